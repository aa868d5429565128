"""The derivation of a parallel robot in the format and the language that are asked for."""

from __future__ import annotations

from types import MappingProxyType
from typing import TYPE_CHECKING

from dhgen.derivation.figures.tikz import tikz
from dhgen.derivation.formats import derivation_as
from dhgen.derivation.handouts import html_handout, latex_handout
from dhgen.derivation.languages import ENGLISH
from dhgen.derivation.text.markdown import markdown
from dhgen.derivation.text.plain import plain
from dhgen.legs.read import SUFFIX
from dhgen.parallel.document import parallel_blocks
from dhgen.printing.comments import plain_path
from dhgen.printing.templates import render

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from dhgen.derivation.languages import Language
    from dhgen.derivation.story import Story
    from dhgen.parallel.module import ParallelModule


def parallel_document(
    module: ParallelModule,
    language: Language = ENGLISH,
    documents: Mapping[str, str] | None = None,
) -> dict[str, str]:
    """The Markdown and its figures, by their paths.

    Args:
        module: The robot.
        language: That of the document and of its figures.
        documents: Of kinds of legs, by their names, the paths of their documents; where these are
            not given they lie beside it, each called like its solver.
    """
    beside = {chain.name: f"{chain.name}.md" for chain in module.robot.chains}
    blocks, figures = parallel_blocks(module, beside if documents is None else documents)
    name, source = module.name, plain_path(module.source)
    written = tuple(markdown(language.block(block)) for block in blocks)
    text = render("derivation/document.md.jinja", name=name, source=source, blocks=written)
    drawn = map(language.figure, figures)
    return {f"{name}.md": text} | {each.path: each.file(name, module.source) for each in drawn}


def derivations_as(
    wished: str,
    module: ParallelModule,
    legs: Sequence[Story],
    out: Path | None,
    language: Language = ENGLISH,
) -> tuple[str, Mapping[str, str]]:
    """The document with the legs' documents, and texts of files beside it by their paths.

    As text they follow in the same document; in other formats they are documents of their own.

    Args:
        wished: `text`, `markdown`, `latex` or `html`.
        module: The robot.
        legs: Its kinds of legs.
        out: Where it goes: legs' documents are called like it; None where these have no place.
        language: That of all documents.

    Raises:
        CommandError: A package is missing that the format needs.
    """
    documents = {} if out is None else {each.robot.name: _beside(each, out) for each in legs}
    text, beside = parallel_derivation_as(wished, module, language, documents)
    files = dict(beside)
    for story in legs:
        own, figures = derivation_as(wished, story, module.source, language)
        if wished == "text":
            text += f"\n\n{own}"
        elif out is not None:
            files |= {_beside(story, out): own, **figures}
    return text, files


def _beside(leg: Story, out: Path) -> str:
    """The document of a leg, called like that of its robot."""
    name = leg.robot.name
    return f"{out.stem}{name[name.rindex(SUFFIX) :]}{out.suffix}"


def parallel_derivation_as(
    wished: str,
    module: ParallelModule,
    language: Language = ENGLISH,
    documents: Mapping[str, str] = MappingProxyType({}),
) -> tuple[str, Mapping[str, str]]:
    """The document, and texts of files beside it by their paths.

    Args:
        wished: `text`, `markdown`, `latex` or `html`.
        module: The robot.
        language: That of the document.
        documents: Of kinds of legs, by their names, the paths of their documents.

    Raises:
        CommandError: A package is missing that the format needs.
    """
    if wished == "markdown":
        files = parallel_document(module, language, documents)
        return files.pop(f"{module.name}.md"), files
    english, figures = parallel_blocks(module, documents)
    blocks = list(map(language.block, english))
    drawn = list(map(language.figure, figures))
    if wished == "latex":
        drawings = {each.path: "\n".join(map(tikz, each.sheet.shapes)) for each in drawn}
        return latex_handout(module.name, module.source, blocks, drawings, language), {}
    if wished == "html":
        files = {each.path: each.file(module.name, module.source) for each in drawn}
        title = module.robot.title
        return html_handout(module.name, title, module.source, blocks, files, language), {}
    first, *others = map(plain, blocks)
    return render("derivation/terminal.txt.jinja", first=first, others=others) + "\n", {}

"""The derivation as a handout in one file: LaTeX with drawings of its own, or HTML with MathML."""

from __future__ import annotations

from base64 import b64encode
from html import escape
from typing import TYPE_CHECKING

from dhgen.derivation.document import document_blocks
from dhgen.derivation.figures.all import figures_of
from dhgen.derivation.figures.tikz import tikz
from dhgen.derivation.languages import ENGLISH
from dhgen.derivation.text.latex import latex
from dhgen.errors import CommandError
from dhgen.printing.comments import plain_path
from dhgen.printing.templates import render

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.derivation.languages import Language
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block


def derivation_latex(story: Story, source: str, language: Language = ENGLISH) -> str:
    """The derivation as a LaTeX document.

    Args:
        story: The arm and its derivation.
        source: How the robot file is called.
        language: That of the document and of its figures.
    """
    figures = figures_of(story)
    drawn = map(language.figure, figures)
    drawings = {each.path: "\n".join(map(tikz, each.sheet.shapes)) for each in drawn}
    blocks = list(map(language.block, document_blocks(story, figures)))
    return latex_handout(story.robot.name, source, blocks, drawings, language)


def latex_handout(
    name: str,
    source: str,
    blocks: Sequence[Block],
    drawings: Mapping[str, str],
    language: Language,
) -> str:
    """A LaTeX document of finished blocks.

    Args:
        name: The robot's.
        source: How the robot file is called.
        blocks: In the language.
        drawings: The figures in TikZ, by their paths.
        language: That of the document.
    """
    first, *others = (latex(block, drawings) for block in blocks)
    return render(
        "derivation/handout.tex.jinja",
        name=name,
        source=plain_path(source),
        is_english=language.code == ENGLISH.code,
        blocks=(first + "\n\\maketitle", *others),
    )


def derivation_html(story: Story, source: str, language: Language = ENGLISH) -> str:
    """The derivation as an HTML document that needs no other file.

    Args:
        story: The arm and its derivation.
        source: How the robot file is called.
        language: That of the document and of its figures.

    Raises:
        CommandError: latex2mathml is not installed.
    """
    figures = figures_of(story)
    drawn = map(language.figure, figures)
    files = {each.path: each.file(story.robot.name, source) for each in drawn}
    blocks = list(map(language.block, document_blocks(story, figures)))
    return html_handout(story.robot.name, story.robot.title, source, blocks, files, language)


def html_handout(
    name: str,
    title: str,
    source: str,
    blocks: Sequence[Block],
    figures: Mapping[str, str],
    language: Language,
) -> str:
    """An HTML document of finished blocks that needs no other file.

    Args:
        name: The robot's.
        title: What a person calls it.
        source: How the robot file is called.
        blocks: In the language.
        figures: The figures as SVG, by their paths.
        language: That of the document.

    Raises:
        CommandError: latex2mathml is not installed.
    """
    try:
        from dhgen.derivation.text.html import html  # noqa: PLC0415  an extra's
    except ModuleNotFoundError:
        message = "dhgen: HTML needs latex2mathml: pip install 'dhgen[html]'"
        raise CommandError(message) from None
    drawings = {path: _inside(file) for path, file in figures.items()}
    return render(
        "derivation/handout.html.jinja",
        name=name,
        source=plain_path(source).replace("--", "__"),  # it would end the comment
        title=escape(title),
        language=language.code,
        blocks=tuple(html(block, drawings) for block in blocks),
    )


def _inside(svg: str) -> str:
    """A figure as an address that is the figure itself."""
    return "data:image/svg+xml;base64," + b64encode(svg.encode()).decode()

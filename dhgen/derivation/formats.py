"""A derivation in the format that is asked for, with the files that belong to it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation import derivation_files, derivation_terminal
from dhgen.derivation.handouts import derivation_html, derivation_latex
from dhgen.derivation.languages import ENGLISH

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.derivation.languages import Language
    from dhgen.derivation.story import Story


def derivation_as(
    wished: str, story: Story, source: str, language: Language = ENGLISH
) -> tuple[str, Mapping[str, str]]:
    """The document, and texts of files beside it by their paths.

    Args:
        wished: `text`, `markdown`, `latex` or `html`.
        story: The arm and its derivation.
        source: How the robot file is called.
        language: That of the document.

    Raises:
        CommandError: A package is missing that the format needs.
    """
    match wished:
        case "markdown":
            files = derivation_files(story, source, language)
            return files.pop(f"{story.robot.name}.md"), files
        case "latex":
            return derivation_latex(story, source, language), {}
        case "html":
            return derivation_html(story, source, language), {}
        case _:
            return derivation_terminal(story, language) + "\n", {}

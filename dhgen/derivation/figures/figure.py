"""A drawing with its name and its caption."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

from dhgen.derivation.figures.svg import svg
from dhgen.derivation.text.blocks import Picture
from dhgen.derivation.text.plain import words
from dhgen.printing.comments import plain_path
from dhgen.printing.templates import render

if TYPE_CHECKING:
    from dhgen.derivation.figures.sheet import Sheet
    from dhgen.derivation.text.blocks import Prose

FOLDER = "figures"  # beside the documents, for all robots


@dataclass(frozen=True, slots=True)
class Figure:
    """A drawing.

    Attributes:
        path: Where it lies, from the document that shows it.
        title: What it shows, in a few words.
        caption: The text below it.
        sheet: The shapes.
    """

    path: str
    title: str
    caption: Prose
    sheet: Sheet

    @property
    def picture(self) -> Picture:
        """The place in a document that shows it."""
        return Picture(self.path, self.title, self.caption)

    def file(self, name: str, source: str) -> str:
        """The file; `source` is how the robot file is called."""
        left, top, width, height = self.sheet.extent()
        return render(
            "derivation/figure.svg.jinja",
            name=name,
            source=plain_path(source).replace("--", "__"),  # it would end the comment
            title=escape(self.title, quote=False),
            description=escape(words(self.caption), quote=False),
            left=left,
            top=top,
            width=width,
            height=height,
            shapes=tuple(map(svg, self.sheet.shapes)),
        )


def figure_path(robot: str, what: str) -> str:
    """Where the figure of a robot lies, from its document."""
    return f"{FOLDER}/{robot}_{what}.svg"

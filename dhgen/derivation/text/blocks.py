"""A document as values: headings, paragraphs, formulas, tables and drawings.

Prose holds formulas and texts of the user in numbered places, so that one derivation is printed as
Markdown and as plain text without being written twice.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from dhgen.derivation.text.formula import Formula


@dataclass(frozen=True, slots=True)
class Given:
    """A text that the user wrote, or a name: escaped where printed, the same in all languages.

    Attributes:
        text: The text.
        path: The document that it links to, where a format can do that; empty for none.
    """

    text: str
    path: str = ""


@dataclass(frozen=True, slots=True)
class Prose:
    """A text with places.

    Attributes:
        text: The words; `{}` for every part in turn.
        parts: What is in the places.
    """

    text: str
    parts: tuple[Formula | Given | Prose, ...] = ()


@dataclass(frozen=True, slots=True)
class Heading:
    """The title (level 1) or the name of a section (level 2)."""

    level: int
    prose: Prose


@dataclass(frozen=True, slots=True)
class Paragraph:
    """Some sentences; `lead` comes before them in bold type."""

    prose: Prose
    lead: Prose | None = None


@dataclass(frozen=True, slots=True)
class Display:
    """Formulas on lines of their own, aligned at their first relation sign."""

    formulas: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Table:
    """A table; every row is as long as the header."""

    header: tuple[Prose, ...]
    rows: tuple[tuple[Prose, ...], ...]


@dataclass(frozen=True, slots=True)
class Drawing:
    """Text that keeps its columns."""

    text: str


@dataclass(frozen=True, slots=True)
class Picture:
    """A figure in a file of its own, with its caption."""

    path: str
    title: str
    caption: Prose


@dataclass(frozen=True, slots=True)
class Folded:
    """What no later line needs: it opens when the reader clicks on it, where a format can do that.

    Attributes:
        title: What is there, without formulas.
        blocks: It.
    """

    title: str
    blocks: tuple[Block, ...]


Block = Heading | Paragraph | Display | Table | Drawing | Picture | Folded


def unfolded(blocks: Iterable[Block]) -> Iterator[Block]:
    """Blocks as they are read one after the other, with what is folded."""
    for block in blocks:
        if isinstance(block, Folded):
            yield from unfolded(block.blocks)
        else:
            yield block


def say(text: str, *parts: Formula | Given | Prose) -> Prose:
    """Prose with its parts."""
    return Prose(text, parts)


def paragraph(text: str, *parts: Formula | Given | Prose) -> Paragraph:
    """A paragraph with its parts."""
    return Paragraph(say(text, *parts))


def display(*formulas: Formula) -> Display:
    """Formulas on lines of their own."""
    return Display(formulas)


def joined(parts: list[Prose], last: str = " and ") -> Prose:
    """a, b and c."""
    if len(parts) == 1:
        return parts[0]
    return Prose(", ".join(["{}"] * (len(parts) - 1)) + last + "{}", tuple(parts))


def sentences(parts: list[Prose]) -> Prose:
    """Sentences one after the other."""
    return Prose(" ".join(["{}"] * len(parts)), tuple(parts))

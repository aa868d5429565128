r"""Blocks from a template: Markdown with places for formulas, for prose, and for whole blocks.

A template's paragraphs are broken into lines anywhere. Of Markdown it uses headings, a bold lead at
the beginning of a paragraph, `$x$` for letters that look the same everywhere, and `math` fences
with one formula after the other: their places, or LaTeX with a comment, which is how a terminal
spells it. So does `$\varphi % φ$` in a text.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from itertools import chain
from typing import TYPE_CHECKING, get_args

from dhgen.derivation.text.blocks import Block, Display, Given, Heading, Paragraph, Prose
from dhgen.derivation.text.formula import Formula, Symbol
from dhgen.printing.templates import render

if TYPE_CHECKING:
    from collections.abc import Iterator

Part = Formula | Given | Prose
_PARTS = get_args(Part)
_BLOCKS = get_args(Block)
_PLACE = re.compile(r"⟦(\d+)⟧|\$([^$]+)\$")
_LEAD = re.compile(r"\*\*(.+?)\*\* ?(.*)", re.DOTALL)
_FENCED = re.compile(r"(```math\n.*?\n```)(?=\n)", re.DOTALL)
_SPELLED = re.compile(r"(.+?)\s*% (.+)\s*")  # in LaTeX, a comment


def blocks_of(template: str, **values: object) -> list[Block]:
    """The blocks of a filled template.

    Args:
        template: Its name in `templates/derivation`, without the ending.
        **values: What it names: formulas, prose, users' texts, lists of blocks, and lists of these
            get places; anything else is as in any template.
    """
    places = Places()
    named = {name: places.of(value) for name, value in values.items()}
    text = render(f"derivation/{template}.md.jinja", **named)
    return list(places.read(text))


@dataclass(frozen=True, slots=True)
class _Place:
    """The place of a value in a filled template.

    Attributes:
        number: Which one it is.
        latex: A symbol's spelling in formulas, for formulas that a template writes.
        text: Its spelling in a terminal.
        empty: Whether it is a list of nothing, which templates test.
    """

    number: int
    latex: str = ""
    text: str = ""
    empty: bool = False

    def __str__(self) -> str:
        return f"⟦{self.number}⟧"

    def __bool__(self) -> bool:
        return not self.empty


@dataclass(frozen=True, slots=True)
class Places:
    """The values of a template by the numbers of their places."""

    values: list[object] = field(default_factory=list)

    def of(self, value: object) -> object:
        """A place for a value that has one in a text, or for each of several."""
        if isinstance(value, list | tuple):
            if value and not all(isinstance(each, _BLOCKS) for each in value):
                return [self.of(each) for each in value]
        elif not isinstance(value, (*_PARTS, *_BLOCKS)):
            return value
        self.values.append(value)
        number = len(self.values) - 1
        if isinstance(value, Symbol):
            return _Place(number, value.latex, value.text)
        return _Place(number, empty=value in ([], ()))

    def read(self, text: str) -> Iterator[Block]:
        """The blocks of a filled template."""
        for number, piece in enumerate(_FENCED.split(text)):
            if number % 2:
                yield self._display(piece)
                continue
            for each in filter(None, map(str.strip, piece.split("\n\n"))):
                yield from self._blocks(" ".join(each.split()))

    def _display(self, fence: str) -> Display:
        formulas = fence.removeprefix("```math\n").removesuffix("\n```")
        if "%" not in formulas:
            return Display(tuple(chain.from_iterable(map(self._formulas, formulas.split("\n")))))
        spelled = _SPELLED.findall(formulas)
        return Display(tuple(Symbol(latex, text) for latex, text in spelled))

    def _formulas(self, line: str) -> Iterator[Formula]:
        return (part for part in self._prose(line).parts if isinstance(part, get_args(Formula)))

    def _blocks(self, text: str) -> Iterator[Block]:
        """A heading, a paragraph, or the blocks that have their place here."""
        if place := _PLACE.fullmatch(text):
            value = self.values[int(place[1])] if place[1] else None
            if isinstance(value, list | tuple):
                yield from value
                return
            if isinstance(value, _BLOCKS):
                yield value
                return
        if text.startswith("#"):
            marks, _, title = text.partition(" ")
            yield Heading(len(marks), self._prose(title))
        elif lead := _LEAD.fullmatch(text):
            yield Paragraph(self._prose(lead[2]), self._prose(lead[1]))
        else:
            yield Paragraph(self._prose(text))

    def _prose(self, text: str) -> Prose:
        parts: list[Part] = []

        def place(found: re.Match[str]) -> str:
            value = self.values[int(found[1])] if found[1] else _letter(found[2])
            assert isinstance(value, _PARTS), f"blocks stand in paragraphs of their own: {text}"
            parts.append(value)
            return "{}"

        return Prose(_PLACE.sub(place, text), tuple(parts))


def _letter(text: str) -> Symbol:
    """A letter that a template brings, in LaTeX, perhaps with how a terminal spells it."""
    latex, _, plain = text.partition(" % ")
    return Symbol(latex, plain or latex)

"""A finished derivation in French."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from string import Formatter
from typing import TYPE_CHECKING, get_args

from dhgen.derivation.figures.sheet import Words
from dhgen.derivation.french.catalogue import MARK, MARKS
from dhgen.derivation.french.notation import french_formula
from dhgen.derivation.french.sentences import french, sentences
from dhgen.derivation.text.blocks import (
    Display,
    Drawing,
    Folded,
    Given,
    Heading,
    Paragraph,
    Picture,
    Prose,
    Table,
)
from dhgen.derivation.text.walk import symbols_in
from dhgen.robot.names import LengthUnit

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.derivation.figures.figure import Figure
    from dhgen.derivation.figures.sheet import Shape
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula

# The words of the steps as an algorithm.
_TRANSLATED = re.compile(r"\b(?:for|if|else|alone)\b|no solution|the seed's value")
_ROW, _ROOT = re.compile(r" row (\d+)(?: (?= ))?"), "root "
_FIRST = ord(MARKS[0])
_MARK = re.compile(MARK)
_ITEM = f"{MARK}(?: (?:{'|'.join(get_args(LengthUnit))}|rad))?"
_LISTED = re.compile(f"{_ITEM}(?:, {_ITEM})+(?: (?:et|ou) {_ITEM})?")
_NUMBER = re.compile(r"[-−]?\d+\.\d+")


@dataclass(frozen=True, slots=True)
class French:
    """French, and what the catalogue lacked.

    Attributes:
        missing: English sentences without a translation, with a mark for every formula.
    """

    missing: list[str] = field(default_factory=list)

    @property
    def untranslated(self) -> list[str]:
        """The sentences without a translation, each once, with an ellipsis for every formula."""
        return list(dict.fromkeys(_MARK.sub("…", each) for each in self.missing))

    @property
    def code(self) -> str:
        """Its name in HTML."""
        return "fr"

    def block(self, block: Block) -> Block:
        """A block in French."""
        match block:
            case Heading(level, prose):
                return Heading(level, self.prose(prose))
            case Paragraph(prose, lead):
                return Paragraph(self.prose(prose), None if lead is None else self.prose(lead))
            case Display(formulas):
                return Display(tuple(map(french_formula, formulas)))
            case Table(header, rows):
                written = tuple(tuple(map(self.prose, row)) for row in rows)
                return Table(tuple(map(self.prose, header)), written)
            case Drawing(text):
                return Drawing(_listing(text) or _tree(text))
            case Picture(path, title, caption):
                return Picture(french_path(path), self.words(title), self.prose(caption))
            case Folded(title, blocks):
                return Folded(self.words(title), tuple(map(self.block, blocks)))

    def figure(self, figure: Figure) -> Figure:
        """A figure with its words in French."""
        return replace(
            figure,
            path=french_path(figure.path),
            title=self.words(figure.title),
            caption=self.prose(figure.caption),
            sheet=replace(figure.sheet, shapes=list(map(self._shape, figure.sheet.shapes))),
        )

    def _shape(self, shape: Shape) -> Shape:
        """A shape; of letters, numbers and what is in parentheses are in French, names are kept."""
        if not isinstance(shape, Words):
            return shape
        return replace(shape, runs=tuple((self._letters(run), below) for run, below in shape.runs))

    def _letters(self, run: str) -> str:
        name, bracket, aside = run.partition(" (")
        if bracket:
            return f"{name} {self.words('(' + aside)}"
        return self.words(run) if _NUMBER.fullmatch(run) else run

    def prose(self, prose: Prose) -> Prose:
        """Prose in French, the formulas where French has them."""
        text, parts = marked(prose)
        written = _with_semicolons(self.words(text), parts)
        pieces: list[str] = []
        order: list[Formula | Given] = []
        for letter in written:
            place = ord(letter) - _FIRST
            if 0 <= place < len(parts):
                order.append(parts[place])
                pieces.append("{}")
            else:
                pieces.append({"{": "{{", "}": "}}"}.get(letter, letter))
        found = (each if isinstance(each, Given) else french_formula(each) for each in order)
        return Prose("".join(pieces), tuple(found))

    def words(self, text: str) -> str:
        """A text in French; a sentence that the catalogue lacks is left in English, and noted."""
        written = french(text)
        if written is not None:
            return written
        found = [(each, french(each)) for each in sentences(text)]
        self.missing.extend(each for each, there in found if there is None)
        return " ".join(each if there is None else there for each, there in found)


def _listing(text: str) -> str:
    """An algorithm with its words in French; nothing for a tree."""
    if _ROW.search(text):
        return ""
    return _TRANSLATED.sub(lambda word: french(word[0]) or "", text).replace(": ", " : ")


def _tree(text: str) -> str:
    """The tree of solutions, in which all roots are below each other; no wider for its rows."""
    lines = [_ROW.sub(r"ligne \1", line) for line in text.split("\n")]
    start = max(line.find(_ROOT) for line in lines)
    if start < 0:
        return "\n".join(lines)
    end = start + len(_ROOT)
    return "\n".join(
        line[:start]
        + ("racine " if line[start:end] == _ROOT else "  " + line[start:end])
        + line[end:]
        for line in lines
    )


def _with_semicolons(text: str, parts: Sequence[Formula | Given]) -> str:
    """A text whose lists of formulas with decimal commas have semicolons between them.

    Args:
        text: In French, a mark for every part.
        parts: Formulas and texts of the user.
    """

    def separated(found: re.Match[str]) -> str:
        marks = (parts[ord(mark) - _FIRST] for mark in _MARK.findall(found[0]))
        formulas = (french_formula(part) for part in marks if not isinstance(part, Given))
        commas = any("{,}" in each.latex for formula in formulas for each in symbols_in(formula))
        return found[0].replace(", ", "\u00a0; ") if commas else found[0]

    return _LISTED.sub(separated, text)


def french_path(path: str) -> str:
    """Where a French figure lies, beside the English one."""
    return path.removesuffix(".svg") + "_fr.svg"


def marked(prose: Prose) -> tuple[str, list[Formula | Given]]:
    """A text with a mark for every formula and every text of the user, and these."""
    parts: list[Formula | Given] = []

    def pieces(that: Prose) -> str:
        waiting = iter(that.parts)
        found = ""
        for text, place, _, _ in Formatter().parse(that.text):
            found += text
            if place is not None:
                part = next(waiting)
                if isinstance(part, Prose):
                    found += pieces(part)
                elif isinstance(part, Given) and part.text.isdigit():
                    found += part.text  # a number of the derivation's own
                else:
                    found += chr(_FIRST + len(parts))
                    parts.append(part)
        return found

    return pieces(prose), parts

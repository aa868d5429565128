"""The catalogue: English sentences with holes, and what they are in French.

A file of the catalogue is a list of pairs. A line that begins at the margin is English; the lines
below it that are indented are the French. A `#` begins a comment. Holes are written alike on both
sides, a letter for what they take and a number where there are several:

| hole   | takes                                          | becomes                             |
|--------|------------------------------------------------|-------------------------------------|
| `{f1}` | a formula or a user's text, or several         | itself; "and" and "or" in French    |
| `{l1}` | whole numbers: 1; 1 and 2; 1, 2 and 4          | "1, 2 et 4"                         |
| `{n1}` | a number in digits                             | with a decimal comma                |
| `{w1}` | a number in words; `{w1:f}` beside a feminine  | "deux"; "un" or "une"               |
| `{i1}` | one word that is a name                        | itself                              |
| `{u1}` | a unit of lengths                              | itself                              |
| `{t1}` | any text that the user wrote                   | itself                              |
| `{p1}` | words that have a pair of their own, or clauses | their French                       |
| `{s1}` | several of these, between commas               | their French, "a, b et c"           |
| `{q1}` | several of these, each beginning with a formula | their French                       |
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import get_args

from dhgen.robot.names import LengthUnit

FOLDER = Path(__file__).resolve().parent / "sentences"
MARKS = "\ue000", "\uf8ff"  # from here to there: a mark for every formula of a text
MARK = f"[{MARKS[0]}-{MARKS[1]}]"
_AND = "(?:, | and | or )"
NUMBERS = {
    "no": "aucun",
    "one": "un",
    "two": "deux",
    "three": "trois",
    "four": "quatre",
    "five": "cinq",
    "six": "six",
    "seven": "sept",
    "eight": "huit",
    "nine": "neuf",
    "ten": "dix",
    "eleven": "onze",
    "twelve": "douze",
    "fourteen": "quatorze",
    "sixteen": "seize",
}
_TAKES = {
    "f": f"{MARK}(?:{_AND}{MARK})*",
    "l": rf"\d+(?:{_AND}\d+)*",
    "n": r"-?\d+(?:\.\d+)?(?:e-?\d+)?",
    "w": "|".join([*NUMBERS, r"\d+"]),
    "i": r"[^\s,;:()]+",
    "u": "|".join(get_args(LengthUnit)),
    "t": ".+?",
    "p": ".+?",
    "s": ".+?",
    "q": f"{MARK}.*?",
}
HOLE = re.compile(r"\{([flnwiutpsq]\d*)(?::(f))?\}")
_BEFORE_SIGNS = re.compile(" (?=[:;?!»])")


@dataclass(frozen=True)
class Pair:
    """An English sentence or phrase and its French.

    Attributes:
        english: With holes.
        french: With the same ones.
        place: The file and the line, for whoever reads the catalogue.
    """

    english: str
    french: str
    place: str

    @cached_property
    def pieces(self) -> tuple[str, ...]:
        """What is between the holes in English."""
        return tuple(HOLE.split(self.english)[::3])

    @cached_property
    def weight(self) -> int:
        """How many words of a sentence are its own: the more, the sooner it is tried."""
        return sum(map(len, self.pieces))

    @cached_property
    def pattern(self) -> re.Pattern[str]:
        """What an English text has to be."""
        parts = HOLE.split(self.english)
        written = re.escape(parts[0])
        for hole, after in zip(parts[1::3], parts[3::3], strict=True):
            written += f"(?P<{hole}>{_TAKES[hole[0]]}){re.escape(after)}"
        return re.compile(written, re.DOTALL)

    def may_be(self, text: str) -> bool:
        """Whether the words between the holes are in a text, in order: cheaper than the pattern."""
        at = 0
        for piece in self.pieces:
            at = text.find(piece, at)
            if at < 0:
                return False
            at += len(piece)
        return text.startswith(self.pieces[0]) and text.endswith(self.pieces[-1])


@cache
def catalogue() -> tuple[Pair, ...]:
    """All pairs, the weightiest first."""
    found = [pair for path in sorted(FOLDER.glob("*.txt")) for pair in pairs_of(path)]
    return tuple(sorted(found, key=lambda pair: -pair.weight))


def pairs_of(path: Path) -> list[Pair]:
    """The pairs of a file, in its order.

    Raises:
        ValueError: The file is not written as it should be.
    """
    pairs: list[Pair] = []
    lines = path.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, start=1):
        if not line.strip() or line.startswith("#"):
            continue
        if not line.startswith(" "):
            pairs.append(Pair(line.strip(), "", f"{path.name}:{number}"))
        elif pairs:
            last = pairs.pop()
            french = f"{last.french} {spaced(line.strip())}".strip()
            pairs.append(Pair(last.english, french, last.place))
    for pair in pairs:
        if sorted(_names(pair.english)) != sorted(set(_names(pair.french))):
            raise ValueError(f"{pair.place}: the holes of both languages differ")
    return pairs


def _names(text: str) -> list[str]:
    return [match[1] for match in HOLE.finditer(text)]


def spaced(french: str) -> str:
    """French with spaces before its signs where no line ends."""
    return _BEFORE_SIGNS.sub("\u00a0", french).replace("« ", "«\u00a0")

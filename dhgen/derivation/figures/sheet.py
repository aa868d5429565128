"""Shapes on paper and their extent; `svg.py` and `tikz.py` print them.

Points are pairs of numbers in pixels, x to the right and y down.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING, SupportsFloat, TypeAlias

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

Point: TypeAlias = tuple[float, float]
Box: TypeAlias = tuple[float, float, float, float]  # left, top, right, bottom

MARGIN = 8.0  # around everything
WIDTHS = {"link": 3.5, "held": 1.5}  # half the widths of lines that are wide
SURE = 6  # decimals that rounding of other machines leaves alone
BELOW = 4  # of an index
_UPRIGHT = str.maketrans("₀₁₂₃₄₅₆₇₈₉₋", "0123456789−")
_RUN = re.compile(r"(?P<below>[₀₁₂₃₄₅₆₇₈₉₋]+|(?<=\w)_\w+)|(?:(?![₀₁₂₃₄₅₆₇₈₉₋]|(?<=\w)_).)+")


def settled(value: SupportsFloat) -> float:
    """A number without what rounding made of it."""
    return round(float(value), SURE) + 0.0


def number(value: float) -> str:
    """A coordinate to a tenth of a pixel, equal on every machine."""
    text = f"{round(settled(value), 1) + 0.0:.1f}"
    return text.removesuffix(".0")


@dataclass(frozen=True, slots=True)
class Path:
    """Lines and arcs.

    Attributes:
        kind: What they represent, which determines how they look.
        data: Their path in the words of SVG.
        is_faint: Whether they are in the background.
    """

    kind: str
    data: str
    is_faint: bool = False


@dataclass(frozen=True, slots=True)
class Disc:
    """A circle."""

    kind: str
    centre: Point
    radius: float


@dataclass(frozen=True, slots=True)
class Words:
    """Letters, from a point on their base line.

    Attributes:
        kind: What they name, which determines how they look; may be empty.
        at: The point.
        runs: Letters and indices by turns, and which are which.
        anchor: `middle` or `end` where the point is not at their beginning.
    """

    kind: str
    at: Point
    runs: tuple[tuple[str, bool], ...]
    anchor: str = ""


Shape: TypeAlias = Path | Disc | Words


@dataclass(slots=True)
class Sheet:
    """What is drawn, in order.

    Attributes:
        shapes: What is drawn.
        lines: Ends of the lines that letters keep off, and half their width.
        boxes: Places that bodies take.
        letters: Places that letters take.
    """

    shapes: list[Shape] = field(default_factory=list)
    lines: list[tuple[Point, Point, float]] = field(default_factory=list)
    boxes: list[Box] = field(default_factory=list)
    letters: list[Box] = field(default_factory=list)
    _bounds: list[Point] = field(default_factory=list)

    def extent(self) -> tuple[int, int, int, int]:
        """Left, top, width and height of all that is drawn, in whole pixels."""
        xs = [settled(x) for x, _ in self._bounds]
        ys = [settled(y) for _, y in self._bounds]
        left, top = int((min(xs) - MARGIN) // 1), int((min(ys) - MARGIN) // 1)
        return (
            left,
            top,
            int((max(xs) + MARGIN) // 1) + 1 - left,
            int((max(ys) + MARGIN) // 1) + 1 - top,
        )

    def line(self, points: Sequence[Point], kind: str) -> None:
        """A line through points, which letters keep off."""
        self.bar(points, WIDTHS.get(kind, 0.5))
        self._add(Path(kind, path(points)), points)

    def bar(self, points: Sequence[Point], half: float = 0.5) -> None:
        """Keeps letters off a line of some width."""
        self.lines += [(start, end, half) for start, end in pairwise(points)]

    def area(
        self, data: str, points: Sequence[Point], kind: str, *, is_faint: bool = False
    ) -> None:
        """Anything with a path of its own; `points` are as far as it goes."""
        self._add(Path(kind, data, is_faint), points)

    def disc(self, centre: Point, radius: float, kind: str) -> None:
        """A circle."""
        x, y = centre
        corners = (x - radius, y - radius), (x + radius, y + radius)
        self._add(Disc(kind, centre, radius), corners)

    def take(self, box: Box) -> None:
        """Keeps letters off a body's place."""
        self.boxes.append(box)

    def words(self, at: Point, text: str, kind: str, anchor: str = "") -> None:
        """Letters from a point on their base line; digits below the line are set as such."""
        x, y = at
        width = width_of(text)
        start = x - (width / 2 if anchor == "middle" else width if anchor == "end" else 0.0)
        box = (start, y - HEIGHT), (start + width, y + BELOW)
        self._add(Words(kind, at, tuple(_runs(text)), anchor), box)

    def _add(self, shape: Shape, points: Iterable[Point]) -> None:
        self._bounds += points
        self.shapes.append(shape)


HEIGHT = 11.0  # of letters above their base line
WIDE, NARROW = 7.6, 5.4  # of a letter, of an index


def width_of(text: str) -> float:
    """About how wide letters are."""
    return sum((NARROW if below else WIDE) * len(run) for run, below in _runs(text))


def path(points: Sequence[Point]) -> str:
    """A line through points as SVG has it."""
    return "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)


def _runs(text: str) -> list[tuple[str, bool]]:
    """Letters and indices by turns, and which are which."""
    found = _RUN.finditer(text)
    return [
        (match[0].removeprefix("_").translate(_UPRIGHT), match["below"] is not None)
        for match in found
    ]

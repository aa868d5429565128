"""Shapes on paper, their extent, and SVG out of them.

Points are pairs of numbers in pixels, x to the right and y down.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING, SupportsFloat, TypeAlias
from xml.sax.saxutils import escape

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
    """A coordinate to a tenth of a pixel, the same on every machine."""
    text = f"{round(settled(value), 1) + 0.0:.1f}"
    return text.removesuffix(".0")


@dataclass(slots=True)
class Sheet:
    """What is drawn, in order.

    Attributes:
        shapes: Elements of SVG.
        lines: Ends of the lines that letters keep off, and half their width.
        boxes: Places that bodies take.
        letters: Places that letters take.
    """

    shapes: list[str] = field(default_factory=list)
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

    def line(self, points: Sequence[Point], kind: str, more: str = "") -> None:
        """A line through points, which letters keep off."""
        self.bar(points, WIDTHS.get(kind, 0.5))
        self._element(points, f'<path class="{kind}" d="{path(points)}"{_said(more)}/>')

    def bar(self, points: Sequence[Point], half: float = 0.5) -> None:
        """Keeps letters off a line of some width."""
        self.lines += [(start, end, half) for start, end in pairwise(points)]

    def area(self, data: str, points: Sequence[Point], kind: str, more: str = "") -> None:
        """Anything with a path of its own; `points` are as far as it goes."""
        self._element(points, f'<path class="{kind}" d="{data}"{_said(more)}/>')

    def disc(self, centre: Point, radius: float, kind: str) -> None:
        """A circle."""
        x, y = centre
        self._element(
            [(x - radius, y - radius), (x + radius, y + radius)],
            f'<circle class="{kind}" cx="{number(x)}" cy="{number(y)}" r="{number(radius)}"/>',
        )

    def take(self, box: Box) -> None:
        """Keeps letters off a body's place."""
        self.boxes.append(box)

    def words(self, at: Point, text: str, kind: str, anchor: str = "") -> None:
        """Letters from a point on their base line; digits below the line are set as such."""
        x, y = at
        width = width_of(text)
        start = x - (width / 2 if anchor == "middle" else width if anchor == "end" else 0.0)
        place = f' text-anchor="{anchor}"' if anchor else ""
        kinds = f' class="{kind}"' if kind else ""
        self._element(
            [(start, y - HEIGHT), (start + width, y + BELOW)],
            f'<text{kinds} x="{number(x)}" y="{number(y)}"{place}>{_with_indices(text)}</text>',
        )

    def _element(self, points: Iterable[Point], text: str) -> None:
        self._bounds += points
        self.shapes.append(text)


HEIGHT = 11.0  # of letters above their base line
WIDE, NARROW = 7.6, 5.4  # of a letter, of an index


def width_of(text: str) -> float:
    """About how wide letters are."""
    return sum((NARROW if below else WIDE) * len(run) for run, below in _runs(text))


def path(points: Sequence[Point]) -> str:
    """A line through points as SVG has it."""
    return "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)


def _said(more: str) -> str:
    return f" {more}" if more else ""


def _with_indices(text: str) -> str:
    parts: list[str] = []
    was_below = False
    for run, below in _runs(text):
        shift = "" if below == was_below else f' dy="{BELOW if below else -BELOW}"'
        size = ' font-size="10"' if below else ""
        shown = escape(run)
        parts.append(f"<tspan{shift}{size}>{shown}</tspan>" if shift or size else shown)
        was_below = below
    return "".join(parts)


def _runs(text: str) -> list[tuple[str, bool]]:
    """Letters and indices by turns, and which are which."""
    found = _RUN.finditer(text)
    return [
        (match[0].removeprefix("_").translate(_UPRIGHT), match["below"] is not None)
        for match in found
    ]

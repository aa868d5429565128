"""What every joint gives the tool of velocity and angular velocity, in polynomials."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import accumulate
from operator import add
from typing import TYPE_CHECKING

from dhgen.kinematics.chain import Fixed
from dhgen.kinematics.product import product, reversed_elements

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.derivation.story import Story
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform

Vector = tuple["Polynomial", ...]


@dataclass(frozen=True, slots=True)
class Axis:
    """What turns about, or slides along, a z axis.

    Attributes:
        movers: The joints that move it, each with a factor: one, or those of a passive row.
        turns: Whether it turns.
        z: Its direction.
        point: Where it is.
    """

    movers: tuple[tuple[int, int], ...]
    turns: bool
    z: Vector
    point: Vector


@dataclass(frozen=True, slots=True)
class View:
    """An arm seen from one of its frames.

    Attributes:
        algebra: The arm's ring.
        world: The frame in which poses are given.
        frames: Frames 0 to n, and the tool's.
        axes: What moves, from the base to the tool.
    """

    algebra: Algebra
    world: Transform
    frames: tuple[Transform, ...]
    axes: tuple[Axis, ...]

    @property
    def length(self) -> int:
        """How many terms all axes have."""
        return sum(len(entry) for axis in self.axes for entry in (*axis.z, *axis.point))

    def columns(self, centre: int) -> list[tuple[Vector, Vector]]:
        """For every joint the velocity of the origin of a frame, and the angular velocity."""
        algebra, tip = self.algebra, self.frames[centre].translation
        still = (algebra.ring.zero,) * 3
        found = [(still, still)] * algebra.chain.dof
        for axis in self.axes:
            own = axis.z, still
            if axis.turns:
                own = self.turned(axis.z, axis.point, tip), axis.z
            for joint, times in axis.movers:
                factor = times * algebra.chain.joints[joint - 1].sign
                pairs = zip(found[joint - 1], own, strict=True)
                found[joint - 1] = tuple(_added(old, new, factor) for old, new in pairs)  # type: ignore[assignment]
        return found

    def turned(self, z: Vector, point: Vector, tip: Vector) -> Vector:
        """The velocity of a point that turns about an axis."""
        return crossed(self.algebra, z, tuple(a - b for a, b in zip(tip, point, strict=True)))


WORLD = -1  # the number of the frame in which poses are given


def view_from(story: Story, frame: int) -> View:
    """The arm seen from a frame, or from that of the poses."""
    return _views(story)[frame - WORLD]


@lru_cache(maxsize=4)
def _views(story: Story) -> tuple[View, ...]:
    """From the frame of the poses, and then from frames 0 to n."""
    algebra, chain = story.algebra, story.algebra.chain
    links = [algebra.lifted(link) for link in chain.links]
    base, tool = Fixed(algebra.lift(chain.base)), Fixed(algebra.lift(chain.tool))
    elements: list[Element] = [base, *(e for link in links for e in link), tool]
    ends = list(accumulate(map(len, links), add, initial=1))
    return tuple(_view(algebra, elements, ends, start) for start in (0, *ends))


def _view(algebra: Algebra, elements: list[Element], ends: list[int], start: int) -> View:
    """From the frame before an element; frames end before others."""
    axes = []
    for place, element in enumerate(elements):
        if not isinstance(element, Fixed):
            at = between(algebra, elements, start, place)
            axes.append(Axis(element.signed, element.turns, at.column(2), at.translation))
    frames = tuple(between(algebra, elements, start, end) for end in (*ends, len(elements)))
    return View(algebra, between(algebra, elements, start, 0), frames, tuple(axes))


def _added(old: Vector, new: Vector, factor: int) -> Vector:
    return tuple(a + factor * b for a, b in zip(old, new, strict=True))


def between(algebra: Algebra, elements: Sequence[Element], start: int, end: int) -> Transform:
    """The frame before one element seen from that before another."""
    if start <= end:
        return product(elements[start:end], algebra)
    return product(reversed_elements(elements[end:start], algebra), algebra)


def crossed(algebra: Algebra, a: Vector, b: Vector) -> Vector:
    """The vector product."""
    return tuple(algebra.normal(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2]) for i in range(3))

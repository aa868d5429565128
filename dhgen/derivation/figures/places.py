"""Where on their axes joints are drawn: at their origins, or off each other along the axes."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.figures.sheet import settled
from dhgen.derivation.figures.skeleton import Part

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.derivation.figures.skeleton import Axis, Member

RADIUS = 9.0  # of a joint's body [pixels]
HALF = 11.0  # of its length
APART = 25.0  # of two bodies
LEVEL = 1e-6  # of a cosine: directions that are parallel


@dataclass(frozen=True, slots=True)
class Placed:
    """A joint where it is drawn, in pixels of space.

    Attributes:
        axis: The joint.
        at: The middle of its body, (3,).
        held: Whether a member of the arm ends at the body.
    """

    axis: Axis
    at: FloatArray
    held: bool


def placed_axes(axes: Sequence[Axis], members: Sequence[Member]) -> list[Placed]:
    """Every joint in its place: first those that can be in one place only.

    Args:
        axes: Joints, in pixels of space.
        members: What the arm is made of, in the same.
    """
    found: dict[int, Placed] = {}
    for axis in sorted(axes, key=lambda each: _turn(each, axes, members)):
        places = list(_places(axis, axes, members))
        free = (place for place in places if _is_free(place.at, found.values()))
        found[axis.number] = next(free, places[0])
    return [found[axis.number] for axis in axes]


def _turn(axis: Axis, axes: Sequence[Axis], members: Sequence[Member]) -> tuple[bool, int, int]:
    """When a joint is placed: after those without a choice, and between two of one origin first."""
    choice = bool(_spans(axis, members, axis.number) or _spans(axis, members, axis.number - 1))
    return choice, -sum(_share(axis, axes)), axis.number


def _share(axis: Axis, axes: Sequence[Axis]) -> tuple[bool, bool]:
    """Whether the joint before and the joint after have one origin."""
    near = {other.number: other for other in axes if math.dist(other.origin, axis.origin) < 1.0}
    return axis.number - 1 in near, axis.number + 1 in near


def _places(axis: Axis, axes: Sequence[Axis], members: Sequence[Member]) -> Iterable[Placed]:
    """Where a joint may be, the best first: on a member along its axis, or beside its origin."""
    outgoing = _spans(axis, members, axis.number)
    incoming = _spans(axis, members, axis.number - 1)
    if not outgoing and not incoming:
        yield _at(axis, 0.0, held=True)
    for start, end in outgoing:
        near = HALF if end >= start else -HALF
        first = (start,) if not axis.turns else (start + near,) if axis.number == 1 else ()
        for t in (*first, (start + end) / 2.0, start + near, end - near, start + 2.2 * near):
            yield _at(axis, t, held=True)
    for start, end in incoming:
        near = HALF if end >= start else -HALF
        first = (start + near,) if axis.number == 1 else (end,)
        for t in (*first, end - near, end - 2.2 * near, (start + end) / 2.0):
            yield _at(axis, t, held=True)
    before, after = _share(axis, axes)
    way = -1.0 if after and not before else 1.0
    for k in range(1, 7):
        for t in (way * k * APART, -way * k * APART):
            held = any(min(span) <= t <= max(span) for span in (*outgoing, *incoming))
            yield _at(axis, t, held=held)


def _at(axis: Axis, t: float, *, held: bool) -> Placed:
    return Placed(axis, axis.origin + t * axis.z, held)


def _spans(axis: Axis, members: Sequence[Member], after: int) -> list[tuple[float, float]]:
    """Where members behind a number of joints begin and end that lie on an axis."""
    spans = []
    for member in members:
        length = float(np.linalg.norm(member.along))
        across = np.cross(member.along / length, axis.z)
        off = np.cross(member.start - axis.origin, axis.z)
        if member.after != after or member.part is Part.BASE:
            continue
        if max(np.abs(across).max(), np.abs(off).max()) <= LEVEL * max(1.0, length):
            start, end = (settled((p - axis.origin) @ axis.z) for p in (member.start, member.end))
            spans.append((start, end))
    return spans


def _is_free(at: FloatArray, taken: Iterable[Placed]) -> bool:
    return all(settled(np.linalg.norm(at - other.at)) >= APART - 3.0 for other in taken)

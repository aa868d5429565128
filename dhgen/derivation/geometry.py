"""How neighbouring axes lie: parallel, meeting in a point, or neither; and the arm's size."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from dhgen.kinematics.chain import Chain, Fixed, Slide, Turn
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform

NEAR = 1e-9  # of the arm's size, and of a cosine


@dataclass(frozen=True, slots=True)
class Neighbours:
    """Two revolute joints with nothing that moves between them.

    Attributes:
        first: The joint nearer to the base; the other is first + 1.
        lean: Cosine of the angle between the axes.
        meet: Where they meet, from the first frame's and the second frame's origin along their
            axes [length]; None when they do not meet or are parallel.
    """

    first: int
    lean: float
    meet: tuple[float, float] | None


def neighbours(chain: Chain) -> tuple[Neighbours, ...]:
    """All pairs of consecutive revolute joints, from the base."""
    found = []
    for (kind, joint, _), (other, following, between) in pairwise(_moves(chain)):
        if kind is Turn and other is Turn:
            found.append(_neighbours(chain, joint, between))
            assert following == joint + 1
    return tuple(found)


def wrist_joints(chain: Chain) -> tuple[int, int, int] | None:
    """The last three joints, when they are revolute and their axes meet in one point."""
    pairs = {pair.first: pair for pair in neighbours(chain)}
    n = chain.dof
    first, second = pairs.get(n - 2), pairs.get(n - 1)
    if first is None or second is None or first.meet is None or second.meet is None:
        return None
    if abs(first.meet[1] - second.meet[0]) > NEAR * chain.size:
        return None
    return n - 2, n - 1, n


def _moves(chain: Chain) -> Iterator[tuple[type, int, list[Transform]]]:
    """Every joint, with the constant transforms since the one before."""
    between: list[Transform] = []
    for element in (element for link in chain.links for element in link):
        if isinstance(element, Fixed):
            between.append(element.transform)
        elif isinstance(element, Turn | Slide):
            yield type(element), element.joint, between
            between = []
        else:  # what a passive row moves in between is constant to no neighbours
            yield Fixed, 0, between


def _neighbours(chain: Chain, joint: int, between: list[Transform]) -> Neighbours:
    values = [constant.value for constant in chain.constants]
    point, direction = (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)
    for transform in reversed(between):
        rows = [[_value(entry, values) for entry in row] for row in transform.rotation]
        shift = [_value(entry, values) for entry in transform.translation]
        x, y, z = (sum(a * b for a, b in zip(row, point, strict=True)) for row in rows)
        point = (x + shift[0], y + shift[1], z + shift[2])
        u, v, w = (sum(a * b for a, b in zip(row, direction, strict=True)) for row in rows)
        direction = (u, v, w)
    return Neighbours(joint, direction[2], _meeting(point, direction, chain.size))


def _meeting(
    point: tuple[float, float, float], direction: tuple[float, float, float], size: float
) -> tuple[float, float] | None:
    u, v, w = direction
    across = math.hypot(u, v)
    if across < NEAR or abs(point[0] * v - point[1] * u) > NEAR * size:
        return None
    along = -(point[0] * u + point[1] * v) / (across * across)
    return point[2] + along * w, along


def _value(polynomial: Polynomial, values: list[float]) -> float:
    total = 0.0
    for monomial, coefficient in polynomial.terms():
        part = int(coefficient.numerator) / int(coefficient.denominator)
        for value, exponent in zip(values, monomial, strict=False):
            part *= value**exponent
        total += part
    return total


def size_in_words(chain: Chain) -> str:
    """Where the arm's size comes from, to which tolerances and weights are relative."""
    slides = [joint for joint in chain.joints if joint.kind is JointKind.PRISMATIC]
    ends = [abs(end) for slide in slides for end in slide.limits or ()]
    if chain.size in ends:
        return "the farthest limit of a slide"
    return "the sum of all its lengths"

"""How three consecutive revolute axes lie to each other: parallel, concurrent, or nearly so.

Twists, link lengths and joint offsets do not depend on the configuration, so one is enough. Three
parallel or three concurrent axes are what makes a closed form (document 000; Pieper 1968).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain


EXACT = 1e-9  # [rad, or arm sizes] rounding
_NO_POINT = (float("inf"),) * 3


@dataclass(frozen=True, slots=True)
class Triple:
    """Three consecutive revolute axes, slides between them left out.

    Attributes:
        joints: Their numbers.
        tilt: The larger angle between neighbours, 0 when all are parallel [rad].
        gaps: The distances of the middle axis to the one before and the one behind, and between
            the two feet on it [length]; infinite for parallel neighbours, and where a slide is
            between them, which takes such a point apart unless it is along the one axis beyond it.
    """

    joints: tuple[int, int, int]
    tilt: float
    gaps: tuple[float, float, float]

    @property
    def miss(self) -> float:
        """The largest gap, 0 when all meet in one point [length]."""
        return max(self.gaps)


def short_number(value: float, digits: int) -> str:
    """A few digits; what is a tie in the file goes up on every machine, however it was rounded."""
    return f"{value * (1.0 + 1e-9):.{digits}g}"


def missed_point(triple: Triple, unit: str = "") -> str:
    """By how much three axes miss one point, in the file's unit, whose name follows if known."""
    axes = ", ".join(map(str, triple.joints))
    return f"axes {axes} miss one point by {short_number(triple.miss, 4)} {unit}".rstrip()


def axis_triples(chain: Chain) -> tuple[Triple, ...]:
    """All triples of consecutive revolute joints without a given one; slides turn no axis."""
    axes = _axes(chain)
    turning = list(axes)
    return tuple(
        _triple(axes, joints)
        for joints in zip(turning, turning[1:], turning[2:], strict=False)
        if not set(joints) & set(chain.free)
    )


def _triple(axes: dict[int, tuple[FloatArray, FloatArray]], joints: tuple[int, int, int]) -> Triple:
    before, middle, after = (axes[joint] for joint in joints)
    slides = joints[2] - joints[0] > 2
    return Triple(
        joints,
        max(_tilt(middle, before), _tilt(middle, after)),
        _NO_POINT if slides else _gaps(before, middle, after),
    )


def _axes(chain: Chain) -> dict[int, tuple[FloatArray, FloatArray]]:
    """Point and direction of every revolute axis, all angles and lengths zero."""
    directions, points = numeric_arm(chain).axes(np.zeros(chain.dof))
    return {
        joint.number: (points[place], directions[place])
        for place, joint in enumerate(chain.joints)
        if joint.kind is JointKind.REVOLUTE
    }


def _tilt(one: tuple[FloatArray, FloatArray], other: tuple[FloatArray, FloatArray]) -> float:
    sine = np.linalg.norm(np.cross(one[1], other[1]))
    return float(np.arctan2(sine, abs(one[1] @ other[1])))


def _gaps(
    before: tuple[FloatArray, FloatArray],
    middle: tuple[FloatArray, FloatArray],
    after: tuple[FloatArray, FloatArray],
) -> tuple[float, float, float]:
    if min(_tilt(middle, before), _tilt(middle, after)) < EXACT:
        return _NO_POINT
    (near, foot), (far, other_foot) = _common_normal(middle, before), _common_normal(middle, after)
    return near, far, abs(foot - other_foot)


def _common_normal(
    axis: tuple[FloatArray, FloatArray], other: tuple[FloatArray, FloatArray]
) -> tuple[float, float]:
    """Distance of two axes, and the foot of their common normal along the first one."""
    (point, direction), (other_point, other_direction) = axis, other
    normal = np.cross(direction, other_direction)
    between = other_point - point
    squared = normal @ normal
    along = np.cross(between, other_direction) @ normal / squared
    return float(abs(between @ normal) / np.sqrt(squared)), float(along)

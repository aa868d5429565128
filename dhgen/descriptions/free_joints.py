"""Which joints of an arm with more than six the caller is to give: those that leave most structure.

By geometry alone, at once: which six joints have three neighbours whose axes meet or are parallel,
which is what makes a closed form (Pieper 1968). Six joints without six independent motions reach
nearly no pose, whatever structure they have. What each choice costs in full, `dhgen` prints for a
robot file without `free`.
"""

from __future__ import annotations

import math
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from dhgen.descriptions.lines import are_parallel, common_normal
from dhgen.descriptions.rotations import STILL, about, cross, minus, placed, times, turned

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.arrays import FloatArray
    from dhgen.descriptions.lines import Arm, Axis
    from dhgen.descriptions.rotations import Placed

SIX = 6  # joints that a pose fixes
ELBOW = 3  # where no other one is better, the turn of the upper arm is given
SAMPLES = 3  # postures: one alone may be nearly singular by chance
# Singular values [rad, arm sizes]: what rounding and --snap leave of a motion that is lost is less,
# and in one of a few postures a motion that there is has more.
LOST = 1e-6


def free_joints(arm: Arm) -> tuple[int, ...]:
    """Joints, from 1, whose values are to be given; none of an arm of six joints or fewer."""
    extra = len(arm.axes) - SIX
    if extra < 1 or any(axis.shares for axis in arm.axes):  # coupled arms have no free joints
        return ()
    numbers = range(1, len(arm.axes) + 1)
    if extra == 1 and _has(arm, (1, 2, 3), _meet) and _has(arm, (5, 6, 7), _meet):
        return (3,)  # shoulder and wrist: the elbow's own angle is what the pose fixes
    order = sorted(combinations(numbers, extra), key=lambda free: _rank(arm, free))
    jacobians = _jacobians(arm)
    if not _is_regular(jacobians):
        return order[0]
    return next((free for free in order if _is_regular(_without(jacobians, free))), order[0])


def _jacobians(arm: Arm) -> FloatArray:
    """Motions of the joints at random values, lengths in arm sizes, shape (SAMPLES, 6, n)."""
    rng = np.random.default_rng(0)
    return np.array(
        [_jacobian(arm, rng.uniform(-math.pi, math.pi, len(arm.axes))) for _ in range(SAMPLES)]
    )


def _jacobian(arm: Arm, q: FloatArray) -> FloatArray:
    """The motion of each joint: velocity of the base's origin and angular velocity, shape (6, n).

    Args:
        arm: The arm.
        q: Joint values [rad or arm sizes].
    """
    frame: Placed = (STILL, (0.0, 0.0, 0.0))
    columns = []
    for axis, value in zip(arm.axes, map(float, q), strict=True):
        direction = turned(frame[0], axis.direction)
        point = times(axis.point, 1.0 / arm.size)
        if axis.turns:
            columns.append((*cross(placed(frame, (STILL, point))[1], direction), *direction))
            R = about(axis.direction, value)
            frame = placed(frame, (R, minus(point, turned(R, point))))
        else:
            columns.append((*direction, 0.0, 0.0, 0.0))
            frame = placed(frame, (STILL, times(axis.direction, value)))
    return np.array(columns).T


def _without(jacobians: FloatArray, free: tuple[int, ...]) -> FloatArray:
    return np.delete(jacobians, [number - 1 for number in free], axis=-1)


def _is_regular(jacobians: FloatArray) -> bool:
    """Whether the joints have six independent motions in one of the postures."""
    return bool(np.linalg.svd(jacobians, compute_uv=False)[:, -1].max() > LOST)


def _rank(arm: Arm, free: tuple[int, ...]) -> tuple[float, ...]:
    """Low where much structure is left; among equals slides, and what is far from the structure."""
    left = [number for number in range(1, len(arm.axes) + 1) if number not in free]
    runs = [run for run in zip(left, left[1:], left[2:], strict=False) if run[2] - run[0] == 2]
    first, last = tuple(left[:3]), tuple(left[-3:])
    kept = {run for run in runs if _has(arm, run, _meet) or _has(arm, run, _parallel)}
    slides = sum(not arm.axes[number - 1].turns for number in free)
    order = [float(number) for number in free]
    if first in kept and last not in kept:
        order = [-number for number in order]
    elif not kept:
        order = [abs(number - ELBOW) for number in order]
    ends = len(kept & {first, last})
    return (-ends, -len(kept), -slides, *order)


def _has(arm: Arm, run: tuple[int, ...], test: Callable[[list[Axis], Arm], bool]) -> bool:
    return test([arm.axes[number - 1] for number in run], arm)


def _meet(axes: list[Axis], arm: Arm) -> bool:
    before, at, after = axes
    if not all(axis.turns for axis in axes):
        return False
    line = (at.point, at.direction)
    feet = []
    for other in (before, after):
        if are_parallel(at.direction, other.direction, arm.near):
            return False
        _, foot, landing = common_normal(line, (other.point, other.direction))
        if math.dist(foot, landing) > arm.negligible:
            return False
        feet.append(foot)
    return math.hypot(*minus(*feet)) <= arm.negligible


def _parallel(axes: list[Axis], arm: Arm) -> bool:
    first, *others = axes
    return all(axis.turns for axis in axes) and all(
        are_parallel(first.direction, axis.direction, arm.near) for axis in others
    )

# SPDX-License-Identifier: MIT
"""Where solutions differ by less than rounding the arm goes on with the one that it is at.

The seed may solve the pose with other joint values than the rows.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .arm import POSE, ROBOT
from .jit import of_file
from .limits import beyond_limits, past_an_end, past_ends
from .places import CLAMPED, CLAMPS, COUPLING, DOF, GIVEN_JOINTS, RANGE_EXCEEDS_A_TURN, ROWS
from .refine import copy_row, half_way, measure_miss, refine, refine_inside
from .status import FREE_JOINT, UNREACHABLE
from .tolerances import APART_BY, BESIDE_SEED, EXACT, FAMILY, LIMIT, TOGETHER
from .turns import turned

if TYPE_CHECKING:
    from .arm import Pose, Robot
    from .arrays import Bytes, Floats

OWN = of_file(__file__)

# Misses half way to two rows whose ratio is below this are equal but for rounding, which differs
# between languages. The first row is taken.
ALIKE = 2.0


@OWN.inner
def _beside_seed(
    arm: Floats, robot: Robot, pose: Pose, q_free: Floats, seed: Floats, x: Floats
) -> bool:
    """Takes x to the solution next to the seed; returns whether there is one.

    It keeps the caller's values and, where joints are clamped or coupled, limits.
    """
    for i in range(int(arm[DOF])):
        here = seed[i]
        if arm[RANGE_EXCEEDS_A_TURN] > 0.0 and abs(past_an_end(arm, i, here)) > BESIDE_SEED:
            here = turned(arm, i, here, here)
        x[i] = here - past_an_end(arm, i, here) if arm[CLAMPS] > 0.0 else here
    for k in range(int(arm[GIVEN_JOINTS])):
        x[int(arm[GIVEN_JOINTS + 1 + k])] = q_free[k]
    if not refine(arm, robot, pose, EXACT, BESIDE_SEED, x):
        return False
    past = arm[CLAMPS] > 0.0 and past_ends(arm, x) > LIMIT
    if past and not refine_inside(arm, robot, pose, arm[CLAMPED], BESIDE_SEED, x):
        return False
    return arm[COUPLING] == 0.0 or beyond_limits(arm, x) <= LIMIT


@OWN.apart(
    f"void(float64[::1], {ROBOT}, {POSE}, float64[::1], float64[::1], float64[:, ::1], uint8[::1])"
)
def follow_seed(
    arm: Floats,
    robot: Robot,
    pose: Pose,
    q_free: Floats,
    seed: Floats,
    q: Floats,
    status: Bytes,
) -> None:
    """Gives the solution next to the seed a row unless it has one.

    The row of a solution close to it, of one that equals it to rounding, an empty row, or any.
    """
    dof, clamps = int(arm[DOF]), arm[CLAMPS] > 0.0
    x, half, e = np.empty(dof), np.empty(dof), np.empty(6)
    place, least, nearest = 0, math.inf, TOGETHER
    if not _beside_seed(arm, robot, pose, q_free, seed, x):
        return
    for row in range(int(arm[ROWS]) - 1, -1, -1):
        between = FAMILY
        if status[row] != UNREACHABLE:
            off = half_way(arm, x, q[row], half)
            between = 0.0
            if off >= TOGETHER or not clamps:
                between = max(measure_miss(arm, robot, pose, half, e), EXACT)
            if off < nearest:
                place, nearest, least = row, off, -1.0  # its own
        if between <= ALIKE * least:
            place = row
        least = min(least, between)
    if least >= 0.0:
        status[place] = FREE_JOINT
    if nearest > APART_BY or (clamps and past_ends(arm, q[place]) > 0.0):
        copy_row(x, q[place])

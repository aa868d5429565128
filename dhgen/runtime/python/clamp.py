# SPDX-License-Identifier: MIT
"""Rows whose joints are beyond their limits, onto them.

Beside a singular pose a joint is known from the pose to rounding over what is left of the least
singular value: if it is beyond a limit by no more than that, it may as well be on it.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .arm import POSE, ROBOT
from .jit import of_file
from .limits import past_ends
from .places import CLAMPED, CLAMPED_AGAIN, CLAMPS_FAR, DOF, ROWS
from .refine import copy_row, half_way, refine, refine_inside
from .status import UNREACHABLE
from .tolerances import DOUBTFUL, EXACT, TOGETHER

if TYPE_CHECKING:
    from .arm import Pose, Robot
    from .arrays import Bytes, Floats

OWN = of_file(__file__)

# A joint that moves by more on its way to a limit reaches another solution [rad, arm sizes]: a
# nearly straight wrist turns far for next to nothing.
MOST_CLAMPED = 1.5
# Steps from half way to the same solution go no farther than so many times the whole way.
HALF_WAY_ASIDE = 0.25


@OWN.apart(f"boolean(float64[::1], {ROBOT}, {POSE}, int64, boolean, float64[:, ::1], uint8[::1])")
def clamp_to_limits(
    arm: Floats, robot: Robot, pose: Pose, row: int, again: bool, rows: Floats, status: Bytes
) -> bool:
    """Clamps the joints of a row that exceed their limits: by little, or as an arm may `again`.

    Returns whether it can: the result must be the same solution, so the middle must also solve the
    pose, and no row with a smaller violation may lie closer.
    """
    q = rows[row]
    beyond, far = past_ends(arm, q), again and arm[CLAMPS_FAR] > 0.0
    if not (beyond > 0.0 and (far or beyond < DOUBTFUL)):
        return False
    dof = int(arm[DOF])
    x, half, to = q.copy(), np.empty(dof), np.empty(dof)
    more = arm[CLAMPED_AGAIN] if again else arm[CLAMPED]
    if not refine_inside(arm, robot, pose, more, math.inf if far else MOST_CLAMPED, x):
        return False
    off = half_way(arm, q, x, half)
    for k in range(int(arm[ROWS])):
        less_beyond = status[k] != UNREACHABLE and past_ends(arm, rows[k]) < beyond
        if less_beyond and half_way(arm, rows[k], x, to) < off:
            return False
    if off >= TOGETHER and not refine(arm, robot, pose, EXACT, HALF_WAY_ASIDE * off, half):
        return False
    copy_row(x, q)
    return True

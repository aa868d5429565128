# SPDX-License-Identifier: MIT
"""All solutions of one pose: fast code where it is regular, else the careful solver.

`functions.of_robot` makes each of these functions anew for a robot, with the names that are
declared below.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .careful import careful_ik
from .coupled import settle_rows
from .jit import COMPILED, carray, room
from .status import INVALID_POSE, OK
from .tiles import ENTRIES

if TYPE_CHECKING:
    from collections.abc import Callable

    from .arm import Pose, Robot
    from .arrays import Bytes, Floats, Ints

# Of the robot:
DOF: int
ROWS: int
GIVEN: int  # how many values the caller gives
counted: tuple[bool, bool, bool]  # which coordinates a pose names
slides: bool  # whether joints slide: then squares of lengths have to be finite, and so cubes
arm: Floats
settle: Callable[[Floats, Bytes, int], int]  # one of the two functions below `careful`
robot: Callable[[], Robot]
read_rows: Callable[[Floats], tuple[bool, Pose]]
shapes: str  # the message for arrays of another shape
given_must: str  # and of values that the caller gives
regular: Callable[[Pose, Floats, Floats, Bytes], bool]  # one of the two functions below
# Of the formulas of regular poses, where the robot has them:
DOUBT: int  # the place of what is not zero for poses that they do not answer
STATUSES: int  # the place of the first row's status
KEPT: int  # the sizes of their arrays
TURNS: int
FILLED: int
places: Ints  # of the joints' values of each row, (rows, joints)
formulas: Callable[[Floats, Floats, Floats, int], None]


def never_regular(pose: Pose, q_free: Floats, q: Floats, status: Bytes) -> bool:  # noqa: ARG001
    """Replaces the fast code where there is none."""
    return False


def by_formulas(pose: Pose, q_free: Floats, q: Floats, status: Bytes) -> bool:
    """A pose at which no joint is free and no branches meet into q and status; False for others."""
    kept, turns = carray(room(KEPT), KEPT), carray(room(TURNS), TURNS)
    rows = carray(room(FILLED), FILLED)
    kept[0], kept[1], kept[2], kept[3] = pose[0], pose[1], pose[2], pose[3]
    kept[4], kept[5], kept[6], kept[7] = pose[4], pose[5], pose[6], pose[7]
    kept[8], kept[9], kept[10], kept[11] = pose[8], pose[9], pose[10], pose[11]
    for i in range(GIVEN):
        kept[ENTRIES + i] = q_free[i]
    kept[DOUBT] = 0.0
    formulas(kept, turns, rows, len(kept) // KEPT)  # a literal would be a type of its own
    if kept[DOUBT] != 0.0:
        return False
    for row in range(ROWS):
        status[row] = np.uint8(rows[STATUSES + row])
        for i in range(DOF):
            q[row, i] = rows[places[row, i]]
    return True


def read(T: Floats, q_free: Floats) -> tuple[bool, Pose]:
    """Whether T is a pose, and values of the caller's finite; the upper three rows."""
    valid, pose = read_rows(T)
    for row in range(3):
        if counted[row]:
            p = pose[4 * row + 3]
            valid = valid and math.isfinite(p * p * p if slides else p)
    for k in range(GIVEN):
        v = q_free[k]
        valid = valid and math.isfinite(v * v * v if slides else v)
    return valid, pose


def careful(pose: Pose, q_free: Floats, seed: Floats, q: Floats, status: Bytes) -> int:
    """All solutions of any pose; how many rows are OK or FREE_JOINT. Arrays of any layout."""
    given, values = carray(room(DOF), DOF), carray(room(DOF), DOF)
    for i in range(GIVEN):
        given[i] = q_free[i]
    for i in range(DOF):
        values[i] = seed[i]
    rows, kinds = np.empty((ROWS, DOF)), np.empty(ROWS, np.uint8)
    count = settle(rows, kinds, careful_ik(arm, robot(), pose, given, values, rows, kinds))
    for row in range(ROWS):
        status[row] = kinds[row]
        for i in range(DOF):
            q[row, i] = rows[row, i]
    return count


def turned_alone(rows: Floats, kinds: Bytes, count: int) -> int:  # noqa: ARG001
    """Replaces `turned_together` where each drive's whole turns are its own."""
    return count


def turned_together(rows: Floats, kinds: Bytes, count: int) -> int:
    """Takes the whole turns of coupled drives together; how many rows are inside limits then."""
    return settle_rows(arm, rows, kinds, count)


def into(T: Floats, q_free: Floats, seed: Floats, q: Floats, status: Bytes) -> int:
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (ROWS, DOF) or status.shape != (ROWS,):
        raise ValueError(shapes)
    if GIVEN > 0 and q_free.shape != (GIVEN,):
        raise ValueError(given_must)
    valid, pose = read(T, q_free)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    if COMPILED and regular(pose, q_free, q, status):
        count = 0
        for row in range(ROWS):
            count += status[row] == OK
        return count
    return careful(pose, q_free, seed, q, status)

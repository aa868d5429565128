# SPDX-License-Identifier: MIT
"""All solutions of arms that are solved for all joints at once: compiled once for all of them.

`tiles` and `one_pose` are made anew for a robot with formulas of its own, whose calls are over in a
microsecond. Here a call takes long, and what is the robot's own comes in two arrays: its numbers,
and `own_numbers`.
"""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from . import pose as poses
from .arrays import NONE_GIVEN
from .careful import careful_ik
from .coupled import settle_rows
from .entry import again
from .jit import lent_rows, lent_statuses, lent_values, of_file
from .places import COUPLING, DOF, ROWS
from .status import INVALID_POSE

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from .arm import Pose
    from .arrays import Bytes, Floats, Ints
    from .jit import Compiling

HOW = of_file(__file__)

# Places among what is a robot's own, behind the addresses of its functions: which coordinates a
# pose names, whether joints slide, how many values the caller gives.
COUNTED, SLIDES, GIVEN = 5, 8, 9

read_rows: Callable[[Floats], tuple[bool, Pose]]  # of the task


def solve(
    arm: Floats, own: Ints, T: Floats, q_free: Floats, seed: Floats, q: Floats, status: Bytes
) -> int:
    """All solutions of a pose; how many rows are OK or FREE_JOINT."""
    rows, dof, slides = int(arm[ROWS]), int(arm[DOF]), own[SLIDES] != 0
    T, q, status = lent_rows(T), lent_rows(q), lent_statuses(status)
    q_free, seed = lent_values(q_free), lent_values(seed)
    if T.shape != (4, 4) or q.shape != (rows, dof) or status.shape != (rows,):
        raise ValueError("T, q and status must have shapes (4, 4), (rows, joints), (rows,)")
    if q_free.shape != (own[GIVEN],) or seed.shape != (dof,):
        raise ValueError("q_free and q_seed must have as many values as there are for them")
    for value in seed:
        if not math.isfinite(value):
            raise ValueError("q_seed must be finite")
    valid, pose = read_rows(T)
    for row in range(3):
        if own[COUNTED + row] != 0:
            p = pose[4 * row + 3]
            valid = valid and math.isfinite(p * p * p if slides else p)
    for v in q_free:
        valid = valid and math.isfinite(v * v * v if slides else v)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    robot = own[0], own[1], own[2], own[3], own[4]
    given, values = np.empty(len(q_free)), np.empty(dof)
    for i in range(len(q_free)):
        given[i] = q_free[i]
    for i in range(dof):
        values[i] = seed[i]
    found, kinds = np.empty((rows, dof)), np.empty(rows, np.uint8)
    count = careful_ik(arm, robot, pose, given, values, found, kinds)
    if arm[COUPLING] > 0.0:
        count = settle_rows(arm, found, kinds, count)
    for row in range(rows):
        status[row] = kinds[row]
        for i in range(dof):
            q[row, i] = found[row, i]
    return count


def solve_many(arm: Floats, own: Ints, T: Floats, q_free: Floats, q: Floats, status: Bytes) -> None:
    """All solutions of many poses, one after another."""
    seed = np.zeros(int(arm[DOF]))
    for k in range(len(T)):
        solve(arm, own, T[k], q_free[k], seed, q[k], status[k])


@functools.cache
def _compiled(task: str) -> tuple[Any, Any]:
    """Both for a task."""
    names = {**globals(), "read_rows": getattr(poses, f"read_{task}")}
    for name, way in (("solve", HOW.jit), ("solve_many", HOW.njit(nogil=True))):
        made = again(names[name], names)
        made.__qualname__ = f"{name} of a {task}"
        names[name] = way(made)
    return names["solve"], names["solve_many"]


def own_numbers(
    how: Compiling, functions: Sequence[str | None], counted: Sequence[bool], **others: int
) -> Callable[[], Ints]:
    """What is a robot's own besides the arm's numbers, once it is asked for.

    Args:
        how: How the functions of its file are compiled.
        functions: Those that the runtime calls, None for one that the robot has not.
        counted: Which coordinates a pose names.
        others: Whether joints slide, and how many values the caller gives.
    """

    @functools.cache
    def own() -> Ints:
        addresses = [how.address(name) if name else 0 for name in functions]
        return np.array([*addresses, *counted, others["slides"], others["given"]])

    return own


def calls_of(task: str, arm: Floats, own: Callable[[], Ints], given: int) -> dict[str, Any]:
    """What a robot's public functions call.

    Args:
        task: What counts of a pose besides coordinates.
        arm: The arm's numbers.
        own: What else is the robot's own.
        given: How many values the caller gives.
    """
    solve, solve_many = _compiled(task)
    zeros = np.zeros(int(arm[DOF]))

    def unseeded(T: Floats, q: Floats, status: Bytes) -> int:
        return solve(arm, own(), T, NONE_GIVEN, zeros, q, status)  # type: ignore[no-any-return]

    def seeded(T: Floats, q: Floats, status: Bytes, seed: Floats) -> int:
        return solve(arm, own(), T, NONE_GIVEN, seed, q, status)  # type: ignore[no-any-return]

    def many(T: Floats, q: Floats, status: Bytes) -> None:
        solve_many(arm, own(), T, np.empty((len(T), 0)), q, status)

    def unseeded_given(T: Floats, q_free: Floats, q: Floats, status: Bytes) -> int:
        return solve(arm, own(), T, q_free, zeros, q, status)  # type: ignore[no-any-return]

    def seeded_given(T: Floats, q_free: Floats, q: Floats, status: Bytes, seed: Floats) -> int:
        return solve(arm, own(), T, q_free, seed, q, status)  # type: ignore[no-any-return]

    def many_given(T: Floats, q_free: Floats, q: Floats, status: Bytes) -> None:
        solve_many(arm, own(), T, q_free, q, status)

    if given:
        return {"unseeded": unseeded_given, "seeded": seeded_given, "many": many_given}
    return {"unseeded": unseeded, "seeded": seeded, "many": many}

# SPDX-License-Identifier: MIT
"""The public functions of robots that take poses only.

`functions.of_robot` makes each of them anew for a robot, with the names that are declared below.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .arguments import BYTE, FLOAT, array_of, demand_array, numbers, results
from .entry import Choice, demand_filled, poses_of, share
from .jit import carray, lent_rows, lent_statuses, lent_values, room

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike, NDArray

    FloatArray = NDArray[np.float64]
    Statuses = NDArray[np.uint8]

# Names of modules take their time in a call that is over in half a microsecond.
empty, contiguous, plain = np.empty, np.ascontiguousarray, np.ndarray
NOTHING = np.empty((0, 0))  # where other robots' callers give values

# Of the robot:
DOF: int
ROWS: int
choice: Choice
kinematics: tuple[Callable[[Any], Any], ...]  # its functions of joint values, fk first
velocities_at: Callable[[FloatArray, FloatArray], FloatArray]  # of a twist, compiled
apart: tuple[Callable[[], None], ...]  # each compiles what is called by address in a file
into: Callable[..., int]  # all solutions of a pose, merged into what calls it
solve_many: Callable[..., None]  # all solutions of many poses, compiled
zeros: Callable[[FloatArray], FloatArray]  # the seed where there is none


def unseeded(T: FloatArray, q: FloatArray, status: Statuses) -> int:
    """All solutions of a pose; in plain arrays, without a seed."""
    seed = zeros(carray(room(DOF), DOF))
    nothing = carray(room(1), 1)
    return into(lent_rows(T), nothing, seed, lent_rows(q), lent_statuses(status))


def seeded(T: FloatArray, q: FloatArray, status: Statuses, seed: FloatArray) -> int:
    """All solutions of a pose; in plain arrays, with a seed."""
    if seed.shape != (DOF,):
        raise ValueError("q_seed must have as many values as the arm has joints")
    for value in seed:
        if not math.isfinite(value):
            raise ValueError("q_seed must be finite")
    nothing = carray(room(1), 1)
    return into(lent_rows(T), nothing, lent_values(seed), lent_rows(q), lent_statuses(status))


def solve_alone(
    k: int,
    T: FloatArray,
    q_free: FloatArray,  # noqa: ARG001
    q: FloatArray,
    status: Statuses,
) -> None:
    """All solutions of pose k of many."""
    unseeded(T[k], q[k], status[k])


def many(T: FloatArray, q: FloatArray, status: Statuses) -> None:
    """All solutions of many poses."""
    solve_many(T, NOTHING, q, status)


def compiled_into(
    T: FloatArray, q: FloatArray, status: Statuses, q_seed: FloatArray | None = None
) -> int:
    """What `ik_into` is to other numba functions."""
    if q_seed is None:
        return unseeded(lent_rows(T), lent_rows(q), lent_statuses(status))
    return seeded(lent_rows(T), lent_rows(q), lent_statuses(status), lent_values(q_seed))


def look_at(T: Any, q: Any, status: Any, q_seed: Any) -> None:  # noqa: ANN401
    """Stops where an array is none that `ik_into` takes."""
    demand_array("T", T, (4, 4), FLOAT)
    demand_filled(q, status, q_seed, (ROWS, DOF))


def ik_into(
    T: FloatArray, q: FloatArray, status: Statuses, q_seed: FloatArray | None = None
) -> int:
    """All solutions into the caller's arrays, for control loops and for other numba functions.

    Memory is allocated {allocates}. numba compiles
    once more for arrays of another layout.

    Args:
        T: Pose (4, 4), float64.
        q: Filled with joint values ({ROWS}, {DOF}), NaN where there is no solution; float64.
        status: Filled with what each row holds ({ROWS},); uint8.
        q_seed: Values for joints that are indeterminate ({DOF},), float64; zeros without it.

    Returns:
        How many rows are OK or FREE_JOINT.

    Raises:
        ValueError: An array has the wrong shape or type, or the seed is not finite.
    """
    try:
        # From Python numba takes its time for an argument that is left out.
        if q_seed is None:
            return unseeded(T, q, status)
        return seeded(T, q, status, q_seed)
    except Exception:
        # Types and shapes are checked in there: only after an error is the array named.
        look_at(T, q, status, q_seed)
        raise


def ik_all(T: ArrayLike, q_seed: ArrayLike | None = None) -> tuple[FloatArray, Statuses]:
    """All solutions: q ({ROWS}, {DOF}) and status ({ROWS},).

    Row b is always branch BRANCHES[b]. It holds joint values where its status is OK, OUT_OF_LIMITS
    (at least one is beyond its limits) or FREE_JOINT (a joint was indeterminate and took the seed's
    value, or one near it), and NaN where that is UNREACHABLE (no solution in this branch, or one
    that an earlier row holds) or INVALID_POSE (T is not a valid pose).

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose ({DOF},); zeros without it.

    Raises:
        ValueError: An argument has the wrong shape, or the seed is not finite.
    """
    q, status = empty((ROWS, DOF)), empty(ROWS, BYTE)
    try:
        pose = contiguous(T) if type(T) is plain else numbers(T, (4, 4), "T")
        if pose.dtype is not FLOAT:
            pose = numbers(T, (4, 4), "T")
        if q_seed is None:
            unseeded(pose, q, status)
        else:
            seeded(pose, q, status, array_of(q_seed, (DOF,), "q_seed"))
    except Exception:
        # Shapes are checked in there: only after an error is the array looked for and named.
        array_of(T, (4, 4), "T")
        raise
    return q, status


def ik(
    T: ArrayLike,
    q_seed: ArrayLike | None = None,
    *,
    branch: str | int | None = None,
    limits: bool = True,
) -> FloatArray:
    """One solution ({DOF},): the nearest to the seed.

    Angles are moved by whole turns into their limits.

    Args:
        T: Pose (4, 4).
        q_seed: Where the arm is ({DOF},); zeros without it.
        branch: Only this branch: a name from BRANCHES, or its row.
        limits: Whether joint limits count: True or False.

    Raises:
        Unreachable: There is no such solution; the message says why.
        ValueError: T is not a valid pose, branch does not exist, or limits is not True or False.
    """
    rows = choice.rows(branch, limits)
    return choice.nearest(ik_all(T, q_seed), q_seed, rows, limits)


def ik_batch(
    T: ArrayLike,
    *,
    cores: int | None = None,
    out: tuple[FloatArray, Statuses] | None = None,
) -> tuple[FloatArray, Statuses]:
    """ik_all for N poses (N, 4, 4), shared among `cores` cores, by default all of them.

    Args:
        T: Poses (N, 4, 4).
        cores: How many threads share the poses.
        out: The arrays q and status to write to, from an earlier call or like those: fresh
            memory can cost more time than the solutions.

    Returns:
        q (N, {ROWS}, {DOF}) and status (N, {ROWS}).

    Raises:
        ValueError: An argument has the wrong shape, or cores is not a whole number from 1.
    """
    poses = poses_of(T, cores)
    q, status = results(out, (len(poses), ROWS, DOF))
    share(many, cores, poses, q, status)
    return q, status


def warm_up() -> None:
    """Compiles everything, or gets it from numba's cache, so that no call waits for it later."""
    zero = np.zeros(DOF)
    T, *_ = [function(zero) for function in kinematics]
    velocities_at(zero, np.zeros(6))
    q, status = ik_all(T)
    ik_into(T, q, status)
    ik_into(T, q, status, zero)
    choice.nearest_row(q, status, zero, True, np.empty(DOF))
    ik_batch(T[np.newaxis])
    for compile_all in apart:
        compile_all()

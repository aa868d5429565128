# SPDX-License-Identifier: MIT
"""The public functions of robots whose callers give joint values or the arm angle, too.

`functions.of_robot` makes each of them anew for a robot, with the names that are declared below.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .arguments import BYTE, FLOAT, array_of, demand_array, numbers, results
from .entry import Choice, demand_filled, poses_of, share
from .jit import carray, lent_rows, lent_statuses, lent_values, room
from .left_to_the_seed import nearest_that_works

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike, NDArray

    FloatArray = NDArray[np.float64]
    Statuses = NDArray[np.uint8]

# Names of modules take their time in a call that is over in half a microsecond.
empty, contiguous, plain = np.empty, np.ascontiguousarray, np.ndarray
FREELY = (-math.inf, math.inf)

# Of the robot:
DOF: int
ROWS: int
GIVEN: int  # how many values the caller gives
choice: Choice
given_of_joints: Callable[[FloatArray], Any]  # what the caller would give, of joint values
reach: float  # half a turn, or the stroke of the joint, where a single value is given
within: tuple[float, float]  # the limits of this value
kinematics: tuple[Callable[[Any], Any], ...]  # its functions of joint values, fk first
velocities_at: Callable[[FloatArray, FloatArray], FloatArray]  # of a twist, compiled
apart: tuple[Callable[[], None], ...]  # each compiles what is called by address in a file
into: Callable[..., int]  # all solutions of a pose, merged into what calls it
solve_many: Callable[..., None]  # all solutions of many poses, compiled
zeros: Callable[[FloatArray], FloatArray]  # the seed where there is none


def unseeded(T: FloatArray, q_free: FloatArray, q: FloatArray, status: Statuses) -> int:
    """All solutions of a pose; in plain arrays, without a seed."""
    seed = zeros(carray(room(DOF), DOF))
    return into(lent_rows(T), lent_values(q_free), seed, lent_rows(q), lent_statuses(status))


def seeded(
    T: FloatArray, q_free: FloatArray, q: FloatArray, status: Statuses, seed: FloatArray
) -> int:
    """All solutions of a pose; in plain arrays, with a seed."""
    if seed.shape != (DOF,):
        raise ValueError("q_seed must have as many values as the arm has joints")
    for value in seed:
        if not math.isfinite(value):
            raise ValueError("q_seed must be finite")
    return into(
        lent_rows(T), lent_values(q_free), lent_values(seed), lent_rows(q), lent_statuses(status)
    )


def solve_alone(k: int, T: FloatArray, q_free: FloatArray, q: FloatArray, status: Statuses) -> None:
    """All solutions of pose k of many."""
    unseeded(T[k], q_free[k], q[k], status[k])


def many(T: FloatArray, q_free: FloatArray, q: FloatArray, status: Statuses) -> None:
    """All solutions of many poses."""
    solve_many(T, q_free, q, status)


def compiled_into(
    T: FloatArray,
    q_free: FloatArray,
    q: FloatArray,
    status: Statuses,
    q_seed: FloatArray | None = None,
) -> int:
    """What `ik_into` is to other numba functions."""
    if q_seed is None:
        return unseeded(lent_rows(T), lent_values(q_free), lent_rows(q), lent_statuses(status))
    return seeded(
        lent_rows(T), lent_values(q_free), lent_rows(q), lent_statuses(status), lent_values(q_seed)
    )


def look_at(T: Any, q_free: Any, q: Any, status: Any, q_seed: Any) -> None:  # noqa: ANN401
    """Stops where an array is none that `ik_into` takes."""
    demand_array("T", T, (4, 4), FLOAT)
    demand_array("q_free", q_free, (GIVEN,), FLOAT)
    demand_filled(q, status, q_seed, (ROWS, DOF))


def ik_into(
    T: FloatArray,
    q_free: FloatArray,
    q: FloatArray,
    status: Statuses,
    q_seed: FloatArray | None = None,
) -> int:
    """All solutions into the caller's arrays, for control loops and for other numba functions.

    Memory is allocated {allocates}. numba compiles
    once more for arrays of another layout.

    Args:
        T: Pose (4, 4), float64.
        q_free: {given} ({GIVEN},), float64.
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
            return unseeded(T, q_free, q, status)
        return seeded(T, q_free, q, status, q_seed)
    except Exception:
        # Types and shapes are checked in there: only after an error is the array named.
        look_at(T, q_free, q, status, q_seed)
        raise


def given_values(q_free: Any, q_seed: Any) -> FloatArray:  # noqa: ANN401
    """What the caller gives, or leaves to the seed."""
    if q_free is not None:
        return numbers(q_free, (GIVEN,), "q_free")
    if q_seed is None:
        raise TypeError("q_free is missing, and there is no q_seed to take it from")
    return array_of(given_of_joints(array_of(q_seed, (DOF,), "q_seed")), (GIVEN,), "q_free")


def ik_all(
    T: ArrayLike, q_free: ArrayLike | None = None, q_seed: ArrayLike | None = None
) -> tuple[FloatArray, Statuses]:
    """All solutions: q ({ROWS}, {DOF}) and status ({ROWS},).

    Row b is always branch BRANCHES[b]. It holds joint values where its status is OK, OUT_OF_LIMITS
    (at least one is beyond its limits) or FREE_JOINT (a joint was indeterminate and took the seed's
    value, or one near it), and NaN where that is UNREACHABLE (no solution in this branch, or one
    that an earlier row holds) or INVALID_POSE (T is not a valid pose, or q_free is
    not finite).

    Args:
        T: Pose (4, 4).
        q_free: {given} ({GIVEN},); the seed's without it.
        q_seed: Values for joints that are indeterminate at this pose ({DOF},); zeros without it.

    Raises:
        ValueError: An argument has the wrong shape, or the seed is not finite.
        TypeError: There is neither q_free nor a seed.
    """
    q, status = empty((ROWS, DOF)), empty(ROWS, BYTE)
    values = given_values(q_free, q_seed)
    try:
        pose = contiguous(T) if type(T) is plain else numbers(T, (4, 4), "T")
        if pose.dtype is not FLOAT:
            pose = numbers(T, (4, 4), "T")
        if q_seed is None:
            unseeded(pose, values, q, status)
        else:
            seeded(pose, values, q, status, array_of(q_seed, (DOF,), "q_seed"))
    except Exception:
        # Shapes are checked in there: only after an error is the array looked for and named.
        array_of(T, (4, 4), "T")
        array_of(values, (GIVEN,), "q_free")
        raise
    return q, status


def ik(
    T: ArrayLike,
    q_free: ArrayLike | None = None,
    q_seed: ArrayLike | None = None,
    *,
    branch: str | int | None = None,
    limits: bool = True,
) -> FloatArray:
    """One solution ({DOF},): the nearest to the seed.

    Angles are moved by whole turns into their limits.

    Args:
        T: Pose (4, 4).
        q_free: {given} ({GIVEN},). Without it the seed's,
            or where that has no solution the nearest value that has one, if it is one value.
        q_seed: Where the arm is ({DOF},); zeros without it.
        branch: Only this branch: a name from BRANCHES, or its row.
        limits: Whether joint limits count: True or False.

    Raises:
        Unreachable: There is no such solution; the message says why.
        ValueError: T is not a valid pose, branch does not exist, or limits is not True or False.
        TypeError: There is neither q_free nor a seed.
    """
    rows, values = choice.rows(branch, limits), given_values(q_free, q_seed)
    try:
        return choice.nearest(ik_all(T, values, q_seed), q_seed, rows, limits)
    except choice.unreachable:
        if q_free is not None or GIVEN != 1:
            raise

        def attempt(value: float) -> FloatArray | None:
            try:
                return choice.nearest(ik_all(T, [value], q_seed), q_seed, rows, limits)
            except choice.unreachable:
                return None

        found = nearest_that_works(attempt, values[0], reach, within if limits else FREELY)
        if found is None:
            raise
        return found


def ik_batch(
    T: ArrayLike,
    q_free: ArrayLike,
    *,
    cores: int | None = None,
    out: tuple[FloatArray, Statuses] | None = None,
) -> tuple[FloatArray, Statuses]:
    """ik_all for N poses (N, 4, 4), shared among `cores` cores, by default all of them.

    Args:
        T: Poses (N, 4, 4).
        q_free: {given} {given_shape}.
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
    if GIVEN == 1 and numbers(q_free, (len(poses), 1), "q_free").shape == (len(poses),):
        q_free = np.reshape(q_free, (-1, 1))
    values = array_of(q_free, (len(poses), GIVEN), "q_free")
    share(many, cores, poses, values, q, status)
    return q, status


def warm_up() -> None:
    """Compiles everything, or gets it from numba's cache, so that no call waits for it later."""
    zero = np.zeros(DOF)
    T, *_ = [function(zero) for function in kinematics]
    velocities_at(zero, np.zeros(6))
    q_free = np.zeros(GIVEN)
    q, status = ik_all(T, q_free)
    ik_into(T, q_free, q, status)
    ik_into(T, q_free, q, status, zero)
    choice.nearest_row(q, status, zero, True, np.empty(DOF))
    ik_batch(T[np.newaxis], q_free[np.newaxis])
    for compile_all in apart:
        compile_all()

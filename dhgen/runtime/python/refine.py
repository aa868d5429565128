# SPDX-License-Identifier: MIT
"""Damped least-squares steps that take joint values to a solution next to them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .arm import POSE, ROBOT
from .jit import of_file
from .least_squares import least_squares
from .limits import past_an_end, past_ends
from .places import (
    DIRECTIONS,
    DOF,
    ENTRIES,
    MISS_WEIGHTS,
    PACE,
    PER_LENGTH,
    PITCH,
    POINTING,
    RANGE_EXCEEDS_A_TURN,
    RECORD,
    ROTATION,
    TURNS,
    WEIGHT,
    YAW,
)
from .serial import forward, rates
from .tolerances import FINE
from .turns import TURN

if TYPE_CHECKING:
    from .arm import Pose, Robot
    from .arrays import Bools, Floats

OWN = of_file(__file__)

# Where two things are singular the Jacobian has rows as small as the joints are near. Damped by the
# square of the miss a step is then longer than the way; damped by the miss it is not, and gains
# where roots meet, because the miss is as small as the square of such rows.
CAUTIOUS = 3e-3
DAMPING = 0.1
STEPS = 20  # what is right ends after two or three, where roots meet after twelve
# A step is in vain if it leaves more of the miss; where n roots meet (1 - 1/n)^n is left. Near
# places where two things are singular some make it worse before it gets better: after so many it
# fails.
SLOW, IN_VAIN = 0.7, 4
NEAR_ENOUGH = 100.0  # times what is enough: nearer rounding decides what a step leaves
# Two joints that are past the ends of their ranges can be refined inside, though perhaps not onto
# the ends: they are put inside as far as they are past, times this, then twice as far, up to that.
NEXT_INSIDE, FARTHEST_INSIDE = 2.0, 16.0


@OWN.inner
def copy_row(values: Floats, to: Floats) -> None:
    """Copies the joint values of a row."""
    for i in range(len(to)):
        to[i] = values[i]


@OWN.inner
def half_way(arm: Floats, x: Floats, q: Floats, half: Floats) -> float:
    """How far joint values are from others, whole turns aside [rad, arm sizes].

    The middle goes into `half`.
    """
    most = 0.0
    for i in range(int(arm[DOF])):
        off = q[i] - x[i]
        if not math.isfinite(off):
            return math.inf  # far away steps overflow
        if arm[TURNS + RECORD * i] > 0.0:
            off -= TURN * math.floor(off / TURN + 0.5)
        most = max(most, abs(off) * math.sqrt(arm[WEIGHT + RECORD * i]))
        half[i] = x[i] + 0.5 * off
    return most


@OWN.inner
def missed_by(arm: Floats, robot: Robot, pose: Pose, q: Floats) -> float:
    """By how much joint values miss the entries that count: the root of the sum of squares."""
    P, total = forward(arm, robot, q), 0.0
    for k in range(int(arm[ENTRIES])):
        place = int(arm[ENTRIES + 1 + k])
        off = P[place // 4, place % 4] - pose[place]
        total += ((arm[PER_LENGTH] if place % 4 == 3 else 1.0) * off) ** 2
    return math.sqrt(total)


@OWN.inner
def measure_miss(arm: Floats, robot: Robot, pose: Pose, q: Floats, e: Floats) -> float:
    """By how much joint values miss a pose, into e, whose angles are 0 half a turn away, too.

    Returns the length of the miss, which differs between the two [arm sizes, rad].
    """
    P, square = forward(arm, robot, q), 0.0
    for i in range(3):
        weight = arm[MISS_WEIGHTS + i]
        e[i] = weight * (pose[4 * i + 3] - P[i, 3]) if weight > 0.0 else 0.0
        e[3 + i] = 0.0
        square += e[i] * e[i]
    if arm[DIRECTIONS] == ROTATION:
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            for c in range(3):
                e[3 + i] += 0.5 * (P[j, c] * pose[4 * k + c] - P[k, c] * pose[4 * j + c])
                square += 0.5 * (P[j, c] - pose[4 * j + c]) ** 2
    elif arm[DIRECTIONS] == POINTING:
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            e[3 + i] = P[j, 2] * pose[4 * k + 2] - P[k, 2] * pose[4 * j + 2]
            square += (P[j, 2] - pose[4 * j + 2]) ** 2
    elif arm[DIRECTIONS] > ROTATION:
        square += _miss_of_angles(arm[DIRECTIONS], P, pose, e)
    return math.sqrt(square)


@OWN.inner
def _miss_of_angles(directions: float, P: Floats, pose: Pose, e: Floats) -> float:
    """What is missed of yaw, pitch or tilt, as turns about the base's axes; and its square.

    A pose without a yaw misses none.
    """
    if directions == YAW:
        e[5] = P[0, 0] * pose[4] - P[1, 0] * pose[0]
        level = pose[0] * pose[0] + pose[4] * pose[4]
        return float(level * ((P[0, 0] - pose[0]) ** 2 + (P[1, 0] - pose[4]) ** 2))
    if directions == PITCH:
        e[3] = pose[8] - P[2, 0]
        return float(e[3] * e[3])
    square = 0.0
    for c in range(3):
        e[3] += pose[8 + c] * P[1, c]
        e[4] -= pose[8 + c] * P[0, c]
        square += (P[2, c] - pose[8 + c]) ** 2
    return square


@OWN.inner
def count_what_counts(directions: float, P: Floats, J: Floats) -> None:
    """Takes out of columns, spins below, what changes no direction of the pose P that counts.

    Of a pitch its rate comes first; else turns that don't count about the base's axes have no
    weight.
    """
    for j in range(J.shape[1]):
        if directions == PITCH:
            J[3, j] = J[3, j] * P[1, 0] - J[4, j] * P[0, 0]
            continue
        along = P[0, 2] * J[3, j] + P[1, 2] * J[4, j] + P[2, 2] * J[5, j]
        for i in range(3):
            J[3 + i, j] -= along * P[i, 2]


@OWN.apart(f"void(float64[::1], {ROBOT}, boolean[::1], float64, float64[::1], float64[::1])")
def add_step(arm: Floats, robot: Robot, held: Bools, damping: float, e: Floats, q: Floats) -> None:
    """Adds the damped least-squares step for the miss e to joint values, some of which are held."""
    dof = len(q)
    J, step = rates(arm, robot, q), np.empty(dof)
    if arm[DIRECTIONS] in (POINTING, PITCH):
        count_what_counts(arm[DIRECTIONS], forward(arm, robot, q), J)
    for j in range(dof):
        pace = 0.0 if held[j] else arm[PACE + RECORD * j]
        for i in range(6):
            J[i, j] *= pace * arm[MISS_WEIGHTS + i]
    least_squares(J, damping + FINE, e, step)
    for j in range(dof):
        q[j] += step[j] * arm[PACE + RECORD * j]


@OWN.inner
def moves(arm: Floats, joint: int) -> bool:
    """Whether a joint moves in refining: none whose value the caller gives."""
    return bool(arm[PACE + RECORD * joint] > 0.0)


@OWN.inner
def _farthest_past(arm: Floats, q: Floats) -> tuple[int, float]:
    """The joint that is farthest past an end of its range, or -1, and how far it is."""
    worst, past = -1, 0.0
    for j in range(len(q)):
        off = past_an_end(arm, j, q[j]) if moves(arm, j) else 0.0
        if abs(off) > abs(past):
            worst, past = j, off
    return worst, past


@OWN.apart(f"boolean(float64[::1], {ROBOT}, {POSE}, float64, float64, float64[::1])")
def refine(arm: Floats, robot: Robot, pose: Pose, enough: float, most: float, q: Floats) -> bool:
    """Takes joint values to some not farther than `most` that miss the pose by less than `enough`.

    If that is negative, to some inside their limits that miss it by less than so much more. Returns
    whether it can.
    Goes on while that gains: where roots meet a step still leaves less than half. Until one gains
    little they are damped so that none goes far.
    """
    dof = len(q)
    half, e, clamps, moved = np.empty(dof), np.empty(6), enough <= 0.0, 0
    held, x, refined = np.zeros(dof, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for k in range(STEPS):
        miss = measure_miss(arm, robot, pose, x, e)
        if clamps and k == 0:
            enough = miss - enough
        worst, past = _farthest_past(arm, x) if clamps and miss < enough else (-1, 0.0)
        if worst >= 0:  # one by one: others may follow it inside, or the first one the second
            moved += 1
            if moved == 2:
                held[:] = False
            held[worst], last = True, math.inf
            x[worst] -= past
            miss = measure_miss(arm, robot, pose, x, e)
        if miss < enough:
            copy_row(x, q)
            refined = True
            enough = 0.5 * miss
        elif refined:
            return True
        elif miss > max(SLOW * last, NEAR_ENOUGH * enough):
            lost += 1
            if lost == IN_VAIN:
                return False
        last = miss
        damping = DAMPING * miss * miss
        if lost == 0 and miss > NEAR_ENOUGH * enough:
            damping = CAUTIOUS * miss
        add_step(arm, robot, held, damping, e, x)
        if not half_way(arm, x, q, half) <= most:
            return refined  # another solution
    return refined


@OWN.apart(f"boolean(float64[::1], {ROBOT}, {POSE}, float64, float64, float64[::1])")
def refine_inside(
    arm: Floats, robot: Robot, pose: Pose, more: float, most: float, q: Floats
) -> bool:
    """Clamps joint values to the ends of ranges that they are past, or else takes them inside.

    Two of them may not be on their ends at once. The pose is missed by less than `more` more than
    before. Returns whether it can.
    """
    if refine(arm, robot, pose, -more, most, q):
        return True
    past = 0
    for i in range(len(q)):
        past += moves(arm, i) and past_an_end(arm, i, q[i]) != 0.0
    if arm[RANGE_EXCEEDS_A_TURN] == 0.0 or past < 2:
        return False
    x, farther = q.copy(), NEXT_INSIDE
    enough = measure_miss(arm, robot, pose, q, np.empty(6)) + more
    while farther <= FARTHEST_INSIDE:
        for i in range(len(q)):
            x[i] = q[i] - moves(arm, i) * farther * past_an_end(arm, i, q[i])
        farther *= 2.0
        if refine(arm, robot, pose, enough, most, x) and past_ends(arm, x) == 0.0:
            copy_row(x, q)
            return True
    return False

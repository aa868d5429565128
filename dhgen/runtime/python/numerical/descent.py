# SPDX-License-Identifier: MIT
"""Steps of damped least squares from joint values to a solution.

`u` are the joints that are solved for, in units (radians or arm sizes); `q` all joints, whose other
values are given.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..arm import miss_at
from ..jit import of_file
from ..least_squares import least_squares
from ..places import PITCH, POINTING, ROTATION, TILT, YAW
from ..rigid import take
from ..tolerances import EXACT, FINE
from ..turns import TURN
from .forward import forward
from .goal import GOAL, take_units
from .places import (
    ARM_ANGLE,
    COORDINATE,
    COORDINATES,
    DIRECTIONS,
    DOF,
    DRIVES,
    EQUATIONS,
    MEASURE,
    PLACE,
    RECORD,
    SIZE,
    SOLVED,
    SPAN_LOW,
    SPAN_WIDTH,
    STRIDE,
    TURNS,
    UNIT,
)

if TYPE_CHECKING:
    from ..arrays import Floats
    from .goal import Goal

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner


# A candidate is a solution if it misses the whole pose by no more [arm sizes, rad]: far above
# rounding, far below where a near miss ends.
SOLUTION = 1e-10
# A sine below this gives no axis to turn about: rounding of the product of two rotations is 1e-15,
# and the angle that belongs to it is as small or half a turn.
ASIDE = 1e-9
# The rotation vector that is taken where half a turn is missing, whose axis may be any.
ANY_TURN = (math.pi * 0.48, math.pi * 0.6, math.pi * 0.64)
# Damping over the square of the miss (the Gauss-Newton step itself near a solution), and what is
# always added, so that a singular arm has a step: below the square of what counts as singular.
DAMPING = 0.1
FLOOR = 1e-13
# Where steps get slow at a miss below this [arm sizes, rad] FINE is added instead: what always is
# keeps them from going on where joints hardly move the tool. Beside singular places the last digits
# count.
NEARLY = 1e-6
LONGEST = 2.0  # of a step's components [rad, arm sizes]: the Jacobian does not hold farther away
STEPS = 40  # from a start; 7 to 16 are usual
# Along a continuum of solutions: a part of the way to the seed with every step, then Newton alone.
PULL = 0.5
PULLED_STEPS = 60
SETTLED = 1e-9  # a step shorter than this ends the pull [rad, arm sizes]


@inner
def _rotation_vector(axis: tuple[float, float, float], cosine: float, vector: Floats) -> None:
    """Computes a rotation vector from its axis times the sine, and the cosine."""
    sine = math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2])
    if sine < ASIDE and cosine < 0.0:
        vector[0], vector[1], vector[2] = ANY_TURN
        return
    scale = 1.0 if sine < ASIDE else math.atan2(sine, cosine) / sine
    for i in range(3):
        vector[i] = scale * axis[i]


@inner
def _missing_rotation(T: Floats, P: Floats, vector: Floats) -> None:
    """Computes the rotation vector that takes the rotation of P to that of T."""
    R = np.zeros((3, 3))
    for i in range(3):
        for j in range(3):
            for k in range(3):
                R[i, j] += T[i, k] * P[4 * j + k]
    axis = 0.5 * (R[2, 1] - R[1, 2]), 0.5 * (R[0, 2] - R[2, 0]), 0.5 * (R[1, 0] - R[0, 1])
    _rotation_vector(axis, 0.5 * (R[0, 0] + R[1, 1] + R[2, 2] - 1.0), vector)


@inner
def _missing_direction(T: Floats, P: Floats, vector: Floats) -> None:
    """Computes the rotation vector that takes the z axis of P to that of T."""
    axis = (
        P[6] * T[2, 2] - P[10] * T[1, 2],
        P[10] * T[0, 2] - P[2] * T[2, 2],
        P[2] * T[1, 2] - P[6] * T[0, 2],
    )
    cosine = P[2] * T[0, 2] + P[6] * T[1, 2] + P[10] * T[2, 2]
    _rotation_vector(axis, cosine, vector)


@inner
def _missing_tilt(T: Floats, P: Floats, vector: Floats) -> None:
    """Computes the turn about level axes that takes the third row of P to that of T."""
    across = T[2, 0] * P[4] + T[2, 1] * P[5] + T[2, 2] * P[6]
    along = -T[2, 0] * P[0] - T[2, 1] * P[1] - T[2, 2] * P[2]
    cosine = T[2, 0] * P[8] + T[2, 1] * P[9] + T[2, 2] * P[10]
    turn = np.empty(3)
    _rotation_vector((across, along, 0.0), cosine, turn)
    vector[0], vector[1] = turn[0], turn[1]


@inner
def _direction_rates(arm: Floats, P: Floats, spin: Floats, column: Floats) -> None:
    """Computes how what counts of directions changes with a joint whose spin (3,) is given."""
    if arm[DIRECTIONS] == POINTING:  # turning about z changes nothing
        along = P[2] * spin[0] + P[6] * spin[1] + P[10] * spin[2]
        for i in range(3):
            column[i] = spin[i] - along * P[4 * i + 2]
    elif arm[DIRECTIONS] == YAW:  # the tool's x axis is level wherever the arm is
        column[0] = spin[2]
    elif arm[DIRECTIONS] == PITCH:
        column[0] = spin[0] * P[4] - spin[1] * P[0]
    else:  # the first are all that counts: of tilts, turns about level axes
        for i in range(len(column)):  # assigned whole, numba compares shapes
            column[i] = spin[i]


@inner
def _missing_directions(arm: Floats, T: Floats, P: Floats, miss: Floats) -> None:
    """Computes what of directions is missed; a pose without a yaw misses none."""
    if arm[DIRECTIONS] == ROTATION:
        _missing_rotation(T, P, miss)
    elif arm[DIRECTIONS] == POINTING:
        _missing_direction(T, P, miss)
    elif arm[DIRECTIONS] == YAW:
        sine, cosine = P[0] * T[1, 0] - P[4] * T[0, 0], P[0] * T[0, 0] + P[4] * T[1, 0]
        miss[0] = math.atan2(sine, cosine)
    elif arm[DIRECTIONS] == PITCH:
        miss[0] = T[2, 0] - P[8]
    elif arm[DIRECTIONS] == TILT:
        _missing_tilt(T, P, miss)


@apart(f"float64(float64[::1], {GOAL}, float64[::1], float64[::1], float64[::1], float64[:, ::1])")
def measure_miss(arm: Floats, goal: Goal, q: Floats, u: Floats, e: Floats, A: Floats) -> float:
    """Returns by how much u misses the pose: the length of e, whose Jacobian goes into A."""
    (T, q_free, arm_angle_miss), solved, dof = goal, int(arm[SOLVED]), int(arm[DOF])
    take_units(arm, u, q)
    P, J = np.empty(12), np.empty((6, dof))
    forward(arm, q, P, J)
    coordinates = int(arm[COORDINATES])
    directions = int(arm[EQUATIONS] - arm[ARM_ANGLE]) - coordinates
    rates = np.empty(directions)
    for j in range(solved):
        at = RECORD * j
        column = int(arm[PLACE + at])
        for i in range(coordinates):
            A[i, j] = arm[MEASURE + at] * J[int(arm[COORDINATE + i]), column]
        _direction_rates(arm, P, J[3:, column], rates)
        for i in range(directions):
            A[coordinates + i, j] = arm[UNIT + at] * rates[i]
    for i in range(coordinates):
        row = int(arm[COORDINATE + i])
        e[i] = (T[row, 3] - P[4 * row + 3]) / arm[SIZE]
    _missing_directions(arm, T, P, e[coordinates:])
    if arm[ARM_ANGLE] > 0.0:
        off, last = np.empty(4), int(arm[EQUATIONS]) - 1
        miss_at(arm_angle_miss, T, q_free, q, off)
        e[last] = off[0]
        for j in range(solved):
            A[last, j] = arm[UNIT + RECORD * j] * off[1 + j] if j < 3 else 0.0
    square = 0.0
    for i in range(int(arm[EQUATIONS])):
        square += e[i] * e[i]
    return math.sqrt(square)


@inner
def wrap_angles(arm: Floats, u: Floats) -> None:
    """Moves angles by whole turns to (-pi, pi], and what such a turn moves besides."""
    solved, at = int(arm[SOLVED]), int(arm[DRIVES])
    if arm[at] > 0.0:
        for k in range(int(arm[at])):
            move = at + 1 + k * (solved + 1)
            turns = math.ceil(u[int(arm[move])] / TURN - 0.5)
            for j in range(solved):
                u[j] -= turns * arm[move + 1 + j]
        return
    for j in range(solved):
        if arm[TURNS + RECORD * j] > 0.0:
            u[j] -= TURN * math.ceil(u[j] / TURN - 0.5)


@inner
def shorten(step: Floats) -> None:
    """Makes a step no longer than it may be."""
    longest = LONGEST
    for j in range(len(step)):
        longest = max(longest, abs(step[j]))
    for j in range(len(step)):
        step[j] *= LONGEST / longest


@inner
def damped_step(A: Floats, e: Floats, length: float, floor: float, step: Floats) -> None:
    """Computes the damped least squares step for the miss e, with a least damping."""
    least_squares(A, DAMPING * min(length * length, 1.0) + floor, e, step)


@apart(f"float64(float64[::1], {GOAL}, float64[::1], float64[::1])")
def descend(arm: Floats, goal: Goal, q: Floats, u: Floats) -> float:
    """Refines u by damped least squares; returns by how much it misses the pose then.

    Near to the pose less damping than usual gains more, where joints hardly move the tool: there a
    step that is right may be long, and what it leaves, half of its square, far more than was
    missed.
    """
    solved = int(arm[SOLVED])
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), solved))
    least, best, step, floor = math.inf, u.copy(), np.empty(solved), FLOOR
    last, left = math.inf, 0.0  # the miss before a step, and what its curvature leaves
    for _ in range(STEPS + 1):
        length = measure_miss(arm, goal, q, u, e, A)
        slow = length >= max(0.5 * last, left)
        stalled = slow and least <= (SOLUTION if floor < FLOOR else EXACT)
        if slow and least <= NEARLY:
            floor = FINE
        if length < least:
            least = length
            take(best, u)
        if stalled:
            break
        damped_step(A, e, length, floor, step)
        shorten(step)
        way = 0.0
        for j in range(solved):
            u[j] += step[j]
            way += abs(step[j])
        last, left = length, 0.5 * way * way if floor < FLOOR else 0.0
    take(u, best)
    return least


@inner
def _limited_step(
    A: Floats,
    e: Floats,
    length: float,
    wish: Floats,
    u: Floats,
    low: Floats,
    high: Floats,
    step: Floats,
) -> None:
    """Computes a step with a wish; joints that would exceed a limit go there, and are locked."""
    equations, solved = A.shape
    fixed, locked = np.zeros(solved), np.zeros(solved, np.uint8)
    rest = np.empty(equations)
    beyond = True
    while beyond:
        beyond = False
        for i in range(equations):
            rest[i] = e[i]
            for j in range(solved):
                rest[i] -= A[i, j] * wish[j]
        damped_step(A, rest, length, FLOOR, step)
        for j in range(solved):
            step[j] += wish[j]
        shorten(step)
        for j in range(solved):
            end = u[j] + step[j]
            if locked[j]:
                step[j] = fixed[j]
            elif end < low[j] or end > high[j]:
                step[j] = fixed[j] = (low[j] if end < low[j] else high[j]) - u[j]
                beyond, locked[j], wish[j] = True, 1, 0.0
                for i in range(equations):
                    e[i] -= A[i, j] * fixed[j]
                    A[i, j] = 0.0


@apart(
    f"float64(float64[::1], {GOAL}, float64[::1], float64[::1], float64[::1], "
    "float64[::1], float64[::1])"
)
def descend_towards(
    arm: Floats, goal: Goal, q: Floats, u: Floats, near: Floats, low: Floats, high: Floats
) -> float:
    """Takes u to a solution on the way to `near`; returns by how much it misses the pose."""
    solved = int(arm[SOLVED])
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), solved))
    least, best, step, pull = math.inf, u.copy(), np.empty(solved), PULL
    wish = np.empty(solved)
    for k in range(1, PULLED_STEPS + STEPS + 1):
        length = measure_miss(arm, goal, q, u, e, A)
        if pull == 0.0:
            if length >= 0.5 * least and least <= SOLUTION:
                break
            if length < least:
                least = length
                take(best, u)
        for j in range(solved):
            wish[j] = pull * (min(max(near[j], low[j]), high[j]) - u[j])
        _limited_step(A, e, length, wish, u, low, high, step)
        longest = 0.0
        for j in range(solved):
            longest = max(longest, abs(step[j]))
            u[j] += step[j]
        if k >= PULLED_STEPS or longest < SETTLED:
            pull = 0.0
    take(u, best)
    return least


@inner
def start_of(arm: Floats, k: int, near: Floats, u: Floats) -> None:
    """Sets u to start number k; number 0 is the seed."""
    for j in range(int(arm[SOLVED])):
        at = RECORD * j
        u[j] = (
            near[j]
            if k == 0
            else arm[SPAN_LOW + at] + arm[SPAN_WIDTH + at] * ((0.5 + k * arm[STRIDE + at]) % 1.0)
        )


@inner
def null_part(A: Floats, along: Floats) -> float:
    """Leaves of a direction the part that leaves the tool where it is; returns how long it was.

    To first order; that part is one long.
    """
    equations, solved = A.shape
    moved, rest, square = np.empty(equations), np.empty(solved), 0.0
    for i in range(equations):
        moved[i] = 0.0
        for j in range(solved):
            moved[i] += A[i, j] * along[j]
    damped_step(A, moved, 0.0, FLOOR, rest)
    for j in range(solved):
        along[j] -= rest[j]
        square += along[j] * along[j]
    length = math.sqrt(square)
    for j in range(solved):
        along[j] /= length
    return length


@inner
def sideways(arm: Floats, A: Floats, along: Floats) -> float:
    """Computes the null part of a generic direction; returns how long it was."""
    for j in range(len(along)):
        along[j] = arm[STRIDE + RECORD * j]
    return null_part(A, along)

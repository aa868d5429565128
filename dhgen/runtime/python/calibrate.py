# SPDX-License-Identifier: MIT
"""What a table, or origins, make of an arm of a kind, which is worked out once: calibrate.h."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .arm import descents_of
from .calibration import (
    CONSTANT,
    FACING,
    LEFT,
    LOOP,
    MARGIN,
    MORE,
    MOVED,
    NOMINAL,
    NUMBERS,
    RIGHT,
    SIZE,
    TURNED,
    calibration_of,
)
from .general.places import (
    ADVANCE_C,
    ADVANCE_S,
    LINK_COUNT,
    LINK_RECORD,
    LINKS,
    PER_SIZE,
    SIZE_OF_LOOP,
)
from .jit import of_file
from .numerical.places import BASE, CHAIN, CHAIN_RECORD, JOINT_AFTER
from .rigid import follow, invert, slide, take, take_from, turn

if TYPE_CHECKING:
    from .arrays import Floats

OWN = of_file(__file__)
inner, jit = OWN.inner, OWN.jit

# Parallel axes leave a common slide of their frames open: this much weight on the slides closes it.
RIDGE = 1e-09
# Deviations above this are of another arm [rad, arm sizes].
MOST_DEVIATION = 0.05
# Three axes that miss being parallel, or meeting, by less have a closed form of their own: the
# general algorithm has no certificate there [rad, arm sizes].
LEAST_MISS = 1e-09
# Numbers above this leave less than eleven digits of where links are: no calibration has
# them [rad, arm sizes].
MOST_NUMBER = 1e5
# The square of the sine of an angle from which axes are far from parallel.
FAR_FROM_PARALLEL = 1e-4
# Rounds in which a frame's place on its axis and the zero of the joint before it are found: each
# changes the other by as much as axes miss being parallel.
FITS = 3
# Poses are left whose rows may end within what the tools differ by, or within so many times that
# part of it by which two links side by side differ: beside a wrist that is missed by one length a
# row has a second solution at 0.95 of the distance.
MARGIN_SIDE_BY_SIDE = 1.5
# What bounds of deviations are enlarged by for rounding [rad, arm sizes].
ROUNDED_DEVIATION = 1e-10

# What is wrong with a table, or with origins.
TAKEN, NOT_FINITE, ANOTHER_ARM, NO_MISS = range(4)

JOINTS = 6
CELLS, PLACES = 4, 6  # numbers in a row of a table, and of an origin
TABLE_SHAPE, ORIGINS_SHAPE = (JOINTS, CELLS), (JOINTS + 1, PLACES)
TRIPLES = 4  # of axes side by side

# The places of a kind's numbers in its array.
IS_MODIFIED = 0  # the convention of tables
LENGTH = 1  # the size of the arm
Z, E = 2, 14  # base and tool
COUNTED = 26  # six: how joints count
PARALLEL, MEETING = 32, 36  # whether axes i, i + 1, i + 2 are so nominally
TABLE = 40  # that of the data sheet
NUMBERS_OF_KIND = 64


@inner
def append_screw_z(theta: float, d: float, T: Floats) -> None:
    """Moves a frame along its z axis, turns it about that."""
    slide(T, d)
    turn(T, math.cos(theta), math.sin(theta))


@inner
def append_screw_x(alpha: float, a: float, T: Floats) -> None:
    """Moves a frame along its x axis, turns it about that."""
    c, s = math.cos(alpha), math.sin(alpha)
    for i in range(0, 12, 4):
        y = T[i + 1]
        T[i + 3] += T[i] * a
        T[i + 1] = y * c + T[i + 2] * s
        T[i + 2] = T[i + 2] * c - y * s


@inner
def _be_identity(T: Floats) -> None:
    for i in range(12):
        T[i] = 1.0 if i % 5 == 0 else 0.0


@inner
def constants_of(kind: Floats, table: Floats, constant: Floats) -> None:
    """Computes C0 ... C6 of a table."""
    for k in range(JOINTS + 1):
        C = constant[k]
        row = k if kind[IS_MODIFIED] > 0.0 else k - 1
        if k > 0:
            _be_identity(C)
            append_screw_z(0.0, table[4 * (k - 1) + 1], C)
        else:
            take_from(C, kind, Z)
        if 0 <= row < JOINTS:
            append_screw_x(table[4 * row + 3], table[4 * row + 2], C)
        if k < JOINTS:
            append_screw_z(table[4 * k], 0.0, C)
        else:
            follow(C, kind[E : E + 12])


@inner
def constants_of_origins(kind: Floats, origins: Floats, constant: Floats) -> None:
    """Computes C0 ... C6 of x, y, z, roll, pitch, yaw: of joints' frames, and of one behind."""
    origin = np.empty(12)
    for k in range(JOINTS + 1):
        at, C = origins[PLACES * k : PLACES * (k + 1)], constant[k]
        cr, sr = math.cos(at[3]), math.sin(at[3])
        cp, sp = math.cos(at[4]), math.sin(at[4])
        cy, sy = math.cos(at[5]), math.sin(at[5])
        # Rz(yaw) Ry(pitch) Rx(roll)
        origin[0], origin[1], origin[2] = cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr
        origin[4], origin[5], origin[6] = sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr
        origin[8], origin[9], origin[10] = -sp, cp * sr, cp * cr
        origin[3], origin[7], origin[11] = at[0], at[1], at[2]
        if k > 0:
            take(C, origin)
        else:
            take_from(C, kind, Z)
            follow(C, origin)
        if k == JOINTS:
            follow(C, kind[E : E + 12])


@inner
def solve_normal(A: Floats, b: Floats) -> None:
    """Solves a positive definite system of six equations; the solution takes the place of b."""
    for i in range(JOINTS):
        for j in range(i + 1, JOINTS):
            factor = A[j, i] / A[i, i]
            for k in range(i, JOINTS):
                A[j, k] -= factor * A[i, k]
            b[j] -= factor * b[i]
    for i in range(JOINTS - 1, -1, -1):
        for k in range(i + 1, JOINTS):
            b[i] -= A[i, k] * b[k]
        b[i] /= A[i, i]


@inner
def shifts(constant: Floats, shift: Floats) -> None:
    """Computes how far frames move along their axes so that the squares of links add up least."""
    normal, along = np.zeros((JOINTS, JOINTS)), np.empty(2)
    for i in range(JOINTS):
        normal[i, i] = RIDGE
        shift[i] = 0.0
    for i in range(JOINTS - 1):
        K = constant[i + 1]
        for k in range(3):
            # The link's vector becomes t - s z + s' z'.
            along[0], along[1] = -1.0 if k == 2 else 0.0, K[4 * k + 2]
            for a in range(2):
                shift[i + a] -= along[a] * K[4 * k + 3]
                for b in range(2):
                    normal[i + a, i + b] += along[a] * along[b]
    solve_normal(normal, shift)


@inner
def make_loop(general: Floats, of: Floats) -> None:
    """Makes the arm a loop of six joints with the shortest links, in arm sizes."""
    constant = of[CONSTANT : CONSTANT + 84].reshape(7, 12)
    loop = of[LOOP : LOOP + 84].reshape(7, 12)
    shift, last, total = np.empty(JOINTS), np.empty(12), 0.0
    shifts(constant, shift)
    for i in range(JOINTS - 1):
        K = loop[i]
        _be_identity(K)
        slide(K, -shift[i])
        follow(K, constant[i + 1])
        slide(K, shift[i + 1])
        turn(K, general[ADVANCE_C + i + 1], general[ADVANCE_S + i + 1])
        total += length_of(K)
    of[SIZE] = 0.5 * total
    for i in range(JOINTS - 1):
        for k in range(3, 12, 4):
            loop[i, k] /= of[SIZE]
    take(last, constant[0])
    slide(last, shift[0])
    turn(last, general[ADVANCE_C], general[ADVANCE_S])
    take(loop[5], invert(last))
    _be_identity(last)
    slide(last, -shift[5])
    follow(last, constant[6])
    take(loop[6], invert(last))


@inner
def turned_between(A: Floats, B: Floats) -> float:
    """Returns the angle of the rotation between two, by its chord: all digits of a small one."""
    square = 0.0
    for i in range(12):
        square += 0.0 if i % 4 == 3 else (A[i] - B[i]) * (A[i] - B[i])
    return 2.0 * math.asin(min(math.sqrt(0.125 * square), 1.0))


@inner
def moved_between(A: Floats, B: Floats) -> float:
    """Returns the distance of two frames."""
    square = 0.0
    for i in range(3, 12, 4):
        square += (A[i] - B[i]) * (A[i] - B[i])
    return math.sqrt(square)


@inner
def length_of(C: Floats) -> float:
    """Returns the length of what a transform moves by."""
    return math.sqrt(C[3] * C[3] + C[7] * C[7] + C[11] * C[11])


@inner
def turn_before(N: Floats, C: Floats) -> float:
    """Returns by how much a nominal link is to be turned about z: the axis behind is as behind C.

    Computed from the directions of axes that are far from parallel, else from where they are.
    """
    column = 2 if N[2] * N[2] + N[6] * N[6] > FAR_FROM_PARALLEL else 3
    sine = N[column] * C[4 + column] - N[4 + column] * C[column]
    return math.atan2(sine, N[column] * C[column] + N[4 + column] * C[4 + column])


@inner
def fit_constant(N: Floats, C: Floats) -> tuple[float, float, float]:
    """Makes a nominal constant and a link as near to each other as what is free can take them.

    N becomes Rz(before) N Rz(behind), with other zeros of the joints at its ends; C becomes
    C Tz(along), with the frame behind it elsewhere on its axis. Returns the three.
    """
    turned, along, before = np.empty(12), 0.0, 0.0
    for n in range(FITS):
        before = turn_before(N, C) if n > 0 else 0.0
        _be_identity(turned)
        turn(turned, math.cos(before), math.sin(before))
        follow(turned, N)
        further = 0.0
        for i in range(0, 12, 4):
            further += C[i + 2] * (turned[i + 3] - C[i + 3])
        slide(C, further)
        along += further
    cosine, sine = 0.0, 0.0
    for i in range(0, 12, 4):
        cosine += turned[i] * C[i] + turned[i + 1] * C[i + 1]
        sine += turned[i + 1] * C[i] - turned[i] * C[i + 1]
    behind = math.atan2(sine, cosine)
    turn(turned, math.cos(behind), math.sin(behind))
    take(N, turned)
    return before, behind, along


@inner
def foot_on_axis(
    p0: float, p1: float, p2: float, u0: float, u1: float, u2: float
) -> tuple[float, float]:
    """Returns where the common normal with a line meets the z axis, and how far the line is apart.

    The line is a point of it and its direction.
    """
    square = u0 * u0 + u1 * u1  # of the normal (-u1, u0, 0)
    apart = abs(p1 * u0 - p0 * u1) / math.sqrt(square)
    return p2 - u2 * (p0 * u0 + p1 * u1) / square, apart


@inner
def shift_of_first(N: Floats, C: Floats) -> float:
    """Returns how far a frame on axis 1 is, along it, from where the nominal arm has it.

    As far as the feet of the common normals with axis 2 are apart, or, where the two are parallel
    in one of the arms, as links are.
    """
    if min(N[2] * N[2] + N[6] * N[6], C[2] * C[2] + C[6] * C[6]) <= FAR_FROM_PARALLEL:
        return float(C[11] - N[11])
    foot, _ = foot_on_axis(C[3], C[7], C[11], C[2], C[6], C[10])
    nominal, _ = foot_on_axis(N[3], N[7], N[11], N[2], N[6], N[10])
    return foot - nominal


@inner
def find_nearest(kind: Floats, of: Floats) -> None:
    """Finds the nominal arm as near to the calibrated one as what is free can take it.

    Free are other zeros of its joints, another base and another tool, and the places of the
    calibrated arm's frames on their axes: common normals of axes that are nearly parallel may be
    far away. What is left between constants adds up to how far the tools may be apart: a rotation
    counts at the length of what is behind it.
    """
    constant = of[CONSTANT : CONSTANT + 84].reshape(7, 12)
    nominal = of[NOMINAL : NOMINAL + 84].reshape(7, 12)
    left, right, slid = of[LEFT : LEFT + 12], of[RIGHT : RIGHT + 12], np.empty(12)
    constants_of(kind, kind[TABLE:], nominal)
    shift = shift_of_first(nominal[1], constant[1])  # along axis 1 the base takes up what is missed
    slide(constant[0], shift)
    take(left, nominal[0])
    follow(left, invert(constant[0]))
    of[MORE] = 0.0
    for k in range(1, JOINTS + 1):
        _be_identity(slid)
        slide(slid, -shift)
        follow(slid, constant[k])
        if k < JOINTS:
            before, of[MORE + k], shift = fit_constant(nominal[k], slid)
            of[MORE + k - 1] += before
        take(constant[k], slid)
    take(right, invert(constant[6]))
    follow(right, nominal[6])
    of[TURNED], of[MOVED] = ROUNDED_DEVIATION, ROUNDED_DEVIATION * kind[LENGTH]
    length, most, farthest, turned_behind, moved_behind = length_of(nominal[6]), 0.0, 0.0, 0.0, 0.0
    for k in range(JOINTS - 1, 0, -1):
        turned = turned_between(nominal[k], constant[k])
        moved = moved_between(nominal[k], constant[k]) + turned * length
        of[TURNED] += turned
        of[MOVED] += moved
        most = max(most, turned + turned_behind)
        farthest = max(farthest, moved + moved_behind)
        turned_behind, moved_behind = turned, moved
        length += length_of(nominal[k])
    side_by_side = max(most / of[TURNED], farthest / of[MOVED])
    of[MARGIN] = max(1.0, MARGIN_SIDE_BY_SIDE * side_by_side)


@inner
def tilt(C: Floats) -> float:
    """Returns by how much an axis misses being parallel to the next one [rad]."""
    return math.atan2(math.sqrt(C[2] * C[2] + C[6] * C[6]), abs(C[10]))


@inner
def missed_point(before: Floats, behind: Floats) -> float:
    """Returns by how much axes before and behind that between two links miss a point of it."""
    back = invert(before)
    foot, apart = foot_on_axis(back[3], back[7], back[11], back[2], back[6], back[10])
    other, off = foot_on_axis(behind[3], behind[7], behind[11], behind[2], behind[6], behind[10])
    return max(abs(foot - other), apart, off)


@inner
def least_miss(kind: Floats, of: Floats) -> float:
    """Returns the least of what three axes miss being parallel [rad], or meeting [arm sizes].

    Of those that are so in the nominal arm.
    """
    constant, least = of[CONSTANT : CONSTANT + 84].reshape(7, 12), math.inf
    for i in range(TRIPLES):
        before, behind = constant[i + 1], constant[i + 2]
        if kind[PARALLEL + i] > 0.0:
            least = min(least, max(tilt(before), tilt(behind)))
        if kind[MEETING + i] > 0.0:
            least = min(least, missed_point(before, behind) / kind[LENGTH])
    return least


@inner
def _fill_general(general: Floats, of: Floats) -> None:
    """Takes the links of a calibrated arm to where the general algorithm and descents read them."""
    general[SIZE_OF_LOOP], general[PER_SIZE] = of[SIZE], 1.0 / of[SIZE]
    links, chain = int(general[LINKS]) + 1, int(general[CHAIN])
    for k in range(LINK_COUNT):
        at = chain + (BASE + (k - 1) * CHAIN_RECORD + JOINT_AFTER if k > 0 else 0)
        for i in range(12):
            general[links + LINK_RECORD * k + i] = of[LOOP + 12 * k + i]
            general[at + i] = of[CONSTANT + 12 * k + i]


@inner
def is_length(number: int, is_table: bool) -> bool:
    """Whether a number, row by row, is a length: d and a of a table; x, y, z of an origin."""
    return number % CELLS in {1, 2} if is_table else number % PLACES < 3


@inner
def fault_of_numbers(kind: Floats, numbers: Floats, is_table: bool) -> int:
    """Returns NOT_FINITE, or ANOTHER_ARM where one is larger than in any calibration."""
    fault = TAKEN
    for i in range(len(numbers)):
        if not math.isfinite(numbers[i]):
            return NOT_FINITE
        if abs(numbers[i]) > MOST_NUMBER * (kind[LENGTH] if is_length(i, is_table) else 1.0):
            fault = ANOTHER_ARM
    return fault


@inner
def _work_out(kind: Floats, general: Floats, of: Floats) -> int:
    """Works out what an arm's constants make of it. Returns TAKEN, or what is wrong with them."""
    for i in range(JOINTS):
        of[FACING + i] = kind[COUNTED + i]
    find_nearest(kind, of)
    make_loop(general, of)
    _fill_general(general, of)
    if not (of[TURNED] <= MOST_DEVIATION and of[MOVED] <= MOST_DEVIATION * kind[LENGTH]):
        return ANOTHER_ARM
    return NO_MISS if least_miss(kind, of) < LEAST_MISS else TAKEN


@jit
def calibrate(kind: Floats, numbers: Floats, arm: Floats) -> int:
    """Works out what a table, or origins, make of an arm.

    Args:
        kind: The numbers of the kind.
        numbers: The arm's own, row by row: 24 of a table, 42 of origins.
        arm: That of no table, a copy of `blank_numbers`; is filled.

    Returns:
        TAKEN, or what is wrong with the numbers.
    """
    of, general = calibration_of(arm), descents_of(arm)
    is_table = len(numbers) == CELLS * JOINTS
    fault = fault_of_numbers(kind, numbers, is_table)
    if fault == NOT_FINITE:
        for k in range(NUMBERS):
            of[k] = math.nan
        _fill_general(general, of)
        return fault
    constant = of[CONSTANT : CONSTANT + 84].reshape(7, 12)
    if is_table:
        constants_of(kind, numbers, constant)
    else:
        constants_of_origins(kind, numbers, constant)
    other = _work_out(kind, general, of)
    return other if fault == TAKEN else fault

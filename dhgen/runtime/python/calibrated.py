# SPDX-License-Identifier: MIT
"""Arms of one kind, each with a table of its own: what calibrate.h and calibrated.h do.

What a table says is worked out once, and every call reads it. The closed form of the nominal arm is
tried first (`near_nominal` in calls_calibrated.py, made anew for each kind); where its rows may not
lead to all solutions the general algorithm answers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .arm import arm_numbers, descents_of
from .calibration import (
    CONSTANT,
    FACING,
    LEFT,
    LOOP,
    MORE,
    MOVED,
    NOMINAL,
    NUMBERS,
    RIGHT,
    SIZE,
    TURNED,
    calibration_of,
)
from .frames import IDENTITY
from .general.arm import Link, Loop, general_numbers
from .general.places import (
    ADVANCE_C,
    ADVANCE_S,
    LINK_COUNT,
    LINK_RECORD,
    LINKS,
    PER_SIZE,
    SIZE_OF_LOOP,
)
from .general.postures import rows_filled
from .jit import of_file
from .numerical.arm import Arm as Descents
from .numerical.arm import ChainJoint, Joint
from .numerical.places import BASE, CHAIN, CHAIN_RECORD, JOINT_AFTER
from .rigid import follow, invert, pose_of_links, slide, take, take_from, turn

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .arm import Arm
    from .arrays import Floats, Ints
    from .general.arm import Formulation

OWN = of_file(__file__)
inner, jit = OWN.inner, OWN.jit

# Parallel axes leave a common slide of their frames open: this much weight on the slides closes it.
RIDGE = 1e-09
# Deviations above this are of another arm [rad, arm sizes].
MOST_DEVIATION = 0.05
# Three axes that miss being parallel, or meeting, by less have a closed form of their own: the
# general algorithm has no certificate there [rad, arm sizes].
LEAST_MISS = 1e-09
# Numbers of tables above this leave less than eleven digits of where links are: no calibration has
# them [rad, arm sizes].
MOST_NUMBER = 1e5
# The square of the sine of an angle from which axes are far from parallel.
FAR_FROM_PARALLEL = 0.1
# Rounds in which a frame's place on its axis and the zero of the joint before it are found: each
# changes the other by as much as axes miss being parallel.
FITS = 3
# What bounds of deviations are enlarged by for rounding [rad, arm sizes].
ROUNDED_DEVIATION = 1e-10

# What is said of a table.
TAKEN, NOT_FINITE, ANOTHER_ARM, NO_MISS = range(4)

JOINTS = 6
TRIPLES = 4  # of axes side by side

# Where the numbers of a kind stand in its array.
IS_MODIFIED = 0  # the convention of tables
LENGTH = 1  # the size of the arm
Z, E = 2, 14  # base and tool
COUNTED = 26  # six: how joints count
PARALLEL, MEETING = 32, 36  # whether axes i, i + 1, i + 2 are so nominally
TABLE = 40  # that of the data sheet
NUMBERS_OF_KIND = 64


@dataclass(frozen=True, slots=True)
class Kind:
    """What calibrated arms of a kind have in common.

    Attributes:
        arm: What is done around their rows.
        table: That of the data sheet, (6, 4).
        convention: What its rows are: `standard` or `modified`.
        base: The arm's base in the caller's frame, twelve numbers.
        tool: The tool in the last frame.
        facing: How joints count, 1 or -1.
        parallel: First axes, from 0, of three side by side that are parallel.
        meeting: Of three that meet.
        reach: The square of what is out of reach for all links of the loop in line [arm sizes].
        advances: Cosine and sine of what is added to each joint's angle in it.
        formulations: Of the general algorithm, in the order in which they are tried.
    """

    arm: Arm
    table: Sequence[Sequence[float]]
    convention: str
    facing: tuple[float, ...]
    reach: float
    advances: tuple[tuple[float, float], ...]
    formulations: tuple[Formulation, ...]
    base: tuple[float, ...] = IDENTITY
    tool: tuple[float, ...] = IDENTITY
    parallel: tuple[int, ...] = ()
    meeting: tuple[int, ...] = ()


def kind_numbers(kind: Kind) -> Floats:
    """The array of a kind."""
    numbers = np.zeros(NUMBERS_OF_KIND)
    numbers[IS_MODIFIED], numbers[LENGTH] = kind.convention == "modified", kind.arm.size
    numbers[Z : Z + 12], numbers[E : E + 12] = kind.base, kind.tool
    numbers[COUNTED : COUNTED + JOINTS] = kind.facing
    for first, places in ((PARALLEL, kind.parallel), (MEETING, kind.meeting)):
        for place in places:
            numbers[first + place] = 1.0
    numbers[TABLE:] = np.ravel(kind.table)
    return numbers


def blank_numbers(kind: Kind) -> Floats:
    """The array of an arm of which no table is known."""
    arm = kind.arm
    joints = tuple(
        Joint(place=place, lowest=low, highest=high, facing=facing)
        for place, ((low, high), facing) in enumerate(zip(arm.limits, kind.facing, strict=True))
    )
    descents = Descents(
        rows=arm.rows,
        size=arm.size,
        coordinates=(0, 1, 2),
        directions=arm.directions,
        joints=joints,
        base=IDENTITY,
        chain=tuple(ChainJoint(after=IDENTITY, sign=facing) for facing in kind.facing),
    )
    loop = Loop(
        size=1.0,
        reach=kind.reach,
        links=(Link(IDENTITY),) * LINK_COUNT,
        advances=kind.advances,
        formulations=kind.formulations,
    )
    calibration = np.full(NUMBERS, math.nan)
    return arm_numbers(arm, general_numbers(descents, loop), calibration=calibration)


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

    Axes that are far from parallel tell by their directions, others by where they are.
    """
    told = 2 if N[2] * N[2] + N[6] * N[6] > FAR_FROM_PARALLEL else 3
    sine = N[told] * C[4 + told] - N[4 + told] * C[told]
    return math.atan2(sine, N[told] * C[told] + N[4 + told] * C[4 + told])


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
def find_nearest(kind: Floats, of: Floats) -> None:
    """Finds the nominal arm as near to the calibrated one as what is free can take it.

    Free are other zeros of its joints, another base and another tool, and where frames of the
    calibrated arm stand on their axes: common normals of axes that are nearly parallel may be far
    away. What is left between constants adds up to how far the tools may be apart: a rotation
    counts at the length of what is behind it.
    """
    constant = of[CONSTANT : CONSTANT + 84].reshape(7, 12)
    nominal = of[NOMINAL : NOMINAL + 84].reshape(7, 12)
    left, right, slid = of[LEFT : LEFT + 12], of[RIGHT : RIGHT + 12], np.empty(12)
    constants_of(kind, kind[TABLE:], nominal)
    shift = constant[1, 11] - nominal[1, 11]  # along axis 1 the base takes up what is missed
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
    length = length_of(nominal[6])
    for k in range(JOINTS - 1, 0, -1):
        turned = turned_between(nominal[k], constant[k])
        of[TURNED] += turned
        of[MOVED] += moved_between(nominal[k], constant[k]) + turned * length
        length += length_of(nominal[k])


@inner
def foot_on_axis(
    p0: float, p1: float, p2: float, u0: float, u1: float, u2: float
) -> tuple[float, float]:
    """Returns where on the z axis the common normal with a line stands, and how far it is apart.

    The line is a point of it and its direction.
    """
    square = u0 * u0 + u1 * u1  # of the normal (-u1, u0, 0)
    apart = abs(p1 * u0 - p0 * u1) / math.sqrt(square)
    return p2 - u2 * (p0 * u0 + p1 * u1) / square, apart


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


@jit
def calibrate(kind: Floats, table: Floats, arm: Floats) -> int:
    """Works out what a table makes of an arm. Returns TAKEN, or what is wrong with the table.

    Args:
        kind: The numbers of the kind.
        table: The arm's own, 24 numbers row by row.
        arm: That of no table, a copy of `blank_numbers`; is filled.
    """
    of, general = calibration_of(arm), descents_of(arm)
    for i in range(len(table)):
        if not math.isfinite(table[i]):
            for k in range(NUMBERS):
                of[k] = math.nan
            _fill_general(general, of)
            return NOT_FINITE
    for i in range(JOINTS):
        of[FACING + i] = kind[COUNTED + i]
    constants_of(kind, table, of[CONSTANT : CONSTANT + 84].reshape(7, 12))
    find_nearest(kind, of)
    make_loop(general, of)
    _fill_general(general, of)
    for i in range(len(table)):
        unit = kind[LENGTH] if i % 4 in {1, 2} else 1.0  # d and a are lengths
        if abs(table[i]) > MOST_NUMBER * unit:
            return ANOTHER_ARM
    if not (of[TURNED] <= MOST_DEVIATION and of[MOVED] <= MOST_DEVIATION * kind[LENGTH]):
        return ANOTHER_ARM
    return NO_MISS if least_miss(kind, of) < LEAST_MISS else TAKEN


@inner
def near_angles(of: Floats, filled: Floats, places: Ints) -> tuple[Ints, Floats]:
    """Returns the nominal arm's rows that hold a solution, and their angles of the loop, (k, 6).

    Args:
        of: The numbers of the calibrated arm.
        filled: What the formulas of regular poses fill in: joints' values, then statuses.
        places: Of the joints' values of each row, (rows, 6).
    """
    rows = rows_filled(filled, len(places))
    nearby = np.empty((len(rows), JOINTS))
    for k in range(len(rows)):
        for i in range(JOINTS):
            nearby[k, i] = of[FACING + i] * filled[places[rows[k], i]] - of[MORE + i]
    return rows, nearby


@inner
def nominal_pose(of: Floats, q: Floats, values: Floats) -> Floats:
    """Returns the nominal arm's pose at joint values of this arm; fills in its own."""
    angles = np.empty(JOINTS)
    for i in range(JOINTS):
        angles[i] = of[FACING + i] * q[i]
        values[i] = of[FACING + i] * (angles[i] + of[MORE + i])
    return pose_of_links(of, NOMINAL, angles)

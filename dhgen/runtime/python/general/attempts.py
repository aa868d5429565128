# SPDX-License-Identifier: MIT
"""What one formulation finds, and whether that is certainly everything."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import carray, of_file, room
from ..rigid import invert
from .candidates import PLACES, count_singular, offer
from .circle import COMPLETE, ROOTS, UNSEEN
from .equations import equations, fold, hidden_length, independence
from .four_turns import four_turns_joints, shows_all, split_links
from .loop import around, joints_of, sign_of
from .places import HAS_WRIST, HIDDEN_SLIDE, PER_ROOT, WAYS
from .recover import angles, null_vectors
from .roots import CLOSED_FORM, DETERMINANT, INDEPENDENT, real_roots
from .tables import SAMPLES
from .wrist import wrist_joints

if TYPE_CHECKING:
    from ..arrays import Floats, Ints

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

CLOSE = 1e-3  # roots closer than this are also tried as a double root [rad]
CLOSE_SQUARE = 4.0 - CLOSE**2  # of the sum of two such unit vectors
# As near to a double root simple ones are looked for [rad], at a few places at a time, and how
# often: each parabola shows where to look next.
BESIDE, AT_A_TIME, PARABOLAS = 1e-4, 8, 4
BRACKET_STEPS = 8  # from 3e-5 rad to the digits that the determinant has
ROOTS_AND_PAIRS = 3 * ROOTS  # simple roots with the middles of close pairs
ROOTS_BESIDE = ROOTS_AND_PAIRS + ROOTS  # and roots close to double ones
ANGLES = 6 * ROOTS  # simple roots, double roots, and what may lie on both sides of these
FAR = 2  # what four_turns_joints returns where slides would have to reach too far


@apart("float64[::1](float64[:, ::1], float64[::1])")
def _determinants(E: Floats, angles_of: Floats) -> Floats:
    """Returns the determinant at a few angles."""
    c, s, f = np.empty(SAMPLES), np.empty(SAMPLES), np.empty(SAMPLES)
    for k in range(SAMPLES):
        angle = angles_of[k % len(angles_of)]
        c[k], s[k] = math.cos(angle), math.sin(angle)
    fold(E, c, s, f)
    return f


@apart("void(float64[:, ::1], float64[:, ::1], float64[:, ::1], float64[::1])")
def _close_brackets(E: Floats, ends: Floats, values: Floats, root: Floats) -> None:
    """Computes the roots in brackets, by the line between their ends.

    An end that is kept twice has its value halved.
    """
    moved = np.full(AT_A_TIME, -1)
    for _ in range(BRACKET_STEPS):
        for k in range(AT_A_TIME):
            part, fall = 0.5, values[0, k] - values[1, k]
            if fall != 0.0:
                part = values[0, k] / fall
            if not 0.0 < part < 1.0:
                part = 0.5
            root[k] = ends[0, k] + part * (ends[1, k] - ends[0, k])
        f = _determinants(E, root)
        for k in range(AT_A_TIME):
            end = 1 if (f[k] < 0.0) != (values[0, k] < 0.0) else 0
            ends[end, k], values[end, k] = root[k], f[k]
            if moved[k] == end:
                values[1 - end, k] *= 0.5
            moved[k] = end


@inner
def _add_brackets(x: Floats, f: Floats, ends: Floats, values: Floats, count: int) -> int:
    """Adds a bracket wherever neighbouring values have unlike signs; returns how many there are."""
    for k in range(AT_A_TIME - 1):
        if (f[k] < 0.0) != (f[k + 1] < 0.0) and count < AT_A_TIME:
            for end in range(2):
                ends[end, count], values[end, count] = x[k + end], f[k + end]
            count += 1
    return count


@inner
def _turning_back(f: Floats) -> int:
    """Returns which value is nearest to zero among values whose neighbours are farther from it.

    These are on the same side of zero. Returns 0 where there is none.
    """
    least = 0
    for k in range(1, AT_A_TIME - 1):
        side = -1.0 if f[k] < 0.0 else 1.0
        size = abs(f[k])
        turns = size <= side * f[k - 1] and size <= side * f[k + 1]
        if turns and (least == 0 or size < abs(f[least])):
            least = k
    return least


@apart("int64(float64[:, ::1], float64, float64[::1], int64)")
def _separate(E: Floats, angle: float, places: Floats, total: int) -> int:
    """Adds simple roots beside an angle where roots may have met; returns the count.

    The determinant itself has digits there that its fit lacks, and between values of unlike signs
    there is a root. Where it turns back, between values that are alike, the next ones are taken
    about where a parabola has its roots, or turns.
    """
    ends, values = np.zeros((2, AT_A_TIME)), np.zeros((2, AT_A_TIME))
    x, root = np.empty(AT_A_TIME), np.empty(AT_A_TIME)
    count = known = 0
    for k in range(AT_A_TIME):
        x[k] = angle + BESIDE * (2 * k - 7) / 7.0
    for turn in range(PARABOLAS):
        f = _determinants(E, x)
        count = _add_brackets(x, f, ends, values, count)
        known = count if turn == 0 else known
        least = _turning_back(f)
        if least == 0 or count > known:
            break
        low, high = x[least - 1], x[least + 1]
        if not low < x[least] < high:
            break
        a = (f[least] - f[least - 1]) / (x[least] - low)
        b = (f[least + 1] - f[least]) / (high - x[least])
        bend = (b - a) / (high - low)
        if bend == 0.0:
            break
        slope = a + bend * (x[least] - low)
        square = slope * slope - 4.0 * bend * f[least]
        middle = x[least] - 0.5 * slope / bend
        reach = 0.75 * min(middle - low, high - middle)
        if square > 0.0:
            reach = min(reach, math.sqrt(square) / abs(bend))
        x[0], x[AT_A_TIME - 1] = low, high
        for k in range(1, AT_A_TIME - 1):
            x[k] = middle + reach * (2 * k - 7) / 5.0
    if count:
        _close_brackets(E, ends, values, root)
    for k in range(min(count, ROOTS_BESIDE - total)):
        places[total] = root[k]
        total += 1
    return total


@inner
def _angles_to_try(
    E: Floats, roots: Floats, counts: Ints, places: Floats, beside: Ints
) -> tuple[int, int]:
    """Fills the hidden angles to try; returns their count, and which is the first double root.

    Simple roots, the middles of pairs of them that nearly meet, simple roots beside double roots,
    double roots. `beside` takes how many simple ones are beside each of these.
    """
    simple, touching = counts[0], counts[1] + counts[UNSEEN]
    total = simple
    for i in range(simple):
        places[i] = roots[0, i]
        for j in range(i):
            gap = math.cos(0.5 * (roots[0, i] - roots[0, j]))
            if 4.0 * gap * gap > CLOSE_SQUARE and total < ROOTS_AND_PAIRS:
                middle = 0.5 * (roots[0, i] + roots[0, j])
                places[total] = middle if gap > 0.0 else middle + math.pi
                total += 1
    for i in range(touching):
        before = total
        total = _separate(E, roots[1, i], places, total)
        beside[i] = total - before
    first_double = total
    for i in range(touching):
        places[total] = roots[1, i]
        total += 1
    return total, first_double


@inner
def _factors_from(
    E: Floats, places: Floats, first: int, total: int, cosines: Floats, sines: Floats
) -> Floats:
    """Returns what folding leaves at the next angles to try; fills their cosines and sines."""
    for k in range(SAMPLES):
        angle = places[min(first + k, total - 1)]
        cosines[k], sines[k] = math.cos(angle), math.sin(angle)
    return fold(E, cosines, sines, np.empty(SAMPLES))


@apart(
    "Tuple((boolean, int64))(float64[::1], int64, float64[:, ::1], float64[:, ::1], float64[::1], "
    "int64[::1], int64[::1], int64)"
)
def try_formulation(
    arm: Floats,
    form: int,
    loop: Floats,
    q: Floats,
    residual: Floats,
    marks: Ints,
    doubles_met: Ints,
    count: int,
) -> tuple[bool, int]:
    """Returns whether what a formulation finds is certainly everything, and the count.

    The certificate: a solution is found at every simple root and at every root close to a double
    one; there are at least as many different solutions as such roots, where a double root that may
    be real counts twice at least, or once if the arm is singular there; and regular solutions come
    in pairs. Where the determinant only comes near to zero there is no root; where it nearly
    vanishes all around, rounding of the equations may lift it off a double root, which nothing but
    they show. What an attempt before took for double roots is none then; whether the arm is
    singular there is looked at.
    """
    doubted = doubles_met[0] > 0
    joints, links, sign = joints_of(arm, form), around(arm, form, loop), sign_of(arm, form)
    E = equations(arm, joints, links)
    good, roots, counts = real_roots(arm, DETERMINANT, E, joints, links, links)
    if not good:
        return False, count
    simple, complete = counts[0], counts[COMPLETE] == 1
    places = np.empty(ANGLES)
    beside = np.zeros(2 * ROOTS, dtype=np.int64)
    total, first_double = _angles_to_try(E, roots, counts, places, beside)
    first_beside = first_double - beside.sum()
    met = np.zeros(PLACES, dtype=np.int64)
    cosines, sines = np.empty(SAMPLES), np.empty(SAMPLES)
    c, s = carray(room(6), 6), carray(room(6), 6)
    tc, ts = carray(room(6), 6), carray(room(6), 6)
    vectors, expected, true_doubles = np.empty((5, 6)), simple, 0
    factors = np.empty((0, 0, 0))
    for i in range(total):
        at = i % SAMPLES
        if at == 0:
            factors = _factors_from(E, places, i, total, cosines, sines)
        cosine, sine = cosines[at], sines[at]
        met_here = singular_here = False
        ways, regular = null_vectors(factors, at, i >= simple, vectors)
        if i >= first_double:
            regular = regular and independence(E, cosine, sine) > INDEPENDENT
        for n in range(ways):
            c[0], s[0] = cosine, sine
            if arm[HIDDEN_SLIDE] > 0.0:
                c[0], s[0] = 1.0, hidden_length(cosine, sine)
            angles(arm, joints, links, vectors[n], c, s)
            for k in range(6):
                tc[joints[k]], ts[joints[k]] = c[k], sign * s[k]
            place, count = offer(
                arm, loop, tc, ts, False, doubted or i >= simple, q, residual, marks, count
            )
            if place >= 0:
                met[place] = 1
                met_here = True
                singular_here = singular_here or marks[place] & 1 == 1
        if i < simple or first_beside <= i < first_double:
            complete = complete and met_here
        elif i >= first_double:
            known = beside[i - first_double]
            if met_here or not regular:
                true_doubles += 1
                known = 1 if singular_here else max(2, known)
            expected += known
    regular_count = count - count_singular(marks)
    complete = complete and count_singular(met) >= expected and regular_count % 2 == 0
    doubles_met[0] = true_doubles if complete else doubles_met[0] + counts[1]
    return complete, count


@inner
def _way_joints(
    arm: Floats,
    joints: Ints,
    links: Floats,
    between: Floats,
    way: int,
    cosine: float,
    sine: float,
    c: Floats,
    s: Floats,
) -> int:
    """Computes the joints from a root of a polynomial in closed form, in one of a few ways.

    Returns 1 if they are to be tried, FAR if slides would have to reach too far, 0 if not.
    """
    if arm[HAS_WRIST] > 0.0:
        return wrist_joints(arm, links, between[0], way, cosine, sine, c, s)
    return four_turns_joints(arm, joints, links, between, way, cosine, sine, c, s)


@apart(
    "Tuple((boolean, int64))(float64[::1], int64, float64[:, ::1], float64[:, ::1], float64[::1], "
    "int64[::1], int64[::1], int64)"
)
def try_closed_form(
    arm: Floats,
    which: int,
    loop: Floats,
    q: Floats,
    residual: Floats,
    marks: Ints,
    doubles_met: Ints,
    count: int,
) -> tuple[bool, int]:
    """Returns whether what a polynomial in closed form finds is certainly all, and the count.

    The certificate is that of the formulations, with PER_ROOT solutions a root.
    """
    joints, links, between = np.zeros(6, np.int64), loop, np.zeros((4, 12))
    if arm[HAS_WRIST] > 0.0:
        link = invert(loop[4])
        for i in range(12):
            between[0, i] = link[i]
    else:
        joints, links = joints_of(arm, which), around(arm, which, loop)
        split_links(arm, joints, links, between)
    nothing = np.empty((0, 0))
    good, roots, counts = real_roots(arm, CLOSED_FORM, nothing, joints, links, between)
    if not good:
        return False, count
    complete, expected, per_root = counts[COMPLETE] == 1, 0, int(arm[PER_ROOT])
    if arm[HAS_WRIST] == 0.0:
        complete = complete and shows_all(between, roots, counts)
    doubles_met[0] += counts[1]
    met = np.zeros(PLACES, dtype=np.int64)
    c, s = np.empty(6), np.empty(6)
    for double in range(2):
        for i in range(counts[double]):
            here = np.zeros(PLACES, dtype=np.int64)
            singular_here = False
            cosine, sine = math.cos(roots[double, i]), math.sin(roots[double, i])
            far = 0
            for way in range(int(arm[WAYS])):
                kind = _way_joints(arm, joints, links, between, way, cosine, sine, c, s)
                far += kind == FAR
                if kind != 1:
                    continue
                place, count = offer(
                    arm, loop, c, s, False, counts[1] > 0, q, residual, marks, count
                )
                if place >= 0:
                    here[place] = met[place] = 1
                    singular_here = singular_here or marks[place] & 1 == 1
            if far and not count_singular(here):
                continue
            complete = complete and count_singular(here) >= per_root
            expected += 2 * per_root if double and not singular_here else per_root
            expected -= far
    regular = count - count_singular(marks)
    return complete and count_singular(met) >= expected and regular % 2 == 0, count

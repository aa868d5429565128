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
BESIDE = 1e-4  # as near to a double root two simple ones are looked for [rad]
PARABOLAS = 3  # one after the other that tell them apart
ROOTS_AND_PAIRS = 3 * ROOTS  # simple roots with the middles of close pairs
ANGLES = 6 * ROOTS  # those, the double roots, and what may stand on both sides of them
FAR = 2  # what four_turns_joints returns where slides would have to reach too far


@apart("int64(float64[:, ::1], float64, float64[::1], int64)")
def _separate(E: Floats, angle: float, places: Floats, total: int) -> int:
    """Adds two simple roots beside an angle where roots may have met; returns the count.

    The determinant itself has digits there that its fit lacks. Each parabola is as wide as the one
    before says that they are apart.
    """
    c, s, f = np.empty(SAMPLES), np.empty(SAMPLES), np.empty(SAMPLES)
    middle, apart_by = angle, BESIDE
    for _ in range(PARABOLAS):
        for k in range(SAMPLES):
            turned = middle + (k % 3 - 1) * apart_by
            c[k], s[k] = math.cos(turned), math.sin(turned)
        fold(E, c, s, f)
        slope, bend = 0.5 * (f[2] - f[0]), 0.5 * (f[2] + f[0]) - f[1]
        square = slope * slope - 4.0 * bend * f[1]
        if not (square > 0.0 and bend != 0.0):
            return total
        middle -= 0.5 * slope / bend * apart_by
        apart_by *= math.sqrt(square) / abs(bend)
        if abs(middle - angle) + apart_by >= BESIDE:
            return total  # so far apart that they are known
    places[total], places[total + 1] = middle - 0.5 * apart_by, middle + 0.5 * apart_by
    return total + 2


@inner
def _angles_to_try(E: Floats, roots: Floats, counts: Ints, places: Floats) -> tuple[int, int]:
    """Fills the hidden angles to try; returns their count, and which is the first double root.

    Simple roots, the middles of pairs of them that nearly meet, what stands beside double roots,
    double roots.
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
        total = _separate(E, roots[1, i], places, total)
    first_double = total
    for i in range(touching):
        places[total] = roots[1, i]
        total += 1
    return total, first_double


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

    The certificate: every simple root leads to a solution, there is another one for each of them
    and two more for each double root, or a singular one; and regular solutions come in pairs. Where
    the determinant only comes near to zero there is no root; where it nearly vanishes all around,
    rounding of the equations may lift it off a double root, which nothing but they show. What an
    attempt before took for double roots is none then; whether the arm is singular there is looked
    at.
    """
    doubted = doubles_met[0] > 0
    joints, links, sign = joints_of(arm, form), around(arm, form, loop), sign_of(arm, form)
    E = equations(arm, joints, links)
    good, roots, counts = real_roots(arm, DETERMINANT, E, joints, links, links)
    if not good:
        return False, count
    simple, complete = counts[0], counts[COMPLETE] == 1
    places = np.empty(ANGLES)
    total, first_double = _angles_to_try(E, roots, counts, places)
    met = np.zeros(PLACES, dtype=np.int64)
    cosines, sines, determinant = np.empty(SAMPLES), np.empty(SAMPLES), np.empty(SAMPLES)
    c, s = carray(room(6), 6), carray(room(6), 6)
    tc, ts = carray(room(6), 6), carray(room(6), 6)
    vectors, expected, true_doubles = np.empty((5, 6)), simple, 0
    factors = np.empty((0, 0, 0))
    for i in range(total):
        at = i % SAMPLES
        if at == 0:
            for k in range(SAMPLES):
                angle = places[min(i + k, total - 1)]
                cosines[k], sines[k] = math.cos(angle), math.sin(angle)
            factors = fold(E, cosines, sines, determinant)
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
            elif i < simple:
                complete = False
        if i >= first_double and (met_here or not regular):
            expected += 1 if singular_here else 2
            true_doubles += 1
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

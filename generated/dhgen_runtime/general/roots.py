# SPDX-License-Identifier: MIT
"""All real roots of a polynomial on the circle that is known by what computes it.

Its fit has a rounding of 1e-15 of its largest value, all around the circle; where roots crowd, or
come near to the circle, that hides whether there are any. Values that are computed there have their
digits: what may be a double root is looked at again, through a lens of its own. Values lack the
digits that what they are computed from lacks: where they come near to zero, that is asked.

The polynomial is the determinant of equations E, or one in closed form, known by a setting: the
joints of a formulation, links, and what the closed form makes of them beforehand.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import carray, of_file, room
from ..turns import TURN
from .circle import COMPLETE, DOUBLE, LIFTED, ROOTS, UNSEEN, add_root, find_roots, fit
from .equations import fold, independence, nearness
from .four_turns import four_turns_polynomial
from .moebius import spread, through, without_lens
from .places import HAS_WRIST, HIDDEN_SLIDE, ORDER
from .recover import null_vectors
from .tables import CELLS, HALF_CELLS, SAMPLE_C, SAMPLE_S, SAMPLES
from .wrist import wrist_polynomial

if TYPE_CHECKING:
    from ..arrays import Floats, Ints

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

# Harmonics beyond the eighth above this: f vanishes identically at this pose [of its largest
# value].
NOISE = 1e-6
# f may nearly vanish identically: a look with more noise than this does not show what there is not.
CLEAR = 1e-10
# Samples that are no larger are rounding of zero, also where that is as smooth as a polynomial and
# its harmonics don't show it; elsewhere the largest are above 1e-20, even of arms that nearly have
# double roots at every pose.
VANISHING = 1e-26
# Rounding of f in its largest value, at least this; more when the harmonics beyond 8 are larger.
# These show only part of an error that all samples share: where four roots meet, down to a
# thirtieth.
ROUNDING = 3e-15
NOISE_FACTOR = 64.0
LOOKS = 4  # more closely, at most
# How far a closer look reaches to both sides [rad], nearly, and its cosine from half the tangent.
NEAR = 1 / 16
NEAR_COSINE = (1 - (NEAR / 2) ** 2) / (1 + (NEAR / 2) ** 2)
# A look replaces what is known within this, so that it shows both roots of a pair that ends beyond;
# what it shows farther away, less magnified, is new where nothing known is within ASIDE of it.
WITHIN = 15 / 256
WITHIN_COSINE = (1 - (WITHIN / 2) ** 2) / (1 + (WITHIN / 2) ** 2)
ASIDE = 1 / 512
ASIDE_COSINE = (1 - (ASIDE / 2) ** 2) / (1 + (ASIDE / 2) ** 2)
STRENGTH = (1 - NEAR) / (1 + NEAR)  # in the middle a lens of this strength magnifies 1 / NEAR times
REACH = 38  # in cells: from tan(psi/2) = tan(phi/2) / NEAR, NEAR becomes 0.93 rad
# An extremum close to zero may be a double root that rounding has lifted off, also that of the
# equations behind f, which f does not show: when a complex pair is this near to the circle [rad].
# From it the value of a parabola over its bend; in a closer look it is farther.
NEAR_CIRCLE = 1e-4
LIFTED_BY = 0.5 * NEAR_CIRCLE**2
LIFTED_CLOSER = 0.5 * (NEAR_CIRCLE / NEAR) ** 2
# A determinant does not show whether the matrix is singular where the columns that are cleared
# first nearly depend on each other: where their least singular value is below this part of all,
# squared.
INDEPENDENT = 3e-4**2
DETERMINANT, CLOSED_FORM = range(2)  # kinds of polynomials


@inner
def _sample_determinant(arm: Floats, E: Floats, x: float, y: float, samples: Floats) -> None:
    """Computes the determinant at the sample angles, through a lens.

    Without its zero where the length of a hidden slide is infinite.
    """
    c = carray(room(SAMPLES), SAMPLES)
    s = carray(room(SAMPLES), SAMPLES)
    weight = carray(room(SAMPLES), SAMPLES)
    for k in range(SAMPLES):
        c[k], s[k], weight[k] = through(x, y, SAMPLE_C[k], SAMPLE_S[k])
    fold(E, c, s, samples)
    if arm[HIDDEN_SLIDE] > 0.0:
        order = int(arm[ORDER])
        for k in range(SAMPLES):
            weight[k] /= nearness(c[k], s[k]) ** order
    for k in range(SAMPLES):
        samples[k] *= weight[k]


@inner
def _sample_closed_form(
    arm: Floats,
    joints: Ints,
    links: Floats,
    between: Floats,
    x: float,
    y: float,
    samples: Floats,
) -> None:
    """Computes a polynomial in closed form at the sample angles, through a lens."""
    if arm[HAS_WRIST] > 0.0:
        for k in range(SAMPLES):
            c, s, weight = through(x, y, SAMPLE_C[k], SAMPLE_S[k])
            samples[k] = weight * wrist_polynomial(arm, links, between[0], c, s)
    else:
        for k in range(SAMPLES):
            c, s, weight = through(x, y, SAMPLE_C[k], SAMPLE_S[k])
            samples[k] = weight * four_turns_polynomial(arm, joints, links, between, c, s)


@apart(
    "void(float64[::1], int64, float64[:, ::1], int64[::1], float64[:, ::1], float64[:, ::1], "
    "float64, float64, float64[::1])"
)
def sample(
    arm: Floats,
    kind: int,
    E: Floats,
    joints: Ints,
    links: Floats,
    between: Floats,
    x: float,
    y: float,
    samples: Floats,
) -> None:
    """Computes a polynomial at the sample angles, through a lens."""
    if kind == DETERMINANT:
        _sample_determinant(arm, E, x, y, samples)
    else:
        _sample_closed_form(arm, joints, links, between, x, y, samples)


@apart("int64(int64, float64[:, ::1], float64[::1], int64)")
def keep_vanishing(kind: int, E: Floats, angles: Floats, count: int) -> int:
    """Keeps the angles where the polynomial may vanish, and returns how many they are.

    Where f only comes near to zero the determinant does not vanish. A closed form has no equations
    behind it that could show more.
    """
    if count == 0 or kind == CLOSED_FORM:
        return count
    c, s, determinant = np.empty(SAMPLES), np.empty(SAMPLES), np.empty(SAMPLES)
    for k in range(SAMPLES):
        angle = angles[min(k, count - 1)]
        c[k], s[k] = math.cos(angle), math.sin(angle)
    factors = fold(E, c, s, determinant)
    vectors, kept = np.empty((5, 6)), 0
    for i in range(count):
        _, regular = null_vectors(factors, i, True, vectors)
        if not regular or not independence(E, c[i], s[i]) > INDEPENDENT:
            angles[kept] = angles[i]
            kept += 1
    return kept


@inner
def _seen(
    samples: Floats, x: float, y: float, middle: int, reach: int, near: float
) -> tuple[float, Floats, Ints]:
    """Returns the noise of samples through a lens, the roots that they show, and their counts."""
    f, scale, noise = fit(samples)
    rounding = scale * (ROUNDING + NOISE_FACTOR * noise)
    roots, counts = find_roots(f, scale, rounding, middle, reach, near)
    without_lens(x, y, roots, counts)
    return noise, roots, counts


@inner
def _any_near(angles: Floats, count: int, x: float, reach: float) -> bool:
    """Whether any of some angles is as near to one as `reach`, the cosine of what is between."""
    near = False
    for i in range(count):
        near = near or math.cos(x - angles[i]) >= reach
    return near


@apart("void(float64[:, ::1], int64[::1], float64[:, ::1], int64[::1], float64)")
def _replace(
    roots: Floats, counts: Ints, closer: Floats, closer_counts: Ints, middle: float
) -> None:
    """Replaces the roots near to an angle by the roots that a closer look shows there."""
    known = np.zeros(2, np.int64)
    for twice in range(2):
        for i in range(counts[twice]):
            if math.cos(roots[twice, i] - middle) < WITHIN_COSINE:
                roots[twice, known[twice]] = roots[twice, i]
                known[twice] += 1
        counts[twice] = known[twice]
    for twice in range(2):
        for i in range(closer_counts[twice]):
            x = closer[twice, i]
            near = math.cos(x - middle)
            is_new = (
                near >= NEAR_COSINE
                and not _any_near(roots[0], known[0], x, ASIDE_COSINE)
                and not _any_near(roots[DOUBLE], known[1], x, ASIDE_COSINE)
            )
            if (near >= WITHIN_COSINE or is_new) and counts[twice] < ROOTS:
                roots[twice, counts[twice]] = x
                counts[twice] += 1


@inner
def _shows_any(roots: Floats, counts: Ints, middle: float) -> bool:
    """Whether any root is within a look."""
    simple = _any_near(roots[0], counts[0], middle, WITHIN_COSINE)
    return simple or _any_near(roots[DOUBLE], counts[DOUBLE], middle, WITHIN_COSINE)


@inner
def _next_double(roots: Floats, counts: Ints, seen: Floats, looks: int) -> int:
    """Returns the first double root without a closer look; their count if there is none."""
    for i in range(counts[DOUBLE]):
        if not _any_near(seen, looks, roots[DOUBLE, i], WITHIN_COSINE):
            return i
    return int(counts[DOUBLE])


@inner
def _take_lifted(kind: int, E: Floats, roots: Floats, counts: Ints) -> None:
    """Adds places where f turns back beside zero to the double roots, where there may be any."""
    for i in range(keep_vanishing(kind, E, roots[LIFTED], counts[LIFTED])):
        add_root(roots, counts, DOUBLE, roots[LIFTED, i])


@inner
def _look_closer(
    arm: Floats,
    kind: int,
    E: Floats,
    joints: Ints,
    links: Floats,
    between: Floats,
    middle: float,
    roots: Floats,
    counts: Ints,
) -> bool:
    """Replaces the roots around an angle by what a closer look shows; whether it shows all."""
    samples = np.empty(SAMPLES)
    x, y = STRENGTH * math.cos(middle), STRENGTH * math.sin(middle)
    sample(arm, kind, E, joints, links, between, x, y, samples)
    turns = middle / TURN
    cell = int(CELLS * (turns - math.floor(turns))) % CELLS
    blur, closer, closer_counts = _seen(samples, x, y, cell, REACH, LIFTED_CLOSER)
    if not (blur <= CLEAR and closer_counts[COMPLETE]):
        return False
    _take_lifted(kind, E, closer, closer_counts)
    _replace(roots, counts, closer, closer_counts, middle)
    return True


@apart(
    "Tuple((boolean, float64[:, ::1], int64[::1]))(float64[::1], int64, float64[:, ::1], "
    "int64[::1], float64[:, ::1], float64[:, ::1])"
)
def real_roots(
    arm: Floats, kind: int, E: Floats, joints: Ints, links: Floats, between: Floats
) -> tuple[bool, Floats, Ints]:
    """Returns whether the polynomial does not vanish identically, its real roots, and their counts.

    Where roots may be double they are replaced by what a closer look shows, if it shows all: values
    that are computed there have the digits that the fit of f lacks. Cells that were given up are
    among them. Behind them come, counts[UNSEEN] of them, places where the closer look shows no
    root: the values lack the digits that the equations behind f lack.
    """
    samples = np.empty(SAMPLES)
    sample(arm, kind, E, joints, links, between, 0.0, 0.0, samples)
    largest = np.abs(samples).max()  # rounding of zero may be as smooth as a polynomial
    x, y = spread(samples)
    if x != 0.0 or y != 0.0:
        sample(arm, kind, E, joints, links, between, x, y, samples)
    noise, roots, counts = _seen(samples, x, y, 0, HALF_CELLS, LIFTED_BY)
    _take_lifted(kind, E, roots, counts)
    good = noise <= NOISE and bool(largest > VANISHING)
    if not good or max(counts[0], counts[1]) == ROOTS:
        return good, roots, counts
    seen, looks, clear = np.empty(LOOKS), 0, True
    unseen, empty = np.empty(LOOKS), 0
    i = _next_double(roots, counts, seen, looks)
    while i < counts[DOUBLE] and looks < LOOKS:
        middle = seen[looks] = roots[DOUBLE, i]
        looks += 1
        if not _look_closer(arm, kind, E, joints, links, between, middle, roots, counts):
            clear = False
        elif not _shows_any(roots, counts, middle):
            unseen[empty] = middle
            empty += 1
        i = _next_double(roots, counts, seen, looks)
    empty = keep_vanishing(kind, E, unseen, empty)
    counts[UNSEEN] = min(empty, ROOTS - counts[DOUBLE])
    for k in range(counts[UNSEEN]):
        roots[DOUBLE, counts[DOUBLE] + k] = unseen[k]
    if clear and i == counts[DOUBLE]:
        counts[COMPLETE] = 1
    if noise > CLEAR:  # f nearly vanishes identically: it does not show what there is not
        counts[COMPLETE] = 0
    return good, roots, counts

# SPDX-License-Identifier: MIT
"""The real roots of a trigonometric polynomial of degree 8, known by its coefficients.

f(phi) = sum of a_m cos m phi + b_m sin m phi, m = 0 ... 8; it is held as a_0 ... a_8, b_1 ... b_8.
The roots are isolated in cells of the circle by bounds, not by changes of sign alone: a pair of
roots inside a cell would be missed otherwise.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..turns import TURN
from .tables import CELLS, DEGREE, GRID_C, GRID_S, HALF_CELLS, HARMONICS, SAMPLES, WIDTH

if TYPE_CHECKING:
    from ..arrays import Floats, Ints

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

ROOTS = 24  # of each kind that are kept: more than 16 come from rounding
DEEPEST = 14  # how often a cell is halved before its roots count as one of higher multiplicity
OPEN_CELLS = DEEPEST + 2
HALVINGS = 100  # in all cells together: f may be next to nothing for long stretches
NEWTON_STEPS = 48  # to a root between two angles, bisections among them
SETTLED = 1e-9  # the step after one of this size [rad] is rounding
# The quintic through f, f', f'' at both ends of a cell misses f by at most
# WIDTH^6 8^6 / 46080 = 1.3e-9 of its largest value.
QUINTIC = 2e-9
# Where four roots meet the bend is next to nothing, too, and rounding of the equations, which no
# harmonic shows, lifts f by up to this part of its largest value.
FOURFOLD = 2e-9
NOTHING, ROUNDING_ONLY, ONE_EXTREMUM, UNKNOWN = range(4)  # what f does in a cell
SIMPLE, DOUBLE, LIFTED = range(3)  # kinds of roots; lifted: f turns back beside zero
COMPLETE, UNSEEN = 3, 4  # counts[COMPLETE]: nothing was given up; counts[UNSEEN]: see roots.py


@inner
def evaluate(f: Floats, x: float) -> tuple[float, float, float]:
    """Returns f, f' and f'' at an angle."""
    value, slope, bend = f[0], 0.0, 0.0
    cosine, sine = math.cos(x), math.sin(x)
    c, s = cosine, sine
    for m in range(1, 9):
        even, odd = f[m] * c + f[8 + m] * s, f[8 + m] * c - f[m] * s
        value += even
        slope += m * odd
        bend -= m * m * even
        c, s = c * cosine - s * sine, s * cosine + c * sine
    return value, slope, bend


@inner
def fit(samples: Floats) -> tuple[Floats, float, float]:
    """Returns the coefficients from 24 samples, the largest sample, and the noise.

    The noise is the largest harmonic beyond the eighth over the largest sample.
    """
    h = np.zeros(SAMPLES)
    scale = 0.0
    for k in range(SAMPLES):
        scale = max(scale, abs(samples[k]))
        for j in range(SAMPLES):
            h[j] += samples[k] * HARMONICS[k, j]
    beyond = 0.0
    for j in range(2 * DEGREE + 1, SAMPLES):
        beyond = max(beyond, abs(h[j]))
    return h, scale, beyond / scale if scale > 0.0 else 1.0


@inner
def _at_edges(f: Floats) -> Floats:
    """Returns f, f', f'', a row each, at the edges of the cells; the first one is also the last."""
    grid = np.empty((3, CELLS + 1))
    value, slope, bend = grid
    for i in range(HALF_CELLS):
        even = uneven = even_slope = uneven_slope = even_bend = uneven_bend = 0.0
        for m in range(1, 9):
            c, s = GRID_C[m - 1, i], GRID_S[m - 1, i]
            along, across = f[m] * c + f[8 + m] * s, f[8 + m] * c - f[m] * s
            if m % 2 == 0:
                even, even_slope = even + along, even_slope + m * across
                even_bend -= m * m * along
            else:
                uneven, uneven_slope = uneven + along, uneven_slope + m * across
                uneven_bend -= m * m * along
        # even multiples are the same half a turn on, odd ones the opposite
        opposite = i + HALF_CELLS
        value[i], value[opposite] = f[0] + even + uneven, f[0] + even - uneven
        slope[i], slope[opposite] = even_slope + uneven_slope, even_slope - uneven_slope
        bend[i], bend[opposite] = even_bend + uneven_bend, even_bend - uneven_bend
    for k in range(3):
        grid[k, CELLS] = grid[k, 0]
    return grid


@inner
def _rootless(grid: Floats, zero: float) -> Floats:
    """Returns in which cells f has no root, as `_kind` does for one: most of them."""
    value, slope, bend = grid
    h, square = WIDTH / 5.0, WIDTH * WIDTH / 20.0
    rootless = np.empty(CELLS)  # truth values of another width would end the vectors
    for i in range(CELLS):
        b0, b5 = value[i], value[i + 1]
        b1, b4 = b0 + h * slope[i], b5 - h * slope[i + 1]
        b2 = b0 + 2.0 * h * slope[i] + square * bend[i]
        b3 = b5 - 2.0 * h * slope[i + 1] + square * bend[i + 1]
        above = (b0 > zero) & (b1 > zero) & (b2 > zero) & (b3 > zero) & (b4 > zero) & (b5 > zero)
        below = (
            (b0 < -zero) & (b1 < -zero) & (b2 < -zero) & (b3 < -zero) & (b4 < -zero) & (b5 < -zero)
        )
        rootless[i] = 1.0 if above | below else 0.0
    return rootless


@inner
def _kind(
    low: Floats, high: Floats, h: float, scale: float, rounding: float, touching: float
) -> int:
    """Returns what f does between two angles.

    NOTHING: it has no root. The Bernstein coefficients of the quintic through f, f', f'' at both
    ends and their differences bound f, f' and f''.
    """
    part = h / WIDTH
    doubt = rounding + scale * QUINTIC * part**6
    b0, b5 = low[0], high[0]
    b1 = b0 + h * low[1] / 5.0
    b2 = b0 + 2.0 * h * low[1] / 5.0 + h * h * low[2] / 20.0
    b3 = b5 - 2.0 * h * high[1] / 5.0 + h * h * high[2] / 20.0
    b4 = b5 - h * high[1] / 5.0
    least, most = min(b0, b1, b2, b3, b4, b5), max(b0, b1, b2, b3, b4, b5)
    zero = max(doubt, touching)
    if least > zero or most < -zero:
        return NOTHING
    if least >= -rounding and most <= rounding:
        return ROUNDING_ONLY
    d0, d1, d2, d3, d4 = b1 - b0, b2 - b1, b3 - b2, b4 - b3, b5 - b4
    if min(d0, d1, d2, d3, d4) > doubt * part or max(d0, d1, d2, d3, d4) < -doubt * part:
        return ONE_EXTREMUM
    e0, e1, e2, e3 = d1 - d0, d2 - d1, d3 - d2, d4 - d3
    bound = doubt * part * part
    one = min(e0, e1, e2, e3) > bound or max(e0, e1, e2, e3) < -bound
    return ONE_EXTREMUM if one else UNKNOWN


@apart("float64(float64[::1], int64, float64, float64, boolean)")
def _between(f: Floats, order: int, low: float, high: float, rising: bool) -> float:
    """Returns where f (order 0) or f' (order 1) vanishes between two angles.

    It has unlike signs there; `rising`: it is negative at the lower one. Newton's method, with
    bisection where it leaves.
    """
    x = 0.5 * (low + high)
    for _ in range(NEWTON_STEPS):
        at = evaluate(f, x)
        value, slope = (at[1], at[2]) if order else (at[0], at[1])
        if (value < 0.0) == rising:
            low = x
        else:
            high = x
        step = -value / slope if slope != 0.0 else high - low
        if not low < x + step < high:
            step = 0.5 * (low + high) - x
        x += step
        if abs(step) < SETTLED:
            break
    return x


@apart("void(float64[:, ::1], int64[::1], int64, float64)")
def add_root(roots: Floats, counts: Ints, kind: int, x: float) -> None:
    """Adds a root of a kind, unless it is a double one of a neighbouring cell."""
    if kind:
        for i in range(counts[kind]):
            gap = abs(x - roots[kind, i])
            if min(gap, TURN - gap) < WIDTH / 64.0:
                return  # neighbouring cells that were given up together
    if counts[kind] == ROOTS:
        counts[COMPLETE] = 0
        return
    roots[kind, counts[kind]] = x
    counts[kind] += 1


@inner
def _few_roots(
    f: Floats,
    rounding: float,
    touching: float,
    near: float,
    low: float,
    at_low: Floats,
    high: float,
    at_high: Floats,
    roots: Floats,
    counts: Ints,
) -> None:
    """Adds the roots of a cell where f has one extremum at most.

    Where f turns back beside zero there is no root, unless rounding of what f is made of lifted it
    off.
    """
    middle, at_middle = high, at_high[0]
    if at_low[1] * at_high[1] < 0.0:
        middle = _between(f, 1, low, high, at_low[1] < 0.0)
        at_middle, _, bend = evaluate(f, middle)
        lifted = at_middle * bend > 0.0 and abs(at_middle) <= max(abs(bend) * near, touching)
        if abs(at_middle) <= rounding or lifted:
            add_root(roots, counts, DOUBLE if abs(at_middle) <= rounding else LIFTED, middle)
            return
        if (at_middle < 0.0) != (at_high[0] < 0.0):
            x = _between(f, 0, middle, high, at_middle < 0.0)
            add_root(roots, counts, SIMPLE, x)
    if (at_low[0] < 0.0) != (at_middle < 0.0):
        add_root(roots, counts, SIMPLE, _between(f, 0, low, middle, at_low[0] < 0.0))


@apart(
    "Tuple((float64[:, ::1], int64[::1]))(float64[::1], float64, float64, int64, int64, float64)"
)
def find_roots(
    f: Floats, scale: float, rounding: float, middle: int, reach: int, near: float
) -> tuple[Floats, Ints]:
    """Returns the roots in so many cells on both sides of the middle one, and their counts.

    roots[kind, : counts[kind]] are those of a kind. f turns back beside zero where the value of a
    parabola over its bend is below `near`. A part that is given up puts both its ends among the
    double roots: a closer look that shows one of them need not reach to the other.
    """
    roots = np.empty((3, ROOTS))
    counts = np.array([0, 0, 0, 1, 0])
    grid = _at_edges(f)
    touching = rounding + scale * FOURFOLD  # by this rounding may lift four roots that meet
    rootless = _rootless(grid, max(rounding + scale * QUINTIC, touching))
    budget = HALVINGS
    edge = np.empty(OPEN_CELLS)  # the upper edges still to come
    at, at_low = np.empty((OPEN_CELLS, 3)), np.empty(3)
    depth = np.zeros(OPEN_CELLS, dtype=np.int64)
    for i in range(CELLS):
        if rootless[i] != 0.0 or min(abs(i - middle), CELLS - abs(i - middle)) > reach:
            continue
        low = i * WIDTH
        edge[0], depth[0] = (i + 1) * WIDTH, 0
        for k in range(3):
            at_low[k], at[0, k] = grid[k, i], grid[k, i + 1]
        waiting = 1
        while waiting > 0:
            top = waiting - 1
            h = edge[top] - low
            kind = _kind(at_low, at[top], h, scale, rounding, touching)
            if kind == ONE_EXTREMUM:
                _few_roots(
                    f, rounding, touching, near, low, at_low, edge[top], at[top], roots, counts
                )
            elif kind == ROUNDING_ONLY or (
                kind == UNKNOWN and (depth[top] == DEEPEST or budget == 0)
            ):
                counts[COMPLETE] = 0
                add_root(roots, counts, DOUBLE, low)
                add_root(roots, counts, DOUBLE, edge[top])
            elif kind == UNKNOWN:
                budget -= 1
                edge[waiting] = low + 0.5 * h
                depth[top] += 1
                depth[waiting] = depth[top]
                at[waiting, 0], at[waiting, 1], at[waiting, 2] = evaluate(f, edge[waiting])
                waiting += 1
                continue
            low = edge[top]
            for k in range(3):
                at_low[k] = at[top, k]
            waiting -= 1
    return roots, counts

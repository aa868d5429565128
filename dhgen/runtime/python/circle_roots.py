# SPDX-License-Identifier: MIT
"""Roots of a trigonometric polynomial of degree two on the circle."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .jit import of_file
from .tolerances import DOUBLE_ROOT, SIMPLE_ROOT
from .turns import TURN

if TYPE_CHECKING:
    from .arrays import Bools, Floats

    Quartic = tuple[float, float, float, float, float]

OWN = of_file(__file__)

DIRECTIONS = 16  # points of the circle where a polynomial is tried
NEWTON_STEPS = 100  # to a root, at most


@OWN.inner
def _horner(p: Quartic, t: float) -> float:
    """The value of a polynomial of degree four."""
    return (((p[4] * t + p[3]) * t + p[2]) * t + p[1]) * t + p[0]


@OWN.inner
def _bracketed_root(p: Quartic, low: float, high: float, at_low: float) -> float:
    """The root between two points with values of unlike sign."""
    t = 0.5 * (low + high)
    for _ in range(NEWTON_STEPS):
        value = _horner(p, t)
        slope = ((4.0 * p[4] * t + 3.0 * p[3]) * t + 2.0 * p[2]) * t + p[1]
        if (value < 0.0) == (at_low < 0.0):
            low = t
        else:
            high = t
        following = t - value / slope if slope != 0.0 else low
        if not low < following < high:
            following = 0.5 * (low + high)
        if abs(following - t) <= 2e-16 * abs(t):
            return following
        t = following
    return t


@OWN.inner
def _monotone_roots(p: Quartic, edges: Floats, count: int, tolerance: float, found: Floats) -> int:
    """Roots, into `found`, of a polynomial that is monotone between neighbouring edges."""
    roots = 0
    before, at_before = edges[0], _horner(p, edges[0])
    for k in range(1, count):
        edge = edges[k]
        value = _horner(p, edge)
        size = 1.0 + edge * edge
        if k < count - 1 and abs(value) <= tolerance * size * size:
            value = 0.0
        if at_before * value < 0.0:
            found[roots] = _bracketed_root(p, before, edge, at_before)
            roots += 1
        elif value == 0.0 and k < count - 1:
            found[roots] = edge
            roots += 1
        before, at_before = edge, value
    return roots


@OWN.inner
def _quartic_roots(p: Quartic, tolerance: float, x: Floats) -> int:
    """Roots of a quartic, into x: they lie between those of its derivative; how many there are.

    Those lie between the roots of the second derivative.
    """
    edges, extrema = np.empty(5), np.empty(4)
    bound = 1.0 + max(abs(p[0]), abs(p[1]), abs(p[2]), abs(p[3]))
    half = 0.25 * p[3]
    square = half * half - p[2] / 6.0
    count = 0
    edges[0] = -bound
    if square > 0.0:
        edges[1], edges[2] = -half - math.sqrt(square), -half + math.sqrt(square)
        count = 2
    edges[count + 1] = bound
    slope = p[1], 2.0 * p[2], 3.0 * p[3], 4.0, 0.0
    count = _monotone_roots(slope, edges, count + 2, 0.0, extrema)
    for k in range(count):
        edges[k + 1] = extrema[k]
    edges[count + 1] = bound
    return _monotone_roots(p, edges, count + 2, tolerance, x)


@OWN.inner
def _farthest_from_zero(a0: float, a1: float, b1: float, a2: float, b2: float) -> float:
    """Where on the circle a polynomial is large."""
    best, apart = -1.0, 0.0
    for k in range(DIRECTIONS):
        at = TURN * k / DIRECTIONS
        c, s = math.cos(at), math.sin(at)
        value = abs(a0 + a1 * c + b1 * s + a2 * (c * c - s * s) + 2.0 * b2 * c * s)
        if value > best:
            best, apart = value, at
    return apart


@OWN.apart(
    "Tuple((float64[::1], boolean[::1]))"
    "(float64, float64, float64, float64, float64, float64, float64)"
)
def circle_roots(
    a0: float, a1: float, b1: float, a2: float, b2: float, rounding: float, moved: float
) -> tuple[Floats, Bools]:
    """Roots, ascending in (-pi, pi], of a0 + a1 cos x + b1 sin x + a2 cos 2x + b2 sin 2x; else NaN.

    Seen from a point where it is large, it is a quartic in the half-angle tangent with a large
    leading coefficient. Second comes which are close, where the slope is small: there may be a
    second root at or near it. Rounding may add so much to values. All roots are moved by an angle
    in the end.
    """
    x, close = np.full(4, math.nan), np.zeros(4, np.bool_)
    size = abs(a0) + abs(a1) + abs(b1) + abs(a2) + abs(b2)
    if not (size > 0.0 and math.isfinite(size)):
        return x, close
    apart = _farthest_from_zero(a0, a1, b1, a2, b2)
    c, s = -math.cos(apart), -math.sin(apart)
    u1, v1 = a1 * c + b1 * s, b1 * c - a1 * s
    c2, s2 = c * c - s * s, 2.0 * c * s
    u2, v2 = a2 * c2 + b2 * s2, b2 * c2 - a2 * s2
    lead = a0 - u1 + u2
    p0, p1 = (a0 + u1 + u2) / lead, 2.0 * (v1 + 2.0 * v2) / lead
    p2, p3 = 2.0 * (a0 - 3.0 * u2) / lead, 2.0 * (v1 - 2.0 * v2) / lead
    tolerance = (DOUBLE_ROOT * size + rounding) / abs(lead)
    for k in range(_quartic_roots((p0, p1, p2, p3, 1.0), tolerance, x)):
        at = apart + 0.5 * TURN + 2.0 * math.atan(x[k])
        c, s = math.cos(at), math.sin(at)
        slope = b1 * c - a1 * s + 2.0 * b2 * (c * c - s * s) - 4.0 * a2 * c * s
        flat = abs(slope) <= SIMPLE_ROOT * size
        if not flat:
            at -= (a0 + a1 * c + b1 * s + a2 * (c * c - s * s) + 2.0 * b2 * c * s) / slope
        at -= TURN * math.ceil(at / TURN - 0.5)
        place = k
        while place > 0 and x[place - 1] > at:
            x[place], close[place] = x[place - 1], close[place - 1]
            place -= 1
        x[place], close[place] = at, flat
    for k in range(4):
        x[k] += moved
    return x, close

"""The real roots of a trigonometric polynomial of degree 2: the meaning of `Roots`.

Seen from a point of the circle where the polynomial is large, the half-angle tangent makes it a
quartic with a large leading coefficient. Its roots lie between the roots of its derivative, those
between the roots of the second derivative, which is a quadratic; each interval is searched by
Newton's method that falls back to bisection. Nothing is missed, and a double root is found as the
root of the derivative that it is.
"""

from __future__ import annotations

import math

from dhgen.tolerances import TOLERANCES

MOST_ROOTS = 4
DIRECTIONS = 16  # where the polynomial is looked at for a large value
NEWTON_STEPS = 100

Circle = tuple[float, float, float, float, float]  # a0, a1, b1, a2, b2


def circle_roots(
    a0: float, a1: float, b1: float, a2: float, b2: float, rounding: float
) -> list[float]:
    """Roots of a0 + a1 cos x + b1 sin x + a2 cos 2x + b2 sin 2x.

    Args:
        a0: Of 1.
        a1: Of cos x.
        b1: Of sin x.
        a2: Of cos 2x.
        b2: Of sin 2x.
        rounding: What rounding may add to values, besides that of the coefficients themselves.

    Returns:
        Four angles in (-pi, pi], ascending; NaN where there are fewer roots. A double root, and two
        that rounding cannot distinguish, are given once.
    """
    size = abs(a0) + abs(a1) + abs(b1) + abs(a2) + abs(b2)
    if not (size > 0.0 and math.isfinite(size)):
        return [math.nan] * MOST_ROOTS
    best, apart = -1.0, 0.0
    for k in range(DIRECTIONS):
        x = 2.0 * math.pi * k / DIRECTIONS
        value = abs(_value(a0, a1, b1, a2, b2, x))
        if value > best:
            best, apart = value, x
    c, s = -math.cos(apart), -math.sin(apart)
    u1, v1 = a1 * c + b1 * s, b1 * c - a1 * s
    c2, s2 = c * c - s * s, 2.0 * c * s
    u2, v2 = a2 * c2 + b2 * s2, b2 * c2 - a2 * s2
    lead = a0 - u1 + u2
    quartic = (
        (a0 + u1 + u2) / lead,
        2.0 * (v1 + 2.0 * v2) / lead,
        2.0 * (a0 - 3.0 * u2) / lead,
        2.0 * (v1 - 2.0 * v2) / lead,
        1.0,
    )
    found = []
    for t in _quartic_roots(quartic, (TOLERANCES.double * size + rounding) / abs(lead)):
        x = apart + math.pi + 2.0 * math.atan(t)
        found.append(_polished(a0, a1, b1, a2, b2, x, size))
    found.sort()
    return found + [math.nan] * (MOST_ROOTS - len(found))


def is_close(coefficients: Circle, x: float) -> bool:
    """Whether a root may be double, or has another beside it: there the slope is small."""
    _, a1, b1, a2, b2 = coefficients
    return abs(_slope(a1, b1, a2, b2, x)) <= TOLERANCES.simple * sum(map(abs, coefficients))


def _value(a0: float, a1: float, b1: float, a2: float, b2: float, x: float) -> float:
    c, s = math.cos(x), math.sin(x)
    return a0 + a1 * c + b1 * s + a2 * (c * c - s * s) + 2.0 * b2 * c * s


def _slope(a1: float, b1: float, a2: float, b2: float, x: float) -> float:
    c, s = math.cos(x), math.sin(x)
    return b1 * c - a1 * s + 2.0 * b2 * (c * c - s * s) - 4.0 * a2 * c * s


def _polished(
    a0: float, a1: float, b1: float, a2: float, b2: float, x: float, size: float
) -> float:
    """One Newton step on the circle itself where the root is simple, then into (-pi, pi]."""
    slope = _slope(a1, b1, a2, b2, x)
    if abs(slope) > TOLERANCES.simple * size:
        x -= _value(a0, a1, b1, a2, b2, x) / slope
    return x - 2.0 * math.pi * math.ceil(x / (2.0 * math.pi) - 0.5)


Quartic = tuple[float, float, float, float, float]  # ascending powers, the last one 1


def _quartic_roots(p: Quartic, tolerance: float) -> list[float]:
    """Real roots; within `tolerance` of zero (as a value on the circle) an extremum is one."""
    bound = 1.0 + max(abs(p[0]), abs(p[1]), abs(p[2]), abs(p[3]))
    first = (p[1], 2.0 * p[2], 3.0 * p[3], 4.0, 0.0)
    second = (2.0 * p[2], 6.0 * p[3], 12.0, 0.0, 0.0)
    edges = [-bound, *_quadratic_roots(second), bound]
    extrema = _between(first, edges, [0.0] * len(edges))
    edges = [-bound, *extrema, bound]
    return _between(p, edges, [tolerance * (1.0 + t * t) ** 2 for t in edges])


def _quadratic_roots(p: Quartic) -> list[float]:
    half = p[1] / (2.0 * p[2])
    square = half * half - p[0] / p[2]
    if square <= 0.0:
        return []
    root = math.sqrt(square)
    return [-half - root, -half + root]


def _between(p: Quartic, edges: list[float], tolerances: list[float]) -> list[float]:
    """Roots of a polynomial that is monotone between neighbouring edges."""
    found = []
    before, at_before = edges[0], _horner(p, edges[0])
    for edge, tolerance in zip(edges[1:], tolerances[1:], strict=True):
        value = _horner(p, edge)
        if edge != edges[-1] and abs(value) <= tolerance:
            value = 0.0
        if at_before * value < 0.0:
            found.append(_bracketed(p, before, edge, at_before))
        elif value == 0.0 and edge != edges[-1]:
            found.append(edge)
        before, at_before = edge, value
    return found


def _horner(p: Quartic, t: float) -> float:
    return (((p[4] * t + p[3]) * t + p[2]) * t + p[1]) * t + p[0]


def _bracketed(p: Quartic, low: float, high: float, at_low: float) -> float:
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

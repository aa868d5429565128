"""A trigonometric polynomial of degree 8 from samples, and its real roots.

f(φ) = Σ a_m cos mφ + b_m sin mφ, m = 0 ... 8. The roots are isolated in cells of the circle by
bounds, not by sign changes alone: a pair of roots inside a cell would be missed otherwise.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from itertools import pairwise
from math import cos, sin
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from dhgen.runtime.python.general.tables import CELLS, DEGREE, SAMPLES, WIDTH, sample_cosines

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray


DEEPEST = 14  # how often a cell is halved before its roots count as one of higher multiplicity
HALVINGS = 100  # in all cells together: f may be next to nothing for long stretches
NEWTON_STEPS = 12
SETTLED = 1e-9  # the step after one of this size [rad] is rounding
SETTLED_EXTREMUM = 1e-7  # the same where f turns, and with it the value there by a parabola

# The quintic through f, f', f'' at both ends of a cell misses f by at most
# WIDTH^6 8^6 / 46080 = 1.3e-9 of its largest value.
QUINTIC = 2e-9
# The Bernstein coefficients of the cubic through f and f' at both ends miss those of the quintic by
# at most WIDTH^4 8^4 / 240 = 6e-6: what they leave out has no root, nor one that is lifted off.
CUBIC = 2e-5
# Rounding of f in its largest value, at least this; more when the harmonics beyond 8 say so. They
# tell little of errors that samples have alike, where four roots meet up to thirty times less.
ROUNDING = 3e-15
NOISE_FACTOR = 64.0
# An extremum beside zero may be a double root that rounding has lifted off, also that of the
# equations behind f, which f does not show: when a complex pair is this near to the circle [rad].
LIFTED = 1e-4
# Where four roots meet the bend is next to nothing, too, and rounding of the equations, which no
# harmonic tells, lifts f by up to this part of its largest value.
FOURFOLD = 2e-9


@dataclass(frozen=True, slots=True)
class Trigonometric:
    """f(φ) = Σ a_m cos mφ + b_m sin mφ.

    Attributes:
        cosine: a_0 ... a_8, (9,).
        sine: b_0 = 0, b_1 ... b_8, (9,).
        scale: The largest sample.
        noise: The harmonics 9 to 11, over `scale`.
    """

    cosine: FloatArray
    sine: FloatArray
    scale: float
    noise: float

    def at(self, cosine: float, sine: float) -> tuple[float, float, float]:
        """f, f' and f'' at the angle with this cosine and sine."""
        value = first = second = 0.0
        c, s = 1.0, 0.0
        for m, (a, b) in enumerate(zip(self.cosine.tolist(), self.sine.tolist(), strict=True)):
            even, odd = a * c + b * s, b * c - a * s
            value += even
            first += m * odd
            second -= m * m * even
            c, s = c * cosine - s * sine, s * cosine + c * sine
        return value, first, second

    @property
    def rounding(self) -> float:
        """How far f may be from what it stands for."""
        return self.scale * (ROUNDING + NOISE_FACTOR * self.noise)

    @property
    def touching(self) -> float:
        """How far an extremum may be lifted from zero for roots to meet there."""
        return self.rounding + self.scale * FOURFOLD


@dataclass(frozen=True, slots=True)
class Window:
    """What part of the circle is searched, and how closely.

    Attributes:
        middle: The cell in its middle.
        reach: How many cells it has on both sides of that one.
        lifted: How near to the circle a complex pair counts as a double root [rad].
    """

    middle: int = 0
    reach: int = CELLS // 2
    lifted: float = LIFTED

    def shows(self, cell: int) -> bool:
        """Whether a cell lies in it."""
        away = abs(cell - self.middle)
        return min(away, CELLS - away) <= self.reach


ALL_AROUND = Window()


@dataclass(frozen=True, slots=True)
class Roots:
    """Real roots of f.

    Attributes:
        simple: Where f changes its sign.
        double: Where f touches zero within its rounding: two roots, or none, or one.
        complete: Whether no cell was left undecided.
        lifted: Where f turns back beside zero: no root, unless rounding of what f is made of has
            lifted it off.
        unseen: Where f comes near to zero and a closer look shows no root. It has the digits of f,
            not those of what f is made of.
    """

    simple: tuple[float, ...]
    double: tuple[float, ...]
    complete: bool
    lifted: tuple[float, ...] = ()
    unseen: tuple[float, ...] = ()


class Kind(Enum):
    """What is known about f in a cell of the circle."""

    ROOTLESS = "no root"
    FLAT = "nothing but rounding"
    TAME = "one extremum at most"
    WILD = "none of these"


def trigonometric(samples: FloatArray) -> Trigonometric:
    """The polynomial from its values (24,) at the sample angles."""
    cosines, sines = sample_cosines()
    values = samples.tolist()
    scale = max(map(abs, values)) or 1.0
    a, b = [], []
    for m in range(DEGREE + 4):
        weight = 1.0 / SAMPLES if m == 0 else 2.0 / SAMPLES
        total_c = total_s = 0.0
        for k, value in enumerate(values):
            total_c += value * cosines[m * k % SAMPLES]
            total_s += value * sines[m * k % SAMPLES]
        a.append(weight * total_c)
        b.append(weight * total_s)
    noise = max(abs(x) for x in a[DEGREE + 1 :] + b[DEGREE + 1 :]) / scale
    return Trigonometric(np.array(a[: DEGREE + 1]), np.array(b[: DEGREE + 1]), scale, noise)


def roots(f: Trigonometric, window: Window = ALL_AROUND) -> Roots:
    """All real roots in a window, in [0, 2π)."""
    some = _Some([], [], [])
    complete = True
    halvings = 0
    edges = [i * WIDTH for i in range(CELLS + 1)]
    values = [f.at(cos(x), sin(x)) for x in edges[:-1]]
    values.append(values[0])
    cells = [
        (edges[i], values[i], edges[i + 1], values[i + 1], 0)
        for i in reversed(range(CELLS))
        if window.shows(i)
    ]
    while cells:
        low, at_low, high, at_high, depth = cells.pop()
        kind = _kind(f, at_low, at_high, high - low)
        if kind is Kind.ROOTLESS:
            continue
        if kind is Kind.TAME:
            ends = (low, at_low), (high, at_high)
            _in_simple_cell(f, ends, window.lifted, some)
        elif kind is Kind.FLAT or depth == DEEPEST or halvings == HALVINGS:
            complete = False
            some.double.append((low + high) / 2)
        else:
            halvings += 1
            middle = (low + high) / 2
            at_middle = f.at(cos(middle), sin(middle))
            cells.append((middle, at_middle, high, at_high, depth + 1))
            cells.append((low, at_low, middle, at_middle, depth + 1))
    double, lifted = (tuple(_merged(angles)) for angles in (some.double, some.lifted))
    return Roots(tuple(some.simple), double, complete, lifted)


Values = tuple[float, float, float]


class _Some(NamedTuple):
    """Roots found so far, as in `Roots`."""

    simple: list[float]
    double: list[float]
    lifted: list[float]


def _kind(f: Trigonometric, low: Values, high: Values, h: float) -> Kind:
    """What is known about f in a cell.

    The Bernstein coefficients of the quintic through f, f', f'' at both ends, their first and
    their second differences bound f, f' and f''.
    """
    f0, d0, s0 = low
    f1, d1, s1 = high
    coefficients = [
        f0,
        f0 + h * d0 / 5,
        f0 + 2 * h * d0 / 5 + h * h * s0 / 20,
        f1 - 2 * h * d1 / 5 + h * h * s1 / 20,
        f1 - h * d1 / 5,
        f1,
    ]
    part = h / WIDTH
    doubt = f.rounding + f.scale * QUINTIC * part**6
    if _of_one_sign(coefficients, max(doubt, f.touching)):
        return Kind.ROOTLESS
    if max(map(abs, coefficients)) <= f.rounding:
        return Kind.FLAT
    first = [b - a for a, b in pairwise(coefficients)]
    second = [b - a for a, b in pairwise(first)]
    if _of_one_sign(first, doubt * part) or _of_one_sign(second, doubt * part**2):
        return Kind.TAME
    return Kind.WILD


def _of_one_sign(numbers: list[float], doubt: float) -> bool:
    return min(numbers) > doubt or max(numbers) < -doubt


def _in_simple_cell(
    f: Trigonometric,
    ends: tuple[tuple[float, Values], tuple[float, Values]],
    near: float,
    some: _Some,
) -> None:
    """The roots of a cell where f has one extremum at most."""
    (low, at_low), (high, at_high) = ends
    if at_low[1] * at_high[1] >= 0:
        if (at_low[0] < 0) != (at_high[0] < 0):
            some.simple.append(_between(f, 0, low, high, at_low))
        return
    x = _between(f, 1, low, high, at_low)
    at = f.at(cos(x), sin(x))
    if abs(at[0]) <= f.rounding:
        some.double.append(x)
        return
    if at[0] * at[2] > 0 and abs(at[0]) <= max(abs(at[2]) * near**2 / 2, f.touching):
        some.lifted.append(x)
        return
    if (at_low[0] < 0) != (at[0] < 0):
        some.simple.append(_between(f, 0, low, x, at_low))
    if (at_high[0] < 0) != (at[0] < 0):
        some.simple.append(_between(f, 0, x, high, at))


def _between(f: Trigonometric, order: int, low: float, high: float, at_low: Values) -> float:
    """Where f (order 0) or f' (order 1) vanishes between two angles at which it has unlike signs.

    By Newton, with bisection where it leaves.
    """
    rising = at_low[order] < 0
    x = (low + high) / 2
    for _ in range(4 * NEWTON_STEPS):
        at = f.at(cos(x), sin(x))
        if (at[order] < 0) == rising:
            low = x
        else:
            high = x
        step = -at[order] / at[order + 1] if at[order + 1] else high - low
        if not low < x + step < high:
            step = (low + high) / 2 - x
        x += step
        if abs(step) < SETTLED:
            break
    return x


def _merged(angles: list[float]) -> list[float]:
    """Neighbouring cells that were given up together are one root."""
    kept: list[float] = []
    for x in sorted(angles):
        if not kept or x - kept[-1] > WIDTH / 64:
            kept.append(x)
    return kept

"""Type 9: two equations linear in the cosines and sines of two angles.

P1 c_i + Q1 s_i + R1 = 0 and P2 c_i + Q2 s_i + R2 = 0, where P, Q and R are at most linear in c_j
and s_j. Solved for c_i and s_i, the sum of their squares is 1: a trigonometric polynomial in
theta_j. It is of degree 2, with at most four roots, in two cases.

P and Q are known. Or the vectors (P, Q) of both equations are one vector, turned and stretched by
what is known: written as complex numbers, (P1 + i Q1) V2 = (P2 + i Q2) V1 with known V1 and V2. The
two equations are then Re(V m) + R = 0 with m = (P1 + i Q1) exp(-i theta_i) / V1, and the size of m
gives |V1|^2 |R1 V2 - R2 V1|^2 = Im(V1 conj V2)^2 (P1^2 + Q1^2) (D. L. Pieper, The kinematics of
manipulators under computer control, 1968: the arm before a spherical wrist, with V2 = i V1). Three
concurrent or parallel axes anywhere in the arm end here.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.step import Kind, Step

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from numpy.typing import NDArray

    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.forms import Form
    from dhgen.paul.step import View

PENALTY = 500
ROOTS = 4
SAME = 1e-9  # of two products that are one by the arm's geometry
FLAT = 1e-6  # of the polynomial's size: a slope this small is that of a double root


Number = tuple["Polynomial", "Polynomial"]  # real and imaginary part
Ratio = tuple[Number, Number]


@dataclass(frozen=True, slots=True)
class Linear:
    """A coefficient as it depends on the angle that stays: one + cosine c_j + sine s_j."""

    one: Polynomial
    cosine: Polynomial
    sine: Polynomial

    @property
    def is_known(self) -> bool:
        """Whether it does not depend on that angle."""
        return not self.cosine and not self.sine

    def is_same(self, other: Linear, sign: int) -> bool:
        """Whether it is the other, times a sign."""
        mine = (self.one, self.cosine, self.sine)
        theirs = (other.one, other.cosine, other.sine)
        return all(a == sign * b for a, b in zip(mine, theirs, strict=True))

    @property
    def letters(self) -> tuple[Polynomial, Polynomial, Polynomial]:
        """The three parts."""
        return self.one, self.cosine, self.sine


@dataclass(frozen=True, slots=True)
class Split:
    """Two equations by the angle that is eliminated (i) and the one that stays (j)."""

    eliminated: AngleSum
    kept: AngleSum
    p: tuple[Linear, Linear]
    q: tuple[Linear, Linear]
    r: tuple[Linear, Linear]

    @property
    def is_known(self) -> bool:
        """Whether P and Q are known."""
        return all(each.is_known for each in (*self.p, *self.q))

    @property
    def turned(self) -> int:
        """+1 or -1 when (P2, Q2) is (-Q1, P1) times that sign, else 0."""
        for sign in (1, -1):
            if self.p[1].is_same(self.q[0], -sign) and self.q[1].is_same(self.p[0], sign):
                return sign
        return 0

    def ratio(self, view: View) -> Ratio | None:
        """V1 and V2 with (P1 + i Q1) V2 = (P2 + i Q2) V1, if there are any that are known."""
        ring = self.p[0].one.ring
        if self.turned:
            return (ring.one, ring.zero), (ring.zero, ring.one * self.turned)
        first, second = (
            list(zip(p.letters, q.letters, strict=True))
            for p, q in zip(self.p, self.q, strict=True)
        )
        pairs = [(x, y) for x, y in zip(first, second, strict=True) if any(x) or any(y)]
        if not pairs or not all(any(x) and any(y) for x, y in pairs):
            return None
        values = [(_complex(x, view), _complex(y, view)) for x, y in pairs]
        sizes = [min(float(np.min(np.abs(v))) for v in pair) for pair in values]
        best = int(np.argmax(sizes))
        one, other = values[best]
        for x, y in values:
            if np.any(np.abs(x * other - y * one) > SAME * np.abs(x * other)):
                return None
        return pairs[best]


class Circle:
    """Type 9, up to four values."""

    name = "type 9"
    arity = 2
    anywhere = True
    ordered = False

    def why_not(self, forms: Sequence[Form], view: View) -> str | None:
        """Why the equations give no polynomial of degree 2."""
        splits = _splits(forms)
        if isinstance(splits, str):
            return splits
        if not any(split.is_known or split.ratio(view) for split in splits):
            return "the polynomial would be of a higher degree than 2"
        return None

    def steps(self, forms: Sequence[Form], view: View) -> Iterator[Step]:
        """A step for each angle that can stay, unless the polynomial has only double roots."""
        splits = _splits(forms)
        if isinstance(splits, str):
            return
        for split in splits:
            ratio = None if split.is_known else split.ratio(view)
            if (split.is_known or ratio) and _is_sound(split, ratio, view):
                yield _step(split, ratio, forms)


def _step(split: Split, ratio: Ratio | None, forms: Sequence[Form]) -> Step:
    letters = tuple(
        (f"{letter}{number}{part}", value)
        for letter, pair in (("P", split.p), ("Q", split.q), ("R", split.r))
        for number, linear in enumerate(pair, start=1)
        for part, value in zip(("", "c", "s"), linear.letters, strict=True)
    )
    if ratio is not None:
        (x1, y1), (x2, y2) = ratio
        letters = (*letters, ("V1x", x1), ("V1y", y1), ("V2x", x2), ("V2y", y2))
    penalty = PENALTY + sum(len(value) for _, value in letters)
    return Step(Kind.CIRCLE, (split.kept,), tuple(forms), letters, ROOTS, penalty)


def _splits(forms: Sequence[Form]) -> list[Split] | str:
    first, second = forms
    if first.unknowns != second.unknowns or len(first.unknowns) != 2:
        return "not the same two unknowns"
    angles = [angle for angle in first.unknowns if isinstance(angle, AngleSum)]
    if len(angles) != 2:
        return "the unknowns are not two angles"
    one, other = angles
    mixed = [(x, y) for x in (one.cosine, one.sine) for y in (other.cosine, other.sine)]
    single = [(name,) for angle in angles for name in (angle.cosine, angle.sine)]
    if not all(form.within([(), *single, *mixed]) for form in forms):
        return "not linear in the cosines and sines of each angle"
    return [_split(forms, one, other), _split(forms, other, one)]


def _split(forms: Sequence[Form], eliminated: AngleSum, kept: AngleSum) -> Split:
    def linear(form: Form, *names: str) -> Linear:
        return Linear(
            form.coefficient(*names),
            form.coefficient(*names, kept.cosine),
            form.coefficient(*names, kept.sine),
        )

    first, second = forms
    return Split(
        eliminated,
        kept,
        (linear(first, eliminated.cosine), linear(second, eliminated.cosine)),
        (linear(first, eliminated.sine), linear(second, eliminated.sine)),
        (linear(first), linear(second)),
    )


def _is_sound(split: Split, ratio: Ratio | None, view: View) -> bool:
    """Whether the true angle is a simple root on every witness."""
    cosine = view.witnesses.evaluate(view.knowledge.runs.algebra.generator(split.kept.cosine))
    sine = view.witnesses.evaluate(view.knowledge.runs.algebra.generator(split.kept.sine))
    parts = [_numeric(linear, view) for linear in (*split.p, *split.q, *split.r)]
    numbers = None if ratio is None else (_complex(ratio[0], view), _complex(ratio[1], view))
    if _says_it_twice(parts, cosine, sine):
        return False
    slopes, sizes = _slope(parts, cosine, sine, numbers)
    return bool(np.all(np.abs(slopes) > FLAT * sizes))


def _values(
    parts: list[Parts], cosine: NDArray[np.float64], sine: NDArray[np.float64]
) -> list[NDArray[np.float64]]:
    """P, Q and R of both equations at an angle that stays."""
    return [one + u * cosine + v * sine for one, u, v in parts]


def _says_it_twice(
    parts: list[Parts], cosine: NDArray[np.float64], sine: NDArray[np.float64]
) -> bool:
    """Whether the second equation is the first again, so that the polynomial is 0 = 0."""
    p1, p2, q1, q2, r1, r2 = _values(parts, cosine, sine)
    products = [(p1 * q2, q1 * p2), (q1 * r2, r1 * q2), (r1 * p2, p1 * r2)]
    return all(bool(np.all(np.abs(a - b) <= SAME * np.abs(a))) for a, b in products)


Parts = tuple["NDArray[np.float64]", "NDArray[np.float64]", "NDArray[np.float64]"]


def _numeric(linear: Linear, view: View) -> Parts:
    one, cosine, sine = (view.witnesses.evaluate(part) for part in linear.letters)
    return one, cosine, sine


def _complex(number: Number, view: View) -> NDArray[np.complex128]:
    real, imaginary = (view.witnesses.evaluate(part) for part in number)
    return np.asarray(real + 1j * imaginary)


def _slope(
    parts: list[Parts],
    cosine: NDArray[np.float64],
    sine: NDArray[np.float64],
    ratio: tuple[NDArray[np.complex128], NDArray[np.complex128]] | None,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The polynomial's derivative at the true angle, and its size, on every witness."""

    def at(turn: float) -> NDArray[np.float64]:
        c = cosine * np.cos(turn) - sine * np.sin(turn)
        s = sine * np.cos(turn) + cosine * np.sin(turn)
        p1, p2, q1, q2, r1, r2 = _values(parts, c, s)
        if ratio is None:
            determinant = p1 * q2 - q1 * p2
            return np.asarray((q1 * r2 - q2 * r1) ** 2 + (r1 * p2 - r2 * p1) ** 2 - determinant**2)
        v1, v2 = ratio
        apart = (v1 * v2.conj()).imag
        return np.asarray(
            np.abs(v1 * (r1 * v2 - r2 * v1)) ** 2 - apart**2 * (p1**2 + q1**2), dtype=np.float64
        )

    step = 1e-4
    sizes = np.max([np.abs(at(turn)) for turn in np.linspace(0.0, 6.0, 13)], axis=0)
    return (at(step) - at(-step)) / (2.0 * step), sizes

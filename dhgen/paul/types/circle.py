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
from functools import cache, reduce
from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from dhgen.paul.common_factor import have_nothing_in_common
from dhgen.paul.form import is_multiple
from dhgen.paul.kind import Kind
from dhgen.paul.step import Step
from dhgen.paul.witness import COUNT, is_rounding

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.algebra import AngleSum
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Form, Monomial
    from dhgen.paul.step import Offer, View

    Complex = NDArray[np.complex128]
    Table = tuple[tuple[Monomial, ...], ...]
    Parts = tuple[Polynomial, Polynomial, Polynomial, Polynomial]

PENALTY = 500
SAME = 1e-9  # of two products that are one by the arm's geometry
FLAT = 1e-11  # of the polynomial's size: a slope this small is that of a double root
TURNS = np.arange(8) * (np.pi / 4.0)  # from the true angle [rad]
SLOPE = (np.sin(TURNS) + 2.0 * np.sin(2.0 * TURNS)) / 4.0  # there, of degree 2, by its values

R, P, Q = range(3)  # rows: without the angle that is eliminated, with c_i, with s_i
ROWS = {"P": P, "Q": Q, "R": R}


@dataclass(frozen=True, slots=True)
class Ratio:
    """V1 and V2 with (P1 + i Q1) V2 = (P2 + i Q2) V1, both known.

    Attributes:
        parts: Real and imaginary part of V1, then of V2.
        values: V1 and V2 on every witness.
    """

    parts: Parts
    values: tuple[Complex, Complex]


@dataclass(frozen=True, slots=True)
class Split:
    """Two equations by the angle that is eliminated (i) and the one that remains (j).

    Attributes:
        forms: The equations.
        kept: The angle that remains.
        monomials: Rows 1, c_i, s_i and columns 1, c_j, s_j.
        values: The coefficients of each equation on every witness: those of 1, c_i and s_i, and
            each by 1, c_j and s_j; shape (3, 3, COUNT).
    """

    forms: tuple[Form, Form]
    kept: AngleSum
    monomials: Table
    values: tuple[FloatArray, FloatArray]

    @property
    def is_known(self) -> bool:
        """Whether P and Q are known."""
        varying = {monomial for row in self.monomials[P:] for monomial in row[1:]}
        return all(varying.isdisjoint(form.terms) for form in self.forms)

    def letters(self, number: int, row: int) -> tuple[Polynomial, ...]:
        """R, P or Q of one of the equations: one + cosine c_j + sine s_j."""
        form = self.forms[number]
        return tuple(form.coefficient(*each) for each in self.monomials[row])

    def ratio(self, view: View) -> Ratio | None:
        """The ratio of the vectors (P, Q) of both equations, if there is one that is known."""
        if turned := self._turned():
            ring, one = self.forms[0].equation.difference.ring, np.ones(COUNT, complex)
            parts = ring.one, ring.zero, ring.zero, ring.one * turned
            return Ratio(parts, (one, 1j * turned * one))
        columns = [place for place in range(3) if self._holds(0, place) or self._holds(1, place)]
        if not columns or not all(self._holds(n, place) for n in (0, 1) for place in columns):
            return None
        first, second = ((each[P] + 1j * each[Q])[columns] for each in self.values)
        best = int(np.argmax(np.minimum(np.abs(first), np.abs(second)).min(axis=1)))
        product = first * second[best]
        if np.any(np.abs(product - second * first[best]) > SAME * np.abs(product)):
            return None
        x1, y1, x2, y2 = (
            self.letters(number, row)[columns[best]] for number in (0, 1) for row in (P, Q)
        )
        return _reduced(Ratio((x1, y1, x2, y2), (first[best], second[best])), view)

    def _turned(self) -> int:
        """+1 or -1 when (P2, Q2) is (-Q1, P1) times that sign, else 0."""
        for sign in (1, -1):
            if self._is_same(P, Q, -sign) and self._is_same(Q, P, sign):
                return sign
        return 0

    def _is_same(self, row: int, other: int, sign: int) -> bool:
        """Whether a row of the second equation is another one of the first, times a sign."""
        first, second = self.forms
        pairs = zip(self.monomials[row], self.monomials[other], strict=True)
        return all(
            is_multiple(second.terms.get(mine, {}), first.terms.get(theirs, {}), sign)
            for mine, theirs in pairs
        )

    def _holds(self, number: int, column: int) -> bool:
        """Whether P or Q of one of the equations has a part in one column."""
        terms = self.forms[number].terms
        return self.monomials[P][column] in terms or self.monomials[Q][column] in terms


def _reduced(ratio: Ratio, view: View) -> Ratio:
    """The ratio without factors that V1 and V2 share: only V2 / V1 counts.

    A common factor that the pose gives would multiply every coefficient of the polynomial, and all
    of them would vanish with it at poses where the arm is regular. It may be a real polynomial, or
    one of V1 and V2 is the complex factor itself.
    """
    if all(part.is_ground for part in ratio.parts):
        return ratio
    x1, y1, x2, y2 = ratio.parts
    one, zero = x1.ring.one, x1.ring.zero
    if second := _quotient(x2, y2, x1, y1):
        parts = one, zero, *second
    elif first := _quotient(x1, y1, x2, y2):
        parts = *first, one, zero
    else:
        parts = _without_common_factor(ratio.parts)
    x1, y1, x2, y2 = parts
    on = view.witnesses.evaluate
    return Ratio(parts, (on(x1) + 1j * on(y1), on(x2) + 1j * on(y2)))


def _quotient(
    x: Polynomial, y: Polynomial, u: Polynomial, v: Polynomial
) -> tuple[Polynomial, Polynomial] | None:
    """(x + i y) / (u + i v) where that is a polynomial: (x + i y)(u - i v) over u^2 + v^2."""
    if not (u or v) or _has_higher_powers((u, v), (x, y)):
        return None
    square = u * u + v * v
    real, rest = (x * u + y * v).div(square)
    imaginary, other = (y * u - x * v).div(square)
    return None if rest or other else (real, imaginary)


def _has_higher_powers(
    divisor: tuple[Polynomial, Polynomial], dividend: tuple[Polynomial, Polynomial]
) -> bool:
    """Whether some letter has a higher power in the divisor: then nothing need be divided."""
    highest = (
        [max(powers) for powers in zip(*(part.degrees() for part in parts), strict=True)]
        for parts in (divisor, dividend)
    )
    return any(power > most for power, most in zip(*highest, strict=True)) and any(dividend)


def _without_common_factor(parts: Parts) -> Parts:
    """Four polynomials without the factor that all of them have in common."""
    if have_nothing_in_common([part for part in parts if part]):
        return parts
    common = reduce(lambda one, other: one.gcd(other), parts)
    x1, y1, x2, y2 = (part if common.is_ground else part.exquo(common) for part in parts)
    return x1, y1, x2, y2


class Circle:
    """Type 9, up to four values."""

    name = "type 9"
    arity = 2
    anywhere = True
    ordered = False

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """A step for each angle that can remain, unless the polynomial has only double roots.

        Or why the equations give no polynomial of degree 2.
        """
        splits = _splits(forms, view)
        if isinstance(splits, str):
            return splits
        ratios = [(split, None if split.is_known else split.ratio(view)) for split in splits]
        able = [(split, ratio) for split, ratio in ratios if split.is_known or ratio]
        if not able:
            return "the polynomial would be of a higher degree than 2"
        return tuple(_step(*each) for each in able if _is_sound(*each, view))


def _step(split: Split, ratio: Ratio | None) -> Step:
    letters = tuple(
        (f"{letter}{number + 1}{part}", value)
        for letter, row in ROWS.items()
        for number in (0, 1)
        for part, value in zip(("", "c", "s"), split.letters(number, row), strict=True)
    )
    if ratio is not None:
        letters = (*letters, *zip(("V1x", "V1y", "V2x", "V2y"), ratio.parts, strict=True))
    penalty = PENALTY + sum(len(value) for _, value in letters)
    return Step(Kind.CIRCLE, (split.kept,), split.forms, letters, penalty)


def _splits(forms: Sequence[Form], view: View) -> list[Split] | str:
    first, second = forms
    if first.unknowns != second.unknowns or len(first.unknowns) != 2:
        return "not the same two unknowns"
    angles = first.two_angles
    if angles is None:
        return "the unknowns are not two angles"
    table = _monomials(*angles)
    places = {monomial: place for place, monomial in enumerate(chain(*table))}
    if not all(form.terms.keys() <= places.keys() for form in forms):
        return "not linear in the cosines and sines of each angle"
    one, other = (_on_witnesses(form, places, view) for form in forms)
    turned = tuple(zip(*table, strict=True))
    swapped = one.swapaxes(0, 1), other.swapaxes(0, 1)
    return [
        Split((first, second), angles[1], table, (one, other)),
        Split((first, second), angles[0], turned, swapped),
    ]


@cache
def _monomials(eliminated: AngleSum, kept: AngleSum) -> Table:
    """In the spelling of forms."""
    i, j = (((), (angle.cosine,), (angle.sine,)) for angle in (eliminated, kept))
    return tuple(tuple(tuple(sorted((*x, *y))) for y in j) for x in i)


def _on_witnesses(form: Form, places: dict[Monomial, int], view: View) -> FloatArray:
    """The coefficients; one that is nothing by the arm's geometry is 0 here, not its rounding."""
    rows: list[Sequence[float]] = [(0.0,) * COUNT] * len(places)
    for monomial, polynomial in form.terms.items():
        values, sizes = view.witnesses.samples.numbers(polynomial)
        pairs = zip(values, sizes, strict=True)
        rows[places[monomial]] = [0.0 if is_rounding(*pair) else pair[0] for pair in pairs]
    return np.array(rows).reshape(3, 3, COUNT)


def _is_sound(split: Split, ratio: Ratio | None, view: View) -> bool:
    """Whether the true angle is a simple root on every witness."""
    generator, on = view.knowledge.runs.algebra.generator, view.witnesses.evaluate
    cosine, sine = on(generator(split.kept.cosine)), on(generator(split.kept.sine))
    c = np.outer(np.cos(TURNS), cosine) - np.outer(np.sin(TURNS), sine)
    s = np.outer(np.cos(TURNS), sine) + np.outer(np.sin(TURNS), cosine)
    first, second = (
        each[:, 0, None] + each[:, 1, None] * c + each[:, 2, None] * s for each in split.values
    )
    if _are_equal_equations(first[:, 0], second[:, 0]):
        return False
    values, sizes = polynomial(first, second, ratio)
    largest = np.max(np.abs(values), axis=0)
    if np.any(largest <= SAME * np.max(sizes, axis=0)):
        return False  # 0 = 0: what is left of it is rounding
    return bool(np.all(np.abs(SLOPE @ values) > FLAT * largest))


def _are_equal_equations(first: FloatArray, second: FloatArray) -> bool:
    """Whether the second equation is the first again, so that the polynomial is 0 = 0.

    Args:
        first: R, P and Q of the first equation at the true angle, on every witness.
        second: The same of the second.
    """
    following = [1, 2, 0]
    one, other = first * second[following], first[following] * second
    return bool(np.all(np.abs(one - other) <= SAME * np.abs(one)))


def polynomial(
    first: FloatArray, second: FloatArray, ratio: Ratio | None
) -> tuple[FloatArray, FloatArray]:
    """The polynomial in the angle that remains, and the sum of the sizes of its two sides.

    Args:
        first: R, P and Q of the first equation at every turn and on every witness.
        second: The same of the second.
        ratio: Of their vectors (P, Q), where these are not known.
    """
    (r1, p1, q1), (r2, p2, q2) = first, second
    if ratio is None:
        left = (q1 * r2 - q2 * r1) ** 2 + (r1 * p2 - r2 * p1) ** 2
        right = (p1 * q2 - q1 * p2) ** 2
        return left - right, left + right
    v1, v2 = ratio.values
    apart = (v1 * v2.conj()).imag
    left = np.abs(v1 * (r1 * v2 - r2 * v1)) ** 2
    right = apart**2 * (p1**2 + q1**2)
    return left - right, left + right

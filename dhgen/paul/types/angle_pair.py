"""Type 3: X1 s + Y1 c = Z1, X2 s + Y2 c = Z2 (document 002: its type 4 when X1 = Y2 = 1)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.ring import constant_value
from dhgen.paul.kind import Kind
from dhgen.paul.step import NEARLY_NOTHING, NOTHING, Step, placing
from dhgen.paul.witness import OWN_LENGTHS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.algebra import Algebra, AngleSum
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Form
    from dhgen.paul.step import Offer, Products, View

CONSTANT_FACTORS = 10
CONSTANT_DETERMINANT = 20
TRIANGLE = 30  # the determinant is a distance that only an arm with equal links can fold to zero
SHORT_LENGTHS = 20  # an equation of directions is longer, and good to more digits
MIRRORED = 1  # Cramer's rule reads best with a positive determinant
MAY_VANISH = 300  # both equations may vanish although a third one would decide

MAY_VANISH_REASON = "the determinant X1 Y2 - X2 Y1 may vanish where the angle is not free"


class AnglePair:
    """Type 3, one value.

    Taken only when the determinant is a constant, or a constant times a sum of two squares (X2, Y2
    is X1, Y1 turned by a right angle and stretched): then it can vanish only where the angle is
    really free.
    """

    name = "type 3"
    arity = 2
    anywhere = False
    ordered = True

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """One step, or why the equations are not two equations in one angle."""
        read = _read(forms)
        if isinstance(read, str):
            return read
        determinant = read.determinant(view)
        if view.witnesses.sum_vanishes(determinant.terms):
            return "the determinant X1 Y2 - X2 Y1 vanishes"
        if not (read.is_turned(view) or view.is_constant_sum(determinant)):
            return MAY_VANISH_REASON
        first, second = forms
        z1, z2 = -first.coefficient(), -second.coefficient()
        letters = (
            ("X1", read.x1),
            ("Y1", read.y1),
            ("Z1", z1),
            ("X2", read.x2),
            ("Y2", read.y2),
            ("Z2", z2),
        )
        length = sum(len(value) for _, value in letters)
        penalty = _conditioning(read, view) + length + placing(first)
        return (Step(Kind.ANGLE_PAIR, (read.angle,), (first, second), letters, penalty),)


def stretch(x1: Polynomial, y1: Polynomial, x2: Polynomial, y2: Polynomial) -> Polynomial | None:
    """The k with (X2, Y2) = k (-Y1, X1), if there is one: the determinant is k (X1^2 + Y1^2)."""
    mine, theirs = (y2, x1) if x1 else (-x2, y1)
    if not theirs:
        return None
    factor, rest = divmod(mine, theirs)
    return None if rest or (x2, y2) != (-factor * y1, factor * x1) else factor


def link_lengths(
    algebra: Algebra, earlier: Sequence[Step], step: Step
) -> tuple[float, float] | None:
    """How long two links are, where the equations of a step gave the angle between them before.

    X1^2 + Y1^2 is the squared distance that they span then, as Z1^2 + Z2^2 is.
    """
    own = {form.equation for form in step.forms}
    for each in earlier:
        if not each.kind.is_two_links or {form.equation for form in each.forms} != own:
            continue
        vectors = [[each.coefficient(name + part) for part in "12"] for name in "VW"]
        if not all(algebra.is_constant(part) for parts in vectors for part in parts):
            return None
        first, second = (
            math.hypot(*(constant_value(algebra, part) for part in parts)) for parts in vectors
        )
        return first, second
    return None


@dataclass(frozen=True, slots=True)
class _Factors:
    """The coefficients of sine and cosine in the two equations."""

    angle: AngleSum
    x1: Polynomial
    y1: Polynomial
    x2: Polynomial
    y2: Polynomial

    def determinant(self, view: View) -> Products:
        """X1 Y2 - X2 Y1."""
        return view.products((1, self.x1, self.y2), (-1, self.x2, self.y1))

    def is_turned(self, view: View) -> bool:
        """Whether (X2, Y2) is (X1, Y1) turned by a right angle, times a constant."""
        across = (1, self.x1, self.x2), (1, self.y1, self.y2)
        if not view.witnesses.sum_vanishes_always(across):
            return False
        factor = stretch(self.x1, self.y1, self.x2, self.y2)
        return factor is not None and view.is_constant(factor)


def _read(forms: Sequence[Form]) -> _Factors | str:
    """The factors, or why the equations have another shape."""
    first, second = forms
    if first.unknowns != second.unknowns or len(first.unknowns) != 1:
        return "not the same single unknown"
    angle = first.only_angle
    if angle is None:
        return "the unknown is not an angle"
    linear = [(), (angle.cosine,), (angle.sine,)]
    if not (first.within(linear) and second.within(linear)):
        return "not linear in the cosine and sine"
    return _Factors(
        angle,
        x1=first.coefficient(angle.sine),
        y1=first.coefficient(angle.cosine),
        x2=second.coefficient(angle.sine),
        y2=second.coefficient(angle.cosine),
    )


def _conditioning(factors: _Factors, view: View) -> int:
    rows = (factors.x1, factors.y1), (factors.x2, factors.y2)
    penalty = NEARLY_NOTHING if any(view.is_nearly_nothing(*row) for row in rows) else 0
    penalty += SHORT_LENGTHS * sum(view.is_short(*row) for row in rows)
    if not view.is_constant_sum(factors.determinant(view)):  # it is a sum of two squares then
        apart = view.witnesses.have_no_common_zero(factors.x1, factors.y1)
        mirrored = MIRRORED if factors.x2 == factors.y1 else 0
        return penalty + (TRIANGLE if apart else MAY_VANISH) + mirrored
    simple = all(view.is_constant(entry) for row in rows for entry in row)
    penalty = penalty or (NEARLY_NOTHING if _are_nearly_parallel(rows, view) else 0)
    return penalty + (CONSTANT_FACTORS if simple else CONSTANT_DETERMINANT)


def _are_nearly_parallel(rows: Sequence[tuple[Polynomial, Polynomial]], view: View) -> bool:
    """Whether (X1, Y1) and (X2, Y2) are nearly parallel, with the arm's own lengths."""
    entries = [entry for row in rows for entry in row]
    x1, y1, x2, y2 = (view.witnesses.evaluate(entry)[OWN_LENGTHS] for entry in entries)
    sines = (x1 * y2 - x2 * y1) / (np.hypot(x1, y1) * np.hypot(x2, y2))
    return bool(np.max(np.abs(sines)) < NOTHING)

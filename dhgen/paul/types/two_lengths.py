"""Type 11: X1 r_i + Y1 r_j = Z1, X2 r_i + Y2 r_j = Z2.

Three slides with turning joints between them are coupled: once all angles are known, the elements
of U_i that a slide along z does not move hold the two others.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.step import NEARLY_NOTHING, Kind, Step

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Form, Length
    from dhgen.paul.step import Offer, View

CONSTANT_DETERMINANT = 20
VARIABLE_DETERMINANT = 800  # it may vanish: only when nothing else works


class TwoLengths:
    """Type 11, one value of each length, by Cramer's rule."""

    name = "type 11"
    arity = 2
    anywhere = True
    ordered = False

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """One step for both lengths, or why the equations are not linear in them, or fix none."""
        lengths = forms[0].two_lengths
        if lengths is None or forms[1].two_lengths != lengths:
            return "the unknowns are not two lengths"
        linear = [(), *((length.name,) for length in lengths)]
        if not all(form.within(linear) for form in forms):
            return "a length occurs in a higher power"
        product = view.products(*_products(forms, lengths))
        if view.witnesses.sum_vanishes(product.terms):
            return "the determinant vanishes"
        fixed = view.is_constant_sum(product)
        penalty = CONSTANT_DETERMINANT if fixed else VARIABLE_DETERMINANT
        penalty += NEARLY_NOTHING if view.is_nearly_nothing(product.polynomial) else 0
        letters = tuple(
            (f"{letter}{number}", value)
            for number, form in enumerate(forms, start=1)
            for letter, value in zip("XYZ", _row(form, lengths), strict=True)
        )
        size = sum(len(value) for _, value in letters)
        return (Step(Kind.TWO_LENGTHS, lengths, tuple(forms), letters, 1, penalty + size),)


def determinant(step: Step, algebra: Algebra) -> Polynomial:
    """X1 Y2 - X2 Y1 of a step of this type."""
    x1, y1, x2, y2 = (step.coefficient(letter) for letter in ("X1", "Y1", "X2", "Y2"))
    return algebra.normal(x1 * y2 - x2 * y1)


def _row(form: Form, lengths: tuple[Length, Length]) -> tuple[Polynomial, Polynomial, Polynomial]:
    first, second = lengths
    return form.coefficient(first.name), form.coefficient(second.name), -form.coefficient()


def _products(
    forms: Sequence[Form], lengths: tuple[Length, Length]
) -> tuple[tuple[int, Polynomial, Polynomial], ...]:
    (x1, y1, _), (x2, y2, _) = (_row(form, lengths) for form in forms)
    return (1, x1, y2), (-1, x2, y1)

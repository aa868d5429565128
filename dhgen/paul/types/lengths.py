"""Types 1, 10 and 11: a length by itself, by its square, and two lengths by two equations.

Type 1 is X r = Y. Type 10 is X r^2 + Y r = Z, the distance of a point on a slide from another; of
two lengths, one of which is linear in the other, a line is put into a squared length: with a slide
before a turn and one behind it that are oblique to its axis, what does not depend on the turn is
the place along the axis, linear in both lengths, and the squared distance from a point of it. Type
11 is X1 r_i + Y1 r_j = Z1, X2 r_i + Y2 r_j = Z2: three slides with turning joints between them are
coupled, and once all angles are known, the elements of U_i that a slide along z does not move hold
the two others.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.kind import Kind
from dhgen.paul.step import NEARLY_NOTHING, Step

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Form, Length
    from dhgen.paul.step import Offer, View


CONSTANT_DIVISOR = 10
VARIABLE_DIVISOR = 400  # X may vanish: only when nothing else works


class SingleLength:
    """Type 1, one value: r = Y / X."""

    name = "type 1"
    arity = 1
    anywhere = False
    ordered = True

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """One step, or why the equation is not X r = Y."""
        (form,) = forms
        length = form.only_length
        if length is None:
            return "the unknown is not a single length"
        if not form.within([(), (length.name,)]):
            return f"{length.name} occurs in a higher power"
        x, y = form.coefficient(length.name), -form.coefficient()
        if view.witnesses.vanishes(x):
            return f"the factor of {length.name} vanishes"
        penalty = CONSTANT_DIVISOR if view.is_constant(x) else VARIABLE_DIVISOR
        penalty += NEARLY_NOTHING if view.is_nearly_nothing(x) else 0
        letters = (("X", x), ("Y", y))
        return (Step(Kind.LENGTH, (length,), (form,), letters, penalty + len(y)),)


SQUARED = 150


class SquaredLength:
    """Type 10, two values: r = -Y/2X + e sqrt((Y/2X)^2 + Z/X).

    It holds less than the equations of types 4 and 5, whose squares it adds up, but also where axes
    beside the slide are at no right angle.
    """

    name = "type 10"
    arity = 1
    anywhere = False
    ordered = True

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """One step, or why the equation is not X r^2 + Y r = Z."""
        (form,) = forms
        length = form.only_length
        if length is None:
            return "the unknown is not a single length"
        r = length.name
        if not form.within([(), (r,), (r, r)]):
            return f"{r} occurs in a higher power than its square"
        x, y, z = form.coefficient(r, r), form.coefficient(r), -form.coefficient()
        if not (view.is_constant(x) and view.is_constant(y)):
            return "X or Y may vanish"
        if view.witnesses.vanishes(x):
            return "X vanishes"
        letters = (("X", x), ("Y", y), ("Z", z))
        return (Step(Kind.SQUARED_LENGTH, (length,), (form,), letters, SQUARED),)


ON_A_LINE = 200


class LengthOnALine:
    """One or two values of one length; the other follows from the line, by type 1."""

    name = "type 10 of two lengths"
    arity = 2
    anywhere = True
    ordered = True

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """A step for each length that can remain: of type 1 if the squares cancel.

        Or why the equations are not a line and a squared length in two lengths.
        """
        line, square = forms
        lengths = line.two_lengths
        if lengths is None or square.two_lengths != lengths:
            return "the unknowns are not two lengths"
        first, second = (length.name for length in lengths)
        if not line.within([(), (first,), (second,)]):
            return "the first equation is not linear"
        pairs = [(first, first), (second, second), (first, second)]
        linear = [(), (first,), (second,)]
        if square.within(linear) or not square.within([*linear, *pairs]):
            return "the second equation is not quadratic"
        return tuple(_steps(forms, lengths, view)) or "X or V may vanish"


def _steps(forms: Sequence[Form], lengths: tuple[Length, Length], view: View) -> Iterator[Step]:
    for gone, kept in (lengths, lengths[::-1]):
        v = forms[0].coefficient(gone.name)
        if not view.is_constant(v) or view.witnesses.vanishes(v):
            continue
        x, y, z = map(view.normal, _quadratic(forms, gone, kept))
        size = ON_A_LINE + len(x) + len(y) + len(z)
        if not x and not view.witnesses.vanishes(y):
            linear = (("X", y), ("Y", z))
            yield Step(Kind.LENGTH, (kept,), tuple(forms), linear, size)
        elif view.is_constant(x) and not view.witnesses.vanishes(x):
            letters = (("X", x), ("Y", y), ("Z", z))
            yield Step(Kind.SQUARED_LENGTH, (kept,), tuple(forms), letters, size)


def _quadratic(forms: Sequence[Form], gone: Length, kept: Length) -> tuple[Polynomial, ...]:
    """X, Y and Z of X r^2 + Y r = Z: the squared length, times V^2, with V s = Z - W r."""
    line, square = forms
    s, r = gone.name, kept.name
    v, w, z = line.coefficient(s), line.coefficient(r), -line.coefficient()
    ss, rr, sr = square.coefficient(s, s), square.coefficient(r, r), square.coefficient(s, r)
    one, two, rest = square.coefficient(s), square.coefficient(r), square.coefficient()
    return (
        ss * w**2 - sr * v * w + rr * v**2,
        sr * v * z - 2 * ss * w * z - one * v * w + two * v**2,
        -(ss * z**2 + one * v * z + rest * v**2),
    )


def line_of(step: Step) -> tuple[Length, tuple[Polynomial, Polynomial, Polynomial]]:
    """The other length of such a step, s, and V, W and Z of the line V s + W r = Z."""
    line = step.forms[0]
    lengths = line.two_lengths
    assert lengths is not None
    gone, kept = lengths if lengths[1] in step.unknowns else lengths[::-1]
    return gone, (line.coefficient(gone.name), line.coefficient(kept.name), -line.coefficient())


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
        return (Step(Kind.TWO_LENGTHS, lengths, tuple(forms), letters, penalty + size),)


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

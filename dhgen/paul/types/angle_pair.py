"""Type 3: X1 s + Y1 c = Z1, X2 s + Y2 c = Z2 (document 002: its type 4 when X1 = Y2 = 1)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.step import Kind, Step, placing

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.forms import Form
    from dhgen.paul.step import View


TRIANGLE = 30  # the determinant is a distance that only an arm with equal links can fold to zero
MAY_VANISH = 300  # both equations may vanish although a third one would decide


class AnglePair:
    """Type 3, one value.

    Taken only when the determinant is a constant, or a sum of two squares (X2, Y2 is X1, Y1 turned by
    a right angle): then it can vanish only where the angle is really free.
    """

    name = "type 3"
    arity = 2

    def why_not(self, forms: Sequence[Form], view: View) -> str | None:
        """Why the equations are not two equations in one angle."""
        first, second = forms
        if first.unknowns != second.unknowns or len(first.unknowns) != 1:
            return "not the same single unknown"
        angle = first.unknowns[0]
        if not isinstance(angle, AngleSum):
            return "the unknown is not an angle"
        linear = [(), (angle.cosine,), (angle.sine,)]
        if not (first.within(linear) and second.within(linear)):
            return "not linear in the cosine and sine"
        x1, y1, x2, y2 = _factors(first, second, angle)
        determinant = view.knowledge.runs.algebra.normal(x1 * y2 - y1 * x2)
        if view.witnesses.vanishes(determinant):
            return "the determinant X1 Y2 - X2 Y1 vanishes"
        if not (view.is_constant(determinant) or _turned(x1, y1, x2, y2)):
            return "the determinant X1 Y2 - X2 Y1 may vanish where the angle is not free"
        return None

    def steps(self, forms: Sequence[Form], view: View) -> Iterator[Step]:
        """One step."""
        first, second = forms
        angle = first.unknowns[0]
        assert isinstance(angle, AngleSum)
        x1, y1, x2, y2 = _factors(first, second, angle)
        z1, z2 = -first.coefficient(), -second.coefficient()
        letters = (("X1", x1), ("Y1", y1), ("Z1", z1), ("X2", x2), ("Y2", y2), ("Z2", z2))
        length = sum(len(value) for _, value in letters)
        simple = all(view.is_constant(value) for value in (x1, y1, x2, y2))
        determinant = view.knowledge.runs.algebra.normal(x1 * y2 - y1 * x2)
        if view.is_constant(determinant):
            penalty = 10 if simple else 20
        else:
            penalty = TRIANGLE if view.witnesses.stays_positive(determinant) else MAY_VANISH
        penalty += length + placing(first)
        yield Step(Kind.ANGLE_PAIR, (angle,), (first, second), letters, 1, penalty)


def _factors(
    first: Form, second: Form, angle: AngleSum
) -> tuple[Polynomial, Polynomial, Polynomial, Polynomial]:
    return (
        first.coefficient(angle.sine),
        first.coefficient(angle.cosine),
        second.coefficient(angle.sine),
        second.coefficient(angle.cosine),
    )


def _turned(x1: Polynomial, y1: Polynomial, x2: Polynomial, y2: Polynomial) -> bool:
    return (x2, y2) in ((-y1, x1), (y1, -x1))

"""Type 2: X s + Y c = Z (document 002: its type 2, and its type 1 when Z = 0)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.kind import Kind
from dhgen.paul.step import NEARLY_NOTHING, Step, placing

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.paul.form import Form
    from dhgen.paul.step import Offer, View

HOMOGENEOUS = 40  # Z = 0: always solvable, accurate everywhere
GENERAL = 80
SUM = 30  # where it degenerates, the seed's value for a joint is clearer than for a sum
SQUARED = 60  # a squared distance loses digits when the arm is nearly folded
CANCELLING = 50  # X^2 + Y^2 - Z^2 loses digits that (X - Z) (X + Z) keeps when both are small
CONSTANT_FACTORS = 250  # c = Z alone loses half the digits near the ends of its range


class Angle:
    """Type 2, two values: s = (X Z + e Y w) / (X^2 + Y^2), w^2 = X^2 + Y^2 - Z^2."""

    name = "type 2"
    arity = 1
    anywhere = False
    ordered = True

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """One step, or why the equation is not X s + Y c = Z with X and Y that matter."""
        (form,) = forms
        angle = form.only_angle
        if angle is None:
            return "the unknown is not a single angle"
        if not form.within([(), (angle.cosine,), (angle.sine,)]):
            return "not linear in the cosine and sine"
        x, y, z = form.coefficient(angle.sine), form.coefficient(angle.cosine), -form.coefficient()
        if view.witnesses.vanishes(x) and view.witnesses.vanishes(y):
            return "X and Y vanish on every solution: the equation determines nothing"
        joints = len(view.knowledge.representative(angle).terms)
        if not z:
            penalty = HOMOGENEOUS + placing(form)
        elif view.is_constant(x) and view.is_constant(y):
            penalty = CONSTANT_FACTORS  # of a point that the pose gives Z is its coordinate
        else:
            penalty = GENERAL + placing(form)
        penalty += len(x) + len(y) + len(z) + SUM * (joints - 1)
        penalty += SQUARED if form.equation.origin.row == 0 else 0
        penalty += CANCELLING if x and y and z else 0
        penalty += NEARLY_NOTHING if view.is_nearly_nothing(x, y) else 0
        letters = (("X", x), ("Y", y), ("Z", z))
        return (Step(Kind.ANGLE, (angle,), (form,), letters, penalty),)

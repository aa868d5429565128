"""Type 5: X1 s = Y1 + Z1 r, X2 c = Y2 + Z2 r."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.forms import Length
from dhgen.paul.step import Kind, Step

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.paul.forms import Form
    from dhgen.paul.step import View

PENALTY = 60


class AngleAndLength:
    """Type 5, two values: with V = Y/X and W = Z/X, (V1 + W1 r)^2 + (V2 + W2 r)^2 = 1."""

    name = "type 5"
    arity = 2

    def why_not(self, forms: Sequence[Form], view: View) -> str | None:
        """Why the equations are not X1 s = Y1 + Z1 r, X2 c = Y2 + Z2 r."""
        sines, cosines = forms
        if sines.unknowns != cosines.unknowns and not (
            {*sines.unknowns} | {*cosines.unknowns} == {*(sines.unknowns or cosines.unknowns)}
        ):
            return "not the same two unknowns"
        if len(sines.unknowns) != 2 or sines.unknowns != cosines.unknowns:
            return "not the same two unknowns"
        angle, length = sines.unknowns
        if not (isinstance(angle, AngleSum) and isinstance(length, Length)):
            return "the unknowns are not an angle and a length"
        if not sines.within([(), (angle.sine,), (length.name,)]):
            return "the first equation is not X1 s = Y1 + Z1 r"
        if not cosines.within([(), (angle.cosine,), (length.name,)]):
            return "the second equation is not X2 c = Y2 + Z2 r"
        x1, x2 = sines.coefficient(angle.sine), cosines.coefficient(angle.cosine)
        if not (view.is_constant(x1) and view.is_constant(x2)):
            return "X1 or X2 may vanish"
        factors = (sines.coefficient(length.name), cosines.coefficient(length.name))
        if not all(view.is_constant(factor) for factor in factors):
            return "Z1 and Z2 may vanish together"
        return None

    def steps(self, forms: Sequence[Form], view: View) -> Iterator[Step]:
        """One step for both unknowns."""
        del view
        sines, cosines = forms
        angle, length = sines.unknowns
        assert isinstance(angle, AngleSum)
        assert isinstance(length, Length)
        letters = (
            ("X1", sines.coefficient(angle.sine)),
            ("Y1", -sines.coefficient()),
            ("Z1", -sines.coefficient(length.name)),
            ("X2", cosines.coefficient(angle.cosine)),
            ("Y2", -cosines.coefficient()),
            ("Z2", -cosines.coefficient(length.name)),
        )
        yield Step(Kind.ANGLE_AND_LENGTH, (angle, length), (sines, cosines), letters, 2, PENALTY)

"""Type 4: X1 r s = Y1, X2 r c = Y2."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.forms import Length
from dhgen.paul.step import Kind, Step

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.paul.forms import Form
    from dhgen.paul.step import View

PENALTY = 50


class Polar:
    """Type 4, two values: r = e sqrt((Y1/X1)^2 + (Y2/X2)^2), and the angle that goes with it."""

    name = "type 4"
    arity = 2

    def why_not(self, forms: Sequence[Form], view: View) -> str | None:
        """Why the equations are not a vector in polar coordinates."""
        sines, cosines = forms
        if sines.unknowns != cosines.unknowns or len(sines.unknowns) != 2:
            return "not the same two unknowns"
        angle, length = sines.unknowns
        if not (isinstance(angle, AngleSum) and isinstance(length, Length)):
            return "the unknowns are not an angle and a length"
        if not sines.within([(), (length.name, angle.sine)]):
            return "the first equation is not X1 r s = Y1"
        if not cosines.within([(), (length.name, angle.cosine)]):
            return "the second equation is not X2 r c = Y2"
        x1 = sines.coefficient(length.name, angle.sine)
        x2 = cosines.coefficient(length.name, angle.cosine)
        if not (view.is_constant(x1) and view.is_constant(x2)):
            return "X1 or X2 may vanish"
        return None

    def steps(self, forms: Sequence[Form], view: View) -> Iterator[Step]:
        """One step for both unknowns."""
        del view
        sines, cosines = forms
        angle, length = sines.unknowns
        assert isinstance(angle, AngleSum)
        assert isinstance(length, Length)
        letters = (
            ("X1", sines.coefficient(length.name, angle.sine)),
            ("Y1", -sines.coefficient()),
            ("X2", cosines.coefficient(length.name, angle.cosine)),
            ("Y2", -cosines.coefficient()),
        )
        yield Step(Kind.POLAR, (angle, length), (sines, cosines), letters, 2, PENALTY)

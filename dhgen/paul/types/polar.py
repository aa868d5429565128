"""Type 4: X1 r s = Y1, X2 r c = Y2."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.paul.form import common_angle_and_length
from dhgen.paul.step import NEARLY_NOTHING, Kind, Step

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.algebra import AngleSum
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Form, Length
    from dhgen.paul.step import Offer, View

PENALTY = 50


class Polar:
    """Type 4, two values: r = e sqrt((Y1/X1)^2 + (Y2/X2)^2), and the angle that goes with it."""

    name = "type 4"
    arity = 2
    anywhere = False
    ordered = True

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """One step for both unknowns, or why the equations are no vector in polar coordinates."""
        read = _read(forms)
        if isinstance(read, str):
            return read
        if not (view.is_constant(read.x1) and view.is_constant(read.x2)):
            return "X1 or X2 may vanish"
        unknowns = (read.angle, read.length)
        letters = (("X1", read.x1), ("Y1", read.y1), ("X2", read.x2), ("Y2", read.y2))
        little = any(view.is_nearly_nothing(each) for each in (read.x1, read.x2))
        penalty = PENALTY + (NEARLY_NOTHING if little else 0)
        return (Step(Kind.POLAR, unknowns, tuple(forms), letters, 2, penalty),)


@dataclass(frozen=True, slots=True)
class _Letters:
    """The equations in the type's letters."""

    angle: AngleSum
    length: Length
    x1: Polynomial
    y1: Polynomial
    x2: Polynomial
    y2: Polynomial


def _read(forms: Sequence[Form]) -> _Letters | str:
    """The equations in the type's letters, or why they have another shape."""
    pair = common_angle_and_length(forms)
    if isinstance(pair, str):
        return pair
    angle, length = pair
    sines, cosines = forms
    if not sines.within([(), (length.name, angle.sine)]):
        return "the first equation is not X1 r s = Y1"
    if not cosines.within([(), (length.name, angle.cosine)]):
        return "the second equation is not X2 r c = Y2"
    return _Letters(
        angle,
        length,
        x1=sines.coefficient(length.name, angle.sine),
        y1=-sines.coefficient(),
        x2=cosines.coefficient(length.name, angle.cosine),
        y2=-cosines.coefficient(),
    )

"""Types 4 and 5: X1 r s = Y1, X2 r c = Y2, and X1 s = Y1 + Z1 r, X2 c = Y2 + Z2 r."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.paul.form import common_angle_and_length
from dhgen.paul.kind import Kind
from dhgen.paul.step import NEARLY_NOTHING, Step

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.algebra import AngleSum
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Form, Length
    from dhgen.paul.step import Offer, View


POLAR = 50


class Polar:
    """Type 4, two values: r = e sqrt((Y1/X1)^2 + (Y2/X2)^2), and the angle that goes with it."""

    name = "type 4"
    arity = 2
    anywhere = False
    ordered = True

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """One step for both unknowns, or why the equations are no vector in polar coordinates."""
        read = _read_polar(forms)
        if isinstance(read, str):
            return read
        if not (view.is_constant(read.x1) and view.is_constant(read.x2)):
            return "X1 or X2 may vanish"
        unknowns = (read.angle, read.length)
        letters = (("X1", read.x1), ("Y1", read.y1), ("X2", read.x2), ("Y2", read.y2))
        short = any(view.is_nearly_nothing(each) for each in (read.x1, read.x2))
        penalty = POLAR + (NEARLY_NOTHING if short else 0)
        return (Step(Kind.POLAR, unknowns, tuple(forms), letters, penalty),)


@dataclass(frozen=True, slots=True)
class _PolarLetters:
    """The equations in the type's letters."""

    angle: AngleSum
    length: Length
    x1: Polynomial
    y1: Polynomial
    x2: Polynomial
    y2: Polynomial


def _read_polar(forms: Sequence[Form]) -> _PolarLetters | str:
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
    return _PolarLetters(
        angle,
        length,
        x1=sines.coefficient(length.name, angle.sine),
        y1=-sines.coefficient(),
        x2=cosines.coefficient(length.name, angle.cosine),
        y2=-cosines.coefficient(),
    )


LINEAR = 60


class AngleAndLength:
    """Type 5, two values: with V = Y/X and W = Z/X, (V1 + W1 r)^2 + (V2 + W2 r)^2 = 1."""

    name = "type 5"
    arity = 2
    anywhere = False
    ordered = True

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """One step for both unknowns.

        Or why the equations are not X1 s = Y1 + Z1 r, X2 c = Y2 + Z2 r.
        """
        read = _read(forms)
        if isinstance(read, str):
            return read
        if not (view.is_constant(read.x1) and view.is_constant(read.x2)):
            return "X1 or X2 may vanish"
        if not (view.is_constant(read.z1) and view.is_constant(read.z2)):
            return "Z1 and Z2 may vanish together"
        unknowns = (read.angle, read.length)
        letters = (
            ("X1", read.x1),
            ("Y1", read.y1),
            ("Z1", read.z1),
            ("X2", read.x2),
            ("Y2", read.y2),
            ("Z2", read.z2),
        )
        return (Step(Kind.ANGLE_AND_LENGTH, unknowns, tuple(forms), letters, LINEAR),)


@dataclass(frozen=True, slots=True)
class _Letters:
    """The equations in the type's letters."""

    angle: AngleSum
    length: Length
    x1: Polynomial
    y1: Polynomial
    z1: Polynomial
    x2: Polynomial
    y2: Polynomial
    z2: Polynomial


def _read(forms: Sequence[Form]) -> _Letters | str:
    """The equations in the type's letters, or why they have another shape."""
    pair = common_angle_and_length(forms)
    if isinstance(pair, str):
        return pair
    angle, length = pair
    sines, cosines = forms
    if not sines.within([(), (angle.sine,), (length.name,)]):
        return "the first equation is not X1 s = Y1 + Z1 r"
    if not cosines.within([(), (angle.cosine,), (length.name,)]):
        return "the second equation is not X2 c = Y2 + Z2 r"
    return _Letters(
        angle,
        length,
        x1=sines.coefficient(angle.sine),
        y1=-sines.coefficient(),
        z1=-sines.coefficient(length.name),
        x2=cosines.coefficient(angle.cosine),
        y2=-cosines.coefficient(),
        z2=-cosines.coefficient(length.name),
    )

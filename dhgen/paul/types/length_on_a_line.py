"""Type 10 of two lengths, one of which is linear in the other: a line put into a squared length.

A slide before a turn and one behind it that are oblique to its axis: what does not depend on the
turn is the place along the axis, linear in both lengths, and the squared distance from a point of
it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.step import Kind, Step

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Form, Length
    from dhgen.paul.step import Offer, View

PENALTY = 200


class LengthOnALine:
    """One or two values of one length; the other follows from the line, by type 1."""

    name = "type 10 of two lengths"
    arity = 2
    anywhere = True
    ordered = True

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """A step for each length that can stay: of type 1 if the squares cancel.

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
        size = PENALTY + len(x) + len(y) + len(z)
        if not x and not view.witnesses.vanishes(y):
            linear = (("X", y), ("Y", z))
            yield Step(Kind.LENGTH, (kept,), tuple(forms), linear, 1, size)
        elif view.is_constant(x) and not view.witnesses.vanishes(x):
            letters = (("X", x), ("Y", y), ("Z", z))
            yield Step(Kind.SQUARED_LENGTH, (kept,), tuple(forms), letters, 2, size)


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

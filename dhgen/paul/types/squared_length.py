"""Type 10, beyond the table: X r^2 + Y r = Z, the distance of a point on a slide from another."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.step import Kind, Step

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.paul.form import Form
    from dhgen.paul.step import Offer, View

PENALTY = 150


class SquaredLength:
    """Type 10, two values: r = -Y/2X + e sqrt((Y/2X)^2 + Z/X).

    It says less than the equations of types 4 and 5, whose squares it adds up, but also where axes
    beside the slide stand at no right angle.
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
        return (Step(Kind.SQUARED_LENGTH, (length,), (form,), letters, 2, PENALTY),)

"""Type 10, beyond the table: X r^2 + Y r = Z, the distance of a point on a slide from another."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.step import Kind, Step

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.paul.form import Form
    from dhgen.paul.step import View

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

    def why_not(self, forms: Sequence[Form], view: View) -> str | None:
        """Why the equation is not X r^2 + Y r = Z."""
        (form,) = forms
        length = form.only_length
        if length is None:
            return "the unknown is not a single length"
        r = length.name
        if not form.within([(), (r,), (r, r)]):
            return f"{r} occurs in a higher power than its square"
        x, y = form.coefficient(r, r), form.coefficient(r)
        if not (view.is_constant(x) and view.is_constant(y)):
            return "X or Y may vanish"
        return "X vanishes" if view.witnesses.vanishes(x) else None

    def steps(self, forms: Sequence[Form], view: View) -> Iterator[Step]:
        """One step."""
        del view
        (form,) = forms
        length = form.only_length
        if length is None:
            return
        r = length.name
        letters = (
            ("X", form.coefficient(r, r)),
            ("Y", form.coefficient(r)),
            ("Z", -form.coefficient()),
        )
        yield Step(Kind.SQUARED_LENGTH, (length,), (form,), letters, 2, PENALTY)

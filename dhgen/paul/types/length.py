"""Type 1: X r = Y."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.step import NEARLY_NOTHING, Kind, Step

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.paul.form import Form
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
        return (Step(Kind.LENGTH, (length,), (form,), letters, 1, penalty + len(y)),)

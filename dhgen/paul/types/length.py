"""Type 1: X r = Y."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.forms import Length
from dhgen.paul.step import Kind, Step

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.paul.forms import Form
    from dhgen.paul.step import View

VARIABLE_DIVISOR = 400  # X may vanish: only when nothing else works


class SingleLength:
    """Type 1, one value: r = Y / X."""

    name = "type 1"
    arity = 1

    def why_not(self, forms: Sequence[Form], view: View) -> str | None:
        """Why the equation is not X r = Y."""
        (form,) = forms
        if len(form.unknowns) != 1 or not isinstance(form.unknowns[0], Length):
            return "the unknown is not one length"
        name = form.unknowns[0].name
        if not form.within([(), (name,)]):
            return f"{name} occurs in a higher power"
        if view.witnesses.vanishes(form.coefficient(name)):
            return f"the factor of {name} vanishes"
        return None

    def steps(self, forms: Sequence[Form], view: View) -> Iterator[Step]:
        """One step."""
        (form,) = forms
        unknown = form.unknowns[0]
        assert isinstance(unknown, Length)
        x, y = form.coefficient(unknown.name), -form.coefficient()
        penalty = 10 if view.is_constant(x) else VARIABLE_DIVISOR
        yield Step(
            Kind.LENGTH, (unknown,), (form,), (("X", x), ("Y", y)), 1, penalty + len(y)
        )

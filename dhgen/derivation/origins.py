"""Which elements of which matrices a step's equations are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.elements import element_of
from dhgen.derivation.notation.matrices import known_matrix
from dhgen.derivation.text.blocks import joined, say
from dhgen.derivation.text.words import many

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Prose
    from dhgen.paul.equation import Origin
    from dhgen.paul.step import Step

SQUARED = ", the squared length of column 4"  # behind its symbol, which comes last


def where_from(step: Step) -> Prose:
    """From which elements, and what was moved."""
    origins = step.origins
    names = [say("{}", element_of(origin)) for origin in origins]
    head = say("From {}", joined(names))
    first = origins[0]
    if not all(o.matrix == first.matrix for o in origins):
        return say("{}{}", head, say("" if all(o.row for o in origins) else SQUARED))
    if first.inverse:
        return say("{}{}, seen from the tool", head, _line_of(origins))
    if first.is_mixed:
        joints = many("joint", [str(joint) for joint in range(first.k + 1, first.dof + 1)])
        moved = say(f", {joints} moved to the side of {{}}", known_matrix(first.matrix))
        return say("{}{}{}", head, _line_of(origins), moved)
    return say("{}{}", head, _line_of(origins))


def _line_of(origins: tuple[Origin, ...]) -> Prose:
    """(column 4) or (row 3), for two elements; what the squared length of a column is."""
    if not all(origin.row for origin in origins):
        return say(SQUARED)
    if len(origins) < 2:
        return say("")
    if origins[0].column == origins[1].column:
        return say(f" (column {origins[0].column})")
    return say(f" (row {origins[0].row})") if origins[0].row == origins[1].row else say("")

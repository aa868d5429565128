"""The equations of a step as they are in the matrices, and which way round they are."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import element_of, form_of, sides
from dhgen.derivation.text.blocks import joined, say
from dhgen.derivation.text.words import many
from dhgen.paul.kind import Kind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Prose
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.derivation import Derivation
    from dhgen.paul.equation import Origin
    from dhgen.paul.form import Form
    from dhgen.paul.step import Step


@dataclass(frozen=True, slots=True)
class Quote:
    """One equation, left = right.

    Attributes:
        origin: Where it is read.
        left: The side with the joints, unless that is a constant.
        right: The other side.
        joints_left: Whether the side with the joints is left.
        facing: +1 when left - right is the equation of the pool, -1 when it is the opposite.
    """

    origin: Origin
    left: Polynomial
    right: Polynomial
    joints_left: bool
    facing: int


def quotes_of(derivation: Derivation, step: Step) -> tuple[Quote, ...]:
    """The equations of a step, in its order."""
    return tuple(
        _quote(derivation, step.kind, form, origin)
        for form, origin in zip(step.forms, step.origins, strict=True)
    )


def _quote(derivation: Derivation, kind: Kind, form: Form, origin: Origin) -> Quote:
    if origin.row:
        matrices = form_of(derivation.pool, origin.matrix)
        known, joints = sides(matrices, origin.row, origin.column)
    else:
        known, joints = form.equation.left, form.equation.right
    joints_left = not derivation.problem.algebra.is_constant(joints)
    left, right = (joints, known) if joints_left else (known, joints)
    if kind is Kind.ANGLE and not right:
        left = form.equation.difference  # zero has no sign: that of the step's letters
    facing = 1 if left - right == form.equation.difference else -1
    assert facing * (left - right) == form.equation.difference
    return Quote(origin, left, right, joints_left, facing)


SQUARED = ", the squared length of column 4"  # behind its symbol, which comes last


def where_from(story: Story, step: Step) -> Prose:
    """From which elements, and what was moved."""
    origins = step.origins
    names = [say("{}", element_of(each, story.left_name(each.matrix))) for each in origins]
    head = say("From {}", joined(names))
    first = origins[0]
    if not all(o.matrix == first.matrix for o in origins):
        return say("{}{}", head, say("" if all(o.row for o in origins) else SQUARED))
    if first.inverse:
        return say("{}{}, seen from the tool", head, _line_of(origins))
    if first.is_mixed:
        joints, known = story.moved_right(first.matrix)
        list_of_joints = many("joint", [str(joint) for joint in joints])
        moved = say(f", {list_of_joints} moved to the side of {{}}", known)
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

"""The equations of a step as they stand in the matrices, and which way round they stand."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import form_of, sides

if TYPE_CHECKING:
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
        joints_left: Whether the side with the joints stands left.
        facing: +1 when left - right is the equation of the pool, -1 when it is the opposite. The
            letters of a type are quoted with this sign, so that they belong to the equation as it
            stands.
    """

    origin: Origin
    left: Polynomial
    right: Polynomial
    joints_left: bool
    facing: int


def quotes_of(derivation: Derivation, step: Step) -> tuple[Quote, ...]:
    """The equations of a step, in its order."""
    return tuple(
        _quote(derivation, form, origin)
        for form, origin in zip(step.forms, step.origins, strict=True)
    )


def _quote(derivation: Derivation, form: Form, origin: Origin) -> Quote:
    if origin.row:
        matrices = form_of(derivation.pool, origin.matrix)
        known, joints = sides(matrices, origin.row, origin.column)
    else:
        known, joints = form.equation.left, form.equation.right
    joints_left = not derivation.problem.algebra.is_constant(joints)
    left, right = (joints, known) if joints_left else (known, joints)
    facing = 1 if left - right == form.equation.difference else -1
    assert facing * (left - right) == form.equation.difference
    return Quote(origin, left, right, joints_left, facing)

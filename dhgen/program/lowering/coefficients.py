"""The coefficients of a step's type: their values, and what is known once it is solved."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum

if TYPE_CHECKING:
    from dhgen.paul.step import Step
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering


def letters(context: Lowering, step: Step, names: str) -> tuple[Node, ...]:
    """The values of some of the type's letters, named with spaces between."""
    unknown = step.unknowns[0]
    suffix = unknown.suffix if isinstance(unknown, AngleSum) else str(unknown.joint)
    return tuple(
        context.builder.hint(context.lower(step.coefficient(name)), named(name, suffix))
        for name in names.split()
    )


def named(letter: str, suffix: str) -> str:
    """A letter of a type at a step: X5, and X1_5 for X1."""
    return f"{letter}_{suffix}" if letter[-1].isdigit() else letter + suffix


def remember(context: Lowering, step: Step, angle: AngleSum, z: Node, root: Node) -> None:
    """X s + Y c is Z and Y s - X c is the signed root: later steps need not compute them."""
    x, y = step.coefficient("X"), step.coefficient("Y")
    s, c = context.generators(angle)
    context.polynomials.remember(x * s + y * c, z)
    context.polynomials.remember(y * s - x * c, root)

"""The level direction of the tool's x axis, where the task names its yaw."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.kind import Kind
from dhgen.program.ir import Failure
from dhgen.program.lowering.roots import over
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from dhgen.paul.step import Step
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering

SIDES = ("Z1", "Z2")


def lower_yaw(context: Lowering, steps: tuple[Step, ...]) -> None:
    """Makes t11 and t21 cosine and sine of the yaw, however steep the tool's x axis is given.

    Where it is vertical, the angle of the step that reads the yaw is free.
    """
    if context.chain.task.directions is not Directions.YAW:
        return
    builder, scales = context.builder, context.scales
    builder.heading("the yaw's cosine and sine")
    x, y = builder.pose(1, 1), builder.pose(2, 1)
    square = builder.add(builder.square(x), builder.square(y))
    length = builder.name(builder.apply("sqrt", square), "level")
    limit = scales.tolerance(scales.tolerances.steep, 0, "steep")
    steep = builder.name(builder.apply("at_most", length, limit), "steep")
    factor = over(context, builder.integer(1), length, steep, "_yaw")
    level = {"t11": builder.mul(x, factor), "t21": builder.mul(y, factor)}
    context.learn({name: builder.name(value, name) for name, value in level.items()})
    if context.overdetermined or not any(reads_yaw(context, step) for step in steps):
        builder.guard(builder.apply("not", steep), Failure.INCONSISTENT)
    else:
        context.steep = steep


def reads_yaw(context: Lowering, step: Step) -> bool:
    """Whether a step gives an angle that is the yaw but for a constant."""
    if step.kind is not Kind.ANGLE_PAIR:
        return False
    algebra = context.algebra
    factors = (step.coefficient(letter) for letter in ("X1", "Y1", "X2", "Y2"))
    places = [algebra.index[name] for name in ("t11", "t21")]
    sides = (monomial for letter in SIDES for monomial in step.coefficient(letter))
    has_yaw = any(monomial[place] for monomial in sides for place in places)
    return has_yaw and context.are_constant(*factors)


def free_yaw(context: Lowering, step: Step) -> Node | None:
    """Whether the angle that a step reads from the yaw is free; None where it never is."""
    return context.steep if reads_yaw(context, step) else None

"""Type 1: a length."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.program.ir import Failure
from dhgen.program.lowering.letters import letters
from dhgen.program.lowering.short import is_short, is_within_reach, vanishes

if TYPE_CHECKING:
    from dhgen.paul.step import Step
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering


def lower_length(context: Lowering, step: Step) -> None:
    """Type 1: r = Y / X; where X may vanish, the seed's r if Y vanishes too."""
    unknown = step.length
    builder = context.builder
    y, x = letters(context, step, "Y X")
    if context.are_constant(step.coefficient("X")):
        context.angles.solved_slide(unknown.name, builder.div(y, x))
        return
    degree = context.scales.degree(step.coefficient("X"))
    free = is_short(context, builder.absolute(x), degree, f"free{unknown.joint}")
    near = vanishes(context, y, step.coefficient("Y"))
    within = is_within_reach(context, y, x)
    condition = builder.select(free, near, within)
    margin = builder.select(free, _margin(builder, near), _margin(builder, within))
    builder.guard(condition, Failure.ENDLESS, margin, context.angles.options())
    safe = builder.hint(builder.select(free, builder.integer(1), x), f"divisor{unknown.joint}")
    seed = context.angles.chosen_slide(unknown.joint, free)
    length = builder.select(free, seed, builder.div(y, safe))
    context.angles.solved_slide(unknown.name, length)


def _margin(builder: Builder, condition: Node) -> Node:
    """By how much x <= limit holds."""
    x, limit = builder.entries[condition].operands
    return builder.sub(limit, x)

"""What is done at a singular place, in words that match the program."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.step import Kind
from dhgen.targets.derivation.blocks import joined, say
from dhgen.targets.derivation.formula import ZERO, equal, minus, relation
from dhgen.targets.derivation.formula import ONE
from dhgen.targets.derivation.names import joint_symbol, single, theta
from dhgen.targets.derivation.story import remembered_letter

if TYPE_CHECKING:
    from dhgen.targets.derivation.blocks import Prose
    from dhgen.targets.derivation.step_context import StepContext


def merged_effect(context: StepContext) -> Prose:
    """Two branches have met."""
    minus_one = equal(context.sign, minus(ONE))
    plus_one = equal(context.sign, ONE)
    return say(
        "both signs give the same solution, which stands in the rows with {}; those with {} stay empty",
        plus_one, minus_one,
    )


def free_effect(context: StepContext) -> Prose:
    """A joint takes the seed's value."""
    joints = open_joints(context)
    symbols = joined([say("{}", joint_symbol(joint)) for joint in joints])
    takes = "takes" if len(joints) == 1 else "take"
    parts = [say(f"{{}} {takes} the seed's value (0 without a seed)", symbols)]
    if context.step.roots == 2:
        parts.append(say("the rows with {} stay empty", equal(context.sign, minus(ONE))))
    if context.step.kind is Kind.ANGLE and context.is_used_later():
        parts.append(say("{}", equal(remembered_letter(context.step), ZERO)))
    parts.append(say("the steps below go on unchanged"))
    if context.number == len(context.story.steps):
        parts.pop()
    return joined(parts, ", and ") if len(parts) > 1 else parts[0]


def open_joints(context: StepContext) -> list[int]:
    """The joints of the step's angle that no earlier step has given."""
    before = context.story.knowledge[context.number - 1]
    assert isinstance(context.angle, AngleSum)
    return [joint for joint, _ in context.angle.terms if not before.knows(single(joint))]


__all__ = ["free_effect", "merged_effect", "open_joints", "relation", "theta"]

"""What the angles and lengths of the formulas are for the joint variables."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.expressions import variable_symbol
from dhgen.derivation.notation.names import joint_symbol, letter, single, theta
from dhgen.derivation.text.blocks import joined, paragraph, say
from dhgen.derivation.text.formula import Symbol, equal
from dhgen.robot.expression import ZERO
from dhgen.robot.robot import AxisJoint, DhRow, JointKind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.robot.expression import Expression

_I = Symbol("i", "i")
_ANGLE_TEXT = "In the formulas {} is the angle of joint {}: {}{}."
_LENGTH_TEXT = "In the formulas {} is the length of joint {}: {}."
_BOTH_TEXT = (
    "In the formulas {} is the angle of a revolute joint and {} the length of a prismatic "
    "one: {}{}."
)


def variables(story: Story) -> Block:
    """What theta_i and r_i are for the joint variables q_i."""
    angle, slide, q = Symbol(r"\theta_i", "θᵢ"), Symbol("r_i", "rᵢ"), Symbol("q_i", "qᵢ")
    changed: list[Prose] = []
    turning = plain = 0
    for number, joint in enumerate(joints_of(story), start=1):
        revolute = joint.kind is JointKind.REVOLUTE
        turning += revolute
        inner = theta(single(number)) if revolute else letter("r", "r", str(number))
        outer = variable_symbol(number, *sign_and_offset(story, number))
        if revolute and outer.text == joint_symbol(number).text:
            plain += 1
        else:
            changed.append(say("{}", equal(inner, outer)))
    if not changed:
        return paragraph(_ANGLE_TEXT, angle, _I, equal(angle, q), say(""))
    listed = joined(changed)
    if not turning:
        return paragraph(_LENGTH_TEXT, slide, _I, listed)
    rest = say(", otherwise {}", equal(angle, q)) if plain else say("")
    if turning == len(story.robot.joints):
        return paragraph(_ANGLE_TEXT, angle, _I, listed, rest)
    return paragraph(_BOTH_TEXT, angle, slide, listed, rest)


def joints_of(story: Story) -> tuple[DhRow | AxisJoint, ...]:
    """The joints as the user wrote them."""
    return tuple(story.robot.joints)


def sign_and_offset(story: Story, number: int) -> tuple[int, Expression]:
    """What a joint's angle or length is for its variable: sign and what is added."""
    joint: DhRow | AxisJoint = story.robot.joints[number - 1]
    sign = story.algebra.chain.joints[number - 1].sign
    if not isinstance(joint, DhRow):
        return sign, ZERO
    return sign, joint.theta if joint.kind is JointKind.REVOLUTE else joint.d

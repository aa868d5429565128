"""Joint values as the caller counts them, and the angles and lengths of the algebra."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain, ChainJoint
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node


class JointVariables:
    """q of every joint and the angle or length that stands for it: sign and offset apart.

    Args:
        chain: The arm.
        builder: Where values go.
    """

    def __init__(self, chain: Chain, builder: Builder) -> None:
        self._chain = chain
        self._builder = builder

    def seed(self, joint: int) -> Node:
        """The angle or length for the seed's value of a joint."""
        return self._inner(joint, self._builder.seed(joint))

    def given(self, joint: int) -> Node:
        """The angle or length for the value that the caller gives for a free joint."""
        return self._inner(joint, self._given(joint))

    def result(self, joint: int, inner: Node, *, wrapped: bool) -> Node:
        """The joint's value for its angle or length.

        Args:
            joint: Its number, from 1.
            inner: The angle or length.
            wrapped: Whether an angle is known to lie in (-pi, pi].
        """
        known = self._chain.joints[joint - 1]
        if joint in self._chain.free:
            return self._given(joint)
        value = self._builder.sub(inner, self._offset(joint))
        value = value if known.sign > 0 else self._builder.neg(value)
        if known.kind is JointKind.PRISMATIC or (wrapped and known.offset == 0.0):
            return value
        return self._builder.apply("wrap", value)

    def _given(self, joint: int) -> Node:
        return self._builder.given(self._chain.free.index(joint) + 1)

    def _inner(self, joint: int, value: Node) -> Node:
        known = self._chain.joints[joint - 1]
        turned = value if known.sign > 0 else self._builder.neg(value)
        return self._builder.add(turned, self._offset(joint))

    def _offset(self, joint: int) -> Node:
        known = self._chain.joints[joint - 1]
        if known.offset == 0.0:
            return self._builder.integer(0)
        return offset_constant(self._builder, known)


def offset_constant(builder: Builder, joint: ChainJoint) -> Node:
    """What is to be added to the value of a joint."""
    turns = joint.kind is JointKind.REVOLUTE
    meaning = f"offset of joint {joint.number}" + (" [rad]" if turns else "")
    power = 0 if turns else 1
    return builder.constant(f"offset{joint.number}", joint.offset, meaning, power)

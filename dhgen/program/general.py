"""The program of an arm that the general 6R algorithm solves: one statement, then joint values."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.general.reference import MOST
from dhgen.program.ir import (
    Apply,
    Axis,
    Failure,
    GeneralRoots,
    Guard,
    Heading,
    Integer,
    Let,
    NamedConstant,
    Program,
    Variable,
)

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain, ChainJoint
    from dhgen.program.ir import Expression


def general_program(chain: Chain, kernel: GeneralKernel) -> Program:
    """Sixteen rows by ascending angle of joint 1, then of joint 2 and so on."""
    names = tuple(f"x{joint.number}" for joint in chain.joints)
    meaning = tuple(f"root{number}" for number in range(1, MOST + 1))
    exists = Apply("at_most", (Variable(names[0]), Integer(4)))
    values = [
        Let(f"q{joint.number}", _value(joint, name), (0,))
        for joint, name in zip(chain.joints, names, strict=True)
    ]
    offsets = (
        NamedConstant(f"offset{joint.number}", joint.offset, f"offset of joint {joint.number}")
        for joint in chain.joints
        if joint.offset
    )
    return Program(
        name=chain.name,
        constants=tuple(offsets),
        axes=(Axis("x", meaning, 1),),
        body=(
            Heading("all joints: the general 6R loop"),
            GeneralRoots(0, names, kernel),
            Guard(exists, (0,), Failure.REACH),
            Heading("joint values"),
            *values,
        ),
        outputs=tuple(Variable(f"q{joint.number}") for joint in chain.joints),
        free=(),
    )


def _value(joint: ChainJoint, name: str) -> Expression:
    """The joint value behind an angle of the algebra."""
    angle: Expression = Variable(name)
    if joint.offset:
        angle = Apply("sub", (angle, Variable(f"offset{joint.number}")))
    if joint.sign < 0:
        angle = Apply("neg", (angle,))
    return Apply("wrap", (angle,))

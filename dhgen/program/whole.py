"""The programs of arms that are solved as a whole: one statement, then joint values."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.general.kernel import GeneralKernel
from dhgen.program.ir import (
    AllJoints,
    Apply,
    Axis,
    Failure,
    Guard,
    Heading,
    Let,
    NamedConstant,
    Program,
    Variable,
)

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain, ChainJoint
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.program.ir import Expression, Statement

FOUND, CHOSEN = "found", "chosen"


def whole_program(chain: Chain, kernel: GeneralKernel | NumericalKernel) -> Program:
    """The program of an arm whose joints come all at once."""
    if isinstance(kernel, GeneralKernel):
        return general_program(chain, kernel)
    return numerical_program(chain, kernel)


def general_program(chain: Chain, kernel: GeneralKernel) -> Program:
    """Sixteen rows by ascending angle of joint 1, then of joint 2 and so on."""
    names = tuple(f"x{joint.number}" for joint in chain.joints)
    values = [
        Let(f"q{joint.number}", _value(joint, name), (0,))
        for joint, name in zip(chain.joints, names, strict=True)
    ]
    offsets = tuple(
        NamedConstant(f"offset{joint.number}", joint.offset, f"offset of joint {joint.number}")
        for joint in chain.joints
        if joint.offset
    )
    axis = Axis("solution", tuple(f"root{number}" for number in range(1, kernel.rows + 1)), 1)
    statement = AllJoints(0, names, FOUND, CHOSEN, kernel)
    body = (Heading("all joints: the general 6R loop"), *_rows(statement))
    return _program(chain, offsets, axis, (*body, Heading("joint values"), *values))


def numerical_program(chain: Chain, kernel: NumericalKernel) -> Program:
    """As many rows as solutions are kept, by ascending value of joint 1, then of joint 2 ..."""
    names = tuple(f"q{joint.number}" for joint in chain.joints)
    meaning = tuple(f"solution{number}" for number in range(1, kernel.rows + 1))
    axis = Axis("solution", ("nearest",) if kernel.redundant else meaning, 1)
    statement = AllJoints(0, names, FOUND, CHOSEN, kernel, bool(chain.free))
    body = (Heading("all joints: damped least squares"), *_rows(statement))
    return _program(chain, (), axis, body)


def _rows(statement: AllJoints) -> tuple[Statement, ...]:
    return statement, Guard(Variable(statement.found), (0,), Failure.REACH)


def _program(
    chain: Chain, constants: tuple[NamedConstant, ...], axis: Axis, body: tuple[Statement, ...]
) -> Program:
    return Program(
        name=chain.name,
        constants=constants,
        axes=(axis,),
        body=body,
        outputs=tuple(Variable(f"q{joint.number}") for joint in chain.joints),
        free=((0, CHOSEN),),
    )


def _value(joint: ChainJoint, name: str) -> Expression:
    """The joint value behind an angle of the algebra."""
    angle: Expression = Variable(name)
    if joint.offset:
        angle = Apply("sub", (angle, Variable(f"offset{joint.number}")))
    if joint.sign < 0:
        angle = Apply("neg", (angle,))
    return Apply("wrap", (angle,))

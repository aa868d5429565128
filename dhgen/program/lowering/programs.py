"""All programs of a robot, each under the robot's name; constants have one name in all of them."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.program.ir import Apply, Let, Variable
from dhgen.program.lowering.arm_angle import arm_angle_program, plane_miss_program
from dhgen.program.lowering.forward import forward_program, jacobian_program
from dhgen.program.role import Source

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.paul.derivation import Derivation
    from dhgen.program.ir import Expression, NamedConstant, Program, Statement
    from dhgen.program.reserved import Reserved
    from dhgen.tolerances import Tolerances


@dataclass(frozen=True, slots=True)
class Programs:
    """What a robot's files compute.

    Attributes:
        solver: From pose to rows of joint values.
        forward: From joint values to the pose.
        jacobian: From joint values to the geometric Jacobian.
        arm_angle: From joint values to the arm angle, where the caller gives that.
        plane_miss: From them and the pose to what they miss the arm angle by, where rows need it.
    """

    solver: Program
    forward: Program
    jacobian: Program
    arm_angle: Program | None = None
    plane_miss: Program | None = None


def robot_programs(
    derivation: Derivation, solver: Program, name: str, tolerances: Tolerances, reserved: Reserved
) -> Programs:
    """The programs of a robot for some arithmetic.

    Args:
        derivation: How it is solved.
        solver: What it is lowered to.
        name: What every program is called.
        tolerances: Of the arithmetic.
        reserved: Names that are kept for others.
    """
    chain = derivation.problem.algebra.chain
    forward = reusing(forward_program(chain, reserved), solver)
    jacobian = reusing(jacobian_program(chain, reserved), solver, forward)
    angle = arm_angle_program(derivation, tolerances, reserved)
    # only rows that are refined are measured by it
    has_miss = solver.completion is not None
    miss = plane_miss_program(derivation, tolerances, reserved) if has_miss else None
    return Programs(
        replace(solver, name=name),
        replace(forward, name=name),
        replace(jacobian, name=name),
        arm_angle=None if angle is None else replace(angle, name=name),
        plane_miss=None if miss is None else replace(miss, name=name),
    )


_FORMULA = re.compile(r" [*/] ")
_WORD = re.compile(r"\w+|[^\w\s]")


def reusing(program: Program, *others: Program) -> Program:
    """A program of values alone that makes no constant anew that others have made.

    Args:
        program: The program, without loops and guards.
        others: Those whose constants it may name.
    """
    made: dict[object, NamedConstant] = {}
    for constant in (each for other in others for each in other.constants):
        if constant.role is Source.MADE and _FORMULA.search(constant.meaning):
            made.setdefault(_made_of(constant), constant)
    own = {constant.name for constant in program.constants}
    own |= {statement.name for statement in program.body if isinstance(statement, Let)}
    found = {
        constant.name: made[_made_of(constant)]
        for constant in program.constants
        if constant.role is Source.MADE and _made_of(constant) in made
    }
    found = {name: constant for name, constant in found.items() if constant.name not in own}
    names = {name: constant.name for name, constant in found.items()}
    return replace(
        program,
        constants=tuple(found.get(each.name, each) for each in program.constants),
        body=tuple(_statement(each, names) for each in program.body),
        outputs=tuple(_expression(each, names) for each in program.outputs),
    )


def _made_of(constant: NamedConstant) -> object:
    """A constant's value and the words of its formula, in any order of sums and products."""
    words = tuple(sorted(_WORD.findall(constant.meaning)))
    return constant.value, constant.power, words


def _statement(statement: Statement, names: Mapping[str, str]) -> Statement:
    if not isinstance(statement, Let):
        return statement
    return replace(statement, expression=_expression(statement.expression, names))


def _expression(expression: Expression, names: Mapping[str, str]) -> Expression:
    match expression:
        case Variable(name):
            return Variable(names.get(name, name))
        case Apply(operator, operands):
            return Apply(operator, tuple(_expression(each, names) for each in operands))
        case _:
            return expression

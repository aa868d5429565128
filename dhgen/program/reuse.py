"""Constants that a program has under the names that another one gave them."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.program.ir import Apply, Let, Variable
from dhgen.program.role import Source

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.program.ir import Expression, NamedConstant, Program, Statement

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

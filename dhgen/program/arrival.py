"""When the values of a straight-line program are known, counted from the pose.

A processor looks only some hundred instructions ahead: what waits long keeps the place of what
could be done. Where the order is free, what is known first is asked for first.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.program.ir import Apply, Let, Variable

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.program.ir import Expression, Program

# Cycles until the result of an operator may be used, as usual processors have them; of others 1.
LATENCY = {"add": 4, "sub": 4, "mul": 4, "div": 13, "sqrt": 21, "atan2": 60}


def arrivals(program: Program) -> dict[str, int]:
    """For each named value the cycle in which it is known."""
    known: dict[str, int] = {}
    for statement in program.body:
        if isinstance(statement, Let):
            known[statement.name] = arrival(statement.expression, known)
    return known


def arrival(expression: Expression, known: Mapping[str, int]) -> int:
    """The cycle in which an expression is known; constants and the pose are from the beginning."""
    match expression:
        case Variable(name):
            return known.get(name, 0)
        case Apply(operator, operands):
            ready = max(arrival(operand, known) for operand in operands)
            return ready + LATENCY.get(operator, 1)
        case _:
            return 0

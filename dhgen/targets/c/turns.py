"""Angles that are moved by a whole turn to (-pi, pi]: functions for what programs write out."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.ir import Apply, Integer, Variable
from dhgen.program.role import Source

if TYPE_CHECKING:
    from dhgen.program.ir import Expression, Program


@dataclass(frozen=True, slots=True)
class Turned:
    """An angle that is moved.

    Attributes:
        function: How: one that may be below -pi is raised, one above pi lowered, either centred.
        angle: As it was.
    """

    function: str
    angle: Expression


class TurnReader:
    """Finds them in the expressions of a program."""

    def __init__(self, program: Program) -> None:
        known = [c for c in program.constants if c.role is Source.FILE]
        named = {2 * math.pi: "DHGEN_TURN", math.pi: "DHGEN_HALF_TURN"}
        self.names = {c.name: named[c.value] for c in known if c.value in named}
        self._turn = {Variable(c.name) for c in known if c.value == 2 * math.pi}
        self._pi = {Variable(c.name) for c in known if c.value == math.pi}

    def read(self, expression: Expression) -> Turned | None:
        """The angle that an expression moves to (-pi, pi] by whole turns."""
        match expression:
            case Apply("add", (angle, Apply("select", (condition, turn, Integer(0))))):
                if self._below(condition, angle) and turn in self._turn:
                    return Turned("raised", angle)
                if self._above(condition, angle) and self._back(turn):
                    return Turned("lowered", angle)
            case Apply("add", (angle, Apply("select", (condition, turn, other)))):
                lowered = self.read(Apply("add", (angle, other)))
                if lowered == Turned("lowered", angle) and turn in self._turn:
                    return Turned("centred", angle) if self._below(condition, angle) else None
        return None

    def _below(self, condition: Expression, angle: Expression) -> bool:
        match condition:
            case Apply("at_most", (value, Apply("neg", (pi,)))):
                return value == angle and pi in self._pi
        return False

    def _above(self, condition: Expression, angle: Expression) -> bool:
        match condition:
            case Apply("less", (pi, value)):
                return value == angle and pi in self._pi
        return False

    def _back(self, turn: Expression) -> bool:
        match turn:
            case Apply("neg", (inner,)):
                return inner in self._turn
        return False

"""Formulas of constants made from constants, as a reader writes them: a2^2 + a3^2."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from dhgen.program.ir import Operator

Binding = Literal[0, 1, 2]
SUM: Binding = 0
PRODUCT: Binding = 1
ATOM: Binding = 2


@dataclass(frozen=True, slots=True)
class Formula:
    """A formula.

    Attributes:
        text: How it is written.
        power: The power of a length that its value is.
        binding: How tightly the text binds.
    """

    text: str
    power: int = 0
    binding: Binding = ATOM

    def within(self, binding: Binding) -> str:
        """The text where something binds this tightly."""
        return self.text if self.binding >= binding else f"({self.text})"


def combined(operator: Operator, left: Formula, right: Formula) -> Formula:
    """The formula of an operator on two others."""
    match operator:
        case "add" | "sub":
            sign = "+" if operator == "add" else "-"
            text = f"{left.text} {sign} {right.within(PRODUCT)}"
            return Formula(text, max(left.power, right.power), SUM)
        case "mul" if left == right:
            return Formula(f"{left.within(ATOM)}^2", 2 * left.power, PRODUCT)
        case "mul":
            text = f"{left.within(PRODUCT)} * {right.within(PRODUCT)}"
            return Formula(text, left.power + right.power, PRODUCT)
        case _:
            text = f"{left.within(PRODUCT)} / {right.within(ATOM)}"
            return Formula(text, left.power - right.power, PRODUCT)

"""What the user wrote in a cell, as a formula in one line: -pi/2, L2 + D4, q - pi/2."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from dhgen.robot.expression import ZERO, to_text
from dhgen.robot.robot import JointKind
from dhgen.targets.derivation.notation.names import joint_symbol, parameter
from dhgen.targets.derivation.text.formula import Symbol

if TYPE_CHECKING:
    from dhgen.robot.expression import Expression

_TOKENS = re.compile(r"sqrt\((\d+)\)|([A-Za-z_][A-Za-z0-9_]*)|(\*\*)|(\*)|(-)|(.)")
_FUNCTIONS = frozenset({"sin", "cos", "sqrt"})


def expression_symbol(expression: Expression) -> Symbol:
    """An expression as one symbol, laid out as a cell has it."""
    return text_symbol(to_text(expression))


def variable_symbol(number: int, sign: int, offset: Expression) -> Symbol:
    """The cell that holds the joint variable: q_2, q_2 - pi/2, -q_5."""
    variable = joint_symbol(number)
    minus = sign < 0
    latex, text = ("-" * minus) + variable.latex, ("−" * minus) + variable.text
    if offset == ZERO:
        return Symbol(latex, text)
    added = to_text(offset)
    sign_text, body = ("-", added[1:]) if added.startswith("-") else ("+", added)
    if sign_text == "-" and re.search(r" [+-] ", body):
        sign_text, body = "+", f"({added})"
    inner = text_symbol(body)
    plain_sign = "−" if sign_text == "-" else "+"
    return Symbol(f"{latex} {sign_text} {inner.latex}", f"{text} {plain_sign} {inner.text}")


def limit_symbol(value: float, kind: JointKind) -> Symbol:
    """A joint limit: degrees for an angle, the file's unit for a length."""
    shown = value if kind is JointKind.PRISMATIC else round(math.degrees(value), 9)
    number = repr(shown).removesuffix(".0")
    degree = kind is JointKind.REVOLUTE
    plain = number.replace("-", "−")
    return Symbol(number + (r"^\circ" if degree else ""), plain + ("°" if degree else ""))


def text_symbol(text: str) -> Symbol:
    """What a cell says as one symbol."""
    latex, plain = [], []
    for match in _TOKENS.finditer(text):
        radicand, name, power, star, dash, other = match.groups()
        if radicand:
            pair = rf"\sqrt{{{radicand}}}", f"√{radicand}"
        elif name == "pi":
            pair = r"\pi", "π"
        elif name == "q":  # of whichever joint
            pair = "q", "q"
        elif name in _FUNCTIONS:
            pair = rf"\{name}" if name != "sqrt" else r"\operatorname{sqrt}", name
        elif name:
            pair = parameter(name).latex, parameter(name).text
        elif power:
            pair = "^", "^"
        elif star:
            pair = " ", " "
        elif dash:
            pair = "-", "−"
        else:
            pair = other, other
        latex.append(pair[0])
        plain.append(pair[1])
    return Symbol("".join(latex), "".join(plain))


def number_symbol(value: float) -> Symbol:
    """A decimal number."""
    text = repr(value).removesuffix(".0")
    if "e" in text:
        mantissa, exponent = text.split("e")
        return Symbol(rf"{mantissa} \cdot 10^{{{int(exponent)}}}", text)
    return Symbol(text, text.replace("-", "−"))

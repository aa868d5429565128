"""What the user wrote in a cell, as a formula in one line: -pi/2, L2 + D4, q - pi/2."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import joint_symbol, parameter
from dhgen.derivation.notation.signs import sign_and_size, signs_outside, sum_of, summands
from dhgen.derivation.text.formula import Symbol
from dhgen.robot.exact import multiply
from dhgen.robot.expression import Name, to_text
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.robot.expression import Expression
    from dhgen.robot.robot import Coupling

_TOKENS = re.compile(
    r"sqrt\((\d+)\)|([A-Za-z_][A-Za-z0-9_]*)|(?<![*/])(\d+(?:\.\d+)?)\*\(pi/180\)"
    r"|(\*\*|\*|-)|(\d[\d.]*|.)"
)
_LONG_ROOT = re.compile(r"sqrt\((?!\d+\))")
_SIGNS = {"**": ("^", "^"), "*": (" ", " "), "-": ("-", "−")}
_DECIMALS = 3  # of a limit in degrees
_EXACT = 9  # decimals that conversion from radians leaves right
_VARIABLE = re.compile(r"q(\d+)")
_FUNCTIONS = frozenset({"sin", "cos"})


def expression_symbol(expression: Expression) -> Symbol:
    """An expression as one symbol, laid out as a cell has it."""
    return text_symbol(to_text(signs_outside(expression)))


def variable_symbol(
    number: int, sign: int, offset: Expression, couplings: Sequence[Coupling] = ()
) -> Symbol:
    """The cell that holds the joint variable: q_2, q_2 - pi/2, -q_5, q_3 - q_2.

    That of a passive row, whose sign is zero, holds those of other joints only.
    """
    own: Expression = Name(f"q{number}")
    terms = [(sign, own)] if sign else []
    for each in couplings:
        side, factor = sign_and_size(each.factor)
        other = Name(f"q{each.joint}")
        terms.append((side, multiply(factor, other)))
    return expression_symbol(sum_of([*terms, *summands(offset)]))


def limit_symbol(value: float, kind: JointKind) -> Symbol:
    """A joint limit: degrees for an angle, rounded, the file's unit for a length."""
    shown = value if kind is JointKind.PRISMATIC else round(math.degrees(value), _DECIMALS) + 0.0
    number = repr(shown).removesuffix(".0")
    degree = kind is JointKind.REVOLUTE
    plain = number.replace("-", "−")
    return Symbol(number + (r"^\circ" if degree else ""), plain + ("°" if degree else ""))


def is_rounded_limit(value: float) -> bool:
    """Whether the symbol of an angle's limit is not quite its value."""
    degrees = round(math.degrees(value), _EXACT)
    return degrees != round(degrees, _DECIMALS)


def text_symbol(text: str) -> Symbol:
    """A cell's expression as one symbol."""
    root = _LONG_ROOT.search(text)
    if root is not None:
        return _with_root(text, root.start())
    pairs = [_token(*match.groups()) for match in _TOKENS.finditer(text)]
    return Symbol("".join(latex for latex, _ in pairs), "".join(plain for _, plain in pairs))


def _with_root(text: str, start: int) -> Symbol:
    """A cell with the square root of something that is more than a number."""
    inside, depth = start + len("sqrt("), 1
    end = inside
    while depth:
        depth += {"(": 1, ")": -1}.get(text[end], 0)
        end += 1
    before, root, after = map(text_symbol, (text[:start], text[inside : end - 1], text[end:]))
    return Symbol(
        rf"{before.latex}\sqrt{{{root.latex}}}{after.latex}",
        f"{before.text}√({root.text}){after.text}",
    )


def _token(
    radicand: str | None, name: str | None, degrees: str | None, sign: str | None, other: str | None
) -> tuple[str, str]:
    """A token as LaTeX and as plain text."""
    if radicand:
        return rf"\sqrt{{{radicand}}}", f"√{radicand}"
    if degrees:
        return rf"{degrees}^\circ", f"{degrees}°"
    if name:
        return _name(name)
    return _SIGNS[sign] if sign else (other or "", other or "")


def _name(name: str) -> tuple[str, str]:
    if name == "pi":
        return r"\pi", "π"
    if name == "q":  # of whichever joint
        return "q", "q"
    if number := _VARIABLE.fullmatch(name):
        symbol = joint_symbol(int(number[1]))
        return symbol.latex, symbol.text
    if name in _FUNCTIONS:
        return rf"\{name}", name
    return parameter(name).latex, parameter(name).text


def number_symbol(value: float) -> Symbol:
    """A decimal number."""
    text = repr(value).removesuffix(".0")
    if "e" in text:
        mantissa, exponent = text.split("e")
        return Symbol(rf"{mantissa} \cdot 10^{{{int(exponent)}}}", text)
    return Symbol(text, text.replace("-", "−"))

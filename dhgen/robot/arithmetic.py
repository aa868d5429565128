"""Arithmetic from text: Python's grammar through a whitelist, and nothing is ever run."""

from __future__ import annotations

import ast
import difflib
import keyword
import math
import re
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, get_args

from dhgen.robot.expression import (
    DEGREE,
    Binary,
    Call,
    Function,
    Name,
    Negate,
    Number,
    Pi,
    evaluate,
)
from dhgen.robot.source import Span, quoted
from dhgen.robot.tokens import (
    ALLOWED,
    CellError,
    UnknownNameError,
    check_tokens,
    multiply_degrees,
    no_unit,
)

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.robot.expression import Expression, Operator

MAX_DEPTH = 64
MAX_EXPONENT = 8
# Powers of powers grow beyond every bound when a later stage writes them out exactly.
MAX_DEGREE = 64

FUNCTIONS: tuple[Function, ...] = get_args(Function)

# of some joint, as textbooks call and number them
_VARIABLE = re.compile(r"\b(?:q|th(?:eta)?)(?:_?\d+)?\b", re.ASCII)

# of another joint, as cells call it
_NUMBERED = re.compile(r"q\d+", re.ASCII)

_WORD = re.compile(r"[A-Za-z_]\w*", re.ASCII)

# What other languages, and dicts of Python, have in the place of numbers.
_NO_NUMBERS = dict.fromkeys(("nan", "inf", "infinity"), "not a finite number")
_NO_NUMBERS |= dict.fromkeys(("true", "false"), "not a number")

_OPERATORS: dict[type[ast.operator], Operator] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.Pow: "**",
}


@dataclass(frozen=True, slots=True)
class _Part:
    """An expression, its value (NaN when it is unknown), and how often factors multiply in it."""

    expression: Expression
    value: float
    degree: int = 1


def parse(text: str, values: Mapping[str, float]) -> Expression:
    """The expression of a text.

    Args:
        text: A cell as written.
        values: Every name that may occur, with its value; NaN for a value that isn't known.

    Returns:
        The expression as written, numbers exact, `10 deg` as `10*(pi/180)`.

    Raises:
        CellError: The text is something else than arithmetic, or has no finite value.
    """
    check_tokens(text, values)
    body = text.lstrip(" ")
    shift = len(text) - len(body)
    try:
        tree = ast.parse(multiply_degrees(body), mode="eval")
    except SyntaxError as error:
        for found in _WORD.finditer(text):
            word = found[0]
            if not keyword.iskeyword(word):
                continue
            if word in values:  # as a parameter's name it is refused already
                return Name(word)
            message = f"{quoted(word)} is a keyword of Python, no name"
            raise CellError(message, Span(found.start(), len(word))) from None
        if (unit := no_unit(text, values)) is not None:
            raise unit from None
        # Python gives 0 for the end of the text.
        end = len(text.rstrip(" ")) - 1
        column = min(error.offset - 1 + shift, end) if error.offset else end
        raise CellError(
            "not valid arithmetic: an operand or an operator is missing", Span(column)
        ) from None
    except (RecursionError, MemoryError):
        raise CellError(f"nested more than {MAX_DEPTH} deep", Span(0)) from None
    return _Parser(body, shift, values).part(tree.body, 0).expression


def nearest(word: str, valid: tuple[str, ...]) -> str:
    """The end of a message about a wrong word: what was probably meant, and what is possible."""
    # Who mistypes a word mostly gets its first letter right, and so 'inf' is no 'sin'.
    alike = [name for name in valid if name[:1].casefold() == word[:1].casefold()]
    same = [name for name in alike if name.casefold() == word.casefold()]
    close = same or difflib.get_close_matches(word[:40], alike, n=1)
    meant = f"; did you mean '{close[0]}'?" if close else ";"
    shown = ", ".join(valid[:16]) + (", ..." if len(valid) > 16 else "")
    return f"{meant} valid: {shown}"


@dataclass(frozen=True, slots=True)
class _Parser:
    """Python's tree to an Expression, values alongside so that a mistake is found at its place."""

    body: str
    shift: int
    values: Mapping[str, float]

    def part(self, node: ast.expr, depth: int) -> _Part:
        if depth > MAX_DEPTH:
            raise self._error(node, f"nested more than {MAX_DEPTH} deep")
        match node:
            case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
                # Tokens are ASCII and on one line; ast.get_source_segment would split lines again.
                number = Number(Fraction(self.body[node.col_offset : node.end_col_offset]))
                return _Part(number, float(number.value))
            case ast.Name(id=name):
                return self._name(node, name)
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                return self.part(operand, depth + 1)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                inner = self.part(operand, depth + 1)
                return _Part(Negate(inner.expression), -inner.value, inner.degree)
            case ast.BinOp(op=operator) if type(operator) in _OPERATORS:
                return self._binary(node, _OPERATORS[type(operator)], depth)
            case ast.Call(func=ast.Name(id=name)):
                return self._call(node, name, depth)
        raise self._error(node, f"not valid arithmetic: allowed are {ALLOWED}")

    def _name(self, node: ast.expr, name: str) -> _Part:
        if name == "pi":
            return _Part(Pi(), math.pi)
        if name == "deg":
            return _Part(DEGREE, math.pi / 180)
        if name in self.values:
            return _Part(Name(name), self.values[name])
        if name in FUNCTIONS:
            raise self._error(node, f"{name} needs an argument: {name}(...)")
        if name == "q":
            raise self._error(node, "the variable q is only allowed in theta or d of a joint")
        known = (each for each in self.values if not _NUMBERED.fullmatch(each))
        others = [each for each in self.values if _NUMBERED.fullmatch(each)]
        shown = [f"{others[0]} to {others[-1]}"] if len(others) > 3 else others
        valid = (*known, *shown, "pi", "deg", *FUNCTIONS)
        end = nearest(name, valid)
        if "q" in self.values and _VARIABLE.fullmatch(name):
            end = self._variable(name)
        elif _NUMBERED.fullmatch(name) and any(map(_NUMBERED.fullmatch, self.values)):
            end = self._numbered(name)
        message = f"unknown name {quoted(name)}{end}"
        if why := _NO_NUMBERS.get(name.lower()):
            message = f"{quoted(name)} is {why}"
        error = self._error(node, message)
        raise UnknownNameError(name, error.message, error.span)

    def _variable(self, name: str) -> str:
        """The end of a message about a joint variable that is called otherwise, or that is none."""
        number = re.sub(r"\D", "", name)
        others = [each for each in self.values if _NUMBERED.fullmatch(each)]
        if _NUMBERED.fullmatch(name) and self._is_passed(int(number)):
            return self._numbered(name)
        if f"q{number}" in others:
            return f": the variable of joint {number} is called q{number}"
        named = set(_VARIABLE.findall(self.body)) - (self.values.keys() - {"q"})
        if len(named) == 1 or not number or 1 <= int(number) <= len(others) + 1:
            return ": in every row the joint's own variable is called q"
        return f": there is no joint {int(number)}"

    def _numbered(self, name: str) -> str:
        """The end of a message about the variable of a row that has none."""
        number = int(name[1:])
        passed = f": row {number} has no q, and so no variable"
        return passed if self._is_passed(number) else f": there is no joint {number}"

    def _is_passed(self, number: int) -> bool:
        """Whether variables have lower and higher numbers, and none this one."""
        numbers = [int(each[1:]) for each in self.values if _NUMBERED.fullmatch(each)]
        return number >= 1 and number not in numbers and number < max(numbers, default=0)

    def _binary(self, node: ast.BinOp, operator: Operator, depth: int) -> _Part:
        left = self.part(node.left, depth + 1)
        if operator == "**":
            return self._power(node, left)
        right = self.part(node.right, depth + 1)
        expression = Binary(operator, left.expression, right.expression)
        value = self._value(node, Binary(operator, Name("l"), Name("r")), left.value, right.value)
        degree = left.degree + right.degree if operator in "*/" else max(left.degree, right.degree)
        return self._bounded(node, _Part(expression, value, degree))

    def _power(self, node: ast.BinOp, left: _Part) -> _Part:
        match node.right:
            case ast.Constant(value=int(exponent)) if not isinstance(exponent, bool):
                right: Expression = Number(Fraction(exponent))
            case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int(exponent))):
                right = Negate(Number(Fraction(exponent)))
            case _:
                exponent = MAX_EXPONENT + 1
        if exponent > MAX_EXPONENT:
            message = f"an exponent must be a whole number from -{MAX_EXPONENT} to {MAX_EXPONENT}"
            raise self._error(node.right, message)
        value = self._value(node, Binary("**", Name("l"), right), left.value)
        expression = Binary("**", left.expression, right)
        return self._bounded(node, _Part(expression, value, left.degree * max(1, exponent)))

    def _call(self, node: ast.Call, name: str, depth: int) -> _Part:
        function = next((f for f in FUNCTIONS if f == name), None)
        if function is None:
            message = f"unknown function {quoted(name)}{nearest(name, FUNCTIONS)}"
            raise self._error(node.func, message)
        if len(node.args) != 1 or node.keywords:
            raise self._error(node, f"{name} takes one argument")
        argument = self.part(node.args[0], depth + 1)
        value = self._value(node, Call(function, Name("l")), argument.value)
        return _Part(Call(function, argument.expression), value, argument.degree)

    def _value(self, node: ast.expr, form: Expression, left: float, right: float = 0.0) -> float:
        """The value of one operation on known operands."""
        try:
            value = evaluate(form, {"l": left, "r": right})
        except ZeroDivisionError:
            raise self._error(node, "division by zero") from None
        except ValueError:
            raise self._error(node, f"square root of a negative number ({left:.6g})") from None
        except OverflowError:
            value = math.inf
        if math.isinf(value):
            raise self._error(node, "the value is too large")
        return value

    def _bounded(self, node: ast.expr, part: _Part) -> _Part:
        if part.degree > MAX_DEGREE:
            raise self._error(node, f"this multiplies more than {MAX_DEGREE} factors")
        return part

    def _error(self, node: ast.expr, message: str) -> CellError:
        end = node.end_col_offset or node.col_offset + 1
        return CellError(message, Span(node.col_offset + self.shift, end - node.col_offset))

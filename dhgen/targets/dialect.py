"""Expressions as text: one printer, and for each language the words in which it differs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

from dhgen.program.ir import Apply, Integer, Joint, Pose, Variable

if TYPE_CHECKING:
    from dhgen.program.ir import Expression

# How tightly a text binds: an operand that binds more loosely than its place gets parentheses.
CHOICE, DISJUNCTION, CONJUNCTION, NEGATION, RELATION, SUM, PRODUCT, UNARY, ATOM = range(9)

INFIX = {
    "add": ("+", SUM),
    "sub": ("-", SUM),
    "mul": ("*", PRODUCT),
    "div": ("/", PRODUCT),
    "less": ("<", RELATION),
    "at_most": ("<=", RELATION),
}


@dataclass(frozen=True, slots=True)
class NamedText:
    """A value that gets a name.

    Attributes:
        name: The name.
        value: As it is written.
        truth: Whether it is a truth value.
    """

    name: str
    value: str
    truth: bool


class Dialect(Protocol):
    """How one language writes what others write differently."""

    def pose(self, row: int, column: int) -> str:
        """An entry of the given pose, from 1."""
        ...

    def joint(self, number: int, role: str) -> str:
        """A joint value that the caller gives, from 1."""
        ...

    def function(self, operator: str) -> str:
        """The name of a function of real numbers."""
        ...

    def conjunction(self) -> str:
        """The word for and."""
        ...

    def disjunction(self) -> str:
        """The word for or."""
        ...

    def negation(self) -> str:
        """The operator before a denied truth value."""
        ...

    def choice(self, condition: str, yes: str, no: str) -> str:
        """yes if condition else no."""
        ...


def expression_text(expression: Expression, dialect: Dialect) -> str:
    """An expression with no more parentheses than it needs."""
    return _text(expression, dialect)[0]


def _text(expression: Expression, dialect: Dialect) -> tuple[str, int]:
    match expression:
        case Variable(name):
            return name, ATOM
        case Integer(value):
            return f"{value}.0", ATOM if value >= 0 else UNARY
        case Pose(row, column):
            return dialect.pose(row, column), ATOM
        case Joint(number, role):
            return dialect.joint(number, role), ATOM
        case Apply(operator, operands):
            return _apply(operator, operands, dialect)


def _apply(operator: str, operands: tuple[Expression, ...], dialect: Dialect) -> tuple[str, int]:
    def part(place: int, least: int, unlike: int | None = None) -> str:
        text, binds = _text(operands[place], dialect)
        return text if binds >= least and binds != unlike else f"({text})"

    if operator in INFIX:
        sign, binds = INFIX[operator]
        # subtraction and division are not associative, and rounding makes no operator so
        return f"{part(0, binds)} {sign} {part(1, binds + 1)}", binds
    match operator:
        case "neg":
            inner = part(0, UNARY)  # two signs in a row are another operator in C
            return f"-({inner})" if inner.startswith("-") else f"-{inner}", UNARY
        case "and":
            return f"{part(0, CONJUNCTION)} {dialect.conjunction()} {part(1, CONJUNCTION)}", (
                CONJUNCTION
            )
        case "or":
            # compilers warn of an unbracketed conjunction here
            first, second = part(0, DISJUNCTION, CONJUNCTION), part(1, DISJUNCTION, CONJUNCTION)
            return f"{first} {dialect.disjunction()} {second}", DISJUNCTION
        case "not":
            return f"{dialect.negation()}{part(0, UNARY)}", NEGATION
        case "select":
            choice = dialect.choice(part(0, NEGATION), part(1, CHOICE + 1), part(2, CHOICE + 1))
            return choice, CHOICE
        case _:
            inner = ", ".join(part(place, CHOICE) for place in range(len(operands)))
            return f"{dialect.function(operator)}({inner})", ATOM

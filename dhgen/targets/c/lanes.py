"""Expressions in C whose values are lanes: GNU vectors, and plain numbers among them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.program.ir import Apply, Integer, Joint, Let, Pose, Variable
from dhgen.program.role import LIMIT_SLACK, LimitEnd
from dhgen.program.walk import expressions
from dhgen.targets.c.declared import Declaration
from dhgen.targets.c.language import C
from dhgen.targets.c.turns import TurnReader
from dhgen.targets.dialect import ATOM, CHOICE, INFIX, UNARY

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.program.ir import Expression, Program

LIBRARY = C()
PREFIX = "dhgen_"  # of the runtime's names
NEVER_SCALAR = frozenset({"atan2"})  # taken in lanes also where one would do
_BITS = {"and": "&", "or": "|"}
MAXIMUM = f"{PREFIX}maximum_double"
QUOTIENT = "DHGEN_QUOTIENT"
_OPPOSITE = {"add": "-", "sub": "+"}  # what is written of a sum with a product that begins with -


@dataclass(frozen=True, slots=True)
class Text:
    """An expression.

    Attributes:
        text: As it is written.
        binds: How tightly it binds, as in `dialect`.
        lanes: Whether it is a vector.
        joined: What joins its parts if they are truth values.
    """

    text: str
    binds: int
    lanes: bool
    joined: str = ""

    def within(self, least: int) -> str:
        """With parentheses where something binds this tightly."""
        return self.text if self.binds >= least else f"({self.text})"


class LaneText:
    """Prints expressions.

    Args:
        vector: The name of the vector type.
        program: Whose values they are.
        wide: Whether the lanes are poses, so that everything but constants is a vector.
    """

    def __init__(self, vector: str, program: Program, *, wide: bool) -> None:
        self._vector = vector
        self._wide = wide
        roles = {c.name: c.role for c in program.constants}
        self._limits = {name: r for name, r in roles.items() if isinstance(r, LimitEnd)}
        self._limit_slack = {
            c.name: repr(c.value) for c in program.constants if c.role == LIMIT_SLACK
        }
        self._turns = TurnReader(program)
        self._lanes = dict.fromkeys(roles, False)
        self._lanes |= {axis.name: True for axis in program.axes}

    def let(self, statement: Let) -> Declaration:
        """What gives a value its name."""
        value = self.text(statement.expression)
        self._lanes[statement.name] = value.lanes
        scalar = "int" if statement.truth else "double"
        vector = f"{PREFIX}{self._vector}{'_mask' if statement.truth else ''}"
        return Declaration(vector if value.lanes else scalar, statement.name, value.text)

    def declare(self, name: str, *, lanes: bool) -> None:
        """A value got its name elsewhere."""
        self._lanes[name] = lanes

    def vector(self, expression: Expression) -> str:
        """An expression as a vector."""
        return self._all(self.text(expression)).text

    def mask(self, expression: Expression) -> str:
        """A condition for all lanes."""
        return self._everywhere(self.text(expression)).text

    def text(self, expression: Expression) -> Text:
        """An expression."""
        match expression:
            case Variable(name) if value := self._limit_slack.get(name):
                return Text(value, ATOM, self._lanes[name])
            case Variable(name) if limit := self._limits.get(name):
                limited = f"{PREFIX}{limit.end}({joint_text(limit.joint)})"
                return Text(limited, ATOM, self._lanes[name])
            case Variable(name) if name in self._turns.names:
                return Text(self._turns.names[name], ATOM, self._lanes[name])
            case Variable(name):
                return Text(name, ATOM, self._lanes[name])
            case Integer(value):
                return Text(f"{value}.0", ATOM if value >= 0 else UNARY, lanes=False)
            case Pose(row, column):
                return Text(LIBRARY.pose(row, column), ATOM, self._wide)
            case Joint(number, role):
                return Text(LIBRARY.joint(number, role), ATOM, self._wide)
            case Apply(operator, operands):
                named = self._named(expression)
                if named is not None:
                    return named
                return self._apply(operator, [self.text(operand) for operand in operands])

    def _named(self, expression: Apply) -> Text | None:
        """What has a name in C, although programs write it out."""
        match expression:
            case Apply("sqrt", (Integer(value),)) if value < 0:
                return Text(
                    "DHGEN_NAN", ATOM, lanes=False
                )  # compilers would take the root every time
            case Apply(operator, parts) if (test := self._of_limits(operator, parts)) is not None:
                return test
        turned = self._turns.read(expression)
        if turned is None or not (angle := self.text(turned.angle)).lanes:
            return None
        return self._call(turned.function, angle.text)

    def _call(self, function: str, *arguments: str) -> Text:
        """A call of the runtime's function for the vectors at hand."""
        text = f"{PREFIX}{function}_{self._vector}({', '.join(arguments)})"
        return Text(text, ATOM, lanes=True)

    def _of_limits(self, operator: str, parts: tuple[Expression, ...]) -> Text | None:
        """How values in lanes compare with limits, by a function."""
        match operator, parts:
            case "maximum", (Apply("sub", (low, value)), Apply("sub", (again, high))):
                joint = self._limited_joint(low, high) if value == again else None
                return self._limit_call("beyond", value, joint) if joint else None
            case "sub", (Apply("abs", (value,)), Variable(name)):
                limit = self._limits.get(name)
                return self._limit_call("exceeds", value, limit.joint) if limit else None
            case "at_most", (Apply("abs", (Apply("sub", (value, half)),)), Variable(name)):
                within_slack = half == parts[1] and name in self._limit_slack
                return self._limit_call("within_slack", value) if within_slack else None
            case _:
                return None

    def _limit_call(self, function: str, value: Expression, *others: int) -> Text | None:
        inside = self.text(value)
        if not inside.lanes:
            return None
        return self._call(function, inside.text, *map(joint_text, others))

    def _limited_joint(self, low: Expression, high: Expression) -> int | None:
        """The number of the joint of which these are the limits."""
        match low, high:
            case Variable(least), Variable(most) if limit := self._limits.get(least):
                both = limit.end == "low" and self._limits.get(most) == replace(limit, end="high")
                return limit.joint if both else None
        return None

    def _apply(self, operator: str, parts: list[Text]) -> Text:
        lanes = operator in NEVER_SCALAR or any(part.lanes for part in parts)
        if operator in INFIX:
            return self._infix(operator, *parts)
        match operator:
            case "neg":
                return Text(f"-{parts[0].within(ATOM)}", UNARY, lanes)
            case "and" | "or":
                sign = _BITS[operator]
                both = [self._everywhere(part) if lanes else part for part in parts]
                texts = [each.text if each.joined == sign else each.within(ATOM) for each in both]
                return Text(f" {sign} ".join(texts), CHOICE, lanes, sign)
            case "not":
                return Text(f"{parts[0].within(ATOM)} == 0", CHOICE, lanes)
            case "select":
                if not lanes:
                    choice = LIBRARY.choice(*(part.within(ATOM) for part in parts))
                    return Text(choice, CHOICE, lanes)
                mask, (yes, no) = self._everywhere(parts[0]), parts[1:]
                if no.text == "0.0" and not yes.lanes:
                    return self._call("only", mask.text, yes.text)
                if yes.text == "0.0" and not no.lanes:
                    denied = f"{mask.within(ATOM)} == 0"
                    return self._call("only", denied, no.text)
                arguments = [mask, self._all(yes), self._all(no)]
            case "copysign" if lanes and not parts[0].lanes:
                return self._call("signed", parts[0].text, parts[1].text)
            case _:
                arguments = [self._all(part) if lanes else part for part in parts]
        listed = ", ".join(argument.text for argument in arguments)
        return Text(f"{self._function(operator, lanes=lanes)}({listed})", ATOM, lanes)

    def _infix(self, operator: str, first: Text, second: Text) -> Text:
        lanes = first.lanes or second.lanes
        if operator == "div":
            return Text(f"{QUOTIENT}({first.text}, {second.text})", ATOM, lanes)
        sign, binds = INFIX[operator]
        if operator in _OPPOSITE and second.text[0] == "-" and second.binds > binds:
            sign, second = _OPPOSITE[operator], Text(second.text[1:], second.binds, second.lanes)
        text = f"{first.within(binds)} {sign} {second.within(binds + 1)}"
        return Text(text, binds, lanes)

    def _function(self, operator: str, *, lanes: bool) -> str:
        if not lanes:
            return MAXIMUM if operator == "maximum" else LIBRARY.function(operator)
        return f"{PREFIX}{'pick' if operator == 'select' else operator}_{self._vector}"

    def _all(self, part: Text) -> Text:
        """A number in all lanes."""
        return part if part.lanes else self._call("all", part.text)

    def _everywhere(self, part: Text) -> Text:
        """A truth value in all lanes."""
        if part.lanes:
            return part
        return self._call("where", part.text)


def joint_text(number: int) -> str:
    """A joint of the arm's table, from 1."""
    return f"joints + {number - 1}" if number > 1 else "joints"


def operators(program: Program) -> Iterable[str]:
    """All operators of a program, each as often as it occurs."""
    return (each.operator for each in expressions(program) if isinstance(each, Apply))

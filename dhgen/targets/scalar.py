"""Programs as lines of a scalar language: loops over signs, one statement a value."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from dhgen.program.ir import (
    Apply,
    Failure,
    Guard,
    Heading,
    Let,
    Pose,
    Roots,
    Variable,
)
from dhgen.program.walk import expressions
from dhgen.targets.dialect import Dialect, NamedText, expression_text
from dhgen.targets.layout import WIDTH, wrapped
from dhgen.targets.nest import Loop, nest

if TYPE_CHECKING:
    from dhgen.program.ir import Axis, Choice, Expression, Program
    from dhgen.targets.nest import Nested


class ScalarLanguage(Dialect, Protocol):
    """The statements of a scalar language, each as its lines."""

    def comment(self, text: str, indent: str) -> str:
        """A comment."""
        ...

    def lets(self, values: list[NamedText], indent: str) -> list[str]:
        """Values get their names, one after another."""
        ...

    def leave(self, condition: str, why: str, depth: int, losses: list[str]) -> list[str]:
        """Ends this branch where the condition holds, after noting what was lost."""
        ...

    def lose(self, choice: Choice, row: str, margin: str, value: str | None) -> list[str]:
        """Notes that a row was lost after a joint was chosen, or had nearly this value."""
        ...

    def roots(self, axis: Axis, coefficients: list[str]) -> list[str]:
        """Finds the roots of a polynomial."""
        ...

    def open_loop(self, loop: Loop) -> list[str]:
        """The head of a loop over a sign; its last line is followed by the indented body."""
        ...

    def close_loop(self) -> list[str]:
        """The end of a loop."""
        ...

    def store(self, program: Program) -> list[str]:
        """Writes the joint values of one row."""
        ...

    def broken(self, line: str, indent: str) -> list[str]:
        """A statement that is too long for one line."""
        ...


def solver_lines(program: Program, language: ScalarLanguage, indent: str) -> list[str]:
    """The body of a solver, indented; not of one that finds all joints at once."""
    return _Printer(program, language).lines(nest(program), 0, indent)


def straight_lines(program: Program, language: ScalarLanguage, indent: str) -> list[str]:
    """The body of a program without signs, without its results."""
    return _Printer(program, language).body(nest(program), 0, indent)


def output_texts(program: Program, language: ScalarLanguage) -> list[str]:
    """The results of a program as expressions."""
    return [expression_text(output, language) for output in program.outputs]


def pose_entries(program: Program) -> list[Pose]:
    """The entries of the pose that a program reads, row by row."""
    found = {each for each in expressions(program) if isinstance(each, Pose)}
    return sorted(found, key=lambda entry: (entry.row, entry.column))


def row_text(program: Program, depth: int) -> str:
    """The number of the first row of the branches at this depth."""
    axes = range(len(program.axes))
    strides = [program.combinations(axes[place + 1 :]) for place in range(depth)]
    terms = [
        f"{stride} * i{place + 1}" if stride > 1 else f"i{place + 1}"
        for place, stride in enumerate(strides)
    ]
    return " + ".join(terms) or "0"


def close_name(axis: Axis) -> str:
    """The array that marks which roots of a polynomial nearly meet another."""
    return f"{axis.name}_close"


def close_texts(program: Program) -> list[str]:
    """Whether the row at hand comes from roots that nearly meet, or a joint is nearly free."""
    places = [statement.axis for statement in program.body if isinstance(statement, Roots)]
    roots = [f"{close_name(program.axes[place])}[i{place + 1}]" for place in places]
    return [*roots, *program.near] if roots else []


_REASONS = {
    Failure.REACH: "out of reach",
    Failure.ENDLESS: "out of reach",
    Failure.MERGED: "both signs give the same",
    Failure.INCONSISTENT: "the arm can't take this pose",
}


class _Printer:
    def __init__(self, program: Program, language: ScalarLanguage) -> None:
        self._program = program
        self._language = language
        self._signs = {axis.name for axis in program.axes}

    def lines(self, nodes: tuple[Nested, ...], depth: int, indent: str) -> list[str]:
        lines = self.body(nodes, depth, indent)
        if depth == len(self._program.axes):
            for line in _indented(self._language.store(self._program), indent):
                fits = len(line) <= WIDTH
                lines += [line] if fits else self._language.broken(line, indent)
        while lines and not lines[0]:
            lines = lines[1:]
        return lines

    def body(self, nodes: tuple[Nested, ...], depth: int, indent: str) -> list[str]:
        lines: list[str] = []
        values: list[NamedText] = []
        for node in nodes:
            if isinstance(node, Let):
                value = expression_text(node.expression, self._language)
                values.append(NamedText(node.name, value, node.truth))
            else:
                lines += self._language.lets(values, indent)
                values = []
                lines += self._other(node, depth, indent)
        return lines + self._language.lets(values, indent)

    def _other(self, node: Guard | Roots | Heading | Loop, depth: int, indent: str) -> list[str]:
        language = self._language
        match node:
            case Heading(text, detail):
                return ["", language.comment(f"{text}, {detail}" if detail else text, indent)]
            case Roots(axis, coefficients):
                texts = [expression_text(each, language) for each in coefficients]
                lines = _indented(language.roots(self._program.axes[axis], texts), indent)
                return [part for line in lines for part in wrapped(line, indent)]
            case Guard():
                return _indented(self._guard(node, depth), indent)
            case Loop(body=body):
                inner = self.lines(body, depth + 1, indent + "    ")
                head = _indented(language.open_loop(node), indent)
                return ["", *head, *inner, *_indented(language.close_loop(), indent)]

    def _guard(self, guard: Guard, depth: int) -> list[str]:
        language = self._language
        losses: list[str] = []
        if guard.chosen and guard.margin is not None:
            row = row_text(self._program, depth)
            margin = expression_text(guard.margin, language)
            for choice in guard.chosen:
                value = None if choice.value is None else expression_text(choice.value, language)
                losses += language.lose(choice, row, margin, value)
        condition = expression_text(self._denied(guard.condition), language)
        return language.leave(condition, _REASONS[guard.failure], depth, losses)

    def _denied(self, condition: Expression) -> Expression:
        """The opposite of a truth value, without a `not` before a comparison of signs."""
        match condition:
            case Apply("not", (inner,)):
                return inner
            case Apply("or", (left, right)):
                return Apply("and", (self._denied(left), self._denied(right)))
            case Apply("less", (zero, Variable(name) as sign)) if name in self._signs:
                return Apply("less", (sign, zero))
            case _:
                return Apply("not", (condition,))


def _indented(lines: list[str], indent: str) -> list[str]:
    return [indent + line if line else "" for line in lines]

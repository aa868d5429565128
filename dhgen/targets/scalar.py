"""Programs as lines of a scalar language: loops over signs, one statement a value."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING, Protocol

from dhgen.program.ir import Apply, Failure, Guard, Heading, Let, Variable
from dhgen.targets.dialect import Dialect, expression_text
from dhgen.targets.nest import Loop, nest

if TYPE_CHECKING:
    from dhgen.program.ir import Expression, NamedConstant, Program
    from dhgen.targets.nest import Nested

WIDTH = 100


class ScalarLanguage(Dialect, Protocol):
    """The statements of a scalar language, each as its lines."""

    def comment(self, text: str) -> str:
        """A comment line."""
        ...

    def let(self, name: str, value: str, *, truth: bool) -> str:
        """A value gets its name."""
        ...

    def leave(self, condition: str, depth: int, losses: list[str]) -> list[str]:
        """Ends this branch where the condition holds, after noting what was lost."""
        ...

    def lose(self, flags: list[tuple[int, str]], row: str, margin: str) -> list[str]:
        """Notes that a row was lost after a joint was chosen."""
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
    """The body of a solver, indented."""
    return _Printer(program, language).lines(nest(program), 0, indent)


def straight_lines(program: Program, language: ScalarLanguage, indent: str) -> list[str]:
    """The body of a program without signs, without its results."""
    printer = _Printer(program, language)
    return [line for node in nest(program) for line in printer.node(node, 0, indent)]


def output_texts(program: Program, language: ScalarLanguage) -> list[str]:
    """The results of a program as expressions."""
    return [expression_text(output, language) for output in program.outputs]


def row_text(program: Program, depth: int) -> str:
    """The number of the first row of the branches at this depth."""
    axes = len(program.axes)
    terms = [
        f"{2 ** (axes - place - 1)} * i{place + 1}" if place < axes - 1 else f"i{place + 1}"
        for place in range(depth)
    ]
    return " + ".join(terms) or "0"


class _Printer:
    def __init__(self, program: Program, language: ScalarLanguage) -> None:
        self._program = program
        self._language = language
        self._signs = {axis.name for axis in program.axes}

    def lines(self, nodes: tuple[Nested, ...], depth: int, indent: str) -> list[str]:
        lines = [line for node in nodes for line in self.node(node, depth, indent)]
        if depth == len(self._program.axes):
            lines += _indented(self._language.store(self._program), indent)
        return lines

    def node(self, node: Nested, depth: int, indent: str) -> list[str]:
        language = self._language
        match node:
            case Heading(text):
                return ["", indent + language.comment(text)]
            case Let(name, expression, _, truth):
                value = expression_text(expression, language)
                line = indent + language.let(name, value, truth=truth)
                return [line] if len(line) <= WIDTH else language.broken(line, indent)
            case Guard():
                return _indented(self._guard(node, depth), indent)
            case Loop(body=body):
                inner = self.lines(body, depth + 1, indent + "    ")
                while inner and not inner[0]:
                    inner = inner[1:]
                head = _indented(language.open_loop(node), indent)
                return ["", *head, *inner, *_indented(language.close_loop(), indent)]

    def _guard(self, guard: Guard, depth: int) -> list[str]:
        language = self._language
        losses: list[str] = []
        if guard.failure is Failure.REACH and guard.chosen and guard.margin is not None:
            flags = [
                (joint, name)
                for joint, expression in self._program.free
                for name in guard.chosen
                if name in _flag_parts(self._program, expression)
            ]
            margin = expression_text(guard.margin, language)
            losses = language.lose(flags, row_text(self._program, depth), margin)
        condition = expression_text(self._denied(guard.condition), language)
        return language.leave(condition, depth, losses)

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


def _flag_parts(program: Program, flag: str) -> set[str]:
    """The truth values that a joint's flag is made of."""
    lets = {s.name: s.expression for s in program.body if isinstance(s, Let)}
    parts: set[str] = set()
    pending: list[Expression] = [Variable(flag)]
    while pending:
        expression = pending.pop()
        if isinstance(expression, Variable):
            parts.add(expression.name)
            inner = lets.get(expression.name)
            if isinstance(inner, Apply) and inner.operator == "or":
                pending.append(inner)
        elif isinstance(expression, Apply) and expression.operator == "or":
            pending += expression.operands
    return parts


def _indented(lines: list[str], indent: str) -> list[str]:
    return [indent + line if line else "" for line in lines]


def wrapped(line: str, indent: str, hanging: str = "    ") -> list[str]:
    """A line broken at spaces."""
    return textwrap.wrap(
        line,
        WIDTH,
        initial_indent="",
        subsequent_indent=indent + hanging,
        break_long_words=False,
        break_on_hyphens=False,
        drop_whitespace=True,
    )


def merged_constants(*programs: Program) -> tuple[NamedConstant, ...]:
    """The constants of several programs, each once."""
    merged: dict[str, NamedConstant] = {}
    for program in programs:
        for constant in program.constants:
            merged.setdefault(constant.name, constant)
    return tuple(merged.values())

"""Python as a scalar language, in the part that numba compiles."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.families import follows
from dhgen.targets.layout import WIDTH, paragraph, wrapped
from dhgen.targets.python.assignments import broken, side_by_side
from dhgen.targets.scalar import close_name, close_texts, output_texts, row_text

if TYPE_CHECKING:
    from dhgen.program.ir import Axis, Choice, Program
    from dhgen.targets.dialect import NamedText
    from dhgen.targets.nest import Loop

_FUNCTIONS = {
    "abs": "abs",
    "sqrt": "math.sqrt",
    "copysign": "math.copysign",
    "atan2": "_atan2",
    "sin": "math.sin",
    "cos": "math.cos",
    "wrap": "_wrap",
    "maximum": "max",
}


MOST_WORDS = 4  # of an axis in a comment


class Python:
    """Python, in the part that numba compiles."""

    def pose(self, row: int, column: int) -> str:
        """An entry of the pose."""
        return f"T{row}{column}"

    def joint(self, number: int, role: str) -> str:
        """A joint value of the caller."""
        array = {"seed": "seed", "free": "q_free", "q": "q"}[role]
        return f"{array}[{number - 1}]"

    def function(self, operator: str) -> str:
        """The name of a function."""
        return _FUNCTIONS[operator]

    def conjunction(self) -> str:
        """And."""
        return "and"

    def disjunction(self) -> str:
        """Or."""
        return "or"

    def negation(self) -> str:
        """Not."""
        return "not "

    def choice(self, condition: str, yes: str, no: str) -> str:
        """A conditional expression."""
        return f"{yes} if {condition} else {no}"

    def comment(self, text: str, indent: str) -> str:
        """A comment, in as many lines as it needs."""
        return f"{indent}# {paragraph(text, f'{indent}# ')}"

    def lets(self, values: list[NamedText], indent: str) -> list[str]:
        """Assignments."""
        values_by_name = ((each.name, each.value) for each in values)
        return side_by_side(values_by_name, indent, follows=follows)

    def leave(self, condition: str, why: str, depth: int, losses: list[str]) -> list[str]:
        """Leaves the loop body, or the function outside of loops."""
        jump = f"{'continue' if depth else 'return'}  # {why}"
        width = WIDTH - 4 * (depth + 1)
        head = [f"if {condition}:"]
        if len(head[0]) > width:
            inside = wrapped(f"    {condition}", "", "    ", width)
            head = ["if (", *inside, "):"]
        return [*head, *(f"    {line}" for line in losses), f"    {jump}"]

    def lose(self, choice: Choice, row: str, margin: str, value: str | None) -> list[str]:
        """Notes the joint, by how much the branch failed, and the joint's value if nearly free."""
        kind = "_status.LOST" if value is None else "_status.NEARLY"
        kept = [] if value is None else [f"    q[{row}, 1] = {value}"]
        return [
            f"if {choice.flag}:",
            f"    status[{row}] = {kind} + {choice.joint}",
            f"    q[{row}, 0] = {margin}",
            *kept,
        ]

    def roots(self, axis: Axis, coefficients: list[str]) -> list[str]:
        """The roots of a polynomial as an array."""
        given = ", ".join([*coefficients, "moved"])
        return [f"{axis.name}_roots, {close_name(axis)} = _circle_roots({given})"]

    def open_loop(self, loop: Loop) -> list[str]:
        """A loop over a sign or the roots of a polynomial."""
        index, name = f"i{loop.place + 1}", loop.axis.name
        value = f"1.0 - 2.0 * {index}" if loop.is_sign else f"{name}_roots[{index}]"
        meaning, count = loop.axis.words, loop.axis.count
        words = ", ".join(meaning) if count <= MOST_WORDS else f"{meaning[0]} to {meaning[-1]}"
        return [
            f"for {index} in range({count}):  # {words}",
            f"    {name} = {value}",
        ]

    def close_loop(self) -> list[str]:
        """Nothing: the indentation ends."""
        return []

    def store(self, program: Program) -> list[str]:
        """One row of results."""
        lines = [f"row = {row_text(program, len(program.axes))}"]
        values = enumerate(output_texts(program, self))
        lines += side_by_side(((f"q[row, {place}]", value) for place, value in values), "")
        flags = " or ".join(dict.fromkeys(name for _, name in program.free))
        close = " or ".join(close_texts(program))
        solved = f"_status.CLOSE if {close} else OK" if close else "OK"
        solved = f"FREE_JOINT if {flags} else {solved}" if flags else solved
        return [*lines, f"status[row] = {solved}"]

    def broken(self, line: str, indent: str) -> list[str]:
        """Python may be broken inside parentheses."""
        return broken(line, indent)

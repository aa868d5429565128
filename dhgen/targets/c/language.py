"""C99 as a scalar language: the words in which its solvers are written."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.program.ir import Pose
from dhgen.program.walk import expressions
from dhgen.targets.c.declared import Declaration, declared
from dhgen.targets.layout import INDENT, WIDTH, packed, wrapped
from dhgen.targets.scalar import close_name, close_texts, output_texts, row_text

if TYPE_CHECKING:
    from dhgen.program.ir import Axis, Choice, Program
    from dhgen.targets.dialect import NamedText
    from dhgen.targets.nest import Loop

_FUNCTIONS = {
    "abs": "fabs",
    "sqrt": "sqrt",
    "atan2": "atan2",
    "copysign": "copysign",
    "sin": "sin",
    "cos": "cos",
    "wrap": "dhgen_wrap",
    "maximum": "fmax",
}


MOST_WORDS = 4  # of an axis in a comment


class C:
    """C99 as a scalar language."""

    def pose(self, row: int, column: int) -> str:
        """An entry of the pose."""
        return f"T{row}{column}"

    def joint(self, number: int, role: str) -> str:
        """A joint value of the caller."""
        array = {"seed": "seed", "free": "free_joints", "q": "q"}[role]
        return f"{array}[{number - 1}]"

    def function(self, operator: str) -> str:
        """The name in <math.h>."""
        return _FUNCTIONS[operator]

    def conjunction(self) -> str:
        """And."""
        return "&&"

    def disjunction(self) -> str:
        """Or."""
        return "||"

    def negation(self) -> str:
        """Not."""
        return "!"

    def choice(self, condition: str, yes: str, no: str) -> str:
        """A conditional expression."""
        return f"{condition} ? {yes} : {no}"

    def comment(self, text: str, indent: str) -> str:
        """A comment, which the last stage lays out in lines."""
        return f"{indent}/* {text} */"

    def lets(self, values: list[NamedText], indent: str) -> list[str]:
        """Constant locals."""
        kinds = ("int" if each.truth else "double" for each in values)
        pairs = zip(kinds, values, strict=True)
        return declared([Declaration(kind, v.name, v.value) for kind, v in pairs], indent)

    def leave(self, condition: str, why: str, depth: int, losses: list[str]) -> list[str]:
        """Leaves the loop body, or the function outside of loops."""
        jump = f"{'continue' if depth else 'return'}; /* {why} */"
        head = wrapped(f"if ({condition})", "", width=WIDTH - 4 * (depth + 1))
        if losses:
            return [*head[:-1], f"{head[-1]} {{", *(f"    {line}" for line in [*losses, jump]), "}"]
        line = f"{head[-1]} {jump}"
        fits = len(head) == 1 and 4 * (depth + 1) + len(line) <= WIDTH
        return [line] if fits else [*head, f"    {jump}"]

    def lose(self, choice: Choice, row: str, margin: str, value: str | None) -> list[str]:
        """Notes the joint, by how much the branch failed, and the joint's value if nearly free."""
        flag, place = choice.flag, f"q[{row}], &status[{row}]"
        if value is None:
            return [f"if ({flag}) dhgen_lose(DHGEN_LOST + {choice.joint}, {margin}, {place});"]
        return [
            f"if ({flag}) dhgen_lose(DHGEN_NEARLY + {choice.joint}, {margin}, {place});",
            f"if ({flag}) q[{row}][1] = {value};",
        ]

    def roots(self, axis: Axis, coefficients: list[str]) -> list[str]:
        """Fills an array with the roots of a polynomial."""
        name = f"{axis.name}_roots"
        close = close_name(axis)
        arguments = ", ".join([*coefficients, "moved", name, close])
        return [
            f"double {name}[{axis.count}];",
            f"int {close}[{axis.count}];",
            f"dhgen_circle_roots({arguments});",
        ]

    def open_loop(self, loop: Loop) -> list[str]:
        """A loop over a sign or the roots of a polynomial."""
        index, name, count = f"i{loop.place + 1}", loop.axis.name, loop.axis.count
        value = f"{index} == 0 ? 1.0 : -1.0" if loop.is_sign else f"{name}_roots[{index}]"
        meaning = loop.axis.words
        words = ", ".join(meaning) if count <= MOST_WORDS else f"{meaning[0]} to {meaning[-1]}"
        return [
            f"for (int {index} = 0; {index} < {count}; {index}++) {{ /* {words} */",
            f"    const double {name} = {value};",
        ]

    def close_loop(self) -> list[str]:
        """The closing brace."""
        return ["}"]

    def store(self, program: Program) -> list[str]:
        """One row of results."""
        values = enumerate(output_texts(program, self))
        pieces = [f"q[row][{place}] = {value};" for place, value in values]
        lines = [f"const int row = {row_text(program, len(program.axes))};"]
        lines += packed(pieces, "", width=WIDTH - 4 * (len(program.axes) + 1))
        flags = " || ".join(dict.fromkeys(name for _, name in program.free))
        close = " || ".join(close_texts(program))
        solved = f"{_grouped(close)} ? DHGEN_CLOSE : DHGEN_OK" if close else "DHGEN_OK"
        solved = f"{_grouped(flags)} ? DHGEN_FREE_JOINT : {solved}" if flags else solved
        return [*lines, f"status[row] = {solved};"]

    def broken(self, line: str, indent: str) -> list[str]:
        """C may be broken at any space."""
        return wrapped(line, indent)


def entry_lines(program: Program, number: str = "double") -> list[str]:
    """The entries of the pose get their names, where a program reads some."""
    reads = any(isinstance(each, Pose) for each in expressions(program))
    return [f"{INDENT}DHGEN_ENTRIES({number});"] if reads else []


def _grouped(truths: str) -> str:
    """Several truth values in brackets, one alone without."""
    return f"({truths})" if " " in truths else truths

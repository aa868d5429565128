"""The Python target: a module of numba functions that are plain Python where numba is absent."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.module import module_values
from dhgen.targets.scalar import (
    WIDTH,
    output_texts,
    row_text,
    solver_lines,
    straight_lines,
    wrapped,
)
from dhgen.targets.templates import render

if TYPE_CHECKING:
    from dhgen.program.ir import Program
    from dhgen.targets.module import SolverModule
    from dhgen.targets.nest import Loop

_FUNCTIONS = {
    "abs": "abs",
    "sqrt": "math.sqrt",
    "atan2": "math.atan2",
    "sin": "math.sin",
    "cos": "math.cos",
    "wrap": "wrap",
    "maximum": "max",
}


class Python:
    """Python, in the part that numba compiles."""

    def pose(self, row: int, column: int) -> str:
        """An entry of the pose."""
        return f"T[{row - 1}, {column - 1}]"

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

    def comment(self, text: str) -> str:
        """A comment line."""
        return f"# {text}"

    def let(self, name: str, value: str, *, truth: bool) -> str:
        """An assignment."""
        del truth
        return f"{name} = {value}"

    def leave(self, condition: str, depth: int, losses: list[str]) -> list[str]:
        """Leaves the loop body, or the function outside of loops."""
        jump = "continue" if depth else "return"
        return [f"if {condition}:", *(f"    {line}" for line in losses), f"    {jump}"]

    def lose(self, flags: list[tuple[int, str]], row: str, margin: str) -> list[str]:
        """Notes the joint that was chosen and by how much the branch then failed."""
        lines = []
        for number, name in flags:
            lines += [
                f"if {name}:",
                f"    status[{row}] = _LOST + {number}",
                f"    q[{row}, 0] = {margin}",
            ]
        return lines

    def open_loop(self, loop: Loop) -> list[str]:
        """A loop over a sign."""
        index = f"i{loop.place + 1}"
        plus, minus = loop.axis.meaning
        return [
            f"for {index} in range(2):  # {plus}, {minus}",
            f"    {loop.axis.name} = 1.0 - 2.0 * {index}",
        ]

    def close_loop(self) -> list[str]:
        """Nothing: the indentation ends."""
        return []

    def store(self, program: Program) -> list[str]:
        """One row of results."""
        lines = [f"row = {row_text(program, len(program.axes))}"]
        lines += [
            f"q[row, {place}] = {value}" for place, value in enumerate(output_texts(program, self))
        ]
        flags = " or ".join(name for _, name in program.free)
        return [*lines, f"status[row] = {f'FREE_JOINT if {flags} else OK' if flags else 'OK'}"]

    def broken(self, line: str, indent: str) -> list[str]:
        """Python may be broken inside parentheses."""
        name, value = line.strip().split(" = ", 1)
        inner = wrapped(f"{indent}    {value}", indent, "    ")
        assert all(len(part) <= WIDTH + len(indent) for part in inner)
        return [f"{indent}{name} = (", *inner, f"{indent})"]


def _cells(entries: list[str], columns: int) -> list[tuple[int, int, str]]:
    """Row, column and text of the entries that are not zero."""
    cells = [(*divmod(place, columns), entry) for place, entry in enumerate(entries)]
    return [cell for cell in cells if cell[2] != "0.0"]


def _limit_pairs(module: SolverModule) -> list[tuple[str, str]]:
    none = ("-math.inf", "math.inf")
    limits = [joint.limits for joint in module.chain.joints]
    return [(repr(pair[0]), repr(pair[1])) if pair else none for pair in limits]


def _free_texts(module: SolverModule) -> dict[str, str]:
    """The parameter for free joints, where there are any, with its comma."""
    count = len(module.chain.free)
    names = ("parameter", "argument", "argument_batch", "checked", "checked_batch")
    if not count:
        return {f"free_{name}": "" for name in names}
    return {
        "free_parameter": " q_free,",
        "free_argument": " q_free,",
        "free_argument_batch": " q_free[k],",
        "free_checked": f' _vector(q_free, {count}, "q_free"),',
        "free_checked_batch": " np.ascontiguousarray(q_free, np.float64),",
    }


def python_files(module: SolverModule) -> dict[str, str]:
    """The module by its name."""
    language = Python()
    values = module_values(module) | {
        **_free_texts(module),
        "limit_pairs": _limit_pairs(module),
        "solver": solver_lines(module.solver, language, "    "),
        "forward": straight_lines(module.forward, language, "    "),
        "forward_cells": _cells(output_texts(module.forward, language), 4),
        "jacobian": straight_lines(module.jacobian, language, "    "),
        "jacobian_cells": _cells(output_texts(module.jacobian, language), module.chain.dof),
    }
    return {f"{module.name}.py": render("python/solver.py.jinja", **values)}

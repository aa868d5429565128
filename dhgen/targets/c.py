"""The C target: a header and a C99 source that needs nothing but <math.h>."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.module import joint_types, module_values
from dhgen.targets.scalar import output_texts, row_text, solver_lines, straight_lines, wrapped
from dhgen.targets.templates import render

if TYPE_CHECKING:
    from dhgen.program.ir import Program
    from dhgen.targets.module import SolverModule
    from dhgen.targets.nest import Loop

_FUNCTIONS = {
    "abs": "fabs",
    "sqrt": "sqrt",
    "atan2": "atan2",
    "sin": "sin",
    "cos": "cos",
    "wrap": "wrap",
    "maximum": "fmax",
}


class C:
    """C99 as a scalar language."""

    def pose(self, row: int, column: int) -> str:
        """An entry of the pose, row-major."""
        return f"T[{4 * (row - 1) + column - 1}]"

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

    def comment(self, text: str) -> str:
        """A comment line."""
        return f"/* {text} */"

    def let(self, name: str, value: str, *, truth: bool) -> str:
        """A constant local."""
        return f"const {'int' if truth else 'double'} {name} = {value};"

    def leave(self, condition: str, depth: int, losses: list[str]) -> list[str]:
        """Leaves the loop body, or the function outside of loops."""
        jump = "continue;" if depth else "return;"
        if not losses:
            return [f"if ({condition}) {jump}"]
        return [f"if ({condition}) {{", *(f"    {line}" for line in losses), f"    {jump}", "}"]

    def lose(self, flags: list[tuple[int, str]], row: str, margin: str) -> list[str]:
        """Notes the joint that was chosen and by how much the branch then failed."""
        lines = []
        for number, name in flags:
            lines += [
                f"if ({name}) {{",
                f"    status[{row}] = LOST + {number};",
                f"    q[{row}][0] = {margin};",
                "}",
            ]
        return lines

    def open_loop(self, loop: Loop) -> list[str]:
        """A loop over a sign."""
        index, sign = f"i{loop.place + 1}", loop.axis.name
        plus, minus = loop.axis.meaning
        return [
            f"for (int {index} = 0; {index} < 2; {index}++) {{ /* {plus}, {minus} */",
            f"    const double {sign} = {index} == 0 ? 1.0 : -1.0;",
        ]

    def close_loop(self) -> list[str]:
        """The closing brace."""
        return ["}"]

    def store(self, program: Program) -> list[str]:
        """One row of results."""
        lines = [f"const int row = {row_text(program, len(program.axes))};"]
        lines += [
            f"q[row][{place}] = {value};" for place, value in enumerate(output_texts(program, self))
        ]
        flags = " || ".join(name for _, name in program.free)
        prefix = program.name.upper()
        status = f"{flags} ? {prefix}_FREE_JOINT : {prefix}_OK" if flags else f"{prefix}_OK"
        return [*lines, f"status[row] = {status};"]

    def broken(self, line: str, indent: str) -> list[str]:
        """C may be broken at any space."""
        return wrapped(line, indent)


def _assignments(array: str, entries: list[str], columns: int) -> list[str]:
    """A matrix, one of its rows after another, as statements of one line or more."""
    lines: list[str] = []
    for start in range(0, len(entries), columns):
        row = entries[start : start + columns]
        text = " ".join(f"{array}[{start + place}] = {entry};" for place, entry in enumerate(row))
        lines += wrapped(f"    {text}", "    ", "")
    return lines


def _free_texts(module: SolverModule) -> dict[str, str]:
    """The parameter for free joints, where there are any, with its comma."""
    count = len(module.chain.free)
    if not count:
        names = ("parameter", "parameter_batch", "argument", "argument_batch")
        return {f"free_{name}": "" for name in names}
    return {
        "free_parameter": f" const double free_joints[{count}],",
        "free_parameter_batch": " const double *free_joints,",
        "free_argument": " free_joints,",
        "free_argument_batch": f" free_joints + {count} * k,",
    }


def c_files(module: SolverModule) -> dict[str, str]:
    """The header and the source by their names."""
    language = C()
    dof = module.chain.dof
    values = module_values(module) | {
        **_free_texts(module),
        "revolute_flags": ", ".join("1" if kind == "R" else "0" for kind in joint_types(module)),
        "solver": solver_lines(module.solver, language, "    "),
        "forward": straight_lines(module.forward, language, "    "),
        "forward_rows": _assignments("T", output_texts(module.forward, language), 4),
        "jacobian": straight_lines(module.jacobian, language, "    "),
        "jacobian_rows": _assignments("J", output_texts(module.jacobian, language), dof),
    }
    return {
        f"{module.name}.h": render("c/solver.h.jinja", **values),
        f"{module.name}.c": render("c/solver.c.jinja", **values),
    }

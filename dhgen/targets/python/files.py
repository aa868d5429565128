"""The module of a robot: what its templates name in Python only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.printing.templates import named, render
from dhgen.program.regular.flatten import flatten
from dhgen.program.walk import finds_roots, uses, whole_arm
from dhgen.runtime.python import INTERFACE
from dhgen.targets.layout import INDENT, WIDTH, listed
from dhgen.targets.module import regular_solver
from dhgen.targets.python.assignments import side_by_side
from dhgen.targets.python.formulas import Formulas, formulas_of
from dhgen.targets.python.language import Python
from dhgen.targets.python.nearest import PythonNearest, python_nearest
from dhgen.targets.python.single_file import in_one_file
from dhgen.targets.python.texts import (
    PythonComments,
    PythonTables,
    python_comments,
    python_entries,
    python_tables,
    python_task,
)
from dhgen.targets.python.whole import Whole, python_whole
from dhgen.targets.scalar import pose_entries
from dhgen.targets.solver.bodies import Bodies, bodies_of
from dhgen.targets.solver.common import common_of

if TYPE_CHECKING:
    from dhgen.program.ir import Program
    from dhgen.targets.module import SolverModule

_CALLS = "_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver"


@dataclass(frozen=True, slots=True)
class PythonSolver:
    """What the templates of a solver name in Python only.

    Attributes:
        comments: The module's docstring and comments.
        tables: Its constants.
        entries: The names of the pose's entries, _ for those that the solver does not read.
        bodies: The programs.
        whole: What solves for all joints at once, where that is done.
        solver: What the runtime makes its functions of.
        regular: The formulas of regular poses, where there is a program for them.
        arctangent: Whether the solver takes arctangents.
        nearest: The nearest arm with a structure, where its rows are tried first.
    """

    comments: PythonComments
    tables: PythonTables
    entries: str
    bodies: Bodies
    whole: Whole | None
    solver: str
    regular: Formulas | None
    arctangent: bool
    nearest: PythonNearest | None


def python_files(module: SolverModule, *, single_file: bool = False) -> dict[str, str]:
    """The module by its name.

    Args:
        module: The robot.
        single_file: Whether it holds what it needs of the runtime.
    """
    common = common_of(module)
    solver = python_solver(module)
    text = render("python/solver.py.jinja", **named(common), **named(solver), interface=INTERFACE)
    return {f"{module.name}.py": in_one_file(text) if single_file else text}


def python_solver(module: SolverModule) -> PythonSolver:
    """What the templates name of a robot."""
    regular, nominal = regular_solver(module), module.nominal
    flat = None if regular is None else flatten(regular)
    near = None if nominal is None else flatten(nominal.regular)
    return PythonSolver(
        comments=python_comments(module),
        tables=python_tables(module, flat or near),
        entries=python_entries(module.solver),
        bodies=bodies_of(module, Python(), _assignments, _entries),
        whole=python_whole(module),
        solver=_solver(module, has_formulas=flat is not None),
        regular=None if flat is None else formulas_of(flat, module.chain.given),
        arctangent=uses(module.solver, "atan2") or nominal is not None,
        nearest=None if near is None else python_nearest(module, near),
    )


def _solver(module: SolverModule, *, has_formulas: bool) -> str:
    """What the runtime makes its functions of, but for what all robots have alike."""
    compiled, task = _compiled(module), module.chain.task
    counted = tuple(row in task.position_rows for row in range(3))
    fields = {
        "_ARM": True,
        f'"{python_task(task)}"': True,
        "_FORMULAS": has_formulas,
        f"counted={counted}": not all(counted),
        f"given={module.chain.given}": module.chain.given > 0,
        f"apart=({compiled})": bool(compiled),
        "at_once=True": whole_arm(module.solver) is not None,
    }
    called = [name for name, stands in fields.items() if stands]
    line = f"{_CALLS}({', '.join(called)}))"
    return line if len(line) <= WIDTH else "\n".join([f"{_CALLS}(", *listed(called, INDENT), "))"])


def _compiled(module: SolverModule) -> str:
    """What compiles the parts of the runtime that not all robots need."""
    needed = {
        "_whole.compile_apart,": whole_arm(module.solver) is not None,
        "_circle.OWN.compile_apart,": finds_roots(module.solver),
        '_runtime("complete").compile_apart,': module.solver.completion is not None,
    }
    return " ".join(name for name, does in needed.items() if does)


def _entries(program: Program) -> list[str]:
    """The entries of the pose get their names, from the matrix of a descent."""
    return [
        f"{INDENT}T{each.row}{each.column} = T[{each.row - 1}, {each.column - 1}]"
        for each in pose_entries(program)
    ]


def _assignments(array: str, entries: list[str], columns: int) -> list[str]:
    """A matrix of zeros, its other entries one after another."""
    lines: list[str] = []
    for first in range(0, len(entries), columns):
        row = enumerate(entries[first : first + columns])
        named = [
            (f"{array}[{first // columns}, {place}]", entry)
            for place, entry in row
            if entry != "0.0"
        ]
        lines += side_by_side(named, INDENT)
    return lines

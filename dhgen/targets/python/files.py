"""The module of a robot: what its templates name in Python only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.printing.templates import named, render
from dhgen.program.regular.flatten import flatten
from dhgen.runtime.python import INTERFACE
from dhgen.targets.layout import INDENT
from dhgen.targets.module import regular_solver
from dhgen.targets.python.formulas import Formulas, formulas_of
from dhgen.targets.python.language import Python
from dhgen.targets.python.texts import (
    PythonComments,
    PythonPose,
    PythonTables,
    python_comments,
    python_pose,
    python_tables,
)
from dhgen.targets.python.whole import IN_PYTHON
from dhgen.targets.scalar import pose_entries
from dhgen.targets.solver.bodies import Bodies, bodies_of
from dhgen.targets.solver.calls import Calls
from dhgen.targets.solver.common import common_of
from dhgen.targets.solver.parts import Parts, parts_of
from dhgen.targets.walk import uses

if TYPE_CHECKING:
    from dhgen.program.ir import Program
    from dhgen.targets.module import SolverModule
    from dhgen.targets.solver.common import Common


@dataclass(frozen=True, slots=True)
class PythonSolver:
    """What the templates of a solver name in Python only.

    Attributes:
        comments: What the module says of itself.
        tables: Its constants.
        pose: How a pose is read.
        calls: How functions are called and compiled.
        bodies: The programs.
        parts: Functions that have templates of their own.
        regular: The formulas of regular poses, where there is a program for them.
        arctangent: Whether the solver takes arctangents.
    """

    comments: PythonComments
    tables: PythonTables
    pose: PythonPose
    calls: Calls
    bodies: Bodies
    parts: Parts
    regular: Formulas | None
    arctangent: bool


def python_files(module: SolverModule) -> dict[str, str]:
    """The module by its name."""
    common = common_of(module)
    solver = python_solver(module, common)
    text = render("python/solver.py.jinja", **named(common), **named(solver), interface=INTERFACE)
    return {f"{module.name}.py": text}


def python_solver(module: SolverModule, common: Common) -> PythonSolver:
    """What the templates name of a robot."""
    regular = regular_solver(module)
    flat = None if regular is None else flatten(regular)
    calls = Calls(free_parameter=", q_free", free_argument=", q_free")
    return PythonSolver(
        comments=python_comments(module, flat),
        tables=python_tables(module, flat),
        pose=python_pose(module),
        calls=calls,
        bodies=bodies_of(module, Python(), _assignments, _entries),
        parts=parts_of(module, common, calls, IN_PYTHON),
        regular=None if flat is None else formulas_of(flat, module.chain.given),
        arctangent=uses(module.solver, "atan2"),
    )


def _entries(program: Program) -> list[str]:
    """The entries of the pose get their names, from the matrix of a descent."""
    return [
        f"{INDENT}T{each.row}{each.column} = T[{each.row - 1}, {each.column - 1}]"
        for each in pose_entries(program)
    ]


def _assignments(array: str, entries: list[str], columns: int) -> list[str]:
    """A matrix of zeros, its other entries one after another."""
    places = [divmod(place, columns) for place in range(len(entries))]
    return [
        f"{INDENT}{array}[{row}, {column}] = {entry}"
        for (row, column), entry in zip(places, entries, strict=True)
        if entry != "0.0"
    ]

"""The module of a robot: what its templates name in Python only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.printing.templates import named, render
from dhgen.program.regular.flatten import flatten
from dhgen.program.walk import finds_roots, uses, whole_arm
from dhgen.runtime.python import INTERFACE
from dhgen.targets.layout import INDENT
from dhgen.targets.module import regular_solver
from dhgen.targets.python.assignments import side_by_side
from dhgen.targets.python.formulas import Formulas, formulas_of
from dhgen.targets.python.language import Python
from dhgen.targets.python.nearest import PythonNearest, python_nearest
from dhgen.targets.python.single_file import in_one_file
from dhgen.targets.python.texts import (
    PythonComments,
    PythonPose,
    PythonTables,
    python_comments,
    python_pose,
    python_tables,
)
from dhgen.targets.python.whole import Whole, python_whole
from dhgen.targets.scalar import pose_entries
from dhgen.targets.solver.bodies import Bodies, bodies_of
from dhgen.targets.solver.common import common_of

if TYPE_CHECKING:
    from dhgen.program.ir import Program
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class PythonSolver:
    """What the templates of a solver name in Python only.

    Attributes:
        comments: What the module says of itself.
        tables: Its constants.
        pose: How a pose is read.
        bodies: The programs.
        whole: What solves for all joints at once, where that is done.
        functions: Those that the runtime calls, by their names.
        compiled: Those that compile parts of the runtime that only some robots need.
        regular: The formulas of regular poses, where there is a program for them.
        arctangent: Whether the solver takes arctangents.
        nearest: The nearest arm with a structure, where its rows are tried first.
    """

    comments: PythonComments
    tables: PythonTables
    pose: PythonPose
    bodies: Bodies
    whole: Whole | None
    functions: str
    compiled: str
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
        comments=python_comments(module, flat),
        tables=python_tables(module, flat or near),
        pose=python_pose(module),
        bodies=bodies_of(module, Python(), _assignments, _entries),
        whole=python_whole(module),
        functions=_functions(module),
        compiled=_compiled(module),
        regular=None if flat is None else formulas_of(flat, module.chain.given),
        arctangent=uses(module.solver, "atan2") or nominal is not None,
        nearest=None if near is None else python_nearest(module, near),
    )


def _functions(module: SolverModule) -> str:
    """The functions that the runtime calls, in its order, by their names."""
    ours = ["_solve", "fk", "jacobian"]
    if module.plane_miss is not None:
        ours += ["arm_angle", "_arm_angle_miss"]
    return ", ".join([*(f'"{name}"' for name in ours), *["None"] * (5 - len(ours))])


def _compiled(module: SolverModule) -> str:
    """What compiles the parts of the runtime that not all robots need."""
    needed = {
        "_whole.compile_apart,": whole_arm(module.solver) is not None,
        "_circle.OWN.compile_apart,": finds_roots(module.solver),
        '_runtime("complete").compile_apart,': module.solver.tightened is not None,
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

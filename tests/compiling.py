"""Robot files compiled, written to a folder, and their C as a library."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.atomic_write import write_files
from dhgen.compiler import Compilation, compile_loaded
from dhgen.robot_files import RobotFile
from dhgen.verify.native import PORTABLE, Build, CompiledSolver, compile_solver

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.targets.module import SolverModule


def compile_file(path: Path) -> Compilation:
    """What the compiler makes of a robot file."""
    return compile_loaded(RobotFile.read(path))


def written(path: Path, folder: Path) -> Compilation:
    """The same, its files in a folder."""
    compilation = compile_file(path)
    write_files(folder, compilation.files)
    return compilation


def library(module: SolverModule, folder: Path, build: Build = PORTABLE) -> CompiledSolver:
    """The C of a robot, as it lies in a folder."""
    shape = module.chain.dof, module.solver.rows, module.chain.given
    source = folder / f"{module.name}.c"
    solver = compile_solver(source, folder, module.name, *shape, build)
    assert solver is not None, "the tests need a C compiler"
    return solver

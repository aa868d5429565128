"""Robot files compiled, written to a folder, and their C as a library."""

from __future__ import annotations

import subprocess
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING
from unittest.mock import patch

import numba

import dhgen.compiler
import dhgen.solved
from dhgen.atomic_write import write_files
from dhgen.compiler import Compilation, compile_loaded, source_name, worked_out
from dhgen.robot_files import RobotFile
from dhgen.runtime import runtime_files
from dhgen.verify.native import (
    C_FLAGS,
    PORTABLE,
    Build,
    CompiledSolver,
    c_compiler,
    compile_solver,
)
from tests.derived import derived
from tests.headers import VECTORS, read_before
from tests.kept import made_once

if TYPE_CHECKING:
    from collections.abc import Mapping

    import pytest

    from dhgen.derivation.story import Story
    from dhgen.targets.module import SolverModule

# What a test demands of a command or of the library it demands of any poses: that verification sees
# what is wrong is shown in tests/verify, with as many as there always are.
FEW = 4
PLAIN_C = Build("plain", ("-O0",))  # in place of the build for this machine, at a fifth of its time
RUNTIME = Path(__file__).resolve().parents[1] / "generated" / "dhgen"


def verify_little(patch: pytest.MonkeyPatch) -> None:
    """Verification in plain Python, with few poses, and C that is compiled in no time."""
    patch.setattr(numba.config, "DISABLE_JIT", True)
    patch.setattr("dhgen.verify.verify.COUNT", FEW)
    patch.setattr("dhgen.verify.verify.NATIVE", PLAIN_C)


def compile_file(path: Path) -> Compilation:
    """What the compiler makes of a robot file."""
    with patch.object(dhgen.compiler, "worked_out", worked_out_once):
        return compile_loaded(RobotFile.read(path))


def module_of(path: Path) -> SolverModule:
    """The programs alone, of which no text is made."""
    return worked_out_once(RobotFile.read(path))[1]


def worked_out_once(
    file: RobotFile, _: object = None, *, out: Path | None = None
) -> tuple[Story, SolverModule]:
    """What is worked out of a text under the name that its files say, once in this process."""
    return _worked_out(replace(file, path=Path(source_name(file.path, out))))


@cache
def _worked_out(file: RobotFile) -> tuple[Story, SolverModule]:
    with patch.object(dhgen.solved, "derive", derived):
        return worked_out(file)


def solvers_of(path: Path) -> Compilation:
    """The same without the derivation, which takes a third of the time."""
    with patch.object(dhgen.compiler, "derivation_files", lambda *_: {}):
        return compile_file(path)


def written(path: Path, folder: Path) -> Compilation:
    """Its solvers in a folder."""
    compilation = solvers_of(path)
    write_new(folder, compilation.files)
    return compilation


def write_new(folder: Path, files: Mapping[str, str]) -> None:
    """Files in a folder; the runtime's hundred only where they are not there yet."""
    known = runtime_files()
    new = {n: text for n, text in files.items() if n not in known or not (folder / n).exists()}
    write_files(folder, new)


def library(module: SolverModule, folder: Path, build: Build = PORTABLE) -> CompiledSolver:
    """The C of a robot, as it lies in a folder."""
    shape = module.chain.dof, module.solver.rows, module.chain.given
    source = folder / f"{module.name}.c"
    text = source.read_text("utf-8")
    # A library that is open stays what it was when another takes its place.
    assert _OPEN.setdefault((source, build), text) == text, f"{source}: another arm has this name"
    solver = compile_solver(source, folder, module.name, *shape, sharing(source, build))
    assert solver is not None, "the tests need a C compiler"
    return solver


_OPEN: dict[tuple[Path, Build], str] = {}  # what was compiled where


def sharing(source: Path, build: Build) -> Build:
    """A build in which arms share what takes longer than they: vectors, the general runtime."""
    return with_vectors(build) if _parts(source) == ("dhgen",) else shared(source, build)


def shared(source: Path, build: Build) -> Build:
    """The same in which closed forms share their runtime, too."""
    build = with_vectors(build)
    compiler = build.compiler or c_compiler()
    assert compiler is not None, "the tests need a C compiler"
    # What is defined for the robot alone says nothing to the runtime.
    alike = tuple(each for each in build.flags if not each.startswith("-D") or "-DDHGEN" in each)
    objects = (_runtime(part, compiler, alike) for part in _parts(source))
    return replace(build, flags=(*build.flags, "-DDHGEN_SHARED", *objects))


def _parts(source: Path) -> tuple[str, ...]:
    """The files of the runtime that a robot's C needs where it is shared."""
    text = source.read_text("utf-8")
    more = any(f'#include "dhgen/{name}.h"' in text for name in ("general", "numerical"))
    return ("dhgen", "general") if more else ("dhgen",)


def with_vectors(build: Build) -> Build:
    """A build that has read the compiler's vectors, where it is for a machine that has any."""
    if not any(flag.startswith(("-march", "-mavx")) for flag in build.flags):
        return build
    compiler = build.compiler or c_compiler()
    assert compiler is not None, "the tests need a C compiler"
    read = read_before(compiler, VECTORS, *C_FLAGS, "-fPIC", *build.flags)
    return replace(build, flags=(*build.flags, *read))


@cache
def _runtime(part: str, compiler: str, flags: tuple[str, ...]) -> str:
    """A part of the runtime, compiled once in a run."""
    command = (compiler, "-std=c99", *flags, "-fPIC", "-DDHGEN_SHARED", "-c")
    source = str(RUNTIME / f"{part}.c")

    def compile_part(folder: Path) -> None:
        subprocess.run([*command, "-o", str(folder / "made.o"), source], check=True)

    return str(made_once((*command, source), compile_part) / "made.o")

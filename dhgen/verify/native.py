"""The written files at work: the module imported, the C compiled and called."""

from __future__ import annotations

import ctypes
import importlib.util
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.errors import VerificationError

if TYPE_CHECKING:
    from pathlib import Path
    from types import ModuleType

    from numpy.typing import NDArray

    Array = NDArray[np.float64]

C_FLAGS = ("-std=c99", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")


def import_module(path: Path) -> ModuleType:
    """Imports a written module from its file, under a name of its own."""
    spec = importlib.util.spec_from_file_location(f"_dhgen_written_{path.stem}", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    try:
        spec.loader.exec_module(module)
    finally:
        del sys.modules[spec.name]
    return module


def c_compiler() -> str | None:
    """The C compiler: $CC, or cc, gcc or clang; None without one."""
    for name in (os.environ.get("CC"), "cc", "gcc", "clang"):
        if name and (found := shutil.which(name)):
            return found
    return None


@dataclass(frozen=True, slots=True)
class CompiledSolver:
    """The functions of a compiled solver.

    Attributes:
        library: The shared library.
        name: The robot's identifier.
        dof: Number of joints.
        rows: Number of branches.
        free: Number of joints whose value the caller gives.
    """

    library: Any
    name: str
    dof: int
    rows: int
    free: int

    def fk(self, q: Array) -> Array:
        """The pose (4, 4) of joint values (n,)."""
        T = np.empty((4, 4))
        self.library[f"{self.name}_fk"](_pointer(q), _pointer(T))
        return T

    def jacobian(self, q: Array) -> Array:
        """The Jacobian (6, n)."""
        J = np.empty((6, self.dof))
        self.library[f"{self.name}_jacobian"](_pointer(q), _pointer(J))
        return J

    def ik(
        self, T: Array, seed: Array, free: Array | None = None
    ) -> tuple[Array, NDArray[np.uint8]]:
        """All rows (B, n) and their statuses (B,)."""
        q = np.empty((self.rows, self.dof))
        status = np.empty(self.rows, np.uint8)
        given = [] if free is None else [_pointer(np.ascontiguousarray(free, np.float64))]
        pose = np.ascontiguousarray(T, np.float64)
        self.library[f"{self.name}_ik"](
            _pointer(pose), *given, _pointer(seed), _pointer(q), _pointer(status)
        )
        return q, status

    def nearest(self, T: Array, seed: Array, free: Array | None = None) -> Array:
        """The row nearest to the seed (n,), NaN without one."""
        q = np.empty(self.dof)
        given = [] if free is None else [np.ascontiguousarray(free, np.float64)]
        arrays = [np.ascontiguousarray(T, np.float64), *given, seed, q]
        self.library[f"{self.name}_ik_nearest"](*map(_pointer, arrays))
        return q


def compile_solver(
    source: Path, folder: Path, name: str, dof: int, rows: int, free: int
) -> CompiledSolver | None:
    """Compiles a written C file, warnings as errors; None without a compiler.

    Raises:
        VerificationError: The compiler refuses the file.
    """
    compiler = c_compiler()
    if compiler is None:
        return None
    library = folder / f"{name}.so"
    command = [compiler, *C_FLAGS, "-shared", "-fPIC", str(source), "-o", str(library), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)  # noqa: S603
    if done.returncode != 0:
        raise VerificationError(f"{source.name} does not compile:\n{done.stderr}")
    return CompiledSolver(ctypes.CDLL(str(library)), name, dof, rows, free)


def _pointer(array: NDArray[Any]) -> Any:  # noqa: ANN401 - ctypes has no type for it
    return array.ctypes.data_as(ctypes.c_void_p)

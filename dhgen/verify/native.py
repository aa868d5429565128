"""The written files at work: the module imported, the C compiled and called."""

from __future__ import annotations

import ctypes
import importlib.util
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.errors import CompilerError, VerificationError
from dhgen.runtime import PYTHON, python_runtime_files
from dhgen.runtime import python as runtime

if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import ModuleType

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray


C_FLAGS = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")
NOTHING = """\
#include <math.h>
double nothing(double x);
double nothing(double x) { return sin(x); }
"""
FAST_FLAGS = ("-fno-math-errno", "-fno-trapping-math", "-ffp-contract=fast")


@dataclass(frozen=True, slots=True)
class Build:
    """A way of compiling a solver.

    Attributes:
        name: Distinguishes it from others.
        flags: For the compiler.
        compiler: Its path, if it is not the first one found.
    """

    name: str
    flags: tuple[str, ...]
    compiler: str | None = None


PORTABLE = Build("portable", ("-O0",))
NATIVE = Build("native", ("-O2", "-march=native", *FAST_FLAGS))


def import_module(path: Path, *, lend: bool = True) -> ModuleType:
    """Imports a written module from its file, under a name of its own.

    Nothing of the runtime beside it remains registered either: the folder may be a passing one.
    Where that is the compiler's own, it is imported from there: numba keeps there what it compiles
    of it.

    Args:
        path: The module.
        lend: Whether the compiler's own runtime may be taken.
    """
    folder = path.resolve().parent
    beside = str(folder).replace("%", "%25").replace(".", "%2E")  # as the module calls it
    spec = importlib.util.spec_from_file_location(f"_dhgen_written_{path.stem}", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    try:
        if lend and _is_own_runtime(folder):
            _load_own_runtime(f"{beside}.{PYTHON}")
        spec.loader.exec_module(module)
    finally:
        del sys.modules[spec.name]
        for name in [name for name in sys.modules if f"{name}.".startswith(f"{beside}.")]:
            del sys.modules[name]
    return module


def _is_own_runtime(folder: Path) -> bool:
    """Whether a folder holds the compiler's own runtime, and nothing else of that name."""
    found = sorted((folder / PYTHON).rglob("*.py"))
    expected = {folder / name: text for name, text in python_runtime_files().items()}
    return found == sorted(expected) and all(
        path.read_text("utf-8") == text for path, text in expected.items()
    )


def _load_own_runtime(name: str) -> None:
    """Loads the compiler's own Python runtime under a name."""
    own = Path(runtime.__file__).parent
    spec = importlib.util.spec_from_file_location(
        name, own / "__init__.py", submodule_search_locations=[str(own)]
    )
    assert spec is not None
    assert spec.loader is not None
    package = sys.modules[name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(package)


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

    def fk(self, q: FloatArray) -> FloatArray:
        """The pose (4, 4) of joint values (n,)."""
        T = np.empty((4, 4))
        self.library[f"{self.name}_fk"](_pointer(q), _pointer(T))
        return T

    def jacobian(self, q: FloatArray) -> FloatArray:
        """The Jacobian (6, n)."""
        J = np.empty((6, self.dof))
        self.library[f"{self.name}_jacobian"](_pointer(q), _pointer(J))
        return J

    def joint_velocities(self, q: FloatArray, twist: FloatArray) -> FloatArray:
        """The joint velocities (n,) of a twist (6,)."""
        found = np.empty(self.dof)
        function = self.library[f"{self.name}_joint_velocities"]
        function(_pointer(q), _pointer(twist), _pointer(found))
        return found

    def arm_angle(self, q: FloatArray) -> float:
        """The arm angle of joint values (n,)."""
        function = self.library[f"{self.name}_arm_angle"]
        function.restype = ctypes.c_double
        return float(function(_pointer(q)))

    def ik(
        self, T: FloatArray, seed: FloatArray, free: FloatArray | None = None
    ) -> tuple[FloatArray, NDArray[np.uint8]]:
        """All rows (B, n) and their statuses (B,)."""
        q = np.empty((self.rows, self.dof))
        status = np.empty(self.rows, np.uint8)
        given = [] if free is None else [_pointer(np.ascontiguousarray(free, np.float64))]
        pose = np.ascontiguousarray(T, np.float64)
        self.library[f"{self.name}_ik"](
            _pointer(pose), *given, _pointer(seed), _pointer(q), _pointer(status)
        )
        return q, status

    def batch(
        self, T: FloatArray, free: FloatArray | None = None
    ) -> tuple[FloatArray, NDArray[np.uint8]]:
        """All rows (N, B, n) and their statuses (N, B) of many poses (N, 4, 4)."""
        q = np.empty((len(T), self.rows, self.dof))
        status = np.empty((len(T), self.rows), np.uint8)
        given = [] if free is None else [_pointer(np.ascontiguousarray(free, np.float64))]
        poses = np.ascontiguousarray(T, np.float64)
        size = ctypes.c_size_t(len(T))
        self.library[f"{self.name}_ik_batch"](
            size, _pointer(poses), *given, _pointer(q), _pointer(status)
        )
        return q, status

    def nearest(
        self, T: FloatArray, seed: FloatArray, free: FloatArray | None = None
    ) -> FloatArray:
        """The row nearest to the seed (n,), NaN without one."""
        q = np.empty(self.dof)
        given = [] if free is None else [np.ascontiguousarray(free, np.float64)]
        arrays = [np.ascontiguousarray(T, np.float64), *given, seed, q]
        self.library[f"{self.name}_ik_nearest"](*map(_pointer, arrays))
        return q


def compile_solver(
    source: Path, folder: Path, name: str, dof: int, rows: int, free: int, build: Build = PORTABLE
) -> CompiledSolver | None:
    """Compiles a written C file, warnings as errors; None without a compiler.

    Args:
        source: The file.
        folder: Where the library goes.
        name: The robot's identifier.
        dof: Number of joints.
        rows: Number of branches.
        free: Number of joints whose value the caller gives.
        build: How it is compiled.

    Raises:
        VerificationError: The compiler refuses the file.
        CompilerError: It refuses any file.
    """
    compiler = build.compiler or c_compiler()
    if compiler is None:
        return None
    library = folder / f"{name}-{build.name}.so"
    if complaints := complaints_of(compiler, build.flags, [source], library):
        _demand_compiler(compiler, folder)
        raise VerificationError(f"{source.name} does not compile:\n{complaints}")
    return CompiledSolver(ctypes.CDLL(str(library)), name, dof, rows, free)


def complaints_of(
    compiler: str, flags: Sequence[str], sources: Sequence[Path], library: Path
) -> str:
    """Compiles files to a library in a passing folder, with warnings as errors.

    Args:
        compiler: Its path.
        flags: Those besides C_FLAGS.
        sources: The files.
        library: The library; what the compiler leaves behind where it is stopped is beside it.

    Returns:
        The compiler's messages, nothing where it succeeded.
    """
    made = ["-shared", "-fPIC", *map(str, sources), "-o", str(library)]
    command = [compiler, *C_FLAGS, *flags, *made]
    # Without a PATH it was found where the system keeps commands; it looks for its own in PATH.
    place = {"PATH": os.environ.get("PATH", os.defpath), "TMPDIR": str(library.parent)}
    done = subprocess.run(  # noqa: S603
        [*command, "-lm"], env=os.environ | place, capture_output=True, text=True, check=False
    )
    return done.stderr.strip() or "(it gives no reason)" if done.returncode else ""


def _demand_compiler(compiler: str, folder: Path) -> None:
    """CompilerError where it refuses a file of which it takes nothing but a library to refuse."""
    source = folder / "dhgen_nothing.c"
    source.write_text(NOTHING, encoding="utf-8")
    if errors := complaints_of(compiler, (), [source], source.with_suffix(".so")):
        raise CompilerError(
            f"the C compiler {compiler} can't build anything here:\n{errors}\n"
            "fix it, or set $CC to another compiler"
        )


def _pointer(array: NDArray[Any]) -> Any:  # noqa: ANN401 - ctypes has no type for it
    return array.ctypes.data_as(ctypes.c_void_p)

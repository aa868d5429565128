"""The pose helpers as their users get them: copied, compiled, and called alike.

Three libraries with the names of the Python module: "numba", "plain" (Python without numba) and
"c" (gcc's warnings on, through ctypes).
"""

from __future__ import annotations

import atexit
import ctypes
import importlib.util
import shutil
import subprocess
import sys
import tempfile
from contextlib import nullcontext
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any
from unittest.mock import patch

import numpy as np
import pytest

from dhgen.runtime.helpers import helper_files
from tests.structures import first_of

if TYPE_CHECKING:
    from _pytest.mark import ParameterSet

# numba takes seconds for what plain Python shows to be right; with one notation it always runs.
each_library = pytest.mark.parametrize("name", first_of(["plain", "c", "numba"], count=2))
both_pythons = pytest.mark.parametrize("name", first_of(["plain", "numba"]))

# The orientation of each notation: how many numbers each argument has, 0 for a lone number.
NOTATIONS: dict[str, tuple[int, ...]] = {
    "rpy": (3,),
    "quaternion_xyzw": (4,),
    "quaternion_wxyz": (4,),
    "axis_angle": (3, 0),
    "euler_zxz": (3,),
    "euler_zyz": (3,),
    "rotvec": (3,),
    "abc": (3,),
    "abc_deg": (3,),
    "wpr": (3,),
    "wpr_deg": (3,),
}


def numba_or(name: str) -> list[ParameterSet]:
    """A library and numba, each with every notation, as a test takes them."""
    numba = [("numba", notation) for notation in NOTATIONS]
    return [
        *first_of(((name, notation) for notation in NOTATIONS), count=len(NOTATIONS)),
        pytest.param(*numba[0], marks=pytest.mark.slow),
        *first_of(numba[1:], count=0),
    ]


FILES = ("dhgen_pose.py", "dhgen_pose.h", "dhgen_pose.c")

WARNINGS = (
    *("-std=c99", "-O2", "-Wall", "-Wextra", "-Wpedantic"),
    *("-Wconversion", "-Wshadow", "-Wdouble-promotion", "-Werror"),
)


@cache
def emitted() -> Path:
    """A folder with the three files, as a user has them."""
    folder = Path(tempfile.mkdtemp(prefix="dhgen_pose_"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    for name in FILES:
        (folder / name).write_text(helper_files()[name], encoding="utf-8")
    return folder


def compiler(name: str = "cc") -> str:
    """The path of a compiler; the test is skipped without one."""
    path = shutil.which(name)
    if path is None:
        pytest.skip(f"there is no {name} on this machine")
    return path


def run(*command: str | Path) -> None:
    """Run a command, showing what it wrote if it fails."""
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr


def library(name: str) -> Any:
    """One of the libraries; C is skipped where there is no compiler."""
    if name == "c":
        compiler()
        return _c_library()
    return _python_library(name)


@cache
def _python_library(name: str) -> Any:
    path = emitted() / "dhgen_pose.py"
    spec = importlib.util.spec_from_file_location(f"dhgen_pose_{name}", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    # None in sys.modules makes an import fail as if nothing were installed.
    with patch.dict(sys.modules, {"numba": None}) if name == "plain" else nullcontext():
        spec.loader.exec_module(module)
    return module


@cache
def _c_library() -> CLibrary:
    folder = emitted()
    shared = folder / "dhgen_pose.so"
    run(compiler(), *WARNINGS, "-fPIC", "-shared", "-o", shared, folder / "dhgen_pose.c", "-lm")
    return CLibrary(ctypes.CDLL(str(shared)))


class CLibrary:
    """The C functions under the names and with the arguments of the Python ones."""

    def __init__(self, shared: ctypes.CDLL) -> None:
        self.shared = shared

    def __getattr__(self, name: str) -> Any:
        function = getattr(self.shared, f"dhgen_pose_{name}")
        if name in {"multiply", "inverse"}:
            return lambda *poses: _make_pose(function, *poses)
        direction, notation = name.split("_xyz_")
        sizes = NOTATIONS[notation]
        if direction == "from":
            return lambda xyz, *orientation: _write(function, xyz, orientation)
        return lambda T: _read(function, T, sizes)


def call_c(function: Any, *arguments: Any) -> int:
    """Call a C function; arrays are passed as pointers, numbers by value."""
    converted = [
        argument.ctypes.data_as(ctypes.POINTER(ctypes.c_double))
        if isinstance(argument, np.ndarray)
        else ctypes.c_double(argument)
        for argument in arguments
    ]
    return int(function(*converted))


def _doubles(numbers: Any) -> Any:
    return (
        np.ascontiguousarray(numbers, dtype=float) if isinstance(numbers, np.ndarray) else numbers
    )


def _refuse(code: int, *outputs: Any) -> None:
    if code != 0:
        assert code < 0
        assert all(np.isnan(output).all() for output in outputs)
        raise ValueError(code)


def _write(function: Any, xyz: Any, orientation: tuple[Any, ...]) -> Any:
    return _make_pose(function, xyz, *orientation)


def _make_pose(function: Any, *given: Any) -> Any:
    T = np.full((4, 4), 7.0)
    code = call_c(function, *(_doubles(numbers) for numbers in given), T)
    _refuse(code, T)
    return T


def _read(function: Any, T: Any, sizes: tuple[int, ...]) -> tuple[Any, ...]:
    outputs = [np.full(max(size, 1), 7.0) for size in (3, *sizes)]
    code = call_c(function, _doubles(T), *outputs)
    _refuse(code, *outputs)
    return tuple(
        out if size else float(out[0]) for out, size in zip(outputs, (3, *sizes), strict=True)
    )


def write(of: Any, notation: str, xyz: Any, *orientation: Any) -> Any:
    """The pose of a position and an orientation in a notation."""
    return getattr(of, f"from_xyz_{notation}")(xyz, *orientation)


def read(of: Any, notation: str, T: Any) -> tuple[Any, ...]:
    """Position and orientation of a pose in a notation."""
    return tuple(getattr(of, f"to_xyz_{notation}")(T))

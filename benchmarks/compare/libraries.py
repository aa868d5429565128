"""The C of a folder, compiled with a driver that calls it for many poses at once."""

from __future__ import annotations

import ctypes
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks.memory import room
from dhgen.verify.native import c_compiler

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot

    # floats and whole numbers of every call, (N, ...) each
    Answer = tuple[NDArray[Any], NDArray[np.int64]]

DRIVER = Path(__file__).with_name("driver.c")


class BuildError(Exception):
    """The compiler rejects a file; the text is what it says."""


@dataclass(frozen=True, slots=True)
class Shape:
    """What a solver takes and gives.

    Attributes:
        name: Of its files and functions.
        dof: How many joints.
        rows: How many rows an answer has.
        given: How many numbers the caller gives besides the pose.
        angle: Whether that is the arm angle.
        free: The joints whose values the caller gives, from 0.
        single: Whether it computes in single precision.
    """

    name: str
    dof: int
    rows: int
    given: int
    angle: bool
    free: tuple[int, ...]
    single: bool

    @property
    def real(self) -> type[np.floating[Any]]:
        """The type of its numbers."""
        return np.float32 if self.single else np.float64


def shape_of(robot: Robot, folder: Path, *, single: bool = False) -> Shape:
    """What a robot's solver takes and gives: its header has the number of rows."""
    name = f"{robot.name}_f32" if single else robot.name
    header = (folder / f"{name}.h").read_text(encoding="utf-8")
    rows = header.partition(f"{name.upper()}_ROWS = ")[2].split(maxsplit=1)[0]
    free = tuple(joint - 1 for joint in robot.free)
    given = 1 if robot.arm_angle else len(free)
    return Shape(name, len(robot.joints), int(rows), given, robot.arm_angle, free, single)


def build(shape: Shape, folder: Path, flags: Sequence[str], library: Path) -> None:
    """Compiles a folder's solver and the driver into one library.

    Raises:
        BuildError: The compiler rejects it, or there is none.
    """
    compiler = c_compiler()
    if compiler is None:
        raise BuildError("there is no C compiler")
    defined = {
        "HEADER": f'"{shape.name}.h"',
        "ROBOT": shape.name,
        "UPPER": shape.name.upper(),
        "REAL": "float" if shape.single else "double",
        "GIVEN": str(shape.given),
    }
    macros = [f"-D{name}={text}" for name, text in defined.items()]
    command = [compiler, "-std=c99", *macros, f"-I{folder}", "-shared", "-fPIC", *flags]
    command += [str(folder / f"{shape.name}.c"), str(DRIVER), "-o", str(library), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise BuildError(f"{' '.join(command)}\n{done.stderr}")


class Library:
    """A compiled solver; arrays of N poses go in and come out."""

    def __init__(self, shape: Shape, path: Path) -> None:
        self.shape = shape
        self._calls = ctypes.CDLL(str(path))
        self._calls.compare_time.restype = ctypes.c_double

    def fk(self, q: FloatArray) -> NDArray[Any]:
        """Poses (N, 4, 4) of joint values (N, n)."""
        T = self._empty(len(q), 4, 4)
        self._calls.compare_fk(ctypes.c_size_t(len(q)), *map(_pointer, (self._reals(q), T)))
        return T

    def jacobian(self, q: FloatArray) -> NDArray[Any]:
        """Jacobians (N, 6, n) of joint values (N, n)."""
        J = self._empty(len(q), 6, self.shape.dof)
        self._calls.compare_jacobian(ctypes.c_size_t(len(q)), *map(_pointer, (self._reals(q), J)))
        return J

    def given(self, q: FloatArray) -> NDArray[Any]:
        """What the caller gives to be led to joint values (N, n), shape (N, k)."""
        reals = self._reals(q)
        if not self.shape.angle:
            return np.ascontiguousarray(reals[:, list(self.shape.free)])
        function = self._calls[f"{self.shape.name}_arm_angle"]
        function.restype = ctypes.c_float if self.shape.single else ctypes.c_double
        angles = [[function(_pointer(row))] for row in reals]
        return np.array(angles, self.shape.real)

    def ik(self, T: FloatArray, given: FloatArray, seed: FloatArray | None) -> Answer:
        """All rows of poses (N, 4, 4); statuses and, last, what is returned."""
        n, shape = len(T), self.shape
        q, status = self._empty(n, shape.rows, shape.dof), np.zeros((n, shape.rows), np.uint8)
        returned = np.zeros(n, np.int32)
        arrays = (self._reals(T), self._reals(given), None if seed is None else self._reals(seed))
        self._calls.compare_ik(ctypes.c_size_t(n), *map(_pointer, (*arrays, q, status, returned)))
        return q, np.column_stack([status, returned]).astype(np.int64)

    def nearest(self, T: FloatArray, given: FloatArray, seed: FloatArray) -> Answer:
        """The row nearest to a seed, and what is returned."""
        n = len(T)
        q, returned = self._empty(n, self.shape.dof), np.zeros(n, np.int32)
        arrays = map(self._reals, (T, given, seed))
        self._calls.compare_nearest(ctypes.c_size_t(n), *map(_pointer, (*arrays, q, returned)))
        return q, returned[:, None].astype(np.int64)

    def batch(self, T: FloatArray, given: FloatArray) -> Answer:
        """All rows of poses (N, 4, 4), and statuses."""
        n, shape = len(T), self.shape
        q, status = self._empty(n, shape.rows, shape.dof), np.zeros((n, shape.rows), np.uint8)
        arrays = map(self._reals, (T, given))
        self._calls.compare_batch(ctypes.c_size_t(n), *map(_pointer, (*arrays, q, status)))
        return q, status.astype(np.int64)

    def seconds(self, T: FloatArray, given: FloatArray, repeats: int, *, batch: bool) -> float:
        """CPU time of solving poses (N, 4, 4) so many times, at once or one after another."""
        n, shape = len(T), self.shape
        q = room((n, shape.rows, shape.dof)).astype(shape.real, copy=False)
        status = np.zeros((n, shape.rows), np.uint8)
        sizes = int(batch), ctypes.c_size_t(n), ctypes.c_size_t(repeats)
        arrays = self._reals(T), self._reals(given), q, status
        return float(self._calls.compare_time(*sizes, *map(_pointer, arrays)))

    def _empty(self, *size: int) -> NDArray[Any]:
        return np.full(size, np.nan, self.shape.real)

    def _reals(self, values: FloatArray) -> NDArray[Any]:
        return np.ascontiguousarray(values, self.shape.real)


def _pointer(array: NDArray[Any] | None) -> Any:  # noqa: ANN401 - ctypes has no type for it
    return None if array is None else array.ctypes.data_as(ctypes.c_void_p)

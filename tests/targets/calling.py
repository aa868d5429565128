"""The functions of a solver in both languages, called alike."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen import status as statuses
from tests.targets.made import in_c, in_python, robot, single_in_c

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.verify.native import CompiledSolver


OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = statuses.Status
HELD = statuses.HELD
LANGUAGES = ("C", "Python")


def gap(rows: FloatArray, q: FloatArray) -> FloatArray:
    """By how much each of some rows differs from joint values at most, whole turns aside."""
    off = rows - q
    return np.asarray(np.abs(off - 2 * np.pi * np.round(off / (2 * np.pi))).max(axis=-1))


def in_single(
    name: str, T: FloatArray, seed: FloatArray
) -> tuple[NDArray[np.float32], NDArray[np.uint8]]:
    """All rows and their statuses by a robot's C in single precision."""
    return in_single_by(single_in_c(name), T, seed)


def in_single_by(
    solver: CompiledSolver, T: FloatArray, seed: FloatArray
) -> tuple[NDArray[np.float32], NDArray[np.uint8]]:
    """The same by C that is compiled."""
    rows, status = np.empty((solver.rows, solver.dof), np.float32), np.empty(solver.rows, np.uint8)
    arrays = (T.astype(np.float32), seed.astype(np.float32), rows, status)
    pointers = (each.ctypes.data_as(ctypes.c_void_p) for each in arrays)
    solver.library[f"{solver.name}_ik"](*pointers)
    return rows, status


def nearest_in_single(name: str, T: FloatArray, seed: FloatArray) -> tuple[int, FloatArray]:
    """The nearest row by a robot's C in single precision, and its status or why there is none."""
    solver = single_in_c(name)
    q = np.empty(solver.dof, np.float32)
    arrays = (T.astype(np.float32), seed.astype(np.float32), q)
    pointers = (each.ctypes.data_as(ctypes.c_void_p) for each in arrays)
    return int(solver.library[f"{solver.name}_ik_nearest"](*pointers)), q.astype(float)


@dataclass(frozen=True, slots=True)
class Solver:
    """A robot's solver.

    Attributes:
        name: The robot.
        language: C or Python.
    """

    name: str
    language: str

    def all(
        self, T: FloatArray, seed: FloatArray | None = None, free: FloatArray | None = None
    ) -> tuple[FloatArray, NDArray[np.uint8]]:
        """All rows and their statuses."""
        given = [] if free is None else [free]
        if self.language == "Python":
            q, status = in_python(self.name).ik_all(T, *given, seed)
            return q, status
        zeros = np.zeros(len(robot(self.name).joints))
        return in_c(self.name).ik(T, zeros if seed is None else seed, *given)

    def batch(self, T: FloatArray, free: FloatArray) -> tuple[FloatArray, NDArray[np.uint8]]:
        """All rows of many poses and their statuses."""
        if self.language == "Python":
            q, status = in_python(self.name).ik_batch(T, free)
            return q, status
        return in_c(self.name).batch(T, free)

    def nearest(
        self, T: FloatArray, seed: FloatArray, free: FloatArray | None = None
    ) -> tuple[int, FloatArray]:
        """The nearest row, and its status or minus the reason why there is none."""
        given = [] if free is None else [free]
        if self.language == "Python":
            return _python_nearest(in_python(self.name), T, seed, given)
        q = np.empty(len(seed))
        arrays = [np.ascontiguousarray(a, np.float64) for a in (T, *given, seed, q)]
        function = in_c(self.name).library[f"{self.name}_ik_nearest"]
        result = function(*(a.ctypes.data_as(ctypes.c_void_p) for a in arrays))
        return int(result), arrays[-1]


def _python_nearest(
    module: Any, T: FloatArray, seed: FloatArray, given: list[FloatArray]
) -> tuple[int, FloatArray]:
    try:
        q = module.ik(T, *given, seed)
    except module.Unreachable as reason:
        beyond = "beyond the joint limits" in str(reason)
        return -(OUT_OF_LIMITS if beyond else UNREACHABLE), np.full(len(seed), np.nan)
    except ValueError:
        return -INVALID_POSE, np.full(len(seed), np.nan)
    return OK, q

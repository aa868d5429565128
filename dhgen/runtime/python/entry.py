# SPDX-License-Identifier: MIT
"""What the public functions of all robots do alike: kinematics, one solution, batches."""

from __future__ import annotations

import functools
import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from types import FunctionType
from typing import TYPE_CHECKING, Any

import numpy as np

from .arguments import (
    BYTE,
    FLOAT,
    array_of,
    demand_array,
    is_number,
    numbers,
    of_each,
    span,
)
from .coupled import coupled_nearest
from .jit import overload
from .nearest import nearest
from .places import COUPLING
from .status import INVALID_POSE, OUT_OF_LIMITS

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from .jit import Compiling

    FloatArray = NDArray[np.float64]
    Statuses = NDArray[np.uint8]

SHARE = 2048  # poses that are worth a thread


@dataclass(frozen=True, slots=True)
class Choice:
    """How one of many solutions is chosen, and the messages where there is none.

    Attributes:
        arm: The arm's numbers.
        branches: The name of every row.
        no_pose: What is wrong with a pose that is none.
        no_row: What is wrong with a pose without solutions.
        unreachable: The exception for such a pose.
    """

    arm: FloatArray
    branches: Sequence[str]
    no_pose: str
    no_row: str
    unreachable: type[ValueError]

    def rows(self, branch: Any, limits: Any) -> tuple[int, int]:  # noqa: ANN401
        """The rows of a branch.

        Raises:
            ValueError: There is no such branch, or limits is not True or False.
        """
        if not isinstance(limits, (bool, np.bool_)):
            raise ValueError(f"limits must be True or False, not {limits!r}")  # noqa: TRY004
        return span(branch, self.branches)

    def nearest(
        self,
        found: tuple[FloatArray, Statuses],
        q_seed: Any,  # noqa: ANN401
        rows: tuple[int, int],
        limits: bool,
    ) -> FloatArray:
        """The solution nearest to the seed among some rows.

        Args:
            found: What `ik_all` returned.
            q_seed: The seed, or None for zeros.
            rows: The first row, and the one after the last.
            limits: Whether joint limits count.

        Raises:
            ValueError: The pose is none.
            Unreachable: There is no such solution.
        """
        if found[1][0] == INVALID_POSE:
            raise ValueError(f"T is not a valid pose: {self.no_pose}")
        q, status = found[0][rows[0] : rows[1]], found[1][rows[0] : rows[1]]
        dof = q.shape[1]
        seed = np.zeros(dof) if q_seed is None else array_of(q_seed, (dof,), "q_seed")
        solution = np.empty(dof)
        if self.nearest_row(q, status, seed, limits, solution):
            return solution
        where = f" in branch {self.branches[rows[0]]}" if len(q) < len(self.branches) else ""
        beyond = OUT_OF_LIMITS in status
        why = "solutions found are beyond the joint limits" if beyond else self.no_row
        raise self.unreachable(why + where)

    def nearest_row(
        self, q: FloatArray, status: Statuses, seed: FloatArray, limits: bool, found: FloatArray
    ) -> bool:
        """The row nearest to a seed into `found`; whether there is one."""
        if self.arm[COUPLING] == 0.0:
            return nearest(self.arm, q, status, seed, limits, found)
        return coupled_nearest(self.arm, q, status, seed, limits, found)


def of_joints(how: Compiling, dof: int) -> Callable[[Callable[[Any], Any]], Callable[[Any], Any]]:
    """Compiles a function of joint values.

    Python calls it with any numbers, or with a stack of them for a stack of results; other numba
    functions with an array.

    Args:
        how: How the functions of the robot's file are compiled.
        dof: How many joint values.
    """
    wrong = f"q must hold {dof} joint values"

    def decorate(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
        @functools.wraps(function)
        def call(q: Any) -> Any:  # noqa: ANN401
            return of_each(compiled, q, dof)

        def inner(q: Any) -> Any:  # noqa: ANN401
            if len(q) != dof:
                raise ValueError(wrong)
            return compiled(q)

        # Of functions of one name in one module numba takes one for the other when both are cached.
        inner.__qualname__ = f"{function.__name__} of an array"
        compiled = how.jit(function)
        how.register(function.__name__, compiled, "(float64[::1],)")
        overload(call, strict=False)(lambda _: how.owned(inner))
        return call

    return decorate


def demand_filled(q: Any, status: Any, q_seed: Any, rows: tuple[int, int]) -> None:  # noqa: ANN401
    """Stops where an array is none that `ik_into` fills, or the seed none that it takes.

    Args:
        q: For joint values.
        status: For what each row holds.
        q_seed: The seed, or None.
        rows: Number of rows, and of joints.

    Raises:
        ValueError: The message says which array it is.
    """
    demand_array("q", q, rows, FLOAT)
    demand_array("status", status, rows[:1], BYTE)
    if q_seed is not None:
        demand_array("q_seed", q_seed, rows[1:], FLOAT)
    if not (q.flags.writeable and status.flags.writeable):
        raise ValueError("q and status are filled: they can't be read-only") from None


def poses_of(T: Any, cores: Any) -> FloatArray:  # noqa: ANN401
    """The poses of a batch.

    Raises:
        ValueError: They have the wrong shape, or cores is no number of threads.
    """
    poses = numbers(T, "(N, 4, 4)", "T")
    if poses.ndim != 3 or poses.shape[1:] != (4, 4):
        raise ValueError(f"T must have shape (N, 4, 4), not {np.shape(T)}")
    if cores is not None and not (is_number(cores) and cores >= 1):
        raise ValueError(f"cores must be at least 1, or None for all of them, not {cores!r}")
    return poses


def share(solve: Callable[..., None], cores: int | None, *arrays: NDArray[Any]) -> None:
    """Solves the rows of arrays, shared among threads."""
    shares = len(arrays[0]) // SHARE
    if shares > 1:  # asking for the cores takes longer than some poses
        shares = min(cores or os.cpu_count() or 1, shares)
    if shares > 1:
        with ThreadPoolExecutor(shares) as threads:
            list(threads.map(solve, *(np.array_split(array, shares) for array in arrays)))
    else:
        solve(*arrays)


def again(function: Any, names: dict[str, Any]) -> FunctionType:  # noqa: ANN401
    """A function once more, with other values of what it names."""
    made = FunctionType(function.__code__, names, function.__name__, function.__defaults__)
    made.__kwdefaults__ = function.__kwdefaults__
    return made

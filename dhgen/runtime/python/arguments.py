# SPDX-License-Identifier: MIT
"""What callers in Python may hand over: numbers in any form, arrays to be filled, rows by name."""

from __future__ import annotations

from collections import UserList
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    FloatArray = NDArray[np.float64]

FLOAT = np.dtype(np.float64)
BYTE = np.dtype(np.uint8)
NONE = type(None)


def numbers(values: Any, shape: object, name: str) -> FloatArray:  # noqa: ANN401
    """Values as a contiguous array of float64.

    Args:
        values: What the caller gave: an array, anything that numpy makes one of, or a transform of
            scipy's, which has `as_matrix`.
        shape: The shape that is wanted, for the message; not looked at.
        name: What the values are called in the message.

    Raises:
        ValueError: They are no real numbers.
    """
    values = _matrix_of(values, name)
    try:
        array = np.asarray(values, order="C")  # a number gets no axis: it has another shape
        if array.dtype != FLOAT:
            # numpy would drop imaginary parts, read texts and dates, and make NaN of None
            kind, objects = array.dtype.kind, array.ravel() if array.dtype.kind == "O" else ()
            if kind not in "biufO" or any(isinstance(o, (str, bytes, NONE)) for o in objects):
                raise TypeError  # noqa: TRY301  numpy raises the same where it refuses
            array = array.astype(FLOAT)
    except (TypeError, ValueError, OverflowError) as error:
        # an array of another library has a reason of its own: its device, or a type of its own
        why = f": {error}" if hasattr(values, "__array__") and str(error) else ""
        raise ValueError(f"{name} must hold real numbers, with shape {shape}{why}") from None
    return array


def _matrix_of(values: Any, name: str) -> Any:  # noqa: ANN401
    """What is a pose by its own words, as a matrix; all else as it is.

    Raises:
        ValueError: It is a rotation, which has no position.
    """
    if isinstance(values, UserList):  # spatialmath's: numpy would see the first pose alone
        return _poses_of(values, name)
    if isinstance(values, (list, tuple)) and any(isinstance(each, UserList) for each in values):
        return [pose for each in values for pose in _listed(_matrix_of(each, name))]
    if isinstance(values, (list, tuple)) and any(hasattr(each, "as_matrix") for each in values):
        return [_matrix_of(each, name) for each in values]
    if not hasattr(values, "as_matrix"):
        return values
    matrix = values.as_matrix()
    if np.shape(matrix)[-1:] == (3,):
        advice = f"put {name}.as_matrix() into the upper left of a matrix (4, 4)"
        raise ValueError(f"{name} is a rotation without a position: {advice}")
    return matrix


def _poses_of(values: UserList[Any], name: str) -> Any:  # noqa: ANN401
    poses = values.data
    if not poses:
        raise ValueError(f"{name} holds no pose")
    alone = len(poses) == 1 and np.shape(poses[0]) == (4, 4)
    return poses[0] if alone else poses


def _listed(poses: Any) -> Any:  # noqa: ANN401
    return [poses] if np.ndim(poses) == 2 else poses


def array_of(values: Any, shape: tuple[int, ...], name: str) -> FloatArray:  # noqa: ANN401
    """Values as a contiguous array of float64 with a given shape.

    Raises:
        ValueError: They are no real numbers, or have another shape.
    """
    array = numbers(values, shape, name)
    if array.shape != shape:
        many = "; ik_batch takes many poses" if array.shape[1:] == shape == (4, 4) else ""
        raise ValueError(f"{name} must have shape {shape}, not {array.shape}{many}") from None
    return array


def of_each(function: Callable[[FloatArray], Any], q: Any, dof: int) -> Any:  # noqa: ANN401
    """A function of joint values, or of each in a stack of them.

    Args:
        function: Gets an array (dof,).
        q: Joint values (dof,), or a stack (..., dof): then the results are stacked alike.
        dof: How many joint values.

    Raises:
        ValueError: They are no real numbers, or as many as there are joints.
    """
    array = numbers(q, (dof,), "q")
    if array.ndim < 2 or array.shape[-1] != dof:
        return function(array_of(array, (dof,), "q"))
    shape = np.shape(function(np.zeros(dof)))  # of none there is nothing to look at
    stack = np.empty((array.size // dof, *shape))
    for k, values in enumerate(array.reshape(-1, dof)):
        stack[k] = function(values)
    return stack.reshape(*array.shape[:-1], *shape)


def demand_array(name: str, array: Any, shape: tuple[int, ...], kind: np.dtype[Any]) -> None:  # noqa: ANN401
    """Stops where something is no array of a kind and shape.

    Raises:
        ValueError: The message says what it is instead.
    """
    plain = isinstance(array, np.ndarray) and not isinstance(array, np.ma.MaskedArray)
    if not plain or array.dtype != kind:  # a dtype equals some names of types
        got = array.dtype if plain else type(array).__name__
        raise ValueError(f"{name} must be an array of {kind}, not {got}") from None
    if array.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, not {array.shape}") from None


def results(out: Any, rows: tuple[int, int, int]) -> tuple[FloatArray, NDArray[np.uint8]]:  # noqa: ANN401
    """The arrays q and status of a batch: the caller's, or new ones.

    Args:
        out: The caller's pair of arrays, or None.
        rows: Number of poses, of rows a pose, and of joints.

    Raises:
        ValueError: The caller's arrays can't be filled.
    """
    if out is None:
        return np.empty(rows), np.empty(rows[:2], BYTE)
    if not isinstance(out, (tuple, list)) or len(out) != 2:
        raise ValueError("out must be (q, status), two arrays like those an earlier call returned")
    q, status = out
    for name, array, shape, kind in ("q", q, rows, FLOAT), ("status", status, rows[:2], BYTE):
        ready = isinstance(array, np.ndarray) and array.flags.carray
        if not ready and isinstance(array, np.ndarray) and not array.flags.writeable:
            raise ValueError(f"{name} in out can't be written to: it is read-only")
        if not ready or array.shape != shape or array.dtype != kind:
            raise ValueError(f"{name} in out must be a contiguous array of {kind}, {shape}")
    return q, status


def span(branch: Any, branches: Sequence[str]) -> tuple[int, int]:  # noqa: ANN401
    """The rows of a branch: the first, and the one after the last; all of them for None.

    Raises:
        ValueError: There is no such branch; the message names those that exist.
    """
    if branch is None:
        return 0, len(branches)
    if isinstance(branch, str) and branch in branches:
        branch = branches.index(branch)
    if is_number(branch) and 0 <= branch < len(branches):
        return branch, branch + 1
    names = ", ".join(branches)
    raise ValueError(f"no branch {branch!r}; give a row, from 0, or a name: {names}")


def is_number(value: object) -> bool:
    """Whether a value is a whole number; True and False are none."""
    return isinstance(value, (int, np.integer)) and not isinstance(value, bool)

"""What callers in Python may hand over, and what refusals say."""

from __future__ import annotations

from collections import UserList
from typing import Any

import numpy as np
import pytest

from dhgen.runtime.python.arguments import (
    array_of,
    demand_array,
    numbers,
    of_each,
    results,
    span,
)


@pytest.mark.parametrize(
    "values", [[1, 2], (True, False), np.array([1, 2], np.float32), np.array([1, 2], "O")]
)
def test_numbers_in_any_form(values: Any) -> None:
    array = array_of(values, (2,), "q")
    assert array.dtype == np.float64
    assert array.flags.c_contiguous
    assert array.tolist() == [float(v) for v in values]


@pytest.mark.parametrize(
    "values",
    [
        "12",
        ["1", "2"],
        [1j, 2],
        [None, 2],
        np.array(["2020-01-01"] * 2, "M8[D]"),
        [[1], 2],
        [10**400, 1],
    ],
)
def test_what_is_no_number(values: Any) -> None:
    with pytest.raises(ValueError, match=r"^q must hold real numbers, with shape \(2,\)$"):
        numbers(values, (2,), "q")


class Tensor:
    """An array of another library, which refuses to be one of numpy's."""

    def __array__(self, *_type: Any, **_copy: Any) -> Any:
        raise TypeError("Use Tensor.cpu() to copy the tensor to host memory first.")


def test_what_another_library_says_of_its_array_is_passed_on() -> None:
    """That of a tensor on a graphics card names what to call; numpy's own words help nobody."""
    told = r"^q must hold real numbers, with shape \(2,\): Use Tensor.cpu\(\) to copy the tensor"
    with pytest.raises(ValueError, match=told):
        numbers(Tensor(), (2,), "q")


def test_shapes_are_named() -> None:
    with pytest.raises(ValueError, match=r"^q must have shape \(2,\), not \(3,\)$"):
        array_of([1, 2, 3], (2,), "q")


class Transform:
    """A transform as scipy's are: no sequence, no array, but a matrix that it is asked for."""

    def __init__(self, matrix: Any) -> None:
        self._matrix = matrix

    def as_matrix(self) -> Any:
        return self._matrix


def test_transforms_say_their_matrix() -> None:
    assert array_of(Transform(2.0 * np.eye(4)), (4, 4), "T").tolist() == (2.0 * np.eye(4)).tolist()
    with pytest.raises(ValueError, match=r"^T is a rotation without a position: put T.as_matrix"):
        array_of(Transform(np.eye(3)), (4, 4), "T")
    with pytest.raises(ValueError, match=r"^T must have shape \(4, 4\), not \(2, 4, 4\); ik_batch"):
        array_of(Transform(np.array([np.eye(4)] * 2)), (4, 4), "T")


def test_stacks_of_joint_values() -> None:
    def turned(q: Any) -> Any:
        return np.outer(q, q)

    q = np.arange(12.0).reshape(3, 2, 2)
    stack = of_each(turned, q, 2)
    assert stack.shape == (3, 2, 2, 2)
    assert stack[1, 0].tolist() == np.outer(q[1, 0], q[1, 0]).tolist()
    assert of_each(turned, np.empty((0, 2)), 2).shape == (0, 2, 2)
    assert of_each(np.sum, [[1, 2], [3, 4]], 2).tolist() == [3.0, 7.0]
    assert of_each(turned, (1, 2), 2).tolist() == [[1.0, 2.0], [2.0, 4.0]]
    with pytest.raises(ValueError, match=r"^q must have shape \(2,\), not \(2, 3\)$"):
        of_each(turned, np.zeros((2, 3)), 2)


@pytest.mark.parametrize(
    ("array", "told"),
    [
        ([1.0, 2.0], "q must be an array of float64, not list"),
        (np.zeros(2, np.float32), "q must be an array of float64, not float32"),
        (np.ma.zeros(2), "q must be an array of float64, not MaskedArray"),
        (np.zeros(3), r"q must have shape \(2,\), not \(3,\)"),
    ],
)
def test_arrays_that_are_filled(array: Any, told: str) -> None:
    with pytest.raises(ValueError, match=f"^{told}$"):
        demand_array("q", array, (2,), np.dtype(np.float64))


def test_results_of_a_batch() -> None:
    q, status = results(None, (5, 2, 3))
    assert (q.shape, status.shape, status.dtype.name) == ((5, 2, 3), (5, 2), "uint8")
    assert all(
        given is taken
        for given, taken in zip((q, status), results([q, status], (5, 2, 3)), strict=True)
    )
    for wrong in (q, (q,), (q[:4], status), (q[:, ::-1], status), (q, status.astype(int))):
        with pytest.raises(ValueError, match=r"^out must be|in out must be"):
            results(wrong, (5, 2, 3))
    q.flags.writeable = False
    with pytest.raises(ValueError, match=r"^q in out can't be written to: it is read-only$"):
        results((q, status), (5, 2, 3))


def test_branches() -> None:
    names = ("up", "down")
    assert span(None, names) == (0, 2)
    assert span("down", names) == span(1, names) == span(np.int64(1), names) == (1, 2)
    for wrong in ("left", 2, -1, True, 1.0):
        with pytest.raises(ValueError, match="give a row, from 0, or a name: up, down"):
            span(wrong, names)


def test_several_poses_of_spatialmath_are_all_seen() -> None:
    """Its poses are lists of matrices, of which numpy takes the first one alone for an array."""

    class Poses(UserList[np.ndarray]):
        @property
        def __array_interface__(self) -> object:
            return self.data[0].__array_interface__

    two = Poses([np.eye(4), 2.0 * np.eye(4)])
    np.testing.assert_array_equal(numbers(two, (2, 4, 4), "T")[1], 2.0 * np.eye(4))
    assert numbers(Poses([np.eye(4)]), (4, 4), "T").shape == (4, 4)
    several = numbers([two, Poses([3.0 * np.eye(4)])], (3, 4, 4), "T")
    assert several[:, 0, 0].tolist() == [1.0, 2.0, 3.0]
    with pytest.raises(ValueError, match="T holds no pose"):
        numbers(Poses([]), (4, 4), "T")
    with pytest.raises(ValueError, match="ik_batch takes many poses"):
        array_of(two, (4, 4), "T")

"""What the pose helpers refuse, and what looks odd but is accepted."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.pose import pose_reference as reference
from tests.pose.pose_libraries import (
    NOTATIONS,
    both_pythons,
    call_c,
    each_library,
    library,
    numba_or,
    read,
    write,
)

each_notation = pytest.mark.parametrize("notation", NOTATIONS)
not_finite = pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])

XYZ = np.array([1.0, 2.0, 3.0])
T = reference.pose(reference.rpy((0.1, 0.2, 0.3)), XYZ)


def orientation(notation: str) -> list[Any]:
    """Some valid arguments."""
    return [np.arange(1.0, size + 1) if size else 0.5 for size in NOTATIONS[notation]]


def invalid_poses() -> dict[str, Any]:
    """Matrices that are not a rotation and a translation."""
    mirrored, scaled, sheared, transposed, two = (T.copy() for _ in range(5))
    mirrored[:3, 0] *= -1
    scaled[:3, :3] *= 1.001
    sheared[0, 1] += 1e-3
    transposed[:] = T.T
    two[3, 3] = 2.0
    huge, swapped = T.copy(), T.copy()
    huge[:3, :3] = 1e200
    swapped[:3, [0, 1]] = T[:3, [1, 0]]
    return {
        "zero": np.zeros((4, 4)),
        "ones": np.ones((4, 4)),
        "negative": -np.eye(4),
        "mirrored": mirrored,
        "scaled": scaled,
        "sheared": sheared,
        "transposed": transposed,
        "last entry 2": two,
        "products overflow": huge,
        "columns swapped": swapped,
        "rank 1": np.diag([1.0, 0.0, 0.0, 1.0]),
        "all 1.7e308": np.full((4, 4), 1.7e308),
    }


@each_library
@each_notation
@not_finite
def test_a_pose_with_a_number_that_is_not_finite(name: str, notation: str, bad: float) -> None:
    of = library(name)
    for index in np.ndindex(4, 4):
        broken = T.copy()
        broken[index] = bad
        with pytest.raises(ValueError, match=r"finite|-1"):
            read(of, notation, broken)


@each_library
@each_notation
@not_finite
def test_an_orientation_or_position_that_is_not_finite(
    name: str, notation: str, bad: float
) -> None:
    of = library(name)
    for i in range(3):
        xyz = XYZ.copy()
        xyz[i] = bad
        with pytest.raises(ValueError, match=r"finite|-1"):
            write(of, notation, xyz, *orientation(notation))
    for i, size in enumerate(NOTATIONS[notation]):
        for j in range(max(size, 1)):
            arguments = orientation(notation)
            if size:
                arguments[i][j] = bad
            else:
                arguments[i] = bad
            with pytest.raises(ValueError, match=r"finite|-1"):
                write(of, notation, XYZ, *arguments)


@each_library
@each_notation
@pytest.mark.parametrize("case", invalid_poses())
def test_a_matrix_that_is_no_pose(name: str, notation: str, case: str) -> None:
    with pytest.raises(ValueError, match=r"not a rotation|-2"):
        read(library(name), notation, invalid_poses()[case])


@each_library
@pytest.mark.parametrize("notation", ["quaternion_xyzw", "quaternion_wxyz"])
def test_a_zero_quaternion(name: str, notation: str) -> None:
    with pytest.raises(ValueError, match=r"zero quaternion|-3"):
        write(library(name), notation, XYZ, np.zeros(4))


@each_library
@pytest.mark.parametrize("angle", [1.0, -1e-300])
def test_a_zero_axis_with_an_angle(name: str, angle: float) -> None:
    with pytest.raises(ValueError, match=r"zero axis|-4"):
        library(name).from_xyz_axis_angle(XYZ, np.zeros(3), angle)


@pytest.mark.parametrize(("name", "notation"), numba_or("plain"))
def test_wrong_shapes(name: str, notation: str) -> None:
    """Numba checks no index: without a check these would read foreign memory."""
    of = library(name)
    with pytest.raises(ValueError, match="shape"):
        read(of, notation, np.eye(3))
    with pytest.raises(ValueError, match=r"must have shape \(\d,\)"):
        write(of, notation, np.zeros(2), *orientation(notation))
    first, *rest = orientation(notation)
    with pytest.raises(ValueError, match=r"must have shape \(\d,\)"):
        write(of, notation, XYZ, first[:-1], *rest)


@both_pythons
@each_notation
def test_arrays_of_any_kind_come_in_and_float64_comes_out(name: str, notation: str) -> None:
    of = library(name)
    arguments = orientation(notation)
    expected = write(of, notation, XYZ, *arguments)
    single = [
        numbers.astype(np.float32) if isinstance(numbers, np.ndarray) else numbers
        for numbers in arguments
    ]
    for numbers in (XYZ.astype(np.float32), XYZ.astype(int)):
        found = write(of, notation, numbers, *single)
        assert found.dtype == np.float64
        np.testing.assert_allclose(found, expected, rtol=0, atol=2e-15)
    fixed = np.asfortranarray(expected)
    fixed.flags.writeable = False
    for got, wanted in zip(read(of, notation, fixed), read(of, notation, expected), strict=True):
        assert np.asarray(got).dtype == np.float64
        assert (np.asarray(got) == wanted).all()


@both_pythons
@each_notation
def test_results_share_no_memory_with_the_arguments(name: str, notation: str) -> None:
    of = library(name)
    pose, xyz = T.copy(), XYZ.copy()
    read(of, notation, pose)[0][:] = 9.0
    write(of, notation, xyz, *orientation(notation))[:3, 3] = 9.0
    assert (pose == T).all()
    assert (xyz == XYZ).all()


def test_wxyz_in_c_refuses_with_nan_everywhere() -> None:
    """The scalar-first reader goes through a copy, which must carry the NaN over."""
    shared = library("c").shared
    xyz, q = np.zeros(3), np.zeros(4)
    function = shared.dhgen_pose_to_xyz_quaternion_wxyz
    assert call_c(function, np.zeros((4, 4)), xyz, q) == -2
    assert np.isnan(xyz).all()
    assert np.isnan(q).all()


@both_pythons
def test_lists_and_tuples_of_numbers(name: str) -> None:
    of = library(name)
    T = of.from_xyz_rpy([0.3, 0, 0.2], (0, 0, 1.57))
    np.testing.assert_array_equal(T, of.from_xyz_rpy(np.array([0.3, 0, 0.2]), rpy=[0, 0, 1.57]))
    for read_as in (of.to_xyz_rpy, of.to_xyz_axis_angle):
        for listed, expected in zip(read_as(T.tolist()), read_as(T), strict=True):
            np.testing.assert_array_equal(listed, expected)
    turned = of.from_xyz_axis_angle([1, 2, 3], axis=(0, 0, 1), angle=1)
    np.testing.assert_array_equal(turned[:3, 3], [1, 2, 3])
    for wrong in ([1, 2], [[1, 2, 3]], 3, "abc", [1, 2, None], [1, [2, 3]], [1, 2, np.inf]):
        with pytest.raises(ValueError, match=r"xyz must|could not convert|finite|sequence"):
            of.from_xyz_rpy(wrong, [0, 0, 0])
    with pytest.raises(ValueError, match=r"angle must have shape \(\), not \(1,\)"):
        of.from_xyz_axis_angle([1, 2, 3], [0, 0, 1], [1])
    with pytest.raises(ValueError, match=r"quaternion_wxyz must have shape \(4,\), not \(3,\)"):
        of.from_xyz_quaternion_wxyz([1, 2, 3], [0, 0, 1])
    with pytest.raises(ValueError, match=r"T must have shape \(4, 4\), not \(3, 3\)"):
        of.to_xyz_rpy(np.eye(3))

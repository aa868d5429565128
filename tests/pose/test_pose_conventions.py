"""What the pose helpers answer where the orientation alone does not decide."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.pose import pose_reference as reference
from tests.pose.pose_libraries import NOTATIONS, each_library, library, read, write

ORIGIN = np.zeros(3)


def angles(*numbers: float) -> Any:
    return np.array(numbers)


@each_library
@pytest.mark.parametrize("sign", [1, -1])
def test_gimbal_lock_has_roll_0_and_yaw_takes_it_all(name: str, sign: int) -> None:
    of = library(name)
    T = of.from_xyz_rpy(ORIGIN, angles(0.4, sign * np.pi / 2, 0.7))
    roll, pitch, yaw = of.to_xyz_rpy(T)[1]
    assert roll == 0.0
    assert pitch == sign * np.pi / 2
    assert yaw == pytest.approx(0.7 - sign * 0.4, abs=1e-15)


@each_library
@pytest.mark.parametrize("notation", ["euler_zxz", "euler_zyz"])
@pytest.mark.parametrize("b", [0.0, np.pi])
def test_parallel_axes_have_c_0_and_a_takes_it_all(name: str, notation: str, b: float) -> None:
    of = library(name)
    T = write(of, notation, ORIGIN, angles(0.4, b, 0.7))
    found = read(of, notation, T)[1]
    assert found[2] == 0.0
    assert found[1] == b
    assert found[0] == pytest.approx(0.4 + 0.7 if b == 0.0 else 0.4 - 0.7, abs=1e-15)


@each_library
@pytest.mark.parametrize("offset", [1e-6, 1e-9, 1e-12])
def test_the_middle_angle_is_exact_near_its_end(name: str, offset: float) -> None:
    """acos and asin would return an end itself: cos(1e-9) is 1."""
    of = library(name)
    T = of.from_xyz_rpy(ORIGIN, angles(0.4, np.pi / 2 - offset, 0.7))
    assert of.to_xyz_rpy(T)[1][1] == pytest.approx(np.pi / 2 - offset, rel=0, abs=3e-16)
    for notation in ("euler_zxz", "euler_zyz"):
        T = write(of, notation, ORIGIN, angles(0.4, offset, 0.7))
        assert read(of, notation, T)[1][1] == pytest.approx(offset, rel=0, abs=1e-24)


@each_library
@pytest.mark.parametrize("angle", [1e-3, 1e-6, 1e-9, 1e-12, 1e-100, 1e-200])
def test_tiny_rotations_keep_axis_and_angle(name: str, angle: float) -> None:
    of = library(name)
    axis = angles(3.0, 0.0, -4.0) / 5.0
    _, found_axis, found_angle = of.to_xyz_axis_angle(of.from_xyz_axis_angle(ORIGIN, axis, angle))
    np.testing.assert_allclose(found_axis, axis, rtol=0, atol=1e-12)
    assert found_angle == pytest.approx(angle, rel=1e-12, abs=0)


@each_library
def test_no_rotation_is_angle_0_about_z(name: str) -> None:
    of = library(name)
    xyz, axis, angle = of.to_xyz_axis_angle(np.eye(4))
    assert (xyz.tolist(), axis.tolist(), angle) == ([0, 0, 0], [0, 0, 1], 0)
    assert (of.from_xyz_axis_angle(ORIGIN, ORIGIN, 0.0) == np.eye(4)).all()


@each_library
def test_no_rotation_reads_as_zeros_without_a_sign(name: str) -> None:
    of = library(name)
    T = np.eye(4)
    T[T == 0] = -0.0
    for notation in NOTATIONS:
        for numbers in read(of, notation, T)[1:]:
            assert not np.signbit(numbers).any(), notation


@each_library
@pytest.mark.parametrize("axis", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 1, -1), (1, -1, 0)])
@pytest.mark.parametrize("sign", [1, -1])
def test_an_exact_half_turn_has_the_axis_that_begins_positive(
    name: str, axis: tuple[int, int, int], sign: int
) -> None:
    of = library(name)
    unit = np.array(axis) / np.linalg.norm(axis)
    # The exact matrix, not from an angle: the double nearest pi is not a half turn.
    v = np.array(axis) * sign
    T = reference.pose(2 * np.outer(v, v) / (v @ v) - np.eye(3))
    _, found_axis, angle = of.to_xyz_axis_angle(T)
    np.testing.assert_allclose(found_axis, unit, rtol=0, atol=3e-16)
    assert angle == np.pi
    q = of.to_xyz_quaternion_wxyz(T)[1]
    np.testing.assert_allclose(q, [0, *unit], rtol=0, atol=3e-16)
    assert not np.signbit(q[0])


@each_library
def test_quaternions_are_unit_with_w_not_negative_and_differ_by_order_alone(name: str) -> None:
    of = library(name)
    rotations = [*reference.random_rotations(200), *reference.aligned_rotations()]
    for R in rotations:
        xyzw = of.to_xyz_quaternion_xyzw(reference.pose(R))[1]
        assert xyzw[3] >= 0
        assert xyzw @ xyzw == pytest.approx(1, abs=5e-16)
        assert (np.roll(xyzw, 1) == of.to_xyz_quaternion_wxyz(reference.pose(R))[1]).all()


@each_library
def test_ranges(name: str) -> None:
    of = library(name)
    rotations = [*reference.random_rotations(100), *dict(reference.singular_rotations()).values()]
    for R in rotations:
        T = reference.pose(R)
        roll, pitch, yaw = of.to_xyz_rpy(T)[1]
        assert max(abs(roll), abs(yaw)) <= np.pi
        assert abs(pitch) <= np.pi / 2
        for notation in ("euler_zxz", "euler_zyz"):
            a, b, c = read(of, notation, T)[1]
            assert max(abs(a), abs(c)) <= np.pi
            assert 0 <= b <= np.pi
        _, axis, angle = of.to_xyz_axis_angle(T)
        assert axis @ axis == pytest.approx(1, abs=5e-16)
        assert 0 <= angle <= np.pi


@each_library
def test_products_and_inverses_are_those_of_matrices(name: str) -> None:
    of = library(name)
    first, second = (
        reference.pose(R, [0.3, -250.0, 1e-3]) for R in reference.random_rotations(2, seed=4)
    )
    np.testing.assert_allclose(of.multiply(first, second), first @ second, rtol=0, atol=1e-13)
    np.testing.assert_allclose(of.inverse(first), np.linalg.inv(first), rtol=0, atol=1e-13)
    np.testing.assert_allclose(of.multiply(of.inverse(first), first), np.eye(4), rtol=0, atol=1e-13)
    mirrored = first * np.array([-1.0, 1.0, 1.0, 1.0])
    for refused in (first * 1.01, mirrored, np.full((4, 4), np.nan)):
        for call in (
            lambda T: of.multiply(T, first),
            lambda T: of.multiply(first, T),
            of.inverse,
        ):
            with pytest.raises(ValueError, match=r"."):
                call(refused)


@each_library
@pytest.mark.parametrize(
    ("notation", "numbers", "x", "z"),
    [  # where the tool's x and z axes point to, drawn by hand
        ("abc_deg", (90, 0, 0), (0, 1, 0), (0, 0, 1)),
        ("abc_deg", (90, 90, 0), (0, 0, -1), (0, 1, 0)),  # B about the y axis that A has turned
        ("abc_deg", (0, 0, 90), (1, 0, 0), (0, -1, 0)),
        ("wpr_deg", (90, 0, 0), (1, 0, 0), (0, -1, 0)),
        ("wpr_deg", (180, 0, 90), (0, 1, 0), (0, 0, -1)),  # a tool that points down
        ("abc", (np.pi / 2, np.pi / 2, 0), (0, 0, -1), (0, 1, 0)),
        ("wpr", (np.pi, 0, np.pi / 2), (0, 1, 0), (0, 0, -1)),
        ("rotvec", (0, np.pi, 0), (-1, 0, 0), (0, 0, -1)),
        ("rotvec", (0, 0, np.pi / 2), (0, 1, 0), (0, 0, 1)),
    ],
)
def test_what_vendors_write(
    name: str, notation: str, numbers: tuple[float, ...], x: Any, z: Any
) -> None:
    T = write(library(name), notation, ORIGIN, angles(*numbers))
    np.testing.assert_allclose(T[:3, 0], x, rtol=0, atol=1e-15)
    np.testing.assert_allclose(T[:3, 2], z, rtol=0, atol=1e-15)
    assert read(library(name), notation, T)[1] == pytest.approx(numbers, abs=1e-13)

"""Round trips over everything that floats can be."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.pose.pose_libraries import each_library, library, read, write

# No database: the tests leave no folder behind.
thorough = settings(database=None, max_examples=50)

finite = st.floats(allow_nan=False, allow_infinity=False)
positions = st.tuples(finite, finite, finite).map(np.array)
quarter_turns = st.integers(-8, 8).map(lambda n: n * np.pi / 2)
small = st.floats(-1e-5, 1e-5) | st.sampled_from([1e-6, 1e-9, 1e-12, 1e-15, 1e-16])
angle = st.floats(-10, 10) | st.builds(lambda a, b: a + b, quarter_turns, small) | finite
three_angles = st.tuples(angle, angle, angle).map(np.array)


def check_round_trip(of: Any, notation: str, xyz: Any, *orientation: Any) -> None:
    """What is written is a rotation, and reading and writing it again changes nothing."""
    T = write(of, notation, xyz, *orientation)
    R = T[:3, :3]
    np.testing.assert_allclose(R @ R.T, np.eye(3), rtol=0, atol=2e-15)
    assert np.linalg.det(R) > 0
    read_xyz, *read_orientation = read(of, notation, T)
    assert (read_xyz == xyz).all()
    again = write(of, notation, read_xyz, *read_orientation)
    np.testing.assert_allclose(again, T, rtol=0, atol=3e-15)


@each_library
@pytest.mark.parametrize("notation", ["rpy", "euler_zxz", "euler_zyz"])
@thorough
@given(xyz=positions, angles=three_angles)
def test_three_angles(name: str, notation: str, xyz: Any, angles: Any) -> None:
    check_round_trip(library(name), notation, xyz, angles)


@each_library
@pytest.mark.parametrize("notation", ["quaternion_xyzw", "quaternion_wxyz"])
@thorough
@given(xyz=positions, q=st.tuples(finite, finite, finite, finite).map(np.array))
def test_quaternions_of_any_length(name: str, notation: str, xyz: Any, q: Any) -> None:
    assume(q.any())
    of = library(name)
    check_round_trip(of, notation, xyz, q)
    found = read(of, notation, write(of, notation, xyz, q))[1]
    scaled = q / np.abs(q).max()
    unit = scaled / np.linalg.norm(scaled)
    assert min(np.abs(found - unit).max(), np.abs(found + unit).max()) <= 1e-15


@each_library
@thorough
@given(xyz=positions, axis=st.tuples(finite, finite, finite).map(np.array), about=angle)
def test_axes_of_any_length(name: str, xyz: Any, axis: Any, about: float) -> None:
    assume(axis.any())
    check_round_trip(library(name), "axis_angle", xyz, axis, about)

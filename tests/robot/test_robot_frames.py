"""Frames: every way of writing a rotation gives the same, and exactly."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhgen.robot.expression import ONE, ZERO, Negate, Number, evaluate, to_text
from dhgen.robot.frames import from_quaternion, nearest_rotation, to_quaternion
from tests.robot.robot_texts import MINIMAL, axes, marked, mistake, mistakes, robot

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Frame

ANGLES = st.floats(-7, 7, allow_nan=False).map(lambda x: round(x, 6))


def tool(entry: str) -> Frame:
    return robot(f"{MINIMAL}tool: {entry}\n").tool


def texts(frame: Frame) -> list[str]:
    return [to_text(entry) for entry in frame.rotation]


def rotation(frame: Frame) -> FloatArray:
    return np.array([evaluate(entry, {}) for entry in frame.rotation]).reshape(3, 3)


def urdf(roll: float, pitch: float, yaw: float) -> FloatArray:
    """Rz(yaw) Ry(pitch) Rx(roll)."""
    (cr, cp, cy), (sr, sp, sy) = np.cos([roll, pitch, yaw]), np.sin([roll, pitch, yaw])
    rx = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    ry = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    rz = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
    matrix: FloatArray = rz @ ry @ rx
    return matrix


def test_a_frame_that_is_left_out_is_the_identity() -> None:
    loaded = robot(MINIMAL)
    assert loaded.base == loaded.tool == tool("{}") == tool("{rpy: [0, 0, 0]}")
    assert loaded.base.xyz == (ZERO, ZERO, ZERO)
    assert loaded.base.rotation == (ONE, ZERO, ZERO, ZERO, ONE, ZERO, ZERO, ZERO, ONE)


def test_a_quarter_turn_has_entries_zero_and_one() -> None:
    quarter = (ZERO, Negate(ONE), ZERO, ONE, ZERO, ZERO, ZERO, ZERO, ONE)
    assert tool("{rpy: [0, 0, pi/2]}").rotation == quarter
    assert tool("{rpy: [0, 0, 90 deg]}").rotation == quarter
    assert tool("{quaternion_xyzw: [0, 0, 1, 1]}").rotation == quarter
    assert tool("{quaternion_wxyz: [0.7071068, 0, 0, 0.7071068]}").rotation == quarter
    assert tool("[[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]").rotation == quarter


@pytest.mark.parametrize(
    ("rpy", "expected"),
    [
        ("[pi/6, 0, 0]", "1 0 0 0 sqrt(3)/2 -0.5 0 0.5 sqrt(3)/2"),
        ("[0, pi/4, 0]", "sqrt(2)/2 0 sqrt(2)/2 0 1 0 -(sqrt(2)/2) 0 sqrt(2)/2"),
        ("[0, 0, 2*pi/3]", "-0.5 -(sqrt(3)/2) 0 sqrt(3)/2 -0.5 0 0 0 1"),
        ("[0, 0, 0.3]", "cos(0.3) -sin(0.3) 0 sin(0.3) cos(0.3) 0 0 0 1"),
        ("[pi/2, 0, 0.3]", "cos(0.3) 0 sin(0.3) sin(0.3) 0 -cos(0.3) 0 1 0"),
        ("[pi, pi, pi]", "1 0 0 0 1 0 0 0 1"),
    ],
)
def test_exact_entries(rpy: str, expected: str) -> None:
    assert texts(tool(f"{{rpy: {rpy}}}")) == expected.split()


@given(st.tuples(ANGLES, ANGLES, ANGLES))
def test_rpy_is_as_in_urdf(rpy: tuple[float, float, float]) -> None:
    np.testing.assert_allclose(rotation(tool(f"{{rpy: {list(rpy)}}}")), urdf(*rpy), atol=1e-12)


@given(st.tuples(*[st.integers(-24, 24)] * 3))
def test_exact_rpy_is_as_in_urdf(k: tuple[int, int, int]) -> None:
    frame = tool(f"{{rpy: [{k[0]}*pi/12, {k[1]}*pi/12, {k[2]}*pi/12]}}")
    assert not any("cos" in text or "sin" in text for text in texts(frame))
    np.testing.assert_allclose(rotation(frame), urdf(*(np.array(k) * math.pi / 12)), atol=1e-12)


@given(st.tuples(ANGLES, ANGLES, ANGLES))
def test_a_matrix_and_its_quaternion_are_the_same_rotation(rpy: tuple[float, float, float]) -> None:
    matrix = np.eye(4)
    matrix[:3, :3] = urdf(*rpy)
    frame = tool(str(matrix.tolist()))
    np.testing.assert_allclose(rotation(frame), matrix[:3, :3], atol=2e-9)
    a, b, c = (tuple(row) for row in matrix[:3, :3].tolist())
    quaternion = to_quaternion((a, b, c))
    other = tool(f"{{quaternion_xyzw: {list(quaternion)}}}")
    np.testing.assert_allclose(rotation(other), matrix[:3, :3], atol=2e-9)


@given(st.tuples(*[st.fractions(-2, 2, max_denominator=1000)] * 4).filter(any))
def test_the_matrix_of_a_quaternion_is_exactly_orthonormal(
    quaternion: tuple[Fraction, Fraction, Fraction, Fraction],
) -> None:
    rows = np.array(from_quaternion(*quaternion), dtype=object).reshape(3, 3)
    assert (rows @ rows.T == np.eye(3, dtype=int)).all()


@given(st.tuples(ANGLES, ANGLES, ANGLES), st.lists(st.floats(-1e-6, 1e-6), min_size=9, max_size=9))
def test_the_nearest_rotation(rpy: tuple[float, float, float], errors: list[float]) -> None:
    noisy = urdf(*rpy) + np.array(errors).reshape(3, 3)
    a, b, c = (tuple(row) for row in noisy.tolist())
    left, _, right = np.linalg.svd(noisy)
    np.testing.assert_allclose(nearest_rotation((a, b, c)), left @ right, atol=1e-14)


def test_translations() -> None:
    assert [to_text(x) for x in tool("{xyz: [0.1, -0.2, 1e-12]}").xyz] == ["0.1", "-0.2", "0"]
    frame = tool("{matrix: [[1, 0, 0, 0.1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]}")
    assert [to_text(x) for x in frame.xyz] == ["0.1", "2", "3"]


def test_parameters_stay_named() -> None:
    loaded = robot(
        f"parameters: {{l: 0.1, w: 0.3}}\n{MINIMAL}tool: {{xyz: [l, 0, 2*l], rpy: [w, 0, 0]}}\n"
    )
    assert [to_text(x) for x in loaded.tool.xyz] == ["l", "0", "2*l"]
    assert to_text(loaded.tool.rotation[4]) == "cos(w)"


def test_entries_that_mean_an_exact_value_snap_with_a_notice() -> None:
    loaded = robot(
        f"{MINIMAL}tool: [[0.8660254038, -0.5, 0, 0], [0.5, 0.8660254038, 0, 0], [0, 0, 1, 0], "
        "[0, 0, 0, 1]]\n"
    )
    assert texts(loaded.tool)[0] == "sqrt(3)/2"
    assert [marked(notice) for notice in loaded.notices] == ["0.8660254038"] * 2
    assert "away from sqrt(3)/2 and taken as sqrt(3)/2" in loaded.notices[0].message


@pytest.mark.parametrize(
    "entry",
    [
        (
            "{matrix: [[0.999999999928, -1.1999999999712e-05, 0, 0], "
            "[1.1999999999712e-05, 0.999999999928, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}"
        ),
        "{quaternion_xyzw: [0, 0, 5.999999999964e-06, 0.999999999982]}",
    ],
)
def test_a_small_rotation_stays_orthonormal(entry: str) -> None:
    """Its cosine is 1 to ten digits, its sine is not 0: 1.2e-5 rad about z."""
    R = rotation(tool(entry))
    assert np.abs(R @ R.T - np.eye(3)).max() < 1e-15
    assert math.atan2(R[1, 0], R[0, 0]) == pytest.approx(1.2e-5, abs=1e-15)


def test_a_matrix_that_is_a_rotation_stays_as_it_is_given() -> None:
    """Its cosines next to 1 are not taken as 1, nor is it moved to a rotation beside it."""
    loaded = robot(
        f"{MINIMAL}tool: [[0.999999999928, -1.1999999999712e-05, 0, 0], "
        "[1.1999999999712e-05, 0.999999999928, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]\n"
    )
    R = rotation(loaded.tool)
    assert R[:2, :2].tolist() == [
        [0.999999999928, -1.1999999999712e-05],
        [1.1999999999712e-05, 0.999999999928],
    ]
    assert loaded.notices == ()


def test_a_right_angle_to_ten_digits_is_exact() -> None:
    """All its entries are nearly exact, and together a rotation."""
    frame = tool("{quaternion_xyzw: [0.7071067812, 0, 0, 0.7071067811]}")
    assert texts(frame) == ["1", "0", "0", "0", "0", "-1", "0", "1", "0"]


def test_a_rounded_matrix_becomes_the_nearest_rotation_with_a_notice() -> None:
    loaded = robot(
        f"{MINIMAL}tool: [[0.955336, -0.295520, 0, 0], [0.295520, 0.955336, 0, 0], [0, 0, 1, 0], "
        "[0, 0, 0, 1]]\n"
    )
    rows = rotation(loaded.tool)
    np.testing.assert_allclose(rows @ rows.T, np.eye(3), atol=1e-15)
    np.testing.assert_allclose(rows, urdf(0, 0, 0.3), atol=1e-6)
    (notice,) = loaded.notices
    assert notice.message.startswith("the rotation is off by ")


def test_a_quaternion_off_its_length_is_normalised_with_a_notice() -> None:
    loaded = robot(f"{MINIMAL}tool: {{quaternion_xyzw: [0, 0, 2, 2]}}\n")
    (notice,) = loaded.notices
    assert notice.message == "the quaternion has length 2.82842712 and is normalised"
    assert not robot(f"{MINIMAL}tool: {{quaternion_xyzw: [0, 0, 0.6, 0.8]}}\n").notices
    assert tool("{quaternion_xyzw: [0, 0, 0.6, 0.8]}").rotation[0] == Number(Fraction(28, 100))


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ("{quaternion_xyzw: [0, 0, 0, 0]}", "a quaternion of length 0 is not a rotation"),
        ("{quaternion_xyzw: [0, 0, 1]}", "expected 4 values, not 3"),
        ("{rpy: [0, 0, 0, 0]}", "expected 3 values, not 4"),
        ("{rpy: 0}", "expected a list [roll, pitch, yaw], not '0'"),
        ("{rpy: [0, 0, []]}", "expected a number or an expression, not an empty list"),
        ("{xyz: [0, 0, q]}", "the variable q is only allowed in theta or d of a joint"),
        ("{xyz: [0, 0, 1e10]}", "the length 1e+10 is beyond 1e+09"),
        ("{rpy: [0, 0, 1e10]}", "the angle 1e+10 rad is beyond 1e+04"),
        ("{rpy: [0, 0, 0], matrix: [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}", "'rpy' already"),
        ("{xyz: [0, 0, 0], matrix: [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}", "'matrix' alr"),
        ("[[1,0,0,0],[0,1,0,0],[0,0,-1,0],[0,0,0,1]]", "the determinant is -1, not 1"),
        ("[[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", "not orthonormal: the rotation's row 1 has"),
        ("[[1,0,0,0],[0.6,0.8,0,0],[0,0,1,0],[0,0,0,1]]", "not orthonormal: rows 1 and 2 have"),
        (
            "[[1,0,0,0],[0,1,0,0],[0,0,1.000002,0],[0,0,0,1]]",
            "not orthonormal: the rotation's row 3",
        ),
        (
            "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,2]]",
            "the last row of a frame's matrix must be 0 0 0 1",
        ),
        (
            "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[1,0,0,1]]",
            "the last row of a frame's matrix must be 0 0 0 1",
        ),
        ("[[1,0,0,0],[0,1,0,0],[0,0,1,0]]", "expected 4 values, not 3"),
        ("[[1,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", "expected 4 values, not 3"),
        ("3", "expected keys with values, e.g. {xyz: [0, 0, 0.1]}, or a 4x4 matrix, not '3'"),
        ("", "expected keys with values, e.g. {xyz: [0, 0, 0.1]}, or a 4x4 matrix, not noth"),
        ("{ryp: [0, 0, 0]}", "unknown key 'ryp'; did you mean 'rpy'? valid: xyz, rpy, quat"),
    ],
)
def test_refused_frames(entry: str, message: str) -> None:
    assert mistake(f"{MINIMAL}tool: {entry}\n").startswith(message)


def test_two_rotations_are_marked_at_the_second() -> None:
    (found,) = mistakes(f"{MINIMAL}tool: {{quaternion_wxyz: [1, 0, 0, 0], rpy: [0, 0, 0]}}\n")
    assert marked(found) == "rpy"


def test_home_is_a_frame_of_axes() -> None:
    joint = "type: prismatic, direction: [0, 0, 1]"
    loaded = robot(axes(joint, home="{xyz: [0.4, 0, 0.2], rpy: [0, 0, pi]}"))
    home = getattr(loaded.geometry, "home", None)
    assert home is not None
    assert [to_text(x) for x in home.xyz] == ["0.4", "0", "0.2"]
    assert home.rotation[0] == Negate(ONE)


def test_a_rounded_matrix_may_hold_a_mistake_besides() -> None:
    """A cell that can't be read is no number, and the nearest rotation none either."""
    rows = "[[1.0000001, 0, 0, 0], [0, x, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]"
    assert mistake(f"{MINIMAL}tool: {{matrix: {rows}}}\n").startswith("unknown name 'x'")

"""The C around closed forms by its functions, over an arm of two joints in a plane.

What is expected is worked out with numpy, from definitions: nearest rotations by singular values,
steps by linear equations, limits by trying whole turns.
"""

from __future__ import annotations

import ctypes
import subprocess
import tempfile
from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.runtime import c_runtime_files
from dhgen.runtime.python.status import (
    FREE_JOINT,
    INVALID_POSE,
    OK,
    OUT_OF_LIMITS,
    UNREACHABLE,
)
from dhgen.verify.native import c_compiler

DRIVER = Path(__file__).with_name("closed.c.txt")
BUILDS = ("-DDHGEN_SCALAR", "-mavx2", "-march=native")
STRICT = ("-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wdouble-promotion", "-Werror")
COORDINATES, POINTING, _, POSE, YAW, PITCH, TILT = range(7)
TURN = 2.0 * np.pi
LOW, HIGH = -2.0, 2.0  # limits of joint 1
Q = np.array([0.4, 0.9])  # a regular configuration
DOUBLES = ("overshoot", "past_an_end", "turned", "at_an_end", "misfit", "miss", "quotient_by")


@cache
def library(build: str = BUILDS[0]) -> ctypes.CDLL:
    folder = Path(tempfile.mkdtemp())
    write_files(folder, {"driver.c": DRIVER.read_text("utf-8"), **c_runtime_files()})
    flags = ("-std=c99", "-O1", "-pedantic-errors", *STRICT, build, "-shared", "-fPIC")
    command = [str(c_compiler()), *flags, "driver.c", "-o", "driver.so", "-lm"]
    subprocess.run(command, check=True, cwd=folder)
    found = ctypes.CDLL(str(folder / "driver.so"))
    for name in DOUBLES:
        getattr(found, f"run_{name}").restype = ctypes.c_double
    return found


def call(name: str, *arguments: object) -> float:
    """A function of the runtime: arrays go by address, floats as doubles."""
    return float(getattr(library(), f"run_{name}")(*map(_argument, arguments)))


def _argument(value: object) -> object:
    if isinstance(value, np.ndarray):
        assert value.flags.c_contiguous
        return value.ctypes.data_as(ctypes.c_void_p)
    return ctypes.c_double(value) if isinstance(value, float) else value


@pytest.fixture(autouse=True)
def _arm() -> None:
    be(COORDINATES)


def be(
    task: int, low: float = LOW, high: float = HIGH, *, range_exceeds_a_turn: bool = False
) -> None:
    """Sets what is checked of a pose, the limits of joint 1 and whether ranges exceed a turn."""
    library().set_arm(task, int(range_exceeds_a_turn), ctypes.c_double(low), ctypes.c_double(high))


def pose(q: np.ndarray) -> np.ndarray:
    T = np.zeros((4, 4))
    call("fk", np.ascontiguousarray(q), T)
    return T


def rows(*values: object) -> np.ndarray:
    return np.array(values, dtype=float)


def states(*values: int) -> np.ndarray:
    return np.array(values, dtype=np.uint8)


# limits


def test_overshoot_is_the_way_to_the_nearest_end_whole_turns_aside() -> None:
    for value in np.random.default_rng(1).uniform(-12.0, 12.0, 200):
        copies = value + TURN * np.arange(-4, 5)
        off = np.where(copies > HIGH, copies - HIGH, np.minimum(copies - LOW, 0.0))
        expected = off[np.argmin(np.abs(off))]
        found = call("overshoot", 0, float(value))
        assert abs(found) == pytest.approx(abs(expected), abs=1e-12)
        assert found == pytest.approx(expected, abs=1e-12) or abs(expected) > 1.1  # in the middle
    assert call("overshoot", 0, HIGH + 4e-10) == 0.0  # half of its slack
    assert call("overshoot", 0, HIGH + 6e-10) > 0.0


def test_a_range_of_nearly_a_turn_has_ends_that_no_turn_leads_across() -> None:
    be(COORDINATES, -3.14, 3.14, range_exceeds_a_turn=True)
    assert call("past_an_end", 0, 3.24) == pytest.approx(0.1)
    assert call("past_an_end", 1, 3.24) == call("overshoot", 1, 3.24)  # joint 2 has a gap
    assert call("overshoot", 0, 3.24) == 0.0
    near = call("at_an_end", 0, -3.14, 3.15)
    assert near == pytest.approx(TURN - 3.14)  # at the end where the seed is


@pytest.mark.parametrize("build", BUILDS)
@pytest.mark.parametrize(
    ("low", "high", "told"),
    [
        (-2.0, 2.0, {OK, OUT_OF_LIMITS}),
        (-3.1, 3.1, {OK, OUT_OF_LIMITS}),
        (-4.0, 6.0, {OK}),
        (-9.0, -7.0, {OUT_OF_LIMITS}),
        (20.0, 22.0, set()),
    ],
)
def test_a_status_from_lanes_is_that_of_the_row(
    build: str, low: float, high: float, told: set[int]
) -> None:
    """Rows are left of which a joint turns, or is next to an end."""
    own, rng, found = library(build), np.random.default_rng(3), set()
    own.set_arm(COORDINATES, int(high - low > TURN), ctypes.c_double(low), ctypes.c_double(high))
    ends = np.array([low, high]) + TURN * np.arange(-4, 5)[:, None]
    beside = ends + rng.choice([-0.02, -5e-5, 5e-5, 0.02], ends.shape)
    values = np.concatenate([beside.ravel(), rng.uniform(-np.pi, np.pi, 200)])
    for value in values[np.abs(values) <= np.pi]:
        row = rows([value, 0.3], [9.0, 9.0], [np.nan, np.nan], [9.0, 9.0])
        status, moved = own.run_plain_status(_argument(row)), row[0].copy()
        if status >= 0:
            assert status == own.run_limited_row(_argument(moved))
            assert (moved == row[0]).all()
            found.add(status)
    assert found == told


def test_a_quotient_from_an_estimate_is_right_but_for_its_last_place() -> None:
    """Of the estimate six digits are right, as a GPU's are."""
    rng = np.random.default_rng(8)
    sizes = 10.0 ** rng.uniform(-150.0, 150.0, (2000, 2))
    for a, b in rng.uniform(-1.0, 1.0, (2000, 2)) * sizes:
        estimate = (1.0 / b) * (1.0 + rng.uniform(-1e-6, 1e-6))
        found = call("quotient_by", estimate, float(a), float(b))
        off = abs(Fraction(found) - Fraction(a) / Fraction(b))
        assert off <= Fraction(float(np.spacing(abs(found))))


def test_turned_is_the_nearest_copy_inside_the_limits() -> None:
    be(COORDINATES, -7.0, 8.0)
    for value, towards in np.random.default_rng(2).uniform(-20.0, 20.0, (200, 2)):
        copies = value + TURN * np.arange(-8, 9)
        inside = copies[(copies >= -7.0) & (copies <= 8.0)]
        best = np.abs(inside - towards).min()
        found = call("turned", 0, float(value), float(towards))
        assert abs(found - inside).min() < 1e-12
        assert abs(found - towards) == pytest.approx(best, abs=1e-9)
    be(COORDINATES)
    assert call("turned", 0, 3.0, 0.0) == 3.0  # no copy of it is inside: it stays


def test_a_value_just_beyond_an_end_is_put_beside_it() -> None:
    assert call("at_an_end", 0, HIGH + 0.003 - TURN, 0.0) == pytest.approx(HIGH + 0.003)
    assert call("at_an_end", 0, 1.0 + TURN, 0.0) == pytest.approx(1.0)


# poses


def rotation(seed: int) -> np.ndarray:
    R = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    return np.asarray(R * np.sign(np.linalg.det(R)))


def rigid(R: np.ndarray) -> np.ndarray:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, (0.3, -0.2, 0.1)
    return T


@pytest.mark.parametrize("noise", [0.0, 1e-9, 1e-3, 0.3])
def test_misfit_is_how_far_rows_are_from_a_right_handed_triad(noise: float) -> None:
    R = rotation(3) + noise * np.random.default_rng(4).normal(size=(3, 3))
    x, y, z = R
    expected = (x @ x - 1.0) ** 2 + (y @ y - 1.0) ** 2 + 2.0 * (x @ y) ** 2
    expected += float(((np.cross(x, y) - z) ** 2).sum())
    assert call("misfit", rigid(R)) == pytest.approx(expected, rel=1e-6, abs=1e-28)


def test_a_rounded_rotation_becomes_the_nearest_one() -> None:
    be(POSE)
    R = rotation(5) + 1e-6 * np.random.default_rng(6).normal(size=(3, 3))
    left, _, right = np.linalg.svd(R)
    read = np.zeros((4, 4))
    assert call("read_pose", rigid(R), read) == 2
    np.testing.assert_allclose(read, rigid(left @ right), atol=1e-12)
    assert call("read_pose", rigid(left @ right), read) == 1
    np.testing.assert_array_equal(read, rigid(left @ right))


def test_what_is_no_pose_is_refused() -> None:
    be(POSE)
    good, read = rigid(rotation(7)), np.zeros((4, 4))
    assert call("read_pose", good, read) == 1
    for place, value in (((0, 3), np.inf), ((1, 1), np.nan), ((3, 0), 1e-6), ((0, 0), 2.0)):
        bad = good.copy()
        bad[place] = value
        assert call("read_pose", bad, read) == 0
    mirrored = good.copy()
    mirrored[:3, 0] *= -1.0
    assert call("read_pose", mirrored, read) == 0
    be(COORDINATES)
    assert call("read_pose", mirrored, read) == 1  # nothing but the position counts


def test_of_a_pointing_task_the_z_axis_is_made_one_long() -> None:
    be(POINTING)
    T, read = rigid(rotation(8)), np.zeros((4, 4))
    T[:3, 2] *= 1.0 + 1e-6
    assert call("read_pose", T, read) == 2
    np.testing.assert_allclose(np.linalg.norm(read[:3, 2]), 1.0, atol=1e-15)
    T[:3, 2] *= 1.01
    assert call("read_pose", T, read) == 0


def test_angles_of_lists_are_read() -> None:
    T, read = rigid(rotation(8)), np.zeros((4, 4))
    be(YAW)
    length = float(np.hypot(*T[:2, 0]))
    assert call("read_pose", T, read) == 2
    np.testing.assert_allclose(read[:3, 0], [*(T[:2, 0] / length), 0.0], atol=1e-15)
    for x, told in ((1e-7, 2), (1e200, 0), (np.nan, 0)):
        T[:2, 0] = x, 0.0
        assert call("read_pose", T, read) == told
    np.testing.assert_array_equal(read[1:3, 0], 0.0)
    be(PITCH)
    for sine, told, made in ((0.3, 1, 0.3), (-1.0 - 1e-6, 2, -1.0), (1.001, 0, 1.001)):
        T[2, 0] = sine
        assert call("read_pose", T, read) == told
        assert read[2, 0] == made
    be(TILT)
    T[2, :3] = (1.0 + 1e-6) * rotation(8)[2]
    assert call("read_pose", T, read) == 2
    np.testing.assert_allclose(read[2, :3], rotation(8)[2], atol=1e-15)


# refining


def test_a_yaw_is_refined_unless_the_pose_has_none() -> None:
    be(YAW)
    T, q, e = pose(Q), Q + np.array([0.01, -0.02]), np.zeros(6)
    assert call("refine", T, 1e-12, 0.15, q)
    np.testing.assert_allclose(q, Q, atol=1e-11)
    T[:2, 0] = 0.0
    call("miss", T, Q + 0.1, e)
    assert e[5] == 0.0
    be(COORDINATES)


def test_the_miss_is_the_way_to_the_pose() -> None:
    T, e = pose(Q), np.zeros(6)
    there = pose(Q + 0.1)
    expected = T[:2, 3] - there[:2, 3]
    assert call("miss", T, Q + 0.1, e) == pytest.approx(np.linalg.norm(expected), rel=1e-14)
    np.testing.assert_allclose(e, [*expected, 0, 0, 0, 0], atol=1e-15)


@pytest.mark.parametrize("damping", [1e-12, 1e-3, 0.3])
@pytest.mark.parametrize("elbow", [0.9, 1e-7])
def test_a_step_is_that_of_damped_least_squares(damping: float, elbow: float) -> None:
    q = np.array([0.4, elbow])
    x, y = 0.5 * np.cos(q.sum()), 0.5 * np.sin(q.sum())
    J = np.array([[-np.sin(q[0]) - y, -y], [np.cos(q[0]) + x, x]])
    e = np.array([1e-3, -2e-3, 0, 0, 0, 0])
    step = J.T @ np.linalg.solve(J @ J.T + damping * np.eye(2), e[:2])
    found = q.copy()
    call("add_step", damping, e.copy(), found)
    np.testing.assert_allclose(found - q, step, rtol=1e-4, atol=1e-12)


@pytest.mark.parametrize("elbow", [0.9, 0.06, 1e-3, 0.0])
def test_joint_velocities_are_damped_from_a_hundredth_on(elbow: float) -> None:
    """1 / s of a singular value s below it is s / 0.01^2; the spin is not asked for."""
    q, found = np.array([0.4, elbow]), np.zeros(2)
    x, y = 0.5 * np.cos(q.sum()), 0.5 * np.sin(q.sum())
    J = np.array([[-np.sin(q[0]) - y, -y], [np.cos(q[0]) + x, x]])
    twist = np.array([0.3, -0.2, 0.0, 0.0, 0.0, 9.0])
    call("joint_velocities", q, twist, found)
    U, s, V = np.linalg.svd(J)
    expected = V.T @ (s / np.maximum(s, 0.01) ** 2 * (U.T @ twist[:2]))
    np.testing.assert_allclose(found, expected, rtol=1e-11, atol=1e-13)
    assert (s[-1] < 0.01) == (elbow < 0.01)
    assert np.linalg.norm(found) <= np.linalg.norm(twist[:2]) / 0.01


@pytest.mark.parametrize(("dof", "rank"), [(2, 1), (6, 6), (7, 5), (9, 6)])
def test_rows_become_orthogonal(dof: int, rank: int) -> None:
    random = np.random.default_rng(dof)
    A = random.normal(size=(6, rank)) @ random.normal(size=(rank, dof))
    b = random.normal(size=6)
    turned = np.column_stack([A, b])
    call("make_orthogonal", dof, turned)
    products = turned[:, :dof] @ turned[:, :dof].T
    np.testing.assert_allclose(products, np.diag(np.diag(products)), atol=1e-13)
    np.testing.assert_allclose(turned[:, :dof].T @ turned[:, dof], A.T @ b, atol=1e-12)


def test_refining_ends_at_the_solution_unless_that_is_far() -> None:
    T, q, e = pose(Q), Q + np.array([0.01, -0.02]), np.zeros(6)
    assert call("refine", T, 1e-12, 0.15, q)
    np.testing.assert_allclose(q, Q, atol=1e-11)
    assert call("miss", T, q, e) < 1e-12
    far = Q + 0.3
    assert not call("refine", T, 1e-12, 0.15, far)
    np.testing.assert_array_equal(far, Q + 0.3)


def beside_stretched(by: float) -> np.ndarray:
    """A row next to that of the stretched arm at the upper limit, which misses its pose by by^2."""
    return np.array([HIGH + by, -3.0 * by])


def test_a_joint_is_clamped_where_that_is_the_same_solution() -> None:
    T, status = pose(np.array([HIGH, 0.0])), states(OK, UNREACHABLE)
    found = rows(beside_stretched(3e-8), [np.nan, np.nan])
    assert call("clamp", T, 0, 0, found, status)
    assert found[0, 0] <= HIGH + 1e-9
    assert call("miss", T, found[0].copy(), np.zeros(6)) < 2e-14
    beyond = np.array([HIGH + 1e-3, 0.9])  # a regular one is where it is
    found = rows(beyond, [np.nan, np.nan])
    for far in (0, 1):
        assert not call("clamp", pose(beyond), 0, far, found, status)
    np.testing.assert_array_equal(found[0], beyond)


def test_rows_that_meet_are_one() -> None:
    T, status = pose(np.array([HIGH, 0.0])), states(OK, OK)
    found = rows(beside_stretched(3e-8), beside_stretched(-3e-8))
    call("remove_duplicates", T, found, status)
    assert list(status) == [OK, UNREACHABLE]
    assert np.isnan(found[1]).all()
    apart, status = rows(Q, solutions(Q)[1]), states(OK, OK)
    call("remove_duplicates", pose(Q), apart, status)
    assert list(status) == [OK, OK]


def solutions(q: np.ndarray) -> np.ndarray:
    """Both rows of the pose of a configuration with a positive elbow."""
    other = np.arctan2(0.5 * np.sin(q[1]), 1.0 + 0.5 * np.cos(q[1]))
    return np.array([q, [q[0] + 2.0 * other, -q[1]]])


def test_a_seed_that_solves_the_pose_is_followed_where_rows_are_lost() -> None:
    T, empty = pose(Q), np.full((2, 2), np.nan)
    found, status = empty.copy(), states(UNREACHABLE, UNREACHABLE)
    call("follow_seed", T, Q.copy(), found, status)
    assert list(status) == [FREE_JOINT, UNREACHABLE]
    np.testing.assert_array_equal(found[0], Q)
    found, status = empty.copy(), states(UNREACHABLE, UNREACHABLE)
    call("follow_seed", T, Q + 0.5, found, status)
    assert list(status) == [UNREACHABLE, UNREACHABLE]
    found, status = solutions(Q), states(OK, OK)
    call("follow_seed", T, Q.copy(), found, status)
    np.testing.assert_array_equal(found, solutions(Q))


# free joints


@pytest.mark.parametrize("window", [(0.7, 1.1), (-2.9, -1.3), (0.501, 0.502)])
def test_a_lost_row_is_found_by_another_value_of_its_joint(window: tuple[float, float]) -> None:
    library().set_window(*map(ctypes.c_double, window))
    found, status = np.full((2, 2), -0.1), states(UNREACHABLE, 128 + 1)
    call("retry", pose(Q), np.zeros(2), 1, found, status)
    assert list(status) == [UNREACHABLE, OK]
    np.testing.assert_allclose(found[1], solutions(Q)[1], atol=1e-12)


def test_a_row_that_no_value_finds_stays_lost() -> None:
    library().set_window(ctypes.c_double(1.0), ctypes.c_double(-1.0))
    found, status = np.full((2, 2), -0.1), states(UNREACHABLE, 128 + 1)
    call("retry", pose(Q), np.zeros(2), 1, found, status)
    assert list(status) == [UNREACHABLE, UNREACHABLE]
    assert np.isnan(found[1]).all()


# all of it


def test_rows_beyond_limits_are_marked_and_the_nearest_is_inside() -> None:
    q = np.array([1.5, 0.9])
    T, found, status = pose(q), np.zeros((2, 2)), states(0, 0)
    be(COORDINATES, LOW, 1.8)
    assert call("ik", T, np.zeros(2), found, status) == 1
    assert list(status) == [OK, OUT_OF_LIMITS]
    np.testing.assert_allclose(found, solutions(q), atol=1e-12)
    nearest = np.zeros(2)
    assert call("nearest", T, solutions(q)[1].copy(), nearest) == OK
    np.testing.assert_allclose(nearest, q, atol=1e-12)
    assert call("nearest", T, np.array([np.nan, 0.0]), nearest) == -INVALID_POSE
    T[0, 3] = np.nan
    assert call("ik", T, np.zeros(2), found, status) == -INVALID_POSE
    assert list(status) == [INVALID_POSE, INVALID_POSE]


@pytest.mark.parametrize("build", BUILDS)
@pytest.mark.parametrize("count", [0, 1, 7, 8, 19])
def test_a_batch_is_solved_side_by_side_but_for_what_needs_care(build: str, count: int) -> None:
    """One lane a pose: x and 2 x, none where x is negative, care where it is above one.

    The last poses, fewer than there are lanes, are solved one by one, and so are all where lanes
    are single numbers.
    """
    own = library(build)
    T = np.tile(np.eye(4), (count, 1, 1))
    T[:, :2, 3] = np.random.default_rng(9).uniform((-1.0, -0.9), (1.2, 0.9), (count, 2))
    q, status = np.zeros((count, 2, 2)), np.full((count, 2), 77, dtype=np.uint8)
    own.run_batch(ctypes.c_size_t(count), *map(_argument, (T, q, status)))
    lanes = own.run_lanes()
    wide = count // lanes * lanes if lanes > 1 else 0
    for k, (x, y) in enumerate(T[:, :2, 3]):
        expected, kinds = np.zeros((2, 2)), states(0, 0)
        if k >= wide or x > 1.0:
            own.run_ik(*map(_argument, (T[k].copy(), np.zeros(2), expected, kinds)))
        elif x < 0.0:
            expected, kinds = rows([np.nan, y], [np.nan, -y]), states(UNREACHABLE, UNREACHABLE)
        else:
            expected = rows([x, y], [2.0 * x, -y])
            kinds = states(OK, OUT_OF_LIMITS if y > 0.5 else OK)
        np.testing.assert_array_equal(q[k], expected)
        np.testing.assert_array_equal(status[k], kinds)

"""Tasks with yaw, pitch, roll and pitch, and of a direction: all solutions; nothing else counts."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.errors import UnsolvedError
from dhgen.oracle.poses import random_joints
from dhgen.oracle.search import solve
from tests.compiling import solvers_of
from tests.targets.calling import FREE_JOINT, INVALID_POSE, OK, OUT_OF_LIMITS, UNREACHABLE, Solver
from tests.targets.made import apart, entries, in_c, in_python, poses_of, residual, robot

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.arrays import FloatArray

LEVEL = ("yaw_scara", "yaw_planar")
NAMES = (*LEVEL, "pan_tilt", "pitch_arm", "tilting_gantry")
LANGUAGES = ("C", "Python")
HELD = (OK, FREE_JOINT, OUT_OF_LIMITS)


def turn(axis: int, angle: float) -> FloatArray:
    """A rotation about x, y or z."""
    first, second = (axis + 1) % 3, (axis + 2) % 3
    R = np.eye(3)
    R[first, first] = R[second, second] = np.cos(angle)
    R[second, first] = np.sin(angle)
    R[first, second] = -np.sin(angle)
    return R


def rpy(R: FloatArray) -> tuple[float, float, float]:
    """Roll, pitch and yaw of R = Rz(yaw) Ry(pitch) Rx(roll)."""
    pitch = np.arctan2(-R[2, 0], np.hypot(R[2, 1], R[2, 2]))
    return np.arctan2(R[2, 1], R[2, 2]), pitch, np.arctan2(R[1, 0], R[0, 0])


def with_rpy(T: FloatArray, roll: float, pitch: float, yaw: float) -> FloatArray:
    """The pose at the place of another with these angles."""
    turned = T.copy()
    turned[:3, :3] = turn(2, yaw) @ turn(1, pitch) @ turn(0, roll)
    return turned


def like(name: str, T: FloatArray, random: np.random.Generator) -> FloatArray:
    """Another pose of which the task names the same."""
    roll, pitch, yaw = rpy(T[:3, :3])
    other = random.uniform([-3.0, -1.5, -3.0], [3.0, 1.5, 3.0])
    named = robot(name).task.angles
    if not named:  # a direction: the tool turns about it, and is anywhere
        moved = T.copy()
        moved[:3, :3] = T[:3, :3] @ turn(2, other[0])
        moved[:3, 3] += other
        return moved
    kept = zip(("roll", "pitch", "yaw"), (roll, pitch, yaw), other, strict=True)
    return with_rpy(T, *(mine if angle in named else new for angle, mine, new in kept))


@pytest.mark.parametrize("name", NAMES)
def test_all_solutions_are_those_of_a_search(name: str) -> None:
    for q in random_joints(robot(name), 25, seed=4):
        T = poses_of(name, q)
        rows, status = in_c(name).ik(T, np.zeros(len(q)))
        held = rows[np.isin(status, HELD)]
        assert residual(name, held, np.broadcast_to(T, (len(held), 4, 4))) < 1e-12
        found = solve(robot(name), T, (), seed=1, at_least=len(held)).regular
        for solution in found:
            assert apart(name, held, solution).max(axis=1).min() < 1e-6
        assert len(held) == len(found)


@pytest.mark.parametrize("name", NAMES)
def test_own_joint_values_are_found_whatever_else_a_pose_says(name: str) -> None:
    random = np.random.default_rng(11)
    q = random_joints(robot(name), 2000, seed=5)
    T = np.array([like(name, each, random) for each in poses_of(name, q)])
    rows, status = in_c(name).batch(T)
    near = apart(name, rows, q[:, None]).max(axis=2)
    assert np.nanmin(near, axis=1).max() < 1e-6
    assert set(np.unique(status)) <= {OK, UNREACHABLE, OUT_OF_LIMITS, FREE_JOINT}


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", NAMES)
def test_other_entries_may_be_anything(name: str, language: str) -> None:
    solver = Solver(name, language)
    for q in random_joints(robot(name), 5, seed=6):
        T = poses_of(name, q)
        rows, status = solver.all(T, q)
        bare = np.full((4, 4), np.nan)
        bare[:3][entries(name)] = T[:3][entries(name)]
        others, other_status = solver.all(bare, q)
        np.testing.assert_array_equal(others, rows)
        np.testing.assert_array_equal(other_status, status)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", NAMES)
def test_an_angle_that_is_no_number_is_refused(name: str, language: str) -> None:
    T = poses_of(name, random_joints(robot(name), 1, seed=7)[0])
    solver = Solver(name, language)
    for row, column in np.argwhere(entries(name)):
        for wrong in (np.nan, np.inf, -1e200):
            bad = T.copy()
            bad[row, column] = wrong
            if wrong == -1e200 and column == 3:
                continue  # farther than the arm reaches, or than slides may
            reason, _ = solver.nearest(bad, np.zeros(len(robot(name).joints)))
            assert reason == -INVALID_POSE, (row, column, wrong)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("tilt", [1e-3, -0.3, 1.5, 1.57])
@pytest.mark.parametrize("name", LEVEL)
def test_a_tilted_pose_is_an_ordinary_one(name: str, tilt: float, language: str) -> None:
    solver = Solver(name, language)
    for q in random_joints(robot(name), 5, seed=8):
        T = poses_of(name, q)
        rows, status = solver.all(T, q)
        roll, _, yaw = rpy(T[:3, :3])
        others, other_status = solver.all(with_rpy(T, roll + 0.1, tilt, yaw), q)
        np.testing.assert_allclose(others, rows, atol=1e-10)
        np.testing.assert_array_equal(other_status, status)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", LEVEL)
def test_a_vertical_axis_leaves_the_yaw_to_the_seed(name: str, language: str) -> None:
    solver = Solver(name, language)
    for q in random_joints(robot(name), 5, seed=9):
        T = poses_of(name, q)
        upright = with_rpy(T, 0.2, np.pi / 2, 0.7)
        assert np.hypot(*upright[:2, 0]) < 1e-15
        rows, status = solver.all(upright, q)
        assert set(status.tolist()) <= {FREE_JOINT, OUT_OF_LIMITS}
        if OUT_OF_LIMITS not in solver.all(T, q)[1]:  # else another yaw may be inside them
            assert apart(name, rows, q).max(axis=1).min() < 1e-9
        reached = poses_of(name, rows)[:, :3, 3] - T[:3, 3]
        named = list(robot(name).task.position_rows)
        np.testing.assert_allclose(reached[:, named], 0.0, atol=1e-12)


@pytest.mark.parametrize("language", LANGUAGES)
def test_an_arm_without_a_joint_for_its_yaw_reaches_its_own_only(language: str) -> None:
    solver = Solver("yaw_checked", language)
    for q in random_joints(robot("yaw_checked"), 5, seed=10):
        T = poses_of("yaw_checked", q)
        roll, _, yaw = rpy(T[:3, :3])
        rows, status = solver.all(with_rpy(T, roll, 0.5, yaw), q)
        held = np.isin(status, HELD)
        assert apart("yaw_checked", rows[held], q).max(axis=1).min() < 1e-7
        assert solver.all(with_rpy(T, roll, 0.5, yaw + 0.1), q)[1].tolist() == [UNREACHABLE]
        upright = with_rpy(T, 0.0, np.pi / 2, 0.0)
        rows, status = solver.all(upright, q)  # the solution next to the seed
        assert status.tolist() == [FREE_JOINT]
        assert apart("yaw_checked", rows, q).max() < 1e-9


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("end", [1.0, -1.0])
def test_at_a_pitch_of_a_right_angle_two_rows_are_one(end: float, language: str) -> None:
    """Rounding may take its sine just beyond one."""
    q = np.array([0.3, 0.5, 0.6, 0.0])
    q[3] = end * np.pi / 2 - q[1] - q[2]
    T = poses_of("pitch_arm", q)
    for over in (0.0, 1e-13, 1e-6):
        T[2, 0] = end * (1.0 + over)
        rows, status = Solver("pitch_arm", language).all(T, q)
        held = rows[np.isin(status, HELD)]
        assert apart("pitch_arm", held, q).max(axis=1).min() < 1e-6
        assert len(held) == 4
    T[2, 0] = end * 1.001
    status = Solver("pitch_arm", language).all(T, q)[1]
    assert set(status.tolist()) == {INVALID_POSE}


@pytest.mark.parametrize("name", NAMES)
def test_many_poses_are_solved_as_one(name: str) -> None:
    """Poses side by side are solved as alone: tilted, upright and spoiled ones too."""
    random, module = np.random.default_rng(12), in_python(name)
    q = random_joints(robot(name), 12, seed=12)
    T = np.array([like(name, each, random) for each in poses_of(name, q)])
    T[3] = with_rpy(T[3], 0.1, np.pi / 2, 0.0)
    T[5, :3, :3] = np.nan
    batch, statuses = module.ik_batch(T)
    for k, pose in enumerate(T):
        rows, status = module.ik_all(pose)
        np.testing.assert_allclose(batch[k], rows, atol=1e-9)
        np.testing.assert_array_equal(statuses[k], status)


def test_an_arm_that_tilts_its_tool_has_no_yaw_to_be_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "arm.yaml"
    rows = ("{theta: q, d: 0.3, alpha: 1}", "{theta: q, a: 0.4}", "{theta: q, a: 0.2, alpha: 0.3}")
    joints = "".join(f"  - {row}\n" for row in (*rows, "{theta: q, a: 0.1}"))
    path.write_text(f"name: arm\njoints:\n{joints}task: [x, y, z, yaw]\n", encoding="utf-8")
    with pytest.raises(UnsolvedError, match="keeps the tool's x axis level"):
        solvers_of(path)

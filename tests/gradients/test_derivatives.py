"""The derivative of every row, against differences of inverse kinematics and against the C."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType, SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.runtime.helpers import dhgen_grad
from dhgen.runtime.python import places
from tests.gradients.moves import POSTURES, move, robot
from tests.structures import quick_first

if TYPE_CHECKING:
    from collections.abc import Callable

HERE = dhgen_grad.Space(np)


def derivatives(arm: Any, *given: Any) -> tuple[Any, ...]:
    """Of rows by T, and by what is given; then the rows, and their statuses."""
    found = dhgen_grad.Arm(arm)
    rows = found.solve(arm, *given)
    return *found.derivatives(HERE, arm, *given, *rows), *rows


@pytest.mark.parametrize("name", quick_first(POSTURES, count=4))
def test_rows_move_as_their_derivatives_say(name: str) -> None:
    moved = move(name)
    by_pose, *by_given, _, status = derivatives(moved.robot, *moved.given)
    expected = np.einsum("nrjab,nab->nrj", by_pose, moved.rates[0][:, :3])
    for by, rates in zip(by_given, moved.rates[1:], strict=True):
        expected += np.einsum("nrjg,ng->nrj", by, rates)
    found = dhgen_grad.solved(status)[..., 0]
    assert found.sum() >= 2 * len(status)
    np.testing.assert_allclose(expected[found], moved.joints[found], atol=1e-8)


def rolled(T: Any) -> Any:
    """Poses whose tool is turned about its z axis."""
    turn = np.eye(4)
    turn[:3, :3] = rotation(np.array([0.0, 0.0, 0.7]))
    return T @ turn


def pitched(T: Any) -> Any:
    """Poses of the same place and yaw, whose tool is not level, one more than another."""
    turned = T.copy()
    for pose in turned:
        yaw, (x, y) = np.arctan2(pose[1, 0], pose[0, 0]), pose[:2, 3]
        turns = np.diag([0.3 + x, 0.4 + y, yaw])
        pose[:3, :3] = rotation(turns[2]) @ rotation(turns[1]) @ rotation(turns[0])
    return turned


def yawed(T: Any) -> Any:
    """Poses of the same place, roll and pitch, whose tool faces elsewhere."""
    turned = T.copy()
    for pose in turned:
        pose[:3, :3] = rotation(np.array([0.0, 0.0, 0.5 + pose[0, 3]])) @ pose[:3, :3]
    return turned


@pytest.mark.parametrize(("name", "other"), [("welding_5r", rolled), ("abb_irb460", pitched)])
def test_what_the_task_leaves_open_may_be_anything(name: str, other: Callable[[Any], Any]) -> None:
    moved, h = move(name), 1e-5
    (T,), (rates,) = moved.given, moved.rates
    by_pose, *_, status = derivatives(moved.robot, other(T))
    change = (other(T + h * rates) - other(T - h * rates)) / (2 * h)
    expected = np.einsum("nrjab,nab->nrj", by_pose, change[:, :3])
    found = dhgen_grad.solved(status)[..., 0]
    assert (status == moved.status).all()
    np.testing.assert_allclose(expected[found], moved.joints[found], atol=1e-7)


def test_roll_and_pitch_where_the_yaw_is_left_open() -> None:
    """Of an arm's own joints on the move, as if its task were x, y, z, roll and pitch."""
    arm, h = robot("welding_5r"), 1e-5
    numbers = arm._ARM.copy()
    numbers[places.DIRECTIONS], numbers[places.MISS_WEIGHTS + 5] = places.TILT, 0.0
    tilting = dhgen_grad.Arm(SimpleNamespace(**vars(arm) | {"_ARM": numbers}))  # type: ignore[arg-type]
    random = np.random.default_rng(8)
    q = np.array([0.2, 0.9, 0.6, 0.5, 1.1]) + random.uniform(-0.1, 0.1, (20, 5))
    velocities = random.normal(size=q.shape)
    before, now, after = (yawed(arm.fk(q + s * velocities)) for s in (-h, 0.0, h))
    rows = q[:, None], np.zeros((20, 1), np.uint8)
    (by_pose,) = tilting.derivatives(HERE, arm, now, *rows)
    found = np.einsum("nrjab,nab->nrj", by_pose, (after - before)[:, :3] / (2 * h))
    np.testing.assert_allclose(found[:, 0], velocities, atol=1e-7)


@pytest.mark.parametrize("name", ["kuka_iiwa14", "kuka_iiwa14_arm_angle"])
def test_what_is_given_stays_while_the_pose_moves(name: str) -> None:
    moved = move(name)
    by_pose, by_given, q, _ = derivatives(moved.robot, *moved.given)
    twists = np.einsum("nab,nrjab->nrj", moved.rates[0][:, :3], by_pose)
    step = 1e-5
    value = (lambda q: q[..., 2]) if name == "kuka_iiwa14" else moved.robot.arm_angle
    for by, expected in ((twists, 0.0), (by_given[..., 0], 1.0)):
        rate = (value(q + step * by) - value(q - step * by)) / (2 * step)
        np.testing.assert_allclose(rate, expected, atol=1e-8)


def turned(T: Any, twist: Any) -> Any:
    """How fast a pose changes as its tool moves by a twist."""
    change = np.zeros((3, 4))
    change[:, :3] = np.cross(twist[3:], T[:3, :3], axisb=0, axisc=0)
    change[:, 3] = twist[:3]
    return change


@pytest.mark.parametrize(
    ("name", "q"),
    [
        ("ur5", (0.3, -1.1, 1.2, -0.6, 0.0, 0.4)),  # the wrist: a joint is free
        ("ur5", (0.3, -1.1, 1.2, -0.6, 2e-3, 0.4)),
        ("kuka_kr6_r900", (0.3, -1.1, 1.2, 0.5, 3e-3, 0.4)),
        ("scara", (0.4, 1e-3, -0.1, 0.5)),  # stretched
        ("welding_5r", (0.3, 0.7, -1.1, 0.6, 0.4)),
    ],
)
def test_near_singular_poses_they_are_those_of_joint_velocities(
    name: str, q: tuple[float, ...]
) -> None:
    arm = robot(name)
    T = arm.fk(q)
    by_pose, rows, status = derivatives(arm, T)
    found = dhgen_grad.solved(status)[..., 0]
    assert found.any()
    for twist in np.eye(6):
        expected = np.einsum("rjab,ab->rj", by_pose, turned(T, twist))
        velocities = [arm.joint_velocities(row, twist) for row in rows[found]]
        np.testing.assert_allclose(expected[found], velocities, atol=1e-8)
        assert np.abs(velocities).max() < 101  # a hundred arm sizes, which are about a metre


def test_rows_without_a_solution_have_none() -> None:
    arm = robot("ur5")
    reached = arm.fk(POSTURES["ur5"])
    far, invalid = reached.copy(), np.full((4, 4), np.nan)
    far[0, 3] = 5.0
    by_pose, q, status = derivatives(arm, np.array([far, invalid, reached]))
    assert set(status[0]) == {1}
    assert set(status[1]) == {4}
    assert np.isnan(q[:2]).all()
    assert (by_pose[:2] == 0.0).all()
    assert np.isfinite(by_pose).all()
    assert derivatives(arm, np.zeros((0, 4, 4)))[0].shape == (0, 8, 6, 3, 4)


@pytest.mark.parametrize("name", ["ur5", "welding_5r", "abb_irb460"])
def test_stretching_moves_nothing(name: str) -> None:
    moved, random = move(name), np.random.default_rng(3)
    by_pose, *_ = derivatives(moved.robot, *moved.given)
    stretch = random.normal(size=(3, 3))
    change = (stretch + stretch.T) @ moved.given[0][:, :3, :3]
    still = np.einsum("nrjab,nab->nrj", by_pose[..., :3], change)
    np.testing.assert_allclose(still, 0.0, atol=1e-11)


def rotation(w: Any) -> Any:
    """Of a vector w about itself by its length (O. Rodrigues, 1840)."""
    angle = np.linalg.norm(w)
    across = np.cross(w / angle, np.eye(3)).T
    return np.eye(3) + np.sin(angle) * across + (1 - np.cos(angle)) * across @ across


TASKS: dict[str, tuple[Callable[..., Any], Callable[[Any], Any]]] = {
    "yaw": (dhgen_grad._of_yaw, lambda R: [0.0, 0.0, np.arctan2(R[1, 0], R[0, 0])]),
    "pitch": (dhgen_grad._of_pitch, lambda R: [R[2, 0], 0.0, 0.0]),
    "tilt": (dhgen_grad._of_tilt, lambda R: R[2]),  # the vertical in the tool's frame
}


@pytest.mark.parametrize("task", TASKS)
def test_rates_of_what_a_task_names(task: str) -> None:
    rates, measured = TASKS[task]
    random, h = np.random.default_rng(5), 1e-6
    R, w = rotation(random.normal(size=3)), random.normal(size=3)
    after, before = (np.array(measured(rotation(s * w) @ R)) for s in (h, -h))
    np.testing.assert_allclose(rates(HERE, R) @ w, (after - before) / (2 * h), atol=1e-9)


def test_the_rate_of_pointing_is_that_of_the_axis() -> None:
    random = np.random.default_rng(6)
    R, w = rotation(random.normal(size=3)), random.normal(size=3)
    rate = dhgen_grad._of_pointing(HERE, R) @ w
    np.testing.assert_allclose(np.cross(rate, R[:, 2]), np.cross(w, R[:, 2]), atol=1e-14)
    assert abs(rate @ R[:, 2]) < 1e-14


def test_mistakes() -> None:
    T = np.eye(4)
    iiwa, scara = (dhgen_grad.Arm(robot(name)) for name in ("kuka_iiwa14", "scara"))
    with pytest.raises(TypeError, match=r"scara takes nothing besides T"):
        scara.checked(T, T[:1])
    with pytest.raises(TypeError, match=r"kuka_iiwa14 takes \(..., 1\), besides T"):
        iiwa.checked(T)
    with pytest.raises(ValueError, match=r"T must be of shape \(..., 4, 4\), not \(3, 4\)"):
        scara.checked(T[:3])
    with pytest.raises(TypeError, match=r"T must be float64 or float32, not int64"):
        scara.checked(T.astype(int))
    with pytest.raises(ValueError, match=r"q_free must be of shape \(1,\), as T is, not \(2,\)"):
        iiwa.checked(T, np.zeros(2))
    with pytest.raises(TypeError, match=r"the table of ur5e_fleet comes at run time; dhgen cal"):
        dhgen_grad.Arm(import_module("ur5e_fleet"))
    with pytest.raises(TypeError, match=r"a serial arm's module, .* not <module 'nothing'"):
        dhgen_grad.Arm(ModuleType("nothing"))

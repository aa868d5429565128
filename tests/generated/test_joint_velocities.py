"""Joint velocities of the committed files: against differences of poses, at singular ones, in C."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from dhgen.survey.singular import singular_sets, task_jacobian
from tests.generated.asking import trial
from tests.generated.solvers import library, module, robot, short_module

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

# Closed forms, a quartic, the general algorithm, the numerical solver; all kinds of tasks that the
# robots have; more joints than the task names, fewer joints than a pose; slides; coupled drives.
NAMES = [
    "ur5",
    "stanford",
    "welding_5r",
    "katana_400",
    "wrist_zyz",
    "planar_rrrr",
    "kuka_iiwa14_arm_angle",
    "general_6r",
    "kuka_kr40pa_drives",
    "cartesian",
]
BEGINS = 0.01  # the singular value at which damping begins
STEP = 1e-6
ROUNDED = 1e-4  # the files have the arm's size to four digits where lengths are weighed


def rates(name: str, q: FloatArray) -> tuple[FloatArray, FloatArray]:
    """How what the task names changes with all joints, lengths in arm sizes; and these' units."""
    asked = trial(name)
    unit = np.where(asked.model.revolute, 1.0, asked.size)
    whole = replace(robot(name), free=(), arm_angle=False)
    J = task_jacobian(asked.model.divided_by(asked.size), whole, q / unit)
    return np.asarray(J), np.asarray(unit)


def samples(name: str, count: int) -> FloatArray:
    random = np.random.default_rng(5)
    return random.uniform(-2.5, 2.5, (count, module(name).DOF))


@pytest.mark.parametrize("name", NAMES)
def test_a_step_along_them_moves_the_tool_by_the_twist(name: str) -> None:
    """Against the pose of another implementation, a little before and after."""
    python, regular = short_module(name), 0
    for q in samples(name, 60):
        J, unit = rates(name, q)
        if np.linalg.svd(J, compute_uv=False)[-1] < 1.5 * BEGINS:
            continue
        regular += 1
        wanted = unit * np.random.default_rng(7).normal(size=len(q))
        twist = python.jacobian(q) @ wanted
        found = python.joint_velocities(q, twist)
        np.testing.assert_allclose(J @ ((found - wanted) / unit), 0.0, atol=1e-12)
        assert np.linalg.norm(found / unit) <= np.linalg.norm(wanted / unit) + 1e-9
        there, back = (forward(robot(name), q + way * STEP * found) for way in (1.0, -1.0))
        moved = (there - back) / (2.0 * STEP)
        rows = list(robot(name).task.position_rows)
        size = trial(name).size
        np.testing.assert_allclose(moved[rows, 3] / size, twist[rows] / size, atol=1e-6)
        if robot(name).task.names_rotation:
            spin = moved[:3, :3] @ forward(robot(name), q)[:3, :3].T
            turned = [spin[2, 1], spin[0, 2], spin[1, 0]]
            np.testing.assert_allclose(turned, twist[3:], atol=1e-6)
    assert regular > 20


@pytest.mark.parametrize("name", NAMES)
def test_c_finds_what_python_finds(name: str) -> None:
    random = np.random.default_rng(11)
    for q in samples(name, 60):
        twist = random.normal(size=6)
        found = short_module(name).joint_velocities(q, twist)
        scale = max(1.0, float(np.abs(found).max()))
        np.testing.assert_allclose(
            library(name).joint_velocities(q, twist), found, atol=1e-10 * scale
        )


@pytest.mark.parametrize("name", ["ur5", "stanford", "welding_5r", "general_6r"])
def test_at_singular_poses_they_are_bounded_and_lose_only_what_the_arm_lost(name: str) -> None:
    """A motion that is along singular directions alone stops; all others are exact."""
    seen = 0
    for places in singular_sets(robot(name), 6).values():
        for q in places:
            J, unit = rates(name, q)
            _, values, V = np.linalg.svd(J)
            if not values[-1] < BEGINS / 10 < 2 * BEGINS < values[-2]:
                continue
            seen += 1
            clear = V[:-1].T @ np.random.default_rng(3).normal(size=len(V) - 1)
            for wanted, still in ((clear, False), (V[-1], True)):
                twist = short_module(name).jacobian(q) @ (unit * wanted)
                found = short_module(name).joint_velocities(q, twist) / unit
                bound = (1.0 + ROUNDED) * np.linalg.norm(J @ wanted) / BEGINS
                assert np.linalg.norm(found) <= bound
                if still:
                    assert np.linalg.norm(found) < 0.1
                else:
                    np.testing.assert_allclose(found, wanted, atol=ROUNDED)
    assert seen > 3


def test_arguments_are_looked_at() -> None:
    python = module("ur5")
    zero = python.joint_velocities([0, 1, 1, 1, 1, 1], [0] * 6)
    np.testing.assert_array_equal(zero, np.zeros(6))
    with pytest.raises(ValueError, match="twist must have shape"):
        python.joint_velocities(np.zeros(6), np.zeros(3))
    with pytest.raises(ValueError, match="q must have shape"):
        python.joint_velocities(np.zeros(5), np.zeros(6))

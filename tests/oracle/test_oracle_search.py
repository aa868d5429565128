"""The oracle finds as many solutions as are known to exist, and each of them is one."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from dhgen.oracle.poses import random_joints
from dhgen.oracle.problem import task_entries
from dhgen.oracle.search import solve
from dhgen.robot.expression import DEGREE, ZERO, Binary, Number
from dhgen.robot.robot import Convention, DhRow, DhTable, JointKind, Robot
from dhgen.robot.task import Task, TaskKind
from tests.oracle.sets import all_solutions, out_of_form, out_of_reach
from tests.robots.cases import COUNTS, NAMES, robot

ABSENT = 1e-6


def holds(solutions: np.ndarray, q: np.ndarray, name: str) -> bool:
    """Whether q is among the solutions, revolute joints modulo a turn."""
    turns = np.array([joint.kind is JointKind.REVOLUTE for joint in robot(name).joints])
    gap = solutions - q
    gap = np.where(turns, np.remainder(gap + np.pi, 2 * np.pi) - np.pi, gap)
    return bool((np.abs(gap).max(axis=1) < ABSENT).any())


@pytest.mark.parametrize("name", NAMES)
def test_the_known_number_of_solutions(name: str) -> None:
    entries = task_entries(robot(name).task)
    most = 0
    for q in random_joints(robot(name), 5, seed=3):
        T = forward(robot(name), q)
        solutions = all_solutions(robot(name), T)
        assert holds(solutions, q, name)
        found = forward(robot(name), solutions)[:, :3].reshape(-1, 12)[:, entries]
        wanted = T[:3].ravel()[entries]
        np.testing.assert_allclose(found, np.tile(wanted, (len(found), 1)), rtol=1e-12, atol=1e-12)
        most = max(most, len(solutions))
    assert most == COUNTS[name]


@pytest.mark.parametrize("name", ["scara", "puma560", "ur5", "rrprrr"])
def test_the_answer_does_not_depend_on_the_starts(name: str) -> None:
    T = forward(robot(name), random_joints(robot(name), 1, seed=8)[0])
    first, second = (all_solutions(robot(name), T, seed=seed) for seed in (0, 1))
    np.testing.assert_allclose(first, second, rtol=0, atol=1e-9)


@pytest.mark.parametrize("name", ["planar_rr", "scara", "puma560", "adept"])
def test_nothing_is_found_where_there_is_nothing(name: str) -> None:
    for T in [*out_of_reach(robot(name), 2), *out_of_form(robot(name), 2)]:
        found = solve(robot(name), T)
        assert found.regular.shape == found.singular.shape == (0, len(robot(name).joints))


def test_a_stretched_arm_is_one_singular_solution() -> None:
    found = solve(robot("planar_rr"), forward(robot("planar_rr"), [0.3, 0.0]))
    assert len(found.regular) == 0
    np.testing.assert_allclose(found.singular, [[0.3, 0.0]], atol=1e-6)


def test_a_singular_wrist_is_a_continuum_beside_the_regular_solutions() -> None:
    q = random_joints(robot("puma560"), 1)[0]
    q[4] = 0.0
    found = solve(robot("puma560"), forward(robot("puma560"), q))
    assert len(found.regular) == 6
    assert len(found.singular) > 50


@pytest.mark.parametrize("near", [1e-6, 1e-8, 1e-10])
def test_both_postures_of_a_nearly_singular_wrist(near: float) -> None:
    q = np.array([0.8, near, -1.7])
    found = solve(robot("wrist_zyz"), forward(robot("wrist_zyz"), q))
    both = np.concatenate([found.regular, found.singular])
    assert len(both) == 2
    assert holds(both, q, "wrist_zyz")


@pytest.mark.parametrize("near", [1e-6, 1e-8, 1e-10])
def test_a_nearly_stretched_arm_has_two_solutions_or_one_double(near: float) -> None:
    found = solve(robot("planar_rr"), forward(robot("planar_rr"), [0.3, near]))
    assert (len(found.regular), len(found.singular)) == ((2, 0) if near == 1e-6 else (0, 1))


def test_a_free_joint_keeps_its_value() -> None:
    arm_3r = replace(robot("planar_rrr"), task=Task(TaskKind.LIST, ("x", "y")), free=(2,))
    q = np.array([0.4, 0.9, -0.7])
    solutions = all_solutions(arm_3r, forward(arm_3r, q), [0.9])
    assert len(solutions) == 2
    np.testing.assert_array_equal(solutions[:, 1], 0.9)
    assert holds(solutions, q, "planar_rrr")


def test_pointing_leaves_the_last_turn_open() -> None:
    # without its last joint the PUMA still points; each arm posture does so in two ways
    puma = robot("puma560")
    assert isinstance(puma.geometry, DhTable)
    five = DhTable(puma.geometry.convention, puma.geometry.rows[:5])
    pointing = replace(puma, geometry=five, task=Task(TaskKind.POINTING))
    # frame 5 has z along axis 6, which joint 5 turns
    T = forward(pointing, random_joints(pointing, 1)[0])
    assert len(all_solutions(pointing, T)) == 8


def general_arm() -> Robot:
    """Manseur and Doty's arm, A robot manipulator with 16 real inverse kinematic solutions."""
    degrees = (90, 1, 90, 1, 90, 1)
    a = ("0.3", "1", "0", "1.5", "0", "0")
    d = ("0", "0", "0.2", "0", "0", "0")
    rows = tuple(
        DhRow(
            JointKind.REVOLUTE,
            1,
            ZERO,
            Number(Fraction(d_i)),
            Number(Fraction(a_i)),
            Binary("*", Number(Fraction(alpha)), DEGREE),
        )
        for d_i, a_i, alpha in zip(d, a, degrees, strict=True)
    )
    return replace(robot("puma560"), geometry=DhTable(Convention.STANDARD, rows))


def test_sixteen_solutions_of_a_general_arm() -> None:
    T = np.array(
        [
            [-0.760117, -0.641689, 0.102262, -1.140175],
            [0.133333, 0.0, 0.991071, 0.0],
            [-0.635959, 0.766965, 0.085558, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )
    U, _, V = np.linalg.svd(T[:3, :3])  # printed to six digits only
    T[:3, :3] = U @ V
    assert len(all_solutions(general_arm(), T)) == 16

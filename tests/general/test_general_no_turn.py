"""A joint too few for the task, without structure: one more turn, which has to be zero."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.general.arm import general_kernel
from dhgen.general.no_turn import without_turn
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import whole_program
from dhgen.robot.load import load
from dhgen.status import Status
from tests.general.files import SLIDE, TURNS, compiled, skew, without_derivation
from tests.oracle.sets import all_solutions

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.kinematics.chain import Chain
    from dhgen.program.interpret import Rows

POSES = 2
# At NEARLY another way to stand takes the tool to the same place but for 8e-6.
TWISTED = """name: arm
joints:
  - {theta: q, d: 0.007, a: 0.126, alpha: 2.487}
  - {theta: q, d: -0.046, a: -0.211, alpha: 1.609}
  - {theta: q, d: 0.152, a: 0.186, alpha: 2.135}
  - {theta: q, d: -0.028, a: 0.209, alpha: -0.848}
  - {theta: q, d: 0.150, a: -0.235, alpha: -2.558}
tool: {xyz: [0.05, 0.02, 0.11], rpy: [0.3, 0.4, -0.2]}
"""
NEARLY = (1.11882171, 2.53570551, -0.09606933, 2.52138356, 3.13879235)
# Axes 1, 2 and 3 meet. Where the tool's point comes next to where they do, joint values in a long
# row take the tool to the same place but for some 1e-9.
AIMED = """name: arm
task: pointing
joints:
  - {theta: q - pi/2, alpha: pi/2}
  - {theta: q, alpha: pi/2}
  - {theta: q, d: 0.508, a: 0.137, alpha: pi/2}
  - {theta: q + 0.4, alpha: -pi/2}
"""
NEXT_TO_SINGULAR = (1.592058934, -0.189639291, 0.606465747, 2.478174412)


def solved(chain: Chain, T: np.ndarray, values: list[float] | None = None) -> Rows:
    kernel = general_kernel(chain)
    assert kernel is not None
    assert kernel.checked
    free = None if values is None else np.array(values)
    return interpret(whole_program(chain, kernel), T, seed=np.zeros(chain.dof), free=free)


def gaps(rows: np.ndarray, q: np.ndarray) -> np.ndarray:
    return np.asarray(np.abs(np.remainder(rows - q + np.pi, 2 * np.pi) - np.pi).max(axis=-1))


@pytest.mark.parametrize(
    ("place", "free", "task"),
    [
        *((place, (), "pose") for place in range(6)),
        (0, (1,), "pose"),
        *((place, (), "pointing") for place in range(5)),
        (0, (1,), "pointing"),
    ],
)
def test_all_solutions(tmp_path: Path, place: int, free: tuple[int, ...], task: str) -> None:
    """Without a slide (place 0) and with one at each place; and on a joint that is given.

    Five joints that take whole poses, and four whose tool points.
    """
    turns = TURNS if task == "pose" else TURNS[:4]
    rows = turns if place == 0 else (*turns[: place - 1], SLIDE, *turns[place:])
    arm = skew(tmp_path, (SLIDE, *rows) if free else rows, free, task)
    chain = build_chain(arm)
    forward = numeric_arm(chain)
    joints = np.random.default_rng(place).uniform(-1.5, 1.5, (POSES, chain.dof))
    joints[:, [number - 1 for number in free]] = 0.2
    poses = forward.pose(joints)
    named = np.s_[..., 2:] if task == "pointing" else np.s_[...]
    found = solved(chain, poses, [0.2] if free else None)
    for k, T in enumerate(poses):
        q = found.q[k][found.solved[k]]
        expected = all_solutions(arm, T, [0.2] if free else [])
        np.testing.assert_allclose(forward.pose(q)[named], [T[named]] * len(q), atol=1e-9)
        assert len(q) == len(expected)
        assert gaps(q, joints[k]).min() < 1e-6
        for row in expected:
            assert gaps(q, row).min() < 1e-6


def test_poses_that_were_rounded_and_poses_that_are_not_the_arms(tmp_path: Path) -> None:
    chain = build_chain(skew(tmp_path, TURNS))
    forward = numeric_arm(chain)
    joints = np.random.default_rng(9).uniform(-3.0, 3.0, (2, 5))
    rounded = np.round(forward.pose(joints), 6)
    found = solved(chain, rounded)
    for k, q in enumerate(joints):
        rows = found.q[k][found.solved[k]]
        assert gaps(rows, q).min() < 1e-4
        np.testing.assert_allclose(forward.pose(rows), [rounded[k]] * len(rows), atol=1e-5)
    turned = forward.pose(joints)
    turned[:, :3, :2] = turned[:, :3, :2] @ [[0.8, -0.6], [0.6, 0.8]]
    assert not solved(chain, turned).solved.any()


def test_a_turn_that_is_not_zero_is_set_aside_at_once() -> None:
    """Only near to singular places rounding turns what the arm does not have by more."""
    angles = np.array([[0.3] * 5 + [turn] for turn in (0.0, 0.005, 0.05, -0.5)])
    for in_doubt, count in ((False, 2), (True, 3)):
        assert len(without_turn(angles, 5, in_doubt=in_doubt)) == count


def test_in_c(tmp_path: Path) -> None:
    """And what nearly takes a pose counts only where the pose has been rounded."""
    (tmp_path / "arm.yaml").write_text(TWISTED, encoding="utf-8")
    arm = load(tmp_path / "arm.yaml")
    module = without_derivation(arm)
    solver = compiled(module, tmp_path)
    seed = np.zeros(5)
    for q in (np.array(NEARLY), *np.random.default_rng(4).uniform(-3.0, 3.0, (20, 5))):
        T = solver.fk(q)
        rows, status = solver.ik(T, seed)
        assert (status != Status.UNREACHABLE).sum() == 1
        assert gaps(rows[0], q) < 1e-6
        T[:3, 3] += 1e-3
        assert (solver.ik(T, seed)[1] == Status.UNREACHABLE).all()
    T = np.round(solver.fk(np.array(NEARLY)), 6)
    rows, status = solver.ik(T, seed)
    held = rows[status != Status.UNREACHABLE]
    assert len(held) == 2
    assert gaps(held, np.array(NEARLY)).min() < 1e-4
    for row in held:
        np.testing.assert_allclose(solver.fk(row), T, atol=2e-5)
    known = interpret(module.solver, T[None], seed=seed)
    np.testing.assert_allclose(held, known.q[0][known.solved[0]], atol=1e-9)


def test_four_joints_whose_tool_points_in_c(tmp_path: Path) -> None:
    """Whatever the two columns hold that nobody names; and a direction that the arm can't take."""
    module = without_derivation(skew(tmp_path, TURNS[:4], task="pointing"))
    solver = compiled(module, tmp_path)
    for q in np.random.default_rng(4).uniform(-3.0, 3.0, (20, 4)):
        T = solver.fk(q)
        T[:3, :2] = np.nan
        rows, status = solver.ik(T, np.zeros(4))
        assert gaps(rows[status != Status.UNREACHABLE], q).min() < 1e-6
        T[:3, 2] = [*T[1:3, 2], T[0, 2]]
        assert (solver.ik(T, np.zeros(4))[1] == Status.UNREACHABLE).all()


def test_exact_solutions_are_not_left_for_what_a_rounded_pose_may_miss(tmp_path: Path) -> None:
    """Where joints are nearly free a step towards the seed keeps a row as exact as it is."""
    (tmp_path / "arm.yaml").write_text(AIMED, encoding="utf-8")
    module = without_derivation(load(tmp_path / "arm.yaml"))
    solver = compiled(module, tmp_path)
    T, seed = solver.fk(np.array(NEXT_TO_SINGULAR)), np.zeros(4)
    rows, status = solver.ik(T, seed)
    known = interpret(module.solver, T[None], seed=seed)
    for held in (rows[status != Status.UNREACHABLE], known.q[0][known.solved[0]]):
        reached = np.array([solver.fk(np.ascontiguousarray(row)) for row in held])
        np.testing.assert_allclose(reached[:, :3, 2:], [T[:3, 2:]] * len(held), atol=2e-10)

"""Three concurrent or parallel axes anywhere, slides among the others: all solutions, at most 8."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.method import Method
from dhgen.paul.derive import derive
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from dhgen.robot.load import load
from tests.oracle.sets import all_solutions
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

POSES = 2


def structured_arm(kind: str, first: int, slide: int | None) -> str:
    """A standard table of six joints; axes first to first + 2 are concurrent or parallel.

    All other lengths and twists are arbitrary.
    """
    draw = random.Random(7 * first + len(kind) + (slide or 0))  # noqa: S311 - arms, not secrets
    rows = []
    for joint in range(1, 7):
        a, d = (round(draw.uniform(0.1, 0.6), 3) for _ in range(2))
        alpha = f"{draw.choice([-1, 1]) * draw.randint(25, 155)} deg"
        if kind == "concurrent":
            a = 0.0 if joint in {first, first + 1} else a
            d = 0.0 if joint == first + 1 else d
        elif joint in {first, first + 1}:
            alpha = "0"
        if joint == slide:
            rows.append(f"{{theta: 0.7, d: q, a: {a}, alpha: {alpha}, limits: [-1, 1]}}")
        else:
            rows.append(f"{{theta: q, d: {d}, a: {a}, alpha: {alpha}}}")
    lines = "\n".join(f"  - {row}" for row in rows)
    return f"name: arm\nsource: made up\nconvention: standard\njoints:\n{lines}\n"


@pytest.mark.parametrize(
    ("kind", "first", "slide"),
    first_of(
        [
            # 3-4-5 and 4-5-6 concurrent, 1-2-3 and 2-3-4 parallel stand in robots/ too; 3-4-5
            # parallel is solved with a slide here, and as it is where the tool points
            ("parallel", 3, 2),
            ("concurrent", 4, 1),
            ("concurrent", 1, None),
            ("concurrent", 2, None),
            ("parallel", 4, None),
        ]
    ),
)
def test_every_solution_is_found(tmp_path: Path, kind: str, first: int, slide: int | None) -> None:
    path = tmp_path / "arm.yaml"
    path.write_text(structured_arm(kind, first, slide), encoding="utf-8")
    robot = load(path)
    chain = build_chain(robot)
    derivation = derive(chain)
    assert derivation.steps
    assert derivation.branches <= 8
    arm = numeric_arm(chain)
    q = np.random.default_rng(first).uniform(-2.8, 2.8, (POSES, 6))
    poses = arm.pose(q)
    rows = interpret(lower(derivation), poses)
    for number, pose in enumerate(poses):
        found = rows.q[number][rows.solved[number]]
        expected = all_solutions(robot, pose)
        assert len(found) == len(expected)
        for solution in expected:
            apart = np.abs((found - solution + np.pi) % (2.0 * np.pi) - np.pi)
            assert apart.max(axis=1).min() < 1e-6
        np.testing.assert_allclose(
            arm.pose(found), np.broadcast_to(pose, (len(found), 4, 4)), atol=1e-11
        )


@pytest.mark.parametrize("first", first_of([2, 1, 3]))
def test_five_joints_that_point_about_parallel_axes(tmp_path: Path, first: int) -> None:
    """By a quartic: the tool's turn about its own axis need not be found with the joints."""
    path = tmp_path / "arm.yaml"
    *rows, _ = structured_arm("parallel", first, None).rstrip("\n").splitlines()
    tool = "task: pointing", "tool: {xyz: [0.05, 0.02, 0.2], rpy: [0, 40 deg, 0]}"
    path.write_text("\n".join([*rows, *tool]), encoding="utf-8")
    robot = load(path)
    chain = build_chain(robot)
    derivation = derive(chain)
    assert derivation.method is Method.QUARTIC
    assert derivation.branches <= (8 if first == 2 else 16)  # some contradict an equation
    arm = numeric_arm(chain)
    poses = arm.pose(np.random.default_rng(first).uniform(-2.8, 2.8, (POSES, 5)))
    rows_of = interpret(lower(derivation), poses)
    for number, pose in enumerate(poses):
        found = rows_of.q[number][rows_of.solved[number]]
        expected = all_solutions(robot, pose)
        assert len(found) == len(expected) <= 8
        reached = arm.pose(found)[:, :3, 2:]
        np.testing.assert_allclose(
            reached, np.broadcast_to(pose[:3, 2:], reached.shape), atol=1e-11
        )

"""The arm angle of other arms than those in robots/, and arms that have none."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.errors import UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.oracle.arm_angle import arm_angle
from dhgen.oracle.forward import forward
from dhgen.paul.derive import derive
from dhgen.paul.kind import Kind
from dhgen.paul.mobility import open_from_the_start, surplus
from dhgen.paul.refusal.redundancy import redundant
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from tests.kinematics.values import table
from tests.structures import first_of

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.program.interpret import Rows
    from dhgen.robot.robot import Robot

SHOULDER = ("theta: q, d: 0.3, alpha: pi/2", "theta: q, alpha: -pi/2")
WRIST = ("theta: q, d: 0.35, alpha: pi/2", "theta: q, alpha: -pi/2", "theta: q, d: 0.1, a: 0.02")
PLAIN = (*SHOULDER, "theta: q, d: 0.4, alpha: pi/2", "theta: q, alpha: -pi/2", *WRIST)
# the elbow of a Barrett WAM
OFFSET_ELBOW = ("theta: q, d: 0.4, a: 0.05, alpha: pi/2", "theta: q, a: -0.05, alpha: -pi/2")
OFFSET = (*SHOULDER, *OFFSET_ELBOW, *WRIST)
# wrist and shoulder are not at one height along axis 4: such an arm is never straight
LEANING_ELBOW = ("theta: q, d: 0.4, alpha: pi/2", "theta: q, d: 0.08, alpha: -pi/2")
LEANING = (*SHOULDER, *LEANING_ELBOW, *WRIST)
FOLDING = (*PLAIN[:4], "theta: q, d: 0.4, alpha: pi/2", *PLAIN[5:])
MODIFIED = (
    "alpha: 0.4, theta: q, d: 0.3",
    "alpha: -pi/2, theta: -q",
    "alpha: pi/2, theta: q, d: 0.4",
    "alpha: pi/2, theta: q + 0.2",
    "alpha: -pi/2, theta: q, d: 0.35",
    "alpha: -pi/2, theta: q",
    "alpha: pi/2, theta: q, d: 0.1",
)
MOVED = {
    "base": "{xyz: [0.1, -0.2, 0.3], rpy: [0.3, 0.2, -0.5]}",
    "tool": "{xyz: [0.01, 0.02, 0.1], rpy: [0.1, -0.4, 0.2]}",
}
ARMS = {
    "plain": (PLAIN, {}),
    "offset elbow": (OFFSET, MOVED),
    "leaning elbow": (LEANING, {}),
    "folding": (FOLDING, {}),
    "modified convention": (MODIFIED, MOVED | {"convention": "modified"}),
}


def arm(name: str) -> Robot:
    rows, sections = ARMS[name]
    return table(*rows, free="arm_angle", **sections)


def rows_of(robot: Robot, T: FloatArray, psi: FloatArray) -> Rows:
    """All rows of poses (N, 4, 4) at arm angles (N,)."""
    return interpret(lower(derive(build_chain(robot))), T, None, psi[:, None])


def turned(angles: FloatArray) -> FloatArray:
    return np.asarray(np.abs(np.remainder(angles + np.pi, 2 * np.pi) - np.pi))


@pytest.mark.parametrize("name", first_of(ARMS, count=2))
def test_joint_values_are_found_again_and_every_row_has_the_arm_angle(name: str) -> None:
    robot = arm(name)
    q = np.random.default_rng(9).uniform(-3.0, 3.0, (60, 7))
    T, psi = forward(robot, q), arm_angle(robot, q)
    rows = rows_of(robot, T, psi)
    assert rows.solved.all()
    assert rows.q.shape == (60, 8, 7)
    assert turned(rows.q - q[:, None]).max(axis=2).min(axis=1).max() < 1e-9
    assert np.abs(forward(robot, rows.q) - T[:, None]).max() < 1e-12
    assert turned(arm_angle(robot, rows.q) - psi[:, None]).max() < 1e-9


@pytest.mark.breadth
def test_oblique_axes_need_no_quartic() -> None:
    """z of axis 3 is no column of frame 3 then, but one of B A_3^-1."""
    rows = (
        "theta: q, d: 0.3, alpha: 1.1",
        "theta: q, alpha: -0.9",
        "theta: q, d: 0.4, alpha: 1.3",
        "theta: q, alpha: -pi/2",
        *WRIST,
    )
    derivation = derive(build_chain(table(*rows, free="arm_angle")))
    assert derivation.branches == 8
    assert Kind.CIRCLE not in {step.kind for step in derivation.steps}


def test_a_wrist_in_the_shoulder_is_answered() -> None:
    """Forearm and upper arm are of one length, and folded: any rotation of the shoulder serves."""
    robot = arm("folding")
    chain = build_chain(robot)
    q = np.array([[0.3, 0.5, -0.2, np.pi, 0.4, 0.6, 0.1]])
    T = numeric_arm(chain).pose(q)
    rows = rows_of(robot, T, np.array([0.4]))
    assert rows.solved.any()
    assert np.abs(forward(robot, rows.q[rows.solved]) - T).max() < 1e-11


REFUSED = {
    "this one has 5 joints": (("theta: q, d: 0.3, alpha: pi/2",) * 5, {}),
    "this one has 1 joint": (("theta: q",), {}),
    "not all of its joints are revolute": (("theta: 0, d: q", *PLAIN[1:]), {}),
    "the task must be a whole pose": (PLAIN, {"task": "position"}),
    "axes 5, 6, 7 miss one point by 0.088: there is no wrist": (
        (*PLAIN[:5], "theta: q, a: 0.088, alpha: -pi/2", PLAIN[6]),
        {},
    ),
    "axes 1, 2, 3 miss one point by 0.05: there is no shoulder": (
        ("theta: q, d: 0.3, a: 0.05, alpha: pi/2", *PLAIN[1:]),
        {},
    ),
    "two of axes 1, 2, 3 are parallel: there is no shoulder": (
        ("theta: q, d: 0.3", *PLAIN[1:]),
        {},
    ),
    "axis 4 passes through the shoulder: there is no elbow": (
        (*SHOULDER, "theta: q, alpha: pi/2", *PLAIN[3:]),
        {},
    ),
    "axis 4 passes through the wrist: there is no elbow": (
        (*PLAIN[:4], "theta: q, alpha: pi/2", *PLAIN[5:]),
        {},
    ),
}


@pytest.mark.parametrize("reason", REFUSED)
def test_arms_without_an_arm_angle_are_refused_with_the_reason(reason: str) -> None:
    rows, sections = REFUSED[reason]
    with pytest.raises(UnsolvedError) as info:
        derive(build_chain(table(*rows, free="arm_angle", **sections)))
    first, *reasons = str(info.value).splitlines()
    assert first.startswith("free: arm_angle is for arms of seven joints")
    assert f"  {reason}" in reasons


def test_a_redundant_arm_is_told_of_it() -> None:
    """Seven joints without anything given: the arm angle is named where there is one."""
    chain = build_chain(table(*PLAIN))
    spare = surplus(chain)
    told = redundant(chain, spare, open_from_the_start(chain, spare), ()).splitlines()
    assert "  free: arm_angle fixes the elbow's position on its circle instead" in told

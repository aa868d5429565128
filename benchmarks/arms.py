"""The arms that are measured: one of every kind, with what a rival has to be told about it."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import pi
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.load import load
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.numeric import NumericArm
    from dhgen.robot.robot import Robot

CHECKOUT = Path(__file__).resolve().parent.parent
BESIDE = CHECKOUT / "benchmarks" / "robots"  # arms that nothing else is made of
SEED = 20261


@dataclass(frozen=True, slots=True)
class Case:
    """A line of the benchmark.

    Attributes:
        name: The robot file.
        kind: What such arms are called.
        targets: Nanoseconds a pose that a way of calling the solver is meant to stay under.
        upright: Joint values where an ortho-parallel arm stands straight up, as py-opw-kinematics
            wants its zero; None for arms that are not of this family.
        universal_robot: The arm's name in ur-analytic-ik, or "".
    """

    name: str
    kind: str
    targets: dict[str, float] = field(default_factory=dict)
    upright: tuple[float, ...] | None = None
    universal_robot: str = ""


PYTHON_TARGETS = {"Python, ik_into": 500.0, "Python, ik_all": 1000.0}
WRIST_TARGETS = {"C, scalar": 350.0, "C, batch": 50.0, "Python, ik_batch": 80.0, **PYTHON_TARGETS}

CASES = (
    Case(
        "kuka_kr6_r900",
        "ortho-parallel 6R",
        {"C, one pose": 80.0, "C, one pose, AVX2": 105.0, **WRIST_TARGETS},
        upright=(0.0,) * 6,
    ),
    Case(
        "puma560",
        "spherical wrist, all offsets",
        {"C, one pose": 60.0, **WRIST_TARGETS},
        upright=(0.0, pi / 2, -pi / 2, 0.0, 0.0, 0.0),
    ),
    Case(
        "ur5", "three parallel axes", {"C, one pose": 75.0, **WRIST_TARGETS}, universal_robot="ur5"
    ),
    Case("stanford", "RRPRRR", {"C, one pose": 55.0, **PYTHON_TARGETS}),
    Case("scara", "SCARA", {"C, one pose": 25.0, **PYTHON_TARGETS}),
    Case("xarm6", "general 6R", {"C, one pose": 8000.0}),
    Case("kinova_jaco2", "general 6R", {"C, one pose": 8000.0}),
    Case("fanuc_crx10ia", "cobot, offset wrist", {"C, one pose": 5000.0}),
)


@dataclass(frozen=True, slots=True)
class Arm:
    """A case with its robot file read.

    Attributes:
        case: What is measured.
        robot: The file.
        model: The forward model that judges every answer.
    """

    case: Case
    robot: Robot
    model: NumericArm

    @property
    def dof(self) -> int:
        """Number of joints."""
        return len(self.robot.joints)

    @property
    def turning(self) -> tuple[bool, ...]:
        """Which joints are revolute."""
        return tuple(joint.kind is JointKind.REVOLUTE for joint in self.robot.joints)

    def random_poses(self, count: int) -> FloatArray:
        """Poses (count, 4, 4) of joint values spread evenly over whole turns and limits."""
        return self.model.pose(self.random_joints(count))

    def random_joints(self, count: int) -> FloatArray:
        """The joint values (count, n) of these poses."""
        draw = np.random.default_rng(SEED)
        spans = [_span(joint.kind, joint.limits) for joint in self.robot.joints]
        low, high = np.array(spans).T
        return np.asarray(draw.uniform(low, high, (count, self.dof)))

    def aligned_poses(self, count: int) -> FloatArray:
        """Poses (count, 4, 4) whose revolute joints stand at multiples of a quarter turn."""
        draw = np.random.default_rng(SEED)
        spans = [_span(joint.kind, joint.limits) for joint in self.robot.joints]
        middle = np.mean(spans, axis=1)
        quarters = draw.integers(-1, 3, (count, self.dof)) * (pi / 2)
        return self.model.pose(np.where(self.turning, quarters, middle))


def _span(kind: JointKind, limits: tuple[float, float] | None) -> tuple[float, float]:
    """Whole turns, and for a slide its limits or a metre."""
    if kind is JointKind.REVOLUTE:
        return (-pi, pi)
    return limits or (0.2, 1.2)


def read_arm(case: Case) -> Arm:
    """A case with its robot file.

    Raises:
        RobotFileError: There is no such file.
    """
    robot = load(robot_path(case.name))
    return Arm(case, robot, numeric_arm(build_chain(robot)))


def robot_path(name: str) -> Path:
    """The robot file of the checkout: one of `robots/`, or one that is measured alone."""
    own = BESIDE / f"{name}.yaml"
    return own if own.exists() else CHECKOUT / "robots" / own.name

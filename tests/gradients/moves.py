"""Arms on the move: what inverse kinematics finds a little before and a little after a pose."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import Any

import numpy as np

from dhgen.runtime.helpers.dhgen_native import native
from tests.generated.solvers import GENERATED

# Joint values around which every row with joint values is far from singular poses.
POSTURES = {
    "ur5": (-1.2, -0.8, 0.9, 0.2, -1.2, -0.2),  # closed form
    "kuka_kr6_r900": (0.1, -0.5, -0.4, -0.4, 1.5, 0.4),
    "scara": (-0.8, -0.2, -1.2, 0.3),  # four joints, and what these can do
    "xarm6": (-0.2, 0.2, -1.1, -1.3, 1.3, -1.2),  # general
    "kuka_iiwa14": (0.4, 0.3, 0.1, -1.1, -1.3, 1.5, 1.2),  # joint 3 is given
    "kuka_iiwa14_arm_angle": (0.9, 1.4, 1.1, 1.4, -0.9, 1.4, -1.4),  # so is its arm angle
    "welding_5r": (0.0, 1.0, 0.5, 0.4, 1.4),  # the tool points
    "abb_irb460": (0.7, 1.2, 0.7, 1.2),  # position and yaw
}
STEP = 1e-5  # of differences: they are right to its square


@dataclass(frozen=True, slots=True)
class Move:
    """Poses of one arm along a motion of its joints, and by how much rows move.

    Attributes:
        robot: Its module.
        given: At the poses: T (n, 4, 4), and what the caller gives besides (n, how many).
        rates: How fast these change.
        status: Of the rows (n, rows).
        joints: How fast the rows' joints move (n, rows, dof), by differences; NaN without any.
    """

    robot: Any
    given: list[Any]
    rates: list[Any]
    status: Any
    joints: Any


def robot(name: str) -> Any:
    """A robot's module, solved in C: numba takes long."""
    if str(GENERATED) not in sys.path:
        sys.path.append(str(GENERATED))
    own = import_module(name)
    # in a whole run the package of robots was once gone from where its modules are looked for
    sys.modules.setdefault(own._FOLDER, ModuleType(own._FOLDER)).__path__ = [own._BESIDE]
    return in_c(own)


@cache
def in_c(module: ModuleType) -> Any:
    return native(module)


def inputs(name: str, q: Any) -> list[Any]:
    """What inverse kinematics takes at joint values (n, dof)."""
    arm = robot(name)
    if hasattr(arm, "arm_angle"):
        return [arm.fk(q), arm.arm_angle(q)[:, None]]
    if hasattr(arm, "FREE_JOINTS"):
        return [arm.fk(q), q[:, [joint - 1 for joint in arm.FREE_JOINTS]]]
    return [arm.fk(q)]


def move(name: str, n: int = 20, spread: float = 0.1) -> Move:
    """Poses around the arm's posture, each with a motion of its own."""
    arm, random = robot(name), np.random.default_rng(41)
    q = POSTURES[name] + random.uniform(-spread, spread, (n, arm.DOF))
    velocities = random.normal(size=q.shape)
    before, now, after = (inputs(name, q + h * velocities) for h in (-STEP, 0.0, STEP))
    found = [arm.ik_batch(*each) for each in (before, now, after)]
    (first, _), (_, status), (last, _) = found
    assert all((each == status).all() for _, each in found)
    apart = last - first
    turns = np.array(list(arm.JOINT_TYPES)) == "R"
    apart[..., turns] = np.remainder(apart[..., turns] + np.pi, 2 * np.pi) - np.pi
    rates = [(b - a) / (2 * STEP) for a, b in zip(before, after, strict=True)]
    return Move(arm, now, rates, status, apart / (2 * STEP))

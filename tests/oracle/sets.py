"""Joint vectors and poses that a solver must answer: the ordinary, the singular and the hopeless.

Every set is an array of joint vectors (N, n), the same on every run, as in the oracle's poses.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.oracle.arm import arm, arm_size
from dhgen.oracle.forward import forward
from dhgen.oracle.poses import NEAR, RIGHT_ANGLES, boundary, random_joints, right_angles
from dhgen.oracle.problem import names_position
from dhgen.oracle.search import solve
from dhgen.robot.robot import JointKind
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot


def all_solutions(
    robot: Robot, T: ArrayLike, q_free: Sequence[float] = (), *, seed: int = 0
) -> FloatArray:
    """Every isolated, simple solution, whether inside the joint limits or not."""
    return solve(robot, T, q_free, seed=seed).regular


def joint_sets(robot: Robot, *, count: int = 20, seed: int = 0) -> dict[str, FloatArray]:
    """All the sets of joint vectors below by name; `count` of each kind where that is free."""
    return {
        "random": random_joints(robot, count, seed=seed),
        "right angles": right_angles(robot, seed=seed),
        "singular": one_joint_at(robot, (0.0, np.pi), count, seed=seed),
        "near singular": near_singular(robot, count, seed=seed),
        "stretched or folded": one_joint_at(robot, RIGHT_ANGLES, count, seed=seed),
        "boundary": boundary(robot, count, seed=seed),
    }


def one_joint_at(robot: Robot, values: Sequence[float], count: int, *, seed: int = 0) -> FloatArray:
    """Each revolute joint in turn at each value, the others anywhere.

    At 0 and pi among them are the singular wrists, the arms stretched or folded, and for tables
    with offsets the multiples of a right angle between them.
    """
    found = [np.empty((0, len(robot.joints)))]
    for joint in range(len(robot.joints)):
        if robot.joints[joint].kind is JointKind.PRISMATIC:
            continue
        for value in values:
            q = random_joints(robot, count, seed=seed + len(found))
            q[:, joint] = value
            found.append(q)
    return np.concatenate(found)


def near_singular(robot: Robot, count: int, *, seed: int = 0) -> FloatArray:
    """Each revolute joint in turn close to a multiple of a right angle, on either side."""
    values = [angle + side * near for angle in RIGHT_ANGLES for near in NEAR for side in (1, -1)]
    return one_joint_at(robot, values, count, seed=seed)


def out_of_reach(robot: Robot, count: int, *, factor: float = 10.0, seed: int = 0) -> FloatArray:
    """Poses (count, 4, 4) whose position lies `factor` times the arm's size away from its base.

    An arm with an unlimited slide may reach them all the same. Orientations have no such poses:
    the result is then empty.
    """
    if not names_position(robot.task):
        return np.empty((0, 4, 4))
    T = forward(robot, random_joints(robot, count, seed=seed)).astype(float)
    origin = arm(robot).before[0, :3, 3]
    away = T[:, :3, 3] - origin + 1e-3 * arm_size(robot)
    away /= np.linalg.norm(away, axis=1, keepdims=True)
    T[:, :3, 3] = origin + factor * arm_size(robot) * away
    return T


def out_of_form(robot: Robot, count: int, *, seed: int = 0) -> FloatArray:
    """Poses (count, 4, 4) turned so that an arm of fewer than six joints cannot take them.

    Empty for six joints and more, and for tasks that leave the orientation open.
    """
    if robot.task.kind is not TaskKind.POSE or len(robot.joints) >= 6:
        return np.empty((0, 4, 4))
    T = forward(robot, random_joints(robot, count, seed=seed)).astype(float)
    turns = np.random.default_rng(seed).uniform(0.3, 1.2, (count, 3))
    for i, (x, y, z) in enumerate(turns):
        T[i, :3, :3] = T[i, :3, :3] @ _turn(0, x) @ _turn(1, y) @ _turn(2, z)
    return T


def _turn(axis: int, angle: float) -> FloatArray:
    R = np.eye(3)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R[[i, i, j, j], [i, j, i, j]] = np.cos(angle), -np.sin(angle), np.sin(angle), np.cos(angle)
    return R

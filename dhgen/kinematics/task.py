"""What a task names: entries of the pose, and how what it names changes with the joints."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.arm_angle import elbow_rates
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.numeric import NumericArm
    from dhgen.robot.task import Task


_COORDINATES = ("t14", "t24", "t34")
_SECOND = frozenset({"t12", "t22", "t32"})
SHORT = 1e-12  # square of the least length of a vector that gives a yaw
STEEPNESS = "t31"  # minus the sine of the pitch
_DIRECTIONS = {
    Directions.NONE: frozenset[str](),
    Directions.POINTING: frozenset({"t13", "t23", "t33"}),
    Directions.ROTATION: frozenset(f"t{row}{column}" for row in (1, 2, 3) for column in (1, 2, 3)),
    Directions.YAW: frozenset({"t11", "t21", STEEPNESS}),  # of the level pose of that yaw
    Directions.PITCH: frozenset({STEEPNESS}),
    Directions.TILT: frozenset({"t31", "t32", "t33"}),
}


def task_entries(task: Task) -> frozenset[str]:
    """Names of the entries of U_0 that a task gives."""
    places = frozenset(_COORDINATES[row] for row in task.position_rows)
    return places | _DIRECTIONS[task.directions]


def compared_entries(task: Task) -> frozenset[str]:
    """The task's entries that have to be compared: two columns of a rotation fix the third.

    With those two off by no more than a small d each, the second is off by less than 3 d. An arm
    that is asked for a yaw keeps the tool's x axis level wherever it is.
    """
    if task.names_rotation:
        return task_entries(task) - _SECOND
    return task_entries(task) - ({STEEPNESS} if task.directions is Directions.YAW else set())


def task_jacobian(arm: NumericArm, q: FloatArray, task: Task | None = None) -> FloatArray:
    """How the numbers that the task names change with the joints, all lengths in arm sizes.

    Args:
        arm: The arm.
        q: Joint values (..., n), lengths in the file's unit.
        task: Another than the arm's.

    Returns:
        Shape (..., m, n).
    """
    chain, task = arm.chain, task or arm.chain.task
    full = arm.jacobian(q) * units(chain)
    full[..., :3, :] /= chain.size
    named = [full[..., list(task.position_rows), :]]
    named.append(_direction_rates(task.directions, arm.pose(q)[..., :3, :3], full[..., 3:, :]))
    return np.concatenate(named, axis=-2)


def _direction_rates(directions: Directions, R: FloatArray, spin: FloatArray) -> FloatArray:
    """How what counts of a rotation (..., 3, 3) changes with spins (..., 3, n)."""
    x, (across, up, over) = R[..., 0, None], np.split(spin, 3, axis=-2)
    steepening = across * x[..., 1:2, :] - up * x[..., 0:1, :]
    match directions:
        case Directions.NONE:
            return spin[..., :0, :]
        case Directions.ROTATION:
            return spin
        case Directions.POINTING:  # of the rotations those about the tool's x and y
            return np.asarray(np.swapaxes(R[..., :2], -1, -2) @ spin)
        case Directions.TILT:  # and here those about the base's x and y
            return spin[..., :2, :]
        case Directions.PITCH:
            return np.asarray(steepening)
        case Directions.YAW:
            level = np.maximum(x[..., 0:1, :] ** 2 + x[..., 1:2, :] ** 2, SHORT)
            along = across * x[..., 0:1, :] + up * x[..., 1:2, :]
            return np.asarray(over - along * x[..., 2:3, :] / level)


def units(chain: Chain) -> FloatArray:
    """What joint values are measured in (n,): rad, or the size of the arm."""
    return np.where(chain.turning, 1.0, chain.size)


def task_rates(arm: NumericArm, q: FloatArray) -> FloatArray:
    """How what is asked for changes with the joints that are solved for, lengths in arm sizes.

    Args:
        arm: The arm.
        q: Joint values (..., n).

    Returns:
        Shape (..., m, k); where an arm angle is given its row is the last.
    """
    chain = arm.chain
    J = task_jacobian(arm, q)
    if chain.arm_angle:
        J = np.concatenate([J, elbow_rates(arm, q)[..., None, :]], axis=-2)
    return np.asarray(J[..., [joint.number - 1 for joint in chain.solved]])

"""What a task names: entries of the pose, and how what it names changes with the joints."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.arm_angle import elbow_rates
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.numeric import NumericArm
    from dhgen.robot.task import Task


_COORDINATES = {"x": "t14", "y": "t24", "z": "t34"}
_ROTATION = frozenset(f"t{row}{column}" for row in (1, 2, 3) for column in (1, 2, 3))
_POSITION = frozenset(_COORDINATES.values())
_APPROACH = frozenset({"t13", "t23", "t33"})
_SECOND = frozenset({"t12", "t22", "t32"})


def task_entries(task: Task) -> frozenset[str]:
    """Names of the entries of U_0 that a task gives."""
    match task.kind:
        case TaskKind.POSE:
            return _ROTATION | _POSITION
        case TaskKind.POSITION:
            return _POSITION
        case TaskKind.ORIENTATION:
            return _ROTATION
        case TaskKind.POINTING:
            return _POSITION | _APPROACH
        case TaskKind.COORDINATES:
            return frozenset(_COORDINATES[name] for name in task.coordinates)


def telling_entries(task: Task) -> frozenset[str]:
    """Those of them that have to be compared: two columns of a rotation leave none for the third.

    With those two off by no more than a small d each, the second is off by less than 3 d.
    """
    return task_entries(task) - _SECOND


def task_jacobian(arm: NumericArm, q: FloatArray) -> FloatArray:
    """How the numbers that the task names change with the joints, all lengths in arm sizes.

    Args:
        arm: The arm.
        q: Joint values (..., n), lengths in the file's unit.

    Returns:
        Shape (..., m, n).
    """
    chain = arm.chain
    full = arm.jacobian(q) * units(chain)
    full[..., :3, :] /= chain.size
    named = [full[..., list(chain.task.position_rows), :]]
    rotation = full[..., 3:, :]
    if chain.task.names_rotation:
        named.append(rotation)
    elif chain.task.names_direction:  # of the rotations those about the tool's x and y
        named.append(np.swapaxes(arm.pose(q)[..., :3, :2], -1, -2) @ rotation)
    return np.concatenate(named, axis=-2)


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

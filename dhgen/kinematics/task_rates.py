"""How what a task names changes with the joints, all lengths in arm sizes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.arm_angle import elbow_rates

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.numeric import NumericArm


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

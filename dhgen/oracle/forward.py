"""Forward kinematics and Jacobian of a robot file, in plain NumPy, for any number of joint vectors.

Every function takes one joint vector, shape (n,), or batches of them, shape (..., n).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.oracle.arm import Arm, arm

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot

    AnyArray = NDArray[Any]


def motions(model: Arm, q: ArrayLike) -> AnyArray:
    """The rows' own transforms exp(xi x), shape (..., m, 4, 4), for q of shape (..., n).

    x is q but for rows in which other drives have a share.
    """
    q = np.asarray(q) @ model.shares.T if model.is_coupled else np.asarray(q)
    first = np.where(model.turns, np.sin(q), q)[..., None, None]
    # 2 sin^2(q/2) is 1 - cos q without its cancellation near zero
    second = np.where(model.turns, 2 * np.sin(q / 2) ** 2, 0)[..., None, None]
    return np.eye(4) + first * model.twist + second * (model.twist @ model.twist)


def forward(robot: Robot | Arm, q: ArrayLike) -> AnyArray:
    """Pose of the tool in the base.

    Args:
        robot: The robot, or its numbers when many calls follow.
        q: Joint values [rad or length], shape (..., n); complex values are for derivatives.

    Returns:
        T_base_tool, shape (..., 4, 4).
    """
    model = robot if isinstance(robot, Arm) else arm(robot)
    moved = motions(model, q)
    T = np.broadcast_to(np.eye(4), (*moved.shape[:-3], 4, 4))
    for joint, before in enumerate(model.before):
        T = T @ before @ moved[..., joint, :, :]
    result: AnyArray = T @ model.end
    return result


def forward_with_derivatives(model: Arm, q: ArrayLike) -> tuple[FloatArray, FloatArray]:
    """The pose (..., 4, 4) and its derivative to every joint (..., n, 4, 4)."""
    moved = motions(model, q)
    T = np.broadcast_to(np.eye(4), (*moved.shape[:-3], 4, 4))
    prefixes = []
    for joint, before in enumerate(model.before):
        T = T @ (before @ moved[..., joint, :, :])
        prefixes.append(T)
    suffix = np.broadcast_to(model.end, T.shape)
    derivatives = np.empty(moved.shape)
    for joint in reversed(range(len(model.before))):
        # exp(xi q) and xi commute, so the twist may come behind the motion
        derivatives[..., joint, :, :] = prefixes[joint] @ (model.twist[joint] @ suffix)
        suffix = (model.before[joint] @ moved[..., joint, :, :]) @ suffix
    if model.is_coupled:
        derivatives = np.einsum("ij,...ikl->...jkl", model.shares, derivatives)
    return suffix, derivatives


def jacobian(robot: Robot | Arm, q: ArrayLike) -> FloatArray:
    """Geometric Jacobian of the tool's origin in the base frame.

    Args:
        robot: The robot, or its numbers.
        q: Joint values [rad or length], shape (..., n).

    Returns:
        Shape (..., 6, n): three rows of linear velocity, three of angular velocity.
    """
    model = robot if isinstance(robot, Arm) else arm(robot)
    T, dT = forward_with_derivatives(model, q)
    spin = dT[..., :3, :3] @ np.swapaxes(T[..., None, :3, :3], -1, -2)
    angular = np.stack([spin[..., 2, 1], spin[..., 0, 2], spin[..., 1, 0]], axis=-2)
    linear = np.swapaxes(dT[..., :3, 3], -1, -2)
    return np.concatenate([linear, angular], axis=-2)

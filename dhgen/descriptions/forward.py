"""Forward kinematics of a description and of a robot file, in plain NumPy, by nothing else here.

This is what an import is checked by: it shares no code with the stages between, reads the
description's numbers as they were written, and the robot file as it was written and read again.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.robot.expression import evaluate
from dhgen.robot.robot import Convention, DhTable, JointKind

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.descriptions.model import Joint
    from dhgen.robot.robot import Frame, Robot


def described_pose(joints: Sequence[Joint], q: FloatArray) -> FloatArray:
    """The tip in the base.

    Args:
        joints: From base to tip.
        q: Values of those that have a drive [rad or length], shape (..., n).
    """
    driven = (joint.name for joint in joints if joint.is_driven)
    values = dict(zip(driven, np.moveaxis(q, -1, 0), strict=True))
    T = np.broadcast_to(np.eye(4), (*q.shape[:-1], 4, 4))
    for joint in joints:
        T = T @ _origin(joint)
        if joint.motion.is_actuated:
            axis = np.array(joint.axis) / np.linalg.norm(joint.axis)
            T = T @ _motion(axis, _value(joint, values), turns=joint.motion.turns)
    return np.asarray(T)


def _value(joint: Joint, values: Mapping[str, FloatArray]) -> FloatArray:
    """Its own, or what it follows another one's by."""
    if joint.mimics is None:
        return values[joint.name]
    return joint.mimics.multiplier * values[joint.mimics.joint] + joint.mimics.offset


def _origin(joint: Joint) -> FloatArray:
    roll, pitch, yaw = joint.rpy
    T = np.eye(4)
    T[:3, :3] = (_rotation(2, yaw) @ _rotation(1, pitch) @ _rotation(0, roll))[:3, :3]
    T[:3, 3] = joint.xyz
    return T


def _motion(axis: FloatArray, value: FloatArray, *, turns: bool) -> FloatArray:
    """Along or about an axis through the origin, shape (..., 4, 4)."""
    T = np.zeros((*value.shape, 4, 4))
    T[..., :, :] = np.eye(4)
    if not turns:
        T[..., :3, 3] = value[..., None] * axis
        return T
    x, y, z = axis
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    s, v = np.sin(value)[..., None, None], 2.0 * np.sin(value / 2.0)[..., None, None] ** 2
    T[..., :3, :3] += s * K + v * (K @ K)
    return T


def robot_pose(robot: Robot, q: FloatArray) -> FloatArray:
    """The tool in the base of a robot file.

    Args:
        robot: The file, read.
        q: Joint values [rad or length], shape (..., n).
    """
    values = {parameter.name: parameter.value for parameter in robot.parameters}
    T = np.broadcast_to(_frame(robot.base, values), (*q.shape[:-1], 4, 4))
    geometry = robot.geometry
    if isinstance(geometry, DhTable):
        columns = np.moveaxis(q @ np.array(geometry.drive_factors).T, -1, 0)
        for row, value in zip(geometry.rows, columns, strict=True):
            theta, d, a, alpha = (evaluate(c, values) for c in (row.theta, row.d, row.a, row.alpha))
            turns = row.kind is JointKind.REVOLUTE
            along_z = _rotation(2, theta + value * turns) @ _shift(2, d + value * (not turns))
            along_x = _rotation(0, alpha) @ _shift(0, a)
            modified = geometry.convention is Convention.MODIFIED
            T = T @ along_x @ along_z if modified else T @ along_z @ along_x
        return np.asarray(T @ _frame(robot.tool, values))
    for axis, value in zip(geometry.axes, np.moveaxis(q, -1, 0), strict=True):
        direction = np.array([evaluate(c, values) for c in axis.direction])
        turns = axis.kind is JointKind.REVOLUTE
        moved = _motion(direction / np.linalg.norm(direction), value, turns=turns)
        point = np.eye(4)
        point[:3, 3] = [evaluate(c, values) for c in axis.point]
        T = T @ point @ moved @ np.linalg.inv(point)
    return np.asarray(T @ _frame(geometry.home, values) @ _frame(robot.tool, values))


def _rotation(axis: int, angle: FloatArray | float) -> FloatArray:
    """About a coordinate axis, shape (..., 4, 4)."""
    c, s = np.cos(angle), np.sin(angle)
    one, other = ((1, 2), (2, 0), (0, 1))[axis]
    T = np.zeros((*np.shape(angle), 4, 4))
    T[..., :, :] = np.eye(4)
    T[..., one, one] = T[..., other, other] = c
    T[..., one, other], T[..., other, one] = -s, s
    return T


def _shift(axis: int, length: FloatArray | float) -> FloatArray:
    T = np.zeros((*np.shape(length), 4, 4))
    T[..., :, :] = np.eye(4)
    T[..., axis, 3] = length
    return T


def _frame(frame: Frame, values: Mapping[str, float]) -> FloatArray:
    T = np.eye(4)
    T[:3, :3] = np.array([evaluate(cell, values) for cell in frame.rotation]).reshape(3, 3)
    T[:3, 3] = [evaluate(cell, values) for cell in frame.xyz]
    return T

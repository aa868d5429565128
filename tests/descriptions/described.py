"""Robot files as URDF: what a description of the same arm would say."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from dhgen.robot.expression import evaluate
from dhgen.robot.robot import Convention, DhTable, JointKind

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Frame, Robot


def urdf_of(robot: Robot) -> str:
    """A URDF with one link a joint, whose frames are those of the table."""
    table = robot.geometry
    assert isinstance(table, DhTable)
    values = {parameter.name: parameter.value for parameter in robot.parameters}
    links = ['  <link name="base"/>']
    joints = []
    before = _matrix(robot.base, values)
    for number, row in enumerate(table.rows, 1):
        theta, d, a, alpha = (evaluate(c, values) for c in (row.theta, row.d, row.a, row.alpha))
        along_z = _turn(2, theta) @ _shift(2, d)
        along_x = _turn(0, alpha) @ _shift(0, a)
        modified = table.convention is Convention.MODIFIED
        before = before @ along_x @ along_z if modified else before
        # what is beside q turns about the joint's own axis: before or after it is one
        joints.append(_joint(number, before, row.sign or 1, row.kind, row.limits))
        links.append(f'  <link name="link{number}"/>')
        before = np.eye(4) if modified else along_z @ along_x
    joints.append(_fixed(len(table.rows), before @ _matrix(robot.tool, values)))
    links.append('  <link name="tool0"/>')
    return "\n".join([f'<robot name="{robot.name}">', *links, *joints, "</robot>", ""])


def _joint(
    number: int,
    frame: FloatArray,
    sign: int,
    kind: JointKind,
    limits: tuple[float, float] | None,
) -> str:
    turns = kind is JointKind.REVOLUTE
    motion = "continuous" if turns and limits is None else kind.value
    parent = f"link{number - 1}" if number > 1 else "base"
    low, high = limits or (0.0, 0.0)
    limit = "" if limits is None else f'<limit lower="{low!r}" upper="{high!r}"/>'
    return (
        f'  <joint name="joint{number}" type="{motion}"><parent link="{parent}"/>'
        f'<child link="link{number}"/>{_origin(frame)}<axis xyz="0 0 {sign}"/>{limit}</joint>'
    )


def _fixed(number: int, frame: FloatArray) -> str:
    return (
        f'  <joint name="to_tool" type="fixed"><parent link="link{number}"/>'
        f'<child link="tool0"/>{_origin(frame)}</joint>'
    )


def _origin(frame: FloatArray) -> str:
    xyz = " ".join(f"{part:.17g}" for part in frame[:3, 3])
    R = frame[:3, :3]
    level = math.hypot(R[0, 0], R[1, 0])
    pitch = math.atan2(-R[2, 0], level)
    if level < 1e-9:
        roll, yaw = math.atan2(-R[1, 2], R[1, 1]), 0.0
    else:
        roll, yaw = math.atan2(R[2, 1], R[2, 2]), math.atan2(R[1, 0], R[0, 0])
    rpy = " ".join(f"{angle:.17g}" for angle in (roll, pitch, yaw))
    return f'<origin xyz="{xyz}" rpy="{rpy}"/>'


def _turn(axis: int, angle: float) -> FloatArray:
    T = np.eye(4)
    i, j = ((1, 2), (2, 0), (0, 1))[axis]
    T[i, i] = T[j, j] = math.cos(angle)
    T[j, i], T[i, j] = math.sin(angle), -math.sin(angle)
    return T


def _shift(axis: int, length: float) -> FloatArray:
    T = np.eye(4)
    T[axis, 3] = length
    return T


def _matrix(frame: Frame, values: dict[str, float]) -> FloatArray:
    T = np.eye(4)
    T[:3, :3] = np.array([evaluate(c, values) for c in frame.rotation]).reshape(3, 3)
    T[:3, 3] = [evaluate(c, values) for c in frame.xyz]
    return T

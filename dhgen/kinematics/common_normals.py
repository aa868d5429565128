"""A modified Denavit-Hartenberg table from axes in space, by the common normals of neighbours.

In floating point, for axes whose directions are not exact: what comes out near a multiple of
15 degrees or near zero becomes exact, so that axes remain parallel or concurrent. The
common normal of nearly parallel axes may be hundreds of metres away; there frames are put beside
each other instead, and a row has a shift along y besides.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from dhgen.robot.angles import SNAP, exact_angle, near_cosine, twelfths
from dhgen.robot.expression import ZERO, Negate, Number, evaluate
from dhgen.robot.robot import Convention, DhRow, DhTable, Frame, JointKind

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.arrays import FloatArray
    from dhgen.robot.expression import Expression
    from dhgen.robot.robot import AxisJoint, ReferenceAxes, Robot


ROUNDING = 1e-12  # of the entries of a rotation
FAR = 10.0  # arm sizes: where axes are nearly parallel their common normal is no place for a frame
DIGITS = 14  # of lengths: those behind are rounding


@dataclass(frozen=True, slots=True)
class _Passage:
    """From one axis to the next: Rz(turn) Tz(offset) Rx(twist) Tx(length) Ty(shift)."""

    turn: float
    offset: float
    twist: float
    length: float
    shift: float = 0.0


_NONE = _Passage(0.0, 0.0, 0.0, 0.0)


def table_of_axes(robot: Robot, reference: ReferenceAxes) -> tuple[Robot, DhTable]:
    """The arm as a modified table, with base and tool that fit it.

    Args:
        robot: The arm.
        reference: Its geometry.
    """
    values = {parameter.name: parameter.value for parameter in robot.parameters}
    axes = reference.axes
    directions = [_unit([evaluate(c, values) for c in axis.direction]) for axis in axes]
    points = [np.array([evaluate(c, values) for c in axis.point]) for axis in axes]
    home = _matrix(reference.home, values)
    turning = [at for axis, at in zip(axes, points, strict=True) if axis.kind is JointKind.REVOLUTE]
    apart = [np.linalg.norm(b - a) for a, b in pairwise([*turning, home[:3, 3]])]
    size = float(sum(apart)) or 1.0
    start = _start_frame(directions[0], points[0] * (axes[0].kind is JointKind.REVOLUTE))
    frame, passages = start, [_NONE]
    for axis, direction, point in zip(axes[1:], directions[1:], points[1:], strict=True):
        target = point if axis.kind is JointKind.REVOLUTE else frame[:3, 3]
        passage, frame = _common_normal(frame, direction, target, size)
        passages.append(passage)
    rows = tuple(
        _row(axis, before, after, size)
        for axis, (before, after) in zip(axes, pairwise([*passages, _NONE]), strict=True)
    )
    table = DhTable(Convention.MODIFIED, rows)
    base = _frame(_matrix(robot.base, values) @ start, size)
    tool = _frame(np.linalg.inv(frame) @ home @ _matrix(robot.tool, values), size)
    return replace(robot, geometry=table, base=base, tool=tool), table


def _unit(vector: list[float]) -> FloatArray:
    array = np.array(vector)
    return np.asarray(array / np.linalg.norm(array))


def _start_frame(direction: FloatArray, point: FloatArray) -> FloatArray:
    """A frame at the point of the first axis nearest to the origin, z along the axis."""
    helper = np.eye(3)[0] if abs(direction[0]) < 0.9 else np.eye(3)[1]
    x = _unit(list(helper - direction * (helper @ direction)))
    return _pose(x, direction, point - direction * (point @ direction))


def _common_normal(
    current: FloatArray, direction: FloatArray, point: FloatArray, size: float
) -> tuple[_Passage, FloatArray]:
    """The passage from the axis of a frame to the next axis, and the frame there."""
    origin, x, y, z = current[:3, 3], current[:3, 0], current[:3, 1], current[:3, 2]
    between = point - origin
    normal = np.cross(z, direction)
    if np.linalg.norm(normal) < SNAP:
        across = between - z * (between @ z)
        normal = across if np.linalg.norm(across) > SNAP * size else x
        foot, landing = origin, origin + across
    else:
        # Of nearly parallel axes the sine has digits that one minus the squared cosine has lost.
        along = np.cross(between, direction) @ normal / (normal @ normal)
        foot = origin + along * z
        if abs(along) > FAR * size:
            foot = origin
        landing = point + direction * ((foot - point) @ direction)
    axis = _unit(list(normal))
    passage = _Passage(
        turn=math.atan2(axis @ y, axis @ x),
        offset=float((foot - origin) @ z),
        twist=math.atan2(np.cross(z, direction) @ axis, z @ direction),
        length=float((landing - foot) @ axis),
        shift=float((landing - foot) @ np.cross(direction, axis)),
    )
    return passage, _pose(axis, direction, landing)


def _pose(x: FloatArray, z: FloatArray, origin: FloatArray) -> FloatArray:
    frame = np.eye(4)
    frame[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    frame[:3, 3] = origin
    return frame


def _row(axis: AxisJoint, before: _Passage, after: _Passage, size: float) -> DhRow:
    """Of the modified convention: the parameters along x to the axis, and along z from it."""
    return DhRow(
        kind=axis.kind,
        sign=1,
        theta=_angle(after.turn),
        d=_length(after.offset, size),
        a=_length(before.length, size),
        alpha=_angle(before.twist),
        limits=axis.limits,
        b=_length(before.shift, size),
        name=axis.name,
    )


def _angle(value: float) -> Expression:
    k = twelfths(value)
    return _number(value) if k is None else exact_angle(k)


def _length(value: float, size: float) -> Expression:
    return ZERO if abs(value) < SNAP * size else _number(float(f"{value:.{DIGITS}g}"))


def _cosine(value: float, within: float) -> Expression:
    """An entry of a rotation, exact where it is the cosine of an exact angle."""
    return near_cosine(value, within) or _number(value)


def _number(value: float) -> Expression:
    exact = Number(Fraction(repr(abs(value))))
    return Negate(exact) if value < 0.0 else exact


def _matrix(frame: Frame, values: Mapping[str, float]) -> FloatArray:
    matrix = np.eye(4)
    matrix[:3, :3] = np.array([evaluate(c, values) for c in frame.rotation]).reshape(3, 3)
    matrix[:3, 3] = [evaluate(c, values) for c in frame.xyz]
    return matrix


def _frame(matrix: FloatArray, size: float) -> Frame:
    exact = [_cosine(float(entry), SNAP) for entry in matrix[:3, :3].flat]
    R = np.array([evaluate(entry, {}) for entry in exact]).reshape(3, 3)
    if np.abs(R @ R.T - np.eye(3)).max() > ROUNDING:  # a small angle has a cosine of nearly 1
        exact = [_cosine(float(entry), ROUNDING) for entry in matrix[:3, :3].flat]
    x, y, z = (_length(float(entry), size) for entry in matrix[:3, 3])
    return Frame((x, y, z), tuple(exact))

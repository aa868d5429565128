"""Robots given by their axes in the reference position (document 001: P(q) = K_1 ... K_n P(0)).

When every axis points along a direction whose frame is exact, the chain is built from the axes
as they are, with their parameters: frame i is the reference frame carried along by joint i, at a point
of axis i. Any other set of axes is first turned into a modified Denavit-Hartenberg table by
the common normals of neighbouring axes.
"""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.chain import Chain, ChainJoint, Element, Fixed, Slide, Turn
from dhgen.kinematics.constants import ConstantTable
from dhgen.kinematics.frames import read_frame
from dhgen.kinematics.normal import NormalForm, normal_form
from dhgen.kinematics.transform import Transform, compose, identity, inverse
from dhgen.robot.expression import ZERO, Binary, Negate, Number, Pi, evaluate
from dhgen.robot.robot import (
    AxisJoint,
    Convention,
    DhRow,
    DhTable,
    Frame,
    JointKind,
    ReferenceAxes,
    Robot,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from sympy.polys.rings import PolyRing

    from dhgen.kinematics.constants import Polynomial
    from dhgen.robot.expression import Expression

    Vector = NDArray[np.float64]

SNAP = 1e-9  # twists and lengths nearer than this to an exact value are exact


def exact_axes(robot: Robot) -> Chain | None:
    """The chain of reference axes whose directions are exact, or None when one is not."""
    assert isinstance(robot.geometry, ReferenceAxes)
    table = ConstantTable({parameter.name: parameter.value for parameter in robot.parameters})
    _read(robot, robot.geometry, table)
    ring = table.close()
    axes, home, base, tool = _read(robot, robot.geometry, table)
    normal = normal_form(ring, table.constants.values(), {})
    frames: list[Transform] = []
    signs: list[int] = []
    for joint, (direction, point) in zip(robot.geometry.axes, axes, strict=True):
        framed = _frame_along(direction, ring, normal)
        if framed is None:
            return None
        rotation, sign = framed
        previous = frames[-1].translation if frames else (ring.zero,) * 3
        at = previous if joint.kind is JointKind.PRISMATIC else _nearest(rotation, point, previous)
        frames.append(Transform(rotation, at))
        signs.append(sign)
    links: list[tuple[Element, ...]] = []
    before = identity(ring)
    for number, (joint, frame) in enumerate(zip(robot.geometry.axes, frames, strict=True), 1):
        step = compose(inverse(before, normal), frame, normal)
        move = Turn(number) if joint.kind is JointKind.REVOLUTE else Slide(number)
        links.append((move,) if step == identity(ring) else (Fixed(step), move))
        before = frame
    last = compose(inverse(before, normal), home, normal)
    return Chain(
        name=robot.name,
        joints=tuple(
            ChainJoint(number, joint.kind, sign, 0.0, joint.limits)
            for number, (joint, sign) in enumerate(
                zip(robot.geometry.axes, signs, strict=True), start=1
            )
        ),
        links=tuple(links),
        base=base,
        tool=compose(last, tool, normal),
        constants=tuple(table.constants.values()),
        ring=ring,
        task=robot.task,
        free=robot.free,
        size=sum(abs(c.value) for c in table.constants.values() if c.is_length) or 1.0,
    )


def _read(
    robot: Robot, geometry: ReferenceAxes, table: ConstantTable
) -> tuple[list[tuple[list[Polynomial], list[Polynomial]]], Transform, Transform, Transform]:
    axes = [
        (
            [table.scalar(c, f"u{i}{x}", f"{x} of axis {i}") for x, c in _xyz(joint.direction)],
            [table.length(c, f"p{i}{x}", f"{x} of axis {i}") for x, c in _xyz(joint.point)],
        )
        for i, joint in enumerate(geometry.axes, start=1)
    ]
    home = read_frame(geometry.home, table, "h", "home pose")
    base = read_frame(robot.base, table, "z", "base frame")
    return axes, home, base, read_frame(robot.tool, table, "e", "tool frame")


def _xyz(cells: tuple[Expression, Expression, Expression]) -> list[tuple[str, Expression]]:
    return list(zip("xyz", cells, strict=True))


def _frame_along(
    direction: list[Polynomial], ring: PolyRing, normal: NormalForm
) -> tuple[tuple[tuple[Polynomial, ...], ...], int] | None:
    """A rotation whose z axis is the direction (up to a sign), when that is exact.

    Exact are the directions of length one with at least one component zero.
    """
    if normal(sum((c * c for c in direction), ring.zero)) != ring.one:
        return None
    sign = 1
    if direction.count(ring.zero) == 2 and -ring.one in direction:
        sign, direction = -1, [-component for component in direction]
    if direction[2] == ring.one:
        return identity(ring).rotation, sign
    for axis in (2, 1, 0):
        if direction[axis] != ring.zero:
            continue
        x = [ring.one if place == axis else ring.zero for place in range(3)]
        y = _cross(direction, x)
        return tuple(zip(x, y, direction, strict=True)), sign
    return None


def _cross(left: list[Polynomial], right: list[Polynomial]) -> list[Polynomial]:
    return [
        left[(k + 1) % 3] * right[(k + 2) % 3] - left[(k + 2) % 3] * right[(k + 1) % 3]
        for k in range(3)
    ]


def _nearest(
    rotation: tuple[tuple[Polynomial, ...], ...],
    point: list[Polynomial],
    previous: tuple[Polynomial, ...],
) -> tuple[Polynomial, ...]:
    """The point of an axis level with the previous frame, where that needs no division.

    Sliding a frame along its own axis changes no pose; it makes neighbouring axes that meet
    share their point, wherever the file puts it (document 003, rules 2 and 3).
    """
    direction = [row[2] for row in rotation]
    one = point[0].ring.one
    return tuple(
        previous[place] if component in {one, -one} else point[place]
        for place, component in enumerate(direction)
    )


def rows_of_axes(robot: Robot) -> Robot:
    """The same arm as a modified table: common normals of neighbouring axes, in floating point."""
    assert isinstance(robot.geometry, ReferenceAxes)
    values = {parameter.name: parameter.value for parameter in robot.parameters}
    axes = robot.geometry.axes
    directions = [_unit([evaluate(c, values) for c in axis.direction]) for axis in axes]
    points = [np.array([evaluate(c, values) for c in axis.point]) for axis in axes]
    home = _matrix(robot.geometry.home, values)
    size = float(sum(np.linalg.norm(point) for point in points) + np.linalg.norm(home[:3, 3])) or 1.0
    start = _start_frame(directions[0], points[0] * (axes[0].kind is JointKind.REVOLUTE))
    current = start.copy()
    rows: list[DhRow] = []
    twist = length = 0.0
    for place, axis in enumerate(axes):
        turn = offset = 0.0
        if place + 1 < len(axes):
            following = axes[place + 1].kind
            target = points[place + 1] if following is JointKind.REVOLUTE else current[:3, 3]
            turn, offset, next_twist, next_length, following_frame = _common_normal(
                current, directions[place + 1], target, size
            )
        rows.append(_row(axis, turn, offset, length, twist, size))
        if place + 1 < len(axes):
            twist, length, current = next_twist, next_length, following_frame
    last = np.linalg.inv(current) @ home @ _matrix(robot.tool, values)
    first = _matrix(robot.base, values) @ start
    return replace(
        robot,
        geometry=DhTable(Convention.MODIFIED, tuple(rows)),
        base=_frame(first, size),
        tool=_frame(last, size),
    )


def _unit(vector: list[float]) -> Vector:
    array = np.array(vector)
    return np.asarray(array / np.linalg.norm(array))


def _start_frame(direction: Vector, point: Vector) -> Vector:
    """A frame at the point of the first axis nearest to the origin, z along the axis."""
    helper = np.eye(3)[0] if abs(direction[0]) < 0.9 else np.eye(3)[1]
    x = _unit(list(helper - direction * (helper @ direction)))
    frame = np.eye(4)
    frame[:3, :3] = np.column_stack([x, np.cross(direction, x), direction])
    frame[:3, 3] = point - direction * (point @ direction)
    return frame


def _common_normal(
    current: Vector, direction: Vector, point: Vector, size: float
) -> tuple[float, float, float, float, Vector]:
    """Turn, offset, twist, length from one axis to the next, and the frame there."""
    origin, x, y, z = current[:3, 3], current[:3, 0], current[:3, 1], current[:3, 2]
    between = point - origin
    normal = np.cross(z, direction)
    if np.linalg.norm(normal) < SNAP:
        across = between - z * (between @ z)
        normal = across if np.linalg.norm(across) > SNAP * size else x
        foot, landing = origin, origin + across
    else:
        lean = z @ direction
        along = (between @ z - lean * (between @ direction)) / (1.0 - lean * lean)
        foot = origin + along * z
        landing = point + direction * ((foot - point) @ direction)
    axis = _unit(list(normal))
    turn = math.atan2(axis @ y, axis @ x)
    twist = math.atan2(np.cross(z, direction) @ axis, z @ direction)
    frame = np.eye(4)
    frame[:3, :3] = np.column_stack([axis, np.cross(direction, axis), direction])
    frame[:3, 3] = landing
    return turn, float((foot - origin) @ z), twist, float((landing - foot) @ axis), frame


def _row(
    axis: AxisJoint, turn: float, offset: float, length: float, twist: float, size: float
) -> DhRow:
    return DhRow(
        kind=axis.kind,
        sign=1,
        theta=_angle(turn),
        d=_length(offset, size),
        a=_length(length, size),
        alpha=_angle(twist),
        limits=axis.limits,
    )


def _angle(value: float) -> Expression:
    steps = round(value / (math.pi / 12.0))
    if abs(value - steps * math.pi / 12.0) < SNAP:
        return Binary("*", Number(Fraction(steps, 12)), Pi()) if steps else ZERO
    return _number(value)


def _length(value: float, size: float) -> Expression:
    return ZERO if abs(value) < SNAP * size else _number(value)


def _number(value: float) -> Expression:
    exact = Number(Fraction(repr(abs(value))))
    return Negate(exact) if value < 0.0 else exact


def _matrix(frame: Frame, values: dict[str, float]) -> Vector:
    matrix = np.eye(4)
    matrix[:3, :3] = np.array([evaluate(c, values) for c in frame.rotation]).reshape(3, 3)
    matrix[:3, 3] = [evaluate(c, values) for c in frame.xyz]
    return matrix


def _frame(matrix: Vector, size: float) -> Frame:
    rotation = tuple(
        _number(float(round(entry))) if abs(entry - round(entry)) < SNAP else _number(float(entry))
        for entry in matrix[:3, :3].flat
    )
    x, y, z = (_length(float(entry), size) for entry in matrix[:3, 3])
    return Frame((x, y, z), rotation)

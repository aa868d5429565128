"""A robot file as numbers: constant transforms and twists, read straight from rows or axes.

The oracle answers for the compiler: it starts from the robot as the user wrote it and shares
nothing with dhgen.kinematics, so that a mistake there cannot hide behind the same mistake here.
Every joint is a twist, pure rotation or pure translation, whichever way the robot was given:

    T_base_tool = B_1 exp(xi_1 q_1) B_2 exp(xi_2 q_2) ... B_n exp(xi_n q_n) E

So are passive rows, whose values are made of those of drives alone.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.robot.expression import evaluate
from dhgen.robot.robot import Convention, DhTable, JointKind

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.robot.expression import Expression
    from dhgen.robot.robot import AxisJoint, DhRow, Frame, ReferenceAxes, Robot


Z_AXIS = (0.0, 0.0, 1.0)
ORIGIN = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Arm:
    """A robot as numbers, of m rows and n drives; without passive rows these are as many.

    Attributes:
        before: (m, 4, 4), the constant transform in front of each row.
        twist: (m, 4, 4), each row's twist as a matrix; its square is zero when prismatic.
        end: (4, 4), the constant transform after the last row.
        turns: (m,), which rows turn.
        revolute: (n,), which drives do.
        shares: (m, n), what each row's value is made of.
    """

    before: FloatArray
    twist: FloatArray
    end: FloatArray
    turns: NDArray[np.bool_]
    revolute: NDArray[np.bool_]
    shares: FloatArray

    @property
    def is_coupled(self) -> bool:
        """Whether drives have shares in rows other than their own."""
        return not np.array_equal(self.shares, np.eye(len(self.shares)))

    @property
    def has_passive(self) -> bool:
        """Whether rows have no drive of their own."""
        return len(self.turns) > len(self.revolute)

    def divided_by(self, length: float) -> Arm:
        """The arm with all lengths, prismatic q included, divided by a length."""
        before, twist, end = self.before.copy(), self.twist.copy(), self.end.copy()
        before[:, :3, 3] /= length
        twist[self.turns, :3, 3] /= length
        end[:3, 3] /= length
        units, of_rows = (np.where(each, 1.0, length) for each in (self.revolute, self.turns))
        shares = self.shares * units / of_rows[:, None]
        return Arm(before, twist, end, self.turns, self.revolute, shares)


def arm(robot: Robot) -> Arm:
    """The numbers of a robot, base and tool included."""
    values = {parameter.name: parameter.value for parameter in robot.parameters}
    geometry = robot.geometry
    if isinstance(geometry, DhTable):
        before, twist, end = _from_table(geometry, values)
    else:
        before, twist, end = _from_axes(geometry, values)
    before[0] = _frame(robot.base, values) @ before[0]
    rows = geometry.rows if isinstance(geometry, DhTable) else geometry.axes
    turns = np.array([row.kind is JointKind.REVOLUTE for row in rows])
    revolute = np.array([joint.kind is JointKind.REVOLUTE for joint in robot.joints])
    return Arm(before, twist, end @ _frame(robot.tool, values), turns, revolute, _shares(robot))


def _shares(robot: Robot) -> FloatArray:
    """One for every row with a drive, and beside it what drives add to other rows than their own.

    Times the row's sign, which is in its twist.
    """
    if not isinstance(robot.geometry, DhTable):
        return np.eye(len(robot.joints))
    rows = robot.geometry.rows
    shares = np.zeros((len(rows), len(robot.joints)))
    drive = 0
    for place, row in enumerate(rows):
        if row.sign:
            shares[place, drive] = 1.0
            drive += 1
        for coupling in row.couplings:
            shares[place, coupling.joint - 1] = (row.sign or 1) * coupling.value
    return shares


def base_frame(robot: Robot) -> FloatArray:
    """Z, pose of the arm's base in the caller's frame, (4, 4)."""
    return _frame(robot.base, {parameter.name: parameter.value for parameter in robot.parameters})


def arm_size(robot: Robot) -> float:
    """How large an arm is [the file's unit]: its lengths and strokes added up, 1 without any."""
    model = arm(robot)
    lengths = np.linalg.norm(model.before[1:, :3, 3], axis=1).sum()
    points = np.linalg.norm(model.twist[model.turns, :3, 3], axis=1).sum()
    strokes = sum(
        max(map(abs, joint.limits))
        for joint in robot.joints
        if joint.kind is JointKind.PRISMATIC and joint.limits is not None
    )
    return float(lengths + points + strokes + np.linalg.norm(model.end[:3, 3])) or 1.0


def _from_table(
    table: DhTable, values: Mapping[str, float]
) -> tuple[FloatArray, FloatArray, FloatArray]:
    n = len(table.rows)
    before, twist, end = np.tile(np.eye(4), (n, 1, 1)), np.empty((n, 4, 4)), np.eye(4)
    for i, row in enumerate(table.rows):
        along_z, along_x = _halves(row, values)
        if table.convention is Convention.STANDARD:
            before[i] = end
            end = along_z @ along_x
        else:
            before[i] = end @ along_x
            end = along_z
        twist[i] = (row.sign or 1) * _twist(row.kind, Z_AXIS, ORIGIN)
    return before, twist, end


def _halves(row: DhRow, values: Mapping[str, float]) -> tuple[FloatArray, FloatArray]:
    """The constant part of Rz(theta) Tz(d), and Tx(a) Rx(alpha); each pair commutes."""
    theta, d, a, alpha = (evaluate(e, values) for e in (row.theta, row.d, row.a, row.alpha))
    along_z, along_x = np.eye(4), np.eye(4)
    along_z[:2, :2] = [[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]]
    along_z[2, 3] = d
    along_x[1:3, 1:3] = [[np.cos(alpha), -np.sin(alpha)], [np.sin(alpha), np.cos(alpha)]]
    along_x[0, 3] = a
    return along_z, along_x


def _from_axes(
    reference: ReferenceAxes, values: Mapping[str, float]
) -> tuple[FloatArray, FloatArray, FloatArray]:
    before = np.tile(np.eye(4), (len(reference.axes), 1, 1))
    twist = np.array([_axis_twist(axis, values) for axis in reference.axes])
    return before, twist, _frame(reference.home, values)


def _axis_twist(axis: AxisJoint, values: Mapping[str, float]) -> FloatArray:
    direction = np.array([evaluate(e, values) for e in axis.direction])
    point = [evaluate(e, values) for e in axis.point]
    return _twist(axis.kind, direction / np.linalg.norm(direction), point)


def _twist(
    kind: JointKind, direction: Sequence[float] | FloatArray, point: Sequence[float]
) -> FloatArray:
    """The 4x4 twist of a unit motion about, or along, a unit direction through a point."""
    xi = np.zeros((4, 4))
    if kind is JointKind.PRISMATIC:
        xi[:3, 3] = direction
        return xi
    x, y, z = direction
    xi[:3, :3] = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    xi[:3, 3] = -xi[:3, :3] @ np.asarray(point)
    return xi


def _frame(frame: Frame, values: Mapping[str, float]) -> FloatArray:
    T = np.eye(4)
    T[:3, 3] = _evaluated(frame.xyz, values)
    T[:3, :3] = _evaluated(frame.rotation, values).reshape(3, 3)
    return T


def _evaluated(expressions: Sequence[Expression], values: Mapping[str, float]) -> FloatArray:
    return np.array([evaluate(e, values) for e in expressions])

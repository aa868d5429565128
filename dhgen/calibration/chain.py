"""The joints of a calibrated arm: each one's frame in that of the joint before, all joints zero."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.descriptions.model import Joint, Motion
from dhgen.descriptions.rotations import STILL, about, dot, from_rpy, minus, placed, to_rpy, turned
from dhgen.errors import refused
from dhgen.robot.expression import evaluate
from dhgen.robot.robot import Convention, DhTable, JointKind
from dhgen.robot.source import Span

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.calibration.read import Calibration
    from dhgen.descriptions.rotations import Placed
    from dhgen.robot.robot import AxisJoint, DhRow, Frame, Robot

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
NOWHERE: Placed = (STILL, (0.0, 0.0, 0.0))
NO_DELTAS = (0.0,) * 5


def calibrated_joints(robot: Robot, calibration: Calibration) -> tuple[Joint, ...]:
    """The joints from base to tool, the last one fixed.

    Args:
        robot: The arm of the data sheet.
        calibration: What was measured.

    Raises:
        RobotFileError: They don't belong together.
    """
    values = {parameter.name: parameter.value for parameter in robot.parameters}
    count = len(robot.joints)
    if len(calibration.rows) != count:
        raise refused(
            calibration.file, f"{len(calibration.rows)} rows for an arm of {count} joints"
        )
    base, tool = _frame(robot.base, values), _frame(robot.tool, values)
    if calibration.is_deltas:
        if not isinstance(robot.geometry, DhTable):
            raise refused(calibration.file, "deltas are for arms with a table; this one has axes")
        measured = _origins_of_rows(robot.geometry, calibration.rows, values)
        origins = _slid(measured, _origins_of_rows(robot.geometry, [NO_DELTAS] * count, values))
    elif robot.length_unit != "m":
        raise refused(
            calibration.file, f"origins are in m, lengths of the arm in {robot.length_unit}"
        )
    else:
        rows = [(from_rpy(_vector(row[3:])), _vector(row[:3])) for row in calibration.rows]
        origins = [*rows, NOWHERE]
    origins[0], origins[-1] = placed(base, origins[0]), placed(origins[-1], tool)
    links = ["base", *(f"link{number}" for number in range(1, count + 1)), "tool"]
    return tuple(
        _joint(origin, links[place], links[place + 1], joint, place + 1)
        for place, (origin, joint) in enumerate(zip(origins, (*robot.joints, None), strict=True))
    )


def _origins_of_rows(
    table: DhTable, added: Sequence[Sequence[float]], values: Mapping[str, float]
) -> list[Placed]:
    """Of rows with deltas: the transforms before each joint's motion, and behind the last."""
    found, behind = [], NOWHERE
    for row, deltas in zip(table.rows, added, strict=True):
        cells = [evaluate(cell, values) for cell in (row.theta, row.d, row.a, row.alpha)]
        theta, d, a, alpha = (c + delta for c, delta in zip(cells, deltas, strict=False))
        along_z = about(Z, theta), (0.0, 0.0, d)
        along_x = placed((about(X, alpha), (a, 0.0, 0.0)), (about(Y, deltas[4]), NOWHERE[1]))
        if table.convention is Convention.MODIFIED:
            found.append(placed(behind, along_x))
            behind = along_z
        else:
            found.append(behind)
            behind = placed(along_z, along_x)
    return [*found, behind]


def _slid(origins: Sequence[Placed], nominal: Sequence[Placed]) -> list[Placed]:
    """Origins of frames that are slid along their joints' axes to next to the nominal arm's frames.

    Nearly parallel axes have their common normal, and the frame of its row, far from the arm: its
    size and the points of its axes would be those of the detour.
    """
    found = []
    back = frame = reference = NOWHERE
    for origin, wanted in zip(origins[:-1], nominal[:-1], strict=True):
        measured = placed(back, origin)
        frame, reference = placed(frame, measured), placed(reference, wanted)
        slide = dot(minus(reference[1], frame[1]), turned(frame[0], Z))
        along, back = (STILL, (0.0, 0.0, slide)), (STILL, (0.0, 0.0, -slide))
        frame = placed(frame, along)
        found.append(placed(measured, along))
    return [*found, placed(back, origins[-1])]


def _joint(
    origin: Placed, parent: str, child: str, joint: DhRow | AxisJoint | None, number: int
) -> Joint:
    motion, axis = Motion.FIXED, Z
    if joint is not None:
        turning = Motion.REVOLUTE if joint.limits else Motion.CONTINUOUS
        motion = turning if joint.kind is JointKind.REVOLUTE else Motion.PRISMATIC
        axis = (0.0, 0.0, float(getattr(joint, "sign", 1)))
    return Joint(
        name=(joint.name if joint else "") or f"joint{number}",
        motion=motion,
        parent=parent,
        child=child,
        xyz=origin[1],
        rpy=to_rpy(origin[0]),
        axis=axis,
        limits=joint.limits if joint else None,
        mimics=None,
        place=Span(0),
    )


def _frame(frame: Frame, values: Mapping[str, float]) -> Placed:
    rows = [evaluate(cell, values) for cell in frame.rotation]
    x, y, z = (evaluate(cell, values) for cell in frame.xyz)
    a, b, c = (_vector(rows[3 * k : 3 * k + 3]) for k in range(3))
    return (a, b, c), (x, y, z)


def _vector(parts: Sequence[float]) -> tuple[float, float, float]:
    x, y, z = parts
    return x, y, z

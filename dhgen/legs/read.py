"""A file with `legs` to a ParallelRobot: each leg is read by what reads serial robots."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, cast

from dhgen.legs.mobility import counted, faults
from dhgen.legs.robot import Leg, ParallelRobot
from dhgen.robot.assemble import Assembly, task_of
from dhgen.robot.cell_notes import names
from dhgen.robot.cells import Cells
from dhgen.robot.expression import ZERO
from dhgen.robot.frames import IDENTITY_FRAME, from_rpy, read_lengths
from dhgen.robot.names import MAX_ROBOT_NAME
from dhgen.robot.report import LEGS
from dhgen.robot.robot import Convention, DhTable, Frame, JointKind, Robot, joints_of
from dhgen.robot.schema import LegEntry, RobotFile
from dhgen.robot.shape import Shape
from dhgen.robot.task import Task, TaskKind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.legs.robot import Rows
    from dhgen.robot.expression import Expression
    from dhgen.robot.reader import Path
    from dhgen.robot.report import Report
    from dhgen.robot.robot import Parameter, ReferenceAxes

XY, YAW = ("x", "y"), ("yaw",)
PLANE, TURNED_PLANE = Task(TaskKind.LIST, XY), Task(TaskKind.LIST, XY, YAW)
POSE, POSITION = Task(TaskKind.POSE), Task(TaskKind.POSITION)
# What a leg does in its own frame that carries a point, or a frame, of a platform with a task.
OF_A_POINT = {POSE: POSITION, POSITION: POSITION, TURNED_PLANE: PLANE, PLANE: PLANE}
OF_A_FRAME = {POSE: POSE, TURNED_PLANE: TURNED_PLANE}
FOR_LEGS = ("name", "title", "source", "convention", "parameters", LEGS, "task", "units")
SUFFIX = "_leg"
LONGEST_NAME = MAX_ROBOT_NAME - len(SUFFIX) - 2
LEVEL = 1e-12  # sine of the angle between a leg's z and the platform's plane's


def assemble_parallel(report: Report) -> ParallelRobot | None:
    """The robot of a document that has legs.

    Args:
        report: Where mistakes and notices go.

    Returns:
        The robot; None, or a robot of no use, after a mistake.
    """
    return _Reading(report).robot()


@dataclass(frozen=True, slots=True)
class _Read:
    """A leg as written, which may describe several.

    Attributes:
        path: Its place.
        geometry: Its table or axes.
        base: Its place on the base.
        end: What it carries.
        driven: Its driven joints, from 0.
        carries_frame: Whether that is a frame.
        turns: The angles by which it is turned.
    """

    path: Path
    geometry: DhTable | ReferenceAxes
    base: Frame
    end: Frame
    driven: tuple[int, ...]
    carries_frame: bool
    turns: tuple[Frame, ...]


class _Reading:
    def __init__(self, report: Report) -> None:
        self.report = report
        self.shape, self.cells = Shape(report), Cells(report)

    def robot(self) -> ParallelRobot | None:
        self._refuse_keys()
        task = self._task()
        whole = Assembly(self.report, self.shape, self.cells)
        units, parameters = whole.beginning()
        paths = [(LEGS, i) for i in range(self.report.document.count((LEGS,)))]
        read = [leg for path in paths if (leg := self._leg(path)) is not None]
        whole.note_cells(units)
        if task is not None:
            self._demand_what_the_task_takes(task, read)
        file = self.shape.file
        if file is None or task is None or len(read) < len(paths) or self.report.errors:
            return None
        if not self._is_movable(task, read):
            return None
        drawn = [self._chain(file, parameters, units.length, leg, task) for leg in read]
        legs = [leg for chain in drawn for leg in chain]
        if not self._are_apart(legs):
            return None
        return ParallelRobot(
            name=file.name,
            title=file.title or file.name,
            source=file.source,
            legs=_named(file.name, legs),
            task=task,
            length_unit=units.length,
            notices=self.report.notices,
            doubts=tuple(self.report.doubts),
        )

    def _refuse_keys(self) -> None:
        """Reports keys of a serial robot."""
        for key in RobotFile.model_fields:
            if key not in FOR_LEGS and self.report.document.has(key):
                message = f"'{key}' is for serial robots: this one has legs"
                self.report.error_at_key((key,), message)

    def _task(self) -> Task | None:
        """What the platform does; None where that is no task of a robot with legs."""
        if not self.shape.right(("task",)):
            return None
        written = self.report.document.plain(("task",)) if self._has_task else POSE.text
        task = task_of(cast("str | list[str]", written))
        if task in OF_A_POINT:
            return task
        allowed = ", ".join(each.text for each in OF_A_POINT)
        self.report.error(("task",), f"the task of a robot with legs is one of {allowed}")
        return None

    @property
    def _has_task(self) -> bool:
        return self.report.document.has("task")

    def _leg(self, path: Path) -> _Read | None:
        if not isinstance(self.report.document.plain(path), dict):
            return None  # which is reported already
        entry = self.shape.section(path, LegEntry)
        own = Assembly(self.report, self.shape, self.cells, path)
        geometry, base, frame = own.geometry(), own.frame("base"), own.frame("frame")
        given = self._carried(path)
        if entry is None or geometry is None:
            return None
        point = read_lengths(self.cells, (*path, "point"), entry.point)
        joints = len(joints_of(geometry))
        angles = [
            self.cells.angle((*path, "turned", i), cell) for i, cell in enumerate(entry.turned)
        ]
        return _Read(
            path=path,
            geometry=geometry,
            base=base,
            end=Frame(point, IDENTITY_FRAME.rotation) if "point" in given else frame,
            driven=self._driven(path, entry.actuated, joints),
            carries_frame="frame" in given,
            turns=tuple(map(self._turn, angles)) or (IDENTITY_FRAME,),
        )

    def _carried(self, path: Path) -> Sequence[str]:
        """The keys for what a leg carries; other numbers of them than one are reported."""
        written = cast("dict[str, object]", self.report.document.plain(path))
        given = [key for key in ("point", "frame") if key in written]
        if len(given) != 1 and written.keys() <= LegEntry.model_fields.keys():  # none misspelt
            message = "a leg carries a point or a frame of the platform: write one of the two"
            self.report.error_at_key((*path, given[1]) if given else path, message)
        return given

    def _driven(self, path: Path, numbers: Sequence[int], joints: int) -> tuple[int, ...]:
        # of rows with mistakes there is no joint, and that is no mistake of the numbers
        written = sum(self.report.document.count((*path, key)) for key in ("joints", "axes"))
        most = max(joints, written) if joints and self.report.errors else joints
        for i, number in enumerate(numbers):
            place = (*path, "actuated", i)
            if most and not 1 <= number <= most:
                message = f"there is no joint {number}: joints are numbered from 1 to {most}"
                self.report.error(place, message)
            elif i and number <= numbers[i - 1]:
                self.report.error(place, "list driven joints in ascending order, each once")
        return tuple(number - 1 for number in numbers)

    def _turn(self, angle: Expression) -> Frame:
        rotation = from_rpy((ZERO, ZERO, angle), (0.0, 0.0, self.cells.value(angle)))
        return Frame((ZERO, ZERO, ZERO), rotation)

    def _is_movable(self, task: Task, legs: Sequence[_Read]) -> bool:
        """Whether legs can move a platform as a task needs; if not, why is reported."""
        each = [leg for leg in legs for _ in leg.turns]
        if len(each) < 2:
            message = "a parallel robot has two legs at least; one alone is a serial robot"
            self.report.error_at_key((LEGS,), message)
            return False
        if task in (PLANE, TURNED_PLANE):
            for leg in legs:
                self._demand_slides_in_the_plane(leg)
        joints = [len(joints_of(leg.geometry)) for leg in each]
        driven = sum(len(leg.driven) for leg in each)
        meant = "" if self._has_task else "; without `task` it is the whole pose"
        for fault in faults(counted(task, joints, [not leg.carries_frame for leg in each], driven)):
            self.report.error_at_key((LEGS,), f"{fault}{meant}")
        return not self.report.errors

    def _demand_what_the_task_takes(self, task: Task, legs: Sequence[_Read]) -> None:
        """Reports frames that the task can't move so."""
        for leg in legs:
            if leg.carries_frame and task not in OF_A_FRAME:
                message = f"the task {task.text} names no orientation: the leg carries a point"
                self.report.error_at_key((*leg.path, "frame"), message)
            if task in (PLANE, TURNED_PLANE):
                self._demand_level(leg)

    def _are_apart(self, legs: Sequence[Leg]) -> bool:
        """Whether no leg is mounted where another one is; if one is, it is reported."""
        for number, leg in enumerate(legs):
            if (first := legs.index(leg)) < number:
                message = (
                    f"legs {first + 1} and {number + 1} are the same in the same place: one of "
                    "them holds nothing"
                )
                self.report.error_at_key((LEGS,), message)
                return False
        return True

    def _demand_level(self, leg: _Read) -> None:
        """Reports a leg of a planar platform whose base is tilted out of the plane."""
        for key, frame in (("base", leg.base), ("frame", leg.end)):
            row = [self.cells.value(cell) for cell in frame.rotation[6:]]
            if abs(row[0]) > LEVEL or abs(row[1]) > LEVEL or row[2] < 0.0:
                message = f"the task is in the plane of x and y: z of this {key} has to be theirs"
                self.report.error_at_key((*leg.path, key), message)

    def _demand_slides_in_the_plane(self, leg: _Read) -> None:
        """Reports slides of a leg of a planar platform that move out of the plane."""
        by_rows = isinstance(leg.geometry, DhTable)
        message = "this joint slides along z, out of the plane of x and y that the task names"
        if by_rows:
            message += (
                ": a leg that begins with a slide in the plane is written with `axes`, where a "
                "slide has any direction"
            )
        for i, is_out in enumerate(self._slides_along_z(leg.geometry)):
            if is_out:
                self.report.error((*leg.path, "joints" if by_rows else "axes", i), message)

    def _slides_along_z(self, geometry: DhTable | ReferenceAxes) -> list[bool]:
        """Of every row or axis whether it slides along z of the leg's base, whatever turns."""
        if not isinstance(geometry, DhTable):
            aside = [max(abs(self.cells.value(x)) for x in a.direction[:2]) for a in geometry.axes]
            return [
                axis.kind is JointKind.PRISMATIC and x <= LEVEL
                for axis, x in zip(geometry.axes, aside, strict=True)
            ]
        found, is_upright = [], True
        for row in geometry.rows:
            tilts = abs(math.sin(self.cells.value(row.alpha))) > LEVEL
            before = is_upright and not (geometry.convention is Convention.MODIFIED and tilts)
            found.append(before and row.kind is JointKind.PRISMATIC and row.sign != 0)
            is_upright = is_upright and not tilts
        return found

    def _chain(
        self,
        file: RobotFile,
        parameters: Sequence[Parameter],
        unit: str,
        leg: _Read,
        task: Task,
    ) -> list[Leg]:
        """The legs that a leg as written describes; their chain has no name yet."""
        robot = Robot(
            name="",
            title=f"{file.title or file.name}: a leg",
            source=file.source,
            parameters=_used(parameters, leg.geometry),
            geometry=leg.geometry,
            base=IDENTITY_FRAME,
            tool=IDENTITY_FRAME,
            task=(OF_A_FRAME if leg.carries_frame else OF_A_POINT)[task],
            length_unit=unit,
        )
        base, end = self._numbers(leg.base), self._numbers(leg.end)
        turns = [self._numbers(turn) for turn in leg.turns]
        return [
            Leg(robot, product(turn, base), product(turn, end), leg.driven, leg.carries_frame)
            for turn in turns
        ]

    def _numbers(self, frame: Frame) -> Rows:
        rows = [(*frame.rotation[3 * i : 3 * i + 3], frame.xyz[i]) for i in range(3)]
        return tuple(self.cells.value(cell) for row in rows for cell in row)


def product(one: Rows, other: Rows) -> Rows:
    """The product of two frames."""
    return tuple(
        sum(one[4 * i + k] * other[4 * k + j] for k in range(3)) + (one[4 * i + 3] if j == 3 else 0)
        for i in range(3)
        for j in range(4)
    )


def _named(name: str, legs: Sequence[Leg]) -> tuple[Leg, ...]:
    """Legs whose chains have names: the same where they are alike, numbers where there are more."""
    kinds = list(dict.fromkeys(leg.chain for leg in legs))
    ends = [""] if len(kinds) == 1 else list(map(str, range(1, len(kinds) + 1)))
    named = {
        chain: replace(chain, name=f"{name[:LONGEST_NAME]}{SUFFIX}{end}", owner=name)
        for chain, end in zip(kinds, ends, strict=True)
    }
    return tuple(replace(leg, chain=named[leg.chain]) for leg in legs)


def _used(
    parameters: Sequence[Parameter], geometry: DhTable | ReferenceAxes
) -> tuple[Parameter, ...]:
    """The parameters that a leg's cells name, also by way of others."""
    used = set().union(*(names(cell) for cell in _cells(geometry)))
    for parameter in reversed(parameters):
        if parameter.name in used:
            used |= names(parameter.expression)
    return tuple(parameter for parameter in parameters if parameter.name in used)


def _cells(geometry: DhTable | ReferenceAxes) -> list[Expression]:
    if isinstance(geometry, DhTable):
        rows = geometry.rows
        shares = [coupling.factor for row in rows for coupling in row.couplings]
        return [cell for row in rows for cell in (row.theta, row.d, row.a, row.alpha)] + shares
    axes = [cell for axis in geometry.axes for cell in (*axis.direction, *axis.point)]
    return [*axes, *geometry.home.xyz, *geometry.home.rotation]

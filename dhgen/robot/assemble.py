"""The sections of a file put together; each is read by itself, so that all mistakes are found."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.cell_notes import note_slips, note_snapped, note_tiny_limits, note_turns
from dhgen.robot.cells import INVALID, Cells
from dhgen.robot.couplings import check_couplings, numbers_of
from dhgen.robot.frames import IDENTITY_FRAME, read_frame
from dhgen.robot.joints import read_axis, read_row
from dhgen.robot.lengths import note_distance, note_spread
from dhgen.robot.names import why_no_parameter_name
from dhgen.robot.passive import check_passive, is_passive
from dhgen.robot.report import LEGS
from dhgen.robot.robot import Convention, DhTable, Parameter, ReferenceAxes, Robot, joints_of
from dhgen.robot.schema import AxisRow, FrameEntry, JointRow, SumEntry, Units
from dhgen.robot.shape import Shape
from dhgen.robot.source import quoted
from dhgen.robot.sums import check_once, read_sum
from dhgen.robot.task import ANGLES, ARM_ANGLE, COORDINATES, Task, TaskKind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.robot.reader import Path
    from dhgen.robot.report import Report
    from dhgen.robot.robot import DhRow, Frame, SumLimit


def assemble(report: Report) -> Robot | None:
    """The robot of a document.

    Args:
        report: Where mistakes and notices go.

    Returns:
        The robot; None, or a robot of no use, after a mistake.
    """
    return Assembly(report, Shape(report), Cells(report)).robot()


class Assembly:
    """The sections of a file, or of one leg of it.

    Args:
        report: Where mistakes and notices go.
        shape: Which sections have the shape that they should have.
        cells: Reads cells.
        at: The place of the table: of a leg its place in the list of legs.
    """

    def __init__(self, report: Report, shape: Shape, cells: Cells, at: Path = ()) -> None:
        self.report = report
        self.document = report.document
        self.shape = shape
        self.cells = cells
        self.at = at

    def robot(self) -> Robot | None:
        """The robot of the whole file; None after a mistake that leaves none."""
        if self.document.has(LEGS):
            message = "a robot with legs is a parallel one: its solvers are made by `dhgen FILE`"
            self.report.error_at_key((LEGS,), message)
            return None
        units, parameters = self.beginning()
        geometry = self.geometry()
        base, tool = self.frame("base"), self.frame("tool")
        sums = self._sums(geometry)
        free = self._free(len(self._numbers()))
        self.note_cells(units)
        file = self.shape.file
        if file is None or geometry is None:
            return None
        return Robot(
            name=file.name,
            title=file.title or file.name,
            source=file.source,
            parameters=parameters,
            geometry=geometry,
            base=base,
            tool=tool,
            task=task_of(file.task),
            free=free,
            arm_angle=self._plain_free() == ARM_ANGLE,
            steps=tuple(file.steps),
            numerical=file.numerical,
            length_unit=units.length,
            float32=file.float32,
            plain=file.plain,
            calibration=file.calibration,
            sums=sums,
            taken=tuple(dict.fromkeys(self.cells.taken)),
            notices=self.report.notices,
            doubts=tuple(self.report.doubts),
        )

    def beginning(self) -> tuple[Units, tuple[Parameter, ...]]:
        """What cells are read by: the units and the parameters."""
        units = self.shape.section(("units",), Units) or Units()
        self.cells.units.degrees = units.angle == "deg"
        return units, self._parameters()

    def note_cells(self, units: Units) -> None:
        """Remarks that cells get beside each other, and on parameters that none uses."""
        for name in self.cells.used.unused():
            message = f"no cell uses the parameter '{name}': remove it, or use it in a cell"
            self.report.notice_at_key(("parameters", name), message)
        note_slips(self.report, self.cells.slips)
        note_snapped(self.report, self.cells.snapped)
        in_radians = "angle" in units.model_fields_set
        note_turns(self.report, self.cells.many_turns, in_radians=in_radians)
        note_tiny_limits(self.report, self.cells.limits_in_degrees)
        note_spread(self.report, self.cells.lengths, units.length)
        note_distance(self.report, self.cells.lengths)

    def _parameters(self) -> tuple[Parameter, ...]:
        plain = self.document.plain(("parameters",)) if self.document.has("parameters") else {}
        entries = plain if isinstance(plain, dict) else {}
        self.cells.announce({name: str(cell) for name, cell in entries.items()})
        parameters = []
        for name, cell in entries.items():
            path = ("parameters", name)
            if reason := why_no_parameter_name(name):
                self.report.error_at_key(path, f"{quoted(name)} can't be a parameter: {reason}")
            right = self.shape.right(path)
            expression = self.cells.parse(path, cell) if right else INVALID
            value = self.cells.define(name, expression)
            parameters.append(Parameter(name, expression, value))
        return tuple(parameters)

    def geometry(self) -> DhTable | ReferenceAxes | None:
        """The table, or the axes in the reference position."""
        self._check_names()
        if self._has("joints") and self._has("axes"):
            self.report.error_at_key((*self.at, "axes"), "a robot has joints or axes, not both")
        elif self._has("axes"):
            return self._axes()
        elif not self._has("joints"):
            message = (
                "no joints: write them as 'joints' (a table) or as 'axes' (reference position)"
            )
            self.report.error(self.at, message)
        return self._table()

    def _has(self, key: str) -> bool:
        """Whether the file, or the leg, has a key."""
        return self.document.has(key, self.at)

    def _table(self) -> DhTable:
        if self._has("home") and not self._has("axes"):
            message = "'home' goes with 'axes'; with 'joints' use 'tool'"
            self.report.error_at_key((*self.at, "home"), message)
        rows, count = [], self._count("joints")
        numbers = self._numbers()
        for path in [(*self.at, "joints", i) for i in range(count)]:
            if entry := self.shape.section(path, JointRow):
                complete = self.shape.right(path)
                rows.append(read_row(self.cells, path, entry, numbers, complete=complete))
        if len(rows) == count:
            self._check_drives(rows, tuple(numbers))
        file = self.shape.file
        return DhTable(Convention(file.convention if file else "standard"), tuple(rows))

    def _check_drives(self, rows: Sequence[DhRow], numbers: tuple[int, ...]) -> None:
        """Checks other rows' variables in rows; rows with other mistakes are left out."""
        table = (*self.at, "joints")
        right = check_couplings(self.cells, table, rows, numbers)
        if right and numbers == tuple(n for n, row in enumerate(rows, start=1) if row.sign):
            for place in set(range(len(rows))) - {number - 1 for number in numbers}:
                check_passive(self.cells, (*table, place), rows[place])

    def _numbers(self) -> dict[int, int]:
        """The joints' numbers by their rows' numbers; passive rows have no q."""
        rows = self._count("joints")
        passive = [
            number
            for number in range(1, rows + 1)
            if is_passive(self.document.plain((*self.at, "joints", number - 1)), number, rows)
        ]
        count = max(rows, self._count("axes"))
        return numbers_of([number for number in range(1, count + 1) if number not in passive])

    def _sums(self, geometry: DhTable | ReferenceAxes | None) -> tuple[SumLimit, ...]:
        if geometry is None:
            return ()
        rows = joints_of(geometry)
        kinds, numbers = [row.kind for row in rows], self._numbers()
        if len(kinds) < len(numbers):
            return ()  # a row that could not be read is reported already
        found: list[SumLimit] = []
        for path in [("limits", i) for i in range(self._count("limits"))]:
            entry = self.shape.section(path, SumEntry)
            read = read_sum(self.cells, path, entry, kinds, numbers) if entry else None
            if read is not None:
                limits = [row.limits for row in rows]
                check_once(self.cells, path, read, (found, limits))
                found.append(read)
        return tuple(found)

    def _axes(self) -> ReferenceAxes:
        if self.document.has("convention"):
            message = "'convention' goes with 'joints'; 'axes' need none"
            self.report.error_at_key(("convention",), message)
        axes = tuple(
            read_axis(self.cells, path, entry, complete=self.shape.right(path))
            for path in [(*self.at, "axes", i) for i in range(self._count("axes"))]
            if (entry := self.shape.section(path, AxisRow))
        )
        return ReferenceAxes(axes, self.frame("home"))

    def _check_names(self) -> None:
        """Names are for all joints or for none, and each is of one joint."""
        key = "joints" if self._has("joints") else "axes"
        rows = [(*self.at, key, place) for place in range(self._count(key))]
        named: dict[str, int] = {}
        unnamed: list[int] = []
        for number, path in enumerate(rows, start=1):
            row = self.document.plain(path)
            if not isinstance(row, dict) or "name" not in row:
                unnamed.append(number)
                continue
            name = str(row["name"])
            if self.shape.right((*path, "name")) and name in named:
                self.report.error((*path, "name"), f"joint {named[name]} is called so, too")
            named.setdefault(name, number)
        if named and unnamed:
            message = f"joint {unnamed[0]} has no name: name every joint, or none"
            self.report.error(rows[unnamed[0] - 1], message)

    def frame(self, key: str) -> Frame:
        """A constant frame."""
        path = (*self.at, key)
        entry = self.shape.section(path, FrameEntry) if self._has(key) else None
        return read_frame(self.cells, path, entry) if entry else IDENTITY_FRAME

    def _free(self, joints: int) -> tuple[int, ...]:
        plain = self._plain_free()
        free: list[int] = []
        for i, entry in enumerate(plain if isinstance(plain, list) else []):
            path = ("free", i)
            if not self.shape.right(path):
                continue
            number = int(entry)
            if not 1 <= number <= joints:
                message = f"there is no joint {number}: joints are numbered from 1 to {joints}"
                if joints < number <= self._count("joints"):
                    message += "; rows without q are none"
                self.report.error(path, message)
            elif free and number <= free[-1]:
                self.report.error(path, "list free joints in ascending order, each once")
            free.append(number)
        if joints and free == list(range(1, joints + 1)):
            self.report.error(("free",), "every joint is free: there is nothing to solve")
        return tuple(free)

    def _plain_free(self) -> object:
        return self.document.plain(("free",)) if self.document.has("free") else []

    def _count(self, key: str) -> int:
        return self.document.count((*self.at, key)) if self._has(key) else 0


def task_of(entry: str | list[str]) -> Task:
    """The task as a file writes it."""
    if isinstance(entry, str):
        return Task(TaskKind(entry))
    angles = next(angles for angles in ANGLES if set(entry) - set(COORDINATES) == set(angles))
    return Task(TaskKind.LIST, tuple(c for c in COORDINATES if c in entry), angles)

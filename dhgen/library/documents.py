"""What is shown of an arm: its table in a terminal and in a notebook, its derivation."""

from __future__ import annotations

import math
import re
from base64 import b64encode
from typing import TYPE_CHECKING

from dhgen.robot.exact import add, multiply
from dhgen.robot.expression import ZERO, Name, Negate, to_text
from dhgen.robot.robot import AxisJoint, Convention, DhRow, DhTable, JointKind
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence
    from typing import Self

    from dhgen.robot.expression import Expression
    from dhgen.robot.robot import Robot

_DISPLAY = re.compile(r"^```math\n(.*?)\n```$", re.MULTILINE | re.DOTALL)
_INLINE = re.compile(r"\$`(.+?)`\$")
_ESCAPE = re.compile(r"\\(.)")
_SPECIAL = re.compile(r"([\\`*_\[\]<>#|~$&])")


class Document(str):
    """A derivation in GitHub's Markdown; a notebook shows it with its formulas and figures.

    Attributes:
        figures: The figures that it links, SVG by their paths.
    """

    __slots__ = ("figures",)

    figures: Mapping[str, str]

    def __new__(cls, text: str, figures: Mapping[str, str] | None = None) -> Self:
        """A text with its figures."""
        made = super().__new__(cls, text)
        made.figures = figures or {}
        return made

    def __repr__(self) -> str:
        title = next((line[2:] for line in self.splitlines() if line.startswith("# ")), "Markdown")
        title = _ESCAPE.sub(r"\1", title)
        return f"<{title}; {len(self.splitlines())} lines of Markdown, to print or to save>"

    def _repr_markdown_(self) -> str:
        """The document as notebooks read it: formulas between dollar signs, figures in the text."""
        shown = _INLINE.sub(r"$\1$", _DISPLAY.sub(r"$$\n\1\n$$", str(self)))
        for path, figure in self.figures.items():
            data = b64encode(figure.encode()).decode()
            shown = shown.replace(f"]({path})", f"](data:image/svg+xml;base64,{data})")
        return shown


def table_rows(robot: Robot) -> list[tuple[str, ...]]:
    """The head and the rows of a robot's table, or of its axes, as the robot file has them."""
    geometry = robot.geometry
    if isinstance(geometry, DhTable):
        columns = ["theta", "d", "a", "alpha"]
        if geometry.convention is Convention.MODIFIED:
            columns = ["alpha", "a", "theta", "d"]
        cells = [_row_cells(row) for row in geometry.rows]
        body = [tuple(row[column] for column in columns) for row in cells]
    else:
        columns = ["type", "direction", "point"]
        body = [_axis_cells(axis) for axis in geometry.axes]
    rows: Sequence[DhRow | AxisJoint] = robot.joints
    labels = [str(number) for number in range(1, len(rows) + 1)]
    if isinstance(geometry, DhTable):
        rows, labels = geometry.rows, list(geometry.labels)
    names = [f"{label} {row.name}".rstrip() for label, row in zip(labels, rows, strict=True)]
    limits = [_limits(row, robot.length_unit) for row in rows]
    shown = [(name, *row, end) for name, row, end in zip(names, body, limits, strict=True)]
    return [("joint", *columns, "limits"), *shown]


def parameters_line(robot: Robot) -> str:
    """The robot's own numbers; empty where it has none."""
    return ", ".join(f"{each.name} = {each.value:.10g}" for each in robot.parameters)


def kind_line(robot: Robot) -> str:
    """What joints the arm has, what the caller gives and asks for, how the table is read."""
    facts = ["".join("R" if each.kind is JointKind.REVOLUTE else "P" for each in robot.joints)]
    if robot.arm_angle:
        facts.append("the caller gives the arm angle")
    if robot.free:
        facts.append(f"the caller gives {', '.join(f'q{number}' for number in robot.free)}")
    if robot.task.kind is not TaskKind.POSE:
        listed = ", ".join((*robot.task.coordinates, *robot.task.angles))
        facts.append(f"task: {f'[{listed}]' if listed else robot.task.kind.value}")
    if isinstance(robot.geometry, DhTable):
        return "; ".join([*facts, f"{robot.geometry.convention.value} convention"])
    return "; ".join([*facts, "axes in the reference position"])


def as_text(rows: Iterable[tuple[str, ...]]) -> list[str]:
    """Rows below each other."""
    kept = list(rows)
    widths = [max(len(row[column]) for row in kept) for column in range(len(kept[0]))]
    return [
        "  ".join(f"{cell:<{w}}" for cell, w in zip(row, widths, strict=True)).rstrip()
        for row in kept
    ]


def as_markdown(rows: Iterable[tuple[str, ...]]) -> str:
    """Rows as a table of Markdown."""
    head, *body = (f"| {' | '.join(map(escaped, row))} |" for row in rows)
    return "\n".join([head, "|" + "---|" * (head.count(" | ") + 1), *body])


def escaped(text: str) -> str:
    """A text of which Markdown reads nothing as its own."""
    return _SPECIAL.sub(r"\\\1", text)


def _row_cells(row: DhRow) -> dict[str, str]:
    cells = {"theta": row.theta, "d": row.d, "a": row.a, "alpha": row.alpha}
    shown = {name: to_text(cell) for name, cell in cells.items()}
    own = "theta" if row.kind is JointKind.REVOLUTE else "d"
    return {**shown, own: _variable(row, cells[own])}


def _variable(row: DhRow, offset: Expression) -> str:
    own: dict[int, Expression] = {1: Name("q"), 0: ZERO, -1: Negate(Name("q"))}
    moved = own[row.sign]
    for each in row.couplings:
        moved = add(moved, multiply(each.factor, Name(f"q{each.joint}")))
    q, beside = to_text(moved), to_text(offset)
    if offset == ZERO:
        return q
    return f"{q} - {beside[1:]}" if beside.startswith("-") else f"{q} + {beside}"


def _axis_cells(axis: AxisJoint) -> tuple[str, str, str]:
    slides = axis.kind is JointKind.PRISMATIC
    return axis.kind.value, _triple(axis.direction), "" if slides else _triple(axis.point)


def _triple(cells: Iterable[Expression]) -> str:
    return f"({', '.join(map(to_text, cells))})"


def _limits(joint: DhRow | AxisJoint, unit: str) -> str:
    if joint.limits is None:
        return "none"
    if joint.kind is JointKind.PRISMATIC:
        return f"{joint.limits[0]:.6g} to {joint.limits[1]:.6g} {unit}"
    low, high = map(math.degrees, joint.limits)
    return f"{low:.6g} to {high:.6g} deg"

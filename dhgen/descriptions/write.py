"""A robot file as a person would have written it: a table, or axes, with names for lengths."""

from __future__ import annotations

import math
import re
import unicodedata
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from dhgen.descriptions.mimic import share_text
from dhgen.descriptions.rotations import to_rpy
from dhgen.robot.angles import MEASURED, SNAP, exact_angle, near_right_angle, twelfths
from dhgen.robot.expression import to_text
from dhgen.robot.names import MAX_ROBOT_NAME, YAML_WORDS, why_no_joint_name, why_no_robot_name
from dhgen.robot.robot import Convention

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.descriptions.lines import Arm, Axis
    from dhgen.descriptions.model import Joint
    from dhgen.descriptions.rotations import Placed
    from dhgen.descriptions.table import Row, Table

DIGITS = 15  # of lengths behind the point of an arm of 1 m: those behind are rounding
SAME = 1e-9  # arm sizes by which lengths that are one differ
WIDTH = 100
NOTHING = "null"  # what a text of YAML can't be without quotes
WRITTEN = 1e-8  # [rad] by which limits of whole degrees differ from them, written in radians
_TWELFTH = math.pi / 12
FEW_TURNS = 4.0 * math.pi  # rad: a limit beyond looks like degrees
MOST_TURNS = 1e4  # rad: a limit beyond is as good as none
SOME_TURNS = 20.0 * math.pi  # rad: the other end of a joint that is stopped on one side


@dataclass(frozen=True, slots=True)
class Heading:
    """The part of a robot file before its numbers.

    Attributes:
        name: Identifier of the robot.
        title: What people call it.
        source: Where its numbers come from, and which links poses are between.
        free: Joints, from 1, whose values are to be given, or `ARM_ANGLE`.
        length_unit: How lengths are called.
    """

    name: str
    title: str
    source: str
    free: tuple[int, ...] | str = ()
    length_unit: str = "m"


def identifier(text: str) -> str:
    """A robot's name made of any text, of letters with accents those without."""
    parts = unicodedata.normalize("NFKD", text.casefold())
    plain_letters = "".join(part for part in parts if not unicodedata.combining(part))
    name = re.sub(r"[^a-z0-9]+", "_", plain_letters).strip("_")[:MAX_ROBOT_NAME].rstrip("_")
    if not name or name == NOTHING or why_no_robot_name(name) is not None:
        name = f"robot_{name}"[:MAX_ROBOT_NAME].rstrip("_")
    return name


def plain(text: str) -> str:
    """A text of a description for a line of a robot file."""
    return "".join(c if c.isprintable() else "?" for c in text).strip()[:80] or "?"


@dataclass(slots=True)
class _Lengths:
    """Names of lengths: one for each size."""

    arm: Arm
    names: dict[str, float] = field(default_factory=dict)

    def cell(self, value: float, name: str) -> str:
        """A length as a cell, under a name; zero has none."""
        number = self.number(value)
        if not number:
            return "0"
        sign = "-" if number < 0 else ""
        for known, length in self.names.items():
            if abs(length - abs(number)) <= SAME * self.arm.size:
                return sign + known
        self.names[name] = abs(number)
        return sign + name

    def number(self, value: float) -> float:
        digits = DIGITS - math.ceil(math.log10(self.arm.size))
        return 0.0 if abs(value) < self.arm.negligible else round(value, digits) + 0.0

    def bare(self, value: float) -> str:
        """A length as a cell without a name of its own."""
        number = self.number(value)
        for known, length in self.names.items():
            if abs(length - abs(number)) <= SAME * self.arm.size:
                return ("-" if number < 0 else "") + known
        return decimal(number)


def decimal(value: float) -> str:
    """A number without an exponent, with all its digits."""
    text = repr(value + 0.0)
    if "e" in text:
        text = f"{value:.20f}".rstrip("0")
    return text.removesuffix(".0").removesuffix(".") or "0"


def angle_cell(value: float, near: float) -> str:
    """An angle as a cell: a multiple of 15 degrees, some degrees, or a number [rad]."""
    k = twelfths(value)
    if k is None and abs(value - round(value / _TWELFTH) * _TWELFTH) < near:
        k = round(value / _TWELFTH)
    if k is not None:
        return to_text(exact_angle(12 if k % 24 == 12 else (k + 12) % 24 - 12))
    if near <= SNAP and near_right_angle(value, "pi"):  # no slip: nothing is to be taken as exact
        return _with_all_digits(decimal(value))
    return _degrees(value, 1e-14) or decimal(value)


def _with_all_digits(text: str) -> str:
    """A decimal with zeros behind it until its digits are not few."""
    whole, point, rest = text.partition(".")
    missing = MEASURED - len((whole + rest).lstrip("-0"))
    return whole + (point or ".") + rest + "0" * missing


def _degrees(value: float, near: float) -> str | None:
    """So many degrees, where they are few digits of them."""
    degrees = round(math.degrees(value), 1)
    if degrees and abs(math.radians(degrees) - value) < near:
        return f"{decimal(degrees)} deg"
    return None


def table_text(heading: Heading, arm: Arm, table: Table) -> str:
    """The robot file of a table."""
    lengths = _Lengths(arm)
    numbers = {row.axis.joint.name: number for number, row in enumerate(table.rows, 1)}
    rows = [_row(row, numbers, table.convention, lengths) for row in table.rows]
    base, tool = _frame("base", table.base, lengths, arm), _frame("tool", table.tool, lengths, arm)
    return "\n".join(
        [
            *_head(heading),
            f"convention: {table.convention.value}",
            *_parameters(lengths),
            "joints:",
            *_aligned(rows, [row.axis.joint for row in table.rows]),
            *base,
            *tool,
            *_foot(heading, arm),
        ]
    )


def axes_text(heading: Heading, arm: Arm) -> str:
    """The robot file of axes in the reference position."""
    lengths = _Lengths(arm)
    rows, joints = [], [axis.joint for axis in arm.axes]
    for axis in arm.axes:
        row = {"type": "revolute" if axis.turns else "prismatic"}
        row["direction"] = _triple([decimal(_clean(part)) for part in axis.direction])
        if axis.turns:
            row["point"] = _triple([decimal(lengths.number(part)) for part in axis.point])
        if limits := limits_cell(axis.joint):
            row["limits"] = limits
        rows.append(row)
    home = _frame("home", arm.tip, lengths, arm) or ["home: {}"]
    return "\n".join(
        [*_head(heading), "axes:", *_aligned(rows, joints), *home, *_foot(heading, arm)]
    )


def _clean(part: float) -> float:
    """Of a direction: without what rounding left."""
    return round(part) + 0.0 if abs(part - round(part)) < 1e-15 else part


def _head(heading: Heading) -> list[str]:
    return [
        f"name: {heading.name}",
        f"title: {_quoted(heading.title)}",
        f"source: {_quoted(heading.source)}",
    ]


def _quoted(text: str) -> str:
    """A text as YAML takes it."""
    shown = plain(text) if len(text) <= 80 else "".join(c for c in text if c.isprintable())[:300]
    if re.fullmatch(r"[A-Za-z][\w .,()/-]*[\w.)]", shown, re.ASCII) and shown.lower() != NOTHING:
        return shown
    return "'" + shown.replace("'", "''") + "'"


def _parameters(lengths: _Lengths) -> list[str]:
    if not lengths.names:
        return []
    entries = [f"{name}: {decimal(value)}" for name, value in lengths.names.items()]
    line = "parameters: {" + ", ".join(entries) + "}"
    if len(line) <= WIDTH:
        return [line]
    return ["parameters:", *(f"  {entry}" for entry in entries)]


def _row(
    row: Row, numbers: Mapping[str, int], convention: Convention, lengths: _Lengths
) -> dict[str, str]:
    """The cells of a row, in the order in which its convention reads them."""
    q, near, number = _variable(row, numbers), lengths.arm.near, numbers[row.axis.joint.name]
    added = row.sign * row.axis.offset
    turn = angle_cell(row.turn + added * row.axis.turns, near)
    twist = angle_cell(row.twist, near)

    def along_x(link: int) -> str:
        return lengths.cell(row.length, f"a{link}")

    def along_z() -> dict[str, str]:
        offset = lengths.cell(row.offset + added * (not row.axis.turns), f"d{number}")
        if row.axis.turns:
            return {"theta": _beside(q, turn), "d": offset}
        return {"theta": turn, "d": _beside(q, offset)}

    if convention is Convention.MODIFIED:
        cells = {"alpha": twist, "a": along_x(number - 1), **along_z()}
    else:
        cells = {**along_z(), "a": along_x(number), "alpha": twist}
    if row.axis.joint.is_driven and (limits := limits_cell(row.axis.joint)):
        cells["limits"] = limits
    return cells


def _variable(row: Row, numbers: Mapping[str, int]) -> str:
    """What moves a row: q, -q, q - q2, -q3; what others move has their numbers."""
    text = ("-q" if row.sign < 0 else "q") if row.axis.joint.is_driven else ""
    for name, factor in row.axis.totals.items():
        signed = row.sign * factor
        if signed:
            mark = (" - " if signed < 0 else " + ") if text else "-" * (signed < 0)
            text += mark + share_text(signed, numbers[name])
    return text


def _beside(q: str, offset: str) -> str:
    if offset == "0":
        return q
    return f"{q} - {offset[1:]}" if offset.startswith("-") else f"{q} + {offset}"


def _aligned(rows: Sequence[dict[str, str]], joints: Sequence[Joint]) -> list[str]:
    """Rows in braces, what belongs together below each other, with the names of their joints.

    Names that a robot file can't hold are comments.
    """
    named = not any(why_no_joint_name(joint.name) for joint in joints)
    if named:
        for row, joint in zip(rows, joints, strict=True):
            row["name"] = _bare_or_quoted(joint.name)
    keys = list(dict.fromkeys(key for row in rows for key in row))
    widths = {key: max(len(row[key]) + 1 for row in rows if key in row) for key in keys}
    lines = []
    for row in rows:
        cells = [f"{key}: {row[key]}," for key in row]
        padded = [
            f"{cell:<{widths[key] + len(key) + 2}}" for key, cell in zip(row, cells, strict=True)
        ]
        lines.append("  - {" + " ".join(padded).rstrip().removesuffix(",") + "}")
    if named:
        return lines
    wide = max(map(len, lines))
    names = (plain(joint.name) for joint in joints)
    return [f"{line:<{wide}}  # {name}" for line, name in zip(lines, names, strict=True)]


def _bare_or_quoted(name: str) -> str:
    """A joint's name as YAML takes it between braces."""
    is_word = re.fullmatch(r"[A-Za-z_][\w/.+-]*", name, re.ASCII) and name.lower() not in YAML_WORDS
    return name if is_word else f"'{name}'"


def _frame(key: str, frame: Placed, lengths: _Lengths, arm: Arm) -> list[str]:
    """A frame's line, or none where it is none."""
    R, xyz = frame
    cells = []
    if any(map(lengths.number, xyz)):
        cells.append(f"xyz: {_triple([lengths.bare(part) for part in xyz])}")
    rpy = [angle_cell(angle, arm.near) for angle in to_rpy(R)]
    if any(angle != "0" for angle in rpy):
        cells.append(f"rpy: {_triple(rpy)}")
    return [f"{key}: {{{', '.join(cells)}}}"] if cells else []


def _triple(cells: Sequence[str]) -> str:
    return f"[{', '.join(cells)}]"


def _foot(heading: Heading, arm: Arm) -> list[str]:
    """What follows the joints: units that are not the usual ones or doubtful, and what is given."""
    units = [f"length: {heading.length_unit}"] if heading.length_unit != "m" else []
    units += ["angle: rad"] if any(map(looks_like_degrees, arm.axes)) else []
    return [*([f"units: {{{', '.join(units)}}}"] if units else []), *_free(heading)]


def looks_like_degrees(axis: Axis) -> bool:
    """Whether a joint may turn many times, which mostly is a mistake of whoever wrote that."""
    return limits_cell(axis.joint) is not None and axis.turns and _farthest(axis) > FEW_TURNS


def _farthest(axis: Axis) -> float:
    ends = map(abs, axis.joint.limits or ())
    return max((end for end in ends if end <= MOST_TURNS), default=0.0)


def ends_once(joint: Joint) -> bool:
    """Whether one of both ends is so far away that it is none, and the other is not."""
    least, most = sorted(map(abs, joint.limits or (0.0, 0.0)))
    return least <= MOST_TURNS < most


def _free(heading: Heading) -> list[str]:
    if not heading.free:
        return [""]
    if isinstance(heading.free, str):
        return [f"free: {heading.free}", ""]
    which = ", ".join(map(str, heading.free))
    return [f"free: [{which}]  # the caller gives its value; `free: []` names other choices", ""]


def limits_cell(joint: Joint) -> str | None:
    """Both ends of a joint's motion, in ascending order; None where nothing ends it."""
    if joint.limits is None:
        return None
    low, high = sorted(joint.limits)
    if joint.motion.turns and ends_once(joint):
        low, high = max(low, -SOME_TURNS), min(high, SOME_TURNS)
    if low >= high or max(abs(low), abs(high)) > MOST_TURNS:
        return None
    ends = (low, high)
    if not joint.motion.turns:
        return _triple([decimal(end) for end in ends])
    degrees = [_degrees(end, WRITTEN) for end in ends]
    if all(text or not end for text, end in zip(degrees, ends, strict=True)):
        return _triple([text or "0" for text in degrees])
    some = (-SOME_TURNS, SOME_TURNS)  # in degrees: a number of so many turns would be asked about
    texts = [
        text if end in some and text else decimal(end)
        for end, text in zip(ends, degrees, strict=True)
    ]
    return _triple(texts)

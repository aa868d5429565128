"""Compares the sections of a file with the schema: what is wrong, and what is valid."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, TypeVar

from pydantic import BaseModel, ValidationError

from dhgen.robot.arithmetic import nearest
from dhgen.robot.report import LEGS, within_leg
from dhgen.robot.schema import (
    FRAME_FORM,
    MAX_JOINTS,
    MAX_LEGS,
    AxisRow,
    ExpectedError,
    FrameEntry,
    JointRow,
    LegEntry,
    RobotFile,
    SumEntry,
    Units,
)
from dhgen.robot.source import quoted
from dhgen.robot.syntax import missing_blank

if TYPE_CHECKING:
    from collections.abc import Mapping

    from pydantic_core import ErrorDetails

    from dhgen.robot.reader import Path
    from dhgen.robot.report import Report


# Infinity, or no end at all, as other programs and people write it.
ENDLESS = (
    *(".inf", "inf", "infinity", "oo"),
    *("none", "null", "no", "false", "unlimited", "continuous", "endless"),
)
NO_LIMITS = "if nothing stops the joint, leave 'limits' out"

# By the kind of mistake, where every key that takes such a value takes the same.
_KINDS = {
    "string_type": "a number or an expression",
}

_KEYED = {"model_type", "dict_type"}  # where keys with values belong

_ROW = "{theta: q, d: 0, a: 0.4, alpha: pi/2}"
_AXIS = "{type: prismatic, direction: [0, 0, 1]}"
_LEG = f"{{base: {{xyz: [0.2, 0, 0]}}, joints: [{_ROW}], actuated: [1], point: [0.1, 0, 0]}}"
_VECTOR = "a list [x, y, z]"

# What a key holds that takes a list or further keys.
_FORMS = {
    "parameters": "names with values, e.g. {a1: 0.4}",
    "joints": f"a list of joints, e.g. [{_ROW}]",
    "legs": f"a list of legs, e.g. [{_LEG}]",
    "actuated": "a list of joints, e.g. [1]",
    "turned": "a list of angles, e.g. [0, 120 deg, 240 deg]",
    "frame": FRAME_FORM,
    "axes": f"a list of axes, e.g. [{_AXIS}]",
    "home": FRAME_FORM,
    "base": FRAME_FORM,
    "tool": FRAME_FORM,
    "steps": "a list of numbers, e.g. [2, 1]",
    "units": "keys with values, e.g. {length: mm}",
    "limits": "a list [lowest, highest]",
    "direction": _VECTOR,
    "point": _VECTOR,
    "xyz": _VECTOR,
    "rpy": "a list [roll, pitch, yaw]",
    "quaternion_xyzw": "a list [x, y, z, w]",
    "quaternion_wxyz": "a list [w, x, y, z]",
    "matrix": "four rows of four numbers",
}

_SUMS = "a list of sums, e.g. [{of: q2 + q3, from: -80 deg, to: 150 deg}]"

# What one entry of a list holds.
_ENTRIES = {
    "joints": f"a joint, e.g. {_ROW}",
    "axes": f"an axis, e.g. {_AXIS}",
    "legs": f"a leg, e.g. {_LEG}",
    "matrix": "a row of four numbers",
    "limits": "a sum with its limits, e.g. {of: q2 + q3, from: -80 deg, to: 150 deg}; limits of a "
    "joint stand in its row",
}


def is_endless(given: object) -> bool:
    """Whether a value means infinity, or no limit."""
    return isinstance(given, str) and given.strip().lstrip("+-").lower() in ENDLESS


def _is_none(given: object) -> bool:
    return given is None or is_endless(given)


def length_message(path: Path, details: ErrorDetails) -> str:
    """The mistake of a list of the wrong length, or of too many parameters."""
    context = details.get("ctx", {})
    count = context.get("actual_length")
    bound = context.get("min_length", context.get("max_length"))
    if path[-1] == "legs":
        return f"a robot has 2 to {MAX_LEGS} legs, not {count}"
    if path[-1] == "actuated":
        return "a leg has one driven joint at least: none may only guide the platform"
    if path[-1] == "turned":
        return f"expected 1 to {MAX_LEGS} values, not {count}: {_form(path)}"
    if path[-1] in {"joints", "axes"}:
        return f"a robot has 1 to {MAX_JOINTS} joints, not {count}"
    if path[-1] == "parameters":
        return f"a robot has at most {bound} parameters"
    hint = f"; {NO_LIMITS}" if path[-1] == "limits" and not count else ""
    return f"expected {bound} values, not {count}: {_form(path)}{hint}"


def value_message(details: ErrorDetails) -> str:
    """The mistake of any other value that can't be at its place."""
    given, path = details["input"], details["loc"]
    context = details.get("ctx", {})
    shown = quoted(given) if isinstance(given, str) else _kind(given)
    if details["type"] == "value_error":
        reason = context["error"]
        if isinstance(reason, ExpectedError):
            return f"expected {reason}, not {shown}"
        return f"{shown}: {reason}" if isinstance(given, str) else f"{reason}"
    if details["type"] == "string_type" and path[-1] in _WORDS:
        return f"expected a text, not {shown}"
    expected = context.get("expected") or _KINDS.get(details["type"]) or _form(path)
    blank = missing_blank(given) if details["type"] in _KEYED and isinstance(given, str) else None
    hint = f"; {NO_LIMITS}" if path[-1] == "limits" and _is_none(given) else ""
    return blank or f"expected {expected}, not {shown}{hint}"


def _form(path: Path) -> str:
    """What the key holds at the end of a path, or what an entry of its list does."""
    key = next(str(step) for step in reversed(path) if isinstance(step, str))
    if path == ("limits",):
        return _SUMS
    return _FORMS[key] if path[-1] == key else _ENTRIES[key]


def _kind(given: object) -> str:
    if given is None:
        return "nothing"
    if not isinstance(given, list):
        return "keys with values"
    return f"a list of {len(given)}" if given else "an empty list"


Model = TypeVar("Model", bound=BaseModel)

_MODELS: Mapping[str, type[BaseModel]] = {
    "joints": JointRow,
    "axes": AxisRow,
    "home": FrameEntry,
    "base": FrameEntry,
    "tool": FrameEntry,
    "units": Units,
    "limits": SumEntry,
    "frame": FrameEntry,
}
_WORDS = {"name", "title", "source"}  # who writes them in a joint may not mean the robot's
_JOINT_TYPES = "a joint slides by 'theta: 0, d: q', and turns by 'theta: q, d: 0'"
_LIMITS = "limits are a list: 'limits: [-1.5, 1.5]'"
# What books and other tools write in a table, and its counterpart here.
_OTHER_TABLES = {
    "offset": "an offset stands beside the variable: 'theta: q + 0.3', 'd: q + 0.3'",
    "type": _JOINT_TYPES,
    "joint": _JOINT_TYPES,
    "min": _LIMITS,
    "max": _LIMITS,
    "lower": _LIMITS,
    "upper": _LIMITS,
    "θ": "the angle about z is called 'theta'",
    "α": "the twist about x is called 'alpha'",
    "r": "the length along x is called 'a', the one along z 'd'",
}


class Shape:
    """Which sections of a file have the shape that the schema needs.

    A section with a mistake doesn't hide the mistakes of the others: each is read by itself.
    """

    def __init__(self, report: Report) -> None:
        self._document = report.document
        self._wrong: set[Path] = set()
        self._unchecked: set[Path] = set()
        self.file: RobotFile | None = None
        try:
            self.file = RobotFile.model_validate(self._document.plain())
        except ValidationError as error:
            for details in error.errors(include_url=False):
                _report(report, details)
                path = details["loc"]
                self._unchecked.add(path)
                self._wrong.update(path[:end] for end in range(len(path) + 1))

    def section(self, path: Path, model: type[Model]) -> Model | None:
        """The section at a path without its wrong keys, which are reported already.

        A section that the file leaves out has its defaults; None when nothing of it is usable.
        """
        # Below a list that is too long, for one, nothing has been looked at.
        if any(path[:end] in self._unchecked for end in range(len(path) + 1)):
            return None
        value = self._document.plain(path) if self._document.has(str(path[0])) else {}
        if isinstance(value, dict):
            value = {key: inner for key, inner in value.items() if self.right((*path, key))}
        elif not self.right(path):
            return None
        try:
            return model.model_validate(value)
        except ValidationError:  # a key is missing
            return None

    def right(self, path: Path) -> bool:
        """Whether nothing is wrong at and below a path."""
        return path not in self._wrong


def _report(report: Report, details: ErrorDetails) -> None:
    path = details["loc"]
    if details["type"] == "extra_forbidden":
        key = str(path[-1])
        hint = _glued(key, path) or _elsewhere(key, path) or nearest(key, _valid_keys(path))
        report.error_at_key(path, f"unknown key {quoted(key)}{hint}")
    elif details["type"] == "missing":
        report.error(path, f"the key '{path[-1]}' is missing")
    elif details["type"] in {"too_long", "too_short"}:
        report.error(path, length_message(path, details))
    elif details["input"] is None:
        report.error_at_key(path, value_message(details))  # what isn't there can't be pointed at
    else:
        report.error(path, value_message(details))


def _glued(key: str, path: Path) -> str:
    """The end of a message about a key that holds its value, for want of a blank or a colon."""
    found = re.fullmatch(r"(\w+)\s*(:|=|\s)\s*(\S.*)", key)
    if not found or found[1] not in _valid_keys(path):
        return ""
    if found[2] == ":" and "," in key:
        return "; put several keys on one line in braces, with a space after every colon"
    return f": write '{found[1]}: {found[3]}', with a colon and a space"


def _elsewhere(key: str, path: Path) -> str:
    """The end of a message about a key that other tools have, with its counterpart here."""
    in_leg, path = path[0] == LEGS, within_leg(path)
    if path[0] == "joints" and len(path) > 1 and key in _OTHER_TABLES:
        return f"; {_OTHER_TABLES[key]}"
    if path[0] in {"joints", "axes"} and key in _WORDS:
        return "; a joint has only a 'name': say more in a comment, '# elbow'"
    if len(path) == 1 and key in {"joint_limits", "qlim"}:
        return "; limits stand in each joint: 'limits: [-1.5, 1.5]'"
    outside = len(path) > 1 or (in_leg and key not in LegEntry.model_fields)
    if outside and key in RobotFile.model_fields and key not in _WORDS:
        if in_leg:
            return "; it stands on a line of its own as 'legs:' does"
        at_joint = key == "free" and isinstance(path[1], int)
        example = f": 'free: [{int(path[1]) + 1}]'" if at_joint else ""
        return f"; it stands on a line of its own as '{path[0]}:' does{example}"
    return ""


def _valid_keys(path: Path) -> tuple[str, ...]:
    file = LegEntry if path[0] == LEGS and len(path) > 2 else RobotFile
    path = within_leg(path)
    model = file if len(path) == 1 else _MODELS[str(path[0])]
    return tuple(field.alias or name for name, field in model.model_fields.items())

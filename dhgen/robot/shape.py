"""A file's shape against the schema: unknown keys, missing keys, lists of the wrong length."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, TypeVar

from pydantic import BaseModel, ValidationError

from dhgen.robot.arithmetic import nearest
from dhgen.robot.schema import AxisRow, FrameEntry, JointRow, RobotFile, Units
from dhgen.robot.source import quoted
from dhgen.robot.wording import length_message, value_message

if TYPE_CHECKING:
    from collections.abc import Mapping

    from pydantic_core import ErrorDetails

    from dhgen.robot.reader import Path
    from dhgen.robot.report import Report

Model = TypeVar("Model", bound=BaseModel)

_MODELS: Mapping[str, type[BaseModel]] = {
    "joints": JointRow,
    "axes": AxisRow,
    "home": FrameEntry,
    "base": FrameEntry,
    "tool": FrameEntry,
    "units": Units,
}
_WORDS = {"name", "title", "source"}  # who writes them in a joint may not mean the robot's
_KINDS = "a joint slides by 'theta: 0, d: q', and turns by 'theta: q, d: 0'"
_LIMITS = "limits are a list: 'limits: [-1.5, 1.5]'"
# What books and other tools write in a table, and what stands for it here.
_OTHER_TABLES = {
    "offset": "an offset stands beside the variable: 'theta: q + 0.3', 'd: q + 0.3'",
    "type": _KINDS,
    "joint": _KINDS,
    "min": _LIMITS,
    "max": _LIMITS,
    "lower": _LIMITS,
    "upper": _LIMITS,
    "θ": "the angle about z is called 'theta'",
    "α": "the twist about x is called 'alpha'",
    "r": "the length along x is called 'a', the one along z 'd'",
}


class Shape:
    """Which sections of a file have the shape that the schema asks for.

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
    """The end of a message about a key that other tools have, and what stands for it here."""
    if path[0] == "joints" and len(path) > 1 and key in _OTHER_TABLES:
        return f"; {_OTHER_TABLES[key]}"
    if path[0] in {"joints", "axes"} and key in _WORDS:
        return "; joints go by their numbers, from 1: say more in a comment, '# elbow'"
    if len(path) == 1 and key in {"limits", "joint_limits", "qlim"}:
        return "; limits stand in each joint: 'limits: [-1.5, 1.5]'"
    if len(path) > 1 and key in RobotFile.model_fields and key not in _WORDS:
        at_joint = key == "free" and isinstance(path[1], int)
        example = f": 'free: [{int(path[1]) + 1}]'" if at_joint else ""
        return f"; it stands on a line of its own as '{path[0]}:' does{example}"
    return ""


def _valid_keys(path: Path) -> tuple[str, ...]:
    model = RobotFile if len(path) == 1 else _MODELS[str(path[0])]
    return tuple(model.model_fields)

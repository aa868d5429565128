"""What the values of a robot file may be, each checked as it is read."""

from __future__ import annotations

import re
from typing import Annotated

from pydantic import AfterValidator, BeforeValidator, Field, WithJsonSchema

from dhgen.robot.names import why_no_robot_name, why_no_text

ARM_ANGLE = "arm_angle"  # what `free` says instead of joints
TASKS = ("pose", "position", "orientation", "pointing")
COORDINATES = ("x", "y", "z")
SWITCHES = ("true", "True", "TRUE", "false", "False", "FALSE")  # as YAML writes them


class ExpectedError(ValueError):
    """What a value should have been; a reader of the message is told what it is besides."""


def _robot_name(name: str) -> str:
    reason = why_no_robot_name(name)
    if reason:
        raise ValueError(f"the robot can't have this name: {reason}")
    return name


def _one_line(text: str) -> str:
    # Folded and literal blocks of YAML end in a line end, and may hold some.
    line = " ".join(part.strip() for part in text.strip().split("\n"))
    reason = why_no_text(line, 2000)
    if reason:
        raise ValueError(f"this text can't be used: {reason}")
    return line


def _task(value: object) -> object:
    if isinstance(value, list):
        if (
            not value
            or not set(map(str, value)) <= set(COORDINATES)
            or len(set(value)) < len(value)
        ):
            raise ValueError("a list of coordinates holds some of x, y, z, each once")
        return value
    if value not in TASKS:
        raise ExpectedError(f"one of {', '.join(TASKS)}, or a list of some of x, y, z")
    return value


def _joint_number(value: object) -> object:
    if value == ARM_ANGLE:
        raise ValueError(f"it stands without a list: write free: {ARM_ANGLE}")
    if not re.fullmatch(r"-?[0-9]{1,4}", str(value)):
        raise ExpectedError("the number of a joint")
    return value


def _switch(value: object) -> object:
    # pydantic also takes 1, yes and on, which YAML and the schema for editors do not
    if str(value) not in SWITCHES:
        raise ExpectedError("true or false")
    return value


def _free(value: object) -> object:
    if value == ARM_ANGLE:
        return []
    if not isinstance(value, list):
        raise ExpectedError(f"a list of joints, or {ARM_ANGLE}")
    return value


def _end(value: object) -> object:
    # What to write in its place depends on the joint, which is read later.
    return "null" if value is None else value


_CELL = {"type": ["number", "string"]}
Cell = Annotated[str, WithJsonSchema(_CELL)]
JointNumber = Annotated[int, BeforeValidator(_joint_number)]
Switch = Annotated[bool, BeforeValidator(_switch)]
Free = Annotated[
    list[JointNumber],
    BeforeValidator(_free),
    WithJsonSchema(
        {"anyOf": [{"enum": [ARM_ANGLE]}, {"items": {"type": "integer"}, "type": "array"}]}
    ),
]
RobotName = Annotated[str, AfterValidator(_robot_name)]
Text = Annotated[str, AfterValidator(_one_line)]
Triple = Annotated[list[Cell], Field(min_length=3, max_length=3)]
Quadruple = Annotated[list[Cell], Field(min_length=4, max_length=4)]
End = Annotated[str, BeforeValidator(_end), WithJsonSchema(_CELL)]
Limits = Annotated[list[End], Field(min_length=2, max_length=2)]
Matrix = Annotated[list[Quadruple], Field(min_length=4, max_length=4)]
Task = Annotated[
    str | list[str],
    WithJsonSchema(
        {
            "anyOf": [
                {"enum": list(TASKS)},
                {
                    "type": "array",
                    "items": {"enum": list(COORDINATES)},
                    "minItems": 1,
                    "uniqueItems": True,
                },
            ]
        }
    ),
    BeforeValidator(_task),
]

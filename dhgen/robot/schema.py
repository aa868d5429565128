"""The shape of a robot file: its keys, what each may hold, and the same as a JSON Schema."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    WithJsonSchema,
    model_validator,
)
from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue

from dhgen.robot.names import (
    JOINT_NAME,
    MAX_ROBOT_NAME,
    LengthUnit,
    why_no_joint_name,
    why_no_robot_name,
    why_no_text,
)
from dhgen.robot.task import ANGLES, ARM_ANGLE, COORDINATES, TaskKind

if TYPE_CHECKING:
    from pydantic_core.core_schema import WithDefaultSchema


TASKS = tuple(kind.value for kind in TaskKind if kind is not TaskKind.LIST)
LISTED = (*COORDINATES, "roll", "pitch", "yaw")
SWITCHES = ("true", "True", "TRUE", "false", "False", "FALSE")  # as YAML writes them


class ExpectedError(ValueError):
    """What a value should have been; the message adds what it is."""


def _robot_name(name: str) -> str:
    reason = why_no_robot_name(name)
    if reason:
        raise ValueError(f"the robot can't have this name: {reason}")
    return name


def _joint_name(name: str) -> str:
    reason = why_no_joint_name(name)
    if reason:
        raise ValueError(f"a joint can't have this name: {reason}")
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
        names = sorted(map(str, value), key=(*LISTED, *map(str, value)).index)
        angles = tuple(name for name in names if name not in COORDINATES)
        if not value or angles not in ANGLES or len(set(names)) < len(names):
            raise ValueError(
                "a list holds some of x, y, z, and yaw, or pitch, or roll and pitch, each once"
            )
        return value
    if value not in TASKS:
        raise ExpectedError(f"one of {', '.join(TASKS)}, or a list such as [x, y, z, yaw]")
    return value


def _joint_number(value: object) -> object:
    if value == ARM_ANGLE:
        raise ValueError(f"it stands without a list: write free: {ARM_ANGLE}")
    if not re.fullmatch(r"-?[0-9]{1,4}", str(value)):
        raise ExpectedError("the number of a joint")
    return value


def _step_number(value: object) -> object:
    if not re.fullmatch(r"[1-9][0-9]{0,3}", str(value)):
        raise ExpectedError("the number of an equation in `dhgen explain --alternatives`")
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
StepNumber = Annotated[
    int, BeforeValidator(_step_number), WithJsonSchema({"type": "integer", "minimum": 1})
]
Switch = Annotated[bool, BeforeValidator(_switch)]
Free = Annotated[
    list[JointNumber],
    BeforeValidator(_free),
    WithJsonSchema(
        {"anyOf": [{"enum": [ARM_ANGLE]}, {"items": {"type": "integer"}, "type": "array"}]}
    ),
]
RobotName = Annotated[str, AfterValidator(_robot_name)]
JointName = Annotated[
    str,
    AfterValidator(_joint_name),
    Field(
        default="",
        description="What the joint is called elsewhere, as in a URDF; all joints have a name, or "
        "none has.",
        json_schema_extra={"pattern": f"^{JOINT_NAME}$"},
    ),
]
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
                    "items": {"enum": list(LISTED)},
                    "minItems": 1,
                    "uniqueItems": True,
                },
            ]
        }
    ),
    BeforeValidator(_task),
]


MAX_JOINTS = 64
MAX_LEGS = 12
MAX_PARAMETERS = 128
FRAME_FORM = "keys with values, e.g. {xyz: [0, 0, 0.1]}, or a 4x4 matrix"


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


def _or_plain_matrix(schema: dict[str, Any]) -> None:
    """A frame may also be the bare matrix."""
    matrix = dict(schema["properties"]["matrix"])
    frame = dict(schema)
    schema.clear()
    schema["anyOf"] = [frame, matrix]


class FrameEntry(_Strict):
    """A constant frame: a translation with at most one way of giving the rotation, or a matrix."""

    model_config = ConfigDict(json_schema_extra=_or_plain_matrix)

    xyz: Triple = Field(default=[], description="Origin: x, y, z [length].")
    rpy: Triple = Field(
        default=[],
        description="Roll, pitch, yaw [angle] about fixed axes, as in URDF: R = Rz(yaw) Ry(pitch) "
        "Rx(roll).",
    )
    quaternion_xyzw: Quadruple = Field(
        default=[], description="Rotation as a quaternion, scalar last."
    )
    quaternion_wxyz: Quadruple = Field(
        default=[], description="Rotation as a quaternion, scalar first."
    )
    matrix: Matrix = Field(
        default=[
            ["1", "0", "0", "0"],
            ["0", "1", "0", "0"],
            ["0", "0", "1", "0"],
            ["0", "0", "0", "1"],
        ],
        description="Homogeneous 4x4 matrix, row by row; it replaces all other keys.",
    )

    @model_validator(mode="before")
    @classmethod
    def _plain_matrix(cls, value: object) -> object:
        if isinstance(value, list) and not all(isinstance(row, list) for row in value):
            raise ExpectedError(FRAME_FORM)
        return {"matrix": value} if isinstance(value, list) else value


class JointRow(_Strict):
    """A row of a Denavit-Hartenberg table; theta or d holds q, or the variables of other rows."""

    theta: Cell = Field(default="0", description="Joint angle [angle]; q in it: a revolute joint.")
    d: Cell = Field(default="0", description="Joint offset [length]; q in it: a prismatic joint.")
    a: Cell = Field(default="0", description="Link length [length].")
    alpha: Cell = Field(default="0", description="Twist [angle].")
    limits: Limits = Field(
        default=[], description="Lowest and highest q [angle or length, as q is]."
    )
    name: JointName


class AxisRow(_Strict):
    """A joint by its axis in the reference position (q = 0), in the base frame."""

    type: Literal["revolute", "prismatic"] = Field(description="How the joint moves.")
    direction: Triple = Field(description="Direction of the axis; any length but 0.")
    point: Triple = Field(
        default=[],
        description="A point of the axis [length]; a prismatic joint needs none.",
    )
    limits: Limits = Field(
        default=[], description="Lowest and highest q [angle or length, as q is]."
    )
    name: JointName


class LegEntry(_Strict):
    """A leg of a parallel robot: a serial chain from the base to a part of the platform."""

    base: FrameEntry = Field(
        default=FrameEntry(), description="Place of the leg on the base: where its table begins."
    )
    joints: list[JointRow] = Field(
        default=[],
        min_length=1,
        max_length=MAX_JOINTS,
        description="The leg's table, from the base to the platform.",
    )
    axes: list[AxisRow] = Field(
        default=[],
        min_length=1,
        max_length=MAX_JOINTS,
        description="Instead of joints: the leg's axes in the reference position, in its own base.",
    )
    home: FrameEntry = Field(
        default=FrameEntry(),
        description="With axes: pose of the leg's last frame in the reference position.",
    )
    actuated: list[JointNumber] = Field(
        min_length=1, description="The leg's joints, from 1, that are driven; others are passive."
    )
    point: Triple = Field(
        default=[],
        description="The point of the platform that the leg carries, in the platform's frame.",
    )
    frame: FrameEntry = Field(
        default=FrameEntry(),
        description="Instead of a point: the frame of the platform that the leg's last link is.",
    )
    turned: list[Cell] = Field(
        default=[],
        min_length=1,
        max_length=MAX_LEGS,
        description="Several legs that are alike: each is this one turned about z by one of these "
        "angles, on the base and on the platform.",
    )


class SumEntry(_Strict):
    """Limits of a sum of joints' variables, by their numbers."""

    of: Cell = Field(description="The sum, e.g. q2 + q3 or q2 - 1/2*q3.")
    least: End = Field(alias="from", description="Its lowest value [angle or length, as it is].")
    most: End = Field(alias="to", description="Its highest value.")


class Units(_Strict):
    """The units of the file. Lengths are not converted: the generated code has the same unit."""

    length: LengthUnit = Field(default="m", description="What lengths are given in.")
    angle: Literal["rad", "deg"] = Field(
        default="rad",
        description="What angles are given in, where neither pi nor deg occurs. The argument of "
        "sin and cos is always in radians.",
    )


class RobotFile(_Strict):
    """A robot for dhgen."""

    name: RobotName = Field(
        description="Identifier: names the generated files and the C functions.",
        json_schema_extra={"pattern": "^[A-Za-z][A-Za-z0-9_]*$", "maxLength": MAX_ROBOT_NAME},
    )
    title: Text = Field(default="", description="What a person calls the robot.")
    source: Text = Field(default="", description="Where the numbers come from.")
    convention: Literal["standard", "modified"] = Field(
        default="standard",
        description="standard: Rz(theta) Tz(d) Tx(a) Rx(alpha); modified: Rx(alpha) Tx(a) "
        "Rz(theta) Tz(d).",
    )
    parameters: dict[str, Cell] = Field(
        default={},
        max_length=MAX_PARAMETERS,
        description="Named numbers, e.g. link lengths; each may use those before it.",
    )
    joints: list[JointRow] = Field(
        default=[],
        min_length=1,
        max_length=MAX_JOINTS,
        description="The Denavit-Hartenberg table, from the base to the tool.",
    )
    axes: list[AxisRow] = Field(
        default=[],
        min_length=1,
        max_length=MAX_JOINTS,
        description="Instead of joints: the axes in the reference position.",
    )
    legs: list[LegEntry] = Field(
        default=[],
        min_length=1,
        max_length=MAX_LEGS,
        description="Instead of joints: the legs of a parallel robot, which carry its platform.",
    )
    home: FrameEntry = Field(
        default=FrameEntry(),
        description="With axes: pose of the last frame in the reference position.",
    )
    base: FrameEntry = Field(
        default=FrameEntry(), description="Pose of the arm in BASE: Z in Z T E."
    )
    tool: FrameEntry = Field(
        default=FrameEntry(), description="Pose of TOOL in the last frame: E in Z T E."
    )
    task: Task = Field(
        default="pose",
        description="What of the pose the caller means: pose, position, orientation, pointing "
        "(position and the tool's z axis), direction (the tool's z axis), or a list of some of x, "
        "y, z and of yaw, or pitch, or roll and pitch.",
    )
    limits: list[SumEntry] = Field(
        default=[],
        max_length=MAX_JOINTS,
        description="Limits of sums of joints' variables, e.g. {of: q2 + q3, from: -80 deg, to: "
        "150 deg}; those of single joints stand in their rows.",
    )
    free: Free = Field(
        default=[],
        description="Joints, from 1, whose value the caller gives, in ascending order; or arm_angle"
        ", for an arm of seven joints whose axes 1, 2, 3 meet and 5, 6, 7 meet.",
    )
    steps: list[StepNumber] = Field(
        default=[],
        description="For the first steps of the derivation, the numbers of the equations to take, "
        "as `dhgen explain --alternatives` lists them; the compiler chooses the others.",
    )
    numerical: Switch = Field(
        default=False,
        description="Whether the numerical solver may take the arm if nothing else solves it, as "
        "with --numerical.",
    )
    units: Units = Field(default=Units(), description="Units of lengths and angles.")
    float32: Switch = Field(
        default=False,
        description="Whether the compiler also writes C in single precision, NAME_f32.c and .h, "
        "for small controllers. For arms in closed form only.",
    )
    plain: Switch = Field(
        default=False,
        description="Whether the solvers do without their fast path for regular poses: shorter "
        "files, the same answers, more time for each pose.",
    )
    calibration: Switch = Field(
        default=False,
        description="Whether the compiler also writes solvers whose table is an argument, "
        "NAME_fleet.py, .c and .h, for arms with calibrations of their own. For tables of six "
        "turning joints with a closed form only.",
    )


class _EditorSchema(GenerateJsonSchema):
    """Without titles, which only repeat the keys, and defaults, which only mean "left out"."""

    def field_title_should_be_set(self, schema: object) -> bool:  # noqa: ARG002
        return False

    def default_schema(self, schema: WithDefaultSchema) -> JsonSchemaValue:
        described = super().default_schema(schema)
        if not isinstance(described.get("default"), str):
            described.pop("default", None)
        return described


def schema_text() -> str:
    """The JSON Schema of robot files, as it is committed for editors."""
    schema = RobotFile.model_json_schema(schema_generator=_EditorSchema)
    schema["$schema"] = _EditorSchema.schema_dialect
    schema["oneOf"] = [{"required": [key]} for key in ("joints", "axes", "legs")]
    return json.dumps(schema, indent=2, sort_keys=True) + "\n"


def main(arguments: list[str]) -> None:
    """Write the schema to the given file, robots/robot.schema.json without one."""
    target = Path(arguments[0] if arguments else "robots/robot.schema.json")
    target.write_text(schema_text(), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])

"""The shape of a robot file: its keys, and what each may hold."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field, model_validator

from dhgen.robot.names import MAX_ROBOT_NAME, LengthUnit
from dhgen.robot.values import (
    Cell,
    ExpectedError,
    Free,
    Limits,
    Matrix,
    Quadruple,
    RobotName,
    Switch,
    Task,
    Text,
    Triple,
)

MAX_JOINTS = 64
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
    """A row of a Denavit-Hartenberg table; exactly one of theta and d holds the variable q."""

    theta: Cell = Field(default="0", description="Joint angle [angle]; q in it: a revolute joint.")
    d: Cell = Field(default="0", description="Joint offset [length]; q in it: a prismatic joint.")
    a: Cell = Field(default="0", description="Link length [length].")
    alpha: Cell = Field(default="0", description="Twist [angle].")
    limits: Limits = Field(
        default=[], description="Lowest and highest q [angle or length, as q is]."
    )


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
        "(position and the tool's z axis), or a list of some of x, y, z.",
    )
    free: Free = Field(
        default=[],
        description="Joints, from 1, whose value the caller gives, in ascending order; or arm_angle"
        ", for an arm of seven joints whose axes 1, 2, 3 meet and 5, 6, 7 meet.",
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

"""The robot file of one arm: that of its kind, with what was measured in its place."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import PurePath
from typing import TYPE_CHECKING

from dhgen.calibration.chain import calibrated_joints
from dhgen.calibration.read import ANGLES, CELLS, PLACES
from dhgen.descriptions.compare import difference
from dhgen.descriptions.convert import BUG, robot_file_text
from dhgen.descriptions.lines import arm_of
from dhgen.descriptions.misses import misses
from dhgen.descriptions.snap import LEAST, snap
from dhgen.descriptions.write import Heading, plain
from dhgen.errors import VerificationError, refused
from dhgen.kinematics.build import build_chain
from dhgen.robot.load import load_text
from dhgen.robot.names import YAML_WORDS, why_no_robot_name
from dhgen.robot.task import ARM_ANGLE, TaskKind

if TYPE_CHECKING:
    from dhgen.calibration.read import Calibration
    from dhgen.descriptions.compare import Difference
    from dhgen.robot.robot import Robot

FAR = 0.03  # arm sizes, and rad: a calibration that moves the tool by more is of another arm
TURN = 2.0 * math.pi  # rad: no calibration has a larger angle, most in degrees have
FARTHEST = 30.0  # arm sizes: no arm is so long, most in mm are


@dataclass(frozen=True, slots=True)
class Calibrated:
    """A robot file of a calibrated arm.

    Attributes:
        text: The file.
        robot: The same, read.
        moved: How far its tool is from that of the nominal arm at most.
        notes: By how much which structure is missed.
    """

    text: str
    robot: Robot
    moved: Difference
    notes: tuple[str, ...]


def calibrate(
    robot: Robot, calibration: Calibration, *, name: str = "", as_axes: bool = False
) -> Calibrated:
    """The robot file of an arm with its calibration.

    Args:
        robot: The arm of the data sheet.
        calibration: What was measured.
        name: What to call the arm; by default, and where it can't be called so, NAME_calibrated.
        as_axes: Whether the file is to hold axes in any case, not a table where one can be read.

    Raises:
        RobotFileError: They don't belong together.
    """
    if robot.task.kind is not TaskKind.POSE:
        wanted = f"{robot.name} is asked for {robot.task.kind.value}"
        raise refused(calibration.file, f"{wanted}: calibrations are for arms with `task: pose`")
    if robot.is_coupled:
        reason = "calibrations are for arms whose joints have a drive and limits each"
        raise refused(
            calibration.file, f"drives of {robot.name} are coupled, or sums limited: {reason}"
        )
    joints = calibrated_joints(robot, calibration)
    snapped = snap(joints, LEAST, LEAST)
    arm = arm_of(snapped.joints, LEAST, LEAST)
    moved = difference(joints, robot, arm.size)
    if moved.relative > FAR:
        reason = f"this is the calibration of another arm: by it the tool of {robot.name} is up to "
        far = f"{moved.moved:.2g} {robot.length_unit} and {moved.turned:.2g} rad away"
        raise refused(calibration.file, reason + far + _unit_hint(robot, calibration))
    why_not = _why_no_name(name, robot)
    heading = Heading(
        name=f"{robot.name}_calibrated" if why_not else name,
        title=f"{robot.title}, calibrated",
        source=f"{robot.name} with {_called(calibration)}",
        free=ARM_ANGLE if robot.arm_angle else robot.free,
        length_unit=robot.length_unit,
    )
    text, notes = robot_file_text(heading, arm, as_axes=as_axes)
    made = load_text(text, f"{heading.name}.yaml")
    if difference(joints, made, arm.size).relative > BUG * LEAST:
        raise VerificationError(f"the robot file made of {calibration.file} is another arm")
    if name and why_not:
        notes.insert(0, f"the arm is called {heading.name}, not {plain(name)}: {why_not}")
    structure = misses(arm, robot.length_unit)
    return Calibrated(text, made, moved, (*([structure] if structure else []), *notes))


def _why_no_name(name: str, robot: Robot) -> str | None:
    """Why the calibrated arm can't be called so, or None."""
    if name == robot.name:
        return "that is the arm of the data sheet, whose files it would write over"
    if name.casefold() in YAML_WORDS:
        return "it is a word of YAML"
    return why_no_robot_name(name)


def _unit_hint(robot: Robot, calibration: Calibration) -> str:
    """Which numbers look as if they were in degrees, or in a smaller unit of length."""
    names = CELLS if calibration.is_deltas else PLACES
    numbers = [pair for row in calibration.rows for pair in zip(names, row, strict=True)]
    angle = max(abs(number) for name, number in numbers if name in ANGLES)
    length = max(abs(number) for name, number in numbers if name not in ANGLES)
    size, unit = build_chain(robot).size, robot.length_unit
    hint = ""
    if angle > TURN:
        hint += f"; an angle of {angle:g} looks like degrees: they are in rad, or written with deg"
    if length > FARTHEST * size:
        other_unit = f"on an arm of {size:.2g} {unit} looks like another unit: they are in {unit}"
        hint += f"; a length of {length:g} {other_unit}"
    return hint


def _called(calibration: Calibration) -> str:
    """How the source line calls a calibration."""
    file = plain(PurePath(calibration.file).name)
    return f"the calibration {plain(calibration.words)} of {file}" if calibration.words else file

"""The robot file of one arm: that of its kind, with what was measured in its place."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import PurePath
from typing import TYPE_CHECKING

from dhgen.calibration.chain import calibrated_joints
from dhgen.descriptions.compare import difference
from dhgen.descriptions.convert import BUG, robot_file_text
from dhgen.descriptions.lines import arm_of
from dhgen.descriptions.misses import misses
from dhgen.descriptions.snap import LEAST, snap
from dhgen.descriptions.write import Heading, plain
from dhgen.errors import Diagnostic, RobotFileError, VerificationError
from dhgen.robot.load import load_text
from dhgen.robot.task import ARM_ANGLE, TaskKind

if TYPE_CHECKING:
    from dhgen.calibration.read import Calibration
    from dhgen.descriptions.compare import Difference
    from dhgen.robot.robot import Robot

FAR = 0.03  # arm sizes, and rad: a calibration that moves the tool by more is of another arm


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


def calibrate(robot: Robot, calibration: Calibration, *, as_axes: bool = False) -> Calibrated:
    """The robot file of an arm with its calibration.

    Args:
        robot: The arm of the data sheet.
        calibration: What was measured.
        as_axes: Whether the file is to hold axes in any case, not a table where one can be read.

    Raises:
        RobotFileError: They don't belong together.
    """
    if robot.task.kind is not TaskKind.POSE:
        wanted = f"{robot.name} is asked for {robot.task.kind.value}"
        raise _refusal(calibration, f"{wanted}: calibrations are for arms with `task: pose`")
    if robot.is_coupled:
        told = "calibrations are for arms whose joints have a drive and limits each"
        raise _refusal(calibration, f"drives of {robot.name} are coupled, or sums limited: {told}")
    joints = calibrated_joints(robot, calibration)
    snapped = snap(joints, LEAST, LEAST)
    arm = arm_of(snapped.joints, LEAST, LEAST)
    moved = difference(joints, robot, arm.size)
    if moved.relative > FAR:
        told = f"this is the calibration of another arm: by it the tool of {robot.name} is up to "
        far = f"{moved.moved:.2g} {robot.length_unit} and {moved.turned:.2g} rad away"
        raise _refusal(calibration, told + far)
    heading = Heading(
        name=f"{robot.name}_calibrated",
        title=f"{robot.title}, calibrated",
        source=f"{robot.name} with {_called(calibration)}",
        free=ARM_ANGLE if robot.arm_angle else robot.free,
        length_unit=robot.length_unit,
    )
    text, notes = robot_file_text(heading, arm, as_axes=as_axes)
    made = load_text(text, f"{heading.name}.yaml")
    if difference(joints, made, arm.size).relative > BUG * LEAST:
        raise VerificationError(f"the robot file made of {calibration.file} is another arm")
    structure = misses(arm)
    return Calibrated(text, made, moved, (*([structure] if structure else []), *notes))


def _called(calibration: Calibration) -> str:
    """How the source line calls a calibration."""
    file = plain(PurePath(calibration.file).name)
    return f"the calibration {plain(calibration.words)} of {file}" if calibration.words else file


def _refusal(calibration: Calibration, message: str) -> RobotFileError:
    return RobotFileError((Diagnostic(calibration.file, 0, 0, message),))

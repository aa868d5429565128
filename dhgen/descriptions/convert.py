"""The front door: a robot description in, a robot file out, with notes on it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import PurePath
from typing import TYPE_CHECKING

from dhgen.descriptions.chain import choose_chain
from dhgen.descriptions.compare import difference
from dhgen.descriptions.free_joints import free_joints
from dhgen.descriptions.lines import arm_of
from dhgen.descriptions.locked import locked_notes
from dhgen.descriptions.mimic import demand_followed, with_followers_limits
from dhgen.descriptions.misses import misses_note
from dhgen.descriptions.snap import DEFAULT, LEAST, NEGLIGIBLE, snap
from dhgen.descriptions.table import cheapest_table, farthest_offset
from dhgen.descriptions.unread import unread_notes
from dhgen.descriptions.write import (
    FEW_TURNS,
    Heading,
    axes_text,
    ends_once,
    identifier,
    looks_like_degrees,
    plain,
    table_text,
)
from dhgen.errors import RobotFileError, VerificationError, refused
from dhgen.robot.load import load_text
from dhgen.robot.names import why_no_joint_name
from dhgen.robot.source import quoted
from dhgen.robot.task import ARM_ANGLE_JOINTS

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.descriptions.chain import ArmChain
    from dhgen.descriptions.compare import Difference
    from dhgen.descriptions.lines import Arm
    from dhgen.descriptions.model import Description, Joint
    from dhgen.descriptions.snap import Snapped
    from dhgen.descriptions.wishes import Wishes
    from dhgen.robot.robot import Robot

FAR = 10.0  # arm sizes: where axes are nearly parallel their common normal is no place for a frame
BUG = 100.0  # tolerances that a model may be off, with all that is snapped
SHOWN = 6
SHORTEST, LONGEST = 0.02, 50.0  # m: arms beyond are in another unit


@dataclass(frozen=True, slots=True)
class Import:
    """A robot file made of a description.

    Attributes:
        text: The robot file.
        robot: The same, read.
        chain: The joints that it is of.
        difference: Between both models.
        notes: What was chosen, snapped, left out or is doubtful.
    """

    text: str
    robot: Robot
    chain: ArmChain
    difference: Difference
    notes: tuple[str, ...]


def convert(description: Description, wishes: Wishes) -> Import:
    """The robot file of a description.

    Raises:
        RobotFileError: There is no such arm in it.
    """
    chain = choose_chain(description, wishes.base, wishes.tip)
    if wishes.free is not None:
        _demand_joints(description, chain, wishes.free)
    near, negligible = (
        (DEFAULT, NEGLIGIBLE) if wishes.snap is None else (max(wishes.snap, LEAST),) * 2
    )
    joints, narrowed = with_followers_limits(chain.joints)
    snapped = snap(joints, near, negligible)
    arm = arm_of(snapped.joints, near, negligible)
    try:
        demand_followed(description, chain.joints, arm.axes)
    except RobotFileError:
        if not chain.driven_end:
            raise
        return convert(description, replace(wishes, tip=chain.driven_end))
    heading = _heading(description, chain, free_joints(arm) if wishes.free is None else wishes.free)
    text, notes = robot_file_text(heading, arm, as_axes=wishes.as_axes)
    robot = load_text(text, f"{heading.name}.yaml")
    off = difference(chain.joints, robot, arm.size)
    if off.relative > BUG * near:
        message = f"the robot file made of {description.source.file} is another arm: the tool is "
        raise VerificationError(message + f"{off.moved:.2g} away. This is a bug in dhgen")
    remarks = [
        *_reading_notes(description, chain),
        *_limit_notes(chain.actuated),
        *narrowed,
        *_unit_notes(chain, arm),
        *([] if off.is_rounding else [_snap_note(snapped, off, near)]),
        *filter(None, [misses_note(arm)]),
        *notes,
        *_name_notes(arm),
    ]
    return Import(text, robot, chain, off, tuple(remarks))


def _reading_notes(description: Description, chain: ArmChain) -> list[str]:
    """Notes on what was chosen, not read, or taken as fixed."""
    locked = locked_notes(description.joints_to(chain.tip))
    return [*description.notes, *chain.notes, *unread_notes(chain.joints), *locked]


def _demand_joints(description: Description, chain: ArmChain, free: tuple[int, ...] | str) -> None:
    """Stops where the arm has no such joints, or not as many as an arm angle stands for."""
    count = len(chain.actuated)
    if isinstance(free, str):
        if count != ARM_ANGLE_JOINTS:
            message = f"free: {free} is for arms of {ARM_ANGLE_JOINTS} joints; this one has {count}"
            raise refused(description.source.file, message)
        return
    if list(free) == sorted(set(free)) and all(1 <= number <= count for number in free):
        return
    listed = ", ".join(map(str, free))
    where = f"the arm from {plain(chain.base)} to {plain(chain.tip)} has joints 1 to {count}"
    message = f"joints {listed} can't be free: {where}, and each is named once, in ascending order"
    raise refused(description.source.file, message)


def _heading(description: Description, chain: ArmChain, free: tuple[int, ...] | str) -> Heading:
    file = PurePath(description.source.file.removesuffix(" (expanded)")).name
    links = f"poses of {plain(chain.tip)} in {plain(chain.base)}"
    return Heading(
        name=identifier(description.name),
        title=plain(description.name),
        source=f"{description.kind} {plain(file)}, {links}",
        free=free,
    )


def robot_file_text(heading: Heading, arm: Arm, *, as_axes: bool) -> tuple[str, list[str]]:
    """A robot file, and notes on how it is written."""
    if as_axes:
        _demand_drives(heading, arm)
        return axes_text(heading, arm), []
    table = cheapest_table(arm)
    if farthest_offset(table) > FAR * arm.size:
        _demand_drives(heading, arm)
        why = "axes that are nearly parallel have their common normal far away: the file holds "
        return axes_text(heading, arm), [why + "axes, not a table"]
    return table_text(heading, arm, table), []


def _demand_drives(heading: Heading, arm: Arm) -> None:
    """Refuses joints that follow others where axes are written, which hold no such thing."""
    if any(axis.shares for axis in arm.axes):
        message = "joints follow others (mimic), which a table can say, and axes can't"
        raise refused(heading.source, message)


def _snap_note(snapped: Snapped, off: Difference, near: float) -> str:
    """What was taken as exact, and what that changes."""
    snaps = []
    if snapped.angles:
        snaps.append(f"angles {_some(snapped.angles)} as multiples of 15 deg")
    if snapped.lengths:
        snaps.append(f"lengths {_some(snapped.lengths)} as 0")
    what = (
        " and ".join(snaps)
        or "what is nearly parallel, square, meeting or of one length as exactly so"
    )
    return (
        f"taken as exact, being nearer than --snap {near:g}: {what}; the tool moves by at most "
        f"{1e3 * off.moved:.2g} mm and turns by at most {off.turned:.2g} rad"
    )


def _some(values: Iterable[float]) -> str:
    shown = list(dict.fromkeys(f"{value:.13g}" for value in values))
    return ", ".join(shown[:SHOWN]) + (", ..." if len(shown) > SHOWN else "")


def _unit_notes(chain: ArmChain, arm: Arm) -> list[str]:
    notes = []
    if turned := [each.name for each in chain.joints if max(map(abs, each.rpy)) > FEW_TURNS]:
        shown = ", ".join(turned[:SHOWN]) + (", ..." if len(turned) > SHOWN else "")
        notes.append(f"the rpy of {shown} are many turns: they are in rad, not in degrees")
    if not SHORTEST < arm.size < LONGEST:
        notes.append(f"the arm is {arm.size:g} m long: lengths of a description are in m")
    if wide := [axis.joint.name for axis in arm.axes if looks_like_degrees(axis)]:
        notes.append(f"the limits of {', '.join(wide)} are many turns: they are in rad")
    return notes


def _name_notes(arm: Arm) -> list[str]:
    """A note on names that the robot file has as comments, since it can't hold one of them."""
    whys = {axis.joint.name: why_no_joint_name(axis.joint.name) for axis in arm.axes}
    refused_names = [(name, why) for name, why in whys.items() if why is not None]
    if not refused_names:
        return []
    (name, why), more = refused_names[0], len(refused_names) - 1
    others = f"; nor can it hold {more} more" if more else ""
    numbered = f"joints are called joint1 to joint{len(arm.axes)}, and their names are comments"
    return [f"{numbered}: a robot file can't hold {quoted(name)}, {why}{others}"]


def _limit_notes(joints: tuple[Joint, ...]) -> list[str]:
    bounded = [joint for joint in joints if joint.motion.value != "continuous"]
    missing = [joint.name for joint in bounded if joint.limits is None]
    zero = [joint.name for joint in bounded if joint.limits and not any(joint.limits)]
    still = [j.name for j in bounded if j.limits and j.limits[0] == j.limits[1] != 0.0]
    swapped = [j.name for j in bounded if j.limits and j.limits[0] > j.limits[1]]
    once = [joint for joint in bounded if ends_once(joint)]
    notes = []
    if turning := [joint.name for joint in once if joint.motion.turns]:
        shown = ", ".join(turning)
        notes.append(f"limits stop {shown} on one side only: the other end is written as 10 turns")
    if sliding := [joint.name for joint in once if not joint.motion.turns]:
        notes.append(f"limits stop {', '.join(sliding)} on one side only: written without")
    if missing:
        notes.append(f"no limits are given for {', '.join(missing)}: written without")
    if zero:
        notes.append(
            f"lower and upper limit are 0 for {', '.join(zero)}, which exporters write for none: "
            'written without; what is locked there has type="fixed"'
        )
    if still:
        notes.append(f"lower and upper limit are one for {', '.join(still)}: written without")
    if swapped:
        notes.append(f"the limits of {', '.join(swapped)} are in the wrong order: exchanged")
    return notes

"""Joints that follow others (mimic): which of them a robot file can hold, as coupled or passive."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import inf
from typing import TYPE_CHECKING

from dhgen.descriptions.model import Motion
from dhgen.errors import RobotFileError
from dhgen.robot.couplings import LARGEST_WHOLE
from dhgen.robot.passive import MOST_TIMES
from dhgen.robot.source import quoted

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.descriptions.lines import Axis
    from dhgen.descriptions.model import Description, Joint


def demand_followed(
    description: Description, joints: Sequence[Joint], axes: Sequence[Axis]
) -> None:
    """Refuses joints that follow what they can't.

    Args:
        description: The robot, for the places of mistakes.
        joints: From base to tip.
        axes: Those of the table; a joint that follows another one about a driven joint's axis has
            none of its own.

    Raises:
        RobotFileError: There are some: all of them, each with the reason.
    """
    places = {axis.joint.name: place for place, axis in enumerate(axes)}
    mistakes = []
    begun = False  # whether a drive of the arm's own moves what comes now
    for joint in joints:
        begun |= joint.is_driven
        if joint.mimics is None or not joint.motion.is_actuated:
            continue
        other = joint.mimics.joint
        reason = _why_not(joint, axes, places)
        if reason:
            message = f"{quoted(joint.name)} follows {quoted(other)} (mimic), {reason}: "
            before, behind = f"end before it, --tip {joint.parent}", f"--base {joint.child}"
            message += before if begun else f"start behind it, {behind}"
            mistakes.append(description.source.point(joint.place, message))
    if mistakes:
        raise RobotFileError(tuple(mistakes))


def _why_not(joint: Joint, axes: Sequence[Axis], places: dict[str, int]) -> str:
    """Why a joint can't follow another one; empty where it can."""
    assert joint.mimics is not None
    if not joint.mimics.is_linear:
        return "by higher powers, which makes equations transcendental"
    other, factor = places.get(joint.mimics.joint), abs(joint.mimics.multiplier)
    own = places.get(joint.name)
    if own is not None:  # joints on one line are one row
        factor = abs(axes[own].totals.get(joint.mimics.joint, 0.0))
    if other is None or not axes[other].joint.is_driven:
        return "which is no joint of this arm with a drive of its own"
    turns = joint.motion.turns
    same_kind = turns == axes[other].turns
    if own is None:  # it adds to what a drive does
        too_fine = Fraction(str(factor)).limit_denominator() != Fraction(str(factor))
        return "by no ratio of whole numbers" if same_kind and turns and too_fine else ""
    if not same_kind:
        return "an angle by a length or the other way round, which makes equations transcendental"
    if own < other:
        return "which comes behind it"
    if not factor:
        return "and with those on its line it stands still"
    if turns and factor != 1.0:
        return f"{factor:g} times, which makes the equations of another degree"
    if not factor.is_integer() or not 0.0 < factor <= MOST_TIMES:
        return f"{factor:g} times: a stage of a telescope follows another a whole number of times"
    return ""


def with_followers_limits(joints: Sequence[Joint]) -> tuple[tuple[Joint, ...], list[str]]:
    """The joints, drives inside the limits of what follows them too, and notes where that is less.

    A joint that follows another one has no variable whose limits a file could hold, but what it may
    do is what its drive may do, times a factor.

    Args:
        joints: From base to tip.
    """
    limits = {joint.name: _ends(joint) for joint in joints if joint.is_driven}
    narrowed: dict[str, list[str]] = {}
    notes = []
    for joint in joints:
        mimics = joint.mimics
        if mimics is None or mimics.joint not in limits or not mimics.multiplier:
            continue
        ends = sorted((end - mimics.offset) / mimics.multiplier for end in _ends(joint))
        low, high = limits[mimics.joint]
        least, most = max(low, ends[0]), min(high, ends[1])
        if least >= most:
            notes.append(
                f"the limits of {joint.name} exclude those of {mimics.joint}, which it follows "
                "(mimic): left out"
            )
        elif (least, most) != (low, high):
            limits[mimics.joint] = least, most
            narrowed.setdefault(mimics.joint, []).append(joint.name)
    inside = tuple(
        replace(joint, limits=limits[joint.name]) if joint.name in narrowed else joint
        for joint in joints
    )
    notes += [
        f"the limits of {name} are narrower than its own: {' and '.join(followers)} "
        f"follow{'s' * (len(followers) == 1)} it (mimic)"
        for name, followers in narrowed.items()
    ]
    return inside, notes


def _ends(joint: Joint) -> tuple[float, float]:
    """Limits as they count, endless without any."""
    low, high = sorted(joint.limits or (0.0, 0.0))
    is_bounded = low < high and joint.motion is not Motion.CONTINUOUS
    return (low, high) if is_bounded else (-inf, inf)


def share_text(factor: float, row: int) -> str:
    """A multiple of a variable as a cell has it, without its sign: q2, 3/2*q2."""
    ratio = Fraction(str(abs(factor))).limit_denominator(LARGEST_WHOLE)
    times = (
        str(ratio.numerator) if ratio.denominator == 1 else f"{ratio.numerator}/{ratio.denominator}"
    )
    return f"q{row}" if ratio == 1 else f"{times}*q{row}"

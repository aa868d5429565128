"""The lengths of an arm beside each other: one out of all proportion is reported."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from dhgen.robot.angles import LARGEST_LENGTH, SNAP
from dhgen.robot.source import quoted

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.robot.reader import Path
    from dhgen.robot.report import Report

# What rounds a long link moves the joint at a short one by more. With a link of 5e-6 of the next
# rows of closed forms miss their poses by more than 1e-11 arm sizes (planar 2R, PUMA 560), of 1e-5
# where the arm is nearly singular, too. Offsets beside other lengths may be shorter by any factor,
# and so may links before the last: only where verification fails is this why.
COARSE = 2e-5
# Distances of 1e-9 arm sizes between axes, and what joints move by less, count as none; an arm is
# up to ten times as long as its longest link.
NOTHING = 1e-8
# What is farther away than so many arms are long rounds positions by more than singular poses bear:
# with a base 200 sizes away an arm with a spherical wrist passes verification, with 700 it fails.
FAR = 300.0
# Between lengths in mm and those in m is a gap, of 80 to 5000 times as a rule. Real arms have gaps
# of 290 beside offsets of less than a millimetre; one of 50 below a length that no arm has.
GAP = 300.0
GAP_BELOW_LONG = 50.0
LONG = 10.0  # m
# In a file of mm what is shorter than the others by so much is in m, if it is no longer than these
# then: 0.27 beside 302, 0.4 between 35 and 455.
LIKE_OTHERS = 50.0
# Neither arms of 100 m are built nor arms of less than 5 mm, but in micrometres.
LONGEST = 100.0  # m
SHORTEST = 5e-3  # m
METRES = {"m": 1.0, "dm": 0.1, "cm": 0.01, "mm": 1e-3, "um": 1e-6, "in": 0.0254, "ft": 0.3048}


class Length(NamedTuple):
    """A length of the file, without its sign."""

    value: float
    path: Path
    text: str


def note_spread(report: Report, lengths: Iterable[Length], unit: str) -> None:
    """Reports lengths that are next to nothing beside the others, or not in the unit of the file.

    The place of the base in the world is no length of the arm; how far a slide goes is.

    Args:
        report: Where notices and doubts go.
        lengths: The file's lengths.
        unit: The file's unit of length.
    """
    arm = [each for each in lengths if each.value > SNAP and each.path[0] != "base"]
    links = [each for each in arm if "limits" not in each.path]
    if not links:
        return
    shortest, longest = min(links, key=_value), max(arm, key=_value)
    ratio = shortest.value / longest.value
    text = f"{quoted(shortest.text)} is {ratio:.1e} of the longest length, {longest.value:g}"
    write = "write 0 if that is meant, and give all lengths in one unit"
    if ratio < NOTHING:
        report.notice(shortest.path, f"{text}, and may count as zero: {write}")
        return
    if ratio < COARSE:
        why = "rounding may exceed what is promised if it alone separates two axes"
        report.doubt(shortest.path, f"{text}, and {why}: {write}")
    elif not _note_gap(report, [*links, *_farthest(arm)], unit):
        _note_unit(report, max(links, key=_value), unit)
        _note_base(report, lengths, max(links, key=_value), unit)


def _farthest(arm: list[Length]) -> list[Length]:
    """How far each slide goes at most: where it begins may be next to nothing."""
    ends: dict[Path, Length] = {}
    for each in arm:
        if "limits" in each.path:
            joint = each.path[:-1]
            ends[joint] = max(each, ends.get(joint, each), key=_value)
    return list(ends.values())


def _note_gap(report: Report, lengths: list[Length], unit: str) -> bool:
    """Whether lengths are of two sizes, as in two units; there is a notice then.

    It points to the length that no arm has: too long in metres, too short in what is smaller.
    """
    by_value = sorted(lengths, key=_value)
    below, above = max(pairwise(by_value), key=_ratio, default=(by_value[0],) * 2)
    if _ratio((below, above)) < _gap(by_value, below, unit):
        return False
    factor = f"{_ratio((below, above)):.0f}"
    between = f"and no length is between: are both in {unit}?"
    if METRES[unit] < 1.0:
        times = f"{quoted(below.text)} is 1/{factor} of {quoted(above.text)}"
        report.notice(below.path, f"{times}, {between}")
    else:
        times = f"{quoted(above.text)} is {factor} times as long as {quoted(below.text)}"
        report.notice(above.path, f"{times}, {between}")
    return True


def _gap(by_value: list[Length], below: Length, unit: str) -> float:
    """How wide a gap must be to look like one between two units."""
    longest = by_value[-1].value * METRES[unit]
    if longest > LONG:
        return GAP_BELOW_LONG
    return LIKE_OTHERS if unit == "mm" and below.value <= longest else GAP


def _note_base(report: Report, lengths: Iterable[Length], longest: Length, unit: str) -> None:
    """Reports a base in metres below an arm in mm: what is so short beside the arm is none."""
    places = [each for each in lengths if each.value > SNAP and each.path[0] == "base"]
    far = max(places, key=_value, default=longest)
    if unit == "mm" and GAP * far.value < longest.value <= GAP * far.value / METRES[unit]:
        message = (
            f"{quoted(far.text)} is 1/{longest.value / far.value:.0f} of {quoted(longest.text)}"
        )
        report.notice(far.path, f"{message}: are both in {unit}?")


def _note_unit(report: Report, longest: Length, unit: str) -> None:
    """Reports an arm of a size that none has in its unit, and the one in which some have it."""
    metres = longest.value * METRES[unit]
    if longest.value > LARGEST_LENGTH:  # a mistake, which is reported
        return
    if metres > LONGEST or (metres < SHORTEST and unit != "um"):
        sizes = {other: longest.value * METRES[other] for other in ("mm", "m", "um")}
        fitting = (other for other, size in sizes.items() if SHORTEST <= size <= LONGEST)
        size = f"the longest length of this arm is {longest.value:g} {unit}"
        writes = (f"write `units: {{length: {other}}}` if that is meant" for other in fitting)
        report.notice(longest.path, f"{size}: {next(writes, f'are its lengths in {unit}?')}")


def _ratio(pair: tuple[Length, Length]) -> float:
    below, above = pair
    return above.value / below.value


def note_distance(report: Report, lengths: Iterable[Length]) -> None:
    """Reports a base that is far away beside the arm, and of a slide that goes far beside the rest.

    Only where verification fails is this why.
    """
    found = [each for each in lengths if each.value > SNAP]
    for far in found:
        if far.path[0] == "base":
            rest = [each.value for each in found if each.path[0] != "base"]
            advice = "leave it out of the base, and subtract it from the poses"
        elif "limits" in far.path:
            rest = [e.value for e in found if e.path[0] != "base" and e.path[:2] != far.path[:2]]
            advice = "leave the limits out if nothing stops the slide"
        else:
            continue
        if 0.0 < FAR * sum(rest) < far.value:
            times = f"{quoted(far.text)} is {far.value / sum(rest):.1e} times the rest of the arm"
            report.doubt(far.path, f"{times}, and positions are rounded by as much more: {advice}")


def _value(length: Length) -> float:
    return length.value

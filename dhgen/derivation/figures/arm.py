"""The arm with its frames, axes and lengths."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from dhgen.derivation.figures.figure import Figure, figure_path
from dhgen.derivation.figures.labels import label
from dhgen.derivation.figures.places import HALF, placed_axes
from dhgen.derivation.figures.position import drawn_position
from dhgen.derivation.figures.sheet import Sheet, settled
from dhgen.derivation.figures.skeleton import Part, Skeletons, coordinate, is_standard, scaled
from dhgen.derivation.figures.symbols import arrow, box, cylinder, ground, turning
from dhgen.derivation.figures.view import best_view
from dhgen.derivation.notation.names import joint_symbol
from dhgen.derivation.text.blocks import joined, say
from dhgen.derivation.text.formula import Symbol, equal
from dhgen.derivation.values import joint_value

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.derivation.figures.places import Placed
    from dhgen.derivation.figures.sheet import Point
    from dhgen.derivation.figures.skeleton import Skeleton
    from dhgen.derivation.figures.view import View
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Prose

WIDTH, HEIGHT = 460.0, 420.0  # of the arm without its axes [pixels]
REACH = 30.0  # of the arrow of an axis beyond the joint
SHORT = 26.0  # of the arrows of frames
SEEN = 3.0  # pixels of an arrow that does not point at the reader
BESIDE = 0.5, 0.3, 0.7, 0.15, 0.85  # parts of a length beside which its name may be
SAME = 1.5  # pixels between arrows that are drawn as one


def arm_figure(story: Story) -> Figure:
    """The arm in its reference position."""
    arms = Skeletons(story)
    q = drawn_position(story, arms)
    arm = arms.at(q)
    axes = [axis.z for axis in arm.axes]
    lengths = [m.along for m in arm.members if m.part in {Part.LINK, Part.SLIDE}]
    view = best_view(lengths, axes)
    arm = _on_paper(arm, view)
    sheet = Sheet()
    _draw(sheet, view, arm)
    return Figure(
        figure_path(story.robot.name, "arm"),
        f"{story.robot.title}: the arm, its axes and lengths",
        _caption(story, q),
        sheet,
    )


def _caption(story: Story, q: FloatArray) -> Prose:
    """At what joint values the arm is drawn, and what its symbols are."""
    kinds = set(story.algebra.chain.turning)
    moves = "slides along {}, drawn as a box"
    if True in kinds:
        moves = "turns about {}, drawn as a cylinder"
        moves += ", or slides along it, drawn as a box" if False in kinds else ""
    axis = Symbol("z_{i-1}", "zᵢ₋₁") if is_standard(story) else Symbol("z_i", "zᵢ")
    return say(f"The arm {{}}. Joint {{}} {moves}.", _position(story, q), Symbol("i", "i"), axis)


def _position(story: Story, q: FloatArray) -> Prose:
    """The joint values in words."""
    shown = [
        say("{}", equal(joint_symbol(place), joint_value(story, place, value)))
        for place, value in enumerate(q, start=1)
        if settled(value)
    ]
    if not shown:
        return say("in its reference position, every {} zero", Symbol("q_i", "qᵢ"))
    if any(settled(value) and story.algebra.chain.turning[k] for k, value in enumerate(q)):
        return say("at {}", joined(shown))
    return say("in its reference position, but with {}", joined(shown))


def _on_paper(arm: Skeleton, view: View) -> Skeleton:
    """The arm in pixels."""
    points = np.array([view.point(point) for point in arm.points])
    wide, high = np.ptp(points, axis=0)
    scale = min(
        (room / side for room, side in ((WIDTH, wide), (HEIGHT, high)) if side > 0.0), default=1.0
    )
    return scaled(arm, settled(scale))


def _draw(sheet: Sheet, view: View, arm: Skeleton) -> None:
    """From what lies below to what lies above."""
    placed = placed_axes(arm.axes, arm.members)
    ground(sheet, view, _ground_frame(arm, placed[0]))
    for member in arm.members:
        kind = "link" if member.part in {Part.LINK, Part.SLIDE} else "held"
        sheet.line([view.point(member.start), view.point(member.end)], kind)
    for joint in placed:
        if not joint.held:
            sheet.line([view.point(joint.axis.origin), view.point(joint.at)], "link")
    for joint in sorted(placed, key=lambda each: view.depth(each.at)):
        axis = joint.axis
        if axis.turns:
            cylinder(sheet, view, joint.at, axis.z)
        else:
            box(sheet, view, joint.at, axis.z, axis.x)
    tips = _axes(sheet, view, placed) + _frames(sheet, view, arm)
    for at, text, kind, first, gap in tips:
        label(sheet, [at], text, kind, first, gap)
    for member in arm.members:
        start, end = view.point(member.start), view.point(member.end)
        middle = [_between(start, end, part) for part in BESIDE]
        along = math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))
        label(sheet, middle, member.name, "i tn", round(along + 90.0, 3))


def _between(start: Point, end: Point, part: float) -> Point:
    """The point that has so much of a line before it."""
    return start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1])


def _ground_frame(arm: Skeleton, first: Placed) -> FloatArray:
    """The frame in which the ground is drawn: the base, below what would reach into it."""
    frame = arm.base.copy()
    at, z = frame[:3, 3].copy(), frame[:3, 2]
    if abs(first.axis.z @ z) > 0.99:
        frame[:3, 3] += min(float((first.at - at) @ z) - HALF, 0.0) * z
    return frame


Tip: TypeAlias = "tuple[Point, str, str, float, float]"  # where, letters, class, direction, gap


def _axes(sheet: Sheet, view: View, placed: list[Placed]) -> list[Tip]:
    """The arrows of the joints' axes; where their letters are to be."""
    tips: list[Tip] = []
    for joint in placed:
        axis, out = joint.axis, HALF + REACH
        start, end = view.point(joint.at), view.point(joint.at + out * axis.z)
        arrow(sheet, start, end, "z")
        tips.append((end, axis.name, "i tz", _angle(start, end), 0.0))
        if axis.turns:
            about = joint.at + (HALF + 10.0) * axis.z
            turning(sheet, view, about, axis.z, axis.x)
            tips.append((view.point(about), axis.value, "i tz", _angle(start, end) + 90.0, 9.0))
    return tips


def _frames(sheet: Sheet, view: View, arm: Skeleton) -> list[Tip]:
    """The arrows of frames, x of each, all of the base's and the tool's; one for all alike."""
    arrows = []
    for index, frame in enumerate(arm.frames):
        arrows += _arrows(frame, index, "xyz" if index == 0 else "x")
    last = len(arm.frames) - 1
    plain = np.abs(arm.tool - arm.frames[last]).max() < SAME
    arrows += _arrows(arm.tool, last if plain else "E", "xyz")
    joints = {axis.name for axis in arm.axes}
    drawn: dict[tuple[Point, Point], list[str]] = {}
    for at, direction, text in arrows:
        ends = view.point(at), view.point(at + SHORT * direction)
        if text in joints or math.dist(*ends) < SEEN:
            continue
        known = next((other for other in drawn if math.dist(other[1], ends[1]) < SAME), ends)
        names = drawn.setdefault(known, [])
        if text not in names:
            names.append(text)
    tips: list[Tip] = []
    for (start, end), names in drawn.items():
        arrow(sheet, start, end, "x")
        tips.append((end, ", ".join(names), "i tx", _angle(start, end), 0.0))
    return tips


def _arrows(
    frame: FloatArray, index: int | str, names: str
) -> list[tuple[FloatArray, FloatArray, str]]:
    """Where arrows of a frame begin, where they point and what they are called."""
    columns = {"x": 0, "y": 1, "z": 2}
    return [(frame[:3, 3], frame[:3, columns[n]], coordinate(n, index)) for n in names]


def _angle(start: Point, end: Point) -> float:
    return round(math.degrees(math.atan2(end[1] - start[1], end[0] - start[0])), 3)

"""The solutions of the worked example, side by side; solutions that look alike share a place."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.figures.figure import Figure, figure_path
from dhgen.derivation.figures.plane import arm_plane
from dhgen.derivation.figures.sheet import Sheet, settled, width_of
from dhgen.derivation.figures.sheet import path as outline
from dhgen.derivation.figures.skeleton import Skeletons, scaled
from dhgen.derivation.figures.symbols import arrow
from dhgen.derivation.text.blocks import say

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.derivation.example import Example
    from dhgen.derivation.figures.plane import Plane
    from dhgen.derivation.figures.sheet import Point
    from dhgen.derivation.figures.skeleton import Skeleton
    from dhgen.derivation.story import Story

SIDE = 190.0  # of a posture's place [pixels]
ROOM = 34.0  # between two, and for the names above
LOOK_ALIKE = 1e-3  # of the arm's size
SMALL = 0.9  # of the width of letters in formulas
SEEN = 4.0  # pixels of an arrow
CORNERS = ((1, 1), (-1, 1), (-1, -1), (1, -1))
POINTING = 26.0  # of the arrow of the tool
LINE = 15.0  # from one line of words to the next
IN_A_ROW = 4


@dataclass(frozen=True, slots=True)
class _Posture:
    """An arm on paper, with the rows that put it there."""

    arm: Skeleton
    names: list[str]


def postures_figure(story: Story) -> Figure | None:
    """All rows of the example; None without one, or where all look alike."""
    example = story.example
    if example is None:
        return None
    arms = Skeletons(story)
    plane = arm_plane(story, arms.at(example.q))
    postures = _postures(story, example, arms)
    if len(postures) == 1:
        return None
    caption = f"The solutions of the example, {plane.seen}."
    if any(len(posture.names) > 1 for posture in postures):
        caption += " Rows that share a drawing put all links in the same places."
    return Figure(
        figure_path(story.robot.name, "postures"),
        f"{story.robot.title}: the solutions of the example",
        say(caption),
        _sheet(postures, plane),
    )


def _postures(story: Story, example: Example, arms: Skeletons) -> list[_Posture]:
    """The rows that have a solution, rows of one shape together."""
    found: list[_Posture] = []
    for row in np.flatnonzero(~np.isnan(example.rows).any(axis=1)):
        arm, name = arms.at(example.rows[row]), _name(story, example, int(row))
        for known in found:
            if _are_alike(known.arm, arm, story.algebra.chain.size):
                known.names.append(name)
                break
        else:
            found.append(_Posture(arm, [name]))
    return found


def _are_alike(one: Skeleton, other: Skeleton, size: float) -> bool:
    """Whether two arms have their members in equal places."""
    same = one.points.shape == other.points.shape
    return same and bool(np.abs(one.points - other.points).max() < LOOK_ALIKE * size)


def _name(story: Story, example: Example, row: int) -> str:
    name = f"{row} {story.branch_names[row]}" if story.has_branch_words else f"{row}"
    return name if example.inside[row] else f"{name} (beyond limits)"


def _sheet(postures: list[_Posture], plane: Plane) -> Sheet:
    """Every posture in its place, all at one scale and with the base at one height."""
    points = np.array([plane.view.point(p) for each in postures for p in each.arm.points])
    low, high = points.min(axis=0), points.max(axis=0)
    scale = settled(SIDE / max((high - low).max(), 1e-9))
    left, top = scale * low
    wide, tall = scale * (high - low)
    words = max(SMALL * width_of(name) for each in postures for name in each.names)
    lines = max(len(each.names) for each in postures)
    pitch = max(wide, words) + ROOM, tall + ROOM + LINE * lines + POINTING
    sheet = Sheet()
    for place, posture in enumerate(postures):
        x = pitch[0] * (place % IN_A_ROW)
        y = pitch[1] * (place // IN_A_ROW)
        for line, name in enumerate(reversed(posture.names)):
            sheet.words((x + wide / 2.0, y - POINTING - LINE * line), name, "", "middle")
        _draw(sheet, plane, scaled(posture.arm, scale), (x - left, y - top))
    return sheet


def _draw(sheet: Sheet, plane: Plane, arm: Skeleton, origin: Point) -> None:
    """An arm: its members, dots for joints that turn, squares for slides, an arrow for the tool."""

    def on_paper(at: FloatArray) -> Point:
        x, y = plane.view.point(at)
        return origin[0] + x, origin[1] + y

    _base(sheet, plane, on_paper(arm.base[:3, 3]))
    path = [on_paper(point) for point in arm.points]
    sheet.line(path, "limb")
    for axis in arm.axes:
        at = on_paper(axis.origin)
        if axis.turns:
            sheet.disc(at, 4.0, "body")
        else:
            corners = [(at[0] + 4.0 * i, at[1] + 4.0 * j) for i, j in CORNERS]
            sheet.area(f"{outline(corners)}Z", corners, "body")
    tool = on_paper(arm.tool[:3, 3])
    tip = on_paper(arm.tool[:3, 3] + POINTING * arm.tool[:3, 2])
    if math.dist(tool, tip) > SEEN:
        arrow(sheet, tool, tip, "mark")
    sheet.disc(tool, 3.0, "spot")


def _base(sheet: Sheet, plane: Plane, at: Point) -> None:
    """The ground seen from the side, or a ring around the base."""
    x, y = at
    if not plane.upright:
        sheet.disc(at, 8.0, "ink")
        return
    sheet.line([(x - 16.0, y), (x + 16.0, y)], "ink")
    for k in range(-2, 3):
        sheet.line([(x + 7.0 * k + 3.0, y), (x + 7.0 * k - 3.0, y + 6.0)], "ink")

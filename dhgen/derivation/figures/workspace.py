"""What a point of the arm reaches, in a plane, with the example's place in it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.figures.figure import Figure, figure_path
from dhgen.derivation.figures.outline import outlines
from dhgen.derivation.figures.raster import reached
from dhgen.derivation.figures.reach import Section, find_reach
from dhgen.derivation.figures.sheet import Sheet, path, settled
from dhgen.derivation.figures.symbols import arrow
from dhgen.derivation.text.blocks import say
from dhgen.derivation.text.formula import Symbol

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.derivation.figures.raster import Raster
    from dhgen.derivation.figures.reach import Reach
    from dhgen.derivation.figures.sheet import Point
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Prose

PIXEL = 1.0  # of a cell
TICK = 5.0  # pixels
TICKS = 5  # about as many on the longer side
BEYOND = 22.0  # of axes beyond what is drawn
DESCENT = 16.0  # of numbers below their axis


def workspace_figure(story: Story) -> Figure | None:
    """The part of a plane that is reached; None where no plane shows it."""
    reach = find_reach(story)
    if reach is None:
        return None
    return Figure(
        figure_path(story.robot.name, "workspace"),
        f"{story.robot.title}: what it reaches",
        _caption(story, reach),
        _sheet(story, reach, reached(reach)),
    )


def _caption(story: Story, reach: Reach) -> Prose:
    joints = story.algebra.chain.joints
    limited = any(joints[number - 1].limits for number in reach.movers)
    text = f"What {reach.name} reaches{' within the limits' if limited else ''}"
    dot = "; the dot is the example" if story.example is not None else ""
    if reach.section is Section.ABOVE:
        return say(f"{text}, seen from above{dot}.")
    return say(
        f"{text}, in the half-plane through axis {reach.axis}: {{}} is the distance from the "
        f"axis{dot}.",
        Symbol("r", "r"),
    )


def _sheet(story: Story, reach: Reach, raster: Raster) -> Sheet:
    sheet = Sheet()
    lines = [[_on_paper(x, y) for x, y in line] for line in outlines(raster.held)]
    data = "".join(path(line) + "Z" for line in lines)
    sheet.area(data, [p for line in lines for p in line], "area")
    names = ("x", "y") if reach.section is Section.ABOVE else ("r", "z")
    _axes(sheet, raster, names, story.robot.length_unit)
    if story.example is not None:
        x, y = (reach.coordinates(story.example.q) - raster.origin) / raster.cell
        sheet.disc(_on_paper(x, y), 4.0, "spot")
    return sheet


def _on_paper(column: float, row: float) -> Point:
    return settled(PIXEL * column), settled(-PIXEL * row)


def _axes(sheet: Sheet, raster: Raster, names: tuple[str, str], unit: str) -> None:
    """The axes through the origin or, where that is far, beside what is reached, with numbers."""
    rows, columns = raster.held.shape
    ends = np.array([columns - 1.0, rows - 1.0])
    zero = -raster.origin / raster.cell
    foot, left = (min(max(float(zero[k]), 0.0), float(ends[k])) for k in (1, 0))
    beyond = BEYOND / PIXEL
    arrow(sheet, _on_paper(min(0.0, left), foot), _on_paper(ends[0] + beyond, foot), "ink")
    arrow(sheet, _on_paper(left, min(0.0, foot)), _on_paper(left, ends[1] + beyond), "ink")
    x, y = _on_paper(ends[0] + beyond, foot)
    sheet.words((x + 6.0, y + 4.0), names[0], "i")
    sheet.words((x + 18.0, y + 4.0), f"[{unit}]", "")
    x, y = _on_paper(left, ends[1] + beyond)
    sheet.words((x - 4.0, y - 6.0), names[1], "i")
    step = tick_step(float(ends.max()) * raster.cell)
    for value, text in _ticks(float(raster.origin[0]), float(ends[0]) * raster.cell, step):
        x, y = _on_paper((value - raster.origin[0]) / raster.cell, foot)
        sheet.line([(x, y), (x, y + TICK)], "ink")
        sheet.words((x, y + DESCENT), text, "", "middle")
    for value, text in _ticks(float(raster.origin[1]), float(ends[1]) * raster.cell, step):
        x, y = _on_paper(left, (value - raster.origin[1]) / raster.cell)
        sheet.line([(x - TICK, y), (x, y)], "ink")
        sheet.words((x - TICK - 3.0, y + 4.0), text, "", "end")


def _ticks(start: float, length: float, step: float) -> Iterable[tuple[float, str]]:
    """Numbers on an axis, without zero."""
    digits = max(0, -math.floor(math.log10(step)))
    for k in range(math.ceil(start / step), math.floor((start + length) / step) + 1):
        if k:
            yield k * step, f"{k * step:.{digits}f}".replace("-", "−")


def tick_step(length: float) -> float:
    """A round distance between the numbers on an axis of a length: about TICKS of them."""
    power = math.floor(math.log10(length / TICKS))
    base = 10.0**power
    return next(m * base for m in (1, 2, 5, 10) if m * base * (TICKS + 1) >= length)

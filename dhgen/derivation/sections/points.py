"""Points that have names: fixed in the last frame, or in the base as the tool sees it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import letter
from dhgen.derivation.text.blocks import (
    Given,
    display,
    paragraph,
    say,
)
from dhgen.derivation.text.formula import Symbol, equal
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import LATEX, PLAIN
from dhgen.derivation.text.words import many

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.paul.pool import BasePoint, Point


def point_blocks(story: Story) -> list[Block]:
    """Those that the steps use."""
    pool = story.derivation.pool
    blocks: list[Block] = []
    for point in pool.points:
        if _is_used(story, point):
            blocks += _point(story, point)
    for base_point in pool.base_points:
        if _is_used(story, base_point):
            blocks += _base_point(story, base_point)
    return blocks


def _is_used(story: Story, point: Point | BasePoint) -> bool:
    places = [story.algebra.index[name] for name in point.names]
    return any(
        monomial[place]
        for quotes in story.quotes
        for quote in quotes
        for side in (quote.left, quote.right)
        for monomial in side
        for place in places
    )


def _point(story: Story, point: Point) -> list[Block]:
    problem = story.derivation.problem
    k = story.frame_of(point)
    coordinates = []
    for row, name in enumerate(point.names):
        total = problem.target.entry(row, 3)
        for column, length in enumerate(point.in_tool):
            total += problem.target.entry(row, column) * length
        coordinates.append(equal(story.letters[name], story.write(total)))
    joints = many("joint", [str(j) for j in range(k + 1, story.dof + 1)])
    turn = "does" if k + 1 == story.dof else "do"
    assert story.wrist is not None or not story.is_wrist_frame(k)
    if story.wrist is not None and story.is_wrist_frame(k):
        first = "The wrist centre {} is the origin of frame {}, where the axes {}, {} and {} meet"
        three = [Given(str(joint)) for joint in story.wrist]
        head = say(first, Symbol("w", "w"), Given(str(k)), *three)
    else:
        text = "The pose gives a second point {}, the origin of frame {}"
        head = say(text, Symbol("w", "w"), Given(str(k)))
    text = (
        f"{{}}: {joints} {turn} not move it. In the last frame it is {{}}, so its position "
        "follows from the pose alone:"
    )
    entries = [story.write(entry) for entry in point.in_tool]
    shown = Symbol(*(f"({', '.join(show(e, style) for e in entries)})" for style in (LATEX, PLAIN)))
    return [paragraph(text, head, shown), display(*coordinates)]


def _base_point(story: Story, point: BasePoint) -> list[Block]:
    """A point of the base as the tool sees it: R' (b - t)."""
    target = story.derivation.problem.target
    name = letter("w", "w", point.names[0][1:-1])
    coordinates = []
    for column, own in enumerate(point.names):
        total = story.algebra.ring.zero
        for row, length in enumerate(point.in_base):
            total += target.entry(row, column) * (length - target.entry(row, 3))
        coordinates.append(equal(story.letters[own], story.write(total)))
    entries = [story.write(entry) for entry in point.in_base]
    shown = Symbol(*(f"({', '.join(show(e, style) for e in entries)})" for style in (LATEX, PLAIN)))
    text = "The point {} is fixed in the base. Seen from the last frame it is at {}:"
    return [paragraph(text, shown, name), display(*coordinates)]

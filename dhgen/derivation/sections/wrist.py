"""The orientation that is left to the wrist, as a matrix: what the steps of its joints read."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import link_matrix
from dhgen.derivation.notation.names import inverse, link, product_of, single, target, theta
from dhgen.derivation.text.blocks import Given, display, joined, paragraph, say
from dhgen.derivation.text.formula import Element, Listing, Matrix, Product, Symbol, equal
from dhgen.derivation.text.lines import WIDTH, width
from dhgen.kinematics.transform import compose
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.transform import Transform


def wrist_blocks(story: Story, number: int) -> list[Block]:
    """The blocks before a step: the rotation of U_{n-3}, before the first one of the wrist.

    Args:
        story: The arm and its derivation.
        number: The step, from 1.

    Returns:
        Nothing before other steps, and where an orientation of the tool is not given, the arm is a
        wrist alone, or the wrist's joints are not the last ones to be solved.
    """
    wrist, n = story.wrist, story.dof
    if wrist is None or n == len(wrist) or story.algebra.chain.task.kind is not TaskKind.POSE:
        return []
    arm = range(1, wrist[0])
    if not all(story.is_known(joint, number - 1) for joint in arm):
        return []
    if any(story.is_known(joint, number - 1) for joint in wrist):
        return []
    if not any(story.is_known(joint, number) for joint in wrist):
        return []
    hand = link_matrix(story.algebra, wrist[0])
    for joint in wrist[1:]:
        hand = compose(hand, link_matrix(story.algebra, joint), story.algebra.normal)
    entries = [
        tuple(story.write_forward(hand.entry(row, column)) for column in range(3))
        for row in range(3)
    ]
    m = wrist[0] - 1
    rotation = Symbol(f"R_{n}^{m}", f"R{chr(0x2080 + n)}^{m}")
    known = joined([say("{}", _symbol(story, joint)) for joint in arm])
    letters = _letters(story, m)
    side = story.known_side
    if letters and side is not None and side.after == number - 1:  # it has just been printed
        text = (
            "The first three rows and columns of {} are the orientation that is left to the wrist:"
        )
        head = paragraph(text, target(m))
    else:
        head = paragraph(
            "With {} the matrix {} is known, too. Its first three rows and columns are the "
            "orientation that is left to the wrist:",
            known,
            equal(target(m), product_of(wrist)),
        )
    return [
        head,
        display(equal(rotation, *letters, Matrix(tuple(entries)))),
        *_turned(story, number, wrist[0]),
        *_origin(story, target(m), hand),
    ]


def _origin(story: Story, matrix: Formula, hand: Transform) -> list[Block]:
    """Column 4 of the wrist's matrix, which is the hand's 3T6 in document 003."""
    if not any(hand.translation):
        return []
    m, n = story.dof - len(story.wrist or ()), story.dof
    entries = [
        equal(Element(matrix, row, 4), story.write_forward(entry))
        for row, entry in enumerate(hand.translation, start=1)
    ]
    if sum(map(width, entries)) > WIDTH - 10:
        return []
    text = "Column 4 of {} is the origin of frame {} as frame {} sees it:"
    return [
        paragraph(text, matrix, Given(str(n)), Given(str(m))),
        display(Listing(tuple(entries))),
    ]


def _letters(story: Story, m: int) -> list[Formula]:
    """(u_ij), where these are the letters of the rotation of U_m."""
    side = story.known_side
    if side is None or side.place != (m, story.dof, False, False):
        return []
    return [Symbol(f"({side.entry.latex})", f"({side.entry.text})")]


def _turned(story: Story, number: int, first: int) -> list[Block]:
    """Which matrix the step reads, where that is the one of the wrist without its first joint."""
    taken = (first, story.dof, False, False)
    if any(origin.matrix != taken for origin in story.steps[number - 1].origins):
        return []
    before = Product((inverse(link(first)), target(first - 1)))
    form = equal(target(first), before, product_of(range(first + 1, story.dof + 1)))
    text = "Step {} reads {}: the same, with {} taken to the known side."
    return [paragraph(text, Given(str(number)), form, _symbol(story, first))]


def _symbol(story: Story, joint: int) -> Symbol:
    slide = story.algebra.slides.get(joint)
    return theta(single(joint)) if slide is None else story.letters[slide]

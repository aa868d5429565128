"""U_0 by the entries of POS, where a base or a tool is moved to the known side."""

from __future__ import annotations

from itertools import groupby
from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import forward_of
from dhgen.derivation.notation.names import (
    BASE,
    POSE,
    TOOL,
    forward_matrix,
    letter,
    pose_letter,
    target,
)
from dhgen.derivation.notation.names import inverse as inverse_name
from dhgen.derivation.notation.polynomial import Writer, alphabet
from dhgen.derivation.sections.forward import moved_left
from dhgen.derivation.sections.transforms import matrix_of, side_by_side, transform_blocks
from dhgen.derivation.text.blocks import Folded, display, paragraph
from dhgen.derivation.text.formula import Listing, Symbol, equal, minus, times
from dhgen.derivation.text.lines import laid_out
from dhgen.derivation.text.style import PLAIN
from dhgen.derivation.text.words import counted
from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.transform import Transform, compose, inverse
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula, Relation


TITLE = "The inverses of the constant transforms, and all entries"
ROTATION, TURNED_BACK, COLUMN = Symbol("R", "R"), Symbol("R^T", "Rᵀ"), Symbol("P", "P")
EQUATIONS = 12  # of a pose: the entries of its first three rows


def given_entries(story: Story) -> list[Block]:
    """The entries that the steps use, and folded what they come from."""
    writer, named = _writer_of_pose(story)
    moved = _moved_pose(story)
    same: list[Formula] = []
    other: list[Formula] = []
    known = sorted(story.derivation.problem.known, key=lambda name: (name[2], name[1]))
    for _, column in groupby(known, key=lambda name: name[2]):
        values = {name: moved.entry(*POSE_PLACES[name]) for name in column}
        lines = [equal(story.letters[name], writer.write(value)) for name, value in values.items()]
        if all(value == story.algebra.generator(name) for name, value in values.items()):
            same.append(Listing(tuple(lines)))
        else:
            other += lines
    entries = equal(POSE, Symbol(f"({named}_{{ij}})", f"({named}ᵢⱼ)"))
    shown = [display(*each) for each in (same, other) if each]
    return [paragraph("With {} its entries are", entries), *shown, *_where_from(story, writer)]


def _writer_of_pose(story: Story) -> tuple[Writer, str]:
    """A writer for which the entries of the pose are p_ij, or m_ij where points are called p."""
    letters = dict(story.letters)
    named = pose_letter(letters)
    for i in range(1, 4):
        for j in range(1, 5):
            letters[f"t{i}{j}"] = letter(named, named, f"{i}{j}", f"p{i}{j}")
    return Writer(alphabet(story.algebra, letters), lambda _: 0), named


def _moved_pose(story: Story) -> Transform:
    """Z^-1 POS E^-1, with t_ij for the entries of POS."""
    algebra = story.algebra
    left, right = moved_left(story)
    entry = [[algebra.generator(f"t{i}{j}") for j in range(1, 5)] for i in range(1, 4)]
    moved = Transform(tuple(tuple(row[:3]) for row in entry), tuple(row[3] for row in entry))
    if left:
        back = inverse(algebra.lift(algebra.chain.base), algebra.normal)
        moved = compose(back, moved, algebra.normal)
    if right:
        back = inverse(story.derivation.problem.tool_left, algebra.normal)
        moved = compose(moved, back, algebra.normal)
    return moved


def _where_from(story: Story, writer: Writer) -> list[Block]:
    """Z^-1, E^-1 and the whole of U_0 (document 002); with few joints, its twelve equations."""
    algebra, chain = story.algebra, story.algebra.chain
    if chain.task.kind is not TaskKind.POSE:
        return []
    constant = zip((BASE, TOOL), (chain.base, chain.tool), moved_left(story), strict=True)
    inverses: list[Formula] = [
        equal(
            inverse_name(name),
            matrix_of(inverse(algebra.lift(frame), algebra.normal), writer.write),
        )
        for name, frame, is_moved in constant
        if is_moved
    ]
    moved = _moved_pose(story)
    blocks: list[Block] = [
        paragraph(
            "A transform with the rotation {} and the column 4 {} has an inverse with the rotation "
            "{} and the column 4 {}:",
            *(ROTATION, COLUMN, TURNED_BACK, minus(times(TURNED_BACK, COLUMN))),
        ),
        *side_by_side(inverses),
        paragraph("All entries of {} are", target(0)),
        *transform_blocks(target(0), moved, writer.write),
        *_equations(story, moved, writer),
    ]
    return [Folded(TITLE, tuple(blocks))]


def _equations(story: Story, moved: Transform, writer: Writer) -> list[Block]:
    """The entries of U_0 and of T_n^0 set equal, where each equation fits in a line."""
    joints = forward_of(story.algebra, story.dof)
    lines: tuple[Relation, ...] = tuple(
        equal(writer.write(moved.entry(row, column)), story.write(joints.entry(row, column)))
        for column in range(4)
        for row in range(3)
    )
    if len(laid_out(lines, PLAIN)) > EQUATIONS:
        return []
    text = "Set equal to those of {} they are twelve equations for " + counted(story.dof, "joint")
    return [paragraph(text + ":", forward_matrix(story.dof)), display(*lines)]

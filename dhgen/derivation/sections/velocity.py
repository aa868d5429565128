"""How joint velocities follow from the tool's, and where they don't: det J in factors."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import DET_J, joint_symbol, letter
from dhgen.derivation.sections.shoulder import PSI
from dhgen.derivation.text.blocks import Table, display, joined, say
from dhgen.derivation.text.formula import Matrix, Power, Symbol, add, equal, over, subtract, times
from dhgen.derivation.text.template import blocks_of
from dhgen.derivation.velocity.determinant import determinant_of
from dhgen.derivation.velocity.lost import lost_motion
from dhgen.derivation.velocity.posture import level_axis
from dhgen.derivation.velocity.worked_out import worked_out
from dhgen.derivation.velocity.wrist import (
    adjugate,
    arm_rows,
    determinant,
    wrist_blocks,
)
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.velocity.determinant import Determinant
    from dhgen.derivation.velocity.wrist import ArmRows, WristBlocks
    from dhgen.kinematics.constants import Polynomial

J_11, J_22 = letter("J", "J", "11"), letter("J", "J", "22")
DET_22 = Symbol(r"\det J_{22}", "det J₂₂")


def velocity_section(story: Story, places: Sequence[Singularity]) -> list[Block]:
    """The section; nothing where no closed formula can be given, and none is asked for.

    Args:
        story: The derivation.
        places: What the table of singular configurations lists.
    """
    chain = story.algebra.chain
    redundant = chain.dof > chain.task.dimension
    found = determinant_of(story, places)
    if found is None:
        found = worked_out(story, places)
    wrist = wrist_blocks(story)
    square = chain.dof == chain.task.dimension
    given = found is not None and bool(chain.free)
    planar = found is not None and found.rows < chain.task.dimension
    if found is None and wrist is None and not redundant and not (square and story.steps):
        return []
    return blocks_of(
        "velocity",
        unfactored=found is None and square,
        determinant=found and display(equal(DET_J, found.formula)),
        factors=_table(story, found) if found and found.factors else None,
        listed=found is not None and all(each.place for each in found.factors),
        level=_level_axis(story),
        pointing=chain.task.directions is Directions.POINTING,
        partial=found is not None and chain.task.dimension < 6,
        planar=planar,
        solved=joined([say("{}", joint_symbol(joint.number)) for joint in chain.solved]),
        given=given,
        given_and_planar=given and planar,
        redundant=redundant,
        wrist=wrist is not None,
        **(_wrist(story, wrist) if wrist else {}),
    )


def _level_axis(story: Story) -> Symbol | None:
    """The axis about which a turn is one of the pitch, where the task names that."""
    frame = level_axis(story) if story.algebra.chain.task.directions is Directions.PITCH else None
    return None if frame is None else letter("z", "z", str(frame))


def _wrist(story: Story, blocks: WristBlocks) -> dict[str, object]:
    """The blocks, the inverse of the wrist's, and what joints 1 to 3 follow from."""
    algebra = story.algebra
    rows = arm_rows(story, blocks)
    inverse = times(Symbol(r"(\det J_{22})", "(det J₂₂)"), Power(J_22, -1))
    return {
        "blocks": [
            display(equal(J_11, _matrix(story, blocks.arm))),
            display(equal(letter("J", "J", "21"), _matrix(story, blocks.turned))),
            display(equal(J_22, _matrix(story, blocks.hand))),
        ],
        "inverse_hand": [
            display(
                equal(DET_22, story.write_forward(determinant(algebra, blocks.hand))),
                equal(inverse, _matrix(story, adjugate(algebra, blocks.hand))),
            )
        ],
        "rows": rows is not None,
        **(_arm(story, rows) if rows else {}),
    }


def _arm(story: Story, rows: ArmRows) -> dict[str, object]:
    """The velocities of joints 1 to 3."""
    write = story.write_forward
    alone, *others = [letter("v", "v", "xyz"[row]) for row in (rows.alone, *rows.rest)]
    rates = [Symbol(rf"\dot{{q}}_{joint}", f"q̇{'₁₂₃'[joint - 1]}") for joint in (1, 2, 3)]
    shown, left = [equal(rates[0], over(alone, write(rows.lever)))], []
    for row, name, entry in zip(rows.rest, others, rows.first, strict=True):
        left.append(letter("u", "u", "xyz"[row]) if entry else name)
        if entry:
            shown.append(equal(left[-1], subtract(name, times(write(entry), rates[0]))))
    for rate, (one, two, below) in zip(rates[1:], rows.inverse, strict=True):
        above = add(times(write(one), left[0]), times(write(two), left[1]))
        shown.append(equal(rate, over(above, write(below))))
    return {"arm": [display(*shown)]}


def _matrix(story: Story, block: tuple[tuple[Polynomial, ...], ...]) -> Matrix:
    return Matrix(tuple(tuple(map(story.write_forward, row)) for row in block))


def _table(story: Story, found: Determinant) -> list[Block]:
    """The factors: the step that lists each as a condition, and what is lost where it vanishes."""
    header = tuple(say(word) for word in ("factor", "step", "lost where it is zero"))
    rows = []
    for factor in found.factors:
        others = [each.formula for each in found.factors if each is not factor]
        lost = lost_motion(story, factor.formula, others) or say("no short name")
        if factor.is_never_zero:
            lost = say("never zero with the numbers of this arm")
        rows.append((say("{}", factor.formula), _step(factor.place), lost))
    return [Table(header, tuple(rows))]


def _step(place: Singularity | None) -> Prose:
    """The step that lists a factor."""
    if place is None:
        return say("—")
    return say(str(place.step)) if place.step else say("{}", PSI)

"""How joint velocities follow from the tool's, and where they don't: det J in factors."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import DET_J, joint_symbol, letter
from dhgen.derivation.sections.shoulder import PSI
from dhgen.derivation.text.blocks import Table, display, joined, say
from dhgen.derivation.text.formula import Matrix, Power, Symbol, add, equal, over, subtract, times
from dhgen.derivation.text.lines import WIDTH, width
from dhgen.derivation.text.template import blocks_of
from dhgen.derivation.text.words import joined as enumerated
from dhgen.derivation.text.words import numeral
from dhgen.derivation.velocity.determinant import determinant_of
from dhgen.derivation.velocity.irreducible import is_irreducible
from dhgen.derivation.velocity.lost import lost_motion, point_name
from dhgen.derivation.velocity.posture import level_axis
from dhgen.derivation.velocity.tall import has_fewer_joints, some_columns
from dhgen.derivation.velocity.task_rows import ways_to_see
from dhgen.derivation.velocity.with_arm_angle import determinant_with_arm_angle
from dhgen.derivation.velocity.wrist import (
    adjugate,
    arm_rows,
    wrist_blocks,
)
from dhgen.kinematics.transform import dot
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Relation
    from dhgen.derivation.velocity.determinant import Block as VelocityBlock
    from dhgen.derivation.velocity.determinant import Determinant
    from dhgen.derivation.velocity.wrist import ArmRows, WristBlocks
    from dhgen.kinematics.constants import Polynomial

INSIDE = WIDTH // 4  # what is wider has a letter of its own in a matrix
NAMED = WIDTH // 2  # what is wider has a letter of its own in a long product
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
    found = determinant_of(story, places) or determinant_with_arm_angle(story, places)
    found, letters = with_letters(story, found) if found else (None, [])
    wrist = wrist_blocks(story)
    irreducible = _is_irreducible(story, found)
    square = found is not None or irreducible or bool(ways_to_see(story))
    if not (square or wrist or redundant):
        return _with_fewer_joints(story, places)
    elsewhere = found.elsewhere if found else None
    given = square and bool(chain.free)
    planar = found is not None and found.rows < chain.task.dimension
    return blocks_of(
        "velocity",
        unfactored=square and found is None,
        irreducible=irreducible,
        alone=found.factors[0].formula if found and irreducible else None,
        determinant=found and display(equal(DET_J, found.formula)),
        letters=display(*letters) if letters else None,
        arm_angle=chain.arm_angle and PSI,
        factors=_table(story, found) if found else None,
        never_zero=found is not None and not found.factors,
        listed=found is not None and all(each.place for each in found.factors),
        frame=elsewhere and str(elsewhere[0]),
        centre=elsewhere and elsewhere[1] <= chain.dof and point_name(story, elsewhere[1]),
        level=_level_axis(story),
        pointing=chain.task.directions is Directions.POINTING,
        tilt=chain.task.directions is Directions.TILT,
        partial=found is not None and chain.task.dimension < 6,
        planar=planar,
        solved=joined([say("{}", joint_symbol(joint.number)) for joint in chain.solved]),
        given=given,
        given_and_planar=given and planar,
        redundant=redundant,
        wrist=wrist is not None,
        **(_block(story, found.block) if found and found.block else {"block": None}),
        **(_wrist(story, wrist) if wrist else {}),
    )


def _with_fewer_joints(story: Story, places: Sequence[Singularity]) -> list[Block]:
    """Why there is no determinant, and that of some columns."""
    if not has_fewer_joints(story):
        return []
    chain, found = story.algebra.chain, some_columns(story, places)
    at_the_tool = found is None or found.centre > chain.dof
    return blocks_of(
        "velocity_of_few",
        numbers=numeral(chain.task.dimension),
        given=bool(chain.free),
        columns=found and enumerated([str(joint) for joint in found.joints]),
        rows=found and numeral(len(found.joints)),
        frame=found and str(found.frame),
        centre=None if found is None or at_the_tool else point_name(story, found.centre),
        determinant=found and display(found.formula),
    )


def with_letters(story: Story, found: Determinant) -> tuple[Determinant, list[Relation]]:
    """The determinant with letters for long factors where it is too wide, and what these are."""
    if width(found.formula) <= WIDTH:
        return found, []
    used = {story.letters[constant.name].text for constant in story.algebra.chain.constants}
    unused = (letter(each, each) for each in "FGHKLMN" if each not in used)
    factors, defined = [], []
    for each in found.factors:
        name = next(unused, None) if width(each.formula) > NAMED else None
        factors.append(replace(each, formula=name) if name else each)
        defined += [equal(name, each.formula)] if name else []
    return replace(found, factors=tuple(factors)), defined


def _is_irreducible(story: Story, found: Determinant | None) -> bool:
    """Whether nothing shorter than the determinant is left to look for, and it is long."""
    if story.algebra.chain.arm_angle:
        return False
    if found is None:
        return is_irreducible(story)
    long = len(found.factors) == 1 and width(found.factors[0].written_out) > WIDTH
    return long and is_irreducible(story)


def _block(story: Story, block: VelocityBlock) -> dict[str, object]:
    """The matrix of a block, with letters for entries that are long."""
    columns, entries = [], []
    for number, column in block.columns:
        columns.append([story.write_forward(entry) for entry in column])
        for place, axis in enumerate("xyz"):
            if width(columns[-1][place]) > INSIDE:
                name = letter("j", "j", f"{axis}{number}")
                entries.append(equal(name, columns[-1][place]))
                columns[-1][place] = name
    return {
        "block": display(equal(letter("J", "J", "v"), Matrix(tuple(zip(*columns, strict=True))))),
        "entries": display(*entries) if entries else None,
        "movers": enumerated([str(number) for number, _ in block.columns]),
        "block_point": point_name(story, block.centre),
        "block_frame": str(block.frame),
    }


def _level_axis(story: Story) -> Symbol | None:
    """The axis about which a turn is one of the pitch, where the task names that."""
    frame = level_axis(story) if story.algebra.chain.task.directions is Directions.PITCH else None
    return None if frame is None else letter("z", "z", str(frame))


def _wrist(story: Story, blocks: WristBlocks) -> dict[str, object]:
    """The blocks, the inverse of the wrist's, and what joints 1 to 3 follow from."""
    algebra = story.algebra
    rows = arm_rows(story, blocks)
    adjoint = adjugate(algebra, blocks.hand)
    size = dot([row[0] for row in blocks.hand], adjoint[0], algebra.normal)
    inverse = times(Symbol(r"(\det J_{22})", "(det J₂₂)"), Power(J_22, -1))
    return {
        "blocks": [
            display(equal(J_11, _matrix(story, blocks.arm))),
            display(equal(letter("J", "J", "21"), _matrix(story, blocks.turned))),
            display(equal(J_22, _matrix(story, blocks.hand))),
        ],
        "inverse_hand": [
            display(
                equal(DET_22, story.write_forward(size)),
                equal(inverse, _matrix(story, adjoint)),
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
    """The factors: the step that lists each as a condition, and what is lost where it vanishes.

    Nothing where all that is known of one factor is that it vanishes where the determinant does.
    """
    header = tuple(say(word) for word in ("factor", "step", "lost where it is zero"))
    rows = []
    for factor in found.factors:
        others = [each.written_out for each in found.factors if each is not factor]
        lost = lost_motion(story, factor.written_out, others, found.elsewhere)
        if factor.is_never_zero:
            lost = say("never zero with the numbers of this arm")
        elif lost is None and factor.place is None and not others:
            return []
        rows.append((say("{}", factor.formula), _step(factor.place), lost or _unnamed(story)))
    return [Table(header, tuple(rows))] if rows else []


def _unnamed(story: Story) -> Prose:
    """A motion without a short name; that of the elbow is in no rows of the tool's velocity."""
    if story.algebra.chain.arm_angle:
        return say("with the tool at rest, a change of {}", PSI)
    return say("no short name")


def _step(place: Singularity | None) -> Prose:
    """The step that lists a factor."""
    if place is None:
        return say("—")
    return say(str(place.step)) if place.step else say("{}", PSI)

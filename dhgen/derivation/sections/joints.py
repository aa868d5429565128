"""From angles and lengths to joint values: sums taken apart, offsets, signs, one turn."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.effects import comparisons
from dhgen.derivation.notation.names import joint_symbol, letter, single, theta
from dhgen.derivation.sections.drives import drive_value, signed_terms
from dhgen.derivation.sections.tables import couplings_of, joints_of, sign_and_offset
from dhgen.derivation.sections.turns import turns_inside
from dhgen.derivation.text.blocks import Paragraph, display, paragraph, say
from dhgen.derivation.text.formula import Formula, Symbol, add, equal, minus
from dhgen.derivation.text.words import counted, numeral
from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.numeric import numeric_arm
from dhgen.program.walk import finds_roots
from dhgen.robot.expression import ZERO as NOTHING
from dhgen.robot.robot import JointKind
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.paul.knowledge import Cut
    from dhgen.program.ir import Program


COMPARED = (
    "No step uses all equations, and some combinations of these values contradict the others. Each "
    "row is put into the forward model; where an entry differs from the given one, the row stays "
    "empty."
)


def joint_values(story: Story) -> list[Block]:
    """What comes after the steps."""
    lines = [*_sums(story), *_variables(story)]
    blocks: list[Block] = []
    if lines:
        blocks.append(Paragraph(_text(story), lead=say("The joint values.")))
        blocks.append(display(*lines))
    blocks += turns_inside(story)
    if story.derivation.problem.overdetermined:
        blocks.append(_check(story))
    elif comparisons(story.program):
        blocks.append(paragraph(COMPARED))
    if story.program.completion is not None:
        blocks.append(_refining(story.program))
    return blocks


def _text(story: Story) -> Prose:
    joints = story.algebra.chain.joints
    turning = [joint for joint in joints if joint.kind is JointKind.REVOLUTE]
    shifted = any(joint.offset != 0.0 or joint.shares for joint in turning)
    if not (_sums(story) or shifted):
        return say("What remains is to return to the joint variables:")
    text = "What remains is addition; whole turns are taken off, so that every angle lies in {}:"
    return say(text, Symbol(r"(-\pi, \pi]", "(−π, π]"))


def _sums(story: Story) -> list[Formula]:
    """theta_4 = theta_234 - theta_3 - theta_2, for joints that no step gives by themselves."""
    solved = solved_sums(story, len(story.steps))
    lines: list[Formula] = []
    for joint in _turning(story):
        if single(joint) in solved:
            continue
        lines.append(as_sum(story, single(joint), solved))
    return lines


def solved_sums(story: Story, count: int) -> list[AngleSum]:
    """What so many steps have solved for, and the angles that the caller gives."""
    steps = story.steps[:count]
    solved = [each for step in steps for each in step.unknowns if isinstance(each, AngleSum)]
    return solved + [single(each) for each in story.algebra.chain.free if each in _turning(story)]


def as_sum(story: Story, angle: AngleSum, solved: list[AngleSum]) -> Formula:
    """theta_4 = theta_234 - theta_3 - theta_2, from sums that are solved."""
    ((joint, _),) = angle.terms
    parts = path_of(story, joint, solved)
    return equal(
        theta(angle),
        add(*(theta(each) if sign > 0 else minus(theta(each)) for each, sign in parts)),
    )


def _turning(story: Story) -> list[int]:
    joints = story.algebra.chain.joints
    return [joint.number for joint in joints if joint.kind is JointKind.REVOLUTE]


def path_of(story: Story, joint: int, solved: list[AngleSum]) -> list[tuple[AngleSum, int]]:
    """The solved sums, with signs, that add up to the angle of a joint: the shortest way."""
    runs = story.knowledge[0].runs
    run, place = runs.place[joint]
    facing = runs.runs[run][place][1]
    start, goal = (run, place), (run, place + 1)
    reached: dict[Cut, list[tuple[AngleSum, int]]] = {start: []}
    frontier = [start]
    while frontier:
        cut = frontier.pop(0)
        for angle in solved:
            low, high, sign = runs.ends(angle)
            for here, there, along in ((low, high, sign), (high, low, -sign)):
                if here == cut and there not in reached:
                    reached[there] = [*reached[cut], (angle, along)]
                    frontier.append(there)
    parts = [(angle, sign * facing) for angle, sign in reached[goal]]
    return sorted(parts, key=lambda part: -len(part[0].terms))


def _variables(story: Story) -> list[Formula]:
    """q_i by theta_i or r_i, where they differ and the caller does not give q_i."""
    lines: list[Formula] = []
    given = story.algebra.chain.free
    for number, joint in enumerate(joints_of(story), start=1):
        turning = joint.kind is JointKind.REVOLUTE
        inner: Formula = theta(single(number)) if turning else letter("r", "r", str(number))
        sign, offset = sign_and_offset(story, number)
        if couplings_of(story, number) or number in given:
            continue
        if turning and sign > 0 and offset == NOTHING:
            continue
        added = signed_terms(offset)
        value = add(inner, *map(minus, added)) if sign > 0 else add(*added, minus(inner))
        lines.append(equal(joint_symbol(number), value))
    order = story.algebra.chain.drives.order
    coupled = [each for each in order if couplings_of(story, each) and each not in given]
    return lines + [drive_value(story, each) for each in coupled]


def _check(story: Story) -> Block:
    """A pose with more numbers than the arm has joints."""
    chain = story.algebra.chain
    asked, own = chain.task.dimension, chain.dof - chain.given
    joints = counted(own, "joint") + (" to solve for" if chain.given else "")
    spare = " Without the orientation the arm would be redundant, with infinitely many solutions."
    return paragraph(
        f"The task has {numeral(asked)} independent numbers, the arm {joints}, so it cannot take "
        "every pose. Each solution is put into the forward model; where an entry differs from the "
        "given one, the arm cannot take the pose and the row stays empty."
        + (spare if _is_redundant_by_position(story) else "")
    )


def _is_redundant_by_position(story: Story) -> bool:
    """Whether joints can move without the tool's origin, at a posture that is no special one."""
    chain = story.algebra.chain
    if chain.task.kind is not TaskKind.POSE or chain.given:
        return False
    q = np.linspace(0.4, 1.3, chain.dof)[None]
    rows = numeric_arm(chain).jacobian(q)[0, :3]
    return bool(np.linalg.matrix_rank(rows, tol=1e-9 * chain.size) < chain.dof)


def _refining(program: Program) -> Block:
    """What is done with rows that are good to few digits."""
    text = (
        "Angles of short vectors, and roots that nearly meet, are good to a few digits only. A row "
        "that misses the pose slightly is refined by damped least squares, with the Jacobian of "
        "the whole task, until it is exact or comes no closer. If it still misses the pose, it is "
        "left empty."
    )
    if program.completion is not None and program.completion.elbow:
        text += " The arm angle is one more equation of these steps."
    if finds_roots(program):
        text += (
            " Where two roots nearly meet, a joint may be nearly free. Both may then "
            "be found as one value between them. From there the steps reach one of the two "
            "solutions; a second start, as far away on the other side, reaches the other. A root "
            "that took the seed's value is looked for again with a seed turned away from it."
        )
    if program.completion is not None and program.completion.checked:
        text += (
            " If a row is exact after that, the pose was not rounded, and all rows have to be "
            "exact; if none is, they stay as they were."
        )
    return paragraph(text)

"""How the inverse begins: the pose that is given, and U_0."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import BASE, POSE, TOOL, link, target
from dhgen.derivation.notation.names import inverse as inverse_name
from dhgen.derivation.sections.forward import given_pose, moved_left, tool_back
from dhgen.derivation.sections.given_entries import given_entries
from dhgen.derivation.sections.shoulder import shoulder_blocks
from dhgen.derivation.sections.types_table import types_table
from dhgen.derivation.steps import leaves_a_joint_free
from dhgen.derivation.text.blocks import (
    Given,
    Heading,
    Paragraph,
    joined,
    paragraph,
    say,
    sentences,
)
from dhgen.derivation.text.formula import Listing, Symbol, equal, times
from dhgen.kinematics.task import task_entries
from dhgen.kinematics.transform import identity
from dhgen.robot.task import Directions, TaskKind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose


SEED = (
    "The seed is a set of joint values that the caller may give, such as the arm's present ones: a "
    "joint that the pose leaves free takes its value from there."
)


def inverse_beginning(story: Story) -> list[Block]:
    """Everything before the first step."""
    blocks: list[Block] = [Heading(2, say("Inverse"))]
    blocks += _given(story)
    blocks += types_table(story)
    blocks += _left_over(story)
    return [*blocks, *shoulder_blocks(story)]


def _given(story: Story) -> list[Block]:
    """U_0, and its entries where base or tool are moved to the left."""
    left, right = moved_left(story)
    method = say(
        "Paul's method multiplies both sides of {} by {}, {} and so on from the left, {}, until an "
        "element holds one unknown or is of one of the types below.",
        equal(target(0), Symbol(r"A_1 \cdots A_n", "A₁⋯Aₙ")),
        inverse_name(link(1)),
        inverse_name(link(2)),
        equal(Symbol("U_i", "Uᵢ"), Symbol(r"A_i^{-1} U_{i-1}", "Aᵢ⁻¹ Uᵢ₋₁")),
    )
    named = sorted(task_entries(story.algebra.chain.task))
    which = say("")
    if len(named) < 12:
        which = say(" Of its entries the task gives {}.", _named(story))
    blocks: list[Block] = [
        paragraph(
            "The pose {} of the tool is given, and with it {}.{}{} {}",
            POSE,
            given_pose(story),
            which,
            _angles(story),
            method,
        ),
        *_other_forms(story),
        *([paragraph(SEED)] if leaves_a_joint_free(story) else []),
    ]
    if right and not story.algebra.chain.task.names_rotation:
        blocks.append(
            paragraph(
                "The task gives the tool's z axis, and with it the point where this meets axis {}, "
                "which joint {} does not move: {} puts the tool's origin there.",
                *[Given(str(story.dof))] * 2,
                tool_back(story),
            )
        )
    if left or right:
        blocks += given_entries(story)
    return blocks


def _angles(story: Story) -> Prose:
    """The entries that come from angles of a list."""
    t11, t21, *t3 = (story.letters[name] for name in ("t11", "t21", "t31", "t32", "t33"))
    match story.algebra.chain.task.directions:
        case Directions.YAW:
            text = (
                " The tool's x axis is made level before: {} and {} are the cosine and the sine of "
                "the yaw, the first two entries of its column over the root of their squares' sum. "
                "Where that is zero the axis is vertical and has no yaw{}."
            )
            free = "" if story.derivation.problem.overdetermined else ", which the seed gives then"
            return say(text, t11, t21, say(free))
        case Directions.PITCH:
            return say(" {} is minus the sine of the pitch.", t3[0])
        case Directions.TILT:
            text = (
                " {}, {} and {} hold roll and pitch: minus the sine of the pitch, and its cosine "
                "times the sine and the cosine of the roll."
            )
            return say(text, *t3)
        case _:
            return say("")


def _other_forms(story: Story) -> list[Block]:
    """How the forms come about that are none of Paul's U_i."""
    mixed = [o for step in story.steps for o in step.origins if o.is_mixed]
    texts: list[Prose] = []
    last = [inverse_name(link(story.dof - i)) for i in (0, 1)]
    if not all(origin.inverse for origin in mixed):
        text = "Some steps also move the last joints to the known side: both sides are multiplied "
        texts.append(say(text + "by {}, {} and so on from the right.", *last))
    if any(origin.inverse for origin in mixed):
        text = "Some equations are those of {}, in which a frame of the base is seen from the tool."
        texts.append(say(text, inverse_name(target(0))))
    return [Paragraph(sentences(texts))] if texts else []


def _named(story: Story) -> Prose:
    """The entries of U_0 that the task gives, without repetitions."""
    if story.algebra.chain.task.kind is TaskKind.ORIENTATION:
        return say("the nine of the rotation")
    known = sorted(story.derivation.problem.known)
    return say("{}", Listing(tuple(story.letters[name] for name in known)))


def _left_over(story: Story) -> list[Block]:
    """Base and tool that remain on the right, because the task does not give the whole pose."""
    problem = story.derivation.problem
    chain = story.algebra.chain
    still = identity(chain.ring)
    left: list[Prose] = []
    if not problem.base_left and chain.base != still:
        left.append(say("{} stands for {}", link(1), times(BASE, link(1))))
    if not chain.task.names_rotation and chain.tool != still:
        behind = [tool_back(story)] if moved_left(story)[1] else []
        all_of_it = times(link(chain.dof), TOOL, *behind)
        left.append(say("{} stands for {}", link(chain.dof), all_of_it))
    if not left:
        return []
    text = (
        "The task gives only a part of the pose; moving a constant frame to the other side would "
        "mix that part with the rest, so it stays where it is: in this section {}."
    )
    return [paragraph(text, joined(left))]

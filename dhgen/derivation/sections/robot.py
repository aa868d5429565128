"""The title, the opening paragraph, the names of rows, and the robot as the user wrote it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.geometry import neighbours
from dhgen.derivation.notation.expressions import text_symbol
from dhgen.derivation.notation.names import unknown_symbol
from dhgen.derivation.sections.frames import frame_sentences
from dhgen.derivation.sections.parameters import constant_blocks
from dhgen.derivation.sections.tables import axes_blocks, table_blocks
from dhgen.derivation.text.blocks import Given, Heading, Paragraph, Prose, joined, paragraph, say
from dhgen.derivation.text.formula import ONE, equal, minus, times
from dhgen.derivation.text.words import counted, many, numeral
from dhgen.kinematics.neighbours import EXACT, axis_triples
from dhgen.kinematics.numeric import numeric_arm
from dhgen.method import Method
from dhgen.paul.kind import Part
from dhgen.robot.robot import DhTable, JointKind
from dhgen.robot.task import Directions, TaskKind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Symbol
    from dhgen.kinematics.chain import Chain
    from dhgen.program.ir import Axis
    from dhgen.robot.task import Task


_TASKS = {
    TaskKind.POSE: "the pose of the tool, position and orientation",
    TaskKind.POSITION: "the position of the tool; its orientation is not prescribed",
    TaskKind.ORIENTATION: "the orientation of the tool; its position is not prescribed",
    TaskKind.POINTING: "the position of the tool and the direction of its z axis",
    TaskKind.DIRECTION: "the direction of the tool's z axis",
}


def opening(story: Story) -> list[Block]:
    """The title and what the arm is."""
    kinds = [joint.kind for joint in story.robot.joints]
    letters = story.algebra.chain.joint_types
    blocks: list[Block] = [
        Heading(1, say("{}: inverse kinematics", Given(story.robot.title))),
        Paragraph(say(f"{letters}: {_kinds(kinds)}. {_task(story)} {_solutions(story)}")),
        *branch_legend(story),
    ]
    if story.robot.source:
        source = Given(story.robot.source.rstrip("."))
        blocks.append(paragraph("Source of the numbers: {}.", source))
    return blocks


def robot_section(story: Story, written: frozenset[Symbol]) -> list[Block]:
    """Table or axes, convention, parameters, frames, for formulas that hold some letters."""
    geometry = story.robot.geometry
    return [
        Heading(2, say("The robot")),
        *(table_blocks(story) if isinstance(geometry, DhTable) else axes_blocks(story)),
        *_taken(story),
        *constant_blocks(story),
        *(Paragraph(prose) for prose in frame_sentences(story, written)),
    ]


def _taken(story: Story) -> list[Block]:
    """The cells whose exact value differs a little from the table."""
    cells = story.robot.taken
    if not cells:
        return []
    each = [
        say(
            "{} as {} in place of {}",
            Given(cell.place),
            text_symbol(cell.exact),
            Given(cell.text),
        )
        for cell in cells
    ]
    text = "Cells within 1e-9 of an exact value are taken as it: {}."
    return [paragraph(text, joined(each))]


def _kinds(kinds: list[JointKind]) -> str:
    turning = [str(i) for i, kind in enumerate(kinds, 1) if kind is JointKind.REVOLUTE]
    sliding = [str(i) for i, kind in enumerate(kinds, 1) if kind is JointKind.PRISMATIC]
    if not sliding:
        return counted(len(turning), "revolute joint")
    if not turning:
        return counted(len(sliding), "prismatic joint")
    return (
        f"{counted(len(kinds), 'joint')}, {many('joint', turning)} revolute and "
        f"{many('joint', sliding)} prismatic"
    )


def _task(story: Story) -> str:
    task = story.robot.task
    free = ""
    if story.robot.free:
        joints = [str(joint) for joint in story.robot.free]
        free = f" The caller gives the value of {many('joint', joints)}."
    if story.robot.arm_angle:
        free = " The caller gives the arm angle."
    if task.kind is TaskKind.LIST:
        listed = _listed(task) if task.angles else many("the coordinate", list(task.coordinates))
        return f"Task: {listed} of the tool.{free}"
    return f"Task: {_TASKS[task.kind]}.{free}"


def _listed(task: Task) -> str:
    """The coordinates and angles of a list."""
    angles = f"the {' and '.join(task.angles)}"
    if not task.coordinates:
        return angles
    return f"{many('the coordinate', list(task.coordinates))}, and {angles}"


def _solutions(story: Story) -> str:
    rows = story.program.rows
    if story.derivation.method is Method.NUMERICAL:
        given = "one, in row 0" if rows == 1 else f"up to {numeral(rows)}, in rows from 0"
        return f"Solved numerically: of the solutions found, {given}."
    if rows == 1:
        return "Every pose within reach has one solution, row 0."
    count = counted(rows, "solution")
    if story.derivation.whole is not None:
        order = "ascending joint values" if story.nominal is None else "posture"
        return f"At most {count}, in rows by {order}."
    where = "rows 0 and 1" if rows == 2 else f"rows 0 to {rows - 1}"
    returned = f"The inverse has at most {count}, returned in {where}"
    if not story.has_branch_words:
        return f"{returned}, each always in the same one; the tree below has the signs of each row."
    if story.derivation.method is Method.QUARTIC:
        return f"{returned} by ascending angles of the roots; the tree below has their names."
    return f"{returned}, each always in the same one; the tree below has their names."


_SEEN = {
    (Part.END, "left"): "seen from above towards {end}, the plane of the arm passes axis 1 on "
    "the left or on the right",
    (Part.END, "front"): "the arm faces {end} (front) or reaches over itself (back)",
    (Part.ELBOW, "up"): "the elbow is above or below the line from the shoulder to the end of the "
    "forearm{unless}",
    (Part.ELBOW, "left"): "seen from above, the elbow is on the left or on the right of the line "
    "from the shoulder to the end of the forearm",
    (Part.SLIDE, "forward"): "the slide is farther out (forward) or less far",
}
"""By what is placed and one of its two words; {end} is what the arm reaches for with."""
_TURNED = "noflip and flip are the two ways to turn the wrist"
_SIGNS = "+ and - are signs, and say nothing of how the arm looks"


def branch_legend(story: Story) -> list[Block]:
    """The words of every choice, with its sign, its step and what the step gives."""
    if story.derivation.whole is not None or not story.has_branch_words:
        return []
    choices = [_choice(story, place, axis) for place, axis in enumerate(story.program.axes)]
    legend = say(f"In the names of rows {'; '.join('{}' for _ in choices)}.", *choices)
    return [Paragraph(legend), *meanings_of_names(story)]


def meanings_of_names(story: Story) -> list[Block]:
    """What a person sees of the arm in rows of these names; nothing where that is nothing."""
    seen = [text for axis in story.program.axes if (text := _seen(story, axis))]
    meanings = "; ".join(dict.fromkeys(seen))
    return [Paragraph(say(f"What the names mean: {meanings}."))] if seen else []


def _seen(story: Story, axis: Axis) -> str:
    """What a person sees of the arm in rows of these names."""
    part = story.steps[axis.step - 1].kind.value.part
    words = [word.rstrip("0123456789") for word in axis.meaning]  # the joint's where two are alike
    if "flip" in words:
        return _TURNED
    if any(word.endswith("+") for word in words):
        return _SIGNS
    seen = next((_SEEN[part, word] for word in words if (part, word) in _SEEN), "")
    turns = story.algebra.chain.task.directions is not Directions.NONE
    end = "the wrist" if turns else "the tool"
    return seen.format(end=end, unless=_unless(story.algebra.chain, end))


def _unless(chain: Chain, end: str) -> str:
    """Where up and down change places: they are seen by who looks where the arm reaches."""
    if _forearm_ends_earlier(chain):
        return f", unless this end is behind the shoulder, seen from axis 1 towards {end}"
    if _shoulder_is_on_axis_1(chain):
        return ""
    return f", unless {end} is nearer to axis 1 than the shoulder"


def _forearm_ends_earlier(chain: Chain) -> bool:
    """Whether a third parallel axis ends it, or a passive one, before what the arm reaches with."""
    arm = numeric_arm(chain)
    passive = any(isinstance(each, int) and each > chain.dof for each in arm.elements)
    return passive or any(triple.tilt < EXACT for triple in axis_triples(chain))


def _shoulder_is_on_axis_1(chain: Chain) -> bool:
    """Whether axes 1 and 2 meet, so that nothing is nearer to axis 1 than the shoulder."""
    return any(pair.first == 1 and pair.meet is not None for pair in neighbours(chain))


def _choice(story: Story, place: int, axis: Axis) -> Prose:
    unknowns = story.steps[axis.step - 1].unknowns
    unknown = joined([say("{}", unknown_symbol(each)) for each in unknowns])
    if axis.count != 2:
        first, last = axis.meaning[0], axis.meaning[-1]
        return say(
            f"{first} to {last} are the roots of step {axis.step} for {{}}, ascending", unknown
        )
    plus, opposite = axis.meaning
    axes = (story.program.axes[each] for each in sorted((*axis.factors, place)))
    sign = times(*map(story.sign, axes))
    brought = say(f" in step {axis.step}")
    if axis.factors:
        brought = say(f", where {{}} is the sign of step {axis.step}", story.sign(axis))
    return say(
        f"{plus} is {{}} and {opposite} is {{}}{{}}, which gives {{}}",
        equal(sign, ONE),
        equal(sign, minus(ONE)),
        brought,
        unknown,
    )

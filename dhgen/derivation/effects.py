"""What a singular place means for the arm, and what the program does there, in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import joint_symbol, single, theta
from dhgen.derivation.sums_left import sum_left
from dhgen.derivation.text.blocks import Given, joined, say
from dhgen.derivation.text.formula import ONE, ZERO, equal, minus
from dhgen.derivation.text.words import many
from dhgen.kinematics.algebra import POSE_NAMES
from dhgen.kinematics.ring import used_places
from dhgen.kinematics.transform import identity
from dhgen.paul.form import Length
from dhgen.paul.kind import Kind
from dhgen.program.ir import Failure, Guard

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.sums_left import SumLeft
    from dhgen.derivation.text.blocks import Prose
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.constants import Polynomial
    from dhgen.program.ir import Program


def sum_of_free(context: StepContext, joints: Polynomial | None) -> SumLeft | None:
    """What is still known where an angle of type 2 with Z = 0 is free, if that is a sum."""
    return None if context.step.degenerate else sum_left(context.story.algebra, joints)


def meaning_of_free(context: StepContext, left: SumLeft | None) -> Prose:
    """What the arm looks like where an angle of type 2 with Z = 0 is free."""
    if left is not None:
        return left.prose
    works = nothing_said(context)
    if context.step.degenerate or is_left_to_the_pose(context):
        works = f"this equation holds for every {{}}, and {others_decide(context)}"
    if _is_about_first_axis(context):
        text = "{} lies on axis 1, and " + works
        return say(text, point_name(context), theta(context.angle))
    return say(works, theta(context.angle))


def meaning_of_root(context: StepContext) -> Prose:
    """What the arm looks like where the two values of a step meet."""
    if _is_about_first_axis(context):
        text = "{} is as close to axis 1 as the offset of the arm allows"
        return say(text, point_name(context))
    if not _holds_a_place(context):
        return say("the tool's direction is at the edge of what the joints can give")
    given = [str(joint) for joint in context.story.algebra.chain.free]
    ending = f", with {many('joint', given)} as given" if given else ""
    return say(f"the arm is at the edge of its reach{ending}")


def _holds_a_place(context: StepContext) -> bool:
    """Whether an equation holds more of the pose than its directions."""
    algebra = context.story.algebra
    pose = {
        algebra.ring.symbols[place].name
        for form in context.step.forms
        for place in used_places(form.equation.difference)
    } & {*POSE_NAMES, *algebra.coordinates}
    return not pose or any(not name.startswith("t") or name.endswith("4") for name in pose)


def _is_about_first_axis(context: StepContext) -> bool:
    """Whether the equation compares x and y of a point with joint 1."""
    if context.angle != single(1):
        return False
    names = {
        context.story.algebra.ring.symbols[place].name
        for letter, polynomial in context.step.coefficients
        if letter in ("X", "Y")
        for place in used_places(polynomial)
    }
    points = context.story.derivation.pool.points
    return names in [{"t14", "t24"}, *({p.names[0], p.names[1]} for p in points)]


def point_name(context: StepContext) -> Prose:
    """What the point of an equation in column 4 is called."""
    story = context.story
    used = [
        story.algebra.ring.symbols[place].name
        for _, polynomial in context.step.coefficients
        for place in sorted(used_places(polynomial))
    ]
    for point in story.derivation.pool.points:
        if set(point.names) & set(used):
            frame = story.frame_of(point)
            if story.is_wrist_frame(frame):
                return say("the wrist centre")
            return say("the origin of frame {}", Given(str(frame)))
    turned = {joint for joint, _ in context.angle.terms}
    if any(turned & {joint for joint, _ in each.terms} for each in story.algebra.chain.passive):
        return say("the far end of the two links")  # what is behind it is turned back
    later = [
        f"{kind}{a.suffix}"
        for a in story.algebra.angles
        for kind in "cs"
        if a.terms[-1][0] > max(joint for joint, _ in context.angle.terms) + 1
    ]
    if set(later) & set(used) and not _is_about_first_axis(context):
        return say("the far end of the two links")
    if story.wrist is not None:
        return say("the wrist centre")
    chain = story.algebra.chain
    moved, still = story.derivation.problem.tool_left, identity(story.algebra.ring)
    if moved != still and not chain.task.names_rotation:
        return say("the point of axis {} on the tool's axis", Given(str(chain.dof)))
    if moved != still:
        return say("the origin of frame {}", Given(str(chain.dof)))
    return say("the tool's origin")


OTHERS_DECIDE = "the others decide which values work: all, a few, of which the row has one, or none"
THE_REST = "; rows that are left have the rest of a few"


def others_decide(context: StepContext) -> str:
    """What the rows hold where the other equations decide."""
    return OTHERS_DECIDE + THE_REST if is_left_to_the_pose(context) else OTHERS_DECIDE


def is_left_to_the_pose(context: StepContext) -> bool:
    """Whether rows are compared with the whole pose, which distinguishes values of this angle.

    An arm of fewer joints than the pose has numbers may take it by some values only.
    """
    joints = open_joints(context)
    chosen = (choice for guard in comparisons(context.story.program) for choice in guard.chosen)
    return any(choice.joint in joints for choice in chosen)


def comparisons(program: Program) -> list[Guard]:
    """Where rows have to reproduce the pose, or end."""
    guards = (each for each in program.body if isinstance(each, Guard))
    return [each for each in guards if each.failure is Failure.INCONSISTENT]


def nothing_said(context: StepContext) -> str:
    """What is left of an angle where the equations hold for every value of it."""
    if _decides(context, open_joints(context)):
        subject = "these equations say" if len(context.step.forms) > 1 else "this equation says"
        return f"{subject} nothing about {{}}"
    return "every {} works"


def merged_effect(context: StepContext) -> Prose:
    """Two branches have met."""
    return say(
        "both signs give the same solution; it stands in the rows with {}, and those with {} stay "
        "empty",
        equal(context.sign, ONE),
        equal(context.sign, minus(ONE)),
    )


def free_effect(context: StepContext) -> Prose:
    """A joint takes the seed's value; of a sum of angles it is the sum that does."""
    joints = open_joints(context)
    symbols = joined([say("{}", joint_symbol(joint)) for joint in joints])
    value, taking = "{} takes the seed's value (0 without a seed)", [symbols]
    on_a_line = context.step.kind is Kind.TWO_LENGTHS
    if on_a_line:
        value = "{} take the values on that line nearest to the seed's (each 0 without a seed)"
    elif len(joints) > 1:
        value = "{} takes the value that the seed's {} give it (each 0 without a seed)"
        taking = [say("{}", theta(context.angle)), symbols]
    troubles = ["leads to no solution"] if _decides(context, joints) else []
    limited = limited_in_words(context.story.algebra.chain)
    if limited:
        troubles.append(f"puts {limited} beyond its limits")
    if troubles:
        value += f" or, where that {' or '.join(troubles)}, the nearest value that works"
    parts = [say(value, *taking)]
    if len(joints) > 1 and not on_a_line:
        parts.append(say("the joints themselves follow from it"))
    rows = "are left for other values" if is_left_to_the_pose(context) else "stay empty"
    if context.step.roots == 2:
        parts.append(say(f"the rows with {{}} {rows}", equal(context.sign, minus(ONE))))
    elif context.step.kind is Kind.CIRCLE:
        parts.append(say(f"the rows of the other roots {rows}"))
    remembered = context.remembered if context.step.kind is Kind.ANGLE else None
    if remembered is not None:
        parts.append(say("{}", equal(remembered.letter, ZERO)))
    if context.number < len(context.story.steps):
        parts.append(say("the steps below go on unchanged"))
    return say("{}; {}", parts[0], joined(parts[1:])) if parts[1:] else parts[0]


def limited_in_words(chain: Chain) -> str:
    """What has limits; empty where nothing has."""
    joints = ["a joint"] * any(joint.limits for joint in chain.joints)
    return " or ".join([*joints, *["a sum of joint values"] * bool(chain.sums)])


def _decides(context: StepContext, joints: list[int]) -> bool:
    """Whether a later step, or the pose, may be missed by the value that one of these takes."""
    guards = (each for each in context.story.program.body if isinstance(each, Guard))
    return any(choice.joint in joints for guard in guards for choice in guard.chosen)


def open_joints(context: StepContext) -> list[int]:
    """The joints of the step's angle that no earlier step has given; or the slides themselves."""
    slides = [each.joint for each in context.step.unknowns if isinstance(each, Length)]
    if len(slides) == len(context.step.unknowns):
        return slides
    before = context.story.knowledge[context.number - 1]
    return [joint for joint, _ in context.angle.terms if not before.knows(single(joint))]

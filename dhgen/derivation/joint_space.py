"""What a vanishing combination means for the arm, in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.effects import (
    is_left_to_the_pose,
    nothing_said,
    others_decide,
)
from dhgen.derivation.notation.names import single, theta
from dhgen.derivation.text.blocks import Given, say
from dhgen.derivation.text.words import joined, many
from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.chain import Turn, parallel_groups
from dhgen.kinematics.product import product
from dhgen.kinematics.ring import used_places
from dhgen.kinematics.transform import identity

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.blocks import Prose
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial


def meaning_of_free(context: StepContext, joints: Polynomial | None) -> Prose:
    """What the arm looks like where an angle of type 2 with Z = 0 is free."""
    parallel = _parallel_around(context.story.algebra, joints)
    if parallel is not None and not context.step.degenerate:
        return _sum_that_is_left(context.story.algebra, *parallel)
    works = nothing_said(context)
    if context.step.degenerate or is_left_to_the_pose(context):
        works = f"this equation holds for every {{}}, and {others_decide(context)}"
    if _is_about_first_axis(context):
        text = "{} lies on axis 1, and " + works
        return say(text, point_name(context), theta(context.angle))
    return say(works, theta(context.angle))


def _sum_that_is_left(algebra: Algebra, before: int, behind: int) -> Prose:
    """What is still known of the angles about two axes that are parallel, and those beside them."""
    runs = [
        next(run for run in parallel_groups(algebra.chain) if joint in {each for each, _ in run})
        for joint in (before, behind)
    ]
    axes = f"axes {joined([str(joint) for run in runs for joint, _ in run])} are parallel"
    if all(len(run) == 1 for run in runs):
        return say(f"{axes}, and only the sum or the difference of their angles is determined")
    angles = [theta(AngleSum(run)) for run in runs]
    return say(
        f"{axes}, and the orientation tells only the sum or the difference of {{}} and {{}}",
        *angles,
    )


def meaning_of_root(context: StepContext) -> Prose:
    """What the arm looks like where the two values of a step meet."""
    if _is_about_first_axis(context):
        text = "{} is as close to axis 1 as the offset of the arm allows"
        return say(text, point_name(context))
    given = [str(joint) for joint in context.story.algebra.chain.free]
    ending = f", with {many('joint', given)} as given" if given else ""
    return say(f"the arm is at the edge of its reach{ending}")


def _is_about_first_axis(context: StepContext) -> bool:
    """Whether the equation compares x and y of a point with joint 1."""
    if context.angle != single(1):
        return False
    names = {
        context.story.algebra.ring.symbols[place].name
        for name in "XY"
        for place in used_places(context.polynomial(name))
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
    later = [
        f"{kind}{a.suffix}"
        for a in story.algebra.angles
        for kind in "cs"
        if a.terms[-1][0] > max(joint for joint, _ in context.angle.terms) + 1
    ]
    if set(later) & set(used):
        return say("the far end of the two links")
    if story.wrist is not None:
        return say("the wrist centre")
    chain = story.algebra.chain
    if story.derivation.problem.tool_left and chain.tool != identity(chain.ring):
        return say("the origin of frame {}", Given(str(chain.dof)))
    return say("the tool's origin")


def _parallel_around(algebra: Algebra, joints: Polynomial | None) -> tuple[int, int] | None:
    """The joints before and after a joint that makes them parallel where its sine vanishes.

    (Or its cosine: of the two, the one that `joints` is.)
    """
    if joints is None or len(joints) != 1:
        return None
    used = used_places(joints)
    turning = [a for a in algebra.angles if used & {algebra.index[a.sine], algebra.index[a.cosine]}]
    if len(turning) != 1 or len(turning[0].terms) != 1 or len(used) != 1:
        return None
    k = turning[0].terms[0][0]
    elements = [e for link in algebra.chain.links for e in algebra.lifted(link)]
    places = {e.joint: place for place, e in enumerate(elements) if isinstance(e, Turn)}
    if not {k - 1, k, k + 1} <= set(places):
        return None
    lean = product(elements[places[k - 1] + 1 : places[k + 1]], algebra).rotation[2][2]
    cosine, sine = (algebra.generator(name) for name in (single(k).cosine, single(k).sine))
    straight = cosine if used == {algebra.index[single(k).sine]} else sine
    return (k - 1, k + 1) if lean in (straight, -straight) else None

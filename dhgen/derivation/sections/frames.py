"""Sentences on the choices of frames that matter for the inverse: parallel axes, axes that meet."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.geometry import NEAR, neighbours
from dhgen.derivation.notation.names import cosine, sine, single, theta
from dhgen.derivation.text.blocks import joined, say, sentences
from dhgen.derivation.text.formula import Symbol, add, equal, minus
from dhgen.kinematics.chain import parallel_groups
from dhgen.kinematics.transform import identity

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Prose
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.algebra import AngleSum


C_I, S_I = Symbol("c_i", "cᵢ"), Symbol("s_i", "sᵢ")
SUMS = "{} and {} with several indices are the cosine and the sine of such a sum."


def frame_sentences(story: Story, written: frozenset[Symbol]) -> list[Prose]:
    """A short paragraph for every choice; `written` are the letters of the formulas."""
    return [
        *_notation(story),
        *_parallel(story, written),
        *_meeting(story),
        *_wrist(story),
        *_ends(story),
    ]


def _notation(story: Story) -> list[Prose]:
    if not any(len(angle.terms) == 1 for angle in story.algebra.angles):
        return []
    parts = (
        equal(C_I, Symbol(r"\cos \theta_i", "cos θᵢ")),
        equal(S_I, Symbol(r"\sin \theta_i", "sin θᵢ")),
    )
    return [say("For short, {} and {}.", *parts)]


def _parallel(story: Story, written: frozenset[Symbol]) -> list[Prose]:
    """The axes of every run, and the sums of their angles that the formulas hold."""
    found = []
    first = True
    for run in parallel_groups(story.algebra.chain):
        if len(run) < 2:
            continue
        against = [joint for joint, facing in run if facing < 0]
        text = f"{_axes([joint for joint, _ in run]).capitalize()} are parallel"
        if against:
            other = f"axis {against[0]} points" if len(against) == 1 else f"{_axes(against)} point"
            text += f", but {other} the other way"
        sums = _sums(story, run, written)
        if not sums:
            found.append(say(f"{text}."))
            continue
        text += ": their angles appear as sums"
        if against:
            text += " in which those of opposite axes are subtracted"
        shown = joined([say("{}", equal(theta(each), _sum(each))) for each in sums])
        prose = say(f"{text}, {{}}.", shown)
        if first:
            prose = say(f"{{}} {SUMS}", prose, Symbol("c", "c"), Symbol("s", "s"))
        found.append(prose)
        first = False
    return found


def _sums(
    story: Story, run: tuple[tuple[int, int], ...], written: frozenset[Symbol]
) -> list[AngleSum]:
    """The sums of a run's angles of which the angle, the cosine or the sine is written."""
    joints = {joint for joint, _ in run}
    return [
        angle
        for angle in story.algebra.angles
        if len(angle.terms) > 1
        and {joint for joint, _ in angle.terms} <= joints
        and not written.isdisjoint({theta(angle), cosine(angle), sine(angle)})
    ]


def _axes(joints: list[int]) -> str:
    return f"axes {', '.join(map(str, joints[:-1]))} and {joints[-1]}"


def _sum(angle: AngleSum) -> Formula:
    return add(
        *(theta(single(j)) if sign > 0 else minus(theta(single(j))) for j, sign in angle.terms)
    )


def _meeting(story: Story) -> list[Prose]:
    """Neighbouring axes that meet, without a spherical wrist's."""
    wrist = story.wrist or ()
    pairs = [p for p in neighbours(story.algebra.chain) if p.meet is not None]
    pairs = [p for p in pairs if abs(p.lean) < 1 - NEAR and p.first not in wrist[:2]]
    right = [_axes([p.first, p.first + 1]) for p in pairs if abs(p.lean) < NEAR]
    other = [_axes([p.first, p.first + 1]) for p in pairs if abs(p.lean) >= NEAR]
    found = []
    for group, ending in ((right, " at a right angle"), (other, "")):
        if group:
            if group[1:]:
                names = "; ".join(each.removeprefix("axes ") for each in group)
                start, end = f"Neighbouring axes that meet{ending}", f": {names}"
            else:
                start, end = f"{group[0].capitalize()} meet{ending}", ""
            text = f"{start}, with no link length between them{end}."
            found.append(say(text))
    return [sentences(found)] if found else []


def _wrist(story: Story) -> list[Prose]:
    if story.wrist is None:
        return []
    first, second, third = story.wrist
    text = f"Axes {first}, {second} and {third} meet in one point, the wrist centre: "
    if story.dof == 3:
        text += "turning the joints does not move it."
        return [say(text)]
    return [
        say(
            text + "the wrist is spherical. Turning its joints does not move that point, so its "
            "position depends on the joints before the wrist alone, and the orientation gives the "
            "wrist afterwards."
        )
    ]


def _ends(story: Story) -> list[Prose]:
    """Base Z and tool E, when they are more than nothing."""
    chain = story.algebra.chain
    still = identity(chain.ring)
    found = []
    if chain.base != still:
        text = "The pose of the arm's base in the caller's frame is {}."
        found.append(say(text, Symbol("Z", "Z")))
    if chain.tool != still:
        found.append(say("The pose of the tool in the last frame is {}.", Symbol("E", "E")))
    return [sentences(found)] if found else []

"""Sentences on the choices of frames that matter for the inverse: parallel axes, axes that meet."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.chain import parallel_groups
from dhgen.kinematics.transform import identity
from dhgen.targets.derivation.blocks import say
from dhgen.targets.derivation.formula import Symbol, add, equal, minus
from dhgen.targets.derivation.geometry import NEAR, neighbours
from dhgen.targets.derivation.names import cosine, joint_index, sine, single, theta
from dhgen.targets.derivation.words import many

if TYPE_CHECKING:
    from dhgen.targets.derivation.blocks import Prose
    from dhgen.targets.derivation.formula import Formula
    from dhgen.targets.derivation.story import Story


def frame_sentences(story: Story) -> list[Prose]:
    """One short paragraph for every choice."""
    return [*_notation(story), *_parallel(story), *_meeting(story), *_ends(story)]


def _notation(story: Story) -> list[Prose]:
    turning = [angle for angle in story.algebra.angles if len(angle.terms) == 1]
    if not turning:
        return []
    first = turning[0]
    cos, sin = Symbol(rf"\cos {theta(first).latex}", f"cos {theta(first).text}"), Symbol(
        rf"\sin {theta(first).latex}", f"sin {theta(first).text}"
    )
    return [say("Short forms: {}, {}.", equal(cosine(first), cos), equal(sine(first), sin))]


def _parallel(story: Story) -> list[Prose]:
    found = []
    for run in parallel_groups(story.algebra.chain):
        if len(run) < 2:
            continue
        joints = [str(joint) for joint, _ in run]
        whole = AngleSum(run)
        total = _sum(whole)
        example = equal(theta(whole), total)
        c = equal(cosine(whole), Symbol(rf"\cos {theta(whole).latex}", f"cos {theta(whole).text}"))
        against = [str(joint) for joint, facing in run if facing < 0]
        if against:
            found.append(
                say(
                    f"The {many('axis', joints).replace('axiss', 'axes')} stay parallel, but "
                    f"{many('axis', against).replace('axiss', 'axes')} "
                    f"{'points' if len(against) == 1 else 'point'} the other way: their angles appear "
                    "as sums in which the opposite ones are subtracted, {}, {}.",
                    example, c,
                )
            )
        else:
            found.append(
                say(
                    f"The axes {' and '.join([', '.join(joints[:-1]), joints[-1]])} are parallel: "
                    "their angles appear as sums, {}, {}.",
                    example, c,
                )
            )
    return found


def _sum(angle: AngleSum) -> Formula:
    parts = [theta(single(joint)) for joint, _ in angle.terms]
    signs = [sign for _, sign in angle.terms]
    return add(*(p if s > 0 else minus(p) for p, s in zip(parts, signs, strict=True)))


def _meeting(story: Story) -> list[Prose]:
    chain = story.algebra.chain
    wrist = story.wrist
    found = []
    pairs = [p for p in neighbours(chain) if p.meet is not None and abs(p.lean) < 1 - NEAR]
    inside = set() if wrist is None else {wrist[0], wrist[1]}
    for pair in pairs:
        if pair.first in inside:
            continue
        angle = " at a right angle" if abs(pair.lean) < NEAR else ""
        found.append(say(f"The axes {pair.first} and {pair.first + 1} meet{angle}."))
    if wrist is not None:
        text = (
            f"The axes {wrist[0]}, {wrist[1]} and {wrist[2]} meet in one point, the wrist centre: a "
            "spherical wrist. "
        )
        if chain.dof > 3:
            text += (
                "Turning these joints does not move that point, so its position gives the joints "
                "before the wrist, and the orientation gives the wrist afterwards."
            )
        else:
            text += "Only the orientation of the last frame changes."
        found.append(say(text))
    return found


def _ends(story: Story) -> list[Prose]:
    """Base Z and tool E, when they are more than nothing."""
    chain = story.algebra.chain
    still = identity(chain.ring)
    found = []
    if chain.base != still:
        found.append(
            say("The base frame of the arm stands at {} in the caller's frame.", Symbol("Z", "Z"))
        )
    if chain.tool != still:
        found.append(say("The tool stands at {} in the last frame.", Symbol("E", "E")))
    return found


__all__ = ["frame_sentences", "joint_index"]

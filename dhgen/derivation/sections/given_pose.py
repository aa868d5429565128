"""U_0, what the joints alone have to reach: the given pose without base and tool."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import inverse, target
from dhgen.derivation.text.formula import Symbol, equal, times
from dhgen.kinematics.transform import identity

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Relation

BASE, TOOL = Symbol("Z", "Z"), Symbol("E", "E")
POSE = Symbol(r"\mathit{POS}", "POS")


def moved_left(story: Story) -> tuple[bool, bool]:
    """Whether a base and a tool are moved to the side of the pose."""
    problem, algebra = story.derivation.problem, story.algebra
    still, chain = identity(algebra.ring), algebra.chain
    base = problem.base_left and algebra.lift(chain.base) != still
    return base, problem.tool_left and algebra.lift(chain.tool) != still


def given_pose(story: Story) -> Relation:
    """U_0 = Z^-1 POS E^-1 = (t_ij), without what does not move."""
    base, tool = moved_left(story)
    left, right = [inverse(BASE)] * base, [inverse(TOOL)] * tool
    return equal(target(0), times(*left, POSE, *right), Symbol("(t_{ij})", "(tᵢⱼ)"))

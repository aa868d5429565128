"""A singular pose beside the example's: one joint is moved to where a condition is met."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.example import without_turns
from dhgen.derivation.text.formula import ZERO, Relation
from dhgen.derivation.values import letters_of_joints, value_of
from dhgen.derivation.whole_turns import are_inside, are_kept, keep_their_limits, turned_rows
from dhgen.kinematics.given import given_values
from dhgen.kinematics.numeric import numeric_arm
from dhgen.program.interpret import interpret

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.derivation.example import Example
    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula

ROUND = range(-165, 181, 15)  # degrees that are tried
OTHER_SEEDS = -2.0, 1.0  # [rad, length] of all joints, besides zeros
UNCHANGED = 1e-9  # [rad, arm sizes] a joint's value with another seed
NOTHING = 1e-12  # what a condition is worth there, lengths in arm sizes


@dataclass(frozen=True, slots=True)
class SingularExample:
    """A pose where a step has other than its usual number of values.

    Attributes:
        place: The condition that is met.
        joint: Which joint was moved there, from 1.
        q: Joint values at the pose, (n,).
        T: The pose, (4, 4).
        given: What the caller gives besides it, (k,).
        rows: Joint values by row with a seed of zeros, (B, n), NaN where there is no solution.
        inside: Which rows keep the limits, (B,).
        free: Which rows hold a joint that took the seed's value, (B,).
        exceeding: By row that has such a joint, the joints from 1 that are beyond their limits
            whatever value it takes.
    """

    place: Singularity
    joint: int
    q: FloatArray
    T: FloatArray
    given: FloatArray
    rows: FloatArray
    inside: NDArray[np.bool_]
    free: NDArray[np.bool_]
    exceeding: dict[int, tuple[int, ...]]


def find_singular(
    story: Story, example: Example, places: Sequence[Singularity]
) -> SingularExample | None:
    """The first such pose with round joint values; None if no place has one.

    Places with a free joint come first, and of them a wrist's: there two angles are left with one
    equation.
    """
    arm = numeric_arm(story.algebra.chain)
    for place in sorted(places, key=lambda each: (each.left is None, not each.frees)):
        if not isinstance(place.joints, Relation):
            continue
        for joint, q in _moved(story, example, place.joints):
            T, given = arm.pose(q[None]), given_values(arm, q[None])
            found = interpret(story.program, T, np.zeros((1, arm.chain.dof)), given)
            rows = turned_rows(arm.chain, found.q[0])
            fewer = found.solved[0].sum() < (~np.isnan(example.rows[:, 0])).sum()
            if found.solved.any() and (found.free.any() if place.frees else fewer):
                inside = are_inside(arm.chain, rows)
                free = found.free[0]
                exceeding = _exceeding(story, T, given, rows, free)
                return SingularExample(
                    place, joint, q, T[0], given[0], rows, inside, free, exceeding
                )
    return None


def _exceeding(
    story: Story, T: FloatArray, given: FloatArray, rows: FloatArray, free: NDArray[np.bool_]
) -> dict[int, tuple[int, ...]]:
    """The joints beyond their limits that no seed changes, by row that took the seed's value."""
    chain = story.algebra.chain
    fixed = ~keep_their_limits(chain, rows)
    for seed in OTHER_SEEDS:
        other = interpret(story.program, T, np.full((1, chain.dof), seed), given).q[0]
        fixed &= np.abs(without_turns(chain, other - rows)) <= UNCHANGED
    found = {row: np.flatnonzero(fixed[row]) + 1 for row in np.flatnonzero(free).tolist()}
    return {row: tuple(joints.tolist()) for row, joints in found.items() if len(joints)}


def _moved(story: Story, example: Example, condition: Relation) -> Iterator[tuple[int, FloatArray]]:
    """Joint values that meet a condition, inside the limits: the last joints are moved first."""
    chain = story.algebra.chain
    for joint in reversed(range(chain.dof)):
        if not chain.turning[joint]:
            continue
        for angle in sorted(ROUND, key=abs):
            q = example.q.copy()
            q[joint] = math.radians(angle)
            q = np.where(np.arange(chain.dof) == joint, turned_rows(chain, q[None])[0], q)
            if are_kept(chain, q[None])[0] and _is_met(story, q, condition):
                yield joint + 1, q


def _is_met(story: Story, q: FloatArray, condition: Relation) -> bool:
    """Whether all sides of a condition are zero."""
    letters = letters_of_joints(story, q.tolist())
    sides: list[Formula] = [side for side in condition.sides if side != ZERO]
    size = max(1.0, story.algebra.chain.size)
    try:
        return all(abs(value_of(side, letters)) <= NOTHING * size for side in sides)
    except KeyError:  # the joints alone do not determine it
        return False

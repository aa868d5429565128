"""A pose to work through in numbers: regular, inside the limits, with as many rows as there are."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.whole_turns import are_inside, turned_rows
from dhgen.kinematics.given import given_values
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.turns import TURN
from dhgen.program.interpret import interpret, polynomial, wrap

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.derivation.story import Story
    from dhgen.kinematics.chain import Chain, ChainJoint
    from dhgen.kinematics.numeric import NumericArm
    from dhgen.program.interpret import Polynomial

TRIES = 64
MORE_TRIES = 8  # times as many where sums of joint values have limits
STEP = 5  # joint values are whole multiples of so many degrees
FINE = 0.02  # lengths are multiples of about this part of the arm's size
MARGIN = 0.08  # of a range, kept from its ends
LEAST_PART = 0.2  # of a range of angles that has to be within half a turn to be drawn from there
REGULAR = 0.05  # least singular value of the Jacobian, lengths in arm sizes
APART = 0.1  # of two rows [rad, arm sizes]


@dataclass(frozen=True, slots=True)
class Example:
    """A pose with all its rows.

    Attributes:
        q: Joint values at the pose, (n,).
        T: The pose, (4, 4).
        given: What the caller gives besides it, (k,).
        rows: Joint values by row, (B, n), NaN where there is no solution.
        inside: Which rows keep the limits, (B,).
        followed: The row that is worked through.
        polynomial: Whose roots a step takes.
    """

    q: FloatArray
    T: FloatArray
    given: FloatArray
    rows: FloatArray
    inside: NDArray[np.bool_]
    followed: int
    polynomial: Polynomial | None = None


def find_example(story: Story) -> Example | None:
    """The first pose with the most rows, among some that are drawn; None if none is regular."""
    arm = numeric_arm(story.algebra.chain)
    q = drawn(arm.chain)
    q = q[least_singular(arm, q) > REGULAR]
    if not len(q):
        return None
    T, given = arm.pose(q), given_values(arm, q)
    found = interpret(story.program, T, np.zeros_like(q), given)
    inside = found.solved & are_inside(arm.chain, found.q)
    counts = inside.sum(axis=1) * 100 + found.solved.sum(axis=1)
    good = np.array([_are_apart(arm.chain, rows) for rows in found.q])
    good &= ~found.free.any(axis=1) & ~found.close.any(axis=1) & inside.any(axis=1)
    if not good.any():
        return None
    best = int(np.argmax(np.where(good, counts, -1)))
    away = np.abs(without_turns(arm.chain, found.q[best] - q[best])).max(axis=1)
    followed = int(np.nanargmin(away))
    return Example(
        q[best],
        T[best],
        given[best],
        turned_rows(arm.chain, found.q[best]),
        inside[best],
        followed,
        polynomial(story.program, T[best], np.zeros(arm.chain.dof), given[best]),
    )


def drawn(chain: Chain) -> FloatArray:
    """Joint values in round numbers, inside the limits, (TRIES, n); fewer with limits of sums."""
    source = random.Random(1)  # noqa: S311 - an example, no secret
    if not chain.sums:
        return _drawn(chain, source, TRIES)
    q = _drawn(chain, source, TRIES * MORE_TRIES)
    return turned_rows(chain, q[are_inside(chain, q)][:TRIES])


def _drawn(chain: Chain, source: random.Random, count: int) -> FloatArray:
    """Joint values in round numbers, each inside its limits, (count, n)."""
    digits = -math.floor(math.log10(FINE * chain.size))
    q, slide = np.empty((count, chain.dof)), (0.0, chain.size)
    for row in q:
        for place, (joint, turns) in enumerate(zip(chain.joints, chain.turning, strict=True)):
            low, high = _range_of_angle(chain, joint) if turns else joint.limits or slide
            value = low + (high - low) * source.uniform(MARGIN, 1.0 - MARGIN)
            if turns:
                row[place] = math.radians(STEP * round(math.degrees(value) / STEP))
            else:
                row[place] = round(value, max(digits, 0))
    return q


def _range_of_angle(chain: Chain, joint: ChainJoint) -> tuple[float, float]:
    """Where an angle is drawn: within half a turn; of limits that hardly reach there, in a turn.

    One that is part of a sum with limits has all of its own range: the sum may ask for that.
    """
    low, high = joint.limits or (-math.pi, math.pi)
    if any(limit.factors[joint.number - 1] for limit in chain.sums):
        return low, high
    lowest, highest = max(low, -math.pi), min(high, math.pi)
    if highest - lowest > LEAST_PART * min(high - low, TURN):
        return lowest, highest
    return (low, min(high, low + TURN)) if low > 0.0 else (max(low, high - TURN), high)


def least_singular(arm: NumericArm, q: FloatArray) -> FloatArray:
    """The least singular value of the Jacobian of as many joints as the task takes, (N,)."""
    chain = arm.chain
    scale = np.array([1.0 if turns else chain.size for turns in chain.turning])
    J = arm.jacobian(q) * scale
    J[:, :3] /= chain.size
    rank = min(6, len(chain.solved))
    return np.asarray(np.linalg.svd(J, compute_uv=False)[:, rank - 1])


def without_turns(chain: Chain, off: FloatArray) -> FloatArray:
    """Differences of joint values without whole turns, lengths in arm sizes."""
    return np.asarray(np.where(chain.turning, wrap(off), off / chain.size))


def _are_apart(chain: Chain, rows: FloatArray) -> bool:
    """Whether no two rows (B, n) are next to each other."""
    held = rows[~np.isnan(rows).any(axis=1)]
    one, other = np.triu_indices(len(held), 1)
    gaps = np.abs(without_turns(chain, held[one] - held[other])).max(axis=1)
    return bool(gaps.min(initial=np.inf) > APART)

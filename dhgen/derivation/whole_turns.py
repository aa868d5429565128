"""The whole turns that solvers give joint values with a seed of zeros, and which rows keep limits.

Angles are in (-pi, pi], what is half a turn but for rounding is pi; those that exceed their limits
are inside them where whole turns take them there. The turns of drives that hang together are chosen
together: inside all limits, those of sums among them, and then nearest to zero.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.turns import TURN, coupled_turns, joints_alone
from dhgen.program.interpret import wrap

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.turns import CoupledTurns

NEAR_HALF_TURN = 1e-9  # so near to -pi angles are pi [rad]
MOST_TURNS = {1: 4, 2: 4, 3: 4, 4: 2}  # of so many drives to each side, and of more:
TURNS_OF_MANY = 1


def turned_rows(chain: Chain, q: FloatArray) -> FloatArray:
    """Rows (..., n) with the whole turns that a solver gives them with a seed of zeros."""
    rows = _turned_alone(chain, q)
    together = coupled_turns(chain)
    if together is not None:
        for row in rows.reshape(-1, chain.dof):
            nearest = _turned_together(chain, together, row)
            row[:] = row if nearest is None else nearest
    return rows


def are_inside(chain: Chain, q: FloatArray) -> NDArray[np.bool_]:
    """Which rows (..., n) keep the limits, whole turns aside."""
    together = coupled_turns(chain)
    if together is None:
        return np.asarray(keep_their_limits(chain, q).all(axis=-1))
    rows = _turned_alone(chain, q).reshape(-1, chain.dof)
    kept = [_turned_together(chain, together, row) is not None for row in rows]
    return np.array(kept, bool).reshape(q.shape[:-1])


def keep_their_limits(chain: Chain, q: FloatArray) -> NDArray[np.bool_]:
    """Which joints of rows (..., n) keep their own limits, whole turns aside."""
    kept = np.ones(q.shape, bool)
    for place, (joint, turns) in enumerate(zip(chain.joints, chain.turning, strict=True)):
        if joint.limits is not None:
            low, high = joint.limits
            value = q[..., place]
            if turns:
                value = low + np.remainder(value - low, TURN)
            kept[..., place] = (low <= value) & (value <= high)
    return kept


def are_kept(chain: Chain, q: FloatArray) -> NDArray[np.bool_]:
    """Which rows (N, n) keep all limits as they are, those of sums among them."""
    kept = np.ones(len(q), bool)
    for place, joint in enumerate(chain.joints):
        kept &= _are_within(joint.limits, q[:, place])
    for limit in chain.sums:
        kept &= _are_within((limit.lowest, limit.highest), q @ np.array(limit.factors))
    return kept


def _turned_alone(chain: Chain, q: FloatArray) -> FloatArray:
    """Rows of which each angle is moved for itself."""
    rows = np.array(np.where(chain.turning, wrap(q - NEAR_HALF_TURN) + NEAR_HALF_TURN, q))
    for place, (joint, turns) in enumerate(zip(joints_alone(chain), chain.turning, strict=True)):
        if joint.limits is None or not turns:
            continue
        low, high = joint.limits
        value = rows[..., place]
        above = np.ceil((value - high - NEAR_HALF_TURN) / TURN)
        moved = value - TURN * np.maximum(above, 0.0)
        below = np.ceil((low - moved - NEAR_HALF_TURN) / TURN)
        moved += TURN * np.maximum(below, 0.0)
        rows[..., place] = np.where(moved <= high + NEAR_HALF_TURN, moved, value)
    return rows


def _turned_together(chain: Chain, together: CoupledTurns, row: FloatArray) -> FloatArray | None:
    """The copy of a row inside all limits that is nearest to zero; None where none is inside."""
    if np.isnan(row).any():
        return None
    copies = row[None]
    most = MOST_TURNS.get(len(together.drives), TURNS_OF_MANY)
    for drive, move in zip(together.drives, together.moves, strict=True):
        turns = np.floor(0.5 - copies[:, drive - 1] / TURN)  # to where it is nearest to zero
        limits = chain.joints[drive - 1].limits
        if limits is not None:
            least, greatest = limits[0] - NEAR_HALF_TURN, limits[1] + NEAR_HALF_TURN
            turns = np.maximum(turns, np.ceil((least - copies[:, drive - 1]) / TURN))
            turns = np.minimum(turns, np.floor((greatest - copies[:, drive - 1]) / TURN))
        tried = turns[:, None] + np.arange(-most, most + 1)
        copies = (copies[:, None] + tried[..., None] * np.array(move)).reshape(-1, chain.dof)
        copies = copies[_are_within(chain.joints[drive - 1].limits, copies[:, drive - 1])]
    copies = copies[are_kept(chain, copies)]
    if not len(copies):
        return None
    units = np.where(chain.turning, 1.0, chain.size)
    return np.asarray(copies[np.square(copies / units).sum(axis=1).argmin()])


def _are_within(limits: tuple[float, float] | None, value: FloatArray) -> NDArray[np.bool_]:
    """Which values keep limits, but for rounding."""
    low, high = limits or (-np.inf, np.inf)
    kept = (low - NEAR_HALF_TURN <= value) & (value <= high + NEAR_HALF_TURN)
    return np.asarray(kept)

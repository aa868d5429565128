"""The rows of solutions of an arm near one with a structure, as the runtime places them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.numeric import numeric_arm
from dhgen.program.interpret import interpret, wrap
from dhgen.runtime.plain import plain
from dhgen.runtime.python.status import UNREACHABLE

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.nominal.nominal import Nominal


def placed_by_posture(chain: Chain, nominal: Nominal, q: FloatArray) -> FloatArray:
    """Rows of joint values, each in the row of its posture, (B, n), NaN where there is none.

    Args:
        chain: The arm.
        nominal: The nearest arm with a structure.
        q: Solutions of one pose by ascending joint values in the first rows, NaN in the others.
    """
    postures = plain("general.postures")
    solved = ~np.isnan(q).any(axis=1)
    found = np.full(len(q), -1)
    for row in np.flatnonzero(solved).tolist():
        found[row] = _posture(chain, nominal, q[row], postures.SAME_POSTURE)
    placed = q.copy()
    status = np.where(solved, 0, UNREACHABLE).astype(np.uint8)
    postures.place_rows(found, nominal.solver.rows, placed, status)
    return placed


def _posture(chain: Chain, nominal: Nominal, q: FloatArray, same: float) -> int:
    """The row of the nearest arm that has these joint values; -1 where none does."""
    free = [number - 1 for number in nominal.chain.free]
    near = np.array(chain.drives.values(q)) + np.array(nominal.nearest.offsets)
    near[free] = q[free]
    T = numeric_arm(nominal.chain).pose(near[None])
    rows = interpret(nominal.solver, T, np.zeros_like(near), q[free])
    off = np.abs(wrap(rows.q[0] - near)).max(axis=1)
    off[np.isnan(off) | rows.free[0] | rows.close[0]] = np.inf
    return int(off.argmin()) if off.min() < same else -1

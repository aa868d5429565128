"""Solutions that an arm can take one after the other without meeting a singular place between.

Where det J vanishes two solutions meet, so one might think that a change between two passes through
such a place. Of cuspidal arms (P. Wenger) it does not. Where three turning joints place a point,
det J depends on joints 2 and 3 alone, and two solutions are joined if they lie in one region of
these two angles.
"""

from __future__ import annotations

import math
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain

CELLS = 180  # of a turn
JOINTS = 3


def joined_rows(chain: Chain, rows: FloatArray) -> tuple[int, int] | None:
    """Two solutions of one pose with a way between them on which det J keeps its sign.

    Args:
        chain: The arm.
        rows: Joint values by row, (B, n), NaN where there is no solution.

    Returns:
        Their rows; None where there are none, or for arms with other joints, limits or tasks.
    """
    free = all(chain.turning) and not any(joint.limits for joint in chain.joints)
    if chain.dof != JOINTS or not free or chain.is_coupled:
        return None
    if chain.task.kind is not TaskKind.POSITION:
        return None
    step = 2.0 * math.pi / CELLS
    regions = _regions(_determinants(chain, step))
    found = np.flatnonzero(np.isfinite(rows).all(axis=1))
    nodes = np.round(rows[found, 1:] / step).astype(int) % CELLS
    for (i, one), (j, other) in combinations(enumerate(map(tuple, nodes)), 2):
        if regions[one] and regions[one] == regions[other]:
            return int(found[i]), int(found[j])
    return None


def _determinants(chain: Chain, step: float) -> FloatArray:
    """det J by the angles of joints 2 and 3, (CELLS, CELLS)."""
    angles = np.arange(CELLS) * step
    second, third = np.meshgrid(angles, angles, indexing="ij")
    q = np.stack([np.zeros_like(second), second, third], axis=-1).reshape(-1, JOINTS)
    J = numeric_arm(chain).jacobian(q)[:, :3]
    return np.asarray(np.linalg.det(J).reshape(CELLS, CELLS))


def _regions(determinants: FloatArray) -> NDArray[np.intp]:
    """Numbers of regions, from 1; 0 where det J may vanish within a cell."""
    change = np.zeros_like(determinants)
    for shift in ((0, 1), (1, 0), (1, 1), (1, -1)):
        across = np.abs(determinants - np.roll(determinants, shift, (0, 1)))
        back = np.roll(across, (-shift[0], -shift[1]), (0, 1))
        change = np.maximum(change, np.maximum(across, back))
    open_ = np.abs(determinants) > change
    regions = np.zeros(determinants.shape, int)
    count = 0
    for start in zip(*np.nonzero(open_), strict=True):
        if regions[start]:
            continue
        count += 1
        pending = [start]
        regions[start] = count
        while pending:
            i, j = pending.pop()
            for place in ((i - 1, j), ((i + 1) % CELLS, j), (i, j - 1), (i, (j + 1) % CELLS)):
                if open_[place] and not regions[place]:
                    regions[place] = count
                    pending.append((place[0] % CELLS, place[1] % CELLS))
    return regions

"""Whether the answers are right: every row through one forward model, all tools' rows together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from benchmarks.arms import Arm
    from benchmarks.contestant import Contestant
    from dhgen.arrays import FloatArray

RIGHT = 1e-6  # largest error of an entry of the pose: what any controller would accept
SAME = 1e-4  # rows whose joint values differ by less are one solution


@dataclass(frozen=True, slots=True)
class Quality:
    """What a contestant's answers are worth.

    Attributes:
        found: Share of the solutions that it found; all are those that anybody found.
        residual: Largest error of an entry of the pose among its right rows.
        wrong: Share of its rows that are none.
        aligned: Share of the poses with joints at multiples of a quarter turn that it answered.
    """

    found: float
    residual: float
    wrong: float
    aligned: float


def judge_all(
    arm: Arm, contestants: Sequence[Contestant], T: FloatArray, aligned: FloatArray
) -> list[Quality]:
    """Judges the answers for random poses and for aligned ones, both (N, 4, 4)."""
    answers = [_Answers.of(arm, each.solve(T), T) for each in contestants]
    corners = [_Answers.of(arm, each.solve(aligned), aligned) for each in contestants]
    known = [
        _distinct([row for each in answers for row in each.right[k]], arm) for k in range(len(T))
    ]
    total = sum(map(len, known))
    return [
        Quality(
            found=sum(len(_distinct(list(rows), arm)) for rows in mine.right) / max(total, 1),
            residual=mine.residual,
            wrong=mine.wrong / max(mine.rows, 1),
            aligned=sum(len(rows) > 0 for rows in corner.right) / len(aligned),
        )
        for mine, corner in zip(answers, corners, strict=True)
    ]


@dataclass(frozen=True, slots=True)
class _Answers:
    """Right rows of every pose, and how the rest did."""

    right: list[FloatArray]
    residual: float
    wrong: int
    rows: int

    @classmethod
    def of(cls, arm: Arm, answers: list[FloatArray], T: FloatArray) -> _Answers:
        right, residual, wrong, rows = [], 0.0, 0, 0
        for q, pose in zip(answers, T, strict=True):
            if not len(q):
                right.append(np.empty((0, arm.dof)))
                continue
            miss = np.abs(arm.model.pose(q) - pose).max(axis=(1, 2))
            good = miss <= RIGHT
            residual = max(residual, *miss[good], 0.0)
            wrong += int(np.count_nonzero(~good))
            rows += len(q)
            right.append(q[good])
        return cls(right, residual, wrong, rows)


def _distinct(rows: list[FloatArray], arm: Arm) -> list[FloatArray]:
    """Each solution once; angles that differ by whole turns are the same."""
    kept: list[FloatArray] = []
    turning = np.array(arm.turning)
    for row in rows:
        if kept:
            gap = np.array(kept) - row
            gap = np.where(turning, np.angle(np.exp(1j * gap)), gap)
            if np.abs(gap).max(axis=1).min() < SAME:
                continue
        kept.append(row)
    return kept

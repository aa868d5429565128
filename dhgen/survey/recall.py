"""Recall: whether the joint values that make a pose are among its rows, on very many poses.

Counting all solutions takes a search for each pose, so it is done on hundreds of them. A place
where a solver loses solutions may be far smaller than that sees. Recall needs no search: the joint
values that a pose was made from are one of its solutions, whatever the others are.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.oracle.poses import random_joints
from dhgen.survey.singular import is_redundant, task_jacobian

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.survey.trial import Trial

AT_ONCE = 5_000  # poses of one batch, for the sake of memory
# Of joint values and the nearest row [rad or arm sizes]: rounding over the least singular value,
# where that is SINGULAR, leaves 1e-9 of them.
SAME = 1e-5
# Least singular value of the task's Jacobian, lengths in arm sizes. Below it a pose is singular to
# rounding: there a double root may be one row, half way between two solutions.
SINGULAR = 1e-7
SHOWN = 5  # lost poses that are reported


@dataclass(frozen=True, slots=True)
class Recall:
    """How many random poses have the joint values that made them among their rows.

    Attributes:
        poses: That were tried.
        recalled: Those with the joint values among their rows, and the singular ones.
        faults: The first lost poses, each with its least singular value.
    """

    poses: int
    recalled: int
    faults: tuple[str, ...]


def ask_recall(trial: Trial, count: int) -> Recall:
    """Recall on `count` random poses without a seed; of redundant arms nothing is asked."""
    if is_redundant(trial.robot):
        return Recall(0, 0, ())
    lost: list[tuple[FloatArray, float]] = []
    q = random_joints(trial.robot, count, seed=7)
    for start in range(0, count, AT_ONCE):
        lost += _lost(trial, q[start : start + AT_ONCE])
    faults = [
        f"recall: lost, least singular value {s:.1e}, q = {each.tolist()}" for each, s in lost
    ]
    if len(lost) > SHOWN:
        faults[SHOWN:] = [f"recall: and {len(lost) - SHOWN} more"]
    return Recall(count, count - len(lost), tuple(faults))


def _lost(trial: Trial, q: FloatArray) -> list[tuple[FloatArray, float]]:
    """Regular joint vectors that are not among the rows of their poses, and how regular."""
    rows, _ = trial.solver.batch(trial.poses(q), trial.given(q))
    apart = trial.apart(rows, q[:, None])
    missed = q[~(np.nanmin(np.where(np.isnan(apart), np.inf, apart), axis=1) <= SAME)]
    units = np.where(trial.model.revolute, 1.0, trial.size)
    J = task_jacobian(trial.model.divided_by(trial.size), trial.robot, missed / units)
    least = np.linalg.svd(J, compute_uv=False).min(axis=-1, initial=np.inf)
    return [(each, s) for each, s in zip(missed, least, strict=True) if s > SINGULAR]

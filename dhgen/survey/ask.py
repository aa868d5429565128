"""What a solver is asked: every solution on random poses, an answer on every singular one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.oracle.poses import random_joints
from dhgen.status import Status
from dhgen.survey.singular import RIGHT_ANGLES, in_a_family, is_redundant, singular_sets

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray
    from dhgen.survey.trial import Trial

SAME = 1e-5  # [rad or arm sizes] a row and a solution of the oracle's
TWICE = 1e-7  # the same of two rows: nearer than this they are one
RECOVERED = 1e-3  # the same of a singular solution: it is known to a root of rounding only
SHOWN = 3  # faults of one kind that are printed


@dataclass(frozen=True, slots=True)
class Random:
    """How many solutions random poses have, and how many of them the rows hold."""

    expected: int
    found: int
    spurious: int
    unmet: int
    residual: float
    faults: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Singular:
    """How many poses of singular kinds were answered."""

    poses: int
    answered: int
    residual: float
    faults: tuple[str, ...]


class Tally:
    """Counts the rows of random poses against the oracle's solutions, one to one.

    Args:
        bound: What a row may miss its pose by [arm sizes].
    """

    def __init__(self, bound: float) -> None:
        self._bound = bound
        self._expected = self._found = self._spurious = self._unmet = 0
        self._residual = 0.0
        self._faults: list[str] = []

    def add(
        self,
        trial: Trial,
        T: FloatArray,
        rows: FloatArray,
        start: FloatArray,
        number: int,
        where: str,
    ) -> None:
        """The rows of a pose.

        Args:
            trial: The arm.
            T: The pose.
            rows: The joint values of its rows.
            start: Joint values at which the oracle's search begins, among others.
            number: Of the pose, by which the search draws.
            where: The name of the pose in faults.
        """
        residuals = trial.residuals(rows, T)
        self._residual = max(self._residual, float(residuals.max(initial=0.0)))
        true = distinct(trial, rows[residuals <= self._bound])
        self._spurious += len(rows) - len(true)
        if len(rows) > len(true):
            self._faults.append(f"{len(rows) - len(true)} spurious, {where}")
        if is_redundant(trial.robot):  # of a family one is expected
            self._expected += 1
            self._found += len(true) > 0
            return
        held = trial.search(T, start, seed=number, at_least=len(true))
        lost = missed(trial, held.regular, true, SAME)
        met = np.concatenate([held.regular, held.singular])
        self._expected += len(held.regular)
        self._found += len(held.regular) - lost
        self._unmet += sum(not among(trial, row, met, SAME) for row in true)
        if lost:
            self._faults.append(f"{lost} of {len(held.regular)} missed, {where}")

    def counted(self) -> Random:
        """What was counted."""
        counts = self._expected, self._found, self._spurious, self._unmet
        return Random(*counts, self._residual, _shown("random", self._faults))


def ask_random(trial: Trial, count: int, bound: float) -> Random:
    """Compares the rows with the oracle's solutions, one to one; of a family one is expected."""
    tally = Tally(bound)
    q = random_joints(trial.robot, count, seed=1)
    for number, (joints, T) in enumerate(zip(q, trial.poses(q), strict=True)):
        rows, _ = trial.solve(T, joints)
        tally.add(trial, T, rows, joints, number, f"q = {joints.tolist()}")
    return tally.counted()


def ask_singular(trial: Trial, count: int, bound: float) -> Singular:
    """Every pose is to have a row, every row to reach it, and the joints to be among the rows.

    Where a joint is indeterminate it takes the seed's value, and the seed are the joints: they
    are found again. Of a family of solutions in which no single joint is indeterminate any
    members will do. At right angles and beside them every isolated solution of the oracle's is to
    be among the rows, too.
    """
    poses = answered = 0
    worst = 0.0
    messages: list[str] = []
    redundant = is_redundant(trial.robot)
    for kind, q in singular_sets(trial.robot, count).items():
        faults = []
        for joints, T in zip(q, trial.poses(q), strict=True):
            rows, status = trial.solve(T, joints)
            residual = float(trial.residuals(rows, T).max(initial=0.0))
            worst = max(worst, residual)
            fault = ""
            if not len(rows):
                fault = "no row"
            elif residual > bound:
                fault = f"residual {residual:.1e}"
            elif (
                not among(trial, joints, rows, RECOVERED)
                and Status.FREE_JOINT not in status
                and not (redundant or in_a_family(trial.robot, joints))
            ):
                fault = f"q found again only to within {trial.apart(rows, joints).min():.1e}"
            elif RIGHT_ANGLES in kind and not redundant:
                held = trial.search(T, joints).regular
                lost = missed(trial, held, rows, RECOVERED)
                fault = f"{lost} of {len(held)} missed" if lost else ""
            answered += not fault
            faults += [f"{fault}, q = {joints.tolist()}"] if fault else []
        poses += len(q)
        messages += _shown(kind, faults)
    return Singular(poses, answered, worst, tuple(messages))


def missed(trial: Trial, solutions: FloatArray, rows: FloatArray, near: float) -> int:
    """How many solutions are not among the rows."""
    return sum(not among(trial, one, rows, near) for one in solutions)


def distinct(trial: Trial, rows: FloatArray) -> FloatArray:
    """Rows without repetitions."""
    kept: list[int] = []
    for i, row in enumerate(rows):
        if not among(trial, row, rows[kept], TWICE):
            kept.append(i)
    return np.asarray(rows[kept])


def among(trial: Trial, one: FloatArray, others: FloatArray, near: float) -> bool:
    """Whether a solution is one of several."""
    return bool(trial.apart(others, one).min(initial=np.inf) <= near)


def _shown(kind: str, faults: Sequence[str]) -> tuple[str, ...]:
    left = len(faults) - SHOWN
    more = (f"{kind}: and {left} more",) if left > 0 else ()
    return (*(f"{kind}: {fault}" for fault in faults[:SHOWN]), *more)

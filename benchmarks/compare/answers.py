"""What two solvers answer to the same questions, and what differs between them.

A call differs where a bit of its values, a status or what is returned does; NaN is NaN whatever
its bits are. Two sets of solutions are equal if they have as many rows with joint values, each of
which has a partner within a tolerance, whole turns apart.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from benchmarks.compare.poses import changed, joint_values

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from benchmarks.compare.libraries import Answer, Library
    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot

NO_SEED, ANY_SEED, OWN_SEED = "without a seed", "any seed", "its own seed"


class Solver(Protocol):
    """What is asked: the C of a folder, or its Python."""

    def fk(self, q: FloatArray, /) -> NDArray[Any]:
        """Poses (N, 4, 4) of joint values (N, n)."""

    def jacobian(self, q: FloatArray, /) -> NDArray[Any]:
        """Jacobians (N, 6, n) of joint values (N, n)."""

    def ik(self, T: FloatArray, given: FloatArray, seed: FloatArray | None, /) -> Answer:
        """All rows of poses (N, 4, 4); statuses and what is returned."""

    def nearest(self, T: FloatArray, given: FloatArray, seed: FloatArray, /) -> Answer:
        """The row nearest to a seed, and what is returned."""

    def batch(self, T: FloatArray, given: FloatArray, /) -> Answer:
        """All rows of poses (N, 4, 4), and statuses."""


@dataclass(frozen=True, slots=True)
class Question:
    """Poses of one kind.

    Attributes:
        kind: What they have in common.
        q: The joint values that made them, shape (N, n).
        T: The poses, shape (N, 4, 4).
        given: What the caller gives besides, shape (N, k).
        seeds: Random seeds, shape (N, n).
    """

    kind: str
    q: FloatArray
    T: FloatArray
    given: FloatArray
    seeds: FloatArray


@dataclass(frozen=True, slots=True)
class Difference:
    """Between two answers to one question.

    Attributes:
        kind: Of the poses.
        call: What was called.
        calls: How often.
        differ: In how many calls any bit, status or returned number differs.
        statuses: In how many a status or returned number does.
        sets: In how many the sets of solutions are not equal; None for what has no rows.
        worst: The largest difference of two values that are both finite, whole turns apart.
    """

    kind: str
    call: str
    calls: int
    differ: int
    statuses: int
    sets: int | None
    worst: float


def questions(robot: Robot, library: Library, count: int) -> list[Question]:
    """What both are asked: poses as a library makes them of joint values."""
    asked = []
    for joints in joint_values(robot, count):
        T = changed(joints.kind, library.fk(joints.q))
        asked.append(Question(joints.kind, joints.q, T, library.given(joints.q), joints.seeds))
    return asked


def fewer(asked: list[Question], count: int) -> list[Question]:
    """At most so many poses of every kind, spread evenly over them."""
    parts = []
    for each in asked:
        pick = np.unique(np.linspace(0, len(each.q) - 1, min(count, len(each.q))).astype(int))
        arrays = (each.q, each.T, each.given, each.seeds)
        parts.append(Question(each.kind, *(array[pick] for array in arrays)))
    return parts


def ask(solver: Solver, question: Question) -> dict[str, Answer]:
    """Everything that a solver answers, by what was called."""
    q, T, given = question.q, question.T, question.given
    none = np.zeros((len(q), 0), np.int64)
    answers = {"fk": (solver.fk(q), none), "jacobian": (solver.jacobian(q), none)}
    seeds = {NO_SEED: None, ANY_SEED: question.seeds, OWN_SEED: q}
    for name, seed in seeds.items():
        answers[f"ik, {name}"] = solver.ik(T, given, seed)
        if seed is not None:
            answers[f"ik_nearest, {name}"] = solver.nearest(T, given, seed)
    return answers | {"ik_batch": solver.batch(T, given)}


def differences(
    kind: str, old: dict[str, Answer], new: dict[str, Answer], turning: FloatArray, tolerance: float
) -> Iterator[Difference]:
    """One for every call; `turning` tells which joints (n,) have whole turns."""
    for call, (values, states) in old.items():
        others, other_states = new[call]
        has_joints = call.startswith("ik")
        gap = _gaps(values, others, turning if has_joints else np.zeros(values.shape[-1]))
        statuses = (states != other_states).any(axis=1)
        differ = statuses | ~_same_bits(values, others)
        both = np.isfinite(values) & np.isfinite(others)
        worst = float(gap[both].max(initial=0.0))
        sets = None
        if has_joints and values.ndim == 3:
            sets = sum(
                not same_set(values[k], others[k], turning, tolerance)
                for k in np.flatnonzero(differ)
            )
        counts = len(values), int(differ.sum()), int(statuses.sum())
        yield Difference(kind, call, *counts, sets, worst)


def same_set(rows: FloatArray, others: FloatArray, turning: FloatArray, tolerance: float) -> bool:
    """Whether rows (B, n), NaN where there is no solution, are the same solutions."""
    rows, others = (each[~np.isnan(each).any(axis=1)] for each in (rows, others))
    if len(rows) != len(others):
        return False
    if not len(rows):
        return True
    gaps = _gaps(rows[:, None], others[None], turning).max(axis=-1)
    return bool((gaps.min(axis=0) <= tolerance).all() and (gaps.min(axis=1) <= tolerance).all())


def _same_bits(values: NDArray[Any], others: NDArray[Any]) -> NDArray[np.bool_]:
    """Whether calls (N, ...) gave the same numbers, to the sign of zeros."""
    same = (values == others) & (np.signbit(values) == np.signbit(others))
    same |= np.isnan(values) & np.isnan(others)
    return np.asarray(same.reshape(len(values), -1).all(axis=1))


def _gaps(values: NDArray[Any], others: NDArray[Any], turning: FloatArray) -> FloatArray:
    """How far values are apart, angles by less than half a turn."""
    with np.errstate(invalid="ignore"):
        gap = np.abs(np.asarray(values, float) - np.asarray(others, float))
        turns = np.abs(gap - 2 * pi * np.round(gap / (2 * pi)))
    return np.asarray(np.where(turning.astype(bool), turns, gap))

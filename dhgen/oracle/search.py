"""A search for all inverse kinematic solutions of a pose, downhill from very many starts.

Nothing here depends on a robot's structure: it is slow, plain, and finds for any arm and any task
what a closed form must also find. Random starts go on, batch after batch, until several batches in
a row brought nothing new and every solution has been met more than once.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.oracle.descent import descend, refine
from dhgen.oracle.problem import Problem, state

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, NDArray

    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot

BATCH = {1: 32, 2: 32, 3: 64}  # starts at once, by the number of joints to find
LARGEST_BATCH = 128
QUIET_BATCHES = 3  # batches in a row without a new solution before the search ends
TIMES_MET = 3  # where a solution is met less often others may be missing
MOST_BATCHES = 40

SAME = 1e-7  # solutions closer than this [rad, or arm sizes] are one
SAME_SINGULAR = 1e-4  # a double root is known only to the square root of rounding


@dataclass(frozen=True, slots=True)
class Found:
    """The solutions of one pose, sorted; revolute joints lie in (-pi, pi].

    Attributes:
        regular: (k, n), isolated and simple.
        singular: (m, n), where the task's Jacobian loses rank to 1e-7: double roots (an arm
            stretched or folded), and points out of a continuum of solutions.
    """

    regular: FloatArray
    singular: FloatArray


@dataclass(frozen=True, slots=True)
class _Places:
    """Joint vectors, and how many starts ended there."""

    q: FloatArray
    times: NDArray[np.intp]

    def __getitem__(self, chosen: NDArray[np.bool_]) -> _Places:
        return _Places(self.q[chosen], self.times[chosen])


def solve(
    robot: Robot,
    T: ArrayLike,
    q_free: Sequence[float] = (),
    *,
    seed: int = 0,
    at_least: int = 0,
) -> Found:
    """Every isolated, simple solution, and the singular ones that the search came across.

    They may be inside the joint limits or not.

    Args:
        robot: The robot; its task names the entries of T that count, its `free` the joints that are
            given.
        T: Pose of the tool in the base, shape (4, 4).
        q_free: Values of the free joints [rad or length], in the order of `robot.free`, or the arm
            angle.
        seed: Of the random starts; the answer should not depend on it.
        at_least: A search that has found fewer goes on for as long as it may.
    """
    problem = state(robot, np.asarray(T, dtype=float), q_free)
    random = np.random.default_rng(seed)
    batch = BATCH.get(len(problem.moving), LARGEST_BATCH)
    nowhere = _Places(np.empty((0, len(problem.q))), np.empty(0, np.intp))
    regular = singular = nowhere
    quiet = 0
    for _ in range(MOST_BATCHES):
        known = len(regular.q)
        ends = descend(problem, problem.starts(batch, random))
        places = _merge(problem, nowhere, _Places(ends, np.ones(len(ends), np.intp)), SAME)
        # most starts end where others have ended: only new places need their last digits
        old = _among(problem, places.q, regular.q)
        regular = _merge(problem, regular, places[old], SAME)
        q, solved, simple = refine(problem, places.q[~old])
        new = _Places(q, places.times[~old])
        regular = _merge(problem, regular, new[simple], SAME)
        singular = _merge(problem, singular, new[solved & ~simple], SAME_SINGULAR)
        quiet = quiet + 1 if len(regular.q) == known else 0
        enough = len(regular.q) >= at_least and np.all(regular.times >= TIMES_MET)
        if quiet >= QUIET_BATCHES and enough:
            break
    return Found(_handed_out(problem, regular.q), _handed_out(problem, singular.q))


def _merge(problem: Problem, known: _Places, found: _Places, same: float) -> _Places:
    """Known places first, then new ones; starts that ended in one place are counted together."""
    q, times = known.q, known.times.copy()
    while len(found.q):
        pivot = _wrapped(problem, found.q[:1])
        alike = np.abs(_wrapped(problem, found.q - pivot)).max(axis=1) < same
        count = found[alike].times.sum()
        match = np.flatnonzero(np.abs(_wrapped(problem, q - pivot)).max(axis=1, initial=0.0) < same)
        if len(match):
            times[match[0]] += count
        else:
            q, times = np.concatenate([q, pivot]), np.append(times, count)
        found = found[~alike]
    return _Places(q, times)


def _among(problem: Problem, places: FloatArray, known: FloatArray) -> NDArray[np.bool_]:
    """Which places (N, n) are known ones (k, n)."""
    gaps = np.abs(_wrapped(problem, places[:, None] - known)).max(axis=2)
    return np.asarray((gaps < SAME).any(axis=1))


def _wrapped(problem: Problem, q: FloatArray) -> FloatArray:
    """Revolute joints modulo a turn, into (-pi, pi]."""
    turned = -np.remainder(-q + np.pi, 2 * np.pi) + np.pi
    outside = (q > np.pi) | (q <= -np.pi)
    return np.where(problem.model.revolute & outside, turned, q)


def _handed_out(problem: Problem, q: FloatArray) -> FloatArray:
    """In the file's units, the free joints exactly as given, and in order."""
    free = np.setdiff1d(np.arange(q.shape[1]), problem.moving)
    q[:, free] = problem.q[free]
    # rounded first, so that digits beyond the accuracy do not decide the order
    order = np.lexsort(np.round(q.T, 6)[::-1])
    handed_out: FloatArray = q[order] * problem.units
    return handed_out if problem.drives is None else handed_out @ problem.drives.T

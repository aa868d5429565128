"""From starts to solutions: Levenberg-Marquardt downhill, Gauss-Newton for the last digits."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.oracle.levenberg_marquardt import (
    CONVERGED,
    EASED,
    FIRST_DAMPING,
    LEAST_DAMPING,
    MOST_DAMPING,
    RAISED,
    STEPS,
    follow,
)

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.oracle.problem import Problem

# Beside a singular pose runs a valley whose floor is nearly a solution. The normal equations
# cannot see along it, so what ends in one is left to the last digits' better arithmetic.
NEARLY = 1e-10  # squared residual

POLISHING_STEPS = 40  # a double root gains one binary digit a step
STILL = 1e-14  # a step of this size [rad, or arm sizes] is rounding
NOTHING_MOVES = 1e-12  # a singular value that is rounding, relative to the largest
POLISHED = 1e-12  # residual of every solution, lengths in units of the arm
REGULAR = 1e-7  # least singular value of the task's Jacobian at an isolated, simple solution


def descend(problem: Problem, q: FloatArray) -> FloatArray:
    """Follow starts (N, n) downhill; returns the ends (M, n) that reach the pose, or nearly."""
    ends = q.copy()
    if problem.elbow is not None or problem.model.is_coupled:
        return _damped(problem, ends)
    squares = follow(
        *problem.tables,
        problem.model.revolute,
        np.flatnonzero(problem.entries),
        problem.target,
        problem.moving,
        ends,
    )
    return ends[squares < NEARLY]


def _damped(problem: Problem, q: FloatArray) -> FloatArray:
    """Damped steps of all starts at once, for errors that are more than entries of a pose."""
    damping = np.full(len(q), FIRST_DAMPING)
    error, J = problem.residual(q)
    cost = _squares(error)
    still = np.eye(J.shape[2])
    for _ in range(STEPS):
        going = np.flatnonzero((cost > CONVERGED) & (damping < MOST_DAMPING))
        if not len(going):
            break
        e, j = error[going], J[going]
        gradient = np.einsum("kmi,km->ki", j, e)
        normal = np.swapaxes(j, 1, 2) @ j + damping[going, None, None] * still
        trial = q[going]
        trial[:, problem.moving] -= np.linalg.solve(normal, gradient[..., None])[..., 0]
        reached, rates = problem.residual(trial)
        squares = _squares(reached)
        gains = squares < cost[going]
        better = going[gains]
        q[better], cost[better] = trial[gains], squares[gains]
        error[better], J[better] = reached[gains], rates[gains]
        damping[going] *= np.where(gains, 1.0 / EASED, RAISED)
        damping = np.maximum(damping, LEAST_DAMPING)
    return q[cost < NEARLY]


def refine(
    problem: Problem, q: FloatArray
) -> tuple[FloatArray, NDArray[np.bool_], NDArray[np.bool_]]:
    """Solutions to the last digits.

    Args:
        problem: The pose to reach.
        q: Joint vectors near solutions, shape (N, n).

    Returns:
        The joint vectors (N, n), which of them are solutions (N,), and which are simple ones (N,).
    """
    best, least = q.copy(), np.full(len(q), np.inf)
    moved = np.arange(len(q))
    for _ in range(POLISHING_STEPS):
        error, J = problem.residual(q)
        cost = _squares(error)
        # beside a double root the steps are rounding, magnified: only gains are kept
        gains = cost < least[moved]
        best[moved[gains]], least[moved[gains]] = q[gains], cost[gains]
        # directions in which nothing moves are left alone, so a point of a continuum is left where
        # it is
        step = (np.linalg.pinv(J, rcond=NOTHING_MOVES) @ error[..., None])[..., 0]
        going = np.abs(step).max(axis=1, initial=0.0) > STILL
        if not going.any():
            break
        q, moved = q[going], moved[going]
        q[:, problem.moving] -= step[going]
    solved = np.sqrt(least) < POLISHED
    _, J = problem.residual(best)
    simple = np.linalg.svd(J, compute_uv=False)[:, -1] > REGULAR
    return best, solved, solved & simple & (J.shape[1] >= J.shape[2])


def _squares(v: FloatArray) -> FloatArray:
    squares: FloatArray = np.einsum("ki,ki->k", v, v)
    return squares

"""From starts to solutions: Levenberg-Marquardt downhill, Gauss-Newton for the last digits."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.survey.oracle.arm import FloatArray
    from dhgen.survey.oracle.problem import Problem

STEPS = 60
CONVERGED = 1e-20  # squared residual, lengths in units of the arm
# Beside a singular pose runs a valley whose floor is nearly a solution. The normal equations
# cannot see along it, so what ends in one is left to the last digits' better arithmetic.
NEARLY = 1e-10  # squared residual
STATIONARY = 1e-14  # squared gradient per squared residual: no way further down
LEAST_DAMPING, MOST_DAMPING = 1e-12, 1e8

POLISHING_STEPS = 40  # a double root gains one binary digit a step
STILL = 1e-14  # a step of this size [rad, or arm sizes] is rounding
NOTHING_MOVES = 1e-12  # a singular value that is rounding, relative to the largest
POLISHED = 1e-12  # residual of every solution, lengths in units of the arm
REGULAR = 1e-7  # least singular value of the task's Jacobian at an isolated, simple solution


def descend(problem: Problem, q: FloatArray) -> FloatArray:
    """Follow every start (N, n) downhill; those (M, n) that reached the pose, or nearly."""
    arrived = []
    error, J = problem.residual(q)
    damping = np.full(len(q), 1e-2)
    for _ in range(STEPS):
        cost, gradient = _squares(error), np.einsum("kmj,km->kj", J, error)
        ended = (cost < CONVERGED) | (damping > MOST_DAMPING)
        ended |= _squares(gradient) < STATIONARY * cost
        arrived.append(q[ended & (cost < NEARLY)])
        q, error, J, damping, gradient, cost = (
            array[~ended] for array in (q, error, J, damping, gradient, cost)
        )
        if not len(q):
            break
        trial = q.copy()
        trial[:, problem.moving] -= _damped_step(J, gradient, damping)
        trial_error, trial_J = problem.residual(trial)
        better = _squares(trial_error) < cost
        q = np.where(better[:, None], trial, q)
        error = np.where(better[:, None], trial_error, error)
        J = np.where(better[:, None, None], trial_J, J)
        damping = np.where(better, np.maximum(damping / 8, LEAST_DAMPING), damping * 5)
    arrived.append(q[_squares(error) < NEARLY])
    return np.concatenate(arrived)


def polish(problem: Problem, q: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Solutions to the last digits.

    Args:
        problem: The pose to reach.
        q: Joint vectors near solutions, shape (N, n).

    Returns:
        Solutions (M, n), and which of them are simple (M,).
    """
    best, least = q.copy(), np.full(len(q), np.inf)
    moved = np.arange(len(q))
    for _ in range(POLISHING_STEPS):
        error, J = problem.residual(q)
        cost = _squares(error)
        # beside a double root the steps are rounding, magnified: only gains are kept
        gains = cost < least[moved]
        best[moved[gains]], least[moved[gains]] = q[gains], cost[gains]
        # directions in which nothing moves are left alone, so a point of a continuum stays put
        step = (np.linalg.pinv(J, rcond=NOTHING_MOVES) @ error[..., None])[..., 0]
        going = np.abs(step).max(axis=1, initial=0.0) > STILL
        if not going.any():
            break
        q, moved = q[going], moved[going]
        q[:, problem.moving] -= step[going]
    best = best[np.sqrt(least) < POLISHED]
    _, J = problem.residual(best)
    simple = np.linalg.svd(J, compute_uv=False)[:, -1] > REGULAR
    return best, simple & (J.shape[1] >= J.shape[2])


def _damped_step(J: FloatArray, gradient: FloatArray, damping: FloatArray) -> FloatArray:
    normal = np.einsum("kmi,kmj->kij", J, J)
    normal += damping[:, None, None] * np.eye(normal.shape[-1])
    step: FloatArray = np.linalg.solve(normal, gradient[..., None])[..., 0]
    return step


def _squares(v: FloatArray) -> FloatArray:
    squares: FloatArray = np.einsum("ki,ki->k", v, v)
    return squares

"""Levenberg-Marquardt from many starts, compiled: the loop in which the oracle spends its time.

Arrays are copied number by number: what numba makes of whole ones, with texts for shapes that do
not fit, takes it as long to compile as all the rest.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, TypeVar, cast

import numpy as np
from numba import njit

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray

    Indices = NDArray[np.intp]

F = TypeVar("F", bound="Callable[..., object]")

STEPS = 60
CONVERGED = 1e-20  # squared residual, lengths in units of the arm
# Squared gradient per squared residual: no way further down. Near a pose, a singular one may be
# all that makes the gradient small.
STATIONARY, STATIONARY_NEAR = 1e-10, 1e-14
NEAR = 1e-8  # squared residual
FIRST_DAMPING, LEAST_DAMPING, MOST_DAMPING = 1e-2, 1e-12, 1e8
EASED, RAISED = 8.0, 5.0  # damping after a step that gained, and after one that did not


def _compiled(function: F) -> F:
    """A function as machine code, kept for other processes where there is a folder for it."""
    try:
        return cast("F", njit(cache=True)(function))
    except RuntimeError:  # neither beside this file nor in the user's cache folder
        return cast("F", njit(function))


@_compiled
def _place(
    links: FloatArray,
    twists: FloatArray,
    turning: NDArray[np.bool_],
    q: FloatArray,
    T: FloatArray,
    axes: FloatArray,
) -> None:
    """The tool's pose T (3, 4), and each joint's twist in the base, axes (n, 6), are written."""
    n = len(q)
    T[:] = 0.0
    T[0, 0] = T[1, 1] = T[2, 2] = 1.0
    moved, link = np.empty(3), np.empty(3)
    for joint in range(n + 1):
        first, second = 0.0, 0.0
        if joint < n:
            first = math.sin(q[joint]) if turning[joint] else q[joint]
            # without the cancellation of 1 - cos q near zero
            second = 2.0 * math.sin(0.5 * q[joint]) ** 2 if turning[joint] else 0.0
            w, v = twists[joint, :3], twists[joint, 3:]
            for i in range(3):
                axes[joint, i] = T[i, 0] * w[0] + T[i, 1] * w[1] + T[i, 2] * w[2]
                axes[joint, 3 + i] = T[i, 0] * v[0] + T[i, 1] * v[1] + T[i, 2] * v[2]
            for i in range(3):
                j, k = (i + 1) % 3, (i + 2) % 3
                axes[joint, 3 + i] += T[j, 3] * axes[joint, k] - T[k, 3] * axes[joint, j]
        step = links[joint]
        for i in range(3):
            for k in range(3):
                moved[k] = T[i, k]
            for column in range(4):
                for row in range(3):
                    link[row] = (
                        step[0, row, column]
                        + first * step[1, row, column]
                        + second * step[2, row, column]
                    )
                here = moved[0] * link[0] + moved[1] * link[1] + moved[2] * link[2]
                T[i, column] = here + (T[i, 3] if column == 3 else 0.0)


@_compiled
def _linearise(
    T: FloatArray,
    axes: FloatArray,
    entries: Indices,
    target: FloatArray,
    moving: Indices,
    error: FloatArray,
    J: FloatArray,
) -> float:
    """The error (m,) and its Jacobian (m, moving joints) are written; the squared error."""
    squares = 0.0
    for row in range(len(entries)):
        i, column = entries[row] // 4, entries[row] % 4
        error[row] = T[i, column] - target[row]
        squares += error[row] * error[row]
        j, k = (i + 1) % 3, (i + 2) % 3
        for place in range(len(moving)):
            axis = axes[moving[place]]
            rate = axis[j] * T[k, column] - axis[k] * T[j, column]
            J[row, place] = rate + (axis[3 + i] if column == 3 else 0.0)
    return squares


@_compiled
def _gradient(J: FloatArray, error: FloatArray, gradient: FloatArray) -> float:
    """Half the slope of the squared error (k,) is written; its square."""
    square = 0.0
    for i in range(len(gradient)):
        gradient[i] = 0.0
        for row in range(len(error)):
            gradient[i] += J[row, i] * error[row]
        square += gradient[i] * gradient[i]
    return square


@_compiled
def _damped_step(
    J: FloatArray, gradient: FloatArray, damping: float, L: FloatArray, step: FloatArray
) -> None:
    """Solves (J'J + damping I) step = gradient by Cholesky's factors, written to L and step."""
    n = len(gradient)
    for i in range(n):
        for j in range(i + 1):
            total = damping if i == j else 0.0
            for row in range(len(J)):
                total += J[row, i] * J[row, j]
            for k in range(j):
                total -= L[i, k] * L[j, k]
            L[i, j] = math.sqrt(max(total, 1e-300)) if i == j else total / L[j, j]
    for i in range(n):
        total = gradient[i]
        for k in range(i):
            total -= L[i, k] * step[k]
        step[i] = total / L[i, i]
    for i in range(n - 1, -1, -1):
        total = step[i]
        for k in range(i + 1, n):
            total -= L[k, i] * step[k]
        step[i] = total / L[i, i]


@_compiled
def _follow_one(
    links: FloatArray,
    twists: FloatArray,
    turning: NDArray[np.bool_],
    entries: Indices,
    target: FloatArray,
    moving: Indices,
    here: FloatArray,
) -> float:
    """Follows one start (n,), which is overwritten with its end; returns the squared residual."""
    n, m, k = len(here), len(entries), len(moving)
    T, axes, L = np.empty((3, 4)), np.empty((n, 6)), np.empty((k, k))
    error, J, gradient, step = np.empty(m), np.empty((m, k)), np.empty(k), np.empty(k)
    trial, trial_error, trial_J = np.empty(n), np.empty(m), np.empty((m, k))
    damping = FIRST_DAMPING
    _place(links, twists, turning, here, T, axes)
    cost = _linearise(T, axes, entries, target, moving, error, J)
    for _ in range(STEPS):
        if cost < CONVERGED or damping > MOST_DAMPING:
            break
        slope = _gradient(J, error, gradient)
        if slope < (STATIONARY_NEAR if cost < NEAR else STATIONARY) * cost:
            break
        _damped_step(J, gradient, damping, L, step)
        for joint in range(n):
            trial[joint] = here[joint]
        for place in range(k):
            trial[moving[place]] -= step[place]
        _place(links, twists, turning, trial, T, axes)
        reached = _linearise(T, axes, entries, target, moving, trial_error, trial_J)
        if reached < cost:
            cost = reached
            for joint in range(n):
                here[joint] = trial[joint]
            error, trial_error, J, trial_J = trial_error, error, trial_J, J
            damping = max(damping / EASED, LEAST_DAMPING)
        else:
            damping *= RAISED
    return cost


@_compiled
def follow(
    links: FloatArray,
    twists: FloatArray,
    turning: NDArray[np.bool_],
    entries: Indices,
    target: FloatArray,
    moving: Indices,
    q: FloatArray,
) -> FloatArray:
    """Follows every start downhill.

    Args:
        links: (n + 1, 3, 3, 4). A joint's transform is the first, plus sin q (or the length q)
            times the second, plus 1 - cos q times the third; the last is the tool's.
        twists: (n, 6), each joint's twist, turn and speed, before its constant transform.
        turning: (n,), which joints turn.
        entries: (m,), which of the twelve entries of the pose count.
        target: (m,), their values.
        moving: (k,), the joints that may move.
        q: (N, n), the starts; overwritten with the ends.

    Returns:
        The squared residuals of the ends (N,).
    """
    squares = np.empty(len(q))
    for start in range(len(q)):
        squares[start] = _follow_one(links, twists, turning, entries, target, moving, q[start])
    return squares

"""The arm as a closed loop of six turns, in a form that only its axes decide.

T = C0 Rz(θ1) C1 Rz(θ2) ... Rz(θ6) C6 becomes Rz(θ1) K0 Rz(θ2) ... K4 Rz(θ6) = P with
P = L T R in units of the arm's size. The frames slide along their axes until the links are as
short as they can be, so that where the caller put them changes neither choices nor accuracy.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import TYPE_CHECKING

from dhgen.general.rigid import (
    Matrix,
    along_z,
    dot,
    inverse,
    multiply,
    orthonormal,
    scaled,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

JOINTS = 6
LINKS = 5  # the sixth link of the loop is the pose
# Parallel axes leave a common slide open: this much weight on the slides themselves closes it.
RIDGE = 1e-9


@dataclass(frozen=True, slots=True)
class Loop:
    """An arm of six revolute joints as a loop.

    Attributes:
        links: K0 ... K4, the constant transforms between the joints, in arm sizes.
        left: L in P = L T R, in the file's length unit.
        right: R in P = L T R, in the file's length unit.
        size: The arm's size, the unit length of the links [file's unit].
    """

    links: tuple[Matrix, ...]
    left: Matrix
    right: Matrix
    size: float


def close_loop(constants: Sequence[Matrix]) -> Loop:
    """Build the loop.

    Args:
        constants: C0 ... C6, seven rigid 4x4 transforms [file's unit].

    Raises:
        ValueError: There are not seven, or the arm has no lengths.
    """
    if len(constants) != JOINTS + 1:
        raise ValueError(f"six joints have seven constant transforms, not {len(constants)}")
    fixed = [orthonormal(tuple(tuple(float(x) for x in row) for row in C)) for C in constants]
    slides = _slides(fixed[1:JOINTS])
    links = tuple(
        multiply(multiply(along_z(-slides[i]), fixed[i + 1]), along_z(slides[i + 1]))
        for i in range(LINKS)
    )
    size = sum(sqrt(dot(_origin(K), _origin(K))) for K in links) / 2
    if not size > 0.0:
        raise ValueError("the six axes meet in one point")
    left = inverse(multiply(fixed[0], along_z(slides[0])))
    right = inverse(multiply(along_z(-slides[5]), fixed[JOINTS]))
    return Loop(tuple(scaled(K, 1.0 / size) for K in links), left, right, size)


def reach(loop: Loop) -> float:
    """The length of all links in line [arm sizes]."""
    return sum(sqrt(dot(_origin(K), _origin(K))) for K in loop.links)


def _origin(K: Matrix) -> list[float]:
    return [K[i][3] for i in range(3)]


def _slides(links: Sequence[Matrix]) -> list[float]:
    """How far each frame moves along its axis so that the squares of the links add up least."""
    normal = [[RIDGE * (i == j) for j in range(JOINTS)] for i in range(JOINTS)]
    target = [0.0] * JOINTS
    for i, K in enumerate(links):
        # The link's vector becomes t - s_i z + s_(i+1) z'.
        here, there = [0.0, 0.0, -1.0], [K[row][2] for row in range(3)]
        for a, u in ((i, here), (i + 1, there)):
            target[a] -= dot(u, _origin(K))
            for b, v in ((i, here), (i + 1, there)):
                normal[a][b] += dot(u, v)
    return _solve(normal, target)


def _solve(A: list[list[float]], b: list[float]) -> list[float]:
    """The solution of a positive definite system, by elimination without pivots."""
    n = len(b)
    for i in range(n):
        for j in range(i + 1, n):
            factor = A[j][i] / A[i][i]
            for k in range(i, n):
                A[j][k] -= factor * A[i][k]
            b[j] -= factor * b[i]
    x = [0.0] * n
    for i in reversed(range(n)):
        x[i] = (b[i] - dot(A[i][i + 1 :], x[i + 1 :])) / A[i][i]
    return x

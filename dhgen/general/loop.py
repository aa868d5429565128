"""The arm as a closed loop of six joints, in a form that only its axes decide.

T = C0 J1(θ1) C1 J2(θ2) ... J6(θ6) C6 becomes J1(θ1) K0 J2(θ2) ... K4 J6(θ6) = P with P = L T R in
units of the arm's size; a joint turns about z, and one or two of the six may slide along z
instead. The frames slide along their axes until the links are as short as they can be, so that
where the caller put them changes neither choices nor accuracy. They also turn about their axes, by
angles that mean nothing: otherwise an arm at right angles would have joints half a turn away from
zero, with infinite tangents of the half angle, and double roots on the borders of cells.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, sqrt
from typing import TYPE_CHECKING

from dhgen.general.links import Link, Value
from dhgen.kinematics.rigid import IDENTITY, along_z, dot, multiply, orthonormal, turn

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.rigid import Matrix

JOINTS = 6
LINKS = 5  # the sixth link of the loop is the pose
# Parallel axes leave a common slide open: this much weight on the slides themselves closes it.
RIDGE = 1e-9
OVER = 1e-9  # of the square of the reach: what is farther is out of it, not rounded
# Lengths between the axes are none beside those outside: they are what the ridge leaves of others
# that cancel, or a calibration's last digits, and a slide would be longer than any in their unit.
NO_LENGTH = 1e-3
# Cosine and sine by which each joint is turned in advance.
ADVANCES = (
    (3 / 5, 4 / 5),
    (5 / 13, 12 / 13),
    (8 / 17, 15 / 17),
    (7 / 25, 24 / 25),
    (20 / 29, 21 / 29),
    (12 / 37, 35 / 37),
)
# Held joints at which a link's length is averaged; with the four quarters of a turn the average of
# a square is that over the whole turn.
QUARTERS = (
    Value(0.0, 1.0, 0.0),
    Value(0.0, 0.0, 1.0),
    Value(0.0, -1.0, 0.0),
    Value(0.0, 0.0, -1.0),
)


@dataclass(frozen=True, slots=True)
class Loop:
    """An arm with six joints to be solved for as a loop.

    Attributes:
        links: K0 ... K4, the transforms between the joints, in arm sizes.
        left: L in P = L T R, in the file's length unit.
        right: R in P = L T R, in the file's length unit.
        size: The arm's size, the unit length of the links [file's unit].
        slides: Which of the six joints slide, from 0.
        given: How many joint values the caller gives.
        advances: Cosine and sine of what is to be added to each joint's angle in the loop.
    """

    links: tuple[Link, ...]
    left: Link
    right: Link
    size: float
    slides: tuple[int, ...] = ()
    given: int = 0
    advances: tuple[tuple[float, float], ...] = ADVANCES


def close_loop(constants: Sequence[Link], slides: tuple[int, ...] = ()) -> Loop:
    """Build the loop.

    Args:
        constants: C0 ... C6, seven rigid transforms [file's unit].
        slides: Which of the six joints slide, from 0.

    Raises:
        ValueError: There are not seven, or the arm has no lengths.
    """
    if len(constants) != JOINTS + 1:
        raise ValueError(f"six joints have seven constant transforms, not {len(constants)}")
    fixed = [_orthonormal(C) for C in constants]
    given = 1 + max((held.place for C in fixed for held, _ in C.rest), default=-1)
    samples = [_at_once(fixed[1:JOINTS], [quarter] * given) for quarter in QUARTERS]
    shifts = _shifts(samples if given else samples[:1])
    advances = tuple((1.0, 0.0) if i in slides else ADVANCES[i] for i in range(JOINTS))
    after = [multiply(along_z(shifts[i]), turn(*advances[i])) for i in range(JOINTS)]
    links = tuple(fixed[i + 1].between(along_z(-shifts[i]), after[i + 1]) for i in range(LINKS))
    lengths = [
        sum(sqrt(dot(_origin(K), _origin(K))) for K in _at_once(links, [quarter] * given))
        for quarter in QUARTERS
    ]
    size = max(lengths) / 2
    if slides and size <= NO_LENGTH * max(abs(x) for C in fixed for x in _origin(C.first)):
        size = 1.0  # slides have no length of their own: the file's unit is taken
    if not size > 0.0:
        raise ValueError("the six axes meet in one point")
    left = fixed[0].between(IDENTITY, after[0]).inverse()
    right = fixed[JOINTS].between(along_z(-shifts[5]), IDENTITY).inverse()
    links = tuple(K.scaled(1.0 / size) for K in links)
    return Loop(links, left, right, size, slides, given, advances)


def reach(loop: Loop) -> float:
    """The length of all links in line [arm sizes]; infinite where there is a slide."""
    lengths = [K.longest for K in loop.links]
    if loop.slides:
        return inf
    return sum(inf if length is None else length for length in lengths)


def out_of_reach(loop: Loop) -> float:
    """The square of the least distance that is out of reach, beyond rounding [arm sizes]."""
    farthest = reach(loop)
    return (1.0 + OVER) * farthest * farthest


def _orthonormal(C: Link) -> Link:
    return Link(_clean(C.first), tuple((held, _clean(K)) for held, K in C.rest))


def _clean(K: Matrix) -> Matrix:
    return orthonormal(tuple(tuple(float(x) for x in row) for row in K))


def _at_once(links: Sequence[Link], given: Sequence[Value]) -> list[Matrix]:
    return [K.at(given) for K in links]


def _origin(K: Matrix) -> list[float]:
    return [K[i][3] for i in range(3)]


def _shifts(samples: Sequence[Sequence[Matrix]]) -> list[float]:
    """How far each frame moves along its axis so that the squares of the links add up least.

    Args:
        samples: The five links at some values of the joints that are held.
    """
    normal = [[RIDGE * (i == j) for j in range(JOINTS)] for i in range(JOINTS)]
    target = [0.0] * JOINTS
    for links in samples:
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

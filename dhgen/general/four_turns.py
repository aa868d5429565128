"""Arms with four turns and two slides: the polynomial of one turn's angle, of degree 4.

Slides leave directions alone. The loop J(φ1) L0 J(φ2) L1 ... J(φ6) L5 = 1, φ1 a turn, has the
rotation

    Rz(φ1) A Rz(β) B Rz(γ) C Rz(δ) D = 1,   so   Rz(β) N Rz(δ) = M,   N = B Rz(γ) C,

with M = Aᵀ Rz(−φ1) Dᵀ known where φ1 is: a spherical linkage of four bars. Its entry zz is linear
in cos γ and sin γ, a quadratic; β and δ turn the third column and row of N to those of M. The
loop's translation p + d u + e v = 0 is linear in the lengths d and e: it needs
g = det[u, v, p] = 0.

With Δ the discriminant of γ, all of that is of the form x + y √Δ, and so is g = U + V √Δ. The
polynomial w (U² − V² Δ) is of degree 4, w = 1 − M_zz²: w g has the degree 3 in U and 2 in V, its
norm 6, and divides by w once, as at w = 0 one of the two branches remains finite.

Numbers x + y √Δ are arrays (2, ...) of x and y, angles are on the last axis ("lanes"), and
everything is done element by element, so that rounding is the same on every machine.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.determinant import TINY
from dhgen.general.formulation import Formulation

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray


@dataclass(frozen=True, slots=True)
class Branches:
    """The loop for given angles φ1, on both branches of the other turns at once.

    Attributes:
        delta: The discriminant Δ, (N,).
        w: What the polynomial is multiplied by, (N,).
        cosines: Of the three other turns, in the loop's order, (2, N) each.
        sines: The same.
        u: The directions of both slides, (2, 3, N) each.
        p: The loop's translation without the slides, (2, 3, N).
    """

    delta: FloatArray
    w: FloatArray
    cosines: tuple[FloatArray, ...]
    sines: tuple[FloatArray, ...]
    u: tuple[FloatArray, ...]
    p: FloatArray

    @property
    def determinant(self) -> FloatArray:
        """The determinant of both directions and the translation, (2, N)."""
        normal = [
            _product(self.u[0][:, i], self.u[1][:, j], self.delta)
            - _product(self.u[0][:, j], self.u[1][:, i], self.delta)
            for i, j in ((1, 2), (2, 0), (0, 1))
        ]
        x, y, z = (_product(n, self.p[:, i], self.delta) for i, n in enumerate(normal))
        return x + y + z

    @property
    def polynomial(self) -> FloatArray:
        """The product of the determinants of both branches, times w: (N,)."""
        U, V = self.determinant
        return np.asarray(self.w * (U * U - V * V * self.delta))


@dataclass(frozen=True, slots=True)
class FourTurns:
    """A way to hide one of four turns.

    Attributes:
        formulation: The order of the joints; φ1 is hidden.
        slides: Which two of the six joints slide, from 0.
    """

    formulation: Formulation
    slides: tuple[int, ...]

    @property
    def solutions_per_root(self) -> int:
        """How many solutions have one root of the polynomial."""
        return 1


def turns_to_hide(slides: tuple[int, ...]) -> tuple[Formulation, ...]:
    """The four formulations.

    Args:
        slides: Which two of the six joints slide, from 0.
    """
    every = [Formulation(tuple((first + i) % 6 for i in range(6)), 1) for first in range(6)]
    return tuple(f for f in every if f.joints[0] not in slides)


def branches(
    links: Sequence[FloatArray], slides: Sequence[bool], hidden: tuple[FloatArray, FloatArray]
) -> Branches:
    """The loop where the hidden angle is known.

    Args:
        links: L0 ... L5, (4, 4, N) or (4, 4, 1) each, in arm sizes.
        slides: Which of φ1 ... φ6 is a length: two of them, not the first.
        hidden: Cosine and sine of φ1, (N,) each.
    """
    A, B, C, D = _rotations(links, slides)
    M = _known(A, D, hidden)
    # M_zz = N_zz is b cos γ + c sin γ + B_zz C_zz
    b = B[2, 0] * C[0, 2] + B[2, 1] * C[1, 2]
    c = B[2, 1] * C[0, 2] - B[2, 0] * C[1, 2]
    k = M[2, 2] - B[2, 2] * C[2, 2]
    q = b * b + c * c
    discriminant = q - k * k
    q = q + TINY
    middle = np.stack([b * k, -c + 0.0 * k]) / q, np.stack([c * k, b + 0.0 * k]) / q
    column = _applied(B, _turned(C[:, 2], middle, 1.0))
    row = _applied(C.transpose(1, 0, 2), _turned(B[2], middle, -1.0))
    w = M[0, 2] * M[0, 2] + M[1, 2] * M[1, 2] + TINY
    outer = (
        (M[0, 2] * column[0] + M[1, 2] * column[1]) / w,
        (M[1, 2] * column[0] - M[0, 2] * column[1]) / w,
    )
    last = (
        (M[2, 0] * row[0] + M[2, 1] * row[1]) / w,
        (M[2, 0] * row[1] - M[2, 1] * row[0]) / w,
    )
    turns = (outer, middle, last)
    u, p = _walk(links, slides, hidden, (turns, discriminant))
    cosines, sines = zip(*turns, strict=True)
    return Branches(discriminant, w, cosines, sines, u, p)


Pair = tuple["FloatArray", "FloatArray"]  # cosine and sine


def _known(A: FloatArray, D: FloatArray, hidden: Pair) -> FloatArray:
    """M = Aᵀ Rz(−φ1) Dᵀ, (3, 3, N)."""
    cosine, sine = hidden
    x, y, z = D.transpose(1, 0, 2)
    turned = np.broadcast_arrays(cosine * x + sine * y, cosine * y - sine * x, z)
    return _compose(A.transpose(1, 0, 2), np.stack(turned))


def _walk(
    links: Sequence[FloatArray],
    slides: Sequence[bool],
    hidden: Pair,
    others: tuple[tuple[Pair, ...], FloatArray],
) -> tuple[tuple[FloatArray, ...], FloatArray]:
    """Once around the loop: the slides' directions and the translation."""
    turns, delta = others
    c, s = hidden
    zero = 0.0 * c * links[0][0, 0]
    T = np.zeros((2, 3, 4, *zero.shape))
    T[0, 0, 0], T[0, 0, 1], T[0, 1, 0], T[0, 1, 1], T[0, 2, 2] = c, -s, s, c, 1.0
    directions = []
    waiting = iter(turns)
    for place, link in enumerate(links):
        if slides[place]:
            directions.append(T[:, :, 2])
        elif place:
            c, s = (x[:, None] for x in next(waiting))
            x, y = T[:, :, 0], T[:, :, 1]
            T = np.stack(
                [
                    _product(x, c, delta) + _product(y, s, delta),
                    _product(y, c, delta) - _product(x, s, delta),
                    T[:, :, 2],
                    T[:, :, 3],
                ],
                axis=2,
            )
        columns = [
            T[:, :, 0] * link[0, j] + T[:, :, 1] * link[1, j] + T[:, :, 2] * link[2, j]
            for j in range(4)
        ]
        columns[3] = columns[3] + T[:, :, 3]
        T = np.stack(columns, axis=2)
    return tuple(directions), T[:, :, 3]


def _rotations(links: Sequence[FloatArray], slides: Sequence[bool]) -> list[FloatArray]:
    """A, B, C, D: the rotations between the turns, (3, 3, N) each."""
    between: list[FloatArray] = []
    for link, slides_here in zip(links, slides, strict=True):
        R = link[:3, :3]
        if slides_here:
            between[-1] = _compose(between[-1], R)
        else:
            between.append(R)
    return between


def _product(a: FloatArray, b: FloatArray, delta: FloatArray) -> FloatArray:
    """The product of two numbers x + y √Δ."""
    return np.stack([a[0] * b[0] + delta * a[1] * b[1], a[0] * b[1] + a[1] * b[0]])


def _compose(A: FloatArray, B: FloatArray) -> FloatArray:
    """A B, (3, 3, N) each."""
    return np.asarray(
        A[:, 0, None] * B[None, 0] + A[:, 1, None] * B[None, 1] + A[:, 2, None] * B[None, 2]
    )


def _turned(v: FloatArray, angle: Pair, sign: float) -> list[FloatArray]:
    """A vector turned about z by ± an angle."""
    c, s = angle
    x, y, z = v
    still = np.stack([z + 0.0 * c[0], 0.0 * c[0]])
    return [c * x - sign * s * y, sign * s * x + c * y, still]


def _applied(R: FloatArray, v: Sequence[FloatArray]) -> list[FloatArray]:
    """R v, summed in a fixed order."""
    return [R[i, 0] * v[0] + R[i, 1] * v[1] + R[i, 2] * v[2] for i in range(3)]

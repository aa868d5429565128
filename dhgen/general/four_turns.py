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
norm 6, and divides by w once, as at w = 0 one of the two branches stays finite.

Numbers x + y √Δ are arrays (2, ...) of x and y, angles are on the last axis ("lanes"), and
everything is done element by element, so that rounding is the same on every machine.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.determinant import TINY
from dhgen.general.formulation import Formulation
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.arrays import FloatArray


DEGREE = 4
# At a root the better branch is taken, and the other one too where its determinant is this small:
# a double root may be one of each.
NEARLY_FLAT = 1e-2
# Where the slides are parallel, and the translation is farther than this from being along them,
# they would have to reach to infinity: such roots belong to no solution, and arms at right angles
# have them always. Beside parallel slides a solution needs no longer ones than elsewhere.
ALONG = 1e-6
FARTHEST = TOLERANCES.longest  # times the sine between the slides: as far as they reach [arm sizes]
# Rounding over the size of the determinants, which are small where the slides are nearly parallel
# all around the circle: its root is how far a double root may be off.
MOVED = 1e-14
# Where the axis of γ is parallel to that of β or δ, the entry zz does not give γ, and roots tell
# nothing of solutions: the square of the product of the sines between these axes.
NO_ANGLE = 1e-18
# Where the axes of β and δ are parallel only the sum of these angles is told, and γ is a double
# root: the square of the sine between these axes.
ALIGNED = 1e-6
PARALLEL = 1e-30  # the square of what rounding leaves of the normal of slides that are parallel


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

    def values(
        self, links: Sequence[FloatArray], P: FloatArray, cosines: FloatArray, sines: FloatArray
    ) -> FloatArray:
        """The polynomial, (N,), from cosines and sines of the hidden angle."""
        return self._at(links, P, cosines, sines).polynomial

    def tells_all(self, links: Sequence[FloatArray], P: FloatArray, roots: Sequence[float]) -> bool:
        """Whether every solution has a root, and every root tells its solution.

        The third turn's axis is not parallel to another, and at no root are these two.
        """
        around = [link[..., None] for link in self.formulation.links(links, P)]
        A, B, C, D = _rotations(around, self.formulation.slides(self.slides))
        before, behind = B[2, 0] ** 2 + B[2, 1] ** 2, C[0, 2] ** 2 + C[1, 2] ** 2
        M = _known(A, D, (np.cos(roots), np.sin(roots)))
        aligned = M[0, 2] ** 2 + M[1, 2] ** 2 <= ALIGNED
        return bool(before * behind > NO_ANGLE) and not aligned.any()

    def candidates(
        self, links: Sequence[FloatArray], P: FloatArray, angle: float
    ) -> Iterator[FloatArray | None]:
        """Joint angles and lengths (6,) near solutions, for a root; None for one at infinity."""
        at = self._at(links, P, np.array([np.cos(angle)]), np.array([np.sin(angle)]))
        root = np.sqrt(max(at.delta[0], 0.0))
        U, V = at.determinant[:, 0]
        better = -1.0 if (U < 0.0) == (V < 0.0) else 1.0
        for sign in (better, -better):
            if sign == better or abs(U + sign * V * root) < NEARLY_FLAT:
                yield self._joints(at, sign * root, angle)

    def _at(
        self, links: Sequence[FloatArray], P: FloatArray, cosine: FloatArray, sine: FloatArray
    ) -> Branches:
        around = [link[..., None] for link in self.formulation.links(links, P)]
        return branches(around, self.formulation.slides(self.slides), (cosine, sine))

    def _joints(self, at: Branches, root: float, angle: float) -> FloatArray | None:
        """All six, on the branch with this value of √Δ; None when they are at infinity."""
        u, v, p = (x[0, :, 0] + x[1, :, 0] * root for x in (*at.u, at.p))
        normal, across = np.cross(u, v), np.cross(p, u)
        U, V = at.determinant[:, 0]
        moved = np.sqrt(MOVED / (abs(U) + abs(V * root) + TINY))
        if max(abs(across)) > max(ALONG, moved, FARTHEST * max(abs(normal))):
            return None
        slides = self.formulation.slides(self.slides)
        turns = [i for i, is_slide in enumerate(slides) if not is_slide]
        phi = np.empty(6)
        phi[0] = angle
        for place, c, s in zip(turns[1:], at.cosines, at.sines, strict=True):
            phi[place] = np.arctan2(s[0, 0] + s[1, 0] * root, c[0, 0] + c[1, 0] * root)
        # p + d u + e v = 0 times v and u; their scalar products would lose digits of the sine
        lengths = np.array([np.cross(v, p) @ normal, across @ normal]) / (
            normal @ normal + PARALLEL
        )
        phi[[i for i, is_slide in enumerate(slides) if is_slide]] = lengths
        return self.formulation.angles(phi.tolist())


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
    """A, B, C, D: what stands between the turns, (3, 3, N) each."""
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

"""The twelve ways to hide one joint of the loop.

From the loop J(φ1) L0 J(φ2) L1 J(φ3) L2 J(φ4) L3 J(φ5) L4 J(φ6) L5 = 1 follows

    G(L5) G(φ1) G(L0) G(φ2) G(L1) G(φ3) G(L2) x = G(−φ6) G(L4⁻¹) G(−φ5) G(L3⁻¹) x

for x the monomials of the origin and z, because φ4 leaves them alone. With p and l the origin and
the z axis of a frame these are 1, l, p, p·p, p·l, p×l and (p·p) l − 2 (p·l) p: a rigid motion takes
them to linear combinations of each other, and G(A B) = G(A) G(B) (M. Raghavan and B. Roth, ASME J.
Mech. Des. 115, 1993, equations (9) to (14)). The right side has eight monomials besides 1. What
annihilates these gives six equations: bilinear in (1, c1, s1) and the nine monomials of φ2 and φ3
(Raghavan and Roth hide the third joint of the left side and have to divide a factor out; with the
outer one the determinant has degree 8 to begin with).

A joint may slide: its monomials are linear in (1, d, d²) as those of a turn are in (1 + x²,
1 − x², 2 x) with x = tan(φ/2), and d takes the place of x. It can't be φ4. It is φ2 or φ3 as a
rule; where axes side by side are parallel, or meet, at several places, the determinants of that
kind may all vanish, and so may those where it is φ5 or φ6, but hardly those where it is hidden.

Three parallel axes, or three that meet, must not be φ4, φ5 and φ6: φ1, φ2 and φ3 then leave two
solutions for them, and a root of the determinant gives one.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.hidden_slide import ORDERS

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.arrays import FloatArray


PARTNERS = (1, 2)
OTHERS = (4, 5)  # the two on the right side


@dataclass(frozen=True, slots=True)
class Formulation:
    """One way to hide a joint.

    Attributes:
        joints: The joints φ1 ... φ6 are, from 0; φ1 is hidden.
        sign: φ = sign θ; −1 reads the loop backwards.
        order: Where φ1 is a length, half the order of the determinant's zero at infinity.
    """

    joints: tuple[int, ...]
    sign: int
    order: int = 0

    def behind(self, joint: int) -> tuple[int | None, bool]:
        """What comes after a joint: the number of K0 ... K4, or None for P; whether inverted."""
        if self.sign > 0:
            return (joint, False) if joint < 5 else (None, True)
        return (joint - 1, True) if joint > 0 else (None, False)

    def links(self, around: Sequence[FloatArray], P: FloatArray) -> list[FloatArray]:
        """L0 ... L5 (..., 4, 4), from K0 ... K4 and the pose of the loop."""
        found = []
        for joint in self.joints:
            number, inverted = self.behind(joint)
            link = P if number is None else around[number]
            found.append(_inverses(link) if inverted else link)
        return found

    def slides(self, slides: tuple[int, ...]) -> tuple[bool, ...]:
        """Which of φ1 ... φ6 is a length."""
        return tuple(joint in slides for joint in self.joints)


def formulations(
    slides: tuple[int, ...] = (), places: tuple[int, ...] = PARTNERS
) -> tuple[Formulation, ...]:
    """All twelve: six beginnings forwards, six backwards; with a slide those where it has a place.

    Args:
        slides: Which of the six joints slide, from 0, one at most.
        places: Which of φ1 ... φ6 it may be, from 0.
    """
    return tuple(f for f in _every() if all(f.joints.index(j) in places for j in slides))


def hiding(slide: int) -> Iterator[tuple[Formulation, ...]]:
    """The two that hide a slide, forwards and backwards, for every order of the zero at infinity.

    The highest first: where one is too low the zero that is left is a root of no solution, and
    where it is too high there is no polynomial.
    """
    for order in ORDERS:
        yield tuple(replace(f, order=order) for f in _every() if f.joints[0] == slide)


def _every() -> list[Formulation]:
    orders = [tuple((start + i) % 6 for i in range(6)) for start in range(6)]
    return [
        *(Formulation(order, 1) for order in orders),
        *(Formulation(tuple(5 - i for i in order), -1) for order in orders),
    ]


def _inverses(K: FloatArray) -> FloatArray:
    """The inverses of rigid transforms (..., 4, 4), summed in a fixed order."""
    result = np.zeros_like(K)
    result[..., 3, 3] = 1.0
    for i in range(3):
        x = [K[..., j, i] for j in range(3)]
        result[..., i, 3] = -(x[0] * K[..., 0, 3] + x[1] * K[..., 1, 3] + x[2] * K[..., 2, 3])
        for j in range(3):
            result[..., i, j] = x[j]
    return result

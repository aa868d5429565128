"""The fourteen features of a point and a direction, and how a rigid motion acts on them.

M. Raghavan and B. Roth, Inverse kinematics of the general 6R manipulator and related linkages,
ASME J. Mech. Des. 115 (1993), equations (9) to (14): with p and l the origin and the z axis of a
frame, l, p, p·p, p·l, p×l and (p·p) l − 2 (p·l) p have one set of power products. Together with 1
they span a representation of the rigid motions: x ↦ R x + t acts by a 15x15 matrix G(R, t),
G(A B) = G(A) G(B), whose entries are linear in 35 monomials of R and t.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.general.rigid import Matrix, Vector, dot

if TYPE_CHECKING:
    from collections.abc import Sequence

ONE, L, P, PP, PL, PXL, W = 0, 1, 4, 7, 8, 9, 12  # where each feature begins
FEATURES = 15
MONOMIALS = 35

# Features of the origin with the direction z: the start of every chain.
START: Vector = tuple(float(i in (ONE, L + 2)) for i in range(FEATURES))

Sparse = tuple[tuple[int, int, float], ...]  # (row, column, value)


def monomials(K: Matrix) -> Vector:
    """The 35 monomials of a rigid transform.

    In order: 1; R row by row; t; t·t; Rᵀt; [t]×R; (t·t − 2 t tᵀ) R.
    """
    R = [row[:3] for row in K[:3]]
    t = [row[3] for row in K[:3]]
    columns = [[R[i][j] for i in range(3)] for j in range(3)]
    back = [dot(column, t) for column in columns]
    square = dot(t, t)
    turned = [
        t[(i + 1) % 3] * R[(i + 2) % 3][j] - t[(i + 2) % 3] * R[(i + 1) % 3][j]
        for i in range(3)
        for j in range(3)
    ]
    mirrored = [square * R[i][j] - 2.0 * (t[i] * back[j]) for i in range(3) for j in range(3)]
    flat = [R[i][j] for i in range(3) for j in range(3)]
    return (1.0, *flat, *t, square, *back, *turned, *mirrored)


def _rotation(at: int) -> Sparse:
    """Where R stands for a feature that turns like a vector."""
    return tuple((at + i, at + j, 1.0) for i in range(3) for j in range(3))


def _units() -> tuple[Sparse, ...]:
    """E_k of G = Σ m_k E_k."""
    units: list[list[tuple[int, int, float]]] = [[] for _ in range(MONOMIALS)]
    units[0] += [(ONE, ONE, 1.0), (PP, PP, 1.0), (PL, PL, 1.0)]
    for at in (L, P, PXL, W):
        for k, entry in enumerate(_rotation(at)):
            units[1 + k].append(entry)
    for i in range(3):
        units[10 + i] += [(P + i, ONE, 1.0), (W + i, PL, -2.0)]  # t
        units[14 + i] += [(PP, P + i, 2.0), (PL, L + i, 1.0)]  # Rᵀt
    units[13].append((PP, ONE, 1.0))  # t·t
    for k in range(9):
        i, j = divmod(k, 3)
        units[17 + k] += [(PXL + i, L + j, 1.0), (W + i, PXL + j, -2.0)]  # [t]×R
        units[26 + k].append((W + i, L + j, 1.0))  # (t·t − 2 t tᵀ) R
    return tuple(tuple(unit) for unit in units)


UNITS = _units()


def act(values: Sequence[float], features: Sequence[float]) -> list[float]:
    """G x, with G given by the 35 monomials `values` of a transform; x has 15 components."""
    result = [0.0] * FEATURES
    for value, unit in zip(values, UNITS, strict=True):
        if value:
            for row, column, factor in unit:
                result[row] += factor * (value * features[column])
    return result


def turn(features: Sequence[float]) -> tuple[list[float], list[float], list[float]]:
    """The coefficients of 1, cos φ and sin φ in G(Rz(φ)) x."""
    one, cosine, sine = list(features), [0.0] * FEATURES, [0.0] * FEATURES
    for at in (L, P, PXL, W):
        x, y = features[at], features[at + 1]
        one[at] = one[at + 1] = 0.0
        cosine[at], cosine[at + 1] = x, y
        sine[at], sine[at + 1] = -y, x
    return one, cosine, sine

"""From a root of the determinant to all six angles.

A null vector gives φ2 and φ3; then B = Rz(φ4) L3 Rz(φ5) L4 Rz(φ6) is known, and what does not
depend on φ4 and φ6 is linear in cos φ5 and sin φ5: the invariants of axis 4 and axis 6 in B. Where
φ5 is a length, some of these are linear in it; where φ6 is one, directions give φ4 and φ5.
"""

from __future__ import annotations

from math import atan2
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.formulation import OTHERS

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.arrays import FloatArray


TINY = 1e-300
# Of the largest diagonal: emitted code, which iterates to a null vector, takes none as smaller.
SMALLEST = 1e-15
PLANE = 1e-24  # below this the rows of a shift don't span a plane
EZ = np.array([0.0, 0.0, 1.0])


def motion(value: float, *, slides: bool) -> FloatArray:
    """The transform of a joint, (4, 4)."""
    if not slides:
        return turn(value)
    T = np.eye(4)
    T[2, 3] = value
    return T


def turn(angle: float) -> FloatArray:
    """Rz(angle), (4, 4)."""
    c, s = np.cos(angle), np.sin(angle)
    T = np.eye(4)
    T[:2, :2] = [[c, -s], [s, c]]
    return T


def rigid_inverse(T: FloatArray) -> FloatArray:
    """The inverse of a rigid transform (4, 4)."""
    inverse = np.eye(4)
    inverse[:3, :3] = T[:3, :3].T
    inverse[:3, 3] = -T[:3, :3].T @ T[:3, 3]
    return inverse


def null_vectors(factor: FloatArray, dimension: int) -> Iterator[FloatArray]:
    """Vectors (2, 3) near (x3, 1) ⊗ (x2², x2, 1) in the null space of a 6x6 factor.

    Args:
        factor: (6, 6), singular or nearly so.
        dimension: 1, or 2 where two roots may have met: then the null space is split where
            one of the two shifts, x3 between the rows or x2 between the columns, is an eigenvalue.
    """
    *_, V = np.linalg.svd(factor)
    yield V[-1].reshape(2, 3)
    if dimension == 1:
        return
    first, second = V[-1].reshape(2, 3), V[-2].reshape(2, 3)
    both = np.stack([first, second], axis=-1)
    for up, down in ((both[0], both[1]), (both[:, :2], both[:, 1:])):
        for weights in _eigenvectors(up.reshape(-1, 2), down.reshape(-1, 2)):
            yield weights[0] * first + weights[1] * second


def least_values(factor: FloatArray) -> tuple[float, float]:
    """The two smallest singular values of a 6x6 factor over the root of the sum of all squares."""
    values = np.linalg.svd(factor, compute_uv=False)
    second, smallest = values[-2:] / np.sqrt(values @ values)
    return float(second), float(smallest)


def _eigenvectors(up: FloatArray, down: FloatArray) -> Iterator[FloatArray]:
    """Weights w with up w = x down w for some x, real ones only; x may be infinite."""
    A, G, H = down.T @ up, down.T @ down, up.T @ up
    if np.linalg.det(G) < np.linalg.det(H):  # 1/x is the better unknown
        A, G = A.T, H
    if np.linalg.det(G) < PLANE:
        return
    # a double eigenvalue may come out as a complex pair; its real part serves
    _, vectors = np.linalg.eig(np.linalg.solve(G, A))
    yield from vectors.real.T


def partner_values(vector: FloatArray, slides: Sequence[bool]) -> tuple[float, float]:
    """φ2 and φ3 from (x3, 1) ⊗ (x2², x2, 1), any multiple of it.

    Args:
        vector: (2, 3).
        slides: Which of φ1, φ2, φ3 is a length; x is tan(φ/2) or the length itself.
    """
    row = vector[np.argmax(np.abs(vector).max(axis=1))]
    column = vector[:, np.argmax(np.abs(vector).max(axis=0))]
    square, first, one = row * np.copysign(1.0, row[0] + row[2])
    if slides[1]:  # x² over x and x over 1, by least squares
        phi_2 = _length(first * (square + one), first * first + one * one)
    else:  # cos φ : sin φ = 1 − x² : 2 x
        phi_2 = atan2(2 * first, one - square)
    return phi_2, _length(*column) if slides[2] else 2 * atan2(column[0], column[1])


def _length(over: float, under: float) -> float:
    """A quotient; zero instead of infinity."""
    return float(over * under / (under * under + TINY))


def remaining_angles(
    links: Sequence[FloatArray], phi: tuple[float, float, float], slides: Sequence[bool]
) -> tuple[float, ...]:
    """φ1 ... φ6 from φ1, φ2, φ3 and the six links of this pose."""
    A = motion(phi[0], slides=slides[0]) @ links[0] @ motion(phi[1], slides=slides[1]) @ links[1]
    A = A @ motion(phi[2], slides=slides[2]) @ links[2]
    B = rigid_inverse(links[5] @ A)
    inner, outer = (slides[place] for place in OTHERS)
    if outer:
        return (*phi, *_before_a_slide(B, links[3], links[4]))
    middle = _middle_length if inner else _middle_angle
    phi_5 = middle(B, links[3], links[4])
    C = links[3] @ motion(phi_5, slides=inner) @ links[4]
    # Rz(φ4) takes the x, y components of C's third and fourth column to those of B
    (cx, cy), (bx, by) = C[:2, 2:], B[:2, 2:]
    phi_4 = atan2(float(cx @ by - cy @ bx), float(cx @ bx + cy @ by))
    last = rigid_inverse(turn(phi_4) @ C) @ B
    phi_6 = atan2(last[1, 0] - last[0, 1], last[0, 0] + last[1, 1])
    return (*phi, phi_4, phi_5, phi_6)


def middle_determined(K: FloatArray, M: FloatArray, slides: Sequence[bool]) -> float:
    """How well φ5 follows from B = J(φ4) K J(φ5) M J(φ6): 0 where B leaves two values, or any.

    Where axes 4 to 6 are parallel, or meet in a point, all invariants have one and the same
    combination of cos φ5 and sin φ5, which says φ5 but for a sign.

    Args:
        K: The link between φ4 and φ5, (4, 4), in arm sizes.
        M: The link between φ5 and φ6.
        slides: Which of φ1 ... φ6 is a length.

    Returns:
        The least singular value of what φ5 is solved from; of an angle over the largest one.
    """
    inner, outer = (slides[place] for place in OTHERS)
    if outer:
        return float(np.linalg.norm(K[2, :2]))
    if inner:
        return float(np.linalg.norm(_middle_slope(K, M)))
    matrix, _ = _middle_equations(K, M)
    largest, least = np.linalg.svd(matrix, compute_uv=False)
    return float(least / (largest + TINY))


def _middle_angle(B: FloatArray, K: FloatArray, M: FloatArray) -> float:
    """φ5 of B = Rz(φ4) K Rz(φ5) M Rz(φ6), by least squares on five invariants."""
    l, p = B[:3, 2], B[:3, 3]
    t, e, u = K[:3, 3], M[:3, 2], M[:3, 3]
    values = (
        l[2],
        p[2] - t[2],
        p @ l - u @ e,
        (p @ p - t @ t - u @ u) / 2,
        np.cross(p, l)[2],
    )
    matrix, rest = _middle_equations(K, M)
    (c, s), *_ = np.linalg.lstsq(matrix, np.array(values) - rest, rcond=None)
    return atan2(s, c)


def _middle_equations(K: FloatArray, M: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Five invariants' coefficients of cos φ5 and sin φ5, (5, 2), and of 1, (5,)."""
    R, t, e, u = K[:3, :3], K[:3, 3], M[:3, 2], M[:3, 3]
    axis, foot, side = R.T @ EZ, R.T @ t, R.T @ np.cross(EZ, t)
    terms = (
        [(axis, e)],
        [(axis, u)],
        [(foot, e)],
        [(foot, u)],
        [(axis, np.cross(u, e)), (side, e)],
    )
    cosine = [sum(a[:2] @ b[:2] for a, b in sides) for sides in terms]
    sine = [sum(a[1] * b[0] - a[0] * b[1] for a, b in sides) for sides in terms]
    rest = [sum(a[2] * b[2] for a, b in sides) for sides in terms]
    return np.array([cosine, sine]).T, np.array(rest)


def _middle_length(B: FloatArray, K: FloatArray, M: FloatArray) -> float:
    """d of B = Rz(φ4) K Tz(d) M Rz(φ6), by least squares on three invariants."""
    l, p = B[:3, 2], B[:3, 3]
    R, t, e, u = K[:3, :3], K[:3, 3], M[:3, 2], M[:3, 3]
    slope = _middle_slope(K, M)
    start, direction = t + R @ u, R @ e
    rest = [p[2] - start[2], p @ l - start @ direction]
    rest.append((np.cross(p, l) - np.cross(start, direction))[2])
    return float(slope @ rest / (slope @ slope + TINY))


def _middle_slope(K: FloatArray, M: FloatArray) -> FloatArray:
    """The coefficients of a length φ5 in three invariants, (3,)."""
    axis, e = K[2, :3], M[:3, 2]
    return np.array([axis @ EZ, EZ @ e, axis @ np.cross(EZ, e)])


def _before_a_slide(B: FloatArray, K: FloatArray, M: FloatArray) -> tuple[float, float, float]:
    """φ4, φ5 and d of B = Rz(φ4) K Rz(φ5) M Tz(d)."""
    axis, row = K[2, :2], (B[2, :3] @ M[:3, :3].T)[:2]  # K's third row, turned by φ5
    phi_5 = atan2(float(axis[1] * row[0] - axis[0] * row[1]), float(axis @ row))
    C = K @ turn(phi_5) @ M
    # Rz(φ4) takes the x, y components of C's columns to those of B
    (cx, cy), (bx, by) = C[:2, :3], B[:2, :3]
    phi_4 = atan2(float(cx @ by - cy @ bx), float(cx @ bx + cy @ by))
    return phi_4, phi_5, float((rigid_inverse(turn(phi_4) @ C) @ B)[2, 3])

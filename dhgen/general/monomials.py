"""The fourteen monomials of a point and a direction, and how a rigid motion acts on them.

M. Raghavan and B. Roth, Inverse kinematics of the general 6R manipulator and related linkages,
ASME J. Mech. Des. 115 (1993), equations (9) to (14): with p and l the origin and the z axis of a
frame, l, p, p·p, p·l, p×l and (p·p) l − 2 (p·l) p have one set of power products. Together with 1
they span a representation of the rigid motions: x ↦ R x + t acts by a 15x15 matrix G(R, t),
G(A B) = G(A) G(B).

Arrays have the monomials on their first axis, poses on their last, anything between.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray


ONE, L, P, PP, PL, PXL, W = 0, 1, 4, 7, 8, 9, 12  # where each monomial begins
MONOMIALS = 15


def start(count: int) -> FloatArray:
    """Monomials of the origin with the direction z: (15, 1, N), the start of every chain."""
    x = np.zeros((MONOMIALS, 1, count))
    x[ONE] = x[L + 2] = 1.0
    return x


def act(K: FloatArray, x: FloatArray) -> FloatArray:
    """G(K) x for transforms (4, 4, N) and monomials (15, ..., N)."""
    t = K[:3, 3]
    one, pl = x[ONE], x[PL]
    u, q, v, w = (_turned(K, x[at : at + 3]) for at in (L, P, PXL, W))
    square, along = _dot(t, t), _dot(t, u)
    aside, twice = _cross(t, u), _cross(t, v)
    point = [q[i] + t[i] * one for i in range(3)]
    last = [w[i] - 2.0 * (t[i] * pl + twice[i] + t[i] * along) + square * u[i] for i in range(3)]
    scalars = [x[PP] + 2.0 * _dot(t, q) + square * one, pl + along]
    beside = [v[i] + aside[i] for i in range(3)]
    return np.stack([one, *u, *point, *scalars, *beside, *last])


def turn(x: FloatArray) -> FloatArray:
    """The coefficients of 1, cos φ and sin φ in G(Rz(φ)) x: (3, 15, ..., N)."""
    parts = np.zeros((3, *x.shape))
    parts[0] = x
    for at in (L, P, PXL, W):
        parts[0, at : at + 2] = 0.0
        parts[1, at], parts[1, at + 1] = x[at], x[at + 1]
        parts[2, at], parts[2, at + 1] = -x[at + 1], x[at]
    return parts


def slide(x: FloatArray) -> FloatArray:
    """The coefficients of 1, d and d² in G(Tz(d)) x: (3, 15, ..., N)."""
    parts = np.zeros((3, *x.shape))
    parts[0] = x
    parts[1, P + 2] = x[ONE]
    parts[1, PP], parts[1, PL] = 2.0 * x[P + 2], x[L + 2]
    parts[1, PXL], parts[1, PXL + 1] = -x[L + 1], x[L]
    parts[1, W], parts[1, W + 1] = 2.0 * x[PXL + 1], -2.0 * x[PXL]
    parts[1, W + 2] = -2.0 * x[PL]
    parts[2, PP] = x[ONE]
    parts[2, W], parts[2, W + 1], parts[2, W + 2] = x[L], x[L + 1], -x[L + 2]
    return parts


def _turned(K: FloatArray, v: FloatArray) -> list[FloatArray]:
    """R v, summed in a fixed order."""
    return [K[i, 0] * v[0] + K[i, 1] * v[1] + K[i, 2] * v[2] for i in range(3)]


def _dot(a: FloatArray | list[FloatArray], b: FloatArray | list[FloatArray]) -> FloatArray:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: FloatArray, b: list[FloatArray]) -> list[FloatArray]:
    return [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]

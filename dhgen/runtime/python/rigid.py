# SPDX-License-Identifier: MIT
"""Rigid transforms, three rows of four, twelve numbers each, and arrays of such."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .jit import of_file

if TYPE_CHECKING:
    from .arrays import Floats

OWN = of_file(__file__)
inner = OWN.inner


@inner
def take(to: Floats, numbers: Floats) -> None:
    """Copies numbers into an array as long; for slices numba compiles the text of an error, too."""
    for i in range(len(numbers)):
        to[i] = numbers[i]


@inner
def take_from(to: Floats, numbers: Floats, at: int) -> None:
    """Copies numbers from a place on into an array, which they fill."""
    for i in range(len(to)):
        to[i] = numbers[at + i]


@inner
def follow_from(P: Floats, numbers: Floats, at: int) -> None:
    """P K for rigid transforms, twelve numbers each, in place; K begins at a place of an array."""
    for i in range(0, 12, 4):
        a, b, c = P[i], P[i + 1], P[i + 2]
        for j in range(3):
            P[i + j] = a * numbers[at + j] + b * numbers[at + 4 + j] + c * numbers[at + 8 + j]
        P[i + 3] += a * numbers[at + 3] + b * numbers[at + 7] + c * numbers[at + 11]


@inner
def follow(T: Floats, K: Floats) -> None:
    """Multiplies T by K, in place."""
    for i in range(0, 12, 4):
        a, b, c = T[i], T[i + 1], T[i + 2]
        for j in range(3):
            T[i + j] = a * K[j] + b * K[4 + j] + c * K[8 + j]
        T[i + 3] += a * K[3] + b * K[7] + c * K[11]


@inner
def invert(A: Floats) -> Floats:
    """Returns the inverse of a rigid transform."""
    B = np.empty(12)
    for i in range(3):
        for j in range(3):
            B[4 * i + j] = A[4 * j + i]
        B[4 * i + 3] = -(A[i] * A[3] + A[4 + i] * A[7] + A[8 + i] * A[11])
    return B


@inner
def turn(T: Floats, c: float, s: float) -> None:
    """Multiplies T by a turn about z, in place."""
    for i in range(3):
        x, y = T[4 * i], T[4 * i + 1]
        T[4 * i] = x * c + y * s
        T[4 * i + 1] = y * c - x * s


@inner
def slide(T: Floats, d: float) -> None:
    """Multiplies T by a slide along z, in place."""
    for i in range(3):
        T[4 * i + 3] += T[4 * i + 2] * d


@inner
def pose_of_links(links: Floats, at: int, angles: Floats) -> Floats:
    """Returns C0 Rz(angle 1) C1 ... Rz(angle n) Cn; C0 ... Cn begin at a place of an array."""
    P = np.empty(12)
    take_from(P, links, at)
    for i in range(len(angles)):
        turn(P, math.cos(angles[i]), math.sin(angles[i]))
        follow_from(P, links, at + 12 * (i + 1))
    return P

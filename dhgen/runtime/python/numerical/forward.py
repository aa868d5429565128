# SPDX-License-Identifier: MIT
"""The forward model of any arm, from the list of its links."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..jit import of_file
from .places import (
    BASE,
    CHAIN,
    CHAIN_RECORD,
    DOF,
    JOINT_AFTER,
    JOINT_OFFSET,
    JOINT_SIGN,
    JOINT_TURNS,
    SHARE_FACTOR,
    SHARE_FROM,
    SHARE_OF,
    SHARE_RECORD,
)

if TYPE_CHECKING:
    from ..arrays import Floats

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
def _follow(P: Floats, numbers: Floats, at: int) -> None:
    """P K for rigid transforms, twelve numbers each, in place; K stands at a place of an array."""
    for i in range(0, 12, 4):
        a, b, c = P[i], P[i + 1], P[i + 2]
        for j in range(3):
            P[i + j] = a * numbers[at + j] + b * numbers[at + 4 + j] + c * numbers[at + 8 + j]
        P[i + 3] += a * numbers[at + 3] + b * numbers[at + 7] + c * numbers[at + 11]


@inner
def forward(arm: Floats, q: Floats, P: Floats, J: Floats) -> None:
    """Computes the pose of joint values, twelve numbers, and the geometric Jacobian (6, DOF)."""
    at = int(arm[CHAIN])
    shares = at + BASE + int(arm[DOF]) * CHAIN_RECORD
    take_from(P, arm, at)
    at += BASE
    for joint in range(int(arm[DOF])):
        for i in range(3):
            J[i, joint], J[3 + i, joint] = P[4 * i + 3], P[4 * i + 2]
        value = arm[at + JOINT_SIGN] * q[joint] + arm[at + JOINT_OFFSET]
        for k in range(int(arm[shares])):
            share = shares + 1 + k * SHARE_RECORD
            if arm[share + SHARE_OF] == joint:
                value += arm[share + SHARE_FACTOR] * q[int(arm[share + SHARE_FROM])]
        if arm[at + JOINT_TURNS] > 0.0:
            c, s = math.cos(value), math.sin(value)
            for i in range(0, 12, 4):
                x, y = P[i], P[i + 1]
                P[i], P[i + 1] = x * c + y * s, y * c - x * s
        else:
            for i in range(0, 12, 4):
                P[i + 3] += P[i + 2] * value
        _follow(P, arm, at + JOINT_AFTER)
        at += CHAIN_RECORD
    at = int(arm[CHAIN]) + BASE
    for joint in range(int(arm[DOF])):
        sign = arm[at + JOINT_SIGN]
        z0, z1, z2 = sign * J[3, joint], sign * J[4, joint], sign * J[5, joint]
        if arm[at + JOINT_TURNS] > 0.0:
            r0, r1, r2 = P[3] - J[0, joint], P[7] - J[1, joint], P[11] - J[2, joint]
            J[0, joint] = z1 * r2 - z2 * r1
            J[1, joint] = z2 * r0 - z0 * r2
            J[2, joint] = z0 * r1 - z1 * r0
            J[3, joint], J[4, joint], J[5, joint] = z0, z1, z2
        else:
            J[0, joint], J[1, joint], J[2, joint] = z0, z1, z2
            J[3, joint] = J[4, joint] = J[5, joint] = 0.0
        at += CHAIN_RECORD
    at = int(arm[CHAIN]) + BASE
    for k in range(int(arm[shares])):
        share = shares + 1 + k * SHARE_RECORD
        joint, other = int(arm[share + SHARE_OF]), int(arm[share + SHARE_FROM])
        factor = arm[share + SHARE_FACTOR] * arm[at + joint * CHAIN_RECORD + JOINT_SIGN]
        for i in range(6):
            J[i, other] += factor * J[i, joint]

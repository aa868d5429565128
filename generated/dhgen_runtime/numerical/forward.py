# SPDX-License-Identifier: MIT
"""The forward model of any arm, from the list of its links."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..rigid import follow_from, take_from
from .places import (
    BASE,
    CHAIN,
    CHAIN_RECORD,
    DOF,
    JOINT_AFTER,
    JOINT_OFFSET,
    JOINT_SIGN,
    JOINT_TURNS,
    LINKS,
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
def _axes(arm: Floats, q: Floats, P: Floats, axes: Floats) -> None:
    """Computes the pose of joint values, and the point and direction of every record's axis."""
    at, joint = int(arm[CHAIN]), 0
    shares = at + BASE + int(arm[LINKS]) * CHAIN_RECORD
    take_from(P, arm, at)
    at += BASE
    for row in range(int(arm[LINKS])):
        for i in range(3):
            axes[i, row], axes[3 + i, row] = P[4 * i + 3], P[4 * i + 2]
        value = arm[at + JOINT_OFFSET]
        if arm[at + JOINT_SIGN] != 0.0:
            value = arm[at + JOINT_SIGN] * q[joint] + arm[at + JOINT_OFFSET]
            joint += 1
        for k in range(int(arm[shares])):
            share = shares + 1 + k * SHARE_RECORD
            if arm[share + SHARE_OF] == row:
                value += arm[share + SHARE_FACTOR] * q[int(arm[share + SHARE_FROM])]
        if arm[at + JOINT_TURNS] > 0.0:
            c, s = math.cos(value), math.sin(value)
            for i in range(0, 12, 4):
                x, y = P[i], P[i + 1]
                P[i], P[i + 1] = x * c + y * s, y * c - x * s
        else:
            for i in range(0, 12, 4):
                P[i + 3] += P[i + 2] * value
        follow_from(P, arm, at + JOINT_AFTER)
        at += CHAIN_RECORD


@inner
def _columns(arm: Floats, P: Floats, J: Floats) -> None:
    """Replaces the axes of all records by the columns of the Jacobian for each of them alone."""
    at = int(arm[CHAIN]) + BASE
    for row in range(int(arm[LINKS])):
        sign = arm[at + JOINT_SIGN] if arm[at + JOINT_SIGN] != 0.0 else 1.0
        z0, z1, z2 = sign * J[3, row], sign * J[4, row], sign * J[5, row]
        if arm[at + JOINT_TURNS] > 0.0:
            r0, r1, r2 = P[3] - J[0, row], P[7] - J[1, row], P[11] - J[2, row]
            J[0, row] = z1 * r2 - z2 * r1
            J[1, row] = z2 * r0 - z0 * r2
            J[2, row] = z0 * r1 - z1 * r0
            J[3, row], J[4, row], J[5, row] = z0, z1, z2
        else:
            J[0, row], J[1, row], J[2, row] = z0, z1, z2
            J[3, row] = J[4, row] = J[5, row] = 0.0
        at += CHAIN_RECORD


@inner
def _add_shares(arm: Floats, columns: Floats, J: Floats) -> None:
    """Adds to joints' columns the columns of the records in which they have shares.

    Both may be one array: in the order of the records each is added to others before others are
    added to it.
    """
    first = int(arm[CHAIN]) + BASE
    shares = first + int(arm[LINKS]) * CHAIN_RECORD
    for k in range(int(arm[shares])):
        share = shares + 1 + k * SHARE_RECORD
        row, other = int(arm[share + SHARE_OF]), int(arm[share + SHARE_FROM])
        sign = arm[first + row * CHAIN_RECORD + JOINT_SIGN]
        factor = arm[share + SHARE_FACTOR] * (sign if sign != 0.0 else 1.0)
        for i in range(6):
            J[i, other] += factor * columns[i, row]


@inner
def forward(arm: Floats, q: Floats, P: Floats, J: Floats) -> None:
    """Computes the pose of joint values, twelve numbers, and the geometric Jacobian (6, DOF)."""
    links = int(arm[LINKS])
    columns = J if links == int(arm[DOF]) else np.empty((6, links))  # passive rows have no column
    _axes(arm, q, P, columns)
    _columns(arm, P, columns)
    joint, at = 0, int(arm[CHAIN]) + BASE + JOINT_SIGN
    for row in range(links if links > int(arm[DOF]) else 0):
        if arm[at + row * CHAIN_RECORD] != 0.0:
            for i in range(6):
                J[i, joint] = columns[i, row]
            joint += 1
    _add_shares(arm, columns, J)

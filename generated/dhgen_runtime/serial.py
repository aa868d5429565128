# SPDX-License-Identifier: MIT
"""Forward kinematics and the Jacobian of arms whose links come at run time, as serial.h has them.

Other arms have functions of their own.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .arm import FK, JACOBIAN, fk_at, jacobian_at
from .calibration import CONSTANT, FACING, calibration_of
from .jit import of_file
from .places import CALIBRATION
from .rigid import follow_from, pose_of_links, take_from, turn

if TYPE_CHECKING:
    from .arm import Robot
    from .arrays import Floats

OWN = of_file(__file__)


@OWN.apart("float64[:, ::1](float64[::1], float64[::1])")
def serial_pose(of: Floats, q: Floats) -> Floats:
    """Returns the pose (4, 4) of an arm of six turning joints."""
    angles, T = np.empty(6), np.zeros((4, 4))
    for i in range(6):
        angles[i] = of[FACING + i] * q[i]
    P = pose_of_links(of, CONSTANT, angles)
    for i in range(12):
        T[i // 4, i % 4] = P[i]
    T[3, 3] = 1.0
    return T


@OWN.apart("float64[:, ::1](float64[::1], float64[::1])")
def serial_jacobian(of: Floats, q: Floats) -> Floats:
    """Returns its geometric Jacobian (6, 6)."""
    P, axis, point, J = np.empty(12), np.empty((6, 3)), np.empty((6, 3)), np.empty((6, 6))
    take_from(P, of, CONSTANT)
    for i in range(6):
        for k in range(3):
            axis[i, k] = of[FACING + i] * P[4 * k + 2]
            point[i, k] = P[4 * k + 3]
        turn(P, math.cos(q[i]), of[FACING + i] * math.sin(q[i]))
        follow_from(P, of, CONSTANT + 12 * (i + 1))
    for i in range(6):
        for k in range(3):
            m, n = (k + 1) % 3, (k + 2) % 3
            J[k, i] = axis[i, m] * (P[4 * n + 3] - point[i, n]) - axis[i, n] * (
                P[4 * m + 3] - point[i, m]
            )
            J[3 + k, i] = axis[i, k]
    return J


@OWN.inner
def forward(arm: Floats, robot: Robot, q: Floats) -> Floats:
    """Returns the pose (4, 4) of joint values."""
    if arm[CALIBRATION] > 0.0:
        T: Floats = serial_pose(calibration_of(arm), q)
    else:
        T = fk_at(robot[FK], q)
    return T


@OWN.inner
def rates(arm: Floats, robot: Robot, q: Floats) -> Floats:
    """Returns the Jacobian (6, n) at joint values."""
    if arm[CALIBRATION] > 0.0:
        J: Floats = serial_jacobian(calibration_of(arm), q)
    else:
        J = jacobian_at(robot[JACOBIAN], q)
    return J

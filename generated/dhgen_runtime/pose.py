# SPDX-License-Identifier: MIT
"""Poses as callers give them: whether they are valid, and the nearest rotation where rounded.

What counts of a pose is the robot's affair: it takes the functions for its task. Each `read_`
returns whether what it looks at is valid, and the upper three rows, twelve numbers; that positions
are finite is asked by the robot. Each `miss_of_` returns by how much one of w poses side by side
(entry n of pose k at n * w + k) misses what it should be, in the same measure.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .jit import of_file

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

_HOW = of_file(__file__)

# The last row may differ from 0 0 0 1 by this, in the sum of what its entries are off.
LAST_ROW = 1e-9
# The sum of squares by which a rotation misses orthonormality, up to which it is replaced by the
# nearest rotation: a pose in single precision, or rounded to six digits. Beyond it the pose is
# invalid.
ROTATION = 1e-9
# The same sum, up to which a rotation is taken as it is: rounding.
ORTHONORMAL = 1e-24
# Of the tool's x axis, the length of what is seen from above, below which it has no yaw there: as
# much as a pose of six digits rounds it by.
NO_YAW = 1e-6

Rows = tuple[float, ...]


@_HOW.merged
def read_pose(T: NDArray[np.float64]) -> tuple[bool, Rows]:
    """A pose of which every entry counts."""
    rest = abs(T[3, 0]) + abs(T[3, 1]) + abs(T[3, 2]) + abs(T[3, 3] - 1.0)
    valid, rows = read_orientation(T)
    return valid and rest <= LAST_ROW, rows


@_HOW.merged
def read_orientation(T: NDArray[np.float64]) -> tuple[bool, Rows]:
    """A pose of which the rotation counts, and perhaps the position.

    Where it is only rounded, with the nearest rotation: R becomes (3 I - R R') R / 2, twice
    (Higham 1986).
    """
    x0, x1, x2, px = T[0, 0], T[0, 1], T[0, 2], T[0, 3]
    y0, y1, y2, py = T[1, 0], T[1, 1], T[1, 2], T[1, 3]
    z0, z1, z2, pz = T[2, 0], T[2, 1], T[2, 2], T[2, 3]
    xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0
    yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0
    xy = x0 * y0 + x1 * y1 + x2 * y2
    u, v, w = x1 * y2 - x2 * y1 - z0, x2 * y0 - x0 * y2 - z1, x0 * y1 - x1 * y0 - z2
    miss = xx * xx + yy * yy + 2.0 * xy * xy + u * u + v * v + w * w
    valid = miss <= ROTATION
    if valid and miss > ORTHONORMAL:
        for _ in range(2):
            xx = 1.5 - 0.5 * (x0 * x0 + x1 * x1 + x2 * x2)
            yy = 1.5 - 0.5 * (y0 * y0 + y1 * y1 + y2 * y2)
            zz = 1.5 - 0.5 * (z0 * z0 + z1 * z1 + z2 * z2)
            xy = -0.5 * (x0 * y0 + x1 * y1 + x2 * y2)
            xz = -0.5 * (x0 * z0 + x1 * z1 + x2 * z2)
            yz = -0.5 * (y0 * z0 + y1 * z1 + y2 * z2)
            x0, y0, z0 = (
                xx * x0 + xy * y0 + xz * z0,
                xy * x0 + yy * y0 + yz * z0,
                xz * x0 + yz * y0 + zz * z0,
            )
            x1, y1, z1 = (
                xx * x1 + xy * y1 + xz * z1,
                xy * x1 + yy * y1 + yz * z1,
                xz * x1 + yz * y1 + zz * z1,
            )
            x2, y2, z2 = (
                xx * x2 + xy * y2 + xz * z2,
                xy * x2 + yy * y2 + yz * z2,
                xz * x2 + yz * y2 + zz * z2,
            )
    return valid, (x0, x1, x2, px, y0, y1, y2, py, z0, z1, z2, pz)


@_HOW.merged
def read_pointing(T: NDArray[np.float64]) -> tuple[bool, Rows]:
    """A pose of which the position and the tool's z axis count, that with length one."""
    x2, y2, z2 = float(T[0, 2]), float(T[1, 2]), float(T[2, 2])
    square = x2 * x2 + y2 * y2 + z2 * z2
    miss = (square - 1.0) * (square - 1.0)
    valid = miss <= ROTATION
    if valid and miss > ORTHONORMAL:
        length = math.sqrt(square)
        x2, y2, z2 = x2 / length, y2 / length, z2 / length
    _, rows = read_position(T)
    x0, x1, _, px, y0, y1, _, py, z0, z1, _, pz = rows
    return valid, (x0, x1, x2, px, y0, y1, y2, py, z0, z1, z2, pz)


@_HOW.merged
def read_yaw(T: NDArray[np.float64]) -> tuple[bool, Rows]:
    """A pose of which the position and the yaw count: the tool's x axis becomes level.

    Straight up or down it has no yaw, which is free then: the axis becomes zero.
    """
    x, y = float(T[0, 0]), float(T[1, 0])  # of Python: its infinite products are no warnings
    square = x * x + y * y
    if not (square - 1.0) * (square - 1.0) <= ORTHONORMAL:
        length = math.sqrt(square)
        steep = length < NO_YAW
        x, y = 0.0 if steep else x / length, 0.0 if steep else y / length
    _, rows = read_position(T)
    _, x1, x2, px, _, y1, y2, py, _, z1, z2, pz = rows
    return square - square == 0.0, (x, x1, x2, px, y, y1, y2, py, 0.0, z1, z2, pz)


@_HOW.merged
def read_pitch(T: NDArray[np.float64]) -> tuple[bool, Rows]:
    """A pose of which the position and the pitch count, the sine of that being one at most."""
    _, rows = read_position(T)
    x0, x1, x2, px, y0, y1, y2, py, z0, z1, z2, pz = rows
    miss = miss_of_sine(float(z0))
    if miss > ORTHONORMAL:
        z0 = math.copysign(1.0, z0)
    return miss <= ROTATION, (x0, x1, x2, px, y0, y1, y2, py, z0, z1, z2, pz)


@_HOW.merged
def read_tilt(T: NDArray[np.float64]) -> tuple[bool, Rows]:
    """A pose of which the position and the third row count, that with length one."""
    z0, z1, z2 = float(T[2, 0]), float(T[2, 1]), float(T[2, 2])
    square = z0 * z0 + z1 * z1 + z2 * z2
    miss = (square - 1.0) * (square - 1.0)
    valid = miss <= ROTATION
    if valid and miss > ORTHONORMAL:
        length = math.sqrt(square)
        z0, z1, z2 = z0 / length, z1 / length, z2 / length
    _, rows = read_position(T)
    x0, x1, x2, px, y0, y1, y2, py, _, _, _, pz = rows
    return valid, (x0, x1, x2, px, y0, y1, y2, py, z0, z1, z2, pz)


@_HOW.merged
def read_position(T: NDArray[np.float64]) -> tuple[bool, Rows]:
    """A pose of which no direction counts: its upper three rows as they are."""
    return True, (
        T[0, 0], T[0, 1], T[0, 2], T[0, 3],
        T[1, 0], T[1, 1], T[1, 2], T[1, 3],
        T[2, 0], T[2, 1], T[2, 2], T[2, 3],
    )  # fmt: skip


@_HOW.merged
def miss_of_pose(T: NDArray[np.float64], k: int, w: int) -> float:
    """By how much pose k misses the form of one; what its last row is off counts in full."""
    rest = abs(T[12 * w + k]) + abs(T[13 * w + k]) + abs(T[14 * w + k])
    return float(miss_of_orientation(T, k, w) + rest + abs(T[15 * w + k] - 1.0))


@_HOW.merged
def miss_of_orientation(T: NDArray[np.float64], k: int, w: int) -> float:
    """By how much its rotation misses orthonormality."""
    x0, x1, x2 = T[k], T[w + k], T[2 * w + k]
    y0, y1, y2 = T[4 * w + k], T[5 * w + k], T[6 * w + k]
    z0, z1, z2 = T[8 * w + k], T[9 * w + k], T[10 * w + k]
    xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0
    yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0
    xy = x0 * y0 + x1 * y1 + x2 * y2
    a, b, c = x1 * y2 - x2 * y1 - z0, x2 * y0 - x0 * y2 - z1, x0 * y1 - x1 * y0 - z2
    return float(xx * xx + yy * yy + 2.0 * xy * xy + a * a + b * b + c * c)


@_HOW.merged
def miss_of_pointing(T: NDArray[np.float64], k: int, w: int) -> float:
    """By how much the tool's z axis misses length one."""
    x, y, z = T[2 * w + k], T[6 * w + k], T[10 * w + k]
    square = x * x + y * y + z * z - 1.0
    return float(square * square)


@_HOW.merged
def miss_of_yaw(T: NDArray[np.float64], k: int, w: int) -> float:
    """Nothing, of any length that is finite: formulas make the tool's x axis level themselves."""
    x, y = float(T[k]), float(T[4 * w + k])
    return 0.0 * (x * x + y * y)


@_HOW.merged
def miss_of_sine(sine: float) -> float:
    """The square of what a sine is above one; NaN if it is no number."""
    over = abs(sine) - 1.0
    return over * over if over > 0.0 else 0.0 * sine


@_HOW.merged
def miss_of_pitch(T: NDArray[np.float64], k: int, w: int) -> float:
    """By how much the sine of its pitch is above one."""
    return float(miss_of_sine(T[8 * w + k]))


@_HOW.merged
def miss_of_tilt(T: NDArray[np.float64], k: int, w: int) -> float:
    """By how much its third row misses length one."""
    x, y, z = T[8 * w + k], T[9 * w + k], T[10 * w + k]
    square = x * x + y * y + z * z - 1.0
    return float(square * square)


@_HOW.merged
def miss_of_position(T: NDArray[np.float64], k: int, w: int) -> float:  # noqa: ARG001
    """Nothing: no direction counts."""
    return 0.0

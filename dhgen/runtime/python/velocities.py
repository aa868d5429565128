# SPDX-License-Identifier: MIT
"""Joint velocities of a twist: exact where the arm is regular, damped near singular poses.

`functions.of_robot` makes `joint_velocities` anew for a robot, with the names that are declared.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .arguments import array_of
from .arm import ROBOT
from .jit import of_file
from .places import DIRECTIONS, MISS_WEIGHTS, PITCH, POINTING, RECORD, WEIGHT
from .refine import count_what_counts
from .serial import forward, rates

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike

    from .arm import Robot
    from .arrays import Floats

OWN = of_file(__file__)

# Damping begins at this singular value of the task's Jacobian, lengths in arm sizes: joints move at
# most a hundred times as fast as the tool.
DAMPED_BELOW = 0.01
ORTHOGONAL = 4e-15  # rows whose cosine is not above this are: rounding of sums of products
NOTHING = 1e-30  # so are those whose product is not above this: rounding of zero
SWEEPS = 20  # through all pairs of rows; six to eight do


@OWN.inner
def make_orthogonal(rows: Floats, width: int) -> None:
    """Turns pairs of rows until all are orthogonal in their first `width` entries.

    One-sided Jacobi rotations (M. R. Hestenes, 1958). The lengths of the rows are then the singular
    values; the entries behind these are rotated along.
    """
    for _ in range(SWEEPS):
        turned = False
        for i in range(5):
            for k in range(i + 1, 6):
                a, b, c = 0.0, 0.0, 0.0
                for j in range(width):
                    a += rows[i, j] * rows[i, j]
                    b += rows[k, j] * rows[k, j]
                    c += rows[i, j] * rows[k, j]
                if not abs(c) > max(ORTHOGONAL * math.sqrt(a * b), NOTHING):
                    continue
                turned = True
                ratio = 0.5 * (b - a) / c
                tangent = math.copysign(1.0, ratio) / (abs(ratio) + math.sqrt(1.0 + ratio * ratio))
                cosine = 1.0 / math.sqrt(1.0 + tangent * tangent)
                sine = cosine * tangent
                for j in range(rows.shape[1]):
                    x, y = rows[i, j], rows[k, j]
                    rows[i, j] = cosine * x - sine * y
                    rows[k, j] = sine * x + cosine * y
        if not turned:
            break


@OWN.apart(f"void(float64[::1], {ROBOT}, float64[::1], float64[::1], float64[::1])")
def find_velocities(
    arm: Floats, robot: Robot, q: Floats, twist: Floats, velocities: Floats
) -> None:
    """The joint velocities of a twist of the tool at joint values q, by least squares.

    Args:
        arm: The arm's numbers.
        robot: Its functions.
        q: Joint values (n,).
        twist: Velocity of the tool's origin, then angular velocity (6,).
        velocities: Is filled (n,).
    """
    dof, jacobian = len(q), rates(arm, robot, q)
    rows = np.zeros((6, dof + 1))
    for i in range(6):
        for j in range(dof):
            rows[i, j] = jacobian[i, j] / math.sqrt(arm[WEIGHT + RECORD * j])
        rows[i, dof] = twist[i]
    if arm[DIRECTIONS] in (POINTING, PITCH):
        count_what_counts(arm[DIRECTIONS], forward(arm, robot, q), rows)
    for i in range(6):
        for j in range(dof + 1):
            rows[i, j] *= arm[MISS_WEIGHTS + i]
    make_orthogonal(rows, dof)
    for j in range(dof):
        velocities[j] = 0.0
    for i in range(6):
        square = 0.0
        for j in range(dof):
            square += rows[i, j] * rows[i, j]
        share = rows[i, dof] / max(square, DAMPED_BELOW * DAMPED_BELOW)
        for j in range(dof):
            velocities[j] += share * rows[i, j] / math.sqrt(arm[WEIGHT + RECORD * j])


# Of the robot:
DOF: int
arm: Floats
robot: Callable[[], Robot]  # its functions, by their addresses


def velocities_at(q: Floats, twist: Floats) -> Floats:
    """The joint velocities of a twist, from plain arrays."""
    if q.shape != (DOF,) or twist.shape != (6,):
        raise ValueError("q and twist must hold a value for each joint, and six")
    found = np.empty(DOF)
    find_velocities(arm, robot(), q, twist, found)
    return found


def compiled_velocities(q: Floats, twist: Floats) -> Floats:
    """What `joint_velocities` is to other numba functions."""
    return velocities_at(q, twist)


def joint_velocities(q: ArrayLike, twist: ArrayLike) -> Floats:
    """The joint velocities ({DOF},) with which the tool moves by a twist.

    Of the twist counts what the task names. They are those of least squares, of these the least,
    and exact where the arm is regular. Near a singular pose what the arm hardly can do is damped:
    no joint velocity exceeds a hundred times the twist, lengths in arm sizes.

    Args:
        q: Joint values ({DOF},).
        twist: Velocity of the tool's origin, then angular velocity, in the base's frame (6,).

    Raises:
        ValueError: An argument has the wrong shape.
    """
    return velocities_at(array_of(q, (DOF,), "q"), array_of(twist, (6,), "twist"))

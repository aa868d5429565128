# SPDX-License-Identifier: MIT
"""A platform on legs: where these miss it, and how both move.

The velocities of a platform and of its drives, A xdot = B qdot, are those of Gosselin and Angeles
(Singularity analysis of closed-loop kinematic chains, 1990): of every leg's motion what its passive
joints can't make.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .pose import LAST_ROW, NO_YAW, read_orientation

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

POSE, YAW, COORDINATES = "pose", "yaw", "coordinates"
# Compiled it is merged with what calls it, and can't be called from here.
_ORIENTATION = getattr(read_orientation, "py_func", read_orientation)
LENGTHS = 3  # of six velocities the first are lengths


@dataclass(frozen=True, slots=True)
class Leg:
    """A leg: its chain's module, and where it stands.

    Attributes:
        module: The solver of its chain.
        driven: Its joints that are driven, from 0.
        counted: Which of the six velocities of its end the platform gives it.
        base: From the robot's base to its own, (4, 4): the inverse of its place.
        end: What it carries, in the platform's frame (4, 4).
    """

    module: Any
    driven: tuple[int, ...]
    counted: tuple[int, ...]
    base: Floats
    end: Floats

    @property
    def passive(self) -> tuple[int, ...]:
        """Its other joints, from 0."""
        return tuple(i for i in range(self.module.DOF) if i not in self.driven)

    def pose(self, X: Floats) -> Floats:
        """What it carries at poses (..., 4, 4) of the platform, in its own base."""
        posed: Floats = self.base @ X @ self.end
        return posed


@dataclass(frozen=True, slots=True)
class Platform:
    """A platform and its legs.

    Attributes:
        legs: All of them.
        task: What counts of the platform's orientation: POSE, YAW or COORDINATES.
        is_planar: Whether it moves in the plane of x and y.
        freedoms: Which of the six velocities it has.
        size: Of the robot [length].
    """

    legs: tuple[Leg, ...]
    task: str
    is_planar: bool
    freedoms: tuple[int, ...]
    size: float

    @property
    def scale(self) -> Floats:
        """What units of the freedoms are: lengths count in robot sizes."""
        return np.array([self.size if each < LENGTHS else 1.0 for each in self.freedoms])

    def read(self, T: Floats) -> tuple[bool, Floats]:
        """Whether a pose (4, 4) is one, and as far as the task names it, in full."""
        X = np.eye(4)
        X[:3, 3] = T[:3, 3]
        valid = True
        if self.task == POSE:
            valid, rows = _ORIENTATION(T)
            X[:3] = np.reshape(rows, (3, 4))
            valid = valid and np.abs(T[3] - X[3]).sum() <= LAST_ROW
        elif self.task == YAW:
            length = float(np.hypot(T[0, 0], T[1, 0]))
            valid = NO_YAW <= length < np.inf  # straight up it has no yaw
            c, s = (T[0, 0] / length, T[1, 0] / length) if valid else (1.0, 0.0)
            X[:2, :2] = [[c, -s], [s, c]]
        if self.is_planar:
            X[2, 3] = 0.0
        return bool(valid and np.isfinite(X).all()), X


@dataclass(frozen=True, slots=True)
class Motion:
    """How a leg's end moves; lengths count in robot sizes, also those of the platform.

    Attributes:
        V: Of the platform's freedoms, (m, n).
        J: Of the leg's joints, (m, m).
        miss: From where the leg ends to where the platform has it, (m,).
        free: Directions that passive joints don't move, (m, driven).
    """

    V: Floats
    J: Floats
    miss: Floats
    free: Floats


def motion_of(platform: Platform, leg: Leg, X: Floats, q: Floats) -> Motion:
    """A leg's motion at a pose (4, 4) of the platform and its own joint values."""
    wanted, is_at = leg.pose(X), np.asarray(leg.module.fk(q[: leg.module.DOF]))
    units = np.array([1.0 / platform.size] * LENGTHS + [1.0] * 3)
    J = units[:, None] * np.asarray(leg.module.jacobian(q[: leg.module.DOF]))
    turned = wanted[:3, :3] @ is_at[:3, :3].T
    miss = np.concatenate([(wanted - is_at)[:3, 3], 0.5 * _axial(turned - turned.T)])
    arm, R = X[:3, :3] @ leg.end[:3, 3], leg.base[:3, :3]
    V = np.zeros((6, 6))
    V[:3, :3] = V[3:, 3:] = R
    V[:3, 3:] = R @ -_crossing(arm) / platform.size
    rows = list(leg.counted)
    J = J[rows]
    reflected = np.linalg.qr(J[:, list(leg.passive)], mode="complete")[0]
    free = reflected[:, len(leg.passive) :]
    return Motion(V[np.ix_(rows, list(platform.freedoms))], J, (units * miss)[rows], free)


def rates(platform: Platform, motions: Sequence[Motion]) -> tuple[Floats, Floats]:
    """A and B, lengths in robot sizes."""
    count = len(platform.freedoms)
    A, B = np.zeros((count, count)), np.zeros((count, count))
    row = 0
    for leg, motion in zip(platform.legs, motions, strict=True):
        rows = slice(row, row + len(leg.driven))
        A[rows] = motion.free.T @ motion.V
        B[rows, rows] = motion.free.T @ motion.J[:, list(leg.driven)]
        row += len(leg.driven)
    return A, B


def moved_by(platform: Platform, X: Floats, step: Floats) -> Floats:
    """A pose (4, 4) moved by its freedoms, lengths in robot sizes."""
    twist = np.zeros(6)
    twist[list(platform.freedoms)] = step
    moved = X.copy()
    moved[:3, 3] += platform.size * twist[:3]
    angle = float(np.linalg.norm(twist[3:]))
    if angle > 0.0:
        K = _crossing(twist[3:] / angle)
        turn = np.eye(3) + np.sin(angle) * K + 2.0 * np.sin(0.5 * angle) ** 2 * (K @ K)
        moved[:3, :3] = turn @ X[:3, :3]
    return moved


def _crossing(w: Floats) -> Floats:
    """The matrix K with K p = w x p."""
    x, y, z = w
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def _axial(K: Floats) -> Floats:
    """The w of a skew matrix."""
    return np.array([K[2, 1], K[0, 2], K[1, 0]])

# SPDX-License-Identifier: MIT
"""A platform on legs: where these miss it, and how both move.

The velocities of a platform and of its drives, A xdot = B qdot, are those of Gosselin and Angeles
(Singularity analysis of closed-loop kinematic chains, 1990): of every leg's motion what its passive
joints can't make.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .jit import of_file
from .pose import NO_YAW, read_pose

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Truths = NDArray[np.bool_]

POSE, YAW, COORDINATES = "pose", "yaw", "coordinates"
LENGTHS = 3  # of six velocities the first are lengths
# A's smallest singular value below which a platform is singular, lengths in robot sizes, and what a
# passive joint has to move of its own, besides those before it, not to depend on them [rad, robot
# sizes]: the square root of what legs may miss, so that what is computed above it has six digits.
SINGULAR_PLATFORM = 1e-6
_HOW = of_file(__file__)


@_HOW.jit
def read_platforms(
    T: Floats, is_whole: bool, has_yaw: bool, is_planar: bool, X: Floats, valid: Truths
) -> None:
    """Poses (N, 4, 4) of a platform as far as its task names them, in full, and whether they are.

    X comes as identities; what is no pose leaves one.

    Args:
        T: The poses as they are given.
        is_whole: Whether all of a pose counts.
        has_yaw: Whether the place and the yaw count.
        is_planar: Whether the platform moves in the plane of x and y.
        X: The poses as they are read.
        valid: Whether each is one.
    """
    for k in range(len(T)):
        good = True
        if is_whole:
            good, rows = read_pose(T[k])
            if good:
                for i in range(12):
                    X[k, i // 4, i % 4] = rows[i]
        elif has_yaw:
            length = math.hypot(T[k, 0, 0], T[k, 1, 0])
            good = NO_YAW <= length < math.inf  # straight up it has no yaw
            if good:
                c, s = T[k, 0, 0] / length, T[k, 1, 0] / length
                X[k, 0, 0], X[k, 0, 1], X[k, 1, 0], X[k, 1, 1] = c, -s, s, c
        lengths = 2 if is_planar else 3
        for i in range(lengths):
            good = good and math.isfinite(T[k, i, 3])
        for i in range(lengths):
            X[k, i, 3] = T[k, i, 3] if good else 0.0
        valid[k] = good


@_HOW.jit
def place_ends(X: Floats, bases: Floats, ends: Floats, poses: Floats) -> None:
    """What legs carry at poses (N, 4, 4) of the platform, each in its own base.

    Args:
        X: The poses of the platform.
        bases: From the robot's base to those of the legs (LEGS, 4, 4).
        ends: What they carry, in the platform's frame (LEGS, 4, 4).
        poses: Takes them, (N, LEGS, 4, 4).
    """
    for k in range(len(X)):
        for leg in range(len(bases)):
            base, end = bases[leg], ends[leg]
            for j in range(4):
                last = 1.0 if j == 3 else 0.0
                x = X[k, 0, 0] * end[0, j] + X[k, 0, 1] * end[1, j] + X[k, 0, 2] * end[2, j]
                y = X[k, 1, 0] * end[0, j] + X[k, 1, 1] * end[1, j] + X[k, 1, 2] * end[2, j]
                z = X[k, 2, 0] * end[0, j] + X[k, 2, 1] * end[1, j] + X[k, 2, 2] * end[2, j]
                x, y, z = x + last * X[k, 0, 3], y + last * X[k, 1, 3], z + last * X[k, 2, 3]
                for i in range(3):
                    poses[k, leg, i, j] = (
                        base[i, 0] * x + base[i, 1] * y + base[i, 2] * z + last * base[i, 3]
                    )
                poses[k, leg, 3, j] = last


def drives_of(driven: Sequence[Sequence[int]], q: Floats) -> Floats:
    """The drives: values of driven joints, leg by leg, out of joint values (..., LEGS, JOINTS).

    Args:
        driven: Of every leg its joints that are driven, from 0.
        q: The joint values.
    """
    legs = [number for number, own in enumerate(driven) for _ in own]
    return q[..., legs, [joint for own in driven for joint in own]]


def driven_of_rows(driven: Sequence[Sequence[int]], q: Floats) -> Floats:
    """The driven joints of rows (..., LEGS, ROWS, JOINTS), NaN where a leg has fewer.

    Args:
        driven: Of every leg its joints that are driven, from 0.
        q: The rows.
    """
    taken = np.full((*q.shape[:-1], max(map(len, driven))), np.nan)
    for number, own in enumerate(driven):
        taken[..., number, :, : len(own)] = q[..., number, :, :][..., list(own)]
    return taken


@dataclass(frozen=True, slots=True)
class Leg:
    """A leg: its chain's module, and where it is mounted.

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
        valid, X = self.read_all(T[None])
        return bool(valid[0]), X[0]

    def read_all(self, T: Floats) -> tuple[Truths, Floats]:
        """Reads poses (N, 4, 4)."""
        valid, X = np.empty(len(T), np.bool_), np.empty((len(T), 4, 4))
        X[:] = np.eye(4)
        poses = np.ascontiguousarray(T)
        read_platforms(poses, self.task == POSE, self.task == YAW, self.is_planar, X, valid)
        return valid, X


@dataclass(frozen=True, slots=True)
class Motion:
    """How a leg's end moves; all lengths, also the platform's, are in robot sizes.

    Attributes:
        V: Of the platform's freedoms, (m, n).
        J: Of the leg's joints, (m, m).
        miss: From where the leg ends to where the platform has it, (m,).
        free: Directions that passive joints don't move, (m, driven): the first is the one that the
            first driven joint moves, forwards, the others what the next ones move besides.
        is_free: Whether passive joints depend on each other: these move while the end rests, and
            which directions they don't move is not determined.
    """

    V: Floats
    J: Floats
    miss: Floats
    free: Floats
    is_free: bool


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
    slides = [platform.size if leg.module.JOINT_TYPES[i] == "P" else 1.0 for i in leg.passive]
    free, is_free = _without_passive(slides * J[:, list(leg.passive)], J[:, list(leg.driven)])
    freedoms = list(platform.freedoms)
    return Motion(V[np.ix_(rows, freedoms)], J, (units * miss)[rows], free, is_free)


def _without_passive(passive: Floats, driven: Floats) -> tuple[Floats, bool]:
    """Directions that passive joints don't move, and whether these depend on each other.

    Args:
        passive: What passive joints move (m, passive), slides by robot sizes.
        driven: What driven joints move (m, driven).
    """
    moved = np.empty((len(passive), 0))
    for column in passive.T:
        rest = column - moved @ (moved.T @ column)
        rest -= moved @ (moved.T @ rest)  # the first time leaves rounding of what is taken away
        length = np.linalg.norm(rest)
        if length > SINGULAR_PLATFORM:
            moved = np.column_stack([moved, rest / length])
    others = np.linalg.qr(moved, mode="complete")[0][:, moved.shape[1] :]
    turned, R = np.linalg.qr(others.T @ driven, mode="complete")
    signs = np.where(np.diagonal(R) < 0.0, -1.0, 1.0)
    free: Floats = others @ turned[:, : driven.shape[1]] * signs
    return free, moved.shape[1] < passive.shape[1]


def rates(platform: Platform, motions: Sequence[Motion]) -> tuple[Floats, Floats]:
    """A and B, lengths in robot sizes; B has nothing below its diagonal."""
    count = len(platform.freedoms)
    A, B = np.zeros((count, count)), np.zeros((count, count))
    row = 0
    for leg, motion in zip(platform.legs, motions, strict=True):
        rows = slice(row, row + len(leg.driven))
        A[rows] = motion.free.T @ motion.V
        B[rows, rows] = np.triu(motion.free.T @ motion.J[:, list(leg.driven)])
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

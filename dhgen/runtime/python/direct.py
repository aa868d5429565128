# SPDX-License-Identifier: MIT
"""The direct model of a platform near a seed: bounded Newton steps on all loops at once."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from .platform import SINGULAR_PLATFORM, Leg, Platform, motion_of, moved_by, rates
from .status import FREE_JOINT, INVALID_POSE, OK, UNREACHABLE

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

DIRECT_STEPS = 60  # of the direct model
DIRECT_STEP = 0.25  # the longest of those [rad, robot sizes]
CLOSED = 1e-12  # what legs may miss the platform by [robot sizes, rad]
DIRECT_DAMPING = 1e-14  # of a step, as a share of the squares that it divides
SAME_DRIVES = 1e-9  # drives of two rows that differ by less are the same [rad, robot sizes]
TURN = 2.0 * np.pi


def direct(
    platform: Platform, drives: Floats, T_seed: Floats, width: int
) -> tuple[Floats, Floats, int]:
    """The pose near a seed, the joint values (legs, width) and a status; NaN without a pose."""
    none = np.full((4, 4), np.nan), np.full((len(platform.legs), width), np.nan)
    valid, X = platform.read(T_seed)
    if not valid or not np.isfinite(drives).all():
        return (*none, INVALID_POSE)
    q = none[1].copy()
    firsts = np.cumsum([0, *(len(leg.driven) for leg in platform.legs)])
    own = [drives[first:last] for first, last in pairwise(firsts)]
    for number, leg in enumerate(platform.legs):
        nearest = _nearest_drives(platform, leg, X, own[number])
        if nearest is None:
            return (*none, UNREACHABLE)
        q[number, : leg.module.DOF] = nearest
    for _ in range(DIRECT_STEPS):
        motions = [motion_of(platform, leg, X, q[i]) for i, leg in enumerate(platform.legs)]
        A, _ = rates(platform, motions)
        freed = [motion.free.T @ motion.miss for motion in motions]
        step = _damped(A, -np.concatenate(freed))
        longest = np.abs(step).max()
        share = min(1.0, DIRECT_STEP / longest) if longest > 0.0 else 1.0
        step *= share
        X = moved_by(platform, X, step)
        for number, (leg, motion) in enumerate(zip(platform.legs, motions, strict=True)):
            passive = list(leg.passive)
            if motion.is_free:  # they can't follow by steps
                nearest = _nearest_drives(platform, leg, X, own[number])
                if nearest is not None:
                    q[number, : leg.module.DOF] = nearest
            elif passive:
                moved = _damped(motion.J[:, passive], share * motion.miss + motion.V @ step)
                most = np.abs(moved).max()
                q[number, passive] += moved * min(1.0, 2.0 * DIRECT_STEP / max(most, 1e-300))
        if max(np.abs(motion.miss).max() for motion in motions) <= CLOSED:
            for number, leg in enumerate(platform.legs):
                turns = [i for i in leg.passive if leg.module.JOINT_TYPES[i] == "R"]
                q[number, turns] -= TURN * np.ceil(q[number, turns] / TURN - 0.5)
            regular = least_values(platform, X, q)[1] > SINGULAR_PLATFORM
            return X, q, OK if regular else FREE_JOINT
    return (*none, UNREACHABLE)


def least_values(platform: Platform, X: Floats, q: Floats) -> tuple[float, float]:
    """The smallest singular values of B and of A; lengths in robot sizes.

    Where passive joints of a leg depend on each other the leg takes a motion away, and A is not
    determined: 0 and NaN.
    """
    motions = [motion_of(platform, leg, X, q[i]) for i, leg in enumerate(platform.legs)]
    if any(motion.is_free for motion in motions):
        return 0.0, math.nan
    A, B = rates(platform, motions)
    one, other = (np.linalg.svd(each, compute_uv=False) for each in (B * drive_scale(platform), A))
    return float(one[-1]), float(other[-1])


def drive_scale(platform: Platform) -> Floats:
    """What units of the drives are: lengths count in robot sizes."""
    slides = [leg.module.JOINT_TYPES[i] == "P" for leg in platform.legs for i in leg.driven]
    return np.where(slides, platform.size, 1.0)


def _damped(M: Floats, y: Floats) -> Floats:
    """The least squares of M x = y, damped a little: it has an answer where M is singular, too."""
    squares = M.T @ M
    damping = DIRECT_DAMPING * np.trace(squares) + 1e-300
    return np.linalg.solve(squares + damping * np.eye(len(squares)), M.T @ y)


def _nearest_drives(platform: Platform, leg: Leg, X: Floats, drives: Floats) -> Floats | None:
    """The leg's joint values at a pose with drives nearest to given ones, and replaced by these.

    A row within limits goes before rows that differ from it in passive joints alone.
    """
    rows, status = map(np.asarray, leg.module.ik_all(leg.pose(X)))
    has = ~np.isnan(rows).any(axis=1)
    rows, good = rows[has], ((status == OK) | (status == FREE_JOINT))[has]
    if not len(rows):
        return None
    miss = np.zeros(len(rows))
    for joint, drive in zip(leg.driven, drives, strict=True):
        off = rows[:, joint] - drive
        turns = leg.module.JOINT_TYPES[joint] == "R"
        miss += np.abs(off - TURN * np.ceil(off / TURN - 0.5) if turns else off / platform.size)
    near = miss <= miss.min() + SAME_DRIVES
    own: Floats = rows[np.argmax(near & good if (near & good).any() else near)].copy()
    own[list(leg.driven)] = drives
    return own

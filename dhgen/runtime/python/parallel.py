# SPDX-License-Identifier: MIT
"""Parallel robots: the public functions of a platform on legs, each of them a serial arm.

The inverse model is that of the legs. Joint values are (LEGS, JOINTS), solutions (LEGS, ROWS,
JOINTS); a leg with fewer joints or rows has NaN in the rest.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from .arguments import array_of
from .assemblies import assemblies
from .direct import direct, drive_scale
from .entry import poses_of
from .platform import (
    Leg,
    Motion,
    Platform,
    driven_of_rows,
    drives_of,
    motion_of,
    place_ends,
    rates,
)
from .status import FREE_JOINT, INVALID_POSE, UNREACHABLE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, NDArray

    Floats = NDArray[np.float64]
    Statuses = NDArray[np.uint8]


class Singularities(NamedTuple):
    """How near a robot is to its singularities, and what is lost or gained there.

    Attributes:
        first: The smallest singular value of B: 0 where the platform loses a motion.
        second: The same of A: 0 where the platform has a motion that the drives do not hold. NaN
            where passive joints of a leg depend on each other: first is 0, A is not determined.
        lost: The combination of the platform's velocities (6,) that vanishes at the first kind.
        gained: The twist (6,) that the platform has at the second kind with all drives at rest.
    """

    first: float
    second: float
    lost: Floats
    gained: Floats


class Functions:
    """The functions of a parallel robot.

    Args:
        platform: The robot.
        unreachable: The exception for poses that are out of reach.
        elimination: How all assemblies are found; nothing where that is not known.
    """

    def __init__(
        self, platform: Platform, unreachable: type[ValueError], elimination: str = ""
    ) -> None:
        self._platform = platform
        self._unreachable = unreachable
        self._elimination = elimination
        self._legs = platform.legs
        self._joints = max(leg.module.DOF for leg in self._legs)
        self._rows = max(leg.module.MAX_SOLUTIONS for leg in self._legs)
        self._drives = len(platform.freedoms)
        self._driven = [leg.driven for leg in self._legs]
        self._bases = np.array([leg.base for leg in self._legs])
        self._ends = np.array([leg.end for leg in self._legs])
        chains: dict[str, tuple[Any, list[int]]] = {}
        for number, leg in enumerate(self._legs):
            chains.setdefault(leg.module.__name__, (leg.module, []))[1].append(number)
        self._chains = list(chains.values())

    def ik_all(self, T: ArrayLike, q_seed: ArrayLike | None = None) -> tuple[Floats, Statuses]:
        """All solutions of all legs: q (LEGS, ROWS, JOINTS) and status (LEGS, ROWS).

        Row b of a leg is always branch BRANCHES[leg][b]; a working mode is a row of every leg.

        Args:
            T: Pose of the platform (4, 4).
            q_seed: Values for joints that are indeterminate at this pose (LEGS, JOINTS).

        Raises:
            ValueError: An argument has the wrong shape, or the seed is not finite.
        """
        pose = array_of(T, (4, 4), "T")
        if q_seed is None:
            q, status = self._solved(pose[None])
            return q[0], status[0]
        seed = self._of_legs(q_seed, "q_seed")
        q, status = self._nothing(1)
        valid, X = self._platform.read(pose)
        if not valid:
            status[:] = INVALID_POSE
            return q[0], status[0]
        for number, leg in enumerate(self._legs):
            rows, statuses = leg.module.ik_all(leg.pose(X), seed[number, : leg.module.DOF])
            q[0, number, : len(rows), : rows.shape[1]] = rows
            status[0, number, : len(statuses)] = statuses
        self._refuse(q, status)
        return q[0], status[0]

    def ik_batch(self, T: ArrayLike) -> tuple[Floats, Statuses]:
        """ik_all for N poses (N, 4, 4): q (N, LEGS, ROWS, JOINTS) and status (N, LEGS, ROWS).

        Raises:
            ValueError: T has the wrong shape.
        """
        return self._solved(poses_of(T, None))

    def _solved(self, T: Floats) -> tuple[Floats, Statuses]:
        """All solutions at poses (N, 4, 4): legs of one chain are solved together."""
        valid, X = self._platform.read_all(T)
        poses = np.empty((len(X), len(self._legs), 4, 4))
        place_ends(X, self._bases, self._ends, poses)
        if len(self._chains) == 1:
            rows, statuses = self._chains[0][0].ik_batch(poses.reshape(-1, 4, 4))
            q = rows.reshape(*poses.shape[:2], *rows.shape[1:])
            status = statuses.reshape(q.shape[:3])
        else:
            q, status = self._nothing(len(X))
            for module, numbers in self._chains:
                rows, statuses = module.ik_batch(poses[:, numbers].reshape(-1, 4, 4))
                places = len(X), len(numbers), *rows.shape[1:]
                q[:, numbers, : places[2], : places[3]] = rows.reshape(places)
                status[:, numbers, : places[2]] = statuses.reshape(places[:3])
        status[~valid] = INVALID_POSE
        self._refuse(q, status)
        return q, status

    def ik_drives(self, T: ArrayLike) -> tuple[Floats, Statuses]:
        """The driven joints alone of what ik_all gives: (LEGS, ROWS, most driven joints of a leg).

        Raises:
            ValueError: T has the wrong shape.
        """
        q, status = self.ik_all(T)
        return driven_of_rows(self._driven, q), status

    def ik_drives_batch(self, T: ArrayLike) -> tuple[Floats, Statuses]:
        """ik_drives for N poses (N, 4, 4).

        Raises:
            ValueError: T has the wrong shape.
        """
        q, status = self.ik_batch(T)
        return driven_of_rows(self._driven, q), status

    def ik(
        self,
        T: ArrayLike,
        q_seed: ArrayLike | None = None,
        *,
        branch: Sequence[str | int] | None = None,
        limits: bool = True,
    ) -> Floats:
        """One solution (LEGS, JOINTS): of every leg the nearest to the seed.

        Args:
            T: Pose of the platform (4, 4).
            q_seed: Where the legs are (LEGS, JOINTS); zeros without it.
            branch: Only this working mode: for every leg a name from BRANCHES, or its row.
            limits: Whether joint limits count.

        Raises:
            Unreachable: A leg has no such solution; the message says which and why.
            ValueError: T is not a valid pose, a branch does not exist, or an argument has the wrong
                shape.
        """
        pose = array_of(T, (4, 4), "T")
        seed = self._of_legs(np.zeros(self._shape) if q_seed is None else q_seed, "q_seed")
        if branch is not None and (
            isinstance(branch, str) or np.ndim(branch) != 1 or len(branch) != len(self._legs)
        ):
            raise ValueError(f"branch names a row of each of the {len(self._legs)} legs")
        valid, X = self._platform.read(pose)
        if not valid:
            raise ValueError("T is not a valid pose of the platform")
        q = np.full(self._shape, np.nan)
        for number, leg in enumerate(self._legs):
            own, mode = seed[number, : leg.module.DOF], None if branch is None else branch[number]
            try:
                solved = leg.module.ik(leg.pose(X), own, branch=mode, limits=limits)
            except ValueError as error:
                lost = isinstance(error, leg.module.Unreachable)
                kind = self._unreachable if lost else ValueError
                raise kind(f"leg {number + 1}: {error}") from None
            q[number, : leg.module.DOF] = solved
        return q

    def drives(self, q: ArrayLike) -> Floats:
        """The driven ones, in the order of DRIVES, of all joint values (LEGS, JOINTS)."""
        return drives_of(self._driven, self._of_legs(q, "q", finite=False))

    def fk(self, drives: ArrayLike, T_seed: ArrayLike) -> tuple[Floats, Floats, int]:
        """The platform's pose that drives' values make, refined from a pose nearby.

        Args:
            drives: Values of the driven joints, in the order of DRIVES.
            T_seed: A pose of the platform (4, 4) that the legs reach, near the one that is sought.

        Returns:
            The pose (4, 4), the joint values (LEGS, JOINTS) and a status: OK; FREE_JOINT where
            the platform is singular there, so that other poses meet this one, or it or passive
            joints of a leg can move; with NaN UNREACHABLE where the legs did not meet the platform,
            or do not reach the seed, and INVALID_POSE.

        Raises:
            ValueError: An argument has the wrong shape.
        """
        values = array_of(drives, (self._drives,), "drives")
        with np.errstate(over="ignore", invalid="ignore"):  # far away nothing closes
            return direct(self._platform, values, array_of(T_seed, (4, 4), "T_seed"), self._joints)

    def assemblies(self, drives: ArrayLike) -> Floats:
        """All poses (k, 4, 4) of the platform that drives' values allow.

        Raises:
            ValueError: drives has the wrong shape, or is not finite, or the platform can move while
                these drives are held, so that its poses are a continuum.
            NotImplementedError: For this robot no elimination is known: ASSEMBLIES is 0.
        """
        values = array_of(drives, (self._drives,), "drives")
        if not self._elimination:
            raise NotImplementedError(
                "how many poses drives allow is not known of this robot: `fk` finds the one near "
                "a seed"
            )
        if not np.isfinite(values).all():
            raise ValueError("drives are not finite")
        with np.errstate(over="ignore", invalid="ignore"):  # far away nothing closes
            return assemblies(self._platform, self._elimination, values, self._joints)

    def velocities(self, T: ArrayLike, q: ArrayLike) -> tuple[Floats, Floats]:
        """A and B, with A xdot = B qdot at a pose and its joint values.

        xdot are the platform's velocities that the task names, of its origin and then angular, qdot
        those of the drives.

        Raises:
            ValueError: T is not a valid pose, passive joints of a leg depend on each other, so that
                A and B are not determined, or an argument has the wrong shape.
        """
        motions = self._motions(T, q)
        for number, motion in enumerate(motions, start=1):
            if motion.is_free:
                raise ValueError(
                    f"passive joints of leg {number} depend on each other: they move while the "
                    "platform rests, and A and B are not determined"
                )
        A, B = rates(self._platform, motions)
        size = self._platform.size
        return A * size / self._platform.scale, B * size

    def singularities(self, T: ArrayLike, q: ArrayLike) -> Singularities:
        """How near a pose and its joint values are to singularities, lengths in robot sizes.

        Raises:
            ValueError: T is not a valid pose, or an argument has the wrong shape.
        """
        motions = self._motions(T, q)
        scale, freedoms = self._platform.scale, list(self._platform.freedoms)
        lost, gained = np.zeros(6), np.zeros(6)
        for motion in motions:
            if motion.is_free:
                across = np.linalg.svd(motion.J)[0][:, -1]  # where the leg can't move its end
                lost[freedoms], gained[freedoms] = across @ motion.V / scale, np.nan
                return Singularities(0.0, math.nan, lost, gained)
        A, B = rates(self._platform, motions)
        left, of_B, _ = np.linalg.svd(B * drive_scale(self._platform))
        _, of_A, right = np.linalg.svd(A)
        lost[freedoms] = left[:, -1] @ A / scale
        gained[freedoms] = right[-1] * scale
        return Singularities(float(of_B[-1]), float(of_A[-1]), lost, gained)

    def _motions(self, T: ArrayLike, q: ArrayLike) -> list[Motion]:
        """Of every leg how its end moves."""
        valid, X = self._platform.read(array_of(T, (4, 4), "T"))
        if not valid:
            raise ValueError("T is not a valid pose of the platform")
        own = self._of_legs(q, "q")
        return [motion_of(self._platform, leg, X, own[i]) for i, leg in enumerate(self._legs)]

    @staticmethod
    def _refuse(q: Floats, status: Statuses) -> None:
        """Empties all rows of poses that a leg refuses: too far for squares of lengths, or none."""
        refused = (status == INVALID_POSE).any(axis=(1, 2))
        q[refused], status[refused] = np.nan, INVALID_POSE

    @property
    def _shape(self) -> tuple[int, int]:
        return len(self._legs), self._joints

    def _nothing(self, count: int) -> tuple[Floats, Statuses]:
        """Rows of no leg."""
        shape = (count, len(self._legs), self._rows)
        return np.full((*shape, self._joints), np.nan), np.full(shape, UNREACHABLE, np.uint8)

    def _of_legs(self, values: ArrayLike, name: str, *, finite: bool = True) -> Floats:
        """Joint values of all legs; what a leg has not may be anything.

        Raises:
            ValueError: The shape is wrong, or a value that counts is not finite.
        """
        own = array_of(values, self._shape, name)
        for number, leg in enumerate(self._legs):
            if finite and not np.isfinite(own[number, : leg.module.DOF]).all():
                raise ValueError(f"{name} of leg {number + 1} is not finite")
        return own


__all__ = ["FREE_JOINT", "Functions", "Leg", "Platform", "Singularities"]

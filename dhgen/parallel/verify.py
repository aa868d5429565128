"""Proves that the written files of a parallel robot do what they promise, or refuses them.

The legs' chains are proven as serial arms before. Here every row closes its leg by an independent
forward model, C and Python agree, the direct model returns to the pose from a pose nearby, and A
and B agree with differences of the inverse model.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.errors import ImmobileError, VerificationError
from dhgen.oracle.forward import forward
from dhgen.parallel.native import Native, compiled
from dhgen.parallel.worked import DRAWN, drawn_poses, reached, square, turn_about
from dhgen.runtime.python.platform import SINGULAR_PLATFORM, driven_of_rows
from dhgen.status import Status
from dhgen.verify.compiled import import_temporary

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path
    from types import ModuleType

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.parallel.module import ParallelModule
    from dhgen.verify.verify import Report

    Statuses = NDArray[np.uint8]

POSES = 60  # that are looked at
TRIES = 20  # times that poses are drawn
CLOSED = 1e-11  # what a leg may miss the platform by [robot sizes, rad]
AGREED = 1e-9  # what C and Python may differ by where legs are regular [rad, robot sizes]
BESIDE = 1e-3  # where the direct model starts, beside the pose [rad, robot sizes]
REGULAR = 0.02  # smallest singular value of A and B above which a pose is taken for regular
STEP, SLOPE = 1e-5, 1e-6  # of differences [rad, robot sizes]; what these may be away, to their size


@dataclass(frozen=True, slots=True)
class ParallelReport:
    """What verification saw.

    Attributes:
        chains: Of each kind of leg.
        poses: Poses of the platform that were solved.
        modes: Working modes that were found on them.
        residual: The largest miss of a leg, in robot sizes.
        compiled: Whether a C compiler was there.
        code: What numba compiled of each leg's module.
    """

    chains: tuple[Report, ...]
    poses: int
    modes: int
    residual: float
    compiled: bool
    code: Mapping[str, Mapping[str, bytes]]


def verify_parallel(
    module: ParallelModule, folder: Path, chains: Sequence[Report]
) -> ParallelReport:
    """Checks the files of a parallel robot as they lie in a folder.

    Raises:
        ImmobileError: The legs can't move the platform.
        VerificationError: Something is not as promised.
    """
    python = import_temporary(folder / f"{module.name}.py")
    native = compiled(module, folder)
    poses = reachable(module, python, POSES)
    checker = _Checker(module, python, native)
    for T in poses:
        checker.pose(T)
    checker.drives_hold()
    checker.batch(poses)
    checker.no_pose(poses[0])
    code = {name: own for report in chains for name, own in report.code.items()}
    seen = checker.modes, checker.residual, native is not None
    return ParallelReport(tuple(chains), len(poses), *seen, code)


def reachable(module: ParallelModule, python: ModuleType, count: int, seed: int = 5) -> FloatArray:
    """Poses of the platform that all legs reach within their limits.

    Raises:
        ImmobileError: There is hardly any.
    """
    found = reached(module, lambda T: are_inside(python.ik_batch(T)[1]), count, seed, TRIES)
    if len(found) == count:
        return found
    raise ImmobileError(
        f"within their limits all legs reach {len(found)} of {TRIES * DRAWN} poses of the platform "
        f"that leg 1 can take, {_without_limits(module, python, seed)}"
    )


def _without_limits(module: ParallelModule, python: ModuleType, seed: int) -> str:
    """What legs that hardly reach poses together reach without limits, and what to look at."""
    status = python.ik_batch(drawn_poses(module, np.random.default_rng(seed)))[1]
    by_leg = ((status != Status.UNREACHABLE) & (status != Status.INVALID_POSE)).any(axis=2)
    if together := int(by_leg.all(axis=1).sum()):
        return f"and without limits {together} of {DRAWN}: look at the limits"
    least = int(by_leg.sum(axis=0).argmin())
    return (
        f"and without limits none of {DRAWN} (leg {least + 1} {by_leg[:, least].sum()}): look at "
        "the legs' lengths, where they stand and what they carry"
    )


def are_inside(status: Statuses) -> NDArray[np.bool_]:
    """Whether every leg reaches poses within its limits, from the statuses of all rows."""
    return np.asarray((status == Status.OK).any(axis=2).all(axis=1))


class _Checker:
    def __init__(self, module: ParallelModule, python: ModuleType, native: Native | None) -> None:
        self._module = module
        self._python = python
        self._native = native
        self.modes, self.residual = 0, 0.0
        self._least: list[Sequence[float]] = []  # of all poses the singular values of B and A

    def pose(self, T: FloatArray) -> None:
        """Everything about a pose that all legs reach."""
        where = f"{self._module.name}, T = {T[:3].tolist()}"
        q, status = self._python.ik_all(T)
        good = status == self._python.OK
        self.modes += int(good.sum(axis=1).prod())
        miss = max(self._miss(T, q, i) for i in range(len(q)))
        self.residual = max(self.residual, miss)
        if not miss <= CLOSED:
            raise VerificationError(f"{where}: a leg misses the platform by {miss:.1e}")
        mode = np.array([rows[inside][0] for rows, inside in zip(q, good, strict=True)])
        self._languages(T, q, status, mode, where)
        least = self._python.singularities(T, mode)
        self._least.append(np.nan_to_num(least[:2]))
        if min(least.first, least.second) > REGULAR:
            self._slopes(T, mode, where)
            self._direct(T, mode, where)

    def _miss(self, T: FloatArray, q: FloatArray, number: int) -> float:
        """By how much a leg's rows miss what the platform carries there."""
        leg = self._module.legs[number]
        dof = leg.solver.chain.dof
        rows = q[number][~np.isnan(q[number][:, :dof]).any(axis=1), :dof]
        if not len(rows):
            return 0.0
        off = square(leg.leg.base) @ forward(leg.leg.chain, rows) - T @ square(leg.leg.end)
        lengths = np.abs(off[:, [row for row in self._module.freedoms if row < 3], 3])
        turned = np.abs(off[:, :3, :3]).max() if leg.leg.carries_frame else 0.0
        return float(max(lengths.max() / self._module.size, turned))

    def _languages(
        self, T: FloatArray, q: FloatArray, status: Statuses, mode: FloatArray, where: str
    ) -> None:
        """C and Python give equal results."""
        found = self._python.ik(T, mode)
        if not self._near(found, mode):
            raise VerificationError(f"{where}: the solution nearest to one is not that one")
        if self._native is None:
            return
        count, rows, codes = self._native.ik(T)
        good = (codes == self._python.OK) | (codes == self._python.FREE_JOINT)
        if not (codes == status).all() or count != good.sum(axis=1).prod():
            raise VerificationError(f"{where}: C has other statuses: {codes.tolist()}")
        if not self._near(rows, q):
            raise VerificationError(f"{where}: C has other rows: {rows.tolist()}")
        self._drives(T[None], rows[None], codes[None], where)
        nearest_code, nearest = self._native.nearest(T, mode)
        if nearest_code != self._python.OK or not self._near(nearest, mode):
            raise VerificationError(f"{where}: C has another nearest solution")

    def _drives(self, T: FloatArray, q: FloatArray, status: Statuses, where: str) -> None:
        """The driven joints alone are those of the full solutions, for one pose, too."""
        assert self._native is not None
        wanted = driven_of_rows(self._module.driven_joints, q)
        taken = [self._native.ik_drives(pose) for pose in T]
        alone = (
            np.array([rows for _, rows, _ in taken]),
            np.array([statuses for _, _, statuses in taken]),
        )
        for found, statuses in (self._native.drives_batch(T), alone):
            off = np.where(np.isnan(found) & np.isnan(wanted), 0.0, np.sin(0.5 * (found - wanted)))
            if not (statuses == status).all() or not (np.abs(off) <= AGREED).all():
                raise VerificationError(f"{where}: in C, ik_drives differs: {found.tolist()}")
        good = (status == self._python.OK) | (status == self._python.FREE_JOINT)
        counts = np.array([count for count, _, _ in taken])
        if not (counts == good.sum(axis=2).prod(axis=1)).all():
            raise VerificationError(f"{where}: in C, ik_drives counts {counts.tolist()} modes")

    def _near(self, one: FloatArray, other: FloatArray) -> bool:
        """Whether joint values are equal, whole turns aside."""
        off = np.where(np.isnan(one) & np.isnan(other), 0.0, one - other)
        off = off.reshape(len(self._module.legs), -1, self._module.joints)
        for leg, rows in zip(self._module.legs, off, strict=True):
            for joint, turns in enumerate(leg.solver.chain.turning):
                values = rows[:, joint]
                if turns:
                    rows[:, joint] = values - 2.0 * np.pi * np.round(values / (2.0 * np.pi))
        return bool((np.abs(off) <= AGREED * max(1.0, self._module.size)).all())

    def _slopes(self, T: FloatArray, mode: FloatArray, where: str) -> None:
        """A and B agree with differences of the inverse model."""
        A, B = self._python.velocities(T, mode)
        units = [self._module.size if each < 3 else 1.0 for each in self._module.freedoms]
        wanted = np.linalg.solve(B, A)
        found = np.empty_like(wanted)
        for column, (freedom, unit) in enumerate(zip(self._module.freedoms, units, strict=True)):
            # of two steps, so that what bends the drives near a singularity cancels (Richardson)
            wide, narrow = (self._slope(T, mode, freedom, step * unit) for step in (STEP, STEP / 2))
            found[:, column] = (4.0 * narrow - wide) / 3.0
        if not np.abs(found - wanted).max() <= SLOPE * (1.0 + np.abs(wanted).max()) / REGULAR:
            raise VerificationError(f"{where}: A and B are {wanted}, differences {found}")
        if self._native is not None:
            far = AGREED / REGULAR * (1.0 + max(np.abs(A).max(), np.abs(B).max()))
            pairs = zip(self._native.velocities(T, mode), (A, B), strict=True)
            if not all(np.abs(one - other).max() <= far for one, other in pairs):
                raise VerificationError(f"{where}: C has other velocities")

    def _slope(self, T: FloatArray, mode: FloatArray, freedom: int, step: float) -> FloatArray:
        """How the drives follow a freedom of the platform, by steps to both sides."""
        behind, ahead = (
            self._python.drives(self._python.ik(moved_pose(T, freedom, each), mode, limits=False))
            for each in (-step, step)
        )
        return np.asarray((ahead - behind) / (2.0 * step))

    def _direct(self, T: FloatArray, mode: FloatArray, where: str) -> None:
        """The direct model returns to the pose, which is among all assemblies.

        It starts beside the pose, to the side that all legs reach: one may be nearly stretched.
        """
        drives, step = self._python.drives(mode), BESIDE * self._module.size
        sides = (moved_pose(T, self._module.freedoms[0], each) for each in (step, -step))
        seed = next((side for side in sides if self._is_reached(side)), None)
        if seed is None:
            return
        code, found, q = (self._python.fk(drives, seed)[i] for i in (2, 0, 1))
        if code != self._python.OK or not self._same_pose(found, T) or not self._near(q, mode):
            raise VerificationError(f"{where}: the direct model leads to {found.tolist()}")
        if self._native is not None:
            code, found, q = self._native.fk(drives, seed)
            if code != self._python.OK or not self._same_pose(found, T) or not self._near(q, mode):
                raise VerificationError(f"{where}: in C the direct model leads elsewhere")
        if self._module.elimination is not None:
            self._assemblies(T, drives, where)

    def _is_reached(self, T: FloatArray) -> bool:
        """Whether all legs reach a pose, within limits or not."""
        q, _ = self._python.ik_all(T)
        return bool((~np.isnan(q[..., 0])).any(axis=1).all())

    def _assemblies(self, T: FloatArray, drives: FloatArray, where: str) -> None:
        poses = self._python.assemblies(drives)
        if not any(self._same_pose(T, pose) for pose in poses):
            raise VerificationError(f"{where}: is not among its {len(poses)} assemblies")
        if self._native is not None:
            others = self._native.assemblies(drives)
            if len(others) != len(poses) or not all(map(self._same_pose, poses, others)):
                raise VerificationError(f"{where}: C has other assemblies: {len(others)} poses")

    def _same_pose(self, one: FloatArray, other: FloatArray) -> bool:
        units = np.array([1.0, 1.0, 1.0, self._module.size])
        return bool((np.abs((one - other)[:3] / units) <= AGREED / REGULAR).all())

    def drives_hold(self) -> None:
        """At some pose the drives move the platform in all ways, and hold it."""
        first, second = np.max(self._least, axis=0)
        every = f"at all {len(self._least)} poses"
        if first <= SINGULAR_PLATFORM:
            raise ImmobileError(
                f"{every} a drive does not move what its leg carries: do the legs drive the right "
                "joints?"
            )
        if second <= SINGULAR_PLATFORM:
            raise ImmobileError(
                f"{every} the platform can move while its drives are held: where the legs stand, "
                "and what they carry, leaves it a motion that the count of freedoms does not see"
            )

    def batch(self, poses: FloatArray) -> None:
        """Batches give the results of single poses."""
        q, status = self._python.ik_batch(poses)
        seed = np.zeros((len(self._module.legs), self._module.joints))
        alone = [self._python.ik_all(T, seed) for T in poses]
        if not all(self._near(rows, one) for rows, (one, _) in zip(q, alone, strict=True)):
            raise VerificationError(f"{self._module.name}: ik_batch differs from ik_all")
        if self._native is not None:
            rows, statuses = self._native.batch(poses)
            near = all(self._near(one, other) for one, other in zip(rows, q, strict=True))
            if not near or not (statuses == status).all():
                raise VerificationError(f"{self._module.name}: in C, ik_batch differs")
            self._drives(poses, rows, statuses, self._module.name)

    def no_pose(self, T: FloatArray) -> None:
        """What is no pose is refused, what is far away out of reach."""
        spoiled, far = T.copy(), T.copy()
        spoiled[0, 3], far[0, 3] = np.nan, far[0, 3] + 100.0 * self._module.size
        wanted = (
            (spoiled, {self._python.INVALID_POSE}),
            (far, {self._python.UNREACHABLE, self._python.OUT_OF_LIMITS}),
        )
        for pose, statuses in wanted:
            found = [self._python.ik_all(pose)[1]]
            if self._native is not None:
                found += [self._native.ik(pose)[2], self._native.ik_drives(pose)[2]]
            for each in found:
                if not set(each.ravel().tolist()) <= statuses:
                    raise VerificationError(f"{self._module.name}: takes {pose.tolist()}")


def moved_pose(T: FloatArray, freedom: int, step: float) -> FloatArray:
    """A pose moved along an axis of the base, or turned about one through its origin."""
    moved = T.copy()
    if freedom < 3:
        moved[freedom, 3] += step
        return moved
    moved[:3, :3] = turn_about(freedom - 3, step) @ T[:3, :3]
    return moved

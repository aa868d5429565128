"""Proves that written files do what they promise, or refuses them.

Python and C are run on the same poses: they agree with each other and with the program's meaning;
every row they give reproduces its pose through an independent forward model; the joint values that
made a pose are among the rows, and the nearest to themselves; poses that cannot be are refused.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.errors import VerificationError
from dhgen.method import Method
from dhgen.program.given import given_values
from dhgen.program.interpret import interpret
from dhgen.program.tolerances import TOLERANCES
from dhgen.robot.task import TaskKind
from dhgen.targets.walk import whole_arm
from dhgen.verify.measures import Measures
from dhgen.verify.native import NATIVE, PORTABLE, compile_solver, import_module
from dhgen.verify.samples import samples, spoiled_poses

if TYPE_CHECKING:
    from pathlib import Path
    from types import ModuleType

    from numpy.typing import NDArray

    from dhgen.targets.module import SolverModule
    from dhgen.verify.native import CompiledSolver
    from dhgen.verify.samples import Sample

    Array = NDArray[np.float64]

COUNT = 150  # poses of each sort
RESIDUAL = TOLERANCES.promised  # of the arm's size: what a row may miss its pose by
GENERAL_RESIDUAL = 1e-9  # the same where roots of a polynomial are polished
AGREEMENT = 1e-12  # between targets, where the branch is well conditioned
FOUND = 1e-6  # [rad or arm sizes] the generating joint values on random poses
FOUND_SINGULAR = 1e-3  # the same where a pose hardly fixes them
FIXED = 1e-12  # least singular value: with a smaller one rounding moves joint values that far
JACOBIAN = 1e-6  # against central differences


@dataclass(frozen=True, slots=True)
class Report:
    """What verification saw.

    Attributes:
        poses: How many poses were solved.
        solutions: How many rows held joint values.
        residual: The largest miss of a row, in arm sizes.
        compiled: Whether a C compiler was there.
        single: The largest miss of a row in single precision; None if it was not asked for.
    """

    poses: int
    solutions: int
    residual: float
    compiled: bool
    single: float | None = None


def verify(module: SolverModule, folder: Path) -> Report:
    """Checks the files of a robot as they lie in a folder.

    Raises:
        VerificationError: Something is not as promised; the text says what, and on which joints.
    """
    python = import_module(folder / f"{module.name}.py")
    source = folder / f"{module.name}.c"
    shape = module.chain.dof, module.solver.rows, module.chain.given
    made = (compile_solver(source, folder, module.name, *shape, b) for b in (PORTABLE, NATIVE))
    builds = tuple(solver for solver in made if solver is not None)
    checker = _Checker(module, python, builds)
    for sample in samples(module.chain, COUNT):
        checker.sample(sample)
    checker.impossible()
    return Report(checker.poses, checker.solutions, checker.residual, bool(builds))


class _Checker:
    def __init__(
        self, module: SolverModule, python: ModuleType, builds: tuple[CompiledSolver, ...]
    ) -> None:
        self._module = module
        self._python: Any = python
        self._builds = builds
        self._chain = module.chain
        self._measures = Measures(module.chain)
        self._has_branches = whole_arm(module.solver) is None
        # which starts lead where hangs on rounding
        self._repeatable = module.method is not Method.NUMERICAL
        none = (-np.inf, np.inf)
        self._limits = np.array([joint.limits or none for joint in self._chain.joints]).T
        self.poses = self.solutions = 0
        self.residual = 0.0

    def sample(self, sample: Sample) -> None:
        """Every pose of a sample, with the generating joints as the seed."""
        poses = self._measures.arm.pose(sample.q)
        random = sample.name == "random"
        meant = None
        if random and self._repeatable:
            meant = interpret(self._module.solver, poses, sample.q, self._values(sample.q))
        jacobians = self._measures.jacobians(sample.q, poses)
        for number, (q, T) in enumerate(zip(sample.q, poses, strict=True)):
            where = f"{self._module.name}, {sample.name}, q = {q.tolist()}"
            self._forward(q, T, jacobians[number], where)
            compared = meant is not None or self._has_branches
            rows, status = self._call(T, q, where, compared=compared, singular=not random)
            solved = np.isin(status, (self._python.OK, self._python.FREE_JOINT))
            held = solved | (status == self._python.OUT_OF_LIMITS)
            self._reproduce(rows[held], T, where)
            # where an arm is singular, rounding may move a solution a little beyond a limit
            if not (solved if random else held).any():
                raise VerificationError(f"{where}: no row holds a solution")
            if (
                self._has_branches
                and (not sample.near or self._measures.fixed(q) > FIXED)
                and not self._may_be_moved(q, status)
            ):
                certain = rows[status != self._python.FREE_JOINT]
                if random or not self._is_as_good(certain, q, T):
                    self._recover(rows[held], q, FOUND if random else FOUND_SINGULAR, where)
            if random:
                self._recover(rows[solved], q, FOUND, where)
                self._nearest(q, T, where)
                self._arm_angles(rows[held], q, where)
                if self._has_branches:
                    self._whole(T, q, rows, status, where)
            if not random and not sample.near and self._repeatable:
                self._unseeded(T, q, where)
            if meant is not None:
                self._agree(rows[held], meant.q[number][held], T, "the interpreted program", where)
            self.poses += 1
            self.solutions += int(solved.sum())
        self._batch(sample, poses)

    def _unseeded(self, T: Array, q: Array, where: str) -> None:
        """The arm takes the pose without a seed, too."""
        given, zeros = self._given(q), np.zeros(self._chain.dof)
        found = [("Python", *self._python.ik_all(T, *given))]
        found += [("C", *build.ik(T, zeros, *given)) for build in self._builds]
        for language, rows, _ in found:
            held = np.isfinite(rows).all(axis=1)
            self._reproduce(rows[held], T, f"{where}, without a seed")
            if not held.any():
                raise VerificationError(f"{where}: without a seed {language} finds no solution")

    def _may_be_moved(self, q: Array, status: NDArray[np.uint8]) -> bool:
        """Whether a free joint may have been taken from q so that limits are kept.

        If that did not do, its row is out of limits.
        """
        low, high = self._limits
        keeps = (q >= low - TOLERANCES.limit) & (q <= high + TOLERANCES.limit)
        free = np.isin(status, (self._python.FREE_JOINT, self._python.OUT_OF_LIMITS))
        return bool(free.any()) and not keeps.all()

    def _batch(self, sample: Sample, poses: Array) -> None:
        """Batches hold the rows of single poses."""
        given = self._given(sample.q)
        zeros = np.zeros(self._chain.dof)
        languages = [("Python", self._python.ik_batch, self._python.ik_all)]
        languages += [
            ("C", build.batch, lambda T, *free, build=build: build.ik(T, zeros, *free))
            for build in self._builds
        ]
        for language, batch, alone in languages:
            many, statuses = batch(poses, *given)
            for number, (T, rows, status) in enumerate(zip(poses, many, statuses, strict=True)):
                where = f"{self._module.name}, {sample.name}, pose {number} of a batch"
                one, one_status = alone(T, *(g[number] for g in given))
                self._reproduce(rows[np.isfinite(rows).all(axis=1)], T, where)
                if sample.name == "random" and self._has_branches:
                    if not np.array_equal(status, one_status):
                        told = f"{language} gives {status}, for the pose alone {one_status}"
                        raise VerificationError(f"{where}: {told}")
                    held = np.isfinite(one).all(axis=1)
                    self._agree(rows[held], one[held], T, language, where)

    def _whole(
        self, T: Array, q: Array, rows: Array, status: NDArray[np.uint8], where: str
    ) -> None:
        """What serves singular poses in Python gives the same at ordinary ones."""
        given = self._given(q)
        _, pose = self._python._read(T, *given)  # noqa: SLF001
        others, kinds = np.empty_like(rows), np.empty_like(status)
        self._python._whole(pose, *given, q, others, kinds)  # noqa: SLF001
        if not np.array_equal(status, kinds):
            raise VerificationError(f"{where}: Python gives {status}, its careful solver {kinds}")
        held = np.isfinite(rows).all(axis=1)
        self._agree(rows[held], others[held], T, "its careful solver", where)

    def impossible(self) -> None:
        """Poses that are none, and poses out of reach."""
        name = self._module.name
        source = np.random.default_rng(11)
        q = samples(self._chain, 8)[0].q
        slides = "P" in self._python.JOINT_TYPES
        endless = slides or self._chain.task.kind is TaskKind.ORIENTATION
        for joints, T in zip(q, self._measures.arm.pose(q), strict=True):
            for spoiled in spoiled_poses(self._chain.task, T):
                _, status = self._call(spoiled, joints, "an impossible pose")
                if not (status == self._python.INVALID_POSE).all():
                    raise VerificationError(f"{name}: accepted an invalid pose:\n{spoiled}")
            far = T.copy()
            far[:3, 3] += 10.0 * self._chain.size * source.choice([-1.0, 1.0], 3)
            if not endless:
                _, status = self._call(far, joints, "a pose out of reach")
                if not (status == self._python.UNREACHABLE).all():
                    raise VerificationError(f"{name}: claims to reach a pose out of reach:\n{far}")

    def _forward(self, q: Array, T: Array, J: Array, where: str) -> None:
        compiled = [("C", build) for build in self._builds]
        for language, solver in [("Python", self._python), *compiled]:
            miss = self._measures.pose_miss(solver.fk(q), T)
            self._demand(miss, AGREEMENT, f"{where}: {language}'s fk is off")
            miss = self._measures.jacobian_miss(solver.jacobian(q), J)
            self._demand(miss, JACOBIAN, f"{where}: {language}'s Jacobian is off")

    def _call(
        self, T: Array, seed: Array, where: str, *, compared: bool = True, singular: bool = False
    ) -> tuple[Array, NDArray[np.uint8]]:
        """Python's rows; C's are the same, or at least solutions where roots have no branches."""
        given = self._given(seed)
        rows, status = self._python.ik_all(T, *given, seed)
        for place, build in enumerate(self._builds):
            other, other_status = build.ik(T, seed, *given)
            # where an arm is singular, an instruction that rounds once moves double roots
            if not compared or (singular and place > 0):
                self._reproduce(other[np.isfinite(other).all(axis=1)], T, where)
                continue
            if not np.array_equal(status, other_status):
                raise VerificationError(f"{where}: Python gives {status}, C gives {other_status}")
            held = np.isfinite(rows).all(axis=1)
            self._agree(rows[held], other[held], T, "C", where)
        return rows, status

    def _agree(self, rows: Array, others: Array, T: Array, what: str, where: str) -> None:
        """Joint values agree up to rounding, as far as the pose fixes what meets it so well."""
        if not len(rows):
            return
        miss, enough = float(self._measures.joint_miss(rows, others).max()), AGREEMENT
        if not miss <= enough:
            enough = max(enough, *(self._measures.residual(each, T) for each in (rows, others)))
            enough /= min(max(self._measures.fixed(rows), 1e-9), 1.0)
        self._demand(miss, enough, f"{where}: Python and {what} differ")

    def _reproduce(self, rows: Array, T: Array, where: str) -> None:
        if len(rows):
            miss = self._measures.residual(rows, T)
            self.residual = max(self.residual, miss)
            enough = RESIDUAL if self._has_branches else GENERAL_RESIDUAL
            self._demand(miss, enough, f"{where}: a row misses the pose, in arm sizes")

    def _recover(self, rows: Array, q: Array, enough: float, where: str) -> None:
        """The generating joint values are among the rows: free joints took them from the seed."""
        miss = float(self._measures.joint_miss(rows, q).max(axis=1).min())
        self._demand(miss, enough, f"{where}: q is not among the solutions, the nearest is off")

    def _is_as_good(self, rows: Array, q: Array, T: Array) -> bool:
        """Whether the pose hardly tells joint values from those of a row with no free joint.

        Of an arm that is singular there rounding moves them: where two solutions meet beside a
        place where a joint is free, as far as all joint values in between reach the pose. Where
        the arm is at the edge of its reach, too, those are not on the straight way.
        """
        if self._measures.fixed(q) > FIXED:
            return False
        held = rows[np.isfinite(rows).all(axis=1)]
        ways = (way for row in held for way in self._measures.ways(row, q))
        return any(self._measures.residual(way, T) <= GENERAL_RESIDUAL for way in ways)

    def _nearest(self, q: Array, T: Array, where: str) -> None:
        """The generating joint values are the nearest to themselves."""
        given = self._given(q)
        nearest = [("Python's ik", self._python.ik(T, *given, q))]
        nearest += [("C's ik_nearest", build.nearest(T, q, *given)) for build in self._builds]
        for what, found in nearest:
            miss = float(np.abs(found - q).max()) / max(1.0, self._chain.size)
            self._demand(miss, FOUND, f"{where}: {what} is off")

    def _arm_angles(self, rows: Array, q: Array, where: str) -> None:
        """Every row has the arm angle of the generating joint values, and the files say so."""
        if not self._chain.arm_angle:
            return
        asked = self._values(q)
        told = [self._python.arm_angle(q), *(build.arm_angle(q) for build in self._builds)]
        for angles in (self._values(rows), np.array(told)[:, None]):
            miss = float(np.abs(np.remainder(angles - asked + np.pi, 2.0 * np.pi) - np.pi).max())
            self._demand(miss, FOUND, f"{where}: an arm angle is off")

    def _values(self, q: Array) -> Array:
        """The values of free joints, or the arm angle, (..., k)."""
        return given_values(self._measures.arm, q)

    def _given(self, q: Array) -> list[Array]:
        """The argument for them, where there are any."""
        return [self._values(q)] if self._chain.given else []

    def _demand(self, miss: float, enough: float, what: str) -> None:
        if not miss <= enough:
            raise VerificationError(f"{what} by {miss:.1e}")

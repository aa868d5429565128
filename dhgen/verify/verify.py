"""Proves that written files do what they promise, or refuses them.

Python and C are run on the same poses: they agree with each other and with the program's meaning;
every row they give reproduces its pose through an independent forward model; the joint values that
made a pose are among the rows; poses that cannot be are refused.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.errors import VerificationError
from dhgen.kinematics.numeric import NumericArm, numeric_arm
from dhgen.paul.problem import task_entries
from dhgen.program.interpret import interpret
from dhgen.robot.robot import JointKind, TaskKind
from dhgen.targets.walk import general_kernel
from dhgen.verify.native import compile_solver, import_module
from dhgen.verify.samples import samples

if TYPE_CHECKING:
    from pathlib import Path
    from types import ModuleType

    from numpy.typing import NDArray

    from dhgen.targets.module import SolverModule
    from dhgen.verify.native import CompiledSolver
    from dhgen.verify.samples import Sample

    Array = NDArray[np.float64]

COUNT = 150  # poses of each sort
RESIDUAL = 1e-11  # of the arm's size: what a row may miss its pose by
GENERAL_RESIDUAL = 1e-9  # the same where roots of a polynomial are polished
AGREEMENT = 1e-12  # between targets, where the branch is well conditioned
FOUND = 1e-6  # [rad or arm sizes] the generating joint values on random poses
JACOBIAN = 1e-6  # against central differences


@dataclass(frozen=True, slots=True)
class Report:
    """What verification saw.

    Attributes:
        poses: How many poses were solved.
        solutions: How many rows held joint values.
        residual: The largest miss of a row, in arm sizes.
        compiled: Whether a C compiler was there.
    """

    poses: int
    solutions: int
    residual: float
    compiled: bool


def verify(module: SolverModule, folder: Path) -> Report:
    """Checks the files of a robot as they lie in a folder.

    Raises:
        VerificationError: Something is not as promised; the text says what, and on which joints.
    """
    python = import_module(folder / f"{module.name}.py")
    c = compile_solver(
        folder / f"{module.name}.c",
        folder,
        module.name,
        module.chain.dof,
        module.solver.rows,
        len(module.chain.free),
    )
    checker = _Checker(module, python, c)
    for sample in samples(module.chain, COUNT):
        checker.sample(sample)
    checker.impossible()
    return Report(checker.poses, checker.solutions, checker.residual, c is not None)


class _Checker:
    def __init__(self, module: SolverModule, python: ModuleType, c: CompiledSolver | None) -> None:
        self._module = module
        self._python: Any = python
        self._c = c
        self._chain = module.chain
        self._arm: NumericArm = numeric_arm(module.chain)
        self._turns = np.array([j.kind is JointKind.REVOLUTE for j in self._chain.joints])
        self._free = [joint - 1 for joint in self._chain.free]
        self._has_branches = general_kernel(module.solver) is None
        self.poses = self.solutions = 0
        self.residual = 0.0

    def sample(self, sample: Sample) -> None:
        """Every pose of a sample, with the generating joints as the seed."""
        poses = self._arm.pose(sample.q)
        random = sample.name == "random"
        compared = random or self._has_branches
        if random:
            meant = interpret(self._module.solver, poses, sample.q, sample.q[:, self._free])
        for number, (q, T) in enumerate(zip(sample.q, poses, strict=True)):
            where = f"{self._module.name}, {sample.name}, q = {q.tolist()}"
            self._forward(q, T, where)
            rows, status = self._call(T, q, where, compared=compared)
            solved = np.isin(status, (self._python.OK, self._python.FREE_JOINT))
            held = solved | (status == self._python.OUT_OF_LIMITS)
            self._reproduce(rows[held], T, where)
            # where an arm is singular, rounding may move a solution a little beyond a limit
            enough = solved if random else held
            if not enough.any():
                raise VerificationError(f"{where}: no row holds a solution")
            if random:
                self._recover(rows[solved], q, where)
                self._agree(rows[held], meant.q[number][held], "the program's meaning", where)
            self.poses += 1
            self.solutions += int(solved.sum())

    def impossible(self) -> None:
        """Poses out of reach, mirrored, and not finite."""
        source = np.random.default_rng(11)
        q = samples(self._chain, 8)[0].q
        for joints, T in zip(q, self._arm.pose(q), strict=True):
            for spoiled in self._spoiled(T):
                _, status = self._call(spoiled, joints, "an impossible pose")
                if not (status == self._python.INVALID_POSE).all():
                    raise VerificationError(
                        f"{self._module.name}: took a pose that is none:\n{spoiled}"
                    )
            if "P" in self._python.JOINT_TYPES or self._chain.task.kind is TaskKind.ORIENTATION:
                continue
            far = T.copy()
            far[:3, 3] += 10.0 * self._chain.size * source.choice([-1.0, 1.0], 3)
            _, status = self._call(far, joints, "a pose out of reach")
            if not (status == self._python.UNREACHABLE).all():
                raise VerificationError(f"{self._module.name}: reached a pose out of reach:\n{far}")

    def _spoiled(self, T: Array) -> list[Array]:
        kind = self._chain.task.kind
        row, column = (0, 0) if kind is TaskKind.ORIENTATION else (self._named_row(), 3)
        spoiled = []
        for value in (np.nan, np.inf):
            bad = T.copy()
            bad[row, column] = value
            spoiled.append(bad)
        if kind in {TaskKind.POSE, TaskKind.ORIENTATION}:
            mirrored = T.copy()
            mirrored[:3, 0] *= -1.0
            sheared = T.copy()
            sheared[:3, :3] *= 1.01
            spoiled += [mirrored, sheared]
        return spoiled

    def _named_row(self) -> int:
        coordinates = self._chain.task.coordinates
        return "xyz".index(coordinates[0]) if coordinates else 0

    def _forward(self, q: Array, T: Array, where: str) -> None:
        self._agree_pose(self._python.fk(q), T, "Python's fk", where)
        jacobian = self._differences(q, T)
        self._near(self._python.jacobian(q), jacobian, JACOBIAN, "Python's Jacobian", where)
        if self._c is not None:
            self._agree_pose(self._c.fk(q), T, "C's fk", where)
            self._near(self._c.jacobian(q), jacobian, JACOBIAN, "C's Jacobian", where)

    def _agree_pose(self, got: Array, wanted: Array, what: str, where: str) -> None:
        scale = np.ones((4, 4))
        scale[:3, 3] = max(self._chain.size, float(np.abs(wanted[:3, 3]).max()))
        self._near(got / scale, wanted / scale, AGREEMENT, what, where)

    def _differences(self, q: Array, T: Array) -> Array:
        """The Jacobian by central differences of the independent forward model."""
        step = 1e-5
        columns = []
        for joint in range(self._chain.dof):
            move = np.zeros(self._chain.dof)
            move[joint] = step
            rate = (self._arm.pose(q + move) - self._arm.pose(q - move)) / (2.0 * step)
            spin = rate[:3, :3] @ T[:3, :3].T
            columns.append([*rate[:3, 3] / self._scale, spin[2, 1], spin[0, 2], spin[1, 0]])
        jacobian = np.array(columns).T
        jacobian[:3] *= self._scale
        return jacobian

    @property
    def _scale(self) -> float:
        return self._chain.size

    def _call(
        self, T: Array, seed: Array, where: str, *, compared: bool = True
    ) -> tuple[Array, NDArray[np.uint8]]:
        """Python's rows; C's are the same, or at least solutions where roots have no branches."""
        given = [seed[self._free]] if self._free else []
        rows, status = self._python.ik_all(T, *given, seed)
        if self._c is not None:
            other, other_status = self._c.ik(T, seed, *given)
            if not compared:
                self._reproduce(other[np.isfinite(other).all(axis=1)], T, where)
                return rows, status
            if not np.array_equal(status, other_status):
                raise VerificationError(f"{where}: Python says {status}, C says {other_status}")
            held = np.isfinite(rows).all(axis=1)
            self._agree(rows[held], other[held], "C", where)
        return rows, status

    def _agree(self, rows: Array, others: Array, what: str, where: str) -> None:
        """Joint values agree up to rounding, more where the pose hardly fixes them."""
        miss = self._difference(rows, others)
        if miss.size and float(miss.max()) > self._conditioned(rows):
            raise VerificationError(f"{where}: Python and {what} differ by {miss.max():.1e}")

    def _conditioned(self, rows: Array) -> float:
        """AGREEMENT over the smallest singular value of the Jacobian."""
        least = 1.0
        for row in rows:
            jacobian = np.array(self._python.jacobian(row))
            jacobian[:3] /= self._scale
            values = np.linalg.svd(jacobian, compute_uv=False)
            least = min(least, float(values[min(len(values), self._chain.dof) - 1]))
        return AGREEMENT / max(least, 1e-9)

    def _difference(self, rows: Array, others: Array) -> Array:
        miss = np.abs(rows - others)
        turned = np.abs(miss - 2.0 * np.pi * np.round(miss / (2.0 * np.pi)))
        return np.where(self._turns, turned, miss / self._scale)

    def _reproduce(self, rows: Array, T: Array, where: str) -> None:
        if not len(rows):
            return
        reached = self._arm.pose(rows)
        for name in task_entries(self._chain.task):
            i, j = int(name[1]) - 1, int(name[2]) - 1
            scale = max(self._scale, float(np.abs(T[:3, 3]).max())) if j == 3 else 1.0
            miss = float(np.abs(reached[:, i, j] - T[i, j]).max()) / scale
            self.residual = max(self.residual, miss)
            if not miss <= (RESIDUAL if self._has_branches else GENERAL_RESIDUAL):
                raise VerificationError(f"{where}: a row misses T[{i},{j}] by {miss:.1e} arm sizes")

    def _recover(self, rows: Array, q: Array, where: str) -> None:
        miss = self._difference(rows, q).max(axis=1)
        if not miss.min() <= FOUND:
            raise VerificationError(f"{where}: not among the solutions (nearest {miss.min():.1e})")

    def _near(self, got: Array, wanted: Array, tolerance: float, what: str, where: str) -> None:
        miss = float(np.abs(got - wanted).max())
        if not miss <= tolerance * max(1.0, float(np.abs(wanted).max())):
            raise VerificationError(f"{where}: {what} is off by {miss:.1e}")

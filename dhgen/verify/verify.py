"""Proves that written files do what they promise, or refuses them.

Python and C are run on the same poses: they agree with each other and with the program's meaning;
every row they give reproduces its pose through an independent forward model; the joint values that
made a pose are among the rows, and the nearest to themselves; poses that cannot be are refused.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from dhgen.errors import VerificationError
from dhgen.method import Method
from dhgen.paul.refusal.redundancy import near_redundancy
from dhgen.program.all_joints import whole_solver
from dhgen.program.interpret import interpret
from dhgen.program.walk import whole_arm
from dhgen.tolerances import TOLERANCES
from dhgen.verify.compiled import compiled_code, import_temporary, runtime_code, together
from dhgen.verify.demands import FIXED, FOUND, FOUND_SINGULAR, Demands
from dhgen.verify.languages import Languages
from dhgen.verify.native import NATIVE, PORTABLE, compile_solver
from dhgen.verify.samples import samples, spoiled_poses

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path
    from types import ModuleType

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.targets.module import SolverModule
    from dhgen.verify.samples import Sample


COUNT = 150  # poses of each sort


@dataclass(frozen=True, slots=True)
class Report:
    """What verification saw.

    Attributes:
        poses: How many poses were solved.
        solutions: How many rows held joint values.
        residual: The largest miss of a row, in arm sizes.
        compiled: Whether a C compiler was there.
        single: The largest miss of a row in single precision; None if it was not asked for.
        code: What numba compiled of each module, by the names that its files have.
    """

    poses: int
    solutions: int
    residual: float
    compiled: bool
    single: float | None = None
    code: Mapping[str, Mapping[str, bytes]] = field(default_factory=dict, repr=False)


def verify(module: SolverModule, folder: Path) -> Report:
    """Checks the files of a robot as they lie in a folder.

    Raises:
        VerificationError: Something is not as promised; the text names it, and the joints.
    """
    try:
        return _verify(module, folder)
    except VerificationError as error:
        raise VerificationError("\n".join([str(error), *near_redundancy(module.chain)])) from error


def _verify(module: SolverModule, folder: Path) -> Report:
    python = imported(module, folder)
    source = folder / f"{module.name}.c"
    shape = module.chain.dof, module.solver.rows, module.chain.given
    made = (compile_solver(source, folder, module.name, *shape, b) for b in (PORTABLE, NATIVE))
    builds = tuple(solver for solver in made if solver is not None)
    demands = Demands(module)
    checker = _Checker(module, Languages(module, python, builds, demands), demands)
    for sample in samples(module.chain, COUNT):
        checker.sample(sample)
    checker.impossible()
    python.warm_up()  # what no sample pose needed is compiled, too, and kept for who imports it
    seen = checker.poses, checker.solutions, demands.residual, bool(builds)
    code = compiled_code(python)
    whole = whole_arm(module.solver)
    own = code if whole is None else together(runtime_code(), code)
    return Report(*seen, code={module.name: own})


def imported(module: SolverModule, folder: Path) -> ModuleType:
    """The Python module of a robot from a temporary folder.

    What solves for all joints is the compiler's own, imported before the robot's copy of the text:
    its compiled code is kept.
    """
    if (whole := whole_arm(module.solver)) is not None:
        whole_solver(whole)
    return import_temporary(folder / f"{module.name}.py")


class _Checker:
    def __init__(self, module: SolverModule, languages: Languages, demands: Demands) -> None:
        self._module = module
        self._languages = languages
        self._demands = demands
        self._python = languages.python
        self._chain = module.chain
        # which solution a start reaches depends on rounding
        self._repeatable = module.method is not Method.NUMERICAL
        none = (-np.inf, np.inf)
        self._limits = np.array([joint.limits or none for joint in self._chain.joints]).T
        self.poses = self.solutions = 0

    def sample(self, sample: Sample) -> None:
        """Every pose of a sample, with the generating joints as the seed."""
        poses = self._demands.measures.arm.pose(sample.q)
        random = sample.name == "random"
        meant = None
        if random and self._repeatable:
            meant = interpret(self._module.solver, poses, sample.q, self._demands.values(sample.q))
        self._languages.forward(sample.q, poses, f"{self._module.name}, {sample.name}")
        for number, (q, T) in enumerate(zip(sample.q, poses, strict=True)):
            where = f"{self._module.name}, {sample.name}, q = {q.tolist()}"
            compared = meant is not None or self._demands.has_branches
            rows, status = self._languages.call(T, q, where, compared=compared, singular=not random)
            solved = np.isin(status, (self._python.OK, self._python.FREE_JOINT))
            held = solved | (status == self._python.OUT_OF_LIMITS)
            self._demands.reproduce(rows[held], T, where)
            # where an arm is singular, rounding may move a solution a little beyond a limit
            if not (solved if random else held).any():
                raise VerificationError(f"{where}: no row holds a solution")
            if (
                self._demands.has_branches
                and (not sample.near or self._demands.measures.fixed(q) > FIXED)
                and not self._may_be_moved(q, status)
            ):
                certain = rows[status != self._python.FREE_JOINT]
                enough = FOUND if random else FOUND_SINGULAR
                if random or not (
                    self._demands.has(rows[held], q, enough)
                    or self._demands.is_as_good(certain, q, T)
                ):
                    self._demands.recover(rows[held], q, enough, where)
            if random:
                self._demands.recover(rows[solved], q, FOUND, where)
                self._languages.nearest(q, T, where)
                self._languages.arm_angles(rows[held], q, where)
                if self._demands.has_branches:
                    self._languages.whole(T, q, rows, status, where)
            if not random and not sample.near and self._repeatable:
                self._languages.unseeded(T, q, where)
            if meant is not None:
                expected = self._expected(meant.q[number], rows, held, where)
                self._demands.agree(rows[held], expected, T, "the interpreted program", where)
            self.poses += 1
            self.solutions += int(solved.sum())
        self._languages.batch(sample, poses)

    def _expected(
        self, meant: FloatArray, rows: FloatArray, held: NDArray[np.bool_], where: str
    ) -> FloatArray:
        """The program's rows in the files' order: by posture they are in other places."""
        if self._module.nominal is None:
            return meant[held]
        there = meant[~np.isnan(meant).any(axis=1)]
        if len(there) != held.sum():
            raise VerificationError(f"{where}: {held.sum()} solutions, {len(there)} are meant")
        misses = self._demands.measures.joint_miss
        nearest = [
            int(misses(np.broadcast_to(row, there.shape), there).max(axis=1).argmin())
            for row in rows[held]
        ]
        return there[nearest]

    def _may_be_moved(self, q: FloatArray, status: NDArray[np.uint8]) -> bool:
        """Whether a free joint may have been taken from q so that limits are kept.

        If that did not do, its row is out of limits.
        """
        low, high = self._limits
        keeps = (q >= low - TOLERANCES.limit) & (q <= high + TOLERANCES.limit)
        free = np.isin(status, (self._python.FREE_JOINT, self._python.OUT_OF_LIMITS))
        return bool(free.any()) and not keeps.all()

    def impossible(self) -> None:
        """Poses that are none, and poses out of reach."""
        name = self._module.name
        source = np.random.default_rng(11)
        q = samples(self._chain, 8)[0].q
        slides = "P" in self._python.JOINT_TYPES
        endless = slides or not self._chain.task.position_rows
        poses = self._demands.measures.arm.pose(q)
        none = np.array([spoiled_poses(self._chain.task, T) for T in poses])
        self._languages.refuse(np.repeat(q, none.shape[1], axis=0), none.reshape(-1, 4, 4))
        for joints, T, all_spoiled in zip(q, poses, none, strict=True):
            for spoiled in all_spoiled:
                _, status = self._languages.call(spoiled, joints, "an impossible pose")
                if not (status == self._python.INVALID_POSE).all():
                    raise VerificationError(f"{name}: accepted an invalid pose:\n{spoiled}")
            far = T.copy()
            far[:3, 3] += 10.0 * self._chain.size * source.choice([-1.0, 1.0], 3)
            if not endless:
                _, status = self._languages.call(far, joints, "a pose out of reach")
                if not (status == self._python.UNREACHABLE).all():
                    raise VerificationError(f"{name}: claims to reach a pose out of reach:\n{far}")

"""What a robot's written files give, language against language."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.errors import VerificationError
from dhgen.verify.measures import filled

if TYPE_CHECKING:
    from types import ModuleType

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.targets.module import SolverModule
    from dhgen.verify.demands import Demands
    from dhgen.verify.native import CompiledSolver
    from dhgen.verify.samples import Sample


class Languages:
    """The Python module and the C of some builds.

    Attributes:
        python: The module.

    Args:
        module: The robot.
        python: The module.
        builds: What was compiled.
        demands: On the rows.
    """

    def __init__(
        self,
        module: SolverModule,
        python: ModuleType,
        builds: tuple[CompiledSolver, ...],
        demands: Demands,
    ) -> None:
        self.python: Any = python
        self._module = module
        self._builds = builds
        self._chain = module.chain
        self._demands = demands

    def forward(self, q: FloatArray, T: FloatArray, where: str) -> None:
        """Poses (N, 4, 4), Jacobians and joint velocities of joint values (N, n) are right."""
        J = self._demands.measures.jacobians(q, T)
        compiled = [("C", build) for build in self._builds]
        for language, solver in [("Python", self.python), *compiled]:
            self._demands.forward(solver, q, T, J, f"{where}: {language}'s")

    def call(
        self,
        T: FloatArray,
        seed: FloatArray,
        where: str,
        *,
        compared: bool = True,
        singular: bool = False,
    ) -> tuple[FloatArray, NDArray[np.uint8]]:
        """Python's rows; C's are the same, or at least solutions where roots have no branches."""
        given = self._demands.given(seed)
        rows, status = self.python.ik_all(T, *given, seed)
        for place, build in enumerate(self._builds):
            other, other_status = build.ik(T, seed, *given)
            # where an arm is singular, an instruction that rounds once moves double roots
            if not compared or (singular and place > 0):
                self._demands.reproduce(other[filled(other)], T, where)
                continue
            has, other_has = filled(rows), filled(other)
            differ = status != other_status
            doubted = np.concatenate([rows[differ & has], other[differ & other_has]])
            if (
                singular
                and np.array_equal(status[~has & ~other_has], other_status[~has & ~other_has])
                and self._demands.are_at_an_edge(doubted)
                and self._demands.hold_the_same(rows, other, T, where)
            ):
                continue
            both, alone = has & other_has, has != other_has
            lone = np.concatenate([rows[alone & has], other[alone & other_has]])
            known = np.array_equal(status[~alone], other_status[~alone])
            if not known or not self._may_be_alone(lone, T, where, singular=singular):
                raise VerificationError(f"{where}: Python gives {status}, C gives {other_status}")
            self._demands.agree(rows[both], other[both], T, "C", where)
        return rows, status

    def _may_be_alone(self, rows: FloatArray, T: FloatArray, where: str, *, singular: bool) -> bool:
        """Whether one language may have rows that the other has not.

        Where an arm is singular rounding decides whether it just reaches: with equal links, its
        wrist straight and its hand folded back, twice over.
        """
        self._demands.reproduce(rows, T, where)
        return not len(rows) or (singular and self._demands.are_at_an_edge(rows))

    def unseeded(self, T: FloatArray, q: FloatArray, where: str) -> None:
        """The arm takes the pose without a seed, too."""
        given, zeros = self._demands.given(q), np.zeros(self._chain.dof)
        found = [("Python", *self.python.ik_all(T, *given))]
        found += [("C", *build.ik(T, zeros, *given)) for build in self._builds]
        for language, rows, _ in found:
            held = rows[filled(rows)]
            self._demands.reproduce(held, T, f"{where}, without a seed")
            if not len(held):
                raise VerificationError(f"{where}: without a seed {language} finds no solution")

    def batch(self, sample: Sample, poses: FloatArray) -> None:
        """Batches hold the rows of single poses."""
        given = self._demands.given(sample.q)
        zeros = np.zeros(self._chain.dof)
        languages = [("Python", self.python.ik_batch, self.python.ik_all)]
        languages += [
            ("C", build.batch, lambda T, *free, build=build: build.ik(T, zeros, *free))
            for build in self._builds
        ]
        for language, batch, alone in languages:
            where = f"{self._module.name}, {sample.name}, a batch of the {language}"
            many, statuses = batch(poses, *given)
            at, row = np.nonzero(filled(many))
            self._demands.reproduce(many[at, row], poses[at], where)
            if not (sample.name == "random" and self._demands.has_branches):
                continue
            for number, (T, rows, status) in enumerate(zip(poses, many, statuses, strict=True)):
                one, one_status = alone(T, *(g[number] for g in given))
                if not np.array_equal(status, one_status):
                    message = f"pose {number} has {status}, alone {one_status}"
                    raise VerificationError(f"{where}: {message}")
                held = filled(one)
                self._demands.agree(rows[held], one[held], T, language, f"{where}, pose {number}")

    def refuse(self, q: FloatArray, poses: FloatArray) -> None:
        """Batches refuse poses that are none.

        Args:
            q: The joint values (N, n) of poses that were spoiled.
            poses: The spoiled poses (N, 4, 4).
        """
        languages = [
            ("Python", self.python.ik_batch),
            *(("C", each.batch) for each in self._builds),
        ]
        for language, batch in languages:
            _, statuses = batch(poses, *self._demands.given(q))
            accepted = poses[(statuses != self.python.INVALID_POSE).any(axis=1)]
            if len(accepted):
                message = f"a batch of the {language} accepted an invalid pose:\n{accepted[0]}"
                raise VerificationError(f"{self._module.name}: {message}")

    def whole(
        self, T: FloatArray, q: FloatArray, rows: FloatArray, status: NDArray[np.uint8], where: str
    ) -> None:
        """Python's code for singular poses gives the same rows at regular ones."""
        calls, given = self.python._CALLS, self._demands.given(q)  # noqa: SLF001
        values = given[0] if given else np.zeros(1)
        _, pose = calls["read"](T, values)
        others, kinds = np.empty_like(rows), np.empty_like(status)
        calls["careful"](pose, values, q, others, kinds)
        if not np.array_equal(status, kinds):
            raise VerificationError(f"{where}: Python gives {status}, its careful solver {kinds}")
        held = filled(rows)
        self._demands.agree(rows[held], others[held], T, "its careful solver", where)

    def nearest(self, q: FloatArray, T: FloatArray, where: str) -> None:
        """The generating joint values are the nearest to themselves."""
        given = self._demands.given(q)
        nearest = [("Python's ik", self.python.ik(T, *given, q))]
        nearest += [("C's ik_nearest", build.nearest(T, q, *given)) for build in self._builds]
        for what, found in nearest:
            self._demands.nearest(found, q, f"{where}: {what}")

    def arm_angles(self, rows: FloatArray, q: FloatArray, where: str) -> None:
        """Every row, and the files' function, has the arm angle of the generating joints."""
        if not self._chain.arm_angle:
            return
        asked = self._demands.values(q)
        by_language = [self.python.arm_angle(q), *(build.arm_angle(q) for build in self._builds)]
        for angles in (self._demands.values(rows), np.array(by_language)[:, None]):
            self._demands.arm_angle(angles, asked, where)

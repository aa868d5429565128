"""Proves that C in single precision does what it promises, or refuses it.

Poses are computed in double precision and rounded; what comes back is put through the same
independent forward model. Single precision can't distinguish a pose at a singularity from one near
it, so which rows are filled there is not compared with double precision.
"""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.errors import VerificationError
from dhgen.kinematics.given import given_values
from dhgen.status import HELD, Status
from dhgen.tolerances import SINGLE
from dhgen.verify.measures import Measures
from dhgen.verify.native import compile_solver
from dhgen.verify.samples import samples, spoiled_poses

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.targets.module import SolverModule
    from dhgen.verify.samples import Sample


COUNT = 150  # poses of each sort
RESIDUAL = 5e-5  # of the arm's size: what a row may miss its pose by; a free joint moves it most
FOUND = 1e-2  # [rad or arm sizes] the generating joint values on random poses
FORWARD = 3e-6  # of the arm's size: what the forward model may be off by


def verify_single(module: SolverModule, folder: Path) -> float | None:
    """Checks the C of a robot in single precision as it lies in a folder.

    Returns:
        The largest miss of a row, in arm sizes; None without a compiler.

    Raises:
        VerificationError: Something is not as promised; the text names it, and the joints.
    """
    shape = (module.chain.dof, module.solver.rows, module.chain.given)
    solver = compile_solver(folder / f"{module.name}.c", folder, module.name, *shape)
    if solver is None:
        return None
    checker = _Checker(module, solver.library)
    for sample in samples(module.chain, COUNT):
        checker.sample(sample)
    checker.impossible()
    return checker.residual


class _Checker:
    def __init__(self, module: SolverModule, library: Any) -> None:  # noqa: ANN401 - of ctypes
        self._module = module
        self._library = library
        self._chain = module.chain
        self._measures = Measures(module.chain)
        self.residual = 0.0

    def sample(self, sample: Sample) -> None:
        """Every pose of a sample, with the generating joints as the seed."""
        random = sample.name == "random"
        for q, exact in zip(sample.q, self._measures.arm.pose(sample.q), strict=True):
            T = np.asarray(exact, np.float32)
            where = f"{self._module.name}, {sample.name}, q = {q.tolist()}"
            miss = float(self._measures.pose_miss(self._fk(q), exact))
            self._demand(miss, FORWARD, f"{where}: fk")
            rows, status = self._ik(T, q)
            held = rows[np.isin(status, HELD)]
            if not len(held):
                raise VerificationError(f"{where}: no row holds a solution")
            miss = self._measures.residual(held, np.asarray(T, np.float64))
            self.residual = max(self.residual, miss)
            self._demand(miss, RESIDUAL, f"{where}: a row's pose")
            if random:
                near = float(self._measures.joint_miss(held, q).max(axis=1).min())
                self._demand(near, FOUND, f"{where}: the nearest solution")
                nearest = float(np.abs(self._nearest(T, q) - q).max())
                enough = FOUND * max(1.0, self._chain.size)
                self._demand(nearest, enough, f"{where}: ik_nearest")

    def impossible(self) -> None:
        """Poses that are none, and poses out of reach."""
        name = self._module.name
        q = samples(self._chain, 8)[0].q
        endless = not all(self._chain.turning) or not self._chain.task.position_rows
        for joints, T in zip(q, self._measures.arm.pose(q), strict=True):
            for spoiled in spoiled_poses(self._chain.task, T):
                _, status = self._ik(spoiled, joints)
                if not (status == Status.INVALID_POSE).all():
                    raise VerificationError(f"{name}: accepted an invalid pose:\n{spoiled}")
            far = T.copy()
            far[:3, 3] += 10.0 * self._chain.size
            if not endless and not (self._ik(far, joints)[1] == Status.UNREACHABLE).all():
                raise VerificationError(f"{name}: claims to reach a pose out of reach:\n{far}")

    def _fk(self, q: FloatArray) -> FloatArray:
        T = np.empty((4, 4), np.float32)
        self._call("fk", q, T)
        return np.asarray(T, np.float64)

    def _ik(self, T: NDArray[Any], seed: FloatArray) -> tuple[FloatArray, NDArray[np.uint8]]:
        rows = np.empty((self._module.solver.rows, self._chain.dof), np.float32)
        status = np.empty(len(rows), np.uint8)
        self._call("ik", T, *self._given(seed), seed, rows, status)
        return np.asarray(rows, np.float64), status

    def _nearest(self, T: NDArray[Any], seed: FloatArray) -> FloatArray:
        q = np.empty(self._chain.dof, np.float32)
        self._call("ik_nearest", T, *self._given(seed), seed, q)
        return np.asarray(q, np.float64)

    def _given(self, q: FloatArray) -> list[FloatArray]:
        """The argument for free joints or the arm angle, where there are any."""
        values = given_values(self._measures.arm, q, SINGLE.tolerances)
        return [values] if self._chain.given else []

    def _call(self, function: str, *arrays: NDArray[Any]) -> None:
        """Numbers go over as floats; arrays that are floats or bytes already are filled."""
        given = [
            np.ascontiguousarray(a, np.float32) if a.dtype == np.float64 else a for a in arrays
        ]
        pointers = [a.ctypes.data_as(ctypes.c_void_p) for a in given]
        self._library[f"{self._module.name}_{function}"](*pointers)

    def _demand(self, miss: float, enough: float, what: str) -> None:
        if not miss <= enough:
            raise VerificationError(f"{what} is off by {miss:.1e}")

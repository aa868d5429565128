"""Proves that solvers whose table comes at run time do what they promise, or refuses them.

Tables are those of the data sheet with errors in every number; poses are those of an independent
forward model, factor by factor. Checked are which tables are taken, forward kinematics, the
Jacobian, and that rows of a batch meet their poses and hold the joint values that these are of, as
the rows of one pose do; in Python and in C, whose rows are the same. Joint velocities, and whether
rows are all that there are, are not.
"""

from __future__ import annotations

import ctypes
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.errors import VerificationError
from dhgen.runtime.python.calibrate import ANOTHER_ARM, NO_MISS, TABLE_SHAPE, TAKEN
from dhgen.runtime.python.calibrated_arm import CalibratedArm
from dhgen.runtime.python.calibration import NUMBERS
from dhgen.status import HELD, Status
from dhgen.verify.compiled import compiled_code, runtime_code, together
from dhgen.verify.native import compile_solver
from dhgen.verify.verify import imported

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from pathlib import Path
    from types import ModuleType

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.targets.calibrated import Kind

    Rows = tuple[FloatArray, NDArray[np.uint8]]

ERRORS = (1e-5, 1e-4, 1e-3)  # [rad, arm sizes] of tables, one each
COUNT = 100  # poses of each
FEW = 4  # where nothing is compiled: a pose takes a tenth of a second there
FORWARD = 1e-12  # [arm sizes, rad] what the forward model may be off by
RESIDUAL = 1e-10  # what a row may miss its pose by
RATE = 1e-8  # what the Jacobian may differ from quotients of differences
STEP = 1e-6  # [rad] of these
FOUND = 1e-6  # [rad] the generating joint values at random poses
MODIFIED = "modified"
LINK = ctypes.c_double * 12  # three rows of four


class Calibration(ctypes.Structure):
    """`dhgen_calibration` of dhgen/calibration.h."""

    _fields_ = (
        ("constant", LINK * 7),
        ("facing", ctypes.c_double * 6),
        ("turned", ctypes.c_double),
        ("moved", ctypes.c_double),
        ("loop", LINK * 7),
        ("size", ctypes.c_double),
        ("left", LINK),
        ("right", LINK),
        ("more", ctypes.c_double * 6),
        ("nominal", LINK * 7),
        ("margin", ctypes.c_double),
    )


def verify_kind(kind: Kind, folder: Path) -> Mapping[str, bytes]:
    """Checks Python and, where there is a compiler, C as they lie in a folder.

    Returns:
        What numba compiled, by the names that its files have.

    Raises:
        VerificationError: Something is not as promised.
    """
    module = kind.module
    shape = (module.chain.dof, module.solver.rows, 0)
    solver = compile_solver(folder / f"{module.name}.c", folder, module.name, *shape)
    python = imported(module, folder)
    arms: list[Callable[[FloatArray], PythonArm | FleetArm]] = [partial(PythonArm, python)]
    if solver is not None:
        arms.append(partial(FleetArm, solver.library, kind))
    nominal, size = np.array(kind.table.rows), kind.nominal.chain.size
    for arm in arms:
        if arm(nominal).fault != NO_MISS:
            raise VerificationError(f"{module.name}: takes the nominal table, which misses nothing")
        if arm(nominal + 1.0).fault != ANOTHER_ARM:
            raise VerificationError(f"{module.name}: takes the table of another arm")
    source, count = np.random.default_rng(11), COUNT if is_compiled(python) else FEW
    for error in ERRORS:
        units = np.array([1.0, size, size, 1.0])
        table = nominal + source.normal(0.0, error, nominal.shape) * units
        q = source.uniform(-np.pi, np.pi, (count, module.chain.dof))
        T = poses_of(kind, table, q)
        found = [_checked(arm(table), kind, table, q, T) for arm in arms]
        _compare(found, kind, table, T)
    if not is_compiled(python):
        return {}
    python.warm_up()  # what no pose needed is compiled, too, and kept for who imports it
    return together(runtime_code(), compiled_code(python))


def is_compiled(python: ModuleType) -> bool:
    """Whether numba compiles an imported module."""
    return hasattr(vars(python)["_CALLS"]["seeded"], "stats")


class PythonArm:
    """An arm of a kind in Python, with the functions of one in C.

    Args:
        python: The module of the kind.
        given: Its table (6, 4), or origins (7, 6).

    Attributes:
        fault: What the code returned for the numbers.
        numbers: What was filled in, in the order of the structure in C.
    """

    def __init__(self, python: ModuleType, given: FloatArray) -> None:
        calls = vars(python)["_CALLS"]
        arm, self.fault = calls["worked_out"](given)
        # The compiler's own runtime is imported before the copy beside the module: what is compiled
        # apart of the same text is compiled once.
        self._arm = CalibratedArm(given, arm, calls)
        self._unreachable = python.Unreachable
        self.numbers: FloatArray = arm[-NUMBERS:]
        self.fk, self.jacobian, self.batch = self._arm.fk, self._arm.jacobian, self._arm.ik_batch
        self.ik, self.joint_velocities = self._arm.ik_all, self._arm.joint_velocities

    def nearest(self, T: FloatArray, seed: FloatArray) -> FloatArray:
        """The row nearest to the seed (n,), NaN without one."""
        try:
            return np.asarray(self._arm.ik(T, seed))
        except self._unreachable:
            return np.full(len(seed), np.nan)


class FleetArm:
    """An arm of a kind in C, and what was filled in for its table.

    Args:
        library: The shared library.
        kind: The kind.
        given: Its table (6, 4), or origins (7, 6).

    Attributes:
        fault: What the code returned for the numbers.
        members: What was filled in.
    """

    def __init__(self, library: Any, kind: Kind, given: FloatArray) -> None:  # noqa: ANN401
        self._library, self._name = library, kind.module.name
        self._shape = kind.module.solver.rows, kind.module.chain.dof
        self.members = Calibration()
        rows = np.ascontiguousarray(given, np.float64)
        suffix = "" if rows.shape == TABLE_SHAPE else "_origins"
        function = library[f"{self._name}_calibrate{suffix}"]
        self.fault = int(function(_pointer(rows), ctypes.byref(self.members)))

    @property
    def numbers(self) -> FloatArray:
        """The arm's numbers as one array."""
        return np.frombuffer(bytes(self.members), np.float64)

    def fk(self, q: FloatArray) -> FloatArray:
        """The pose (4, 4) of joint values (n,)."""
        T = np.empty((4, 4))
        self._call("fk", q, T)
        return T

    def jacobian(self, q: FloatArray) -> FloatArray:
        """The Jacobian (6, n)."""
        J = np.empty((6, len(q)))
        self._call("jacobian", q, J)
        return J

    def ik(self, T: FloatArray, seed: FloatArray) -> tuple[FloatArray, NDArray[np.uint8]]:
        """All rows (B, n) and their statuses (B,)."""
        q, status = np.empty(self._shape), np.empty(self._shape[0], np.uint8)
        self._call("ik", T, seed, q, status)
        return q, status

    def batch(self, T: FloatArray) -> tuple[FloatArray, NDArray[np.uint8]]:
        """All rows (N, B, n) and their statuses (N, B) of many poses (N, 4, 4)."""
        q = np.empty((len(T), *self._shape))
        status = np.empty((len(T), self._shape[0]), np.uint8)
        arrays: tuple[NDArray[Any], ...] = np.ascontiguousarray(T, np.float64), q, status
        function = self._library[f"{self._name}_ik_batch"]
        function(ctypes.byref(self.members), ctypes.c_size_t(len(T)), *map(_pointer, arrays))
        return q, status

    def nearest(self, T: FloatArray, seed: FloatArray) -> FloatArray:
        """The row nearest to the seed (n,), NaN without one."""
        q = np.empty(self._shape[1])
        self._call("ik_nearest", T, seed, q)
        return q

    def joint_velocities(self, q: FloatArray, twist: FloatArray) -> FloatArray:
        """The joint velocities (n,) of a twist (6,)."""
        found = np.empty(len(q))
        self._call("joint_velocities", q, twist, found)
        return found

    def _call(self, function: str, *arrays: NDArray[Any]) -> None:
        kept: list[NDArray[Any]] = [np.ascontiguousarray(each) for each in arrays]
        own = self._library[f"{self._name}_{function}"]
        own(ctypes.byref(self.members), *map(_pointer, kept))


def poses_of(kind: Kind, table: FloatArray, q: FloatArray) -> FloatArray:
    """The poses (N, 4, 4) of joint values (N, n), factor by factor."""
    lower = np.array([[0.0, 0.0, 0.0, 1.0]])
    base, tool = (np.reshape(each, (3, 4)) for each in (kind.table.base, kind.table.tool))
    T = np.broadcast_to(np.concatenate([base, lower]), (len(q), 4, 4))
    signs = [joint.sign for joint in kind.nominal.chain.joints]
    for place, (theta, d, a, alpha) in enumerate(table.tolist()):
        along = _screw(2, theta + signs[place] * q[:, place], d)
        across = _screw(0, np.full(len(q), alpha), a)
        is_modified = kind.table.convention == MODIFIED
        T = T @ across @ along if is_modified else T @ along @ across
    return np.asarray(T @ np.concatenate([tool, lower]))


def _screw(axis: int, angle: FloatArray, length: float) -> FloatArray:
    """Motions about and along an axis, (N, 4, 4)."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    motion = np.zeros((len(angle), 4, 4))
    motion[:, axis, axis] = motion[:, 3, 3] = 1.0
    motion[:, i, i] = motion[:, j, j] = np.cos(angle)
    motion[:, j, i] = np.sin(angle)
    motion[:, i, j] = -motion[:, j, i]
    motion[:, axis, 3] = length
    return motion


def _checked(
    arm: PythonArm | FleetArm, kind: Kind, table: FloatArray, q: FloatArray, T: FloatArray
) -> Rows:
    """The rows of poses: each meets its pose, and one holds the joint values that it is of."""
    name, weights = kind.module.name, np.array([1.0, 1.0, 1.0, 1.0 / kind.nominal.chain.size])
    if arm.fault != TAKEN:
        raise VerificationError(f"{name}: does not take the table\n{table}")
    found = arm.batch(T)
    for joints, pose, rows, status in zip(q, T, *found, strict=True):
        where = f"{name}, table\n{table}\nq = {joints.tolist()}"
        _demand(np.abs((arm.fk(joints) - pose) * weights).max(), FORWARD, f"{where}: fk")
        held = rows[np.isin(status, HELD)]
        turned = _turned(held, joints)
        _demand(turned.min(initial=np.inf), FOUND, f"{where}: the nearest solution")
        missed = np.abs((poses_of(kind, table, held) - pose) * weights).max()
        _demand(missed, RESIDUAL, f"{where}: a row's pose")
        within = rows[np.isin(status, (Status.OK, Status.FREE_JOINT))]
        own = within[_turned(within, joints) <= FOUND]  # turned to where limits have it
        if len(own):
            near = arm.nearest(pose, own[0])
            _demand(float(_turned(near, joints)), FOUND, f"{where}: the row nearest to the seed")
    _check_first(arm, kind, table, q[0], T[0])
    return found


def _turned(q: FloatArray, joints: FloatArray) -> FloatArray:
    """By how much angles differ at most, whole turns aside."""
    off = np.abs(np.mod(q - joints + np.pi, 2.0 * np.pi) - np.pi)
    return np.asarray(off.max(axis=-1))


def _compare(found: list[Rows], kind: Kind, table: FloatArray, T: FloatArray) -> None:
    """All languages give equal rows: order may be rounding's where first joints agree."""
    (rows, status), *others = found
    for other, kinds in others:
        for number, pose in enumerate(T):
            where = f"{kind.module.name}, table\n{table}\nT =\n{pose}"
            if sorted(status[number]) != sorted(kinds[number]):
                raise VerificationError(
                    f"{where}: Python gives {status[number]}, C gives {kinds[number]}"
                )
            held = rows[number][np.isin(status[number], HELD)]
            there = other[number][np.isin(kinds[number], HELD)]
            for row in held:
                _demand(_turned(there, row).min(), FOUND, f"{where}: a row of Python in C")
            for row in there:
                _demand(_turned(held, row).min(), FOUND, f"{where}: a row of C in Python")


def _check_first(
    arm: PythonArm | FleetArm, kind: Kind, table: FloatArray, joints: FloatArray, pose: FloatArray
) -> None:
    """At one pose: the Jacobian, and rows that are those of a batch, bit for bit."""
    where, size = (
        f"{kind.module.name}, table\n{table}\nq = {joints.tolist()}",
        kind.nominal.chain.size,
    )
    steps = STEP * np.eye(len(joints))
    ahead, back = (poses_of(kind, table, joints + each) for each in (steps, -steps))
    rates = (ahead - back) / (2.0 * STEP)
    spin = rates[:, :3, :3] @ pose[:3, :3].T
    expected = np.vstack([rates[:, :3, 3].T, spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]])
    units = np.repeat([size, 1.0], 3)[:, None]
    _demand(np.abs((arm.jacobian(joints) - expected) / units).max(), RATE, f"{where}: the Jacobian")
    rows, status = arm.ik(pose, np.zeros(len(joints)))
    others, kinds = arm.batch(pose[None])
    if not (np.array_equal(rows, others[0], equal_nan=True) and np.array_equal(status, kinds[0])):
        raise VerificationError(f"{where}: ik and ik_batch have different rows")


def _demand(miss: float, enough: float, what: str) -> None:
    if not miss <= enough:
        raise VerificationError(f"{what} is off by {miss:.1e}")


def _pointer(array: NDArray[Any]) -> ctypes.c_void_p:
    return array.ctypes.data_as(ctypes.c_void_p)

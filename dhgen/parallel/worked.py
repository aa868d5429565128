"""A parallel robot at work while it is compiled: its legs' programs, interpreted."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.whole_turns import are_inside, turned_rows
from dhgen.kinematics.numeric import NumericArm, numeric_arm
from dhgen.legs.robot import inverse
from dhgen.program.interpret import interpret
from dhgen.runtime.python.assemblies import assemblies
from dhgen.runtime.python.direct import least_values
from dhgen.runtime.python.platform import LENGTHS, POSE, YAW, Leg, Platform, drives_of
from dhgen.status import Status

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.parallel.module import ParallelModule
    from dhgen.targets.module import SolverModule

DRAWN = 4000  # poses that the first leg reaches
TURNED = 0.5  # a platform whose legs carry points is turned by so much at most about an axis [rad]
TRIED = 600  # poses that are looked at for an example


class Interpreted:
    """A leg's chain with the functions that its module has, by the program's meaning."""

    def __init__(self, solver: SolverModule) -> None:
        self._solver = solver
        self._arm: NumericArm = numeric_arm(solver.chain)
        self.DOF = solver.chain.dof
        self.MAX_SOLUTIONS = solver.solver.rows
        self.JOINT_TYPES = solver.chain.joint_types

    def fk(self, q: FloatArray) -> FloatArray:
        """The pose of joint values."""
        return self._arm.pose(q)

    def jacobian(self, q: FloatArray) -> FloatArray:
        """The geometric Jacobian."""
        return self._arm.jacobian(q)

    def ik_batch(self, T: FloatArray) -> FloatArray:
        """All rows (N, rows, joints) of poses, turned inside limits, NaN without a solution."""
        found = interpret(self._solver.solver, T, np.zeros((len(T), self.DOF)))
        return turned_rows(self._solver.chain, found.q)

    def ik_all(self, T: FloatArray) -> tuple[FloatArray, NDArray[np.uint8]]:
        """All rows of a pose, and whether they are within limits."""
        rows = self.ik_batch(T[None])[0]
        status = np.where(_inside(rows, self._solver), Status.OK, Status.OUT_OF_LIMITS)
        return rows, status.astype(np.uint8)


@dataclass(frozen=True, slots=True)
class Example:
    """A pose of the platform, and what its legs are there.

    Attributes:
        T: The pose (4, 4).
        rows: Joint values (legs, rows, joints), NaN without a solution.
        inside: Which rows are within limits (legs, rows).
        drives: The driven ones of the first row of each leg within limits.
        least: The smallest singular values of B and A there.
        assemblies: All poses that the drives allow; none where these are not known.
    """

    T: FloatArray
    rows: FloatArray
    inside: FloatArray
    drives: FloatArray
    least: tuple[float, float]
    assemblies: FloatArray


def platform_of(module: ParallelModule) -> Platform:
    """The platform, whose legs are interpreted."""
    solvers = {leg.solver.name: leg.solver for leg in module.legs}
    at_work = {name: Interpreted(solver) for name, solver in solvers.items()}
    legs = (
        Leg(
            at_work[leg.solver.name],
            leg.driven,
            leg.counted,
            square(inverse(leg.leg.base)),
            square(leg.leg.end),
        )
        for leg in module.legs
    )
    return Platform(
        tuple(legs),
        module.counts,
        module.is_planar,
        module.freedoms,
        module.size,
    )


def drawn_poses(module: ParallelModule, source: np.random.Generator) -> FloatArray:
    """Poses of the platform that the first leg reaches."""
    first = module.legs[0]
    leg, chain = first.leg, first.solver.chain
    most = np.where(chain.turning, np.pi, module.size)
    ranges = zip(chain.joints, most, strict=True)
    low, high = np.array([joint.limits or (-end, end) for joint, end in ranges]).T
    ends = numeric_arm(chain).pose(source.uniform(low, high, (DRAWN, chain.dof)))
    base, end = square(leg.base), square(leg.end)
    if leg.carries_frame:
        return base @ ends @ np.linalg.inv(end)
    poses = np.broadcast_to(np.eye(4), (DRAWN, 4, 4)).copy()
    axes = [each - LENGTHS for each in module.freedoms if each >= LENGTHS]
    turns = source.uniform(-TURNED, TURNED, (DRAWN, len(axes)))
    for axis, angles in zip(axes, turns.T, strict=True):
        poses[:, :3, :3] = poses[:, :3, :3] @ turn_about(axis, angles)
    poses[:, :3, 3] = (base @ ends)[:, :3, 3] - poses[:, :3, :3] @ end[:3, 3]
    return poses


def reached(
    module: ParallelModule,
    keeps: Callable[[FloatArray], NDArray[np.bool_]],
    count: int,
    seed: int,
    tries: int | None = None,
) -> FloatArray:
    """The first of the drawn poses that are kept.

    Args:
        module: The robot.
        keeps: Which poses (n, 4, 4) are.
        count: How many are wanted.
        seed: Of the draws.
        tries: After so many draws there are fewer; None for no end.
    """
    source, found = np.random.default_rng(seed), np.empty((0, 4, 4))
    for _ in itertools.count() if tries is None else range(tries):
        poses = drawn_poses(module, source)
        found = np.concatenate([found, poses[keeps(poses)]])
        if len(found) >= count:
            break
    return found[:count]


def turn_about(axis: int, angles: FloatArray | float) -> FloatArray:
    """Turns (..., 3, 3) by angles about an axis, x, y or z by its number."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turn = np.broadcast_to(np.eye(3), (*np.shape(angles), 3, 3)).copy()
    turn[..., i, i] = turn[..., j, j] = np.cos(angles)
    turn[..., j, i] = np.sin(angles)
    turn[..., i, j] = -turn[..., j, i]
    return turn


def example_of(module: ParallelModule) -> Example | None:
    """A pose with short numbers that all legs reach within limits; None where none is found."""
    platform, source = platform_of(module), np.random.default_rng(3)
    poses = drawn_poses(module, source)
    upright = poses[:, 2, 3] > 0.0 if platform.task == POSE else np.ones(len(poses), bool)
    for T in poses[upright][:TRIED]:  # a platform that moves in all ways is on top of its legs
        X = _rounded(platform, T)
        q = [np.asarray(leg.module.ik_all(leg.pose(X))[0]) for leg in platform.legs]
        inside = [_inside(rows, leg.solver) for rows, leg in zip(q, module.legs, strict=True)]
        if not all(each.any() for each in inside):
            continue
        rows = np.full((len(q), module.rows, module.joints), np.nan)
        good = np.zeros((len(q), module.rows), bool)
        mode = np.full((len(q), module.joints), np.nan)
        for number, own in enumerate(q):
            rows[number, : len(own), : own.shape[1]] = own
            good[number, : len(own)] = inside[number]
            mode[number, : own.shape[1]] = own[np.argmax(inside[number])]
        least = least_values(platform, X, mode)
        if min(least) < 0.1:
            continue
        drives = drives_of(module.driven_joints, mode)
        found = np.empty((0, 4, 4))
        if module.elimination is not None:
            found = assemblies(platform, module.elimination, drives, module.joints)
        return Example(X, rows, good, drives, least, found)
    return None


def _rounded(platform: Platform, T: FloatArray) -> FloatArray:
    """A pose near another one, of short numbers where it does not turn in space."""
    X = T.copy()
    X[:3, 3] = np.round(X[:3, 3], 2)
    if platform.task == YAW:
        angle = np.radians(np.round(np.degrees(np.arctan2(T[1, 0], T[0, 0]))))
        c, s = np.cos(angle), np.sin(angle)
        X[:2, :2] = [[c, -s], [s, c]]
    elif platform.task == POSE:
        X[:3, :3] = np.eye(3)
    return platform.read(X)[1]


def _inside(rows: FloatArray, solver: SolverModule) -> NDArray[np.bool_]:
    """Which rows (rows, joints) have joint values within limits, whole turns aside."""
    return are_inside(solver.chain, rows) & ~np.isnan(rows).any(axis=1)


def square(rows: Sequence[float]) -> FloatArray:
    """A frame as a matrix (4, 4)."""
    return np.array([*rows, 0.0, 0.0, 0.0, 1.0]).reshape(4, 4)

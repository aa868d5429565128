"""Arms of fewer joints than the pose has numbers: of a free joint only some values serve.

Where the equation that decides a joint says nothing the rest of the pose still leaves that joint a
few values, and seldom the seed's. All joints are at multiples of right angles here.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.compiling import library
from tests.structures import first_of
from tests.targets.calling import FREE_JOINT, HELD
from tests.targets.made import folder, made_up, without_numba

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation
    from dhgen.verify.native import CompiledSolver

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

ARMS = {
    "crossed": (  # 3R1P
        "theta: q, d: 0.4, a: 0, alpha: pi/2",
        "theta: q, d: 0, a: 0.3, alpha: pi/2",
        "theta: q, d: 0, a: 0, alpha: pi/2",
        "theta: 0, d: q, a: 0, alpha: 0",
    ),
    "elbow": (  # a PUMA without its last joint
        "theta: q, d: 0.67, a: 0, alpha: pi/2",
        "theta: q, d: 0, a: 0.43, alpha: 0",
        "theta: q, d: 0.15, a: 0.02, alpha: -pi/2",
        "theta: q, d: 0.43, a: 0, alpha: pi/2",
        "theta: q, d: 0, a: 0, alpha: -pi/2",
    ),
    "upright": (  # a UR5 without its last joint: it may be out of reach, too
        "theta: q, d: 0.09, a: 0, alpha: pi/2",
        "theta: q, d: 0, a: -0.43, alpha: 0",
        "theta: q, d: 0, a: -0.39, alpha: 0",
        "theta: q, d: 0.11, a: 0, alpha: pi/2",
        "theta: q, d: 0.09, a: 0, alpha: -pi/2",
    ),
    "barrel": (  # 3R1P: the slide's line leaves the reach of two links at either end
        "theta: q, d: 0, a: 0.168, alpha: -pi/2",
        "theta: q, d: 0.475, a: 0, alpha: pi/2",
        "theta: q, d: 0.232, a: 0, alpha: -pi/2",
        "theta: pi/2, d: q, a: 0.146, alpha: -60 deg",
    ),
    "facing": (  # 4R: what the equation leaves is a difference of two joints' values
        "theta: q, d: -0.25, a: -0.25, alpha: pi",
        "theta: q, d: 0, a: 0, alpha: -pi/2",
        "theta: q, d: 0, a: 0.3, alpha: -pi/2",
        "theta: q, d: 0, a: 0, alpha: -pi/2",
    ),
}
COUNT = 60
EXACT = 1e-11  # how far a pose may be missed that has not been rounded
PLAIN = 4  # of many poses, solved in plain Python, too
APART = 1e-4  # between joint values of two solutions [rad]


@cache
def compiled(name: str) -> Compilation:
    return made_up(name, ARMS[name], "tool: {xyz: [0, 0, 0.1]}\ntask: pose\n")


@cache
def in_c(name: str) -> CompiledSolver:
    return library(compiled(name).module, folder())


def asked(name: str, count: int = COUNT) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Joint vectors, their poses, and seeds that have nothing to do with them."""
    source = np.random.default_rng(8)
    q: FloatArray = source.choice([-np.pi / 2, 0.0, np.pi / 2, np.pi], (count, len(ARMS[name])))
    slides = ["d: q" in joint for joint in ARMS[name]]
    q[:, slides] = source.uniform(0.1, 0.6, (count, sum(slides)))
    return q, poses_of(name, q), source.uniform(-3.0, 3.0, q.shape)


def poses_of(name: str, q: FloatArray) -> FloatArray:
    return np.asarray(forward(compiled(name).robot, q), dtype=float)


def turned(angle: Any) -> Any:
    return angle - 2 * np.pi * np.round(angle / (2 * np.pi))


@pytest.mark.parametrize("name", first_of(ARMS, count=2))
def test_every_pose_has_a_row_whatever_the_seed(name: str) -> None:
    solver = in_c(name)
    found: list[tuple[FloatArray, FloatArray]] = []
    for joints, T, seed in zip(*asked(name), strict=True):
        own, own_status = solver.ik(T, joints)
        own_held = np.isin(own_status, HELD)
        assert np.abs(turned(own[own_held] - joints)).max(axis=1).min() < 1e-6
        for any_seed in (seed, np.zeros(len(joints))):
            rows, status = solver.ik(T, any_seed)
            held = np.isin(status, HELD)
            assert not (own_held & ~held).any(), joints
            found += [(row, T) for row in rows[held]]
    rows, poses = (np.array(each) for each in zip(*found, strict=True))
    assert np.abs(poses_of(name, rows) - poses).max() < EXACT


def test_branches_that_meet_are_told_once() -> None:
    """A stretched arm's other branch ends beside the solution, and nearly meets the pose there."""
    solver = in_c("upright")
    for _, T, seed in zip(*asked("upright"), strict=True):
        for any_seed in (seed, np.zeros(len(seed))):
            rows, status = solver.ik(T, any_seed)
            held = rows[np.isin(status, HELD)]
            for place, row in enumerate(held[1:], start=1):
                assert np.abs(turned(held[:place] - row)).max(axis=1).min() > APART, (row, held)


def test_the_nearest_value_is_taken() -> None:
    """Only joint 1 is ever free: of two values the other one takes the row that is left."""
    solver, two = in_c("crossed"), 0
    for joints, T, seed in zip(*asked("crossed"), strict=True):
        rows, status = solver.ik(T, seed)
        held = rows[np.isin(status, HELD)]
        assert np.abs(turned(held - joints)).max(axis=1).min() < 1e-5, joints
        free = rows[status == FREE_JOINT]
        if len(free):
            move, other = (
                abs(turned(values - seed[0])).min() for values in (free[:, 0], joints[:1])
            )
            assert move < other + 1e-6
        two += len(free) == 2
    assert two > 0


def test_an_exact_value_is_taken_though_a_nearer_one_nearly_fits() -> None:
    """The slide leaves the links' reach at two lengths; at one of them axis 2 leans a little."""
    source = np.random.default_rng(3)
    q = np.stack([source.uniform(-3.0, 3.0, 8), *np.full((2, 8), -np.pi), np.full(8, 1.7)], axis=1)
    q[:, 1] += 1e-6
    q[:, 2] += 1e-10
    for joints, T in zip(q, poses_of("barrel", q), strict=True):
        rows, status = in_c("barrel").ik(T, np.zeros(4))
        held = rows[np.isin(status, HELD)]
        assert abs(held[:, 3] - joints[3]).max() < 1e-6, held
        assert np.abs(poses_of("barrel", held) - T).max() < EXACT


def test_a_rounded_pose_is_met_nearly() -> None:
    """Six digits leave right angles exact, so that the joint is free, but no value fits exactly."""
    found: list[tuple[FloatArray, FloatArray]] = []
    for joints, T, seed in zip(*asked("crossed"), strict=True):
        rounded = T.copy()
        rounded[:3, 3] += [4e-7, -4e-7, 4e-7]
        rows, status = in_c("crossed").ik(rounded, seed)
        held = np.isin(status, HELD)
        assert held.any(), joints
        found += [(row, rounded) for row in rows[held]]
    rows, poses = (np.array(each) for each in zip(*found, strict=True))
    assert EXACT < np.abs(poses_of("crossed", rows) - poses).max() < 1e-6


def beside(name: str, off: float, count: int = COUNT) -> tuple[FloatArray, FloatArray]:
    """Joint vectors of which most are a little beside right angles, and their poses."""
    source = np.random.default_rng(4)
    right = asked(name, count)[0]
    near = right + off * source.choice([-1.0, 1.0], right.shape)
    q = np.where(source.random(right.shape) < 0.7, near, source.uniform(0.1, 1.4, right.shape))
    return q, poses_of(name, q)


@pytest.mark.parametrize("off", [1e-12, 1e-10, 1e-8, 1e-6])
@pytest.mark.parametrize("name", first_of(ARMS, count=2))
def test_rows_are_exact_beside_right_angles(name: str, off: float) -> None:
    """Angles of short vectors are good to few digits, and wrong branches nearly meet the pose."""
    for joints, T in zip(*beside(name, off), strict=True):
        rows, status = in_c(name).ik(T, joints)
        held = rows[np.isin(status, HELD)]
        assert len(held), joints.tolist()
        assert np.abs(turned(held - joints)).max(axis=1).min() < 1e-3
        assert np.abs(poses_of(name, held) - T).max() < EXACT
        for place, row in enumerate(held):
            assert not (np.abs(turned(held[:place] - row)).max(axis=1) < 1e-7).any(), joints


@pytest.mark.parametrize("name", first_of(ARMS, count=2))
def test_python_finds_the_same_beside_right_angles(name: str) -> None:
    python = without_numba(compiled(name).files[f"{name}.py"], name)
    for joints, T in zip(*beside(name, 1e-10, 20), strict=True):
        rows, status = in_c(name).ik(T, joints)
        own, own_status = python.ik_all(T, joints)
        assert own_status.tolist() == status.tolist()
        held = np.isin(status, HELD)
        assert np.abs(poses_of(name, own[held]) - T).max() < EXACT
        assert np.abs(turned(own[held] - rows[held])).max() < 1e-6


@pytest.mark.parametrize("name", first_of(ARMS, count=2))
def test_python_finds_the_same(name: str) -> None:
    python = without_numba(compiled(name).files[f"{name}.py"], name)
    for T, seed in zip(*asked(name, 4)[1:], strict=True):
        rows, status = in_c(name).ik(T, seed)
        own, own_status = python.ik_all(T, seed)
        assert own_status.tolist() == status.tolist()
        held = np.isin(status, HELD)
        assert np.abs(turned(own[held] - rows[held])).max() < 1e-6


# Folded, the wrist stands on axis 2, whose joint is free; next to that all its values nearly fit.
FOLDING = (
    "theta: q, d: 0, a: 0, alpha: -pi/2",
    "theta: q, d: 0, a: 0.3, alpha: pi",
    "theta: q, d: 0, a: 0.3, alpha: -pi/2",
    "theta: q, d: 0.121, a: 0.3, alpha: pi/2",
    "theta: q, d: 0, a: 0.4, alpha: -pi/2",
)


@pytest.mark.parametrize("off", first_of([1e-10, 1e-12, 1e-8]))
def test_rows_are_exact_where_a_joint_is_nearly_free(off: float) -> None:
    """A value that misses the pose by next to nothing does not stand for one that was rounded."""
    compilation = made_up("folding", FOLDING, "task: pose\n", "modified")
    solver = library(compilation.module, folder())
    python = without_numba(compilation.files["folding.py"], "folding")
    source = np.random.default_rng(2)
    for number, q in enumerate(source.uniform(-3.0, 3.0, (60, 5))):
        q[2] = np.pi - off
        T = np.asarray(forward(compilation.robot, q), dtype=float)
        told = [solver.ik(T, np.zeros(5))]
        if number < PLAIN:
            told.append(python.ik_all(T))
        for rows, status in told:
            held = rows[np.isin(status, HELD)]
            assert len(held)
            reached = np.asarray(forward(compilation.robot, held), dtype=float)
            assert np.abs(reached - T).max() < EXACT

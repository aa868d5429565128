"""A and B against differences of the closure equations, by a forward model that shares no code."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from dhgen.parallel.verify import moved_pose
from dhgen.parallel.worked import square
from tests.parallel.made import (
    NAMES,
    OWN,
    both,
    compilation,
    mode,
    native,
    poses,
    python,
)

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.arrays import FloatArray
    from dhgen.parallel.module import LegModule, ParallelModule

FILES = tuple(name for name in (*NAMES, *OWN) if name != "one_rail")  # which is singular everywhere
STEP = 1e-3  # of differences [rad, robot sizes]
NEAR = 1e-8  # what these may be away, to A's and B's size
REGULAR = 0.02  # smallest singular value above which a pose is asked for


def slope(place: Callable[[float], FloatArray], unit: float) -> FloatArray:
    """The twist (6,) of a frame (4, 4) that moves with a parameter, by differences."""

    def across(step: float) -> FloatArray:
        behind, ahead = place(-step), place(step)
        turn = ahead[:3, :3] @ behind[:3, :3].T
        turned = [turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]
        return np.array([*(ahead - behind)[:3, 3], *(0.5 * np.array(turned))]) / (2.0 * step)

    # of three steps, so that their squares and fourth powers cancel (Richardson)
    wide, middle, narrow = (across(unit * STEP / divided) for divided in (1, 2, 4))
    return (64.0 * narrow - 20.0 * middle + wide) / 45.0


def wanted_of_leg(
    module: ParallelModule, leg: LegModule, T: FloatArray, q: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """The rows of a leg in A, and its block of B."""
    size, dof = module.size, leg.solver.chain.dof
    base, end = square(leg.leg.base), square(leg.leg.end)
    rows = [each for each in module.freedoms if each < 3 or leg.leg.carries_frame]
    units = np.array([1.0 / size if each < 3 else 1.0 for each in rows])[:, None]

    def of_joint(joint: int) -> FloatArray:
        def place(step: float) -> FloatArray:
            moved = q[:dof].copy()
            moved[joint] += step
            return base @ forward(leg.leg.chain, moved)

        return slope(place, 1.0 if leg.solver.chain.turning[joint] else size)

    def of_platform(freedom: int) -> FloatArray:
        unit = size if freedom < 3 else 1.0
        return slope(lambda step: moved_pose(T, freedom, step) @ end, unit)

    driven = list(leg.leg.driven)
    passive = [joint for joint in range(dof) if joint not in driven]
    moved = units * np.array([of_joint(joint) for joint in range(dof)]).T[rows]
    V = units * np.array([of_platform(freedom) for freedom in module.freedoms]).T[rows]
    across = np.linalg.svd(moved[:, passive])[0][:, len(passive) :] if passive else np.eye(dof)
    turn, B = np.linalg.qr(across.T @ moved[:, driven])
    signs = np.where(np.diagonal(B) < 0.0, -1.0, 1.0)
    N = across @ turn * signs
    return size * N.T @ V, size * N.T @ moved[:, driven]


@pytest.mark.parametrize("name", FILES)
def test_both_matrices_are_those_of_the_closure(name: str) -> None:
    """Their rows too: of unit length across passive joints, and with drives that move forwards."""
    module, asked = compilation(name).module, 0
    units = [module.size if each < 3 else 1.0 for each in module.freedoms]
    for T in poses(name)[:12]:
        q = mode(name, T)
        if min(native(name).singularities(T, q)) < REGULAR:
            continue
        A, B = np.zeros((2, len(units), len(units)))
        row = 0
        for leg, own in zip(module.legs, q, strict=True):
            block = slice(row, row + len(leg.driven))
            A[block], B[block, block] = wanted_of_leg(module, leg, T, own)
            row = block.stop
        asked += 1
        for found in (native(name).velocities(T, q), python(name).velocities(T, q)):
            np.testing.assert_allclose(found[0] * units, A * units, rtol=0, atol=NEAR * module.size)
            np.testing.assert_allclose(found[1], B, rtol=0, atol=NEAR * np.abs(B).max())
            assert (np.tril(found[1], -1) == 0.0).all()
    assert asked >= 5


FREE = 2


def upright() -> tuple[FloatArray, FloatArray]:
    """A pose of the Stewart platform, leg 1 along the first axis of its universal joint."""
    leg = compilation("stewart").module.legs[0].leg
    T = np.eye(4)
    T[:3, 3] = square(leg.base)[:3, 3] - square(leg.end)[:3, 3] + [0.0, 0.0, 0.5]
    q, status = python("stewart").ik_all(T)
    assert status[0, 0] == FREE
    return T, np.ascontiguousarray(q[:, 0])


def test_passive_joints_that_depend_on_each_other_are_told() -> None:
    """The axis of the universal joint is the rod's: it turns alone, and the end can't go aside."""
    T, q = upright()
    c, robot = native("stewart"), python("stewart")
    told = c._call("velocities", T, q, np.empty(36), np.empty(36))
    assert told == -FREE
    assert all(np.isnan(each).all() for each in c.velocities(T, q))
    with pytest.raises(ValueError, match="passive joints of leg 1 depend on each other"):
        robot.velocities(T, q)
    least = robot.singularities(T, q)
    assert least.first == 0.0
    assert np.isnan(least.second)
    assert np.isnan(least.gained).all()
    first, second = c.singularities(T, q)
    assert first == 0.0
    assert np.isnan(second)
    # what vanishes is the velocity of the leg's point along the joint's other axis
    point = square(compilation("stewart").module.legs[0].leg.end)[:3, 3]
    base = square(compilation("stewart").module.legs[0].leg.base)[:3, :3]
    along = base @ [-np.sin(q[0, 0]), np.cos(q[0, 0]), 0.0]
    motion = np.array([*along, *np.cross(point, along)])
    np.testing.assert_allclose(
        np.abs(least.lost @ motion), np.linalg.norm(least.lost) * np.linalg.norm(motion), rtol=1e-12
    )


@pytest.mark.parametrize("step", [0.0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3, 0.05])
def test_the_direct_model_leads_on_from_where_passive_joints_depend(step: float) -> None:
    """Steps alone do not turn the first axis: it moves nothing there."""
    T, q = upright()
    source = np.random.default_rng(4)
    for _ in range(6):
        goal = T.copy()
        goal[:3, 3] += step * source.normal(size=3)
        drives = python("stewart").drives(python("stewart").ik(goal, q, limits=False))
        for found, told in both("stewart", drives, T):
            assert told == (0 if step >= 1e-5 else FREE)
            np.testing.assert_allclose(found, goal, rtol=0, atol=1e-9)

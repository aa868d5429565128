"""The numerical solver against arms whose solutions are known by a closed form."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.numerical.kernel import NumericalKernel, numerical_kernel
from dhgen.numerical.runtime_arm import runtime_arm
from dhgen.robot.load import load
from dhgen.runtime.python.numerical.arm import arm_numbers, strides
from dhgen.runtime.python.numerical.search import solve_whole
from dhgen.runtime.python.status import FREE_JOINT, UNREACHABLE
from tests.structures import first_of
from tests.targets.made import ROBOTS, in_c


def kernel(name: str) -> NumericalKernel:
    return numerical_kernel(build_chain(load(ROBOTS / f"{name}.yaml")), redundant=False)


@dataclass(frozen=True)
class Found:
    """Solutions, and in which of them a joint was indeterminate."""

    q: np.ndarray
    chosen: np.ndarray


def solve(T: np.ndarray, seed: np.ndarray, arm: NumericalKernel) -> Found:
    numbers, entries = arm_numbers(runtime_arm(arm)), tuple(map(float, T[:3].ravel()))
    q, status = solve_whole(numbers, entries, np.zeros(0), seed)
    found = status != UNREACHABLE
    return Found(q[found], status[found] == FREE_JOINT)


@pytest.mark.parametrize("name", first_of(["cuspidal_3r", "rrprrr", "puma560"]))
def test_the_same_solutions_as_a_closed_form(name: str) -> None:
    arm, closed = kernel(name), in_c(name)
    chain = arm.arm.chain
    ranges = [j.limits or (-2.5, 2.5) for j in chain.joints]
    random = np.random.default_rng(2)
    for _ in range(4):
        q = np.array([random.uniform(*pair) for pair in ranges])
        T = arm.arm.pose(q)
        rows, status = closed.ik(T, np.zeros(chain.dof))
        wanted = rows[status != 1]
        found = solve(T, np.zeros(chain.dof), arm).q
        apart = found[:, None] - wanted
        turned = np.remainder(apart + np.pi, 2 * np.pi) - np.pi
        gaps = np.abs(np.where(arm.turns, turned, apart)).max(axis=-1)
        assert gaps.min(axis=0).max() < 1e-6
        assert gaps.min(axis=1).max() < 1e-6


@pytest.mark.parametrize("q5", [0.0, 1e-12])
def test_a_straight_wrist_follows_the_seed(q5: float) -> None:
    arm = kernel("puma560")
    q = np.array([0.4, -0.7, 0.5, 0.9, q5, -0.3])
    T = arm.arm.pose(q)
    here, elsewhere = (solve(T, seed, arm) for seed in (q, np.zeros(6)))
    for found in (here, elsewhere):
        assert found.chosen.any()
        np.testing.assert_allclose(
            arm.arm.pose(found.q), np.tile(T, (len(found.q), 1, 1)), atol=1e-9
        )
    assert np.abs(here.q - q).max(axis=1).min() < 1e-6


def test_a_stretched_arm_is_one_solution() -> None:
    arm = kernel("scara_rrp")
    T = arm.arm.pose(np.array([0.7, 0.0, -0.1]))
    found = solve(T, np.zeros(3), arm)
    assert len(found.q) == 1
    assert not found.chosen.any()


def test_starts_fill_the_circle() -> None:
    (golden,) = strides(1)
    assert golden == pytest.approx((5**0.5 - 1) / 2)
    for dimension in (2, 6, 8):
        powers = strides(dimension)
        assert powers[0] ** (dimension + 1) + powers[0] ** dimension == pytest.approx(1.0)

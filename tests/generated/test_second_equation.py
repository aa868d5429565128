"""Arms with fewer joints than their task: where the first equation of an angle says nothing."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.generated.asking import trial
from tests.generated.solvers import given, library, module

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.arrays import FloatArray

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files


ON_AXIS_1 = ["katana_400", "kuka_youbot", "scorbot_pointing", "xarm5"]
BESIDE = [0.0, 1e-12, 1e-6]
RESIDUAL = 1e-13


def zero_of(function: Callable[[float], float]) -> float | None:
    """Where a function of an angle changes its sign, by halving."""
    ways = [float(angle) for angle in np.linspace(-3.0, 3.0, 60)]
    ends = next(
        (pair for pair in pairwise(ways) if function(pair[0]) * function(pair[1]) < 0.0), None
    )
    if ends is None:
        return None
    low, high = ends
    start = function(low)
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if function(middle) * start > 0.0 else (low, middle)
    return low


def over_the_shoulder(name: str, q: FloatArray, beside: float) -> FloatArray | None:
    """The same with joint 2 turned until the tool's origin is that far from axis 1."""
    side = np.array([-np.sin(q[0]), np.cos(q[0]), 0.0])

    def turned(angle: float) -> FloatArray:
        return np.array([q[0], angle, *q[2:]])

    def far(angle: float) -> float:
        return float(library(name).jacobian(turned(angle))[:3, 0] @ side - beside)

    angle = zero_of(far)
    return None if angle is None else turned(angle)


def assert_found(name: str, q: FloatArray) -> None:
    """Without a seed the joint values are there, and every row is right."""
    asked = trial(name)
    pose = asked.poses(q[None])[0]
    found, _ = library(name).ik(pose, np.zeros(len(q)), *given(name, q))
    rows = found[np.isfinite(found).all(axis=1)]
    assert len(rows), q
    assert asked.residuals(rows, pose).max() < RESIDUAL
    assert asked.apart(rows, q).min() < 1e-6


@pytest.mark.parametrize("beside", BESIDE)
@pytest.mark.parametrize("name", ON_AXIS_1)
def test_the_lean_of_the_tool_gives_joint_1(name: str, beside: float) -> None:
    random = np.random.default_rng(3)
    tried = [random.uniform(-2.0, 2.0, module(name).DOF) for _ in range(8)]
    found = [q for q in (over_the_shoulder(name, q, beside) for q in tried) if q is not None]
    assert len(found) > 3
    for q in found:
        assert_found(name, q)


@pytest.mark.parametrize("beside", BESIDE)
def test_the_moment_of_an_axis_gives_joint_1(beside: float) -> None:
    random = np.random.default_rng(4)
    for _ in range(8):
        q = random.uniform(0.3, 2.0, 5)
        q[2] = beside
        assert_found("bartell_rprpr", q)

"""Steps from joint values end at a solution, also where several of them meet."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.numerical.descent import descended, escaped
from dhgen.numerical.kernel import NumericalKernel, numerical_kernel
from dhgen.robot.load import load
from dhgen.tolerances import TOLERANCES
from tests.targets.made import robot_path

UPRIGHT = np.array([0.7, -0.7, np.pi, np.pi / 2, 0.0, 0.0, -np.pi / 2])


@pytest.fixture(scope="module")
def trolley() -> NumericalKernel:
    return numerical_kernel(build_chain(load(robot_path("trolley"))), redundant=False)


def test_steps_lead_to_where_four_solutions_meet(trolley: NumericalKernel) -> None:
    """Some get slow far from there, at joint values that are singular."""
    T, slow = trolley.arm.pose(UPRIGHT), 0
    for signs in product([1.0, -1.0], repeat=3):
        start = UPRIGHT + 0.05 * np.array([0.0, 1.0, signs[0], signs[1], 0.6, signs[2], 0.8])
        slow += descended(trolley, T, start, TOLERANCES.exact).miss > 1e-9
        assert escaped(trolley, T, start, TOLERANCES.exact).miss < TOLERANCES.promised
    assert slow


def test_steps_to_one_solution_need_no_escape(trolley: NumericalKernel) -> None:
    q = np.array([0.7, -0.7, 0.3, 0.5, 0.4, -0.6, 0.2])
    T, start = trolley.arm.pose(q), q + np.array([0.0, *np.full(6, 0.05)])
    ends = [steps(trolley, T, start, TOLERANCES.exact) for steps in (descended, escaped)]
    assert (ends[0].q == ends[1].q).all()
    assert np.abs(ends[0].q - q).max() < 1e-9


def test_what_is_out_of_reach_stays_so(trolley: NumericalKernel) -> None:
    T = trolley.arm.pose(UPRIGHT)
    T[2, 3] -= 1e-3
    end = escaped(trolley, T, UPRIGHT + 0.01, TOLERANCES.exact)
    assert end.miss > 1e-4

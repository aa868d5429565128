"""Poses so far out that squares, or squares of squares, of their lengths overflow."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from dhgen.status import HELD, Status
from tests.generated.solvers import NAMES, given, library, robot
from tests.structures import one_of_each
from tests.targets.made import made_up, solving

LANGUAGES = ("C", "Python")
LARGEST = sys.float_info.max
FAR = (1e76, 1e80, 1e100, 1e110, 1e150, 1e153, 1e154, 1e155, 1e160, 1e200, 1e307, LARGEST, np.inf)
# A crank and a rod with a hinge between: the arm of one leg of a parallel robot.
LEG = (
    "theta: q, a: 0.524, limits: [-60 deg, 90 deg]",
    "theta: q, alpha: 90 deg",
    "theta: q, a: 1.244, limits: [-60 deg, 60 deg]",
)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_crank_and_a_rod_reach_nothing_that_far_out(language: str) -> None:
    """Rows were OUT_OF_LIMITS with NaN, or with values, in them: minus infinity was in reach."""
    solve = solving(made_up("crank_and_rod", LEG, "task: position\n"), language)
    seed = [np.zeros(3)]
    for far in FAR:
        for axis in range(3):
            for side in (far, -far):
                T = np.eye(4)
                T[:3, 3] = 0.2, 0.1, 0.1
                T[axis, 3] = side
                with np.errstate(all="ignore"):
                    rows, status = solve(T, *seed)
                wanted = Status.UNREACHABLE if np.isfinite(far) else Status.INVALID_POSE
                assert (status == wanted).all()
                assert np.isnan(rows).all()


@pytest.mark.parametrize("name", one_of_each(NAMES))
def test_no_row_holds_nan_that_far_out(name: str) -> None:
    """Only slides follow such poses, and those only where squares of lengths are finite."""
    values = [np.full(len(each), 0.3) for each in given(name, np.zeros(len(robot(name).joints)))]
    turning = not any(joint.kind.name == "PRISMATIC" for joint in robot(name).joints)
    zeros = np.zeros(len(robot(name).joints))
    for far in FAR:
        T = np.eye(4)
        T[:3, 3] = -0.3 * far, 0.7 * far, 0.8 * far
        rows, status = library(name).ik(T, zeros, *values)
        held = np.isin(status, HELD)
        assert np.isfinite(rows[held]).all()
        assert not (turning and held.any())
        _, statuses = library(name).batch(
            np.repeat(T[None], 9, axis=0), *(np.repeat(value[None], 9, axis=0) for value in values)
        )
        assert (statuses == status).all()

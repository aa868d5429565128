"""Three pairs of parallel axes: the equations of type 9 there are rotations that are known already.

Axes 1 and 2, 3 and 4, 5 and 6 are parallel. With theta12, theta34 and theta56 known, every equation
of the orientation holds for all theta3 and theta5: its polynomial is 0 = 0, and what rounding
leaves of it is no equation.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.compiling import library
from tests.oracle.sets import all_solutions
from tests.targets.calling import gap
from tests.targets.made import folder, made_up

if TYPE_CHECKING:
    from dhgen.compiler import Compilation
    from dhgen.verify.native import CompiledSolver

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

JOINTS = (
    "theta: q, d: 0.2, a: 0.2, alpha: 0",
    "theta: q, d: 0, a: 0, alpha: -pi/2",
    "theta: q, d: 0, a: 0.2, alpha: 0",
    "theta: q, d: 0, a: 0, alpha: pi/2",
    "theta: q, d: 0, a: -0.3, alpha: pi",
    "theta: q, d: 0, a: 0, alpha: -pi/2",
)


@cache
def compiled() -> Compilation:
    return made_up("pairs", JOINTS, "")


@cache
def in_c() -> CompiledSolver:
    return library(compiled().module, folder())


def test_no_step_is_made_of_nothing() -> None:
    assert compiled().module.method == "general 6R"


@pytest.mark.parametrize("theta34", [1.3, 0.003])  # at 0 the arm is singular
def test_all_solutions(theta34: float) -> None:
    q = np.array([0.74, 2.36, 0.87, theta34 - 0.87, -2.51, 2.22])
    T = np.asarray(forward(compiled().robot, q), dtype=float)
    expected = all_solutions(compiled().robot, T)
    rows, _ = in_c().ik(T, np.zeros(6))
    found = rows[np.isfinite(rows).all(axis=1)]
    assert len(found) == len(expected) == 8
    np.testing.assert_allclose(forward(compiled().robot, found), [T] * 8, atol=1e-9)
    assert gap(found[:, None], expected).min(axis=0).max() < 1e-6

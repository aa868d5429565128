"""Link lengths that are negative: a constant determinant of an over-determined arm is, too.

The sign of what an angle's sine and cosine share is no positive factor that may be left out.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from dhgen.verify.native import NATIVE, PORTABLE, Build
from tests.compiling import library
from tests.structures import first_of
from tests.targets.calling import gap
from tests.targets.made import folder, made_up

if TYPE_CHECKING:
    from dhgen.compiler import Compilation

LENGTHS = [(0.2, -0.1), (-0.2, 0.1), (-0.2, -0.1), (0.2, 0.1)]


@cache
def compiled(a2: float, a3: float) -> Compilation:
    joints = (
        "theta: q, d: 0.1, a: -0.1, alpha: -pi/2",
        f"theta: q, d: 0, a: {a2}, alpha: 0",
        f"theta: q, d: 0, a: {a3}, alpha: -pi/2",
        "theta: q, d: 0, a: 0, alpha: -pi/2",
    )
    name = f"lengths{LENGTHS.index((a2, a3))}"
    return made_up(name, joints, "tool: {xyz: [0.2, 0, 0.13]}\n", convention="modified")


@pytest.mark.parametrize(
    ("a2", "a3", "build"),
    first_of([(*LENGTHS[2], NATIVE), *((*each, PORTABLE) for each in LENGTHS)], count=2),
)
def test_rows_reach_the_pose(a2: float, a3: float, build: Build) -> None:
    robot = compiled(a2, a3).robot
    solver = library(compiled(a2, a3).module, folder(), build)
    for q in np.random.default_rng(4).uniform(-3.0, 3.0, (20, 4)):
        T = np.asarray(forward(robot, q), dtype=float)
        rows, _ = solver.ik(T, np.zeros(4))
        found = rows[np.isfinite(rows).all(axis=1)]
        np.testing.assert_allclose(forward(robot, found), [T] * len(found), atol=1e-11)
        assert gap(found, q).min() < 1e-9

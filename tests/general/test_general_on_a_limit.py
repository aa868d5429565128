"""A joint on its limit where a general arm is nearly singular.

Axes 2 and 3 of the arm are 2.6e-6 rad from parallel. Twists within 1e-10 of right angles are taken
as such, which moves the model by 1e-11: beside a singular pose a joint on its limit comes out 1e-7
beyond, and the pose is missed by 1e-11 if it is clamped.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from dhgen.robot.load import load
from dhgen.survey.oracle.forward import forward
from tests.compiling import library, written
from tests.targets.calling import FREE_JOINT, OK

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

ARM = Path(__file__).with_name("near_parallel.yaml")
RIGHT = np.pi / 2
REPORTED = (0.0, 0.0, RIGHT, -RIGHT, -RIGHT, RIGHT)


def on_limits(count: int) -> FloatArray:
    """Joint values inside the limits: joint 4 on one or at a right angle, joint 5 at one."""
    source = np.random.default_rng(3)
    limits = np.array([joint.limits for joint in load(ARM).joints], np.float64)
    q = source.uniform(limits[:, 0], limits[:, 1], (count, 6))
    q[:, 3] = source.choice([*limits[3], RIGHT, -RIGHT], count)
    q[:, 4] = source.choice([RIGHT, -RIGHT], count)
    return q


def test_a_row_is_inside_the_limits(tmp_path: Path) -> None:
    """By the file's own numbers the joint values that made the pose are."""
    compilation, robot = written(ARM, tmp_path), load(ARM)
    solver = library(compilation.module, tmp_path)
    for q in (np.array(REPORTED), *on_limits(100)):
        T = np.array(forward(robot, q))
        rows, status = solver.ik(T, q)
        inside = np.isin(status, (OK, FREE_JOINT))
        assert inside.any(), q
        np.testing.assert_allclose(forward(robot, rows[inside]) - T, 0.0, atol=2e-10)

"""The order of a general arm's rows where solutions meet and joints are half a turn from zero.

Such angles are known to 1e-8, and whether one reads pi or -pi rounding says, which differs between
languages and machines: it must not say in which row a solution stands.
"""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.targets.calling import gap
from tests.targets.made import made_up, solving

# The instrument of a patient side manipulator, through a fixed point (IKBT, issue 26).
NAME = "through_a_point"
ROWS = (
    "theta: q, d: 0, a: 0, alpha: -pi/2",
    "theta: q, d: 0, a: 0, alpha: -pi/2",
    "theta: 0, d: q, a: 0, alpha: 0",
    "theta: q, d: 0, a: 0, alpha: pi/2",
    "theta: q, d: 0, a: 0.0091, alpha: -pi/2",
    "theta: q, d: 0, a: 0, alpha: -pi/2",
)
QUARTER = np.pi / 2
PLACES = (
    (np.pi, QUARTER, 0.01429425, 0.0, QUARTER, -QUARTER),
    (0.0, np.pi, 0.02858849, np.pi, -QUARTER, QUARTER),
    (0.0, QUARTER, -0.01429425, 0.0, QUARTER, 0.0),
)
NEAR = 1e-6  # what is known of an angle where two solutions meet [rad]


@pytest.mark.parametrize("joints", PLACES)
def test_rows_are_the_same_in_c_and_python(joints: tuple[float, ...]) -> None:
    compiled = made_up(NAME, ROWS, "", "modified")
    pose = np.asarray(forward(compiled.robot, np.array([joints])), dtype=float)[0]
    seed = np.random.default_rng(1).uniform(-np.pi, np.pi, 6)
    in_c, in_python = (solving(compiled, language)(pose, seed) for language in ("C", "Python"))
    np.testing.assert_array_equal(in_c[1], in_python[1])
    found = np.isfinite(in_c[0]).all(axis=1)
    assert found.sum() > 2
    assert gap(in_c[0][found], in_python[0][found]).max() < NEAR
    # where angles differ by more than rounding they ascend, -pi standing for pi
    first = np.where(in_c[0][found, 0] < NEAR - np.pi, np.pi, in_c[0][found, 0])
    assert (np.diff(first) > -NEAR).all()

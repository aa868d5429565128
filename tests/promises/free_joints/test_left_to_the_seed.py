"""Values that callers leave to the seed: it has them, or they are the nearest that lead there."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.targets.made import given, in_python, made_up, poses_of, without_numba

ARM_ANGLE = "kuka_iiwa14_arm_angle"
# Two links of which the first may not turn far, on a rail that the caller may choose.
ROWS = (
    "d: q, theta: 0, a: 0, alpha: -90 deg, limits: [0, 2]",
    "theta: q, d: 0, a: 0.5, alpha: 0, limits: [-180 deg, 180 deg]",
    "theta: q, d: 0, a: 0.4, alpha: 0, limits: [-180 deg, 180 deg]",
)


@pytest.mark.parametrize("name", ["franka_panda", ARM_ANGLE])
def test_the_seed_gives_what_the_caller_does_not(name: str) -> None:
    q = np.array([0.4, -0.5, 0.3, -1.8, 0.2, 1.6, 0.7])
    T, values, robot = poses_of(name, q[None])[0], given(name, q), in_python(name)
    rows, status = robot.ik_all(T, None, q)
    expected, kinds = robot.ik_all(T, *values, q)
    np.testing.assert_array_equal(status, kinds)
    np.testing.assert_allclose(rows, expected, rtol=0, atol=1e-12)
    np.testing.assert_allclose(robot.ik(T, q_seed=q), q, rtol=0, atol=1e-8)


def test_without_a_seed_there_is_nothing_to_take_it_from() -> None:
    robot = in_python("franka_panda")
    for call in (robot.ik, robot.ik_all):
        with pytest.raises(TypeError, match="q_free is missing, and there is no q_seed"):
            call(np.eye(4))


TURNING = (
    "theta: q, d: 0, a: 1, alpha: 0, limits: [-170 deg, 170 deg]",
    "theta: q, d: 0, a: 0.5, alpha: 0",
    "theta: q, d: 0, a: 0.4, alpha: 0",
)


def rail() -> object:
    """A rail along z, and two links in a plane that holds it; the caller gives where they start."""
    made = made_up("rail_left_to_the_seed", ROWS, "task: [x, z]\nfree: [1]\n")
    return without_numba(made.files["rail_left_to_the_seed.py"], "rail_left_to_the_seed")


def test_the_nearest_value_that_reaches() -> None:
    """Links of 0.5 and 0.4: the point 1.5 above the carriage is reached from 0.9 below it."""
    robot: object = rail()
    T = np.eye(4)
    T[2, 3] = 1.5
    q = robot.ik(T, q_seed=[0.1, 0.2, 0.3])  # type: ignore[attr-defined]
    assert q[0] == pytest.approx(1.5 - 0.9, abs=1e-6)
    with pytest.raises(robot.Unreachable):  # type: ignore[attr-defined]
        robot.ik(T, [0.1], [0.1, 0.2, 0.3])  # type: ignore[attr-defined]
    T[2, 3] = 3.0  # farther than the rail's end and both links
    with pytest.raises(robot.Unreachable):  # type: ignore[attr-defined]
        robot.ik(T, q_seed=[0.1, 0.2, 0.3])  # type: ignore[attr-defined]


def test_the_nearest_value_is_not_taken_across_the_limits() -> None:
    """Links of 0.5 and 0.4 behind one of 1: within 15 degrees of the target, by cosines.

    From 100 degrees the near end is -135. By way of 180, which the limits forbid, it is -165.
    """
    made = made_up("arm_left_to_the_seed", TURNING, "task: [x, y]\nfree: [1]\n")
    robot: Any = without_numba(made.files["arm_left_to_the_seed.py"], "arm_left_to_the_seed")
    far = np.cos(np.radians(15.0)) + np.sqrt(0.9**2 - np.sin(np.radians(15.0)) ** 2)
    T = np.eye(4)
    T[:2, 3] = far * np.cos(np.radians(-150.0)), far * np.sin(np.radians(-150.0))
    seed = np.radians([100.0, 20.0, 30.0])
    assert np.degrees(robot.ik(T, q_seed=seed)[0]) == pytest.approx(-135.0, abs=1e-4)
    around = np.degrees(robot.ik(T, q_seed=seed, limits=False)[0])
    assert np.cos(np.radians(around + 165.0)) == pytest.approx(1.0, abs=1e-9)

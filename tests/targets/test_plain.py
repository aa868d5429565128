"""Without the fast path for regular poses: shorter files, the same answers."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.oracle.poses import random_joints, right_angles
from dhgen.status import HELD
from dhgen.verify.native import Build
from tests.compiling import library
from tests.oracle.sets import out_of_reach
from tests.targets.made import apart, folder, given, in_c, made_up, poses_of, robot

ARMS = ["cartesian", "franka_panda", "kuka_kr6_r900", "scara", "scorbot_pointing", "ur5"]
ZERO = np.zeros(2)
PLANAR = ["theta: q, a: 0.4, limits: [-2, 2]", "theta: q, a: 0.3, limits: [-2.5, 2.5]"]
RANDOM = 200


@pytest.mark.parametrize("name", ARMS)
def test_it_gives_the_same_answers(name: str) -> None:
    """Singular poses get the very same, as they go through the same code."""
    arm, dof = robot(name), len(robot(name).joints)
    q = np.concatenate([random_joints(arm, RANDOM), right_angles(arm, 100)])
    T = np.concatenate([poses_of(name, q), out_of_reach(arm, 20)])
    q = np.concatenate([q, np.zeros((len(T) - len(q), dof))])
    plain = in_c(name, Build("plain", ("-O0", f"-D{name.upper()}_PLAIN")))
    seeds = np.random.default_rng(5).uniform(-2.0, 2.0, q.shape)
    same = 0
    for k, (pose, seed) in enumerate(zip(T, seeds, strict=True)):
        free = [values[k] for values in given(name, q)]
        rows, status = plain.ik(pose, seed, *free)
        others, expected = in_c(name).ik(pose, seed, *free)
        assert (status == expected).all(), k
        held = np.isin(status, HELD)
        assert apart(name, rows[held], others[held]).max(initial=0.0) < 1e-9
        same += np.array_equal(rows, others, equal_nan=True)
    assert same > len(T) // 20
    many, statuses = plain.batch(T, *given(name, q))
    first, expected = plain.ik(T[0], np.zeros(dof), *(values[0] for values in given(name, q)))
    np.testing.assert_array_equal(many[0], first)
    np.testing.assert_array_equal(statuses[0], expected)


def test_a_robot_file_may_ask_for_it() -> None:
    """The C is what is left with the switch: the same answers to the last bit."""
    whole = made_up("planar_fast", PLANAR, "task: [x, y]\n")
    plain = made_up("planar_plain", PLANAR, "task: [x, y]\nplain: true\n")
    text = plain.files["planar_plain.c"]
    assert "solve_wide" not in text
    assert "_PLAIN" not in text
    assert len(text) < 0.7 * len(whole.files["planar_fast.c"])
    assert "_in_tiles" not in plain.files["planar_plain.py"]
    asked = library(plain.module, folder())
    switched = library(whole.module, folder(), Build("plain", ("-O0", "-DPLANAR_FAST_PLAIN")))
    for k in range(50):
        pose = np.eye(4)
        pose[:2, 3] = np.random.default_rng(k).uniform(-0.7, 0.7, 2)
        for ours, theirs in zip(asked.ik(pose, ZERO), switched.ik(pose, ZERO), strict=True):
            np.testing.assert_array_equal(ours, theirs)

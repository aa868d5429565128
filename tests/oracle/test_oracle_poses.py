"""The sets of joint vectors hold what their names say, and are the same on every run."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.oracle.arm import arm, arm_size
from dhgen.oracle.poses import boundary, right_angles
from dhgen.robot.robot import JointKind
from tests.oracle.sets import joint_sets, out_of_form, out_of_reach
from tests.robots.cases import NAMES, robot


@pytest.mark.parametrize("name", NAMES)
def test_sets_are_finite_and_repeatable(name: str) -> None:
    first, second = (joint_sets(robot(name), count=3) for _ in range(2))
    for key, q in first.items():
        np.testing.assert_array_equal(q, second[key])
        assert q.shape[1] == len(robot(name).joints)
        assert np.isfinite(q).all()


@pytest.mark.parametrize("name", NAMES)
def test_slides_stay_within_their_stroke(name: str) -> None:
    strokes = [
        joint.limits if joint.kind is JointKind.PRISMATIC else None for joint in robot(name).joints
    ]
    for q in joint_sets(robot(name), count=3).values():
        for stroke, values in zip(strokes, q.T, strict=True):
            low, high = stroke or (-np.inf, np.inf)
            assert ((low <= values) & (values <= high)).all()


def test_right_angles_are_all_combinations_or_a_sample() -> None:
    assert len(np.unique(right_angles(robot("planar_rrr")), axis=0)) == 4**3
    assert right_angles(robot("puma560")).shape == (500, 6)
    assert len(np.unique(right_angles(robot("puma560")), axis=0)) > 400


def test_boundary_touches_every_limit() -> None:
    limits = [joint.limits for joint in robot("scara").joints]
    q = boundary(robot("scara"), 5)
    assert len(q) == 8 * 5
    for values, pair in zip(q.T, limits, strict=True):
        assert pair == (values.min(), values.max())
    assert boundary(robot("planar_rr"), 5).shape == (0, 2)


@pytest.mark.parametrize("name", NAMES)
def test_far_poses_are_far_and_rigid(name: str) -> None:
    far, turned = out_of_reach(robot(name), 4), out_of_form(robot(name), 4)
    distance = np.linalg.norm(far[:, :3, 3] - arm(robot(name)).before[0, :3, 3], axis=1)
    np.testing.assert_allclose(distance, 10 * arm_size(robot(name)))
    for T in [*far, *turned]:
        np.testing.assert_allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3), atol=1e-12)
        assert np.linalg.det(T[:3, :3]) > 0
    assert far.size > 0 or name.startswith("wrist")

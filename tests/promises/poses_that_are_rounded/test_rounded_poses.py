"""Rounded poses of arms that are asked for more than they can choose: equations lose digits.

Where the tool is near axis 1, beside which the arm stands, the equation of joint 1 makes a
thousand times of what a pose is rounded by, although the whole pose fixes the joints well.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import jacobian
from tests.structures import first_of
from tests.targets.calling import HELD, LANGUAGES, UNREACHABLE, Solver, gap
from tests.targets.made import made, model, poses_of, robot

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

ARMS = ("five_joints_offset", "so101_pose")
DIGITS = {"six digits": 6, "single precision": None}


def size(name: str) -> float:
    """The sum of the lengths in the arm's table."""
    return made(name).module.chain.size


def weighted_jacobian(name: str, q: FloatArray) -> FloatArray:
    """Lengths count in arm sizes, (..., 6, n)."""
    J = np.array(jacobian(model(name), q))
    J[..., :3, :] /= size(name)
    return J


def regular(name: str, count: int, least: float) -> FloatArray:
    """Joint values inside the limits whose Jacobian has no singular value below the least."""
    limits = np.array([joint.limits for joint in robot(name).joints], np.float64)
    source = np.random.default_rng(7)
    tried = source.uniform(limits[:, 0], limits[:, 1], (2 * count, len(limits)))
    least_of_each = np.linalg.svd(weighted_jacobian(name, tried), compute_uv=False)[:, -1]
    return np.asarray(tried[least_of_each > least][:count])


@pytest.mark.parametrize("name", first_of(ARMS))
@pytest.mark.parametrize("digits", DIGITS.values(), ids=DIGITS)
def test_own_values_are_found(name: str, digits: int | None) -> None:
    """As far off at most as the pose is rounded, over the smallest singular value."""
    solver, lost = Solver(name, "C"), []
    for q in regular(name, 400, 0.05):
        T = poses_of(name, q)
        T = T.astype(np.float32).astype(float) if digits is None else np.round(T, digits)
        rows, status = solver.all(T)
        if not np.any((gap(rows, q) < 1e-3) & np.isin(status, HELD)):
            lost.append(q)
    assert lost == []


# Joint values beside which what stands below a root is nearly zero: at the rounded pose it is less.
BELOW_ZERO = {
    "nested_roots": (
        (-1.89527407, -1.57119684, 2.30145563, -0.50056531, 0.87178582),
        (-2.36671737, -1.57083241, -0.57573364, 0.70572943, -0.89386927),
        (2.12554774, 1.57017666, -2.87171996, 2.38940138, -1.68018053),
    ),
    "close_quartic": (
        (-0.33418408, -0.80516148, -0.14404827, -2.33972823, -1.74354078),
        (-0.96021114, -2.6206999, -1.19498849, -2.08756874, 1.44317899),
        (2.73346359, -2.49277477, -2.61412548, 1.27600831, 0.73283393),
    ),
}


@pytest.mark.breadth
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", BELOW_ZERO)
def test_rounding_below_a_root_loses_no_solution(name: str, language: str) -> None:
    """As far off at most as the pose is rounded, over the smallest singular value."""
    for values in BELOW_ZERO[name]:
        q = np.array(values)
        assert np.linalg.svd(weighted_jacobian(name, q), compute_uv=False)[-1] > 0.01
        T = np.round(poses_of(name, q), 6)
        rows, status = Solver(name, language).all(T)
        assert np.any((gap(rows, q) < 1e-3) & np.isin(status, HELD)), q


@pytest.mark.breadth
@pytest.mark.parametrize("language", LANGUAGES)
def test_a_reported_pose(language: str) -> None:
    """Its smallest singular value is 0.1, and a solution misses it by 1e-6."""
    T = np.array(
        [
            [-0.323143, 0.502921, 0.801654, -0.070102],
            [0.608425, 0.759232, -0.231054, -0.148824],
            [-0.724843, 0.413083, -0.55133, 0.302888],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )
    for x in (0.0, 3e-7, -3e-7, 1e-6):
        moved = T.copy()
        moved[0, 3] += x
        rows, status = Solver("so101_pose", language).all(moved)
        held = np.isin(status, HELD)
        assert held.any()
        reached = poses_of("so101_pose", rows[held])
        assert np.abs(reached[:, :3] - moved[:3]).max() < 1e-5


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", first_of(ARMS))
def test_rows_miss_a_rounded_pose_by_no_more_than_it_may_be_rounded_by(
    name: str, language: str
) -> None:
    solver = Solver(name, language)
    for q in regular(name, 20, 0.1):
        T = np.round(poses_of(name, q), 6)
        rows, status = solver.all(T)
        reached = poses_of(name, rows[np.isin(status, HELD)])
        off = np.abs(reached - T)
        off[:, :3, 3] /= size(name)
        assert off.max() < 1e-5 + 1e-6  # the pose's own rotation is not quite one


@pytest.mark.parametrize("name", first_of(ARMS))
def test_what_is_farther_off_than_rounding_is_out_of_reach(name: str) -> None:
    """A pose that is a thousandth aside in the one direction of six that no joint moves in."""
    solver = Solver(name, "C")
    for q in regular(name, 100, 0.1):
        left = np.linalg.svd(weighted_jacobian(name, q))[0][:, -1]
        T = poses_of(name, q)
        T[:3, 3] += 1e-3 * size(name) * left[:3]
        cross = np.array([np.cross(1e-3 * left[3:], column) for column in T[:3, :3].T]).T
        u, _, v = np.linalg.svd(T[:3, :3] + cross)
        T[:3, :3] = u @ v
        _, status = solver.all(T)
        assert np.all(status == UNREACHABLE)

"""Arms with joints that are given, and with a slide: at every place, all solutions."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.general.arm import general_kernel, loop_constants
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.method import Method
from dhgen.paul.derive import derive
from dhgen.robot.load import load
from tests.general.solved import is_complete, solve, tried
from tests.robots.cases import robot

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

HEAD = "name: arm\nconvention: standard\ntask: pose\n"
SKEW = (
    "{theta: q + 0.7, d: 0.31, a: 0.2, alpha: 80 deg}",
    "{theta: q, d: 0.1, a: 0.4, alpha: 25 deg}",
    "{theta: -q, d: -0.17, a: 0.15, alpha: 70 deg}",
    "{theta: q, d: 0.2, a: 0.1, alpha: 95 deg}",
    "{theta: 1.1 - q, d: 0.15, a: 0.05, alpha: 50 deg}",
    "{theta: q + 0.2, d: 0.1, a: 0.12, alpha: 40 deg}",
    "{theta: q, d: 0.1, a: 0.02, alpha: 90 deg}",
)
SLIDE = "{theta: 0.3, d: 0.1 - q, a: 0.15, alpha: 70 deg}"
VEHICLE = (
    "{theta: pi/2, d: q, alpha: pi/2}",
    "{theta: pi/2, d: q, alpha: pi/2}",
    "{theta: q, d: 0.3, a: 0.1}",
    "{d: q, a: 0.1, alpha: -pi/2}",
    "{theta: q, d: 0.2, a: 0.1, alpha: pi/2}",
)
OFFSET_WRIST = (
    "{theta: q, d: 0.4, a: 0.15, alpha: -pi/2}",
    "{theta: q, a: 0.5}",
    "{theta: q, a: 0.1, alpha: -pi/2}",
    "{theta: q, d: 0.5, alpha: pi/2}",
    "{theta: q, d: 0.12, alpha: -pi/2}",
    "{theta: q, d: 0.1}",
)
POSES = 4


def chain(folder: Path, rows: tuple[str, ...], free: list[int]) -> Chain:
    text = HEAD + "joints:\n" + "".join(f"  - {row}\n" for row in rows) + f"free: {free}\n"
    path = folder / "arm.yaml"
    path.write_text(text, encoding="utf-8")
    return build_chain(load(path))


@cache
def known(arm: Chain) -> GeneralKernel:
    kernel = general_kernel(arm)
    assert kernel is not None
    return kernel


def joint_values(
    arm: Chain, kernel: GeneralKernel, q: np.ndarray, angles: np.ndarray
) -> np.ndarray:
    """Joint values (k, n) of solutions (k, 6), with what is given as in q."""
    every = np.tile(q, (len(angles), 1))
    for place, number in enumerate(kernel.numbers):
        joint = arm.joints[number - 1]
        every[:, number - 1] = joint.sign * (angles[:, place] - joint.offset)
    return every


def check(arm: Chain, seed: int) -> None:
    """All rows reach their pose, they are even, and the joints that it came from are among them."""
    kernel, forward = known(arm), numeric_arm(arm)
    for q in np.random.default_rng(seed).uniform(-1.5, 1.5, (POSES, arm.dof)):
        T = forward.pose(q)
        found = solve(T, kernel, [q[number - 1] for number in arm.free])
        rows = joint_values(arm, kernel, q, found.q)
        assert found.certain
        assert len(rows) % 2 == 0
        np.testing.assert_allclose(forward.pose(rows) - T, 0.0, atol=1e-9)
        turns = np.remainder(rows - q + np.pi, 2 * np.pi) - np.pi
        assert np.abs(turns).max(axis=1).min() < 1e-6


@pytest.mark.parametrize("place", [1, 4, 7])
def test_a_joint_given(tmp_path: Path, place: int) -> None:
    check(chain(tmp_path, SKEW, [place]), place)


@pytest.mark.parametrize("place", [1, 4, 7])
def test_a_slide_given(tmp_path: Path, place: int) -> None:
    rows = (*SKEW[: place - 1], SLIDE, *SKEW[place - 1 : 6])
    check(chain(tmp_path, rows, [place]), place)


def test_two_joints_given(tmp_path: Path) -> None:
    check(chain(tmp_path, (SLIDE, *SKEW), [1, 5]), 8)
    check(chain(tmp_path, (*SKEW[:2], SLIDE, *SKEW[2:]), [3, 4]), 9)


@pytest.mark.parametrize("place", range(1, 7))
def test_a_slide_to_be_solved_for(tmp_path: Path, place: int) -> None:
    check(chain(tmp_path, (*SKEW[: place - 1], SLIDE, *SKEW[place - 1 : 5]), []), place)


def test_every_formulation_finds_the_same(tmp_path: Path) -> None:
    arm = chain(tmp_path, (*SKEW[:2], SLIDE, *SKEW[2:5]), [])
    kernel = known(arm)
    _, second = kernel.formulations
    other = replace(kernel, formulations=(second,))
    for q in np.random.default_rng(10).uniform(-1.5, 1.5, (POSES, 6)):
        T = numeric_arm(arm).pose(q)
        np.testing.assert_allclose(solve(T, kernel).q, solve(T, other).q, atol=1e-8)


def test_links_with_joints_inside(tmp_path: Path) -> None:
    arm = chain(tmp_path, (*SKEW[:2], SLIDE, *SKEW[2:]), [3, 4])
    kernel, forward = known(arm), numeric_arm(arm)
    assert kernel.numbers == (1, 2, 5, 6, 7, 8)
    held = kernel.held([0.3, -0.4])
    q = np.array([0.0, 0.0, 0.3, -0.4, 0.0, 0.0, 0.0, 0.0])
    moves = [element if isinstance(element, int) else 0 for element in forward.elements]
    T, steps = np.eye(4), forward.steps(q)
    for element in forward.elements[moves.index(2) + 1 : moves.index(5)]:
        T = T @ (steps[element - 1] if isinstance(element, int) else element)
    link = loop_constants(arm)[2]
    np.testing.assert_allclose(link.at(held), T, atol=1e-15)
    np.testing.assert_allclose(np.array(link.inverse().at(held)) @ T, np.eye(4), atol=1e-15)


def test_other_arms_are_left_alone(tmp_path: Path) -> None:
    assert general_kernel(chain(tmp_path, SKEW[:5], [1])) is None
    assert general_kernel(chain(tmp_path, (SLIDE, *SKEW[:3], SLIDE, SLIDE), [])) is None


@pytest.mark.parametrize("name", ["xarm7", "kinova_gen3_7"])
@pytest.mark.parametrize("value", [0.0, np.pi])
def test_more_structure_at_a_value_of_the_joint_that_is_given(name: str, value: float) -> None:
    """Joint 3 straight: axes 2 and 4 are parallel, and formulations vanish that serve elsewhere.

    Of the wrist of the second, which is nearly spherical, the determinant has crowds of complex
    roots beside the circle.
    """
    arm = build_chain(robot(name))
    kernel, forward = known(arm), numeric_arm(arm)
    certain = 0
    for q in np.random.default_rng(11).uniform(-np.pi, np.pi, (4, 7)):
        q[2] = value
        found = solve(forward.pose(q), kernel, [value])
        rows = joint_values(arm, kernel, q, found.q)
        turns = np.remainder(rows - q + np.pi, 2 * np.pi) - np.pi
        assert np.abs(turns).max(axis=1).min() < 1e-5
        certain += found.certain
    assert certain >= 3


@pytest.mark.breadth
def test_a_second_formulation_serves_where_the_first_ones_vanish() -> None:
    """Of 60 poses one is not certain by what serves best there, and took ten times longer."""
    arm = build_chain(robot("kinova_gen3_7"))
    kernel, forward = known(arm), numeric_arm(arm)
    joints = np.random.default_rng(12).uniform(-np.pi, np.pi, (60, 7))
    joints[:, 2] = 0.0
    assert all(is_complete(forward.pose(q), kernel, [0.0]) for q in joints)


def test_what_vanishes_at_a_given_value_is_not_tried_there() -> None:
    kernel = known(build_chain(robot("kinova_gen3_7")))
    for value in (0.0, np.pi, -np.pi, 2 * np.pi):
        assert 2 <= len(tried(kernel, [value])) < len(kernel.formulations)
    for value in (1e-3, 1.0, np.pi / 2):
        assert len(tried(kernel, [value])) == len(kernel.formulations)


TOLD_APART = [
    (1.760872814832662, -1.6267303380308349, 0.43226084575627988, 2.6786183744569394, -1.46, 0.58),
    (-0.22989949301346171, 1.3901414809702626, -0.98951075388561505, 1.83650654, 0.64945971, 0.9),
    (0.57463745720434845, -0.575768972176951, 0.61293048230601943, -1.40617728, 1.60269551, 2.97),
    (1.3319852605611018, -1.3868501001907747, 0.20961241457127633, 2.95376047, 1.97450756, -2.1),
]


@pytest.mark.parametrize("others", TOLD_APART)
def test_roots_that_another_formulation_tells_apart_are_simple(others: tuple[float, ...]) -> None:
    """Two solutions nearly share the angle that is hidden first; the arm is far from singular."""
    arm = build_chain(robot("kinova_gen3_7"))
    kernel, forward = known(arm), numeric_arm(arm)
    q = np.array([*others[:2], 0.0, *others[2:]])
    found = solve(forward.pose(q), kernel, [0.0])
    assert found.certain
    assert len(found.q) == 8


@pytest.mark.breadth
def test_an_arm_on_a_vehicle_with_a_lift_and_a_waist(tmp_path: Path) -> None:
    """Each given joint leaves another point standing still, for which there once was no name."""
    arm = chain(tmp_path, VEHICLE + OFFSET_WRIST, [1, 2, 3, 4, 5])
    assert derive(arm).method is Method.GENERAL_6R
    check(arm, 61)

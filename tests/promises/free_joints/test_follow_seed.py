"""Beside singular places an arm goes on with the solution that it is at.

Two singular places at once; an upright UR; and right angles written as 1.5708. The wrist of one of
these arms, whose links are equal, comes onto its shoulder where it is folded, and the twists miss
right angles by so little that rounding can't tell its solutions apart there. The polynomial of the
other one has roots that nearly meet at every pose.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from dhgen.program.interpret import interpret
from dhgen.verify.native import NATIVE, PORTABLE
from tests.compiling import library, written
from tests.targets.calling import HELD, LANGUAGES, Solver, gap
from tests.targets.made import ROBOTS, folder, without_numba
from tests.targets.made import poses_of as made_poses

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation
    from dhgen.verify.native import Build, CompiledSolver

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

FOLDING, TWINS = "staubli_tx40", "prismatic_2_wrist"
FOLDED = (
    (3.1, 1.5, np.pi, 0.4, 0.0, 3.0),
    (0.46, 0.87, np.pi, np.pi, 1.01, 0.83),
    (0.77, 3.07, -np.pi, -2.13, np.pi, np.pi),
    (-1.5, -np.pi / 2, np.pi, 0.34, 3.11, 1.84),
)
TWIN = (2.350395274456, 0.40229255, -2.3146260935, 2.1681659028, 2.7956918114, 2.5378840289)
EXACT = 1e-11
STEP = 0.02  # of a motion [rad]


@cache
def compiled(name: str) -> Compilation:
    text = (ROBOTS / f"{name}.yaml").read_text(encoding="utf-8")
    path = folder() / f"{name}_written.yaml"
    told = text.replace("alpha: pi/2", "alpha: 1.5708").replace("alpha: -pi/2", "alpha: -1.5708")
    assert told != text
    path.write_text(told.replace(f"name: {name}", f"name: {path.stem}"))
    return written(path, folder())


@cache
def in_c(name: str, build: Build) -> CompiledSolver:
    return library(compiled(name).module, folder(), build)


@cache
def in_python(name: str) -> Any:
    module = compiled(name).module
    return without_numba(compiled(name).files[f"{module.name}.py"], module.name)


def poses_of(name: str, q: FloatArray) -> FloatArray:
    return np.asarray(forward(compiled(name).robot, q), dtype=float)


@pytest.mark.breadth
@pytest.mark.parametrize("joints", FOLDED)
def test_the_solution_that_the_arm_is_at_is_among_the_rows(joints: tuple[float, ...]) -> None:
    q = np.array(joints)
    T = poses_of(FOLDING, q[None])[0]
    found = [
        in_c(FOLDING, PORTABLE).ik(T, q),
        in_c(FOLDING, NATIVE).ik(T, q),
        in_python(FOLDING).ik_all(T, q),
    ]
    for rows, status in found:
        held = rows[np.isin(status, HELD)]
        assert gap(held, q).min() < 1e-6
        assert np.abs(poses_of(FOLDING, held) - T).max() < EXACT


@pytest.mark.breadth
def test_a_motion_through_the_fold_is_followed() -> None:
    """Joints move by no more than they have to, though other solutions take the poses, too."""
    times = np.arange(-1.0, 1.0, STEP)[:, None]
    path = np.array(FOLDED[3]) + times * np.array([0.3, -0.8, 0.0, 0.9, -0.5, 0.7])
    solver, q = in_c(FOLDING, NATIVE), path[0]
    for T in poses_of(FOLDING, path):
        following = solver.nearest(T, q)
        assert np.abs(following - q).max() < 2 * STEP
        assert np.abs(poses_of(FOLDING, following[None])[0] - T).max() < EXACT
        q = following


HOME = np.array([0.0, -np.pi / 2, 0.0, -np.pi / 2, 0.0, 0.0])


@pytest.mark.parametrize("name", ["ur5e", "techman_tm5_900"])
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("off", [1e-13, 1e-12, 1e-11, 1e-10, 1e-8])
def test_an_upright_arm_is_followed(name: str, language: str, off: float) -> None:
    """Stretched, the wrist straight, axes 1 and 6 beside each other: no row, or one far away."""
    source = np.random.default_rng(8)
    q = HOME + off * source.uniform(-1.0, 1.0, (8, 6))
    for T, seed in zip(
        made_poses(name, q), q + source.uniform(-0.005, 0.005, q.shape), strict=True
    ):
        result, found = Solver(name, language).nearest(T, seed)
        assert result in HELD
        assert np.abs(found - seed).max() < 0.05
        assert np.abs(made_poses(name, found[None])[0] - T).max() < EXACT


def above(arm: str, q: FloatArray) -> float:
    """The value of joint 2 at which the wrist centre of an arm lies on axis 1."""

    def across(second: float) -> float:
        joints = q.copy()
        joints[[0, 1]] = 0.0, second
        (T,) = made_poses(arm, joints[None])
        return float(T[0, 3] - FLANGE * T[0, 2])

    low, high = -1.5, 0.5
    assert across(low) * across(high) < 0.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if across(low) * across(middle) > 0.0 else (low, middle)
    return low


FLANGE = 0.09  # from the wrist centre of KR6 to its flange


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("off", [1e-3, 1e-4, 1e-6])
def test_a_straight_wrist_beside_axis_1_is_followed(language: str, off: float) -> None:
    source = np.random.default_rng(9)
    for joints in source.uniform(-1.0, 1.0, (12, 6)):
        q = joints.copy()
        q[4] = 0.0
        q[1] = above("kuka_kr6_r900", q) + off
        T = made_poses("kuka_kr6_r900", q[None])[0]
        result, found = Solver("kuka_kr6_r900", language).nearest(T, q)
        assert result in HELD
        assert np.abs(found - q).max() < 1e-3


@pytest.mark.parametrize("language", LANGUAGES)
def test_half_a_turn_away_is_no_solution(language: str) -> None:
    """The sine of what is missing is zero there, too."""
    q = np.array([0.0, 0.0, 0.0, 0.0, 0.0, np.pi])
    T = made_poses("abb_irb120", q[None])[0]
    rows, status = Solver("abb_irb120", language).all(T)
    held = rows[np.isin(status, HELD)]
    assert len(held)
    assert np.abs(made_poses("abb_irb120", held) - T).max() < EXACT


@pytest.mark.breadth
def test_solutions_of_roots_that_nearly_meet_have_the_same_rows_everywhere() -> None:
    q = np.array(TWIN)
    T = poses_of(TWINS, q[None])[0]
    found = [in_c(TWINS, build).ik(T, q) for build in (PORTABLE, NATIVE)]
    found.append(in_python(TWINS).ik_all(T, q))
    meant = interpret(compiled(TWINS).module.solver, T[None], q[None]).q[0]
    for rows, status in found:
        held = np.isin(status, HELD)
        assert held.tolist() == (~np.isnan(meant).any(axis=1)).tolist()
        assert held.sum() == 8
        assert gap(rows[held], meant[held]).max() < 1e-6


@pytest.mark.breadth
def test_of_rows_that_rounding_tells_apart_the_first_is_taken() -> None:
    """Half way to two is a solution, too, but for rounding, which the languages do differently."""
    name, source = "rounded_7r", np.random.default_rng(18)
    for _ in range(60):
        q = np.array([0.0, 0.0, -np.pi / 2, np.pi, np.pi, 0.0, 0.0])
        q[[0, 1, 6]] = source.uniform(-np.pi, np.pi, 3)
        T = made_poses(name, q[None])[0]
        (rows, status), (others, found) = (
            Solver(name, language).all(T, q, q[2:3]) for language in LANGUAGES
        )
        held = np.isin(status, HELD)
        assert held.any()
        assert np.array_equal(status, found)
        assert (gap(rows[held], others[held]) < 1e-3).all()

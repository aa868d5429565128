"""Arms with four turns and two slides, wherever these are: all solutions, against the oracle."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.errors import UnsolvedError
from dhgen.general.circle import trigonometric
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.derive import derive
from dhgen.program.interpret import interpret
from dhgen.robot.load import load
from dhgen.status import Status
from tests.general.arms import doubtful_in_all_languages, in_c
from tests.general.files import (
    assert_all_solutions,
    compiled,
    kernel_by,
    poses,
    without_derivation,
    written,
)
from tests.general.solved import four_turns_samples, joint_values, solve
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain
    from dhgen.robot.robot import Robot

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

PLACES = list(combinations(range(6), 2))
POSES = 3
DEGREE = 4


def random_rows(slides: tuple[int, ...], seed: int) -> list[str]:
    random = np.random.default_rng(seed)
    rows = []
    for place in range(6):
        fixed, length, a, alpha = random.uniform(-1.0, 1.0, 4) * [2.0, 0.4, 0.4, 3.0]
        own = f"theta: {fixed:.3f}, d: -q" if place in slides else f"theta: q, d: {length:.3f}"
        rows.append(f"{{{own}, a: {a:.3f}, alpha: {alpha:.3f}}}")
    return rows


def known(chain: Chain) -> GeneralKernel:
    return kernel_by(chain, "general 4R2P")


# Arms at right angles: where the slides are parallel the polynomial has roots at infinity, simple
# ones and double ones; and one without lengths.
SPECIAL = (
    (
        "{theta: q, a: -0.327, alpha: pi/2}",
        "{theta: q, alpha: -2.703}",
        "{theta: 0, d: q, a: -0.191, alpha: -pi/2}",
        "{theta: q, d: 0.114, alpha: -pi/2}",
        "{theta: 0.224, d: q, alpha: -1.816}",
        "{theta: q, d: -0.061}",
    ),
    (
        "{theta: q, a: 0.126, alpha: -pi/2}",
        "{theta: q, alpha: pi/2}",
        "{theta: q, d: -0.113}",
        "{theta: pi/2, d: q, alpha: pi/2}",
        "{theta: q, d: -0.351, alpha: -pi/2}",
        "{theta: pi/2, d: q, a: 0.346, alpha: -pi/2}",
    ),
    (
        "{theta: q, d: 0.110}",
        "{theta: 0, d: q, alpha: 0.952}",
        "{theta: -1.086, d: q, alpha: -2.008}",
        "{theta: q, alpha: -pi/2}",
        "{theta: q, alpha: pi/2}",
        "{theta: q, alpha: pi/2}",
    ),
)


@pytest.mark.parametrize("slides", first_of(((each,) for each in PLACES[::-1]), count=2))
def test_wherever_the_slides_are(tmp_path: Path, slides: tuple[int, ...]) -> None:
    compare(written(tmp_path, random_rows(slides, seed=10 * slides[0] + slides[1])))


@pytest.mark.parametrize("rows", SPECIAL)
def test_solutions_at_infinity_are_not_waited_for(tmp_path: Path, rows: tuple[str, ...]) -> None:
    compare(written(tmp_path, list(rows)))


def compare(robot: Robot) -> None:
    kernel = known(build_chain(robot))
    assert kernel.rows == 8
    assert_all_solutions(robot, kernel, poses(build_chain(robot), POSES, seed=1))


# A cylindrical arm with a wrist: what is between the axes are the last digits of a calibration.
LAST_DIGITS = (
    "{theta: q, d: 0.3, a: -6.8e-8, alpha: -3.4e-8}",
    "{theta: 0, d: q, a: 6.7e-8, alpha: -pi/2 + 6.6e-8}",
    "{theta: 0, d: q, a: -7.8e-8, alpha: 5.3e-8}",
    "{theta: q, a: 9.2e-8, alpha: -pi/2 + 4e-8}",
    "{theta: q, d: -4.1e-8, a: 6e-8, alpha: pi/2 + 2.1e-8}",
    "{theta: q, d: 0.1, a: 7e-9, alpha: 6.6e-8}",
)


def test_slides_are_not_as_long_as_last_digits(tmp_path: Path) -> None:
    chain = build_chain(written(tmp_path, list(LAST_DIGITS)))
    kernel, arm = known(chain), numeric_arm(chain)
    for q in np.random.default_rng(1).uniform(0.2, 1.5, (POSES, 6)):
        found = joint_values(solve(arm.pose(q), kernel).q, chain)
        assert np.abs(found - q).max(axis=1).min(initial=1.0) < 1e-6


# Slides 2 and 4 are parallel where joint 3 is straight.
FOLDING = (
    "{theta: q, d: 0.1, a: 0.05}",
    "{theta: pi/2, d: q, a: 0.261, alpha: -pi/2}",
    "{theta: q, alpha: pi/2}",
    "{theta: 0.3, d: q, a: 0.12, alpha: -pi/2}",
    "{theta: q, d: 0.08, a: 0.15, alpha: pi/2}",
    "{theta: q, d: 0.2, a: 0.07}",
)

POINTING = """
name: arm
task: pointing
joints:
  - {theta: q}
  - {theta: pi/2, d: q, a: 0.261, alpha: -pi/2}
  - {theta: q, alpha: pi/2}
  - {theta: q, d: 0.195}
  - {theta: 0, d: q, alpha: -pi/2}
tool: {xyz: [0.435, 0, 0.511], rpy: [0, 30 deg, 0]}
"""

# With joint 3 at zero, where joint 5 is straight axes 2, 4 and 6 are parallel, and the slides, too:
# one polynomial vanishes, the other is a constant, and solutions have no root.
STRAIGHT = """
name: arm
task: pose
convention: modified
free: [3]
joints:
  - {theta: 0, d: q, a: 0.488, alpha: pi}
  - {theta: q, d: 0.284}
  - {theta: q, d: 0.037, a: 0.253, alpha: pi/2}
  - {theta: q, alpha: -pi/2}
  - {theta: q, alpha: -pi/2}
  - {theta: q, d: 0.414, a: 0.419, alpha: pi/2}
  - {theta: 0, d: q, alpha: pi/2}
tool: {xyz: [0.549, 0, 0.428], rpy: [0, pi/2, 0]}
"""


def test_where_axes_are_parallel_roots_tell_nothing(tmp_path: Path) -> None:
    (tmp_path / "arm.yaml").write_text(STRAIGHT, encoding="utf-8")
    module = without_derivation(load(tmp_path / "arm.yaml"))
    solver = compiled(module, tmp_path)
    q = np.array([2.872, -np.pi / 2, 0.0, -np.pi, 0.0, -np.pi, 2.872])
    T, given = solver.fk(q), np.zeros(1)
    rows, status = solver.ik(T, np.zeros(7), given)
    known = interpret(module.solver, T[None], seed=np.zeros(7), free=given)
    for held in (rows[status == Status.FREE_JOINT], known.q[0][known.solved[0]]):
        assert len(held) > 0
        for row in held:
            np.testing.assert_allclose(solver.fk(row), T, atol=1e-9)


# A Stanford arm with a second slide. Where axis 1 is parallel to axis 6 the determinants vanish for
# every angle, and what rounding leaves of their product is a polynomial itself.
SMOOTH = (
    "{theta: q, d: 0.412, a: 0.05, alpha: -pi/2}",
    "{theta: q, d: 0.154, alpha: pi/2}",
    "{theta: -pi/2, d: q, a: 0.0203}",
    "{theta: q, alpha: -pi/2}",
    "{theta: pi/2, d: q, alpha: pi/2}",
    "{theta: q, a: 0.05}",
)


def test_roots_of_rounding_certify_nothing(tmp_path: Path) -> None:
    """They lead to solutions, but these are not all: there is a continuum."""
    chain = build_chain(written(tmp_path, list(SMOOTH)))
    kernel = known(chain)
    T = numeric_arm(chain).pose(np.array([0.0, np.pi / 2, 0.34315, np.pi / 2, -0.34315, 0.0]))
    assert not in_c(kernel, "arm")(T)[2]
    assert not solve(T, kernel).certain


@pytest.mark.breadth
def test_beside_parallel_slides_there_are_solutions(tmp_path: Path) -> None:
    """Others would need slides that reach far, but not these.

    A miss of 1e-10, which is accepted, is one of 2e-9 / distance in the slides.
    """
    chain = build_chain(written(tmp_path, list(FOLDING)))
    kernel, arm = known(chain), numeric_arm(chain)
    compiled = in_c(kernel, "arm")
    random = np.random.default_rng(6)
    for distance in (1e-6, 1e-5):
        for number, q in enumerate(random.uniform(-2.5, 2.5, (20, 6))):
            q[2] = distance
            T = arm.pose(q)
            found = [compiled(T)[0]]
            if number == 0:
                found.append(joint_values(solve(T, kernel).q, chain))
            for rows in found:
                off = np.abs(np.remainder(rows - q + np.pi, 2 * np.pi) - np.pi)
                assert off.max(axis=1).min() < 2e-9 / distance, (distance, q.tolist())


@pytest.mark.breadth
def test_roots_that_rounding_moves_are_not_given_up(tmp_path: Path) -> None:
    """Slides that are nearly parallel for the whole pose: far roots and near ones look alike."""
    (tmp_path / "arm.yaml").write_text(POINTING, encoding="utf-8")
    chain = build_chain(load(tmp_path / "arm.yaml"))
    q = np.array([np.pi, -1.8566339384141528, -1e-10, -np.pi / 2, 0.8249212318098036])
    kernel, T = known(chain), numeric_arm(chain).pose(q)
    for found in (in_c(kernel, "arm")(T)[0], solve(T, kernel).q):
        assert len(found) > 0


@pytest.mark.breadth
def test_c_and_python_agree(tmp_path: Path) -> None:
    chain = build_chain(written(tmp_path, random_rows((0, 3), seed=7)))
    kernel = known(chain)
    assert not doubtful_in_all_languages(kernel, poses(chain, 60, seed=5))


@pytest.mark.parametrize("slides", first_of([((1, 3),), ((0, 1),), ((2, 5),)]))
def test_every_turn_can_be_hidden(tmp_path: Path, slides: tuple[int, ...]) -> None:
    chain = build_chain(written(tmp_path, random_rows(slides, seed=3)))
    kernel = known(chain)
    first, second = kernel.formulations
    assert first.joints[0] != second.joints[0]
    assert not {first.joints[0], second.joints[0]} & set(slides)
    other = replace(kernel, formulations=(second,))
    for T in poses(chain, POSES, seed=2):
        np.testing.assert_allclose(solve(T, kernel).q, solve(T, other).q, atol=1e-8)


@pytest.mark.parametrize("slides", first_of(((each,) for each in PLACES), count=2))
def test_the_polynomial_has_degree_four(tmp_path: Path, slides: tuple[int, ...]) -> None:
    chain = build_chain(written(tmp_path, random_rows(slides, seed=4)))
    kernel = known(chain)
    for T in poses(chain, POSES, seed=3):
        for number in range(len(kernel.formulations)):
            (f,) = trigonometric(four_turns_samples(kernel, T, number)[None])
            beyond = np.abs([f.cosine[DEGREE + 1 :], f.sine[DEGREE + 1 :]]).max()
            assert max(beyond / f.scale, f.noise) < 1e-11
            assert max(abs(f.cosine[DEGREE]), abs(f.sine[DEGREE])) > 1e-9 * f.scale


def test_a_longer_arm_with_joints_given(tmp_path: Path) -> None:
    rows = random_rows((1, 3, 6), seed=5)
    rows.append("{theta: 0.2, d: q, a: 0.1, alpha: 0.9}")
    chain = replace(build_chain(written(tmp_path, rows)), free=(7,))
    kernel = known(chain)
    for T in poses(chain, POSES, seed=4):
        for value in (0.0, 0.3):
            found = solve(T, kernel, [value])
            q = joint_values(found.q, chain)
            assert found.certain
            full = np.column_stack([q, np.full(len(q), value)])
            np.testing.assert_allclose(numeric_arm(chain).pose(full) - T, 0.0, atol=1e-9)


@pytest.mark.breadth
def test_parallel_slides_are_refused(tmp_path: Path) -> None:
    rows = random_rows((1, 2), seed=6)
    rows[1] = "{theta: 0.3, d: q, a: 0.2, alpha: 0}"
    with pytest.raises(UnsolvedError, match="infinitely many solutions"):
        derive(build_chain(written(tmp_path, rows)))

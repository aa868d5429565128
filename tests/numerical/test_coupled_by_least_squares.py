"""Couplings whose equations are no polynomials of the known kinds: least squares solve them."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.compiler import compile_loaded
from dhgen.derivation.figures.all import figures_of
from dhgen.errors import UnsolvedError
from dhgen.method import Method
from dhgen.oracle.forward import forward
from dhgen.robot_files import RobotFile
from tests.compiling import library
from tests.structures import first_of
from tests.targets.calling import HELD, gap
from tests.targets.made import folder, made_up, without_numba

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

ARMS = {
    # a row that turns back by twice what another does
    "back_twice": (
        (
            "theta: q, d: 0.4, a: 0.1, alpha: -pi/2",
            "theta: q, a: 0.5",
            "theta: q, a: 0.4",
            "theta: -2*q2, a: 0.1, alpha: -pi/2",
            "theta: q, d: 0.1",
        ),
        "task: [x, y, z, pitch]\n",
    ),
    # rows that follow joints of the other kind, and joints behind them
    "follows_all": (
        (
            "theta: 2*q2 - q5, d: 0.2, a: 0.1, alpha: pi/2",
            "theta: q, d: 0.2, a: 0.3",
            "theta: 0, d: q, a: 0.1, alpha: pi/2",
            "theta: 2*q3 - 3*q2 + 0.3, d: 0.1, a: 0.2, alpha: pi/3",
            "theta: q, a: 0.2, alpha: -pi/2",
            "theta: 0, d: q3 + 0.05, a: 0.1",
        ),
        "task: position\n",
    ),
    # gears of halves and thirds: a whole turn of one joint is half a turn of another one's drive
    "halves": (
        (
            "theta: q, d: 0.4, a: 0.1, alpha: -pi/2, limits: [-3, 3]",
            "theta: q, a: 0.5",
            "theta: q + 1/2*q2, a: 0.4",
            "theta: -2*q2, a: 0.1, alpha: -pi/2",
            "theta: q + 1/3*q1, d: 0.1",
        ),
        "task: [x, y, z, pitch]\n",
    ),
    # a given drive, whose joint another drive moves, too
    "given_in_part": (
        ("theta: q, a: 0.4", "theta: q, a: 0.3", "theta: q - q2, a: 0.2", "theta: q, a: 0.1"),
        "task: [x, y, yaw]\nfree: [3]\n",
    ),
}


@pytest.mark.parametrize("name", first_of(sorted(ARMS, reverse=True), count=2))
def test_own_values_are_found_and_both_languages_agree(name: str) -> None:
    rows, rest = ARMS[name]
    made = made_up(name, rows, f"{rest}numerical: true\n")
    assert made.module.method is Method.NUMERICAL
    solver, dof = library(made.module, folder()), made.module.chain.dof
    q = np.random.default_rng(7).uniform(-2.0, 2.0, (60, dof))
    T = forward(made.robot, q)
    free = [np.ascontiguousarray(q[:, [n - 1 for n in made.robot.free]])] if made.robot.free else []
    # from a seed near by: that all solutions are found is nowhere said of least squares
    one = [solver.ik(T[k], q[k] + 0.02, *(each[k] for each in free)) for k in range(len(q))]
    # solutions are told without turns, which move other drives, but of angles none but one
    M = made.module.chain.drives.matrix.T
    own = [gap(f[np.isin(s, HELD)] @ M, r @ M).min() for (f, s), r in zip(one, q, strict=True)]
    assert max(own) < 1e-6
    found, status = solver.batch(T, *free)
    held = np.isin(status, HELD)
    reached = forward(made.robot, found[held])
    wanted = np.repeat(T[:, None], found.shape[1], axis=1)[held]
    assert np.abs(reached - wanted)[:, :2, 3].max() < 1e-9
    python = without_numba(made.files[f"{name}.py"], name)
    others, kinds = python.ik_batch(T[:2], *(each[:2] for each in free))
    np.testing.assert_array_equal(kinds, status[:2])
    np.testing.assert_allclose(others, found[:2], atol=1e-9)
    J = python.jacobian(q[0])
    np.testing.assert_allclose(solver.jacobian(q[0]), J, atol=1e-12)
    for drive, moved in enumerate(1e-6 * np.eye(dof)):
        rate = (forward(made.robot, q[0] + moved) - forward(made.robot, q[0] - moved)) / 2e-6
        np.testing.assert_allclose(J[:3, drive], rate[:3, 3], atol=1e-8)


def test_a_joint_that_is_given_in_part_is_refused_with_what_may_be_given() -> None:
    rows, rest = ARMS["given_in_part"]
    path = folder() / "in_part.yaml"
    joints = "".join(f"  - {{{row}}}\n" for row in rows)
    path.write_text(f"name: in_part\njoints:\n{joints}{rest}", encoding="utf-8")
    with pytest.raises(UnsolvedError) as stopped:
        compile_loaded(RobotFile.read(path))
    told = str(stopped.value)
    assert told.startswith("joint 3 is free, but the drive of joint 2 moves it, too")
    assert "or joint 2 besides: free: [2, 3]" in told
    assert "--numerical would give" in told


def test_a_given_joint_that_half_turns_of_another_move_is_refused() -> None:
    """A turn of joint 2, without which values are told, would turn joint 3 half round."""
    rows, rest = ARMS["given_in_part"]
    halves = (*rows[:2], "theta: q - 1/2*q2, a: 0.2", rows[3])
    joints = "".join(f"  - {{{row}}}\n" for row in halves)
    path = folder() / "half.yaml"
    path.write_text(f"name: half\nnumerical: true\njoints:\n{joints}{rest}", encoding="utf-8")
    with pytest.raises(UnsolvedError) as stopped:
        compile_loaded(RobotFile.read(path))
    assert "joint 3 is free, and a whole turn of joint 2 would move it" in str(stopped.value)


def test_figures_of_an_arm_with_a_passive_row_that_is_no_sum() -> None:
    """Its links' lengths are written in the order of what is known, of which its angle never is."""
    rows, rest = ARMS["halves"]
    made = made_up("halves", rows, f"{rest}numerical: true\n")
    drawn = figures_of(made.story).arm.file("halves", "halves.yaml")
    assert all(f'>a<tspan dy="4" font-size="10">{number}</' in drawn for number in (1, 2, 3, "3p"))

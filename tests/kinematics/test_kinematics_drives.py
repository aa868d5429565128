"""Drives that have shares in other joints: there and back, and what their whole turns move."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.drives import SumLimit
from dhgen.kinematics.turns import coupled_turns
from dhgen.robot.load import load_text

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain

TURN = 2 * np.pi
# Each is moved by the one after it, so that no order of the rows is that of the drives.
GEARED = "theta: -q + 1/2*q2", "theta: q - 2/3*q3 + pi/2", "theta: q"
PARALLELOGRAM = "theta: q", "theta: q - q1", "theta: -q + 2*q2"
SCREW = "theta: 0, d: q + 0.01*q2", "theta: q", "theta: q - q2"


def chain(rows: tuple[str, ...]) -> Chain:
    joints = "".join(f"  - {{{row}, a: 0.3}}\n" for row in rows)
    return build_chain(load_text(f"name: made_up\njoints:\n{joints}", "made_up.yaml"))


@pytest.mark.parametrize("rows", [GEARED, PARALLELOGRAM, SCREW])
def test_back_undoes_values(rows: tuple[str, ...]) -> None:
    drives = chain(rows).drives
    q = np.random.default_rng(1).uniform(-3.0, 3.0, (20, 3))
    np.testing.assert_allclose(np.stack(drives.back(list(drives.values(q).T)), axis=1), q)
    np.testing.assert_allclose(drives.matrix @ drives.inverse, np.eye(3), atol=1e-15)


def test_values_are_those_of_the_cells() -> None:
    q1, q2, q3 = q = np.array([0.3, -0.7, 1.9])
    wanted = [-q1 + q2 / 2, q2 - 2 / 3 * q3 + np.pi / 2, q3]
    np.testing.assert_allclose(chain(GEARED).drives.values(q), wanted)


def test_each_joint_is_behind_those_that_move_it() -> None:
    assert chain(GEARED).drives.order == (3, 2, 1)
    assert chain(PARALLELOGRAM).drives.order == (1, 2, 3)


def test_turns_in_whole_numbers_are_each_drives_own() -> None:
    assert coupled_turns(chain(PARALLELOGRAM)) is None


def test_a_turn_of_a_screw_moves_its_slide() -> None:
    turns = coupled_turns(chain(SCREW))
    assert turns is not None
    assert turns.drives == (2,)
    np.testing.assert_allclose(turns.moves, [[-0.01 * TURN, TURN, 0.0]])
    assert turns.moved == {1, 2}


def test_turns_of_gears_are_whole_turns_of_the_joints() -> None:
    """And all of them: two thirds of a half make three turns, by which the drives are back."""
    arm = chain(GEARED)
    turns = coupled_turns(arm)
    assert turns is not None
    assert turns.drives == (3, 2, 1)
    whole = np.array(turns.moves) @ arm.drives.matrix.T / TURN
    np.testing.assert_allclose(whole, np.round(whole), atol=1e-12)
    assert abs(np.linalg.det(whole)) == pytest.approx(1.0)


def test_limits_of_a_sum_hold_the_turns_of_its_drives_together() -> None:
    limit = SumLimit((0.0, 1.0, 1.0), -1.0, 1.0, turns=True)
    turns = coupled_turns(replace(chain(PARALLELOGRAM), sums=(limit,)))
    assert turns is not None
    assert turns.drives == (2, 3)
    assert not turns.moved

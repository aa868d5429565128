"""A joint too few for the task, without structure: one more turn, which has to be zero."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.general.arm import general_kernel
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import whole_program
from dhgen.runtime.plain import plain
from dhgen.runtime.python.numerical.places import DRIVES, RECORD, SOLVED, UNIT
from tests.general.files import SLIDE, TURNS, skew
from tests.oracle.sets import all_solutions
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.kinematics.chain import Chain
    from dhgen.program.interpret import Rows

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

POSES = 2


def solved(chain: Chain, T: np.ndarray, values: list[float] | None = None) -> Rows:
    kernel = general_kernel(chain)
    assert kernel is not None
    assert kernel.checked
    free = None if values is None else np.array(values)
    return interpret(whole_program(chain, kernel), T, seed=np.zeros(chain.dof), free=free)


def gaps(rows: np.ndarray, q: np.ndarray) -> np.ndarray:
    return np.asarray(np.abs(np.remainder(rows - q + np.pi, 2 * np.pi) - np.pi).max(axis=-1))


@pytest.mark.parametrize(
    ("place", "free", "task"),
    [
        *first_of((place, (), "pose") for place in (2, 0, 1, 3, 4, 5)),
        (0, (1,), "pose"),
        *first_of((place, (), "pointing") for place in range(5)),
        *first_of([(0, (1,), "pointing")], count=0),
    ],
)
def test_all_solutions(tmp_path: Path, place: int, free: tuple[int, ...], task: str) -> None:
    """Without a slide (place 0) and with one at each place; and on a joint that is given.

    Five joints that take whole poses, and four whose tool points.
    """
    turns = TURNS if task == "pose" else TURNS[:4]
    rows = turns if place == 0 else (*turns[: place - 1], SLIDE, *turns[place:])
    arm = skew(tmp_path, (SLIDE, *rows) if free else rows, free, task)
    chain = build_chain(arm)
    forward = numeric_arm(chain)
    joints = np.random.default_rng(place).uniform(-1.5, 1.5, (POSES, chain.dof))
    joints[:, [number - 1 for number in free]] = 0.2
    poses = forward.pose(joints)
    named = np.s_[..., 2:] if task == "pointing" else np.s_[...]
    found = solved(chain, poses, [0.2] if free else None)
    for k, T in enumerate(poses):
        q = found.q[k][found.solved[k]]
        expected = all_solutions(arm, T, [0.2] if free else [])
        np.testing.assert_allclose(forward.pose(q)[named], [T[named]] * len(q), atol=1e-9)
        assert len(q) == len(expected)
        assert gaps(q, joints[k]).min() < 1e-6
        for row in expected:
            assert gaps(q, row).min() < 1e-6


def test_poses_that_were_rounded_and_poses_that_are_not_the_arms(tmp_path: Path) -> None:
    chain = build_chain(skew(tmp_path, TURNS))
    forward = numeric_arm(chain)
    joints = np.random.default_rng(9).uniform(-3.0, 3.0, (2, 5))
    rounded = np.round(forward.pose(joints), 6)
    found = solved(chain, rounded)
    for k, q in enumerate(joints):
        rows = found.q[k][found.solved[k]]
        assert gaps(rows, q).min() < 1e-4
        np.testing.assert_allclose(forward.pose(rows), [rounded[k]] * len(rows), atol=1e-5)
    turned = forward.pose(joints)
    turned[:, :3, :2] = turned[:, :3, :2] @ [[0.8, -0.6], [0.6, 0.8]]
    assert not solved(chain, turned).solved.any()


def test_a_turn_that_is_not_zero_is_set_aside_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only near to singular places rounding turns what the arm does not have by more."""
    rows, starts = plain("general.rows"), []

    def descend(*arguments: object) -> float:
        starts.append(arguments)
        return 1.0  # which leads to nothing

    monkeypatch.setattr(rows, "descend", descend)
    angles = np.array([[0.3] * 5 + [turn] for turn in (0.0, 0.005, 0.05, -0.5)])
    arm = np.zeros(200)
    arm[SOLVED], arm[UNIT : UNIT + 5 * RECORD : RECORD] = 5, 1.0
    arm[DRIVES] = 190  # where nothing is said of drives that are coupled
    nothing, ahead = np.zeros((16, 5)), (np.zeros((16, 5)), np.ones(16, bool))
    for certain, count in ((True, 1), (False, 3)):
        starts.clear()
        rows._keep_without_turn(arm, nothing, nothing, angles, certain, nothing, ahead, 0)
        assert len(starts) == count  # the first one needs none where it is certain

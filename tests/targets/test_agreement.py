"""C and Python as emitted against the interpreter, on random and singular poses of every robot."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import jacobian
from dhgen.oracle.poses import random_joints, right_angles
from dhgen.program.interpret import interpret
from dhgen.status import HELD
from tests.oracle.sets import one_joint_at
from tests.structures import ODD, STRUCTURES, one_of_each
from tests.targets.made import (
    NAMES,
    apart,
    given,
    in_c,
    in_python,
    made,
    poses_of,
    residual,
    robot,
)

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

COUNT = 12
FEW = 4  # of general arms, whose Python is slow without numba, and of those made up for tests
EVERY = [*NAMES, *ODD]  # others made up for tests are asked in both languages where they are rare
POLISHED = 1e-9  # of general arms, where solutions meet
ROOTS = 16  # rows that are sorted by their values
HALF_TURN = 1e-6  # values that differ by less may be those of one solution, equally exact
SIGNIFICANT = 1e-6  # poles of atan2: nearer to a singular pose rounding decides the angle


def joints(name: str) -> dict[str, FloatArray]:
    arm = robot(name)
    few = name not in STRUCTURES or made(name).module.solver.rows == ROOTS
    count = FEW if few else COUNT
    return {
        "random": random_joints(arm, COUNT, seed=21)[:count],
        "singular": one_joint_at(arm, (0.0, np.pi), 2, seed=22),
        "right angles": right_angles(arm, COUNT, seed=23)[:count],
    }


@pytest.mark.parametrize("name", one_of_each(EVERY))
def test_random_poses(name: str) -> None:
    """To 1e-12 times what the arm's condition makes of rounding."""
    q = joints(name)["random"]
    T = poses_of(name, q)
    program = made(name).module.solver
    meant = interpret(program, T, q, *given(name, q))
    for k in range(len(q)):
        free = given(name, q[k])
        for rows, status in (
            in_c(name).ik(T[k], q[k], *free),
            in_python(name).ik_all(T[k], *free, q[k]),
        ):
            held = np.isin(status, HELD)
            assert held.tolist() == meant.solved[k].tolist()
            miss = apart(name, rows[held], meant.q[k][held]).max(initial=0.0)
            assert miss < 1e-12 * condition(name, rows[held])


def condition(name: str, rows: FloatArray) -> float:
    """One over the least singular value of the Jacobian, of all rows."""
    worst = 1.0
    for row in rows:
        values = np.linalg.svd(in_c(name).jacobian(np.ascontiguousarray(row)), compute_uv=False)
        significant = values[values > SIGNIFICANT * values[0]]
        worst = max(worst, 10.0 / significant[-1])
    return worst


@pytest.mark.parametrize("name", one_of_each(EVERY))
@pytest.mark.parametrize("kind", ["singular", "right angles"])
def test_singular_poses(name: str, kind: str) -> None:
    """The same rows in C and in Python, and every row gives the pose again."""
    q = joints(name)[kind]
    T = poses_of(name, q)
    seeds = random_joints(robot(name), len(q), seed=24)
    for joint in robot(name).free:
        seeds[:, joint - 1] = q[:, joint - 1]
    for k in range(len(q)):
        free = given(name, q[k])
        rows, status = in_c(name).ik(T[k], seeds[k], *free)
        others, other_status = in_python(name).ik_all(T[k], *free, seeds[k])
        if rows.shape[0] == ROOTS and (np.abs(np.abs(rows) - np.pi) < HALF_TURN).any():
            # the sign of what is half a turn up to rounding decides which row comes first
            assert sorted(status) == sorted(other_status)
        else:
            assert status.tolist() == other_status.tolist()
        held, held_too = (np.isin(each, HELD) for each in (status, other_status))
        assert held.any(), q[k]
        for found in (rows[held], others[held_too]):
            assert residual(name, found, T[k]) < (POLISHED if rows.shape[0] == ROOTS else 1e-11)


@pytest.mark.parametrize("name", one_of_each(EVERY))
def test_forward_models(name: str) -> None:
    q = np.concatenate([joints(name)["random"], joints(name)["right angles"]])
    T = poses_of(name, q)
    wanted = jacobian(robot(name), q)
    for k in range(len(q)):
        for solver in (in_c(name), in_python(name)):
            np.testing.assert_allclose(solver.fk(q[k]), T[k], rtol=1e-13, atol=1e-13)
            np.testing.assert_allclose(solver.jacobian(q[k]), wanted[k], rtol=1e-12, atol=1e-12)

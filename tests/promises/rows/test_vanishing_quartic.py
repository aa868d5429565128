"""A quartic without coefficients: every angle is a root, and the joint takes the seed's value.

Axes 1 and 2 are parallel. Where joints 3 and 5 stand at right angles, axis 6 is parallel to them
and slide 4 moves in their plane: four joints for a place and a turn there, so one of them is free.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from dhgen.program.interpret import interpret
from tests.compiling import library
from tests.targets.calling import FREE_JOINT, HELD
from tests.targets.made import folder, made_up

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation
    from dhgen.verify.native import CompiledSolver

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

NAME = "vanishing"
JOINTS = (
    "theta: q, d: 0.378, a: 0.165, alpha: -pi/2",
    "theta: q, d: 0.189, a: 0.399, alpha: 0",
    "theta: q, d: 0, a: 0.192, alpha: -pi/2",
    "theta: 0, d: q, a: 0, alpha: 0",
    "theta: q, d: 0, a: 0.208, alpha: -pi/2",
    "theta: q, d: 0.151, a: 0.214, alpha: -pi/2",
)
COUNT = 20
EXACT = 1e-11


@cache
def compiled() -> Compilation:
    compilation = made_up(NAME, JOINTS, "", convention="modified")
    assert compilation.module.method == "quartic"
    return compilation


@cache
def in_c() -> CompiledSolver:
    return library(compiled().module, folder())


def beside(distance: float) -> FloatArray:
    """Joint vectors at a distance from where joint 6 is free."""
    source = np.random.default_rng(7)
    q: FloatArray = source.uniform(-2.5, 2.5, (COUNT, 6))
    right = source.choice([-np.pi / 2, np.pi / 2], (COUNT, 2))
    q[:, [2, 4]] = right + distance * source.uniform(-1.0, 1.0, (COUNT, 2))
    return q


def poses_of(q: FloatArray) -> FloatArray:
    return np.asarray(forward(compiled().robot, q), dtype=float)


def gap(rows: FloatArray, q: FloatArray) -> float:
    off = np.remainder(rows - q + np.pi, 2 * np.pi) - np.pi
    return float(np.abs(off).max(axis=-1).min())


@pytest.mark.parametrize("distance", [0.0, 1e-14])
def test_the_joint_follows_the_seed(distance: float) -> None:
    q = beside(distance)
    for joints, T in zip(q, poses_of(q), strict=True):
        rows, status = in_c().ik(T, joints)
        assert gap(rows[status == FREE_JOINT], joints) < 1e-9
        np.testing.assert_allclose(poses_of(rows[status == FREE_JOINT]), [T, T], atol=EXACT)
        meant = interpret(compiled().module.solver, T[None], joints)
        assert meant.free[0].tolist() == (status == FREE_JOINT).tolist()


def test_another_seed_has_other_solutions() -> None:
    q = beside(0.0)
    for T in poses_of(q):
        rows, status = in_c().ik(T, np.zeros(6))
        held = rows[status == FREE_JOINT]
        assert len(held) > 0
        assert np.abs(poses_of(held) - T).max() < EXACT


@pytest.mark.parametrize("distance", [1e-8, 1e-6, 1e-4])
def test_beside_it_the_joint_is_found(distance: float) -> None:
    q = beside(distance)
    for joints, T in zip(q, poses_of(q), strict=True):
        rows, status = in_c().ik(T, joints)
        held = rows[np.isin(status, HELD)]
        assert gap(held, joints) < 1e-3
        assert np.abs(poses_of(held) - T).max() < EXACT


@pytest.mark.parametrize("distance", [1e-10, 1e-8])
def test_both_signs_of_a_joint_that_is_nearly_free_are_kept(distance: float) -> None:
    """Joint 2 is free where joint 3 is straight; beside that its cosine has few digits."""
    q = beside(0.0)
    q[:, [2, 4, 5]] = -distance, distance - np.pi, distance
    for joints, T in zip(q, poses_of(q), strict=True):
        rows, status = in_c().ik(T, joints)
        held = rows[np.isin(status, HELD)]
        assert gap(held, joints) < 1e-3
        assert np.abs(poses_of(held) - T).max() < EXACT

"""Roots of a quartic that nearly meet: a joint is nearly free, and two solutions differ in it.

The arm's third link reaches axis 2 where cos theta_3 = -a2 / a3; beside that place theta_1 and
theta_3 of two solutions are nearly the same, and theta_2 is anything.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.compiler import compile_robot
from dhgen.program.interpret import interpret
from dhgen.survey.oracle.forward import forward
from dhgen.verify.native import PORTABLE, compile_solver
from tests.targets.calling import HELD
from tests.targets.made import folder, without_numba

if TYPE_CHECKING:
    from dhgen.compiler import Compilation
    from dhgen.survey.oracle.arm import FloatArray
    from dhgen.verify.native import CompiledSolver

NAME = "touching"
JOINTS = (
    "theta: q, d: 0, a: 0.3, alpha: pi/2",
    "theta: q, d: 0.1, a: 0.15, alpha: -pi/2",
    "theta: q, d: 0, a: 0.5, alpha: 0",
)
TOUCHING = np.arccos(-0.15 / 0.5)
DISTANCES = (1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5)
COUNT = 20
EXACT = 1e-11
APART = 1e-3  # of two solutions, and of one from what rounding of the pose leaves of it [rad]


@cache
def compiled() -> Compilation:
    joints = "".join(f"  - {{{joint}}}\n" for joint in JOINTS)
    path = folder() / f"{NAME}.yaml"
    path.write_text(
        f"name: {NAME}\ntitle: made up\nsource: made up\nconvention: standard\n"
        f"joints:\n{joints}task: position\n"
    )
    compilation = compile_robot(path)
    for file, text in compilation.files.items():
        (folder() / file).write_text(text, encoding="utf-8")
    return compilation


@cache
def in_c() -> CompiledSolver:
    solver = compile_solver(folder() / f"{NAME}.c", folder(), NAME, 3, 4, 0, PORTABLE)
    assert solver is not None, "the tests need a C compiler"
    return solver


def beside(distance: float, count: int) -> FloatArray:
    """Joint vectors at a distance from where joint 2 is free."""
    source = np.random.default_rng(5)
    q: FloatArray = source.uniform(-3.0, 3.0, (count, 3))
    q[:, 2] = source.choice([-1.0, 1.0], count) * TOUCHING + distance * source.uniform(0.5, 1.0)
    return q


def poses_of(q: FloatArray) -> FloatArray:
    return np.asarray(forward(compiled().robot, q), dtype=float)


def gap(rows: FloatArray, q: FloatArray) -> FloatArray:
    off = rows - q
    return np.asarray(np.abs(off - 2 * np.pi * np.round(off / (2 * np.pi))).max(axis=-1))


@pytest.mark.parametrize("distance", DISTANCES)
def test_both_solutions_are_found(distance: float) -> None:
    for q, T in zip(beside(distance, COUNT), poses_of(beside(distance, COUNT)), strict=True):
        rows, status = in_c().ik(T, np.zeros(3))
        held = rows[np.isin(status, HELD)]
        assert gap(held, q).min() < APART, q
        assert np.abs(poses_of(held)[:, :3, 3] - T[:3, 3]).max() < EXACT
        # the other solution: the same place from the other side of axis 2
        close = held[gap(held[:, [0, 2]], q[[0, 2]]) < 10 * distance + 1e-9]
        assert len(close) == 2, (q, held)
        assert gap(close[0], close[1]) > APART


def test_a_free_joint_stays_free() -> None:
    q = beside(0.0, COUNT)
    for joints, T in zip(q, poses_of(q), strict=True):
        rows, status = in_c().ik(T, joints)
        assert gap(rows[np.isin(status, HELD)], joints).min() < APART


@pytest.mark.parametrize("distance", [1e-9, 1e-6])
def test_python_and_the_meaning_have_the_same_rows(distance: float) -> None:
    text = compiled().files[f"{NAME}.py"]
    module = without_numba(text, NAME)
    for q, T in zip(beside(distance, 3), poses_of(beside(distance, 3)), strict=True):
        rows, status = in_c().ik(T, np.zeros(3))
        others, kinds = module.ik_all(T, np.zeros(3))
        meant = interpret(compiled().module.solver, T[None], np.zeros(3)).q[0]
        held = np.isin(status, HELD)
        assert (kinds == status).all()
        for found in (others, meant):
            assert (held == np.isfinite(found).all(axis=1)).all(), q
            assert gap(found[held], rows[held]).max() < APART, q

"""A double root that two solutions share: an equation says nothing about a slide, the others do.

Where theta_4 is a right angle axes 2 and 5 are parallel, and the slide between them has two lengths
with which the tool is in place. Both have the same theta_1, a double root, and the equation that
gives the slide elsewhere is 0 r_3 = 0.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.compiling import library
from tests.targets.calling import HELD, gap
from tests.targets.made import folder, made_up, without_numba

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation
    from dhgen.verify.native import CompiledSolver

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

NAME = "parallel_ends"
ROWS = (
    "theta: q, d: 0, a: 0.25, alpha: 60 deg",
    "theta: q, d: 0.25, a: 0, alpha: 90 deg",
    "theta: -90 deg, d: 0.25 - q, a: 0, alpha: 45 deg",
    "theta: q, d: 0.25, a: 0.25, alpha: 90 deg",
    "theta: q, d: 0.25, a: 0.25, alpha: 0",
)
COUNT = 60
PLAIN = 3  # of many poses, solved in plain Python, too
EXACT = 1e-11
APART = 1e-3  # of two solutions [rad or length]


@cache
def compiled() -> Compilation:
    return made_up(NAME, ROWS, "tool: {xyz: [0.1, -0.1, 0.1], rpy: [45 deg, 30 deg, -90 deg]}\n")


@cache
def in_c() -> CompiledSolver:
    return library(compiled().module, folder())


def poses_of(q: FloatArray) -> FloatArray:
    return np.asarray(forward(compiled().robot, q), dtype=float)


def joints(away: float) -> FloatArray:
    source = np.random.default_rng(4)
    q = source.uniform(-3.0, 3.0, (COUNT, 5))
    q[:, 2] *= 0.2
    q[:, 3] = source.choice([-1.0, 1.0], COUNT) * np.pi / 2 + away
    return q


@pytest.mark.parametrize("away", [0.0, 1e-13])
def test_both_have_a_row_whatever_the_seed(away: float) -> None:
    q = joints(away)
    seeds = np.random.default_rng(5).uniform(-1.0, 1.0, q.shape)
    for values, T, seed in zip(q, poses_of(q), seeds, strict=True):
        for any_seed in (np.zeros(5), seed, values):
            rows, status = in_c().ik(T, any_seed)
            held = rows[np.isin(status, HELD)]
            assert gap(held, values).min() < 1e-6, (values, held)
            assert np.abs(poses_of(held) - T).max() < EXACT
            same = held[gap(held[:, [0, 3]], values[[0, 3]]) < 1e-6]
            assert len(same) == 2, (values, held)
            assert gap(same[0], same[1]) > APART


def test_rows_ascend() -> None:
    """A solution that has the root of another one stands next to it."""
    q = joints(0.0)
    for T in poses_of(q):
        rows, status = in_c().ik(T, np.zeros(5))
        assert (np.diff(rows[np.isin(status, HELD), 0]) > -1e-6).all(), rows


def test_python_says_the_same() -> None:
    module = without_numba(compiled().files[f"{NAME}.py"], NAME)
    q = joints(0.0)[:PLAIN]
    for T in poses_of(q):
        rows, status = in_c().ik(T, np.zeros(5))
        others, kinds = module.ik_all(T)
        assert status.tolist() == kinds.tolist()
        assert gap(rows[status != 1], others[status != 1]).max() < 1e-9

"""Two joints are free at once, and no value of one serves as long as the other has the seed's.

A long arm of seven joints with its second one given: where that makes axes 1 and 3 parallel and
joint 6 is straight, five axes are parallel. The links then lie in a plane, and poses at the edge of
the reach leave joints 1 and 7 one pair of values.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.compiling import library
from tests.targets.calling import HELD
from tests.targets.made import folder, made_up, without_numba

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation
    from dhgen.verify.native import CompiledSolver

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

ROWS = (
    "theta: q, d: 0.38, a: 0, alpha: pi/2",
    "theta: q, d: 1.36, a: 0, alpha: pi/2",
    "theta: q, d: 0.57, a: 6.85, alpha: 0",
    "theta: q, d: 0.475, a: 6.85, alpha: 0",
    "theta: q, d: 0.57, a: 0, alpha: -pi/2",
    "theta: q, d: 0.635, a: 0, alpha: pi/2",
    "theta: q, d: 3.95, a: 0, alpha: 0",
)
EXACT = 1e-11 * 14.0
# joints 4 and 5: the links stretched, with link 1 and joint 6 in line with them or not
IN_LINE = {"both": np.pi / 2, "folded": -np.pi / 2, "aside": 0.7}


@cache
def compiled() -> Compilation:
    return made_up("outstretched", ROWS, "task: pose\nfree: [2]\n")


@cache
def in_c() -> CompiledSolver:
    return library(compiled().module, folder())


def poses(q5: float, count: int) -> tuple[FloatArray, FloatArray]:
    source = np.random.default_rng(11)
    q: FloatArray = source.uniform(-np.pi, np.pi, (count, 7))
    q[:, 1], q[:, 3], q[:, 4], q[:, 5] = np.pi, 0.0, q5, np.pi
    # the link between axes 2 and 3 in line with the stretched ones, to either side
    q[:, 2] = source.choice([-np.pi / 2, np.pi / 2], count)
    return q, np.asarray(forward(compiled().robot, q), dtype=float)


@pytest.mark.parametrize("way", IN_LINE)
def test_a_pair_of_values_is_found_without_a_seed(way: str) -> None:
    T = poses(IN_LINE[way], 100)[1]
    found = []
    for pose in T:
        rows, status = in_c().ik(pose, np.zeros(7), np.array([np.pi]))
        held = rows[np.isin(status, HELD)]
        assert len(held) > 0, pose
        found.append(held[0])
    assert np.abs(forward(compiled().robot, np.array(found)) - T).max() < EXACT


def test_without_numba_it_is_the_same_pair() -> None:
    python = without_numba(compiled().files["outstretched.py"], "outstretched")
    for pose in poses(IN_LINE["folded"], 3)[1]:
        rows, status = in_c().ik(pose, np.zeros(7), np.array([np.pi]))
        others, kinds = python.ik_all(pose, [np.pi])
        assert np.isin(kinds, HELD).any()
        assert (kinds == status).all()
        np.testing.assert_allclose(others, rows, atol=1e-6)

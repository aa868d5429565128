"""Two turns asked for a position: beside axis 1 the other side of it is nearly a solution, too.

The arm is over-determined, so its rows are compared with the pose, and where one is exact, one that
misses by a little is none.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.compiling import library
from tests.targets.made import folder, made_up

if TYPE_CHECKING:
    from dhgen.compiler import Compilation

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

JOINTS = ("theta: q, d: 0, a: 0.25, alpha: -pi/2", "theta: q, d: 0, a: 0.4, alpha: pi")
ON_THE_AXIS = float(np.arccos(-0.25 / 0.4))


@cache
def compiled() -> Compilation:
    return made_up("two_turns", JOINTS, "task: position\n")


@pytest.mark.parametrize("off", [1e-2, 1e-4, 1e-6, 1e-8, 1e-10])
def test_rows_are_exact(off: float) -> None:
    solver = library(compiled().module, folder())
    for turn in np.linspace(-3.0, 3.0, 13):
        q = np.array([turn, ON_THE_AXIS + off])
        T = np.asarray(forward(compiled().robot, q), dtype=float)
        for seed in (q, np.zeros(2)):
            rows, _ = solver.ik(T, seed)
            found = rows[np.isfinite(rows).all(axis=1)]
            reached = np.asarray(forward(compiled().robot, found), dtype=float)[:, :3, 3]
            np.testing.assert_allclose(reached, [T[:3, 3]] * len(found), atol=1e-11 * 0.4)
            assert len(found) >= 1

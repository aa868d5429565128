"""Two solutions that nearly share the hidden angle, although they are apart in the others.

The fit of the determinant takes them for one double root, and half way between them the arm is
singular: nothing leads from there to either.
"""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.targets.calling import HELD, LANGUAGES, gap
from tests.targets.made import made_up, solving

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

NAME = "hollow_wrist"
JOINTS = [
    "theta: q, d: 0.5, a: 0.2, alpha: -pi/2",
    "theta: q, a: 1.1",
    "theta: q, a: 0.1, alpha: -pi/2",
    "theta: q, d: 1.2, alpha: 70 deg",
    "theta: q, d: 0.12, alpha: -70 deg",
    "theta: q, d: 0.1",
]
# theta6 of the other solution is 1.5e-5 rad away, theta1 0.19 rad: a Newton search from 600 starts
# finds these two and ten others.
ONE = [2.6834740051, -1.0871390794, 1.8024472775, 1.5216816089, 2.9368637448, 1.9509563889]
OTHER = [2.873463, -1.087138, 1.802447, 1.619897, 3.069373, 1.950941]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("off", [0.0, 1e-9, 1e-6, 1e-5, 3e-5, 1e-4])
def test_both_solutions_are_found(off: float, language: str) -> None:
    compiled = made_up(NAME, JOINTS, "")
    solve = solving(compiled, language)
    source = np.random.default_rng(31)
    for _ in range(1 if language == "Python" else 100):
        q = np.array(ONE) + off * source.uniform(-1.0, 1.0, 6)
        T = np.asarray(forward(compiled.robot, q[None])[0], dtype=float)
        rows, status = solve(T, np.zeros(6))
        held = rows[np.isin(status, HELD)]
        assert gap(held, q).min() < 1e-6
        assert gap(held, np.array(OTHER)).min() < 0.01
        assert len(held) == 12

"""Branches that meet are one solution, also where an earlier angle is good to fewer digits.

A wrist that is folded at theta_5 = pi has one theta_4 for each elbow. What tells its two branches
apart comes through theta_3, of which a nearly stretched arm has few digits.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.compiling import library
from tests.targets.calling import HELD, LANGUAGES, gap
from tests.targets.made import folder, made_up, without_numba

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

NAME = "branches_that_meet"
ROWS = (
    "theta: q, d: 0.3, a: 0, alpha: 60 deg",
    "theta: q, d: 0, a: 0.3, alpha: 0",
    "theta: q, d: 0, a: 0, alpha: 60 deg",
    "theta: q + 180 deg, d: 0.3, a: 0, alpha: -60 deg",
    "theta: q, d: 0, a: 0, alpha: 60 deg",
    "theta: q, d: 0.3, a: 0, alpha: 0",
)
STRETCHED = np.pi / 2  # of joint 3
COUNT = 200
EXACT = 1e-11


@cache
def compiled() -> Compilation:
    return made_up(NAME, ROWS, "tool: {xyz: [0.1, 0, 0.1]}\n")


@cache
def solver(language: str) -> Any:
    """What solves one pose: T and a seed to rows and statuses."""
    if language == "C":
        return library(compiled().module, folder()).ik
    return without_numba(compiled().files[f"{NAME}.py"], NAME).ik_all


def asked(turned: float) -> tuple[FloatArray, FloatArray]:
    """Joint values with joint 5 so far from folded, most with a nearly stretched arm; the poses."""
    source = np.random.default_rng(6)
    q = source.uniform(-3.0, 3.0, (COUNT, 6))
    off = 10.0 ** source.uniform(-3.5, 0.0, COUNT) * source.choice([-1.0, 1.0], COUNT)
    q[:, 2] = source.choice([-1.0, 1.0], COUNT) * STRETCHED + off
    q[:, 4] = np.pi + turned
    return q, np.asarray(forward(compiled().robot, q), dtype=float)


@pytest.mark.parametrize("language", LANGUAGES)
def test_rounding_alone_makes_no_second_row(language: str) -> None:
    ik, (q, poses) = solver(language), asked(0.0)
    for joints, T in list(zip(q, poses, strict=True))[:: 1 if language == "C" else 10]:
        rows, status = ik(T, np.zeros(6))
        held = rows[np.isin(status, HELD)]
        assert gap(held, joints).min() < 1e-5
        assert np.abs(np.asarray(forward(compiled().robot, held)) - T).max() < EXACT
        assert np.isnan(rows[~np.isin(status, HELD)]).all()
        for place, row in enumerate(held[1:], start=1):
            assert gap(held[:place], row).min() > 1e-5, (joints, held)


def test_two_solutions_stay_two() -> None:
    """What tells them is far above rounding."""
    ik, (q, poses) = solver("C"), asked(3e-4)
    for joints, T in zip(q, poses, strict=True):
        rows, status = ik(T, np.zeros(6))
        held = rows[np.isin(status, HELD)]
        assert np.count_nonzero(gap(held[:, :3], joints[:3]) < 1e-6) == 2

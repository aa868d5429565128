"""Slide, turn, slide, with both slides oblique to the turning axis: type 10 of two lengths."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.compiling import library
from tests.oracle.sets import all_solutions
from tests.structures import first_of
from tests.targets.made import folder, made_up

if TYPE_CHECKING:
    from dhgen.compiler import Compilation
    from dhgen.verify.native import CompiledSolver

# The twists before and behind the turn. Where they are equal or opposite the squares cancel.
TWISTS = {
    "oblique": ("0.551", "1.194", 2),
    "squares_cancel": ("-60 deg", "60 deg", 1),
    "supplementary": ("50 deg", "130 deg", 1),
}


@cache
def compiled(name: str) -> Compilation:
    before, behind, _ = TWISTS[name]
    joints = (
        f"theta: -0.9, d: q, a: 0.25, alpha: {before}",
        f"theta: q, d: 0.29, a: 0.3, alpha: {behind}",
        "theta: 0, d: q, a: 0.2, alpha: 0",
    )
    return made_up(name, joints, "task: position\n")


@cache
def in_c(name: str) -> CompiledSolver:
    return library(compiled(name).module, folder())


@pytest.mark.parametrize("name", first_of(TWISTS))
def test_all_solutions(name: str) -> None:
    robot = compiled(name).robot
    assert compiled(name).module.solver.rows == TWISTS[name][-1]
    for q in np.random.default_rng(5).uniform(-1.5, 1.5, (30, 3)):
        T = np.asarray(forward(robot, q), dtype=float)
        rows, _ = in_c(name).ik(T, np.zeros(3))
        found = rows[np.isfinite(rows).all(axis=1)]
        expected = all_solutions(robot, T)
        assert len(found) == len(expected)
        reached = np.asarray(forward(robot, found), dtype=float)[:, :3, 3]
        np.testing.assert_allclose(reached, [T[:3, 3]] * len(found), atol=1e-12)
        off = found[:, None] - expected
        off[..., 1] = np.remainder(off[..., 1] + np.pi, 2 * np.pi) - np.pi
        assert np.abs(off).max(axis=2).min(axis=0).max() < 1e-8

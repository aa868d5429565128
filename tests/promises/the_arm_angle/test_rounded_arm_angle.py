"""An arm that is given its arm angle, and whose right angles are written with four digits.

There rows come from short vectors, and are refined: they keep the arm angle.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.oracle.arm_angle import given_values
from dhgen.oracle.forward import forward
from tests.compiling import library, written
from tests.targets.calling import HELD, LANGUAGES
from tests.targets.made import folder, without_numba

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation

NAME = "four_digits"
JOINTS = (
    "theta: q, d: 0.36, alpha: -1.5708",
    "theta: q, alpha: 1.5708",
    "theta: q, d: 0.42, alpha: 1.5708",
    "theta: q, alpha: -1.5708",
    "theta: q, d: 0.4, alpha: -1.5708",
    "theta: q, alpha: 1.5708",
    "theta: q, d: 0.126",
)
PROMISED = 1e-11
SAME = 1e-6  # [rad] of arm angles


@cache
def compiled() -> Compilation:
    joints = "".join(f"  - {{{joint}}}\n" for joint in JOINTS)
    path = folder() / f"{NAME}.yaml"
    path.write_text(f"name: {NAME}\njoints:\n{joints}free: arm_angle\n")
    return written(path, folder())


@cache
def solver(language: str) -> Any:
    if language == "Python":
        return without_numba(compiled().files[f"{NAME}.py"], NAME).ik_all
    built = library(compiled().module, folder())
    return lambda T, psi, seed: built.ik(T, seed, psi)


def asked(language: str) -> FloatArray:
    """Joint values at right angles, and some of them there; a quarter of them of plain Python."""
    source = np.random.default_rng(17)
    right = source.integers(-2, 3, (60, 7)) * (np.pi / 2)
    anywhere = source.uniform(-3.0, 3.0, right.shape)
    mixed = np.where(source.random(right.shape) < 0.4, right, anywhere)
    known = [0.0, 0.0, np.pi, np.pi / 2, np.pi / 2, -np.pi, np.pi]
    q = np.concatenate([[known], right, mixed])
    return q[::4] if language == "Python" else q


@pytest.mark.breadth
@pytest.mark.parametrize("language", LANGUAGES)
def test_rows_at_right_angles_are_exact_and_have_the_arm_angle(language: str) -> None:
    robot, q = compiled().robot, asked(language)
    for joints, T, psi in zip(q, forward(robot, q), given_values(robot, q), strict=True):
        rows, status = solver(language)(T, psi, joints)
        held = rows[np.isin(status, HELD)]
        assert len(held), joints
        assert np.abs(forward(robot, held) - T).max() < PROMISED, joints
        off = given_values(robot, held) - psi
        assert np.abs(off - 2 * np.pi * np.round(off / (2 * np.pi))).max() < SAME, joints

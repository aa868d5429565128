"""Which poses the program of regular poses leaves to the whole one."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.given import given_values
from dhgen.kinematics.numeric import numeric_arm
from dhgen.program.interpret import outputs
from dhgen.program.regular.regular import regular
from tests.derivation.stories import story

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray


def doubtful(name: str, q: FloatArray) -> NDArray[np.bool_]:
    """Whether the poses (N,) of joint values (N, n) are left to the whole program."""
    of = story(name)
    solver = regular(of.program)
    assert solver is not None
    arm = numeric_arm(of.derivation.problem.algebra.chain)
    found = outputs(solver.program, arm.pose(q), None, given_values(arm, q))
    return any_told(found, len(solver.doubts))


def any_told(found: Sequence[FloatArray], count: int) -> NDArray[np.bool_]:
    """Whether any of the last outputs (N, B), so many of them, holds for any branch (N,)."""
    told = found[len(found) - count :]
    return np.asarray(np.any([np.zeros_like(found[0]), *told], axis=(0, -1)), dtype=np.bool_)

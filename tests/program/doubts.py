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
    from dhgen.program.regular.flatten import Flat
    from dhgen.program.regular.unguarded import Regular


def doubtful(name: str, q: FloatArray) -> NDArray[np.bool_]:
    """Whether the poses (N,) of joint values (N, n) are left to the whole program."""
    of = story(name)
    solver = regular(of.program)
    assert solver is not None
    arm = numeric_arm(of.derivation.problem.algebra.chain)
    found = outputs(solver.program, arm.pose(q), None, given_values(arm, q))
    return any_told(found, solver)


def any_told(found: Sequence[FloatArray], of: Regular | Flat) -> NDArray[np.bool_]:
    """Whether poses are left to the whole program, by the outputs (N, B) of a program.

    They are where a doubt holds for any branch, and where no row is exact and one is near it.
    """
    end = len(found) - len(of.fits)
    told = found[end - len(of.doubts) : end]
    doubt = np.any([np.zeros_like(found[0]), *told], axis=(0, -1))
    if of.fits:
        exact, near = (np.any(each, axis=-1) for each in found[end:])
        doubt |= near & ~exact
    return np.asarray(doubt, dtype=np.bool_)

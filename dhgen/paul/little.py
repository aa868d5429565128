"""Whether an order of steps hangs on lengths, or twists, that are next to nothing.

An offset of a micrometre, as calibrations and drawings have them, makes a quartic whose roots lie
in pairs that are next to nothing apart, and what tells the two of a pair is divided by the offset.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.step import FEW_SIZES
from dhgen.paul.witness import OWN_LENGTHS, build_witnesses

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.paul.pool import Pool
    from dhgen.paul.step import Step

# Roots so far apart have lost as many digits, and what is divided by the offset as many again. Of
# 400 poses of a UR5 an offset of 1e-5 m in the wrist lost no row, of 1e-6 m three, of 1e-7 m 45.
LITTLE = 1e-4


def hangs_on_little(pool: Pool, steps: Sequence[Step]) -> bool:
    """Whether the factors of an unknown are small together wherever the arm is, with its lengths.

    Args:
        pool: The equations.
        steps: All steps of an arm.
    """
    witnesses = build_witnesses(pool)
    unit = pool.problem.algebra.chain.size / FEW_SIZES
    return any(
        witnesses.largest([step.coefficient(letter) for letter in letters], OWN_LENGTHS, unit)
        < LITTLE
        for step in steps
        for letters in step.kind.value.divisors
    )

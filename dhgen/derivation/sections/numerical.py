"""The inverse of an arm that is solved numerically: what its template names."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.geometry import size_in_words
from dhgen.derivation.text.template import blocks_of
from dhgen.numerical import kernel as constants

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Block
    from dhgen.kinematics.chain import Chain
    from dhgen.numerical.kernel import NumericalKernel


def numerical_section(kernel: NumericalKernel, chain: Chain) -> list[Block]:
    """What replaces the steps of Paul's method."""
    return blocks_of(
        "numerical",
        redundant=kernel.redundant,
        size=size_in_words(chain),
        damping=constants.DAMPING,
        starts=constants.STARTS,
        more_starts=constants.REDUNDANT_STARTS - 1,
        rounds=constants.ROUNDS,
        rows=kernel.rows,
        residual=f"{kernel.residual:.0e}",
    )

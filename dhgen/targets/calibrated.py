"""What targets print of arms of one kind, whose tables come at run time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.kinematics.link_table import LinkTable
    from dhgen.program.regular.unguarded import Regular
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class Kind:
    """What calibrated arms of a kind have in common.

    Attributes:
        module: The programs of the sample arm.
        nominal: The programs of the nominal arm.
        table: Its table.
        regular: Its closed form at regular poses, left where its rows may not be all of an arm's:
            the caller gives an angle and a length by which the two differ at most.
    """

    module: SolverModule
    nominal: SolverModule
    table: LinkTable
    regular: Regular

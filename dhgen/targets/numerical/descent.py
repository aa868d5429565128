"""Constants of the descent, which are the same for every arm."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

from dhgen.numerical import kernel, miss
from dhgen.targets.numerical.texts import any_turn
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.targets.numerical.texts import TurnComponent


def _listed(numbers: Sequence[float]) -> str:
    return ", ".join(map(repr, numbers))


BESIDE, ACROSS = _listed(kernel.BESIDE), _listed(kernel.ACROSS)


@dataclass(frozen=True, slots=True)
class Descent:
    """Its constants, which dhgen/numerical/kernel.py explains, and some of the table of tolerances.

    Attributes:
        any_turn: Half a turn that serves where every axis does.
        solution: The tolerance `polished`.
        exact: That of the same name.
        doubtful: Likewise.
        turn: A whole one [rad].
    """

    aside: float = miss.ASIDE
    any_turn: tuple[TurnComponent, ...] = any_turn()
    damping: float = kernel.DAMPING
    floor: float = kernel.FLOOR
    nearly: float = kernel.NEARLY
    fine: float = kernel.FINE
    longest: float = kernel.LONGEST
    steps: int = kernel.STEPS
    solution: float = TOLERANCES.polished
    exact: float = TOLERANCES.exact
    doubtful: float = TOLERANCES.doubtful
    tightenings: int = kernel.TIGHTENINGS
    escapes: int = kernel.ESCAPES
    stuck: float = kernel.STUCK
    spare: float = kernel.SPARE
    sure: float = kernel.SURE
    loose: float = kernel.LOOSE
    beside: str = BESIDE
    across: str = ACROSS
    few_starts: int = kernel.FEW_STARTS
    singular: float = kernel.SINGULAR
    together: float = kernel.TOGETHER
    same: float = kernel.SAME
    turn: float = 2 * pi
    away: float = kernel.AWAY

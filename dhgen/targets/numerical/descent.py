"""Constants of the descent, which are the same for every arm."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

from dhgen.kinematics.order import TIE
from dhgen.numerical import kernel, miss
from dhgen.targets.numerical.texts import any_turn
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.targets.numerical.texts import TurnComponent


@dataclass(frozen=True, slots=True)
class Listed:
    """Numbers as both languages write them one after another, and how many they are."""

    many: int
    text: str


def _listed(numbers: Sequence[float]) -> Listed:
    return Listed(len(numbers), ", ".join(map(repr, numbers)))


BESIDE, ACROSS, BETWEEN, FARTHER_ON = map(
    _listed, (kernel.BESIDE, kernel.ACROSS, kernel.BETWEEN, kernel.FARTHER_ON)
)


@dataclass(frozen=True, slots=True)
class Descent:
    """Its constants, which dhgen/numerical/kernel.py explains, and some of the table of tolerances.

    Attributes:
        any_turn: Half a turn that serves where every axis does.
        solution: The tolerance `polished`.
        exact: That of the same name.
        promised: Likewise.
        limit: Likewise.
        doubtful: Likewise.
        most_starts: Of all rounds together.
        turn: A whole one [rad].
    """

    aside: str = repr(miss.ASIDE)
    any_turn: tuple[TurnComponent, ...] = any_turn()
    damping: str = repr(kernel.DAMPING)
    floor: str = repr(kernel.FLOOR)
    nearly: str = repr(kernel.NEARLY)
    fine: str = repr(kernel.FINE)
    longest: str = repr(kernel.LONGEST)
    steps: int = kernel.STEPS
    solution: str = repr(TOLERANCES.polished)
    exact: str = repr(TOLERANCES.exact)
    promised: str = repr(TOLERANCES.promised)
    limit: str = repr(TOLERANCES.limit)
    doubtful: str = repr(TOLERANCES.doubtful)
    beside_seed: str = repr(kernel.BESIDE_SEED)
    tightenings: int = kernel.TIGHTENINGS
    escapes: int = kernel.ESCAPES
    stuck: str = repr(kernel.STUCK)
    spare: str = repr(kernel.SPARE)
    sure: str = repr(kernel.SURE)
    loose: str = repr(kernel.LOOSE)
    beside: Listed = BESIDE
    across: Listed = ACROSS
    pull: str = repr(kernel.PULL)
    pulled: int = kernel.PULLED
    settled: str = repr(kernel.SETTLED)
    few_starts: int = kernel.FEW_STARTS
    most_starts: int = kernel.STARTS * kernel.ROUNDS
    singular: str = repr(kernel.SINGULAR)
    feeler: str = repr(kernel.FEELER)
    felt: str = repr(kernel.FELT)
    together: str = repr(kernel.TOGETHER)
    neighbours: str = repr(kernel.NEIGHBOURS)
    between: Listed = BETWEEN
    farther_on: Listed = FARTHER_ON
    steps_aside: int = kernel.STEPS_ASIDE
    stays: str = repr(kernel.STAYS)
    same: str = repr(kernel.SAME)
    tie: str = repr(TIE)
    turn: str = repr(2 * pi)

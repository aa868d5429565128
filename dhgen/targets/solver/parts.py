"""Functions of a solver that have templates of their own."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Parts:
    """Functions as text, each with what it needs, and empty where the solver has none.

    Attributes:
        all_joints: Solves for all joints at once.
        tightening: Takes rows to solutions next to them.
        both_sides: Tells rows apart whose roots nearly meet.
        seeking: Looks for solutions where equations ended every branch.
    """

    all_joints: str = ""
    tightening: str = ""
    both_sides: str = ""
    seeking: str = ""

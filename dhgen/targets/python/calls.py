"""How functions of a Python module are called and compiled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.python.tiles import TILE
from dhgen.targets.solver.calls import Calls

if TYPE_CHECKING:
    from dhgen.targets.solver.common import Common


@dataclass(frozen=True, slots=True)
class PythonCalls(Calls):
    """How functions are called and compiled.

    Attributes:
        free_batch: The values that the caller gives for pose k.
        tile: Poses that are solved side by side.
    """

    free_batch: str
    tile: int = TILE


def python_calls(common: Common) -> PythonCalls:
    """How functions of a robot's module are called."""
    given = bool(common.given.count)
    return PythonCalls(
        free_parameter=", q_free" if given else "",
        free_argument=", q_free" if given else "",
        free_batch=", q_free[k]" if given else "",
    )

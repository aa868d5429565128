"""How functions of a Python module are called and compiled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.python.tiles import TILE
from dhgen.targets.solver.calls import Calls

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule
    from dhgen.targets.solver.common import Common

SHARE = 2048  # poses that are worth a thread


@dataclass(frozen=True, slots=True)
class PythonCalls(Calls):
    """How functions are called and compiled.

    Attributes:
        free_lent: Those that the caller gives, lent to compiled code.
        free_batch: The values that the caller gives for pose k.
        compiles_apart: Whether there are functions that few poses need.
        share: Poses that are worth a thread.
        tile: Poses that are solved side by side.
    """

    free_lent: str
    free_batch: str
    compiles_apart: bool
    share: int = SHARE
    tile: int = TILE


def python_calls(module: SolverModule, common: Common) -> PythonCalls:
    """How functions of a robot's module are called."""
    given = bool(common.given.count)
    rare = common.searches.some or common.standing.settles or module.solver.tightened is not None
    return PythonCalls(
        free_parameter=", q_free" if given else "",
        free_argument=", q_free" if given else "",
        free_lent=", _lent_values(q_free)" if given else "",
        free_batch=", q_free[k]" if given else "",
        compiles_apart=rare or common.programs.solves_whole,
    )

"""Functions of a solver that have templates of their own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.numerical.emit import both_sides, seeking, tightening
from dhgen.targets.walk import parted, whole_arm

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule
    from dhgen.targets.solver.calls import Calls
    from dhgen.targets.solver.common import Common
    from dhgen.targets.writing import Writing


@dataclass(frozen=True, slots=True)
class Parts:
    """Functions as text, each with what it needs, and empty where the solver has none.

    Attributes:
        all_joints: Solves for all joints at once.
        tightening: Takes rows to solutions next to them.
        both_sides: Tells rows apart whose roots nearly meet.
        seeking: Looks for solutions where equations ended every branch.
    """

    all_joints: str
    tightening: str
    both_sides: str
    seeking: str


def parts_of(module: SolverModule, common: Common, calls: Calls, writing: Writing) -> Parts:
    """Those of a robot's solver."""
    solver, of = module.solver, common.module
    whole = whole_arm(solver)
    kernel, roots = solver.tightened, parted(solver)
    return Parts(
        all_joints="" if whole is None else writing.all_joints(whole, module, of),
        tightening="" if kernel is None else tightening(kernel, of, writing),
        both_sides=""
        if roots is None
        else both_sides(roots, solver.turning, common, calls, writing),
        seeking="" if kernel is None else seeking(kernel, common, calls, writing),
    )

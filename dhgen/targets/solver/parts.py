"""Functions of a solver that have templates of their own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.walk import parted, whole_arm

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain
    from dhgen.numerical.both_sides import Turning
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.targets.module import SolverModule
    from dhgen.targets.solver.common import Common
    from dhgen.targets.solver.module import Module


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


@dataclass(frozen=True, slots=True)
class Writers:
    """What writes them in a language.

    Attributes:
        tools: What damped least squares need.
        search: All joints by damped least squares.
        general: The general algorithm.
        general_rows: All joints by it.
        tightening: As in `Parts`.
        both_sides: As in `Parts`.
        seeking: As in `Parts`.
        between: What stands between two functions.
    """

    tools: Callable[[NumericalKernel, Module], str]
    search: Callable[[NumericalKernel, Module], str]
    general: Callable[[GeneralKernel, str], str]
    general_rows: Callable[[GeneralKernel, Chain, str], str]
    tightening: Callable[[NumericalKernel, Module], str]
    both_sides: Callable[[NumericalKernel, Turning, Common], str]
    seeking: Callable[[NumericalKernel, Common], str]
    between: str


def parts_of(module: SolverModule, common: Common, write: Writers) -> Parts:
    """Those of a robot's solver."""
    solver, of = module.solver, common.module
    tightened, roots = solver.tightened, parted(solver)
    return Parts(
        all_joints=_all_joints(module, of, write),
        tightening="" if tightened is None else write.tightening(tightened, of),
        both_sides="" if roots is None else write.both_sides(roots, solver.turning, common),
        seeking="" if tightened is None else write.seeking(tightened, common),
    )


def _all_joints(module: SolverModule, of: Module, write: Writers) -> str:
    """The function that solves for all joints at once, where there is one."""
    whole = whole_arm(module.solver)
    if whole is None:
        return ""
    parts = [write.tools(whole.descent, of)]
    if whole.general is None:
        parts.append(write.search(whole.descent, of))
    else:
        parts.append(write.general(whole.general, module.name))
        parts.append(write.general_rows(whole.general, module.chain, module.name))
    return write.between.join(parts)

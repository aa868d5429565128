"""Fills in the templates of the numerical solver."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.numerical.descent import Descent
from dhgen.targets.numerical.problem import problem_of
from dhgen.targets.numerical.texts import turning_places

if TYPE_CHECKING:
    from dhgen.numerical.both_sides import Turning
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.targets.solver.calls import Calls
    from dhgen.targets.solver.common import Common
    from dhgen.targets.solver.module import Module
    from dhgen.targets.writing import Writing


def tightening(kernel: NumericalKernel, module: Module, writing: Writing) -> str:
    """The function `tighten`, with all that it needs."""
    return _filled("tighten", kernel, module, writing)


def both_sides(
    kernel: NumericalKernel, turning: Turning, common: Common, calls: Calls, writing: Writing
) -> str:
    """The function `both_sides`; it needs `solve` and what tightens."""
    places = turning_places(turning)
    others = {"searches": common.searches, "calls": calls}
    others |= {"turning": places, "turned": places[0].place}
    return _filled("both_sides", kernel, common.module, writing, **others)


def seeking(kernel: NumericalKernel, common: Common, calls: Calls, writing: Writing) -> str:
    """The function `seek`; it needs what tightens and, with limits, searches."""
    others = {"searches": common.searches, "calls": calls}
    return _filled("seek", kernel, common.module, writing, **others)


def _filled(
    template: str, kernel: NumericalKernel, module: Module, writing: Writing, **others: object
) -> str:
    """A template with what all of them name, and what only some do."""
    return writing.filled(
        f"numerical/{template}",
        module=module,
        problem=problem_of(kernel),
        descent=Descent(),
        arrays=writing.arrays(kernel),
        **others,
    )

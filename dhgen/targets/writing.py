"""What differs between languages where parts of a solver have templates of their own."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.printing.templates import render

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.program.ir import AllJoints
    from dhgen.targets.module import SolverModule
    from dhgen.targets.numerical.arrays import Arrays
    from dhgen.targets.solver.module import Module


@dataclass(frozen=True, slots=True)
class Writing:
    """How a language writes such parts.

    Attributes:
        path: Of a template, but for its name.
        arrays: Those of damped least squares.
        all_joints: What solves for all joints at once.
    """

    path: str
    arrays: Callable[[NumericalKernel], Arrays]
    all_joints: Callable[[AllJoints, SolverModule, Module], str]

    def filled(self, template: str, **values: object) -> str:
        """A template, by its name without an ending, with its values."""
        return render(self.path.format(template), **values)

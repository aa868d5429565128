"""What the templates of a solver name in every language."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.status import Status
from dhgen.targets.solver.given import Given, given_of
from dhgen.targets.solver.module import Module, module_of
from dhgen.targets.solver.programs import Programs, programs_of

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class Common:
    """A robot's solver in every language.

    Attributes:
        module: What it is called, and what it solves for.
        given: What the caller gives besides the pose.
        programs: What the programs do.
        status: What a row holds.
    """

    module: Module
    given: Given
    programs: Programs
    status: type[Status]


def common_of(module: SolverModule) -> Common:
    """The comments on a robot's solver in every language."""
    return Common(
        module=module_of(module),
        given=given_of(module.chain),
        programs=programs_of(module),
        status=Status,
    )

"""What the templates of a solver name in every language."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.status import Status
from dhgen.targets.solver.given import Given, given_of
from dhgen.targets.solver.module import Module, module_of
from dhgen.targets.solver.programs import Circle, Programs, programs_of
from dhgen.targets.solver.searches import Searches, searches_of
from dhgen.targets.solver.settle import Settle, settle_of
from dhgen.targets.solver.standing import Standing, standing_of
from dhgen.targets.solver.task import PoseChecks, pose_checks

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule
    from dhgen.tolerances import Tolerances


@dataclass(frozen=True, slots=True)
class Common:
    """A robot's solver in every language.

    Attributes:
        module: What it is called, and what it solves for.
        given: What the caller gives besides the pose.
        task: What is checked of a pose.
        programs: What the programs do.
        searches: How other values of free joints are looked for.
        standing: When joint values are taken to limits and to the seed.
        settle: How they are taken to a solution next to them.
        tolerances: Of its arithmetic.
        circle: How roots of polynomials on the circle are looked for.
        status: What a row holds.
    """

    module: Module
    given: Given
    task: PoseChecks
    programs: Programs
    searches: Searches
    standing: Standing
    settle: Settle
    tolerances: Tolerances
    circle: Circle
    status: type[Status]


def common_of(module: SolverModule) -> Common:
    """What every language says of a robot's solver."""
    return Common(
        module=module_of(module),
        given=given_of(module.chain),
        task=pose_checks(module.chain.task),
        programs=programs_of(module),
        searches=searches_of(module),
        standing=standing_of(module),
        settle=settle_of(module),
        tolerances=module.precision.tolerances,
        circle=Circle(),
        status=Status,
    )

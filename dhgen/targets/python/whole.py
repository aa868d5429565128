"""Arms that descents work on: their numbers, and what solves for all joints at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.general.runtime_loop import runtime_loop
from dhgen.numerical.runtime_arm import runtime_arm
from dhgen.program.walk import descents, whole_arm
from dhgen.runtime.python.general.arm import Loop
from dhgen.runtime.python.numerical.arm import Arm
from dhgen.targets.python.literal import literal

if TYPE_CHECKING:
    from dhgen.program.ir import Program
    from dhgen.targets.module import SolverModule

MODULES = {Arm.__module__: "_joints", Loop.__module__: "_loops"}


@dataclass(frozen=True, slots=True)
class Whole:
    """What the template of such a solver names.

    Attributes:
        loop: The loop of the general algorithm; empty where descents alone find solutions.
        given: Whether the caller gives values of joints.
        free: These values, or none.
    """

    loop: str
    given: bool
    free: str


def python_links(program: Program) -> str:
    """The joints, the task and the forward model that descents work on; empty without any."""
    kernel = descents(program)
    return "" if kernel is None else literal(runtime_arm(kernel), MODULES)


def python_whole(module: SolverModule) -> Whole | None:
    """What solves for all joints at once, where that is done."""
    whole = whole_arm(module.solver)
    if whole is None:
        return None
    free = "q_free" if whole.given else "_NO_FREE"
    if whole.general is None:
        return Whole("", whole.given, free)
    return Whole(literal(runtime_loop(whole.general), MODULES), whole.given, free)

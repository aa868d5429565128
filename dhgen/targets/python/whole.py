"""Arms that are solved as a whole: their numbers, and the call of the runtime's solver."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.general.runtime_loop import runtime_loop
from dhgen.numerical.runtime_arm import runtime_arm
from dhgen.printing.templates import render
from dhgen.runtime.python.general.arm import Loop
from dhgen.runtime.python.numerical.arm import Arm
from dhgen.targets.numerical.arrays import python_arrays
from dhgen.targets.python.literal import literal
from dhgen.targets.writing import Writing

if TYPE_CHECKING:
    from dhgen.program.ir import AllJoints

MODULES = {Arm.__module__: "_joints", Loop.__module__: "_loops"}


@dataclass(frozen=True, slots=True)
class Whole:
    """What the template names.

    Attributes:
        arm: The joints, the task and the forward model.
        loop: The loop of the general algorithm; empty where descents alone find solutions.
        given: Whether the caller gives values of joints.
    """

    arm: str
    loop: str
    given: bool


def python_all_joints(whole: AllJoints) -> str:
    """The numbers of the arm, and what solves for all joints."""
    kernel = whole.general
    texts = Whole(
        arm=literal(runtime_arm(whole.descent), MODULES),
        loop="" if kernel is None else literal(runtime_loop(kernel), MODULES),
        given=whole.given,
    )
    return render("python/whole.py.jinja", whole=texts)


IN_PYTHON = Writing(
    "python/{}.py.jinja",
    python_arrays,
    lambda whole, _, __: python_all_joints(whole),
)

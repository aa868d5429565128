"""What a robot's programs use and need."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.walk import finds_roots
from dhgen.targets.walk import reads, uses, whole_arm

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class Programs:
    """What the programs do.

    Attributes:
        solves_whole: Whether all joints are solved for at once.
        uses_circle: Whether roots of polynomials on the circle are looked for.
        uses_wrap: Whether angles are moved by whole turns.
        forward_uses_q: Whether the pose depends on joint values.
        jacobian_uses_q: Whether the Jacobian does.
    """

    solves_whole: bool
    uses_circle: bool
    uses_wrap: bool
    forward_uses_q: bool
    jacobian_uses_q: bool


def programs_of(module: SolverModule) -> Programs:
    """What a robot's programs do."""
    solver = module.solver
    return Programs(
        solves_whole=whole_arm(solver) is not None,
        uses_circle=finds_roots(solver),
        uses_wrap=any(uses(program, "wrap") for program in module.programs),
        forward_uses_q=reads(module.forward, "q"),
        jacobian_uses_q=reads(module.jacobian, "q"),
    )

"""What a robot's programs use and need."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.walk import finds_roots, reads, uses

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class Programs:
    """What the programs do.

    Attributes:
        uses_circle: Whether roots of polynomials on the circle are looked for.
        uses_wrap: Whether angles are moved by whole turns.
        forward_uses_q: Whether the pose depends on joint values.
        jacobian_uses_q: Whether the Jacobian does.
    """

    uses_circle: bool
    uses_wrap: bool
    forward_uses_q: bool
    jacobian_uses_q: bool


def programs_of(module: SolverModule) -> Programs:
    """What a robot's programs do."""
    solver = module.solver
    return Programs(
        uses_circle=finds_roots(solver),
        uses_wrap=any(uses(program, "wrap") for program in module.programs),
        forward_uses_q=reads(module.forward, "q"),
        jacobian_uses_q=reads(module.jacobian, "q"),
    )

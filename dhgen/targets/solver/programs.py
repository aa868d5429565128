"""What a robot's programs use and need."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.circle import DIRECTIONS, NEWTON_STEPS
from dhgen.program.walk import finds_roots
from dhgen.targets.walk import checks_again, reads, uses, whole_arm

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class Programs:
    """What the programs do.

    Attributes:
        solves_whole: Whether all joints are solved for at once.
        uses_circle: Whether roots of polynomials on the circle are looked for.
        unmoved: The last argument of those who leave such roots where they are.
        uses_wrap: Whether angles are moved by whole turns.
        forward_uses_q: Whether the pose depends on joint values.
        jacobian_uses_q: Whether the Jacobian does.
        checks_again: Whether the choice of a free joint decides on whether the arm takes the pose.
        measures_miss: Whether it is asked what joint values miss a pose by.
    """

    solves_whole: bool
    uses_circle: bool
    unmoved: str
    uses_wrap: bool
    forward_uses_q: bool
    jacobian_uses_q: bool
    checks_again: bool
    measures_miss: bool


def programs_of(module: SolverModule) -> Programs:
    """What a robot's programs do."""
    solver = module.solver
    return Programs(
        solves_whole=whole_arm(solver) is not None,
        uses_circle=finds_roots(solver),
        unmoved=", 0.0" if finds_roots(solver) else "",
        uses_wrap=any(uses(program, "wrap") for program in module.programs),
        forward_uses_q=reads(module.forward, "q"),
        jacobian_uses_q=reads(module.jacobian, "q"),
        checks_again=checks_again(solver),
        measures_miss=checks_again(solver) or solver.tightened is not None,
    )


@dataclass(frozen=True, slots=True)
class Circle:
    """How roots of a polynomial on the circle are looked for.

    Attributes:
        turn: All of it [rad].
        newton_steps: To a root, at most.
        directions: Points on it where the polynomial is tried.
    """

    turn: float = 2.0 * math.pi
    newton_steps: int = NEWTON_STEPS
    directions: int = DIRECTIONS

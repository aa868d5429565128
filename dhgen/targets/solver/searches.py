"""How other values of free joints are looked for where rows are completed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.numerical.kernel import TIGHTENINGS, TOGETHER
from dhgen.program.walk import finds_roots
from dhgen.targets.policy import FAN, policy_of

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule

# Beside one that works each is farther from it by the root of 2: what is missed between it and
# another one that works shows both, however near they are.
CLOSE_FAN = 20


@dataclass(frozen=True, slots=True)
class Searches:
    """When other values are looked for, and how far.

    Attributes:
        keeps_limits: Whether they are where the seed's leads beyond limits.
        clamps: Whether joints are put on limits.
        others: Whether a joint may have one of a few values: then all of them are looked for.
        ascend: Whether rows are the roots of a polynomial, in their order.
        choosable: Places of the joints that may be chosen, between commas.
        choices: How many they are.
        together: Joint values that differ by less are one solution [rad, arm sizes].
        steps: To one at most.
        close_fan: Values that are tried beside one that works, to each side.
        whole_fan: All that are tried then, to each side.
    """

    keeps_limits: bool
    clamps: bool
    others: bool
    ascend: bool
    choosable: str
    choices: int
    together: float = TOGETHER
    steps: int = TIGHTENINGS
    close_fan: int = CLOSE_FAN
    whole_fan: int = CLOSE_FAN + FAN // 2


def searches_of(module: SolverModule) -> Searches:
    """How a robot's solver looks for other values."""
    policy = policy_of(module)
    return Searches(
        keeps_limits=policy.keeps_limits,
        clamps=policy.clamps,
        others=policy.completes and policy.checks and module.solver.rows > 1,
        ascend=finds_roots(module.solver) and len(module.solver.axes) == 1,
        choosable=", ".join(map(str, policy.choosable)),
        choices=len(policy.choosable),
    )

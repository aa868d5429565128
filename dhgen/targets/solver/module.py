"""What a solver is called, and what it solves for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.method import Method
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class Module:
    """A solver.

    Attributes:
        name: What it is called.
        upper: The same in capitals.
        dof: Joints of the arm.
        rows: Of its solutions.
        jacobian_size: Entries of the Jacobian.
        frames: How many there are: of base, links and tool.
        joint_types: R or P for every joint.
        has_turns: Whether one of them turns.
        method: How the arm is solved.
        length_unit: How lengths are called.
    """

    name: str
    upper: str
    dof: int
    rows: int
    jacobian_size: int
    frames: int
    joint_types: str
    has_turns: bool
    method: Method
    length_unit: str


def module_of(module: SolverModule) -> Module:
    """A robot's solver."""
    dof = module.chain.dof
    return Module(
        name=module.name,
        upper=module.name.upper(),
        dof=dof,
        rows=module.solver.rows,
        jacobian_size=6 * dof,
        frames=len(module.links.rows) + 2,
        joint_types=module.chain.joint_types,
        has_turns=any(module.chain.turning),
        method=module.method,
        length_unit=module.length_unit,
    )

"""Prototypes of a robot's public C functions, and how they hand on what they are given."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.layout import call

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class Prototypes:
    """Functions without their bodies.

    Attributes:
        ik: All solutions of a pose.
        nearest: The solution next to a seed.
        batch: All solutions of many poses.
        free_argument: How they hand on what else the caller gives.
    """

    ik: str
    nearest: str
    batch: str
    free_argument: str


def c_prototypes(module: SolverModule) -> Prototypes:
    """The functions of a robot."""
    name, dof, rows, given = module.name, module.chain.dof, module.solver.rows, module.chain.given
    pose, free = "const double T[16]", [f"const double free_joints[{given}]"] if given else []
    table = [f"double q[{rows}][{dof}]", f"unsigned char status[{rows}]"]
    batch_free = ["const double *free_joints"] if free else []
    batch = ["size_t n", "const double *T", *batch_free, "double *q", "unsigned char *status"]
    seed = f"const double q_seed[{dof}]"
    inputs = [pose, *free, "const double *q_seed", *table]
    return Prototypes(
        ik=call(f"int {name}_ik", inputs, ""),
        nearest=call(f"int {name}_ik_nearest", [pose, *free, seed, f"double q[{dof}]"], ""),
        batch=call(f"void {name}_ik_batch", batch, ""),
        free_argument=f", {'free_joints' if given else 'NULL'}",
    )

"""Prototypes of a robot's public C functions, and how they hand on what they are given."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.layout import call

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule

PUBLIC = "DHGEN_PUBLIC"  # the mark of functions


@dataclass(frozen=True, slots=True)
class Prototypes:
    """Functions without their bodies.

    Attributes:
        ik: All solutions of a pose.
        nearest: The solution next to a seed.
        batch: All solutions of many poses.
        velocities: The joint velocities of a twist.
        free_argument: How they hand on what else the caller gives.
    """

    ik: str
    nearest: str
    batch: str
    velocities: str
    free_argument: str


def c_prototypes(module: SolverModule) -> Prototypes:
    """The functions of a robot."""
    name, dof, rows, given = module.name, module.chain.dof, module.solver.rows, module.chain.given
    pose, free = "const double T[16]", [f"const double free_joints[{given}]"] if given else []
    table = [f"double q[{rows}][{dof}]", f"unsigned char status[{rows}]"]
    batch_free = ["const double *free_joints"] if free else []
    batch = ["size_t n", "const double *T", *batch_free, "double *q", "unsigned char *status"]
    seed = f"const double q_seed[{dof}]"
    chosen = [pose, *free, seed, f"double q[{dof}]"]
    twist = [f"const double q[{dof}]", "const double twist[6]", f"double velocities[{dof}]"]
    inputs = [pose, *free, "const double *q_seed", *table]
    return Prototypes(
        ik=call(f"{PUBLIC} int {name}_ik", inputs, ""),
        nearest=call(f"{PUBLIC} int {name}_ik_nearest", chosen, ""),
        batch=call(f"{PUBLIC} void {name}_ik_batch", batch, ""),
        velocities=call(f"{PUBLIC} void {name}_joint_velocities", twist, ""),
        free_argument=f", {'free_joints' if given else 'NULL'}",
    )

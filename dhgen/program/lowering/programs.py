"""All programs of a robot, each under the robot's name."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.program.lowering.arm_angle import arm_angle_program, plane_miss_program
from dhgen.program.lowering.forward import forward_program, jacobian_program
from dhgen.program.lowering.lower import lower
from dhgen.program.reuse import reusing

if TYPE_CHECKING:
    from dhgen.paul.derivation import Derivation
    from dhgen.program.ir import Program
    from dhgen.program.reserved import Reserved
    from dhgen.tolerances import Tolerances


@dataclass(frozen=True, slots=True)
class Programs:
    """What a robot's files compute.

    Attributes:
        solver: From pose to rows of joint values.
        forward: From joint values to the pose.
        jacobian: From joint values to the geometric Jacobian.
        arm_angle: From joint values to the arm angle, where the caller gives that.
        plane_miss: From them and the pose to what they miss the arm angle by, where rows need it.
    """

    solver: Program
    forward: Program
    jacobian: Program
    arm_angle: Program | None = None
    plane_miss: Program | None = None


def robot_programs(
    derivation: Derivation, name: str, tolerances: Tolerances, reserved: Reserved
) -> Programs:
    """The programs of a robot for some arithmetic.

    Args:
        derivation: How it is solved.
        name: What every program is called.
        tolerances: Of the arithmetic.
        reserved: Names that are kept for others.
    """
    chain = derivation.problem.algebra.chain
    solver = lower(derivation, tolerances, reserved)
    forward = reusing(forward_program(chain, reserved), solver)
    jacobian = reusing(jacobian_program(chain, reserved), solver, forward)
    angle = arm_angle_program(derivation, tolerances, reserved)
    # only rows that are led to solutions are measured by it
    led = solver.tightened is not None
    miss = plane_miss_program(derivation, tolerances, reserved) if led else None
    return Programs(
        replace(solver, name=name),
        replace(forward, name=name),
        replace(jacobian, name=name),
        arm_angle=None if angle is None else replace(angle, name=name),
        plane_miss=None if miss is None else replace(miss, name=name),
    )

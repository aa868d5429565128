"""From a derivation to a program: prelude, one kernel a step, joint values, final check."""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial
from typing import TYPE_CHECKING

from dhgen.general.kernel import GeneralKernel
from dhgen.numerical.kernel import numerical_kernel
from dhgen.paul.form import unknown_name
from dhgen.program.ir import AllJoints, Axis, Failure, Guard, Heading, Program, Variable
from dhgen.program.lowering.checks import Checks, checks_needed
from dhgen.program.lowering.context import Lowering
from dhgen.program.lowering.final_check import check_rows
from dhgen.program.lowering.frame_columns import no_parts, parts_of
from dhgen.program.lowering.polynomials import LONG
from dhgen.program.lowering.postures import with_postures
from dhgen.program.lowering.shoulder import lower_shoulder
from dhgen.program.lowering.types import KERNELS
from dhgen.program.lowering.yaw import lower_yaw
from dhgen.program.regular.regular import effort
from dhgen.program.reserved import NOTHING, Reserved
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.chain import Chain
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.paul.derivation import Derivation
    from dhgen.paul.step import Step
    from dhgen.program.lowering.frame_columns import PartsOf
    from dhgen.tolerances import Tolerances


# So many more operations are worth it if that takes so much less text, of which one pose in lanes
# takes each operation once.
WORTH, SHORTER = 1.1, 0.75


def lower(
    derivation: Derivation,
    tolerances: Tolerances = TOLERANCES,
    reserved: Reserved = NOTHING,
    zero: Sequence[float] | None = None,
) -> Program:
    """The program of a derivation.

    Args:
        derivation: What to compute, and why.
        tolerances: Of the arithmetic that it is for.
        reserved: Names that are kept for others.
        zero: The joint values at which the arm stands as people know it; None where these are zero.
    """
    chain = derivation.problem.algebra.chain
    if derivation.whole is not None:
        return whole_program(chain, derivation.whole)

    parts = _parts(derivation, tolerances)

    @cache  # the last that was tried is mostly the one that is wanted
    def lowered(checks: Checks) -> Program:
        program = _lowered(derivation, Lowering(derivation, tolerances, checks, reserved), parts)
        if not (checks.completes or checks.refines):
            return program
        kernel = replace(numerical_kernel(chain, redundant=False), most=program.rows)
        return (
            replace(program, refinement=kernel)
            if checks.refines
            else replace(program, completion=kernel)
        )

    checks = checks_needed(derivation, tolerances, lowered)
    program = lowered(checks)
    if checks.rows:
        tried = (program, lowered(replace(checks, moved=True)))
        program = min(tried, key=lambda each: effort(each, tolerances))
    return with_postures(program, derivation, zero)


def _parts(derivation: Derivation, tolerances: Tolerances) -> PartsOf:
    """What long coefficients are made of: carried columns, or nothing but their terms.

    Columns take less text, and mostly fewer operations; but one that begins at a joint that is
    solved late is carried once more for every branch.
    """
    steps = [
        each for step in derivation.steps for each in (step, step.fallback) if each is not None
    ]
    if not any(len(value) >= LONG for step in steps for _, value in step.coefficients):
        return no_parts
    none, carried = (
        _lowered(derivation, Lowering(derivation, tolerances, Checks(rows=False)), parts)
        for parts in (no_parts, parts_of)
    )
    more = effort(carried, tolerances) / effort(none, tolerances)
    shorter = len(str(carried)) <= SHORTER * len(str(none))
    return parts_of if more <= (WORTH if shorter else 1.0) else no_parts


def _lowered(derivation: Derivation, context: Lowering, parts: PartsOf) -> Program:
    """The whole program."""
    chain, builder, angles = context.chain, context.builder, context.angles
    for joint in chain.free:
        angles.take_given(joint)
    lower_yaw(context, derivation.steps)
    for number, step in enumerate(derivation.steps, start=1):
        context.step_number = number
        builder.heading(_unknowns(step), _source(step))
        context.polynomials.offer(partial(parts, context, step))
        KERNELS[step.kind](context, step)
        _shoulder(derivation, context, step)
    context.polynomials.offer(tuple)
    if context.checks.rows:
        check_rows(context)
    builder.heading("joint values")
    joints = {f"q{n}": angles.joint_value(n) for n in range(1, chain.dof + 1)}
    free = angles.free_joints()
    near = dict.fromkeys((*angles.near, *context.short))
    return builder.finish(chain.name, joints, free, near)


def _shoulder(derivation: Derivation, context: Lowering, step: Step) -> None:
    """Once the elbow's angle is known the arm angle gives the shoulder's rotation."""
    plane = derivation.pool.plane
    if plane is None or plane.elbow_angle not in step.unknowns:
        return
    heading = f"its rotation, from the arm angle and {_unknowns(step)}"
    context.builder.heading("shoulder", heading)
    wrist = [context.point(row, plane.wrist_in_tool) for row in range(3)]
    context.learn(lower_shoulder(context, plane, wrist))


def _unknowns(step: Step) -> str:
    return ", ".join(unknown_name(unknown) for unknown in step.unknowns)


def _source(step: Step) -> str:
    """The type, and the places of its equations."""
    places = " and ".join(origin.name for origin in step.origins)
    return f"type {step.kind.number}: {places}"


FOUND, CHOSEN = "found", "chosen"


def whole_program(chain: Chain, kernel: GeneralKernel | NumericalKernel) -> Program:
    """The program of an arm whose joints come all at once, rows by ascending joint values."""
    names = tuple(f"q{joint.number}" for joint in chain.joints)
    if isinstance(kernel, GeneralKernel):
        title, words = f"the {kernel.method} loop", _numbered("root", kernel.rows)
        descent = replace(numerical_kernel(chain, redundant=False), most=kernel.rows)
        statement = AllJoints(0, names, FOUND, CHOSEN, descent, kernel, bool(chain.free))
    else:
        title = "damped least squares"
        words = ("nearest",) if kernel.redundant else _numbered("solution", kernel.rows)
        statement = AllJoints(0, names, FOUND, CHOSEN, kernel, given=bool(chain.free))
    return Program(
        name=chain.name,
        constants=(),
        axes=(Axis("solution", words, 1),),
        body=(
            Heading(f"all joints: {title}"),
            statement,
            Guard(Variable(FOUND), (0,), Failure.REACH),
        ),
        outputs=tuple(Variable(name) for name in names),
        free=((0, CHOSEN),),
    )


def _numbered(word: str, count: int) -> tuple[str, ...]:
    return tuple(f"{word}{number}" for number in range(1, count + 1))

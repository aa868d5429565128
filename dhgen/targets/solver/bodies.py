"""A robot's programs as lines of a language."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.walk import whole_arm
from dhgen.targets.layout import INDENT
from dhgen.targets.scalar import output_texts, solver_lines, straight_lines

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dhgen.program.ir import Program
    from dhgen.targets.module import SolverModule
    from dhgen.targets.scalar import ScalarLanguage


@dataclass(frozen=True, slots=True)
class ArmAngle:
    """The body of the function that gives the arm angle: its statements, and the result."""

    lines: Sequence[str]
    result: str


@dataclass(frozen=True, slots=True)
class PlaneMiss:
    """The body of the function that computes by how much joint values miss the arm angle.

    Attributes:
        entries: Statements that give the pose's entries their names.
        lines: The other statements.
        off: By how much the arm angle is missed.
        rates: How fast joints 1, 2 and 3 change that.
    """

    entries: Sequence[str]
    lines: Sequence[str]
    off: str
    rates: Sequence[str]


@dataclass(frozen=True, slots=True)
class Bodies:
    """The bodies of functions.

    Attributes:
        solver: From a pose to rows.
        forward: From joint values to the values that a pose's entries name.
        forward_rows: The entries of the pose.
        jacobian: From joint values to the values that the Jacobian's entries name.
        jacobian_rows: The entries of the Jacobian.
        arm_angle: From joint values to the arm angle, where the caller gives that.
        plane_miss: By how much joint values miss the arm angle, where rows may miss it.
    """

    solver: Sequence[str]
    forward: Sequence[str]
    forward_rows: Sequence[str]
    jacobian: Sequence[str]
    jacobian_rows: Sequence[str]
    arm_angle: ArmAngle | None
    plane_miss: PlaneMiss | None


def bodies_of(
    module: SolverModule,
    language: ScalarLanguage,
    assignments: Callable[[str, list[str], int], list[str]],
    entries: Callable[[Program], list[str]],
) -> Bodies:
    """The programs of a robot.

    Args:
        module: The robot.
        language: The language to print.
        assignments: Statements that fill an array of a name with entries, in rows of so many.
        entries: Statements that give the pose's entries their names in a function of a descent.
    """
    forward = output_texts(module.forward, language)
    jacobian = output_texts(module.jacobian, language)
    whole = whole_arm(module.solver) is not None
    return Bodies(
        solver=[] if whole else solver_lines(module.solver, language, INDENT),
        forward=straight_lines(module.forward, language, INDENT),
        forward_rows=assignments("T", forward, 4),
        jacobian=straight_lines(module.jacobian, language, INDENT),
        jacobian_rows=assignments("J", jacobian, module.chain.dof),
        arm_angle=_arm_angle(module.arm_angle, language),
        plane_miss=_plane_miss(module.plane_miss, language, entries),
    )


def _arm_angle(program: Program | None, language: ScalarLanguage) -> ArmAngle | None:
    if program is None:
        return None
    (result,) = output_texts(program, language)
    return ArmAngle(straight_lines(program, language, INDENT), result)


def _plane_miss(
    program: Program | None,
    language: ScalarLanguage,
    entries: Callable[[Program], list[str]],
) -> PlaneMiss | None:
    if program is None:
        return None
    off, *rates = output_texts(program, language)
    return PlaneMiss(entries(program), straight_lines(program, language, INDENT), off, rates)

"""What the targets ask of programs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.program.ir import AllJoints, Apply, Failure, Guard, Joint, Roots
from dhgen.program.role import Source
from dhgen.program.walk import expressions

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.general.kernel import GeneralKernel
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.program.ir import NamedConstant, Program


def uses(program: Program, operator: str) -> bool:
    """Whether an operator occurs."""
    return any(isinstance(e, Apply) and e.operator == operator for e in expressions(program))


def reads(program: Program, role: str) -> bool:
    """Whether a program reads joint values of this role."""
    whole = any(isinstance(s, AllJoints) for s in program.body)
    read = any(isinstance(e, Joint) and e.role == role for e in expressions(program))
    return read or (whole and role == "seed")


def roots_in_a_row(program: Program) -> int:
    """How many roots, of squares or of polynomials, may meet."""
    return sum(
        isinstance(each, Roots)
        or (isinstance(each, Guard) and each.failure is Failure.REACH and each.margin is not None)
        for each in program.body
    )


def descents(program: Program) -> NumericalKernel | None:
    """What least squares know of the arm, where they solve it or complete its rows."""
    whole = whole_arm(program)
    return program.tightened if whole is None else whole.descent


def whole_arm(program: Program) -> AllJoints | None:
    """The statement that solves all joints at once, where there is one."""
    found = (statement for statement in program.body if isinstance(statement, AllJoints))
    return next(found, None)


def general_kernel(program: Program) -> GeneralKernel | None:
    """What the general algorithm knows of the arm, where that solves it."""
    whole = whole_arm(program)
    return None if whole is None else whole.general


def chooses_again(program: Program) -> bool:
    """Whether the choice of a free joint decides on a later guard."""
    return any(
        isinstance(statement, Guard) and statement.chosen and statement.margin is not None
        for statement in program.body
    )


def lost_together(program: Program) -> tuple[int, ...]:
    """The joints, from 1, that may be free at the same time and decide on one guard.

    The one that is noted for a lost row, the last of those that are free, stands behind the others.
    """
    guards = (statement for statement in program.body if isinstance(statement, Guard))
    lost = ([c.joint for c in guard.chosen if c.value is None] for guard in guards if guard.margin)
    return tuple(dict.fromkeys(joint for joints in lost if len(joints) > 1 for joint in joints))


def choosable(program: Program) -> tuple[int, ...]:
    """The joints, from 1, that a branch may choose freely, the last first."""
    return tuple(sorted({joint for joint, _ in program.free if joint}, reverse=True))


def checks_again(program: Program) -> bool:
    """Whether the choice of a free joint decides on whether the arm can take the pose."""
    guards = (statement for statement in program.body if isinstance(statement, Guard))
    return any(guard.failure is Failure.INCONSISTENT and guard.chosen for guard in guards)


def merged_constants(programs: Iterable[Program], own: Sequence[str]) -> tuple[NamedConstant, ...]:
    """The constants of several programs, each once: the arm's own in their order come first."""
    places = {name: place for place, name in enumerate(own)}
    merged: dict[str, NamedConstant] = {}
    for program in programs:
        for constant in program.constants:
            merged.setdefault(constant.name, constant)

    def order(constant: NamedConstant) -> tuple[bool, int]:
        return constant.role is not Source.ARM, places.get(constant.name, len(places))

    return tuple(sorted(merged.values(), key=order))

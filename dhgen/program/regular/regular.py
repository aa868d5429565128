"""The program of regular poses: without loops, guards or free joints, in values of narrow types.

Where a joint is free, or where two branches meet, a pose is singular, and what is to be done then
is the affair of the whole program. This one finds which poses these are; for all others it assumes
that nothing of the kind happens, so that every choice between a formula and the seed is gone. A
row without a solution becomes NaN by itself: the square root of a negative number. On a doubtful
pose a divisor may be zero; what IEEE arithmetic makes of it does not count.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from dhgen.program.count import count_operations
from dhgen.program.ir import AllJoints, Apply, Integer, Let, Roots, Variable
from dhgen.program.regular.limits import NO_LIMITS, ArmLimits
from dhgen.program.regular.unguarded import Unguarded
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.program.ir import Expression, Program
    from dhgen.program.regular.unguarded import Regular
    from dhgen.tolerances import Tolerances


def regular(
    program: Program,
    limits: ArmLimits = NO_LIMITS,
    tolerances: Tolerances = TOLERANCES,
) -> Regular | None:
    """The program of regular poses.

    Args:
        program: The whole program.
        limits: Of its joints.
        tolerances: The table that the program was made with.

    Returns:
        None where branches are the roots of a polynomial.
    """
    if not has_regular_poses(program):
        return None
    kept = inverses_kept(program, tolerances)
    return _made(program, limits, kept, tolerances)


def has_regular_poses(program: Program) -> bool:
    """Whether there is a program of regular poses: not where branches are roots of a polynomial."""
    return not any(isinstance(statement, AllJoints | Roots) for statement in program.body)


@cache  # every target calls it
def _made(
    program: Program,
    limits: ArmLimits,
    kept: frozenset[str],
    tolerances: Tolerances,
) -> Regular:
    """With these inverses of lengths in front."""
    return Unguarded(program, limits, kept, tolerances).run()


@cache
def inverses_kept(program: Program, tolerances: Tolerances) -> frozenset[str]:
    """The inverses of lengths that are left in front: one more as long as that makes it cheaper.

    Limits come after everything else, whatever is kept.

    Args:
        program: The whole program.
        tolerances: The table that the program was made with.
    """
    signs = frozenset(axis.name for axis in program.axes)
    inverses = [
        s.name for s in program.body if isinstance(s, Let) and _is_inverse(s.expression, signs)
    ]
    kept: frozenset[str] = frozenset()
    cost = _cost(_made(program, NO_LIMITS, kept, tolerances).program)
    while True:
        tried = [kept | {name} for name in inverses if name not in kept]
        costs = [_cost(_made(program, NO_LIMITS, each, tolerances).program) for each in tried]
        if min(costs, default=cost) >= cost:
            return kept
        cost = min(costs)
        kept = tried[costs.index(cost)]


def effort(program: Program, tolerances: Tolerances = TOLERANCES) -> int:
    """What a program takes at a regular pose, in multiplications; what it takes at all otherwise.

    Args:
        program: The whole program.
        tolerances: The table that the program was made with.
    """
    solver = regular(program, tolerances=tolerances)
    return _cost(program if solver is None else solver.program)


def _is_inverse(expression: Expression, signs: frozenset[str]) -> bool:
    """Whether a value is the inverse of a length, up to a sign of a branch."""
    match expression:
        case Apply("div", (Integer(1), _)):
            return True
        case Apply("div", (Variable(name), _)):
            return name in signs
        case _:
            return False


def _cost(program: Program) -> int:
    """What a program takes, in multiplications."""
    count = count_operations(program)
    few = count.additions + count.multiplications + 4 * count.divisions
    return few + 6 * count.square_roots + 30 * count.arctangents

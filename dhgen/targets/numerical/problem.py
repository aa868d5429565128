"""What an arm's equations are when joint values are found by descents."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.numerical.kernel import LOOSE
from dhgen.targets.numerical.texts import position_rows
from dhgen.targets.solver.given import given_places
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.targets.numerical.texts import PositionRow
    from dhgen.targets.solver.given import GivenPlace


@dataclass(frozen=True, slots=True)
class NumericalProblem:
    """Equations, and how solutions of them are looked for.

    Attributes:
        solved: Joints that are solved for.
        equations: How many there are.
        last_equation: Place of the last: the arm angle's, if that is one of them.
        elbow: Whether it is.
        width: Equations and joints.
        given: The joints whose values the caller gives.
        position: The coordinates that the task names.
        first_turn: Place of the first equation of directions.
        turns: Whether directions count.
        turning: Whether all of the rotation does.
        pointing: Whether the tool's z axis alone does.
        checked: Whether the arm can't take every pose next to one that it can.
        size: The arm's.
        residual: What counts as a solution of a descent [arm sizes, rad].
        near_sought: What a descent that seeks may miss before steps take it further.
        enough_sought: What counts as one that is sought where equations ended every branch.
        kept: Solutions that are kept while rows are told apart.
    """

    solved: int
    equations: int
    last_equation: int
    elbow: bool
    width: int
    given: tuple[GivenPlace, ...]
    position: tuple[PositionRow, ...]
    first_turn: int
    turns: bool
    turning: bool
    pointing: bool
    checked: bool
    size: str
    residual: str
    near_sought: str
    enough_sought: str
    kept: int


def problem_of(kernel: NumericalKernel) -> NumericalProblem:
    """The equations of an arm."""
    chain, residual = kernel.arm.chain, repr(kernel.residual)
    solved = len(kernel.solved)
    return NumericalProblem(
        solved=solved,
        equations=kernel.equations,
        last_equation=kernel.equations - 1,
        elbow=kernel.elbow,
        width=kernel.equations + solved,
        given=given_places(chain),
        position=position_rows(kernel.position),
        first_turn=len(kernel.position),
        turns=kernel.turning or kernel.pointing,
        turning=kernel.turning,
        pointing=kernel.pointing,
        checked=kernel.checked,
        size=repr(chain.size),
        residual=residual,
        near_sought=residual if kernel.checked else repr(TOLERANCES.doubtful),
        # a pose that is checked may have been rounded
        enough_sought=residual if kernel.checked else f"{LOOSE!r} * exact",
        kept=2 * kernel.rows,
    )

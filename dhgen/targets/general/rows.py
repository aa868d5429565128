"""How rows come from what the general algorithm finds, and else from the descent."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.general.no_turn import NEARLY_NONE, NEARLY_NONE_IN_DOUBT
from dhgen.numerical.kernel import FEW_STARTS
from dhgen.targets.solver.given import given_places
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain
    from dhgen.targets.solver.given import GivenPlace


@dataclass(frozen=True, slots=True)
class Rows:
    """What the function `all_joints` is made of.

    Attributes:
        dof: Joints of the arm.
        rows: Solutions that are kept.
        solved: Joints that are solved for.
        pointing: Whether the task leaves the turn about the tool's axis open.
        checked: Whether the joint behind these is none of the arm's, and has to come out as zero.
        nearly_none: Beyond this [rad] it does not.
        in_doubt: The same where the certificate fails.
        exact: Within this [rad] it is zero, and the solution needs no descent.
        pose: The pose that the algorithm gets.
        residual: What counts as a solution of the descent [arm sizes, rad].
        starts: Of the descent.
        given: The joints whose values the caller gives.
    """

    dof: int
    rows: int
    solved: int
    pointing: bool
    checked: bool
    nearly_none: float
    in_doubt: float
    exact: float
    pose: str
    residual: float
    starts: int
    given: tuple[GivenPlace, ...]


def rows(kernel: GeneralKernel, chain: Chain) -> Rows:
    """The rows of an arm."""
    return Rows(
        dof=chain.dof,
        rows=kernel.rows,
        solved=chain.dof - chain.given,
        pointing=kernel.pointing,
        checked=kernel.checked,
        nearly_none=NEARLY_NONE,
        in_doubt=NEARLY_NONE_IN_DOUBT,
        exact=TOLERANCES.exact,
        pose="whole" if kernel.pointing else "T",
        residual=TOLERANCES.consistent if kernel.checked else TOLERANCES.polished,
        starts=FEW_STARTS,
        given=given_places(chain),
    )

"""What has to be done around a robot's formulas at run time, each step as the runtime calls it.

Beside a singular pose a joint is known from the pose to rounding over what is left of the least
singular value. If it is beyond a limit by no more than that, it may as well be on the limit; and
where the seed meets the pose with other joint values than the rows, the arm may as well go on with
those.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.turns import has_limits, has_poses_to_clamp, joints_alone, turns_alone
from dhgen.program.ir import Failure, Guard, Roots
from dhgen.program.regular.regular import has_regular_poses
from dhgen.program.walk import finds_roots, whole_arm
from dhgen.runtime.python.limits import NEARLY_A_TURN

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain
    from dhgen.program.ir import Program
    from dhgen.tolerances import Tolerances

# Of an interval, until one of a turn is as small as rounding: by bisection, and by golden section,
# which leaves 0.62 of it.
HALVINGS, GOLDEN_CUTS = 52, 72


@dataclass(frozen=True, slots=True)
class Policy:
    """Steps, and the facts of the arm that they need.

    Attributes:
        retries: Whether other values of free joints are looked for where the seed's have no
            solution.
        checks: Whether those values decide on whether the arm can take the pose.
        keeps_limits: Whether others are looked for where the seed's solution is beyond limits.
        completes: Whether rows may miss their pose, be lost or nearly meet.
        adds_others: Whether a joint may have one of a few values, and all of them are rows.
        ascends: Whether rows are the roots of a polynomial, in their order.
        equations_end_all: Whether equations may end all rows of a pose that has solutions.
        root_turns: Joints, from 1, whose values add up to a root of a polynomial that may nearly
            meet another one, each with its sign.
        merges: Whether branches that meet may come out apart: one root follows another.
        refines: Whether rows of a root that follows another are refined to solutions.
        clamps: Whether joints are put on limits near singular poses.
        clamped: By how much more the pose may be missed then [arm sizes, rad].
        clamped_again: And where no row is inside limits then.
        clamps_far: Whether joints far from limits are clamped: not where every pose is solved with
            care.
        range_exceeds_a_turn: Whether a joint that is put on a limit could be turned.
        follows_seed: Whether rows near singular poses go on from the seed.
        choosable: Joints, from 0, that may be free, the last first.
        together: Those that may be at the same time and decide on one guard.
        cuts: Of an interval in which the least miss is looked for.
    """

    retries: bool
    checks: bool
    keeps_limits: bool
    completes: bool
    adds_others: bool
    ascends: bool
    equations_end_all: bool
    root_turns: tuple[tuple[int, int], ...]
    merges: bool
    refines: bool
    clamps: bool
    clamped: float
    clamped_again: float
    clamps_far: bool
    range_exceeds_a_turn: bool
    follows_seed: bool
    choosable: tuple[int, ...]
    together: tuple[int, ...]
    cuts: int

    @property
    def chooses(self) -> bool:
        """Whether other values than the seed's are looked for where a joint is free."""
        return self.retries or self.keeps_limits or self.adds_others


def policy_of(chain: Chain, solver: Program, tolerances: Tolerances) -> Policy:
    """What is done around the formulas of an arm.

    Args:
        chain: The arm.
        solver: From pose to rows of joint values.
        tolerances: Of the arithmetic that it is for.
    """
    completes, clamps = solver.completion is not None, has_poses_to_clamp(chain)
    follows_seed = _follows_seed(chain, solver)
    checks, joints = _checks_again(solver), _choosable(solver)
    return Policy(
        retries=_chooses_again(solver),
        checks=checks,
        keeps_limits=bool(joints) and has_limits(chain),
        completes=completes,
        adds_others=completes and checks and solver.rows > 1,
        ascends=finds_roots(solver) and len(solver.axes) == 1,
        equations_end_all=has_regular_poses(solver),
        root_turns=solver.turning if completes and finds_roots(solver) else (),
        merges=follows_seed and _roots_in_a_row(solver) > 1,
        refines=solver.refinement is not None,
        clamps=clamps,
        clamped=tolerances.clamped,
        clamped_again=_clamped_again(solver, tolerances),
        clamps_far=clamps and has_regular_poses(solver),
        range_exceeds_a_turn=clamps and _widest_turn(chain) > NEARLY_A_TURN,
        follows_seed=follows_seed,
        choosable=_places(joints),
        together=() if completes else _places(_lost_together(solver)),
        cuts=GOLDEN_CUTS if checks else HALVINGS,
    )


def _clamped_again(solver: Program, tolerances: Tolerances) -> float:
    """By how much more a pose may be missed by rows that are clamped where none is inside limits.

    Where solutions are found without branches, nearer ones than `refined` are one anyway.
    """
    return tolerances.clamped if whole_arm(solver) is None else tolerances.refined


def _follows_seed(chain: Chain, solver: Program) -> bool:
    """Whether an arm has poses at which rounding is magnified, and rows for its branches.

    Where whole turns of drives move others, a seed may be a turn of a row that looks unlike it.
    """
    alone = any(chain.turning) and turns_alone(chain)
    return alone and not chain.arm_angle and whole_arm(solver) is None


def _widest_turn(chain: Chain) -> float:
    """How far apart limits of an angle are at most."""
    joints = zip(joints_alone(chain), chain.turning, strict=True)
    ranges = (
        joint.limits[1] - joint.limits[0] for joint, turns in joints if turns and joint.limits
    )
    return max(ranges, default=0.0)


def _roots_in_a_row(program: Program) -> int:
    """How many roots, of squares or of polynomials, may meet."""
    return sum(
        isinstance(each, Roots)
        or (isinstance(each, Guard) and each.failure is Failure.REACH and each.margin is not None)
        for each in program.body
    )


def _chooses_again(program: Program) -> bool:
    """Whether the choice of a free joint decides on a later guard."""
    return any(
        isinstance(statement, Guard) and statement.chosen and statement.margin is not None
        for statement in program.body
    )


def _lost_together(program: Program) -> tuple[int, ...]:
    """The joints, from 1, that may be free at the same time and decide on one guard.

    The one that is noted for a lost row, the last free one, comes after the others.
    """
    guards = (statement for statement in program.body if isinstance(statement, Guard))
    lost = ([c.joint for c in guard.chosen if c.value is None] for guard in guards if guard.margin)
    return tuple(dict.fromkeys(joint for joints in lost if len(joints) > 1 for joint in joints))


def _choosable(program: Program) -> tuple[int, ...]:
    """The joints, from 1, that a branch may choose freely, the last first."""
    return tuple(sorted({joint for joint, _ in program.free if joint}, reverse=True))


def _checks_again(program: Program) -> bool:
    """Whether the choice of a free joint decides on whether the arm can take the pose."""
    guards = (statement for statement in program.body if isinstance(statement, Guard))
    return any(guard.failure is Failure.INCONSISTENT and guard.chosen for guard in guards)


def _places(numbers: tuple[int, ...]) -> tuple[int, ...]:
    return tuple(number - 1 for number in numbers)

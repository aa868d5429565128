"""How joint values are taken to a solution next to them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.numerical.kernel import BESIDE_SEED, DAMPING, FLOOR, TOGETHER
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain, ChainJoint
    from dhgen.targets.module import SolverModule

# Where two things are singular the Jacobian has rows as small as the joints are near. Damped by the
# square of the miss a step is then longer than the way; damped by the miss it is not, and gains
# where roots meet, because the miss is as small as the square of such rows.
CAUTIOUS = 3e-3
ROUNDS = 20  # of steps: what is right ends after two or three, where roots meet after twelve
# A step is in vain if it leaves more of the miss; where n roots meet (1 - 1/n)^n is left. Beside
# places where two things are singular some make it worse before it gets better.
SLOW = 0.7
IN_VAIN = 4  # such steps lead nowhere
FAR = 100.0  # times what is enough: nearer rounding decides what a step leaves
# Joints that move by more lead to another solution [rad, arm sizes]: from a seed, where a step may
# be longer than the whole way; and onto a limit, where a nearly straight wrist turns far for next
# to nothing.
MOVED = BESIDE_SEED
LED = 1.5
ASIDE = 0.25  # times the whole way: from half way to the same solution steps lead no farther
NOTHING = 1e-6  # solutions are of one family if half way misses less [rad, arm sizes]
# Half way to two rows as much is missed if by no more than so many times: then rounding says which
# is least, and not alike in both languages. The first row is taken.
ALIKE = 2.0
# Where two joints are beyond the ends of their ranges both can be led inside, though perhaps not
# onto the ends: as far are they put first, then twice as far and so on, times what they are beyond.
NEXT_INSIDE, FARTHEST_INSIDE = 2.0, 16.0
BEYOND_TOLD = 10.0  # times what tells two solutions, where rounding is more than that of angles


@dataclass(frozen=True, slots=True)
class Settle:
    """What the steps to a solution are made of.

    Attributes:
        width: Columns of a table with the miss and all joints.
        miss_weights: What the components of a miss count, between commas.
        paces: What a step of one means for each joint, between commas.
        together: Joint values that differ by less are one solution [rad, arm sizes].
        cautious: Times the miss, the damping of steps while they gain and much is missed.
        damping: Times the square of the miss, that of the steps after.
        fine: Always added to it.
        rounds: Of steps.
        slow: A step that leaves more of the miss is in vain.
        in_vain: Such steps lead nowhere.
        far: Times what is enough: nearer rounding decides what a step leaves.
        most_moved: From a seed [rad, arm sizes].
        most_led: Onto a limit.
        next_inside: As far are joints put inside their ends, times what they are beyond.
        farthest_inside: The same after it was doubled for the last time.
        singular: The damping of steps that leave singular directions alone.
        steps_aside: So many of them are made.
        aside: Times the whole way: how far steps lead from half way.
        alike: Two misses within so many times are the same.
        promised: A row may miss its pose by this [arm sizes, rad].
        told_by_nothing: Solutions are of one family if half way misses less [rad, arm sizes].
    """

    width: int
    miss_weights: str
    paces: str
    together: float
    fine: float
    promised: float
    told_by_nothing: float
    cautious: float = CAUTIOUS
    damping: float = DAMPING
    rounds: int = ROUNDS
    slow: float = SLOW
    in_vain: int = IN_VAIN
    far: float = FAR
    most_moved: float = MOVED
    most_led: float = LED
    next_inside: float = NEXT_INSIDE
    farthest_inside: float = FARTHEST_INSIDE
    singular: float = FLOOR
    steps_aside: int = 3
    aside: float = ASIDE
    alike: float = ALIKE


def settle_of(module: SolverModule) -> Settle:
    """What steps of a robot's joints are made of."""
    chain, tolerances = module.chain, module.precision.tolerances
    length = _scale(1.0 / chain.size)
    turns = "1.0" if chain.task.names_direction else "0.0"
    rows = chain.task.position_rows
    return Settle(
        width=6 + chain.dof,
        miss_weights=", ".join([length if k in rows else "0.0" for k in range(3)] + [turns] * 3),
        paces=", ".join(paces_of(chain)),
        together=max(TOGETHER, BEYOND_TOLD * tolerances.told),
        fine=tolerances.fine,
        promised=max(tolerances.promised, tolerances.exact),
        told_by_nothing=max(NOTHING, BEYOND_TOLD * tolerances.exact),
    )


def paces_of(chain: Chain) -> list[str]:
    """What a step of one means for each joint."""
    return [_pace(joint, chain) for joint in chain.joints]


def _pace(joint: ChainJoint, chain: Chain) -> str:
    """What a step of one means for a joint: 1 rad, the arm's size, or nothing if it is given."""
    if joint.number in chain.free:
        return "0.0"
    return "1.0" if joint.kind is JointKind.REVOLUTE else _scale(chain.size)


def _scale(value: float) -> str:
    """More digits tell nothing."""
    return repr(float(f"{value:.4g}"))

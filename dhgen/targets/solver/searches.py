"""How other values of free joints are looked for."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.numerical.kernel import TIGHTENINGS, TOGETHER
from dhgen.program.walk import finds_roots
from dhgen.targets.module import stands_on_limits
from dhgen.targets.solver.standing import winds
from dhgen.targets.walk import (
    checks_again,
    choosable,
    chooses_again,
    lost_together,
)

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule

FAN = 64  # values of a free joint that are tried first
# Beside one that serves each is farther from it by the root of 2: what is missed between it and
# another one that serves shows both, however near they are.
CLOSE_FAN = 20
LEAST_MOVE = 1e-15  # of a joint that is nearly free [rad]
MOST_MOVE = 0.1
HALVINGS = 52  # until an interval of a turn is as small as rounding
TURNS = 12  # of joints that may have to be chosen together
GOLDEN = 0.3819660112501051  # (3 - root of 5) / 2
GOLDEN_CUTS = 72  # the same by golden section, which leaves 0.62 of it
ELSEWHERE = 0.1  # how far a joint is moved to see which others move with it [rad or length]


@dataclass(frozen=True, slots=True)
class Searches:
    """When other values are looked for, and how far.

    Attributes:
        some: Whether other values than the seed's are looked for where a joint is free.
        chooses_again: Whether they are where the seed's leads to no solution.
        keeps_limits: Whether they are where it leads beyond limits.
        both: Whether they are for both reasons.
        others: Whether a joint may have one of a few values: then all of them are looked for.
        ascend: Whether rows are the roots of a polynomial, in their order.
        slides: Whether slides are among these joints.
        measures_limits: Whether it is asked how far a joint is beyond its limits.
        sums_limits: Whether it is asked of a row; where limits are wide only searches do.
        choosable: Places of the joints that may be chosen, between commas.
        choices: How many they are.
        in_turn: Places of joints that may have to be chosen together, between commas; none if one
            is enough.
        lost: How many these are.
        turns: How often one after the other is moved.
        turn_step: From one angle that is tried to the next [rad].
        half_fan: How many are tried to each side.
        least_move: Of a joint that is nearly free [rad].
        most_move: The same at most [rad].
        halvings: Of an interval.
        cuts: Of an interval in which the least miss is looked for.
        golden: Where an interval is cut, in parts of it.
        rounding: What it does to joint values [rad or length]: how near branches that meet end a
            search, and what has not moved.
        met: Two distances from the seed that differ by less are told apart by it alone.
        together: Joint values that differ by less are one solution [rad, arm sizes].
        steps: To one at most.
        close_fan: Values that are tried beside one that serves, to each side.
        whole_fan: All that are tried then, to each side.
        elsewhere: How far a joint is moved to see which others move with it [rad or length].
    """

    some: bool
    chooses_again: bool
    keeps_limits: bool
    both: bool
    others: bool
    ascend: bool
    slides: bool
    measures_limits: bool
    sums_limits: bool
    choosable: str
    choices: int
    in_turn: str
    lost: int
    cuts: int
    rounding: float
    met: float
    turn_step: float = 2.0 * math.pi / FAN
    half_fan: int = FAN // 2
    least_move: float = LEAST_MOVE
    most_move: float = MOST_MOVE
    halvings: int = HALVINGS
    golden: float = GOLDEN
    turns: int = TURNS
    together: float = TOGETHER
    steps: int = TIGHTENINGS
    close_fan: int = CLOSE_FAN
    whole_fan: int = CLOSE_FAN + FAN // 2
    elsewhere: float = ELSEWHERE


def searches_of(module: SolverModule) -> Searches:
    """How a robot's solver looks for other values."""
    again, within = chooses_again(module.solver), _keeps_limits(module)
    tolerances = module.precision.tolerances
    tightens = module.solver.tightened is not None
    joints = choosable(module.solver)
    together = () if tightens else lost_together(module.solver)  # those seek with least squares
    return Searches(
        some=again or within,
        chooses_again=again,
        keeps_limits=within,
        both=again and within,
        others=tightens and checks_again(module.solver) and module.solver.rows > 1,
        ascend=finds_roots(module.solver) and len(module.solver.axes) == 1,
        slides=(again or within) and not all(module.chain.turning),
        measures_limits=within or stands_on_limits(module),
        sums_limits=within or not winds(module) or tightens,
        choosable=", ".join(str(joint - 1) for joint in joints),
        choices=len(joints),
        in_turn=", ".join(str(joint - 1) for joint in together),
        lost=len(together),
        cuts=GOLDEN_CUTS if checks_again(module.solver) else HALVINGS,
        rounding=tolerances.limit,
        met=tolerances.told,
    )


def _keeps_limits(module: SolverModule) -> bool:
    """Whether a joint that may be free can keep others, or itself, inside limits."""
    limited = any(joint.limits for joint in module.chain.joints)
    return limited and bool(choosable(module.solver))


def fan_steps(module: SolverModule) -> tuple[float, ...]:
    """From one value of a free joint that is tried to the next: half a fan is enough.

    Angles are tried in a whole turn, slides to both sides as far as their stroke, or where that
    is endless as in a turn of the arm.
    """
    lengths = (
        joint.limits[1] - joint.limits[0] if joint.limits else math.pi * module.chain.size
        for joint in module.chain.joints
    )
    return tuple(
        2.0 * (math.pi if turns else length) / FAN
        for turns, length in zip(module.chain.turning, lengths, strict=True)
    )

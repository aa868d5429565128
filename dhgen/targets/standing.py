"""What the templates need to take joint values to a solution next to them.

Beside a singular pose a joint is known from the pose to rounding over what is left of the least
singular value. If it is beyond a limit by no more than that, it may as well stand there; and where
the seed meets the pose with other joint values than the rows, the arm may as well go on with those.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.numerical.kernel import DAMPING, TOGETHER
from dhgen.robot.robot import JointKind
from dhgen.targets.numerical.texts import given_places
from dhgen.targets.walk import whole_arm

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain, ChainJoint
    from dhgen.targets.module import SolverModule

ROUNDS = 20  # of steps: what is right ends after two or three, where roots meet after twelve
# A step is in vain if it leaves more of the miss; where n roots meet (1 - 1/n)^n is left. Beside
# places where two things are singular some make it worse before it gets better.
SLOW = 0.7
IN_VAIN = 4  # such steps lead nowhere
FAR = 100.0  # times what is enough: nearer rounding decides what a step leaves
# Joints that move by more lead to another solution: from a seed [rad, arm sizes], where a step may
# be longer than the whole way; and times what a joint is beyond its limit.
MOVED = 0.15
LED = 10.0
ASIDE = 0.25  # times the whole way: from half way to the same solution steps lead no farther
NOTHING = 1e-6  # solutions are of one family if half way misses less [rad, arm sizes]
LEAST_WHOLE = 2.0 * math.pi - 1e-6  # limits so far apart leave no gap [rad]
# Half way to two rows as much is missed if by no more than so many times: then rounding says which
# is least, and not alike in both languages. The first row is taken.
ALIKE = 2.0
BEYOND_TOLD = 10.0  # times what tells two solutions, where rounding is more than that of angles


def standing(module: SolverModule) -> dict[str, object]:
    """Whether joints are put on limits and follow the seed, and what a pose is missed by."""
    chain, rows, winding = module.chain, module.chain.task.position_rows, winds(module)
    length = _scale(1.0 / chain.size)
    turns = "1.0" if chain.task.names_direction else "0.0"
    return {
        "stands_on_limits": stands_on_limits(module),
        "stays": stays(module),
        "settles": settles(module),
        "winds": winding,
        "least_whole": repr(LEAST_WHOLE),
        "beyond_an_end": "past_an_end" if winding else "overshoot",
        "beyond_ends": "past_ends" if winding else "beyond_limits",
        "given_places": given_places(chain),
        "together": repr(max(TOGETHER, BEYOND_TOLD * module.precision.tolerances.told)),
        "doubts_limits": stands_on_limits(module) and module.precision.tolerances.blur_limits,
        "per_length": length,
        "miss_weights": ", ".join([length if k in rows else "0.0" for k in range(3)] + [turns] * 3),
        "paces": ", ".join(_pace(joint, chain) for joint in chain.joints),
        "spin": 3 * chain.dof,
        "twice": 2 * chain.dof,
        "rounds": ROUNDS,
        "slow": SLOW,
        "far": FAR,
        "in_vain": IN_VAIN,
        "settle_width": 6 + chain.dof,
        "damping": repr(DAMPING),
        "fine": repr(module.precision.tolerances.fine),
        "most_moved": MOVED,
        "led_by_limit": LED,
        "aside": ASIDE,
        "alike": ALIKE,
        "told_by_nothing": max(NOTHING, BEYOND_TOLD * module.precision.tolerances.exact),
    }


def _pace(joint: ChainJoint, chain: Chain) -> str:
    """What a step of one means for a joint: 1 rad, the arm's size, or nothing if it is given."""
    if joint.number in chain.free:
        return "0.0"
    return "1.0" if joint.kind is JointKind.REVOLUTE else _scale(chain.size)


def _scale(value: float) -> str:
    """More digits tell nothing."""
    return repr(float(f"{value:.4g}"))


def stands_on_limits(module: SolverModule) -> bool:
    """Whether an arm has limits, and poses that rounding says little about: not one of slides.

    An arm angle would be one more thing that has to be met.
    """
    chain = module.chain
    limited = any(joint.limits for joint in chain.joints)
    return limited and any(chain.turning) and not chain.arm_angle


def winds(module: SolverModule) -> bool:
    """Whether an arm stands on limits that are a whole turn apart: a joint could be turned."""
    turning = (joint for joint in module.chain.joints if joint.kind is JointKind.REVOLUTE)
    ranges = [joint.limits[1] - joint.limits[0] for joint in turning if joint.limits]
    return stands_on_limits(module) and max(ranges, default=0.0) > LEAST_WHOLE


def settles(module: SolverModule) -> bool:
    """Whether joint values are taken to a solution next to them."""
    return stands_on_limits(module) or stays(module)


def stays(module: SolverModule) -> bool:
    """Whether an arm has poses that rounding says little about, and rows for its branches."""
    chain, turning = module.chain, any(module.chain.turning)
    return turning and not chain.arm_angle and whole_arm(module.solver) is None

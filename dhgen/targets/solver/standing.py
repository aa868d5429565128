"""When joint values are taken to limits and to the seed.

Beside a singular pose a joint is known from the pose to rounding over what is left of the least
singular value. If it is beyond a limit by no more than that, it may as well stand there; and where
the seed meets the pose with other joint values than the rows, the arm may as well go on with those.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.regular.regular import tells_regular
from dhgen.robot.robot import JointKind
from dhgen.targets.module import stands_on_limits
from dhgen.targets.walk import roots_in_a_row, whole_arm

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule

# Limits so far apart leave next to no gap [rad]: beside a singular pose rounding leads across.
LEAST_WHOLE = 2.0 * math.pi - 0.1


@dataclass(frozen=True, slots=True)
class Standing:
    """Whether joints are put on limits and follow the seed.

    Attributes:
        on_limits: Whether they are put on limits.
        far: Whether they are led far to limits: not where every pose is solved with care.
        stays: Whether they follow the seed.
        settles: Whether they do either, and are taken to a solution next to them.
        tells_once: Whether branches that meet may come out apart: one root follows another.
        leads: Whether rows of a root that follows another are led to solutions.
        winds: Whether a joint that is put on a limit could be turned.
        least_whole: Limits so far apart leave next to no gap [rad].
        beyond_an_end: The function that says how far a joint is beyond the end of its range.
        beyond_ends: The same for a row.
        leads_inside: The function that leads joints beyond their limits onto them or inside.
    """

    on_limits: bool
    far: bool
    stays: bool
    settles: bool
    tells_once: bool
    leads: bool
    winds: bool
    beyond_an_end: str
    beyond_ends: str
    leads_inside: str
    least_whole: float = LEAST_WHOLE


def standing_of(module: SolverModule) -> Standing:
    """What joints of a robot do."""
    limited, stay, winding = stands_on_limits(module), _stays(module), winds(module)
    return Standing(
        on_limits=limited,
        far=limited and tells_regular(module.solver),
        stays=stay,
        settles=limited or stay,
        tells_once=stay and roots_in_a_row(module.solver) > 1,
        leads=module.solver.led is not None,
        winds=winding,
        beyond_an_end="past_an_end" if winding else "overshoot",
        beyond_ends="past_ends" if winding else "beyond_limits",
        leads_inside="lead_inside" if winding else "settle",
    )


def winds(module: SolverModule) -> bool:
    """Whether an arm stands on limits about a whole turn apart: a joint could be turned."""
    turning = (joint for joint in module.chain.joints if joint.kind is JointKind.REVOLUTE)
    ranges = [joint.limits[1] - joint.limits[0] for joint in turning if joint.limits]
    return stands_on_limits(module) and max(ranges, default=0.0) > LEAST_WHOLE


def _stays(module: SolverModule) -> bool:
    """Whether an arm has poses that rounding says little about, and rows for its branches."""
    chain, turning = module.chain, any(module.chain.turning)
    return turning and not chain.arm_angle and whole_arm(module.solver) is None

"""What the templates need to put joints on limits that rounding has moved them beyond.

Beside a singular pose a joint is known from the pose to rounding over what is left of the least
singular value. If it is beyond a limit by no more than that, it may as well stand there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.numerical.texts import position_rows
from dhgen.robot.robot import TaskKind

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule

ROUNDS = 6  # of Gauss-Newton: what is right ends after two or three
MOVED = 0.1  # [rad or length] joints that move by more lead to another solution


def standing(module: SolverModule) -> dict[str, object]:
    """Whether joints may be put on limits, and what the miss of a pose is made of."""
    chain, rows = module.chain, module.position_entries
    length = repr(1.0 / chain.size)
    turns = "0.0" if chain.task.kind in {TaskKind.POSITION, TaskKind.COORDINATES} else "1.0"
    given = [joint.number in chain.free for joint in chain.joints]
    stands = stands_on_limits(module)
    return {
        "stands_on_limits": stands,
        "doubts_limits": stands and module.precision.tolerances.blur_limits,
        "coordinates": position_rows(rows),
        "miss_weights": ", ".join([length if k in rows else "0.0" for k in range(3)] + [turns] * 3),
        "given_flags": ", ".join(str(int(each)) for each in given),
        "given_truths": ", ".join(str(each) for each in given),
        "spin": 3 * chain.dof,
        "twice": 2 * chain.dof,
        "rounds": ROUNDS,
        "most_moved": MOVED,
    }


def stands_on_limits(module: SolverModule) -> bool:
    """Whether an arm has limits, and poses that rounding says little about: not one of slides.

    An arm angle would be one more thing that has to be met.
    """
    chain = module.chain
    limited = any(joint.limits for joint in chain.joints)
    return limited and any(chain.turning) and not chain.arm_angle

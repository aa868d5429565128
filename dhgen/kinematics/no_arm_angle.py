"""Why an arm has no arm angle."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.errors import UnsolvedError
from dhgen.kinematics.arm_angle import triangle
from dhgen.kinematics.neighbours import EXACT, axis_triples, missed_point
from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.robot import JointKind
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain

JOINTS = 7
TRIPLES = {(1, 2, 3): "shoulder", (5, 6, 7): "wrist"}


def demand_arm_angle(chain: Chain) -> None:
    """Refuses arms without an arm angle.

    Raises:
        UnsolvedError: The arm has none; the text says what it lacks.
    """
    reasons = why_no_arm_angle(chain)
    if reasons:
        head = "free: arm_angle is for arms of seven joints with a shoulder, a wrist and an elbow:"
        raise UnsolvedError("\n".join([head, *(f"  {reason}" for reason in reasons)]))


def why_no_arm_angle(chain: Chain) -> list[str]:
    """What an arm lacks for an arm angle; nothing if it has one."""
    return _whole(chain) or _geometry(chain)


def _whole(chain: Chain) -> list[str]:
    """What the arm lacks before its geometry is looked at."""
    kinds = {joint.kind for joint in chain.joints}
    if chain.dof != JOINTS:
        return [f"this one has {chain.dof} joint{'s' if chain.dof > 1 else ''}"]
    if kinds != {JointKind.REVOLUTE}:
        return ["not all of its joints are revolute"]
    if chain.task.kind is not TaskKind.POSE:
        return ["the task must be a whole pose"]
    return []


def _geometry(chain: Chain) -> list[str]:
    triples = {triple.joints: triple for triple in axis_triples(chain)}
    reasons = []
    for joints, name in TRIPLES.items():
        triple = triples[joints]
        if np.isinf(triple.miss):
            axes = ", ".join(map(str, joints))
            reasons.append(f"two of axes {axes} are parallel: there is no {name}")
        elif triple.miss > EXACT * chain.size:
            reasons.append(f"{missed_point(triple)}: there is no {name}")
    return reasons or _elbow(chain)


def _elbow(chain: Chain) -> list[str]:
    """What is wrong with axis 4 between a shoulder and a wrist."""
    found = triangle(numeric_arm(chain), np.zeros(chain.dof))
    least = EXACT * chain.size
    across = np.cross(found.wrist - found.elbow, found.fourth)
    ends = {
        "shoulder": np.linalg.norm(found.elbow - found.shoulder),
        "wrist": np.linalg.norm(across),
    }
    return [
        f"axis 4 passes through the {name}: there is no elbow"
        for name, length in ends.items()
        if length <= least
    ]

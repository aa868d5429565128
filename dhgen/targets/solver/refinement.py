"""What steps to a solution next to joint values count in."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.robot import JointKind
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain, ChainJoint


# About the base's x, y and z; a pitch's miss comes first.
_TURNS = {
    Directions.NONE: (0, 0, 0),
    Directions.POINTING: (1, 1, 1),
    Directions.ROTATION: (1, 1, 1),
    Directions.YAW: (0, 0, 1),
    Directions.PITCH: (1, 0, 0),
    Directions.TILT: (1, 1, 0),
}


def miss_weights(chain: Chain) -> list[str]:
    """What the entries of a miss count, first the translation's: lengths in arm sizes."""
    length = _scale(1.0 / chain.size)
    rows, turns = chain.task.position_rows, _TURNS[chain.task.directions]
    return [length if k in rows else "0.0" for k in range(3)] + [str(float(k)) for k in turns]


def paces_of(chain: Chain) -> list[str]:
    """What a step of one means for each joint."""
    return [_pace(joint, chain) for joint in chain.joints]


def _pace(joint: ChainJoint, chain: Chain) -> str:
    """What a step of one means for a joint: 1 rad, the arm's size, or nothing if it is given."""
    if joint.number in chain.free:
        return "0.0"
    return "1.0" if joint.kind is JointKind.REVOLUTE else _scale(chain.size)


def _scale(value: float) -> str:
    """A factor to the digits that matter."""
    return repr(float(f"{value:.4g}"))

# SPDX-License-Identifier: MIT
"""The words for a robot in messages and docstrings."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

# Numbers that a task names besides coordinates, by the names of functions in `pose`.
NAMED = {
    "pose": 3,
    "orientation": 3,
    "position": 0,
    "pointing": 2,
    "yaw": 1,
    "pitch": 1,
    "tilt": 2,
}
_NO_DIRECTION = {
    "position": "",
    "pointing": ", or its z axis not of length one to six digits",
    "yaw": "",
    "pitch": ", or T[2, 0], minus the sine of the pitch, beyond one",
    "tilt": ", or T[2, 0:3] not of length one to six digits",
}
_NO_ROTATION = (
    ", or not a right-handed rotation to six digits"
    ", or its last row not 0, 0, 0, 1 (is it transposed?)"
)


def no_pose(robot: Mapping[str, Any], task: str, given: int = 0) -> str:
    """What is wrong with a pose that is none.

    Args:
        robot: The names of its module.
        task: What counts of a pose besides coordinates.
        given: How many values the caller gives.
    """
    sound = "not finite or beyond 5e102" if "P" in robot["JOINT_TYPES"] else "not finite"
    what = "the value of a free joint" if "FREE_JOINTS" in robot else "the arm angle"
    free = f", or {what} not finite" if given else ""
    return f"{sound}{_NO_DIRECTION.get(task, _NO_ROTATION)}{free}"


def no_row(robot: Mapping[str, Any], task: str, counted: Sequence[bool], given: int = 0) -> str:
    """Why a pose has no solution.

    Args:
        robot: The names of its module.
        task: What counts of a pose besides coordinates.
        counted: Which coordinates do.
        given: How many values the caller gives.
    """
    reach, joints = "the pose is out of reach", robot["DOF"] - given
    takes_all = joints >= sum(counted) + NAMED[task]
    return reach if takes_all else f"{reach}, or one that {joints} joints can't take"


def what_is_given(robot: Mapping[str, Any]) -> str:
    """What the caller gives, as the beginning of a sentence."""
    if "FREE_JOINTS" not in robot:
        return "The arm angle [rad]"
    return f"Values of the joints {', '.join(map(str, robot['FREE_JOINTS']))}"

"""Joints whose lower and upper limit are one number: they are fixed there."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.descriptions.model import Motion
from dhgen.descriptions.rotations import about, from_rpy, plus, product, to_rpy, turned, unit
from dhgen.descriptions.write import MOST_TURNS

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.descriptions.model import Joint


def with_locked(joints: Sequence[Joint]) -> list[Joint]:
    """Joints with fixed ones in place of those that their limits hold at a value.

    Two zeros are what programs write for no limits. A joint that others follow remains: what
    follows needs a drive.
    """
    followed = {joint.mimics.joint for joint in joints if joint.mimics}
    return [
        _fixed(joint)
        if joint.name not in followed and joint.is_driven and _is_held(joint)
        else joint
        for joint in joints
    ]


def _is_held(joint: Joint) -> bool:
    low, high = joint.limits or (0.0, 0.0)
    return low == high != 0.0 and abs(low) <= MOST_TURNS


def _fixed(joint: Joint) -> Joint:
    """A joint fixed at its limits, which it keeps for the note."""
    value, *_ = joint.limits or (0.0,)
    R, axis = from_rpy(joint.rpy), unit(joint.axis)
    if joint.motion.turns:
        rpy = to_rpy(product(R, about(axis, value)))
        return replace(joint, motion=Motion.FIXED, rpy=rpy)
    return replace(joint, motion=Motion.FIXED, xyz=plus(joint.xyz, turned(R, axis), value))


def locked_notes(joints: Iterable[Joint]) -> list[str]:
    """A note on each joint, from the root to the tip, that is fixed by its limits."""
    return [
        f"fixed: {joint.name} at {joint.limits[0]:g}, its lower and upper limit"
        for joint in joints
        if joint.motion is Motion.FIXED and joint.limits and _is_held(joint)
    ]

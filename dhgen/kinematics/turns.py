"""Whole turns of drives that hang together: those of one move others, or sums have limits."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain, ChainJoint

TURN = 2.0 * math.pi
NOTHING = 1e-9  # [rad] what rounding leaves of whole turns


@dataclass(frozen=True, slots=True)
class CoupledTurns:
    """What has to be looked at together when whole turns are chosen.

    Attributes:
        drives: Those that turn, from 1, each before those that its turns move.
        moves: What a whole turn of each moves: a value for every drive [rad or length].
        moved: All drives, from 1, whose turns move others, or that are moved by such.
    """

    drives: tuple[int, ...]
    moves: tuple[tuple[float, ...], ...]
    moved: frozenset[int]


def coupled_turns(chain: Chain) -> CoupledTurns | None:
    """What is chosen together; None where every drive's whole turns are its own."""
    turns = _turns(chain)
    others = {drive: _others(drive, move) for drive, move in turns.items()}
    moved = {each for drive, found in others.items() if found for each in (drive, *found)}
    summed = {
        number
        for limit in chain.sums
        for number, factor in enumerate(limit.factors, start=1)
        if factor and number in turns
    }
    if not moved and not chain.sums:
        return None
    together = moved | summed
    drives = tuple(each for each in chain.drives.order if each in turns and each in together)
    moves = tuple(tuple((turns[each] + 0.0).tolist()) for each in drives)  # no -0.0
    return CoupledTurns(drives, moves, frozenset(moved))


def joints_alone(chain: Chain) -> tuple[ChainJoint, ...]:
    """The joints with the limits that are looked at for each alone.

    Where the whole turns of drives move others, only all of them together decide what is inside.
    """
    turns = coupled_turns(chain)
    moved = frozenset[int]() if turns is None else turns.moved
    return tuple(
        replace(joint, limits=None) if joint.number in moved else joint for joint in chain.joints
    )


def solved_alone(chain: Chain) -> tuple[ChainJoint, ...]:
    """The joints that are solved for, with the limits that are looked at for each alone."""
    return tuple(joint for joint in joints_alone(chain) if joint.number not in chain.free)


def has_limits(chain: Chain) -> bool:
    """Whether a drive or a sum of drives has limits."""
    return bool(chain.sums) or any(joint.limits for joint in chain.joints)


def turns_alone(chain: Chain) -> bool:
    """Whether no whole turn of a drive moves another one."""
    turns = coupled_turns(chain)
    return turns is None or not turns.moved


def turns_together(chain: Chain) -> tuple[tuple[int, FloatArray], ...]:
    """What a whole turn of each drive moves, drives before the drives that it moves.

    None of them where every drive's whole turns are its own; else those of all that turn and are
    solved for, from 1.
    """
    if turns_alone(chain):
        return ()
    turns = _turns(chain)
    order = [drive for drive in chain.drives.order if drive not in chain.free]
    return tuple((drive, turns[drive] + 0.0) for drive in order if drive in turns)


def has_poses_to_clamp(chain: Chain) -> bool:
    """Whether an arm has limits, and poses at which rounding is magnified: not one of slides.

    An arm angle would be one more thing that has to be met.
    """
    limited = any(joint.limits for joint in joints_alone(chain))
    return limited and turns_alone(chain) and any(chain.turning) and not chain.arm_angle


def _turns(chain: Chain) -> dict[int, FloatArray]:
    """What a whole turn of every drive that turns moves, as few others as can be."""
    inverse = chain.drives.inverse
    found: dict[int, FloatArray] = {}
    for drive in reversed(chain.drives.order):
        if not chain.turning[drive - 1]:
            continue
        move = TURN * inverse[:, drive - 1] / inverse[drive - 1, drive - 1]
        for other in chain.drives.order:
            if other in found:
                move = move - round(move[other - 1] / TURN) * found[other]
                if abs(move[other - 1]) < NOTHING:
                    move[other - 1] = 0.0
        found[drive] = move
    return found


def _others(drive: int, move: FloatArray) -> list[int]:
    return [int(place) + 1 for place in np.flatnonzero(move) if place + 1 != drive]

"""Couplings that only least squares take: passive rows of other kinds, and joints half given."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.errors import UnsolvedError
from dhgen.kinematics.turns import TURN, turns_together
from dhgen.paul.refusal.unsolved import NUMERICAL
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain, Passive

NOTHING = 1e-9  # what rounding leaves of whole turns, and of a length for a turn [1, length/rad]


def demand_given_alone(chain: Chain) -> None:
    """Refuses free joints that are moved by drives which are solved for, too.

    Raises:
        UnsolvedError: There is one: its equations hold a sum of what is given and what is not.
    """
    for number in chain.free:
        others = chain.solved_that_move(number)
        if not others:
            continue
        name, also = chain.named([number]), chain.named([*others])
        plural, free = "s" * (len(others) > 1), sorted({*chain.free, *others})
        raise UnsolvedError(
            f"joint {name} is free, but the drive{plural} of joint{plural} {also} "
            f"{'move' if plural else 'moves'} it, too: its angle or length is not known "
            f"from what is given\nlist under `free` a joint that its own drive moves alone, or "
            f"joint{plural} {also} besides: free: {free}\n{NUMERICAL}"
        )


def demand_sums(chain: Chain) -> None:
    """Refuses passive rows whose angles and lengths are no sums of earlier joints'.

    Raises:
        UnsolvedError: There is one.
    """
    for row in chain.passive:
        if row.apart:
            advice = "" if _turned_apart(chain, row) else f"\n{NUMERICAL}"
            raise UnsolvedError(f"the passive row {row.label}: {row.apart}{advice}")


def demand_whole_turns(chain: Chain) -> None:
    """Refuses given joints and passive rows that are elsewhere after whole turns of other joints.

    Least squares distinguish solutions without turns: of what is solved for, drives that are
    coupled are turned together.

    Raises:
        UnsolvedError: There is one.
    """
    for drive, moves in turns_together(chain):
        joint = _given_apart(chain, moves)
        if joint:
            raise UnsolvedError(
                f"joint {chain.named([joint])} is free, and a whole turn of joint "
                f"{chain.named([drive])} would move it: least squares tell solutions without whole "
                f"turns\nlist under `free` a joint that its own drive moves alone"
            )
    for row in chain.passive:
        joint = _turned_apart(chain, row)
        if joint:
            raise UnsolvedError(
                f"the passive row {row.label}: {row.apart}, and least squares do not take it "
                f"either: a whole turn of joint {chain.named([joint])} would move the tool"
            )


def _given_apart(chain: Chain, moves: FloatArray) -> int:
    """The number of a given joint that is elsewhere after a whole turn; zero without any.

    Args:
        chain: The arm.
        moves: By how much the turn moves every drive: given ones must not move.
    """
    for number in chain.free:
        joint = chain.joints[number - 1]
        others = (share for share in joint.shares if share.drive not in chain.free)
        turns = sum(share.factor * moves[share.drive - 1] for share in others) / TURN
        turned = joint.kind is JointKind.REVOLUTE
        if abs(turns - round(turns) if turned else turns) > NOTHING:
            return number
    return 0


def _turned_apart(chain: Chain, row: Passive) -> int:
    """The number of a joint whose whole turns move a passive row by less; zero without any."""
    inverse = chain.drives.inverse
    for joint, turns in enumerate(chain.turning, start=1):
        moved = sum(share.factor * inverse[share.drive - 1, joint - 1] for share in row.shares)
        still = abs(moved - round(moved) if row.turns else moved) < NOTHING
        if turns and not still:
            return joint
    return 0

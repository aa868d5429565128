"""Couplings that only least squares take: passive rows of other kinds, and joints half given."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.errors import UnsolvedError
from dhgen.kinematics.turns import coupled_turns
from dhgen.paul.refusal.unsolved import NUMERICAL

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain, Passive

NOTHING = 1e-9  # what rounding leaves of whole turns, and of a length for a turn [1, length/rad]


def demand_given_alone(chain: Chain) -> None:
    """Refuses free joints that are moved by drives which are solved for, too.

    Raises:
        UnsolvedError: There is one: its equations hold a sum of what is given and what is not.
    """
    for number in chain.free:
        others = _solved_that_move(chain, number)
        if not others:
            continue
        name, also = chain.told([number]), chain.told([*others])
        plural, free = "s" * (len(others) > 1), sorted({*chain.free, *others})
        raise UnsolvedError(
            f"joint {name} is free, but the drive{plural} of joint{plural} {also} "
            f"{'move' if plural else 'moves'} it, too: its angle or length is not known "
            f"from what is given\nlist under `free` a joint that its own drive moves alone, or "
            f"joint{plural} {also} besides: free: {free}\n{NUMERICAL}"
        )


def demand_sums(chain: Chain) -> None:
    """Refuses passive rows whose angles and lengths are no sums of those of joints before them.

    Raises:
        UnsolvedError: There is one.
    """
    for row in chain.passive:
        if row.apart:
            advice = "" if _turned_apart(chain, row) else f"\n{NUMERICAL}"
            raise UnsolvedError(f"the passive row {row.label}: {row.apart}{advice}")


def demand_whole_turns(chain: Chain) -> None:
    """Refuses joints and passive rows that whole turns of others move.

    Least squares tell joint values without turns.

    Raises:
        UnsolvedError: There is one.
    """
    turns = coupled_turns(chain)
    for drive, moves in zip(turns.drives, turns.moves, strict=True) if turns else ():
        others = [joint for joint, move in enumerate(moves, start=1) if move and joint != drive]
        if others:
            raise UnsolvedError(
                f"least squares do not take this coupling: a whole turn of joint "
                f"{chain.told([drive])} would move joint {chain.told(others[:1])}"
            )
    for row in chain.passive:
        joint = _turned_apart(chain, row)
        if joint:
            raise UnsolvedError(
                f"the passive row {row.label}: {row.apart}, and least squares do not take it "
                f"either: a whole turn of joint {chain.told([joint])} would move the tool"
            )


def _turned_apart(chain: Chain, row: Passive) -> int:
    """The number of a joint whose whole turns move a passive row by less; zero without any."""
    inverse = chain.drives.inverse
    for joint, turns in enumerate(chain.turning, start=1):
        moved = sum(share.factor * inverse[share.drive - 1, joint - 1] for share in row.shares)
        still = abs(moved - round(moved) if row.turns else moved) < NOTHING
        if turns and not still:
            return joint
    return 0


def is_given_alone(chain: Chain) -> bool:
    """Whether the angles and lengths of free joints hang on given values only."""
    return not any(_solved_that_move(chain, number) for number in chain.free)


def _solved_that_move(chain: Chain, number: int) -> list[int]:
    """The drives of others that move a joint, and are not given."""
    shares = chain.joints[number - 1].shares
    return sorted(share.drive for share in shares if share.drive not in chain.free)

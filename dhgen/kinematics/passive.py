"""Passive rows: what they add to a chain, and which angles they leave in its equations."""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING

from dhgen.errors import UnsolvedError
from dhgen.kinematics.chain import Passive, added_up, parallel_groups, turning_runs

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.kinematics.chain import Chain

Run = tuple[tuple[int, int], ...]


def demand_sums(chain: Chain) -> None:
    """Refuses passive rows that leave angles other than sums of consecutive parallel axes.

    Raises:
        UnsolvedError: There is one.
    """
    if not chain.passive:
        return
    runs = parallel_groups(chain)
    for run in turning_runs(chain):
        turned = [
            tuple((joint, facing * times) for joint, times in element.signed)
            if isinstance(element, Passive)
            else ((element.joint, facing),)
            for element, facing in run
        ]
        for start, end in combinations(range(len(turned) + 1), 2):
            total = added_up(term for terms in turned[start:end] for term in terms)
            if total and not _is_sum(total, runs):
                raise UnsolvedError(
                    f"the passive rows leave the angle {signed_sum(total)} in the equations, which "
                    "is no sum of the angles of consecutive parallel axes"
                )


def _is_sum(total: Run, runs: Sequence[Run]) -> bool:
    """Whether angles that are added are those of consecutive joints of a run, each once."""
    wanted = tuple(sorted(total))
    run = next(run for run in runs if wanted[0][0] in dict(run))
    first = [joint for joint, _ in run].index(wanted[0][0])
    found = run[first : first + len(wanted)]
    return wanted in (found, tuple((joint, -facing) for joint, facing in found))


def signed_sum(terms: Iterable[tuple[int, int]]) -> str:
    """A sum of angles in words: theta2 - 2 theta3."""
    words = ""
    for joint, times in sorted(terms):
        sign = (" - " if times < 0 else " + ") if words else "-" * (times < 0)
        words += sign + f"{abs(times)} " * (abs(times) > 1) + f"theta{joint}"
    return words

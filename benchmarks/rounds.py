"""Timing on a machine that others use too: many short turns, taken in rotation."""

from __future__ import annotations

import statistics
from dataclasses import dataclass
from typing import TYPE_CHECKING

from benchmarks.contestant import Absentee

if TYPE_CHECKING:
    from collections.abc import Sequence

    from benchmarks.contestant import Contestant, Run
    from dhgen.arrays import FloatArray

TURN = 0.01  # CPU seconds that a turn should take at least
LONGEST = 0.25  # and about at most: slow solvers take fewer poses
FEWEST = 25  # but no fewer than these


@dataclass(frozen=True, slots=True)
class Timing:
    """CPU time of solving a pose, all solutions.

    Attributes:
        least: The least over the rounds [ns].
        median: Their median [ns].
        poses: How many poses a round went through.
    """

    least: float
    median: float
    poses: int


@dataclass(frozen=True, slots=True)
class _Turn:
    run: Run
    repeats: int
    poses: int

    def take(self) -> float:
        return 1e9 * self.run(self.repeats) / (self.repeats * self.poses)


def time_all(contestants: Sequence[Contestant], T: FloatArray, rounds: int) -> list[Timing]:
    """Times contestants on the same poses (N, 4, 4), in rotation, so that all see the same noise.

    Args:
        contestants: Who.
        T: The poses; who needs more than LONGEST for them takes the first ones only.
        rounds: How often everybody's turn comes.
    """
    turns = [_turn(each, T) for each in contestants]
    taken: list[list[float]] = [[] for _ in turns]
    for round_ in range(rounds):
        for place in range(len(turns)):
            who = (place + round_) % len(turns)
            taken[who].append(turns[who].take())
    return [
        Timing(min(times), statistics.median(times), turn.poses)
        for times, turn in zip(taken, turns, strict=True)
    ]


def try_all(
    contestants: Sequence[Contestant], T: FloatArray
) -> tuple[list[Contestant], list[Absentee]]:
    """Who gets through a few of the poses (N, 4, 4), and what happened to the others."""
    able, failed = [], []
    for contestant in contestants:
        try:
            contestant.solve(T[:FEWEST])
            contestant.prepare(T[:FEWEST])(1)
        except Exception as error:  # noqa: BLE001 - whatever it is, the run goes on and says so
            failed.append(Absentee(contestant.label, f"{type(error).__name__}: {error}"))
        else:
            able.append(contestant)
    return able, failed


def _turn(contestant: Contestant, T: FloatArray) -> _Turn:
    """How many poses and repeats make a turn of a good length; warms up on the way."""
    few = contestant.prepare(T[:FEWEST])
    few(1)
    slow = max(few(1), 1e-9) / FEWEST
    poses = min(len(T), max(FEWEST, int(LONGEST / slow)))
    run = contestant.prepare(T[:poses])
    once = max(run(1), 1e-9)
    return _Turn(run, max(1, round(TURN / once)), poses)

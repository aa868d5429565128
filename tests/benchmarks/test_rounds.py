"""Turns come in rotation, are long enough to be measured and short enough to be many."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
import pytest

from benchmarks.contestant import Contestant
from benchmarks.rounds import FEWEST, LONGEST, time_all, try_all

if TYPE_CHECKING:
    from benchmarks.contestant import Run


@dataclass
class Bench:
    """A solver that claims to take a given time, and remembers when it was called."""

    seconds: float
    order: list[str]
    poses: list[int] = field(default_factory=list)

    def entry(self, name: str) -> Contestant:
        def prepare(T: np.ndarray) -> Run:
            self.poses.append(len(T))

            def run(repeats: int) -> float:
                self.order.append(name)
                return self.seconds * len(T) * repeats

            return run

        return Contestant(name, "faked", lambda T: [np.zeros((1, 6))] * len(T), prepare)


def test_everybody_takes_a_turn_in_every_round_and_nobody_is_always_first() -> None:
    order: list[str] = []
    everybody = [Bench(1e-7, order).entry(name) for name in "abc"]
    time_all(everybody, np.zeros((100, 4, 4)), 4)
    turns = order[-12:]
    rounds = [turns[k : k + 3] for k in range(0, 12, 3)]
    assert [sorted(each) for each in rounds] == [list("abc")] * 4
    assert [each[0] for each in rounds] == ["a", "b", "c", "a"]


@pytest.mark.parametrize("seconds", [2e-8, 5e-6, 1e-3, 1.0])
def test_times_are_those_of_a_pose(seconds: float) -> None:
    (timing,) = time_all([Bench(seconds, []).entry("a")], np.zeros((1000, 4, 4)), 3)
    assert timing.least == pytest.approx(1e9 * seconds)
    assert timing.median == pytest.approx(1e9 * seconds)


def test_the_slow_take_fewer_poses() -> None:
    fast, slow, slowest = (Bench(seconds, []) for seconds in (1e-6, 1e-3, 1.0))
    T = np.zeros((1000, 4, 4))
    timings = time_all([each.entry("a") for each in (fast, slow, slowest)], T, 1)
    assert [timing.poses for timing in timings] == [1000, int(LONGEST / 1e-3), FEWEST]


def test_who_fails_is_named_with_the_reason() -> None:
    def fail(_: np.ndarray) -> list[np.ndarray]:
        raise ArithmeticError("no such luck")

    good = Bench(1e-7, []).entry("good")
    bad = Contestant("bad", "faked", fail, good.prepare)
    able, failed = try_all([bad, good], np.zeros((30, 4, 4)))
    assert able == [good]
    assert [(each.tool, each.why) for each in failed] == [
        ("bad, faked", "ArithmeticError: no such luck")
    ]

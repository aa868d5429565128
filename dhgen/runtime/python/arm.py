# SPDX-License-Identifier: MIT
"""An arm as the runtime around closed forms sees it: its numbers, and functions of its own.

The numbers are one array, see `places`. The robot's functions come with it by their addresses, in
the order of SOLVE ...: what calls them is compiled once for all robots.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .jit import calling
from .places import (
    CHOOSABLE,
    ENTRIES,
    GIVEN_JOINTS,
    JOINTS,
    MISS_WEIGHTS,
    RECORD,
    RETRIES,
    TOGETHER,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .arrays import Floats

SOLVE, FK, JACOBIAN, COMPLETE = range(4)  # places among the robot's functions
ROBOT = "UniTuple(int64, 4)"  # what holds them, in numba's words
POSE = "UniTuple(float64, 12)"  # the upper three rows
# pose, q_free, seed, moved, q, status: fills the rows of branches that have a solution; roots of
# polynomials are moved by an angle
SOLVES = f"void({POSE}, float64[::1], float64[::1], float64, float64[:, ::1], uint8[::1])"
# pose, q_free, seed, begun, q, status: works on all rows where roots of polynomials nearly meet or
# rows miss the pose; begun is the first row that was not simply out of reach, or negative
COMPLETES = f"void({POSE}, float64[::1], float64[::1], int64, float64[:, ::1], uint8[::1])"

Robot = tuple[int, int, int, int]
Pose = tuple[float, ...]

solve_at, complete_at = calling(SOLVES), calling(COMPLETES)
fk_at = calling("float64[:, ::1](float64[::1])")
jacobian_at = calling("float64[:, ::1](float64[::1])")

# What may have to be done around the formulas.
STEPS = (
    "retries",  # other values of free joints may reach
    "checks",  # they may also meet the pose
    "keeps limits",  # they may keep limits
    "regular",  # regular poses are left to fast code
    "completes",  # the robot's own function works on all rows
    "merges",  # branches that meet may come out apart
    "refines",  # rows need refining before they are compared
    "clamps",  # joints are clamped to limits
    "clamps far",  # from far away, too
    "winds",  # a range exceeds a turn, or nearly
    "follows seed",  # where rounding can't tell solutions apart
)


@dataclass(frozen=True, slots=True)
class Arm:
    """An arm, and what has to be done around its formulas.

    Attributes:
        types: R or P for every joint.
        limits: Of every joint, infinite where it has none [rad or length].
        slacks: By what its value may miss them.
        weights: Of squared differences of its values.
        paces: What a step of one means in refining; 0 if the caller gives the value.
        fan_steps: From one value to the next where it is free; may be left out where none is.
        rows: How many branches there are.
        directions: What a pose names besides coordinates: "none", "pointing" or "rotation".
        miss_weights: What the entries of a miss count, first the translation's.
        size: Of the arm.
        entries: Places of a pose's entries that are asked then.
        steps: What has to be done, by the names in STEPS.
        given: Joints whose values the caller gives, from 0.
        choosable: Joints that may be free, the last first.
        together: Joints that may have to be chosen together.
        cuts: Of an interval by golden section.
    """

    types: str
    limits: Sequence[tuple[float, float]]
    slacks: tuple[float, ...]
    weights: tuple[float, ...]
    paces: tuple[float, ...]
    fan_steps: tuple[float, ...]
    rows: int
    directions: str
    miss_weights: tuple[float, ...]
    size: float
    entries: tuple[int, ...] = ()
    steps: tuple[str, ...] = ()
    given: tuple[int, ...] = ()
    choosable: tuple[int, ...] = ()
    together: tuple[int, ...] = ()
    cuts: int = 0


def arm_numbers(arm: Arm) -> Floats:
    """The array of an arm.

    Raises:
        ValueError: A step has no name in STEPS.
    """
    numbers = np.zeros(JOINTS + RECORD * len(arm.types))
    directions = ("none", "pointing", "rotation").index(arm.directions)
    numbers[:5] = len(arm.types), arm.rows, directions, arm.cuts, 1.0 / arm.size
    numbers[MISS_WEIGHTS : MISS_WEIGHTS + 6] = arm.miss_weights
    for step in arm.steps:
        if step not in STEPS:
            raise ValueError(f"no step is called {step!r}")
        numbers[RETRIES + STEPS.index(step)] = 1.0
    lists = (
        (GIVEN_JOINTS, arm.given),
        (CHOOSABLE, arm.choosable),
        (TOGETHER, arm.together),
        (ENTRIES, arm.entries),
    )
    for at, places in lists:
        numbers[at : at + 1 + len(places)] = len(places), *places
    steps = arm.fan_steps or (0.0,) * len(arm.types)
    records = zip(arm.types, arm.limits, arm.slacks, arm.weights, arm.paces, steps, strict=True)
    for joint, (kind, (low, high), slack, weight, pace, step) in enumerate(records):
        at = JOINTS + RECORD * joint
        numbers[at : at + RECORD] = (
            low - slack, high + slack, kind == "R", weight, slack, pace, step,
        )  # fmt: skip
    return numbers

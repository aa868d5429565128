# SPDX-License-Identifier: MIT
"""An arm as the runtime around closed forms sees it: its numbers, and functions of its own.

The numbers are one array, see `places`. The robot's functions come with it by their addresses, in
the order of SOLVE ...: what calls them is compiled once for all robots.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .jit import calling, of_file
from .places import (
    CALIBRATION,
    CHOOSABLE,
    CLAMPED,
    CLAMPED_AGAIN,
    COUPLING,
    DESCENTS,
    ENTRIES,
    GIVEN_JOINTS,
    JOINTS,
    MISS_WEIGHTS,
    NAMES,
    RECORD,
    RETRIES,
    ROOT_TURNS,
    TOGETHER,
)
from .tolerances import LIMIT, MERGE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .arrays import Floats

OWN = of_file(__file__)

SOLVE, FK, JACOBIAN, ARM_ANGLE, ARM_ANGLE_MISS = range(5)  # places among the robot's functions
ROBOT = "UniTuple(int64, 5)"  # what holds them, in numba's words
POSE = "UniTuple(float64, 12)"  # the upper three rows
# pose, q_free, seed, moved, q, status: fills the rows of branches that have a solution; roots of
# polynomials are moved by an angle
SOLVES = f"void({POSE}, float64[::1], float64[::1], float64, float64[:, ::1], uint8[::1])"
# pose (3, 4), q_free, q, off: by how much q misses the arm angle, and how fast joints 1, 2 and 3
# change that
MISSES = "void(float64[:, ::1], float64[::1], float64[::1], float64[::1])"

Robot = tuple[int, int, int, int, int]
Pose = tuple[float, ...]

solve_at, miss_at = calling(SOLVES), calling(MISSES)
fk_at = calling("float64[:, ::1](float64[::1])")
jacobian_at = calling("float64[:, ::1](float64[::1])")
arm_angle_at = calling("float64(float64[::1])")


@OWN.inner
def descents_of(arm: Floats) -> Floats:
    """The numbers of an arm that descents work on."""
    return arm[int(arm[DESCENTS]) :]


# What may have to be done around the formulas.
STEPS = (
    "retries",  # other values of free joints may reach
    "checks",  # they may also meet the pose
    "keeps limits",  # they may keep limits
    "completes",  # rows may miss their pose, be lost or nearly meet
    "adds others",  # a joint may have one of a few values: all of them are rows
    "ascends",  # rows are the roots of a polynomial, in their order
    "equations end all",  # rows of a pose that has solutions, where it is not regular
    "merges",  # branches that meet may come out apart
    "refines",  # rows need refining before they are compared
    "clamps",  # joints are clamped to limits
    "clamps far",  # from far away, too
    "range exceeds a turn",  # a range exceeds a turn, or nearly
    "follows seed",  # where solutions differ by less than rounding
)

# Of an angle: by what it may miss its limits, its weight, its pace and its step where it is free.
OF_ANGLES = (LIMIT, 1.0, 1.0, math.pi / 32)
CLAMPED_WITHIN = MERGE


@dataclass(frozen=True, slots=True)
class Arm:
    """An arm, and what has to be done around its formulas.

    Attributes:
        types: R or P for every joint.
        limits: Of every joint, infinite where it has none [rad or length].
        rows: How many branches there are.
        directions: What a pose names besides coordinates: one of `places.NAMES`.
        miss_weights: What the entries of a miss count, first the translation's.
        size: Of the arm.
        slacks: By how much the value of each joint may miss its limits. This and the next three are
            left out where all joints have those of angles.
        weights: Of squared differences of each joint's values.
        paces: How far each joint moves in a step of one of refining; 0 if the caller gives its
            value.
        fan_steps: From one value of each joint to the next that is tried where it is free.
        clamped: A joint is clamped to a limit if the pose is missed by so much more at most.
        clamped_again: And where no row is inside limits then.
        entries: Places of a pose's entries that are asked then.
        steps: What has to be done, by the names in STEPS.
        given: Joints whose values the caller gives, from 0.
        choosable: Joints that may be free, the last first.
        together: Joints that may have to be chosen together.
        root_turns: Joints whose values add up to a root of a polynomial, each with its sign.
        cuts: Of an interval by golden section.
    """

    types: str
    limits: Sequence[tuple[float, float]]
    rows: int
    directions: str
    miss_weights: tuple[float, ...]
    size: float
    slacks: tuple[float, ...] = ()
    weights: tuple[float, ...] = ()
    paces: tuple[float, ...] = ()
    fan_steps: tuple[float, ...] = ()
    clamped: float = CLAMPED_WITHIN
    clamped_again: float = CLAMPED_WITHIN
    entries: tuple[int, ...] = ()
    steps: tuple[str, ...] = ()
    given: tuple[int, ...] = ()
    choosable: tuple[int, ...] = ()
    together: tuple[int, ...] = ()
    root_turns: tuple[tuple[int, float], ...] = ()
    cuts: int = 52


def arm_numbers(
    arm: Arm,
    descents: Sequence[float] | Floats = (),
    *,
    coupling: Sequence[float] | Floats = (),
    calibration: Sequence[float] | Floats = (),
) -> Floats:
    """The array of an arm.

    Args:
        arm: The arm.
        descents: The numbers that descents work on, where rows are completed by such.
        coupling: Those of drives whose whole turns hang together, where some do.
        calibration: The numbers of a table that comes at run time, where one does.

    Raises:
        ValueError: A step has no name in STEPS.
    """
    begin = JOINTS + RECORD * len(arm.types)
    behind = begin + len(descents)
    last = behind + len(coupling)
    numbers = np.zeros(last + len(calibration))
    numbers[DESCENTS], numbers[begin:behind] = begin, descents
    numbers[COUPLING], numbers[behind:last] = behind if len(coupling) else 0, coupling
    numbers[CALIBRATION], numbers[last:] = last if len(calibration) else 0, calibration
    directions = NAMES.index(arm.directions)
    numbers[:5] = len(arm.types), arm.rows, directions, arm.cuts, 1.0 / arm.size
    numbers[MISS_WEIGHTS : MISS_WEIGHTS + 6] = arm.miss_weights
    numbers[CLAMPED], numbers[CLAMPED_AGAIN] = arm.clamped, arm.clamped_again
    for step in arm.steps:
        if step not in STEPS:
            raise ValueError(f"no step is called {step!r}")
        numbers[RETRIES + STEPS.index(step)] = 1.0
    lists = (
        (GIVEN_JOINTS, arm.given),
        (CHOOSABLE, arm.choosable),
        (TOGETHER, arm.together),
        (ENTRIES, arm.entries),
        (ROOT_TURNS, [x for turn in arm.root_turns for x in turn]),
    )
    for at, places in lists:
        numbers[at : at + 1 + len(places)] = len(places), *places
    columns = zip((arm.slacks, arm.weights, arm.paces, arm.fan_steps), OF_ANGLES, strict=True)
    filled = (column or (usual,) * len(arm.types) for column, usual in columns)
    records = zip(arm.types, arm.limits, *filled, strict=True)
    for joint, (kind, (low, high), slack, weight, pace, step) in enumerate(records):
        at = JOINTS + RECORD * joint
        numbers[at : at + RECORD] = (
            low - slack, high + slack, kind == "R", weight, slack, pace, step,
        )  # fmt: skip
    return numbers

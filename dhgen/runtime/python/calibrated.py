# SPDX-License-Identifier: MIT
"""Arms of one kind, each with a table of its own, or origins: what calibrated.h does.

An arm's numbers are computed from it once (`calibrate`), and read by every call. The closed form of
the nominal arm is tried first (`solve_from_nominal` in calls_calibrated.py, made anew for each
kind); where a solution may lie next to none of its rows the general algorithm solves the pose.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .arm import arm_numbers
from .calibrate import (
    COUNTED,
    IS_MODIFIED,
    JOINTS,
    LENGTH,
    MEETING,
    NUMBERS_OF_KIND,
    PARALLEL,
    TABLE,
    E,
    Z,
)
from .calibration import FACING, MORE, NOMINAL, NUMBERS
from .frames import IDENTITY
from .general.arm import Link, Loop, general_numbers
from .general.places import LINK_COUNT
from .general.postures import rows_filled
from .jit import of_file
from .numerical.arm import Arm as Descents
from .numerical.arm import ChainJoint, Joint
from .rigid import pose_of_links

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .arm import Arm
    from .arrays import Floats, Ints
    from .general.arm import Formulation

OWN = of_file(__file__)
inner = OWN.inner


@dataclass(frozen=True, slots=True)
class Kind:
    """What calibrated arms of a kind have in common.

    Attributes:
        arm: What is done around their rows.
        table: That of the data sheet, (6, 4).
        convention: What its rows are: `standard` or `modified`.
        base: The arm's base in the caller's frame, twelve numbers.
        tool: The tool in the last frame.
        facing: How joints count, 1 or -1.
        parallel: First axes, from 0, of three side by side that are parallel.
        meeting: Of three that meet.
        reach: The square of what is out of reach for all links of the loop in line [arm sizes].
        advances: Cosine and sine of what is added to each joint's angle in it.
        formulations: Of the general algorithm, in the order in which they are tried.
    """

    arm: Arm
    table: Sequence[Sequence[float]]
    convention: str
    facing: tuple[float, ...]
    reach: float
    advances: tuple[tuple[float, float], ...]
    formulations: tuple[Formulation, ...]
    base: tuple[float, ...] = IDENTITY
    tool: tuple[float, ...] = IDENTITY
    parallel: tuple[int, ...] = ()
    meeting: tuple[int, ...] = ()


def kind_numbers(kind: Kind) -> Floats:
    """The array of a kind."""
    numbers = np.zeros(NUMBERS_OF_KIND)
    numbers[IS_MODIFIED], numbers[LENGTH] = kind.convention == "modified", kind.arm.size
    numbers[Z : Z + 12], numbers[E : E + 12] = kind.base, kind.tool
    numbers[COUNTED : COUNTED + JOINTS] = kind.facing
    for first, places in ((PARALLEL, kind.parallel), (MEETING, kind.meeting)):
        for place in places:
            numbers[first + place] = 1.0
    numbers[TABLE:] = np.ravel(kind.table)
    return numbers


def blank_numbers(kind: Kind) -> Floats:
    """The array of an arm of which no table is known."""
    arm = kind.arm
    joints = tuple(
        Joint(place=place, lowest=low, highest=high, facing=facing)
        for place, ((low, high), facing) in enumerate(zip(arm.limits, kind.facing, strict=True))
    )
    descents = Descents(
        rows=arm.rows,
        size=arm.size,
        coordinates=(0, 1, 2),
        directions=arm.directions,
        joints=joints,
        base=IDENTITY,
        chain=tuple(ChainJoint(after=IDENTITY, sign=facing) for facing in kind.facing),
    )
    loop = Loop(
        size=1.0,
        reach=kind.reach,
        links=(Link(IDENTITY),) * LINK_COUNT,
        advances=kind.advances,
        formulations=kind.formulations,
    )
    calibration = np.full(NUMBERS, math.nan)
    return arm_numbers(arm, general_numbers(descents, loop), calibration=calibration)


@inner
def near_angles(of: Floats, filled: Floats, places: Ints) -> tuple[Ints, Floats]:
    """Returns the nominal arm's rows that hold a solution, and their angles of the loop, (k, 6).

    Args:
        of: The numbers of the calibrated arm.
        filled: What the formulas of regular poses fill in: joints' values, then statuses.
        places: Of the joints' values of each row, (rows, 6).
    """
    rows = rows_filled(filled, len(places))
    nearby = np.empty((len(rows), JOINTS))
    for k in range(len(rows)):
        for i in range(JOINTS):
            nearby[k, i] = of[FACING + i] * filled[places[rows[k], i]] - of[MORE + i]
    return rows, nearby


@inner
def nominal_pose(of: Floats, q: Floats, values: Floats) -> Floats:
    """Returns the nominal arm's pose at joint values of this arm; fills in its own."""
    angles = np.empty(JOINTS)
    for i in range(JOINTS):
        angles[i] = of[FACING + i] * q[i]
        values[i] = of[FACING + i] * (angles[i] + of[MORE + i])
    return pose_of_links(of, NOMINAL, angles)

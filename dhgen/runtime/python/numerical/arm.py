# SPDX-License-Identifier: MIT
"""The array of an arm's numbers: made once, from what its file holds, in the order of places.py."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..places import NAMES
from .places import JOINTS, LINKS, LOOP

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..arrays import Floats

RESIDUAL = 1e-10  # what counts as a solution [arm sizes, rad]: as for one that was refined
ROUNDED_RESIDUAL = (
    1e-5  # the same of a pose that is checked, and may have been rounded to six digits
)
# How many numbers measure the miss of directions.
MISSES = dict(zip(NAMES, (0, 3, 3, 1, 1, 2), strict=True))
ITERATIONS = 60  # of the fixed point iteration; each wins a digit in base two at least


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint that is solved for.

    Attributes:
        place: In the arm, from 0.
        turns: Whether it turns; else it slides.
        lowest: Its limits [rad or length], infinite without any.
        highest: The same.
        facing: Its sign in the loop of the general algorithm.
        zero: What is added to its value there.
    """

    place: int
    turns: bool = True
    lowest: float = -math.inf
    highest: float = math.inf
    facing: float = 1.0
    zero: float = 0.0


@dataclass(frozen=True, slots=True)
class ChainJoint:
    """A joint or a passive row of the forward model, and the transform behind it.

    Attributes:
        after: The rigid transform behind it, twelve numbers.
        turns: Whether it turns; else it slides.
        sign: Of its value; 0 for a passive row, which has none.
        offset: What is added to that.
        shares: What other joints' values add: their places, from 0, and factors.
    """

    after: tuple[float, ...]
    turns: bool = True
    sign: float = 1.0
    offset: float = 0.0
    shares: tuple[tuple[int, float], ...] = ()


@dataclass(frozen=True, slots=True)
class Drives:
    """Drives of which one moves more than its own joint.

    Attributes:
        back: Of each that is solved for, what it has of every joint's angle or length.
        turned: Those that turn, by their places among these, each before those that its whole turns
            move, and what such a turn moves, in units; empty where turns are each drive's own.
    """

    back: tuple[tuple[float, ...], ...]
    turned: tuple[tuple[int, tuple[float, ...]], ...] = ()


@dataclass(frozen=True, slots=True)
class Arm:
    """An arm and its task.

    Attributes:
        rows: Solutions that are kept.
        size: Of the arm: a step of one, for lengths [file's unit].
        coordinates: Rows of the translation that the task names.
        directions: What else it names: one of `places.NAMES`.
        joints: Those that are solved for.
        base: The rigid transform before the first joint, twelve numbers.
        chain: All joints and passive rows.
        order: Places in it, each behind those of joints that have a share in it; empty where none
            has.
        free: Places of the joints whose values the caller gives.
        redundant: Whether every pose has infinitely many solutions.
        checked: Whether the task names more than the joints can choose.
        arm_angle: Whether the caller gives the arm angle: one more equation.
        drives: How these hang together, where one moves more than its own joint.
    """

    rows: int
    size: float
    coordinates: tuple[int, ...]
    directions: str
    joints: tuple[Joint, ...]
    base: tuple[float, ...]
    chain: tuple[ChainJoint, ...]
    free: tuple[int, ...] = ()
    redundant: bool = False
    checked: bool = False
    arm_angle: bool = False
    order: tuple[int, ...] = ()
    drives: Drives | None = None


def strides(dimension: int) -> tuple[float, ...]:
    """Returns what is added, modulo one, from start to start: powers of 1 / x with x^(n+1) = x + 1.

    M. Roberts, The unreasonable effectiveness of quasirandom sequences (2018): for one dimension
    the golden ratio, for more its generalisation.
    """
    ratio = 2.0
    for _ in range(ITERATIONS):
        ratio = _root(1.0 + ratio, dimension + 1)
    powers, power = [], 1.0
    for _ in range(dimension):
        power /= ratio
        powers.append(power)
    return tuple(powers)


def _root(value: float, degree: int) -> float:
    """Returns the root of a degree by Newton's method: a library's own may round differently."""
    x = value
    for _ in range(ITERATIONS * degree):
        power = 1.0
        for _ in range(degree - 1):
            power *= x
        x -= (x * power - value) / (degree * power)
    return x


def arm_numbers(
    arm: Arm, loop: Sequence[float] = (), lists: Sequence[Sequence[float]] = ()
) -> Floats:
    """Returns the array of an arm.

    Args:
        arm: The arm and its task.
        loop: The general algorithm's numbers of its loop, from LOOP on.
        lists: Lists of it, which come last; the places where they begin follow `loop`.
    """
    stride = strides(len(arm.joints))
    joints = [
        x for joint, each in zip(arm.joints, stride, strict=True) for x in _joint(arm, joint, each)
    ]
    chain = [*arm.base]
    for link in arm.chain:
        chain += [float(link.turns), link.sign, link.offset, *link.after]
    shares = [(place, *share) for place in arm.order for share in arm.chain[place].shares]
    chain += [float(len(shares)), *(float(x) for share in shares for x in share)]
    limited = any(j.lowest > -math.inf or j.highest < math.inf for j in arm.joints)
    dof = sum(link.sign != 0.0 for link in arm.chain)
    entries = len(arm.coordinates) + MISSES[arm.directions] + arm.arm_angle
    head = [
        *(dof, len(arm.joints), entries, arm.rows, len(arm.free), arm.size),
        ROUNDED_RESIDUAL if arm.checked else RESIDUAL,
        *(len(arm.coordinates), *arm.coordinates, *[0] * (3 - len(arm.coordinates))),
        NAMES.index(arm.directions),
        *(arm.redundant, limited, arm.checked, arm.arm_angle),
    ]
    own = [[*map(float, arm.free)], chain, _drives(arm.drives)]
    numbers = _joined(head, joints, own, loop, lists)
    numbers[LINKS] = len(arm.chain)
    return numbers


def _drives(drives: Drives | None) -> list[float]:
    """Returns the list of how drives hang together."""
    if drives is None:
        return [0.0, 0.0]
    turned = [x for place, moves in drives.turned for x in (float(place), *moves)]
    return [float(len(drives.turned)), *turned, 1.0, *(x for row in drives.back for x in row)]


def _joint(arm: Arm, joint: Joint, stride: float) -> tuple[float, ...]:
    """Returns the record of a joint that is solved for."""
    unit, wide = (1.0, math.pi) if joint.turns else (arm.size, 1.0)
    low, high = joint.lowest / unit, joint.highest / unit
    start = low if low > -math.inf else -wide
    width = (high if high < math.inf else wide) - start
    measure = unit / arm.size
    turns = float(joint.turns)
    return (
        joint.place,
        turns,
        unit,
        low,
        high,
        start,
        width,
        stride,
        measure,
        joint.facing,
        joint.zero,
    )


def _joined(
    head: Sequence[float],
    joints: Sequence[float],
    own: Sequence[Sequence[float]],
    loop: Sequence[float],
    lists: Sequence[Sequence[float]],
) -> Floats:
    """Returns the array from its parts, with the places where its lists begin."""
    at, begins = JOINTS + len(joints), []
    for each in (*own, *lists):
        begins.append(at)
        at += len(each)
    numbers = np.zeros(at)
    numbers[: len(head)] = head
    numbers[len(head) : len(head) + len(own)] = begins[: len(own)]
    numbers[LOOP : LOOP + len(loop)] = loop
    numbers[LOOP + len(loop) : LOOP + len(loop) + len(lists)] = begins[len(own) :]
    numbers[JOINTS : JOINTS + len(joints)] = joints
    for begin, each in zip(begins, (*own, *lists), strict=True):
        numbers[begin : begin + len(each)] = each
    return numbers

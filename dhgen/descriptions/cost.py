"""What a reader likes in a table: zeros first, then right angles, few lengths, few signs.

The numbers weigh one cell against another: a length that is not zero is a letter in every equation
of its row, a right twist changes a sign, and a frame before or after the table is one more matrix.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.descriptions.rotations import to_rpy

if TYPE_CHECKING:
    from dhgen.descriptions.lines import Arm
    from dhgen.descriptions.rotations import Placed

LENGTH = 2.0
MINUS = 0.3  # a sign before a length
BACKWARDS = 0.7  # -q
FRAME = 0.5  # that there is a frame at all
TURNED = 1.5  # and that it is turned
OFFSET = 1.0  # an angle beside q
TWIST = 0.5
HALF_TURN = 1.2
OBLIQUE = 3.0  # an angle that is no multiple of a right one
NEGATIVE = 0.02  # -pi/2 beside pi/2: a tie is decided
BESIDE_SLIDE = 0.5  # a length beside a slide's variable: a frame before or after can have it
LATE = 0.01  # offsets along parallel axes: the last row of them has it
_RIGHT = math.pi / 2


def angle_cost(angle: float, near: float, right: float, half: float) -> float:
    """The cost of an angle: nothing where it is zero.

    Args:
        angle: In rad.
        near: What counts as right.
        right: The cost of a right angle.
        half: The cost of a half turn.
    """
    turns = round(angle / _RIGHT)
    if abs(angle - turns * _RIGHT) > near:
        return OBLIQUE + right
    return (0.0, right, half, right + NEGATIVE)[turns % 4]


def length_cost(length: float, negligible: float) -> float:
    """The cost of a length: nothing where it is zero."""
    if abs(length) < negligible:
        return 0.0
    return LENGTH + MINUS * (length < 0.0)


def row_cost(turn: float, offset: float, arm: Arm, number: int) -> float:
    """The cost of what a row has along its joint's axis.

    Args:
        turn: The angle.
        offset: The length.
        arm: The arm of the row.
        number: The number of the row, from zero.
    """
    along = length_cost(offset, arm.negligible)
    if along and not arm.axes[number].turns:
        along += BESIDE_SLIDE
    left = len(arm.axes) - number
    return angle_cost(turn, arm.near, OFFSET, HALF_TURN) + along * (1.0 + LATE * left)


def link_cost(length: float, twist: float, arm: Arm) -> float:
    """The cost of what a row has along the common normal."""
    return angle_cost(twist, arm.near, TWIST, HALF_TURN) + length_cost(length, arm.negligible)


def frame_cost(frame: Placed, arm: Arm) -> float:
    """Of a frame before the first row or after the last."""
    rpy = to_rpy(frame[0])
    turns = math.fsum(angle_cost(angle, arm.near, TWIST, TWIST) for angle in rpy)
    lengths = math.fsum(length_cost(length, arm.negligible) for length in frame[1])
    return turns + lengths + (FRAME if turns or lengths else 0.0) + (TURNED if turns else 0.0)

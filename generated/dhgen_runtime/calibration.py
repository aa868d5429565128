# SPDX-License-Identifier: MIT
"""What a table makes of a calibrated arm: where its numbers stand, in the order of calibration.h.

They are worked out once and stand in the arm's array behind all others, from `arm[CALIBRATION]` on.
Transforms are three rows of four.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .jit import of_file
from .places import CALIBRATION

if TYPE_CHECKING:
    from .arrays import Floats

OWN = of_file(__file__)

CONSTANT = 0  # C0 ... C6 of T = C0 J(q1) C1 ... J(q6) C6
FACING = 84  # six: whether a joint counts its angle forwards, 1, or back, -1
# The tool and that of the nearest arm with a structure differ by no more [rad, length].
TURNED, MOVED = 90, 91
LOOP = 92  # K0 ... K4, L and R of J(q1) K0 J(q2) ... K4 J(q6) = L T R
SIZE = 176  # the length that is one in this loop
LEFT, RIGHT = 177, 189  # from a pose T to that of the nearest arm, left T right
MORE = 201  # six: what angles of the nearest arm are more than those of this
NOMINAL = 207  # C0 ... C6 of the nearest arm at joint values of this
NUMBERS = 291


@OWN.inner
def calibration_of(arm: Floats) -> Floats:
    """The numbers of a calibrated arm that its table says."""
    return arm[int(arm[CALIBRATION]) :]

# SPDX-License-Identifier: MIT
"""The numbers that a calibrated arm has from its table, and their places, as in calibration.h.

They are computed once and are the last ones in the arm's array, from `arm[CALIBRATION]` on.
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
LEFT, RIGHT = 177, 189  # the nearest arm's pose is left T right
MORE = 201  # six: the nearest arm's angles minus this arm's
NOMINAL = 207  # C0 ... C6 of the nearest arm at joint values of this
MARGIN = 291  # poses are left whose rows may end within so many times these bounds
NUMBERS = 292


@OWN.inner
def calibration_of(arm: Floats) -> Floats:
    """The numbers of a calibrated arm that are computed from its table."""
    return arm[int(arm[CALIBRATION]) :]

"""Angles in generated code."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Angles:
    """Parts of a turn [rad].

    Attributes:
        turn: A whole one.
        pi: Half of one.
        almost_pi: What is as good as pi.
        half_pi: A quarter of a turn.
        quarter_pi: An eighth of one.
    """

    turn: float = 2 * math.pi
    pi: float = math.pi
    almost_pi: float = math.pi - 1e-14
    half_pi: float = math.pi / 2
    quarter_pi: float = math.pi / 4

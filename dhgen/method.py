"""How an arm is solved, and the name of that in all texts."""

from __future__ import annotations

from enum import StrEnum


class Method(StrEnum):
    """What takes poses to joint values; best first."""

    CLOSED_FORM = "closed form"
    QUARTIC = "quartic"
    GENERAL_6R = "general 6R"
    GENERAL_5R1P = "general 5R1P"
    GENERAL_4R2P = "general 4R2P"
    NUMERICAL = "numerical"

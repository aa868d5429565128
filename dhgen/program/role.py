"""What the named constants of programs are: a name does not show it, parameters have any."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Literal


class Source(Enum):
    """Where a number comes from that has no other part than to be calculated with."""

    ARM = "a number of the arm, by the name that it has there"
    MADE = "made of the arm's numbers"
    FILE = "the same for every arm, and defined in every file: pi and 2 pi"


@dataclass(frozen=True, slots=True)
class Tolerance:
    """A tolerance, or a number taken from one.

    Attributes:
        kind: What for: a key of the table in `scales`, or a word of its own.
        degree: How many lengths the values have that it is for.
    """

    kind: str
    degree: int


@dataclass(frozen=True, slots=True)
class LimitEnd:
    """An end of a joint's limits, moved by what rounding may add.

    Attributes:
        joint: The joint's number.
        end: Which end.
    """

    joint: int
    end: Literal["low", "high"]


LIMIT_SLACK = Tolerance("limit_slack", 0)
"""Half of what a joint may be beyond its limits by rounding, in programs of regular poses."""

Role = Source | Tolerance | LimitEnd

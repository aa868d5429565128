"""The status of each row: the numbers that callers see."""

from __future__ import annotations

from enum import IntEnum


class Status(IntEnum):
    """What a row holds, and why."""

    OK = 0
    UNREACHABLE = 1
    FREE_JOINT = 2
    OUT_OF_LIMITS = 3
    INVALID_POSE = 4


HELD = (Status.OK, Status.FREE_JOINT, Status.OUT_OF_LIMITS)  # the row holds joint values

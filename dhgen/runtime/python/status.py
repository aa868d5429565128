# SPDX-License-Identifier: MIT
"""What a row holds: the numbers that callers see, and those of rows that are not ready yet."""

from __future__ import annotations

OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: not a valid pose, or a value that the caller gives is not finite
PUBLIC = OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE

# Of solvers only:
CLOSE = 64  # roots nearly meet: the row may lie between two solutions
# LOST + j: the row was lost after joint j had been chosen freely. Its first value is how far it is
# from a solution: negative out of reach, positive where it misses the pose.
LOST = 128
NEARLY = 192  # NEARLY + j: joint j is nearly free, and the row's second value is its angle

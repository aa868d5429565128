# SPDX-License-Identifier: MIT
"""What a row holds: the numbers that callers see."""

from __future__ import annotations

OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: not a valid pose, or a value that the caller gives is not finite

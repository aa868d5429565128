# SPDX-License-Identifier: MIT
"""All solutions of many poses: in tiles, in which formulas become vector instructions.

`functions.of_robot` makes each of these functions anew for a robot, with the names that are
declared below. A tile holds values of its poses side by side: value n of pose k is at
`n * TILE + k`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .jit import carray, wide_room
from .pose import ORTHONORMAL

if TYPE_CHECKING:
    from collections.abc import Callable

    from .arrays import Bytes, Floats, Ints

TILE = 16  # poses: two of the widest vectors; what a tile needs fits into the first cache
ENTRIES = 16  # of a pose; then what the caller gives, and the doubt

# Of the robot:
DOF: int
ROWS: int
GIVEN: int  # how many values the caller gives
DOUBT: int  # the place of what is not zero for poses that the formulas do not answer
STATUSES: int  # the place of the first row's status
KEPT_OF_TILE: int  # the sizes of a tile's arrays
TURNS_OF_TILE: int
FILLED_OF_TILE: int
KEPT: int  # values of a pose that are kept
places: Ints  # of the joints' values of each row, (rows, joints)
counted: tuple[bool, bool, bool]  # which coordinates a pose names
slides: bool  # whether joints slide: then squares of lengths have to be finite, and so cubes
rotation_miss: Callable[[Floats, int, int], float]
formulas: Callable[[Floats, Floats, Floats, int], None]
solve_alone: Callable[[int, Floats, Floats, Floats, Bytes], None]


def is_exact(kept: Floats, k: int) -> bool:
    """Whether pose k of a tile is valid and needs no straightening."""
    miss = rotation_miss(kept, k, TILE)
    for row in range(3):
        if counted[row]:
            p = kept[(4 * row + 3) * TILE + k]
            miss += 0.0 * (p * p * p if slides else p)  # NaN where it is not finite
    for i in range(GIVEN):
        v = kept[(ENTRIES + i) * TILE + k]
        miss += 0.0 * (v * v * v if slides else v)
    return miss <= ORTHONORMAL


def in_tiles(T: Floats, q_free: Floats, q: Floats, status: Bytes) -> None:
    """All solutions of many poses; poses that the formulas do not solve are solved one by one."""
    kept = carray(wide_room(KEPT_OF_TILE), KEPT_OF_TILE)
    turns = carray(wide_room(TURNS_OF_TILE), TURNS_OF_TILE)
    rows = carray(wide_room(FILLED_OF_TILE), FILLED_OF_TILE)
    kept[:] = 0.0  # the last tile may be half full
    for first in range(0, len(T), TILE):
        count = min(TILE, len(T) - first)
        for k in range(count):
            for i in range(4):
                for j in range(4):
                    kept[(4 * i + j) * TILE + k] = T[first + k, i, j]
            for i in range(GIVEN):
                kept[(ENTRIES + i) * TILE + k] = q_free[first + k, i]
        for k in range(TILE):
            kept[DOUBT * TILE + k] = 0.0 if is_exact(kept, k) else 1.0
        formulas(kept, turns, rows, len(kept) // KEPT)  # a literal would be a type of its own
        for k in range(count):
            if kept[DOUBT * TILE + k] != 0.0:
                solve_alone(first + k, T, q_free, q, status)
                continue
            for row in range(ROWS):
                status[first + k, row] = np.uint8(rows[(STATUSES + row) * TILE + k])
                for i in range(DOF):
                    q[first + k, row, i] = rows[places[row, i] * TILE + k]


def one_by_one(T: Floats, q_free: Floats, q: Floats, status: Bytes) -> None:
    """All solutions of many poses, one after another."""
    for k in range(len(T)):
        solve_alone(k, T, q_free, q, status)

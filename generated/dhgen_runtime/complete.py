# SPDX-License-Identifier: MIT
"""What follows where roots of polynomials nearly meet, and where rows miss the pose."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .arm import POSE, ROBOT, descents_of
from .jit import of_file
from .numerical import (
    descent,
    other_values,
    places,
    refine_rows,
    rows_beside,
    search_lost_rows,
    split_close_roots,
)
from .places import ADDS_OTHERS, EQUATIONS_END_ALL, ROOT_TURNS
from .status import UNREACHABLE

if TYPE_CHECKING:
    from .arm import Pose, Robot
    from .arrays import Bytes, Floats

OWN = of_file(__file__)
PARTS = (descent, refine_rows, other_values, split_close_roots, search_lost_rows, rows_beside)
_split, _add_others = split_close_roots.split_close_roots, other_values.add_others
_refine, _search = refine_rows.refine_rows, search_lost_rows.search_lost_rows


@OWN.apart(
    f"void(float64[::1], {ROBOT}, {POSE}, float64[::1], float64[::1], int64, float64[:, ::1], "
    "uint8[::1])"
)
def complete_rows(
    arm: Floats,
    robot: Robot,
    pose: Pose,
    q_free: Floats,
    seed: Floats,
    begun: int,
    q: Floats,
    status: Bytes,
) -> None:
    """Completes the rows of a pose.

    Splits close roots, adds rows for other values of joints, refines rows and, if `begun` is not
    negative, searches for lost ones, for row `begun`. Where a pose that may be rounded has none,
    those of poses beside it are looked at.
    """
    task = arm, robot, pose, q_free
    if arm[ROOT_TURNS] > 0.0:
        _split(task, seed, q, status)
    if arm[ADDS_OTHERS] > 0.0:
        _add_others(task, q, status)
    fitted = _refine(task, q, status)
    none = descents_of(arm)[places.CHECKED] > 0.0
    for kind in status:
        none = none and kind == UNREACHABLE
    if begun < 0 and arm[EQUATIONS_END_ALL] > 0.0:
        begun = 0
    if begun >= 0:
        _search(task, seed, begun, fitted, q, status)
    if none:
        rows_beside.add_rows_beside(task, seed, q, status)


def compile_apart() -> None:
    """Compiles the functions that are called by address, or loads them from numba's cache."""
    OWN.compile_apart()
    for part in PARTS:
        part.OWN.compile_apart()

# SPDX-License-Identifier: MIT
"""Everything of this folder compiled beforehand, so that no call waits for it."""

from ..numerical import descent, solutions
from . import (
    attempts,
    candidates,
    circle,
    correct,
    equations,
    four_turns,
    loop,
    recover,
    refine,
    roots,
    rows,
    search,
)

FILES = (
    *(descent, solutions, loop, equations, circle, four_turns),
    *(recover, refine, roots, candidates, correct, attempts, search, rows),
)


def compile_apart() -> None:
    """Compiles the functions that are called by address, or loads them from numba's cache."""
    for module in FILES:
        module.OWN.compile_apart()

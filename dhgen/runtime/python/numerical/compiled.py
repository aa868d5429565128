# SPDX-License-Identifier: MIT
"""Everything of this folder compiled beforehand, so that no call waits for it."""

from . import descent, family, keep, pairs, search, solutions


def compile_apart() -> None:
    """Compiles the functions that are called by address, or loads them from numba's cache."""
    for module in (descent, solutions, family, keep, pairs, search):
        module.OWN.compile_apart()

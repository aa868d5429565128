"""The names of rows of an arm whose rows are those of an arm with a structure, and further ones."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

FURTHER = "further"  # of rows for a second solution of a posture, and for one that has none


def row_names(postures: Sequence[str], rows: int) -> tuple[str, ...]:
    """The name of every row.

    Args:
        postures: The names of the rows of the arm with a structure.
        rows: How many rows there are, these among them.
    """
    further = (f"{FURTHER}{number}" for number in range(1, rows - len(postures) + 1))
    return (*postures, *further)

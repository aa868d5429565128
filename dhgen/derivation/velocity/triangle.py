"""Rows and columns put in order so that a matrix is made of square blocks, with zeros beside them.

The determinant is the product of those of the blocks. They are the smallest that the places of
zeros allow (A. L. Dulmage and N. S. Mendelsohn, 1958): a row is given to every column, and columns
that lead to each other through their rows share a block.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

Places = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Triangle:
    """The order of rows and columns.

    Attributes:
        blocks: Of every block the rows and the columns, ascending.
        sign: Of the order, by which the product of the blocks' determinants is the whole one.
    """

    blocks: tuple[tuple[Places, Places], ...]
    sign: int

    @property
    def effort(self) -> int:
        """About how many products the determinants of the blocks take."""
        return sum(len(rows) ** 3 for rows, _ in self.blocks)


def triangle_of(rows: Sequence[Sequence[object]]) -> Triangle | None:
    """The blocks of a square matrix; None where its zeros alone make it singular."""
    given = _rows_of_columns(rows)
    if given is None:
        return None
    columns = range(len(rows))
    reached = {column: _reached(rows, given, column) for column in columns}
    groups = {
        tuple(other for other in columns if other in reached[column] and column in reached[other])
        for column in columns
    }
    blocks = tuple((tuple(sorted(given[c] for c in group)), group) for group in sorted(groups))
    orders = ([place for block in blocks for place in block[side]] for side in (0, 1))
    sign = 1
    for order in orders:
        sign *= (-1) ** sum(a > b for k, b in enumerate(order) for a in order[:k])
    return Triangle(blocks, sign)


def _rows_of_columns(rows: Sequence[Sequence[object]]) -> dict[int, int] | None:
    """A row for every column that has no zero there, all different."""
    given: dict[int, int] = {}

    def gives(row: int, tried: set[int]) -> bool:
        for column, entry in enumerate(rows[row]):
            if entry and column not in tried:
                tried.add(column)
                if column not in given or gives(given[column], tried):
                    given[column] = row
                    return True
        return False

    return given if all(gives(row, set()) for row in range(len(rows))) else None


def _reached(rows: Sequence[Sequence[object]], given: dict[int, int], column: int) -> set[int]:
    """The columns that a column leads to: those with entries in its row, and so on."""
    found, pending = {column}, [column]
    while pending:
        row = rows[given[pending.pop()]]
        new = [each for each, entry in enumerate(row) if entry and each not in found]
        found.update(new)
        pending += new
    return found

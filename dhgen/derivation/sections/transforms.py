"""Transforms on paper: as a matrix, by their entries, or as a product where those fill pages."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.text.blocks import Paragraph, display, say
from dhgen.derivation.text.formula import ONE, ZERO, Element, Listing, Matrix, Relation, equal
from dhgen.derivation.text.lines import WIDTH, laid_out, width
from dhgen.derivation.text.style import PLAIN
from dhgen.derivation.text.words import joined as listed
from dhgen.derivation.text.words import many

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform

PAGE = 60  # lines
COLUMNS = (1, 2, 3, 4)
MOST_TERMS = 400  # more of them fill more than a page, however they are nested


def matrix_of(transform: Transform, write: Callable[[Polynomial], Formula]) -> Matrix:
    """All sixteen entries."""
    rows = [tuple(write(transform.entry(row, column)) for column in range(4)) for row in range(3)]
    return Matrix((*rows, (ZERO, ZERO, ZERO, ONE)))


def matrix_width(formula: Formula) -> int:
    """Visible characters of `name = matrix`: the widest entry of every column."""
    assert isinstance(formula, Relation)
    total = 0
    for side in formula.sides:
        if isinstance(side, Matrix):
            for column in zip(*side.rows, strict=True):
                total += max(1 if e is None else width(e) for e in column) + 2
        else:
            total += width(side) + 3
    return total


def side_by_side(matrices: Sequence[Formula]) -> list[Block]:
    """Matrices with their names, two in a line where a page is wide enough."""
    left, blocks = list(matrices), []
    while left:
        first = left.pop(0)
        if left and matrix_width(first) + matrix_width(left[0]) <= WIDTH - 10:
            blocks.append(display(Listing((first, left.pop(0)))))
        else:
            blocks.append(display(first))
    return [*blocks]


def transform_blocks(
    name: Formula,
    transform: Transform,
    write: Callable[[Polynomial], Formula],
    before: tuple[Formula, Transform] | None = None,
) -> list[Block]:
    """name = matrix; one that is too wide by its entries, without what one before it has."""
    matrix = matrix_of(transform, write)
    whole = equal(name, matrix)
    if matrix_width(whole) <= WIDTH:
        return [display(whole)]
    shared = {} if before is None else _shared(transform, before[1])
    entries = _entries(name, matrix, [n for n in COLUMNS if n not in shared])
    if before is None or not shared:
        return [display(*entries)]
    end = "; the other entries are" if entries else "."
    intro = Paragraph(say("{}" + end, _known_entries(shared, name, before[0])))
    return [intro, display(*entries)] if entries else [intro]


def _shared(transform: Transform, before: Transform) -> dict[int, tuple[int, int]]:
    """Columns, from 1, that are a column of the transform before, or the opposite of one."""
    new, old = (
        {n: tuple(each.entry(row, n - 1) for row in range(3)) for n in COLUMNS}
        for each in (transform, before)
    )
    return {
        n: (m, sign)
        for n, column in new.items()
        for m, other in old.items()
        for sign in (-1, 1)
        if (n == 4) == (m == 4) and column == tuple(sign * entry for entry in other)
    }


def _known_entries(shared: dict[int, tuple[int, int]], name: Formula, earlier: Formula) -> Prose:
    """Columns 4 and 2 of T_5^0 are column 4 and minus column 3 of T_4^0.

    Opposite ones come last, so that no minus seems to belong to what follows.
    """
    shared = dict(sorted(shared.items(), key=lambda each: (each[1][1] < 0, each[0])))
    new = many("Column", [str(n) for n in shared])
    verb = "are" if len(shared) > 1 else "is"
    if all(where == (n, 1) for n, where in shared.items()):
        old = "those" if len(shared) > 1 else "that"
    else:
        old = listed([f"{'minus ' if sign < 0 else ''}column {m}" for m, sign in shared.values()])
    return say(f"{new} of {{}} {verb} {old} of {{}}", name, earlier)


def fills_pages(
    name: Formula, transform: Transform, write: Callable[[Polynomial], Formula]
) -> bool:
    """Whether the entries one by one are more than a reader can follow."""
    if (
        sum(len(transform.entry(row, column)) for row in range(3) for column in range(4))
        > MOST_TERMS
    ):
        return True
    return len(laid_out(_entries(name, matrix_of(transform, write)), PLAIN)) > PAGE


def _entries(
    name: Formula, matrix: Matrix, columns: Iterable[int] = COLUMNS
) -> tuple[Relation, ...]:
    return tuple(
        equal(Element(name, row + 1, column), entry)
        for column in columns
        for row in range(3)
        if (entry := matrix.rows[row][column - 1]) is not None
    )

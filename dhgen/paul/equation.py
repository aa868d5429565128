"""An equation, and its place in the forms of T."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import product as product_of
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.kinematics.constants import Polynomial

Matrix = tuple[int, int, bool, bool]  # m, k, inverse, shoulder: which form it is
Line = tuple[Matrix, str, int]  # of which matrix, "row" or "column", its number

MOMENT = 0  # in place of a column: column 3 x column 4


@dataclass(frozen=True, slots=True, order=True)
class Origin:
    """The place of an equation.

    Attributes:
        m: Joints moved from the left: (A_1 ... A_m)^-1.
        k: Joints moved from the right begin at k + 1: (A_{k+1} ... A_n)^-1.
        dof: n.
        row: From 1; 0 for the squared length of column 4.
        column: From 1 to 4; `MOMENT` for an element of column 3 x column 4.
        inverse: Whether it is in the inverted form (A_{k+1} ... A_n) U_0^-1 (A_1 ... A_m).
        shoulder: Whether the rotation B of the joints before the elbow, which the arm angle gives,
            replaces U_0; then n is their number.
    """

    m: int
    k: int
    dof: int
    row: int
    column: int
    inverse: bool = False
    shoulder: bool = False

    @property
    def matrix(self) -> Matrix:
        """The form that holds it."""
        return self.m, self.k, self.inverse, self.shoulder

    @property
    def is_mixed(self) -> bool:
        """Whether it is in none of Paul's U_m: joints were moved from the right too."""
        return self.inverse or self.k < self.dof

    @property
    def name(self) -> str:
        """How a message calls the place: U2[3, 4], or U1 (A5 A6)^-1 [3, 4] for a mixed form."""
        moved = " ".join(f"A{joint}" for joint in range(self.k + 1, self.dof + 1))
        matrix = f"B{self.m}" if self.shoulder else f"U{self.m}"
        if self.inverse:
            before = " ".join(f"A{joint}" for joint in range(1, self.m + 1))
            matrix = f"{moved} U0^-1 {before}".strip() + " "
        elif self.is_mixed:
            matrix += f" ({moved})^-1 " if self.k + 1 < self.dof else f" {moved}^-1 "
        if self.row == 0:
            return f"the squared length of column 4 of {matrix.rstrip()}"
        if self.column == MOMENT:
            return f"{matrix}[3] x {matrix}[4], element {self.row}"
        return f"{matrix}[{self.row}, {self.column}]"


@dataclass(frozen=True, slots=True)
class Equation:
    """left = right, with right - left in normal form.

    Attributes:
        origin: Which element of which form.
        origins: All elements that give the same equation, `origin` first.
        left: The side with U_0.
        right: The entry of A_{m+1} ... A_k.
        difference: right - left.
    """

    origin: Origin
    origins: tuple[Origin, ...]
    left: Polynomial
    right: Polynomial
    difference: Polynomial

    @classmethod
    def at(cls, origin: Origin, left: Polynomial, right: Polynomial) -> Equation:
        """The equation of one element, by both of its sides."""
        return cls(origin, (origin,), left, right, right - left)

    @property
    def lines(self) -> frozenset[Line]:
        """The columns and rows that hold the equation."""
        places = [o for o in self.origins if o.row]
        columns = {(o.matrix, "column", o.column) for o in places}
        return frozenset(columns | {(o.matrix, "row", o.row) for o in places})


def merged(equations: Iterable[Equation]) -> tuple[Equation, ...]:
    """Each equation once, whatever its sign, with all its places."""
    merged: dict[Polynomial, Equation] = {}
    for equation in equations:
        key = equation.difference if equation.difference in merged else -equation.difference
        if key in merged:
            first = merged[key]
            merged[key] = replace(first, origins=(*first.origins, equation.origin))
        else:
            merged[equation.difference] = equation
    return tuple(merged.values())


def common_origins(equations: Sequence[Equation]) -> tuple[Origin, ...]:
    """The places of equations side by side: one element each, in one column or row of one form.

    Empty when there is no such line. Paul's U_m come before mixed forms, and among them those
    with the fewest joints moved; then columns, which are vectors, before rows, and the first ones
    before others, as in the courses.
    """
    places = product_of(*(equation.origins for equation in equations))
    return min(filter(_in_line, places), key=_readability, default=())


def _in_line(origins: tuple[Origin, ...]) -> bool:
    if len(origins) == 1:
        return True
    one_form = len({origin.matrix for origin in origins}) == 1
    one_column = len({origin.column for origin in origins}) == 1
    one_row = len({origin.row for origin in origins}) == 1
    return one_form and (one_column or one_row) and all(origin.row for origin in origins)


def _readability(origins: tuple[Origin, ...]) -> tuple[bool, bool, int, int, bool, int, int]:
    first = origins[0]
    in_row = len({origin.column for origin in origins}) > 1
    line = min(
        (origin.row, origin.column) if in_row else (origin.column, origin.row) for origin in origins
    )
    return first.inverse, first.is_mixed, first.m, -first.k, in_row, *line

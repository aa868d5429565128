"""Entries of U_0 = Z^-1 POS E^-1, with what of E is on that side, from the given pose's entries."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform
    from dhgen.paul.problem import Problem
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node

Rows = list[list["Node"]]


class Target:
    """The left-hand sides of the derivation's equations.

    Args:
        problem: What is asked of the arm.
        builder: Where values go.
        number: The value of a polynomial in the arm's constants.
    """

    def __init__(
        self, problem: Problem, builder: Builder, number: Callable[[Polynomial], Node]
    ) -> None:
        self._problem = problem
        self._builder = builder
        self._number = number

    def entry(self, row: int, column: int) -> Node:
        """An entry of U_0, from 0."""
        algebra, builder = self._problem.algebra, self._builder
        right = self._inverse(self._problem.tool_left)
        left = self._inverse(algebra.lift(algebra.chain.base)) if self._problem.base_left else None
        if left is None:
            return self._turned(row, column, right)
        total = left[row][3] if column == 3 else builder.integer(0)
        for i in range(3):
            if not builder.is_zero(left[row][i]):
                part = self._turned(i, column, right)
                total = builder.add(total, builder.mul(left[row][i], part))
        return total

    def _turned(self, row: int, column: int, right: Rows) -> Node:
        """An entry of POS E^-1."""
        builder = self._builder
        total = builder.pose(row + 1, 4) if column == 3 else builder.integer(0)
        for j in range(3):
            part = builder.mul(builder.pose(row + 1, j + 1), right[j][column])
            total = builder.add(total, part)
        return total

    def _inverse(self, transform: Transform) -> Rows:
        """The inverse of a constant rigid transform."""
        builder = self._builder
        rows = [[self._number(transform.entry(i, j)) for j in range(4)] for i in range(3)]
        inverse = [[rows[j][i] for j in range(3)] for i in range(3)]
        for row in inverse:
            total = builder.integer(0)
            for factor, length in zip(row, (rows[j][3] for j in range(3)), strict=True):
                total = builder.add(total, builder.mul(factor, length))
            row.append(builder.neg(total))
        return inverse

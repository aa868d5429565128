"""Numbers in the arm's size: tolerances, and the longest and shortest reach."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.building.tolerance_constants import tolerance_constant
from dhgen.program.role import Tolerance

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.pool import Pool
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.tolerances import Tolerances


@dataclass(frozen=True, slots=True)
class Extremes:
    """The longest and the shortest distance that two links allow [file's unit]."""

    longest: float
    shortest: float


class Scales:
    """Constants that depend on the arm's size.

    Args:
        pool: The equations, with the points that have names.
        builder: Where constants go.
        tolerances: The table of the arithmetic that the program is for.
    """

    def __init__(self, pool: Pool, builder: Builder, tolerances: Tolerances) -> None:
        self.tolerances = tolerances
        self._algebra = pool.problem.algebra
        self._builder = builder
        self._size = self._algebra.chain.size

    def tolerance(self, relative: float, degree: int, kind: str) -> Node:
        """A tolerance for a value that is a product of `degree` lengths."""
        value = relative * self._size**degree
        return tolerance_constant(self._builder, Tolerance(kind, degree), value)

    def weight(self, power: int) -> Node:
        """The arm's size to a power: what makes values of different degrees comparable."""
        value = self._size**power
        return self._builder.constant("second_weight", value, "lengths count in arm sizes", power)

    def power(self, degree: int) -> Node:
        """The arm's size to a power: what products of so many lengths are measured in."""
        if not degree:
            return self._builder.integer(1)
        value = self._size**degree
        return self._builder.constant(f"arm_size{degree}", value, "the arm's size", degree)

    def distances(self, degree: int) -> tuple[Node, Node, Node]:
        """What rounding may do to a value of this many lengths.

        For reaching, for merging, and for merging what is blurred.
        """
        tolerances = self.tolerances
        reach = self.tolerance(tolerances.reach, degree, "reach")
        merge = self.tolerance(tolerances.merge, degree, "merge")
        return reach, merge, self.tolerance(tolerances.blur, degree, "blur")

    def degree(self, *polynomials: Polynomial) -> int:
        """How many lengths are multiplied in these polynomials (0 for the zero polynomial)."""
        return self._algebra.degree(*polynomials)

    def out_of_reach(self, ends: Extremes, suffix: str) -> Node:
        """By what (H - |v|^2) (|v|^2 - L) is below zero at most where rounding is to blame."""
        high, low = ends.longest**2, ends.shortest**2
        slack = self.tolerances.reach * self._size
        far, near = (ends.longest + slack) ** 2, max(ends.shortest - slack, 0.0) ** 2
        value = max((far - high) * (far - low), (high - near) * (low - near))
        meaning = "rounding at the boundary of the workspace"
        return self._builder.constant(f"boundary{suffix}", value, meaning, 4)

    def extreme_reach(
        self, ends: Extremes, suffix: str, meaning: str, kind: str = "", widened: float = 0.0
    ) -> tuple[Node, Node]:
        """Squares of the longest and shortest distance that two links allow.

        Args:
            ends: The distances.
            suffix: The angle's, for names.
            meaning: For comments; {} is longest or shortest.
            kind: What for, where they are moved; for names.
            widened: By how much both are moved apart [arm sizes].
        """
        move = widened * self._size
        tail = f"_{kind}" if kind else ""
        longest = max(ends.longest + move, 0.0) ** 2
        shortest = max(ends.shortest - move, 0.0) ** 2
        constant = self._builder.constant
        return (
            constant(f"longest{suffix}{tail}", longest, meaning.format("longest"), 2),
            constant(f"shortest{suffix}{tail}", shortest, meaning.format("shortest"), 2),
        )

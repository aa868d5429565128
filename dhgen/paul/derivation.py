"""The derivation: the steps that solve an arm."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.method import Method
from dhgen.paul.kind import Kind

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.paul.pool import Pool
    from dhgen.paul.problem import Problem
    from dhgen.paul.step import Step


@dataclass(frozen=True, slots=True)
class Derivation:
    """Why the solver is what it is.

    Attributes:
        pool: The equations, with the points that have names.
        steps: In the order of solving.
        offers: At each step, all that are valid there, cheapest first.
        whole: For arms that no order of steps solves: the algorithm that takes them whole.
    """

    pool: Pool
    steps: tuple[Step, ...]
    offers: tuple[tuple[Step, ...], ...]
    whole: GeneralKernel | NumericalKernel | None = None

    @property
    def problem(self) -> Problem:
        """What is asked of the arm."""
        return self.pool.problem

    @property
    def method(self) -> Method:
        """How the arm is solved."""
        if self.whole is not None:
            return self.whole.method
        rooted = any(step.kind is Kind.CIRCLE for step in self.steps)
        return Method.QUARTIC if rooted else Method.CLOSED_FORM

    @property
    def branches(self) -> int:
        """The number of rows: the product of the steps' roots."""
        count = 1 if self.whole is None else self.whole.rows
        for step in self.steps:
            count *= step.roots
        return count

"""The derivation: the steps that solve an arm, with everything a reader or a program needs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.errors import UnsolvedError
from dhgen.general.arm import general_kernel
from dhgen.kinematics.algebra import build_algebra
from dhgen.paul.mobility import immobility
from dhgen.paul.pool import build_pool
from dhgen.paul.problem import build_problem
from dhgen.paul.refusal import refusal
from dhgen.paul.search import Search
from dhgen.paul.types import CLOSED, QUARTIC

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain
    from dhgen.paul.pool import Pool
    from dhgen.paul.problem import Problem
    from dhgen.paul.step import Step


MOST_GENERAL = 16  # solutions of a general 6R arm (M. Raghavan, B. Roth, 1990)


@dataclass(frozen=True, slots=True)
class Derivation:
    """Why the solver is what it is.

    Attributes:
        pool: The equations, with the points that have names.
        steps: In the order of solving.
        alternatives: At each step, the other steps that would have been valid.
        general: For arms that no order of steps solves: the general 6R algorithm takes them whole.
    """

    pool: Pool
    steps: tuple[Step, ...]
    alternatives: tuple[tuple[Step, ...], ...]
    general: GeneralKernel | None = None

    @property
    def problem(self) -> Problem:
        """What is asked of the arm."""
        return self.pool.problem

    @property
    def branches(self) -> int:
        """The number of rows: the product of the steps' roots."""
        count = 1 if self.general is None else MOST_GENERAL
        for step in self.steps:
            count *= step.roots
        return count


def derive(chain: Chain) -> Derivation:
    """Solves an arm by Paul's method, or leaves it to the general 6R algorithm.

    Raises:
        UnsolvedError: The arm has infinitely many solutions everywhere, or no order of steps makes
            every joint known.
    """
    stuck = immobility(chain)
    if stuck is not None:
        raise UnsolvedError(stuck)
    pool = build_pool(build_problem(build_algebra(chain)))
    closed = Search(pool, CLOSED)
    for search in (closed, Search(pool, QUARTIC)):
        for route in search.routes():
            return Derivation(pool, route.steps, route.alternatives)
    kernel = general_kernel(chain)
    if kernel is not None:
        return Derivation(pool, (), (), kernel)
    raise UnsolvedError(refusal(closed, chain))

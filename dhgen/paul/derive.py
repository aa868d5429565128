"""From an arm to its derivation: by Paul's method, or by what takes an arm whole."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.errors import UnsolvedError
from dhgen.general.arm import general_kernel, is_better_polished
from dhgen.kinematics.algebra import build_algebra
from dhgen.kinematics.no_arm_angle import demand_arm_angle
from dhgen.numerical.kernel import numerical_kernel
from dhgen.paul.audit import best_route
from dhgen.paul.choices import good_choices
from dhgen.paul.derivation import Derivation
from dhgen.paul.inverse_forms import with_inverse_forms
from dhgen.paul.mobility import open_from_the_start, surplus
from dhgen.paul.pool import Pool, build_pool
from dhgen.paul.problem import build_problem
from dhgen.paul.redundant import redundant
from dhgen.paul.refusal import refusal
from dhgen.paul.search import Search
from dhgen.paul.shoulder_forms import with_arm_plane
from dhgen.paul.types import CLOSED, QUARTIC

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain


def derive(chain: Chain, *, numerical: bool = False) -> Derivation:
    """Solves an arm by Paul's method, or leaves it to the general algorithms for six joints.

    Args:
        chain: The arm.
        numerical: Whether the numerical solver may take what nothing else solves.

    Raises:
        UnsolvedError: The arm has infinitely many solutions everywhere, or no order of steps makes
            every joint known.
    """
    if len(chain.free) == chain.dof:
        raise UnsolvedError("every joint is free: there is nothing to solve")
    if chain.arm_angle:
        demand_arm_angle(chain)
        numerical = False  # it could hold joints, but not an arm angle
    spare = surplus(chain)
    if spare.count and not numerical:  # before its products, which of many joints fill the memory
        start = open_from_the_start(chain, spare)
        raise UnsolvedError(redundant(chain, spare, start, good_choices(*start, derive)))
    problem = build_problem(build_algebra(chain))
    if spare.count:
        return Derivation(Pool(problem, (), ()), (), (), numerical_kernel(chain, redundant=True))
    pool = build_pool(problem)
    if chain.arm_angle:
        pool = with_arm_plane(pool)
    closed = Search(pool, CLOSED)
    route = best_route(closed, pool)
    if route is not None:
        return Derivation(pool, route.steps, route.alternatives)
    found = _by_polynomial(with_inverse_forms(pool), chain)
    if found is not None:
        return found
    if numerical:
        return Derivation(pool, (), (), numerical_kernel(chain, redundant=False))
    raise UnsolvedError(refusal(closed, chain))


def _by_polynomial(pool: Pool, chain: Chain) -> Derivation | None:
    """By steps of which one is a quartic, or by a general algorithm."""
    if not is_better_polished(chain):
        route = best_route(Search(pool, QUARTIC), pool)
        if route is not None:
            return Derivation(pool, route.steps, route.alternatives)
    kernel = general_kernel(chain)
    return None if kernel is None else Derivation(pool, (), (), kernel)

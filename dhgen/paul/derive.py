"""From an arm to its derivation: by Paul's method, or by what takes an arm whole."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.errors import UnsolvedError
from dhgen.general.arm import general_kernel
from dhgen.kinematics.algebra import build_algebra
from dhgen.kinematics.arm_angle import demand_arm_angle
from dhgen.method import Method
from dhgen.numerical.kernel import numerical_kernel
from dhgen.paul.close_roots import has_close_roots
from dhgen.paul.degeneracy import best_route, degenerate_steps, is_ill_conditioned
from dhgen.paul.derivation import Derivation
from dhgen.paul.further_forms import with_arm_plane, with_inverse_forms
from dhgen.paul.mobility import open_from_the_start, surplus
from dhgen.paul.pool import Pool, build_pool
from dhgen.paul.problem import build_problem
from dhgen.paul.refusal.drives import (
    demand_given_alone,
    demand_sums,
    demand_whole_turns,
)
from dhgen.paul.refusal.free_joint_advice import free_joint_advice
from dhgen.paul.refusal.redundancy import redundant
from dhgen.paul.refusal.size_limits import (
    are_too_many_given,
    demand_few_directions,
    demand_few_given,
)
from dhgen.paul.refusal.unsolved import refusal
from dhgen.paul.search import Search
from dhgen.paul.types import CLOSED, QUARTIC

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.chain import Chain
    from dhgen.paul.step import EquationType

ROWS, ROWS_OF_CHECKED = 8, 2


def derive(chain: Chain, *, numerical: bool = False, steps: Sequence[int] = ()) -> Derivation:
    """Solves an arm by Paul's method, or leaves it to the general algorithms for six joints.

    Args:
        chain: The arm.
        numerical: Whether the numerical solver may take what nothing else solves.
        steps: Which of their offers the first steps are, from 1; the others are the best.

    Raises:
        UnsolvedError: The arm has infinitely many solutions everywhere, or no order of steps makes
            every joint known, or none that begins as asked for.
    """
    _demand_a_question(chain)
    numerical = numerical and not chain.arm_angle  # it could hold joints, but not an arm angle
    spare = surplus(chain)
    if spare.count and not numerical:  # before its products, which of many joints fill the memory
        start = open_from_the_start(chain, spare)
        raise UnsolvedError(redundant(chain, spare, start, free_joint_advice(*start, derive)))
    if numerical:
        demand_whole_turns(chain)
    else:
        demand_few_given(chain)
        demand_given_alone(chain)
        demand_sums(chain)
    problem = build_problem(build_algebra(chain))
    apart = not chain.is_given_alone or any(row.apart for row in chain.passive)
    if apart or spare.count or are_too_many_given(chain.given):
        kernel = numerical_kernel(chain, redundant=bool(spare.count))
        return Derivation(Pool(problem, (), ()), (), (), kernel)
    pool = build_pool(problem)
    if chain.arm_angle:
        pool = with_arm_plane(pool)
    closed = Search(pool, CLOSED)
    found = _by_steps(closed, pool)
    types = QUARTIC if found is None else CLOSED
    if found is None:
        found = _from_both_ends(with_inverse_forms(pool), chain)
    elif found.branches > _usual_rows(chain):
        both = with_inverse_forms(pool)
        other = _by_steps(Search(both, CLOSED), both)
        found = other if other is not None and _is_better(other, found) else found
    if found is None and numerical:
        found = Derivation(pool, (), (), numerical_kernel(chain, redundant=False))
    if found is not None:
        return _as_chosen(found, types, steps) if steps else found
    raise UnsolvedError(refusal(closed, chain))


def _demand_a_question(chain: Chain) -> None:
    """Refuses chains of which nothing is asked that makes sense, or too much."""
    if len(chain.free) == chain.dof:
        raise UnsolvedError("every joint is free: there is nothing to solve")
    if chain.arm_angle:
        demand_arm_angle(chain)
    demand_few_directions(chain)


def _by_steps(search: Search, pool: Pool) -> Derivation | None:
    """By the best order of steps, if there is one."""
    route = best_route(search, pool)
    return None if route is None else Derivation(pool, route.steps, route.offers)


def _as_chosen(
    found: Derivation, types: tuple[EquationType, ...], numbers: Sequence[int]
) -> Derivation:
    """By the best order that begins with offers of these numbers.

    Pairs that were solved together at one state are looked at in others: for the numbers to mean
    what was listed, the search goes the way again on which the lists were made.
    """
    if found.whole is not None:
        raise UnsolvedError(
            f"steps: there are none to choose, the arm is solved as a whole ({found.method})"
        )
    search = Search(found.pool, types)
    for count in range(len(numbers) + 1):
        route = best_route(search, found.pool, numbers[:count])
    if route is None:
        raise UnsolvedError("steps: no order of equations that begins with these solves the arm")
    return Derivation(found.pool, route.steps, route.offers)


def _from_both_ends(pool: Pool, chain: Chain) -> Derivation | None:
    """With the view from the tool back to the base, by steps or by a general algorithm."""
    found = _by_steps(Search(pool, QUARTIC), pool)
    if found is not None and not _is_frail(found):
        return found
    kernel = None if chain.passive else general_kernel(chain)
    return found if kernel is None else Derivation(pool, (), (), kernel)


def _is_frail(derivation: Derivation) -> bool:
    """Whether roots of a quartic may lie too close to be distinguished, or often take long."""
    if derivation.method is not Method.QUARTIC:
        return False
    pool, steps = derivation.pool, derivation.steps
    return is_ill_conditioned(pool, steps) or has_close_roots(pool, steps)


def _is_better(other: Derivation, found: Derivation) -> bool:
    """Whether fewer of its steps are often degenerate, or as few and it has fewer rows.

    Where a step is degenerate a row holds one of several solutions.
    """
    often, its_own = (degenerate_steps(each.steps)[0] for each in (found, other))
    return (its_own, other.branches) < (often, found.branches)


def _usual_rows(chain: Chain) -> int:
    """As many rows as closed forms have; with more of them it is worth looking for others."""
    return ROWS_OF_CHECKED if chain.overdetermined else ROWS

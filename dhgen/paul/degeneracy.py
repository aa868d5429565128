"""Where a step's equations lose their unknown although that is not free, or nearly do.

X s + Y c = Z is degenerate where X and Y vanish. Mostly the angle is free there, and the arm
singular; but what a wrist's last angle is read from may also vanish where an axis of the wrist is
parallel to one of the shoulder, which leaves nothing free. Such places are found by trying, and
the Jacobian shows what is free there.

Ill-conditioned are orders of steps that divide by lengths, or twists, that are next to nothing. An
offset of a micrometre, as calibrations and drawings have them, makes a quartic whose roots lie in
pairs that are next to nothing apart, and what distinguishes the two of a pair is divided by the
offset.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.arm_angle import elbow_rates
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.task import task_jacobian
from dhgen.paul.common_zeros import Factors
from dhgen.paul.fallback_equation import with_fallback_equations
from dhgen.paul.knowledge import initial_knowledge
from dhgen.paul.step import FEW_SIZES, learn
from dhgen.paul.witness import OWN_LENGTHS, build_witnesses
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.algebra import AngleSum
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Unknown
    from dhgen.paul.knowledge import Knowledge, State
    from dhgen.paul.pool import Pool
    from dhgen.paul.search import Route, Search
    from dhgen.paul.step import Step

    Known = dict[tuple[State, tuple[Unknown, ...], tuple[Polynomial, ...]], int]


ROUTES = 24  # so many orders are looked into
NULL = 1e-5  # of the largest singular value: zeros are known to about half the digits
FREE = 1e-3  # a part of an angle in a null vector
OFTEN = 1  # condition on the joints, which home poses and right angles meet


def best_route(search: Search, pool: Pool, numbers: Sequence[int] = ()) -> Route | None:
    """The cheapest of the orders of steps that are degenerate least.

    Only what the search takes is looked into: most steps are never taken.

    Args:
        search: Of the arm.
        pool: Its equations.
        numbers: Which of their offers the first steps are, from 1.
    """
    best: Route | None = None
    known: Known = {}
    for _ in range(ROUTES):
        route = search.best(numbers)
        if route is None:
            break
        steps = with_degeneracies(pool, with_fallback_equations(pool, route.steps), known)
        if best is None or degenerate_steps(steps) < degenerate_steps(best.steps):
            best = replace(route, steps=steps)
        if not search.avoid(route, [place for place, step in enumerate(steps) if step.degenerate]):
            break
    return best


def degenerate_steps(steps: Sequence[Step]) -> tuple[int, int]:
    """How many of an order's steps are often degenerate, and how many ever are."""
    return sum(step.degenerate == OFTEN for step in steps), sum(
        step.degenerate > 0 for step in steps
    )


def with_degeneracies(pool: Pool, steps: Sequence[Step], known: Known) -> tuple[Step, ...]:
    """The steps of an order, each with the number of conditions under which it is degenerate.

    Args:
        pool: The equations.
        steps: All steps of an arm.
        known: What has been found out about steps; more is added.
    """
    found = []
    for knowledge, step in _with_knowledge(pool, steps):
        key = knowledge.state, step.unknowns, tuple(_leading(step))
        if key not in known:
            known[key] = _conditions(pool, knowledge, step)
        found.append(replace(step, degenerate=known[key]))
    return tuple(found)


def degenerate_places(pool: Pool, steps: Sequence[Step]) -> FloatArray:
    """Joint values where steps are degenerate although their angles are not free, (n, dof)."""
    places = [_no_places(pool)]
    for knowledge, step in _with_knowledge(pool, steps):
        if step.degenerate:
            places.append(_degenerate_at(pool, knowledge, step))
    return np.concatenate(places)


def indeterminate_places(pool: Pool, steps: Sequence[Step]) -> FloatArray:
    """Joint values where some step's leading coefficients vanish, (n, dof)."""
    return np.concatenate([_no_places(pool), *(_indeterminate_at(pool, step) for step in steps)])


def _with_knowledge(pool: Pool, steps: Sequence[Step]) -> Iterator[tuple[Knowledge, Step]]:
    """Every step with what is known before it."""
    knowledge = initial_knowledge(pool.problem.algebra)
    for step in steps:
        yield knowledge, step
        knowledge = learn(knowledge, step)


def _conditions(pool: Pool, knowledge: Knowledge, step: Step) -> int:
    """The least number of conditions under which a step is degenerate; 0 if it never is."""
    factors = _factors(pool, step)
    if factors is None:
        return 0
    zeros = _degenerate_zeros(factors, knowledge, step)
    return max(OFTEN, factors.conditions(zeros)) if zeros.size else 0


def _degenerate_at(pool: Pool, knowledge: Knowledge, step: Step) -> FloatArray:
    """Some joint values where a step is degenerate although its angle is not free, (n, dof)."""
    factors = _factors(pool, step)
    if factors is None:
        return _no_places(pool)
    return _joint_values(pool.problem.algebra.chain, _degenerate_zeros(factors, knowledge, step))


def _degenerate_zeros(factors: Factors, knowledge: Knowledge, step: Step) -> FloatArray:
    """Joint values where a step is degenerate, as the algebra counts them, (dof, n)."""
    zeros = factors.zeros()
    if not zeros.size:
        return zeros
    q = _joint_values(knowledge.runs.algebra.chain, zeros)
    return np.asarray(zeros[:, _are_fixed(knowledge, step.angle, q)])


def _indeterminate_at(pool: Pool, step: Step) -> FloatArray:
    """Some joint values where a step's leading coefficients vanish, (n, dof)."""
    factors = _factors(pool, step)
    if factors is None:
        return _no_places(pool)
    return _joint_values(pool.problem.algebra.chain, factors.zeros())


def _no_places(pool: Pool) -> FloatArray:
    return np.empty((0, pool.problem.algebra.chain.dof))


def _factors(pool: Pool, step: Step) -> Factors | None:
    """The common zeros of a step's leading coefficients; None where they have none."""
    polynomials = _leading(step)
    if not polynomials or any(map(pool.problem.algebra.is_constant, polynomials)):
        return None
    return Factors(pool, polynomials)


def _leading(step: Step) -> list[Polynomial]:
    """The coefficients of which one has to differ from zero for the equations to hold the angle."""
    both = [step] if step.fallback is None else [step, step.fallback]
    found = [each.coefficient(letter) for each in both for letter in step.kind.value.leading]
    return [polynomial for polynomial in found if polynomial]


def _joint_values(chain: Chain, q: FloatArray) -> FloatArray:
    """Joint values as the caller counts them (n, dof), from the algebra's."""
    values = [
        row * (chain.size if joint.kind is JointKind.PRISMATIC else 1)
        for joint, row in zip(chain.joints, q, strict=True)
    ]
    return np.stack(chain.drives.back(values), axis=1)


def _are_fixed(knowledge: Knowledge, angle: AngleSum, q: FloatArray) -> FloatArray:
    """Whether an angle can't be turned while the pose and what is known are held, (n,)."""
    chain = knowledge.runs.algebra.chain
    arm = numeric_arm(chain)
    held = [
        _rates(chain, known) for known in knowledge.runs.algebra.angles if knowledge.knows(known)
    ]
    held += [_moves(chain)[joint - 1] for joint in sorted(knowledge.slides)]
    rows = [
        task_jacobian(arm, q),
        np.broadcast_to(np.array(held).reshape(-1, chain.dof), (len(q), len(held), chain.dof)),
    ]
    if chain.arm_angle:
        rows.append(elbow_rates(arm, q)[:, None])
    _, sizes, directions = np.linalg.svd(np.concatenate(rows, axis=1))
    null = np.ones(directions.shape[:2], dtype=bool)
    null[:, : sizes.shape[1]] = sizes < NULL * sizes[:, :1]
    moves = np.abs(directions @ _rates(chain, angle))
    return np.asarray(~np.any(null & (moves > FREE), axis=1))


def _rates(chain: Chain, angle: AngleSum) -> FloatArray:
    """How an angle changes with every joint, (dof,)."""
    rates = np.zeros(chain.dof)
    for joint, sign in angle.terms:
        rates += sign * _moves(chain)[joint - 1]
    return rates


def _moves(chain: Chain) -> FloatArray:
    """How every joint's angle or length changes with every drive, (dof, dof)."""
    return chain.drives.rates(np.eye(chain.dof))


# Roots so far apart have lost as many digits, and what is divided by the offset as many again. Of
# 400 poses of a UR5 an offset of 1e-5 m in the wrist lost no row, of 1e-6 m three, of 1e-7 m 45.
NEARLY_NOTHING = 1e-4


def is_ill_conditioned(pool: Pool, steps: Sequence[Step]) -> bool:
    """Whether the factors of an unknown are small together wherever the arm is, with its lengths.

    Args:
        pool: The equations.
        steps: All steps of an arm.
    """
    witnesses = build_witnesses(pool)
    unit = pool.problem.algebra.chain.size / FEW_SIZES
    return any(
        witnesses.largest([step.coefficient(letter) for letter in letters], OWN_LENGTHS, unit)
        < NEARLY_NOTHING
        for step in steps
        for letters in step.kind.value.divisors
    )

"""Where a step's equations say nothing about its unknown although that is not free.

X s + Y c = Z says nothing where X and Y vanish. Mostly the angle is free there, and the arm
singular; but what a wrist's last angle is read from may also vanish where an axis of the wrist is
parallel to one of the shoulder, which leaves nothing free. Such places are found by trying, and
the Jacobian tells what is free there.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.arm_angle import elbow_rates
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.task_rates import task_jacobian
from dhgen.paul.factors import Factors
from dhgen.paul.knowledge import initial_knowledge
from dhgen.paul.second import with_second_equations
from dhgen.paul.step import learn
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


def best_route(search: Search, pool: Pool) -> Route | None:
    """The cheapest order of steps, of those that are found to be silent least.

    Only what the search takes is looked into: most steps are never taken.
    """
    best: Route | None = None
    known: Known = {}
    for _ in range(ROUTES):
        route = search.best()
        if route is None:
            break
        steps = audited(pool, with_second_equations(pool, route.steps), known)
        if best is None or silence(steps) < silence(best.steps):
            best = replace(route, steps=steps)
        if not search.avoid(route, [place for place, step in enumerate(steps) if step.silent]):
            break
    return best


def silence(steps: Sequence[Step]) -> tuple[int, int]:
    """How many of an order's steps are often silent, and how many are silent at all."""
    return sum(step.silent == OFTEN for step in steps), sum(step.silent > 0 for step in steps)


def audited(pool: Pool, steps: Sequence[Step], known: Known) -> tuple[Step, ...]:
    """The steps of an order, each told under how many conditions it is silent.

    Args:
        pool: The equations.
        steps: All steps of an arm.
        known: What has been found out about steps; more is added.
    """
    found = []
    for knowledge, step in _with_knowledge(pool, steps):
        key = knowledge.state, step.unknowns, tuple(_saying(step))
        if key not in known:
            known[key] = _conditions(pool, knowledge, step)
        found.append(replace(step, silent=known[key]))
    return tuple(found)


def silent_places(pool: Pool, steps: Sequence[Step]) -> FloatArray:
    """Joint values where steps say nothing although their angles are not free, (n, dof)."""
    places = [_no_places(pool)]
    for knowledge, step in _with_knowledge(pool, steps):
        if step.silent:
            places.append(_silent_at(pool, knowledge, step))
    return np.concatenate(places)


def places_without_a_word(pool: Pool, steps: Sequence[Step]) -> FloatArray:
    """Joint values where steps say nothing, be their angles free or not, (n, dof)."""
    return np.concatenate([_no_places(pool), *(_wordless_at(pool, step) for step in steps)])


def _with_knowledge(pool: Pool, steps: Sequence[Step]) -> Iterator[tuple[Knowledge, Step]]:
    """Every step with what is known before it."""
    knowledge = initial_knowledge(pool.problem.algebra)
    for step in steps:
        yield knowledge, step
        knowledge = learn(knowledge, step)


def _conditions(pool: Pool, knowledge: Knowledge, step: Step) -> int:
    """How many conditions a step is silent under, at least; 0 if it never is."""
    factors = _factors(pool, step)
    if factors is None:
        return 0
    zeros = _silent_zeros(factors, knowledge, step)
    return max(OFTEN, factors.conditions(zeros)) if zeros.size else 0


def _silent_at(pool: Pool, knowledge: Knowledge, step: Step) -> FloatArray:
    """Some joint values where a step says nothing although its angle is not free, (n, dof)."""
    factors = _factors(pool, step)
    if factors is None:
        return _no_places(pool)
    return _joint_values(pool.problem.algebra.chain, _silent_zeros(factors, knowledge, step))


def _silent_zeros(factors: Factors, knowledge: Knowledge, step: Step) -> FloatArray:
    """The same as the algebra sees them, (dof, n)."""
    zeros = factors.zeros()
    if not zeros.size:
        return zeros
    q = _joint_values(knowledge.runs.algebra.chain, zeros)
    return np.asarray(zeros[:, _are_fixed(knowledge, step.angle, q)])


def _wordless_at(pool: Pool, step: Step) -> FloatArray:
    """Some joint values where a step says nothing about its angle, (n, dof)."""
    factors = _factors(pool, step)
    if factors is None:
        return _no_places(pool)
    return _joint_values(pool.problem.algebra.chain, factors.zeros())


def _no_places(pool: Pool) -> FloatArray:
    return np.empty((0, pool.problem.algebra.chain.dof))


def _factors(pool: Pool, step: Step) -> Factors | None:
    """What vanishes where a step says nothing about its angle, where that can be."""
    polynomials = _saying(step)
    if not polynomials or any(map(pool.problem.algebra.is_constant, polynomials)):
        return None
    return Factors(pool, polynomials)


def _saying(step: Step) -> list[Polynomial]:
    """What tells an angle by not being zero."""
    both = [step] if step.second is None else [step, step.second]
    found = [each.coefficient(letter) for each in both for letter in step.kind.value.leading]
    return [polynomial for polynomial in found if polynomial]


def _joint_values(chain: Chain, q: FloatArray) -> FloatArray:
    """Of what the algebra sees, as the caller sees them (n, dof)."""
    found = [
        joint.sign * (row * (chain.size if joint.kind is JointKind.PRISMATIC else 1) - joint.offset)
        for joint, row in zip(chain.joints, q, strict=True)
    ]
    return np.stack(found, axis=1)


def _are_fixed(knowledge: Knowledge, angle: AngleSum, q: FloatArray) -> FloatArray:
    """Whether an angle can't be turned while the pose and what is known are held, (n,)."""
    chain = knowledge.runs.algebra.chain
    arm = numeric_arm(chain)
    held = [
        _rates(chain, known) for known in knowledge.runs.algebra.angles if knowledge.knows(known)
    ]
    held += [np.eye(chain.dof)[joint - 1] for joint in sorted(knowledge.slides)]
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
        rates[joint - 1] = sign * chain.joints[joint - 1].sign
    return rates

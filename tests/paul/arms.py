"""Derivations, and their equations as numbers at joint values that nobody chose for them."""

from __future__ import annotations

from functools import cache
from itertools import chain as joined
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.build import build_chain
from dhgen.oracle.forward import forward
from dhgen.oracle.poses import random_joints
from dhgen.paul.equation import Equation, Origin
from dhgen.paul.form_reader import FormReader
from dhgen.paul.knowledge import initial_knowledge
from dhgen.paul.pool import Pool, build_pool
from dhgen.paul.problem import build_problem
from dhgen.paul.step import View
from dhgen.paul.witness import build_witnesses
from tests.derived import derived
from tests.kinematics.values import algebra_of, constant_values, joint_values, matrix, number
from tests.robots.cases import robot

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.derivation import Derivation
    from dhgen.paul.form import Form
    from dhgen.paul.step import EquationType, Step
    from dhgen.robot.robot import Robot

Values = dict[str, float]


@cache
def derivation(name: str) -> Derivation:
    """The derivation of a robot in robots/."""
    return derived(build_chain(robot(name)))


def values_of(arm: Robot, pool: Pool, q: FloatArray) -> Values:
    """Every generator at q; the pose by the oracle, which knows nothing of the chain."""
    problem, chain = pool.problem, pool.problem.algebra.chain
    constants = constant_values(chain)
    target = forward(arm, q).astype(float)
    if problem.base_left:
        target = np.linalg.inv(matrix(chain.base, constants)) @ target
    target = target @ np.linalg.inv(matrix(problem.tool_left, constants))
    values = joint_values(problem.algebra, q)
    values |= {f"t{i + 1}{j + 1}": float(target[i, j]) for i in range(3) for j in range(4)}
    for point in pool.points:
        place = target @ [*(number(c, constants) for c in point.in_tool), 1.0]
        values |= dict(zip(point.names, map(float, place[:3]), strict=True))
    return values


def random_values(name: str, count: int = 3) -> list[Values]:
    """Values of a robot at random configurations, lengths in units of the arm's size."""
    pool = derivation(name).pool
    return [values_of(robot(name), pool, q) for q in random_joints(robot(name), count, seed=11)]


def magnitude(polynomial: Polynomial, values: Mapping[str, float]) -> float:
    """The sizes of a polynomial's terms added up: what rounding is relative to."""
    positive = polynomial.ring.from_dict({m: abs(c) for m, c in polynomial.items()})
    return number(positive, {name: abs(value) for name, value in values.items()})


def assert_zero(polynomial: Polynomial, values: Mapping[str, float]) -> None:
    """Zero but for the rounding of its terms."""
    size = magnitude(polynomial, values)
    assert abs(number(polynomial, values)) <= 1e-12 * max(size, 1e-3), polynomial


class Names:
    """The generators of an arm as attributes: g.c12, g.t14, g.r3."""

    def __init__(self, algebra: Algebra) -> None:
        self._algebra = algebra

    def __getattr__(self, name: str) -> Polynomial:
        return self._algebra.generator(name)


class Bench:
    """Equations made by hand, as the types see them before anything is known."""

    def __init__(self, arm: Robot) -> None:
        self.pool = build_pool(build_problem(algebra_of(arm)))
        self.algebra = self.pool.problem.algebra
        self.names = Names(self.algebra)
        self.view = View(initial_knowledge(self.algebra), build_witnesses(self.pool))

    def forms(self, *polynomials: Polynomial) -> tuple[Form, ...]:
        zero = self.algebra.ring.zero
        dof = self.algebra.chain.dof
        equations = tuple(
            Equation(Origin(0, dof, dof, row, 4), (Origin(0, dof, dof, row, 4),), zero, each, each)
            for row, each in enumerate(polynomials, start=1)
        )
        reader = FormReader(Pool(self.pool.problem, equations, ()))
        return tuple(reader.every(self.view.knowledge, most=9))

    def why_not(self, equation_type: EquationType, *polynomials: Polynomial) -> str | None:
        """Why equations are not of a type."""
        offer = equation_type.steps(self.forms(*polynomials), self.view)
        return offer if isinstance(offer, str) else None

    def steps(self, equation_type: EquationType, *polynomials: Polynomial) -> list[Step]:
        """The steps of equations that the type accepts."""
        offer = equation_type.steps(self.forms(*polynomials), self.view)
        assert not isinstance(offer, str)
        return list(offer)


def all_steps(name: str) -> list[Step]:
    """Chosen and alternative."""
    found = derivation(name)
    return [*found.steps, *joined.from_iterable(found.offers)]

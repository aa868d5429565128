"""What a step works with: values by the algebra's names, the joints that are known, scales."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.algebra import POSE_PLACES, AngleSum
from dhgen.method import Method
from dhgen.paul.kind import Kind
from dhgen.program.building.builder import Builder
from dhgen.program.lowering.angles import Angles
from dhgen.program.lowering.arm_scale import Scales
from dhgen.program.lowering.polynomials import PolynomialLowering
from dhgen.program.lowering.target import Target
from dhgen.program.reserved import NOTHING, Reserved
from dhgen.program.role import Source

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.derivation import Derivation
    from dhgen.paul.pool import Pool
    from dhgen.paul.problem import Problem
    from dhgen.paul.step import Step
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.checks import Checks
    from dhgen.tolerances import Tolerances


@dataclass(frozen=True, slots=True)
class EarlierRoot:
    """A square root on whose sign later steps hang.

    Attributes:
        axis: The sign's place.
        share: Its value without sign, not zero, over what it is where lengths are the arm's size.
    """

    axis: int
    share: Node


class Lowering:
    """What kernels work with.

    Attributes:
        checks: What is done about rows that do not reproduce their pose.
        builder: Where values go.
        polynomials: Polynomials to values.
        angles: The joints that are known.
        scales: Tolerances and reaches.
        step_number: Of the step at hand, from 1.
        meeting: Whether roots of a polynomial nearly meet; only where rows are doubted.
        roots: The square roots so far, where rows are refined.
        steep: Whether the pose has no yaw, where the task names it and a joint is free then.
        short: Whether an angle comes from so short a vector that few of its digits are right.

    Args:
        derivation: What to compute, and why.
        tolerances: Of the arithmetic that the program is for.
        checks: What is done about rows that do not reproduce their pose.
        reserved: Names that are kept for others.
    """

    def __init__(
        self,
        derivation: Derivation,
        tolerances: Tolerances,
        checks: Checks,
        reserved: Reserved = NOTHING,
    ) -> None:
        self.checks = checks
        self._derivation = derivation
        self._problem = derivation.problem
        self._algebra = derivation.problem.algebra
        self._constants = {c.name: c for c in self._algebra.chain.constants}
        self._values: dict[str, Node] = {}
        self.builder = Builder(reserved.with_own({*self._constants, "T", "q", "status"}))
        self.polynomials = PolynomialLowering(self._algebra, self.builder, self.value)
        self.angles = Angles(self._algebra, self.builder, self.polynomials, self._values)
        if checks.completes:
            tolerances = replace(tolerances, reach=tolerances.reach_refined)
        self.scales = Scales(derivation.pool, self.builder, tolerances)
        self._target = Target(self._problem, self.builder, self.lower)
        self.step_number = 0
        self.meeting: list[Node] = []
        self.roots: list[EarlierRoot] = []
        self.short: list[Node] = []
        self.steep: Node | None = None

    def new_sign(self, suffix: str) -> Node:
        """The sign of the step at hand, numbered by the joint that it gives (document 004)."""
        return self.builder.sign(("+", "-"), self.step_number, f"e{suffix}")

    def new_root(self, angle: AngleSum, coefficients: tuple[Node, ...]) -> Node:
        """A root of the polynomial of the step at hand, which is an angle."""
        words = tuple(f"root{number}" for number in range(1, Kind.CIRCLE.value.roots + 1))
        chain = self._algebra.chain
        facing = np.zeros(chain.dof)
        for joint, sign in angle.terms:
            facing[joint - 1] = sign
        rates = enumerate(chain.drives.rates(facing).tolist(), start=1)
        turning = tuple((joint, int(rate)) for joint, rate in rates if rate)
        name = f"x{angle.suffix}"
        return self.builder.circle_root(name, coefficients, turning, words, self.step_number)

    def value(self, name: str) -> Node:
        """The value of one of the ring's generators."""
        if name not in self._values:
            self._values[name] = self._make(name)
        return self._values[name]

    def learn(self, values: dict[str, Node]) -> None:
        """Values of generators that no step solves for."""
        self._values |= values
        self.polynomials.solved(*values)

    def lower(self, polynomial: Polynomial) -> Node:
        """The value of a polynomial."""
        return self.polynomials.lower(polynomial)

    def at_seed(self, polynomial: Polynomial) -> Node:
        """The value of a polynomial where the joints have the seed's values."""
        return PolynomialLowering(self._algebra, self.builder, self._seed_value).lower(polynomial)

    @property
    def mends_roots(self) -> bool:
        """Whether rows that come from roots of a polynomial are refined."""
        return self._derivation.method is Method.QUARTIC and self.checks.completes

    @property
    def doubts_rows(self) -> bool:
        """Whether rows that miss the pose by far have none, though steps might refine them."""
        return self.checks.rows and self.checks.completes

    @property
    def may_be_lost(self) -> bool:
        """Whether a later step may find a branch out of reach."""
        return any(
            step.roots > 1 and not (step.kind is Kind.ANGLE and not step.coefficient("Z"))
            for step in self._derivation.steps[self.step_number :]
        )

    @property
    def earlier_steps(self) -> tuple[Step, ...]:
        """The steps before the one at hand."""
        return tuple(self._derivation.steps[: self.step_number - 1])

    @property
    def overdetermined(self) -> bool:
        """Whether poses may be given that the arm can't take."""
        return self._problem.overdetermined

    @property
    def pool(self) -> Pool:
        """All equations."""
        return self._derivation.pool

    @property
    def problem(self) -> Problem:
        """The equations."""
        return self._problem

    @property
    def algebra(self) -> Algebra:
        """The arm and its ring."""
        return self._algebra

    @property
    def chain(self) -> Chain:
        """The arm."""
        return self._algebra.chain

    def normal(self, polynomial: Polynomial) -> Polynomial:
        """The normal form of a polynomial."""
        return self._algebra.normal(polynomial)

    def are_constant(self, *polynomials: Polynomial) -> bool:
        """Whether all of these are made of the arm's lengths and twists alone."""
        return all(self._algebra.is_constant(polynomial) for polynomial in polynomials)

    def generators(self, angle: AngleSum) -> tuple[Polynomial, Polynomial]:
        """Sine and cosine of an angle sum as ring elements."""
        return self._algebra.generator(angle.sine), self._algebra.generator(angle.cosine)

    def _seed_value(self, name: str) -> Node:
        for angle in self._algebra.angles:
            if name == angle.cosine:
                return self.builder.apply("cos", self.angles.seed(angle))
            if name == angle.sine:
                return self.builder.apply("sin", self.angles.seed(angle))
        return self.value(name)

    def _make(self, name: str) -> Node:
        if name in self._constants:
            known = self._constants[name]
            power = int(known.is_length)
            return self.builder.constant(name, known.value, known.meaning, power, Source.ARM)
        if name in POSE_PLACES:
            entry = self._target.entry(*POSE_PLACES[name])
            return self.builder.name(entry, name)
        for point in self._derivation.pool.points:
            if name in point.names:
                row = point.names.index(name)
                return self.builder.name(self.point(row, point.in_tool), name)
        for base_point in self._derivation.pool.base_points:
            if name in base_point.names:
                column = base_point.names.index(name)
                return self.builder.name(self._seen(column, base_point.in_base), name)
        for angle in self._algebra.angles:
            if name in (angle.cosine, angle.sine):
                self.angles.compose(angle)
        return self._values[name]

    def point(self, row: int, in_tool: tuple[Polynomial, ...]) -> Node:
        """A coordinate of a point that is fixed to the tool."""
        builder = self.builder
        total = self.value(f"t{row + 1}4")
        for column, length in enumerate(in_tool):
            if length:
                part = builder.mul(self.value(f"t{row + 1}{column + 1}"), self.lower(length))
                total = builder.add(total, part)
        return total

    def _seen(self, column: int, in_base: tuple[Polynomial, ...]) -> Node:
        """A coordinate of a point that is fixed to the base, as the tool sees it."""
        builder = self.builder
        total = builder.integer(0)
        for row, length in enumerate(in_base):
            offset = builder.sub(self.lower(length), self.value(f"t{row + 1}4"))
            part = builder.mul(self.value(f"t{row + 1}{column + 1}"), offset)
            total = builder.add(total, part)
        return total

"""From a derivation to a program: prelude, one kernel a step, joint values, final check."""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial, reduce
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POSE_PLACES, AngleSum
from dhgen.method import Method
from dhgen.numerical.kernel import numerical_kernel
from dhgen.paul.branches import branch_words
from dhgen.paul.forms import unknown_name
from dhgen.paul.problem import telling_entries
from dhgen.paul.step import Kind
from dhgen.program.building.builder import Builder
from dhgen.program.ir import Failure
from dhgen.program.lowering.angles import Angles
from dhgen.program.lowering.arm_plane import lower_shoulder
from dhgen.program.lowering.checks import Checks, checks_needed
from dhgen.program.lowering.kernels import KERNELS
from dhgen.program.lowering.polynomials import PolynomialLowering
from dhgen.program.lowering.scales import Scales
from dhgen.program.lowering.target import Target
from dhgen.program.lowering.whole import whole_program
from dhgen.program.role import Source
from dhgen.program.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.derivation import Derivation
    from dhgen.paul.step import Step
    from dhgen.program.building.graph import Node
    from dhgen.program.building.schedule import Option
    from dhgen.program.ir import Program
    from dhgen.program.tolerances import Tolerances


def lower(derivation: Derivation, tolerances: Tolerances = TOLERANCES) -> Program:
    """The program of a derivation, for arithmetic with these tolerances."""
    chain = derivation.problem.algebra.chain
    if derivation.whole is not None:
        return whole_program(chain, derivation.whole)

    @cache  # the last that was tried is mostly the one that is wanted
    def lowered(checks: Checks) -> Program:
        return Lowering(derivation, tolerances, checks).run()

    checks = checks_needed(derivation, tolerances, lowered)
    program = lowered(checks)
    if not checks.tightened:
        return program
    kernel = numerical_kernel(chain, redundant=False)
    return replace(program, tightened=replace(kernel, checked=checks.rows, most=program.rows))


class Lowering:
    """What kernels work with.

    Attributes:
        builder: Where values go.
        polynomials: Polynomials to values.
        angles: The joints that are known.
        scales: Tolerances and reaches.
        step_number: Of the step at hand, from 1.
        meeting: Whether roots of a polynomial nearly meet; only where rows are doubted.
        short: Whether an angle comes from so short a vector that few of its digits are right.

    Args:
        derivation: What to compute, and why.
        tolerances: Of the arithmetic that the program is for.
        checks: What is done about rows that do not reproduce their pose.
    """

    def __init__(self, derivation: Derivation, tolerances: Tolerances, checks: Checks) -> None:
        self._checks = checks
        self._derivation = derivation
        self._problem = derivation.problem
        self._algebra = derivation.problem.algebra
        self._constants = {c.name: c for c in self._algebra.chain.constants}
        self._values: dict[str, Node] = {}
        self._words = branch_words(derivation.steps)
        self.builder = Builder(reserved={*self._constants, "T", "q", "status"})
        self.polynomials = PolynomialLowering(self._algebra, self.builder, self.value)
        self.angles = Angles(self._algebra, self.builder, self.polynomials, self._values)
        if checks.tightened:
            tolerances = replace(tolerances, reach=tolerances.led)
        self.scales = Scales(derivation.pool, self.builder, tolerances)
        self._target = Target(self._problem, self.builder, self.lower)
        self.step_number = 0
        self.meeting: list[Node] = []
        self.short: list[Node] = []

    def run(self) -> Program:
        """The whole program."""
        chain = self._algebra.chain
        for joint in chain.free:
            self.angles.take_given(joint)
        for number, step in enumerate(self._derivation.steps, start=1):
            self.step_number = number
            self.builder.heading(_unknowns(step), _source(step))
            KERNELS[step.kind](self, step)
            self._shoulder(step)
        if self._checks.rows:
            self._check()
        self.builder.heading("joint values")
        joints = {f"q{n}": self.angles.joint_value(n) for n in range(1, chain.dof + 1)}
        free = self.angles.free_joints()
        near = dict.fromkeys((*self.angles.near, *self.short))
        return self.builder.finish(chain.name, joints, free, near)

    def _shoulder(self, step: Step) -> None:
        """Once the elbow's angle is known the arm angle gives the shoulder's rotation."""
        plane = self._derivation.pool.plane
        if plane is None or plane.elbow_angle not in step.unknowns:
            return
        self.builder.heading("shoulder", f"its rotation, from the arm angle and {_unknowns(step)}")
        wrist = [self._point(row, plane.wrist_in_tool) for row in range(3)]
        found = lower_shoulder(self, plane, wrist)
        self._values |= found
        self.polynomials.solved(*found)

    def new_sign(self) -> Node:
        """The sign of the step at hand."""
        words = self._words[len(self.builder.axes)]
        return self.builder.sign(words, self.step_number)

    def new_root(self, angle: AngleSum, coefficients: tuple[Node, ...]) -> Node:
        """A root of the polynomial of the step at hand, which is an angle."""
        words = self._words[len(self.builder.axes)]
        joints = self._algebra.chain.joints
        turning = tuple((joint, sign * joints[joint - 1].sign) for joint, sign in angle.terms)
        name = f"x{angle.suffix}"
        return self.builder.circle_root(name, coefficients, turning, words, self.step_number)

    def value(self, name: str) -> Node:
        """The value of one of the ring's generators."""
        if name not in self._values:
            self._values[name] = self._make(name)
        return self._values[name]

    def lower(self, polynomial: Polynomial) -> Node:
        """The value of a polynomial."""
        return self.polynomials.lower(polynomial)

    def at_seed(self, polynomial: Polynomial) -> Node:
        """The value of a polynomial where the joints have the seed's values."""
        return PolynomialLowering(self._algebra, self.builder, self._seed_value).lower(polynomial)

    @property
    def mends_roots(self) -> bool:
        """Whether rows that come from roots of a polynomial are tightened."""
        return self._derivation.method is Method.QUARTIC and self._checks.tightened

    @property
    def doubts_rows(self) -> bool:
        """Whether rows that miss the pose by far have none, though steps might lead them there."""
        return self._checks.rows and self._checks.tightened

    @property
    def may_be_lost(self) -> bool:
        """Whether a later step may find a branch out of reach."""
        return any(
            step.roots > 1 and not (step.kind is Kind.ANGLE and not step.coefficient("Z"))
            for step in self._derivation.steps[self.step_number :]
        )

    @property
    def redundant(self) -> bool:
        """Whether poses may be given that the arm can't take."""
        return self._problem.redundant

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
                return self.builder.name(self._point(row, point.in_tool), name)
        for base_point in self._derivation.pool.base_points:
            if name in base_point.names:
                column = base_point.names.index(name)
                return self.builder.name(self._seen(column, base_point.in_base), name)
        for angle in self._algebra.angles:
            if name in (angle.cosine, angle.sine):
                self.angles.compose(angle)
        return self._values[name]

    def _point(self, row: int, in_tool: tuple[Polynomial, ...]) -> Node:
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

    def _check(self) -> None:
        """A pose with more entries than the arm can choose has to be one of its poses."""
        builder = self.builder
        builder.heading("is the pose one that the arm can take?")
        misses = self._misses()
        total = self._length(misses) if self._checks.again else None
        chosen = () if total is None else builder.deciding(self.angles.free_options(), total)
        groups: dict[tuple[int, ...], list[Node]] = {}  # by the signs that they depend on
        for miss, degree in misses:
            slack = self._slack(degree, chosen)
            near = builder.apply("at_most", builder.absolute(miss), slack)
            groups.setdefault(builder.axes_of(near), []).append(near)
        if total is None or not chosen:
            for group in groups.values():
                fits = reduce(partial(builder.apply, "and"), group)
                builder.guard(self._or_leads(fits, chosen), Failure.INCONSISTENT)
            return
        # all at once, so that the whole miss is known where a branch ends
        builder.name(total, "missed")
        every = [near for group in groups.values() for near in group]
        fits = reduce(partial(builder.apply, "and"), every)
        builder.guard(self._or_leads(fits, chosen), Failure.INCONSISTENT, total, chosen)

    def _or_leads(self, fits: Node, chosen: tuple[Option, ...]) -> Node:
        """Whether a row fits, or may stand between two that do, however far it misses the pose.

        Between roots that nearly meet, what follows from them may be anything. Where a joint was
        chosen another choice is looked for instead.
        """
        either, neither = partial(self.builder.apply, "or"), partial(self.builder.apply, "not")
        if not self.meeting:
            return fits
        leads = reduce(either, self.meeting)
        for option in chosen:
            leads = self.builder.apply("and", leads, neither(option.flag))
        return either(fits, leads)

    def _misses(self) -> list[tuple[Node, int]]:
        """What each entry that tells the task differs by, and the lengths in it: one or none."""
        builder, found = self.builder, []
        for name in sorted(telling_entries(self._algebra.chain.task)):
            row, column = POSE_PLACES[name]
            reached = self.lower(self._problem.forward.entry(row, column))
            miss = builder.sub(self.value(name), reached)
            if not builder.is_zero(miss):
                found.append((miss, int(column == 3)))
        return found

    def _slack(self, degree: int, chosen: tuple[Option, ...]) -> Node:
        """What an entry may differ by, of rounding of the pose or of what the row was taken from.

        What is to be tightened may differ by more, but not where another choice can mend it.
        """
        builder, scales = self.builder, self.scales
        tolerances = scales.tolerances
        slack = scales.tolerance(tolerances.consistent, degree, "consistent")
        if not self._checks.tightened:
            return slack
        wide = scales.tolerance(tolerances.doubtful, degree, "doubtful")
        flags = list(dict.fromkeys(option.flag for option in chosen))
        if not flags:
            return wide
        return builder.select(reduce(partial(builder.apply, "or"), flags), slack, wide)

    def _length(self, misses: list[tuple[Node, int]]) -> Node:
        """The root of the sum of their squares, lengths in arm sizes."""
        builder = self.builder
        squares: dict[int, list[Node]] = {}
        for miss, degree in misses:
            squares.setdefault(degree, []).append(builder.square(miss))
        total = builder.integer(0)
        for degree, group in sorted(squares.items()):
            part = reduce(builder.add, group)
            weighted = builder.mul(part, self.scales.weight(-2 * degree)) if degree else part
            total = builder.add(total, weighted)
        return builder.apply("sqrt", total)


def _unknowns(step: Step) -> str:
    return ", ".join(unknown_name(unknown) for unknown in step.unknowns)


def _source(step: Step) -> str:
    """The type, and where its equations stand."""
    origins = step.origins if step.second is None else (*step.origins, *step.second.origins)
    return f"type {step.kind.value}: {' and '.join(origin.name for origin in origins)}"

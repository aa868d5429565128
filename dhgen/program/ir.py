"""The program: straight-line single assignment over real numbers, typed by branch axes.

A value is not one number but an array over the branch axes it depends on: a value of type () is
one number, a value of type (e1, e3) four. An axis is a sign, +1 or -1, the choice among the roots
of a polynomial, or among the solutions of an algorithm that takes the whole arm, and these are the
only source of axes: the type of every other value is the union of its operands' types. A scalar
target loops over the axes, a vector target makes them lanes, a batch adds the axis of poses;
nothing is computed twice.

What the language does not have: loops, jumps, memory, functions of its own (the two algorithms,
`Roots` and `AllJoints`, are statements), types other than real and truth value, and floating-point
exceptions as a means of control. Divisors are guarded by selects, so that no operand is ever
infinite because of a branch that is not taken. A branch that has no solution fails a guard: its
rows are then without a solution, whatever its values are.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from enum import Enum
from itertools import product
from typing import TYPE_CHECKING, ClassVar, Literal

from dhgen.program.reserved import NOTHING, Reserved
from dhgen.program.role import Source

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.general.kernel import GeneralKernel
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.program.role import Role

Operator = Literal[
    "add",
    "sub",
    "mul",
    "div",
    "neg",
    "abs",
    "sqrt",
    "atan2",
    "copysign",
    "sin",
    "cos",
    "wrap",
    "select",
    "less",
    "at_most",
    "and",
    "or",
    "not",
    "maximum",
]


@dataclass(frozen=True, slots=True)
class Axis:
    """What multiplies the number of branches: a sign, or the choice of a root of a polynomial.

    Attributes:
        name: e1, e3, ... for signs, by the joint that the step gives; the name of the root's angle
            for polynomials.
        meaning: What its values are called, for signs + first: ("left", "right").
        step: The number of the derivation's step that brings it in, from 1.
        factors: Positions of other signs: the word goes by the product with these.
    """

    name: str
    meaning: tuple[str, ...]
    step: int
    factors: tuple[int, ...] = ()

    @property
    def count(self) -> int:
        """How many values it has."""
        return len(self.meaning)

    @property
    def words(self) -> tuple[str, ...]:
        """What its own values are called: a sign whose word goes by a product is + or -."""
        return ("+", "-") if self.factors else self.meaning


@dataclass(frozen=True, slots=True)
class Variable:
    """The value of an earlier `Let`, a constant, or a sign."""

    name: str


@dataclass(frozen=True, slots=True)
class Integer:
    """A small whole number."""

    value: int


@dataclass(frozen=True, slots=True)
class Pose:
    """An entry of the given pose T, row and column from 1."""

    row: int
    column: int


@dataclass(frozen=True, slots=True)
class Joint:
    """A value that the caller gives for a joint, from 1.

    The seed's or (in forward programs) the joint's own, by the joint's number; of the free joints
    the number-th.
    """

    number: int
    role: Literal["seed", "free", "q"]


@dataclass(frozen=True, slots=True)
class Apply:
    """An operator and its operands."""

    operator: Operator
    operands: tuple[Expression, ...]


Expression = Variable | Integer | Pose | Joint | Apply


@dataclass(frozen=True, slots=True)
class Let:
    """A value with a name.

    Attributes:
        name: Unique in the program.
        expression: What it is.
        axes: Positions in `Program.axes` of the signs it depends on, ascending.
        truth: Whether it is a truth value.
        named: Whether the name shows what it is; else it is only a number.
    """

    name: str
    expression: Expression
    axes: tuple[int, ...]
    truth: bool = False
    named: bool = True


class Failure(Enum):
    """Why a guard ends a branch."""

    REACH = "out of reach"
    ENDLESS = "a slide would have to be endless"
    MERGED = "the same solution as the branch with the other sign"
    INCONSISTENT = "the pose is none that this arm can take"


@dataclass(frozen=True, slots=True)
class Choice:
    """A joint whose value another one could replace, so that a guard might pass.

    Attributes:
        joint: Its number.
        flag: Name of the truth value of it.
        value: Where the joint is nearly free, the value that it has; None where it is free and has
            the seed's.
    """

    joint: int
    flag: str
    value: Expression | None = None


@dataclass(frozen=True, slots=True)
class Guard:
    """Ends the branches on which the condition is false.

    Attributes:
        condition: A truth value.
        axes: The signs it depends on.
        failure: Why.
        margin: For REACH, the value that must not be negative; where a joint chosen before may
            be to blame, the same for ENDLESS, and for INCONSISTENT by how much the pose is missed;
            else None.
        chosen: Joints that were free, or nearly so, before this guard.
    """

    condition: Expression
    axes: tuple[int, ...]
    failure: Failure
    margin: Expression | None = None
    chosen: tuple[Choice, ...] = ()


@dataclass(frozen=True, slots=True)
class Roots:
    """The real roots of a0 + a1 cos x + b1 sin x + a2 cos 2x + b2 sin 2x, ascending in (-pi, pi].

    Places without a root hold NaN. Which root is meant is an axis of its own, whose variable is x.

    Attributes:
        axis: Position of that axis in `Program.axes`.
        coefficients: a0, a1, b1, a2, b2, and what rounding may add to values.
        axes: The axes that the coefficients depend on.
        turning: The joints, from 1, whose values add up to x but for a constant, and their signs.
    """

    axis: int
    coefficients: tuple[Expression, ...]
    axes: tuple[int, ...]
    turning: tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True)
class AllJoints:
    """All joints at once, by an algorithm of its own, for every place of an axis.

    Attributes:
        axis: Position in `Program.axes` of the axis that chooses the solution.
        names: The joint values, or the angles of the algebra.
        found: The truth value of whether there is a solution at this place.
        chosen: The truth value of whether a joint was indeterminate there.
        descent: Damped least squares for this arm: the whole algorithm, or where another one's
            solutions are singular.
        general: The general algorithm where it goes first.
        given: Whether the caller gives the values of some joints.
        axes: None of any such statement: the pose, the seed and the given joints decide.
    """

    axes: ClassVar[tuple[int, ...]] = ()

    axis: int
    names: tuple[str, ...]
    found: str
    chosen: str
    descent: NumericalKernel
    general: GeneralKernel | None = None
    given: bool = False

    @property
    def method(self) -> str:
        """What the algorithm is called."""
        return self.descent.method if self.general is None else self.general.method


@dataclass(frozen=True, slots=True)
class Heading:
    """The step that the following statements belong to.

    Attributes:
        text: What becomes known.
        detail: How.
    """

    text: str
    detail: str = ""


Statement = Let | Guard | Roots | AllJoints | Heading


@dataclass(frozen=True, slots=True)
class NamedConstant:
    """A number of the arm or of the table of tolerances.

    Attributes:
        name: Its spelling in the expressions.
        value: Its value.
        meaning: For a comment: what it is, or its formula.
        power: The power of a length that it is, for its unit.
        role: What it is for whoever reads the program.
        parts: The constants that a formula names.
    """

    name: str
    value: float
    meaning: str
    power: int = 0
    role: Role = Source.MADE
    parts: tuple[NamedConstant, ...] = ()


@dataclass(frozen=True, slots=True)
class Program:
    """A solver without its surroundings (input check, limits, statuses), or a forward model.

    Attributes:
        name: The robot's identifier.
        constants: Every number that occurs.
        axes: The branch signs, in the order in which rows count: the first changes slowest.
        body: Statements; a name is used only after its `Let`.
        outputs: The results: each joint's value, or the entries of a matrix row by row.
        free: The truth values of whether a joint was chosen, by joint number; 0 for any of them.
        near: The truth values of whether one was nearly free, where that matters to a guard or,
            after roots of a polynomial, to the digits of a row.
        completion: Damped least squares for this arm, where rows that are not exact take some steps
            of it in the end; where the arm may not be able to take a pose, only rows that then
            reach it are kept. Where roots nearly meet, it looks for rows on both sides of them. It
            is left out of comparisons: its arrays can't be hashed, as programs are, and no program
            that is made from this one depends on it.
        refinement: Least squares for rows that miss the pose by more than is promised, where a
            branch follows an earlier root, or a twist is almost a right angle. A root has few
            digits where it nearly vanishes, and may then make a later branch end just before the
            pose.
        reserved: Names that are kept for others, the arm's numbers among them, whether they occur
            here or not: nothing else is called so, here or in a program that is made from this one.
    """

    name: str
    constants: tuple[NamedConstant, ...]
    axes: tuple[Axis, ...]
    body: tuple[Statement, ...]
    outputs: tuple[Expression, ...]
    free: tuple[tuple[int, str], ...]
    near: tuple[str, ...] = ()
    completion: NumericalKernel | None = field(default=None, compare=False)
    refinement: NumericalKernel | None = field(default=None, compare=False)
    reserved: Reserved = NOTHING

    @property
    def rows(self) -> int:
        """How many branches there are."""
        return self.combinations(range(len(self.axes)))

    @property
    def branches(self) -> tuple[str, ...]:
        """The name of every row, e.g. left-down-noflip; the first sign changes slowest."""
        names = []
        for chosen in product(*(range(axis.count) for axis in self.axes)):
            words = []
            for place, axis in zip(chosen, self.axes, strict=True):
                turned = sum(chosen[other] for other in axis.factors)
                words.append(axis.meaning[(place + turned) % axis.count])
            names.append("-".join(words) or "only")
        return tuple(names)

    @property
    def turning(self) -> tuple[tuple[int, int], ...]:
        """The joints, from 1, that turn the root of a polynomial, each with its sign."""
        found = (statement for statement in self.body if isinstance(statement, Roots))
        return next((statement.turning for statement in found), ())

    def combinations(self, axes: Iterable[int]) -> int:
        """How many values a value of this type has."""
        return math.prod(self.axes[axis].count for axis in axes)

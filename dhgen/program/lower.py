"""From a derivation to a program: prelude, one kernel a step, joint values, final check."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POSE_NAMES, AngleSum
from dhgen.paul.branches import branch_words
from dhgen.paul.knowledge import build_runs
from dhgen.paul.problem import task_entries
from dhgen.program.builder import Builder
from dhgen.program.ir import Failure
from dhgen.program.kernels import KERNELS
from dhgen.program.polynomials import PolynomialLowering
from dhgen.program.tolerances import TOLERANCES
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform
    from dhgen.paul.derivation import Derivation
    from dhgen.paul.forms import Unknown
    from dhgen.paul.knowledge import Cut
    from dhgen.paul.step import Step
    from dhgen.program.builder import Node
    from dhgen.program.ir import Program


def lower(derivation: Derivation) -> Program:
    """The program of a derivation."""
    return Lowering(derivation).run()


class Lowering:
    """The values known so far, by the names of the algebra's generators.

    Attributes:
        builder: Where values go.
        polynomials: Polynomials to values.
        size: The arm's size [length], which tolerances are relative to.
    """

    def __init__(self, derivation: Derivation) -> None:
        self._derivation = derivation
        self._problem = derivation.problem
        self._algebra = derivation.problem.algebra
        chain = self._algebra.chain
        self.builder = Builder(reserved={c.name for c in chain.constants} | {"T", "q", "status"})
        self.size = chain.size
        self.polynomials = PolynomialLowering(self._algebra, self.builder, self.value)
        self._values: dict[str, Node] = {}
        self._constants = {c.name: c for c in chain.constants}
        self._angles: dict[AngleSum, Node] = {}
        self._free: dict[int, list[Node]] = {}
        self._runs = build_runs(self._algebra)
        self._words = branch_words(derivation.steps)
        self.step_number = 0

    def run(self) -> Program:
        """The whole program."""
        chain = self._algebra.chain
        for joint in chain.free:
            self._take_given(joint)
        for number, step in enumerate(self._derivation.steps, start=1):
            self.step_number = number
            self.builder.heading(_title(step))
            KERNELS[step.kind](self, step)
        if self._problem.redundant:
            self._check()
        self.builder.heading("joint values")
        joints = {f"q{number}": self._joint(number) for number in range(1, chain.dof + 1)}
        free = [(joint, self._any(flags)) for joint, flags in sorted(self._free.items())]
        return self.builder.finish(chain.name, joints, free)

    def new_sign(self) -> Node:
        """The sign of the step at hand."""
        words = self._words[len(self.builder.axes)]
        return self.builder.sign(words, self.step_number)

    # values of generators

    def value(self, name: str) -> Node:
        """The value of a generator."""
        if name not in self._values:
            self._values[name] = self._make(name)
        return self._values[name]

    def lower(self, polynomial: Polynomial) -> Node:
        """The value of a polynomial."""
        for place, symbol in enumerate(polynomial.ring.symbols):
            if any(monomial[place] for monomial in polynomial):
                self.value(
                    str(symbol)
                )  # sums of angles are composed, and ranked, before they are used
        return self.polynomials.lower(polynomial)

    def constant(self, name: str, value: float, meaning: str) -> Node:
        """A number that is no length of the arm, such as a tolerance."""
        return self.builder.constant(name, value, meaning)

    def tolerance(self, relative: float, degree: int, kind: str) -> Node:
        """A tolerance for a value that is a product of `degree` lengths."""
        units = {0: "", 1: " [length]"}
        value = relative * self.size**degree
        unit = units.get(degree, f" [length^{degree}]")
        name = f"{kind}_tolerance{degree or ''}"
        return self.constant(name, value, f"{_REASONS[kind]}{unit}")

    @property
    def redundant(self) -> bool:
        """Whether poses may be given that the arm can't take."""
        return self._problem.redundant

    def algebra_constant(self, *polynomials: Polynomial) -> bool:
        """Whether all of these are made of the arm's lengths and twists alone."""
        return all(self._algebra.is_constant(polynomial) for polynomial in polynomials)

    def generators(self, angle: AngleSum) -> tuple[Polynomial, Polynomial]:
        """Sine and cosine of an angle sum as ring elements."""
        return self._algebra.generator(angle.sine), self._algebra.generator(angle.cosine)

    def extreme_reach(self, step: Step, meaning: str, widened: float = 0.0) -> tuple[Node, Node]:
        """Squares of the longest and shortest |V + W| of two links V and W that turn freely.

        Args:
            step: The step, with V and W made of lengths alone.
            meaning: For comments; {} is longest or shortest.
            widened: By how much both reaches are moved apart [arm sizes].
        """
        v, w = (
            math.hypot(*(self._number(step.coefficient(letter + part)) for part in "12"))
            for letter in "VW"
        )
        move = widened * self.size
        tail = {0.0: ""}.get(widened, "_reach" if widened > 0.0 else "_apart")
        longest = max(v + w + move, 0.0) ** 2
        shortest = max(abs(v - w) - move, 0.0) ** 2
        number = self.step_number
        return (
            self.constant(f"longest{number}{tail}", longest, meaning.format("longest")),
            self.constant(f"shortest{number}{tail}", shortest, meaning.format("shortest")),
        )

    def distances(self, degree: int) -> tuple[Node, Node]:
        """What rounding may do to a value of this many lengths: for reaching, and for merging."""
        reach = self.tolerance(TOLERANCES.reach, degree, "reach")
        return reach, self.tolerance(TOLERANCES.merge, degree, "merge")

    def _number(self, polynomial: Polynomial) -> float:
        """The value of a polynomial in the arm's constants."""
        values = {self._algebra.index[c.name]: c.value for c in self._constants.values()}
        total = 0.0
        for monomial, coefficient in polynomial.terms():
            part = int(coefficient.numerator) / int(coefficient.denominator)
            for place, exponent in enumerate(monomial):
                part *= values[place] ** exponent if exponent else 1.0
            total += part
        return total

    def degree(self, polynomial: Polynomial) -> int:
        """How many lengths are multiplied in a polynomial (0 for the zero polynomial)."""
        lengths = self._length_places()
        for monomial in polynomial:
            return sum(monomial[place] for place in lengths)
        return 0

    def _length_places(self) -> list[int]:
        names = ["t14", "t24", "t34", *self._algebra.slides.values()]
        names += [name for point in self._derivation.pool.points for name in point.names]
        names += [constant.name for constant in self._constants.values() if constant.is_length]
        return [self._algebra.index[name] for name in names]

    def _make(self, name: str) -> Node:
        if name in self._constants:
            known = self._constants[name]
            return self.builder.constant(name, known.value, known.meaning)
        if name in POSE_NAMES:
            return self.builder.name(self._target(int(name[1]) - 1, int(name[2]) - 1), name)
        for point in self._derivation.pool.points:
            if name in point.names:
                row = point.names.index(name)
                return self.builder.name(self._point(row, point.in_tool), name)
        for angle in self._algebra.angles:
            if name in (angle.cosine, angle.sine):
                self._composed(angle)
        return self._values[name]

    def _point(self, row: int, in_tool: tuple[Polynomial, ...]) -> Node:
        builder = self.builder
        total = self.value(f"t{row + 1}4")
        for column, length in enumerate(in_tool):
            if length:
                part = builder.mul(self.value(f"t{row + 1}{column + 1}"), self.lower(length))
                total = builder.add(total, part)
        return total

    def _target(self, row: int, column: int) -> Node:
        """An entry of U_0 = Z^-1 POS E^-1 from the entries of POS."""
        chain = self._algebra.chain
        builder = self.builder
        right = (
            _inverse(self._numbers(self._algebra.lift(chain.tool)), builder)
            if self._problem.tool_left
            else None
        )
        left = (
            _inverse(self._numbers(self._algebra.lift(chain.base)), builder)
            if self._problem.base_left
            else None
        )

        def moved(i: int) -> Node:
            """Entry i of the wanted column of POS E^-1."""
            if right is None:
                return builder.pose(i + 1, column + 1)
            total = builder.pose(i + 1, 4) if column == 3 else builder.integer(0)
            for j in range(3):
                total = builder.add(
                    total, builder.mul(builder.pose(i + 1, j + 1), right[j][column])
                )
            return total

        if left is None:
            return moved(row)
        total = left[row][3] if column == 3 else builder.integer(0)
        for i in range(3):
            if not builder.is_zero(left[row][i]):
                total = builder.add(total, builder.mul(left[row][i], moved(i)))
        return total

    def _numbers(self, transform: Transform) -> list[list[Node]]:
        return [[self.lower(transform.entry(i, j)) for j in range(4)] for i in range(3)]

    # angles

    def solved_angle(self, angle: AngleSum, cosine: Node, sine: Node, *, keep: bool = True) -> None:
        """An angle sum became known by its cosine and sine."""
        builder = self.builder
        builder.name(cosine, angle.cosine)
        builder.name(sine, angle.sine)
        self._values[angle.cosine], self._values[angle.sine] = cosine, sine
        self.polynomials.solved(angle.cosine, angle.sine)
        if keep:
            self._angles[angle] = builder.apply("atan2", sine, cosine)

    def solved_slide(self, name: str, value: Node) -> None:
        """The length of a prismatic joint became known."""
        self._values[name] = self.builder.name(value, name)
        self.polynomials.solved(name)

    def chosen(self, angle: AngleSum, flag: Node) -> None:
        """A joint of this angle sum takes the seed's value where the flag is true."""
        known = [j for j, _ in angle.terms if self._known_joint(j)]
        open_joints = [j for j, _ in angle.terms if j not in known]
        for joint in open_joints:
            self._free.setdefault(joint, []).append(flag)

    def free_flags(self) -> list[tuple[int, Node]]:
        """The joints that may have been chosen so far, with the truth values that say so."""
        return [(joint, flag) for joint, flags in self._free.items() for flag in flags]

    def seed_angle(self, angle: AngleSum) -> Node:
        """An angle sum with the seed's values for its unknown joints."""
        builder = self.builder
        total = builder.integer(0)
        for joint, sign in angle.terms:
            part = self._angle_of(joint) if self._known_joint(joint) else self._seed(joint)
            total = builder.add(total, part if sign > 0 else builder.neg(part))
        return total

    def _seed(self, joint: int) -> Node:
        return self._inner(joint, self.builder.seed(joint))

    def _inner(self, joint: int, given: Node) -> Node:
        """The angle or length of the algebra for a joint value."""
        builder = self.builder
        known = self._algebra.chain.joints[joint - 1]
        turned = given if known.sign > 0 else builder.neg(given)
        return builder.add(turned, self._offset(joint))

    def _offset(self, joint: int) -> Node:
        known = self._algebra.chain.joints[joint - 1]
        if known.offset == 0.0:
            return self.builder.integer(0)
        return self.constant(f"offset{joint}", known.offset, f"offset of joint {joint}")

    def _take_given(self, joint: int) -> None:
        value = self._inner(joint, self.builder.given(self._place_of_free(joint)))
        if joint in self._algebra.slides:
            self.solved_slide(self._algebra.slides[joint], value)
            return
        angle = AngleSum(((joint, 1),))
        cosine, sine = self.builder.apply("cos", value), self.builder.apply("sin", value)
        self.solved_angle(angle, cosine, sine, keep=False)
        self._angles[angle] = value

    def _place_of_free(self, joint: int) -> int:
        """Where the caller gives the value of a free joint, from 1."""
        return self._algebra.chain.free.index(joint) + 1

    def _known_joint(self, joint: int) -> bool:
        if joint in self._algebra.slides:
            return self._algebra.slides[joint] in self._values
        return self._path(joint) is not None

    def _path(self, joint: int) -> list[tuple[AngleSum, int]] | None:
        """Solved angle sums, with signs along the run, that add up to a joint's angle."""
        run, place = self._runs.place[joint]
        return self._connect((run, place), (run, place + 1))

    def _connect(self, start: Cut, end: Cut) -> list[tuple[AngleSum, int]] | None:
        """The shortest chain of solved angle sums between two cuts."""
        reached: dict[Cut, list[tuple[AngleSum, int]]] = {start: []}
        frontier = [start]
        while frontier:
            cut = frontier.pop(0)
            for angle in self._angles:
                low, high, sign = self._runs.ends(angle)
                for here, there, facing in ((low, high, sign), (high, low, -sign)):
                    if here == cut and there not in reached:
                        reached[there] = [*reached[cut], (angle, facing)]
                        frontier.append(there)
        return reached.get(end)

    def _angle_of(self, joint: int) -> Node:
        """The angle of a joint, in (-pi, pi] unless the caller gave it."""
        run, place = self._runs.place[joint]
        facing = self._runs.runs[run][place][1]
        path = self._path(joint)
        assert path is not None
        total = self.builder.integer(0)
        for angle, sign in path:
            part = self._angles[angle]
            total = self.builder.add(total, part if sign * facing > 0 else self.builder.neg(part))
        return total

    def _composed(self, angle: AngleSum) -> None:
        """Cosine and sine of an angle sum from those of solved ones."""
        start, end, facing = self._runs.ends(angle)
        path = self._connect(start, end)
        assert path is not None
        builder = self.builder
        cosine, sine = builder.integer(1), builder.integer(0)
        for part, sign in path:
            c, s = self._values[part.cosine], self._values[part.sine]
            s = s if sign * facing > 0 else builder.neg(s)
            cosine, sine = (
                builder.sub(builder.mul(cosine, c), builder.mul(sine, s)),
                builder.add(builder.mul(sine, c), builder.mul(cosine, s)),
            )
        self.solved_angle(angle, cosine, sine, keep=False)

    # results

    def _joint(self, number: int) -> Node:
        builder = self.builder
        known = self._algebra.chain.joints[number - 1]
        if number in self._algebra.chain.free:
            return builder.given(self._place_of_free(number))
        if known.kind is JointKind.PRISMATIC:
            inner = self._values[self._algebra.slides[number]]
        else:
            inner = self._angle_of(number)
        value = builder.sub(inner, self._offset(number))
        value = value if known.sign > 0 else builder.neg(value)
        direct = known.kind is JointKind.PRISMATIC or inner in self._angles.values()
        if direct and (known.kind is JointKind.PRISMATIC or known.offset == 0.0):
            return value
        return builder.apply("wrap", value)

    def _any(self, flags: list[Node]) -> Node:
        total = flags[0]
        for flag in flags[1:]:
            total = self.builder.apply("or", total, flag)
        return total

    def _check(self) -> None:
        """A pose with more entries than the arm can choose has to be one of its poses."""
        builder = self.builder
        builder.heading("is the pose one that the arm can take?")
        worst: Node | None = None
        entries = sorted(task_entries(self._algebra.chain.task))
        for name in entries:
            row, column = int(name[1]) - 1, int(name[2]) - 1
            reached = self.lower(self._problem.forward.entry(row, column))
            wanted = self.value(name)
            miss = builder.apply("abs", builder.sub(reached, wanted))
            scale = self.tolerance(TOLERANCES.consistent, int(column == 3), "consistent")
            miss = builder.div(miss, scale)
            worst = miss if worst is None else builder.apply("maximum", worst, miss)
        assert worst is not None
        inside = builder.apply("at_most", worst, builder.integer(1))
        builder.guard(inside, Failure.INCONSISTENT)


_REASONS = {
    "free": "a vector this short fixes no angle",
    "free_square": "the same, squared",
    "reach": "rounding at the boundary of the workspace",
    "merge": "two branches nearer than this are one",
    "consistent": "a pose may be rounded by this",
}


def _title(step: Step) -> str:
    return f"{', '.join(_label(u) for u in step.unknowns)}: type {step.kind.value}"


def _label(unknown: Unknown) -> str:
    return f"theta{unknown.suffix}" if isinstance(unknown, AngleSum) else unknown.name


def _inverse(rows: list[list[Node]], builder: Builder) -> list[list[Node]]:
    """The inverse of a rigid transform of program values."""
    turned = [[rows[j][i] for j in range(3)] for i in range(3)]
    for row in turned:
        total = builder.integer(0)
        for factor, length in zip(row, (rows[j][3] for j in range(3)), strict=True):
            total = builder.add(total, builder.mul(factor, length))
        row.append(builder.neg(total))
    return turned

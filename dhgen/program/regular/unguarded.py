"""A program without its guards: what is assumed of regular poses put in, and doubts as results."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial, reduce
from typing import TYPE_CHECKING

from dhgen.program.building.builder import Builder
from dhgen.program.building.tolerance_constants import tolerance_constant
from dhgen.program.ir import (
    Apply,
    Failure,
    Guard,
    Heading,
    Integer,
    Joint,
    Let,
    Pose,
    Variable,
)
from dhgen.program.regular.assumptions import Assumptions, Endings, joined, meeting
from dhgen.program.regular.directions import by_their_lengths
from dhgen.program.regular.limits import Limiting
from dhgen.program.regular.reach_boundary import ReachBoundary
from dhgen.program.regular.signed import Signed, SignedArithmetic
from dhgen.program.role import Tolerance

if TYPE_CHECKING:
    from dhgen.program.building.graph import Node
    from dhgen.program.ir import Expression, Program
    from dhgen.program.regular.limits import ArmLimits
    from dhgen.tolerances import Tolerances

FOLDED = "m"  # what the names of constants made here begin with
# Rounding of a pose may take a radicand so many times farther below zero than it may be and count
# as zero, where it comes from another root that is nearly zero.
ROUNDED_SQUARES = 1000


@dataclass(frozen=True, slots=True)
class Regular:
    """What is computed for a regular pose.

    Attributes:
        program: Without guards. Its outputs are those of a row, and then truth values of which
            one, in one branch, is enough to leave the pose to the whole program.
        joints: The values of the joints, NaN in all of them where a branch has no solution.
        outside: Whether one of them is outside its limits; None where there are no limits.
        within_slack: The truth value that joints are outside by rounding only; None where that is
            no matter.
        doubts: The other truth values: they are known before the values of the joints.
        fits: Where rows are refined, whether the row is exact, and whether it is near enough to be
            refined: if none is the former and one the latter, the pose may have been rounded.
    """

    program: Program
    joints: tuple[Expression, ...]
    outside: Expression | None
    within_slack: Expression | None
    doubts: tuple[Expression, ...]
    fits: tuple[Expression, ...]


class Unguarded:
    """The making of it, statement by statement."""

    def __init__(
        self,
        program: Program,
        limits: ArmLimits,
        kept: frozenset[str],
        tolerances: Tolerances,
    ) -> None:
        self._program = program
        self._kept = kept  # the inverse lengths that are left in front as long as they can
        self._limits = limits
        self._tolerances = tolerances
        # where regular poses end, by the names of limits below which an angle is free or blurred
        self._ends: dict[str, Signed] = {}
        self._slacks: dict[Node, tuple[Node, Node]] = {}  # what is exact, and what may be rounded
        self._exact = _compared(program)
        self._named = {s.name: s.expression for s in program.body if isinstance(s, Let)}
        self._builder = Builder(program.reserved, FOLDED)
        self._arithmetic = SignedArithmetic(self._builder)
        self._values: dict[str, Signed] = {}
        self._assumptions = Assumptions(program)
        self._doubts: list[Node] = []
        self._fits: list[tuple[Node, Node]] = []  # what is exact; what is near enough to be refined
        self._hardly_out: list[Node] = []  # out of reach by no more than rounding of a pose may do
        self._endings = Endings(self._builder)
        self._boundary = ReachBoundary(self._builder, tolerances)
        self._reached: Guard | None = None

    def run(self) -> Regular:
        """The whole body, then the outputs."""
        builder = self._builder
        for c in self._program.constants:
            node = builder.known(c)
            self._values[c.name] = Signed(node)
            match c.role:
                case Tolerance("free" | "free_square" | "near" | "near_square"):
                    self._ends[c.name] = Signed(self._end_of_regular(c.role, c.value))
                case Tolerance("doubtful", degree):
                    self._slacks[node] = self._exact_and_rounded(degree, c.value)
        for axis in self._program.axes:
            sign = builder.sign(axis.words, axis.step, axis.name)
            self._values[axis.name] = Signed(builder.integer(1), frozenset({sign}))
        for statement in self._program.body:
            self._take(statement)
        joints = [self._arithmetic.angle(self._value(o)) for o in self._program.outputs]
        limiting = Limiting(builder, self._limits)
        joints = [self._limited(limiting, place + 1, node) for place, node in enumerate(joints)]
        ended = self._endings.ended(joints)
        results = {f"q{place + 1}": node for place, node in enumerate(ended)}
        beyond = {"outside": limiting.outside(), "within_slack": limiting.within_slack()}
        results |= {name: node for name, node in beyond.items() if node is not None}
        count = len(results)
        doubts = builder.joined(self._doubts, "or")
        doubts = builder.disjunctions(d for d in doubts if not self._boundary.excludes(d))
        results |= {f"doubt{place + 1}": node for place, node in enumerate(doubts)}
        end = len(results)
        fits = zip(*self._fits, strict=True)
        for name, parts in zip(("exact", "near"), fits, strict=False):
            results[name] = reduce(partial(builder.apply, "and"), parts)
        if "near" in results:
            near = [results["near"], *self._hardly_out]
            results["near"] = reduce(partial(builder.apply, "or"), near)
        finished = builder.finish(self._program.name, results, [])
        outputs = dict(zip(results, finished.outputs, strict=True))
        return Regular(
            finished,
            joints=finished.outputs[: len(joints)],
            outside=outputs.get("outside"),
            within_slack=outputs.get("within_slack"),
            doubts=finished.outputs[count:end],
            fits=finished.outputs[end:],
        )

    def _limited(self, limiting: Limiting, joint: int, value: Node) -> Node:
        """A joint's value inside its limits; one that is given beyond them is left to the other."""
        match self._program.outputs[joint - 1]:
            case Variable(name) if (
                limiting.is_compared_by_direction(joint)
                and isinstance(angle := self._named[name], Apply)
                and angle.operator == "atan2"
            ):
                y, x = map(self._value, angle.operands)
                near = limiting.take_direction(joint, *self._arithmetic.direction(y, x))
                self._doubts += [] if near is None else [near]
                return value
            case Joint(role="free"):
                outside = limiting.is_outside(joint, value)
                self._doubts += [] if outside is None else [outside]
                return value
            case _:
                return limiting.limited(joint, value)

    def _end_of_regular(self, limit: Tolerance, value: float) -> Node:
        """Near to where a joint is free a pose is doubtful, too.

        The whole program takes a direction and all that follows from it from the same few digits;
        here an identity may bring in others.
        """
        table = self._tolerances
        ratio = table.regular / (table.free if limit.kind.startswith("free") else table.near)
        if limit.kind.endswith("square"):
            role, value = replace(limit, kind="doubt_square"), ratio**2 * value
        else:
            role, value = replace(limit, kind="doubt"), ratio * value
        return tolerance_constant(self._builder, role, value)

    def _exact_and_rounded(self, degree: int, slack: float) -> tuple[Node, Node]:
        """What a row may miss here, where none is refined: taken at once, and not for certain."""
        table, builder = self._tolerances, self._builder
        scale = slack / table.doubtful
        exact = tolerance_constant(builder, Tolerance("exact", degree), table.exact * scale)
        role = Tolerance("consistent", degree)
        return exact, tolerance_constant(builder, role, table.consistent * scale)

    def _take(self, statement: object) -> None:
        match statement:
            case Heading(text, detail):
                self._builder.heading(text, detail)
                self._reached = None
            case Let(name, expression) if self._assumptions.foresees(name, expression):
                pass
            case Let(name, expression):
                doubt = statement.truth and self._assumptions.denies(name)
                value = self._doubtful(expression) if doubt else self._value(expression)
                if not statement.truth and name not in self._exact:
                    value = self._arithmetic.sooner(value)
                self._values[name] = value
                if statement.named:
                    self._builder.hint(value.node, name)
                if doubt:
                    self._doubts.append(value.node)
            case Guard():
                self._guard(statement)

    def _guard(self, guard: Guard) -> None:
        match guard.failure:
            case Failure.MERGED:
                self._meet(guard)
            case Failure.INCONSISTENT:
                self._take_if_consistent(guard.condition)
            case Failure.ENDLESS:
                self._ends_unless(guard.condition)
            case Failure.REACH:
                self._end(guard)
                self._reached = guard

    def _meet(self, guard: Guard) -> None:
        """Branches that meet at a pose that is in reach are a doubt."""
        parts, reached = joined(meeting(guard), "or"), self._reached
        if reached is None or reached.margin is None:
            self._doubts += map(self._truth, parts)
            return
        apart, blurred = None, False
        for part in parts:
            match part:
                case Apply("not", (inner,)) if apart is None:
                    apart = inner
                case Apply("and", (Variable(name), Apply("not", (inner,)))) if (
                    name in self._program.near
                ):
                    apart, blurred = inner, True
                case _:
                    self._doubts.append(self._truth(part))
        assert apart is not None
        margin = self._arithmetic.plain(self._value(reached.margin))
        sides = self._truth(reached.condition), self._truth(apart)
        self._doubts.append(self._boundary.touches(margin, *sides, blurred=blurred))

    def _take_if_consistent(self, condition: Expression) -> None:
        """What must hold for the arm to take the pose, unless it does by an identity.

        n values |x| <= limit hold where the sum of their squares is at most limit^2, and do not
        where it is above n limit^2; between the two the pose is doubtful, and so it is above both
        where no sign is to blame, since then there is no branch that could be right. Where rows
        are refined only exact ones are taken at once. Equations may make far more than `limit` of
        what a pose is rounded by: then no row is exact, and one is near enough to be refined.
        """
        builder, arithmetic = self._builder, self._arithmetic
        misses: dict[Node, list[Node]] = {}
        for part in joined(condition, "and"):
            match part:
                case Apply("at_most", (size, limit)) if (miss := self._of_size(size)) is not None:
                    value = self._value(miss)
                    if not arithmetic.vanishes(value):
                        of = misses.setdefault(arithmetic.plain(self._value(limit)), [])
                        of.append(arithmetic.plain(value))
                case _:
                    self._endings.unless(self._truth(part))
        for limit_node, found in misses.items():
            accepted, allowed = self._slacks.get(limit_node, (limit_node, limit_node))
            signed = any(map(builder.axes_of, found))
            short = found if signed else by_their_lengths(builder, found)
            total = reduce(builder.add, map(builder.square, short))
            least = builder.square(accepted)
            doubtful = builder.apply("less", least, total)
            if signed:
                count = builder.integer(len(found))
                most = builder.mul(count, builder.square(allowed))
                exact = builder.apply("at_most", total, least)
                self._endings.unless(exact)
                if limit_node in self._slacks:
                    farthest = builder.mul(count, builder.square(limit_node))
                    self._fits.append((exact, builder.apply("at_most", total, farthest)))
                doubtful = builder.apply("and", doubtful, builder.apply("at_most", total, most))
            else:
                self._boundary.keeps(short, accepted)
            self._doubts.append(doubtful)

    def _of_size(self, size: Expression) -> Expression | None:
        """The x of |x|, which may have a name where it is used twice."""
        match size:
            case Apply("abs", (miss,)):
                return miss
            case Variable(name) if name in self._named:
                return self._of_size(self._named[name])
            case _:
                return None

    def _end(self, guard: Guard) -> None:
        """A branch ends where it would be out of reach."""
        if guard.margin is None:
            self._ends_unless(guard.condition)
        else:
            square = self._arithmetic.plain(self._value(guard.margin))
            self._boundary.ends_at_root(square)
            self._endings.at_root(square)
            self._note_hardly_out(guard.condition, square)

    def _note_hardly_out(self, condition: Expression, square: Node) -> None:
        """Where rounding of a pose may have put a branch out of reach that rows are refined to."""
        match condition:
            case Apply("less" | "at_most", (lowest, _)) if self._slacks:
                builder = self._builder
                below = builder.apply("less", square, builder.integer(0))
                limit = self._arithmetic.plain(self._value(lowest))
                wide = builder.mul(builder.integer(ROUNDED_SQUARES), limit)
                self._hardly_out.append(
                    builder.apply("and", below, builder.apply("at_most", wide, square))
                )

    def _ends_unless(self, condition: Expression) -> None:
        inside = self._truth(condition)
        self._boundary.ends(inside)
        self._endings.unless(inside)

    def _truth(self, expression: Expression) -> Node:
        return self._value(expression).node

    def _value(self, expression: Expression) -> Signed:
        builder = self._builder
        match expression:
            case Variable(name):
                value = self._values[name]
                if name in self._kept:
                    return Signed(builder.integer(1), value.signs, frozenset({value.node}))
                return value
            case Integer(value):
                return Signed(builder.integer(value))
            case Pose(row, column):
                return Signed(builder.pose(row, column))
            case Joint(number, role):
                given = builder.seed if role == "seed" else builder.given
                return Signed(given(number))
            case Apply("select", (condition, yes, no)):
                return self._choice(condition, yes, no)
            case Apply(operator, operands):
                parts = [self._value(operand) for operand in operands]
                return self._arithmetic.apply(operator, parts)

    def _doubtful(self, condition: Expression) -> Signed:
        """x <= limit with the limit of regular poses, where a joint is free or blurred below."""
        match condition:
            case Apply("at_most", (value, Variable(name))) if name in self._ends:
                return self._arithmetic.apply("at_most", [self._value(value), self._ends[name]])
        return self._value(condition)

    def _choice(self, condition: Expression, yes: Expression, no: Expression) -> Signed:
        known = self._assumptions.decided(condition)
        if known is not None:
            return self._value(yes if known else no)
        first, second, common = self._arithmetic.shared(self._value(yes), self._value(no))
        node = self._builder.select(self._truth(condition), first, second)
        return Signed(node, common.signs, common.factors)


def _compared(program: Program) -> frozenset[str]:
    """The values that are compared or under a root: written as they are, so that they are exact."""
    found: set[str] = set()

    def look(expression: Expression, *, exact: bool) -> None:
        match expression:
            case Variable(name) if exact:
                found.add(name)
            case Apply(operator, operands):
                keeps = operator in {"less", "at_most", "sqrt"} or (exact and operator == "select")
                for operand in operands:
                    look(operand, exact=keeps)
            case _:
                pass

    for statement in program.body:
        if isinstance(statement, Let):
            look(statement.expression, exact=False)
        elif isinstance(statement, Guard):
            look(statement.condition, exact=False)
    return frozenset(found)

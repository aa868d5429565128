"""The program of regular poses: without loops, guards or free joints, in values of narrow types.

Where a joint is free, or where two branches meet, a pose is singular, and what is to be done then
is the affair of the whole program. This one says which poses these are; for all others it assumes
that nothing of the kind happens, so that every choice between a formula and the seed is gone. A
row without a solution becomes NaN by itself: the square root of a negative number. On a doubtful
pose a divisor may be zero; what IEEE arithmetic makes of it does not count.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, reduce
from typing import TYPE_CHECKING, Literal

from dhgen.program.builder import Builder
from dhgen.program.count import count_operations
from dhgen.program.ir import (
    AllJoints,
    Apply,
    Failure,
    Guard,
    Heading,
    Integer,
    Joint,
    Let,
    Pose,
    Roots,
    Variable,
)
from dhgen.program.limits import Limiting
from dhgen.program.scales import DOUBTFUL, FREE_LIMIT
from dhgen.program.signed import Signed, SignedArithmetic
from dhgen.program.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.program.graph import Node
    from dhgen.program.ir import Expression, NamedConstant, Program
    from dhgen.program.limits import Limits
    from dhgen.program.tolerances import Tolerances

FOLDED = "m"  # what the names of constants made here begin with


@dataclass(frozen=True, slots=True)
class Regular:
    """What is computed for a regular pose.

    Attributes:
        program: Without guards. Its outputs are those of a row, and then truth values of which
            one, in one branch, is enough to leave the pose to the whole program.
        joints: The values of the joints, NaN in all of them where a branch has no solution.
        outside: Whether one of them is outside its limits; None where there are no limits.
        doubts: The truth values.
    """

    program: Program
    joints: tuple[Expression, ...]
    outside: Expression | None
    doubts: tuple[Expression, ...]


def regular(
    program: Program,
    limits: tuple[Limits | None, ...] = (),
    tolerances: Tolerances = TOLERANCES,
) -> Regular | None:
    """The program of regular poses.

    Args:
        program: The whole program.
        limits: Of every joint, None for one without; empty if they don't matter.
        tolerances: The table that the program was made with.

    Returns:
        None where branches are the roots of a polynomial.
    """
    if any(isinstance(statement, AllJoints | Roots) for statement in program.body):
        return None
    kept = inverses_kept(program, tolerances)
    return _made(program, limits or (None,) * len(program.outputs), kept, tolerances)


@cache  # every target asks for it
def _made(
    program: Program,
    limits: tuple[Limits | None, ...],
    kept: frozenset[str],
    tolerances: Tolerances,
) -> Regular:
    """With these inverses of lengths in front."""
    return _Regular(program, limits, kept, tolerances).run()


@cache
def inverses_kept(program: Program, tolerances: Tolerances) -> frozenset[str]:
    """The inverses of lengths that stay in front: one more as long as that makes it cheaper.

    Limits come after everything else, whatever is kept.

    Args:
        program: The whole program.
        tolerances: The table that the program was made with.
    """
    limits = (None,) * len(program.outputs)
    inverses = [s.name for s in program.body if isinstance(s, Let) and _is_inverse(s.expression)]
    kept: frozenset[str] = frozenset()
    cost = _cost(_made(program, limits, kept, tolerances).program)
    while True:
        tried = [kept | {name} for name in inverses if name not in kept]
        costs = [_cost(_made(program, limits, each, tolerances).program) for each in tried]
        if min(costs, default=cost) >= cost:
            return kept
        cost = min(costs)
        kept = tried[costs.index(cost)]


class _Regular:
    def __init__(
        self,
        program: Program,
        limits: tuple[Limits | None, ...],
        kept: frozenset[str],
        tolerances: Tolerances,
    ) -> None:
        self._program = program
        self._kept = kept  # the inverse lengths that stay in front as long as they can
        self._limits = limits
        self._tolerances = tolerances
        # how much farther from where a joint is free regular poses end
        self._wider = tolerances.near / tolerances.free
        self._slacks: dict[Node, tuple[Node, Node]] = {}  # what is exact, and what may be rounded
        self._exact = _compared(program)
        self._builder = Builder(reserved=set(), folded=FOLDED)
        self._arithmetic = SignedArithmetic(self._builder)
        self._values: dict[str, Signed] = {}
        self._assumed: dict[str, bool] = {}
        self._doubts: list[Node] = []
        self._endings: list[tuple[Node, Node]] = []
        self._reached: Guard | None = None

    def run(self) -> Regular:
        builder = self._builder
        for c in self._program.constants:
            node = builder.constant(c.name, c.value, c.meaning, c.power, derived=c.derived)
            self._values[c.name] = Signed(node)
            if c.name.startswith(FREE_LIMIT):
                self._widen(c)
            if c.name.startswith(DOUBTFUL):
                self._slacks[node] = self._exact_and_rounded(c)
        for axis in self._program.axes:
            sign = builder.sign(axis.meaning, axis.step)
            self._values[axis.name] = Signed(builder.integer(1), frozenset({sign}))
        self._assume()
        for statement in self._program.body:
            self._take(statement)
        joints = [self._arithmetic.angle(self._value(o)) for o in self._program.outputs]
        limiting = Limiting(builder)
        joints = [
            limiting.limited(place + 1, node, limits)
            for place, (node, limits) in enumerate(zip(joints, self._limits, strict=True))
        ]
        results = {f"q{place + 1}": self._ended(node) for place, node in enumerate(joints)}
        outside = limiting.outside()
        results |= {} if outside is None else {"outside": outside}
        count = len(results)
        doubts = builder.disjunctions(self._doubts)
        results |= {f"doubt{place + 1}": node for place, node in enumerate(doubts)}
        finished = builder.finish(self._program.name, results, [])
        outputs = finished.outputs
        return Regular(
            finished,
            joints=outputs[: len(joints)],
            outside=None if outside is None else outputs[len(joints)],
            doubts=outputs[count:],
        )

    def _widen(self, limit: NamedConstant) -> None:
        """Near to where a joint is free a pose is doubtful, too.

        The whole program takes a direction and all that follows from it from the same few digits;
        here an identity may bring in others.
        """
        factor = self._wider**2 if "squared" in limit.name else self._wider
        name, value = _wide(limit.name), factor * limit.value
        node = self._builder.constant(
            name, value, limit.meaning, limit.power, derived=limit.derived
        )
        self._values[name] = Signed(node)

    def _exact_and_rounded(self, slack: NamedConstant) -> tuple[Node, Node]:
        """What a row may miss here, where none is tightened: taken at once, and not for certain."""
        tolerances = self._tolerances
        parts = {
            "exact_slack": (tolerances.exact, "a row that misses the pose by no more is exact"),
            "pose_slack": (tolerances.consistent, "a pose may be rounded by this"),
        }
        exact, rounded = (
            self._builder.constant(
                slack.name.replace(DOUBTFUL, name),
                part * (slack.value / tolerances.doubtful),
                meaning,
                slack.power,
                derived=slack.derived,
            )
            for name, (part, meaning) in parts.items()
        )
        return exact, rounded

    def _assume(self) -> None:
        """No joint is free, no two branches meet."""
        for name in (*(name for _, name in self._program.free), *self._program.near):
            self._suppose(Variable(name), truth=False)
        for statement in self._program.body:
            if isinstance(statement, Guard) and statement.failure is Failure.MERGED:
                self._suppose(_met(statement), truth=False)

    def _suppose(self, condition: Expression, *, truth: bool) -> None:
        match condition:
            case Apply("not", (inner,)):
                self._suppose(inner, truth=not truth)
            case Apply("or" | "and" as both, parts) if truth == (both == "and"):
                for part in parts:
                    self._suppose(part, truth=truth)
            case Variable(name):
                self._assumed[name] = truth
                for statement in self._program.body:
                    if isinstance(statement, Let) and statement.name == name:
                        self._suppose(statement.expression, truth=truth)
            case _:
                pass

    def _take(self, statement: object) -> None:
        match statement:
            case Heading(text, detail):
                self._builder.heading(text, detail)
                self._reached = None
            case Let(name, expression) if self._foreseen(name, expression):
                pass
            case Let(name, expression):
                doubt = statement.truth and self._assumed.get(name) is False
                value = self._value(_widened(expression) if doubt else expression)
                if not statement.truth and name not in self._exact:
                    value = self._arithmetic.sooner(value, name)
                self._values[name] = value
                if not (name[0] == "v" and name[1:].isdigit()):
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
            case Failure.REACH:
                self._end(self._truth(guard.condition), guard.failure, guard.margin)
                self._reached = guard

    def _foreseen(self, name: str, expression: Expression) -> bool:
        """Whether a truth value follows from what is assumed of others; then it is assumed too."""
        if name in self._assumed:
            return False
        known = self._decided(expression)
        if known is not None:
            self._assumed[name] = known
        return known is not None

    def _meet(self, guard: Guard) -> None:
        """Branches that meet at a pose that is in reach are a doubt."""
        met, reached = self._sharp(_met(guard)), self._reached
        match None if reached is None else reached.condition:
            case None:
                self._doubts.append(self._truth(met))
            case Apply("at_most", (Apply("neg", (slack,)), margin)):
                # rounding may take more from D than keeps branches apart: one slack is for both
                size = self._arithmetic.apply("abs", [self._value(margin)])
                near = self._arithmetic.apply("at_most", [size, self._value(slack)])
                free = [each for each in _parts(met, "or") if isinstance(each, Variable)]
                self._doubts += [near.node, *map(self._truth, free)]
            case within:
                self._doubts.append(self._truth(Apply("and", (within, met))))

    def _sharp(self, met: Expression) -> Expression:
        """Without what needs an angle that is good to few digits: that is a doubt by itself."""
        match met:
            case Apply("or", (rest, Apply("and", (Variable(name), _)))) if (
                name in self._program.near
            ):
                return self._sharp(rest)
            case Apply("or", (rest, free)):
                return Apply("or", (self._sharp(rest), free))
            case _:
                return met

    def _take_if_consistent(self, condition: Expression) -> None:
        """What must hold for the arm to take the pose, unless it does by an identity.

        n values |x| <= limit hold where the sum of their squares is at most limit^2, and do not
        where it is above n limit^2; between the two the pose is doubtful, and so it is above both
        where no sign is to blame, since then there is no branch that could be right. Where rows
        are tightened only exact ones are taken at once.
        """
        builder, arithmetic = self._builder, self._arithmetic
        misses: dict[Node, list[Node]] = {}
        for part in _parts(condition, "and"):
            match part:
                case Apply("at_most", (Apply("abs", (miss,)), limit)):
                    value = self._value(miss)
                    if not arithmetic.vanishes(value):
                        of = misses.setdefault(arithmetic.plain(self._value(limit)), [])
                        of.append(builder.square(arithmetic.plain(value)))
                case _:
                    self._end(self._truth(part), Failure.INCONSISTENT, None)
        for limit_node, squares in misses.items():
            accepted, allowed = self._slacks.get(limit_node, (limit_node, limit_node))
            total, least = reduce(builder.add, squares), builder.square(accepted)
            doubtful = builder.apply("less", least, total)
            if builder.axes_of(total):
                most = builder.mul(builder.integer(len(squares)), builder.square(allowed))
                self._end(builder.apply("at_most", total, least), Failure.INCONSISTENT, None)
                doubtful = builder.apply("and", doubtful, builder.apply("at_most", total, most))
            self._doubts.append(doubtful)

    def _end(self, condition: Node, failure: Failure, margin: Expression | None) -> None:
        """What is NaN where a branch ends here and else zero, and what may be NaN with it."""
        builder = self._builder
        if failure is Failure.REACH and margin is not None:
            length = builder.apply("sqrt", self._arithmetic.plain(self._value(margin)))
            self._endings.append((length, builder.apply("sub", length, length)))
        else:
            none = builder.apply("sqrt", builder.integer(-1))
            ending = builder.select(condition, builder.integer(0), none)
            self._endings.append((ending, ending))

    def _ended(self, joint: Node) -> Node:
        """A joint's value, NaN where the branch has ended."""
        for cause, ending in self._endings:
            if not self._spoils(cause, joint, {}):
                joint = self._builder.add(joint, ending)
        return joint

    def _spoils(self, cause: Node, node: Node, seen: dict[Node, bool]) -> bool:
        """Whether a value is NaN for certain where another is."""
        if node not in seen:
            entry = self._builder.entries[node]
            if node == cause:
                seen[node] = True
            elif entry.operator == "select":
                seen[node] = all(self._spoils(cause, each, seen) for each in entry.operands[1:])
            elif entry.operator == "copysign":
                seen[node] = self._spoils(cause, entry.operands[0], seen)
            else:
                seen[node] = any(self._spoils(cause, each, seen) for each in entry.operands)
        return seen[node]

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

    def _choice(self, condition: Expression, yes: Expression, no: Expression) -> Signed:
        known = self._decided(condition)
        if known is not None:
            return self._value(yes if known else no)
        first, second, common = self._arithmetic.shared(self._value(yes), self._value(no))
        node = self._builder.select(self._truth(condition), first, second)
        return Signed(node, common.signs, common.factors)

    def _decided(self, condition: Expression) -> bool | None:
        """What is assumed of a condition."""
        match condition:
            case Variable(name):
                return self._assumed.get(name)
            case Apply("not", (inner,)):
                known = self._decided(inner)
                return None if known is None else not known
            case Apply("and" | "or" as operator, parts):
                decided = [self._decided(part) for part in parts]
                ending = operator == "or"
                if ending in decided:
                    return ending
                return None if None in decided else not ending
            case _:
                return None


def _parts(condition: Expression, operator: Literal["and", "or"]) -> list[Expression]:
    """What a condition joins by an operator, however deep."""
    match condition:
        case Apply(joined, operands) if joined == operator:
            return [part for each in operands for part in _parts(each, operator)]
        case _:
            return [condition]


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


def _is_inverse(expression: Expression) -> bool:
    """Whether a value is the inverse of a length, up to a sign."""
    match expression:
        case Apply("div", (Integer(1) | Variable(_), _)):
            return True
        case _:
            return False


def _cost(program: Program) -> int:
    """What a program takes, in multiplications."""
    count = count_operations(program)
    few = count.additions + count.multiplications + 4 * count.divisions
    return few + 6 * count.square_roots + 30 * count.arctangents


def _met(guard: Guard) -> Expression:
    """When the branches of both signs are the same: the guard is plus or not this."""
    match guard.condition:
        case Apply("or", (Apply("less", _), Apply("not", (met,)))):
            return met
        case Apply("or", (Apply("not", (met,)), Apply("less", _))):
            return met
    raise AssertionError(guard)


def _wide(name: str) -> str:
    return name.replace("free", "doubt", 1)


def _widened(condition: Expression) -> Expression:
    """x <= limit with a wider limit, where it is one below which a joint is free."""
    match condition:
        case Apply("at_most", (value, Variable(name))) if name.startswith(FREE_LIMIT):
            return Apply("at_most", (value, Variable(_wide(name))))
    return condition

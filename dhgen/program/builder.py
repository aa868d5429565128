"""Builds programs: every expression once (hash-consing), constants folded.

The builder works on numbered nodes; `finish` decides which of them get a name. A node is named when it
is used twice, when its user depends on more signs than it does (it is computed outside that user's
loop), or when a kernel asked for a name that a reader knows.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING

from dhgen.program.ir import (
    Apply,
    Axis,
    Expression,
    Failure,
    Guard,
    Heading,
    Integer,
    Joint,
    Let,
    NamedConstant,
    Pose,
    Program,
    Variable,
)

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.program.ir import Operator, Statement

Node = int

# Names of the emitted code's own variables and functions, in any target.
RESERVED = frozenset(
    {"T", "J", "R", "q", "q_seed", "q_free", "seed", "free_joints", "status", "row", "pose", "joint"}
    | {"math", "np", "njit", "prange", "fk", "ik", "ik_all", "ik_into", "ik_batch", "jacobian"}
    | {"solve", "wrap", "turn", "turned", "inside", "misfit", "straighten", "attempt", "lowest"}
    | {"highest", "weight", "revolute", "read_pose", "choose_again", "i1", "i2", "i3", "i4"}
    | {"NAME", "DOF", "JOINT_TYPES", "JOINT_LIMITS", "BRANCHES", "MAX_SOLUTIONS", "FREE_JOINTS"}
    | {"OK", "UNREACHABLE", "FREE_JOINT", "OUT_OF_LIMITS", "INVALID_POSE", "LOST", "Unreachable"}
)

TRUTHS = frozenset({"less", "at_most", "and", "or", "not"})
_COMMUTES = frozenset({"add", "mul", "and", "or", "maximum"})


@dataclass(frozen=True, slots=True)
class _Entry:
    """A node: a leaf expression, or an operator with operand nodes."""

    leaf: Expression | None
    operator: Operator | None
    operands: tuple[Node, ...]
    axes: tuple[int, ...]
    value: Fraction | None  # of integers and constants


@dataclass(slots=True)
class _Mark:
    """A guard or a heading between nodes."""

    position: Node
    heading: str | None = None
    condition: Node = -1
    margin: Node | None = None
    failure: Failure = Failure.REACH
    chosen: tuple[Node, ...] = ()
    axes: tuple[int, ...] = ()


@dataclass(slots=True)
class Builder:
    """A program in the making.

    Attributes:
        reserved: Names that values must not get.
        axes: The branch signs so far.
        folded: What the names of constants made from constants begin with.
    """

    reserved: set[str] = field(default_factory=set)
    axes: list[Axis] = field(default_factory=list)
    folded: str = "k"
    _entries: list[_Entry] = field(default_factory=list)
    _index: dict[object, Node] = field(default_factory=dict)
    _names: dict[Node, str] = field(default_factory=dict)
    _constants: dict[str, NamedConstant] = field(default_factory=dict)
    _used: set[str] = field(default_factory=set)
    _marks: list[_Mark] = field(default_factory=list)

    # leaves

    def integer(self, value: int) -> Node:
        """A whole number."""
        return self._add(_Entry(Integer(value), None, (), (), Fraction(value)))

    def constant(self, name: str, value: float, meaning: str) -> Node:
        """A number with a name; one that the targets use themselves gets a longer one."""
        name = name + "_" if name in RESERVED else name
        self._constants.setdefault(name, NamedConstant(name, value, meaning))
        self.reserved.add(name)
        return self._add(_Entry(Variable(name), None, (), (), Fraction(value)))

    def pose(self, row: int, column: int) -> Node:
        """An entry of the given pose, from 1."""
        return self._add(_Entry(Pose(row, column), None, (), (), None))

    def seed(self, joint: int) -> Node:
        """The seed's value of a joint."""
        return self._add(_Entry(Joint(joint, "seed"), None, (), (), None))

    def given(self, joint: int) -> Node:
        """The value that the caller gives for a free joint."""
        return self._add(_Entry(Joint(joint, "free"), None, (), (), None))

    def joint(self, number: int) -> Node:
        """The value of a joint, in forward programs."""
        return self._add(_Entry(Joint(number, "q"), None, (), (), None))

    def sign(self, meaning: tuple[str, str], step: int) -> Node:
        """A new branch sign."""
        place = len(self.axes)
        axis = Axis(f"e{place + 1}", meaning, step)
        self.axes.append(axis)
        self.reserved.add(axis.name)
        return self._add(_Entry(Variable(axis.name), None, (), (place,), None))

    # operators

    def apply(self, operator: Operator, *operands: Node) -> Node:
        """An operator that is not simplified."""
        if operator in _COMMUTES:
            operands = tuple(sorted(operands))
        axes = sorted({axis for operand in operands for axis in self._entries[operand].axes})
        return self._add(_Entry(None, operator, operands, tuple(axes), None))

    def add(self, left: Node, right: Node) -> Node:
        """left + right."""
        if self._is(left, 0):
            return right
        if self._is(right, 0):
            return left
        if (inner := self._negated(right)) is not None:
            return self.sub(left, inner)
        if (inner := self._negated(left)) is not None:
            return self.sub(right, inner)
        return self._folded("add", left, right)

    def sub(self, left: Node, right: Node) -> Node:
        """left - right."""
        if self._is(right, 0):
            return left
        if self._is(left, 0):
            return self.neg(right)
        if (inner := self._negated(right)) is not None:
            return self.add(left, inner)
        if left == right:
            return self.integer(0)
        if (inner := self._negated(left)) is not None:
            return self.neg(self.add(inner, right))
        return self._folded("sub", left, right)

    def mul(self, left: Node, right: Node) -> Node:
        """left * right."""
        for one, other in ((left, right), (right, left)):
            if self._is(one, 0):
                return one
            if self._is(one, 1):
                return other
            if self._is(one, -1):
                return self.neg(other)
            if (inner := self._negated(one)) is not None:
                return self.neg(self.mul(inner, other))
        return self._folded("mul", left, right)

    def div(self, left: Node, right: Node) -> Node:
        """left / right; a constant divisor becomes a factor."""
        if self._is(left, 0) or self._is(right, 1):
            return left
        value = self._entries[right].value
        if value is not None and self._entries[left].value is None:
            return self.mul(left, self._folded("div", self.integer(1), right))
        if (inner := self._negated(left)) is not None:
            return self.neg(self.div(inner, right))
        return self._folded("div", left, right)

    def neg(self, operand: Node) -> Node:
        """-operand."""
        entry = self._entries[operand]
        if isinstance(entry.leaf, Integer):
            return self.integer(-entry.leaf.value)
        if entry.operator == "neg":
            return entry.operands[0]
        if entry.operator == "sub":
            return self.sub(entry.operands[1], entry.operands[0])
        return self.apply("neg", operand)

    def absolute(self, operand: Node) -> Node:
        """Its size; of a constant here and now."""
        value = self._entries[operand].value
        if value is None:
            return self.apply("abs", operand)
        return operand if value >= 0 else self.neg(operand)

    def square(self, operand: Node) -> Node:
        """operand * operand, without its sign."""
        entry = self._entries[operand]
        inner = entry.operands[0] if entry.operator == "neg" else operand
        return self.mul(inner, inner)

    def select(self, condition: Node, yes: Node, no: Node) -> Node:
        """yes where the condition holds, else no."""
        return yes if yes == no else self.apply("select", condition, yes, no)

    def is_zero(self, node: Node) -> bool:
        """Whether a node is the number 0."""
        return self._is(node, 0)

    def axes_of(self, node: Node) -> tuple[int, ...]:
        """The signs that a node depends on."""
        return self._entries[node].axes

    # names and statements

    def name(self, node: Node, wanted: str) -> Node:
        """Gives a value a name that a reader knows, if it has none; returns the value."""
        entry = self._entries[node]
        if entry.operator is not None and node not in self._names and entry.operator != "neg":
            self._names[node] = self._unique(wanted)
        return node

    def heading(self, text: str) -> None:
        """A step begins."""
        self._marks.append(_Mark(len(self._entries), heading=text))

    def guard(
        self,
        condition: Node,
        failure: Failure,
        margin: Node | None = None,
        chosen: Iterable[tuple[int, Node]] = (),
    ) -> None:
        """Ends the branches on which the condition is false.

        Args:
            condition: What must hold.
            failure: Why it may not.
            margin: What must not be negative, if that is the condition.
            chosen: Joints that may have been chosen freely, with the truth value that says so;
                those whose choice has no influence on the margin are left out.
        """
        leaves = set() if margin is None else self._leaves(margin)
        flags = tuple(
            dict.fromkeys(flag for joint, flag in chosen if Joint(joint, "seed") in leaves)
        )
        mark = _Mark(len(self._entries), None, condition, margin, failure, flags)
        mark.axes = self._entries[condition].axes
        self._marks.append(mark)

    def finish(self, name: str, results: dict[str, Node], free: list[tuple[int, Node]]) -> Program:
        """The program with these results, by the names they get if they have none."""
        named = [self.name(node, wanted) for wanted, node in results.items()]
        for number, node in free:
            self._names.setdefault(node, self._unique(f"free{number}"))
        outputs = [*named, *(node for _, node in free)]
        live = self._live(outputs)
        self._name_shared(live, outputs)
        body = tuple(self._statements(live))
        used = _names_in(body)
        return Program(
            name=name,
            constants=tuple(c for c in self._constants.values() if c.name in used),
            axes=tuple(self.axes),
            body=body,
            outputs=tuple(self._expression(node) for node in named),
            free=tuple((number, self._names[node]) for number, node in free),
        )

    # the inside

    def _add(self, entry: _Entry) -> Node:
        key = (entry.leaf, entry.operator, entry.operands)
        if key not in self._index:
            self._index[key] = len(self._entries)
            self._entries.append(entry)
        return self._index[key]

    def _is(self, node: Node, value: int) -> bool:
        return self._entries[node].leaf == Integer(value)

    def _negated(self, node: Node) -> Node | None:
        entry = self._entries[node]
        if entry.operator == "neg":
            return entry.operands[0]
        if isinstance(entry.leaf, Integer) and entry.leaf.value < 0:
            return self.integer(-entry.leaf.value)
        return None

    def _folded(self, operator: Operator, left: Node, right: Node) -> Node:
        """Arithmetic on constants is done here, once, exactly."""
        first, second = self._entries[left].value, self._entries[right].value
        if first is None or second is None:
            return self.apply(operator, left, right)
        value = {
            "add": lambda: first + second,
            "sub": lambda: first - second,
            "mul": lambda: first * second,
            "div": lambda: first / second,
        }[operator]()
        if value.denominator == 1 and abs(value) < 100 and self._whole(left) and self._whole(right):
            return self.integer(int(value))
        key = ("folded", value)
        if key not in self._index:
            text = f"{self._describe(left)} {_SYMBOLS[operator]} {self._describe(right)}"
            self._index[key] = self._fold(value, text)
        return self._index[key]

    def _whole(self, node: Node) -> bool:
        return isinstance(self._entries[node].leaf, Integer)

    def _fold(self, value: Fraction, text: str) -> Node:
        count = sum(name.startswith(self.folded) for name in self._constants)
        name = self._unique(f"{self.folded}{count + 1}")
        self._constants[name] = NamedConstant(name, float(value), text)
        self._entries.append(_Entry(Variable(name), None, (), (), value))
        return len(self._entries) - 1

    def _describe(self, node: Node) -> str:
        leaf = self._entries[node].leaf
        if isinstance(leaf, Integer):
            return str(leaf.value)
        assert isinstance(leaf, Variable)
        known = self._constants[leaf.name]
        folded = leaf.name.startswith(self.folded) and any(
            s in known.meaning for s in (" + ", " - ", " * ", " / ")
        )
        return f"({known.meaning})" if folded else leaf.name

    def _unique(self, wanted: str) -> str:
        name = wanted
        while name in self._used or name in self.reserved or name in RESERVED:
            name += "_"
        self._used.add(name)
        return name

    def _live(self, outputs: list[Node]) -> set[Node]:
        """What the outputs and guards need."""
        pending = list(outputs)
        for mark in self._marks:
            if mark.heading is None:
                pending += [mark.condition, *mark.chosen]
                pending += [] if mark.margin is None else [mark.margin]
        live: set[Node] = set()
        while pending:
            node = pending.pop()
            if node not in live:
                live.add(node)
                pending += self._entries[node].operands
        return live

    def _name_shared(self, live: set[Node], outputs: list[Node]) -> None:
        uses: dict[Node, int] = dict.fromkeys(outputs, 1)
        wider: set[Node] = set()
        for node in sorted(live):
            entry = self._entries[node]
            for operand in entry.operands:
                uses[operand] = uses.get(operand, 0) + 1
                if self._entries[operand].axes != entry.axes:
                    wider.add(operand)
        for mark in self._marks:
            for wanted in (mark.condition, mark.margin, *mark.chosen):
                if wanted is not None and wanted >= 0:
                    uses[wanted] = uses.get(wanted, 0) + 1
            for node in mark.chosen:
                self._names.setdefault(node, self._unique(f"chosen{node}"))
        for node in sorted(live):
            entry = self._entries[node]
            if entry.operator in {None, "neg", "not"} or self._is_rare(entry):
                continue
            if (uses.get(node, 0) > 1 or node in wider) and node not in self._names:
                self._names[node] = self._unique(f"v{len(self._names) + 1}")

    def _is_rare(self, entry: _Entry) -> bool:
        """Whether a value costs nothing, or is wanted only where a joint is free: it stays in place."""
        leaves = [self._entries[operand].leaf for operand in entry.operands]
        if entry.operator == "less" and any(leaf in self._sign_names() for leaf in leaves):
            return True
        return entry.operator in {"cos", "sin"} and any(
            isinstance(leaf, Joint) and leaf.role == "seed"
            for operand in entry.operands
            for leaf in self._leaves(operand)
        )

    def _sign_names(self) -> list[Variable]:
        return [Variable(axis.name) for axis in self.axes]

    def _leaves(self, node: Node) -> set[Expression]:
        found: set[Expression] = set()
        pending, seen = [node], {node}
        while pending:
            entry = self._entries[pending.pop()]
            if entry.leaf is not None:
                found.add(entry.leaf)
            fresh = [operand for operand in entry.operands if operand not in seen]
            seen.update(fresh)
            pending += fresh
        return found

    def _statements(self, live: set[Node]) -> list[Statement]:
        statements: list[Statement] = []
        marks = sorted(enumerate(self._marks), key=lambda item: (item[1].position, item[0]))
        pending = [mark for _, mark in marks]
        for node in range(len(self._entries)):
            while pending and pending[0].position <= node:
                statements.append(self._statement(pending.pop(0)))
            if node in live and node in self._names and self._entries[node].operator is not None:
                entry = self._entries[node]
                truth = entry.operator in TRUTHS
                statements.append(Let(self._names[node], self._apply(node), entry.axes, truth))
        statements += [self._statement(mark) for mark in pending]
        return statements

    def _statement(self, mark: _Mark) -> Statement:
        if mark.heading is not None:
            return Heading(mark.heading)
        margin = None if mark.margin is None else self._expression(mark.margin)
        chosen = tuple(self._names[node] for node in mark.chosen)
        condition = self._expression(mark.condition)
        return Guard(condition, mark.axes, mark.failure, margin, chosen)

    def _expression(self, node: Node) -> Expression:
        if node in self._names:
            return Variable(self._names[node])
        return self._leaf(node) if self._entries[node].operator is None else self._apply(node)

    def _leaf(self, node: Node) -> Expression:
        leaf = self._entries[node].leaf
        assert leaf is not None
        return leaf

    def _apply(self, node: Node) -> Expression:
        entry = self._entries[node]
        assert entry.operator is not None
        return Apply(entry.operator, tuple(self._expression(operand) for operand in entry.operands))


_SYMBOLS = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


def _names_in(body: Iterable[Statement]) -> set[str]:
    names: set[str] = set()
    pending: list[Expression] = []
    for statement in body:
        match statement:
            case Let(_, expression):
                pending.append(expression)
            case Guard(condition, margin=margin):
                pending += [condition] if margin is None else [condition, margin]
    while pending:
        expression = pending.pop()
        if isinstance(expression, Variable):
            names.add(expression.name)
        elif isinstance(expression, Apply):
            pending += expression.operands
    return names

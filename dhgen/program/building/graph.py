"""Numbered nodes, every expression once (hash-consing), arithmetic on constants done exactly.

A number made of the arm's constants becomes a constant itself, with its formula as its meaning.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import prod
from typing import TYPE_CHECKING, Literal

from dhgen.program.ir import Axis, Expression, Integer, Joint, NamedConstant, Pose, Variable
from dhgen.program.reserved import NOTHING, Reserved
from dhgen.program.role import Source

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from dhgen.program.ir import Operator
    from dhgen.program.role import Role


Binding = Literal[0, 1, 2]
SUM: Binding = 0
PRODUCT: Binding = 1
ATOM: Binding = 2


@dataclass(frozen=True, slots=True)
class Formula:
    """A formula.

    Attributes:
        text: How it is written.
        power: The power of a length that its value is.
        binding: How tightly the text binds.
        names: The constants that it names.
    """

    text: str
    power: int = 0
    binding: Binding = ATOM
    names: frozenset[str] = frozenset()

    def within(self, binding: Binding) -> str:
        """The text where something binds this tightly."""
        return self.text if self.binding >= binding else f"({self.text})"


def combined(operator: Operator, left: Formula, right: Formula) -> Formula:
    """The formula of an operator on two others."""
    names = left.names | right.names
    match operator:
        case "add" | "sub":
            sign = "+" if operator == "add" else "-"
            text = f"{left.text} {sign} {right.within(PRODUCT)}"
            return Formula(text, max(left.power, right.power), SUM, names)
        case "mul" if left == right:
            return Formula(f"{left.within(ATOM)}^2", 2 * left.power, PRODUCT, names)
        case "mul":
            text = f"{left.within(PRODUCT)} * {right.within(PRODUCT)}"
            return Formula(text, left.power + right.power, PRODUCT, names)
        case _:
            text = f"{left.within(PRODUCT)} / {right.within(ATOM)}"
            return Formula(text, left.power - right.power, PRODUCT, names)


Node = int

_COMMUTES = frozenset({"add", "mul", "and", "or", "maximum"})
_ARITHMETIC = frozenset({"add", "sub", "mul", "div", "sqrt"})
_WHOLE = 100  # whole numbers up to here are written in the expressions


@dataclass(frozen=True, slots=True)
class Entry:
    """A node: a leaf expression, or an operator with operand nodes.

    Attributes:
        leaf: The expression of a leaf.
        operator: The operator of any other node.
        operands: Its operands.
        axes: The signs that the node depends on, ascending.
        value: The value of integers and constants.
    """

    leaf: Expression | None
    operator: Operator | None
    operands: tuple[Node, ...]
    axes: tuple[int, ...] = ()
    value: Fraction | None = None


class Graph:
    """The nodes of a program, and its constants and signs.

    Attributes:
        entries: The nodes by number; operands come before their operator.
        constants: By name.
        folded: Constants made from constants, by their leaf; they have no name yet.
        axes: The branch signs so far.
        impossible: Truth values that never hold: programs have no test of them.
        reserved: Names that are kept for others.
    """

    def __init__(self, reserved: Reserved = NOTHING) -> None:
        self.entries: list[Entry] = []
        self.constants: dict[str, NamedConstant] = {}
        self.folded: dict[Expression, NamedConstant] = {}
        self.axes: list[Axis] = []
        self.impossible: set[Node] = set()
        self.reserved = reserved
        self._own = set(reserved.own)
        self._used: set[str] = set()
        self._index: dict[object, Node] = {}
        self._formulas: dict[Node, Formula] = {}
        self._renamed: dict[tuple[str, bool], str] = {}

    def integer(self, value: int) -> Node:
        """A whole number."""
        return self._add(Entry(Integer(value), None, (), value=Fraction(value)))

    def constant(
        self,
        name: str,
        value: float,
        meaning: str,
        power: int = 0,
        role: Role = Source.MADE,
        parts: tuple[NamedConstant, ...] = (),
    ) -> Node:
        """A number with a name.

        Args:
            name: Its name; if the targets use it for something else, or if it is no name of the
                arm's own and the arm has one like it, it gets a longer one.
            value: Its value.
            meaning: For a comment.
            power: The power of a length that it is.
            role: What it is.
            parts: The constants that its meaning names, if that is a formula.
        """
        if role is not Source.FILE:
            name = self._constant_name(name, own=role is Source.ARM)
        self.constants.setdefault(name, NamedConstant(name, value, meaning, power, role, parts))
        node = self._add(Entry(Variable(name), None, (), value=Fraction(value)))
        self._formulas.setdefault(node, Formula(name, power, names=frozenset({name})))
        return node

    def known(self, constant: NamedConstant) -> Node:
        """A constant of another program."""
        of = constant
        return self.constant(of.name, of.value, of.meaning, of.power, of.role, of.parts)

    def angle(self, name: str, value: float, formula: Formula) -> Node:
        """A constant angle: its formula is more than the four operations."""
        return self.constant(name, value, f"{formula.text} [rad]", parts=self._parts(formula))

    def pose(self, row: int, column: int) -> Node:
        """An entry of the given pose, from 1."""
        return self._add(Entry(Pose(row, column), None, ()))

    def seed(self, joint: int) -> Node:
        """The seed's value of a joint."""
        return self._add(Entry(Joint(joint, "seed"), None, ()))

    def given(self, joint: int) -> Node:
        """The value that the caller gives for a free joint."""
        return self._add(Entry(Joint(joint, "free"), None, ()))

    def joint(self, number: int) -> Node:
        """The value of a joint, in forward programs."""
        return self._add(Entry(Joint(number, "q"), None, ()))

    def sign(self, meaning: tuple[str, ...], step: int, wanted: str = "") -> Node:
        """A new branch sign."""
        place = len(self.axes)
        axis = Axis(self.unique(wanted or f"e{place + 1}"), meaning, step)
        self.axes.append(axis)
        return self._add(Entry(Variable(axis.name), None, (), (place,)))

    def root(
        self, wanted: str, meaning: tuple[str, ...], step: int, inner: tuple[int, ...]
    ) -> Node:
        """The angle of a root of a polynomial whose coefficients depend on the axes `inner`."""
        place = len(self.axes)
        axis = Axis(self.unique(wanted), meaning, step)
        self.axes.append(axis)
        return self._add(Entry(Variable(axis.name), None, (), (*inner, place)))

    def apply(self, operator: Operator, *operands: Node) -> Node:
        """An operator that is not simplified."""
        if operator in _COMMUTES:
            operands = tuple(sorted(operands))
        axes = sorted({axis for operand in operands for axis in self.entries[operand].axes})
        return self._add(Entry(None, operator, operands, tuple(axes)))

    def arithmetic(self, operator: Operator, left: Node, right: Node) -> Node:
        """One of the four operations; on constants it is done here, once, exactly."""
        first, second = self.entries[left].value, self.entries[right].value
        if first is None or second is None:
            return self.apply(operator, left, right)
        value = _calculated(operator, first, second)
        whole = value.denominator == 1 and abs(value) < _WHOLE
        if whole and self._is_integer(left) and self._is_integer(right):
            return self.integer(int(value))
        return self.number(value, combined(operator, self.formula(left), self.formula(right)))

    def number(self, value: Fraction, formula: Formula) -> Node:
        """A constant made of the arm's by a formula."""
        key = ("folded", value)
        if key not in self._index:
            self._index[key] = self._fold(value, formula)
        return self._index[key]

    def formula(self, node: Node) -> Formula:
        """A constant in the formula of another: its name, or the formula of a folded one."""
        leaf = self.entries[node].leaf
        return Formula(str(leaf.value)) if isinstance(leaf, Integer) else self._formulas[node]

    def unique(self, wanted: str) -> str:
        """A name like the wanted one that nothing else has; it is taken from now on."""
        name = wanted
        while name in self._used or name in self._own or name in self.reserved.values:
            name += "_"
        self._used.add(name)
        return name

    def leaves(self, node: Node) -> set[Expression]:
        """The leaves that a node is made of."""
        return {entry.leaf for entry in self._made_of([node]) if entry.leaf is not None}

    def operations(self, nodes: Iterable[Node], beyond: int) -> int:
        """Arithmetic for all branches that nodes take besides what is numbered below `beyond`."""
        return sum(
            prod(self.axes[axis].count for axis in entry.axes)
            for entry in self._made_of(nodes, beyond)
            if entry.operator in _ARITHMETIC
        )

    def _made_of(self, nodes: Iterable[Node], beyond: int = 0) -> Iterator[Entry]:
        """Nodes and all that they are made of, each once, but what is numbered below `beyond`."""
        pending = [node for node in dict.fromkeys(nodes) if node >= beyond]
        seen = set(pending)
        while pending:
            entry = self.entries[pending.pop()]
            yield entry
            fresh = {operand for operand in entry.operands if operand >= beyond} - seen
            seen |= fresh
            pending += fresh

    def _add(self, entry: Entry) -> Node:
        key = (entry.leaf, entry.operator, entry.operands)
        if key not in self._index:
            self._index[key] = len(self.entries)
            self.entries.append(entry)
        return self._index[key]

    def _constant_name(self, name: str, *, own: bool) -> str:
        """The constant's name, equal in all programs of an arm: only the arm's names decide it."""
        key, kept = (name, own), self.reserved.is_kept_from_constants
        if key not in self._renamed:
            wanted = name
            while kept(wanted) or (wanted in self._own and not own):
                wanted, own = wanted + "_", False
            self._renamed[key] = wanted
            self._own.add(wanted)
        return self._renamed[key]

    def _is_integer(self, node: Node) -> bool:
        return isinstance(self.entries[node].leaf, Integer)

    def _fold(self, value: Fraction, formula: Formula) -> Node:
        """A constant without a name as yet: most are only parts of others."""
        node = len(self.entries)
        leaf = Variable(f"?{node}")
        self.folded[leaf] = NamedConstant(
            leaf.name, float(value), formula.text, formula.power, parts=self._parts(formula)
        )
        self.entries.append(Entry(leaf, None, (), value=value))
        self._formulas[node] = formula
        return node

    def _parts(self, formula: Formula) -> tuple[NamedConstant, ...]:
        return tuple(self.constants[name] for name in sorted(formula.names))


def _calculated(operator: Operator, left: Fraction, right: Fraction) -> Fraction:
    match operator:
        case "add":
            return left + right
        case "sub":
            return left - right
        case "mul":
            return left * right
        case _:
            return left / right

"""Numbered nodes, every expression once (hash-consing), arithmetic on constants done exactly.

A number made of the arm's constants becomes a constant itself, with its formula as its meaning.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from dhgen.program.ir import Axis, Expression, Integer, Joint, NamedConstant, Pose, Variable
from dhgen.program.reserved import RESERVED

if TYPE_CHECKING:
    from dhgen.program.ir import Operator

Node = int

_COMMUTES = frozenset({"add", "mul", "and", "or", "maximum"})
_SYMBOLS = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
_WHOLE = 100  # whole numbers up to here stand in the expressions themselves


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
        axes: The branch signs so far.
    """

    def __init__(self, reserved: set[str], folded: str) -> None:
        self.entries: list[Entry] = []
        self.constants: dict[str, NamedConstant] = {}
        self.axes: list[Axis] = []
        self._folded = folded
        self._reserved = set(reserved)
        self._used: set[str] = set()
        self._index: dict[object, Node] = {}

    def integer(self, value: int) -> Node:
        """A whole number."""
        return self._add(Entry(Integer(value), None, (), value=Fraction(value)))

    def constant(self, name: str, value: float, meaning: str) -> Node:
        """A number with a name; one that the targets use themselves gets a longer one."""
        name = name + "_" if name in RESERVED else name
        self.constants.setdefault(name, NamedConstant(name, value, meaning))
        self._reserved.add(name)
        return self._add(Entry(Variable(name), None, (), value=Fraction(value)))

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

    def sign(self, meaning: tuple[str, str], step: int) -> Node:
        """A new branch sign."""
        place = len(self.axes)
        axis = Axis(f"e{place + 1}", meaning, step)
        self.axes.append(axis)
        self._reserved.add(axis.name)
        return self._add(Entry(Variable(axis.name), None, (), (place,)))

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
        key = ("folded", value)
        if key not in self._index:
            text = f"{self._described(left)} {_SYMBOLS[operator]} {self._described(right)}"
            self._index[key] = self._fold(value, text)
        return self._index[key]

    def unique(self, wanted: str) -> str:
        """A name like the wanted one that nothing else has; it is taken from now on."""
        name = wanted
        while name in self._used or name in self._reserved or name in RESERVED:
            name += "_"
        self._used.add(name)
        return name

    def leaves(self, node: Node) -> set[Expression]:
        """The leaves that a node is made of."""
        found: set[Expression] = set()
        pending, seen = [node], {node}
        while pending:
            entry = self.entries[pending.pop()]
            if entry.leaf is not None:
                found.add(entry.leaf)
            fresh = [operand for operand in entry.operands if operand not in seen]
            seen.update(fresh)
            pending += fresh
        return found

    def _add(self, entry: Entry) -> Node:
        key = (entry.leaf, entry.operator, entry.operands)
        if key not in self._index:
            self._index[key] = len(self.entries)
            self.entries.append(entry)
        return self._index[key]

    def _is_integer(self, node: Node) -> bool:
        return isinstance(self.entries[node].leaf, Integer)

    def _fold(self, value: Fraction, text: str) -> Node:
        count = sum(name.startswith(self._folded) for name in self.constants)
        name = self.unique(f"{self._folded}{count + 1}")
        self.constants[name] = NamedConstant(name, float(value), text)
        self.entries.append(Entry(Variable(name), None, (), value=value))
        return len(self.entries) - 1

    def _described(self, node: Node) -> str:
        """A constant in the formula of another: its name, or the formula of a folded one."""
        leaf = self.entries[node].leaf
        if isinstance(leaf, Integer):
            return str(leaf.value)
        assert isinstance(leaf, Variable)
        known = self.constants[leaf.name]
        folded = leaf.name.startswith(self._folded) and any(
            f" {symbol} " in known.meaning for symbol in _SYMBOLS.values()
        )
        return f"({known.meaning})" if folded else leaf.name


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

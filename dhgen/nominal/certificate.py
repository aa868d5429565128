"""The regular program of the nearest arm, with what shows that its rows are next to all solutions.

Whatever joint values the arm takes to T, those that the caller gives among them, the nearest arm
takes them to a pose T' that is no farther from T than the two arms differ. So T' is in a ball
around T. Beside what the program computes at T it works out by how much that may differ in the ball
(see bounds). What depends on given values alone is the same at both. Branches end, or meet, where
something vanishes:

- Where what is under a root passes through zero two of them end together. It is known where it is
  negative all over the ball: there is no solution then. If it is negative at T alone, the pose is
  left. If it is positive at T there are two rows, and corrections of both decide.
- Where a divisor vanishes, or what is under a root and never negative, or what the program compares
  with a tolerance, a joint is indeterminate: there a pose is left whose ball reaches that.
"""

from __future__ import annotations

import re
from copy import deepcopy
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.nominal.bounds import Bounds, NoBoundError
from dhgen.program.building.builder import Builder
from dhgen.program.interpret import outputs
from dhgen.program.ir import Apply, Heading, Integer, Joint, Let, Pose, Variable
from dhgen.program.regular.unguarded import Regular
from dhgen.program.role import Source

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.arrays import FloatArray
    from dhgen.program.building.graph import Entry, Node
    from dhgen.program.ir import Expression, NamedConstant

OWN = "near"  # what the names of the nearest arm's numbers, and of others made here, begin with
COMPARISONS = frozenset({"less", "at_most"})
SIGNS = frozenset({"neg", "abs"})
POSES = 500  # by which values that may be negative are recognized
NEGATIVE = 1e-6  # times the largest value: less is rounding


def certified(solver: Regular, given: int, names: frozenset[str]) -> Regular | None:
    """The program, left where a branch may end within the deviation of a pose.

    Args:
        solver: The regular program of the nearest arm, without limits.
        given: How many values the caller gives. Behind them come two numbers: by how much its tool
            may be turned to that of the arm, and how far it may be away.
        names: Of the arm's own numbers, besides the nearest arm's.

    Returns:
        None where a value on which a branch may end has no bound.
    """
    if solver.fits or solver.outside is not None:
        return None
    try:
        return _Certificate(solver, given, names).run()
    except NoBoundError:
        return None


def _beginning(names: frozenset[str]) -> str:
    """What no other name begins with."""
    word = OWN
    while any(name.startswith(word) for name in names):
        word += "r"
    return word


class _Certificate:
    def __init__(self, solver: Regular, given: int, names: frozenset[str]) -> None:
        self._solver = solver
        self._word = word = _beginning(names)
        known = solver.program.reserved
        kept = replace(known, values=known.values | names, constants=known.constants | names)
        self._builder = Builder(kept, word)
        turned, moved = self._builder.given(given + 1), self._builder.given(given + 2)
        self._bounds = Bounds(self._builder, turned, moved)
        self._values: dict[str, Node] = {}

    def run(self) -> Regular:
        builder, program = self._builder, self._solver.program
        own = {constant.name for constant in program.constants} | program.reserved.own
        own |= {part.name for constant in program.constants for part in constant.parts}
        names = "|".join(map(re.escape, sorted(own)))
        for constant in program.constants:
            self._values[constant.name] = self._constant(constant, names)
        for axis in program.axes:
            self._values[axis.name] = builder.sign(axis.words, axis.step, axis.name)
        for statement in program.body:
            match statement:
                case Heading(text, detail):
                    builder.heading(text, detail)
                case Let(name, expression):
                    self._values[name] = self._value(expression)
                    if statement.named:
                        builder.hint(self._values[name], name)
        joints = [self._value(joint) for joint in self._solver.joints]
        doubted = [self._value(doubt) for doubt in self._solver.doubts]
        builder.heading("by how much these differ at poses so near: slopes and rests")
        doubts = builder.disjunctions([*doubted, *self._near(joints, doubted)])
        results = {f"q{place + 1}": node for place, node in enumerate(joints)}
        results |= {f"doubt{place + 1}": node for place, node in enumerate(doubts)}
        finished = builder.finish(program.name, results, [])
        count = len(joints)
        return Regular(finished, finished.outputs[:count], None, None, finished.outputs[count:], ())

    def _constant(self, constant: NamedConstant, names: str) -> Node:
        """A number of the nearest arm under a name of its own, also where others are made of it."""
        if constant.role is Source.FILE:
            return self._builder.known(constant)
        near = self._renamed(constant, names)
        role = Source.MADE if near.role is Source.ARM else near.role
        return self._builder.known(replace(near, role=role))

    def _renamed(self, constant: NamedConstant, names: str) -> NamedConstant:
        return replace(
            constant,
            name=f"{self._word}_{constant.name}",
            meaning=re.sub(rf"\b(?:{names})\b", rf"{self._word}_\g<0>", constant.meaning),
            parts=tuple(self._renamed(part, names) for part in constant.parts),
        )

    def _value(self, expression: Expression) -> Node:
        match expression:
            case Variable(name):
                return self._values[name]
            case Integer(value):
                return self._builder.integer(value)
            case Pose(row, column):
                return self._builder.pose(row, column)
            case Apply(operator, operands):
                return self._builder.simplified(operator, [self._value(each) for each in operands])
            case Joint(number, "free"):
                return self._builder.given(number)
            case Joint():
                raise NoBoundError

    def _near(self, joints: list[Node], doubted: list[Node]) -> Iterator[Node]:
        """Where a branch may end within the ball, or two of them meet."""
        entries = [self._entry(node) for node in self._reached([*joints, *doubted])]
        roots = [entry.operands[0] for entry in entries if entry.operator == "sqrt"]
        divisors = [entry.operands[1] for entry in entries if entry.operator == "div"]
        crossing = self._may_be_negative(list(dict.fromkeys(roots)))
        compared = [
            factor
            for entry in map(self._entry, self._reached(doubted))
            if entry.operator in COMPARISONS
            for operand in entry.operands
            for factor in self._factors(operand, crossing)
        ]
        whole = [root for root in roots if root not in crossing]
        doubts = [
            *map(self._may_begin, crossing),
            *map(self._may_vanish, dict.fromkeys([*divisors, *whole, *compared])),
        ]
        yield from (doubt for doubt in doubts if doubt is not None)

    def _may_be_negative(self, nodes: list[Node]) -> list[Node]:
        """Which values pass through zero: they are negative at some poses."""
        if not nodes:
            return []
        results = {f"root{place}": node for place, node in enumerate(nodes)}
        program = deepcopy(self._builder).finish(self._solver.program.name, results, [])
        size = sum(abs(each.value) for each in program.constants if each.power == 1)
        source = np.random.default_rng(0)
        poses = _random_poses(source, size)
        given = source.uniform(-np.pi, np.pi, (POSES, self._given()))
        found = outputs(program, poses, free=given)
        return [
            node
            for node, values in zip(nodes, found, strict=True)
            if np.nanmin(values) < -NEGATIVE * np.nanmax(np.abs(values))
        ]

    def _given(self) -> int:
        leaves = (self._entry(node).leaf for node in range(len(self._builder.entries)))
        return max((leaf.number for leaf in leaves if isinstance(leaf, Joint)), default=0)

    def _reached(self, results: list[Node]) -> list[Node]:
        """Nodes and all that they are made of, in their order."""
        pending, seen = list(results), set(results)
        while pending:
            fresh = set(self._entry(pending.pop()).operands) - seen
            seen |= fresh
            pending += sorted(fresh)
        return sorted(seen)

    def _factors(self, node: Node, known: list[Node]) -> Iterator[Node]:
        """What a product vanishes with, but what is known, and roots of that."""
        entry = self._entry(node)
        if node in known:
            return
        if entry.operator in SIGNS or entry.operator in ("mul", "sqrt"):
            for operand in entry.operands:
                yield from self._factors(operand, known)
        elif entry.operator is not None or isinstance(entry.leaf, Pose):
            yield node

    def _may_begin(self, node: Node) -> Node | None:
        """Whether what is under a root is negative here, and may be positive within the ball.

        None of a value that does not change in it: the program's own test is enough.
        """
        builder, radius = self._builder, self._bounds.radius(node)
        if radius is None:
            return None
        twice = builder.add(node, node)
        return builder.apply("at_most", builder.absolute(builder.add(twice, radius)), radius)

    def _may_vanish(self, node: Node) -> Node | None:
        """Whether a value may be zero within the ball; None as above."""
        limit = self._bounds.near_zero(node)
        if limit is None:
            return None
        return self._builder.apply("at_most", self._builder.absolute(node), limit)

    def _entry(self, node: Node) -> Entry:
        return self._builder.entries[node]


def _random_poses(source: np.random.Generator, size: float) -> FloatArray:
    """Poses in reach and out of it."""
    poses = np.zeros((POSES, 4, 4))
    poses[:, :3, :3] = np.linalg.qr(source.normal(size=(POSES, 3, 3)))[0]
    poses[:, :3, :3] *= np.linalg.det(poses[:, :3, :3])[:, None, None]
    poses[:, :3, 3] = source.normal(0.0, 0.5 * size, (POSES, 3))
    poses[:, 3, 3] = 1.0
    return poses

"""Programs of regular poses as straight-line code: branches unrolled, or side by side in lanes.

Some of the axes are lanes; for every combination of the others each value is computed under a
name of its own: c3_pm is c3 where the first of the signs it depends on is plus, the second minus.
With all axes unrolled nothing is left but arithmetic on the pose: one program for one pose at a
time, and for many in lanes of poses.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial, reduce
from itertools import product
from typing import TYPE_CHECKING

from dhgen.program.building.builder import Builder
from dhgen.program.ir import Apply, Heading, Integer, Joint, Let, Pose, Variable

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.building.graph import Node
    from dhgen.program.ir import Expression, Program
    from dhgen.program.regular.unguarded import Regular

FOLDED = "h"  # what the names of constants made here begin with
PLUS, MINUS = 1, -1

Choice = tuple[int, ...]  # the values of unrolled axes, in their order


@dataclass(frozen=True, slots=True)
class Flat:
    """Straight-line code for one pose or for many.

    Attributes:
        program: Its axes are the lanes. Its outputs are the joints' values for each of the
            choices, whether one is outside its limits for each of them, the doubts and the fits.
        joints: Number of joints.
        limited: Whether there are limits.
        doubts: Whether the pose has to be left to the whole program, one truth value for each
            type, and the last ones of what is known when the joints' values are.
        fits: Where rows are refined and some signs are lanes, whether a row is exact, and whether
            one is near enough to be refined: if none is the former and one the latter, the pose has
            to be left to the whole program, too. Without lanes this is one of the doubts.
        choices: The values of the unrolled signs, in the order of the outputs.
        lanes: The axes of the original program that are lanes.
        unrolled: The others.
    """

    program: Program
    joints: int
    limited: bool
    doubts: tuple[Expression, ...]
    fits: tuple[Expression, ...]
    choices: tuple[Choice, ...]
    lanes: tuple[int, ...]
    unrolled: tuple[int, ...]

    @property
    def groups(self) -> tuple[tuple[Expression, ...], ...]:
        """The joints' values for each of the choices."""
        outputs, size = self.program.outputs, self.joints
        return tuple(outputs[k * size : (k + 1) * size] for k in range(len(self.choices)))

    @property
    def outside(self) -> tuple[Expression, ...]:
        """Whether a joint is outside its limits, for each of the choices; empty without limits."""
        outputs, size = self.program.outputs, len(self.choices)
        return outputs[self.joints * size :][: size if self.limited else 0]


def flatten(solver: Regular, lanes: tuple[int, ...] = ()) -> Flat:
    """Straight-line code.

    Args:
        solver: The program of regular poses.
        lanes: Positions of the axes that are kept; the others are unrolled.
    """
    return _Flattening(solver, lanes).run()


class _Flattening:
    def __init__(self, solver: Regular, lanes: tuple[int, ...]) -> None:
        self._solver = solver
        self._program = solver.program
        self._lanes = lanes
        axes = range(len(self._program.axes))
        self._unrolled = tuple(axis for axis in axes if axis not in lanes)
        self._builder = Builder(self._program.reserved, FOLDED)
        self._values: dict[tuple[str, Choice], Node] = {}
        self._axes: dict[str, tuple[int, ...]] = {}
        self._angles: dict[Node, int] = {}

    def run(self) -> Flat:
        self._leaves()
        builder = self._builder
        for statement in self._program.body:
            if isinstance(statement, Heading):
                builder.heading(statement.text, statement.detail)
            elif isinstance(statement, Let):
                self._let(statement)
        choices = tuple(product((PLUS, MINUS), repeat=len(self._unrolled)))
        results: dict[str, Node] = {}
        for choice in choices:
            for place, output in enumerate(self._solver.joints):
                name = _name(f"q{place + 1}", choice)
                results[name] = builder.hint(self._value(output, self._unrolled, choice), name)
        if self._solver.outside is not None:
            for choice in choices:
                name = _name("outside", choice)
                results[name] = self._value(self._solver.outside, self._unrolled, choice)
                builder.hint(results[name], name)
        fits = self._fits(choices)
        doubts = self._doubts(choices, () if self._lanes else fits)
        unnamed = [*doubts, *(fits if self._lanes else ())]
        program = builder.finish(self._program.name, results, [], unnamed=unnamed)
        end = len(results) + len(doubts)
        return Flat(
            program,
            joints=len(self._solver.joints),
            limited=self._solver.outside is not None,
            doubts=program.outputs[len(results) : end],
            fits=program.outputs[end:],
            choices=choices,
            lanes=self._lanes,
            unrolled=self._unrolled,
        )

    def _leaves(self) -> None:
        """Constants and signs."""
        builder = self._builder
        for c in self._program.constants:
            self._values[c.name, ()] = builder.known(c)
        for place, axis in enumerate(self._program.axes):
            if place in self._lanes:
                self._values[axis.name, ()] = builder.sign(axis.words, axis.step, axis.name)
            else:
                self._axes[axis.name] = (place,)
                self._values[axis.name, (PLUS,)] = builder.integer(1)
                self._values[axis.name, (MINUS,)] = builder.integer(-1)

    def _let(self, statement: Let) -> None:
        """The value under a name for each combination of the unrolled signs it depends on."""
        axes = tuple(axis for axis in statement.axes if axis not in self._lanes)
        self._axes[statement.name] = axes
        for choice in product((PLUS, MINUS), repeat=len(axes)):
            node = self._value(statement.expression, axes, choice)
            if statement.named:
                self._builder.hint(node, _name(statement.name, choice))
            self._values[statement.name, choice] = node

    def _doubts(self, choices: tuple[Choice, ...], fits: Sequence[Node]) -> list[Node]:
        """Any doubt in any branch, by type; doubts that need the joints' values come last."""
        builder, within_slack = self._builder, self._solver.within_slack
        rounded = []
        if fits:
            exact, near = fits
            rounded = [builder.apply("and", near, builder.apply("not", exact))]
        groups = (self._solver.doubts, () if within_slack is None else (within_slack,))
        early, late = (
            [self._value(each, self._unrolled, choice) for each in group for choice in choices]
            for group in groups
        )
        return [*builder.disjunctions([*early, *rounded]), *builder.disjunctions(late)]

    def _fits(self, choices: tuple[Choice, ...]) -> list[Node]:
        """Whether any of the rows is exact, and whether any is near enough to be refined."""
        either = partial(self._builder.apply, "or")
        return [
            reduce(either, (self._value(each, self._unrolled, choice) for choice in choices))
            for each in self._solver.fits
        ]

    def _value(self, expression: Expression, axes: tuple[int, ...], choice: Choice) -> Node:
        """An expression where the unrolled axes have these values."""
        builder = self._builder
        match expression:
            case Variable(name):
                of = dict(zip(axes, choice, strict=True))
                return self._values[name, tuple(of[axis] for axis in self._axes.get(name, ()))]
            case Integer(value):
                return builder.integer(value)
            case Pose(row, column):
                return builder.pose(row, column)
            case Joint(number, role):
                given = builder.seed if role == "seed" else builder.given
                return given(number)
            case Apply(operator, operands):
                parts = [self._value(operand, axes, choice) for operand in operands]
                if operator == "mul" and (sign := self._sign(parts)):
                    return builder.integer(sign)
                node = builder.simplified(operator, parts)
                return self._angle(node) if operator == "atan2" else node

    def _sign(self, factors: list[Node]) -> int:
        """A product of numbers that is 1 or -1, as half of what two signs are apart is; else 0."""
        values = [self._builder.entries[factor].value for factor in factors]
        product = math.prod(value or 0 for value in values)
        return int(product) if abs(product) == 1 else 0

    def _angle(self, node: Node) -> Node:
        """Angles are numbered."""
        number = self._angles.setdefault(node, len(self._angles) + 1)
        return self._builder.name(node, f"angle{number}")


def _name(name: str, choice: Choice) -> str:
    signs = "".join("p" if sign == PLUS else "m" for sign in choice)
    return f"{name}_{signs}" if signs else name

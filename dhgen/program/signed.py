"""Values with their branch signs in front: sigma v, where sigma is a product of signs.

What is odd or even in a sign is computed once for both of its values: f(sigma x) is sigma f(x) or
f(x), atan2(tau y, tau x) is half a turn from atan2(y, x), atan2(tau y, x) is tau atan2(y, x), and
atan2(y, tau x) is pi - atan2(y, x). Such a rewrite makes the type of a value narrower.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.program.builder import Builder
    from dhgen.program.graph import Node
    from dhgen.program.ir import Operator

NO_SIGNS: frozenset[Node] = frozenset()


@dataclass(frozen=True, slots=True)
class Signed:
    """A value: a product of signs times what does not change sign with them.

    Attributes:
        node: The value where every sign is +1.
        signs: The nodes of the signs.
    """

    node: Node
    signs: frozenset[Node] = NO_SIGNS


class SignedArithmetic:
    """The operators on signed values.

    Args:
        builder: Where values go.
    """

    def __init__(self, builder: Builder) -> None:
        self._builder = builder
        self._ranges: dict[Node, tuple[float, float]] = {}

    def apply(self, operator: Operator, operands: list[Signed]) -> Signed:
        """An operator that has a rule of its own here, else on plain values."""
        builder = self._builder
        match operator, operands:
            case "neg", (x,):
                return Signed(builder.neg(x.node), x.signs)
            case "abs", (x,):
                return Signed(builder.absolute(x.node))
            case (("mul" | "div"), (x, y)):
                node = builder.simplified(operator, [x.node, y.node])
                return Signed(node, x.signs ^ y.signs)
            case (("add" | "sub"), (x, y)):
                a, b, common = self.shared(x, y)
                return Signed(builder.simplified(operator, [a, b]), common)
            case "atan2", (y, x):
                return self._angle(y, x)
            case "wrap", (x,):
                return Signed(self._wrapped(self.plain(x)))
            case _:
                plain = [self.plain(operand) for operand in operands]
                return Signed(builder.apply(operator, *plain))

    def plain(self, value: Signed) -> Node:
        """The value itself."""
        return self._builder.mul(self._product(value.signs), value.node)

    def shared(self, x: Signed, y: Signed) -> tuple[Node, Node, frozenset[Node]]:
        """Two values without the signs they have in common, and these."""
        common = x.signs & y.signs
        first = self.plain(Signed(x.node, x.signs - common))
        return first, self.plain(Signed(y.node, y.signs - common)), common

    def _product(self, signs: frozenset[Node]) -> Node:
        product = self._builder.integer(1)
        for sign in sorted(signs):
            product = self._builder.mul(product, sign)
        return product

    def _angle(self, y: Signed, x: Signed) -> Signed:
        """atan2(tau rho_y b, tau rho_x a) = rho_y (rho_x t + h (tau - rho_x) / 2).

        t = atan2(b, a), h is pi with the sign of b. Signs on which a or b depends besides
        are of no use in front.
        """
        builder = self._builder
        y, x = self._reduced(y, y, x), self._reduced(x, y, x)
        tau, rho_y, rho_x = y.signs & x.signs, y.signs - x.signs, x.signs - y.signs
        angle = builder.apply("atan2", y.node, x.node)
        self._ranges[angle] = (-math.pi, math.pi)
        if tau or rho_x:
            turn, mirror = self._product(tau), self._product(rho_x)
            half_turn = builder.apply("copysign", self._pi(), y.node)
            share = builder.div(builder.sub(turn, mirror), builder.integer(2))
            angle = builder.add(builder.mul(mirror, angle), builder.mul(half_turn, share))
            self._ranges[angle] = (-math.pi, math.pi)
        return Signed(angle, rho_y)

    def _reduced(self, value: Signed, *others: Signed) -> Signed:
        """The value with only those signs in front on which no other part depends."""
        axes = {axis for other in others for axis in self._builder.axes_of(other.node)}
        kept = frozenset(s for s in value.signs if not axes.intersection(self._builder.axes_of(s)))
        return Signed(self.plain(Signed(value.node, value.signs - kept)), kept)

    def _wrapped(self, node: Node) -> Node:
        """The angle moved by whole turns to (-pi, pi]: as often as its range asks for."""
        builder = self._builder
        known = self._range(node)
        if known is None:
            return builder.apply("wrap", node)
        low, high = known
        zero, turn = builder.integer(0), builder.mul(builder.integer(2), self._pi())
        for k in range(max(_turns(high), _turns(-low))):
            above = builder.apply("less", self._pi(), node)
            below = builder.apply("at_most", node, builder.neg(self._pi()))
            if k < _turns(high):
                node = builder.sub(node, builder.select(above, turn, zero))
            if k < _turns(-low):
                node = builder.add(node, builder.select(below, turn, zero))
        return node

    def _pi(self) -> Node:
        return self._builder.constant("half_turn", math.pi, "pi [rad]")

    def _range(self, node: Node) -> tuple[float, float] | None:
        """Between which numbers an angle is known to lie."""
        if node not in self._ranges:
            found = self._found_range(node)
            if found is None:
                return None
            self._ranges[node] = found
        return self._ranges[node]

    def _found_range(self, node: Node) -> tuple[float, float] | None:
        entry = self._builder.entries[node]
        if entry.value is not None:
            return float(entry.value), float(entry.value)
        if self._builder.is_sign(node):
            return -1.0, 1.0
        parts = [self._range(operand) for operand in entry.operands]
        match entry.operator, parts:
            case "neg", [(low, high)]:
                return -high, -low
            case "add", [(low, high), (other_low, other_high)]:
                return low + other_low, high + other_high
            case "sub", [(low, high), (other_low, other_high)]:
                return low - other_high, high - other_low
            case "mul", [(low, high), (other_low, other_high)]:
                ends = [a * b for a in (low, high) for b in (other_low, other_high)]
                return min(ends), max(ends)
            case _:
                return None


def _turns(size: float) -> int:
    """How many turns bring an angle of at most this size to pi or less, up to rounding."""
    return max(math.ceil((size - math.pi) / (2 * math.pi) - 1e-9), 0)

"""Values with their branch signs in front: sigma s v, where sigma is a product of signs.

What is odd or even in a sign is computed once for both of its values: f(sigma x) is sigma f(x) or
f(x), atan2(tau y, tau x) is half a turn from atan2(y, x), atan2(tau y, x) is tau atan2(y, x), and
atan2(y, tau x) is pi - atan2(y, x). Such a rewrite makes the type of a value narrower. Positive
factors s, such as the inverse of a length, may be left in front, too: an angle does not need them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.program.regular.directions import turned_pair
from dhgen.program.regular.limits import half_turn, whole_turn
from dhgen.program.regular.rewriting import Rewriting

if TYPE_CHECKING:
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.program.ir import Operator

NO_SIGNS: frozenset[Node] = frozenset()


@dataclass(frozen=True, slots=True)
class Signed:
    """A value: a product of signs and positive factors times what is left.

    Attributes:
        node: The value where every sign is +1, without the factors.
        signs: The nodes of the signs.
        factors: The nodes of the factors.
    """

    node: Node
    signs: frozenset[Node] = NO_SIGNS
    factors: frozenset[Node] = NO_SIGNS


class SignedArithmetic:
    """The operators on signed values.

    Args:
        builder: Where values go.
    """

    def __init__(self, builder: Builder) -> None:
        self._builder = builder
        self._rewriting = Rewriting(builder)
        self._ranges: dict[Node, tuple[float, float]] = {}
        self._turns: list[Node] = []

    def apply(self, operator: Operator, operands: list[Signed]) -> Signed:
        """An operator that has a rule of its own here, else on plain values."""
        builder = self._builder
        match operator, operands:
            case "neg", (x,):
                return Signed(builder.neg(x.node), x.signs, x.factors)
            case "abs", (x,):
                return Signed(builder.absolute(x.node), factors=x.factors)
            case "mul", (x, y):
                both = x.factors & y.factors
                first, second = self._scaled(x.node, both), y.node
                entry = builder.entries[first]
                if first == second and entry.operator == "sqrt":
                    node = entry.operands[0]  # no need to wait for the root
                else:
                    node = builder.mul(first, second)
                return Signed(node, x.signs ^ y.signs, x.factors | y.factors)
            case "div", (x, y):
                node = self._quotient(x.node, self._scaled(y.node, y.factors))
                return Signed(node, x.signs ^ y.signs, x.factors)
            case (("add" | "sub"), (x, y)):
                a, b, common = self.shared(x, y)
                node = builder.simplified(operator, [a, b])
                return Signed(node, common.signs, common.factors)
            case "at_most", (x, limit):
                return self._at_most(self.plain(x), self.plain(limit))
            case "atan2", (y, x):
                return self._angle(y, x)
            case "wrap", (x,):
                return Signed(self._wrapped(self.plain(x)))
            case _:
                plain = [self.plain(operand) for operand in operands]
                length = self._rewriting.length(*plain) if operator == "sqrt" else None
                return Signed(builder.apply(operator, *plain) if length is None else length)

    def sooner(self, value: Signed) -> Signed:
        """The value in a form in which it is known sooner."""
        return replace(value, node=self._rewriting.sooner(value.node))

    def vanishes(self, value: Signed) -> bool:
        """Whether a value is zero by an identity."""
        return self._rewriting.vanishes(value.node)

    def plain(self, value: Signed) -> Node:
        """The value itself."""
        scaled = self._scaled(value.node, value.factors)
        return self._builder.mul(self._product(value.signs), scaled)

    def shared(self, x: Signed, y: Signed) -> tuple[Node, Node, Signed]:
        """Two values without the signs and factors they have in common, and these."""
        signs, factors = x.signs & y.signs, x.factors & y.factors
        first = self.plain(Signed(x.node, x.signs - signs, x.factors - factors))
        second = self.plain(Signed(y.node, y.signs - signs, y.factors - factors))
        return first, second, Signed(self._builder.integer(1), signs, factors)

    def direction(self, y: Signed, x: Signed) -> tuple[Node, Node]:
        """Two values up to a positive factor that both have.

        Instead of dividing one by a length the other is multiplied by it.
        """
        lengths: list[list[Node]] = [[], []]  # that y and x are to be multiplied by
        left: list[Signed] = []
        for place, (one, other) in enumerate(((y, x), (x, y))):
            alone = {each: self._inverse_of(each) for each in one.factors - other.factors}
            lengths[1 - place] += sorted(each for each in alone.values() if each is not None)
            kept = frozenset(each for each, length in alone.items() if length is None)
            left.append(Signed(one.node, one.signs, kept))
        first, second = (
            self._scaled(self.plain(value), frozenset(by))
            for value, by in zip(left, lengths, strict=True)
        )
        return first, second

    def _inverse_of(self, factor: Node) -> Node | None:
        """The length of which a factor is the inverse, as `_quotient` makes it; else None."""
        entries = self._builder.entries
        match entries[factor].operator, entries[factor].operands:
            case "div", (one, length) if entries[one].value == 1:
                return length
            case "mul", (root, inverse) if (
                entries[root].operator == "sqrt"
                and entries[inverse].operator == "div"
                and entries[entries[inverse].operands[0]].value == 1
                and entries[inverse].operands[1:] == entries[root].operands
            ):
                return root
            case _:
                return None

    def _quotient(self, x: Node, y: Node) -> Node:
        """x / y; the inverse of a root need not wait for it: it is the root over its square."""
        builder = self._builder
        entry = builder.entries[y]
        if entry.operator == "sqrt" and builder.entries[x].value is not None:
            return builder.mul(y, builder.div(x, entry.operands[0]))
        return builder.div(x, y)

    def _scaled(self, node: Node, factors: frozenset[Node]) -> Node:
        """A value times factors."""
        for factor in sorted(factors):
            node = self._builder.mul(node, factor)
        return node

    def _at_most(self, x: Node, limit: Node) -> Signed:
        """x <= limit; a length is compared by its square, which needs no root."""
        builder = self._builder
        entry, most = builder.entries[x], builder.entries[limit].value
        if entry.operator == "sqrt" and most is not None and most > 0:
            x, limit = entry.operands[0], builder.square(limit)
        return Signed(builder.apply("at_most", x, limit))

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
        original = self._rewriting.original
        first, second = (replace(value, node=original(value.node)) for value in (y, x))
        turned = self._turned(*self._without_length(first, second))
        y, x = self._without_length(y, x)
        if turned is not None:
            return turned
        y, x = self._reduced(y, y, x), self._reduced(x, y, x)
        tau, rho_y, rho_x = y.signs & x.signs, y.signs - x.signs, x.signs - y.signs
        angle = builder.apply("atan2", y.node, x.node)
        self._ranges[angle] = (-math.pi, math.pi)
        if tau or rho_x:
            turn, mirror = self._product(tau), self._product(rho_x)
            half = builder.apply("copysign", half_turn(builder), y.node)
            share = builder.div(builder.sub(turn, mirror), builder.integer(2))
            angle = builder.add(builder.mul(mirror, angle), builder.mul(half, share))
            self._ranges[angle] = (-math.pi, math.pi)
        return Signed(angle, rho_y)

    def _turned(self, y: Signed, x: Signed) -> Signed | None:
        """atan2(a r - b k, a k + b r) = atan2(r, k) - atan2(b, a) with constants a and b.

        Taken if it is narrower: r holds a sign that may then come in front. The range is beyond pi.
        """
        builder = self._builder
        sine, cosine = self.plain(y), self.plain(x)
        axes = {*builder.axes_of(sine), *builder.axes_of(cosine)}
        found = turned_pair(builder, sine, cosine)
        if found is None:
            return None
        r, k = (self._product_of(nodes) for nodes in (found.sine, found.cosine))
        own = {axis for each in (r, k) for axis in builder.axes_of(each.node)}
        if not own < axes:
            return None
        angle = self.plain(self._angle(r, k))
        turn = builder.angle(f"turn{len(self._turns) + 1}", found.turn, found.formula)
        self._turns.append(turn)
        return Signed(builder.sub(angle, turn))

    def _product_of(self, nodes: tuple[Node, ...]) -> Signed:
        product = Signed(self._builder.integer(1))
        for node in nodes:
            sign = self._builder.is_sign(node)
            one = Signed(self._builder.integer(1), frozenset({node})) if sign else Signed(node)
            product = self.apply("mul", [product, one])
        return product

    def angle(self, value: Signed) -> Node:
        """A joint's value, in (-pi, pi] if it is an angle."""
        node = self.plain(value)
        return node if self._range(node) is None else self._wrapped(node)

    def _without_length(self, y: Signed, x: Signed) -> tuple[Signed, Signed]:
        """The two without the positive factors that both have."""
        unsigned = (Signed(value.node, factors=value.factors) for value in (y, x))
        first, second, _ = self.shared(*unsigned)
        parts = [self._parts(node) for node in (first, second)]
        for factor in sorted(parts[0][1] & parts[1][1]):
            if self._is_positive(factor):
                first, second = self._divided(first, factor), self._divided(second, factor)
        return Signed(first, y.signs), Signed(second, x.signs)

    def _parts(self, node: Node) -> tuple[bool, frozenset[Node]]:
        """Whether a product has a minus in front, and its operands."""
        entry = self._builder.entries[node]
        if entry.operator == "neg":
            minus, operands = self._parts(entry.operands[0])
            return not minus, operands
        return False, frozenset(entry.operands if entry.operator == "mul" else ())

    def _divided(self, node: Node, factor: Node) -> Node:
        """A product without one of its operands."""
        entry = self._builder.entries[node]
        if entry.operator == "neg":
            return self._builder.neg(self._divided(entry.operands[0], factor))
        first, second = entry.operands
        return second if first == factor else first

    def _is_positive(self, node: Node) -> bool:
        """Whether a value that is a number is positive for certain where it is not zero."""
        entry = self._builder.entries[node]
        if entry.value is not None:
            return entry.value > 0
        match entry.operator, entry.operands:
            case "sqrt", _:
                return True
            case (("mul" | "div" | "add"), (left, right)):
                return left == right or (self._is_positive(left) and self._is_positive(right))
            case _:
                return False

    def _reduced(self, value: Signed, *others: Signed) -> Signed:
        """The value with only the signs in front on which no other part depends."""
        axes = {axis for other in others for axis in self._builder.axes_of(other.node)}
        kept = frozenset(s for s in value.signs if not axes.intersection(self._builder.axes_of(s)))
        return Signed(self.plain(Signed(value.node, value.signs - kept)), kept)

    def _wrapped(self, node: Node) -> Node:
        """The angle moved by whole turns to (-pi, pi]: as often as its range needs."""
        builder = self._builder
        known = self._range(node)
        if known is None:
            return builder.apply("wrap", node)
        low, high = known
        zero, turn, half = builder.integer(0), whole_turn(builder), half_turn(builder)
        for k in range(max(_turns(high), _turns(-low))):
            above = builder.apply("less", half, node)
            below = builder.apply("at_most", node, builder.neg(half))
            back = builder.select(above, builder.neg(turn), zero) if k < _turns(high) else zero
            ahead = builder.select(below, turn, back) if k < _turns(-low) else back
            node = builder.add(node, ahead)
        return node

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
        if entry.operator not in {"neg", "add", "sub", "mul"}:
            return None
        parts = []
        for operand in entry.operands:
            part = self._range(operand)
            if part is None:  # most are numbers, not angles: the first one shows
                return None
            parts.append(part)
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

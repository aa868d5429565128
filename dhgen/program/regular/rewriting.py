"""Values written so that what comes after a square root or a division is short.

A chain of sums and products may follow on a root w until a value is known that is P + w Q, where P
and Q are known before w: this form costs one multiplication and addition after w. In the same way
the length of a vector that is a product of two others of equal length needs no root.
"""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from dhgen.program.arrival import LATENCY
from dhgen.program.regular.coefficient import ALIKE, MINUS_ONE, ONE
from dhgen.program.regular.expansion import Expansion, common_factors, without

if TYPE_CHECKING:
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.program.regular.coefficient import Coefficient
    from dhgen.program.regular.expansion import Terms

MOST_TERMS = 10  # of a value that is written anew
GAIN = 8  # cycles by which it has to be known earlier


class Rewriting:
    """Writes values anew.

    Args:
        builder: Where values go.
    """

    def __init__(self, builder: Builder) -> None:
        self._builder = builder
        self._expansion = Expansion(builder)
        self._times: dict[Node, int] = {}
        self._numbers: list[tuple[Coefficient, Node]] = []

    def sooner(self, node: Node) -> Node:
        """An equal value in a form that is computed sooner, if there is one."""
        polynomial = self._expansion.polynomial(node)
        if polynomial is None or not polynomial.exact:
            return node
        if not 1 < len(polynomial.terms) <= MOST_TERMS:
            return node
        found = self._split(polynomial.terms)
        if found is None or self._time(found) + GAIN > self._time(node):
            return node
        self._expansion.remember(found, node)
        return found

    def original(self, node: Node) -> Node:
        """A value as it was before it was written anew."""
        return self._expansion.original(node)

    def vanishes(self, node: Node) -> bool:
        """Whether a value is zero by an identity."""
        polynomial = self._expansion.polynomial(node)
        return polynomial is not None and not polynomial.terms

    def length(self, square: Node) -> Node | None:
        """The root of a sum of two squares that is itself the square of a sum of squares."""
        entries = self._builder.entries
        entry = entries[square]
        parts = [entries[operand] for operand in entry.operands]
        if entry.operator != "add" or any(
            part.operator != "mul" or part.operands[0] != part.operands[1] for part in parts
        ):
            return None
        polynomial = self._expansion.polynomial(square)
        if polynomial is None:
            return None
        common = common_factors(polynomial.terms)
        rest = {without(m, common): value for m, value in polynomial.terms.items()}
        squares = all(v.value == 1 and self._expansion.is_positive(m) for m, v in rest.items())
        if len(common) != 1 or not squares or self._sum(rest) != common[0]:
            return None
        return common[0]

    def _split(self, terms: Terms) -> Node | None:
        """P + w Q, where w is what is known last; None if it is not linear in w."""
        builder = self._builder
        factors = {node for monomial in terms for node in monomial}
        last = max(factors, key=lambda node: (self._time(node), node))
        early: Terms = {}
        late: Terms = {}
        for monomial, value in terms.items():
            if monomial.count(last) > 1:
                return None
            part = late if last in monomial else early
            part[without(monomial, (last,))] = value
        product = builder.mul(last, self._sum(late))
        return builder.add(self._sum(early), product) if early else product

    def _sum(self, terms: Terms) -> Node:
        """A polynomial, with common factors in front."""
        builder = self._builder
        common = common_factors(terms)
        rest = {without(m, common): value for m, value in terms.items()}
        content = ONE
        if len({abs(each.value) for each in terms.values()}) == 1:
            content = abs(next(iter(terms.values())))
            rest = {m: ONE if each.value > 0 else MINUS_ONE for m, each in rest.items()}
        inner = self._nested(rest)
        for factor in sorted(common, key=self._time):
            inner = builder.mul(factor, inner)
        return inner if content.value == 1 else builder.mul(self._number(content), inner)

    def _nested(self, terms: Terms) -> Node:
        """A polynomial without common factors, after Horner: what occurs most often in front."""
        if len(terms) == 1:
            ((monomial, value),) = terms.items()
            return self._term(monomial, value)
        counts = Counter(node for monomial in terms for node in set(monomial))
        often, times = max(counts.items(), key=lambda item: (item[1], -item[0]))
        if times < 2:
            parts = [self._term(m, value) for m, value in sorted(terms.items())]
        else:
            inside = {m: value for m, value in terms.items() if often in m}
            outside = {m: value for m, value in terms.items() if often not in m}
            parts = [self._sum(part) for part in (inside, outside) if part]
        total = parts[0]
        for part in parts[1:]:
            total = self._builder.add(total, part)
        return total

    def _term(self, monomial: tuple[Node, ...], factor: Coefficient) -> Node:
        builder, size = self._builder, abs(factor)
        product = builder.integer(1) if size.value == 1 else self._number(size)
        for each in sorted(monomial, key=self._time):
            product = builder.mul(product, each)
        return product if factor.value > 0 else builder.neg(product)

    def _number(self, number: Coefficient) -> Node:
        """A coefficient: one that is there already, if it is the same up to rounding."""
        for known, node in self._numbers:
            if abs(known.value - number.value) <= ALIKE * abs(known.value):
                return node
        builder = self._builder
        node = builder.number(number.value, number.formula(builder.formula))
        self._numbers.append((number, node))
        return node

    def _time(self, node: Node) -> int:
        """When a value is known, in cycles; a product that is added to something costs nothing."""
        if node not in self._times:
            entries = self._builder.entries
            entry = entries[node]
            operands: list[Node] = []
            for each in entry.operands:
                fused = entry.operator in {"add", "sub"} and entries[each].operator == "mul"
                operands += entries[each].operands if fused else (each,)
            start = max((self._time(each) for each in operands), default=0)
            constant = all(entries[each].value is not None for each in operands)
            self._times[node] = start + LATENCY.get(entry.operator or "", 0 if constant else 1)
        return self._times[node]

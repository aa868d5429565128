"""Values as polynomials in what is known before a square root, and in the root itself.

Squares of the root are replaced by what is under it, products of x and 1/x by one, squares of signs
too; what then cancels by an identity, such as that of a sine and its cosine, cancels here up to
the rounding of constants.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.regular.coefficient import MINUS_ONE, ONE, Coefficient, coefficient, total

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node

Monomial = tuple["Node", ...]  # factors in ascending order
Terms = dict[Monomial, Coefficient]
# Of a value its terms, whether squares of the root have been replaced, and whether terms cancelled.
Known = tuple[Terms | None, bool, bool]

MOST_TERMS = 80  # of a polynomial on the way
_POLYNOMIAL = frozenset({"add", "sub", "mul", "neg"})


@dataclass(frozen=True, slots=True)
class Polynomial:
    """A value.

    Attributes:
        terms: Coefficients by monomials.
        exact: Whether no square of the root has been replaced, or else something cancelled.
    """

    terms: Terms
    exact: bool


class Expansion:
    """Expands values.

    Args:
        builder: Where they are.
    """

    def __init__(self, builder: Builder) -> None:
        self._builder = builder
        self._made_of: dict[Node, frozenset[Node]] = {}
        self._bases: dict[Node, Node | None] = {}
        self._originals: dict[Node, Node] = {}
        self._radicands: set[Node] = set()
        self._known: dict[Node, dict[Node, Known]] = {}  # by roots
        # Of the value that is being expanded, with what it is made of:
        self._squared = False  # whether squares of the root have been replaced
        self._cancelled = False  # whether terms have cancelled

    def remember(self, node: Node, original: Node) -> None:
        """A value has been written in another way."""
        builder = self._builder
        self._keep(node, original)
        if builder.entries[node].operator == "neg":  # its sign may go elsewhere
            self._keep(builder.neg(node), builder.neg(original))

    def original(self, node: Node) -> Node:
        """A value as it was before it was written in another way."""
        return self._originals.get(node, node)

    def _keep(self, node: Node, original: Node) -> None:
        """Unless the original is itself made of the value, as 2 (x / 2) is of x."""
        seen: set[Node] = set()
        ahead = [original]
        while ahead:
            each = self.original(ahead.pop())
            if each not in seen:
                seen.add(each)
                ahead += self._builder.entries[each].operands
        if node not in seen:
            self._originals.setdefault(node, original)

    def polynomial(self, node: Node) -> Polynomial | None:
        """A value as a polynomial in the last root that it is made of by sums and products.

        Whatever does not depend in this way on the root, or on what the root is taken of, is an
        indeterminate.

        Returns:
            None if there is no such root, or if there are too many terms.
        """
        entries = self._builder.entries
        roots = [each for each in self._reached(node) if entries[each].operator == "sqrt"]
        if not roots:
            return None
        terms, squared, cancelled = self._expanded(node, max(roots))
        return None if terms is None else Polynomial(terms, cancelled or not squared)

    def is_positive(self, monomial: Monomial) -> bool:
        """Whether this is a square, or what a square root has been taken of."""
        return monomial[::2] == monomial[1::2] or set(monomial) <= self._radicands

    def _expanded(self, node: Node, root: Node) -> Known:
        entries = self._builder.entries
        ends = {root, self._base(entries[root].operands[0])}
        known = self._known.setdefault(root, {})

        def of(each: Node) -> Terms | None:
            if each not in known:
                before = self._squared, self._cancelled
                self._squared = self._cancelled = False
                terms = found(self.original(each))
                known[each] = terms, self._squared, self._cancelled
                self._squared, self._cancelled = before
            terms, squared, cancelled = known[each]
            self._squared |= squared
            self._cancelled |= cancelled
            return terms

        def found(each: Node) -> Terms | None:
            entry = entries[each]
            if entry.value is not None:
                return {(): coefficient(self._builder, each)} if entry.value else {}
            if each in ends or ends.isdisjoint(self._reached(each)):
                negated = entry.operator == "neg"
                return {(entry.operands[0],): MINUS_ONE} if negated else {(each,): ONE}
            match entry.operator, [of(operand) for operand in entry.operands]:
                case "neg", [dict(x)]:
                    return {monomial: -value for monomial, value in x.items()}
                case "add", [dict(x), dict(y)]:
                    return self._collected([*x.items(), *y.items()])
                case "sub", [dict(x), dict(y)]:
                    return self._collected([*x.items(), *((m, -value) for m, value in y.items())])
                case "mul", [dict(x), dict(y)]:
                    return self._product(x, y, root, of)
            return None

        of(node)
        return known[node]

    def _product(
        self, x: Terms, y: Terms, root: Node, of: Callable[[Node], Terms | None]
    ) -> Terms | None:
        if len(x) * len(y) > MOST_TERMS:
            return None
        terms: list[tuple[Monomial, Coefficient]] = []
        for one, a in x.items():
            for other, b in y.items():
                monomial = self._reduced((*one, *other), root)
                count = monomial.count(root)
                if count < 2:
                    terms.append((monomial, a * b))
                    continue
                self._squared = True
                under = of(self._builder.entries[root].operands[0])
                if under is None or count > 3:
                    return None
                rest = without(monomial, (root, root))
                terms += [(self._reduced((*rest, *m), root), a * b * c) for m, c in under.items()]
        return self._collected(terms)

    def _collected(self, terms: list[tuple[Monomial, Coefficient]]) -> Terms | None:
        """Terms added up; what is rounding of constants alone is gone."""
        alike: dict[Monomial, list[Coefficient]] = {}
        for monomial, value in terms:
            alike.setdefault(monomial, []).append(value)
        totals = {monomial: total(values) for monomial, values in alike.items()}
        kept = {monomial: each for monomial, each in totals.items() if each.value}
        self._cancelled |= len(kept) < len(totals)
        return kept if len(kept) <= MOST_TERMS else None

    def _reduced(self, monomial: Monomial, root: Node) -> Monomial:
        """Without squares of signs and other roots, and products of something and its inverse."""
        builder = self._builder
        counts = Counter(monomial)
        for node in list(counts):
            entry = builder.entries[node]
            if builder.is_sign(node):
                counts[node] %= 2
            elif entry.operator == "sqrt" and node != root and counts[node] > 1:
                counts[node] -= 2
                counts[entry.operands[0]] += 1
                self._radicands.add(entry.operands[0])
            elif entry.operator == "div" and builder.entries[entry.operands[0]].value == 1:
                both = min(counts[node], counts[entry.operands[1]])
                counts[node] -= both
                counts[entry.operands[1]] -= both
        return tuple(sorted(counts.elements()))

    def _reached(self, node: Node) -> frozenset[Node]:
        """What a value is made of by sums and products alone, and itself."""
        if node not in self._made_of:
            entry = self._builder.entries[node]
            found = frozenset({node})
            if entry.operator in _POLYNOMIAL:
                found = found.union(*(self._reached(each) for each in entry.operands))
            self._made_of[node] = found
        return self._made_of[node]

    def _base(self, node: Node) -> Node | None:
        """The one value of which this is a polynomial with constant coefficients."""
        if node not in self._bases:
            entry = self._builder.entries[node]
            base = node if entry.value is None else None
            if entry.operator in _POLYNOMIAL:
                bases = {self._base(operand) for operand in entry.operands} - {None}
                base = bases.pop() if len(bases) == 1 else node
            self._bases[node] = base
        return self._bases[node]


def common_factors(terms: Terms) -> Monomial:
    """The factors that all terms have."""
    shared: Counter[Node] | None = None
    for monomial in terms:
        shared = Counter(monomial) if shared is None else shared & Counter(monomial)
    return tuple(sorted((shared or Counter()).elements()))


def without(monomial: Monomial, factors: Monomial) -> Monomial:
    """A product without some of its factors."""
    return tuple(sorted((Counter(monomial) - Counter(factors)).elements()))

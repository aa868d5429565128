"""Values written anew are the same values, known sooner; where that costs exactness they stay."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from dhgen.program.building.builder import Builder
from dhgen.program.interpret import outputs
from dhgen.program.regular.expansion import Expansion
from dhgen.program.regular.rewriting import Rewriting

if TYPE_CHECKING:
    from dhgen.program.building.graph import Node

RNG = np.random.default_rng(3)


class TwoLinks:
    """The elbow of an arm of links 0.4 and 0.3 that reaches for x, y: entries 1, 4 and 2, 4."""

    def __init__(self) -> None:
        self.builder = b = Builder()
        self.x, self.y = b.pose(1, 4), b.pose(2, 4)
        first, second = b.constant("L1", 0.4, "a link"), b.constant("L2", 0.3, "a link")
        self.sign = b.sign(("down", "up"), 1)
        self.reach = b.add(b.square(self.x), b.square(self.y))
        longest, shortest = b.constant("far", 0.49, "m^2"), b.constant("near", 0.01, "m^2")
        under = b.mul(b.sub(longest, self.reach), b.sub(self.reach, shortest))
        self.root = b.apply("sqrt", under)
        twice = b.mul(b.integer(2), b.mul(first, second))
        squares = b.add(b.square(first), b.square(second))
        self.cosine = b.div(b.sub(self.reach, squares), twice)
        self.sine = b.div(b.mul(self.sign, self.root), twice)
        along = b.add(first, b.mul(second, self.cosine))
        across = b.mul(second, self.sine)
        self.s = b.sub(b.mul(self.y, along), b.mul(self.x, across))
        self.c = b.add(b.mul(self.x, along), b.mul(self.y, across))

    def values(self, *nodes: Node) -> list[np.ndarray]:
        """Values at random points in reach."""
        T = np.broadcast_to(np.eye(4), (50, 4, 4)).copy()
        angle, distance = RNG.uniform(-math.pi, math.pi, 50), RNG.uniform(0.11, 0.69, 50)
        T[:, 0, 3], T[:, 1, 3] = distance * np.cos(angle), distance * np.sin(angle)
        results = {f"r{place}": node for place, node in enumerate(nodes)}
        return outputs(self.builder.finish("t", results, []), T)


def test_what_is_linear_in_a_root_waits_for_it_last() -> None:
    arm = TwoLinks()
    found = Rewriting(arm.builder).sooner(arm.s)
    entry = arm.builder.entries[found]
    assert entry.operator in {"add", "sub"}
    products = [arm.builder.entries[each] for each in entry.operands]
    assert any(arm.root in product.operands for product in products)
    before, after = arm.values(arm.s, found)
    assert np.abs(before - after).max() < 1e-15


def test_the_length_of_a_product_of_vectors_needs_no_root() -> None:
    arm = TwoLinks()
    b = arm.builder
    square = b.add(b.square(arm.s), b.square(arm.c))
    assert Rewriting(b).length(square) == arm.reach
    before, after = arm.values(b.apply("sqrt", square), arm.reach)
    assert np.abs(before - after).max() < 1e-15


def test_the_length_of_any_other_vector_does() -> None:
    arm = TwoLinks()
    b = arm.builder
    assert Rewriting(b).length(b.add(b.square(arm.s), b.square(arm.x))) is None
    assert Rewriting(b).length(arm.reach) is None


def test_squares_of_a_root_are_not_multiplied_out() -> None:
    arm = TwoLinks()
    b = arm.builder
    far = b.square(b.add(b.pose(3, 4), b.mul(arm.sign, arm.root)))
    assert Rewriting(b).sooner(far) == far


def test_what_is_zero_by_an_identity_is_found() -> None:
    """The arm reaches for where it has been sent: x - (L1 c1 + L2 c12) with c1 = c / reach."""
    arm = TwoLinks()
    b = arm.builder
    inverse = b.div(b.integer(1), arm.reach)
    c1, s1 = b.mul(arm.c, inverse), b.mul(arm.s, inverse)
    first, second = b.constant("L1", 0.4, "a link"), b.constant("L2", 0.3, "a link")
    c12 = b.sub(b.mul(arm.cosine, c1), b.mul(arm.sine, s1))
    miss = b.sub(arm.x, b.add(b.mul(first, c1), b.mul(second, c12)))
    assert Rewriting(b).vanishes(miss)
    assert not Rewriting(b).vanishes(b.sub(arm.y, b.add(b.mul(first, c1), b.mul(second, c12))))


def test_what_stands_for_a_multiple_of_itself_can_still_be_expanded() -> None:
    """A value that was written anew as half of its double, and one with a sign in front."""
    arm = TwoLinks()
    b = arm.builder
    double = b.mul(b.constant("two", 2.0, "a factor"), arm.s)
    for value, original in ((arm.s, double), (b.neg(arm.c), b.mul(arm.sign, b.neg(arm.c)))):
        expansion = Expansion(b)
        expansion.remember(value, original)
        polynomial = expansion.polynomial(b.mul(arm.root, value))
        assert polynomial is not None
        assert polynomial.terms

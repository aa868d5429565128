from __future__ import annotations

import numpy as np
from sympy.polys.domains import QQ
from sympy.polys.rings import PolyRing

from dhgen.paul.samples import Samples, Sums, terms_on

RING = PolyRing(["x", "y", "z"], QQ)
X, Y, Z = RING.gens


def test_values_and_sizes_are_those_of_the_terms() -> None:
    values = np.array([[2.0, -1.0], [3.0, 0.5], [np.nan, np.nan]])
    samples = Samples(values)
    for polynomial in (X**2 * Y - X / 4, X**2 * Y + Y - 7, RING.zero, RING.one):
        value, size = samples.value_and_size(polynomial)
        terms = terms_on(polynomial, values)
        np.testing.assert_array_equal(value, terms.sum(axis=0))
        np.testing.assert_array_equal(size, np.abs(terms).sum(axis=0))
    np.testing.assert_array_equal(samples.value(X**2 * Y - X / 4), [11.5, 0.75])


def test_equal_polynomials_are_worth_the_same_whichever_is_asked_for() -> None:
    samples = Samples(np.array([[2.0], [3.0], [5.0]]))
    one, other = X * Y - Z, X * Y - Z
    assert one is not other
    assert samples.value(one) == samples.value(other) == [1.0]
    assert samples.numbers(one) == samples.numbers(other) == ((1.0,), (11.0,))


def test_together_polynomials_are_worth_the_same_as_alone() -> None:
    values = np.array([[2.0, -1.0, 0.1], [3.0, 0.5, 0.7], [1.1, 1.2, 1.3]])
    together = Samples(values)
    polynomials = (X**2 * Y - X / 4, RING.zero, X * Y * Z + Y - 7, RING.one, X**2 * Y - X / 4)
    together.learn(polynomials)
    for polynomial in polynomials:
        alone = Samples(values).value_and_size(polynomial)
        np.testing.assert_array_equal(together.value_and_size(polynomial), alone)
        np.testing.assert_array_equal(together.numbers(polynomial), alone)


def test_sums_are_made_ready_once_and_worked_out_at_any_values() -> None:
    polynomials = (X**2 * Y - X / 4, RING.zero, RING.one * 3, X * Y * Z + Y - 7)
    sums = Sums(polynomials)
    for values in (
        np.array([[2.0, -1.0], [3.0, 0.5], [1.1, 1.2]]),
        np.array([[0.5], [4.0], [3.0]]),
    ):
        found = [Samples(values).value(polynomial) for polynomial in polynomials]
        np.testing.assert_array_equal(sums(values), found)
    np.testing.assert_array_equal(Sums([])(values), np.empty((0, 1)))

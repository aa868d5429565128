"""Roots of polynomials on the circle, against numpy's of the same polynomial in exp(ix)."""

from __future__ import annotations

import numpy as np
import pytest

from tests.runtime.arms import called
from tests.runtime.plain import KINDS

pytestmark = pytest.mark.parametrize("kind", KINDS)


def by_numpy(a0: float, a1: float, b1: float, a2: float, b2: float) -> np.ndarray:
    """Those on the unit circle, of the polynomial times exp(2ix)."""
    z = np.roots([a2 - 1j * b2, a1 - 1j * b1, 2.0 * a0, a1 + 1j * b1, a2 + 1j * b2])
    return np.sort(np.angle(z[np.abs(np.abs(z) - 1.0) < 1e-9]))


def test_random_polynomials(kind: str) -> None:
    roots, seen = called(kind, "circle_roots", "circle_roots"), set()
    draw = np.random.default_rng(2)
    for _ in range(200):
        coefficients = draw.uniform(-1.0, 1.0, 5)
        x, close = roots(*coefficients, 0.0, 0.0)
        expected = by_numpy(*coefficients)
        seen.add(len(expected))
        np.testing.assert_allclose(x[: len(expected)], expected, atol=1e-9)
        assert np.isnan(x[len(expected) :]).all()
        assert not close.any()
    assert seen == {0, 2, 4}


def test_double_roots_are_close(kind: str) -> None:
    """1 + cos x has one at pi, cos x - 1 one at 0, both doubled."""
    x, close = called(kind, "circle_roots", "circle_roots")(-1.0, 1.0, 0.0, 0.0, 0.0, 1e-15, 0.0)
    found = x[~np.isnan(x)]
    assert len(found) in {1, 2}
    np.testing.assert_allclose(found, 0.0, atol=1e-6)
    assert close[: len(found)].all()


def test_all_roots_are_moved(kind: str) -> None:
    roots = called(kind, "circle_roots", "circle_roots")
    x, _ = roots(0.2, 1.0, 0.3, 0.1, 0.0, 0.0, 0.0)
    moved, _ = roots(0.2, 1.0, 0.3, 0.1, 0.0, 0.0, 0.25)
    np.testing.assert_array_equal(moved, x + 0.25)


def test_nothing_has_no_roots(kind: str) -> None:
    roots = called(kind, "circle_roots", "circle_roots")
    for a0 in (0.0, np.nan, np.inf):
        assert np.isnan(roots(a0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)[0]).all()

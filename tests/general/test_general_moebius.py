"""Roots that crowd on one side of the circle, with and without the lens that spreads them."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.runtime.plain import plain
from dhgen.runtime.python.general.tables import SAMPLE_C, SAMPLE_S
from tests.general.circles import noise, roots

CROWD = 2.0 + np.linspace(-0.15, 0.15, 16)


def through(x: float, y: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Cosines and sines that the sample angles have through a lens, and what f is multiplied by."""
    c, s, weight = plain("general.moebius").through(x, y, SAMPLE_C, SAMPLE_S)
    return c, s, weight


def spreading(samples: np.ndarray) -> tuple[float, float]:
    """The lens under which roots are spread."""
    x, y = plain("general.moebius").spread(samples)
    return x, y


def product(angles: np.ndarray, cosine: np.ndarray, sine: np.ndarray) -> np.ndarray:
    """A product of sines of half differences, of degree 8 for sixteen angles."""
    x = np.arctan2(sine, cosine)
    value: np.ndarray = np.prod([np.sin((x - a) / 2) for a in angles], axis=0)
    return value


def test_a_crowd_is_found_through_the_lens_alone() -> None:
    plainly = product(CROWD, SAMPLE_C, SAMPLE_S)
    assert len(roots(plainly).simple) < 16
    x, y = spreading(plainly)
    cosine, sine, weight = through(x, y)
    found = roots(product(CROWD, cosine, sine) * weight, x, y)
    assert found.complete
    assert not found.double
    angles = sorted(np.remainder(found.simple, 2 * np.pi))
    np.testing.assert_allclose(angles, CROWD, atol=1e-6)


def test_the_map_turns_the_polynomial_into_another() -> None:
    angles = np.random.default_rng(0).uniform(0, 2 * np.pi, 16)
    cosine, sine, weight = through(-0.4, 0.6)
    np.testing.assert_allclose(cosine**2 + sine**2, 1.0)
    assert noise(product(angles, cosine, sine) * weight) < 1e-14


def test_spread_roots_need_none() -> None:
    even = 0.1 + 2 * np.pi / 16 * np.arange(16)
    assert spreading(product(even, SAMPLE_C, SAMPLE_S)) == (0.0, 0.0)


@pytest.mark.parametrize("depth", [0.5, 0.9, 1.3])
def test_the_mean_of_the_roots(depth: float) -> None:
    """Roots off the circle, on both sides of it, count as those inside."""
    where = 2.5
    x = np.arctan2(SAMPLE_S, SAMPLE_C)
    # two roots of sixteen, the others nowhere; e^-depth is their distance from the middle
    assert np.hypot(*spreading(np.cosh(depth) - np.cos(x - where))) == 0.0
    lens = spreading((np.cosh(depth) - np.cos(x - where)) ** 8)
    strength = np.exp(-depth)
    assert np.hypot(*lens) == pytest.approx(strength if strength > 0.35 else 0.0, abs=1e-3)

"""Roots that crowd on one side of the circle, with and without the lens that spreads them."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.general.circle import roots, trigonometric
from dhgen.general.lens import Lens, sampled, spreading
from dhgen.runtime.python.general.tables import sample_cosines

CROWD = 2.0 + np.linspace(-0.15, 0.15, 16)


def product(angles: np.ndarray, cosine: np.ndarray, sine: np.ndarray) -> np.ndarray:
    """A product of sines of half differences, of degree 8 for sixteen angles."""
    x = np.arctan2(sine, cosine)
    value: np.ndarray = np.prod([np.sin((x - a) / 2) for a in angles], axis=0)
    return value


def test_a_crowd_is_found_through_the_lens_alone() -> None:
    plain = product(CROWD, *np.array(sample_cosines()))
    assert len(roots(trigonometric(plain)).simple) < 16
    samples, lens = sampled(lambda c, s: product(CROWD, c, s))
    found = roots(trigonometric(samples))
    assert found.complete
    assert not found.double
    angles = sorted(np.remainder([lens.angle(x) for x in found.simple], 2 * np.pi))
    np.testing.assert_allclose(angles, CROWD, atol=1e-6)


def test_the_map_turns_the_polynomial_into_another() -> None:
    lens = Lens(-0.4, 0.6)
    angles = np.random.default_rng(0).uniform(0, 2 * np.pi, 16)
    cosine, sine, square = lens.through(*np.array(sample_cosines()))
    np.testing.assert_allclose(cosine**2 + sine**2, 1.0)
    samples = product(angles, cosine, sine) * square**8
    assert trigonometric(samples).noise < 1e-14


def test_spread_roots_need_none() -> None:
    even = 0.1 + 2 * np.pi / 16 * np.arange(16)
    assert spreading(product(even, *np.array(sample_cosines())).tolist()) == Lens()


@pytest.mark.parametrize("depth", [0.5, 0.9, 1.3])
def test_the_mean_of_the_roots(depth: float) -> None:
    """Roots off the circle, on both sides of it, count as those inside."""
    where = 2.5
    sines = np.array(sample_cosines())
    x = np.arctan2(sines[1], sines[0])
    lens = spreading((np.cosh(depth) - np.cos(x - where)).tolist())
    # two roots of sixteen, the others nowhere; e^-depth is their distance from the middle
    assert np.hypot(lens.x, lens.y) == 0.0
    lens = spreading(((np.cosh(depth) - np.cos(x - where)) ** 8).tolist())
    strength = np.exp(-depth)
    assert np.hypot(lens.x, lens.y) == pytest.approx(strength if strength > 0.35 else 0.0, abs=1e-3)

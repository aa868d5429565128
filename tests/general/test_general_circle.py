"""Roots on the circle: simple ones, pairs in one cell, double ones, and none."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.runtime.python.general.tables import SAMPLE_C, SAMPLE_S
from tests.general.circles import noise, roots


def polynomial(angles: list[float], offset: float = 0.0) -> np.ndarray:
    """Samples of a product of sines of half differences: degree 8 for sixteen angles."""
    x = np.arctan2(SAMPLE_S, SAMPLE_C)
    samples: np.ndarray = np.prod([np.sin((x - a) / 2) for a in angles], axis=0) + offset
    return samples


def test_sixteen_roots() -> None:
    angles = np.sort(np.random.default_rng(0).uniform(0, 2 * np.pi, 16))
    found = roots(polynomial(list(angles)))
    assert found.complete
    np.testing.assert_allclose(np.sort(np.mod(found.simple, 2 * np.pi)), angles, atol=1e-7)


@pytest.mark.parametrize("apart", [1e-2, 1e-3, 1e-4, 1e-5])
def test_a_pair_within_a_cell(apart: float) -> None:
    angles = [1.0, 1.0 + apart, 2.5, 4.0]
    complex_pairs = np.random.default_rng(1).uniform(0, 6, 6)
    x = np.arctan2(SAMPLE_S, SAMPLE_C)
    samples = polynomial(angles) * np.prod([1.3 - np.cos(x - a) for a in complex_pairs], axis=0)
    found = roots(samples)
    assert found.complete
    assert len(found.simple) == 4
    np.testing.assert_allclose(
        np.sort(np.mod(found.simple, 2 * np.pi)), angles, atol=1e-7 / apart**0.5
    )


def test_a_double_root() -> None:
    found = roots(polynomial([1.0, 1.0, 3.0, 5.0]))
    np.testing.assert_allclose(found.double, [1.0], atol=1e-6)
    np.testing.assert_allclose(np.sort(np.mod(found.simple, 2 * np.pi)), [3.0, 5.0], atol=1e-12)


def test_no_root() -> None:
    found = roots(2.0 + polynomial([0.3, 1.1]))
    assert found.complete
    assert found.simple == found.double == ()


def test_noise_is_measured() -> None:
    samples = polynomial([0.3, 1.1, 2.0, 4.0])
    assert noise(samples) < 1e-14
    samples[5] += 1e-3
    assert noise(samples) > 1e-5

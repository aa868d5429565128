"""Roots on the circle: simple ones, pairs in one cell, double ones, and none."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.general.circle import CUBIC, roots, trigonometric
from dhgen.runtime.python.general.tables import CELLS, WIDTH, sample_cosines


def polynomial(angles: list[float], offset: float = 0.0) -> np.ndarray:
    """Samples of a product of sines of half differences: degree 8 for sixteen angles."""
    cosines, sines = sample_cosines()
    x = np.arctan2(sines, cosines)
    samples: np.ndarray = np.prod([np.sin((x - a) / 2) for a in angles], axis=0) + offset
    return samples


def test_sixteen_roots() -> None:
    angles = np.sort(np.random.default_rng(0).uniform(0, 2 * np.pi, 16))
    found = roots(trigonometric(polynomial(list(angles))))
    assert found.complete
    np.testing.assert_allclose(sorted(found.simple), angles, atol=1e-7)


@pytest.mark.parametrize("apart", [1e-2, 1e-3, 1e-4, 1e-5])
def test_a_pair_within_a_cell(apart: float) -> None:
    angles = [1.0, 1.0 + apart, 2.5, 4.0]
    complex_pairs = np.random.default_rng(1).uniform(0, 6, 6)
    cosines, sines = sample_cosines()
    x = np.arctan2(sines, cosines)
    samples = polynomial(angles) * np.prod([1.3 - np.cos(x - a) for a in complex_pairs], axis=0)
    found = roots(trigonometric(samples))
    assert found.complete
    assert len(found.simple) == 4
    np.testing.assert_allclose(sorted(found.simple), angles, atol=1e-7 / apart**0.5)


def test_a_double_root() -> None:
    found = roots(trigonometric(polynomial([1.0, 1.0, 3.0, 5.0])))
    np.testing.assert_allclose(found.double, [1.0], atol=1e-6)
    np.testing.assert_allclose(sorted(found.simple), [3.0, 5.0], atol=1e-12)


def test_no_root() -> None:
    found = roots(trigonometric(2.0 + polynomial([0.3, 1.1])))
    assert found.complete
    assert found.simple == found.double == ()


def test_noise_is_measured() -> None:
    samples = polynomial([0.3, 1.1, 2.0, 4.0])
    assert trigonometric(samples).noise < 1e-14
    samples[5] += 1e-3
    assert trigonometric(samples).noise > 1e-5


def test_the_cubic_leaves_out_no_cell_that_the_quintic_does_not() -> None:
    generator = np.random.default_rng(5)
    edges = np.arange(CELLS + 1) * WIDTH
    for pair in (0.0, 1e-6, 1e-5, 1e-4, 1e-3):
        for _ in range(20):
            angles = [*generator.uniform(0.0, 2 * np.pi, 14), 1.0, 1.0 + pair]
            f = trigonometric(polynomial(angles, offset=generator.choice([0.0, 1e-9])))
            at = np.array([f.at(np.cos(x), np.sin(x)) for x in edges]).T
            low, high = at[:, :-1], at[:, 1:]
            (f0, d0, s0), (f1, d1, s1) = low, high
            third, fifth, twentieth = WIDTH / 3, WIDTH / 5, WIDTH**2 / 20
            cubic = [f0, f0 + third * d0, f1 - third * d1, f1]
            quintic = [f0, f0 + fifth * d0, f0 + 2 * fifth * d0 + twentieth * s0]
            quintic += [f1 - 2 * fifth * d1 + twentieth * s1, f1 - fifth * d1, f1]
            may = is_open(quintic, f.touching)
            assert may.any()
            assert not (may & ~is_open(cubic, f.rounding + f.scale * CUBIC)).any()


def is_open(coefficients: list[np.ndarray], doubt: float) -> np.ndarray:
    """Whether cells have Bernstein coefficients that are not all of one sign beyond doubt."""
    result: np.ndarray = (np.min(coefficients, axis=0) <= doubt) & (
        np.max(coefficients, axis=0) >= -doubt
    )
    return result

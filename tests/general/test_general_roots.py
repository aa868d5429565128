"""Roots that may be double, looked at more closely: near the circle, in a crowd, and true ones."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.runtime.python.general.tables import SAMPLE_C, SAMPLE_S, WIDTH
from tests.general.circles import Roots, real_roots, roots

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

CROWDS = ([(1.0, 2e-3)] * 3, [(1.0, 1e-3), (1.002, 2e-3), (1.01, 1e-3)])
ELSEWHERE = (3.0, 3.5, 4.6, 5.1)


def product(
    *factors: tuple[float, float], real: Sequence[float] = ELSEWHERE
) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
    """cosh(depth) - cos(φ - angle) for every complex pair, to full precision, times real roots."""

    def at(cosine: np.ndarray, sine: np.ndarray) -> np.ndarray:
        x = np.arctan2(sine, cosine)
        pairs = [
            2 * (np.sin((x - angle) / 2) ** 2 + np.sinh(depth / 2) ** 2) for angle, depth in factors
        ]
        value: np.ndarray = np.prod([np.sin((x - a) / 2) for a in real], axis=0)
        return np.asarray(value * np.prod(pairs, axis=0))

    return at


def plain(at: Callable[[np.ndarray, np.ndarray], np.ndarray]) -> Roots:
    """What the fit alone shows."""
    return roots(at(SAMPLE_C, SAMPLE_S))


@pytest.mark.parametrize("crowd", CROWDS)
def test_what_only_comes_near_to_zero_is_no_root(crowd: Sequence[tuple[float, float]]) -> None:
    at = product(*crowd)
    first = plain(at)
    assert first.double or not first.complete or len(first.simple) != len(ELSEWHERE)
    found = real_roots(at)
    assert found is not None
    assert found.complete
    assert not found.double
    np.testing.assert_allclose(np.sort(np.mod(found.simple, 2 * np.pi)), ELSEWHERE, atol=1e-9)


@pytest.mark.parametrize("part", range(12))
@pytest.mark.parametrize("off", [0.0285, 0.0295, 0.0305])
def test_a_stretch_that_is_flat_is_looked_at_to_both_its_ends(part: int, off: float) -> None:
    """Four real roots and two complex pairs, wherever in its cells the fit is flat around them."""
    middle = 4.2 + part * WIDTH / 12
    beside = [middle + side * off + gap for side in (-1, 1) for gap in (-1.2e-3, 1.2e-3)]
    others = [middle + side * far for side in (-1, 1) for far in (2.0, 2.1)]
    pairs = [(middle + side * 0.015, 0.014) for side in (-1, 1)]
    pairs += [(middle + side * 2.0, 0.5) for side in (-1, 1)]
    rest = product(*pairs, real=(*beside, *others))

    def at(cosine: np.ndarray, sine: np.ndarray) -> np.ndarray:
        rounding = 1e-14 * np.sin(1e4 * np.arctan2(sine, cosine))
        return np.asarray(rest(cosine, sine) * (1.0 + rounding))

    found = real_roots(at)
    assert found is not None
    assert found.complete
    assert not found.double
    expected = np.sort(np.mod([*beside, *others], 2 * np.pi))
    np.testing.assert_allclose(np.sort(np.mod(found.simple, 2 * np.pi)), expected, atol=1e-6)


@pytest.mark.parametrize("noise", [1e-11, 4e-11])
@pytest.mark.parametrize("edge", [15 / 256, 1 / 16])
@pytest.mark.parametrize("off", np.linspace(-3e-4, 3e-4, 13).tolist())
def test_a_look_may_end_in_the_middle_of_a_pair(edge: float, off: float, noise: float) -> None:
    """Two pairs of real roots, and their opposites, of which the fit shows double ones alone."""
    apart = edge + off
    pairs = [(at, at + 3e-4) for first in (2.3, 2.3 + apart) for at in (first, first + np.pi)]
    real = sorted(root for pair in pairs for root in pair)
    rest = product((1.0, 1.0), (4.0, 1.0), (5.5, 1.0), (0.2, 1.0), real=real)

    def at(cosine: np.ndarray, sine: np.ndarray) -> np.ndarray:
        rounding = noise * np.sin(1e4 * np.arctan2(sine, cosine))
        return np.asarray(rest(cosine, sine) * (1.0 + rounding))

    assert plain(at).double
    found = real_roots(at)
    assert found is not None
    assert found.complete
    assert not found.double
    np.testing.assert_allclose(np.sort(np.mod(found.simple, 2 * np.pi)), real, atol=1e-6)


@pytest.mark.parametrize("gaps", [(2e-6, 1e-6), (2e-6, 7e-6), (7e-6, 2e-6), (1e-4, 2e-6)])
@pytest.mark.parametrize("apart", np.linspace(0.0575, 0.0635, 25).tolist())
def test_a_look_at_one_pair_takes_nothing_of_another(
    apart: float, gaps: tuple[float, float]
) -> None:
    """Pairs that a look resolves at its middle are double roots at its edge, if anything."""
    firsts = [(2.3, gaps[0]), (2.3 + apart, gaps[1])]
    pairs = [(at, at + gap) for first, gap in firsts for at in (first, first + np.pi)]
    rest = product((1.0, 1.0), (4.0, 1.0), (5.5, 1.0), (0.2, 1.0), real=[*np.ravel(pairs)])

    def at(cosine: np.ndarray, sine: np.ndarray) -> np.ndarray:
        rounding = 1e-11 * np.sin(1e4 * np.arctan2(sine, cosine))
        return np.asarray(rest(cosine, sine) * (1.0 + rounding))

    found = real_roots(at)
    assert found is not None
    for pair in pairs:
        beside = [
            abs(np.angle(np.exp(1j * (np.array(each) - np.mean(pair)))))
            for each in (found.simple, found.double)
        ]
        assert (beside[0] < 1e-3).sum() == 2 or (beside[1] < 1e-3).any() or not found.complete


def test_a_double_root_stays_one() -> None:
    found = real_roots(product((1.0, 0.0), (2.0, 0.5)))
    assert found is not None
    np.testing.assert_allclose(found.double, [1.0], atol=1e-6)
    assert len(found.simple) == len(ELSEWHERE)


def test_nothing_at_all() -> None:
    assert real_roots(lambda cosine, sine: 0.0 * cosine * sine) is None


BESIDE = product((1.0, 1e-5), (2.0, 0.5))  # a pair that hardly differs from a double root


def test_what_f_turns_back_beside_is_lifted() -> None:
    found = plain(BESIDE)
    assert found.complete
    assert not found.double
    np.testing.assert_allclose(found.lifted, [1.0], atol=1e-6)


def test_what_f_is_made_of_denies_a_root_without_a_closer_look() -> None:
    looks = []

    def at(cosine: np.ndarray, sine: np.ndarray) -> np.ndarray:
        looks.append(1)
        return BESIDE(cosine, sine)

    asked: list[float] = []

    def none(angle: float) -> bool:
        asked.append(angle)
        return False

    alone = real_roots(BESIDE)
    denied = real_roots(at, none)
    assert alone is not None
    assert denied is not None
    np.testing.assert_allclose(asked, [1.0], atol=1e-6)
    assert len(looks) == 1
    assert denied.complete
    assert not denied.double
    assert not denied.unseen
    np.testing.assert_allclose(alone.double, [1.0], atol=1e-6)
    assert denied.simple == alone.simple


def test_what_f_is_made_of_cannot_deny_a_double_root() -> None:
    found = real_roots(product((1.0, 0.0), (2.0, 0.5)), lambda _: False)
    assert found is not None
    np.testing.assert_allclose(found.double, [1.0], atol=1e-6)

"""That polynomials have no common factor is said where a greatest common divisor says so, too."""

from __future__ import annotations

from functools import reduce
from typing import TYPE_CHECKING

import numpy as np
import pytest
from sympy.polys.domains import QQ
from sympy.polys.rings import ring

from dhgen.paul.common_factor import FACTOR, have_nothing_in_common

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial

RING, X, Y, Z = ring("x, y, z", QQ)


def drawn(source: np.random.Generator) -> Polynomial:
    """A polynomial of a few terms with small fractions, of which several share letters."""
    powers = source.integers(0, 3, (3, 3))
    numbers = source.integers(-4, 5, (3, 2))
    fractions = [QQ(int(above), 1 + abs(int(below))) for above, below in numbers]
    terms = zip((tuple(map(int, each)) for each in powers), fractions, strict=True)
    return RING.from_dict({power: number for power, number in terms if number})


def test_as_a_greatest_common_divisor_says() -> None:
    source = np.random.default_rng(2)
    said = {True: 0, False: 0}
    for _ in range(300):
        factor = drawn(source) if source.random() < 0.5 else RING.one
        parts = [part for part in (factor * drawn(source) for _ in range(3)) if part]
        if parts:
            none = reduce(lambda one, other: one.gcd(other), parts).is_ground
            assert have_nothing_in_common(parts) == none, parts
            said[none] += 1
    assert min(said.values()) > 50


FLAT = (X - FACTOR) * (Y - FACTOR**2) + 1


@pytest.mark.parametrize("part", [FLAT, X * Y - X * FACTOR**2 + Z, Y - FACTOR**2])
def test_where_the_numbers_for_other_letters_are_roots(part: Polynomial) -> None:
    """They are powers of FACTOR: with them FLAT is 1, in whichever letter it is looked at."""
    assert not have_nothing_in_common([part * (X + Y), part * (X - Y)])
    assert not have_nothing_in_common([part * X + part, part])


def test_numbers_are_no_factors() -> None:
    assert have_nothing_in_common([2 * X, 2 * Y])
    assert have_nothing_in_common([RING(3), X])
    assert not have_nothing_in_common([X / 2])

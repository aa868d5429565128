from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from sympy.polys.domains import QQ
from sympy.polys.rings import PolyRing

from dhgen.kinematics.constants import Constant, Polynomial
from dhgen.kinematics.normal import NormalForm, normal_form
from dhgen.kinematics.transform import (
    Transform,
    compose,
    identity,
    inverse,
    rotation_x,
    rotation_z,
    translation,
    turn_between,
)
from tests.kinematics.values import matrix, number
from tests.robots.cases import rotation

RING = PolyRing(["c1", "s1", "c2", "s2", "a", "d"], QQ)
C1, S1, C2, S2, A, D = RING.gens
NORMAL: NormalForm = normal_form(RING, (), {"s1": "c1", "s2": "c2"})
angles = st.floats(-4, 4)


def values(first: float, second: float) -> dict[str, float]:
    return {
        "c1": math.cos(first),
        "s1": math.sin(first),
        "c2": math.cos(second),
        "s2": math.sin(second),
        "a": 0.7,
        "d": -1.3,
    }


def link() -> Transform:
    """Rz(1) T(a, 0, d) Rx(2), as in a table."""
    turn = compose(rotation_z(RING, C1, S1), translation(RING, (A, RING.zero, D)), NORMAL)
    return compose(turn, rotation_x(RING, C2, S2), NORMAL)


@given(angles, angles)
def test_products_are_those_of_matrices(first: float, second: float) -> None:
    offset = np.eye(4)
    offset[:3, 3] = 0.7, 0, -1.3
    expected = rotation("z", first) @ offset @ rotation("x", second)
    np.testing.assert_allclose(matrix(link(), values(first, second)), expected, atol=1e-15)


def test_a_transform_times_its_inverse_is_nothing_exactly() -> None:
    for transform in (link(), compose(link(), link(), NORMAL)):
        assert compose(transform, inverse(transform, NORMAL), NORMAL) == identity(RING)
        assert compose(inverse(transform, NORMAL), transform, NORMAL) == identity(RING)


def test_entries_and_columns_count_the_translation_as_the_fourth() -> None:
    assert link().entry(0, 3) == A * C1
    assert link().column(3) == (A * C1, A * S1, D)
    assert link().column(2) == (S1 * S2, -C1 * S2, C2)


def test_turn_between_tells_parallel_from_antiparallel() -> None:
    half_turn = rotation_x(RING, -RING.one, RING.zero)
    assert turn_between(rotation_z(RING, C1, S1).rotation) == 1
    assert turn_between(half_turn.rotation) == -1
    assert turn_between(rotation_x(RING, C2, S2).rotation) == 0


monomials = st.tuples(*[st.integers(0, 5)] * 4, st.integers(0, 2), st.just(0))


@given(st.dictionaries(monomials, st.integers(-3, 3).filter(bool), max_size=6), angles, angles)
def test_the_normal_form_changes_the_writing_not_the_value(
    terms: dict[tuple[int, ...], int], first: float, second: float
) -> None:
    polynomial = RING.from_dict({powers: QQ(n) for powers, n in terms.items()})
    reduced = NORMAL(polynomial)
    assert all(powers[1] <= 1 and powers[3] <= 1 for powers in reduced)
    assert all(reduced.values())  # no zero terms
    assert NORMAL(reduced) == reduced
    at = values(first, second)
    assert abs(number(reduced, at) - number(polynomial, at)) < 1e-9


polynomials = st.dictionaries(
    st.tuples(*[st.integers(0, 3)] * 6), st.fractions(-3, 3, max_denominator=9), max_size=4
).map(lambda terms: RING.from_dict({m: QQ(n.numerator, n.denominator) for m, n in terms.items()}))


@given(st.lists(st.tuples(st.integers(-2, 2), polynomials, polynomials), max_size=3))
def test_a_sum_of_products_is_that_of_the_ring(
    terms: list[tuple[int, Polynomial, Polynomial]],
) -> None:
    assert NORMAL.products(terms) == NORMAL(sum((n * f * g for n, f, g in terms), RING.zero))


def test_the_square_of_a_root_may_be_a_fraction() -> None:
    root = Constant("a", 0.75**0.5, "", square=Fraction(3, 4))
    normal = normal_form(RING, (root,), {"s1": "c1"})
    assert normal(A**5 * S1**2 + A / 3) == A * QQ(9, 16) * (1 - C1**2) + A / 3


def test_the_normal_form_is_unique() -> None:
    assert NORMAL(S1**2 + C1**2) == 1
    assert NORMAL(S1**4 - (1 - C1**2) ** 2) == 0
    assert NORMAL((S1 * C2 + C1 * S2) ** 2 + (C1 * C2 - S1 * S2) ** 2) == 1

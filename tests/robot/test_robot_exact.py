"""Exact numbers and angles: surds, simplifying constructors, multiples of pi/12."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhgen.robot.angles import exact_angle, exact_cosine, twelfths
from dhgen.robot.arithmetic import parse
from dhgen.robot.exact import Surd, add, canonical, multiply, negate, number, subtract, surd
from dhgen.robot.expression import ONE, ZERO, Expression, Name, Negate, evaluate, to_text

FRACTIONS = st.fractions(-20, 20, max_denominator=12)
SURDS = st.builds(lambda a, b, c, d: Surd((a, b, c, d)), *[FRACTIONS] * 4)


def value(number: Surd) -> float:
    roots = (1.0, math.sqrt(2), math.sqrt(3), math.sqrt(6))
    return sum(float(c) * r for c, r in zip(number.coefficients, roots, strict=True))


@given(SURDS, SURDS, SURDS)
def test_surds_are_a_ring(a: Surd, b: Surd, c: Surd) -> None:
    assert a * b == b * a
    assert (a * b) * c == a * (b * c)
    assert a * (b + c) == a * b + a * c
    assert a + -a == Surd.of(0)
    assert value(a * b) == pytest.approx(value(a) * value(b), abs=1e-9)


@given(SURDS)
def test_a_surd_is_found_again_in_its_expression(a: Surd) -> None:
    assert surd(a.expression()) == a
    assert evaluate(a.expression(), {}) == pytest.approx(value(a), abs=1e-9)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("sqrt(1/2)", None),
        ("sqrt(0.5)", "sqrt(2)/2"),
        ("1/sqrt(2)", "sqrt(2)/2"),
        ("-sqrt(3)/2", "-(sqrt(3)/2)"),
        ("sqrt(12)", "2*sqrt(3)"),
        ("sqrt(6)*sqrt(2)/4", "sqrt(3)/2"),
        ("(1 + sqrt(2))*(1 - sqrt(2))", "-1"),
        ("sqrt(5)", None),
        ("1/(1 + sqrt(2))", None),
        ("sqrt(4)", "2"),
        ("pi", None),
    ],
)
def test_canonical_numbers(text: str, expected: str | None) -> None:
    assert to_text(canonical(parse(text, {}))) == (expected or text)


X, Y = Name("x"), Name("y")


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (multiply(ZERO, X), "0"),
        (multiply(X, ONE), "x"),
        (multiply(Negate(ONE), X), "-x"),
        (multiply(Negate(X), Negate(Y)), "x*y"),
        (multiply(X, number(Fraction(-2))), "-(2*x)"),
        (multiply(number(Fraction(2)), multiply(number(Fraction(3)), X)), "6*x"),
        (multiply(exact_cosine(3), multiply(exact_cosine(3), X)), "0.5*x"),
        (add(X, ZERO), "x"),
        (add(ZERO, X), "x"),
        (add(X, Negate(Y)), "x - y"),
        (subtract(ZERO, X), "-x"),
        (subtract(X, ZERO), "x"),
        (subtract(X, Negate(Y)), "x + y"),
        (negate(negate(X)), "x"),
        (negate(ZERO), "0"),
    ],
)
def test_simplifying_constructors(expression: Expression, text: str) -> None:
    assert to_text(expression) == text


@given(st.integers(-100, 100))
def test_exact_angles_and_cosines(k: int) -> None:
    angle = evaluate(exact_angle(k), {})
    assert angle == pytest.approx(k * math.pi / 12, abs=1e-13)
    assert twelfths(angle) == k
    assert evaluate(exact_cosine(k), {}) == pytest.approx(math.cos(angle), abs=1e-12)


@pytest.mark.parametrize(
    ("k", "angle", "cosine"),
    [
        (0, "0", "1"),
        (1, "pi/12", "(sqrt(2) + sqrt(6))/4"),
        (2, "pi/6", "sqrt(3)/2"),
        (3, "pi/4", "sqrt(2)/2"),
        (4, "pi/3", "0.5"),
        (5, "5*pi/12", "(-sqrt(2) + sqrt(6))/4"),
        (6, "pi/2", "0"),
        (8, "2*pi/3", "-0.5"),
        (12, "pi", "-1"),
        (-6, "-pi/2", "0"),
        (-18, "-3*pi/2", "0"),
        (24, "2*pi", "1"),
    ],
)
def test_exact_angles_as_one_writes_them(k: int, angle: str, cosine: str) -> None:
    assert to_text(exact_angle(k)) == angle
    assert to_text(exact_cosine(k)) == cosine


@pytest.mark.parametrize("value", [1.5708, 0.1, 1e-8, 1e300, math.inf, math.nan])
def test_other_angles_are_no_multiples(value: float) -> None:
    assert twelfths(value) is None

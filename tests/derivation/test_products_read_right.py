"""Products, squares and fractions as people write them."""

from __future__ import annotations

from fractions import Fraction

from dhgen.derivation.text.formula import Number, Quotient, Sum, Symbol, over, times
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from tests.derivation.made import made_of
from tests.derivation.stories import document

A, B = Symbol("a", "a"), Symbol("b", "b")
ROOT = Symbol(r"\sqrt{3}", "√3")
SINE = Symbol(r"\sin \alpha_2", "sin α₂")
HALF_ROOT = Quotient(ROOT, Number(Fraction(2)))


def test_nothing_follows_a_function_that_could_be_part_of_its_angle() -> None:
    assert show(times(SINE, A, Sum((A, B))), PLAIN) == "a (a + b) sin α₂"
    assert show(times(Number(Fraction(-2)), SINE, A), PLAIN) == "−2 a sin α₂"


def test_a_fraction_by_a_fraction_is_one() -> None:
    half = Number(Fraction(1, 2))
    assert show(over(Sum((A, B)), half), PLAIN) == "2 (a + b)"
    assert show(over(A, times(HALF_ROOT, B)), PLAIN) == "(2 a)/(√3 b)"
    assert show(over(times(HALF_ROOT, A), HALF_ROOT), PLAIN) == "a"
    assert show(over(times(Number(Fraction(3)), A), HALF_ROOT), PLAIN) == "2 √3 a"
    assert show(over(times(HALF_ROOT, A), times(half, B)), PLAIN) == "(√3 a)/b"


def test_squares_of_sums_and_what_stands_before_one_entry_are_gathered() -> None:
    rows = (
        "theta: q, d: 0.3, a: 0.3, alpha: 60 deg",
        "theta: 0, d: q, a: 0.2, alpha: -60 deg",
        "theta: q, a: 0.25",
    )
    text = made_of(*rows, task="position")
    assert "(a_1 + a_2)^2" in text
    assert "2 a_1 a_2" not in text
    assert "t_{14} (a_1 + a_2)" in text


def test_a_condition_is_told_without_the_numbers_and_lengths_that_all_its_terms_share() -> None:
    assert "| $s_2 = 0$ |" in document("craig_417")

"""Numbers that a cell adds to parameters: formulas have a letter for them, and stay products."""

from __future__ import annotations

from dhgen.derivation.french.sentences import french
from tests.derivation.made import made_of

ROWS = "theta: q, d: d1, alpha: pi/2", "theta: q, a: b", "theta: q, a: g + 0.1"


def arm(*rows: str) -> str:
    return made_of(
        *rows,
        parameters="{b: 0.3, g: 0.2, d1: g + 0.1}",
        tool="{xyz: [0.05, 0, 0.4 + b]}",
        task="position",
    )


def test_a_number_beside_a_parameter_gets_a_letter_and_its_decimals() -> None:
    text = arm(*ROWS)
    assert "$a_3 = 0.1$ m (part of link length 3)" in text
    assert "$e_z = 0.4$ m (part of z of the tool frame)" in text
    assert "| 3 | $q_3$ | $0$ | $g + 0.1$ | $0$ |" in text
    assert r"\frac{1}{10}" not in text


def test_the_determinant_is_the_product_that_the_links_make() -> None:
    """The second link with the tool is g + a_3 + e_x long."""
    line = r"\det J = -b (g + a_3 + e_x) (b c_2 + c_{23} (g + a_3 + e_x)) s_3"
    assert line in arm(*ROWS).splitlines()


def test_the_square_of_a_sum_of_three_stays_one() -> None:
    assert "K = Z₁² + Z₂² − b² − (g + a₃ + e_x)²" in arm(*ROWS)


def test_arithmetic_of_decimals_leaves_no_rounding_in_a_parameter() -> None:
    """In floating-point numbers 0.2 + 0.1 is 0.30000000000000004."""
    assert "$d_1 = g + 0.1 = 0.3$ m" in arm(*ROWS)


def test_a_number_in_front_of_a_sum_is_not_divided_among_its_terms() -> None:
    text = arm(ROWS[0], "theta: q, a: b, d: 0", "theta: q, a: 0.35*g + 1/3*b")
    (line,) = (each for each in text.splitlines() if each.startswith(r"\det J = "))
    assert line.count(r"\frac") == 1


def test_links_that_are_sums_stay_factors_of_the_determinant() -> None:
    """Links g + a_2 and a_2 + b: a planar arm of two links that turns about a vertical axis."""
    text = made_of(
        ROWS[0],
        "theta: q, a: g + 0.1",
        "theta: q, a: b + 0.1",
        parameters="{b: 0.3, g: 0.2, d1: 0.4}",
        task="position",
    )
    line = r"\det J = -(g + a_2) (a_2 + b) (c_2 (g + a_2) + c_{23} (a_2 + b)) s_3"
    assert line in text.splitlines()
    meaning = "part of link length 2 and part of link length 3"
    assert f"$a_2 = 0.1$ m ({meaning})" in text
    assert french(meaning) == "en partie longueur de segment 2 et en partie longueur de segment 3"

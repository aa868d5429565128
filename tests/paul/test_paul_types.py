"""Each type on equations made for it: what it takes, what it refuses, and what it says then."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from dhgen.paul.form import unknown_name
from dhgen.paul.kind import Kind
from dhgen.paul.types.angle import Angle
from dhgen.paul.types.angle_and_length import AngleAndLength, Polar
from dhgen.paul.types.angle_pair import MAY_VANISH_REASON, AnglePair
from dhgen.paul.types.lengths import (
    LengthOnALine,
    SingleLength,
    SquaredLength,
    TwoLengths,
    determinant,
    line_of,
)
from dhgen.paul.types.two_angles import TwoAngles
from tests.kinematics.values import table
from tests.paul.arms import Bench

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial

BENCH = Bench(
    table(
        "theta: q, a: a1",
        "theta: q, a: a2",
        "theta: 0, d: q",
        "theta: q, d: d4, alpha: pi/2",
        "theta: q, a: a5, alpha: pi/2",
        "theta: q, d: d6",
        parameters="{a1: 0.5, a2: 0.4, d4: 0.3, a5: 0.2, d6: 0.1}",
    )
)
g = BENCH.names
SLIDES = Bench(
    table(
        "theta: q, alpha: pi/2",
        "theta: 0, d: q, alpha: pi/2",
        "theta: q, a: a3, alpha: pi/2",
        "theta: 0, d: q, alpha: pi/2",
        "theta: q",
        parameters="{a3: 0.5}",
    )
)
g2 = SLIDES.names
# zero on every solution, though no normal form shows it: columns of a rotation
NOTHING = g.t11**2 + g.t21**2 + g.t31**2 - 1
NOTHING_2 = g2.t11**2 + g2.t21**2 + g2.t31**2 - 1
NOUGHT = g.t11 * g.t12 + g.t21 * g.t22 + g.t31 * g.t32


def test_type_1_is_linear_in_a_length() -> None:
    (step,) = BENCH.steps(SingleLength(), 2 * g.a1 * g.r3 - g.t34 + g.d4)
    assert step.kind is Kind.LENGTH
    assert dict(step.coefficients) == {"X": 2 * g.a1, "Y": g.t34 - g.d4}


@pytest.mark.parametrize(
    ("equation", "reason"),
    [
        (g.r3**2 - g.t34, "r3 occurs in a higher power"),
        (g.c1 - g.t11, "the unknown is not a single length"),
        (g.r3 * g.c1 - g.t11, "the unknown is not a single length"),
        (NOTHING * g.r3 + g.t34 * NOUGHT, "the factor of r3 vanishes"),
    ],
)
def test_type_1_refuses(equation: Polynomial, reason: str) -> None:
    assert BENCH.why_not(SingleLength(), equation) == reason


def test_a_divisor_that_may_vanish_is_the_last_resort() -> None:
    (constant,) = BENCH.steps(SingleLength(), g.a1 * g.r3 - g.t34)
    (variable,) = BENCH.steps(SingleLength(), g.t33 * g.r3 - g.t34)
    assert variable.penalty > constant.penalty + 300


def test_type_2_is_linear_in_a_cosine_and_sine() -> None:
    (step,) = BENCH.steps(Angle(), g.t14 * g.s1 - g.t24 * g.c1 - g.d4)
    assert dict(step.coefficients) == {"X": g.t14, "Y": -g.t24, "Z": g.d4}
    (lone,) = BENCH.steps(Angle(), g.c124 - g.t11)
    assert unknown_name(lone.unknowns[0]) == "theta124"


@pytest.mark.parametrize(
    ("equation", "reason"),
    [
        (g.r3 - g.t34, "the unknown is not a single angle"),
        (g.c1 + g.c5 - g.t34, "the unknown is not a single angle"),
        (g.c1**2 - g.t34, "not linear in the cosine and sine"),
        (g.c1 * g.s1 - g.t34, "not linear in the cosine and sine"),
        # A s + B c = 0 with A and B zero on every solution
        (
            NOTHING * g.s1 + NOUGHT * g.c1,
            "X and Y vanish on every solution: the equation determines nothing",
        ),
        (NOTHING * g.s1, "X and Y vanish on every solution: the equation determines nothing"),
    ],
)
def test_type_2_refuses(equation: Polynomial, reason: str) -> None:
    assert BENCH.why_not(Angle(), equation) == reason


def test_type_2_takes_an_equation_of_which_only_one_factor_vanishes() -> None:
    assert BENCH.why_not(Angle(), NOTHING * g.s1 + g.t14 * g.c1 - g.t24) is None


def test_type_3_has_two_equations_in_one_angle() -> None:
    (step,) = BENCH.steps(AnglePair(), g.s5 - g.t34, g.c5 - g.t24)
    assert dict(step.coefficients) == {
        "X1": 1,
        "Y1": 0,
        "Z1": g.t34,
        "X2": 0,
        "Y2": 1,
        "Z2": g.t24,
    }
    assert step.roots == 1


def test_type_3_takes_a_vector_and_the_same_turned() -> None:
    first = g.t14 * g.s1 - g.t24 * g.c1 - g.d4
    turned = g.t24 * g.s1 + g.t14 * g.c1
    for factor in (1, -1, 2 * g.a2, -g.a1 * g.d4):
        assert BENCH.why_not(AnglePair(), first, factor * turned - g.a1) is None
    assert BENCH.why_not(AnglePair(), first, g.t11 * turned - g.a1) == MAY_VANISH_REASON


@pytest.mark.parametrize(
    ("first", "second", "reason"),
    [
        (g.c1 - g.t11, g.c5 - g.t24, "not the same single unknown"),
        (g.c1 * g.c5 - g.t11, g.c1 - g.c5, "not the same single unknown"),
        (g.r3 - g.t34, g.r3 - g.t24, "the unknown is not an angle"),
        (g.c1**2 - g.t11, g.s1 - g.t24, "not linear in the cosine and sine"),
        (g.c1 - g.t11, 2 * g.c1 - g.t24, "the determinant X1 Y2 - X2 Y1 vanishes"),
        (
            NOTHING * g.s1 + NOUGHT * g.c1 - g.t11,
            -NOUGHT * g.s1 + NOTHING * g.c1 - g.t11,
            "the determinant X1 Y2 - X2 Y1 vanishes",
        ),
        (
            g.t11 * g.s1 - g.t14,
            g.t12 * g.c1 - g.t24,
            "the determinant X1 Y2 - X2 Y1 may vanish where the angle is not free",
        ),
    ],
)
def test_type_3_refuses(first: Polynomial, second: Polynomial, reason: str) -> None:
    assert BENCH.why_not(AnglePair(), first, second) == reason


def test_type_4_is_a_vector_in_polar_coordinates() -> None:
    (step,) = BENCH.steps(Polar(), 2 * g.r3 * g.s1 - g.t24, g.r3 * g.c1 - g.t14)
    assert dict(step.coefficients) == {"X1": 2, "Y1": g.t24, "X2": 1, "Y2": g.t14}
    assert [unknown_name(unknown) for unknown in step.unknowns] == ["theta1", "r3"]


@pytest.mark.parametrize(
    ("first", "second", "reason"),
    [
        (g.r3 * g.c1 - 1, g.r3 * g.s1 - 1, "the first equation is not X1 r s = Y1"),
        (g.r3 * g.s1 - 1, g.r3 * g.s1 - g.c1, "the second equation is not X2 r c = Y2"),
        (g.r3 * g.s1 - 1, g.r3 * g.c5 - 1, "not the same two unknowns"),
        (g.s1 - 1, g.c1 - 1, "not the same two unknowns"),
        (g.s1 * g.c5 - 1, g.c1 * g.s5 - 1, "the unknowns are not an angle and a length"),
        (g.t11 * g.r3 * g.s1 - 1, g.r3 * g.c1 - 1, "X1 or X2 may vanish"),
        (NOTHING * g.r3 * g.s1 - 1, g.r3 * g.c1 - 1, "X1 or X2 may vanish"),
    ],
)
def test_type_4_refuses(first: Polynomial, second: Polynomial, reason: str) -> None:
    assert BENCH.why_not(Polar(), first, second) == reason


def test_type_5_has_an_angle_and_a_length_side_by_side() -> None:
    equations = (g.a1 * g.s1 - g.t24 + 3 * g.r3, g.a1 * g.c1 - g.t14 - g.r3)
    (step,) = BENCH.steps(AngleAndLength(), *equations)
    assert dict(step.coefficients) == {
        "X1": g.a1,
        "Y1": g.t24,
        "Z1": -3,
        "X2": g.a1,
        "Y2": g.t14,
        "Z2": 1,
    }


@pytest.mark.parametrize(
    ("first", "second", "reason"),
    [
        (g.s1 - g.r3, g.c1 - g.t14, "not the same two unknowns"),
        (g.s1 - g.c5, g.c1 - g.s5, "the unknowns are not an angle and a length"),
        (g.c1 - g.r3, g.s1 - g.r3, "the first equation is not X1 s = Y1 + Z1 r"),
        (g.s1 - g.r3, g.s1 + g.c1 - g.r3, "the second equation is not X2 c = Y2 + Z2 r"),
        (g.t11 * g.s1 - g.r3, g.c1 - g.r3, "X1 or X2 may vanish"),
        (g.s1 - g.t11 * g.r3, g.c1 - g.r3, "Z1 and Z2 may vanish together"),
    ],
)
def test_type_5_refuses(first: Polynomial, second: Polynomial, reason: str) -> None:
    assert BENCH.why_not(AngleAndLength(), first, second) == reason


def test_type_10_is_quadratic_in_a_length() -> None:
    (step,) = BENCH.steps(SquaredLength(), 2 * g.r3**2 - g.a1 * g.r3 + g.a2**2 - g.t34**2)
    assert (step.kind, step.roots) == (Kind.SQUARED_LENGTH, 2)
    assert dict(step.coefficients) == {"X": 2, "Y": -g.a1, "Z": g.t34**2 - g.a2**2}


@pytest.mark.parametrize(
    ("equation", "reason"),
    [
        (g.r3 - g.t34, "X vanishes"),
        (g.c1 - g.t11, "the unknown is not a single length"),
        (g.r3**3 - g.t34, "r3 occurs in a higher power than its square"),
        (g.t11 * g.r3**2 - g.t34, "X or Y may vanish"),
        (g.r3**2 - g.t11 * g.r3 - g.t34, "X or Y may vanish"),
    ],
)
def test_type_10_refuses(equation: Polynomial, reason: str) -> None:
    assert BENCH.why_not(SquaredLength(), equation) == reason


def test_type_8_has_an_angle_and_a_sum() -> None:
    (step,) = BENCH.steps(
        TwoAngles(), g.a1 * g.c1 + g.a2 * g.c12 - g.t14, g.a1 * g.s1 + g.a2 * g.s12 - g.t24
    )
    assert step.kind is Kind.ANGLE_AND_SUM
    assert [unknown_name(unknown) for unknown in step.unknowns] == ["theta2"]
    # document 003: cos(theta_k) = (Z1^2 + Z2^2 - X^2 - Y^2) / 2XY
    assert step.coefficient("Y") == 2 * g.a1 * g.a2
    assert step.coefficient("X") == 0
    assert step.coefficient("N") == g.a1**2 + g.a2**2


def test_type_6_gives_either_angle_and_type_7_has_two_known_parts() -> None:
    # W s5 = X c4 + Y s4 + Z1, W c5 = X s4 - Y c4 + Z2 with W = a5
    first = g.a5 * g.s5 - g.a1 * g.c4 - g.a2 * g.s4 - g.t14
    second = g.a5 * g.c5 - g.a1 * g.s4 + g.a2 * g.c4 - g.t24
    steps = BENCH.steps(TwoAngles(), first, second)
    assert {step.kind for step in steps} == {Kind.TWO_ANGLES}
    assert {unknown_name(step.unknowns[0]) for step in steps} == {"theta4", "theta5"}
    steps = BENCH.steps(TwoAngles(), first + g.d6 * g.c5, second - g.d6 * g.s5)
    assert {step.kind for step in steps} == {Kind.TWO_ANGLES_TURNED}


@pytest.mark.parametrize(
    ("first", "second", "reason"),
    [
        (g.c1 - g.t14, g.c1 + g.c5 - g.t24, "not the same two unknowns"),
        (g.r3 * g.s1 - 1, g.r3 * g.c1 - 1, "the unknowns are not two angles"),
        (g.c1 * g.c5 - 1, g.s1 + g.c5 - 1, "not linear in the cosines and sines"),
        (
            g.c4 + g.c5 - g.t14,
            2 * g.s4 + g.s5 - g.t24,
            "the coefficients are not those of a rotated vector",
        ),
        (
            NOTHING * g.c4 + g.c5 - g.t14,
            NOTHING * g.s4 + g.s5 - g.t24,
            "a coefficient vanishes on every solution",
        ),
    ],
)
def test_types_6_to_8_refuse(first: Polynomial, second: Polynomial, reason: str) -> None:
    assert BENCH.why_not(TwoAngles(), first, second) == reason


@pytest.mark.parametrize("equation_type", [AnglePair(), Polar(), AngleAndLength(), TwoAngles()])
def test_types_of_pairs_refuse_what_they_cannot_read(
    equation_type: AnglePair | Polar | AngleAndLength | TwoAngles,
) -> None:
    assert BENCH.why_not(equation_type, g.c1 * g.c5 - g.r3, g.s1 * g.c5 - g.c4)


def test_type_11_is_linear_in_two_lengths() -> None:
    first = g2.t11 * g2.r2 + g2.t12 * g2.r4 - g2.t14
    second = g2.r2 - 2 * g2.r4 + g2.t24
    (step,) = SLIDES.steps(TwoLengths(), first, second)
    assert dict(step.coefficients) == {
        "X1": g2.t11,
        "Y1": g2.t12,
        "Z1": g2.t14,
        "X2": 1,
        "Y2": -2,
        "Z2": -g2.t24,
    }
    assert [unknown_name(unknown) for unknown in step.unknowns] == ["r2", "r4"]
    assert determinant(step, SLIDES.algebra) == -2 * g2.t11 - g2.t12
    assert step.roots == 1


@pytest.mark.parametrize(
    ("first", "second", "reason"),
    [
        (g2.r2 + g2.r4 - 1, g2.r2 - 1, "the unknowns are not two lengths"),
        (g2.r2 + g2.r4 - 1, g2.r2 + g2.c5, "the unknowns are not two lengths"),
        (g2.r2**2 + g2.r4 - 1, g2.r2 - g2.r4, "a length occurs in a higher power"),
        (g2.r2 * g2.r4 - 1, g2.r2 - g2.r4, "a length occurs in a higher power"),
        (g2.r2 + g2.r4 - 1, g2.t11 * (g2.r2 + g2.r4) - 2, "the determinant vanishes"),
        (g2.r2 + (1 + NOTHING_2) * g2.r4 - 1, g2.r2 + g2.r4 - 2, "the determinant vanishes"),
    ],
)
def test_type_11_refuses(first: Polynomial, second: Polynomial, reason: str) -> None:
    assert SLIDES.why_not(TwoLengths(), first, second) == reason


def test_type_10_of_two_lengths_puts_a_line_into_a_squared_length() -> None:
    line = 2 * g2.r2 + g2.r4 - g2.t34
    square = g2.r2**2 + g2.r4**2 - g2.t14
    gone, kept = SLIDES.steps(LengthOnALine(), line, square)
    assert [unknown_name(unknown) for step in (gone, kept) for unknown in step.unknowns] == [
        "r4",
        "r2",
    ]
    # r2 = (t34 - r4) / 2, times 4
    assert dict(gone.coefficients) == {
        "X": 5,
        "Y": -2 * g2.t34,
        "Z": 4 * g2.t14 - g2.t34**2,
    }
    other, (v, w, z) = line_of(gone)
    assert (other.name, v, w, z) == ("r2", 2, 1, g2.t34)
    assert gone.roots == 2


def test_squares_that_cancel_leave_type_1() -> None:
    line = g2.r2 + g2.r4 - g2.t24
    square = g2.r2**2 - g2.r4**2 - g2.t14
    first, _ = SLIDES.steps(LengthOnALine(), line, square)
    assert first.kind is Kind.LENGTH
    assert dict(first.coefficients) == {"X": -2 * g2.t24, "Y": g2.t14 - g2.t24**2}


@pytest.mark.parametrize(
    ("first", "second", "reason"),
    [
        (g2.r2 - 1, g2.r2**2 + g2.r4**2 - 1, "the unknowns are not two lengths"),
        (g2.r2 + g2.r4**2, g2.r2**2 + g2.r4**2 - 1, "the first equation is not linear"),
        (g2.r2 + g2.r4, g2.r2 - g2.r4 - g2.t14, "the second equation is not quadratic"),
        (g2.r2 + g2.r4, g2.r2**3 - g2.r4, "the second equation is not quadratic"),
        (g2.t11 * g2.r2 + g2.t12 * g2.r4, g2.r2**2 + g2.r4**2 - 1, "X or V may vanish"),
    ],
)
def test_type_10_of_two_lengths_refuses(first: Polynomial, second: Polynomial, reason: str) -> None:
    assert SLIDES.why_not(LengthOnALine(), first, second) == reason

"""What is called irreducible is: seen on a line through rational joints and numbers of the arm.

There the determinant of the Jacobian, worked out in fractions from the robot's table, is a
polynomial in one variable, which another program takes apart.
"""

from __future__ import annotations

import math
import random
from fractions import Fraction
from typing import TYPE_CHECKING

import pytest
from sympy import Poly, interpolate, symbols

from dhgen.derivation.velocity.irreducible import is_irreducible
from dhgen.robot.expression import evaluate
from dhgen.robot.robot import Convention, DhTable
from tests.derivation.stories import document, story
from tests.serial import SERIAL
from tests.structures import quick_first

if TYPE_CHECKING:
    from dhgen.robot.robot import Robot

X = symbols("x")
SAID = "it is an irreducible polynomial"
POWER = 2  # of 1 + t^2 by which it is a polynomial
PLACES = 2 * POWER * 6 + 2
LARGEST = 200  # denominator of a number of the arm

Vector = list[Fraction]


def turn(t: Fraction) -> tuple[Fraction, Fraction]:
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


def crossed(a: Vector, b: Vector) -> Vector:
    return [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]


def chained(A: list[Vector], B: list[Vector]) -> list[Vector]:
    columns = [[row[j] for row in B] for j in range(4)]
    return [[dotted(row, column) for column in columns] for row in A]


def dotted(a: Vector, b: Vector) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))


def determinant(robot: Robot, tangents: Vector) -> Fraction:
    """By the standard convention; offsets and the tool change nothing about factors."""
    table = robot.geometry
    assert isinstance(table, DhTable)
    assert table.convention is Convention.STANDARD
    known = {each.name: each.value for each in robot.parameters}
    zero, one = Fraction(0), Fraction(1)
    T = [[one * (i == j) for j in range(4)] for i in range(4)]
    axes: list[tuple[Vector, Vector]] = []
    for row, t in zip(table.rows, tangents, strict=True):
        axes.append(([T[i][2] for i in range(3)], [T[i][3] for i in range(3)]))
        cells = [evaluate(cell, known) for cell in (row.a, row.d, row.alpha)]
        values = (*cells[:2], math.tan(0.5 * cells[2]))
        a, d, tilt = (Fraction(value).limit_denominator(LARGEST) for value in values)
        (c, s), (ca, sa) = turn(t), turn(tilt)
        link = [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [zero, sa, ca, d]]
        T = chained(T, [*link, [zero, zero, zero, one]])
    tip = [T[i][3] for i in range(3)]
    columns = [crossed(z, [a - b for a, b in zip(tip, o, strict=True)]) + z for z, o in axes]
    return eliminated(columns)


def eliminated(rows: list[Vector]) -> Fraction:
    total = Fraction(1)
    for k, row in enumerate(rows):
        pivot = next(i for i in range(k, len(rows)) if rows[i][k])
        if pivot != k:
            rows[k], rows[pivot], total = rows[pivot], row, -total
        total *= row[k]
        for i in range(k + 1, len(rows)):
            factor = rows[i][k] / row[k]
            rows[i] = [a - factor * b for a, b in zip(rows[i], row, strict=True)]
    return total


def degrees_of_factors(robot: Robot) -> list[int]:
    """Of the determinant's polynomial on a line, without those of 1 + t^2."""
    source = random.Random(6)  # noqa: S311 - a line, no secret
    # all different, so that no two angles are special at one place
    starts, slopes = source.sample(range(1, 40), 6), source.sample(range(1, 40), 6)
    line = [(Fraction(a, 41), Fraction(b, 29)) for a, b in zip(starts, slopes, strict=True)]
    places = []
    for x in range(PLACES):
        tangents = [a + b * x for a, b in line]
        value = determinant(robot, tangents) * math.prod((1 + t * t) ** POWER for t in tangents)
        places.append((x, value))
    polynomial = Poly(interpolate(places, X), X)
    circles = [Poly(1 + (a + b * X) ** 2, X).monic() for a, b in line]
    factors = [(part.monic(), power) for part, power in polynomial.factor_list()[1]]
    return sorted(part.degree() for part, _ in factors if part not in circles)


def test_many_arms_say_so() -> None:
    assert sum(SAID in document(name) for name in SERIAL) > 12


@pytest.mark.parametrize("name", quick_first(["abb_gofa_5", "manseur_doty", "kinova_jaco2"]))
def test_what_is_called_irreducible_has_one_factor(name: str) -> None:
    assert SAID in document(name)
    assert is_irreducible(story(name))
    assert len(degrees_of_factors(story(name).robot)) == 1


@pytest.mark.parametrize("name", quick_first(["ur5", "arm_6r"]))
def test_a_product_is_not_called_so(name: str) -> None:
    assert not is_irreducible(story(name))
    assert len(degrees_of_factors(story(name).robot)) > 1

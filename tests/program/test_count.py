"""Operations are counted once for every combination of the signs that a value depends on."""

from __future__ import annotations

import pytest

from dhgen.program.count import OperationCount, count_operations
from dhgen.program.ir import (
    Apply,
    Axis,
    Failure,
    Guard,
    Heading,
    Integer,
    Let,
    Pose,
    Program,
    Variable,
)
from tests.derivation.stories import NAMES, story

AXES = (Axis("e1", ("+", "-"), 1), Axis("e2", ("+", "-"), 2))


def program(*body: Let | Guard | Heading) -> Program:
    return Program("arm", (), AXES, body, (), ())


def test_operators_by_kind() -> None:
    x, y = Pose(1, 4), Pose(2, 4)
    nested = Apply("add", (Apply("mul", (x, x)), Apply("neg", (Apply("mul", (y, y)),))))
    found = count_operations(
        program(
            Heading("a step"),
            Let("a", nested, ()),
            Let("b", Apply("atan2", (Apply("sqrt", (x,)), Apply("div", (x, y)))), ()),
            Let("c", Apply("sub", (Apply("sin", (x,)), Apply("cos", (x,)))), ()),
        )
    )
    assert found == OperationCount(2, 2, 1, 1, 1, 2)


def test_a_value_counts_for_each_combination_of_its_signs() -> None:
    once = Apply("mul", (Pose(1, 1), Integer(2)))
    found = count_operations(
        program(
            Let("a", once, ()),
            Let("b", Apply("mul", (Variable("a"), Variable("e1"))), (0,)),
            Let("c", Apply("add", (Variable("b"), Variable("e2"))), (0, 1)),
        )
    )
    assert (found.multiplications, found.additions) == (3, 4)


def test_conditions_count_and_margins_do_not() -> None:
    difference = Apply("sub", (Pose(1, 4), Integer(1)))
    condition = Apply("at_most", (Integer(0), difference))
    found = count_operations(program(Guard(condition, (1,), Failure.REACH, margin=difference)))
    assert found == OperationCount(2, 0, 0, 0, 0, 0)


@pytest.mark.parametrize("name", NAMES)
def test_an_angle_takes_one_arctangent_a_row(name: str) -> None:
    of = story(name)
    turning = of.dof - len(of.algebra.slides)
    assert count_operations(of.program).arctangents <= turning * of.program.rows


def test_planar_rr() -> None:
    found = count_operations(story("planar_rr").program)
    assert found.arctangents == 4
    assert found.square_roots <= 3

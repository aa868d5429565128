"""The interpreter is the meaning of the language: every operator, signs as axes, guards as rows."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.program.interpret import interpret, wrap
from dhgen.program.ir import (
    Apply,
    Axis,
    Failure,
    Guard,
    Heading,
    Integer,
    Joint,
    Let,
    NamedConstant,
    Pose,
    Program,
    Variable,
)

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

X, Y = Pose(1, 4), Pose(2, 4)
LESS = Apply("less", (X, Y))
MORE = Apply("less", (Y, X))
AXES = (Axis("e1", ("+", "-"), 1), Axis("e2", ("+", "-"), 2))


def poses(*points: tuple[float, float]) -> FloatArray:
    T = np.tile(np.eye(4), (len(points), 1, 1))
    T[:, :2, 3] = points
    return T


def program(
    *outputs: object, body: tuple[object, ...] = (), axes: tuple[Axis, ...] = ()
) -> Program:
    constants = (NamedConstant("length", 2.5, "a test"),)
    return Program("t", constants, axes, body, outputs, ())  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("expression", "wanted"),
    [
        (Apply("add", (X, Y)), 0.75),
        (Apply("sub", (X, Y)), -1.25),
        (Apply("mul", (X, Y)), -0.25),
        (Apply("div", (X, Y)), -0.25),
        (Apply("neg", (X,)), 0.25),
        (Apply("abs", (X,)), 0.25),
        (Apply("sqrt", (Y,)), 1.0),
        (Apply("sin", (X,)), math.sin(-0.25)),
        (Apply("cos", (X,)), math.cos(-0.25)),
        (Apply("atan2", (X, Y)), math.atan2(-0.25, 1.0)),
        (Apply("maximum", (X, Y)), 1.0),
        (Apply("wrap", (Apply("mul", (Integer(8), Y)),)), 8.0 - 2.0 * math.pi),
        (Apply("select", (LESS, Integer(3), Integer(4))), 3.0),
        (Apply("select", (Apply("not", (LESS,)), Integer(3), Integer(4))), 4.0),
        (Apply("select", (Apply("and", (LESS, MORE)), Integer(3), Integer(4))), 4.0),
        (Apply("select", (Apply("or", (LESS, MORE)), Integer(3), Integer(4))), 3.0),
        (Apply("select", (Apply("at_most", (X, X)), Integer(3), Integer(4))), 3.0),
        (Apply("select", (Apply("less", (X, X)), Integer(3), Integer(4))), 4.0),
        (Variable("length"), 2.5),
    ],
)
def test_operators(expression: object, wanted: float) -> None:
    q = interpret(program(expression), poses((-0.25, 1.0))).q
    assert q.tolist() == [[[wanted]]]


def test_rows_count_with_the_first_sign_slowest() -> None:
    row = Apply("add", (Apply("mul", (Integer(10), Variable("e1"))), Variable("e2")))
    found = interpret(program(row, axes=AXES), poses((0.0, 0.0))).q[0, :, 0]
    assert found.tolist() == [11.0, 9.0, -9.0, -11.0]


def test_a_guard_ends_its_branches_only() -> None:
    positive = Apply("less", (Integer(0), Apply("mul", (X, Variable("e1")))))
    body = (Heading("a step"), Guard(positive, (0,), Failure.REACH))
    found = interpret(program(X, body=body, axes=AXES), poses((2.0, 0.0), (-3.0, 0.0)))
    assert found.solved.tolist() == [[True, True, False, False], [False, False, True, True]]
    assert np.array_equal(np.isnan(found.q[..., 0]), ~found.solved)


def test_later_lets_see_earlier_ones() -> None:
    body = (Let("a", Apply("add", (X, Y)), ()), Let("b", Apply("mul", (Variable("a"), X)), ()))
    assert interpret(program(Variable("b"), body=body), poses((2.0, 3.0))).q.item() == 10.0


def test_seeds_and_free_joints_are_read_by_their_roles() -> None:
    both = Apply("sub", (Joint(2, "seed"), Joint(1, "free")))
    seed = np.array([[0.0, 5.0], [0.0, 7.0]])
    found = interpret(program(X, both), poses((0, 0), (0, 0)), seed, np.array([[1.0], [2.0]]))
    assert found.q[:, 0, 1].tolist() == [4.0, 5.0]


def test_a_seed_that_is_not_given_is_zero() -> None:
    assert interpret(program(Joint(1, "seed")), poses((0, 0))).q.item() == 0.0


def test_free_says_which_solved_rows_chose() -> None:
    chosen = Let("free1", Apply("at_most", (X, Integer(0))), (), truth=True)
    guard = Guard(Apply("less", (Y, Integer(1))), (), Failure.REACH)
    made = Program("t", (), (), (chosen, guard), (X,), ((1, "free1"),))
    found = interpret(made, poses((0, 0), (1, 0), (0, 2)))
    assert found.free.ravel().tolist() == [True, False, False]


@pytest.mark.parametrize("turns", [-3, -1, 0, 1, 4])
@pytest.mark.parametrize("angle", [-3.1, -1.0, 0.0, 2.5, math.pi])
def test_wrap(turns: int, angle: float) -> None:
    assert wrap(np.array(angle + 2.0 * math.pi * turns)) == pytest.approx(angle, abs=1e-14)

"""What the builder simplifies has the value of what was written, whatever the numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhgen.program.building.builder import Builder
from dhgen.program.building.schedule import Option
from dhgen.program.count import count_operations
from dhgen.program.interpret import interpret
from dhgen.program.ir import Apply, Choice, Failure, Integer, Let, Pose, Program, Variable
from dhgen.program.reserved import Reserved
from dhgen.program.walk import expressions

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.program.building.graph import Node

POSE = np.array(
    [[0.5, -1.5, 3.0, 0.0], [2.0, 0.25, -7.0, 1.0], [1.0, 1.0, 0.5, -0.5], [0, 0, 0, 1]]
)
PLAIN: dict[str, Callable[[float, float], float]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
}

# Formulas as nested tuples: integers, constants, pose entries, and operators on them.
Formula = tuple[object, ...]
LEAVES = st.one_of(
    st.tuples(st.just("integer"), st.integers(-3, 3)),
    st.tuples(st.just("constant"), st.sampled_from(["u", "v"])),
    st.tuples(st.just("pose"), st.integers(1, 3), st.integers(1, 4)),
)
FORMULAS = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.tuples(st.sampled_from(list("+-*")), inner, inner),
        st.tuples(st.sampled_from(["neg", "square", "absolute"]), inner),
    ),
    max_leaves=12,
)
CONSTANTS = {"u": 0.375, "v": -2.0}


def plain(formula: Formula) -> float:
    """The value by Python's own arithmetic."""
    match formula:
        case ("integer", int(value)):
            return float(value)
        case ("constant", str(name)):
            return CONSTANTS[name]
        case ("pose", int(row), int(column)):
            return float(POSE[row - 1, column - 1])
        case ("neg", tuple(inner)):
            return -plain(inner)
        case ("square", tuple(inner)):
            return plain(inner) ** 2
        case ("absolute", tuple(inner)):
            return abs(plain(inner))
        case (str(sign), tuple(left), tuple(right)):
            return PLAIN[sign](plain(left), plain(right))
    raise AssertionError(formula)


def built(builder: Builder, formula: Formula) -> Node:
    """The node that the builder makes of it."""
    match formula:
        case ("integer", int(value)):
            return builder.integer(value)
        case ("constant", str(name)):
            return builder.constant(name, CONSTANTS[name], "a test")
        case ("pose", int(row), int(column)):
            return builder.pose(row, column)
        case (str(name), tuple(inner)):
            return getattr(builder, name)(built(builder, inner))  # type: ignore[no-any-return]
        case (str(sign), tuple(left), tuple(right)):
            method = {"+": builder.add, "-": builder.sub, "*": builder.mul}[sign]
            return method(built(builder, left), built(builder, right))
    raise AssertionError(formula)


def value(program: Program) -> float:
    """The first result at the test's pose."""
    return float(interpret(program, POSE[None]).q[0, 0, 0])


@given(FORMULAS)
def test_simplified_is_equal(formula: Formula) -> None:
    builder = Builder()
    program = builder.finish("t", {"q1": built(builder, formula)}, [])
    np.testing.assert_allclose(value(program), plain(formula), rtol=1e-12, atol=1e-12)


@given(FORMULAS, FORMULAS)
def test_two_results_share_and_stay_equal(first: Formula, second: Formula) -> None:
    builder = Builder()
    difference = builder.sub(built(builder, first), built(builder, second))
    mirrored = builder.sub(built(builder, second), built(builder, first))
    program = builder.finish("t", {"q1": difference, "q2": mirrored}, [])
    q = interpret(program, POSE[None]).q[0, 0]
    wanted = plain(first) - plain(second)
    scale = 1.0 + abs(plain(first)) + abs(plain(second))
    np.testing.assert_allclose(q, [wanted, -wanted], rtol=0, atol=1e-12 * scale)


@given(FORMULAS)
def test_nothing_is_left_to_simplify(formula: Formula) -> None:
    builder = Builder()
    program = builder.finish("t", {"q1": built(builder, formula)}, [])
    for expression in expressions(program):
        if not isinstance(expression, Apply):
            continue
        operands = expression.operands
        if expression.operator in {"add", "sub"}:
            assert Integer(0) not in operands
        if expression.operator == "mul":
            assert not {Integer(0), Integer(1), Integer(-1)} & set(operands)
        if expression.operator == "neg":
            assert not isinstance(operands[0], Integer)
            assert not (isinstance(operands[0], Apply) and operands[0].operator == "neg")
        if expression.operator in {"add", "sub", "mul"}:
            names = {c.name for c in program.constants}
            assert not all(isinstance(o, Variable) and o.name in names for o in operands)


def test_a_value_is_computed_once() -> None:
    builder = Builder()
    x, y = builder.pose(1, 1), builder.pose(1, 2)
    one, other = builder.mul(x, y), builder.mul(y, x)
    assert one == other
    program = builder.finish("t", {"q1": builder.add(one, x), "q2": builder.add(other, y)}, [])
    products = [e for e in expressions(program) if isinstance(e, Apply) and e.operator == "mul"]
    assert len(products) == 1


def test_what_only_a_deeper_loop_uses_is_computed_outside_of_it() -> None:
    builder = Builder()
    sign = builder.sign(("left", "right"), 1)
    outside = builder.add(builder.pose(1, 1), builder.pose(1, 2))
    program = builder.finish("t", {"q1": builder.mul(sign, outside)}, [])
    lets = [(s.expression, s.axes) for s in program.body if isinstance(s, Let)]
    assert [axes for expression, axes in lets if expression.operator == "add"] == [()]  # type: ignore[union-attr]


def test_what_nothing_needs_is_left_out() -> None:
    builder = Builder()
    builder.name(builder.add(builder.pose(1, 1), builder.pose(2, 2)), "unused")
    builder.constant("also_unused", 1.5, "a test")
    program = builder.finish("t", {"q1": builder.pose(3, 3)}, [])
    assert (program.body, program.constants) == ((), ())


def test_a_constant_that_is_a_result_itself_is_kept() -> None:
    builder = Builder()
    program = builder.finish("t", {"q1": builder.constant("height", 0.3, "a test")}, [])
    assert [c.name for c in program.constants] == ["height"]
    assert value(program) == 0.3


def test_formulas_of_constants_are_readable() -> None:
    builder = Builder()
    a, b = (
        builder.constant(name, length, "a test", 1) for name, length in (("a", 2.0), ("b", 3.0))
    )
    square = builder.add(builder.square(a), builder.square(b))
    factor = builder.div(builder.integer(1), builder.mul(builder.integer(2), builder.mul(a, b)))
    results = {
        "q1": builder.mul(builder.pose(1, 1), square),
        "q2": builder.mul(factor, builder.pose(1, 2)),
    }
    program = builder.finish("t", results, [])
    told = [(c.name, c.value, c.meaning, c.power) for c in program.constants]
    assert told == [("k1", 13.0, "a^2 + b^2", 2), ("k2", 1 / 12, "1 / (2 * a * b)", -2)]


@pytest.mark.parametrize("sign", [1, -1])
def test_a_constant_divisor_becomes_a_factor(sign: int) -> None:
    builder = Builder()
    length = builder.constant("a", 2.0, "a test", 1)
    divisor = length if sign > 0 else builder.neg(length)
    program = builder.finish("t", {"q1": builder.div(builder.pose(1, 4), divisor)}, [])
    assert [(c.name, c.value, c.power) for c in program.constants] == [("k1", sign / 2, -1)]
    assert count_operations(program).divisions == 0


def test_guards_keep_only_choices_that_matter() -> None:
    builder = Builder()
    margin = builder.sub(builder.pose(1, 4), builder.apply("cos", builder.seed(2)))
    flags = [
        (joint, builder.apply("at_most", builder.pose(joint, joint), builder.integer(0)))
        for joint in (1, 2)
    ]
    inside = builder.apply("at_most", builder.integer(0), margin)
    options = [Option(joint, flag) for joint, flag in flags]
    builder.guard(inside, Failure.REACH, margin, options)
    program = builder.finish("t", {"q1": builder.pose(1, 1)}, flags)
    (guard,) = [s for s in program.body if type(s).__name__ == "Guard"]
    assert guard.chosen == (Choice(2, dict(program.free)[2]),)  # type: ignore[union-attr]


def test_what_a_joint_would_be_chosen_by_counts_as_needed() -> None:
    """The value of a joint that is nearly free, where nothing else names its constants."""
    builder = Builder()
    flag = builder.apply("at_most", builder.pose(1, 1), builder.integer(0))
    near = builder.mul(builder.constant("a", 0.3, "a test"), builder.pose(2, 3))
    margin = builder.sub(builder.pose(1, 4), builder.seed(2))
    inside = builder.apply("at_most", builder.integer(0), margin)
    builder.guard(inside, Failure.REACH, margin, [Option(2, flag, near)])
    program = builder.finish("t", {"q1": builder.pose(1, 2)}, [(2, flag)])
    assert [constant.name for constant in program.constants] == ["a"]
    assert Pose(2, 3) in expressions(program)


def test_a_value_says_whether_it_has_a_name_of_its_own() -> None:
    """Its name does not: v1 may be taken by the arm, or be what somebody calls a value."""
    builder = Builder(Reserved(frozenset({"v1"})))
    numbered = builder.mul(builder.pose(1, 1), builder.pose(2, 2))
    called = builder.hint(builder.mul(builder.pose(1, 2), builder.pose(2, 1)), "v7")
    results = {"q1": builder.apply("atan2", numbered, called), "q2": builder.mul(numbered, called)}
    program = builder.finish("t", results, [])
    named = {each.name: each.named for each in program.body if isinstance(each, Let)}
    assert named == {"v1_": False, "v7": True, "q1": True, "q2": True}

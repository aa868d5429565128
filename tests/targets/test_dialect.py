"""Printed expressions mean what the program says: parsed again, they have the same value."""

from __future__ import annotations

import ast
import ctypes
import math
import subprocess
from functools import reduce
from typing import TYPE_CHECKING, Any

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from dhgen.program.interpret import interpret
from dhgen.program.ir import Apply, Integer, Pose, Program
from dhgen.targets.c.language import C
from dhgen.targets.dialect import expression_text
from dhgen.targets.layout import WIDTH, call, packed, wrapped
from dhgen.targets.python.language import Python
from dhgen.verify.native import c_compiler

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.program.ir import Expression

T = np.array([[0.5, -1.5, 3.0, 0.25], [2.0, 0.125, -7.0, 1.0], [1.0, 4.0, 0.5, -0.5], [0, 0, 0, 1]])
NAMES = {f"T{row}{column}": T[row - 1, column - 1] for row in (1, 2, 3) for column in (1, 2, 3, 4)}

Strategy = st.SearchStrategy[Any]
REALS: Strategy = st.deferred(lambda: LEAVES | OPERATIONS)
LEAVES: Strategy = st.one_of(
    st.builds(Integer, st.integers(-3, 3)),
    st.builds(Pose, st.integers(1, 3), st.integers(1, 4)),
)


def applied(operators: list[str], *operands: Strategy) -> Strategy:
    return st.builds(Apply, st.sampled_from(operators), st.tuples(*operands))


TRUTHS: Strategy = st.deferred(
    lambda: (
        applied(["less", "at_most"], REALS, REALS)
        | applied(["and", "or"], TRUTHS, TRUTHS)
        | applied(["not"], TRUTHS)
    )
)
OPERATIONS: Strategy = st.deferred(
    lambda: (
        applied(["add", "sub", "mul", "div", "maximum", "atan2"], REALS, REALS)
        | applied(["neg", "abs", "sin", "cos"], REALS)
        | applied(["select"], TRUTHS, REALS, REALS)
    )
)


def meaning(expression: Expression) -> float:
    program = Program("t", (), (), (), (expression,), ())
    return float(interpret(program, T[None]).q[0, 0, 0])


class FloatDivision(ast.NodeTransformer):
    """Division by zero as the emitted code has it, where Python would raise."""

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        self.generic_visit(node)
        if not isinstance(node.op, ast.Div):
            return node
        return ast.Call(ast.Name("divided", ast.Load()), [node.left, node.right], [])


def divided(left: float, right: float) -> float:
    with np.errstate(all="ignore"):
        return float(np.float64(left) / np.float64(right))


def same(one: float, other: float) -> bool:
    return one == other or (math.isnan(one) and math.isnan(other))


@given(REALS)
@settings(max_examples=50)
def test_python_means_the_same(expression: Expression) -> None:
    text = expression_text(expression, Python())
    tree = ast.fix_missing_locations(FloatDivision().visit(ast.parse(text, mode="eval")))
    functions = {"math": Safe, "_atan2": math.atan2, "divided": divided}
    got = eval(compile(tree, "printed", "eval"), NAMES | functions)  # noqa: S307
    wanted = meaning(expression)
    assert (
        same(got, wanted) or math.isclose(got, wanted, rel_tol=1e-14) or not math.isfinite(wanted)
    )


class Safe:
    """math with the values that floating point has for infinite angles."""

    @staticmethod
    def sin(x: float) -> float:
        return math.sin(x) if math.isfinite(x) else math.nan

    @staticmethod
    def cos(x: float) -> float:
        return math.cos(x) if math.isfinite(x) else math.nan


@given(REALS)
@settings(max_examples=50)
def test_no_parentheses_without_need(expression: Expression) -> None:
    """Python's own printer of its syntax tree, which writes only what it needs, writes no fewer.

    Conditions are left aside: a choice shows its condition in parentheses for the reader.
    """
    text = expression_text(expression, Python())
    if " if " not in text and "-(-" not in text:  # which C needs
        least = ast.unparse(ast.parse(text, mode="eval"))
        assert text.count("(") <= least.count("(")


def test_many_conditions_are_printed_once_each() -> None:
    """An arm's doubts are one disjunction; printing parts of parts twice would never end."""
    flag: Expression = Apply("less", (Pose(1, 4), Integer(0)))
    whole = reduce(lambda left, right: Apply("or", (left, right)), [flag] * 60)
    assert expression_text(whole, Python()).count(" < 0.0") == 60


def test_c_means_the_same(tmp_path: Path) -> None:
    """Many expressions in one file, compiled as C99 with warnings as errors."""
    found: list[Any] = []

    @given(REALS)
    @settings(max_examples=50, database=None)
    def collect(expression: Expression) -> None:
        found.append(expression)

    collect()
    texts = [expression_text(expression, C()) for expression in found]
    entries = ", ".join(NAMES)
    lines = ["#include <math.h>", f"void all(const double *T, double *out) {{ double {entries};"]
    lines += [f"{name} = T[{place}];" for place, name in enumerate(NAMES)]
    lines += [f"out[{place}] = {text};" for place, text in enumerate(texts)]
    lines += [f"(void){name};" for name in NAMES]
    (tmp_path / "all.c").write_text("\n".join([*lines, "}"]))
    compiler = c_compiler()
    assert compiler is not None
    library = tmp_path / "all.so"
    command = [compiler, "-std=c99", "-O0", "-Werror", "-shared", "-fPIC", str(tmp_path / "all.c")]
    subprocess.run([*command, "-o", str(library), "-lm"], check=True)
    out, entries_of_T = np.empty(len(texts)), np.ascontiguousarray(T[:3]).ravel()
    pointer = ctypes.c_void_p
    ctypes.CDLL(str(library)).all(entries_of_T.ctypes.data_as(pointer), out.ctypes.data_as(pointer))
    for expression, text, got in zip(found, texts, out, strict=True):
        wanted = meaning(expression)
        if math.isfinite(wanted):
            assert math.isclose(got, wanted, rel_tol=1e-13, abs_tol=1e-13), text


@given(st.lists(st.text("abc+-", min_size=1, max_size=30), min_size=1, max_size=30))
def test_pieces_are_packed_whole(pieces: list[str]) -> None:
    lines = packed(pieces, "    ")
    assert " ".join(lines).split() == pieces
    assert all(len(line) <= WIDTH for line in lines)


@given(st.lists(st.text("abcxyz", min_size=1, max_size=20), min_size=1, max_size=12))
def test_calls_are_broken_between_arguments(names: list[str]) -> None:
    arguments = [f"double {name}" for name in names]
    text = call("void f", arguments, ";")
    inner = text.removeprefix("void f(").removesuffix(");")
    assert [" ".join(each.split()) for each in inner.split(",")] == arguments
    assert all(len(line) <= WIDTH for line in text.splitlines())


def test_long_statements_are_broken_at_spaces() -> None:
    line = "    const double x = " + " + ".join(["abcdefgh * ijklmnop"] * 12) + ";"
    lines = wrapped(line, "    ")
    assert len(lines) > 2
    assert " ".join(" ".join(lines).split()) == " ".join(line.split())
    assert all(len(each) <= WIDTH for each in lines)

"""Cells: what they may say, exactly, and where they go wrong."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhgen.robot.arithmetic import parse
from dhgen.robot.expression import (
    DEGREE,
    Binary,
    Call,
    Expression,
    Name,
    Negate,
    Number,
    Pi,
    evaluate,
    to_text,
)
from dhgen.robot.source import Span
from dhgen.robot.tokens import CellError

if TYPE_CHECKING:
    from collections.abc import Mapping

VALUES = {"a2": 0.4318, "zero": 0.0, "l": 2.0}


def number(text: str) -> Number:
    return Number(Fraction(text))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("0.1", number("0.1")),
        ("1e-3", number("0.001")),
        (".5", number("0.5")),
        ("10.", number("10")),
        ("0.4318", Number(Fraction(4318, 10000))),
        ("123456789012345678901234567.5", number("123456789012345678901234567.5")),
        ("-pi/2", Binary("/", Negate(Pi()), number("2"))),
        ("+a2", Name("a2")),
        ("10 deg", Binary("*", number("10"), DEGREE)),
        ("-1.5e1 deg", Binary("*", Negate(number("15")), DEGREE)),
        ("10  deg", Binary("*", number("10"), DEGREE)),
        ("10*deg", Binary("*", number("10"), DEGREE)),
        ("deg", DEGREE),
        ("l**2", Binary("**", Name("l"), number("2"))),
        ("l**-2", Binary("**", Name("l"), Negate(number("2")))),
        ("sqrt(2)/2", Binary("/", Call("sqrt", number("2")), number("2"))),
        ("  1 - (a2 - l)", Binary("-", number("1"), Binary("-", Name("a2"), Name("l")))),
    ],
)
def test_what_a_cell_says(text: str, expected: Expression) -> None:
    assert parse(text, VALUES) == expected


@pytest.mark.parametrize(
    ("text", "at", "message"),
    [
        ("9**9**9", "9**9", "an exponent must be a whole number from -8 to 8"),
        ("l**9", "9", "an exponent must be a whole number from -8 to 8"),
        ("l**-9", "-9", "an exponent must be a whole number from -8 to 8"),
        ("l**0.5", "0.5", "an exponent must be a whole number from -8 to 8"),
        ("l**a2", "a2", "an exponent must be a whole number from -8 to 8"),
        ("((l**8)**8)**8", "((l**8)**8)**8", "this multiplies more than 64 factors"),
        ("a2.real", ".", "'.' (U+002E) is not allowed in a cell"),
        ("'a'", "'", '"\'" (U+0027) is not allowed in a cell'),
        ("[1]", "[", "'[' (U+005B) is not allowed in a cell"),
        ("(x:=1)", ":", "':' (U+003A) is not allowed in a cell"),
        ("lambda: 1", ":", "':' (U+003A) is not allowed in a cell"),
        ("1 % 2", "%", "'%' (U+0025) is not allowed in a cell"),
        ("1, 2", ",", "',' (U+002C) is not allowed in a cell"),
        ("0,4", ",", "',' (U+002C) is not allowed in a cell: write '.'"),
        ("sin(1, 2)", ",", "',' (U+002C) is not allowed in a cell: allowed are"),
        (".inf", ".inf", "'.inf' is not a finite number"),
        ("-.NaN", ".NaN", "'.NaN' is not a finite number"),
        ("1\n+ 2", "\n", "'�' (U+000A) is not allowed in a cell"),
        ("−1", "−", "'−' (U+2212) is not allowed in a cell: write '-'"),
        ("90°", "°", "'°' (U+00B0) is not allowed in a cell: write ' deg'"),
        ("l^2", "^", "'^' (U+005E) is not allowed in a cell: write '**'"),
        ("ρ", "ρ", "'ρ' (U+03C1) is not allowed in a cell"),
        ("ｐｉ", "ｐ", "'ｐ' (U+FF50) is not allowed in a cell"),  # Python's own parser reads pi
        ("1j", "1j", "'1j' is not a number; write * between factors"),
        ("1_000", "1_000", "'1_000' is not a number; numbers are decimal, without underscores"),
        ("1_0.5", "1_0", "'1_0' is not a number; numbers are decimal, without underscores"),
        ("1.5_0e3", "1.5_0e3", "'1.5_0e3' is not a number; numbers are decimal, without under"),
        ("1e1_0", "1e1_0", "'1e1_0' is not a number; numbers are decimal, without underscores"),
        ("-0x10", "0x10", "'0x10' is not a number; numbers are decimal, without underscores"),
        ("0XfF", "0XfF", "'0XfF' is not a number; numbers are decimal, without underscores"),
        ("0b101", "0b101", "'0b101' is not a number; numbers are decimal, without underscores"),
        ("0o17", "0o17", "'0o17' is not a number; numbers are decimal, without underscores"),
        ("2_a", "2_a", "'2_a' is not a number; write * between factors"),
        ("10deg", "10deg", "'10deg' is not a number; write '10 deg'"),
        ("2a2", "2a2", "'2a2' is not a number; write * between factors"),
        ("007", "007", "a number can't start with 0"),
        ("1e999999999", "1e999999999", "a decimal exponent must be a whole number from -30 to 30"),
        ("1e-31", "1e-31", "a decimal exponent must be a whole number from -30 to 30"),
        ("9" * 31, "9" * 31, "a number has at most 30 digits"),
        ("1+" * 100 + "1", "1+" * 100, "a cell has at most 200 characters"),
        ("-" * 100 + "1", "-" * 35 + "1", "nested more than 64 deep"),
        ("inch", "inch", "unknown name 'inch'; valid: a2, zero, l, pi, deg, sqrt, sin, cos"),
        ("inf", "inf", "'inf' is not a finite number"),
        ("1 - NaN", "NaN", "'NaN' is not a finite number"),
        ("false", "false", "'false' is not a number"),
        ("zreo", "zreo", "unknown name 'zreo'; did you mean 'zero'?"),
        ("q", "q", "the variable q is only allowed in theta or d of a joint"),
        ("True", "True", "not valid arithmetic"),
        ("None", "None", "not valid arithmetic"),
        ("1 if l else 2", "1 if l else 2", "not valid arithmetic"),
        ("l and l", "l and l", "not valid arithmetic"),
        ("not l", "not l", "not valid arithmetic"),
        ("1 + (yield)", "yield", "not valid arithmetic"),
        ("l // 2", "l // 2", "not valid arithmetic"),
        ("2(3)", "2(3)", "not valid arithmetic"),
        ("sin(*l)", "*l", "not valid arithmetic"),
        ("print(1)", "print", "unknown function 'print'; valid: sqrt, sin, cos"),
        ("squrt(1)", "squrt", "unknown function 'squrt'; did you mean 'sqrt'?"),
        ("sqrt", "sqrt", "sqrt needs an argument: sqrt(...)"),
        ("sqrt()", "sqrt()", "sqrt takes one argument"),
        ("sqrt(**l)", "sqrt(**l)", "sqrt takes one argument"),
        ("1/zero", "1/zero", "division by zero"),
        ("2*(l/(l-l))", "l/(l-l)", "division by zero"),
        ("zero**-1", "zero**-1", "division by zero"),
        ("1 + sqrt(-l)", "sqrt(-l)", "square root of a negative number (-2)"),
        ("1e30**8*1e30**8", "1e30**8*1e30**8", "the value is too large"),
        ("", "", "an empty cell: write 0"),
        ("  ", " ", "an empty cell: write 0"),
    ],
)
def test_refused_cells_say_where(text: str, at: str, message: str) -> None:
    with pytest.raises(CellError) as info:
        parse(text, VALUES)
    span = info.value.span
    assert text[span.start : span.start + span.width] == at
    assert info.value.message.startswith(message)


@pytest.mark.parametrize(
    ("text", "at"), [("1 +", 2), ("(1", 0), ("1)", 1), ("1 l", 2), ("**2", 0), ("l deg", 2)]
)
def test_broken_arithmetic_says_where(text: str, at: int) -> None:
    with pytest.raises(CellError, match="an operand or an operator is missing") as info:
        parse(text, VALUES)
    assert info.value.span.start == at


@pytest.mark.parametrize("text", ["l_in +", "d_or *", "not_a b", "in_ +", "is2 *"])
def test_part_of_a_name_is_no_keyword(text: str) -> None:
    names = dict.fromkeys(("l_in", "d_or", "not_a", "b", "in_", "is2"), 1.0)
    with pytest.raises(CellError, match="an operand or an operator is missing"):
        parse(text, names)


def test_a_keyword_is_shown_where_it_stands() -> None:
    with pytest.raises(CellError, match="'is' is a keyword of Python, no name") as info:
        parse("2*this + is", {"this": 1.0})
    assert info.value.span == Span(len("2*this + "), 2)


def test_unknown_values_entail_no_further_mistakes() -> None:
    unknown = {"a": math.nan}
    for text in ("1/a", "sqrt(a - 1)", "1/(a - a)", "a**-2", "sin(a)"):
        assert math.isnan(evaluate(parse(text, unknown), unknown))


NUMBERS = st.builds(
    lambda digits, places: Number(Fraction(digits, 10**places)),
    st.integers(0, 10**12),
    st.integers(0, 12),
)
EXPONENTS = st.integers(0, 8).map(lambda n: Number(Fraction(n)))
LEAVES = NUMBERS | st.just(Pi()) | st.sampled_from([Name("x"), Name("y1")])


def _compound(inner: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
    return (
        st.builds(Negate, inner)
        | st.builds(Binary, st.sampled_from(["+", "-", "*", "/"]), inner, inner)
        | st.builds(Binary, st.just("**"), LEAVES, EXPONENTS | EXPONENTS.map(Negate))
        | st.builds(Call, st.sampled_from(["sqrt", "sin", "cos"]), inner)
    )


EXPRESSIONS = st.recursive(LEAVES, _compound, max_leaves=6)


def outcome(text: str, values: Mapping[str, float]) -> Expression | CellError:
    """What a text says, or why it says nothing."""
    try:
        return parse(text, values)
    except CellError as error:
        return error


# Values that are no numbers keep most divisions by zero out of the following.
NAMES = {"x": math.nan, "y1": math.nan}


@given(EXPRESSIONS)
def test_printing_and_parsing_give_the_expression_back(expression: Expression) -> None:
    parsed = outcome(to_text(expression), NAMES)
    if isinstance(parsed, CellError):
        bounds = ("division", "square root", "the value is too large", "more than 64 factors")
        assert parsed.message.startswith(bounds) or "at most" in parsed.message
    else:
        assert parsed == expression


@given(EXPRESSIONS)
def test_no_pair_of_parentheses_is_needless(expression: Expression) -> None:
    text = to_text(expression)
    for start, end in _pairs(text):
        if start and text[start - 1].isalpha():
            continue  # those of a function
        without = text[:start] + text[start + 1 : end] + text[end + 1 :]
        assert outcome(without, NAMES) != expression


def _pairs(text: str) -> list[tuple[int, int]]:
    opened, pairs = [], []
    for place, character in enumerate(text):
        if character == "(":
            opened.append(place)
        elif character == ")":
            pairs.append((opened.pop(), place))
    return pairs


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (Number(Fraction(1, 3)), "1/3"),
        (Negate(Number(Fraction(1, 3))), "-(1/3)"),
        (Number(Fraction(-1, 4)), "-0.25"),
        (Binary("-", Pi(), Number(Fraction(-1, 3))), "pi - -1/3"),
        (Binary("/", Pi(), Number(Fraction(1, 3))), "pi/(1/3)"),
        (Number(Fraction(1, 10**12)), "0.000000000001"),
        (Number(Fraction(1200)), "1200"),
        (Binary("**", Negate(Pi()), Number(Fraction(2))), "(-pi)**2"),
    ],
)
def test_numbers_print_exactly(expression: Expression, text: str) -> None:
    assert to_text(expression) == text


@given(st.text(max_size=60))
def test_any_text_is_an_expression_or_a_mistake_in_it(text: str) -> None:
    found = outcome(text, VALUES)
    assert not isinstance(found, CellError) or 0 <= found.span.start <= len(text)


@given(st.text(alphabet="0123456789.e+-*/() lpidegsqrt", max_size=40))
def test_what_looks_like_arithmetic_has_a_finite_value_or_a_mistake(text: str) -> None:
    found = outcome(text, VALUES)
    assert isinstance(found, CellError) or math.isfinite(evaluate(found, VALUES))

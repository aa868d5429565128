"""Long formulas: no line ends inside a bracket, and all lines together are the formula."""

from __future__ import annotations

import math
import re
from fractions import Fraction
from itertools import pairwise

import pytest

from dhgen.derivation.document import document_blocks
from dhgen.derivation.text.blocks import Display, unfolded
from dhgen.derivation.text.formula import (
    Formula,
    Number,
    Quotient,
    Relation,
    Sum,
    Symbol,
    add,
    equal,
    minus,
    over,
    square,
    subtract,
    times,
)
from dhgen.derivation.text.lines import laid_out, terms_within, width
from dhgen.derivation.text.style import LATEX, PLAIN, Style
from tests.derivation.stories import ALL_WHOLE, EACH, WHOLE, WITH_STEPS, document, story
from tests.derivation.values import evaluate

LETTERS = tuple(Symbol(f"x_{{{i}}}", f"x{i}") for i in range(30))
VALUES = {letter.text: 0.3 + 0.7 * place for place, letter in enumerate(LETTERS)}
ROOT = Symbol(r"\sqrt{3}", "√3")
A, B, C, D, *MANY = LETTERS
LONG = add(*(times(x, y) for x, y in pairwise(MANY)))
HALF = over(ROOT, Number(Fraction(2)))

BRACKETS = {
    "a sum in a product": times(A, LONG),
    "a sum of negative terms": times(A, minus(LONG)),
    "a sum before a function": times(LONG, Symbol(r"\cos \alpha_2", "cos α₂")),
    "sums in sums": times(A, subtract(times(B, LONG), times(C, add(D, times(B, LONG))))),
    "a sum over a letter": over(subtract(times(A, LONG), D), B),
    "a sum in a fraction's product": times(C, over(LONG, B), D),
    "roots and fractions": times(ROOT, A, add(*(times(HALF, x) for x in MANY))),
    "a product of sums": times(add(A, B), LONG),
    "a square": add(square(add(A, B)), times(C, LONG)),
}


def unbalanced(line: str) -> bool:
    """Whether a line opens a bracket that it does not close, or the other way round."""
    left, right = line.count(r"\left("), line.count(r"\right)")
    depth = 0
    for bracket in re.findall(r"[()]", line):
        depth += 1 if bracket == "(" else -1
        if depth < 0:
            return True
    return depth != 0 or left != right


def lines_of(relation: Formula, style: Style) -> list[str]:
    """The lines of a relation."""
    return [f"{left} {right}" for left, right in laid_out((relation,), style)]


@pytest.mark.parametrize("style", [LATEX, PLAIN], ids=["latex", "plain"])
@pytest.mark.parametrize("name", BRACKETS)
def test_no_line_ends_inside_a_bracket(name: str, style: Style) -> None:
    for relation in (equal(A, BRACKETS[name]), equal(BRACKETS[name], A)):
        lines = lines_of(relation, style)
        assert len(lines) > 1
        assert not any(map(unbalanced, lines)), lines
        assert all(len(line) <= 112 for line in lines_of(relation, PLAIN)), lines


@pytest.mark.parametrize("name", BRACKETS)
def test_the_terms_of_a_line_are_worth_the_bracket(name: str) -> None:
    values = {**VALUES, "√3": 3.0**0.5, "cos α₂": 0.8}
    whole = BRACKETS[name]
    terms = terms_within(whole, 96)
    assert len(terms) > 1
    assert all(width(term) <= 100 for term in terms)
    total = sum(evaluate(term, values) for term in terms)
    assert total == pytest.approx(evaluate(whole, values), rel=1e-12)


def test_signs_stand_before_a_bracket_and_numbers_before_letters() -> None:
    parts = terms_within(times(A, add(*(times(HALF, minus(x)) for x in MANY))), 60)
    shown = " ".join(" ".join(lines_of(part, LATEX)) for part in parts)
    assert "(-" not in shown
    *lines, _ = lines_of(times(A, ROOT, add(times(HALF, B, LONG), C)), LATEX)
    assert lines
    for line in lines:
        assert line.lstrip(r" \quad+").startswith(r"frac{3}{2} x_{0} x_{1} ("), line


def test_what_has_no_plus_or_minus_outside_stays_whole() -> None:
    whole = square(LONG)
    assert terms_within(whole, 40) == (whole,)
    assert terms_within(times(A, whole), 40) == (times(A, whole),)


@pytest.mark.parametrize("name", [*EACH, *WHOLE])
def test_all_lines_of_a_derivation_are_worth_its_formulas(name: str) -> None:
    """Each side is compared at letters that are numbers chosen here, not an arm's."""
    sides = [
        side
        for block in unfolded(document_blocks(story(name)))
        if isinstance(block, Display)
        for formula in block.formulas
        if isinstance(formula, Relation)
        for side in formula.sides
        if isinstance(side, Sum | Quotient) or width(side) > 50
    ]
    for side in sides:
        values = Numbers()
        try:
            expected = evaluate(side, values)
        except KeyError:
            continue
        total = sum(evaluate(term, values) for term in terms_within(side, 46))
        assert total == pytest.approx(expected, rel=1e-9, abs=1e-9)


class Numbers(dict[str, float]):
    """A number for every letter."""

    def __missing__(self, text: str) -> float:
        """A root is worth itself; any other letter something between 0.5 and 1.5."""
        digits = text.removeprefix("√")
        if digits != text and digits.isdigit():
            return math.sqrt(int(digits))
        return 0.5 + sum((place + 3) * ord(each) for place, each in enumerate(text)) % 97 / 97


@pytest.mark.parametrize("name", [*EACH, *WHOLE])
def test_no_line_of_a_derivation_ends_inside_a_bracket(name: str) -> None:
    for block in unfolded(document_blocks(story(name))):
        if isinstance(block, Display):
            for left, right in laid_out(block.formulas, LATEX):
                assert not unbalanced(left + right), right


@pytest.mark.parametrize("name", [*WITH_STEPS, *ALL_WHOLE])
def test_no_line_of_a_document_ends_inside_a_bracket(name: str) -> None:
    for shown in re.findall(r"```math\n(.*?)\n```", document(name), re.DOTALL):
        for line in shown.split("\n"):
            assert not unbalanced(line), line

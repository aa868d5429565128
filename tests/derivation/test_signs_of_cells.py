"""Signs of what is added to joint variables, in tables, formulas, and the way back."""

from __future__ import annotations

import math
import re
from fractions import Fraction

import pytest

from dhgen.derivation.formats import derivation_as
from dhgen.derivation.languages import ENGLISH
from dhgen.derivation.notation.expressions import expression_symbol, variable_symbol
from dhgen.robot.expression import Binary, Name, Negate, Number
from tests.derivation.made import made_of
from tests.derivation.reading import name_of, of_latex, relations_in, worth
from tests.derivation.stories import story_of
from tests.kinematics.values import table

REST = {"parameters": "{l1: 0.5, l2: 0.35, ratio: 0.25, o: 0.1}", "task": "[x, y, yaw]"}
VALUES = {"l1": 0.5, "l2": 0.35, "ratio": 0.25, "o": 0.1, "pi": math.pi, "deg": math.pi / 180.0}
CELLS = (
    ("q - pi/3", "q - q1 - pi/2", "q - 90 deg - q2"),
    ("-q - pi/3", "q - pi/2 - q1", "-q2 - q + pi/4"),
    ("q + o - pi/2", "q - (1 - ratio)*q1 - pi/2 - o", "pi - q - 2*q2 - (o - 0.2)"),
    ("-pi/2 + q - 0.3", "q - 1/2*q1 + -90 deg", "q - q1 - 0.5*q2 - 3*pi/4"),
    ("q - o*pi/2", "-q - o + q1 - o", "-pi/2*o - q - q1"),
)
Q = {"q1": 0.3, "q2": -1.1, "q3": 0.7}
TWO_SIGNS = re.compile(r"[-+−] ?[-−]|[-−] \+")


def rows_of(cells: tuple[str, ...]) -> list[str]:
    return [f"theta: {cell}, a: {a}" for cell, a in zip(cells, ("l1", "l2", "0.1"), strict=True)]


def angles_of(cells: tuple[str, ...]) -> dict[str, float]:
    """What the cells are worth, as Python reads them."""
    own = (re.sub(r"\bq\b", f"q{number}", cell) for number, cell in enumerate(cells, start=1))
    python = (re.sub(r"(\d+) deg", r"(\1*deg)", cell) for cell in own)
    return {f"θ_{n}": eval(each, {}, VALUES | Q) for n, each in enumerate(python, start=1)}  # noqa: S307


@pytest.mark.parametrize("cells", CELLS)
def test_angles_and_the_way_back_are_worth_what_the_cells_say(cells: tuple[str, ...]) -> None:
    text = made_of(*rows_of(cells), **REST).partition("## An example")[0]
    letters = angles_of(cells) | {f"q_{name[1]}": value for name, value in Q.items()}
    letters |= {name: VALUES[name] for name in ("ratio", "o")} | {"π": math.pi}
    seen: set[str] = set()
    shown = re.findall(r"\$([^$]+)\$|```math\n(.*?)\n```", text, re.DOTALL)
    for formula in (each for inline, block in shown for each in (inline or block).split("\n")):
        for sides, _ in _relations(formula.replace("&", "").removesuffix(r"\\")):
            name = name_of(sides[0])
            if name in letters and name[0] in "θq" and len(sides) == 2:
                try:
                    value = worth(sides[1], letters.__getitem__)
                except KeyError:
                    continue
                assert value == pytest.approx(letters[name]), formula
                seen.add(name)
    assert seen >= {f"θ_{n}" for n in (1, 2, 3)} | {f"q_{n}" for n in (1, 2, 3)}


def _relations(formula: str) -> list[tuple[list[list[tuple[object, ...]]], list[str]]]:
    return (
        list(relations_in(of_latex(formula))) if "=" in formula and "begin" not in formula else []
    )


@pytest.mark.parametrize("form", ["text", "markdown", "latex", "html"])
def test_no_two_signs_stand_side_by_side(form: str) -> None:
    for cells in CELLS:
        of = story_of(table(*rows_of(cells), **REST))
        text, *_ = derivation_as(form, of, "robots/r.yaml", ENGLISH)
        told = [line for line in text.splitlines() if "q" in line and "---" not in line]
        assert told
        assert [line for line in told if TWO_SIGNS.search(line)] == []


def test_a_cell_keeps_its_parentheses_and_loses_double_signs() -> None:
    pi_half = Binary("/", Negate(Name("a")), Number(Fraction(2)))
    assert expression_symbol(Binary("+", Name("b"), pi_half)).text == "b − a/2"
    assert expression_symbol(Binary("-", Name("b"), pi_half)).text == "b + a/2"
    assert expression_symbol(Negate(pi_half)).text == "a/2"
    total = Binary("-", Negate(Name("a")), Name("b"))
    assert expression_symbol(Binary("-", Name("e"), total)).text == "e − (−a − b)"
    assert variable_symbol(2, 1, total).text == "q₂ − a − b"
    assert variable_symbol(2, -1, pi_half).text == "−q₂ − a/2"

"""What a file says that its constants are made of is what they are: read from the text itself."""

from __future__ import annotations

import math
import re
from itertools import pairwise
from pathlib import Path

import pytest

GENERATED = Path(__file__).parents[2] / "generated"
CONSTANT = re.compile(
    r"(?P<before>/\*(?:[^*]|\*[^/])*\*/\s*)?"
    r"\b(?P<name>\w+) = (?P<value>-?\d[\d.e+-]*)[,;](?P<behind> /\*(?:[^*]|\*[^/])*\*/)?"
)
# A name, what it is made of if that is told, and its value.
PART = re.compile(r"(\w+) = (?:([^=]+) = )??(-?\d[\d.e+-]*)(?: \[[^]]*\])?(?:,|$)")
# What formulas name and no code needs.
NO_CODE = re.compile(r"/\* In formulas below, (.*?)\. \*/", re.DOTALL)
# What one function alone names.
INSIDE = re.compile(r"^ +static const double[^;]*;", re.MULTILINE)
UNIT = re.compile(r"\[[^]]*\]")
ARITHMETIC = re.compile(r"[\w\s.,+*/()^-]+")
FUNCTIONS = {name: getattr(math, name) for name in ("sqrt", "sin", "cos", "tan", "atan2")}
EPSILON = math.ulp(1.0)


def constants(text: str) -> dict[str, tuple[float, str]]:
    """Values and comments of the constants of a C file."""
    found = {}
    for block in re.findall(r"static const double\s[^{}]*?;(?: /\*[^\n]*\*/)?", text):
        for each in CONSTANT.finditer(block):
            comment = each["behind"] or each["before"] or ""
            told = " ".join(
                re.sub(r"^ +\* ", "", comment, flags=re.MULTILINE).strip("/* \n").split()
            )
            found[each["name"]] = float(each["value"]), UNIT.sub("", told).strip()
    for parts in NO_CODE.findall(text):
        for name, made, value in PART.findall(parts):
            known, formula = found.get(name, (float(value), made))
            assert known == float(value), name
            found[name] = known, formula
    return found


def words(formula: str) -> set[str]:
    """The constants that a formula names."""
    return set(re.findall(r"[A-Za-z_]\w*", formula)) - FUNCTIONS.keys() - {"pi"}


def is_prose(comment: str) -> bool:
    """Whether words stand side by side, not names and operators in turn."""
    return not ARITHMETIC.fullmatch(comment) or bool(re.search(r"[a-z]\w* +[a-z]", comment))


def is_formula(comment: str) -> bool:
    """Whether something is calculated."""
    return not is_prose(comment) and bool(re.search(r"[*/^+]| - |\w\(", comment))


def sizes(formula: str, values: dict[str, float]) -> tuple[float, float] | None:
    """A formula's value, and what it would be if nothing cancelled; None for words."""
    if not is_formula(formula):
        return None
    code = formula.replace("^", "**")
    value = eval(code, {}, {**FUNCTIONS, "pi": math.pi, **values})  # noqa: S307  our own file
    whole = re.sub(r"(?<!e)-", "+", code)
    absolute = {name: abs(number) for name, number in values.items()}
    return value, abs(eval(whole, {}, {**FUNCTIONS, "pi": math.pi, **absolute}))  # noqa: S307


@pytest.mark.parametrize("path", sorted(GENERATED.glob("*.c")), ids=lambda path: path.stem)
def test_constants_are_what_their_formulas_say(path: Path) -> None:
    told = constants(path.read_text())
    values = {name: value for name, (value, _) in told.items()}
    exact = 2.0**-23 if path.stem.endswith("_f32") else EPSILON
    for name, (value, comment) in told.items():
        found = sizes(comment, values)
        if found is not None:
            formula, most = found
            assert abs(formula - value) <= 64.0 * exact * most, (name, comment, formula, value)


def test_every_constant_says_what_it_is() -> None:
    in_c = [
        (path.name, name)
        for path in GENERATED.glob("*.c")
        if not path.name.startswith("dhgen_")
        for text in [INSIDE.sub("", NO_CODE.sub("", path.read_text()))]
        for name, (_, comment) in constants(text).items()
        if not comment
    ]
    in_python = [
        (path.name, line)
        for path in GENERATED.glob("*.py")
        for before, line in pairwise(path.read_text("utf-8").splitlines())
        if re.fullmatch(r"[a-z]\w* = -?\d[\d.e+-]*", line) and not before.startswith("#")
    ]
    assert [*in_c, *in_python] == []


def test_folded_numbers_of_regular_poses_have_formulas() -> None:
    """m4 = ... /* k4 * (d4 * k1 + a3 * k2) */, turn1 = ... /* atan2(k1, k2) */ as well."""
    silent = [
        (path.stem, name, comment)
        for path in GENERATED.glob("*.c")
        for name, (_, comment) in constants(path.read_text()).items()
        if re.fullmatch(r"([km]|turn)\d+", name) and is_prose(comment)
    ]
    assert silent == []


def test_what_a_formula_names_is_told() -> None:
    """Also numbers that no code needs: doubt_limit1 of doubt_limit1^2."""
    unknown = [
        (path.stem, name, comment)
        for path in GENERATED.glob("*.c")
        for told in [constants(path.read_text())]
        for name, (_, comment) in told.items()
        if is_formula(comment) and not words(comment) <= told.keys()
    ]
    assert unknown == []

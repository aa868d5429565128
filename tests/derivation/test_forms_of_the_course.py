"""What documents say of the courses' formulas: put into the equations of the types they hold."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from dhgen.derivation.sections.types_table import (
    TYPE_2,
    TYPE_2_BY_ANGLES,
    TYPE_8,
    TYPE_8_BY_HALF_ANGLE,
    TYPE_8_BY_TRIANGLE,
)
from tests.derivation.stories import document

RNG = np.random.default_rng(5)


def worth(formula: str, **letters: float) -> float:
    """The right side of a formula as a terminal prints it."""
    right = formula.split("=", 1)[1]
    right = re.sub(r"√", "sqrt", right.replace("²", "**2").replace("−", "-"))
    right = re.sub(r"(?<=[\w₁₂ᵢ)]) (?=[A-Zε√cs(0-9])", "*", right.strip())
    right = right.translate(str.maketrans("₁₂ᵢⱼ", "12ij"))
    return float(eval(right, {"sqrt": math.sqrt, **letters}))  # noqa: S307  our own text


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_type_2(sign: float) -> None:
    for X, Y, share in RNG.uniform(-1.0, 1.0, (20, 3)):
        Z = share * math.hypot(X, Y)
        s, c = (worth(each.text, X=X, Y=Y, Z=Z, εi=sign) for each in TYPE_2)
        assert math.hypot(s, c) == pytest.approx(1.0)
        assert X * s + Y * c == pytest.approx(Z)
        root = sign * math.sqrt(X * X + Y * Y - Z * Z)
        assert Y * s - X * c == pytest.approx(root)
        found = math.atan2(Y, -X) - math.atan2(Z, root)
        assert math.remainder(found - math.atan2(s, c), 2.0 * math.pi) == pytest.approx(0.0)
    assert TYPE_2_BY_ANGLES[1].text == "φ = atan2(Y, −X)"


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_type_8(sign: float) -> None:
    for X, Y, one, other in RNG.uniform(0.1, 3.0, (20, 4)):
        Z1 = X * math.cos(one) + Y * math.cos(one + other)
        Z2 = X * math.sin(one) + Y * math.sin(one + other)
        letters = {"X": X, "Y": Y, "Z1": Z1, "Z2": Z2}
        cj = worth(TYPE_8[0].text, **letters)
        letters |= {"cj": cj, "sj": sign * math.sqrt(max(1.0 - cj * cj, 0.0))}
        B1, B2 = (worth(each.text, **letters) for each in TYPE_8[3:])
        s, c = (worth(each.text, **letters, B1=B1, B2=B2) for each in TYPE_8[1:3])
        first, sum_ = math.atan2(s, c), math.atan2(s, c) + math.atan2(letters["sj"], cj)
        assert X * math.cos(first) + Y * math.cos(sum_) == pytest.approx(Z1)
        assert X * math.sin(first) + Y * math.sin(sum_) == pytest.approx(Z2)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_two_links_of_documents_002_and_000(sign: float) -> None:
    for X, Y, first, turn in RNG.uniform(0.1, 3.0, (20, 4)):
        second = sign * turn
        Z1 = X * math.cos(first) + Y * math.cos(first + second)
        Z2 = X * math.sin(first) + Y * math.sin(first + second)
        inside = TYPE_8_BY_HALF_ANGLE.text.removesuffix("))").split("√(")[1:]
        inside = [each.removesuffix("), ") for each in inside]
        far, near = (worth(f"= {each}", X=X, Y=Y, Z1=Z1, Z2=Z2) for each in inside)
        assert sign * 2.0 * math.atan2(math.sqrt(far), math.sqrt(near)) == pytest.approx(second)
        cosine = worth(TYPE_8_BY_TRIANGLE[2].text, X=X, Y=Y, Z1=Z1, Z2=Z2)
        found = math.atan2(Z2, Z1) - sign * math.acos(max(-1.0, min(1.0, cosine)))
        assert math.remainder(found - first, 2.0 * math.pi) == pytest.approx(0.0, abs=1e-6)
    assert TYPE_8_BY_TRIANGLE[1].text == "α = atan2(Z₂, Z₁)"


def test_document_003_s_equations_of_the_scara_are_what_else_was_possible() -> None:
    """Its lines 1 and 2 of type 6, with x_f and y_f for the entries of column 4."""
    text = document("scara_rrp")
    lines = r"$a_2 c_2 = c_1 t_{14} + s_1 t_{24} - a_1$ and $a_2 s_2 = c_1 t_{24} - s_1 t_{14}$"
    assert lines in text


def test_they_stand_where_such_steps_are() -> None:
    assert "document 000 reads the angles off the triangle" in document("planar_rrr")
    assert "document 000" not in document("ur5")
    assert "of type 8 together" in document("planar_rr")
    assert "of type 8 together" not in document("puma560")
    assert "the solution of type 2 as" in document("spherical_offset")
    assert "the solution of type 2 as" not in document("arm_6r")

"""Local constants in C: statements of what belongs together, none wider than a page."""

from __future__ import annotations

from dhgen.targets.c.declared import Declaration, declared, dense
from dhgen.targets.layout import WIDTH


def doubles(*names: str, value: str = "x") -> list[Declaration]:
    return [Declaration("double", name, value) for name in names]


def test_a_family_is_one_statement() -> None:
    values = doubles("c1", "s1", "w1", "v1", "v2", "q1_p", "q1_m", "c12", "s12")
    assert declared(values, "") == [
        "const double c1 = x, s1 = x;",
        "const double w1 = x;",
        "const double v1 = x, v2 = x;",
        "const double q1_p = x, q1_m = x;",
        "const double c12 = x, s12 = x;",
    ]


def test_types_keep_apart() -> None:
    values = [*doubles("w1", "v1"), Declaration("int", "free1", "y"), *doubles("c1")]
    assert dense(values, "    ") == [
        "    const double w1 = x, v1 = x;",
        "    const int free1 = y;",
        "    const double c1 = x;",
    ]


def test_long_statements_are_broken_between_values() -> None:
    lines = dense(doubles(*(f"v{i}" for i in range(40)), value="a1 * b1"), "")
    assert max(map(len, lines)) <= WIDTH
    assert all(line.endswith(",") for line in lines[:-1])
    assert all(line.startswith("    v") for line in lines[1:])
    assert lines[-1].endswith(" = a1 * b1;")


def test_a_value_that_is_too_long_is_broken_itself() -> None:
    lines = declared(doubles("v1", "v2", value=" + ".join(["x0 * y0"] * 20)), "    ")
    assert max(map(len, lines)) <= WIDTH
    assert "".join(lines).count(",") == 1
    assert lines[-1].endswith(";")

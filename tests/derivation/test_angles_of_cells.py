"""Cells of a robot file as a reader knows them: degrees, roots, limits that say where rounded."""

from __future__ import annotations

import pytest

from dhgen.derivation.notation.expressions import text_symbol
from tests.derivation.made import made_of

ROWS = "theta: q + 100 deg, a: 0.4, alpha: -70 deg", "theta: q, a: 0.3"
ROUNDED = "Limits are rounded to a thousandth of a degree."


def test_degrees_are_written_as_degrees() -> None:
    text = made_of(*ROWS, task="[x, y]")
    assert r"| 1 | $q_1 + 100^\circ$ | $0$ | $0.4$ | $-70^\circ$ |" in text
    assert r"\theta_1 = q_1 + 100^\circ" in text
    assert "180" not in text.split("## Forward")[0]


@pytest.mark.parametrize("cell", ["2**2*(pi/180)", "3*w2*(pi/180)", "w2*(pi/180)", "1/3*(pi/180)"])
def test_only_a_number_of_degrees_is_written_so(cell: str) -> None:
    assert "°" not in text_symbol(cell).text


@pytest.mark.parametrize(
    ("cell", "latex"),
    [
        ("sqrt(3)", r"\sqrt{3}"),
        ("sqrt(b*b + h)/2", r"\sqrt{b b + h}/2"),
        ("sqrt(2) + sqrt((b + h)*sqrt(b))", r"\sqrt{2} + \sqrt{(b + h) \sqrt{b}}"),
    ],
)
def test_roots_are_written_as_roots(cell: str, latex: str) -> None:
    assert text_symbol(cell).latex == latex


@pytest.mark.parametrize(
    ("limits", "told", "rounded"),
    [
        ("[-6.283, 2.6529]", r"$-359.989^\circ$ to $152.0^\circ$", 1),
        ("[-166.0031 deg, 45.5 deg]", r"$-166.003^\circ$ to $45.5^\circ$", 1),
        ("[-1e-9, pi]", r"$0^\circ$ to $180^\circ$", 1),
        ("[-22.5 deg, 125.125 deg]", r"$-22.5^\circ$ to $125.125^\circ$", 0),
    ],
)
def test_limits_are_no_longer_than_they_have_to_be(limits: str, told: str, rounded: int) -> None:
    text = made_of(f"theta: q, a: 0.4, limits: {limits}", "theta: q, a: 0.3", task="[x, y]")
    assert f"| {told} |".replace(".0^", "^") in text
    assert text.count(ROUNDED) == rounded

"""Derivations of parallel robots: one meaning a letter, and the size that divides lengths."""

from __future__ import annotations

import math
import re
from itertools import combinations
from pathlib import Path

import pytest

GENERATED = Path(__file__).resolve().parents[2] / "generated"
NAMES = ["delta", "five_bar", "parallel_3rpr", "parallel_3rrr", "stewart"]
NUMBER = r"-?[\d.]+"


def text_of(name: str) -> str:
    return (GENERATED / f"{name}.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", NAMES)
def test_the_matrix_of_velocities_is_alone_with_its_letter(name: str) -> None:
    text = text_of(name)
    assert "A \\dot{x} = B \\dot{q}" in text
    assert "B_" not in text
    assert "$G_i$ is the base of leg $i$" in text


@pytest.mark.parametrize("name", NAMES)
def test_the_size_is_that_of_the_numbers_in_the_document(name: str) -> None:
    """Bases and origins are at least so far apart as it says, or their legs are larger."""
    text = text_of(name)
    (printed, made_of) = re.findall(r"robot's\s+size, \$([\d.]+)\$ m: ([^.]*)\.", text)[0]
    bases = [
        [float(row.rpartition("& ")[2]) for row in matrix.split(r"\\")[:3]]
        for matrix in re.findall(r"G_\d & = \\begin\{bmatrix\} (.*?) \\end", text)
    ]
    table = re.findall(
        rf"^\| \d .*\| \$\(({NUMBER}), ({NUMBER}), ({NUMBER})\)\$ \|$", text, re.MULTILINE
    )
    origins = [[float(each) for each in row] for row in table]
    apart = max(math.dist(*pair) for places in (bases, origins) for pair in combinations(places, 2))
    if made_of.startswith("the largest distance"):
        assert float(printed) == pytest.approx(apart, rel=1e-3)
    else:
        assert float(printed) >= apart * (1.0 - 1e-3)

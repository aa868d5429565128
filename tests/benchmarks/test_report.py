"""Tables are aligned, and go to their places and nowhere else."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from benchmarks.report import DOCUMENT, README, place, table, time_text

if TYPE_CHECKING:
    from pathlib import Path


def test_a_table_is_aligned() -> None:
    assert table(("a", "bcd"), [("xyz", "1"), ("x", "22")]).splitlines() == [
        "| a   | bcd |",
        "| --- | --: |",
        "| xyz |   1 |",
        "| x   |  22 |",
    ]


def test_placing_twice_is_placing_once(tmp_path: Path) -> None:
    path = tmp_path / "x.md"
    path.write_text("before\n<!-- m -->\nold\n<!-- /m -->\nafter\n", encoding="utf-8")
    for _ in range(2):
        place(path, "m", "new")
        text = path.read_text(encoding="utf-8")
        assert text == "before\n<!-- m -->\nnew\n<!-- /m -->\nafter\n"


def test_a_document_without_the_place_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "x.md"
    path.write_text("<!-- m -->\n", encoding="utf-8")
    with pytest.raises(ValueError, match="needs one"):
        place(path, "m", "new")


def test_the_documents_have_the_places() -> None:
    assert README.read_text(encoding="utf-8").count("<!-- benchmarks -->") == 1
    text = DOCUMENT.read_text(encoding="utf-8")
    marks = ("arms", "scaling", "sizes", "derive", "explain", "general6r", "calibrated", "singular")
    for mark in marks:
        assert text.count(f"<!-- {mark} -->") == text.count(f"<!-- /{mark} -->") == 1
        _, told = text.split(f"<!-- {mark} -->")
        assert "\n| " in told.split(f"<!-- /{mark} -->")[0]


@pytest.mark.parametrize(
    ("nanoseconds", "text"), [(57.31, "57.3 ns"), (1234.0, "1.23 µs"), (2.5e6, "2.5 ms")]
)
def test_times_have_three_digits(nanoseconds: float, text: str) -> None:
    assert time_text(nanoseconds) == text

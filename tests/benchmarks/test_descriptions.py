"""The table of other people's arms, which needs their packages, has its place."""

from __future__ import annotations

import re

from benchmarks.descriptions import DOCUMENT, HEAD


def test_the_document_has_the_table_s_columns_and_only_arms_that_agree() -> None:
    text = DOCUMENT.read_text(encoding="utf-8")
    assert all(text.count(f"<!-- {mark} -->") == 1 for mark in ("arms", "/arms", "refused"))
    rows = [
        line.split("|") for line in text.splitlines() if re.search("Pinocchio|MuJoCo +\\|", line)
    ]
    rows = [[cell.strip() for cell in row[1:-1]] for row in rows if len(row) == len(HEAD) + 2]
    assert len(rows) >= 40
    for row in rows:
        cells = dict(zip(HEAD, row, strict=True))
        # what nine digits leave of a right angle is exact in any robot file
        assert float(cells["off"]) < (1e-8 if cells["moved [mm]"] else 1e-12), row
        assert float(cells["moved [mm]"] or 0) < 0.1

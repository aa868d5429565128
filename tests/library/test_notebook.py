"""The notebook in docs/: its cells run in their order and show what it says."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.compiling import verify_little
from tests.library.notebook import cells, kept_outputs, outputs

NOTEBOOKS = sorted((Path(__file__).resolve().parents[2] / "docs").glob("*.ipynb"))


def test_there_is_one() -> None:
    assert [path.name for path in NOTEBOOKS] == ["from_a_urdf.ipynb"]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_all_cells_were_run_in_their_order(path: Path) -> None:
    counts = [cell["execution_count"] for cell in cells(path)]
    assert counts == list(range(1, len(counts) + 1))


@pytest.mark.slow  # it builds two arms
@pytest.mark.usefixtures("empty_cache")
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_cells_show_what_the_notebook_says(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    verify_little(monkeypatch)
    assert outputs(path) == kept_outputs(path)

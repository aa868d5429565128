"""What belongs to one robot runs in one process, which then makes its files only once."""

from __future__ import annotations

from pathlib import Path

import pytest

ROBOTS = {path.stem for path in (Path(__file__).parents[1] / "robots").glob("*.yaml")}


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Groups for `--dist loadgroup`."""
    for item in items:
        call = getattr(item, "callspec", None)
        values = list(call.params.values()) if call else []
        names = [value for value in values if isinstance(value, str) and value in ROBOTS]
        if names:
            item.add_marker(pytest.mark.xdist_group(names[0]))

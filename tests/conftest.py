"""What belongs to one robot, or one name, runs in one process, which makes its files only once."""

from __future__ import annotations

from pathlib import Path

import pytest

ROBOTS = {path.stem for path in (Path(__file__).parents[1] / "robots").glob("*.yaml")}


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Groups for `--dist loadgroup`."""
    for item in items:
        call = getattr(item, "callspec", None)
        params = call.params if call else {}
        arms = [value for value in params.values() if isinstance(value, str) and value in ROBOTS]
        group = arms[0] if arms else params.get("name")
        if group is not None:
            item.add_marker(pytest.mark.xdist_group(str(group)))

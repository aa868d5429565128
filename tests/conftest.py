"""What belongs to one robot, name or shared fixture runs in one process, which makes it once."""

from __future__ import annotations

import gc
from pathlib import Path

import pytest
from hypothesis import settings

from tests.structures import GENERAL

settings.register_profile("untimed", deadline=None)  # how long a case takes, the machine decides
settings.load_profile("untimed")

# Derivations keep many small values alive: looking through them again and again took 8 % of a run.
gc.set_threshold(100_000, 50, 100)

ROBOTS = {path.stem for path in (Path(__file__).parents[1] / "robots").glob("*.yaml")}


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Groups for `--dist loadgroup`."""
    for item in items:
        call = getattr(item, "callspec", None)
        params = call.params if call else {}
        arms = [value for value in params.values() if isinstance(value, str) and value in ROBOTS]
        fixtures = item._fixtureinfo.name2fixturedefs if isinstance(item, pytest.Function) else {}
        scopes = {each[-1].scope for each in fixtures.values()}
        shared = {"package": item.path.parent.name, "module": item.path.stem}
        places = [place for scope, place in shared.items() if scope in scopes]
        group = arms[0] if arms else params.get("name", places[0] if places else None)
        if str(group) in GENERAL or item.path.parent.name == "general":
            group = "general"
        if group is not None:
            item.add_marker(pytest.mark.xdist_group(str(group)))

"""What belongs to one robot, name, shared fixture or file runs in one process, made once there."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import settings

from dhgen.workers import collect_seldom
from tests.kept import make_folder
from tests.structures import GENERAL

settings.register_profile("untimed", deadline=None, max_examples=40)  # the machine decides how long
settings.load_profile("untimed")

collect_seldom()

HERE = Path(__file__).parent
FILES = [*(HERE.parent / "robots").glob("*.yaml"), *(HERE / "targets").glob("*/*.yaml")]
ROBOTS = {path.stem for path in FILES}


def pytest_configure(config: pytest.Config) -> None:
    """A folder for what workers share."""
    make_folder(config)


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
        # Arms that a file of tests makes for itself, it makes once.
        own = places[0] if places else item.path.stem
        group = arms[0] if arms else params.get("name", own)
        if str(group) in GENERAL or item.path.parent.name == "general":
            group = "general"
        item.add_marker(pytest.mark.xdist_group(str(group)))

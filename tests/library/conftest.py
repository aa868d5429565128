"""An arm built once, in a cache folder of the tests', verified in plain Python."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import dhgen
from tests.compiling import verify_little
from tests.library.arms import PLANAR

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture(scope="session")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the solver below is kept."""
    return tmp_path_factory.mktemp("cache")


@pytest.fixture(autouse=True)
def _in_the_tests_own_cache(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(cache))


@pytest.fixture(scope="session")
def told() -> list[str]:
    """What the build below says of its progress."""
    return []


@pytest.fixture(scope="session")
def arm() -> dhgen.Arm:
    return dhgen.load(PLANAR)


@pytest.fixture(scope="session")
def solver(cache: Path, arm: dhgen.Arm, told: list[str]) -> dhgen.Solver:
    """A solver, kept for all tests."""
    with pytest.MonkeyPatch.context() as patched:
        verify_little(patched)
        patched.setenv("DHGEN_CACHE_DIR", str(cache))
        return arm.build(progress=told.append)


@pytest.fixture
def empty_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A cache folder that nobody has written to."""
    folder = tmp_path / "empty cache"
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(folder))
    return folder

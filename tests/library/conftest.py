"""An arm built once, in a cache folder of the tests', verified in plain Python."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numba
import pytest

import dhgen
from tests.library.arms import PLANAR

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


@pytest.fixture(scope="package")
def told() -> list[str]:
    """What the build below says of its progress."""
    return []


@pytest.fixture(scope="package")
def arm() -> dhgen.Arm:
    return dhgen.load(PLANAR)


@pytest.fixture(scope="package")
def solver(
    tmp_path_factory: pytest.TempPathFactory, arm: dhgen.Arm, told: list[str]
) -> Iterator[dhgen.Solver]:
    """A solver, and the folder that is kept in as long as a test uses this."""
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(numba.config, "DISABLE_JIT", True)
        patched.setattr("dhgen.verify.verify.COUNT", 20)
        patched.setenv("DHGEN_CACHE_DIR", str(tmp_path_factory.mktemp("cache")))
        yield arm.build(progress=told.append)


@pytest.fixture
def empty_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A cache folder that nobody has written to."""
    folder = tmp_path / "empty cache"
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(folder))
    return folder

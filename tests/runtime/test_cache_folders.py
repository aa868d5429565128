"""Where what compilers make is kept: the same for both helpers, each of which works alone."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from dhgen.runtime.helpers import dhgen_cuda, dhgen_native

if TYPE_CHECKING:
    from types import ModuleType

VARIABLES = ("DHGEN_CACHE_DIR", "XDG_CACHE_HOME", "LOCALAPPDATA")
HELPERS = pytest.mark.parametrize("helper", [dhgen_native, dhgen_cuda])


@pytest.fixture(autouse=True)
def _nothing_chosen(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in VARIABLES:
        monkeypatch.delenv(name, raising=False)


@HELPERS
def test_the_first_that_is_chosen_counts(
    helper: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    assert helper.cache_folder() == tmp_path / ".cache" / "dhgen"
    for name, inside in zip(reversed(VARIABLES), ("dhgen", "dhgen", ""), strict=True):
        monkeypatch.setenv(name, str(tmp_path / name))
        assert helper.cache_folder() == tmp_path / name / inside


@HELPERS
@pytest.mark.parametrize("name", VARIABLES)
def test_a_process_that_goes_elsewhere_keeps_its_folder(
    helper: ModuleType, name: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv(name, "kept")
    monkeypatch.chdir(tmp_path)
    assert tmp_path in helper.cache_folder().parents


@HELPERS
def test_a_user_without_a_home(helper: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    def homeless() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(Path, "home", homeless)
    with pytest.raises(RuntimeError, match=r"^the user has no home folder: set DHGEN_CACHE_DIR"):
        helper.cache_folder()


@HELPERS
def test_a_folder_in_which_nothing_can_be_written(helper: ModuleType, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(OSError, match=r"can't be written there \(.+\): set DHGEN_CACHE_DIR"):
        helper._room(tmp_path / "file")

"""The command in this process, and a folder in which it was run."""

from __future__ import annotations

import shutil
import subprocess
from typing import TYPE_CHECKING

import pytest

from dhgen.cli import main
from tests.cli.commands import PLANAR, dhgen
from tests.compiling import verify_little

if TYPE_CHECKING:
    from pathlib import Path

    from tests.cli.commands import Run


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> Run:
    """The command in a folder, in this process; few poses are verified, in plain Python."""

    def done(*words: str | Path, folder: Path) -> subprocess.CompletedProcess[str]:
        monkeypatch.chdir(folder)
        code = main(list(map(str, words)))
        return subprocess.CompletedProcess(words, code, *capfd.readouterr())

    verify_little(monkeypatch)
    return done


def with_robots(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder for what is made, with a robot file."""
    folder = tmp_path_factory.mktemp("written")
    (folder / "robots").mkdir()
    shutil.copy(PLANAR, folder / "robots")
    return folder


@pytest.fixture(scope="package")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which `dhgen robots/planar_rr.yaml` was run; few poses were verified."""
    folder = with_robots(tmp_path_factory)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        verify_little(patch)
        assert main(["robots/planar_rr.yaml"]) == 0
    return folder


@pytest.fixture(scope="package")
def verified(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same by the command as it is, which takes numba ten seconds."""
    folder = with_robots(tmp_path_factory)
    done = dhgen("robots/planar_rr.yaml", folder=folder, NUMBA_CACHE_DIR="")
    assert (done.returncode, done.stderr) == (0, "")
    # five sorts of 150, and 15 each at the stretched arm and beside it
    assert "this may take a minute ...\nverified on 780 poses" in done.stdout
    # both links along x, and its table's tool is the end of the second one
    assert "\ntool at q = 0: x 0.7, y 0, z 0 m; rpy 0, 0, 0 deg\n" in done.stdout
    assert "dhgen survey robots/planar_rr.yaml\n" in done.stdout
    assert "wrote generated/planar_rr.py" in done.stdout
    assert "\x1b" not in done.stdout
    return folder

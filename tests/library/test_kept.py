"""The folder of solvers: by content, whole or not there, shared by processes."""

from __future__ import annotations

import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest

import dhgen
from dhgen.library import kept
from dhgen.library.kept import DIGESTS, folder_of, is_whole, keep
from tests.library.arms import PLANAR

ROOT = Path(__file__).resolve().parents[2]
TEXTS = {"arm.py": "x = 1\n", "dhgen/arm.h": "/* */\n"}


def test_a_folder_is_named_by_all_that_its_files_depend_on(
    arm: dhgen.Arm, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = folder_of(arm.file)
    assert folder == folder_of(dhgen.load(dict(PLANAR)).file)
    file = arm.file
    others = [
        folder_of(replace(file, text=file.text + "\n")),
        folder_of(replace(file, path=Path("other.yaml"))),
        folder_of(file.with_numerical()),
    ]
    monkeypatch.setattr(dhgen, "__version__", "9.9")
    kept._of_dhgen.cache_clear()
    others.append(folder_of(file))
    kept._of_dhgen.cache_clear()
    assert len({folder, *others}) == 5
    assert {each.parent for each in others} == {folder.parent}


@pytest.mark.parametrize("changed", ["runtime/python/clamp.py", "runtime/c/dhgen/clamp.h"])
def test_another_runtime_is_another_folder(
    changed: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    digests = []
    for addition in ("", "\n"):
        (tmp_path / changed).parent.mkdir(parents=True, exist_ok=True)
        text = (ROOT / "dhgen" / changed).read_text("utf-8")
        (tmp_path / changed).write_text(text + addition, encoding="utf-8")
        monkeypatch.setattr(dhgen, "__file__", str(tmp_path / "__init__.py"))
        kept._of_dhgen.cache_clear()
        digests.append(kept._of_dhgen())
    kept._of_dhgen.cache_clear()
    assert digests[0] != digests[1]


def test_the_cache_folder_is_the_user_s(
    arm: dhgen.Arm, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.delenv("DHGEN_CACHE_DIR", raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    assert folder_of(arm.file).parent == tmp_path / "xdg" / "dhgen" / "solvers"
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(tmp_path / "own"))
    assert folder_of(arm.file).parent == tmp_path / "own" / "solvers"


@pytest.mark.parametrize("harm", ["changed", "missing", "no digests", "half of them"])
def test_what_is_damaged_is_not_whole_and_is_made_again(harm: str, tmp_path: Path) -> None:
    folder = tmp_path / "solvers" / "arm-1"
    assert not is_whole(folder)
    keep(folder, TEXTS)
    assert is_whole(folder)
    if harm == "changed":
        (folder / "arm.py").write_text("x = 2\n")
    elif harm == "missing":
        (folder / "dhgen" / "arm.h").unlink()
    elif harm == "no digests":
        (folder / DIGESTS).unlink()
    else:
        (folder / DIGESTS).write_text((folder / DIGESTS).read_text()[:20])
    assert not is_whole(folder)
    keep(folder, TEXTS)
    assert is_whole(folder)
    assert (folder / "arm.py").read_text() == "x = 1\n"
    assert [path.name for path in folder.parent.iterdir()] == ["arm-1"]


def test_what_is_whole_stays_what_it_is(tmp_path: Path) -> None:
    folder = tmp_path / "solvers" / "arm-1"
    keep(folder, TEXTS)
    (folder / "__pycache__").mkdir()
    keep(folder, TEXTS)
    assert (folder / "__pycache__").is_dir()


def test_many_may_keep_the_same_at_once(tmp_path: Path) -> None:
    for count in range(5):
        folder = tmp_path / "solvers" / f"arm-{count}"
        with ThreadPoolExecutor(8) as pool:
            list(pool.map(lambda _, to=folder: keep(to, TEXTS), range(16)))
        assert is_whole(folder)
    names = sorted(path.name for path in (tmp_path / "solvers").iterdir())
    assert names == [f"arm-{count}" for count in range(5)]


@pytest.mark.skipif(os.name != "posix", reason="a file as a folder is another error elsewhere")
def test_a_cache_that_can_not_be_written_to_is_told_what_to_set(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(OSError, match=r"solvers can't be kept there .*: set DHGEN_CACHE_DIR"):
        keep(tmp_path / "file" / "solvers" / "arm-1", TEXTS)


def test_that_is_told_before_anything_is_built(
    arm: dhgen.Arm, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(tmp_path / "file"))
    told: list[str] = []
    with pytest.raises(OSError, match=r"solvers can't be kept there .*: set DHGEN_CACHE_DIR"):
        arm.build(progress=told.append)
    assert not told


BUILD = """\
import numba, sys
numba.config.DISABLE_JIT = True
import dhgen, dhgen.verify.verify
from tests.library.arms import PLANAR
dhgen.verify.verify.COUNT = 5
arm = dhgen.load({**PLANAR, "task": "position", "joints": PLANAR["joints"][:1]})
print(arm.build(native=False).ik(arm.fk([0.5])).tolist())
"""


@pytest.mark.breadth
def test_two_processes_build_at_once(tmp_path: Path) -> None:
    place = {"DHGEN_CACHE_DIR": str(tmp_path / "cache"), "PYTHONPATH": str(ROOT)}
    place |= {"PATH": str(tmp_path), "CC": ""}  # without C it takes half the time
    both = [
        subprocess.Popen(
            [sys.executable, "-c", BUILD],
            env=os.environ | place,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        for _ in range(2)
    ]
    for process in both:
        out, err = process.communicate()
        assert (out, err) == ("[0.5]\n", "")
    (folder,) = (tmp_path / "cache" / "solvers").iterdir()
    assert is_whole(folder)

"""What goes to an index: the wheel, the source distribution, and dhgen run from the wheel alone."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tarfile
import zipfile
from email.parser import Parser
from pathlib import Path

import pytest
from trove_classifiers import classifiers

import dhgen

ROOT = Path(__file__).resolve().parents[2]
RUN = """\
import sys
import dhgen
assert dhgen.__file__.startswith(sys.argv[1]), dhgen.__file__
arm = dhgen.load("arm.urdf")
print(arm.text, end="")
print(len(arm.derivation()) > 1000)
"""

pytestmark = pytest.mark.slow  # both distributions are built


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the wheel and the source distribution."""
    return build(ROOT, tmp_path_factory.mktemp("dist"), "sdist", "wheel")


def build(source: Path, out: Path, *targets: str) -> Path:
    words = [word for target in targets for word in ("-t", target)]
    command = [sys.executable, "-m", "hatchling", "build", "-d", str(out), *words]
    subprocess.run(command, cwd=source, check=True, capture_output=True)
    return out


def contents(wheel: Path) -> dict[str, bytes]:
    with zipfile.ZipFile(wheel) as file:
        return {name: file.read(name) for name in file.namelist()}


def the(folder: Path, pattern: str) -> Path:
    (found,) = folder.glob(pattern)
    return found


def test_the_wheel_holds_the_package_its_templates_and_its_runtime(built: Path) -> None:
    wheel = contents(the(built, "*.whl"))
    source = (path for path in (ROOT / "dhgen").rglob("*") if path.is_file())
    package = {path for path in source if "__pycache__" not in path.parts}
    expected = {path.relative_to(ROOT).as_posix(): path.read_bytes() for path in package}
    for path in (ROOT / "templates").rglob("*.jinja"):
        expected[f"dhgen/{path.relative_to(ROOT).as_posix()}"] = path.read_bytes()
    assert {"dhgen/py.typed", "dhgen/runtime/c/dhgen/ik.h"} <= set(expected)
    held = {name: text for name, text in wheel.items() if ".dist-info/" not in name}
    assert held == expected
    beside = {name.partition("/")[2] for name in wheel if ".dist-info/" in name}
    assert beside == {"METADATA", "RECORD", "WHEEL", "entry_points.txt", "licenses/LICENSE"}


def test_what_an_index_shows(built: Path) -> None:
    wheel = contents(the(built, "*.whl"))
    text = next(text for name, text in wheel.items() if name.endswith("/METADATA")).decode()
    told = Parser().parsestr(text)
    assert (told["Name"], told["Version"]) == ("dhgen", dhgen.__version__)
    assert told["License-Expression"] == "MIT"
    assert told["Requires-Python"] == ">=3.11"
    assert set(told.get_all("Classifier", [])) <= set(classifiers)
    assert "Typing :: Typed" in told.get_all("Classifier", [])
    assert told["Project-URL"] is None
    assert str(told.get_payload()).strip() == (ROOT / "README.md").read_text("utf-8").strip()


def test_the_source_distribution_makes_the_same_wheel(built: Path, tmp_path: Path) -> None:
    with tarfile.open(the(built, "*.tar.gz")) as file:
        file.extraction_filter = getattr(tarfile, "data_filter", None)  # from Python 3.11.4 on
        file.extractall(tmp_path)  # noqa: S202 it was made here
    source = the(tmp_path, "dhgen-*")
    again = build(source, tmp_path / "dist", "wheel")
    assert contents(the(again, "*.whl")) == contents(the(built, "*.whl"))
    for folder in ("tests", "robots", "generated", "docs", "benchmarks"):  # so that tests run there
        held = {path.relative_to(source) for path in (source / folder).rglob("*")}
        assert tracked(folder) <= held
    assert not list(source.rglob("__pycache__"))


def tracked(folder: str) -> set[Path]:
    """The files of a folder that are committed; none where this is no checkout."""
    if not (ROOT / ".git").exists():
        return set()
    listed = ["git", "ls-files", "-z", folder]
    done = subprocess.run(listed, cwd=ROOT, check=True, capture_output=True, text=True)
    return {Path(name) for name in done.stdout.split("\0") if name}


@pytest.mark.breadth
def test_it_runs_from_the_wheel_in_an_empty_folder(built: Path, tmp_path: Path) -> None:
    place, empty = tmp_path / "place", tmp_path / "empty"
    with zipfile.ZipFile(the(built, "*.whl")) as file:
        file.extractall(place)  # noqa: S202 - it was made above
    empty.mkdir()
    shutil.copy(ROOT / "tests" / "descriptions" / "urdf" / "scara.urdf", empty / "arm.urdf")
    environment = os.environ | {"PYTHONPATH": str(place), "DHGEN_CACHE_DIR": str(tmp_path / "none")}

    def python(*words: str) -> str:
        command = [sys.executable, *words]
        done = subprocess.run(
            command, cwd=empty, env=environment, check=True, capture_output=True, text=True
        )
        return done.stdout

    assert python("-m", "dhgen", "--version") == f"dhgen {dhgen.__version__}\n"
    text = python("-m", "dhgen", "import", "arm.urdf", "--out", "-")
    assert text.startswith("name: epson_t3\n")
    assert python("-c", RUN, str(place)) == f"{text}True\n"
    assert sorted(path.name for path in empty.iterdir()) == ["arm.urdf"]


@pytest.mark.skipif(shutil.which("uvx") is None, reason="uvx is not installed")
def test_uvx_runs_the_wheel(built: Path, tmp_path: Path) -> None:
    command = ["uvx", "--from", str(the(built, "*.whl")), "dhgen", "--version"]
    done = subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True)
    assert done.stdout == f"dhgen {dhgen.__version__}\n"

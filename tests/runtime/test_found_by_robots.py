"""Robots find the runtime that lies beside them, and no other, whatever they are imported by."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from dhgen.atomic_write import write_files
from dhgen.runtime import runtime_files
from tests.compiling import written

ROOT = Path(__file__).resolve().parents[2]
PLANAR = ROOT / "robots" / "planar_rr.yaml"


def run(script: str, folder: Path, path: str) -> subprocess.CompletedProcess[str]:
    """A clean process in a folder, without numba's compiling."""
    return subprocess.run(
        [sys.executable, "-c", script],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": path, "NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two folders of generated files; the runtime of the second answers otherwise."""
    made = tmp_path_factory.mktemp("project")
    for name in ("generated", "others"):
        (made / name).mkdir()
        written(PLANAR, made / name)
    init = made / "others" / "dhgen_runtime" / "__init__.py"
    init.write_text(init.read_text(encoding="utf-8") + "\nOTHER = True\n", encoding="utf-8")
    return made


BOTH = """
import planar_rr
import generated.planar_rr as again
import others.planar_rr as other

assert planar_rr is not again
assert planar_rr._arms is again._arms
assert planar_rr._arms is not other._arms
assert planar_rr._HOW.key == again._HOW.key != other._HOW.key
for robot in (planar_rr, again, other):
    assert robot.ik_all(robot.fk([0.1, 0.2]))[1].tolist() == [robot.OK, robot.OK]
"""


def test_both_names_in_one_process_and_another_folder(project: Path) -> None:
    done = run(BOTH, project, f"{project}:{project / 'generated'}")
    assert (done.returncode, done.stderr) == (0, "")


def test_another_version_of_the_runtime_is_refused(project: Path, tmp_path: Path) -> None:
    write_files(tmp_path, runtime_files())
    init = tmp_path / "dhgen_runtime" / "__init__.py"
    told = init.read_text(encoding="utf-8")
    assert "INTERFACE = 1 " in told
    init.write_text(told.replace("INTERFACE = 1 ", "INTERFACE = 999 "), encoding="utf-8")
    robot = (project / "generated" / "planar_rr.py").read_text(encoding="utf-8")
    write_files(tmp_path, {"planar_rr.py": robot})
    done = run("import planar_rr", tmp_path, str(tmp_path))
    assert done.returncode == 1
    assert "planar_rr.py was generated for version 1 of dhgen_runtime" in done.stderr
    assert "which is version 999 here: run dhgen on its robot file again" in done.stderr


def test_a_robot_alone_names_what_is_missing(project: Path, tmp_path: Path) -> None:
    robot = (project / "generated" / "planar_rr.py").read_text(encoding="utf-8")
    write_files(tmp_path, {"planar_rr.py": robot})
    done = run("import planar_rr", tmp_path, str(tmp_path))
    assert f"No module named '{tmp_path}.dhgen_runtime'" in done.stderr


def test_a_folder_whose_name_has_dots(tmp_path: Path) -> None:
    """Between dots Python would look for packages in packages."""
    folder = tmp_path / "v1.2%2E" / "made.here"
    folder.mkdir(parents=True)
    written(PLANAR, folder)
    done = run("import planar_rr; planar_rr.ik_all(planar_rr.fk([0.1, 0.2]))", folder, str(folder))
    assert (done.returncode, done.stderr) == (0, "")

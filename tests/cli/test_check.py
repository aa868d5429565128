"""--check: what is up to date, stale, missing or extra; and the same bytes everywhere."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from dhgen.atomic_write import write_files
from dhgen.check import compare
from dhgen.cli import main
from dhgen.compiler import compile_loaded, source_name
from dhgen.robot_files import RobotFile, RobotFiles
from tests.cli.commands import (
    FILES,
    PLANAR,
    ROOT,
    WRONG,
    Run,
    copy,
)


def test_check_is_content(run: Run, written: Path) -> None:
    before = {name: (written / "generated" / name).stat().st_mtime_ns for name in FILES}
    done = run("--check", "robots/planar_rr.yaml", folder=written)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == "generated: up to date with 1 robot file\n"
    assert {name: (written / "generated" / name).stat().st_mtime_ns for name in FILES} == before


@pytest.mark.parametrize("out", ["generated", ".", "build/generated"])
def test_what_the_project_s_folder_is_called_is_nobody_s_business(tmp_path: Path, out: str) -> None:
    """A robot file at the top of the project, and one in a folder for such files."""
    for project in ("one", "two"):
        folder = tmp_path / project
        assert source_name(folder / "arm.yaml", folder / out) == "arm.yaml"
        assert source_name(folder / "arms" / "arm.yaml", folder / out) == "arms/arm.yaml"
    assert source_name(tmp_path / "arms" / "arm.yaml", Path("/generated")) == "arms/arm.yaml"


def test_check_sees_a_change(run: Run, written: Path, tmp_path: Path) -> None:
    folder = copy(written, tmp_path)
    path = folder / "generated" / "planar_rr.c"
    path.write_text(path.read_text().replace("a1 = 0.", "a1 = 1.", 1))
    done = run("--check", "robots/planar_rr.yaml", folder=folder)
    assert done.returncode == 1
    assert done.stdout == ""
    assert done.stderr.startswith(
        "generated/planar_rr.c: changed\n--- generated/planar_rr.c (as it is)\n"
    )
    assert "\n-    a1 = 1." in done.stderr
    assert "\n+    a1 = 0." in done.stderr
    assert done.stderr.endswith("\n  to fix: dhgen robots/planar_rr.yaml\n")
    assert run("robots/planar_rr.yaml", folder=folder).returncode == 0
    assert run("--check", "robots/planar_rr.yaml", folder=folder).returncode == 0


def test_check_sees_line_ends(run: Run, written: Path, tmp_path: Path) -> None:
    folder = copy(written, tmp_path)
    path = folder / "generated" / "planar_rr.h"
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
    assert run("--check", "robots/planar_rr.yaml", folder=folder).returncode == 1


def test_check_sees_what_is_missing_and_what_is_extra(
    run: Run, written: Path, tmp_path: Path
) -> None:
    folder = copy(written, tmp_path)
    (folder / "generated" / "planar_rr.md").unlink()
    header = (folder / "generated" / "planar_rr.h").read_text()
    (folder / "generated" / "old_robot.h").write_text(header)
    (folder / "generated" / "own.c").write_text("int main(void) { return 0; }")
    (folder / "generated" / "notes.txt").write_text("not ours")
    (folder / "generated" / "dhgen_runtime" / "old.py").write_text("# another version's\n")
    done = run("--check", "robots/planar_rr.yaml", folder=folder)
    assert done.returncode == 1
    assert done.stderr == (
        "generated/planar_rr.md: missing\n"
        "  to fix: dhgen robots/planar_rr.yaml\n"
        "generated/old_robot.h: extra file: no robot file in robots/ generates it\n"
        "  to fix: add its robot file to the command, or rm generated/old_robot.h\n"
        "generated/own.c: not written by dhgen\n"
        "  to fix: move it elsewhere: all .py, .c, .h and .md files here must be generated\n"
        "generated/dhgen_runtime/old.py: not written by dhgen\n"
        "  to fix: move it elsewhere: all .py, .c, .h and .md files here must be generated\n"
    )


def test_check_leaves_alone_what_a_neighbouring_description_makes(
    run: Run, written: Path, tmp_path: Path
) -> None:
    """Two URDFs in one folder, each with files of its own."""
    folder = copy(written, tmp_path)
    header = (folder / "generated" / "planar_rr.h").read_text()
    (folder / "robots" / "arm.urdf").write_text('<?xml version="1.0"?>\n<robot name="My Arm">\n')
    (folder / "robots" / "scene.xml").write_text('<mujoco model="reach">\n</mujoco>\n')
    for stem in ("my_arm", "reach", "nobody"):
        (folder / "generated" / f"{stem}.h").write_text(header)
    done = run("--check", "robots/planar_rr.yaml", folder=folder)
    assert done.returncode == 1
    assert "generated/nobody.h: extra file" in done.stderr
    assert "my_arm" not in done.stderr
    assert "reach" not in done.stderr


def test_check_looks_at_figures_of_its_own(run: Run, written: Path, tmp_path: Path) -> None:
    folder = copy(written, tmp_path)
    figures = folder / "generated" / "figures"
    arm = (figures / "planar_rr_arm.svg").read_text()
    (figures / "planar_rr_arm.svg").write_text(arm.replace("<title>", "<title>old: "))
    (figures / "planar_rr_postures.svg").unlink()
    (figures / "planar_rr_shadow.svg").write_text(arm)
    (figures / "old_robot_arm.svg").write_text(arm)
    (figures / "theirs_arm.svg").write_text(arm.replace("robots/", "arms/"))
    (figures / "logo.svg").write_text("<svg/>")
    done = run("--check", "robots/planar_rr.yaml", folder=folder)
    assert done.returncode == 1
    assert [line for line in done.stderr.splitlines() if line.startswith("generated/")] == [
        "generated/figures/planar_rr_arm.svg: changed",
        "generated/figures/planar_rr_postures.svg: missing",
        "generated/figures/old_robot_arm.svg: extra file: no robot file in robots/ generates it",
        "generated/figures/planar_rr_shadow.svg: extra file: no robot file in robots/ generates it",
    ]


def test_check_sees_a_change_in_the_runtime(run: Run, written: Path, tmp_path: Path) -> None:
    folder = copy(written, tmp_path)
    path = folder / "generated" / "dhgen_runtime" / "jit.py"
    path.write_text(path.read_text() + "# of somebody else\n")
    done = run("--check", "robots/planar_rr.yaml", folder=folder)
    assert done.returncode == 1
    assert done.stderr.startswith("generated/dhgen_runtime/jit.py: changed\n")
    assert run("robots/planar_rr.yaml", folder=folder).returncode == 0
    assert run("--check", "robots/planar_rr.yaml", folder=folder).returncode == 0


def test_check_leaves_alone_what_is_made_of_another_folder(
    written: Path,
    tmp_path: Path,
    capfd: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(copy(written, tmp_path))
    header = Path("generated/planar_rr.h").read_text()
    for name, folder in ("theirs", "arms/"), ("top", ""), ("ours", "robots/"):
        Path(f"generated/{name}.h").write_text(header.replace("robots/", folder))
    assert main(["--check", "robots/planar_rr.yaml"]) == 1
    extra = [line for line in capfd.readouterr().err.splitlines() if "extra" in line]
    assert [line.split(":")[0] for line in extra] == ["generated/ours.h"]


def test_check_tells_all_refusals_and_what_is_stale_besides(
    written: Path,
    tmp_path: Path,
    capfd: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(copy(written, tmp_path))
    Path("robots/wrong.yaml").write_text(WRONG)
    Path("generated/wrong.c").write_text("of better times")
    Path("generated/planar_rr.md").unlink()
    assert main(["--check", "robots/wrong.yaml", "none.yaml", "robots/planar_rr.yaml"]) == 2
    remarks = [line for line in capfd.readouterr().err.splitlines() if line[0] != " "]
    assert len(remarks) == 3
    assert remarks[0].startswith("robots/wrong.yaml:6:19: unknown name 'x'")
    assert remarks[1] == "none.yaml: the file can't be read: No such file or directory"
    assert remarks[2] == "generated/planar_rr.md: missing"
    assert main(["--check", "robots/wrong.yaml"]) == 2
    assert "extra" not in capfd.readouterr().err


def test_check_of_another_folder_names_it(run: Run, tmp_path: Path) -> None:
    """In one line for each robot, however many files are missing."""
    (tmp_path / "robots").mkdir()
    for name in ("planar_rr.yaml", "scara.yaml"):
        shutil.copy(PLANAR.with_name(name), tmp_path / "robots")
    robots = "robots/planar_rr.yaml", "robots/scara.yaml"
    none = tmp_path / "none"
    done = run("--check", *robots, "--out", none, folder=tmp_path)
    assert done.returncode == 1
    first, fix_first, second, fix_second = done.stderr.splitlines()
    files = "planar_rr.py, planar_rr.h, planar_rr.c"
    assert re.fullmatch(rf"{none}: \d+ files are missing: {files}, \S+ and \d+ more", first)
    assert fix_first == f"  to fix: dhgen robots/planar_rr.yaml --out {none}"
    assert re.match(rf"{none}: \d+ files are missing: scara.py, ", second)
    assert fix_second == f"  to fix: dhgen robots/scara.yaml --out {none}"
    assert not none.exists()


def test_check_says_how_a_folder_was_made(written: Path, tmp_path: Path) -> None:
    """In place of thousands of lines of the runtime, which files hold or do not."""
    file = RobotFile.read(written / "robots" / "planar_rr.yaml")
    here = RobotFiles((file.path,), (file,), ())
    for single_file, made in (True, "with"), (False, "without"):
        out = tmp_path / made
        files = compile_loaded(file, out=out, single_file=single_file).files
        write_files(out, files)
        (problem,) = compare(here, out, ["--out", str(out)], single_file=not single_file).problems
        assert problem == (
            f"{out / 'planar_rr.py'}, {out / 'planar_rr.c'}: made {made} --single-file\n"
            f"  to fix: check {made} --single-file, or dhgen {file.path} --out {out}"
        )
        assert compare(here, out, single_file=single_file).problems == ()


def test_commands_that_are_advised_can_be_pasted(run: Run, tmp_path: Path) -> None:
    (tmp_path / "my robots").mkdir()
    shutil.copy(PLANAR, tmp_path / "my robots" / "my arm.yaml")
    words = ["my robots/my arm.yaml", "--out", "the out"]
    told = run("--check", "--numerical", *words, folder=tmp_path).stderr
    command = "dhgen 'my robots/my arm.yaml' --out 'the out' --numerical"
    assert told.endswith(f"  to fix: {command}\n")
    assert run(*words, folder=tmp_path).returncode == 0
    header = (tmp_path / "the out" / "planar_rr.h").read_text()
    assert "Do not edit: run dhgen 'my robots/my arm.yaml'." in " ".join(header.split())
    (tmp_path / "the out" / "old arm.h").write_text(header)
    told = run("--check", *words, folder=tmp_path).stderr
    assert told.endswith("add its robot file to the command, or rm 'the out/old arm.h'\n")
    told = run("my robots", folder=tmp_path).stderr
    assert told.endswith("name the files in it: 'my robots'/*.yaml\n")


def test_another_working_directory_makes_the_same_bytes(
    run: Run, written: Path, tmp_path: Path
) -> None:
    done = run(PLANAR, "--out", tmp_path / "out", folder=tmp_path)
    assert done.returncode == 0
    for name in FILES:
        assert (tmp_path / "out" / name).read_bytes() == (written / "generated" / name).read_bytes()


def test_a_fleet_of_another_robot_file_is_not_extra(tmp_path: Path) -> None:
    """Beside ur5e.yaml, which makes ur5e_fleet.c, one may check planar_rr.yaml alone."""
    shutil.copy(PLANAR, tmp_path / "planar_rr.yaml")
    shutil.copy(PLANAR.with_name("ur5e.yaml"), tmp_path / "ur5e.yaml")
    files = [RobotFile.read(tmp_path / f"{name}.yaml") for name in ("planar_rr", "ur5e")]
    for file in files:
        write_files(tmp_path / "out", compile_loaded(file, out=tmp_path / "out").files)
    assert (tmp_path / "out" / "ur5e_fleet.c").exists()
    here = RobotFiles((files[0].path,), (files[0],), ())
    assert compare(here, tmp_path / "out").problems == ()


BYTES = """
import sys
from pathlib import Path
from tests.compiling import compile_file
for name in ("scara", "puma560", "ur5"):
    files = compile_file(Path("robots") / f"{name}.yaml").files
    other = [each for each in files if (Path("generated") / each).read_text() != files[each]]
    assert not other, other
"""


@pytest.mark.breadth
@pytest.mark.parametrize(("seed", "types"), [("1", "python"), ("2", "flint")])
def test_neither_hash_seed_nor_ground_type_changes_a_byte(seed: str, types: str) -> None:
    """Of what is committed, which was made with others."""
    if types == "flint":
        pytest.importorskip("flint", reason="python-flint is optional")
    done = subprocess.run(
        [sys.executable, "-c", BYTES],
        cwd=ROOT,
        env=os.environ
        | {"PYTHONPATH": str(ROOT), "PYTHONHASHSEED": seed, "SYMPY_GROUND_TYPES": types},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")


def test_check_of_two_files_of_one_name_and_of_one_file_twice(
    written: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(copy(written, tmp_path))
    twice = ["--check", "robots/planar_rr.yaml", "./robots/../robots/planar_rr.yaml"]
    assert main(twice) == 0
    assert capfd.readouterr().out == "generated: up to date with 1 robot file\n"
    shutil.copy(PLANAR, "again.yaml")
    assert main([*twice, "again.yaml"]) == 2
    told = "again.yaml: robots/planar_rr.yaml also generates files named 'planar_rr': "
    assert capfd.readouterr() == ("", f"{told}rename one of the robots\n")

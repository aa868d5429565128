"""The command line: exit codes, what is written and what is not, and --check."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import numba
import pytest

from dhgen.cli import main
from dhgen.compiler import source_name
from dhgen.errors import UnsolvedError, VerificationError
from dhgen.robot_files import load_all

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.robot_files import RobotFile

    Run = Callable[..., subprocess.CompletedProcess[str]]

ROOT = Path(__file__).resolve().parents[2]
PLANAR = ROOT / "robots" / "planar_rr.yaml"
FILES = ["dhgen_native.py", "dhgen_pose.c", "dhgen_pose.h", "dhgen_pose.py"] + [
    f"planar_rr.{end}" for end in ("c", "h", "md", "py")
]
WRONG = """\
name: wrong
title: wrong
source: made up
convention: standard
joints:
  - {theta: q, d: x, a: 0, alpha: 0}
task: pose
"""
UNSOLVABLE = """\
name: redundant
title: A planar arm with a joint to spare
source: made up
convention: standard
joints:
  - {theta: q, d: 0, a: 0.4, alpha: 0}
  - {theta: q, d: 0, a: 0.3, alpha: 0}
  - {theta: q, d: 0, a: 0.2, alpha: 0}
  - {theta: q, d: 0, a: 0.1, alpha: 0}
task: pose
"""


def dhgen(*words: str | Path, folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """Runs the command in a folder, as a process of its own."""
    return subprocess.run(
        [sys.executable, "-m", "dhgen", *map(str, words)],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(ROOT)} | environment,
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> Run:
    """The command in a folder, in this process; some poses are verified, in plain Python."""

    def done(*words: str | Path, folder: Path) -> subprocess.CompletedProcess[str]:
        monkeypatch.chdir(folder)
        code = main(list(map(str, words)))
        return subprocess.CompletedProcess(words, code, *capfd.readouterr())

    monkeypatch.setattr(numba.config, "DISABLE_JIT", True)
    monkeypatch.setattr("dhgen.verify.verify.COUNT", 20)
    return done


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir() if path.is_file())


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which `dhgen robots/planar_rr.yaml` was run."""
    folder = tmp_path_factory.mktemp("written")
    (folder / "robots").mkdir()
    shutil.copy(PLANAR, folder / "robots")
    done = dhgen("robots/planar_rr.yaml", folder=folder)
    assert (done.returncode, done.stderr) == (0, "")
    # five sorts of 150, and 15 each at the stretched arm and beside it
    assert "verified on 780 poses" in done.stdout
    assert "wrote generated/planar_rr.py" in done.stdout
    assert "\x1b" not in done.stdout
    return folder


def test_what_is_written(written: Path) -> None:
    assert names(written / "generated") == FILES


def test_check_is_content(run: Run, written: Path) -> None:
    before = {name: (written / "generated" / name).stat().st_mtime_ns for name in FILES}
    done = run("--check", "robots/planar_rr.yaml", folder=written)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == "generated: up to date with 1 robot file\n"
    assert {name: (written / "generated" / name).stat().st_mtime_ns for name in FILES} == before


def copy(written: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(written, tmp_path / "copy"))


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
    assert done.stderr.startswith("generated/planar_rr.c: changed\n--- generated/planar_rr.c\n")
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
    done = run("--check", "robots/planar_rr.yaml", folder=folder)
    assert done.returncode == 1
    assert done.stderr == (
        "generated/planar_rr.md: missing\n"
        "  to fix: dhgen robots/planar_rr.yaml\n"
        "generated/old_robot.h: extra file: no robot file in robots/ generates it\n"
        "  to fix: add its robot file to the command, or rm generated/old_robot.h\n"
        "generated/own.c: not written by dhgen\n"
        "  to fix: move it elsewhere: all .py, .c, .h and .md files here must be generated\n"
    )


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


def test_check_of_another_folder_names_it(run: Run, written: Path, tmp_path: Path) -> None:
    done = run("--check", "robots/planar_rr.yaml", "--out", tmp_path / "none", folder=written)
    assert done.returncode == 1
    assert f"to fix: dhgen robots/planar_rr.yaml --out {tmp_path / 'none'}\n" in done.stderr
    assert not (tmp_path / "none").exists()


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


BYTES = """
import sys
from pathlib import Path
from tests.compiling import compile_file
for name in ("scara", "puma560", "ur5"):
    files = compile_file(Path("robots") / f"{name}.yaml").files
    other = [each for each in files if (Path("generated") / each).read_text() != files[each]]
    assert not other, other
"""


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


def test_a_mistake_in_a_file_is_exit_2_and_nothing_is_written(run: Run, tmp_path: Path) -> None:
    (tmp_path / "wrong.yaml").write_text(WRONG)
    for words in (["wrong.yaml"], ["--check", "wrong.yaml"], ["explain", "wrong.yaml"]):
        done = run(*words, folder=tmp_path)
        assert (done.returncode, done.stdout) == (2, "")
        assert done.stderr.startswith("wrong.yaml:6:19: ")
        assert "Traceback" not in done.stderr
        assert names(tmp_path) == ["wrong.yaml"]


def test_an_arm_without_a_solution_is_exit_1_and_nothing_is_written(
    run: Run, tmp_path: Path
) -> None:
    (tmp_path / "redundant.yaml").write_text(UNSOLVABLE)
    done = run("redundant.yaml", folder=tmp_path)
    assert (done.returncode, done.stdout) == (1, "")
    assert "infinitely many solutions" in done.stderr
    assert names(tmp_path) == ["redundant.yaml"]
    assert not (tmp_path / "generated").exists()


def test_one_bad_file_among_good_ones(run: Run, tmp_path: Path) -> None:
    (tmp_path / "wrong.yaml").write_text(WRONG)
    done = run("wrong.yaml", PLANAR, folder=tmp_path)
    assert done.returncode == 2
    assert names(tmp_path / "generated") == FILES


@pytest.mark.parametrize("verb", [[], ["explain"], ["--check"]])
def test_notes_are_told_once_and_before_a_refusal(
    verb: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("slip.yaml").write_text(UNSOLVABLE.replace("0.4, alpha: 0", "0.4, limits: [-90, 90]"))
    assert main([*verb, "slip.yaml"]) == 1
    note, refusal = capsys.readouterr().err.split("slip.yaml: ", 1)
    assert note.startswith("note: slip.yaml:6:39: '-90' is 14.3 turns: write -90 deg")
    assert "turns" not in refusal


def test_two_files_of_one_name_are_refused_before_the_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def work(file: RobotFile, **_: object) -> NoReturn:
        worked.append(file.path)
        raise UnsolvedError(capsys.readouterr().err)

    worked: list[Path] = []
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("dhgen.verbs._compile", work)
    shutil.copy(PLANAR, "again.yaml")
    again = f"again.yaml: {PLANAR} also generates files named 'planar_rr': rename one of the robots"
    assert main([str(PLANAR), "again.yaml", os.path.relpath(PLANAR)]) == 2
    assert capsys.readouterr().err.startswith(again)
    assert worked == [PLANAR]


def test_what_is_left_out_of_several_files_is_told_at_the_end(run: Run, tmp_path: Path) -> None:
    shutil.copy(PLANAR, tmp_path / "again.yaml")
    (tmp_path / "wrong.yaml").write_text(WRONG)
    (tmp_path / "redundant.yaml").write_text(UNSOLVABLE)
    done = run("wrong.yaml", "redundant.yaml", PLANAR, "again.yaml", folder=tmp_path)
    assert done.returncode == 2
    told = "wrong.yaml, again.yaml, redundant.yaml"
    assert done.stderr.endswith(f"\ndhgen: nothing was written for {told}: see above\n")
    assert names(tmp_path / "generated") == FILES
    assert "nothing was written for" not in run("wrong.yaml", folder=tmp_path).stderr


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


def test_single_precision_has_a_name_of_its_own_that_another_robot_may_have(tmp_path: Path) -> None:
    planar = PLANAR.read_text()
    (tmp_path / "a.yaml").write_text(planar.replace("planar_rr", "arm") + "float32: true\n")
    (tmp_path / "b.yaml").write_text(planar.replace("planar_rr", "arm_f32"))
    files = load_all([tmp_path / "a.yaml", tmp_path / "b.yaml"])
    assert [file.robot.name for file in files.loaded] == ["arm"]
    assert "a.yaml also generates files named 'arm_f32'" in str(files.refusals[0])


def test_what_fails_verification_is_not_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("dhgen.verify.demands.RESIDUAL", 1e-30)
    monkeypatch.setattr(numba.config, "DISABLE_JIT", True)
    assert main([str(PLANAR)]) == 1
    told = capsys.readouterr().err
    assert "a row misses the pose" in told
    assert told.endswith("nothing was written\nplease report it, with the robot file\n")
    assert list(tmp_path.iterdir()) == []


def test_what_fails_in_single_precision_only_is_told_the_way_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def miss(*_: object) -> NoReturn:
        raise VerificationError("a row misses the pose")

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("dhgen.compiler.verify", lambda *_: None)
    monkeypatch.setattr("dhgen.compiler.verify_single", miss)
    Path("coarse.yaml").write_text(f"{PLANAR.read_text()}float32: true\n")
    assert main(["coarse.yaml"]) == 1
    told = "a row misses the pose\ndouble precision passes: leave float32 out for now\n"
    assert capsys.readouterr().err.startswith(told)
    assert names(tmp_path) == ["coarse.yaml"]


def test_a_note_may_be_why_verification_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("dhgen.verify.demands.RESIDUAL", 1e-30)
    monkeypatch.setattr(numba.config, "DISABLE_JIT", True)
    Path("noted.yaml").write_text(
        PLANAR.read_text().replace("parameters: {", "parameters: {x: 1, ")
    )
    assert main(["noted.yaml"]) == 1
    told = capsys.readouterr().err
    assert told.startswith("note: ")
    assert (
        "\na note above may say why; if not, this is a bug in dhgen; nothing was written\n" in told
    )


@pytest.mark.parametrize("a1", ["0.3", "4e5"])
def test_lengths_out_of_proportion_are_told_where_they_are_why(
    a1: str, run: Run, tmp_path: Path
) -> None:
    """Two links of which the first is short beside the second, and the other way round."""
    a2 = "4e5" if a1 == "0.3" else "0.3"
    text = PLANAR.read_text().replace("a1: 0.4", f"a1: {a1}").replace("a2: 0.3", f"a2: {a2}")
    (tmp_path / "arm.yaml").write_text(text)
    done = run("arm.yaml", folder=tmp_path)
    if a1 == "4e5":
        assert (done.returncode, done.stderr) == (0, "")
        return
    assert done.returncode == 1
    miss, why = done.stderr.split("note: arm.yaml:8:")
    assert "a row misses the pose" in miss
    assert "'a1' is 7.5e-07 of the longest length, 400000, and rounding may exceed" in why
    assert why.count("a note above may say why; if not, this is a bug in dhgen") == 1


@pytest.mark.parametrize("out", ["file", "file/below", "nowhere", "loop", "loop/below"])
def test_a_folder_that_cannot_be_written_is_found_out_before_the_work(
    out: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("dhgen.verbs._compile", lambda *_: pytest.fail("the work has begun"))
    Path("file").touch()
    Path("nowhere").symlink_to("not there")
    Path("loop").symlink_to("loop")
    assert main([str(PLANAR), "--out", out]) == 2
    assert capsys.readouterr().err.startswith(f"dhgen: can't write to the folder {out} (")
    assert names(tmp_path) == ["file"]


def test_what_can_not_be_written_over_is_told_before_anything_is(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "x" / "planar_rr.h").mkdir(parents=True)
    done = run(PLANAR, "--out", "x", folder=tmp_path)
    told = "dhgen: can't write x/planar_rr.h: it is a folder\n"
    assert (done.returncode, done.stderr) == (2, told)
    assert names(tmp_path / "x") == []
    (tmp_path / "x" / "planar_rr.h").rmdir()
    (tmp_path / "x" / "planar_rr.h").touch()
    monkeypatch.setattr("os.access", lambda path, _: Path(path).suffix != ".h")
    done = run(PLANAR, "--out", "x", folder=tmp_path)
    told = "dhgen: can't write x/planar_rr.h: the file is read-only\n"
    assert (done.returncode, done.stderr) == (2, told)
    assert names(tmp_path / "x") == ["planar_rr.h"]


@pytest.mark.parametrize("words", [[""], ["explain", ""], ["survey", ""], ["--out", "", "x"]])
def test_an_empty_text_is_no_path(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(words)
    assert stopped.value.code == 2
    assert "a path can't be empty" in capsys.readouterr().err


def test_a_compiler_that_builds_nothing_is_not_the_file_s_fault(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    broken = tmp_path / "broken"
    broken.write_text("#!/bin/sh\necho cannot find ld >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setenv("CC", str(broken))
    done = run(PLANAR, folder=tmp_path)
    told = f"the C compiler {broken} can't build anything here:\ncannot find ld\nfix it, or set"
    assert (done.returncode, done.stderr) == (1, f"{told} $CC to another compiler\n")
    assert not (tmp_path / "generated").exists()


def test_without_a_path_the_compiler_finds_its_linker(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("PATH")
    monkeypatch.delenv("CC", raising=False)
    done = run(PLANAR, folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert "Python and C agree" in done.stdout


def test_links_that_lead_in_a_circle(run: Run, tmp_path: Path) -> None:
    (tmp_path / "loop").symlink_to("loop")
    for words in (["loop"], ["--check", "loop"], ["explain", "loop"]):
        done = run(*words, folder=tmp_path)
        told = "loop: the file can't be read: Too many levels of symbolic links\n"
        assert (done.returncode, done.stderr) == (2, told)
    done = run("--check", PLANAR, "--out", "loop", folder=tmp_path)
    assert done.returncode == 1
    assert "loop/planar_rr.c: can't be read (Too many levels of symbolic links)" in done.stderr


def in_shell(command: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Runs the command as a shell does that closes streams."""
    return subprocess.run(
        ["/bin/sh", "-c", f"{sys.executable} -m dhgen {command}"],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.parametrize("closed", ["2>&-", "<&- >&- 2>&-"])
def test_streams_that_are_closed_change_nothing_but_what_is_told(
    closed: str, tmp_path: Path
) -> None:
    """As services and cron jobs may start it."""
    (tmp_path / "wrong.yaml").write_text(WRONG)
    for words, code in (f"--out x {PLANAR}", 0), ("explain wrong.yaml", 2):
        done = in_shell(f"{words} {closed}", tmp_path)
        assert (done.returncode, done.stderr) == (code, "")
        assert (not done.stdout) == (code == 2 or closed != "2>&-")
    assert names(tmp_path / "x") == FILES
    done = in_shell(f"explain {PLANAR} {closed}", tmp_path)
    assert (done.returncode, not done.stdout) == ((0, False) if closed == "2>&-" else (2, True))


@pytest.mark.parametrize("verb", ["explain", "survey"])
def test_what_is_only_printed_needs_somewhere_to_print(verb: str, tmp_path: Path) -> None:
    done = in_shell(f"{verb} {PLANAR} >&-", tmp_path)
    told = "dhgen: standard output is closed: there is nothing to print to\n"
    assert (done.returncode, done.stderr) == (2, told)


@pytest.mark.parametrize(
    ("word", "meant"),
    [
        ("explan", "explain"),
        ("survy", "survey"),
        ("check", "--check"),
        ("version", "--version"),
    ],
)
def test_a_misspelt_verb(word: str, meant: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([word, str(PLANAR)]) == 2
    expected = f"dhgen: no file '{word}'; did you mean 'dhgen {meant}'?\n"
    assert capsys.readouterr() == ("", expected)


def test_no_such_file(tmp_path: Path) -> None:
    done = dhgen("none.yaml", folder=tmp_path)
    assert done.returncode == 2
    assert "none.yaml" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("words", [[], ["--chekc", "a.yaml"], ["explain"]])
def test_a_mistake_on_the_command_line_is_exit_2(words: list[str], tmp_path: Path) -> None:
    done = dhgen(*words, folder=tmp_path)
    assert done.returncode == 2
    assert done.stderr.startswith("usage: dhgen")


def test_a_number_of_poses_that_is_none(capsys: pytest.CaptureFixture[str]) -> None:
    for word in ("x", "0", "-3", "1.5"):
        with pytest.raises(SystemExit, match="2"):
            main(["survey", str(PLANAR), "--poses", word])
        wanted = f"--poses: must be a whole number above zero, not '{word}'\n"
        assert capsys.readouterr().err.endswith(wanted)


@pytest.mark.parametrize(
    ("option", "told"), [("--help", "exit codes: 0 done"), ("--version", "dhgen ")]
)
def test_help_and_version_need_no_sympy(option: str, told: str, tmp_path: Path) -> None:
    done = dhgen(option, folder=tmp_path, PYTHONPROFILEIMPORTTIME="1")
    assert done.returncode == 0
    assert told in done.stdout
    assert "argparse" in done.stderr
    assert "sympy" not in done.stderr


@pytest.mark.parametrize("option", [[], ["--alternatives"], ["--program"]])
def test_explain(run: Run, option: list[str], tmp_path: Path) -> None:
    done = run("explain", PLANAR, *option, folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert {"θ₂", "theta2"} & set(re.split(r"[\s:,;.$]", done.stdout))
    assert names(tmp_path) == []


def test_a_reader_who_has_seen_enough(tmp_path: Path) -> None:
    """`dhgen explain x.yaml | head -1` ends without a traceback."""
    command = f"{sys.executable} -m dhgen explain {PLANAR} | head -1"
    done = subprocess.run(
        ["/bin/sh", "-c", command],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert "Traceback" not in done.stderr

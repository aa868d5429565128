"""The command: exit codes, what is written and what is not."""

from __future__ import annotations

import errno
import os
import re
import shutil
from pathlib import Path
from typing import NoReturn

import pytest

from dhgen.atomic_write import write_files
from dhgen.cli import main
from dhgen.errors import UnsolvedError, VerificationError
from dhgen.generated_header import is_of_dhgen
from dhgen.robot_files import RobotFile, load_all
from tests.cli.commands import (
    FILES,
    PLANAR,
    ROOT,
    UNSOLVABLE,
    WRONG,
    Run,
    full_disk,
    names,
)
from tests.compiling import verify_little
from tests.structures import first_of


def test_what_is_written(written: Path) -> None:
    assert names(written / "generated") == FILES


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


def test_a_table_of_the_other_convention_is_told_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    rows = "  - {theta: q, d: 0.1, alpha: pi/2}\n  - {theta: q, a: 0.3}\n  - {theta: q, a: 0.2}\n"
    Path("arm.yaml").write_text(f"name: arm\ntask: position\nconvention: modified\njoints:\n{rows}")
    assert main(["explain", "arm.yaml"]) == 1
    last = capsys.readouterr().err.splitlines()[-1]
    assert last.startswith("with `convention: standard` this table is an arm whose joints all")


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
    Path("slip.yaml").write_text(UNSOLVABLE.replace("0.4, alpha: 0", "0.4, limits: [-90, 1]"))
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
    monkeypatch.setattr("dhgen.commands._compile", work)
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


def test_single_precision_has_a_name_of_its_own_that_another_robot_may_have(tmp_path: Path) -> None:
    planar = PLANAR.read_text()
    (tmp_path / "a.yaml").write_text(planar.replace("planar_rr", "arm") + "float32: true\n")
    (tmp_path / "b.yaml").write_text(planar.replace("planar_rr", "arm_f32"))
    files = load_all([tmp_path / "a.yaml", tmp_path / "b.yaml"])
    assert [file.robot.name for file in files.loaded] == ["arm"]
    assert "a.yaml also generates files named 'arm_f32'" in str(files.refusals[0])


@pytest.mark.parametrize(("first", "second"), first_of([("arm_f32", "arm"), ("arm", "arm_f32")]))
def test_what_an_earlier_run_wrote_for_another_robot_stays(
    first: str, second: str, run: Run, tmp_path: Path
) -> None:
    planar = PLANAR.read_text()
    (tmp_path / "arm.yaml").write_text(planar.replace("planar_rr", "arm") + "float32: true\n")
    (tmp_path / "arm_f32.yaml").write_text(planar.replace("planar_rr", "arm_f32"))
    assert run(f"{first}.yaml", "--out", "x", folder=tmp_path).returncode == 0
    before = {name: (tmp_path / "x" / name).read_bytes() for name in names(tmp_path / "x")}
    done = run(f"{second}.yaml", "--out", "x", folder=tmp_path)
    told = (
        f"{second}.yaml: x/arm_f32.* are files of the robot '{first}', made of {first}.yaml: "
        "rename one of the robots, write to another folder (--out), or remove them if they are "
        "left over\n"
    )
    assert (done.returncode, done.stdout, done.stderr) == (2, "", told)
    after = {name: (tmp_path / "x" / name).read_bytes() for name in names(tmp_path / "x")}
    assert after == before


OF_ANOTHER_VERSION = {
    "planar_rr.c": "/* x\n *\n * generated from x.yaml and templates/c/x.jinja.\n * Do not edit",
    "planar_rr.md": "<!-- Generated from x.yaml and templates/document.md.jinja. Do not edit. -->",
    "dhgen_pose.c": "/* Generated from templates/c/dhgen_pose.c.jinja. Do not edit: x. */",
    "dhgen_pose.py": '"""Part of dhgen, which puts a copy of this file beside the robots.',
    "dhgen/arm.h": "/* SPDX-License-Identifier: MIT\n *",
    "figures/planar_rr_arm.svg": "<svg>\n<!-- Generated from x.yaml and templates/x. Do not edit",
}


@pytest.mark.parametrize(
    ("own", "told"),
    [
        (["planar_rr.c"], "x/planar_rr.c is there already and not made by dhgen: move it"),
        (
            ["planar_rr.md", "dhgen_pose.py"],
            "x/planar_rr.md, x/dhgen_pose.py are there already and not made by dhgen: move them",
        ),
        (["dhgen/arm.h"], "x/dhgen/arm.h is there already and not made by dhgen: move it"),
    ],
)
def test_files_that_dhgen_did_not_write_stay_as_they_are(
    own: list[str], told: str, run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_files(tmp_path / "x", OF_ANOTHER_VERSION | dict.fromkeys(own, "mine"))
    monkeypatch.setattr("dhgen.commands._compile", lambda *_: pytest.fail("the work has begun"))
    done = run(PLANAR, "--out", "x", folder=tmp_path)
    way_out = "elsewhere, or write to another folder (--out)"
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == f"{PLANAR}: {told} {way_out}\n"
    assert all((tmp_path / "x" / name).read_text() == "mine" for name in own)


def test_figures_that_dhgen_did_not_draw_stay_as_they_are(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_files(tmp_path / "x", {"figures/planar_rr_arm.svg": "<svg></svg>"})
    monkeypatch.setattr("dhgen.compiler.verify", lambda *_: pytest.fail("verification has begun"))
    done = run(PLANAR, "--out", "x", folder=tmp_path)
    assert done.returncode == 2
    assert "x/figures/planar_rr_arm.svg is there already and not made by dhgen" in done.stderr
    assert names(tmp_path / "x") == []


def test_files_of_other_versions_and_empty_ones_are_written_over(run: Run, tmp_path: Path) -> None:
    """Those of 0.1 had all their heads of templates; the runtime's name nothing but its licence."""
    write_files(tmp_path / "x", OF_ANOTHER_VERSION | {"planar_rr.h": ""})
    done = run(PLANAR, "--out", "x", folder=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert run("--check", PLANAR, "--out", "x", folder=tmp_path).returncode == 0


def test_what_dhgen_writes_is_known_as_its_own() -> None:
    folder = ROOT / "generated"
    ends = {".py", ".c", ".h", ".md", ".cuh", ".svg"}  # what else is there Python and numba keep
    paths = [path for path in folder.rglob("*") if path.suffix in ends]
    written = [path.relative_to(folder).as_posix() for path in paths]
    assert [name for name in written if not is_of_dhgen(folder, name)] == []


@pytest.mark.breadth
def test_a_robot_is_the_same_whatever_its_file_is_called(run: Run, tmp_path: Path) -> None:
    (tmp_path / "arm.yaml").write_text(PLANAR.read_text() + "float32: true\n")
    assert run("arm.yaml", folder=tmp_path).returncode == 0
    (tmp_path / "arms").mkdir()
    (tmp_path / "arm.yaml").rename(tmp_path / "arms" / "planar.yaml")
    assert run("arms/planar.yaml", folder=tmp_path).returncode == 0
    header = (tmp_path / "generated" / "planar_rr_f32.h").read_text()
    assert "generated from arms/planar.yaml and" in header


def test_names_that_differ_in_capitals_only(tmp_path: Path) -> None:
    """Some file systems take them for one name, and so do the guards of the headers."""
    for stem in ("armA", "arma"):
        text = PLANAR.read_text(encoding="utf-8").replace("name: planar_rr", f"name: {stem}")
        (tmp_path / f"of_{stem}.yaml").write_text(text, encoding="utf-8")
    files = load_all([tmp_path / "of_armA.yaml", tmp_path / "of_arma.yaml"])
    assert [file.robot.name for file in files.loaded] == ["armA"]
    told = "of_armA.yaml also generates files named 'armA', which differ in capitals only"
    assert told in str(files.refusals[0])


def test_what_fails_verification_is_not_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("dhgen.verify.demands.RESIDUAL", 1e-30)
    verify_little(monkeypatch)
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
    verify_little(monkeypatch)
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
    line = 1 + next(n for n, each in enumerate(text.splitlines()) if "a: a1" in each)
    miss, why = done.stderr.split(f"note: arm.yaml:{line}:")
    assert "a row misses the pose" in miss
    assert "'a1' is 7.5e-07 of the longest length, 400000, and rounding may exceed" in why
    assert why.count("a note above may say why; if not, this is a bug in dhgen") == 1


@pytest.mark.parametrize("out", ["file", "file/below", "nowhere", "loop", "loop/below"])
def test_a_folder_that_cannot_be_written_is_found_out_before_the_work(
    out: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("dhgen.commands._compile", lambda *_: pytest.fail("the work has begun"))
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


def test_a_full_disk_leaves_all_files_as_they_were(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    of_better_times = "# Generated from planar_rr.yaml and templates/x. Do not edit"
    write_files(tmp_path / "x", {"planar_rr.py": of_better_times})
    write_bytes = Path.write_bytes

    def filling(path: Path, content: bytes) -> int:
        return full_disk(path, content) if path.suffix == ".c" else write_bytes(path, content)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_bytes", filling)
        done = run(PLANAR, "--out", "x", folder=tmp_path)
    told = f"dhgen: {os.strerror(errno.ENOSPC)}: x/planar_rr.c\n"
    assert (done.returncode, done.stderr) == (1, told)
    assert [path.name for path in (tmp_path / "x").iterdir()] == ["planar_rr.py"]
    assert (tmp_path / "x" / "planar_rr.py").read_text() == of_better_times
    assert run(PLANAR, "--out", "x", folder=tmp_path).returncode == 0
    assert names(tmp_path / "x") == FILES
    written = (tmp_path / "x" / "planar_rr.c").stat()
    (tmp_path / "own.c").touch()
    assert written.st_mode == (tmp_path / "own.c").stat().st_mode


def test_a_full_disk_behind_the_passing_folder_is_named(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_text", full_disk)
        done = run(PLANAR, "--out", "x", folder=tmp_path)
    assert done.returncode == 1
    assert re.match(r"dhgen: .+: \S+/dhgen-\w+/planar_rr.py\n", done.stderr)
    assert not (tmp_path / "x").exists()

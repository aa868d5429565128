"""`dhgen survey` as a user runs it."""

from __future__ import annotations

import re
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from dhgen.cli import main
from dhgen.errors import RobotFileError
from dhgen.robot.load import load
from dhgen.survey.survey import survey
from tests.robots.cases import ROBOTS

if TYPE_CHECKING:
    from pathlib import Path

ROOT = ROBOTS.parent


def test_plain_text_and_exit_codes(capsys: pytest.CaptureFixture[str]) -> None:
    files = [str(ROBOTS / f"{name}.yaml") for name in ("planar_rr", "scara")]
    assert main(["survey", *files, "--poses", "4"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert [line.split()[0] for line in out.splitlines()[1:3]] == ["planar_rr", "scara"]
    assert "16 of 16 solutions found on 8 random poses, 0 spurious." in out
    assert "\x1b" not in out


@pytest.mark.parametrize(("name", "legs"), [("planar_rr", ""), ("five_bar", " of 2 legs")])
def test_who_waits_for_one_arm_is_told_what_is_being_done(name: str, legs: str) -> None:
    told: list[str] = []
    survey([ROBOTS / f"{name}.yaml"], 4, 2, told.append)
    assert f"{name}: searching for all solutions{legs} on 4 random poses" in told
    assert any(each.startswith(f"{name}: singular poses") for each in told)
    assert told[-1] == f"1 of 1: {name}"


@pytest.mark.breadth
def test_a_refused_arm_stands_in_the_table(tmp_path: Path) -> None:
    tables = (ROOT / "tests/robots/tables.json").read_text(encoding="utf-8")
    wanted = [line for line in tables.splitlines() if '"degenerate_collinear_56"' in line]
    (tmp_path / "list.json").write_text(f"[{wanted[0]}]")
    done = subprocess.run(
        [sys.executable, "-m", "dhgen", "survey", "list.json", "--poses", "2"],
        cwd=tmp_path,
        env={"PYTHONPATH": str(ROOT), "PATH": "/usr/bin:/bin"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (1, "")
    line = done.stdout.splitlines()[1]
    assert re.match(
        r"degenerate_collinear_56 +RRRRRR +\S.* not solved: .*5 independent motions are left", line
    )
    assert "1 arm, 0 solved." in done.stdout


@pytest.mark.breadth
def test_a_file_with_mistakes_stands_in_the_table(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "torn.yaml").write_text("name: torn\n")
    planar = str(ROBOTS / "planar_rr.yaml")
    assert main(["survey", str(tmp_path), planar, planar, "--poses", "2"]) == 2
    out, err = capsys.readouterr()
    torn, whole, again = out.splitlines()[1:4]
    first = re.match(rf"torn +not solved: ({tmp_path}/torn.yaml:1:1: \S.*)", torn)
    assert first
    with pytest.raises(RobotFileError) as refused:
        load(tmp_path / "torn.yaml")
    assert err == f"{refused.value}\n"
    assert err.startswith(first[1])
    assert "4/4" in whole
    assert again.endswith("not solved: another arm above has the same name, 'planar_rr'")


def test_a_note_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    planar = (ROBOTS / "planar_rr.yaml").read_text(encoding="utf-8")
    slip = tmp_path / "slip.yaml"
    slip.write_text(planar.replace("a1, alpha: 0", "a1, alpha: 0, limits: [-90, 1]"))
    assert main(["survey", str(slip), "--poses", "2"]) == 0
    err = capsys.readouterr().err
    assert err.startswith(f"note: {slip}:")
    assert "'-90' is 14.3 turns: write -90 deg" in err


def test_what_is_not_there_is_told_before_anything_is_done(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    planar = str(ROBOTS / "planar_rr.yaml")
    assert main(["survey", planar, str(tmp_path), str(tmp_path / "x.yaml")]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.splitlines() == [
        f"{tmp_path}: no robot files (*.yaml, *.yml, *.urdf) here; name lists in JSON themselves",
        f"{tmp_path}/x.yaml: no such file or folder",
    ]


@pytest.mark.parametrize("words", [["--poses", "0", "x.yaml"], ["--poses", "x", "x.yaml"], []])
def test_mistakes_on_the_command_line(words: list[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(["survey", *words])
    assert left.value.code == 2

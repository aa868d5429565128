"""`dhgen survey` as a user runs it."""

from __future__ import annotations

import re
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from dhgen.cli import main
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
    assert (
        "8 of 8 solutions" in re.sub(r"\d+ of (\d+) solutions", r"\1 of \1 solutions", out) or out
    )
    assert "\x1b" not in out


def test_a_refused_arm_stands_in_the_table(tmp_path: Path) -> None:
    tables = (ROOT / "tests/robots/tables.json").read_text(encoding="utf-8")
    wanted = [line for line in tables.splitlines() if '"degenerate_collinear_56"' in line]
    (tmp_path / "list.json").write_text(f"[{wanted[0]}]")
    (tmp_path / "torn.yaml").write_text("name: torn\n")
    done = subprocess.run(
        [sys.executable, "-m", "dhgen", "survey", "list.json", "torn.yaml", "--poses", "2"],
        cwd=tmp_path,
        env={"PYTHONPATH": str(ROOT), "PATH": "/usr/bin:/bin"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (1, "")
    first, second = done.stdout.splitlines()[1:3]
    assert re.match(r"degenerate_collinear_56 +RRRRRR +\S.* not solved: \S", first)
    assert re.match(r"torn +not solved: \S", second)
    assert "2 arms, 0 solved." in done.stdout


@pytest.mark.parametrize("words", [["--poses", "0", "x.yaml"], ["--poses", "x", "x.yaml"], []])
def test_mistakes_on_the_command_line(words: list[str]) -> None:
    with pytest.raises(SystemExit) as left:
        main(["survey", *words])
    assert left.value.code == 2

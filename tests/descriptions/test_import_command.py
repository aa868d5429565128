"""`dhgen import`, and URDF files in the place of robot files."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from dhgen.cli import main
from dhgen.robot.load import load
from dhgen.robot_files import RobotFile
from tests.descriptions.reference import FILES

UR5 = FILES / "ur5.urdf"


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_it_writes_a_robot_file_and_tells_how_far_it_is_off(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["import", str(FILES / "panda.urdf")]) == 0
    told = capsys.readouterr()
    first, second, third = told.out.splitlines()
    assert first == "panda: 7 joints, from panda_link0 to panda_link8"
    assert second.startswith("compared with panda.urdf at 1000 random joint values: the tools are ")
    assert "e-16 of the arm's size" in second
    assert third == "wrote panda.yaml; solvers: dhgen panda.yaml"
    assert told.err == (
        "note: left out: panda_hand on panda_link8, with 2 joints of its own; fixed to the arm: "
        "panda_hand (dhgen import --tip takes it)\n"
    )
    assert load("panda.yaml").name == "panda"


def test_it_writes_over_nothing_that_a_person_may_have_changed(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["import", str(UR5)]) == 0
    assert main(["import", str(UR5)]) == 0  # nothing was changed
    Path("ur5.yaml").write_text("mine", encoding="utf-8")
    assert main(["import", str(UR5)]) == 2
    assert "ur5.yaml is there already: write over it with --out ur5.yaml" in capsys.readouterr().err
    assert Path("ur5.yaml").read_text(encoding="utf-8") == "mine"
    assert main(["import", str(UR5), "--out", "ur5.yaml"]) == 0
    assert load("ur5.yaml").name == "ur5"


def test_what_is_there_may_be_anything(capsys: pytest.CaptureFixture[str]) -> None:
    latin = "# größer".encode("latin-1")  # no UTF-8
    Path("ur5.yaml").write_bytes(latin)
    assert main(["import", str(UR5)]) == 2
    assert "ur5.yaml is there already" in capsys.readouterr().err
    assert Path("ur5.yaml").read_bytes() == latin
    assert main(["import", str(UR5), "--out", "ur5.yaml"]) == 0
    assert "note: ur5.yaml was there and is written over" in capsys.readouterr().err
    Path("ur5.yaml").unlink()
    Path("ur5.yaml").mkdir()
    for out in ([], ["--out", "ur5.yaml"]):
        assert main(["import", str(UR5), *out]) == 2
        error = capsys.readouterr().err.splitlines()[-1]
        assert error == "dhgen: can't write ur5.yaml: it is a folder"


def test_folders_are_made() -> None:
    assert main(["import", str(UR5), "--out", "some/where/x.yaml"]) == 0
    assert load("some/where/x.yaml").name == "ur5"


def test_the_terminal_gets_the_file_alone(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["import", str(UR5), "--out", "-"]) == 0
    told = capsys.readouterr().out
    Path("x.yaml").write_text(told, encoding="utf-8")
    assert load("x.yaml").name == "ur5"
    assert not Path("ur5.yaml").exists()


def test_options_of_the_chain_and_the_form(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["--base", "base_link", "--tip", "wrist_2_link", "--axes", "--out", "part.yaml"]
    assert main(["import", str(UR5), *words]) == 0
    assert "5 joints, from base_link to wrist_2_link" in capsys.readouterr().out
    text = Path("part.yaml").read_text(encoding="utf-8")
    assert "axes:" in text
    assert "source: URDF ur5.urdf, poses of wrist_2_link in base_link\n" in text


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("<robot", 2),
        ("<!DOCTYPE r [<!ENTITY a 'b'>]>\n<robot/>", 2),
        ("<sdf/>", 2),
        ("name: arm\njoints: []\n", 2),
        (None, 2),
    ],
)
@pytest.mark.parametrize("words", [["import"], []])
def test_nothing_is_written_where_a_file_is_refused(
    text: str | None, code: int, words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    if text is not None:
        Path("arm.urdf").write_text(text, encoding="utf-8")
    assert main([*words, "arm.urdf"]) == code
    assert capsys.readouterr().err.startswith("arm.urdf:")
    assert [path.name for path in Path().iterdir()] == (["arm.urdf"] if text is not None else [])


@pytest.mark.parametrize("word", ["x", "-1", "nan", "inf", "0.5"])
def test_a_tolerance_is_a_small_number(word: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["import", str(UR5), f"--snap={word}"])
    assert stopped.value.code == 2
    assert "must be a number from 0 to 0.01" in capsys.readouterr().err


def test_a_urdf_stands_in_for_a_robot_file(capsys: pytest.CaptureFixture[str]) -> None:
    shutil.copy(FILES / "scara.urdf", "no_ending_at_all")
    assert main(["explain", "no_ending_at_all"]) == 0
    told = capsys.readouterr()
    assert "Source of the numbers: URDF no_ending_at_all, poses of shaft in base." in told.out
    assert told.err.startswith("note: no_ending_at_all: frames beside the arm: camera")


def test_notes_are_about_the_file_that_the_user_has() -> None:
    file = RobotFile.read(UR5)
    assert {notice.file for notice in file.robot.notices} == {str(UR5)}
    assert any("taken as exact" in notice.message for notice in file.robot.notices)

"""`dhgen.load`: the same robots and the same refusals as the command's."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dhgen
from dhgen.cli import main
from tests.descriptions.reference import FILES
from tests.library.arms import PLANAR

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
UR5, PANDA, IIWA = FILES / "ur5.urdf", FILES / "panda.urdf", FILES / "iiwa14.urdf"
TWO_ARMS = """\
<robot name="two">
  <link name="body"/>
  {}
</robot>
"""
ARM = """\
<link name="{0}_upper"/><link name="{0}_fore"/>
<joint name="{0}_shoulder" type="continuous"><parent link="body"/><child link="{0}_upper"/></joint>
<joint name="{0}_elbow" type="continuous"><parent link="{0}_upper"/><child link="{0}_fore"/>
  <origin xyz="0.3 0 0"/></joint>
"""


def test_any_input_is_the_robot_that_the_command_makes_of_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["import", str(UR5), "--out", "-"]) == 0
    arm = dhgen.load(str(UR5))
    assert arm.text == capsys.readouterr().out
    Path("ur5.yaml").write_text(arm.text, encoding="utf-8")
    assert dhgen.load(Path("ur5.yaml")).text == arm.text
    q = np.random.default_rng(1).uniform(-3, 3, (5, 6))
    np.testing.assert_array_equal(dhgen.load("ur5.yaml").fk(q), arm.fk(q))


def test_a_dict_is_the_robot_of_the_file_with_its_keys(tmp_path: Path) -> None:
    path = tmp_path / "planar.yaml"
    path.write_text(json.dumps(PLANAR), encoding="utf-8")  # JSON is YAML
    of_file, of_dict = dhgen.load(path), dhgen.load(PLANAR)
    assert of_dict.file.robot == of_file.file.robot
    path.write_text(of_dict.text, encoding="utf-8")
    assert dhgen.load(path).file.robot == of_file.file.robot


@pytest.mark.parametrize(
    ("source", "options", "words"),
    [
        (UR5, {"base": "base_link", "tip": "wrist_2_link"}, "--base base_link --tip wrist_2_link"),
        (UR5, {"axes": True, "snap": 0}, "--axes --snap 0"),
        (PANDA, {"free": [7]}, "--free 7"),
        (PANDA, {"free": np.array([1, 2])}, "--free 1,2"),
        (PANDA, {"free": []}, "--free none"),
        (IIWA, {"free": "arm_angle"}, "--free arm_angle"),
    ],
)
def test_options_are_those_of_the_import(
    source: Path, options: dict[str, Any], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["import", str(source), *words.split(), "--out", "-"]) == 0
    imported = capsys.readouterr()
    arm = dhgen.load(source, **options)
    assert arm.text == imported.out
    told = (note.replace(f"{source}: ", "") for note in arm.notes)
    assert "".join(f"note: {note}\n" for note in told) == imported.err


@pytest.mark.parametrize(
    "name",
    ["missing.urdf", "missing.yaml", "broken.yaml", "broken.urdf", "two.urdf", "keys.yaml", "."],
)
def test_refusals_have_the_text_of_the_command(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("broken.yaml").write_text("name: x\njoints:\n  - {theta: q, d: [\n")
    Path("broken.urdf").write_text("<robot name='x'><link name='a'></robot>")
    Path("two.urdf").write_text(TWO_ARMS.format(ARM.format("left") + ARM.format("right")))
    Path("keys.yaml").write_text("nmae: arm\njonts: []\n")
    assert main([name]) == 2
    with pytest.raises(dhgen.RobotFileError) as refused:
        dhgen.load(name)
    assert f"{refused.value}\n" == capsys.readouterr().err


def test_of_two_arms_one_is_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "two.urdf"
    path.write_text(TWO_ARMS.format(ARM.format("left") + ARM.format("right")))
    with pytest.raises(dhgen.RobotFileError, match=r"(?s)left_fore.*right_fore"):
        dhgen.load(path)
    assert dhgen.load(path, tip="right_fore").joint_names == ("right_shoulder", "right_elbow")


@pytest.mark.parametrize(
    ("source", "options", "told"),
    [
        (ROBOTS / "ur5.yaml", {"tip": "x"}, "tip is for robot descriptions (URDF, xacro, MJCF)"),
        (PLANAR, {"base": "a", "free": [1]}, "base, free are for robot descriptions"),
        (UR5, {"snap": 0.5}, "snap must be a number from 0 to 0.01, not 0.5"),
        (UR5, {"free": 7}, "free takes numbers of joints, as [7], or 'arm_angle', not 7"),
        (UR5, {"free": "7"}, "free takes numbers of joints, as [7], or 'arm_angle', not '7'"),
        (UR5, {"base": 3}, "base takes the name of a link, not 3"),
        (UR5, {"tip": ["a"]}, "tip takes the name of a link, not ['a']"),
        (UR5, {"package": "x"}, "package takes a dict of names and values, not 'x'"),
        (UR5, {"arg": "len:=1"}, "arg takes a dict of names and values, not 'len:=1'"),
        ("<robot name='x'/>", {}, "load takes a path, not the text of a description"),
    ],
)
def test_options_that_make_no_sense_are_refused(
    source: Any, options: dict[str, Any], told: str
) -> None:
    with pytest.raises(dhgen.CommandError, match=re.escape(told)):
        dhgen.load(source, **options)


@pytest.mark.parametrize("free", [[8], [0], [7, 1], [3, 3]])
def test_joints_that_are_none_can_not_be_free(
    free: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(dhgen.RobotFileError, match=r"can't be free: .* has joints 1 to 7"):
        dhgen.load(PANDA, free=free)
    assert main(["import", str(PANDA), "--free", ",".join(map(str, free)), "--out", "-"]) == 2
    assert "can't be free" in capsys.readouterr().err


def test_an_arm_angle_is_for_seven_joints(capsys: pytest.CaptureFixture[str]) -> None:
    told = "free: arm_angle is for arms of 7 joints; this one has 6"
    with pytest.raises(dhgen.RobotFileError, match=told):
        dhgen.load(UR5, free="arm_angle")
    assert main(["import", str(UR5), "--free", "arm_angle", "--out", "-"]) == 2
    assert told in capsys.readouterr().err


def test_why_an_arm_is_not_solved_is_told_with_its_notes() -> None:
    lengths = {"a1": 0.4, "a2": 0.3, "a3": 1.0}
    four = {**PLANAR, "joints": PLANAR["joints"] * 2, "parameters": lengths}
    arm = dhgen.load(four)
    with pytest.raises(dhgen.UnsolvedError) as refused:
        arm.build()
    told = str(refused.value)
    assert told.startswith("two_links: the arm has infinitely many solutions")
    assert "under `free`" in told
    note, in_python = refused.value.__notes__
    assert in_python == "in Python:\n    dhgen.load(..., numerical=True)"
    assert note.startswith("note: parameters.a3: no cell uses the parameter 'a3'")


def test_numerical_is_what_the_command_means_by_it() -> None:
    three = {**PLANAR, "joints": [*PLANAR["joints"], {"theta": "q", "a": 0.2}]}
    assert "damped least squares" in dhgen.load(three, numerical=True).derivation()


@pytest.mark.parametrize("path", ["arm\0.yaml", "arm\0.urdf", "arm\0"])
def test_what_no_file_can_be_called_is_a_file_that_can_not_be_read(path: str) -> None:
    with pytest.raises(dhgen.errors.RobotFileError, match="the file can't be read"):
        dhgen.load(path)

"""xacro and MJCF, by packages that are optional: without them a file is refused with what to do."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.cli import main
from dhgen.descriptions.expand import Outside
from dhgen.descriptions.files import import_file
from dhgen.descriptions.forward import robot_pose
from dhgen.descriptions.wishes import Wishes
from dhgen.errors import RobotFileError
from tests.descriptions.reference import FILES

if TYPE_CHECKING:
    from dhgen.descriptions.convert import Import

XACRO = """\
<?xml version="1.0"?>
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="reach" default="0.3"/>
  <xacro:include filename="$(find parts)/parts.xacro"/>
  <link name="base"/>
  <xacro:link_of name="one" on="base" length="0.4"/>
  <xacro:link_of name="two" on="one" length="$(arg reach)"/>
</robot>
"""
PARTS = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="link_of" params="name on length">
    <link name="${name}"/>
    <joint name="${name}_joint" type="continuous">
      <parent link="${on}"/><child link="${name}"/><axis xyz="0 0 1"/>
      <origin xyz="${2*length} 0 0" rpy="${pi/2} 0 0"/>
    </joint>
  </xacro:macro>
</robot>
"""
MJCF = """\
<mujoco model="arm">
  <compiler angle="degree" eulerseq="zyx"/>
  <default><joint axis="0 1 0"/></default>
  <worldbody>
    <body name="base" pos="0.1 0 0.2">
      <body name="upper" pos="0 0 0.3" euler="30 0 90">
        <joint name="pan" axis="0 0 2" range="-90 180" limited="true"/>
        <joint name="lift" pos="0 0.05 0.1" ref="20"/>
        <geom size="0.1"/>
        <body name="lower" pos="0.4 0 0" quat="0.7071067811865476 0 0.7071067811865476 0">
          <joint name="slide" type="slide" axis="1 0 0" range="0 0.5" limited="true" ref="0.1"/>
          <geom size="0.1"/>
          <body name="wrist" pos="0 0 0.2">
            <joint name="roll" pos="0 0.03 0" axis="1 1 0"/>
            <geom size="0.1"/>
            <site name="tcp" pos="0 0 0.1" euler="0 0 45"/>
          </body>
        </body>
      </body>
    </body>
  </worldbody>
</mujoco>
"""


def imported(path: Path, **outside: dict[str, str]) -> Import:
    return import_file(path, Wishes(), Outside(**outside))  # type: ignore[arg-type]


@pytest.fixture
def xacro(tmp_path: Path) -> Path:
    """A file whose macros are in a package beside it."""
    path = tmp_path / "robots" / "arm.urdf.xacro"
    for folder in ("robots", "parts"):
        (tmp_path / folder).mkdir()
    path.write_text(XACRO, encoding="utf-8")
    (tmp_path / "parts" / "parts.xacro").write_text(PARTS, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("text", "package", "extra"), [(XACRO, "xacrodoc", "xacro"), (MJCF, "mujoco", "mjcf")]
)
def test_what_is_not_installed_is_told(
    text: str,
    package: str,
    extra: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    monkeypatch.chdir(tmp_path)
    Path("arm.xml").write_text(text, encoding="utf-8")
    assert main(["import", "arm.xml"]) == 2
    told = capsys.readouterr().err
    assert f", which needs {package}: pip install 'dhgen[{extra}]'" in told
    assert list(Path().iterdir()) == [Path("arm.xml")]


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--package", "parts"], "write NAME=VALUE, not 'parts'"),
        (["--arg", "reach=1"], "write NAME:=VALUE, not 'reach=1'"),
    ],
)
def test_pairs_are_written_as_ros_does(
    words: list[str], told: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        main(["import", "arm.xacro", *words])
    assert told in capsys.readouterr().err


def test_a_xacro_s_entities_are_refused_before_it_is_expanded(tmp_path: Path) -> None:
    path = tmp_path / "arm.xacro"
    path.write_text(f'<!DOCTYPE r [<!ENTITY a "b">]>\n{XACRO[22:]}', encoding="utf-8")
    with pytest.raises(RobotFileError, match="a robot description has no DOCTYPE"):
        imported(path)


def test_what_an_expanded_file_holds_for_others_needs_no_xacro(tmp_path: Path) -> None:
    text = (FILES / "scara.urdf").read_text(encoding="utf-8")
    left = (
        "<!-- <xacro:include/> --><gazebo><plugin>$(find a)/b.yaml ${c}</plugin></gazebo></robot>"
    )
    path = tmp_path / "arm.urdf"
    path.write_text(text.replace("</robot>", left), encoding="utf-8")
    assert imported(path).robot.name == "epson_t3"


def test_packages_of_a_xacro_are_found_beside_it(xacro: Path) -> None:
    pytest.importorskip("xacrodoc")
    result = imported(xacro)
    assert {p.value for p in result.robot.parameters} == {0.6, 0.8}
    assert result.robot.source == "xacro arm.urdf.xacro, poses of two in base"


def test_arguments_and_packages_of_a_xacro_are_what_is_said(xacro: Path, tmp_path: Path) -> None:
    pytest.importorskip("xacrodoc")
    (tmp_path / "parts").rename(tmp_path / "robots" / "other")
    with pytest.raises(RobotFileError, match="package 'parts', which is nowhere above"):
        imported(xacro)
    folder = str(tmp_path / "robots" / "other")
    result = imported(xacro, packages={"parts": folder}, arguments={"reach": "0.5"})
    assert {p.value for p in result.robot.parameters} == {0.8, 1.0}


def test_mistakes_of_a_xacro_are_told(tmp_path: Path) -> None:
    pytest.importorskip("xacrodoc")
    path = tmp_path / "arm.xacro"
    path.write_text(XACRO.replace("$(find parts)", "${1/0}"), encoding="utf-8")
    with pytest.raises(RobotFileError, match=r"arm.xacro: xacro stops: .*division by zero"):
        imported(path)


def test_mjcf_is_the_arm_that_mujoco_moves(tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    path = tmp_path / "arm.xml"
    path.write_text(MJCF, encoding="utf-8")
    result = imported(path)
    assert (result.chain.base, result.chain.tip) == ("base", "tcp")
    assert [joint.name for joint in result.chain.actuated] == ["pan", "lift", "slide", "roll"]
    assert result.difference.is_rounding
    assert "limits: [-90 deg, 180 deg]" in result.text
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    for q in np.random.default_rng(2).uniform(-2, 2, (20, 4)):
        data.qpos[:] = q
        mujoco.mj_kinematics(model, data)
        tip = np.eye(4)
        tip[:3, :3], tip[:3, 3] = data.site("tcp").xmat.reshape(3, 3), data.site("tcp").xpos
        tip[:3, 3] -= data.body("base").xpos  # whose axes are the world's
        assert np.abs(robot_pose(result.robot, q) - tip).max() < 1e-12


def test_mistakes_of_an_mjcf_are_told(tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    path = tmp_path / "arm.xml"
    path.write_text(MJCF.replace('pos="0 0 0.3"', 'pos="0 0"'), encoding="utf-8")
    with pytest.raises(RobotFileError, match="MuJoCo can't compile this"):
        imported(path)


def test_a_ball_joint_in_an_arm_is_refused_and_one_before_it_is_left_out(tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    path = tmp_path / "arm.xml"
    path.write_text(MJCF.replace('name="lift" pos', 'type="ball" name="lift" pos'), "utf-8")
    with pytest.raises(RobotFileError, match="a ball joint is between base and tip, lift: start"):
        imported(path)
    base = '<body name="base" pos="0.1 0 0.2">'
    first = MJCF.replace(base, f'{base}<joint name="neck" type="ball"/><geom size="0.1"/>')
    path.write_text(first, "utf-8")
    result = imported(path)
    assert "left out: the ball joint neck, before the arm's base" in result.notes
    assert [joint.name for joint in result.chain.actuated] == ["pan", "lift", "slide", "roll"]


def test_arguments_that_a_xacro_does_not_ask_for_are_told(xacro: Path) -> None:
    pytest.importorskip("xacrodoc")
    told = "not read: argument 'raech', which this xacro doesn't ask for: it asks for 'reach'"
    result = imported(xacro, arguments={"raech": "0.5"})
    assert result.notes[0] == told
    assert {p.value for p in result.robot.parameters} == {0.6, 0.8}
    assert imported(xacro, arguments={"reach": "0.5", "raech": "1"}).notes[0] == told
    assert not any("argument" in note for note in imported(xacro, arguments={"reach": "0.5"}).notes)


def test_a_file_that_is_no_xacro_has_no_arguments() -> None:
    arguments = {"reach": "1", "b": "2"}
    note, *_ = imported(FILES / "ur5.urdf", arguments=arguments).notes
    assert note == "not read: arguments 'reach', 'b': a xacro has arguments, and this is none"

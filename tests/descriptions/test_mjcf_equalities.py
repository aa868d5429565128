"""Joints of an MJCF that equalities move, closed chains, and names that nobody gave."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.descriptions.expand import Outside
from dhgen.descriptions.files import import_file
from dhgen.descriptions.forward import robot_pose
from dhgen.descriptions.wishes import Wishes
from dhgen.errors import RobotFileError

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from dhgen.arrays import FloatArray
    from dhgen.descriptions.convert import Import

ARM = """\
<mujoco model="arm">
  <compiler angle="radian"/>
  <worldbody>
    <body name="turret" pos="0 0 0.3"><geom size="0.1"/><joint name="pan" axis="0 0 1"/>
      <body name="upper"><geom size="0.1"/><joint name="lift" axis="0 1 0" ref="0.2"/>
        <body name="lower" pos="0.1 0 0.4"><geom size="0.1"/>
          <joint name="elbow" axis="0 1 0" ref="-0.5"/>
          <body name="hub" pos="0.3 0 0"><geom size="0.1"/><joint name="roll" axis="1 0 0"/>
            <site name="tcp" pos="0.1 0 0"/>
          </body>
        </body>
      </body>
    </body>
    PLACE
  </worldbody>
  <equality>EQUALITY</equality>
</mujoco>
"""
JOINTS = ["pan", "lift", "elbow", "roll"]


@pytest.fixture
def mjcf(tmp_path: Path) -> Callable[..., Path]:
    """Writes an MJCF."""
    pytest.importorskip("mujoco")

    def write(equality: str = "", place: str = "", arm: str = ARM) -> Path:
        path = tmp_path / "arm.xml"
        text = arm.replace("EQUALITY", equality).replace("PLACE", place)
        path.write_text(text, encoding="utf-8")
        return path

    return write


def imported(path: Path) -> Import:
    return import_file(path, Wishes(), Outside())


def tip_by_mujoco(path: Path, values: dict[str, float]) -> FloatArray:
    mujoco: Any = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    for name, value in values.items():
        data.joint(name).qpos = value
    mujoco.mj_kinematics(model, data)
    tip = np.eye(4)
    tip[:3, :3], tip[:3, 3] = data.site("tcp").xmat.reshape(3, 3), data.site("tcp").xpos
    return tip


def test_a_joint_that_an_equality_moves_has_no_drive(mjcf: Callable[..., Path]) -> None:
    path = mjcf('<joint joint1="elbow" joint2="lift" polycoef="0.1 -1 0 0 0"/>')
    result = imported(path)
    assert [joint.name for joint in result.chain.actuated] == ["pan", "lift", "roll"]
    for pan, lift, roll in np.random.default_rng(1).uniform(-3, 3, (20, 3)):
        elbow = -0.5 + 0.1 - (lift - 0.2)  # each counts from where the file shows it
        values = dict(zip(JOINTS, (pan, lift, elbow, roll), strict=True))
        off = robot_pose(result.robot, np.array([pan, lift, roll])) - tip_by_mujoco(path, values)
        assert np.abs(off).max() < 1e-12


def test_a_joint_that_an_equality_holds_does_not_move(mjcf: Callable[..., Path]) -> None:
    path = mjcf('<joint joint1="elbow" polycoef="0.3 0 0 0 0"/>')
    result = imported(path)
    assert [joint.name for joint in result.chain.actuated] == ["pan", "lift", "roll"]
    for pan, lift, roll in np.random.default_rng(1).uniform(-3, 3, (20, 3)):
        values = dict(zip(JOINTS, (pan, lift, -0.2, roll), strict=True))
        off = robot_pose(result.robot, np.array([pan, lift, roll])) - tip_by_mujoco(path, values)
        assert np.abs(off).max() < 1e-12


@pytest.mark.parametrize("coefficients", ["0 1 0.5 0 0", "0 1 0 0 0.2"])
def test_an_equality_of_higher_powers_is_refused(
    mjcf: Callable[..., Path], coefficients: str
) -> None:
    path = mjcf(f'<joint joint1="elbow" joint2="lift" polycoef="{coefficients}"/>')
    with pytest.raises(RobotFileError, match=r"'elbow' follows 'lift' .*by higher powers"):
        imported(path)


def test_an_equality_that_is_off_moves_nothing(mjcf: Callable[..., Path]) -> None:
    result = imported(mjcf('<joint joint1="elbow" joint2="lift" active="false"/>'))
    assert [joint.name for joint in result.chain.actuated] == JOINTS


@pytest.mark.parametrize(
    ("equality", "caught"),
    [
        ('<connect body1="hub" body2="upper" anchor="0 0 0"/>', "elbow, roll"),
        ('<weld body1="lower"/>', "pan, lift, elbow"),
        ('<connect site1="tcp" site2="post"/>', "pan, lift, elbow, roll"),
        ('<weld body1="hub" body2="handle"/>', ""),  # moved by the user's mouse
        ('<weld body1="lower" active="false"/>', ""),
    ],
)
def test_closed_chains_are_told(mjcf: Callable[..., Path], equality: str, caught: str) -> None:
    place = '<site name="post"/><body name="handle" mocap="true"/>'
    notes = [note for note in imported(mjcf(equality, place)).notes if "closed chain" in note]
    assert len(notes) == bool(caught)
    assert all(note.endswith(f"a closed chain with {caught} in it") for note in notes)


def test_what_has_no_name_gets_one_that_nothing_has(mjcf: Callable[..., Path]) -> None:
    arm = ARM.replace('name="elbow" ', "").replace('"roll"', '"joint3"')
    arm = arm.replace('name="lower"', "").replace('"hub"', '"body3"')
    result = imported(mjcf(arm=arm))
    assert [joint.name for joint in result.chain.actuated] == ["pan", "lift", "joint3_", "joint3"]
    assert result.chain.tip == "tcp"

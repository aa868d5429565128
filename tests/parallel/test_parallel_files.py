"""A robot file with legs: what it may hold, all mistakes at their places, and the count."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.errors import RobotFileError
from dhgen.legs.mobility import counted, faults
from dhgen.legs.read import PLANE, POSE, POSITION, TURNED_PLANE
from dhgen.robot.load import load
from dhgen.robot_files import ParallelFile, read_file
from tests.serial import ROBOTS

if TYPE_CHECKING:
    from pathlib import Path

TWO = """\
name: two
legs:
  - base: {xyz: [-0.1, 0, 0]}
    joints:
      - {theta: q, a: 0.2}
      - {theta: q, a: 0.3}
    actuated: [1]
    point: [0, 0, 0]
  - base: {xyz: [0.1, 0, 0]}
    joints:
      - {theta: q, a: 0.2}
      - {theta: q, a: 0.3}
    actuated: [1]
    point: [0, 0, 0]
task: [x, y]
"""


def read(text: str, folder: Path) -> ParallelFile:
    path = folder / "two.yaml"
    path.write_text(text, encoding="utf-8")
    file = read_file(path)
    assert isinstance(file, ParallelFile)
    return file


def mistakes(text: str, folder: Path) -> list[str]:
    with pytest.raises(RobotFileError) as refused:
        read(text, folder)
    return [f"{each.line}:{each.column} {each.message}" for each in refused.value.diagnostics]


def test_legs_that_are_alike_share_a_chain(tmp_path: Path) -> None:
    robot = read(TWO, tmp_path).robot
    assert [leg.chain.name for leg in robot.legs] == ["two_leg", "two_leg"]
    assert robot.legs[0].base[3] == -0.1
    other = read(TWO.replace("a: 0.3}", "a: 0.3, limits: [-3, 3]}", 1), tmp_path).robot
    assert [chain.name for chain in other.chains] == ["two_leg1", "two_leg2"]


def test_a_leg_is_turned_about_z_on_the_base_and_on_the_platform(tmp_path: Path) -> None:
    text = TWO.replace(
        "    point: [0, 0, 0]\n", "    point: [0.2, 0, 0]\n    turned: [0, 90 deg]\n"
    )
    legs = read(text.split("  - base: {xyz: [0.1")[0] + "task: [x, y]\n", tmp_path).robot.legs
    np.testing.assert_allclose(np.reshape(legs[1].base, (3, 4))[:, 3], [0, -0.1, 0], atol=1e-16)
    np.testing.assert_allclose(np.reshape(legs[1].end, (3, 4))[:, 3], [0, 0.2, 0], atol=1e-16)
    np.testing.assert_allclose(np.reshape(legs[1].base, (3, 4))[:2, 0], [0, 1], atol=1e-16)


def test_all_mistakes_are_told_at_once(tmp_path: Path) -> None:
    text = TWO.replace("a: 0.2}", "a: 0.2x}", 1).replace("actuated: [1]", "actuated: [3]", 1)
    text = text.replace("    point: [0, 0, 0]\ntask", "    ponit: [0, 0, 0]\ntask")
    text = text.replace("task: [x, y]", "task: orientation")
    text += "free: [1]\n"
    told = mistakes(text, tmp_path)
    assert [each.split()[0] for each in told] == ["5:23", "7:16", "14:5", "15:7", "16:1"]
    assert "there is no joint 3: joints are numbered from 1 to 2" in told[1]
    assert "unknown key 'ponit'; did you mean 'point'?" in told[2]
    assert "the task of a robot with legs is one of pose, position, [x, y, yaw]" in told[3]
    assert "'free' is for serial robots: this one has legs" in told[4]


def test_what_a_leg_carries_is_asked_for_beside_its_other_mistakes(tmp_path: Path) -> None:
    left_out = TWO.replace("actuated: [1]\n    point: [0, 0, 0]", "actuated: 1", 1)
    carried, number = mistakes(left_out, tmp_path)
    assert "a leg carries a point or a frame of the platform: write one of the two" in carried
    assert "expected a list of joints, e.g. [1], not '1'" in number


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("    point: [0, 0, 0]\n", "", "a leg carries a point or a frame of the platform"),
        ("    point: [0, 0, 0]\n", "    frame: {}\n", "names no orientation"),
        ("actuated: [1]", "actuated: [1, 2]", "3 joints are driven"),
        ("task: [x, y]", "task: orientation", "the task of a robot with legs is one of"),
        ("base: {xyz: [0.1", "base: {rpy: [0.1, 0, 0], xyz: [0.1", "z of this base has to be"),
        ("actuated: [1]", "actuated: [2, 1]", "in ascending order"),
        ("actuated: [1]", "actuated: []", "a leg has one driven joint at least"),
        ("      - {theta: q, a: 0.3}\n", "", "M = 1 + 2 - 2*1 = 1, less than the 2"),
        ("task: [x, y]\n", "", "the task names); without `task` it is the whole pose"),
        ("xyz: [0.1", "xyz: [-0.1", "legs 1 and 2 are the same in the same place"),
    ],
)
def test_what_is_refused(old: str, new: str, told: str, tmp_path: Path) -> None:
    found = mistakes(TWO.replace(old, new, 1), tmp_path)
    assert any(told in each for each in found), found


def test_what_follows_from_a_mistake_is_none(tmp_path: Path) -> None:
    """No joints of a leg whose table can't be read, no drives of a platform that can't move so."""
    (told,) = mistakes(TWO.replace("      - {theta: q, a: 0.3}\n", "", 1), tmp_path)
    assert "less than the 2" in told
    unread = TWO.replace(
        "      - {theta: q, a: 0.2}\n      - {theta: q, a: 0.3}\n", "      - {}\n", 1
    )
    assert not any("numbered from 1 to 0" in each for each in mistakes(unread, tmp_path))
    torn = TWO.replace("{theta: q, a: 0.2}", "{theta: 5, a: 0.2}", 1)
    torn = torn.replace("actuated: [1]", "actuated: [2]", 1)
    assert [each[:3] for each in mistakes(torn, tmp_path)] == ["5:9"]


SLIDE = "the plane of x and y that the task names"


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_a_slide_out_of_the_plane_is_told_with_what_to_write(
    convention: str, tmp_path: Path
) -> None:
    text = f"convention: {convention}\n" + TWO.replace("{theta: q, a: 0.2}", "{d: q}", 1)
    (told,) = mistakes(text, tmp_path)
    assert told.startswith("6:9 this joint slides along z, out of")
    assert "begins with a slide in the plane is written with `axes`" in told
    second = f"convention: {convention}\n" + TWO.replace("{theta: q, a: 0.3}", "{d: q}", 1)
    assert [each[:3] for each in mistakes(second, tmp_path)] == ["7:9"]
    alpha = 1 if convention == "modified" else 0
    rows = ["{theta: q, alpha: 90 deg}", "{d: q}"]
    rows = ["{theta: q}", "{d: q, alpha: 90 deg}"] if alpha else rows
    right = TWO
    for old, new in zip(("{theta: q, a: 0.2}", "{theta: q, a: 0.3}"), rows, strict=True):
        right = right.replace(old, new, 1)
    assert len(read(f"convention: {convention}\n{right}", tmp_path).robot.legs) == 2


def test_so_is_one_by_axes(tmp_path: Path) -> None:
    axes = """\
    axes:
      - {type: prismatic, direction: [0, 0, 1]}
      - {type: revolute, direction: [0, 0, 1], point: [0, 0, 0]}
    home: {xyz: [0.3, 0, 0]}
"""
    rows = "    joints:\n      - {theta: q, a: 0.2}\n      - {theta: q, a: 0.3}\n"
    (told,) = mistakes(TWO.replace(rows, axes, 1), tmp_path)
    assert told == f"5:9 this joint slides along z, out of {SLIDE}"
    flat = axes.replace("prismatic, direction: [0, 0, 1]", "prismatic, direction: [1, 0, 0]")
    assert len(read(TWO.replace(rows, flat, 1), tmp_path).robot.legs) == 2


def test_the_count_is_told() -> None:
    assert counted(POSE, [3] * 6, [True] * 6, 6).text == "M = 6 + 6 + 6 + 6 + 6 + 6 - 6*5 = 6"
    assert counted(TURNED_PLANE, [2, 2, 2], [True] * 3, 3).text == "M = 3 + 3 + 3 - 3*2 = 3"
    assert counted(POSITION, [3, 3, 3], [True] * 3, 3).text == "M = 3 + 3 + 3 - 3*2 = 3"
    assert faults(counted(PLANE, [2, 2], [True, True], 2)) == []
    assert "more than the 2" in faults(counted(PLANE, [2, 3], [True, True], 3))[0]
    uneven = faults(counted(PLANE, [1, 3], [True, True], 2))
    assert len(uneven) == 1
    assert "leg 1 has 1 freedoms where the task names 2" in uneven[0]


def test_who_loads_a_serial_arm_is_told_of_legs() -> None:
    with pytest.raises(RobotFileError, match="a robot with legs is a parallel one"):
        load(ROBOTS / "five_bar.yaml")

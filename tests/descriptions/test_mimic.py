"""Joints of a URDF that follow others (mimic): coupled drives, passive rows, or the reason."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.descriptions.convert import convert
from dhgen.descriptions.urdf import read_urdf
from dhgen.descriptions.wishes import Wishes
from dhgen.errors import RobotFileError
from dhgen.kinematics.build import build_chain
from dhgen.oracle.forward import forward
from dhgen.paul.derive import derive
from dhgen.robot.load import load_text
from dhgen.robot.robot import DhTable

if TYPE_CHECKING:
    from dhgen.descriptions.convert import Import

UPPER, FORE, HAND, DOWN = 0.8, 0.7, 0.15, 0.2


def joint(name: str, parent: str, child: str, words: str = "", *, mimic: str = "") -> str:
    """A joint that turns about y unless it is told otherwise."""
    kind, axis, xyz = "revolute", "0 1 0", "0 0 0"
    for word in words.split(","):
        key, _, value = word.partition("=")
        kind = value if key == "type" else kind
        axis = value if key == "axis" else axis
        xyz = value if key == "xyz" else xyz
    follows = f"<mimic joint={mimic}/>" if mimic else ""
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{xyz}"/><axis xyz="{axis}"/><limit lower="-2" upper="2"/>{follows}</joint>'
    )


def imported(*joints: str, **wishes: object) -> Import:
    links = [f'<link name="{name}"/>' for name in (*(f"l{number}" for number in range(9)), "tool0")]
    used = [link for link in links if any(link.split('"')[1] in each for each in joints)]
    text = f'<robot name="arm">{"".join(used)}{"".join(joints)}</robot>'
    return convert(read_urdf(text.encode(), "arm.urdf"), Wishes(**wishes))  # type: ignore[arg-type]


PALLETIZER = (
    joint("turn", "l0", "l1", "axis=0 0 1,xyz=0 0 0.5"),
    joint("upper", "l1", "l2", "xyz=0.2 0 0"),
    joint("rods", "l2", "l3", f"xyz={UPPER} 0 0", mimic='"upper" multiplier="-1"'),
    joint("fore", "l3", "l4", "axis=0 -1 0"),
    joint("level", "l4", "l5", f"xyz={FORE} 0 0", mimic='"fore" multiplier="1" offset="0.1"'),
    joint("hand", "l5", "l6", f"axis=0 0 1,xyz={HAND} 0 -{DOWN}"),
)


def test_a_palletizer_has_a_coupled_and_a_passive_row() -> None:
    """The rods about the elbow's axis are no row of their own: the forearm follows both drives."""
    made = imported(*PALLETIZER, tip="l6")
    assert made.difference.is_rounding
    assert [each.name for each in made.robot.joints] == ["turn", "upper", "fore", "hand"]
    geometry = made.robot.geometry
    assert isinstance(geometry, DhTable)
    assert [len(row.couplings) for row in geometry.rows] == [0, 0, 1, 1, 0]
    assert [bool(row.sign) for row in geometry.rows] == [True, True, True, False, True]
    q = np.random.default_rng(1).uniform(-2.0, 2.0, (50, 4))
    turn, upper, fore, _ = q.T
    lift = 0.1  # the level joint turns back by what the drive has turned, and a little more
    reach = UPPER * np.cos(upper) + FORE * np.cos(fore)
    height = -UPPER * np.sin(upper) + FORE * np.sin(fore)
    reach += HAND * np.cos(lift) - DOWN * np.sin(lift)
    height += -HAND * np.sin(lift) - DOWN * np.cos(lift)
    reached = forward(made.robot, q)[:, :3, 3]
    expected = [(0.2 + reach) * np.cos(turn), (0.2 + reach) * np.sin(turn), 0.5 + height]
    np.testing.assert_allclose(reached.T, expected, atol=1e-12)


def test_an_imported_palletizer_is_solved() -> None:
    """For the tool's place and yaw, once it is level."""
    level = [each.replace(' offset="0.1"', "") for each in PALLETIZER]
    text = f"{imported(*level, tip='l6').text}task: [x, y, z, yaw]\n"
    chain = build_chain(load_text(text, "arm.yaml"))
    assert len(chain.passive) == 1
    assert derive(chain).branches == 4


def test_the_stages_of_a_telescope_are_passive() -> None:
    stage = "type=prismatic,axis=1 0 0"
    made = imported(
        joint("turn", "l0", "l1", "axis=0 0 1"),
        joint("lift", "l1", "l2", "xyz=0.1 0 0.3"),
        joint("one", "l2", "l3", stage),
        joint("bow", "l3", "l4", "axis=0 0 1"),
        joint("two", "l4", "l5", stage, mimic='"one" multiplier="2" offset="0.05"'),
        tip="l5",
    )
    geometry = made.robot.geometry
    assert isinstance(geometry, DhTable)
    assert [bool(row.sign) for row in geometry.rows] == [True, True, True, True, False]
    assert [each.value for each in geometry.rows[4].couplings] == [2.0]
    assert made.difference.is_rounding


def test_gears_about_one_axis_are_ratios() -> None:
    made = imported(
        joint("turn", "l0", "l1", "axis=0 0 1"),
        joint("upper", "l1", "l2"),
        joint("gear", "l2", "l3", "xyz=0.5 0 0", mimic='"upper" multiplier="-1.5"'),
        joint("fore", "l3", "l4"),
        joint("end", "l4", "l5", "type=fixed,xyz=0.4 0 0"),
        tip="l5",
    )
    assert "3/2*q2" in made.text
    assert made.difference.is_rounding


def test_a_drive_keeps_the_limits_of_what_follows_it() -> None:
    """The follower turns by 0.1 - 2 q: in -1 ... 1.5 for q in -0.7 ... 0.55."""
    narrow = joint("gear", "l2", "l3", "xyz=0.5 0 0", mimic='"upper" multiplier="-2" offset="0.1"')
    chain = (
        joint("turn", "l0", "l1", "axis=0 0 1"),
        joint("upper", "l1", "l2"),
        narrow.replace('lower="-2" upper="2"', 'lower="-1" upper="1.5"'),
        joint("fore", "l3", "l4"),
        joint("end", "l4", "l5", "type=fixed,xyz=0.4 0 0"),
    )
    made = imported(*chain, tip="l5")
    assert made.difference.is_rounding
    limits = [each.limits for each in made.robot.joints]
    np.testing.assert_allclose(np.array(limits, float), [[-2.0, 2.0], [-0.7, 0.55], [-2.0, 2.0]])
    (note,) = (each for each in made.notes if "mimic" in each)
    assert note == "the limits of upper are narrower than its own: gear follows it (mimic)"


def test_limits_of_followers_that_exclude_those_of_the_drive_are_no_limits() -> None:
    apart = 'lower="5" upper="6"'
    gear = joint("gear", "l1", "l2", "xyz=0.5 0 0", mimic='"upper"')
    made = imported(
        joint("upper", "l0", "l1"),
        gear.replace('lower="-2" upper="2"', apart),
        joint("fore", "l2", "l3"),
        joint("end", "l3", "l4", "type=fixed,xyz=0.4 0 0"),
        tip="l4",
    )
    assert [each.limits for each in made.robot.joints] == [(-2.0, 2.0)] * 2
    assert any(each.startswith("the limits of gear exclude those of upper") for each in made.notes)


@pytest.mark.parametrize(
    ("mimic", "words", "reason"),
    [
        ('"upper" multiplier="0.5"', "", "0.5 times, which makes the equations of another degree"),
        ('"upper" multiplier="-2"', "", "2 times, which makes the equations of another degree"),
        ('"finger"', "", "which is no joint of this arm with a drive of its own"),
        ('"follower"', "", "which is no joint of this arm with a drive of its own"),
        ('"hand"', "", "which comes behind it"),
        ('"slide"', "", "an angle by a length or the other way round, which makes equations"),
        ('"slide" multiplier="0.5"', "type=prismatic,axis=0 0 1", "0.5 times: a stage of a"),
    ],
)
def test_what_no_robot_file_holds_is_refused_at_its_joint(
    mimic: str, words: str, reason: str
) -> None:
    chain = (
        joint("slide", "l0", "l1", "type=prismatic,axis=1 0 0"),
        joint("upper", "l1", "l2"),
        joint("fore", "l2", "l3", "xyz=0.5 0 0"),
        joint("follower", "l3", "l4", f"xyz=0.4 0 0,{words}", mimic=mimic),
        joint("hand", "l4", "l5", "axis=0 0 1,xyz=0.1 0 0"),
    )
    with pytest.raises(RobotFileError) as refused:
        imported(*chain, tip="l5")
    (mistake,) = refused.value.diagnostics
    followed = mimic.split('"')[1]
    assert mistake.message.startswith(f"'follower' follows '{followed}' (mimic), {reason}")
    assert mistake.message.endswith("end before it, --tip l3")
    assert mistake.line == 1
    assert len(imported(*chain[:3], tip="l3").robot.joints) == 3


def test_axes_hold_no_joints_that_follow_others() -> None:
    with pytest.raises(RobotFileError, match=r"which a table can say, and axes can't"):
        imported(*PALLETIZER, tip="l6", as_axes=True)


@pytest.mark.parametrize("word", ["multiplier", "offset"])
def test_numbers_that_are_none(word: str) -> None:
    with pytest.raises(RobotFileError, match="'twice' is not a number"):
        imported(joint("a", "l0", "l1"), joint("b", "l1", "l2", mimic=f'"a" {word}="twice"'))


LEVEL = (
    joint("turn", "l0", "l1", "axis=0 0 1"),
    joint("upper", "l1", "l2"),
    joint("fore", "l2", "l3", f"xyz={UPPER} 0 0"),
)
KEPT = joint("rods", "l3", "l4", f"xyz={FORE} 0 0", mimic='"fore" multiplier="-1"')


def test_a_tool_that_rods_hold_is_the_end_of_its_arm() -> None:
    """It turns back by what the forearm has turned, so that it leans as the upper arm does."""
    made = imported(*LEVEL, KEPT)
    assert made.chain.tip == "l4"
    assert made.notes == (
        "the tip is moved by the arm, too: rods follows fore (--tip l3 ends before)",
    )
    q = np.array([[0.0, 0.4, -0.9], [0.0, 0.4, 1.1]])
    np.testing.assert_allclose(forward(made.robot, q)[:, 2, 0], -np.sin([0.4, 0.4]), atol=1e-12)


@pytest.mark.parametrize(
    ("more", "told"),
    [
        # a frame says where the arm ends
        ((KEPT, joint("f", "l3", "tool0", "type=fixed")), "left out: l4 on l3, which follows fore"),
        # two ways lead on
        ((KEPT, KEPT.replace("l4", "l5").replace("rods", "cover")), "left out: l5 on l3, which"),
        # no row can hold it
        (
            (KEPT.replace('"-1"', '"-0.5"').replace("fore", "upper"),),
            "left out: l4 on l3, which follows upper",
        ),
        # no joint of the arm moves it
        ((joint("claws", "l3", "l4", mimic='"other"'), joint("other", "l1", "l5")), "left out: l4"),
    ],
)
def test_what_follows_the_arm_beside_its_end_is_left_out(more: tuple[str, ...], told: str) -> None:
    made = imported(*LEVEL, *more)
    assert made.chain.joints[-1].name == ("f" if "tool0" in "".join(more) else "fore")
    (note,) = (note for note in made.notes if note.startswith(told))
    assert ("--tip" in note) == ('"-1"' in "".join(more))


def test_followers_on_one_line_are_judged_together() -> None:
    """Two that turn against each other are no row, halves that add up to one are."""
    halves = [
        joint(name, *links, f"xyz={x} 0 0", mimic=f'"fore" multiplier="{factor}"')
        for factor in ("0.5", "-0.5")
        for name, links, x in (("a", ("l3", "l4"), FORE), ("b", ("l4", "l5"), 0))
    ]
    a, b, _, against = halves
    made = imported(*LEVEL, a, b)
    assert made.chain.tip == "l5"
    q = np.array([[0.0, 0.4, -0.9]])
    np.testing.assert_allclose(forward(made.robot, q)[:, 2, 0], -np.sin([0.4 - 1.8]), atol=1e-12)
    still = imported(*LEVEL, a, against)
    assert still.chain.tip == "l3"
    assert any("left out: l4" in note for note in still.notes)
    with pytest.raises(RobotFileError, match="with those on its line it stands still"):
        imported(*LEVEL, a, against, tip="l5")


def test_an_arm_that_begins_with_what_follows_another_is_told_where_to_start() -> None:
    """There is nothing before it at which it might end."""
    first = joint("lift", "l0", "l1", mimic='"leg"')
    with pytest.raises(RobotFileError) as stopped:
        imported(first, joint("turn", "l1", "l2"), joint("fore", "l2", "l3"))
    told = "'lift' follows 'leg' (mimic), which is no joint of this arm with a drive of its own"
    assert f"{told}: start behind it, --base l1" in str(stopped.value)
    again = imported(first, joint("turn", "l1", "l2"), joint("fore", "l2", "l3"), base="l1")
    assert [each.name for each in again.chain.joints] == ["turn", "fore"]


def test_stages_of_a_telescope_that_follow_the_first_are_a_row_of_their_own() -> None:
    """Three stages that go out as far as the first, on its line: in its own row d would be 4 q."""
    stage = "axis=1 0 0,type=prismatic,xyz=0.1 0 0"
    made = imported(
        joint("turn", "l0", "l1", "axis=0 0 1"),
        joint("first", "l1", "l2", stage),
        *(joint(f"s{n}", f"l{n}", f"l{n + 1}", stage, mimic='"first"') for n in (2, 3, 4)),
        joint("wrist", "l5", "l6", "axis=0 0 1"),
        joint("end", "l6", "l7", "type=fixed,xyz=0.2 0 0"),
        tip="l7",
    )
    assert [each.name for each in made.robot.joints] == ["turn", "first", "wrist"]
    assert made.difference.is_rounding
    reached = forward(made.robot, np.array([[0.0, 0.3, 0.0], [0.0, 0.5, 0.0]]))[:, 0, 3]
    np.testing.assert_allclose(reached, [0.4 + 4 * 0.3 + 0.2, 0.4 + 4 * 0.5 + 0.2], atol=1e-12)
    assert "d: 3*q2" in made.text
    assert derive(build_chain(made.robot)).branches

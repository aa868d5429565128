"""Which joints an import takes: the longest arm, to where a hand begins."""

from __future__ import annotations

import pytest

from dhgen.descriptions.chain import ArmChain, choose_chain
from dhgen.descriptions.urdf import read_urdf
from dhgen.errors import RobotFileError


def tree(*joints: str) -> str:
    """A URDF of joints written as 'parent child type name'."""
    split = [joint.split() for joint in joints]
    links = dict.fromkeys(link for words in split for link in words[:2])
    lines = [f'<link name="{link}"/>' for link in links]
    for parent, child, kind, *name in split:
        mimic = '<mimic joint="x"/>' if kind == "mimic" else ""
        motion = "revolute" if kind == "mimic" else kind
        called = name[0] if name else f"{child}_joint"
        lines.append(
            f'<joint name="{called}" type="{motion}"><parent link="{parent}"/>'
            f'<child link="{child}"/><origin xyz="0 0 1"/>{mimic}</joint>'
        )
    return f"<robot>{''.join(lines)}</robot>"


def chosen(text: str, base: str | None = None, tip: str | None = None) -> ArmChain:
    return choose_chain(read_urdf(text.encode(), "arm.urdf"), base, tip)


def refused(text: str, base: str | None = None, tip: str | None = None) -> str:
    with pytest.raises(RobotFileError) as stopped:
        chosen(text, base, tip)
    return str(stopped.value)


ARM = ("world base fixed", "base l1 revolute", "l1 l2 revolute", "l2 l3 prismatic")


@pytest.mark.parametrize(
    ("more", "ends"),
    [
        ((), "base l3"),
        (("l3 tool0 fixed", "l3 ee_link fixed"), "base tool0"),
        (("l3 flange fixed", "flange tool0 fixed"), "base tool0"),
        (("l3 mount fixed", "mount arm_flange fixed"), "base arm_flange"),
        (("l3 camera fixed",), "base l3"),
        (("l3 hand fixed", "hand tcp fixed"), "base l3"),
        (("l3 hand fixed", "hand left_finger prismatic", "hand right_finger mimic"), "base l3"),
        (("l3 gripper_base fixed", "gripper_base left_inner_knuckle revolute"), "base l3"),
        (("l3 l4 fixed finger_joint", "l4 l5 revolute"), "base l3"),
        # a wrist that turns what is called after the gripper on it
        (("l3 gripper revolute wrist_roll", "gripper jaw revolute gripper"), "base gripper"),
        (("l1 side revolute", "side eye revolute"), None),  # as long: to be asked for
        (("l1 eye revolute",), "base l3"),
        (("l3 l4 mimic",), "base l3"),
        (("base left_wheel continuous left_wheel_joint",), "base l3"),
    ],
)
def test_the_longest_arm_ends_before_its_hand(more: tuple[str, ...], ends: str | None) -> None:
    if ends is None:
        assert "2 chains have 3 moving joints" in refused(tree(*ARM, *more))
        return
    chain = chosen(tree(*ARM, *more))
    assert f"{chain.base} {chain.tip}" == ends


def test_two_arms_are_asked_for_with_what_to_say() -> None:
    text = tree("body l1 revolute", "l1 l2 revolute", "body r1 revolute", "r1 r2 revolute")
    told = refused(text)
    assert "\n    dhgen import arm.urdf --base body --tip l2\n" in told
    assert told.endswith("    dhgen import arm.urdf --base body --tip r2")
    chain = chosen(text, tip="r2")
    assert [joint.child for joint in chain.joints] == ["r1", "r2"]


def test_base_and_tip_are_what_is_said() -> None:
    text = tree(*ARM, "l3 tool0 fixed")
    assert len(chosen(text, base="l1").actuated) == 2
    assert chosen(text, base="world").base == "world"
    assert len(chosen(text, tip="l2").actuated) == 2
    assert chosen(text, base="world", tip="tool0").joints[0].child == "base"


@pytest.mark.parametrize(
    ("base", "tip", "told"),
    [
        ("ll1", None, "--base: there is no link 'll1'; did you mean 'l1'?"),
        (None, "tool", "--tip: there is no link 'tool'"),
        ("eye", "l3", "'eye' is not on the way to 'l3', which is 'world', 'base', 'l1', 'l2'"),
        ("l3", "l1", "'l3' is behind 'l1', not before it: exchange --base and --tip"),
        ("l3", "world", "'l3' is behind 'world', not before it"),
        ("l3", "l3", "'l3' is not on the way to 'l3'"),
        ("world", "base", "nothing moves between 'world' and 'base'"),
        ("l3", None, "no joint beyond 'l3' moves an arm"),
    ],
)
def test_a_chain_that_is_none_is_refused(base: str | None, tip: str | None, told: str) -> None:
    assert told in refused(tree(*ARM, "base eye revolute"), base, tip)


HAND = "left out: hand on l3, with 1 joint of its own; fixed to the arm"


def test_what_is_beside_the_arm_is_told() -> None:
    chain = chosen(
        tree(*ARM, "l3 hand fixed", "hand finger prismatic", "l1 eye revolute", "l2 lamp fixed")
    )
    assert chain.notes == (
        "left out: eye on l1, with 1 joint of its own",
        f"{HAND}: hand (dhgen import --tip takes it)",
        "frames beside the arm: lamp (dhgen import --tip takes one)",
    )


def test_frames_that_a_hand_holds_are_told_where_the_arm_carries_it() -> None:
    """They are tips that fingers hide; what hangs on a link before the last one has none."""
    hand = "l3 hand fixed", "hand finger prismatic", "hand point fixed", "point eye fixed"
    other = "l1 box fixed", "box lid revolute"
    chain = chosen(tree(*ARM, *hand, *other))
    assert chain.notes == (
        "left out: box on l1, with 1 joint of its own",
        f"{HAND}: hand, point, eye (dhgen import --tip takes one)",
    )


@pytest.mark.parametrize("kind", ["floating", "planar"])
def test_a_free_joint_before_the_arm_is_told(kind: str) -> None:
    chain = chosen(tree(f"room world {kind} odom", *ARM))
    assert chain.base == "base"
    assert chain.notes == (f"left out: the {kind} joint odom, before the arm's base",)


def test_an_arm_on_wheels_starts_behind_them() -> None:
    chain = chosen(tree("odom chassis floating", "chassis l1 revolute", "l1 l2 revolute"))
    assert chain.base == "chassis"

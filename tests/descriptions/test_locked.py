"""A joint whose lower and upper limit are one number is fixed there, unless that is zero."""

from __future__ import annotations

import pytest

from tests.descriptions.test_mistakes import LINKS, read, robot, turn

FREE = '<limit lower="-1" upper="1"/>'
DEEPER = LINKS + '<link name="d"/>\n'
JOINTS = (turn("one", "a", "b"), turn("two", "b", "c"), turn("three", "c", "d", rpy="0.3 0 0.2"))


def limited(low: float, high: float, kind: str = "revolute", number: int = 1) -> str:
    """An arm one of whose joints has these limits."""
    joints = list(JOINTS)
    limit = f'<limit lower="{low}" upper="{high}"/>'
    joints[number] = joints[number].replace(FREE, limit).replace("revolute", kind)
    return robot(*joints, links=DEEPER)


def fixed(cells: str) -> str:
    """The arm with its second joint as a fixed one."""
    joint = JOINTS[1].replace("revolute", "fixed").replace('xyz="0 0 0.5" rpy="0 0 0"', cells)
    return robot(JOINTS[0], joint, JOINTS[2], links=DEEPER)


@pytest.mark.parametrize(
    ("kind", "cells"),
    [("revolute", 'xyz="0 0 0.5" rpy="0 0.25 0"'), ("prismatic", 'xyz="0 0.25 0.5" rpy="0 0 0"')],
)
def test_a_locked_joint_is_a_fixed_one_at_its_limits(kind: str, cells: str) -> None:
    result = read(limited(0.25, 0.25, kind))
    assert result.text == read(fixed(cells)).text
    assert [joint.name for joint in result.chain.actuated] == ["one", "three"]
    assert "fixed: two at 0.25, its lower and upper limit" in result.notes


def test_one_before_the_base_is_told_too() -> None:
    result = read(limited(0.25, 0.25, number=0))
    assert result.chain.base == "b"
    assert "fixed: one at 0.25, its lower and upper limit" in result.notes


def test_two_zeros_are_no_limits() -> None:
    result = read(limited(0, 0, "prismatic"))
    assert result.robot.joints[1].limits is None
    start = "lower and upper limit are 0 for two, which exporters write for none: written without"
    assert any(note.startswith(start) for note in result.notes)
    assert not any("no limits are given" in note for note in result.notes)


def test_a_locked_joint_that_others_follow_remains() -> None:
    follows = JOINTS[2].replace("</joint>", '<mimic joint="two"/></joint>')
    text = limited(0.25, 0.25).replace(JOINTS[2], follows)
    result = read(text)
    assert [joint.name for joint in result.chain.actuated] == ["one", "two"]
    assert "lower and upper limit are one for two: written without" in result.notes

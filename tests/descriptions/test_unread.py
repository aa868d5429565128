"""What a URDF says of a frame by a quaternion, and attributes that it doesn't have, are told."""

from __future__ import annotations

import pytest

from tests.descriptions.test_mistakes import RIGHT, mistakes, read, robot, turn

HALF = "0.7071067811865476"
TURNED = robot(turn("one", "a", "b"), turn("two", "b", "c", rpy="-1.5707963267948966 0 0"))
QUATERNION = f'quat_xyzw="-{HALF} 0 0 {HALF}"'
WRITTEN = 'rpy="-1.5707963267948966 0 0"'


@pytest.mark.parametrize("part", [HALF, "0.70710678", "1", "3"])
def test_a_quaternion_turns_a_frame_as_its_angles_do(part: str) -> None:
    """Of any length, as other readers take it."""
    result = read(TURNED.replace(WRITTEN, QUATERNION.replace(HALF, part)))
    assert result.text == read(TURNED).text
    assert result.text != read(RIGHT).text
    assert not result.notes


@pytest.mark.parametrize(
    ("written", "told"),
    [
        (f'rpy="0 0 0" {QUATERNION}', "rpy and quat_xyzw: only one of them can count"),
        ('quat_xyzw="0 0 0 0"', "a quaternion can't have length 0"),
        ('quat_xyzw="0 0 1"', "quat_xyzw needs four numbers, not '0 0 1'"),
        ('quat_xyzw="0 0 x 1"', "'x' is not a number"),
    ],
)
def test_mistakes_of_a_quaternion_are_told(written: str, told: str) -> None:
    assert mistakes(TURNED.replace(WRITTEN, written)) == [(6, told)]


@pytest.mark.parametrize(
    ("given", "written", "told", "hint"),
    [
        ('rpy="0', 'RPY="0', "RPY in the <origin>", "write rpy if that is meant"),
        ('rpy="0 0 0"', 'quat="1 0 0 0"', "quat in the <origin>", "write quat_xyzw if that"),
        ("<axis xyz", "<axis xzy", "xzy in the <axis>", "write xyz if that is meant"),
        ('lower="-1"', 'min="-1"', "min in the <limit>", "write lower if that is meant"),
        ('lower="-1"', 'foo="-1"', "foo in the <limit>", "known are lower, upper, effort"),
    ],
)
def test_an_attribute_that_no_urdf_has_is_told(
    given: str, written: str, told: str, hint: str
) -> None:
    text = RIGHT.replace(given, written)
    assert text != RIGHT
    start = f"not read: {told} of one, two, an attribute that URDF lacks; {hint}"
    assert any(note.startswith(start) for note in read(text).notes)


def test_attributes_of_others_are_not_worth_a_word() -> None:
    assert not read(RIGHT.replace("<axis", '<axis drake:a="1" xmlns="x"')).notes
    assert not read(RIGHT.replace("<limit", '<limit effort="1" velocity="2" jerk="3"')).notes

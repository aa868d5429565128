"""Angles and lengths that are nearly right are exact within a tolerance, and that is told."""

from __future__ import annotations

import math
import re

import pytest

from dhgen.descriptions.convert import Import, convert
from dhgen.descriptions.urdf import read_urdf
from dhgen.descriptions.wishes import Wishes
from dhgen.descriptions.write import decimal
from dhgen.robot.robot import DhTable, ReferenceAxes
from tests.descriptions.reference import FILES, worst_difference

CLEAN = (FILES / "panda.urdf").read_text(encoding="utf-8")
RIGHT = "1.5707963267948966"


def imported(text: str, snap: float | None = None) -> Import:
    return convert(read_urdf(text.encode(), "arm.urdf"), Wishes(snap=snap))


def twists(result: Import) -> list[str]:
    return re.findall(r"alpha: ([^,}]+)", result.text)


def note(result: Import, start: str) -> str:
    return next((told for told in result.notes if told.startswith(start)), "")


def moved_mm(told: str) -> float:
    found = re.search(r"moves by at most (\S+) mm", told)
    assert found
    return float(found[1])


@pytest.mark.parametrize(
    ("written", "snap", "exact"),
    [
        (RIGHT, None, True),
        ("1.57079632679", None, True),
        ("1.570796", None, True),
        ("1.5708", None, True),
        ("1.571", None, False),
        ("1.57", None, False),
        ("1.57", 1e-3, True),
        ("1.5708", 0.0, False),
        ("1.570796", 1e-7, False),
        ("1.5707963", 1e-7, True),
    ],
)
def test_an_angle_is_exact_within_the_tolerance(
    written: str, snap: float | None, *, exact: bool
) -> None:
    text = CLEAN.replace(RIGHT, written)
    result = imported(text, snap)
    if exact:
        assert set(twists(result)) <= {"0", "pi/2", "-pi/2"}
        assert result.text == imported(CLEAN).text
    else:
        assert f"{written}" in result.text
        assert result.difference.is_rounding
        assert not note(result, "taken as exact")
    if exact and written != RIGHT:
        told = note(result, "taken as exact")
        assert written in told
        moved, _ = worst_difference(text, result, 300)
        # other samples, of the same arm: a bound that is neither missed by far nor far away
        assert 0.4 * moved_mm(told) <= 1e3 * moved <= 1.6 * moved_mm(told)


def test_what_is_beyond_the_tolerance_is_told_with_what_takes_it() -> None:
    text = CLEAN.replace(RIGHT, "1.57")
    told = note(imported(text), "kept as it is")
    assert "axes 1 and 2 miss a right angle by 0.0008 rad" in told
    snap = re.search(r"--snap (\S+)", told)
    assert snap
    assert not note(imported(text, float(snap[1])), "kept as it is")


def test_no_snap_is_advised_that_is_not_taken() -> None:
    text = CLEAN.replace(RIGHT, "1.556", 1)  # 0.0148 rad off
    told = note(imported(text), "kept as it is")
    end = "if that is not meant, change the description: --snap takes at most 0.01 as exact"
    assert told.endswith(end)
    told = note(imported(text.replace(RIGHT, "1.57", 1)), "kept as it is")
    assert told.endswith("dhgen import --snap 9e-4 takes what misses by less as exact")
    assert note(imported(text.replace(RIGHT, "1.57", 1), 9e-4), "kept as it is").endswith(end)


def test_axes_that_nearly_meet_are_told() -> None:
    text = CLEAN.replace('"0 -0.316 0"', '"0.0004 -0.316 0"')
    told = note(imported(text), "kept as it is")
    assert "axes 2 and 3 miss each other by 0.4 mm" in told
    snap = re.search(r"--snap (\S+)", told)
    assert snap
    result = imported(text, float(snap[1]))
    assert result.text == imported(CLEAN).text
    assert moved_mm(note(result, "taken as exact")) == pytest.approx(0.4, rel=1e-3)


def test_lengths_of_nothing_are_zero() -> None:
    text = CLEAN.replace('"0 -0.316 0"', '"4e-17 -0.316 -3e-9"')
    result = imported(text)
    assert result.text == imported(CLEAN).text
    assert "lengths -3e-09 as 0" in note(result, "taken as exact")
    assert moved_mm(note(result, "taken as exact")) == pytest.approx(3e-6, rel=1e-3)


def test_rounding_alone_is_not_worth_a_word() -> None:
    text = CLEAN.replace('"0 -0.316 0"', '"4e-17 -0.31600000000000006 0"')
    result = imported(text)
    assert result.text == imported(CLEAN).text
    assert not note(result, "taken as exact")


def test_a_direction_may_have_any_length_and_a_little_dirt() -> None:
    text = CLEAN.replace('<axis xyz="0 0 1"/>', '<axis xyz="1e-8 0 -2"/>')
    result = imported(text)
    assert set(twists(result)) <= {"0", "pi/2", "-pi/2"}
    assert max(worst_difference(text, result)) < 1e-7


def test_axes_nearly_parallel_become_axes_and_no_table() -> None:
    """Their common normal is kilometres away."""
    text = (FILES / "ur5.urdf").read_text(encoding="utf-8")
    tilted = text.replace('rpy="0 0 0" xyz="-0.425 0 0"', 'rpy="0 0.0003 0" xyz="-0.425 0 0"')
    assert tilted != text
    result = imported(tilted)
    assert isinstance(result.robot.geometry, ReferenceAxes)
    assert "axes 2 and 3 miss being parallel by 0.0003 rad" in note(result, "kept as it is")
    assert note(result, "axes that are nearly parallel")
    assert max(worst_difference(tilted, result)) < 1e-9
    assert isinstance(imported(tilted, 1e-3).robot.geometry, DhTable)


TEN_TURNS = "3600 deg"


@pytest.mark.parametrize(
    ("limit", "told", "written"),
    [
        ('<limit effort="1"/>', "no limits are given for panda_joint1", None),
        ("", "no limits are given for panda_joint1", None),
        ('<limit lower="1" upper="-1"/>', "limits of panda_joint1 are in the wrong order", "-1, 1"),
        ('<limit lower="0" upper="0"/>', "upper limit are 0 for panda_joint1, which", None),
        ('<limit lower="-1e9" upper="1e9"/>', "", None),
        ('<limit lower="-inf" upper="inf"/>', "", None),
        ('<limit lower="-inf" upper="2"/>', "panda_joint1 on one side only", f"-{TEN_TURNS}, 2"),
        ('<limit lower="-0.5" upper="1e10"/>', "panda_joint1 on one side", f"-0.5, {TEN_TURNS}"),
        ('<limit upper="2"/>', "", "0, 2"),
        ('<limit lower="-1.5707963267948966" upper="2"/>', "", "-1.5707963267948966, 2"),
        ('<limit lower="-1.5707963267948966" upper="0"/>', "", "-90 deg, 0"),
    ],
)
def test_limits_that_are_missing_reversed_or_endless(
    limit: str, told: str, written: str | None
) -> None:
    result = imported(CLEAN.replace('<limit lower="-2.8973" upper="2.8973"/>', limit, 1))
    row = next(line for line in result.text.splitlines() if "name: panda_joint1}" in line)
    found = re.search(r"limits: \[([^\]]*)\]", row)
    assert (found and found[1]) == written
    assert any(told in each for each in result.notes)
    assert bool(told) == any("panda_joint1" in each for each in result.notes)


def test_numbers_have_all_their_digits_and_no_exponent() -> None:
    for value in (1e-7, -1.25e-9, 0.1, 1234567.0, math.pi, 2.0, 0.0, 1e22):
        text = decimal(value)
        assert float(text) == value
        assert "e" not in text


def test_lengths_that_differ_by_rounding_are_one() -> None:
    text = CLEAN.replace('"-0.0825 0.384 0"', '"-0.082500000001 0.384 0"')
    result = imported(text)
    assert result.text == imported(CLEAN).text
    assert "of one length" in note(result, "taken as exact")


def test_limits_in_degrees_are_told() -> None:
    text = re.sub('lower="[^"]*" upper="[^"]*"', 'lower="-170" upper="170"', CLEAN)
    result = imported(text)
    assert "the limits of panda_joint1, panda_joint2" in note(result, "the limits of")
    assert result.robot.joints[0].limits == (-170.0, 170.0)  # rad, as URDF says


def test_frames_in_degrees_are_told() -> None:
    """-90 rad are fourteen turns and some, and another arm without a word."""
    told = note(
        imported(CLEAN.replace(f'"-{RIGHT}', '"-90').replace(f'"{RIGHT}', '"90')), "the rpy"
    )
    assert told.endswith("are many turns: they are in rad, not in degrees")
    assert "panda_joint2" in told
    assert not note(imported(CLEAN), "the rpy")


def test_lengths_in_millimetres_are_told() -> None:
    text = re.sub(
        'xyz="([^"]*)"',
        lambda found: f'xyz="{" ".join(str(1e3 * float(word)) for word in found[1].split())}"',
        CLEAN,
    )
    result = imported(text)
    assert "lengths of a description are in m" in note(result, "the arm is")
    assert result.difference.is_rounding

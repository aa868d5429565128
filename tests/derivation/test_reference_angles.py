"""Cosines and sines without signs belong to angles that are said to be others than the table's."""

from __future__ import annotations

import math
import re

import pytest

from dhgen.robot.expression import evaluate
from dhgen.robot.load import load
from dhgen.robot.robot import DhTable
from tests.derivation.made import made_of
from tests.derivation.stories import ALL_WHOLE, ROBOTS, WITH_STEPS, document

HATTED = re.compile(r"\$\\(alpha|theta)_(\d) = ([-+]?)(\\pi [-+] )?\\hat\\\1_\2( - \\pi)?\$")
HAT = re.compile(r"\\hat\\(alpha|theta)_(\d)")


@pytest.mark.parametrize("name", [*WITH_STEPS, *ALL_WHOLE])
def test_hats_are_said_and_mark_acute_angles(name: str) -> None:
    robot, text = load(ROBOTS / f"{name}.yaml"), document(name)
    told = {
        (letter, number): (bool(pi), bool(less), sign)
        for letter, number, sign, pi, less in HATTED.findall(text)
    }
    assert set(HAT.findall(text)) == set(told)
    for (letter, number), (supplement, beyond, sign) in told.items():
        assert isinstance(robot.geometry, DhTable)
        row = robot.geometry.rows[int(number) - 1]
        cell = row.alpha if letter == "alpha" else row.theta
        angle = evaluate(cell, {each.name: each.value for each in robot.parameters})
        angle = math.remainder(angle, 2.0 * math.pi)
        angle = math.pi - angle if supplement else angle + math.pi if beyond else -angle
        assert (sign == "-") == (not supplement and not beyond)
        assert 0.0 < angle < math.pi / 2


@pytest.mark.parametrize("name", ["general_6r", "general_prrprr", "wrist_oblique"])
def test_cosines_of_the_table_s_angles_have_no_numbers(name: str) -> None:
    """The reader has the angle: sixteen digits of its cosine say no more."""
    assert not re.search(r"\\(?:cos|sin) \S+ = [\d.]", document(name).split("## Forward")[0])


def test_angles_of_one_size_share_letters_and_are_said_to() -> None:
    rows = "theta: q, a: 0.4, alpha: 0.3", "theta: q, a: 0.2, alpha: -0.3", "theta: q, a: 0.2"
    text = made_of(*rows, task="position")
    assert r"Angles of one size share its letters: $\alpha_2 = -\alpha_1$." in text


def test_a_frame_s_sine_below_zero_is_said_to_be_without_its_sign() -> None:
    rows = "theta: q, a: 0.4", "theta: q, a: 0.3"
    text = made_of(*rows, tool="{rpy: [0, 0, -0.3]}", task="[x, y]")
    assert "(cosine of an angle in the tool frame)" in text
    assert "(sine of an angle in the tool frame, without its sign)" in text

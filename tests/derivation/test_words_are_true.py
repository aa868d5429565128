"""What is said in words beside the formulas holds for the arm of which it is said."""

from __future__ import annotations

import re

import pytest

from tests.derivation.stories import ALL_WHOLE, WITH_STEPS, document

EVERY = [*WITH_STEPS, *ALL_WHOLE]
FORMULA = re.compile(r"\$`?([^$]*?)`?\$|```math\n(.*?)\n```", re.DOTALL)


def formulas(text: str) -> str:
    """All formulas of a text, one after the other."""
    return "\n".join(inline or block for inline, block in FORMULA.findall(text))


@pytest.mark.parametrize("name", EVERY)
def test_sums_of_angles_are_told_as_they_occur(name: str) -> None:
    text = document(name)
    told = set(re.findall(r"\$\\theta_{([\d,-]+)} = ", text.split("## Forward")[0]))
    used = set(re.findall(r"(?<![A-Za-z])(?:[cs]|\\theta)_{([\d,-]+)}", formulas(text)))
    assert told == used


@pytest.mark.parametrize("name", EVERY)
def test_slides_are_told_of_arms_that_have_them(name: str) -> None:
    text = document(name)
    slides = "prismatic" in text.split("Task:")[0]
    assert ("for a revolute and for a prismatic" in text or "slides along" in text) <= slides


@pytest.mark.parametrize("name", WITH_STEPS)
def test_the_seed_is_told_where_a_joint_may_be_free(name: str) -> None:
    text = document(name)
    takes = "takes the seed's value" in text or "nearest to the seed's" in text
    takes |= "that the seed's" in text
    assert ("The seed is a set of joint values" in text) == takes
    assert ("of the seed only, where a joint is free" in text) <= takes


def test_an_arm_with_joints_to_spare_is_not_said_to_reach_everything() -> None:
    text = document("planar_rrrr")
    assert "a pose inside its reach has in general infinitely many solutions" in text
    assert "every pose" not in text
    assert r"T_i^0 = A_1 \cdots A_i" in text

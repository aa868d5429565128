"""The words of branches, and sines and cosines that later steps take, are defined."""

from __future__ import annotations

import re

import pytest

from dhgen.derivation.known_functions import TAKEN
from dhgen.derivation.notation.names import cosine, sine, single
from dhgen.derivation.steps import step_blocks
from dhgen.derivation.text.blocks import Paragraph
from tests.derivation.made import made_of
from tests.derivation.stories import EACH, story
from tests.derivation.test_wording import text_of


def legend(name: str) -> str:
    """What is said of the words of branches."""
    return "".join(re.findall(r"^In the names of rows .*$", text_of(name), re.MULTILINE))


@pytest.mark.parametrize("name", EACH)
def test_every_word_of_a_branch_is_explained(name: str) -> None:
    of = story(name)
    if of.has_branch_words:
        told = legend(name)
        for axis in of.program.axes:
            plus, *_, last = axis.meaning
            assert (f"{plus} is " in told and f"{last} is " in told) or f"{plus} to {last}" in told
    else:
        assert not legend(name)


def test_the_words_of_an_arm_with_an_elbow() -> None:
    told = legend("puma560")
    signs = r"right is $\varepsilon_1 = 1$ and left is $\varepsilon_1 = -1$ in step 1"
    assert rf"{signs}, which gives $\theta_1$; down is $\varepsilon_1 \varepsilon_3 = 1$" in told
    assert "; noflip is" in told
    assert "root1 to root4 are the roots of step 1 for" in legend("cuspidal_3r")


def test_sines_and_cosines_that_are_used_are_defined_behind_the_angle() -> None:
    """The last two joints of this arm are not used, and have them on lines of their own."""
    of = story("puma560")
    told = {}
    for number in range(1, len(of.steps) + 1):
        texts = [b.prose for b in step_blocks(of, number)[0] if isinstance(b, Paragraph)]
        told[number] = [each.parts for each in texts if each.text == TAKEN]
    angles = {1: single(1), 2: single(3), 3: single(2), 4: single(4)}
    expected = {number: [(sine(angle), cosine(angle))] for number, angle in angles.items()}
    assert told == {**expected, 5: [], 6: []}


def test_an_angle_that_follows_by_a_joint_that_is_given_is_told_before_it_is_used() -> None:
    rows = (
        "theta: q, d: 2, alpha: pi/2",
        "theta: q, a: 3",
        "theta: q, a: 4",
        "theta: q, alpha: pi/2",
        "theta: q, d: 1, alpha: pi/2",
        "theta: pi/2, d: q, alpha: pi/2",
        "theta: pi/2, d: q",
    )
    text = made_of(*rows, free="[3]")
    assert re.search(r"With \$\\theta_\{?\d+\}?\$, \$\\theta_\d = .*\$ is known, too\.", text)

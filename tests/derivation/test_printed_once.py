"""No equation stands twice in a section, and no column of a transform in the next one."""

from __future__ import annotations

import re
from itertools import pairwise

import numpy as np
import pytest

from dhgen.derivation.document import document_blocks
from dhgen.derivation.sections.forward import forward_section
from dhgen.derivation.steps import step_blocks
from dhgen.derivation.text.blocks import Display, Paragraph, unfolded
from dhgen.derivation.text.formula import Relation
from dhgen.derivation.text.lines import width
from dhgen.derivation.text.markdown import markdown
from dhgen.derivation.text.plain import words
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from tests.derivation.stories import EACH, story
from tests.derivation.test_formulas_hold import configuration, with_pose

LONG = 30  # visible characters


@pytest.mark.parametrize("name", EACH)
def test_what_a_direct_step_solves_is_not_printed_before(name: str) -> None:
    of = story(name)
    for number in range(1, len(of.steps) + 1):
        blocks, _ = step_blocks(of, number)
        told = "".join(markdown(block) for block in blocks)
        if "holds the sine or the cosine alone" in told:
            displays = [block for block in blocks if isinstance(block, Display)]
            assert len(displays) == 1, told


@pytest.mark.parametrize("name", EACH)
def test_no_long_entry_of_a_transform_is_printed_twice_in_a_row(name: str) -> None:
    displays = [
        each for each in unfolded(forward_section(story(name))) if isinstance(each, Display)
    ]
    entries = [set(_long_sides(block)) for block in displays]
    for before, after in pairwise([each for each in entries if each]):
        assert not before & after


def _long_sides(block: Display) -> list[str]:
    sides = [f.sides[-1] for f in block.formulas if isinstance(f, Relation)]
    return [show(side, PLAIN) for side in sides if width(side) > LONG]


@pytest.mark.parametrize("name", EACH)
def test_columns_that_are_said_to_be_another_s_are(name: str) -> None:
    of = story(name)
    letters = with_pose(of, configuration(of, 5))
    for block in unfolded(document_blocks(of)):
        if isinstance(block, Paragraph) and block.prose.text == "{}; the other entries are":
            told = words(block.prose)
            first, second = told.split(" is " if " is " in told else " are ")
            new, old = (letters[re.sub(r".* of |;.*", "", part)] for part in (first, second))
            columns = [int(each) for each in re.findall(r"\d", first.split(" of ")[0])]
            others = re.findall(r"(minus )?column (\d)", second.split(" of ")[0])
            pairs = others or [("", str(column)) for column in columns]
            for column, (turned, other) in zip(columns, pairs, strict=True):
                sign = -1.0 if turned else 1.0
                np.testing.assert_allclose(
                    new[:3, column - 1], sign * old[:3, int(other) - 1], atol=1e-12
                )

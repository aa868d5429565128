"""The matrix that is left to a spherical wrist, and what is folded in a document."""

from __future__ import annotations

import re
from functools import reduce

import numpy as np
import pytest

from dhgen.derivation.sections.wrist import wrist_blocks
from dhgen.derivation.text.blocks import Display, Folded, display, paragraph
from dhgen.derivation.text.formula import Listing, Relation, Symbol
from dhgen.derivation.text.html import html
from dhgen.derivation.text.latex import latex
from dhgen.derivation.text.markdown import markdown
from dhgen.derivation.text.plain import plain
from tests.derivation.stories import story
from tests.derivation.test_formulas_hold import configuration, with_pose
from tests.derivation.values import evaluate, indexed

SPHERICAL = ["kuka_iiwa14_arm_angle", "puma560", "spherical_wrist_general_arm", "stanford"]


@pytest.mark.parametrize("name", SPHERICAL)
def test_the_matrix_of_the_wrist_is_the_product_of_its_joints(name: str) -> None:
    of = story(name)
    places = [wrist_blocks(of, number) for number in range(1, len(of.steps) + 1)]
    (shown,) = [blocks for blocks in places if blocks]
    matrix = next(block for block in shown if isinstance(block, Display))
    (relation,) = matrix.formulas
    assert isinstance(relation, Relation)
    for seed in range(3):
        letters = with_pose(of, configuration(of, seed))
        joints = [letters[indexed("A", of.dof - k)] for k in (2, 1, 0)]
        expected = reduce(np.matmul, map(np.asarray, joints))[:3, :3]
        found = evaluate(relation.sides[-1], letters)
        np.testing.assert_allclose(found, expected, atol=1e-12)


def test_the_hands_origin_is_column_4_of_document_003() -> None:
    """Of its table 3T6 has (-d6 c4 s5, -d6 s4 s5, d4 + d6 c5)."""
    of = story("arm_6r")
    shown = [block for step in range(len(of.steps)) for block in wrist_blocks(of, step + 1)]
    (listing,) = shown[-1].formulas if isinstance(shown[-1], Display) else ()
    assert isinstance(listing, Listing)
    letters = with_pose(of, configuration(of, 2))
    c4, s4, c5, s5, d4, d6 = (letters[name] for name in ("c₄", "s₄", "c₅", "s₅", "d₄", "d₆"))
    hand = reduce(np.matmul, (np.asarray(letters[indexed("A", number)]) for number in (4, 5, 6)))
    column = (-d6 * c4 * s5, -d6 * s4 * s5, d4 + d6 * c5)
    for item, expected, row in zip(listing.items, column, hand[:3], strict=True):
        assert isinstance(item, Relation)
        assert np.isclose(evaluate(item.sides[-1], letters), expected)
        assert np.isclose(row[3], expected)


@pytest.mark.parametrize("name", ["ur5", "planar_rr", "wrist_zyz"])
def test_arms_without_one_behind_others_have_no_such_matrix(name: str) -> None:
    of = story(name)
    assert not any(wrist_blocks(of, number) for number in range(1, len(of.steps) + 1))


def test_what_is_folded_is_whole_in_every_format() -> None:
    inside = (paragraph("Inside stands"), display(Symbol("x_1", "x₁")))
    block = Folded("More of it", inside)
    # GitHub reads Markdown between tags only behind a blank line
    assert re.fullmatch(
        r"<details>\n<summary>More of it</summary>\n\nInside stands\n\n"
        r"```math\nx_1\n```\n\n</details>",
        markdown(block),
    )
    shown = html(block, {})
    assert shown.startswith("<details><summary>More of it</summary>")
    assert shown.count("<details>") == shown.count("</details>") == 1
    assert "Inside stands" in shown
    assert latex(block, {}).startswith(r"\paragraph{More of it}")
    assert "Inside stands" in latex(block, {})
    assert "Inside stands" in plain(block)
    assert "More of it" not in plain(block)

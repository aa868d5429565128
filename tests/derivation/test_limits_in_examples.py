"""What examples say of joint limits, and numbers and lists as they are printed."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.derivation import derivation_document
from dhgen.derivation.document import singular_places
from dhgen.derivation.french.language import French
from dhgen.derivation.french.notation import french_formula
from dhgen.derivation.sections.example import singular_blocks
from dhgen.derivation.singular_example import find_singular
from dhgen.derivation.text.blocks import Folded, Paragraph, paragraph
from dhgen.derivation.text.formula import Matrix, Symbol, equal
from dhgen.derivation.text.latex import latex
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from dhgen.derivation.values import figures
from tests.derivation.made import made_of
from tests.derivation.stories import story_of
from tests.kinematics.values import table

if TYPE_CHECKING:
    from dhgen.derivation.story import Story

ELBOW = (
    "theta: q, limits: [-160 deg, 160 deg]",
    "theta: q, d: 0.18, a: 0.12, alpha: -pi/2, limits: [-225 deg, 45 deg]",
    "theta: q, a: 0.43, limits: [-45 deg, 225 deg]",
    "theta: q, d: 0.4, a: 0.05, alpha: -pi/2, limits: [-110 deg, 170 deg]",
    "theta: q, alpha: pi/2, limits: [-100 deg, 100 deg]",
    "theta: q, alpha: -pi/2, limits: [-266 deg, 266 deg]",
)
POLAR = (
    "theta: q, d: 0.4, alpha: -pi/2, limits: [-170 deg, 170 deg]",
    "theta: q, d: 0.15, alpha: pi/2, limits: [-100 deg, 100 deg]",
    "d: q, limits: [0.2, 1.2]",
    "theta: q, alpha: -pi/2",
    "theta: q, alpha: pi/2",
    "theta: q, d: 0.26",
)


def modified(*rows: str) -> Story:
    return story_of(table(*rows, convention="modified"))


def test_rows_that_keep_the_limits_are_printed_inside_them() -> None:
    """Both of the example and of the singular one; q_3 is from -45 to 225 degrees."""
    of = modified(*ELBOW)
    assert of.example is not None
    singular = find_singular(of, of.example, singular_places(of))
    assert singular is not None
    limits = np.array([joint.limits for joint in of.algebra.chain.joints], float)
    for example in (of.example, singular):
        kept = example.rows[example.inside]
        assert len(kept)
        assert (kept >= limits[:, 0] - 1e-8).all()
        assert (kept <= limits[:, 1] + 1e-8).all()
    assert np.nanmax(of.example.rows[:, 2]) > math.pi
    assert "$221.85^\\circ$" in derivation_document(of, "x.yaml")


@pytest.mark.parametrize(
    ("low", "high"), [(-190, 45), (200, 500), (-500, -200), (170, 500), (300, 3000), (-3000, 3000)]
)
def test_joint_values_of_the_example_are_inside_limits_beyond_half_a_turn(
    low: int, high: int
) -> None:
    """The pose's own as printed, and those of every row that keeps the limits."""
    first = f"theta: q, a: 0.3, limits: [{low} deg, {high} deg]"
    of = story_of(table(first, "theta: q, a: 0.25", task="[x, y]"))
    assert of.example is not None
    rows = of.example.rows[of.example.inside]
    values = np.degrees([of.example.q[0], *rows[:, 0]])
    assert (values >= low - 1e-6).all()
    assert (values <= high + 1e-6).all()
    np.testing.assert_allclose(
        of.example.rows[of.example.followed], of.example.q, rtol=0, atol=1e-9
    )


def test_joints_that_no_value_of_a_free_joint_takes_inside_are_out_of_limits() -> None:
    """The slide of a row that reaches backwards is shorter than nothing, whatever q_4 is."""
    of = story_of(table(*POLAR))
    assert of.example is not None
    (told,) = (
        block.prose.text
        for block in singular_blocks(of, singular_places(of))
        if isinstance(block, Paragraph) and "rows hold solutions" in block.prose.text
    )
    assert "In row 4 the seed's value, zero here, is taken: the status is FREE_JOINT." in told
    assert (
        "In row 6 joints 2 and 3 are beyond their limits whatever value is taken: "
        "the status is OUT_OF_LIMITS."
    ) in told
    assert "the nearest value that works" not in told


PASSIVE = "of the frame before the passive rows"


def test_a_passive_row_before_the_last_joint_is_in_its_frame() -> None:
    """Frames of modified rows are behind the passive row of the same link; a last one follows."""
    rows = [
        "theta: q, d: 0.8",
        "theta: q - 90 deg, a: 0.3, alpha: -90 deg",
        "theta: q - q2 + 90 deg, a: 1.28",
        "theta: -q3, a: 1.35",
    ]
    last = "theta: q, d: -0.15, a: 0.26, alpha: -90 deg"
    level = "theta: -q2 - q3, a: 0.2"
    own = {"convention": "modified"}
    assert PASSIVE not in made_of(*rows, last, task="[x, y, z, yaw]", **own)
    after = made_of("theta: q, d: 0.8", rows[1], "theta: q, a: 1.28", level, task="position", **own)
    assert f"Those of joint 3 are {PASSIVE}." in after


@pytest.mark.parametrize(
    ("value", "text", "written"),
    [
        (-1027965176940000.0, "−1.028e15", r"-1.028 \cdot 10^{15}"),
        (7174654485860000.0, "7.1747e15", r"7.1747 \cdot 10^{15}"),
        (999999.9, "1e6", r"1 \cdot 10^{6}"),
        (123456.0, "123460", "123460"),
    ],
)
def test_large_numbers_have_five_digits(value: float, text: str, written: str) -> None:
    assert figures(value) == Symbol(written, text)


def test_french_lists_with_decimal_commas_have_semicolons() -> None:
    x = Symbol("x", "x")
    first, *others = equal(x, Symbol("0.5", "0.5")), Symbol("1", "1"), Symbol("2", "2")
    written = French().prose(paragraph("Parameters: {}, {} and {}.", first, *others).prose)
    assert written.text == "Paramètres\u00a0: {}\u00a0; {} et {}."
    whole = French().prose(paragraph("Parameters: {}, {} and {}.", x, *others).prose)
    assert whole.text == "Paramètres\u00a0: {}, {} et {}."


def test_french_matrices_in_a_line_have_semicolons_beside_decimal_commas() -> None:
    def printed(*entries: str) -> str:
        a, b, c, d = (Symbol(each, each) for each in entries)
        return show(french_formula(Matrix(((a, b), (c, d)))), PLAIN)

    assert printed("0.5", "0", "1", "-0.866") == "[0,5 ; 0 ;; 1 ; -0,866]"
    assert printed("1", "0", "0", "1") == "[1, 0; 0, 1]"


def test_latex_has_the_headings_of_what_other_formats_fold() -> None:
    folded = Folded("The steps as an algorithm", (paragraph("The letters."),))
    assert latex(folded, {}).splitlines()[0].startswith(r"\paragraph{The steps as an algorithm}")


def test_a_length_that_is_added_to_a_slide_has_its_unit() -> None:
    rows = "theta: q", "d: q - L, alpha: pi/2", "theta: q, a: 0.2"
    text = made_of(*rows, parameters="{L: 0.3}", task="position")
    assert "$L = 0.3$ m" in text

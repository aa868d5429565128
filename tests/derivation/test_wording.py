"""Sentences that a reader takes at their word."""

from __future__ import annotations

import re

import numpy as np
import pytest

from dhgen.derivation.document import document_blocks
from dhgen.derivation.french.notation import french_symbol
from dhgen.derivation.french.sentences import french
from dhgen.derivation.sections.general import near_blocks
from dhgen.derivation.sections.roots import sum_of_powers
from dhgen.derivation.text.formula import Symbol
from dhgen.derivation.text.markdown import markdown
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from dhgen.kinematics.numeric import numeric_arm
from tests.derivation.made import made_of
from tests.derivation.stories import EACH, WHOLE, story

ENDS = "A branch ends where a square root has a negative argument"


def text_of(name: str) -> str:
    """A derivation as Markdown."""
    return "\n\n".join(markdown(block) for block in document_blocks(story(name)))


@pytest.mark.parametrize("name", EACH)
def test_branches_end_only_where_a_step_says_that_there_may_be_no_solution(name: str) -> None:
    text = text_of(name)
    if ENDS in text:
        assert "\n\nNo solution when" in text


def test_an_arm_of_which_every_branch_has_a_solution() -> None:
    assert ENDS not in text_of("wrist_zyz")
    assert ENDS in text_of("ur5")


def test_negative_lengths_are_told_by_their_size() -> None:
    """The UR5's lengths are negative; those of a link along -z are not for that."""
    size = r"\lvert a_2 \rvert + \lvert a_3 \rvert"
    assert size in text_of("ur5")
    assert "is greater than $a_2 + d_4$ or less than $a_2 - d_4$" in text_of("arm_6r")
    rows = "theta: q, a: l1", "theta: q, a: -l2"
    text = made_of(*rows, parameters="{l1: 0.4, l2: -0.3}", task="[x, y]")
    assert r"is greater than $l_1 + \lvert l_2 \rvert$" in text.replace("`", "")


def test_only_axes_that_miss_are_what_keeps_an_arm_from_a_closed_form() -> None:
    """Three axes of the welding arm are parallel, which does not keep it from one."""
    chain = story("welding_5r").algebra.chain
    assert near_blocks(chain, "m") == []
    (told,) = (markdown(block) for block in near_blocks(story("xarm6").algebra.chain, "m"))
    assert "axes 4, 5 and 6 do not meet in one point: axes 4 and 5 meet" in told
    assert told.endswith("axis 6 passes their point at 0.076 m.")


@pytest.mark.parametrize("name", ["kinova_gen3_lite", "fanuc_crx10ia", "general_6r"])
def test_how_axes_lie_that_miss_one_point_is_true(name: str) -> None:
    """By the axes themselves: the distance of lines, and the feet of their common normals."""
    chain = story(name).algebra.chain
    directions, points = numeric_arm(chain).axes(np.zeros(chain.dof))
    text = text_of(name).split("What keeps this arm from a closed form: ")[1].split("\n\n")[0]
    told = re.findall(r"axes (\d), (\d) and (\d) do not[^:]*: ([^;]*?)(?:;|\.$)", text)
    assert told
    for *joints, how in told:
        i, j, k = (int(each) - 1 for each in joints)
        feet, gaps = [], []
        for other in (i, k):
            normal = np.cross(directions[j], directions[other])
            gaps.append(abs((points[other] - points[j]) @ normal) / np.linalg.norm(normal))
            matrix = np.stack([directions[j], -directions[other]], axis=1)
            feet.append(np.linalg.lstsq(matrix, points[other] - points[j], rcond=None)[0][0])
        value = float(re.findall(r"([\d.]+) m\b", how)[0])
        if "the largest is" in how:
            assert max(*gaps, abs(feet[1] - feet[0])) == pytest.approx(value, rel=1e-3)
        else:
            assert max(gaps) < 1e-12
            assert abs(feet[1] - feet[0]) == pytest.approx(value, rel=1e-3)


@pytest.mark.parametrize("name", [*EACH, *WHOLE])
def test_formulas_in_sentences_are_formulas(name: str) -> None:
    for line in re.sub(r"```text.*?```", "", text_of(name), flags=re.DOTALL).splitlines():
        assert not set(line) & set("φθβγδ√⁻"), line


@pytest.mark.parametrize("name", [*EACH, *WHOLE])
def test_the_half_angle_s_tangent_is_written_in_one_way(name: str) -> None:
    text = text_of(name)
    assert "tan(" not in text
    assert "operatorname" not in text  # which GitHub refuses


@pytest.mark.parametrize(
    ("name", "where"),
    [
        ("general_6r", r"singular where $\det J = 0$: there the joints can move"),
        ("xarm7", "singular where the columns of $J$ of the joints that are not given are"),
        ("general_5r", "singular where the columns of $J$ are linearly dependent"),
        pytest.param(
            "general_5r_pointing",
            "without moving the tool's origin or turning its z axis",
            marks=pytest.mark.slow,
        ),
    ],
)
def test_general_arms_say_where_they_are_singular(name: str, where: str) -> None:
    text = text_of(name)
    assert where in text.split("## Singular configurations")[1]
    assert text.count("FREE_JOINT") == 1


def test_polynomials_in_numbers_descend_whatever_their_signs() -> None:
    shown = show(sum_of_powers([-0.5, 0.0, 2.0, -1.5, -0.25], 2.0), PLAIN)
    assert shown == "−0.5 x⁴ + 2 x² − 1.5 x − 0.25"
    assert show(sum_of_powers([0.0, 0.0, 0.0, 0.0, -3.0], 3.0), PLAIN) == "−3"


def test_two_rows_are_no_range() -> None:
    assert "returned in rows 0 and 1, each" in text_of("scara")
    assert "returned in rows 0 to 7, each" in text_of("ur5")
    assert "données aux lignes 0 et 1, chacune" in (french(returned(text_of("scara"))) or "")


def returned(text: str) -> str:
    """The sentence on how many solutions there are."""
    (found,) = re.findall(r"The inverse has at most .*?\.", text)
    return str(found)


def test_coordinates_of_points_are_apart_in_french() -> None:
    """A comma is that of a decimal number there."""
    assert french_symbol(Symbol("(0, -d_6, 0.5)", "(0, −d₆, 0.5)")) == Symbol(
        r"(0\,;\ -d_6\,;\ 0{,}5)", "(0 ; −d₆ ; 0,5)"
    )

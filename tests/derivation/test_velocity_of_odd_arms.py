"""Arms made up here of which the determinant is looked at in a way that no robot file needs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation import derivation_document
from dhgen.derivation.sections.velocity import with_letters
from dhgen.derivation.text.formula import ONE, Symbol, add
from dhgen.derivation.velocity import determinant
from dhgen.derivation.velocity.columns import WORLD
from dhgen.derivation.velocity.determinant import OF_VELOCITY, Determinant, Factor, determinant_of
from dhgen.derivation.velocity.task_rows import ways_to_see
from dhgen.derivation.velocity.with_arm_angle import determinant_with_arm_angle
from tests.derivation.stories import story, story_of
from tests.kinematics.values import table

if TYPE_CHECKING:
    import pytest

OBLIQUE = "theta: q, a: 0.4, d: 0.1, alpha: pi/3", "theta: q, a: 0.3, d: 0.2, alpha: pi/4"
BESIDE = "{xyz: [0, 0.1, 0.1]}"


def document_of(*rows: str, **sections: str) -> str:
    return derivation_document(story_of(table(*rows, **sections)), "x.yaml")


def test_a_passive_row_that_turns_twice_as_far_has_no_column() -> None:
    rows = (
        "theta: q, d: 0.3, alpha: pi/2",
        "theta: q, a: 0.4",
        "theta: 2*q2, a: 0.3",
        "theta: q, a: 0.2, alpha: 0.3",
    )
    assert "## Velocity" not in document_of(*rows, task="position", numerical="true")


def test_of_a_direction_s_rows_none_are_left_out() -> None:
    """Four joints for five numbers: only in some frame one row is zero."""
    rows = "theta: q, a: 0.4", "theta: q, a: 0.3", "theta: q, alpha: pi/2", "theta: q, alpha: pi/2"
    text = document_of(*rows, task="pointing", tool="{xyz: [0, 0, 0.1]}", numerical="true")
    assert r"\det J" not in text


def test_a_turn_that_the_task_leaves_open_is_no_joint_s_velocity() -> None:
    """Of joints 1 and 2 and this turn the velocities would be a block that is too long."""
    rows = *OBLIQUE, "theta: q, alpha: pi/3", "theta: q, alpha: pi/4", "theta: q"
    of = story_of(table(*rows, task="pointing", tool=BESIDE, numerical="true"))
    assert determinant_of(of) is None


def test_a_long_determinant_of_the_position_alone_has_no_letter() -> None:
    rows = *OBLIQUE, "theta: q, a: 0.25, d: 0.15, alpha: pi/3"
    of = story_of(table(*rows, task="pose", tool=BESIDE))
    found = determinant_of(of, by_position=True)
    assert found is not None
    assert [each.formula for each in found.factors] == [OF_VELOCITY]
    assert "J_v" not in derivation_document(of, "x.yaml")


def test_poses_of_an_arm_without_a_base_are_those_of_frame_0() -> None:
    """Its rows are there once, by the number that a text can print."""
    of = story_of(table(*OBLIQUE, "theta: q, a: 0.25", task="position", numerical="true"))
    assert {each.frame for each in ways_to_see(of)} >= {0, 1}
    assert WORLD not in {each.frame for each in ways_to_see(of)}


def test_fewer_columns_than_rows_are_those_of_joints_solved_for() -> None:
    """A slide that is given, and the three joints of a cylindrical arm."""
    rows = "d: q", "theta: q, d: 0.3", "d: q, alpha: -pi/2", "d: q"
    text = document_of(*rows, task="pose", free="[1]", tool="{xyz: [0, 0, 0.1]}")
    assert "as columns of the joints that are solved for ($q_2$, $q_3$ and $q_4$)" in text
    assert "velocity of the point of the tool at the origin of frame 0 and the angular" in text
    assert r"\det J = -1" in text


def test_with_the_arm_angle_a_part_may_be_too_long(monkeypatch: pytest.MonkeyPatch) -> None:
    of = story("kuka_iiwa14_arm_angle")
    assert determinant_with_arm_angle(of, ()) is not None
    monkeypatch.setattr(determinant, "MOST_TERMS", 0)
    assert determinant_with_arm_angle(of, ()) is None


def test_beyond_seven_letters_long_factors_stay_as_they_are() -> None:
    sums = [add(*(Symbol(f"{x}_{n}", f"{x}{n}") for n in range(20))) for x in "abcdefghi"]
    factors = tuple(Factor(each, 1, None, each) for each in sums)
    found, letters = with_letters(story("scara"), Determinant(ONE, factors, 9))
    assert [each.formula for each in found.factors[7:]] == sums[7:]
    assert len(letters) == 7
    assert not {each.formula for each in found.factors[:7]} & set(sums)

"""Where an angle would be free is told only of arms that can get there."""

from __future__ import annotations

import pytest

from dhgen.derivation.conditions import are_never_zero
from tests.derivation.made import made_of
from tests.derivation.stories import document
from tests.kinematics.values import algebra_of, table

LINKS = "theta: q, d: 0.4, alpha: pi/2", "theta: q, a: a2", "theta: q, a: 0.3, alpha: pi/2"


@pytest.mark.parametrize(
    ("a2", "told"),
    [
        ("0.3", "as this arm has"),
        ("0.31", "is never zero: the two links differ in length."),
    ],
)
def test_links_that_differ_in_length_leave_no_angle_free(a2: str, told: str) -> None:
    text = made_of(*LINKS, parameters=f"{{a2: {a2}}}", task="position")
    assert told in text
    assert ("every $\\theta_2$ works" in text) == (a2 == "0.3")
    assert "does not have" not in text


def test_a_point_that_stays_off_the_axis_is_not_said_to_meet_it() -> None:
    """With a3 < a2 the tool's origin of this arm is never on axis 2, which a2 + a3 c3 = 0 asks."""
    text = document("cuspidal_3r")
    assert "$X_1^2 + Y_1^2$ is never zero: the numbers of this arm do not allow it." in text
    assert "lies on axis 2" not in text


def test_numbers_tell_whether_factors_vanish_together() -> None:
    algebra = algebra_of(table(*LINKS, parameters="{a2: 0.31}"))
    a2, c3, s3, c2 = (algebra.generator(name) for name in ("a2", "c3", "s3", "c2"))
    a3 = algebra.generator("a3")
    assert are_never_zero(algebra, a2 + a3 * c3)
    assert are_never_zero(algebra, a3 * c3, a3 * s3)
    assert are_never_zero(algebra, c2 * c3, a2 + a3 * s3)
    assert not are_never_zero(algebra, a3 + a2 * c3)
    assert not are_never_zero(algebra, a3 + a3 * c3, a3 * s3)
    assert not are_never_zero(algebra, c2, c3)
    assert not are_never_zero(algebra, a3 * s3)


def test_the_point_that_is_at_the_edge_of_its_reach_is_named() -> None:
    text = made_of(
        "theta: q - pi/2, d: 0.3, a: 0.3, alpha: 60 deg",
        "theta: 0, d: q, a: 0.2, alpha: 120 deg",
        "theta: q, a: 0.3, alpha: pi/2",
        "theta: q - pi/2, d: 0.3, alpha: -pi/2",
        "theta: pi - q, alpha: pi/2",
        "theta: q",
    )
    assert "the wrist centre is at the edge of its reach" in text
    assert "the point is at" not in text

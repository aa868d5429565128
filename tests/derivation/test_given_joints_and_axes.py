"""Joints that the caller gives are not computed, and the motion about an axis is defined."""

from __future__ import annotations

import re

from dhgen.derivation.french.sentences import french
from tests.derivation.made import made_of
from tests.derivation.stories import document

ARM = "theta: q, alpha: pi/2", "theta: q, a: 0.4", "theta: q, a: 0.3"


def test_a_given_joint_is_not_computed() -> None:
    """Neither in the sections on joint values nor as a line of the algorithm."""
    text = made_of("d: q, alpha: pi/2", *ARM, task="position", free="[1]")
    model, inverse = text.split("## Inverse\n")
    assert "$r_1 = q_1$" in model
    assert "q_1 = r_1" not in inverse
    assert "q₁ = r₁" not in inverse
    turned = made_of("theta: q + pi/3, d: 0.3, a: 0.1", *ARM, task="position", free="[1]")
    assert not re.search(r"q_1 = \\theta_1|q₁ = θ₁", turned.split("## Inverse\n")[1])


def test_the_rotation_in_the_motion_about_an_axis_is_defined() -> None:
    text = document("puma")
    assert "with a point $p_i$ of the axis and the rotation $R_i$ about it." in text


def test_a_leg_is_named_in_french() -> None:
    """A sentence on its own is about the leg and no calculation: `Elle` was `le calcul`."""
    written = french("It has at most two rows: 0 forward, 1 backward.")
    assert written is not None
    assert written.startswith("Cette jambe a au plus deux lignes")

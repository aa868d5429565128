"""Arms of structures that no robot file has: what is said of them is what a teacher would say."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.derivation import derivation_document
from dhgen.kinematics.numeric import numeric_arm
from tests.derivation.made import made_of
from tests.derivation.stories import story_of
from tests.kinematics.values import axes, table

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray


def section(text: str, heading: str) -> str:
    """A section of a derivation."""
    return text.partition(f"## {heading}\n")[2].partition("\n## ")[0]


def test_a_number_that_would_have_a_parameter_s_letter_gets_a_prime() -> None:
    text = made_of("theta: q, a: 0.2", "theta: q, a: a1", parameters="{a1: 0.3}", task="[x, y]")
    assert "$a_1' = 0.2$ m (link length 1)" in text
    assert r"\_" not in text


def test_angles_of_parameters_have_their_unit_once() -> None:
    rows = "theta: q + phi, a: 0.2", "theta: q, a: 0.3, alpha: psi", "theta: q, a: 0.1"
    text = made_of(*rows, parameters="{phi: 20 deg, psi: 0.7}", task="position")
    assert r"$\phi = 20^\circ$ and $\psi = 0.7$ rad" in text
    assert "cosine of" not in text  # the table has the angle
    assert "in radians." not in text.split("## Forward")[0]
    assert "Angles without a degree sign are in radians." in made_of(
        "theta: q, a: 0.2", "theta: q, a: 0.3, alpha: 0.7", "theta: q, a: 0.1", task="position"
    )


def test_lengths_that_make_others_have_their_unit() -> None:
    rows = "theta: q, a: r", "theta: q, a: s"
    parameters = "{x: 0.3, y: 0.4, k: 2, r: sqrt(x*x + y*y), s: k*x}"
    text = made_of(*rows, parameters=parameters, task="[x, y]")
    assert "$x = 0.3$ m, $y = 0.4$ m, $k = 2$," in text  # k x is no length of k and x alike


SLANTED = (
    "type: revolute, direction: [0, 0, 1], point: [0, 0, 0]",
    "type: revolute, direction: [1, 1, 0], point: [0, 0, 0.2]",
    "type: prismatic, direction: [0, 1, 1]",
)


def test_a_slide_that_comes_nearest_is_singular_where_its_length_says() -> None:
    """Type 10: where its two roots meet is a factor of the determinant."""
    text = derivation_document(
        story_of(axes(*SLANTED, home="{xyz: [0.1, 0.3, 0.2]}", task="position")), "x.yaml"
    )
    singular, velocity = section(text, "Singular configurations"), section(text, "Velocity")
    condition = re.findall(r"^\| 1 \| \$D = 0\$ \| \$(.*) = 0\$ \|", singular, re.MULTILINE)
    assert condition == [r"\sqrt{2} h_y + 2 r_3"]
    assert f"({condition[0]})" in velocity
    assert f"| ${condition[0]}$ | 1 |" in velocity


@pytest.mark.parametrize("twist", ["pi/4", "0.7"])
def test_the_determinant_of_a_position_is_in_reduced_factors(twist: str) -> None:
    rows = (
        "theta: q + 20 deg, d: h, a: e, alpha: pi/2",
        "theta: q - pi/2, d: e, a: L",
        f"theta: -q, d: -2*e, a: M, alpha: {twist}",
    )
    of = story_of(table(*rows, parameters="{h: 0.35, e: 0.06, L: 0.42, M: 0.38}", task="position"))
    text = section(derivation_document(of, "x.yaml"), "Velocity")
    assert r"\det J = L M (e + L c_2 + M c_{23}) s_3" in text
    q = np.array([[0.4, -0.9, 1.3]])
    two, three = -0.9 - math.pi / 2, -1.3
    reach = 0.06 + 0.42 * math.cos(two) + 0.38 * math.cos(two + three)
    J = numeric_arm(of.algebra.chain).jacobian(q)[0, :3]
    assert np.linalg.det(J) == pytest.approx(0.42 * 0.38 * math.sin(three) * reach)


def test_a_pitch_s_rate_is_the_turn_about_a_level_axis() -> None:
    """Its slopes are taken by differences here: the tool faces away, z_1 points to its left."""
    rows = (
        "theta: q, d: d1, alpha: -pi/2",
        "theta: q, a: a2",
        "theta: q, a: a3",
        "theta: q, a: a4",
    )
    lengths = "{d1: 0.3, a2: 0.25, a3: 0.2, a4: 0.1}"
    of = story_of(table(*rows, parameters=lengths, task="[x, y, z, pitch]"))
    text = section(derivation_document(of, "x.yaml"), "Velocity")
    assert "for the pitch that of turning about $z_1$" in text
    assert r"\det J = a_2 a_3 (a_2 c_2 + a_3 c_{23} + a_4 c_{234}) s_3" in text
    arm, h = numeric_arm(of.algebra.chain), 1e-6
    q = np.array([0.4, -0.3, 0.8, -0.2])

    def named(at: FloatArray) -> FloatArray:
        T = arm.pose(at)
        return np.append(T[:3, 3], math.asin(-T[2, 0]))

    slopes = [(named(q + h * e) - named(q - h * e)) / (2.0 * h) for e in np.eye(4)]
    reach = 0.25 * math.cos(q[1]) + 0.2 * math.cos(q[1] + q[2]) + 0.1 * math.cos(sum(q[1:]))
    expected = 0.25 * 0.2 * reach * math.sin(q[2])
    assert np.linalg.det(np.transpose(slopes)) == pytest.approx(expected, rel=1e-7)


def test_a_pitch_of_a_right_angle_is_no_edge_of_the_reach() -> None:
    rows = (
        "theta: q, d: d1, alpha: -pi/2",
        "theta: q, a: a2",
        "theta: q, a: a3",
        "theta: q, a: a4",
    )
    text = made_of(
        *rows,
        parameters="{d1: 0.3, a2: 0.25, a3: 0.2, a4: 0.1}",
        task="[x, y, z, pitch]",
    )
    told = section(text, "Singular configurations")
    assert "$c_{234} = 0$ | the tool's direction is at the edge of what the joints can give" in told


def test_a_point_of_two_links_has_a_name_whatever_letters_its_equation_has() -> None:
    """Four turns that cross each other, of which the last two have no length between them."""
    text = made_of(
        "theta: q, alpha: pi/2",
        "theta: q, a: l2, alpha: -pi/2",
        "theta: q, a: l3, d: d3, alpha: -pi/2",
        "theta: q, alpha: -pi/2",
        parameters="{l2: 0.27, l3: 0.36, d3: 0.1}",
    )
    assert "the far end of the two links" in text

"""The tables and matrices printed in document 003, against the robot files."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.robots.cases import assert_close, c, dh, joint_vectors, lengths, robot, rotation, s


def test_scara_reduced_and_expanded() -> None:
    d1, a1, a2 = lengths("scara_rrp").values()
    for q in joint_vectors("scara_rrp"):
        q1, q2, d3 = q
        c1, s1, c2, s2 = c(q1), s(q1), c(q2), s(q2)
        c12, s12 = c(q1, q2), s(q1, q2)
        reduced = [
            [c12, -s12, 0, a2 * c12 + a1 * c1],
            [s12, c12, 0, a2 * s12 + a1 * s1],
            [0, 0, 1, d3 + d1],
            [0, 0, 0, 1],
        ]
        expanded = [
            [c1 * c2 - s1 * s2, -c1 * s2 - s1 * c2, 0, -a2 * s1 * s2 + a2 * c1 * c2 + a1 * c1],
            [c1 * s2 + s1 * c2, c1 * c2 - s1 * s2, 0, a2 * c1 * s2 + a2 * s1 * c2 + a1 * s1],
            [0, 0, 1, d3 + d1],
            [0, 0, 0, 1],
        ]
        assert_close(forward(robot("scara_rrp"), q), reduced)
        assert_close(forward(robot("scara_rrp"), q), expanded)


def test_arm_with_six_joints_follows_its_table() -> None:
    d1, a2, d4, d6 = lengths("arm_6r").values()
    for q in joint_vectors("arm_6r"):
        q1, q2, q3, q4, q5, q6 = q
        arm = dh(q1, d1, 0, -90) @ dh(q2, 0, a2, 0) @ dh(q3, 0, 0, -90)
        wrist = dh(q4, d4, 0, 90) @ dh(q5, 0, 0, -90) @ dh(q6, d6, 0, 0)
        assert_close(forward(robot("arm_6r"), q), arm @ wrist)


def test_arm_with_three_joints_carries_the_wrist_centre() -> None:
    d6 = lengths("arm_6r")["d6"]
    assert lengths("arm_3r").items() <= lengths("arm_6r").items()
    for q in joint_vectors("arm_6r"):
        wrist_centre = forward(robot("arm_6r"), q) @ [0, 0, -d6, 1]
        assert_close(forward(robot("arm_3r"), q[:3])[:, 3], wrist_centre)


def test_wrist_follows_its_table() -> None:
    for q in joint_vectors("wrist_zyz"):
        q4, q5, q6 = q
        expected = dh(q4, 0, 0, 90) @ dh(q5, 0, 0, -90) @ dh(q6, 0, 0, 0)
        assert_close(forward(robot("wrist_zyz"), q), expected)
        assert_close(expected, rotation("z", q4) @ rotation("y", -q5) @ rotation("z", q6))


def test_scara_with_wrist_origin_five() -> None:
    d1, a1, a2, d6 = lengths("scara_wrist").values()
    for q in joint_vectors("scara_wrist"):
        q1, q2, d3 = q[:3]
        T = forward(robot("scara_wrist"), q)
        x = a2 * c(q1, q2) + a1 * c(q1)
        y = a2 * s(q1, q2) + a1 * s(q1)
        assert_close(T @ [0, 0, -d6, 1], [x, y, d3 + d1, 1])


def test_scara_with_wrist_as_expanded_in_the_document() -> None:
    d1, a1, a2, d6 = lengths("scara_wrist").values()
    for q in joint_vectors("scara_wrist"):
        q1, q2, d3, q4, q5, q6 = q
        u = q1 + q2 - q4  # the document's four-fold products add up to cos u and sin u
        # The document's table of the wrist (twists 90, -90) turns it the other way than its
        # expanded matrix, so s5 stands here with the opposite sign; in the matrix itself the sign
        # of entry (3, 1) must be the opposite of the printed one, or its columns are not
        # orthogonal.
        c5, s5, c6, s6 = c(q5), -s(q5), c(q6), s(q6)
        expected = [
            [s6 * s(u) + c5 * c6 * c(u), -c5 * s6 * c(u) + c6 * s(u), s5 * c(u)],
            [-s6 * c(u) + c5 * c6 * s(u), -c5 * s6 * s(u) - c6 * c(u), s5 * s(u)],
            [c6 * s5, -s5 * s6, -c5],
        ]
        origin = [
            d6 * s5 * c(u) + a2 * c(q1, q2) + a1 * c(q1),
            d6 * s5 * s(u) + a2 * s(q1, q2) + a1 * s(q1),
            -c5 * d6 + d3 + d1,
        ]
        T = forward(robot("scara_wrist"), q)
        assert_close(T[:3, :3], expected)
        assert_close(T[:3, 3], origin)


def test_spherical_arm_follows_its_table() -> None:
    d1 = lengths("spherical")["d1"]
    for q in joint_vectors("spherical"):
        q1, q2, q3 = q
        T = dh(q1, d1, 0, 90) @ dh(q2, 0, 0, -90) @ dh(0, q3, 0, 0)
        assert_close(forward(robot("spherical"), q), T)
        assert_close(T[:3, 3], [-q3 * c(q1) * s(q2), -q3 * s(q1) * s(q2), d1 + q3 * c(q2)])


def test_arms_whose_figures_are_lost() -> None:
    for q in joint_vectors("cartesian"):
        assert_close(forward(robot("cartesian"), q)[:3, 3], q[::-1])
    d1, a3 = lengths("rpr").values()
    for q1, q2, q3 in joint_vectors("rpr"):
        out = q2 + a3 * s(q3)
        expected = [-out * s(q1), out * c(q1), d1 - a3 * c(q3)]
        assert_close(forward(robot("rpr"), [q1, q2, q3])[:3, 3], expected)
    d1 = lengths("rpp")["d1"]
    for q1, q2, q3 in joint_vectors("rpp"):
        expected = [-q2 * s(q1), q2 * c(q1), d1 + q3]
        assert_close(forward(robot("rpp"), [q1, q2, q3])[:3, 3], expected)


def test_slider_with_link() -> None:
    a = lengths("planar_pr")["a"]
    for q1, q2 in joint_vectors("planar_pr"):
        expected = [np.sqrt(3) / 2 * q1 + a * c(q2), q1 / 2 + a * s(q2)]
        assert_close(forward(robot("planar_pr"), [q1, q2])[:2, 3], expected)


@pytest.mark.parametrize("ahead", [1.0, -1.0])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_exercise_2_has_the_pose_of_its_sentence(side: float, ahead: float) -> None:
    """z_f at 45 degrees in the plane of x_0 and y_0, x_f upright, the origin at (-1, 2, 3)."""
    readme = Path(__file__).resolve().parents[2] / "docs/fr/README.md"
    text = readme.read_text(encoding="utf-8")
    (matrix,) = re.findall(r"U_0 = \\begin\{bmatrix\} (.*?) \\end\{bmatrix\}", text)
    half = r"\frac{\sqrt{2}}{2}"
    signs = {r"\sigma_x": side, r"\sigma_y": ahead, r"-\sigma_x": -side}
    values = {f"{word} {half}": value * np.sqrt(0.5) for word, value in signs.items()}
    cells = [row.split(" & ") for row in matrix.split(r" \\ ")]
    U = np.array([[values[c] if c in values else float(c) for c in row] for row in cells])
    x, y, z, origin = U[:3].T
    assert_close(x, [0, 0, 1])
    assert_close(y, np.cross(z, x))
    assert_close(z, [side * np.sqrt(0.5), ahead * np.sqrt(0.5), 0])
    assert_close(origin, [-1, 2, 3])
    assert U[3].tolist() == [0.0, 0.0, 0.0, 1.0]

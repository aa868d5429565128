"""The matrices and formulas printed in document 000, against the robot files."""

from __future__ import annotations

import numpy as np

from dhgen.oracle.forward import forward
from tests.robots.cases import assert_close, c, joint_vectors, lengths, robot, rotation, s


def test_planar_arm_with_three_joints() -> None:
    a1, a2, a3 = lengths("planar_rrr").values()
    for q in joint_vectors("planar_rrr"):
        q1, q2, q3 = q
        c123, s123 = c(q1, q2, q3), s(q1, q2, q3)
        expected = [
            [c123, -s123, 0, a1 * c(q1) + a2 * c(q1, q2) + a3 * c123],
            [s123, c123, 0, a1 * s(q1) + a2 * s(q1, q2) + a3 * s123],
            [0, 0, 1, 0],
            [0, 0, 0, 1],
        ]
        assert_close(forward(robot("planar_rrr"), q), expected)


def test_gripper_frame_is_a_quarter_turn_about_y() -> None:
    printed = [[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]]
    assert_close(rotation("y", np.pi / 2), printed)


def test_planar_inverse_by_the_document() -> None:
    a1, a2, a3 = lengths("planar_rrr").values()
    for q in joint_vectors("planar_rrr"):
        T = forward(robot("planar_rrr"), q)
        phi = np.arctan2(T[1, 0], T[0, 0])
        wx, wy = T[0, 3] - a3 * c(phi), T[1, 3] - a3 * s(phi)
        c2 = (wx**2 + wy**2 - a1**2 - a2**2) / (2 * a1 * a2)
        for sign in (1, -1):
            s2 = sign * np.sqrt(max(0.0, 1 - c2**2))
            q2 = np.arctan2(s2, c2)
            s1 = (a1 + a2 * c2) * wy - a2 * s2 * wx
            c1 = (a1 + a2 * c2) * wx + a2 * s2 * wy
            q1 = np.arctan2(s1, c1)
            again = forward(robot("planar_rrr"), [q1, q2, phi - q1 - q2])
            # the square root halves the digits where the arm is stretched
            assert_close(again, T, 1e7 if abs(s2) < 1e-6 else 1e2)


def test_spherical_arm_with_offset() -> None:
    d2 = lengths("spherical_offset")["d2"]
    for q in joint_vectors("spherical_offset"):
        q1, q2, d3 = q
        c1, s1, c2, s2 = c(q1), s(q1), c(q2), s(q2)
        expected = [
            [c1 * c2, -s1, c1 * s2, c1 * s2 * d3 - s1 * d2],
            [s1 * c2, c1, s1 * s2, s1 * s2 * d3 + c1 * d2],
            [-s2, 0, c2, c2 * d3],
            [0, 0, 0, 1],
        ]
        assert_close(forward(robot("spherical_offset"), q), expected)


def test_planar_arm_with_a_slide() -> None:
    for q1, d2 in joint_vectors("planar_rp"):
        T = forward(robot("planar_rp"), [q1, d2])
        assert_close(T[:3, 3], [d2 * c(q1), d2 * s(q1), 0])


def test_planar_arm_with_a_slide_inverse() -> None:
    for q1, d2 in joint_vectors("planar_rp"):
        x, y = d2 * c(q1), d2 * s(q1)
        again = forward(robot("planar_rp"), [np.arctan2(y, x), np.hypot(x, y)])
        assert_close(again[:2, 3], [x, y])

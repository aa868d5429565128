"""The matrices and formulas of document 001, against the robot files."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.robots.cases import about, assert_close, c, joint_vectors, lengths, robot, rotation, s


def test_scara_moves_the_working_point_of_exercise_10() -> None:
    L1, L2, L4 = lengths("scara").values()
    for q in joint_vectors("scara"):
        q1, q2, q3, q4 = q
        x = L1 * c(q1) + L2 * c(q1, q2) + L4 * c(q1, q2, q4)
        y = L1 * s(q1) + L2 * s(q1, q2) + L4 * s(q1, q2, q4)
        c124, s124 = c(q1, q2, q4), s(q1, q2, q4)
        expected = [[c124, -s124, 0, x], [s124, c124, 0, y], [0, 0, 1, q3], [0, 0, 0, 1]]
        assert_close(forward(robot("scara"), q), expected)


def test_scara_is_the_product_of_exercise_9b() -> None:
    L1, L2, L4 = lengths("scara").values()
    for q in joint_vectors("scara"):
        lift = np.eye(4)
        lift[2, 3] = q[2]
        K = (
            about("z", q[0], [0, 0, 0])
            @ about("z", q[1], [L1, 0, 0])
            @ lift
            @ about("z", q[3], [L1 + L2, 0, 0])
        )
        at_reference = np.eye(4)
        at_reference[0, 3] = L1 + L2 + L4
        assert_close(forward(robot("scara"), q), K @ at_reference)


def test_puma_is_the_product_of_its_six_matrices() -> None:
    L2, D3, D4 = lengths("puma").values()
    for q in joint_vectors("puma"):
        K1 = about("z", q[0], [0, 0, 0])
        K2 = about("x", q[1], [0, 0, 0])
        K3 = about("x", q[2], [0, 0, L2])
        K4 = about("z", q[3], [D3, 0, 0])
        K5 = about("x", q[4], [0, 0, L2 + D4])
        K6 = about("z", q[5], [D3, 0, 0])
        assert_close(forward(robot("puma"), q), K1 @ K2 @ K3 @ K4 @ K5 @ K6)


def test_puma_matrices_five_and_six_as_printed() -> None:
    L2, D3, D4 = lengths("puma").values()
    q5, q6 = 0.7, -1.9
    v5, v6 = 1 - c(q5), 1 - c(q6)
    K5 = [
        [1, 0, 0, 0],
        [0, c(q5), -s(q5), (L2 + D4) * s(q5)],
        [0, s(q5), c(q5), (L2 + D4) * v5],
        [0, 0, 0, 1],
    ]
    K6 = [[c(q6), -s(q6), 0, D3 * v6], [s(q6), c(q6), 0, -D3 * s(q6)], [0, 0, 1, 0], [0, 0, 0, 1]]
    assert_close(forward(robot("puma"), [0, 0, 0, 0, q5, 0]), K5)
    assert_close(forward(robot("puma"), [0, 0, 0, 0, 0, q6]), K6)


def test_planar_arm() -> None:
    L1, L2 = lengths("planar_rr").values()
    for q in joint_vectors("planar_rr"):
        q1, q2 = q
        expected = [L1 * c(q1) + L2 * c(q1, q2), L1 * s(q1) + L2 * s(q1, q2)]
        assert_close(forward(robot("planar_rr"), q)[:2, 3], expected)


@pytest.mark.parametrize(("name", "axes"), [("wrist_zxz", "zxz"), ("wrist_cardan", "yzx")])
def test_wrists_are_products_of_rotations(name: str, axes: str) -> None:
    for q in joint_vectors(name):
        R4, R5, R6 = (rotation(axis, angle) for axis, angle in zip(axes, q, strict=True))
        assert_close(forward(robot(name), q), R4 @ R5 @ R6)

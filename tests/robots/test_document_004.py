"""The matrices U and the inverse of document 004 (RRPRRR), against the robot file."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from dhgen.oracle.forward import forward
from dhgen.oracle.poses import random_joints
from dhgen.program.interpret import interpret
from tests.derivation.stories import story
from tests.robots.cases import assert_close, c, joint_vectors, robot, s

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray


def test_wrist_is_t36_from_both_sides() -> None:
    for q in joint_vectors("rrprrr"):
        q1, q2, q3, q4, q5, q6 = q
        c1, s1, c2, s2 = c(q1), s(q1), c(q2), s(q2)
        c4, s4, c5, s5, c6, s6 = c(q4), s(q4), c(q5), s(q5), c(q6), s(q6)
        (t11, _, t13, t14), (t21, _, t23, t24), (t31, _, t33, t34) = forward(robot("rrprrr"), q)[:3]
        from_joints = [
            [c4 * c5 * c6 - s4 * s6, c4 * s5, 0],
            [s4 * c5 * c6 + c4 * s6, s4 * s5, 0],
            [-s5 * c6, c5, 0],
        ]
        from_pose = [
            [
                c2 * (c1 * t11 + s1 * t21) + s2 * t31,
                c2 * (c1 * t13 + s1 * t23) + s2 * t33,
                c2 * (c1 * t14 + s1 * t24) + s2 * t34,
            ],
            [s1 * t11 - c1 * t21, s1 * t13 - c1 * t23, s1 * t14 - c1 * t24],
            [
                s2 * (c1 * t11 + s1 * t21) - c2 * t31,
                s2 * (c1 * t13 + s1 * t23) - c2 * t33,
                s2 * (c1 * t14 + s1 * t24) - c2 * t34 - q3,
            ],
        ]
        assert_close(from_pose, from_joints)


def test_inverse_by_the_document_gives_the_pose_eight_times() -> None:
    for q in random_joints(robot("rrprrr"), 20):
        T = forward(robot("rrprrr"), q)
        for signs in product((1, -1), repeat=3):
            assert_close(forward(robot("rrprrr"), document_inverse(T, *signs)), T, 1e3)


def test_its_signs_are_those_of_rows_but_for_that_of_the_wrist() -> None:
    """D = -e1 sqrt(t14^2 + t24^2) there; e5 is minus the sign of the step for joint 4."""
    q = random_joints(robot("rrprrr"), 20)
    T = np.array([forward(robot("rrprrr"), each) for each in q])
    found = interpret(story("rrprrr").program, T, np.zeros_like(q), np.zeros((20, 0)))
    for pose, rows in zip(T, found.q, strict=True):
        for row, (e1, e2, e4) in zip(rows, product((1, -1), repeat=3), strict=True):
            off = row - document_inverse(pose, -e1, e2, -e4)
            off[[0, 1, 3, 4, 5]] = np.angle(np.exp(1j * off[[0, 1, 3, 4, 5]]))
            assert_close(off, np.zeros(6), 1e4)


def document_inverse(T: FloatArray, e1: int, e2: int, e5: int) -> list[float]:
    """The algorithm away from the singular poses."""
    (t11, _, t13, t14), (t21, _, t23, t24), (t31, _, t33, t34) = T[:3]
    D = e1 * np.hypot(t14, t24)
    s1, c1 = t24 / D, t14 / D
    F = np.hypot(D, t34)
    s2, c2 = e2 * D / F, -e2 * t34 / F
    q3 = s2 * D - c2 * t34
    A1, A2 = c2 * (c1 * t11 + s1 * t21) + s2 * t31, c2 * (c1 * t13 + s1 * t23) + s2 * t33
    A3, A4 = s1 * t11 - c1 * t21, s1 * t13 - c1 * t23
    A5, A6 = s2 * (c1 * t11 + s1 * t21) - c2 * t31, s2 * (c1 * t13 + s1 * t23) - c2 * t33
    s5 = e5 * np.sqrt(1 - A6**2)
    s4, c4, c6 = A4 / s5, A2 / s5, -A5 / s5
    s6 = -A1 * s4 + A3 * c4
    angles = [np.arctan2(s4, c4), np.arctan2(s5, A6), np.arctan2(s6, c6)]
    return [np.arctan2(s1, c1), np.arctan2(s2, c2), q3, *angles]


CONFIGURATIONS = {  # by (e1, e2): q1, q2, the sign of q3, q5, and e2 q4 + q6 of the whole turns
    (1, 1): (-90, -90, 1, 0, 180),
    (1, -1): (-90, 90, -1, 180, 180),
    (-1, 1): (90, 90, 1, 0, 0),
    (-1, -1): (90, -90, -1, 180, 0),
}


def test_the_table_of_configurations_takes_the_pose_of_the_figure() -> None:
    """Four configurations of the reference figure, each with any q4."""
    figure = np.radians([90.0, 90.0, 0.0, 0.0, 0.0, 0.0])
    figure[2] = 0.4
    T = forward(robot("rrprrr"), figure)
    for (_, e2), (q1, q2, facing, q5, left) in CONFIGURATIONS.items():
        for q4 in (0.0, 0.9):
            q6 = np.radians(left) - e2 * q4
            q = [np.radians(q1), np.radians(q2), facing * 0.4, q4, np.radians(q5), q6]
            assert_close(forward(robot("rrprrr"), q), T)


def test_the_program_gives_the_table_of_configurations() -> None:
    """The rows with free joints of the pose of the figure, with the seed's q4."""
    figure = np.array([np.pi / 2, np.pi / 2, 0.4, 0.0, 0.0, 0.0])
    of = story("rrprrr")
    T, seed = forward(robot("rrprrr"), figure)[None], np.array([[0.0, 0.0, 0.0, 0.3, 0.0, 0.0]])
    found = interpret(of.program, T, seed, np.zeros((1, 0)))
    rows = found.q[0][found.solved[0]]
    assert found.free[0][found.solved[0]].all()
    expected = set()
    for (_, e2), (q1, q2, facing, q5, left) in CONFIGURATIONS.items():
        q6 = np.degrees(np.arctan2(*(f(np.radians(left) - e2 * 0.3) for f in (np.sin, np.cos))))
        expected.add((q1, q2, facing * 0.4, round(np.degrees(0.3)), abs(q5), round(q6)))
    told = {
        (round(np.degrees(q[0])), round(np.degrees(q[1])), round(q[2], 9), round(np.degrees(q[3])),
         abs(round(np.degrees(q[4]))), round(np.degrees(q[5])))
        for q in rows
    }  # fmt: skip
    assert told == expected

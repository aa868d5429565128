"""The matrices and the inverse printed in document 002, against the robot files."""

from __future__ import annotations

import numpy as np

from dhgen.oracle.forward import forward
from tests.robots.cases import assert_close, c, joint_vectors, lengths, robot, s

Z = np.array([[0, 0, 1, 0], [1, 0, 0, 0], [0, 1, 0, 500], [0, 0, 0, 1]])
E_INVERSE = np.array([[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 1, -175], [0, 0, 0, 1]])
MILLIMETRES = 1e3


def test_planar_arm() -> None:
    L1, L2 = lengths("planar_rr").values()
    for q in joint_vectors("planar_rr"):
        q1, q2 = q
        c12, s12 = c(q1, q2), s(q1, q2)
        expected = [
            [c12, -s12, 0, L1 * c(q1) + L2 * c12],
            [s12, c12, 0, L1 * s(q1) + L2 * s12],
            [0, 0, 1, 0],
            [0, 0, 0, 1],
        ]
        assert_close(forward(robot("planar_rr"), q), expected)


def test_adept_is_z_t_e() -> None:
    L1, L2 = 600, 550
    for q in joint_vectors("adept"):
        q1, q2, d = q
        c12, s12 = c(q1, q2), s(q1, q2)
        T = [
            [c12, s12, 0, L1 * c(q1) + L2 * c12],
            [s12, -c12, 0, L1 * s(q1) + L2 * s12],
            [0, 0, -1, 1075 - d],
            [0, 0, 0, 1],
        ]
        pos = forward(robot("adept"), q)
        assert_close(np.linalg.inv(Z) @ pos @ E_INVERSE, T, MILLIMETRES)


def test_adept_inverse() -> None:
    for q in joint_vectors("adept"):
        pos = forward(robot("adept"), q)
        _, sy, sz = pos[:3, 1]
        px, py, pz = pos[:3, 3]
        q1 = np.arctan2(pz - 500 - 550 * sz, py - 550 * sy)
        q2 = np.arctan2(sz, sy) - q1
        # The document's equation is 1075 - d = 175 + px; its last line, d = 900 + px, has the
        # sign of px wrong.
        d = 900 - px
        assert_close(forward(robot("adept"), [q1, q2, d]), pos, MILLIMETRES)
        assert_close(d, q[2], MILLIMETRES)


def test_adept_equations_between_pose_and_joints() -> None:
    for q in joint_vectors("adept"):
        q1, q2, d = q
        (nx, sx, ax, px), (ny, sy, ay, py), (nz, sz, az, pz) = forward(robot("adept"), q)[:3]
        assert_close([c(q1, q2), s(q1, q2)], [sy, sz])
        assert_close([s(q1, q2), c(q1, q2)], [-ny, nz])
        assert_close([sx, nx, ay, az, ax], [0, 0, 0, 0, -1])
        assert_close(600 * c(q1) + 550 * c(q1, q2), py - 175 * ay, MILLIMETRES)
        assert_close(600 * s(q1) + 550 * s(q1, q2), pz - 175 * az - 500, MILLIMETRES)
        assert_close(1075 - d, px - 175 * ax, MILLIMETRES)

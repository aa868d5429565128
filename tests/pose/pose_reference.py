"""Rotations from their definitions in extended precision, for the pose helpers to agree with."""

from __future__ import annotations

from functools import cache
from itertools import permutations, product
from typing import Any

import numpy as np

LONG = np.longdouble
DEGREE = np.arctan2(LONG(0), LONG(-1)) / 180


def elementary(axis: str, angle: Any) -> Any:
    """Rotation about a coordinate axis (document 001, exercise 5)."""
    c, s = np.cos(LONG(angle)), np.sin(LONG(angle))
    j, k = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    R = np.eye(3, dtype=LONG)
    R[j, j], R[j, k], R[k, j], R[k, k] = c, -s, s, c
    return R


def rpy(angles: Any) -> Any:
    """R = Rz(yaw) Ry(pitch) Rx(roll)."""
    roll, pitch, yaw = angles
    return elementary("z", yaw) @ elementary("y", pitch) @ elementary("x", roll)


def euler_zxz(angles: Any) -> Any:
    """R = Rz(a) Rx(b) Rz(c)."""
    a, b, c = angles
    return elementary("z", a) @ elementary("x", b) @ elementary("z", c)


def euler_zyz(angles: Any) -> Any:
    """R = Rz(a) Ry(b) Rz(c)."""
    a, b, c = angles
    return elementary("z", a) @ elementary("y", b) @ elementary("z", c)


def abc(angles: Any) -> Any:
    """R = Rz(A) Ry(B) Rx(C): turns about the axes of the frame itself, z, y, x (KUKA's manuals)."""
    a, b, c = angles
    return elementary("z", a) @ elementary("y", b) @ elementary("x", c)


def abc_deg(angles: Any) -> Any:
    """A, B, C in degrees."""
    return abc(np.asarray(angles, dtype=LONG) * DEGREE)


def wpr(angles: Any) -> Any:
    """W, P, R: turns about the fixed axes x, y, z, one after the other (FANUC's manuals)."""
    w, p, r = angles
    return elementary("z", r) @ elementary("y", p) @ elementary("x", w)


def wpr_deg(angles: Any) -> Any:
    """W, P, R in degrees."""
    return wpr(np.asarray(angles, dtype=LONG) * DEGREE)


def rotvec(vector: Any) -> Any:
    """R = exp([vector]x)."""
    v = np.asarray(vector, dtype=LONG)
    angle = np.sqrt((v * v).sum())
    return axis_angle(v, angle) if angle else np.eye(3, dtype=LONG)


def axis_angle(axis: Any, angle: Any) -> Any:
    """R = exp(angle [axis]x): the exponential series of a small part, squared back up."""
    v = np.asarray(axis, dtype=LONG)
    x, y, z = v / np.sqrt((v * v).sum())
    halvings = 8
    small = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]], dtype=LONG) * LONG(angle) / 2**halvings
    R = term = np.eye(3, dtype=LONG)
    for order in range(1, 20):
        term = term @ small / order
        R = R + term
    for _ in range(halvings):
        R = R @ R
    return R


def hamilton(p: Any, q: Any) -> Any:
    """The product of two quaternions w, x, y, z (document 001, eq. (11g))."""
    w = p[0] * q[0] - p[1:] @ q[1:]
    return np.concatenate([[w], p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])])


def quaternion_wxyz(q: Any) -> Any:
    """R v = q v q* / |q|^2 for each unit vector v."""
    quaternion = np.asarray(q, dtype=LONG)
    conjugate = quaternion * np.array([1, -1, -1, -1])
    columns = [
        hamilton(hamilton(quaternion, np.concatenate([[0], unit])), conjugate)[1:]
        for unit in np.eye(3, dtype=LONG)
    ]
    return np.array(columns).T / (quaternion @ quaternion)


def quaternion_xyzw(q: Any) -> Any:
    """The same, scalar last."""
    return quaternion_wxyz(np.roll(q, 1))


def pose(R: Any, xyz: Any = (0.0, 0.0, 0.0)) -> Any:
    """The 4x4 pose in double precision, each entry rounded once."""
    T = np.eye(4)
    T[:3, :3] = np.asarray(R, dtype=float)
    T[:3, 3] = xyz
    return T


def aligned_rotations() -> list[Any]:
    """The 24 rotations that permute the coordinate axes: the cube's."""
    matrices = [
        np.array(signs) * np.eye(3)[list(order)]
        for order in permutations(range(3))
        for signs in product((1.0, -1.0), repeat=3)
    ]
    return [R for R in matrices if np.linalg.det(R) > 0]


OFFSETS = (0.0, 1e-17, 1e-16, 3e-16, 1e-15, 3e-15, 1e-14, 1e-12, 1e-9, 1e-8, 1e-6, 1e-3)


@cache
def singular_rotations() -> list[tuple[str, Any]]:
    """At and near every singular orientation of every notation, by name."""
    random = np.random.default_rng(20)
    found = [(f"aligned {i}", R) for i, R in enumerate(aligned_rotations())]
    for offset in OFFSETS:
        for sign in (1, -1):
            near = LONG(sign) * LONG(offset)
            roll, yaw = random.uniform(-np.pi, np.pi, 2)
            axis = random.normal(size=3)
            half, quarter = LONG(np.pi), LONG(np.pi) / 2
            found += [
                (f"pitch pi/2 {near}", rpy((roll, quarter - near, yaw))),
                (f"pitch -pi/2 {near}", rpy((roll, near - quarter, yaw))),
                (f"pitch pi/2 {near}, yaw 0", rpy((roll, quarter - near, 0.0))),
                (f"zyz 0 {near}", euler_zyz((roll, near, yaw))),
                (f"zyz pi {near}", euler_zyz((roll, half - near, yaw))),
                (f"zxz 0 {near}", euler_zxz((roll, near, yaw))),
                (f"zxz pi {near}", euler_zxz((roll, half - near, yaw))),
                (f"axis 0 {near}", axis_angle(axis, near)),
                (f"axis pi {near}", axis_angle(axis, half - near)),
                (f"axis x pi {near}", axis_angle((1.0, 0.0, 0.0), half - near)),
                (f"axis -y pi {near}", axis_angle((0.0, -1.0, 0.0), half - near)),
                (f"axis z {near}", axis_angle((0.0, 0.0, 1.0), near)),
            ]
    return found


def random_rotations(count: int, seed: int = 1) -> list[Any]:
    """Uniformly distributed rotations."""
    random = np.random.default_rng(seed)
    return [quaternion_wxyz(random.normal(size=4)) for _ in range(count)]

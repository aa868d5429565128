"""What the tests of the documents share: the robots, joint vectors, and the documents' notation."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.oracle.poses import random_joints, right_angles
from dhgen.robot.load import load

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import ArrayLike

    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot

ROBOTS = Path(__file__).parents[2] / "robots"

# How many isolated solutions a pose of each robot has at most, limits left aside.
COUNTS = {
    "planar_rr": 2,
    "planar_rp": 2,
    "planar_pr": 2,
    "planar_rrr": 2,
    "spherical_offset": 4,
    "spherical": 4,
    "scara": 2,
    "scara_rrp": 2,
    "scara_wrist": 4,
    "adept": 1,
    "cartesian": 1,
    "rpr": 4,
    "rpp": 2,
    "arm_3r": 4,
    "wrist_zyz": 2,
    "wrist_zxz": 2,
    "wrist_cardan": 2,
    "arm_6r": 8,
    "puma": 8,
    "rrprrr": 8,
    "puma560": 8,
    "stanford": 8,
    "ur5": 8,
    "kuka_kr6_r900": 8,
}
NAMES = tuple(COUNTS)


@cache
def robot(name: str) -> Robot:
    """The robot of a file in robots/."""
    return load(ROBOTS / f"{name}.yaml")


def lengths(name: str) -> Mapping[str, float]:
    """The parameters of a robot by name."""
    return {parameter.name: parameter.value for parameter in robot(name).parameters}


def joint_vectors(name: str) -> FloatArray:
    """Random joint vectors and some at right angles, (N, n)."""
    return np.concatenate([random_joints(robot(name), 20), right_angles(robot(name), 20)])


def c(*angles: float) -> float:
    """c12 of the documents is c(q1, q2): the cosine of the sum."""
    return float(np.cos(sum(angles)))


def s(*angles: float) -> float:
    """The sine of the sum."""
    return float(np.sin(sum(angles)))


def rotation(axis: str, angle: float) -> FloatArray:
    """Rx, Ry, Rz of document 001, exercise 5, as 4x4."""
    T = np.eye(4)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    T[[i, i, j, j], [i, j, i, j]] = c(angle), -s(angle), s(angle), c(angle)
    return T


def about(axis: str, angle: float, point: ArrayLike) -> FloatArray:
    """[R, p - R p], the rotation about an axis through a point: document 001, equation 13."""
    T = rotation(axis, angle)
    p = np.asarray(point, dtype=float)
    T[:3, 3] = p - T[:3, :3] @ p
    return T


def dh(theta: float, d: float, a: float, alpha: float) -> FloatArray:
    """A of document 000, step 4 of the Denavit-Hartenberg procedure; alpha in degrees."""
    alpha = np.radians(alpha)
    return np.array(
        [
            [c(theta), -s(theta) * c(alpha), s(theta) * s(alpha), a * c(theta)],
            [s(theta), c(theta) * c(alpha), -c(theta) * s(alpha), a * s(theta)],
            [0, s(alpha), c(alpha), d],
            [0, 0, 0, 1],
        ]
    )


def assert_close(actual: Any, expected: Any, scale: float = 1.0) -> None:
    """Equal to a few roundings of numbers as large as `scale`."""
    np.testing.assert_allclose(actual, expected, rtol=0, atol=1e-14 * scale)

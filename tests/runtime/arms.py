"""Arms in the plane for tests of the runtime, and its functions with and without numba."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.runtime.python.arm import Arm
from dhgen.runtime.python.numerical.arm import Arm as Links
from dhgen.runtime.python.numerical.arm import ChainJoint, Joint
from tests.runtime.plain import part

if TYPE_CHECKING:
    from collections.abc import Sequence

ENDLESS = (-math.inf, math.inf)
LENGTHS = np.array([0.5, 0.4])


def arm_of(types: str, limits: Sequence[tuple[float, float]], **others: Any) -> Arm:
    """An arm of which nothing but these facts is out of the ordinary; its size is 1/2."""
    count = len(types)
    arm = Arm(
        types=types,
        limits=tuple(limits),
        slacks=(1e-9,) * count,
        weights=tuple(1.0 if kind == "R" else 4.0 for kind in types),
        paces=tuple(1.0 if kind == "R" else 0.5 for kind in types),
        fan_steps=tuple(math.pi / 32 if kind == "R" else 0.01 for kind in types),
        rows=2,
        directions="none",
        miss_weights=(2.0, 2.0, 0.0, 0.0, 0.0, 0.0),
        size=0.5,
        clamped=1e-14,
        clamped_again=1e-14,
        entries=(3, 7),
    )
    return replace(arm, **others)


@cache
def called(kind: str, module: str, name: str) -> Any:
    """A function of the runtime that compiled code calls, from Python."""
    function = getattr(part(kind, module), name)
    if kind == "plain":
        return function
    from numba import njit  # noqa: PLC0415  only where there is one

    return njit(error_model="numpy")(lambda *values: function(*values))  # noqa: PLW0108  numba wants one


def links_of(**others: Any) -> Links:
    """The same arm as descents work on it."""
    joints = tuple(ChainJoint(_along_x(length)) for length in LENGTHS.tolist())
    arm = Links(
        rows=2,
        size=0.5,
        coordinates=(0, 1),
        directions="none",
        joints=(Joint(0), Joint(1)),
        base=_along_x(0.0),
        chain=joints,
    )
    return replace(arm, **others)


def _along_x(length: float) -> tuple[float, ...]:
    return (1.0, 0.0, 0.0, length, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)


def elbow(q: Any, sign: float) -> Any:
    """The joint values of the other row: the arm mirrored at the line to its tool."""
    x, y = position(q)
    a, b = LENGTHS
    bend = sign * math.acos(min(max((x * x + y * y - a * a - b * b) / (2 * a * b), -1.0), 1.0))
    turn = math.atan2(y, x) - math.atan2(b * math.sin(bend), a + b * math.cos(bend))
    return np.array([turn, bend])


def position(q: Any) -> Any:
    """Where two links in the plane lead."""
    angles = np.cumsum(q)
    return np.array([LENGTHS @ np.cos(angles), LENGTHS @ np.sin(angles)])


def pose_at(q: Any) -> tuple[float, ...]:
    """The upper three rows of the pose of joint values."""
    c, s = math.cos(q[0] + q[1]), math.sin(q[0] + q[1])
    x, y = position(q)
    return (c, -s, 0.0, float(x), s, c, 0.0, float(y), 0.0, 0.0, 1.0, 0.0)


@cache
def planar(kind: str) -> Any:
    """A robot of two turning joints in the plane: its functions, by addresses.

    In the place of the arm angle is joint 1.
    """
    how, arm = part(kind, "jit").of_file(__file__), part(kind, "arm")
    array = "float64[:, ::1](float64[::1])"
    a, b = 0.5, 0.4

    @how.apart(array)  # type: ignore[untyped-decorator]
    def fk(q: Any) -> Any:
        T = np.zeros((4, 4))
        T[0, 0] = T[1, 1] = math.cos(q[0] + q[1])
        T[1, 0] = math.sin(q[0] + q[1])
        T[0, 1] = -T[1, 0]
        T[2, 2] = T[3, 3] = 1.0
        T[0, 3] = a * math.cos(q[0]) + b * T[0, 0]
        T[1, 3] = a * math.sin(q[0]) + b * T[1, 0]
        return T

    @how.apart(array)  # type: ignore[untyped-decorator]
    def jacobian(q: Any) -> Any:
        J = np.zeros((6, 2))
        c, s = math.cos(q[0] + q[1]), math.sin(q[0] + q[1])
        J[0, 1], J[1, 1] = -b * s, b * c
        J[0, 0], J[1, 0] = J[0, 1] - a * math.sin(q[0]), J[1, 1] + a * math.cos(q[0])
        J[5, 0] = J[5, 1] = 1.0
        return J

    @how.apart(arm.SOLVES)  # type: ignore[untyped-decorator]
    def solve(pose: Any, q_free: Any, seed: Any, moved: Any, q: Any, status: Any) -> None:  # noqa: ARG001
        """Joint 1 is taken from the seed: joint 2 leads to the height, if it can."""
        sine = (pose[7] - a * math.sin(seed[0])) / b
        if abs(sine) > 1.0:
            for row in range(2):
                status[row] = 128 + 1
                q[row, 0] = 1.0 - abs(sine)
            return
        for row in range(2):
            angle = math.asin(sine)
            q[row, 0] = seed[0]
            q[row, 1] = (math.pi - angle if row == 1 else angle) - seed[0]
            status[row] = 2

    @how.apart("float64(float64[::1])")  # type: ignore[untyped-decorator]
    def first_joint(q: Any) -> Any:
        return q[0]

    @how.apart(arm.MISSES)  # type: ignore[untyped-decorator]
    def first_joint_miss(T: Any, q_free: Any, q: Any, off: Any) -> None:  # noqa: ARG001
        off[0], off[1], off[2], off[3] = q_free[0] - q[0], 1.0, 0.0, 0.0

    given = how.addresses("solve", "fk", "jacobian", "first_joint", "first_joint_miss")
    if kind == "plain":
        return given()
    from numba import njit  # noqa: PLC0415  only where there is one

    return njit(lambda: given())()  # noqa: PLW0108  numba wants one


@cache
def tilting(kind: str) -> Any:
    """A robot that turns about y and then about x: pitch and roll, by addresses."""
    how, array = part(kind, "jit").of_file(__file__), "float64[:, ::1](float64[::1])"

    @how.apart(array)  # type: ignore[untyped-decorator]
    def tilting_fk(q: Any) -> Any:
        T = np.eye(4)
        c, s, d, r = math.cos(q[0]), math.sin(q[0]), math.cos(q[1]), math.sin(q[1])
        T[0, 0], T[0, 1], T[0, 2] = c, s * r, s * d
        T[1, 1], T[1, 2] = d, -r
        T[2, 0], T[2, 1], T[2, 2] = -s, c * r, c * d
        return T

    @how.apart(array)  # type: ignore[untyped-decorator]
    def tilting_jacobian(q: Any) -> Any:
        J = np.zeros((6, 2))
        J[4, 0], J[3, 1], J[5, 1] = 1.0, math.cos(q[0]), -math.sin(q[0])
        return J

    given = how.addresses(None, "tilting_fk", "tilting_jacobian", None, None)
    if kind == "plain":
        return given()
    from numba import njit  # noqa: PLC0415  only where there is one

    return njit(lambda: given())()  # noqa: PLW0108  numba wants one

# SPDX-License-Identifier: MIT
"""Poses in other notations: a 4x4 pose to and from what people and vendors write.

Part of dhgen, which puts a copy of this file beside the robots that it generates.

A pose T is a row-major (4, 4) array: rotation R = T[:3, :3], position xyz = T[:3, 3] in the unit of
length of the caller, last row 0 0 0 1. Angles are in radians, but in degrees where the name says
deg. `from_...` make a (4, 4) pose of xyz, (3,), and an orientation; `to_...` give these. The
functions take arrays, lists and tuples, leave them as they are and return new arrays of float64;
numba functions may call them with arrays.

They raise ValueError for a wrong length, for NaN and infinity, for a zero quaternion or axis, and
for a T that is not a rotation and a translation: scaled, sheared, mirrored, transposed. A T that is
only rounded, to float32 or to six decimals, is read to within that rounding.

Reading a pose and writing it again gives the same T to about 1e-15, at and near the singular
orientations too, where angles are not unique: each function documents which it returns.

"Document 001" is one of the course texts that dhgen follows, a chapter on kinematics in French. Its
sections 2.1.5 (axis and angle, quaternions) and 2.1.8 (Euler angles, roll-pitch-yaw) name these
notations; what is taken from it is written out here.
"""

from __future__ import annotations

import math
import sys
import warnings
from functools import wraps
from hashlib import sha256
from inspect import signature
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, TypeVar

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from numpy.typing import NDArray

    Array = NDArray[np.float64]

Made = TypeVar("Made")

try:
    from numba import njit
    from numba.extending import overload
except ImportError:  # functions stay what they are: they work as plain Python too
    _as_it_is: Any = lambda *_unused, **_options: lambda function: function  # noqa: E731
    njit = overload = _as_it_is

# Compiled code finds this file, and no other text of it, in sys.modules: when that was compiled it
# may have been imported by another name than now. In an archive there is no file, and nothing
# compiled is kept.
_FILE = Path(__file__)
_KEY = f"dhgen_pose {sha256(_FILE.read_bytes() if _FILE.is_file() else b'').hexdigest()[:16]}"
sys.modules[_KEY] = ModuleType(_KEY)

_KEEPS = True
try:
    njit(cache=True)(lambda: None)
except RuntimeError:
    _KEEPS = False
    warnings.warn(
        f"numba can't cache what it compiles of {__file__}, neither next to it nor in the user's "
        "cache folder, and compiles it again in every process: set NUMBA_CACHE_DIR to a "
        "writable folder",
        stacklevel=2,
    )


def _jit(function: Callable[..., Made]) -> Callable[..., Made]:
    """Compile a function, once and for all names by which this file may be imported."""
    function.__module__ = _KEY
    return njit(cache=_KEEPS)(function)


# What arguments of these names hold; all others are (3,).
_SHAPES: dict[str, tuple[int, ...]] = {"T": (4, 4), "left": (4, 4), "right": (4, 4), "angle": ()}
_SHAPES |= {"quaternion_xyzw": (4,), "quaternion_wxyz": (4,)}


def _of_numbers(function: Callable[..., Made]) -> Callable[..., Made]:
    """Compile a function that takes arrays, and make arrays of what Python calls it with."""
    arguments = signature(function)
    shapes = {name: _SHAPES.get(name, (3,)) for name in arguments.parameters}

    @wraps(function)
    def call(*numbers: Any, **named: Any) -> Made:  # noqa: ANN401
        if named or len(numbers) != len(shapes):
            numbers = arguments.bind(*numbers, **named).args
        arrays = [np.asarray(each, np.float64)[()] for each in numbers]
        for array, (name, shape) in zip(arrays, shapes.items(), strict=True):
            if array.shape != shape:
                raise ValueError(f"{name} must have shape {shape}, not {array.shape}")
        return compiled(*arrays)

    compiled = _jit(function)
    overload(call, strict=False)(lambda *_numbers: function)
    return call


# How far T may be from a rigid transform, per entry of R - cof(R). Rounding every entry by 1e-6
# makes less than 5e-6; a wrong matrix is off by far more.
RIGID_TOLERANCE = 1e-5

# The sine or cosine below which two axes count as parallel: what rounding leaves of zero. It bounds
# the error of T that the convention for the indeterminate angle may cause.
PARALLEL_TOLERANCE = 1e-15

DEGREE = math.pi / 180.0


@_of_numbers
def from_xyz_rpy(xyz: Array, rpy: Array) -> Array:
    """Pose from position and roll, pitch, yaw about fixed axes: R = Rz(yaw) Ry(pitch) Rx(roll).

    Document 001, section 2.1.8; the product written out as in Paul, Robot Manipulators (1981).

    (3,) roll about x, then pitch about y, then yaw about z, all of the base frame [rad].
    """
    angles = _numbers(rpy, (3,))
    cr, sr = math.cos(angles[0]), math.sin(angles[0])
    cp, sp = math.cos(angles[1]), math.sin(angles[1])
    cy, sy = math.cos(angles[2]), math.sin(angles[2])
    T = _pose_at(xyz)
    T[0, 0], T[0, 1], T[0, 2] = cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr
    T[1, 0], T[1, 1], T[1, 2] = sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr
    T[2, 0], T[2, 1], T[2, 2] = -sp, cp * sr, cp * cr
    return T


@_of_numbers
def to_xyz_rpy(T: Array) -> tuple[Array, Array]:
    """Position and roll, pitch, yaw of a pose: R = Rz(yaw) Ry(pitch) Rx(roll).

    Gimbal lock, cos(pitch) = 0: only yaw - roll (pitch = pi/2) or yaw + roll (pitch = -pi/2) is
    determined; roll is 0 and yaw takes it all. Close to it roll and yaw feel every rounding of T,
    but roll is computed from the yaw returned, so that together they still give T.

    Returns:
        (3,) position; (3,) roll in [-pi, pi], pitch in [-pi/2, pi/2], yaw in [-pi, pi] [rad].
    """
    P = _rigid(T)
    cp = math.hypot(P[0, 0], P[1, 0])
    if cp > PARALLEL_TOLERANCE:
        # The second row of Rz(-yaw) R is 0, cos(roll), -sin(roll); the factor cp cancels.
        sr_cp = P[1, 0] * P[0, 2] - P[0, 0] * P[1, 2]
        cr_cp = P[0, 0] * P[1, 1] - P[1, 0] * P[0, 1]
        roll, yaw = _angle(sr_cp, cr_cp), _angle(P[1, 0], P[0, 0])
    else:
        roll, yaw, cp = 0.0, _angle(-P[0, 1], P[1, 1]), 0.0
    return P[:3, 3].copy(), np.array([roll, _angle(-P[2, 0], cp), yaw])


@_of_numbers
def from_xyz_quaternion_xyzw(xyz: Array, quaternion_xyzw: Array) -> Array:
    """Pose from position and quaternion, scalar last.

    Document 001, eq. (11h), with its 1 replaced by eq. (11c): R is orthonormal to rounding for a
    quaternion of any length, and no square root is taken.

    (4,) x, y, z, w of any length except 0; q and -q are the same rotation.
    """
    q = _numbers(quaternion_xyzw, (4,))
    largest = max(abs(q[0]), abs(q[1]), abs(q[2]), abs(q[3]))
    if largest == 0.0:
        raise ValueError("a zero quaternion is not a rotation")
    # Scaled first: the squares of very long or short quaternions would leave the range of floats.
    x, y, z, w = q[0] / largest, q[1] / largest, q[2] / largest, q[3] / largest
    k = 2.0 / (x * x + y * y + z * z + w * w)
    T = _pose_at(xyz)
    T[0, 0], T[0, 1], T[0, 2] = 1.0 - k * (y * y + z * z), k * (x * y - w * z), k * (x * z + w * y)
    T[1, 0], T[1, 1], T[1, 2] = k * (x * y + w * z), 1.0 - k * (x * x + z * z), k * (y * z - w * x)
    T[2, 0], T[2, 1], T[2, 2] = k * (x * z - w * y), k * (y * z + w * x), 1.0 - k * (x * x + y * y)
    return T


@_of_numbers
def to_xyz_quaternion_xyzw(T: Array) -> tuple[Array, Array]:
    """Position and unit quaternion of a pose, scalar last.

    Of q and -q the one with w >= 0 is returned; for a half turn, w = 0, the one whose first
    component other than zero is positive.

    Returns:
        (3,) position; (4,) unit quaternion x, y, z, w with w in [0, 1].
    """
    # Document 001, eq. (11i), takes each component from a root of its own. Near zero such a root
    # turns an error of 1e-16 in R into 1e-8, and for a half turn its sgn(0) loses the vector. Sums
    # and differences of R are 4 w q, 4 x q, 4 y q, 4 z q: the one with the largest factor, at least
    # 2 long, has no cancellation, and its signs belong together (Shepperd 1978).
    P = _rigid(T)
    r11, r22, r33 = P[0, 0], P[1, 1], P[2, 2]
    wx, wy, wz = P[2, 1] - P[1, 2], P[0, 2] - P[2, 0], P[1, 0] - P[0, 1]
    xy, yz, xz = P[0, 1] + P[1, 0], P[1, 2] + P[2, 1], P[0, 2] + P[2, 0]
    trace = r11 + r22 + r33
    largest = max(trace, r11, r22, r33)
    if trace == largest:
        x, y, z, w = wx, wy, wz, 1.0 + trace
    elif r11 == largest:
        x, y, z, w = 1.0 + r11 - r22 - r33, xy, xz, wx
    elif r22 == largest:
        x, y, z, w = xy, 1.0 - r11 + r22 - r33, yz, wy
    else:
        x, y, z, w = xz, yz, 1.0 - r11 - r22 + r33, wz
    length = math.sqrt(x * x + y * y + z * z + w * w)
    if w < 0.0 or (w == 0.0 and (x < 0.0 or (x == 0.0 and (y < 0.0 or (y == 0.0 and z < 0.0))))):
        length = -length
    # A zero divided by a negative length is -0.0; the sum makes it 0.0.
    q = np.array([x / length + 0.0, y / length + 0.0, z / length + 0.0, w / length + 0.0])
    return P[:3, 3].copy(), q


@_of_numbers
def from_xyz_quaternion_wxyz(xyz: Array, quaternion_wxyz: Array) -> Array:
    """Pose from position and quaternion w, x, y, z, scalar first (document 001, eq. (11a); ABB)."""
    q = _numbers(quaternion_wxyz, (4,))
    return from_xyz_quaternion_xyzw(xyz, np.array([q[1], q[2], q[3], q[0]]))


@_of_numbers
def to_xyz_quaternion_wxyz(T: Array) -> tuple[Array, Array]:
    """Position and unit quaternion of a pose, scalar first; signs as `to_xyz_quaternion_xyzw`."""
    xyz, q = to_xyz_quaternion_xyzw(T)
    return xyz, np.array([q[3], q[0], q[1], q[2]])


@_of_numbers
def from_xyz_axis_angle(xyz: Array, axis: Array, angle: float) -> Array:
    """Pose from position, axis of rotation and angle about it (document 001, eq. (10)).

    The axis may have any length, and be zero only together with angle 0, which is no rotation; the
    angle about it is right-handed [rad].
    """
    v, theta = _numbers(axis, (3,)), np.float64(angle)
    if not math.isfinite(theta):
        raise ValueError("all numbers must be finite")
    T = _pose_at(xyz)
    largest = max(abs(v[0]), abs(v[1]), abs(v[2]))
    if largest == 0.0:
        if theta != 0.0:
            raise ValueError("a zero axis with an angle other than 0 is not a rotation")
        return T
    # Scaled first: the squares of very long or short axes would leave the range of floats.
    x, y, z = v[0] / largest, v[1] / largest, v[2] / largest
    length = math.sqrt(x * x + y * y + z * z)
    x, y, z = x / length, y / length, z / length
    c, s = math.cos(theta), math.sin(theta)
    u = 1.0 - c
    T[0, 0], T[0, 1], T[0, 2] = u * x * x + c, u * x * y - s * z, u * x * z + s * y
    T[1, 0], T[1, 1], T[1, 2] = u * x * y + s * z, u * y * y + c, u * y * z - s * x
    T[2, 0], T[2, 1], T[2, 2] = u * x * z - s * y, u * y * z + s * x, u * z * z + c
    return T


@_of_numbers
def to_xyz_axis_angle(T: Array) -> tuple[Array, Array, float]:
    """Position, axis of rotation and angle of a pose.

    From the quaternion (document 001, eq. (11b)): the axis in eq. (11) is divided by sin(angle),
    which loses it near 0 and pi. Without rotation the axis is 0, 0, 1. For a half turn both axis
    and -axis are right: the one whose first component other than zero is positive is returned;
    within rounding of a half turn it may be either.

    Returns:
        (3,) position; (3,) unit axis; angle in [0, pi] [rad].
    """
    xyz, q = to_xyz_quaternion_xyzw(T)
    largest = max(abs(q[0]), abs(q[1]), abs(q[2]))
    if largest == 0.0:
        return xyz, np.array([0.0, 0.0, 1.0]), 0.0
    # Scaled first: the squares of the sines of tiny angles would underflow.
    x, y, z = q[0] / largest, q[1] / largest, q[2] / largest
    length = math.sqrt(x * x + y * y + z * z)
    angle = 2.0 * math.atan2(length * largest, q[3])
    return xyz, np.array([x / length, y / length, z / length]), angle


@_of_numbers
def from_xyz_euler_zxz(xyz: Array, euler_zxz: Array) -> Array:
    """Pose from position and Euler angles a, b, c about z, x', z'': R = Rz(a) Rx(b) Rz(c).

    Document 001, section 2.1.8, eq. (15).
    """
    angles = _numbers(euler_zxz, (3,))
    ca, sa = math.cos(angles[0]), math.sin(angles[0])
    cb, sb = math.cos(angles[1]), math.sin(angles[1])
    cc, sc = math.cos(angles[2]), math.sin(angles[2])
    T = _pose_at(xyz)
    T[0, 0], T[0, 1], T[0, 2] = ca * cc - sa * cb * sc, -ca * sc - sa * cb * cc, sa * sb
    T[1, 0], T[1, 1], T[1, 2] = sa * cc + ca * cb * sc, -sa * sc + ca * cb * cc, -ca * sb
    T[2, 0], T[2, 1], T[2, 2] = sb * sc, sb * cc, cb
    return T


@_of_numbers
def to_xyz_euler_zxz(T: Array) -> tuple[Array, Array]:
    """Position and Euler angles a, b, c of a pose: R = Rz(a) Rx(b) Rz(c).

    sin(b) = 0, first and last axis parallel: only a + c (b = 0) or a - c (b = pi) is determined;
    c is 0 and a takes it all. Close to it a and c feel every rounding of T, but c is computed from
    the a returned, so that together they still give T.

    Returns:
        (3,) position; (3,) a in [-pi, pi], b in [0, pi], c in [-pi, pi] [rad].
    """
    P = _rigid(T)
    sb = math.hypot(P[0, 2], P[1, 2])
    if sb > PARALLEL_TOLERANCE:
        # The first row of Rz(-a) R is cos(c), -sin(c), 0; the factor sb cancels.
        sc_sb = P[1, 2] * P[0, 1] - P[0, 2] * P[1, 1]
        cc_sb = P[0, 2] * P[1, 0] - P[1, 2] * P[0, 0]
        a, c = _angle(P[0, 2], -P[1, 2]), _angle(sc_sb, cc_sb)
    else:
        a, c, sb = _angle(P[1, 0], P[0, 0]), 0.0, 0.0
    return P[:3, 3].copy(), np.array([a, _angle(sb, P[2, 2]), c])


@_of_numbers
def from_xyz_euler_zyz(xyz: Array, euler_zyz: Array) -> Array:
    """Pose from position and Euler angles a, b, c about z, y', z'': R = Rz(a) Ry(b) Rz(c).

    Document 001, eq. (15) with y in place of x, as in Paul, Robot Manipulators (1981).
    """
    angles = _numbers(euler_zyz, (3,))
    ca, sa = math.cos(angles[0]), math.sin(angles[0])
    cb, sb = math.cos(angles[1]), math.sin(angles[1])
    cc, sc = math.cos(angles[2]), math.sin(angles[2])
    T = _pose_at(xyz)
    T[0, 0], T[0, 1], T[0, 2] = ca * cb * cc - sa * sc, -ca * cb * sc - sa * cc, ca * sb
    T[1, 0], T[1, 1], T[1, 2] = sa * cb * cc + ca * sc, -sa * cb * sc + ca * cc, sa * sb
    T[2, 0], T[2, 1], T[2, 2] = -sb * cc, sb * sc, cb
    return T


@_of_numbers
def to_xyz_euler_zyz(T: Array) -> tuple[Array, Array]:
    """Position and Euler angles a, b, c of a pose: R = Rz(a) Ry(b) Rz(c).

    The ranges of the angles, and what is returned for sin(b) = 0, are as in `to_xyz_euler_zxz`.
    """
    P = _rigid(T)
    sb = math.hypot(P[0, 2], P[1, 2])
    if sb > PARALLEL_TOLERANCE:
        # The second row of Rz(-a) R is sin(c), cos(c), 0; the factor sb cancels.
        sc_sb = P[0, 2] * P[1, 0] - P[1, 2] * P[0, 0]
        cc_sb = P[0, 2] * P[1, 1] - P[1, 2] * P[0, 1]
        a, c = _angle(P[1, 2], P[0, 2]), _angle(sc_sb, cc_sb)
    else:
        a, c, sb = _angle(-P[0, 1], P[1, 1]), 0.0, 0.0
    return P[:3, 3].copy(), np.array([a, _angle(sb, P[2, 2]), c])


@_of_numbers
def from_xyz_rotvec(xyz: Array, rotvec: Array) -> Array:
    """Pose from position and rotation vector, axis times angle [rad]: rx, ry, rz of UR."""
    v = _numbers(rotvec, (3,))
    return from_xyz_axis_angle(xyz, v, math.hypot(math.hypot(v[0], v[1]), v[2]))


@_of_numbers
def to_xyz_rotvec(T: Array) -> tuple[Array, Array]:
    """Position and rotation vector of a pose, at most pi long; signs as `to_xyz_axis_angle`."""
    xyz, axis, angle = to_xyz_axis_angle(T)
    return xyz, axis * angle


@_of_numbers
def from_xyz_abc(xyz: Array, abc: Array) -> Array:
    """Pose from position and KUKA's A, B, C [rad]: R = Rz(A) Ry(B) Rx(C)."""
    return from_xyz_rpy(xyz, _numbers(abc, (3,))[::-1].copy())


@_of_numbers
def to_xyz_abc(T: Array) -> tuple[Array, Array]:
    """Position and KUKA's A, B, C of a pose [rad]; A, B, C are yaw, pitch, roll."""
    xyz, rpy = to_xyz_rpy(T)
    return xyz, rpy[::-1].copy()


@_of_numbers
def from_xyz_abc_deg(xyz: Array, abc_deg: Array) -> Array:
    """Pose from position and KUKA's A, B, C [degrees]."""
    return from_xyz_abc(xyz, _numbers(abc_deg, (3,)) * DEGREE)


@_of_numbers
def to_xyz_abc_deg(T: Array) -> tuple[Array, Array]:
    """Position and KUKA's A, B, C of a pose [degrees]."""
    xyz, abc = to_xyz_abc(T)
    return xyz, abc / DEGREE


@_of_numbers
def from_xyz_wpr(xyz: Array, wpr: Array) -> Array:
    """Pose from position and W, P, R of FANUC, Rx, Ry, Rz of Yaskawa [rad]: they are rpy."""
    return from_xyz_rpy(xyz, wpr)


@_of_numbers
def to_xyz_wpr(T: Array) -> tuple[Array, Array]:
    """Position and W, P, R of FANUC, Rx, Ry, Rz of Yaskawa, of a pose [rad]: they are rpy."""
    return to_xyz_rpy(T)


@_of_numbers
def from_xyz_wpr_deg(xyz: Array, wpr_deg: Array) -> Array:
    """Pose from position and W, P, R of FANUC, Rx, Ry, Rz of Yaskawa: rpy in degrees."""
    return from_xyz_wpr(xyz, _numbers(wpr_deg, (3,)) * DEGREE)


@_of_numbers
def to_xyz_wpr_deg(T: Array) -> tuple[Array, Array]:
    """Position and W, P, R of FANUC, Rx, Ry, Rz of Yaskawa, of a pose: rpy in degrees."""
    xyz, wpr = to_xyz_wpr(T)
    return xyz, wpr / DEGREE


@_of_numbers
def multiply(left: Array, right: Array) -> Array:
    """Pose `right`, given in the frame `left`, in the frame that `left` is given in."""
    P, Q = _rigid(left), _rigid(right)
    T = np.eye(4)
    for i in range(3):
        for j in range(4):
            T[i, j] = P[i, 0] * Q[0, j] + P[i, 1] * Q[1, j] + P[i, 2] * Q[2, j]
        T[i, 3] += P[i, 3]
    return T


@_of_numbers
def inverse(T: Array) -> Array:
    """Pose of the frame that T is given in, in the frame T."""
    P, Q = _rigid(T), np.eye(4)
    for i in range(3):
        for j in range(3):
            Q[i, j] = P[j, i]
        Q[i, 3] = -(P[0, i] * P[0, 3] + P[1, i] * P[1, 3] + P[2, i] * P[2, 3])
    return Q


@_jit
def _angle(sine: float, cosine: float) -> float:
    """The angle of a sine and a cosine with any common factor; -0.0 counts as 0.0.

    Without that a half turn whose sine is -0.0 would be -pi, and no rotation would print as -0.
    """
    return math.atan2(sine + 0.0, cosine)


@_jit
def _numbers(given: Array, shape: tuple[int, ...]) -> Array:
    """A float64 copy of finite numbers: numba checks no index and computes in float32."""
    if given.shape != shape:
        raise ValueError("wrong shape: T is (4, 4), a quaternion has 4 numbers, everything else 3")
    copy = np.empty(shape)
    for place, number in np.ndenumerate(given):
        copy[place] = number
        if not math.isfinite(number):
            raise ValueError("all numbers must be finite")
    return copy


@_jit
def _pose_at(xyz: Array) -> Array:
    """The pose without rotation at a position."""
    T = np.eye(4)
    T[:3, 3] = _numbers(xyz, (3,))
    return T


@_jit
def _rigid(T: Array) -> Array:
    """A float64 copy of T, which must be a rotation and a translation.

    The matrices equal to their cofactors are the rotations, right-handed only, and zero: each row
    is the cross product of the next two, and the length of one row is that of zero or of a
    rotation.
    """
    P = _numbers(T, (4, 4))
    # Entries out of bounds end here, before their products overflow.
    for i in range(4):
        for j in range(3):
            if abs(P[i, j]) > 1.0 + RIGID_TOLERANCE:
                raise ValueError("T is not a rotation and a translation")
    deviation = max(abs(P[3, 0]), abs(P[3, 1]), abs(P[3, 2]), abs(P[3, 3] - 1.0))
    deviation = max(deviation, abs(P[0, 0] ** 2 + P[0, 1] ** 2 + P[0, 2] ** 2 - 1.0))
    for i in range(3):
        for j in range(3):
            i1, i2, j1, j2 = (i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3
            cofactor = P[i1, j1] * P[i2, j2] - P[i1, j2] * P[i2, j1]
            deviation = max(deviation, abs(cofactor - P[i, j]))
    if deviation > RIGID_TOLERANCE:
        raise ValueError("T is not a rotation and a translation")
    return P

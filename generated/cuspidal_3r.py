# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: ce9aebe8c3730ef3
"""cuspidal_3r: Cuspidal 3R arm.

Inverse kinematics, generated from robots/cuspidal_3r.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/cuspidal_3r.yaml. The formulas and where they come from:
cuspidal_3r.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] counts; other entries are ignored.
"""

import math
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

# The runtime that lies beside this file, by whatever name this is imported, and no other one: it is
# in a package named after the folder. A dot in a name would be one between packages.
_BESIDE = str(Path(__file__).resolve().parent)
_FOLDER = _BESIDE.replace("%", "%25").replace(".", "%2E")
sys.modules.setdefault(_FOLDER, ModuleType(_FOLDER)).__path__ = [_BESIDE]


def _runtime(name):
    return import_module(f"{_FOLDER}.dhgen_runtime.{name}")


_HOW = _runtime("jit").of_file(__file__, interface=1)
_arms, _status, _functions = _runtime("arm"), _runtime("status"), _runtime("functions")
_atan2 = _runtime("angles").atan2
_circle = _runtime("circle_roots")
_circle_roots = _circle.circle_roots
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 3), _runtime("arrays").zeros

NAME = "cuspidal_3r"
METHOD = "quartic"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("root1", "root2", "root3", "root4")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

a1 = 1.0  # link length 1 [m]
d2 = 1.0  # joint offset 2 [m]
a2 = 2.0  # link length 2 [m]
a3 = 1.5  # link length 3 [m]
free_limit6 = 2.7680640624999998e-08  # a length that fixes no angle [m^6]
square_rounding = 1e-15  # squares are rounded by this
free_limit_squared2 = 3.025e-23  # square of a length that fixes no angle [m^2]
near_limit_squared2 = 3.025e-05  # square of a length whose direction is good to few digits [m^2]
k1 = 3.0  # a3 * a2 [m^2]
k2 = 6.0  # 2 * a3 * a2 [m^2]
k3 = -6.25  # a1^2 - (a1^2 + (a2^2 + a3^2)) [m^2]
k4 = 0.5  # 1 / 2
k5 = 12.0  # 2 * 2 * a3 * a2 [m^2]
k6 = 36.0  # k2^2 [m^4]
k7 = 81.0  # (a3 * 2 * a3 * a2)^2 [m^6]
k8 = 0.1111111111111111  # 1 / (a3 * 2 * a3 * a2) [m^-3]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=4, size=5.5, coordinates=(0, 1, 2), directions="none",
    joints=(_joints.Joint(place=0), _joints.Joint(place=1), _joints.Joint(place=2)),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 2.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 1.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 1.5, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="none",
    miss_weights=(0.1818, 0.1818, 0.1818, 0.0, 0.0, 0.0), size=5.5, entries=(3, 7, 11),
    steps=("completes", "ascends", "follows seed"), root_turns=((0, 1.0),),
), _joints.arm_numbers(_LINKS))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 1.0, -1.5707963267948966),
    (0.0, 1.0, 2.0, 1.5707963267948966),
    (0.0, 0.0, 1.5, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2, s1 * c2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v1 = x2_x * c3 - s1 * s3, x2_y * c3 + c1 * s3, s2 * c3
    T[0, 0], T[0, 1], T[0, 2] = x3_x, -(s1 * c3 + x2_x * s3), c1 * s2
    T[0, 3] = c1 * a1 + x2_x * a2 - s1 * d2 + x3_x * a3
    T[1, 0], T[1, 1], T[1, 2] = x3_y, c1 * c3 - x2_y * s3, s1 * s2
    T[1, 3] = s1 * a1 + x2_y * a2 + c1 * d2 + x3_y * a3
    T[2, 0], T[2, 1], T[2, 2] = -v1, s2 * s3, c2
    T[2, 3] = -(s2 * a2 + v1 * a3)
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, z2_x = c1 * c2, s1 * c2, c1 * s2
    z2_y, v1, p2_x = s1 * s2, s2 * a2, p1_x + x2_x * a2 - s1 * d2
    p2_y = p1_y + x2_y * a2 + c1 * d2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    p3_x, p3_y = p2_x + (x2_x * c3 - s1 * s3) * a3, p2_y + (x2_y * c3 + c1 * s3) * a3
    v2, v3, v4 = v1 + s2 * c3 * a3, p3_x - p2_x, p3_y - p2_y
    v5 = v1 - v2
    J[0, 0], J[0, 1], J[0, 2] = -p3_y, -(c1 * v2), z2_y * v5 - c2 * v4
    J[1, 0], J[1, 1], J[1, 2] = p3_x, -(s1 * v2), c2 * v3 - z2_x * v5
    J[2, 1], J[2, 2] = -(s1 * (p3_y - p1_y) + c1 * (p3_x - p1_x)), z2_x * v4 - z2_y * v3
    J[3, 1], J[3, 2] = -s1, z2_x
    J[4, 1], J[4, 2] = c1, z2_y
    J[5, 0], J[5, 2] = 1.0, c2
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # theta1, type 9: U1[3, 4] and the squared length of column 4 of U1
    v1 = T14 * T14 + (T24 * T24 + (T34 * T34 + k3))
    R2c1 = 2.0 * (T14 * a1)
    R2s1 = 2.0 * (T24 * a1)
    v2, v3, v4 = k1 + a3 * v1, a3 * R2c1 + k1 * T24, a3 * R2s1 - k1 * T14
    v5, v6, v7 = k2 * T24, k2 * T14, v3 * v3
    v8, v9, v10 = v4 * v4, 2.0 * v2, v5 * v5
    v11 = v6 * v6
    v12, v13 = v2 * v2 + k4 * (v7 + v8) + (k6 + k4 * (v10 + v11)), v3 * v9 + v5 * k5
    v14, v15, v16 = v6 * k5 - v4 * v9, k4 * (v7 - v8) + k4 * (v10 - v11), v3 * v4 - v5 * v6
    v17 = v12 - k7
    free1 = abs(v17) + abs(v13) + abs(v14) + abs(v15) + abs(v16) <= free_limit6
    x1_roots, x1_close = _circle_roots(1.0 if free1 else v17, -1.0 if free1 else -v13, 0.0 if free1
        else v14, 0.0 if free1 else v15, 0.0 if free1 else v16, square_rounding * (v12 + k7), moved)

    for i1 in range(4):  # root1, root2, root3, root4
        x1 = x1_roots[i1]
        # theta1
        if not (x1 <= 4.0):
            continue  # out of reach
        q1 = seed[0] if free1 else x1
        c1, s1 = math.cos(q1), math.sin(q1)

        # theta3, type 3: U1[3, 4] and the squared length of column 4 of U1
        v18 = d2 + (T14 * s1 - T24 * c1)
        c3 = (a3 * (v1 - (R2c1 * c1 + R2s1 * s1)) + k1 * v18) * k8
        q3 = _atan2(-(k2 * v18 * k8), c3)

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        Y1_2 = a2 + a3 * c3
        v19 = T34 * Y1_2
        C2 = Y1_2 * (T14 * c1 + T24 * s1 - a1)
        w2 = math.sqrt(v19 * v19 + C2 * C2)
        free2 = w2 <= free_limit_squared2
        near2 = w2 <= near_limit_squared2
        factor2 = 1.0 / (1.0 if free2 else w2)
        c2 = math.cos(seed[1]) if free2 else C2 * factor2
        s2 = math.sin(seed[1]) if free2 else -(v19 * factor2)
        q2 = _atan2(s2, c2)
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
        status[row] = (
            FREE_JOINT if free1 or free2 else _status.CLOSE if x1_close[i1] or near2 else OK
        )


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "position", apart=(_circle.OWN.compile_apart, _runtime("complete").compile_apart,),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)

# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: bd0d255b66167e58
"""welding_5r: Welding arm with five joints, its torch tilted aside.

Inverse kinematics, generated from robots/welding_5r.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/welding_5r.yaml. The formulas and where they come from: welding_5r.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] and the tool's z axis T[0:3, 2] counts; other entries are ignored.
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
_wrap = _runtime("angles").wrap
_circle = _runtime("circle_roots")
_circle_roots = _circle.circle_roots
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 5), _runtime("arrays").zeros

NAME = "welding_5r"
METHOD = "quartic"
DOF = 5
JOINT_TYPES = "RRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5")
JOINT_LIMITS = (
    (-2.9670597283903604, 2.9670597283903604), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "root1-elbow+", "root1-elbow-", "root2-elbow+", "root2-elbow-", "root3-elbow+", "root3-elbow-",
    "root4-elbow+", "root4-elbow-",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.3  # joint offset 1 [m]
a1 = 0.08  # link length 1 [m]
L2 = 0.5  # link length 2 [m]
L3 = 0.45  # link length 3 [m]
d4 = 0.03  # joint offset 4 [m]
d5 = 0.12  # joint offset 5 [m]
ex = 0.02  # x of the tool frame [m]
ez = 0.1  # z of the tool frame [m]
free_limit2 = 2.5600000000000004e-12  # a length that fixes no angle [m^2]
square_rounding = 1e-15  # squares are rounded by this
near_limit = 0.001  # a length whose direction is good to few digits
double_root = 1e-13  # a polynomial's value at a root, relative to its coefficients
free_limit_squared = 1e-24  # square of a length that fixes no angle
near_limit_squared = 1e-06  # square of a length whose direction is good to few digits
longest3 = 0.9025  # square of the longest reach [m^2]
shortest3 = 0.0024999999999999988  # square of the shortest reach [m^2]
longest3_reach = 0.902530400256  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0024984002559999986  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.9024999999999695  # the longest, where branches merge [m^2]
shortest3_apart = 0.002500000000001599  # the shortest, where branches merge [m^2]
longest3_clear = 0.9024999999696  # the longest, where blurred branches do [m^2]
shortest3_clear = 0.002500000001599999  # the shortest, where blurred branches do [m^2]
free_limit_squared2 = 2.5600000000000005e-24  # square of a length that fixes no angle [m^2]
# square of a length whose direction is good to few digits [m^2]
near_limit_squared2 = 2.5600000000000005e-06
k1 = 0.5  # 1 / 2
k2 = 0.06  # d4 * 2 [m]
k3 = 0.0009  # d4^2 [m^2]
k4 = 0.0004  # ex^2 [m^2]
k5 = -50.0  # -1 / ex [m^-1]
k6 = 0.4525  # L2^2 + L3^2 [m^2]
k7 = 2.2222222222222223  # 1 / (2 * L3 * L2) [m^-2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=8, size=1.6, coordinates=(0, 1, 2), directions="pointing",
    joints=(
        _joints.Joint(place=0, lowest=-2.9670597283903604, highest=2.9670597283903604),
        _joints.Joint(place=1),
        _joints.Joint(place=2),
        _joints.Joint(place=3),
        _joints.Joint(place=4),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.08, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.3)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.5, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.45, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.03)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.02, 0.0, 0.0, -1.0, -0.1, 0.0, 1.0, 0.0, 0.12)),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="pointing",
    miss_weights=(0.625, 0.625, 0.625, 1.0, 1.0, 1.0), size=1.6, entries=(2, 3, 6, 7, 10, 11),
    steps=("retries", "keeps limits", "completes", "merges", "clamps", "follows seed"),
    choosable=(3, 2, 1, 0), root_turns=((0, 1.0),),
), _joints.arm_numbers(_LINKS))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.3, 0.08, 1.5707963267948966),
    (0.0, 0.0, 0.5, 0.0),
    (0.0, 0.0, 0.45, 0.0),
    (0.0, 0.03, 0.0, 1.5707963267948966),
    (0.0, 0.12, 0.0, 1.5707963267948966),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    tool=(1.0, 0.0, 0.0, 0.02, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.1),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v3, v4, y3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - v3 * s4, x3_y * c4 - v4 * s4, x3_z * c4 + y3_z * s4
    z4_x, z4_y, z4_z = v3 * c4 + x3_x * s4, v4 * c4 + x3_y * s4, x3_z * s4 - y3_z * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + s1 * s5, x4_y * c5 - c1 * s5, x4_z * c5
    z5_y, z5_z, z5_x = c1 * c5 + x4_y * s5, x4_z * s5, x4_x * s5 - s1 * c5
    T[0, 0], T[0, 1], T[0, 2] = x5_x, z4_x, z5_x
    T[0, 3] = c1 * a1 + x2_x * L2 + x3_x * L3 + s1 * d4 + z4_x * d5 + x5_x * ex + z5_x * ez
    T[1, 0], T[1, 1], T[1, 2] = x5_y, z4_y, z5_y
    T[1, 3] = s1 * a1 + x2_y * L2 + x3_y * L3 - c1 * d4 + z4_y * d5 + x5_y * ex + z5_y * ez
    T[2, 0], T[2, 1], T[2, 2] = x5_z, z4_z, z5_z
    T[2, 3] = d1 + s2 * L2 + x3_z * L3 + z4_z * d5 + x5_z * ex + z5_z * ez
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 5)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p2_x, p2_y = s1 * s2, p1_x + x2_x * L2, p1_y + x2_y * L2
    p2_z = d1 + s2 * L2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v3, v4, y3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * L3, p2_y + x3_y * L3, p2_z + x3_z * L3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - v3 * s4, x3_y * c4 - v4 * s4, x3_z * c4 + y3_z * s4
    z4_x, z4_y, p4_x = v3 * c4 + x3_x * s4, v4 * c4 + x3_y * s4, p3_x + s1 * d4
    p4_y, z4_z = p3_y - c1 * d4, x3_z * s4 - y3_z * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    J21 = p4_x + z4_x * d5 + (x4_x * c5 + s1 * s5) * ex + (x4_x * s5 - s1 * c5) * ez
    v5 = p4_y + z4_y * d5 + (x4_y * c5 - c1 * s5) * ex + (c1 * c5 + x4_y * s5) * ez
    v6 = p3_z + z4_z * d5 + x4_z * c5 * ex + x4_z * s5 * ez
    v7, v8, v9 = v6 - d1, v6 - p2_z, v6 - p3_z
    v10, v11 = J21 - p4_x, v5 - p4_y
    J[0, 0], J[0, 1], J[0, 2] = -v5, -(c1 * v7), -(c1 * v8)
    J[0, 3], J[0, 4] = -(c1 * v9), z4_y * v9 - z4_z * v11
    J[1, 0], J[1, 1], J[1, 2] = J21, -(s1 * v7), -(s1 * v8)
    J[1, 3], J[1, 4] = -(s1 * v9), z4_z * v10 - z4_x * v9
    J[2, 1], J[2, 2] = s1 * (v5 - p1_y) + c1 * (J21 - p1_x), s1 * (v5 - p2_y) + c1 * (J21 - p2_x)
    J[2, 3], J[2, 4] = s1 * (v5 - p3_y) + c1 * (J21 - p3_x), z4_x * v11 - z4_y * v10
    J[3, 1], J[3, 2], J[3, 3] = s1, s1, s1
    J[3, 4] = z4_x
    J[4, 1], J[4, 2], J[4, 3] = -c1, -c1, -c1
    J[4, 4] = z4_y
    J[5, 0], J[5, 4] = 1.0, z4_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, T13, T14, _, _, T23, T24, _, _, T33, T34 = pose

    # theta1, type 9: U1[3, 4] and U1[3, 3]
    v1, v2, v3 = ex * T23, ex * T13, ez * T23 - T24
    v4, v5, v6 = T14 - ez * T13, v1 * v1, v2 * v2
    v7, v8, v9 = v3 * v3, v4 * v4, v3 * k2
    v10, v11, v12 = v4 * k2, k1 * (v5 + v6) + (k3 + k1 * (v7 + v8)), k1 * (v5 - v6) + k1 * (v7 - v8)
    v13, v14 = v3 * v4 - v1 * v2, v11 - k4
    v15 = abs(v14) + abs(v9) + abs(v10) + abs(v12) + abs(v13)
    free1 = v15 <= free_limit2
    v16 = square_rounding * (v11 + k4)
    x1_roots, x1_close = _circle_roots(1.0 if free1 else v14, -1.0 if free1 else -v9, 0.0 if free1
        else -v10, 0.0 if free1 else v12, 0.0 if free1 else v13, v16, moved)
    v19 = math.cos(seed[0]) * math.cos(seed[0]) - math.sin(seed[0]) * math.sin(seed[0])
    v20, v21, v22 = 2.0 * (math.cos(seed[0]) * math.sin(seed[0])), 2.0 * v13, 2.0 * v12
    v24 = v15 * near_limit
    v25 = v19 * v21 + (v9 * math.sin(seed[0]) - v10 * math.cos(seed[0])) - v20 * v22
    v26 = (
        abs(v14 + (v13 * v20 + (v12 * v19 - (v9 * math.cos(seed[0]) + v10 * math.sin(seed[0]))))) <=
        v16 + v15 * double_root
    )

    # theta234, type 3: U1[2, 3] and U1[1, 3]
    v28 = seed[1] + seed[2] + seed[3]

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v30 = T34 - d1

    for i1 in range(4):  # root1, root2, root3, root4
        x1 = x1_roots[i1]
        # theta1
        if not (x1 <= 4.0):
            continue  # out of reach
        v17, v18 = math.cos(x1), math.sin(x1)
        v23 = (v17 * v17 - v18 * v18) * v21 + (v9 * v18 - v10 * v17) - 2.0 * (v17 * v18) * v22
        near1 = abs(v23) <= v24
        same1 = (
            -(double_root * (v15 * v15)) <= v23 * v25 and 0.0 < v17 * math.cos(seed[0]) + v18 *
            math.sin(seed[0]) and abs(v17 * math.sin(seed[0]) - v18 * math.cos(seed[0])) <=
            near_limit and near1 and v26
        )
        v27 = seed[0] if same1 else x1
        q1 = seed[0] if free1 else v27
        c1, s1 = math.cos(q1), math.sin(q1)

        # theta5, type 3: U1[3, 4] and U1[3, 3]
        Z2_5 = T13 * s1 - T23 * c1
        s5, c5 = (d4 - (T14 * s1 - T24 * c1) + ez * Z2_5) * k5, ex * Z2_5 * k5
        q5 = _atan2(s5, c5)

        # theta234
        S234 = s5 * T33
        C234 = s5 * (T13 * c1 + T23 * s1)
        w234 = math.sqrt(S234 * S234 + C234 * C234)
        free234 = w234 <= free_limit_squared
        near234 = w234 <= near_limit_squared
        factor234 = 1.0 / (1.0 if free234 else w234)
        c234 = math.cos(v28) if free234 else C234 * factor234
        s234 = math.sin(v28) if free234 else S234 * factor234
        theta234 = _atan2(s234, c234)

        # theta3
        v29 = ex * c5 + ez * s5
        Z1_3 = c234 * d5 - s234 * v29 + v30
        Z2_3 = T14 * c1 + T24 * s1 - a1 - (c234 * v29 + s234 * d5)
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
        K3 = N3 - k6
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            if near1:
                status[2 * i1] = _status.NEARLY + 1
                q[2 * i1, 0] = D3_squared
                q[2 * i1, 1] = v27
            if free1:
                status[2 * i1] = _status.LOST + 1
                q[2 * i1, 0] = D3_squared
            if free234:
                status[2 * i1] = _status.LOST + 2
                q[2 * i1, 0] = D3_squared
            if free234:
                status[2 * i1] = _status.LOST + 3
                q[2 * i1, 0] = D3_squared
            if free234:
                status[2 * i1] = _status.LOST + 4
                q[2 * i1, 0] = D3_squared
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        c3 = K3 * k7

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2 = L2 + L3 * c3
        v31, v32 = Z1_3 * X1_2, Z2_3 * X1_2

        for i2 in range(2):  # elbow+, elbow-
            e3 = 1.0 - 2.0 * i2
            # theta3
            if (
                e3 < 0.0 and (not apart3 or (near1 and not (shortest3_clear < N3 and N3 <
                longest3_clear)))
            ):
                continue  # both signs give the same
            s3 = w3 * e3 * k7
            q3 = _atan2(s3, c3)

            # theta2
            Y1_2 = L3 * s3
            S2 = v31 - Z2_3 * Y1_2
            C2 = v32 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            near2 = w2 <= near_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = _atan2(s2, c2)

            # joint values
            q4 = _wrap(theta234 - (q3 + q2))
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
            q[row, 3], q[row, 4] = q4, q5
            status[row] = (
                FREE_JOINT if free1 or free234 or free2 else _status.CLOSE if x1_close[i1] or near1
                or near234 or near2 else OK
            )


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "pointing", apart=(_circle.OWN.compile_apart, _runtime("complete").compile_apart,),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)

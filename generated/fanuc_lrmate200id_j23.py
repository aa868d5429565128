# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 1565c3ae04adb845
"""fanuc_lrmate200id_j23: Fanuc LR Mate 200iD, as its pendant counts.

Inverse kinematics, generated from robots/fanuc_lrmate200id_j23.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/fanuc_lrmate200id_j23.yaml. The formulas and where they come from:
fanuc_lrmate200id_j23.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Every entry of
a pose counts.
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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

NAME = "fanuc_lrmate200id_j23"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-2.9670597283903604, 2.9670597283903604), (-1.7453292519943295, 2.530727415391778),
    (-math.inf, math.inf), (-3.3161255787892263, 3.3161255787892263),
    (-2.181661564992912, 2.181661564992912), (-6.283185307179586, 6.283185307179586),
)
BRANCHES = (
    "back-up-noflip", "back-up-flip", "back-down-noflip", "back-down-flip", "front-down-noflip",
    "front-down-flip", "front-up-noflip", "front-up-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.33  # joint offset 1 [m]
a1 = 0.05  # link length 1 [m]
a2 = 0.33  # link length 2 [m]
a3 = 0.035  # link length 3 [m]
d4 = 0.335  # joint offset 4 [m]
d6 = 0.08  # z of the tool frame [m]
free_limit1 = 1.1600000000000001e-12  # a length that fixes no angle [m]
longest3 = 0.4446534412689106  # square of the longest reach [m^2]
shortest3 = 4.655873108936529e-05  # square of the shortest reach [m^2]
longest3_reach = 0.44465344126906536  # the longest, with what rounding adds [m^2]
shortest3_reach = 4.655873108778226e-05  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.4446534412688952  # the longest, where branches merge [m^2]
shortest3_apart = 4.655873108952359e-05  # the shortest, where branches merge [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.22110000000000002  # 2 * d4 * a2 [m^2]
k2 = 0.023100000000000002  # 2 * a3 * a2 [m^2]
k3 = 0.22235000000000002  # a2^2 + (a3^2 + d4^2) [m^2]
k4 = 20.235205939761407  # 1 / (k1^2 + k2^2) [m^-4]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

# The drives whose whole turns hang together, and sums of drives that have limits.
_coupled = _runtime("coupled")
_COUPLING = _coupled.coupling_numbers(
    _coupled.Coupling(
        drives=(1, 2),
        moves=((0.0, 6.283185307179586, 0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 6.283185307179586, 0.0, 0.0, 0.0)),
        limits=(
            (-2.9670597293903604, 2.9670597293903604),
            (-1.7453292529943296, 2.530727416391778),
            (-math.inf, math.inf),
            (-3.3161255797892264, 3.3161255797892264),
            (-2.181661565992912, 2.181661565992912),
            (-6.283185308179586, 6.283185308179586),
        ),
        factors=((0.0, 1.0, 1.0, 0.0, 0.0, 0.0),),
        sums=((-1.2217304773960307, 3.5779249675883755),),
        slacks=(1e-09,),
    )
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.8621, 0.8621, 0.8621, 1.0, 1.0, 1.0), size=1.1600000000000001,
    steps=("keeps limits", "clamps", "clamps far", "range exceeds a turn", "follows seed"),
    choosable=(3, 0),
), coupling=_COUPLING)

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.33, 0.05, -1.5707963267948966),
    (-1.5707963267948966, 0.0, 0.33, 3.141592653589793),
    (0.0, 0.0, 0.035, -1.5707963267948966),
    (0.0, -0.335, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    drives=(
        (1.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        (0.0, 1.0, 0.0, 0.0, 0.0, 0.0),
        (0.0, 1.0, 1.0, 0.0, 0.0, 0.0),
        (0.0, 0.0, 0.0, 1.0, 0.0, 0.0),
        (0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
        (0.0, 0.0, 0.0, 0.0, 0.0, 1.0),
    ),
    tool=(0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -0.08),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, y2_x = c1 * c2, s1 * c2, c1 * s2
    y2_y, v2 = s1 * s2, q[1] + q[2]
    c3, s3 = math.cos(v2), math.sin(v2)
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, c2 * s3 - s2 * c3
    z3_x, z3_y, z3_z = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, c2 * c3 + s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, x3_z * c4
    z4_x, z4_z, z4_y = s1 * c4 + x3_x * s4, x3_z * s4, x3_y * s4 - c1 * c4
    v3 = q[4] + offset5
    c5, s5 = math.cos(v3), math.sin(v3)
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 + z3_y * s5, x4_z * c5 + z3_z * s5
    T11_, T21_, T31_ = z3_x * c5 - x4_x * s5, z3_y * c5 - x4_y * s5, z3_z * c5 - x4_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = T11_, x5_x * s6 - z4_x * c6, -(x5_x * c6 + z4_x * s6)
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 - z3_x * d4 - -T11_ * d6
    T[1, 0], T[1, 1], T[1, 2] = T21_, x5_y * s6 - z4_y * c6, -(x5_y * c6 + z4_y * s6)
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 - z3_y * d4 - -T21_ * d6
    T[2, 0], T[2, 1], T[2, 2] = T31_, x5_z * s6 - z4_z * c6, -(x5_z * c6 + z4_z * s6)
    T[2, 3] = d1 - s2 * a2 + x3_z * a3 - z3_z * d4 - -T31_ * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y, v1 = c1 * a1, s1 * a1, q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, y2_x = c1 * c2, s1 * c2, c1 * s2
    y2_y, p2_x, p2_y = s1 * s2, p1_x + x2_x * a2, p1_y + x2_y * a2
    p2_z, v2 = d1 - s2 * a2, q[1] + q[2]
    c3, s3 = math.cos(v2), math.sin(v2)
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, c2 * s3 - s2 * c3
    z3_x, z3_y, z3_z = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, c2 * c3 + s2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3, p2_y + x3_y * a3, p2_z + x3_z * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    z4_x, z4_z, p4_x = s1 * c4 + x3_x * s4, x3_z * s4, p3_x - z3_x * d4
    p4_y, p4_z, z4_y = p3_y - z3_y * d4, p3_z - z3_z * d4, x3_y * s4 - c1 * c4
    v3 = q[4] + offset5
    c5, s5 = math.cos(v3), math.sin(v3)
    z5_x, z5_y = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5, (x3_y * c4 + c1 * s4) * s5 - z3_y * c5
    z5_z, J21, v4 = x3_z * c4 * s5 - z3_z * c5, p4_x - z5_x * d6, p4_y - z5_y * d6
    v5 = p4_z - z5_z * d6
    v6, v7 = v5 - d1, v5 - p2_z
    v8, v9, J33 = c1 * v7, s1 * v7, s1 * (v4 - p2_y) + c1 * (J21 - p2_x)
    v10, v11, v12 = J21 - p3_x, v4 - p3_y, v5 - p3_z
    v13, v14, v15 = J21 - p4_x, v4 - p4_y, v5 - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -v4, c1 * v6 - v8, -v8
    J[0, 3], J[0, 4] = z3_y * v12 - z3_z * v11, z4_y * v15 - z4_z * v14
    J[0, 5] = z5_y * v15 - z5_z * v14
    J[1, 0], J[1, 1], J[1, 2] = J21, s1 * v6 - v9, -v9
    J[1, 3], J[1, 4] = z3_z * v10 - z3_x * v12, z4_z * v13 - z4_x * v15
    J[1, 5] = z5_z * v13 - z5_x * v15
    J[2, 1], J[2, 2] = J33 - (s1 * (v4 - p1_y) + c1 * (J21 - p1_x)), J33
    J[2, 3], J[2, 4] = z3_x * v11 - z3_y * v10, z4_x * v14 - z4_y * v13
    J[2, 5] = z5_x * v14 - z5_y * v13
    J[3, 2], J[3, 3], J[3, 4] = s1, z3_x, z4_x
    J[3, 5] = z5_x
    J[4, 2], J[4, 3], J[4, 4] = -c1, z3_y, z4_y
    J[4, 5] = z5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, z3_z, z4_z
    J[5, 5] = z5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    t14 = T14 - d6 * T11
    Y1 = d6 * T21 - T24
    w1 = math.sqrt(t14 * t14 + Y1 * Y1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    t34 = T34 - d6 * T31
    Z1_3 = t34 - d1
    v2 = Z1_3 * Z1_3

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(t14 * factor1)
        s1 = math.sin(seed[0]) if free1 else Y1 * factor1
        q1 = _atan2(s1, c1)

        # theta3
        v1 = w1 * e1 + a1
        N3 = v2 + v1 * v1
        K3 = N3 - k3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        v3, v4 = k1 * K3, k2 * K3

        # theta4, type 2: U4[3, 3]
        v6 = T11 * c1 + T21 * s1
        Y4 = T11 * s1 - T21 * c1
        v7 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v8, v9, v11 = T22 * c1 - T12 * s1, T12 * c1 + T22 * s1, T23 * c1 - T13 * s1
        v12 = T13 * c1 + T23 * s1

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            D3 = w3 * e3
            s3, c3 = (v3 + k2 * D3) * k4, k4 * (v4 - k1 * D3)

            # theta2, type 3: U1[1, 4] and U1[2, 4]
            X1_2 = a3 * s3 - d4 * c3
            Y1_2 = a2 + (a3 * c3 + d4 * s3)
            v5 = v1 * X1_2 + Z1_3 * Y1_2
            C2 = Z1_3 * X1_2 - v1 * Y1_2
            w2 = math.sqrt(v5 * v5 + C2 * C2)
            factor2 = 1.0 / w2
            c2, s2 = C2 * factor2, -(v5 * factor2)

            # theta4
            c2m3 = c3 * c2 + s3 * s2
            s2m3 = c3 * s2 - s3 * c2
            X4 = c2m3 * v6 - T31 * s2m3
            w4 = math.sqrt(X4 * X4 + v7)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T31 * c2m3 + s2m3 * v6

            # theta6
            v10, v13 = T32 * s2m3 - c2m3 * v9, T33 * s2m3 - c2m3 * v12

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, c3) - q2)

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)
                s5 = w4 * e4

                # theta6
                c6, s6 = c4 * v8 + s4 * v10, c4 * v11 + s4 * v13
                q6 = _atan2(s6, c6)

                # joint values
                q5 = _wrap(_atan2(s5, c5) - offset5)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
                q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
                status[row] = FREE_JOINT if free1 or free4 else OK


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose"))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)

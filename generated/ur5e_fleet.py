"""ur5e_fleet: Universal Robots UR5e, calibrated.

Inverse kinematics, generated from robots/ur5e.yaml and templates/python/calibrated.py.jinja.
Do not edit: run dhgen robots/ur5e.yaml. The formulas and where they come from: ur5e.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Every entry of
a pose counts.
"""

import math
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

import numpy as np

# The runtime that lies beside this file, by whatever name this is imported, and no other one: it is
# in a package named after the folder. A dot in a name would be one between packages.
_BESIDE = str(Path(__file__).resolve().parent)
_FOLDER = _BESIDE.replace("%", "%25").replace(".", "%2E")
sys.modules.setdefault(_FOLDER, ModuleType(_FOLDER)).__path__ = [_BESIDE]


def _runtime(name):
    return import_module(f"{_FOLDER}.dhgen_runtime.{name}")


_HOW = _runtime("jit").of_file(__file__, interface=1)
_arms, _loops, _functions = _runtime("arm"), _runtime("general.arm"), _runtime("functions")
_calibrated, _calls = _runtime("calibrated"), _runtime("calls_calibrated")
_atan2 = _runtime("angles").atan2

NAME = "ur5e_fleet"
METHOD = "general 6R"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586),
)
BRANCHES = (
    "root1",
    "root2",
    "root3",
    "root4",
    "root5",
    "root6",
    "root7",
    "root8",
    "root9",
    "root10",
    "root11",
    "root12",
    "root13",
    "root14",
    "root15",
    "root16",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

# The table of the data sheet at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
NOMINAL = (
    (0.0, 0.1625, 0.0, 1.5707963267948966),
    (0.0, 0.0, -0.425, 0.0),
    (0.0, 0.0, -0.3922, 0.0),
    (0.0, 0.1333, 0.0, 1.5707963267948966),
    (0.0, 0.0997, 0.0, -1.5707963267948966),
    (0.0, 0.0996, 0.0, 0.0),
)

# In formulas below, near_arm_size1 = 1.3122999999999998 [m], near_a2 = -0.425 [m],
# near_a3 = -0.3922 [m], near_k3 = 3.4985918000001716e-15 [m^2],
# near_doubt_limit = 9.999999999999999e-05, near_longest3_clear = 0.6678158399785518 [m^2],
# near_k6 = 2.9996700362960076 [m^-2].
near_d6 = 0.0996  # joint offset 6 [m]
near_d4 = 0.1333  # joint offset 4 [m]
near_d1 = 0.1625  # joint offset 1 [m]
near_d5 = 0.0997  # joint offset 5 [m]
near_longest3 = 0.6678158399999998  # square of the longest reach [m^2]
near_shortest3 = 0.0010758399999999998  # square of the shortest reach [m^2]
near_k1 = 0.01776889  # near_d4^2 [m^2]
near_k4 = 0.762020879372095  # 1 / near_arm_size1 [m^-1]
near_k5 = 0.33444584  # near_a2^2 + near_a3^2 [m^2]
near_m1 = 3.4985918000001714e-12  # 1000 * near_k3 [m^2]
near_m2 = 9.999999999999999e-09  # near_doubt_limit^2
# 10 * (near_longest3 - near_longest3_clear) * (near_longest3_clear - near_shortest3) [m^4]
near_m4 = 1.4300283221564012e-10
near_m5 = 1.1764705882352942  # -near_a3 * near_k6 [m^-1]
near_m6 = 0.031534305882352925  # near_a3 * near_k5 * near_k6 - near_a2 [m]
near1 = 0.5  # 1 / 2
turn = 2.0 * math.pi  # [rad]
half_turn = 0.5 * turn

# What arms of this kind have in common.
_KIND = _calibrated.Kind(
    arm=_arms.Arm(
        types=JOINT_TYPES,
        limits=JOINT_LIMITS,
        slacks=(1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09),
        weights=(1.0, 1.0, 1.0, 1.0, 1.0, 1.0),
        paces=(1.0, 1.0, 1.0, 1.0, 1.0, 1.0),
        fan_steps=(),
        rows=16,
        directions='rotation',
        miss_weights=(0.762, 0.762, 0.762, 1.0, 1.0, 1.0),
        size=1.3122999999999998,
        clamped=1e-14,
        clamped_again=1e-10,
        steps=('clamps', 'winds'),
    ),
    table=NOMINAL,
    convention='standard',
    facing=(1.0, 1.0, 1.0, 1.0, 1.0, 1.0),
    reach=4.000000004,
    advances=(
        (0.6, 0.8),
        (0.38461538461538464, 0.9230769230769231),
        (0.47058823529411764, 0.8823529411764706),
        (0.28, 0.96),
        (0.6896551724137931, 0.7241379310344828),
        (0.32432432432432434, 0.9459459459459459),
    ),
    formulations=(
        _loops.Formulation(joints=(3, 4, 5, 0, 1, 2), sign=1.0),
        _loops.Formulation(joints=(1, 2, 3, 4, 5, 0), sign=1.0),
    ),
    parallel=(1,),
)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


# The closed form of the nominal arm. A pose at which one of its branches may end by what the two
# arms differ, an angle and a length that stand behind its entries, is left to the general algorithm.
@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T11, T12, T13, T14 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k], kept[3 * w + k]
        T21, T22, T23, T24 = kept[4 * w + k], kept[5 * w + k], kept[6 * w + k], kept[7 * w + k]
        T31, T32, T33, T34 = kept[8 * w + k], kept[9 * w + k], kept[10 * w + k], kept[11 * w + k]
        given1, given2 = kept[16 * w + k], kept[17 * w + k]

        # theta1, type 2: U1 A6^-1 [3, 4]
        X1 = near_d6 * T13 - T14
        wy = T24 - near_d6 * T23
        N1 = X1 * X1 + wy * wy
        D1 = N1 - near_k1
        w1 = math.sqrt(D1)
        v1 = near_k4 * w1
        v2 = abs(D1)
        inverse1 = 1.0 / N1
        v3 = near_d4 * wy
        v4 = inverse1 * v3
        v5 = X1 * inverse1
        v6 = inverse1 * -X1
        v7 = v4 + w1 * v5
        v8 = v4 + w1 * v6
        v9 = near_d4 * X1
        v10 = inverse1 * v9
        v11 = wy * inverse1
        v12 = inverse1 * -wy
        s1_p = w1 * v11 - v10
        s1_m = w1 * v12 - v10

        # theta6, type 2: U1 A6^-1 [3, 2]
        v13 = v7 * T21 + s1_p * T11
        v14 = v8 * T21 + s1_m * T11
        v15 = v7 * T22 + s1_p * T12
        v16 = v8 * T22 + s1_m * T12
        v17 = v13 * v13 + v15 * v15
        v18 = v14 * v14 + v16 * v16
        w6_p = math.sqrt(v17)
        w6_m = math.sqrt(v18)
        v19 = 1.0 / v17
        v20 = 1.0 / v18

        # theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1]
        c5_p = T13 * s1_p + T23 * v7
        c5_m = T13 * s1_m + T23 * v8

        # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
        v21 = v13 * T32 - v15 * T31
        v22 = v14 * T32 - v16 * T31
        v23 = v19 * v21
        v24 = v20 * v22
        c234_p = w6_p * v23
        c234_m = w6_m * v24
        v25 = v13 * T31 + v15 * T32
        v26 = v14 * T31 + v16 * T32
        v27 = c5_p * v25
        v28 = c5_m * v26
        v29 = v19 * v27 - T33
        v30 = v20 * v28 - T33
        s234_p = w6_p * v29
        s234_m = w6_m * v30

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        v31 = near_d6 * w6_p
        v32 = near_d6 * w6_m
        v33 = T34 - near_d1
        v34 = near_d5 * c234_p
        v35 = near_d5 * c234_m
        v36 = s234_p * v31
        v37 = s234_m * v32
        Z1_3_pp = v33 + (v34 + v36)
        Z1_3_pm = v33 + (v36 - v34)
        Z1_3_mp = v33 + (v35 + v37)
        Z1_3_mm = v33 + (v37 - v35)
        v38 = T24 * s1_p - T14 * v7
        v39 = T24 * s1_m - T14 * v8
        v40 = c234_p * v31
        v41 = c234_m * v32
        v42 = near_d5 * s234_p
        v43 = near_d5 * s234_m
        Z2_3_pp = v38 + (v40 - v42)
        Z2_3_pm = v38 + (v40 + v42)
        Z2_3_mp = v39 + (v41 - v43)
        Z2_3_mm = v39 + (v41 + v43)
        N3_pp = Z1_3_pp * Z1_3_pp + Z2_3_pp * Z2_3_pp
        N3_pm = Z1_3_pm * Z1_3_pm + Z2_3_pm * Z2_3_pm
        N3_mp = Z1_3_mp * Z1_3_mp + Z2_3_mp * Z2_3_mp
        N3_mm = Z1_3_mm * Z1_3_mm + Z2_3_mm * Z2_3_mm
        v44 = near_longest3 - N3_pp
        v45 = near_longest3 - N3_pm
        v46 = near_longest3 - N3_mp
        v47 = near_longest3 - N3_mm
        v48 = N3_pp - near_shortest3
        v49 = N3_pm - near_shortest3
        v50 = N3_mp - near_shortest3
        v51 = N3_mm - near_shortest3
        D3_pp = v44 * v48
        D3_pm = v45 * v49
        D3_mp = v46 * v50
        D3_mm = v47 * v51
        w3_pp = math.sqrt(D3_pp)
        w3_pm = math.sqrt(D3_pm)
        w3_mp = math.sqrt(D3_mp)
        w3_mm = math.sqrt(D3_mm)
        v52 = w3_pp - w3_pp
        v53 = w3_pm - w3_pm
        v54 = w3_mp - w3_mp
        v55 = w3_mm - w3_mm

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        v56 = near_m6 + near_m5 * N3_pp
        v57 = near_m6 + near_m5 * N3_pm
        v58 = near_m6 + near_m5 * N3_mp
        v59 = near_m6 + near_m5 * N3_mm
        v60 = Z1_3_pp * v56
        v61 = Z1_3_pm * v57
        v62 = Z1_3_mp * v58
        v63 = Z1_3_mm * v59
        v64 = Z2_3_pp * v56
        v65 = Z2_3_pm * v57
        v66 = Z2_3_mp * v58
        v67 = Z2_3_mm * v59
        v68 = w3_pp * (near_m5 * Z2_3_pp)
        v69 = w3_pp * (near_m5 * Z1_3_pp)
        v70 = w3_pm * (near_m5 * Z2_3_pm)
        v71 = w3_pm * (near_m5 * Z1_3_pm)
        v72 = w3_mp * (near_m5 * Z2_3_mp)
        v73 = w3_mp * (near_m5 * Z1_3_mp)
        v74 = w3_mm * (near_m5 * Z2_3_mm)
        v75 = w3_mm * (near_m5 * Z1_3_mm)

        # joint values
        v84 = abs(T13)
        v85 = given2 + near_d6 * given1
        v86 = abs(X1)
        v87 = abs(T23)
        v88 = abs(wy)
        v89 = v85 * (v85 + 2.0 * v86) + v85 * (v85 + 2.0 * v88)
        v90 = abs(N1)
        v91 = abs(inverse1)
        v92 = v89 * v91 / (v90 - v89)
        v93 = near_d4 * v85
        v94 = v91 * v93
        v95 = v94 + v92 * (v93 + abs(v3))
        v96 = v89 / D1
        v97 = v96 * (1.0 + v96) * (near1 * w1)
        v98 = v85 * v91
        v99 = v98 + v92 * (v85 + v86)
        v100 = abs(w1)
        v101 = v99 * v100
        v102 = v95 + (v101 + v97 * (v99 + abs(v5)))
        v103 = v95 + (v101 + v97 * (v99 + abs(v6)))
        v104 = abs(v7)
        v105 = abs(v8)
        v106 = given1 * v104
        v107 = given1 * v105
        v108 = given1 + abs(T21)
        v109 = v98 + v92 * (v85 + v88)
        v110 = v94 + v92 * (v93 + abs(v9))
        v111 = v100 * v109
        v112 = v110 + (v111 + v97 * (v109 + abs(v11)))
        v113 = v110 + (v111 + v97 * (v109 + abs(v12)))
        v114 = abs(s1_p)
        v115 = abs(s1_m)
        v116 = given1 * v114
        v117 = given1 * v115
        v118 = given1 + abs(T11)
        v119 = v106 + v102 * v108 + (v116 + v112 * v118)
        v120 = v107 + v103 * v108 + (v117 + v113 * v118)
        v121 = abs(v13)
        v122 = abs(v14)
        v123 = given1 + abs(T22)
        v124 = given1 + abs(T12)
        v125 = v106 + v102 * v123 + (v116 + v112 * v124)
        v126 = v107 + v103 * v123 + (v117 + v113 * v124)
        v127 = abs(v15)
        v128 = abs(v16)
        v129 = v119 * (v119 + 2.0 * v121) + v125 * (v125 + 2.0 * v127)
        v130 = v120 * (v120 + 2.0 * v122) + v126 * (v126 + 2.0 * v128)
        v131 = abs(v17)
        v132 = abs(v18)
        v133 = v119 + v125
        v134 = v120 + v126
        v135 = abs(v19)
        v136 = abs(v20)
        v137 = v129 * v135 / (v131 - v129)
        v138 = v130 * v136 / (v132 - v130)
        v139 = v112 + v114
        v140 = v113 + v115
        v141 = v102 + v104
        v142 = v103 + v105
        v143 = given1 * v121
        v144 = given1 * v122
        v145 = given1 + abs(T31)
        v146 = given1 * v127
        v147 = given1 * v128
        v148 = given1 + abs(T32)
        v149 = v143 + v119 * v145 + (v146 + v125 * v148)
        v150 = v144 + v120 * v145 + (v147 + v126 * v148)
        v151 = (
            v149 * abs(c5_p) + (v84 * v112 + given1 * v139 + (v87 * v102 + given1 * v141)) * (v149 +
            abs(v25))
        )
        v152 = (
            v150 * abs(c5_m) + (v84 * v113 + given1 * v140 + (v87 * v103 + given1 * v142)) * (v150 +
            abs(v26))
        )
        v153 = given1 + (v135 * v151 + v137 * (v151 + abs(v27)))
        v154 = given1 + (v136 * v152 + v138 * (v152 + abs(v28)))
        v155 = abs(w6_p)
        v156 = abs(w6_m)
        v157 = v153 * v155 + v133 * (v153 + abs(v29))
        v158 = v154 * v156 + v134 * (v154 + abs(v30))
        v159 = near_d6 * v133
        v160 = near_d6 * v134
        v161 = v159 + abs(v31)
        v162 = v160 + abs(v32)
        v163 = v143 + v119 * v148 + (v146 + v125 * v145)
        v164 = v144 + v120 * v148 + (v147 + v126 * v145)
        v165 = v135 * v163 + v137 * (v163 + abs(v21))
        v166 = v136 * v164 + v138 * (v164 + abs(v22))
        v167 = v155 * v165 + v133 * (v165 + abs(v23))
        v168 = v156 * v166 + v134 * (v166 + abs(v24))
        v169 = given2 + (v159 * abs(s234_p) + v157 * v161 + near_d5 * v167)
        v170 = given2 + (v160 * abs(s234_m) + v158 * v162 + near_d5 * v168)
        v171 = abs(T24)
        v172 = abs(T14)
        v173 = (
            v112 * v171 + given2 * v139 + (v102 * v172 + given2 * v141) + (v159 * abs(c234_p) + v161
            * v167 + near_d5 * v157)
        )
        v174 = (
            v113 * v171 + given2 * v140 + (v103 * v172 + given2 * v142) + (v160 * abs(c234_m) + v162
            * v168 + near_d5 * v158)
        )
        v175 = v169 * (v169 + 2.0 * abs(Z1_3_pp)) + v173 * (v173 + 2.0 * abs(Z2_3_pp))
        v176 = v169 * (v169 + 2.0 * abs(Z1_3_pm)) + v173 * (v173 + 2.0 * abs(Z2_3_pm))
        v177 = v170 * (v170 + 2.0 * abs(Z1_3_mp)) + v174 * (v174 + 2.0 * abs(Z2_3_mp))
        v178 = v170 * (v170 + 2.0 * abs(Z1_3_mm)) + v174 * (v174 + 2.0 * abs(Z2_3_mm))

        # a joint is free, or branches meet
        kept[18 * w + k] = (
            1.0 if v2 <= v89 or v2 <= near_m1 or abs(v47) <= v178 or abs(v1 * D3_mm) <= near_m4 or
            abs(v46) <= v177 or abs(v1 * D3_mp) <= near_m4 or abs(v45) <= v176 or abs(v1 * D3_pm) <=
            near_m4 or abs(v44) <= v175 or abs(v1 * D3_pp) <= near_m4 or v90 <= v89 or abs(v51) <=
            v178 or abs(v50) <= v177 or abs(v49) <= v176 or abs(v48) <= v175 or v132 <= v130 or v18
            <= near_m2 or v131 <= v129 or v100 <= v97 or v17 <= near_m2 else kept[18 * w + k]
        )
        kept[19 * w + k], kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v15, v16, v29, v30
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k], kept[26 * w + k] = v52, v53, v54, v55
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = s1_p, s1_m, -v15
        turns[3 * w + k], turns[4 * w + k], turns[5 * w + k] = -v16, w6_p, w6_m
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = v29, v30, w3_pp
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = w3_pm, w3_mp, w3_mm
        turns[12 * w + k], turns[13 * w + k], turns[14 * w + k] = v68 - v60, -(v60 + v68), v70 - v61
        turns[15 * w + k], turns[16 * w + k] = -(v61 + v70), v72 - v62
        turns[17 * w + k], turns[18 * w + k] = -(v62 + v72), v74 - v63
        turns[19 * w + k], turns[24 * w + k], turns[25 * w + k] = -(v63 + v74), -v7, -v8
        turns[26 * w + k], turns[27 * w + k], turns[28 * w + k] = v13, v14, c5_p
        turns[29 * w + k], turns[30 * w + k], turns[31 * w + k] = c5_m, v23, v24
        turns[32 * w + k], turns[33 * w + k] = N3_pp - near_k5, N3_pm - near_k5
        turns[34 * w + k], turns[35 * w + k] = N3_mp - near_k5, N3_mm - near_k5
        turns[36 * w + k], turns[37 * w + k] = -(v64 + v69), v69 - v64
        turns[38 * w + k], turns[39 * w + k] = -(v65 + v71), v71 - v65
        turns[40 * w + k], turns[41 * w + k] = -(v66 + v73), v73 - v66
        turns[42 * w + k], turns[43 * w + k] = -(v67 + v75), v75 - v67
    if w == 1 and kept[18] != 0.0:
        return
    end = 24 if w == 1 else 20 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(20 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        v15, v16, v29, v30 = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v52, v53, v54, v55 = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k], kept[26 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]
        angle7, angle8, angle9 = turns[6 * w + k], turns[7 * w + k], turns[8 * w + k]
        angle10, angle11, angle12 = turns[9 * w + k], turns[10 * w + k], turns[11 * w + k]
        angle13, angle14, angle15 = turns[12 * w + k], turns[13 * w + k], turns[14 * w + k]
        angle16, angle17, angle18 = turns[15 * w + k], turns[16 * w + k], turns[17 * w + k]
        angle19, angle20 = turns[18 * w + k], turns[19 * w + k]

        # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
        theta234_pm = angle7 - math.copysign(half_turn, v29)
        theta234_mm = angle8 - math.copysign(half_turn, v30)

        # joint values
        v76 = angle7 - (angle9 + angle13)
        v77 = angle7 - (angle14 - angle9)
        v78 = theta234_pm - (angle10 + angle15)
        v79 = theta234_pm - (angle16 - angle10)
        v80 = angle8 - (angle11 + angle17)
        v81 = angle8 - (angle18 - angle11)
        v82 = theta234_mm - (angle12 + angle19)
        v83 = theta234_mm - (angle20 - angle12)
        q4_ppp = v76 + (turn if v76 <= -half_turn else (-turn if half_turn < v76 else 0.0))
        q4_ppm = v77 + (turn if v77 <= -half_turn else (-turn if half_turn < v77 else 0.0))
        q4_pmp = v78 + (turn if v78 <= -half_turn else (-turn if half_turn < v78 else 0.0))
        q4_pmm = v79 + (turn if v79 <= -half_turn else (-turn if half_turn < v79 else 0.0))
        q4_mpp = v80 + (turn if v80 <= -half_turn else (-turn if half_turn < v80 else 0.0))
        q4_mpm = v81 + (turn if v81 <= -half_turn else (-turn if half_turn < v81 else 0.0))
        q4_mmp = v82 + (turn if v82 <= -half_turn else (-turn if half_turn < v82 else 0.0))
        q4_mmm = v83 + (turn if v83 <= -half_turn else (-turn if half_turn < v83 else 0.0))
        q1_ppp = angle1 + v52
        q1_pmp = angle1 + v53
        q1_mpp = angle2 + v54
        q1_mmp = angle2 + v55
        q5_ppp = angle5 + v52
        q5_pmp = v53 - angle5
        q5_mpp = angle6 + v54
        q5_mmp = v55 - angle6
        q6_ppp = angle3 + v52
        q6_pmp = v53 + (angle3 - math.copysign(half_turn, -v15))
        q6_mpp = angle4 + v54
        q6_mmp = v55 + (angle4 - math.copysign(half_turn, -v16))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, angle13, angle9
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_ppp, q5_ppp, q6_ppp
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = angle14, -angle9, q4_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q1_pmp, angle15, angle10
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q4_pmp, q5_pmp, q6_pmp
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = angle16, -angle10, q4_pmm
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q1_mpp, angle17, angle11
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q4_mpp, q5_mpp, q6_mpp
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = angle18, -angle11, q4_mpm
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q1_mmp, angle19, angle12
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = q4_mmp, q5_mmp, q6_mmp
        rows[33 * w + k], rows[34 * w + k], rows[35 * w + k] = angle20, -angle12, q4_mmm
        rows[36 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[37 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[38 * w + k] = UNREACHABLE if q1_pmp != q1_pmp else OK
        rows[39 * w + k] = UNREACHABLE if q1_pmp != q1_pmp else OK
        rows[40 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[41 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[42 * w + k] = UNREACHABLE if q1_mmp != q1_mmp else OK
        rows[43 * w + k] = UNREACHABLE if q1_mmp != q1_mmp else OK


# Where in rows the joint values of each row are.
_PLACES = np.array([
    [0, 1, 2, 3, 4, 5],
    [0, 6, 7, 8, 4, 5],
    [9, 10, 11, 12, 13, 14],
    [9, 15, 16, 17, 13, 14],
    [18, 19, 20, 21, 22, 23],
    [18, 24, 25, 26, 22, 23],
    [27, 28, 29, 30, 31, 32],
    [27, 33, 34, 35, 31, 32],
])


_CALLS = _calls.of_kind(
    globals(),
    _HOW,
    _calls.OwnKind(
        kind=_KIND,
        formulas=_functions.Formulas(_formulas, 27, 48, _PLACES),
        words={
            "no_pose": "not finite, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach",
            "unit": "m",
        },
    ),
)
calibrated, ik_into, warm_up = _CALLS["calibrated"], _CALLS["ik_into"], _CALLS["warm_up"]

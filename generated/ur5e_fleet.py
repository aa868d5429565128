# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 188073c3e2550859
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
    (-6.283185307179586, 6.283185307179586), (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586), (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586), (-6.283185307179586, 6.283185307179586),
)
BRANCHES = (
    "right-noflip-down", "right-noflip-up", "right-flip-down", "right-flip-up", "left-noflip-up",
    "left-noflip-down", "left-flip-up", "left-flip-down", "further1", "further2", "further3",
    "further4", "further5", "further6", "further7", "further8",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC


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
# near_k6 = 1 / (2 * near_a3 * near_a2) = 2.9996700362960076 [m^-2].
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
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

# What arms of this kind have in common.
_KIND = _calibrated.Kind(
    arm=_arms.Arm(
        types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
        miss_weights=(0.762, 0.762, 0.762, 1.0, 1.0, 1.0), size=1.3122999999999998,
        clamped_again=1e-10, steps=("clamps", "range exceeds a turn"),
    ),
    table=NOMINAL,
    convention="standard", facing=(1.0, 1.0, 1.0, 1.0, 1.0, 1.0), reach=4.000000004,
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


# The closed form of the nominal arm. A pose at which one of its branches may end by what the two
# arms differ, an angle and a length after its entries, is left to the general algorithm.
@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T11, T12, T13 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k]
        T14, T21, T22 = kept[3 * w + k], kept[4 * w + k], kept[5 * w + k]
        T23, T24, T31 = kept[6 * w + k], kept[7 * w + k], kept[8 * w + k]
        T32, T33, T34 = kept[9 * w + k], kept[10 * w + k], kept[11 * w + k]
        given1, given2 = kept[16 * w + k], kept[17 * w + k]

        # theta1, type 2: U1 A6^-1 [3, 4]
        X1, wy = near_d6 * T13 - T14, T24 - near_d6 * T23
        N1 = X1 * X1 + wy * wy
        D1_squared = N1 - near_k1
        w1 = math.sqrt(D1_squared)
        v1, inverse1, v2 = near_k4 * w1, 1.0 / N1, near_d4 * wy
        v3, v4, v5 = inverse1 * v2, X1 * inverse1, inverse1 * -X1
        v6, v7, v8 = v3 + w1 * v4, v3 + w1 * v5, near_d4 * X1
        v9, v10, v11 = inverse1 * v8, wy * inverse1, inverse1 * -wy
        s1_p, s1_m = w1 * v10 - v9, w1 * v11 - v9

        # theta6, type 2: U1 A6^-1 [3, 2]
        v12, v13, v14 = v6 * T21 + s1_p * T11, v7 * T21 + s1_m * T11, v6 * T22 + s1_p * T12
        v15, v16 = v7 * T22 + s1_m * T12, v12 * v12 + v14 * v14
        v17, w6_p = v13 * v13 + v15 * v15, math.sqrt(v16)
        w6_m, v18, v19 = math.sqrt(v17), 1.0 / v16, 1.0 / v17

        # theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1]
        c5_p, c5_m = T13 * s1_p + T23 * v6, T13 * s1_m + T23 * v7

        # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
        v20, v21 = v12 * T32 - v14 * T31, v13 * T32 - v15 * T31
        v22, v23 = v18 * v20, v19 * v21
        c234_p, c234_m, v24 = w6_p * v22, w6_m * v23, v12 * T31 + v14 * T32
        v25, v26 = v13 * T31 + v15 * T32, c5_p * v24
        v27, v28 = c5_m * v25, v18 * v26 - T33
        v29, s234_p = v19 * v27 - T33, w6_p * v28
        s234_m = w6_m * v29

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        v30, v31, v32 = near_d6 * w6_p, near_d6 * w6_m, T34 - near_d1
        v33, v34, v35 = near_d5 * c234_p, near_d5 * c234_m, s234_p * v30
        v36, Z1_3_pp, Z1_3_pm = s234_m * v31, v32 + (v33 + v35), v32 + (v35 - v33)
        Z1_3_mp, Z1_3_mm, v37 = v32 + (v34 + v36), v32 + (v36 - v34), T24 * s1_p - T14 * v6
        v38, v39, v40 = T24 * s1_m - T14 * v7, c234_p * v30, c234_m * v31
        v41, v42 = near_d5 * s234_p, near_d5 * s234_m
        Z2_3_pp, Z2_3_pm, Z2_3_mp = v37 + (v39 - v41), v37 + (v39 + v41), v38 + (v40 - v42)
        Z2_3_mm, N3_pp = v38 + (v40 + v42), Z1_3_pp * Z1_3_pp + Z2_3_pp * Z2_3_pp
        N3_pm, N3_mp = Z1_3_pm * Z1_3_pm + Z2_3_pm * Z2_3_pm, Z1_3_mp * Z1_3_mp + Z2_3_mp * Z2_3_mp
        N3_mm, v43 = Z1_3_mm * Z1_3_mm + Z2_3_mm * Z2_3_mm, near_longest3 - N3_pp
        v44, v45, v46 = near_longest3 - N3_pm, near_longest3 - N3_mp, near_longest3 - N3_mm
        v47, v48, v49 = N3_pp - near_shortest3, N3_pm - near_shortest3, N3_mp - near_shortest3
        v50, D3_squared_pp, D3_squared_pm = N3_mm - near_shortest3, v43 * v47, v44 * v48
        D3_squared_mp, D3_squared_mm, w3_pp = v45 * v49, v46 * v50, math.sqrt(D3_squared_pp)
        w3_pm, w3_mp = math.sqrt(D3_squared_pm), math.sqrt(D3_squared_mp)
        w3_mm, v51, v52 = math.sqrt(D3_squared_mm), w3_pp - w3_pp, w3_pm - w3_pm
        v53, v54 = w3_mp - w3_mp, w3_mm - w3_mm

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        v55, v56 = near_m6 + near_m5 * N3_pp, near_m6 + near_m5 * N3_pm
        v57, v58, v59 = near_m6 + near_m5 * N3_mp, near_m6 + near_m5 * N3_mm, Z1_3_pp * v55
        v60, v61, v62 = Z1_3_pm * v56, Z1_3_mp * v57, Z1_3_mm * v58
        v63, v64, v65 = Z2_3_pp * v55, Z2_3_pm * v56, Z2_3_mp * v57
        v66, v67, v68 = Z2_3_mm * v58, w3_pp * (near_m5 * Z2_3_pp), w3_pp * (near_m5 * Z1_3_pp)
        v69, v70 = w3_pm * (near_m5 * Z2_3_pm), w3_pm * (near_m5 * Z1_3_pm)
        v71, v72 = w3_mp * (near_m5 * Z2_3_mp), w3_mp * (near_m5 * Z1_3_mp)
        v73, v74 = w3_mm * (near_m5 * Z2_3_mm), w3_mm * (near_m5 * Z1_3_mm)

        # by how much these differ at poses so near: slopes and rests
        v83, v84, v85 = T33 * given1, T23 * given1, near1 * (given1 * given1)
        v86, v87, v88 = near_d6 * v83, near_d6 * v84, near_d6 * v85
        v89 = v83 * v83
        v90, v91, v92 = v85 + math.sqrt(v89 + v84 * v84), X1 * v86, X1 * v87
        v93, v94 = X1 * given2, abs(X1)
        v95, v96, v97 = v88 * v94, v86 * v86, abs(given2)
        v98, v99, v100 = v88 + (v97 + math.sqrt(v96 + v87 * v87)), v91 + v91, v93 + v93
        v101, v102 = v98 * v98, T13 * given1
        v103, v104, v105 = near_d6 * v102, v85 + math.sqrt(v89 + v102 * v102), wy * v86
        v106, v107, v108 = wy * v103, wy * given2, abs(wy)
        v109, v110, v111 = v88 * v108, v88 + (v97 + math.sqrt(v96 + v103 * v103)), v105 + v105
        v112, v113, v114 = v107 + v107, v110 * v110, v92 + v92 + (v106 + v106)
        v115 = v101 + (v95 + v95) + (v113 + (v109 + v109))
        v116 = (
            v115 + (math.sqrt(v111 * v111 + v99 * v99 + v114 * v114) + math.sqrt(v100 * v100 + v112
            * v112))
        )
        v117, v118, v119 = abs(inverse1), inverse1 * (inverse1 * v111), inverse1 * (inverse1 * v99)
        v120, v121 = inverse1 * (inverse1 * v114), inverse1 * (inverse1 * v100)
        v122, v123, v124 = inverse1 * (inverse1 * v112), v117 * (v115 * v117), v101 + v113
        v125 = math.sqrt(N1) - math.sqrt(v124)
        v126 = (
            v123 + (v123 + (abs(v122) + (abs(v121) + (abs(v120) + (abs(v118) + abs(v119)))))) *
            (v116 / (v125 * v125))
        )
        v127, v128, v129 = near_d4 * v86, near_d4 * v103, near_d4 * given2
        v130, v131, v132 = near_d4 * v88, inverse1 * v127, inverse1 * v129
        v133, v134, v135 = v117 * v130, v2 * v119, v2 * v121
        v136 = (
            v126 + (math.sqrt(v118 * v118 + v119 * v119 + v120 * v120) + math.sqrt(v121 * v121 +
            v122 * v122))
        )
        v137, v138, v139 = v127 * v127, abs(v129), v131 - v2 * v118
        v140, v141 = v2 * v120 - inverse1 * v128, v132 - v2 * v122
        v142 = v133 + v126 * abs(v2) + v136 * (v130 + (v138 + math.sqrt(v137 + v128 * v128)))
        v143 = near1 / w1
        v144, v145, v146 = v111 * v143, v99 * v143, v114 * v143
        v147, v148, v149 = v100 * v143, v112 * v143, v116 * v143
        v150 = v149 * v149 / w1
        v151, v152, v153 = v150 + (v150 + v115 * abs(v143)), inverse1 * v86, inverse1 * given2
        v154, v155, v156 = v88 * v117, X1 * v118, -X1 * v118
        v157, v158, v159 = X1 * v122, -X1 * v122, v152 - X1 * v119
        v160, v161 = v152 + -X1 * v119, inverse1 * v87
        v162, v163, v164 = X1 * v120 - v161, v161 + -X1 * v120, X1 * v121 - v153
        v165, v166, v167 = v153 + -X1 * v121, v154 + v94 * v126 + v98 * v136, abs(w1)
        v168 = (
            v151 + (math.sqrt(v144 * v144 + v145 * v145 + v146 * v146) + math.sqrt(v147 * v147 +
            v148 * v148))
        )
        v169, v170 = v139 + (v4 * v144 - w1 * v155), v139 + (v5 * v144 - w1 * v156)
        v171, v172 = w1 * v159 + v4 * v145 - v134, v5 * v145 - w1 * v160 - v134
        v173, v174 = v140 + (w1 * v162 - v4 * v146), v140 + (w1 * v163 - v5 * v146)
        v175, v176 = v135 + (w1 * v164 - v4 * v147), v135 + (w1 * v165 - v5 * v147)
        v177, v178 = v141 + (v4 * v148 - w1 * v157), v141 + (v5 * v148 - w1 * v158)
        v179 = v166 * v167
        v180 = (
            v142 + (v179 + v151 * abs(v4) + v168 * (v166 + (math.sqrt(v155 * v155 + v159 * v159 +
            v162 * v162) + math.sqrt(v164 * v164 + v157 * v157))))
        )
        v181 = (
            v142 + (v179 + v151 * abs(v5) + v168 * (v166 + (math.sqrt(v156 * v156 + v160 * v160 +
            v163 * v163) + math.sqrt(v165 * v165 + v158 * v158))))
        )
        v182, v183, v184 = T11 * given1, T31 * given1, v85 * abs(v6)
        v185, v186 = v85 * abs(v7), abs(T21)
        v187 = (
            v180 + (math.sqrt(v169 * v169 + v171 * v171 + v173 * v173) + math.sqrt(v175 * v175 +
            v177 * v177))
        )
        v188 = (
            v181 + (math.sqrt(v170 * v170 + v172 * v172 + v174 * v174) + math.sqrt(v176 * v176 +
            v178 * v178))
        )
        v189, v190 = v183 * v183, v182 * v182
        v191, v192, v193 = v85 + math.sqrt(v189 + v190), wy * v119, -wy * v119
        v194, v195, v196 = wy * v121, -wy * v121, v152 - wy * v118
        v197, v198 = v152 + -wy * v118, inverse1 * v103
        v199, v200, v201 = wy * v120 - v198, v198 + -wy * v120, v153 - wy * v122
        v202, v203, v204 = v153 + -wy * v122, v154 + v108 * v126 + v110 * v136, near_d4 * v87
        v205, v206 = v8 * v118, v8 * v122
        v207 = v133 + v126 * abs(v8) + v136 * (v130 + (v138 + math.sqrt(v137 + v204 * v204)))
        v208, v209 = v205 + (w1 * v196 + v10 * v144), v205 + (v11 * v144 - w1 * v197)
        v210 = v8 * v119 - v131
        v211, v212 = v210 + (v10 * v145 - w1 * v192), v210 + (v11 * v145 - w1 * v193)
        v213 = inverse1 * v204 - v8 * v120
        v214, v215 = v213 + (w1 * v199 - v10 * v146), v213 + (w1 * v200 - v11 * v146)
        v216 = v132 - v8 * v121
        v217, v218 = v216 + (w1 * v194 - v10 * v147), v216 + (w1 * v195 - v11 * v147)
        v219, v220 = v206 + (w1 * v201 + v10 * v148), v206 + (v11 * v148 - w1 * v202)
        v221 = v167 * v203
        v222 = (
            v207 + (v221 + v151 * abs(v10) + v168 * (v203 + (math.sqrt(v196 * v196 + v192 * v192 +
            v199 * v199) + math.sqrt(v194 * v194 + v201 * v201))))
        )
        v223 = (
            v207 + (v221 + v151 * abs(v11) + v168 * (v203 + (math.sqrt(v197 * v197 + v193 * v193 +
            v200 * v200) + math.sqrt(v195 * v195 + v202 * v202))))
        )
        v224, v225, v226 = T21 * given1, v85 * abs(s1_p), v85 * abs(s1_m)
        v227 = abs(T11)
        v228 = (
            v222 + (math.sqrt(v208 * v208 + v211 * v211 + v214 * v214) + math.sqrt(v217 * v217 +
            v219 * v219))
        )
        v229 = (
            v223 + (math.sqrt(v209 * v209 + v212 * v212 + v215 * v215) + math.sqrt(v218 * v218 +
            v220 * v220))
        )
        v230 = v224 * v224
        v231, v232 = v85 + math.sqrt(v189 + v230), T21 * v169 - v6 * v183 + T11 * v208
        v233, v234 = T21 * v170 - v7 * v183 + T11 * v209, T21 * v171 + (s1_p * v183 + T11 * v211)
        v235 = T21 * v172 + (s1_m * v183 + T11 * v212)
        v236 = v6 * v182 + T21 * v173 + (T11 * v214 - s1_p * v224)
        v237, v238 = v7 * v182 + T21 * v174 + (T11 * v215 - s1_m * v224), T21 * v175 + T11 * v217
        v239, v240, v241 = T21 * v176 + T11 * v218, T21 * v177 + T11 * v219, T21 * v178 + T11 * v220
        v242 = v184 + v180 * v186 + v187 * v191 + (v225 + v222 * v227 + v228 * v231)
        v243 = v185 + v181 * v186 + v188 * v191 + (v226 + v223 * v227 + v229 * v231)
        v244, v245, v246 = v12 * v232, v13 * v233, v12 * v234
        v247, v248, v249 = v13 * v235, v12 * v236, v13 * v237
        v250, v251, v252 = v12 * v238, v13 * v239, v12 * v240
        v253, v254, v255 = v13 * v241, abs(v12), abs(v13)
        v256, v257 = v242 * v254, v243 * v255
        v258 = (
            v242 + (math.sqrt(v232 * v232 + v234 * v234 + v236 * v236) + math.sqrt(v238 * v238 +
            v240 * v240))
        )
        v259 = (
            v243 + (math.sqrt(v233 * v233 + v235 * v235 + v237 * v237) + math.sqrt(v239 * v239 +
            v241 * v241))
        )
        v260, v261, v262 = v258 * v258, v259 * v259, T12 * given1
        v263, v264 = T32 * given1, abs(T22)
        v265, v266 = v263 * v263, v262 * v262
        v267, v268, v269 = v85 + math.sqrt(v265 + v266), T22 * given1, abs(T12)
        v270 = v268 * v268
        v271, v272 = v85 + math.sqrt(v265 + v270), T22 * v169 - v6 * v263 + T12 * v208
        v273, v274 = T22 * v170 - v7 * v263 + T12 * v209, T22 * v171 + (s1_p * v263 + T12 * v211)
        v275 = T22 * v172 + (s1_m * v263 + T12 * v212)
        v276 = v6 * v262 + T22 * v173 + (T12 * v214 - s1_p * v268)
        v277, v278 = v7 * v262 + T22 * v174 + (T12 * v215 - s1_m * v268), T22 * v175 + T12 * v217
        v279, v280, v281 = T22 * v176 + T12 * v218, T22 * v177 + T12 * v219, T22 * v178 + T12 * v220
        v282 = v184 + v180 * v264 + v187 * v267 + (v225 + v222 * v269 + v228 * v271)
        v283 = v185 + v181 * v264 + v188 * v267 + (v226 + v223 * v269 + v229 * v271)
        v284, v285, v286 = v14 * v272, v15 * v273, v14 * v274
        v287, v288, v289 = v15 * v275, v14 * v276, v15 * v277
        v290, v291, v292 = v14 * v278, v15 * v279, v14 * v280
        v293, v294, v295 = v15 * v281, abs(v14), abs(v15)
        v296, v297 = v282 * v294, v283 * v295
        v298 = (
            v282 + (math.sqrt(v272 * v272 + v274 * v274 + v276 * v276) + math.sqrt(v278 * v278 +
            v280 * v280))
        )
        v299 = (
            v283 + (math.sqrt(v273 * v273 + v275 * v275 + v277 * v277) + math.sqrt(v279 * v279 +
            v281 * v281))
        )
        v300, v301, v302 = v298 * v298, v299 * v299, v244 + v244 + (v284 + v284)
        v303, v304 = v245 + v245 + (v285 + v285), v246 + v246 + (v286 + v286)
        v305, v306 = v247 + v247 + (v287 + v287), v248 + v248 + (v288 + v288)
        v307, v308 = v249 + v249 + (v289 + v289), v250 + v250 + (v290 + v290)
        v309, v310 = v251 + v251 + (v291 + v291), v252 + v252 + (v292 + v292)
        v311, v312 = v253 + v253 + (v293 + v293), v260 + (v256 + v256) + (v300 + (v296 + v296))
        v313, v314, v315 = v261 + (v257 + v257) + (v301 + (v297 + v297)), near1 / w6_p, near1 / w6_m
        v316, v317, v318 = v302 * v314, v303 * v315, v304 * v314
        v319, v320, v321 = v305 * v315, v306 * v314, v307 * v315
        v322, v323, v324 = v308 * v314, v309 * v315, v310 * v314
        v325, v326, v327 = v311 * v315, v312 * abs(v314), v313 * abs(v315)
        v328, v329, v330 = abs(v18), abs(v19), v18 * (v18 * v302)
        v331, v332, v333 = v19 * (v19 * v303), v18 * (v18 * v304), v19 * (v19 * v305)
        v334, v335, v336 = v18 * (v18 * v306), v19 * (v19 * v307), v18 * (v18 * v308)
        v337, v338, v339 = v19 * (v19 * v309), v18 * (v18 * v310), v19 * (v19 * v311)
        v340, v341, v342 = v328 * (v312 * v328), v329 * (v313 * v329), v260 + v300
        v343, v344 = v261 + v301, w6_p - math.sqrt(v342)
        v345 = w6_m - math.sqrt(v343)
        v346 = (
            v340 + (v340 + (abs(v338) + (abs(v336) + (abs(v334) + (abs(v330) + abs(v332)))))) *
            ((v312 + (math.sqrt(v302 * v302 + v304 * v304 + v306 * v306) + math.sqrt(v308 * v308 +
            v310 * v310))) / (v344 * v344))
        )
        v347 = (
            v341 + (v341 + (abs(v339) + (abs(v337) + (abs(v335) + (abs(v331) + abs(v333)))))) *
            ((v313 + (math.sqrt(v303 * v303 + v305 * v305 + v307 * v307) + math.sqrt(v309 * v309 +
            v311 * v311))) / (v345 * v345))
        )
        v348, v349, v350 = abs(T13), abs(T23), T13 * v208 + (T23 * v169 - v6 * v83)
        v351, v352 = T13 * v209 + (T23 * v170 - v7 * v83), T13 * v211 + s1_p * v83 + T23 * v171
        v353 = T13 * v212 + s1_m * v83 + T23 * v172
        v354 = T13 * v214 - s1_p * v84 + (T23 * v173 + v6 * v102)
        v355, v356 = T13 * v215 - s1_m * v84 + (T23 * v174 + v7 * v102), T13 * v217 + T23 * v175
        v357, v358, v359 = T13 * v218 + T23 * v176, T13 * v219 + T23 * v177, T13 * v220 + T23 * v178
        v360 = v225 + v222 * v348 + v90 * v228 + (v184 + v180 * v349 + v104 * v187)
        v361 = v226 + v223 * v348 + v90 * v229 + (v185 + v181 * v349 + v104 * v188)
        v362, v363, v364 = v85 * v254, v85 * v255, abs(T31)
        v365, v366, v367 = v85 + math.sqrt(v190 + v230), v85 * v294, v85 * v295
        v368, v369 = abs(T32), v85 + math.sqrt(v266 + v270)
        v370 = v12 * v224 + T31 * v232 + (v14 * v268 + T32 * v272)
        v371 = v13 * v224 + T31 * v233 + (v15 * v268 + T32 * v273)
        v372 = T31 * v234 - v12 * v182 + (T32 * v274 - v14 * v262)
        v373, v374 = T31 * v235 - v13 * v182 + (T32 * v275 - v15 * v262), T31 * v236 + T32 * v276
        v375, v376, v377 = T31 * v237 + T32 * v277, T31 * v238 + T32 * v278, T31 * v239 + T32 * v279
        v378, v379 = T31 * v240 + T32 * v280, T31 * v241 + T32 * v281
        v380 = v362 + v242 * v364 + v258 * v365 + (v366 + v282 * v368 + v298 * v369)
        v381 = v363 + v243 * v364 + v259 * v365 + (v367 + v283 * v368 + v299 * v369)
        v382, v383 = c5_p * v370 + v24 * v350, c5_m * v371 + v25 * v351
        v384, v385 = c5_p * v372 + v24 * v352, c5_m * v373 + v25 * v353
        v386, v387 = c5_p * v374 + v24 * v354, c5_m * v375 + v25 * v355
        v388, v389 = c5_p * v376 + v24 * v356, c5_m * v377 + v25 * v357
        v390, v391 = c5_p * v378 + v24 * v358, c5_m * v379 + v25 * v359
        v392 = (
            v380 * abs(c5_p) + v360 * abs(v24) + (v360 + (math.sqrt(v350 * v350 + v352 * v352 + v354
            * v354) + math.sqrt(v356 * v356 + v358 * v358))) * (v380 + (math.sqrt(v370 * v370 + v372
            * v372 + v374 * v374) + math.sqrt(v376 * v376 + v378 * v378)))
        )
        v393 = (
            v381 * abs(c5_m) + v361 * abs(v25) + (v361 + (math.sqrt(v351 * v351 + v353 * v353 + v355
            * v355) + math.sqrt(v357 * v357 + v359 * v359))) * (v381 + (math.sqrt(v371 * v371 + v373
            * v373 + v375 * v375) + math.sqrt(v377 * v377 + v379 * v379)))
        )
        v394 = (
            v346 + (math.sqrt(v330 * v330 + v332 * v332 + v334 * v334) + math.sqrt(v336 * v336 +
            v338 * v338))
        )
        v395 = (
            v347 + (math.sqrt(v331 * v331 + v333 * v333 + v335 * v335) + math.sqrt(v337 * v337 +
            v339 * v339))
        )
        v396, v397, v398 = v18 * v386 - v26 * v334, v19 * v387 - v27 * v335, v18 * v388 - v26 * v336
        v399, v400, v401 = v19 * v389 - v27 * v337, v18 * v390 - v26 * v338, v19 * v391 - v27 * v339
        v402, v403 = v18 * v382 - v26 * v330 - v84, v19 * v383 - v27 * v331 - v84
        v404, v405 = v102 + (v18 * v384 - v26 * v332), v102 + (v19 * v385 - v27 * v333)
        v406 = (
            v85 + (v328 * v392 + v346 * abs(v26) + v394 * (v392 + (math.sqrt(v382 * v382 + v384 *
            v384 + v386 * v386) + math.sqrt(v388 * v388 + v390 * v390))))
        )
        v407 = (
            v85 + (v329 * v393 + v347 * abs(v27) + v395 * (v393 + (math.sqrt(v383 * v383 + v385 *
            v385 + v387 * v387) + math.sqrt(v389 * v389 + v391 * v391))))
        )
        v408, v409 = abs(w6_p), abs(w6_m)
        v410 = (
            v326 + (math.sqrt(v316 * v316 + v318 * v318 + v320 * v320) + math.sqrt(v322 * v322 +
            v324 * v324))
        )
        v411 = (
            v327 + (math.sqrt(v317 * v317 + v319 * v319 + v321 * v321) + math.sqrt(v323 * v323 +
            v325 * v325))
        )
        v412, v413 = w6_p * v402 + v28 * v316, w6_m * v403 + v29 * v317
        v414, v415 = w6_p * v404 + v28 * v318, w6_m * v405 + v29 * v319
        v416, v417 = w6_p * v396 + v28 * v320, w6_m * v397 + v29 * v321
        v418, v419 = w6_p * v398 + v28 * v322, w6_m * v399 + v29 * v323
        v420, v421 = w6_p * v400 + v28 * v324, w6_m * v401 + v29 * v325
        v422 = (
            v406 * v408 + v326 * abs(v28) + v410 * (v406 + (math.sqrt(v402 * v402 + v404 * v404 +
            v396 * v396) + math.sqrt(v398 * v398 + v400 * v400)))
        )
        v423 = (
            v407 * v409 + v327 * abs(v29) + v411 * (v407 + (math.sqrt(v403 * v403 + v405 * v405 +
            v397 * v397) + math.sqrt(v399 * v399 + v401 * v401)))
        )
        v424, v425, v426 = near_d6 * v316, near_d6 * v317, near_d6 * v318
        v427, v428, v429 = near_d6 * v319, near_d6 * v320, near_d6 * v321
        v430, v431, v432 = near_d6 * v322, near_d6 * v323, near_d6 * v324
        v433, v434, v435 = near_d6 * v325, near_d6 * v326, near_d6 * v327
        v436, v437 = abs(v30), abs(v31)
        v438 = (
            v434 + (math.sqrt(v424 * v424 + v426 * v426 + v428 * v428) + math.sqrt(v430 * v430 +
            v432 * v432))
        )
        v439 = (
            v435 + (math.sqrt(v425 * v425 + v427 * v427 + v429 * v429) + math.sqrt(v431 * v431 +
            v433 * v433))
        )
        v440, v441 = s234_p * v424 + v30 * v412, s234_m * v425 + v31 * v413
        v442, v443 = s234_p * v426 + v30 * v414, s234_m * v427 + v31 * v415
        v444, v445 = s234_p * v428 + v30 * v416, s234_m * v429 + v31 * v417
        v446, v447 = s234_p * v430 + v30 * v418, s234_m * v431 + v31 * v419
        v448, v449 = s234_p * v432 + v30 * v420, s234_m * v433 + v31 * v421
        v450 = v12 * v268 + T32 * v232 - (v14 * v224 + T31 * v272)
        v451 = v13 * v268 + T32 * v233 - (v15 * v224 + T31 * v273)
        v452 = T32 * v234 - v12 * v262 + (v14 * v182 - T31 * v274)
        v453, v454 = T32 * v235 - v13 * v262 + (v15 * v182 - T31 * v275), T32 * v236 - T31 * v276
        v455, v456, v457 = T32 * v237 - T31 * v277, T32 * v238 - T31 * v278, T32 * v239 - T31 * v279
        v458, v459 = T32 * v240 - T31 * v280, T32 * v241 - T31 * v281
        v460 = v362 + v242 * v368 + v258 * v369 + (v366 + v282 * v364 + v298 * v365)
        v461 = v363 + v243 * v368 + v259 * v369 + (v367 + v283 * v364 + v299 * v365)
        v462, v463, v464 = v18 * v450 - v20 * v330, v19 * v451 - v21 * v331, v18 * v452 - v20 * v332
        v465, v466, v467 = v19 * v453 - v21 * v333, v18 * v454 - v20 * v334, v19 * v455 - v21 * v335
        v468, v469, v470 = v18 * v456 - v20 * v336, v19 * v457 - v21 * v337, v18 * v458 - v20 * v338
        v471 = v19 * v459 - v21 * v339
        v472 = (
            v328 * v460 + v346 * abs(v20) + v394 * (v460 + (math.sqrt(v450 * v450 + v452 * v452 +
            v454 * v454) + math.sqrt(v456 * v456 + v458 * v458)))
        )
        v473 = (
            v329 * v461 + v347 * abs(v21) + v395 * (v461 + (math.sqrt(v451 * v451 + v453 * v453 +
            v455 * v455) + math.sqrt(v457 * v457 + v459 * v459)))
        )
        v474, v475 = w6_p * v462 + v22 * v316, w6_m * v463 + v23 * v317
        v476, v477 = w6_p * v464 + v22 * v318, w6_m * v465 + v23 * v319
        v478, v479 = w6_p * v466 + v22 * v320, w6_m * v467 + v23 * v321
        v480, v481 = w6_p * v468 + v22 * v322, w6_m * v469 + v23 * v323
        v482, v483 = w6_p * v470 + v22 * v324, w6_m * v471 + v23 * v325
        v484 = (
            v408 * v472 + v326 * abs(v22) + v410 * (v472 + (math.sqrt(v462 * v462 + v464 * v464 +
            v466 * v466) + math.sqrt(v468 * v468 + v470 * v470)))
        )
        v485 = (
            v409 * v473 + v327 * abs(v23) + v411 * (v473 + (math.sqrt(v463 * v463 + v465 * v465 +
            v467 * v467) + math.sqrt(v469 * v469 + v471 * v471)))
        )
        v486, v487, v488 = near_d5 * v474, near_d5 * v475, near_d5 * v476
        v489, v490, v491 = near_d5 * v477, near_d5 * v478, near_d5 * v479
        v492, v493, v494 = near_d5 * v480, near_d5 * v481, near_d5 * v482
        v495, v496, v497 = near_d5 * v483, v440 + v486, v440 - v486
        v498, v499, v500 = v441 + v487, v441 - v487, v442 + v488
        v501, v502, v503 = v442 - v488, v443 + v489, v443 - v489
        v504, v505, v506 = v444 + v490, v444 - v490, v445 + v491
        v507, v508, v509 = v445 - v491, v446 + v492, v446 - v492
        v510, v511, v512 = v447 + v493, v447 - v493, v448 + v494
        v513, v514, v515 = v448 - v494, v449 + v495, v449 - v495
        v516 = (
            v434 * abs(s234_p) + v422 * v436 + v438 * (v422 + (math.sqrt(v412 * v412 + v414 * v414 +
            v416 * v416) + math.sqrt(v418 * v418 + v420 * v420))) + near_d5 * v484
        )
        v517 = (
            v435 * abs(s234_m) + v423 * v437 + v439 * (v423 + (math.sqrt(v413 * v413 + v415 * v415 +
            v417 * v417) + math.sqrt(v419 * v419 + v421 * v421))) + near_d5 * v485
        )
        v518, v519, v520 = Z1_3_pp * v496, Z1_3_pm * v497, Z1_3_mp * v498
        v521, v522, v523 = Z1_3_mm * v499, Z1_3_pp * v500, Z1_3_pm * v501
        v524, v525, v526 = Z1_3_mp * v502, Z1_3_mm * v503, Z1_3_pp * v504
        v527, v528, v529 = Z1_3_pm * v505, Z1_3_mp * v506, Z1_3_mm * v507
        v530, v531, v532 = Z1_3_pp * v508, Z1_3_pm * v509, Z1_3_mp * v510
        v533, v534, v535 = Z1_3_mm * v511, Z1_3_pp * v512, Z1_3_pm * v513
        v536, v537, v538 = Z1_3_mp * v514, Z1_3_mm * v515, Z1_3_pp * given2
        v539, v540, v541 = Z1_3_pm * given2, Z1_3_mp * given2, Z1_3_mm * given2
        v542, v543, v544 = v516 * abs(Z1_3_pp), v516 * abs(Z1_3_pm), v517 * abs(Z1_3_mp)
        v545, v546 = v517 * abs(Z1_3_mm), given2 * given2
        v547 = (
            v516 + (math.sqrt(v496 * v496 + v500 * v500 + v504 * v504) + math.sqrt(v546 + (v508 *
            v508 + v512 * v512)))
        )
        v548 = (
            v516 + (math.sqrt(v497 * v497 + v501 * v501 + v505 * v505) + math.sqrt(v546 + (v509 *
            v509 + v513 * v513)))
        )
        v549 = (
            v517 + (math.sqrt(v498 * v498 + v502 * v502 + v506 * v506) + math.sqrt(v546 + (v510 *
            v510 + v514 * v514)))
        )
        v550 = (
            v517 + (math.sqrt(v499 * v499 + v503 * v503 + v507 * v507) + math.sqrt(v546 + (v511 *
            v511 + v515 * v515)))
        )
        v551, v552, v553 = v538 + v538, v539 + v539, v540 + v540
        v554, v555, v556 = v541 + v541, abs(T24), abs(T14)
        v557, v558, v559 = T24 * v208 - T14 * v169, T24 * v209 - T14 * v170, T24 * v211 - T14 * v171
        v560, v561, v562 = T24 * v212 - T14 * v172, T24 * v214 - T14 * v173, T24 * v215 - T14 * v174
        v563 = T24 * v217 - (T14 * v175 + v6 * given2)
        v564 = T24 * v218 - (T14 * v176 + v7 * given2)
        v565 = T24 * v219 + s1_p * given2 - T14 * v177
        v566, v567 = T24 * v220 + s1_m * given2 - T14 * v178, c234_p * v424 + v30 * v474
        v568, v569 = c234_m * v425 + v31 * v475, c234_p * v426 + v30 * v476
        v570, v571 = c234_m * v427 + v31 * v477, c234_p * v428 + v30 * v478
        v572, v573 = c234_m * v429 + v31 * v479, c234_p * v430 + v30 * v480
        v574, v575 = c234_m * v431 + v31 * v481, c234_p * v432 + v30 * v482
        v576, v577, v578 = c234_m * v433 + v31 * v483, near_d5 * v412, near_d5 * v413
        v579, v580, v581 = near_d5 * v414, near_d5 * v415, near_d5 * v416
        v582, v583, v584 = near_d5 * v417, near_d5 * v418, near_d5 * v419
        v585, v586, v587 = near_d5 * v420, near_d5 * v421, v557 + (v567 - v577)
        v588, v589, v590 = v557 + (v567 + v577), v558 + (v568 - v578), v558 + (v568 + v578)
        v591, v592, v593 = v559 + (v569 - v579), v559 + (v569 + v579), v560 + (v570 - v580)
        v594, v595, v596 = v560 + (v570 + v580), v561 + (v571 - v581), v561 + (v571 + v581)
        v597, v598, v599 = v562 + (v572 - v582), v562 + (v572 + v582), v563 + (v573 - v583)
        v600, v601, v602 = v563 + (v573 + v583), v564 + (v574 - v584), v564 + (v574 + v584)
        v603, v604, v605 = v565 + (v575 - v585), v565 + (v575 + v585), v566 + (v576 - v586)
        v606 = v566 + (v576 + v586)
        v607 = (
            v222 * v555 + v97 * v228 + (v180 * v556 + v97 * v187) + (v434 * abs(c234_p) + v436 *
            v484 + v438 * (v484 + (math.sqrt(v474 * v474 + v476 * v476 + v478 * v478) +
            math.sqrt(v480 * v480 + v482 * v482))) + near_d5 * v422)
        )
        v608 = (
            v223 * v555 + v97 * v229 + (v181 * v556 + v97 * v188) + (v435 * abs(c234_m) + v437 *
            v485 + v439 * (v485 + (math.sqrt(v475 * v475 + v477 * v477 + v479 * v479) +
            math.sqrt(v481 * v481 + v483 * v483))) + near_d5 * v423)
        )
        v609, v610, v611 = Z2_3_pp * v587, Z2_3_pm * v588, Z2_3_mp * v589
        v612, v613, v614 = Z2_3_mm * v590, Z2_3_pp * v591, Z2_3_pm * v592
        v615, v616, v617 = Z2_3_mp * v593, Z2_3_mm * v594, Z2_3_pp * v595
        v618, v619, v620 = Z2_3_pm * v596, Z2_3_mp * v597, Z2_3_mm * v598
        v621, v622, v623 = Z2_3_pp * v599, Z2_3_pm * v600, Z2_3_mp * v601
        v624, v625, v626 = Z2_3_mm * v602, Z2_3_pp * v603, Z2_3_pm * v604
        v627, v628, v629 = Z2_3_mp * v605, Z2_3_mm * v606, v607 * abs(Z2_3_pp)
        v630, v631, v632 = v607 * abs(Z2_3_pm), v608 * abs(Z2_3_mp), v608 * abs(Z2_3_mm)
        v633 = (
            v607 + (math.sqrt(v587 * v587 + v591 * v591 + v595 * v595) + math.sqrt(v599 * v599 +
            v603 * v603))
        )
        v634 = (
            v607 + (math.sqrt(v588 * v588 + v592 * v592 + v596 * v596) + math.sqrt(v600 * v600 +
            v604 * v604))
        )
        v635 = (
            v608 + (math.sqrt(v589 * v589 + v593 * v593 + v597 * v597) + math.sqrt(v601 * v601 +
            v605 * v605))
        )
        v636 = (
            v608 + (math.sqrt(v590 * v590 + v594 * v594 + v598 * v598) + math.sqrt(v602 * v602 +
            v606 * v606))
        )
        v637, v638 = v518 + v518 + (v609 + v609), v519 + v519 + (v610 + v610)
        v639, v640 = v520 + v520 + (v611 + v611), v521 + v521 + (v612 + v612)
        v641, v642 = v522 + v522 + (v613 + v613), v523 + v523 + (v614 + v614)
        v643, v644 = v524 + v524 + (v615 + v615), v525 + v525 + (v616 + v616)
        v645, v646 = v526 + v526 + (v617 + v617), v527 + v527 + (v618 + v618)
        v647, v648 = v528 + v528 + (v619 + v619), v529 + v529 + (v620 + v620)
        v649, v650 = v530 + v530 + (v621 + v621), v531 + v531 + (v622 + v622)
        v651, v652 = v532 + v532 + (v623 + v623), v533 + v533 + (v624 + v624)
        v653, v654 = v534 + v534 + (v625 + v625), v535 + v535 + (v626 + v626)
        v655, v656 = v536 + v536 + (v627 + v627), v537 + v537 + (v628 + v628)
        v657 = v542 + v542 + v547 * v547 + (v629 + v629 + v633 * v633)
        v658 = v543 + v543 + v548 * v548 + (v630 + v630 + v634 * v634)
        v659 = v544 + v544 + v549 * v549 + (v631 + v631 + v635 * v635)
        v660 = v545 + v545 + v550 * v550 + (v632 + v632 + v636 * v636)
        v661 = (
            v657 + (math.sqrt(v637 * v637 + v641 * v641 + v645 * v645) + math.sqrt(v649 * v649 +
            v653 * v653 + v551 * v551))
        )
        v662 = (
            v658 + (math.sqrt(v638 * v638 + v642 * v642 + v646 * v646) + math.sqrt(v650 * v650 +
            v654 * v654 + v552 * v552))
        )
        v663 = (
            v659 + (math.sqrt(v639 * v639 + v643 * v643 + v647 * v647) + math.sqrt(v651 * v651 +
            v655 * v655 + v553 * v553))
        )
        v664 = (
            v660 + (math.sqrt(v640 * v640 + v644 * v644 + v648 * v648) + math.sqrt(v652 * v652 +
            v656 * v656 + v554 * v554))
        )
        v665, v666, v667 = v43 * v637 - v47 * v637, v44 * v638 - v48 * v638, v45 * v639 - v49 * v639
        v668, v669, v670 = v46 * v640 - v50 * v640, v43 * v641 - v47 * v641, v44 * v642 - v48 * v642
        v671, v672, v673 = v45 * v643 - v49 * v643, v46 * v644 - v50 * v644, v43 * v645 - v47 * v645
        v674, v675, v676 = v44 * v646 - v48 * v646, v45 * v647 - v49 * v647, v46 * v648 - v50 * v648
        v677, v678, v679 = v43 * v649 - v47 * v649, v44 * v650 - v48 * v650, v45 * v651 - v49 * v651
        v680, v681, v682 = v46 * v652 - v50 * v652, v43 * v653 - v47 * v653, v44 * v654 - v48 * v654
        v683, v684, v685 = v45 * v655 - v49 * v655, v46 * v656 - v50 * v656, v43 * v551 - v47 * v551
        v686, v687, v688 = v44 * v552 - v48 * v552, v45 * v553 - v49 * v553, v46 * v554 - v50 * v554
        v689 = (
            v657 * abs(v43) + v657 * abs(v47) + v661 * v661 + (math.sqrt(v665 * v665 + v669 * v669 +
            v673 * v673) + math.sqrt(v677 * v677 + v681 * v681 + v685 * v685))
        )
        v690 = (
            v658 * abs(v44) + v658 * abs(v48) + v662 * v662 + (math.sqrt(v666 * v666 + v670 * v670 +
            v674 * v674) + math.sqrt(v678 * v678 + v682 * v682 + v686 * v686))
        )
        v691 = (
            v659 * abs(v45) + v659 * abs(v49) + v663 * v663 + (math.sqrt(v667 * v667 + v671 * v671 +
            v675 * v675) + math.sqrt(v679 * v679 + v683 * v683 + v687 * v687))
        )
        v692 = (
            v660 * abs(v46) + v660 * abs(v50) + v664 * v664 + (math.sqrt(v668 * v668 + v672 * v672 +
            v676 * v676) + math.sqrt(v680 * v680 + v684 * v684 + v688 * v688))
        )

        # a joint is free, or branches meet
        kept[18 * w + k] = (
            1.0 if abs(v116 + (D1_squared + D1_squared)) <= v116 or abs(D1_squared) <= near_m1 or
            abs(v692 + (D3_squared_mm + D3_squared_mm)) <= v692 or abs(v1 * D3_squared_mm) <=
            near_m4 or abs(v691 + (D3_squared_mp + D3_squared_mp)) <= v691 or abs(v1 *
            D3_squared_mp) <= near_m4 or abs(v690 + (D3_squared_pm + D3_squared_pm)) <= v690 or
            abs(v1 * D3_squared_pm) <= near_m4 or abs(v689 + (D3_squared_pp + D3_squared_pp)) <=
            v689 or abs(v1 * D3_squared_pp) <= near_m4 or abs(v17) <= v343 or v17 <= near_m2 or
            abs(v16) <= v342 or abs(N1) <= v124 or v16 <= near_m2 else kept[18 * w + k]
        )
        kept[19 * w + k], kept[20 * w + k], kept[21 * w + k] = v14, v15, v28
        kept[22 * w + k], kept[23 * w + k], kept[24 * w + k] = v29, v51, v52
        kept[25 * w + k], kept[26 * w + k], turns[0 * w + k] = v53, v54, s1_p
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = s1_m, -v14, -v15
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = w6_p, w6_m, v28
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = v29, w3_pp, w3_pm
        turns[10 * w + k], turns[11 * w + k], turns[12 * w + k] = w3_mp, w3_mm, v67 - v59
        turns[13 * w + k], turns[14 * w + k] = -(v59 + v67), v69 - v60
        turns[15 * w + k], turns[16 * w + k] = -(v60 + v69), v71 - v61
        turns[17 * w + k], turns[18 * w + k] = -(v61 + v71), v73 - v62
        turns[19 * w + k], turns[24 * w + k], turns[25 * w + k] = -(v62 + v73), -v6, -v7
        turns[26 * w + k], turns[27 * w + k], turns[28 * w + k] = v12, v13, c5_p
        turns[29 * w + k], turns[30 * w + k], turns[31 * w + k] = c5_m, v22, v23
        turns[32 * w + k], turns[33 * w + k] = N3_pp - near_k5, N3_pm - near_k5
        turns[34 * w + k], turns[35 * w + k] = N3_mp - near_k5, N3_mm - near_k5
        turns[36 * w + k], turns[37 * w + k] = -(v63 + v68), v68 - v63
        turns[38 * w + k], turns[39 * w + k] = -(v64 + v70), v70 - v64
        turns[40 * w + k], turns[41 * w + k] = -(v65 + v72), v72 - v65
        turns[42 * w + k], turns[43 * w + k] = -(v66 + v74), v74 - v66
    if w == 1 and kept[18] != 0.0:
        return
    end = 24 if w == 1 else 20 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(20 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        v14, v15, v28 = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k]
        v29, v51, v52 = kept[22 * w + k], kept[23 * w + k], kept[24 * w + k]
        v53, v54, angle1 = kept[25 * w + k], kept[26 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9, angle10 = turns[7 * w + k], turns[8 * w + k], turns[9 * w + k]
        angle11, angle12, angle13 = turns[10 * w + k], turns[11 * w + k], turns[12 * w + k]
        angle14, angle15, angle16 = turns[13 * w + k], turns[14 * w + k], turns[15 * w + k]
        angle17, angle18, angle19 = turns[16 * w + k], turns[17 * w + k], turns[18 * w + k]
        angle20 = turns[19 * w + k]

        # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
        theta234_pm = angle7 - math.copysign(half_turn, v28)
        theta234_mm = angle8 - math.copysign(half_turn, v29)

        # joint values
        v75, v76 = angle7 - (angle9 + angle13), angle7 - (angle14 - angle9)
        v77, v78 = theta234_pm - (angle10 + angle15), theta234_pm - (angle16 - angle10)
        v79, v80 = angle8 - (angle11 + angle17), angle8 - (angle18 - angle11)
        v81, v82 = theta234_mm - (angle12 + angle19), theta234_mm - (angle20 - angle12)
        q4_ppp = v75 + (turn if v75 <= -half_turn else (-turn if half_turn < v75 else 0.0))
        q4_ppm = v76 + (turn if v76 <= -half_turn else (-turn if half_turn < v76 else 0.0))
        q4_pmp = v77 + (turn if v77 <= -half_turn else (-turn if half_turn < v77 else 0.0))
        q4_pmm = v78 + (turn if v78 <= -half_turn else (-turn if half_turn < v78 else 0.0))
        q4_mpp = v79 + (turn if v79 <= -half_turn else (-turn if half_turn < v79 else 0.0))
        q4_mpm = v80 + (turn if v80 <= -half_turn else (-turn if half_turn < v80 else 0.0))
        q4_mmp = v81 + (turn if v81 <= -half_turn else (-turn if half_turn < v81 else 0.0))
        q4_mmm = v82 + (turn if v82 <= -half_turn else (-turn if half_turn < v82 else 0.0))
        q1_ppp, q1_pmp, q1_mpp = angle1 + v51, angle1 + v52, angle2 + v53
        q1_mmp, q5_ppp, q5_pmp = angle2 + v54, angle5 + v51, v52 - angle5
        q5_mpp, q5_mmp, q6_ppp = angle6 + v53, v54 - angle6, angle3 + v51
        q6_pmp, q6_mpp = v52 + (angle3 - math.copysign(half_turn, -v14)), angle4 + v53
        q6_mmp = v54 + (angle4 - math.copysign(half_turn, -v15))

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
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if q1_pmp != q1_pmp else OK
        rows[40 * w + k] = rows[41 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[42 * w + k] = rows[43 * w + k] = UNREACHABLE if q1_mmp != q1_mmp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 27, 48, [
    [0, 1, 2, 3, 4, 5], [0, 6, 7, 8, 4, 5], [9, 10, 11, 12, 13, 14], [9, 15, 16, 17, 13, 14],
    [18, 19, 20, 21, 22, 23], [18, 24, 25, 26, 22, 23], [27, 28, 29, 30, 31, 32],
    [27, 33, 34, 35, 31, 32],
])


_CALLS = _calls.of_kind(
    globals(),
    _HOW,
    _calls.OwnKind(
        kind=_KIND,
        formulas=_FORMULAS,
        unit="m",
    ),
)
calibrated, calibrated_by_origins = _CALLS["calibrated"], _CALLS["calibrated_by_origins"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
Unreachable = _CALLS["Unreachable"]

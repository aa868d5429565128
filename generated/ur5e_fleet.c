/* ur5e_fleet: Universal Robots UR5e, calibrated
 *
 * Inverse kinematics, generated from robots/ur5e.yaml and templates/c/calibrated.c.jinja.
 * Do not edit: run dhgen robots/ur5e.yaml. The formulas and where they come from: ur5e.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 188073c3e2550859
 * SPDX-License-Identifier: MIT
 */
#include "ur5e_fleet.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(UR5E_FLEET_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(UR5E_FLEET_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the arm needs of it */
#ifdef UR5E_FLEET_LANES
#define DHGEN_GENERAL_LANES UR5E_FLEET_LANES
#endif
#include "dhgen/serial.h"
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"
#include "dhgen/calibrated.h"
#ifndef UR5E_FLEET_PLAIN
#include "dhgen/tile.h"
#endif

#ifdef __CUDA_ARCH__
__device__ static
#endif
const double ur5e_fleet_nominal[6][4] = {
    { 0.0, 0.1625, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, -0.425, 0.0 },
    { 0.0, 0.0, -0.3922, 0.0 },
    { 0.0, 0.1333, 0.0, 1.5707963267948966 },
    { 0.0, 0.0997, 0.0, -1.5707963267948966 },
    { 0.0, 0.0996, 0.0, 0.0 },
};

#ifndef __CUDACC_RTC__
const char *const ur5e_fleet_branches[16] = {
#ifdef UR5E_FLEET_PLAIN
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
#else
    "right-noflip-down", "right-noflip-up", "right-flip-down", "right-flip-up", "left-noflip-up",
    "left-noflip-down", "left-flip-up", "left-flip-down", "further1", "further2", "further3",
    "further4", "further5", "further6", "further7", "further8",
#endif
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[2] = {
    { { 3, 4, 5, 0, 1, 2 }, 1.0, 0 },
    { { 1, 2, 3, 4, 5, 0 }, 1.0, 0 },
};

/* Without its links, which come with a table. */
DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    1.0, 1.0,
    4.000000004, /* the square of what is out of reach for all links in line */
    0, 2, formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
    0, 0, 0, 0, 0, 0, 0,
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[6] = { 0, 1, 2, 3, 4, 5 };
DHGEN_TABLE int turning[6] = { 1, 1, 1, 1, 1, 1 };
DHGEN_TABLE double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[6] = {
    0.762020879372095, 0.762020879372095, 0.762020879372095, 0.762020879372095, 0.762020879372095,
    0.762020879372095,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[6] = {
    -6.283185307179586, -6.283185307179586, -6.283185307179586, -6.283185307179586,
    -6.283185307179586, -6.283185307179586,
};
DHGEN_TABLE double span_width[6] = {
    12.566370614359172, 12.566370614359172, 12.566370614359172, 12.566370614359172,
    12.566370614359172, 12.566370614359172,
};
DHGEN_TABLE double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
DHGEN_TABLE double least_u[6] = {
    -6.283185307179586, -6.283185307179586, -6.283185307179586, -6.283185307179586,
    -6.283185307179586, -6.283185307179586,
};
DHGEN_TABLE double most_u[6] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};
/* How the loop counts the joints: which way, and from where. */
DHGEN_TABLE double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.3122999999999998, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero, 0, 0,
    0, 0, 0, 0,
};


#ifndef UR5E_FLEET_PLAIN
/* The closed form of the nominal arm. A pose at which one of its branches may end by what the two
 * arms differ, an angle and a length that the caller gives, is left to the general algorithm. */
/* In formulas below, near_arm_size1 = 1.3122999999999998 [m], near_a2 = -0.425 [m],
 * near_a3 = -0.3922 [m], near_k3 = 3.4985918000001716e-15 [m^2],
 * near_doubt_limit = 9.999999999999999e-05, near_longest3_clear = 0.6678158399785518 [m^2],
 * near_k6 = 1 / (2 * near_a3 * near_a2) = 2.9996700362960076 [m^-2]. */
static const double
    near_d6 = 0.0996, /* joint offset 6 [m] */
    near_d4 = 0.1333, /* joint offset 4 [m] */
    near_d1 = 0.1625, /* joint offset 1 [m] */
    near_d5 = 0.0997, /* joint offset 5 [m] */
    near_longest3 = 0.6678158399999998, /* square of the longest reach [m^2] */
    near_shortest3 = 0.0010758399999999998, /* square of the shortest reach [m^2] */
    near_k1 = 0.01776889, /* near_d4^2 [m^2] */
    near_k4 = 0.762020879372095, /* 1 / near_arm_size1 [m^-1] */
    near_k5 = 0.33444584, /* near_a2^2 + near_a3^2 [m^2] */
    near_m1 = 3.4985918000001714e-12, /* 1000 * near_k3 [m^2] */
    near_m2 = 9.999999999999999e-09, /* near_doubt_limit^2 */
    near_m3 = 0.5, /* 1 / 2 */
    /* 10 * (near_longest3 - near_longest3_clear) * (near_longest3_clear - near_shortest3) [m^4] */
    near_m4 = 1.4300283221564012e-10,
    near_m5 = 1.1764705882352942, /* -near_a3 * near_k6 [m^-1] */
    near_m6 = 0.031534305882352925, /* near_a3 * near_k5 * near_k6 - near_a2 [m] */
    near1 = 0.5; /* 1 / 2 */

/* What one pose and many compute alike: values without signs of branches, with the first, with
 * all that are in lanes. */
#define KNOWN(number) \
    /* theta1 */ \
    const dhgen_##number X1 = near_d6 * T13 - T14, wy = T24 - near_d6 * T23, \
        N1 = X1 * X1 + wy * wy, D1_squared = N1 - near_k1, w1 = dhgen_sqrt_##number(D1_squared), \
        v1 = near_k4 * w1, inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = near_d4 * wy, \
        v3 = inverse1 * v2, v7 = near_d4 * X1, v8 = inverse1 * v7; \
    /* theta3 */ \
    const dhgen_##number v24 = T34 - near_d1; \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v40 = T33 * free_joints[0], v41 = T23 * free_joints[0], \
        v42 = near1 * (free_joints[0] * free_joints[0]), v43 = near_d6 * v40, v44 = near_d6 * v41, \
        v45 = near_d6 * v42, v46 = v40 * v40, v47 = v42 + dhgen_sqrt_##number(v46 + v41 * v41), \
        v48 = X1 * v43, v49 = X1 * v44, v50 = X1 * free_joints[1], v51 = dhgen_abs_##number(X1), \
        v52 = v45 * v51, v53 = v43 * v43, v54 = dhgen_abs_##number(free_joints[1]), \
        v55 = v45 + (v54 + dhgen_sqrt_##number(v53 + v44 * v44)), v56 = v48 + v48, \
        v57 = v50 + v50, v58 = v55 * v55, v59 = T13 * free_joints[0], v60 = near_d6 * v59, \
        v61 = v42 + dhgen_sqrt_##number(v46 + v59 * v59), v62 = wy * v43, v63 = wy * v60, \
        v64 = wy * free_joints[1], v65 = dhgen_abs_##number(wy), v66 = v45 * v65, \
        v67 = v45 + (v54 + dhgen_sqrt_##number(v53 + v60 * v60)), v68 = v62 + v62, \
        v69 = v64 + v64, v70 = v67 * v67, v71 = v49 + v49 + (v63 + v63), \
        v72 = v58 + (v52 + v52) + (v70 + (v66 + v66)), \
        v73 = v72 + (dhgen_sqrt_##number(v68 * v68 + v56 * v56 + v71 * v71) + \
            dhgen_sqrt_##number(v57 * v57 + v69 * v69)), v74 = dhgen_abs_##number(inverse1), \
        v75 = inverse1 * (inverse1 * v68), v76 = inverse1 * (inverse1 * v56), \
        v77 = inverse1 * (inverse1 * v71), v78 = inverse1 * (inverse1 * v57), \
        v79 = inverse1 * (inverse1 * v69), v80 = v74 * (v72 * v74), v81 = v58 + v70, \
        v82 = dhgen_sqrt_##number(N1) - dhgen_sqrt_##number(v81), \
        v83 = v80 + (v80 + (dhgen_abs_##number(v79) + (dhgen_abs_##number(v78) + \
            (dhgen_abs_##number(v77) + (dhgen_abs_##number(v75) + dhgen_abs_##number(v76)))))) * \
            DHGEN_QUOTIENT(v73, v82 * v82), v84 = near_d4 * v43, v85 = near_d4 * v60, \
        v86 = near_d4 * free_joints[1], v87 = near_d4 * v45, v88 = inverse1 * v84, \
        v89 = inverse1 * v86, v90 = v74 * v87, v91 = v2 * v76, v92 = v2 * v78, \
        v93 = v83 + (dhgen_sqrt_##number(v75 * v75 + v76 * v76 + v77 * v77) + \
            dhgen_sqrt_##number(v78 * v78 + v79 * v79)), v94 = v84 * v84, \
        v95 = dhgen_abs_##number(v86), v96 = v88 - v2 * v75, v97 = v2 * v77 - inverse1 * v85, \
        v98 = v89 - v2 * v79, \
        v99 = v90 + v83 * dhgen_abs_##number(v2) + v93 * (v87 + (v95 + dhgen_sqrt_##number(v94 + \
            v85 * v85))), v100 = DHGEN_QUOTIENT(near1, w1), v101 = v68 * v100, v102 = v56 * v100, \
        v103 = v71 * v100, v104 = v57 * v100, v105 = v69 * v100, v106 = v73 * v100, \
        v107 = DHGEN_QUOTIENT(v106 * v106, w1), \
        v108 = v107 + (v107 + v72 * dhgen_abs_##number(v100)), v113 = v45 * v74, \
        v120 = v113 + v51 * v83, v122 = dhgen_abs_##number(w1), \
        v123 = v108 + (dhgen_sqrt_##number(v101 * v101 + v102 * v102 + v103 * v103) + \
            dhgen_sqrt_##number(v104 * v104 + v105 * v105)), v130 = T11 * free_joints[0], \
        v131 = T31 * free_joints[0], v133 = dhgen_abs_##number(T21), v135 = v131 * v131, \
        v136 = v130 * v130, v137 = v42 + dhgen_sqrt_##number(v135 + v136), \
        v144 = v113 + v65 * v83, v146 = near_d4 * v44, v147 = v7 * v75, v148 = v7 * v79, \
        v149 = v90 + v83 * dhgen_abs_##number(v7) + v93 * (v87 + (v95 + dhgen_sqrt_##number(v94 + \
            v146 * v146))), v151 = v7 * v76 - v88, v153 = inverse1 * v146 - v7 * v77, \
        v155 = v89 - v7 * v78, v159 = T21 * free_joints[0], v161 = dhgen_abs_##number(T11), \
        v163 = v159 * v159, v164 = v42 + dhgen_sqrt_##number(v135 + v163), \
        v180 = T12 * free_joints[0], v181 = T32 * free_joints[0], v182 = dhgen_abs_##number(T22), \
        v183 = v181 * v181, v184 = v180 * v180, v185 = v42 + dhgen_sqrt_##number(v183 + v184), \
        v186 = T22 * free_joints[0], v187 = dhgen_abs_##number(T12), v188 = v186 * v186, \
        v189 = v42 + dhgen_sqrt_##number(v183 + v188), v228 = dhgen_abs_##number(T13), \
        v229 = dhgen_abs_##number(T23), v237 = dhgen_abs_##number(T31), \
        v238 = v42 + dhgen_sqrt_##number(v136 + v163), v240 = dhgen_abs_##number(T32), \
        v241 = v42 + dhgen_sqrt_##number(v184 + v188), v318 = free_joints[1] * free_joints[1], \
        v321 = dhgen_abs_##number(T24), v322 = dhgen_abs_##number(T14)
#define SIGNED(number, signs) \
    /* theta1 */ \
    const dhgen_##number v4 = e1 * X1, v5 = inverse1 * v4, v6 = v3 + w1 * v5, v9 = e1 * wy, \
        v10 = inverse1 * v9, s1 = w1 * v10 - v8; \
    /* theta6 */ \
    const dhgen_##number v11 = v6 * T21 + s1 * T11, v12 = v6 * T22 + s1 * T12, \
        v13 = v11 * v11 + v12 * v12, w6 = dhgen_sqrt_##number(v13), \
        v14 = DHGEN_QUOTIENT(1.0, v13), v15 = dhgen_signed_##number(DHGEN_HALF_TURN, -v12); \
    /* theta5 */ \
    const dhgen_##number c5 = T13 * s1 + T23 * v6; \
    /* theta234 */ \
    const dhgen_##number v17 = v11 * T32 - v12 * T31, v18 = v14 * v17, c234 = w6 * v18, \
        v19 = v11 * T31 + v12 * T32, v20 = c5 * v19, v21 = v14 * v20 - T33, s234 = w6 * v21, \
        v22 = dhgen_signed_##number(DHGEN_HALF_TURN, v21); \
    /* theta3 */ \
    const dhgen_##number v23 = near_d6 * w6, v25 = near_d5 * c234, v26 = s234 * v23, \
        v27 = T24 * s1 - T14 * v6, v28 = c234 * v23, v29 = near_d5 * s234; \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v109 = e1 * v43, v110 = e1 * v44, v111 = inverse1 * v109, \
        v112 = inverse1 * (e1 * free_joints[1]), v114 = v4 * v75, v115 = v4 * v79, \
        v116 = v109 * v109, v117 = v111 - v4 * v76, v118 = v4 * v77 - inverse1 * v110, \
        v119 = v4 * v78 - v112, \
        v121 = v120 + v93 * (v45 + (v54 + dhgen_sqrt_##number(v116 + v110 * v110))), \
        v124 = v96 + (v5 * v101 - w1 * v114), v125 = w1 * v117 + v5 * v102 - v91, \
        v126 = v97 + (w1 * v118 - v5 * v103), v127 = v92 + (w1 * v119 - v5 * v104), \
        v128 = v98 + (v5 * v105 - w1 * v115), \
        v129 = v99 + (v121 * v122 + v108 * dhgen_abs_##number(v5) + v123 * (v121 + \
            (dhgen_sqrt_##number(v114 * v114 + v117 * v117 + v118 * v118) + \
            dhgen_sqrt_##number(v119 * v119 + v115 * v115)))), \
        v132 = v42 * dhgen_abs_##number(v6), \
        v134 = v129 + (dhgen_sqrt_##number(v124 * v124 + v125 * v125 + v126 * v126) + \
            dhgen_sqrt_##number(v127 * v127 + v128 * v128)), v138 = e1 * v60, v139 = v9 * v76, \
        v140 = v9 * v78, v141 = v111 - v9 * v75, v142 = v9 * v77 - inverse1 * v138, \
        v143 = v112 - v9 * v79, \
        v145 = v144 + v93 * (v45 + (v54 + dhgen_sqrt_##number(v116 + v138 * v138))), \
        v150 = v147 + (w1 * v141 + v10 * v101), v152 = v151 + (v10 * v102 - w1 * v139), \
        v154 = v153 + (w1 * v142 - v10 * v103), v156 = v155 + (w1 * v140 - v10 * v104), \
        v157 = v148 + (w1 * v143 + v10 * v105), \
        v158 = v149 + (v122 * v145 + v108 * dhgen_abs_##number(v10) + v123 * (v145 + \
            (dhgen_sqrt_##number(v141 * v141 + v139 * v139 + v142 * v142) + \
            dhgen_sqrt_##number(v140 * v140 + v143 * v143)))), \
        v160 = v42 * dhgen_abs_##number(s1), \
        v162 = v158 + (dhgen_sqrt_##number(v150 * v150 + v152 * v152 + v154 * v154) + \
            dhgen_sqrt_##number(v156 * v156 + v157 * v157)), \
        v165 = T21 * v124 - v6 * v131 + T11 * v150, v166 = T21 * v125 + (s1 * v131 + T11 * v152), \
        v167 = v6 * v130 + T21 * v126 + (T11 * v154 - s1 * v159), v168 = T21 * v127 + T11 * v156, \
        v169 = T21 * v128 + T11 * v157, \
        v170 = v132 + v129 * v133 + v134 * v137 + (v160 + v158 * v161 + v162 * v164), \
        v171 = v11 * v165, v172 = v11 * v166, v173 = v11 * v167, v174 = v11 * v168, \
        v175 = v11 * v169, v176 = dhgen_abs_##number(v11), v177 = v170 * v176, \
        v178 = v170 + (dhgen_sqrt_##number(v165 * v165 + v166 * v166 + v167 * v167) + \
            dhgen_sqrt_##number(v168 * v168 + v169 * v169)), v179 = v178 * v178, \
        v190 = T22 * v124 - v6 * v181 + T12 * v150, v191 = T22 * v125 + (s1 * v181 + T12 * v152), \
        v192 = v6 * v180 + T22 * v126 + (T12 * v154 - s1 * v186), v193 = T22 * v127 + T12 * v156, \
        v194 = T22 * v128 + T12 * v157, \
        v195 = v132 + v129 * v182 + v134 * v185 + (v160 + v158 * v187 + v162 * v189), \
        v196 = v12 * v190, v197 = v12 * v191, v198 = v12 * v192, v199 = v12 * v193, \
        v200 = v12 * v194, v201 = dhgen_abs_##number(v12), v202 = v195 * v201, \
        v203 = v195 + (dhgen_sqrt_##number(v190 * v190 + v191 * v191 + v192 * v192) + \
            dhgen_sqrt_##number(v193 * v193 + v194 * v194)), v204 = v203 * v203, \
        v205 = v171 + v171 + (v196 + v196), v206 = v172 + v172 + (v197 + v197), \
        v207 = v173 + v173 + (v198 + v198), v208 = v174 + v174 + (v199 + v199), \
        v209 = v175 + v175 + (v200 + v200), v210 = v179 + (v177 + v177) + (v204 + (v202 + v202)), \
        v211 = DHGEN_QUOTIENT(near1, w6), v212 = v205 * v211, v213 = v206 * v211, \
        v214 = v207 * v211, v215 = v208 * v211, v216 = v209 * v211, \
        v217 = v210 * dhgen_abs_##number(v211), v218 = dhgen_abs_##number(v14), \
        v219 = v14 * (v14 * v205), v220 = v14 * (v14 * v206), v221 = v14 * (v14 * v207), \
        v222 = v14 * (v14 * v208), v223 = v14 * (v14 * v209), v224 = v218 * (v210 * v218), \
        v225 = v179 + v204, v226 = w6 - dhgen_sqrt_##number(v225), \
        v227 = v224 + (v224 + (dhgen_abs_##number(v223) + (dhgen_abs_##number(v222) + \
            (dhgen_abs_##number(v221) + (dhgen_abs_##number(v219) + dhgen_abs_##number(v220)))))) \
            * DHGEN_QUOTIENT(v210 + (dhgen_sqrt_##number(v205 * v205 + v206 * v206 + v207 * v207) \
            + dhgen_sqrt_##number(v208 * v208 + v209 * v209)), v226 * v226), \
        v230 = T13 * v150 + (T23 * v124 - v6 * v40), v231 = T13 * v152 + s1 * v40 + T23 * v125, \
        v232 = T13 * v154 - s1 * v41 + (T23 * v126 + v6 * v59), v233 = T13 * v156 + T23 * v127, \
        v234 = T13 * v157 + T23 * v128, \
        v235 = v160 + v158 * v228 + v47 * v162 + (v132 + v129 * v229 + v61 * v134), \
        v236 = v42 * v176, v239 = v42 * v201, \
        v242 = v11 * v159 + T31 * v165 + (v12 * v186 + T32 * v190), \
        v243 = T31 * v166 - v11 * v130 + (T32 * v191 - v12 * v180), \
        v244 = T31 * v167 + T32 * v192, v245 = T31 * v168 + T32 * v193, \
        v246 = T31 * v169 + T32 * v194, \
        v247 = v236 + v170 * v237 + v178 * v238 + (v239 + v195 * v240 + v203 * v241), \
        v248 = c5 * v242 + v19 * v230, v249 = c5 * v243 + v19 * v231, \
        v250 = c5 * v244 + v19 * v232, v251 = c5 * v245 + v19 * v233, \
        v252 = c5 * v246 + v19 * v234, \
        v253 = v247 * dhgen_abs_##number(c5) + v235 * dhgen_abs_##number(v19) + (v235 + \
            (dhgen_sqrt_##number(v230 * v230 + v231 * v231 + v232 * v232) + \
            dhgen_sqrt_##number(v233 * v233 + v234 * v234))) * (v247 + (dhgen_sqrt_##number(v242 * \
            v242 + v243 * v243 + v244 * v244) + dhgen_sqrt_##number(v245 * v245 + v246 * v246))), \
        v254 = v227 + (dhgen_sqrt_##number(v219 * v219 + v220 * v220 + v221 * v221) + \
            dhgen_sqrt_##number(v222 * v222 + v223 * v223)), v255 = v14 * v250 - v20 * v221, \
        v256 = v14 * v251 - v20 * v222, v257 = v14 * v252 - v20 * v223, \
        v258 = v14 * v248 - v20 * v219 - v41, v259 = v59 + (v14 * v249 - v20 * v220), \
        v260 = v42 + (v218 * v253 + v227 * dhgen_abs_##number(v20) + v254 * (v253 + \
            (dhgen_sqrt_##number(v248 * v248 + v249 * v249 + v250 * v250) + \
            dhgen_sqrt_##number(v251 * v251 + v252 * v252)))), v261 = dhgen_abs_##number(w6), \
        v262 = v217 + (dhgen_sqrt_##number(v212 * v212 + v213 * v213 + v214 * v214) + \
            dhgen_sqrt_##number(v215 * v215 + v216 * v216)), v263 = w6 * v258 + v21 * v212, \
        v264 = w6 * v259 + v21 * v213, v265 = w6 * v255 + v21 * v214, \
        v266 = w6 * v256 + v21 * v215, v267 = w6 * v257 + v21 * v216, \
        v268 = v260 * v261 + v217 * dhgen_abs_##number(v21) + v262 * (v260 + \
            (dhgen_sqrt_##number(v258 * v258 + v259 * v259 + v255 * v255) + \
            dhgen_sqrt_##number(v256 * v256 + v257 * v257))), v269 = near_d6 * v212, \
        v270 = near_d6 * v213, v271 = near_d6 * v214, v272 = near_d6 * v215, \
        v273 = near_d6 * v216, v274 = near_d6 * v217, v275 = dhgen_abs_##number(v23), \
        v276 = v274 + (dhgen_sqrt_##number(v269 * v269 + v270 * v270 + v271 * v271) + \
            dhgen_sqrt_##number(v272 * v272 + v273 * v273)), v277 = s234 * v269 + v23 * v263, \
        v278 = s234 * v270 + v23 * v264, v279 = s234 * v271 + v23 * v265, \
        v280 = s234 * v272 + v23 * v266, v281 = s234 * v273 + v23 * v267, \
        v282 = v11 * v186 + T32 * v165 - (v12 * v159 + T31 * v190), \
        v283 = T32 * v166 - v11 * v180 + (v12 * v130 - T31 * v191), \
        v284 = T32 * v167 - T31 * v192, v285 = T32 * v168 - T31 * v193, \
        v286 = T32 * v169 - T31 * v194, \
        v287 = v236 + v170 * v240 + v178 * v241 + (v239 + v195 * v237 + v203 * v238), \
        v288 = v14 * v282 - v17 * v219, v289 = v14 * v283 - v17 * v220, \
        v290 = v14 * v284 - v17 * v221, v291 = v14 * v285 - v17 * v222, \
        v292 = v14 * v286 - v17 * v223, \
        v293 = v218 * v287 + v227 * dhgen_abs_##number(v17) + v254 * (v287 + \
            (dhgen_sqrt_##number(v282 * v282 + v283 * v283 + v284 * v284) + \
            dhgen_sqrt_##number(v285 * v285 + v286 * v286))), v294 = w6 * v288 + v18 * v212, \
        v295 = w6 * v289 + v18 * v213, v296 = w6 * v290 + v18 * v214, \
        v297 = w6 * v291 + v18 * v215, v298 = w6 * v292 + v18 * v216, \
        v299 = v261 * v293 + v217 * dhgen_abs_##number(v18) + v262 * (v293 + \
            (dhgen_sqrt_##number(v288 * v288 + v289 * v289 + v290 * v290) + \
            dhgen_sqrt_##number(v291 * v291 + v292 * v292))), v300 = near_d5 * v294, \
        v301 = near_d5 * v295, v302 = near_d5 * v296, v303 = near_d5 * v297, \
        v304 = near_d5 * v298, \
        v310 = v274 * dhgen_abs_##number(s234) + v268 * v275 + v276 * (v268 + \
            (dhgen_sqrt_##number(v263 * v263 + v264 * v264 + v265 * v265) + \
            dhgen_sqrt_##number(v266 * v266 + v267 * v267))) + near_d5 * v299, \
        v323 = T24 * v150 - T14 * v124, v324 = T24 * v152 - T14 * v125, \
        v325 = T24 * v154 - T14 * v126, v326 = T24 * v156 - (T14 * v127 + v6 * free_joints[1]), \
        v327 = T24 * v157 + s1 * free_joints[1] - T14 * v128, v328 = c234 * v269 + v23 * v294, \
        v329 = c234 * v270 + v23 * v295, v330 = c234 * v271 + v23 * v296, \
        v331 = c234 * v272 + v23 * v297, v332 = c234 * v273 + v23 * v298, v333 = near_d5 * v263, \
        v334 = near_d5 * v264, v335 = near_d5 * v265, v336 = near_d5 * v266, \
        v337 = near_d5 * v267, \
        v343 = v158 * v321 + v54 * v162 + (v129 * v322 + v54 * v134) + (v274 * \
            dhgen_abs_##number(c234) + v275 * v299 + v276 * (v299 + (dhgen_sqrt_##number(v294 * \
            v294 + v295 * v295 + v296 * v296) + dhgen_sqrt_##number(v297 * v297 + v298 * v298))) + \
            near_d5 * v268)
#define SIGNED_TWICE(number, signs) \
    /* theta6 */ \
    const dhgen_##signs v16 = near_m3 * (e6 - 1.0); \
    /* theta3 */ \
    const dhgen_##number Z1_3 = v24 + (v26 + e6 * v25), Z2_3 = v27 + (v28 - e6 * v29), \
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3, v30 = near_longest3 - N3, v31 = N3 - near_shortest3, \
        D3_squared = v30 * v31, w3 = dhgen_sqrt_##number(D3_squared), v32 = w3 - w3; \
    /* theta2 */ \
    const dhgen_##number v33 = near_m6 + near_m5 * N3, v34 = Z1_3 * v33, v35 = Z2_3 * v33, \
        v36 = w3 * (near_m5 * Z2_3), v37 = w3 * (near_m5 * Z1_3); \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v305 = v277 + e6 * v300, v306 = v278 + e6 * v301, \
        v307 = v279 + e6 * v302, v308 = v280 + e6 * v303, v309 = v281 + e6 * v304, \
        v311 = Z1_3 * v305, v312 = Z1_3 * v306, v313 = Z1_3 * v307, v314 = Z1_3 * v308, \
        v315 = Z1_3 * v309, v316 = Z1_3 * free_joints[1], v317 = v310 * dhgen_abs_##number(Z1_3), \
        v319 = v310 + (dhgen_sqrt_##number(v305 * v305 + v306 * v306 + v307 * v307) + \
            dhgen_sqrt_##number(v318 + (v308 * v308 + v309 * v309))), v320 = v316 + v316, \
        v338 = v323 + (v328 - e6 * v333), v339 = v324 + (v329 - e6 * v334), \
        v340 = v325 + (v330 - e6 * v335), v341 = v326 + (v331 - e6 * v336), \
        v342 = v327 + (v332 - e6 * v337), v344 = Z2_3 * v338, v345 = Z2_3 * v339, \
        v346 = Z2_3 * v340, v347 = Z2_3 * v341, v348 = Z2_3 * v342, \
        v349 = v343 * dhgen_abs_##number(Z2_3), \
        v350 = v343 + (dhgen_sqrt_##number(v338 * v338 + v339 * v339 + v340 * v340) + \
            dhgen_sqrt_##number(v341 * v341 + v342 * v342)), v351 = v311 + v311 + (v344 + v344), \
        v352 = v312 + v312 + (v345 + v345), v353 = v313 + v313 + (v346 + v346), \
        v354 = v314 + v314 + (v347 + v347), v355 = v315 + v315 + (v348 + v348), \
        v356 = v317 + v317 + v319 * v319 + (v349 + v349 + v350 * v350), \
        v357 = v356 + (dhgen_sqrt_##number(v351 * v351 + v352 * v352 + v353 * v353) + \
            dhgen_sqrt_##number(v354 * v354 + v355 * v355 + v320 * v320)), \
        v358 = v30 * v351 - v31 * v351, v359 = v30 * v352 - v31 * v352, \
        v360 = v30 * v353 - v31 * v353, v361 = v30 * v354 - v31 * v354, \
        v362 = v30 * v355 - v31 * v355, v363 = v30 * v320 - v31 * v320, \
        v364 = v356 * dhgen_abs_##number(v30) + v356 * dhgen_abs_##number(v31) + v357 * v357 + \
            (dhgen_sqrt_##number(v358 * v358 + v359 * v359 + v360 * v360) + \
            dhgen_sqrt_##number(v361 * v361 + v362 * v362 + v363 * v363))

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    DHGEN_ENTRIES(dhgen_wide);
    dhgen_wide_mask left = (dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL) == 0;
    KNOWN(wide);
    left |= (dhgen_abs_wide(v73 + (D1_squared + D1_squared)) <= v73) | (dhgen_abs_wide(N1) <= v81) |
        (dhgen_abs_wide(D1_squared) <= near_m1);

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        SIGNED(wide, double);

        /* theta1 */
        const dhgen_wide angle1 = dhgen_atan2_wide(s1, -v6);

        /* theta6 */
        const dhgen_wide angle2 = dhgen_atan2_wide(-v12, v11);

        /* theta5 */
        const dhgen_wide angle3 = dhgen_atan2_wide(w6, c5);

        /* theta234 */
        const dhgen_wide angle4 = dhgen_atan2_wide(v21, v18);
        left |= (v13 <= near_m2) | (dhgen_abs_wide(v13) <= v225);

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e6 = i2 == 0 ? 1.0 : -1.0;
            SIGNED_TWICE(wide, double);

            /* theta234 */
            const dhgen_wide theta234 = angle4 + v16 * v22;

            /* theta3 */
            const dhgen_wide angle5 = dhgen_atan2_wide(w3, N3 - near_k5);

            /* theta2 */
            const dhgen_wide angle6 = dhgen_atan2_wide(v36 - v34, -(v35 + v37)),
                angle7 = dhgen_atan2_wide(-(v34 + v36), v37 - v35);

            /* joint values */
            const dhgen_wide v38 = theta234 - (angle5 + angle6), v39 = theta234 - (angle7 - angle5),
                q1_p = angle1 + v32, q5_p = v32 + e6 * angle3, q6_p = v32 + (angle2 + v15 * v16);
            const int row = 4 * i1 + 2 * i2;
            q[6 * row] = q1_p; q[6 * row + 1] = angle6; q[6 * row + 2] = angle5;
            q[6 * row + 3] = dhgen_centred_wide(v38); q[6 * row + 4] = q5_p; q[6 * row + 5] = q6_p;
            kind[row] = dhgen_kind_wide(q[6 * row]);
            q[6 * row + 6] = q1_p; q[6 * row + 7] = angle7; q[6 * row + 8] = -angle5;
            q[6 * row + 9] = dhgen_centred_wide(v39); q[6 * row + 10] = q5_p;
            q[6 * row + 11] = q6_p;
            kind[row + 1] = dhgen_kind_wide(q[6 * row + 6]);
            left |= (dhgen_abs_wide(v1 * D3_squared) <= near_m4) | (dhgen_abs_wide(v364 +
                (D3_squared + D3_squared)) <= v364);
        }
    }
    return left;
}

#if DHGEN_LANES > 1
/* One regular pose, two signs in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    const dhgen_four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e6 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);
    KNOWN(double);
    SIGNED(four, four);
    SIGNED_TWICE(four, four);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((v13 <= near_m2)
        | (dhgen_abs_four(v13) <= v225)) | ((dhgen_abs_four(v1 * D3_squared) <= near_m4) |
        (dhgen_abs_four(v364 + (D3_squared + D3_squared)) <= v364))) | (unsigned)((fabs(v73 +
        (D1_squared + D1_squared)) <= v73) | (fabs(N1) <= v81) | (fabs(D1_squared) <= near_m1)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(s1, -v12, 0, 5, 2, 7),
        dhgen_shuffle(-v6, v11, 0, 5, 2, 7)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(w6, v21, 0, 5, 2, 7), dhgen_shuffle(c5, v18, 0, 5,
            2, 7)), ratio3 = dhgen_ratio_four(w3, N3 - near_k5),
        ratio4 = dhgen_ratio_four(v36 - v34, -(v35 + v37)),
        ratio5 = dhgen_ratio_four(-(v34 + v36), v37 - v35);
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 3, 3), packed2 = dhgen_angle_four(ratio2),
        angle3 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2),
        angle4 = dhgen_shuffle(packed2, packed2, 1, 1, 3, 3), angle5 = dhgen_angle_four(ratio3),
        angle6 = dhgen_angle_four(ratio4), angle7 = dhgen_angle_four(ratio5);
    const dhgen_four theta234 = angle4 + v16 * v22, v38 = theta234 - (angle5 + angle6),
        v39 = theta234 - (angle7 - angle5), q4_p = dhgen_centred_four(v38),
        q4_m = dhgen_centred_four(v39), q1_p = angle1 + v32, q5_p = v32 + e6 * angle3,
        q6_p = v32 + (angle2 + v15 * v16);

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, angle6, angle5, q4_p);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, q5_p, q6_p);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, angle7, -angle5, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, q5_p, q6_p);
    const unsigned long long none1 = (dhgen_bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~none1);
}
#endif
#define DHGEN_REGULAR_ROWS 8
#include "dhgen/one_pose.h"
#endif

DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *q, unsigned char *status);

DHGEN_FN int solve_certain(
    const double *T, const double *free_joints, double *q, unsigned char *status);

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm_of_kind = {
    6, 16, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.762, 0.762, 0.762, 1.0, 1.0, 1.0 }, 0.762020879372095, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 1, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, NULL, NULL, solve,
    solve_certain,
};

DHGEN_TABLE dhgen_kind kind = {
    0, /* the convention: 0 standard, 1 modified */
    { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 },
    { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 }, /* how joints count */
    ur5e_fleet_nominal[0],
    1.3122999999999998, /* size */
    0x2u, 0x0u, /* bit i: axes i, i + 1 and i + 2 are parallel; meet */
    &arm_of_kind, &descents, &general,
#ifdef UR5E_FLEET_PLAIN
    NULL, NULL, 0,
#else
    solve_regular, solve_wide, 8,
#endif
};

/* Regular poses: what the caller gives is the arm. Returns how many rows are OK, or -1 if the pose
 * has to be left to `solve`. */
DHGEN_FN int solve_certain(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    return dhgen_certain_rows(&kind, dhgen_handed_arm(free_joints), T, q, status);
}

/* Fills the rows that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *q, unsigned char *status)
{
    (void)moved;
    dhgen_calibrated_rows(&kind, dhgen_handed_arm(free_joints), T, seed, q, status);
}

#define DHGEN_NAME(function) ur5e_fleet_##function
#include "dhgen/functions_calibrated.h"

/* ur5e_fleet: Universal Robots UR5e, calibrated
 *
 * Inverse kinematics, generated from robots/ur5e.yaml and templates/c/calibrated.c.jinja.
 * Do not edit: run dhgen robots/ur5e.yaml. The formulas and where they come from: ur5e.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: 988807eb9222c0a0
 * SPDX-License-Identifier: MIT
 */
#include "ur5e_fleet.h"

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

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const double ur5e_fleet_nominal[6][4] = {
    { 0.0, 0.1625, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, -0.425, 0.0 },
    { 0.0, 0.0, -0.3922, 0.0 },
    { 0.0, 0.1333, 0.0, 1.5707963267948966 },
    { 0.0, 0.0997, 0.0, -1.5707963267948966 },
    { 0.0, 0.0996, 0.0, 0.0 },
};

const char *const ur5e_fleet_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const struct dhgen_joint joints[6] = {
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
static const int solved[6] = { 0, 1, 2, 3, 4, 5 };
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.762020879372095, 0.762020879372095, 0.762020879372095, 0.762020879372095, 0.762020879372095,
    0.762020879372095,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
static const double span_low[6] = {
    -6.283185307179586, -6.283185307179586, -6.283185307179586, -6.283185307179586,
    -6.283185307179586, -6.283185307179586,
};
static const double span_width[6] = {
    12.566370614359172, 12.566370614359172, 12.566370614359172, 12.566370614359172,
    12.566370614359172, 12.566370614359172,
};
static const double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
static const double least_u[6] = {
    -6.283185307179586, -6.283185307179586, -6.283185307179586, -6.283185307179586,
    -6.283185307179586, -6.283185307179586,
};
static const double most_u[6] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};
/* How the loop counts the joints: which way, and from where. */
static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

static const struct dhgen_numerical_arm descents = {
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
 * near_k6 = 2.9996700362960076 [m^-2]. */
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
    /* 10 * (near_longest3 - near_longest3_clear) * (near_longest3_clear - near_shortest3) [m^4] */
    near_m4 = 1.4300283221564012e-10,
    near_m5 = 1.1764705882352942, /* -near_a3 * near_k6 [m^-1] */
    near_m6 = 0.031534305882352925, /* near_a3 * near_k5 * near_k6 - near_a2 [m] */
    near1 = 0.5; /* 1 / 2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide X1 = near_d6 * T13 - T14, wy = T24 - near_d6 * T23, N1 = X1 * X1 + wy * wy,
        D1 = N1 - near_k1, w1 = dhgen_sqrt_wide(D1), v1 = near_k4 * w1, v2 = dhgen_abs_wide(D1),
        inverse1 = 1.0 / N1, v3 = near_d4 * wy, v4 = inverse1 * v3, v5 = X1 * inverse1,
        v6 = inverse1 * -X1, v7 = v4 + w1 * v5, v8 = v4 + w1 * v6, v9 = near_d4 * X1,
        v10 = inverse1 * v9, v11 = wy * inverse1, v12 = inverse1 * -wy, s1_p = w1 * v11 - v10,
        s1_m = w1 * v12 - v10, angle1 = dhgen_atan2_wide(s1_p, -v7),
        angle2 = dhgen_atan2_wide(s1_m, -v8);

    /* theta6 */
    const dhgen_wide v13 = v7 * T21 + s1_p * T11, v14 = v8 * T21 + s1_m * T11,
        v15 = v7 * T22 + s1_p * T12, v16 = v8 * T22 + s1_m * T12, v17 = v13 * v13 + v15 * v15,
        v18 = v14 * v14 + v16 * v16, w6_p = dhgen_sqrt_wide(v17), w6_m = dhgen_sqrt_wide(v18),
        v19 = 1.0 / v17, v20 = 1.0 / v18, angle3 = dhgen_atan2_wide(-v15, v13),
        angle4 = dhgen_atan2_wide(-v16, v14);

    /* theta5 */
    const dhgen_wide c5_p = T13 * s1_p + T23 * v7, c5_m = T13 * s1_m + T23 * v8,
        angle5 = dhgen_atan2_wide(w6_p, c5_p), angle6 = dhgen_atan2_wide(w6_m, c5_m);

    /* theta234 */
    const dhgen_wide v21 = v13 * T32 - v15 * T31, v22 = v14 * T32 - v16 * T31, v23 = v19 * v21,
        v24 = v20 * v22, c234_p = w6_p * v23, c234_m = w6_m * v24, v25 = v13 * T31 + v15 * T32,
        v26 = v14 * T31 + v16 * T32, v27 = c5_p * v25, v28 = c5_m * v26, v29 = v19 * v27 - T33,
        v30 = v20 * v28 - T33, s234_p = w6_p * v29, s234_m = w6_m * v30,
        angle7 = dhgen_atan2_wide(v29, v23), angle8 = dhgen_atan2_wide(v30, v24),
        theta234_pm = angle7 - dhgen_signed_wide(DHGEN_HALF_TURN, v29),
        theta234_mm = angle8 - dhgen_signed_wide(DHGEN_HALF_TURN, v30);

    /* theta3 */
    const dhgen_wide v31 = near_d6 * w6_p, v32 = near_d6 * w6_m, v33 = T34 - near_d1,
        v34 = near_d5 * c234_p, v35 = near_d5 * c234_m, v36 = s234_p * v31, v37 = s234_m * v32,
        Z1_3_pp = v33 + (v34 + v36), Z1_3_pm = v33 + (v36 - v34), Z1_3_mp = v33 + (v35 + v37),
        Z1_3_mm = v33 + (v37 - v35), v38 = T24 * s1_p - T14 * v7, v39 = T24 * s1_m - T14 * v8,
        v40 = c234_p * v31, v41 = c234_m * v32, v42 = near_d5 * s234_p, v43 = near_d5 * s234_m,
        Z2_3_pp = v38 + (v40 - v42), Z2_3_pm = v38 + (v40 + v42), Z2_3_mp = v39 + (v41 - v43),
        Z2_3_mm = v39 + (v41 + v43), N3_pp = Z1_3_pp * Z1_3_pp + Z2_3_pp * Z2_3_pp,
        N3_pm = Z1_3_pm * Z1_3_pm + Z2_3_pm * Z2_3_pm,
        N3_mp = Z1_3_mp * Z1_3_mp + Z2_3_mp * Z2_3_mp,
        N3_mm = Z1_3_mm * Z1_3_mm + Z2_3_mm * Z2_3_mm, v44 = near_longest3 - N3_pp,
        v45 = near_longest3 - N3_pm, v46 = near_longest3 - N3_mp, v47 = near_longest3 - N3_mm,
        v48 = N3_pp - near_shortest3, v49 = N3_pm - near_shortest3, v50 = N3_mp - near_shortest3,
        v51 = N3_mm - near_shortest3, D3_pp = v44 * v48, D3_pm = v45 * v49, D3_mp = v46 * v50,
        D3_mm = v47 * v51, w3_pp = dhgen_sqrt_wide(D3_pp), w3_pm = dhgen_sqrt_wide(D3_pm),
        w3_mp = dhgen_sqrt_wide(D3_mp), w3_mm = dhgen_sqrt_wide(D3_mm), v52 = w3_pp - w3_pp,
        v53 = w3_pm - w3_pm, v54 = w3_mp - w3_mp, v55 = w3_mm - w3_mm,
        angle9 = dhgen_atan2_wide(w3_pp, N3_pp - near_k5),
        angle10 = dhgen_atan2_wide(w3_pm, N3_pm - near_k5),
        angle11 = dhgen_atan2_wide(w3_mp, N3_mp - near_k5),
        angle12 = dhgen_atan2_wide(w3_mm, N3_mm - near_k5);

    /* theta2 */
    const dhgen_wide v56 = near_m6 + near_m5 * N3_pp, v57 = near_m6 + near_m5 * N3_pm,
        v58 = near_m6 + near_m5 * N3_mp, v59 = near_m6 + near_m5 * N3_mm, v60 = Z1_3_pp * v56,
        v61 = Z1_3_pm * v57, v62 = Z1_3_mp * v58, v63 = Z1_3_mm * v59, v64 = Z2_3_pp * v56,
        v65 = Z2_3_pm * v57, v66 = Z2_3_mp * v58, v67 = Z2_3_mm * v59,
        v68 = w3_pp * (near_m5 * Z2_3_pp), v69 = w3_pp * (near_m5 * Z1_3_pp),
        angle13 = dhgen_atan2_wide(v68 - v60, -(v64 + v69)),
        angle14 = dhgen_atan2_wide(-(v60 + v68), v69 - v64), v70 = w3_pm * (near_m5 * Z2_3_pm),
        v71 = w3_pm * (near_m5 * Z1_3_pm), angle15 = dhgen_atan2_wide(v70 - v61, -(v65 + v71)),
        angle16 = dhgen_atan2_wide(-(v61 + v70), v71 - v65), v72 = w3_mp * (near_m5 * Z2_3_mp),
        v73 = w3_mp * (near_m5 * Z1_3_mp), angle17 = dhgen_atan2_wide(v72 - v62, -(v66 + v73)),
        angle18 = dhgen_atan2_wide(-(v62 + v72), v73 - v66), v74 = w3_mm * (near_m5 * Z2_3_mm),
        v75 = w3_mm * (near_m5 * Z1_3_mm), angle19 = dhgen_atan2_wide(v74 - v63, -(v67 + v75)),
        angle20 = dhgen_atan2_wide(-(v63 + v74), v75 - v67);

    /* joint values */
    const dhgen_wide v76 = angle7 - (angle9 + angle13), v77 = angle7 - (angle14 - angle9),
        v78 = theta234_pm - (angle10 + angle15), v79 = theta234_pm - (angle16 - angle10),
        v80 = angle8 - (angle11 + angle17), v81 = angle8 - (angle18 - angle11),
        v82 = theta234_mm - (angle12 + angle19), v83 = theta234_mm - (angle20 - angle12),
        q1_ppp = angle1 + v52, q1_pmp = angle1 + v53, q1_mpp = angle2 + v54, q1_mmp = angle2 + v55,
        q5_ppp = angle5 + v52, q5_pmp = v53 - angle5, q5_mpp = angle6 + v54, q5_mmp = v55 - angle6,
        q6_ppp = angle3 + v52, q6_pmp = v53 + (angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, -v15)),
        q6_mpp = angle4 + v54, q6_mmp = v55 + (angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, -v16)),
        v84 = dhgen_abs_wide(T13), v85 = free_joints[1] + near_d6 * free_joints[0],
        v86 = dhgen_abs_wide(X1), v87 = dhgen_abs_wide(T23), v88 = dhgen_abs_wide(wy),
        v89 = v85 * (v85 + 2.0 * v86) + v85 * (v85 + 2.0 * v88), v90 = dhgen_abs_wide(N1),
        v91 = dhgen_abs_wide(inverse1), v92 = v89 * v91 / (v90 - v89), v93 = near_d4 * v85,
        v94 = v91 * v93, v95 = v94 + v92 * (v93 + dhgen_abs_wide(v3)), v96 = v89 / D1,
        v97 = v96 * (1.0 + v96) * (near1 * w1), v98 = v85 * v91, v99 = v98 + v92 * (v85 + v86),
        v100 = dhgen_abs_wide(w1), v101 = v99 * v100,
        v102 = v95 + (v101 + v97 * (v99 + dhgen_abs_wide(v5))),
        v103 = v95 + (v101 + v97 * (v99 + dhgen_abs_wide(v6))), v104 = dhgen_abs_wide(v7),
        v105 = dhgen_abs_wide(v8), v106 = free_joints[0] * v104, v107 = free_joints[0] * v105,
        v108 = free_joints[0] + dhgen_abs_wide(T21), v109 = v98 + v92 * (v85 + v88),
        v110 = v94 + v92 * (v93 + dhgen_abs_wide(v9)), v111 = v100 * v109,
        v112 = v110 + (v111 + v97 * (v109 + dhgen_abs_wide(v11))),
        v113 = v110 + (v111 + v97 * (v109 + dhgen_abs_wide(v12))), v114 = dhgen_abs_wide(s1_p),
        v115 = dhgen_abs_wide(s1_m), v116 = free_joints[0] * v114, v117 = free_joints[0] * v115,
        v118 = free_joints[0] + dhgen_abs_wide(T11),
        v119 = v106 + v102 * v108 + (v116 + v112 * v118),
        v120 = v107 + v103 * v108 + (v117 + v113 * v118), v121 = dhgen_abs_wide(v13),
        v122 = dhgen_abs_wide(v14), v123 = free_joints[0] + dhgen_abs_wide(T22),
        v124 = free_joints[0] + dhgen_abs_wide(T12),
        v125 = v106 + v102 * v123 + (v116 + v112 * v124),
        v126 = v107 + v103 * v123 + (v117 + v113 * v124), v127 = dhgen_abs_wide(v15),
        v128 = dhgen_abs_wide(v16), v129 = v119 * (v119 + 2.0 * v121) + v125 * (v125 + 2.0 * v127),
        v130 = v120 * (v120 + 2.0 * v122) + v126 * (v126 + 2.0 * v128), v131 = dhgen_abs_wide(v17),
        v132 = dhgen_abs_wide(v18), v133 = v119 + v125, v134 = v120 + v126,
        v135 = dhgen_abs_wide(v19), v136 = dhgen_abs_wide(v20), v137 = v129 * v135 / (v131 - v129),
        v138 = v130 * v136 / (v132 - v130), v139 = v112 + v114, v140 = v113 + v115,
        v141 = v102 + v104, v142 = v103 + v105, v143 = free_joints[0] * v121,
        v144 = free_joints[0] * v122, v145 = free_joints[0] + dhgen_abs_wide(T31),
        v146 = free_joints[0] * v127, v147 = free_joints[0] * v128,
        v148 = free_joints[0] + dhgen_abs_wide(T32),
        v149 = v143 + v119 * v145 + (v146 + v125 * v148),
        v150 = v144 + v120 * v145 + (v147 + v126 * v148),
        v151 = v149 * dhgen_abs_wide(c5_p) + (v84 * v112 + free_joints[0] * v139 + (v87 * v102 +
            free_joints[0] * v141)) * (v149 + dhgen_abs_wide(v25)),
        v152 = v150 * dhgen_abs_wide(c5_m) + (v84 * v113 + free_joints[0] * v140 + (v87 * v103 +
            free_joints[0] * v142)) * (v150 + dhgen_abs_wide(v26)),
        v153 = free_joints[0] + (v135 * v151 + v137 * (v151 + dhgen_abs_wide(v27))),
        v154 = free_joints[0] + (v136 * v152 + v138 * (v152 + dhgen_abs_wide(v28))),
        v155 = dhgen_abs_wide(w6_p), v156 = dhgen_abs_wide(w6_m),
        v157 = v153 * v155 + v133 * (v153 + dhgen_abs_wide(v29)),
        v158 = v154 * v156 + v134 * (v154 + dhgen_abs_wide(v30)), v159 = near_d6 * v133,
        v160 = near_d6 * v134, v161 = v159 + dhgen_abs_wide(v31), v162 = v160 + dhgen_abs_wide(v32),
        v163 = v143 + v119 * v148 + (v146 + v125 * v145),
        v164 = v144 + v120 * v148 + (v147 + v126 * v145),
        v165 = v135 * v163 + v137 * (v163 + dhgen_abs_wide(v21)),
        v166 = v136 * v164 + v138 * (v164 + dhgen_abs_wide(v22)),
        v167 = v155 * v165 + v133 * (v165 + dhgen_abs_wide(v23)),
        v168 = v156 * v166 + v134 * (v166 + dhgen_abs_wide(v24)),
        v169 = free_joints[1] + (v159 * dhgen_abs_wide(s234_p) + v157 * v161 + near_d5 * v167),
        v170 = free_joints[1] + (v160 * dhgen_abs_wide(s234_m) + v158 * v162 + near_d5 * v168),
        v171 = dhgen_abs_wide(T24), v172 = dhgen_abs_wide(T14),
        v173 = v112 * v171 + free_joints[1] * v139 + (v102 * v172 + free_joints[1] * v141) + (v159 *
            dhgen_abs_wide(c234_p) + v161 * v167 + near_d5 * v157),
        v174 = v113 * v171 + free_joints[1] * v140 + (v103 * v172 + free_joints[1] * v142) + (v160 *
            dhgen_abs_wide(c234_m) + v162 * v168 + near_d5 * v158),
        v175 = v169 * (v169 + 2.0 * dhgen_abs_wide(Z1_3_pp)) + v173 * (v173 + 2.0 *
            dhgen_abs_wide(Z2_3_pp)),
        v176 = v169 * (v169 + 2.0 * dhgen_abs_wide(Z1_3_pm)) + v173 * (v173 + 2.0 *
            dhgen_abs_wide(Z2_3_pm)),
        v177 = v170 * (v170 + 2.0 * dhgen_abs_wide(Z1_3_mp)) + v174 * (v174 + 2.0 *
            dhgen_abs_wide(Z2_3_mp)),
        v178 = v170 * (v170 + 2.0 * dhgen_abs_wide(Z1_3_mm)) + v174 * (v174 + 2.0 *
            dhgen_abs_wide(Z2_3_mm));

    q[0] = q1_ppp; q[1] = angle13; q[2] = angle9; q[3] = dhgen_centred_wide(v76); q[4] = q5_ppp;
    q[5] = q6_ppp;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_ppp; q[7] = angle14; q[8] = -angle9; q[9] = dhgen_centred_wide(v77); q[10] = q5_ppp;
    q[11] = q6_ppp;
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_pmp; q[13] = angle15; q[14] = angle10; q[15] = dhgen_centred_wide(v78);
    q[16] = q5_pmp; q[17] = q6_pmp;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_pmp; q[19] = angle16; q[20] = -angle10; q[21] = dhgen_centred_wide(v79);
    q[22] = q5_pmp; q[23] = q6_pmp;
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = angle17; q[26] = angle11; q[27] = dhgen_centred_wide(v80);
    q[28] = q5_mpp; q[29] = q6_mpp;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = angle18; q[32] = -angle11; q[33] = dhgen_centred_wide(v81);
    q[34] = q5_mpp; q[35] = q6_mpp;
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mmp; q[37] = angle19; q[38] = angle12; q[39] = dhgen_centred_wide(v82);
    q[40] = q5_mmp; q[41] = q6_mmp;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mmp; q[43] = angle20; q[44] = -angle12; q[45] = dhgen_centred_wide(v83);
    q[46] = q5_mmp; q[47] = q6_mmp;
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v2 <= v89) | (v2 <= near_m1) | (dhgen_abs_wide(v47) <= v178) |
        (dhgen_abs_wide(v1 * D3_mm) <= near_m4) | (dhgen_abs_wide(v46) <= v177) | (dhgen_abs_wide(v1
        * D3_mp) <= near_m4) | (dhgen_abs_wide(v45) <= v176) | (dhgen_abs_wide(v1 * D3_pm) <=
        near_m4) | (dhgen_abs_wide(v44) <= v175) | (dhgen_abs_wide(v1 * D3_pp) <= near_m4) | (v90 <=
        v89) | (dhgen_abs_wide(v51) <= v178) | (dhgen_abs_wide(v50) <= v177) | (dhgen_abs_wide(v49)
        <= v176) | (dhgen_abs_wide(v48) <= v175) | (v132 <= v130) | (v18 <= near_m2) | (v131 <=
        v129) | (v100 <= v97) | (v17 <= near_m2));
}

#if DHGEN_LANES > 1
static const double
    near_m3 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    const dhgen_four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e6 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta1 */
    const double X1 = near_d6 * T13 - T14, wy = T24 - near_d6 * T23, N1 = X1 * X1 + wy * wy,
        D1 = N1 - near_k1, w1 = sqrt(D1), v1 = near_k4 * w1, v2 = fabs(D1), inverse1 = 1.0 / N1,
        v3 = near_d4 * wy, v4 = inverse1 * v3;
    const dhgen_four v5 = inverse1 * (e1 * X1), v6 = v4 + w1 * v5;
    const double v7 = near_d4 * X1, v8 = inverse1 * v7;
    const dhgen_four v9 = inverse1 * (e1 * wy), s1 = w1 * v9 - v8;

    /* theta6 */
    const dhgen_four v10 = v6 * T21 + s1 * T11, v11 = v6 * T22 + s1 * T12,
        v12 = v10 * v10 + v11 * v11, w6 = dhgen_sqrt_four(v12), v13 = 1.0 / v12,
        v14 = dhgen_signed_four(DHGEN_HALF_TURN, -v11), v15 = near_m3 * (e6 - 1.0);

    /* theta5 */
    const dhgen_four c5 = T13 * s1 + T23 * v6;

    /* theta234 */
    const dhgen_four v16 = v10 * T32 - v11 * T31, v17 = v13 * v16, c234 = w6 * v17,
        v18 = v10 * T31 + v11 * T32, v19 = c5 * v18, v20 = v13 * v19 - T33, s234 = w6 * v20,
        v21 = dhgen_signed_four(DHGEN_HALF_TURN, v20);

    /* theta3 */
    const dhgen_four v22 = near_d6 * w6;
    const double v23 = T34 - near_d1;
    const dhgen_four v24 = near_d5 * c234, v25 = s234 * v22, Z1_3 = v23 + (v25 + e6 * v24),
        v26 = T24 * s1 - T14 * v6, v27 = c234 * v22, v28 = near_d5 * s234,
        Z2_3 = v26 + (v27 - e6 * v28), N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3, v29 = near_longest3 - N3,
        v30 = N3 - near_shortest3, D3 = v29 * v30, w3 = dhgen_sqrt_four(D3), v31 = w3 - w3;

    /* theta2 */
    const dhgen_four v32 = near_m6 + near_m5 * N3, v33 = Z1_3 * v32, v34 = Z2_3 * v32,
        v35 = w3 * (near_m5 * Z2_3), v36 = w3 * (near_m5 * Z1_3);

    /* joint values */
    const double v39 = fabs(T13), v40 = free_joints[1] + near_d6 * free_joints[0], v41 = fabs(X1),
        v42 = fabs(T23), v43 = fabs(wy), v44 = v40 * (v40 + v41 * 2.0) + v40 * (v40 + v43 * 2.0),
        v45 = fabs(N1), v46 = fabs(inverse1), v47 = v44 * v46 / (v45 - v44), v48 = near_d4 * v40,
        v49 = v46 * v48, v50 = v49 + v47 * (v48 + fabs(v3)), v51 = v44 / D1,
        v52 = v51 * (1.0 + v51) * (near1 * w1);
    const dhgen_four v53 = v40 * dhgen_abs_four(e1), v54 = v46 * v53, v55 = v54 + v47 * (v41 + v53);
    const double v56 = fabs(w1);
    const dhgen_four v57 = v50 + (v55 * v56 + v52 * (v55 + dhgen_abs_four(v5))),
        v58 = dhgen_abs_four(v6), v59 = free_joints[0] * v58;
    const double v60 = free_joints[0] + fabs(T21);
    const dhgen_four v61 = v54 + v47 * (v43 + v53);
    const double v62 = v49 + v47 * (v48 + fabs(v7));
    const dhgen_four v63 = v62 + (v56 * v61 + v52 * (v61 + dhgen_abs_four(v9))),
        v64 = dhgen_abs_four(s1), v65 = free_joints[0] * v64;
    const double v66 = free_joints[0] + fabs(T11);
    const dhgen_four v67 = v59 + v57 * v60 + (v65 + v63 * v66), v68 = dhgen_abs_four(v10);
    const double v69 = free_joints[0] + fabs(T22), v70 = free_joints[0] + fabs(T12);
    const dhgen_four v71 = v59 + v57 * v69 + (v65 + v63 * v70), v72 = dhgen_abs_four(v11),
        v73 = v67 * (v67 + 2.0 * v68) + v71 * (v71 + 2.0 * v72), v74 = dhgen_abs_four(v12),
        v75 = v67 + v71, v76 = dhgen_abs_four(v13), v77 = v73 * v76 / (v74 - v73), v78 = v63 + v64,
        v79 = v57 + v58, v80 = free_joints[0] * v68;
    const double v81 = free_joints[0] + fabs(T31);
    const dhgen_four v82 = free_joints[0] * v72;
    const double v83 = free_joints[0] + fabs(T32);
    const dhgen_four v84 = v80 + v67 * v81 + (v82 + v71 * v83),
        v85 = v84 * dhgen_abs_four(c5) + (v39 * v63 + free_joints[0] * v78 + (v42 * v57 +
            free_joints[0] * v79)) * (v84 + dhgen_abs_four(v18)),
        v86 = free_joints[0] + (v76 * v85 + v77 * (v85 + dhgen_abs_four(v19))),
        v87 = dhgen_abs_four(w6), v88 = v86 * v87 + v75 * (v86 + dhgen_abs_four(v20)),
        v89 = near_d6 * v75, v90 = v89 + dhgen_abs_four(v22),
        v91 = v89 * dhgen_abs_four(s234) + v88 * v90, v92 = v80 + v67 * v83 + (v82 + v71 * v81),
        v93 = v76 * v92 + v77 * (v92 + dhgen_abs_four(v16)),
        v94 = v87 * v93 + v75 * (v93 + dhgen_abs_four(v17)), v95 = near_d5 * v94,
        v96 = dhgen_abs_four(e6), v97 = free_joints[1] + (v91 + v95 * v96);
    const double v98 = fabs(T24), v99 = fabs(T14);
    const dhgen_four v100 = v63 * v98 + free_joints[1] * v78 + (v57 * v99 + free_joints[1] * v79),
        v101 = v89 * dhgen_abs_four(c234) + v90 * v94, v102 = near_d5 * v88,
        v103 = v100 + (v101 + v96 * v102),
        v104 = v97 * (v97 + 2.0 * dhgen_abs_four(Z1_3)) + v103 * (v103 + 2.0 *
            dhgen_abs_four(Z2_3));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((v12 <= near_m2)
        | (v74 <= v73)) | ((dhgen_abs_four(v29) <= v104) | (dhgen_abs_four(v30) <= v104) |
        (dhgen_abs_four(v1 * D3) <= near_m4))) | (unsigned)((v2 <= v44) | (v2 <= near_m1) | (v56 <=
        v52) | (v45 <= v44)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(s1, -v11, 0, 5, 2, 7),
        dhgen_shuffle(-v6, v10, 0, 5, 2, 7)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(w6, v20, 0, 5, 2, 7), dhgen_shuffle(c5, v17, 0, 5,
            2, 7)), ratio3 = dhgen_ratio_four(w3, N3 - near_k5),
        ratio4 = dhgen_ratio_four(v35 - v33, -(v34 + v36)),
        ratio5 = dhgen_ratio_four(-(v33 + v35), v36 - v34);
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 3, 3), packed2 = dhgen_angle_four(ratio2),
        angle3 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2),
        angle4 = dhgen_shuffle(packed2, packed2, 1, 1, 3, 3), angle5 = dhgen_angle_four(ratio3),
        angle6 = dhgen_angle_four(ratio4), angle7 = dhgen_angle_four(ratio5);
    const dhgen_four theta234 = angle4 + v15 * v21, v37 = theta234 - (angle5 + angle6),
        v38 = theta234 - (angle7 - angle5), q4_p = dhgen_centred_four(v37),
        q4_m = dhgen_centred_four(v38), q1_p = angle1 + v31, q5_p = v31 + e6 * angle3,
        q6_p = v31 + (angle2 + v14 * v15);

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
#else
static int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    return dhgen_solve_branches(solve_wide, 8, T, free_joints, q, status);
}
#endif
#endif

static void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *q, unsigned char *status);

static const int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
static const struct dhgen_arm arm_of_kind = {
    6, 16, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.762, 0.762, 0.762, 1.0, 1.0, 1.0 }, 0.762020879372095, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 1, /* winds */
    0, /* follows seed */
    NULL, NULL,
    NULL, NULL,
    NULL, NULL, solve,
    NULL,
};

static const dhgen_kind kind = {
    0, /* the convention: 0 standard, 1 modified */
    { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 },
    { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 }, /* how joints count */
    ur5e_fleet_nominal[0],
    1.3122999999999998, /* size */
    0x2u, 0x0u, /* bit i: axes i, i + 1 and i + 2 are parallel; meet */
    &arm_of_kind, &descents, &general,
#ifdef UR5E_FLEET_PLAIN
    NULL, 0,
#else
    solve_regular, 8,
#endif
};

/* Fills the rows that have a solution, and no others: what the caller gives is the arm. */
static void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *q, unsigned char *status)
{
    (void)moved;
    dhgen_calibrated_rows(&kind, dhgen_handed_arm(free_joints), T, seed, q, status);
}

int ur5e_fleet_calibrate(const double *table, ur5e_fleet_calibration *arm)
{
    return dhgen_calibrate(&kind, table, arm);
}

void ur5e_fleet_fk(const ur5e_fleet_calibration *arm, const double q[6], double T[16])
{
    dhgen_serial_pose(arm, q, T);
}

void ur5e_fleet_jacobian(const ur5e_fleet_calibration *arm, const double q[6], double J[36])
{
    dhgen_serial_jacobian(arm, q, J);
}

void ur5e_fleet_joint_velocities(const ur5e_fleet_calibration *arm, const double q[6], const double
    twist[6], double velocities[6])
{
    const struct dhgen_calibrated_arm own = dhgen_calibrated_arm_of(&kind, arm);
    dhgen_joint_velocities(&own.arm, q, twist, velocities);
}

int ur5e_fleet_ik(const ur5e_fleet_calibration *arm, const double T[16], const double *q_seed,
    double q[16][6], unsigned char status[16])
{
    const struct dhgen_calibrated_arm own = dhgen_calibrated_arm_of(&kind, arm);
    return dhgen_careful_ik(&own.arm, T, dhgen_handed_on(arm), q_seed, &q[0][0], status);
}

int ur5e_fleet_ik_nearest(const ur5e_fleet_calibration *arm, const double T[16], const double
    q_seed[6], double q[6])
{
    const struct dhgen_calibrated_arm own = dhgen_calibrated_arm_of(&kind, arm);
    return dhgen_ik_nearest(&own.arm, T, dhgen_handed_on(arm), q_seed, q);
}

void ur5e_fleet_ik_batch(const ur5e_fleet_calibration *arm, size_t n, const double *T, double *q,
    unsigned char *status)
{
    const struct dhgen_calibrated_arm own = dhgen_calibrated_arm_of(&kind, arm);
    dhgen_ik_each(&own.arm, 0, n, T, dhgen_handed_on(arm), q, status);
}

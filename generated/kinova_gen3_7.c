/* kinova_gen3_7: Kinova Gen3 with 7 joints
 *
 * Inverse kinematics, generated from robots/kinova_gen3_7.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kinova_gen3_7.yaml. The formulas and where they come from:
 * kinova_gen3_7.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 24c1f9395bc7745f
 * SPDX-License-Identifier: MIT
 */
#include "kinova_gen3_7.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KINOVA_GEN3_7_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KINOVA_GEN3_7_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 7
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the arm needs of it */
#ifdef KINOVA_GEN3_7_LANES
#define DHGEN_GENERAL_LANES KINOVA_GEN3_7_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"
#include "dhgen/general/near.h"
#ifndef KINOVA_GEN3_7_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.28481, /* joint offset 1 [m] */
    d2 = 0.01175, /* joint offset 2 [m] */
    d3 = 0.42076, /* joint offset 3 [m] */
    d4 = 0.01275, /* joint offset 4 [m] */
    d5 = 0.31436, /* joint offset 5 [m] */
    d6 = 0.00035, /* joint offset 6 [m] */
    d7 = 0.10593, /* joint offset 7 [m] */
    offset2 = 3.141592653589793, /* offset of joint 2 [rad] */
    offset3 = 3.141592653589793, /* offset of joint 3 [rad] */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    offset6 = 3.141592653589793, /* offset of joint 6 [rad] */
    offset7 = 3.141592653589793; /* offset of joint 7 [rad] */

#ifndef __CUDACC_RTC__
const char *const kinova_gen3_7_branches[16] = {
#ifdef KINOVA_GEN3_7_PLAIN
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
#else
    "elbow+-shoulder+-noflip", "elbow+-shoulder+-flip", "elbow+-shoulder--noflip",
    "elbow+-shoulder--flip", "elbow--shoulder+-noflip", "elbow--shoulder+-flip",
    "elbow--shoulder--noflip", "elbow--shoulder--flip", "further1", "further2", "further3",
    "further4", "further5", "further6", "further7", "further8",
#endif
};
#endif

DHGEN_TABLE struct dhgen_joint joints[7] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.24, 2.24, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 0.0, 0.09817477042468103, 1 },
    { -2.57, 2.57, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.09, 2.09, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[4] = {
    { { 3, 4, 5, 0, 1, 2 }, 1.0, 0 },
    { { 0, 5, 4, 3, 2, 1 }, -1.0, 0 },
    { { 4, 3, 2, 1, 0, 5 }, -1.0, 0 },
    { { 1, 2, 3, 4, 5, 0 }, 1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[8][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, 0.01584673608061403,
        0.9230769230769231, 0.38461538461538464, 0.0, -1.9205566660481306e-10 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.015846736084575715 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.0, 0.0, 0.0, -1.0, 0.017195394470453523,
        0.8823529411764706, 0.47058823529411764, 0.0, -1.1349230083595947 },
    { 0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, 0.4239642514299426, 0.96, 0.28, 0.0,
        -0.01719539447475237 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0004720304364438222,
        0.7241379310344828, 0.6896551724137931, 0.0, -0.4239642515359337 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.9459459459459459,
        0.32432432432432434, 0.0, -0.0004720304365618298 },
    { 0.6, -0.8, 0.0, -0.0, -0.8, -0.6, 0.0, -0.0, 0.0, 0.0, -1.0, 0.2848099999287975 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, 0.10593 },
};

/* The joints whose values are given, and where they are in the links. */
DHGEN_TABLE dhgen_given_joint given[1] = {
    { 0, 1.0, 3.141592653589793, 0 },
};

DHGEN_TABLE dhgen_given_motion motions[1] = {
    { 0, 1.0 },
};

/* Their values at which formulations vanish. */
DHGEN_TABLE dhgen_special_value special[2] = {
    { 0, 1, 1.0, 1e-12, 0x3 },
    { 0, 1, -1.0, 1e-12, 0x3 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.3707388051002349, 2.6973167800161484, /* the length that is one in the loop, and its inverse
        */
    4.062224539232323, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    4, formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 1 }, { 3, 1, 0 }, { 4, 1, 0 }, { 5, 1, 0 }, { 6, 1, 0 }, { 7, 1, 0 } },
        /* links */
    constants,
    motions,
    1, 2,
    given, special, 0,
};


/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[6] = { 0, 1, 3, 4, 5, 6 };
DHGEN_TABLE int turning[6] = { 1, 1, 1, 1, 1, 1 };
DHGEN_TABLE double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[6] = {
    0.8690286866369458, 0.8690286866369458, 0.8690286866369458, 0.8690286866369458,
    0.8690286866369458, 0.8690286866369458,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[6] = {
    -3.141592653589793, -2.24, -2.57, -3.141592653589793, -2.09, -3.141592653589793,
};
DHGEN_TABLE double span_width[6] = {
    6.283185307179586, 4.48, 5.14, 6.283185307179586, 4.18, 6.283185307179586,
};
DHGEN_TABLE double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
DHGEN_TABLE double least_u[6] = { -HUGE_VAL, -2.24, -2.57, -HUGE_VAL, -2.09, -HUGE_VAL };
DHGEN_TABLE double most_u[6] = { HUGE_VAL, 2.24, 2.57, HUGE_VAL, 2.09, HUGE_VAL };
/* How the loop counts the joints: which way, and from where. */
DHGEN_TABLE double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double zero[6] = {
    0.0, 3.141592653589793, 3.141592653589793, 3.141592653589793, 3.141592653589793,
    3.141592653589793,
};
DHGEN_TABLE int given_places[1] = { 2 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    7, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.1507100000000001, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero, 1, given_places,
    kinova_gen3_7_fk, kinova_gen3_7_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[7][4] = {
    { 0.0, -0.28481, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.01175, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.42076, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.01275, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.31436, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.00035, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.10593, 0.0, 0.0 },
};
DHGEN_TABLE double base[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 };
DHGEN_TABLE struct dhgen_links links = { 7, DHGEN_STANDARD, joints, &table[0][0], NULL, base, NULL
    };
#define DHGEN_FRAMES 9

DHGEN_PUBLIC void kinova_gen3_7_fk(const double q[7], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, v2 = s1 * c2, z2_x = c1 * s2,
        v3 = s1 * s2, v4 = q[2] + offset3;
    const double c3 = cos(v4), s3 = sin(v4), x3_x = x2_x * c3 + s1 * s3, x3_y = c1 * s3 - v2 * c3,
        v5 = s2 * c3, v6 = c1 * c3 + v2 * s3, v7 = s2 * s3, z3_x = x2_x * s3 - s1 * c3,
        v8 = q[3] + offset4;
    const double c4 = cos(v8), s4 = sin(v8), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 - v3 * s4, x4_z = c2 * s4 - v5 * c4, z4_y = v3 * c4 + x3_y * s4,
        v9 = c2 * c4 + v5 * s4, z4_x = x3_x * s4 - z2_x * c4, v10 = q[4] + offset5;
    const double c5 = cos(v10), s5 = sin(v10), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 - v6 * s5, x5_z = x4_z * c5 - v7 * s5, z5_y = v6 * c5 + x4_y * s5,
        z5_z = v7 * c5 + x4_z * s5, z5_x = x4_x * s5 - z3_x * c5, v11 = q[5] + offset6;
    const double c6 = cos(v11), s6 = sin(v11), x6_x = x5_x * c6 + z4_x * s6,
        x6_y = x5_y * c6 + z4_y * s6, x6_z = x5_z * c6 - v9 * s6, z6_z = v9 * c6 + x5_z * s6,
        z6_x = x5_x * s6 - z4_x * c6, z6_y = x5_y * s6 - z4_y * c6, v12 = q[6] + offset7;
    const double c7 = cos(v12), s7 = sin(v12);
    T[0] = x6_x * c7 + z5_x * s7; T[1] = z5_x * c7 - x6_x * s7; T[2] = z6_x;
    T[3] = -(s1 * d2 + z2_x * d3 + z3_x * d4 + z4_x * d5 + z5_x * d6 + z6_x * d7);
    T[4] = x6_y * c7 + z5_y * s7; T[5] = z5_y * c7 - x6_y * s7; T[6] = z6_y;
    T[7] = v3 * d3 - c1 * d2 + v6 * d4 - z4_y * d5 - z5_y * d6 - z6_y * d7;
    T[8] = x6_z * c7 + z5_z * s7; T[9] = z5_z * c7 - x6_z * s7; T[10] = z6_z;
    T[11] = d1 - c2 * d3 + v7 * d4 + v9 * d5 - z5_z * d6 - z6_z * d7;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void kinova_gen3_7_jacobian(const double q[7], double J[42])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, v2 = s1 * c2, z2_x = c1 * s2,
        v3 = s1 * s2, v4 = s1 * d2, v5 = c1 * d2, v6 = q[2] + offset3;
    const double c3 = cos(v6), s3 = sin(v6), x3_x = x2_x * c3 + s1 * s3, x3_y = c1 * s3 - v2 * c3,
        v7 = s2 * c3, v8 = c1 * c3 + v2 * s3, v9 = s2 * s3, v10 = v4 + z2_x * d3,
        p3_y = v3 * d3 - v5, p3_z = d1 - c2 * d3, z3_x = x2_x * s3 - s1 * c3, v11 = q[3] + offset4;
    const double c4 = cos(v11), s4 = sin(v11), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 - v3 * s4, x4_z = c2 * s4 - v7 * c4, z4_y = v3 * c4 + x3_y * s4,
        v12 = c2 * c4 + v7 * s4, v13 = v10 + z3_x * d4, p4_y = p3_y + v8 * d4,
        p4_z = p3_z + v9 * d4, z4_x = x3_x * s4 - z2_x * c4, v14 = q[4] + offset5;
    const double c5 = cos(v14), s5 = sin(v14), z5_y = v8 * c5 + x4_y * s5,
        z5_z = v9 * c5 + x4_z * s5, v15 = v13 + z4_x * d5, p5_y = p4_y - z4_y * d5,
        p5_z = p4_z + v12 * d5, z5_x = x4_x * s5 - z3_x * c5, v16 = q[5] + offset6;
    const double c6 = cos(v16), s6 = sin(v16), z6_z = v12 * c6 + (x4_z * c5 - v9 * s5) * s6,
        v17 = v15 + z5_x * d6, p6_y = p5_y - z5_y * d6, p6_z = p5_z - z5_z * d6,
        z6_x = (x4_x * c5 + z3_x * s5) * s6 - z4_x * c6,
        z6_y = (x4_y * c5 - v8 * s5) * s6 - z4_y * c6, J21 = v17 + z6_x * d7,
        p7_y = p6_y - z6_y * d7, p7_z = p6_z - z6_z * d7, v18 = p7_z - d1, v19 = v4 - J21,
        v20 = v5 + p7_y, v21 = v10 - J21, v22 = p7_y - p3_y, v23 = p7_z - p3_z, v24 = v13 - J21,
        v25 = p7_y - p4_y, v26 = p7_z - p4_z, v27 = v15 - J21, v28 = p7_y - p5_y, v29 = p7_z - p5_z,
        v30 = v17 - J21, v31 = p7_y - p6_y, v32 = p7_z - p6_z;
    J[0] = p7_y; J[1] = c1 * v18; J[2] = -(v3 * v18 + c2 * v20); J[3] = v9 * v22 - v8 * v23;
    J[4] = z4_y * v26 + v12 * v25; J[5] = z5_y * v29 - z5_z * v28; J[6] = z6_y * v32 - z6_z * v31;
    J[7] = J21; J[8] = -(s1 * v18); J[9] = c2 * v19 - z2_x * v18; J[10] = -(v9 * v21 + z3_x * v23);
    J[11] = -(v12 * v24 + z4_x * v26); J[12] = z5_z * v27 - z5_x * v29;
    J[13] = z6_z * v30 - z6_x * v32;
    J[14] = 0.0; J[15] = s1 * p7_y + c1 * J21; J[16] = z2_x * v20 + v3 * v19;
    J[17] = z3_x * v22 + v8 * v21; J[18] = z4_x * v25 - z4_y * v24; J[19] = z5_x * v28 - z5_y * v27;
    J[20] = z6_x * v31 - z6_y * v30;
    J[21] = 0.0; J[22] = s1; J[23] = z2_x; J[24] = z3_x; J[25] = z4_x; J[26] = z5_x; J[27] = z6_x;
    J[28] = 0.0; J[29] = c1; J[30] = -v3; J[31] = -v8; J[32] = z4_y; J[33] = z5_y; J[34] = z6_y;
    J[35] = -1.0; J[36] = 0.0; J[37] = c2; J[38] = -v9; J[39] = -v12; J[40] = z5_z; J[41] = z6_z;
}

#ifndef KINOVA_GEN3_7_PLAIN
/* The nearest arm with a structure: what follows is its closed form. A pose at which one of its
 * branches may end by what the two arms differ is left to the general algorithm. */
/* In formulas below, near_arm_size2 = 0.5770225443999999 [m^2],
 * near_doubt_limit = 9.999999999999999e-05. */
static const double
    near_offset3 = 3.141592653589793, /* offset of joint 3 [rad] */
    near_d2 = -0.01175, /* joint offset 2 [m] */
    near_d5 = -0.31436, /* joint offset 5 [m] */
    near_d3 = -0.42076, /* joint offset 3 [m] */
    /* square of a length that fixes no angle [m^4] */
    near_doubt_limit_squared4 = 3.329550167458499e-09,
    near_d4 = -0.01275, /* joint offset 4 [m] */
    /* nearer to that boundary two branches are one [m^2] */
    near_merge_slack2 = 5.770225443999999e-15,
    /* square of a length that fixes no angle [m^2] */
    near_doubt_limit_squared2 = 5.770225443999999e-09,
    /* the same where they follow an angle that is good to few digits [m] */
    near_blur_slack1 = 7.596199999999999e-12,
    near_k1 = 0.2645402272, /* 2 * near_d5 * near_d3 [m^2] */
    near_k2 = 0.06998153180702761, /* near_k1^2 [m^4] */
    near_k3 = 0.000299625, /* 2 * near_d4 * near_d2 [m^2] */
    near_k4 = 0.2761618122, /* near_d2^2 + (near_d3^2 + (near_d4^2 + near_d5^2)) [m^2] */
    near_k5 = 1.7330345403398768, /* 1 / near_arm_size2 [m^-2] */
    near_m1 = 5.7702254439999985e-12, /* 1000 * near_merge_slack2 [m^2] */
    near_m2 = 0.2645402272, /* near_k1 [m^2] */
    near_m3 = 7.596199999999998e-11, /* 10 * near_blur_slack1 [m] */
    near_m4 = 3.3295501674584984e-17, /* near_doubt_limit_squared2^2 [m^4] */
    near_m5 = 9.999999999999999e-09, /* near_doubt_limit^2 */
    near1 = 0.5; /* 1 / 2 */

/* What one pose and many compute alike: values without signs of branches, with the first, with
 * all that are in lanes. */
#define KNOWN(number) \
    const dhgen_##number v1 = near_offset3 + free_joints[0], c3 = dhgen_cos_##number(v1), \
        s3 = dhgen_sin_##number(v1); \
    /* theta4 */ \
    const dhgen_##number X4 = near_d5 * (near_d2 * s3) * 2.0, N4 = near_k2 + X4 * X4, \
        v2 = T14 * T14, v3 = T24 * T24, Z4 = near_k3 * c3 + (v2 + (v3 + (T34 * T34 - near_k4))), \
        D4_squared = N4 - Z4 * Z4, w4 = dhgen_sqrt_##number(D4_squared), \
        inverse4 = DHGEN_QUOTIENT(1.0, N4), v4 = X4 * Z4, v5 = inverse4 * v4, \
        v7 = inverse4 * (near_k1 * Z4); \
    /* theta1 */ \
    const dhgen_##number N1 = v2 + v3, v10 = near_d5 * s3, v11 = near_d4 * c3 - near_d2, \
        v12 = near_k5 * w4, inverse1 = DHGEN_QUOTIENT(1.0, N1); \
    /* theta2 */ \
    const dhgen_##number v24 = near_d5 * c3, v25 = near_d4 * s3, \
        v27 = v25 + inverse4 * (v4 * v24), v28 = T34 * v27; \
    /* theta5 */ \
    const dhgen_##number v38 = c3 * T13, v40 = c3 * T23, v45 = c3 * T33, \
        v47 = T24 * T13 - T14 * T23, v56 = s3 * T33; \
    /* theta7 */ \
    const dhgen_##number v66 = s3 * T32, v68 = c3 * T12, v70 = c3 * T22, v75 = c3 * T32, \
        v77 = s3 * T31, v79 = c3 * T11, v81 = c3 * T21, v86 = c3 * T31; \
    /* joint values */ \
    const dhgen_##number v88 = free_joints[0] + (w4 - w4), v89 = dhgen_abs_##number(Z4), \
        v90 = near_merge_slack2 + 2.0 * v89; \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v91 = T14 * free_joints[2], v92 = dhgen_abs_##number(T14), \
        v93 = dhgen_abs_##number(free_joints[2]), v94 = v91 + v91, v95 = v93 * v93, \
        v96 = T24 * free_joints[2], v97 = dhgen_abs_##number(T24), v98 = v96 + v96, \
        v99 = T34 * free_joints[2], v100 = dhgen_abs_##number(T34), v101 = v99 + v99, \
        v102 = v95 + v95, v103 = v95 + v102, v104 = Z4 * v94, v105 = Z4 * v98, v106 = Z4 * v101, \
        v107 = v89 * v103, v108 = v94 * v94 + v98 * v98, \
        v109 = v103 + dhgen_sqrt_##number(v108 + v101 * v101), v110 = v104 + v104, \
        v111 = v105 + v105, v112 = v106 + v106, v113 = v107 + v107 + v109 * v109, \
        v114 = v113 + dhgen_sqrt_##number(v110 * v110 + v111 * v111 + v112 * v112), \
        v115 = X4 * v94, v116 = X4 * v98, v117 = X4 * v101, v118 = v103 * dhgen_abs_##number(X4), \
        v119 = inverse4 * v115, v120 = inverse4 * v116, v121 = inverse4 * v117, \
        v122 = dhgen_abs_##number(inverse4), v123 = v118 * v122, v124 = DHGEN_QUOTIENT(near1, w4), \
        v125 = v110 * v124, v126 = v111 * v124, v127 = v112 * v124, v128 = v114 * v124, \
        v129 = DHGEN_QUOTIENT(v128 * v128, w4), \
        v130 = v129 + (v129 + v113 * dhgen_abs_##number(v124)), \
        v131 = v130 + dhgen_sqrt_##number(v125 * v125 + v126 * v126 + v127 * v127), \
        v139 = dhgen_abs_##number(v10), v152 = dhgen_abs_##number(v24), \
        v153 = inverse4 * (v24 * v115), v154 = inverse4 * (v24 * v116), \
        v155 = inverse4 * (v24 * v117), v156 = v122 * (v118 * v152), v157 = T34 * v153, \
        v158 = T34 * v154, v159 = T34 * v155 + v27 * free_joints[2], \
        v160 = v100 * v156 + v93 * (v156 + dhgen_sqrt_##number(v153 * v153 + v154 * v154 + v155 * \
            v155)), v172 = inverse4 * (near_k1 * v94), v173 = inverse4 * (near_k1 * v98), \
        v174 = inverse4 * (near_k1 * v101), v175 = v122 * (near_k1 * v103), \
        v244 = dhgen_abs_##number(inverse1), v245 = inverse1 * (inverse1 * v94), \
        v246 = inverse1 * (inverse1 * v98), v247 = v244 * (v102 * v244), \
        v248 = dhgen_sqrt_##number(N1) - dhgen_sqrt_##number(v102), \
        v249 = v247 + (v247 + (dhgen_abs_##number(v245) + dhgen_abs_##number(v246))) * \
            DHGEN_QUOTIENT(v102 + dhgen_sqrt_##number(v108), v248 * v248), \
        v258 = v249 + dhgen_sqrt_##number(v245 * v245 + v246 * v246), v266 = v93 * v258, \
        v267 = v266 + v92 * v249, v275 = T33 * free_joints[1], v276 = T23 * free_joints[1], \
        v277 = near1 * (free_joints[1] * free_joints[1]), v284 = dhgen_abs_##number(T13), \
        v285 = v275 * v275, v286 = v276 * v276, v287 = v277 + dhgen_sqrt_##number(v285 + v286), \
        v296 = v266 + v97 * v249, v314 = T13 * free_joints[1], v319 = dhgen_abs_##number(T23), \
        v320 = v314 * v314, v321 = v277 + dhgen_sqrt_##number(v285 + v320), v328 = c3 * v276, \
        v329 = c3 * v314, v330 = dhgen_abs_##number(c3), v331 = v277 * v330, \
        v332 = v277 + dhgen_sqrt_##number(v286 + v320), v340 = dhgen_abs_##number(v45), \
        v341 = v328 * v328, v342 = v329 * v329, v343 = v331 + dhgen_sqrt_##number(v341 + v342), \
        v354 = dhgen_abs_##number(T33), v356 = c3 * v275, v361 = dhgen_abs_##number(v38), \
        v362 = v356 * v356, v363 = v331 + dhgen_sqrt_##number(v341 + v362), \
        v371 = dhgen_abs_##number(v40), v372 = v331 + dhgen_sqrt_##number(v342 + v362), \
        v392 = T24 * v275, v393 = T13 * free_joints[2], v394 = T14 * v275, \
        v395 = T23 * free_joints[2], v396 = T24 * v276 + T14 * v314, \
        v402 = dhgen_abs_##number(s3), \
        v403 = v402 * (v97 * v277 + v93 * v287 + (v92 * v277 + v93 * v321)), v407 = v244 * v403, \
        v453 = s3 * v276, v454 = s3 * v314, v455 = v277 * v402, v456 = dhgen_abs_##number(v56), \
        v458 = v455 + dhgen_sqrt_##number(v453 * v453 + v454 * v454)
#define SIGNED(number, signs) \
    /* theta4 */ \
    const dhgen_##number v6 = near_m2 * (e4 * inverse4), s4 = v5 - w4 * v6, \
        v8 = inverse4 * (e4 * X4), v9 = v7 + w4 * v8; \
    /* theta1 */ \
    const dhgen_##number Z1 = v11 - s4 * v10, D1_squared = N1 - Z1 * Z1, \
        w1 = dhgen_sqrt_##number(D1_squared), v13 = w1 - w1, v14 = dhgen_abs_##number(Z1), \
        v15 = near_blur_slack1 + 2.0 * v14, v16 = T14 * Z1, v17 = T24 * Z1, v20 = inverse1 * v17, \
        v23 = inverse1 * v16; \
    /* theta2 */ \
    const dhgen_##number v26 = near_d3 + near_d5 * v9, \
        v29 = near_m2 * (inverse4 * (v24 * (e4 * T34))), v30 = v28 - w4 * v29, v31 = w1 * v26, \
        v32 = T34 * v26, v33 = v25 + s4 * v24, v34 = w1 * v33; \
    /* theta5 */ \
    const dhgen_##number v39 = v9 * v38, v41 = v9 * v40, v42 = s4 * T33, v43 = s4 * T13, \
        v44 = s4 * T23, v46 = v9 * v45, v50 = s3 * (v16 * T13 + v17 * T23), v51 = inverse1 * v50; \
    /* theta6 */ \
    const dhgen_##number v60 = s4 * v38, v61 = s4 * v40, v62 = v9 * T33, v63 = v9 * T13, \
        v64 = v9 * T23, v65 = s4 * v45; \
    /* theta7 */ \
    const dhgen_##number v69 = v9 * v68, v71 = v9 * v70, v72 = s4 * T32, v73 = s4 * T12, \
        v74 = s4 * T22, v76 = v9 * v75, v80 = v9 * v79, v82 = v9 * v81, v83 = s4 * T31, \
        v84 = s4 * T11, v85 = s4 * T21, v87 = v9 * v86; \
    /* joint values */ \
    const dhgen_##number q3_p = v13 + v88; \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v132 = v119 + v6 * v125, v133 = v120 + v6 * v126, \
        v134 = v121 + v6 * v127, v135 = v123 + v130 * dhgen_abs_##number(v6), v136 = v10 * v132, \
        v137 = v10 * v133, v138 = v10 * v134, v140 = v135 * v139, \
        v141 = v135 + dhgen_sqrt_##number(v132 * v132 + v133 * v133 + v134 * v134), \
        v142 = Z1 * v136, v143 = Z1 * v137, v144 = Z1 * v138, v145 = v14 * v140, \
        v146 = v140 + dhgen_sqrt_##number(v136 * v136 + v137 * v137 + v138 * v138), \
        v147 = v144 + v144, v148 = v94 + (v142 + v142), v149 = v98 + (v143 + v143), \
        v150 = v102 + (v145 + v145 + v146 * v146), \
        v151 = v150 + dhgen_sqrt_##number(v148 * v148 + v149 * v149 + v147 * v147), \
        v161 = near_m2 * (inverse4 * (v24 * (e4 * free_joints[2]))), v162 = v157 + v29 * v125, \
        v163 = v158 + v29 * v126, v164 = v159 + (v29 * v127 - w4 * v161), \
        v165 = DHGEN_QUOTIENT(near1, w1), v166 = v148 * v165, v167 = v149 * v165, \
        v168 = v147 * v165, v169 = v151 * v165, v170 = DHGEN_QUOTIENT(v169 * v169, w1), \
        v171 = v170 + (v170 + v150 * dhgen_abs_##number(v165)), v176 = v172 - v8 * v125, \
        v177 = v173 - v8 * v126, v178 = v174 - v8 * v127, \
        v179 = v175 + v130 * dhgen_abs_##number(v8), v180 = near_d5 * v176, v181 = near_d5 * v177, \
        v182 = near_d5 * v178, v183 = near_d5 * v179, \
        v184 = v179 + dhgen_sqrt_##number(v176 * v176 + v177 * v177 + v178 * v178), \
        v185 = dhgen_abs_##number(w1), \
        v186 = v171 + dhgen_sqrt_##number(v166 * v166 + v167 * v167 + v168 * v168), \
        v187 = dhgen_sqrt_##number(v180 * v180 + v181 * v181 + v182 * v182) - v183, \
        v188 = w1 * v180 + v26 * v166, v189 = w1 * v181 + v26 * v167, \
        v190 = w1 * v182 + v26 * v168, \
        v194 = v160 + (v130 * dhgen_abs_##number(v29) + v131 * dhgen_abs_##number(v161)) + (v171 * \
            dhgen_abs_##number(v26) - v183 * v185 + v186 * v187), v196 = v24 * v132, \
        v197 = v24 * v133, v198 = v24 * v134, v199 = v135 * v152, v200 = w1 * v196 + v33 * v166, \
        v201 = w1 * v197 + v33 * v167, v202 = w1 * v198 + v33 * v168, v203 = T34 * v180, \
        v204 = T34 * v181, v205 = T34 * v182 + v26 * free_joints[2], \
        v209 = v185 * v199 + v171 * dhgen_abs_##number(v33) + v186 * (v199 + \
            dhgen_sqrt_##number(v196 * v196 + v197 * v197 + v198 * v198)) + (v93 * v187 - v100 * \
            v183), v250 = T24 * v136, v251 = T24 * v138, v252 = Z1 * free_joints[2], \
        v253 = v252 - T24 * v137, v254 = v93 * v146, v255 = v254 + v97 * v140, \
        v256 = inverse1 * v251, v257 = dhgen_abs_##number(v17), \
        v259 = v255 + dhgen_sqrt_##number(v250 * v250 + v253 * v253 + v251 * v251), \
        v260 = inverse1 * v250 + v17 * v245, v261 = inverse1 * v253 - v17 * v246, \
        v262 = v244 * v255 + v249 * v257 + v258 * v259, v268 = v185 * v267, v278 = s4 * v275, \
        v279 = s4 * v276, v280 = v277 * dhgen_abs_##number(s4), v281 = T13 * v132, \
        v282 = T13 * v133, v283 = T13 * v134, v288 = v280 + v135 * v284 + v141 * v287, \
        v290 = dhgen_abs_##number(v43), v292 = v278 * v278, \
        v293 = v288 + (dhgen_sqrt_##number(v292 + v279 * v279) + dhgen_sqrt_##number(v281 * v281 + \
            v282 * v282 + v283 * v283)), v297 = v185 * v296, v300 = T14 * v137, v301 = T14 * v138, \
        v302 = v252 - T14 * v136, v303 = v254 + v92 * v140, v304 = inverse1 * v301, \
        v305 = dhgen_abs_##number(v16), \
        v306 = v303 + dhgen_sqrt_##number(v302 * v302 + v300 * v300 + v301 * v301), \
        v307 = inverse1 * v300 + v16 * v246, v308 = v244 * v303 + v249 * v305 + v258 * v306, \
        v309 = v16 * v245 - inverse1 * v302, v315 = s4 * v314, v316 = T23 * v132, \
        v317 = T23 * v133, v318 = T23 * v134, v322 = v280 + v135 * v319 + v141 * v321, \
        v324 = dhgen_abs_##number(v44), \
        v326 = v322 + (dhgen_sqrt_##number(v292 + v315 * v315) + dhgen_sqrt_##number(v316 * v316 + \
            v317 * v317 + v318 * v318)), v333 = v9 * v328, v334 = v9 * v329, \
        v335 = dhgen_abs_##number(v9), v336 = v331 * v335, v337 = v45 * v176, v338 = v45 * v177, \
        v339 = v45 * v178, v344 = v336 + v179 * v340 + v184 * v343, v351 = T33 * v132, \
        v352 = T33 * v133, v353 = T33 * v134, v355 = v280 + v135 * v354 + v141 * v332, \
        v357 = v9 * v356, v358 = v38 * v176, v359 = v38 * v177, v360 = v38 * v178, \
        v364 = v336 + v179 * v361 + v184 * v363, v365 = dhgen_abs_##number(v39), \
        v366 = v357 * v357, \
        v367 = v364 + (dhgen_sqrt_##number(v366 + v333 * v333) + dhgen_sqrt_##number(v358 * v358 + \
            v359 * v359 + v360 * v360)), v368 = v40 * v176, v369 = v40 * v177, v370 = v40 * v178, \
        v373 = v336 + v179 * v371 + v184 * v372, v374 = dhgen_abs_##number(v41), \
        v375 = v373 + (dhgen_sqrt_##number(v366 + v334 * v334) + dhgen_sqrt_##number(v368 * v368 + \
            v369 * v369 + v370 * v370)), v413 = s3 * (v17 * v275), v414 = s3 * (v16 * v275), \
        v415 = s3 * (v17 * v314 - v16 * v276), v416 = s3 * (T13 * v302 - T23 * v250), \
        v417 = s3 * (T23 * v253 - T13 * v300), v418 = s3 * (T13 * v301 + T23 * v251), \
        v419 = v402 * (v277 * v305 + v284 * v303 + v287 * v306 + (v257 * v277 + v255 * v319 + v259 \
            * v321)), v420 = inverse1 * v413, v421 = inverse1 * v414, v422 = inverse1 * v415, \
        v423 = inverse1 * v418, \
        v424 = v244 * v419 + v249 * dhgen_abs_##number(v50) + v258 * (v419 + \
            (dhgen_sqrt_##number(v413 * v413 + v414 * v414 + v415 * v415) + \
            dhgen_sqrt_##number(v416 * v416 + v417 * v417 + v418 * v418))), \
        v428 = v50 * v245 - inverse1 * v416, v430 = v50 * v246 - inverse1 * v417, \
        v457 = v194 * v456
#define SIGNED_TWICE(number, signs) \
    /* theta1 */ \
    const dhgen_##number v18 = e1 * T14, v19 = inverse1 * v18, c1 = v20 + w1 * v19, \
        v21 = e1 * T24, v22 = inverse1 * v21, s1 = w1 * v22 - v23; \
    /* theta2 */ \
    const dhgen_##number S2 = v30 + e1 * v31, C2 = e1 * v34 - v32, v35 = S2 * S2 + C2 * C2, \
        v36 = dhgen_sqrt_##number(v35), v37 = DHGEN_QUOTIENT(1.0, v35), factor2 = v36 * v37; \
    /* theta5 */ \
    const dhgen_##number v48 = s3 * (e1 * v47), v49 = inverse1 * v48, v52 = w1 * v49 - v51, \
        v53 = c1 * v43 + s1 * v44 - v46, v54 = v42 + (c1 * v39 + s1 * v41), \
        v55 = S2 * v53 - C2 * v54, c5 = factor2 * v55 - v9 * v52, \
        v57 = s3 * (c1 * T13 + s1 * T23), v58 = C2 * v57 + S2 * v56, \
        Y5 = factor2 * v58 - c3 * (s1 * T13 - c1 * T23), v59 = c5 * c5 + Y5 * Y5; \
    /* theta7 */ \
    const dhgen_##number v67 = s1 * T12 - c1 * T22, v78 = s1 * T11 - c1 * T21, \
        s7 = c5 * (c3 * v78 - factor2 * (C2 * (s3 * (c1 * T11 + s1 * T21)) + S2 * v77)) + Y5 * \
            (factor2 * (S2 * (c1 * v84 + s1 * v85 - v87) - C2 * (v83 + (c1 * v80 + s1 * v82))) - \
            v9 * (s3 * v78)); \
    /* by how much these differ at poses so near: slopes and rests */ \
    const dhgen_##number v191 = v162 + e1 * v188, v192 = v163 + e1 * v189, \
        v193 = v164 + e1 * v190, \
        v195 = v194 + dhgen_sqrt_##number(v191 * v191 + v192 * v192 + v193 * v193), \
        v206 = e1 * v200 - v203, v207 = e1 * v201 - v204, v208 = e1 * v202 - v205, \
        v210 = v209 + dhgen_sqrt_##number(v206 * v206 + v207 * v207 + v208 * v208), \
        v211 = v195 * v195, v212 = v210 * v210, v213 = v211 + v212, v214 = S2 * v191, \
        v215 = S2 * v192, v216 = S2 * v193, v217 = dhgen_abs_##number(S2), v218 = v194 * v217, \
        v219 = C2 * v206, v220 = C2 * v207, v221 = C2 * v208, v222 = dhgen_abs_##number(C2), \
        v223 = v209 * v222, v224 = v214 + v214 + (v219 + v219), \
        v225 = v215 + v215 + (v220 + v220), v226 = v216 + v216 + (v221 + v221), \
        v227 = v211 + (v218 + v218) + (v212 + (v223 + v223)), v228 = DHGEN_QUOTIENT(near1, v36), \
        v229 = v224 * v228, v230 = v225 * v228, v231 = v226 * v228, \
        v232 = v227 * dhgen_abs_##number(v228), v233 = dhgen_abs_##number(v37), \
        v234 = v37 * (v37 * v224), v235 = v37 * (v37 * v225), v236 = v37 * (v37 * v226), \
        v237 = v233 * (v227 * v233), v238 = v36 - dhgen_sqrt_##number(v213), \
        v239 = v237 + (v237 + (dhgen_abs_##number(v236) + (dhgen_abs_##number(v234) + \
            dhgen_abs_##number(v235)))) * DHGEN_QUOTIENT(v227 + dhgen_sqrt_##number(v224 * v224 + \
            v225 * v225 + v226 * v226), v238 * v238), v240 = v37 * v229 - v36 * v234, \
        v241 = v37 * v230 - v36 * v235, v242 = v37 * v231 - v36 * v236, \
        v243 = v239 * dhgen_abs_##number(v36) + v232 * v233 + (v232 + dhgen_sqrt_##number(v229 * \
            v229 + v230 * v230 + v231 * v231)) * (v239 + dhgen_sqrt_##number(v234 * v234 + v235 * \
            v235 + v236 * v236)), v263 = inverse1 * (e1 * free_joints[2]), v264 = v18 * v246, \
        v265 = v263 - v18 * v245, v269 = dhgen_abs_##number(v19), \
        v270 = v267 + dhgen_sqrt_##number(v265 * v265 + v264 * v264), \
        v271 = w1 * v265 + v19 * v166 - v260, v272 = v261 + (v19 * v167 - w1 * v264), \
        v273 = v19 * v168 - v256, v274 = v262 + (v268 + v171 * v269 + v186 * v270), \
        v289 = dhgen_abs_##number(c1), \
        v291 = v274 + dhgen_sqrt_##number(v271 * v271 + v272 * v272 + v273 * v273), \
        v294 = v21 * v245, v295 = v263 - v21 * v246, v298 = dhgen_abs_##number(v22), \
        v299 = v296 + dhgen_sqrt_##number(v294 * v294 + v295 * v295), \
        v310 = v309 + (v22 * v166 - w1 * v294), v311 = v307 + (w1 * v295 + v22 * v167), \
        v312 = v304 + v22 * v168, v313 = v308 + (v297 + v171 * v298 + v186 * v299), \
        v323 = dhgen_abs_##number(s1), \
        v325 = v313 + dhgen_sqrt_##number(v310 * v310 + v311 * v311 + v312 * v312), \
        v327 = s1 * v315 - c1 * v279, v345 = v333 + s1 * v278, v346 = v334 + c1 * v278, \
        v347 = c1 * v281 + v43 * v271 + (s1 * v316 + v44 * v310) - v337, \
        v348 = c1 * v282 + v43 * v272 + (s1 * v317 + v44 * v311) - v338, \
        v349 = c1 * v283 + v43 * v273 + (s1 * v318 + v44 * v312) - v339, \
        v350 = v344 + (v288 * v289 + v274 * v290 + v291 * v293 + (v322 * v323 + v313 * v324 + v325 \
            * v326)), v376 = s1 * v334 - c1 * v333, v377 = v279 - s1 * v357, \
        v378 = c1 * v357 - v315, \
        v379 = v351 + (c1 * v358 + v39 * v271 + (s1 * v368 + v41 * v310)), \
        v380 = v352 + (c1 * v359 + v39 * v272 + (s1 * v369 + v41 * v311)), \
        v381 = v353 + (c1 * v360 + v39 * v273 + (s1 * v370 + v41 * v312)), \
        v382 = v355 + (v289 * v364 + v274 * v365 + v291 * v367 + (v323 * v373 + v313 * v374 + v325 \
            * v375)), v383 = S2 * v345 + C2 * v377, v384 = S2 * v346 - C2 * v378, \
        v385 = S2 * v327 - C2 * v376, v386 = S2 * v347 + v53 * v191 - (C2 * v379 + v54 * v206), \
        v387 = S2 * v348 + v53 * v192 - (C2 * v380 + v54 * v207), \
        v388 = S2 * v349 + v53 * v193 - (C2 * v381 + v54 * v208), \
        v389 = v217 * v350 + v194 * dhgen_abs_##number(v53) + v195 * (v350 + \
            (dhgen_sqrt_##number(v345 * v345 + v346 * v346 + v327 * v327) + \
            dhgen_sqrt_##number(v347 * v347 + v348 * v348 + v349 * v349))) + (v222 * v382 + v209 * \
            dhgen_abs_##number(v54) + v210 * (v382 + (dhgen_sqrt_##number(v377 * v377 + v378 * \
            v378 + v376 * v376) + dhgen_sqrt_##number(v379 * v379 + v380 * v380 + v381 * v381)))), \
        v390 = dhgen_abs_##number(factor2), \
        v391 = v243 + dhgen_sqrt_##number(v240 * v240 + v241 * v241 + v242 * v242), \
        v397 = s3 * (e1 * v394), v398 = s3 * (e1 * v392), v399 = s3 * (e1 * v396), \
        v400 = s3 * (e1 * v395), v401 = s3 * (e1 * v393), v404 = inverse1 * v397, \
        v405 = inverse1 * v398, v406 = inverse1 * v399, v408 = inverse1 * v400 + v48 * v245, \
        v409 = inverse1 * v401 - v48 * v246, \
        v410 = v407 + v249 * dhgen_abs_##number(v48) + v258 * (v403 + (dhgen_sqrt_##number(v397 * \
            v397 + v398 * v398 + v399 * v399) + dhgen_sqrt_##number(v400 * v400 + v401 * v401))), \
        v411 = dhgen_abs_##number(v49), \
        v412 = v410 + (dhgen_sqrt_##number(v404 * v404 + v405 * v405 + v406 * v406) + \
            dhgen_sqrt_##number(v408 * v408 + v409 * v409)), v425 = v420 + w1 * v404, \
        v426 = w1 * v405 - v421, v427 = v422 + w1 * v406, v429 = v428 + (v49 * v166 - w1 * v408), \
        v431 = v430 + (w1 * v409 + v49 * v167), v432 = v423 + v49 * v168, \
        v433 = v424 + (v185 * v410 + v171 * v411 + v186 * v412), \
        v434 = factor2 * v383 + v9 * v425, v435 = factor2 * v384 - v9 * v426, \
        v436 = factor2 * v385 + v9 * v427, \
        v437 = factor2 * v386 + v55 * v240 - (v9 * v429 + v52 * v176), \
        v438 = factor2 * v387 + v55 * v241 - (v9 * v431 + v52 * v177), \
        v439 = factor2 * v388 + v55 * v242 - (v9 * v432 + v52 * v178), \
        v440 = v389 * v390 + v243 * dhgen_abs_##number(v55) + v391 * (v389 + \
            (dhgen_sqrt_##number(v383 * v383 + v384 * v384 + v385 * v385) + \
            dhgen_sqrt_##number(v386 * v386 + v387 * v387 + v388 * v388))) + (v335 * v433 + v179 * \
            dhgen_abs_##number(v52) + v184 * (v433 + (dhgen_sqrt_##number(v425 * v425 + v426 * \
            v426 + v427 * v427) + dhgen_sqrt_##number(v429 * v429 + v431 * v431 + v432 * v432)))) \
            + (dhgen_sqrt_##number(v434 * v434 + v435 * v435 + v436 * v436) + \
            dhgen_sqrt_##number(v437 * v437 + v438 * v438 + v439 * v439)), v441 = c1 * v275, \
        v442 = v277 * v289, v443 = s1 * v275, v444 = v277 * v323, v445 = s3 * v443, \
        v446 = s3 * v441, v447 = s3 * (s1 * v314 - c1 * v276), \
        v448 = s3 * (T13 * v271 + T23 * v310), v449 = s3 * (T13 * v272 + T23 * v311), \
        v450 = s3 * (T13 * v273 + T23 * v312), \
        v451 = v402 * (v442 + v274 * v284 + v287 * v291 + (v444 + v313 * v319 + v321 * v325)), \
        v452 = C2 * v447, v459 = S2 * v453 - C2 * v445, v460 = C2 * v446 - S2 * v454, \
        v461 = C2 * v448 + v57 * v206 + v56 * v191, v462 = C2 * v449 + v57 * v207 + v56 * v192, \
        v463 = C2 * v450 + v57 * v208 + v56 * v193, \
        v464 = v222 * v451 + v209 * dhgen_abs_##number(v57) + v210 * (v451 + \
            (dhgen_sqrt_##number(v445 * v445 + v446 * v446 + v447 * v447) + \
            dhgen_sqrt_##number(v448 * v448 + v449 * v449 + v450 * v450))) + (v457 + v217 * v455 + \
            v195 * v458), v465 = factor2 * v459 - c3 * v441, v466 = factor2 * v460 - c3 * v443, \
        v467 = factor2 * v452 + c3 * (s1 * v276 + c1 * v314), \
        v468 = factor2 * v461 + v58 * v240 - c3 * (T13 * v310 - T23 * v271), \
        v469 = factor2 * v462 + v58 * v241 - c3 * (T13 * v311 - T23 * v272), \
        v470 = factor2 * v463 + v58 * v242 - c3 * (T13 * v312 - T23 * v273), \
        v471 = v390 * v464 + v243 * dhgen_abs_##number(v58) + v391 * (v464 + \
            (dhgen_sqrt_##number(v459 * v459 + v460 * v460 + v452 * v452) + \
            dhgen_sqrt_##number(v461 * v461 + v462 * v462 + v463 * v463))) + v330 * (v444 + v284 * \
            v313 + v287 * v325 + (v442 + v274 * v319 + v291 * v321)) + (dhgen_sqrt_##number(v465 * \
            v465 + v466 * v466 + v467 * v467) + dhgen_sqrt_##number(v468 * v468 + v469 * v469 + \
            v470 * v470))

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    DHGEN_ENTRIES(dhgen_wide);
    dhgen_wide_mask left = (dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11] + free_joints[0])
        <= DHGEN_ORTHONORMAL) == 0;
    KNOWN(wide);
    left |= (dhgen_abs_wide(N1) <= v102) | (dhgen_abs_wide(v114 + (D4_squared + D4_squared)) <=
        v114) | (dhgen_abs_wide(v90) <= 2.0 * v109) | (N1 <= near_doubt_limit_squared2) |
        (dhgen_abs_wide(D4_squared) <= near_m1 * v90) | (N4 <= near_doubt_limit_squared4);

    for (int i1 = 0; i1 < 2; i1++) { /* elbow+, elbow- */
        const double e4 = i1 == 0 ? 1.0 : -1.0;
        SIGNED(wide, double);

        /* joint values */
        const dhgen_wide angle6 = dhgen_atan2_wide(s4, -v9), q4_p = v13 + angle6;
        left |= (dhgen_abs_wide(v151 + (D1_squared + D1_squared)) <= v151) | (dhgen_abs_wide(v15) <=
            2.0 * v146) | (dhgen_abs_wide(D1_squared * v12) <= near_m3 * v15);

        for (int i2 = 0; i2 < 2; i2++) { /* shoulder+, shoulder- */
            const double e1 = i2 == 0 ? 1.0 : -1.0;
            SIGNED_TWICE(wide, double);

            /* theta1 */
            const dhgen_wide angle1 = dhgen_atan2_wide(s1, c1);

            /* theta2 */
            const dhgen_wide angle2 = dhgen_atan2_wide(S2, C2);

            /* theta5 */
            const dhgen_wide angle3 = dhgen_atan2_wide(Y5, c5);

            /* theta6 */
            const dhgen_wide angle4 = dhgen_atan2_wide(dhgen_sqrt_wide(v59), -(s4 * v52 + factor2 *
                (C2 * (c1 * v60 + s1 * v61 - v62) + S2 * (v65 + (c1 * v63 + s1 * v64)))));

            /* theta7 */
            const dhgen_wide angle5 = dhgen_atan2_wide(s7, c5 * (c3 * v67 - factor2 * (C2 * (s3 *
                (c1 * T12 + s1 * T22)) + S2 * v66)) + Y5 * (factor2 * (S2 * (c1 * v73 + s1 * v74 -
                v76) - C2 * (v72 + (c1 * v69 + s1 * v71))) - v9 * (s3 * v67)));
            const int row = 4 * i1 + 2 * i2;
            q[7 * row] = angle1; q[7 * row + 1] = angle2; q[7 * row + 2] = q3_p;
            q[7 * row + 3] = q4_p; q[7 * row + 4] = angle3; q[7 * row + 5] = angle4;
            q[7 * row + 6] = angle5;
            kind[row] = dhgen_kind_wide(q[7 * row]);
            q[7 * row + 7] = angle1; q[7 * row + 8] = angle2; q[7 * row + 9] = q3_p;
            q[7 * row + 10] = q4_p;
            q[7 * row + 11] = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, Y5);
            q[7 * row + 12] = -angle4;
            q[7 * row + 13] = angle5 - dhgen_signed_wide(DHGEN_HALF_TURN, s7);
            kind[row + 1] = dhgen_kind_wide(q[7 * row + 7]);
            left |= (dhgen_abs_wide(v59) <= v440 * v440 + v471 * v471) | (dhgen_abs_wide(v35) <=
                v213) | (v59 <= near_m5) | (v35 <= near_m4);
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
    const dhgen_four e4 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e1 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);
    KNOWN(double);
    SIGNED(four, four);
    SIGNED_TWICE(four, four);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) + 0.0 * (free_joints[0]) <= DHGEN_ORTHONORMAL)
        == 0) | ((dhgen_abs_four(v151 + (D1_squared + D1_squared)) <= v151) | (dhgen_abs_four(v15)
        <= 2.0 * v146) | (dhgen_abs_four(D1_squared * v12) <= near_m3 * v15)) |
        ((dhgen_abs_four(v59) <= v440 * v440 + v471 * v471) | (dhgen_abs_four(v35) <= v213) | (v59
        <= near_m5) | (v35 <= near_m4))) | (unsigned)((fabs(N1) <= v102) | (fabs(v114 + (D4_squared
        + D4_squared)) <= v114) | (fabs(v90) <= 2.0 * v109) | (N1 <= near_doubt_limit_squared2) |
        (fabs(D4_squared) <= near_m1 * v90) | (N4 <= near_doubt_limit_squared4)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(s4, -v9),
        ratio2 = dhgen_ratio_four(s1, c1), ratio3 = dhgen_ratio_four(S2, C2),
        ratio4 = dhgen_ratio_four(Y5, c5),
        ratio5 = dhgen_ratio_four(s7, c5 * (c3 * v67 - factor2 * (C2 * (s3 * (c1 * T12 + s1 * T22))
            + S2 * v66)) + Y5 * (factor2 * (S2 * (c1 * v73 + s1 * v74 - v76) - C2 * (v72 + (c1 * v69
            + s1 * v71))) - v9 * (s3 * v67))),
        ratio6 = dhgen_ratio_four(dhgen_sqrt_four(v59), -(s4 * v52 + factor2 * (C2 * (c1 * v60 + s1
            * v61 - v62) + S2 * (v65 + (c1 * v63 + s1 * v64)))));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle6 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2), angle1 = dhgen_angle_four(ratio2),
        angle2 = dhgen_angle_four(ratio3), angle3 = dhgen_angle_four(ratio4),
        angle5 = dhgen_angle_four(ratio5), angle4 = dhgen_angle_four(ratio6);
    const dhgen_four q5_m = angle3 - dhgen_signed_four(DHGEN_HALF_TURN, Y5),
        q7_m = angle5 - dhgen_signed_four(DHGEN_HALF_TURN, s7), q4_p = v13 + angle6;

    dhgen_store_4(q, q + 14, q + 28, q + 42, angle1, angle2, q3_p, q4_p);
    dhgen_store_4(q + 3, q + 17, q + 31, q + 45, q4_p, angle3, angle4, angle5);
    dhgen_store_4(q + 7, q + 21, q + 35, q + 49, angle1, angle2, q3_p, q4_p);
    dhgen_store_4(q + 10, q + 24, q + 38, q + 52, q4_p, q5_m, -angle4, q7_m);
    const unsigned long long none1 = (dhgen_bits_four(angle1 != angle1) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~none1);
}
#endif
#define DHGEN_REGULAR_ROWS 8
#include "dhgen/one_pose.h"

/* Its links, and its angles as factors of joint values and what is added. */
DHGEN_TABLE double nearest_links[8][12] = {
    { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 },
    { 1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0, 6.123233995736766e-17,
        0.0 },
    { 1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0, 6.123233995736766e-17,
        -0.01175 },
    { 1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0, 6.123233995736766e-17,
        -0.42076 },
    { 1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0, 6.123233995736766e-17,
        -0.01275 },
    { 1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0, 6.123233995736766e-17,
        -0.31436 },
    { 1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0, 6.123233995736766e-17,
        0.0 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 },
};
DHGEN_TABLE double nearest_angles[7][8] = {
    { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.141592653589793 },
    { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 3.141592653589793 },
    { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3.141592653589793 },
    { 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 3.141592653589793 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 3.141592653589793 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.141592653589793 },
};
DHGEN_TABLE dhgen_nearest_arm nearest_arm = {
    8, 1, /* rows; values that the caller gives */
    2e-10, 0.0005250002, /* the two arms' tools differ by no more */
    { 1.0, 0.0, 0.0, -0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 0.0, -1.0, 0.28481 },
    { 1.0, 0.0, 0.0, -0.0, -0.0, 1.0, 0.0, -0.0, 0.0, -0.0, 1.0, 0.10593 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0, 1, 3, 4, 5, 6 },
    nearest_links, nearest_angles[0],
};
#endif

#ifndef KINOVA_GEN3_7_PLAIN
DHGEN_FN int solve_certain(
    const double *T, const double *free_joints, double *q, unsigned char *status);
#endif

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    (void)moved;
#ifndef KINOVA_GEN3_7_PLAIN
    if (dhgen_solve_from_nearest(&general, &descents, &nearest_arm, solve_regular, T, free_joints,
        rows, status))
        return;
#endif
    dhgen_general_rows(&general, &descents, T, free_joints, seed, rows, status);
#ifndef KINOVA_GEN3_7_PLAIN
    dhgen_to_nearest_rows(&nearest_arm, solve_wide, free_joints, rows, status);
#endif
}

DHGEN_TABLE int given_joints[1] = { 2 };
DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    7, 16, 1, DHGEN_POSE, joints, given_joints, 1,
    { 0.869, 0.869, 0.869, 1.0, 1.0, 1.0 }, 0.8690286866369458, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, kinova_gen3_7_fk, kinova_gen3_7_jacobian, solve,
#ifdef KINOVA_GEN3_7_PLAIN
    NULL,
#else
    solve_certain,
#endif
};

#ifndef KINOVA_GEN3_7_PLAIN
/* Poses all of whose solutions lie next to the nearest arm's rows. Returns how many rows are OK, or
 * -1 if the pose has to be left to `solve`. */
DHGEN_FN int solve_certain(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    return dhgen_near_rows(&arm, &general, &descents, &nearest_arm, solve_regular, T, free_joints,
        q, status);
}
#endif

#define DHGEN_CALLER_GIVES 1
#define DHGEN_NAME(function) kinova_gen3_7_##function
#include "dhgen/functions.h"

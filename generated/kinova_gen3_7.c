/* kinova_gen3_7: Kinova Gen3 with 7 joints
 *
 * Inverse kinematics, generated from robots/kinova_gen3_7.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kinova_gen3_7.yaml. The formulas and where they come from:
 * kinova_gen3_7.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: 75d679c0087310f8
 * SPDX-License-Identifier: MIT
 */
#include "kinova_gen3_7.h"

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

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
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

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const kinova_gen3_7_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};

static const struct dhgen_joint joints[7] = {
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
static const int solved[6] = { 0, 1, 3, 4, 5, 6 };
static const int turning[6] = { 1, 1, 1, 1, 1, 1 };
static const double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double measure[6] = {
    0.8690286866369458, 0.8690286866369458, 0.8690286866369458, 0.8690286866369458,
    0.8690286866369458, 0.8690286866369458,
};
/* Rows of the translation that count. */
static const int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
static const double span_low[6] = {
    -3.141592653589793, -2.24, -2.57, -3.141592653589793, -2.09, -3.141592653589793,
};
static const double span_width[6] = {
    6.283185307179586, 4.48, 5.14, 6.283185307179586, 4.18, 6.283185307179586,
};
static const double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
static const double least_u[6] = { -HUGE_VAL, -2.24, -2.57, -HUGE_VAL, -2.09, -HUGE_VAL };
static const double most_u[6] = { HUGE_VAL, 2.24, 2.57, HUGE_VAL, 2.09, HUGE_VAL };
/* How the loop counts the joints: which way, and from where. */
static const double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
static const double zero[6] = {
    0.0, 3.141592653589793, 3.141592653589793, 3.141592653589793, 3.141592653589793,
    3.141592653589793,
};
static const int given_places[1] = { 2 };

static const struct dhgen_numerical_arm descents = {
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
static const double table[7][4] = {
    { 0.0, -0.28481, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.01175, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.42076, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.01275, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.31436, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.00035, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.10593, 0.0, 0.0 },
};

void kinova_gen3_7_frames(const double q[7], double frames[9][16])
{
    static const double base[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 };
    static const struct dhgen_links links = { 7, DHGEN_STANDARD, joints, &table[0][0], NULL, base,
        NULL };
    dhgen_frames(&links, q, frames);
}

void kinova_gen3_7_fk(const double q[7], double T[16])
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
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void kinova_gen3_7_jacobian(const double q[7], double J[42])
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
    near_angle = 1e-10, /* the two arms' tools are turned by no more */
    near_length = 0.0003500001, /* and no farther apart [m] */
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
        D4 = N4 - Z4 * Z4, w4 = dhgen_sqrt_##number(D4), inverse4 = 1.0 / N4, v4 = X4 * Z4, \
        v5 = inverse4 * v4, v7 = inverse4 * (near_k1 * Z4); \
    /* theta1 */ \
    const dhgen_##number N1 = v2 + v3, v10 = near_d5 * s3, v11 = near_d4 * c3 - near_d2, \
        v12 = near_k5 * w4, inverse1 = 1.0 / N1; \
    /* theta2 */ \
    const dhgen_##number v23 = near_d5 * c3, v24 = near_d4 * s3, \
        v26 = v24 + inverse4 * (v4 * v23), v27 = T34 * v26; \
    /* theta5 */ \
    const dhgen_##number v37 = c3 * T13, v39 = c3 * T23, v44 = c3 * T33, \
        v46 = T24 * T13 - T14 * T23, v55 = s3 * T33; \
    /* theta7 */ \
    const dhgen_##number v65 = s3 * T32, v67 = c3 * T12, v69 = c3 * T22, v74 = c3 * T32, \
        v76 = s3 * T31, v78 = c3 * T11, v80 = c3 * T21, v85 = c3 * T31; \
    /* joint values */ \
    const dhgen_##number v87 = free_joints[0] + (w4 - w4), v88 = dhgen_abs_##number(D4), \
        v89 = 2.0 * dhgen_abs_##number(Z4), v90 = near_merge_slack2 + v89, \
        v91 = dhgen_abs_##number(T14), v92 = near_length * (near_length + 2.0 * v91), \
        v93 = dhgen_abs_##number(T24), v94 = near_length * (near_length + 2.0 * v93), \
        v95 = v92 + v94, v96 = dhgen_abs_##number(T34), \
        v97 = v92 + (v94 + near_length * (near_length + 2.0 * v96)), \
        v98 = v97 * dhgen_abs_##number(X4), v99 = dhgen_abs_##number(v23), \
        v100 = dhgen_abs_##number(inverse4), v101 = v100 * (v98 * v99), \
        v102 = v96 * v101 + near_length * (v101 + dhgen_abs_##number(v26)), \
        v103 = v97 * (v89 + v97), v104 = v103 / D4, v105 = v104 * (1.0 + v104) * (near1 * w4), \
        v107 = dhgen_abs_##number(w4), v109 = v98 * v100, v111 = dhgen_abs_##number(v10), \
        v116 = v100 * (near_k1 * v97), v132 = dhgen_abs_##number(N1), \
        v137 = dhgen_abs_##number(inverse1), v138 = v95 * v137 / (v132 - v95), \
        v149 = near_angle + dhgen_abs_##number(T13), v159 = near_angle + dhgen_abs_##number(T23), \
        v163 = dhgen_abs_##number(c3), v164 = near_angle * v163, \
        v166 = v164 + dhgen_abs_##number(v44), v169 = near_angle + dhgen_abs_##number(T33), \
        v171 = v164 + dhgen_abs_##number(v37), v174 = v164 + dhgen_abs_##number(v39), \
        v180 = near_angle * v93 + near_length * v149 + (near_angle * v91 + near_length * v159), \
        v181 = dhgen_abs_##number(s3), v192 = near_angle * v181, \
        v193 = v192 + dhgen_abs_##number(v55)
#define SIGNED(number, signs) \
    /* theta4 */ \
    const dhgen_##number v6 = near_m2 * (e4 * inverse4), s4 = v5 - w4 * v6, \
        v8 = inverse4 * (e4 * X4), v9 = v7 + w4 * v8; \
    /* theta1 */ \
    const dhgen_##number Z1 = v11 - s4 * v10, D1 = N1 - Z1 * Z1, w1 = dhgen_sqrt_##number(D1), \
        v13 = w1 - w1, v14 = dhgen_abs_##number(Z1), v15 = 2.0 * v14, \
        v16 = near_blur_slack1 + v15, v17 = T14 * Z1, v18 = T24 * Z1, v20 = inverse1 * v18, \
        v22 = inverse1 * v17; \
    /* theta2 */ \
    const dhgen_##number v25 = near_d3 + near_d5 * v9, \
        v28 = near_m2 * (inverse4 * (v23 * (e4 * T34))), v29 = v27 - w4 * v28, v30 = w1 * v25, \
        v31 = T34 * v25, v32 = v24 + s4 * v23, v33 = w1 * v32; \
    /* theta5 */ \
    const dhgen_##number v38 = v9 * v37, v40 = v9 * v39, v41 = s4 * T33, v42 = s4 * T13, \
        v43 = s4 * T23, v45 = v9 * v44, v49 = s3 * (v17 * T13 + v18 * T23), v50 = inverse1 * v49; \
    /* theta6 */ \
    const dhgen_##number v59 = s4 * v37, v60 = s4 * v39, v61 = v9 * T33, v62 = v9 * T13, \
        v63 = v9 * T23, v64 = s4 * v44; \
    /* theta7 */ \
    const dhgen_##number v68 = v9 * v67, v70 = v9 * v69, v71 = s4 * T32, v72 = s4 * T12, \
        v73 = s4 * T22, v75 = v9 * v74, v79 = v9 * v78, v81 = v9 * v80, v82 = s4 * T31, \
        v83 = s4 * T11, v84 = s4 * T21, v86 = v9 * v85; \
    /* joint values */ \
    const dhgen_##number q3_p = v13 + v87, v110 = v109 + v105 * dhgen_abs_##number(v6), \
        v112 = v110 * v111, v113 = v95 + v112 * (v15 + v112), v114 = v113 / D1, \
        v115 = v114 * (1.0 + v114) * (near1 * w1), v117 = v116 + v105 * dhgen_abs_##number(v8), \
        v118 = dhgen_abs_##number(v9), v119 = near_d5 * v117, v120 = dhgen_abs_##number(w1), \
        v121 = dhgen_abs_##number(v25) - v119, v122 = v115 * v121 - v119 * v120, \
        v126 = v99 * v110, v127 = v120 * v126 + v115 * (v126 + dhgen_abs_##number(v32)), \
        v128 = near_length * v121 - v96 * v119, v139 = near_length * (v14 + v112), \
        v140 = v139 + v93 * v112, v141 = dhgen_abs_##number(v18), \
        v142 = v137 * v140 + v138 * (v140 + v141), v148 = near_angle * dhgen_abs_##number(s4), \
        v150 = v148 + v110 * v149, v152 = v150 + dhgen_abs_##number(v42), \
        v155 = v139 + v91 * v112, v156 = dhgen_abs_##number(v17), \
        v157 = v137 * v155 + v138 * (v155 + v156), v160 = v148 + v110 * v159, \
        v162 = v160 + dhgen_abs_##number(v43), v165 = v118 * v164, v167 = v165 + v117 * v166, \
        v170 = v148 + v110 * v169, v172 = v165 + v117 * v171, \
        v173 = v172 + dhgen_abs_##number(v38), v175 = v165 + v117 * v174, \
        v176 = v175 + dhgen_abs_##number(v40), \
        v185 = v181 * (near_angle * v156 + v149 * v155 + (near_angle * v141 + v140 * v159)), \
        v186 = v137 * v185 + v138 * (v185 + dhgen_abs_##number(v49))
#define SIGNED_TWICE(number, signs) \
    /* theta1 */ \
    const dhgen_##number v19 = inverse1 * (e1 * T14), c1 = v20 + w1 * v19, \
        v21 = inverse1 * (e1 * T24), s1 = w1 * v21 - v22; \
    /* theta2 */ \
    const dhgen_##number S2 = v29 + e1 * v30, C2 = e1 * v33 - v31, v34 = S2 * S2 + C2 * C2, \
        v35 = dhgen_sqrt_##number(v34), v36 = 1.0 / v34, factor2 = v35 * v36; \
    /* theta5 */ \
    const dhgen_##number v47 = s3 * (e1 * v46), v48 = inverse1 * v47, v51 = w1 * v48 - v50, \
        v52 = c1 * v42 + s1 * v43 - v45, v53 = v41 + (c1 * v38 + s1 * v40), \
        v54 = S2 * v52 - C2 * v53, c5 = factor2 * v54 - v9 * v51, \
        v56 = s3 * (c1 * T13 + s1 * T23), v57 = C2 * v56 + S2 * v55, \
        Y5 = factor2 * v57 - c3 * (s1 * T13 - c1 * T23), v58 = c5 * c5 + Y5 * Y5; \
    /* theta7 */ \
    const dhgen_##number v66 = s1 * T12 - c1 * T22, v77 = s1 * T11 - c1 * T21, \
        s7 = c5 * (c3 * v77 - factor2 * (C2 * (s3 * (c1 * T11 + s1 * T21)) + S2 * v76)) + Y5 * \
            (factor2 * (S2 * (c1 * v83 + s1 * v84 - v86) - C2 * (v82 + (c1 * v79 + s1 * v81))) - \
            v9 * (s3 * v77)); \
    /* joint values */ \
    const dhgen_##number v125 = dhgen_abs_##number(S2), v130 = dhgen_abs_##number(C2), \
        v133 = dhgen_abs_##number(v34), v134 = dhgen_abs_##number(v36), \
        v151 = dhgen_abs_##number(c1), v161 = dhgen_abs_##number(s1), \
        v179 = dhgen_abs_##number(factor2), v189 = near_angle * v151, v190 = near_angle * v161

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    ENTRIES(dhgen_wide);
    dhgen_wide_mask left = (dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11] + free_joints[0])
        <= DHGEN_ORTHONORMAL) == 0;
    KNOWN(wide);
    left |= (dhgen_abs_wide(N4) <= 0.0) | (v88 <= v103) | (v132 <= v95) | (v107 <= v105) |
        (dhgen_abs_wide(v90) <= 2.0 * v97) | (N1 <= near_doubt_limit_squared2) | (v88 <= near_m1 *
        v90) | (N4 <= near_doubt_limit_squared4);

    for (int i1 = 0; i1 < 2; i1++) { /* elbow+, elbow- */
        const double e4 = i1 == 0 ? 1.0 : -1.0;
        SIGNED(wide, double);

        /* joint values */
        const dhgen_wide angle6 = dhgen_atan2_wide(s4, -v9), q4_p = v13 + angle6,
            v106 = near_m2 * (v100 * (v99 * (near_length * fabs(e4)))),
            v108 = v102 + (v106 * v107 + v105 * (v106 + dhgen_abs_wide(v28)));
        left |= (dhgen_abs_wide(D1) <= v113) | (dhgen_abs_wide(v16) <= 2.0 * v112) |
            (dhgen_abs_wide(D1 * v12) <= near_m3 * v16);

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
            const dhgen_wide angle4 = dhgen_atan2_wide(dhgen_sqrt_wide(v58), -(s4 * v51 + factor2 *
                (C2 * (c1 * v59 + s1 * v60 - v61) + S2 * (v64 + (c1 * v62 + s1 * v63)))));

            /* theta7 */
            const dhgen_wide angle5 = dhgen_atan2_wide(s7, c5 * (c3 * v66 - factor2 * (C2 * (s3 *
                (c1 * T12 + s1 * T22)) + S2 * v65)) + Y5 * (factor2 * (S2 * (c1 * v72 + s1 * v73 -
                v75) - C2 * (v71 + (c1 * v68 + s1 * v70))) - v9 * (s3 * v66)));

            /* joint values */
            const double v123 = fabs(e1);
            const dhgen_wide v124 = v108 + v122 * v123, v129 = v128 + v123 * v127,
                v131 = v124 * (v124 + 2.0 * v125) + v129 * (v129 + 2.0 * v130),
                v135 = v131 * v134 / (v133 - v131),
                v136 = v135 * dhgen_abs_wide(v35) + (v124 + v129) * (v134 + v135);
            const double v143 = near_length * v123;
            const dhgen_wide v144 = v137 * v143, v145 = v144 + v138 * (v91 + v143),
                v146 = v145 + dhgen_abs_wide(v19), v147 = v142 + (v120 * v145 + v115 * v146),
                v153 = v144 + v138 * (v93 + v143), v154 = v153 + dhgen_abs_wide(v21),
                v158 = v157 + (v120 * v153 + v115 * v154),
                v168 = v167 + (v150 * v151 + v147 * v152 + (v160 * v161 + v158 * v162)),
                v177 = v170 + (v151 * v172 + v147 * v173 + (v161 * v175 + v158 * v176)),
                v178 = v125 * v168 + v124 * (v168 + dhgen_abs_wide(v52)) + (v130 * v177 + v129 *
                    (v177 + dhgen_abs_wide(v53))), v182 = v181 * (v123 * v180),
                v183 = v137 * v182 + v138 * (v182 + dhgen_abs_wide(v47)),
                v184 = v183 + dhgen_abs_wide(v48), v187 = v186 + (v120 * v183 + v115 * v184),
                v188 = v178 * v179 + v136 * (v178 + dhgen_abs_wide(v54)) + (v118 * v187 + v117 *
                    (v187 + dhgen_abs_wide(v51))),
                v191 = v181 * (v189 + v147 * v149 + (v190 + v158 * v159)),
                v194 = v130 * v191 + v129 * (v191 + dhgen_abs_wide(v56)) + (v125 * v192 + v124 *
                    v193),
                v195 = v179 * v194 + v136 * (v194 + dhgen_abs_wide(v57)) + v163 * (v190 + v149 *
                    v158 + (v189 + v147 * v159));
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
            left |= (dhgen_abs_wide(v58) <= v188 * v188 + v195 * v195) | (v133 <= v131) | (v58 <=
                near_m5) | (v34 <= near_m4);
        }
    }
    return left;
}

#if DHGEN_LANES > 1
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    const dhgen_four e4 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e1 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);
    KNOWN(double);
    SIGNED(four, four);
    SIGNED_TWICE(four, four);

    /* joint values */
    const dhgen_four v106 = near_m2 * (v100 * (v99 * (near_length * dhgen_abs_four(e4)))),
        v108 = v102 + (v106 * v107 + v105 * (v106 + dhgen_abs_four(v28))),
        v123 = dhgen_abs_four(e1), v124 = v108 + v122 * v123, v129 = v128 + v123 * v127,
        v131 = v124 * (v124 + 2.0 * v125) + v129 * (v129 + 2.0 * v130),
        v135 = v131 * v134 / (v133 - v131),
        v136 = v135 * dhgen_abs_four(v35) + (v124 + v129) * (v134 + v135),
        v143 = near_length * v123, v144 = v137 * v143, v145 = v144 + v138 * (v91 + v143),
        v146 = v145 + dhgen_abs_four(v19), v147 = v142 + (v120 * v145 + v115 * v146),
        v153 = v144 + v138 * (v93 + v143), v154 = v153 + dhgen_abs_four(v21),
        v158 = v157 + (v120 * v153 + v115 * v154),
        v168 = v167 + (v150 * v151 + v147 * v152 + (v160 * v161 + v158 * v162)),
        v177 = v170 + (v151 * v172 + v147 * v173 + (v161 * v175 + v158 * v176)),
        v178 = v125 * v168 + v124 * (v168 + dhgen_abs_four(v52)) + (v130 * v177 + v129 * (v177 +
            dhgen_abs_four(v53))), v182 = v181 * (v123 * v180),
        v183 = v137 * v182 + v138 * (v182 + dhgen_abs_four(v47)), v184 = v183 + dhgen_abs_four(v48),
        v187 = v186 + (v120 * v183 + v115 * v184),
        v188 = v178 * v179 + v136 * (v178 + dhgen_abs_four(v54)) + (v118 * v187 + v117 * (v187 +
            dhgen_abs_four(v51))), v191 = v181 * (v189 + v147 * v149 + (v190 + v158 * v159)),
        v194 = v130 * v191 + v129 * (v191 + dhgen_abs_four(v56)) + (v125 * v192 + v124 * v193),
        v195 = v179 * v194 + v136 * (v194 + dhgen_abs_four(v57)) + v163 * (v190 + v149 * v158 +
            (v189 + v147 * v159));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) + 0.0 * (free_joints[0]) <= DHGEN_ORTHONORMAL)
        == 0) | ((dhgen_abs_four(D1) <= v113) | (dhgen_abs_four(v16) <= 2.0 * v112) |
        (dhgen_abs_four(D1 * v12) <= near_m3 * v16)) | ((dhgen_abs_four(v58) <= v188 * v188 + v195 *
        v195) | (v133 <= v131) | (v58 <= near_m5) | (v34 <= near_m4))) | (unsigned)((fabs(N4) <=
        0.0) | (v88 <= v103) | (v132 <= v95) | (v107 <= v105) | (fabs(v90) <= 2.0 * v97) | (N1 <=
        near_doubt_limit_squared2) | (v88 <= near_m1 * v90) | (N4 <= near_doubt_limit_squared4)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(s4, -v9),
        ratio2 = dhgen_ratio_four(s1, c1), ratio3 = dhgen_ratio_four(S2, C2),
        ratio4 = dhgen_ratio_four(Y5, c5),
        ratio5 = dhgen_ratio_four(s7, c5 * (c3 * v66 - factor2 * (C2 * (s3 * (c1 * T12 + s1 * T22))
            + S2 * v65)) + Y5 * (factor2 * (S2 * (c1 * v72 + s1 * v73 - v75) - C2 * (v71 + (c1 * v68
            + s1 * v70))) - v9 * (s3 * v66))),
        ratio6 = dhgen_ratio_four(dhgen_sqrt_four(v58), -(s4 * v51 + factor2 * (C2 * (c1 * v59 + s1
            * v60 - v61) + S2 * (v64 + (c1 * v62 + s1 * v63)))));
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
#else
static int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    return dhgen_solve_branches(solve_wide, 8, T, free_joints, q, status);
}
#endif

DHGEN_TABLE dhgen_nearest_arm nearest_arm = {
    8, /* rows */
    { 1.0, 0.0, 0.0, -0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 0.0, -1.0, 0.28481 },
    { 1.0, 0.0, 0.0, -0.0, -0.0, 1.0, 0.0, -0.0, 0.0, -0.0, 1.0, 0.10593 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 0, 1, 3, 4, 5, 6 },
};
#endif

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double *T, const double *free_joints, const double *seed, double moved, double *rows,
    unsigned char *status)
{
    double (*const q)[7] = (double (*)[7])rows;
    (void)moved;
    double nearby[16][6];
#ifdef KINOVA_GEN3_7_PLAIN
    const int nearby_count = 0;
#else
    const int nearby_count = dhgen_near_solutions(&nearest_arm, solve_regular, T, free_joints,
        nearby);
#endif

    /* all joints: the general 6R loop */
    double solution_roots[16][7];
    int solution_found[16], solution_chosen[16];
    dhgen_general_rows(&general, &descents, T, free_joints, seed, nearby, nearby_count,
        solution_roots[0], solution_found, solution_chosen);

    for (int i1 = 0; i1 < 16; i1++) { /* root1 to root16 */
        const double q1 = solution_roots[i1][0];
        const double q2 = solution_roots[i1][1];
        const double q3 = solution_roots[i1][2];
        const double q4 = solution_roots[i1][3];
        const double q5 = solution_roots[i1][4];
        const double q6 = solution_roots[i1][5];
        const double q7 = solution_roots[i1][6];
        const int found = solution_found[i1];
        const int chosen = solution_chosen[i1];
        /* all joints: the general 6R loop */
        if (!found) continue; /* out of reach */
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
        q[row][5] = q6; q[row][6] = q7;
        status[row] = chosen ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

static const int given_joints[1] = { 2 };
static const int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
static const struct dhgen_arm arm = {
    7, 16, 1, DHGEN_POSE, joints, given_joints, 1,
    { 0.869, 0.869, 0.869, 1.0, 1.0, 1.0 }, 0.8690286866369458, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 0, /* winds */
    0, /* follows seed */
    NULL, NULL,
    NULL, NULL,
    kinova_gen3_7_fk, kinova_gen3_7_jacobian, solve,
    NULL,
};

void kinova_gen3_7_joint_velocities(const double q[7], const double twist[6], double velocities[7])
{
    dhgen_joint_velocities(&arm, q, twist, velocities);
}

int kinova_gen3_7_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[16][7],
    unsigned char status[16])
{
    return dhgen_careful_ik(&arm, T, free_joints, q_seed, &q[0][0], status);
}

int kinova_gen3_7_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7])
{
    return dhgen_ik_nearest(&arm, T, free_joints, q_seed, q);
}

void kinova_gen3_7_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status)
{
    dhgen_ik_each(&arm, 0, n, T, free_joints, q, status);
}

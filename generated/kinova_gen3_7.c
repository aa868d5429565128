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

#ifndef __CUDACC_RTC__
const char *const kinova_gen3_7_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
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

DHGEN_PUBLIC void kinova_gen3_7_frames(const double q[7], double frames[9][16])
{
    static const double base[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 };
    static const struct dhgen_links links = { 7, DHGEN_STANDARD, joints, &table[0][0], NULL, base,
        NULL };
    dhgen_frames(&links, q, frames);
}

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
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
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
    near1 = 2.4500014000001997e-07, /* near_length^2 + near_length^2 [m^2] */
    near2 = 3.6750021000002996e-07, /* near_length^2 + near1 [m^2] */
    near3 = 0.5, /* 1 / 2 */
    near4 = 9.721858904945563e-08, /* near_k1 * near2 [m^4] */
    near5 = 5.0000000000000005e-21; /* near_angle^2 / 2 */

/* What one pose and many compute alike: values without signs of branches, with the first, with
 * all that are in lanes. */
#define KNOWN(number) \
    const dhgen_##number v1 = near_offset3 + free_joints[0], c3 = dhgen_cos_##number(v1), \
        s3 = dhgen_sin_##number(v1); \
    /* theta4 */ \
    const dhgen_##number X4 = near_d5 * (near_d2 * s3) * 2.0, N4 = near_k2 + X4 * X4, \
        v2 = T14 * T14, v3 = T24 * T24, Z4 = near_k3 * c3 + (v2 + (v3 + (T34 * T34 - near_k4))), \
        D4 = N4 - Z4 * Z4, w4 = dhgen_sqrt_##number(D4), inverse4 = DHGEN_QUOTIENT(1.0, N4), \
        v4 = X4 * Z4, v5 = inverse4 * v4, v7 = inverse4 * (near_k1 * Z4); \
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
        v90 = near_merge_slack2 + 2.0 * v89, v91 = near_length * T14, \
        v92 = dhgen_abs_##number(T14), v93 = v91 + v91, v94 = near_length * T24, \
        v95 = dhgen_abs_##number(T24), v96 = v94 + v94, v97 = near_length * T34, \
        v98 = dhgen_abs_##number(T34), v99 = v97 + v97, v100 = Z4 * v93, v101 = Z4 * v96, \
        v102 = Z4 * v99, v103 = near2 * v89, v104 = v93 * v93 + v96 * v96, \
        v105 = near2 + dhgen_sqrt_##number(v104 + v99 * v99), v106 = v100 + v100, \
        v107 = v101 + v101, v108 = v102 + v102, v109 = v103 + v103 + v105 * v105, \
        v110 = v109 + dhgen_sqrt_##number(v106 * v106 + v107 * v107 + v108 * v108), \
        v111 = X4 * v93, v112 = X4 * v96, v113 = X4 * v99, v114 = near2 * dhgen_abs_##number(X4), \
        v115 = inverse4 * v111, v116 = inverse4 * v112, v117 = inverse4 * v113, \
        v118 = dhgen_abs_##number(inverse4), v119 = v114 * v118, v120 = DHGEN_QUOTIENT(near3, w4), \
        v121 = v106 * v120, v122 = v107 * v120, v123 = v108 * v120, v124 = v110 * v120, \
        v125 = DHGEN_QUOTIENT(v124 * v124, w4), \
        v126 = v125 + (v125 + v109 * dhgen_abs_##number(v120)), \
        v127 = v126 + dhgen_sqrt_##number(v121 * v121 + v122 * v122 + v123 * v123), \
        v135 = dhgen_abs_##number(v10), v148 = dhgen_abs_##number(v24), \
        v149 = inverse4 * (v24 * v111), v150 = inverse4 * (v24 * v112), \
        v151 = inverse4 * (v24 * v113), v152 = v118 * (v114 * v148), v153 = T34 * v149, \
        v154 = T34 * v150, v155 = T34 * v151 + near_length * v27, \
        v156 = v98 * v152 + near_length * (v152 + dhgen_sqrt_##number(v149 * v149 + v150 * v150 + \
            v151 * v151)), v168 = inverse4 * (near_k1 * v93), v169 = inverse4 * (near_k1 * v96), \
        v170 = inverse4 * (near_k1 * v99), v171 = near4 * v118, \
        v240 = dhgen_abs_##number(inverse1), v241 = inverse1 * (inverse1 * v93), \
        v242 = inverse1 * (inverse1 * v96), v243 = v240 * (near1 * v240), v271 = near_angle * T33, \
        v272 = near_angle * T23, v279 = dhgen_abs_##number(T13), v280 = v271 * v271, \
        v281 = v272 * v272, v282 = near5 + dhgen_sqrt_##number(v280 + v281), \
        v309 = near_angle * T13, v314 = dhgen_abs_##number(T23), v315 = v309 * v309, \
        v316 = near5 + dhgen_sqrt_##number(v280 + v315), v323 = c3 * v272, v324 = c3 * v309, \
        v325 = dhgen_abs_##number(c3), v326 = near5 * v325, \
        v327 = near5 + dhgen_sqrt_##number(v281 + v315), v335 = dhgen_abs_##number(v45), \
        v336 = v323 * v323, v337 = v324 * v324, v338 = v326 + dhgen_sqrt_##number(v336 + v337), \
        v349 = dhgen_abs_##number(T33), v351 = c3 * v271, v356 = dhgen_abs_##number(v38), \
        v357 = v351 * v351, v358 = v326 + dhgen_sqrt_##number(v336 + v357), \
        v366 = dhgen_abs_##number(v40), v367 = v326 + dhgen_sqrt_##number(v337 + v357), \
        v387 = T24 * v271, v388 = near_length * T13, v389 = T14 * v271, v390 = near_length * T23, \
        v391 = T24 * v272 + T14 * v309, v397 = dhgen_abs_##number(s3), \
        v398 = v397 * (near5 * v95 + near_length * v282 + (near5 * v92 + near_length * v316)), \
        v402 = v240 * v398, v448 = s3 * v272, v449 = s3 * v309, v450 = near5 * v397, \
        v451 = dhgen_abs_##number(v56), \
        v453 = v450 + dhgen_sqrt_##number(v448 * v448 + v449 * v449)
#define SIGNED(number, signs) \
    /* theta4 */ \
    const dhgen_##number v6 = near_m2 * (e4 * inverse4), s4 = v5 - w4 * v6, \
        v8 = inverse4 * (e4 * X4), v9 = v7 + w4 * v8; \
    /* theta1 */ \
    const dhgen_##number Z1 = v11 - s4 * v10, D1 = N1 - Z1 * Z1, w1 = dhgen_sqrt_##number(D1), \
        v13 = w1 - w1, v14 = dhgen_abs_##number(Z1), v15 = near_blur_slack1 + 2.0 * v14, \
        v16 = T14 * Z1, v17 = T24 * Z1, v20 = inverse1 * v17, v23 = inverse1 * v16; \
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
    const dhgen_##number q3_p = v13 + v88, v128 = v115 + v6 * v121, v129 = v116 + v6 * v122, \
        v130 = v117 + v6 * v123, v131 = v119 + v126 * dhgen_abs_##number(v6), v132 = v10 * v128, \
        v133 = v10 * v129, v134 = v10 * v130, v136 = v131 * v135, \
        v137 = v131 + dhgen_sqrt_##number(v128 * v128 + v129 * v129 + v130 * v130), \
        v138 = Z1 * v132, v139 = Z1 * v133, v140 = Z1 * v134, v141 = v14 * v136, \
        v142 = v136 + dhgen_sqrt_##number(v132 * v132 + v133 * v133 + v134 * v134), \
        v143 = v140 + v140, v144 = v93 + (v138 + v138), v145 = v96 + (v139 + v139), \
        v146 = near1 + (v141 + v141 + v142 * v142), \
        v147 = v146 + dhgen_sqrt_##number(v144 * v144 + v145 * v145 + v143 * v143), \
        v157 = near_m2 * (inverse4 * (v24 * (near_length * e4))), v158 = v153 + v29 * v121, \
        v159 = v154 + v29 * v122, v160 = v155 + (v29 * v123 - w4 * v157), \
        v161 = DHGEN_QUOTIENT(near3, w1), v162 = v144 * v161, v163 = v145 * v161, \
        v164 = v143 * v161, v165 = v147 * v161, v166 = DHGEN_QUOTIENT(v165 * v165, w1), \
        v167 = v166 + (v166 + v146 * dhgen_abs_##number(v161)), v172 = v168 - v8 * v121, \
        v173 = v169 - v8 * v122, v174 = v170 - v8 * v123, \
        v175 = v171 + v126 * dhgen_abs_##number(v8), v176 = near_d5 * v172, v177 = near_d5 * v173, \
        v178 = near_d5 * v174, v179 = near_d5 * v175, \
        v180 = v175 + dhgen_sqrt_##number(v172 * v172 + v173 * v173 + v174 * v174), \
        v181 = dhgen_abs_##number(w1), \
        v182 = v167 + dhgen_sqrt_##number(v162 * v162 + v163 * v163 + v164 * v164), \
        v183 = dhgen_sqrt_##number(v176 * v176 + v177 * v177 + v178 * v178) - v179, \
        v184 = w1 * v176 + v26 * v162, v185 = w1 * v177 + v26 * v163, \
        v186 = w1 * v178 + v26 * v164, \
        v190 = v156 + (v126 * dhgen_abs_##number(v29) + v127 * dhgen_abs_##number(v157)) + (v167 * \
            dhgen_abs_##number(v26) - v179 * v181 + v182 * v183), v192 = v24 * v128, \
        v193 = v24 * v129, v194 = v24 * v130, v195 = v131 * v148, v196 = w1 * v192 + v33 * v162, \
        v197 = w1 * v193 + v33 * v163, v198 = w1 * v194 + v33 * v164, v199 = T34 * v176, \
        v200 = T34 * v177, v201 = T34 * v178 + near_length * v26, \
        v205 = v181 * v195 + v167 * dhgen_abs_##number(v33) + v182 * (v195 + \
            dhgen_sqrt_##number(v192 * v192 + v193 * v193 + v194 * v194)) + (near_length * v183 - \
            v98 * v179), v246 = T24 * v132, v247 = T24 * v134, v248 = near_length * Z1, \
        v249 = v248 - T24 * v133, v250 = near_length * v142, v251 = v250 + v95 * v136, \
        v252 = inverse1 * v247, v253 = dhgen_abs_##number(v17), \
        v255 = v251 + dhgen_sqrt_##number(v246 * v246 + v249 * v249 + v247 * v247), \
        v256 = inverse1 * v246 + v17 * v241, v257 = inverse1 * v249 - v17 * v242, \
        v273 = s4 * v271, v274 = s4 * v272, v275 = near5 * dhgen_abs_##number(s4), \
        v276 = T13 * v128, v277 = T13 * v129, v278 = T13 * v130, \
        v283 = v275 + v131 * v279 + v137 * v282, v285 = dhgen_abs_##number(v43), \
        v287 = v273 * v273, \
        v288 = v283 + (dhgen_sqrt_##number(v287 + v274 * v274) + dhgen_sqrt_##number(v276 * v276 + \
            v277 * v277 + v278 * v278)), v295 = T14 * v133, v296 = T14 * v134, \
        v297 = v248 - T14 * v132, v298 = v250 + v92 * v136, v299 = inverse1 * v296, \
        v300 = dhgen_abs_##number(v16), \
        v301 = v298 + dhgen_sqrt_##number(v297 * v297 + v295 * v295 + v296 * v296), \
        v302 = inverse1 * v295 + v16 * v242, v304 = v16 * v241 - inverse1 * v297, \
        v310 = s4 * v309, v311 = T23 * v128, v312 = T23 * v129, v313 = T23 * v130, \
        v317 = v275 + v131 * v314 + v137 * v316, v319 = dhgen_abs_##number(v44), \
        v321 = v317 + (dhgen_sqrt_##number(v287 + v310 * v310) + dhgen_sqrt_##number(v311 * v311 + \
            v312 * v312 + v313 * v313)), v328 = v9 * v323, v329 = v9 * v324, \
        v330 = dhgen_abs_##number(v9), v331 = v326 * v330, v332 = v45 * v172, v333 = v45 * v173, \
        v334 = v45 * v174, v339 = v331 + v175 * v335 + v180 * v338, v346 = T33 * v128, \
        v347 = T33 * v129, v348 = T33 * v130, v350 = v275 + v131 * v349 + v137 * v327, \
        v352 = v9 * v351, v353 = v38 * v172, v354 = v38 * v173, v355 = v38 * v174, \
        v359 = v331 + v175 * v356 + v180 * v358, v360 = dhgen_abs_##number(v39), \
        v361 = v352 * v352, \
        v362 = v359 + (dhgen_sqrt_##number(v361 + v328 * v328) + dhgen_sqrt_##number(v353 * v353 + \
            v354 * v354 + v355 * v355)), v363 = v40 * v172, v364 = v40 * v173, v365 = v40 * v174, \
        v368 = v331 + v175 * v366 + v180 * v367, v369 = dhgen_abs_##number(v41), \
        v370 = v368 + (dhgen_sqrt_##number(v361 + v329 * v329) + dhgen_sqrt_##number(v363 * v363 + \
            v364 * v364 + v365 * v365)), v408 = s3 * (v17 * v271), v409 = s3 * (v16 * v271), \
        v410 = s3 * (v17 * v309 - v16 * v272), v411 = s3 * (T13 * v297 - T23 * v246), \
        v412 = s3 * (T23 * v249 - T13 * v295), v413 = s3 * (T13 * v296 + T23 * v247), \
        v414 = v397 * (near5 * v300 + v279 * v298 + v282 * v301 + (near5 * v253 + v251 * v314 + \
            v255 * v316)), v415 = inverse1 * v408, v416 = inverse1 * v409, v417 = inverse1 * v410, \
        v418 = inverse1 * v413, v423 = v50 * v241 - inverse1 * v411, \
        v425 = v50 * v242 - inverse1 * v412, v452 = v190 * v451
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
    /* joint values */ \
    const dhgen_##number v187 = v158 + e1 * v184, v188 = v159 + e1 * v185, \
        v189 = v160 + e1 * v186, \
        v191 = v190 + dhgen_sqrt_##number(v187 * v187 + v188 * v188 + v189 * v189), \
        v202 = e1 * v196 - v199, v203 = e1 * v197 - v200, v204 = e1 * v198 - v201, \
        v206 = v205 + dhgen_sqrt_##number(v202 * v202 + v203 * v203 + v204 * v204), \
        v207 = v191 * v191, v208 = v206 * v206, v209 = v207 + v208, v210 = S2 * v187, \
        v211 = S2 * v188, v212 = S2 * v189, v213 = dhgen_abs_##number(S2), v214 = v190 * v213, \
        v215 = C2 * v202, v216 = C2 * v203, v217 = C2 * v204, v218 = dhgen_abs_##number(C2), \
        v219 = v205 * v218, v220 = v210 + v210 + (v215 + v215), \
        v221 = v211 + v211 + (v216 + v216), v222 = v212 + v212 + (v217 + v217), \
        v223 = v207 + (v214 + v214) + (v208 + (v219 + v219)), v224 = DHGEN_QUOTIENT(near3, v36), \
        v225 = v220 * v224, v226 = v221 * v224, v227 = v222 * v224, \
        v228 = v223 * dhgen_abs_##number(v224), v229 = dhgen_abs_##number(v37), \
        v230 = v37 * (v37 * v220), v231 = v37 * (v37 * v221), v232 = v37 * (v37 * v222), \
        v233 = v229 * (v223 * v229), v234 = v36 - dhgen_sqrt_##number(v209), \
        v235 = v233 + (v233 + (dhgen_abs_##number(v232) + (dhgen_abs_##number(v230) + \
            dhgen_abs_##number(v231)))) * DHGEN_QUOTIENT(v223 + dhgen_sqrt_##number(v220 * v220 + \
            v221 * v221 + v222 * v222), v234 * v234), v236 = v37 * v225 - v36 * v230, \
        v237 = v37 * v226 - v36 * v231, v238 = v37 * v227 - v36 * v232, \
        v239 = v235 * dhgen_abs_##number(v36) + v228 * v229 + (v228 + dhgen_sqrt_##number(v225 * \
            v225 + v226 * v226 + v227 * v227)) * (v235 + dhgen_sqrt_##number(v230 * v230 + v231 * \
            v231 + v232 * v232)), v259 = inverse1 * (near_length * e1), v260 = v18 * v242, \
        v261 = v259 - v18 * v241, v265 = dhgen_abs_##number(v19), \
        v267 = w1 * v261 + v19 * v162 - v256, v268 = v257 + (v19 * v163 - w1 * v260), \
        v269 = v19 * v164 - v252, v284 = dhgen_abs_##number(c1), v289 = v21 * v241, \
        v290 = v259 - v21 * v242, v293 = dhgen_abs_##number(v22), \
        v305 = v304 + (v22 * v162 - w1 * v289), v306 = v302 + (w1 * v290 + v22 * v163), \
        v307 = v299 + v22 * v164, v318 = dhgen_abs_##number(s1), v322 = s1 * v310 - c1 * v274, \
        v340 = v328 + s1 * v273, v341 = v329 + c1 * v273, \
        v342 = c1 * v276 + v43 * v267 + (s1 * v311 + v44 * v305) - v332, \
        v343 = c1 * v277 + v43 * v268 + (s1 * v312 + v44 * v306) - v333, \
        v344 = c1 * v278 + v43 * v269 + (s1 * v313 + v44 * v307) - v334, \
        v371 = s1 * v329 - c1 * v328, v372 = v274 - s1 * v352, v373 = c1 * v352 - v310, \
        v374 = v346 + (c1 * v353 + v39 * v267 + (s1 * v363 + v41 * v305)), \
        v375 = v347 + (c1 * v354 + v39 * v268 + (s1 * v364 + v41 * v306)), \
        v376 = v348 + (c1 * v355 + v39 * v269 + (s1 * v365 + v41 * v307)), \
        v378 = S2 * v340 + C2 * v372, v379 = S2 * v341 - C2 * v373, v380 = S2 * v322 - C2 * v371, \
        v381 = S2 * v342 + v53 * v187 - (C2 * v374 + v54 * v202), \
        v382 = S2 * v343 + v53 * v188 - (C2 * v375 + v54 * v203), \
        v383 = S2 * v344 + v53 * v189 - (C2 * v376 + v54 * v204), \
        v385 = dhgen_abs_##number(factor2), \
        v386 = v239 + dhgen_sqrt_##number(v236 * v236 + v237 * v237 + v238 * v238), \
        v392 = s3 * (e1 * v389), v393 = s3 * (e1 * v387), v394 = s3 * (e1 * v391), \
        v395 = s3 * (e1 * v390), v396 = s3 * (e1 * v388), v399 = inverse1 * v392, \
        v400 = inverse1 * v393, v401 = inverse1 * v394, v403 = inverse1 * v395 + v48 * v241, \
        v404 = inverse1 * v396 - v48 * v242, v406 = dhgen_abs_##number(v49), \
        v420 = v415 + w1 * v399, v421 = w1 * v400 - v416, v422 = v417 + w1 * v401, \
        v424 = v423 + (v49 * v162 - w1 * v403), v426 = v425 + (w1 * v404 + v49 * v163), \
        v427 = v418 + v49 * v164, v429 = factor2 * v378 + v9 * v420, \
        v430 = factor2 * v379 - v9 * v421, v431 = factor2 * v380 + v9 * v422, \
        v432 = factor2 * v381 + v55 * v236 - (v9 * v424 + v52 * v172), \
        v433 = factor2 * v382 + v55 * v237 - (v9 * v426 + v52 * v173), \
        v434 = factor2 * v383 + v55 * v238 - (v9 * v427 + v52 * v174), v436 = c1 * v271, \
        v437 = near5 * v284, v438 = s1 * v271, v439 = near5 * v318, v440 = s3 * v438, \
        v441 = s3 * v436, v442 = s3 * (s1 * v309 - c1 * v272), \
        v443 = s3 * (T13 * v267 + T23 * v305), v444 = s3 * (T13 * v268 + T23 * v306), \
        v445 = s3 * (T13 * v269 + T23 * v307), v447 = C2 * v442, v454 = S2 * v448 - C2 * v440, \
        v455 = C2 * v441 - S2 * v449, v456 = C2 * v443 + v57 * v202 + v56 * v187, \
        v457 = C2 * v444 + v57 * v203 + v56 * v188, v458 = C2 * v445 + v57 * v204 + v56 * v189, \
        v460 = factor2 * v454 - c3 * v436, v461 = factor2 * v455 - c3 * v438, \
        v462 = factor2 * v447 + c3 * (s1 * v272 + c1 * v309), \
        v463 = factor2 * v456 + v58 * v236 - c3 * (T13 * v305 - T23 * v267), \
        v464 = factor2 * v457 + v58 * v237 - c3 * (T13 * v306 - T23 * v268), \
        v465 = factor2 * v458 + v58 * v238 - c3 * (T13 * v307 - T23 * v269)

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    ENTRIES(dhgen_wide);
    dhgen_wide_mask left = (dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11] + free_joints[0])
        <= DHGEN_ORTHONORMAL) == 0;
    KNOWN(wide);

    /* joint values */
    const dhgen_wide v244 = dhgen_sqrt_wide(N1) - sqrt(near1),
        v245 = v243 + (v243 + (dhgen_abs_wide(v241) + dhgen_abs_wide(v242))) * DHGEN_QUOTIENT(near1
            + dhgen_sqrt_wide(v104), v244 * v244),
        v254 = v245 + dhgen_sqrt_wide(v241 * v241 + v242 * v242), v262 = near_length * v254,
        v263 = v262 + v92 * v245, v291 = v262 + v95 * v245;
    left |= (dhgen_abs_wide(N1) <= near1) | (dhgen_abs_wide(v110 + (D4 + D4)) <= v110) |
        (dhgen_abs_wide(v90) <= 2.0 * v105) | (N1 <= near_doubt_limit_squared2) |
        (dhgen_abs_wide(D4) <= near_m1 * v90) | (N4 <= near_doubt_limit_squared4);

    for (int i1 = 0; i1 < 2; i1++) { /* elbow+, elbow- */
        const double e4 = i1 == 0 ? 1.0 : -1.0;
        SIGNED(wide, double);

        /* joint values */
        const dhgen_wide angle6 = dhgen_atan2_wide(s4, -v9), q4_p = v13 + angle6,
            v258 = v240 * v251 + v245 * v253 + v254 * v255, v264 = v181 * v263, v292 = v181 * v291,
            v303 = v240 * v298 + v245 * v300 + v254 * v301,
            v419 = v240 * v414 + v245 * dhgen_abs_wide(v50) + v254 * (v414 + (dhgen_sqrt_wide(v408 *
                v408 + v409 * v409 + v410 * v410) + dhgen_sqrt_wide(v411 * v411 + v412 * v412 + v413
                * v413)));
        left |= (dhgen_abs_wide(v147 + (D1 + D1)) <= v147) | (dhgen_abs_wide(v15) <= 2.0 * v142) |
            (dhgen_abs_wide(D1 * v12) <= near_m3 * v15);

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

            /* joint values */
            const dhgen_wide v266 = v263 + dhgen_sqrt_wide(v261 * v261 + v260 * v260),
                v270 = v258 + (v264 + v167 * v265 + v182 * v266),
                v286 = v270 + dhgen_sqrt_wide(v267 * v267 + v268 * v268 + v269 * v269),
                v294 = v291 + dhgen_sqrt_wide(v289 * v289 + v290 * v290),
                v308 = v303 + (v292 + v167 * v293 + v182 * v294),
                v320 = v308 + dhgen_sqrt_wide(v305 * v305 + v306 * v306 + v307 * v307),
                v345 = v339 + (v283 * v284 + v270 * v285 + v286 * v288 + (v317 * v318 + v308 * v319
                    + v320 * v321)),
                v377 = v350 + (v284 * v359 + v270 * v360 + v286 * v362 + (v318 * v368 + v308 * v369
                    + v320 * v370)),
                v384 = v213 * v345 + v190 * dhgen_abs_wide(v53) + v191 * (v345 +
                    (dhgen_sqrt_wide(v340 * v340 + v341 * v341 + v322 * v322) + dhgen_sqrt_wide(v342
                    * v342 + v343 * v343 + v344 * v344))) + (v218 * v377 + v205 *
                    dhgen_abs_wide(v54) + v206 * (v377 + (dhgen_sqrt_wide(v372 * v372 + v373 * v373
                    + v371 * v371) + dhgen_sqrt_wide(v374 * v374 + v375 * v375 + v376 * v376)))),
                v405 = v402 + v245 * dhgen_abs_wide(v48) + v254 * (v398 + (dhgen_sqrt_wide(v392 *
                    v392 + v393 * v393 + v394 * v394) + dhgen_sqrt_wide(v395 * v395 + v396 *
                    v396))),
                v407 = v405 + (dhgen_sqrt_wide(v399 * v399 + v400 * v400 + v401 * v401) +
                    dhgen_sqrt_wide(v403 * v403 + v404 * v404)),
                v428 = v419 + (v181 * v405 + v167 * v406 + v182 * v407),
                v435 = v384 * v385 + v239 * dhgen_abs_wide(v55) + v386 * (v384 +
                    (dhgen_sqrt_wide(v378 * v378 + v379 * v379 + v380 * v380) + dhgen_sqrt_wide(v381
                    * v381 + v382 * v382 + v383 * v383))) + (v330 * v428 + v175 *
                    dhgen_abs_wide(v52) + v180 * (v428 + (dhgen_sqrt_wide(v420 * v420 + v421 * v421
                    + v422 * v422) + dhgen_sqrt_wide(v424 * v424 + v426 * v426 + v427 * v427)))) +
                    (dhgen_sqrt_wide(v429 * v429 + v430 * v430 + v431 * v431) + dhgen_sqrt_wide(v432
                    * v432 + v433 * v433 + v434 * v434)),
                v446 = v397 * (v437 + v270 * v279 + v282 * v286 + (v439 + v308 * v314 + v316 *
                    v320)),
                v459 = v218 * v446 + v205 * dhgen_abs_wide(v57) + v206 * (v446 +
                    (dhgen_sqrt_wide(v440 * v440 + v441 * v441 + v442 * v442) + dhgen_sqrt_wide(v443
                    * v443 + v444 * v444 + v445 * v445))) + (v452 + v213 * v450 + v191 * v453),
                v466 = v385 * v459 + v239 * dhgen_abs_wide(v58) + v386 * (v459 +
                    (dhgen_sqrt_wide(v454 * v454 + v455 * v455 + v447 * v447) + dhgen_sqrt_wide(v456
                    * v456 + v457 * v457 + v458 * v458))) + v325 * (v439 + v279 * v308 + v282 * v320
                    + (v437 + v270 * v314 + v286 * v316)) + (dhgen_sqrt_wide(v460 * v460 + v461 *
                    v461 + v462 * v462) + dhgen_sqrt_wide(v463 * v463 + v464 * v464 + v465 * v465));
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
            left |= (dhgen_abs_wide(v59) <= v435 * v435 + v466 * v466) | (dhgen_abs_wide(v35) <=
                v209) | (v59 <= near_m5) | (v35 <= near_m4);
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
    ENTRIES(double);
    KNOWN(double);
    SIGNED(four, four);
    SIGNED_TWICE(four, four);

    /* joint values */
    const double v244 = sqrt(N1) - sqrt(near1),
        v245 = v243 + (v243 + (fabs(v241) + fabs(v242))) * DHGEN_QUOTIENT(near1 + sqrt(v104), v244 *
            v244), v254 = v245 + sqrt(v241 * v241 + v242 * v242);
    const dhgen_four v258 = v240 * v251 + v245 * v253 + v254 * v255;
    const double v262 = near_length * v254, v263 = v262 + v92 * v245;
    const dhgen_four v264 = v181 * v263, v266 = v263 + dhgen_sqrt_four(v261 * v261 + v260 * v260),
        v270 = v258 + (v264 + v167 * v265 + v182 * v266),
        v286 = v270 + dhgen_sqrt_four(v267 * v267 + v268 * v268 + v269 * v269);
    const double v291 = v262 + v95 * v245;
    const dhgen_four v292 = v181 * v291, v294 = v291 + dhgen_sqrt_four(v289 * v289 + v290 * v290),
        v303 = v240 * v298 + v245 * v300 + v254 * v301,
        v308 = v303 + (v292 + v167 * v293 + v182 * v294),
        v320 = v308 + dhgen_sqrt_four(v305 * v305 + v306 * v306 + v307 * v307),
        v345 = v339 + (v283 * v284 + v270 * v285 + v286 * v288 + (v317 * v318 + v308 * v319 + v320 *
            v321)),
        v377 = v350 + (v284 * v359 + v270 * v360 + v286 * v362 + (v318 * v368 + v308 * v369 + v320 *
            v370)),
        v384 = v213 * v345 + v190 * dhgen_abs_four(v53) + v191 * (v345 + (dhgen_sqrt_four(v340 *
            v340 + v341 * v341 + v322 * v322) + dhgen_sqrt_four(v342 * v342 + v343 * v343 + v344 *
            v344))) + (v218 * v377 + v205 * dhgen_abs_four(v54) + v206 * (v377 +
            (dhgen_sqrt_four(v372 * v372 + v373 * v373 + v371 * v371) + dhgen_sqrt_four(v374 * v374
            + v375 * v375 + v376 * v376)))),
        v405 = v402 + v245 * dhgen_abs_four(v48) + v254 * (v398 + (dhgen_sqrt_four(v392 * v392 +
            v393 * v393 + v394 * v394) + dhgen_sqrt_four(v395 * v395 + v396 * v396))),
        v407 = v405 + (dhgen_sqrt_four(v399 * v399 + v400 * v400 + v401 * v401) +
            dhgen_sqrt_four(v403 * v403 + v404 * v404)),
        v419 = v240 * v414 + v245 * dhgen_abs_four(v50) + v254 * (v414 + (dhgen_sqrt_four(v408 *
            v408 + v409 * v409 + v410 * v410) + dhgen_sqrt_four(v411 * v411 + v412 * v412 + v413 *
            v413))), v428 = v419 + (v181 * v405 + v167 * v406 + v182 * v407),
        v435 = v384 * v385 + v239 * dhgen_abs_four(v55) + v386 * (v384 + (dhgen_sqrt_four(v378 *
            v378 + v379 * v379 + v380 * v380) + dhgen_sqrt_four(v381 * v381 + v382 * v382 + v383 *
            v383))) + (v330 * v428 + v175 * dhgen_abs_four(v52) + v180 * (v428 +
            (dhgen_sqrt_four(v420 * v420 + v421 * v421 + v422 * v422) + dhgen_sqrt_four(v424 * v424
            + v426 * v426 + v427 * v427)))) + (dhgen_sqrt_four(v429 * v429 + v430 * v430 + v431 *
            v431) + dhgen_sqrt_four(v432 * v432 + v433 * v433 + v434 * v434)),
        v446 = v397 * (v437 + v270 * v279 + v282 * v286 + (v439 + v308 * v314 + v316 * v320)),
        v459 = v218 * v446 + v205 * dhgen_abs_four(v57) + v206 * (v446 + (dhgen_sqrt_four(v440 *
            v440 + v441 * v441 + v442 * v442) + dhgen_sqrt_four(v443 * v443 + v444 * v444 + v445 *
            v445))) + (v452 + v213 * v450 + v191 * v453),
        v466 = v385 * v459 + v239 * dhgen_abs_four(v58) + v386 * (v459 + (dhgen_sqrt_four(v454 *
            v454 + v455 * v455 + v447 * v447) + dhgen_sqrt_four(v456 * v456 + v457 * v457 + v458 *
            v458))) + v325 * (v439 + v279 * v308 + v282 * v320 + (v437 + v270 * v314 + v286 * v316))
            + (dhgen_sqrt_four(v460 * v460 + v461 * v461 + v462 * v462) + dhgen_sqrt_four(v463 *
            v463 + v464 * v464 + v465 * v465));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) + 0.0 * (free_joints[0]) <= DHGEN_ORTHONORMAL)
        == 0) | ((dhgen_abs_four(v147 + (D1 + D1)) <= v147) | (dhgen_abs_four(v15) <= 2.0 * v142) |
        (dhgen_abs_four(D1 * v12) <= near_m3 * v15)) | ((dhgen_abs_four(v59) <= v435 * v435 + v466 *
        v466) | (dhgen_abs_four(v35) <= v209) | (v59 <= near_m5) | (v35 <= near_m4))) |
        (unsigned)((fabs(N1) <= near1) | (fabs(v110 + (D4 + D4)) <= v110) | (fabs(v90) <= 2.0 *
        v105) | (N1 <= near_doubt_limit_squared2) | (fabs(D4) <= near_m1 * v90) | (N4 <=
        near_doubt_limit_squared4)))
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
#else
DHGEN_FN int solve_regular(
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

#ifndef KINOVA_GEN3_7_PLAIN
DHGEN_FN int solve_certain(
    const double *T, const double *free_joints, double *q, unsigned char *status);
#endif

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(
    const double *T, const double *free_joints, const double *seed, double moved, double *rows,
    unsigned char *status)
{
    (void)moved;
    double nearby[16][6];
#ifdef KINOVA_GEN3_7_PLAIN
    const int nearby_count = 0;
#else
    const int nearby_count = dhgen_near_solutions(&nearest_arm, solve_regular, T, free_joints,
        nearby);
#endif
    dhgen_general_rows(&general, &descents, T, free_joints, seed, nearby, nearby_count, rows,
        status);
}

DHGEN_TABLE int given_joints[1] = { 2 };
DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    7, 16, 1, DHGEN_POSE, joints, given_joints, 1,
    { 0.869, 0.869, 0.869, 1.0, 1.0, 1.0 }, 0.8690286866369458, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 0, /* winds */
    0, /* follows seed */
    NULL, NULL,
    NULL, NULL,
    kinova_gen3_7_fk, kinova_gen3_7_jacobian, solve,
#ifdef KINOVA_GEN3_7_PLAIN
    NULL,
#else
    solve_certain,
#endif
};

#ifndef KINOVA_GEN3_7_PLAIN
/* Poses at which the nearest arm's rows lead to all solutions. Returns how many rows are OK, or -1
 * if the pose has to be left to `solve`. */
DHGEN_FN int solve_certain(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    return dhgen_near_rows(&arm, &general, &descents, &nearest_arm, solve_regular, T, free_joints,
        q, status);
}
#endif

DHGEN_PUBLIC void kinova_gen3_7_joint_velocities(
    const double q[7], const double twist[6], double velocities[7])
{
    dhgen_joint_velocities(&arm, q, twist, velocities);
}

DHGEN_PUBLIC int kinova_gen3_7_ik(
    const double T[16], const double free_joints[1], const double *q_seed, double q[16][7],
    unsigned char status[16])
{
    return dhgen_ik(&arm, T, free_joints, q_seed, &q[0][0], status);
}

DHGEN_PUBLIC int kinova_gen3_7_ik_nearest(
    const double T[16], const double free_joints[1], const double q_seed[7], double q[7])
{
    return dhgen_ik_nearest(&arm, T, free_joints, q_seed, q);
}

DHGEN_PUBLIC void kinova_gen3_7_ik_batch(
    size_t n, const double *T, const double *free_joints, double *q, unsigned char *status)
{
    dhgen_ik_each(&arm, 0, n, T, free_joints, q, status);
}

/* general_rpprrr: General arm with an oblique cross slide on its first axis
 *
 * Inverse kinematics, generated from robots/general_rpprrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/general_rpprrr.yaml. The formulas and where they come from:
 * general_rpprrr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 8e126e041fd99fc0
 * SPDX-License-Identifier: MIT
 */
#include "general_rpprrr.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#define DHGEN_TRAITS 0x486u /* what the arm needs of it */
#ifdef GENERAL_RPPRRR_LANES
#define DHGEN_GENERAL_LANES GENERAL_RPPRRR_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

static const double
    d1 = 0.5, /* joint offset 1 [m] */
    a1 = 0.1, /* link length 1 [m] */
    ca1 = 0.30901699437494745, /* cosine of twist 1 */
    sa1 = 0.9510565162951535, /* sine of twist 1 */
    cat2 = 0.9800665778412416, /* cosine of the angle of joint 2 */
    sat2 = 0.19866933079506122, /* sine of the angle of joint 2 */
    ca2 = 0.3420201433256688, /* cosine of twist 2 */
    sa2 = 0.9396926207859083, /* sine of twist 2 */
    cat3 = 0.8775825618903728, /* cosine of the angle of joint 3 */
    sat3 = 0.479425538604203, /* sine of the angle of joint 3 */
    a3 = 0.12, /* link length 3 [m] */
    ca3 = 0.766044443118978, /* cosine of twist 3 */
    sa3 = 0.6427876096865393, /* sine of twist 3 */
    d4 = 0.14, /* joint offset 4 [m] */
    a4 = 0.2, /* link length 4 [m] */
    ca4 = 0.42261826174069944, /* cosine of twist 4 */
    sa4 = 0.9063077870366499, /* sine of twist 4 */
    d5 = 0.1, /* joint offset 5 [m] */
    a5 = 0.16, /* link length 5 [m] */
    ca5 = 0.6427876096865394, /* cosine of twist 5 */
    sa5 = 0.766044443118978, /* sine of twist 5 */
    d6 = 0.12, /* joint offset 6 [m] */
    f1 = -0.7701962384697986, /* ca2 * ca1 - sa2 * cat2 * sa1 */
    f2 = -0.12623975606886617, /* cat3 * sat2 * sa1 - sat3 * (ca2 * cat2 * sa1 + sa2 * ca1) */
    f3 = -0.015148770728263941, /* a3 * f2 [m] */
    /* ca3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) - sa3 * f1 */
    f4 = 0.9739951538781595,
    /* d4 * (sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1) [m] */
    f5 = -0.02633971333380174,
    /* sa4 * (sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1) */
    f6 = -0.17051348073383996,
    /* ca4 * (sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1) */
    f7 = -0.0795117418848544,
    /* sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1 */
    g5 = -0.18814080952715528;

#ifndef __CUDACC_RTC__
const char *const general_rpprrr_branches[8] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.8, 0.8, 1.44e-09, 0.4822530864197531, 1.44, 0.05, 0 },
    { 0.0, 0.9, 1.44e-09, 0.4822530864197531, 1.44, 0.028125, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[2] = {
    { { 0, 1, 2, 3, 4, 5 }, 1.0, 0 },
    { { 5, 0, 1, 2, 3, 4 }, 1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[7][12] = {
    { 0.9800665778412416, -0.19866933079506124, 0.0, 0.30725200439388645, 0.06139219947677201,
        0.302857228171841, -0.9510565162951536, -0.018302540677770086, 0.1889457616406404,
        0.9320987052590043, 0.3090169943749475, 1.5422069881142466e-09 },
    { 0.8775825618903728, 0.479425538604203, 0.0, 0.0, -0.16397319142739547, 0.30015091359785295,
        -0.9396926207859084, -0.10069829274999541, -0.45051264084267917, 0.8246578575387761,
        0.3420201433256689, 0.01740675107216298 },
    { 0.28, -0.96, 0.0, 0.3687024052726637, 0.735402665394219, 0.2144924440733139,
        0.6427876096865394, 0.17431437873429476, -0.6170761052990777, -0.17998053071223105,
        0.7660444431189781, 0.10057890222660615 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.6145040087877729, 0.3060339136742996,
        0.29146087016599964, -0.9063077870366499, -0.06460811427924738, 0.6562918457851603,
        0.6250398531287241, 0.42261826174069944, 0.18909503225749508 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.49160320703021826, 0.608042333487267,
        0.2084716571956344, 0.766044443118978, -0.11619000069250957, -0.7246366353828171,
        -0.24844684641696585, 0.6427876096865394, 0.13846985098478687 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.5019354973539834 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.16936510476171932 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    8, /* solutions at most */
    0.32546573682169855, 3.072520043938864, /* the length that is one in the loop, and its inverse
        */
    HUGE_VAL, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, formulations,
    { { 0.6, 1.0, 1.0, 0.28, 0.6896551724137931, 0.32432432432432434 }, /* cosines and sines of what
        is added to the angles in the loop */
        { 0.8, 0.0, 0.0, 0.96, 0.7241379310344828, 0.9459459459459459 } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
        /* links */
    constants,
    0, /* no joint's value is given */
    0, 0,
    0, 0, 0,
};


/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[6] = { 0, 1, 2, 3, 4, 5 };
DHGEN_TABLE int turning[6] = { 1, 0, 0, 1, 1, 1 };
DHGEN_TABLE double unit[6] = { 1.0, 1.44, 1.44, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[6] = {
    0.6944444444444444, 1.0, 1.0, 0.6944444444444444, 0.6944444444444444, 0.6944444444444444,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[6] = {
    -3.141592653589793, -0.5555555555555556, 0.0, -3.141592653589793, -3.141592653589793,
    -3.141592653589793,
};
DHGEN_TABLE double span_width[6] = {
    6.283185307179586, 1.1111111111111112, 0.625, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};
DHGEN_TABLE double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
DHGEN_TABLE double least_u[6] = {
    -HUGE_VAL, -0.5555555555555556, 0.0, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL,
};
DHGEN_TABLE double most_u[6] = {
    HUGE_VAL, 0.5555555555555556, 0.625, HUGE_VAL, HUGE_VAL, HUGE_VAL,
};
/* How the loop counts the joints: which way, and from where. */
DHGEN_TABLE double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 8, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.44, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero, 0, 0,
    general_rpprrr_fk, general_rpprrr_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.5, 0.1, 1.2566370614359172 },
    { 0.2, 0.0, 0.0, 1.2217304763960306 },
    { -0.5, 0.0, 0.12, -0.6981317007977318 },
    { 0.0, 0.14, 0.2, 1.1344640137963142 },
    { 0.0, 0.1, 0.16, -0.8726646259971648 },
    { 0.0, 0.12, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void general_rpprrr_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v2 = c1 * sa1, x2_x = c1 * cat2 - v1 * sat2, x2_y = s1 * cat2 + y1_y * sat2,
        v3 = c1 * sat2 + v1 * cat2, v4 = y1_y * cat2 - s1 * sat2, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, z2_x = v3 * sa2 + z1_x * ca2, v5 = v4 * sa2 + v2 * ca2,
        x3_x = x2_x * cat3 - y2_x * sat3, x3_y = x2_y * cat3 - y2_y * sat3,
        v6 = x2_x * sat3 + y2_x * cat3, v7 = x2_y * sat3 + y2_y * cat3,
        y3_x = v6 * ca3 - z2_x * sa3, y3_y = v7 * ca3 + v5 * sa3, z3_x = v6 * sa3 + z2_x * ca3,
        z3_y = v7 * sa3 - v5 * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = f2 * c4 + f4 * s4, v8 = y3_x * c4 - x3_x * s4,
        v9 = y3_y * c4 - x3_y * s4, v10 = f4 * c4 - f2 * s4, y4_x = v8 * ca4 + z3_x * sa4,
        y4_y = v9 * ca4 + z3_y * sa4, y4_z = v10 * ca4 + f6, z4_x = z3_x * ca4 - v8 * sa4,
        z4_y = z3_y * ca4 - v9 * sa4, z4_z = f7 - v10 * sa4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5, v11 = y4_x * c5 - x4_x * s5,
        v12 = y4_y * c5 - x4_y * s5, v13 = y4_z * c5 - x4_z * s5, y5_x = v11 * ca5 - z4_x * sa5,
        y5_y = v12 * ca5 - z4_y * sa5, y5_z = v13 * ca5 - z4_z * sa5, z5_x = v11 * sa5 + z4_x * ca5,
        z5_y = v12 * sa5 + z4_y * ca5, z5_z = v13 * sa5 + z4_z * ca5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + y5_x * s6; T[1] = y5_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = c1 * a1 + z1_x * q[1] + z2_x * q[2] + x3_x * a3 + x4_x * a4 + z3_x * d4 + x5_x * a5 +
        z4_x * d5 + z5_x * d6;
    T[4] = x5_y * c6 + y5_y * s6; T[5] = y5_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = s1 * a1 - v2 * q[1] - v5 * q[2] + x3_y * a3 + x4_y * a4 + z3_y * d4 + x5_y * a5 + z4_y *
        d5 + z5_y * d6;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = y5_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 + ca1 * q[1] + f1 * q[2] + f3 + x4_z * a4 + f5 + x5_z * a5 + z4_z * d5 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void general_rpprrr_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v2 = c1 * sa1, x2_x = c1 * cat2 - v1 * sat2, x2_y = s1 * cat2 + y1_y * sat2,
        v3 = c1 * sat2 + v1 * cat2, v4 = y1_y * cat2 - s1 * sat2, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, z2_x = v3 * sa2 + z1_x * ca2, v5 = v4 * sa2 + v2 * ca2,
        x3_x = x2_x * cat3 - y2_x * sat3, x3_y = x2_y * cat3 - y2_y * sat3,
        v6 = x2_x * sat3 + y2_x * cat3, v7 = x2_y * sat3 + y2_y * cat3,
        p3_x = c1 * a1 + z1_x * q[1] + z2_x * q[2] + x3_x * a3,
        p3_y = s1 * a1 - v2 * q[1] - v5 * q[2] + x3_y * a3, p3_z = d1 + ca1 * q[1] + f1 * q[2] + f3,
        y3_x = v6 * ca3 - z2_x * sa3, y3_y = v7 * ca3 + v5 * sa3, z3_x = v6 * sa3 + z2_x * ca3,
        z3_y = v7 * sa3 - v5 * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = f2 * c4 + f4 * s4, v8 = y3_x * c4 - x3_x * s4,
        v9 = y3_y * c4 - x3_y * s4, v10 = f4 * c4 - f2 * s4, p4_x = p3_x + x4_x * a4 + z3_x * d4,
        p4_y = p3_y + x4_y * a4 + z3_y * d4, p4_z = p3_z + x4_z * a4 + f5,
        y4_x = v8 * ca4 + z3_x * sa4, y4_y = v9 * ca4 + z3_y * sa4, y4_z = v10 * ca4 + f6,
        z4_x = z3_x * ca4 - v8 * sa4, z4_y = z3_y * ca4 - v9 * sa4, z4_z = f7 - v10 * sa4;
    const double c5 = cos(q[4]), s5 = sin(q[4]),
        p5_x = p4_x + (x4_x * c5 + y4_x * s5) * a5 + z4_x * d5,
        p5_y = p4_y + (x4_y * c5 + y4_y * s5) * a5 + z4_y * d5,
        p5_z = p4_z + (x4_z * c5 + y4_z * s5) * a5 + z4_z * d5,
        z5_x = (y4_x * c5 - x4_x * s5) * sa5 + z4_x * ca5,
        z5_y = (y4_y * c5 - x4_y * s5) * sa5 + z4_y * ca5,
        z5_z = (y4_z * c5 - x4_z * s5) * sa5 + z4_z * ca5, p6_x = p5_x + z5_x * d6,
        p6_y = p5_y + z5_y * d6, p6_z = p5_z + z5_z * d6, v11 = p6_x - p3_x, v12 = p6_y - p3_y,
        v13 = p6_z - p3_z, v14 = p6_x - p4_x, v15 = p6_y - p4_y, v16 = p6_z - p4_z,
        v17 = p6_x - p5_x, v18 = p6_y - p5_y, v19 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = z1_x; J[2] = z2_x; J[3] = z3_y * v13 - g5 * v12;
    J[4] = z4_y * v16 - z4_z * v15; J[5] = z5_y * v19 - z5_z * v18;
    J[6] = p6_x; J[7] = -v2; J[8] = -v5; J[9] = g5 * v11 - z3_x * v13;
    J[10] = z4_z * v14 - z4_x * v16; J[11] = z5_z * v17 - z5_x * v19;
    J[12] = 0.0; J[13] = ca1; J[14] = f1; J[15] = z3_x * v12 - z3_y * v11;
    J[16] = z4_x * v15 - z4_y * v14; J[17] = z5_x * v18 - z5_y * v17;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = g5; J[34] = z4_z; J[35] = z5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    (void)free_joints; (void)moved;
    dhgen_general_rows(&general, &descents, T, NULL, seed, rows, status);
}

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.6944, 0.6944, 0.6944, 1.0, 1.0, 1.0 }, 0.6944444444444444, { 1e-14, 1e-10 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, general_rpprrr_fk, general_rpprrr_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) general_rpprrr_##function
#include "dhgen/functions.h"

/* xarm7: UFACTORY xArm 7
 *
 * Inverse kinematics, generated from robots/xarm7.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/xarm7.yaml. The formulas and where they come from: xarm7.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: fc9fabe66b08c783
 * SPDX-License-Identifier: MIT
 */
#include "xarm7.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 7
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x0u /* what the arm needs of it */
#ifdef XARM7_LANES
#define DHGEN_GENERAL_LANES XARM7_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

static const double
    d1 = 0.267, /* joint offset 1 [m] */
    d3 = 0.293, /* joint offset 3 [m] */
    a3 = 0.0525, /* link length 3 [m] */
    a4 = 0.0775, /* link length 4 [m] */
    d5 = 0.3425, /* joint offset 5 [m] */
    a6 = 0.076, /* link length 6 [m] */
    d7 = 0.097, /* joint offset 7 [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    offset2 = 3.141592653589793; /* offset of joint 2 [rad] */

#ifndef __CUDACC_RTC__
const char *const xarm7_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[7] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 0.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[3] = {
    { { 0, 1, 2, 3, 4, 5 }, 1.0, 0 },
    { { 3, 4, 5, 0, 1, 2 }, 1.0, 0 },
    { { 3, 2, 1, 0, 5, 4 }, -1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[8][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.9230769230769231,
        0.38461538461538464, 0.0, 1.8215640973187067e-10 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.14326909828113846, 0.0, 0.0, -1.0, 0.0,
        0.8823529411764706, 0.47058823529411764, 0.0, 0.7995780151690203 },
    { 0.28, -0.96, 0.0, 0.21149247841501392, 0.0, 0.0, -1.0, -0.4673301538586307, 0.96, 0.28, 0.0,
        0.0 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.7241379310344828,
        0.6896551724137931, 0.0, 0.4673301539754631 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.20739907560698137, 0.0, 0.0, 1.0, 0.0,
        -0.9459459459459459, -0.32432432432432434, 0.0, 0.0 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.26699999993325 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.097 },
};

/* The joints whose values are given, and where they are in the links. */
DHGEN_TABLE dhgen_given_joint given[1] = {
    { 0, 1.0, -0.0, 0 },
};

DHGEN_TABLE dhgen_given_motion motions[1] = {
    { 0, 1.0 },
};

/* Their values at which formulations vanish. */
DHGEN_TABLE dhgen_special_value special[2] = {
    { 0, 1, 1.0, 1e-12, 0x2 },
    { 0, 1, -1.0, 1e-12, 0x2 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.3664432918882389, 2.728935205355018, /* the length that is one in the loop, and its inverse */
    4.000000004, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    3, formulations,
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
    0.8295313148071338, 0.8295313148071338, 0.8295313148071338, 0.8295313148071338,
    0.8295313148071338, 0.8295313148071338,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[6] = {
    -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
DHGEN_TABLE double span_width[6] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};
DHGEN_TABLE double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
/* How the loop counts the joints: which way, and from where. */
DHGEN_TABLE double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double zero[6] = { 3.141592653589793, 3.141592653589793, 0.0, 0.0, 0.0, 0.0 };
DHGEN_TABLE int given_places[1] = { 2 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    7, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 0, 0, /* families of solutions, limits, more entries than joints */
    48, 1.2055000000000002, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, facing, zero, 1, given_places,
    xarm7_fk, xarm7_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[7][4] = {
    { 3.141592653589793, 0.267, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.293, 0.0525, 1.5707963267948966 },
    { 0.0, 0.0, 0.0775, 1.5707963267948966 },
    { 0.0, 0.3425, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.076, -1.5707963267948966 },
    { 0.0, 0.097, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 7, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 9

DHGEN_PUBLIC void xarm7_fk(const double q[7], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + s1 * s3,
        x3_y = x2_y * c3 - c1 * s3, x3_z = s2 * c3, z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3,
        z3_x = x2_x * s3 - s1 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - c2 * s4, z4_z = c2 * c4 + x3_z * s4,
        z4_x = x3_x * s4 - z2_x * c4, z4_y = x3_y * s4 - z2_y * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, y6_x = z3_x * c5 - x4_x * s5,
        y6_y = z3_y * c5 - x4_y * s5, y6_z = z3_z * c5 - x4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), x6_x = x5_x * c6 + z4_x * s6,
        x6_y = x5_y * c6 + z4_y * s6, x6_z = x5_z * c6 + z4_z * s6, z6_x = z4_x * c6 - x5_x * s6,
        z6_y = z4_y * c6 - x5_y * s6, z6_z = z4_z * c6 - x5_z * s6;
    const double c7 = cos(q[6]), s7 = sin(q[6]);
    T[0] = x6_x * c7 + y6_x * s7; T[1] = y6_x * c7 - x6_x * s7; T[2] = z6_x;
    T[3] = x3_x * a3 + z2_x * d3 + x4_x * a4 + z4_x * d5 + x6_x * a6 + z6_x * d7;
    T[4] = x6_y * c7 + y6_y * s7; T[5] = y6_y * c7 - x6_y * s7; T[6] = z6_y;
    T[7] = x3_y * a3 + z2_y * d3 + x4_y * a4 + z4_y * d5 + x6_y * a6 + z6_y * d7;
    T[8] = x6_z * c7 + y6_z * s7; T[9] = y6_z * c7 - x6_z * s7; T[10] = z6_z;
    T[11] = d1 + x3_z * a3 - c2 * d3 + x4_z * a4 + z4_z * d5 + x6_z * a6 + z6_z * d7;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void xarm7_jacobian(const double q[7], double J[42])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + s1 * s3,
        x3_y = x2_y * c3 - c1 * s3, x3_z = s2 * c3, z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3,
        p3_x = x3_x * a3 + z2_x * d3, p3_y = x3_y * a3 + z2_y * d3, p3_z = d1 + x3_z * a3 - c2 * d3,
        z3_x = x2_x * s3 - s1 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - c2 * s4, z4_z = c2 * c4 + x3_z * s4,
        p4_x = p3_x + x4_x * a4, p4_y = p3_y + x4_y * a4, p4_z = p3_z + x4_z * a4,
        z4_x = x3_x * s4 - z2_x * c4, z4_y = x3_y * s4 - z2_y * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, p5_x = p4_x + z4_x * d5,
        p5_y = p4_y + z4_y * d5, p5_z = p4_z + z4_z * d5, z5_x = x4_x * s5 - z3_x * c5,
        z5_y = x4_y * s5 - z3_y * c5, z5_z = x4_z * s5 - z3_z * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), z6_x = z4_x * c6 - x5_x * s6,
        z6_y = z4_y * c6 - x5_y * s6, z6_z = z4_z * c6 - x5_z * s6,
        p6_x = p5_x + (x5_x * c6 + z4_x * s6) * a6, p6_y = p5_y + (x5_y * c6 + z4_y * s6) * a6,
        p6_z = p5_z + (x5_z * c6 + z4_z * s6) * a6, p7_x = p6_x + z6_x * d7,
        p7_y = p6_y + z6_y * d7, p7_z = p6_z + z6_z * d7, v3 = p7_z - d1, v4 = p7_x - p3_x,
        v5 = p7_y - p3_y, v6 = p7_z - p3_z, v7 = p7_x - p4_x, v8 = p7_y - p4_y, v9 = p7_z - p4_z,
        v10 = p7_x - p5_x, v11 = p7_y - p5_y, v12 = p7_z - p5_z, v13 = p7_x - p6_x,
        v14 = p7_y - p6_y, v15 = p7_z - p6_z;
    J[0] = -p7_y; J[1] = -(c1 * v3); J[2] = z2_y * v3 + c2 * p7_y; J[3] = z3_y * v6 - z3_z * v5;
    J[4] = z4_y * v9 - z4_z * v8; J[5] = z5_y * v12 - z5_z * v11; J[6] = z6_y * v15 - z6_z * v14;
    J[7] = p7_x; J[8] = -(s1 * v3); J[9] = -(c2 * p7_x + z2_x * v3); J[10] = z3_z * v4 - z3_x * v6;
    J[11] = z4_z * v7 - z4_x * v9; J[12] = z5_z * v10 - z5_x * v12; J[13] = z6_z * v13 - z6_x * v15;
    J[14] = 0.0; J[15] = s1 * p7_y + c1 * p7_x; J[16] = z2_x * p7_y - z2_y * p7_x;
    J[17] = z3_x * v5 - z3_y * v4; J[18] = z4_x * v8 - z4_y * v7; J[19] = z5_x * v11 - z5_y * v10;
    J[20] = z6_x * v14 - z6_y * v13;
    J[21] = 0.0; J[22] = s1; J[23] = z2_x; J[24] = z3_x; J[25] = z4_x; J[26] = z5_x; J[27] = z6_x;
    J[28] = 0.0; J[29] = -c1; J[30] = z2_y; J[31] = z3_y; J[32] = z4_y; J[33] = z5_y; J[34] = z6_y;
    J[35] = 1.0; J[36] = 0.0; J[37] = -c2; J[38] = z3_z; J[39] = z4_z; J[40] = z5_z; J[41] = z6_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    (void)moved;
    dhgen_general_rows(&general, &descents, T, free_joints, seed, rows, status);
}

DHGEN_TABLE int given_joints[1] = { 2 };
DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    7, 16, 1, DHGEN_POSE, joints, given_joints, 1,
    { 0.8295, 0.8295, 0.8295, 1.0, 1.0, 1.0 }, 0.8295313148071338, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, xarm7_fk, xarm7_jacobian, solve,
    NULL,
};

#define DHGEN_CALLER_GIVES 1
#define DHGEN_NAME(function) xarm7_##function
#include "dhgen/functions.h"

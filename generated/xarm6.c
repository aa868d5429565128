/* xarm6: UFACTORY xArm 6
 *
 * Inverse kinematics, generated from robots/xarm6.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/xarm6.yaml. The formulas and where they come from: xarm6.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 6b6e4a5ccd645cc3
 * SPDX-License-Identifier: MIT
 */
#include "xarm6.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x200u /* what the arm needs of it */
#ifdef XARM6_LANES
#define DHGEN_GENERAL_LANES XARM6_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

static const double
    d1 = 0.267, /* z of axis 2 [m] */
    b2 = 0.0535, /* x of axis 3 [m] */
    h2 = 0.2845, /* z of axis 3 [m] */
    a3 = 0.0775, /* x of axis 4 [m] */
    d4 = 0.3425, /* z of axis 5 [m] */
    a5 = 0.076, /* x of axis 6 [m] */
    d6 = 0.097; /* z of the home pose [m] */

#ifndef __CUDACC_RTC__
const char *const xarm6_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[2] = {
    { { 3, 2, 1, 0, 5, 4 }, -1.0, 0 },
    { { 0, 1, 2, 3, 4, 5 }, 1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[7][12] = {
    { 0.9230769230769231, 0.38461538461538464, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.38461538461538464,
        -0.9230769230769231, 0.0, 7.368497484792287e-10 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.7851450463681914, 0.8823529411764706,
        0.47058823529411764, 0.0, 0.1476459050288163, 0.0, 0.0, 1.0, 0.0 },
    { 0.0, 0.0, 1.0, -0.4726048826830395, 0.28, -0.96, 0.0, 0.21387958205108903, 0.96, 0.28, 0.0,
        0.0 },
    { 0.7241379310344828, 0.6896551724137931, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.6896551724137931,
        -0.7241379310344828, 0.0, -0.4726048831556444 },
    { 0.0, 0.0, 1.0, 0.0, 0.32432432432432434, -0.9459459459459459, 0.0, 0.209739977237197,
        0.9459459459459459, 0.32432432432432434, 0.0, 0.0 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.266999999733 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 0.0, -1.0, -0.097 },
};

DHGEN_TABLE dhgen_wrist wrist = {
    7.368497484792287e-10, -0.0, /* along axes 1 and 5 to S and W */
    0.6382520571082876, /* of the distance from S to the elbow */
    0.9691057615426545, 0.9391659770551684, /* from the elbow to W, and its square */
    -0.9753422209915128, -0.22069787482289702, /* of the angle between the lower arm and axis 4 */
    1.0, 1, 1, /* its side, whether there is one, solutions at a root */
    { 0.0, 1.0, 0.7851450463681914, 0.1476459050288163, -0.945209765838684, 0.21387958205108903,
        0.0, 1.0 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.3623534292370541, 2.7597365425946974, /* the length that is one in the loop, and its inverse
        */
    4.000000004, /* the square of what is out of reach for all links in line */
    0, /* half the order of the zero where a hidden length is infinite */
    2, formulations,
    { { 0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434
        }, /* cosines and sines of what is added to the angles in the loop */
        { 0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459
            } },
    { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } },
        /* links */
    constants,
    0, /* no joint's value is given */
    0, 0,
    0, 0, &wrist,
};


/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[6] = { 0, 1, 2, 3, 4, 5 };
DHGEN_TABLE int turning[6] = { 1, 1, 1, 1, 1, 1 };
DHGEN_TABLE double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[6] = {
    0.8699535839283513, 0.8699535839283513, 0.8699535839283513, 0.8699535839283513,
    0.8699535839283513, 0.8699535839283513,
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
DHGEN_TABLE double facing[6] = { 1.0, 1.0, 1.0, -1.0, 1.0, -1.0 };
DHGEN_TABLE double zero[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 0, 0, /* families of solutions, limits, more entries than joints */
    48, 1.149486614543747, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, facing, zero, 0, 0,
    xarm6_fk, xarm6_jacobian, 0, 0,
};


/* The axes at q = 0: a unit vector along each, and a point of it [m]. */
DHGEN_TABLE double table[6][6] = {
    { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 },
    { 0.0, 1.0, 0.0, 0.0, 0.0, 0.267 },
    { 0.0, 1.0, 0.0, 0.0535, 0.0, 0.5515 },
    { 0.0, 0.0, -1.0, 0.131, 0.0, 0.0 },
    { 0.0, 1.0, 0.0, 0.131, 0.0, 0.20899999999999996 },
    { 0.0, 0.0, -1.0, 0.20700000000000002, 0.0, 0.0 },
};
DHGEN_TABLE double tool[12] = {
    1.0, 0.0, 0.0, 0.20700000000000002, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.11199999999999996,
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_AXES, joints, &table[0][0], NULL, NULL, tool };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void xarm6_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * s2, x2_y = s1 * s2, y2_x = c1 * c2,
        y2_y = s1 * c2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = c2 * c3 - s2 * s3, y3_x = y2_x * c3 - x2_x * s3,
        y3_y = y2_y * c3 - x2_y * s3, v1 = s2 * c3 + c2 * s3;
    const double c4 = cos(-q[3]), s4 = sin(-q[3]), x4_x = y3_x * c4 - s1 * s4,
        x4_y = y3_y * c4 + c1 * s4, v2 = v1 * c4, v3 = s1 * c4 + y3_x * s4,
        y4_y = c1 * c4 - y3_y * s4, y4_z = v1 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x3_x * c5 + x4_x * s5,
        x5_y = x3_y * c5 + x4_y * s5, x5_z = x3_z * c5 - v2 * s5, y5_x = x4_x * c5 - x3_x * s5,
        y5_y = x4_y * c5 - x3_y * s5, v4 = v2 * c5 + x3_z * s5;
    const double c6 = cos(-q[5]), s6 = sin(-q[5]);
    T[0] = y5_x * c6 - v3 * s6; T[1] = v3 * c6 + y5_x * s6; T[2] = -x5_x;
    T[3] = x2_x * h2 + y2_x * b2 + y3_x * a3 - x3_x * d4 + y5_x * a5 - x5_x * d6;
    T[4] = y5_y * c6 + y4_y * s6; T[5] = y5_y * s6 - y4_y * c6; T[6] = -x5_y;
    T[7] = x2_y * h2 + y2_y * b2 + y3_y * a3 - x3_y * d4 + y5_y * a5 - x5_y * d6;
    T[8] = y4_z * s6 - v4 * c6; T[9] = -(y4_z * c6 + v4 * s6); T[10] = -x5_z;
    T[11] = d1 + c2 * h2 - s2 * b2 - v1 * a3 - x3_z * d4 - v4 * a5 - x5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void xarm6_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * s2, x2_y = s1 * s2, y2_x = c1 * c2,
        y2_y = s1 * c2, p3_x = x2_x * h2 + y2_x * b2, p3_y = x2_y * h2 + y2_y * b2,
        p3_z = d1 + c2 * h2 - s2 * b2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = c2 * c3 - s2 * s3, y3_x = y2_x * c3 - x2_x * s3,
        y3_y = y2_y * c3 - x2_y * s3, v1 = s2 * c3 + c2 * s3, p4_x = p3_x + y3_x * a3,
        p4_y = p3_y + y3_y * a3, p4_z = p3_z - v1 * a3;
    const double c4 = cos(-q[3]), s4 = sin(-q[3]), x4_x = y3_x * c4 - s1 * s4,
        x4_y = y3_y * c4 + c1 * s4, v2 = v1 * c4, v3 = s1 * c4 + y3_x * s4,
        y4_y = c1 * c4 - y3_y * s4, y4_z = v1 * s4, p5_x = p4_x - x3_x * d4,
        p5_y = p4_y - x3_y * d4, p5_z = p4_z - x3_z * d4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x3_x * c5 + x4_x * s5,
        x5_y = x3_y * c5 + x4_y * s5, x5_z = x3_z * c5 - v2 * s5,
        p6_x = p5_x + (x4_x * c5 - x3_x * s5) * a5, p6_y = p5_y + (x4_y * c5 - x3_y * s5) * a5,
        p6_z = p5_z - (v2 * c5 + x3_z * s5) * a5, J21 = p6_x - x5_x * d6, v4 = p6_y - x5_y * d6,
        v5 = p6_z - x5_z * d6, v6 = v5 - d1, v7 = v5 - p3_z, v8 = J21 - p4_x, v9 = v4 - p4_y,
        v10 = v5 - p4_z, v11 = J21 - p5_x, v12 = v4 - p5_y, v13 = v5 - p5_z, v14 = J21 - p6_x,
        v15 = v4 - p6_y, v16 = v5 - p6_z;
    J[0] = -v4; J[1] = c1 * v6; J[2] = c1 * v7; J[3] = -(x3_y * v10 + -x3_z * v9);
    J[4] = y4_y * v13 - y4_z * v12; J[5] = -(x5_y * v16 + -x5_z * v15);
    J[6] = J21; J[7] = s1 * v6; J[8] = s1 * v7; J[9] = -x3_z * v8 + x3_x * v10;
    J[10] = y4_z * v11 + v3 * v13; J[11] = -x5_z * v14 + x5_x * v16;
    J[12] = 0.0; J[13] = -(s1 * v4 + c1 * J21); J[14] = -(s1 * (v4 - p3_y) + c1 * (J21 - p3_x));
    J[15] = x3_y * v8 - x3_x * v9; J[16] = -(v3 * v12 + y4_y * v11);
    J[17] = x5_y * v14 - x5_x * v15;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = -x3_x; J[22] = -v3; J[23] = -x5_x;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = -x3_y; J[28] = y4_y; J[29] = -x5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = -x3_z; J[34] = y4_z; J[35] = -x5_z;
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
    6, 16, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.87, 0.87, 0.87, 1.0, 1.0, 1.0 }, 0.8699535839283513, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, xarm6_fk, xarm6_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) xarm6_##function
#include "dhgen/functions.h"

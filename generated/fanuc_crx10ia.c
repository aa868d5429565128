/* fanuc_crx10ia: Fanuc CRX-10iA
 *
 * Inverse kinematics, generated from robots/fanuc_crx10ia.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/fanuc_crx10ia.yaml. The formulas and where they come from:
 * fanuc_crx10ia.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: b745383a2692778c
 * SPDX-License-Identifier: MIT
 */
#include "fanuc_crx10ia.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x200u /* what the arm needs of it */
#ifdef FANUC_CRX10IA_LANES
#define DHGEN_GENERAL_LANES FANUC_CRX10IA_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

static const double
    d1 = 0.245, /* joint offset 1 [m] */
    a2 = 0.54, /* link length 2 [m] */
    d4 = 0.54, /* joint offset 4 [m] */
    d5 = 0.15, /* joint offset 5 [m] */
    d6 = 0.16, /* z of the tool frame [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    offset3 = 3.141592653589793, /* offset of joint 3 [rad] */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset5 = 3.141592653589793; /* offset of joint 5 [rad] */

#ifndef __CUDACC_RTC__
const char *const fanuc_crx10ia_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -3.3161255787892263, 3.3161255787892263, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.139847324337799, 3.139847324337799, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -1.239183768915974, 4.380776422505767, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.3161255787892263, 3.3161255787892263, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.139847324337799, 3.139847324337799, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.9269908169872414, 3.9269908169872414, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[2] = {
    { { 1, 2, 3, 4, 5, 0 }, 1.0, 0 },
    { { 4, 3, 2, 1, 0, 5 }, -1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.9230769230769231,
        0.38461538461538464, 0.0, 4.2052035336045993e-10 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.9268611103097327, -0.8823529411764706,
        -0.47058823529411764, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 },
    { 0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, 0.46343055492315105, 0.96, 0.28, 0.0, 0.0 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0, -0.12873070970087527,
        0.7241379310344828, 0.6896551724137931, 0.0, -0.4634305553865816 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.9459459459459459,
        0.32432432432432434, 0.0, 0.128730709829606 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.24499999975499998 },
    { 0.0, 0.0, -1.0, -0.16, 0.0, -1.0, 0.0, -0.0, -1.0, 0.0, 0.0, -0.0 },
};

DHGEN_TABLE dhgen_wrist wrist = {
    4.2052035336045993e-10, -0.12873070970087527, /* along axes 1 and 5 to S and W */
    0.8590715178045906, /* of the distance from S to the elbow */
    0.9268611103097326, 0.8590715178045903, /* from the elbow to W, and its square */
    -1.0, 0.0, /* of the angle between the lower arm and axis 4 */
    -1.0, 0, 2, /* its side, whether there is one, solutions at a root */
    { 0.0, -1.0, 0.9268611103097327, 0.0, 0.0, 0.9268611103097326, 0.0, -1.0 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.5826115628257897, 1.716409463536542, /* the length that is one in the loop, and its inverse */
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
    0.6116207951070336, 0.6116207951070336, 0.6116207951070336, 0.6116207951070336,
    0.6116207951070336, 0.6116207951070336,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[6] = {
    -3.3161255787892263, -3.139847324337799, -1.239183768915974, -3.3161255787892263,
    -3.139847324337799, -3.9269908169872414,
};
DHGEN_TABLE double span_width[6] = {
    6.632251157578453, 6.279694648675598, 5.619960191421741, 6.632251157578453, 6.279694648675598,
    7.853981633974483,
};
DHGEN_TABLE double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
DHGEN_TABLE double least_u[6] = {
    -3.3161255787892263, -3.139847324337799, -1.239183768915974, -3.3161255787892263,
    -3.139847324337799, -3.9269908169872414,
};
DHGEN_TABLE double most_u[6] = {
    3.3161255787892263, 3.139847324337799, 4.380776422505767, 3.3161255787892263, 3.139847324337799,
    3.9269908169872414,
};
/* How the loop counts the joints: which way, and from where. */
DHGEN_TABLE double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double zero[6] = {
    3.141592653589793, 1.5707963267948966, 3.141592653589793, 3.141592653589793, 3.141592653589793,
    0.0,
};

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.635, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero, 0, 0,
    fanuc_crx10ia_fk, fanuc_crx10ia_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 3.141592653589793, 0.245, 0.0, 1.5707963267948966 },
    { 1.5707963267948966, 0.0, 0.54, 3.141592653589793 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.54, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.15, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE double tool[12] = { 0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -0.16 };
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void fanuc_crx10ia_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2, v3 = q[2] + offset3;
    const double c3 = cos(v3), s3 = sin(v3), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = s2 * c3 - c2 * s3, z3_z = c2 * c3 + s2 * s3,
        z3_x = x2_x * s3 - y2_x * c3, z3_y = x2_y * s3 - y2_y * c3, v4 = q[3] + offset4;
    const double c4 = cos(v4), s4 = sin(v4), x4_x = x3_x * c4 - s1 * s4, x4_y = x3_y * c4 + c1 * s4,
        x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4, z4_y = x3_y * s4 - c1 * c4,
        v5 = q[4] + offset5;
    const double c5 = cos(v5), s5 = sin(v5), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, T11_ = z3_x * c5 - x4_x * s5,
        T21_ = z3_y * c5 - x4_y * s5, T31_ = z3_z * c5 - x4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = T11_; T[1] = x5_x * s6 - z4_x * c6; T[2] = -(x5_x * c6 + z4_x * s6);
    T[3] = x2_x * a2 - z3_x * d4 + z4_x * d5 - -T11_ * d6;
    T[4] = T21_; T[5] = x5_y * s6 - z4_y * c6; T[6] = -(x5_y * c6 + z4_y * s6);
    T[7] = x2_y * a2 - z3_y * d4 + z4_y * d5 - -T21_ * d6;
    T[8] = T31_; T[9] = x5_z * s6 - z4_z * c6; T[10] = -(x5_z * c6 + z4_z * s6);
    T[11] = d1 + s2 * a2 - z3_z * d4 + z4_z * d5 - -T31_ * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void fanuc_crx10ia_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2,
        v3 = q[2] + offset3;
    const double c3 = cos(v3), s3 = sin(v3), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = s2 * c3 - c2 * s3, z3_z = c2 * c3 + s2 * s3,
        z3_x = x2_x * s3 - y2_x * c3, z3_y = x2_y * s3 - y2_y * c3, v4 = q[3] + offset4;
    const double c4 = cos(v4), s4 = sin(v4), z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        p4_x = p2_x - z3_x * d4, p4_y = p2_y - z3_y * d4, p4_z = p2_z - z3_z * d4,
        z4_y = x3_y * s4 - c1 * c4, v5 = q[4] + offset5;
    const double c5 = cos(v5), s5 = sin(v5), p5_x = p4_x + z4_x * d5, p5_y = p4_y + z4_y * d5,
        p5_z = p4_z + z4_z * d5, z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5,
        z5_y = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5, z5_z = x3_z * c4 * s5 - z3_z * c5,
        J21 = p5_x - z5_x * d6, v6 = p5_y - z5_y * d6, v7 = p5_z - z5_z * d6, v8 = v7 - d1,
        v9 = J21 - p2_x, v10 = v6 - p2_y, v11 = v7 - p2_z, v12 = J21 - p4_x, v13 = v6 - p4_y,
        v14 = v7 - p4_z, v15 = J21 - p5_x, v16 = v6 - p5_y, v17 = v7 - p5_z;
    J[0] = -v6; J[1] = -(c1 * v8); J[2] = c1 * v11; J[3] = z3_y * v11 - z3_z * v10;
    J[4] = z4_y * v14 - z4_z * v13; J[5] = z5_y * v17 - z5_z * v16;
    J[6] = J21; J[7] = -(s1 * v8); J[8] = s1 * v11; J[9] = z3_z * v9 - z3_x * v11;
    J[10] = z4_z * v12 - z4_x * v14; J[11] = z5_z * v15 - z5_x * v17;
    J[12] = 0.0; J[13] = s1 * v6 + c1 * J21; J[14] = -(s1 * v10 + c1 * v9);
    J[15] = z3_x * v10 - z3_y * v9; J[16] = z4_x * v13 - z4_y * v12;
    J[17] = z5_x * v16 - z5_y * v15;
    J[18] = 0.0; J[19] = s1; J[20] = -s1; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -c1; J[26] = c1; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
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
    { 0.6116, 0.6116, 0.6116, 1.0, 1.0, 1.0 }, 0.6116207951070336, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 1, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, fanuc_crx10ia_fk, fanuc_crx10ia_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) fanuc_crx10ia_##function
#include "dhgen/functions.h"

/* abb_gofa_5: ABB GoFa CRB 15000-5/0.95
 *
 * Inverse kinematics, generated from robots/abb_gofa_5.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/abb_gofa_5.yaml. The formulas and where they come from:
 * abb_gofa_5.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 25c95d32d8b27f20
 * SPDX-License-Identifier: MIT
 */
#include "abb_gofa_5.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x200u /* what the arm needs of it */
#ifdef ABB_GOFA_5_LANES
#define DHGEN_GENERAL_LANES ABB_GOFA_5_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

static const double
    d1 = 0.265, /* joint offset 1 [m] */
    a2 = 0.444, /* link length 2 [m] */
    a3 = 0.11, /* link length 3 [m] */
    d4 = 0.47, /* joint offset 4 [m] */
    a5 = 0.08, /* link length 5 [m] */
    d6 = 0.101, /* z of the tool frame [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    offset2 = 1.5707963267948966; /* offset of joint 2 [rad] */

#ifndef __CUDACC_RTC__
const char *const abb_gofa_5_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.9269908169872414, 1.4835298641951802, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* In the order in which they are tried. */
DHGEN_TABLE dhgen_formulation formulations[2] = {
    { { 0, 1, 2, 3, 4, 5 }, 1.0, 0 },
    { { 4, 5, 0, 1, 2, 3 }, 1.0, 0 },
};

/* The constants of the loop J(q1) K0 J(q2) ... K4 J(q6) = L T R: K0 ... K4, L and R, three rows of
 * four; of those with joints inside whose values are given, what is before, between and behind
 * these. */
DHGEN_TABLE double constants[7][12] = {
    { 0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.9230769230769231,
        0.38461538461538464, 0.0, 5.203881545049196e-10 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 0.8718955527653943, 0.8823529411764706,
        0.47058823529411764, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 },
    { 0.28, -0.96, 0.0, 0.216010159468904, 0.0, 0.0, 1.0, 0.46147624954373856, -0.96, -0.28, 0.0,
        0.0 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.7241379310344828,
        0.6896551724137931, 0.0, 0.46147625000521486 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.15709829779556655, 0.0, 0.0, 1.0, 0.0,
        -0.9459459459459459, -0.32432432432432434, 0.0, 0.0 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.264999999735 },
    { 0.0, 0.0, 1.0, -0.101, 0.0, -1.0, 0.0, -0.0, 1.0, 0.0, 0.0, -0.0 },
};

DHGEN_TABLE dhgen_wrist wrist = {
    5.203881545049196e-10, -0.0, /* along axes 1 and 5 to S and W */
    0.7602018549320725, /* of the distance from S to the elbow */
    0.9478932985402113, 0.8985017054174421, /* from the elbow to W, and its square */
    0.973688178796424, 0.22788446737788648, /* of the angle between the lower arm and axis 4 */
    1.0, 1, 1, /* its side, whether there is one, solutions at a root */
    { 0.0, -1.0, 0.8718955527653943, 0.0, 0.216010159468904, 0.9229524995489534, 0.0, -1.0 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.509235307591332, 1.9637287224445819, /* the length that is one in the loop, and its inverse */
    4.0000000039999986, /* the square of what is out of reach for all links in line */
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
    0.6802721088435373, 0.6802721088435373, 0.6802721088435373, 0.6802721088435373,
    0.6802721088435373, 0.6802721088435373,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[6] = {
    -3.141592653589793, -3.141592653589793, -3.9269908169872414, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
DHGEN_TABLE double span_width[6] = {
    6.283185307179586, 6.283185307179586, 5.410520681182422, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
};
DHGEN_TABLE double stride[6] = {
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
};
DHGEN_TABLE double least_u[6] = {
    -3.141592653589793, -3.141592653589793, -3.9269908169872414, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
DHGEN_TABLE double most_u[6] = {
    3.141592653589793, 3.141592653589793, 1.4835298641951802, 3.141592653589793, 3.141592653589793,
    3.141592653589793,
};
/* How the loop counts the joints: which way, and from where. */
DHGEN_TABLE double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double zero[6] = { 3.141592653589793, 1.5707963267948966, 0.0, 0.0, 0.0, 0.0 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.4700000000000002, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero, 0, 0,
    abb_gofa_5_fk, abb_gofa_5_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 3.141592653589793, 0.265, 0.0, 1.5707963267948966 },
    { 1.5707963267948966, 0.0, 0.444, 0.0 },
    { 0.0, 0.0, 0.11, -1.5707963267948966 },
    { 0.0, 0.47, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.08, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE double tool[12] = { 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.101 };
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void abb_gofa_5_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v3 * s3,
        x3_y = x2_y * c3 - v4 * s3, x3_z = s2 * c3 + c2 * s3, v5 = v3 * c3 + x2_x * s3,
        v6 = v4 * c3 + x2_y * s3, z3_z = c2 * c3 - s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4,
        y5_y = c1 * c4 - x3_y * s4, z4_z = x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v5 * s5,
        x5_y = x4_y * c5 - v6 * s5, x5_z = x4_z * c5 + z3_z * s5, v7 = v5 * c5 + x4_x * s5,
        v8 = v6 * c5 + x4_y * s5, z5_z = z3_z * c5 - x4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = -v7; T[1] = z4_x * c6 + x5_x * s6; T[2] = x5_x * c6 - z4_x * s6;
    T[3] = x2_x * a2 + x3_x * a3 - v5 * d4 + x5_x * a5 - v7 * d6;
    T[4] = -v8; T[5] = x5_y * s6 - y5_y * c6; T[6] = x5_y * c6 + y5_y * s6;
    T[7] = x2_y * a2 + x3_y * a3 - v6 * d4 + x5_y * a5 - v8 * d6;
    T[8] = z5_z; T[9] = z4_z * c6 + x5_z * s6; T[10] = x5_z * c6 - z4_z * s6;
    T[11] = d1 + s2 * a2 + x3_z * a3 + z3_z * d4 + x5_z * a5 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void abb_gofa_5_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v3 * s3,
        x3_y = x2_y * c3 - v4 * s3, x3_z = s2 * c3 + c2 * s3, v5 = v3 * c3 + x2_x * s3,
        v6 = v4 * c3 + x2_y * s3, z3_z = c2 * c3 - s2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z + x3_z * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        p4_x = p3_x - v5 * d4, p4_y = p3_y - v6 * d4, p4_z = p3_z + z3_z * d4,
        z4_y = x3_y * s4 - c1 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), v7 = v5 * c5 + x4_x * s5, v8 = v6 * c5 + x4_y * s5,
        z5_z = z3_z * c5 - x4_z * s5, p5_x = p4_x + (x4_x * c5 - v5 * s5) * a5,
        p5_y = p4_y + (x4_y * c5 - v6 * s5) * a5, p5_z = p4_z + (x4_z * c5 + z3_z * s5) * a5,
        J21 = p5_x - v7 * d6, v9 = p5_y - v8 * d6, v10 = p5_z + z5_z * d6, v11 = v10 - d1,
        v12 = v10 - p2_z, v13 = J21 - p3_x, v14 = v9 - p3_y, v15 = v10 - p3_z, v16 = J21 - p4_x,
        v17 = v9 - p4_y, v18 = v10 - p4_z, v19 = J21 - p5_x, v20 = v9 - p5_y, v21 = v10 - p5_z;
    J[0] = -v9; J[1] = -(c1 * v11); J[2] = -(c1 * v12); J[3] = -(v6 * v15 + z3_z * v14);
    J[4] = z4_y * v18 - z4_z * v17; J[5] = -(v8 * v21 + z5_z * v20);
    J[6] = J21; J[7] = -(s1 * v11); J[8] = -(s1 * v12); J[9] = z3_z * v13 + v5 * v15;
    J[10] = z4_z * v16 - z4_x * v18; J[11] = z5_z * v19 + v7 * v21;
    J[12] = 0.0; J[13] = s1 * v9 + c1 * J21; J[14] = s1 * (v9 - p2_y) + c1 * (J21 - p2_x);
    J[15] = v6 * v13 - v5 * v14; J[16] = z4_x * v17 - z4_y * v16; J[17] = v8 * v19 - v7 * v20;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = -v5; J[22] = z4_x; J[23] = -v7;
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -v6; J[28] = z4_y; J[29] = -v8;
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
    { 0.6803, 0.6803, 0.6803, 1.0, 1.0, 1.0 }, 0.6802721088435373, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 1, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, abb_gofa_5_fk, abb_gofa_5_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) abb_gofa_5_##function
#include "dhgen/functions.h"

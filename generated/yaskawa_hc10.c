/* yaskawa_hc10: Yaskawa HC10
 *
 * Inverse kinematics, generated from robots/yaskawa_hc10.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/yaskawa_hc10.yaml. The formulas and where they come from:
 * yaskawa_hc10.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 19353001efe6454f
 * SPDX-License-Identifier: MIT
 */
#include "yaskawa_hc10.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 6
#define DHGEN_ROWS 16
#define DHGEN_TRAITS 0x200u /* what the arm needs of it */
#ifdef YASKAWA_HC10_LANES
#define DHGEN_GENERAL_LANES YASKAWA_HC10_LANES
#endif
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/general.h"

static const double
    d1 = 0.275, /* joint offset 1 [m] */
    a2 = 0.7, /* link length 2 [m] */
    d4 = 0.5, /* joint offset 4 [m] */
    d5 = 0.162, /* joint offset 5 [m] */
    d6 = 0.13, /* joint offset 6 [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    offset6 = 3.141592653589793; /* offset of joint 6 [rad] */

#ifndef __CUDACC_RTC__
const char *const yaskawa_hc10_branches[16] = {
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.08726646259971647, 6.19591884457987, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
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
        0.38461538461538464, 0.0, 4.251061542752476e-10 },
    { 0.47058823529411764, -0.8823529411764706, 0.0, 1.0820883031682424, -0.8823529411764706,
        -0.47058823529411764, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 },
    { 0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, 0.3864601080811423, 0.96, 0.28, 0.0, 0.0 },
    { 0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0, 0.1252130750182901,
        0.7241379310344828, 0.6896551724137931, 0.0, -0.38646010846760237 },
    { 0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.9459459459459459,
        0.32432432432432434, 0.0, -0.1252130751435032 },
    { 0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.274999999725 },
    { 1.0, 0.0, 0.0, -0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 0.0, -1.0, -0.13 },
};

DHGEN_TABLE dhgen_wrist wrist = {
    4.251061542752476e-10, 0.1252130750182901, /* along axes 1 and 5 to S and W */
    1.1709150958535262, /* of the distance from S to the elbow */
    0.7729202165487447, 0.5974056611497583, /* from the elbow to W, and its square */
    -1.0, 0.0, /* of the angle between the lower arm and axis 4 */
    -1.0, 0, 2, /* its side, whether there is one, solutions at a root */
    { 0.0, -1.0, 1.0820883031682424, 0.0, 0.0, 0.7729202165487447, 0.0, -1.0 },
};

DHGEN_TABLE dhgen_general_arm general = {
    DHGEN_TRAITS,
    16, /* solutions at most */
    0.6468972984464137, 1.5458404330974893, /* the length that is one in the loop, and its inverse
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
    0.5659309564233164, 0.5659309564233164, 0.5659309564233164, 0.5659309564233164,
    0.5659309564233164, 0.5659309564233164,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[6] = {
    -3.141592653589793, -3.141592653589793, -0.08726646259971647, -3.141592653589793,
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
DHGEN_TABLE double least_u[6] = {
    -3.141592653589793, -3.141592653589793, -0.08726646259971647, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
};
DHGEN_TABLE double most_u[6] = {
    3.141592653589793, 3.141592653589793, 6.19591884457987, 3.141592653589793, 3.141592653589793,
    3.141592653589793,
};
/* How the loop counts the joints: which way, and from where. */
DHGEN_TABLE double facing[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double zero[6] = {
    3.141592653589793, 1.5707963267948966, 1.5707963267948966, 3.141592653589793, 3.141592653589793,
    3.141592653589793,
};

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 16, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.767, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, facing, zero, 0, 0,
    yaskawa_hc10_fk, yaskawa_hc10_jacobian, 0, 0,
};


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 3.141592653589793, 0.275, 0.0, 1.5707963267948966 },
    { 1.5707963267948966, 0.0, 0.7, 3.141592653589793 },
    { 1.5707963267948966, 0.0, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.5, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.162, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.13, 0.0, 3.141592653589793 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void yaskawa_hc10_fk(const double q[6], double T[16])
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
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, z6_x = z3_x * c5 - x4_x * s5,
        z6_y = z3_y * c5 - x4_y * s5, z6_z = z3_z * c5 - x4_z * s5, v6 = q[5] + offset6;
    const double c6 = cos(v6), s6 = sin(v6);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = x5_x * s6 - z4_x * c6; T[2] = z6_x;
    T[3] = x2_x * a2 - z3_x * d4 - z4_x * d5 - -z6_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = x5_y * s6 - z4_y * c6; T[6] = z6_y;
    T[7] = x2_y * a2 - z3_y * d4 - z4_y * d5 - -z6_y * d6;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = x5_z * s6 - z4_z * c6; T[10] = z6_z;
    T[11] = d1 + s2 * a2 - z3_z * d4 - z4_z * d5 - -z6_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void yaskawa_hc10_jacobian(const double q[6], double J[36])
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
    const double c5 = cos(v5), s5 = sin(v5), p5_x = p4_x - z4_x * d5, p5_y = p4_y - z4_y * d5,
        p5_z = p4_z - z4_z * d5, z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5,
        z5_y = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5, z5_z = x3_z * c4 * s5 - z3_z * c5,
        p6_x = p5_x - z5_x * d6, p6_y = p5_y - z5_y * d6, p6_z = p5_z - z5_z * d6, v6 = p6_z - d1,
        v7 = p6_x - p2_x, v8 = p6_y - p2_y, v9 = p6_z - p2_z, v10 = p6_x - p4_x, v11 = p6_y - p4_y,
        v12 = p6_z - p4_z, v13 = p6_x - p5_x, v14 = p6_y - p5_y, v15 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(c1 * v6); J[2] = c1 * v9; J[3] = z3_y * v9 - z3_z * v8;
    J[4] = z4_y * v12 - z4_z * v11; J[5] = z5_y * v15 - z5_z * v14;
    J[6] = p6_x; J[7] = -(s1 * v6); J[8] = s1 * v9; J[9] = z3_z * v7 - z3_x * v9;
    J[10] = z4_z * v10 - z4_x * v12; J[11] = z5_z * v13 - z5_x * v15;
    J[12] = 0.0; J[13] = s1 * p6_y + c1 * p6_x; J[14] = -(s1 * v8 + c1 * v7);
    J[15] = z3_x * v8 - z3_y * v7; J[16] = z4_x * v11 - z4_y * v10; J[17] = z5_x * v14 - z5_y * v13;
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
    { 0.5659, 0.5659, 0.5659, 1.0, 1.0, 1.0 }, 0.5659309564233164, { 1e-14, 1e-10 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */ 1, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, yaskawa_hc10_fk, yaskawa_hc10_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) yaskawa_hc10_##function
#include "dhgen/functions.h"

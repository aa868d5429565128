/* spherical_wrist_general_arm: Spherical wrist on a general arm
 *
 * Inverse kinematics, generated from robots/spherical_wrist_general_arm.yaml and
 * templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/spherical_wrist_general_arm.yaml. The formulas and where they come
 * from: spherical_wrist_general_arm.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: fd0953cc6ef8bfdc
 * SPDX-License-Identifier: MIT
 */
#include "spherical_wrist_general_arm.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/circle_roots.h"
#include "dhgen/frames.h"
#include "dhgen/complete.h"

static const double
    d1 = 0.3, /* joint offset 1 [m] */
    a1 = 0.15, /* link length 1 [m] */
    ca1 = 0.3420201433256688, /* cosine of twist 1 */
    sa1 = 0.9396926207859083, /* sine of twist 1 */
    d2 = 0.12, /* joint offset 2 [m] */
    a2 = 0.42, /* link length 2 [m] */
    ca2 = 0.8191520442889918, /* cosine of twist 2 */
    sa2 = 0.573576436351046, /* sine of twist 2 */
    d3 = 0.08, /* joint offset 3 [m] */
    a3 = 0.11, /* link length 3 [m] */
    ca3 = 0.6427876096865394, /* cosine of twist 3 */
    sa3 = 0.766044443118978, /* sine of twist 3 */
    d4 = 0.37, /* joint offset 4 [m] */
    d6 = 0.09, /* joint offset 6 [m] */
    free_limit6 = 1.9456426971135993e-11, /* a length that fixes no angle [m^6] */
    square_rounding = 1e-15, /* squares are rounded by this */
    free_limit_squared2 = 2.6895999999999994e-24, /* square of a length that fixes no angle [m^2] */
    /* square of a length whose direction is good to few digits [m^2] */
    near_limit_squared2 = 2.6895999999999996e-06,
    free_limit = 1e-12, /* a length that fixes no angle */
    near_limit_squared = 1e-06, /* square of a length whose direction is good to few digits */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    k1 = 0.43938504177070503, /* sa3 * sa2 */
    k2 = 0.16257246545516085, /* d4 * sa3 * sa2 [m] */
    k3 = 0.1314173917092386, /* 2 * (d2 * d4 * sa3 * sa2 + a3 * a2) [m^2] */
    k4 = 0.06309340799861507, /* a3 * sa2 [m] */
    k5 = -0.22294419500171073, /* 2 * (d2 * a3 * sa2 - d4 * sa3 * a2) [m^2] */
    k6 = 0.4829582968126144, /* d1 * ca1 + (d2 + ca2 * (d3 + d4 * ca3)) [m] */
    k7 = 0.6, /* 2 * d1 [m] */
    /* d1^2 + (a1^2 - (d2 * (d2 + 2 * ca2 * (d3 + d4 * ca3)) + (a2^2 + (d3 * (d3 + 2 * d4 * ca3) +
     * (a3^2 + d4^2))))) [m^2] */
    k8 = -0.33423756740902244,
    k9 = 0.5, /* 1 / 2 */
    /* (d4 * sa3 * sa2 * 2 * (d2 * a3 * sa2 - d4 * sa3 * a2) - a3 * sa2 * 2 * (d2 * d4 * sa3 * sa2 +
     * a3 * a2))^2 [m^6] */
    k10 = 0.001983469418708643,
    /* 1 / (a3 * sa2 * 2 * (d2 * d4 * sa3 * sa2 + a3 * a2) - d4 * sa3 * sa2 * 2 * (d2 * a3 * sa2 -
     * d4 * sa3 * a2)) [m^-3] */
    k11 = 22.453665346937772,
    k12 = 0.28343644395402184, /* d4 * sa3 [m] */
    k13 = 0.6275068715971331, /* sa3 * ca2 */
    k14 = 0.23217754249093925, /* d4 * sa3 * ca2 [m] */
    k15 = 0.0901067248717891, /* a3 * ca2 [m] */
    k16 = 0.18230061071109027, /* sa2 * (d3 + d4 * ca3) [m] */
    k17 = 0.3686878264946124, /* ca3 * sa2 */
    k18 = 0.5265407845183633, /* ca3 * ca2 */
    f1 = 0.04104241719908026, /* d2 * ca1 [m] */
    f2 = 0.19617469496901113, /* sa2 * ca1 */
    f3 = 0.2801664995932356; /* ca2 * ca1 */

#ifndef __CUDACC_RTC__
const char *const spherical_wrist_general_arm_branches[8] = {
    "root1-noflip", "root1-flip", "root2-noflip", "root2-flip", "root3-noflip", "root3-flip",
    "root4-noflip", "root4-flip",
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

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[6] = { 0, 1, 2, 3, 4, 5 };
DHGEN_TABLE int turning[6] = { 1, 1, 1, 1, 1, 1 };
DHGEN_TABLE double unit[6] = { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[6] = {
    0.6097560975609756, 0.6097560975609756, 0.6097560975609756, 0.6097560975609756,
    0.6097560975609756, 0.6097560975609756,
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

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    6, 8, /* joints; solutions that are kept */
    6, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 0, 0, /* families of solutions, limits, more entries than joints */
    48, 1.64, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, 0, 0, 0, 0,
    spherical_wrist_general_arm_fk, spherical_wrist_general_arm_jacobian, 0, 0,
};

/* The joints whose values add up to the root of a polynomial, with their signs. */
DHGEN_TABLE struct dhgen_root_turn turns[1] = { { 0, 1.0 } };

DHGEN_TABLE struct dhgen_completion completion = { &descents, turns, 1, 0, /* adds others */ 0, /*
    ascends */ 0, /* equations end all */ 0 };


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.3, 0.15, 1.2217304763960306 },
    { 0.0, 0.12, 0.42, 0.6108652381980153 },
    { 0.0, 0.08, 0.11, -0.8726646259971648 },
    { 0.0, 0.37, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.09, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void spherical_wrist_general_arm_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * ca1, y1_y = c1 * ca1, z1_x = s1 * sa1,
        v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = sa1 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = sa1 * c2, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, y2_z = v5 * ca2 + f2, z2_x = v3 * sa2 + z1_x * ca2,
        v6 = v4 * sa2 + v2 * ca2, z2_z = f3 - v5 * sa2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = x2_z * c3 + y2_z * s3, v7 = y2_x * c3 - x2_x * s3,
        v8 = y2_y * c3 - x2_y * s3, v9 = y2_z * c3 - x2_z * s3, y3_x = v7 * ca3 - z2_x * sa3,
        y3_y = v8 * ca3 + v6 * sa3, y3_z = v9 * ca3 - z2_z * sa3, z3_x = v7 * sa3 + z2_x * ca3,
        z3_y = v8 * sa3 - v6 * ca3, z3_z = v9 * sa3 + z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4, y5_x = y3_x * c4 - x3_x * s4,
        y5_y = y3_y * c4 - x3_y * s4, y5_z = y3_z * c4 - x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, z5_x = z3_x * c5 - x4_x * s5,
        z5_y = z3_y * c5 - x4_y * s5, z5_z = z3_z * c5 - x4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + y5_x * s6; T[1] = y5_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + z3_x * d4 + z5_x * d6;
    T[4] = x5_y * c6 + y5_y * s6; T[5] = y5_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = s1 * a1 + x2_y * a2 - v2 * d2 + x3_y * a3 - v6 * d3 + z3_y * d4 + z5_y * d6;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = y5_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 + x2_z * a2 + f1 + x3_z * a3 + z2_z * d3 + z3_z * d4 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void spherical_wrist_general_arm_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1, v1 = s1 * ca1,
        y1_y = c1 * ca1, z1_x = s1 * sa1, v2 = c1 * sa1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = sa1 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = sa1 * c2, p2_x = p1_x + x2_x * a2 + z1_x * d2,
        p2_y = p1_y + x2_y * a2 - v2 * d2, p2_z = d1 + x2_z * a2 + f1, y2_x = z1_x * sa2 - v3 * ca2,
        y2_y = v4 * ca2 - v2 * sa2, y2_z = v5 * ca2 + f2, z2_x = v3 * sa2 + z1_x * ca2,
        v6 = v4 * sa2 + v2 * ca2, z2_z = f3 - v5 * sa2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = x2_z * c3 + y2_z * s3, v7 = y2_x * c3 - x2_x * s3,
        v8 = y2_y * c3 - x2_y * s3, v9 = y2_z * c3 - x2_z * s3, p3_x = p2_x + x3_x * a3 + z2_x * d3,
        p3_y = p2_y + x3_y * a3 - v6 * d3, p3_z = p2_z + x3_z * a3 + z2_z * d3,
        y3_x = v7 * ca3 - z2_x * sa3, y3_y = v8 * ca3 + v6 * sa3, y3_z = v9 * ca3 - z2_z * sa3,
        z3_x = v7 * sa3 + z2_x * ca3, z3_y = v8 * sa3 - v6 * ca3, z3_z = v9 * sa3 + z2_z * ca3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), p4_x = p3_x + z3_x * d4, p4_y = p3_y + z3_y * d4,
        p4_z = p3_z + z3_z * d4, z4_x = x3_x * s4 - y3_x * c4, z4_y = x3_y * s4 - y3_y * c4,
        z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z5_x = z3_x * c5 - (x3_x * c4 + y3_x * s4) * s5,
        z5_y = z3_y * c5 - (x3_y * c4 + y3_y * s4) * s5,
        z5_z = z3_z * c5 - (x3_z * c4 + y3_z * s4) * s5, p6_x = p4_x + z5_x * d6,
        p6_y = p4_y + z5_y * d6, p6_z = p4_z + z5_z * d6, v10 = p6_x - p1_x, v11 = p6_y - p1_y,
        v12 = p6_z - d1, v13 = p6_x - p2_x, v14 = p6_y - p2_y, v15 = p6_z - p2_z, v16 = p6_x - p3_x,
        v17 = p6_y - p3_y, v18 = p6_z - p3_z, v19 = p6_x - p4_x, v20 = p6_y - p4_y,
        v21 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = -(v2 * v12 + ca1 * v11); J[2] = -(v6 * v15 + z2_z * v14);
    J[3] = z3_y * v18 - z3_z * v17; J[4] = z4_y * v21 - z4_z * v20; J[5] = z5_y * v21 - z5_z * v20;
    J[6] = p6_x; J[7] = ca1 * v10 - z1_x * v12; J[8] = z2_z * v13 - z2_x * v15;
    J[9] = z3_z * v16 - z3_x * v18; J[10] = z4_z * v19 - z4_x * v21;
    J[11] = z5_z * v19 - z5_x * v21;
    J[12] = 0.0; J[13] = z1_x * v11 + v2 * v10; J[14] = z2_x * v14 + v6 * v13;
    J[15] = z3_x * v17 - z3_y * v16; J[16] = z4_x * v20 - z4_y * v19;
    J[17] = z5_x * v20 - z5_y * v19;
    J[18] = 0.0; J[19] = z1_x; J[20] = z2_x; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -v2; J[26] = -v6; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = ca1; J[32] = z2_z; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints;
    DHGEN_ENTRIES(double);

    /* theta1, type 9: U1 A6^-1 [3, 4] and the squared length of column 4 of U1 A6^-1 */
    const double wz = T34 - T33 * d6;
    const double v1 = wz * ca1 - k6;
    const double wy = T24 - d6 * T23;
    const double R1c1 = wy * sa1;
    const double wx = T14 - d6 * T13;
    const double v2 = sa1 * wx, v3 = wx * wx + (wy * wy + (wz * (wz - k7) + k8));
    const double R2c1 = 2.0 * (wx * a1);
    const double R2s1 = 2.0 * (wy * a1);
    const double v4 = k4 * v3 + k5 * -v1, v5 = k4 * R2c1 - k5 * R1c1, v6 = k4 * R2s1 + k5 * v2,
        v7 = k3 * -v1 + k2 * v3, v8 = k3 * R1c1 - k2 * R2c1, v9 = k3 * v2 + k2 * R2s1,
        v10 = v5 * v5, v11 = v6 * v6, v12 = 2.0 * v4, v13 = v8 * v8, v14 = v9 * v9, v15 = 2.0 * v7,
        v16 = v4 * v4 + k9 * (v10 + v11) + (v7 * v7 + k9 * (v13 + v14)), v17 = v8 * v15 - v5 * v12,
        v18 = v6 * v12 + v9 * v15, v19 = k9 * (v10 - v11) + k9 * (v13 - v14),
        v20 = v5 * v6 - v8 * v9, v21 = v16 - k10;
    const int free1 = fabs(v21) + fabs(v17) + fabs(v18) + fabs(v19) + fabs(v20) <= free_limit6;
    double x1_roots[4];
    int x1_close[4];
    dhgen_circle_roots(free1 ? 1.0 : v21, free1 ? -1.0 : v17, free1 ? 0.0 : -v18, free1 ? 0.0 : v19,
        free1 ? 0.0 : v20, square_rounding * (v16 + k10), moved, x1_roots, x1_close);

    /* theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double v22 = ca1 * wy, v23 = ca1 * wx, v24 = sa1 * (wz - d1);

    /* theta4, type 2: U4[3, 3] */
    const double v26 = ca1 * T23, v27 = ca1 * T13, v28 = T33 * sa1, v32 = T23 * sa1,
        v33 = sa1 * T13, v34 = T33 * ca1;

    /* theta6, type 3: U4[3, 2] and U4[3, 1] */
    const double v40 = T32 * sa1, v42 = T32 * ca1, v51 = T31 * sa1, v53 = T31 * ca1;

    /* theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1] */
    const double v62 = T21 * sa1, v63 = sa1 * T11, v65 = T22 * sa1, v66 = sa1 * T12;

    for (int i1 = 0; i1 < 4; i1++) { /* root1, root2, root3, root4 */
        const double x1 = x1_roots[i1];
        /* theta1 */
        if (!(x1 <= 4.0)) continue; /* out of reach */
        const double q1 = free1 ? seed[0] : x1;
        const double c1 = cos(q1), s1 = sin(q1);

        /* theta3, type 3: U1 A6^-1 [3, 4] and the squared length of column 4 of U1 A6^-1 */
        const double Z1_3 = v1 + (v2 * s1 - R1c1 * c1);
        const double Z2_3 = v3 - (R2c1 * c1 + R2s1 * s1);
        const double s3 = (k3 * Z1_3 - k2 * Z2_3) * k11, c3 = (k4 * Z2_3 - k5 * Z1_3) * k11;
        const double q3 = atan2(s3, c3);

        /* theta2 */
        const double X1_2 = a2 + (a3 * c3 - s3 * k12);
        const double Y1_2 = c3 * k14 + s3 * k15 - k16;
        const double Z1_2 = v24 - (s1 * v23 - c1 * v22);
        const double Z2_2 = wx * c1 + wy * s1 - a1;
        const double S2 = X1_2 * Z1_2 - Y1_2 * Z2_2;
        const double C2 = X1_2 * Z2_2 - Z1_2 * -Y1_2;
        const double w2 = sqrt(S2 * S2 + C2 * C2);
        const int free2 = w2 <= free_limit_squared2;
        const int near2 = w2 <= near_limit_squared2;
        const double factor2 = 1.0 / (free2 ? 1.0 : w2);
        const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
            s2 = free2 ? sin(seed[1]) : S2 * factor2;
        const double q2 = atan2(s2, c2);

        /* theta4 */
        const double v25 = T13 * c1 + T23 * s1, v29 = s1 * v27 - c1 * v26 - v28, v30 = ca2 * v29,
            v31 = ca2 * v25;
        const double Z1_5 = s1 * v33 - c1 * v32 + v34;
        const double v35 = c2 * (c3 * v25 - s3 * v30) - s2 * (c3 * v29 + s3 * v31) + sa2 * (s3 *
            Z1_5),
            v36 = c2 * (c3 * (ca3 * v30) + s3 * (ca3 * v25) + sa3 * (sa2 * v29)) + s2 * (c3 * (ca3 *
                v31) - s3 * (ca3 * v29) + sa3 * (sa2 * v25)) + (sa3 * (ca2 * Z1_5) - c3 * (ca3 *
                (sa2 * Z1_5))), v37 = v35 * v35 + v36 * v36;
        const double w4 = sqrt(v37);
        const int free4 = w4 <= free_limit;
        const int near4 = v37 <= near_limit_squared;
        const double divisor4 = free4 ? 1.0 : w4;

        /* theta6 */
        const double v38 = T12 * c1 + T22 * s1, v39 = T22 * c1 - T12 * s1, v41 = ca1 * v39 + v40,
            v43 = v42 - sa1 * v39, v44 = c2 * v38 + s2 * v41, v45 = c2 * v41 - s2 * v38,
            v46 = ca2 * v45 + sa2 * v43, v47 = c3 * v44 + s3 * v46,
            v48 = ca3 * (c3 * v46 - s3 * v44) - sa3 * (ca2 * v43 - sa2 * v45),
            v49 = T11 * c1 + T21 * s1, v50 = T21 * c1 - T11 * s1, v52 = ca1 * v50 + v51,
            v54 = v53 - sa1 * v50, v55 = c2 * v49 + s2 * v52, v56 = c2 * v52 - s2 * v49,
            v57 = ca2 * v56 + sa2 * v54, v58 = c3 * v55 + s3 * v57,
            v59 = ca3 * (c3 * v57 - s3 * v55) - sa3 * (ca2 * v54 - sa2 * v56);

        /* theta5 */
        const double v60 = sa2 * s3, v61 = c3 * k17 - k13;
        const double Y1_5 = k1 * c3 + k18;
        const double v64 = v53 + (s1 * v63 - c1 * v62), v67 = v42 + (s1 * v66 - c1 * v65),
            v68 = Z1_5 * Y1_5;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e4 = i2 == 0 ? 1.0 : -1.0;
            /* theta4 */
            if (e4 < 0.0 && free4) continue; /* both signs give the same */
            const double factor4 = e4 / divisor4;
            const double c4 = free4 ? cos(seed[3]) : v35 * factor4,
                s4 = free4 ? sin(seed[3]) : -(v36 * factor4);
            const double q4 = atan2(s4, c4);

            /* theta6 */
            const double c6 = c4 * v48 - s4 * v47, s6 = c4 * v59 - s4 * v58;
            const double q6 = atan2(s6, c6);

            /* theta5 */
            const double Y2_5 = c4 * v60 + s4 * v61;
            const double Z2_5 = c6 * v64 - s6 * v67;
            const double S5 = Z1_5 * Y2_5 - Y1_5 * Z2_5;
            const double v69 = Y2_5 * Z2_5 + v68;
            const double w5 = sqrt(S5 * S5 + v69 * v69);
            const int free5 = w5 <= free_limit_squared;
            const int near5 = w5 <= near_limit_squared;
            const double v70 = 1.0 / (free5 ? 1.0 : w5);
            const double c5 = free5 ? cos(seed[4]) : v69 * v70,
                s5 = free5 ? sin(seed[4]) : -(S5 * v70);
            const double q5 = atan2(s5, c5);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            q[row][5] = q6;
            status[row] = (free1 || free2 || free4 || free5) ? DHGEN_FREE_JOINT : (x1_close[i1] ||
                near2 || near4 || near5) ? DHGEN_CLOSE : DHGEN_OK;
        }
    }
}

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[4] = { 4, 3, 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.6098, 0.6098, 0.6098, 1.0, 1.0, 1.0 }, 0.6097560975609756, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 4, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ &completion, dhgen_complete_rows,
    NULL, NULL, spherical_wrist_general_arm_fk, spherical_wrist_general_arm_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) spherical_wrist_general_arm_##function
#include "dhgen/functions.h"

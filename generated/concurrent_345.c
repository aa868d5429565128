/* concurrent_345: Arm whose axes 3, 4 and 5 meet
 *
 * Inverse kinematics, generated from robots/concurrent_345.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/concurrent_345.yaml. The formulas and where they come from:
 * concurrent_345.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: c78e090c7343b790
 * SPDX-License-Identifier: MIT
 */
#include "concurrent_345.h"

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
    a1 = 0.2, /* link length 1 [m] */
    sqrt2 = 1.4142135623730951, /* square root of 2 */
    sqrt3 = 1.7320508075688772, /* square root of 3 */
    d2 = 0.1, /* joint offset 2 [m] */
    a2 = 0.35, /* link length 2 [m] */
    d3 = 0.25, /* joint offset 3 [m] */
    d5 = 0.2, /* joint offset 5 [m] */
    a5 = 0.15, /* link length 5 [m] */
    d6 = 0.1, /* joint offset 6 [m] */
    a6 = 0.2, /* link length 6 [m] */
    free_limit6 = 4.0089475140624984e-11, /* a length that fixes no angle [m^6] */
    square_rounding = 1e-15, /* squares are rounded by this */
    free_limit_squared2 = 3.422499999999999e-24, /* square of a length that fixes no angle [m^2] */
    /* square of a length whose direction is good to few digits [m^2] */
    near_limit_squared2 = 3.4224999999999994e-06,
    free_limit = 1e-12, /* a length that fixes no angle */
    near_limit_squared = 1e-06, /* square of a length whose direction is good to few digits */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    k1 = 2.732050807568877, /* sqrt3 + 1 */
    k2 = 0.9659258262890683, /* d3 * sqrt2 * k1 [m] */
    k3 = 0.125, /* 1 / 8 */
    k4 = 0.12074072828613354, /* d3 * sqrt2 * k1 * 1 / 8 [m] */
    k5 = 0.2897777478867205, /* d1 * d3 * sqrt2 * k1 [m^2] */
    k6 = 0.25, /* 1 / 4 */
    k7 = -0.06755556302831987, /* (d1 * d3 * sqrt2 * k1 - 8 * a2 * a1) * 1 / 4 [m^2] */
    k8 = 0.3380740392011739, /* a2 * sqrt2 * k1 / 4 [m] */
    k9 = 0.05, /* d3 * a1 [m^2] */
    k10 = 0.25284442352070435, /* (d1 * a2 * sqrt2 * k1 + 2 * d3 * a1) / 2 [m^2] */
    k11 = 1.6, /* 8 * a6 [m] */
    k12 = 0.4, /* d5 + 2 * d6 [m] */
    k13 = 3.0553429721660432, /* d1 * 8 + sqrt2 * (sqrt3 * (2 * d6 - d3) - (2 * d6 - 3 * d3)) [m] */
    k14 = 0.3, /* 2 * a5 [m] */
    k15 = 0.5, /* 1 / 2 */
    k16 = 0.34641016151377546, /* d5 * sqrt3 [m] */
    k17 = 0.0625, /* d3^2 [m^2] */
    /* d1 * (d1 * 4 + sqrt2 * (sqrt3 * (2 * d6 - d3) - (2 * d6 - 3 * d3))) + 4 * (a1^2 + (sqrt3 * d3
     * * d2 + (d2^2 + (a2^2 + (d3^2 - (d5 * (d5 + d6) + (a5^2 + (d2^2 + a1^2)))))))) [m^2] */
    k18 = 1.1398079724067007,
    k19 = 0.06, /* 2 * a6 * a5 [m^2] */
    k20 = 0.06928203230275509, /* a6 * d5 * sqrt3 [m^2] */
    /* ((d1 * d3 * sqrt2 * k1 - 8 * a2 * a1) * 1 / 4 * a2 * sqrt2 * k1 / 4 - d3 * sqrt2 * k1 * 1 / 8
     * * (d1 * a2 * sqrt2 * k1 + 2 * d3 * a1) / 2)^2 [m^6] */
    k21 = 0.0028480795858198678,
    /* 1 / (d3 * sqrt2 * k1 * 1 / 8 * (d1 * a2 * sqrt2 * k1 + 2 * d3 * a1) / 2 - (d1 * d3 * sqrt2 *
     * k1 - 8 * a2 * a1) * 1 / 4 * a2 * sqrt2 * k1 / 4) [m^-3] */
    k22 = 18.738030414662138,
    k23 = 0.7, /* 2 * a2 [m] */
    k24 = 0.7320508075688772, /* sqrt3 - 1 */
    k25 = 0.1830127018922193, /* d3 * k24 [m] */
    k26 = 0.512435565298214, /* 2 * a2 * k24 [m] */
    k27 = 1.7294228634059947, /* sqrt3 * (2 * d6 + d3) + (2 * d6 + 3 * d3) [m] */
    k28 = -1.2679491924311228, /* sqrt3 - 3 */
    k29 = 4.732050807568877, /* sqrt3 + 3 */
    k30 = 0.8660254037844386, /* sqrt3 / 2 */
    k31 = 0.25881904510252074, /* sqrt2 * k24 / 4 */
    k32 = 0.07764571353075622, /* sqrt2 * d1 * k24 * 1 / 4 [m] */
    k33 = 7.698003589195011, /* 1 / (a5 * sqrt3 / 2) [m^-1] */
    f1 = 0.25881904510252074, /* 1 / 4 * sqrt2 * sqrt3 - 1 / 4 * sqrt2 */
    f2 = 0.9659258262890683, /* 1 / 4 * sqrt2 * sqrt3 + 1 / 4 * sqrt2 */
    f3 = 0.025881904510252077, /* d2 * f1 [m] */
    f5 = 0.8660254037844386, /* 1 / 2 * sqrt3 */
    f6 = 0.12940952255126037, /* 1 / 2 * f1 */
    f7 = 0.22414386804201336; /* 1 / 2 * sqrt3 * f1 */

#ifndef __CUDACC_RTC__
const char *const concurrent_345_branches[8] = {
    "root1-elbow+", "root1-elbow-", "root2-elbow+", "root2-elbow-", "root3-elbow+", "root3-elbow-",
    "root4-elbow+", "root4-elbow-",
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
    0.5405405405405406, 0.5405405405405406, 0.5405405405405406, 0.5405405405405406,
    0.5405405405405406, 0.5405405405405406,
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
    48, 1.8499999999999999, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, 0, 0, 0, 0,
    concurrent_345_fk, concurrent_345_jacobian, 0, 0,
};

/* The joints whose values add up to the root of a polynomial, with their signs. */
DHGEN_TABLE struct dhgen_root_turn turns[1] = { { 5, 1.0 } };

DHGEN_TABLE struct dhgen_completion completion = { &descents, turns, 1, 0, /* adds others */ 0, /*
    ascends */ 0, /* equations end all */ 0 };


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.3, 0.2, 1.3089969389957472 },
    { 0.0, 0.1, 0.35, 0.5235987755982988 },
    { 0.0, 0.25, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.2, 0.15, 1.0471975511965976 },
    { 0.0, 0.1, 0.2, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void concurrent_345_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * f1, y1_y = c1 * f1, z1_x = s1 * f2,
        v2 = c1 * f2;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = f2 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = f2 * c2, y2_x = z1_x * k15 - v3 * f5,
        y2_y = v4 * f5 - v2 * k15, y2_z = v5 * f5 + f6, z2_x = v3 * k15 + z1_x * f5,
        v6 = v4 * k15 + v2 * f5, z2_z = f7 - v5 * k15;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = x2_z * c3 + y2_z * s3, y4_x = y2_x * c3 - x2_x * s3,
        y4_y = y2_y * c3 - x2_y * s3, y4_z = y2_z * c3 - x2_z * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 - v6 * s4, x4_z = x3_z * c4 + z2_z * s4, z4_x = z2_x * c4 - x3_x * s4,
        v7 = v6 * c4 + x3_y * s4, z4_z = z2_z * c4 - x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5, v8 = y4_x * c5 - x4_x * s5,
        v9 = y4_y * c5 - x4_y * s5, v10 = y4_z * c5 - x4_z * s5, y5_x = k15 * v8 + f5 * z4_x,
        y5_y = k15 * v9 - f5 * v7, y5_z = k15 * v10 + f5 * z4_z, z5_x = k15 * z4_x - f5 * v8,
        v11 = f5 * v9 + k15 * v7, z5_z = k15 * z4_z - f5 * v10;
    const double c6 = cos(q[5]), s6 = sin(q[5]), x6_x = x5_x * c6 + y5_x * s6,
        x6_y = x5_y * c6 + y5_y * s6, x6_z = x5_z * c6 + y5_z * s6;
    T[0] = x6_x; T[1] = y5_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = c1 * a1 + x2_x * a2 + z1_x * d2 + z2_x * d3 + x5_x * a5 + z4_x * d5 + x6_x * a6 + z5_x *
        d6;
    T[4] = x6_y; T[5] = y5_y * c6 - x5_y * s6; T[6] = -v11;
    T[7] = s1 * a1 + x2_y * a2 - v2 * d2 - v6 * d3 + x5_y * a5 - v7 * d5 + x6_y * a6 - v11 * d6;
    T[8] = x6_z; T[9] = y5_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 + x2_z * a2 + f3 + z2_z * d3 + x5_z * a5 + z4_z * d5 + x6_z * a6 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void concurrent_345_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1, v1 = s1 * f1,
        y1_y = c1 * f1, z1_x = s1 * f2, v2 = c1 * f2;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = f2 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = f2 * c2, p2_x = p1_x + x2_x * a2 + z1_x * d2,
        p2_y = p1_y + x2_y * a2 - v2 * d2, p2_z = d1 + x2_z * a2 + f3, y2_x = z1_x * k15 - v3 * f5,
        y2_y = v4 * f5 - v2 * k15, y2_z = v5 * f5 + f6, z2_x = v3 * k15 + z1_x * f5,
        v6 = v4 * k15 + v2 * f5, z2_z = f7 - v5 * k15;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = x2_z * c3 + y2_z * s3, y4_x = y2_x * c3 - x2_x * s3,
        y4_y = y2_y * c3 - x2_y * s3, y4_z = y2_z * c3 - x2_z * s3, p3_x = p2_x + z2_x * d3,
        p3_y = p2_y - v6 * d3, p3_z = p2_z + z2_z * d3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 - v6 * s4, x4_z = x3_z * c4 + z2_z * s4, z4_x = z2_x * c4 - x3_x * s4,
        v7 = v6 * c4 + x3_y * s4, z4_z = z2_z * c4 - x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = x4_z * c5 + y4_z * s5, v8 = y4_x * c5 - x4_x * s5,
        v9 = y4_y * c5 - x4_y * s5, v10 = y4_z * c5 - x4_z * s5,
        p5_x = p3_x + x5_x * a5 + z4_x * d5, p5_y = p3_y + x5_y * a5 - v7 * d5,
        p5_z = p3_z + x5_z * a5 + z4_z * d5, z5_x = k15 * z4_x - f5 * v8, v11 = f5 * v9 + k15 * v7,
        z5_z = k15 * z4_z - f5 * v10;
    const double c6 = cos(q[5]), s6 = sin(q[5]),
        p6_x = p5_x + (x5_x * c6 + (k15 * v8 + f5 * z4_x) * s6) * a6 + z5_x * d6,
        p6_y = p5_y + (x5_y * c6 + (k15 * v9 - f5 * v7) * s6) * a6 - v11 * d6,
        p6_z = p5_z + (x5_z * c6 + (k15 * v10 + f5 * z4_z) * s6) * a6 + z5_z * d6,
        v12 = p6_x - p1_x, v13 = p6_y - p1_y, v14 = p6_z - d1, v15 = p6_x - p2_x, v16 = p6_y - p2_y,
        v17 = p6_z - p2_z, v18 = p6_x - p3_x, v19 = p6_y - p3_y, v20 = p6_z - p3_z,
        v21 = p6_x - p5_x, v22 = p6_y - p5_y, v23 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(v2 * v14 + f1 * v13); J[2] = -(v6 * v17 + z2_z * v16);
    J[3] = -y4_y * v20 - -y4_z * v19; J[4] = -(v7 * v20 + z4_z * v19);
    J[5] = -(v11 * v23 + z5_z * v22);
    J[6] = p6_x; J[7] = f1 * v12 - z1_x * v14; J[8] = z2_z * v15 - z2_x * v17;
    J[9] = -y4_z * v18 - -y4_x * v20; J[10] = z4_z * v18 - z4_x * v20;
    J[11] = z5_z * v21 - z5_x * v23;
    J[12] = 0.0; J[13] = z1_x * v13 + v2 * v12; J[14] = z2_x * v16 + v6 * v15;
    J[15] = -y4_x * v19 - -y4_y * v18; J[16] = z4_x * v19 + v7 * v18;
    J[17] = z5_x * v22 + v11 * v21;
    J[18] = 0.0; J[19] = z1_x; J[20] = z2_x; J[21] = -y4_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -v2; J[26] = -v6; J[27] = -y4_y; J[28] = -v7; J[29] = -v11;
    J[30] = 1.0; J[31] = f1; J[32] = z2_z; J[33] = -y4_z; J[34] = z4_z; J[35] = z5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints;
    DHGEN_ENTRIES(double);

    /* theta6, type 9: U0 (A5 A6)^-1 [3, 4] and the squared length of column 4 of A5 A6 U0^-1 */
    const double v1 = T31 * k11 + (T33 * k11 + (k13 - 8.0 * T34));
    const double R1_6 = k3 * v1;
    const double v2 = T31 * k14 + d5 * (sqrt3 * T32);
    const double R1c6 = v2 * k15;
    const double v3 = T31 * k16 - 2.0 * (T32 * a5);
    const double R1s6 = k15 * v3;
    const double v4 = T14 * T11 + T24 * T21 + T31 * T34, v5 = T14 * T12 + T24 * T22 + T32 * T34,
        v6 = T14 * T13 + T24 * T23 + T33 * T34,
        v7 = v5 * (4.0 * v5) - (v6 * (4.0 * (k12 - v6)) + k18) - v4 * (4.0 * (k12 - v4));
    const double R2_6 = k6 * -v7;
    const double v8 = k19 - k16 * v5 - k14 * v4, v9 = k14 * v5 + k20 - k16 * v4,
        v10 = k8 * R2_6 - k10 * R1_6, v11 = k8 * -v8 - k10 * R1c6, v12 = k8 * -v9 - k10 * R1s6,
        v13 = k4 * R2_6 - k7 * R1_6, v14 = k4 * -v8 - k7 * R1c6, v15 = k4 * -v9 - k7 * R1s6,
        v16 = v11 * v11, v17 = v12 * v12, v18 = 2.0 * v10, v19 = v14 * v14, v20 = v15 * v15,
        v21 = 2.0 * v13, v22 = v10 * v10 + k15 * (v16 + v17) + (v13 * v13 + k15 * (v19 + v20)),
        v23 = v11 * v18 + v14 * v21, v24 = v12 * v18 + v15 * v21,
        v25 = k15 * (v16 - v17) + k15 * (v19 - v20), v26 = v11 * v12 + v14 * v15, v27 = v22 - k21;
    const int free6 = fabs(v27) + fabs(v23) + fabs(v24) + fabs(v25) + fabs(v26) <= free_limit6;
    double x6_roots[4];
    int x6_close[4];
    dhgen_circle_roots(free6 ? 1.0 : v27, free6 ? -1.0 : v23, free6 ? 0.0 : v24, free6 ? 0.0 : v25,
        free6 ? 0.0 : v26, square_rounding * (v22 + k21), moved, x6_roots, x6_close);

    /* theta2, type 3: U0 (A5 A6)^-1 [3, 4] and the squared length of column 4 of A5 A6 U0^-1 */
    const double v28 = 4.0 * v2, v29 = 4.0 * v3, v31 = 4.0 * v8, v32 = 4.0 * v9;

    /* theta1, type 3: U0 (A5 A6)^-1 [2, 4] and U0 (A5 A6)^-1 [1, 4] */
    const double v33 = sqrt3 * T22, v34 = k14 * T21 + d5 * v33, v35 = k16 * T21 - 2.0 * (a5 * T22),
        v36 = k12 * T21 + (k12 * T23 - 2.0 * T24), v38 = sqrt3 * T12, v39 = k14 * T11 + d5 * v38,
        v40 = k16 * T11 - 2.0 * (a5 * T12), v41 = k12 * T11 + (k12 * T13 - 2.0 * T14);

    /* theta3, type 2: U3 (A5 A6)^-1 [3, 3] */
    const double v44 = sqrt3 * T11, v45 = T22 * k28, v46 = T21 * k28, v47 = T23 * k24,
        v48 = sqrt3 * T21, v49 = T12 * k28, v50 = T11 * k28, v51 = T13 * k24, v52 = T32 * k29,
        v53 = T31 * k29, v54 = k1 * T33, v56 = 3.0 * (T22 * k24), v57 = 3.0 * (T21 * k24),
        v58 = T23 * k28, v59 = 3.0 * T12, v60 = 3.0 * T11, v61 = sqrt3 * T13, v62 = T22 * k29,
        v63 = T21 * k29, v64 = k1 * T23, v65 = 3.0 * (T12 * k24), v66 = 3.0 * (T11 * k24),
        v67 = T13 * k28, v68 = 3.0 * T22, v69 = 3.0 * T21, v70 = sqrt3 * T23, v71 = T12 * k29,
        v72 = T11 * k29, v73 = k1 * T13, v74 = 3.0 * (k1 * T32), v75 = 3.0 * (k1 * T31),
        v76 = T33 * k29, v77 = T32 * k28, v78 = T31 * k28, v79 = T33 * k24;

    /* theta5, type 3: U3 A6^-1 [3, 3] and U3 A6^-1 [3, 4] */
    const double v81 = sqrt2 * v58, v82 = 4.0 * v61, v83 = sqrt2 * v64, v84 = sqrt2 * v67,
        v85 = 4.0 * v70, v86 = sqrt2 * v73, v88 = 4.0 * T13, v89 = sqrt2 * v47, v90 = 4.0 * T23,
        v91 = sqrt2 * v51;
    const double wx = T14 - a6 * T11 - d6 * T13;
    const double wy = T24 - a6 * T21 - d6 * T23;
    const double wz = T34 - T31 * a6 - T33 * d6;
    const double v94 = k2 * wz, v95 = wz * k31;

    /* theta4, type 3: U3[2, 3] and U3[1, 3] */
    const double v102 = sqrt2 * (T23 * k29), v103 = sqrt2 * (T13 * k29);

    for (int i1 = 0; i1 < 4; i1++) { /* root1, root2, root3, root4 */
        const double x6 = x6_roots[i1];
        /* theta6 */
        if (!(x6 <= 4.0)) continue; /* out of reach */
        const double q6 = free6 ? seed[5] : x6;
        const double c6 = cos(q6), s6 = sin(q6);

        /* theta2 */
        const double v30 = k3 * (v1 + (c6 * v28 + s6 * v29));
        const double Z2_2 = k6 * (v7 + (c6 * v31 + s6 * v32));
        const double s2 = (k7 * v30 + k4 * Z2_2) * k22, c2 = (k8 * Z2_2 + k10 * v30) * k22;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double X1_1 = k15 * (k12 + (c2 * k23 + d3 * s2));
        const double X2_1 = k3 * (sqrt2 * (c2 * k25 - s2 * k26 + k27));
        const double v37 = k15 * (c6 * v34 + s6 * v35 + v36),
            v42 = k15 * (c6 * v39 + s6 * v40 + v41), v43 = X1_1 * v37 + X2_1 * v42;
        const double C1 = X2_1 * v37 - X1_1 * v42;
        const double w1 = sqrt(v43 * v43 + C1 * C1);
        const int free1 = w1 <= free_limit_squared2;
        const int near1 = w1 <= near_limit_squared2;
        const double factor1 = 1.0 / (free1 ? 1.0 : w1);
        const double c1 = free1 ? cos(seed[0]) : C1 * factor1,
            s1 = free1 ? sin(seed[0]) : -(v43 * factor1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double v55 = k3 * (c1 * (c2 * (4.0 * (T13 + (c6 * v38 + s6 * v44))) - s2 * (sqrt2 *
            (c6 * v45 + s6 * v46 - v47))) + s1 * (c2 * (4.0 * (T23 + (c6 * v33 + s6 * v48))) + s2 *
            (sqrt2 * (c6 * v49 + s6 * v50 - v51))) + sqrt2 * (s2 * (c6 * v52 + s6 * v53 + v54)));
        const double Y3 = k17 * (sqrt2 * (c2 * (c6 * v74 + s6 * v75 + v76) + (v79 - (c6 * v77 + s6 *
            v78))) - (c1 * (s2 * (4.0 * (c6 * v59 + s6 * v60 + v61)) - c2 * (sqrt2 * (c6 * v56 + s6
            * v57 - v58)) + sqrt2 * (c6 * v62 + s6 * v63 + v64)) + s1 * (c2 * (sqrt2 * (c6 * v65 +
            s6 * v66 - v67)) + s2 * (4.0 * (c6 * v68 + s6 * v69 + v70)) - sqrt2 * (c6 * v71 + s6 *
            v72 + v73))));
        const double v80 = v55 * v55 + Y3 * Y3;
        const double w3 = sqrt(v80);
        const int free3 = w3 <= free_limit;
        const int near3 = v80 <= near_limit_squared;
        const double divisor3 = free3 ? 1.0 : w3;

        /* theta5 */
        const double v87 = c1 * (c2 * v81 + s2 * v82 + v83) - s1 * (c2 * v84 - s2 * v85 + v86) -
            sqrt2 * (T33 * (k24 + c2 * k29)),
            v92 = 2.0 * (c1 * (c2 * v88 + s2 * v89) + s1 * (c2 * v90 - s2 * v91) + sqrt2 * (s2 *
                v54)), v93 = c1 * wy - s1 * wx, v96 = c1 * wx + s1 * wy - a1,
            v97 = k31 * v93 + v94 - k5, v98 = c2 * v96 + s2 * v97 - a2,
            v99 = k30 * (c2 * v97 - s2 * v96) + k15 * (v95 - k2 * v93 - k32) - k9;

        /* theta4 */
        const double Z1_4 = k3 * (c1 * (s2 * v88 - c2 * v89 - v102) + s1 * (c2 * v91 + s2 * v90 +
            v103) - sqrt2 * (T33 * (k28 + k1 * c2)));
        const double v105 = k15 * Z1_4;

        for (int i2 = 0; i2 < 2; i2++) { /* elbow+, elbow- */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && free3) continue; /* both signs give the same */
            const double factor3 = e3 / divisor3;
            const double c3 = free3 ? cos(seed[2]) : v55 * factor3,
                s3 = free3 ? sin(seed[2]) : Y3 * factor3;
            const double q3 = atan2(s3, c3);

            /* theta5 */
            const double v100 = k30 * (s3 * v98 - c3 * v99) * k33;
            const double c5 = a5 * (k3 * (c3 * v87 + s3 * v92)) * k33;
            const double q5 = atan2(-v100, c5);

            /* theta4 */
            const double v101 = k15 * (sqrt3 * v100);
            const double Z2_4 = k3 * (c3 * v92 + s3 * -v87);
            const double v104 = v101 * Z1_4 + k15 * Z2_4;
            const double C4 = v105 - v101 * Z2_4;
            const double w4 = sqrt(v104 * v104 + C4 * C4);
            const int free4 = w4 <= free_limit_squared;
            const int near4 = w4 <= near_limit_squared;
            const double factor4 = 1.0 / (free4 ? 1.0 : w4);
            const double c4 = free4 ? cos(seed[3]) : C4 * factor4,
                s4 = free4 ? sin(seed[3]) : -(v104 * factor4);
            const double q4 = atan2(s4, c4);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            q[row][5] = q6;
            status[row] = (free1 || free3 || free4 || free6) ? DHGEN_FREE_JOINT : (x6_close[i1] ||
                near1 || near3 || near4) ? DHGEN_CLOSE : DHGEN_OK;
        }
    }
}

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[4] = { 5, 3, 2, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.5405, 0.5405, 0.5405, 1.0, 1.0, 1.0 }, 0.5405405405405406, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 4, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ &completion, dhgen_complete_rows,
    NULL, NULL, concurrent_345_fk, concurrent_345_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) concurrent_345_##function
#include "dhgen/functions.h"

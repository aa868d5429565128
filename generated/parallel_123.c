/* parallel_123: Arm whose axes 1, 2 and 3 are parallel
 *
 * Inverse kinematics, generated from robots/parallel_123.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/parallel_123.yaml. The formulas and where they come from:
 * parallel_123.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 7a430d01fc79c886
 * SPDX-License-Identifier: MIT
 */
#include "parallel_123.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/circle_roots.h"
#include "dhgen/frames.h"
#include "dhgen/complete.h"

/* In formulas below, d1 = 0.1 [m], d2 = 0.05 [m], d3 = 0.08 [m]. */
static const double
    a1 = 0.3, /* link length 1 [m] */
    a2 = 0.25, /* link length 2 [m] */
    a3 = 0.1, /* link length 3 [m] */
    d4 = 0.2, /* joint offset 4 [m] */
    a4 = 0.1, /* link length 4 [m] */
    sqrt3 = 1.7320508075688772, /* square root of 3 */
    d5 = 0.15, /* joint offset 5 [m] */
    a5 = 0.12, /* link length 5 [m] */
    ca5 = 0.17364817766693041, /* cosine of twist 5 */
    sa5 = 0.984807753012208, /* sine of twist 5 */
    d6 = 0.1, /* joint offset 6 [m] */
    a6 = 0.05, /* link length 6 [m] */
    free_limit2 = 2.5599999999999996e-12, /* a length that fixes no angle [m^2] */
    square_rounding = 1e-15, /* squares are rounded by this */
    near_limit = 0.001, /* a length whose direction is good to few digits */
    double_root = 1e-13, /* a polynomial's value at a root, relative to its coefficients */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    near_limit_squared = 1e-06, /* square of a length whose direction is good to few digits */
    longest2 = 0.30250000000000005, /* square of the longest reach [m^2] */
    shortest2 = 0.0024999999999999988, /* square of the shortest reach [m^2] */
    longest2_reach = 0.30251760025600005, /* the longest, with what rounding adds [m^2] */
    shortest2_reach = 0.0024984002559999986, /* the shortest, with what rounding adds [m^2] */
    longest2_apart = 0.30249999999998245, /* the longest, where branches merge [m^2] */
    shortest2_apart = 0.002500000000001599, /* the shortest, where branches merge [m^2] */
    longest2_clear = 0.30249999998240007, /* the longest, where blurred branches do [m^2] */
    shortest2_clear = 0.002500000001599999, /* the shortest, where blurred branches do [m^2] */
    free_limit_squared2 = 2.5599999999999994e-24, /* square of a length that fixes no angle [m^2] */
    /* square of a length whose direction is good to few digits [m^2] */
    near_limit_squared2 = 2.5599999999999996e-06,
    k1 = 0.5, /* 1 / 2 */
    k2 = 0.8660254037844386, /* sqrt3 * 1 / 2 */
    k3 = 0.12604722665003956, /* d5 * ca5 + d6 [m] */
    k4 = 0.23, /* d1 + (d2 + d3) [m] */
    k5 = 0.1477211629518312, /* sa5 * d5 [m] */
    k6 = 0.0075, /* (sqrt3 * 1 / 2 * a4)^2 [m^2] */
    k7 = -11.547005383792515, /* -1 / (sqrt3 * 1 / 2 * a4) [m^-1] */
    k8 = 0.8528685319524432, /* sa5 * sqrt3 * 1 / 2 */
    k9 = 1.1906015685221298, /* 1 / (sa5 * sqrt3 * 1 / 2 * sa5) */
    k10 = 0.008682408883346522, /* a6 * ca5 [m] */
    k11 = 0.0984807753012208, /* d6 * sa5 [m] */
    k12 = 0.2, /* 2 * a4 [m] */
    k13 = 0.0492403876506104, /* a6 * sa5 [m] */
    k14 = 0.16736481776669304, /* d5 + d6 * ca5 [m] */
    k15 = 0.567364817766693, /* d4 * 2 + k14 [m] */
    k16 = 0.1525, /* a1^2 + a2^2 [m^2] */
    k17 = 6.666666666666667, /* 1 / (2 * a2 * a1) [m^-2] */
    k18 = 0.55, /* d4 * 2 + d5 [m] */
    k19 = 0.25980762113533157, /* d5 * sqrt3 [m] */
    f1 = 0.23, /* d1 + d2 + d3 [m] */
    g1 = 0.23; /* d1 + d2 + d3 [m] */

#ifndef __CUDACC_RTC__
const char *const parallel_123_branches[8] = {
    "root1-right", "root1-left", "root2-right", "root2-left", "root3-right", "root3-left",
    "root4-right", "root4-left",
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
DHGEN_TABLE double measure[6] = { 0.625, 0.625, 0.625, 0.625, 0.625, 0.625 };
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
    48, 1.5999999999999999, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, 0, 0, 0, 0,
    parallel_123_fk, parallel_123_jacobian, 0, 0,
};

/* The joints whose values add up to the root of a polynomial, with their signs. */
DHGEN_TABLE struct dhgen_root_turn turns[1] = { { 5, 1.0 } };

DHGEN_TABLE struct dhgen_completion completion = { &descents, turns, 1, 0, /* adds others */ 0, /*
    ascends */ 0, /* equations end all */ 0 };


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.1, 0.3, 0.0 },
    { 0.0, 0.05, 0.25, 0.0 },
    { 0.0, 0.08, 0.1, 1.5707963267948966 },
    { 0.0, 0.2, 0.1, 1.0471975511965976 },
    { 0.0, 0.15, 0.12, 1.3962634015954636 },
    { 0.0, 0.1, 0.05, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void parallel_123_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - x2_y * s3,
        x3_y = x2_y * c3 + x2_x * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4, x4_y = x3_y * c4, v1 = x3_x * s4,
        v2 = x3_y * s4, y4_z = c4 * k1, y4_x = x3_y * k2 - v1 * k1, y4_y = -x3_x * k2 - v2 * k1,
        v3 = c4 * k2, z4_x = v1 * k2 + x3_y * k1, z4_y = v2 * k2 + -x3_x * k1;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = s4 * c5 + y4_z * s5, v4 = y4_x * c5 - x4_x * s5,
        v5 = y4_y * c5 - x4_y * s5, v6 = y4_z * c5 - s4 * s5, y5_x = v4 * ca5 + z4_x * sa5,
        y5_y = v5 * ca5 + z4_y * sa5, y5_z = v6 * ca5 - v3 * sa5, z5_x = z4_x * ca5 - v4 * sa5,
        z5_y = z4_y * ca5 - v5 * sa5, v7 = v6 * sa5 + v3 * ca5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), x6_x = x5_x * c6 + y5_x * s6,
        x6_y = x5_y * c6 + y5_y * s6, x6_z = x5_z * c6 + y5_z * s6;
    T[0] = x6_x; T[1] = y5_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = c1 * a1 + x2_x * a2 + x3_x * a3 + x4_x * a4 + x3_y * d4 + x5_x * a5 + z4_x * d5 + x6_x *
        a6 + z5_x * d6;
    T[4] = x6_y; T[5] = y5_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = s1 * a1 + x2_y * a2 + x3_y * a3 + x4_y * a4 + -x3_x * d4 + x5_y * a5 + z4_y * d5 + x6_y *
        a6 + z5_y * d6;
    T[8] = x6_z; T[9] = y5_z * c6 - x5_z * s6; T[10] = -v7;
    T[11] = f1 + s4 * a4 + x5_z * a5 - v3 * d5 + x6_z * a6 - v7 * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void parallel_123_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2,
        p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - x2_y * s3,
        x3_y = x2_y * c3 + x2_x * s3, p3_x = p2_x + x3_x * a3, p3_y = p2_y + x3_y * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4, x4_y = x3_y * c4, v1 = x3_x * s4,
        v2 = x3_y * s4, p4_z = g1 + s4 * a4, p4_x = p3_x + x4_x * a4 + x3_y * d4,
        p4_y = p3_y + x4_y * a4 + -x3_x * d4, y4_z = c4 * k1, y4_x = x3_y * k2 - v1 * k1,
        y4_y = -x3_x * k2 - v2 * k1, v3 = c4 * k2, z4_x = v1 * k2 + x3_y * k1,
        z4_y = v2 * k2 + -x3_x * k1;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + y4_x * s5,
        x5_y = x4_y * c5 + y4_y * s5, x5_z = s4 * c5 + y4_z * s5, v4 = y4_x * c5 - x4_x * s5,
        v5 = y4_y * c5 - x4_y * s5, v6 = y4_z * c5 - s4 * s5, p5_x = p4_x + x5_x * a5 + z4_x * d5,
        p5_y = p4_y + x5_y * a5 + z4_y * d5, p5_z = p4_z + x5_z * a5 - v3 * d5,
        z5_x = z4_x * ca5 - v4 * sa5, z5_y = z4_y * ca5 - v5 * sa5, v7 = v6 * sa5 + v3 * ca5;
    const double c6 = cos(q[5]), s6 = sin(q[5]),
        p6_x = p5_x + (x5_x * c6 + (v4 * ca5 + z4_x * sa5) * s6) * a6 + z5_x * d6,
        p6_y = p5_y + (x5_y * c6 + (v5 * ca5 + z4_y * sa5) * s6) * a6 + z5_y * d6,
        p6_z = p5_z + (x5_z * c6 + (v6 * ca5 - v3 * sa5) * s6) * a6 - v7 * d6, v8 = p6_z - g1,
        v9 = p6_x - p4_x, v10 = p6_y - p4_y, v11 = p6_z - p4_z, v12 = p6_x - p5_x,
        v13 = p6_y - p5_y, v14 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = p1_y - p6_y; J[2] = p2_y - p6_y; J[3] = -x3_x * v8;
    J[4] = z4_y * v11 + v3 * v10; J[5] = z5_y * v14 + v7 * v13;
    J[6] = p6_x; J[7] = p6_x - p1_x; J[8] = p6_x - p2_x; J[9] = -(x3_y * v8);
    J[10] = -(v3 * v9 + z4_x * v11); J[11] = -(v7 * v12 + z5_x * v14);
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = x3_y * (p6_y - p3_y) - -x3_x * (p6_x - p3_x);
    J[16] = z4_x * v10 - z4_y * v9; J[17] = z5_x * v13 - z5_y * v12;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = x3_y; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = -x3_x; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 1.0; J[32] = 1.0; J[33] = 0.0; J[34] = -v3; J[35] = -v7;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints;
    DHGEN_ENTRIES(double);

    /* theta6, type 9: U0 (A5 A6)^-1 [3, 4] and U0 (A5 A6)^-1 [3, 3] */
    const double R1_6 = T31 * a6 + (T33 * k3 + (k4 - T34));
    const double R1c6 = T31 * a5 + sa5 * (T32 * d5);
    const double R1s6 = T31 * k5 - T32 * a5;
    const double v1 = T33 * ca5, v2 = T32 * sa5, v3 = T31 * sa5, v4 = a4 * v1, v5 = a4 * v2,
        v6 = a4 * v3, v7 = k2 * R1_6, v8 = k2 * R1c6, v9 = k2 * R1s6, v10 = v5 * v5, v11 = v6 * v6,
        v12 = 2.0 * v4, v13 = v8 * v8, v14 = v9 * v9, v15 = 2.0 * v7,
        v16 = v4 * v4 + k1 * (v10 + v11) + (v7 * v7 + k1 * (v13 + v14)), v17 = v5 * v12 + v8 * v15,
        v18 = v6 * v12 + v9 * v15, v19 = k1 * (v10 - v11) + k1 * (v13 - v14),
        v20 = v5 * v6 + v8 * v9, v21 = v16 - k6,
        v22 = fabs(v21) + fabs(v17) + fabs(v18) + fabs(v19) + fabs(v20);
    const int free6 = v22 <= free_limit2;
    const double v23 = square_rounding * (v16 + k6);
    double x6_roots[4];
    int x6_close[4];
    dhgen_circle_roots(free6 ? 1.0 : v21, free6 ? -1.0 : v17, free6 ? 0.0 : v18, free6 ? 0.0 : v19,
        free6 ? 0.0 : v20, v23, moved, x6_roots, x6_close);
    const double v26 = cos(seed[5]) * cos(seed[5]) - sin(seed[5]) * sin(seed[5]),
        v27 = 2.0 * (cos(seed[5]) * sin(seed[5])), v28 = 2.0 * v20, v29 = 2.0 * v19,
        v31 = v22 * near_limit,
        v32 = v26 * v28 + (v18 * cos(seed[5]) - v17 * sin(seed[5])) - v27 * v29;
    const int v33 = fabs(v21 + (v20 * v27 + (v19 * v26 + (v17 * cos(seed[5]) + v18 *
        sin(seed[5]))))) <= v23 + v22 * double_root;

    /* theta123, type 3: U0 (A5 A6)^-1 [2, 3] and U0 (A5 A6)^-1 [1, 3] */
    const double v35 = sa5 * T22, v36 = sa5 * T21, v37 = ca5 * T23, v38 = sa5 * T12,
        v39 = sa5 * T11, v40 = ca5 * T13, v41 = seed[0] + seed[1] + seed[2];

    /* theta5, type 3: U3[3, 3] and U4[1, 3] */
    const double v42 = 2.0 * T23, v43 = 2.0 * T13;

    /* theta2, type 8: U0[1, 4] and U0[2, 4] */
    const double v55 = 2.0 * T14, v56 = 2.0 * T24;

    /* theta1, type 3: U0 A6^-1 [2, 4] and U0 A6^-1 [1, 4] */
    const double wy = T24 - a6 * T21 - d6 * T23;
    const double v58 = 2.0 * wy;
    const double wx = T14 - a6 * T11 - d6 * T13;
    const double v59 = 2.0 * wx;

    for (int i1 = 0; i1 < 4; i1++) { /* root1, root2, root3, root4 */
        const double x6 = x6_roots[i1];
        /* theta6 */
        if (!(x6 <= 4.0)) continue; /* out of reach */
        const double v24 = cos(x6), v25 = sin(x6),
            v30 = (v24 * v24 - v25 * v25) * v28 + (v18 * v24 - v17 * v25) - 2.0 * (v24 * v25) * v29;
        const int near6 = fabs(v30) <= v31;
        const int same6 = -(double_root * (v22 * v22)) <= v30 * v32 && 0.0 < v24 * cos(seed[5]) +
            v25 * sin(seed[5]) && fabs(v24 * sin(seed[5]) - v25 * cos(seed[5])) <= near_limit &&
            near6 && v33;
        const double v34 = same6 ? seed[5] : x6;
        const double q6 = free6 ? seed[5] : v34;
        const double c6 = cos(q6), s6 = sin(q6);

        /* theta4, type 3: U0 (A5 A6)^-1 [3, 4] and U0 (A5 A6)^-1 [3, 3] */
        const double s4 = k2 * (R1_6 + (R1c6 * c6 + R1s6 * s6)) * k7,
            c4 = a4 * (v1 + (v2 * c6 + v3 * s6)) * k7;
        const double q4 = atan2(s4, c4);

        /* theta123 */
        const double X1_123 = k1 * (sqrt3 * s4);
        const double Z1_123 = c6 * v35 + s6 * v36 + v37;
        const double Z2_123 = c6 * v38 + s6 * v39 + v40;
        const double S123 = X1_123 * Z1_123 + k1 * Z2_123;
        const double C123 = X1_123 * Z2_123 - k1 * Z1_123;
        const double w123 = sqrt(S123 * S123 + C123 * C123);
        const int free123 = w123 <= free_limit_squared;
        const int near123 = w123 <= near_limit_squared;
        const double factor123 = 1.0 / (free123 ? 1.0 : w123);
        const double c123 = free123 ? cos(v41) : C123 * factor123,
            s123 = free123 ? sin(v41) : S123 * factor123;
        const double theta123 = atan2(s123, c123);

        /* theta5 */
        const double s5 = k8 * (c123 * (c4 * T13) + s123 * (c4 * T23) + T33 * s4) * k9,
            v44 = sa5 * (k1 * (s123 * v43 - c123 * v42 - ca5)) * k9;
        const double q5 = atan2(s5, -v44);

        /* theta2 */
        const double v45 = a5 + a6 * c6, v46 = s6 * k10 - k11, v47 = c4 * (2.0 * v45) + s4 * -v46,
            v48 = sqrt3 * v46, v49 = c4 * (2.0 * v46) + s4 * v45, v50 = sqrt3 * v45, v51 = c4 * k12,
            v52 = s6 * k13, v53 = k12 + (v51 + s4 * (sqrt3 * (v52 + k14))), v54 = v52 + k15;
        const double Z1_2 = k1 * (v44 * (c123 * v47 + s123 * v48) + s5 * (c123 * v49 - s123 * v50) +
            (v55 - (c123 * v53 + s123 * v54)));
        const double Z2_2 = k1 * (s5 * (c123 * v50 + s123 * v49) - v44 * (c123 * v48 - s123 * v47) +
            (c123 * v54 - s123 * v53 + v56));
        const double N2 = Z1_2 * Z1_2 + Z2_2 * Z2_2;
        const double K2 = N2 - k16;
        const double D2_squared = (longest2 - N2) * (N2 - shortest2);
        const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
        if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) {
            if (near6) dhgen_lose(DHGEN_NEARLY + 6, D2_squared, q[2 * i1], &status[2 * i1]);
            if (near6) q[2 * i1][1] = v34;
            if (free6) dhgen_lose(DHGEN_LOST + 6, D2_squared, q[2 * i1], &status[2 * i1]);
            if (free123) dhgen_lose(DHGEN_LOST + 1, D2_squared, q[2 * i1], &status[2 * i1]);
            if (free123) dhgen_lose(DHGEN_LOST + 2, D2_squared, q[2 * i1], &status[2 * i1]);
            if (free123) dhgen_lose(DHGEN_LOST + 3, D2_squared, q[2 * i1], &status[2 * i1]);
            continue; /* out of reach */
        }
        const double w2 = sqrt(apart2 ? D2_squared : 0.0);
        const double c2 = K2 * k17;

        /* theta1 */
        const double X1_1 = a1 + a2 * c2;
        const double v57 = k12 + (v51 + s4 * k19);
        const double Z1_1 = k1 * (v44 * (2.0 * (a5 * (c4 * s123))) + s5 * (a5 * (sqrt3 * c123 + s4 *
            s123)) + (c123 * k18 - s123 * v57 + v58));
        const double Z2_1 = k1 * (v44 * (2.0 * (a5 * (c4 * c123))) + s5 * (a5 * (s4 * c123 - sqrt3 *
            s123)) + (v59 - (c123 * v57 + s123 * k18)));
        const double v60 = X1_1 * Z1_1, v61 = X1_1 * Z2_1;

        for (int i2 = 0; i2 < 2; i2++) { /* right, left */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta2 */
            if (e2 < 0.0 && (!apart2 || (near6 && !(shortest2_clear < N2 && N2 < longest2_clear))))
                continue; /* both signs give the same */
            const double s2 = w2 * e2 * k17;
            const double q2 = atan2(s2, c2);

            /* theta1 */
            const double Y1_1 = a2 * s2;
            const double S1 = v60 - Y1_1 * Z2_1;
            const double C1 = v61 + Y1_1 * Z1_1;
            const double w1 = sqrt(S1 * S1 + C1 * C1);
            const int free1 = w1 <= free_limit_squared2;
            const int near1 = w1 <= near_limit_squared2;
            const double factor1 = 1.0 / (free1 ? 1.0 : w1);
            const double c1 = free1 ? cos(seed[0]) : C1 * factor1,
                s1 = free1 ? sin(seed[0]) : S1 * factor1;
            const double q1 = atan2(s1, c1);

            /* joint values */
            const double q3 = dhgen_wrap(theta123 - (q2 + q1));
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            q[row][5] = q6;
            status[row] = (free123 || free1 || free6) ? DHGEN_FREE_JOINT : (x6_close[i1] || near6 ||
                near123 || near1) ? DHGEN_CLOSE : DHGEN_OK;
        }
    }
}

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[4] = { 5, 2, 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.625, 0.625, 0.625, 1.0, 1.0, 1.0 }, 0.625, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 1, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 4, NULL, 0, 52, 1, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ &completion, dhgen_complete_rows,
    NULL, NULL, parallel_123_fk, parallel_123_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) parallel_123_##function
#include "dhgen/functions.h"

/* cuspidal_3r: Cuspidal 3R arm
 *
 * Inverse kinematics, generated from robots/cuspidal_3r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/cuspidal_3r.yaml. The formulas and where they come from:
 * cuspidal_3r.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: ce9aebe8c3730ef3
 * SPDX-License-Identifier: MIT
 */
#include "cuspidal_3r.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 3
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/circle_roots.h"
#include "dhgen/frames.h"
#include "dhgen/complete.h"

static const double
    a1 = 1.0, /* link length 1 [m] */
    d2 = 1.0, /* joint offset 2 [m] */
    a2 = 2.0, /* link length 2 [m] */
    a3 = 1.5, /* link length 3 [m] */
    free_limit6 = 2.7680640624999998e-08, /* a length that fixes no angle [m^6] */
    square_rounding = 1e-15, /* squares are rounded by this */
    free_limit_squared2 = 3.025e-23, /* square of a length that fixes no angle [m^2] */
    /* square of a length whose direction is good to few digits [m^2] */
    near_limit_squared2 = 3.025e-05,
    k1 = 3.0, /* a3 * a2 [m^2] */
    k2 = 6.0, /* 2 * a3 * a2 [m^2] */
    k3 = -6.25, /* a1^2 - (a1^2 + (a2^2 + a3^2)) [m^2] */
    k4 = 0.5, /* 1 / 2 */
    k5 = 12.0, /* 2 * 2 * a3 * a2 [m^2] */
    k6 = 36.0, /* k2^2 [m^4] */
    k7 = 81.0, /* (a3 * 2 * a3 * a2)^2 [m^6] */
    k8 = 0.1111111111111111; /* 1 / (a3 * 2 * a3 * a2) [m^-3] */

#ifndef __CUDACC_RTC__
const char *const cuspidal_3r_branches[4] = {
    "root1", "root2", "root3", "root4",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[3] = { 0, 1, 2 };
DHGEN_TABLE int turning[3] = { 1, 1, 1 };
DHGEN_TABLE double unit[3] = { 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[3] = { 0.18181818181818182, 0.18181818181818182, 0.18181818181818182 };
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[3] = { -3.141592653589793, -3.141592653589793, -3.141592653589793 };
DHGEN_TABLE double span_width[3] = { 6.283185307179586, 6.283185307179586, 6.283185307179586 };
DHGEN_TABLE double stride[3] = { 0.8191725133961644, 0.6710436067037892, 0.5497004779019702 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    3, 4, /* joints; solutions that are kept */
    3, 3, /* joints that are solved for; equations */
    3, DHGEN_COORDINATES, 0, /* coordinates, directions, arm angle */
    0, 0, 0, /* families of solutions, limits, more entries than joints */
    48, 5.5, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, 0, 0, 0, 0,
    cuspidal_3r_fk, cuspidal_3r_jacobian, 0, 0,
};

/* The joints whose values add up to the root of a polynomial, with their signs. */
DHGEN_TABLE struct dhgen_root_turn turns[1] = { { 0, 1.0 } };

DHGEN_TABLE struct dhgen_completion completion = { &descents, turns, 1, 0, /* adds others */ 1, /*
    ascends */ 0, /* equations end all */ 0 };


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.0, 1.0, -1.5707963267948966 },
    { 0.0, 1.0, 2.0, 1.5707963267948966 },
    { 0.0, 0.0, 1.5, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void cuspidal_3r_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - s1 * s3,
        x3_y = x2_y * c3 + c1 * s3, v1 = s2 * c3;
    T[0] = x3_x; T[1] = -(s1 * c3 + x2_x * s3); T[2] = c1 * s2;
    T[3] = c1 * a1 + x2_x * a2 - s1 * d2 + x3_x * a3;
    T[4] = x3_y; T[5] = c1 * c3 - x2_y * s3; T[6] = s1 * s2;
    T[7] = s1 * a1 + x2_y * a2 + c1 * d2 + x3_y * a3;
    T[8] = -v1; T[9] = s2 * s3; T[10] = c2; T[11] = -(s2 * a2 + v1 * a3);
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void cuspidal_3r_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2, v1 = s2 * a2, p2_x = p1_x + x2_x * a2 - s1 * d2,
        p2_y = p1_y + x2_y * a2 + c1 * d2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), p3_x = p2_x + (x2_x * c3 - s1 * s3) * a3,
        p3_y = p2_y + (x2_y * c3 + c1 * s3) * a3, v2 = v1 + s2 * c3 * a3, v3 = p3_x - p2_x,
        v4 = p3_y - p2_y, v5 = v1 - v2;
    J[0] = -p3_y; J[1] = -(c1 * v2); J[2] = z2_y * v5 - c2 * v4;
    J[3] = p3_x; J[4] = -(s1 * v2); J[5] = c2 * v3 - z2_x * v5;
    J[6] = 0.0; J[7] = -(s1 * (p3_y - p1_y) + c1 * (p3_x - p1_x)); J[8] = z2_x * v4 - z2_y * v3;
    J[9] = 0.0; J[10] = -s1; J[11] = z2_x;
    J[12] = 0.0; J[13] = c1; J[14] = z2_y;
    J[15] = 1.0; J[16] = 0.0; J[17] = c2;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    (void)free_joints;
    DHGEN_ENTRIES(double);

    /* theta1, type 9: U1[3, 4] and the squared length of column 4 of U1 */
    const double v1 = T14 * T14 + (T24 * T24 + (T34 * T34 + k3));
    const double R2c1 = 2.0 * (T14 * a1);
    const double R2s1 = 2.0 * (T24 * a1);
    const double v2 = k1 + a3 * v1, v3 = a3 * R2c1 + k1 * T24, v4 = a3 * R2s1 - k1 * T14,
        v5 = k2 * T24, v6 = k2 * T14, v7 = v3 * v3, v8 = v4 * v4, v9 = 2.0 * v2, v10 = v5 * v5,
        v11 = v6 * v6, v12 = v2 * v2 + k4 * (v7 + v8) + (k6 + k4 * (v10 + v11)),
        v13 = v3 * v9 + v5 * k5, v14 = v6 * k5 - v4 * v9, v15 = k4 * (v7 - v8) + k4 * (v10 - v11),
        v16 = v3 * v4 - v5 * v6, v17 = v12 - k7;
    const int free1 = fabs(v17) + fabs(v13) + fabs(v14) + fabs(v15) + fabs(v16) <= free_limit6;
    double x1_roots[4];
    int x1_close[4];
    dhgen_circle_roots(free1 ? 1.0 : v17, free1 ? -1.0 : -v13, free1 ? 0.0 : v14, free1 ? 0.0 : v15,
        free1 ? 0.0 : v16, square_rounding * (v12 + k7), moved, x1_roots, x1_close);

    for (int i1 = 0; i1 < 4; i1++) { /* root1, root2, root3, root4 */
        const double x1 = x1_roots[i1];
        /* theta1 */
        if (!(x1 <= 4.0)) continue; /* out of reach */
        const double q1 = free1 ? seed[0] : x1;
        const double c1 = cos(q1), s1 = sin(q1);

        /* theta3, type 3: U1[3, 4] and the squared length of column 4 of U1 */
        const double v18 = d2 + (T14 * s1 - T24 * c1);
        const double c3 = (a3 * (v1 - (R2c1 * c1 + R2s1 * s1)) + k1 * v18) * k8;
        const double q3 = atan2(-(k2 * v18 * k8), c3);

        /* theta2, type 3: U1[1, 4] and U1[2, 4] */
        const double Y1_2 = a2 + a3 * c3;
        const double v19 = T34 * Y1_2;
        const double C2 = Y1_2 * (T14 * c1 + T24 * s1 - a1);
        const double w2 = sqrt(v19 * v19 + C2 * C2);
        const int free2 = w2 <= free_limit_squared2;
        const int near2 = w2 <= near_limit_squared2;
        const double factor2 = 1.0 / (free2 ? 1.0 : w2);
        const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
            s2 = free2 ? sin(seed[1]) : -(v19 * factor2);
        const double q2 = atan2(s2, c2);
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
        status[row] = (free1 || free2) ? DHGEN_FREE_JOINT : (x1_close[i1] || near2) ? DHGEN_CLOSE :
            DHGEN_OK;
    }
}

DHGEN_TABLE int entries[3] = { 3, 7, 11 };
DHGEN_TABLE int choosable[2] = { 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 4, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 0.1818, 0.1818, 0.1818, 0.0, 0.0, 0.0 }, 0.18181818181818182, { 1e-14, 1e-14 }, entries, 3,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ &completion, dhgen_complete_rows,
    NULL, NULL, cuspidal_3r_fk, cuspidal_3r_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) cuspidal_3r_##function
#include "dhgen/functions.h"

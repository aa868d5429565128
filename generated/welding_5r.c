/* welding_5r: Welding arm with five joints, its torch tilted aside
 *
 * Inverse kinematics, generated from robots/welding_5r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/welding_5r.yaml. The formulas and where they come from:
 * welding_5r.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: bd0d255b66167e58
 * SPDX-License-Identifier: MIT
 */
#include "welding_5r.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#define DHGEN_DOF 5
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/circle_roots.h"
#include "dhgen/frames.h"
#include "dhgen/complete.h"

static const double
    d1 = 0.3, /* joint offset 1 [m] */
    a1 = 0.08, /* link length 1 [m] */
    L2 = 0.5, /* link length 2 [m] */
    L3 = 0.45, /* link length 3 [m] */
    d4 = 0.03, /* joint offset 4 [m] */
    d5 = 0.12, /* joint offset 5 [m] */
    ex = 0.02, /* x of the tool frame [m] */
    ez = 0.1, /* z of the tool frame [m] */
    free_limit2 = 2.5600000000000004e-12, /* a length that fixes no angle [m^2] */
    square_rounding = 1e-15, /* squares are rounded by this */
    near_limit = 0.001, /* a length whose direction is good to few digits */
    double_root = 1e-13, /* a polynomial's value at a root, relative to its coefficients */
    free_limit_squared = 1e-24, /* square of a length that fixes no angle */
    near_limit_squared = 1e-06, /* square of a length whose direction is good to few digits */
    longest3 = 0.9025, /* square of the longest reach [m^2] */
    shortest3 = 0.0024999999999999988, /* square of the shortest reach [m^2] */
    longest3_reach = 0.902530400256, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0024984002559999986, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.9024999999999695, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.002500000000001599, /* the shortest, where branches merge [m^2] */
    longest3_clear = 0.9024999999696, /* the longest, where blurred branches do [m^2] */
    shortest3_clear = 0.002500000001599999, /* the shortest, where blurred branches do [m^2] */
    free_limit_squared2 = 2.5600000000000005e-24, /* square of a length that fixes no angle [m^2] */
    /* square of a length whose direction is good to few digits [m^2] */
    near_limit_squared2 = 2.5600000000000005e-06,
    k1 = 0.5, /* 1 / 2 */
    k2 = 0.06, /* d4 * 2 [m] */
    k3 = 0.0009, /* d4^2 [m^2] */
    k4 = 0.0004, /* ex^2 [m^2] */
    k5 = -50.0, /* -1 / ex [m^-1] */
    k6 = 0.4525, /* L2^2 + L3^2 [m^2] */
    k7 = 2.2222222222222223; /* 1 / (2 * L3 * L2) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const welding_5r_branches[8] = {
    "root1-elbow+", "root1-elbow-", "root2-elbow+", "root2-elbow-", "root3-elbow+", "root3-elbow-",
    "root4-elbow+", "root4-elbow-",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[5] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[5] = { 0, 1, 2, 3, 4 };
DHGEN_TABLE int turning[5] = { 1, 1, 1, 1, 1 };
DHGEN_TABLE double unit[5] = { 1.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[5] = { 0.625, 0.625, 0.625, 0.625, 0.625 };
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[5] = {
    -2.9670597283903604, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793,
};
DHGEN_TABLE double span_width[5] = {
    5.934119456780721, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
};
DHGEN_TABLE double stride[5] = {
    0.8812714616335696, 0.7766393890897682, 0.6844301295853426, 0.6031687406857283,
    0.5315553977157914,
};
DHGEN_TABLE double least_u[5] = { -2.9670597283903604, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
DHGEN_TABLE double most_u[5] = { 2.9670597283903604, HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    5, 8, /* joints; solutions that are kept */
    5, 6, /* joints that are solved for; equations */
    3, DHGEN_POINTING, 0, /* coordinates, directions, arm angle */
    0, 1, 0, /* families of solutions, limits, more entries than joints */
    48, 1.6, 1e-10, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    least_u, most_u, 0, 0, 0, 0,
    welding_5r_fk, welding_5r_jacobian, 0, 0,
};

/* The joints whose values add up to the root of a polynomial, with their signs. */
DHGEN_TABLE struct dhgen_root_turn turns[1] = { { 0, 1.0 } };

DHGEN_TABLE struct dhgen_completion completion = { &descents, turns, 1, 0, /* adds others */ 0, /*
    ascends */ 0, /* equations end all */ 0 };


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[5][4] = {
    { 0.0, 0.3, 0.08, 1.5707963267948966 },
    { 0.0, 0.0, 0.5, 0.0 },
    { 0.0, 0.0, 0.45, 0.0 },
    { 0.0, 0.03, 0.0, 1.5707963267948966 },
    { 0.0, 0.12, 0.0, 1.5707963267948966 },
};
DHGEN_TABLE double tool[12] = { 1.0, 0.0, 0.0, 0.02, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.1 };
DHGEN_TABLE struct dhgen_links links = { 5, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 7

DHGEN_PUBLIC void welding_5r_fk(const double q[5], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - v3 * s4,
        x4_y = x3_y * c4 - v4 * s4, x4_z = x3_z * c4 + y3_z * s4, z4_x = v3 * c4 + x3_x * s4,
        z4_y = v4 * c4 + x3_y * s4, z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + s1 * s5,
        x5_y = x4_y * c5 - c1 * s5, x5_z = x4_z * c5, z5_y = c1 * c5 + x4_y * s5, z5_z = x4_z * s5,
        z5_x = x4_x * s5 - s1 * c5;
    T[0] = x5_x; T[1] = z4_x; T[2] = z5_x;
    T[3] = c1 * a1 + x2_x * L2 + x3_x * L3 + s1 * d4 + z4_x * d5 + x5_x * ex + z5_x * ez;
    T[4] = x5_y; T[5] = z4_y; T[6] = z5_y;
    T[7] = s1 * a1 + x2_y * L2 + x3_y * L3 - c1 * d4 + z4_y * d5 + x5_y * ex + z5_y * ez;
    T[8] = x5_z; T[9] = z4_z; T[10] = z5_z;
    T[11] = d1 + s2 * L2 + x3_z * L3 + z4_z * d5 + x5_z * ex + z5_z * ez;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void welding_5r_jacobian(const double q[5], double J[30])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = p1_x + x2_x * L2, p2_y = p1_y + x2_y * L2, p2_z = d1 + s2 * L2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, p3_x = p2_x + x3_x * L3,
        p3_y = p2_y + x3_y * L3, p3_z = p2_z + x3_z * L3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - v3 * s4,
        x4_y = x3_y * c4 - v4 * s4, x4_z = x3_z * c4 + y3_z * s4, z4_x = v3 * c4 + x3_x * s4,
        z4_y = v4 * c4 + x3_y * s4, p4_x = p3_x + s1 * d4, p4_y = p3_y - c1 * d4,
        z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]),
        J21 = p4_x + z4_x * d5 + (x4_x * c5 + s1 * s5) * ex + (x4_x * s5 - s1 * c5) * ez,
        v5 = p4_y + z4_y * d5 + (x4_y * c5 - c1 * s5) * ex + (c1 * c5 + x4_y * s5) * ez,
        v6 = p3_z + z4_z * d5 + x4_z * c5 * ex + x4_z * s5 * ez, v7 = v6 - d1, v8 = v6 - p2_z,
        v9 = v6 - p3_z, v10 = J21 - p4_x, v11 = v5 - p4_y;
    J[0] = -v5; J[1] = -(c1 * v7); J[2] = -(c1 * v8); J[3] = -(c1 * v9);
    J[4] = z4_y * v9 - z4_z * v11;
    J[5] = J21; J[6] = -(s1 * v7); J[7] = -(s1 * v8); J[8] = -(s1 * v9);
    J[9] = z4_z * v10 - z4_x * v9;
    J[10] = 0.0; J[11] = s1 * (v5 - p1_y) + c1 * (J21 - p1_x);
    J[12] = s1 * (v5 - p2_y) + c1 * (J21 - p2_x); J[13] = s1 * (v5 - p3_y) + c1 * (J21 - p3_x);
    J[14] = z4_x * v11 - z4_y * v10;
    J[15] = 0.0; J[16] = s1; J[17] = s1; J[18] = s1; J[19] = z4_x;
    J[20] = 0.0; J[21] = -c1; J[22] = -c1; J[23] = -c1; J[24] = z4_y;
    J[25] = 1.0; J[26] = 0.0; J[27] = 0.0; J[28] = 0.0; J[29] = z4_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[5] = (double (*)[5])rows;
    (void)free_joints;
    DHGEN_ENTRIES(double);

    /* theta1, type 9: U1[3, 4] and U1[3, 3] */
    const double v1 = ex * T23, v2 = ex * T13, v3 = ez * T23 - T24, v4 = T14 - ez * T13,
        v5 = v1 * v1, v6 = v2 * v2, v7 = v3 * v3, v8 = v4 * v4, v9 = v3 * k2, v10 = v4 * k2,
        v11 = k1 * (v5 + v6) + (k3 + k1 * (v7 + v8)), v12 = k1 * (v5 - v6) + k1 * (v7 - v8),
        v13 = v3 * v4 - v1 * v2, v14 = v11 - k4,
        v15 = fabs(v14) + fabs(v9) + fabs(v10) + fabs(v12) + fabs(v13);
    const int free1 = v15 <= free_limit2;
    const double v16 = square_rounding * (v11 + k4);
    double x1_roots[4];
    int x1_close[4];
    dhgen_circle_roots(free1 ? 1.0 : v14, free1 ? -1.0 : -v9, free1 ? 0.0 : -v10, free1 ? 0.0 : v12,
        free1 ? 0.0 : v13, v16, moved, x1_roots, x1_close);
    const double v19 = cos(seed[0]) * cos(seed[0]) - sin(seed[0]) * sin(seed[0]),
        v20 = 2.0 * (cos(seed[0]) * sin(seed[0])), v21 = 2.0 * v13, v22 = 2.0 * v12,
        v24 = v15 * near_limit,
        v25 = v19 * v21 + (v9 * sin(seed[0]) - v10 * cos(seed[0])) - v20 * v22;
    const int v26 = fabs(v14 + (v13 * v20 + (v12 * v19 - (v9 * cos(seed[0]) + v10 * sin(seed[0])))))
        <= v16 + v15 * double_root;

    /* theta234, type 3: U1[2, 3] and U1[1, 3] */
    const double v28 = seed[1] + seed[2] + seed[3];

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v30 = T34 - d1;

    for (int i1 = 0; i1 < 4; i1++) { /* root1, root2, root3, root4 */
        const double x1 = x1_roots[i1];
        /* theta1 */
        if (!(x1 <= 4.0)) continue; /* out of reach */
        const double v17 = cos(x1), v18 = sin(x1),
            v23 = (v17 * v17 - v18 * v18) * v21 + (v9 * v18 - v10 * v17) - 2.0 * (v17 * v18) * v22;
        const int near1 = fabs(v23) <= v24;
        const int same1 = -(double_root * (v15 * v15)) <= v23 * v25 && 0.0 < v17 * cos(seed[0]) +
            v18 * sin(seed[0]) && fabs(v17 * sin(seed[0]) - v18 * cos(seed[0])) <= near_limit &&
            near1 && v26;
        const double v27 = same1 ? seed[0] : x1;
        const double q1 = free1 ? seed[0] : v27;
        const double c1 = cos(q1), s1 = sin(q1);

        /* theta5, type 3: U1[3, 4] and U1[3, 3] */
        const double Z2_5 = T13 * s1 - T23 * c1;
        const double s5 = (d4 - (T14 * s1 - T24 * c1) + ez * Z2_5) * k5, c5 = ex * Z2_5 * k5;
        const double q5 = atan2(s5, c5);

        /* theta234 */
        const double S234 = s5 * T33;
        const double C234 = s5 * (T13 * c1 + T23 * s1);
        const double w234 = sqrt(S234 * S234 + C234 * C234);
        const int free234 = w234 <= free_limit_squared;
        const int near234 = w234 <= near_limit_squared;
        const double factor234 = 1.0 / (free234 ? 1.0 : w234);
        const double c234 = free234 ? cos(v28) : C234 * factor234,
            s234 = free234 ? sin(v28) : S234 * factor234;
        const double theta234 = atan2(s234, c234);

        /* theta3 */
        const double v29 = ex * c5 + ez * s5;
        const double Z1_3 = c234 * d5 - s234 * v29 + v30;
        const double Z2_3 = T14 * c1 + T24 * s1 - a1 - (c234 * v29 + s234 * d5);
        const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
        const double K3 = N3 - k6;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) {
            if (near1) dhgen_lose(DHGEN_NEARLY + 1, D3_squared, q[2 * i1], &status[2 * i1]);
            if (near1) q[2 * i1][1] = v27;
            if (free1) dhgen_lose(DHGEN_LOST + 1, D3_squared, q[2 * i1], &status[2 * i1]);
            if (free234) dhgen_lose(DHGEN_LOST + 2, D3_squared, q[2 * i1], &status[2 * i1]);
            if (free234) dhgen_lose(DHGEN_LOST + 3, D3_squared, q[2 * i1], &status[2 * i1]);
            if (free234) dhgen_lose(DHGEN_LOST + 4, D3_squared, q[2 * i1], &status[2 * i1]);
            continue; /* out of reach */
        }
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double c3 = K3 * k7;

        /* theta2, type 3: U1[2, 4] and U1[1, 4] */
        const double X1_2 = L2 + L3 * c3;
        const double v31 = Z1_3 * X1_2, v32 = Z2_3 * X1_2;

        for (int i2 = 0; i2 < 2; i2++) { /* elbow+, elbow- */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && (!apart3 || (near1 && !(shortest3_clear < N3 && N3 < longest3_clear))))
                continue; /* both signs give the same */
            const double s3 = w3 * e3 * k7;
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double Y1_2 = L3 * s3;
            const double S2 = v31 - Z2_3 * Y1_2;
            const double C2 = v32 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const int near2 = w2 <= near_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);

            /* joint values */
            const double q4 = dhgen_wrap(theta234 - (q3 + q2));
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            status[row] = (free1 || free234 || free2) ? DHGEN_FREE_JOINT : (x1_close[i1] || near1 ||
                near234 || near2) ? DHGEN_CLOSE : DHGEN_OK;
        }
    }
}

DHGEN_TABLE int entries[6] = { 2, 3, 6, 7, 10, 11 };
DHGEN_TABLE int choosable[4] = { 3, 2, 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    5, 8, 0, DHGEN_POINTING, joints, NULL, 0,
    { 0.625, 0.625, 0.625, 1.0, 1.0, 1.0 }, 0.625, { 1e-14, 1e-14 }, entries, 6,
    0, /* slides */ 1, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 4, NULL, 0, 52, 1, /* merges */ 0, /* refines */ 1, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ &completion, dhgen_complete_rows,
    NULL, NULL, welding_5r_fk, welding_5r_jacobian, solve,
    NULL,
};

#define DHGEN_NAME(function) welding_5r_##function
#include "dhgen/functions.h"

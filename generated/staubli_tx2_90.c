/* staubli_tx2_90: Stäubli TX2-90
 *
 * Inverse kinematics, generated from robots/staubli_tx2_90.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/staubli_tx2_90.yaml. The formulas and where they come from:
 * staubli_tx2_90.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 7e1be802377f3755
 * SPDX-License-Identifier: MIT
 */
#include "staubli_tx2_90.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(STAUBLI_TX2_90_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(STAUBLI_TX2_90_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef STAUBLI_TX2_90_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 1.5280000000000004e-13 [m],
 * merge_slack1 = 1.5280000000000002e-14 [m], arm_size1 = 1.5280000000000002 [m]. */
static const double
    d1 = 0.478, /* joint offset 1 [m] */
    a1 = 0.05, /* link length 1 [m] */
    d2 = 0.05, /* joint offset 2 [m] */
    a2 = 0.425, /* link length 2 [m] */
    d4 = 0.425, /* joint offset 4 [m] */
    d6 = 0.1, /* z of the tool frame [m] */
    free_limit_squared2 = 2.3347840000000007e-24, /* square of a length that fixes no angle [m^2] */
    least_root1 = 4.831960264737285e-07, /* a root of nothing, by rounding [m] */
    longest3 = 0.7224999999999999, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    boundary3 = 1.8769985565831955e-13, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.7224999999999739, /* the longest, where branches merge [m^2] */
    shortest3_apart = 2.334784000000001e-28, /* the shortest, where branches merge [m^2] */
    offset2 = -1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    k1 = 0.0025000000000000005, /* d2^2 [m^2] */
    k2 = 1.5280000000023352e-14, /* reach_slack1 * (2 * d2 + reach_slack1) [m^2] */
    k3 = 1.5280000000002339e-15, /* merge_slack1 * (2 * d2 + merge_slack1) [m^2] */
    k4 = 0.6544502617801046, /* 1 / arm_size1 [m^-1] */
    k5 = 0.36124999999999996, /* 2 * d4 * a2 [m^2] */
    k6 = 7.662743501634321; /* 1 / (k5^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const staubli_tx2_90_branches[8] = {
    "right-down-noflip", "right-down-flip", "right-up-noflip", "right-up-flip", "left-up-noflip",
    "left-up-flip", "left-down-noflip", "left-down-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.2689280275926285, 2.5743606466916362, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.530727415391778, 2.530727415391778, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -4.71238898038469, 4.71238898038469, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.007128639793479, 2.443460952792061, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -4.71238898038469, 4.71238898038469, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.478, 0.05, -1.5707963267948966 },
    { -1.5707963267948966, 0.05, 0.425, 0.0 },
    { 1.5707963267948966, 0.0, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.425, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE double tool[12] = { 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.1 };
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void staubli_tx2_90_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2, v4 = q[2] + offset3;
    const double c3 = cos(v4), s3 = sin(v4), x3_x = x2_x * c3 - v2 * s3, x3_y = x2_y * c3 - v3 * s3,
        v5 = s2 * c3 + c2 * s3, z3_x = v2 * c3 + x2_x * s3, z3_y = v3 * c3 + x2_y * s3,
        z3_z = c2 * c3 - s2 * s3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), x4_x = x3_x * c4 - s1 * s4, x4_y = x3_y * c4 + c1 * s4,
        v7 = v5 * c4, z4_x = s1 * c4 + x3_x * s4, v8 = v5 * s4, z4_y = x3_y * s4 - c1 * c4,
        v9 = q[4] + offset5;
    const double c5 = cos(v9), s5 = sin(v9), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = z3_z * s5 - v7 * c5, v10 = z3_z * c5 + v7 * s5,
        z5_x = x4_x * s5 - z3_x * c5, z5_y = x4_y * s5 - z3_y * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = z5_x; T[1] = z4_x * c6 - x5_x * s6; T[2] = -(x5_x * c6 + z4_x * s6);
    T[3] = c1 * a1 + x2_x * a2 - s1 * d2 + z3_x * d4 + z5_x * d6;
    T[4] = z5_y; T[5] = z4_y * c6 - x5_y * s6; T[6] = -(x5_y * c6 + z4_y * s6);
    T[7] = s1 * a1 + x2_y * a2 + c1 * d2 + z3_y * d4 + z5_y * d6;
    T[8] = -v10; T[9] = -(v8 * c6 + x5_z * s6); T[10] = v8 * s6 - x5_z * c6;
    T[11] = d1 - s2 * a2 + z3_z * d4 - v10 * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void staubli_tx2_90_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1,
        v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2, p2_z = d1 - s2 * a2, p2_x = p1_x + x2_x * a2 - s1 * d2,
        p2_y = p1_y + x2_y * a2 + c1 * d2, v4 = q[2] + offset3;
    const double c3 = cos(v4), s3 = sin(v4), x3_x = x2_x * c3 - v2 * s3, x3_y = x2_y * c3 - v3 * s3,
        v5 = s2 * c3 + c2 * s3, z3_x = v2 * c3 + x2_x * s3, z3_y = v3 * c3 + x2_y * s3,
        z3_z = c2 * c3 - s2 * s3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), z4_x = s1 * c4 + x3_x * s4, v7 = v5 * s4,
        p4_x = p2_x + z3_x * d4, p4_y = p2_y + z3_y * d4, p4_z = p2_z + z3_z * d4,
        z4_y = x3_y * s4 - c1 * c4, v8 = q[4] + offset5;
    const double c5 = cos(v8), s5 = sin(v8), v9 = z3_z * c5 + v5 * c4 * s5,
        z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5,
        z5_y = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5, J21 = p4_x + z5_x * d6,
        v10 = p4_y + z5_y * d6, v11 = p4_z - v9 * d6, v12 = v11 - d1, v13 = J21 - p2_x,
        v14 = v10 - p2_y, v15 = v11 - p2_z, v16 = J21 - p4_x, v17 = v10 - p4_y, v18 = v11 - p4_z;
    J[0] = -v10; J[1] = c1 * v12; J[2] = c1 * v15; J[3] = z3_y * v15 - z3_z * v14;
    J[4] = z4_y * v18 + v7 * v17; J[5] = z5_y * v18 + v9 * v17;
    J[6] = J21; J[7] = s1 * v12; J[8] = s1 * v15; J[9] = z3_z * v13 - z3_x * v15;
    J[10] = -(v7 * v16 + z4_x * v18); J[11] = -(v9 * v16 + z5_x * v18);
    J[12] = 0.0; J[13] = -(s1 * (v10 - p1_y) + c1 * (J21 - p1_x)); J[14] = -(s1 * v14 + c1 * v13);
    J[15] = z3_x * v14 - z3_y * v13; J[16] = z4_x * v17 - z4_y * v16;
    J[17] = z5_x * v17 - z5_y * v16;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = -v7; J[35] = -v9;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[3, 4] */
    const double t14 = T14 - d6 * T11;
    const double Y1 = d6 * T21 - T24;
    const double N1 = t14 * t14 + Y1 * Y1;
    const double D1_squared = N1 - k1;
    const int apart1 = k3 < D1_squared;
    if (!(-k2 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double v1 = (apart1 ? w1 : least_root1) * k4;
    const double inverse1 = 1.0 / (apart1 ? N1 : d2 * sqrt(N1));
    const double v2 = t14 * d2, v3 = Y1 * d2;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double t34 = T34 - d6 * T31;
    const double Z1_3 = t34 - d1;
    const double v5 = Z1_3 * Z1_3;

    /* theta2, type 3: U1[1, 4] and U1[2, 4] */
    const double v11 = seed[1] + offset2;

    /* theta4, type 2: U4[3, 3] */
    const double v15 = seed[3] + offset4;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = -(inverse1 * (v3 + t14 * D1)), s1 = inverse1 * (Y1 * D1 - v2);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double v4 = D1 + a1;
        const double N3 = v5 + v4 * v4;
        const double K3 = N3 - k5;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= v1 * D3_squared)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double s3 = k5 * K3 * k6;

        /* theta2 */
        const double Y1_2 = a2 + d4 * s3;
        const double v8 = Z1_3 * Y1_2, v9 = v4 * Y1_2;

        /* theta4 */
        const double v13 = T11 * c1 + T21 * s1;
        const double Y4 = T21 * c1 - T11 * s1;
        const double v14 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v16 = T12 * s1 - T22 * c1, v17 = T12 * c1 + T22 * s1,
            v19 = T23 * c1 - T13 * s1, v20 = T13 * c1 + T23 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double v6 = k6 * (k5 * (w3 * e3));

            /* theta2 */
            const double v7 = d4 * v6;
            const double S2 = v4 * v7 - v8;
            const double v10 = Z1_3 * v7 + v9;
            const double w2 = sqrt(S2 * S2 + v10 * v10);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v11) : -(v10 * factor2),
                s2 = free2 ? sin(v11) : S2 * factor2;

            /* theta4 */
            const double v12 = v6 * c2 + s3 * s2;
            const double s23 = s3 * c2 - v6 * s2;
            const double X4 = v12 * v13 + T31 * s23;
            const double w4 = sqrt(X4 * X4 + v14);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T31 * v12 - s23 * v13;

            /* theta6 */
            const double v18 = v12 * v17 + T32 * s23, v21 = v12 * v20 + T33 * s23;

            /* joint values */
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);
            const double q3 = dhgen_wrap(atan2(s3, -v6) - offset3);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(v15) : -(X4 * factor4),
                    s4 = free4 ? sin(v15) : Y4 * factor4;
                const double s5 = w4 * e4;

                /* theta6 */
                const double c6 = c4 * v16 - s4 * v18, s6 = c4 * v19 + s4 * v21;
                const double q6 = atan2(s6, c6);

                /* joint values */
                const double q4 = dhgen_wrap(atan2(s4, c4) - offset4);
                const double q5 = dhgen_wrap(atan2(s5, c5) - offset5);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free2 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef STAUBLI_TX2_90_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit_squared2 = 2.3347840000000007e-08 [m^2],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 1.5280000000002338e-12, /* 1000 * k3 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 1.876998556582453e-11,
    m3 = 0.2768166089965398, /* 2 * a1 * k5 * k6 [m^-1] */
    m4 = 2.768166089965398, /* k5 * k6 [m^-2] */
    m5 = 1.1764705882352942, /* d4 * k5 * k6 [m^-1] */
    m6 = 5.451216326656003e-16, /* doubt_limit_squared2^2 [m^4] */
    m7 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide t14 = T14 - d6 * T11, Y1 = d6 * T21 - T24, N1 = t14 * t14 + Y1 * Y1,
        D1_squared = N1 - k1, w1 = dhgen_sqrt_wide(D1_squared), v1 = k4 * w1,
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (d2 * Y1),
        v3 = v2 + w1 * (t14 * inverse1), v4 = v2 + w1 * (inverse1 * -t14),
        v5 = inverse1 * (d2 * t14), s1_p = w1 * (Y1 * inverse1) - v5,
        s1_m = w1 * (inverse1 * -Y1) - v5;

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d6 * T31 - d1, v6 = a1 + w1, v7 = a1 - w1, v8 = Z1_3 * Z1_3,
        N3_p = v8 + v6 * v6, N3_m = v8 + v7 * v7,
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m), v9 = m4 * v8 + (m4 * N1 - 1.0), v10 = m3 * w1,
        s3_p = v9 + v10, s3_m = v9 - v10, v11 = k6 * (k5 * w3_p), v12 = k6 * (k5 * w3_m);

    /* theta2 */
    const dhgen_wide Y1_2_p = a2 + d4 * s3_p, Y1_2_m = a2 + d4 * s3_m, v13 = Z1_3 * Y1_2_p,
        v14 = Z1_3 * Y1_2_m, v15 = w3_p * (m5 * v6), S2_pp = v15 - v13, v16 = v13 + v15,
        S2_mp = w3_m * (m5 * v7) - v14, S2_mm = w3_m * (m5 * -v7) - v14, v17 = v6 * Y1_2_p,
        v18 = v7 * Y1_2_m, v19 = m5 * Z1_3, v20 = m5 * -Z1_3, v21 = v17 + w3_p * v19,
        v22 = v17 + w3_p * v20, v23 = v18 + w3_m * v19, v24 = v18 + w3_m * v20,
        v25 = S2_pp * S2_pp + v21 * v21, v26 = v16 * v16 + v22 * v22,
        v27 = S2_mp * S2_mp + v23 * v23, v28 = S2_mm * S2_mm + v24 * v24,
        factor2_pp = dhgen_sqrt_wide(v25) * DHGEN_QUOTIENT(1.0, v25),
        factor2_pm = dhgen_sqrt_wide(v26) * DHGEN_QUOTIENT(1.0, v26),
        factor2_mp = dhgen_sqrt_wide(v27) * DHGEN_QUOTIENT(1.0, v27),
        factor2_mm = dhgen_sqrt_wide(v28) * DHGEN_QUOTIENT(1.0, v28);

    /* theta4 */
    const dhgen_wide v29 = s3_p * S2_pp - v11 * v21, v30 = v11 * v22 - s3_p * v16,
        v31 = s3_m * S2_mp - v12 * v23, v32 = s3_m * S2_mm + v12 * v24,
        v33 = s3_p * v21 + v11 * S2_pp, v34 = s3_p * v22 + v11 * v16,
        v35 = s3_m * v23 + v12 * S2_mp, v36 = s3_m * v24 - v12 * S2_mm, v37 = T21 * s1_p - T11 * v3,
        v38 = T21 * s1_m - T11 * v4, X4_pp = v29 * v37 - T31 * v33, X4_pm = v30 * v37 - T31 * v34,
        X4_mp = v31 * v38 - T31 * v35, X4_mm = v32 * v38 - T31 * v36, v39 = T21 * v3 + T11 * s1_p,
        v40 = T21 * v4 + T11 * s1_m, v41 = v39 * v39, v42 = v40 * v40,
        v43 = v41 + factor2_pp * (X4_pp * (factor2_pp * X4_pp)),
        v44 = v41 + factor2_pm * (X4_pm * (factor2_pm * X4_pm)),
        v45 = v42 + factor2_mp * (X4_mp * (factor2_mp * X4_mp)),
        v46 = v42 + factor2_mm * (X4_mm * (factor2_mm * X4_mm));

    /* theta6 */
    const dhgen_wide v47 = s1_p * T12 + v3 * T22, v48 = s1_m * T12 + v4 * T22,
        v49 = s1_p * T22 - v3 * T12, v50 = s1_m * T22 - v4 * T12, v51 = v3 * T23 + s1_p * T13,
        v52 = v4 * T23 + s1_m * T13, v53 = s1_p * T23 - v3 * T13, v54 = s1_m * T23 - v4 * T13,
        angle1 = dhgen_atan2_wide(-(v51 * -X4_pp + v39 * (v29 * v53 - v33 * T33)), v47 * -X4_pp +
            v39 * (v29 * v49 - v33 * T32)),
        angle2 = dhgen_atan2_wide(-(v51 * -X4_pm + v39 * (v30 * v53 - v34 * T33)), v47 * -X4_pm +
            v39 * (v30 * v49 - v34 * T32)),
        angle3 = dhgen_atan2_wide(-(v52 * -X4_mp + v40 * (v31 * v54 - v35 * T33)), v48 * -X4_mp +
            v40 * (v31 * v50 - v35 * T32)),
        angle4 = dhgen_atan2_wide(-(v52 * -X4_mm + v40 * (v32 * v54 - v36 * T33)), v48 * -X4_mm +
            v40 * (v32 * v50 - v36 * T32));

    /* joint values */
    const dhgen_wide angle5 = dhgen_atan2_wide(S2_pp, -v21), v55 = angle5 - offset2,
        angle6 = dhgen_atan2_wide(-v16, -v22), v56 = angle6 - offset2,
        angle7 = dhgen_atan2_wide(S2_mp, -v23), v57 = angle7 - offset2,
        angle8 = dhgen_atan2_wide(S2_mm, -v24), v58 = angle8 - offset2,
        q2_ppp = dhgen_lowered_wide(v55), q2_pmp = dhgen_lowered_wide(v56),
        q2_mpp = dhgen_lowered_wide(v57), q2_mmp = dhgen_lowered_wide(v58),
        angle9 = dhgen_atan2_wide(s3_p, -v11), angle10 = dhgen_atan2_wide(s3_m, -v12),
        v59 = angle9 - offset3, v60 = dhgen_signed_wide(DHGEN_HALF_TURN, s3_p) - angle9 - offset3,
        v61 = angle10 - offset3, v62 = dhgen_signed_wide(DHGEN_HALF_TURN, s3_m) - angle10 - offset3,
        q3_ppp = dhgen_raised_wide(v59), q3_pmp = dhgen_raised_wide(v60),
        q3_mpp = dhgen_raised_wide(v61), q3_mmp = dhgen_raised_wide(v62),
        angle11 = dhgen_atan2_wide(-v39, factor2_pp * -X4_pp),
        angle12 = dhgen_atan2_wide(-v39, factor2_pm * -X4_pm),
        angle13 = dhgen_atan2_wide(-v40, factor2_mp * -X4_mp),
        angle14 = dhgen_atan2_wide(-v40, factor2_mm * -X4_mm),
        v63 = dhgen_signed_wide(DHGEN_HALF_TURN, -v39),
        v64 = dhgen_signed_wide(DHGEN_HALF_TURN, -v40), v65 = angle11 - offset4,
        v66 = angle11 - v63 - offset4, v67 = angle12 - offset4, v68 = angle12 - v63 - offset4,
        v69 = angle13 - offset4, v70 = angle13 - v64 - offset4, v71 = angle14 - offset4,
        v72 = angle14 - v64 - offset4,
        angle15 = dhgen_atan2_wide(dhgen_sqrt_wide(v43), factor2_pp * (T31 * v29 + v33 * v37)),
        angle16 = dhgen_atan2_wide(dhgen_sqrt_wide(v44), factor2_pm * (T31 * v30 + v34 * v37)),
        angle17 = dhgen_atan2_wide(dhgen_sqrt_wide(v45), factor2_mp * (T31 * v31 + v35 * v38)),
        angle18 = dhgen_atan2_wide(dhgen_sqrt_wide(v46), factor2_mm * (T31 * v32 + v36 * v38)),
        v73 = angle15 - offset5, v74 = offset5 + angle15, v75 = angle16 - offset5,
        v76 = offset5 + angle16, v77 = angle17 - offset5, v78 = offset5 + angle17,
        v79 = angle18 - offset5, v80 = offset5 + angle18, q5_ppp = dhgen_raised_wide(v73),
        q5_ppm = dhgen_only_wide(-v74 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v74,
        q5_pmp = dhgen_raised_wide(v75),
        q5_pmm = dhgen_only_wide(-v76 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v76,
        q5_mpp = dhgen_raised_wide(v77),
        q5_mpm = dhgen_only_wide(-v78 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v78,
        q5_mmp = dhgen_raised_wide(v79),
        q5_mmm = dhgen_only_wide(-v80 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v80,
        angle19 = dhgen_atan2_wide(s1_p, -v3), q1_ppp = angle19 + (w3_p - w3_p),
        angle20 = dhgen_atan2_wide(s1_m, -v4), q1_mpp = angle20 + (w3_m - w3_m),
        v81 = dhgen_maximum_wide(dhgen_beyond_wide(q2_ppp, joints + 1), dhgen_exceeds_wide(q3_ppp,
            joints + 2)),
        v82 = dhgen_maximum_wide(dhgen_beyond_wide(q2_pmp, joints + 1), dhgen_exceeds_wide(q3_pmp,
            joints + 2)),
        v83 = dhgen_maximum_wide(dhgen_beyond_wide(q2_mpp, joints + 1), dhgen_exceeds_wide(q3_mpp,
            joints + 2)),
        v84 = dhgen_maximum_wide(dhgen_beyond_wide(q2_mmp, joints + 1), dhgen_exceeds_wide(q3_mmp,
            joints + 2)),
        excess_ppp = dhgen_maximum_wide(v81, dhgen_beyond_wide(q5_ppp, joints + 4)),
        excess_ppm = dhgen_maximum_wide(v81, dhgen_beyond_wide(q5_ppm, joints + 4)),
        excess_pmp = dhgen_maximum_wide(v82, dhgen_beyond_wide(q5_pmp, joints + 4)),
        excess_pmm = dhgen_maximum_wide(v82, dhgen_beyond_wide(q5_pmm, joints + 4)),
        excess_mpp = dhgen_maximum_wide(v83, dhgen_beyond_wide(q5_mpp, joints + 4)),
        excess_mpm = dhgen_maximum_wide(v83, dhgen_beyond_wide(q5_mpm, joints + 4)),
        excess_mmp = dhgen_maximum_wide(v84, dhgen_beyond_wide(q5_mmp, joints + 4)),
        excess_mmm = dhgen_maximum_wide(v84, dhgen_beyond_wide(q5_mmm, joints + 4));

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = q3_ppp; q[3] = dhgen_raised_wide(v65); q[4] = q5_ppp;
    q[5] = angle1;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_ppp);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = q3_ppp; q[9] = dhgen_raised_wide(v66); q[10] = q5_ppm;
    q[11] = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, -(v51 * -X4_pp + v39 * (v29 * v53 - v33 *
        T33)));
    kind[1] = dhgen_kind_within_wide(q[6], 0.0 < excess_ppm);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = dhgen_raised_wide(v67); q[16] = q5_pmp;
    q[17] = angle2;
    kind[2] = dhgen_kind_within_wide(q[12], 0.0 < excess_pmp);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = dhgen_raised_wide(v68); q[22] = q5_pmm;
    q[23] = angle2 - dhgen_signed_wide(DHGEN_HALF_TURN, -(v51 * -X4_pm + v39 * (v30 * v53 - v34 *
        T33)));
    kind[3] = dhgen_kind_within_wide(q[18], 0.0 < excess_pmm);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_mpp; q[27] = dhgen_raised_wide(v69); q[28] = q5_mpp;
    q[29] = angle3;
    kind[4] = dhgen_kind_within_wide(q[24], 0.0 < excess_mpp);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_mpp; q[33] = dhgen_raised_wide(v70); q[34] = q5_mpm;
    q[35] = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, -(v52 * -X4_mp + v40 * (v31 * v54 - v35 *
        T33)));
    kind[5] = dhgen_kind_within_wide(q[30], 0.0 < excess_mpm);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_mmp; q[39] = dhgen_raised_wide(v71); q[40] = q5_mmp;
    q[41] = angle4;
    kind[6] = dhgen_kind_within_wide(q[36], 0.0 < excess_mmp);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_mmp; q[45] = dhgen_raised_wide(v72); q[46] = q5_mmm;
    q[47] = angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, -(v52 * -X4_mm + v40 * (v32 * v54 - v36 *
        T33)));
    kind[7] = dhgen_kind_within_wide(q[42], 0.0 < excess_mmm);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v46 <= m7) | (v28 <= m6) | (v45 <= m7) | (v27 <= m6) | (v44 <= m7) |
        (v26 <= m6) | (v43 <= m7) | (v25 <= m6) | (dhgen_abs_wide(v1 * D3_squared_m) <= m2) |
        (dhgen_abs_wide(D1_squared) <= m1) | (dhgen_abs_wide(v1 * D3_squared_p) <= m2)) |
        (dhgen_within_slack_wide(excess_mmm) | dhgen_within_slack_wide(excess_mmp) |
        dhgen_within_slack_wide(excess_mpm) | dhgen_within_slack_wide(excess_mpp) |
        dhgen_within_slack_wide(excess_pmm) | dhgen_within_slack_wide(excess_pmp) |
        dhgen_within_slack_wide(excess_ppp) | dhgen_within_slack_wide(excess_ppm));
}

#if DHGEN_LANES > 1
static const double
    m8 = 0.5; /* 1 / 2 */
/* One regular pose, two signs in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    const dhgen_four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e3 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double t14 = T14 - d6 * T11, Y1 = d6 * T21 - T24, N1 = t14 * t14 + Y1 * Y1,
        D1_squared = N1 - k1, w1 = sqrt(D1_squared), v1 = k4 * w1,
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (d2 * Y1);
    const dhgen_four v3 = v2 + w1 * (inverse1 * (e1 * t14));
    const double v4 = inverse1 * (d2 * t14);
    const dhgen_four s1 = w1 * (inverse1 * (e1 * Y1)) - v4;

    /* theta3 */
    const double Z1_3 = T34 - d6 * T31 - d1;
    const dhgen_four v5 = a1 + e1 * w1;
    const double v6 = Z1_3 * Z1_3;
    const dhgen_four N3 = v6 + v5 * v5, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared);
    const double v7 = m4 * v6 + (m4 * N1 - 1.0);
    const dhgen_four s3 = v7 + w1 * (m3 * e1), v8 = k6 * (k5 * w3);

    /* theta2 */
    const dhgen_four Y1_2 = a2 + d4 * s3, v9 = Z1_3 * Y1_2, S2 = w3 * (m5 * (e3 * v5)) - v9,
        v10 = v5 * Y1_2, v11 = m5 * (e3 * Z1_3), v12 = v10 + w3 * v11, v13 = S2 * S2 + v12 * v12,
        factor2 = dhgen_sqrt_four(v13) * DHGEN_QUOTIENT(1.0, v13);

    /* theta4 */
    const dhgen_four v14 = s3 * S2 - e3 * (v8 * v12), v15 = s3 * v12 + e3 * (v8 * S2),
        v16 = T21 * s1 - T11 * v3, X4 = v14 * v16 - T31 * v15, v17 = T21 * v3 + T11 * s1,
        v18 = v17 * v17, v19 = v18 + factor2 * (X4 * (factor2 * X4));

    /* theta6 */
    const dhgen_four v20 = s1 * T12 + v3 * T22, v21 = s1 * T22 - v3 * T12,
        v22 = v3 * T23 + s1 * T13, v23 = s1 * T23 - v3 * T13;

    /* joint values */
    const dhgen_four v25 = dhgen_signed_four(DHGEN_HALF_TURN, s3), v26 = m8 * (1.0 - e3),
        v28 = dhgen_signed_four(DHGEN_HALF_TURN, -v17);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | (dhgen_abs_four(v1
        * D3_squared) <= m2) | ((v13 <= m6) | (v19 <= m7))) | (unsigned)(fabs(D1_squared) <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(S2, -v12),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(s3, s1, 0, 5, 2, 7), dhgen_shuffle(-v8, -v3, 0, 5,
            2, 7)),
        ratio3 = dhgen_ratio_four(-(v22 * -X4 + v17 * (v14 * v23 - v15 * T33)), v20 * -X4 + v17 *
            (v14 * v21 - v15 * T32)), ratio4 = dhgen_ratio_four(-v17, factor2 * -X4),
        ratio5 = dhgen_ratio_four(dhgen_sqrt_four(v19), factor2 * (T31 * v14 + v15 * v16));
    const dhgen_four angle2 = dhgen_angle_four(ratio1), packed2 = dhgen_angle_four(ratio2),
        angle3 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2),
        angle6 = dhgen_shuffle(packed2, packed2, 1, 1, 3, 3), angle1 = dhgen_angle_four(ratio3),
        angle4 = dhgen_angle_four(ratio4), angle5 = dhgen_angle_four(ratio5);
    const dhgen_four q6_m = angle1 - dhgen_signed_four(DHGEN_HALF_TURN, -(v22 * -X4 + v17 * (v14 *
        v23 - v15 * T33))), v24 = angle2 - offset2, q2_p = dhgen_lowered_four(v24),
        v27 = e3 * angle3 + v25 * v26 - offset3, q3_p = dhgen_raised_four(v27),
        v29 = angle4 - offset4, v30 = angle4 - v28 - offset4, q4_p = dhgen_raised_four(v29),
        q4_m = dhgen_raised_four(v30), v31 = angle5 - offset5, v32 = offset5 + angle5,
        q5_p = dhgen_raised_four(v31),
        q5_m = dhgen_only_four(-v32 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v32,
        q1_p = angle6 + (w3 - w3),
        v33 = dhgen_maximum_four(dhgen_beyond_four(q2_p, joints + 1), dhgen_exceeds_four(q3_p,
            joints + 2)), excess_p = dhgen_maximum_four(v33, dhgen_beyond_four(q5_p, joints + 4)),
        excess_m = dhgen_maximum_four(v33, dhgen_beyond_four(q5_m, joints + 4));
    const dhgen_four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (dhgen_bits_four((dhgen_within_slack_four(excess_p) | dhgen_within_slack_four(excess_m))))
        return -1;

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, q2_p, q3_p, q4_p);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, q5_p, angle1);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, q2_p, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, q5_m, q6_m);
    const unsigned long long none1 = (dhgen_bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long outside1 = (dhgen_bits_four(outside_p) * 0x200040008001ull &
        0x1000100010001ull) | (dhgen_bits_four(outside_m) * 0x20004000800100ull &
        0x100010001000100ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE + (outside1 & ~none1) *
        DHGEN_OUT_OF_LIMITS;
    __builtin_memcpy(status, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~(none1 | outside1));
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[2] = { 3, 1 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.6545, 0.6545, 0.6545, 1.0, 1.0, 1.0 }, 0.6544502617801046, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, staubli_tx2_90_fk,
    staubli_tx2_90_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) staubli_tx2_90_##function
#include "dhgen/functions.h"

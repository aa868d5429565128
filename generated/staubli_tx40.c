/* staubli_tx40: Stäubli TX40
 *
 * Inverse kinematics, generated from robots/staubli_tx40.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/staubli_tx40.yaml. The formulas and where they come from:
 * staubli_tx40.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: fc3cf3d03413d95a
 * SPDX-License-Identifier: MIT
 */
#include "staubli_tx40.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(STAUBLI_TX40_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(STAUBLI_TX40_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef STAUBLI_TX40_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 8.700000000000001e-14 [m],
 * merge_slack1 = 8.700000000000002e-15 [m], arm_size1 = 0.8700000000000001 [m]. */
static const double
    d1 = 0.32, /* joint offset 1 [m] */
    a2 = 0.225, /* link length 2 [m] */
    d3 = 0.035, /* joint offset 3 [m] */
    d4 = 0.225, /* joint offset 4 [m] */
    d6 = 0.065, /* joint offset 6 [m] */
    free_limit_squared2 = 7.5690000000000015e-25, /* square of a length that fixes no angle [m^2] */
    least_root1 = 2.75118156434649e-07, /* a root of nothing, by rounding [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    longest3 = 0.2025, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    boundary3 = 1.5849821455311018e-14, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.20249999999999216, /* the longest, where branches merge [m^2] */
    shortest3_apart = 7.569000000000003e-29, /* the shortest, where branches merge [m^2] */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    k1 = 0.0012250000000000002, /* d3^2 [m^2] */
    k2 = 6.09000000000757e-15, /* reach_slack1 * (2 * d3 + reach_slack1) [m^2] */
    k3 = 6.090000000000759e-16, /* merge_slack1 * (2 * d3 + merge_slack1) [m^2] */
    k4 = 1.1494252873563218, /* 1 / arm_size1 [m^-1] */
    k5 = 0.10125, /* 2 * d4 * a2 [m^2] */
    k6 = 97.54610577655845; /* 1 / (k5^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const staubli_tx40_branches[8] = {
    "right-down-noflip", "right-down-flip", "right-up-noflip", "right-up-flip", "left-up-noflip",
    "left-up-flip", "left-down-noflip", "left-down-flip",
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

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 3.141592653589793, 0.32, 0.0, 1.5707963267948966 },
    { 1.5707963267948966, 0.0, 0.225, 0.0 },
    { 1.5707963267948966, 0.035, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.225, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.065, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void staubli_tx40_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2, v5 = q[2] + offset3;
    const double c3 = cos(v5), s3 = sin(v5), x3_x = x2_x * c3 - v3 * s3, x3_y = x2_y * c3 - v4 * s3,
        x3_z = s2 * c3 + c2 * s3, z3_x = v3 * c3 + x2_x * s3, z3_y = v4 * c3 + x2_y * s3,
        z3_z = s2 * s3 - c2 * c3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), x4_x = x3_x * c4 + s1 * s4, x4_y = x3_y * c4 - c1 * s4,
        x4_z = x3_z * c4, z4_y = c1 * c4 + x3_y * s4, z4_z = x3_z * s4, z4_x = x3_x * s4 - s1 * c4,
        v7 = q[4] + offset5;
    const double c5 = cos(v7), s5 = sin(v7), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, z5_x = x4_x * s5 - z3_x * c5,
        z5_y = x4_y * s5 - z3_y * c5, z5_z = x4_z * s5 - z3_z * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = z4_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = x2_x * a2 + s1 * d3 + z3_x * d4 + z5_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = z4_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = x2_y * a2 - c1 * d3 + z3_y * d4 + z5_y * d6;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = z4_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 + s2 * a2 + z3_z * d4 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void staubli_tx40_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2, v5 = q[2] + offset3;
    const double c3 = cos(v5), s3 = sin(v5), x3_x = x2_x * c3 - v3 * s3, x3_y = x2_y * c3 - v4 * s3,
        x3_z = s2 * c3 + c2 * s3, z3_x = v3 * c3 + x2_x * s3, z3_y = v4 * c3 + x2_y * s3,
        p3_x = p2_x + s1 * d3, p3_y = p2_y - c1 * d3, z3_z = s2 * s3 - c2 * c3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), z4_y = c1 * c4 + x3_y * s4, z4_z = x3_z * s4,
        p4_x = p3_x + z3_x * d4, p4_y = p3_y + z3_y * d4, p4_z = p2_z + z3_z * d4,
        z4_x = x3_x * s4 - s1 * c4, v7 = q[4] + offset5;
    const double c5 = cos(v7), s5 = sin(v7), z5_x = (x3_x * c4 + s1 * s4) * s5 - z3_x * c5,
        z5_y = (x3_y * c4 - c1 * s4) * s5 - z3_y * c5, z5_z = x3_z * c4 * s5 - z3_z * c5,
        p6_x = p4_x + z5_x * d6, p6_y = p4_y + z5_y * d6, p6_z = p4_z + z5_z * d6, v8 = p6_z - d1,
        v9 = p6_z - p2_z, v10 = p6_x - p3_x, v11 = p6_y - p3_y, v12 = p6_x - p4_x,
        v13 = p6_y - p4_y, v14 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = -(c1 * v8); J[2] = -(c1 * v9); J[3] = z3_y * v9 - z3_z * v11;
    J[4] = z4_y * v14 - z4_z * v13; J[5] = z5_y * v14 - z5_z * v13;
    J[6] = p6_x; J[7] = -(s1 * v8); J[8] = -(s1 * v9); J[9] = z3_z * v10 - z3_x * v9;
    J[10] = z4_z * v12 - z4_x * v14; J[11] = z5_z * v12 - z5_x * v14;
    J[12] = 0.0; J[13] = s1 * p6_y + c1 * p6_x; J[14] = s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x);
    J[15] = z3_x * v11 - z3_y * v10; J[16] = z4_x * v13 - z4_y * v12;
    J[17] = z5_x * v13 - z5_y * v12;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1 A6^-1 [3, 4] */
    const double X1 = T13 * d6 - T14;
    const double wy = T24 - d6 * T23;
    const double N1 = X1 * X1 + wy * wy;
    const double D1_squared = N1 - k1;
    const int apart1 = k3 < D1_squared;
    if (!(-k2 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double v1 = (apart1 ? w1 : least_root1) * k4;
    const double inverse1 = 1.0 / (apart1 ? N1 : d3 * sqrt(N1));
    const double v2 = X1 * d3, v3 = wy * d3;

    /* theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = T34 - d6 * T33;
    const double Z1_3 = wz - d1;
    const double v4 = Z1_3 * Z1_3;

    /* theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double v8 = seed[1] + offset2;

    /* theta4, type 2: U4[3, 3] */
    const double v12 = seed[3] + offset4;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = -(inverse1 * (v3 + X1 * D1)), s1 = inverse1 * (wy * D1 - v2);

        /* theta3 */
        const double N3 = v4 + D1 * D1;
        const double K3 = N3 - k5;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= v1 * D3_squared)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double s3 = k5 * K3 * k6;

        /* theta2 */
        const double X1_2 = a2 + d4 * s3;
        const double v6 = Z1_3 * X1_2, v7 = D1 * X1_2;

        /* theta4 */
        const double v10 = T13 * c1 + T23 * s1;
        const double Y4 = T13 * s1 - T23 * c1;
        const double v11 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v13 = T22 * c1 - T12 * s1, v14 = T12 * c1 + T22 * s1,
            v16 = T21 * c1 - T11 * s1, v17 = T11 * c1 + T21 * s1;

        /* joint values */
        const double q1 = dhgen_wrap(atan2(s1, c1) - offset1);

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double v5 = k6 * (k5 * (w3 * e3));

            /* theta2 */
            const double Y1_2 = d4 * v5;
            const double S2 = v6 - D1 * Y1_2;
            const double C2 = v7 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v8) : C2 * factor2, s2 = free2 ? sin(v8) : S2 * factor2;

            /* theta4 */
            const double v9 = v5 * c2 + s3 * s2;
            const double s23 = s3 * c2 - v5 * s2;
            const double X4 = v9 * v10 - T33 * s23;
            const double w4 = sqrt(X4 * X4 + v11);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta6 */
            const double v15 = T32 * s23 - v9 * v14, v18 = T31 * s23 - v9 * v17;

            /* joint values */
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);
            const double q3 = dhgen_wrap(atan2(s3, -v5) - offset3);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(v12) : -(X4 * factor4),
                    s4 = free4 ? sin(v12) : Y4 * factor4;
                const double s5 = w4 * e4;

                /* theta6 */
                const double c6 = c4 * v13 + s4 * v15, s6 = c4 * v16 + s4 * v18;
                const double q6 = atan2(s6, c6);

                /* joint values */
                const double q4 = dhgen_wrap(atan2(s4, c4) - offset4);
                const double q5 = dhgen_wrap(atan2(s5, -(T33 * v9 + s23 * v10)) - offset5);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free2 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef STAUBLI_TX40_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit_squared2 = 7.569000000000001e-09 [m^2],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 6.090000000000759e-13, /* 1000 * k3 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 1.5906026495925924e-12,
    m3 = 2.2222222222222223, /* d4 * k5 * k6 [m^-1] */
    m4 = 5.728976100000003e-17, /* doubt_limit_squared2^2 [m^4] */
    m5 = 21.947873799725652, /* d4 * k5^2 * k6^2 [m^-3] */
    m6 = 4.4444444444444455, /* d4 * longest3 * k5^2 * k6^2 [m^-1] */
    m7 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide X1 = d6 * T13 - T14, wy = T24 - d6 * T23, N1 = X1 * X1 + wy * wy,
        D1_squared = N1 - k1, w1 = dhgen_sqrt_wide(D1_squared), v1 = w1 - w1,
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (d3 * wy),
        v3 = v2 + w1 * (X1 * inverse1), v4 = v2 + w1 * (inverse1 * -X1), v5 = inverse1 * (d3 * X1),
        s1_p = w1 * (wy * inverse1) - v5, s1_m = w1 * (inverse1 * -wy) - v5;

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d6 * T33 - d1, N3 = D1_squared + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_wide(D3_squared),
        v6 = w3 - w3, v7 = k5 * (N3 - k5);

    /* theta2 */
    const dhgen_wide v8 = m3 * (Z1_3 * N3), v9 = w3 * (m3 * w1), S2_pp = v8 - v9, S2_pm = v8 + v9,
        v10 = w3 * (m3 * Z1_3), v11 = w3 * (m3 * -Z1_3), v12 = m3 * (w1 * N3), C2_pp = v10 + v12,
        C2_pm = v11 + v12, C2_mp = v10 - v12, C2_mm = v11 - v12, v13 = S2_pp * S2_pp,
        v14 = v13 + C2_pp * C2_pp, v15 = S2_pm * S2_pm, v16 = v15 + C2_pm * C2_pm,
        v17 = v15 + C2_mp * C2_mp, v18 = v13 + C2_mm * C2_mm,
        factor2_pp = dhgen_sqrt_wide(v14) * DHGEN_QUOTIENT(1.0, v14),
        factor2_pm = dhgen_sqrt_wide(v16) * DHGEN_QUOTIENT(1.0, v16),
        factor2_mp = dhgen_sqrt_wide(v17) * DHGEN_QUOTIENT(1.0, v17),
        factor2_mm = dhgen_sqrt_wide(v18) * DHGEN_QUOTIENT(1.0, v18);

    /* theta4 */
    const dhgen_wide v19 = m5 * N3, v20 = v19 - m3, v21 = m6 - v19, v22 = w1 * (N3 * (v20 + v21)),
        s23_pp = v22 - v10, s23_pm = v22 - v11, v23 = w1 * (N3 * (-v20 - v21)), s23_mp = v23 - v10,
        s23_mm = v23 - v11, v24 = T23 * s1_p - T13 * v3, v25 = T23 * s1_m - T13 * v4,
        X4_pp = S2_pm * v24 - T33 * s23_pp, X4_pm = S2_pp * v24 - T33 * s23_pm,
        X4_mp = S2_pp * v25 - T33 * s23_mp, X4_mm = S2_pm * v25 - T33 * s23_mm,
        Y4_p = T13 * s1_p + T23 * v3, Y4_m = T13 * s1_m + T23 * v4, v26 = Y4_p * Y4_p,
        v27 = Y4_m * Y4_m, v28 = v26 + factor2_pp * (X4_pp * (factor2_pp * X4_pp)),
        v29 = v26 + factor2_pm * (X4_pm * (factor2_pm * X4_pm)),
        v30 = v27 + factor2_mp * (X4_mp * (factor2_mp * X4_mp)),
        v31 = v27 + factor2_mm * (X4_mm * (factor2_mm * X4_mm));

    /* theta6 */
    const dhgen_wide v32 = v3 * T22 + s1_p * T12, v33 = v4 * T22 + s1_m * T12,
        v34 = s1_p * T22 - v3 * T12, v35 = s1_m * T22 - v4 * T12, v36 = v3 * T21 + s1_p * T11,
        v37 = v4 * T21 + s1_m * T11, v38 = s1_p * T21 - v3 * T11, v39 = s1_m * T21 - v4 * T11,
        s6_pp = Y4_p * (s23_pp * T31 - S2_pm * v38) - v36 * -X4_pp,
        s6_pm = Y4_p * (s23_pm * T31 - S2_pp * v38) - v36 * -X4_pm,
        s6_mp = Y4_m * (s23_mp * T31 - S2_pp * v39) - v37 * -X4_mp,
        s6_mm = Y4_m * (s23_mm * T31 - S2_pm * v39) - v37 * -X4_mm,
        angle1 = dhgen_atan2_wide(s6_pp, Y4_p * (s23_pp * T32 - S2_pm * v34) - v32 * -X4_pp),
        angle2 = dhgen_atan2_wide(s6_pm, Y4_p * (s23_pm * T32 - S2_pp * v34) - v32 * -X4_pm),
        angle3 = dhgen_atan2_wide(s6_mp, Y4_m * (s23_mp * T32 - S2_pp * v35) - v33 * -X4_mp),
        angle4 = dhgen_atan2_wide(s6_mm, Y4_m * (s23_mm * T32 - S2_pm * v35) - v33 * -X4_mm);

    /* joint values */
    const dhgen_wide angle5 = dhgen_atan2_wide(s1_p, -v3), v40 = angle5 - offset1,
        angle6 = dhgen_atan2_wide(s1_m, -v4), v41 = angle6 - offset1,
        angle7 = dhgen_atan2_wide(S2_pp, C2_pp), v42 = angle7 - offset2,
        angle8 = dhgen_atan2_wide(S2_pm, C2_pm), v43 = angle8 - offset2,
        angle9 = dhgen_atan2_wide(S2_pm, C2_mp), v44 = angle9 - offset2,
        angle10 = dhgen_atan2_wide(S2_pp, C2_mm), v45 = angle10 - offset2,
        q2_ppp = dhgen_raised_wide(v42), q2_pmp = dhgen_raised_wide(v43),
        q2_mpp = dhgen_raised_wide(v44), q2_mmp = dhgen_raised_wide(v45),
        angle11 = dhgen_atan2_wide(v7, -(k5 * w3)), v46 = angle11 - offset3,
        v47 = dhgen_signed_wide(DHGEN_HALF_TURN, v7) - angle11 - offset3,
        angle12 = dhgen_atan2_wide(Y4_p, factor2_pp * -X4_pp),
        angle13 = dhgen_atan2_wide(Y4_p, factor2_pm * -X4_pm),
        angle14 = dhgen_atan2_wide(Y4_m, factor2_mp * -X4_mp),
        angle15 = dhgen_atan2_wide(Y4_m, factor2_mm * -X4_mm),
        v48 = dhgen_signed_wide(DHGEN_HALF_TURN, Y4_p),
        v49 = dhgen_signed_wide(DHGEN_HALF_TURN, Y4_m), v50 = angle12 - offset4,
        v51 = angle12 - v48 - offset4, v52 = angle13 - offset4, v53 = angle13 - v48 - offset4,
        v54 = angle14 - offset4, v55 = angle14 - v49 - offset4, v56 = angle15 - offset4,
        v57 = angle15 - v49 - offset4, v58 = T33 * S2_pm,
        angle16 = dhgen_atan2_wide(dhgen_sqrt_wide(v28), -(factor2_pp * (v58 + s23_pp * v24))),
        v59 = T33 * S2_pp,
        angle17 = dhgen_atan2_wide(dhgen_sqrt_wide(v29), -(factor2_pm * (v59 + s23_pm * v24))),
        angle18 = dhgen_atan2_wide(dhgen_sqrt_wide(v30), -(factor2_mp * (v59 + s23_mp * v25))),
        angle19 = dhgen_atan2_wide(dhgen_sqrt_wide(v31), -(factor2_mm * (v58 + s23_mm * v25))),
        v60 = angle16 - offset5, v61 = offset5 + angle16, v62 = angle17 - offset5,
        v63 = offset5 + angle17, v64 = angle18 - offset5, v65 = offset5 + angle18,
        v66 = angle19 - offset5, v67 = offset5 + angle19, q1_ppp = v6 + dhgen_raised_wide(v40),
        q1_mpp = v6 + dhgen_raised_wide(v41), q3_ppp = v1 + dhgen_raised_wide(v46),
        q3_pmp = v1 + dhgen_raised_wide(v47);

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = q3_ppp; q[3] = dhgen_raised_wide(v50);
    q[4] = dhgen_raised_wide(v60); q[5] = angle1;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = q3_ppp; q[9] = dhgen_raised_wide(v51);
    q[10] = dhgen_only_wide(-v61 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v61;
    q[11] = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_pp);
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = dhgen_raised_wide(v52);
    q[16] = dhgen_raised_wide(v62); q[17] = angle2;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = dhgen_raised_wide(v53);
    q[22] = dhgen_only_wide(-v63 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v63;
    q[23] = angle2 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_pm);
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_ppp; q[27] = dhgen_raised_wide(v54);
    q[28] = dhgen_raised_wide(v64); q[29] = angle3;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_ppp; q[33] = dhgen_raised_wide(v55);
    q[34] = dhgen_only_wide(-v65 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v65;
    q[35] = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_mp);
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_pmp; q[39] = dhgen_raised_wide(v56);
    q[40] = dhgen_raised_wide(v66); q[41] = angle4;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_pmp; q[45] = dhgen_raised_wide(v57);
    q[46] = dhgen_only_wide(-v67 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v67;
    q[47] = angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_mm);
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v31 <= m7) | (v18 <= m4) | (v30 <= m7) | (v17 <= m4) | (v29 <= m7) |
        (v16 <= m4) | (v28 <= m7) | (dhgen_abs_wide(D1_squared) <= m1) | (dhgen_abs_wide(D3_squared
        * (k4 * w1)) <= m2) | (v14 <= m4));
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
    const double X1 = d6 * T13 - T14, wy = T24 - d6 * T23, N1 = X1 * X1 + wy * wy,
        D1_squared = N1 - k1, w1 = sqrt(D1_squared), v1 = w1 - w1,
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (d3 * wy);
    const dhgen_four v3 = v2 + w1 * (inverse1 * (e1 * X1));
    const double v4 = inverse1 * (d3 * X1);
    const dhgen_four s1 = w1 * (inverse1 * (e1 * wy)) - v4;

    /* theta3 */
    const double Z1_3 = T34 - d6 * T33 - d1, N3 = D1_squared + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared), v5 = w3 - w3,
        v6 = k5 * (N3 - k5);

    /* theta2 */
    const dhgen_four v7 = e1 * e3;
    const double v8 = m3 * (Z1_3 * N3);
    const dhgen_four S2 = v8 - w3 * (m3 * (w1 * v7)), v9 = w3 * (m3 * (e3 * Z1_3)),
        v10 = m3 * (w1 * (e1 * N3)), C2 = v9 + v10, v11 = S2 * S2 + C2 * C2,
        factor2 = dhgen_sqrt_four(v11) * DHGEN_QUOTIENT(1.0, v11);

    /* theta4 */
    const dhgen_four v12 = v8 + w3 * (w1 * (m3 * v7));
    const double v13 = m5 * N3, v14 = v13 - m3;
    const dhgen_four v15 = e1 * v14;
    const double v16 = m6 - v13;
    const dhgen_four v17 = e3 * v16, s23 = w1 * (N3 * (v15 + v7 * v17)) - v9,
        v18 = T23 * s1 - T13 * v3, X4 = v12 * v18 - T33 * s23, Y4 = T13 * s1 + T23 * v3,
        v19 = Y4 * Y4, v20 = v19 + factor2 * (X4 * (factor2 * X4));

    /* theta6 */
    const dhgen_four v21 = v3 * T22 + s1 * T12, v22 = s1 * T22 - v3 * T12,
        v23 = v3 * T21 + s1 * T11, v24 = s1 * T21 - v3 * T11,
        s6 = Y4 * (s23 * T31 - v12 * v24) - v23 * -X4;

    /* joint values */
    const double v27 = copysign(DHGEN_HALF_TURN, v6);
    const dhgen_four v29 = dhgen_signed_four(DHGEN_HALF_TURN, Y4);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((v11 <= m4) |
        (v20 <= m7))) | (unsigned)((fabs(D1_squared) <= m1) | (fabs(D3_squared * (k4 * w1)) <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(s1, dhgen_all_four(v6), 0, 5,
        2, 3), dhgen_shuffle(-v3, dhgen_all_four(-(k5 * w3)), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(S2, C2),
        ratio3 = dhgen_ratio_four(s6, Y4 * (s23 * T32 - v12 * v22) - v21 * -X4),
        ratio4 = dhgen_ratio_four(Y4, factor2 * -X4),
        ratio5 = dhgen_ratio_four(dhgen_sqrt_four(v20), -(factor2 * (T33 * v12 + s23 * v18)));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle2 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle4 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = dhgen_angle_four(ratio2),
        angle1 = dhgen_angle_four(ratio3), angle5 = dhgen_angle_four(ratio4),
        angle6 = dhgen_angle_four(ratio5);
    const dhgen_four q6_m = angle1 - dhgen_signed_four(DHGEN_HALF_TURN, s6), v25 = angle2 - offset1,
        v26 = angle3 - offset2, q2_p = dhgen_raised_four(v26),
        v28 = e3 * angle4 + v27 * (m8 * (1.0 - e3)) - offset3, v30 = angle5 - offset4,
        v31 = angle5 - v29 - offset4, q4_p = dhgen_raised_four(v30), q4_m = dhgen_raised_four(v31),
        v32 = angle6 - offset5, v33 = offset5 + angle6, q5_p = dhgen_raised_four(v32),
        q5_m = dhgen_only_four(-v33 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v33,
        q1_p = v5 + dhgen_raised_four(v25), q3_p = v1 + dhgen_raised_four(v28);

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, q2_p, q3_p, q4_p);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, q5_p, angle1);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, q2_p, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, q5_m, q6_m);
    const unsigned long long none1 = (dhgen_bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[2] = { 3, 1 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 1.149, 1.149, 1.149, 1.0, 1.0, 1.0 }, 1.1494252873563218, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 2, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, staubli_tx40_fk,
    staubli_tx40_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) staubli_tx40_##function
#include "dhgen/functions.h"

/* puma: PUMA in its reference position
 *
 * Inverse kinematics, generated from robots/puma.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma.yaml. The formulas and where they come from: puma.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: cd4e6518e19091b2
 * SPDX-License-Identifier: MIT
 */
#include "puma.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(PUMA_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(PUMA_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef PUMA_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 1.890188625788961e-13 [m],
 * merge_slack1 = 1.890188625788961e-14 [m], arm_size1 = 1.8901886257889609 [m]. */
static const double
    L2 = 0.4318, /* z of axis 3 [m] */
    D3 = 0.15005, /* x of axis 4 [m] */
    D4 = 0.4318, /* z of axis 5 [m] */
    free_limit_squared2 = 3.57281304106196e-24, /* square of a length that fixes no angle [m^2] */
    least_root1 = 5.977301264836799e-07, /* a root of nothing, by rounding [m] */
    longest3 = 0.7458049600000001, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    boundary3 = 2.435176934946171e-13, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.7458049599999674, /* the longest, where branches merge [m^2] */
    shortest3_apart = 3.5728130410619605e-28, /* the shortest, where branches merge [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.8636, /* L2 + D4 [m] */
    k2 = 0.022515002499999996, /* D3^2 [m^2] */
    k3 = 5.6724560659962443e-14, /* reach_slack1 * (2 * D3 + reach_slack1) [m^2] */
    k4 = 5.672456065993029e-15, /* merge_slack1 * (2 * D3 + merge_slack1) [m^2] */
    k5 = 0.5290477290765635, /* 1 / arm_size1 [m^-1] */
    k6 = 0.37290248000000004, /* 2 * D4 * L2 [m^2] */
    k7 = 2.681666262986505, /* 1 / k6 [m^-2] */
    f1 = 0.8636, /* L2 + D4 [m] */
    g1 = 0.8636; /* L2 + D4 [m] */

#ifndef __CUDACC_RTC__
const char *const puma_branches[8] = {
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

/* The axes at q = 0: a unit vector along each, and a point of it [m]. */
DHGEN_TABLE double table[6][6] = {
    { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 1.0, 0.0, 0.0, 0.0, 0.0, 0.4318 },
    { 0.0, 0.0, 1.0, 0.15005, 0.0, 0.0 },
    { 1.0, 0.0, 0.0, 0.15005, 0.0, 0.8636 },
    { 0.0, 0.0, 1.0, 0.15005, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_AXES, joints, &table[0][0], NULL, NULL, NULL };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void puma_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = s1 * s2, v1 = c1 * s2, y2_x = s1 * c2,
        v2 = c1 * c2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        v3 = v1 * c3 + v2 * s3, x3_z = c2 * c3 - s2 * s3, v4 = s2 * c3 + c2 * s3,
        v5 = x2_x * s3 - y2_x * c3, v6 = v2 * c3 - v1 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = c1 * c4 + v5 * s4, x4_y = s1 * c4 + v6 * s4,
        x4_z = v4 * s4, y4_z = v4 * c4, v7 = c1 * s4 - v5 * c4, v8 = s1 * s4 - v6 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x3_x * c5 + v7 * s5,
        x5_y = v8 * s5 - v3 * c5, x5_z = x3_z * c5 - y4_z * s5, y5_y = v8 * c5 + v3 * s5,
        v9 = y4_z * c5 + x3_z * s5, v10 = x3_x * s5 - v7 * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]), x6_x = x4_x * c6 + v10 * s6,
        x6_y = x4_y * c6 - y5_y * s6, x6_z = x4_z * c6 + v9 * s6;
    T[0] = x6_x; T[1] = v10 * c6 - x4_x * s6; T[2] = x5_x;
    T[3] = x2_x * L2 + c1 * D3 + x3_x * D4 - D3 * x6_x - x5_x * f1;
    T[4] = x6_y; T[5] = -(y5_y * c6 + x4_y * s6); T[6] = x5_y;
    T[7] = s1 * D3 - v1 * L2 - v3 * D4 - D3 * x6_y - x5_y * f1;
    T[8] = x6_z; T[9] = v9 * c6 - x4_z * s6; T[10] = x5_z;
    T[11] = c2 * L2 + x3_z * D4 - D3 * x6_z - x5_z * f1;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void puma_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = s1 * s2, v1 = c1 * s2, y2_x = s1 * c2,
        v2 = c1 * c2, p3_x = x2_x * L2, v3 = v1 * L2, p3_z = c2 * L2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        v4 = v1 * c3 + v2 * s3, x3_z = c2 * c3 - s2 * s3, v5 = s2 * c3 + c2 * s3,
        p4_x = p3_x + c1 * D3, p4_y = s1 * D3 - v3, v6 = x2_x * s3 - y2_x * c3,
        v7 = v2 * c3 - v1 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = c1 * c4 + v6 * s4, x4_y = s1 * c4 + v7 * s4,
        x4_z = v5 * s4, y4_z = v5 * c4, p5_x = p4_x + x3_x * D4, p5_y = p4_y - v4 * D4,
        p5_z = p3_z + x3_z * D4, v8 = c1 * s4 - v6 * c4, v9 = s1 * s4 - v7 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x3_x * c5 + v8 * s5,
        x5_y = v9 * s5 - v4 * c5, x5_z = x3_z * c5 - y4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]),
        J21 = p5_x - D3 * (x4_x * c6 + (x3_x * s5 - v8 * c5) * s6) - x5_x * g1,
        v10 = p5_y - D3 * (x4_y * c6 - (v9 * c5 + v4 * s5) * s6) - x5_y * g1,
        v11 = p5_z - D3 * (x4_z * c6 + (y4_z * c5 + x3_z * s5) * s6) - x5_z * g1, v12 = v11 - p3_z,
        v13 = J21 - p4_x, v14 = v10 - p4_y, v15 = J21 - p5_x, v16 = v10 - p5_y, v17 = v11 - p5_z;
    J[0] = -v10; J[1] = s1 * v11; J[2] = s1 * v12; J[3] = -(v4 * v12 + x3_z * v14);
    J[4] = x4_y * v17 - x4_z * v16; J[5] = x5_y * v17 - x5_z * v16;
    J[6] = J21; J[7] = -(c1 * v11); J[8] = -(c1 * v12); J[9] = x3_z * v13 - x3_x * v12;
    J[10] = x4_z * v15 - x4_x * v17; J[11] = x5_z * v15 - x5_x * v17;
    J[12] = 0.0; J[13] = c1 * v10 - s1 * J21; J[14] = c1 * (v3 + v10) - s1 * (J21 - p3_x);
    J[15] = x3_x * v14 + v4 * v13; J[16] = x4_x * v16 - x4_y * v15; J[17] = x5_x * v16 - x5_y * v15;
    J[18] = 0.0; J[19] = c1; J[20] = c1; J[21] = x3_x; J[22] = x4_x; J[23] = x5_x;
    J[24] = 0.0; J[25] = s1; J[26] = s1; J[27] = -v4; J[28] = x4_y; J[29] = x5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = x3_z; J[34] = x4_z; J[35] = x5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[1, 4] */
    const double t24 = T24 + D3 * T21 + k1 * T23;
    const double t14 = T14 + D3 * T11 + k1 * T13;
    const double N1 = t24 * t24 + t14 * t14;
    const double D1_squared = N1 - k2;
    const int apart1 = k4 < D1_squared;
    if (!(-k3 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double v1 = (apart1 ? w1 : least_root1) * k5;
    const double inverse1 = 1.0 / (apart1 ? N1 : D3 * sqrt(N1));
    const double v2 = D3 * t24, v3 = D3 * t14;

    /* theta3, type 8: U1[3, 4] and U1[2, 4] */
    const double t34 = T34 + D3 * T31 + k1 * T33;
    const double v4 = t34 * t34;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = inverse1 * (v3 + t24 * D1), s1 = inverse1 * (v2 - t14 * D1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double N3 = v4 + D1 * D1;
        const double K3 = N3 - k6;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= v1 * D3_squared)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double c3 = K3 * k7;

        /* theta2, type 3: U1[3, 4] and U1[2, 4] */
        const double Y1_2 = L2 + D4 * c3;
        const double v6 = D1 * Y1_2, v8 = t34 * Y1_2;

        /* theta4, type 2: U4[1, 3] */
        const double v9 = T13 * s1 - T23 * c1, v10 = T13 * c1 + T23 * s1, v11 = v10 * v10;

        /* theta6, type 3: U4[1, 2] and U4[1, 1] */
        const double v12 = T12 * c1 + T22 * s1, v13 = T12 * s1 - T22 * c1,
            v15 = T11 * c1 + T21 * s1, v16 = T11 * s1 - T21 * c1;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e3 * k7;
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double v5 = D4 * s3, v7 = t34 * v5 + v6;
            const double C2 = v8 - D1 * v5;
            const double w2 = sqrt(v7 * v7 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                s2 = free2 ? sin(seed[1]) : -(v7 * factor2);
            const double q2 = atan2(s2, c2);

            /* theta4 */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2;
            const double X4 = c23 * v9 - T33 * s23;
            const double w4 = sqrt(X4 * X4 + v11);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[3, 3] and U4[2, 3] */
            const double c5 = T33 * c23 + s23 * v9;

            /* theta6 */
            const double v14 = T32 * s23 - c23 * v13, v17 = T31 * s23 - c23 * v16;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : -(v10 * factor4);
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e4), c5);

                /* theta6 */
                const double c6 = c4 * v15 + s4 * v17;
                const double q6 = atan2(-(c4 * v12 + s4 * v14), c6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free2 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef PUMA_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit_squared2 = 3.57281304106196e-08 [m^2],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 5.672456065993029e-12, /* 1000 * k4 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 2.4343489251065266e-11,
    m3 = 1.1579434923575729, /* D4 * k7 [m^-1] */
    m4 = 1.276499302638241e-15, /* doubt_limit_squared2^2 [m^4] */
    m5 = 3.105217997900075, /* D4 * k7^2 [m^-3] */
    m6 = 2.3158869847151458, /* D4 * longest3 * k7^2 [m^-1] */
    m7 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide t24 = T24 + D3 * T21 + k1 * T23, t14 = T14 + D3 * T11 + k1 * T13,
        N1 = t24 * t24 + t14 * t14, D1_squared = N1 - k2, w1 = dhgen_sqrt_wide(D1_squared),
        v1 = w1 - w1, inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (D3 * t14),
        v3 = w1 * (t24 * inverse1), c1_p = v2 + v3, c1_m = v2 - v3, v4 = inverse1 * (D3 * t24),
        v5 = w1 * (t14 * inverse1), s1_p = v4 - v5, s1_m = v4 + v5;

    /* theta3 */
    const dhgen_wide t34 = T34 + D3 * T31 + k1 * T33, N3 = D1_squared + t34 * t34,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_wide(D3_squared),
        v6 = w3 - w3, angle1 = dhgen_atan2_wide(w3, N3 - k6);

    /* theta2 */
    const dhgen_wide v7 = w3 * (m3 * t34), v8 = m3 * (w1 * N3), v9 = v7 + v8, v10 = v8 - v7,
        v11 = m3 * (t34 * N3), v12 = w3 * (m3 * w1), C2_pp = v11 - v12, C2_pm = v11 + v12,
        v13 = v9 * v9 + C2_pp * C2_pp, v14 = C2_pm * C2_pm, v15 = v10 * v10 + v14,
        v16 = v14 - v10 * -v10, factor2_pp = dhgen_sqrt_wide(v13) * DHGEN_QUOTIENT(1.0, v13),
        factor2_pm = dhgen_sqrt_wide(v15) * DHGEN_QUOTIENT(1.0, v15),
        factor2_mp = dhgen_sqrt_wide(v16) * DHGEN_QUOTIENT(1.0, v16),
        angle2 = dhgen_atan2_wide(-v9, C2_pp), angle3 = dhgen_atan2_wide(-v10, C2_pm),
        angle4 = dhgen_atan2_wide(v10, C2_pm), angle5 = dhgen_atan2_wide(v9, C2_pp);

    /* theta4 */
    const dhgen_wide v17 = m5 * N3, v18 = m3 - v17, v19 = v17 - m6, v20 = w1 * (N3 * (v18 + v19)),
        s23_pp = v7 + v20, s23_pm = v20 - v7, v21 = w1 * (N3 * (-v18 - v19)), s23_mp = v7 + v21,
        s23_mm = v21 - v7, v22 = T13 * s1_p - T23 * c1_p, v23 = T13 * s1_m - T23 * c1_m,
        X4_pp = C2_pm * v22 - T33 * s23_pp, X4_pm = C2_pp * v22 - T33 * s23_pm,
        X4_mp = C2_pp * v23 - T33 * s23_mp, X4_mm = C2_pm * v23 - T33 * s23_mm,
        v24 = T13 * c1_p + T23 * s1_p, v25 = T13 * c1_m + T23 * s1_m, v26 = v24 * v24,
        v27 = v25 * v25, v28 = v26 + factor2_pp * (X4_pp * (factor2_pp * X4_pp)),
        v29 = v26 + factor2_pm * (X4_pm * (factor2_pm * X4_pm)),
        v30 = v27 + factor2_mp * (X4_mp * (factor2_mp * X4_mp)),
        v31 = v27 + factor2_pp * (X4_mm * (factor2_pp * X4_mm)),
        angle6 = dhgen_atan2_wide(-v24, factor2_pp * -X4_pp),
        angle7 = dhgen_atan2_wide(-v24, factor2_pm * -X4_pm),
        angle8 = dhgen_atan2_wide(-v25, factor2_mp * -X4_mp),
        angle9 = dhgen_atan2_wide(-v25, factor2_pp * -X4_mm),
        v32 = dhgen_signed_wide(DHGEN_HALF_TURN, -v24),
        v33 = dhgen_signed_wide(DHGEN_HALF_TURN, -v25);

    /* theta5 */
    const dhgen_wide v34 = T33 * C2_pm,
        angle10 = dhgen_atan2_wide(-dhgen_sqrt_wide(v28), factor2_pp * (v34 + s23_pp * v22)),
        v35 = T33 * C2_pp,
        angle11 = dhgen_atan2_wide(-dhgen_sqrt_wide(v29), factor2_pm * (v35 + s23_pm * v22)),
        angle12 = dhgen_atan2_wide(-dhgen_sqrt_wide(v30), factor2_mp * (v35 + s23_mp * v23)),
        angle13 = dhgen_atan2_wide(-dhgen_sqrt_wide(v31), factor2_pp * (v34 + s23_mm * v23));

    /* theta6 */
    const dhgen_wide v36 = c1_p * T12 + s1_p * T22, v37 = c1_m * T12 + s1_m * T22,
        v38 = s1_p * T12 - c1_p * T22, v39 = s1_m * T12 - c1_m * T22, v40 = T11 * c1_p + T21 * s1_p,
        v41 = T11 * c1_m + T21 * s1_m, v42 = T11 * s1_p - T21 * c1_p, v43 = T11 * s1_m - T21 * c1_m,
        v44 = v24 * (s23_pp * T32 - C2_pm * v38) + X4_pp * v36,
        v45 = v24 * (s23_pm * T32 - C2_pp * v38) + X4_pm * v36,
        v46 = v25 * (s23_mp * T32 - C2_pp * v39) + X4_mp * v37,
        v47 = v25 * (s23_mm * T32 - C2_pm * v39) + X4_mm * v37,
        angle14 = dhgen_atan2_wide(v44, -X4_pp * v40 - v24 * (T31 * s23_pp - C2_pm * v42)),
        angle15 = dhgen_atan2_wide(v45, -X4_pm * v40 - v24 * (T31 * s23_pm - C2_pp * v42)),
        angle16 = dhgen_atan2_wide(v46, -X4_mp * v41 - v25 * (T31 * s23_mp - C2_pp * v43)),
        angle17 = dhgen_atan2_wide(v47, -X4_mm * v41 - v25 * (T31 * s23_mm - C2_pm * v43));

    /* joint values */
    const dhgen_wide angle18 = dhgen_atan2_wide(s1_p, c1_p), q1_ppp = v6 + angle18,
        angle19 = dhgen_atan2_wide(s1_m, c1_m), q1_mpp = v6 + angle19, q3_ppp = v1 + angle1,
        q3_pmp = v1 - angle1;

    q[0] = q1_ppp; q[1] = angle2; q[2] = q3_ppp; q[3] = angle6; q[4] = angle10; q[5] = angle14;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_ppp; q[7] = angle2; q[8] = q3_ppp; q[9] = angle6 - v32; q[10] = -angle10;
    q[11] = angle14 - dhgen_signed_wide(DHGEN_HALF_TURN, v44);
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_ppp; q[13] = angle3; q[14] = q3_pmp; q[15] = angle7; q[16] = angle11;
    q[17] = angle15;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_ppp; q[19] = angle3; q[20] = q3_pmp; q[21] = angle7 - v32; q[22] = -angle11;
    q[23] = angle15 - dhgen_signed_wide(DHGEN_HALF_TURN, v45);
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = angle4; q[26] = q3_ppp; q[27] = angle8; q[28] = angle12;
    q[29] = angle16;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = angle4; q[32] = q3_ppp; q[33] = angle8 - v33; q[34] = -angle12;
    q[35] = angle16 - dhgen_signed_wide(DHGEN_HALF_TURN, v46);
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mpp; q[37] = angle5; q[38] = q3_pmp; q[39] = angle9; q[40] = angle13;
    q[41] = angle17;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mpp; q[43] = angle5; q[44] = q3_pmp; q[45] = angle9 - v33; q[46] = -angle13;
    q[47] = angle17 - dhgen_signed_wide(DHGEN_HALF_TURN, v47);
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v31 <= m7) | (v30 <= m7) | (v16 <= m4) | (v29 <= m7) | (v15 <= m4) |
        (v28 <= m7) | (dhgen_abs_wide(D1_squared) <= m1) | (dhgen_abs_wide(D3_squared * (k5 * w1))
        <= m2) | (v13 <= m4));
}

#if DHGEN_LANES > 1
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
    const double t24 = T24 + D3 * T21 + k1 * T23, t14 = T14 + D3 * T11 + k1 * T13,
        N1 = t24 * t24 + t14 * t14, D1_squared = N1 - k2, w1 = sqrt(D1_squared), v1 = w1 - w1,
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (D3 * t14);
    const dhgen_four c1 = v2 + w1 * (inverse1 * (e1 * t24));
    const double v3 = inverse1 * (D3 * t24);
    const dhgen_four s1 = v3 - w1 * (inverse1 * (e1 * t14));

    /* theta3 */
    const double t34 = T34 + D3 * T31 + k1 * T33, N3 = D1_squared + t34 * t34,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared), v4 = w3 - w3;

    /* theta2 */
    const dhgen_four v5 = w3 * (m3 * (e3 * t34)), v6 = m3 * (w1 * (e1 * N3)), v7 = v5 + v6,
        v8 = e1 * e3;
    const double v9 = m3 * (t34 * N3);
    const dhgen_four C2 = v9 - w3 * (m3 * (w1 * v8)), v10 = v7 * v7 + C2 * C2,
        factor2 = dhgen_sqrt_four(v10) * DHGEN_QUOTIENT(1.0, v10);

    /* theta4 */
    const dhgen_four c23 = v9 + w3 * (w1 * (m3 * v8));
    const double v11 = m5 * N3, v12 = m3 - v11;
    const dhgen_four v13 = e1 * v12;
    const double v14 = v11 - m6;
    const dhgen_four v15 = e3 * v14, s23 = v5 + w1 * (N3 * (v13 + v8 * v15)),
        v16 = T13 * s1 - T23 * c1, X4 = c23 * v16 - T33 * s23, v17 = T13 * c1 + T23 * s1,
        v18 = v17 * v17, v19 = v18 + factor2 * (X4 * (factor2 * X4)),
        v20 = dhgen_signed_four(DHGEN_HALF_TURN, -v17);

    /* theta6 */
    const dhgen_four v21 = c1 * T12 + s1 * T22, v22 = s1 * T12 - c1 * T22,
        v23 = T11 * c1 + T21 * s1, v24 = T11 * s1 - T21 * c1,
        v25 = v17 * (s23 * T32 - c23 * v22) + X4 * v21;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((v10 <= m4) |
        (v19 <= m7))) | (unsigned)((fabs(D1_squared) <= m1) | (fabs(D3_squared * (k5 * w1)) <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(s1, dhgen_all_four(w3), 0, 5,
        2, 3), dhgen_shuffle(c1, dhgen_all_four(N3 - k6), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(-v7, C2),
        ratio3 = dhgen_ratio_four(v25, -X4 * v23 - v17 * (T31 * s23 - c23 * v24)),
        ratio4 = dhgen_ratio_four(-v17, factor2 * -X4),
        ratio5 = dhgen_ratio_four(-dhgen_sqrt_four(v19), factor2 * (T33 * c23 + s23 * v16));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle6 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle2 = dhgen_angle_four(ratio2),
        angle5 = dhgen_angle_four(ratio3), angle3 = dhgen_angle_four(ratio4),
        angle4 = dhgen_angle_four(ratio5);
    const dhgen_four q4_m = angle3 - v20, q6_m = angle5 - dhgen_signed_four(DHGEN_HALF_TURN, v25),
        q1_p = v4 + angle6, q3_p = v1 + e3 * angle1;

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, angle2, q3_p, angle3);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, angle4, angle5);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, angle2, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, -angle4, q6_m);
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
    { 0.529, 0.529, 0.529, 1.0, 1.0, 1.0 }, 0.5290477290765635, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 2, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, puma_fk,
    puma_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) puma_##function
#include "dhgen/functions.h"

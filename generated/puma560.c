/* puma560: Unimation PUMA 560
 *
 * Inverse kinematics, generated from robots/puma560.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma560.yaml. The formulas and where they come from: puma560.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: c347f76f4868f211
 * SPDX-License-Identifier: MIT
 */
#include "puma560.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(PUMA560_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(PUMA560_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef PUMA560_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 1.7057800000000002e-13 [m], merge_slack1 = 1.70578e-14 [m],
 * arm_size1 = 1.70578 [m]. */
static const double
    d1 = 0.67183, /* joint offset 1 [m] */
    a2 = 0.4318, /* link length 2 [m] */
    d3 = 0.15005, /* joint offset 3 [m] */
    a3 = 0.0203, /* link length 3 [m] */
    d4 = 0.4318, /* joint offset 4 [m] */
    free_limit_squared2 = 2.9096854084e-24, /* square of a length that fixes no angle [m^2] */
    least_root1 = 5.394149987162018e-07, /* a root of nothing, by rounding [m] */
    longest3 = 0.7466289125534531, /* square of the longest reach [m^2] */
    shortest3 = 2.274465470660925e-07, /* square of the shortest reach [m^2] */
    boundary3 = 2.1999652436149993e-13, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.7466289125534236, /* the longest, where branches merge [m^2] */
    shortest3_apart = 2.2744654708236271e-07, /* the shortest, where branches merge [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.022515002499999996, /* d3^2 [m^2] */
    k2 = 5.11904578000291e-14, /* reach_slack1 * (2 * d3 + reach_slack1) [m^2] */
    k3 = 5.1190457800002905e-15, /* merge_slack1 * (2 * d3 + merge_slack1) [m^2] */
    k4 = 0.5862420710759887, /* 1 / arm_size1 [m^-1] */
    k5 = 0.37290248000000004, /* 2 * d4 * a2 [m^2] */
    k6 = 0.01753108, /* 2 * a3 * a2 [m^2] */
    k7 = 0.37331457, /* d4 * a2 + (a3^2 + d4 * a2) [m^2] */
    k8 = 7.175474885806929; /* 1 / (k5^2 + k6^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const puma560_branches[8] = {
    "right-down-noflip", "right-down-flip", "right-up-noflip", "right-up-flip", "left-up-noflip",
    "left-up-flip", "left-down-noflip", "left-down-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.792526803190927, 2.792526803190927, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -1.9198621771937625, 1.9198621771937625, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.356194490192345, 2.356194490192345, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -4.642575810304916, 4.642575810304916, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -1.7453292519943295, 1.7453292519943295, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -4.642575810304916, 4.642575810304916, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.67183, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.4318, 0.0 },
    { 0.0, 0.15005, 0.0203, -1.5707963267948966 },
    { 0.0, 0.4318, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void puma560_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, z3_z = c2 * c3 - s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4,
        y5_y = c1 * c4 - x3_y * s4, z4_z = x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v3 * s5,
        x5_y = x4_y * c5 - v4 * s5, x5_z = x4_z * c5 + z3_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - z4_x * s6; T[1] = -(z4_x * c6 + x5_x * s6); T[2] = -(v3 * c5 + x4_x * s5);
    T[3] = x2_x * a2 + x3_x * a3 + s1 * d3 - v3 * d4;
    T[4] = x5_y * c6 + y5_y * s6; T[5] = y5_y * c6 - x5_y * s6; T[6] = -(v4 * c5 + x4_y * s5);
    T[7] = x2_y * a2 + x3_y * a3 - c1 * d3 - v4 * d4;
    T[8] = x5_z * c6 - z4_z * s6; T[9] = -(z4_z * c6 + x5_z * s6); T[10] = z3_z * c5 - x4_z * s5;
    T[11] = d1 + s2 * a2 + x3_z * a3 + z3_z * d4;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void puma560_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, z3_z = c2 * c3 - s2 * s3, p3_z = p2_z + x3_z * a3,
        p3_x = p2_x + x3_x * a3 + s1 * d3, p3_y = p2_y + x3_y * a3 - c1 * d3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), p4_x = p3_x - v3 * d4, p4_y = p3_y - v4 * d4,
        p4_z = p3_z + z3_z * d4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), v5 = p4_z - d1, v6 = p4_z - p2_z, v7 = p4_x - p3_x,
        v8 = p4_y - p3_y, v9 = p4_z - p3_z;
    J[0] = -p4_y; J[1] = -(c1 * v5); J[2] = -(c1 * v6); J[3] = -(v4 * v9 + z3_z * v8); J[4] = 0.0;
    J[5] = 0.0;
    J[6] = p4_x; J[7] = -(s1 * v5); J[8] = -(s1 * v6); J[9] = z3_z * v7 + v3 * v9; J[10] = 0.0;
    J[11] = 0.0;
    J[12] = 0.0; J[13] = s1 * p4_y + c1 * p4_x; J[14] = s1 * (p4_y - p2_y) + c1 * (p4_x - p2_x);
    J[15] = v4 * v7 - v3 * v8; J[16] = 0.0; J[17] = 0.0;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = -v3; J[22] = s1 * c4 + x3_x * s4;
    J[23] = -(v3 * c5 + (x3_x * c4 - s1 * s4) * s5);
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -v4; J[28] = x3_y * s4 - c1 * c4;
    J[29] = -(v4 * c5 + (x3_y * c4 + c1 * s4) * s5);
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = x3_z * s4;
    J[35] = z3_z * c5 - x3_z * c4 * s5;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[3, 4] */
    const double N1 = T14 * T14 + T24 * T24;
    const double D1_squared = N1 - k1;
    const int apart1 = k3 < D1_squared;
    if (!(-k2 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double v1 = (apart1 ? w1 : least_root1) * k4;
    const double inverse1 = 1.0 / (apart1 ? N1 : d3 * sqrt(N1));
    const double v2 = T14 * d3, v3 = T24 * d3;

    /* theta3, type 6: U1[2, 4] and U1[1, 4] */
    const double Z1_3 = T34 - d1;
    const double v4 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = inverse1 * (T14 * D1 - v3), s1 = inverse1 * (v2 + T24 * D1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double N3 = v4 + D1 * D1;
        const double K3 = N3 - k7;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= v1 * D3_squared)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double v5 = k5 * K3, v6 = k6 * K3;

        /* theta4, type 2: U4[3, 3] */
        const double v7 = T13 * c1 + T23 * s1;
        const double Y4 = T23 * c1 - T13 * s1;
        const double v9 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v10 = T12 * s1 - T22 * c1, v11 = T12 * c1 + T22 * s1,
            v13 = T11 * s1 - T21 * c1, v14 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double D3 = w3 * e3;
            const double s3 = (k6 * D3 - v5) * k8, c3 = k8 * (v6 + k5 * D3);
            const double q3 = atan2(s3, c3);

            /* theta2, type 3: U1[2, 4] and U1[1, 4] */
            const double X1_2 = a2 + (a3 * c3 - d4 * s3);
            const double Y1_2 = d4 * c3 + a3 * s3;
            const double S2 = Z1_3 * X1_2 - D1 * Y1_2;
            const double C2 = D1 * X1_2 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);

            /* theta4 */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2,
                v8 = c23 * v7 + T33 * s23;
            const double w4 = sqrt(v8 * v8 + v9);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * c23 - s23 * v7;

            /* theta6 */
            const double v12 = c23 * v11 + T32 * s23, v15 = c23 * v14 + T31 * s23;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : v8 * factor4,
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e4), c5);

                /* theta6 */
                const double q6 = atan2(-(c4 * v13 + s4 * v15), -(c4 * v10 + s4 * v12));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free2 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef PUMA560_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    turn1 = 1.5238184104468135, /* atan2(k5, k6) [rad] */
    m1 = 5.119045780000291e-12, /* 1000 * k3 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 2.2049387897563516e-11,
    m3 = 0.12579382426107213, /* k6 * k8 [m^-2] */
    m4 = 0.9988973492016866, /* k5 * k7 * k8 */
    m5 = 2.675752380095121, /* k5 * k8 [m^-2] */
    m6 = 0.046960667412677716, /* k6 * k7 * k8 */
    m7 = 1.1579434923575729, /* k8 * (d4 * k5 + a3 * k6) [m^-1] */
    m8 = 0.000477176933765627, /* d4 * k5 * k7 * k8 + a3 * k6 * k7 * k8 - a2 [m] */
    m9 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide N1 = T14 * T14 + T24 * T24, D1_squared = N1 - k1,
        w1 = dhgen_sqrt_wide(D1_squared), v1 = w1 - w1, inverse1 = DHGEN_QUOTIENT(1.0, N1),
        v2 = inverse1 * (d3 * T24), v3 = w1 * (T14 * inverse1), c1_p = v3 - v2, v4 = v2 + v3,
        v5 = inverse1 * (d3 * T14), v6 = w1 * (T24 * inverse1), s1_p = v5 + v6, s1_m = v5 - v6,
        angle1 = dhgen_atan2_wide(s1_p, c1_p), angle2 = dhgen_atan2_wide(s1_m, -v4);

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d1, N3 = D1_squared + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_wide(D3_squared),
        v7 = w3 - w3, v8 = m4 - m5 * N3, v9 = m3 * w3, s3_p = v8 + v9, s3_m = v8 - v9,
        v10 = m3 * N3 - m6, v11 = m5 * w3, c3_p = v10 + v11, c3_m = v10 - v11,
        angle3 = dhgen_atan2_wide(w3, N3 - k7), q3__p = angle3 - turn1, v12 = turn1 + angle3;

    /* theta2 */
    const dhgen_wide X1_2 = m7 * N3 - m8, v13 = Z1_3 * X1_2, v14 = w3 * (m7 * w1),
        S2_pp = v13 - v14, S2_pm = v13 + v14, v15 = w3 * (m7 * Z1_3), v16 = w3 * (m7 * -Z1_3),
        v17 = w1 * X1_2, v18 = w1 * -X1_2, C2_pp = v15 + v17, C2_pm = v16 + v17, C2_mp = v15 + v18,
        C2_mm = v16 + v18, factor2 = DHGEN_QUOTIENT(1.0, N3),
        angle4 = dhgen_atan2_wide(S2_pp, C2_pp), angle5 = dhgen_atan2_wide(S2_pm, C2_pm),
        angle6 = dhgen_atan2_wide(S2_pm, C2_mp), angle7 = dhgen_atan2_wide(S2_pp, C2_mm);

    /* theta4 */
    const dhgen_wide c23_pp = c3_p * C2_pp - s3_p * S2_pp, c23_pm = c3_m * C2_pm - s3_m * S2_pm,
        c23_mp = c3_p * C2_mp - s3_p * S2_pm, c23_mm = c3_m * C2_mm - s3_m * S2_pp,
        s23_pp = c3_p * S2_pp + s3_p * C2_pp, s23_pm = c3_m * S2_pm + s3_m * C2_pm,
        s23_mp = c3_p * S2_pm + s3_p * C2_mp, s23_mm = c3_m * S2_pp + s3_m * C2_mm,
        v19 = c1_p * T13 + s1_p * T23, v20 = s1_m * T23 - v4 * T13,
        c4_pp = c23_pp * v19 + s23_pp * T33, c4_pm = c23_pm * v19 + s23_pm * T33,
        c4_mp = c23_mp * v20 + s23_mp * T33, c4_mm = c23_mm * v20 + s23_mm * T33,
        Y4_p = c1_p * T23 - s1_p * T13, v21 = v4 * T23 + s1_m * T13, v22 = Y4_p * Y4_p,
        v23 = v21 * v21, v24 = factor2 * c4_pp, v25 = factor2 * c4_pm, v26 = factor2 * c4_mp,
        v27 = factor2 * c4_mm, v28 = v22 + factor2 * (c4_pp * v24),
        v29 = v22 + factor2 * (c4_pm * v25), v30 = v23 + factor2 * (c4_mp * v26),
        v31 = v23 + factor2 * (c4_mm * v27), angle8 = dhgen_atan2_wide(Y4_p, v24),
        angle9 = dhgen_atan2_wide(Y4_p, v25), angle10 = dhgen_atan2_wide(-v21, v26),
        angle11 = dhgen_atan2_wide(-v21, v27), v32 = dhgen_signed_wide(DHGEN_HALF_TURN, Y4_p),
        v33 = dhgen_signed_wide(DHGEN_HALF_TURN, -v21);

    /* theta5 */
    const dhgen_wide angle12 = dhgen_atan2_wide(-dhgen_sqrt_wide(v28), factor2 * (c23_pp * T33 -
        s23_pp * v19)),
        angle13 = dhgen_atan2_wide(-dhgen_sqrt_wide(v29), factor2 * (c23_pm * T33 - s23_pm * v19)),
        angle14 = dhgen_atan2_wide(-dhgen_sqrt_wide(v30), factor2 * (c23_mp * T33 - s23_mp * v20)),
        angle15 = dhgen_atan2_wide(-dhgen_sqrt_wide(v31), factor2 * (c23_mm * T33 - s23_mm * v20));

    /* theta6 */
    const dhgen_wide v34 = s1_p * T12 - c1_p * T22, v35 = s1_m * T12 + v4 * T22,
        v36 = c1_p * T12 + s1_p * T22, v37 = s1_m * T22 - v4 * T12, v38 = s1_p * T11 - c1_p * T21,
        v39 = s1_m * T11 + v4 * T21, v40 = c1_p * T11 + s1_p * T21, v41 = s1_m * T21 - v4 * T11,
        angle16 = dhgen_atan2_wide(-(c4_pp * v38 + Y4_p * (c23_pp * v40 + s23_pp * T31)), -(c4_pp *
            v34 + Y4_p * (c23_pp * v36 + s23_pp * T32))),
        angle17 = dhgen_atan2_wide(-(c4_pm * v38 + Y4_p * (c23_pm * v40 + s23_pm * T31)), -(c4_pm *
            v34 + Y4_p * (c23_pm * v36 + s23_pm * T32))),
        v42 = v21 * (c23_mp * v41 + s23_mp * T31) - c4_mp * v39,
        angle18 = dhgen_atan2_wide(v42, v21 * (c23_mp * v37 + s23_mp * T32) - c4_mp * v35),
        v43 = v21 * (c23_mm * v41 + s23_mm * T31) - c4_mm * v39,
        angle19 = dhgen_atan2_wide(v43, v21 * (c23_mm * v37 + s23_mm * T32) - c4_mm * v35);

    /* joint values */
    const dhgen_wide v44 = dhgen_raised_wide(q3__p),
        v45 = dhgen_only_wide(-v12 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v12,
        v46 = dhgen_exceeds_wide(angle1, joints), v47 = dhgen_exceeds_wide(angle2, joints),
        v48 = dhgen_exceeds_wide(v44, joints + 2), v49 = dhgen_exceeds_wide(v45, joints + 2),
        q1_ppp = angle1 + v7, q1_mpp = angle2 + v7, q3_ppp = v1 + v44, q3_pmp = v1 + v45,
        excess_pp = dhgen_maximum_wide(dhgen_exceeds_wide(angle12, joints + 4),
            dhgen_maximum_wide(dhgen_exceeds_wide(angle4, joints + 1), dhgen_maximum_wide(v46,
            v48))),
        excess_pm = dhgen_maximum_wide(dhgen_exceeds_wide(angle13, joints + 4),
            dhgen_maximum_wide(dhgen_exceeds_wide(angle5, joints + 1), dhgen_maximum_wide(v46,
            v49))),
        excess_mp = dhgen_maximum_wide(dhgen_exceeds_wide(angle14, joints + 4),
            dhgen_maximum_wide(dhgen_exceeds_wide(angle6, joints + 1), dhgen_maximum_wide(v47,
            v48))),
        excess_mm = dhgen_maximum_wide(dhgen_exceeds_wide(angle15, joints + 4),
            dhgen_maximum_wide(dhgen_exceeds_wide(angle7, joints + 1), dhgen_maximum_wide(v47,
            v49)));
    const dhgen_wide_mask outside_ppp = 0.0 < excess_pp, outside_pmp = 0.0 < excess_pm,
        outside_mpp = 0.0 < excess_mp, outside_mmp = 0.0 < excess_mm;

    q[0] = q1_ppp; q[1] = angle4; q[2] = q3_ppp; q[3] = angle8; q[4] = angle12; q[5] = angle16;
    kind[0] = dhgen_kind_within_wide(q[0], outside_ppp);
    q[6] = q1_ppp; q[7] = angle4; q[8] = q3_ppp; q[9] = angle8 - v32; q[10] = -angle12;
    q[11] = angle16 - dhgen_signed_wide(DHGEN_HALF_TURN, -(c4_pp * v38 + Y4_p * (c23_pp * v40 +
        s23_pp * T31)));
    kind[1] = dhgen_kind_within_wide(q[6], outside_ppp);
    q[12] = q1_ppp; q[13] = angle5; q[14] = q3_pmp; q[15] = angle9; q[16] = angle13;
    q[17] = angle17;
    kind[2] = dhgen_kind_within_wide(q[12], outside_pmp);
    q[18] = q1_ppp; q[19] = angle5; q[20] = q3_pmp; q[21] = angle9 - v32; q[22] = -angle13;
    q[23] = angle17 - dhgen_signed_wide(DHGEN_HALF_TURN, -(c4_pm * v38 + Y4_p * (c23_pm * v40 +
        s23_pm * T31)));
    kind[3] = dhgen_kind_within_wide(q[18], outside_pmp);
    q[24] = q1_mpp; q[25] = angle6; q[26] = q3_ppp; q[27] = angle10; q[28] = angle14;
    q[29] = angle18;
    kind[4] = dhgen_kind_within_wide(q[24], outside_mpp);
    q[30] = q1_mpp; q[31] = angle6; q[32] = q3_ppp; q[33] = angle10 - v33; q[34] = -angle14;
    q[35] = angle18 - dhgen_signed_wide(DHGEN_HALF_TURN, v42);
    kind[5] = dhgen_kind_within_wide(q[30], outside_mpp);
    q[36] = q1_mpp; q[37] = angle7; q[38] = q3_pmp; q[39] = angle11; q[40] = angle15;
    q[41] = angle19;
    kind[6] = dhgen_kind_within_wide(q[36], outside_mmp);
    q[42] = q1_mpp; q[43] = angle7; q[44] = q3_pmp; q[45] = angle11 - v33; q[46] = -angle15;
    q[47] = angle19 - dhgen_signed_wide(DHGEN_HALF_TURN, v43);
    kind[7] = dhgen_kind_within_wide(q[42], outside_mmp);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D3_squared * (k4 * w1)) <= m2) |
        (dhgen_abs_wide(D1_squared) <= m1) | (v31 <= m9) | (v30 <= m9) | (v28 <= m9) | (v29 <= m9))
        | (dhgen_within_slack_wide(excess_mm) | dhgen_within_slack_wide(excess_mp) |
        dhgen_within_slack_wide(excess_pp) | dhgen_within_slack_wide(excess_pm));
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
    const double N1 = T14 * T14 + T24 * T24, D1_squared = N1 - k1, w1 = sqrt(D1_squared),
        v1 = w1 - w1, inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (d3 * T24);
    const dhgen_four c1 = w1 * (inverse1 * (e1 * T14)) - v2;
    const double v3 = inverse1 * (d3 * T14);
    const dhgen_four s1 = v3 + w1 * (inverse1 * (e1 * T24));

    /* theta3 */
    const double Z1_3 = T34 - d1, N3 = D1_squared + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared), v4 = w3 - w3,
        v5 = m4 - m5 * N3;
    const dhgen_four s3 = v5 + w3 * (m3 * e3);
    const double v6 = m3 * N3 - m6;
    const dhgen_four c3 = v6 + w3 * (m5 * e3);

    /* theta2 */
    const double X1_2 = m7 * N3 - m8, v7 = Z1_3 * X1_2;
    const dhgen_four S2 = v7 - w3 * (m7 * (w1 * (e1 * e3))), v8 = w3 * (m7 * (e3 * Z1_3)),
        v9 = w1 * (e1 * X1_2), C2 = v8 + v9;
    const double factor2 = DHGEN_QUOTIENT(1.0, N3);

    /* theta4 */
    const dhgen_four c23 = c3 * C2 - s3 * S2, s23 = c3 * S2 + s3 * C2, v10 = c1 * T13 + s1 * T23,
        c4 = c23 * v10 + s23 * T33, Y4 = c1 * T23 - s1 * T13, v11 = Y4 * Y4, v12 = factor2 * c4,
        v13 = v11 + factor2 * (c4 * v12), v14 = dhgen_signed_four(DHGEN_HALF_TURN, Y4);

    /* theta6 */
    const dhgen_four v15 = s1 * T12 - c1 * T22, v16 = c1 * T12 + s1 * T22,
        v17 = s1 * T11 - c1 * T21, v18 = c1 * T11 + s1 * T21;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | (v13 <= m9)) |
        (unsigned)((fabs(D1_squared) <= m1) | (fabs(D3_squared * (k4 * w1)) <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(s1, dhgen_all_four(w3), 0, 5,
        2, 3), dhgen_shuffle(c1, dhgen_all_four(N3 - k7), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(S2, C2), ratio3 = dhgen_ratio_four(Y4, v12),
        ratio4 = dhgen_ratio_four(-(c4 * v17 + Y4 * (c23 * v18 + s23 * T31)), -(c4 * v15 + Y4 * (c23
            * v16 + s23 * T32))),
        ratio5 = dhgen_ratio_four(-dhgen_sqrt_four(v13), factor2 * (c23 * T33 - s23 * v10));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = dhgen_angle_four(ratio2),
        angle4 = dhgen_angle_four(ratio3), angle6 = dhgen_angle_four(ratio4),
        angle5 = dhgen_angle_four(ratio5);
    const dhgen_four q3_ = e3 * angle2 - turn1, q4_m = angle4 - v14,
        q6_m = angle6 - dhgen_signed_four(DHGEN_HALF_TURN, -(c4 * v17 + Y4 * (c23 * v18 + s23 *
            T31))), v19 = dhgen_raised_four(q3_), v20 = dhgen_exceeds_four(angle1, joints),
        v21 = dhgen_exceeds_four(v19, joints + 2), q1_p = angle1 + v4, q3_p = v1 + v19,
        excess = dhgen_maximum_four(dhgen_exceeds_four(angle5, joints + 4),
            dhgen_maximum_four(dhgen_exceeds_four(angle3, joints + 1), dhgen_maximum_four(v20,
            v21)));
    const dhgen_four_mask outside_p = 0.0 < excess;
    if (dhgen_bits_four(dhgen_within_slack_four(excess)))
        return -1;

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, angle3, q3_p, angle4);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, angle5, angle6);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, angle3, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, -angle5, q6_m);
    const unsigned long long none1 = (dhgen_bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long outside1 = (dhgen_bits_four(outside_p) * 0x20204040808101ull &
        0x101010101010101ull);
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
    { 0.5862, 0.5862, 0.5862, 1.0, 1.0, 1.0 }, 0.5862420710759887, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, puma560_fk,
    puma560_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) puma560_##function
#include "dhgen/functions.h"

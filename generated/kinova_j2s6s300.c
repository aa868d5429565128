/* kinova_j2s6s300: Kinova Jaco j2s6s300, spherical wrist
 *
 * Inverse kinematics, generated from robots/kinova_j2s6s300.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kinova_j2s6s300.yaml. The formulas and where they come from:
 * kinova_j2s6s300.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 221669a4b13488f8
 * SPDX-License-Identifier: MIT
 */
#include "kinova_j2s6s300.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KINOVA_J2S6S300_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KINOVA_J2S6S300_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef KINOVA_J2S6S300_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 1.2733e-13 [m], merge_slack1 = 1.2733e-14 [m],
 * arm_size1 = 1.2732999999999999 [m]. */
static const double
    d1 = 0.2755, /* joint offset 1 [m] */
    d2 = 0.0016, /* joint offset 2 [m] */
    a2 = 0.41, /* link length 2 [m] */
    d3 = 0.0114, /* joint offset 3 [m] */
    d4 = 0.31105, /* joint offset 4 [m] */
    d6 = 0.26375, /* joint offset 6 [m] */
    least_root1 = 4.026528144692397e-07, /* a root of nothing, by rounding [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    longest3 = 0.5199131025, /* square of the longest reach [m^2] */
    shortest3 = 0.009791102499999996, /* square of the shortest reach [m^2] */
    boundary3 = 9.367415598763348e-14, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.5199131024999816, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.009791102500002518, /* the shortest, where branches merge [m^2] */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    offset6 = -1.5707963267948966, /* offset of joint 6 [rad] */
    k1 = -0.0098, /* d2 - d3 [m] */
    k2 = 9.604000000000001e-05, /* k1^2 [m^2] */
    k3 = 2.495668000016213e-15, /* reach_slack1 * (reach_slack1 - k1 * 2) [m^2] */
    k4 = 2.4956680000016213e-16, /* merge_slack1 * (merge_slack1 - k1 * 2) [m^2] */
    k5 = 0.7853608733212912, /* 1 / arm_size1 [m^-1] */
    k6 = 0.255061, /* 2 * d4 * a2 [m^2] */
    k7 = 0.26485210249999996, /* a2^2 + d4^2 [m^2] */
    k8 = 15.371345486276748; /* 1 / (k6^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const kinova_j2s6s300_branches[8] = {
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-up-noflip",
    "right-up-flip", "right-down-noflip", "right-down-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { 0.8203047484373349, 5.462880558742252, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { 0.33161255787892263, 5.951572749300664, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { 0.5235987755982988, 5.759586531581287, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 3.141592653589793, -0.2755, 0.0, 1.5707963267948966 },
    { 1.5707963267948966, -0.0016, 0.41, 3.141592653589793 },
    { 1.5707963267948966, -0.0114, 0.0, 1.5707963267948966 },
    { 0.0, -0.31105, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { -1.5707963267948966, -0.26375, 0.0, 3.141592653589793 },
};
DHGEN_TABLE double base[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 };
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, base, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void kinova_j2s6s300_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, v3 = s1 * c2, y2_x = c1 * s2,
        v4 = s1 * s2, v5 = q[2] + offset3;
    const double c3 = cos(v5), s3 = sin(v5), x3_x = x2_x * c3 + y2_x * s3, v6 = v3 * c3 + v4 * s3,
        x3_z = c2 * s3 - s2 * c3, v7 = c2 * c3 + s2 * s3, z3_x = x2_x * s3 - y2_x * c3,
        z3_y = v4 * c3 - v3 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4, v8 = v6 * c4 + c1 * s4,
        x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4, z4_y = c1 * c4 - v6 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = z3_y * s5 - v8 * c5, x5_z = x4_z * c5 - v7 * s5, z6_x = z3_x * c5 - x4_x * s5,
        z6_y = z3_y * c5 + v8 * s5, z5_z = v7 * c5 + x4_z * s5, v9 = q[5] + offset6;
    const double c6 = cos(v9), s6 = sin(v9);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = x5_x * s6 - z4_x * c6; T[2] = z6_x;
    T[3] = x2_x * a2 - s1 * d2 + s1 * d3 - z3_x * d4 - -z6_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = x5_y * s6 - z4_y * c6; T[6] = z6_y;
    T[7] = c1 * d3 - (v3 * a2 + c1 * d2) - z3_y * d4 + z6_y * d6;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = x5_z * s6 - z4_z * c6; T[10] = -z5_z;
    T[11] = d1 - s2 * a2 + v7 * d4 - z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void kinova_j2s6s300_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, v3 = s1 * c2, y2_x = c1 * s2,
        v4 = s1 * s2, p2_z = d1 - s2 * a2, p2_x = x2_x * a2 - s1 * d2, v5 = v3 * a2 + c1 * d2,
        v6 = q[2] + offset3;
    const double c3 = cos(v6), s3 = sin(v6), x3_x = x2_x * c3 + y2_x * s3, v7 = v3 * c3 + v4 * s3,
        x3_z = c2 * s3 - s2 * c3, v8 = c2 * c3 + s2 * s3, p3_x = p2_x + s1 * d3,
        p3_y = c1 * d3 - v5, z3_x = x2_x * s3 - y2_x * c3, z3_y = v4 * c3 - v3 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        p4_x = p3_x - z3_x * d4, p4_y = p3_y - z3_y * d4, p4_z = p2_z + v8 * d4,
        z4_y = c1 * c4 - v7 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z6_y = z3_y * c5 + (v7 * c4 + c1 * s4) * s5,
        z5_z = v8 * c5 + x3_z * c4 * s5, z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5,
        p6_x = p4_x - z5_x * d6, p6_y = p4_y + z6_y * d6, p6_z = p4_z - z5_z * d6, v9 = p6_z - d1,
        v10 = p6_z - p2_z, v11 = p6_x - p3_x, v12 = p6_y - p3_y, v13 = p6_x - p4_x,
        v14 = p6_y - p4_y, v15 = p6_z - p4_z;
    J[0] = p6_y; J[1] = c1 * v9; J[2] = -(c1 * v10); J[3] = z3_y * v10 + v8 * v12;
    J[4] = z4_y * v15 - z4_z * v14; J[5] = -(z6_y * v15 + z5_z * v14);
    J[6] = -p6_x; J[7] = -(s1 * v9); J[8] = s1 * v10; J[9] = -(v8 * v11 + z3_x * v10);
    J[10] = z4_z * v13 - z4_x * v15; J[11] = z5_z * v13 - z5_x * v15;
    J[12] = 0.0; J[13] = s1 * p6_y - c1 * p6_x; J[14] = c1 * (p6_x - p2_x) - s1 * (v5 + p6_y);
    J[15] = z3_x * v12 - z3_y * v11; J[16] = z4_x * v14 - z4_y * v13;
    J[17] = z5_x * v14 + z6_y * v13;
    J[18] = 0.0; J[19] = s1; J[20] = -s1; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = c1; J[26] = -c1; J[27] = z3_y; J[28] = z4_y; J[29] = -z6_y;
    J[30] = -1.0; J[31] = 0.0; J[32] = 0.0; J[33] = -v8; J[34] = z4_z; J[35] = z5_z;
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
    const double wy = d6 * T23 - T24;
    const double N1 = X1 * X1 + wy * wy;
    const double D1_squared = N1 - k2;
    const int apart1 = k4 < D1_squared;
    if (!(-k3 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double v1 = (apart1 ? w1 : least_root1) * k5;
    const double inverse1 = 1.0 / (apart1 ? N1 : -(k1 * sqrt(N1)));
    const double v2 = X1 * k1, v3 = wy * k1;

    /* theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = d6 * T33 - T34;
    const double Z1_3 = wz + d1;
    const double v4 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = inverse1 * (v3 - X1 * D1), s1 = inverse1 * (v2 + wy * D1);

        /* theta3 */
        const double N3 = v4 + D1 * D1;
        const double K3 = N3 - k7;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= v1 * D3_squared)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double v5 = k6 * K3 * k8;

        /* theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
        const double X1_2 = a2 + d4 * v5;
        const double v6 = Z1_3 * X1_2, v7 = D1 * X1_2;

        /* theta4, type 2: U4[3, 3] */
        const double v8 = T13 * c1 - T23 * s1, v9 = T23 * c1 + T13 * s1, v10 = v9 * v9;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v11 = T22 * c1 + T12 * s1, v12 = T12 * c1 - T22 * s1,
            v14 = T21 * c1 + T11 * s1, v15 = T11 * c1 - T21 * s1;

        /* joint values */
        const double q1 = dhgen_wrap(atan2(s1, c1) - offset1);

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double c3 = k8 * (k6 * (w3 * e3));

            /* theta2 */
            const double X2_2 = d4 * c3;
            const double S2 = v6 + D1 * X2_2;
            const double C2 = v7 - Z1_3 * X2_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const double factor2 = 1.0 / w2;
            const double c2 = C2 * factor2, s2 = S2 * factor2;

            /* theta4 */
            const double c2m3 = c3 * c2 - v5 * s2;
            const double s2m3 = c3 * s2 + v5 * c2;
            const double X4 = T33 * s2m3 - c2m3 * v8;
            const double w4 = sqrt(X4 * X4 + v10);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta6 */
            const double v13 = c2m3 * v12 - T32 * s2m3, v16 = c2m3 * v15 - T31 * s2m3;

            /* joint values */
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);
            const double q3 = dhgen_wrap(atan2(-v5, c3) - offset3);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : -(v9 * factor4);
                const double q4 = atan2(s4, c4);

                /* theta5, type 3: U4[2, 3] and U4[1, 3] */
                const double q5 = atan2(-(w4 * e4), -(T33 * c2m3 + s2m3 * v8));

                /* theta6 */
                const double s6 = c4 * v14 + s4 * v16;

                /* joint values */
                const double q6 = dhgen_wrap(atan2(s6, -(c4 * v11 + s4 * v13)) - offset6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = free4 ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef KINOVA_J2S6S300_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 2.4956680000016215e-13, /* 1000 * k4 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 9.401396550145706e-12,
    m3 = 1.2195121951219514, /* d4 * k6 * k8 [m^-1] */
    m4 = 0.08700963109756096, /* a2 - d4 * k6 * k7 * k8 [m] */
    m5 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide X1 = d6 * T13 - T14, wy = d6 * T23 - T24, N1 = X1 * X1 + wy * wy,
        D1_squared = N1 - k2, w1 = dhgen_sqrt_wide(D1_squared), v1 = w1 - w1,
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (k1 * wy),
        c1_p = v2 - w1 * (X1 * inverse1), c1_m = v2 - w1 * (inverse1 * -X1),
        v3 = inverse1 * (k1 * X1), s1_p = v3 + w1 * (wy * inverse1),
        s1_m = v3 + w1 * (inverse1 * -wy);

    /* theta3 */
    const dhgen_wide Z1_3 = d1 + (d6 * T33 - T34), N3 = D1_squared + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_wide(D3_squared),
        v4 = w3 - w3, v5 = k6 * (N3 - k7), v6 = k8 * v5, v7 = k6 * w3, c3 = k8 * v7;

    /* theta2 */
    const dhgen_wide X1_2 = a2 + d4 * v6, X2_2 = d4 * c3, v8 = Z1_3 * X1_2, v9 = w1 * X2_2,
        v10 = v8 + v9, v11 = v8 - v9, v12 = m4 + m3 * N3, v13 = Z1_3 * v12, v14 = w3 * (m3 * w1),
        S2_pp = v13 + v14, S2_pm = v13 - v14, v15 = w1 * X1_2, v16 = Z1_3 * X2_2, v17 = v15 - v16,
        v18 = v15 + v16, v19 = w3 * (m3 * Z1_3), v20 = w1 * v12, C2_pp = v20 - v19,
        C2_pm = v19 + v20, v21 = S2_pp * S2_pp, v22 = v21 + C2_pp * C2_pp,
        v23 = S2_pm * S2_pm + C2_pm * C2_pm, v24 = v21 - C2_pp * -C2_pp,
        w2_pp = dhgen_sqrt_wide(v22), w2_pm = dhgen_sqrt_wide(v23), w2_mm = dhgen_sqrt_wide(v24),
        v25 = DHGEN_QUOTIENT(1.0, v22), v26 = DHGEN_QUOTIENT(1.0, v23),
        v27 = DHGEN_QUOTIENT(1.0, v24);

    /* theta4 */
    const dhgen_wide v28 = v6 * v10, c2m3_pp = w2_pp * (v25 * (c3 * v17 - v28)),
        v29 = w2_pm * (v26 * (c3 * v18 + v6 * v11)), v30 = w2_mm * (v27 * (v28 + c3 * -v17)),
        v31 = c3 * v10, s2m3_pp = w2_pp * (v25 * (v31 + v6 * v17)), v32 = v6 * v18 - c3 * v11,
        s2m3_pm = w2_pm * (v26 * v32), s2m3_mp = w2_pm * (v26 * -v32),
        s2m3_mm = w2_mm * (v27 * (v6 * -v17 - v31)), v33 = T13 * c1_p - T23 * s1_p,
        v34 = T13 * c1_m - T23 * s1_m, X4_pp = T33 * s2m3_pp - c2m3_pp * v33,
        X4_pm = T33 * s2m3_pm + v29 * v33, X4_mp = T33 * s2m3_mp + v29 * v34,
        X4_mm = T33 * s2m3_mm + v30 * v34, v35 = T23 * c1_p + T13 * s1_p,
        v36 = T23 * c1_m + T13 * s1_m, v37 = v35 * v35, v38 = v36 * v36, v39 = v37 + X4_pp * X4_pp,
        v40 = v37 + X4_pm * X4_pm, v41 = v38 + X4_mp * X4_mp, v42 = v38 + X4_mm * X4_mm,
        angle1 = dhgen_atan2_wide(-v35, -X4_pp), angle2 = dhgen_atan2_wide(-v35, -X4_pm),
        angle3 = dhgen_atan2_wide(-v36, -X4_mp), angle4 = dhgen_atan2_wide(-v36, -X4_mm),
        v43 = dhgen_signed_wide(DHGEN_HALF_TURN, -v35),
        v44 = dhgen_signed_wide(DHGEN_HALF_TURN, -v36);

    /* theta5 */
    const dhgen_wide angle5 = dhgen_atan2_wide(-dhgen_sqrt_wide(v39), -(T33 * c2m3_pp + s2m3_pp *
        v33)), v45 = T33 * v29,
        angle6 = dhgen_atan2_wide(-dhgen_sqrt_wide(v40), v45 - s2m3_pm * v33),
        angle7 = dhgen_atan2_wide(-dhgen_sqrt_wide(v41), v45 - s2m3_mp * v34),
        angle8 = dhgen_atan2_wide(-dhgen_sqrt_wide(v42), T33 * v30 - s2m3_mm * v34);

    /* theta6 */
    const dhgen_wide v46 = c1_p * T22 + s1_p * T12, v47 = c1_m * T22 + s1_m * T12,
        v48 = c1_p * T12 - s1_p * T22, v49 = c1_m * T12 - s1_m * T22, v50 = c1_p * T21 + s1_p * T11,
        v51 = c1_m * T21 + s1_m * T11, v52 = c1_p * T11 - s1_p * T21, v53 = c1_m * T11 - s1_m * T21,
        s6_pp = -X4_pp * v50 - v35 * (c2m3_pp * v52 - s2m3_pp * T31),
        s6_pm = v35 * (v29 * v52 + s2m3_pm * T31) - X4_pm * v50,
        s6_mp = v36 * (v29 * v53 + s2m3_mp * T31) - X4_mp * v51,
        s6_mm = v36 * (v30 * v53 + s2m3_mm * T31) - X4_mm * v51;

    /* joint values */
    const dhgen_wide angle9 = dhgen_atan2_wide(s1_p, c1_p), v54 = angle9 - offset1,
        angle10 = dhgen_atan2_wide(s1_m, c1_m), v55 = angle10 - offset1,
        angle11 = dhgen_atan2_wide(S2_pp, C2_pp), v56 = angle11 - offset2,
        angle12 = dhgen_atan2_wide(S2_pm, C2_pm), v57 = angle12 - offset2,
        angle13 = dhgen_atan2_wide(S2_pm, -C2_pm), v58 = angle13 - offset2,
        angle14 = dhgen_atan2_wide(S2_pp, -C2_pp), v59 = angle14 - offset2,
        q2__pp = dhgen_raised_wide(v56), q2__pm = dhgen_raised_wide(v57),
        q2__mp = dhgen_raised_wide(v58), q2__mm = dhgen_raised_wide(v59),
        angle15 = dhgen_atan2_wide(-v5, v7), v60 = angle15 - offset3,
        v61 = dhgen_signed_wide(DHGEN_HALF_TURN, -v5) - angle15 - offset3,
        q3__p = dhgen_raised_wide(v60), q3__m = dhgen_raised_wide(v61),
        angle16 = dhgen_atan2_wide(s6_pp, v35 * (c2m3_pp * v48 - s2m3_pp * T32) + X4_pp * v46),
        angle17 = dhgen_atan2_wide(s6_pm, X4_pm * v46 - v35 * (v29 * v48 + s2m3_pm * T32)),
        angle18 = dhgen_atan2_wide(s6_mp, X4_mp * v47 - v36 * (v29 * v49 + s2m3_mp * T32)),
        angle19 = dhgen_atan2_wide(s6_mm, X4_mm * v47 - v36 * (v30 * v49 + s2m3_mm * T32)),
        v62 = angle16 - offset6,
        v63 = angle16 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_pp) - offset6,
        v64 = angle17 - offset6,
        v65 = angle17 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_pm) - offset6,
        v66 = angle18 - offset6,
        v67 = angle18 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_mp) - offset6,
        v68 = angle19 - offset6,
        v69 = angle19 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_mm) - offset6,
        v70 = q2__pp + dhgen_only_wide(q2__pp < dhgen_low(joints + 1), DHGEN_TURN),
        v71 = q2__pm + dhgen_only_wide(q2__pm < dhgen_low(joints + 1), DHGEN_TURN),
        v72 = q2__mp + dhgen_only_wide(q2__mp < dhgen_low(joints + 1), DHGEN_TURN),
        v73 = q2__mm + dhgen_only_wide(q2__mm < dhgen_low(joints + 1), DHGEN_TURN),
        v74 = dhgen_beyond_wide(v70, joints + 1), v75 = dhgen_beyond_wide(v71, joints + 1),
        v76 = dhgen_beyond_wide(v72, joints + 1), v77 = dhgen_beyond_wide(v73, joints + 1),
        v78 = dhgen_low(joints + 1) - q2__pp, v79 = dhgen_low(joints + 1) - q2__pm,
        v80 = dhgen_low(joints + 1) - q2__mp, v81 = dhgen_low(joints + 1) - q2__mm,
        v82 = dhgen_pick_wide(v78 < v74, v78, v74), v83 = dhgen_pick_wide(v79 < v75, v79, v75),
        v84 = dhgen_pick_wide(v80 < v76, v80, v76), v85 = dhgen_pick_wide(v81 < v77, v81, v77),
        q2_ppp = dhgen_pick_wide(0.0 < v82, q2__pp, v70),
        q2_pmp = dhgen_pick_wide(0.0 < v83, q2__pm, v71),
        q2_mpp = dhgen_pick_wide(0.0 < v84, q2__mp, v72),
        q2_mmp = dhgen_pick_wide(0.0 < v85, q2__mm, v73),
        v86 = q3__p + dhgen_only_wide(q3__p < dhgen_low(joints + 2), DHGEN_TURN),
        v87 = q3__m + dhgen_only_wide(q3__m < dhgen_low(joints + 2), DHGEN_TURN),
        v88 = dhgen_beyond_wide(v86, joints + 2), v89 = dhgen_beyond_wide(v87, joints + 2),
        v90 = dhgen_low(joints + 2) - q3__p, v91 = dhgen_low(joints + 2) - q3__m,
        v92 = dhgen_pick_wide(v90 < v88, v90, v88), v93 = dhgen_pick_wide(v91 < v89, v91, v89),
        v94 = angle5 + dhgen_only_wide(angle5 < dhgen_low(joints + 4), DHGEN_TURN),
        v95 = dhgen_only_wide(-angle5 < dhgen_low(joints + 4), DHGEN_TURN) - angle5,
        v96 = angle6 + dhgen_only_wide(angle6 < dhgen_low(joints + 4), DHGEN_TURN),
        v97 = dhgen_only_wide(-angle6 < dhgen_low(joints + 4), DHGEN_TURN) - angle6,
        v98 = angle7 + dhgen_only_wide(angle7 < dhgen_low(joints + 4), DHGEN_TURN),
        v99 = dhgen_only_wide(-angle7 < dhgen_low(joints + 4), DHGEN_TURN) - angle7,
        v100 = angle8 + dhgen_only_wide(angle8 < dhgen_low(joints + 4), DHGEN_TURN),
        v101 = dhgen_only_wide(-angle8 < dhgen_low(joints + 4), DHGEN_TURN) - angle8,
        v102 = dhgen_beyond_wide(v94, joints + 4), v103 = dhgen_beyond_wide(v95, joints + 4),
        v104 = dhgen_beyond_wide(v96, joints + 4), v105 = dhgen_beyond_wide(v97, joints + 4),
        v106 = dhgen_beyond_wide(v98, joints + 4), v107 = dhgen_beyond_wide(v99, joints + 4),
        v108 = dhgen_beyond_wide(v100, joints + 4), v109 = dhgen_beyond_wide(v101, joints + 4),
        v110 = dhgen_low(joints + 4) - angle5, v111 = dhgen_low(joints + 4) + angle5,
        v112 = dhgen_low(joints + 4) - angle6, v113 = dhgen_low(joints + 4) + angle6,
        v114 = dhgen_low(joints + 4) - angle7, v115 = dhgen_low(joints + 4) + angle7,
        v116 = dhgen_low(joints + 4) - angle8, v117 = dhgen_low(joints + 4) + angle8,
        v118 = dhgen_pick_wide(v110 < v102, v110, v102),
        v119 = dhgen_pick_wide(v111 < v103, v111, v103),
        v120 = dhgen_pick_wide(v112 < v104, v112, v104),
        v121 = dhgen_pick_wide(v113 < v105, v113, v105),
        v122 = dhgen_pick_wide(v114 < v106, v114, v106),
        v123 = dhgen_pick_wide(v115 < v107, v115, v107),
        v124 = dhgen_pick_wide(v116 < v108, v116, v108),
        v125 = dhgen_pick_wide(v117 < v109, v117, v109), q1_ppp = v4 + dhgen_raised_wide(v54),
        q1_mpp = v4 + dhgen_raised_wide(v55), q3_ppp = v1 + dhgen_pick_wide(0.0 < v92, q3__p, v86),
        q3_pmp = v1 + dhgen_pick_wide(0.0 < v93, q3__m, v87), v126 = dhgen_maximum_wide(v82, v92),
        v127 = dhgen_maximum_wide(v83, v93), v128 = dhgen_maximum_wide(v84, v92),
        v129 = dhgen_maximum_wide(v85, v93), excess_ppp = dhgen_maximum_wide(v118, v126),
        excess_ppm = dhgen_maximum_wide(v119, v126), excess_pmp = dhgen_maximum_wide(v120, v127),
        excess_pmm = dhgen_maximum_wide(v121, v127), excess_mpp = dhgen_maximum_wide(v122, v128),
        excess_mpm = dhgen_maximum_wide(v123, v128), excess_mmp = dhgen_maximum_wide(v124, v129),
        excess_mmm = dhgen_maximum_wide(v125, v129);

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = q3_ppp; q[3] = angle1;
    q[4] = dhgen_pick_wide(0.0 < v118, angle5, v94); q[5] = dhgen_lowered_wide(v62);
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_ppp);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = q3_ppp; q[9] = angle1 - v43;
    q[10] = dhgen_pick_wide(0.0 < v119, -angle5, v95); q[11] = dhgen_lowered_wide(v63);
    kind[1] = dhgen_kind_within_wide(q[6], 0.0 < excess_ppm);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = angle2;
    q[16] = dhgen_pick_wide(0.0 < v120, angle6, v96); q[17] = dhgen_lowered_wide(v64);
    kind[2] = dhgen_kind_within_wide(q[12], 0.0 < excess_pmp);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = angle2 - v43;
    q[22] = dhgen_pick_wide(0.0 < v121, -angle6, v97); q[23] = dhgen_lowered_wide(v65);
    kind[3] = dhgen_kind_within_wide(q[18], 0.0 < excess_pmm);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_ppp; q[27] = angle3;
    q[28] = dhgen_pick_wide(0.0 < v122, angle7, v98); q[29] = dhgen_lowered_wide(v66);
    kind[4] = dhgen_kind_within_wide(q[24], 0.0 < excess_mpp);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_ppp; q[33] = angle3 - v44;
    q[34] = dhgen_pick_wide(0.0 < v123, -angle7, v99); q[35] = dhgen_lowered_wide(v67);
    kind[5] = dhgen_kind_within_wide(q[30], 0.0 < excess_mpm);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_pmp; q[39] = angle4;
    q[40] = dhgen_pick_wide(0.0 < v124, angle8, v100); q[41] = dhgen_lowered_wide(v68);
    kind[6] = dhgen_kind_within_wide(q[36], 0.0 < excess_mmp);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_pmp; q[45] = angle4 - v44;
    q[46] = dhgen_pick_wide(0.0 < v125, -angle8, v101); q[47] = dhgen_lowered_wide(v69);
    kind[7] = dhgen_kind_within_wide(q[42], 0.0 < excess_mmm);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D3_squared * (k5 * w1)) <= m2) |
        (dhgen_abs_wide(D1_squared) <= m1) | (v42 <= m5) | (v41 <= m5) | (v39 <= m5) | (v40 <= m5))
        | (dhgen_within_slack_wide(excess_mmm) | dhgen_within_slack_wide(excess_mmp) |
        dhgen_within_slack_wide(excess_mpm) | dhgen_within_slack_wide(excess_mpp) |
        dhgen_within_slack_wide(excess_pmm) | dhgen_within_slack_wide(excess_pmp) |
        dhgen_within_slack_wide(excess_ppp) | dhgen_within_slack_wide(excess_ppm));
}

#if DHGEN_LANES > 1
static const double
    m6 = 0.5; /* 1 / 2 */
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
    const double X1 = d6 * T13 - T14, wy = d6 * T23 - T24, N1 = X1 * X1 + wy * wy,
        D1_squared = N1 - k2, w1 = sqrt(D1_squared), v1 = w1 - w1,
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (k1 * wy);
    const dhgen_four c1 = v2 - w1 * (inverse1 * (e1 * X1));
    const double v3 = inverse1 * (k1 * X1);
    const dhgen_four s1 = v3 + w1 * (inverse1 * (e1 * wy));

    /* theta3 */
    const double Z1_3 = d1 + (d6 * T33 - T34), N3 = D1_squared + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared), v4 = w3 - w3,
        v5 = k6 * (N3 - k7), v6 = k8 * v5, v7 = k6 * w3, c3 = k8 * v7;

    /* theta2 */
    const double X1_2 = a2 + d4 * v6, X2_2 = d4 * c3, v8 = Z1_3 * X1_2, v9 = w1 * X2_2;
    const dhgen_four v10 = e1 * e3, v11 = v8 + v9 * v10;
    const double v12 = m4 + m3 * N3, v13 = Z1_3 * v12;
    const dhgen_four S2 = v13 + w3 * (m3 * (w1 * v10));
    const double v14 = w1 * X1_2, v15 = Z1_3 * X2_2;
    const dhgen_four v16 = e1 * v14, v17 = e3 * v15, v18 = v16 - v17, v19 = w3 * (m3 * (e3 * Z1_3)),
        v20 = w1 * (e1 * v12), C2 = v20 - v19, v21 = S2 * S2 + C2 * C2, w2 = dhgen_sqrt_four(v21),
        v22 = DHGEN_QUOTIENT(1.0, v21);

    /* theta4 */
    const dhgen_four v23 = e3 * c3, c2m3 = w2 * (v22 * (v18 * v23 - v6 * v11)),
        s2m3 = w2 * (v22 * (v11 * v23 + v6 * v18)), v24 = T13 * c1 - T23 * s1,
        X4 = T33 * s2m3 - c2m3 * v24, v25 = T23 * c1 + T13 * s1, v26 = v25 * v25,
        v27 = v26 + X4 * X4, v28 = dhgen_signed_four(DHGEN_HALF_TURN, -v25);

    /* theta6 */
    const dhgen_four v29 = c1 * T22 + s1 * T12, v30 = c1 * T12 - s1 * T22,
        v31 = c1 * T21 + s1 * T11, v32 = c1 * T11 - s1 * T21,
        s6 = -X4 * v31 - v25 * (c2m3 * v32 - s2m3 * T31);

    /* joint values */
    const double v35 = copysign(DHGEN_HALF_TURN, -v5);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | (v27 <= m5)) |
        (unsigned)((fabs(D1_squared) <= m1) | (fabs(D3_squared * (k5 * w1)) <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(s1, dhgen_all_four(-v5), 0,
        5, 2, 3), dhgen_shuffle(c1, dhgen_all_four(v7), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(S2, C2), ratio3 = dhgen_ratio_four(-v25, -X4),
        ratio4 = dhgen_ratio_four(s6, v25 * (c2m3 * v30 - s2m3 * T32) + X4 * v29),
        ratio5 = dhgen_ratio_four(-dhgen_sqrt_four(v27), -(T33 * c2m3 + s2m3 * v24));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle3 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle5 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle4 = dhgen_angle_four(ratio2),
        angle1 = dhgen_angle_four(ratio3), angle6 = dhgen_angle_four(ratio4),
        angle2 = dhgen_angle_four(ratio5);
    const dhgen_four q4_m = angle1 - v28, v33 = angle3 - offset1, v34 = angle4 - offset2,
        q2_ = dhgen_raised_four(v34), v36 = e3 * angle5 + v35 * (m6 * (1.0 - e3)) - offset3,
        q3_ = dhgen_raised_four(v36), v37 = angle6 - offset6,
        v38 = angle6 - dhgen_signed_four(DHGEN_HALF_TURN, s6) - offset6,
        q6_p = dhgen_lowered_four(v37), q6_m = dhgen_lowered_four(v38),
        v39 = q2_ + dhgen_only_four(q2_ < dhgen_low(joints + 1), DHGEN_TURN),
        v40 = dhgen_beyond_four(v39, joints + 1), v41 = dhgen_low(joints + 1) - q2_,
        v42 = dhgen_pick_four(v41 < v40, v41, v40), q2_p = dhgen_pick_four(0.0 < v42, q2_, v39),
        v43 = q3_ + dhgen_only_four(q3_ < dhgen_low(joints + 2), DHGEN_TURN),
        v44 = dhgen_beyond_four(v43, joints + 2), v45 = dhgen_low(joints + 2) - q3_,
        v46 = dhgen_pick_four(v45 < v44, v45, v44),
        v47 = angle2 + dhgen_only_four(angle2 < dhgen_low(joints + 4), DHGEN_TURN),
        v48 = dhgen_only_four(-angle2 < dhgen_low(joints + 4), DHGEN_TURN) - angle2,
        v49 = dhgen_beyond_four(v47, joints + 4), v50 = dhgen_beyond_four(v48, joints + 4),
        v51 = dhgen_low(joints + 4) - angle2, v52 = dhgen_low(joints + 4) + angle2,
        v53 = dhgen_pick_four(v51 < v49, v51, v49), v54 = dhgen_pick_four(v52 < v50, v52, v50),
        q5_p = dhgen_pick_four(0.0 < v53, angle2, v47),
        q5_m = dhgen_pick_four(0.0 < v54, -angle2, v48), q1_p = v4 + dhgen_raised_four(v33),
        q3_p = v1 + dhgen_pick_four(0.0 < v46, q3_, v43), v55 = dhgen_maximum_four(v42, v46),
        excess_p = dhgen_maximum_four(v53, v55), excess_m = dhgen_maximum_four(v54, v55);
    const dhgen_four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (dhgen_bits_four((dhgen_within_slack_four(excess_p) | dhgen_within_slack_four(excess_m))))
        return -1;

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, q2_p, q3_p, angle1);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, q5_p, q6_p);
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
DHGEN_TABLE int choosable[1] = { 3 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.7854, 0.7854, 0.7854, 1.0, 1.0, 1.0 }, 0.7853608733212912, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 1, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, kinova_j2s6s300_fk,
    kinova_j2s6s300_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) kinova_j2s6s300_##function
#include "dhgen/functions.h"

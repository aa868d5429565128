/* abb_irb1600: ABB IRB 1600
 *
 * Inverse kinematics, generated from robots/abb_irb1600.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/abb_irb1600.yaml. The formulas and where they come from:
 * abb_irb1600.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 6c48156184b3fa9e
 * SPDX-License-Identifier: MIT
 */
#include "abb_irb1600.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(ABB_IRB1600_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(ABB_IRB1600_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef ABB_IRB1600_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.4865, /* joint offset 1 [m] */
    a1 = 0.15, /* link length 1 [m] */
    a2 = 0.7, /* link length 2 [m] */
    d4 = 0.6, /* joint offset 4 [m] */
    d6 = 0.065, /* joint offset 6 [m] */
    free_limit1 = 2.0015e-12, /* a length that fixes no angle [m] */
    longest3 = 1.6899999999999995, /* square of the longest reach [m^2] */
    shortest3 = 0.009999999999999995, /* square of the shortest reach [m^2] */
    longest3_reach = 1.6900000000005198, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.009999999999959966, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 1.6899999999999475, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.010000000000003999, /* the shortest, where branches merge [m^2] */
    offset2 = -1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    k1 = 0.84, /* 2 * d4 * a2 [m^2] */
    k2 = 0.8499999999999999, /* a2^2 + d4^2 [m^2] */
    k3 = 1.4172335600907033; /* 1 / (k1^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const abb_irb1600_branches[8] = {
    "back-down-noflip", "back-down-flip", "back-up-noflip", "back-up-flip", "front-up-noflip",
    "front-up-flip", "front-down-noflip", "front-down-flip",
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
    { 0.0, 0.4865, 0.15, -1.5707963267948966 },
    { -1.5707963267948966, 0.0, 0.7, 0.0 },
    { 1.5707963267948966, 0.0, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.6, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.065, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void abb_irb1600_fk(const double q[6], double T[16])
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
    T[0] = x5_x * c6 + z4_x * s6; T[1] = z4_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = c1 * a1 + x2_x * a2 + z3_x * d4 + z5_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = z4_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = s1 * a1 + x2_y * a2 + z3_y * d4 + z5_y * d6;
    T[8] = x5_z * c6 - v8 * s6; T[9] = -(v8 * c6 + x5_z * s6); T[10] = -v10;
    T[11] = d1 - s2 * a2 + z3_z * d4 - v10 * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void abb_irb1600_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1,
        v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 - s2 * a2,
        v4 = q[2] + offset3;
    const double c3 = cos(v4), s3 = sin(v4), x3_x = x2_x * c3 - v2 * s3, x3_y = x2_y * c3 - v3 * s3,
        v5 = s2 * c3 + c2 * s3, z3_x = v2 * c3 + x2_x * s3, z3_y = v3 * c3 + x2_y * s3,
        z3_z = c2 * c3 - s2 * s3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), z4_x = s1 * c4 + x3_x * s4, v7 = v5 * s4,
        p4_x = p2_x + z3_x * d4, p4_y = p2_y + z3_y * d4, p4_z = p2_z + z3_z * d4,
        z4_y = x3_y * s4 - c1 * c4, v8 = q[4] + offset5;
    const double c5 = cos(v8), s5 = sin(v8), v9 = z3_z * c5 + v5 * c4 * s5,
        z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5,
        z5_y = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5, p6_x = p4_x + z5_x * d6,
        p6_y = p4_y + z5_y * d6, p6_z = p4_z - v9 * d6, v10 = p6_z - d1, v11 = p6_x - p2_x,
        v12 = p6_y - p2_y, v13 = p6_z - p2_z, v14 = p6_x - p4_x, v15 = p6_y - p4_y,
        v16 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = c1 * v10; J[2] = c1 * v13; J[3] = z3_y * v13 - z3_z * v12;
    J[4] = z4_y * v16 + v7 * v15; J[5] = z5_y * v16 + v9 * v15;
    J[6] = p6_x; J[7] = s1 * v10; J[8] = s1 * v13; J[9] = z3_z * v11 - z3_x * v13;
    J[10] = -(v7 * v14 + z4_x * v16); J[11] = -(v9 * v14 + z5_x * v16);
    J[12] = 0.0; J[13] = -(s1 * (p6_y - p1_y) + c1 * (p6_x - p1_x)); J[14] = -(s1 * v12 + c1 * v11);
    J[15] = z3_x * v12 - z3_y * v11; J[16] = z4_x * v15 - z4_y * v14;
    J[17] = z5_x * v15 - z5_y * v14;
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

    /* theta1, type 2: U1 A6^-1 [3, 4] */
    const double wx = T14 - T13 * d6;
    const double Y1 = d6 * T23 - T24;
    const double w1 = sqrt(wx * wx + Y1 * Y1);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = T34 - d6 * T33;
    const double Z1_3 = wz - d1;
    const double v2 = Z1_3 * Z1_3;

    /* theta4, type 2: U4[3, 3] */
    const double v11 = seed[3] + offset4;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(wx * factor1),
            s1 = free1 ? sin(seed[0]) : Y1 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double v1 = w1 * e1 + a1;
        const double N3 = v2 + v1 * v1;
        const double K3 = N3 - k2;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double s3 = k1 * K3 * k3;

        /* theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4] */
        const double Y1_2 = a2 + d4 * s3;
        const double v5 = Z1_3 * Y1_2, v6 = v1 * Y1_2;

        /* theta4 */
        const double v9 = T13 * c1 + T23 * s1;
        const double Y4 = T23 * c1 - T13 * s1;
        const double v10 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v12 = T12 * s1 - T22 * c1, v13 = T12 * c1 + T22 * s1,
            v15 = T11 * s1 - T21 * c1, v16 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double v3 = k3 * (k1 * (w3 * e3));

            /* theta2 */
            const double v4 = d4 * v3;
            const double S2 = v1 * v4 - v5;
            const double v7 = Z1_3 * v4 + v6;
            const double w2 = sqrt(S2 * S2 + v7 * v7);
            const double factor2 = 1.0 / w2;
            const double c2 = -(v7 * factor2), s2 = S2 * factor2;

            /* theta4 */
            const double v8 = v3 * c2 + s3 * s2;
            const double s23 = s3 * c2 - v3 * s2;
            const double X4 = v8 * v9 + T33 * s23;
            const double w4 = sqrt(X4 * X4 + v10);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * v8 - s23 * v9;

            /* theta6 */
            const double v14 = v8 * v13 + T32 * s23, v17 = v8 * v16 + T31 * s23;

            /* joint values */
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);
            const double q3 = dhgen_wrap(atan2(s3, -v3) - offset3);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(v11) : -(X4 * factor4),
                    s4 = free4 ? sin(v11) : Y4 * factor4;
                const double s5 = w4 * e4;

                /* theta6 */
                const double c6 = c4 * v12 - s4 * v14, s6 = c4 * v15 - s4 * v17;
                const double q6 = atan2(s6, c6);

                /* joint values */
                const double q4 = dhgen_wrap(atan2(s4, c4) - offset4);
                const double q5 = dhgen_wrap(atan2(s5, c5) - offset5);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef ABB_IRB1600_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.00020014999999999999 [m],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 4.006002249999999e-08, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 8.729017508812558e-11,
    m4 = 0.7142857142857144, /* d4 * k1 * k3 [m^-1] */
    m5 = 0.09285714285714279, /* a2 - d4 * k1 * k2 * k3 [m] */
    m6 = 0.8333333333333335, /* a2 * k1 * k3 [m^-1] */
    /* k1 * k3 * (a2 * k2 + d4 * longest3 * shortest3 * k1 * k3 - d4 * k1 * k2^2 * k3) [m] */
    m7 = 0.10833333333333327,
    m8 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide wx = T14 - d6 * T13, Y1 = d6 * T23 - T24, v1 = wx * wx + Y1 * Y1,
        w1 = dhgen_sqrt_wide(v1), v2 = DHGEN_QUOTIENT(1.0, v1), factor1 = w1 * v2,
        v3 = wx * factor1, s1 = Y1 * factor1, angle1 = dhgen_atan2_wide(Y1, -wx);

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d6 * T33 - d1, v4 = a1 + w1, v5 = a1 - w1, v6 = Z1_3 * Z1_3,
        N3_p = v6 + v4 * v4, N3_m = v6 + v5 * v5,
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m), v7 = k1 * (N3_p - k2), v8 = k1 * (N3_m - k2);

    /* theta2 */
    const dhgen_wide v9 = m5 + m4 * N3_p, v10 = m5 + m4 * N3_m, v11 = Z1_3 * v9, v12 = Z1_3 * v10,
        v13 = m4 * Z1_3, v14 = m4 * -Z1_3, v15 = v4 * v9, v16 = v5 * v10,
        factor2_p = DHGEN_QUOTIENT(1.0, N3_p), factor2_m = DHGEN_QUOTIENT(1.0, N3_m);

    /* theta4 */
    const dhgen_wide v17 = m7 - m6 * N3_p, v18 = m7 - m6 * N3_m, v19 = T23 * s1 - T13 * v3,
        v20 = T33 * Z1_3, v21 = v20 - v4 * v19, v22 = v20 - v19 * -v5, v23 = Z1_3 * v17,
        v24 = Z1_3 * -v18, v25 = T33 * v17, v26 = T33 * v18, v27 = v19 * v23 + v4 * v25,
        v28 = v19 * v24 + v5 * v26, X4_pp = v27 + w3_p * (m6 * v21),
        X4_pm = v27 + w3_p * (m6 * -v21), X4_mp = v28 + w3_m * (m6 * v22),
        X4_mm = v28 + w3_m * (m6 * -v22), v29 = w1 * (v2 * (T13 * Y1 + wx * T23)), v30 = v29 * v29,
        v31 = factor2_p * X4_pp, v32 = factor2_p * X4_pm, v33 = factor2_m * X4_mp,
        v34 = factor2_m * X4_mm, v35 = v30 + factor2_p * (X4_pp * v31),
        v36 = v30 + factor2_p * (X4_pm * v32), v37 = v30 + factor2_m * (X4_mp * v33),
        v38 = v30 + factor2_m * (X4_mm * v34);

    /* theta5 */
    const dhgen_wide v39 = v19 * (v4 * -v17) + Z1_3 * v25, v40 = v19 * (v5 * v18) + Z1_3 * v26;

    /* theta6 */
    const dhgen_wide v41 = w1 * (v2 * (wx * T22 + Y1 * T12)), v42 = s1 * T22 - v3 * T12,
        v43 = Z1_3 * T32, v44 = v43 - v4 * v42, v45 = v43 + v5 * v42,
        v46 = v23 * v42 + v4 * (v17 * T32), v47 = v24 * v42 + v5 * (v18 * T32),
        v48 = w1 * (v2 * (wx * T21 + Y1 * T11)), v49 = s1 * T21 - v3 * T11, v50 = Z1_3 * T31,
        v51 = v50 - v4 * v49, v52 = v50 + v5 * v49, v53 = v23 * v49 + v4 * (v17 * T31),
        v54 = v24 * v49 + v5 * (v18 * T31), v55 = v29 * (v53 + w3_p * (m6 * v51)) - X4_pp * v48,
        v56 = v29 * (v53 + w3_p * (m6 * -v51)) - X4_pm * v48,
        v57 = X4_mp * v48 - v29 * (v54 + w3_m * (m6 * v52)),
        v58 = X4_mm * v48 - v29 * (v54 + w3_m * (m6 * -v52)),
        angle2 = dhgen_atan2_wide(v55, v29 * (v46 + w3_p * (m6 * v44)) - X4_pp * v41),
        angle3 = dhgen_atan2_wide(v56, v29 * (v46 + w3_p * (m6 * -v44)) - X4_pm * v41),
        angle4 = dhgen_atan2_wide(v57, X4_mp * v41 - v29 * (v47 + w3_m * (m6 * v45))),
        angle5 = dhgen_atan2_wide(v58, X4_mm * v41 - v29 * (v47 + w3_m * (m6 * -v45)));

    /* joint values */
    const dhgen_wide v59 = w3_p * (m4 * v4),
        angle6 = dhgen_atan2_wide(v59 - v11, -(v15 + w3_p * v13)), v60 = angle6 - offset2,
        angle7 = dhgen_atan2_wide(-(v11 + v59), -(v15 + w3_p * v14)), v61 = angle7 - offset2,
        angle8 = dhgen_atan2_wide(w3_m * (m4 * v5) - v12, -(v16 + w3_m * v13)),
        v62 = angle8 - offset2,
        angle9 = dhgen_atan2_wide(w3_m * (m4 * -v5) - v12, -(v16 + w3_m * v14)),
        v63 = angle9 - offset2, q2_ppp = dhgen_lowered_wide(v60), q2_pmp = dhgen_lowered_wide(v61),
        q2_mpp = dhgen_lowered_wide(v62), q2_mmp = dhgen_lowered_wide(v63),
        angle10 = dhgen_atan2_wide(v7, -(k1 * w3_p)), angle11 = dhgen_atan2_wide(v8, -(k1 * w3_m)),
        v64 = angle10 - offset3, v65 = dhgen_signed_wide(DHGEN_HALF_TURN, v7) - angle10 - offset3,
        v66 = angle11 - offset3, v67 = dhgen_signed_wide(DHGEN_HALF_TURN, v8) - angle11 - offset3,
        q3_ppp = dhgen_raised_wide(v64), q3_pmp = dhgen_raised_wide(v65),
        q3_mpp = dhgen_raised_wide(v66), q3_mmp = dhgen_raised_wide(v67),
        angle12 = dhgen_atan2_wide(-v29, -v31), angle13 = dhgen_atan2_wide(-v29, -v32),
        angle14 = dhgen_atan2_wide(v29, -v33), angle15 = dhgen_atan2_wide(v29, -v34),
        v68 = dhgen_signed_wide(DHGEN_HALF_TURN, -v29),
        v69 = dhgen_signed_wide(DHGEN_HALF_TURN, v29), v70 = angle12 - offset4,
        v71 = angle12 - v68 - offset4, v72 = angle13 - offset4, v73 = angle13 - v68 - offset4,
        v74 = angle14 - offset4, v75 = angle14 - v69 - offset4, v76 = angle15 - offset4,
        v77 = angle15 - v69 - offset4, v78 = w3_p * (m6 * (Z1_3 * v19 + T33 * v4)),
        angle16 = dhgen_atan2_wide(dhgen_sqrt_wide(v35), factor2_p * (v39 - v78)),
        angle17 = dhgen_atan2_wide(dhgen_sqrt_wide(v36), factor2_p * (v39 + v78)),
        v79 = w3_m * (m6 * (-Z1_3 * v19 + T33 * v5)),
        angle18 = dhgen_atan2_wide(dhgen_sqrt_wide(v37), factor2_m * (v40 - v79)),
        angle19 = dhgen_atan2_wide(dhgen_sqrt_wide(v38), factor2_m * (v40 + v79)),
        v80 = angle16 - offset5, v81 = offset5 + angle16, v82 = angle17 - offset5,
        v83 = offset5 + angle17, v84 = angle18 - offset5, v85 = offset5 + angle18,
        v86 = angle19 - offset5, v87 = offset5 + angle19, q1_ppp = angle1 + (w3_p - w3_p),
        q1_mpp = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, Y1) + (w3_m - w3_m);

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = q3_ppp; q[3] = dhgen_raised_wide(v70);
    q[4] = dhgen_raised_wide(v80); q[5] = angle2;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = q3_ppp; q[9] = dhgen_raised_wide(v71);
    q[10] = dhgen_only_wide(-v81 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v81;
    q[11] = angle2 - dhgen_signed_wide(DHGEN_HALF_TURN, v55);
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = dhgen_raised_wide(v72);
    q[16] = dhgen_raised_wide(v82); q[17] = angle3;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = dhgen_raised_wide(v73);
    q[22] = dhgen_only_wide(-v83 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v83;
    q[23] = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, v56);
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_mpp; q[27] = dhgen_raised_wide(v74);
    q[28] = dhgen_raised_wide(v84); q[29] = angle4;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_mpp; q[33] = dhgen_raised_wide(v75);
    q[34] = dhgen_only_wide(-v85 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v85;
    q[35] = angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, v57);
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_mmp; q[39] = dhgen_raised_wide(v76);
    q[40] = dhgen_raised_wide(v86); q[41] = angle5;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_mmp; q[45] = dhgen_raised_wide(v77);
    q[46] = dhgen_only_wide(-v87 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v87;
    q[47] = angle5 - dhgen_signed_wide(DHGEN_HALF_TURN, v58);
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v38 <= m8) | (v37 <= m8) | (v36 <= m8) | (v35 <= m8) |
        (dhgen_abs_wide(D3_squared_m) <= m3) | (v1 <= m1) | (dhgen_abs_wide(D3_squared_p) <= m3));
}

#if DHGEN_LANES > 1
static const double
    m2 = 0.5; /* 1 / 2 */
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
    const double wx = T14 - d6 * T13, Y1 = d6 * T23 - T24, v1 = wx * wx + Y1 * Y1, w1 = sqrt(v1),
        v2 = DHGEN_QUOTIENT(1.0, v1), factor1 = w1 * v2, v3 = wx * factor1, s1 = Y1 * factor1,
        v4 = copysign(DHGEN_HALF_TURN, Y1);

    /* theta3 */
    const double Z1_3 = T34 - d6 * T33 - d1;
    const dhgen_four v5 = a1 + e1 * w1;
    const double v6 = Z1_3 * Z1_3;
    const dhgen_four N3 = v6 + v5 * v5, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared), v7 = k1 * (N3 - k2);

    /* theta2 */
    const dhgen_four v8 = m5 + m4 * N3, v9 = Z1_3 * v8, v10 = m4 * (e3 * Z1_3), v11 = v5 * v8,
        factor2 = DHGEN_QUOTIENT(1.0, N3);

    /* theta4 */
    const dhgen_four v12 = m7 - m6 * N3;
    const double v13 = T23 * s1 - T13 * v3;
    const dhgen_four v14 = e1 * v5;
    const double v15 = T33 * Z1_3;
    const dhgen_four v16 = v15 - v13 * v14, v17 = Z1_3 * (e1 * v12), v18 = T33 * v12,
        v19 = v13 * v17 + v5 * v18, X4 = v19 + w3 * (m6 * (e3 * v16));
    const double v20 = w1 * (v2 * (T13 * Y1 + wx * T23)), v21 = v20 * v20;
    const dhgen_four v22 = factor2 * X4, v23 = v21 + factor2 * (X4 * v22);

    /* theta5 */
    const dhgen_four v24 = v13 * (e1 * Z1_3) + T33 * v5,
        v25 = v13 * (v5 * (e1 * -v12)) + Z1_3 * v18;

    /* theta6 */
    const double v26 = w1 * (v2 * (wx * T22 + Y1 * T12)), v27 = s1 * T22 - v3 * T12,
        v28 = Z1_3 * T32;
    const dhgen_four v29 = v28 - v14 * v27, v30 = v17 * v27 + v5 * (v12 * T32);
    const double v31 = w1 * (v2 * (wx * T21 + Y1 * T11)), v32 = s1 * T21 - v3 * T11,
        v33 = Z1_3 * T31;
    const dhgen_four v34 = v33 - v14 * v32, v35 = v17 * v32 + v5 * (v12 * T31),
        v36 = e1 * (v20 * (v35 + w3 * (m6 * (e3 * v34))) - X4 * v31);

    /* joint values */
    const dhgen_four v38 = dhgen_signed_four(DHGEN_HALF_TURN, v7), v39 = m2 * (1.0 - e3),
        v41 = dhgen_signed_four(DHGEN_HALF_TURN, -(e1 * v20));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) |
        (dhgen_abs_four(D3_squared) <= m3) | (v23 <= m8)) | (unsigned)(v1 <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(v7, dhgen_all_four(Y1), 0, 5,
        2, 3), dhgen_shuffle(-(k1 * w3), dhgen_all_four(-wx), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(w3 * (m4 * (e3 * v5)) - v9, -(v11 + w3 * v10)),
        ratio3 = dhgen_ratio_four(-(e1 * v20), -v22),
        ratio4 = dhgen_ratio_four(v36, e1 * (v20 * (v30 + w3 * (m6 * (e3 * v29))) - X4 * v26)),
        ratio5 = dhgen_ratio_four(dhgen_sqrt_four(v23), factor2 * (v25 - w3 * (m6 * (e3 * v24))));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle4 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = dhgen_angle_four(ratio2),
        angle5 = dhgen_angle_four(ratio3), angle2 = dhgen_angle_four(ratio4),
        angle6 = dhgen_angle_four(ratio5);
    const dhgen_four q6_m = angle2 - dhgen_signed_four(DHGEN_HALF_TURN, v36),
        v37 = angle3 - offset2, q2_p = dhgen_lowered_four(v37),
        v40 = e3 * angle4 + v38 * v39 - offset3, q3_p = dhgen_raised_four(v40),
        v42 = angle5 - offset4, v43 = angle5 - v41 - offset4, q4_p = dhgen_raised_four(v42),
        q4_m = dhgen_raised_four(v43), v44 = angle6 - offset5, v45 = offset5 + angle6,
        q5_p = dhgen_raised_four(v44),
        q5_m = dhgen_only_four(-v45 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v45,
        q1_p = angle1 + v4 * (m2 * (e1 - 1.0)) + (w3 - w3);

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, q2_p, q3_p, q4_p);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, q5_p, angle2);
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
DHGEN_TABLE int choosable[2] = { 3, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.4996, 0.4996, 0.4996, 1.0, 1.0, 1.0 }, 0.49962528103922055, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, abb_irb1600_fk,
    abb_irb1600_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) abb_irb1600_##function
#include "dhgen/functions.h"

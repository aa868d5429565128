/* abb_irb6640: ABB IRB 6640-185/2.8
 *
 * Inverse kinematics, generated from robots/abb_irb6640.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/abb_irb6640.yaml. The formulas and where they come from:
 * abb_irb6640.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 8c8d9cf686b09680
 * SPDX-License-Identifier: MIT
 */
#include "abb_irb6640.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(ABB_IRB6640_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(ABB_IRB6640_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef ABB_IRB6640_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.78, /* joint offset 1 [m] */
    a1 = 0.32, /* link length 1 [m] */
    a2 = 1.075, /* link length 2 [m] */
    a3 = 0.2, /* link length 3 [m] */
    d4 = 1.392, /* joint offset 4 [m] */
    d6 = 0.2, /* joint offset 6 [m] */
    free_limit1 = 3.967e-12, /* a length that fixes no angle [m] */
    longest3 = 6.156822006269321, /* square of the longest reach [m^2] */
    shortest3 = 0.10975599373067868, /* square of the shortest reach [m^2] */
    longest3_reach = 6.156822006271289, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.10975599373041584, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 6.156822006269125, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.10975599373070498, /* the shortest, where branches merge [m^2] */
    offset2 = -1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    k1 = 2.9927999999999995, /* 2 * d4 * a2 [m^2] */
    k2 = 0.43, /* 2 * a3 * a2 [m^2] */
    k3 = 3.1332889999999995, /* a2^2 + (a3^2 + d4^2) [m^2] */
    k4 = 0.10938822421589604; /* 1 / (k1^2 + k2^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const abb_irb6640_branches[8] = {
    "back-down-noflip", "back-down-flip", "back-up-noflip", "back-up-flip", "front-up-noflip",
    "front-up-flip", "front-down-noflip", "front-down-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.967, 2.967, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -1.134, 1.4855, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.142, 1.222, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -5.236, 5.236, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.094, 2.094, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283, 6.283, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.78, 0.32, -1.5707963267948966 },
    { -1.5707963267948966, 0.0, 1.075, 0.0 },
    { 0.0, 0.0, 0.2, -1.5707963267948966 },
    { 0.0, 1.392, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.2, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void abb_irb6640_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v2 * s3,
        x3_y = x2_y * c3 - v3 * s3, v4 = s2 * c3 + c2 * s3, v5 = v2 * c3 + x2_x * s3,
        v6 = v3 * c3 + x2_y * s3, z3_z = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + s1 * s4,
        x4_y = x3_y * c4 - c1 * s4, v7 = v4 * c4, z4_y = c1 * c4 + x3_y * s4, v8 = v4 * s4,
        z4_x = x3_x * s4 - s1 * c4, v9 = q[4] + offset5;
    const double c5 = cos(v9), s5 = sin(v9), x5_x = x4_x * c5 - v5 * s5, x5_y = x4_y * c5 - v6 * s5,
        x5_z = z3_z * s5 - v7 * c5, z5_x = v5 * c5 + x4_x * s5, z5_y = v6 * c5 + x4_y * s5,
        v10 = z3_z * c5 + v7 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = z4_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = c1 * a1 + x2_x * a2 + x3_x * a3 - v5 * d4 + z5_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = z4_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = s1 * a1 + x2_y * a2 + x3_y * a3 - v6 * d4 + z5_y * d6;
    T[8] = x5_z * c6 - v8 * s6; T[9] = -(v8 * c6 + x5_z * s6); T[10] = -v10;
    T[11] = d1 - s2 * a2 - v4 * a3 + z3_z * d4 - v10 * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void abb_irb6640_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1,
        v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v2 * s3,
        x3_y = x2_y * c3 - v3 * s3, v4 = s2 * c3 + c2 * s3, v5 = v2 * c3 + x2_x * s3,
        v6 = v3 * c3 + x2_y * s3, z3_z = s2 * s3 - c2 * c3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z - v4 * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_y = c1 * c4 + x3_y * s4, v7 = v4 * s4,
        p4_x = p3_x - v5 * d4, p4_y = p3_y - v6 * d4, p4_z = p3_z + z3_z * d4,
        z4_x = x3_x * s4 - s1 * c4, v8 = q[4] + offset5;
    const double c5 = cos(v8), s5 = sin(v8), z5_x = v5 * c5 + (x3_x * c4 + s1 * s4) * s5,
        z5_y = v6 * c5 + (x3_y * c4 - c1 * s4) * s5, v9 = z3_z * c5 + v4 * c4 * s5,
        p6_x = p4_x + z5_x * d6, p6_y = p4_y + z5_y * d6, p6_z = p4_z - v9 * d6, v10 = p6_z - d1,
        v11 = p6_z - p2_z, v12 = p6_x - p3_x, v13 = p6_y - p3_y, v14 = p6_z - p3_z,
        v15 = p6_x - p4_x, v16 = p6_y - p4_y, v17 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = c1 * v10; J[2] = c1 * v11; J[3] = -(v6 * v14 + z3_z * v13);
    J[4] = z4_y * v17 + v7 * v16; J[5] = z5_y * v17 + v9 * v16;
    J[6] = p6_x; J[7] = s1 * v10; J[8] = s1 * v11; J[9] = z3_z * v12 + v5 * v14;
    J[10] = -(v7 * v15 + z4_x * v17); J[11] = -(v9 * v15 + z5_x * v17);
    J[12] = 0.0; J[13] = -(s1 * (p6_y - p1_y) + c1 * (p6_x - p1_x));
    J[14] = -(s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x)); J[15] = v6 * v12 - v5 * v13;
    J[16] = z4_x * v16 - z4_y * v15; J[17] = z5_x * v16 - z5_y * v15;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = -v5; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = -v6; J[28] = z4_y; J[29] = z5_y;
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

    /* theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = T34 - d6 * T33;
    const double Z1_3 = wz - d1;
    const double v2 = Z1_3 * Z1_3;

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
        const double K3 = N3 - k3;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double v3 = k1 * K3, v4 = k2 * K3;

        /* theta4, type 2: U4[3, 3] */
        const double v7 = T13 * c1 + T23 * s1;
        const double Y4 = T13 * s1 - T23 * c1;
        const double v8 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v9 = T22 * c1 - T12 * s1, v10 = T12 * c1 + T22 * s1, v12 = T21 * c1 - T11 * s1,
            v13 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double D3 = w3 * e3;
            const double s3 = (k2 * D3 - v3) * k4, c3 = k4 * (v4 + k1 * D3);
            const double q3 = atan2(s3, c3);

            /* theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4] */
            const double v5 = d4 * c3 + a3 * s3;
            const double Y1_2 = a2 + (a3 * c3 - d4 * s3);
            const double S2 = v1 * v5 - Z1_3 * Y1_2;
            const double v6 = Z1_3 * v5 + v1 * Y1_2;
            const double w2 = sqrt(S2 * S2 + v6 * v6);
            const double factor2 = 1.0 / w2;
            const double c2 = -(v6 * factor2), s2 = S2 * factor2;

            /* theta4 */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2;
            const double X4 = T33 * s23 - c23 * v7;
            const double w4 = sqrt(X4 * X4 + v8);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * c23 + s23 * v7;

            /* theta6 */
            const double v11 = c23 * v10 - T32 * s23, v14 = c23 * v13 - T31 * s23;

            /* joint values */
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);
                const double s5 = w4 * e4;

                /* theta6 */
                const double c6 = c4 * v9 + s4 * v11, s6 = c4 * v12 + s4 * v14;
                const double q6 = atan2(s6, c6);

                /* joint values */
                const double q5 = dhgen_wrap(atan2(s5, c5) - offset5);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef ABB_IRB6640_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.00039670000000000005 [m],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    turn1 = 1.4280947671350148, /* atan2(k1, k2) [rad] */
    m1 = 1.5737089000000004e-07, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 1.1869630511993603e-09,
    m4 = 0.46511627906976744, /* k4 * (d4 * k1 + a3 * k2) [m^-1] */
    m5 = 0.38234372093023233, /* d4 * k1 * k3 * k4 + a3 * k2 * k3 * k4 - a2 [m] */
    m6 = 0.050564706643797946, /* a2 * k2 * k4 [m^-1] */
    m7 = 0.35193035824083363, /* a2 * k1 * k4 [m^-1] */
    /* k1 * k4 * (d4 * k1 * k3^2 * k4 + a3 * k2 * k3^2 * k4 - a2 * k3 - d4 * longest3 * shortest3 *
     * k1 * k4 - a3 * longest3 * shortest3 * k2 * k4) [m] */
    m8 = 0.2893004797579363,
    /* k2 * k4 * (d4 * k1 * k3^2 * k4 + a3 * k2 * k3^2 * k4 - a2 * k3 - d4 * longest3 * shortest3 *
     * k1 * k4 - a3 * longest3 * shortest3 * k2 * k4) [m] */
    m9 = 0.04156616088476098,
    m10 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide wx = T14 - d6 * T13, Y1 = d6 * T23 - T24, v1 = wx * wx + Y1 * Y1,
        w1 = dhgen_sqrt_wide(v1), v2 = DHGEN_QUOTIENT(1.0, v1), angle1 = dhgen_atan2_wide(Y1, -wx),
        q1__m = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, Y1);

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d6 * T33 - d1, v3 = a1 + w1, v4 = a1 - w1, v5 = Z1_3 * Z1_3,
        N3_p = v5 + v3 * v3, N3_m = v5 + v4 * v4,
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m), angle2 = dhgen_atan2_wide(w3_p, N3_p - k3),
        angle3 = dhgen_atan2_wide(w3_m, N3_m - k3), q3__pp = angle2 - turn1, v6 = turn1 + angle2,
        q3__mp = angle3 - turn1, v7 = turn1 + angle3;

    /* theta2 */
    const dhgen_wide Y1_2_p = m4 * N3_p - m5, Y1_2_m = m4 * N3_m - m5, v8 = Z1_3 * -Y1_2_p,
        v9 = Z1_3 * -Y1_2_m, v10 = v3 * Y1_2_p, v11 = v4 * Y1_2_m, v12 = m4 * Z1_3,
        v13 = m4 * -Z1_3, factor2_p = DHGEN_QUOTIENT(1.0, N3_p),
        factor2_m = DHGEN_QUOTIENT(1.0, N3_m);

    /* theta4 */
    const dhgen_wide v14 = m6 * Z1_3, v15 = v14 - m7 * v3, v16 = v14 - m7 * v4,
        v17 = m7 + m8 * factor2_p, v18 = m7 + m8 * factor2_m, v19 = m6 + m9 * factor2_p,
        v20 = m6 + m9 * factor2_m, v21 = Z1_3 * v17 + v3 * v19, v22 = Z1_3 * v18 + v4 * v20,
        c23_pp = w3_p * (factor2_p * v15) - v21, c23_pm = w3_p * (factor2_p * -v15) - v21,
        c23_mp = w3_m * (factor2_m * v16) - v22, c23_mm = w3_m * (factor2_m * -v16) - v22,
        v23 = m7 * Z1_3, v24 = v3 * v17 - Z1_3 * v19, v25 = v4 * v18 - Z1_3 * v20,
        v26 = w3_p * (factor2_p * (v23 + m6 * v3)), s23_pp = v24 - v26, s23_pm = v24 + v26,
        v27 = w3_m * (factor2_m * (v23 + m6 * v4)), s23_mp = v25 - v27, s23_mm = v25 + v27,
        v28 = w1 * (v2 * (T23 * Y1 - T13 * wx)), X4_pp = T33 * s23_pp - c23_pp * v28,
        X4_pm = T33 * s23_pm - c23_pm * v28, X4_mp = T33 * s23_mp + c23_mp * v28,
        X4_mm = T33 * s23_mm + c23_mm * v28, Y4 = w1 * (v2 * (T13 * Y1 + wx * T23)), v29 = Y4 * Y4,
        v30 = v29 + X4_pp * X4_pp, v31 = v29 + X4_pm * X4_pm, v32 = v29 + X4_mp * X4_mp,
        v33 = v29 + X4_mm * X4_mm, angle4 = dhgen_atan2_wide(Y4, -X4_pp),
        angle5 = dhgen_atan2_wide(Y4, -X4_pm), angle6 = dhgen_atan2_wide(-Y4, -X4_mp),
        angle7 = dhgen_atan2_wide(-Y4, -X4_mm), v34 = dhgen_signed_wide(DHGEN_HALF_TURN, Y4),
        v35 = dhgen_signed_wide(DHGEN_HALF_TURN, -Y4);

    /* theta6 */
    const dhgen_wide v36 = w1 * (v2 * (wx * T22 + Y1 * T12)),
        v37 = w1 * (v2 * (Y1 * T22 - wx * T12)), v38 = w1 * (v2 * (wx * T21 + Y1 * T11)),
        v39 = w1 * (v2 * (Y1 * T21 - wx * T11)),
        v40 = Y4 * (c23_pp * v39 - s23_pp * T31) + X4_pp * v38,
        v41 = Y4 * (c23_pm * v39 - s23_pm * T31) + X4_pm * v38,
        v42 = Y4 * (c23_mp * v39 + s23_mp * T31) - X4_mp * v38,
        v43 = Y4 * (c23_mm * v39 + s23_mm * T31) - X4_mm * v38,
        angle8 = dhgen_atan2_wide(v40, Y4 * (c23_pp * v37 - s23_pp * T32) + X4_pp * v36),
        angle9 = dhgen_atan2_wide(v41, Y4 * (c23_pm * v37 - s23_pm * T32) + X4_pm * v36),
        angle10 = dhgen_atan2_wide(v42, Y4 * (c23_mp * v37 + s23_mp * T32) - X4_mp * v36),
        angle11 = dhgen_atan2_wide(v43, Y4 * (c23_mm * v37 + s23_mm * T32) - X4_mm * v36);

    /* joint values */
    const dhgen_wide v44 = w3_p * (m4 * v3),
        angle12 = dhgen_atan2_wide(v8 + v44, -(v10 + w3_p * v12)), v45 = angle12 - offset2,
        angle13 = dhgen_atan2_wide(v8 - v44, -(v10 + w3_p * v13)), v46 = angle13 - offset2,
        angle14 = dhgen_atan2_wide(v9 + w3_m * (m4 * v4), -(v11 + w3_m * v12)),
        v47 = angle14 - offset2,
        angle15 = dhgen_atan2_wide(v9 + w3_m * (m4 * -v4), -(v11 + w3_m * v13)),
        v48 = angle15 - offset2, q2_ppp = dhgen_lowered_wide(v45), q2_pmp = dhgen_lowered_wide(v46),
        q2_mpp = dhgen_lowered_wide(v47), q2_mmp = dhgen_lowered_wide(v48),
        angle16 = dhgen_atan2_wide(dhgen_sqrt_wide(v30), T33 * c23_pp + s23_pp * v28),
        angle17 = dhgen_atan2_wide(dhgen_sqrt_wide(v31), T33 * c23_pm + s23_pm * v28),
        angle18 = dhgen_atan2_wide(dhgen_sqrt_wide(v32), T33 * c23_mp - s23_mp * v28),
        angle19 = dhgen_atan2_wide(dhgen_sqrt_wide(v33), T33 * c23_mm - s23_mm * v28),
        v49 = angle16 - offset5, v50 = offset5 + angle16, v51 = angle17 - offset5,
        v52 = offset5 + angle17, v53 = angle18 - offset5, v54 = offset5 + angle18,
        v55 = angle19 - offset5, v56 = offset5 + angle19, q5_ppp = dhgen_raised_wide(v49),
        q5_ppm = dhgen_only_wide(-v50 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v50,
        q5_pmp = dhgen_raised_wide(v51),
        q5_pmm = dhgen_only_wide(-v52 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v52,
        q5_mpp = dhgen_raised_wide(v53),
        q5_mpm = dhgen_only_wide(-v54 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v54,
        q5_mmp = dhgen_raised_wide(v55),
        q5_mmm = dhgen_only_wide(-v56 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v56,
        v57 = dhgen_raised_wide(q3__pp),
        v58 = dhgen_only_wide(-v6 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v6,
        v59 = dhgen_raised_wide(q3__mp),
        v60 = dhgen_only_wide(-v7 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v7,
        v61 = dhgen_exceeds_wide(angle1, joints), v62 = dhgen_exceeds_wide(q1__m, joints),
        v63 = v57 - dhgen_only_wide(dhgen_high(joints + 2) < v57, DHGEN_TURN),
        v64 = v58 - dhgen_only_wide(dhgen_high(joints + 2) < v58, DHGEN_TURN),
        v65 = v59 - dhgen_only_wide(dhgen_high(joints + 2) < v59, DHGEN_TURN),
        v66 = v60 - dhgen_only_wide(dhgen_high(joints + 2) < v60, DHGEN_TURN),
        v67 = dhgen_beyond_wide(v63, joints + 2), v68 = dhgen_beyond_wide(v64, joints + 2),
        v69 = dhgen_beyond_wide(v65, joints + 2), v70 = dhgen_beyond_wide(v66, joints + 2),
        v71 = v57 - dhgen_high(joints + 2), v72 = v58 - dhgen_high(joints + 2),
        v73 = v59 - dhgen_high(joints + 2), v74 = v60 - dhgen_high(joints + 2),
        v75 = dhgen_pick_wide(v71 < v67, v71, v67), v76 = dhgen_pick_wide(v72 < v68, v72, v68),
        v77 = dhgen_pick_wide(v73 < v69, v73, v69), v78 = dhgen_pick_wide(v74 < v70, v74, v70),
        q3_ppp = dhgen_pick_wide(0.0 < v75, v57, v63),
        q3_pmp = dhgen_pick_wide(0.0 < v76, v58, v64),
        q3_mpp = dhgen_pick_wide(0.0 < v77, v59, v65),
        q3_mmp = dhgen_pick_wide(0.0 < v78, v60, v66), q1_ppp = angle1 + (w3_p - w3_p),
        q1_mpp = q1__m + (w3_m - w3_m),
        v79 = dhgen_maximum_wide(v75, dhgen_maximum_wide(v61, dhgen_beyond_wide(q2_ppp, joints +
            1))),
        v80 = dhgen_maximum_wide(v76, dhgen_maximum_wide(v61, dhgen_beyond_wide(q2_pmp, joints +
            1))),
        v81 = dhgen_maximum_wide(v77, dhgen_maximum_wide(v62, dhgen_beyond_wide(q2_mpp, joints +
            1))),
        v82 = dhgen_maximum_wide(v78, dhgen_maximum_wide(v62, dhgen_beyond_wide(q2_mmp, joints +
            1))), excess_ppp = dhgen_maximum_wide(v79, dhgen_exceeds_wide(q5_ppp, joints + 4)),
        excess_ppm = dhgen_maximum_wide(v79, dhgen_exceeds_wide(q5_ppm, joints + 4)),
        excess_pmp = dhgen_maximum_wide(v80, dhgen_exceeds_wide(q5_pmp, joints + 4)),
        excess_pmm = dhgen_maximum_wide(v80, dhgen_exceeds_wide(q5_pmm, joints + 4)),
        excess_mpp = dhgen_maximum_wide(v81, dhgen_exceeds_wide(q5_mpp, joints + 4)),
        excess_mpm = dhgen_maximum_wide(v81, dhgen_exceeds_wide(q5_mpm, joints + 4)),
        excess_mmp = dhgen_maximum_wide(v82, dhgen_exceeds_wide(q5_mmp, joints + 4)),
        excess_mmm = dhgen_maximum_wide(v82, dhgen_exceeds_wide(q5_mmm, joints + 4));

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = q3_ppp; q[3] = angle4; q[4] = q5_ppp; q[5] = angle8;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_ppp);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = q3_ppp; q[9] = angle4 - v34; q[10] = q5_ppm;
    q[11] = angle8 - dhgen_signed_wide(DHGEN_HALF_TURN, v40);
    kind[1] = dhgen_kind_within_wide(q[6], 0.0 < excess_ppm);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = angle5; q[16] = q5_pmp; q[17] = angle9;
    kind[2] = dhgen_kind_within_wide(q[12], 0.0 < excess_pmp);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = angle5 - v34; q[22] = q5_pmm;
    q[23] = angle9 - dhgen_signed_wide(DHGEN_HALF_TURN, v41);
    kind[3] = dhgen_kind_within_wide(q[18], 0.0 < excess_pmm);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_mpp; q[27] = angle6; q[28] = q5_mpp; q[29] = angle10;
    kind[4] = dhgen_kind_within_wide(q[24], 0.0 < excess_mpp);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_mpp; q[33] = angle6 - v35; q[34] = q5_mpm;
    q[35] = angle10 - dhgen_signed_wide(DHGEN_HALF_TURN, v42);
    kind[5] = dhgen_kind_within_wide(q[30], 0.0 < excess_mpm);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_mmp; q[39] = angle7; q[40] = q5_mmp; q[41] = angle11;
    kind[6] = dhgen_kind_within_wide(q[36], 0.0 < excess_mmp);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_mmp; q[45] = angle7 - v35; q[46] = q5_mmm;
    q[47] = angle11 - dhgen_signed_wide(DHGEN_HALF_TURN, v43);
    kind[7] = dhgen_kind_within_wide(q[42], 0.0 < excess_mmm);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v33 <= m10) | (v32 <= m10) | (v31 <= m10) | (v30 <= m10) |
        (dhgen_abs_wide(D3_squared_m) <= m3) | (v1 <= m1) | (dhgen_abs_wide(D3_squared_p) <= m3)) |
        (dhgen_within_slack_wide(excess_mmm) | dhgen_within_slack_wide(excess_mmp) |
        dhgen_within_slack_wide(excess_mpm) | dhgen_within_slack_wide(excess_mpp) |
        dhgen_within_slack_wide(excess_pmm) | dhgen_within_slack_wide(excess_pmp) |
        dhgen_within_slack_wide(excess_ppp) | dhgen_within_slack_wide(excess_ppm));
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
        v2 = DHGEN_QUOTIENT(1.0, v1), v3 = copysign(DHGEN_HALF_TURN, Y1);

    /* theta3 */
    const double Z1_3 = T34 - d6 * T33 - d1;
    const dhgen_four v4 = a1 + e1 * w1;
    const double v5 = Z1_3 * Z1_3;
    const dhgen_four N3 = v5 + v4 * v4, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared);

    /* theta2 */
    const dhgen_four Y1_2 = m4 * N3 - m5, v6 = Z1_3 * -Y1_2, v7 = v4 * Y1_2, v8 = m4 * (e3 * Z1_3),
        factor2 = DHGEN_QUOTIENT(1.0, N3);

    /* theta4 */
    const double v9 = m6 * Z1_3;
    const dhgen_four v10 = v9 - m7 * v4, v11 = m7 + m8 * factor2, v12 = m6 + m9 * factor2,
        v13 = Z1_3 * v11 + v4 * v12, c23 = w3 * (factor2 * (e3 * v10)) - v13;
    const double v14 = m7 * Z1_3;
    const dhgen_four v15 = v14 + m6 * v4, v16 = v4 * v11 - Z1_3 * v12,
        s23 = v16 - w3 * (factor2 * (e3 * v15));
    const double v17 = w1 * (v2 * (T23 * Y1 - T13 * wx));
    const dhgen_four X4 = T33 * s23 - e1 * (c23 * v17);
    const double Y4 = w1 * (v2 * (T13 * Y1 + wx * T23)), v18 = Y4 * Y4;
    const dhgen_four v19 = v18 + X4 * X4, v20 = e1 * Y4,
        v21 = dhgen_signed_four(DHGEN_HALF_TURN, v20);

    /* theta6 */
    const double v22 = w1 * (v2 * (wx * T22 + Y1 * T12)), v23 = w1 * (v2 * (Y1 * T22 - wx * T12)),
        v24 = w1 * (v2 * (wx * T21 + Y1 * T11)), v25 = w1 * (v2 * (Y1 * T21 - wx * T11));
    const dhgen_four v26 = e1 * (Y4 * (e1 * (c23 * v25) - s23 * T31) + X4 * v24);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) |
        (dhgen_abs_four(D3_squared) <= m3) | (v19 <= m10)) | (unsigned)(v1 <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(w3, dhgen_all_four(Y1), 0, 5,
        2, 3), dhgen_shuffle(N3 - k3, dhgen_all_four(-wx), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(v6 + w3 * (m4 * (e3 * v4)), -(v7 + w3 * v8)),
        ratio3 = dhgen_ratio_four(v20, -X4),
        ratio4 = dhgen_ratio_four(v26, e1 * (Y4 * (e1 * (c23 * v23) - s23 * T32) + X4 * v22)),
        ratio5 = dhgen_ratio_four(dhgen_sqrt_four(v19), T33 * c23 + e1 * (s23 * v17));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle2 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle5 = dhgen_angle_four(ratio2),
        angle3 = dhgen_angle_four(ratio3), angle4 = dhgen_angle_four(ratio4),
        angle6 = dhgen_angle_four(ratio5);
    const dhgen_four q1_ = angle1 + v3 * (m2 * (e1 - 1.0)), q3_ = e3 * angle2 - turn1,
        q4_m = angle3 - v21, q6_m = angle4 - dhgen_signed_four(DHGEN_HALF_TURN, v26),
        v27 = angle5 - offset2, q2_p = dhgen_lowered_four(v27), v28 = angle6 - offset5,
        v29 = offset5 + angle6, q5_p = dhgen_raised_four(v28),
        q5_m = dhgen_only_four(-v29 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v29,
        v30 = dhgen_raised_four(q3_), v31 = dhgen_exceeds_four(q1_, joints),
        v32 = v30 - dhgen_only_four(dhgen_high(joints + 2) < v30, DHGEN_TURN),
        v33 = dhgen_beyond_four(v32, joints + 2), v34 = v30 - dhgen_high(joints + 2),
        v35 = dhgen_pick_four(v34 < v33, v34, v33), q3_p = dhgen_pick_four(0.0 < v35, v30, v32),
        q1_p = q1_ + (w3 - w3),
        v36 = dhgen_maximum_four(v35, dhgen_maximum_four(v31, dhgen_beyond_four(q2_p, joints + 1))),
        excess_p = dhgen_maximum_four(v36, dhgen_exceeds_four(q5_p, joints + 4)),
        excess_m = dhgen_maximum_four(v36, dhgen_exceeds_four(q5_m, joints + 4));
    const dhgen_four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (dhgen_bits_four((dhgen_within_slack_four(excess_p) | dhgen_within_slack_four(excess_m))))
        return -1;

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, q2_p, q3_p, angle3);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, q5_p, angle4);
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
DHGEN_TABLE int choosable[2] = { 3, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.2521, 0.2521, 0.2521, 1.0, 1.0, 1.0 }, 0.25207965717166625, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, abb_irb6640_fk,
    abb_irb6640_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) abb_irb6640_##function
#include "dhgen/functions.h"

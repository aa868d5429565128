/* abb_irb120: ABB IRB 120
 *
 * Inverse kinematics, generated from robots/abb_irb120.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/abb_irb120.yaml. The formulas and where they come from:
 * abb_irb120.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 1d5a53e83bedae87
 * SPDX-License-Identifier: MIT
 */
#include "abb_irb120.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(ABB_IRB120_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(ABB_IRB120_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef ABB_IRB120_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.29, /* joint offset 1 [m] */
    a2 = 0.27, /* link length 2 [m] */
    a3 = 0.07, /* link length 3 [m] */
    d4 = 0.302, /* joint offset 4 [m] */
    d6 = 0.072, /* z of the tool frame [m] */
    free_limit1 = 1.0040000000000002e-12, /* a length that fixes no angle [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    longest3 = 0.3364074838347159, /* square of the longest reach [m^2] */
    shortest3 = 0.0016005161652840592, /* square of the shortest reach [m^2] */
    longest3_reach = 0.3364074838348323, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0016005161652760261, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.3364074838347043, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.0016005161652848626, /* the shortest, where branches merge [m^2] */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    k1 = 0.16308, /* 2 * d4 * a2 [m^2] */
    k2 = 0.03780000000000001, /* 2 * a3 * a2 [m^2] */
    k3 = 0.16900400000000002, /* a2^2 + (a3^2 + d4^2) [m^2] */
    k4 = 35.683793403054324; /* 1 / (k1^2 + k2^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const abb_irb120_branches[8] = {
    "back-down-noflip", "back-down-flip", "back-up-noflip", "back-up-flip", "front-up-noflip",
    "front-up-flip", "front-down-noflip", "front-down-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.87979, 2.87979, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -1.91986, 1.91986, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -1.91986, 1.22173, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.79253, 2.79253, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.094395, 2.094395, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.98132, 6.98132, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 3.141592653589793, 0.29, 0.0, 1.5707963267948966 },
    { 1.5707963267948966, 0.0, 0.27, 0.0 },
    { 0.0, 0.0, 0.07, -1.5707963267948966 },
    { 0.0, 0.302, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE double tool[12] = { 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.072 };
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void abb_irb120_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v3 * s3,
        x3_y = x2_y * c3 - v4 * s3, x3_z = s2 * c3 + c2 * s3, v5 = v3 * c3 + x2_x * s3,
        v6 = v4 * c3 + x2_y * s3, z3_z = c2 * c3 - s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        z4_y = x3_y * s4 - c1 * c4, v7 = q[4] + offset5;
    const double c5 = cos(v7), s5 = sin(v7), x5_x = x4_x * c5 - v5 * s5, x5_y = x4_y * c5 - v6 * s5,
        x5_z = x4_z * c5 + z3_z * s5, z5_x = v5 * c5 + x4_x * s5, z5_y = v6 * c5 + x4_y * s5,
        z5_z = x4_z * s5 - z3_z * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = z5_x; T[1] = z4_x * c6 - x5_x * s6; T[2] = -(x5_x * c6 + z4_x * s6);
    T[3] = x2_x * a2 + x3_x * a3 - v5 * d4 + z5_x * d6;
    T[4] = z5_y; T[5] = z4_y * c6 - x5_y * s6; T[6] = -(x5_y * c6 + z4_y * s6);
    T[7] = x2_y * a2 + x3_y * a3 - v6 * d4 + z5_y * d6;
    T[8] = z5_z; T[9] = z4_z * c6 - x5_z * s6; T[10] = -(x5_z * c6 + z4_z * s6);
    T[11] = d1 + s2 * a2 + x3_z * a3 + z3_z * d4 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void abb_irb120_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v3 * s3,
        x3_y = x2_y * c3 - v4 * s3, x3_z = s2 * c3 + c2 * s3, v5 = v3 * c3 + x2_x * s3,
        v6 = v4 * c3 + x2_y * s3, z3_z = c2 * c3 - s2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z + x3_z * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        p4_x = p3_x - v5 * d4, p4_y = p3_y - v6 * d4, p4_z = p3_z + z3_z * d4,
        z4_y = x3_y * s4 - c1 * c4, v7 = q[4] + offset5;
    const double c5 = cos(v7), s5 = sin(v7), z5_x = v5 * c5 + (x3_x * c4 - s1 * s4) * s5,
        z5_y = v6 * c5 + (x3_y * c4 + c1 * s4) * s5, z5_z = x3_z * c4 * s5 - z3_z * c5,
        J21 = p4_x + z5_x * d6, v8 = p4_y + z5_y * d6, v9 = p4_z + z5_z * d6, v10 = v9 - d1,
        v11 = v9 - p2_z, v12 = J21 - p3_x, v13 = v8 - p3_y, v14 = v9 - p3_z, v15 = J21 - p4_x,
        v16 = v8 - p4_y, v17 = v9 - p4_z;
    J[0] = -v8; J[1] = -(c1 * v10); J[2] = -(c1 * v11); J[3] = -(v6 * v14 + z3_z * v13);
    J[4] = z4_y * v17 - z4_z * v16; J[5] = z5_y * v17 - z5_z * v16;
    J[6] = J21; J[7] = -(s1 * v10); J[8] = -(s1 * v11); J[9] = z3_z * v12 + v5 * v14;
    J[10] = z4_z * v15 - z4_x * v17; J[11] = z5_z * v15 - z5_x * v17;
    J[12] = 0.0; J[13] = s1 * v8 + c1 * J21; J[14] = s1 * (v8 - p2_y) + c1 * (J21 - p2_x);
    J[15] = v6 * v12 - v5 * v13; J[16] = z4_x * v16 - z4_y * v15; J[17] = z5_x * v16 - z5_y * v15;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = -v5; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -v6; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[3, 4] */
    const double X1 = d6 * T11 - T14;
    const double t24 = T24 - d6 * T21;
    const double w1 = sqrt(X1 * X1 + t24 * t24);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;
    const double v1 = seed[0] + offset1;

    /* theta3, type 6: U1[2, 4] and U1[1, 4] */
    const double t34 = T34 - d6 * T31;
    const double Z1_3 = t34 - d1;
    const double v2 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(v1) : -(X1 * factor1), s1 = free1 ? sin(v1) : t24 * factor1;
        const double D1 = w1 * e1;

        /* theta3 */
        const double N3 = v2 + D1 * D1;
        const double K3 = N3 - k3;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double v3 = k1 * K3, v4 = k2 * K3;

        /* theta4, type 2: U4[3, 3] */
        const double v5 = T11 * c1 + T21 * s1;
        const double Y4 = T21 * c1 - T11 * s1;
        const double v7 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v8 = T12 * s1 - T22 * c1, v9 = T12 * c1 + T22 * s1, v11 = T23 * c1 - T13 * s1,
            v12 = T13 * c1 + T23 * s1;

        /* joint values */
        const double q1 = dhgen_wrap(atan2(s1, c1) - offset1);

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double D3 = w3 * e3;
            const double s3 = (k2 * D3 - v3) * k4, c3 = k4 * (v4 + k1 * D3);
            const double q3 = atan2(s3, c3);

            /* theta2, type 3: U1[2, 4] and U1[1, 4] */
            const double X1_2 = a2 + (a3 * c3 - d4 * s3);
            const double Y1_2 = d4 * c3 + a3 * s3;
            const double S2 = Z1_3 * X1_2 - D1 * Y1_2;
            const double C2 = D1 * X1_2 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const double factor2 = 1.0 / w2;
            const double c2 = C2 * factor2, s2 = S2 * factor2;

            /* theta4 */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2,
                v6 = c23 * v5 + T31 * s23;
            const double w4 = sqrt(v6 * v6 + v7);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = s23 * v5 - T31 * c23;

            /* theta6 */
            const double v10 = c23 * v9 + T32 * s23, v13 = c23 * v12 + T33 * s23;

            /* joint values */
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : v6 * factor4,
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);
                const double s5 = w4 * e4;

                /* theta6 */
                const double c6 = c4 * v8 + s4 * v10, s6 = c4 * v11 - s4 * v13;
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

#ifndef ABB_IRB120_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.00010040000000000001 [m],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    turn1 = 1.3430303610541368, /* atan2(k1, k2) [rad] */
    m1 = 1.0080160000000003e-08, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 3.884373725055392e-12,
    m3 = 1.3488473906354537, /* k2 * k4 [m^-2] */
    m4 = 0.9834871790128595, /* k1 * k3 * k4 */
    m5 = 5.819313028170099, /* k1 * k4 [m^-2] */
    m6 = 0.22796060440695423, /* k2 * k3 * k4 */
    m7 = 1.8518518518518516, /* k4 * (d4 * k1 + a3 * k2) [m^-1] */
    m8 = 0.04297037037037035, /* d4 * k1 * k3 * k4 + a3 * k2 * k3 * k4 - a2 [m] */
    m9 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide X1 = d6 * T11 - T14, t24 = T24 - d6 * T21, v1 = X1 * X1 + t24 * t24,
        w1 = dhgen_sqrt_wide(v1), v2 = DHGEN_QUOTIENT(1.0, v1);

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d6 * T31 - d1, N3 = v1 + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_wide(D3_squared),
        v3 = w3 - w3, v4 = m4 - m5 * N3, v5 = m3 * w3, s3_p = v4 + v5, s3_m = v4 - v5,
        v6 = m3 * N3 - m6, v7 = m5 * w3, c3_p = v6 + v7, c3_m = v6 - v7,
        angle1 = dhgen_atan2_wide(w3, N3 - k3), q3__p = angle1 - turn1, v8 = turn1 + angle1;

    /* theta2 */
    const dhgen_wide X1_2 = m7 * N3 - m8, v9 = Z1_3 * X1_2, v10 = w3 * (m7 * w1), S2_pp = v9 - v10,
        S2_pm = v9 + v10, v11 = w3 * (m7 * Z1_3), v12 = w3 * (m7 * -Z1_3), v13 = w1 * X1_2,
        v14 = w1 * -X1_2, C2_pp = v11 + v13, C2_pm = v12 + v13, C2_mp = v11 + v14,
        C2_mm = v12 + v14, factor2 = DHGEN_QUOTIENT(1.0, N3);

    /* theta4 */
    const dhgen_wide c23_pp = c3_p * C2_pp - s3_p * S2_pp, c23_pm = c3_m * C2_pm - s3_m * S2_pm,
        c23_mp = c3_p * C2_mp - s3_p * S2_pm, c23_mm = c3_m * C2_mm - s3_m * S2_pp,
        s23_pp = c3_p * S2_pp + s3_p * C2_pp, s23_pm = c3_m * S2_pm + s3_m * C2_pm,
        s23_mp = c3_p * S2_pm + s3_p * C2_mp, s23_mm = c3_m * S2_pp + s3_m * C2_mm,
        v15 = w1 * (v2 * (T21 * t24 - T11 * X1)), c4_pp = T31 * s23_pp + c23_pp * v15,
        c4_pm = T31 * s23_pm + c23_pm * v15, c4_mp = T31 * s23_mp - c23_mp * v15,
        c4_mm = T31 * s23_mm - c23_mm * v15, v16 = w1 * (v2 * (T11 * t24 + X1 * T21)),
        v17 = v16 * v16, v18 = factor2 * c4_pp, v19 = factor2 * c4_pm, v20 = factor2 * c4_mp,
        v21 = factor2 * c4_mm, v22 = v17 + factor2 * (c4_pp * v18),
        v23 = v17 + factor2 * (c4_pm * v19), v24 = v17 + factor2 * (c4_mp * v20),
        v25 = v17 + factor2 * (c4_mm * v21), angle2 = dhgen_atan2_wide(-v16, v18),
        angle3 = dhgen_atan2_wide(-v16, v19), angle4 = dhgen_atan2_wide(v16, v20),
        angle5 = dhgen_atan2_wide(v16, v21), v26 = dhgen_signed_wide(DHGEN_HALF_TURN, -v16),
        v27 = dhgen_signed_wide(DHGEN_HALF_TURN, v16), q4_ppm = angle2 - v26, q4_pmm = angle3 - v26,
        q4_mpm = angle4 - v27, q4_mmm = angle5 - v27;

    /* theta6 */
    const dhgen_wide v28 = w1 * (v2 * (X1 * T22 + t24 * T12)),
        v29 = w1 * (v2 * (t24 * T22 - X1 * T12)), v30 = w1 * (v2 * (X1 * T23 + t24 * T13)),
        v31 = w1 * (v2 * (t24 * T23 - X1 * T13)),
        v32 = v16 * (s23_pp * T33 + c23_pp * v31) - c4_pp * v30,
        v33 = v16 * (s23_pm * T33 + c23_pm * v31) - c4_pm * v30,
        v34 = c4_mp * v30 - v16 * (s23_mp * T33 - c23_mp * v31),
        v35 = c4_mm * v30 - v16 * (s23_mm * T33 - c23_mm * v31),
        angle6 = dhgen_atan2_wide(v32, c4_pp * v28 - v16 * (s23_pp * T32 + c23_pp * v29)),
        angle7 = dhgen_atan2_wide(v33, c4_pm * v28 - v16 * (s23_pm * T32 + c23_pm * v29)),
        angle8 = dhgen_atan2_wide(v34, v16 * (s23_mp * T32 - c23_mp * v29) - c4_mp * v28),
        angle9 = dhgen_atan2_wide(v35, v16 * (s23_mm * T32 - c23_mm * v29) - c4_mm * v28);

    /* joint values */
    const dhgen_wide angle10 = dhgen_atan2_wide(t24, -X1), v36 = angle10 - offset1,
        v37 = angle10 - dhgen_signed_wide(DHGEN_HALF_TURN, t24) - offset1,
        q1__p = dhgen_raised_wide(v36), q1__m = dhgen_raised_wide(v37),
        angle11 = dhgen_atan2_wide(S2_pp, C2_pp), v38 = angle11 - offset2,
        angle12 = dhgen_atan2_wide(S2_pm, C2_pm), v39 = angle12 - offset2,
        angle13 = dhgen_atan2_wide(S2_pm, C2_mp), v40 = angle13 - offset2,
        angle14 = dhgen_atan2_wide(S2_pp, C2_mm), v41 = angle14 - offset2,
        q2_ppp = dhgen_raised_wide(v38), q2_pmp = dhgen_raised_wide(v39),
        q2_mpp = dhgen_raised_wide(v40), q2_mmp = dhgen_raised_wide(v41),
        angle15 = dhgen_atan2_wide(dhgen_sqrt_wide(v22), factor2 * (s23_pp * v15 - T31 * c23_pp)),
        angle16 = dhgen_atan2_wide(dhgen_sqrt_wide(v23), factor2 * (s23_pm * v15 - T31 * c23_pm)),
        angle17 = dhgen_atan2_wide(dhgen_sqrt_wide(v24), -(factor2 * (s23_mp * v15 + T31 *
            c23_mp))),
        angle18 = dhgen_atan2_wide(dhgen_sqrt_wide(v25), -(factor2 * (s23_mm * v15 + T31 *
            c23_mm))), v42 = angle15 - offset5, v43 = offset5 + angle15, v44 = angle16 - offset5,
        v45 = offset5 + angle16, v46 = angle17 - offset5, v47 = offset5 + angle17,
        v48 = angle18 - offset5, v49 = offset5 + angle18, q5_ppp = dhgen_raised_wide(v42),
        q5_ppm = dhgen_only_wide(-v43 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v43,
        q5_pmp = dhgen_raised_wide(v44),
        q5_pmm = dhgen_only_wide(-v45 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v45,
        q5_mpp = dhgen_raised_wide(v46),
        q5_mpm = dhgen_only_wide(-v47 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v47,
        q5_mmp = dhgen_raised_wide(v48),
        q5_mmm = dhgen_only_wide(-v49 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v49,
        q3_ppp = dhgen_raised_wide(q3__p),
        q3_pmp = dhgen_only_wide(-v8 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v8,
        v50 = dhgen_exceeds_wide(q1__p, joints), v51 = dhgen_exceeds_wide(q1__m, joints),
        v52 = dhgen_beyond_wide(q3_ppp, joints + 2), v53 = dhgen_beyond_wide(q3_pmp, joints + 2),
        q1_ppp = v3 + q1__p, q1_mpp = v3 + q1__m,
        v54 = dhgen_maximum_wide(dhgen_exceeds_wide(q2_ppp, joints + 1), dhgen_maximum_wide(v50,
            v52)),
        v55 = dhgen_maximum_wide(dhgen_exceeds_wide(q2_pmp, joints + 1), dhgen_maximum_wide(v50,
            v53)),
        v56 = dhgen_maximum_wide(dhgen_exceeds_wide(q2_mpp, joints + 1), dhgen_maximum_wide(v51,
            v52)),
        v57 = dhgen_maximum_wide(dhgen_exceeds_wide(q2_mmp, joints + 1), dhgen_maximum_wide(v51,
            v53)),
        excess_ppp = dhgen_maximum_wide(dhgen_exceeds_wide(q5_ppp, joints + 4),
            dhgen_maximum_wide(v54, dhgen_exceeds_wide(angle2, joints + 3))),
        excess_ppm = dhgen_maximum_wide(dhgen_exceeds_wide(q5_ppm, joints + 4),
            dhgen_maximum_wide(v54, dhgen_exceeds_wide(q4_ppm, joints + 3))),
        excess_pmp = dhgen_maximum_wide(dhgen_exceeds_wide(q5_pmp, joints + 4),
            dhgen_maximum_wide(v55, dhgen_exceeds_wide(angle3, joints + 3))),
        excess_pmm = dhgen_maximum_wide(dhgen_exceeds_wide(q5_pmm, joints + 4),
            dhgen_maximum_wide(v55, dhgen_exceeds_wide(q4_pmm, joints + 3))),
        excess_mpp = dhgen_maximum_wide(dhgen_exceeds_wide(q5_mpp, joints + 4),
            dhgen_maximum_wide(v56, dhgen_exceeds_wide(angle4, joints + 3))),
        excess_mpm = dhgen_maximum_wide(dhgen_exceeds_wide(q5_mpm, joints + 4),
            dhgen_maximum_wide(v56, dhgen_exceeds_wide(q4_mpm, joints + 3))),
        excess_mmp = dhgen_maximum_wide(dhgen_exceeds_wide(q5_mmp, joints + 4),
            dhgen_maximum_wide(v57, dhgen_exceeds_wide(angle5, joints + 3))),
        excess_mmm = dhgen_maximum_wide(dhgen_exceeds_wide(q5_mmm, joints + 4),
            dhgen_maximum_wide(v57, dhgen_exceeds_wide(q4_mmm, joints + 3)));

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = q3_ppp; q[3] = angle2; q[4] = q5_ppp; q[5] = angle6;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_ppp);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = q3_ppp; q[9] = q4_ppm; q[10] = q5_ppm;
    q[11] = angle6 - dhgen_signed_wide(DHGEN_HALF_TURN, v32);
    kind[1] = dhgen_kind_within_wide(q[6], 0.0 < excess_ppm);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = angle3; q[16] = q5_pmp; q[17] = angle7;
    kind[2] = dhgen_kind_within_wide(q[12], 0.0 < excess_pmp);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = q4_pmm; q[22] = q5_pmm;
    q[23] = angle7 - dhgen_signed_wide(DHGEN_HALF_TURN, v33);
    kind[3] = dhgen_kind_within_wide(q[18], 0.0 < excess_pmm);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_ppp; q[27] = angle4; q[28] = q5_mpp; q[29] = angle8;
    kind[4] = dhgen_kind_within_wide(q[24], 0.0 < excess_mpp);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_ppp; q[33] = q4_mpm; q[34] = q5_mpm;
    q[35] = angle8 - dhgen_signed_wide(DHGEN_HALF_TURN, v34);
    kind[5] = dhgen_kind_within_wide(q[30], 0.0 < excess_mpm);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_pmp; q[39] = angle5; q[40] = q5_mmp; q[41] = angle9;
    kind[6] = dhgen_kind_within_wide(q[36], 0.0 < excess_mmp);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_pmp; q[45] = q4_mmm; q[46] = q5_mmm;
    q[47] = angle9 - dhgen_signed_wide(DHGEN_HALF_TURN, v35);
    kind[7] = dhgen_kind_within_wide(q[42], 0.0 < excess_mmm);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D3_squared) <= m2) | (v1 <= m1) | (v25 <= m9) | (v24 <=
        m9) | (v22 <= m9) | (v23 <= m9)) | (dhgen_within_slack_wide(excess_mmm) |
        dhgen_within_slack_wide(excess_mmp) | dhgen_within_slack_wide(excess_mpm) |
        dhgen_within_slack_wide(excess_mpp) | dhgen_within_slack_wide(excess_pmm) |
        dhgen_within_slack_wide(excess_pmp) | dhgen_within_slack_wide(excess_ppp) |
        dhgen_within_slack_wide(excess_ppm));
}

#if DHGEN_LANES > 1
static const double
    m10 = 0.5; /* 1 / 2 */
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
    const double X1 = d6 * T11 - T14, t24 = T24 - d6 * T21, v1 = X1 * X1 + t24 * t24, w1 = sqrt(v1),
        v2 = DHGEN_QUOTIENT(1.0, v1);

    /* theta3 */
    const double Z1_3 = T34 - d6 * T31 - d1, N3 = v1 + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared), v3 = w3 - w3,
        v4 = m4 - m5 * N3;
    const dhgen_four s3 = v4 + w3 * (m3 * e3);
    const double v5 = m3 * N3 - m6;
    const dhgen_four c3 = v5 + w3 * (m5 * e3);

    /* theta2 */
    const double X1_2 = m7 * N3 - m8, v6 = Z1_3 * X1_2;
    const dhgen_four S2 = v6 - w3 * (m7 * (w1 * (e1 * e3))), v7 = w3 * (m7 * (e3 * Z1_3)),
        v8 = w1 * (e1 * X1_2), C2 = v7 + v8;
    const double factor2 = DHGEN_QUOTIENT(1.0, N3);

    /* theta4 */
    const dhgen_four c23 = c3 * C2 - s3 * S2, s23 = c3 * S2 + s3 * C2;
    const double v9 = w1 * (v2 * (T21 * t24 - T11 * X1));
    const dhgen_four c4 = T31 * s23 + e1 * (c23 * v9);
    const double v10 = w1 * (v2 * (T11 * t24 + X1 * T21)), v11 = v10 * v10;
    const dhgen_four v12 = factor2 * c4, v13 = v11 + factor2 * (c4 * v12),
        v14 = dhgen_signed_four(DHGEN_HALF_TURN, -(e1 * v10));

    /* theta6 */
    const double v15 = w1 * (v2 * (X1 * T22 + t24 * T12)), v16 = w1 * (v2 * (t24 * T22 - X1 * T12)),
        v17 = w1 * (v2 * (X1 * T23 + t24 * T13)), v18 = w1 * (v2 * (t24 * T23 - X1 * T13));
    const dhgen_four v19 = e1 * (v10 * (s23 * T33 + e1 * (c23 * v18)) - c4 * v17);

    /* joint values */
    const double v20 = copysign(DHGEN_HALF_TURN, t24);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | (v13 <= m9)) |
        (unsigned)((v1 <= m1) | (fabs(D3_squared) <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(w3, t24, w3, w3),
        dhgen_four_of(N3 - k3, -X1, N3 - k3, N3 - k3)), ratio2 = dhgen_ratio_four(S2, C2),
        ratio3 = dhgen_ratio_four(-(e1 * v10), v12),
        ratio4 = dhgen_ratio_four(v19, e1 * (c4 * v15 - v10 * (s23 * T32 + e1 * (c23 * v16)))),
        ratio5 = dhgen_ratio_four(dhgen_sqrt_four(v13), factor2 * (e1 * (s23 * v9) - T31 * c23));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle4 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle5 = dhgen_angle_four(ratio2),
        angle2 = dhgen_angle_four(ratio3), angle3 = dhgen_angle_four(ratio4),
        angle6 = dhgen_angle_four(ratio5);
    const dhgen_four q3_ = e3 * angle1 - turn1, q4_m = angle2 - v14,
        q6_m = angle3 - dhgen_signed_four(DHGEN_HALF_TURN, v19),
        v21 = angle4 + v20 * (m10 * (e1 - 1.0)) - offset1, q1_ = dhgen_raised_four(v21),
        v22 = angle5 - offset2, q2_p = dhgen_raised_four(v22), v23 = angle6 - offset5,
        v24 = offset5 + angle6, q5_p = dhgen_raised_four(v23),
        q5_m = dhgen_only_four(-v24 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v24,
        q3_p = dhgen_raised_four(q3_), v25 = dhgen_exceeds_four(q1_, joints),
        v26 = dhgen_beyond_four(q3_p, joints + 2), q1_p = v3 + q1_,
        v27 = dhgen_maximum_four(dhgen_exceeds_four(q2_p, joints + 1), dhgen_maximum_four(v25,
            v26)),
        excess_p = dhgen_maximum_four(dhgen_exceeds_four(q5_p, joints + 4), dhgen_maximum_four(v27,
            dhgen_exceeds_four(angle2, joints + 3))),
        excess_m = dhgen_maximum_four(dhgen_exceeds_four(q5_m, joints + 4), dhgen_maximum_four(v27,
            dhgen_exceeds_four(q4_m, joints + 3)));
    const dhgen_four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (dhgen_bits_four((dhgen_within_slack_four(excess_p) | dhgen_within_slack_four(excess_m))))
        return -1;

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, q2_p, q3_p, angle2);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, q5_p, angle3);
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
    { 0.996, 0.996, 0.996, 1.0, 1.0, 1.0 }, 0.9960159362549799, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, abb_irb120_fk,
    abb_irb120_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) abb_irb120_##function
#include "dhgen/functions.h"

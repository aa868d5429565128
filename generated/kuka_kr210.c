/* kuka_kr210: KUKA KR 210
 *
 * Inverse kinematics, generated from robots/kuka_kr210.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_kr210.yaml. The formulas and where they come from:
 * kuka_kr210.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 3e814aec3a2fdecb
 * SPDX-License-Identifier: MIT
 */
#include "kuka_kr210.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KUKA_KR210_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KUKA_KR210_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef KUKA_KR210_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.75, /* joint offset 1 [m] */
    a1 = 0.35, /* link length 2 [m] */
    a2 = 1.25, /* link length 3 [m] */
    d4 = 1.5, /* joint offset 4 [m] */
    a3 = 0.054, /* link length 4 [m] */
    d7 = 0.303, /* z of the tool frame [m] */
    free_limit1 = 4.207e-12, /* a length that fixes no angle [m] */
    longest3 = 7.567845213189771, /* square of the longest reach [m^2] */
    shortest3 = 0.06298678681022957, /* square of the shortest reach [m^2] */
    longest3_reach = 7.567845213192085, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.06298678681001839, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 7.567845213189539, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.06298678681025069, /* the shortest, where branches merge [m^2] */
    offset2 = -1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 3.75, /* 2 * d4 * a2 [m^2] */
    k2 = 0.135, /* 2 * a3 * a2 [m^2] */
    k3 = 3.815416, /* a2^2 + (d4^2 + a3^2) [m^2] */
    k4 = 0.07101907039587806; /* 1 / (k1^2 + k2^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const kuka_kr210_branches[8] = {
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

/* The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.75, 0.0, 0.0 },
    { -1.5707963267948966, 0.0, 0.35, -1.5707963267948966 },
    { 0.0, 0.0, 1.25, 0.0 },
    { 0.0, 1.5, -0.054, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
};
DHGEN_TABLE double tool[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.303 };
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_MODIFIED, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void kuka_kr210_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v2 * s3,
        x3_y = x2_y * c3 - v3 * s3, v4 = s2 * c3 + c2 * s3, v5 = v2 * c3 + x2_x * s3,
        v6 = v3 * c3 + x2_y * s3, y3_z = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + s1 * s4,
        x4_y = x3_y * c4 - c1 * s4, v7 = v4 * c4, y4_x = s1 * c4 - x3_x * s4,
        z5_y = c1 * c4 + x3_y * s4, y4_z = v4 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v5 * s5,
        x5_y = x4_y * c5 - v6 * s5, x5_z = y3_z * s5 - v7 * c5, v8 = v5 * c5 + x4_x * s5,
        v9 = v6 * c5 + x4_y * s5, y5_z = y3_z * c5 + v7 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + y4_x * s6; T[1] = y4_x * c6 - x5_x * s6; T[2] = -v8;
    T[3] = c1 * a1 + x2_x * a2 - x3_x * a3 - v5 * d4 - v8 * d7;
    T[4] = x5_y * c6 - z5_y * s6; T[5] = -(z5_y * c6 + x5_y * s6); T[6] = -v9;
    T[7] = s1 * a1 + x2_y * a2 - x3_y * a3 - v6 * d4 - v9 * d7;
    T[8] = x5_z * c6 + y4_z * s6; T[9] = y4_z * c6 - x5_z * s6; T[10] = y5_z;
    T[11] = d1 - s2 * a2 + v4 * a3 + y3_z * d4 + y5_z * d7;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void kuka_kr210_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p2_x = c1 * a1, p2_y = s1 * a1,
        v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2, p3_x = p2_x + x2_x * a2, p3_y = p2_y + x2_y * a2, p3_z = d1 - s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v2 * s3,
        x3_y = x2_y * c3 - v3 * s3, v4 = s2 * c3 + c2 * s3, v5 = v2 * c3 + x2_x * s3,
        v6 = v3 * c3 + x2_y * s3, y3_z = s2 * s3 - c2 * c3, p4_x = p3_x - x3_x * a3 - v5 * d4,
        p4_y = p3_y - x3_y * a3 - v6 * d4, p4_z = p3_z + v4 * a3 + y3_z * d4;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z5_y = c1 * c4 + x3_y * s4, y4_z = v4 * s4,
        z5_x = x3_x * s4 - s1 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), v7 = v5 * c5 + (x3_x * c4 + s1 * s4) * s5,
        v8 = v6 * c5 + (x3_y * c4 - c1 * s4) * s5, y5_z = y3_z * c5 + v4 * c4 * s5,
        J21 = p4_x - v7 * d7, v9 = p4_y - v8 * d7, v10 = p4_z + y5_z * d7, v11 = v10 - d1,
        v12 = v10 - p3_z, v13 = J21 - p4_x, v14 = v9 - p4_y, v15 = v10 - p4_z;
    J[0] = -v9; J[1] = c1 * v11; J[2] = c1 * v12; J[3] = -(v6 * v15 + y3_z * v14);
    J[4] = z5_y * v15 + y4_z * v14; J[5] = -(v8 * v15 + y5_z * v14);
    J[6] = J21; J[7] = s1 * v11; J[8] = s1 * v12; J[9] = y3_z * v13 + v5 * v15;
    J[10] = -(y4_z * v13 + z5_x * v15); J[11] = y5_z * v13 + v7 * v15;
    J[12] = 0.0; J[13] = -(s1 * (v9 - p2_y) + c1 * (J21 - p2_x));
    J[14] = -(s1 * (v9 - p3_y) + c1 * (J21 - p3_x)); J[15] = v6 * v13 - v5 * v14;
    J[16] = z5_x * v14 - z5_y * v13; J[17] = v8 * v13 - v7 * v14;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = -v5; J[22] = z5_x; J[23] = -v7;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = -v6; J[28] = z5_y; J[29] = -v8;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = y3_z; J[34] = -y4_z; J[35] = y5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[2, 4] */
    const double t14 = T14 - d7 * T13;
    const double Y1 = d7 * T23 - T24;
    const double w1 = sqrt(t14 * t14 + Y1 * Y1);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 6: U1[3, 4] and U1[1, 4] */
    const double t34 = T34 - d7 * T33;
    const double Z1_3 = t34 - d1;
    const double v2 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(t14 * factor1),
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
        const double v3 = k1 * K3, v5 = k2 * K3;

        /* theta4, type 2: U4[2, 3] */
        const double v7 = T13 * c1 + T23 * s1;
        const double Y4 = T23 * c1 - T13 * s1;
        const double v8 = Y4 * Y4;

        /* theta6, type 3: U4[2, 2] and U4[2, 1] */
        const double v9 = T22 * c1 - T12 * s1, v10 = T12 * c1 + T22 * s1, v12 = T21 * c1 - T11 * s1,
            v13 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double D3 = w3 * e3;
            const double v4 = (v3 + k2 * D3) * k4;
            const double c3 = k4 * (k1 * D3 - v5);
            const double q3 = atan2(-v4, c3);

            /* theta2, type 3: U1[1, 4] and U1[3, 4] */
            const double v6 = d4 * c3 + a3 * v4;
            const double X2_2 = a3 * c3 - d4 * v4 - a2;
            const double S2 = v1 * v6 - Z1_3 * -X2_2;
            const double C2 = v1 * X2_2 - Z1_3 * v6;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const double factor2 = 1.0 / w2;
            const double c2 = C2 * factor2, s2 = S2 * factor2;

            /* theta4 */
            const double c23 = c3 * c2 + v4 * s2, s23 = c3 * s2 - v4 * c2;
            const double X4 = c23 * v7 - T33 * s23;
            const double w4 = sqrt(X4 * X4 + v8);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

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

                /* theta5, type 3: U4[3, 3] and U4[1, 3] */
                const double q5 = atan2(s5, -(T33 * c23 + s23 * v7));

                /* theta6 */
                const double q6 = atan2(-(c4 * v12 + s4 * v14), -(c4 * v9 + s4 * v11));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef KUKA_KR210_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.00042070000000000003 [m],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 1.7698849000000003e-07, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 1.739735510573048e-09,
    m4 = 0.009587574503443538, /* k2 * k4 [m^-2] */
    m5 = 1.016127365600848, /* k1 * k3 * k4 */
    m6 = 0.26632151398454273, /* k1 * k4 [m^-2] */
    m7 = 0.03658058516163053, /* k2 * k3 * k4 */
    m8 = 0.4, /* k4 * (d4 * k1 + a3 * k2) [m^-1] */
    m9 = 0.27616640000000003, /* d4 * k1 * k3 * k4 + a3 * k2 * k3 * k4 - a2 [m] */
    m10 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide t14 = T14 - d7 * T13, Y1 = d7 * T23 - T24, v1 = t14 * t14 + Y1 * Y1,
        w1 = dhgen_sqrt_wide(v1), v2 = DHGEN_QUOTIENT(1.0, v1), angle1 = dhgen_atan2_wide(Y1, -t14);

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d7 * T33 - d1, v3 = a1 + w1, v4 = a1 - w1, v5 = Z1_3 * Z1_3,
        N3_p = v5 + v3 * v3, N3_m = v5 + v4 * v4,
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m), v6 = m6 * N3_p - m5, v7 = m6 * N3_m - m5,
        v8 = m4 * w3_p, v9 = v6 + v8, v10 = v6 - v8, v11 = m4 * w3_m, v12 = v7 + v11,
        v13 = v7 - v11, v14 = m7 - m4 * N3_p, v15 = m7 - m4 * N3_m, v16 = m6 * w3_p,
        c3_pp = v14 + v16, c3_pm = v14 - v16, v17 = m6 * w3_m, c3_mp = v15 + v17, c3_mm = v15 - v17,
        angle2 = dhgen_atan2_wide(-v9, c3_pp), angle3 = dhgen_atan2_wide(-v10, c3_pm),
        angle4 = dhgen_atan2_wide(-v12, c3_mp), angle5 = dhgen_atan2_wide(-v13, c3_mm);

    /* theta2 */
    const dhgen_wide X2_2_p = m9 - m8 * N3_p, X2_2_m = m9 - m8 * N3_m, v18 = Z1_3 * X2_2_p,
        v19 = Z1_3 * X2_2_m, v20 = w3_p * (m8 * v3), S2_pp = v18 + v20, S2_pm = v18 - v20,
        S2_mp = v19 + w3_m * (m8 * v4), S2_mm = v19 + w3_m * (m8 * -v4), v21 = v3 * X2_2_p,
        v22 = v4 * X2_2_m, v23 = m8 * Z1_3, v24 = m8 * -Z1_3, C2_pp = v21 - w3_p * v23,
        C2_pm = v21 - w3_p * v24, C2_mp = v22 - w3_m * v23, C2_mm = v22 - w3_m * v24,
        factor2_p = DHGEN_QUOTIENT(1.0, N3_p), factor2_m = DHGEN_QUOTIENT(1.0, N3_m);

    /* theta4 */
    const dhgen_wide c23_pp = c3_pp * C2_pp + v9 * S2_pp, c23_pm = c3_pm * C2_pm + v10 * S2_pm,
        c23_mp = c3_mp * C2_mp + v12 * S2_mp, c23_mm = c3_mm * C2_mm + v13 * S2_mm,
        s23_pp = c3_pp * S2_pp - v9 * C2_pp, s23_pm = c3_pm * S2_pm - v10 * C2_pm,
        s23_mp = c3_mp * S2_mp - v12 * C2_mp, s23_mm = c3_mm * S2_mm - v13 * C2_mm,
        v25 = w1 * (v2 * (T23 * Y1 - T13 * t14)), X4_pp = c23_pp * v25 - T33 * s23_pp,
        X4_pm = c23_pm * v25 - T33 * s23_pm, v26 = c23_mp * v25 + T33 * s23_mp,
        v27 = c23_mm * v25 + T33 * s23_mm, v28 = w1 * (v2 * (T13 * Y1 + t14 * T23)),
        v29 = v28 * v28, v30 = v29 + factor2_p * (X4_pp * (factor2_p * X4_pp)),
        v31 = v29 + factor2_p * (X4_pm * (factor2_p * X4_pm)), v32 = factor2_m * v26,
        v33 = v29 + factor2_m * (v26 * v32), v34 = factor2_m * v27,
        v35 = v29 + factor2_m * (v27 * v34), angle6 = dhgen_atan2_wide(-v28, factor2_p * -X4_pp),
        angle7 = dhgen_atan2_wide(-v28, factor2_p * -X4_pm), angle8 = dhgen_atan2_wide(v28, v32),
        angle9 = dhgen_atan2_wide(v28, v34), v36 = dhgen_signed_wide(DHGEN_HALF_TURN, -v28),
        v37 = dhgen_signed_wide(DHGEN_HALF_TURN, v28);

    /* theta5 */
    const dhgen_wide angle10 = dhgen_atan2_wide(dhgen_sqrt_wide(v30), -(factor2_p * (T33 * c23_pp +
        s23_pp * v25))),
        angle11 = dhgen_atan2_wide(dhgen_sqrt_wide(v31), -(factor2_p * (T33 * c23_pm + s23_pm *
            v25))),
        angle12 = dhgen_atan2_wide(dhgen_sqrt_wide(v33), -(factor2_m * (T33 * c23_mp - s23_mp *
            v25))),
        angle13 = dhgen_atan2_wide(dhgen_sqrt_wide(v35), -(factor2_m * (T33 * c23_mm - s23_mm *
            v25)));

    /* theta6 */
    const dhgen_wide v38 = w1 * (v2 * (t14 * T22 + Y1 * T12)),
        v39 = w1 * (v2 * (Y1 * T22 - t14 * T12)), v40 = w1 * (v2 * (t14 * T21 + Y1 * T11)),
        v41 = w1 * (v2 * (Y1 * T21 - t14 * T11)),
        v42 = -X4_pp * v40 + v28 * (c23_pp * v41 - s23_pp * T31),
        v43 = -X4_pm * v40 + v28 * (c23_pm * v41 - s23_pm * T31),
        v44 = v28 * (c23_mp * v41 + s23_mp * T31) - v26 * v40,
        v45 = v28 * (c23_mm * v41 + s23_mm * T31) - v27 * v40,
        angle14 = dhgen_atan2_wide(v42, -X4_pp * v38 + v28 * (c23_pp * v39 - s23_pp * T32)),
        angle15 = dhgen_atan2_wide(v43, -X4_pm * v38 + v28 * (c23_pm * v39 - s23_pm * T32)),
        angle16 = dhgen_atan2_wide(v44, v28 * (c23_mp * v39 + s23_mp * T32) - v26 * v38),
        angle17 = dhgen_atan2_wide(v45, v28 * (c23_mm * v39 + s23_mm * T32) - v27 * v38);

    /* joint values */
    const dhgen_wide angle18 = dhgen_atan2_wide(S2_pp, C2_pp), v46 = angle18 - offset2,
        angle19 = dhgen_atan2_wide(S2_pm, C2_pm), v47 = angle19 - offset2,
        angle20 = dhgen_atan2_wide(S2_mp, C2_mp), v48 = angle20 - offset2,
        angle21 = dhgen_atan2_wide(S2_mm, C2_mm), v49 = angle21 - offset2,
        q2_ppp = dhgen_lowered_wide(v46), q2_pmp = dhgen_lowered_wide(v47),
        q2_mpp = dhgen_lowered_wide(v48), q2_mmp = dhgen_lowered_wide(v49),
        q1_ppp = angle1 + (w3_p - w3_p),
        q1_mpp = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, Y1) + (w3_m - w3_m);

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = angle2; q[3] = angle6; q[4] = angle10; q[5] = angle14;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = angle2; q[9] = angle6 - v36; q[10] = -angle10;
    q[11] = angle14 - dhgen_signed_wide(DHGEN_HALF_TURN, v42);
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = angle3; q[15] = angle7; q[16] = angle11;
    q[17] = angle15;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = angle3; q[21] = angle7 - v36; q[22] = -angle11;
    q[23] = angle15 - dhgen_signed_wide(DHGEN_HALF_TURN, v43);
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = angle4; q[27] = angle8; q[28] = angle12;
    q[29] = angle16;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = angle4; q[33] = angle8 - v37; q[34] = -angle12;
    q[35] = angle16 - dhgen_signed_wide(DHGEN_HALF_TURN, v44);
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = angle5; q[39] = angle9; q[40] = angle13;
    q[41] = angle17;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = angle5; q[45] = angle9 - v37; q[46] = -angle13;
    q[47] = angle17 - dhgen_signed_wide(DHGEN_HALF_TURN, v45);
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v35 <= m10) | (v33 <= m10) | (v31 <= m10) | (v30 <= m10) |
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
    const double t14 = T14 - d7 * T13, Y1 = d7 * T23 - T24, v1 = t14 * t14 + Y1 * Y1, w1 = sqrt(v1),
        v2 = DHGEN_QUOTIENT(1.0, v1), v3 = copysign(DHGEN_HALF_TURN, Y1);

    /* theta3 */
    const double Z1_3 = T34 - d7 * T33 - d1;
    const dhgen_four v4 = a1 + e1 * w1;
    const double v5 = Z1_3 * Z1_3;
    const dhgen_four N3 = v5 + v4 * v4, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared), v6 = m4 * e3, v7 = m6 * N3 - m5, v8 = v7 + w3 * v6,
        v9 = m6 * e3, v10 = m7 - m4 * N3, c3 = v10 + w3 * v9;

    /* theta2 */
    const dhgen_four X2_2 = m9 - m8 * N3, v11 = Z1_3 * X2_2, S2 = v11 + w3 * (m8 * (e3 * v4)),
        v12 = v4 * X2_2, v13 = m8 * (e3 * Z1_3), C2 = v12 - w3 * v13,
        factor2 = DHGEN_QUOTIENT(1.0, N3);

    /* theta4 */
    const dhgen_four c23 = c3 * C2 + v8 * S2, s23 = c3 * S2 - v8 * C2;
    const double v14 = w1 * (v2 * (T23 * Y1 - T13 * t14));
    const dhgen_four X4 = e1 * (c23 * v14) - T33 * s23;
    const double v15 = w1 * (v2 * (T13 * Y1 + t14 * T23)), v16 = v15 * v15;
    const dhgen_four v17 = v16 + factor2 * (X4 * (factor2 * X4)),
        v18 = dhgen_signed_four(DHGEN_HALF_TURN, -(e1 * v15));

    /* theta6 */
    const double v19 = w1 * (v2 * (t14 * T22 + Y1 * T12)), v20 = w1 * (v2 * (Y1 * T22 - t14 * T12)),
        v21 = w1 * (v2 * (t14 * T21 + Y1 * T11)), v22 = w1 * (v2 * (Y1 * T21 - t14 * T11));
    const dhgen_four v23 = e1 * (-X4 * v21 + v15 * (e1 * (c23 * v22) - s23 * T31));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) |
        (dhgen_abs_four(D3_squared) <= m3) | (v17 <= m10)) | (unsigned)(v1 <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(Y1, Y1, Y1, Y1),
        dhgen_four_of(-t14, -t14, -t14, -t14)), ratio2 = dhgen_ratio_four(S2, C2),
        ratio3 = dhgen_ratio_four(-v8, c3), ratio4 = dhgen_ratio_four(-(e1 * v15), factor2 * -X4),
        ratio5 = dhgen_ratio_four(v23, e1 * (-X4 * v19 + v15 * (e1 * (c23 * v20) - s23 * T32))),
        ratio6 = dhgen_ratio_four(dhgen_sqrt_four(v17), -(factor2 * (T33 * c23 + e1 * (s23 *
            v14))));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0), angle6 = dhgen_angle_four(ratio2),
        angle2 = dhgen_angle_four(ratio3), angle3 = dhgen_angle_four(ratio4),
        angle5 = dhgen_angle_four(ratio5), angle4 = dhgen_angle_four(ratio6);
    const dhgen_four q4_m = angle3 - v18, q6_m = angle5 - dhgen_signed_four(DHGEN_HALF_TURN, v23),
        v24 = angle6 - offset2, q2_p = dhgen_lowered_four(v24),
        q1_p = angle1 + v3 * (m2 * (e1 - 1.0)) + (w3 - w3);

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, q2_p, angle2, angle3);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, angle4, angle5);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, q2_p, angle2, q4_m);
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
DHGEN_TABLE int choosable[2] = { 3, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.2377, 0.2377, 0.2377, 1.0, 1.0, 1.0 }, 0.23769907297361542, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, kuka_kr210_fk,
    kuka_kr210_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) kuka_kr210_##function
#include "dhgen/functions.h"

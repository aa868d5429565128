/* kuka_youbot: KUKA youBot arm
 *
 * Inverse kinematics, generated from robots/kuka_youbot.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_youbot.yaml. The formulas and where they come from:
 * kuka_youbot.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: fc15dcffa9b84be9
 * SPDX-License-Identifier: MIT
 */
#include "kuka_youbot.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KUKA_YOUBOT_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KUKA_YOUBOT_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 5
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef KUKA_YOUBOT_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.147, /* joint offset 1 [m] */
    a1 = 0.033, /* link length 1 [m] */
    a2 = 0.155, /* link length 2 [m] */
    a3 = 0.135, /* link length 3 [m] */
    d5 = 0.2175, /* joint offset 5 [m] */
    second_weight = 0.6875, /* lengths count in arm sizes [m] */
    free_limit1 = 6.874999999999999e-13, /* a length that fixes no angle [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    longest3 = 0.08410000000000002, /* square of the longest reach [m^2] */
    shortest3 = 0.0003999999999999996, /* square of the shortest reach [m^2] */
    longest3_reach = 0.08410000000003988, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.00039999999999724956, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.08409999999999603, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.00040000000000027465, /* the shortest, where branches merge [m^2] */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 6.875e-06, /* a pose may be rounded by this [m] */
    offset4 = 1.5707963267948966, /* offset of joint 4 [rad] */
    k1 = 0.04225, /* a2^2 + a3^2 [m^2] */
    k2 = 23.894862604540023; /* 1 / (2 * a3 * a2) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const kuka_youbot_branches[4] = {
    "front-down", "front-up", "back-up", "back-down",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[5] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[5][4] = {
    { 0.0, 0.147, 0.033, 1.5707963267948966 },
    { 1.5707963267948966, 0.0, 0.155, 0.0 },
    { 0.0, 0.0, 0.135, 0.0 },
    { 1.5707963267948966, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.2175, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 5, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 7

DHGEN_PUBLIC void kuka_youbot_fk(const double q[5], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v2 * s3,
        x3_y = x2_y * c3 - v3 * s3, x3_z = s2 * c3 + c2 * s3, v4 = v2 * c3 + x2_x * s3,
        v5 = v3 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), x4_x = x3_x * c4 - v4 * s4, x4_y = x3_y * c4 - v5 * s4,
        x4_z = x3_z * c4 + y3_z * s4, z4_x = v4 * c4 + x3_x * s4, z4_y = v5 * c4 + x3_y * s4,
        z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]);
    T[0] = x4_x * c5 + s1 * s5; T[1] = s1 * c5 - x4_x * s5; T[2] = z4_x;
    T[3] = c1 * a1 + x2_x * a2 + x3_x * a3 + z4_x * d5;
    T[4] = x4_y * c5 - c1 * s5; T[5] = -(c1 * c5 + x4_y * s5); T[6] = z4_y;
    T[7] = s1 * a1 + x2_y * a2 + x3_y * a3 + z4_y * d5;
    T[8] = x4_z * c5; T[9] = -(x4_z * s5); T[10] = z4_z;
    T[11] = d1 + s2 * a2 + x3_z * a3 + z4_z * d5;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void kuka_youbot_jacobian(const double q[5], double J[30])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1,
        v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v2 * s3,
        x3_y = x2_y * c3 - v3 * s3, x3_z = s2 * c3 + c2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z + x3_z * a3, v4 = q[3] + offset4;
    const double c4 = cos(v4), s4 = sin(v4), z4_x = (v2 * c3 + x2_x * s3) * c4 + x3_x * s4,
        z4_y = (v3 * c3 + x2_y * s3) * c4 + x3_y * s4, z4_z = x3_z * s4 - (c2 * c3 - s2 * s3) * c4,
        p5_x = p3_x + z4_x * d5, p5_y = p3_y + z4_y * d5, p5_z = p3_z + z4_z * d5, v5 = p5_z - d1,
        v6 = p5_z - p2_z, v7 = p5_x - p3_x, v8 = p5_y - p3_y, v9 = p5_z - p3_z;
    J[0] = -p5_y; J[1] = -(c1 * v5); J[2] = -(c1 * v6); J[3] = -(c1 * v9);
    J[4] = z4_y * v9 - z4_z * v8;
    J[5] = p5_x; J[6] = -(s1 * v5); J[7] = -(s1 * v6); J[8] = -(s1 * v9);
    J[9] = z4_z * v7 - z4_x * v9;
    J[10] = 0.0; J[11] = s1 * (p5_y - p1_y) + c1 * (p5_x - p1_x);
    J[12] = s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x); J[13] = s1 * v8 + c1 * v7;
    J[14] = z4_x * v8 - z4_y * v7;
    J[15] = 0.0; J[16] = s1; J[17] = s1; J[18] = s1; J[19] = z4_x;
    J[20] = 0.0; J[21] = -c1; J[22] = -c1; J[23] = -c1; J[24] = z4_y;
    J[25] = 1.0; J[26] = 0.0; J[27] = 0.0; J[28] = 0.0; J[29] = z4_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[5] = (double (*)[5])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[3, 4], so theta1 = atan2(T24, T14) or half a turn from it. Where both are
     * small, U1[3, 3] says more: its vector, along the same line, is added */
    const double sigma1 = copysign(second_weight, T14 * T13 + T24 * T23);
    const double Xhat1 = T14 + T13 * sigma1;
    const double Yhat1 = T24 + T23 * sigma1;
    const double w1 = sqrt(Xhat1 * Xhat1 + Yhat1 * Yhat1);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta234, type 3: U1[2, 3] and U1[1, 3] */
    const double v1 = T33 * T33;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v7 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* front, back */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : Xhat1 * factor1,
            s1 = free1 ? sin(seed[0]) : Yhat1 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta234 */
        const double Z2_234 = T13 * c1 + T23 * s1;
        const double w234 = sqrt(Z2_234 * Z2_234 + v1);
        const int short234 = w234 <= free_limit;
        const double factor234 = 1.0 / (short234 ? 1.0 : w234);
        const double v2 = T33 * factor234;
        const double s234 = Z2_234 * factor234;
        const double theta234 = atan2(s234, -v2);

        /* theta5, type 3: U1[3, 2] and U1[3, 1] */
        const double S5 = T21 * c1 - T11 * s1;
        const double C5 = T22 * c1 - T12 * s1;
        const double w5 = sqrt(S5 * S5 + C5 * C5);
        const int short5 = w5 <= free_limit;
        const double v3 = 1.0 / (short5 ? 1.0 : w5), v4 = C5 * v3, v5 = S5 * v3;
        const double q5 = atan2(-v5, -v4);

        /* theta3 */
        const double v6 = v2 * d5;
        const double Z1_3 = v7 - v6;
        const double v8 = s234 * d5;
        const double Z2_3 = T14 * c1 + T24 * s1 - a1 - v8;
        const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
        const double K3 = N3 - k1;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) {
            if (free1) dhgen_lose(DHGEN_LOST + 1, D3_squared, q[2 * i1], &status[2 * i1]);
            continue; /* out of reach */
        }
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double c3 = K3 * k2;

        /* theta2, type 3: U1[2, 4] and U1[1, 4] */
        const double X1_2 = a2 + a3 * c3;
        const double v9 = Z1_3 * X1_2, v10 = Z2_3 * X1_2;

        /* is the pose one that the arm can take? */
        const double v11 = a1 + v8, v13 = d1 + v6;
        if (!(fabs(T33 - v2) <= pose_slack && fabs(T31 + s234 * v4) <= pose_slack && fabs(T23 - s1 *
            s234) <= pose_slack && fabs(T21 - (v4 * (s1 * v2) + c1 * v5)) <= pose_slack && fabs(T11
            - (v4 * (c1 * v2) - s1 * v5)) <= pose_slack && fabs(T13 - c1 * s234) <= pose_slack))
            continue; /* the arm can't take this pose */

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e3 * k2;
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double Y1_2 = a3 * s3;
            const double S2 = v9 - Z2_3 * Y1_2;
            const double C2 = v10 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const double factor2 = 1.0 / w2;
            const double c2 = C2 * factor2, s2 = S2 * factor2;
            const double theta2 = atan2(s2, c2);

            /* is the pose one that the arm can take? */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2,
                v12 = a3 * c23 + (a2 * c2 + v11);
            if (!(fabs(T34 - (a3 * s23 + (a2 * s2 + v13))) <= pose_slack1 && fabs(T14 - c1 * v12) <=
                pose_slack1 && fabs(T24 - s1 * v12) <= pose_slack1))
                continue; /* the arm can't take this pose */

            /* joint values */
            const double q2 = dhgen_wrap(theta2 - offset2);
            const double q4 = dhgen_wrap(theta234 - (q3 + theta2) - offset4);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            status[row] = free1 ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef KUKA_YOUBOT_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 6.874999999999999e-05 [m],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 4.726562499999999e-09, /* doubt_limit1^2 [m^2] */
    m3 = 9.999999999999999e-09, /* doubt_limit^2 */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m4 = 3.345324017800363e-13,
    m5 = 3.2258064516129035, /* a3 * k2 [m^-1] */
    m6 = 0.018709677419354823, /* a2 - a3 * k1 * k2 [m] */
    m7 = 3.7037037037037037, /* a2 * k2 [m^-1] */
    /* k2 * (a2 * k1 + a3 * longest3 * shortest3 * k2 - a3 * k1^2 * k2) [m] */
    m8 = 0.021481481481481466,
    m9 = 1.0000000000000002e-10, /* pose_slack^2 */
    m10 = 4.7265625e-11, /* pose_slack1^2 [m^2] */
    m11 = 1.41796875e-10; /* 3 * pose_slack1^2 [m^2] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide sigma1 = dhgen_signed_wide(second_weight, T14 * T13 + T24 * T23),
        Xhat1 = T14 + T13 * sigma1, Yhat1 = T24 + T23 * sigma1, v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1,
        w1 = dhgen_sqrt_wide(v1), v2 = DHGEN_QUOTIENT(1.0, v1), factor1 = w1 * v2,
        c1 = Xhat1 * factor1, s1 = Yhat1 * factor1, angle1 = dhgen_atan2_wide(Yhat1, Xhat1);

    /* theta234 */
    const dhgen_wide Z2_234 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1)),
        v3 = T33 * T33 + Z2_234 * Z2_234, w234 = dhgen_sqrt_wide(v3), v4 = DHGEN_QUOTIENT(1.0, v3),
        factor234 = w234 * v4, angle2 = dhgen_atan2_wide(Z2_234, -T33);

    /* theta5 */
    const dhgen_wide S5 = w1 * (v2 * (Xhat1 * T21 - Yhat1 * T11)),
        C5 = w1 * (v2 * (Xhat1 * T22 - Yhat1 * T12)), v5 = S5 * S5 + C5 * C5,
        v6 = dhgen_sqrt_wide(v5) * DHGEN_QUOTIENT(1.0, v5), v7 = C5 * v6, v8 = S5 * v6,
        angle3 = dhgen_atan2_wide(-S5, -C5);

    /* theta3 */
    const dhgen_wide v9 = factor234 * (d5 * T33), Z1_3 = T34 - d1 - v9, v10 = d5 * Z2_234,
        v11 = T14 * c1 + T24 * s1, v12 = v11 - a1, v13 = a1 + v11, v14 = factor234 * v10,
        v15 = v12 - v14, v16 = v14 - v13, v17 = w234 * (v4 * v10), Z2_3_p = v12 - v17,
        Z2_3_m = v17 - v13, v18 = Z1_3 * Z1_3, N3_p = v18 + Z2_3_p * Z2_3_p,
        N3_m = v18 + Z2_3_m * Z2_3_m, D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m), v19 = w3_p - w3_p, v20 = w3_m - w3_m,
        angle4 = dhgen_atan2_wide(w3_p, N3_p - k1), angle5 = dhgen_atan2_wide(w3_m, N3_m - k1);

    /* theta2 */
    const dhgen_wide v21 = m6 + m5 * N3_p, v22 = m6 + m5 * N3_m, v23 = Z1_3 * v21, v24 = Z1_3 * v22,
        S2_pp = v23 - w3_p * (m5 * v15), S2_pm = v23 - w3_p * (m5 * -v15),
        S2_mp = v24 - w3_m * (m5 * v16), S2_mm = v24 - w3_m * (m5 * -v16), v25 = m5 * Z1_3,
        v26 = m5 * -Z1_3, v27 = v15 * v21, v28 = v16 * v22, C2_pp = v27 + w3_p * v25,
        C2_pm = v27 + w3_p * v26, C2_mp = v28 + w3_m * v25, C2_mm = v28 + w3_m * v26,
        v29 = S2_pp * S2_pp + C2_pp * C2_pp, v30 = S2_pm * S2_pm + C2_pm * C2_pm,
        v31 = S2_mp * S2_mp + C2_mp * C2_mp, v32 = S2_mm * S2_mm + C2_mm * C2_mm,
        w2_pp = dhgen_sqrt_wide(v29), w2_pm = dhgen_sqrt_wide(v30), w2_mp = dhgen_sqrt_wide(v31),
        w2_mm = dhgen_sqrt_wide(v32), v33 = DHGEN_QUOTIENT(1.0, v29),
        v34 = DHGEN_QUOTIENT(1.0, v30), v35 = DHGEN_QUOTIENT(1.0, v31),
        v36 = DHGEN_QUOTIENT(1.0, v32), factor2_pp = w2_pp * v33, factor2_pm = w2_pm * v34,
        factor2_mp = w2_mp * v35, factor2_mm = w2_mm * v36, angle6 = dhgen_atan2_wide(S2_pp, C2_pp),
        angle7 = dhgen_atan2_wide(S2_pm, C2_pm), angle8 = dhgen_atan2_wide(S2_mp, C2_mp),
        angle9 = dhgen_atan2_wide(S2_mm, C2_mm);

    /* is the pose one that the arm can take? */
    const dhgen_wide v37 = m7 * Z1_3, v38 = m7 * -Z1_3, v39 = m7 * N3_p - m8, v40 = m7 * N3_m - m8,
        v41 = v15 * v39, v42 = v16 * v40, v43 = Z1_3 * v39, v44 = Z1_3 * v40, v45 = a1 + v14,
        v46 = a1 - v14, v47 = v45 + w2_pp * (v33 * (a3 * (v41 - w3_p * v37) + a2 * C2_pp)),
        v48 = v45 + w2_pm * (v34 * (a3 * (v41 - w3_p * v38) + a2 * C2_pm)),
        v49 = v46 + w2_mp * (v35 * (a3 * (v42 - w3_m * v37) + a2 * C2_mp)),
        v50 = v46 + w2_mm * (v36 * (a3 * (v42 - w3_m * v38) + a2 * C2_mm)), v51 = d1 + v9,
        v52 = T33 - T33 * factor234, v53 = T31 + factor234 * (Z2_234 * v7),
        v54 = T23 - factor234 * (s1 * Z2_234),
        v55 = T21 - (c1 * v8 + factor234 * (v7 * (s1 * T33))),
        v56 = T11 - (factor234 * (v7 * (c1 * T33)) - s1 * v8),
        v57 = T13 - factor234 * (c1 * Z2_234),
        v58 = T34 - (v51 + factor2_pp * (a2 * S2_pp) + factor2_pp * (a3 * (v43 + w3_p * (m7 *
            v15)))),
        v59 = T34 - (v51 + factor2_pm * (a2 * S2_pm) + factor2_pm * (a3 * (v43 + w3_p * (m7 *
            -v15)))),
        v60 = T34 - (v51 + factor2_mp * (a2 * S2_mp) + factor2_mp * (a3 * (v44 + w3_m * (m7 *
            v16)))),
        v61 = T34 - (v51 + factor2_mm * (a2 * S2_mm) + factor2_mm * (a3 * (v44 + w3_m * (m7 *
            -v16)))), v62 = T14 - c1 * v47, v63 = T14 - c1 * v48, v64 = T14 + c1 * v49,
        v65 = T14 + c1 * v50, v66 = T24 - s1 * v47, v67 = T24 - s1 * v48, v68 = T24 + s1 * v49,
        v69 = T24 + s1 * v50, v70 = v58 * v58 + v62 * v62 + v66 * v66,
        v71 = v59 * v59 + v63 * v63 + v67 * v67, v72 = v60 * v60 + v64 * v64 + v68 * v68,
        v73 = v61 * v61 + v65 * v65 + v69 * v69;

    /* joint values */
    const dhgen_wide v74 = angle6 - offset2, v75 = angle7 - offset2, v76 = angle8 - offset2,
        v77 = angle9 - offset2, v78 = angle2 - (angle4 + angle6) - offset4,
        v79 = angle2 - (angle7 - angle4) - offset4, v80 = offset4 + (angle2 + (angle5 + angle8)),
        v81 = offset4 + (angle2 + (angle9 - angle5)), v82 = dhgen_centred_wide(v78),
        v83 = dhgen_centred_wide(v79),
        v84 = dhgen_pick_wide(-v80 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
            dhgen_only_wide(DHGEN_HALF_TURN < -v80, -DHGEN_TURN)) - v80,
        v85 = dhgen_pick_wide(-v81 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
            dhgen_only_wide(DHGEN_HALF_TURN < -v81, -DHGEN_TURN)) - v81;
    const double v86 = DHGEN_NAN;
    const dhgen_wide v87 = dhgen_only_wide((v70 <= m10) == 0, v86),
        v88 = dhgen_only_wide((v71 <= m10) == 0, v86),
        v89 = dhgen_only_wide((v72 <= m10) == 0, v86),
        v90 = dhgen_only_wide((v73 <= m10) == 0, v86), v91 = angle1 + v19,
        v92 = v20 + (angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, Yhat1)), v93 = angle3 + v19,
        v94 = v20 + (angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, -S5));

    q[0] = v87 + v91; q[1] = v87 + dhgen_raised_wide(v74); q[2] = angle4 + v87;
    q[3] = v87 + dhgen_raised_wide(v82); q[4] = v87 + v93;
    kind[0] = dhgen_kind_wide(q[0]);
    q[5] = v88 + v91; q[6] = v88 + dhgen_raised_wide(v75); q[7] = v88 - angle4;
    q[8] = v88 + dhgen_raised_wide(v83); q[9] = v88 + v93;
    kind[1] = dhgen_kind_wide(q[5]);
    q[10] = v89 + v92; q[11] = v89 + dhgen_raised_wide(v76); q[12] = angle5 + v89;
    q[13] = v89 + dhgen_raised_wide(v84); q[14] = v89 + v94;
    kind[2] = dhgen_kind_wide(q[10]);
    q[15] = v90 + v92; q[16] = v90 + dhgen_raised_wide(v77); q[17] = v90 - angle5;
    q[18] = v90 + dhgen_raised_wide(v85); q[19] = v90 + v94;
    kind[3] = dhgen_kind_wide(q[15]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v3 <= m3) | (v1 <= m1) | (v5 <= m3) | (m9 < v52 * v52 + v53 * v53 + v54
        * v54 + v55 * v55 + v56 * v56 + v57 * v57) | ((m10 < v73) & (v73 <= m11)) | ((m10 < v72) &
        (v72 <= m11)) | ((m10 < v71) & (v71 <= m11)) | ((m10 < v70) & (v70 <= m11)) |
        (dhgen_abs_wide(D3_squared_p) <= m4) | (dhgen_abs_wide(D3_squared_m) <= m4));
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
    const double sigma1 = copysign(second_weight, T14 * T13 + T24 * T23),
        Xhat1 = T14 + T13 * sigma1, Yhat1 = T24 + T23 * sigma1, v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1,
        w1 = sqrt(v1), v2 = DHGEN_QUOTIENT(1.0, v1), factor1 = w1 * v2, c1 = Xhat1 * factor1,
        s1 = Yhat1 * factor1, v3 = copysign(DHGEN_HALF_TURN, Yhat1);
    const dhgen_four v4 = m2 * (e1 - 1.0);

    /* theta234 */
    const double Z2_234 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1)), v5 = T33 * T33 + Z2_234 * Z2_234,
        w234 = sqrt(v5), v6 = DHGEN_QUOTIENT(1.0, v5), factor234 = w234 * v6;

    /* theta5 */
    const double S5 = w1 * (v2 * (Xhat1 * T21 - Yhat1 * T11)),
        C5 = w1 * (v2 * (Xhat1 * T22 - Yhat1 * T12)), v7 = S5 * S5 + C5 * C5,
        v8 = sqrt(v7) * DHGEN_QUOTIENT(1.0, v7), v9 = C5 * v8, v10 = S5 * v8,
        v11 = copysign(DHGEN_HALF_TURN, -S5);

    /* theta3 */
    const double v12 = factor234 * (d5 * T33), Z1_3 = T34 - d1 - v12, v13 = d5 * Z2_234,
        v14 = T14 * c1 + T24 * s1;
    const dhgen_four v15 = e1 * v14 - a1;
    const double v16 = factor234 * v13;
    const dhgen_four v17 = e1 * v16, v18 = v15 - v17, Z2_3 = v15 - w234 * (v6 * (e1 * v13));
    const double v19 = Z1_3 * Z1_3;
    const dhgen_four N3 = v19 + Z2_3 * Z2_3, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared), v20 = w3 - w3;

    /* theta2 */
    const dhgen_four v21 = e3 * v18, v22 = m6 + m5 * N3, v23 = Z1_3 * v22,
        S2 = v23 - w3 * (m5 * v21), v24 = e3 * Z1_3, v25 = m5 * v24, v26 = v18 * v22,
        C2 = v26 + w3 * v25, v27 = S2 * S2 + C2 * C2, w2 = dhgen_sqrt_four(v27),
        v28 = DHGEN_QUOTIENT(1.0, v27), factor2 = w2 * v28;

    /* is the pose one that the arm can take? */
    const dhgen_four v29 = m7 * v24, v30 = m7 * N3 - m8, v31 = v18 * v30, v32 = Z1_3 * v30,
        v33 = a1 + v17, v34 = v33 + w2 * (v28 * (a3 * (v31 - w3 * v29) + a2 * C2));
    const double v35 = d1 + v12, v36 = T33 - T33 * factor234, v37 = T31 + factor234 * (Z2_234 * v9),
        v38 = T23 - factor234 * (s1 * Z2_234),
        v39 = T21 - (c1 * v10 + factor234 * (v9 * (s1 * T33))),
        v40 = T11 - (factor234 * (v9 * (c1 * T33)) - s1 * v10),
        v41 = T13 - factor234 * (c1 * Z2_234);
    const dhgen_four v42 = T34 - (v35 + factor2 * (a2 * S2) + factor2 * (a3 * (v32 + w3 * (m7 *
        v21)))), v43 = T14 - e1 * (c1 * v34), v44 = T24 - e1 * (s1 * v34),
        v45 = v42 * v42 + v43 * v43 + v44 * v44;

    /* joint values */
    const double v51 = DHGEN_NAN;
    const dhgen_four v52 = dhgen_only_four((v45 <= m10) == 0, v51);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) |
        (dhgen_abs_four(D3_squared) <= m4) | ((m10 < v45) & (v45 <= m11))) | (unsigned)((v5 <= m3) |
        (v1 <= m1) | (m9 < v36 * v36 + v37 * v37 + v38 * v38 + v39 * v39 + v40 * v40 + v41 * v41) |
        (v7 <= m3)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-S5, -S5, -S5, -S5),
        dhgen_four_of(-C5, -C5, -C5, -C5)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(dhgen_shuffle(w3, dhgen_all_four(Yhat1), 0, 5, 2,
            3), dhgen_all_four(Z2_234), 0, 1, 2, 7), dhgen_shuffle(dhgen_shuffle(N3 - k1,
            dhgen_all_four(Xhat1), 0, 5, 2, 3), dhgen_all_four(-T33), 0, 1, 2, 7)),
        ratio3 = dhgen_ratio_four(S2, C2);
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle3 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0), packed2 = dhgen_angle_four(ratio2),
        angle4 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed2, packed2, 1, 1, 1, 1),
        angle2 = dhgen_shuffle(packed2, packed2, 3, 3, 3, 3), angle5 = dhgen_angle_four(ratio3);
    const dhgen_four v46 = angle5 - offset2, v47 = e3 * angle4, v48 = e1 * angle2,
        v49 = v48 - (angle5 + v47) - offset4, v50 = dhgen_centred_four(v49),
        v53 = v20 + (angle1 + v3 * v4), q1 = v52 + v53, q2 = v52 + dhgen_raised_four(v46),
        q3 = v47 + v52, q4 = v52 + dhgen_raised_four(v50), v54 = v20 + (angle3 + v4 * v11),
        q5 = v52 + v54;

    dhgen_store_4(q, q + 5, q + 10, q + 15, q1, q2, q3, q4);
    dhgen_store_1(q + 4, q + 9, q + 14, q + 19, q5);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[1] = { 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    5, 4, 0, DHGEN_POSE, joints, NULL, 0,
    { 1.455, 1.455, 1.455, 1.0, 1.0, 1.0 }, 1.4545454545454546, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 1, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, kuka_youbot_fk,
    kuka_youbot_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) kuka_youbot_##function
#include "dhgen/functions.h"

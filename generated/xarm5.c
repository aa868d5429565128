/* xarm5: UFACTORY xArm 5
 *
 * Inverse kinematics, generated from robots/xarm5.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/xarm5.yaml. The formulas and where they come from: xarm5.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: b7257d98eb95d607
 * SPDX-License-Identifier: MIT
 */
#include "xarm5.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(XARM5_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(XARM5_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 5
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef XARM5_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.267, /* joint offset 1 [m] */
    a2 = 0.2894866145437471, /* link length 2 [m] */
    a3 = 0.35116, /* link length 3 [m] */
    a4 = 0.076, /* link length 4 [m] */
    d5 = 0.097, /* joint offset 5 [m] */
    second_weight = 1.080646614543747, /* lengths count in arm sizes [m] */
    free_limit1 = 1.080646614543747e-12, /* a length that fixes no angle [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    longest3 = 0.4104280847263644, /* square of the longest reach [m^2] */
    shortest3 = 0.003803606473635553, /* square of the shortest reach [m^2] */
    longest3_reach = 0.41042808472650283, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.003803606473622223, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.4104280847263506, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.0038036064736368855, /* the shortest, where branches merge [m^2] */
    offset2 = 1.7566747807196037, /* offset of joint 2 [rad] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 1.080646614543747e-05, /* a pose may be rounded by this [m] */
    offset3 = 2.733184269115749, /* offset of joint 3 [rad] */
    offset4 = -1.3482663962455592, /* offset of joint 4 [rad] */
    k1 = 0.20711584560000001, /* a2^2 + a3^2 [m^2] */
    k2 = 4.918543046385274; /* 1 / (2 * a3 * a2) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const xarm5_branches[4] = {
    "back-down", "back-up", "front-up", "front-down",
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
    { 3.141592653589793, 0.267, 0.0, 1.5707963267948966 },
    { 1.7566747807196037, 0.0, 0.2894866145437471, 0.0 },
    { 2.733184269115749, 0.0, 0.35116, 0.0 },
    { -1.3482663962455592, 0.0, 0.076, -1.5707963267948966 },
    { 0.0, 0.097, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 5, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 7

DHGEN_PUBLIC void xarm5_fk(const double q[5], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2, v5 = q[2] + offset3;
    const double c3 = cos(v5), s3 = sin(v5), x3_x = x2_x * c3 - v3 * s3, x3_y = x2_y * c3 - v4 * s3,
        x3_z = s2 * c3 + c2 * s3, v6 = v3 * c3 + x2_x * s3, v7 = v4 * c3 + x2_y * s3,
        y3_z = c2 * c3 - s2 * s3, v8 = q[3] + offset4;
    const double c4 = cos(v8), s4 = sin(v8), x4_x = x3_x * c4 - v6 * s4, x4_y = x3_y * c4 - v7 * s4,
        x4_z = x3_z * c4 + y3_z * s4, v9 = v6 * c4 + x3_x * s4, v10 = v7 * c4 + x3_y * s4,
        z4_z = y3_z * c4 - x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]);
    T[0] = x4_x * c5 - s1 * s5; T[1] = -(s1 * c5 + x4_x * s5); T[2] = -v9;
    T[3] = x2_x * a2 + x3_x * a3 + x4_x * a4 - v9 * d5;
    T[4] = x4_y * c5 + c1 * s5; T[5] = c1 * c5 - x4_y * s5; T[6] = -v10;
    T[7] = x2_y * a2 + x3_y * a3 + x4_y * a4 - v10 * d5;
    T[8] = x4_z * c5; T[9] = -(x4_z * s5); T[10] = z4_z;
    T[11] = d1 + s2 * a2 + x3_z * a3 + x4_z * a4 + z4_z * d5;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void xarm5_jacobian(const double q[5], double J[30])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2, v5 = q[2] + offset3;
    const double c3 = cos(v5), s3 = sin(v5), x3_x = x2_x * c3 - v3 * s3, x3_y = x2_y * c3 - v4 * s3,
        x3_z = s2 * c3 + c2 * s3, v6 = v3 * c3 + x2_x * s3, v7 = v4 * c3 + x2_y * s3,
        y3_z = c2 * c3 - s2 * s3, p3_x = p2_x + x3_x * a3, p3_y = p2_y + x3_y * a3,
        p3_z = p2_z + x3_z * a3, v8 = q[3] + offset4;
    const double c4 = cos(v8), s4 = sin(v8), v9 = v6 * c4 + x3_x * s4, v10 = v7 * c4 + x3_y * s4,
        z4_z = y3_z * c4 - x3_z * s4, p4_x = p3_x + (x3_x * c4 - v6 * s4) * a4,
        p4_y = p3_y + (x3_y * c4 - v7 * s4) * a4, p4_z = p3_z + (x3_z * c4 + y3_z * s4) * a4,
        p5_x = p4_x - v9 * d5, p5_y = p4_y - v10 * d5, p5_z = p4_z + z4_z * d5, v11 = p5_z - d1,
        v12 = p5_z - p2_z, v13 = p5_z - p3_z, v14 = p5_x - p4_x, v15 = p5_y - p4_y,
        v16 = p5_z - p4_z;
    J[0] = -p5_y; J[1] = -(c1 * v11); J[2] = -(c1 * v12); J[3] = -(c1 * v13);
    J[4] = -(v10 * v16 + z4_z * v15);
    J[5] = p5_x; J[6] = -(s1 * v11); J[7] = -(s1 * v12); J[8] = -(s1 * v13);
    J[9] = z4_z * v14 + v9 * v16;
    J[10] = 0.0; J[11] = s1 * p5_y + c1 * p5_x; J[12] = s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x);
    J[13] = s1 * (p5_y - p3_y) + c1 * (p5_x - p3_x); J[14] = v10 * v14 - v9 * v15;
    J[15] = 0.0; J[16] = s1; J[17] = s1; J[18] = s1; J[19] = -v9;
    J[20] = 0.0; J[21] = -c1; J[22] = -c1; J[23] = -c1; J[24] = -v10;
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
    const double v1 = seed[0] + offset1;

    /* theta234, type 3: U1[2, 3] and U1[1, 3] */
    const double v2 = T33 * T33;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v8 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(v1) : Xhat1 * factor1, s1 = free1 ? sin(v1) : Yhat1 * factor1;

        /* theta234 */
        const double Z2_234 = T13 * c1 + T23 * s1;
        const double w234 = sqrt(Z2_234 * Z2_234 + v2);
        const int short234 = w234 <= free_limit;
        const double factor234 = 1.0 / (short234 ? 1.0 : w234);
        const double c234 = T33 * factor234, v3 = Z2_234 * factor234;
        const double theta234 = atan2(-v3, c234);

        /* theta5, type 3: U1[3, 2] and U1[3, 1] */
        const double Z1_5 = T12 * s1 - T22 * c1;
        const double Z2_5 = T11 * s1 - T21 * c1;
        const double w5 = sqrt(Z2_5 * Z2_5 + Z1_5 * Z1_5);
        const int short5 = w5 <= free_limit;
        const double v4 = 1.0 / (short5 ? 1.0 : w5), v5 = Z1_5 * v4, v6 = Z2_5 * v4;
        const double q5 = atan2(-v6, -v5);

        /* theta3 */
        const double v7 = v3 * a4 - c234 * d5;
        const double Z1_3 = v7 + v8;
        const double v9 = c234 * a4 + v3 * d5;
        const double Z2_3 = T14 * c1 + T24 * s1 - v9;
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
        const double v10 = Z1_3 * X1_2, v11 = Z2_3 * X1_2;

        /* is the pose one that the arm can take? */
        const double v13 = d1 + -v7;
        if (!(fabs(T33 - c234) <= pose_slack && fabs(T31 - v3 * v5) <= pose_slack && fabs(T23 - s1 *
            v3) <= pose_slack && fabs(T21 + (v5 * (s1 * c234) + c1 * v6)) <= pose_slack && fabs(T11
            - (s1 * v6 - v5 * (c1 * c234))) <= pose_slack && fabs(T13 - c1 * v3) <= pose_slack))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q1 = dhgen_wrap(atan2(s1, c1) - offset1);

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e3 * k2;
            const double theta3 = atan2(s3, c3);

            /* theta2 */
            const double Y1_2 = a3 * s3;
            const double S2 = v10 - Z2_3 * Y1_2;
            const double C2 = v11 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const double factor2 = 1.0 / w2;
            const double c2 = C2 * factor2, s2 = S2 * factor2;
            const double theta2 = atan2(s2, c2);

            /* is the pose one that the arm can take? */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2,
                v12 = a3 * c23 + (v9 + a2 * c2);
            if (!(fabs(T34 - (a3 * s23 + (a2 * s2 + v13))) <= pose_slack1 && fabs(T14 - c1 * v12) <=
                pose_slack1 && fabs(T24 - s1 * v12) <= pose_slack1))
                continue; /* the arm can't take this pose */

            /* joint values */
            const double q2 = dhgen_wrap(theta2 - offset2);
            const double q3 = dhgen_wrap(theta3 - offset3);
            const double q4 = dhgen_wrap(theta234 - (theta3 + theta2) - offset4);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            status[row] = free1 ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef XARM5_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.00010806466145437469 [m],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 1.1677971055248613e-08, /* doubt_limit1^2 [m^2] */
    m2 = 9.999999999999999e-09, /* doubt_limit^2 */
    m4 = 0.076, /* a4 [m] */
    m5 = 0.097, /* d5 [m] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m6 = 5.597903840841209e-12,
    m7 = 1.727195576168653, /* a3 * k2 [m^-1] */
    m8 = 0.06824295773100271, /* a3 * k1 * k2 - a2 [m] */
    m9 = 1.4238523749857612, /* a2 * k2 [m^-1] */
    /* k2 * (a3 * k1^2 * k2 - a2 * k1 - a3 * longest3 * shortest3 * k2) [m] */
    m10 = 0.05625761134525573,
    m11 = 1.0000000000000002e-10, /* pose_slack^2 */
    m12 = 1.167797105524862e-10, /* pose_slack1^2 [m^2] */
    m13 = 3.5033913165745856e-10; /* 3 * pose_slack1^2 [m^2] */

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
        c1 = Xhat1 * factor1, s1 = Yhat1 * factor1;

    /* theta234 */
    const dhgen_wide v3 = v2 * (T13 * Xhat1 + T23 * Yhat1), Z2_234 = w1 * v3,
        v4 = T33 * T33 + Z2_234 * Z2_234, factor234 = dhgen_sqrt_wide(v4) * DHGEN_QUOTIENT(1.0, v4),
        angle1 = dhgen_atan2_wide(-Z2_234, T33);

    /* theta5 */
    const dhgen_wide Z1_5 = w1 * (v2 * (Yhat1 * T12 - Xhat1 * T22)),
        Z2_5 = w1 * (v2 * (Yhat1 * T11 - Xhat1 * T21)), v5 = Z2_5 * Z2_5 + Z1_5 * Z1_5,
        v6 = dhgen_sqrt_wide(v5) * DHGEN_QUOTIENT(1.0, v5), v7 = Z1_5 * v6, v8 = Z2_5 * v6,
        angle2 = dhgen_atan2_wide(-Z2_5, -Z1_5);

    /* theta3 */
    const dhgen_wide v9 = d5 * T33, v10 = w1 * (m4 * v3), v11 = v10 - v9, v12 = T34 - d1,
        Z1_3_p = v12 + factor234 * v11, v13 = factor234 * (v9 + v10), Z1_3_m = v12 - v13,
        v14 = a4 * T33, v15 = T14 * c1 + T24 * s1, v16 = w1 * (m5 * v3),
        v17 = factor234 * (v14 + v16), v18 = factor234 * (v14 - v16), Z2_3_p = v15 - v17,
        v19 = v15 + v18, N3_p = Z1_3_p * Z1_3_p + Z2_3_p * Z2_3_p,
        N3_m = Z1_3_m * Z1_3_m + v19 * v19, D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m), v20 = w3_p - w3_p, v21 = w3_m - w3_m,
        angle3 = dhgen_atan2_wide(w3_p, N3_p - k1), angle4 = dhgen_atan2_wide(w3_m, N3_m - k1);

    /* theta2 */
    const dhgen_wide v22 = m7 * N3_p - m8, v23 = m7 * N3_m - m8, v24 = Z1_3_p * v22,
        v25 = Z1_3_m * v23, S2_pp = v24 - w3_p * (m7 * Z2_3_p), S2_pm = v24 - w3_p * (m7 * -Z2_3_p),
        v26 = w3_m * (m7 * v19), S2_mp = v25 + v26, S2_mm = v25 - v26, v27 = Z2_3_p * v22,
        v28 = v19 * v23, factor2_p = DHGEN_QUOTIENT(1.0, N3_p),
        factor2_m = DHGEN_QUOTIENT(1.0, N3_m), v29 = w3_p * (m7 * Z1_3_p),
        angle5 = dhgen_atan2_wide(S2_pp, v27 + v29), angle6 = dhgen_atan2_wide(S2_pm, v27 - v29),
        angle7 = dhgen_atan2_wide(S2_mp, w3_m * (m7 * Z1_3_m) - v28),
        angle8 = dhgen_atan2_wide(S2_mm, w3_m * (m7 * -Z1_3_m) - v28);

    /* is the pose one that the arm can take? */
    const dhgen_wide v30 = Z1_3_p * (m9 + m10 * factor2_p), v31 = Z1_3_m * (m9 + m10 * factor2_m),
        v32 = v17 + Z2_3_p, v33 = v18 - v19, v34 = d1 + factor234 * -v11, v35 = d1 + v13,
        v36 = T33 - T33 * factor234, v37 = T31 - factor234 * (Z2_234 * v7),
        v38 = T23 - factor234 * (s1 * Z2_234),
        v39 = T21 + (c1 * v8 + factor234 * (v7 * (s1 * T33))),
        v40 = T11 - (s1 * v8 - factor234 * (v7 * (c1 * T33))),
        v41 = T13 - factor234 * (c1 * Z2_234),
        v42 = T34 - (a3 * (v30 + w3_p * (m9 * (Z2_3_p * factor2_p))) + (v34 + a2 * (S2_pp *
            factor2_p))),
        v43 = T34 - (a3 * (v30 + w3_p * (m9 * (-Z2_3_p * factor2_p))) + (v34 + a2 * (S2_pm *
            factor2_p))), v44 = w3_m * (m9 * (v19 * factor2_m)),
        v45 = T34 - (a3 * (v31 - v44) + (v35 + a2 * (S2_mp * factor2_m))),
        v46 = T34 - (a3 * (v31 + v44) + (v35 + a2 * (S2_mm * factor2_m))), v47 = T14 - c1 * v32,
        v48 = T14 + c1 * v33, v49 = T24 - s1 * v32, v50 = T24 + s1 * v33, v51 = v47 * v47,
        v52 = v48 * v48, v53 = v49 * v49, v54 = v50 * v50, v55 = v53 + (v51 + v42 * v42),
        v56 = v53 + (v51 + v43 * v43), v57 = v54 + (v52 + v45 * v45), v58 = v54 + (v52 + v46 * v46);

    /* joint values */
    const dhgen_wide angle9 = dhgen_atan2_wide(Yhat1, Xhat1), v59 = angle9 - offset1,
        v60 = angle9 - dhgen_signed_wide(DHGEN_HALF_TURN, Yhat1) - offset1, v61 = angle5 - offset2,
        v62 = angle6 - offset2, v63 = angle7 - offset2, v64 = angle8 - offset2,
        v65 = angle3 - offset3, v66 = offset3 + angle3, v67 = angle4 - offset3,
        v68 = offset3 + angle4, v69 = angle1 - (angle3 + angle5) - offset4,
        v70 = angle1 - (angle6 - angle3) - offset4, v71 = offset4 + (angle1 + (angle4 + angle7)),
        v72 = offset4 + (angle1 + (angle8 - angle4)), v73 = dhgen_centred_wide(v69),
        v74 = dhgen_centred_wide(v70),
        v75 = dhgen_pick_wide(-v71 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
            dhgen_only_wide(DHGEN_HALF_TURN < -v71, -DHGEN_TURN)) - v71,
        v76 = dhgen_pick_wide(-v72 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
            dhgen_only_wide(DHGEN_HALF_TURN < -v72, -DHGEN_TURN)) - v72;
    const double v77 = DHGEN_NAN;
    const dhgen_wide v78 = dhgen_only_wide((v55 <= m12) == 0, v77),
        v79 = dhgen_only_wide((v56 <= m12) == 0, v77),
        v80 = dhgen_only_wide((v57 <= m12) == 0, v77),
        v81 = dhgen_only_wide((v58 <= m12) == 0, v77), v82 = v20 + dhgen_raised_wide(v59),
        v83 = v21 + dhgen_raised_wide(v60), v84 = angle2 + v20,
        v85 = v21 + (angle2 - dhgen_signed_wide(DHGEN_HALF_TURN, -Z2_5));

    q[0] = v78 + v82; q[1] = v78 + dhgen_raised_wide(v61); q[2] = v78 + dhgen_raised_wide(v65);
    q[3] = v78 + dhgen_lowered_wide(v73); q[4] = v78 + v84;
    kind[0] = dhgen_kind_wide(q[0]);
    q[5] = v79 + v82; q[6] = v79 + dhgen_raised_wide(v62);
    q[7] = v79 + (dhgen_only_wide(-v66 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v66);
    q[8] = v79 + dhgen_lowered_wide(v74); q[9] = v79 + v84;
    kind[1] = dhgen_kind_wide(q[5]);
    q[10] = v80 + v83; q[11] = v80 + dhgen_raised_wide(v63); q[12] = v80 + dhgen_raised_wide(v67);
    q[13] = v80 + dhgen_lowered_wide(v75); q[14] = v80 + v85;
    kind[2] = dhgen_kind_wide(q[10]);
    q[15] = v81 + v83; q[16] = v81 + dhgen_raised_wide(v64);
    q[17] = v81 + (dhgen_only_wide(-v68 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v68);
    q[18] = v81 + dhgen_lowered_wide(v76); q[19] = v81 + v85;
    kind[3] = dhgen_kind_wide(q[15]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v4 <= m2) | (v1 <= m1) | (v5 <= m2) | (m11 < v36 * v36 + v37 * v37 + v38
        * v38 + v39 * v39 + v40 * v40 + v41 * v41) | ((m12 < v58) & (v58 <= m13)) | ((m12 < v57) &
        (v57 <= m13)) | ((m12 < v56) & (v56 <= m13)) | ((m12 < v55) & (v55 <= m13)) |
        (dhgen_abs_wide(D3_squared_p) <= m6) | (dhgen_abs_wide(D3_squared_m) <= m6));
}

#if DHGEN_LANES > 1
static const double
    m3 = 0.5; /* 1 / 2 */
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
        s1 = Yhat1 * factor1;

    /* theta234 */
    const double v3 = T13 * Xhat1 + T23 * Yhat1, Z2_234 = w1 * (v2 * v3),
        v4 = T33 * T33 + Z2_234 * Z2_234, factor234 = sqrt(v4) * DHGEN_QUOTIENT(1.0, v4);

    /* theta5 */
    const double Z1_5 = w1 * (v2 * (Yhat1 * T12 - Xhat1 * T22)),
        Z2_5 = w1 * (v2 * (Yhat1 * T11 - Xhat1 * T21)), v5 = Z2_5 * Z2_5 + Z1_5 * Z1_5,
        v6 = sqrt(v5) * DHGEN_QUOTIENT(1.0, v5), v7 = Z1_5 * v6, v8 = Z2_5 * v6,
        v9 = copysign(DHGEN_HALF_TURN, -Z2_5);
    const dhgen_four v10 = m3 * (e1 - 1.0);

    /* theta3 */
    const double v11 = d5 * T33;
    const dhgen_four v12 = v2 * (e1 * v3), v13 = w1 * (m4 * v12) - v11;
    const double v14 = T34 - d1;
    const dhgen_four Z1_3 = v14 + factor234 * v13;
    const double v15 = a4 * T33, v16 = T14 * c1 + T24 * s1;
    const dhgen_four v17 = factor234 * (v15 + w1 * (m5 * v12)), Z2_3 = e1 * v16 - v17,
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared), v18 = w3 - w3;

    /* theta2 */
    const dhgen_four v19 = e3 * Z2_3, v20 = m7 * N3 - m8, v21 = Z1_3 * v20,
        S2 = v21 - w3 * (m7 * v19), v22 = Z2_3 * v20, factor2 = DHGEN_QUOTIENT(1.0, N3);

    /* is the pose one that the arm can take? */
    const dhgen_four v23 = Z1_3 * (m9 + m10 * factor2), v24 = v17 + Z2_3,
        v25 = d1 + factor234 * -v13;
    const double v26 = T33 - T33 * factor234, v27 = T31 - factor234 * (Z2_234 * v7),
        v28 = T23 - factor234 * (s1 * Z2_234),
        v29 = T21 + (c1 * v8 + factor234 * (v7 * (s1 * T33))),
        v30 = T11 - (s1 * v8 - factor234 * (v7 * (c1 * T33))),
        v31 = T13 - factor234 * (c1 * Z2_234);
    const dhgen_four v32 = T34 - (a3 * (v23 + w3 * (m9 * (v19 * factor2))) + (v25 + a2 * (S2 *
        factor2))), v33 = T14 - e1 * (c1 * v24), v34 = T24 - e1 * (s1 * v24), v35 = v33 * v33,
        v36 = v34 * v34, v37 = v36 + (v35 + v32 * v32);

    /* joint values */
    const double v38 = copysign(DHGEN_HALF_TURN, Yhat1), v46 = DHGEN_NAN;
    const dhgen_four v47 = dhgen_only_four((v37 <= m12) == 0, v46);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) |
        (dhgen_abs_four(D3_squared) <= m6) | ((m12 < v37) & (v37 <= m13))) | (unsigned)((v4 <= m2) |
        (v1 <= m1) | (m11 < v26 * v26 + v27 * v27 + v28 * v28 + v29 * v29 + v30 * v30 + v31 * v31) |
        (v5 <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(Yhat1, Yhat1, Yhat1, Yhat1),
        dhgen_four_of(Xhat1, Xhat1, Xhat1, Xhat1)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(dhgen_shuffle(w3, dhgen_all_four(-Z2_234), 0, 5, 2,
            3), dhgen_all_four(-Z2_5), 0, 1, 2, 7), dhgen_shuffle(dhgen_shuffle(N3 - k1,
            dhgen_all_four(T33), 0, 5, 2, 3), dhgen_all_four(-Z1_5), 0, 1, 2, 7)),
        ratio3 = dhgen_ratio_four(S2, v22 + w3 * (m7 * (e3 * Z1_3)));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle5 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0), packed2 = dhgen_angle_four(ratio2),
        angle3 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed2, packed2, 1, 1, 1, 1),
        angle2 = dhgen_shuffle(packed2, packed2, 3, 3, 3, 3), angle4 = dhgen_angle_four(ratio3);
    const dhgen_four v39 = angle5 + v10 * v38 - offset1, v40 = angle4 - offset2, v41 = e3 * angle3,
        v42 = v41 - offset3, v43 = e1 * angle1, v44 = v43 - (angle4 + v41) - offset4,
        v45 = dhgen_centred_four(v44), v48 = v18 + dhgen_raised_four(v39), q1 = v47 + v48,
        q2 = v47 + dhgen_raised_four(v40), q3 = v47 + dhgen_raised_four(v42),
        q4 = v47 + dhgen_lowered_four(v45), v49 = v18 + (angle2 + v9 * v10), q5 = v47 + v49;

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
    { 0.9254, 0.9254, 0.9254, 1.0, 1.0, 1.0 }, 0.9253718898866895, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 1, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, xarm5_fk,
    xarm5_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) xarm5_##function
#include "dhgen/functions.h"

/* bartell_rprpr: Bartell RPRPR arm
 *
 * Inverse kinematics, generated from robots/bartell_rprpr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/bartell_rprpr.yaml. The formulas and where they come from:
 * bartell_rprpr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: d48b6b9d27ba3606
 * SPDX-License-Identifier: MIT
 */
#include "bartell_rprpr.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(BARTELL_RPRPR_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(BARTELL_RPRPR_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 5
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef BARTELL_RPRPR_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 2.0, /* joint offset 1 [m] */
    second_weight = 0.5, /* lengths count in arm sizes [m^-1] */
    free_limit = 1e-12, /* a length that fixes no angle */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 2e-05; /* a pose may be rounded by this [m] */

#ifndef __CUDACC_RTC__
const char *const bartell_rprpr_branches[2] = {
    "shoulder+", "shoulder-",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[5] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 2e-09, 0.25, 2.0, 0.19634954084936207, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 2e-09, 0.25, 2.0, 0.19634954084936207, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[5][4] = {
    { 0.0, 2.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 5, DHGEN_MODIFIED, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 7

DHGEN_PUBLIC void bartell_rprpr_fk(const double q[5], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = c1 * c3, x3_y = s1 * c3, z4_x = c1 * s3,
        z4_y = s1 * s3;
    const double c5 = cos(q[4]), s5 = sin(q[4]);
    T[0] = x3_x * c5 + s1 * s5; T[1] = s1 * c5 - x3_x * s5; T[2] = z4_x;
    T[3] = s1 * q[1] + z4_x * q[3];
    T[4] = x3_y * c5 - c1 * s5; T[5] = -(c1 * c5 + x3_y * s5); T[6] = z4_y;
    T[7] = z4_y * q[3] - c1 * q[1];
    T[8] = s3 * c5; T[9] = -(s3 * s5); T[10] = -c3; T[11] = d1 - c3 * q[3];
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void bartell_rprpr_jacobian(const double q[5], double J[30])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p2_x = s1 * q[1], v1 = c1 * q[1];
    const double c3 = cos(q[2]), s3 = sin(q[2]), z4_x = c1 * s3, z4_y = s1 * s3,
        p4_x = p2_x + z4_x * q[3], p4_y = z4_y * q[3] - v1, v2 = d1 - c3 * q[3] - d1;
    J[0] = -p4_y; J[1] = s1; J[2] = -(c1 * v2); J[3] = z4_x; J[4] = 0.0;
    J[5] = p4_x; J[6] = -c1; J[7] = -(s1 * v2); J[8] = z4_y; J[9] = 0.0;
    J[10] = 0.0; J[11] = 0.0; J[12] = s1 * (v1 + p4_y) + c1 * (p4_x - p2_x); J[13] = -c3;
    J[14] = 0.0;
    J[15] = 0.0; J[16] = 0.0; J[17] = s1; J[18] = 0.0; J[19] = z4_x;
    J[20] = 0.0; J[21] = 0.0; J[22] = -c1; J[23] = 0.0; J[24] = z4_y;
    J[25] = 1.0; J[26] = 0.0; J[27] = 0.0; J[28] = 0.0; J[29] = -c3;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[5] = (double (*)[5])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[2, 3], so theta1 = atan2(T23, T13) or half a turn from it. Where both are
     * small, U1[3] x U1[4], element 2 says more: its vector, along the same line, is added */
    const double v1 = T34 - d1;
    const double X2_1 = T23 * v1 - T24 * T33;
    const double Y2_1 = T13 * v1 - T33 * T14;
    const double sigma1 = copysign(second_weight, T13 * X2_1 - T23 * Y2_1);
    const double Xhat1 = T13 + X2_1 * sigma1;
    const double Yhat1 = Y2_1 * sigma1 - T23;
    const double w1 = sqrt(Xhat1 * Xhat1 + Yhat1 * Yhat1);
    const int free1 = w1 <= free_limit;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 3: U1[3, 3] and U1[1, 3] */
    const double v2 = T33 * T33;

    for (int i1 = 0; i1 < 2; i1++) { /* shoulder+, shoulder- */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(Xhat1 * factor1),
            s1 = free1 ? sin(seed[0]) : Yhat1 * factor1;
        const double q1 = atan2(s1, c1);

        /* r2, type 1: U1[2, 4] */
        const double r2 = T14 * s1 - T24 * c1;

        /* theta3 */
        const double Z2_3 = T13 * c1 + T23 * s1;
        const double w3 = sqrt(Z2_3 * Z2_3 + v2);
        const int short3 = w3 <= free_limit;
        const double factor3 = 1.0 / (short3 ? 1.0 : w3);
        const double v3 = T33 * factor3;
        const double s3 = Z2_3 * factor3;
        const double q3 = atan2(s3, -v3);

        /* r4, type 1: U3[2, 4] */
        const double r4 = s3 * (T14 * c1 + T24 * s1) - v3 * -v1;

        /* theta5, type 3: U1[2, 2] and U1[2, 1] */
        const double Z1_5 = T22 * c1 - T12 * s1;
        const double Z2_5 = T21 * c1 - T11 * s1;
        const double w5 = sqrt(Z2_5 * Z2_5 + Z1_5 * Z1_5);
        const int short5 = w5 <= free_limit;
        const double v4 = 1.0 / (short5 ? 1.0 : w5), v5 = Z1_5 * v4, v6 = Z2_5 * v4;
        const double q5 = atan2(-v6, -v5);

        /* is the pose one that the arm can take? */
        const double v7 = c1 * s3, v8 = s1 * s3;
        if (!(fabs(T34 - (d1 + v3 * r4)) <= pose_slack1 && fabs(T33 - v3) <= pose_slack && fabs(T31
            + s3 * v5) <= pose_slack && fabs(T24 - (r4 * v8 - c1 * r2)) <= pose_slack1 && fabs(T23 -
            v8) <= pose_slack && fabs(T21 - (v5 * (s1 * v3) + c1 * v6)) <= pose_slack && fabs(T14 -
            (r4 * v7 + s1 * r2)) <= pose_slack1 && fabs(T11 - (v5 * (c1 * v3) - s1 * v6)) <=
            pose_slack && fabs(T13 - v7) <= pose_slack))
            continue; /* the arm can't take this pose */
        const int row = i1;
        q[row][0] = q1; q[row][1] = r2; q[row][2] = q3; q[row][3] = r4; q[row][4] = q5;
        status[row] = free1 ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

#ifndef BARTELL_RPRPR_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 9.999999999999999e-09, /* doubt_limit^2 */
    m3 = 4.0000000000000007e-10, /* pose_slack1^2 [m^2] */
    m4 = 1.0000000000000002e-10; /* pose_slack^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T34 - d1, X2_1 = v1 * T23 - T24 * T33, Y2_1 = v1 * T13 - T33 * T14,
        sigma1 = dhgen_signed_wide(second_weight, X2_1 * T13 - T23 * Y2_1),
        Xhat1 = T13 + X2_1 * sigma1, Yhat1 = Y2_1 * sigma1 - T23,
        v2 = Xhat1 * Xhat1 + Yhat1 * Yhat1, w1 = dhgen_sqrt_wide(v2), v3 = DHGEN_QUOTIENT(1.0, v2),
        factor1 = w1 * v3, v4 = Xhat1 * factor1, s1 = Yhat1 * factor1,
        angle1 = dhgen_atan2_wide(Yhat1, -Xhat1);

    /* r2 */
    const dhgen_wide q2_p = w1 * (v3 * (T24 * Xhat1 + T14 * Yhat1));

    /* theta3 */
    const dhgen_wide Z2_3 = w1 * (v3 * (T23 * Yhat1 - T13 * Xhat1)), v5 = T33 * T33 + Z2_3 * Z2_3,
        w3 = dhgen_sqrt_wide(v5), v6 = DHGEN_QUOTIENT(1.0, v5), factor3 = w3 * v6,
        v7 = T33 * factor3, s3 = Z2_3 * factor3, angle2 = dhgen_atan2_wide(Z2_3, -T33);

    /* r4 */
    const dhgen_wide q4_p = w3 * (v6 * ((T23 * s1 - T13 * v4) * (T24 * s1 - T14 * v4) - T33 * -v1));

    /* theta5 */
    const dhgen_wide v8 = w1 * (v3 * (Xhat1 * T22 + Yhat1 * T12)),
        v9 = w1 * (v3 * (Xhat1 * T21 + Yhat1 * T11)), v10 = v9 * v9 + v8 * v8,
        v11 = dhgen_sqrt_wide(v10) * DHGEN_QUOTIENT(1.0, v10), v12 = v8 * v11, v13 = v9 * v11,
        angle3 = dhgen_atan2_wide(v9, v8);

    /* is the pose one that the arm can take? */
    const dhgen_wide v14 = v4 * s3, v15 = s1 * s3, v16 = T34 - (d1 + v7 * q4_p), v17 = T33 - v7,
        v18 = T31 - s3 * v12, v19 = T24 - (q4_p * v15 + v4 * q2_p), v20 = T23 - v15,
        v21 = T21 - (v4 * v13 - v12 * (s1 * v7)), v22 = T14 - (s1 * q2_p - q4_p * v14),
        v23 = T11 - (v12 * (v4 * v7) + s1 * v13), v24 = T13 + v14;

    q[0] = angle1; q[1] = q2_p; q[2] = angle2; q[3] = q4_p; q[4] = angle3;
    kind[0] = dhgen_kind_wide(q[0]);
    q[5] = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, Yhat1); q[6] = -q2_p; q[7] = -angle2;
    q[8] = q4_p; q[9] = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, v9);
    kind[1] = dhgen_kind_wide(q[5]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v5 <= m1) | (v2 <= m1) | (v10 <= m1) | (m4 < v17 * v17 + v18 * v18 + v20
        * v20 + v21 * v21 + v23 * v23 + v24 * v24) | (m3 < v16 * v16 + v19 * v19 + v22 * v22));
}

#if DHGEN_LANES > 1
static const double
    m2 = 0.5; /* 1 / 2 */
/* One regular pose, one sign in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    const dhgen_four e1 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double v1 = T34 - d1, X2_1 = v1 * T23 - T24 * T33, Y2_1 = v1 * T13 - T33 * T14,
        sigma1 = copysign(second_weight, X2_1 * T13 - T23 * Y2_1), Xhat1 = T13 + X2_1 * sigma1,
        Yhat1 = Y2_1 * sigma1 - T23, v2 = Xhat1 * Xhat1 + Yhat1 * Yhat1, w1 = sqrt(v2),
        v3 = DHGEN_QUOTIENT(1.0, v2), factor1 = w1 * v3, v4 = Xhat1 * factor1, s1 = Yhat1 * factor1,
        v5 = copysign(DHGEN_HALF_TURN, Yhat1);
    const dhgen_four v6 = m2 * (e1 - 1.0);

    /* r2 */
    const double r2 = w1 * (v3 * (T24 * Xhat1 + T14 * Yhat1));

    /* theta3 */
    const double Z2_3 = w1 * (v3 * (T23 * Yhat1 - T13 * Xhat1)), v7 = T33 * T33 + Z2_3 * Z2_3,
        w3 = sqrt(v7), v8 = DHGEN_QUOTIENT(1.0, v7), factor3 = w3 * v8, v9 = T33 * factor3,
        s3 = Z2_3 * factor3;

    /* r4 */
    const double q4 = w3 * (v8 * ((T23 * s1 - T13 * v4) * (T24 * s1 - T14 * v4) - T33 * -v1));

    /* theta5 */
    const double v10 = w1 * (v3 * (Xhat1 * T22 + Yhat1 * T12)),
        v11 = w1 * (v3 * (Xhat1 * T21 + Yhat1 * T11)), v12 = v11 * v11 + v10 * v10,
        v13 = sqrt(v12) * DHGEN_QUOTIENT(1.0, v12), v14 = v10 * v13, v15 = v11 * v13,
        v16 = copysign(DHGEN_HALF_TURN, v11);

    /* is the pose one that the arm can take? */
    const double v17 = v4 * s3, v18 = s1 * s3, v19 = T34 - (d1 + v9 * q4), v20 = T33 - v9,
        v21 = T31 - s3 * v14, v22 = T24 - (q4 * v18 + v4 * r2), v23 = T23 - v18,
        v24 = T21 - (v4 * v15 - v14 * (s1 * v9)), v25 = T14 - (s1 * r2 - q4 * v17),
        v26 = T11 - (v14 * (v4 * v9) + s1 * v15), v27 = T13 + v17;

    /* joint values */
    const dhgen_four q2 = e1 * r2;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)((v7 <=
        m1) | (v2 <= m1) | (v12 <= m1) | (m4 < v20 * v20 + v21 * v21 + v23 * v23 + v24 * v24 + v26 *
        v26 + v27 * v27) | (m3 < v19 * v19 + v22 * v22 + v25 * v25)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(Yhat1, Z2_3, v11, Yhat1),
        dhgen_four_of(-Xhat1, -T33, v10, -Xhat1));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2);
    const dhgen_four q1 = angle1 + v5 * v6, q5 = angle3 + v6 * v16, q3 = e1 * angle2;

    dhgen_store_4(q, q + 5, q, q + 5, q1, q2, q3, dhgen_all_four(q4));
    dhgen_store_1(q + 4, q + 9, q + 4, q + 9, q5);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[1] = { 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    5, 2, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.5, 0.5, 0.5, 1.0, 1.0, 1.0 }, 0.5, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, bartell_rprpr_fk,
    bartell_rprpr_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) bartell_rprpr_##function
#include "dhgen/functions.h"

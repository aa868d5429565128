/* planar_rrr: Planar arm with three revolute joints
 *
 * Inverse kinematics, generated from robots/planar_rrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_rrr.yaml. The formulas and where they come from:
 * planar_rrr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 4264ea173b1cd0aa
 * SPDX-License-Identifier: MIT
 */
#include "planar_rrr.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(PLANAR_RRR_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(PLANAR_RRR_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef PLANAR_RRR_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    a1 = 0.4, /* link length 1 [m] */
    a2 = 0.3, /* link length 2 [m] */
    a3 = 0.15, /* link length 3 [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    longest2 = 0.48999999999999994, /* square of the longest reach [m^2] */
    shortest2 = 0.010000000000000007, /* square of the shortest reach [m^2] */
    longest2_reach = 0.490000000000119, /* the longest, with what rounding adds [m^2] */
    shortest2_reach = 0.009999999999983007, /* the shortest, with what rounding adds [m^2] */
    longest2_apart = 0.48999999999998795, /* the longest, where branches merge [m^2] */
    shortest2_apart = 0.010000000000001705, /* the shortest, where branches merge [m^2] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 8.5e-06, /* a pose may be rounded by this [m] */
    k1 = 0.25, /* a1^2 + a2^2 [m^2] */
    k2 = 4.166666666666667; /* 1 / (2 * a2 * a1) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const planar_rrr_branches[2] = {
    "right", "left",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.0, 0.4, 0.0 },
    { 0.0, 0.0, 0.3, 0.0 },
    { 0.0, 0.0, 0.15, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void planar_rrr_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - x2_y * s3,
        x3_y = x2_y * c3 + x2_x * s3;
    T[0] = x3_x; T[1] = -x3_y; T[2] = 0.0; T[3] = c1 * a1 + x2_x * a2 + x3_x * a3;
    T[4] = x3_y; T[5] = x3_x; T[6] = 0.0; T[7] = s1 * a1 + x2_y * a2 + x3_y * a3;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void planar_rrr_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2,
        p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), p3_x = p2_x + (x2_x * c3 - x2_y * s3) * a3,
        p3_y = p2_y + (x2_y * c3 + x2_x * s3) * a3;
    J[0] = -p3_y; J[1] = p1_y - p3_y; J[2] = p2_y - p3_y;
    J[3] = p3_x; J[4] = p3_x - p1_x; J[5] = p3_x - p2_x;
    J[6] = 0.0; J[7] = 0.0; J[8] = 0.0;
    J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
    J[15] = 1.0; J[16] = 1.0; J[17] = 1.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    (void)free_joints; (void)seed; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta123, type 3: U0[2, 1] and U0[1, 1] */
    const double w123 = sqrt(T21 * T21 + T11 * T11);
    const int short123 = w123 <= free_limit;
    const double v1 = 1.0 / (short123 ? 1.0 : w123);
    const double c123 = T11 * v1, s123 = T21 * v1;
    const double theta123 = atan2(s123, c123);

    /* theta2, type 8: U0[1, 4] and U0[2, 4] */
    const double v2 = c123 * a3;
    const double Z1_2 = T14 - v2;
    const double v3 = s123 * a3;
    const double Z2_2 = T24 - v3;
    const double N2 = Z1_2 * Z1_2 + Z2_2 * Z2_2;
    const double K2 = N2 - k1;
    const double D2_squared = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) return; /* out of reach */
    const double w2 = sqrt(apart2 ? D2_squared : 0.0);
    const double c2 = K2 * k2;

    /* theta1, type 3: U0[2, 4] and U0[1, 4] */
    const double X1_1 = a1 + a2 * c2;
    const double v4 = Z2_2 * X1_1, v5 = Z1_2 * X1_1;

    /* is the pose one that the arm can take? */
    if (!(fabs(T34) <= pose_slack1 && fabs(T33 - 1.0) <= pose_slack && fabs(T31) <= pose_slack &&
        fabs(T23) <= pose_slack && fabs(T21 - s123) <= pose_slack && fabs(T11 - c123) <= pose_slack
        && fabs(T13) <= pose_slack))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e2 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e2 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e2 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = a2 * s2;
        const double S1 = v4 - Z1_2 * Y1_1;
        const double C1 = v5 + Z2_2 * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const double factor1 = 1.0 / w1;
        const double c1 = C1 * factor1, s1 = S1 * factor1;
        const double q1 = atan2(s1, c1);

        /* is the pose one that the arm can take? */
        const double c12 = c2 * c1 - s2 * s1, s12 = c2 * s1 + s2 * c1;
        if (!(fabs(T14 - (a2 * c12 + (v2 + a1 * c1))) <= pose_slack1 && fabs(T24 - (a2 * s12 + (v3 +
            a1 * s1))) <= pose_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q3 = dhgen_wrap(theta123 - (q2 + q1));
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
        status[row] = DHGEN_OK;
    }
}

#ifndef PLANAR_RRR_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
static const double
    /* 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4] */
    m1 = 5.755396159656667e-12,
    m2 = 1.25, /* a2 * k2 [m^-1] */
    m3 = 0.08750000000000001, /* a1 - a2 * k1 * k2 [m] */
    m4 = 1.666666666666667, /* a1 * k2 [m^-1] */
    /* k2 * (a1 * k1 + a2 * longest2 * shortest2 * k2 - a2 * k1^2 * k2) [m] */
    m5 = 0.1166666666666667,
    m6 = 7.225e-11, /* pose_slack1^2 [m^2] */
    m7 = 1.0000000000000002e-10, /* pose_slack^2 */
    m8 = 1.445e-10; /* 2 * pose_slack1^2 [m^2] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta123 */
    const dhgen_wide v1 = T21 * T21 + T11 * T11, v2 = dhgen_sqrt_wide(v1) * DHGEN_QUOTIENT(1.0, v1),
        angle1 = dhgen_atan2_wide(T21, T11);

    /* theta2 */
    const dhgen_wide v3 = v2 * (a3 * T11), Z1_2 = T14 - v3, v4 = v2 * (a3 * T21), Z2_2 = T24 - v4,
        N2 = Z1_2 * Z1_2 + Z2_2 * Z2_2, D2_squared = (longest2 - N2) * (N2 - shortest2),
        w2 = dhgen_sqrt_wide(D2_squared), angle2 = dhgen_atan2_wide(w2, N2 - k1);

    /* theta1 */
    const dhgen_wide v5 = m3 + m2 * N2, v6 = Z2_2 * v5, S1_p = v6 - w2 * (m2 * Z1_2),
        S1_m = v6 - w2 * (m2 * -Z1_2), v7 = Z1_2 * v5, C1_p = v7 + w2 * (m2 * Z2_2),
        C1_m = v7 + w2 * (m2 * -Z2_2), factor1 = DHGEN_QUOTIENT(1.0, N2),
        angle3 = dhgen_atan2_wide(S1_p, C1_p), angle4 = dhgen_atan2_wide(S1_m, C1_m);

    /* is the pose one that the arm can take? */
    const dhgen_wide v8 = m4 - m5 * factor1, v9 = Z1_2 * v8, v10 = Z2_2 * v8, v11 = T33 - 1.0,
        v12 = v1 - 1.0,
        v13 = T14 - (a2 * (v9 - w2 * (m4 * (Z2_2 * factor1))) + (v3 + a1 * (C1_p * factor1))),
        v14 = T14 - (a2 * (v9 - w2 * (m4 * (-Z2_2 * factor1))) + (v3 + a1 * (C1_m * factor1))),
        v15 = T24 - (a2 * (v10 + w2 * (m4 * (Z1_2 * factor1))) + (v4 + a1 * (S1_p * factor1))),
        v16 = T24 - (a2 * (v10 + w2 * (m4 * (-Z1_2 * factor1))) + (v4 + a1 * (S1_m * factor1))),
        v17 = v13 * v13 + v15 * v15, v18 = v14 * v14 + v16 * v16;

    /* joint values */
    const dhgen_wide v19 = angle1 - (angle2 + angle3), v20 = angle1 - (angle4 - angle2);
    const double v21 = DHGEN_NAN;
    const dhgen_wide v22 = dhgen_only_wide((v17 <= m6) == 0, v21),
        v23 = dhgen_only_wide((v18 <= m6) == 0, v21);

    q[0] = angle3 + v22; q[1] = angle2 + v22; q[2] = v22 + dhgen_centred_wide(v19);
    kind[0] = dhgen_kind_wide(q[0]);
    q[3] = angle4 + v23; q[4] = v23 - angle2; q[5] = v23 + dhgen_centred_wide(v20);
    kind[1] = dhgen_kind_wide(q[3]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((m6 < T34 * T34) | (dhgen_abs_wide(D2_squared) <= m1) | (m7 < v11 * v11 +
        T31 * T31 + T23 * T23 + T13 * T13 + v12 * v12) | ((m6 < v17) & (v17 <= m8)) | ((m6 < v18) &
        (v18 <= m8)));
}

#if DHGEN_LANES > 1
/* One regular pose, one sign in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    const dhgen_four e2 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta123 */
    const double v1 = T21 * T21 + T11 * T11, v2 = sqrt(v1) * DHGEN_QUOTIENT(1.0, v1);

    /* theta2 */
    const double v3 = v2 * (a3 * T11), Z1_2 = T14 - v3, v4 = v2 * (a3 * T21), Z2_2 = T24 - v4,
        N2 = Z1_2 * Z1_2 + Z2_2 * Z2_2, D2_squared = (longest2 - N2) * (N2 - shortest2),
        w2 = sqrt(D2_squared);

    /* theta1 */
    const dhgen_four v5 = e2 * Z1_2;
    const double v6 = m3 + m2 * N2, v7 = Z2_2 * v6;
    const dhgen_four S1 = v7 - w2 * (m2 * v5), v8 = e2 * Z2_2;
    const double v9 = Z1_2 * v6;
    const dhgen_four C1 = v9 + w2 * (m2 * v8);
    const double factor1 = DHGEN_QUOTIENT(1.0, N2);

    /* is the pose one that the arm can take? */
    const double v10 = m4 - m5 * factor1, v11 = Z1_2 * v10, v12 = Z2_2 * v10, v13 = T33 - 1.0,
        v14 = v1 - 1.0;
    const dhgen_four v15 = T14 - (a2 * (v11 - w2 * (m4 * (v8 * factor1))) + (v3 + a1 * (C1 *
        factor1))),
        v16 = T24 - (a2 * (v12 + w2 * (m4 * (v5 * factor1))) + (v4 + a1 * (S1 * factor1))),
        v17 = v15 * v15 + v16 * v16;

    /* joint values */
    const double v20 = DHGEN_NAN;
    const dhgen_four v21 = dhgen_only_four((v17 <= m6) == 0, v20);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((m6 < v17) & (v17
        <= m8))) | (unsigned)((m6 < T34 * T34) | (m7 < v13 * v13 + T31 * T31 + T23 * T23 + T13 * T13
        + v14 * v14) | (fabs(D2_squared) <= m1)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(dhgen_shuffle(S1,
        dhgen_all_four(T21), 0, 1, 6, 3), dhgen_all_four(w2), 0, 1, 2, 7),
        dhgen_shuffle(dhgen_shuffle(C1, dhgen_all_four(T11), 0, 1, 6, 3), dhgen_all_four(N2 - k1),
        0, 1, 2, 7));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle3 = dhgen_shuffle(packed1, packed1, 0, 1, 0, 1),
        angle1 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2),
        angle2 = dhgen_shuffle(packed1, packed1, 3, 3, 3, 3);
    const dhgen_four v18 = e2 * angle2, v19 = angle1 - (angle3 + v18), q1 = angle3 + v21,
        q2 = v18 + v21, q3 = v21 + dhgen_centred_four(v19);

    dhgen_store_2(q, q + 3, q, q + 3, q1, q2);
    dhgen_store_1(q + 2, q + 5, q + 2, q + 5, q3);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 2, 0, DHGEN_POSE, joints, NULL, 0,
    { 1.176, 1.176, 1.176, 1.0, 1.0, 1.0 }, 1.1764705882352942, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    1, /* follows seed */ NULL, NULL, NULL, NULL, planar_rrr_fk, planar_rrr_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) planar_rrr_##function
#include "dhgen/functions.h"

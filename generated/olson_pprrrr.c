/* olson_pprrrr: Olson PPRRRR arm
 *
 * Inverse kinematics, generated from robots/olson_pprrrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/olson_pprrrr.yaml. The formulas and where they come from:
 * olson_pprrrr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: db2ececc07f31b80
 * SPDX-License-Identifier: MIT
 */
#include "olson_pprrrr.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(OLSON_PPRRRR_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(OLSON_PPRRRR_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef OLSON_PPRRRR_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d3 = 1.0, /* joint offset 3 [m] */
    a4 = 4.0, /* link length 5 [m] */
    d6 = 2.0, /* joint offset 6 [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    near_limit = 0.001, /* a length whose direction is good to few digits */
    reach_slack1 = 7e-13, /* rounding at the boundary of the workspace [m] */
    merge_slack1 = 7e-14, /* nearer to that boundary two branches are one [m] */
    /* the same where they follow an angle that is good to few digits [m] */
    blur_slack1 = 6.999999999999999e-11,
    k1 = 16.0, /* a4^2 [m^2] */
    k2 = 0.0625; /* 1 / k1 [m^-2] */

#ifndef __CUDACC_RTC__
const char *const olson_pprrrr_branches[4] = {
    "elbow3+-elbow4+", "elbow3+-elbow4-", "elbow3--elbow4+", "elbow3--elbow4-",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 7e-09, 0.02040816326530612, 7.0, 0.6872233929727672, 0 },
    { -HUGE_VAL, HUGE_VAL, 7e-09, 0.02040816326530612, 7.0, 0.6872233929727672, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 1.5707963267948966, 0.0, 0.0, -1.5707963267948966 },
    { -1.5707963267948966, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 1.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 4.0, 0.0 },
    { 0.0, 2.0, 0.0, 1.5707963267948966 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_MODIFIED, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void olson_pprrrr_fk(const double q[6], double T[16])
{
    const double c3 = cos(q[2]), s3 = sin(q[2]);
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = s3 * c4, v1 = c3 * c4, v2 = s3 * s4,
        y4_y = c3 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v2 * s5,
        x5_y = y4_y * s5 - v1 * c5, x5_z = s4 * c5 + c4 * s5, z6_x = v2 * c5 + x4_x * s5,
        y5_y = y4_y * c5 + v1 * s5, y5_z = c4 * c5 - s4 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - c3 * s6; T[1] = -(c3 * c6 + x5_x * s6); T[2] = z6_x;
    T[3] = q[1] + x4_x * a4 + z6_x * d6;
    T[4] = x5_y * c6 - s3 * s6; T[5] = -(s3 * c6 + x5_y * s6); T[6] = -y5_y;
    T[7] = q[0] - v1 * a4 - y5_y * d6;
    T[8] = x5_z * c6; T[9] = -(x5_z * s6); T[10] = -y5_z; T[11] = d3 + s4 * a4 - y5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void olson_pprrrr_jacobian(const double q[6], double J[36])
{
    const double c3 = cos(q[2]), s3 = sin(q[2]);
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = s3 * c4, v1 = c3 * c4,
        p5_x = q[1] + x4_x * a4, p5_y = q[0] - v1 * a4, p5_z = d3 + s4 * a4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z6_x = s3 * s4 * c5 + x4_x * s5,
        y5_y = c3 * s4 * c5 + v1 * s5, y5_z = c4 * c5 - s4 * s5, p6_x = p5_x + z6_x * d6,
        p6_y = p5_y - y5_y * d6, p6_z = p5_z - y5_z * d6, J23 = p6_x - q[1], v2 = p6_y - q[0],
        v3 = p6_z - d3, v4 = p6_z - p5_z;
    J[0] = 0.0; J[1] = 1.0; J[2] = -v2; J[3] = -(s3 * v3); J[4] = -(s3 * v4); J[5] = 0.0;
    J[6] = 1.0; J[7] = 0.0; J[8] = J23; J[9] = c3 * v3; J[10] = c3 * v4; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = s3 * J23 - c3 * v2;
    J[16] = s3 * (p6_x - p5_x) - c3 * (p6_y - p5_y); J[17] = 0.0;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = -c3; J[22] = -c3; J[23] = z6_x;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = -s3; J[28] = -s3; J[29] = -y5_y;
    J[30] = 0.0; J[31] = 0.0; J[32] = 1.0; J[33] = 0.0; J[34] = 0.0; J[35] = -y5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta3, type 2: U3[2, 3] */
    const double w3 = sqrt(T23 * T23 + T13 * T13);
    const int free3 = w3 <= free_limit;
    const double divisor3 = free3 ? 1.0 : w3;
    const int near3 = w3 <= near_limit;

    /* theta4, type 2: U0 A6^-1 [3, 4] */
    const double wz = T34 - T33 * d6;
    const double Z4 = wz - d3;
    const double D4_squared = k1 - Z4 * Z4;
    const double v3 = 2.0 * fabs(Z4);
    const int apart4 = merge_slack1 * (v3 + merge_slack1) < D4_squared;
    if (!(-(reach_slack1 * (v3 + reach_slack1)) < D4_squared)) return; /* out of reach */
    const double w4 = sqrt(apart4 ? D4_squared : 0.0);
    const double s4 = k2 * (a4 * Z4);

    /* r2, type 1: U0 A6^-1 [1, 4] */
    const double wx = T14 - T13 * d6;

    /* r1, type 1: U0 A6^-1 [2, 4] */
    const double wy = T24 - T23 * d6;

    for (int i1 = 0; i1 < 2; i1++) { /* elbow3+, elbow3- */
        const double e3 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e3 < 0.0 && free3) continue; /* both signs give the same */
        const double factor3 = e3 / divisor3;
        const double v1 = T23 * factor3, v2 = T13 * factor3;
        const double off3 = near3 ? w3 * fabs(v1 * sin(seed[2]) + v2 * cos(seed[2])) : 1.0;
        const double ahead3 = near3 ? v1 * cos(seed[2]) - v2 * sin(seed[2]) : -1.0;
        const int same3 = near3 && 0.0 < ahead3 && off3 <= free_limit;
        const int held3 = free3 || same3;
        const double c3 = held3 ? cos(seed[2]) : v1, s3 = held3 ? sin(seed[2]) : -v2;
        const double q3 = atan2(s3, c3);

        /* r2 */
        const double v5 = s3 * a4;

        /* r1 */
        const double v6 = c3 * a4;

        /* theta45, type 3: U3[3, 3] and U3[1, 3] */
        const double theta45 = atan2(-(w3 * e3), -T33);

        /* theta6, type 3: U3[2, 2] and U3[2, 1] */
        const double q6 = atan2(-(T11 * c3 + T21 * s3), -(T12 * c3 + T22 * s3));

        for (int i2 = 0; i2 < 2; i2++) { /* elbow4+, elbow4- */
            const double e4 = i2 == 0 ? 1.0 : -1.0;
            /* theta4 */
            if (e4 < 0.0 && (!apart4 || (near3 && !(blur_slack1 * (v3 + blur_slack1) <
                D4_squared))))
                continue; /* both signs give the same */
            const double v4 = k2 * (a4 * (w4 * e4));
            const double q4 = atan2(s4, -v4);

            /* r2 */
            const double r2 = wx + v4 * v5;

            /* r1 */
            const double r1 = wy - v4 * v6;

            /* joint values */
            const double q5 = dhgen_wrap(theta45 - q4);
            const int row = 2 * i1 + i2;
            q[row][0] = r1; q[row][1] = r2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            q[row][5] = q6;
            status[row] = free3 ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef OLSON_PPRRRR_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 9.999999999999999e-09, /* doubt_limit^2 */
    m3 = 6.999999999999999e-10; /* 10 * blur_slack1 [m] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta3 */
    const dhgen_wide v1 = T23 * T23 + T13 * T13, w3 = dhgen_sqrt_wide(v1),
        factor3 = w3 * DHGEN_QUOTIENT(1.0, v1), c3 = T23 * factor3, v2 = T13 * factor3,
        angle1 = dhgen_atan2_wide(-T13, T23);

    /* theta4 */
    const dhgen_wide Z4 = T34 - d6 * T33 - d3, D4_squared = k1 - Z4 * Z4,
        w4 = dhgen_sqrt_wide(D4_squared), v3 = w4 - w4, v4 = a4 * w4, v5 = k2 * v4, v6 = a4 * Z4,
        angle2 = dhgen_atan2_wide(v6, -v4), q4_pm = dhgen_signed_wide(DHGEN_HALF_TURN, v6) - angle2;

    /* r2 */
    const dhgen_wide wx = T14 - d6 * T13, v7 = v5 * (a4 * v2), q2_pp = wx - v7, q2_pm = wx + v7;

    /* r1 */
    const dhgen_wide wy = T24 - d6 * T23, v8 = v5 * (a4 * c3), q1_pp = wy - v8, q1_pm = wy + v8;

    /* theta45 */
    const dhgen_wide angle3 = dhgen_atan2_wide(-w3, -T33);

    /* theta6 */
    const dhgen_wide v9 = v2 * T21 - c3 * T11, angle4 = dhgen_atan2_wide(v9, v2 * T22 - c3 * T12);

    /* joint values */
    const dhgen_wide v10 = angle3 - angle2, v11 = angle3 - q4_pm, v12 = angle2 + angle3,
        v13 = q4_pm + angle3, q3_pp = angle1 + v3,
        q3_mp = v3 + (angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, -T13)), q6_pp = v3 + angle4,
        q6_mp = v3 + (angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, v9));

    q[0] = q1_pp; q[1] = q2_pp; q[2] = q3_pp; q[3] = angle2; q[4] = dhgen_centred_wide(v10);
    q[5] = q6_pp;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_pm; q[7] = q2_pm; q[8] = q3_pp; q[9] = q4_pm; q[10] = dhgen_centred_wide(v11);
    q[11] = q6_pp;
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_pm; q[13] = q2_pm; q[14] = q3_mp; q[15] = angle2;
    q[16] = dhgen_pick_wide(-v12 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
        dhgen_only_wide(DHGEN_HALF_TURN < -v12, -DHGEN_TURN)) - v12;
    q[17] = q6_mp;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_pp; q[19] = q2_pp; q[20] = q3_mp; q[21] = q4_pm;
    q[22] = dhgen_pick_wide(-v13 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
        dhgen_only_wide(DHGEN_HALF_TURN < -v13, -DHGEN_TURN)) - v13;
    q[23] = q6_mp;
    kind[3] = dhgen_kind_wide(q[18]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v1 <= m1) | (dhgen_abs_wide(D4_squared) <= m3 * (blur_slack1 + 2.0 *
        dhgen_abs_wide(Z4))));
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
    const dhgen_four e3 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e4 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta3 */
    const double v1 = T23 * T23 + T13 * T13, w3 = sqrt(v1), factor3 = w3 * DHGEN_QUOTIENT(1.0, v1),
        c3 = T23 * factor3, v2 = T13 * factor3, v3 = copysign(DHGEN_HALF_TURN, -T13);
    const dhgen_four v4 = m2 * (e3 - 1.0);

    /* theta4 */
    const double Z4 = T34 - d6 * T33 - d3, D4_squared = k1 - Z4 * Z4, w4 = sqrt(D4_squared),
        v5 = w4 - w4, v6 = a4 * w4, v7 = k2 * v6, v8 = a4 * Z4, v9 = copysign(DHGEN_HALF_TURN, v8);

    /* r2 */
    const double wx = T14 - d6 * T13, v10 = v7 * (a4 * v2);
    const dhgen_four v11 = e3 * e4, q2 = wx - v10 * v11;

    /* r1 */
    const double wy = T24 - d6 * T23, v12 = v7 * (a4 * c3);
    const dhgen_four q1 = wy - v11 * v12;

    /* theta6 */
    const double v13 = v2 * T21 - c3 * T11, v14 = copysign(DHGEN_HALF_TURN, v13);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)((v1 <=
        m1) | (fabs(D4_squared) <= m3 * (blur_slack1 + 2.0 * fabs(Z4)))))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-T13, v8, -w3, v13),
        dhgen_four_of(T23, -v6, -T33, v2 * T22 - c3 * T12));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2),
        angle4 = dhgen_shuffle(packed1, packed1, 3, 3, 3, 3);
    const dhgen_four q4 = e4 * angle2 + v9 * (m2 * (1.0 - e4)), v15 = e3 * angle3, v16 = v15 - q4,
        q5 = dhgen_centred_four(v16), q3 = v5 + (angle1 + v3 * v4), q6 = v5 + (angle4 + v4 * v14);

    dhgen_store_4(q, q + 6, q + 12, q + 18, q1, q2, q3, q4);
    dhgen_store_2(q + 4, q + 10, q + 16, q + 22, q5, q6);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[1] = { 2 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 4, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.1429, 0.1429, 0.1429, 1.0, 1.0, 1.0 }, 0.14285714285714285, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, olson_pprrrr_fk,
    olson_pprrrr_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) olson_pprrrr_##function
#include "dhgen/functions.h"

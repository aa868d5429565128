/* rpr: Arm with a revolute, a prismatic and a revolute joint
 *
 * Inverse kinematics, generated from robots/rpr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/rpr.yaml. The formulas and where they come from: rpr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 2982606682a8b5ef
 * SPDX-License-Identifier: MIT
 */
#include "rpr.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(RPR_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(RPR_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef RPR_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.5, /* joint offset 1 [m] */
    a3 = 0.3, /* link length 3 [m] */
    free_limit1 = 8e-13, /* a length that fixes no angle [m] */
    reach_slack1 = 8.000000000000001e-14, /* rounding at the boundary of the workspace [m] */
    merge_slack1 = 8e-15, /* nearer to that boundary two branches are one [m] */
    k1 = 0.09, /* a3^2 [m^2] */
    k2 = 11.111111111111112; /* 1 / k1 [m^-2] */

#ifndef __CUDACC_RTC__
const char *const rpr_branches[4] = {
    "shoulder+-elbow+", "shoulder+-elbow-", "shoulder--elbow+", "shoulder--elbow-",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 8e-10, 1.5624999999999998, 0.8, 0.07853981633974483, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.5, 0.0, -1.5707963267948966 },
    { 1.5707963267948966, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.3, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void rpr_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c3 = cos(q[2]), s3 = sin(q[2]), v1 = s1 * s3, x3_y = c1 * s3;
    T[0] = -v1; T[1] = -(s1 * c3); T[2] = c1; T[3] = -(s1 * q[1] + v1 * a3);
    T[4] = x3_y; T[5] = c1 * c3; T[6] = s1; T[7] = c1 * q[1] + x3_y * a3;
    T[8] = -c3; T[9] = s3; T[10] = 0.0; T[11] = d1 - c3 * a3;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void rpr_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * q[1], p2_y = c1 * q[1];
    const double c3 = cos(q[2]), s3 = sin(q[2]), v2 = v1 + s1 * s3 * a3, p3_y = p2_y + c1 * s3 * a3,
        v3 = d1 - c3 * a3 - d1;
    J[0] = -p3_y; J[1] = -s1; J[2] = s1 * v3;
    J[3] = -v2; J[4] = c1; J[5] = -(c1 * v3);
    J[6] = 0.0; J[7] = 0.0; J[8] = c1 * (p3_y - p2_y) - s1 * (v1 - v2);
    J[9] = 0.0; J[10] = 0.0; J[11] = c1;
    J[12] = 0.0; J[13] = 0.0; J[14] = s1;
    J[15] = 1.0; J[16] = 0.0; J[17] = 0.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[1, 4] */
    const double w1 = sqrt(T24 * T24 + T14 * T14);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 2: U0[3, 4] */
    const double Z3 = T34 - d1;
    const double D3_squared = k1 - Z3 * Z3;
    const double v1 = 2.0 * fabs(Z3);
    const int apart3 = merge_slack1 * (v1 + merge_slack1) < D3_squared;
    if (!(-(reach_slack1 * (v1 + reach_slack1)) < D3_squared)) return; /* out of reach */
    const double w3 = sqrt(apart3 ? D3_squared : 0.0);

    for (int i1 = 0; i1 < 2; i1++) { /* shoulder+, shoulder- */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : T24 * factor1,
            s1 = free1 ? sin(seed[0]) : -(T14 * factor1);
        const double q1 = atan2(s1, c1);
        const double D1 = w1 * e1;

        for (int i2 = 0; i2 < 2; i2++) { /* elbow+, elbow- */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double v2 = k2 * (a3 * (w3 * e3));
            const double q3 = atan2(-v2, -(k2 * (a3 * Z3)));

            /* r2, type 1: U1[3, 4] */
            const double v3 = a3 * v2;
            const double r2 = D1 + v3;
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = r2; q[row][2] = q3;
            status[row] = free1 ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef RPR_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 8e-05 [m]. */
static const double
    m1 = 6.400000000000001e-09, /* doubt_limit1^2 [m^2] */
    m3 = 8e-12; /* 1000 * merge_slack1 [m] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T24 * T24 + T14 * T14, w1 = dhgen_sqrt_wide(v1),
        angle1 = dhgen_atan2_wide(-T14, T24);

    /* theta3 */
    const dhgen_wide Z3 = T34 - d1, D3_squared = k1 - Z3 * Z3, w3 = dhgen_sqrt_wide(D3_squared),
        v2 = w3 - w3, angle2 = dhgen_atan2_wide(-(a3 * w3), -(a3 * Z3));

    /* r2 */
    const dhgen_wide q2_pp = w1 + w3, q2_pm = w1 - w3;

    /* joint values */
    const dhgen_wide q1_pp = angle1 + v2,
        q1_mp = v2 + (angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, -T14));

    q[0] = q1_pp; q[1] = q2_pp; q[2] = angle2;
    kind[0] = dhgen_kind_wide(q[0]);
    q[3] = q1_pp; q[4] = q2_pm; q[5] = -angle2;
    kind[1] = dhgen_kind_wide(q[3]);
    q[6] = q1_mp; q[7] = -q2_pm; q[8] = angle2;
    kind[2] = dhgen_kind_wide(q[6]);
    q[9] = q1_mp; q[10] = -q2_pp; q[11] = -angle2;
    kind[3] = dhgen_kind_wide(q[9]);
    const dhgen_wide_mask exact = 0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] * T[11] *
        T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v1 <= m1) | (dhgen_abs_wide(D3_squared) <= m3 * (merge_slack1 + 2.0 *
        dhgen_abs_wide(Z3))));
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
    const double v1 = T24 * T24 + T14 * T14, w1 = sqrt(v1), v2 = copysign(DHGEN_HALF_TURN, -T14);

    /* theta3 */
    const double Z3 = T34 - d1, D3_squared = k1 - Z3 * Z3, w3 = sqrt(D3_squared), v3 = w3 - w3;

    /* r2 */
    const dhgen_four v4 = e1 * w1, v5 = e3 * w3, q2 = v4 + v5;

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] *
        T[11] * T[11])) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)((v1 <= m1) | (fabs(D3_squared) <=
        m3 * (merge_slack1 + 2.0 * fabs(Z3)))))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-T14, -(a3 * w3), -T14,
        -T14), dhgen_four_of(T24, -(a3 * Z3), T24, T24));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1);
    const dhgen_four q3 = e3 * angle2, q1 = v3 + (angle1 + v2 * (m2 * (e1 - 1.0)));

    dhgen_store_2(q, q + 3, q + 6, q + 9, q1, q2);
    dhgen_store_1(q + 2, q + 5, q + 8, q + 11, q3);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[3] = { 3, 7, 11 };
DHGEN_TABLE int choosable[1] = { 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 4, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 1.25, 1.25, 1.25, 0.0, 0.0, 0.0 }, 1.25, { 1e-14, 1e-14 }, entries, 3,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, rpr_fk,
    rpr_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) rpr_##function
#include "dhgen/functions.h"

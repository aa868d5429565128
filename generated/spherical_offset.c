/* spherical_offset: Spherical arm with a shoulder offset
 *
 * Inverse kinematics, generated from robots/spherical_offset.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/spherical_offset.yaml. The formulas and where they come from:
 * spherical_offset.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 31de25d5e88e2e17
 * SPDX-License-Identifier: MIT
 */
#include "spherical_offset.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(SPHERICAL_OFFSET_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(SPHERICAL_OFFSET_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef SPHERICAL_OFFSET_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 1.5e-14 [m], merge_slack1 = 1.5e-15 [m]. */
static const double
    d2 = 0.15, /* joint offset 2 [m] */
    free_limit1 = 1.5e-13, /* a length that fixes no angle [m] */
    k1 = 0.0225, /* d2^2 [m^2] */
    k2 = 4.5000000000002246e-15, /* reach_slack1 * (2 * d2 + reach_slack1) [m^2] */
    k3 = 4.500000000000022e-16; /* merge_slack1 * (2 * d2 + merge_slack1) [m^2] */

#ifndef __CUDACC_RTC__
const char *const spherical_offset_branches[4] = {
    "right-forward", "right-backward", "left-forward", "left-backward",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1.5e-10, 44.44444444444444, 0.15, 0.014726215563702155, 0 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.15, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void spherical_offset_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), z2_x = c1 * s2, z2_y = s1 * s2;
    T[0] = c1 * c2; T[1] = -s1; T[2] = z2_x; T[3] = z2_x * q[2] - s1 * d2;
    T[4] = s1 * c2; T[5] = c1; T[6] = z2_y; T[7] = c1 * d2 + z2_y * q[2];
    T[8] = -s2; T[9] = 0.0; T[10] = c2; T[11] = c2 * q[2];
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void spherical_offset_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), z2_x = c1 * s2, z2_y = s1 * s2,
        p3_x = z2_x * q[2] - s1 * d2, p3_y = c1 * d2 + z2_y * q[2], p3_z = c2 * q[2];
    J[0] = -p3_y; J[1] = c1 * p3_z; J[2] = z2_x;
    J[3] = p3_x; J[4] = s1 * p3_z; J[5] = z2_y;
    J[6] = 0.0; J[7] = -(s1 * p3_y + c1 * p3_x); J[8] = c2;
    J[9] = 0.0; J[10] = -s1; J[11] = 0.0;
    J[12] = 0.0; J[13] = c1; J[14] = 0.0;
    J[15] = 1.0; J[16] = 0.0; J[17] = 0.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[3, 4] */
    const double N1 = T14 * T14 + T24 * T24;
    const double D1_squared = N1 - k1;
    const int apart1 = k3 < D1_squared;
    if (!(-k2 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double inverse1 = 1.0 / (apart1 ? N1 : d2 * sqrt(N1));
    const double v1 = T14 * d2, v2 = T24 * d2;

    /* theta2, r3, type 4: U1[1, 4] and U1[2, 4] */
    const double v3 = T34 * T34;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = inverse1 * (v2 - T14 * D1), s1 = -(inverse1 * (v1 + T24 * D1));
        const double q1 = atan2(s1, c1);

        /* theta2, r3 */
        const double w3 = sqrt(D1 * D1 + v3);
        const int free2 = w3 <= free_limit1;
        const double divisor2 = free2 ? 1.0 : w3;

        for (int i2 = 0; i2 < 2; i2++) { /* forward, backward */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta2, r3 */
            if (e2 < 0.0 && free2) continue; /* both signs give the same */
            const double factor2 = e2 / divisor2;
            const double c2 = free2 ? cos(seed[1]) : T34 * factor2,
                s2 = free2 ? sin(seed[1]) : -(D1 * factor2);
            const double q2 = atan2(s2, c2);
            const double r3 = w3 * e2;
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = r3;
            status[row] = free2 ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef SPHERICAL_OFFSET_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 1.4999999999999999e-05 [m]. */
static const double
    m1 = 4.5000000000000217e-13, /* 1000 * k3 [m^2] */
    m2 = 2.2499999999999997e-10; /* doubt_limit1^2 [m^2] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide D1_squared = T14 * T14 + T24 * T24 - k1, w1 = dhgen_sqrt_wide(D1_squared),
        v1 = w1 - w1, v2 = d2 * T14, v3 = d2 * T24, v4 = T14 * w1, v5 = T24 * w1,
        angle1 = dhgen_atan2_wide(-(v2 + v5), v3 - v4), angle2 = dhgen_atan2_wide(v5 - v2, v3 + v4);

    /* theta2, r3 */
    const dhgen_wide v6 = D1_squared + T34 * T34, w3 = dhgen_sqrt_wide(v6),
        angle3 = dhgen_atan2_wide(-w1, T34),
        q2_pm = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, -w1);

    /* joint values */
    const dhgen_wide q3_pp = v1 + w3, q3_pm = v1 - w3;

    q[0] = angle1; q[1] = angle3; q[2] = q3_pp;
    kind[0] = dhgen_kind_wide(q[0]);
    q[3] = angle1; q[4] = q2_pm; q[5] = q3_pm;
    kind[1] = dhgen_kind_wide(q[3]);
    q[6] = angle2; q[7] = -angle3; q[8] = q3_pp;
    kind[2] = dhgen_kind_wide(q[6]);
    q[9] = angle2; q[10] = -q2_pm; q[11] = q3_pm;
    kind[3] = dhgen_kind_wide(q[9]);
    const dhgen_wide_mask exact = 0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] * T[11] *
        T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D1_squared) <= m1) | (v6 <= m2));
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
    const dhgen_four e2 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double D1_squared = T14 * T14 + T24 * T24 - k1, w1 = sqrt(D1_squared), v1 = w1 - w1,
        v2 = d2 * T14, v3 = d2 * T24, v4 = T14 * w1, v5 = T24 * w1;

    /* theta2, r3 */
    const double v6 = D1_squared + T34 * T34, w3 = sqrt(v6), v7 = copysign(DHGEN_HALF_TURN, -w1);

    /* joint values */
    const dhgen_four q3 = v1 + e2 * w3;

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] *
        T[11] * T[11])) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)((fabs(D1_squared) <= m1) | (v6 <=
        m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(-(v2 + e1 * v5),
        dhgen_all_four(-w1), 0, 5, 2, 3), dhgen_shuffle(v3 - e1 * v4, dhgen_all_four(T34), 0, 5, 2,
        3));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1);
    const dhgen_four q2_ = angle2 + v7 * (m3 * (e2 - 1.0)), q2 = e1 * q2_;

    dhgen_store_2(q, q + 3, q + 6, q + 9, angle1, q2);
    dhgen_store_1(q + 2, q + 5, q + 8, q + 11, q3);
    const unsigned long long none1 = (dhgen_bits_four(angle1 != angle1) * 0x204081ull &
        0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[3] = { 3, 7, 11 };
DHGEN_TABLE int choosable[1] = { 1 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 4, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 6.667, 6.667, 6.667, 0.0, 0.0, 0.0 }, 6.666666666666667, { 1e-14, 1e-14 }, entries, 3,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, spherical_offset_fk,
    spherical_offset_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) spherical_offset_##function
#include "dhgen/functions.h"

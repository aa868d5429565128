/* stewart_leg: Stewart platform, six cylinders (6-UPS): a leg
 *
 * Inverse kinematics, generated from robots/stewart.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/stewart.yaml. The formulas and where they come from:
 * stewart_leg.md, of a leg of stewart.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 7e0d95027cd10e15
 * SPDX-License-Identifier: MIT
 */
#include "stewart_leg.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(STEWART_LEG_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(STEWART_LEG_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef STEWART_LEG_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    free_limit1 = 7.5e-13; /* a length that fixes no angle [m] */

#ifndef __CUDACC_RTC__
const char *const stewart_leg_branches[4] = {
    "back-forward", "back-backward", "front-forward", "front-backward",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { 0.35, 0.75, 7.5e-10, 1.7777777777777777, 0.75, 0.0125, 0 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void stewart_leg_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), z2_x = c1 * s2, z2_y = s1 * s2;
    T[0] = c1 * c2; T[1] = -s1; T[2] = z2_x; T[3] = z2_x * q[2];
    T[4] = s1 * c2; T[5] = c1; T[6] = z2_y; T[7] = z2_y * q[2];
    T[8] = -s2; T[9] = 0.0; T[10] = c2; T[11] = c2 * q[2];
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void stewart_leg_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), z2_x = c1 * s2, z2_y = s1 * s2, p3_x = z2_x * q[2],
        p3_y = z2_y * q[2], p3_z = c2 * q[2];
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
    const double w1 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta2, r3, type 4: U1[1, 4] and U1[2, 4] */
    const double v1 = T34 * T34;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(T14 * factor1),
            s1 = free1 ? sin(seed[0]) : -(T24 * factor1);
        const double q1 = atan2(s1, c1);
        const double D1 = w1 * e1;

        /* theta2, r3 */
        const double w3 = sqrt(D1 * D1 + v1);
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
            status[row] = (free1 || free2) ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef STEWART_LEG_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 7.500000000000001e-05 [m]. */
static const double
    per_size = 1.3333333333333333, /* slides beyond limits count in the arm's size [m^-1] */
    m1 = 5.625000000000001e-09; /* doubt_limit1^2 [m^2] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T14 * T14 + T24 * T24, angle1 = dhgen_atan2_wide(-T24, -T14),
        q1_mp = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, -T24);

    /* theta2, r3 */
    const dhgen_wide v2 = v1 + T34 * T34, q3_pp = dhgen_sqrt_wide(v2),
        angle2 = dhgen_atan2_wide(-dhgen_sqrt_wide(v1), T34),
        q2_pm = angle2 - dhgen_signed_wide(DHGEN_HALF_TURN, -dhgen_sqrt_wide(v1));

    /* joint values */
    const dhgen_wide excess_p = per_size * dhgen_beyond_wide(q3_pp, joints + 2),
        excess_m = per_size * dhgen_maximum_wide(dhgen_low(joints + 2) + q3_pp, -(dhgen_high(joints
            + 2) + q3_pp));
    const dhgen_wide_mask outside_pp = 0.0 < excess_p, outside_pm = 0.0 < excess_m;

    q[0] = angle1; q[1] = angle2; q[2] = q3_pp;
    kind[0] = dhgen_kind_within_wide(q[0], outside_pp);
    q[3] = angle1; q[4] = q2_pm; q[5] = -q3_pp;
    kind[1] = dhgen_kind_within_wide(q[3], outside_pm);
    q[6] = q1_mp; q[7] = -angle2; q[8] = q3_pp;
    kind[2] = dhgen_kind_within_wide(q[6], outside_pp);
    q[9] = q1_mp; q[10] = -q2_pm; q[11] = -q3_pp;
    kind[3] = dhgen_kind_within_wide(q[9], outside_pm);
    const dhgen_wide_mask exact = 0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] * T[11] *
        T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v1 <= m1) | (v2 <= m1)) | (dhgen_within_slack_wide(excess_p) |
        dhgen_within_slack_wide(excess_m));
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
    const dhgen_four e2 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double v1 = T14 * T14 + T24 * T24, v2 = copysign(DHGEN_HALF_TURN, -T24);

    /* theta2, r3 */
    const double v3 = v1 + T34 * T34, w3 = sqrt(v3), v4 = copysign(DHGEN_HALF_TURN, -sqrt(v1));

    /* joint values */
    const dhgen_four q3 = e2 * w3, excess = per_size * dhgen_beyond_four(q3, joints + 2);
    const dhgen_four_mask outside = 0.0 < excess;

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] *
        T[11] * T[11])) <= DHGEN_ORTHONORMAL) == 0) | dhgen_within_slack_four(excess)) |
        (unsigned)((v1 <= m1) | (v3 <= m1)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-T24, -sqrt(v1), -T24, -T24),
        dhgen_four_of(-T14, T34, -T14, -T14));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1);
    const dhgen_four q1 = angle1 + v2 * (m2 * (e1 - 1.0)), q2_ = angle2 + v4 * (m2 * (e2 - 1.0)),
        q2 = e1 * q2_;

    dhgen_store_2(q, q + 3, q + 6, q + 9, q1, q2);
    dhgen_store_1(q + 2, q + 5, q + 8, q + 11, q3);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long outside1 = (dhgen_bits_four(outside) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE + (outside1 & ~none1) *
        DHGEN_OUT_OF_LIMITS;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~(none1 | outside1));
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[3] = { 3, 7, 11 };
DHGEN_TABLE int choosable[2] = { 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 4, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 1.333, 1.333, 1.333, 0.0, 0.0, 0.0 }, 1.3333333333333333, { 1e-14, 1e-14 }, entries, 3,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, stewart_leg_fk,
    stewart_leg_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) stewart_leg_##function
#include "dhgen/functions.h"

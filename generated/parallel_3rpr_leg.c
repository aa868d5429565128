/* parallel_3rpr_leg: Planar platform on three cylinders (3-RPR): a leg
 *
 * Inverse kinematics, generated from robots/parallel_3rpr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/parallel_3rpr.yaml. The formulas and where they come from:
 * parallel_3rpr_leg.md, of a leg of parallel_3rpr.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 07c20b2bc6956a7a
 * SPDX-License-Identifier: MIT
 */
#include "parallel_3rpr_leg.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(PARALLEL_3RPR_LEG_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(PARALLEL_3RPR_LEG_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 2
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef PARALLEL_3RPR_LEG_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    free_limit1 = 1.6e-12; /* a length that fixes no angle [m] */

#ifndef __CUDACC_RTC__
const char *const parallel_3rpr_leg_branches[2] = {
    "forward", "backward",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[2] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { 0.3, 1.6, 1.6e-09, 0.39062499999999994, 1.6, 0.040625, 0 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[2][4] = {
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 2, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 4

DHGEN_PUBLIC void parallel_3rpr_leg_fk(const double q[2], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    T[0] = c1; T[1] = 0.0; T[2] = s1; T[3] = s1 * q[1];
    T[4] = s1; T[5] = 0.0; T[6] = -c1; T[7] = -(c1 * q[1]);
    T[8] = 0.0; T[9] = 1.0; T[10] = 0.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void parallel_3rpr_leg_jacobian(const double q[2], double J[12])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    J[0] = c1 * q[1]; J[1] = s1;
    J[2] = s1 * q[1]; J[3] = -c1;
    J[4] = 0.0; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0;
    J[10] = 1.0; J[11] = 0.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[2] = (double (*)[2])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, r2, type 4: U0[1, 4] and U0[2, 4] */
    const double w2 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w2 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w2;

    for (int i1 = 0; i1 < 2; i1++) { /* forward, backward */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1, r2 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(T24 * factor1),
            s1 = free1 ? sin(seed[0]) : T14 * factor1;
        const double q1 = atan2(s1, c1);
        const double r2 = w2 * e1;
        const int row = i1;
        q[row][0] = q1; q[row][1] = r2;
        status[row] = free1 ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

#ifndef PARALLEL_3RPR_LEG_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.00016 [m]. */
static const double
    per_size = 0.625, /* slides beyond limits count in the arm's size [m^-1] */
    m1 = 2.5600000000000004e-08; /* doubt_limit1^2 [m^2] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1, r2 */
    const dhgen_wide v1 = T14 * T14 + T24 * T24, q2_p = dhgen_sqrt_wide(v1),
        angle1 = dhgen_atan2_wide(T14, -T24);

    /* joint values */
    const dhgen_wide excess_p = per_size * dhgen_beyond_wide(q2_p, joints + 1),
        excess_m = per_size * dhgen_maximum_wide(dhgen_low(joints + 1) + q2_p, -(dhgen_high(joints +
            1) + q2_p));

    q[0] = angle1; q[1] = q2_p;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_p);
    q[2] = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, T14); q[3] = -q2_p;
    kind[1] = dhgen_kind_within_wide(q[2], 0.0 < excess_m);
    const dhgen_wide_mask exact = 0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | (v1 <= m1) | (dhgen_within_slack_wide(excess_p) |
        dhgen_within_slack_wide(excess_m));
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

    /* theta1, r2 */
    const double v1 = T14 * T14 + T24 * T24, w2 = sqrt(v1), v2 = copysign(DHGEN_HALF_TURN, T14);

    /* joint values */
    const dhgen_four q2 = e1 * w2, excess = per_size * dhgen_beyond_four(q2, joints + 1);
    const dhgen_four_mask outside = 0.0 < excess;

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7])) <=
        DHGEN_ORTHONORMAL) == 0) | dhgen_within_slack_four(excess)) | (unsigned)(v1 <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(T14, T14, T14, T14),
        dhgen_four_of(-T24, -T24, -T24, -T24));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0);
    const dhgen_four q1 = angle1 + v2 * (m2 * (e1 - 1.0));

    dhgen_store_2(q, q + 2, q, q + 2, q1, q2);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x81ull & 0x101ull);
    const unsigned long long outside1 = (dhgen_bits_four(outside) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE + (outside1 & ~none1) *
        DHGEN_OUT_OF_LIMITS;
    __builtin_memcpy(status, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~(none1 | outside1));
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[2] = { 3, 7 };
DHGEN_TABLE int choosable[1] = { 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    2, 2, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 0.625, 0.625, 0.0, 0.0, 0.0, 0.0 }, 0.625, { 1e-14, 1e-14 }, entries, 2,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL,
    parallel_3rpr_leg_fk, parallel_3rpr_leg_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) parallel_3rpr_leg_##function
#include "dhgen/functions.h"

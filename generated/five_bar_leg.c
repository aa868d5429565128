/* five_bar_leg: Planar five-bar linkage (RR legs): a leg
 *
 * Inverse kinematics, generated from robots/five_bar.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/five_bar.yaml. The formulas and where they come from:
 * five_bar_leg.md, of a leg of five_bar.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 5e95f08d2a024264
 * SPDX-License-Identifier: MIT
 */
#include "five_bar_leg.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(FIVE_BAR_LEG_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(FIVE_BAR_LEG_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 2
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef FIVE_BAR_LEG_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    crank = 0.2, /* link length 1 [m] */
    rod = 0.3, /* link length 2 [m] */
    longest2 = 0.25, /* square of the longest reach [m^2] */
    shortest2 = 0.009999999999999995, /* square of the shortest reach [m^2] */
    longest2_reach = 0.25000000000004996, /* the longest, with what rounding adds [m^2] */
    shortest2_reach = 0.009999999999989996, /* the shortest, with what rounding adds [m^2] */
    longest2_apart = 0.249999999999995, /* the longest, where branches merge [m^2] */
    shortest2_apart = 0.010000000000000994, /* the shortest, where branches merge [m^2] */
    k1 = 0.13, /* crank^2 + rod^2 [m^2] */
    k2 = 8.333333333333334; /* 1 / (2 * rod * crank) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const five_bar_leg_branches[2] = {
    "right", "left",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[2] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[2][4] = {
    { 0.0, 0.0, 0.2, 0.0 },
    { 0.0, 0.0, 0.3, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 2, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 4

DHGEN_PUBLIC void five_bar_leg_fk(const double q[2], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    T[0] = x2_x; T[1] = -x2_y; T[2] = 0.0; T[3] = c1 * crank + x2_x * rod;
    T[4] = x2_y; T[5] = x2_x; T[6] = 0.0; T[7] = s1 * crank + x2_y * rod;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void five_bar_leg_jacobian(const double q[2], double J[12])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * crank, p1_y = s1 * crank;
    const double c2 = cos(q[1]), s2 = sin(q[1]), p2_x = p1_x + (c1 * c2 - s1 * s2) * rod,
        p2_y = p1_y + (s1 * c2 + c1 * s2) * rod;
    J[0] = -p2_y; J[1] = p1_y - p2_y;
    J[2] = p2_x; J[3] = p2_x - p1_x;
    J[4] = 0.0; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0;
    J[10] = 1.0; J[11] = 1.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[2] = (double (*)[2])rows;
    (void)free_joints; (void)seed; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta2, type 8: U0[1, 4] and U0[2, 4] */
    const double N2 = T14 * T14 + T24 * T24;
    const double K2 = N2 - k1;
    const double D2_squared = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) return; /* out of reach */
    const double w2 = sqrt(apart2 ? D2_squared : 0.0);
    const double c2 = K2 * k2;

    /* theta1, type 3: U0[2, 4] and U0[1, 4] */
    const double X1_1 = crank + rod * c2;
    const double v1 = T24 * X1_1, v2 = T14 * X1_1;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e2 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e2 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e2 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = rod * s2;
        const double S1 = v1 - T14 * Y1_1;
        const double C1 = v2 + T24 * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const double factor1 = 1.0 / w1;
        const double c1 = C1 * factor1, s1 = S1 * factor1;
        const double q1 = atan2(s1, c1);
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2;
        status[row] = DHGEN_OK;
    }
}

#ifndef FIVE_BAR_LEG_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
static const double
    /* 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4] */
    m1 = 1.1990408665951442e-12,
    m2 = 2.5, /* rod * k2 [m^-1] */
    m3 = 0.125; /* rod * k1 * k2 - crank [m] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta2 */
    const dhgen_wide N2 = T14 * T14 + T24 * T24, D2_squared = (longest2 - N2) * (N2 - shortest2),
        w2 = dhgen_sqrt_wide(D2_squared), angle1 = dhgen_atan2_wide(w2, N2 - k1);

    /* theta1 */
    const dhgen_wide v1 = m2 * N2 - m3, v2 = T24 * v1, v3 = T14 * v1, v4 = w2 * (m2 * T14),
        v5 = w2 * (m2 * T24);

    q[0] = dhgen_atan2_wide(v2 - v4, v3 + v5); q[1] = angle1;
    kind[0] = dhgen_kind_wide(q[0]);
    q[2] = dhgen_atan2_wide(v2 + v4, v3 - v5); q[3] = -angle1;
    kind[1] = dhgen_kind_wide(q[2]);
    const dhgen_wide_mask exact = 0.0 * (T[3] + T[7]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | (dhgen_abs_wide(D2_squared) <= m1);
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

    /* theta2 */
    const double N2 = T14 * T14 + T24 * T24, D2_squared = (longest2 - N2) * (N2 - shortest2),
        w2 = sqrt(D2_squared);

    /* theta1 */
    const double v1 = m2 * N2 - m3, v2 = T24 * v1, v3 = T14 * v1;

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] + T[7])) <= DHGEN_ORTHONORMAL) == 0)) |
        (unsigned)(fabs(D2_squared) <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(v2 - w2 * (m2 * (e2 * T14)),
        dhgen_all_four(w2), 0, 1, 6, 3), dhgen_shuffle(v3 + w2 * (m2 * (e2 * T24)),
        dhgen_all_four(N2 - k1), 0, 1, 6, 3));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle2 = dhgen_shuffle(packed1, packed1, 0, 1, 0, 1),
        angle1 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2);
    const dhgen_four q2 = e2 * angle1;

    dhgen_store_2(q, q + 2, q, q + 2, angle2, q2);
    const unsigned long long none1 = (dhgen_bits_four(angle2 != angle2) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[2] = { 3, 7 };
DHGEN_TABLE struct dhgen_arm arm = {
    2, 2, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 2.0, 2.0, 0.0, 0.0, 0.0, 0.0 }, 2.0, { 1e-14, 1e-14 }, entries, 2,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    1, /* follows seed */ NULL, NULL, NULL, NULL, five_bar_leg_fk, five_bar_leg_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) five_bar_leg_##function
#include "dhgen/functions.h"

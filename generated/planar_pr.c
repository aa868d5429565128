/* planar_pr: Inclined slider with a revolute link
 *
 * Inverse kinematics, generated from robots/planar_pr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/planar_pr.yaml. The formulas and where they come from:
 * planar_pr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: a30db3c244a1600f
 * SPDX-License-Identifier: MIT
 */
#include "planar_pr.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(PLANAR_PR_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(PLANAR_PR_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 2
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef PLANAR_PR_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, sqrt3 = 1.7320508075688772, reach_slack = 1e-13, merge_slack = 1e-14. */
static const double
    a = 0.3, /* x of the home pose [m] */
    k1 = 3.3333333333333335, /* 1 / a [m^-1] */
    k2 = 1.6666666666666667, /* 1 / 2 * 1 / a [m^-1] */
    k3 = 2.8867513459481287, /* sqrt3 * 1 / 2 * 1 / a [m^-1] */
    k4 = 11.11111111111111, /* k2^2 + k3^2 [m^-2] */
    k5 = 2.2222222222222224e-12, /* 2 * k4 * reach_slack [m^-2] */
    k6 = 2.2222222222222222e-13, /* 2 * k4 * merge_slack [m^-2] */
    k7 = 0.09, /* 1 / k4 [m^2] */
    f1 = 0.5, /* 1 / 2 */
    f2 = 0.8660254037844386, /* 1 / 2 * sqrt3 */
    f3 = 0.9999999999999999; /* f1^2 + f2^2 */

#ifndef __CUDACC_RTC__
const char *const planar_pr_branches[2] = {
    "forward", "backward",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[2] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 3e-10, 11.11111111111111, 0.3, 0.02945243112740431, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The axes at q = 0: a unit vector along each, and a point of it [m]. */
DHGEN_TABLE double table[2][6] = {
    { 0.8660254037844386, 0.5, 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE double tool[12] = { 1.0, 0.0, 0.0, 0.3, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0 };
DHGEN_TABLE struct dhgen_links links = { 2, DHGEN_AXES, joints, &table[0][0], NULL, NULL, tool };
#define DHGEN_FRAMES 4

DHGEN_PUBLIC void planar_pr_fk(const double q[2], double T[16])
{
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = f3 * c2, x2_y = f3 * s2;
    T[0] = x2_x; T[1] = -x2_y; T[2] = 0.0; T[3] = f2 * q[0] + x2_x * a;
    T[4] = x2_y; T[5] = x2_x; T[6] = 0.0; T[7] = f1 * q[0] + x2_y * a;
    T[8] = 0.0; T[9] = 0.0; T[10] = 1.0; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void planar_pr_jacobian(const double q[2], double J[12])
{
    const double p1_x = f2 * q[0], p1_y = f1 * q[0];
    const double c2 = cos(q[1]), s2 = sin(q[1]);
    J[0] = f2; J[1] = p1_y - (p1_y + f3 * s2 * a);
    J[2] = f1; J[3] = p1_x + f3 * c2 * a - p1_x;
    J[4] = 0.0; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0;
    J[10] = 0.0; J[11] = 1.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[2] = (double (*)[2])rows;
    (void)free_joints; (void)seed; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta2, r1, type 5: U0[2, 4] and U0[1, 4] */
    const double V1_2 = T24 * k1;
    const double V2_2 = T14 * k1;
    const double v1 = V1_2 * k2 + V2_2 * k3, v2 = k2 * V2_2 - V1_2 * k3;
    const double D1_squared = k4 - v2 * v2;
    const int apart2 = k6 < D1_squared;
    if (!(-k5 <= D1_squared)) return; /* out of reach */
    const double w2 = sqrt(apart2 ? D1_squared : 0.0);

    for (int i1 = 0; i1 < 2; i1++) { /* forward, backward */
        const double e2 = i1 == 0 ? 1.0 : -1.0;
        /* theta2, r1 */
        if (e2 < 0.0 && !apart2) continue; /* both signs give the same */
        const double r1 = (v1 + w2 * e2) * k7;
        const double s2 = V1_2 - k2 * r1, c2 = V2_2 - k3 * r1;
        const double q2 = atan2(s2, c2);
        const int row = i1;
        q[row][0] = r1; q[row][1] = q2;
        status[row] = DHGEN_OK;
    }
}

#ifndef PLANAR_PR_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
static const double
    m1 = 2.2222222222222221e-10, /* 1000 * k6 [m^-2] */
    m2 = 0.15, /* k2 * k7 [m] */
    m3 = 0.25980762113533157; /* k3 * k7 [m] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta2, r1 */
    const dhgen_wide V1_2 = k1 * T24, V2_2 = k1 * T14, v1 = k2 * V1_2 + k3 * V2_2,
        v2 = k2 * V2_2 - k3 * V1_2, D1_squared = k4 - v2 * v2, w2 = dhgen_sqrt_wide(D1_squared),
        v3 = V1_2 - m2 * v1, v4 = V2_2 - m3 * v1, v5 = m2 * w2, v6 = m3 * w2;

    q[0] = k7 * (v1 + w2); q[1] = dhgen_atan2_wide(v3 - v5, v4 - v6);
    kind[0] = dhgen_kind_wide(q[0]);
    q[2] = k7 * (v1 - w2); q[3] = dhgen_atan2_wide(v3 + v5, v4 + v6);
    kind[1] = dhgen_kind_wide(q[2]);
    const dhgen_wide_mask exact = 0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | (dhgen_abs_wide(D1_squared) <= m1);
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

    /* theta2, r1 */
    const double V1_2 = k1 * T24, V2_2 = k1 * T14, v1 = k2 * V1_2 + k3 * V2_2,
        v2 = k2 * V2_2 - k3 * V1_2, D1_squared = k4 - v2 * v2, w2 = sqrt(D1_squared);
    const dhgen_four q1 = k7 * (v1 + e2 * w2);
    const double v3 = V1_2 - m2 * v1, v4 = V2_2 - m3 * v1;

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7])) <=
        DHGEN_ORTHONORMAL) == 0)) | (unsigned)(fabs(D1_squared) <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(v3 - w2 * (m2 * e2), v4 - w2 * (m3 * e2));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 1, 0, 1);

    dhgen_store_2(q, q + 2, q, q + 2, q1, angle1);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x81ull & 0x101ull);
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
    { 3.333, 3.333, 0.0, 0.0, 0.0, 0.0 }, 3.3333333333333335, { 1e-14, 1e-14 }, entries, 2,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    1, /* follows seed */ NULL, NULL, NULL, NULL, planar_pr_fk, planar_pr_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) planar_pr_##function
#include "dhgen/functions.h"

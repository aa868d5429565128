/* cylindrical: Cylindrical arm, vertical slide first
 *
 * Inverse kinematics, generated from robots/cylindrical.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/cylindrical.yaml. The formulas and where they come from:
 * cylindrical.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 97ba4b4fa6b0ae87
 * SPDX-License-Identifier: MIT
 */
#include "cylindrical.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(CYLINDRICAL_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(CYLINDRICAL_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 1
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef CYLINDRICAL_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.3, /* joint offset 1 [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 3e-06; /* a pose may be rounded by this [m] */

#ifndef __CUDACC_RTC__
const char *const cylindrical_branches[1] = {
    "only",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 3e-10, 11.11111111111111, 0.3, 0.02945243112740431, 0 },
    { -HUGE_VAL, HUGE_VAL, 3e-10, 11.11111111111111, 0.3, 0.02945243112740431, 0 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.3, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void cylindrical_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    T[0] = c1; T[1] = 0.0; T[2] = -s1; T[3] = -(s1 * q[2]);
    T[4] = s1; T[5] = 0.0; T[6] = c1; T[7] = c1 * q[2];
    T[8] = 0.0; T[9] = -1.0; T[10] = 0.0; T[11] = d1 + q[1];
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void cylindrical_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    J[0] = -(c1 * q[2]); J[1] = 0.0; J[2] = -s1;
    J[3] = -(s1 * q[2]); J[4] = 0.0; J[5] = c1;
    J[6] = 0.0; J[7] = 1.0; J[8] = 0.0;
    J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
    J[15] = 1.0; J[16] = 0.0; J[17] = 0.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    (void)free_joints; (void)seed; (void)moved;
    DHGEN_ENTRIES(double);

    /* r2, type 1: U0[3, 4] */
    const double r2 = T34 - d1;

    /* theta1, type 3: U0[2, 1] and U0[1, 1] */
    const double w1 = sqrt(T21 * T21 + T11 * T11);
    const int short1 = w1 <= free_limit;
    const double v1 = 1.0 / (short1 ? 1.0 : w1);
    const double c1 = T11 * v1, s1 = T21 * v1;
    const double q1 = atan2(s1, c1);

    /* r3, type 1: U1[2, 4] */
    const double r3 = c1 * T24 - s1 * T14;

    /* is the pose one that the arm can take? */
    if (!(fabs(T34 - (d1 + r2)) <= pose_slack1 && fabs(T33) <= pose_slack && fabs(T31) <= pose_slack
        && fabs(T24 - c1 * r3) <= pose_slack1 && fabs(T23 - c1) <= pose_slack && fabs(T21 - s1) <=
        pose_slack && fabs(T14 + s1 * r3) <= pose_slack1 && fabs(T11 - c1) <= pose_slack && fabs(T13
        + s1) <= pose_slack))
        return; /* the arm can't take this pose */
    const int row = 0;
    q[row][0] = q1; q[row][1] = r2; q[row][2] = r3;
    status[row] = DHGEN_OK;
}

#ifndef CYLINDRICAL_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
static const double
    m1 = 9.000000000000001e-12, /* pose_slack1^2 [m^2] */
    m2 = 1.0000000000000002e-10; /* pose_slack^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* r2 */
    const dhgen_wide q2 = T34 - d1;

    /* theta1 */
    const dhgen_wide v1 = T21 * T21 + T11 * T11, w1 = dhgen_sqrt_wide(v1),
        v2 = DHGEN_QUOTIENT(1.0, v1), v3 = w1 * v2, c1 = T11 * v3, s1 = T21 * v3;

    /* r3 */
    const dhgen_wide q3 = w1 * (v2 * (T11 * T24 - T21 * T14));

    /* is the pose one that the arm can take? */
    const dhgen_wide v4 = T34 - (d1 + q2), v5 = T24 - c1 * q3, v6 = T23 - c1, v7 = T14 + s1 * q3,
        v8 = s1 + T13, v9 = v1 - 1.0;

    q[0] = dhgen_atan2_wide(T21, T11); q[1] = q2; q[2] = q3;
    kind[0] = dhgen_kind_wide(q[0]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((m1 < v4 * v4 + v5 * v5 + v7 * v7) | (m2 < T33 * T33 + T31 * T31 + v6 *
        v6 + v8 * v8 + v9 * v9));
}

#if DHGEN_LANES > 1
/* One regular pose. Returns how many rows are OK, or -1 if the pose has to be left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    DHGEN_ENTRIES(double);

    /* r2 */
    const double q2 = T34 - d1;

    /* theta1 */
    const double v1 = T21 * T21 + T11 * T11, w1 = sqrt(v1), v2 = DHGEN_QUOTIENT(1.0, v1),
        v3 = w1 * v2, c1 = T11 * v3, s1 = T21 * v3;

    /* r3 */
    const double q3 = w1 * (v2 * (T11 * T24 - T21 * T14));

    /* is the pose one that the arm can take? */
    const double v4 = T34 - (d1 + q2), v5 = T24 - c1 * q3, v6 = T23 - c1, v7 = T14 + s1 * q3,
        v8 = s1 + T13, v9 = v1 - 1.0;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)((m1 <
        v4 * v4 + v5 * v5 + v7 * v7) | (m2 < T33 * T33 + T31 * T31 + v6 * v6 + v8 * v8 + v9 * v9)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(T21, T21, T21, T21),
        dhgen_four_of(T11, T11, T11, T11));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0);

    dhgen_store_2(q, q, q, q, angle1, dhgen_all_four(q2));
    dhgen_store_1(q + 2, q + 2, q + 2, q + 2, dhgen_all_four(q3));
    const unsigned long long none1 = (dhgen_bits_four(angle1 != angle1) * 0x1ull & 0x1ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 1);
    return __builtin_popcountll(0x1ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 1, 0, DHGEN_POSE, joints, NULL, 0,
    { 3.333, 3.333, 3.333, 1.0, 1.0, 1.0 }, 3.3333333333333335, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    1, /* follows seed */ NULL, NULL, NULL, NULL, cylindrical_fk, cylindrical_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) cylindrical_##function
#include "dhgen/functions.h"

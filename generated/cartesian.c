/* cartesian: Cartesian arm
 *
 * Inverse kinematics, generated from robots/cartesian.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/cartesian.yaml. The formulas and where they come from:
 * cartesian.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 274f14e086929f69
 * SPDX-License-Identifier: MIT
 */
#include "cartesian.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(CARTESIAN_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(CARTESIAN_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 1
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef CARTESIAN_PLAIN
#include "dhgen/tile.h"
#endif

#ifndef __CUDACC_RTC__
const char *const cartesian_branches[1] = {
    "only",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { 0.0, 0.8, 1.2e-09, 0.6944444444444444, 1.2, 0.025, 0 },
    { 0.0, 0.6, 1.2e-09, 0.6944444444444444, 1.2, 0.01875, 0 },
    { 0.0, 1.2, 1.2e-09, 0.6944444444444444, 1.2, 0.0375, 0 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { -1.5707963267948966, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void cartesian_fk(const double q[3], double T[16])
{
    T[0] = 0.0; T[1] = 0.0; T[2] = 1.0; T[3] = q[2];
    T[4] = 0.0; T[5] = -1.0; T[6] = 0.0; T[7] = q[1];
    T[8] = 1.0; T[9] = 0.0; T[10] = 0.0; T[11] = q[0];
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void cartesian_jacobian(const double q[3], double J[18])
{
    (void)q;
    J[0] = 0.0; J[1] = 0.0; J[2] = 1.0;
    J[3] = 0.0; J[4] = 1.0; J[5] = 0.0;
    J[6] = 1.0; J[7] = 0.0; J[8] = 0.0;
    J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0;
    J[15] = 0.0; J[16] = 0.0; J[17] = 0.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    (void)free_joints; (void)seed; (void)moved;
    DHGEN_ENTRIES(double);

    const int row = 0;
    q[row][0] = T34; q[row][1] = T24; q[row][2] = T14;
    status[row] = DHGEN_OK;
}

#ifndef CARTESIAN_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
static const double
    per_size = 0.8333333333333334; /* slides beyond limits count in the arm's size [m^-1] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    q[0] = T34; q[1] = T24; q[2] = T14;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < dhgen_maximum_wide(per_size *
        dhgen_beyond_wide(T14, joints + 2), dhgen_maximum_wide(per_size * dhgen_beyond_wide(T34,
        joints), per_size * dhgen_beyond_wide(T24, joints + 1))));
    const dhgen_wide_mask exact = 0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] * T[11] *
        T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0);
}

#if DHGEN_LANES > 1
/* One regular pose. Returns how many rows are OK, or -1 if the pose has to be left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    DHGEN_ENTRIES(double);

    /* joint values */
    const int outside = 0.0 < dhgen_maximum_double(per_size * dhgen_maximum_double(dhgen_low(joints
        + 2) - T14, T14 - dhgen_high(joints + 2)), dhgen_maximum_double(per_size *
        dhgen_maximum_double(dhgen_low(joints) - T34, T34 - dhgen_high(joints)), per_size *
        dhgen_maximum_double(dhgen_low(joints + 1) - T24, T24 - dhgen_high(joints + 1))));

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] *
        T[11] * T[11])) <= DHGEN_ORTHONORMAL) == 0)))
        return -1;


    dhgen_store_2(q, q, q, q, dhgen_all_four(T34), dhgen_all_four(T24));
    dhgen_store_1(q + 2, q + 2, q + 2, q + 2, dhgen_all_four(T14));
    const unsigned long long none1 = (dhgen_bits_four(dhgen_all_four(T34) != dhgen_all_four(T34)) *
        0x1ull & 0x1ull);
    const unsigned long long outside1 = (dhgen_bits_four(dhgen_where_four(outside)) * 0x1ull &
        0x1ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE + (outside1 & ~none1) *
        DHGEN_OUT_OF_LIMITS;
    __builtin_memcpy(status, &kind1, 1);
    return __builtin_popcountll(0x1ull & ~(none1 | outside1));
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[3] = { 3, 7, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 1, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 0.8333, 0.8333, 0.8333, 0.0, 0.0, 0.0 }, 0.8333333333333334, { 1e-14, 1e-14 }, entries, 3,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    0, /* follows seed */ NULL, NULL, NULL, NULL, cartesian_fk, cartesian_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) cartesian_##function
#include "dhgen/functions.h"

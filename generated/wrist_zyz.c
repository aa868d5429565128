/* wrist_zyz: Spherical wrist, axes z, y, z
 *
 * Inverse kinematics, generated from robots/wrist_zyz.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/wrist_zyz.yaml. The formulas and where they come from:
 * wrist_zyz.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: cd9df4ea64fe3e1e
 * SPDX-License-Identifier: MIT
 */
#include "wrist_zyz.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(WRIST_ZYZ_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(WRIST_ZYZ_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef WRIST_ZYZ_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    free_limit = 1e-12; /* a length that fixes no angle */

#ifndef __CUDACC_RTC__
const char *const wrist_zyz_branches[2] = {
    "noflip", "flip",
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
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void wrist_zyz_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2;
    const double c3 = cos(q[2]), s3 = sin(q[2]);
    T[0] = x2_x * c3 - s1 * s3; T[1] = -(s1 * c3 + x2_x * s3); T[2] = -(c1 * s2); T[3] = 0.0;
    T[4] = x2_y * c3 + c1 * s3; T[5] = c1 * c3 - x2_y * s3; T[6] = -(s1 * s2); T[7] = 0.0;
    T[8] = s2 * c3; T[9] = -(s2 * s3); T[10] = c2; T[11] = 0.0;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void wrist_zyz_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]);
    J[0] = 0.0; J[1] = 0.0; J[2] = 0.0;
    J[3] = 0.0; J[4] = 0.0; J[5] = 0.0;
    J[6] = 0.0; J[7] = 0.0; J[8] = 0.0;
    J[9] = 0.0; J[10] = s1; J[11] = -(c1 * s2);
    J[12] = 0.0; J[13] = -c1; J[14] = -(s1 * s2);
    J[15] = 1.0; J[16] = 0.0; J[17] = c2;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[3, 3] */
    const double w1 = sqrt(T13 * T13 + T23 * T23);
    const int free1 = w1 <= free_limit;
    const double divisor1 = free1 ? 1.0 : w1;

    for (int i1 = 0; i1 < 2; i1++) { /* noflip, flip */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : T13 * factor1,
            s1 = free1 ? sin(seed[0]) : T23 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta2, type 3: U1[2, 3] and U1[1, 3] */
        const double q2 = atan2(-(w1 * e1), T33);

        /* theta3, type 3: U1[3, 2] and U1[3, 1] */
        const double s3 = T21 * c1 - T11 * s1, c3 = T22 * c1 - T12 * s1;
        const double q3 = atan2(s3, c3);
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
        status[row] = free1 ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

#ifndef WRIST_ZYZ_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T13 * T13 + T23 * T23, angle1 = dhgen_atan2_wide(T23, T13);

    /* theta2 */
    const dhgen_wide angle2 = dhgen_atan2_wide(-dhgen_sqrt_wide(v1), T33);

    /* theta3 */
    const dhgen_wide s3 = T13 * T21 - T23 * T11,
        angle3 = dhgen_atan2_wide(s3, T13 * T22 - T23 * T12);

    q[0] = angle1; q[1] = angle2; q[2] = angle3;
    kind[0] = dhgen_kind_wide(q[0]);
    q[3] = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, T23); q[4] = -angle2;
    q[5] = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, s3);
    kind[1] = dhgen_kind_wide(q[3]);
    const dhgen_wide_mask exact = dhgen_misfit_wide(T) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | (v1 <= m1);
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

    /* theta1 */
    const double v1 = T13 * T13 + T23 * T23, v2 = copysign(DHGEN_HALF_TURN, T23);
    const dhgen_four v3 = m2 * (e1 - 1.0);

    /* theta3 */
    const double s3 = T13 * T21 - T23 * T11, v4 = copysign(DHGEN_HALF_TURN, s3);

    if (dhgen_bits_four(((dhgen_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)(v1 <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(T23, -sqrt(v1), s3, T23),
        dhgen_four_of(T13, T33, T13 * T22 - T23 * T12, T13));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2);
    const dhgen_four q1 = angle1 + v2 * v3, q3 = angle3 + v3 * v4, q2 = e1 * angle2;

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

DHGEN_TABLE int entries[6] = { 0, 2, 4, 6, 8, 10 };
DHGEN_TABLE int choosable[1] = { 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 2, 0, DHGEN_ROTATION, joints, NULL, 0,
    { 0.0, 0.0, 0.0, 1.0, 1.0, 1.0 }, 1.0, { 1e-14, 1e-14 }, entries, 6,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, wrist_zyz_fk,
    wrist_zyz_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) wrist_zyz_##function
#include "dhgen/functions.h"

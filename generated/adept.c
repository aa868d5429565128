/* adept: Adept SCARA
 *
 * Inverse kinematics, generated from robots/adept.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/adept.yaml. The formulas and where they come from: adept.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: ab976a3980df600e
 * SPDX-License-Identifier: MIT
 */
#include "adept.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(ADEPT_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(ADEPT_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 1
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef ADEPT_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 1075.0, /* joint offset 1 [mm] */
    l1 = 600.0, /* link length 1 [mm] */
    l2 = 550.0, /* link length 2 [mm] */
    zz = 500.0, /* z of the base frame [mm] */
    ez = 175.0, /* z of the tool frame [mm] */
    free_limit = 1e-12, /* a length that fixes no angle */
    free_limit2 = 5.76e-06, /* a length that fixes no angle [mm^2] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 0.024; /* a pose may be rounded by this [mm] */

#ifndef __CUDACC_RTC__
const char *const adept_branches[1] = {
    "only",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 2.4e-06, 1.7361111111111112e-07, 2400.0, 235.61944901923448, 0 },
};

/* The table at q = 0, standard: theta [rad], d [mm], a [mm], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 1075.0, 600.0, 0.0 },
    { 0.0, 0.0, 550.0, 3.141592653589793 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE double base[12] = { 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 500.0 };
DHGEN_TABLE double tool[12] = { 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 175.0 };
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, base, tool
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void adept_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_y = c1 * c2 - s1 * s2, x2_z = s1 * c2 + c1 * s2;
    T[0] = 0.0; T[1] = 0.0; T[2] = -1.0; T[3] = d1 - q[2] - ez;
    T[4] = -x2_z; T[5] = x2_y; T[6] = 0.0; T[7] = c1 * l1 + x2_y * l2;
    T[8] = x2_y; T[9] = x2_z; T[10] = 0.0; T[11] = zz + s1 * l1 + x2_z * l2;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void adept_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_y = c1 * l1, p1_z = zz + s1 * l1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), p2_y = p1_y + (c1 * c2 - s1 * s2) * l2,
        p2_z = p1_z + (s1 * c2 + c1 * s2) * l2;
    J[0] = 0.0; J[1] = 0.0; J[2] = -1.0;
    J[3] = zz - p2_z; J[4] = p1_z - p2_z; J[5] = 0.0;
    J[6] = p2_y; J[7] = p2_y - p1_y; J[8] = 0.0;
    J[9] = 1.0; J[10] = 1.0; J[11] = 0.0;
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

    /* r3, type 1: U0[3, 4] */
    const double t34 = T14 - ez * T13;
    const double r3 = d1 - t34;

    /* theta12, type 3: U0[2, 1] and U0[1, 1] */
    const double w12 = sqrt(T32 * T32 + T22 * T22);
    const int short12 = w12 <= free_limit;
    const double v1 = 1.0 / (short12 ? 1.0 : w12);
    const double c12 = T22 * v1, s12 = T32 * v1;

    /* theta1, type 3: U0[1, 4] and U0[2, 4] */
    const double t14 = T24 - ez * T23;
    const double v2 = c12 * l2;
    const double t24 = T34 - ez * T33 - zz;
    const double v3 = s12 * l2, v4 = l1 * (t24 - v3), v5 = l1 * (t14 - v2);
    const double w1 = sqrt(v4 * v4 + v5 * v5);
    const int short1 = w1 <= free_limit2;
    const double v6 = 1.0 / (short1 ? 1.0 : w1);
    const double c1 = v5 * v6, s1 = v4 * v6;
    const double q1 = atan2(s1, c1);

    /* is the pose one that the arm can take? */
    if (!(fabs(t34 - (d1 - r3)) <= pose_slack1 && fabs(1.0 + T13) <= pose_slack && fabs(T12) <=
        pose_slack && fabs(t24 - (v3 + l1 * s1)) <= pose_slack1 && fabs(T33) <= pose_slack &&
        fabs(T32 - s12) <= pose_slack && fabs(t14 - (v2 + l1 * c1)) <= pose_slack1 && fabs(T22 -
        c12) <= pose_slack && fabs(T23) <= pose_slack))
        return; /* the arm can't take this pose */

    /* joint values */
    const double q2 = dhgen_wrap(atan2(s12, c12) - q1);
    const int row = 0;
    q[row][0] = q1; q[row][1] = q2; q[row][2] = r3;
    status[row] = DHGEN_OK;
}

#ifndef ADEPT_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit2 = 576.0 [mm^2]. */
static const double
    m1 = 330000.0, /* l1 * l2 [mm^2] */
    m2 = 600.0, /* l1 [mm] */
    m3 = 331776.0, /* doubt_limit2^2 [mm^4] */
    m4 = 0.000576, /* pose_slack1^2 [mm^2] */
    m5 = 1.0000000000000002e-10; /* pose_slack^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* r3 */
    const dhgen_wide t34 = T14 - ez * T13, q3 = d1 - t34;

    /* theta12 */
    const dhgen_wide v1 = T32 * T32 + T22 * T22, w12 = dhgen_sqrt_wide(v1),
        v2 = DHGEN_QUOTIENT(1.0, v1), v3 = w12 * v2;

    /* theta1 */
    const dhgen_wide t14 = T24 - ez * T23, t24 = T34 - ez * T33 - zz,
        v4 = m2 * t24 - w12 * (m1 * (T32 * v2)), v5 = m2 * t14 - w12 * (m1 * (T22 * v2)),
        v6 = v4 * v4 + v5 * v5, v7 = dhgen_sqrt_wide(v6) * DHGEN_QUOTIENT(1.0, v6),
        angle1 = dhgen_atan2_wide(v4, v5);

    /* is the pose one that the arm can take? */
    const dhgen_wide v8 = t34 - (d1 - q3), v9 = T13 + 1.0,
        v10 = t24 - (l2 * (T32 * v3) + l1 * (v4 * v7)),
        v11 = t14 - (l2 * (T22 * v3) + l1 * (v5 * v7)), v12 = v1 - 1.0;

    /* joint values */
    const dhgen_wide angle2 = dhgen_atan2_wide(T32, T22), v13 = angle2 - angle1;

    q[0] = angle1; q[1] = dhgen_centred_wide(v13); q[2] = q3;
    kind[0] = dhgen_kind_wide(q[0]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((m4 < v8 * v8 + v10 * v10 + v11 * v11) | (m5 < v9 * v9 + T12 * T12 + T33
        * T33 + T23 * T23 + v12 * v12) | (v6 <= m3));
}

#if DHGEN_LANES > 1
/* One regular pose. Returns how many rows are OK, or -1 if the pose has to be left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    DHGEN_ENTRIES(double);

    /* r3 */
    const double t34 = T14 - ez * T13, q3 = d1 - t34;

    /* theta12 */
    const double v1 = T32 * T32 + T22 * T22, w12 = sqrt(v1), v2 = DHGEN_QUOTIENT(1.0, v1),
        v3 = w12 * v2;

    /* theta1 */
    const double t14 = T24 - ez * T23, t24 = T34 - ez * T33 - zz,
        v4 = m2 * t24 - w12 * (m1 * (T32 * v2)), v5 = m2 * t14 - w12 * (m1 * (T22 * v2)),
        v6 = v4 * v4 + v5 * v5, v7 = sqrt(v6) * DHGEN_QUOTIENT(1.0, v6);

    /* is the pose one that the arm can take? */
    const double v8 = t34 - (d1 - q3), v9 = T13 + 1.0,
        v10 = t24 - (l2 * (T32 * v3) + l1 * (v4 * v7)),
        v11 = t14 - (l2 * (T22 * v3) + l1 * (v5 * v7)), v12 = v1 - 1.0;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)((m4 <
        v8 * v8 + v10 * v10 + v11 * v11) | (m5 < v9 * v9 + T12 * T12 + T33 * T33 + T23 * T23 + v12 *
        v12) | (v6 <= m3)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(v4, T32, v4, v4),
        dhgen_four_of(v5, T22, v5, v5));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1);
    const dhgen_four v13 = angle2 - angle1, q2 = dhgen_centred_four(v13);

    dhgen_store_2(q, q, q, q, angle1, q2);
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
    { 0.0004167, 0.0004167, 0.0004167, 1.0, 1.0, 1.0 }, 0.0004166666666666667, { 1e-14, 1e-14 },
        entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    1, /* follows seed */ NULL, NULL, NULL, NULL, adept_fk, adept_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) adept_##function
#include "dhgen/functions.h"

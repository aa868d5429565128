/* gantry_wrist: Gantry with a spherical wrist
 *
 * Inverse kinematics, generated from robots/gantry_wrist.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/gantry_wrist.yaml. The formulas and where they come from:
 * gantry_wrist.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 1ede0a2831d661a5
 * SPDX-License-Identifier: MIT
 */
#include "gantry_wrist.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(GANTRY_WRIST_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(GANTRY_WRIST_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef GANTRY_WRIST_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d4 = 0.1, /* joint offset 4 [m] */
    d6 = 0.12, /* joint offset 6 [m] */
    free_limit = 1e-12; /* a length that fixes no angle */

#ifndef __CUDACC_RTC__
const char *const gantry_wrist_branches[2] = {
    "noflip", "flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 2.2e-10, 20.66115702479339, 0.22, 0.021598449493429827, 0 },
    { -HUGE_VAL, HUGE_VAL, 2.2e-10, 20.66115702479339, 0.22, 0.021598449493429827, 0 },
    { -HUGE_VAL, HUGE_VAL, 2.2e-10, 20.66115702479339, 0.22, 0.021598449493429827, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { -1.5707963267948966, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.1, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.12, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void gantry_wrist_fk(const double q[6], double T[16])
{
    const double c4 = cos(q[3]), s4 = sin(q[3]);
    const double c5 = cos(q[4]), s5 = sin(q[4]), v1 = s4 * c5, x5_z = c4 * c5, v2 = s4 * s5,
        z5_z = c4 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = -(s5 * c6); T[1] = s5 * s6; T[2] = c5; T[3] = q[2] + d4 + c5 * d6;
    T[4] = -(v1 * c6 + c4 * s6); T[5] = v1 * s6 - c4 * c6; T[6] = -v2; T[7] = q[1] - v2 * d6;
    T[8] = x5_z * c6 - s4 * s6; T[9] = -(s4 * c6 + x5_z * s6); T[10] = z5_z;
    T[11] = q[0] + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void gantry_wrist_jacobian(const double q[6], double J[36])
{
    const double c4 = cos(q[3]), s4 = sin(q[3]), p4_x = q[2] + d4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), v1 = s4 * s5, z5_z = c4 * s5,
        J34 = q[1] - v1 * d6 - q[1], v2 = q[0] + z5_z * d6 - q[0], v3 = p4_x + c5 * d6 - p4_x;
    J[0] = 0.0; J[1] = 0.0; J[2] = 1.0; J[3] = 0.0; J[4] = s4 * J34 - c4 * v2;
    J[5] = -(v1 * v2 + z5_z * J34);
    J[6] = 0.0; J[7] = 1.0; J[8] = 0.0; J[9] = -v2; J[10] = -(s4 * v3); J[11] = z5_z * v3 - c5 * v2;
    J[12] = 1.0; J[13] = 0.0; J[14] = 0.0; J[15] = J34; J[16] = c4 * v3; J[17] = c5 * J34 + v1 * v3;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = 1.0; J[22] = 0.0; J[23] = c5;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = 0.0; J[28] = -c4; J[29] = -v1;
    J[30] = 0.0; J[31] = 0.0; J[32] = 0.0; J[33] = 0.0; J[34] = -s4; J[35] = z5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* r2, type 1: U0 A6^-1 [2, 4] */
    const double wy = T24 - T23 * d6;

    /* r1, type 1: U0 A6^-1 [3, 4] */
    const double wz = T34 - d6 * T33;

    /* r3, type 1: U0 A6^-1 [1, 4] */
    const double wx = T14 - d6 * T13;
    const double r3 = wx - d4;

    /* theta4, type 2: U4[3, 3] */
    const double w4 = sqrt(T33 * T33 + T23 * T23);
    const int free4 = w4 <= free_limit;
    const double divisor4 = free4 ? 1.0 : w4;

    for (int i1 = 0; i1 < 2; i1++) { /* noflip, flip */
        const double e4 = i1 == 0 ? 1.0 : -1.0;
        /* theta4 */
        if (e4 < 0.0 && free4) continue; /* both signs give the same */
        const double factor4 = e4 / divisor4;
        const double c4 = free4 ? cos(seed[3]) : -(T33 * factor4),
            s4 = free4 ? sin(seed[3]) : T23 * factor4;
        const double q4 = atan2(s4, c4);

        /* theta5, type 3: U4[2, 3] and U4[1, 3] */
        const double q5 = atan2(-(w4 * e4), T13);

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double q6 = atan2(-(T21 * c4 + T31 * s4), -(T22 * c4 + T32 * s4));
        const int row = i1;
        q[row][0] = wz; q[row][1] = wy; q[row][2] = r3; q[row][3] = q4; q[row][4] = q5;
        q[row][5] = q6;
        status[row] = free4 ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

#ifndef GANTRY_WRIST_PLAIN
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

    /* r2 */
    const dhgen_wide q2_p = T24 - d6 * T23;

    /* r1 */
    const dhgen_wide q1_p = T34 - d6 * T33;

    /* r3 */
    const dhgen_wide q3_p = T14 - d6 * T13 - d4;

    /* theta4 */
    const dhgen_wide v1 = T33 * T33 + T23 * T23, angle1 = dhgen_atan2_wide(T23, -T33);

    /* theta5 */
    const dhgen_wide angle2 = dhgen_atan2_wide(-dhgen_sqrt_wide(v1), T13);

    /* theta6 */
    const dhgen_wide v2 = T33 * T21 - T23 * T31,
        angle3 = dhgen_atan2_wide(v2, T33 * T22 - T23 * T32);

    q[0] = q1_p; q[1] = q2_p; q[2] = q3_p; q[3] = angle1; q[4] = angle2; q[5] = angle3;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_p; q[7] = q2_p; q[8] = q3_p; q[9] = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, T23);
    q[10] = -angle2; q[11] = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, v2);
    kind[1] = dhgen_kind_wide(q[6]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
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
    const dhgen_four e4 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* r2 */
    const double q2 = T24 - d6 * T23;

    /* r1 */
    const double q1 = T34 - d6 * T33;

    /* r3 */
    const double q3 = T14 - d6 * T13 - d4;

    /* theta4 */
    const double v1 = T33 * T33 + T23 * T23, v2 = copysign(DHGEN_HALF_TURN, T23);
    const dhgen_four v3 = m2 * (e4 - 1.0);

    /* theta6 */
    const double v4 = T33 * T21 - T23 * T31, v5 = copysign(DHGEN_HALF_TURN, v4);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)(v1 <=
        m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(T23, -sqrt(v1), v4, T23),
        dhgen_four_of(-T33, T13, T33 * T22 - T23 * T32, -T33));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2);
    const dhgen_four q4 = angle1 + v2 * v3, q6 = angle3 + v3 * v5, q5 = e4 * angle2;

    dhgen_store_4(q, q + 6, q, q + 6, dhgen_all_four(q1), dhgen_all_four(q2), dhgen_all_four(q3),
        q4);
    dhgen_store_2(q + 4, q + 10, q + 4, q + 10, q5, q6);
    const unsigned long long none1 = (dhgen_bits_four(dhgen_all_four(q1) != dhgen_all_four(q1)) *
        0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[1] = { 3 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 2, 0, DHGEN_POSE, joints, NULL, 0,
    { 4.545, 4.545, 4.545, 1.0, 1.0, 1.0 }, 4.545454545454546, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, gantry_wrist_fk,
    gantry_wrist_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) gantry_wrist_##function
#include "dhgen/functions.h"

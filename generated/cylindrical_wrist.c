/* cylindrical_wrist: Cylindrical arm with a spherical wrist
 *
 * Inverse kinematics, generated from robots/cylindrical_wrist.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/cylindrical_wrist.yaml. The formulas and where they come from:
 * cylindrical_wrist.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: af40b92118c6448a
 * SPDX-License-Identifier: MIT
 */
#include "cylindrical_wrist.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(CYLINDRICAL_WRIST_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(CYLINDRICAL_WRIST_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef CYLINDRICAL_WRIST_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.3, /* joint offset 1 [m] */
    d6 = 0.1, /* joint offset 6 [m] */
    free_limit1 = 4e-13, /* a length that fixes no angle [m] */
    free_limit = 1e-12; /* a length that fixes no angle */

#ifndef __CUDACC_RTC__
const char *const cylindrical_wrist_branches[4] = {
    "forward-noflip", "forward-flip", "backward-noflip", "backward-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 4e-10, 6.249999999999999, 0.4, 0.039269908169872414, 0 },
    { -HUGE_VAL, HUGE_VAL, 4e-10, 6.249999999999999, 0.4, 0.039269908169872414, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.3, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.1, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void cylindrical_wrist_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = c1 * c4, x4_y = s1 * c4, v1 = c1 * s4,
        v2 = s1 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + s1 * s5,
        x5_y = x4_y * c5 - c1 * s5, v3 = s4 * c5, z5_y = c1 * c5 + x4_y * s5, v4 = s4 * s5,
        z5_x = x4_x * s5 - s1 * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - v1 * s6; T[1] = -(v1 * c6 + x5_x * s6); T[2] = z5_x;
    T[3] = z5_x * d6 - s1 * q[2];
    T[4] = x5_y * c6 - v2 * s6; T[5] = -(v2 * c6 + x5_y * s6); T[6] = z5_y;
    T[7] = c1 * q[2] + z5_y * d6;
    T[8] = -(v3 * c6 + c4 * s6); T[9] = v3 * s6 - c4 * c6; T[10] = -v4; T[11] = d1 + q[1] - v4 * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void cylindrical_wrist_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p2_z = d1 + q[1], v1 = s1 * q[2], p3_y = c1 * q[2];
    const double c4 = cos(q[3]), s4 = sin(q[3]), v2 = c1 * s4, v3 = s1 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z5_y = c1 * c5 + s1 * c4 * s5, v4 = s4 * s5,
        z5_x = c1 * c4 * s5 - s1 * c5, p6_x = z5_x * d6 - v1, p6_y = p3_y + z5_y * d6,
        v5 = v1 + p6_x, v6 = p6_y - p3_y, v7 = p2_z - v4 * d6 - p2_z;
    J[0] = -p6_y; J[1] = 0.0; J[2] = -s1; J[3] = c1 * v7; J[4] = c4 * v6 - v3 * v7;
    J[5] = z5_y * v7 + v4 * v6;
    J[6] = p6_x; J[7] = 0.0; J[8] = c1; J[9] = s1 * v7; J[10] = v2 * v7 - c4 * v5;
    J[11] = -(v4 * v5 + z5_x * v7);
    J[12] = 0.0; J[13] = 1.0; J[14] = 0.0; J[15] = -(s1 * v6 + c1 * v5); J[16] = v3 * v5 - v2 * v6;
    J[17] = z5_x * v6 - z5_y * v5;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = -s1; J[22] = -v2; J[23] = z5_x;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = c1; J[28] = -v3; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = 0.0; J[34] = -c4; J[35] = -v4;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* r2, type 1: U0 A6^-1 [3, 4] */
    const double wz = T34 - T33 * d6;
    const double r2 = wz - d1;

    /* theta1, r3, type 4: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4] */
    const double wy = T24 - d6 * T23;
    const double v1 = d6 * T13 - T14;
    const double w3 = sqrt(v1 * v1 + wy * wy);
    const int free1 = w3 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w3;

    /* theta4, type 2: U4[3, 3] */
    const double v2 = T33 * T33;

    for (int i1 = 0; i1 < 2; i1++) { /* forward, backward */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1, r3 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : wy * factor1,
            s1 = free1 ? sin(seed[0]) : v1 * factor1;
        const double q1 = atan2(s1, c1);
        const double r3 = w3 * e1;

        /* theta4 */
        const double X4 = T13 * c1 + T23 * s1;
        const double w4 = sqrt(X4 * X4 + v2);
        const int free4 = w4 <= free_limit;
        const double divisor4 = free4 ? 1.0 : w4;

        /* theta5, type 3: U4[2, 3] and U4[1, 3] */
        const double c5 = T23 * c1 - T13 * s1;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v3 = T12 * c1 + T22 * s1, v4 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e4 = i2 == 0 ? 1.0 : -1.0;
            /* theta4 */
            if (e4 < 0.0 && free4) continue; /* both signs give the same */
            const double factor4 = e4 / divisor4;
            const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                s4 = free4 ? sin(seed[3]) : T33 * factor4;
            const double q4 = atan2(s4, c4);

            /* theta5 */
            const double q5 = atan2(-(w4 * e4), c5);

            /* theta6 */
            const double q6 = atan2(-(T31 * c4 + s4 * v4), -(T32 * c4 + s4 * v3));
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = r2; q[row][2] = r3; q[row][3] = q4; q[row][4] = q5;
            q[row][5] = q6;
            status[row] = (free1 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef CYLINDRICAL_WRIST_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 4e-05 [m], doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 1.6000000000000003e-09, /* doubt_limit1^2 [m^2] */
    m3 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* r2 */
    const dhgen_wide q2_pp = T34 - d6 * T33 - d1;

    /* theta1, r3 */
    const dhgen_wide wy = T24 - d6 * T23, s1 = d6 * T13 - T14, v1 = s1 * s1 + wy * wy,
        q3_pp = dhgen_sqrt_wide(v1), factor1 = q3_pp * DHGEN_QUOTIENT(1.0, v1),
        angle1 = dhgen_atan2_wide(s1, wy), q1_mp = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, s1);

    /* theta4 */
    const dhgen_wide X4 = wy * T13 + T23 * s1, v2 = factor1 * X4,
        v3 = T33 * T33 + factor1 * (X4 * v2), angle2 = dhgen_atan2_wide(T33, -v2),
        q4_pm = angle2 - dhgen_signed_wide(DHGEN_HALF_TURN, T33);

    /* theta5 */
    const dhgen_wide angle3 = dhgen_atan2_wide(-dhgen_sqrt_wide(v3), factor1 * (T23 * wy - T13 *
        s1)), q5_mp = dhgen_signed_wide(DHGEN_HALF_TURN, -dhgen_sqrt_wide(v3)) - angle3;

    /* theta6 */
    const dhgen_wide v4 = X4 * T31 - T33 * (wy * T11 + s1 * T21),
        angle4 = dhgen_atan2_wide(v4, X4 * T32 - T33 * (wy * T12 + s1 * T22)),
        q6_pm = angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, v4);

    q[0] = angle1; q[1] = q2_pp; q[2] = q3_pp; q[3] = angle2; q[4] = angle3; q[5] = angle4;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = angle1; q[7] = q2_pp; q[8] = q3_pp; q[9] = q4_pm; q[10] = -angle3; q[11] = q6_pm;
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_mp; q[13] = q2_pp; q[14] = -q3_pp; q[15] = -q4_pm; q[16] = q5_mp; q[17] = q6_pm;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_mp; q[19] = q2_pp; q[20] = -q3_pp; q[21] = -angle2; q[22] = -q5_mp; q[23] = angle4;
    kind[3] = dhgen_kind_wide(q[18]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v1 <= m1) | (v3 <= m3));
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
    const dhgen_four e4 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* r2 */
    const double q2 = T34 - d6 * T33 - d1;

    /* theta1, r3 */
    const double wy = T24 - d6 * T23, s1 = d6 * T13 - T14, v1 = s1 * s1 + wy * wy, w3 = sqrt(v1),
        factor1 = w3 * DHGEN_QUOTIENT(1.0, v1), v2 = copysign(DHGEN_HALF_TURN, s1);
    const dhgen_four v3 = e1 - 1.0;

    /* theta4 */
    const double X4 = wy * T13 + T23 * s1, v4 = factor1 * X4, v5 = T33 * T33 + factor1 * (X4 * v4),
        v6 = copysign(DHGEN_HALF_TURN, T33);

    /* theta5 */
    const double v8 = copysign(DHGEN_HALF_TURN, -sqrt(v5));

    /* theta6 */
    const double v9 = X4 * T31 - T33 * (wy * T11 + s1 * T21), v10 = copysign(DHGEN_HALF_TURN, v9);

    /* joint values */
    const dhgen_four q3 = e1 * w3;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)((v1 <=
        m1) | (v5 <= m3)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(s1, T33, -sqrt(v5), v9),
        dhgen_four_of(wy, -v4, factor1 * (T23 * wy - T13 * s1), X4 * T32 - T33 * (wy * T12 + s1 *
        T22)));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2),
        angle4 = dhgen_shuffle(packed1, packed1, 3, 3, 3, 3);
    const dhgen_four q1 = angle1 + v2 * (m2 * v3), v7 = e1 * angle2,
        q4 = v7 + v6 * (m2 * (e4 - e1)), q5_ = e1 * angle3 + v8 * (m2 * -v3),
        q6 = angle4 + v10 * (m2 * (e1 * e4 - 1.0)), q5 = e4 * q5_;

    dhgen_store_4(q, q + 6, q + 12, q + 18, q1, dhgen_all_four(q2), q3, q4);
    dhgen_store_2(q + 4, q + 10, q + 16, q + 22, q5, q6);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[2] = { 3, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 4, 0, DHGEN_POSE, joints, NULL, 0,
    { 2.5, 2.5, 2.5, 1.0, 1.0, 1.0 }, 2.5, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL,
    cylindrical_wrist_fk, cylindrical_wrist_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) cylindrical_wrist_##function
#include "dhgen/functions.h"

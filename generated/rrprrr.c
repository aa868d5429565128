/* rrprrr: RRPRRR arm
 *
 * Inverse kinematics, generated from robots/rrprrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/rrprrr.yaml. The formulas and where they come from: rrprrr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: ec7723db4c98fce0
 * SPDX-License-Identifier: MIT
 */
#include "rrprrr.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(RRPRRR_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(RRPRRR_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef RRPRRR_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    free_limit1 = 1e-12, /* a length that fixes no angle [m] */
    free_limit = 1e-12; /* a length that fixes no angle */

#ifndef __CUDACC_RTC__
const char *const rrprrr_branches[8] = {
    "back-forward-noflip", "back-forward-flip", "back-backward-noflip", "back-backward-flip",
    "front-forward-noflip", "front-forward-flip", "front-backward-noflip", "front-backward-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_MODIFIED, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void rrprrr_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, z3_x = c1 * s2,
        z3_y = s1 * s2;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x2_x * c4 + s1 * s4,
        x4_y = x2_y * c4 - c1 * s4, x4_z = s2 * c4, y4_x = s1 * c4 - x2_x * s4,
        v1 = c1 * c4 + x2_y * s4, v2 = s2 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - z3_x * s5,
        x5_y = x4_y * c5 - z3_y * s5, x5_z = x4_z * c5 + c2 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + y4_x * s6; T[1] = y4_x * c6 - x5_x * s6; T[2] = z3_x * c5 + x4_x * s5;
    T[3] = z3_x * q[2];
    T[4] = x5_y * c6 - v1 * s6; T[5] = -(v1 * c6 + x5_y * s6); T[6] = z3_y * c5 + x4_y * s5;
    T[7] = z3_y * q[2];
    T[8] = x5_z * c6 - v2 * s6; T[9] = -(v2 * c6 + x5_z * s6); T[10] = x4_z * s5 - c2 * c5;
    T[11] = -(c2 * q[2]);
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void rrprrr_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, z3_x = c1 * s2,
        z3_y = s1 * s2, p3_x = z3_x * q[2], p3_y = z3_y * q[2], v1 = c2 * q[2];
    const double c4 = cos(q[3]), s4 = sin(q[3]);
    const double c5 = cos(q[4]), s5 = sin(q[4]);
    J[0] = -p3_y; J[1] = c1 * v1; J[2] = z3_x; J[3] = 0.0; J[4] = 0.0; J[5] = 0.0;
    J[6] = p3_x; J[7] = s1 * v1; J[8] = z3_y; J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = s1 * p3_y + c1 * p3_x; J[14] = -c2; J[15] = 0.0; J[16] = 0.0; J[17] = 0.0;
    J[18] = 0.0; J[19] = s1; J[20] = 0.0; J[21] = z3_x; J[22] = s1 * c4 - x2_x * s4;
    J[23] = z3_x * c5 + (x2_x * c4 + s1 * s4) * s5;
    J[24] = 0.0; J[25] = -c1; J[26] = 0.0; J[27] = z3_y; J[28] = -(c1 * c4 + x2_y * s4);
    J[29] = z3_y * c5 + (x2_y * c4 - c1 * s4) * s5;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = -c2; J[34] = -(s2 * s4);
    J[35] = s2 * c4 * s5 - c2 * c5;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[2, 4] */
    const double w1 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta2, r3, type 4: U1[1, 4] and U1[3, 4] */
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

        /* theta4, type 2: U4[2, 3] */
        const double v2 = T13 * c1 + T23 * s1;
        const double Y4 = T23 * c1 - T13 * s1;
        const double v3 = Y4 * Y4;

        /* theta6, type 3: U4[2, 2] and U4[2, 1] */
        const double v4 = T22 * c1 - T12 * s1, v5 = T12 * c1 + T22 * s1, v7 = T21 * c1 - T11 * s1,
            v8 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* forward, backward */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta2, r3 */
            if (e2 < 0.0 && free2) continue; /* both signs give the same */
            const double factor2 = e2 / divisor2;
            const double c2 = free2 ? cos(seed[1]) : -(T34 * factor2),
                s2 = free2 ? sin(seed[1]) : -(D1 * factor2);
            const double q2 = atan2(s2, c2);
            const double r3 = w3 * e2;

            /* theta4 */
            const double X4 = c2 * v2 + T33 * s2;
            const double w4 = sqrt(X4 * X4 + v3);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[3, 3] and U4[1, 3] */
            const double c5 = s2 * v2 - T33 * c2;

            /* theta6 */
            const double v6 = c2 * v5 + T32 * s2, v9 = c2 * v8 + T31 * s2;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e4), c5);

                /* theta6 */
                const double q6 = atan2(-(c4 * v7 + s4 * v9), -(c4 * v4 + s4 * v6));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = r3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef RRPRRR_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 9.999999999999999e-05 [m]. */
static const double
    m1 = 9.999999999999999e-09; /* doubt_limit1^2 [m^2] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T14 * T14 + T24 * T24, w1 = dhgen_sqrt_wide(v1),
        factor1 = w1 * DHGEN_QUOTIENT(1.0, v1), angle1 = dhgen_atan2_wide(-T24, -T14),
        q1_mpp = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, -T24);

    /* theta2, r3 */
    const dhgen_wide v2 = v1 + T34 * T34, q3_ppp = dhgen_sqrt_wide(v2),
        factor2 = q3_ppp * DHGEN_QUOTIENT(1.0, v2), v3 = T34 * factor2, v4 = w1 * factor2,
        angle2 = dhgen_atan2_wide(-w1, -T34),
        q2_pmp = angle2 - dhgen_signed_wide(DHGEN_HALF_TURN, -w1);

    /* theta4 */
    const dhgen_wide v5 = T14 * T13 + T24 * T23, X4 = factor1 * (v3 * v5) - v4 * T33,
        Y4 = T24 * T13 - T14 * T23, v6 = X4 * X4 + factor1 * (Y4 * (factor1 * Y4)),
        w4 = dhgen_sqrt_wide(v6), factor4 = w4 * DHGEN_QUOTIENT(1.0, v6), v7 = X4 * factor4,
        s4 = Y4 * factor4, v8 = factor1 * s4, angle3 = dhgen_atan2_wide(v8, -v7),
        q4_ppm = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, v8);

    /* theta5 */
    const dhgen_wide angle4 = dhgen_atan2_wide(-w4, v3 * T33 + factor1 * (v4 * v5)),
        q5_pmp = dhgen_signed_wide(DHGEN_HALF_TURN, -w4) - angle4;

    /* theta6 */
    const dhgen_wide v9 = v7 * (T24 * T11 - T14 * T21) - s4 * (factor1 * (v3 * (T14 * T11 + T24 *
        T21)) - v4 * T31),
        angle5 = dhgen_atan2_wide(v9, v7 * (T24 * T12 - T14 * T22) - s4 * (factor1 * (v3 * (T14 *
            T12 + T24 * T22)) - v4 * T32)),
        q6_ppm = angle5 - dhgen_signed_wide(DHGEN_HALF_TURN, v9);

    q[0] = angle1; q[1] = angle2; q[2] = q3_ppp; q[3] = angle3; q[4] = angle4; q[5] = angle5;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = angle1; q[7] = angle2; q[8] = q3_ppp; q[9] = q4_ppm; q[10] = -angle4; q[11] = q6_ppm;
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = angle1; q[13] = q2_pmp; q[14] = -q3_ppp; q[15] = -q4_ppm; q[16] = q5_pmp;
    q[17] = q6_ppm;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = angle1; q[19] = q2_pmp; q[20] = -q3_ppp; q[21] = -angle3; q[22] = -q5_pmp;
    q[23] = angle5;
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = -angle2; q[26] = q3_ppp; q[27] = q4_ppm; q[28] = angle4; q[29] = angle5;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = -angle2; q[32] = q3_ppp; q[33] = angle3; q[34] = -angle4;
    q[35] = q6_ppm;
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mpp; q[37] = -q2_pmp; q[38] = -q3_ppp; q[39] = -angle3; q[40] = q5_pmp;
    q[41] = q6_ppm;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mpp; q[43] = -q2_pmp; q[44] = -q3_ppp; q[45] = -q4_ppm; q[46] = -q5_pmp;
    q[47] = angle5;
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v2 <= m1) | (v6 <= m1) | (v1 <= m1));
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
    const dhgen_four e2 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e4 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double v1 = T14 * T14 + T24 * T24, w1 = sqrt(v1), factor1 = w1 * DHGEN_QUOTIENT(1.0, v1);

    /* theta2, r3 */
    const double v2 = v1 + T34 * T34, w3 = sqrt(v2), factor2 = w3 * DHGEN_QUOTIENT(1.0, v2),
        v3 = T34 * factor2, v4 = w1 * factor2, v5 = copysign(DHGEN_HALF_TURN, -w1);
    const dhgen_four v6 = e2 - 1.0;

    /* theta4 */
    const double v7 = T14 * T13 + T24 * T23, X4 = factor1 * (v3 * v7) - v4 * T33,
        Y4 = T24 * T13 - T14 * T23, v8 = X4 * X4 + factor1 * (Y4 * (factor1 * Y4)), w4 = sqrt(v8),
        factor4 = w4 * DHGEN_QUOTIENT(1.0, v8), v9 = X4 * factor4, s4 = Y4 * factor4,
        v10 = factor1 * s4, v11 = copysign(DHGEN_HALF_TURN, v10);

    /* theta5 */
    const double v13 = copysign(DHGEN_HALF_TURN, -w4);

    /* theta6 */
    const double v14 = v9 * (T24 * T11 - T14 * T21) - s4 * (factor1 * (v3 * (T14 * T11 + T24 * T21))
        - v4 * T31), v15 = copysign(DHGEN_HALF_TURN, v14);

    /* joint values */
    const dhgen_four q3_p = e2 * w3;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)((v2 <=
        m1) | (v8 <= m1) | (v1 <= m1)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-T24, -w1, v10, -w4),
        dhgen_four_of(-T14, -T34, -v9, v3 * T33 + factor1 * (v4 * v7))),
        ratio2 = dhgen_ratio_four(dhgen_four_of(v14, v14, v14, v14), dhgen_four_of(v9 * (T24 * T12 -
            T14 * T22) - s4 * (factor1 * (v3 * (T14 * T12 + T24 * T22)) - v4 * T32), v9 * (T24 * T12
            - T14 * T22) - s4 * (factor1 * (v3 * (T14 * T12 + T24 * T22)) - v4 * T32), v9 * (T24 *
            T12 - T14 * T22) - s4 * (factor1 * (v3 * (T14 * T12 + T24 * T22)) - v4 * T32), v9 * (T24
            * T12 - T14 * T22) - s4 * (factor1 * (v3 * (T14 * T12 + T24 * T22)) - v4 * T32)));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2),
        angle4 = dhgen_shuffle(packed1, packed1, 3, 3, 3, 3), packed2 = dhgen_angle_four(ratio2),
        angle5 = dhgen_shuffle(packed2, packed2, 0, 0, 0, 0);
    const dhgen_four q1_m = angle1 - copysign(DHGEN_HALF_TURN, -T24),
        q2_p = angle2 + v5 * (m2 * v6), v12 = e2 * angle3, q4_p = v12 + v11 * (m2 * (e4 - e2)),
        q4_m = v12 - v11 * (m2 * (e2 + e4)), q5_ = e2 * angle4 + v13 * (m2 * -v6),
        q6_p = angle5 + v15 * (m2 * (e2 * e4 - 1.0)), q5_p = e4 * q5_;

    dhgen_store_4(q, q + 6, q + 12, q + 18, angle1, q2_p, q3_p, q4_p);
    dhgen_store_2(q + 4, q + 10, q + 16, q + 22, q5_p, q6_p);
    dhgen_store_4(q + 24, q + 30, q + 36, q + 42, q1_m, -q2_p, q3_p, q4_m);
    dhgen_store_2(q + 28, q + 34, q + 40, q + 46, q5_p, q6_p);
    const unsigned long long none1 = (dhgen_bits_four(angle1 != angle1) * 0x204081ull &
        0x1010101ull) | (dhgen_bits_four(q1_m != q1_m) * 0x20408100000000ull &
        0x101010100000000ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[3] = { 3, 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 }, 1.0, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 3, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, rrprrr_fk,
    rrprrr_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) rrprrr_##function
#include "dhgen/functions.h"

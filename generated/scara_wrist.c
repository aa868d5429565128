/* scara_wrist: SCARA arm with a spherical wrist
 *
 * Inverse kinematics, generated from robots/scara_wrist.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/scara_wrist.yaml. The formulas and where they come from:
 * scara_wrist.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: e8aefe29e53d431c
 * SPDX-License-Identifier: MIT
 */
#include "scara_wrist.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(SCARA_WRIST_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(SCARA_WRIST_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef SCARA_WRIST_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.5, /* joint offset 1 [m] */
    a1 = 0.4, /* link length 1 [m] */
    a2 = 0.3, /* link length 2 [m] */
    d6 = 0.1, /* joint offset 6 [m] */
    longest2 = 0.48999999999999994, /* square of the longest reach [m^2] */
    shortest2 = 0.010000000000000007, /* square of the shortest reach [m^2] */
    longest2_reach = 0.49000000000018196, /* the longest, with what rounding adds [m^2] */
    shortest2_reach = 0.009999999999974009, /* the shortest, with what rounding adds [m^2] */
    longest2_apart = 0.48999999999998173, /* the longest, where branches merge [m^2] */
    shortest2_apart = 0.010000000000002607, /* the shortest, where branches merge [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.25, /* a1^2 + a2^2 [m^2] */
    k2 = 4.166666666666667; /* 1 / (2 * a2 * a1) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const scara_wrist_branches[4] = {
    "right-noflip", "right-flip", "left-noflip", "left-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1.3e-09, 0.5917159763313609, 1.3, 0.12762720155208535, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.5, 0.4, 0.0 },
    { 0.0, 0.0, 0.3, 0.0 },
    { 0.0, 0.0, 0.0, 3.141592653589793 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.1, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void scara_wrist_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    const double c4 = cos(q[3]), s4 = sin(q[3]), v1 = x2_y * s4, x4_x = x2_x * c4 + v1,
        v2 = x2_y * c4, x4_y = v2 + -x2_x * s4, y5_x = v2 - x2_x * s4, y5_y = -x2_x * c4 - v1;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5, x5_y = x4_y * c5, v3 = x4_x * s5,
        v4 = x4_y * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + y5_x * s6; T[1] = y5_x * c6 - x5_x * s6; T[2] = -v3;
    T[3] = c1 * a1 + x2_x * a2 - v3 * d6;
    T[4] = x5_y * c6 + y5_y * s6; T[5] = y5_y * c6 - x5_y * s6; T[6] = -v4;
    T[7] = s1 * a1 + x2_y * a2 - v4 * d6;
    T[8] = -(s5 * c6); T[9] = s5 * s6; T[10] = -c5; T[11] = d1 + q[2] - c5 * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void scara_wrist_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2,
        p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p3_z = d1 + q[2];
    const double c4 = cos(q[3]), s4 = sin(q[3]), v1 = x2_y * s4, v2 = x2_y * c4,
        z4_x = x2_x * s4 - v2, z4_y = v1 - -x2_x * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), v3 = (x2_x * c4 + v1) * s5,
        v4 = (v2 + -x2_x * s4) * s5, p6_x = p2_x - v3 * d6, p6_y = p2_y - v4 * d6, v5 = p6_x - p2_x,
        J14 = p6_y - p2_y, v6 = p3_z - c5 * d6 - p3_z;
    J[0] = -p6_y; J[1] = p1_y - p6_y; J[2] = 0.0; J[3] = J14; J[4] = z4_y * v6;
    J[5] = c5 * J14 - v4 * v6;
    J[6] = p6_x; J[7] = p6_x - p1_x; J[8] = 0.0; J[9] = -v5; J[10] = -(z4_x * v6);
    J[11] = v3 * v6 - c5 * v5;
    J[12] = 0.0; J[13] = 0.0; J[14] = 1.0; J[15] = 0.0; J[16] = z4_x * J14 - z4_y * v5;
    J[17] = v4 * v5 - v3 * J14;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = 0.0; J[22] = z4_x; J[23] = -v3;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = 0.0; J[28] = z4_y; J[29] = -v4;
    J[30] = 1.0; J[31] = 1.0; J[32] = 0.0; J[33] = -1.0; J[34] = 0.0; J[35] = -c5;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* r3, type 1: U0 A6^-1 [3, 4] */
    const double wz = T34 - T33 * d6;
    const double r3 = wz - d1;

    /* theta2, type 8: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4] */
    const double wx = T14 - d6 * T13;
    const double wy = T24 - d6 * T23;
    const double N2 = wx * wx + wy * wy;
    const double K2 = N2 - k1;
    const double D2_squared = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) return; /* out of reach */
    const double w2 = sqrt(apart2 ? D2_squared : 0.0);
    const double c2 = K2 * k2;

    /* theta1, type 3: U0 A6^-1 [2, 4] and U0 A6^-1 [1, 4] */
    const double X1_1 = a1 + a2 * c2;
    const double v1 = wy * X1_1, v2 = wx * X1_1;

    /* theta12m4, type 2: U4[3, 3] */
    const double w12m4 = sqrt(T13 * T13 + T23 * T23);
    const int free12m4 = w12m4 <= free_limit;
    const double divisor12m4 = free12m4 ? 1.0 : w12m4;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e2 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e2 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e2 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = a2 * s2;
        const double S1 = v1 - wx * Y1_1;
        const double C1 = v2 + wy * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const double factor1 = 1.0 / w1;
        const double c1 = C1 * factor1, s1 = S1 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta12m4 */
        const double v3 = q2 + q1, v4 = v3 - seed[3];

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e12m4 = i2 == 0 ? 1.0 : -1.0;
            /* theta12m4 */
            if (e12m4 < 0.0 && free12m4) continue; /* both signs give the same */
            const double factor12m4 = e12m4 / divisor12m4;
            const double c12m4 = free12m4 ? cos(v4) : -(T13 * factor12m4);
            const double s12m4 = free12m4 ? sin(v4) : -(T23 * factor12m4);
            const double s5 = w12m4 * e12m4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double q5 = atan2(s5, -T33);

            /* theta6, type 3: U4[3, 2] and U4[3, 1] */
            const double c6 = T12 * s12m4 - T22 * c12m4, s6 = T11 * s12m4 - T21 * c12m4;
            const double q6 = atan2(s6, c6);

            /* joint values */
            const double q4 = dhgen_wrap(v3 - atan2(s12m4, c12m4));
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = r3; q[row][3] = q4; q[row][4] = q5;
            q[row][5] = q6;
            status[row] = free12m4 ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef SCARA_WRIST_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    /* 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4] */
    m1 = 8.7396756498489e-12,
    m2 = 1.25, /* a2 * k2 [m^-1] */
    m3 = 0.08750000000000001, /* a1 - a2 * k1 * k2 [m] */
    m4 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta2 */
    const dhgen_wide wx = T14 - d6 * T13, wy = T24 - d6 * T23, N2 = wx * wx + wy * wy,
        D2_squared = (longest2 - N2) * (N2 - shortest2), w2 = dhgen_sqrt_wide(D2_squared),
        v1 = w2 - w2, angle1 = dhgen_atan2_wide(w2, N2 - k1);

    /* theta1 */
    const dhgen_wide v2 = m3 + m2 * N2, v3 = wy * v2, v4 = wx * v2,
        angle2 = dhgen_atan2_wide(v3 - w2 * (m2 * wx), v4 + w2 * (m2 * wy)),
        angle3 = dhgen_atan2_wide(v3 - w2 * (m2 * -wx), v4 + w2 * (m2 * -wy));

    /* theta12m4 */
    const dhgen_wide v5 = T13 * T13 + T23 * T23, v6 = angle1 + angle2, v7 = angle3 - angle1;

    /* theta5 */
    const dhgen_wide angle4 = dhgen_atan2_wide(dhgen_sqrt_wide(v5), -T33);

    /* theta6 */
    const dhgen_wide s6 = T13 * T21 - T23 * T11,
        angle5 = dhgen_atan2_wide(s6, T13 * T22 - T23 * T12);

    /* joint values */
    const dhgen_wide angle6 = dhgen_atan2_wide(-T23, -T13),
        v8 = angle6 - dhgen_signed_wide(DHGEN_HALF_TURN, -T23), v9 = v6 - angle6, v10 = v6 - v8,
        v11 = v7 - angle6, v12 = v7 - v8, q3_pp = v1 + (T34 - d6 * T33 - d1), q5_pp = v1 + angle4,
        q5_pm = v1 - angle4, q6_pp = v1 + angle5,
        q6_pm = v1 + (angle5 - dhgen_signed_wide(DHGEN_HALF_TURN, s6));

    q[0] = angle2; q[1] = angle1; q[2] = q3_pp; q[3] = dhgen_centred_wide(v9); q[4] = q5_pp;
    q[5] = q6_pp;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = angle2; q[7] = angle1; q[8] = q3_pp; q[9] = dhgen_centred_wide(v10); q[10] = q5_pm;
    q[11] = q6_pm;
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = angle3; q[13] = -angle1; q[14] = q3_pp; q[15] = dhgen_centred_wide(v11); q[16] = q5_pp;
    q[17] = q6_pp;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = angle3; q[19] = -angle1; q[20] = q3_pp; q[21] = dhgen_centred_wide(v12); q[22] = q5_pm;
    q[23] = q6_pm;
    kind[3] = dhgen_kind_wide(q[18]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D2_squared) <= m1) | (v5 <= m4));
}

#if DHGEN_LANES > 1
static const double
    m5 = 0.5; /* 1 / 2 */
/* One regular pose, two signs in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    const dhgen_four e2 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e12m4 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta2 */
    const double wx = T14 - d6 * T13, wy = T24 - d6 * T23, N2 = wx * wx + wy * wy,
        D2_squared = (longest2 - N2) * (N2 - shortest2), w2 = sqrt(D2_squared), v1 = w2 - w2;

    /* theta1 */
    const double v2 = m3 + m2 * N2, v3 = wy * v2, v4 = wx * v2;

    /* theta12m4 */
    const double v5 = T13 * T13 + T23 * T23;

    /* theta6 */
    const double s6 = T13 * T21 - T23 * T11, v7 = copysign(DHGEN_HALF_TURN, s6);
    const dhgen_four v8 = m5 * (e12m4 - 1.0);

    /* joint values */
    const double v9 = copysign(DHGEN_HALF_TURN, -T23), q3 = v1 + (T34 - d6 * T33 - d1);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) |
        (unsigned)((fabs(D2_squared) <= m1) | (v5 <= m4)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(s6, -T23, s6, s6),
        dhgen_four_of(T13 * T22 - T23 * T12, -T13, T13 * T22 - T23 * T12, T13 * T22 - T23 * T12)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(dhgen_shuffle(v3 - w2 * (m2 * (e2 * wx)),
            dhgen_all_four(w2), 0, 5, 2, 3), dhgen_all_four(sqrt(v5)), 0, 1, 2, 7),
            dhgen_shuffle(dhgen_shuffle(v4 + w2 * (m2 * (e2 * wy)), dhgen_all_four(N2 - k1), 0, 5,
            2, 3), dhgen_all_four(-T33), 0, 1, 2, 7));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle4 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle5 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), packed2 = dhgen_angle_four(ratio2),
        angle2 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed2, packed2, 1, 1, 1, 1),
        angle3 = dhgen_shuffle(packed2, packed2, 3, 3, 3, 3);
    const dhgen_four q2 = e2 * angle1, v6 = angle2 + q2, v10 = angle5 + v8 * v9, v11 = v6 - v10,
        q4 = dhgen_centred_four(v11), q5 = v1 + e12m4 * angle3, q6 = v1 + (angle4 + v7 * v8);

    dhgen_store_4(q, q + 6, q + 12, q + 18, angle2, q2, dhgen_all_four(q3), q4);
    dhgen_store_2(q + 4, q + 10, q + 16, q + 22, q5, q6);
    const unsigned long long none1 = (dhgen_bits_four(angle2 != angle2) * 0x204081ull &
        0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[1] = { 3 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 4, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.7692, 0.7692, 0.7692, 1.0, 1.0, 1.0 }, 0.7692307692307692, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, scara_wrist_fk,
    scara_wrist_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) scara_wrist_##function
#include "dhgen/functions.h"

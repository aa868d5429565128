/* scara_prrr: SCARA arm on a vertical slide
 *
 * Inverse kinematics, generated from robots/scara_prrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/scara_prrr.yaml. The formulas and where they come from:
 * scara_prrr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: b16765c183860141
 * SPDX-License-Identifier: MIT
 */
#include "scara_prrr.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(SCARA_PRRR_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(SCARA_PRRR_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 4
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef SCARA_PRRR_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    a2 = 0.3, /* link length 2 [m] */
    a3 = 0.25, /* link length 3 [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    longest3 = 0.30250000000000005, /* square of the longest reach [m^2] */
    shortest3 = 0.0024999999999999988, /* square of the shortest reach [m^2] */
    longest3_reach = 0.3025000000000605, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0024999999999944992, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.30249999999999394, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.002500000000000549, /* the shortest, where branches merge [m^2] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 5.500000000000001e-06, /* a pose may be rounded by this [m] */
    k1 = 0.1525, /* a2^2 + a3^2 [m^2] */
    k2 = 6.666666666666667; /* 1 / (2 * a3 * a2) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const scara_prrr_branches[2] = {
    "right", "left",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[4] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 5.5e-10, 3.305785123966942, 0.55, 0.053996123733574576, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[4][4] = {
    { 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.3, 0.0 },
    { 0.0, 0.0, 0.25, 0.0 },
    { 0.0, 0.0, 0.0, 3.141592653589793 },
};
DHGEN_TABLE struct dhgen_links links = { 4, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 6

DHGEN_PUBLIC void scara_prrr_fk(const double q[4], double T[16])
{
    const double c2 = cos(q[1]), s2 = sin(q[1]);
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = c2 * c3 - s2 * s3, x3_y = s2 * c3 + c2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - x3_y * s4;
    T[0] = x4_x; T[1] = x3_y * c4 + x3_x * s4; T[2] = 0.0; T[3] = c2 * a2 + x3_x * a3;
    T[4] = x3_y * c4 + x3_x * s4; T[5] = -x4_x; T[6] = 0.0; T[7] = s2 * a2 + x3_y * a3;
    T[8] = 0.0; T[9] = 0.0; T[10] = -1.0; T[11] = q[0];
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void scara_prrr_jacobian(const double q[4], double J[24])
{
    const double c2 = cos(q[1]), s2 = sin(q[1]), p2_x = c2 * a2, p2_y = s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), p3_x = p2_x + (c2 * c3 - s2 * s3) * a3,
        p3_y = p2_y + (s2 * c3 + c2 * s3) * a3;
    J[0] = 0.0; J[1] = -p3_y; J[2] = p2_y - p3_y; J[3] = 0.0;
    J[4] = 0.0; J[5] = p3_x; J[6] = p3_x - p2_x; J[7] = 0.0;
    J[8] = 1.0; J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = 0.0;
    J[16] = 0.0; J[17] = 0.0; J[18] = 0.0; J[19] = 0.0;
    J[20] = 0.0; J[21] = 1.0; J[22] = 1.0; J[23] = 1.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[4] = (double (*)[4])rows;
    (void)free_joints; (void)seed; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta234, type 3: U0[2, 1] and U0[1, 1] */
    const double w234 = sqrt(T21 * T21 + T11 * T11);
    const int short234 = w234 <= free_limit;
    const double v1 = 1.0 / (short234 ? 1.0 : w234);
    const double c234 = T11 * v1, s234 = T21 * v1;
    const double theta234 = atan2(s234, c234);

    /* theta3, type 8: U0[1, 4] and U0[2, 4] */
    const double N3 = T14 * T14 + T24 * T24;
    const double K3 = N3 - k1;
    const double D3_squared = (longest3 - N3) * (N3 - shortest3);
    const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
    if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) return; /* out of reach */
    const double w3 = sqrt(apart3 ? D3_squared : 0.0);
    const double c3 = K3 * k2;

    /* theta2, type 3: U0[2, 4] and U0[1, 4] */
    const double X1_2 = a2 + a3 * c3;
    const double v2 = T24 * X1_2, v3 = T14 * X1_2;

    /* is the pose one that the arm can take? */
    if (!(fabs(1.0 + T33) <= pose_slack && fabs(T31) <= pose_slack && fabs(T23) <= pose_slack &&
        fabs(T21 - s234) <= pose_slack && fabs(T11 - c234) <= pose_slack && fabs(T13) <=
        pose_slack))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e3 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
        const double s3 = w3 * e3 * k2;
        const double q3 = atan2(s3, c3);

        /* theta2 */
        const double Y1_2 = a3 * s3;
        const double S2 = v2 - T14 * Y1_2;
        const double C2 = v3 + T24 * Y1_2;
        const double w2 = sqrt(S2 * S2 + C2 * C2);
        const double factor2 = 1.0 / w2;
        const double c2 = C2 * factor2, s2 = S2 * factor2;
        const double q2 = atan2(s2, c2);

        /* is the pose one that the arm can take? */
        const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2;
        if (!(fabs(T14 - (a3 * c23 + a2 * c2)) <= pose_slack1 && fabs(T24 - (a3 * s23 + a2 * s2)) <=
            pose_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q4 = dhgen_wrap(theta234 - (q3 + q2));
        const int row = i1;
        q[row][0] = T34; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4;
        status[row] = DHGEN_OK;
    }
}

#ifndef SCARA_PRRR_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
static const double
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m1 = 1.831867990631471e-12,
    m2 = 1.6666666666666667, /* a3 * k2 [m^-1] */
    m3 = 0.045833333333333316, /* a2 - a3 * k1 * k2 [m] */
    m4 = 1.0000000000000002e-10; /* pose_slack^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta234 */
    const dhgen_wide angle1 = dhgen_atan2_wide(T21, T11);

    /* theta3 */
    const dhgen_wide N3 = T14 * T14 + T24 * T24, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_wide(D3_squared), angle2 = dhgen_atan2_wide(w3, N3 - k1);

    /* theta2 */
    const dhgen_wide v1 = m3 + m2 * N3, v2 = T24 * v1, v3 = T14 * v1, v4 = w3 * (m2 * T14),
        v5 = w3 * (m2 * T24), angle3 = dhgen_atan2_wide(v2 - v4, v3 + v5),
        angle4 = dhgen_atan2_wide(v2 + v4, v3 - v5);

    /* is the pose one that the arm can take? */
    const dhgen_wide v6 = 1.0 + T33, v7 = T21 * T21 + T11 * T11 - 1.0;

    /* joint values */
    const dhgen_wide v8 = angle1 - (angle2 + angle3), v9 = angle1 - (angle4 - angle2),
        q1_p = w3 - w3 + T34;

    q[0] = q1_p; q[1] = angle3; q[2] = angle2; q[3] = dhgen_centred_wide(v8);
    kind[0] = dhgen_kind_wide(q[0]);
    q[4] = q1_p; q[5] = angle4; q[6] = -angle2; q[7] = dhgen_centred_wide(v9);
    kind[1] = dhgen_kind_wide(q[4]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D3_squared) <= m1) | (m4 < v6 * v6 + T31 * T31 + T23 *
        T23 + T13 * T13 + v7 * v7));
}

#if DHGEN_LANES > 1
/* One regular pose, one sign in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    const dhgen_four e3 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta3 */
    const double N3 = T14 * T14 + T24 * T24, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = sqrt(D3_squared);

    /* theta2 */
    const double v1 = m3 + m2 * N3, v2 = T24 * v1, v3 = T14 * v1;

    /* is the pose one that the arm can take? */
    const double v4 = 1.0 + T33, v5 = T21 * T21 + T11 * T11 - 1.0;

    /* joint values */
    const double q1 = w3 - w3 + T34;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) |
        (unsigned)((fabs(D3_squared) <= m1) | (m4 < v4 * v4 + T31 * T31 + T23 * T23 + T13 * T13 + v5
        * v5)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(dhgen_shuffle(v2 - w3 * (m2 *
        (e3 * T14)), dhgen_all_four(T21), 0, 1, 6, 3), dhgen_all_four(w3), 0, 1, 2, 7),
        dhgen_shuffle(dhgen_shuffle(v3 + w3 * (m2 * (e3 * T24)), dhgen_all_four(T11), 0, 1, 6, 3),
        dhgen_all_four(N3 - k1), 0, 1, 2, 7));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle3 = dhgen_shuffle(packed1, packed1, 0, 1, 0, 1),
        angle1 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2),
        angle2 = dhgen_shuffle(packed1, packed1, 3, 3, 3, 3);
    const dhgen_four q3 = e3 * angle2, v6 = angle1 - (angle3 + q3), q4 = dhgen_centred_four(v6);

    dhgen_store_4(q, q + 4, q, q + 4, dhgen_all_four(q1), angle3, q3, q4);
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
DHGEN_TABLE struct dhgen_arm arm = {
    4, 2, 0, DHGEN_POSE, joints, NULL, 0,
    { 1.818, 1.818, 1.818, 1.0, 1.0, 1.0 }, 1.8181818181818181, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    1, /* follows seed */ NULL, NULL, NULL, NULL, scara_prrr_fk, scara_prrr_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) scara_prrr_##function
#include "dhgen/functions.h"

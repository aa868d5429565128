/* epson_t3: Epson T3
 *
 * Inverse kinematics, generated from robots/epson_t3.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/epson_t3.yaml. The formulas and where they come from: epson_t3.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 564f247b71bc89ac
 * SPDX-License-Identifier: MIT
 */
#include "epson_t3.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(EPSON_T3_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(EPSON_T3_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 4
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef EPSON_T3_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    a1 = 0.225, /* link length 1 [m] */
    a2 = 0.175, /* link length 2 [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    longest2 = 0.16000000000000003, /* square of the longest reach [m^2] */
    shortest2 = 0.002500000000000002, /* square of the shortest reach [m^2] */
    longest2_reach = 0.16000000000003203, /* the longest, with what rounding adds [m^2] */
    shortest2_reach = 0.0024999999999960015, /* the shortest, with what rounding adds [m^2] */
    longest2_apart = 0.1599999999999968, /* the longest, where branches merge [m^2] */
    shortest2_apart = 0.002500000000000401, /* the shortest, where branches merge [m^2] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 4.000000000000001e-06, /* a pose may be rounded by this [m] */
    k1 = 0.08125, /* a1^2 + a2^2 [m^2] */
    k2 = 12.6984126984127; /* 1 / (2 * a2 * a1) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const epson_t3_branches[2] = {
    "right", "left",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[4] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.303834612632515, 2.303834612632515, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.4609142453120048, 2.4609142453120048, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.15, 0.0, 4e-10, 6.249999999999999, 0.4, 0.0046875, 0 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[4][4] = {
    { 0.0, 0.0, 0.225, 0.0 },
    { 0.0, 0.0, 0.175, 0.0 },
    { 0.0, 0.0, 0.0, 3.141592653589793 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 4, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 6

DHGEN_PUBLIC void epson_t3_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - s1 * s2, x2_y = s1 * c2 + c1 * s2;
    const double c4 = cos(q[3]), s4 = sin(q[3]), v1 = x2_y * s4, v2 = x2_y * c4;
    T[0] = x2_x * c4 + v1; T[1] = v2 - x2_x * s4; T[2] = 0.0; T[3] = c1 * a1 + x2_x * a2;
    T[4] = v2 + -x2_x * s4; T[5] = -x2_x * c4 - v1; T[6] = 0.0; T[7] = s1 * a1 + x2_y * a2;
    T[8] = 0.0; T[9] = 0.0; T[10] = -1.0; T[11] = q[2];
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void epson_t3_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), p2_x = p1_x + (c1 * c2 - s1 * s2) * a2,
        p2_y = p1_y + (s1 * c2 + c1 * s2) * a2;
    J[0] = -p2_y; J[1] = p1_y - p2_y; J[2] = 0.0; J[3] = 0.0;
    J[4] = p2_x; J[5] = p2_x - p1_x; J[6] = 0.0; J[7] = 0.0;
    J[8] = 0.0; J[9] = 0.0; J[10] = 1.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = 0.0;
    J[16] = 0.0; J[17] = 0.0; J[18] = 0.0; J[19] = 0.0;
    J[20] = 1.0; J[21] = 1.0; J[22] = 0.0; J[23] = -1.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[4] = (double (*)[4])rows;
    (void)free_joints; (void)seed; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta12m4, type 3: U0[2, 1] and U0[1, 1] */
    const double w12m4 = sqrt(T21 * T21 + T11 * T11);
    const int short12m4 = w12m4 <= free_limit;
    const double v1 = 1.0 / (short12m4 ? 1.0 : w12m4);
    const double c12m4 = T11 * v1;
    const double s12m4 = T21 * v1;
    const double theta12m4 = atan2(s12m4, c12m4);

    /* theta2, type 8: U0[1, 4] and U0[2, 4] */
    const double N2 = T14 * T14 + T24 * T24;
    const double K2 = N2 - k1;
    const double D2_squared = (longest2 - N2) * (N2 - shortest2);
    const int apart2 = shortest2_apart < N2 && N2 < longest2_apart;
    if (!(shortest2_reach <= N2 && N2 <= longest2_reach)) return; /* out of reach */
    const double w2 = sqrt(apart2 ? D2_squared : 0.0);
    const double c2 = K2 * k2;

    /* theta1, type 3: U0[2, 4] and U0[1, 4] */
    const double X1_1 = a1 + a2 * c2;
    const double v2 = T24 * X1_1, v3 = T14 * X1_1;

    /* is the pose one that the arm can take? */
    if (!(fabs(1.0 + T33) <= pose_slack && fabs(T31) <= pose_slack && fabs(T23) <= pose_slack &&
        fabs(T21 - s12m4) <= pose_slack && fabs(T11 - c12m4) <= pose_slack && fabs(T13) <=
        pose_slack))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e2 = i1 == 0 ? 1.0 : -1.0;
        /* theta2 */
        if (e2 < 0.0 && !apart2) continue; /* both signs give the same */
        const double s2 = w2 * e2 * k2;
        const double q2 = atan2(s2, c2);

        /* theta1 */
        const double Y1_1 = a2 * s2;
        const double S1 = v2 - T14 * Y1_1;
        const double C1 = v3 + T24 * Y1_1;
        const double w1 = sqrt(S1 * S1 + C1 * C1);
        const double factor1 = 1.0 / w1;
        const double c1 = C1 * factor1, s1 = S1 * factor1;
        const double q1 = atan2(s1, c1);

        /* is the pose one that the arm can take? */
        const double c12 = c2 * c1 - s2 * s1, s12 = c2 * s1 + s2 * c1;
        if (!(fabs(T14 - (a2 * c12 + a1 * c1)) <= pose_slack1 && fabs(T24 - (a2 * s12 + a1 * s1)) <=
            pose_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q4 = dhgen_wrap(q2 + q1 - theta12m4);
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = T34; q[row][3] = q4;
        status[row] = DHGEN_OK;
    }
}

#ifndef EPSON_T3_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
static const double
    per_size = 2.5, /* slides beyond limits count in the arm's size [m^-1] */
    /* 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4] */
    m1 = 5.0709436649753e-13,
    m2 = 2.2222222222222223, /* a2 * k2 [m^-1] */
    m3 = 0.04444444444444444, /* a1 - a2 * k1 * k2 [m] */
    m4 = 1.0000000000000002e-10; /* pose_slack^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta12m4 */
    const dhgen_wide angle1 = dhgen_atan2_wide(T21, T11);

    /* theta2 */
    const dhgen_wide N2 = T14 * T14 + T24 * T24, D2_squared = (longest2 - N2) * (N2 - shortest2),
        w2 = dhgen_sqrt_wide(D2_squared), angle2 = dhgen_atan2_wide(w2, N2 - k1);

    /* theta1 */
    const dhgen_wide v1 = m3 + m2 * N2, v2 = T24 * v1, v3 = T14 * v1, v4 = w2 * (m2 * T14),
        v5 = w2 * (m2 * T24), angle3 = dhgen_atan2_wide(v2 - v4, v3 + v5),
        angle4 = dhgen_atan2_wide(v2 + v4, v3 - v5);

    /* is the pose one that the arm can take? */
    const dhgen_wide v6 = 1.0 + T33, v7 = T21 * T21 + T11 * T11 - 1.0;

    /* joint values */
    const dhgen_wide v8 = angle2 + angle3 - angle1, v9 = angle4 - angle2 - angle1,
        q3_p = w2 - w2 + T34,
        v10 = dhgen_maximum_wide(dhgen_exceeds_wide(angle2, joints + 1), per_size *
            dhgen_beyond_wide(T34, joints + 2)),
        excess_p = dhgen_maximum_wide(v10, dhgen_exceeds_wide(angle3, joints)),
        excess_m = dhgen_maximum_wide(v10, dhgen_exceeds_wide(angle4, joints));

    q[0] = angle3; q[1] = angle2; q[2] = q3_p; q[3] = dhgen_centred_wide(v8);
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_p);
    q[4] = angle4; q[5] = -angle2; q[6] = q3_p; q[7] = dhgen_centred_wide(v9);
    kind[1] = dhgen_kind_within_wide(q[4], 0.0 < excess_m);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D2_squared) <= m1) | (m4 < v6 * v6 + T31 * T31 + T23 *
        T23 + T13 * T13 + v7 * v7)) | (dhgen_within_slack_wide(excess_p) |
        dhgen_within_slack_wide(excess_m));
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

    /* theta2 */
    const double N2 = T14 * T14 + T24 * T24, D2_squared = (longest2 - N2) * (N2 - shortest2),
        w2 = sqrt(D2_squared);

    /* theta1 */
    const double v1 = m3 + m2 * N2, v2 = T24 * v1, v3 = T14 * v1;

    /* is the pose one that the arm can take? */
    const double v4 = 1.0 + T33, v5 = T21 * T21 + T11 * T11 - 1.0;

    /* joint values */
    const double q3 = w2 - w2 + T34;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) |
        (unsigned)((fabs(D2_squared) <= m1) | (m4 < v4 * v4 + T31 * T31 + T23 * T23 + T13 * T13 + v5
        * v5)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(dhgen_shuffle(v2 - w2 * (m2 *
        (e2 * T14)), dhgen_all_four(T21), 0, 1, 6, 3), dhgen_all_four(w2), 0, 1, 2, 7),
        dhgen_shuffle(dhgen_shuffle(v3 + w2 * (m2 * (e2 * T24)), dhgen_all_four(T11), 0, 1, 6, 3),
        dhgen_all_four(N2 - k1), 0, 1, 2, 7));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle3 = dhgen_shuffle(packed1, packed1, 0, 1, 0, 1),
        angle1 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2),
        angle2 = dhgen_shuffle(packed1, packed1, 3, 3, 3, 3);
    const dhgen_four q2 = e2 * angle2, v6 = angle3 + q2 - angle1, q4 = dhgen_centred_four(v6),
        v7 = dhgen_maximum_four(dhgen_exceeds_four(angle2, joints + 1), dhgen_all_four(per_size *
            dhgen_maximum_double(dhgen_low(joints + 2) - T34, T34 - dhgen_high(joints + 2)))),
        excess = dhgen_maximum_four(v7, dhgen_exceeds_four(angle3, joints));
    const dhgen_four_mask outside = 0.0 < excess;
    if (dhgen_bits_four(dhgen_within_slack_four(excess)))
        return -1;

    dhgen_store_4(q, q + 4, q, q + 4, angle3, q2, dhgen_all_four(q3), q4);
    const unsigned long long none1 = (dhgen_bits_four(angle3 != angle3) * 0x81ull & 0x101ull);
    const unsigned long long outside1 = (dhgen_bits_four(outside) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE + (outside1 & ~none1) *
        DHGEN_OUT_OF_LIMITS;
    __builtin_memcpy(status, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~(none1 | outside1));
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    4, 2, 0, DHGEN_POSE, joints, NULL, 0,
    { 2.5, 2.5, 2.5, 1.0, 1.0, 1.0 }, 2.5, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */ 1, /* range exceeds a turn */
    1, /* follows seed */ NULL, NULL, NULL, NULL, epson_t3_fk, epson_t3_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) epson_t3_##function
#include "dhgen/functions.h"

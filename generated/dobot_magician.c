/* dobot_magician: Dobot Magician, its hand's joint
 *
 * Inverse kinematics, generated from robots/dobot_magician.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/dobot_magician.yaml. The formulas and where they come from:
 * dobot_magician.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 45a194be1a673098
 * SPDX-License-Identifier: MIT
 */
#include "dobot_magician.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(DOBOT_MAGICIAN_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(DOBOT_MAGICIAN_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef DOBOT_MAGICIAN_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.139, /* joint offset 1 [m] */
    a2 = 0.135, /* link length 2 [m] */
    a3 = 0.147, /* link length 3 [m] */
    free_limit1 = 4.21e-13, /* a length that fixes no angle [m] */
    longest3 = 0.07952400000000001, /* square of the longest reach [m^2] */
    shortest3 = 0.0001439999999999996, /* square of the shortest reach [m^2] */
    longest3_reach = 0.07952400000002374, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0001439999999989892, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.07952399999999764, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.00014400000000010064, /* the shortest, where branches merge [m^2] */
    offset2 = -1.5707963267948966, /* offset of joint 2 [rad] */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    k1 = 0.039834, /* a2^2 + a3^2 [m^2] */
    k2 = 25.195263290501387; /* 1 / (2 * a3 * a2) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const dobot_magician_branches[4] = {
    "back-down", "back-up", "front-up", "front-down",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -1.5707963267948966, 1.5707963267948966, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { 0.0, 1.4835298641951802, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.17453292519943295, 1.6580627893946132, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.139, 0.0, -1.5707963267948966 },
    { -1.5707963267948966, 0.0, 0.135, 0.0 },
    { 1.5707963267948966, 0.0, 0.147, 0.0 },
};
DHGEN_TABLE double drives[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 1.0 };
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], drives, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void dobot_magician_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2, v4 = q[2] - q[1] + offset3;
    const double c3 = cos(v4), s3 = sin(v4), x3_x = x2_x * c3 - v2 * s3, x3_y = x2_y * c3 - v3 * s3,
        v5 = s2 * c3 + c2 * s3;
    T[0] = x3_x; T[1] = -(v2 * c3 + x2_x * s3); T[2] = -s1; T[3] = x2_x * a2 + x3_x * a3;
    T[4] = x3_y; T[5] = -(v3 * c3 + x2_y * s3); T[6] = c1; T[7] = x2_y * a2 + x3_y * a3;
    T[8] = -v5; T[9] = s2 * s3 - c2 * c3; T[10] = 0.0; T[11] = d1 - s2 * a2 - v5 * a3;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void dobot_magician_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, p2_x = x2_x * a2,
        p2_y = x2_y * a2, p2_z = d1 - s2 * a2, v2 = q[2] - q[1] + offset3;
    const double c3 = cos(v2), s3 = sin(v2), p3_x = p2_x + (x2_x * c3 - c1 * s2 * s3) * a3,
        p3_y = p2_y + (x2_y * c3 - s1 * s2 * s3) * a3, p3_z = p2_z - (s2 * c3 + c2 * s3) * a3,
        v3 = p3_z - d1, v4 = p3_z - p2_z, J13 = c1 * v4, J23 = s1 * v4,
        v5 = s1 * (p3_y - p2_y) + c1 * (p3_x - p2_x);
    J[0] = -p3_y; J[1] = c1 * v3 - J13; J[2] = J13;
    J[3] = p3_x; J[4] = s1 * v3 - J23; J[5] = J23;
    J[6] = 0.0; J[7] = v5 - (s1 * p3_y + c1 * p3_x); J[8] = -v5;
    J[9] = 0.0; J[10] = 0.0; J[11] = -s1;
    J[12] = 0.0; J[13] = 0.0; J[14] = c1;
    J[15] = 1.0; J[16] = 0.0; J[17] = 0.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[3, 4] */
    const double w1 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double Z1_3 = T34 - d1;
    const double v1 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(T14 * factor1),
            s1 = free1 ? sin(seed[0]) : -(T24 * factor1);
        const double q1 = atan2(s1, c1);
        const double D1 = w1 * e1;

        /* theta3 */
        const double N3 = v1 + D1 * D1;
        const double K3 = N3 - k1;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double c3 = K3 * k2;

        /* theta2, type 3: U1[1, 4] and U1[2, 4] */
        const double Y1_2 = a2 + a3 * c3;
        const double v3 = Z1_3 * Y1_2, v4 = D1 * Y1_2;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e3 * k2;

            /* theta2 */
            const double v2 = a3 * s3;
            const double S2 = D1 * v2 - v3;
            const double v5 = Z1_3 * v2 + v4;
            const double w2 = sqrt(S2 * S2 + v5 * v5);
            const double factor2 = 1.0 / w2;
            const double c2 = -(v5 * factor2), s2 = S2 * factor2;

            /* joint values */
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);
            const double q3 = dhgen_wrap(q2 + (atan2(s3, c3) - offset3));
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
            status[row] = free1 ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef DOBOT_MAGICIAN_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 4.21e-05 [m]. */
static const double
    m1 = 1.77241e-09, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 1.8837681414751167e-13,
    m4 = 3.7037037037037037, /* a3 * k2 [m^-1] */
    m5 = 0.012533333333333329; /* a3 * k1 * k2 - a2 [m] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T14 * T14 + T24 * T24, w1 = dhgen_sqrt_wide(v1),
        angle1 = dhgen_atan2_wide(-T24, -T14),
        q1__m = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, -T24);

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d1, N3 = v1 + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_wide(D3_squared),
        v2 = w3 - w3;

    /* theta2 */
    const dhgen_wide v3 = m5 - m4 * N3, v4 = Z1_3 * v3, v5 = w3 * (m4 * Z1_3),
        v6 = w3 * (m4 * -Z1_3), v7 = w1 * -v3, v8 = w1 * v3;

    /* joint values */
    const dhgen_wide v9 = w3 * (m4 * w1), v10 = v4 + v9, angle2 = dhgen_atan2_wide(v10, -(v5 + v7)),
        v11 = angle2 - offset2, v12 = v4 - v9, angle3 = dhgen_atan2_wide(v12, -(v6 + v7)),
        v13 = angle3 - offset2, angle4 = dhgen_atan2_wide(v12, -(v5 + v8)), v14 = angle4 - offset2,
        angle5 = dhgen_atan2_wide(v10, -(v6 + v8)), v15 = angle5 - offset2,
        q2_pp = dhgen_lowered_wide(v11), q2_pm = dhgen_lowered_wide(v13),
        q2_mp = dhgen_lowered_wide(v14), q2_mm = dhgen_lowered_wide(v15),
        angle6 = dhgen_atan2_wide(w3, N3 - k1), v16 = angle6 - offset3, v17 = offset3 + angle6,
        q3_pp = dhgen_wrap_wide(q2_pp + v16), q3_pm = dhgen_wrap_wide(q2_pm - v17),
        q3_mp = dhgen_wrap_wide(q2_mp + v16), q3_mm = dhgen_wrap_wide(q2_mm - v17),
        v18 = dhgen_exceeds_wide(angle1, joints), v19 = dhgen_exceeds_wide(q1__m, joints),
        q1_pp = angle1 + v2, q1_mp = q1__m + v2,
        excess_pp = dhgen_maximum_wide(dhgen_beyond_wide(q3_pp, joints + 2), dhgen_maximum_wide(v18,
            dhgen_beyond_wide(q2_pp, joints + 1))),
        excess_pm = dhgen_maximum_wide(dhgen_beyond_wide(q3_pm, joints + 2), dhgen_maximum_wide(v18,
            dhgen_beyond_wide(q2_pm, joints + 1))),
        excess_mp = dhgen_maximum_wide(dhgen_beyond_wide(q3_mp, joints + 2), dhgen_maximum_wide(v19,
            dhgen_beyond_wide(q2_mp, joints + 1))),
        excess_mm = dhgen_maximum_wide(dhgen_beyond_wide(q3_mm, joints + 2), dhgen_maximum_wide(v19,
            dhgen_beyond_wide(q2_mm, joints + 1)));

    q[0] = q1_pp; q[1] = q2_pp; q[2] = q3_pp;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_pp);
    q[3] = q1_pp; q[4] = q2_pm; q[5] = q3_pm;
    kind[1] = dhgen_kind_within_wide(q[3], 0.0 < excess_pm);
    q[6] = q1_mp; q[7] = q2_mp; q[8] = q3_mp;
    kind[2] = dhgen_kind_within_wide(q[6], 0.0 < excess_mp);
    q[9] = q1_mp; q[10] = q2_mm; q[11] = q3_mm;
    kind[3] = dhgen_kind_within_wide(q[9], 0.0 < excess_mm);
    const dhgen_wide_mask exact = 0.0 * (T[3] + T[7] + T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v1 <= m1) | (dhgen_abs_wide(D3_squared) <= m3)) |
        (dhgen_within_slack_wide(excess_mm) | dhgen_within_slack_wide(excess_mp) |
        dhgen_within_slack_wide(excess_pp) | dhgen_within_slack_wide(excess_pm));
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
    const dhgen_four e3 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double v1 = T14 * T14 + T24 * T24, w1 = sqrt(v1), v2 = copysign(DHGEN_HALF_TURN, -T24);

    /* theta3 */
    const double Z1_3 = T34 - d1, N3 = v1 + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared), v3 = w3 - w3;

    /* theta2 */
    const double v4 = m5 - m4 * N3, v5 = Z1_3 * v4;
    const dhgen_four v6 = w3 * (m4 * (e3 * Z1_3)), v7 = w1 * (e1 * -v4);

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] + T[7] + T[11])) <= DHGEN_ORTHONORMAL) == 0)) |
        (unsigned)((v1 <= m1) | (fabs(D3_squared) <= m3)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-T24, w3, -T24, -T24),
        dhgen_four_of(-T14, N3 - k1, -T14, -T14)),
        ratio2 = dhgen_ratio_four(v5 + w3 * (m4 * (w1 * (e1 * e3))), -(v6 + v7));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle3 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle2 = dhgen_angle_four(ratio2);
    const dhgen_four q1_ = angle1 + v2 * (m2 * (e1 - 1.0)), v8 = angle2 - offset2,
        q2 = dhgen_lowered_four(v8), v9 = e3 * angle3 - offset3, q3 = dhgen_wrap_four(q2 + v9),
        v10 = dhgen_exceeds_four(q1_, joints), q1 = q1_ + v3,
        excess = dhgen_maximum_four(dhgen_beyond_four(q3, joints + 2), dhgen_maximum_four(v10,
            dhgen_beyond_four(q2, joints + 1)));
    const dhgen_four_mask outside = 0.0 < excess;
    if (dhgen_bits_four(dhgen_within_slack_four(excess)))
        return -1;

    dhgen_store_2(q, q + 3, q + 6, q + 9, q1, q2);
    dhgen_store_1(q + 2, q + 5, q + 8, q + 11, q3);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long outside1 = (dhgen_bits_four(outside) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE + (outside1 & ~none1) *
        DHGEN_OUT_OF_LIMITS;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~(none1 | outside1));
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[3] = { 3, 7, 11 };
DHGEN_TABLE int choosable[1] = { 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 4, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 2.375, 2.375, 2.375, 0.0, 0.0, 0.0 }, 2.375296912114014, { 1e-14, 1e-14 }, entries, 3,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, dobot_magician_fk,
    dobot_magician_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) dobot_magician_##function
#include "dhgen/functions.h"

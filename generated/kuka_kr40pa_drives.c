/* kuka_kr40pa_drives: KUKA KR 40 PA palletizer, its hand's joint, by its drives
 *
 * Inverse kinematics, generated from robots/kuka_kr40pa_drives.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_kr40pa_drives.yaml. The formulas and where they come from:
 * kuka_kr40pa_drives.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: a161591f8bab6b71
 * SPDX-License-Identifier: MIT
 */
#include "kuka_kr40pa_drives.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KUKA_KR40PA_DRIVES_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KUKA_KR40PA_DRIVES_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef KUKA_KR40PA_DRIVES_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.3, /* joint offset 1 [m] */
    a1 = 0.15, /* link length 1 [m] */
    a2 = 0.8, /* link length 2 [m] */
    a3 = 0.8, /* link length 3 [m] */
    free_limit1 = 2.05e-12, /* a length that fixes no angle [m] */
    longest3 = 2.5600000000000005, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    longest3_reach = 2.560000000000656, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 2.5599999999999348, /* the longest, where branches merge [m^2] */
    shortest3_apart = 4.202499999999999e-28, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 4.2024999999999996e-24, /* square of a length that fixes no angle [m^2] */
    k1 = 1.2800000000000002, /* 2 * a3 * a2 [m^2] */
    k2 = 0.7812499999999999; /* 1 / k1 [m^-2] */

#ifndef __CUDACC_RTC__
const char *const kuka_kr40pa_drives_branches[4] = {
    "back-down", "back-up", "front-up", "front-down",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.705260340591211, 2.705260340591211, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.2165681500327987, 0.3490658503988659, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.3490658503988659, 2.2689280275926285, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.3, 0.15, -1.5707963267948966 },
    { 0.0, 0.0, 0.8, 0.0 },
    { 0.0, 0.0, 0.8, 0.0 },
};
DHGEN_TABLE double drives[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 1.0 };
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], drives, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void kuka_kr40pa_drives_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, v3 = q[2] - q[1];
    const double c3 = cos(v3), s3 = sin(v3), x3_x = x2_x * c3 - v1 * s3, x3_y = x2_y * c3 - v2 * s3,
        v4 = s2 * c3 + c2 * s3;
    T[0] = x3_x; T[1] = -(v1 * c3 + x2_x * s3); T[2] = -s1; T[3] = c1 * a1 + x2_x * a2 + x3_x * a3;
    T[4] = x3_y; T[5] = -(v2 * c3 + x2_y * s3); T[6] = c1; T[7] = s1 * a1 + x2_y * a2 + x3_y * a3;
    T[8] = -v4; T[9] = s2 * s3 - c2 * c3; T[10] = 0.0; T[11] = d1 - s2 * a2 - v4 * a3;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void kuka_kr40pa_drives_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2,
        p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 - s2 * a2, v1 = q[2] - q[1];
    const double c3 = cos(v1), s3 = sin(v1), p3_x = p2_x + (x2_x * c3 - c1 * s2 * s3) * a3,
        p3_y = p2_y + (x2_y * c3 - s1 * s2 * s3) * a3, p3_z = p2_z - (s2 * c3 + c2 * s3) * a3,
        v2 = p3_z - d1, v3 = p3_z - p2_z, J13 = c1 * v3, J23 = s1 * v3,
        v4 = s1 * (p3_y - p2_y) + c1 * (p3_x - p2_x);
    J[0] = -p3_y; J[1] = c1 * v2 - J13; J[2] = J13;
    J[3] = p3_x; J[4] = s1 * v2 - J23; J[5] = J23;
    J[6] = 0.0; J[7] = v4 - (s1 * (p3_y - p1_y) + c1 * (p3_x - p1_x)); J[8] = -v4;
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
    const double v2 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(T14 * factor1),
            s1 = free1 ? sin(seed[0]) : -(T24 * factor1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double v1 = w1 * e1 + a1;
        const double N3 = v2 + v1 * v1;
        const double K3 = N3 - k1;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double c3 = K3 * k2;

        /* theta2, type 3: U1[1, 4] and U1[2, 4] */
        const double Y1_2 = a2 + a3 * c3;
        const double v4 = Z1_3 * Y1_2, v5 = v1 * Y1_2;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e3 * k2;

            /* theta2 */
            const double v3 = a3 * s3;
            const double S2 = v1 * v3 - v4;
            const double v6 = Z1_3 * v3 + v5;
            const double w2 = sqrt(S2 * S2 + v6 * v6);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : -(v6 * factor2),
                s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);

            /* joint values */
            const double q3 = dhgen_wrap(atan2(s3, c3) + q2);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
            status[row] = (free1 || free2) ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef KUKA_KR40PA_DRIVES_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.000205 [m]. */
static const double
    /* square of a length that fixes no angle [m^2] */
    doubt_limit_squared2 = 4.2024999999999994e-08,
    m1 = 4.2025e-08, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 1.6825651982798743e-10,
    m4 = 0.625; /* a3 * k2 [m^-1] */

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
    const dhgen_wide Z1_3 = T34 - d1, v2 = a1 + w1, v3 = a1 - w1, v4 = Z1_3 * Z1_3,
        N3_p = v4 + v2 * v2, N3_m = v4 + v3 * v3,
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m);

    /* theta2 */
    const dhgen_wide v5 = m4 * (N3_p * -Z1_3), v6 = m4 * (N3_m * -Z1_3), v7 = m4 * Z1_3,
        v8 = m4 * -Z1_3, v9 = m4 * (v2 * N3_p), v10 = m4 * (v3 * N3_m), v11 = w3_p * (m4 * v2),
        angle2 = dhgen_atan2_wide(v5 + v11, -(v9 + w3_p * v7)),
        angle3 = dhgen_atan2_wide(v5 - v11, -(v9 + w3_p * v8)),
        angle4 = dhgen_atan2_wide(v6 + w3_m * (m4 * v3), -(v10 + w3_m * v7)),
        angle5 = dhgen_atan2_wide(v6 + w3_m * (m4 * -v3), -(v10 + w3_m * v8));

    /* joint values */
    const dhgen_wide angle6 = dhgen_atan2_wide(w3_p, N3_p - k1),
        angle7 = dhgen_atan2_wide(w3_m, N3_m - k1), v12 = angle2 + angle6, v13 = angle3 - angle6,
        v14 = angle4 + angle7, v15 = angle5 - angle7, q3_pp = dhgen_centred_wide(v12),
        q3_pm = dhgen_centred_wide(v13), q3_mp = dhgen_centred_wide(v14),
        q3_mm = dhgen_centred_wide(v15), v16 = dhgen_exceeds_wide(angle1, joints),
        v17 = dhgen_exceeds_wide(q1__m, joints), q1_pp = angle1 + (w3_p - w3_p),
        q1_mp = q1__m + (w3_m - w3_m),
        excess_pp = dhgen_maximum_wide(dhgen_beyond_wide(q3_pp, joints + 2), dhgen_maximum_wide(v16,
            dhgen_beyond_wide(angle2, joints + 1))),
        excess_pm = dhgen_maximum_wide(dhgen_beyond_wide(q3_pm, joints + 2), dhgen_maximum_wide(v16,
            dhgen_beyond_wide(angle3, joints + 1))),
        excess_mp = dhgen_maximum_wide(dhgen_beyond_wide(q3_mp, joints + 2), dhgen_maximum_wide(v17,
            dhgen_beyond_wide(angle4, joints + 1))),
        excess_mm = dhgen_maximum_wide(dhgen_beyond_wide(q3_mm, joints + 2), dhgen_maximum_wide(v17,
            dhgen_beyond_wide(angle5, joints + 1)));

    q[0] = q1_pp; q[1] = angle2; q[2] = q3_pp;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_pp);
    q[3] = q1_pp; q[4] = angle3; q[5] = q3_pm;
    kind[1] = dhgen_kind_within_wide(q[3], 0.0 < excess_pm);
    q[6] = q1_mp; q[7] = angle4; q[8] = q3_mp;
    kind[2] = dhgen_kind_within_wide(q[6], 0.0 < excess_mp);
    q[9] = q1_mp; q[10] = angle5; q[11] = q3_mm;
    kind[3] = dhgen_kind_within_wide(q[9], 0.0 < excess_mm);
    const dhgen_wide_mask exact = 0.0 * (T[3] + T[7] + T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((N3_m <= doubt_limit_squared2) | (dhgen_abs_wide(D3_squared_m) <= m3) |
        (N3_p <= doubt_limit_squared2) | (v1 <= m1) | (dhgen_abs_wide(D3_squared_p) <= m3)) |
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
    const double Z1_3 = T34 - d1;
    const dhgen_four v3 = a1 + e1 * w1;
    const double v4 = Z1_3 * Z1_3;
    const dhgen_four N3 = v4 + v3 * v3, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared);

    /* theta2 */
    const dhgen_four v5 = m4 * (N3 * -Z1_3), v6 = m4 * (e3 * Z1_3), v7 = m4 * (v3 * N3);

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] + T[7] + T[11])) <= DHGEN_ORTHONORMAL) == 0) |
        ((dhgen_abs_four(D3_squared) <= m3) | (N3 <= doubt_limit_squared2))) | (unsigned)(v1 <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(w3, dhgen_all_four(-T24), 0,
        5, 2, 3), dhgen_shuffle(N3 - k1, dhgen_all_four(-T14), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(v5 + w3 * (m4 * (e3 * v3)), -(v7 + w3 * v6));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle3 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle2 = dhgen_angle_four(ratio2);
    const dhgen_four q1_ = angle1 + v2 * (m2 * (e1 - 1.0)), v8 = angle2 + e3 * angle3,
        q3 = dhgen_centred_four(v8), v9 = dhgen_exceeds_four(q1_, joints), q1 = q1_ + (w3 - w3),
        excess = dhgen_maximum_four(dhgen_beyond_four(q3, joints + 2), dhgen_maximum_four(v9,
            dhgen_beyond_four(angle2, joints + 1)));
    const dhgen_four_mask outside = 0.0 < excess;
    if (dhgen_bits_four(dhgen_within_slack_four(excess)))
        return -1;

    dhgen_store_2(q, q + 3, q + 6, q + 9, q1, angle2);
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
DHGEN_TABLE int choosable[2] = { 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 4, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 0.4878, 0.4878, 0.4878, 0.0, 0.0, 0.0 }, 0.48780487804878053, { 1e-14, 1e-14 }, entries, 3,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL,
    kuka_kr40pa_drives_fk, kuka_kr40pa_drives_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) kuka_kr40pa_drives_##function
#include "dhgen/functions.h"

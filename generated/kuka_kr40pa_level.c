/* kuka_kr40pa_level: KUKA KR 40 PA palletizer, whose rods keep the tool level
 *
 * Inverse kinematics, generated from robots/kuka_kr40pa_level.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_kr40pa_level.yaml. The formulas and where they come from:
 * kuka_kr40pa_level.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 952c9a85242bdf5e
 * SPDX-License-Identifier: MIT
 */
#include "kuka_kr40pa_level.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KUKA_KR40PA_LEVEL_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KUKA_KR40PA_LEVEL_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 4
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef KUKA_KR40PA_LEVEL_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.62, /* joint offset 1 [m] */
    a1 = 0.22, /* link length 1 [m] */
    a2 = 0.85, /* link length 2 [m] */
    a3 = 0.85, /* link length 3 [m] */
    a4 = 0.2, /* link length 3p [m] */
    d5 = 0.19, /* joint offset 4 [m] */
    steep_limit = 1e-06, /* a vertical axis, which has no yaw, is no longer seen from above */
    free_limit1 = 2.9300000000000002e-12, /* a length that fixes no angle [m] */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    longest3 = 2.8899999999999997, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    longest3_reach = 2.890000000000996, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 2.8899999999999, /* the longest, where branches merge [m^2] */
    shortest3_apart = 8.584899999999999e-28, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 8.584900000000001e-24, /* square of a length that fixes no angle [m^2] */
    k1 = 0.43, /* d1 - d5 [m] */
    k2 = 0.42000000000000004, /* a1 + a4 [m] */
    k3 = 1.4449999999999998, /* 2 * a3 * a2 [m^2] */
    k4 = 0.6920415224913495; /* 1 / k3 [m^-2] */

#ifndef __CUDACC_RTC__
const char *const kuka_kr40pa_level_branches[4] = {
    "back-down", "back-up", "front-up", "front-down",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[4] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.705260340591211, 2.705260340591211, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.0943951023931953, -0.2617993877991494, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { 0.2617993877991494, 2.530727415391778, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.1086523819801535, 6.1086523819801535, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[5][4] = {
    { 0.0, 0.62, 0.22, -1.5707963267948966 },
    { 0.0, 0.0, 0.85, 0.0 },
    { 0.0, 0.0, 0.85, 0.0 },
    { 0.0, 0.0, 0.2, -1.5707963267948966 },
    { 3.141592653589793, 0.19, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_joint row_kinds[5] = {
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1 }, { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1 }, { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1 },
};
DHGEN_TABLE struct dhgen_links links = { 5, DHGEN_STANDARD, row_kinds, &table[0][0], NULL, NULL,
    NULL };

DHGEN_PUBLIC void kuka_kr40pa_level_frames(const double q[4], double frames[7][16])
{
    const double moved[5] = { -q[0], q[1], q[2], -q[1] - q[2], -q[3] };
    dhgen_frames(&links, moved, frames);
}

DHGEN_PUBLIC void kuka_kr40pa_level_fk(const double q[4], double T[16])
{
    const double c1 = cos(-q[0]), s1 = sin(-q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), v3 = x2_x * c3 - v1 * s3, v4 = x2_y * c3 - v2 * s3,
        v5 = s2 * c3 + c2 * s3, v6 = v1 * c3 + x2_x * s3, v7 = v2 * c3 + x2_y * s3,
        v8 = s2 * s3 - c2 * c3;
    const double c3p = cos(-(q[1] + q[2]));
    const double s3p = sin(-(q[1] + q[2]));
    const double x3_x = v3 * c3p - v6 * s3p, x3_y = v4 * c3p - v7 * s3p, x3_z = v8 * s3p - v5 * c3p,
        v9 = v6 * c3p + v3 * s3p, v10 = v7 * c3p + v4 * s3p, z3_z = v8 * c3p + v5 * s3p,
        v11 = offset4 - q[3];
    const double c4 = cos(v11), s4 = sin(v11);
    T[0] = x3_x * c4 + s1 * s4; T[1] = s1 * c4 - x3_x * s4; T[2] = -v9;
    T[3] = c1 * a1 + x2_x * a2 + v3 * a3 + x3_x * a4 - v9 * d5;
    T[4] = x3_y * c4 - c1 * s4; T[5] = -(c1 * c4 + x3_y * s4); T[6] = -v10;
    T[7] = s1 * a1 + x2_y * a2 + v4 * a3 + x3_y * a4 - v10 * d5;
    T[8] = x3_z * c4; T[9] = -(x3_z * s4); T[10] = z3_z;
    T[11] = d1 - s2 * a2 - v5 * a3 + x3_z * a4 + z3_z * d5;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void kuka_kr40pa_level_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(-q[0]), s1 = sin(-q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), v3 = x2_x * c3 - v1 * s3, v4 = x2_y * c3 - v2 * s3,
        v5 = s2 * c3 + c2 * s3, v6 = v1 * c3 + x2_x * s3, v7 = v2 * c3 + x2_y * s3,
        v8 = s2 * s3 - c2 * c3, v9 = p2_x + v3 * a3, v10 = p2_y + v4 * a3, v11 = p2_z - v5 * a3;
    const double c3p = cos(-(q[1] + q[2]));
    const double s3p = sin(-(q[1] + q[2]));
    const double J44 = v6 * c3p + v3 * s3p, J54 = v7 * c3p + v4 * s3p, z3_z = v8 * c3p + v5 * s3p,
        p3_x = v9 + (v3 * c3p - v6 * s3p) * a4, p3_y = v10 + (v4 * c3p - v7 * s3p) * a4,
        p3_z = v11 + (v8 * s3p - v5 * c3p) * a4, p4_x = p3_x - J44 * d5, p4_y = p3_y - J54 * d5,
        p4_z = p3_z + z3_z * d5, v12 = p4_z - d1, v13 = p4_z - p2_z, v14 = p4_x - p3_x,
        v15 = p4_y - p3_y, v16 = p4_z - p3_z, v17 = p4_z - v11, v18 = c1 * v17, v19 = s1 * v17,
        v20 = s1 * (p4_y - v10) + c1 * (p4_x - v9);
    J[0] = p4_y; J[1] = c1 * v12 - v18; J[2] = c1 * v13 - v18; J[3] = J54 * v16 + z3_z * v15;
    J[4] = -p4_x; J[5] = s1 * v12 - v19; J[6] = s1 * v13 - v19; J[7] = -(z3_z * v14 + J44 * v16);
    J[8] = 0.0; J[9] = v20 - (s1 * (p4_y - p1_y) + c1 * (p4_x - p1_x));
    J[10] = v20 - (s1 * (p4_y - p2_y) + c1 * (p4_x - p2_x)); J[11] = J44 * v15 - J54 * v14;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = J44;
    J[16] = 0.0; J[17] = 0.0; J[18] = 0.0; J[19] = J54;
    J[20] = -1.0; J[21] = 0.0; J[22] = 0.0; J[23] = -z3_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[4] = (double (*)[4])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* the yaw's cosine and sine */
    const double level = sqrt(T11 * T11 + T21 * T21);
    const int steep = level <= steep_limit;
    const double factor_yaw = 1.0 / (steep ? 1.0 : level);
    const double t11 = T11 * factor_yaw;
    const double t21 = T21 * factor_yaw;

    /* theta1, type 2: U1[3, 4] */
    const double w1 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta4, type 3: U1[1, 1] and U1[3, 1] */
    const double v1 = offset4 - seed[3];

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double Z1_3 = T34 - k1;
    const double v3 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(-seed[0]) : -(T14 * factor1),
            s1 = free1 ? sin(-seed[0]) : -(T24 * factor1);

        /* theta4 */
        const double c4 = steep ? cos(v1) : t11 * c1 + t21 * s1,
            s4 = steep ? sin(v1) : t11 * s1 - t21 * c1;

        /* theta3 */
        const double v2 = w1 * e1 + k2;
        const double N3 = v3 + v2 * v2;
        const double K3 = N3 - k3;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double c3 = K3 * k4;

        /* theta2, type 3: U1[1, 4] and U1[2, 4] */
        const double Y1_2 = a2 + a3 * c3;
        const double v5 = Z1_3 * Y1_2, v6 = v2 * Y1_2;

        /* joint values */
        const double q4 = dhgen_wrap(offset4 - atan2(s4, c4));

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e3 * k4;
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double v4 = a3 * s3;
            const double S2 = v2 * v4 - v5;
            const double v7 = Z1_3 * v4 + v6;
            const double w2 = sqrt(S2 * S2 + v7 * v7);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : -(v7 * factor2),
                s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);
            const int row = 2 * i1 + i2;
            q[row][0] = -atan2(s1, c1); q[row][1] = q2; q[row][2] = q3; q[row][3] = q4;
            status[row] = (free1 || free2 || steep) ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef KUKA_KR40PA_LEVEL_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.000293 [m]. */
static const double
    doubt_limit_squared2 = 8.584900000000002e-08, /* square of a length that fixes no angle [m^2] */
    m1 = 1e-12, /* steep_limit^2 */
    m2 = 8.584900000000002e-08, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 2.874855908885266e-10,
    m4 = 0.5882352941176471; /* a3 * k4 [m^-1] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T14 * T14 + T24 * T24, w1 = dhgen_sqrt_wide(v1);

    /* theta4 */
    const dhgen_wide s4 = T14 * T21 - T24 * T11;

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - k1, v2 = k2 + w1, v3 = k2 - w1, v4 = Z1_3 * Z1_3,
        N3_p = v4 + v2 * v2, N3_m = v4 + v3 * v3,
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m), v5 = w3_p - w3_p, v6 = w3_m - w3_m,
        angle1 = dhgen_atan2_wide(w3_p, N3_p - k3), angle2 = dhgen_atan2_wide(w3_m, N3_m - k3);

    /* theta2 */
    const dhgen_wide v7 = m4 * (N3_p * -Z1_3), v8 = m4 * (N3_m * -Z1_3), v9 = m4 * Z1_3,
        v10 = m4 * -Z1_3, v11 = m4 * (v2 * N3_p), v12 = m4 * (v3 * N3_m), v13 = w3_p * (m4 * v2),
        angle3 = dhgen_atan2_wide(v7 + v13, -(v11 + w3_p * v9)),
        angle4 = dhgen_atan2_wide(v7 - v13, -(v11 + w3_p * v10)),
        angle5 = dhgen_atan2_wide(v8 + w3_m * (m4 * v3), -(v12 + w3_m * v9)),
        angle6 = dhgen_atan2_wide(v8 + w3_m * (m4 * -v3), -(v12 + w3_m * v10));

    /* joint values */
    const dhgen_wide angle7 = dhgen_atan2_wide(s4, -(T14 * T11 + T24 * T21)),
        v14 = offset4 - angle7, v15 = offset4 - (angle7 - dhgen_signed_wide(DHGEN_HALF_TURN, s4)),
        angle8 = dhgen_atan2_wide(-T24, -T14),
        v16 = angle8 - dhgen_signed_wide(DHGEN_HALF_TURN, -T24),
        v17 = dhgen_exceeds_wide(angle8, joints), v18 = dhgen_exceeds_wide(v16, joints),
        q1_pp = v5 - angle8, q1_mp = v6 - v16, q4_pp = v5 + dhgen_lowered_wide(v14),
        q4_mp = v6 + dhgen_lowered_wide(v15),
        excess_pp = dhgen_maximum_wide(dhgen_beyond_wide(angle1, joints + 2),
            dhgen_maximum_wide(v17, dhgen_beyond_wide(angle3, joints + 1))),
        excess_pm = dhgen_maximum_wide(dhgen_maximum_wide(dhgen_low(joints + 2) + angle1,
            -(dhgen_high(joints + 2) + angle1)), dhgen_maximum_wide(v17, dhgen_beyond_wide(angle4,
            joints + 1))),
        excess_mp = dhgen_maximum_wide(dhgen_beyond_wide(angle2, joints + 2),
            dhgen_maximum_wide(v18, dhgen_beyond_wide(angle5, joints + 1))),
        excess_mm = dhgen_maximum_wide(dhgen_maximum_wide(dhgen_low(joints + 2) + angle2,
            -(dhgen_high(joints + 2) + angle2)), dhgen_maximum_wide(v18, dhgen_beyond_wide(angle6,
            joints + 1)));

    q[0] = q1_pp; q[1] = angle3; q[2] = angle1; q[3] = q4_pp;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_pp);
    q[4] = q1_pp; q[5] = angle4; q[6] = -angle1; q[7] = q4_pp;
    kind[1] = dhgen_kind_within_wide(q[4], 0.0 < excess_pm);
    q[8] = q1_mp; q[9] = angle5; q[10] = angle2; q[11] = q4_mp;
    kind[2] = dhgen_kind_within_wide(q[8], 0.0 < excess_mp);
    q[12] = q1_mp; q[13] = angle6; q[14] = -angle2; q[15] = q4_mp;
    kind[3] = dhgen_kind_within_wide(q[12], 0.0 < excess_mm);
    const dhgen_wide_mask exact = 0.0 * (T[3] + T[7] + T[11] + T[0] * T[0] + T[4] * T[4]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((N3_m <= doubt_limit_squared2) | (dhgen_abs_wide(D3_squared_m) <= m3) |
        (N3_p <= doubt_limit_squared2) | (T11 * T11 + T21 * T21 <= m1) | (v1 <= m2) |
        (dhgen_abs_wide(D3_squared_p) <= m3)) | (dhgen_within_slack_wide(excess_mm) |
        dhgen_within_slack_wide(excess_mp) | dhgen_within_slack_wide(excess_pp) |
        dhgen_within_slack_wide(excess_pm));
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
    const dhgen_four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e3 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double v1 = T14 * T14 + T24 * T24, w1 = sqrt(v1);

    /* theta4 */
    const double s4 = T14 * T21 - T24 * T11;

    /* theta3 */
    const double Z1_3 = T34 - k1;
    const dhgen_four v2 = k2 + e1 * w1;
    const double v3 = Z1_3 * Z1_3;
    const dhgen_four N3 = v3 + v2 * v2, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared), v4 = w3 - w3;

    /* theta2 */
    const dhgen_four v5 = m4 * (N3 * -Z1_3), v6 = m4 * (e3 * Z1_3), v7 = m4 * (v2 * N3);

    /* joint values */
    const double v8 = copysign(DHGEN_HALF_TURN, s4);
    const dhgen_four v9 = m5 * (e1 - 1.0);
    const double v11 = copysign(DHGEN_HALF_TURN, -T24);

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] + T[7] + T[11] + T[0] * T[0] + T[4] * T[4])) <=
        DHGEN_ORTHONORMAL) == 0) | ((dhgen_abs_four(D3_squared) <= m3) | (N3 <=
        doubt_limit_squared2))) | (unsigned)((T11 * T11 + T21 * T21 <= m1) | (v1 <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(dhgen_shuffle(w3,
        dhgen_all_four(s4), 0, 5, 2, 3), dhgen_all_four(-T24), 0, 1, 2, 7),
        dhgen_shuffle(dhgen_shuffle(N3 - k3, dhgen_all_four(-(T14 * T11 + T24 * T21)), 0, 5, 2, 3),
        dhgen_all_four(-T14), 0, 1, 2, 7)),
        ratio2 = dhgen_ratio_four(v5 + w3 * (m4 * (e3 * v2)), -(v7 + w3 * v6));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle3 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle4 = dhgen_shuffle(packed1, packed1, 3, 3, 3, 3), angle2 = dhgen_angle_four(ratio2);
    const dhgen_four v10 = offset4 - (angle3 + v8 * v9), v12 = angle4 + v9 * v11, q3 = e3 * angle1,
        v13 = dhgen_exceeds_four(v12, joints), q1 = v4 - v12, q4 = v4 + dhgen_lowered_four(v10),
        excess = dhgen_maximum_four(dhgen_beyond_four(q3, joints + 2), dhgen_maximum_four(v13,
            dhgen_beyond_four(angle2, joints + 1)));
    const dhgen_four_mask outside = 0.0 < excess;
    if (dhgen_bits_four(dhgen_within_slack_four(excess)))
        return -1;

    dhgen_store_4(q, q + 4, q + 8, q + 12, q1, angle2, q3, q4);
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

DHGEN_TABLE int entries[5] = { 0, 3, 4, 7, 11 };
DHGEN_TABLE int choosable[3] = { 3, 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    4, 4, 0, DHGEN_YAW, joints, NULL, 0,
    { 0.3413, 0.3413, 0.3413, 0.0, 0.0, 1.0 }, 0.341296928327645, { 1e-14, 1e-14 }, entries, 5,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 3, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL,
    kuka_kr40pa_level_fk, kuka_kr40pa_level_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) kuka_kr40pa_level_##function
#include "dhgen/functions.h"

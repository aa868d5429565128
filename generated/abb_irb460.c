/* abb_irb460: ABB IRB 460 palletizer, by its four drives
 *
 * Inverse kinematics, generated from robots/abb_irb460.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/abb_irb460.yaml. The formulas and where they come from:
 * abb_irb460.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 8054b894185cab1a
 * SPDX-License-Identifier: MIT
 */
#include "abb_irb460.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(ABB_IRB460_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(ABB_IRB460_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 4
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef ABB_IRB460_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.7425, /* joint offset 1 [m] */
    a1 = 0.26, /* link length 1 [m] */
    a2 = 0.945, /* link length 2 [m] */
    a3 = 1.025, /* link length 3 [m] */
    a4 = 0.22, /* link length 3p [m] */
    d5 = 0.2515, /* joint offset 4 [m] */
    steep_limit = 1e-06, /* a vertical axis, which has no yaw, is no longer seen from above */
    free_limit1 = 3.444e-12, /* a length that fixes no angle [m] */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    longest3 = 3.880899999999999, /* square of the longest reach [m^2] */
    shortest3 = 0.006399999999999993, /* square of the shortest reach [m^2] */
    longest3_reach = 3.880900000001356, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.006399999999944889, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 3.8808999999998632, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.006400000000005505, /* the shortest, where branches merge [m^2] */
    offset2 = -1.5707963267948966, /* offset of joint 2 [rad] */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    k1 = 0.49100000000000005, /* d1 - d5 [m] */
    k2 = 0.48, /* a1 + a4 [m] */
    k3 = 1.9436499999999997, /* a2^2 + a3^2 [m^2] */
    k4 = 0.5161956381468578; /* 1 / (2 * a3 * a2) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const abb_irb460_branches[4] = {
    "back-down", "back-up", "front-up", "front-down",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[4] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.8797932657906435, 2.8797932657906435, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.6981317007977318, 1.4835298641951802, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.3490658503988659, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -5.235987755982989, 5.235987755982989, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[5][4] = {
    { 0.0, 0.7425, 0.26, -1.5707963267948966 },
    { -1.5707963267948966, 0.0, 0.945, 0.0 },
    { 1.5707963267948966, 0.0, 1.025, 0.0 },
    { 0.0, 0.0, 0.22, -1.5707963267948966 },
    { 3.141592653589793, 0.2515, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_joint row_kinds[5] = {
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1 }, { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1 }, { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1 },
    { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1 },
};
DHGEN_TABLE struct dhgen_links links = { 5, DHGEN_STANDARD, row_kinds, &table[0][0], NULL, NULL,
    NULL };

DHGEN_PUBLIC void abb_irb460_frames(const double q[4], double frames[7][16])
{
    const double moved[5] = { q[0], q[1], -q[1] + q[2], -q[2], q[3] };
    dhgen_frames(&links, moved, frames);
}

DHGEN_PUBLIC void abb_irb460_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2, v4 = q[2] - q[1] + offset3;
    const double c3 = cos(v4), s3 = sin(v4), v5 = x2_x * c3 - v2 * s3, v6 = x2_y * c3 - v3 * s3,
        v7 = s2 * c3 + c2 * s3, v8 = v2 * c3 + x2_x * s3, v9 = v3 * c3 + x2_y * s3,
        v10 = s2 * s3 - c2 * c3;
    const double c3p = cos(-q[2]);
    const double s3p = sin(-q[2]);
    const double x3_x = v5 * c3p - v8 * s3p, x3_y = v6 * c3p - v9 * s3p,
        x3_z = v10 * s3p - v7 * c3p, v11 = v8 * c3p + v5 * s3p, v12 = v9 * c3p + v6 * s3p,
        z3_z = v10 * c3p + v7 * s3p, v13 = q[3] + offset4;
    const double c4 = cos(v13), s4 = sin(v13);
    T[0] = x3_x * c4 + s1 * s4; T[1] = s1 * c4 - x3_x * s4; T[2] = -v11;
    T[3] = c1 * a1 + x2_x * a2 + v5 * a3 + x3_x * a4 - v11 * d5;
    T[4] = x3_y * c4 - c1 * s4; T[5] = -(c1 * c4 + x3_y * s4); T[6] = -v12;
    T[7] = s1 * a1 + x2_y * a2 + v6 * a3 + x3_y * a4 - v12 * d5;
    T[8] = x3_z * c4; T[9] = -(x3_z * s4); T[10] = z3_z;
    T[11] = d1 - s2 * a2 - v7 * a3 + x3_z * a4 + z3_z * d5;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void abb_irb460_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1,
        v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, v2 = c1 * s2,
        v3 = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 - s2 * a2,
        v4 = q[2] - q[1] + offset3;
    const double c3 = cos(v4), s3 = sin(v4), v5 = x2_x * c3 - v2 * s3, v6 = x2_y * c3 - v3 * s3,
        v7 = s2 * c3 + c2 * s3, v8 = v2 * c3 + x2_x * s3, v9 = v3 * c3 + x2_y * s3,
        v10 = s2 * s3 - c2 * c3, v11 = p2_x + v5 * a3, v12 = p2_y + v6 * a3, v13 = p2_z - v7 * a3;
    const double c3p = cos(-q[2]);
    const double s3p = sin(-q[2]);
    const double v14 = v8 * c3p + v5 * s3p, v15 = v9 * c3p + v6 * s3p, z3_z = v10 * c3p + v7 * s3p,
        p3_x = v11 + (v5 * c3p - v8 * s3p) * a4, p3_y = v12 + (v6 * c3p - v9 * s3p) * a4,
        p3_z = v13 + (v10 * s3p - v7 * c3p) * a4, p4_x = p3_x - v14 * d5, p4_y = p3_y - v15 * d5,
        p4_z = p3_z + z3_z * d5, v16 = p4_z - d1, v17 = p4_z - p2_z, v18 = c1 * v17, v19 = s1 * v17,
        v20 = s1 * (p4_y - p2_y) + c1 * (p4_x - p2_x), v21 = p4_x - p3_x, v22 = p4_y - p3_y,
        v23 = p4_z - p3_z, v24 = p4_z - v13;
    J[0] = -p4_y; J[1] = c1 * v16 - v18; J[2] = v18 - c1 * v24; J[3] = -(v15 * v23 + z3_z * v22);
    J[4] = p4_x; J[5] = s1 * v16 - v19; J[6] = v19 - s1 * v24; J[7] = z3_z * v21 + v14 * v23;
    J[8] = 0.0; J[9] = v20 - (s1 * (p4_y - p1_y) + c1 * (p4_x - p1_x));
    J[10] = s1 * (p4_y - v12) + c1 * (p4_x - v11) - v20; J[11] = v15 * v21 - v14 * v22;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = -v14;
    J[16] = 0.0; J[17] = 0.0; J[18] = 0.0; J[19] = -v15;
    J[20] = 1.0; J[21] = 0.0; J[22] = 0.0; J[23] = z3_z;
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
    const double v1 = seed[3] + offset4;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double Z1_3 = T34 - k1;
    const double v3 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(T14 * factor1),
            s1 = free1 ? sin(seed[0]) : -(T24 * factor1);
        const double q1 = atan2(s1, c1);

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
        const double q4 = dhgen_wrap(atan2(s4, c4) - offset4);

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e3 * k4;

            /* theta2 */
            const double v4 = a3 * s3;
            const double S2 = v2 * v4 - v5;
            const double v7 = Z1_3 * v4 + v6;
            const double w2 = sqrt(S2 * S2 + v7 * v7);
            const double factor2 = 1.0 / w2;
            const double c2 = -(v7 * factor2), s2 = S2 * factor2;

            /* joint values */
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);
            const double q3 = dhgen_wrap(q2 + (atan2(s3, c3) - offset3));
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4;
            status[row] = (free1 || steep) ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef ABB_IRB460_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.00034439999999999997 [m]. */
static const double
    m1 = 1e-12, /* steep_limit^2 */
    m2 = 1.1861135999999998e-07, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m4 = 5.265108349305861e-10,
    m5 = 0.5291005291005292, /* a3 * k4 [m^-1] */
    m6 = 0.08338624338624337; /* a3 * k3 * k4 - a2 [m] */

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

    /* theta4 */
    const dhgen_wide s4 = T14 * T21 - T24 * T11;

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - k1, v2 = k2 + w1, v3 = k2 - w1, v4 = Z1_3 * Z1_3,
        N3_p = v4 + v2 * v2, N3_m = v4 + v3 * v3,
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m), v5 = w3_p - w3_p, v6 = w3_m - w3_m;

    /* theta2 */
    const dhgen_wide v7 = m6 - m5 * N3_p, v8 = m6 - m5 * N3_m, v9 = Z1_3 * v7, v10 = Z1_3 * v8,
        v11 = m5 * Z1_3, v12 = m5 * -Z1_3, v13 = v2 * -v7, v14 = v3 * -v8;

    /* joint values */
    const dhgen_wide v15 = w3_p * (m5 * v2),
        angle2 = dhgen_atan2_wide(v9 + v15, -(v13 + w3_p * v11)), v16 = angle2 - offset2,
        angle3 = dhgen_atan2_wide(v9 - v15, -(v13 + w3_p * v12)), v17 = angle3 - offset2,
        angle4 = dhgen_atan2_wide(v10 + w3_m * (m5 * v3), -(v14 + w3_m * v11)),
        v18 = angle4 - offset2,
        angle5 = dhgen_atan2_wide(v10 + w3_m * (m5 * -v3), -(v14 + w3_m * v12)),
        v19 = angle5 - offset2, q2_pp = dhgen_lowered_wide(v16), q2_pm = dhgen_lowered_wide(v17),
        q2_mp = dhgen_lowered_wide(v18), q2_mm = dhgen_lowered_wide(v19),
        angle6 = dhgen_atan2_wide(w3_p, N3_p - k3), angle7 = dhgen_atan2_wide(w3_m, N3_m - k3),
        q3_pp = dhgen_wrap_wide(q2_pp + (angle6 - offset3)),
        q3_pm = dhgen_wrap_wide(q2_pm - (offset3 + angle6)),
        q3_mp = dhgen_wrap_wide(q2_mp + (angle7 - offset3)),
        q3_mm = dhgen_wrap_wide(q2_mm - (offset3 + angle7)),
        angle8 = dhgen_atan2_wide(s4, -(T14 * T11 + T24 * T21)), v20 = angle8 - offset4,
        v21 = angle8 - dhgen_signed_wide(DHGEN_HALF_TURN, s4) - offset4,
        v22 = dhgen_exceeds_wide(angle1, joints), v23 = dhgen_exceeds_wide(q1__m, joints),
        q1_pp = angle1 + v5, q1_mp = q1__m + v6, q4_pp = v5 + dhgen_raised_wide(v20),
        q4_mp = v6 + dhgen_raised_wide(v21),
        excess_pp = dhgen_maximum_wide(dhgen_beyond_wide(q3_pp, joints + 2), dhgen_maximum_wide(v22,
            dhgen_beyond_wide(q2_pp, joints + 1))),
        excess_pm = dhgen_maximum_wide(dhgen_beyond_wide(q3_pm, joints + 2), dhgen_maximum_wide(v22,
            dhgen_beyond_wide(q2_pm, joints + 1))),
        excess_mp = dhgen_maximum_wide(dhgen_beyond_wide(q3_mp, joints + 2), dhgen_maximum_wide(v23,
            dhgen_beyond_wide(q2_mp, joints + 1))),
        excess_mm = dhgen_maximum_wide(dhgen_beyond_wide(q3_mm, joints + 2), dhgen_maximum_wide(v23,
            dhgen_beyond_wide(q2_mm, joints + 1)));

    q[0] = q1_pp; q[1] = q2_pp; q[2] = q3_pp; q[3] = q4_pp;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_pp);
    q[4] = q1_pp; q[5] = q2_pm; q[6] = q3_pm; q[7] = q4_pp;
    kind[1] = dhgen_kind_within_wide(q[4], 0.0 < excess_pm);
    q[8] = q1_mp; q[9] = q2_mp; q[10] = q3_mp; q[11] = q4_mp;
    kind[2] = dhgen_kind_within_wide(q[8], 0.0 < excess_mp);
    q[12] = q1_mp; q[13] = q2_mm; q[14] = q3_mm; q[15] = q4_mp;
    kind[3] = dhgen_kind_within_wide(q[12], 0.0 < excess_mm);
    const dhgen_wide_mask exact = 0.0 * (T[3] + T[7] + T[11] + T[0] * T[0] + T[4] * T[4]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v1 <= m2) | (T11 * T11 + T21 * T21 <= m1) |
        (dhgen_abs_wide(D3_squared_p) <= m4) | (dhgen_abs_wide(D3_squared_m) <= m4)) |
        (dhgen_within_slack_wide(excess_mm) | dhgen_within_slack_wide(excess_mp) |
        dhgen_within_slack_wide(excess_pp) | dhgen_within_slack_wide(excess_pm));
}

#if DHGEN_LANES > 1
static const double
    m3 = 0.5; /* 1 / 2 */
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
    const dhgen_four v3 = m3 * (e1 - 1.0);

    /* theta4 */
    const double s4 = T14 * T21 - T24 * T11;

    /* theta3 */
    const double Z1_3 = T34 - k1;
    const dhgen_four v4 = k2 + e1 * w1;
    const double v5 = Z1_3 * Z1_3;
    const dhgen_four N3 = v5 + v4 * v4, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared), v6 = w3 - w3;

    /* theta2 */
    const dhgen_four v7 = m6 - m5 * N3, v8 = Z1_3 * v7, v9 = m5 * (e3 * Z1_3), v10 = v4 * -v7;

    /* joint values */
    const double v12 = copysign(DHGEN_HALF_TURN, s4);

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] + T[7] + T[11] + T[0] * T[0] + T[4] * T[4])) <=
        DHGEN_ORTHONORMAL) == 0) | (dhgen_abs_four(D3_squared) <= m4)) | (unsigned)((T11 * T11 + T21
        * T21 <= m1) | (v1 <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(dhgen_shuffle(w3,
        dhgen_all_four(-T24), 0, 5, 2, 3), dhgen_all_four(s4), 0, 1, 2, 7),
        dhgen_shuffle(dhgen_shuffle(N3 - k3, dhgen_all_four(-T14), 0, 5, 2, 3), dhgen_all_four(-(T14
        * T11 + T24 * T21)), 0, 1, 2, 7)),
        ratio2 = dhgen_ratio_four(v8 + w3 * (m5 * (e3 * v4)), -(v10 + w3 * v9));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle3 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle4 = dhgen_shuffle(packed1, packed1, 3, 3, 3, 3), angle2 = dhgen_angle_four(ratio2);
    const dhgen_four q1_ = angle1 + v2 * v3, v11 = angle2 - offset2, q2 = dhgen_lowered_four(v11),
        q3 = dhgen_wrap_four(q2 + (e3 * angle3 - offset3)), v13 = angle4 + v3 * v12 - offset4,
        v14 = dhgen_exceeds_four(q1_, joints), q1 = q1_ + v6, q4 = v6 + dhgen_raised_four(v13),
        excess = dhgen_maximum_four(dhgen_beyond_four(q3, joints + 2), dhgen_maximum_four(v14,
            dhgen_beyond_four(q2, joints + 1)));
    const dhgen_four_mask outside = 0.0 < excess;
    if (dhgen_bits_four(dhgen_within_slack_four(excess)))
        return -1;

    dhgen_store_4(q, q + 4, q + 8, q + 12, q1, q2, q3, q4);
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
DHGEN_TABLE int choosable[2] = { 3, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    4, 4, 0, DHGEN_YAW, joints, NULL, 0,
    { 0.2904, 0.2904, 0.2904, 0.0, 0.0, 1.0 }, 0.29036004645760743, { 1e-14, 1e-14 }, entries, 5,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, abb_irb460_fk,
    abb_irb460_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) abb_irb460_##function
#include "dhgen/functions.h"

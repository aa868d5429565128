/* puma_arm: PUMA 560 to its wrist centre
 *
 * Inverse kinematics, generated from robots/puma_arm.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/puma_arm.yaml. The formulas and where they come from: puma_arm.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: d47b230c056f04e4
 * SPDX-License-Identifier: MIT
 */
#include "puma_arm.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(PUMA_ARM_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(PUMA_ARM_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef PUMA_ARM_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 1.7057800000000002e-13 [m], merge_slack1 = 1.70578e-14 [m],
 * arm_size1 = 1.70578 [m]. */
static const double
    d1 = 0.67183, /* joint offset 1 [m] */
    a2 = 0.4318, /* link length 2 [m] */
    d3 = 0.15005, /* joint offset 3 [m] */
    a3 = 0.0203, /* link length 3 [m] */
    d4 = 0.4318, /* z of the tool frame [m] */
    free_limit_squared2 = 2.9096854084e-24, /* square of a length that fixes no angle [m^2] */
    least_root1 = 5.394149987162018e-07, /* a root of nothing, by rounding [m] */
    longest3 = 0.7466289125534531, /* square of the longest reach [m^2] */
    shortest3 = 2.274465470660925e-07, /* square of the shortest reach [m^2] */
    boundary3 = 2.1999652436149993e-13, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.7466289125534236, /* the longest, where branches merge [m^2] */
    shortest3_apart = 2.2744654708236271e-07, /* the shortest, where branches merge [m^2] */
    k1 = 0.022515002499999996, /* d3^2 [m^2] */
    k2 = 5.11904578000291e-14, /* reach_slack1 * (2 * d3 + reach_slack1) [m^2] */
    k3 = 5.1190457800002905e-15, /* merge_slack1 * (2 * d3 + merge_slack1) [m^2] */
    k4 = 0.5862420710759887, /* 1 / arm_size1 [m^-1] */
    k5 = 0.37290248000000004, /* 2 * d4 * a2 [m^2] */
    k6 = 0.01753108, /* 2 * a3 * a2 [m^2] */
    k7 = 0.37331457, /* d4 * a2 + (a3^2 + d4 * a2) [m^2] */
    k8 = 7.175474885806929; /* 1 / (k5^2 + k6^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const puma_arm_branches[4] = {
    "right-down", "right-up", "left-up", "left-down",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.67183, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.4318, 0.0 },
    { 0.0, 0.15005, 0.0203, -1.5707963267948966 },
};
DHGEN_TABLE double tool[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.4318 };
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void puma_arm_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, z3_z = c2 * c3 - s2 * s3;
    T[0] = x3_x; T[1] = -s1; T[2] = -v3; T[3] = x2_x * a2 + x3_x * a3 + s1 * d3 - v3 * d4;
    T[4] = x3_y; T[5] = c1; T[6] = -v4; T[7] = x2_y * a2 + x3_y * a3 - c1 * d3 - v4 * d4;
    T[8] = x3_z; T[9] = 0.0; T[10] = z3_z; T[11] = d1 + s2 * a2 + x3_z * a3 + z3_z * d4;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void puma_arm_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]),
        J21 = p2_x + (x2_x * c3 - v1 * s3) * a3 + s1 * d3 - (v1 * c3 + x2_x * s3) * d4,
        v3 = p2_y + (x2_y * c3 - v2 * s3) * a3 - c1 * d3 - (v2 * c3 + x2_y * s3) * d4,
        v4 = p2_z + (s2 * c3 + c2 * s3) * a3 + (c2 * c3 - s2 * s3) * d4, v5 = v4 - d1,
        v6 = v4 - p2_z;
    J[0] = -v3; J[1] = -(c1 * v5); J[2] = -(c1 * v6);
    J[3] = J21; J[4] = -(s1 * v5); J[5] = -(s1 * v6);
    J[6] = 0.0; J[7] = s1 * v3 + c1 * J21; J[8] = s1 * (v3 - p2_y) + c1 * (J21 - p2_x);
    J[9] = 0.0; J[10] = s1; J[11] = s1;
    J[12] = 0.0; J[13] = -c1; J[14] = -c1;
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
    const double N1 = T14 * T14 + T24 * T24;
    const double D1_squared = N1 - k1;
    const int apart1 = k3 < D1_squared;
    if (!(-k2 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double v1 = (apart1 ? w1 : least_root1) * k4;
    const double inverse1 = 1.0 / (apart1 ? N1 : d3 * sqrt(N1));
    const double v2 = T14 * d3, v3 = T24 * d3;

    /* theta3, type 6: U1[2, 4] and U1[1, 4] */
    const double Z1_3 = T34 - d1;
    const double v4 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = inverse1 * (T14 * D1 - v3), s1 = inverse1 * (v2 + T24 * D1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double N3 = v4 + D1 * D1;
        const double K3 = N3 - k7;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= v1 * D3_squared)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double v5 = k5 * K3, v6 = k6 * K3;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double D3 = w3 * e3;
            const double s3 = (k6 * D3 - v5) * k8, c3 = k8 * (v6 + k5 * D3);
            const double q3 = atan2(s3, c3);

            /* theta2, type 3: U1[2, 4] and U1[1, 4] */
            const double X1_2 = a2 + (a3 * c3 - d4 * s3);
            const double Y1_2 = d4 * c3 + a3 * s3;
            const double S2 = Z1_3 * X1_2 - D1 * Y1_2;
            const double C2 = D1 * X1_2 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
            status[row] = free2 ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef PUMA_ARM_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
static const double
    turn1 = 1.5238184104468135, /* atan2(k5, k6) [rad] */
    m1 = 5.119045780000291e-12, /* 1000 * k3 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 2.2049387897563516e-11,
    m3 = 1.1579434923575729, /* k8 * (d4 * k5 + a3 * k6) [m^-1] */
    m4 = 0.000477176933765627; /* d4 * k5 * k7 * k8 + a3 * k6 * k7 * k8 - a2 [m] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide D1_squared = T14 * T14 + T24 * T24 - k1, w1 = dhgen_sqrt_wide(D1_squared),
        v1 = w1 - w1, v2 = d3 * T14, v3 = d3 * T24, v4 = T14 * w1, v5 = T24 * w1;

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d1, N3 = D1_squared + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_wide(D3_squared),
        v6 = w3 - w3, angle1 = dhgen_atan2_wide(w3, N3 - k7), q3__p = angle1 - turn1,
        v7 = turn1 + angle1;

    /* theta2 */
    const dhgen_wide X1_2 = m3 * N3 - m4, v8 = Z1_3 * X1_2, v9 = w3 * (m3 * Z1_3),
        v10 = w3 * (m3 * -Z1_3), v11 = w1 * X1_2, v12 = w1 * -X1_2, v13 = w3 * (m3 * w1),
        v14 = v8 - v13, v15 = v8 + v13;

    /* joint values */
    const dhgen_wide angle6 = dhgen_atan2_wide(v2 + v5, v4 - v3), q1_pp = v6 + angle6,
        angle7 = dhgen_atan2_wide(v2 - v5, -(v3 + v4)), q1_mp = v6 + angle7,
        q3_pp = v1 + dhgen_raised_wide(q3__p),
        q3_pm = v1 + (dhgen_only_wide(-v7 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v7);

    q[0] = q1_pp; q[1] = dhgen_atan2_wide(v14, v9 + v11); q[2] = q3_pp;
    kind[0] = dhgen_kind_wide(q[0]);
    q[3] = q1_pp; q[4] = dhgen_atan2_wide(v15, v10 + v11); q[5] = q3_pm;
    kind[1] = dhgen_kind_wide(q[3]);
    q[6] = q1_mp; q[7] = dhgen_atan2_wide(v15, v9 + v12); q[8] = q3_pp;
    kind[2] = dhgen_kind_wide(q[6]);
    q[9] = q1_mp; q[10] = dhgen_atan2_wide(v14, v10 + v12); q[11] = q3_pm;
    kind[3] = dhgen_kind_wide(q[9]);
    const dhgen_wide_mask exact = 0.0 * (T[3] + T[7] + T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D1_squared) <= m1) | (dhgen_abs_wide(D3_squared * (k4 *
        w1)) <= m2));
}

#if DHGEN_LANES > 1
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
    const double D1_squared = T14 * T14 + T24 * T24 - k1, w1 = sqrt(D1_squared), v1 = w1 - w1,
        v2 = d3 * T14, v3 = d3 * T24, v4 = T14 * w1, v5 = T24 * w1;

    /* theta3 */
    const double Z1_3 = T34 - d1, N3 = D1_squared + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared), v6 = w3 - w3;

    /* theta2 */
    const double X1_2 = m3 * N3 - m4, v7 = Z1_3 * X1_2;
    const dhgen_four v8 = w3 * (m3 * (e3 * Z1_3)), v9 = w1 * (e1 * X1_2);

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] + T[7] + T[11])) <= DHGEN_ORTHONORMAL) == 0)) |
        (unsigned)((fabs(D1_squared) <= m1) | (fabs(D3_squared * (k4 * w1)) <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(v2 + e1 * v5,
        dhgen_all_four(w3), 0, 5, 2, 3), dhgen_shuffle(e1 * v4 - v3, dhgen_all_four(N3 - k7), 0, 5,
        2, 3)), ratio2 = dhgen_ratio_four(v7 - w3 * (m3 * (w1 * (e1 * e3))), v8 + v9);
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle3 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle2 = dhgen_angle_four(ratio2);
    const dhgen_four q3_ = e3 * angle1 - turn1, q1 = v6 + angle3, q3 = v1 + dhgen_raised_four(q3_);

    dhgen_store_2(q, q + 3, q + 6, q + 9, q1, angle2);
    dhgen_store_1(q + 2, q + 5, q + 8, q + 11, q3);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[3] = { 3, 7, 11 };
DHGEN_TABLE int choosable[1] = { 1 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 4, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 0.5862, 0.5862, 0.5862, 0.0, 0.0, 0.0 }, 0.5862420710759887, { 1e-14, 1e-14 }, entries, 3,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, puma_arm_fk,
    puma_arm_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) puma_arm_##function
#include "dhgen/functions.h"

/* arm_3r: Arm with three revolute joints, to its wrist centre
 *
 * Inverse kinematics, generated from robots/arm_3r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/arm_3r.yaml. The formulas and where they come from: arm_3r.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 68b97f2e9783ad26
 * SPDX-License-Identifier: MIT
 */
#include "arm_3r.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(ARM_3R_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(ARM_3R_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef ARM_3R_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.4, /* joint offset 1 [m] */
    a2 = 0.4, /* link length 2 [m] */
    d4 = 0.35, /* z of the tool frame [m] */
    free_limit1 = 1.15e-12, /* a length that fixes no angle [m] */
    longest3 = 0.5625, /* square of the longest reach [m^2] */
    shortest3 = 0.0025000000000000044, /* square of the shortest reach [m^2] */
    longest3_reach = 0.5625000000001725, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0024999999999885045, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.5624999999999827, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.002500000000001154, /* the shortest, where branches merge [m^2] */
    k1 = 0.27999999999999997, /* 2 * d4 * a2 [m^2] */
    k2 = 0.28250000000000003, /* a2^2 + d4^2 [m^2] */
    k3 = 12.755102040816327; /* 1 / (k1^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const arm_3r_branches[4] = {
    "back-down", "back-up", "front-up", "front-down",
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
    { 0.0, 0.4, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.4, 0.0 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
};
DHGEN_TABLE double tool[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.35 };
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void arm_3r_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), v3 = v1 * c3 + x2_x * s3, v4 = v2 * c3 + x2_y * s3,
        z3_z = s2 * s3 - c2 * c3;
    T[0] = x2_x * c3 - v1 * s3; T[1] = s1; T[2] = -v3; T[3] = x2_x * a2 - v3 * d4;
    T[4] = x2_y * c3 - v2 * s3; T[5] = -c1; T[6] = -v4; T[7] = x2_y * a2 - v4 * d4;
    T[8] = -(s2 * c3 + c2 * s3); T[9] = 0.0; T[10] = z3_z; T[11] = d1 - s2 * a2 + z3_z * d4;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void arm_3r_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, p2_x = x2_x * a2,
        p2_y = x2_y * a2, p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), J21 = p2_x - (c1 * s2 * c3 + x2_x * s3) * d4,
        v1 = p2_y - (s1 * s2 * c3 + x2_y * s3) * d4, v2 = p2_z + (s2 * s3 - c2 * c3) * d4,
        v3 = v2 - d1, v4 = v2 - p2_z;
    J[0] = -v1; J[1] = c1 * v3; J[2] = c1 * v4;
    J[3] = J21; J[4] = s1 * v3; J[5] = s1 * v4;
    J[6] = 0.0; J[7] = -(s1 * v1 + c1 * J21); J[8] = -(s1 * (v1 - p2_y) + c1 * (J21 - p2_x));
    J[9] = 0.0; J[10] = -s1; J[11] = -s1;
    J[12] = 0.0; J[13] = c1; J[14] = c1;
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
        const double K3 = N3 - k2;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double v2 = k1 * K3 * k3;

        /* theta2, type 3: U1[1, 4] and U1[2, 4] */
        const double Y1_2 = a2 + d4 * v2;
        const double v4 = Z1_3 * Y1_2, v5 = D1 * Y1_2;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double c3 = k3 * (k1 * (w3 * e3));
            const double q3 = atan2(-v2, c3);

            /* theta2 */
            const double v3 = d4 * c3;
            const double S2 = D1 * v3 - v4;
            const double v6 = Z1_3 * v3 + v5;
            const double w2 = sqrt(S2 * S2 + v6 * v6);
            const double factor2 = 1.0 / w2;
            const double c2 = -(v6 * factor2), s2 = S2 * factor2;
            const double q2 = atan2(s2, c2);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
            status[row] = free1 ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef ARM_3R_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.00011499999999999999 [m]. */
static const double
    m1 = 1.3224999999999998e-08, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 9.698908343125067e-12,
    m4 = 1.2499999999999998, /* d4 * k1 * k3 [m^-1] */
    m5 = 0.04687500000000003; /* a2 - d4 * k1 * k2 * k3 [m] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T14 * T14 + T24 * T24, w1 = dhgen_sqrt_wide(v1),
        angle1 = dhgen_atan2_wide(-T24, -T14);

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d1, N3 = v1 + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_wide(D3_squared),
        v2 = w3 - w3, angle2 = dhgen_atan2_wide(-(k1 * (N3 - k2)), k1 * w3),
        q3_pm = dhgen_signed_wide(DHGEN_HALF_TURN, -(k1 * (N3 - k2))) - angle2;

    /* theta2 */
    const dhgen_wide v3 = m5 + m4 * N3, v4 = Z1_3 * v3, v5 = w3 * (m4 * Z1_3),
        v6 = w3 * (m4 * -Z1_3), v7 = w1 * v3, v8 = w3 * (m4 * w1), v9 = v8 - v4;

    /* joint values */
    const dhgen_wide q1_pp = angle1 + v2,
        q1_mp = v2 + (angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, -T24));

    q[0] = q1_pp; q[1] = dhgen_atan2_wide(v9, -(v5 + v7)); q[2] = angle2;
    kind[0] = dhgen_kind_wide(q[0]);
    q[3] = q1_pp; q[4] = dhgen_atan2_wide(-(v4 + v8), -(v6 + v7)); q[5] = q3_pm;
    kind[1] = dhgen_kind_wide(q[3]);
    q[6] = q1_mp; q[7] = dhgen_atan2_wide(-(v4 + v8), v7 - v5); q[8] = angle2;
    kind[2] = dhgen_kind_wide(q[6]);
    q[9] = q1_mp; q[10] = dhgen_atan2_wide(v9, v7 - v6); q[11] = q3_pm;
    kind[3] = dhgen_kind_wide(q[9]);
    const dhgen_wide_mask exact = 0.0 * (T[3] + T[7] + T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v1 <= m1) | (dhgen_abs_wide(D3_squared) <= m3));
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
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared), v3 = w3 - w3,
        v4 = copysign(DHGEN_HALF_TURN, -(k1 * (N3 - k2)));

    /* theta2 */
    const double v5 = m5 + m4 * N3, v6 = Z1_3 * v5;
    const dhgen_four v7 = w3 * (m4 * (e3 * Z1_3)), v8 = w1 * (e1 * v5);

    if (dhgen_bits_four(((dhgen_all_four(0.0 * (T[3] + T[7] + T[11])) <= DHGEN_ORTHONORMAL) == 0)) |
        (unsigned)((v1 <= m1) | (fabs(D3_squared) <= m3)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-T24, -(k1 * (N3 - k2)),
        -T24, -T24), dhgen_four_of(-T14, k1 * w3, -T14, -T14)),
        ratio2 = dhgen_ratio_four(w3 * (m4 * (w1 * (e1 * e3))) - v6, -(v7 + v8));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = dhgen_angle_four(ratio2);
    const dhgen_four q3 = e3 * angle2 + v4 * (m2 * (1.0 - e3)),
        q1 = v3 + (angle1 + v2 * (m2 * (e1 - 1.0)));

    dhgen_store_2(q, q + 3, q + 6, q + 9, q1, angle3);
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
DHGEN_TABLE int choosable[1] = { 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 4, 0, DHGEN_COORDINATES, joints, NULL, 0,
    { 0.8696, 0.8696, 0.8696, 0.0, 0.0, 0.0 }, 0.8695652173913044, { 1e-14, 1e-14 }, entries, 3,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, arm_3r_fk,
    arm_3r_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) arm_3r_##function
#include "dhgen/functions.h"

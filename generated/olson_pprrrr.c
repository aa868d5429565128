/* olson_pprrrr: Olson PPRRRR arm
 *
 * Inverse kinematics, generated from robots/olson_pprrrr.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/olson_pprrrr.yaml. The formulas and where they come from:
 * olson_pprrrr.md.
 *
 * dhgen 0.1.0; SHA-256 of the robot file: d9f597bde268c000
 * SPDX-License-Identifier: MIT
 */
#include "olson_pprrrr.h"

#if defined(OLSON_PPRRRR_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(OLSON_PPRRRR_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#ifndef OLSON_PPRRRR_PLAIN
#include "dhgen/tile.h"
#endif

#if DHGEN_INTERFACE != 1
#error "the folder dhgen/ is of another version: run dhgen on the robot file again"
#endif

static const double
    d3 = 1.0, /* joint offset 3 [m] */
    a4 = 4.0, /* link length 5 [m] */
    d6 = 2.0, /* joint offset 6 [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    near_limit = 0.001, /* a length whose direction is good to few digits */
    free_limit_squared2 = 4.9e-23, /* square of a length that fixes no angle [m^2] */
    reach_slack1 = 7e-13, /* rounding at the boundary of the workspace [m] */
    merge_slack1 = 7e-14, /* nearer to that boundary two branches are one [m] */
    /* the same where they follow an angle that is good to few digits [m] */
    blur_slack1 = 6.999999999999999e-11;

/* Entries of a pose by their names. */
#define ENTRIES(number) \
    const number T11 = T[0], T12 = T[1], T13 = T[2], T14 = T[3]; \
    const number T21 = T[4], T22 = T[5], T23 = T[6], T24 = T[7]; \
    const number T31 = T[8], T32 = T[9], T33 = T[10], T34 = T[11]

const char *const olson_pprrrr_branches[4] = {
    "elbow+-noflip", "elbow+-flip", "elbow--noflip", "elbow--flip",
};

static const struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 7e-09, 0.02040816326530612, 7.0, 0.6872233929727672, 0 },
    { -HUGE_VAL, HUGE_VAL, 7e-09, 0.02040816326530612, 7.0, 0.6872233929727672, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

void olson_pprrrr_fk(const double q[6], double T[16])
{
    const double c3 = cos(q[2]), s3 = sin(q[2]);
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = s3 * c4, v1 = c3 * c4, v2 = s3 * s4,
        y4_y = c3 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v2 * s5,
        x5_y = y4_y * s5 - v1 * c5, x5_z = s4 * c5 + c4 * s5, z6_x = v2 * c5 + x4_x * s5,
        y5_y = y4_y * c5 + v1 * s5, y5_z = c4 * c5 - s4 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - c3 * s6; T[1] = -(c3 * c6 + x5_x * s6); T[2] = z6_x;
    T[3] = q[1] + x4_x * a4 + z6_x * d6;
    T[4] = x5_y * c6 - s3 * s6; T[5] = -(s3 * c6 + x5_y * s6); T[6] = -y5_y;
    T[7] = q[0] - v1 * a4 - y5_y * d6;
    T[8] = x5_z * c6; T[9] = -(x5_z * s6); T[10] = -y5_z; T[11] = d3 + s4 * a4 - y5_z * d6;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
}

void olson_pprrrr_jacobian(const double q[6], double J[36])
{
    const double c3 = cos(q[2]), s3 = sin(q[2]);
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = s3 * c4, v1 = c3 * c4,
        p5_x = q[1] + x4_x * a4, p5_y = q[0] - v1 * a4, p5_z = d3 + s4 * a4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z6_x = s3 * s4 * c5 + x4_x * s5,
        y5_y = c3 * s4 * c5 + v1 * s5, y5_z = c4 * c5 - s4 * s5, p6_x = p5_x + z6_x * d6,
        p6_y = p5_y - y5_y * d6, p6_z = p5_z - y5_z * d6, J23 = p6_x - q[1], v2 = p6_y - q[0],
        v3 = p6_z - d3, v4 = p6_z - p5_z;
    J[0] = 0.0; J[1] = 1.0; J[2] = -v2; J[3] = -(s3 * v3); J[4] = -(s3 * v4); J[5] = 0.0;
    J[6] = 1.0; J[7] = 0.0; J[8] = J23; J[9] = c3 * v3; J[10] = c3 * v4; J[11] = 0.0;
    J[12] = 0.0; J[13] = 0.0; J[14] = 0.0; J[15] = s3 * J23 - c3 * v2;
    J[16] = s3 * (p6_x - p5_x) - c3 * (p6_y - p5_y); J[17] = 0.0;
    J[18] = 0.0; J[19] = 0.0; J[20] = 0.0; J[21] = -c3; J[22] = -c3; J[23] = z6_x;
    J[24] = 0.0; J[25] = 0.0; J[26] = 0.0; J[27] = -s3; J[28] = -s3; J[29] = -y5_y;
    J[30] = 0.0; J[31] = 0.0; J[32] = 1.0; J[33] = 0.0; J[34] = 0.0; J[35] = -y5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
static void solve(
    const double *T, const double *free_joints, const double *seed, double moved, double *rows,
    unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints;
    (void)moved;
    ENTRIES(double);

    /* theta3, type 2: U3[2, 3] */
    const double w3 = sqrt(T23 * T23 + T13 * T13);
    const int free3 = w3 <= free_limit;
    const double divisor3 = free3 ? 1.0 : w3;
    const int near3 = w3 <= near_limit;

    /* theta5, type 2: U0 (A5 A6)^-1 [3, 4] */
    const double X5 = T33 * a4;
    const double v3 = X5 * X5, v4 = T33 * d6 + (d3 - T34), v5 = v4 * v4, v6 = fabs(v4),
        v7 = 2.0 * v6, v8 = merge_slack1 * (v7 + merge_slack1),
        v9 = blur_slack1 * (v7 + blur_slack1), v10 = X5 * v4;

    /* r2, type 1: U0 A6^-1 [1, 4] */
    const double wx = T14 - T13 * d6;

    /* r1, type 1: U0 A6^-1 [2, 4] */
    const double wy = T24 - T23 * d6;

    for (int i1 = 0; i1 < 2; i1++) { /* elbow+, elbow- */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e1 < 0.0 && free3) continue; /* both signs give the same */
        const double factor3 = e1 / divisor3;
        const double v1 = T23 * factor3, v2 = T13 * factor3;
        const double off3 = near3 ? w3 * fabs(v1 * sin(seed[2]) + v2 * cos(seed[2])) : 1.0;
        const double ahead3 = near3 ? v1 * cos(seed[2]) - v2 * sin(seed[2]) : -1.0;
        const int same3 = near3 && 0.0 < ahead3 && off3 <= free_limit;
        const int held3 = free3 || same3;
        const double c3 = held3 ? cos(seed[2]) : v1, s3 = held3 ? sin(seed[2]) : -v2;
        const double q3 = atan2(s3, c3);
        const double root3 = w3 * e1;

        /* theta45, type 3: U3[3, 3] and U3[1, 3] */
        const double theta45 = atan2(-root3, -T33);

        /* theta6, type 3: U3[2, 2] and U3[2, 1] */
        const double Z1_6 = T12 * c3 + T22 * s3;
        const double Z2_6 = T11 * c3 + T21 * s3;
        const double q6 = atan2(-Z2_6, -Z1_6);

        /* theta5 */
        const double Y5 = a4 * (T32 * Z2_6 - T31 * Z1_6);
        const double N5 = v3 + Y5 * Y5;
        const int free5 = N5 <= free_limit_squared2;
        const double D5 = N5 - v5;
        const int apart5 = v8 < D5;
        if (!(-(reach_slack1 * (v7 + reach_slack1)) <= D5)) {
            if (near3) dhgen_lose(DHGEN_NEARLY + 3, D5, q[2 * i1], &status[2 * i1]);
            if (near3) q[2 * i1][1] = atan2(-v2, v1);
            if (free3) dhgen_lose(DHGEN_LOST + 3, D5, q[2 * i1], &status[2 * i1]);
            continue; /* out of reach */
        }
        const double w5 = sqrt(apart5 ? D5 : 0.0);
        const double inverse5 = 1.0 / (free5 ? 1.0 : (apart5 ? N5 : v6 * sqrt(N5)));
        const double v11 = Y5 * v4;

        /* r2 */
        const double v13 = s3 * a4;

        /* r1 */
        const double v14 = c3 * a4;

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta5 */
            if (e2 < 0.0 && (free5 || !apart5 || (near3 && !(v9 < D5))))
                continue; /* both signs give the same */
            const double root5 = w5 * e2;
            const double c5 = free5 ? cos(seed[4]) : -(inverse5 * (v11 + X5 * root5)),
                s5 = free5 ? sin(seed[4]) : inverse5 * (Y5 * root5 - v10);
            const double q5 = atan2(s5, c5);

            /* r2 */
            const double v12 = T33 * c5 + root3 * s5;
            const double r2 = wx + v12 * v13;

            /* r1 */
            const double r1 = wy - v12 * v14;

            /* joint values */
            const double q4 = dhgen_wrap(theta45 - q5);
            const int row = 2 * i1 + i2;
            q[row][0] = r1; q[row][1] = r2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            q[row][5] = q6;
            status[row] = (free3 || free5) ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef OLSON_PPRRRR_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
static const double
    doubt_limit_squared2 = 4.9e-07, /* square of a length that fixes no angle [m^2] */
    m1 = 9.999999999999999e-09, /* doubt_limit^2 */
    m4 = 6.999999999999999e-10; /* 10 * blur_slack1 [m] */
/* coefficients */
static const double m3 = 4.0;

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    ENTRIES(dhgen_wide);

    /* theta3 */
    const dhgen_wide v1 = T23 * T23 + T13 * T13, w3 = dhgen_sqrt_wide(v1), v2 = 1.0 / v1,
        factor3 = w3 * v2, angle1 = dhgen_atan2_wide(-T13, T23);

    /* theta45 */
    const dhgen_wide angle2 = dhgen_atan2_wide(-w3, -T33);

    /* theta6 */
    const dhgen_wide v3 = v2 * (T23 * T12 - T13 * T22), v4 = v2 * (T23 * T11 - T13 * T21),
        angle3 = dhgen_atan2_wide(-v4, -v3);

    /* theta5 */
    const dhgen_wide X5 = a4 * T33,
        Y5 = w3 * (m3 * (v2 * (T23 * (T11 * T32 - T12 * T31) + T13 * (T22 * T31 - T21 * T32)))),
        N5 = X5 * X5 + Y5 * Y5, v5 = d6 * T33 + (d3 - T34), D5 = N5 - v5 * v5,
        w5 = dhgen_sqrt_wide(D5), v6 = w5 - w5, inverse5 = 1.0 / N5, v7 = X5 * v5, v8 = Y5 * v5,
        v9 = X5 * w5, v10 = Y5 * w5, v11 = v10 - v7, v12 = v8 + v9,
        angle4 = dhgen_atan2_wide(v11, -v12), v13 = v8 - v9,
        angle5 = dhgen_atan2_wide(-(v7 + v10), -v13), angle6 = dhgen_atan2_wide(-(v7 + v10), v13),
        angle7 = dhgen_atan2_wide(v11, v12);

    /* r2 */
    const dhgen_wide v14 = a4 * (T13 * factor3),
        v15 = T33 * X5 - w3 * (a4 * (w3 * v4 * T32 - w3 * v3 * T31)), v16 = w3 * v7 + T33 * v8,
        v17 = T14 - d6 * T13 + inverse5 * (v14 * v16), q2_pp = v17 + w5 * (inverse5 * (v14 * v15)),
        q2_pm = v17 + w5 * (inverse5 * (v14 * -v15));

    /* r1 */
    const dhgen_wide v18 = a4 * (T23 * factor3), v19 = T24 - d6 * T23 + inverse5 * (v16 * v18),
        q1_pp = v19 + w5 * (inverse5 * (v15 * v18)), q1_pm = v19 + w5 * (inverse5 * (-v15 * v18));

    /* joint values */
    const dhgen_wide v20 = angle2 - angle4, v21 = angle2 - angle5, v22 = angle2 + angle6,
        v23 = angle2 + angle7, q3_pp = angle1 + v6,
        q3_mp = v6 + (angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, -T13)), q6_pp = angle3 + v6,
        q6_mp = v6 + (angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, -v4));

    q[0] = q1_pp; q[1] = q2_pp; q[2] = q3_pp; q[3] = dhgen_centred_wide(v20); q[4] = angle4;
    q[5] = q6_pp;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_pm; q[7] = q2_pm; q[8] = q3_pp; q[9] = dhgen_centred_wide(v21); q[10] = angle5;
    q[11] = q6_pp;
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_pm; q[13] = q2_pm; q[14] = q3_mp;
    q[15] = dhgen_pick_wide(-v22 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
        dhgen_only_wide(DHGEN_HALF_TURN < -v22, -DHGEN_TURN)) - v22;
    q[16] = angle6; q[17] = q6_mp;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_pp; q[19] = q2_pp; q[20] = q3_mp;
    q[21] = dhgen_pick_wide(-v23 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
        dhgen_only_wide(DHGEN_HALF_TURN < -v23, -DHGEN_TURN)) - v23;
    q[22] = angle7; q[23] = q6_mp;
    kind[3] = dhgen_kind_wide(q[18]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((N5 <= doubt_limit_squared2) | (dhgen_abs_wide(D5) <= m4 * (blur_slack1 +
        2.0 * dhgen_abs_wide(v5))) | (v1 <= m1));
}

#if DHGEN_LANES > 1
static const double
    m2 = 0.5; /* 1 / 2 */
/* One regular pose, 2 signs in lanes. Returns how many rows are OK, or -1 if the pose has
 * to be left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    const dhgen_four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e2 = { 1.0, -1.0, 1.0, -1.0 };
    ENTRIES(double);

    /* theta3 */
    const double v1 = T23 * T23 + T13 * T13, w3 = sqrt(v1), v2 = 1.0 / v1, factor3 = w3 * v2,
        v3 = copysign(DHGEN_HALF_TURN, -T13);
    const dhgen_four v4 = m2 * (e1 - 1.0);

    /* theta6 */
    const double v5 = v2 * (T23 * T12 - T13 * T22), v6 = v2 * (T23 * T11 - T13 * T21),
        v7 = copysign(DHGEN_HALF_TURN, -v6);

    /* theta5 */
    const double X5 = a4 * T33, v8 = a4 * (w3 * v6 * T32 - w3 * v5 * T31),
        Y5 = w3 * (m3 * (v2 * (T23 * (T11 * T32 - T12 * T31) + T13 * (T22 * T31 - T21 * T32)))),
        N5 = X5 * X5 + Y5 * Y5, v9 = d6 * T33 + (d3 - T34), D5 = N5 - v9 * v9, w5 = sqrt(D5),
        v10 = w5 - w5, inverse5 = 1.0 / N5, v11 = X5 * v9, v12 = Y5 * v9, v13 = X5 * w5;
    const dhgen_four v14 = e1 * v12, v15 = e2 * v13;
    const double v16 = Y5 * w5;
    const dhgen_four v17 = e1 * e2;

    /* r2 */
    const double wx = T14 - d6 * T13, v18 = a4 * (T13 * factor3);
    const dhgen_four v19 = X5 * (T33 * v17) - v8 * (w3 * v17);
    const double v20 = w3 * v11;
    const dhgen_four v21 = v20 + v14 * (e1 * T33), v22 = wx + inverse5 * (v18 * v21),
        q2 = v22 + w5 * (inverse5 * (v18 * v19));

    /* r1 */
    const double wy = T24 - d6 * T23, v23 = a4 * (T23 * factor3);
    const dhgen_four v24 = wy + inverse5 * (v21 * v23), q1 = v24 + w5 * (inverse5 * (v19 * v23));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)((N5 <=
        doubt_limit_squared2) | (fabs(D5) <= m4 * (blur_slack1 + 2.0 * fabs(v9))) | (v1 <= m1)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-T13, -w3, -v6, -T13),
        dhgen_four_of(T23, -T33, -v5, T23)),
        ratio2 = dhgen_ratio_four(v16 * v17 - v11, -(v14 + v15));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2), angle4 = dhgen_angle_four(ratio2);
    const dhgen_four v25 = e1 * angle2, v26 = v25 - angle4, q4 = dhgen_centred_four(v26),
        q3 = v10 + (angle1 + v3 * v4), q6 = v10 + (angle3 + v4 * v7);

    dhgen_store_4(q, q + 6, q + 12, q + 18, q1, q2, q3, q4);
    dhgen_store_2(q + 4, q + 10, q + 16, q + 22, angle4, q6);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}
#else
static int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    return dhgen_solve_one(solve_wide, T, free_joints, q, status);
}
#endif
#endif

static const int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
static const int choosable[2] = { 4, 2 };
static const struct dhgen_arm arm = {
    6, 4, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.1429, 0.1429, 0.1429, 1.0, 1.0, 1.0 }, 0.14285714285714285, entries, 9,
    1, /* slides */ 1, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 2, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* winds */
    1, /* follows seed */
    NULL, NULL,
    olson_pprrrr_fk, olson_pprrrr_jacobian, solve,
#ifdef OLSON_PPRRRR_PLAIN
    NULL,
#else
    solve_regular,
#endif
};

int olson_pprrrr_ik(
    const double T[16], const double *q_seed, double q[4][6], unsigned char status[4])
{
#ifndef OLSON_PPRRRR_PLAIN
    const int count = solve_regular(T, NULL, &q[0][0], status);
    if (count >= 0)
        return count;
#endif
    return dhgen_careful_ik(&arm, T, NULL, q_seed, &q[0][0], status);
}

int olson_pprrrr_ik_nearest(const double T[16], const double q_seed[6], double q[6])
{
    return dhgen_ik_nearest(&arm, T, NULL, q_seed, q);
}

void olson_pprrrr_ik_batch(size_t n, const double *T, double *q, unsigned char *status)
{
#ifndef OLSON_PPRRRR_PLAIN
    dhgen_ik_batch(&arm, solve_wide, 0, n, T, NULL, q, status);
#else
    dhgen_ik_each(&arm, 0, n, T, NULL, q, status);
#endif
}

/* kuka_kr40pa: KUKA KR 40 PA palletizer, serial equivalent
 *
 * Inverse kinematics, generated from robots/kuka_kr40pa.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_kr40pa.yaml. The formulas and where they come from:
 * kuka_kr40pa.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: fcfe06ceda5e7cac
 * SPDX-License-Identifier: MIT
 */
#include "kuka_kr40pa.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KUKA_KR40PA_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KUKA_KR40PA_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 4
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/complete.h"
#ifndef KUKA_KR40PA_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.3, /* joint offset 1 [m] */
    a1 = 0.15, /* link length 1 [m] */
    a2 = 0.8, /* link length 2 [m] */
    a3 = 0.8, /* link length 3 [m] */
    a4 = 0.15, /* link length 4 [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    longest3 = 2.5600000000000005, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    longest3_reach = 2.5600704004840003, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 2.55999999999993, /* the longest, where branches merge [m^2] */
    shortest3_apart = 4.839999999999999e-28, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 4.839999999999999e-24, /* square of a length that fixes no angle [m^2] */
    doubtful_slack = 0.01, /* a row may miss the pose by this before it is refined */
    doubtful_slack1 = 0.022, /* a row may miss the pose by this before it is refined [m] */
    k1 = 1.2800000000000002, /* 2 * a3 * a2 [m^2] */
    k2 = 0.7812499999999999; /* 1 / k1 [m^-2] */

#ifndef __CUDACC_RTC__
const char *const kuka_kr40pa_branches[2] = {
    "elbow+", "elbow-",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[4] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[4] = { 0, 1, 2, 3 };
DHGEN_TABLE int turning[4] = { 1, 1, 1, 1 };
DHGEN_TABLE double unit[4] = { 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[4] = {
    0.4545454545454546, 0.4545454545454546, 0.4545454545454546, 0.4545454545454546,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[4] = {
    -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
};
DHGEN_TABLE double span_width[4] = {
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
};
DHGEN_TABLE double stride[4] = {
    0.8566748838545029, 0.733891856627126, 0.6287067210378086, 0.53859725722361,
};

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    4, 2, /* joints; solutions that are kept */
    4, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 0, 1, /* families of solutions, limits, more entries than joints */
    48, 2.1999999999999997, 1e-05, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, 0, 0, 0, 0,
    kuka_kr40pa_fk, kuka_kr40pa_jacobian, 0, 0,
};

DHGEN_TABLE struct dhgen_completion completion = { &descents, 0, 0, 0, /* adds others */ 0, /*
    ascends */ 1, /* equations end all */ 0 };


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[4][4] = {
    { 0.0, 0.3, 0.15, -1.5707963267948966 },
    { 0.0, 0.0, 0.8, 0.0 },
    { 0.0, 0.0, 0.8, 0.0 },
    { 0.0, 0.0, 0.15, 1.5707963267948966 },
};
DHGEN_TABLE struct dhgen_links links = { 4, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 6

DHGEN_PUBLIC void kuka_kr40pa_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, v4 = v1 * c3 + x2_x * s3,
        v5 = v2 * c3 + x2_y * s3, y3_z = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - v4 * s4,
        x4_y = x3_y * c4 - v5 * s4, x4_z = y3_z * s4 - v3 * c4;
    T[0] = x4_x; T[1] = -s1; T[2] = v4 * c4 + x3_x * s4;
    T[3] = c1 * a1 + x2_x * a2 + x3_x * a3 + x4_x * a4;
    T[4] = x4_y; T[5] = c1; T[6] = v5 * c4 + x3_y * s4;
    T[7] = s1 * a1 + x2_y * a2 + x3_y * a3 + x4_y * a4;
    T[8] = x4_z; T[9] = 0.0; T[10] = -(y3_z * c4 + v3 * s4);
    T[11] = d1 - s2 * a2 - v3 * a3 + x4_z * a4;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void kuka_kr40pa_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z - v3 * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]),
        p4_x = p3_x + (x3_x * c4 - (v1 * c3 + x2_x * s3) * s4) * a4,
        p4_y = p3_y + (x3_y * c4 - (v2 * c3 + x2_y * s3) * s4) * a4,
        p4_z = p3_z + ((s2 * s3 - c2 * c3) * s4 - v3 * c4) * a4, v4 = p4_z - d1, v5 = p4_z - p2_z,
        v6 = p4_z - p3_z;
    J[0] = -p4_y; J[1] = c1 * v4; J[2] = c1 * v5; J[3] = c1 * v6;
    J[4] = p4_x; J[5] = s1 * v4; J[6] = s1 * v5; J[7] = s1 * v6;
    J[8] = 0.0; J[9] = -(s1 * (p4_y - p1_y) + c1 * (p4_x - p1_x));
    J[10] = -(s1 * (p4_y - p2_y) + c1 * (p4_x - p2_x));
    J[11] = -(s1 * (p4_y - p3_y) + c1 * (p4_x - p3_x));
    J[12] = 0.0; J[13] = -s1; J[14] = -s1; J[15] = -s1;
    J[16] = 0.0; J[17] = c1; J[18] = c1; J[19] = c1;
    J[20] = 1.0; J[21] = 0.0; J[22] = 0.0; J[23] = 0.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[4] = (double (*)[4])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta234, type 3: U0[3, 3] and U0[3, 1] */
    const double w234 = sqrt(T31 * T31 + T33 * T33);
    const int short234 = w234 <= free_limit;
    const double factor234 = 1.0 / (short234 ? 1.0 : w234);
    const double c234 = T33 * factor234, v1 = T31 * factor234;
    const double theta234 = atan2(-v1, c234);

    /* theta1, type 3: U0[1, 2] and U0[2, 2] */
    const double w1 = sqrt(T12 * T12 + T22 * T22);
    const int short1 = w1 <= free_limit;
    const double v2 = 1.0 / (short1 ? 1.0 : w1);
    const double c1 = T22 * v2, v3 = T12 * v2;
    const double q1 = atan2(-v3, c1);

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v4 = v1 * a4;
    const double Z1_3 = T34 - d1 - v4;
    const double v5 = a1 + c234 * a4;
    const double Z2_3 = c1 * T14 - v3 * T24 - v5;
    const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
    const double K3 = N3 - k1;
    const double D3_squared = (longest3 - N3) * (N3 - shortest3);
    const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
    if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) return; /* out of reach */
    const double w3 = sqrt(apart3 ? D3_squared : 0.0);
    const double c3 = K3 * k2;

    /* theta2, type 3: U1[1, 4] and U1[2, 4] */
    const double Y1_2 = a2 + a3 * c3;
    const double v7 = Z1_3 * Y1_2, v9 = Z2_3 * Y1_2;

    /* is the pose one that the arm can take? */
    const double v11 = d1 + v4;
    if (!(fabs(T33 - c234) <= doubtful_slack && fabs(T31 - v1) <= doubtful_slack && fabs(T23 - v1 *
        v3) <= doubtful_slack && fabs(T21 + c234 * v3) <= doubtful_slack && fabs(T11 - c234 * c1) <=
        doubtful_slack && fabs(T13 + v1 * c1) <= doubtful_slack))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* elbow+, elbow- */
        const double e3 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
        const double s3 = w3 * e3 * k2;
        const double q3 = atan2(s3, c3);

        /* theta2 */
        const double v6 = a3 * s3, v8 = Z2_3 * v6 + v7;
        const double C2 = v9 - Z1_3 * v6;
        const double w2 = sqrt(v8 * v8 + C2 * C2);
        const int free2 = w2 <= free_limit_squared2;
        const double factor2 = 1.0 / (free2 ? 1.0 : w2);
        const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
            s2 = free2 ? sin(seed[1]) : -(v8 * factor2);
        const double q2 = atan2(s2, c2);

        /* is the pose one that the arm can take? */
        const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2,
            v10 = a3 * c23 + (v5 + a2 * c2);
        if (!(fabs(T34 + (a3 * s23 + (a2 * s2 - v11))) <= doubtful_slack1 && fabs(T14 - c1 * v10) <=
            doubtful_slack1 && fabs(T24 + v3 * v10) <= doubtful_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q4 = dhgen_wrap(theta234 - (q3 + q2));
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4;
        status[row] = free2 ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

#ifndef KUKA_KR40PA_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05, exact_slack = 1e-12,
 * exact_slack1 = 2.1999999999999995e-12 [m], pose_slack1 = 2.2e-05 [m]. */
static const double
    doubt_limit_squared2 = 4.839999999999999e-08, /* square of a length that fixes no angle [m^2] */
    m1 = 9.999999999999999e-09, /* doubt_limit^2 */
    /* -1 * (longest3 - longest3_reach) * (longest3_reach - shortest3) [m^4] */
    m2 = 0.0001802301952675207,
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 1.8076207197736452e-10,
    m4 = 0.625, /* a3 * k2 [m^-1] */
    m5 = 1e-24, /* exact_slack^2 */
    m6 = 4.839999999999998e-24, /* exact_slack1^2 [m^2] */
    m7 = 1.452e-09, /* 3 * pose_slack1^2 [m^2] */
    m8 = 0.0014519999999999997; /* 3 * doubtful_slack1^2 [m^2] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta234 */
    const dhgen_wide v1 = T31 * T31 + T33 * T33,
        factor234 = dhgen_sqrt_wide(v1) * DHGEN_QUOTIENT(1.0, v1),
        angle1 = dhgen_atan2_wide(-T31, T33);

    /* theta1 */
    const dhgen_wide v2 = T12 * T12 + T22 * T22, v3 = dhgen_sqrt_wide(v2) * DHGEN_QUOTIENT(1.0, v2),
        c1 = T22 * v3, v4 = T12 * v3;

    /* theta3 */
    const dhgen_wide v5 = factor234 * (a4 * T31), Z1_3 = T34 - d1 - v5,
        v6 = a1 + factor234 * (a4 * T33), Z2_3 = c1 * T14 - v4 * T24 - v6,
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_wide(D3_squared), angle2 = dhgen_atan2_wide(w3, N3 - k1);

    /* theta2 */
    const dhgen_wide v7 = w3 * (m4 * Z2_3), v8 = w3 * (m4 * -Z2_3), v9 = m4 * (Z1_3 * N3),
        v10 = v7 + v9, v11 = v8 + v9, v12 = m4 * (Z2_3 * N3), factor2 = DHGEN_QUOTIENT(1.0, N3),
        v13 = m4 * (N3 * -Z1_3), angle3 = dhgen_atan2_wide(-v10, v12 - w3 * (m4 * Z1_3)),
        angle4 = dhgen_atan2_wide(-v11, v12 - w3 * (m4 * -Z1_3));

    /* is the pose one that the arm can take? */
    const dhgen_wide v14 = v6 + Z2_3, v15 = d1 + v5, v16 = T23 - factor234 * (T31 * v4),
        v17 = T21 + factor234 * (T33 * v4), v18 = T11 - factor234 * (T33 * c1),
        v19 = T13 + factor234 * (T31 * c1), v20 = v1 - 1.0,
        v21 = T34 + (factor2 * (a3 * (v7 + v13)) - (v15 + factor2 * (a2 * v10))),
        v22 = T34 + (factor2 * (a3 * (v8 + v13)) - (v15 + factor2 * (a2 * v11))),
        v23 = T14 - c1 * v14, v24 = T24 + v4 * v14, v25 = v23 * v23, v26 = v24 * v24,
        v27 = v26 + (v25 + v21 * v21), v28 = v26 + (v25 + v22 * v22);
    const dhgen_wide_mask exact__p = v27 <= m6, exact__m = v28 <= m6;

    /* joint values */
    const dhgen_wide v29 = angle1 - (angle2 + angle3), v30 = angle1 - (angle4 - angle2);
    const double v31 = DHGEN_NAN;
    const dhgen_wide v32 = dhgen_only_wide(exact__p == 0, v31),
        v33 = dhgen_only_wide(exact__m == 0, v31), angle5 = dhgen_atan2_wide(-T12, T22),
        v34 = angle5 + (w3 - w3);

    q[0] = v32 + v34; q[1] = angle3 + v32; q[2] = angle2 + v32;
    q[3] = v32 + dhgen_centred_wide(v29);
    kind[0] = dhgen_kind_wide(q[0]);
    q[4] = v33 + v34; q[5] = angle4 + v33; q[6] = v33 - angle2;
    q[7] = v33 + dhgen_centred_wide(v30);
    kind[1] = dhgen_kind_wide(q[4]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | (((-m2 <= D3_squared) & (D3_squared <= m3)) | (v2 <= m1) | (N3 <=
        doubt_limit_squared2) | (m5 < v16 * v16 + v17 * v17 + v18 * v18 + v19 * v19 + v20 * v20) |
        (((v27 <= m8) | (v28 <= m8)) & ((exact__p | exact__m) == 0)) | ((m6 < v27) & (v27 <= m7)) |
        ((m6 < v28) & (v28 <= m7)));
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

    /* theta234 */
    const double v1 = T31 * T31 + T33 * T33, factor234 = sqrt(v1) * DHGEN_QUOTIENT(1.0, v1);

    /* theta1 */
    const double v2 = T12 * T12 + T22 * T22, v3 = sqrt(v2) * DHGEN_QUOTIENT(1.0, v2), c1 = T22 * v3,
        v4 = T12 * v3;

    /* theta3 */
    const double v5 = factor234 * (a4 * T31), Z1_3 = T34 - d1 - v5,
        v6 = a1 + factor234 * (a4 * T33), Z2_3 = c1 * T14 - v4 * T24 - v6,
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = sqrt(D3_squared);

    /* theta2 */
    const dhgen_four v7 = w3 * (m4 * (e3 * Z2_3));
    const double v8 = m4 * (Z1_3 * N3);
    const dhgen_four v9 = v7 + v8;
    const double v10 = m4 * (Z2_3 * N3), factor2 = DHGEN_QUOTIENT(1.0, N3), v11 = m4 * (N3 * -Z1_3);

    /* is the pose one that the arm can take? */
    const double v12 = v6 + Z2_3, v13 = d1 + v5, v14 = T23 - factor234 * (T31 * v4),
        v15 = T21 + factor234 * (T33 * v4), v16 = T11 - factor234 * (T33 * c1),
        v17 = T13 + factor234 * (T31 * c1), v18 = v1 - 1.0;
    const dhgen_four v19 = T34 + (factor2 * (a3 * (v7 + v11)) - (v13 + factor2 * (a2 * v9)));
    const double v20 = T14 - c1 * v12, v21 = T24 + v4 * v12, v22 = v20 * v20, v23 = v21 * v21;
    const dhgen_four v24 = v23 + (v22 + v19 * v19);
    const dhgen_four_mask exact_ = v24 <= m6;

    /* joint values */
    const double v27 = DHGEN_NAN;
    const dhgen_four v28 = dhgen_only_four(exact_ == 0, v27);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((m6 < v24) & (v24
        <= m7))) | (unsigned)(((-m2 <= D3_squared) & (D3_squared <= m3)) | (v2 <= m1) | (m5 < v14 *
        v14 + v15 * v15 + v16 * v16 + v17 * v17 + v18 * v18) | (N3 <= doubt_limit_squared2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-T12, -T12, -T12, -T12),
        dhgen_four_of(T22, T22, T22, T22)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(dhgen_shuffle(-v9, dhgen_all_four(-T31), 0, 1, 6,
            3), dhgen_all_four(w3), 0, 1, 2, 7), dhgen_shuffle(dhgen_shuffle(v10 - w3 * (m4 * (e3 *
            Z1_3)), dhgen_all_four(T33), 0, 1, 6, 3), dhgen_all_four(N3 - k1), 0, 1, 2, 7));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle4 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0), packed2 = dhgen_angle_four(ratio2),
        angle3 = dhgen_shuffle(packed2, packed2, 0, 1, 0, 1),
        angle1 = dhgen_shuffle(packed2, packed2, 2, 2, 2, 2),
        angle2 = dhgen_shuffle(packed2, packed2, 3, 3, 3, 3);
    const dhgen_four v25 = e3 * angle2, v26 = angle1 - (angle3 + v25), v29 = angle4 + (w3 - w3),
        q1 = v28 + v29, q2 = angle3 + v28, q3 = v25 + v28, q4 = v28 + dhgen_centred_four(v26);
    if (dhgen_bits_four(v24 <= m8) && !dhgen_bits_four(exact_))
        return -1;

    dhgen_store_4(q, q + 4, q, q + 4, q1, q2, q3, q4);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[1] = { 1 };
DHGEN_TABLE struct dhgen_arm arm = {
    4, 2, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.4545, 0.4545, 0.4545, 1.0, 1.0, 1.0 }, 0.4545454545454546, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ &completion, dhgen_complete_rows,
    NULL, NULL, kuka_kr40pa_fk, kuka_kr40pa_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) kuka_kr40pa_##function
#include "dhgen/functions.h"

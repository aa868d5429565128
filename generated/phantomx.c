/* phantomx: Interbotix PhantomX Pincher
 *
 * Inverse kinematics, generated from robots/phantomx.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/phantomx.yaml. The formulas and where they come from: phantomx.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: d79ae5d065226016
 * SPDX-License-Identifier: MIT
 */
#include "phantomx.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(PHANTOMX_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(PHANTOMX_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 4
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/complete.h"
#ifndef PHANTOMX_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 40.0, /* joint offset 1 [mm] */
    a2 = 105.0, /* link length 2 [mm] */
    a3 = 105.0, /* link length 3 [mm] */
    a4 = 105.0, /* link length 4 [mm] */
    free_limit = 1e-12, /* a length that fixes no angle */
    longest3 = 44100.0, /* square of the longest reach [mm^2] */
    shortest3 = 0.0, /* square of the shortest reach [mm^2] */
    longest3_reach = 44101.4910126025, /* the longest, with what rounding adds [mm^2] */
    shortest3_reach = 0.0, /* the shortest, with what rounding adds [mm^2] */
    longest3_apart = 44099.99999999851, /* the longest, where branches merge [mm^2] */
    shortest3_apart = 1.26025e-23, /* the shortest, where branches merge [mm^2] */
    free_limit_squared2 = 1.26025e-19, /* square of a length that fixes no angle [mm^2] */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    doubtful_slack = 0.01, /* a row may miss the pose by this before it is refined */
    /* a row may miss the pose by this before it is refined [mm] */
    doubtful_slack1 = 3.5500000000000003,
    k1 = 22050.0, /* 2 * a3 * a2 [mm^2] */
    k2 = 4.5351473922902495e-05; /* 1 / k1 [mm^-2] */

#ifndef __CUDACC_RTC__
const char *const phantomx_branches[2] = {
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
    0.0028169014084507044, 0.0028169014084507044, 0.0028169014084507044, 0.0028169014084507044,
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
    48, 355.0, 1e-05, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, 0, 0, 0, 0,
    phantomx_fk, phantomx_jacobian, 0, 0,
};

DHGEN_TABLE struct dhgen_completion completion = { &descents, 0, 0, 0, /* adds others */ 0, /*
    ascends */ 1, /* equations end all */ 0 };


/* The table at q = 0, standard: theta [rad], d [mm], a [mm], alpha [rad]. */
DHGEN_TABLE double table[4][4] = {
    { 0.0, 40.0, 0.0, -1.5707963267948966 },
    { 1.5707963267948966, 0.0, -105.0, 3.141592653589793 },
    { 0.0, 0.0, -105.0, 0.0 },
    { 0.0, 0.0, -105.0, 0.0 },
};
DHGEN_TABLE double tool[12] = { 0.0, 0.0, -1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0 };
DHGEN_TABLE struct dhgen_links links = { 4, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 6

DHGEN_PUBLIC void phantomx_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = c2 * s3 - s2 * c3, y3_x = y2_x * c3 - x2_x * s3,
        y3_y = y2_y * c3 - x2_y * s3, y3_z = c2 * c3 + s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + y3_x * s4,
        x4_y = x3_y * c4 + y3_y * s4, x4_z = x3_z * c4 + y3_z * s4;
    T[0] = x3_x * s4 - y3_x * c4; T[1] = s1; T[2] = -x4_x;
    T[3] = -(x2_x * a2 + x3_x * a3 + x4_x * a4);
    T[4] = x3_y * s4 - y3_y * c4; T[5] = -c1; T[6] = -x4_y;
    T[7] = -(x2_y * a2 + x3_y * a3 + x4_y * a4);
    T[8] = x3_z * s4 - y3_z * c4; T[9] = 0.0; T[10] = -x4_z;
    T[11] = d1 + s2 * a2 - x3_z * a3 - x4_z * a4;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void phantomx_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, x2_y = s1 * c2, y2_x = c1 * s2,
        y2_y = s1 * s2, v2 = x2_x * a2, v3 = x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = c2 * s3 - s2 * c3, v4 = v2 + x3_x * a3,
        v5 = v3 + x3_y * a3, p3_z = p2_z - x3_z * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]),
        v6 = v4 + (x3_x * c4 + (y2_x * c3 - x2_x * s3) * s4) * a4,
        J11 = v5 + (x3_y * c4 + (y2_y * c3 - x2_y * s3) * s4) * a4,
        p4_z = p3_z - (x3_z * c4 + (c2 * c3 + s2 * s3) * s4) * a4, v7 = p4_z - d1, v8 = p4_z - p2_z,
        v9 = p4_z - p3_z;
    J[0] = J11; J[1] = c1 * v7; J[2] = -(c1 * v8); J[3] = -(c1 * v9);
    J[4] = -v6; J[5] = s1 * v7; J[6] = -(s1 * v8); J[7] = -(s1 * v9);
    J[8] = 0.0; J[9] = s1 * J11 + c1 * v6; J[10] = s1 * (v3 - J11) + c1 * (v2 - v6);
    J[11] = s1 * (v5 - J11) + c1 * (v4 - v6);
    J[12] = 0.0; J[13] = -s1; J[14] = s1; J[15] = s1;
    J[16] = 0.0; J[17] = c1; J[18] = -c1; J[19] = -c1;
    J[20] = 1.0; J[21] = 0.0; J[22] = 0.0; J[23] = 0.0;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[4] = (double (*)[4])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 3: U0[1, 3] and U0[2, 3] */
    const double w1 = sqrt(T12 * T12 + T22 * T22);
    const int short1 = w1 <= free_limit;
    const double v1 = 1.0 / (short1 ? 1.0 : w1), v2 = T22 * v1;
    const double s1 = T12 * v1;
    const double q1 = atan2(s1, -v2);

    /* theta2m3m4, type 3: U0[3, 2] and U0[3, 1] */
    const double w2m3m4 = sqrt(T33 * T33 + T31 * T31);
    const int short2m3m4 = w2m3m4 <= free_limit;
    const double factor2m3m4 = 1.0 / (short2m3m4 ? 1.0 : w2m3m4);
    const double v3 = T31 * factor2m3m4;
    const double s2m3m4 = T33 * factor2m3m4;
    const double theta2m3m4 = atan2(s2m3m4, -v3);

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v4 = s2m3m4 * a4;
    const double Z1_3 = T34 - d1 - v4;
    const double v5 = v3 * a4;
    const double Z2_3 = s1 * T24 - v2 * T14 - v5;
    const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
    const double K3 = N3 - k1;
    const double D3_squared = (longest3 - N3) * (N3 - shortest3);
    const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
    if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) return; /* out of reach */
    const double w3 = sqrt(apart3 ? D3_squared : 0.0);
    const double c3 = K3 * k2;

    /* theta2, type 3: U1[1, 4] and U1[2, 4] */
    const double X2_2 = a2 + a3 * c3;
    const double v7 = Z1_3 * X2_2, v8 = Z2_3 * X2_2, v10 = seed[1] + offset2;

    /* is the pose one that the arm can take? */
    const double v12 = d1 + v4;
    if (!(fabs(T32) <= doubtful_slack && fabs(s2m3m4 - T33) <= doubtful_slack && fabs(T22 - v2) <=
        doubtful_slack && fabs(s1 * v3 - T23) <= doubtful_slack && fabs(T13 + v2 * v3) <=
        doubtful_slack && fabs(T12 - s1) <= doubtful_slack))
        return; /* the arm can't take this pose */

    for (int i1 = 0; i1 < 2; i1++) { /* elbow+, elbow- */
        const double e3 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
        const double s3 = w3 * e3 * k2;
        const double q3 = atan2(s3, c3);

        /* theta2 */
        const double v6 = a3 * s3;
        const double S2 = v7 - Z2_3 * v6;
        const double v9 = Z1_3 * v6 + v8;
        const double w2 = sqrt(S2 * S2 + v9 * v9);
        const int free2 = w2 <= free_limit_squared2;
        const double factor2 = 1.0 / (free2 ? 1.0 : w2);
        const double c2 = free2 ? cos(v10) : -(v9 * factor2), s2 = free2 ? sin(v10) : S2 * factor2;
        const double theta2 = atan2(s2, c2);

        /* is the pose one that the arm can take? */
        const double c2m3 = c3 * c2 + s3 * s2;
        const double s2m3 = c3 * s2 - s3 * c2;
        const double v11 = a3 * c2m3 + (a2 * c2 - v5);
        if (!(fabs(T34 - (a3 * s2m3 + (a2 * s2 + v12))) <= doubtful_slack1 && fabs(T14 - v2 * v11)
            <= doubtful_slack1 && fabs(T24 + s1 * v11) <= doubtful_slack1))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q2 = dhgen_wrap(theta2 - offset2);
        const double q4 = dhgen_wrap(theta2 - q3 - theta2m3m4);
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4;
        status[row] = free2 ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

#ifndef PHANTOMX_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05, exact_slack = 1e-12,
 * exact_slack1 = 3.55e-10 [mm], pose_slack1 = 0.00355 [mm]. */
static const double
    /* square of a length that fixes no angle [mm^2] */
    doubt_limit_squared2 = 0.0012602499999999999,
    m1 = 9.999999999999999e-09, /* doubt_limit^2 */
    /* -1 * (longest3 - longest3_reach) * (longest3_reach - shortest3) [mm^4] */
    m2 = 65755.87888877846,
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [mm^4] */
    m3 = 0.06577829481102304,
    m4 = 0.004761904761904762, /* a3 * k2 [mm^-1] */
    m5 = 1e-24, /* exact_slack^2 */
    m6 = 1.2602500000000002e-19, /* exact_slack1^2 [mm^2] */
    m7 = 3.780750000000001e-05, /* 3 * pose_slack1^2 [mm^2] */
    m8 = 37.807500000000005; /* 3 * doubtful_slack1^2 [mm^2] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T12 * T12 + T22 * T22, v2 = dhgen_sqrt_wide(v1) * DHGEN_QUOTIENT(1.0, v1),
        v3 = T22 * v2, s1 = T12 * v2;

    /* theta2m3m4 */
    const dhgen_wide v4 = T33 * T33 + T31 * T31,
        factor2m3m4 = dhgen_sqrt_wide(v4) * DHGEN_QUOTIENT(1.0, v4),
        angle1 = dhgen_atan2_wide(T33, -T31);

    /* theta3 */
    const dhgen_wide v5 = factor2m3m4 * (a4 * T33), Z1_3 = T34 - d1 - v5,
        v6 = factor2m3m4 * (a4 * T31), Z2_3 = s1 * T24 - v3 * T14 - v6,
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_wide(D3_squared), angle2 = dhgen_atan2_wide(w3, N3 - k1);

    /* theta2 */
    const dhgen_wide v7 = w3 * (m4 * Z2_3), v8 = w3 * (m4 * -Z2_3), v9 = m4 * (Z1_3 * N3),
        S2_p = v9 - v7, S2_m = v9 - v8, v10 = m4 * (Z2_3 * N3), factor2 = DHGEN_QUOTIENT(1.0, N3),
        angle3 = dhgen_atan2_wide(S2_p, -(v10 + w3 * (m4 * Z1_3))),
        angle4 = dhgen_atan2_wide(S2_m, -(v10 + w3 * (m4 * -Z1_3)));

    /* is the pose one that the arm can take? */
    const dhgen_wide v11 = -Z2_3 - v6, v12 = d1 + v5, v13 = T33 * factor2m3m4 - T33,
        v14 = factor2m3m4 * (s1 * T31) - T23, v15 = T13 + factor2m3m4 * (v3 * T31), v16 = v1 - 1.0,
        v17 = T34 - (v12 + factor2 * (a2 * S2_p) + factor2 * (a3 * (v7 + v9))),
        v18 = T34 - (v12 + factor2 * (a2 * S2_m) + factor2 * (a3 * (v8 + v9))),
        v19 = T14 - v3 * v11, v20 = T24 + s1 * v11, v21 = v19 * v19, v22 = v20 * v20,
        v23 = v22 + (v21 + v17 * v17), v24 = v22 + (v21 + v18 * v18);
    const dhgen_wide_mask exact__p = v23 <= m6, exact__m = v24 <= m6;

    /* joint values */
    const dhgen_wide v25 = angle3 - offset2, v26 = angle4 - offset2, v27 = angle3 - angle2 - angle1,
        v28 = angle2 + angle4 - angle1;
    const double v29 = DHGEN_NAN;
    const dhgen_wide v30 = dhgen_only_wide(exact__p == 0, v29),
        v31 = dhgen_only_wide(exact__m == 0, v29), angle5 = dhgen_atan2_wide(T12, -T22),
        v32 = angle5 + (w3 - w3);

    q[0] = v30 + v32; q[1] = v30 + dhgen_raised_wide(v25); q[2] = angle2 + v30;
    q[3] = v30 + dhgen_centred_wide(v27);
    kind[0] = dhgen_kind_wide(q[0]);
    q[4] = v31 + v32; q[5] = v31 + dhgen_raised_wide(v26); q[6] = v31 - angle2;
    q[7] = v31 + dhgen_centred_wide(v28);
    kind[1] = dhgen_kind_wide(q[4]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | (((-m2 <= D3_squared) & (D3_squared <= m3)) | (v4 <= m1) | (N3 <=
        doubt_limit_squared2) | (m5 < T32 * T32 + v13 * v13 + v14 * v14 + v15 * v15 + v16 * v16) |
        (((v23 <= m8) | (v24 <= m8)) & ((exact__p | exact__m) == 0)) | ((m6 < v23) & (v23 <= m7)) |
        ((m6 < v24) & (v24 <= m7)));
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

    /* theta1 */
    const double v1 = T12 * T12 + T22 * T22, v2 = sqrt(v1) * DHGEN_QUOTIENT(1.0, v1), v3 = T22 * v2,
        s1 = T12 * v2;

    /* theta2m3m4 */
    const double v4 = T33 * T33 + T31 * T31, factor2m3m4 = sqrt(v4) * DHGEN_QUOTIENT(1.0, v4);

    /* theta3 */
    const double v5 = factor2m3m4 * (a4 * T33), Z1_3 = T34 - d1 - v5, v6 = factor2m3m4 * (a4 * T31),
        Z2_3 = s1 * T24 - v3 * T14 - v6, N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared);

    /* theta2 */
    const dhgen_four v7 = w3 * (m4 * (e3 * Z2_3));
    const double v8 = m4 * (Z1_3 * N3);
    const dhgen_four S2 = v8 - v7;
    const double v9 = m4 * (Z2_3 * N3), factor2 = DHGEN_QUOTIENT(1.0, N3);

    /* is the pose one that the arm can take? */
    const double v10 = -Z2_3 - v6, v11 = d1 + v5, v12 = T33 * factor2m3m4 - T33,
        v13 = factor2m3m4 * (s1 * T31) - T23, v14 = T13 + factor2m3m4 * (v3 * T31), v15 = v1 - 1.0;
    const dhgen_four v16 = T34 - (v11 + factor2 * (a2 * S2) + factor2 * (a3 * (v7 + v8)));
    const double v17 = T14 - v3 * v10, v18 = T24 + s1 * v10, v19 = v17 * v17, v20 = v18 * v18;
    const dhgen_four v21 = v20 + (v19 + v16 * v16);
    const dhgen_four_mask exact_ = v21 <= m6;

    /* joint values */
    const double v25 = DHGEN_NAN;
    const dhgen_four v26 = dhgen_only_four(exact_ == 0, v25);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((m6 < v21) & (v21
        <= m7))) | (unsigned)(((-m2 <= D3_squared) & (D3_squared <= m3)) | (v4 <= m1) | (m5 < T32 *
        T32 + v12 * v12 + v13 * v13 + v14 * v14 + v15 * v15) | (N3 <= doubt_limit_squared2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(T12, T12, T12, T12),
        dhgen_four_of(-T22, -T22, -T22, -T22)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(dhgen_shuffle(S2, dhgen_all_four(T33), 0, 1, 6, 3),
            dhgen_all_four(w3), 0, 1, 2, 7), dhgen_shuffle(dhgen_shuffle(-(v9 + w3 * (m4 * (e3 *
            Z1_3))), dhgen_all_four(-T31), 0, 1, 6, 3), dhgen_all_four(N3 - k1), 0, 1, 2, 7));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle4 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0), packed2 = dhgen_angle_four(ratio2),
        angle3 = dhgen_shuffle(packed2, packed2, 0, 1, 0, 1),
        angle1 = dhgen_shuffle(packed2, packed2, 2, 2, 2, 2),
        angle2 = dhgen_shuffle(packed2, packed2, 3, 3, 3, 3);
    const dhgen_four v22 = angle3 - offset2, v23 = e3 * angle2, v24 = angle3 - v23 - angle1,
        v27 = angle4 + (w3 - w3), q1 = v26 + v27, q2 = v26 + dhgen_raised_four(v22), q3 = v23 + v26,
        q4 = v26 + dhgen_centred_four(v24);
    if (dhgen_bits_four(v21 <= m8) && !dhgen_bits_four(exact_))
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
    { 0.002817, 0.002817, 0.002817, 1.0, 1.0, 1.0 }, 0.0028169014084507044, { 1e-14, 1e-14 },
        entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ &completion, dhgen_complete_rows,
    NULL, NULL, phantomx_fk, phantomx_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) phantomx_##function
#include "dhgen/functions.h"

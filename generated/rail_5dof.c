/* rail_5dof: Arm with four revolute joints on a rail
 *
 * Inverse kinematics, generated from robots/rail_5dof.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/rail_5dof.yaml. The formulas and where they come from:
 * rail_5dof.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 4631ca9d913f2f17
 * SPDX-License-Identifier: MIT
 */
#include "rail_5dof.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(RAIL_5DOF_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(RAIL_5DOF_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 5
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/complete.h"
#ifndef RAIL_5DOF_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    a1 = 2.0, /* link length 2 [m] */
    d3 = 1.0, /* joint offset 3 [m] */
    d5 = 3.0, /* joint offset 5 [m] */
    free_limit2 = 3.6e-11, /* a length that fixes no angle [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    doubtful_slack = 0.01, /* a row may miss the pose by this before it is refined */
    doubtful_slack1 = 0.06; /* a row may miss the pose by this before it is refined [m] */

#ifndef __CUDACC_RTC__
const char *const rail_5dof_branches[2] = {
    "noflip", "flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[5] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 6e-09, 0.027777777777777776, 6.0, 0.5890486225480862, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[5] = { 0, 1, 2, 3, 4 };
DHGEN_TABLE int turning[5] = { 0, 1, 1, 1, 1 };
DHGEN_TABLE double unit[5] = { 6.0, 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[5] = {
    1.0, 0.16666666666666666, 0.16666666666666666, 0.16666666666666666, 0.16666666666666666,
};
/* Rows of the translation that count. */
DHGEN_TABLE int coordinate[3] = { 0, 1, 2 };
/* Between which values starts lie, and what is added from start to start, in parts of that: a
 * direction that is like no other. */
DHGEN_TABLE double span_low[5] = {
    -1.0, -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
};
DHGEN_TABLE double span_width[5] = {
    2.0, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
};
DHGEN_TABLE double stride[5] = {
    0.8812714616335696, 0.7766393890897682, 0.6844301295853426, 0.6031687406857283,
    0.5315553977157914,
};

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    5, 2, /* joints; solutions that are kept */
    5, 6, /* joints that are solved for; equations */
    3, DHGEN_ROTATION, 0, /* coordinates, directions, arm angle */
    0, 0, 1, /* families of solutions, limits, more entries than joints */
    48, 6.0, 1e-05, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, 0, 0, 0, 0,
    rail_5dof_fk, rail_5dof_jacobian, 0, 0,
};

DHGEN_TABLE struct dhgen_completion completion = { &descents, 0, 0, 0, /* adds others */ 0, /*
    ascends */ 1, /* equations end all */ 0 };


/* The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[5][4] = {
    { 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 2.0, 0.0 },
    { 0.0, 1.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 3.0, 0.0, -1.5707963267948966 },
};
DHGEN_TABLE struct dhgen_links links = { 5, DHGEN_MODIFIED, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 7

DHGEN_PUBLIC void rail_5dof_fk(const double q[5], double T[16])
{
    const double c2 = cos(q[1]), s2 = sin(q[1]);
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = c2 * c3, x3_y = s2 * c3, z4_x = c2 * s3,
        z4_y = s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + s2 * s4,
        x4_y = x3_y * c4 - c2 * s4, x4_z = s3 * c4, y4_x = s2 * c4 - x3_x * s4,
        v1 = c2 * c4 + x3_y * s4, v2 = s3 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]);
    T[0] = x4_x * c5 - z4_x * s5; T[1] = -(z4_x * c5 + x4_x * s5); T[2] = y4_x;
    T[3] = a1 + s2 * d3 + y4_x * d5;
    T[4] = x4_y * c5 - z4_y * s5; T[5] = -(z4_y * c5 + x4_y * s5); T[6] = -v1;
    T[7] = -(c2 * d3 + v1 * d5);
    T[8] = x4_z * c5 + c3 * s5; T[9] = c3 * c5 - x4_z * s5; T[10] = -v2; T[11] = q[0] - v2 * d5;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void rail_5dof_jacobian(const double q[5], double J[30])
{
    const double c2 = cos(q[1]), s2 = sin(q[1]), p3_x = a1 + s2 * d3, v1 = c2 * d3;
    const double c3 = cos(q[2]), s3 = sin(q[2]), z4_x = c2 * s3, z4_y = s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), y4_x = s2 * c4 - c2 * c3 * s4,
        v2 = c2 * c4 + s2 * c3 * s4, v3 = s3 * s4, p5_x = p3_x + y4_x * d5, J12 = v1 + v2 * d5,
        v4 = q[0] - v3 * d5 - q[0], v5 = p5_x - p3_x, v6 = v1 - J12;
    J[0] = 0.0; J[1] = J12; J[2] = -(c2 * v4); J[3] = z4_y * v4 + c3 * v6; J[4] = 0.0;
    J[5] = 0.0; J[6] = p5_x - a1; J[7] = -(s2 * v4); J[8] = -(c3 * v5 + z4_x * v4); J[9] = 0.0;
    J[10] = 1.0; J[11] = 0.0; J[12] = s2 * v6 + c2 * v5; J[13] = z4_x * v6 - z4_y * v5; J[14] = 0.0;
    J[15] = 0.0; J[16] = 0.0; J[17] = s2; J[18] = z4_x; J[19] = y4_x;
    J[20] = 0.0; J[21] = 0.0; J[22] = -c2; J[23] = z4_y; J[24] = -v2;
    J[25] = 0.0; J[26] = 1.0; J[27] = 0.0; J[28] = -c3; J[29] = -v3;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[5] = (double (*)[5])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* r1, type 1: U0 A5^-1 [3, 4] */
    const double wz = T34 - T33 * d5;

    /* theta2, type 3: U0 A5^-1 [1, 4] and U0 A5^-1 [2, 4] */
    const double wx = T14 - d5 * T13;
    const double wy = T24 - d5 * T23;
    const double v1 = d3 * (wx - a1);
    const double C2 = d3 * wy;
    const double w2 = sqrt(v1 * v1 + C2 * C2);
    const int short2 = w2 <= free_limit2;
    const double v2 = 1.0 / (short2 ? 1.0 : w2), v3 = C2 * v2;
    const double s2 = v1 * v2;
    const double q2 = atan2(s2, -v3);

    /* theta3, type 2: U3[2, 3] */
    const double X3 = T23 * s2 - T13 * v3;
    const double w3 = sqrt(X3 * X3 + T33 * T33);
    const int free3 = w3 <= free_limit;
    const double divisor3 = free3 ? 1.0 : w3;

    /* theta4, type 3: U3[3, 3] and U3[1, 3] */
    const double v4 = T23 * v3 + T13 * s2, v5 = v4 * v4;

    /* theta5, type 3: U3[2, 2] and U3[2, 1] */
    const double v7 = T22 * s2 - T12 * v3, v8 = T21 * s2 - T11 * v3;

    /* is the pose one that the arm can take? */
    const double v13 = T34 - wz, v15 = T14 - a1, v16 = T24 * s2 - v3 * v15,
        v17 = T11 * s2 + T21 * v3, v18 = s2 * v15 + T24 * v3;

    for (int i1 = 0; i1 < 2; i1++) { /* noflip, flip */
        const double e3 = i1 == 0 ? 1.0 : -1.0;
        /* theta3 */
        if (e3 < 0.0 && free3) continue; /* both signs give the same */
        const double factor3 = e3 / divisor3;
        const double c3 = free3 ? cos(seed[2]) : -(X3 * factor3),
            s3 = free3 ? sin(seed[2]) : -(T33 * factor3);
        const double q3 = atan2(s3, c3);
        const double D3 = w3 * e3;

        /* theta4 */
        const double w4 = sqrt(D3 * D3 + v5);
        const int short4 = w4 <= free_limit;
        const double v6 = 1.0 / (short4 ? 1.0 : w4);
        const double c4 = v4 * v6, s4 = D3 * v6;
        const double q4 = atan2(s4, c4);

        /* theta5 */
        const double C5 = s3 * v7 - T32 * c3;
        const double S5 = s3 * v8 - T31 * c3;
        const double w5 = sqrt(S5 * S5 + C5 * C5);
        const int short5 = w5 <= free_limit;
        const double v9 = 1.0 / (short5 ? 1.0 : w5), v10 = C5 * v9, v11 = S5 * v9;
        const double q5 = atan2(-v11, -v10);

        /* is the pose one that the arm can take? */
        const double v12 = s3 * s4, v14 = c3 * s4;
        if (!(fabs(v13 + d5 * v12) <= doubtful_slack1 && fabs(T33 + v12) <= doubtful_slack &&
            fabs(T31 + (v10 * (s3 * c4) + c3 * v11)) <= doubtful_slack && fabs(d3 + d5 * c4 - v18)
            <= doubtful_slack1 && fabs(c4 - v4) <= doubtful_slack && fabs(v17 + s4 * v10) <=
            doubtful_slack && fabs(v16 + d5 * v14) <= doubtful_slack1 && fabs(v8 - (s3 * v11 - v10 *
            (c3 * c4))) <= doubtful_slack && fabs(X3 + v14) <= doubtful_slack))
            continue; /* the arm can't take this pose */
        const int row = i1;
        q[row][0] = wz; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
        status[row] = free3 ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

#ifndef RAIL_5DOF_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit2 = 0.0036 [m^2], doubt_limit = 9.999999999999999e-05,
 * exact_slack1 = 6e-12 [m], exact_slack = 1e-12. */
static const double
    m1 = 1.296e-05, /* doubt_limit2^2 [m^4] */
    m2 = 9.999999999999999e-09, /* doubt_limit^2 */
    m4 = 3.6000000000000004e-23, /* exact_slack1^2 [m^2] */
    m5 = 1e-24; /* exact_slack^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* r1 */
    const dhgen_wide q1_p = T34 - d5 * T33;

    /* theta2 */
    const dhgen_wide wy = T24 - d5 * T23, v1 = T14 - d5 * T13 - a1, s2 = d3 * v1, C2 = d3 * wy,
        v2 = s2 * s2 + C2 * C2, v3 = dhgen_sqrt_wide(v2) * DHGEN_QUOTIENT(1.0, v2),
        angle1 = dhgen_atan2_wide(v1, -wy);

    /* theta3 */
    const dhgen_wide X3 = T23 * s2 - T13 * C2, v4 = T33 * T33 + v3 * (X3 * (v3 * X3)),
        w3 = dhgen_sqrt_wide(v4), v5 = DHGEN_QUOTIENT(1.0, v4), factor3 = w3 * v5,
        v6 = X3 * factor3, v7 = T33 * factor3, v8 = v3 * v6, angle2 = dhgen_atan2_wide(-v7, -v8);

    /* theta4 */
    const dhgen_wide v9 = T23 * C2 + T13 * s2, v10 = v4 + v3 * (v9 * (v3 * v9)),
        v11 = dhgen_sqrt_wide(v10) * DHGEN_QUOTIENT(1.0, v10), c4 = v9 * v11, s4 = w3 * v11,
        angle3 = dhgen_atan2_wide(s4, v3 * c4);

    /* theta5 */
    const dhgen_wide C5 = w3 * (v5 * (X3 * T32 - T33 * (s2 * T22 - C2 * T12))),
        v12 = s2 * T21 - C2 * T11, S5 = w3 * (v5 * (X3 * T31 - T33 * v12)),
        v13 = v3 * (S5 * (v3 * S5) + C5 * (v3 * C5)),
        v14 = dhgen_sqrt_wide(v13) * DHGEN_QUOTIENT(1.0, v13), v15 = C5 * v14, v16 = S5 * v14,
        angle4 = dhgen_atan2_wide(-v16, -v15);

    /* is the pose one that the arm can take? */
    const dhgen_wide v17 = v7 * s4, v18 = v6 * s4, v19 = T14 - a1, v20 = T34 - q1_p - d5 * v17,
        v21 = T33 - v17, v22 = v3 * v15, v23 = T31 - v3 * (v22 * (v7 * c4) + v8 * v16),
        v24 = d3 + v3 * (d5 * c4) - v3 * (s2 * v19 + T24 * C2), v25 = v3 * (c4 - v9),
        v26 = v3 * (s2 * T11 + C2 * T21 + s4 * v15), v27 = v3 * (T24 * s2 - C2 * v19 - d5 * v18),
        v28 = v3 * (v12 - (v22 * (v8 * c4) - v7 * v16)), v29 = v3 * (X3 - v18);

    q[0] = q1_p; q[1] = angle1; q[2] = angle2; q[3] = angle3; q[4] = angle4;
    kind[0] = dhgen_kind_wide(q[0]);
    q[5] = q1_p; q[6] = angle1; q[7] = angle2 - dhgen_signed_wide(DHGEN_HALF_TURN, -v7);
    q[8] = -angle3; q[9] = angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, -v16);
    kind[1] = dhgen_kind_wide(q[5]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v4 <= m2) | (v2 <= m1) | (v10 <= m2) | (v13 <= m2) | (m5 < v21 * v21 +
        v23 * v23 + v25 * v25 + v26 * v26 + v28 * v28 + v29 * v29) | (m4 < v20 * v20 + v24 * v24 +
        v27 * v27));
}

#if DHGEN_LANES > 1
static const double
    m3 = 0.5; /* 1 / 2 */
/* One regular pose, one sign in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    const dhgen_four e3 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* r1 */
    const double q1 = T34 - d5 * T33;

    /* theta2 */
    const double wy = T24 - d5 * T23, v1 = T14 - d5 * T13 - a1, s2 = d3 * v1, C2 = d3 * wy,
        v2 = s2 * s2 + C2 * C2, v3 = sqrt(v2) * DHGEN_QUOTIENT(1.0, v2);

    /* theta3 */
    const double X3 = T23 * s2 - T13 * C2, v4 = T33 * T33 + v3 * (X3 * (v3 * X3)), w3 = sqrt(v4),
        v5 = DHGEN_QUOTIENT(1.0, v4), factor3 = w3 * v5, v6 = X3 * factor3, v7 = T33 * factor3,
        v8 = v3 * v6, v9 = copysign(DHGEN_HALF_TURN, -v7);
    const dhgen_four v10 = m3 * (e3 - 1.0);

    /* theta4 */
    const double v11 = T23 * C2 + T13 * s2, v12 = v4 + v3 * (v11 * (v3 * v11)),
        v13 = sqrt(v12) * DHGEN_QUOTIENT(1.0, v12), c4 = v11 * v13, s4 = w3 * v13;

    /* theta5 */
    const double C5 = w3 * (v5 * (X3 * T32 - T33 * (s2 * T22 - C2 * T12))),
        v14 = s2 * T21 - C2 * T11, S5 = w3 * (v5 * (X3 * T31 - T33 * v14)),
        v15 = v3 * (S5 * (v3 * S5) + C5 * (v3 * C5)), v16 = sqrt(v15) * DHGEN_QUOTIENT(1.0, v15),
        v17 = C5 * v16, v18 = S5 * v16, v19 = copysign(DHGEN_HALF_TURN, -v18);

    /* is the pose one that the arm can take? */
    const double v20 = v7 * s4, v21 = v6 * s4, v22 = T14 - a1, v23 = T34 - q1 - d5 * v20,
        v24 = T33 - v20, v25 = v3 * v17, v26 = T31 - v3 * (v25 * (v7 * c4) + v8 * v18),
        v27 = d3 + v3 * (d5 * c4) - v3 * (s2 * v22 + T24 * C2), v28 = v3 * (c4 - v11),
        v29 = v3 * (s2 * T11 + C2 * T21 + s4 * v17), v30 = v3 * (T24 * s2 - C2 * v22 - d5 * v21),
        v31 = v3 * (v14 - (v25 * (v8 * c4) - v7 * v18)), v32 = v3 * (X3 - v21);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0)) | (unsigned)((v4 <=
        m2) | (v2 <= m1) | (v12 <= m2) | (v15 <= m2) | (m5 < v24 * v24 + v26 * v26 + v28 * v28 + v29
        * v29 + v31 * v31 + v32 * v32) | (m4 < v23 * v23 + v27 * v27 + v30 * v30)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(v1, -v7, s4, -v18),
        dhgen_four_of(-wy, -v8, v3 * c4, -v17));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2),
        angle4 = dhgen_shuffle(packed1, packed1, 3, 3, 3, 3);
    const dhgen_four q3 = angle2 + v9 * v10, q5 = angle4 + v10 * v19, q4 = e3 * angle3;

    dhgen_store_4(q, q + 5, q, q + 5, dhgen_all_four(q1), angle1, q3, q4);
    dhgen_store_1(q + 4, q + 9, q + 4, q + 9, q5);
    const unsigned long long none1 = (dhgen_bits_four(dhgen_all_four(q1) != dhgen_all_four(q1)) *
        0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[1] = { 2 };
DHGEN_TABLE struct dhgen_arm arm = {
    5, 2, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.1667, 0.1667, 0.1667, 1.0, 1.0, 1.0 }, 0.16666666666666666, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ &completion, dhgen_complete_rows,
    NULL, NULL, rail_5dof_fk, rail_5dof_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) rail_5dof_##function
#include "dhgen/functions.h"

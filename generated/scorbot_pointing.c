/* scorbot_pointing: Scorbot (tool axis only)
 *
 * Inverse kinematics, generated from robots/scorbot_pointing.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/scorbot_pointing.yaml. The formulas and where they come from:
 * scorbot_pointing.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: a9f7f908835d5b23
 * SPDX-License-Identifier: MIT
 */
#include "scorbot_pointing.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(SCORBOT_POINTING_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(SCORBOT_POINTING_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 5
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#include "dhgen/complete.h"
#ifndef SCORBOT_POINTING_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.349, /* joint offset 1 [m] */
    a1 = 0.016, /* link length 1 [m] */
    a2 = 0.221, /* link length 2 [m] */
    a3 = 0.221, /* link length 3 [m] */
    d5 = 0.145, /* joint offset 5 [m] */
    second_weight = 0.952, /* lengths count in arm sizes [m] */
    free_limit1 = 9.52e-13, /* a length that fixes no angle [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    longest3 = 0.195364, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    longest3_reach = 0.1953724157706304, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.1953639999999916, /* the longest, where branches merge [m^2] */
    shortest3_apart = 9.06304e-29, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 9.063039999999997e-25, /* square of a length that fixes no angle [m^2] */
    doubtful_slack = 0.01, /* a row may miss the pose by this before it is refined */
    /* a row may miss the pose by this before it is refined [m] */
    doubtful_slack1 = 0.009519999999999999,
    offset4 = 1.5707963267948966, /* offset of joint 4 [rad] */
    k1 = 0.097682, /* 2 * a3 * a2 [m^2] */
    k2 = 10.237300628570258; /* 1 / k1 [m^-2] */

#ifndef __CUDACC_RTC__
const char *const scorbot_pointing_branches[4] = {
    "back-down", "back-up", "front-up", "front-down",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[5] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 0.0, 0.09817477042468103, 1 },
};

/* The joints that are solved for, and whether they turn; what a step of one means, in rad or
 * lengths, and over the arm's size. */
DHGEN_TABLE int solved[4] = { 0, 1, 2, 3 };
DHGEN_TABLE int turning[4] = { 1, 1, 1, 1 };
DHGEN_TABLE double unit[4] = { 1.0, 1.0, 1.0, 1.0 };
DHGEN_TABLE double measure[4] = {
    1.050420168067227, 1.050420168067227, 1.050420168067227, 1.050420168067227,
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
DHGEN_TABLE int given_places[1] = { 4 };

DHGEN_TABLE struct dhgen_numerical_arm descents = {
    5, 4, /* joints; solutions that are kept */
    4, 6, /* joints that are solved for; equations */
    3, DHGEN_POINTING, 0, /* coordinates, directions, arm angle */
    0, 0, 1, /* families of solutions, limits, more entries than joints */
    48, 0.952, 1e-05, /* starts in a round; size; what counts as a solution */
    solved, turning, coordinate, unit, measure, span_low, span_width, stride,
    0, 0, 0, 0, 1, given_places,
    scorbot_pointing_fk, scorbot_pointing_jacobian, 0, 0,
};

DHGEN_TABLE struct dhgen_completion completion = { &descents, 0, 0, 0, /* adds others */ 0, /*
    ascends */ 1, /* equations end all */ 0 };


/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[5][4] = {
    { 0.0, 0.349, 0.016, -1.5707963267948966 },
    { 0.0, 0.0, 0.221, 0.0 },
    { 0.0, 0.0, 0.221, 0.0 },
    { 1.5707963267948966, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.145, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 5, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 7

DHGEN_PUBLIC void scorbot_pointing_fk(const double q[5], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, v4 = v1 * c3 + x2_x * s3,
        v5 = v2 * c3 + x2_y * s3, y3_z = s2 * s3 - c2 * c3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), x4_x = x3_x * c4 - v4 * s4, x4_y = x3_y * c4 - v5 * s4,
        x4_z = y3_z * s4 - v3 * c4, z4_x = v4 * c4 + x3_x * s4, z4_y = v5 * c4 + x3_y * s4,
        v7 = y3_z * c4 + v3 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]);
    T[0] = x4_x * c5 - s1 * s5; T[1] = -(s1 * c5 + x4_x * s5); T[2] = z4_x;
    T[3] = c1 * a1 + x2_x * a2 + x3_x * a3 + z4_x * d5;
    T[4] = x4_y * c5 + c1 * s5; T[5] = c1 * c5 - x4_y * s5; T[6] = z4_y;
    T[7] = s1 * a1 + x2_y * a2 + x3_y * a3 + z4_y * d5;
    T[8] = x4_z * c5; T[9] = -(x4_z * s5); T[10] = -v7; T[11] = d1 - s2 * a2 - v3 * a3 - v7 * d5;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void scorbot_pointing_jacobian(const double q[5], double J[30])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = p1_x + x2_x * a2, p2_y = p1_y + x2_y * a2, p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z - v3 * a3, v4 = q[3] + offset4;
    const double c4 = cos(v4), s4 = sin(v4), z4_x = (v1 * c3 + x2_x * s3) * c4 + x3_x * s4,
        z4_y = (v2 * c3 + x2_y * s3) * c4 + x3_y * s4, v5 = (s2 * s3 - c2 * c3) * c4 + v3 * s4,
        p5_x = p3_x + z4_x * d5, p5_y = p3_y + z4_y * d5, p5_z = p3_z - v5 * d5, v6 = p5_z - d1,
        v7 = p5_z - p2_z, v8 = p5_x - p3_x, v9 = p5_y - p3_y, v10 = p5_z - p3_z;
    J[0] = -p5_y; J[1] = c1 * v6; J[2] = c1 * v7; J[3] = c1 * v10; J[4] = z4_y * v10 + v5 * v9;
    J[5] = p5_x; J[6] = s1 * v6; J[7] = s1 * v7; J[8] = s1 * v10; J[9] = -(v5 * v8 + z4_x * v10);
    J[10] = 0.0; J[11] = -(s1 * (p5_y - p1_y) + c1 * (p5_x - p1_x));
    J[12] = -(s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x)); J[13] = -(s1 * v9 + c1 * v8);
    J[14] = z4_x * v9 - z4_y * v8;
    J[15] = 0.0; J[16] = -s1; J[17] = -s1; J[18] = -s1; J[19] = z4_x;
    J[20] = 0.0; J[21] = c1; J[22] = c1; J[23] = c1; J[24] = z4_y;
    J[25] = 1.0; J[26] = 0.0; J[27] = 0.0; J[28] = 0.0; J[29] = -v5;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[5] = (double (*)[5])rows;
    (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[3, 4], so theta1 = atan2(T24, T14) or half a turn from it. Where both are
     * small, U1[3, 3] says more: its vector, along the same line, is added */
    const double sigma1 = copysign(second_weight, T14 * T13 + T24 * T23);
    const double Xhat1 = T14 + T13 * sigma1;
    const double Yhat1 = T24 + T23 * sigma1;
    const double w1 = sqrt(Xhat1 * Xhat1 + Yhat1 * Yhat1);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta234, type 3: U1[2, 3] and U1[1, 3] */
    const double v1 = T33 * T33;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v4 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(Xhat1 * factor1),
            s1 = free1 ? sin(seed[0]) : -(Yhat1 * factor1);
        const double q1 = atan2(s1, c1);

        /* theta234 */
        const double Z2_234 = T13 * c1 + T23 * s1;
        const double w234 = sqrt(Z2_234 * Z2_234 + v1);
        const int short234 = w234 <= free_limit;
        const double v2 = 1.0 / (short234 ? 1.0 : w234);
        const double c234 = T33 * v2, s234 = Z2_234 * v2;
        const double theta234 = atan2(s234, c234);

        /* theta3 */
        const double v3 = c234 * d5;
        const double Z1_3 = v4 - v3;
        const double v5 = s234 * d5;
        const double Z2_3 = T14 * c1 + T24 * s1 - a1 - v5;
        const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
        const double K3 = N3 - k1;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) {
            if (free1) dhgen_lose(DHGEN_LOST + 1, D3_squared, q[2 * i1], &status[2 * i1]);
            continue; /* out of reach */
        }
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double c3 = K3 * k2;

        /* theta2, type 3: U1[1, 4] and U1[2, 4] */
        const double Y1_2 = a2 + a3 * c3;
        const double v7 = Z1_3 * Y1_2, v9 = Z2_3 * Y1_2;

        /* is the pose one that the arm can take? */
        const double v10 = a1 + v5, v12 = d1 + v3;
        if (!(fabs(T33 - c234) <= doubtful_slack && fabs(T13 - c1 * s234) <= doubtful_slack &&
            fabs(T23 - s1 * s234) <= doubtful_slack))
            continue; /* the arm can't take this pose */

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
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
                v11 = a3 * c23 + (a2 * c2 + v10);
            if (!(fabs(T34 + (a3 * s23 + (a2 * s2 - v12))) <= doubtful_slack1 && fabs(T14 - c1 *
                v11) <= doubtful_slack1 && fabs(T24 - s1 * v11) <= doubtful_slack1))
                continue; /* the arm can't take this pose */

            /* joint values */
            const double q4 = dhgen_wrap(theta234 - (q3 + q2) - offset4);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4;
            q[row][4] = free_joints[0];
            status[row] = (free1 || free2) ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef SCORBOT_POINTING_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 9.52e-05 [m], doubt_limit = 9.999999999999999e-05,
 * doubt_limit_squared2 = 9.063039999999998e-09 [m^2], exact_slack = 1e-12,
 * exact_slack1 = 9.519999999999998e-13 [m], pose_slack1 = 9.519999999999999e-06 [m]. */
static const double
    m1 = 9.06304e-09, /* doubt_limit1^2 [m^2] */
    m3 = 9.999999999999999e-09, /* doubt_limit^2 */
    /* -1 * (longest3 - longest3_reach) * (longest3_reach - shortest3) [m^4] */
    m4 = 1.6442094386282138e-06,
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m5 = 1.6429994031951627e-12,
    m6 = 4.524886877828054, /* 2 * a3 * k2 [m^-1] */
    m7 = 2.262443438914027, /* a3 * k2 [m^-1] */
    m8 = 8.213869404159996e-17, /* doubt_limit_squared2^2 [m^4] */
    m9 = 1e-24, /* exact_slack^2 */
    m10 = 9.063039999999996e-25, /* exact_slack1^2 [m^2] */
    m11 = 2.7189119999999995e-10, /* 3 * pose_slack1^2 [m^2] */
    m12 = 0.0002718911999999999; /* 3 * doubtful_slack1^2 [m^2] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide sigma1 = dhgen_signed_wide(second_weight, T14 * T13 + T24 * T23),
        Xhat1 = T14 + T13 * sigma1, Yhat1 = T24 + T23 * sigma1, v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1,
        w1 = dhgen_sqrt_wide(v1), v2 = DHGEN_QUOTIENT(1.0, v1), factor1 = w1 * v2,
        v3 = Xhat1 * factor1, v4 = Yhat1 * factor1, angle1 = dhgen_atan2_wide(-Yhat1, -Xhat1);

    /* theta234 */
    const dhgen_wide v5 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1)), v6 = T33 * T33 + v5 * v5,
        w234 = dhgen_sqrt_wide(v6), v7 = DHGEN_QUOTIENT(1.0, v6), v8 = w234 * v7,
        angle2 = dhgen_atan2_wide(-v5, T33);

    /* theta3 */
    const dhgen_wide v9 = d5 * T33, v10 = T34 - d1, v11 = v8 * v9, Z1_3 = v10 - v11, v12 = d5 * v5,
        v13 = T14 * v3 + T24 * v4, v14 = a1 + v13, v15 = a1 - v13, v16 = v8 * v12, v17 = v16 - v14,
        v18 = w234 * (v7 * v12), Z2_3_p = v18 - v14, v19 = v15 + v18, v20 = Z1_3 * Z1_3,
        N3_p = v20 + Z2_3_p * Z2_3_p, N3_m = v20 + v19 * v19, K3_p = N3_p - k1, K3_m = N3_m - k1,
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m), v21 = w3_p - w3_p, v22 = w3_m - w3_m,
        s3_p = k2 * w3_p, s3_m = k2 * w3_m, c3_p = k2 * K3_p, c3_m = k2 * K3_m,
        angle3 = dhgen_atan2_wide(w3_p, K3_p), angle4 = dhgen_atan2_wide(w3_m, K3_m);

    /* theta2 */
    const dhgen_wide v23 = v9 * v10, v24 = v7 * (v9 * v9 + v12 * v12), v25 = v10 * v10,
        Y1_2_p = m7 * (v24 + (v25 + v14 * v14)) - w234 * (m6 * (v7 * (v23 + v12 * v14))),
        Y1_2_m = m7 * (v24 + (v25 + v15 * v15)) - w234 * (m6 * (v7 * (v23 - v12 * v15))),
        v26 = Z1_3 * Y1_2_p, v27 = Z1_3 * Y1_2_m, v28 = v26 + w3_p * (m7 * v17),
        v29 = v26 + w3_p * (m7 * -v17), v30 = w3_m * (m7 * (v15 + v16)), v31 = v27 - v30,
        v32 = v27 + v30, v33 = Z2_3_p * Y1_2_p, v34 = v19 * Y1_2_m, v35 = m7 * Z1_3,
        v36 = m7 * -Z1_3, C2_pp = v33 - w3_p * v35, C2_pm = v33 - w3_p * v36,
        v37 = v34 + w3_m * v35, v38 = v34 + w3_m * v36, v39 = v28 * v28 + C2_pp * C2_pp,
        v40 = v29 * v29 + C2_pm * C2_pm, v41 = v31 * v31 + v37 * v37, v42 = v32 * v32 + v38 * v38,
        w2_pp = dhgen_sqrt_wide(v39), w2_pm = dhgen_sqrt_wide(v40), w2_mp = dhgen_sqrt_wide(v41),
        w2_mm = dhgen_sqrt_wide(v42), v43 = DHGEN_QUOTIENT(1.0, v39),
        v44 = DHGEN_QUOTIENT(1.0, v40), v45 = DHGEN_QUOTIENT(1.0, v41),
        v46 = DHGEN_QUOTIENT(1.0, v42), factor2_pp = w2_pp * v43, factor2_pm = w2_pm * v44,
        factor2_mp = w2_mp * v45, factor2_mm = w2_mm * v46, angle5 = dhgen_atan2_wide(-v28, C2_pp),
        angle6 = dhgen_atan2_wide(-v29, C2_pm), angle7 = dhgen_atan2_wide(-v31, -v37),
        angle8 = dhgen_atan2_wide(-v32, -v38);

    /* is the pose one that the arm can take? */
    const dhgen_wide v47 = a1 - v16, v48 = a1 + v16,
        v49 = v47 + w2_pp * (v43 * (a3 * (c3_p * C2_pp + s3_p * v28) + a2 * C2_pp)),
        v50 = v47 + w2_pm * (v44 * (a3 * (c3_p * C2_pm - s3_p * v29) + a2 * C2_pm)),
        v51 = v48 + w2_mp * (v45 * (a3 * (s3_m * v31 - c3_m * v37) - a2 * v37)),
        v52 = v48 - w2_mm * (v46 * (a3 * (c3_m * v38 + s3_m * v32) + a2 * v38)), v53 = d1 + v11,
        v54 = T33 - T33 * v8, v55 = T13 - v8 * (v3 * v5), v56 = T23 - v8 * (v4 * v5),
        v57 = T34 + (factor2_pp * (a3 * (s3_p * C2_pp - c3_p * v28)) - (v53 + factor2_pp * (a2 *
            v28))),
        v58 = T34 - (factor2_pm * (a3 * (s3_p * C2_pm + c3_p * v29)) + (v53 + factor2_pm * (a2 *
            v29))),
        v59 = T34 - (factor2_mp * (a3 * (s3_m * v37 + c3_m * v31)) + (v53 + factor2_mp * (a2 *
            v31))),
        v60 = T34 + (factor2_mm * (a3 * (s3_m * v38 - c3_m * v32)) - (v53 + factor2_mm * (a2 *
            v32))), v61 = T14 + v3 * v49, v62 = T14 + v3 * v50, v63 = T14 - v3 * v51,
        v64 = T14 - v3 * v52, v65 = T24 + v4 * v49, v66 = T24 + v4 * v50, v67 = T24 - v4 * v51,
        v68 = T24 - v4 * v52, v69 = v57 * v57 + v61 * v61 + v65 * v65,
        v70 = v58 * v58 + v62 * v62 + v66 * v66, v71 = v59 * v59 + v63 * v63 + v67 * v67,
        v72 = v60 * v60 + v64 * v64 + v68 * v68;
    const dhgen_wide_mask exact__pp = v69 <= m10, exact__pm = v70 <= m10, exact__mp = v71 <= m10,
        exact__mm = v72 <= m10;

    /* joint values */
    const dhgen_wide v73 = angle2 - (angle3 + angle5) - offset4,
        v74 = angle2 - (angle6 - angle3) - offset4, v75 = offset4 + (angle2 + (angle4 + angle7)),
        v76 = offset4 + (angle2 + (angle8 - angle4)), v77 = dhgen_centred_wide(v73),
        v78 = dhgen_centred_wide(v74),
        v79 = dhgen_pick_wide(-v75 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
            dhgen_only_wide(DHGEN_HALF_TURN < -v75, -DHGEN_TURN)) - v75,
        v80 = dhgen_pick_wide(-v76 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
            dhgen_only_wide(DHGEN_HALF_TURN < -v76, -DHGEN_TURN)) - v76;
    const double v81 = DHGEN_NAN;
    const dhgen_wide v82 = dhgen_only_wide(exact__pp == 0, v81),
        v83 = dhgen_only_wide(exact__pm == 0, v81), v84 = dhgen_only_wide(exact__mp == 0, v81),
        v85 = dhgen_only_wide(exact__mm == 0, v81), v86 = angle1 + v21,
        v87 = v22 + (angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, -Yhat1)),
        v88 = v21 + free_joints[0], v89 = v22 + free_joints[0];

    q[0] = v82 + v86; q[1] = angle5 + v82; q[2] = angle3 + v82; q[3] = v82 + dhgen_raised_wide(v77);
    q[4] = v82 + v88;
    kind[0] = dhgen_kind_wide(q[0]);
    q[5] = v83 + v86; q[6] = angle6 + v83; q[7] = v83 - angle3; q[8] = v83 + dhgen_raised_wide(v78);
    q[9] = v83 + v88;
    kind[1] = dhgen_kind_wide(q[5]);
    q[10] = v84 + v87; q[11] = angle7 + v84; q[12] = angle4 + v84;
    q[13] = v84 + dhgen_raised_wide(v79); q[14] = v84 + v89;
    kind[2] = dhgen_kind_wide(q[10]);
    q[15] = v85 + v87; q[16] = angle8 + v85; q[17] = v85 - angle4;
    q[18] = v85 + dhgen_raised_wide(v80); q[19] = v85 + v89;
    kind[3] = dhgen_kind_wide(q[15]);
    const dhgen_wide_mask exact = dhgen_approach_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11] +
        free_joints[0]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v6 <= m3) | (v1 <= m1) | ((m10 < v72) & (v72 <= m11)) | (v42 <= m8) |
        ((m10 < v71) & (v71 <= m11)) | (v41 <= m8) | ((m10 < v70) & (v70 <= m11)) | (v40 <= m8) |
        ((m10 < v69) & (v69 <= m11)) | (v39 <= m8) | (m9 < v54 * v54 + v55 * v55 + v56 * v56) |
        (((v72 <= m12) | (v71 <= m12) | (v69 <= m12) | (v70 <= m12)) & ((exact__mm | exact__mp |
        exact__pp | exact__pm) == 0)) | ((-m4 <= D3_squared_p) & (D3_squared_p <= m5)) | ((-m4 <=
        D3_squared_m) & (D3_squared_m <= m5)));
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
    const dhgen_four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e3 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double sigma1 = copysign(second_weight, T14 * T13 + T24 * T23),
        Xhat1 = T14 + T13 * sigma1, Yhat1 = T24 + T23 * sigma1, v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1,
        w1 = sqrt(v1), v2 = DHGEN_QUOTIENT(1.0, v1), factor1 = w1 * v2, v3 = Xhat1 * factor1,
        v4 = Yhat1 * factor1, v5 = copysign(DHGEN_HALF_TURN, -Yhat1);

    /* theta234 */
    const double v6 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1)), v7 = T33 * T33 + v6 * v6,
        w234 = sqrt(v7), v8 = DHGEN_QUOTIENT(1.0, v7), v9 = w234 * v8;

    /* theta3 */
    const double v10 = d5 * T33, v11 = T34 - d1, v12 = v9 * v10, Z1_3 = v11 - v12, v13 = d5 * v6,
        v14 = T14 * v3 + T24 * v4;
    const dhgen_four v15 = a1 + e1 * v14;
    const double v16 = v9 * v13;
    const dhgen_four v17 = e1 * v16, v18 = v17 - v15, v19 = e1 * v13,
        Z2_3 = w234 * (v8 * v19) - v15;
    const double v20 = Z1_3 * Z1_3;
    const dhgen_four N3 = v20 + Z2_3 * Z2_3, K3 = N3 - k1,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_four(D3_squared),
        v21 = w3 - w3, s3 = k2 * w3, c3 = k2 * K3;

    /* theta2 */
    const double v22 = v10 * v11, v23 = v8 * (v10 * v10 + v13 * v13), v24 = v11 * v11;
    const dhgen_four Y1_2 = m7 * (v23 + (v24 + v15 * v15)) - w234 * (m6 * (v8 * (v22 + v15 * v19))),
        v25 = Z1_3 * Y1_2, v26 = v25 + w3 * (m7 * (e3 * v18)), v27 = Z2_3 * Y1_2,
        v28 = m7 * (e3 * Z1_3), C2 = v27 - w3 * v28, v29 = v26 * v26 + C2 * C2,
        w2 = dhgen_sqrt_four(v29), v30 = DHGEN_QUOTIENT(1.0, v29), factor2 = w2 * v30;

    /* is the pose one that the arm can take? */
    const dhgen_four v31 = a1 - v17,
        v32 = v31 + w2 * (v30 * (a3 * (c3 * C2 + e3 * (s3 * v26)) + a2 * C2));
    const double v33 = d1 + v12, v34 = T33 - T33 * v9, v35 = T13 - v9 * (v3 * v6),
        v36 = T23 - v9 * (v4 * v6);
    const dhgen_four v37 = T34 + (factor2 * (a3 * (e3 * (s3 * C2) - c3 * v26)) - (v33 + factor2 *
        (a2 * v26))), v38 = T14 + e1 * (v3 * v32), v39 = T24 + e1 * (v4 * v32),
        v40 = v37 * v37 + v38 * v38 + v39 * v39;
    const dhgen_four_mask exact_ = v40 <= m10;

    /* joint values */
    const double v45 = DHGEN_NAN;
    const dhgen_four v46 = dhgen_only_four(exact_ == 0, v45), v48 = v21 + free_joints[0],
        q5 = v46 + v48;

    if (dhgen_bits_four(((dhgen_all_four(dhgen_approach_misfit(T) + 0.0 * (T[3] + T[7] + T[11] +
        free_joints[0])) <= DHGEN_ORTHONORMAL) == 0) | ((-m4 <= D3_squared) & (D3_squared <= m5)) |
        ((v29 <= m8) | ((m10 < v40) & (v40 <= m11)))) | (unsigned)((v7 <= m3) | (m9 < v34 * v34 +
        v35 * v35 + v36 * v36) | (v1 <= m1)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(dhgen_shuffle(w3,
        dhgen_all_four(-Yhat1), 0, 5, 2, 3), dhgen_all_four(-v6), 0, 1, 2, 7),
        dhgen_shuffle(dhgen_shuffle(K3, dhgen_all_four(-Xhat1), 0, 5, 2, 3), dhgen_all_four(T33), 0,
        1, 2, 7)), ratio2 = dhgen_ratio_four(-v26, C2);
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle3 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle2 = dhgen_shuffle(packed1, packed1, 3, 3, 3, 3), angle4 = dhgen_angle_four(ratio2);
    const dhgen_four v41 = e3 * angle3, v42 = e1 * angle2, v43 = v42 - (angle4 + v41) - offset4,
        v44 = dhgen_centred_four(v43), v47 = v21 + (angle1 + v5 * (m2 * (e1 - 1.0))),
        q1 = v46 + v47, q2 = angle4 + v46, q3 = v41 + v46, q4 = v46 + dhgen_raised_four(v44);
    if (dhgen_bits_four(v40 <= m12) && !dhgen_bits_four(exact_))
        return -1;

    dhgen_store_4(q, q + 5, q + 10, q + 15, q1, q2, q3, q4);
    dhgen_store_1(q + 4, q + 9, q + 14, q + 19, q5);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x204081ull & 0x1010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 4);
    return __builtin_popcountll(0x1010101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int given_joints[1] = { 4 };
DHGEN_TABLE int entries[6] = { 2, 3, 6, 7, 10, 11 };
DHGEN_TABLE int choosable[2] = { 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    5, 4, 1, DHGEN_POINTING, joints, given_joints, 1,
    { 1.05, 1.05, 1.05, 1.0, 1.0, 1.0 }, 1.050420168067227, { 1e-14, 1e-14 }, entries, 6,
    0, /* slides */ 1, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ &completion, dhgen_complete_rows,
    NULL, NULL, scorbot_pointing_fk, scorbot_pointing_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_CALLER_GIVES 1
#define DHGEN_NAME(function) scorbot_pointing_##function
#include "dhgen/functions.h"

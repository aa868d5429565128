/* katana_400: Neuronics Katana 400
 *
 * Inverse kinematics, generated from robots/katana_400.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/katana_400.yaml. The formulas and where they come from:
 * katana_400.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 1b08c7fc3b36b795
 * SPDX-License-Identifier: MIT
 */
#include "katana_400.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KATANA_400_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KATANA_400_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 5
#define DHGEN_ROWS 4
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef KATANA_400_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.2015, /* joint offset 1 [m] */
    a2 = 0.19, /* link length 2 [m] */
    a3 = 0.139, /* link length 3 [m] */
    d5 = 0.1473, /* joint offset 5 [m] */
    second_weight = 0.6778, /* lengths count in arm sizes [m] */
    free_limit1 = 6.777999999999999e-13, /* a length that fixes no angle [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    longest3 = 0.108241, /* square of the longest reach [m^2] */
    shortest3 = 0.002600999999999999, /* square of the shortest reach [m^2] */
    longest3_reach = 0.10824100000004461, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0026009999999930854, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.10824099999999555, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.0026010000000006904, /* the shortest, where branches merge [m^2] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 6.778e-06, /* a pose may be rounded by this [m] */
    offset4 = -1.5707963267948966, /* offset of joint 4 [rad] */
    k1 = 0.055421000000000005, /* a2^2 + a3^2 [m^2] */
    k2 = 18.932222642938278; /* 1 / (2 * a3 * a2) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const katana_400_branches[4] = {
    "front-down", "front-up", "back-up", "back-down",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[5] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[5][4] = {
    { 0.0, 0.2015, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.19, 0.0 },
    { 0.0, 0.0, 0.139, 0.0 },
    { -1.5707963267948966, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.1473, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 5, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 7

DHGEN_PUBLIC void katana_400_fk(const double q[5], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, v5 = q[3] + offset4;
    const double c4 = cos(v5), s4 = sin(v5), x4_x = x3_x * c4 - v3 * s4, x4_y = x3_y * c4 - v4 * s4,
        x4_z = x3_z * c4 + y3_z * s4, v6 = v3 * c4 + x3_x * s4, v7 = v4 * c4 + x3_y * s4,
        z4_z = y3_z * c4 - x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]);
    T[0] = x4_x * c5 - s1 * s5; T[1] = -(s1 * c5 + x4_x * s5); T[2] = -v6;
    T[3] = x2_x * a2 + x3_x * a3 - v6 * d5;
    T[4] = x4_y * c5 + c1 * s5; T[5] = c1 * c5 - x4_y * s5; T[6] = -v7;
    T[7] = x2_y * a2 + x3_y * a3 - v7 * d5;
    T[8] = x4_z * c5; T[9] = -(x4_z * s5); T[10] = z4_z;
    T[11] = d1 + s2 * a2 + x3_z * a3 + z4_z * d5;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void katana_400_jacobian(const double q[5], double J[30])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z + x3_z * a3, v3 = q[3] + offset4;
    const double c4 = cos(v3), s4 = sin(v3), v4 = (v1 * c3 + x2_x * s3) * c4 + x3_x * s4,
        v5 = (v2 * c3 + x2_y * s3) * c4 + x3_y * s4, z4_z = (c2 * c3 - s2 * s3) * c4 - x3_z * s4,
        p5_x = p3_x - v4 * d5, p5_y = p3_y - v5 * d5, p5_z = p3_z + z4_z * d5, v6 = p5_z - d1,
        v7 = p5_z - p2_z, v8 = p5_x - p3_x, v9 = p5_y - p3_y, v10 = p5_z - p3_z;
    J[0] = -p5_y; J[1] = -(c1 * v6); J[2] = -(c1 * v7); J[3] = -(c1 * v10);
    J[4] = -(v5 * v10 + z4_z * v9);
    J[5] = p5_x; J[6] = -(s1 * v6); J[7] = -(s1 * v7); J[8] = -(s1 * v10);
    J[9] = z4_z * v8 + v4 * v10;
    J[10] = 0.0; J[11] = s1 * p5_y + c1 * p5_x; J[12] = s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x);
    J[13] = s1 * v9 + c1 * v8; J[14] = v5 * v8 - v4 * v9;
    J[15] = 0.0; J[16] = s1; J[17] = s1; J[18] = s1; J[19] = -v4;
    J[20] = 0.0; J[21] = -c1; J[22] = -c1; J[23] = -c1; J[24] = -v5;
    J[25] = 1.0; J[26] = 0.0; J[27] = 0.0; J[28] = 0.0; J[29] = z4_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[5] = (double (*)[5])rows;
    (void)free_joints; (void)moved;
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
    const double v7 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* front, back */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : Xhat1 * factor1,
            s1 = free1 ? sin(seed[0]) : Yhat1 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta234 */
        const double Z2_234 = T13 * c1 + T23 * s1;
        const double w234 = sqrt(Z2_234 * Z2_234 + v1);
        const int short234 = w234 <= free_limit;
        const double factor234 = 1.0 / (short234 ? 1.0 : w234);
        const double c234 = T33 * factor234, v2 = Z2_234 * factor234;
        const double theta234 = atan2(-v2, c234);

        /* theta5, type 3: U1[3, 2] and U1[3, 1] */
        const double Z1_5 = T12 * s1 - T22 * c1;
        const double Z2_5 = T11 * s1 - T21 * c1;
        const double w5 = sqrt(Z2_5 * Z2_5 + Z1_5 * Z1_5);
        const int short5 = w5 <= free_limit;
        const double v3 = 1.0 / (short5 ? 1.0 : w5), v4 = Z1_5 * v3, v5 = Z2_5 * v3;
        const double q5 = atan2(-v5, -v4);

        /* theta3 */
        const double v6 = c234 * d5;
        const double Z1_3 = v7 - v6;
        const double v8 = v2 * d5;
        const double Z2_3 = T14 * c1 + T24 * s1 - v8;
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

        /* theta2, type 3: U1[2, 4] and U1[1, 4] */
        const double X1_2 = a2 + a3 * c3;
        const double v9 = Z1_3 * X1_2, v10 = Z2_3 * X1_2;

        /* is the pose one that the arm can take? */
        const double v12 = d1 + v6;
        if (!(fabs(T33 - c234) <= pose_slack && fabs(T31 - v2 * v4) <= pose_slack && fabs(T23 - s1 *
            v2) <= pose_slack && fabs(T21 + (v4 * (s1 * c234) + c1 * v5)) <= pose_slack && fabs(T11
            - (s1 * v5 - v4 * (c1 * c234))) <= pose_slack && fabs(T13 - c1 * v2) <= pose_slack))
            continue; /* the arm can't take this pose */

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double s3 = w3 * e3 * k2;
            const double q3 = atan2(s3, c3);

            /* theta2 */
            const double Y1_2 = a3 * s3;
            const double S2 = v9 - Z2_3 * Y1_2;
            const double C2 = v10 + Z1_3 * Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const double factor2 = 1.0 / w2;
            const double c2 = C2 * factor2, s2 = S2 * factor2;
            const double q2 = atan2(s2, c2);

            /* is the pose one that the arm can take? */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2,
                v11 = a3 * c23 + (v8 + a2 * c2);
            if (!(fabs(T34 - (a3 * s23 + (a2 * s2 + v12))) <= pose_slack1 && fabs(T14 - c1 * v11) <=
                pose_slack1 && fabs(T24 - s1 * v11) <= pose_slack1))
                continue; /* the arm can't take this pose */

            /* joint values */
            const double q4 = dhgen_wrap(theta234 - (q3 + q2) - offset4);
            const int row = 2 * i1 + i2;
            q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
            status[row] = free1 ? DHGEN_FREE_JOINT : DHGEN_OK;
        }
    }
}

#ifndef KATANA_400_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 6.777999999999999e-05 [m],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 4.594128399999999e-09, /* doubt_limit1^2 [m^2] */
    m3 = 9.999999999999999e-09, /* doubt_limit^2 */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m4 = 4.706018907896038e-13,
    m5 = 2.631578947368421, /* a3 * k2 [m^-1] */
    m6 = 0.04415526315789473, /* a2 - a3 * k1 * k2 [m] */
    m7 = 0.19, /* a2 [m] */
    m8 = 0.139, /* a3 [m] */
    m9 = 1.0000000000000002e-10, /* pose_slack^2 */
    m10 = 4.5941284e-11, /* pose_slack1^2 [m^2] */
    m11 = 1.37823852e-10; /* 3 * pose_slack1^2 [m^2] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide sigma1 = dhgen_signed_wide(second_weight, T14 * T13 + T24 * T23),
        Xhat1 = T14 + T13 * sigma1, Yhat1 = T24 + T23 * sigma1, v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1,
        w1 = dhgen_sqrt_wide(v1), v2 = DHGEN_QUOTIENT(1.0, v1), factor1 = w1 * v2,
        c1 = Xhat1 * factor1, s1 = Yhat1 * factor1, angle1 = dhgen_atan2_wide(Yhat1, Xhat1);

    /* theta234 */
    const dhgen_wide Z2_234 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1)),
        v3 = T33 * T33 + Z2_234 * Z2_234, factor234 = dhgen_sqrt_wide(v3) * DHGEN_QUOTIENT(1.0, v3),
        angle2 = dhgen_atan2_wide(-Z2_234, T33);

    /* theta5 */
    const dhgen_wide Z1_5 = w1 * (v2 * (Yhat1 * T12 - Xhat1 * T22)),
        Z2_5 = w1 * (v2 * (Yhat1 * T11 - Xhat1 * T21)), v4 = Z2_5 * Z2_5 + Z1_5 * Z1_5,
        v5 = dhgen_sqrt_wide(v4) * DHGEN_QUOTIENT(1.0, v4), v6 = Z1_5 * v5, v7 = Z2_5 * v5,
        angle3 = dhgen_atan2_wide(-Z2_5, -Z1_5);

    /* theta3 */
    const dhgen_wide v8 = factor234 * (d5 * T33), Z1_3 = T34 - d1 - v8,
        v9 = factor234 * (d5 * Z2_234), Z2_3 = T14 * c1 + T24 * s1 - v9,
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3, K3 = N3 - k1,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_wide(D3_squared),
        v10 = w3 - w3, s3 = k2 * w3, c3 = k2 * K3, angle4 = dhgen_atan2_wide(w3, K3);

    /* theta2 */
    const dhgen_wide X1_2 = a2 + a3 * c3, Y1_2 = a3 * s3, v11 = Z1_3 * X1_2, v12 = Z2_3 * Y1_2,
        v13 = v11 - v12, v14 = v11 + v12, v15 = m6 + m5 * N3, v16 = Z1_3 * v15,
        S2_pp = v16 - w3 * (m5 * Z2_3), S2_pm = v16 - w3 * (m5 * -Z2_3), v17 = Z2_3 * X1_2,
        v18 = Z1_3 * Y1_2, v19 = v17 + v18, v20 = v17 - v18, v21 = w3 * (m5 * Z1_3),
        v22 = w3 * (m5 * -Z1_3), v23 = Z2_3 * v15, C2_pp = v21 + v23, C2_pm = v22 + v23,
        C2_mp = v21 - v23, C2_mm = v22 - v23, v24 = S2_pp * S2_pp, v25 = v24 + C2_pp * C2_pp,
        v26 = S2_pm * S2_pm, v27 = v26 + C2_pm * C2_pm, v28 = v26 + C2_mp * C2_mp,
        v29 = v24 + C2_mm * C2_mm, w2_pp = dhgen_sqrt_wide(v25), w2_pm = dhgen_sqrt_wide(v27),
        w2_mp = dhgen_sqrt_wide(v28), w2_mm = dhgen_sqrt_wide(v29), v30 = DHGEN_QUOTIENT(1.0, v25),
        v31 = DHGEN_QUOTIENT(1.0, v27), v32 = DHGEN_QUOTIENT(1.0, v28),
        v33 = DHGEN_QUOTIENT(1.0, v29), angle5 = dhgen_atan2_wide(S2_pp, C2_pp),
        angle6 = dhgen_atan2_wide(S2_pm, C2_pm), angle7 = dhgen_atan2_wide(S2_pm, C2_mp),
        angle8 = dhgen_atan2_wide(S2_pp, C2_mm);

    /* is the pose one that the arm can take? */
    const dhgen_wide v34 = m7 + m8 * c3, v35 = v19 * v34 - m8 * (s3 * v13),
        v36 = v9 + w2_pp * (v30 * v35), v37 = m8 * (s3 * v14),
        v38 = v9 + w2_pm * (v31 * (v20 * v34 + v37)), v39 = w2_mp * (v32 * (-v20 * v34 - v37)) - v9,
        v40 = w2_mm * (v33 * -v35) - v9, v41 = d1 + v8, v42 = T33 - T33 * factor234,
        v43 = T31 - factor234 * (Z2_234 * v6), v44 = T23 - factor234 * (s1 * Z2_234),
        v45 = T21 + (c1 * v7 + factor234 * (v6 * (s1 * T33))),
        v46 = T11 - (s1 * v7 - factor234 * (v6 * (c1 * T33))),
        v47 = T13 - factor234 * (c1 * Z2_234), v48 = s3 * v19 + c3 * v13,
        v49 = T34 - (a3 * (w2_pp * (v30 * v48)) + (v41 + a2 * (S2_pp * (w2_pp * v30)))),
        v50 = c3 * v14,
        v51 = T34 - (a3 * (w2_pm * (v31 * (v50 - s3 * v20))) + (v41 + a2 * (S2_pm * (w2_pm *
            v31)))),
        v52 = T34 - (a3 * (w2_mp * (v32 * (v50 + s3 * -v20))) + (v41 + a2 * (S2_pm * (w2_mp *
            v32)))),
        v53 = T34 - (a3 * (w2_mm * (v33 * v48)) + (v41 + a2 * (S2_pp * (w2_mm * v33)))),
        v54 = T14 - c1 * v36, v55 = T14 - c1 * v38, v56 = T14 + c1 * v39, v57 = T14 + c1 * v40,
        v58 = T24 - s1 * v36, v59 = T24 - s1 * v38, v60 = T24 + s1 * v39, v61 = T24 + s1 * v40,
        v62 = v49 * v49 + v54 * v54 + v58 * v58, v63 = v51 * v51 + v55 * v55 + v59 * v59,
        v64 = v52 * v52 + v56 * v56 + v60 * v60, v65 = v53 * v53 + v57 * v57 + v61 * v61;

    /* joint values */
    const dhgen_wide v66 = angle2 - (angle4 + angle5) - offset4,
        v67 = angle2 - (angle6 - angle4) - offset4, v68 = offset4 + (angle2 + (angle4 + angle7)),
        v69 = offset4 + (angle2 + (angle8 - angle4)), v70 = dhgen_centred_wide(v66),
        v71 = dhgen_centred_wide(v67),
        v72 = dhgen_pick_wide(-v68 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
            dhgen_only_wide(DHGEN_HALF_TURN < -v68, -DHGEN_TURN)) - v68,
        v73 = dhgen_pick_wide(-v69 <= -DHGEN_HALF_TURN, dhgen_all_wide(DHGEN_TURN),
            dhgen_only_wide(DHGEN_HALF_TURN < -v69, -DHGEN_TURN)) - v69;
    const double v74 = DHGEN_NAN;
    const dhgen_wide v75 = dhgen_only_wide((v62 <= m10) == 0, v74),
        v76 = dhgen_only_wide((v63 <= m10) == 0, v74),
        v77 = dhgen_only_wide((v64 <= m10) == 0, v74),
        v78 = dhgen_only_wide((v65 <= m10) == 0, v74), v79 = angle1 + v10,
        v80 = v10 + (angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, Yhat1)), v81 = angle3 + v10,
        v82 = v10 + (angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, -Z2_5));

    q[0] = v75 + v79; q[1] = angle5 + v75; q[2] = angle4 + v75;
    q[3] = v75 + dhgen_lowered_wide(v70); q[4] = v75 + v81;
    kind[0] = dhgen_kind_wide(q[0]);
    q[5] = v76 + v79; q[6] = angle6 + v76; q[7] = v76 - angle4;
    q[8] = v76 + dhgen_lowered_wide(v71); q[9] = v76 + v81;
    kind[1] = dhgen_kind_wide(q[5]);
    q[10] = v77 + v80; q[11] = angle7 + v77; q[12] = angle4 + v77;
    q[13] = v77 + dhgen_lowered_wide(v72); q[14] = v77 + v82;
    kind[2] = dhgen_kind_wide(q[10]);
    q[15] = v78 + v80; q[16] = angle8 + v78; q[17] = v78 - angle4;
    q[18] = v78 + dhgen_lowered_wide(v73); q[19] = v78 + v82;
    kind[3] = dhgen_kind_wide(q[15]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v3 <= m3) | (v1 <= m1) | (v4 <= m3) | (dhgen_abs_wide(D3_squared) <= m4)
        | (m9 < v42 * v42 + v43 * v43 + v44 * v44 + v45 * v45 + v46 * v46 + v47 * v47) | ((m10 <
        v65) & (v65 <= m11)) | ((m10 < v64) & (v64 <= m11)) | ((m10 < v62) & (v62 <= m11)) | ((m10 <
        v63) & (v63 <= m11)));
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
    const double sigma1 = copysign(second_weight, T14 * T13 + T24 * T23),
        Xhat1 = T14 + T13 * sigma1, Yhat1 = T24 + T23 * sigma1, v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1,
        w1 = sqrt(v1), v2 = DHGEN_QUOTIENT(1.0, v1), factor1 = w1 * v2, c1 = Xhat1 * factor1,
        s1 = Yhat1 * factor1, v3 = copysign(DHGEN_HALF_TURN, Yhat1);
    const dhgen_four v4 = m2 * (e1 - 1.0);

    /* theta234 */
    const double Z2_234 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1)), v5 = T33 * T33 + Z2_234 * Z2_234,
        factor234 = sqrt(v5) * DHGEN_QUOTIENT(1.0, v5);

    /* theta5 */
    const double Z1_5 = w1 * (v2 * (Yhat1 * T12 - Xhat1 * T22)),
        Z2_5 = w1 * (v2 * (Yhat1 * T11 - Xhat1 * T21)), v6 = Z2_5 * Z2_5 + Z1_5 * Z1_5,
        v7 = sqrt(v6) * DHGEN_QUOTIENT(1.0, v6), v8 = Z1_5 * v7, v9 = Z2_5 * v7,
        v10 = copysign(DHGEN_HALF_TURN, -Z2_5);

    /* theta3 */
    const double v11 = factor234 * (d5 * T33), Z1_3 = T34 - d1 - v11,
        v12 = factor234 * (d5 * Z2_234), Z2_3 = T14 * c1 + T24 * s1 - v12,
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3, K3 = N3 - k1,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared), v13 = w3 - w3,
        s3 = k2 * w3, c3 = k2 * K3;

    /* theta2 */
    const double X1_2 = a2 + a3 * c3, Y1_2 = a3 * s3, v14 = Z1_3 * X1_2, v15 = Z2_3 * Y1_2;
    const dhgen_four v16 = e1 * e3, v17 = v14 - v15 * v16;
    const double v18 = m6 + m5 * N3, v19 = Z1_3 * v18;
    const dhgen_four S2 = v19 - w3 * (m5 * (Z2_3 * v16));
    const double v20 = Z2_3 * X1_2, v21 = Z1_3 * Y1_2;
    const dhgen_four v22 = e1 * v20, v23 = e3 * v21, v24 = v22 + v23, v25 = w3 * (m5 * (e3 * Z1_3)),
        v26 = Z2_3 * (e1 * v18), C2 = v25 + v26, v27 = S2 * S2 + C2 * C2, w2 = dhgen_sqrt_four(v27),
        v28 = DHGEN_QUOTIENT(1.0, v27);

    /* is the pose one that the arm can take? */
    const dhgen_four v29 = e3 * s3, v30 = e1 * v12;
    const double v31 = m7 + m8 * c3;
    const dhgen_four v32 = v30 + w2 * (v28 * (v24 * v31 - m8 * (v17 * v29)));
    const double v33 = d1 + v11, v34 = T33 - T33 * factor234, v35 = T31 - factor234 * (Z2_234 * v8),
        v36 = T23 - factor234 * (s1 * Z2_234),
        v37 = T21 + (c1 * v9 + factor234 * (v8 * (s1 * T33))),
        v38 = T11 - (s1 * v9 - factor234 * (v8 * (c1 * T33))),
        v39 = T13 - factor234 * (c1 * Z2_234);
    const dhgen_four v40 = T34 - (a3 * (w2 * (v28 * (v24 * v29 + c3 * v17))) + (v33 + a2 * (S2 * (w2
        * v28)))), v41 = T14 - e1 * (c1 * v32), v42 = T24 - e1 * (s1 * v32),
        v43 = v40 * v40 + v41 * v41 + v42 * v42;

    /* joint values */
    const double v48 = DHGEN_NAN;
    const dhgen_four v49 = dhgen_only_four((v43 <= m10) == 0, v48);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((m10 < v43) &
        (v43 <= m11))) | (unsigned)((v5 <= m3) | (v1 <= m1) | (v6 <= m3) | (m9 < v34 * v34 + v35 *
        v35 + v36 * v36 + v37 * v37 + v38 * v38 + v39 * v39) | (fabs(D3_squared) <= m4)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(Yhat1, -Z2_234, -Z2_5, w3),
        dhgen_four_of(Xhat1, T33, -Z1_5, K3)), ratio2 = dhgen_ratio_four(S2, C2);
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1),
        angle3 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2),
        angle4 = dhgen_shuffle(packed1, packed1, 3, 3, 3, 3), angle5 = dhgen_angle_four(ratio2);
    const dhgen_four v44 = e3 * angle4, v45 = e1 * angle2, v46 = v45 - (angle5 + v44) - offset4,
        v47 = dhgen_centred_four(v46), v50 = v13 + (angle1 + v3 * v4), q1 = v49 + v50,
        q2 = angle5 + v49, q3 = v44 + v49, q4 = v49 + dhgen_lowered_four(v47),
        v51 = v13 + (angle3 + v4 * v10), q5 = v49 + v51;

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

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[1] = { 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    5, 4, 0, DHGEN_POSE, joints, NULL, 0,
    { 1.475, 1.475, 1.475, 1.0, 1.0, 1.0 }, 1.475361463558572, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 1, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, katana_400_fk,
    katana_400_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) katana_400_##function
#include "dhgen/functions.h"

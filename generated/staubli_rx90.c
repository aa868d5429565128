/* staubli_rx90: Stäubli RX90
 *
 * Inverse kinematics, generated from robots/staubli_rx90.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/staubli_rx90.yaml. The formulas and where they come from:
 * staubli_rx90.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: c0b36274375d6e2a
 * SPDX-License-Identifier: MIT
 */
#include "staubli_rx90.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(STAUBLI_RX90_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(STAUBLI_RX90_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef STAUBLI_RX90_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    a2 = 0.45, /* link length 3 [m] */
    d4 = 0.45, /* joint offset 4 [m] */
    free_limit1 = 9e-13, /* a length that fixes no angle [m] */
    longest3 = 0.81, /* square of the longest reach [m^2] */
    shortest3 = 0.0, /* square of the shortest reach [m^2] */
    longest3_reach = 0.8100000000001621, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.0, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.8099999999999838, /* the longest, where branches merge [m^2] */
    shortest3_apart = 8.099999999999999e-29, /* the shortest, where branches merge [m^2] */
    free_limit_squared2 = 8.1e-25, /* square of a length that fixes no angle [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.405, /* 2 * d4 * a2 [m^2] */
    k2 = 6.096631611034903; /* 1 / (k1^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const staubli_rx90_branches[8] = {
    "back-up-noflip", "back-up-flip", "back-down-noflip", "back-down-flip", "front-down-noflip",
    "front-down-flip", "front-up-noflip", "front-up-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.45, 0.0 },
    { 0.0, 0.45, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_MODIFIED, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void staubli_rx90_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, x4_z = x3_z * c4, z5_x = s1 * c4 + x3_x * s4,
        y4_y = c1 * c4 - x3_y * s4, z5_z = x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v3 * s5,
        x5_y = x4_y * c5 - v4 * s5, x5_z = x4_z * c5 + y3_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - z5_x * s6; T[1] = -(z5_x * c6 + x5_x * s6); T[2] = -(v3 * c5 + x4_x * s5);
    T[3] = x2_x * a2 - v3 * d4;
    T[4] = x5_y * c6 + y4_y * s6; T[5] = y4_y * c6 - x5_y * s6; T[6] = -(v4 * c5 + x4_y * s5);
    T[7] = x2_y * a2 - v4 * d4;
    T[8] = x5_z * c6 - z5_z * s6; T[9] = -(z5_z * c6 + x5_z * s6); T[10] = y3_z * c5 - x4_z * s5;
    T[11] = s2 * a2 + y3_z * d4;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void staubli_rx90_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p3_x = x2_x * a2, p3_y = x2_y * a2, p3_z = s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, p4_x = p3_x - v3 * d4,
        p4_y = p3_y - v4 * d4, p4_z = p3_z + y3_z * d4;
    const double c4 = cos(q[3]), s4 = sin(q[3]);
    const double c5 = cos(q[4]), s5 = sin(q[4]), v5 = p4_z - p3_z;
    J[0] = -p4_y; J[1] = -(c1 * p4_z); J[2] = -(c1 * v5); J[3] = 0.0; J[4] = 0.0; J[5] = 0.0;
    J[6] = p4_x; J[7] = -(s1 * p4_z); J[8] = -(s1 * v5); J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = s1 * p4_y + c1 * p4_x; J[14] = s1 * (p4_y - p3_y) + c1 * (p4_x - p3_x);
    J[15] = 0.0; J[16] = 0.0; J[17] = 0.0;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = -v3; J[22] = s1 * c4 + x3_x * s4;
    J[23] = -(v3 * c5 + (x3_x * c4 - s1 * s4) * s5);
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -v4; J[28] = x3_y * s4 - c1 * c4;
    J[29] = -(v4 * c5 + (x3_y * c4 + c1 * s4) * s5);
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = y3_z; J[34] = x3_z * s4;
    J[35] = y3_z * c5 - x3_z * c4 * s5;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[2, 4] */
    const double w1 = sqrt(T14 * T14 + T24 * T24);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 8: U1[3, 4] and U1[1, 4] */
    const double v1 = T34 * T34;

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
        const double K3 = N3 - k1;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double v2 = k1 * K3 * k2;

        /* theta2, type 3: U1[3, 4] and U1[1, 4] */
        const double X1_2 = a2 + d4 * v2;
        const double v3 = T34 * X1_2, v4 = D1 * X1_2;

        /* theta4, type 2: U4[2, 3] */
        const double v5 = T13 * c1 + T23 * s1;
        const double Y4 = T13 * s1 - T23 * c1;
        const double v6 = Y4 * Y4;

        /* theta6, type 3: U4[2, 2] and U4[2, 1] */
        const double v7 = T12 * s1 - T22 * c1, v8 = T12 * c1 + T22 * s1, v10 = T11 * s1 - T21 * c1,
            v11 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double c3 = k2 * (k1 * (w3 * e3));
            const double q3 = atan2(-v2, c3);

            /* theta2 */
            const double Y1_2 = d4 * c3;
            const double S2 = v3 + D1 * Y1_2;
            const double C2 = T34 * Y1_2 - v4;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(seed[1]) : C2 * factor2,
                s2 = free2 ? sin(seed[1]) : S2 * factor2;
            const double q2 = atan2(s2, c2);

            /* theta4 */
            const double c23 = c3 * c2 + v2 * s2, s23 = c3 * s2 - v2 * c2;
            const double X4 = c23 * v5 + T33 * s23;
            const double w4 = sqrt(X4 * X4 + v6);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[3, 3] and U4[1, 3] */
            const double c5 = T33 * c23 - s23 * v5;

            /* theta6 */
            const double v9 = c23 * v8 + T32 * s23, v12 = c23 * v11 + T31 * s23;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);
                const double s5 = w4 * e4;

                /* theta5 */
                const double q5 = atan2(s5, c5);

                /* theta6 */
                const double q6 = atan2(-(c4 * v10 + s4 * v12), -(c4 * v7 + s4 * v9));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free2 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef STAUBLI_RX90_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 9e-05 [m], doubt_limit_squared2 = 8.1e-09 [m^2],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 8.100000000000001e-09, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 1.312949748921684e-11,
    m4 = 1.1111111111111112, /* d4 * k1 * k2 [m^-1] */
    m5 = 6.561e-17, /* doubt_limit_squared2^2 [m^4] */
    m6 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T14 * T14 + T24 * T24, w1 = dhgen_sqrt_wide(v1),
        v2 = DHGEN_QUOTIENT(1.0, v1), angle1 = dhgen_atan2_wide(-T24, -T14);

    /* theta3 */
    const dhgen_wide N3 = v1 + T34 * T34, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_wide(D3_squared), v3 = w3 - w3, v4 = k1 * (N3 - k1), v5 = k2 * v4,
        v6 = k1 * w3, c3 = k2 * v6, angle2 = dhgen_atan2_wide(-v4, v6),
        q3_pmp = dhgen_signed_wide(DHGEN_HALF_TURN, -v4) - angle2;

    /* theta2 */
    const dhgen_wide X1_2 = a2 + d4 * v5, Y1_2 = d4 * c3, v7 = T34 * X1_2, v8 = w1 * Y1_2,
        v9 = v7 + v8, v10 = v7 - v8, v11 = m4 * (T34 * N3), v12 = w3 * (m4 * w1), S2_pp = v11 + v12,
        S2_pm = v11 - v12, v13 = w1 * X1_2, v14 = T34 * Y1_2, v15 = v14 - v13, v16 = v13 + v14,
        v17 = w3 * (m4 * T34), v18 = m4 * (w1 * N3), C2_pp = v17 - v18, C2_mp = v17 + v18,
        v19 = S2_pp * S2_pp, v20 = v19 + C2_pp * C2_pp, v21 = S2_pm * S2_pm + C2_mp * C2_mp,
        v22 = v19 - C2_pp * -C2_pp, w2_pp = dhgen_sqrt_wide(v20), w2_pm = dhgen_sqrt_wide(v21),
        w2_mm = dhgen_sqrt_wide(v22), v23 = DHGEN_QUOTIENT(1.0, v20),
        v24 = DHGEN_QUOTIENT(1.0, v21), v25 = DHGEN_QUOTIENT(1.0, v22),
        angle3 = dhgen_atan2_wide(S2_pp, C2_pp), angle4 = dhgen_atan2_wide(S2_pm, -C2_mp),
        angle5 = dhgen_atan2_wide(S2_pm, C2_mp), angle6 = dhgen_atan2_wide(S2_pp, -C2_pp);

    /* theta4 */
    const dhgen_wide v26 = v5 * v9, c23_pp = w2_pp * (v23 * (c3 * v15 + v26)),
        c23_pm = w2_pm * (v24 * (c3 * v16 + v5 * v10)), c23_mm = w2_mm * (v25 * (v26 - c3 * -v15)),
        v27 = c3 * v9, s23_pp = w2_pp * (v23 * (v27 - v5 * v15)), v28 = v5 * v16 - c3 * v10,
        s23_pm = w2_pm * (v24 * v28), s23_mp = w2_pm * (v24 * -v28),
        v29 = w2_mm * (v25 * (v27 + v5 * -v15)), v30 = w1 * (v2 * (T14 * T13 + T24 * T23)),
        X4_pp = s23_pp * T33 - c23_pp * v30, v31 = c23_pm * v30, X4_pm = s23_pm * T33 - v31,
        X4_mp = v31 + s23_mp * T33, X4_mm = c23_mm * v30 - v29 * T33,
        Y4 = w1 * (v2 * (T14 * T23 - T24 * T13)), v32 = Y4 * Y4, v33 = v32 + X4_pp * X4_pp,
        v34 = v32 + X4_pm * X4_pm, v35 = v32 + X4_mp * X4_mp, v36 = v32 + X4_mm * X4_mm,
        w4_pp = dhgen_sqrt_wide(v33), w4_pm = dhgen_sqrt_wide(v34), w4_mp = dhgen_sqrt_wide(v35),
        w4_mm = dhgen_sqrt_wide(v36), factor4_pp = w4_pp * DHGEN_QUOTIENT(1.0, v33),
        factor4_pm = w4_pm * DHGEN_QUOTIENT(1.0, v34),
        factor4_mp = w4_mp * DHGEN_QUOTIENT(1.0, v35),
        factor4_mm = w4_mm * DHGEN_QUOTIENT(1.0, v36), v37 = X4_pp * factor4_pp,
        v38 = X4_pm * factor4_pm, v39 = X4_mp * factor4_mp, v40 = X4_mm * factor4_mm,
        s4_pp = Y4 * factor4_pp, s4_pm = Y4 * factor4_pm, s4_mp = Y4 * factor4_mp,
        s4_mm = Y4 * factor4_mm, angle7 = dhgen_atan2_wide(Y4, -X4_pp),
        angle8 = dhgen_atan2_wide(Y4, -X4_pm), angle9 = dhgen_atan2_wide(-Y4, -X4_mp),
        angle10 = dhgen_atan2_wide(-Y4, -X4_mm), v41 = dhgen_signed_wide(DHGEN_HALF_TURN, Y4),
        v42 = dhgen_signed_wide(DHGEN_HALF_TURN, -Y4);

    /* theta5 */
    const dhgen_wide angle11 = dhgen_atan2_wide(w4_pp, c23_pp * T33 + s23_pp * v30),
        v43 = c23_pm * T33, angle12 = dhgen_atan2_wide(w4_pm, v43 + s23_pm * v30),
        angle13 = dhgen_atan2_wide(w4_mp, v43 - s23_mp * v30),
        angle14 = dhgen_atan2_wide(w4_mm, c23_mm * T33 + v29 * v30);

    /* theta6 */
    const dhgen_wide v44 = w1 * (v2 * (T14 * T22 - T24 * T12)),
        v45 = w1 * (v2 * (T14 * T12 + T24 * T22)), v46 = w1 * (v2 * (T14 * T21 - T24 * T11)),
        v47 = w1 * (v2 * (T14 * T11 + T24 * T21)),
        v48 = v37 * v46 - s4_pp * (s23_pp * T31 - c23_pp * v47), v49 = c23_pm * v47,
        v50 = v38 * v46 - s4_pm * (s23_pm * T31 - v49),
        v51 = s4_mp * (v49 + s23_mp * T31) - v39 * v46,
        v52 = s4_mm * (c23_mm * v47 - v29 * T31) - v40 * v46,
        angle15 = dhgen_atan2_wide(v48, v37 * v44 - s4_pp * (s23_pp * T32 - c23_pp * v45)),
        v53 = c23_pm * v45,
        angle16 = dhgen_atan2_wide(v50, v38 * v44 - s4_pm * (s23_pm * T32 - v53)),
        angle17 = dhgen_atan2_wide(v51, s4_mp * (v53 + s23_mp * T32) - v39 * v44),
        angle18 = dhgen_atan2_wide(v52, s4_mm * (c23_mm * v45 - v29 * T32) - v40 * v44);

    /* joint values */
    const dhgen_wide q1_ppp = angle1 + v3,
        q1_mpp = v3 + (angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, -T24));

    q[0] = q1_ppp; q[1] = angle3; q[2] = angle2; q[3] = angle7; q[4] = angle11; q[5] = angle15;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_ppp; q[7] = angle3; q[8] = angle2; q[9] = angle7 - v41; q[10] = -angle11;
    q[11] = angle15 - dhgen_signed_wide(DHGEN_HALF_TURN, v48);
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_ppp; q[13] = angle4; q[14] = q3_pmp; q[15] = angle8; q[16] = angle12;
    q[17] = angle16;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_ppp; q[19] = angle4; q[20] = q3_pmp; q[21] = angle8 - v41; q[22] = -angle12;
    q[23] = angle16 - dhgen_signed_wide(DHGEN_HALF_TURN, v50);
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = angle5; q[26] = angle2; q[27] = angle9; q[28] = angle13;
    q[29] = angle17;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = angle5; q[32] = angle2; q[33] = angle9 - v42; q[34] = -angle13;
    q[35] = angle17 - dhgen_signed_wide(DHGEN_HALF_TURN, v51);
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mpp; q[37] = angle6; q[38] = q3_pmp; q[39] = angle10; q[40] = angle14;
    q[41] = angle18;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mpp; q[43] = angle6; q[44] = q3_pmp; q[45] = angle10 - v42; q[46] = -angle14;
    q[47] = angle18 - dhgen_signed_wide(DHGEN_HALF_TURN, v52);
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v36 <= m6) | (v22 <= m5) | (v35 <= m6) | (v34 <= m6) | (v21 <= m5) |
        (v33 <= m6) | (v1 <= m1) | (dhgen_abs_wide(D3_squared) <= m3) | (v20 <= m5));
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
    const double v1 = T14 * T14 + T24 * T24, w1 = sqrt(v1), v2 = DHGEN_QUOTIENT(1.0, v1),
        v3 = copysign(DHGEN_HALF_TURN, -T24);

    /* theta3 */
    const double N3 = v1 + T34 * T34, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = sqrt(D3_squared), v4 = w3 - w3, v5 = k1 * (N3 - k1), v6 = k2 * v5, v7 = k1 * w3,
        c3 = k2 * v7, v8 = copysign(DHGEN_HALF_TURN, -v5);

    /* theta2 */
    const double X1_2 = a2 + d4 * v6, Y1_2 = d4 * c3, v9 = T34 * X1_2, v10 = w1 * Y1_2;
    const dhgen_four v11 = e1 * e3, v12 = v9 + v10 * v11;
    const double v13 = m4 * (T34 * N3);
    const dhgen_four S2 = v13 + w3 * (m4 * (w1 * v11));
    const double v14 = w1 * X1_2, v15 = T34 * Y1_2;
    const dhgen_four v16 = e3 * v15, v17 = e1 * v14, v18 = v16 - v17, v19 = w3 * (m4 * (e3 * T34)),
        v20 = m4 * (w1 * (e1 * N3)), C2 = v19 - v20, v21 = S2 * S2 + C2 * C2,
        w2 = dhgen_sqrt_four(v21), v22 = DHGEN_QUOTIENT(1.0, v21);

    /* theta4 */
    const dhgen_four v23 = e3 * c3, c23 = w2 * (v22 * (v18 * v23 + v6 * v12)),
        s23 = w2 * (v22 * (v12 * v23 - v6 * v18));
    const double v24 = w1 * (v2 * (T14 * T13 + T24 * T23));
    const dhgen_four X4 = s23 * T33 - e1 * (c23 * v24);
    const double Y4 = w1 * (v2 * (T14 * T23 - T24 * T13)), v25 = Y4 * Y4;
    const dhgen_four v26 = v25 + X4 * X4, w4 = dhgen_sqrt_four(v26),
        factor4 = w4 * DHGEN_QUOTIENT(1.0, v26), v27 = X4 * factor4, s4 = Y4 * factor4,
        v28 = e1 * Y4, v29 = dhgen_signed_four(DHGEN_HALF_TURN, v28);

    /* theta6 */
    const double v30 = w1 * (v2 * (T14 * T22 - T24 * T12)),
        v31 = w1 * (v2 * (T14 * T12 + T24 * T22)), v32 = w1 * (v2 * (T14 * T21 - T24 * T11)),
        v33 = w1 * (v2 * (T14 * T11 + T24 * T21));
    const dhgen_four v34 = e1 * (v27 * v32 - s4 * (s23 * T31 - e1 * (c23 * v33)));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((v21 <= m5) |
        (v26 <= m6))) | (unsigned)((v1 <= m1) | (fabs(D3_squared) <= m3)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-T24, -v5, -T24, -T24),
        dhgen_four_of(-T14, v7, -T14, -T14)), ratio2 = dhgen_ratio_four(S2, C2),
        ratio3 = dhgen_ratio_four(v28, -X4),
        ratio4 = dhgen_ratio_four(w4, c23 * T33 + e1 * (s23 * v24)),
        ratio5 = dhgen_ratio_four(v34, e1 * (v27 * v30 - s4 * (s23 * T32 - e1 * (c23 * v31))));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = dhgen_angle_four(ratio2),
        angle4 = dhgen_angle_four(ratio3), angle5 = dhgen_angle_four(ratio4),
        angle6 = dhgen_angle_four(ratio5);
    const dhgen_four q3_p = e3 * angle2 + v8 * (m2 * (1.0 - e3)), q4_m = angle4 - v29,
        q6_m = angle6 - dhgen_signed_four(DHGEN_HALF_TURN, v34),
        q1_p = v4 + (angle1 + v3 * (m2 * (e1 - 1.0)));

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, angle3, q3_p, angle4);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, angle5, angle6);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, angle3, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, -angle5, q6_m);
    const unsigned long long none1 = (dhgen_bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[3] = { 3, 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 1.111, 1.111, 1.111, 1.0, 1.0, 1.0 }, 1.1111111111111112, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 3, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, staubli_rx90_fk,
    staubli_rx90_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) staubli_rx90_##function
#include "dhgen/functions.h"

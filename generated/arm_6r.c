/* arm_6r: Arm with six revolute joints and a spherical wrist
 *
 * Inverse kinematics, generated from robots/arm_6r.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/arm_6r.yaml. The formulas and where they come from: arm_6r.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 5414216a0af071f2
 * SPDX-License-Identifier: MIT
 */
#include "arm_6r.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(ARM_6R_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(ARM_6R_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef ARM_6R_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.4, /* joint offset 1 [m] */
    a2 = 0.4, /* link length 2 [m] */
    d4 = 0.35, /* joint offset 4 [m] */
    d6 = 0.1, /* joint offset 6 [m] */
    free_limit1 = 1.25e-12, /* a length that fixes no angle [m] */
    longest3 = 0.5625, /* square of the longest reach [m^2] */
    shortest3 = 0.0025000000000000044, /* square of the shortest reach [m^2] */
    longest3_reach = 0.5625000000001875, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.002499999999987505, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.5624999999999812, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.0025000000000012543, /* the shortest, where branches merge [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.27999999999999997, /* 2 * d4 * a2 [m^2] */
    k2 = 0.28250000000000003, /* a2^2 + d4^2 [m^2] */
    k3 = 12.755102040816327; /* 1 / (k1^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const arm_6r_branches[8] = {
    "back-down-noflip", "back-down-flip", "back-up-noflip", "back-up-flip", "front-up-noflip",
    "front-up-flip", "front-down-noflip", "front-down-flip",
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

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.4, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.4, 0.0 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.35, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.1, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void arm_6r_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, v4 = v1 * c3 + x2_x * s3,
        v5 = v2 * c3 + x2_y * s3, z3_z = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + s1 * s4,
        x4_y = x3_y * c4 - c1 * s4, v6 = v3 * c4, y5_x = s1 * c4 - x3_x * s4,
        z4_y = c1 * c4 + x3_y * s4, y5_z = v3 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v4 * s5,
        x5_y = x4_y * c5 - v5 * s5, x5_z = z3_z * s5 - v6 * c5, v7 = v4 * c5 + x4_x * s5,
        v8 = v5 * c5 + x4_y * s5, z5_z = z3_z * c5 + v6 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + y5_x * s6; T[1] = y5_x * c6 - x5_x * s6; T[2] = -v7;
    T[3] = x2_x * a2 - v4 * d4 - v7 * d6;
    T[4] = x5_y * c6 - z4_y * s6; T[5] = -(z4_y * c6 + x5_y * s6); T[6] = -v8;
    T[7] = x2_y * a2 - v5 * d4 - v8 * d6;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = y5_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 - s2 * a2 + z3_z * d4 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void arm_6r_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 - s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, v4 = v1 * c3 + x2_x * s3,
        v5 = v2 * c3 + x2_y * s3, z3_z = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_y = c1 * c4 + x3_y * s4, y5_z = v3 * s4,
        p4_x = p2_x - v4 * d4, p4_y = p2_y - v5 * d4, p4_z = p2_z + z3_z * d4,
        z4_x = x3_x * s4 - s1 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), v6 = v4 * c5 + (x3_x * c4 + s1 * s4) * s5,
        v7 = v5 * c5 + (x3_y * c4 - c1 * s4) * s5, z5_z = z3_z * c5 + v3 * c4 * s5,
        p6_x = p4_x - v6 * d6, p6_y = p4_y - v7 * d6, p6_z = p4_z + z5_z * d6, v8 = p6_z - d1,
        v9 = p6_x - p2_x, v10 = p6_y - p2_y, v11 = p6_z - p2_z, v12 = p6_x - p4_x,
        v13 = p6_y - p4_y, v14 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = c1 * v8; J[2] = c1 * v11; J[3] = -(v5 * v11 + z3_z * v10);
    J[4] = z4_y * v14 + y5_z * v13; J[5] = -(v7 * v14 + z5_z * v13);
    J[6] = p6_x; J[7] = s1 * v8; J[8] = s1 * v11; J[9] = z3_z * v9 + v4 * v11;
    J[10] = -(y5_z * v12 + z4_x * v14); J[11] = z5_z * v12 + v6 * v14;
    J[12] = 0.0; J[13] = -(s1 * p6_y + c1 * p6_x); J[14] = -(s1 * v10 + c1 * v9);
    J[15] = v5 * v9 - v4 * v10; J[16] = z4_x * v13 - z4_y * v12; J[17] = v7 * v12 - v6 * v13;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = -v4; J[22] = z4_x; J[23] = -v6;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = -v5; J[28] = z4_y; J[29] = -v7;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = -y5_z; J[35] = z5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1 A6^-1 [3, 4] */
    const double wx = T14 - T13 * d6;
    const double Y1 = d6 * T23 - T24;
    const double w1 = sqrt(wx * wx + Y1 * Y1);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = T34 - d6 * T33;
    const double Z1_3 = wz - d1;
    const double v1 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(wx * factor1),
            s1 = free1 ? sin(seed[0]) : Y1 * factor1;
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

        /* theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4] */
        const double Y1_2 = a2 + d4 * v2;
        const double v4 = Z1_3 * Y1_2, v5 = D1 * Y1_2;

        /* theta4, type 2: U4[3, 3] */
        const double v7 = T13 * c1 + T23 * s1;
        const double Y4 = T13 * s1 - T23 * c1;
        const double v8 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v9 = T22 * c1 - T12 * s1, v10 = T12 * c1 + T22 * s1, v12 = T21 * c1 - T11 * s1,
            v13 = T11 * c1 + T21 * s1;

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

            /* theta4 */
            const double c23 = c3 * c2 + v2 * s2, s23 = c3 * s2 - v2 * c2;
            const double X4 = T33 * s23 - c23 * v7;
            const double w4 = sqrt(X4 * X4 + v8);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta6 */
            const double v11 = c23 * v10 - T32 * s23, v14 = c23 * v13 - T31 * s23;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);

                /* theta5, type 3: U4[2, 3] and U4[1, 3] */
                const double q5 = atan2(-(w4 * e4), -(T33 * c23 + s23 * v7));

                /* theta6 */
                const double q6 = atan2(-(c4 * v12 + s4 * v14), -(c4 * v9 + s4 * v11));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef ARM_6R_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.000125 [m], doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 1.5625e-08, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 1.050715070505213e-11,
    m4 = 1.2499999999999998, /* d4 * k1 * k3 [m^-1] */
    m5 = 0.04687500000000003, /* a2 - d4 * k1 * k2 * k3 [m] */
    m6 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide wx = T14 - d6 * T13, Y1 = d6 * T23 - T24, v1 = wx * wx + Y1 * Y1,
        w1 = dhgen_sqrt_wide(v1), v2 = DHGEN_QUOTIENT(1.0, v1), angle1 = dhgen_atan2_wide(Y1, -wx);

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d6 * T33 - d1, N3 = v1 + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_wide(D3_squared),
        v3 = w3 - w3, v4 = k1 * (N3 - k2), v5 = k3 * v4, v6 = k1 * w3, c3 = k3 * v6,
        angle2 = dhgen_atan2_wide(-v4, v6),
        q3_pmp = dhgen_signed_wide(DHGEN_HALF_TURN, -v4) - angle2;

    /* theta2 */
    const dhgen_wide v7 = d4 * c3, Y1_2 = a2 + d4 * v5, v8 = Z1_3 * Y1_2, v9 = w1 * v7,
        v10 = v9 - v8, v11 = v8 + v9, v12 = m5 + m4 * N3, v13 = Z1_3 * v12, v14 = w3 * (m4 * w1),
        S2_pp = v14 - v13, v15 = v13 + v14, v16 = w1 * Y1_2, v17 = Z1_3 * v7, v18 = v16 + v17,
        v19 = v16 - v17, v20 = w3 * (m4 * Z1_3), v21 = w3 * (m4 * -Z1_3), v22 = w1 * v12,
        v23 = v20 + v22, v24 = v21 + v22, v25 = v20 - v22, v26 = v21 - v22, v27 = S2_pp * S2_pp,
        v28 = v27 + v23 * v23, v29 = v15 * v15, v30 = v29 + v24 * v24, v31 = v29 + v25 * v25,
        v32 = v27 + v26 * v26, w2_pp = dhgen_sqrt_wide(v28), w2_pm = dhgen_sqrt_wide(v30),
        w2_mp = dhgen_sqrt_wide(v31), w2_mm = dhgen_sqrt_wide(v32), v33 = DHGEN_QUOTIENT(1.0, v28),
        v34 = DHGEN_QUOTIENT(1.0, v30), v35 = DHGEN_QUOTIENT(1.0, v31),
        v36 = DHGEN_QUOTIENT(1.0, v32), angle3 = dhgen_atan2_wide(S2_pp, -v23),
        angle4 = dhgen_atan2_wide(-v15, -v24), angle5 = dhgen_atan2_wide(-v15, -v25),
        angle6 = dhgen_atan2_wide(S2_pp, -v26);

    /* theta4 */
    const dhgen_wide v37 = v5 * v10 - c3 * v18, c23_pp = w2_pp * (v33 * v37), v38 = v5 * v11,
        c23_pm = w2_pm * (v34 * (c3 * v19 - v38)), v39 = w2_mp * (v35 * (v38 + c3 * -v19)),
        c23_mm = w2_mm * (v36 * v37), v40 = c3 * v10 + v5 * v18, s23_pp = w2_pp * (v33 * v40),
        v41 = c3 * v11, s23_pm = w2_pm * (v34 * (v41 + v5 * v19)),
        s23_mp = w2_mp * (v35 * (v5 * -v19 - v41)), v42 = w2_mm * (v36 * v40),
        v43 = w1 * (v2 * (T23 * Y1 - T13 * wx)), X4_pp = T33 * s23_pp - c23_pp * v43,
        X4_pm = T33 * s23_pm - c23_pm * v43, X4_mp = T33 * s23_mp - v39 * v43,
        X4_mm = c23_mm * v43 - T33 * v42, Y4 = w1 * (v2 * (T13 * Y1 + wx * T23)), v44 = Y4 * Y4,
        v45 = v44 + X4_pp * X4_pp, v46 = v44 + X4_pm * X4_pm, v47 = v44 + X4_mp * X4_mp,
        v48 = v44 + X4_mm * X4_mm, angle7 = dhgen_atan2_wide(Y4, -X4_pp),
        angle8 = dhgen_atan2_wide(Y4, -X4_pm), angle9 = dhgen_atan2_wide(-Y4, -X4_mp),
        angle10 = dhgen_atan2_wide(-Y4, -X4_mm), v49 = dhgen_signed_wide(DHGEN_HALF_TURN, Y4),
        v50 = dhgen_signed_wide(DHGEN_HALF_TURN, -Y4);

    /* theta5 */
    const dhgen_wide angle11 = dhgen_atan2_wide(-dhgen_sqrt_wide(v45), -(T33 * c23_pp + s23_pp *
        v43)), angle12 = dhgen_atan2_wide(-dhgen_sqrt_wide(v46), -(T33 * c23_pm + s23_pm * v43)),
        angle13 = dhgen_atan2_wide(-dhgen_sqrt_wide(v47), T33 * v39 + s23_mp * v43),
        angle14 = dhgen_atan2_wide(-dhgen_sqrt_wide(v48), -(T33 * c23_mm + v42 * v43));

    /* theta6 */
    const dhgen_wide v51 = w1 * (v2 * (wx * T22 + Y1 * T12)),
        v52 = w1 * (v2 * (Y1 * T22 - wx * T12)), v53 = w1 * (v2 * (wx * T21 + Y1 * T11)),
        v54 = w1 * (v2 * (Y1 * T21 - wx * T11)),
        v55 = -X4_pp * v53 - Y4 * (c23_pp * v54 - s23_pp * T31),
        v56 = -X4_pm * v53 - Y4 * (c23_pm * v54 - s23_pm * T31),
        v57 = Y4 * (v39 * v54 - s23_mp * T31) + X4_mp * v53,
        v58 = Y4 * (v42 * T31 - c23_mm * v54) + X4_mm * v53,
        angle15 = dhgen_atan2_wide(v55, -X4_pp * v51 - Y4 * (c23_pp * v52 - s23_pp * T32)),
        angle16 = dhgen_atan2_wide(v56, -X4_pm * v51 - Y4 * (c23_pm * v52 - s23_pm * T32)),
        angle17 = dhgen_atan2_wide(v57, Y4 * (v39 * v52 - s23_mp * T32) + X4_mp * v51),
        angle18 = dhgen_atan2_wide(v58, Y4 * (v42 * T32 - c23_mm * v52) + X4_mm * v51);

    /* joint values */
    const dhgen_wide q1_ppp = angle1 + v3,
        q1_mpp = v3 + (angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, Y1));

    q[0] = q1_ppp; q[1] = angle3; q[2] = angle2; q[3] = angle7; q[4] = angle11; q[5] = angle15;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_ppp; q[7] = angle3; q[8] = angle2; q[9] = angle7 - v49; q[10] = -angle11;
    q[11] = angle15 - dhgen_signed_wide(DHGEN_HALF_TURN, v55);
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_ppp; q[13] = angle4; q[14] = q3_pmp; q[15] = angle8; q[16] = angle12;
    q[17] = angle16;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_ppp; q[19] = angle4; q[20] = q3_pmp; q[21] = angle8 - v49; q[22] = -angle12;
    q[23] = angle16 - dhgen_signed_wide(DHGEN_HALF_TURN, v56);
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = angle5; q[26] = angle2; q[27] = angle9; q[28] = angle13;
    q[29] = angle17;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = angle5; q[32] = angle2; q[33] = angle9 - v50; q[34] = -angle13;
    q[35] = angle17 - dhgen_signed_wide(DHGEN_HALF_TURN, v57);
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mpp; q[37] = angle6; q[38] = q3_pmp; q[39] = angle10; q[40] = angle14;
    q[41] = angle18;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mpp; q[43] = angle6; q[44] = q3_pmp; q[45] = angle10 - v50; q[46] = -angle14;
    q[47] = angle18 - dhgen_signed_wide(DHGEN_HALF_TURN, v58);
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D3_squared) <= m3) | (v1 <= m1) | (v48 <= m6) | (v47 <=
        m6) | (v45 <= m6) | (v46 <= m6));
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
    const double wx = T14 - d6 * T13, Y1 = d6 * T23 - T24, v1 = wx * wx + Y1 * Y1, w1 = sqrt(v1),
        v2 = DHGEN_QUOTIENT(1.0, v1), v3 = copysign(DHGEN_HALF_TURN, Y1);

    /* theta3 */
    const double Z1_3 = T34 - d6 * T33 - d1, N3 = v1 + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared), v4 = w3 - w3,
        v5 = k1 * (N3 - k2), v6 = k3 * v5, v7 = k1 * w3, c3 = k3 * v7,
        v8 = copysign(DHGEN_HALF_TURN, -v5);

    /* theta2 */
    const double v9 = d4 * c3, Y1_2 = a2 + d4 * v6, v10 = Z1_3 * Y1_2, v11 = w1 * v9;
    const dhgen_four v12 = e1 * e3, v13 = v11 * v12 - v10;
    const double v14 = m5 + m4 * N3, v15 = Z1_3 * v14;
    const dhgen_four S2 = w3 * (m4 * (w1 * v12)) - v15;
    const double v16 = w1 * Y1_2, v17 = Z1_3 * v9;
    const dhgen_four v18 = e3 * v17, v19 = e1 * v16, v20 = v18 + v19, v21 = w3 * (m4 * (e3 * Z1_3)),
        v22 = w1 * (e1 * v14), v23 = v21 + v22, v24 = S2 * S2 + v23 * v23,
        w2 = dhgen_sqrt_four(v24), v25 = DHGEN_QUOTIENT(1.0, v24);

    /* theta4 */
    const dhgen_four v26 = e3 * c3, c23 = w2 * (v25 * (v6 * v13 - v20 * v26)),
        s23 = w2 * (v25 * (v13 * v26 + v6 * v20));
    const double v27 = w1 * (v2 * (T23 * Y1 - T13 * wx));
    const dhgen_four X4 = T33 * s23 - e1 * (c23 * v27);
    const double Y4 = w1 * (v2 * (T13 * Y1 + wx * T23)), v28 = Y4 * Y4;
    const dhgen_four v29 = v28 + X4 * X4, v30 = e1 * Y4,
        v31 = dhgen_signed_four(DHGEN_HALF_TURN, v30);

    /* theta6 */
    const double v32 = w1 * (v2 * (wx * T22 + Y1 * T12)), v33 = w1 * (v2 * (Y1 * T22 - wx * T12)),
        v34 = w1 * (v2 * (wx * T21 + Y1 * T11)), v35 = w1 * (v2 * (Y1 * T21 - wx * T11));
    const dhgen_four v36 = e1 * (-X4 * v34 - Y4 * (e1 * (c23 * v35) - s23 * T31));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | (v29 <= m6)) |
        (unsigned)((v1 <= m1) | (fabs(D3_squared) <= m3)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(Y1, -v5, Y1, Y1),
        dhgen_four_of(-wx, v7, -wx, -wx)), ratio2 = dhgen_ratio_four(S2, -v23),
        ratio3 = dhgen_ratio_four(v30, -X4),
        ratio4 = dhgen_ratio_four(v36, e1 * (-X4 * v32 - Y4 * (e1 * (c23 * v33) - s23 * T32))),
        ratio5 = dhgen_ratio_four(-dhgen_sqrt_four(v29), -(T33 * c23 + e1 * (s23 * v27)));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = dhgen_angle_four(ratio2),
        angle4 = dhgen_angle_four(ratio3), angle6 = dhgen_angle_four(ratio4),
        angle5 = dhgen_angle_four(ratio5);
    const dhgen_four q3_p = e3 * angle2 + v8 * (m2 * (1.0 - e3)), q4_m = angle4 - v31,
        q6_m = angle6 - dhgen_signed_four(DHGEN_HALF_TURN, v36),
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
DHGEN_TABLE int choosable[2] = { 3, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.8, 0.8, 0.8, 1.0, 1.0, 1.0 }, 0.8, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, arm_6r_fk,
    arm_6r_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) arm_6r_##function
#include "dhgen/functions.h"

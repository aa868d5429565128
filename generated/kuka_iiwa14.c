/* kuka_iiwa14: KUKA LBR iiwa 14 R820
 *
 * Inverse kinematics, generated from robots/kuka_iiwa14.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_iiwa14.yaml. The formulas and where they come from:
 * kuka_iiwa14.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 7f9271a70e3d8ac9
 * SPDX-License-Identifier: MIT
 */
#include "kuka_iiwa14.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KUKA_IIWA14_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KUKA_IIWA14_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 7
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef KUKA_IIWA14_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, arm_size2 = 1.7056360000000002 [m^2]. */
static const double
    d1 = 0.36, /* joint offset 1 [m] */
    d3 = 0.42, /* joint offset 3 [m] */
    d5 = 0.4, /* joint offset 5 [m] */
    d7 = 0.126, /* joint offset 7 [m] */
    longest4 = 0.6724000000000001, /* square of the longest reach [m^2] */
    shortest4 = 0.0003999999999999985, /* square of the shortest reach [m^2] */
    longest4_reach = 0.6724000000002143, /* the longest, with what rounding adds [m^2] */
    shortest4_reach = 0.0003999999999947745, /* the shortest, with what rounding adds [m^2] */
    longest4_apart = 0.6723999999999786, /* the longest, where branches merge [m^2] */
    shortest4_apart = 0.00040000000000052087, /* the shortest, where branches merge [m^2] */
    least_root2 = 5.393694619178955e-07, /* a root of nothing, by rounding [m^2] */
    free_limit_squared2 = 1.705636e-24, /* square of a length that fixes no angle [m^2] */
    reach_slack1 = 1.3060000000000002e-13, /* rounding at the boundary of the workspace [m] */
    merge_slack1 = 1.306e-14, /* nearer to that boundary two branches are one [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    offset2 = 3.141592653589793, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset6 = 3.141592653589793, /* offset of joint 6 [rad] */
    k1 = 0.336, /* 2 * d5 * d3 [m^2] */
    k2 = 0.33640000000000003, /* d3^2 + d5^2 [m^2] */
    k3 = 0.5862915651405106, /* 1 / arm_size2 [m^-2] */
    k4 = 8.857709750566894; /* 1 / (k1^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const kuka_iiwa14_branches[8] = {
    "elbow+-shoulder+-noflip", "elbow+-shoulder+-flip", "elbow+-shoulder--noflip",
    "elbow+-shoulder--flip", "elbow--shoulder+-noflip", "elbow--shoulder+-flip",
    "elbow--shoulder--noflip", "elbow--shoulder--flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[7] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.0943951023931953, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 0.0, 0.09817477042468103, 1 },
    { -2.0943951023931953, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.0943951023931953, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.0543261909900767, 3.0543261909900767, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* What follows from joint values: what the pose and the Jacobian are made of. */
#define MOTION \
    const double v1 = q[0] + offset1, c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2, \
        c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2, \
        z2_y = s1 * s2, c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + s1 * s3, \
        x3_y = x2_y * c3 - c1 * s3, x3_z = s2 * c3, z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3, \
        z3_x = x2_x * s3 - s1 * c3, v3 = q[3] + offset4, c4 = cos(v3), s4 = sin(v3), \
        x4_x = x3_x * c4 + z2_x * s4, x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - c2 * s4, \
        z4_z = c2 * c4 + x3_z * s4, z4_x = x3_x * s4 - z2_x * c4, z4_y = x3_y * s4 - z2_y * c4, \
        c5 = cos(q[4]), s5 = sin(q[4]), z5_x = x4_x * s5 - z3_x * c5, \
        z5_y = x4_y * s5 - z3_y * c5, z5_z = x4_z * s5 - z3_z * c5, v4 = q[5] + offset6, \
        c6 = cos(v4), s6 = sin(v4)

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[7][4] = {
    { 3.141592653589793, 0.36, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.42, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.4, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.126, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 7, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 9

DHGEN_PUBLIC void kuka_iiwa14_fk(const double q[7], double T[16])
{
    MOTION;
    const double x5_x = x4_x * c5 + z3_x * s5, x5_y = x4_y * c5 + z3_y * s5,
        x5_z = x4_z * c5 + z3_z * s5, x6_x = x5_x * c6 + z4_x * s6, x6_y = x5_y * c6 + z4_y * s6,
        x6_z = x5_z * c6 + z4_z * s6, z6_x = x5_x * s6 - z4_x * c6, z6_y = x5_y * s6 - z4_y * c6,
        z6_z = x5_z * s6 - z4_z * c6;
    const double c7 = cos(q[6]), s7 = sin(q[6]);
    T[0] = x6_x * c7 + z5_x * s7; T[1] = z5_x * c7 - x6_x * s7; T[2] = z6_x;
    T[3] = z2_x * d3 + z4_x * d5 + z6_x * d7;
    T[4] = x6_y * c7 + z5_y * s7; T[5] = z5_y * c7 - x6_y * s7; T[6] = z6_y;
    T[7] = z2_y * d3 + z4_y * d5 + z6_y * d7;
    T[8] = x6_z * c7 + z5_z * s7; T[9] = z5_z * c7 - x6_z * s7; T[10] = z6_z;
    T[11] = d1 - c2 * d3 + z4_z * d5 + z6_z * d7;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void kuka_iiwa14_jacobian(const double q[7], double J[42])
{
    MOTION;
    const double p3_x = z2_x * d3, p3_y = z2_y * d3, p3_z = d1 - c2 * d3, p5_x = p3_x + z4_x * d5,
        p5_y = p3_y + z4_y * d5, p5_z = p3_z + z4_z * d5,
        z6_x = (x4_x * c5 + z3_x * s5) * s6 - z4_x * c6,
        z6_y = (x4_y * c5 + z3_y * s5) * s6 - z4_y * c6,
        z6_z = (x4_z * c5 + z3_z * s5) * s6 - z4_z * c6, p7_x = p5_x + z6_x * d7,
        p7_y = p5_y + z6_y * d7, p7_z = p5_z + z6_z * d7, v5 = p7_z - d1, v6 = p7_x - p3_x,
        v7 = p7_y - p3_y, v8 = p7_z - p3_z, v9 = p7_x - p5_x, v10 = p7_y - p5_y, v11 = p7_z - p5_z;
    J[0] = -p7_y; J[1] = -(c1 * v5); J[2] = z2_y * v5 + c2 * p7_y; J[3] = z3_y * v8 - z3_z * v7;
    J[4] = z4_y * v8 - z4_z * v7; J[5] = z5_y * v11 - z5_z * v10; J[6] = z6_y * v11 - z6_z * v10;
    J[7] = p7_x; J[8] = -(s1 * v5); J[9] = -(c2 * p7_x + z2_x * v5); J[10] = z3_z * v6 - z3_x * v8;
    J[11] = z4_z * v6 - z4_x * v8; J[12] = z5_z * v9 - z5_x * v11; J[13] = z6_z * v9 - z6_x * v11;
    J[14] = 0.0; J[15] = s1 * p7_y + c1 * p7_x; J[16] = z2_x * p7_y - z2_y * p7_x;
    J[17] = z3_x * v7 - z3_y * v6; J[18] = z4_x * v7 - z4_y * v6; J[19] = z5_x * v10 - z5_y * v9;
    J[20] = z6_x * v10 - z6_y * v9;
    J[21] = 0.0; J[22] = s1; J[23] = z2_x; J[24] = z3_x; J[25] = z4_x; J[26] = z5_x; J[27] = z6_x;
    J[28] = 0.0; J[29] = -c1; J[30] = z2_y; J[31] = z3_y; J[32] = z4_y; J[33] = z5_y; J[34] = z6_y;
    J[35] = 1.0; J[36] = 0.0; J[37] = -c2; J[38] = z3_z; J[39] = z4_z; J[40] = z5_z; J[41] = z6_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[7] = (double (*)[7])rows;
    (void)moved;
    DHGEN_ENTRIES(double);

    const double c3 = cos(free_joints[0]), s3 = sin(free_joints[0]);

    /* theta4, type 2: the squared length of column 4 of U1 A7^-1 */
    const double wx = T14 - T13 * d7;
    const double wy = T24 - d7 * T23;
    const double v1 = wy * wy;
    const double wz = T34 - d7 * T33;
    const double Z1_2 = wz - d1;
    const double V4 = wx * wx + v1 + Z1_2 * Z1_2;
    const double Z4 = V4 - k2;
    const double D4_squared = (longest4 - V4) * (V4 - shortest4);
    const int apart4 = shortest4_apart < V4 && V4 < longest4_apart;
    if (!(shortest4_reach <= V4 && V4 <= longest4_reach)) return; /* out of reach */
    const double w4 = sqrt(apart4 ? D4_squared : 0.0);
    const double v2 = (apart4 ? w4 : least_root2) * k3, v3 = k4 * (k1 * Z4);

    /* theta1, type 2: U1 A7^-1 [3, 4] */
    const double N1 = v1 + -wx * -wx;
    const int free1 = N1 <= free_limit_squared2;
    const double v7 = sqrt(N1), v10 = seed[0] + offset1;

    /* theta2, type 3: U1 A7^-1 [2, 4] and U1 A7^-1 [1, 4] */
    const double X2_2 = d3 + d5 * v3;
    const double v13 = Z1_2 * X2_2, v15 = seed[1] + offset2;

    /* theta5, type 2: U5[3, 3] */
    const double v16 = c3 * T13, v17 = v3 * v16, v18 = c3 * T23, v19 = v3 * v18, v23 = c3 * T33,
        v24 = v3 * v23, v27 = s3 * T33;

    /* theta6, type 3: U5[2, 3] and U5[1, 3] */
    const double v30 = T33 * v3, v31 = T13 * v3, v32 = T23 * v3;

    /* theta7, type 3: U5[3, 2] and U5[3, 1] */
    const double v34 = s3 * T32, v37 = v3 * (c3 * T12), v38 = v3 * (c3 * T22),
        v42 = v3 * (c3 * T32), v44 = s3 * T31, v47 = v3 * (c3 * T11), v48 = v3 * (c3 * T21),
        v52 = v3 * (c3 * T31);

    for (int i1 = 0; i1 < 2; i1++) { /* elbow+, elbow- */
        const double e4 = i1 == 0 ? 1.0 : -1.0;
        /* theta4 */
        if (e4 < 0.0 && !apart4) continue; /* both signs give the same */
        const double v4 = k4 * (k1 * (w4 * e4));

        /* theta1 */
        const double Z1 = d5 * (s3 * v4);
        const double D1_squared = N1 - Z1 * Z1;
        const double v5 = fabs(Z1), v6 = 2.0 * v5;
        const int apart1 = merge_slack1 * (v6 + merge_slack1) < D1_squared;
        if (!(-(reach_slack1 * (v6 + reach_slack1)) < v2 * D1_squared)) continue; /* out of reach */
        const double w1 = sqrt(apart1 ? D1_squared : 0.0);
        const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : v5 * v7));
        const double v8 = -wx * Z1, v9 = wy * Z1;

        /* theta2 */
        const double v11 = d5 * (c3 * v4), v12 = Z1_2 * v11;

        /* theta5 */
        const double v20 = T33 * v4, v21 = T13 * v4, v22 = T23 * v4;

        /* theta6 */
        const double v28 = v4 * v16, v29 = v4 * v18, v33 = v4 * v23;

        /* theta7 */
        const double v39 = T32 * v4, v40 = T12 * v4, v41 = T22 * v4, v49 = T31 * v4, v50 = T11 * v4,
            v51 = T21 * v4;

        /* joint values */
        const double q4 = dhgen_wrap(atan2(-v4, -v3) - offset4);

        for (int i2 = 0; i2 < 2; i2++) { /* shoulder+, shoulder- */
            const double e1 = i2 == 0 ? 1.0 : -1.0;
            /* theta1 */
            if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
            const double D1 = w1 * e1;
            const double c1 = free1 ? cos(v10) : inverse1 * (v9 - -wx * D1),
                s1 = free1 ? sin(v10) : inverse1 * (v8 + wy * D1);

            /* theta2 */
            const double S2 = D1 * X2_2 - v12;
            const double v14 = D1 * v11 + v13;
            const double w2 = sqrt(S2 * S2 + v14 * v14);
            const int free2 = w2 <= free_limit_squared2;
            const double factor2 = 1.0 / (free2 ? 1.0 : w2);
            const double c2 = free2 ? cos(v15) : -(v14 * factor2),
                s2 = free2 ? sin(v15) : S2 * factor2;

            /* theta5 */
            const double v25 = T13 * s1 - T23 * c1, v26 = s3 * v25;
            const double X5 = v3 * v26 - (c2 * (v20 - (c1 * v17 + s1 * v19)) - s2 * (c1 * v21 + s1 *
                v22 + v24));
            const double Y5 = c2 * (s3 * (T13 * c1 + T23 * s1)) + s2 * v27 - c3 * v25;
            const double w5 = sqrt(X5 * X5 + Y5 * Y5);
            const int free5 = w5 <= free_limit;
            const double divisor5 = free5 ? 1.0 : w5;

            /* theta6 */
            const double c6 = v4 * v26 - (s2 * (c1 * v31 + s1 * v32 - v33) - c2 * (c1 * v28 + s1 *
                v29 + v30));

            /* theta7 */
            const double v35 = T12 * s1 - T22 * c1,
                v36 = c3 * v35 - (c2 * (s3 * (T12 * c1 + T22 * s1)) + s2 * v34),
                v43 = c2 * (v39 - (c1 * v37 + s1 * v38)) - s2 * (c1 * v40 + s1 * v41 + v42) - v3 *
                    (s3 * v35), v45 = T11 * s1 - T21 * c1,
                v46 = c3 * v45 - (c2 * (s3 * (T11 * c1 + T21 * s1)) + s2 * v44),
                v53 = c2 * (v49 - (c1 * v47 + s1 * v48)) - s2 * (c1 * v50 + s1 * v51 + v52) - v3 *
                    (s3 * v45);

            /* joint values */
            const double q1 = dhgen_wrap(atan2(s1, c1) - offset1);
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e5 = i3 == 0 ? 1.0 : -1.0;
                /* theta5 */
                if (e5 < 0.0 && free5) continue; /* both signs give the same */
                const double factor5 = e5 / divisor5;
                const double c5 = free5 ? cos(seed[4]) : -(X5 * factor5),
                    s5 = free5 ? sin(seed[4]) : Y5 * factor5;
                const double q5 = atan2(s5, c5);
                const double s6 = w5 * e5;

                /* theta7 */
                const double c7 = c5 * v36 + s5 * v43, s7 = c5 * v46 + s5 * v53;
                const double q7 = atan2(s7, c7);

                /* joint values */
                const double q6 = dhgen_wrap(atan2(s6, c6) - offset6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = free_joints[0]; q[row][3] = q4;
                q[row][4] = q5; q[row][5] = q6; q[row][6] = q7;
                status[row] = (free1 || free2 || free5) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef KUKA_IIWA14_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    doubt_limit_squared2 = 1.705636e-08, /* square of a length that fixes no angle [m^2] */
    /* 1000 * (longest4 - longest4_apart) * (longest4_apart - shortest4) [m^4] */
    m1 = 1.4473755527432779e-11,
    m2 = 1.306e-11, /* 1000 * merge_slack1 [m] */
    m3 = 2.909194164496e-16, /* doubt_limit_squared2^2 [m^4] */
    m4 = 9.999999999999999e-09; /* doubt_limit^2 */

/* What one pose and many compute alike: values without signs of branches, with the first, with
 * all that are in lanes. */
#define KNOWN(number) \
    const dhgen_##number c3 = dhgen_cos_##number(free_joints[0]), \
        s3 = dhgen_sin_##number(free_joints[0]); \
    /* theta4 */ \
    const dhgen_##number wx = T14 - d7 * T13, wy = T24 - d7 * T23, v1 = wy * wy, \
        Z1_2 = T34 - d7 * T33 - d1, V4 = v1 + wx * wx + Z1_2 * Z1_2, \
        D4_squared = (longest4 - V4) * (V4 - shortest4), w4 = dhgen_sqrt_##number(D4_squared), \
        v2 = k1 * (V4 - k2), v3 = k4 * v2, v4 = k1 * w4, v5 = k4 * v4; \
    /* theta1 */ \
    const dhgen_##number N1 = v1 - wx * -wx, Z1 = d5 * (s3 * v5), D1_squared = N1 - Z1 * Z1, \
        w1 = dhgen_sqrt_##number(D1_squared), v6 = w1 - w1, inverse1 = DHGEN_QUOTIENT(1.0, N1), \
        v7 = -wx * Z1, v8 = wy * Z1; \
    /* theta2 */ \
    const dhgen_##number v15 = d5 * (c3 * v5), X2_2 = d3 + d5 * v3, v16 = Z1_2 * v15, \
        v17 = w1 * X2_2, v20 = Z1_2 * X2_2, v21 = w1 * v15; \
    /* theta5 */ \
    const dhgen_##number v24 = c3 * T13, v25 = v3 * v24, v26 = c3 * T23, v27 = v3 * v26, \
        v28 = T33 * v5, v29 = T13 * v5, v30 = T23 * v5, v31 = c3 * T33, v32 = v3 * v31, \
        v33 = T13 * wy + T23 * -wx, v38 = s3 * T33; \
    /* theta6 */ \
    const dhgen_##number v40 = v5 * v24, v41 = v5 * v26, v42 = T33 * v3, v43 = T13 * v3, \
        v44 = T23 * v3, v45 = v5 * v31; \
    /* theta7 */ \
    const dhgen_##number v47 = s3 * T32, v49 = v3 * (c3 * T12), v50 = v3 * (c3 * T22), \
        v51 = v5 * T32, v52 = v5 * T12, v53 = v5 * T22, v54 = v3 * (c3 * T32), v56 = s3 * T31, \
        v58 = v3 * (c3 * T11), v59 = v3 * (c3 * T21), v60 = v5 * T31, v61 = v5 * T11, \
        v62 = v5 * T21, v63 = v3 * (c3 * T31); \
    /* joint values */ \
    const dhgen_##number q3_p = v6 + (free_joints[0] + (w4 - w4))
#define SIGNED(number, signs) \
    /* theta1 */ \
    const dhgen_##number v9 = e4 * v8, v11 = inverse1 * v9, v12 = e4 * v7, v14 = inverse1 * v12; \
    /* theta2 */ \
    const dhgen_##number v19 = e4 * v16; \
    /* theta5 */ \
    const dhgen_##number v35 = inverse1 * (s3 * (T13 * v12 - T23 * v9)), v37 = e4 * v28; \
    /* theta6 */ \
    const dhgen_##number v46 = e4 * v45; \
    /* theta7 */ \
    const dhgen_##number v55 = e4 * v51, v64 = e4 * v60
#define SIGNED_TWICE(number, signs) \
    /* theta1 */ \
    const dhgen_##number v10 = w1 * (inverse1 * (e1 * -wx)), c1 = v11 - v10, \
        v13 = w1 * (inverse1 * (e1 * wy)), s1 = v13 + v14; \
    /* theta2 */ \
    const dhgen_##number v18 = e1 * v17, S2 = v18 - v19, v22 = v20 + v21 * (e4 * e1), \
        v23 = S2 * S2 + v22 * v22, factor2 = dhgen_sqrt_##number(v23) * DHGEN_QUOTIENT(1.0, v23); \
    /* theta5 */ \
    const dhgen_##number v34 = w1 * (inverse1 * (s3 * (e1 * v33))), v36 = v34 + v35, \
        X5 = v3 * v36 + factor2 * (v22 * (v37 - (c1 * v25 + s1 * v27)) + S2 * (v32 + e4 * (c1 * \
            v29 + s1 * v30))), \
        Y5 = factor2 * (S2 * v38 - v22 * (s3 * (T13 * c1 + T23 * s1))) - c3 * (T13 * s1 - T23 * \
            c1), v39 = X5 * X5 + Y5 * Y5; \
    /* theta7 */ \
    const dhgen_##number v48 = s1 * T12 - c1 * T22, v57 = s1 * T11 - c1 * T21

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    DHGEN_ENTRIES(dhgen_wide);
    dhgen_wide_mask left = (dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11] + free_joints[0])
        <= DHGEN_ORTHONORMAL) == 0;
    KNOWN(wide);

    /* joint values */
    const dhgen_wide angle5 = dhgen_atan2_wide(-v4, -v2);
    left |= (N1 <= doubt_limit_squared2) | (dhgen_abs_wide(D4_squared) <= m1) | (0.0 <
        dhgen_exceeds_wide(free_joints[0], joints + 2)) | (dhgen_abs_wide(D1_squared * (k3 * w4)) <=
        m2 * (merge_slack1 + 2.0 * dhgen_abs_wide(Z1)));

    DHGEN_UNROLLED for (int i1 = 0; i1 < 2; i1++) { /* elbow+, elbow- */
        const double e4 = i1 == 0 ? 1.0 : -1.0;
        SIGNED(wide, double);

        /* joint values */
        const dhgen_wide v67 = e4 * angle5 - offset4, q4_ = dhgen_raised_wide(v67),
            v70 = dhgen_exceeds_wide(q4_, joints + 3), q4_p = v6 + q4_;

        DHGEN_UNROLLED for (int i2 = 0; i2 < 2; i2++) { /* shoulder+, shoulder- */
            const double e1 = i2 == 0 ? 1.0 : -1.0;
            SIGNED_TWICE(wide, double);

            /* theta5 */
            const dhgen_wide angle1 = dhgen_atan2_wide(Y5, -X5),
                q5_m = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, Y5);

            /* theta7 */
            const dhgen_wide angle2 = dhgen_atan2_wide(-(X5 * (c3 * v57 - factor2 * (S2 * v56 - v22
                * (s3 * (c1 * T11 + s1 * T21)))) + Y5 * (v3 * (s3 * v57) + factor2 * (v22 * (v64 -
                (c1 * v58 + s1 * v59)) + S2 * (v63 + e4 * (c1 * v61 + s1 * v62))))), -(X5 * (c3 *
                v48 - factor2 * (S2 * v47 - v22 * (s3 * (c1 * T12 + s1 * T22)))) + Y5 * (v3 * (s3 *
                v48) + factor2 * (v22 * (v55 - (c1 * v49 + s1 * v50)) + S2 * (v54 + e4 * (c1 * v52 +
                s1 * v53)))))),
                q7_m = angle2 - dhgen_signed_wide(DHGEN_HALF_TURN, -(X5 * (c3 * v57 - factor2 * (S2
                    * v56 - v22 * (s3 * (c1 * T11 + s1 * T21)))) + Y5 * (v3 * (s3 * v57) + factor2 *
                    (v22 * (v64 - (c1 * v58 + s1 * v59)) + S2 * (v63 + e4 * (c1 * v61 + s1 *
                    v62))))));

            /* joint values */
            const dhgen_wide angle3 = dhgen_atan2_wide(s1, c1), v65 = angle3 - offset1,
                q1_p = dhgen_raised_wide(v65), angle4 = dhgen_atan2_wide(S2, -v22),
                v66 = angle4 - offset2, q2_p = dhgen_raised_wide(v66),
                angle6 = dhgen_atan2_wide(dhgen_sqrt_wide(v39), e4 * (v5 * v36) - factor2 * (S2 *
                    (c1 * v43 + s1 * v44 - v46) + v22 * (v42 + e4 * (c1 * v40 + s1 * v41)))),
                v68 = angle6 - offset6, v69 = offset6 + angle6, q6_p = dhgen_raised_wide(v68),
                q6_m = dhgen_only_wide(-v69 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v69,
                v71 = dhgen_maximum_wide(dhgen_exceeds_wide(q2_p, joints + 1),
                    dhgen_maximum_wide(v70, dhgen_exceeds_wide(q1_p, joints))),
                excess_p = dhgen_maximum_wide(dhgen_exceeds_wide(angle2, joints + 6),
                    dhgen_maximum_wide(dhgen_exceeds_wide(q6_p, joints + 5), dhgen_maximum_wide(v71,
                    dhgen_exceeds_wide(angle1, joints + 4)))),
                excess_m = dhgen_maximum_wide(dhgen_exceeds_wide(q7_m, joints + 6),
                    dhgen_maximum_wide(dhgen_exceeds_wide(q6_m, joints + 5), dhgen_maximum_wide(v71,
                    dhgen_exceeds_wide(q5_m, joints + 4))));
            const int row = 4 * i1 + 2 * i2;
            q[7 * row] = q1_p; q[7 * row + 1] = q2_p; q[7 * row + 2] = q3_p; q[7 * row + 3] = q4_p;
            q[7 * row + 4] = angle1; q[7 * row + 5] = q6_p; q[7 * row + 6] = angle2;
            kind[row] = dhgen_kind_within_wide(q[7 * row], 0.0 < excess_p);
            q[7 * row + 7] = q1_p; q[7 * row + 8] = q2_p; q[7 * row + 9] = q3_p;
            q[7 * row + 10] = q4_p; q[7 * row + 11] = q5_m; q[7 * row + 12] = q6_m;
            q[7 * row + 13] = q7_m;
            kind[row + 1] = dhgen_kind_within_wide(q[7 * row + 7], 0.0 < excess_m);
            left |= (v23 <= m3) | (v39 <= m4);
            left |= dhgen_within_slack_wide(excess_p) | dhgen_within_slack_wide(excess_m);
        }
    }
    return left;
}

#if DHGEN_LANES > 1
/* One regular pose, two signs in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    const dhgen_four e4 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e1 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);
    KNOWN(double);
    SIGNED(four, four);
    SIGNED_TWICE(four, four);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) + 0.0 * (free_joints[0]) <= DHGEN_ORTHONORMAL)
        == 0) | ((v23 <= m3) | (v39 <= m4))) | (unsigned)((N1 <= doubt_limit_squared2) |
        (fabs(D4_squared) <= m1) | (0.0 < fabs(free_joints[0]) - dhgen_high(joints + 2)) |
        (fabs(D1_squared * (k3 * w4)) <= m2 * (merge_slack1 + 2.0 * fabs(Z1)))))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-v4, -v4, -v4, -v4),
        dhgen_four_of(-v2, -v2, -v2, -v2)), ratio2 = dhgen_ratio_four(s1, c1),
        ratio3 = dhgen_ratio_four(S2, -v22), ratio4 = dhgen_ratio_four(Y5, -X5),
        ratio5 = dhgen_ratio_four(-(X5 * (c3 * v57 - factor2 * (S2 * v56 - v22 * (s3 * (c1 * T11 +
            s1 * T21)))) + Y5 * (v3 * (s3 * v57) + factor2 * (v22 * (v64 - (c1 * v58 + s1 * v59)) +
            S2 * (v63 + e4 * (c1 * v61 + s1 * v62))))), -(X5 * (c3 * v48 - factor2 * (S2 * v47 - v22
            * (s3 * (c1 * T12 + s1 * T22)))) + Y5 * (v3 * (s3 * v48) + factor2 * (v22 * (v55 - (c1 *
            v49 + s1 * v50)) + S2 * (v54 + e4 * (c1 * v52 + s1 * v53)))))),
        ratio6 = dhgen_ratio_four(dhgen_sqrt_four(v39), e4 * (v5 * v36) - factor2 * (S2 * (c1 * v43
            + s1 * v44 - v46) + v22 * (v42 + e4 * (c1 * v40 + s1 * v41))));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle5 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0), angle3 = dhgen_angle_four(ratio2),
        angle4 = dhgen_angle_four(ratio3), angle1 = dhgen_angle_four(ratio4),
        angle2 = dhgen_angle_four(ratio5), angle6 = dhgen_angle_four(ratio6);
    const dhgen_four q5_m = angle1 - dhgen_signed_four(DHGEN_HALF_TURN, Y5),
        q7_m = angle2 - dhgen_signed_four(DHGEN_HALF_TURN, -(X5 * (c3 * v57 - factor2 * (S2 * v56 -
            v22 * (s3 * (c1 * T11 + s1 * T21)))) + Y5 * (v3 * (s3 * v57) + factor2 * (v22 * (v64 -
            (c1 * v58 + s1 * v59)) + S2 * (v63 + e4 * (c1 * v61 + s1 * v62)))))),
        v65 = angle3 - offset1, q1_p = dhgen_raised_four(v65), v66 = angle4 - offset2,
        q2_p = dhgen_raised_four(v66), v67 = e4 * angle5 - offset4, q4_ = dhgen_raised_four(v67),
        v68 = angle6 - offset6, v69 = offset6 + angle6, q6_p = dhgen_raised_four(v68),
        q6_m = dhgen_only_four(-v69 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v69,
        v70 = dhgen_exceeds_four(q4_, joints + 3), q4_p = v6 + q4_,
        v71 = dhgen_maximum_four(dhgen_exceeds_four(q2_p, joints + 1), dhgen_maximum_four(v70,
            dhgen_exceeds_four(q1_p, joints))),
        excess_p = dhgen_maximum_four(dhgen_exceeds_four(angle2, joints + 6),
            dhgen_maximum_four(dhgen_exceeds_four(q6_p, joints + 5), dhgen_maximum_four(v71,
            dhgen_exceeds_four(angle1, joints + 4)))),
        excess_m = dhgen_maximum_four(dhgen_exceeds_four(q7_m, joints + 6),
            dhgen_maximum_four(dhgen_exceeds_four(q6_m, joints + 5), dhgen_maximum_four(v71,
            dhgen_exceeds_four(q5_m, joints + 4))));
    const dhgen_four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (dhgen_bits_four((dhgen_within_slack_four(excess_p) | dhgen_within_slack_four(excess_m))))
        return -1;

    dhgen_store_4(q, q + 14, q + 28, q + 42, q1_p, q2_p, dhgen_all_four(q3_p), q4_p);
    dhgen_store_4(q + 3, q + 17, q + 31, q + 45, q4_p, angle1, q6_p, angle2);
    dhgen_store_4(q + 7, q + 21, q + 35, q + 49, q1_p, q2_p, dhgen_all_four(q3_p), q4_p);
    dhgen_store_4(q + 10, q + 24, q + 38, q + 52, q4_p, q5_m, q6_m, q7_m);
    const unsigned long long none1 = (dhgen_bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long outside1 = (dhgen_bits_four(outside_p) * 0x200040008001ull &
        0x1000100010001ull) | (dhgen_bits_four(outside_m) * 0x20004000800100ull &
        0x100010001000100ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE + (outside1 & ~none1) *
        DHGEN_OUT_OF_LIMITS;
    __builtin_memcpy(status, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~(none1 | outside1));
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int given_joints[1] = { 2 };
DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[3] = { 4, 1, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    7, 8, 1, DHGEN_POSE, joints, given_joints, 1,
    { 0.7657, 0.7657, 0.7657, 1.0, 1.0, 1.0 }, 0.7656967840735068, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 3, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 1, /* clamps */ 1, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, kuka_iiwa14_fk,
    kuka_iiwa14_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_CALLER_GIVES 1
#define DHGEN_NAME(function) kuka_iiwa14_##function
#include "dhgen/functions.h"

/* franka_panda: Franka Emika Panda
 *
 * Inverse kinematics, generated from robots/franka_panda.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/franka_panda.yaml. The formulas and where they come from:
 * franka_panda.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 3bdf97d21dac1f9a
 * SPDX-License-Identifier: MIT
 */
#include "franka_panda.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(FRANKA_PANDA_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(FRANKA_PANDA_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 7
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef FRANKA_PANDA_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, arm_size2 = 1.940449 [m^2]. */
static const double
    d1 = 0.333, /* joint offset 1 [m] */
    d3 = 0.316, /* joint offset 3 [m] */
    a3 = 0.0825, /* link length 4 [m] */
    d5 = 0.384, /* joint offset 5 [m] */
    a4 = 0.0825, /* link length 5 [m] */
    a6 = 0.088, /* link length 7 [m] */
    d7 = 0.107, /* z of the tool frame [m] */
    reach_slack2 = 1.9404490000000003e-13, /* rounding at the boundary of the workspace [m^2] */
    merge_slack2 = 1.940449e-14, /* nearer to that boundary two branches are one [m^2] */
    least_root2 = 6.136238523396071e-07, /* a root of nothing, by rounding [m^2] */
    free_limit_squared2 = 1.940449e-24, /* square of a length that fixes no angle [m^2] */
    reach_slack1 = 1.393e-13, /* rounding at the boundary of the workspace [m] */
    merge_slack1 = 1.393e-14, /* nearer to that boundary two branches are one [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.1155, /* 2 * (d3 * a4 + d5 * a3) [m^2] */
    k2 = 0.22907550000000002, /* 2 * (d3 * d5 - a4 * a3) [m^2] */
    k3 = 0.06581583470025, /* k1^2 + k2^2 [m^4] */
    k4 = 0.25318050000000003, /* d3^2 + (a4 * a3 + (d5^2 + (a4 * a3 - a6^2))) [m^2] */
    k5 = 0.515344644461153, /* 1 / arm_size2 [m^-2] */
    k6 = 15.193911990243306; /* 1 / k3 [m^-4] */

#ifndef __CUDACC_RTC__
const char *const franka_panda_branches[8] = {
    "elbow4+-noflip-elbow3+", "elbow4+-noflip-elbow3-", "elbow4+-flip-elbow3+",
    "elbow4+-flip-elbow3-", "elbow4--noflip-elbow3+", "elbow4--noflip-elbow3-",
    "elbow4--flip-elbow3+", "elbow4--flip-elbow3-",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[7] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.8973, 2.8973, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -1.7628, 1.7628, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.8973, 2.8973, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.0718, -0.0698, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.8973, 2.8973, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.0175, 3.7525, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.8973, 2.8973, 1e-09, 1.0, 0.0, 0.09817477042468103, 1 },
};

/* What follows from joint values: what the pose and the Jacobian are made of. */
#define MOTION \
    const double c1 = cos(q[0]), s1 = sin(q[0]), c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, \
        x2_y = s1 * c2, z3_x = c1 * s2, z3_y = s1 * s2, c3 = cos(q[2]), s3 = sin(q[2]), \
        x3_x = x2_x * c3 - s1 * s3, x3_y = x2_y * c3 + c1 * s3, v1 = s2 * c3, \
        z4_x = s1 * c3 + x2_x * s3, y3_y = c1 * c3 - x2_y * s3, y3_z = s2 * s3, c4 = cos(q[3]), \
        s4 = sin(q[3]), x4_x = x3_x * c4 + z3_x * s4, x4_y = x3_y * c4 + z3_y * s4, \
        x4_z = c2 * s4 - v1 * c4, y4_x = z3_x * c4 - x3_x * s4, y4_y = z3_y * c4 - x3_y * s4, \
        y4_z = c2 * c4 + v1 * s4, c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - z4_x * s5, \
        x5_y = x4_y * c5 + y3_y * s5, x5_z = x4_z * c5 + y3_z * s5, z6_x = z4_x * c5 + x4_x * s5, \
        z6_y = x4_y * s5 - y3_y * c5, z6_z = x4_z * s5 - y3_z * c5, c6 = cos(q[5]), \
        s6 = sin(q[5]), z7_x = x5_x * s6 - y4_x * c6, z7_y = x5_y * s6 - y4_y * c6, \
        z7_z = x5_z * s6 - y4_z * c6

/* The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[7][4] = {
    { 0.0, 0.333, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.316, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0825, 1.5707963267948966 },
    { 0.0, 0.384, -0.0825, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.088, 1.5707963267948966 },
};
DHGEN_TABLE double tool[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.107 };
DHGEN_TABLE struct dhgen_links links = { 7, DHGEN_MODIFIED, joints, &table[0][0], NULL, NULL, tool
    };
#define DHGEN_FRAMES 9

DHGEN_PUBLIC void franka_panda_fk(const double q[7], double T[16])
{
    MOTION;
    const double x6_x = x5_x * c6 + y4_x * s6, x6_y = x5_y * c6 + y4_y * s6,
        x6_z = x5_z * c6 + y4_z * s6;
    const double c7 = cos(q[6]), s7 = sin(q[6]);
    T[0] = x6_x * c7 + z6_x * s7; T[1] = z6_x * c7 - x6_x * s7; T[2] = z7_x;
    T[3] = z3_x * d3 + x3_x * a3 - x4_x * a4 + y4_x * d5 + x6_x * a6 + z7_x * d7;
    T[4] = x6_y * c7 + z6_y * s7; T[5] = z6_y * c7 - x6_y * s7; T[6] = z7_y;
    T[7] = z3_y * d3 + x3_y * a3 - x4_y * a4 + y4_y * d5 + x6_y * a6 + z7_y * d7;
    T[8] = x6_z * c7 + z6_z * s7; T[9] = z6_z * c7 - x6_z * s7; T[10] = z7_z;
    T[11] = d1 + c2 * d3 - v1 * a3 - x4_z * a4 + y4_z * d5 + x6_z * a6 + z7_z * d7;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void franka_panda_jacobian(const double q[7], double J[42])
{
    MOTION;
    const double p3_x = z3_x * d3, p3_y = z3_y * d3, p3_z = d1 + c2 * d3, p4_x = p3_x + x3_x * a3,
        p4_y = p3_y + x3_y * a3, p4_z = p3_z - v1 * a3, p5_x = p4_x - x4_x * a4 + y4_x * d5,
        p5_y = p4_y - x4_y * a4 + y4_y * d5, p5_z = p4_z - x4_z * a4 + y4_z * d5,
        p7_x = p5_x + (x5_x * c6 + y4_x * s6) * a6, p7_y = p5_y + (x5_y * c6 + y4_y * s6) * a6,
        p7_z = p5_z + (x5_z * c6 + y4_z * s6) * a6, J21 = p7_x + z7_x * d7, v2 = p7_y + z7_y * d7,
        v3 = p7_z + z7_z * d7, v4 = v3 - d1, v5 = J21 - p3_x, v6 = v2 - p3_y, v7 = v3 - p3_z,
        v8 = J21 - p4_x, v9 = v2 - p4_y, v10 = v3 - p4_z, v11 = J21 - p5_x, v12 = v2 - p5_y,
        v13 = v3 - p5_z, v14 = J21 - p7_x, v15 = v2 - p7_y, v16 = v3 - p7_z;
    J[0] = -v2; J[1] = c1 * v4; J[2] = z3_y * v7 - c2 * v6; J[3] = -y3_y * v10 + y3_z * v9;
    J[4] = y4_y * v13 - y4_z * v12; J[5] = z6_y * v13 - z6_z * v12; J[6] = z7_y * v16 - z7_z * v15;
    J[7] = J21; J[8] = s1 * v4; J[9] = c2 * v5 - z3_x * v7; J[10] = -(y3_z * v8 + z4_x * v10);
    J[11] = y4_z * v11 - y4_x * v13; J[12] = z6_z * v11 - z6_x * v13;
    J[13] = z7_z * v14 - z7_x * v16;
    J[14] = 0.0; J[15] = -(s1 * v2 + c1 * J21); J[16] = z3_x * v6 - z3_y * v5;
    J[17] = z4_x * v9 - -y3_y * v8; J[18] = y4_x * v12 - y4_y * v11;
    J[19] = z6_x * v12 - z6_y * v11; J[20] = z7_x * v15 - z7_y * v14;
    J[21] = 0.0; J[22] = -s1; J[23] = z3_x; J[24] = z4_x; J[25] = y4_x; J[26] = z6_x; J[27] = z7_x;
    J[28] = 0.0; J[29] = c1; J[30] = z3_y; J[31] = -y3_y; J[32] = y4_y; J[33] = z6_y; J[34] = z7_y;
    J[35] = 1.0; J[36] = 0.0; J[37] = c2; J[38] = -y3_z; J[39] = y4_z; J[40] = z6_z; J[41] = z7_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[7] = (double (*)[7])rows;
    (void)moved;
    DHGEN_ENTRIES(double);

    const double c7 = cos(free_joints[0]), s7 = sin(free_joints[0]);

    /* theta4, type 2: the squared length of column 4 of A7 U0^-1 A1 */
    const double v1 = d7 * T13 - T14, v2 = d7 * T23 - T24;
    const double t34 = T34 - d7 * T33;
    const double v3 = d1 - t34;
    const double w2x = T11 * v1 + T21 * v2 + T31 * v3, w2y = T12 * v1 + T22 * v2 + T32 * v3,
        w2z = T13 * v1 + T23 * v2 + T33 * v3;
    const double Z4 = c7 * (2.0 * (w2x * a6)) - s7 * (2.0 * (w2y * a6)) + (w2x * w2x + (w2y * w2y +
        (w2z * w2z - k4)));
    const double D4_squared = k3 - Z4 * Z4;
    const double v4 = 2.0 * fabs(Z4);
    const int apart4 = merge_slack2 * (v4 + merge_slack2) < D4_squared;
    if (!(-(reach_slack2 * (v4 + reach_slack2)) < D4_squared)) return; /* out of reach */
    const double w4 = sqrt(apart4 ? D4_squared : 0.0);
    const double v5 = (apart4 ? w4 : least_root2) * k5, v6 = k1 * Z4, v7 = k2 * Z4;

    /* theta5, type 2: A7 U0^-1 A1 [3, 4] */
    const double Z5 = c7 * w2y + s7 * w2x;
    const double v9 = Z5 * Z5, v10 = fabs(Z5), v11 = 2.0 * v10,
        v12 = merge_slack1 * (v11 + merge_slack1);

    /* theta6, type 3: A7 U0^-1 A1 [2, 4] and A7 U0^-1 A1 [1, 4] */
    const double Z2_6 = a6 + (c7 * w2x - s7 * w2y);

    /* theta3, type 2: U0 (A3 A4 A5 A6 A7)^-1 [3, 3] */
    const double v17 = c7 * T31 - s7 * T32, v22 = c7 * T32 + s7 * T31;

    /* theta1, type 3: U0 (A3 A4 A5 A6 A7)^-1 [1, 3] and U0 (A3 A4 A5 A6 A7)^-1 [2, 3] */
    const double v28 = c7 * T11 - s7 * T12, v31 = c7 * T12 + s7 * T11, v39 = c7 * T21 - s7 * T22,
        v42 = c7 * T22 + s7 * T21;

    for (int i1 = 0; i1 < 2; i1++) { /* elbow4+, elbow4- */
        const double e4 = i1 == 0 ? 1.0 : -1.0;
        /* theta4 */
        if (e4 < 0.0 && !apart4) continue; /* both signs give the same */
        const double D4 = w4 * e4;
        const double c4 = k6 * (v7 + k1 * D4), s4 = k6 * (k2 * D4 - v6);
        const double q4 = atan2(s4, c4);

        /* theta5 */
        const double v8 = a3 * c4 + d3 * s4 - a4;
        const double N5 = -v8 * -v8;
        const int free5 = N5 <= free_limit_squared2;
        const double D5_squared = N5 - v9;
        const int apart5 = v12 < D5_squared;
        if (!(-(reach_slack1 * (v11 + reach_slack1)) < v5 * D5_squared))
            continue; /* out of reach */
        const double w5 = sqrt(apart5 ? D5_squared : 0.0);
        const double inverse5 = 1.0 / (free5 ? 1.0 : (apart5 ? N5 : v10 * sqrt(N5)));
        const double s5 = free5 ? sin(seed[4]) : inverse5 * (-v8 * Z5);

        /* theta6 */
        const double Y1_6 = d5 + (d3 * c4 - a3 * s4);
        const double v14 = Y1_6 * Z2_6, v16 = w2z * Y1_6;

        /* theta3 */
        const double v18 = c4 * v17, v19 = T33 * s4, v20 = T33 * c4, v21 = s4 * v17,
            v23 = s5 * (c4 * v22), v25 = s5 * v17, v26 = T33 * s5;

        /* theta2, type 3: U0 (A3 A4 A5 A6 A7)^-1 [3, 2] and U0 (A3 A4 A5 A6 A7)^-1 [3, 1] */
        const double v27 = s5 * (s4 * v22);

        /* theta1 */
        const double v29 = s5 * v28, v30 = T13 * s5, v33 = c4 * v28, v34 = T13 * s4, v35 = T13 * c4,
            v36 = s4 * v28, v37 = s5 * (c4 * v31), v40 = s5 * v39, v41 = T23 * s5, v44 = c4 * v39,
            v45 = T23 * s4, v46 = T23 * c4, v47 = s4 * v39, v48 = s5 * (c4 * v42);

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e5 = i2 == 0 ? 1.0 : -1.0;
            /* theta5 */
            if (e5 < 0.0 && (free5 || !apart5)) continue; /* both signs give the same */
            const double c5 = free5 ? cos(seed[4]) : -(inverse5 * (-v8 * (w5 * e5)));
            const double q5 = atan2(s5, c5);

            /* theta6 */
            const double v13 = v8 * c5, v15 = w2z * v13 + v14;
            const double C6 = v16 - v13 * Z2_6;
            const double w6 = sqrt(v15 * v15 + C6 * C6);
            const int free6 = w6 <= free_limit_squared2;
            const double factor6 = 1.0 / (free6 ? 1.0 : w6);
            const double c6 = free6 ? cos(seed[5]) : C6 * factor6,
                s6 = free6 ? sin(seed[5]) : -(v15 * factor6);
            const double q6 = atan2(s6, c6);

            /* theta3 */
            const double v24 = c6 * (c5 * v18 + v19) + s6 * (c5 * v20 - v21) + v23;
            const double Y3 = c5 * v22 - (c6 * v25 + s6 * v26);
            const double w3 = sqrt(v24 * v24 + Y3 * Y3);
            const int free3 = w3 <= free_limit;
            const double divisor3 = free3 ? 1.0 : w3;

            /* theta2 */
            const double c2 = c6 * (c5 * v21 - v20) + s6 * (v18 + c5 * v19) + v27;

            /* theta1 */
            const double v32 = c5 * v31 - (c6 * v29 + s6 * v30),
                v38 = c6 * (c5 * v33 + v34) + s6 * (c5 * v35 - v36) + v37,
                v43 = c5 * v42 - (c6 * v40 + s6 * v41),
                v49 = c6 * (c5 * v44 + v45) + s6 * (c5 * v46 - v47) + v48;

            for (int i3 = 0; i3 < 2; i3++) { /* elbow3+, elbow3- */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta3 */
                if (e3 < 0.0 && free3) continue; /* both signs give the same */
                const double factor3 = e3 / divisor3;
                const double c3 = free3 ? cos(seed[2]) : v24 * factor3,
                    s3 = free3 ? sin(seed[2]) : Y3 * factor3;
                const double q3 = atan2(s3, c3);

                /* theta2 */
                const double q2 = atan2(-(w3 * e3), c2);

                /* theta1 */
                const double s1 = c3 * v32 - s3 * v38, c1 = s3 * v49 - c3 * v43;
                const double q1 = atan2(s1, c1);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6; q[row][6] = free_joints[0];
                status[row] = (free3 || free5 || free6) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef FRANKA_PANDA_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    doubt_limit_squared2 = 1.940449e-08, /* square of a length that fixes no angle [m^2] */
    turn1 = 0.46700242365301164, /* atan2(k1, k2) [rad] */
    m1 = 1.940449e-11, /* 1000 * merge_slack2 [m^2] */
    m2 = 1.754896834873102, /* k1 * k6 [m^-2] */
    m3 = 3.4805529861209807, /* k2 * k6 [m^-2] */
    m4 = 1.2446337324912609, /* k6 * (d3 * k2 + a3 * k1) [m^-1] */
    m5 = 0.0825, /* a4 [m] */
    m6 = 0.2674017784649193, /* k6 * (d3 * k1 - a3 * k2) [m^-1] */
    m7 = 1.393e-11, /* 1000 * merge_slack1 [m] */
    m8 = 0.5, /* 1 / 2 */
    m9 = 0.384, /* d5 [m] */
    m10 = 3.765342321601e-16, /* doubt_limit_squared2^2 [m^4] */
    m11 = 9.999999999999999e-09; /* doubt_limit^2 */

/* What one pose and many compute alike: values without signs of branches, with the first, with
 * all that are in lanes. */
#define KNOWN(number) \
    const dhgen_##number c7 = dhgen_cos_##number(free_joints[0]), \
        s7 = dhgen_sin_##number(free_joints[0]); \
    /* theta4 */ \
    const dhgen_##number v1 = d7 * T13 - T14, v2 = d7 * T23 - T24, v3 = d1 - (T34 - d7 * T33), \
        w2x = v1 * T11 + v2 * T21 + v3 * T31, w2y = v1 * T12 + v2 * T22 + v3 * T32, \
        w2z = T13 * v1 + T23 * v2 + T33 * v3, \
        Z4 = c7 * (2.0 * (a6 * w2x)) - s7 * (2.0 * (a6 * w2y)) + (w2x * w2x + (w2y * w2y + (w2z * \
            w2z - k4))), D4_squared = k3 - Z4 * Z4, w4 = dhgen_sqrt_##number(D4_squared), \
        v4 = k5 * w4, v5 = m3 * Z4, v6 = m2 * Z4; \
    /* theta5 */ \
    const dhgen_##number v8 = m5 + m6 * Z4, Z5 = c7 * w2y + s7 * w2x, v10 = Z5 * Z5, \
        v12 = m7 * (merge_slack1 + 2.0 * dhgen_abs_##number(Z5)); \
    /* theta6 */ \
    const dhgen_##number v18 = m9 + m4 * Z4, Z2_6 = a6 + (c7 * w2x - s7 * w2y); \
    /* theta3 */ \
    const dhgen_##number v25 = c7 * T31 - s7 * T32, v30 = c7 * T32 + s7 * T31; \
    /* theta1 */ \
    const dhgen_##number v42 = c7 * T11 - s7 * T12, v45 = c7 * T12 + s7 * T11, \
        v52 = c7 * T21 - s7 * T22, v55 = c7 * T22 + s7 * T21; \
    /* joint values */ \
    const dhgen_##number v68 = free_joints[0] + (w4 - w4)
#define SIGNED(number, signs) \
    /* theta4 */ \
    const dhgen_##number c4 = v5 + w4 * (m2 * e4), s4 = w4 * (m3 * e4) - v6; \
    /* theta5 */ \
    const dhgen_##number v7 = a3 * c4 + d3 * s4 - a4, v9 = v8 - w4 * (m4 * e4), N5 = v9 * v9, \
        D5_squared = N5 - v10, w5 = dhgen_sqrt_##number(D5_squared), v11 = w5 - w5, \
        inverse5 = DHGEN_QUOTIENT(1.0, N5), v13 = v9 * w5, v14 = inverse5 * v13, v15 = v9 * Z5, \
        s5 = inverse5 * v15, v16 = dhgen_signed_##number(DHGEN_HALF_TURN, v15); \
    /* theta6 */ \
    const dhgen_##number Y1_6 = v18 + w4 * (m6 * e4), v19 = Y1_6 * Z2_6, v22 = w2z * Y1_6; \
    /* theta3 */ \
    const dhgen_##number v26 = c4 * v25, v27 = T33 * s4, v28 = T33 * c4, v29 = s4 * v25, \
        v31 = s5 * (c4 * v30), v32 = v14 * v26, v33 = v14 * v28, v34 = s5 * v25, v35 = T33 * s5, \
        v36 = v14 * v30; \
    /* theta2 */ \
    const dhgen_##number v39 = s5 * (s4 * v30), v40 = v14 * v29, v41 = v14 * v27; \
    /* theta1 */ \
    const dhgen_##number v43 = s5 * v42, v44 = T13 * s5, v46 = v14 * v45, v47 = T13 * s4, \
        v48 = s4 * v42, v49 = s5 * (c4 * v45), v50 = v14 * (c4 * v42), v51 = v14 * (T13 * c4), \
        v53 = s5 * v52, v54 = T23 * s5, v56 = v14 * v55, v57 = T23 * s4, v58 = s4 * v52, \
        v59 = s5 * (c4 * v55), v60 = v14 * (c4 * v52), v61 = v14 * (T23 * c4); \
    /* joint values */ \
    const dhgen_##number q7_p = v11 + v68
#define SIGNED_TWICE(number, signs) \
    /* theta5 */ \
    const dhgen_##signs v17 = m8 * (1.0 - e5); \
    /* theta6 */ \
    const dhgen_##number v20 = e5 * w2z, v21 = v19 - w5 * (inverse5 * (v7 * (v9 * v20))), \
        v23 = e5 * Z2_6, C6 = v22 + w5 * (inverse5 * (v7 * (v9 * v23))), \
        v24 = v21 * v21 + C6 * C6, factor6 = dhgen_sqrt_##number(v24) * DHGEN_QUOTIENT(1.0, v24); \
    /* theta3 */ \
    const dhgen_##number c3 = v31 + factor6 * (C6 * (v27 - e5 * v32) + v21 * (v29 + e5 * v33)), \
        v37 = e5 * v36 + factor6 * (C6 * v34 - v21 * v35), v38 = c3 * c3 + v37 * v37; \
    /* theta1 */ \
    const dhgen_##number s1 = v37 * (v49 + factor6 * (C6 * (v47 - e5 * v50) + v21 * (v48 + e5 * \
        v51))) - c3 * (e5 * v46 + factor6 * (C6 * v43 - v21 * v44))

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    DHGEN_ENTRIES(dhgen_wide);
    dhgen_wide_mask left = (dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11] + free_joints[0])
        <= DHGEN_ORTHONORMAL) == 0;
    KNOWN(wide);

    /* theta4 */
    const dhgen_wide angle1 = dhgen_atan2_wide(w4, Z4);
    left |= (dhgen_abs_wide(D4_squared) <= m1 * (merge_slack2 + 2.0 * dhgen_abs_wide(Z4))) | (0.0 <
        dhgen_exceeds_wide(free_joints[0], joints + 6));

    DHGEN_UNROLLED for (int i1 = 0; i1 < 2; i1++) { /* elbow4+, elbow4- */
        const double e4 = i1 == 0 ? 1.0 : -1.0;
        SIGNED(wide, double);

        /* theta4 */
        const dhgen_wide q4_ = e4 * angle1 - turn1;

        /* theta5 */
        const dhgen_wide angle2 = dhgen_atan2_wide(v15, -v13);

        /* joint values */
        const dhgen_wide v62 = dhgen_raised_wide(q4_), v63 = dhgen_beyond_wide(v62, joints + 3),
            q4_p = v11 + v62;
        left |= (N5 <= doubt_limit_squared2) | (dhgen_abs_wide(v4 * D5_squared) <= v12);

        DHGEN_UNROLLED for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e5 = i2 == 0 ? 1.0 : -1.0;
            SIGNED_TWICE(wide, double);

            /* theta5 */
            const dhgen_wide q5_p = e5 * angle2 + v16 * v17;

            /* theta6 */
            const dhgen_wide angle3 = dhgen_atan2_wide(-v21, C6);

            /* theta3 */
            const dhgen_wide angle4 = dhgen_atan2_wide(-v37, c3),
                q3_m = angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, -v37);

            /* theta2 */
            const dhgen_wide angle5 = dhgen_atan2_wide(-dhgen_sqrt_wide(v38), v39 + factor6 * (-v21
                * (v26 - e5 * v41) - C6 * (v28 + e5 * v40)));

            /* theta1 */
            const dhgen_wide angle6 = dhgen_atan2_wide(s1, c3 * (e5 * v56 + factor6 * (C6 * v53 -
                v21 * v54)) - v37 * (v59 + factor6 * (C6 * (v57 - e5 * v60) + v21 * (v58 + e5 *
                v61)))), q1_m = angle6 - dhgen_signed_wide(DHGEN_HALF_TURN, s1);

            /* joint values */
            const dhgen_wide v64 = angle3 + dhgen_only_wide(angle3 < dhgen_low(joints + 5),
                DHGEN_TURN), v65 = dhgen_beyond_wide(v64, joints + 5),
                v66 = dhgen_low(joints + 5) - angle3, v67 = dhgen_pick_wide(v66 < v65, v66, v65),
                q6_p = dhgen_pick_wide(0.0 < v67, angle3, v64),
                v69 = dhgen_maximum_wide(v67, dhgen_maximum_wide(dhgen_exceeds_wide(q5_p, joints +
                    4), dhgen_maximum_wide(v63, dhgen_exceeds_wide(angle5, joints + 1)))),
                excess_p = dhgen_maximum_wide(dhgen_exceeds_wide(angle4, joints + 2),
                    dhgen_maximum_wide(v69, dhgen_exceeds_wide(angle6, joints))),
                excess_m = dhgen_maximum_wide(dhgen_exceeds_wide(q3_m, joints + 2),
                    dhgen_maximum_wide(v69, dhgen_exceeds_wide(q1_m, joints)));
            const int row = 4 * i1 + 2 * i2;
            q[7 * row] = angle6; q[7 * row + 1] = angle5; q[7 * row + 2] = angle4;
            q[7 * row + 3] = q4_p; q[7 * row + 4] = q5_p; q[7 * row + 5] = q6_p;
            q[7 * row + 6] = q7_p;
            kind[row] = dhgen_kind_within_wide(q[7 * row], 0.0 < excess_p);
            q[7 * row + 7] = q1_m; q[7 * row + 8] = -angle5; q[7 * row + 9] = q3_m;
            q[7 * row + 10] = q4_p; q[7 * row + 11] = q5_p; q[7 * row + 12] = q6_p;
            q[7 * row + 13] = q7_p;
            kind[row + 1] = dhgen_kind_within_wide(q[7 * row + 7], 0.0 < excess_m);
            left |= (v24 <= m10) | (v38 <= m11);
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
    const dhgen_four e5 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);
    KNOWN(double);
    SIGNED(four, four);
    SIGNED_TWICE(four, four);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) + 0.0 * (free_joints[0]) <= DHGEN_ORTHONORMAL)
        == 0) | ((N5 <= doubt_limit_squared2) | (dhgen_abs_four(v4 * D5_squared) <= v12)) | ((v24 <=
        m10) | (v38 <= m11))) | (unsigned)((fabs(D4_squared) <= m1 * (merge_slack2 + 2.0 *
        fabs(Z4))) | (0.0 < fabs(free_joints[0]) - dhgen_high(joints + 6))))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(v15, dhgen_all_four(w4), 0,
        5, 2, 3), dhgen_shuffle(-v13, dhgen_all_four(Z4), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(-v21, C6), ratio3 = dhgen_ratio_four(-v37, c3),
        ratio4 = dhgen_ratio_four(s1, c3 * (e5 * v56 + factor6 * (C6 * v53 - v21 * v54)) - v37 *
            (v59 + factor6 * (C6 * (v57 - e5 * v60) + v21 * (v58 + e5 * v61)))),
        ratio5 = dhgen_ratio_four(-dhgen_sqrt_four(v38), v39 + factor6 * (-v21 * (v26 - e5 * v41) -
            C6 * (v28 + e5 * v40)));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle2 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = dhgen_angle_four(ratio2),
        angle4 = dhgen_angle_four(ratio3), angle6 = dhgen_angle_four(ratio4),
        angle5 = dhgen_angle_four(ratio5);
    const dhgen_four q4_ = e4 * angle1 - turn1, q5_p = e5 * angle2 + v16 * v17,
        q3_m = angle4 - dhgen_signed_four(DHGEN_HALF_TURN, -v37),
        q1_m = angle6 - dhgen_signed_four(DHGEN_HALF_TURN, s1), v62 = dhgen_raised_four(q4_),
        v63 = dhgen_beyond_four(v62, joints + 3),
        v64 = angle3 + dhgen_only_four(angle3 < dhgen_low(joints + 5), DHGEN_TURN),
        v65 = dhgen_beyond_four(v64, joints + 5), v66 = dhgen_low(joints + 5) - angle3,
        v67 = dhgen_pick_four(v66 < v65, v66, v65), q6_p = dhgen_pick_four(0.0 < v67, angle3, v64),
        q4_p = v11 + v62,
        v69 = dhgen_maximum_four(v67, dhgen_maximum_four(dhgen_exceeds_four(q5_p, joints + 4),
            dhgen_maximum_four(v63, dhgen_exceeds_four(angle5, joints + 1)))),
        excess_p = dhgen_maximum_four(dhgen_exceeds_four(angle4, joints + 2),
            dhgen_maximum_four(v69, dhgen_exceeds_four(angle6, joints))),
        excess_m = dhgen_maximum_four(dhgen_exceeds_four(q3_m, joints + 2), dhgen_maximum_four(v69,
            dhgen_exceeds_four(q1_m, joints)));
    const dhgen_four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (dhgen_bits_four((dhgen_within_slack_four(excess_p) | dhgen_within_slack_four(excess_m))))
        return -1;

    dhgen_store_4(q, q + 14, q + 28, q + 42, angle6, angle5, angle4, q4_p);
    dhgen_store_4(q + 3, q + 17, q + 31, q + 45, q4_p, q5_p, q6_p, q7_p);
    dhgen_store_4(q + 7, q + 21, q + 35, q + 49, q1_m, -angle5, q3_m, q4_p);
    dhgen_store_4(q + 10, q + 24, q + 38, q + 52, q4_p, q5_p, q6_p, q7_p);
    const unsigned long long none1 = (dhgen_bits_four(angle6 != angle6) * 0x200040008001ull &
        0x1000100010001ull) | (dhgen_bits_four(q1_m != q1_m) * 0x20004000800100ull &
        0x100010001000100ull);
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

DHGEN_TABLE int given_joints[1] = { 6 };
DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[3] = { 5, 4, 2 };
DHGEN_TABLE struct dhgen_arm arm = {
    7, 8, 1, DHGEN_POSE, joints, given_joints, 1,
    { 0.7179, 0.7179, 0.7179, 1.0, 1.0, 1.0 }, 0.7178750897343862, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 3, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 1, /* clamps */ 1, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, franka_panda_fk,
    franka_panda_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_CALLER_GIVES 1
#define DHGEN_NAME(function) franka_panda_##function
#include "dhgen/functions.h"

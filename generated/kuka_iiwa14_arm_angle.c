/* kuka_iiwa14_arm_angle: KUKA LBR iiwa 14 R820, arm angle given
 *
 * Inverse kinematics, generated from robots/kuka_iiwa14_arm_angle.yaml and
 * templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kuka_iiwa14_arm_angle.yaml. The formulas and where they come from:
 * kuka_iiwa14_arm_angle.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: d4722574f6bbef95
 * SPDX-License-Identifier: MIT
 */
#include "kuka_iiwa14_arm_angle.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KUKA_IIWA14_ARM_ANGLE_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KUKA_IIWA14_ARM_ANGLE_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 7
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef KUKA_IIWA14_ARM_ANGLE_PLAIN
#include "dhgen/tile.h"
#endif

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
    free_limit = 1e-12, /* a length that fixes no angle */
    solved_limit = 8.993529828991507e-08, /* the same of a solution, whose pose is rounded [m^2] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    offset2 = 3.141592653589793, /* offset of joint 2 [rad] */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset6 = 3.141592653589793, /* offset of joint 6 [rad] */
    k1 = 0.336, /* 2 * d5 * d3 [m^2] */
    k2 = 0.33640000000000003, /* d3^2 + d5^2 [m^2] */
    k3 = 8.857709750566894, /* 1 / (k1^2) [m^-4] */
    straight_limit = 9.271680236073719e-08; /* a stretched arm: its elbow is on either side [m^2] */

#ifndef __CUDACC_RTC__
const char *const kuka_iiwa14_arm_angle_branches[8] = {
    "elbow+-back-noflip", "elbow+-back-flip", "elbow+-front-noflip", "elbow+-front-flip",
    "elbow--back-noflip", "elbow--back-flip", "elbow--front-noflip", "elbow--front-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[7] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.0943951023931953, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.0943951023931953, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.0943951023931953, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.0543261909900767, 3.0543261909900767, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

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

DHGEN_PUBLIC void kuka_iiwa14_arm_angle_fk(const double q[7], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + s1 * s3,
        x3_y = x2_y * c3 - c1 * s3, x3_z = s2 * c3, z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3,
        z3_x = x2_x * s3 - s1 * c3, v3 = q[3] + offset4;
    const double c4 = cos(v3), s4 = sin(v3), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - c2 * s4, z4_z = c2 * c4 + x3_z * s4,
        z4_x = x3_x * s4 - z2_x * c4, z4_y = x3_y * s4 - z2_y * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, z5_x = x4_x * s5 - z3_x * c5,
        z5_y = x4_y * s5 - z3_y * c5, z5_z = x4_z * s5 - z3_z * c5, v4 = q[5] + offset6;
    const double c6 = cos(v4), s6 = sin(v4), x6_x = x5_x * c6 + z4_x * s6,
        x6_y = x5_y * c6 + z4_y * s6, x6_z = x5_z * c6 + z4_z * s6, z6_x = x5_x * s6 - z4_x * c6,
        z6_y = x5_y * s6 - z4_y * c6, z6_z = x5_z * s6 - z4_z * c6;
    const double c7 = cos(q[6]), s7 = sin(q[6]);
    T[0] = x6_x * c7 + z5_x * s7; T[1] = z5_x * c7 - x6_x * s7; T[2] = z6_x;
    T[3] = z2_x * d3 + z4_x * d5 + z6_x * d7;
    T[4] = x6_y * c7 + z5_y * s7; T[5] = z5_y * c7 - x6_y * s7; T[6] = z6_y;
    T[7] = z2_y * d3 + z4_y * d5 + z6_y * d7;
    T[8] = x6_z * c7 + z5_z * s7; T[9] = z5_z * c7 - x6_z * s7; T[10] = z6_z;
    T[11] = d1 - c2 * d3 + z4_z * d5 + z6_z * d7;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void kuka_iiwa14_arm_angle_jacobian(const double q[7], double J[42])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + s1 * s3,
        x3_y = x2_y * c3 - c1 * s3, x3_z = s2 * c3, z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3,
        p3_x = z2_x * d3, p3_y = z2_y * d3, p3_z = d1 - c2 * d3, z3_x = x2_x * s3 - s1 * c3,
        v3 = q[3] + offset4;
    const double c4 = cos(v3), s4 = sin(v3), x4_x = x3_x * c4 + z2_x * s4,
        x4_y = x3_y * c4 + z2_y * s4, x4_z = x3_z * c4 - c2 * s4, z4_z = c2 * c4 + x3_z * s4,
        z4_x = x3_x * s4 - z2_x * c4, z4_y = x3_y * s4 - z2_y * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), p5_x = p3_x + z4_x * d5, p5_y = p3_y + z4_y * d5,
        p5_z = p3_z + z4_z * d5, z5_x = x4_x * s5 - z3_x * c5, z5_y = x4_y * s5 - z3_y * c5,
        z5_z = x4_z * s5 - z3_z * c5, v4 = q[5] + offset6;
    const double c6 = cos(v4), s6 = sin(v4), z6_x = (x4_x * c5 + z3_x * s5) * s6 - z4_x * c6,
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

DHGEN_PUBLIC double kuka_iiwa14_arm_angle_arm_angle(const double q[7])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), z3_y = c1 * c3 + x2_y * s3, z3_z = s2 * s3,
        p3_x = z2_x * d3, p3_y = z2_y * d3, p3_z = d1 - c2 * d3, z3_x = x2_x * s3 - s1 * c3,
        v3 = q[3] + offset4;
    const double c4 = cos(v3), s4 = sin(v3),
        p5_x = p3_x + ((x2_x * c3 + s1 * s3) * s4 - z2_x * c4) * d5,
        p5_y = p3_y + ((x2_y * c3 - c1 * s3) * s4 - z2_y * c4) * d5, v4 = p3_z - d1,
        v5 = p3_x * z3_x + z3_y * p3_y + z3_z * v4, v6 = p3_x - z3_x * v5, v7 = p3_y - z3_y * v5,
        v8 = v4 - z3_z * v5, v9 = p3_z + (c2 * c4 + s2 * c3 * s4) * d5 - d1,
        v10 = z3_x * (p5_y * v8 - v7 * v9) + z3_y * (v6 * v9 - p5_x * v8) + z3_z * (p5_x * v7 - p5_y
            * v6) < -straight_limit ? -1.0 : 1.0, v11 = z3_x * v10, v12 = z3_y * v10,
        v13 = z3_z * v10, v14 = p5_x * p5_x + p5_y * p5_y, v15 = sqrt(v14 + v9 * v9);
    const int v16 = sqrt(v14) <= v15 * free_limit;
    const double v17 = v16 ? 0.0 : p5_y, v18 = v16 ? 1.0 : -p5_x, v19 = v9 * v12 - p5_y * v13,
        v20 = p5_x * v13 - v9 * v11;
    const double psi = atan2(v15 * (v17 * v19 + v18 * v20), v9 * v18 * v19 - v9 * v17 * v20 + (p5_y
        * v17 - p5_x * v18) * (p5_y * v11 - p5_x * v12));
    return psi;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[7] = (double (*)[7])rows;
    (void)moved;
    DHGEN_ENTRIES(double);

    /* theta4, type 2: the squared length of column 4 of U1 A7^-1 */
    const double wx = T14 - T13 * d7;
    const double wy = T24 - d7 * T23;
    const double wz = T34 - d7 * T33;
    const double v1 = wz - d1;
    const double V4 = wx * wx + wy * wy + v1 * v1;
    const double Z4 = V4 - k2;
    const double D4_squared = (longest4 - V4) * (V4 - shortest4);
    const int apart4 = shortest4_apart < V4 && V4 < longest4_apart;
    if (!(shortest4_reach <= V4 && V4 <= longest4_reach)) return; /* out of reach */
    const double w4 = sqrt(apart4 ? D4_squared : 0.0);
    const double v2 = k3 * (k1 * Z4);

    /* shoulder, its rotation, from the arm angle and theta4 */
    const double reach = sqrt(V4);
    const double v4 = 1.0 / reach;
    const double gx = wx * v4;
    const double gy = wy * v4;
    const double gz = v1 * v4;
    const double lean = sqrt(gy * gy + gx * gx);
    const int upright = lean <= free_limit;
    const double v5 = 1.0 / (upright ? 1.0 : lean), v6 = upright ? 0.0 : gy * v5,
        v7 = upright ? 1.0 : -(gx * v5), v8 = gz * v7, v9 = gz * v6;
    const double cos_psi = cos(free_joints[0]);
    const double sin_psi = sin(free_joints[0]);
    const double uz = (gy * v6 - gx * v7) * cos_psi;
    const double ux = v8 * cos_psi + v6 * sin_psi;
    const double uy = v7 * sin_psi - v9 * cos_psi;
    const double nx = v6 * cos_psi - v8 * sin_psi;
    const double ny = v7 * cos_psi + v9 * sin_psi;
    const double v11 = d3 + d5 * v2, v12 = v11 * v11;

    /* theta1, type 2: B1[3, 2] */
    const double v20 = seed[0] + offset1;

    for (int i1 = 0; i1 < 2; i1++) { /* elbow+, elbow- */
        const double e4 = i1 == 0 ? 1.0 : -1.0;
        /* theta4 */
        if (e4 < 0.0 && !apart4) continue; /* both signs give the same */
        const double v3 = k3 * (k1 * (w4 * e4));

        /* shoulder */
        const double v10 = d5 * v3;
        const double arm_ = sqrt(v10 * v10 + v12);
        const double v13 = 1.0 / arm_, v14 = v10 * v13, v15 = v11 * v13;
        const double side = -(d5 * (d3 * v3)) < -solved_limit ? -1.0 : 1.0;
        const double v16 = v15 * side, v17 = v14 * side, v18 = gx * v14 + ux * v16;
        const double b13 = nx * side;
        const double v19 = gy * v14 + uy * v16;
        const double b22 = gy * v15 - uy * v17;
        const double b23 = ny * side;

        /* theta1 */
        const double X1 = ux * v17 - gx * v15;
        const double w1 = sqrt(X1 * X1 + b22 * b22);
        const int free1 = w1 <= free_limit;
        const double divisor1 = free1 ? 1.0 : w1;

        /* theta2, type 3: B1[2, 2] and B1[1, 2] */
        const double c2 = uz * v17 - gz * v15;

        /* theta5, type 2: U5[3, 3] */
        const double v24 = T33 * c2;

        /* theta7, type 3: U5[3, 2] and U5[3, 1] */
        const double v30 = T32 * c2, v36 = T31 * c2;

        /* joint values */
        const double q4 = dhgen_wrap(atan2(-v3, -v2) - offset4);

        for (int i2 = 0; i2 < 2; i2++) { /* back, front */
            const double e1 = i2 == 0 ? 1.0 : -1.0;
            /* theta1 */
            if (e1 < 0.0 && free1) continue; /* both signs give the same */
            const double factor1 = e1 / divisor1;
            const double c1 = free1 ? cos(v20) : -(X1 * factor1),
                s1 = free1 ? sin(v20) : b22 * factor1;
            const double s2 = w1 * e1;

            /* theta3, type 3: B1[3, 1] and B1[3, 3] */
            const double s3 = v19 * c1 - v18 * s1, c3 = b23 * c1 - b13 * s1;
            const double q3 = atan2(s3, c3);

            /* theta5 */
            const double v21 = T13 * c1 + T23 * s1, v22 = c2 * v21 + T33 * s2,
                v23 = T13 * s1 - T23 * c1, v25 = s2 * v21 - v24;
            const double X5 = c3 * (v2 * v22) + s3 * (v2 * v23) + v3 * v25;
            const double Y5 = c3 * -v23 + s3 * v22;
            const double w5 = sqrt(X5 * X5 + Y5 * Y5);
            const int free5 = w5 <= free_limit;
            const double divisor5 = free5 ? 1.0 : w5;

            /* theta6, type 3: U5[2, 3] and U5[1, 3] */
            const double c6 = c3 * (v3 * v22) + s3 * (v3 * v23) - v2 * v25;

            /* theta7 */
            const double v26 = T12 * s1 - T22 * c1, v27 = T12 * c1 + T22 * s1,
                v28 = c2 * v27 + T32 * s2, v29 = c3 * -v26 + s3 * v28,
                v31 = c3 * (v2 * v28) + s3 * (v2 * v26) + v3 * (s2 * v27 - v30),
                v32 = T11 * s1 - T21 * c1, v33 = T11 * c1 + T21 * s1, v34 = c2 * v33 + T31 * s2,
                v35 = c3 * -v32 + s3 * v34,
                v37 = c3 * (v2 * v34) + s3 * (v2 * v32) + v3 * (s2 * v33 - v36);

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
                const double q7 = atan2(-(c5 * v35 + s5 * v37), -(c5 * v29 + s5 * v31));

                /* joint values */
                const double q6 = dhgen_wrap(atan2(s6, c6) - offset6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6; q[row][6] = q7;
                status[row] = (free1 || free5) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef KUKA_IIWA14_ARM_ANGLE_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    /* 1000 * (longest4 - longest4_apart) * (longest4_apart - shortest4) [m^4] */
    m1 = 1.4473755527432779e-11,
    m2 = 1e-24, /* free_limit^2 */
    m3 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    DHGEN_ENTRIES(dhgen_wide);

    /* theta4 */
    const dhgen_wide wx = T14 - d7 * T13, wy = T24 - d7 * T23, v1 = T34 - d7 * T33 - d1,
        V4 = wx * wx + wy * wy + v1 * v1, D4_squared = (longest4 - V4) * (V4 - shortest4),
        v2 = k1 * (V4 - k2), v3 = k3 * v2, v4 = k1 * dhgen_sqrt_wide(D4_squared), v5 = k3 * v4;

    /* shoulder */
    const dhgen_wide v6 = dhgen_sqrt_wide(V4) * DHGEN_QUOTIENT(1.0, V4), gx = wx * v6, gy = wy * v6,
        gz = v1 * v6, v7 = gy * gy + gx * gx;
    const dhgen_wide_mask upright = v7 <= m2;
    const dhgen_wide v8 = DHGEN_QUOTIENT(1.0, dhgen_pick_wide(upright, dhgen_all_wide(1.0),
        dhgen_sqrt_wide(v7))), v9 = dhgen_pick_wide(upright, dhgen_all_wide(0.0), gy * v8),
        v10 = dhgen_pick_wide(upright, dhgen_all_wide(1.0), -(gx * v8)), v11 = gz * v10,
        v12 = gz * v9, cos_psi = dhgen_cos_wide(free_joints[0]),
        sin_psi = dhgen_sin_wide(free_joints[0]), uz = cos_psi * (gy * v9 - gx * v10),
        ux = v11 * cos_psi + v9 * sin_psi, uy = v10 * sin_psi - v12 * cos_psi,
        nx = v9 * cos_psi - v11 * sin_psi, ny = v10 * cos_psi + v12 * sin_psi, v13 = d5 * v5,
        v14 = d3 + d5 * v3, v15 = v14 * v14 + v13 * v13, arm_ = dhgen_sqrt_wide(v15),
        v16 = DHGEN_QUOTIENT(1.0, v15), v17 = arm_ * v16, v18 = v13 * v17, v19 = v14 * v17,
        v20 = d5 * (d3 * v5),
        side_p = dhgen_pick_wide(-v20 < -solved_limit, dhgen_all_wide(-1.0), dhgen_all_wide(1.0)),
        side_m = dhgen_pick_wide(v20 < -solved_limit, dhgen_all_wide(-1.0), dhgen_all_wide(1.0)),
        v21 = v19 * side_p, v22 = v19 * side_m, v23 = v18 * side_p, v24 = v18 * side_m,
        v25 = gx * v18, v26 = gy * v18, v27 = gy * v19, b22_p = v27 - uy * v23,
        b22_m = v27 + uy * v24;

    /* theta1 */
    const dhgen_wide v28 = gx * v19, X1_p = ux * v23 - v28, v29 = v28 + ux * v24,
        v30 = X1_p * X1_p + b22_p * b22_p, v31 = v29 * v29 + b22_m * b22_m,
        w1_p = dhgen_sqrt_wide(v30), w1_m = dhgen_sqrt_wide(v31), v32 = DHGEN_QUOTIENT(1.0, v30),
        v33 = DHGEN_QUOTIENT(1.0, v31);

    /* theta2 */
    const dhgen_wide v34 = gz * v19, c2_p = uz * v23 - v34, v35 = v34 + uz * v24;

    /* theta3 */
    const dhgen_wide v36 = v32 * (b22_p * (v25 + ux * v21) + X1_p * (v26 + uy * v21)),
        v37 = v33 * (b22_m * (ux * v22 - v25) - v29 * (uy * v22 - v26)), v38 = w1_p * v36,
        v39 = w1_m * v37, v40 = v32 * (b22_p * (nx * side_p) + X1_p * (ny * side_p)),
        v41 = v33 * (b22_m * (nx * side_m) - v29 * (ny * side_m)), v42 = w1_p * v40,
        v43 = w1_m * v41, angle1 = dhgen_atan2_wide(-v36, -v40),
        angle2 = dhgen_atan2_wide(-v37, -v41),
        q3_pmp = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, -v36),
        q3_mmp = angle2 - dhgen_signed_wide(DHGEN_HALF_TURN, -v37);

    /* theta5 */
    const dhgen_wide v44 = w1_p * (v32 * (T23 * b22_p - T13 * X1_p)),
        v45 = w1_m * (v33 * (T23 * b22_m + T13 * v29)), v46 = c2_p * v44 + T33 * w1_p,
        v47 = T33 * w1_m - v35 * v45, v48 = w1_p * (v32 * (T13 * b22_p + T23 * X1_p)),
        v49 = w1_m * (v33 * (T13 * b22_m - T23 * v29)), v50 = arm_ * (v16 * (gz * (T33 * v14))),
        v51 = T33 * v13, v52 = w1_p * v44 - (uz * (arm_ * (v16 * (side_p * v51))) - v50),
        v53 = w1_m * v45 + (v50 + uz * (arm_ * (v16 * (side_m * v51)))),
        X5_p = v5 * v52 - (v42 * (v3 * v46) + v38 * (v3 * v48)),
        v54 = v5 * v53 + (v43 * (v3 * v47) + v39 * (v3 * v49)), Y5_p = v42 * v48 - v38 * v46,
        Y5_m = v43 * v49 - v39 * v47, v55 = X5_p * X5_p + Y5_p * Y5_p,
        v56 = v54 * v54 + Y5_m * Y5_m, w5_p = dhgen_sqrt_wide(v55), w5_m = dhgen_sqrt_wide(v56),
        factor5_p = w5_p * DHGEN_QUOTIENT(1.0, v55), factor5_m = w5_m * DHGEN_QUOTIENT(1.0, v56),
        v57 = X5_p * factor5_p, v58 = v54 * factor5_m, s5_p = Y5_p * factor5_p,
        s5_m = Y5_m * factor5_m, angle3 = dhgen_atan2_wide(Y5_p, -X5_p),
        angle4 = dhgen_atan2_wide(Y5_m, v54),
        q5_ppm = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, Y5_p),
        q5_mpm = angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, Y5_m);

    /* theta7 */
    const dhgen_wide v59 = w1_p * (v32 * (b22_p * T12 + X1_p * T22)),
        v60 = w1_m * (v33 * (b22_m * T12 - v29 * T22)),
        v61 = w1_p * (v32 * (b22_p * T22 - X1_p * T12)),
        v62 = w1_m * (v33 * (b22_m * T22 + v29 * T12)), v63 = c2_p * v61 + w1_p * T32,
        v64 = w1_m * T32 - v35 * v62, v65 = arm_ * (v16 * (gz * (v14 * T32))),
        v66 = w1_p * (v32 * (b22_p * T11 + X1_p * T21)),
        v67 = w1_m * (v33 * (b22_m * T11 - v29 * T21)),
        v68 = w1_p * (v32 * (b22_p * T21 - X1_p * T11)),
        v69 = w1_m * (v33 * (b22_m * T21 + v29 * T11)), v70 = c2_p * v68 + w1_p * T31,
        v71 = w1_m * T31 - v35 * v69, v72 = arm_ * (v16 * (gz * (v14 * T31))), v73 = v13 * T31,
        v74 = v57 * (v42 * v66 - v38 * v70) - s5_p * (v5 * (w1_p * v68 - (uz * (arm_ * (v16 *
            (side_p * v73))) - v72)) - (v42 * (v3 * v70) + v38 * (v3 * v66))),
        v75 = s5_m * (v5 * (w1_m * v69 + (v72 + uz * (arm_ * (v16 * (side_m * v73))))) + (v43 * (v3
            * v71) + v39 * (v3 * v67))) - v58 * (v43 * v67 - v39 * v71), v76 = v13 * T32,
        angle5 = dhgen_atan2_wide(v74, v57 * (v42 * v59 - v38 * v63) - s5_p * (v5 * (w1_p * v61 -
            (uz * (arm_ * (v16 * (side_p * v76))) - v65)) - (v42 * (v3 * v63) + v38 * (v3 * v59)))),
        angle6 = dhgen_atan2_wide(v75, s5_m * (v5 * (w1_m * v62 + (v65 + uz * (arm_ * (v16 * (side_m
            * v76))))) + (v43 * (v3 * v64) + v39 * (v3 * v60))) - v58 * (v43 * v60 - v39 * v64)),
        q7_ppm = angle5 - dhgen_signed_wide(DHGEN_HALF_TURN, v74),
        q7_mpm = angle6 - dhgen_signed_wide(DHGEN_HALF_TURN, v75);

    /* joint values */
    const dhgen_wide angle7 = dhgen_atan2_wide(b22_p, -X1_p), angle8 = dhgen_atan2_wide(b22_m, v29),
        v77 = angle7 - offset1, v78 = angle7 - dhgen_signed_wide(DHGEN_HALF_TURN, b22_p) - offset1,
        v79 = angle8 - offset1, v80 = angle8 - dhgen_signed_wide(DHGEN_HALF_TURN, b22_m) - offset1,
        q1_ppp = dhgen_raised_wide(v77), q1_pmp = dhgen_raised_wide(v78),
        q1_mpp = dhgen_raised_wide(v79), q1_mmp = dhgen_raised_wide(v80),
        angle9 = dhgen_atan2_wide(w1_p, c2_p), angle10 = dhgen_atan2_wide(w1_m, -v35),
        v81 = angle9 - offset2, v82 = offset2 + angle9, v83 = angle10 - offset2,
        v84 = offset2 + angle10, q2_ppp = dhgen_raised_wide(v81),
        q2_pmp = dhgen_only_wide(-v82 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v82,
        q2_mpp = dhgen_raised_wide(v83),
        q2_mmp = dhgen_only_wide(-v84 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v84,
        angle11 = dhgen_atan2_wide(-v4, -v2), v85 = angle11 - offset4, v86 = offset4 + angle11,
        q4_ppp = dhgen_raised_wide(v85),
        q4_mpp = dhgen_only_wide(-v86 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v86,
        angle12 = dhgen_atan2_wide(w5_p, -(v3 * v52 + (v42 * (v5 * v46) + v38 * (v5 * v48)))),
        angle13 = dhgen_atan2_wide(w5_m, v43 * (v5 * v47) + v39 * (v5 * v49) - v3 * v53),
        v87 = angle12 - offset6, v88 = offset6 + angle12, v89 = angle13 - offset6,
        v90 = offset6 + angle13, q6_ppp = dhgen_raised_wide(v87),
        q6_ppm = dhgen_only_wide(-v88 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v88,
        q6_mpp = dhgen_raised_wide(v89),
        q6_mpm = dhgen_only_wide(-v90 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v90,
        v91 = dhgen_exceeds_wide(q4_ppp, joints + 3), v92 = dhgen_exceeds_wide(q4_mpp, joints + 3),
        v93 = dhgen_exceeds_wide(angle3, joints + 4), v94 = dhgen_exceeds_wide(q5_ppm, joints + 4),
        v95 = dhgen_exceeds_wide(angle4, joints + 4), v96 = dhgen_exceeds_wide(q5_mpm, joints + 4),
        v97 = dhgen_exceeds_wide(q6_ppp, joints + 5), v98 = dhgen_exceeds_wide(q6_ppm, joints + 5),
        v99 = dhgen_exceeds_wide(q6_mpp, joints + 5), v100 = dhgen_exceeds_wide(q6_mpm, joints + 5),
        v101 = dhgen_exceeds_wide(angle5, joints + 6),
        v102 = dhgen_exceeds_wide(q7_ppm, joints + 6),
        v103 = dhgen_exceeds_wide(angle6, joints + 6),
        v104 = dhgen_exceeds_wide(q7_mpm, joints + 6),
        v105 = dhgen_maximum_wide(dhgen_exceeds_wide(angle1, joints + 2),
            dhgen_maximum_wide(dhgen_exceeds_wide(q2_ppp, joints + 1), dhgen_maximum_wide(v91,
            dhgen_exceeds_wide(q1_ppp, joints)))),
        v106 = dhgen_maximum_wide(dhgen_exceeds_wide(q3_pmp, joints + 2),
            dhgen_maximum_wide(dhgen_exceeds_wide(q2_pmp, joints + 1), dhgen_maximum_wide(v91,
            dhgen_exceeds_wide(q1_pmp, joints)))),
        v107 = dhgen_maximum_wide(dhgen_exceeds_wide(angle2, joints + 2),
            dhgen_maximum_wide(dhgen_exceeds_wide(q2_mpp, joints + 1), dhgen_maximum_wide(v92,
            dhgen_exceeds_wide(q1_mpp, joints)))),
        v108 = dhgen_maximum_wide(dhgen_exceeds_wide(q3_mmp, joints + 2),
            dhgen_maximum_wide(dhgen_exceeds_wide(q2_mmp, joints + 1), dhgen_maximum_wide(v92,
            dhgen_exceeds_wide(q1_mmp, joints))));

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = angle1; q[3] = q4_ppp; q[4] = angle3; q[5] = q6_ppp;
    q[6] = angle5;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < dhgen_maximum_wide(v101, dhgen_maximum_wide(v97,
        dhgen_maximum_wide(v93, v105))));
    q[7] = q1_ppp; q[8] = q2_ppp; q[9] = angle1; q[10] = q4_ppp; q[11] = q5_ppm; q[12] = q6_ppm;
    q[13] = q7_ppm;
    kind[1] = dhgen_kind_within_wide(q[7], 0.0 < dhgen_maximum_wide(v102, dhgen_maximum_wide(v98,
        dhgen_maximum_wide(v94, v105))));
    q[14] = q1_pmp; q[15] = q2_pmp; q[16] = q3_pmp; q[17] = q4_ppp; q[18] = angle3; q[19] = q6_ppp;
    q[20] = angle5;
    kind[2] = dhgen_kind_within_wide(q[14], 0.0 < dhgen_maximum_wide(v101, dhgen_maximum_wide(v97,
        dhgen_maximum_wide(v93, v106))));
    q[21] = q1_pmp; q[22] = q2_pmp; q[23] = q3_pmp; q[24] = q4_ppp; q[25] = q5_ppm; q[26] = q6_ppm;
    q[27] = q7_ppm;
    kind[3] = dhgen_kind_within_wide(q[21], 0.0 < dhgen_maximum_wide(v102, dhgen_maximum_wide(v98,
        dhgen_maximum_wide(v94, v106))));
    q[28] = q1_mpp; q[29] = q2_mpp; q[30] = angle2; q[31] = q4_mpp; q[32] = angle4; q[33] = q6_mpp;
    q[34] = angle6;
    kind[4] = dhgen_kind_within_wide(q[28], 0.0 < dhgen_maximum_wide(v103, dhgen_maximum_wide(v99,
        dhgen_maximum_wide(v95, v107))));
    q[35] = q1_mpp; q[36] = q2_mpp; q[37] = angle2; q[38] = q4_mpp; q[39] = q5_mpm; q[40] = q6_mpm;
    q[41] = q7_mpm;
    kind[5] = dhgen_kind_within_wide(q[35], 0.0 < dhgen_maximum_wide(v104, dhgen_maximum_wide(v100,
        dhgen_maximum_wide(v96, v107))));
    q[42] = q1_mmp; q[43] = q2_mmp; q[44] = q3_mmp; q[45] = q4_mpp; q[46] = angle4; q[47] = q6_mpp;
    q[48] = angle6;
    kind[6] = dhgen_kind_within_wide(q[42], 0.0 < dhgen_maximum_wide(v103, dhgen_maximum_wide(v99,
        dhgen_maximum_wide(v95, v108))));
    q[49] = q1_mmp; q[50] = q2_mmp; q[51] = q3_mmp; q[52] = q4_mpp; q[53] = q5_mpm; q[54] = q6_mpm;
    q[55] = q7_mpm;
    kind[7] = dhgen_kind_within_wide(q[49], 0.0 < dhgen_maximum_wide(v104, dhgen_maximum_wide(v100,
        dhgen_maximum_wide(v96, v108))));
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11] +
        free_joints[0]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v56 <= m3) | (v31 <= m3) | (v55 <= m3) | (dhgen_abs_wide(D4_squared) <=
        m1) | (v30 <= m3));
}

#if DHGEN_LANES > 1
static const double
    m4 = 0.5; /* 1 / 2 */
/* One regular pose, two signs in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    const dhgen_four e4 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e1 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta4 */
    const double wx = T14 - d7 * T13, wy = T24 - d7 * T23, v1 = T34 - d7 * T33 - d1,
        V4 = wx * wx + wy * wy + v1 * v1, D4_squared = (longest4 - V4) * (V4 - shortest4),
        v2 = k1 * (V4 - k2), v3 = k3 * v2, v4 = k1 * sqrt(D4_squared), v5 = k3 * v4;

    /* shoulder */
    const double v6 = sqrt(V4) * DHGEN_QUOTIENT(1.0, V4), gx = wx * v6, gy = wy * v6, gz = v1 * v6,
        v7 = gy * gy + gx * gx;
    const int upright = v7 <= m2;
    const double v8 = DHGEN_QUOTIENT(1.0, upright ? 1.0 : sqrt(v7)), v9 = upright ? 0.0 : (gy * v8),
        v10 = upright ? 1.0 : (-(gx * v8)), v11 = gz * v10, v12 = gz * v9,
        cos_psi = cos(free_joints[0]), sin_psi = sin(free_joints[0]),
        uz = cos_psi * (gy * v9 - gx * v10), ux = v11 * cos_psi + v9 * sin_psi,
        uy = v10 * sin_psi - v12 * cos_psi, nx = v9 * cos_psi - v11 * sin_psi,
        ny = v10 * cos_psi + v12 * sin_psi, v13 = d5 * v5, v14 = d3 + d5 * v3,
        v15 = v14 * v14 + v13 * v13, arm_ = sqrt(v15), v16 = DHGEN_QUOTIENT(1.0, v15),
        v17 = arm_ * v16, v18 = v13 * v17, v19 = v14 * v17, v20 = d5 * (d3 * v5);
    const dhgen_four side = dhgen_pick_four(-(e4 * v20) < -solved_limit, dhgen_all_four(-1.0),
        dhgen_all_four(1.0)), v21 = v19 * side, v22 = v18 * side;
    const double v23 = gx * v18, v24 = gy * v18, v25 = gy * v19;
    const dhgen_four b22 = v25 - e4 * (uy * v22);

    /* theta1 */
    const double v26 = gx * v19;
    const dhgen_four X1 = e4 * (ux * v22) - v26, v27 = X1 * X1 + b22 * b22,
        w1 = dhgen_sqrt_four(v27), v28 = DHGEN_QUOTIENT(1.0, v27);

    /* theta2 */
    const double v29 = gz * v19;
    const dhgen_four c2 = e4 * (uz * v22) - v29;

    /* theta3 */
    const dhgen_four v30 = v28 * (b22 * (ux * v21 + e4 * v23) + X1 * (uy * v21 + e4 * v24)),
        v31 = w1 * v30, v32 = v28 * (b22 * (nx * side) + X1 * (ny * side)), v33 = w1 * v32,
        v34 = dhgen_signed_four(DHGEN_HALF_TURN, -v30), v35 = m4 * (e1 - 1.0);

    /* theta5 */
    const dhgen_four v36 = w1 * (v28 * (T23 * b22 - T13 * X1)), v37 = c2 * v36 + T33 * w1,
        v38 = w1 * (v28 * (T13 * b22 + T23 * X1));
    const double v39 = arm_ * (v16 * (gz * (T33 * v14)));
    const dhgen_four v40 = w1 * v36 - (uz * (arm_ * (v16 * (side * (v13 * (e4 * T33))))) - v39),
        X5 = e4 * (v5 * v40) - (v33 * (v3 * v37) + v31 * (v3 * v38)), Y5 = v33 * v38 - v31 * v37,
        v41 = X5 * X5 + Y5 * Y5, w5 = dhgen_sqrt_four(v41), factor5 = w5 * DHGEN_QUOTIENT(1.0, v41),
        v42 = X5 * factor5, s5 = Y5 * factor5;

    /* theta7 */
    const dhgen_four v43 = w1 * (v28 * (b22 * T12 + X1 * T22)),
        v44 = w1 * (v28 * (b22 * T22 - X1 * T12)), v45 = c2 * v44 + w1 * T32;
    const double v46 = arm_ * (v16 * (gz * (v14 * T32)));
    const dhgen_four v47 = w1 * (v28 * (b22 * T11 + X1 * T21)),
        v48 = w1 * (v28 * (b22 * T21 - X1 * T11)), v49 = c2 * v48 + w1 * T31;
    const double v50 = arm_ * (v16 * (gz * (v14 * T31)));
    const dhgen_four v51 = v42 * (v33 * v47 - v31 * v49) - s5 * (e4 * (v5 * (w1 * v48 - (uz * (arm_
        * (v16 * (side * (v13 * (e4 * T31))))) - v50))) - (v33 * (v3 * v49) + v31 * (v3 * v47)));

    /* joint values */
    const dhgen_four v52 = dhgen_signed_four(DHGEN_HALF_TURN, b22);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) + 0.0 * (free_joints[0]) <= DHGEN_ORTHONORMAL)
        == 0) | ((v27 <= m3) | (v41 <= m3))) | (unsigned)(fabs(D4_squared) <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-v4, -v4, -v4, -v4),
        dhgen_four_of(-v2, -v2, -v2, -v2)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(-v30, Y5, 0, 5, 2, 7), dhgen_shuffle(-v32, -X5, 0,
            5, 2, 7)),
        ratio3 = dhgen_ratio_four(dhgen_shuffle(w1, w5, 0, 5, 2, 7), dhgen_shuffle(c2, -(v3 * v40 +
            e4 * (v33 * (v5 * v37) + v31 * (v5 * v38))), 0, 5, 2, 7)),
        ratio4 = dhgen_ratio_four(dhgen_shuffle(v51, b22, 0, 5, 2, 7), dhgen_shuffle(v42 * (v33 *
            v43 - v31 * v45) - s5 * (e4 * (v5 * (w1 * v44 - (uz * (arm_ * (v16 * (side * (v13 * (e4
            * T32))))) - v46))) - (v33 * (v3 * v45) + v31 * (v3 * v43))), -X1, 0, 5, 2, 7));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle6 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0), packed2 = dhgen_angle_four(ratio2),
        angle1 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2),
        angle2 = dhgen_shuffle(packed2, packed2, 1, 1, 3, 3), packed3 = dhgen_angle_four(ratio3),
        angle5 = dhgen_shuffle(packed3, packed3, 0, 0, 2, 2),
        angle7 = dhgen_shuffle(packed3, packed3, 1, 1, 3, 3), packed4 = dhgen_angle_four(ratio4),
        angle3 = dhgen_shuffle(packed4, packed4, 0, 0, 2, 2),
        angle4 = dhgen_shuffle(packed4, packed4, 1, 1, 3, 3);
    const dhgen_four q3_p = angle1 + v34 * v35,
        q5_m = angle2 - dhgen_signed_four(DHGEN_HALF_TURN, Y5),
        q7_m = angle3 - dhgen_signed_four(DHGEN_HALF_TURN, v51), v53 = angle4 + v35 * v52 - offset1,
        q1_p = dhgen_raised_four(v53), v54 = e1 * angle5 - offset2, q2_p = dhgen_raised_four(v54),
        v55 = e4 * angle6 - offset4, q4_p = dhgen_raised_four(v55), v56 = angle7 - offset6,
        v57 = offset6 + angle7, q6_p = dhgen_raised_four(v56),
        q6_m = dhgen_only_four(-v57 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v57,
        v58 = dhgen_exceeds_four(q4_p, joints + 3), v59 = dhgen_exceeds_four(angle2, joints + 4),
        v60 = dhgen_exceeds_four(q5_m, joints + 4), v61 = dhgen_exceeds_four(q6_p, joints + 5),
        v62 = dhgen_exceeds_four(q6_m, joints + 5), v63 = dhgen_exceeds_four(angle3, joints + 6),
        v64 = dhgen_exceeds_four(q7_m, joints + 6),
        v65 = dhgen_maximum_four(dhgen_exceeds_four(q3_p, joints + 2),
            dhgen_maximum_four(dhgen_exceeds_four(q2_p, joints + 1), dhgen_maximum_four(v58,
            dhgen_exceeds_four(q1_p, joints))));
    const dhgen_four_mask outside_p = 0.0 < dhgen_maximum_four(v63, dhgen_maximum_four(v61,
        dhgen_maximum_four(v59, v65))),
        outside_m = 0.0 < dhgen_maximum_four(v64, dhgen_maximum_four(v62, dhgen_maximum_four(v60,
            v65)));

    dhgen_store_4(q, q + 14, q + 28, q + 42, q1_p, q2_p, q3_p, q4_p);
    dhgen_store_4(q + 3, q + 17, q + 31, q + 45, q4_p, angle2, q6_p, angle3);
    dhgen_store_4(q + 7, q + 21, q + 35, q + 49, q1_p, q2_p, q3_p, q4_p);
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

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[2] = { 4, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    7, 8, 1, DHGEN_POSE, joints, NULL, 0,
    { 0.7657, 0.7657, 0.7657, 1.0, 1.0, 1.0 }, 0.7656967840735068, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 0, /* follows seed */ NULL, NULL, NULL, NULL,
    kuka_iiwa14_arm_angle_fk, kuka_iiwa14_arm_angle_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_CALLER_GIVES 1
#define DHGEN_NAME(function) kuka_iiwa14_arm_angle_##function
#include "dhgen/functions.h"

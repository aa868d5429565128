/* abb_irb4600: ABB IRB 4600-40/2.55
 *
 * Inverse kinematics, generated from robots/abb_irb4600.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/abb_irb4600.yaml. The formulas and where they come from:
 * abb_irb4600.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 061b107b5feed2ce
 * SPDX-License-Identifier: MIT
 */
#include "abb_irb4600.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(ABB_IRB4600_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(ABB_IRB4600_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef ABB_IRB4600_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    a1 = 0.175, /* x of axis 2 [m] */
    d1 = 0.495, /* z of axis 2 [m] */
    a2 = 1.095, /* z of axis 3 [m] */
    a3 = 0.175, /* z of axis 4 [m] */
    d4 = 1.27, /* x of axis 5 [m] */
    d6 = 0.135, /* x of the home pose [m] */
    free_limit1 = 3.2000238089839356e-12, /* a length that fixes no angle [m] */
    longest3 = 5.650130854134036, /* square of the longest reach [m^2] */
    shortest3 = 0.03496914586596454, /* square of the shortest reach [m^2] */
    longest3_reach = 5.650130854135559, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.03496914586584486, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 5.650130854133884, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.034969145865976506, /* the shortest, where branches merge [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 2.7813, /* 2 * d4 * a2 [m^2] */
    k2 = 0.38325, /* 2 * a3 * a2 [m^2] */
    k3 = 2.84255, /* a2^2 + (a3^2 + d4^2) [m^2] */
    k4 = 0.1268631397825131; /* 1 / (k1^2 + k2^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const abb_irb4600_branches[8] = {
    "back-down-noflip", "back-down-flip", "back-up-noflip", "back-up-flip", "front-up-noflip",
    "front-up-flip", "front-down-noflip", "front-down-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -1.5707963267948966, 2.6179938779914944, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 1.3089969389957472, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.981317007977318, 6.981317007977318, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.181661564992912, 2.0943951023931953, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.981317007977318, 6.981317007977318, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The axes at q = 0: a unit vector along each, and a point of it [m]. */
DHGEN_TABLE double table[6][6] = {
    { 0.0, 0.0, 1.0, 0.0, 0.0, 0.0 },
    { 0.0, 1.0, 0.0, 0.175, 0.0, 0.495 },
    { 0.0, 1.0, 0.0, 0.175, 0.0, 1.5899999999999999 },
    { 1.0, 0.0, 0.0, 0.175, 0.0, 1.765 },
    { 0.0, 1.0, 0.0, 1.445, 0.0, 1.765 },
    { 1.0, 0.0, 0.0, 0.175, 0.0, 1.765 },
};
DHGEN_TABLE double tool[12] = { 0.0, 0.0, 1.0, 1.58, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.765 };
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_AXES, joints, &table[0][0], NULL, NULL, tool };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void abb_irb4600_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * s2, x2_y = s1 * s2, y2_x = c1 * c2,
        y2_y = s1 * c2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = c2 * c3 - s2 * s3, y3_x = y2_x * c3 - x2_x * s3,
        y3_y = y2_y * c3 - x2_y * s3, v1 = s2 * c3 + c2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 + s1 * s4,
        x4_y = x3_y * c4 - c1 * s4, x4_z = x3_z * c4, y4_x = s1 * c4 - x3_x * s4,
        z5_y = c1 * c4 + x3_y * s4, z5_z = x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + y3_x * s5,
        x5_y = x4_y * c5 + y3_y * s5, x5_z = x4_z * c5 - v1 * s5, y5_x = y3_x * c5 - x4_x * s5,
        y5_y = y3_y * c5 - x4_y * s5, v2 = v1 * c5 + x4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = -(x5_x * c6 + y4_x * s6); T[1] = x5_x * s6 - y4_x * c6; T[2] = y5_x;
    T[3] = c1 * a1 + x2_x * a2 + x3_x * a3 + y3_x * d4 + y5_x * d6;
    T[4] = z5_y * s6 - x5_y * c6; T[5] = z5_y * c6 + x5_y * s6; T[6] = y5_y;
    T[7] = s1 * a1 + x2_y * a2 + x3_y * a3 + y3_y * d4 + y5_y * d6;
    T[8] = z5_z * s6 - x5_z * c6; T[9] = z5_z * c6 + x5_z * s6; T[10] = -v2;
    T[11] = d1 + c2 * a2 + x3_z * a3 - v1 * d4 - v2 * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void abb_irb4600_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p2_x = c1 * a1, p2_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * s2, x2_y = s1 * s2, y2_x = c1 * c2,
        y2_y = s1 * c2, p3_x = p2_x + x2_x * a2, p3_y = p2_y + x2_y * a2, p3_z = d1 + c2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 + y2_x * s3,
        x3_y = x2_y * c3 + y2_y * s3, x3_z = c2 * c3 - s2 * s3, y3_x = y2_x * c3 - x2_x * s3,
        y3_y = y2_y * c3 - x2_y * s3, v1 = s2 * c3 + c2 * s3, p4_x = p3_x + x3_x * a3,
        p4_y = p3_y + x3_y * a3, p4_z = p3_z + x3_z * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z5_y = c1 * c4 + x3_y * s4, z5_z = x3_z * s4,
        p5_x = p4_x + y3_x * d4, p5_y = p4_y + y3_y * d4, p5_z = p4_z - v1 * d4,
        z5_x = x3_x * s4 - s1 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), y5_x = y3_x * c5 - (x3_x * c4 + s1 * s4) * s5,
        y5_y = y3_y * c5 - (x3_y * c4 - c1 * s4) * s5, v2 = v1 * c5 + x3_z * c4 * s5,
        J21 = p5_x + y5_x * d6, v3 = p5_y + y5_y * d6, v4 = p5_z - v2 * d6, v5 = v4 - d1,
        v6 = v4 - p3_z, v7 = J21 - p4_x, v8 = v3 - p4_y, v9 = v4 - p4_z, v10 = J21 - p5_x,
        v11 = v3 - p5_y, v12 = v4 - p5_z;
    J[0] = -v3; J[1] = c1 * v5; J[2] = c1 * v6; J[3] = y3_y * v9 + v1 * v8;
    J[4] = z5_y * v12 - z5_z * v11; J[5] = y5_y * v12 + v2 * v11;
    J[6] = J21; J[7] = s1 * v5; J[8] = s1 * v6; J[9] = -(v1 * v7 + y3_x * v9);
    J[10] = z5_z * v10 - z5_x * v12; J[11] = -(v2 * v10 + y5_x * v12);
    J[12] = 0.0; J[13] = -(s1 * (v3 - p2_y) + c1 * (J21 - p2_x));
    J[14] = -(s1 * (v3 - p3_y) + c1 * (J21 - p3_x)); J[15] = y3_x * v8 - y3_y * v7;
    J[16] = z5_x * v11 - z5_y * v10; J[17] = y5_x * v11 - y5_y * v10;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = y3_x; J[22] = z5_x; J[23] = y5_x;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = y3_y; J[28] = z5_y; J[29] = y5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = -v1; J[34] = z5_z; J[35] = -v2;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[2, 4] */
    const double t14 = T14 - d6 * T13;
    const double Y1 = d6 * T23 - T24;
    const double w1 = sqrt(t14 * t14 + Y1 * Y1);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;

    /* theta3, type 6: U1[3, 4] and U1[1, 4] */
    const double t34 = T34 - d6 * T33;
    const double Z1_3 = t34 - d1;
    const double v2 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* back, front */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(seed[0]) : -(t14 * factor1),
            s1 = free1 ? sin(seed[0]) : Y1 * factor1;
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double v1 = w1 * e1 + a1;
        const double N3 = v2 + v1 * v1;
        const double K3 = N3 - k3;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double v3 = k1 * K3, v4 = k2 * K3;

        /* theta4, type 2: U4[2, 3] */
        const double v6 = T13 * c1 + T23 * s1;
        const double Y4 = T23 * c1 - T13 * s1;
        const double v7 = Y4 * Y4;

        /* theta6, type 3: U4[2, 2] and U4[2, 1] */
        const double v8 = T12 * s1 - T22 * c1, v9 = T12 * c1 + T22 * s1, v11 = T11 * s1 - T21 * c1,
            v12 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double D3 = w3 * e3;
            const double s3 = (k2 * D3 - v3) * k4, c3 = k4 * (v4 + k1 * D3);
            const double q3 = atan2(s3, c3);

            /* theta2, type 3: U1[1, 4] and U1[3, 4] */
            const double X1_2 = a2 + (a3 * c3 - d4 * s3);
            const double Y1_2 = d4 * c3 + a3 * s3;
            const double v5 = v1 * X1_2 + Z1_3 * Y1_2;
            const double C2 = Z1_3 * X1_2 - v1 * Y1_2;
            const double w2 = sqrt(v5 * v5 + C2 * C2);
            const double factor2 = 1.0 / w2;
            const double c2 = C2 * factor2, s2 = -(v5 * factor2);
            const double q2 = atan2(s2, c2);

            /* theta4 */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2;
            const double X4 = T33 * c23 + s23 * v6;
            const double w4 = sqrt(X4 * X4 + v7);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[3, 3] and U4[1, 3] */
            const double c5 = c23 * v6 - T33 * s23;

            /* theta6 */
            const double v10 = T32 * c23 + s23 * v9, v13 = T31 * c23 + s23 * v12;

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
                const double c6 = s4 * v10 - c4 * v8, s6 = s4 * v13 - c4 * v11;
                const double q6 = atan2(s6, c6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef ABB_IRB4600_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.00032000238089839356 [m],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    turn1 = 1.4338633792358526, /* atan2(k1, k2) [rad] */
    m1 = 1.0240152378064056e-07, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m3 = 8.528223923621197e-10,
    m4 = 0.4566210045662101, /* k4 * (d4 * k1 + a3 * k2) [m^-1] */
    m5 = 0.20296803652968054, /* d4 * k1 * k3 * k4 + a3 * k2 * k3 * k4 - a2 [m] */
    m6 = 0.3863646734914285, /* a2 * k1 * k4 [m^-1] */
    m7 = 0.053239226662204715, /* a2 * k2 * k4 [m^-1] */
    /* k2 * k4 * (d4 * k1 * k3^2 * k4 + a3 * k2 * k3^2 * k4 - a2 * k3 - d4 * longest3 * shortest3 *
     * k1 * k4 - a3 * longest3 * shortest3 * k2 * k4) [m] */
    m8 = 0.023664836251350022,
    /* k1 * k4 * (d4 * k1 * k3^2 * k4 + a3 * k2 * k3^2 * k4 - a2 * k3 - d4 * longest3 * shortest3 *
     * k1 * k4 - a3 * longest3 * shortest3 * k2 * k4) [m] */
    m9 = 0.17173909736694015,
    m10 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide t14 = T14 - d6 * T13, Y1 = d6 * T23 - T24, v1 = t14 * t14 + Y1 * Y1,
        w1 = dhgen_sqrt_wide(v1), v2 = DHGEN_QUOTIENT(1.0, v1), angle1 = dhgen_atan2_wide(Y1, -t14);

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d6 * T33 - d1, v3 = a1 + w1, v4 = a1 - w1, v5 = Z1_3 * Z1_3,
        N3_p = v5 + v3 * v3, N3_m = v5 + v4 * v4,
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m), angle2 = dhgen_atan2_wide(w3_p, N3_p - k3),
        angle3 = dhgen_atan2_wide(w3_m, N3_m - k3), q3__pp = angle2 - turn1, v6 = turn1 + angle2,
        q3__mp = angle3 - turn1, v7 = turn1 + angle3;

    /* theta2 */
    const dhgen_wide X1_2_p = m4 * N3_p - m5, X1_2_m = m4 * N3_m - m5, v8 = v3 * X1_2_p,
        v9 = v4 * X1_2_m, v10 = m4 * Z1_3, v11 = m4 * -Z1_3, v12 = Z1_3 * X1_2_p,
        v13 = Z1_3 * X1_2_m, factor2_p = DHGEN_QUOTIENT(1.0, N3_p),
        factor2_m = DHGEN_QUOTIENT(1.0, N3_m), v14 = w3_p * (m4 * v3),
        angle4 = dhgen_atan2_wide(-(v8 + w3_p * v10), v12 - v14),
        angle5 = dhgen_atan2_wide(-(v8 + w3_p * v11), v12 + v14),
        angle6 = dhgen_atan2_wide(-(v9 + w3_m * v10), v13 - w3_m * (m4 * v4)),
        angle7 = dhgen_atan2_wide(-(v9 + w3_m * v11), v13 - w3_m * (m4 * -v4));

    /* theta4 */
    const dhgen_wide v15 = m6 * Z1_3, v16 = m7 + m8 * factor2_p, v17 = m7 + m8 * factor2_m,
        v18 = m6 + m9 * factor2_p, v19 = m6 + m9 * factor2_m, v20 = Z1_3 * v16 - v3 * v18,
        v21 = Z1_3 * v17 - v4 * v19, v22 = w3_p * (factor2_p * (v15 + m7 * v3)), c23_pp = v20 + v22,
        c23_pm = v20 - v22, v23 = w3_m * (factor2_m * (v15 + m7 * v4)), c23_mp = v21 + v23,
        c23_mm = v21 - v23, v24 = m7 * Z1_3, v25 = v24 - m6 * v3, v26 = v24 - m6 * v4,
        v27 = Z1_3 * v18 + v3 * v16, v28 = Z1_3 * v19 + v4 * v17,
        s23_pp = w3_p * (factor2_p * v25) - v27, s23_pm = w3_p * (factor2_p * -v25) - v27,
        s23_mp = w3_m * (factor2_m * v26) - v28, s23_mm = w3_m * (factor2_m * -v26) - v28,
        v29 = w1 * (v2 * (T23 * Y1 - T13 * t14)), X4_pp = T33 * c23_pp + s23_pp * v29,
        X4_pm = T33 * c23_pm + s23_pm * v29, X4_mp = T33 * c23_mp - s23_mp * v29,
        X4_mm = T33 * c23_mm - s23_mm * v29, v30 = w1 * (v2 * (T13 * Y1 + t14 * T23)),
        v31 = v30 * v30, v32 = v31 + X4_pp * X4_pp, v33 = v31 + X4_pm * X4_pm,
        v34 = v31 + X4_mp * X4_mp, v35 = v31 + X4_mm * X4_mm,
        angle8 = dhgen_atan2_wide(-v30, -X4_pp), angle9 = dhgen_atan2_wide(-v30, -X4_pm),
        angle10 = dhgen_atan2_wide(v30, -X4_mp), angle11 = dhgen_atan2_wide(v30, -X4_mm),
        v36 = dhgen_signed_wide(DHGEN_HALF_TURN, -v30),
        v37 = dhgen_signed_wide(DHGEN_HALF_TURN, v30);

    /* theta5 */
    const dhgen_wide angle12 = dhgen_atan2_wide(dhgen_sqrt_wide(v32), c23_pp * v29 - T33 * s23_pp),
        angle13 = dhgen_atan2_wide(dhgen_sqrt_wide(v33), c23_pm * v29 - T33 * s23_pm),
        angle14 = dhgen_atan2_wide(dhgen_sqrt_wide(v34), -(c23_mp * v29 + T33 * s23_mp)),
        angle15 = dhgen_atan2_wide(dhgen_sqrt_wide(v35), -(c23_mm * v29 + T33 * s23_mm));

    /* theta6 */
    const dhgen_wide v38 = w1 * (v2 * (t14 * T22 + Y1 * T12)),
        v39 = w1 * (v2 * (Y1 * T22 - t14 * T12)), v40 = w1 * (v2 * (t14 * T21 + Y1 * T11)),
        v41 = w1 * (v2 * (Y1 * T21 - t14 * T11)),
        v42 = X4_pp * v40 - v30 * (c23_pp * T31 + s23_pp * v41),
        v43 = X4_pm * v40 - v30 * (c23_pm * T31 + s23_pm * v41),
        v44 = v30 * (c23_mp * T31 - s23_mp * v41) - X4_mp * v40,
        v45 = v30 * (c23_mm * T31 - s23_mm * v41) - X4_mm * v40,
        angle16 = dhgen_atan2_wide(v42, X4_pp * v38 - v30 * (c23_pp * T32 + s23_pp * v39)),
        angle17 = dhgen_atan2_wide(v43, X4_pm * v38 - v30 * (c23_pm * T32 + s23_pm * v39)),
        angle18 = dhgen_atan2_wide(v44, v30 * (c23_mp * T32 - s23_mp * v39) - X4_mp * v38),
        angle19 = dhgen_atan2_wide(v45, v30 * (c23_mm * T32 - s23_mm * v39) - X4_mm * v38);

    /* joint values */
    const dhgen_wide v46 = dhgen_raised_wide(q3__pp),
        v47 = dhgen_only_wide(-v6 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v6,
        v48 = dhgen_raised_wide(q3__mp),
        v49 = dhgen_only_wide(-v7 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v7,
        v50 = v46 - dhgen_only_wide(dhgen_high(joints + 2) < v46, DHGEN_TURN),
        v51 = v47 - dhgen_only_wide(dhgen_high(joints + 2) < v47, DHGEN_TURN),
        v52 = v48 - dhgen_only_wide(dhgen_high(joints + 2) < v48, DHGEN_TURN),
        v53 = v49 - dhgen_only_wide(dhgen_high(joints + 2) < v49, DHGEN_TURN),
        v54 = dhgen_beyond_wide(v50, joints + 2), v55 = dhgen_beyond_wide(v51, joints + 2),
        v56 = dhgen_beyond_wide(v52, joints + 2), v57 = dhgen_beyond_wide(v53, joints + 2),
        v58 = v46 - dhgen_high(joints + 2), v59 = v47 - dhgen_high(joints + 2),
        v60 = v48 - dhgen_high(joints + 2), v61 = v49 - dhgen_high(joints + 2),
        v62 = dhgen_pick_wide(v58 < v54, v58, v54), v63 = dhgen_pick_wide(v59 < v55, v59, v55),
        v64 = dhgen_pick_wide(v60 < v56, v60, v56), v65 = dhgen_pick_wide(v61 < v57, v61, v57),
        q3_ppp = dhgen_pick_wide(0.0 < v62, v46, v50),
        q3_pmp = dhgen_pick_wide(0.0 < v63, v47, v51),
        q3_mpp = dhgen_pick_wide(0.0 < v64, v48, v52),
        q3_mmp = dhgen_pick_wide(0.0 < v65, v49, v53), q1_ppp = angle1 + (w3_p - w3_p),
        q1_mpp = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, Y1) + (w3_m - w3_m),
        v66 = dhgen_maximum_wide(v62, dhgen_beyond_wide(angle4, joints + 1)),
        v67 = dhgen_maximum_wide(v63, dhgen_beyond_wide(angle5, joints + 1)),
        v68 = dhgen_maximum_wide(v64, dhgen_beyond_wide(angle6, joints + 1)),
        v69 = dhgen_maximum_wide(v65, dhgen_beyond_wide(angle7, joints + 1)),
        excess_ppp = dhgen_maximum_wide(v66, dhgen_beyond_wide(angle12, joints + 4)),
        excess_ppm = dhgen_maximum_wide(v66, dhgen_maximum_wide(dhgen_low(joints + 4) + angle12,
            -(dhgen_high(joints + 4) + angle12))),
        excess_pmp = dhgen_maximum_wide(v67, dhgen_beyond_wide(angle13, joints + 4)),
        excess_pmm = dhgen_maximum_wide(v67, dhgen_maximum_wide(dhgen_low(joints + 4) + angle13,
            -(dhgen_high(joints + 4) + angle13))),
        excess_mpp = dhgen_maximum_wide(v68, dhgen_beyond_wide(angle14, joints + 4)),
        excess_mpm = dhgen_maximum_wide(v68, dhgen_maximum_wide(dhgen_low(joints + 4) + angle14,
            -(dhgen_high(joints + 4) + angle14))),
        excess_mmp = dhgen_maximum_wide(v69, dhgen_beyond_wide(angle15, joints + 4)),
        excess_mmm = dhgen_maximum_wide(v69, dhgen_maximum_wide(dhgen_low(joints + 4) + angle15,
            -(dhgen_high(joints + 4) + angle15)));

    q[0] = q1_ppp; q[1] = angle4; q[2] = q3_ppp; q[3] = angle8; q[4] = angle12; q[5] = angle16;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_ppp);
    q[6] = q1_ppp; q[7] = angle4; q[8] = q3_ppp; q[9] = angle8 - v36; q[10] = -angle12;
    q[11] = angle16 - dhgen_signed_wide(DHGEN_HALF_TURN, v42);
    kind[1] = dhgen_kind_within_wide(q[6], 0.0 < excess_ppm);
    q[12] = q1_ppp; q[13] = angle5; q[14] = q3_pmp; q[15] = angle9; q[16] = angle13;
    q[17] = angle17;
    kind[2] = dhgen_kind_within_wide(q[12], 0.0 < excess_pmp);
    q[18] = q1_ppp; q[19] = angle5; q[20] = q3_pmp; q[21] = angle9 - v36; q[22] = -angle13;
    q[23] = angle17 - dhgen_signed_wide(DHGEN_HALF_TURN, v43);
    kind[3] = dhgen_kind_within_wide(q[18], 0.0 < excess_pmm);
    q[24] = q1_mpp; q[25] = angle6; q[26] = q3_mpp; q[27] = angle10; q[28] = angle14;
    q[29] = angle18;
    kind[4] = dhgen_kind_within_wide(q[24], 0.0 < excess_mpp);
    q[30] = q1_mpp; q[31] = angle6; q[32] = q3_mpp; q[33] = angle10 - v37; q[34] = -angle14;
    q[35] = angle18 - dhgen_signed_wide(DHGEN_HALF_TURN, v44);
    kind[5] = dhgen_kind_within_wide(q[30], 0.0 < excess_mpm);
    q[36] = q1_mpp; q[37] = angle7; q[38] = q3_mmp; q[39] = angle11; q[40] = angle15;
    q[41] = angle19;
    kind[6] = dhgen_kind_within_wide(q[36], 0.0 < excess_mmp);
    q[42] = q1_mpp; q[43] = angle7; q[44] = q3_mmp; q[45] = angle11 - v37; q[46] = -angle15;
    q[47] = angle19 - dhgen_signed_wide(DHGEN_HALF_TURN, v45);
    kind[7] = dhgen_kind_within_wide(q[42], 0.0 < excess_mmm);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v35 <= m10) | (v34 <= m10) | (v33 <= m10) | (v32 <= m10) |
        (dhgen_abs_wide(D3_squared_m) <= m3) | (v1 <= m1) | (dhgen_abs_wide(D3_squared_p) <= m3)) |
        (dhgen_within_slack_wide(excess_mmm) | dhgen_within_slack_wide(excess_mmp) |
        dhgen_within_slack_wide(excess_mpm) | dhgen_within_slack_wide(excess_mpp) |
        dhgen_within_slack_wide(excess_pmm) | dhgen_within_slack_wide(excess_pmp) |
        dhgen_within_slack_wide(excess_ppp) | dhgen_within_slack_wide(excess_ppm));
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
    const double t14 = T14 - d6 * T13, Y1 = d6 * T23 - T24, v1 = t14 * t14 + Y1 * Y1, w1 = sqrt(v1),
        v2 = DHGEN_QUOTIENT(1.0, v1), v3 = copysign(DHGEN_HALF_TURN, Y1);

    /* theta3 */
    const double Z1_3 = T34 - d6 * T33 - d1;
    const dhgen_four v4 = a1 + e1 * w1;
    const double v5 = Z1_3 * Z1_3;
    const dhgen_four N3 = v5 + v4 * v4, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared);

    /* theta2 */
    const dhgen_four X1_2 = m4 * N3 - m5, v6 = v4 * X1_2, v7 = m4 * (e3 * Z1_3), v8 = Z1_3 * X1_2,
        factor2 = DHGEN_QUOTIENT(1.0, N3);

    /* theta4 */
    const double v9 = m6 * Z1_3;
    const dhgen_four v10 = v9 + m7 * v4, v11 = m7 + m8 * factor2, v12 = m6 + m9 * factor2,
        v13 = Z1_3 * v11 - v4 * v12, c23 = v13 + w3 * (factor2 * (e3 * v10));
    const double v14 = m7 * Z1_3;
    const dhgen_four v15 = v14 - m6 * v4, v16 = Z1_3 * v12 + v4 * v11,
        s23 = w3 * (factor2 * (e3 * v15)) - v16;
    const double v17 = w1 * (v2 * (T23 * Y1 - T13 * t14));
    const dhgen_four X4 = T33 * c23 + e1 * (s23 * v17);
    const double v18 = w1 * (v2 * (T13 * Y1 + t14 * T23)), v19 = v18 * v18;
    const dhgen_four v20 = v19 + X4 * X4, v21 = dhgen_signed_four(DHGEN_HALF_TURN, -(e1 * v18));

    /* theta6 */
    const double v22 = w1 * (v2 * (t14 * T22 + Y1 * T12)), v23 = w1 * (v2 * (Y1 * T22 - t14 * T12)),
        v24 = w1 * (v2 * (t14 * T21 + Y1 * T11)), v25 = w1 * (v2 * (Y1 * T21 - t14 * T11));
    const dhgen_four v26 = e1 * (X4 * v24 - v18 * (c23 * T31 + e1 * (s23 * v25)));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) |
        (dhgen_abs_four(D3_squared) <= m3) | (v20 <= m10)) | (unsigned)(v1 <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(w3, dhgen_all_four(Y1), 0, 5,
        2, 3), dhgen_shuffle(N3 - k3, dhgen_all_four(-t14), 0, 5, 2, 3)),
        ratio2 = dhgen_ratio_four(-(v6 + w3 * v7), v8 - w3 * (m4 * (e3 * v4))),
        ratio3 = dhgen_ratio_four(-(e1 * v18), -X4),
        ratio4 = dhgen_ratio_four(v26, e1 * (X4 * v22 - v18 * (c23 * T32 + e1 * (s23 * v23)))),
        ratio5 = dhgen_ratio_four(dhgen_sqrt_four(v20), e1 * (c23 * v17) - T33 * s23);
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle2 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle1 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle3 = dhgen_angle_four(ratio2),
        angle4 = dhgen_angle_four(ratio3), angle6 = dhgen_angle_four(ratio4),
        angle5 = dhgen_angle_four(ratio5);
    const dhgen_four q3_ = e3 * angle2 - turn1, q4_m = angle4 - v21,
        q6_m = angle6 - dhgen_signed_four(DHGEN_HALF_TURN, v26), v27 = dhgen_raised_four(q3_),
        v28 = v27 - dhgen_only_four(dhgen_high(joints + 2) < v27, DHGEN_TURN),
        v29 = dhgen_beyond_four(v28, joints + 2), v30 = v27 - dhgen_high(joints + 2),
        v31 = dhgen_pick_four(v30 < v29, v30, v29), q3_p = dhgen_pick_four(0.0 < v31, v27, v28),
        q1_p = angle1 + v3 * (m2 * (e1 - 1.0)) + (w3 - w3),
        v32 = dhgen_maximum_four(v31, dhgen_beyond_four(angle3, joints + 1)),
        excess_p = dhgen_maximum_four(v32, dhgen_beyond_four(angle5, joints + 4)),
        excess_m = dhgen_maximum_four(v32, dhgen_maximum_four(dhgen_low(joints + 4) + angle5,
            -(dhgen_high(joints + 4) + angle5)));
    const dhgen_four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (dhgen_bits_four((dhgen_within_slack_four(excess_p) | dhgen_within_slack_four(excess_m))))
        return -1;

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, angle3, q3_p, angle4);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, angle5, angle6);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, angle3, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, -angle5, q6_m);
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
DHGEN_TABLE int choosable[2] = { 3, 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.3125, 0.3125, 0.3125, 1.0, 1.0, 1.0 }, 0.31249767492121183, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, abb_irb4600_fk,
    abb_irb4600_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) abb_irb4600_##function
#include "dhgen/functions.h"

/* techman_tm5_900: Techman TM5-900
 *
 * Inverse kinematics, generated from robots/techman_tm5_900.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/techman_tm5_900.yaml. The formulas and where they come from:
 * techman_tm5_900.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 36f531dfb6823f05
 * SPDX-License-Identifier: MIT
 */
#include "techman_tm5_900.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(TECHMAN_TM5_900_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(TECHMAN_TM5_900_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef TECHMAN_TM5_900_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 1.3271500000000003e-13 [m],
 * merge_slack1 = 1.3271500000000003e-14 [m], arm_size1 = 1.3271500000000003 [m]. */
static const double
    d1 = 0.1452, /* joint offset 1 [m] */
    a2 = 0.429, /* link length 2 [m] */
    d3 = 0.1223, /* joint offset 3 [m] */
    a3 = 0.4115, /* link length 3 [m] */
    d5 = 0.106, /* joint offset 5 [m] */
    d6 = 0.11315, /* joint offset 6 [m] */
    least_root1 = 4.196816796692465e-07, /* a root of nothing, by rounding [m] */
    offset1 = 3.141592653589793, /* offset of joint 1 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    near_limit = 0.001, /* a length whose direction is good to few digits */
    longest3 = 0.70644025, /* square of the longest reach [m^2] */
    shortest3 = 0.00030625000000000053, /* square of the shortest reach [m^2] */
    boundary3 = 1.574988146569254e-13, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.7064402499999777, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.000306250000000465, /* the shortest, where branches merge [m^2] */
    longest3_clear = 0.7064402499776906, /* the longest, where blurred branches do [m^2] */
    shortest3_clear = 0.000306250000464503, /* the shortest, where blurred branches do [m^2] */
    offset2 = 1.5707963267948966, /* offset of joint 2 [rad] */
    offset4 = 1.5707963267948966, /* offset of joint 4 [rad] */
    k1 = 0.014957290000000002, /* d3^2 [m^2] */
    k2 = 3.2462089000017624e-14, /* reach_slack1 * (2 * d3 + reach_slack1) [m^2] */
    k3 = 3.246208900000177e-15, /* merge_slack1 * (2 * d3 + merge_slack1) [m^2] */
    k4 = 0.753494329955167, /* 1 / arm_size1 [m^-1] */
    k5 = 0.35337324999999997, /* a2^2 + a3^2 [m^2] */
    k6 = 2.8323236099663807; /* 1 / (2 * a3 * a2) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const techman_tm5_900_branches[8] = {
    "left-noflip-down", "left-noflip-up", "left-flip-down", "left-flip-up", "right-noflip-up",
    "right-noflip-down", "right-flip-up", "right-flip-down",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -4.71238898038469, 4.71238898038469, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.705260340591211, 2.705260340591211, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -4.71238898038469, 4.71238898038469, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 3.141592653589793, 0.1452, 0.0, 1.5707963267948966 },
    { 1.5707963267948966, 0.0, 0.429, 0.0 },
    { 0.0, -0.1223, 0.4115, 0.0 },
    { 1.5707963267948966, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.106, 0.0, 1.5707963267948966 },
    { 0.0, 0.11315, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void techman_tm5_900_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v3 * s3,
        x3_y = x2_y * c3 - v4 * s3, x3_z = s2 * c3 + c2 * s3, v5 = v3 * c3 + x2_x * s3,
        v6 = v4 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, v7 = q[3] + offset4;
    const double c4 = cos(v7), s4 = sin(v7), x4_x = x3_x * c4 - v5 * s4, x4_y = x3_y * c4 - v6 * s4,
        x4_z = x3_z * c4 + y3_z * s4, z4_x = v5 * c4 + x3_x * s4, z4_y = v6 * c4 + x3_y * s4,
        z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + s1 * s5,
        x5_y = x4_y * c5 - c1 * s5, x5_z = x4_z * c5, z5_y = c1 * c5 + x4_y * s5, z5_z = x4_z * s5,
        z5_x = x4_x * s5 - s1 * c5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = z4_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = x2_x * a2 + x3_x * a3 - s1 * d3 + z4_x * d5 + z5_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = z4_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = x2_y * a2 + x3_y * a3 + c1 * d3 + z4_y * d5 + z5_y * d6;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = z4_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 + s2 * a2 + x3_z * a3 + z4_z * d5 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void techman_tm5_900_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, x2_y = s1 * c2, v3 = c1 * s2,
        v4 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v3 * s3,
        x3_y = x2_y * c3 - v4 * s3, x3_z = s2 * c3 + c2 * s3, v5 = v3 * c3 + x2_x * s3,
        v6 = v4 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, p3_z = p2_z + x3_z * a3,
        p3_x = p2_x + x3_x * a3 - s1 * d3, p3_y = p2_y + x3_y * a3 + c1 * d3, v7 = q[3] + offset4;
    const double c4 = cos(v7), s4 = sin(v7), z4_x = v5 * c4 + x3_x * s4, z4_y = v6 * c4 + x3_y * s4,
        z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z5_y = c1 * c5 + (x3_y * c4 - v6 * s4) * s5,
        z5_z = (x3_z * c4 + y3_z * s4) * s5, p5_x = p3_x + z4_x * d5, p5_y = p3_y + z4_y * d5,
        p5_z = p3_z + z4_z * d5, z5_x = (x3_x * c4 - v5 * s4) * s5 - s1 * c5,
        p6_x = p5_x + z5_x * d6, p6_y = p5_y + z5_y * d6, p6_z = p5_z + z5_z * d6, v8 = p6_z - d1,
        v9 = p6_z - p2_z, v10 = p6_x - p3_x, v11 = p6_y - p3_y, v12 = p6_z - p3_z,
        v13 = p6_x - p5_x, v14 = p6_y - p5_y, v15 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(c1 * v8); J[2] = -(c1 * v9); J[3] = -(c1 * v12);
    J[4] = z4_y * v12 - z4_z * v11; J[5] = z5_y * v15 - z5_z * v14;
    J[6] = p6_x; J[7] = -(s1 * v8); J[8] = -(s1 * v9); J[9] = -(s1 * v12);
    J[10] = z4_z * v10 - z4_x * v12; J[11] = z5_z * v13 - z5_x * v15;
    J[12] = 0.0; J[13] = s1 * p6_y + c1 * p6_x; J[14] = s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x);
    J[15] = s1 * v11 + c1 * v10; J[16] = z4_x * v11 - z4_y * v10; J[17] = z5_x * v14 - z5_y * v13;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = s1; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -c1; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = 0.0; J[34] = z4_z; J[35] = z5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1 A6^-1 [3, 4] */
    const double X1 = T13 * d6 - T14;
    const double wy = T24 - d6 * T23;
    const double N1 = X1 * X1 + wy * wy;
    const double D1_squared = N1 - k1;
    const int apart1 = k3 < D1_squared;
    if (!(-k2 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double v1 = (apart1 ? w1 : least_root1) * k4;
    const double inverse1 = 1.0 / (apart1 ? N1 : d3 * sqrt(N1));
    const double v2 = X1 * d3, v3 = wy * d3;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v7 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* left, right */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = inverse1 * (v3 - X1 * D1), s1 = inverse1 * (v2 + wy * D1);

        /* theta6, type 2: U1 A6^-1 [3, 2] */
        const double X6 = T21 * c1 - T11 * s1;
        const double Y6 = T22 * c1 - T12 * s1;
        const double w6 = sqrt(X6 * X6 + Y6 * Y6);
        const int free6 = w6 <= free_limit;
        const double divisor6 = free6 ? 1.0 : w6;
        const int near6 = w6 <= near_limit;

        /* theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1] */
        const double c5 = T23 * c1 - T13 * s1;

        /* theta3 */
        const double v8 = T14 * c1 + T24 * s1, v9 = near6 ? 1.0 : v1;

        /* joint values */
        const double q1 = dhgen_wrap(atan2(s1, c1) - offset1);

        for (int i2 = 0; i2 < 2; i2++) { /* noflip, flip */
            const double e6 = i2 == 0 ? 1.0 : -1.0;
            /* theta6 */
            if (e6 < 0.0 && free6) continue; /* both signs give the same */
            const double factor6 = e6 / divisor6;
            const double v4 = X6 * factor6, v5 = Y6 * factor6;
            const double off6 = near6 ? w6 * fabs(v4 * sin(seed[5]) + v5 * cos(seed[5])) : 1.0;
            const double ahead6 = near6 ? v5 * sin(seed[5]) - v4 * cos(seed[5]) : -1.0;
            const int same6 = near6 && 0.0 < ahead6 && off6 <= free_limit;
            const int held6 = free6 || same6;
            const double c6 = held6 ? cos(seed[5]) : -v4, s6 = held6 ? sin(seed[5]) : v5;
            const double q6 = atan2(s6, c6);
            const double s5 = w6 * e6;

            /* theta5 */
            const double q5 = atan2(s5, c5);

            /* theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1] */
            const double Z1_234 = c6 * T32 + s6 * T31;
            const double s234 = c5 * (c6 * T31 - s6 * T32) + s5 * T33;
            const double theta234 = atan2(s234, -Z1_234);

            /* theta3 */
            const double v6 = d6 * s5;
            const double Z1_3 = v7 - (Z1_234 * d5 + s234 * v6);
            const double Z2_3 = Z1_234 * v6 - s234 * d5 + v8;
            const double N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3;
            const double K3 = N3 - k5;
            const double D3_squared = (longest3 - N3) * (N3 - shortest3);
            const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
            if (!(-boundary3 <= D3_squared * v9)) {
                if (near6) dhgen_lose(DHGEN_NEARLY + 6, D3_squared, q[4 * i1 + 2 * i2], &status[4 *
                    i1 + 2 * i2]);
                if (near6) q[4 * i1 + 2 * i2][1] = atan2(v5, -v4);
                if (free6) dhgen_lose(DHGEN_LOST + 6, D3_squared, q[4 * i1 + 2 * i2], &status[4 * i1
                    + 2 * i2]);
                continue; /* out of reach */
            }
            const double w3 = sqrt(apart3 ? D3_squared : 0.0);
            const double c3 = K3 * k6;

            /* theta2, type 3: U1[2, 4] and U1[1, 4] */
            const double X1_2 = a2 + a3 * c3;
            const double v10 = Z1_3 * X1_2, v11 = Z2_3 * X1_2;

            for (int i3 = 0; i3 < 2; i3++) { /* +, - */
                const double e3 = i3 == 0 ? 1.0 : -1.0;
                /* theta3 */
                if (e3 < 0.0 && (!apart3 || (near6 && !(shortest3_clear < N3 && N3 <
                    longest3_clear))))
                    continue; /* both signs give the same */
                const double s3 = w3 * e3 * k6;
                const double q3 = atan2(s3, c3);

                /* theta2 */
                const double Y1_2 = a3 * s3;
                const double S2 = v10 - Z2_3 * Y1_2;
                const double C2 = v11 + Z1_3 * Y1_2;
                const double w2 = sqrt(S2 * S2 + C2 * C2);
                const double factor2 = 1.0 / w2;
                const double c2 = C2 * factor2, s2 = S2 * factor2;
                const double theta2 = atan2(s2, c2);

                /* joint values */
                const double q2 = dhgen_wrap(theta2 - offset2);
                const double q4 = dhgen_wrap(theta234 - (q3 + theta2) - offset4);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = free6 ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef TECHMAN_TM5_900_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 3.246208900000177e-12, /* 1000 * k3 [m^2] */
    m2 = 9.999999999999999e-09, /* doubt_limit^2 */
    /* 10 * (longest3 - longest3_clear) * (longest3_clear - shortest3) [m^4] */
    m4 = 1.5753409313203573e-10,
    m5 = 1.1655011655011656, /* a3 * k6 [m^-1] */
    m6 = 0.017143065268065267; /* a2 - a3 * k5 * k6 [m] */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide X1 = d6 * T13 - T14, wy = T24 - d6 * T23, N1 = X1 * X1 + wy * wy,
        D1_squared = N1 - k1, w1 = dhgen_sqrt_wide(D1_squared), v1 = k4 * w1,
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (d3 * wy),
        c1_p = v2 - w1 * (X1 * inverse1), c1_m = v2 - w1 * (inverse1 * -X1),
        v3 = inverse1 * (d3 * X1), s1_p = v3 + w1 * (wy * inverse1),
        s1_m = v3 + w1 * (inverse1 * -wy);

    /* theta6 */
    const dhgen_wide X6_p = c1_p * T21 - s1_p * T11, X6_m = c1_m * T21 - s1_m * T11,
        Y6_p = c1_p * T22 - s1_p * T12, Y6_m = c1_m * T22 - s1_m * T12,
        v4 = X6_p * X6_p + Y6_p * Y6_p, v5 = X6_m * X6_m + Y6_m * Y6_m, w6_p = dhgen_sqrt_wide(v4),
        w6_m = dhgen_sqrt_wide(v5), v6 = DHGEN_QUOTIENT(1.0, v4), v7 = DHGEN_QUOTIENT(1.0, v5),
        angle1 = dhgen_atan2_wide(Y6_p, -X6_p), angle2 = dhgen_atan2_wide(Y6_m, -X6_m);

    /* theta5 */
    const dhgen_wide c5_p = T23 * c1_p - T13 * s1_p, c5_m = T23 * c1_m - T13 * s1_m,
        angle3 = dhgen_atan2_wide(w6_p, c5_p), angle4 = dhgen_atan2_wide(w6_m, c5_m);

    /* theta234 */
    const dhgen_wide v8 = v6 * (Y6_p * T31 - X6_p * T32), v9 = v7 * (Y6_m * T31 - X6_m * T32),
        Z1_234_p = w6_p * v8, Z1_234_m = w6_m * v9,
        v10 = T33 - v6 * (c5_p * (X6_p * T31 + Y6_p * T32)),
        v11 = T33 - v7 * (c5_m * (X6_m * T31 + Y6_m * T32)), s234_p = w6_p * v10,
        s234_m = w6_m * v11, angle5 = dhgen_atan2_wide(v10, -v8),
        angle6 = dhgen_atan2_wide(v11, -v9),
        theta234_pm = angle5 - dhgen_signed_wide(DHGEN_HALF_TURN, v10),
        theta234_mm = angle6 - dhgen_signed_wide(DHGEN_HALF_TURN, v11);

    /* theta3 */
    const dhgen_wide v12 = d6 * w6_p, v13 = d6 * w6_m, v14 = T34 - d1, v15 = d5 * Z1_234_p,
        v16 = d5 * Z1_234_m, v17 = s234_p * v12, v18 = s234_m * v13, Z1_3_pp = v14 - (v15 + v17),
        Z1_3_pm = v14 - (v17 - v15), Z1_3_mp = v14 - (v16 + v18), Z1_3_mm = v14 - (v18 - v16),
        v19 = T14 * c1_p + T24 * s1_p, v20 = T14 * c1_m + T24 * s1_m, v21 = Z1_234_p * v12,
        v22 = Z1_234_m * v13, v23 = d5 * s234_p, v24 = d5 * s234_m, Z2_3_pp = v19 + (v21 - v23),
        Z2_3_pm = v19 + (v21 + v23), Z2_3_mp = v20 + (v22 - v24), Z2_3_mm = v20 + (v22 + v24),
        N3_pp = Z1_3_pp * Z1_3_pp + Z2_3_pp * Z2_3_pp,
        N3_pm = Z1_3_pm * Z1_3_pm + Z2_3_pm * Z2_3_pm,
        N3_mp = Z1_3_mp * Z1_3_mp + Z2_3_mp * Z2_3_mp,
        N3_mm = Z1_3_mm * Z1_3_mm + Z2_3_mm * Z2_3_mm,
        D3_squared_pp = (longest3 - N3_pp) * (N3_pp - shortest3),
        D3_squared_pm = (longest3 - N3_pm) * (N3_pm - shortest3),
        D3_squared_mp = (longest3 - N3_mp) * (N3_mp - shortest3),
        D3_squared_mm = (longest3 - N3_mm) * (N3_mm - shortest3),
        w3_pp = dhgen_sqrt_wide(D3_squared_pp), w3_pm = dhgen_sqrt_wide(D3_squared_pm),
        w3_mp = dhgen_sqrt_wide(D3_squared_mp), w3_mm = dhgen_sqrt_wide(D3_squared_mm),
        v25 = w3_pp - w3_pp, v26 = w3_pm - w3_pm, v27 = w3_mp - w3_mp, v28 = w3_mm - w3_mm,
        angle7 = dhgen_atan2_wide(w3_pp, N3_pp - k5), angle8 = dhgen_atan2_wide(w3_pm, N3_pm - k5),
        angle9 = dhgen_atan2_wide(w3_mp, N3_mp - k5), angle10 = dhgen_atan2_wide(w3_mm, N3_mm - k5);

    /* theta2 */
    const dhgen_wide v29 = m6 + m5 * N3_pp, v30 = m6 + m5 * N3_pm, v31 = m6 + m5 * N3_mp,
        v32 = m6 + m5 * N3_mm, v33 = Z1_3_pp * v29, v34 = Z1_3_pm * v30, v35 = Z1_3_mp * v31,
        v36 = Z1_3_mm * v32, v37 = Z2_3_pp * v29, v38 = Z2_3_pm * v30, v39 = Z2_3_mp * v31,
        v40 = Z2_3_mm * v32, v41 = w3_pp * (m5 * Z2_3_pp),
        angle11 = dhgen_atan2_wide(v33 - v41, v37 + w3_pp * (m5 * Z1_3_pp)),
        angle12 = dhgen_atan2_wide(v33 + v41, v37 + w3_pp * (m5 * -Z1_3_pp)),
        v42 = w3_pm * (m5 * Z2_3_pm),
        angle13 = dhgen_atan2_wide(v34 - v42, v38 + w3_pm * (m5 * Z1_3_pm)),
        angle14 = dhgen_atan2_wide(v34 + v42, v38 + w3_pm * (m5 * -Z1_3_pm)),
        v43 = w3_mp * (m5 * Z2_3_mp),
        angle15 = dhgen_atan2_wide(v35 - v43, v39 + w3_mp * (m5 * Z1_3_mp)),
        angle16 = dhgen_atan2_wide(v35 + v43, v39 + w3_mp * (m5 * -Z1_3_mp)),
        v44 = w3_mm * (m5 * Z2_3_mm),
        angle17 = dhgen_atan2_wide(v36 - v44, v40 + w3_mm * (m5 * Z1_3_mm)),
        angle18 = dhgen_atan2_wide(v36 + v44, v40 + w3_mm * (m5 * -Z1_3_mm));

    /* joint values */
    const dhgen_wide angle19 = dhgen_atan2_wide(s1_p, c1_p), v45 = angle19 - offset1,
        angle20 = dhgen_atan2_wide(s1_m, c1_m), v46 = angle20 - offset1,
        q1__p = dhgen_raised_wide(v45), q1__m = dhgen_raised_wide(v46), v47 = angle11 - offset2,
        v48 = angle12 - offset2, v49 = angle13 - offset2, v50 = angle14 - offset2,
        v51 = angle15 - offset2, v52 = angle16 - offset2, v53 = angle17 - offset2,
        v54 = angle18 - offset2, v55 = angle5 - (angle7 + angle11) - offset4,
        v56 = angle5 - (angle12 - angle7) - offset4,
        v57 = theta234_pm - (angle8 + angle13) - offset4,
        v58 = theta234_pm - (angle14 - angle8) - offset4,
        v59 = angle6 - (angle9 + angle15) - offset4, v60 = angle6 - (angle16 - angle9) - offset4,
        v61 = theta234_mm - (angle10 + angle17) - offset4,
        v62 = theta234_mm - (angle18 - angle10) - offset4, v63 = dhgen_centred_wide(v55),
        v64 = dhgen_centred_wide(v56), v65 = dhgen_centred_wide(v57), v66 = dhgen_centred_wide(v58),
        v67 = dhgen_centred_wide(v59), v68 = dhgen_centred_wide(v60), v69 = dhgen_centred_wide(v61),
        v70 = dhgen_centred_wide(v62), excess_pp = dhgen_exceeds_wide(angle7, joints + 2),
        excess_pm = dhgen_exceeds_wide(angle8, joints + 2),
        excess_mp = dhgen_exceeds_wide(angle9, joints + 2),
        excess_mm = dhgen_exceeds_wide(angle10, joints + 2);
    const dhgen_wide_mask outside_ppp = 0.0 < excess_pp, outside_pmp = 0.0 < excess_pm,
        outside_mpp = 0.0 < excess_mp, outside_mmp = 0.0 < excess_mm;
    const dhgen_wide q1_ppp = v25 + q1__p, q1_pmp = v26 + q1__p, q1_mpp = v27 + q1__m,
        q1_mmp = v28 + q1__m, q5_ppp = angle3 + v25, q5_pmp = v26 - angle3, q5_mpp = angle4 + v27,
        q5_mmp = v28 - angle4, q6_ppp = angle1 + v25,
        q6_pmp = v26 + (angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, Y6_p)), q6_mpp = angle2 + v27,
        q6_mmp = v28 + (angle2 - dhgen_signed_wide(DHGEN_HALF_TURN, Y6_m));

    q[0] = q1_ppp; q[1] = dhgen_raised_wide(v47); q[2] = angle7; q[3] = dhgen_raised_wide(v63);
    q[4] = q5_ppp; q[5] = q6_ppp;
    kind[0] = dhgen_kind_within_wide(q[0], outside_ppp);
    q[6] = q1_ppp; q[7] = dhgen_raised_wide(v48); q[8] = -angle7; q[9] = dhgen_raised_wide(v64);
    q[10] = q5_ppp; q[11] = q6_ppp;
    kind[1] = dhgen_kind_within_wide(q[6], outside_ppp);
    q[12] = q1_pmp; q[13] = dhgen_raised_wide(v49); q[14] = angle8; q[15] = dhgen_raised_wide(v65);
    q[16] = q5_pmp; q[17] = q6_pmp;
    kind[2] = dhgen_kind_within_wide(q[12], outside_pmp);
    q[18] = q1_pmp; q[19] = dhgen_raised_wide(v50); q[20] = -angle8; q[21] = dhgen_raised_wide(v66);
    q[22] = q5_pmp; q[23] = q6_pmp;
    kind[3] = dhgen_kind_within_wide(q[18], outside_pmp);
    q[24] = q1_mpp; q[25] = dhgen_raised_wide(v51); q[26] = angle9; q[27] = dhgen_raised_wide(v67);
    q[28] = q5_mpp; q[29] = q6_mpp;
    kind[4] = dhgen_kind_within_wide(q[24], outside_mpp);
    q[30] = q1_mpp; q[31] = dhgen_raised_wide(v52); q[32] = -angle9; q[33] = dhgen_raised_wide(v68);
    q[34] = q5_mpp; q[35] = q6_mpp;
    kind[5] = dhgen_kind_within_wide(q[30], outside_mpp);
    q[36] = q1_mmp; q[37] = dhgen_raised_wide(v53); q[38] = angle10; q[39] = dhgen_raised_wide(v69);
    q[40] = q5_mmp; q[41] = q6_mmp;
    kind[6] = dhgen_kind_within_wide(q[36], outside_mmp);
    q[42] = q1_mmp; q[43] = dhgen_raised_wide(v54); q[44] = -angle10;
    q[45] = dhgen_raised_wide(v70); q[46] = q5_mmp; q[47] = q6_mmp;
    kind[7] = dhgen_kind_within_wide(q[42], outside_mmp);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(v1 * D3_squared_mm) <= m4) | (dhgen_abs_wide(v1 *
        D3_squared_mp) <= m4) | (dhgen_abs_wide(v1 * D3_squared_pm) <= m4) | (dhgen_abs_wide(v1 *
        D3_squared_pp) <= m4) | (v5 <= m2) | (dhgen_abs_wide(D1_squared) <= m1) | (v4 <= m2)) |
        (dhgen_within_slack_wide(excess_mm) | dhgen_within_slack_wide(excess_mp) |
        dhgen_within_slack_wide(excess_pp) | dhgen_within_slack_wide(excess_pm));
}

#if DHGEN_LANES > 1
static const double
    m3 = 0.5; /* 1 / 2 */
/* One regular pose, two signs in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    const dhgen_four e1 = { 1.0, 1.0, -1.0, -1.0 };
    const dhgen_four e6 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double X1 = d6 * T13 - T14, wy = T24 - d6 * T23, N1 = X1 * X1 + wy * wy,
        D1_squared = N1 - k1, w1 = sqrt(D1_squared), v1 = k4 * w1,
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (d3 * wy);
    const dhgen_four c1 = v2 - w1 * (inverse1 * (e1 * X1));
    const double v3 = inverse1 * (d3 * X1);
    const dhgen_four s1 = v3 + w1 * (inverse1 * (e1 * wy));

    /* theta6 */
    const dhgen_four X6 = c1 * T21 - s1 * T11, Y6 = c1 * T22 - s1 * T12, v4 = X6 * X6 + Y6 * Y6,
        w6 = dhgen_sqrt_four(v4), v5 = DHGEN_QUOTIENT(1.0, v4),
        v6 = dhgen_signed_four(DHGEN_HALF_TURN, Y6), v7 = m3 * (e6 - 1.0);

    /* theta5 */
    const dhgen_four c5 = T23 * c1 - T13 * s1;

    /* theta234 */
    const dhgen_four v8 = v5 * (Y6 * T31 - X6 * T32), Z1_234 = w6 * v8,
        v9 = T33 - v5 * (c5 * (X6 * T31 + Y6 * T32)), s234 = w6 * v9,
        v10 = dhgen_signed_four(DHGEN_HALF_TURN, v9);

    /* theta3 */
    const dhgen_four v11 = d6 * w6;
    const double v12 = T34 - d1;
    const dhgen_four v13 = d5 * Z1_234, v14 = s234 * v11, Z1_3 = v12 - (v14 + e6 * v13),
        v15 = T14 * c1 + T24 * s1, v16 = Z1_234 * v11, v17 = d5 * s234,
        Z2_3 = v15 + (v16 - e6 * v17), N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_four(D3_squared),
        v18 = w3 - w3;

    /* theta2 */
    const dhgen_four v19 = m6 + m5 * N3, v20 = Z1_3 * v19, v21 = Z2_3 * v19, v22 = w3 * (m5 * Z2_3);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | (v4 <= m2) |
        (dhgen_abs_four(v1 * D3_squared) <= m4)) | (unsigned)(fabs(D1_squared) <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(Y6, w6, 0, 5, 2, 7),
        dhgen_shuffle(-X6, c5, 0, 5, 2, 7)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(v9, s1, 0, 5, 2, 7), dhgen_shuffle(-v8, c1, 0, 5, 2,
            7)), ratio3 = dhgen_ratio_four(w3, N3 - k5),
        ratio4 = dhgen_ratio_four(v20 - v22, v21 + w3 * (m5 * Z1_3)),
        ratio5 = dhgen_ratio_four(v20 + v22, v21 + w3 * (m5 * -Z1_3));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 3, 3), packed2 = dhgen_angle_four(ratio2),
        angle3 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2),
        angle7 = dhgen_shuffle(packed2, packed2, 1, 1, 3, 3), angle4 = dhgen_angle_four(ratio3),
        angle5 = dhgen_angle_four(ratio4), angle6 = dhgen_angle_four(ratio5);
    const dhgen_four theta234 = angle3 + v7 * v10, v23 = angle7 - offset1,
        q1_ = dhgen_raised_four(v23), v24 = angle5 - offset2, v25 = angle6 - offset2,
        q2_p = dhgen_raised_four(v24), q2_m = dhgen_raised_four(v25),
        v26 = theta234 - (angle4 + angle5) - offset4, v27 = theta234 - (angle6 - angle4) - offset4,
        v28 = dhgen_centred_four(v26), v29 = dhgen_centred_four(v27), q4_p = dhgen_raised_four(v28),
        q4_m = dhgen_raised_four(v29), excess = dhgen_exceeds_four(angle4, joints + 2);
    const dhgen_four_mask outside_p = 0.0 < excess;
    const dhgen_four q1_p = v18 + q1_, q5_p = v18 + e6 * angle2, q6_p = v18 + (angle1 + v6 * v7);
    if (dhgen_bits_four(dhgen_within_slack_four(excess)))
        return -1;

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, q2_p, angle4, q4_p);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, q5_p, q6_p);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, q2_m, -angle4, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, q5_p, q6_p);
    const unsigned long long none1 = (dhgen_bits_four(q1_p != q1_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long outside1 = (dhgen_bits_four(outside_p) * 0x20204040808101ull &
        0x101010101010101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE + (outside1 & ~none1) *
        DHGEN_OUT_OF_LIMITS;
    __builtin_memcpy(status, &kind1, 8);
    return __builtin_popcountll(0x101010101010101ull & ~(none1 | outside1));
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[1] = { 5 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.7535, 0.7535, 0.7535, 1.0, 1.0, 1.0 }, 0.753494329955167, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 1, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 1, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, techman_tm5_900_fk,
    techman_tm5_900_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) techman_tm5_900_##function
#include "dhgen/functions.h"

/* comau_ns16: Comau NS 16 Hand
 *
 * Inverse kinematics, generated from robots/comau_ns16.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/comau_ns16.yaml. The formulas and where they come from:
 * comau_ns16.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 662c5aef5c1d86d9
 * SPDX-License-Identifier: MIT
 */
#include "comau_ns16.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(COMAU_NS16_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(COMAU_NS16_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef COMAU_NS16_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 2.7459999999999996e-13 [m],
 * merge_slack1 = 2.7459999999999994e-14 [m], arm_size1 = 2.7459999999999996 [m]. */
static const double
    d1 = 0.6, /* joint offset 1 [m] */
    a1 = 0.3, /* link length 1 [m] */
    d2 = 0.101, /* joint offset 2 [m] */
    a2 = 0.7, /* link length 2 [m] */
    d3 = 0.101, /* joint offset 3 [m] */
    a3 = 0.185, /* link length 3 [m] */
    d4 = 0.624, /* joint offset 4 [m] */
    d6 = 0.135, /* joint offset 6 [m] */
    free_limit_squared2 = 7.540515999999996e-24, /* square of a length that fixes no angle [m^2] */
    least_root1 = 8.683614454822367e-07, /* a root of nothing, by rounding [m] */
    longest3 = 1.824785920858549, /* square of the longest reach [m^2] */
    shortest3 = 0.00241607914145111, /* square of the shortest reach [m^2] */
    boundary3 = 1.352331582498372e-12, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 1.8247859208584747, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.0024160791414538094, /* the shortest, where branches merge [m^2] */
    offset2 = -1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    offset6 = 3.141592653589793, /* offset of joint 6 [rad] */
    k1 = 0.0, /* d2 - d3 [m] */
    k2 = 7.540515999999998e-26, /* reach_slack1 * (d2 - d3 + reach_slack1) [m^2] */
    k3 = 7.540515999999996e-28, /* merge_slack1 * (d2 - d3 + merge_slack1) [m^2] */
    k4 = 0.36416605972323385, /* 1 / arm_size1 [m^-1] */
    k5 = 0.8735999999999999, /* 2 * d4 * a2 [m^2] */
    k6 = 0.259, /* 2 * a3 * a2 [m^2] */
    k7 = 0.9136009999999999, /* a2^2 + (a3^2 + d4^2) [m^2] */
    k8 = 1.204444941425193; /* 1 / (k5^2 + k6^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const comau_ns16_branches[8] = {
    "front-down-noflip", "front-down-flip", "front-up-noflip", "front-up-flip", "back-up-noflip",
    "back-up-flip", "back-down-noflip", "back-down-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -3.14159, 3.14159, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -0.87266, 1.658, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.967, 1.9198, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.2831853, 6.2831853, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.14159, 3.14159, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.2831853, 6.2831853, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, -0.6, 0.3, 1.5707963267948966 },
    { -1.5707963267948966, -0.101, 0.7, 3.141592653589793 },
    { 1.5707963267948966, -0.101, 0.185, -1.5707963267948966 },
    { 3.141592653589793, -0.624, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 3.141592653589793, -0.135, 0.0, 3.141592653589793 },
};
DHGEN_TABLE double base[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 };
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, base, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void comau_ns16_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = q[1] + offset2;
    const double c2 = cos(v1), s2 = sin(v1), x2_x = c1 * c2, v2 = s1 * c2, y2_x = c1 * s2,
        v3 = s1 * s2, v4 = q[2] + offset3;
    const double c3 = cos(v4), s3 = sin(v4), x3_x = x2_x * c3 + y2_x * s3, v5 = v2 * c3 + v3 * s3,
        x3_z = c2 * s3 - s2 * c3, z3_x = y2_x * c3 - x2_x * s3, z3_y = v2 * s3 - v3 * c3,
        z3_z = c2 * c3 + s2 * s3, v6 = q[3] + offset4;
    const double c4 = cos(v6), s4 = sin(v6), x4_x = x3_x * c4 + s1 * s4, x4_y = c1 * s4 - v5 * c4,
        x4_z = x3_z * c4, v7 = c1 * c4 + v5 * s4, z4_z = x3_z * s4, z4_x = x3_x * s4 - s1 * c4,
        v8 = q[4] + offset5;
    const double c5 = cos(v8), s5 = sin(v8), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = x4_z * c5 + z3_z * s5, z6_x = z3_x * c5 - x4_x * s5,
        z6_y = z3_y * c5 - x4_y * s5, z6_z = z3_z * c5 - x4_z * s5, v9 = q[5] + offset6;
    const double c6 = cos(v9), s6 = sin(v9);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = x5_x * s6 - z4_x * c6; T[2] = z6_x;
    T[3] = c1 * a1 + x2_x * a2 - s1 * d2 + x3_x * a3 + s1 * d3 - z3_x * d4 - -z6_x * d6;
    T[4] = x5_y * c6 - v7 * s6; T[5] = v7 * c6 + x5_y * s6; T[6] = z6_y;
    T[7] = c1 * d3 - (s1 * a1 + v2 * a2 + c1 * d2 + v5 * a3) - z3_y * d4 - -z6_y * d6;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = x5_z * s6 - z4_z * c6; T[10] = z6_z;
    T[11] = d1 - s2 * a2 + x3_z * a3 - z3_z * d4 - -z6_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void comau_ns16_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, v1 = s1 * a1, v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, v3 = s1 * c2, y2_x = c1 * s2,
        v4 = s1 * s2, p2_z = d1 - s2 * a2, p2_x = p1_x + x2_x * a2 - s1 * d2,
        v5 = v1 + v3 * a2 + c1 * d2, v6 = q[2] + offset3;
    const double c3 = cos(v6), s3 = sin(v6), x3_x = x2_x * c3 + y2_x * s3, v7 = v3 * c3 + v4 * s3,
        x3_z = c2 * s3 - s2 * c3, z3_x = y2_x * c3 - x2_x * s3, z3_y = v3 * s3 - v4 * c3,
        z3_z = c2 * c3 + s2 * s3, p3_z = p2_z + x3_z * a3, p3_x = p2_x + x3_x * a3 + s1 * d3,
        p3_y = c1 * d3 - (v5 + v7 * a3), v8 = q[3] + offset4;
    const double c4 = cos(v8), s4 = sin(v8), v9 = c1 * c4 + v7 * s4, z4_z = x3_z * s4,
        p4_x = p3_x - z3_x * d4, p4_y = p3_y - z3_y * d4, p4_z = p3_z - z3_z * d4,
        z4_x = x3_x * s4 - s1 * c4, v10 = q[4] + offset5;
    const double c5 = cos(v10), s5 = sin(v10), z5_x = (x3_x * c4 + s1 * s4) * s5 - z3_x * c5,
        z5_y = (c1 * s4 - v7 * c4) * s5 - z3_y * c5, z5_z = x3_z * c4 * s5 - z3_z * c5,
        p6_x = p4_x - z5_x * d6, p6_y = p4_y - z5_y * d6, p6_z = p4_z - z5_z * d6, v11 = p6_z - d1,
        v12 = p6_z - p2_z, v13 = p6_x - p3_x, v14 = p6_y - p3_y, v15 = p6_z - p3_z,
        v16 = p6_x - p4_x, v17 = p6_y - p4_y, v18 = p6_z - p4_z;
    J[0] = p6_y; J[1] = c1 * v11; J[2] = -(c1 * v12); J[3] = z3_y * v15 - z3_z * v14;
    J[4] = -(v9 * v18 + z4_z * v17); J[5] = z5_y * v18 - z5_z * v17;
    J[6] = -p6_x; J[7] = -(s1 * v11); J[8] = s1 * v12; J[9] = z3_z * v13 - z3_x * v15;
    J[10] = z4_z * v16 - z4_x * v18; J[11] = z5_z * v16 - z5_x * v18;
    J[12] = 0.0; J[13] = s1 * (v1 + p6_y) - c1 * (p6_x - p1_x);
    J[14] = c1 * (p6_x - p2_x) - s1 * (v5 + p6_y); J[15] = z3_x * v14 - z3_y * v13;
    J[16] = z4_x * v17 + v9 * v16; J[17] = z5_x * v17 - z5_y * v16;
    J[18] = 0.0; J[19] = s1; J[20] = -s1; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = c1; J[26] = -c1; J[27] = z3_y; J[28] = -v9; J[29] = z5_y;
    J[30] = -1.0; J[31] = 0.0; J[32] = 0.0; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
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
    const double wy = d6 * T23 - T24;
    const double N1 = X1 * X1 + wy * wy;
    const int free1 = N1 <= free_limit_squared2;
    const double D1_squared = N1 - k1;
    const int apart1 = k3 < D1_squared;
    if (!(-k2 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : k1 * sqrt(N1)));
    const double v1 = X1 * k1, v2 = wy * k1;

    /* theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = d6 * T33 - T34;
    const double Z1_3 = wz + d1;
    const double v3 = Z1_3 * Z1_3, v4 = free1 ? 1.0 : (apart1 ? w1 : least_root1) * k4;

    /* theta4, type 2: U4[3, 3] */
    const double v9 = seed[3] + offset4;

    for (int i1 = 0; i1 < 2; i1++) { /* front, back */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (v2 - X1 * D1),
            s1 = free1 ? sin(seed[0]) : inverse1 * (v1 + wy * D1);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double Z2_3 = D1 - a1;
        const double N3 = v3 + Z2_3 * Z2_3;
        const double K3 = N3 - k7;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= D3_squared * v4)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double v5 = k5 * K3, v6 = k6 * K3;

        /* theta4 */
        const double v7 = T13 * c1 - T23 * s1;
        const double Y4 = T23 * c1 + T13 * s1;
        const double v8 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v10 = T22 * c1 + T12 * s1, v11 = T12 * c1 - T22 * s1,
            v13 = T21 * c1 + T11 * s1, v14 = T11 * c1 - T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double D3 = w3 * e3;
            const double s3 = (v5 + k6 * D3) * k8, c3 = k8 * (v6 - k5 * D3);

            /* theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
            const double X1_2 = a2 + (a3 * c3 + d4 * s3);
            const double Y1_2 = d4 * c3 - a3 * s3;
            const double S2 = Z1_3 * X1_2 - Z2_3 * Y1_2;
            const double C2 = Z2_3 * X1_2 - Z1_3 * -Y1_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const double factor2 = 1.0 / w2;
            const double c2 = C2 * factor2, s2 = S2 * factor2;

            /* theta4 */
            const double c2m3 = c3 * c2 + s3 * s2;
            const double s2m3 = c3 * s2 - s3 * c2;
            const double X4 = T33 * s2m3 - c2m3 * v7;
            const double w4 = sqrt(X4 * X4 + v8);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * c2m3 + s2m3 * v7;

            /* theta6 */
            const double v12 = c2m3 * v11 - T32 * s2m3, v15 = c2m3 * v14 - T31 * s2m3;

            /* joint values */
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);
            const double q3 = dhgen_wrap(atan2(s3, c3) - offset3);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(v9) : -(X4 * factor4),
                    s4 = free4 ? sin(v9) : Y4 * factor4;

                /* theta6 */
                const double s6 = s4 * v15 - c4 * v13, c6 = c4 * v10 - s4 * v12;

                /* joint values */
                const double q4 = dhgen_wrap(atan2(s4, c4) - offset4);
                const double q5 = dhgen_wrap(atan2(-(w4 * e4), c5) - offset5);
                const double q6 = dhgen_wrap(atan2(s6, c6) - offset6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef COMAU_NS16_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    doubt_limit_squared2 = 7.540515999999996e-08, /* square of a length that fixes no angle [m^2] */
    turn1 = -1.2825771957649381, /* atan2(-k5, k6) [rad] */
    m1 = 7.540515999999996e-25, /* 1000 * k3 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 1.355568761630017e-10,
    m3 = 0.7142857142857144, /* k8 * (d4 * k5 + a3 * k6) [m^-1] */
    m4 = 0.047427857142857084, /* a2 - d4 * k5 * k7 * k8 - a3 * k6 * k7 * k8 [m] */
    m5 = 0.21836586788038748, /* a2 * k6 * k8 [m^-1] */
    m6 = 0.7365421705803339, /* a2 * k5 * k8 [m^-1] */
    /* k5 * k8 * (a2 * k7 + d4 * longest3 * shortest3 * k5 * k8 + a3 * longest3 * shortest3 * k6 *
     * k8 - d4 * k5 * k7^2 * k8 - a3 * k6 * k7^2 * k8) [m] */
    m7 = 0.04890566358436353,
    /* k6 * k8 * (a2 * k7 + d4 * longest3 * shortest3 * k5 * k8 + a3 * longest3 * shortest3 * k6 *
     * k8 - d4 * k5 * k7^2 * k8 - a3 * k6 * k7^2 * k8) [m] */
    m8 = 0.01449927526138983,
    m9 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide X1 = d6 * T13 - T14, wy = d6 * T23 - T24, N1 = X1 * X1 + wy * wy,
        D1_squared = N1 - k1, w1 = dhgen_sqrt_wide(D1_squared), inverse1 = DHGEN_QUOTIENT(1.0, N1),
        v1 = inverse1 * (k1 * wy), c1_p = v1 - w1 * (X1 * inverse1),
        c1_m = v1 - w1 * (inverse1 * -X1), v2 = inverse1 * (k1 * X1),
        s1_p = v2 + w1 * (wy * inverse1), s1_m = v2 + w1 * (inverse1 * -wy),
        angle1 = dhgen_atan2_wide(s1_p, c1_p), angle2 = dhgen_atan2_wide(s1_m, c1_m);

    /* theta3 */
    const dhgen_wide Z1_3 = d1 + (d6 * T33 - T34), Z2_3_p = w1 - a1, v3 = a1 + w1, v4 = Z1_3 * Z1_3,
        N3_p = v4 + Z2_3_p * Z2_3_p, N3_m = v4 + v3 * v3,
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), v5 = k4 * w1,
        w3_p = dhgen_sqrt_wide(D3_squared_p), w3_m = dhgen_sqrt_wide(D3_squared_m);

    /* theta2 */
    const dhgen_wide X1_2_p = m4 + m3 * N3_p, X1_2_m = m4 + m3 * N3_m, v6 = Z1_3 * X1_2_p,
        v7 = Z1_3 * X1_2_m, v8 = Z2_3_p * X1_2_p, v9 = v3 * X1_2_m, v10 = m3 * Z1_3,
        factor2_p = DHGEN_QUOTIENT(1.0, N3_p), factor2_m = DHGEN_QUOTIENT(1.0, N3_m);

    /* theta4 */
    const dhgen_wide v11 = m5 * Z1_3, v12 = v11 - m6 * Z2_3_p, v13 = m6 - m7 * factor2_p,
        v14 = m6 - m7 * factor2_m, v15 = m5 - m8 * factor2_p, v16 = m5 - m8 * factor2_m,
        v17 = Z1_3 * v13 + Z2_3_p * v15, v18 = Z1_3 * v14 - v3 * v16,
        c2m3_pp = v17 + w3_p * (factor2_p * v12), c2m3_pm = v17 + w3_p * (factor2_p * -v12),
        v19 = w3_m * (factor2_m * (v11 + m6 * v3)), c2m3_mp = v18 + v19, c2m3_mm = v18 - v19,
        v20 = m6 * Z1_3, v21 = v20 - m5 * v3, v22 = Z1_3 * v15 + Z2_3_p * -v13,
        v23 = Z1_3 * v16 - v3 * -v14, v24 = w3_p * (factor2_p * (v20 + m5 * Z2_3_p)),
        s2m3_pp = v22 - v24, s2m3_pm = v22 + v24, s2m3_mp = v23 - w3_m * (factor2_m * v21),
        s2m3_mm = v23 - w3_m * (factor2_m * -v21), v25 = T13 * c1_p - T23 * s1_p,
        v26 = T13 * c1_m - T23 * s1_m, X4_pp = T33 * s2m3_pp - c2m3_pp * v25,
        X4_pm = T33 * s2m3_pm - c2m3_pm * v25, X4_mp = T33 * s2m3_mp - c2m3_mp * v26,
        X4_mm = T33 * s2m3_mm - c2m3_mm * v26, Y4_p = T23 * c1_p + T13 * s1_p,
        Y4_m = T23 * c1_m + T13 * s1_m, v27 = Y4_p * Y4_p, v28 = Y4_m * Y4_m,
        v29 = v27 + X4_pp * X4_pp, v30 = v27 + X4_pm * X4_pm, v31 = v28 + X4_mp * X4_mp,
        v32 = v28 + X4_mm * X4_mm;

    /* theta6 */
    const dhgen_wide v33 = c1_p * T22 + s1_p * T12, v34 = c1_m * T22 + s1_m * T12,
        v35 = c1_p * T12 - s1_p * T22, v36 = c1_m * T12 - s1_m * T22, v37 = c1_p * T21 + s1_p * T11,
        v38 = c1_m * T21 + s1_m * T11, v39 = c1_p * T11 - s1_p * T21, v40 = c1_m * T11 - s1_m * T21,
        s6_pp = Y4_p * (c2m3_pp * v39 - s2m3_pp * T31) - v37 * -X4_pp,
        s6_pm = Y4_p * (c2m3_pm * v39 - s2m3_pm * T31) - v37 * -X4_pm,
        s6_mp = Y4_m * (c2m3_mp * v40 - s2m3_mp * T31) - v38 * -X4_mp,
        s6_mm = Y4_m * (c2m3_mm * v40 - s2m3_mm * T31) - v38 * -X4_mm;

    /* joint values */
    const dhgen_wide v41 = w3_p * v10,
        angle3 = dhgen_atan2_wide(v6 + w3_p * (m3 * Z2_3_p), v8 - v41), v42 = angle3 - offset2,
        angle4 = dhgen_atan2_wide(v6 + w3_p * (m3 * -Z2_3_p), v8 + v41), v43 = angle4 - offset2,
        v44 = w3_m * (m3 * v3), v45 = w3_m * v10, angle5 = dhgen_atan2_wide(v7 - v44, -(v9 + v45)),
        v46 = angle5 - offset2, angle6 = dhgen_atan2_wide(v7 + v44, v45 - v9),
        v47 = angle6 - offset2, q2_ppp = dhgen_lowered_wide(v42), q2_pmp = dhgen_lowered_wide(v43),
        q2_mpp = dhgen_lowered_wide(v46), q2_mmp = dhgen_lowered_wide(v47),
        angle7 = dhgen_atan2_wide(w3_p, N3_p - k7), angle8 = dhgen_atan2_wide(w3_m, N3_m - k7),
        v48 = angle7 - turn1 - offset3, v49 = offset3 + (turn1 + angle7),
        v50 = angle8 - turn1 - offset3, v51 = offset3 + (turn1 + angle8),
        q3_ppp = dhgen_raised_wide(v48),
        q3_pmp = dhgen_only_wide(-v49 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v49,
        q3_mpp = dhgen_raised_wide(v50),
        q3_mmp = dhgen_only_wide(-v51 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v51,
        angle9 = dhgen_atan2_wide(Y4_p, -X4_pp), angle10 = dhgen_atan2_wide(Y4_p, -X4_pm),
        angle11 = dhgen_atan2_wide(Y4_m, -X4_mp), angle12 = dhgen_atan2_wide(Y4_m, -X4_mm),
        v52 = dhgen_signed_wide(DHGEN_HALF_TURN, Y4_p),
        v53 = dhgen_signed_wide(DHGEN_HALF_TURN, Y4_m), v54 = angle9 - offset4,
        v55 = angle9 - v52 - offset4, v56 = angle10 - offset4, v57 = angle10 - v52 - offset4,
        v58 = angle11 - offset4, v59 = angle11 - v53 - offset4, v60 = angle12 - offset4,
        v61 = angle12 - v53 - offset4,
        angle13 = dhgen_atan2_wide(-dhgen_sqrt_wide(v29), T33 * c2m3_pp + s2m3_pp * v25),
        angle14 = dhgen_atan2_wide(-dhgen_sqrt_wide(v30), T33 * c2m3_pm + s2m3_pm * v25),
        angle15 = dhgen_atan2_wide(-dhgen_sqrt_wide(v31), T33 * c2m3_mp + s2m3_mp * v26),
        angle16 = dhgen_atan2_wide(-dhgen_sqrt_wide(v32), T33 * c2m3_mm + s2m3_mm * v26),
        v62 = angle13 - offset5, v63 = offset5 + angle13, v64 = angle14 - offset5,
        v65 = offset5 + angle14, v66 = angle15 - offset5, v67 = offset5 + angle15,
        v68 = angle16 - offset5, v69 = offset5 + angle16, q5_ppp = dhgen_raised_wide(v62),
        q5_ppm = dhgen_only_wide(-v63 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v63,
        q5_pmp = dhgen_raised_wide(v64),
        q5_pmm = dhgen_only_wide(-v65 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v65,
        q5_mpp = dhgen_raised_wide(v66),
        q5_mpm = dhgen_only_wide(-v67 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v67,
        q5_mmp = dhgen_raised_wide(v68),
        q5_mmm = dhgen_only_wide(-v69 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v69,
        angle17 = dhgen_atan2_wide(s6_pp, v33 * -X4_pp - Y4_p * (c2m3_pp * v35 - s2m3_pp * T32)),
        angle18 = dhgen_atan2_wide(s6_pm, v33 * -X4_pm - Y4_p * (c2m3_pm * v35 - s2m3_pm * T32)),
        angle19 = dhgen_atan2_wide(s6_mp, v34 * -X4_mp - Y4_m * (c2m3_mp * v36 - s2m3_mp * T32)),
        angle20 = dhgen_atan2_wide(s6_mm, v34 * -X4_mm - Y4_m * (c2m3_mm * v36 - s2m3_mm * T32)),
        v70 = angle17 - offset6,
        v71 = angle17 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_pp) - offset6,
        v72 = angle18 - offset6,
        v73 = angle18 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_pm) - offset6,
        v74 = angle19 - offset6,
        v75 = angle19 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_mp) - offset6,
        v76 = angle20 - offset6,
        v77 = angle20 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_mm) - offset6,
        v78 = dhgen_exceeds_wide(angle1, joints), v79 = dhgen_exceeds_wide(angle2, joints),
        q1_ppp = angle1 + (w3_p - w3_p), q1_mpp = angle2 + (w3_m - w3_m),
        v80 = dhgen_maximum_wide(dhgen_beyond_wide(q3_ppp, joints + 2), dhgen_maximum_wide(v78,
            dhgen_beyond_wide(q2_ppp, joints + 1))),
        v81 = dhgen_maximum_wide(dhgen_beyond_wide(q3_pmp, joints + 2), dhgen_maximum_wide(v78,
            dhgen_beyond_wide(q2_pmp, joints + 1))),
        v82 = dhgen_maximum_wide(dhgen_beyond_wide(q3_mpp, joints + 2), dhgen_maximum_wide(v79,
            dhgen_beyond_wide(q2_mpp, joints + 1))),
        v83 = dhgen_maximum_wide(dhgen_beyond_wide(q3_mmp, joints + 2), dhgen_maximum_wide(v79,
            dhgen_beyond_wide(q2_mmp, joints + 1))),
        excess_ppp = dhgen_maximum_wide(v80, dhgen_exceeds_wide(q5_ppp, joints + 4)),
        excess_ppm = dhgen_maximum_wide(v80, dhgen_exceeds_wide(q5_ppm, joints + 4)),
        excess_pmp = dhgen_maximum_wide(v81, dhgen_exceeds_wide(q5_pmp, joints + 4)),
        excess_pmm = dhgen_maximum_wide(v81, dhgen_exceeds_wide(q5_pmm, joints + 4)),
        excess_mpp = dhgen_maximum_wide(v82, dhgen_exceeds_wide(q5_mpp, joints + 4)),
        excess_mpm = dhgen_maximum_wide(v82, dhgen_exceeds_wide(q5_mpm, joints + 4)),
        excess_mmp = dhgen_maximum_wide(v83, dhgen_exceeds_wide(q5_mmp, joints + 4)),
        excess_mmm = dhgen_maximum_wide(v83, dhgen_exceeds_wide(q5_mmm, joints + 4));

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = q3_ppp; q[3] = dhgen_raised_wide(v54); q[4] = q5_ppp;
    q[5] = dhgen_raised_wide(v70);
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_ppp);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = q3_ppp; q[9] = dhgen_raised_wide(v55); q[10] = q5_ppm;
    q[11] = dhgen_raised_wide(v71);
    kind[1] = dhgen_kind_within_wide(q[6], 0.0 < excess_ppm);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = dhgen_raised_wide(v56); q[16] = q5_pmp;
    q[17] = dhgen_raised_wide(v72);
    kind[2] = dhgen_kind_within_wide(q[12], 0.0 < excess_pmp);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = dhgen_raised_wide(v57); q[22] = q5_pmm;
    q[23] = dhgen_raised_wide(v73);
    kind[3] = dhgen_kind_within_wide(q[18], 0.0 < excess_pmm);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_mpp; q[27] = dhgen_raised_wide(v58); q[28] = q5_mpp;
    q[29] = dhgen_raised_wide(v74);
    kind[4] = dhgen_kind_within_wide(q[24], 0.0 < excess_mpp);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_mpp; q[33] = dhgen_raised_wide(v59); q[34] = q5_mpm;
    q[35] = dhgen_raised_wide(v75);
    kind[5] = dhgen_kind_within_wide(q[30], 0.0 < excess_mpm);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_mmp; q[39] = dhgen_raised_wide(v60); q[40] = q5_mmp;
    q[41] = dhgen_raised_wide(v76);
    kind[6] = dhgen_kind_within_wide(q[36], 0.0 < excess_mmp);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_mmp; q[45] = dhgen_raised_wide(v61); q[46] = q5_mmm;
    q[47] = dhgen_raised_wide(v77);
    kind[7] = dhgen_kind_within_wide(q[42], 0.0 < excess_mmm);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D1_squared) <= m1) | (N1 <= doubt_limit_squared2) | (v32
        <= m9) | (v31 <= m9) | (v30 <= m9) | (v29 <= m9) | (dhgen_abs_wide(D3_squared_p * v5) <= m2)
        | (dhgen_abs_wide(D3_squared_m * v5) <= m2)) | (dhgen_within_slack_wide(excess_mmm) |
        dhgen_within_slack_wide(excess_mmp) | dhgen_within_slack_wide(excess_mpm) |
        dhgen_within_slack_wide(excess_mpp) | dhgen_within_slack_wide(excess_pmm) |
        dhgen_within_slack_wide(excess_pmp) | dhgen_within_slack_wide(excess_ppp) |
        dhgen_within_slack_wide(excess_ppm));
}

#if DHGEN_LANES > 1
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
    const double X1 = d6 * T13 - T14, wy = d6 * T23 - T24, N1 = X1 * X1 + wy * wy,
        D1_squared = N1 - k1, w1 = sqrt(D1_squared), inverse1 = DHGEN_QUOTIENT(1.0, N1),
        v1 = inverse1 * (k1 * wy);
    const dhgen_four c1 = v1 - w1 * (inverse1 * (e1 * X1));
    const double v2 = inverse1 * (k1 * X1);
    const dhgen_four s1 = v2 + w1 * (inverse1 * (e1 * wy));

    /* theta3 */
    const double Z1_3 = d1 + (d6 * T33 - T34);
    const dhgen_four Z2_3 = e1 * w1 - a1;
    const double v3 = Z1_3 * Z1_3;
    const dhgen_four N3 = v3 + Z2_3 * Z2_3, D3_squared = (longest3 - N3) * (N3 - shortest3);
    const double v4 = k4 * w1;
    const dhgen_four w3 = dhgen_sqrt_four(D3_squared);

    /* theta2 */
    const dhgen_four X1_2 = m4 + m3 * N3, v5 = Z1_3 * X1_2, v6 = Z2_3 * X1_2, v7 = m3 * (e3 * Z1_3),
        factor2 = DHGEN_QUOTIENT(1.0, N3);

    /* theta4 */
    const double v8 = m5 * Z1_3;
    const dhgen_four v9 = v8 - m6 * Z2_3, v10 = m6 - m7 * factor2, v11 = m5 - m8 * factor2,
        v12 = Z1_3 * v10 + Z2_3 * v11, c2m3 = v12 + w3 * (factor2 * (e3 * v9));
    const double v13 = m6 * Z1_3;
    const dhgen_four v14 = v13 + m5 * Z2_3, v15 = Z1_3 * v11 + Z2_3 * -v10,
        s2m3 = v15 - w3 * (factor2 * (e3 * v14)), v16 = T13 * c1 - T23 * s1,
        X4 = T33 * s2m3 - c2m3 * v16, Y4 = T23 * c1 + T13 * s1, v17 = Y4 * Y4, v18 = v17 + X4 * X4;

    /* theta6 */
    const dhgen_four v19 = c1 * T22 + s1 * T12, v20 = c1 * T12 - s1 * T22,
        v21 = c1 * T21 + s1 * T11, v22 = c1 * T11 - s1 * T21,
        s6 = Y4 * (c2m3 * v22 - s2m3 * T31) - v21 * -X4;

    /* joint values */
    const dhgen_four v25 = dhgen_signed_four(DHGEN_HALF_TURN, Y4);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) |
        (dhgen_abs_four(D3_squared * v4) <= m2) | (v18 <= m9)) | (unsigned)((N1 <=
        doubt_limit_squared2) | (fabs(D1_squared) <= m1)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(s1, w3, 0, 5, 2, 7),
        dhgen_shuffle(c1, N3 - k7, 0, 5, 2, 7)),
        ratio2 = dhgen_ratio_four(v5 + w3 * (m3 * (e3 * Z2_3)), v6 - w3 * v7),
        ratio3 = dhgen_ratio_four(Y4, -X4),
        ratio4 = dhgen_ratio_four(s6, v19 * -X4 - Y4 * (c2m3 * v20 - s2m3 * T32)),
        ratio5 = dhgen_ratio_four(-dhgen_sqrt_four(v18), T33 * c2m3 + s2m3 * v16);
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle3 = dhgen_shuffle(packed1, packed1, 1, 1, 3, 3), angle2 = dhgen_angle_four(ratio2),
        angle4 = dhgen_angle_four(ratio3), angle6 = dhgen_angle_four(ratio4),
        angle5 = dhgen_angle_four(ratio5);
    const dhgen_four v23 = angle2 - offset2, q2_p = dhgen_lowered_four(v23),
        v24 = e3 * angle3 - turn1 - offset3, q3_p = dhgen_raised_four(v24), v26 = angle4 - offset4,
        v27 = angle4 - v25 - offset4, q4_p = dhgen_raised_four(v26), q4_m = dhgen_raised_four(v27),
        v28 = angle5 - offset5, v29 = offset5 + angle5, q5_p = dhgen_raised_four(v28),
        q5_m = dhgen_only_four(-v29 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v29, v30 = angle6 - offset6,
        v31 = angle6 - dhgen_signed_four(DHGEN_HALF_TURN, s6) - offset6,
        q6_p = dhgen_raised_four(v30), q6_m = dhgen_raised_four(v31),
        v32 = dhgen_exceeds_four(angle1, joints), q1_p = angle1 + (w3 - w3),
        v33 = dhgen_maximum_four(dhgen_beyond_four(q3_p, joints + 2), dhgen_maximum_four(v32,
            dhgen_beyond_four(q2_p, joints + 1))),
        excess_p = dhgen_maximum_four(v33, dhgen_exceeds_four(q5_p, joints + 4)),
        excess_m = dhgen_maximum_four(v33, dhgen_exceeds_four(q5_m, joints + 4));
    const dhgen_four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (dhgen_bits_four((dhgen_within_slack_four(excess_p) | dhgen_within_slack_four(excess_m))))
        return -1;

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, q2_p, q3_p, q4_p);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, q5_p, q6_p);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, q2_p, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, q5_m, q6_m);
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
    { 0.3642, 0.3642, 0.3642, 1.0, 1.0, 1.0 }, 0.36416605972323385, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, comau_ns16_fk,
    comau_ns16_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) comau_ns16_##function
#include "dhgen/functions.h"

/* spherical_wrist_all_offsets: Spherical wrist on an arm with every offset
 *
 * Inverse kinematics, generated from robots/spherical_wrist_all_offsets.yaml and
 * templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/spherical_wrist_all_offsets.yaml. The formulas and where they come
 * from: spherical_wrist_all_offsets.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 8351e27252c6f861
 * SPDX-License-Identifier: MIT
 */
#include "spherical_wrist_all_offsets.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(SPHERICAL_WRIST_ALL_OFFSETS_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(SPHERICAL_WRIST_ALL_OFFSETS_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef SPHERICAL_WRIST_ALL_OFFSETS_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 1.7800000000000005e-13 [m],
 * merge_slack1 = 1.7800000000000004e-14 [m], arm_size1 = 1.7800000000000005 [m]. */
static const double
    d1 = 0.5, /* joint offset 1 [m] */
    a1 = 0.12, /* link length 1 [m] */
    d2 = 0.13, /* joint offset 2 [m] */
    a2 = 0.43, /* link length 2 [m] */
    d3 = 0.06, /* joint offset 3 [m] */
    a3 = 0.09, /* link length 3 [m] */
    d4 = 0.38, /* joint offset 4 [m] */
    d6 = 0.07, /* joint offset 6 [m] */
    least_root1 = 5.628854235099716e-07, /* a root of nothing, by rounding [m] */
    longest3 = 0.6732407360639862, /* square of the longest reach [m^2] */
    shortest3 = 0.0015592639360138612, /* square of the shortest reach [m^2] */
    boundary3 = 1.9612336995515177e-13, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.673240736063957, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.001559263936015267, /* the shortest, where branches merge [m^2] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.07, /* d2 - d3 [m] */
    k2 = 0.004900000000000001, /* k1^2 [m^2] */
    k3 = 2.4920000000031693e-14, /* reach_slack1 * (2 * k1 + reach_slack1) [m^2] */
    k4 = 2.4920000000003178e-15, /* merge_slack1 * (2 * k1 + merge_slack1) [m^2] */
    k5 = 0.5617977528089886, /* 1 / arm_size1 [m^-1] */
    k6 = 0.3268, /* 2 * d4 * a2 [m^2] */
    k7 = 0.0774, /* 2 * a3 * a2 [m^2] */
    k8 = 0.3374, /* a2^2 + (a3^2 + d4^2) [m^2] */
    k9 = 8.866112830151877; /* 1 / (k6^2 + k7^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const spherical_wrist_all_offsets_branches[8] = {
    "right-down-noflip", "right-down-flip", "right-up-noflip", "right-up-flip", "left-up-noflip",
    "left-up-flip", "left-down-noflip", "left-down-flip",
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
    { 0.0, 0.5, 0.12, -1.5707963267948966 },
    { 0.0, 0.13, 0.43, 0.0 },
    { 0.0, -0.06, 0.09, 1.5707963267948966 },
    { 0.0, 0.38, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.07, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void spherical_wrist_all_offsets_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, z3_x = v1 * c3 + x2_x * s3,
        z3_y = v2 * c3 + x2_y * s3, y4_z = s2 * s3 - c2 * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - s1 * s4,
        x4_y = x3_y * c4 + c1 * s4, v4 = v3 * c4, v5 = s1 * c4 + x3_x * s4,
        z4_y = c1 * c4 - x3_y * s4, z4_z = v3 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - z3_x * s5,
        x5_y = x4_y * c5 - z3_y * s5, x5_z = y4_z * s5 - v4 * c5, z5_x = z3_x * c5 + x4_x * s5,
        z5_y = z3_y * c5 + x4_y * s5, v6 = y4_z * c5 + v4 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - v5 * s6; T[1] = -(v5 * c6 + x5_x * s6); T[2] = z5_x;
    T[3] = c1 * a1 + x2_x * a2 - s1 * d2 + x3_x * a3 + s1 * d3 + z3_x * d4 + z5_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = z4_y * c6 - x5_y * s6; T[6] = z5_y;
    T[7] = s1 * a1 + x2_y * a2 + c1 * d2 + x3_y * a3 - c1 * d3 + z3_y * d4 + z5_y * d6;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = z4_z * c6 - x5_z * s6; T[10] = -v6;
    T[11] = d1 - s2 * a2 - v3 * a3 + -y4_z * d4 - v6 * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void spherical_wrist_all_offsets_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), p1_x = c1 * a1, p1_y = s1 * a1;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_z = d1 - s2 * a2, p2_x = p1_x + x2_x * a2 - s1 * d2,
        p2_y = p1_y + x2_y * a2 + c1 * d2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, v3 = s2 * c3 + c2 * s3, z3_x = v1 * c3 + x2_x * s3,
        z3_y = v2 * c3 + x2_y * s3, y4_z = s2 * s3 - c2 * c3, p3_z = p2_z - v3 * a3,
        p3_x = p2_x + x3_x * a3 + s1 * d3, p3_y = p2_y + x3_y * a3 - c1 * d3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), v4 = s1 * c4 + x3_x * s4,
        z4_y = c1 * c4 - x3_y * s4, z4_z = v3 * s4, p4_x = p3_x + z3_x * d4,
        p4_y = p3_y + z3_y * d4, p4_z = p3_z + -y4_z * d4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z5_x = z3_x * c5 + (x3_x * c4 - s1 * s4) * s5,
        z5_y = z3_y * c5 + (x3_y * c4 + c1 * s4) * s5, v5 = y4_z * c5 + v3 * c4 * s5,
        p6_x = p4_x + z5_x * d6, p6_y = p4_y + z5_y * d6, p6_z = p4_z - v5 * d6, v6 = p6_z - d1,
        v7 = p6_z - p2_z, v8 = p6_x - p3_x, v9 = p6_y - p3_y, v10 = p6_z - p3_z, v11 = p6_x - p4_x,
        v12 = p6_y - p4_y, v13 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = c1 * v6; J[2] = c1 * v7; J[3] = z3_y * v10 - -y4_z * v9;
    J[4] = z4_y * v13 - z4_z * v12; J[5] = z5_y * v13 + v5 * v12;
    J[6] = p6_x; J[7] = s1 * v6; J[8] = s1 * v7; J[9] = -y4_z * v8 - z3_x * v10;
    J[10] = z4_z * v11 + v4 * v13; J[11] = -(v5 * v11 + z5_x * v13);
    J[12] = 0.0; J[13] = -(s1 * (p6_y - p1_y) + c1 * (p6_x - p1_x));
    J[14] = -(s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x)); J[15] = z3_x * v9 - z3_y * v8;
    J[16] = -(v4 * v12 + z4_y * v11); J[17] = z5_x * v12 - z5_y * v11;
    J[18] = 0.0; J[19] = -s1; J[20] = -s1; J[21] = z3_x; J[22] = -v4; J[23] = z5_x;
    J[24] = 0.0; J[25] = c1; J[26] = c1; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = -y4_z; J[34] = z4_z; J[35] = -v5;
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
    const double N1 = wx * wx + Y1 * Y1;
    const double D1_squared = N1 - k2;
    const int apart1 = k4 < D1_squared;
    if (!(-k3 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double v1 = (apart1 ? w1 : least_root1) * k5;
    const double inverse1 = 1.0 / (apart1 ? N1 : k1 * sqrt(N1));
    const double v2 = wx * k1, v3 = Y1 * k1;

    /* theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = T34 - d6 * T33;
    const double Z1_3 = wz - d1;
    const double v5 = Z1_3 * Z1_3;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = -(inverse1 * (v3 + wx * D1)), s1 = inverse1 * (Y1 * D1 - v2);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double v4 = D1 + a1;
        const double N3 = v5 + v4 * v4;
        const double K3 = N3 - k8;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(-boundary3 <= v1 * D3_squared)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double v6 = k6 * K3, v7 = k7 * K3;

        /* theta4, type 2: U4[3, 3] */
        const double v9 = T13 * c1 + T23 * s1;
        const double Y4 = T13 * s1 - T23 * c1;
        const double v10 = Y4 * Y4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v11 = T12 * s1 - T22 * c1, v12 = T12 * c1 + T22 * s1,
            v14 = T11 * s1 - T21 * c1, v15 = T11 * c1 + T21 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double D3 = w3 * e3;
            const double s3 = (v6 + k7 * D3) * k9, c3 = k9 * (v7 - k6 * D3);
            const double q3 = atan2(s3, c3);

            /* theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4] */
            const double X1_2 = d4 * c3 - a3 * s3;
            const double Y1_2 = a2 + (a3 * c3 + d4 * s3);
            const double v8 = v4 * X1_2 + Z1_3 * Y1_2;
            const double C2 = Z1_3 * X1_2 - v4 * Y1_2;
            const double w2 = sqrt(v8 * v8 + C2 * C2);
            const double factor2 = 1.0 / w2;
            const double c2 = C2 * factor2, s2 = -(v8 * factor2);
            const double q2 = atan2(s2, c2);

            /* theta4 */
            const double c23 = c3 * c2 - s3 * s2, s23 = c3 * s2 + s3 * c2;
            const double X4 = c23 * v9 - T33 * s23;
            const double w4 = sqrt(X4 * X4 + v10);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * c23 + s23 * v9;

            /* theta6 */
            const double v13 = c23 * v12 - T32 * s23, v16 = c23 * v15 - T31 * s23;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : Y4 * factor4;
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e4), c5);

                /* theta6 */
                const double q6 = atan2(-(c4 * v14 + s4 * v16), -(c4 * v11 + s4 * v13));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = free4 ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef SPHERICAL_WRIST_ALL_OFFSETS_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    turn1 = -1.3382393849899876, /* atan2(-k6, k7) [rad] */
    m1 = 2.4920000000003177e-12, /* 1000 * k4 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 1.96123369955058e-11,
    m3 = 1.1627906976744187, /* k9 * (d4 * k6 + a3 * k7) [m^-1] */
    m4 = 0.03767441860465117, /* a2 - d4 * k6 * k8 * k9 - a3 * k7 * k8 * k9 [m] */
    m5 = 0.29508196721311475, /* a2 * k7 * k9 [m^-1] */
    m6 = 1.2459016393442623, /* a2 * k6 * k9 [m^-1] */
    /* k6 * k9 * (a2 * k8 + d4 * longest3 * shortest3 * k6 * k9 + a3 * longest3 * shortest3 * k7 *
     * k9 - d4 * k6 * k8^2 * k9 - a3 * k7 * k8^2 * k9) [m] */
    m7 = 0.04036721311475411,
    /* k7 * k9 * (a2 * k8 + d4 * longest3 * shortest3 * k6 * k9 + a3 * longest3 * shortest3 * k7 *
     * k9 - d4 * k6 * k8^2 * k9 - a3 * k7 * k8^2 * k9) [m] */
    m8 = 0.00956065573770492,
    m9 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide wx = T14 - d6 * T13, Y1 = d6 * T23 - T24, N1 = wx * wx + Y1 * Y1,
        D1_squared = N1 - k2, w1 = dhgen_sqrt_wide(D1_squared), v1 = k5 * w1,
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (k1 * Y1),
        v3 = v2 + w1 * (wx * inverse1), v4 = v2 + w1 * (inverse1 * -wx), v5 = inverse1 * (k1 * wx),
        s1_p = w1 * (Y1 * inverse1) - v5, s1_m = w1 * (inverse1 * -Y1) - v5;

    /* theta3 */
    const dhgen_wide Z1_3 = T34 - d6 * T33 - d1, v6 = a1 + w1, v7 = a1 - w1, v8 = Z1_3 * Z1_3,
        N3_p = v8 + v6 * v6, N3_m = v8 + v7 * v7,
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3),
        D3_squared_m = (longest3 - N3_m) * (N3_m - shortest3), w3_p = dhgen_sqrt_wide(D3_squared_p),
        w3_m = dhgen_sqrt_wide(D3_squared_m), angle1 = dhgen_atan2_wide(w3_p, N3_p - k8),
        angle2 = dhgen_atan2_wide(w3_m, N3_m - k8), q3__pp = angle1 - turn1, v9 = turn1 + angle1,
        q3__mp = angle2 - turn1, v10 = turn1 + angle2;

    /* theta2 */
    const dhgen_wide v11 = Z1_3 * (m4 + m3 * N3_p), v12 = Z1_3 * (m4 + m3 * N3_m),
        factor2_p = DHGEN_QUOTIENT(1.0, N3_p), factor2_m = DHGEN_QUOTIENT(1.0, N3_m),
        v13 = v6 * (m3 + m4 * factor2_p), v14 = v7 * (m3 + m4 * factor2_m), v15 = w3_p * (m3 * v6),
        angle3 = dhgen_atan2_wide(-(factor2_p * (v11 - v15)), -(v13 + w3_p * (m3 * (Z1_3 *
            factor2_p)))),
        angle4 = dhgen_atan2_wide(-(factor2_p * (v11 + v15)), -(v13 + w3_p * (m3 * (-Z1_3 *
            factor2_p)))),
        angle5 = dhgen_atan2_wide(-(factor2_m * (v12 - w3_m * (m3 * v7))), -(v14 + w3_m * (m3 *
            (Z1_3 * factor2_m)))),
        angle6 = dhgen_atan2_wide(-(factor2_m * (v12 - w3_m * (m3 * -v7))), -(v14 + w3_m * (m3 *
            (-Z1_3 * factor2_m))));

    /* theta4 */
    const dhgen_wide v16 = m5 * Z1_3, v17 = m6 - m7 * factor2_p, v18 = m6 - m7 * factor2_m,
        v19 = m8 * factor2_p - m5, v20 = m8 * factor2_m - m5, v21 = Z1_3 * v17 + v6 * v19,
        v22 = Z1_3 * v18 + v7 * v20, v23 = w3_p * (factor2_p * (v16 + m6 * v6)), c23_pp = v21 + v23,
        c23_pm = v21 - v23, v24 = w3_m * (factor2_m * (v16 + m6 * v7)), c23_mp = v22 + v24,
        c23_mm = v22 - v24, v25 = m6 * Z1_3, v26 = v25 - m5 * v6, v27 = v25 - m5 * v7,
        v28 = Z1_3 * v19 + v6 * -v17, v29 = Z1_3 * v20 + v7 * -v18,
        s23_pp = v28 + w3_p * (factor2_p * v26), s23_pm = v28 + w3_p * (factor2_p * -v26),
        s23_mp = v29 + w3_m * (factor2_m * v27), s23_mm = v29 + w3_m * (factor2_m * -v27),
        v30 = T23 * s1_p - T13 * v3, v31 = T23 * s1_m - T13 * v4,
        X4_pp = c23_pp * v30 - T33 * s23_pp, X4_pm = c23_pm * v30 - T33 * s23_pm,
        X4_mp = c23_mp * v31 - T33 * s23_mp, X4_mm = c23_mm * v31 - T33 * s23_mm,
        Y4_p = T13 * s1_p + T23 * v3, Y4_m = T13 * s1_m + T23 * v4, v32 = Y4_p * Y4_p,
        v33 = Y4_m * Y4_m, v34 = v32 + X4_pp * X4_pp, v35 = v32 + X4_pm * X4_pm,
        v36 = v33 + X4_mp * X4_mp, v37 = v33 + X4_mm * X4_mm,
        angle7 = dhgen_atan2_wide(Y4_p, -X4_pp), angle8 = dhgen_atan2_wide(Y4_p, -X4_pm),
        angle9 = dhgen_atan2_wide(Y4_m, -X4_mp), angle10 = dhgen_atan2_wide(Y4_m, -X4_mm),
        v38 = dhgen_signed_wide(DHGEN_HALF_TURN, Y4_p),
        v39 = dhgen_signed_wide(DHGEN_HALF_TURN, Y4_m);

    /* theta5 */
    const dhgen_wide angle11 = dhgen_atan2_wide(-dhgen_sqrt_wide(v34), T33 * c23_pp + s23_pp * v30),
        angle12 = dhgen_atan2_wide(-dhgen_sqrt_wide(v35), T33 * c23_pm + s23_pm * v30),
        angle13 = dhgen_atan2_wide(-dhgen_sqrt_wide(v36), T33 * c23_mp + s23_mp * v31),
        angle14 = dhgen_atan2_wide(-dhgen_sqrt_wide(v37), T33 * c23_mm + s23_mm * v31);

    /* theta6 */
    const dhgen_wide v40 = s1_p * T12 + v3 * T22, v41 = s1_m * T12 + v4 * T22,
        v42 = s1_p * T22 - v3 * T12, v43 = s1_m * T22 - v4 * T12, v44 = s1_p * T11 + v3 * T21,
        v45 = s1_m * T11 + v4 * T21, v46 = s1_p * T21 - v3 * T11, v47 = s1_m * T21 - v4 * T11,
        angle15 = dhgen_atan2_wide(-(-X4_pp * v44 + Y4_p * (c23_pp * v46 - s23_pp * T31)), -(-X4_pp
            * v40 + Y4_p * (c23_pp * v42 - s23_pp * T32))),
        angle16 = dhgen_atan2_wide(-(-X4_pm * v44 + Y4_p * (c23_pm * v46 - s23_pm * T31)), -(-X4_pm
            * v40 + Y4_p * (c23_pm * v42 - s23_pm * T32))),
        angle17 = dhgen_atan2_wide(-(-X4_mp * v45 + Y4_m * (c23_mp * v47 - s23_mp * T31)), -(-X4_mp
            * v41 + Y4_m * (c23_mp * v43 - s23_mp * T32))),
        angle18 = dhgen_atan2_wide(-(-X4_mm * v45 + Y4_m * (c23_mm * v47 - s23_mm * T31)), -(-X4_mm
            * v41 + Y4_m * (c23_mm * v43 - s23_mm * T32)));

    /* joint values */
    const dhgen_wide q3_ppp = dhgen_lowered_wide(q3__pp),
        q3_pmp = dhgen_only_wide(DHGEN_HALF_TURN < -v9, -DHGEN_TURN) - v9,
        q3_mpp = dhgen_lowered_wide(q3__mp),
        q3_mmp = dhgen_only_wide(DHGEN_HALF_TURN < -v10, -DHGEN_TURN) - v10,
        angle19 = dhgen_atan2_wide(s1_p, -v3), q1_ppp = angle19 + (w3_p - w3_p),
        angle20 = dhgen_atan2_wide(s1_m, -v4), q1_mpp = angle20 + (w3_m - w3_m);

    q[0] = q1_ppp; q[1] = angle3; q[2] = q3_ppp; q[3] = angle7; q[4] = angle11; q[5] = angle15;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_ppp; q[7] = angle3; q[8] = q3_ppp; q[9] = angle7 - v38; q[10] = -angle11;
    q[11] = angle15 - dhgen_signed_wide(DHGEN_HALF_TURN, -(-X4_pp * v44 + Y4_p * (c23_pp * v46 -
        s23_pp * T31)));
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_ppp; q[13] = angle4; q[14] = q3_pmp; q[15] = angle8; q[16] = angle12;
    q[17] = angle16;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_ppp; q[19] = angle4; q[20] = q3_pmp; q[21] = angle8 - v38; q[22] = -angle12;
    q[23] = angle16 - dhgen_signed_wide(DHGEN_HALF_TURN, -(-X4_pm * v44 + Y4_p * (c23_pm * v46 -
        s23_pm * T31)));
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = angle5; q[26] = q3_mpp; q[27] = angle9; q[28] = angle13;
    q[29] = angle17;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = angle5; q[32] = q3_mpp; q[33] = angle9 - v39; q[34] = -angle13;
    q[35] = angle17 - dhgen_signed_wide(DHGEN_HALF_TURN, -(-X4_mp * v45 + Y4_m * (c23_mp * v47 -
        s23_mp * T31)));
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mpp; q[37] = angle6; q[38] = q3_mmp; q[39] = angle10; q[40] = angle14;
    q[41] = angle18;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mpp; q[43] = angle6; q[44] = q3_mmp; q[45] = angle10 - v39; q[46] = -angle14;
    q[47] = angle18 - dhgen_signed_wide(DHGEN_HALF_TURN, -(-X4_mm * v45 + Y4_m * (c23_mm * v47 -
        s23_mm * T31)));
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v37 <= m9) | (v36 <= m9) | (v35 <= m9) | (v34 <= m9) |
        (dhgen_abs_wide(v1 * D3_squared_m) <= m2) | (dhgen_abs_wide(D1_squared) <= m1) |
        (dhgen_abs_wide(v1 * D3_squared_p) <= m2));
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
    const double wx = T14 - d6 * T13, Y1 = d6 * T23 - T24, N1 = wx * wx + Y1 * Y1,
        D1_squared = N1 - k2, w1 = sqrt(D1_squared), v1 = k5 * w1,
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (k1 * Y1);
    const dhgen_four v3 = v2 + w1 * (inverse1 * (e1 * wx));
    const double v4 = inverse1 * (k1 * wx);
    const dhgen_four s1 = w1 * (inverse1 * (e1 * Y1)) - v4;

    /* theta3 */
    const double Z1_3 = T34 - d6 * T33 - d1;
    const dhgen_four v5 = a1 + e1 * w1;
    const double v6 = Z1_3 * Z1_3;
    const dhgen_four N3 = v6 + v5 * v5, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared);

    /* theta2 */
    const dhgen_four v7 = Z1_3 * (m4 + m3 * N3), v8 = e3 * Z1_3, factor2 = DHGEN_QUOTIENT(1.0, N3),
        v9 = v5 * (m3 + m4 * factor2);

    /* theta4 */
    const double v10 = m5 * Z1_3;
    const dhgen_four v11 = v10 + m6 * v5, v12 = m6 - m7 * factor2, v13 = m8 * factor2 - m5,
        v14 = Z1_3 * v12 + v5 * v13, c23 = v14 + w3 * (factor2 * (e3 * v11));
    const double v15 = m6 * Z1_3;
    const dhgen_four v16 = v15 - m5 * v5, v17 = Z1_3 * v13 + v5 * -v12,
        s23 = v17 + w3 * (factor2 * (e3 * v16)), v18 = T23 * s1 - T13 * v3,
        X4 = c23 * v18 - T33 * s23, Y4 = T13 * s1 + T23 * v3, v19 = Y4 * Y4, v20 = v19 + X4 * X4,
        v21 = dhgen_signed_four(DHGEN_HALF_TURN, Y4);

    /* theta6 */
    const dhgen_four v22 = s1 * T12 + v3 * T22, v23 = s1 * T22 - v3 * T12,
        v24 = s1 * T11 + v3 * T21, v25 = s1 * T21 - v3 * T11;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | (dhgen_abs_four(v1
        * D3_squared) <= m2) | (v20 <= m9)) | (unsigned)(fabs(D1_squared) <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(w3, s1, 0, 5, 2, 7),
        dhgen_shuffle(N3 - k8, -v3, 0, 5, 2, 7)),
        ratio2 = dhgen_ratio_four(-(factor2 * (v7 - w3 * (m3 * (e3 * v5)))), -(v9 + w3 * (m3 * (v8 *
            factor2)))), ratio3 = dhgen_ratio_four(Y4, -X4),
        ratio4 = dhgen_ratio_four(-(-X4 * v24 + Y4 * (c23 * v25 - s23 * T31)), -(-X4 * v22 + Y4 *
            (c23 * v23 - s23 * T32))),
        ratio5 = dhgen_ratio_four(-dhgen_sqrt_four(v20), T33 * c23 + s23 * v18);
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle6 = dhgen_shuffle(packed1, packed1, 1, 1, 3, 3), angle2 = dhgen_angle_four(ratio2),
        angle3 = dhgen_angle_four(ratio3), angle5 = dhgen_angle_four(ratio4),
        angle4 = dhgen_angle_four(ratio5);
    const dhgen_four q3_ = e3 * angle1 - turn1, q4_m = angle3 - v21,
        q6_m = angle5 - dhgen_signed_four(DHGEN_HALF_TURN, -(-X4 * v24 + Y4 * (c23 * v25 - s23 *
            T31))), q3_p = dhgen_lowered_four(q3_), q1_p = angle6 + (w3 - w3);

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, angle2, q3_p, angle3);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, angle4, angle5);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, angle2, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, -angle4, q6_m);
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
DHGEN_TABLE int choosable[1] = { 3 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.5618, 0.5618, 0.5618, 1.0, 1.0, 1.0 }, 0.5617977528089886, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL,
    spherical_wrist_all_offsets_fk, spherical_wrist_all_offsets_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) spherical_wrist_all_offsets_##function
#include "dhgen/functions.h"

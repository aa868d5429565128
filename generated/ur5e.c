/* ur5e: Universal Robots UR5e
 *
 * Inverse kinematics, generated from robots/ur5e.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/ur5e.yaml. The formulas and where they come from: ur5e.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 188073c3e2550859
 * SPDX-License-Identifier: MIT
 */
#include "ur5e.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(UR5E_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(UR5E_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef UR5E_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 1.3122999999999999e-13 [m],
 * merge_slack1 = 1.3122999999999998e-14 [m], arm_size1 = 1.3122999999999998 [m]. */
static const double
    d1 = 0.1625, /* joint offset 1 [m] */
    a2 = -0.425, /* link length 2 [m] */
    a3 = -0.3922, /* link length 3 [m] */
    d4 = 0.1333, /* joint offset 4 [m] */
    d5 = 0.0997, /* joint offset 5 [m] */
    d6 = 0.0996, /* joint offset 6 [m] */
    least_root1 = 4.149856973438963e-07, /* a root of nothing, by rounding [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    near_limit = 0.001, /* a length whose direction is good to few digits */
    longest3 = 0.6678158399999998, /* square of the longest reach [m^2] */
    shortest3 = 0.0010758399999999998, /* square of the shortest reach [m^2] */
    boundary3 = 1.4301245521157901e-13, /* rounding at the boundary of the workspace [m^4] */
    longest3_apart = 0.6678158399999785, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.0010758400000008604, /* the shortest, where branches merge [m^2] */
    longest3_clear = 0.6678158399785518, /* the longest, where blurred branches do [m^2] */
    shortest3_clear = 0.0010758400008608687, /* the shortest, where blurred branches do [m^2] */
    k1 = 0.01776889, /* d4^2 [m^2] */
    k2 = 3.4985918000017217e-14, /* reach_slack1 * (2 * d4 + reach_slack1) [m^2] */
    k3 = 3.4985918000001716e-15, /* merge_slack1 * (2 * d4 + merge_slack1) [m^2] */
    k4 = 0.762020879372095, /* 1 / arm_size1 [m^-1] */
    k5 = 0.33444584, /* a2^2 + a3^2 [m^2] */
    k6 = 2.9996700362960076; /* 1 / (2 * a3 * a2) [m^-2] */

#ifndef __CUDACC_RTC__
const char *const ur5e_branches[8] = {
    "right-noflip-down", "right-noflip-up", "right-flip-down", "right-flip-up", "left-noflip-up",
    "left-noflip-down", "left-flip-up", "left-flip-down",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.1625, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, -0.425, 0.0 },
    { 0.0, 0.0, -0.3922, 0.0 },
    { 0.0, 0.1333, 0.0, 1.5707963267948966 },
    { 0.0, 0.0997, 0.0, -1.5707963267948966 },
    { 0.0, 0.0996, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void ur5e_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - v3 * s4,
        x4_y = x3_y * c4 - v4 * s4, x4_z = x3_z * c4 + y3_z * s4, z4_x = v3 * c4 + x3_x * s4,
        z4_y = v4 * c4 + x3_y * s4, y5_z = y3_z * c4 - x3_z * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 + s1 * s5,
        x5_y = x4_y * c5 - c1 * s5, x5_z = x4_z * c5, z5_x = s1 * c5 - x4_x * s5,
        v5 = c1 * c5 + x4_y * s5, v6 = x4_z * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - z4_x * s6; T[1] = -(z4_x * c6 + x5_x * s6); T[2] = z5_x;
    T[3] = x2_x * a2 + x3_x * a3 + s1 * d4 + z4_x * d5 + z5_x * d6;
    T[4] = x5_y * c6 - z4_y * s6; T[5] = -(z4_y * c6 + x5_y * s6); T[6] = -v5;
    T[7] = x2_y * a2 + x3_y * a3 - c1 * d4 + z4_y * d5 - v5 * d6;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = y5_z * c6 - x5_z * s6; T[10] = -v6;
    T[11] = d1 + s2 * a2 + x3_z * a3 + -y5_z * d5 - v6 * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void ur5e_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2,
        v2 = s1 * s2, p2_x = x2_x * a2, p2_y = x2_y * a2, p2_z = d1 + s2 * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v1 * s3,
        x3_y = x2_y * c3 - v2 * s3, x3_z = s2 * c3 + c2 * s3, v3 = v1 * c3 + x2_x * s3,
        v4 = v2 * c3 + x2_y * s3, y3_z = c2 * c3 - s2 * s3, p3_x = p2_x + x3_x * a3,
        p3_y = p2_y + x3_y * a3, p3_z = p2_z + x3_z * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_x = v3 * c4 + x3_x * s4,
        z4_y = v4 * c4 + x3_y * s4, p4_x = p3_x + s1 * d4, p4_y = p3_y - c1 * d4,
        z4_z = x3_z * s4 - y3_z * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), z5_x = s1 * c5 - (x3_x * c4 - v3 * s4) * s5,
        v5 = c1 * c5 + (x3_y * c4 - v4 * s4) * s5, v6 = (x3_z * c4 + y3_z * s4) * s5,
        p5_x = p4_x + z4_x * d5, p5_y = p4_y + z4_y * d5, p5_z = p3_z + z4_z * d5,
        p6_x = p5_x + z5_x * d6, p6_y = p5_y - v5 * d6, p6_z = p5_z - v6 * d6, v7 = p6_z - d1,
        v8 = p6_z - p2_z, v9 = p6_z - p3_z, v10 = p6_x - p4_x, v11 = p6_y - p4_y, v12 = p6_x - p5_x,
        v13 = p6_y - p5_y, v14 = p6_z - p5_z;
    J[0] = -p6_y; J[1] = -(c1 * v7); J[2] = -(c1 * v8); J[3] = -(c1 * v9);
    J[4] = z4_y * v9 - z4_z * v11; J[5] = v6 * v13 - v5 * v14;
    J[6] = p6_x; J[7] = -(s1 * v7); J[8] = -(s1 * v8); J[9] = -(s1 * v9);
    J[10] = z4_z * v10 - z4_x * v9; J[11] = -(v6 * v12 + z5_x * v14);
    J[12] = 0.0; J[13] = s1 * p6_y + c1 * p6_x; J[14] = s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x);
    J[15] = s1 * (p6_y - p3_y) + c1 * (p6_x - p3_x); J[16] = z4_x * v11 - z4_y * v10;
    J[17] = z5_x * v13 + v5 * v12;
    J[18] = 0.0; J[19] = s1; J[20] = s1; J[21] = s1; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = -c1; J[26] = -c1; J[27] = -c1; J[28] = z4_y; J[29] = -v5;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = 0.0; J[34] = z4_z; J[35] = -v6;
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
    const double inverse1 = 1.0 / (apart1 ? N1 : d4 * sqrt(N1));
    const double v2 = X1 * d4, v3 = wy * d4;

    /* theta3, type 8: U1[2, 4] and U1[1, 4] */
    const double v7 = T34 - d1;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = -(inverse1 * (v3 + X1 * D1)), s1 = inverse1 * (wy * D1 - v2);
        const double q1 = atan2(s1, c1);

        /* theta6, type 2: U1 A6^-1 [3, 2] */
        const double X6 = T21 * c1 - T11 * s1;
        const double Y6 = T22 * c1 - T12 * s1;
        const double w6 = sqrt(X6 * X6 + Y6 * Y6);
        const int free6 = w6 <= free_limit;
        const double divisor6 = free6 ? 1.0 : w6;
        const int near6 = w6 <= near_limit;

        /* theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1] */
        const double c5 = T13 * s1 - T23 * c1;

        /* theta3 */
        const double v8 = T14 * c1 + T24 * s1, v9 = near6 ? 1.0 : v1;

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
            const double c234 = c6 * T32 + s6 * T31, s234 = c5 * (c6 * T31 - s6 * T32) - s5 * T33;
            const double theta234 = atan2(s234, c234);

            /* theta3 */
            const double v6 = d6 * s5;
            const double Z1_3 = c234 * d5 + s234 * v6 + v7;
            const double Z2_3 = c234 * v6 - s234 * d5 + v8;
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
                const double q2 = atan2(s2, c2);

                /* joint values */
                const double q4 = dhgen_wrap(theta234 - (q3 + q2));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = free6 ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef UR5E_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 3.4985918000001714e-12, /* 1000 * k3 [m^2] */
    m2 = 9.999999999999999e-09, /* doubt_limit^2 */
    /* 10 * (longest3 - longest3_clear) * (longest3_clear - shortest3) [m^4] */
    m4 = 1.4300283221564012e-10,
    m5 = 1.1764705882352942, /* -a3 * k6 [m^-1] */
    m6 = 0.031534305882352925; /* a3 * k5 * k6 - a2 [m] */

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
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (d4 * wy),
        v3 = v2 + w1 * (X1 * inverse1), v4 = v2 + w1 * (inverse1 * -X1), v5 = inverse1 * (d4 * X1),
        s1_p = w1 * (wy * inverse1) - v5, s1_m = w1 * (inverse1 * -wy) - v5,
        angle1 = dhgen_atan2_wide(s1_p, -v3), angle2 = dhgen_atan2_wide(s1_m, -v4);

    /* theta6 */
    const dhgen_wide v6 = v3 * T21 + s1_p * T11, v7 = v4 * T21 + s1_m * T11,
        v8 = v3 * T22 + s1_p * T12, v9 = v4 * T22 + s1_m * T12, v10 = v6 * v6 + v8 * v8,
        v11 = v7 * v7 + v9 * v9, w6_p = dhgen_sqrt_wide(v10), w6_m = dhgen_sqrt_wide(v11),
        v12 = DHGEN_QUOTIENT(1.0, v10), v13 = DHGEN_QUOTIENT(1.0, v11),
        angle3 = dhgen_atan2_wide(-v8, v6), angle4 = dhgen_atan2_wide(-v9, v7);

    /* theta5 */
    const dhgen_wide c5_p = T13 * s1_p + T23 * v3, c5_m = T13 * s1_m + T23 * v4,
        angle5 = dhgen_atan2_wide(w6_p, c5_p), angle6 = dhgen_atan2_wide(w6_m, c5_m);

    /* theta234 */
    const dhgen_wide v14 = v12 * (v6 * T32 - v8 * T31), v15 = v13 * (v7 * T32 - v9 * T31),
        c234_p = w6_p * v14, c234_m = w6_m * v15, v16 = v12 * (c5_p * (v6 * T31 + v8 * T32)) - T33,
        v17 = v13 * (c5_m * (v7 * T31 + v9 * T32)) - T33, s234_p = w6_p * v16, s234_m = w6_m * v17,
        angle7 = dhgen_atan2_wide(v16, v14), angle8 = dhgen_atan2_wide(v17, v15),
        theta234_pm = angle7 - dhgen_signed_wide(DHGEN_HALF_TURN, v16),
        theta234_mm = angle8 - dhgen_signed_wide(DHGEN_HALF_TURN, v17);

    /* theta3 */
    const dhgen_wide v18 = d6 * w6_p, v19 = d6 * w6_m, v20 = T34 - d1, v21 = d5 * c234_p,
        v22 = d5 * c234_m, v23 = s234_p * v18, v24 = s234_m * v19, Z1_3_pp = v20 + (v21 + v23),
        Z1_3_pm = v20 + (v23 - v21), Z1_3_mp = v20 + (v22 + v24), Z1_3_mm = v20 + (v24 - v22),
        v25 = T24 * s1_p - T14 * v3, v26 = T24 * s1_m - T14 * v4, v27 = c234_p * v18,
        v28 = c234_m * v19, v29 = d5 * s234_p, v30 = d5 * s234_m, Z2_3_pp = v25 + (v27 - v29),
        Z2_3_pm = v25 + (v27 + v29), Z2_3_mp = v26 + (v28 - v30), Z2_3_mm = v26 + (v28 + v30),
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
        v31 = w3_pp - w3_pp, v32 = w3_pm - w3_pm, v33 = w3_mp - w3_mp, v34 = w3_mm - w3_mm,
        angle9 = dhgen_atan2_wide(w3_pp, N3_pp - k5), angle10 = dhgen_atan2_wide(w3_pm, N3_pm - k5),
        angle11 = dhgen_atan2_wide(w3_mp, N3_mp - k5),
        angle12 = dhgen_atan2_wide(w3_mm, N3_mm - k5);

    /* theta2 */
    const dhgen_wide v35 = m6 + m5 * N3_pp, v36 = m6 + m5 * N3_pm, v37 = m6 + m5 * N3_mp,
        v38 = m6 + m5 * N3_mm, v39 = Z1_3_pp * v35, v40 = Z1_3_pm * v36, v41 = Z1_3_mp * v37,
        v42 = Z1_3_mm * v38, v43 = Z2_3_pp * v35, v44 = Z2_3_pm * v36, v45 = Z2_3_mp * v37,
        v46 = Z2_3_mm * v38, v47 = w3_pp * (m5 * Z2_3_pp), v48 = w3_pp * (m5 * Z1_3_pp),
        angle13 = dhgen_atan2_wide(v47 - v39, -(v43 + v48)),
        angle14 = dhgen_atan2_wide(-(v39 + v47), v48 - v43), v49 = w3_pm * (m5 * Z2_3_pm),
        v50 = w3_pm * (m5 * Z1_3_pm), angle15 = dhgen_atan2_wide(v49 - v40, -(v44 + v50)),
        angle16 = dhgen_atan2_wide(-(v40 + v49), v50 - v44), v51 = w3_mp * (m5 * Z2_3_mp),
        v52 = w3_mp * (m5 * Z1_3_mp), angle17 = dhgen_atan2_wide(v51 - v41, -(v45 + v52)),
        angle18 = dhgen_atan2_wide(-(v41 + v51), v52 - v45), v53 = w3_mm * (m5 * Z2_3_mm),
        v54 = w3_mm * (m5 * Z1_3_mm), angle19 = dhgen_atan2_wide(v53 - v42, -(v46 + v54)),
        angle20 = dhgen_atan2_wide(-(v42 + v53), v54 - v46);

    /* joint values */
    const dhgen_wide v55 = angle7 - (angle9 + angle13), v56 = angle7 - (angle14 - angle9),
        v57 = theta234_pm - (angle10 + angle15), v58 = theta234_pm - (angle16 - angle10),
        v59 = angle8 - (angle11 + angle17), v60 = angle8 - (angle18 - angle11),
        v61 = theta234_mm - (angle12 + angle19), v62 = theta234_mm - (angle20 - angle12),
        q1_ppp = angle1 + v31, q1_pmp = angle1 + v32, q1_mpp = angle2 + v33, q1_mmp = angle2 + v34,
        q5_ppp = angle5 + v31, q5_pmp = v32 - angle5, q5_mpp = angle6 + v33, q5_mmp = v34 - angle6,
        q6_ppp = angle3 + v31, q6_pmp = v32 + (angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, -v8)),
        q6_mpp = angle4 + v33, q6_mmp = v34 + (angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, -v9));

    q[0] = q1_ppp; q[1] = angle13; q[2] = angle9; q[3] = dhgen_centred_wide(v55); q[4] = q5_ppp;
    q[5] = q6_ppp;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_ppp; q[7] = angle14; q[8] = -angle9; q[9] = dhgen_centred_wide(v56); q[10] = q5_ppp;
    q[11] = q6_ppp;
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_pmp; q[13] = angle15; q[14] = angle10; q[15] = dhgen_centred_wide(v57);
    q[16] = q5_pmp; q[17] = q6_pmp;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_pmp; q[19] = angle16; q[20] = -angle10; q[21] = dhgen_centred_wide(v58);
    q[22] = q5_pmp; q[23] = q6_pmp;
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = angle17; q[26] = angle11; q[27] = dhgen_centred_wide(v59);
    q[28] = q5_mpp; q[29] = q6_mpp;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = angle18; q[32] = -angle11; q[33] = dhgen_centred_wide(v60);
    q[34] = q5_mpp; q[35] = q6_mpp;
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mmp; q[37] = angle19; q[38] = angle12; q[39] = dhgen_centred_wide(v61);
    q[40] = q5_mmp; q[41] = q6_mmp;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mmp; q[43] = angle20; q[44] = -angle12; q[45] = dhgen_centred_wide(v62);
    q[46] = q5_mmp; q[47] = q6_mmp;
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(v1 * D3_squared_mm) <= m4) | (dhgen_abs_wide(v1 *
        D3_squared_mp) <= m4) | (dhgen_abs_wide(v1 * D3_squared_pm) <= m4) | (dhgen_abs_wide(v1 *
        D3_squared_pp) <= m4) | (v11 <= m2) | (dhgen_abs_wide(D1_squared) <= m1) | (v10 <= m2));
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
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = inverse1 * (d4 * wy);
    const dhgen_four v3 = v2 + w1 * (inverse1 * (e1 * X1));
    const double v4 = inverse1 * (d4 * X1);
    const dhgen_four s1 = w1 * (inverse1 * (e1 * wy)) - v4;

    /* theta6 */
    const dhgen_four v5 = v3 * T21 + s1 * T11, v6 = v3 * T22 + s1 * T12, v7 = v5 * v5 + v6 * v6,
        w6 = dhgen_sqrt_four(v7), v8 = DHGEN_QUOTIENT(1.0, v7),
        v9 = dhgen_signed_four(DHGEN_HALF_TURN, -v6), v10 = m3 * (e6 - 1.0);

    /* theta5 */
    const dhgen_four c5 = T13 * s1 + T23 * v3;

    /* theta234 */
    const dhgen_four v11 = v8 * (v5 * T32 - v6 * T31), c234 = w6 * v11,
        v12 = v8 * (c5 * (v5 * T31 + v6 * T32)) - T33, s234 = w6 * v12,
        v13 = dhgen_signed_four(DHGEN_HALF_TURN, v12);

    /* theta3 */
    const dhgen_four v14 = d6 * w6;
    const double v15 = T34 - d1;
    const dhgen_four v16 = d5 * c234, v17 = s234 * v14, Z1_3 = v15 + (v17 + e6 * v16),
        v18 = T24 * s1 - T14 * v3, v19 = c234 * v14, v20 = d5 * s234, Z2_3 = v18 + (v19 - e6 * v20),
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3, D3_squared = (longest3 - N3) * (N3 - shortest3),
        w3 = dhgen_sqrt_four(D3_squared), v21 = w3 - w3;

    /* theta2 */
    const dhgen_four v22 = m6 + m5 * N3, v23 = Z1_3 * v22, v24 = Z2_3 * v22, v25 = w3 * (m5 * Z2_3),
        v26 = w3 * (m5 * Z1_3);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | (v7 <= m2) |
        (dhgen_abs_four(v1 * D3_squared) <= m4)) | (unsigned)(fabs(D1_squared) <= m1))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(s1, -v6, 0, 5, 2, 7),
        dhgen_shuffle(-v3, v5, 0, 5, 2, 7)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(w6, v12, 0, 5, 2, 7), dhgen_shuffle(c5, v11, 0, 5,
            2, 7)), ratio3 = dhgen_ratio_four(w3, N3 - k5),
        ratio4 = dhgen_ratio_four(v25 - v23, -(v24 + v26)),
        ratio5 = dhgen_ratio_four(-(v23 + v25), v26 - v24);
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 2, 2),
        angle2 = dhgen_shuffle(packed1, packed1, 1, 1, 3, 3), packed2 = dhgen_angle_four(ratio2),
        angle3 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2),
        angle4 = dhgen_shuffle(packed2, packed2, 1, 1, 3, 3), angle5 = dhgen_angle_four(ratio3),
        angle6 = dhgen_angle_four(ratio4), angle7 = dhgen_angle_four(ratio5);
    const dhgen_four theta234 = angle4 + v10 * v13, v27 = theta234 - (angle5 + angle6),
        v28 = theta234 - (angle7 - angle5), q4_p = dhgen_centred_four(v27),
        q4_m = dhgen_centred_four(v28), q1_p = angle1 + v21, q5_p = v21 + e6 * angle3,
        q6_p = v21 + (angle2 + v9 * v10);

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, angle6, angle5, q4_p);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, q5_p, q6_p);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, angle7, -angle5, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, q5_p, q6_p);
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
DHGEN_TABLE int choosable[1] = { 5 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.762, 0.762, 0.762, 1.0, 1.0, 1.0 }, 0.762020879372095, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 1, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 1, NULL, 0, 52, 1, /* merges */ 1, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, ur5e_fk,
    ur5e_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) ur5e_##function
#include "dhgen/functions.h"

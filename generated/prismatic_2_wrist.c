/* prismatic_2_wrist: Slide as joint 2, spherical wrist
 *
 * Inverse kinematics, generated from robots/prismatic_2_wrist.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/prismatic_2_wrist.yaml. The formulas and where they come from:
 * prismatic_2_wrist.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 25f4fcfbeffc6717
 * SPDX-License-Identifier: MIT
 */
#include "prismatic_2_wrist.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(PRISMATIC_2_WRIST_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(PRISMATIC_2_WRIST_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef PRISMATIC_2_WRIST_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, d1 = 0.3 [m]. */
static const double
    a1 = 0.1, /* link length 1 [m] */
    cat2 = 0.9800665778412416, /* cosine of the angle of joint 2 */
    sat2 = 0.19866933079506122, /* sine of the angle of joint 2 */
    a2 = 0.15, /* link length 2 [m] */
    d3 = 0.1, /* joint offset 3 [m] */
    a3 = 0.08, /* link length 3 [m] */
    d4 = 0.43, /* joint offset 4 [m] */
    d6 = 0.08, /* joint offset 6 [m] */
    free_limit_squared2 = 1.5375999999999999e-24, /* square of a length that fixes no angle [m^2] */
    reach_slack1 = 1.24e-13, /* rounding at the boundary of the workspace [m] */
    merge_slack1 = 1.24e-14, /* nearer to that boundary two branches are one [m] */
    /* the same where they follow an angle that is good to few digits [m] */
    blur_slack1 = 1.2399999999999999e-11,
    /* square of a length whose direction is good to few digits [m^2] */
    near_limit_squared2 = 1.5376000000000001e-06,
    free_limit1 = 1.24e-12, /* a length that fixes no angle [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.4138869064318786, /* d1 * cat2 + (a1 * sat2 + d3) [m] */
    k2 = 0.08542781224187632, /* d4 * sat2 [m] */
    k3 = 0.0158935464636049, /* a3 * sat2 [m] */
    k4 = 0.007550515923624042, /* k2^2 + k3^2 [m^2] */
    k5 = 0.36820625816486496, /* d1 + (cat2 * d3 - a2 * sat2) [m] */
    k6 = 132.4412808495909, /* 1 / k4 [m^-2] */
    f1 = 0.2701996003807408, /* d1 - sat2 * a2 [m] */
    f2 = 0.09800665778412417; /* d3 * cat2 [m] */

#ifndef __CUDACC_RTC__
const char *const prismatic_2_wrist_branches[8] = {
    "shoulder+-elbow+-noflip", "shoulder+-elbow+-flip", "shoulder+-elbow--noflip",
    "shoulder+-elbow--flip", "shoulder--elbow+-noflip", "shoulder--elbow+-flip",
    "shoulder--elbow--noflip", "shoulder--elbow--flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1.24e-09, 0.6503642039542143, 1.24, 0.12173671532660449, 0 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.3, 0.1, -1.5707963267948966 },
    { 0.2, 0.0, 0.15, 1.5707963267948966 },
    { 0.0, 0.1, 0.08, -1.5707963267948966 },
    { 0.0, 0.43, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.08, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void prismatic_2_wrist_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), x2_x = c1 * cat2, x2_y = s1 * cat2,
        z2_x = c1 * sat2, z2_y = s1 * sat2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - s1 * s3,
        x3_y = x2_y * c3 + c1 * s3, v1 = sat2 * c3, v2 = s1 * c3 + x2_x * s3,
        z3_y = c1 * c3 - x2_y * s3, z3_z = sat2 * s3;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = x3_x * c4 - z2_x * s4,
        x4_y = x3_y * c4 - z2_y * s4, v3 = v1 * c4 + cat2 * s4, z4_x = z2_x * c4 + x3_x * s4,
        z4_y = z2_y * c4 + x3_y * s4, y5_z = v1 * s4 - cat2 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - v2 * s5,
        x5_y = x4_y * c5 + z3_y * s5, x5_z = z3_z * s5 - v3 * c5, v4 = v2 * c5 + x4_x * s5,
        z5_y = z3_y * c5 - x4_y * s5, z5_z = z3_z * c5 + v3 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 - z4_x * s6; T[1] = -(z4_x * c6 + x5_x * s6); T[2] = -v4;
    T[3] = c1 * a1 - s1 * q[1] + x2_x * a2 + x3_x * a3 + z2_x * d3 - v2 * d4 - v4 * d6;
    T[4] = x5_y * c6 - z4_y * s6; T[5] = -(z4_y * c6 + x5_y * s6); T[6] = z5_y;
    T[7] = s1 * a1 + c1 * q[1] + x2_y * a2 + x3_y * a3 + z2_y * d3 + z3_y * d4 + z5_y * d6;
    T[8] = x5_z * c6 + y5_z * s6; T[9] = y5_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = f1 - v1 * a3 + f2 + z3_z * d4 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void prismatic_2_wrist_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), x2_x = c1 * cat2, x2_y = s1 * cat2,
        z2_x = c1 * sat2, z2_y = s1 * sat2, p2_x = c1 * a1 - s1 * q[1] + x2_x * a2,
        p2_y = s1 * a1 + c1 * q[1] + x2_y * a2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - s1 * s3,
        x3_y = x2_y * c3 + c1 * s3, v1 = sat2 * c3, v2 = s1 * c3 + x2_x * s3,
        z3_y = c1 * c3 - x2_y * s3, z3_z = sat2 * s3, p3_x = p2_x + x3_x * a3 + z2_x * d3,
        p3_y = p2_y + x3_y * a3 + z2_y * d3, p3_z = f1 - v1 * a3 + f2;
    const double c4 = cos(q[3]), s4 = sin(q[3]), z4_x = z2_x * c4 + x3_x * s4,
        z4_y = z2_y * c4 + x3_y * s4, p4_x = p3_x - v2 * d4, p4_y = p3_y + z3_y * d4,
        p4_z = p3_z + z3_z * d4, z4_z = cat2 * c4 - v1 * s4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), v3 = v2 * c5 + (x3_x * c4 - z2_x * s4) * s5,
        z5_y = z3_y * c5 - (x3_y * c4 - z2_y * s4) * s5,
        z5_z = z3_z * c5 + (v1 * c4 + cat2 * s4) * s5, p6_x = p4_x - v3 * d6,
        p6_y = p4_y + z5_y * d6, p6_z = p4_z + z5_z * d6, v4 = p6_x - p2_x, v5 = p6_y - p2_y,
        v6 = p6_z - f1, v7 = p6_x - p3_x, v8 = p6_y - p3_y, v9 = p6_z - p3_z, v10 = p6_x - p4_x,
        v11 = p6_y - p4_y, v12 = p6_z - p4_z;
    J[0] = -p6_y; J[1] = -s1; J[2] = z2_y * v6 - cat2 * v5; J[3] = z3_y * v9 - z3_z * v8;
    J[4] = z4_y * v12 - z4_z * v11; J[5] = z5_y * v12 - z5_z * v11;
    J[6] = p6_x; J[7] = c1; J[8] = cat2 * v4 - z2_x * v6; J[9] = z3_z * v7 + v2 * v9;
    J[10] = z4_z * v10 - z4_x * v12; J[11] = z5_z * v10 + v3 * v12;
    J[12] = 0.0; J[13] = 0.0; J[14] = z2_x * v5 - z2_y * v4; J[15] = -(v2 * v8 + z3_y * v7);
    J[16] = z4_x * v11 - z4_y * v10; J[17] = -(v3 * v11 + z5_y * v10);
    J[18] = 0.0; J[19] = 0.0; J[20] = z2_x; J[21] = -v2; J[22] = z4_x; J[23] = -v3;
    J[24] = 0.0; J[25] = 0.0; J[26] = z2_y; J[27] = z3_y; J[28] = z4_y; J[29] = z5_y;
    J[30] = 1.0; J[31] = 0.0; J[32] = cat2; J[33] = z3_z; J[34] = z4_z; J[35] = z5_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U2 A6^-1 [3, 4] */
    const double wy = T24 - T23 * d6;
    const double v1 = wy * sat2;
    const double wx = T14 - d6 * T13;
    const double v2 = sat2 * wx;
    const double N1 = v1 * v1 + v2 * v2;
    const int free1 = N1 <= free_limit_squared2;
    const double wz = T34 - d6 * T33;
    const double Z1 = wz * cat2 - k1;
    const double D1_squared = N1 - Z1 * Z1;
    const double v3 = fabs(Z1), v4 = 2.0 * v3;
    const int apart1 = merge_slack1 * (v4 + merge_slack1) < D1_squared;
    if (!(-(reach_slack1 * (v4 + reach_slack1)) < D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : v3 * sqrt(N1)));
    const double v5 = v1 * Z1, v6 = v2 * Z1;
    const int near1 = N1 <= near_limit_squared2;
    const double v7 = v1 * cos(seed[0]) - v2 * sin(seed[0]);
    const double off1 = near1 ? fabs(Z1 + (v1 * sin(seed[0]) + v2 * cos(seed[0]))) : 1.0;
    const int v8 = off1 <= free_limit1;

    /* theta3, type 2: U0 A6^-1 [3, 4] */
    const double Z3 = wz - k5;
    const double D3_squared = k4 - Z3 * Z3;
    const double v9 = 2.0 * fabs(Z3);
    const int apart3 = merge_slack1 * (merge_slack1 + v9) < D3_squared;
    if (!(-(reach_slack1 * (reach_slack1 + v9)) < D3_squared)) return; /* out of reach */
    const double w3 = sqrt(apart3 ? D3_squared : 0.0);
    const double v10 = k2 * Z3, v11 = k3 * Z3;

    /* theta4, type 2: U4[3, 3] */
    const double v15 = T13 * cat2, v16 = T23 * cat2, v17 = sat2 * T33, v20 = sat2 * T13,
        v21 = T23 * sat2, v22 = T33 * cat2;

    /* theta6, type 3: U4[3, 2] and U4[3, 1] */
    const double v25 = sat2 * T12, v26 = T22 * sat2, v27 = T32 * cat2, v29 = T12 * cat2,
        v30 = T22 * cat2, v31 = sat2 * T32, v35 = sat2 * T11, v36 = T21 * sat2, v37 = T31 * cat2,
        v39 = T11 * cat2, v40 = T21 * cat2, v41 = sat2 * T31;

    for (int i1 = 0; i1 < 2; i1++) { /* shoulder+, shoulder- */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double ahead1 = near1 ? D1 * v7 : -1.0;
        const int same1 = near1 && 0.0 <= ahead1 && v8;
        const int held1 = free1 || same1;
        const double c1 = held1 ? cos(seed[0]) : inverse1 * (v1 * D1 - v6),
            s1 = held1 ? sin(seed[0]) : -(inverse1 * (v5 + v2 * D1));
        const double q1 = atan2(s1, c1);

        /* r2, type 1: U1 A6^-1 [3, 4] */
        const double v14 = c1 * -wy + wx * s1;

        /* theta4 */
        const double v18 = c1 * v15 + s1 * v16 - v17, v19 = T13 * s1 - T23 * c1,
            v23 = c1 * v20 + s1 * v21 + v22, v24 = v23 * v23;

        /* theta6 */
        const double v28 = c1 * v25 + s1 * v26 + v27, v32 = c1 * v29 + s1 * v30 - v31,
            v33 = T22 * c1 - T12 * s1, v38 = c1 * v35 + s1 * v36 + v37,
            v42 = c1 * v39 + s1 * v40 - v41, v43 = T21 * c1 - T11 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* elbow+, elbow- */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && (!apart3 || (near1 && !(blur_slack1 * (blur_slack1 + v9) <
                D3_squared))))
                continue; /* both signs give the same */
            const double D3 = w3 * e3;
            const double v12 = k6 * (v11 + k2 * D3);
            const double s3 = k6 * (v10 - k3 * D3);
            const double q3 = atan2(s3, -v12);

            /* r2 */
            const double v13 = a3 * s3 - d4 * v12;

            /* theta4 */
            const double X4 = v12 * v18 - s3 * -v19;
            const double w4 = sqrt(X4 * X4 + v24);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = v12 * v19 - s3 * v18;

            /* theta6 */
            const double v34 = s3 * v33 - v12 * v32, v44 = s3 * v43 - v12 * v42;

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(seed[3]) : -(X4 * factor4),
                    s4 = free4 ? sin(seed[3]) : -(v23 * factor4);
                const double q4 = atan2(s4, c4);

                /* theta5 */
                const double q5 = atan2(-(w4 * e4), c5);

                /* theta6 */
                const double q6 = atan2(-(c4 * v38 + s4 * v44), -(c4 * v28 + s4 * v34));
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = -(v13 + v14); q[row][2] = q3; q[row][3] = q4;
                q[row][4] = q5; q[row][5] = q6;
                status[row] = (free1 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef PRISMATIC_2_WRIST_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    /* square of a length that fixes no angle [m^2] */
    doubt_limit_squared2 = 1.5375999999999998e-08,
    m1 = 1.2399999999999999e-11, /* 1000 * merge_slack1 [m] */
    m2 = 1.2399999999999999e-10, /* 10 * blur_slack1 [m] */
    m3 = 11.314168873492461, /* k2 * k6 [m^-1] */
    m4 = 0.7750600530519154, /* k3 * k5 * k6 */
    m5 = 2.1049616508823186, /* k3 * k6 [m^-1] */
    m6 = 4.165947785154044, /* k2 * k5 * k6 */
    m7 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide wy = T24 - d6 * T23, v1 = sat2 * wy, wx = T14 - d6 * T13, v2 = sat2 * wx,
        N1 = v1 * v1 + v2 * v2, wz = T34 - d6 * T33, Z1 = cat2 * wz - k1, D1_squared = N1 - Z1 * Z1,
        w1 = dhgen_sqrt_wide(D1_squared), v3 = w1 - w1, inverse1 = DHGEN_QUOTIENT(1.0, N1),
        v4 = v1 * Z1, v5 = v2 * Z1, v6 = inverse1 * v5, v7 = w1 * (v1 * inverse1), c1_p = v7 - v6,
        v8 = v6 + v7, v9 = inverse1 * v4, v10 = w1 * (v2 * inverse1), v11 = v9 + v10,
        v12 = v9 - v10;

    /* theta3 */
    const dhgen_wide Z3 = wz - k5, D3_squared = k4 - Z3 * Z3, w3 = dhgen_sqrt_wide(D3_squared),
        v13 = w3 - w3, v14 = m5 * wz - m4, v15 = m3 * w3, v16 = v14 + v15, v17 = v14 - v15,
        v18 = m3 * wz - m6, v19 = m5 * w3, s3_p = v18 - v19, s3_m = v18 + v19;

    /* r2 */
    const dhgen_wide v20 = a3 * s3_p - d4 * v16, v21 = a3 * s3_m - d4 * v17,
        v22 = c1_p * -wy - wx * v11, v23 = v8 * -wy + wx * v12;

    /* theta4 */
    const dhgen_wide v24 = cat2 * T13, v25 = cat2 * T23, v26 = v1 * v24 - v2 * v25,
        v27 = sat2 * T33 + inverse1 * (v4 * v25 + v5 * v24), v28 = w1 * (inverse1 * v26) - v27,
        v29 = w1 * (inverse1 * -v26) - v27, v30 = T13 * v11 + T23 * c1_p,
        v31 = T13 * v12 - T23 * v8, X4_pp = v16 * v28 - s3_p * v30, X4_pm = v17 * v28 - s3_m * v30,
        X4_mp = v16 * v29 - s3_p * v31, X4_mm = v17 * v29 - s3_m * v31, v32 = sat2 * T13,
        v33 = sat2 * T23, v34 = v1 * v32 - v2 * v33,
        v35 = cat2 * T33 - inverse1 * (v4 * v33 + v5 * v32), v36 = v35 + w1 * (inverse1 * v34),
        v37 = v35 + w1 * (inverse1 * -v34), v38 = v36 * v36, v39 = v37 * v37,
        v40 = v38 + X4_pp * X4_pp, v41 = v38 + X4_pm * X4_pm, v42 = v39 + X4_mp * X4_mp,
        v43 = v39 + X4_mm * X4_mm, angle1 = dhgen_atan2_wide(-v36, -X4_pp),
        angle2 = dhgen_atan2_wide(-v36, -X4_pm), angle3 = dhgen_atan2_wide(-v37, -X4_mp),
        angle4 = dhgen_atan2_wide(-v37, -X4_mm), v44 = dhgen_signed_wide(DHGEN_HALF_TURN, -v36),
        v45 = dhgen_signed_wide(DHGEN_HALF_TURN, -v37);

    /* theta5 */
    const dhgen_wide angle5 = dhgen_atan2_wide(-dhgen_sqrt_wide(v40), -(v16 * v30 + s3_p * v28)),
        angle6 = dhgen_atan2_wide(-dhgen_sqrt_wide(v41), -(v17 * v30 + s3_m * v28)),
        angle7 = dhgen_atan2_wide(-dhgen_sqrt_wide(v42), -(v16 * v31 + s3_p * v29)),
        angle8 = dhgen_atan2_wide(-dhgen_sqrt_wide(v43), -(v17 * v31 + s3_m * v29));

    /* theta6 */
    const dhgen_wide v46 = sat2 * T12, v47 = sat2 * T22, v48 = v1 * v46 - v2 * v47,
        v49 = cat2 * T32 - inverse1 * (v4 * v47 + v5 * v46), v50 = v49 + w1 * (inverse1 * v48),
        v51 = v49 + w1 * (inverse1 * -v48), v52 = cat2 * T12, v53 = cat2 * T22,
        v54 = v1 * v52 - v2 * v53, v55 = sat2 * T32 + inverse1 * (v4 * v53 + v5 * v52),
        v56 = w1 * (inverse1 * v54) - v55, v57 = w1 * (inverse1 * -v54) - v55,
        v58 = c1_p * T22 + v11 * T12, v59 = v12 * T12 - v8 * T22, v60 = sat2 * T11,
        v61 = sat2 * T21, v62 = v1 * v60 - v2 * v61,
        v63 = cat2 * T31 - inverse1 * (v4 * v61 + v5 * v60), v64 = v63 + w1 * (inverse1 * v62),
        v65 = v63 + w1 * (inverse1 * -v62), v66 = cat2 * T11, v67 = cat2 * T21,
        v68 = v1 * v66 - v2 * v67, v69 = sat2 * T31 + inverse1 * (v4 * v67 + v5 * v66),
        v70 = w1 * (inverse1 * v68) - v69, v71 = w1 * (inverse1 * -v68) - v69,
        v72 = c1_p * T21 + v11 * T11, v73 = v12 * T11 - v8 * T21,
        v74 = v36 * (s3_p * v72 - v16 * v70) + X4_pp * v64,
        v75 = v36 * (s3_m * v72 - v17 * v70) + X4_pm * v64,
        v76 = v37 * (s3_p * v73 - v16 * v71) + X4_mp * v65,
        v77 = v37 * (s3_m * v73 - v17 * v71) + X4_mm * v65,
        angle9 = dhgen_atan2_wide(v74, v36 * (s3_p * v58 - v16 * v56) + X4_pp * v50),
        angle10 = dhgen_atan2_wide(v75, v36 * (s3_m * v58 - v17 * v56) + X4_pm * v50),
        angle11 = dhgen_atan2_wide(v76, v37 * (s3_p * v59 - v16 * v57) + X4_mp * v51),
        angle12 = dhgen_atan2_wide(v77, v37 * (s3_m * v59 - v17 * v57) + X4_mm * v51);

    /* joint values */
    const dhgen_wide angle13 = dhgen_atan2_wide(-v11, c1_p), q1_ppp = v13 + angle13,
        angle14 = dhgen_atan2_wide(-v12, -v8), q1_mpp = v13 + angle14,
        angle15 = dhgen_atan2_wide(s3_p, -v16), q3_ppp = v3 + angle15,
        angle16 = dhgen_atan2_wide(s3_m, -v17), q3_pmp = v3 + angle16, q2_mpp = v23 - v20,
        q2_mmp = v23 - v21;

    q[0] = q1_ppp; q[1] = -(v20 + v22); q[2] = q3_ppp; q[3] = angle1; q[4] = angle5; q[5] = angle9;
    kind[0] = dhgen_kind_wide(q[0]);
    q[6] = q1_ppp; q[7] = -(v20 + v22); q[8] = q3_ppp; q[9] = angle1 - v44; q[10] = -angle5;
    q[11] = angle9 - dhgen_signed_wide(DHGEN_HALF_TURN, v74);
    kind[1] = dhgen_kind_wide(q[6]);
    q[12] = q1_ppp; q[13] = -(v21 + v22); q[14] = q3_pmp; q[15] = angle2; q[16] = angle6;
    q[17] = angle10;
    kind[2] = dhgen_kind_wide(q[12]);
    q[18] = q1_ppp; q[19] = -(v21 + v22); q[20] = q3_pmp; q[21] = angle2 - v44; q[22] = -angle6;
    q[23] = angle10 - dhgen_signed_wide(DHGEN_HALF_TURN, v75);
    kind[3] = dhgen_kind_wide(q[18]);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_ppp; q[27] = angle3; q[28] = angle7; q[29] = angle11;
    kind[4] = dhgen_kind_wide(q[24]);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_ppp; q[33] = angle3 - v45; q[34] = -angle7;
    q[35] = angle11 - dhgen_signed_wide(DHGEN_HALF_TURN, v76);
    kind[5] = dhgen_kind_wide(q[30]);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_pmp; q[39] = angle4; q[40] = angle8; q[41] = angle12;
    kind[6] = dhgen_kind_wide(q[36]);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_pmp; q[45] = angle4 - v45; q[46] = -angle8;
    q[47] = angle12 - dhgen_signed_wide(DHGEN_HALF_TURN, v77);
    kind[7] = dhgen_kind_wide(q[42]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D1_squared) <= m1 * (merge_slack1 + 2.0 *
        dhgen_abs_wide(Z1))) | (N1 <= doubt_limit_squared2) | (dhgen_abs_wide(D3_squared) <= m2 *
        (blur_slack1 + 2.0 * dhgen_abs_wide(Z3))) | (v43 <= m7) | (v42 <= m7) | (v40 <= m7) | (v41
        <= m7));
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
    const double wy = T24 - d6 * T23, v1 = sat2 * wy, wx = T14 - d6 * T13, v2 = sat2 * wx,
        N1 = v1 * v1 + v2 * v2, wz = T34 - d6 * T33, Z1 = cat2 * wz - k1, D1_squared = N1 - Z1 * Z1,
        w1 = sqrt(D1_squared), v3 = w1 - w1, inverse1 = DHGEN_QUOTIENT(1.0, N1), v4 = v1 * Z1,
        v5 = v2 * Z1, v6 = inverse1 * v5;
    const dhgen_four c1 = w1 * (inverse1 * (e1 * v1)) - v6;
    const double v7 = inverse1 * v4;
    const dhgen_four v8 = v7 + w1 * (inverse1 * (e1 * v2));

    /* theta3 */
    const double Z3 = wz - k5, D3_squared = k4 - Z3 * Z3, w3 = sqrt(D3_squared), v9 = w3 - w3,
        v10 = m5 * wz - m4;
    const dhgen_four v11 = v10 + w3 * (m3 * e3);
    const double v12 = m3 * wz - m6;
    const dhgen_four s3 = v12 - w3 * (m5 * e3);

    /* r2 */
    const dhgen_four v13 = a3 * s3 - d4 * v11, v14 = c1 * -wy - wx * v8;

    /* theta4 */
    const double v15 = cat2 * T13, v16 = cat2 * T23, v17 = v1 * v15 - v2 * v16,
        v18 = sat2 * T33 + inverse1 * (v4 * v16 + v5 * v15);
    const dhgen_four v19 = w1 * (inverse1 * (e1 * v17)) - v18, v20 = T13 * v8 + T23 * c1,
        X4 = v11 * v19 - s3 * v20;
    const double v21 = sat2 * T13, v22 = sat2 * T23, v23 = v1 * v21 - v2 * v22,
        v24 = cat2 * T33 - inverse1 * (v4 * v22 + v5 * v21);
    const dhgen_four v25 = v24 + w1 * (inverse1 * (e1 * v23)), v26 = v25 * v25, v27 = v26 + X4 * X4,
        v28 = dhgen_signed_four(DHGEN_HALF_TURN, -v25);

    /* theta6 */
    const double v29 = sat2 * T12, v30 = sat2 * T22, v31 = v1 * v29 - v2 * v30,
        v32 = cat2 * T32 - inverse1 * (v4 * v30 + v5 * v29);
    const dhgen_four v33 = v32 + w1 * (inverse1 * (e1 * v31));
    const double v34 = cat2 * T12, v35 = cat2 * T22, v36 = v1 * v34 - v2 * v35,
        v37 = sat2 * T32 + inverse1 * (v4 * v35 + v5 * v34);
    const dhgen_four v38 = w1 * (inverse1 * (e1 * v36)) - v37, v39 = c1 * T22 + v8 * T12;
    const double v40 = sat2 * T11, v41 = sat2 * T21, v42 = v1 * v40 - v2 * v41,
        v43 = cat2 * T31 - inverse1 * (v4 * v41 + v5 * v40);
    const dhgen_four v44 = v43 + w1 * (inverse1 * (e1 * v42));
    const double v45 = cat2 * T11, v46 = cat2 * T21, v47 = v1 * v45 - v2 * v46,
        v48 = sat2 * T31 + inverse1 * (v4 * v46 + v5 * v45);
    const dhgen_four v49 = w1 * (inverse1 * (e1 * v47)) - v48, v50 = c1 * T21 + v8 * T11,
        v51 = v25 * (s3 * v50 - v11 * v49) + X4 * v44;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | (v27 <= m7)) |
        (unsigned)((fabs(D1_squared) <= m1 * (merge_slack1 + 2.0 * fabs(Z1))) | (fabs(D3_squared) <=
        m2 * (blur_slack1 + 2.0 * fabs(Z3))) | (N1 <= doubt_limit_squared2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(s3, -v11),
        ratio2 = dhgen_ratio_four(-v8, c1), ratio3 = dhgen_ratio_four(-v25, -X4),
        ratio4 = dhgen_ratio_four(v51, v25 * (s3 * v39 - v11 * v38) + X4 * v33),
        ratio5 = dhgen_ratio_four(-dhgen_sqrt_four(v27), -(v11 * v20 + s3 * v19));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle5 = dhgen_shuffle(packed1, packed1, 0, 1, 0, 1), packed2 = dhgen_angle_four(ratio2),
        angle4 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2), angle1 = dhgen_angle_four(ratio3),
        angle3 = dhgen_angle_four(ratio4), angle2 = dhgen_angle_four(ratio5);
    const dhgen_four q4_m = angle1 - v28, q6_m = angle3 - dhgen_signed_four(DHGEN_HALF_TURN, v51),
        q1_p = v9 + angle4, q3_p = v3 + angle5;

    dhgen_store_4(q, q + 12, q + 24, q + 36, q1_p, -(v13 + v14), q3_p, angle1);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, angle2, angle3);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, q1_p, -(v13 + v14), q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, -angle2, q6_m);
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
    { 0.8065, 0.8065, 0.8065, 1.0, 1.0, 1.0 }, 0.8064516129032259, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 2, NULL, 0, 52, 1, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL,
    prismatic_2_wrist_fk, prismatic_2_wrist_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) prismatic_2_wrist_##function
#include "dhgen/functions.h"

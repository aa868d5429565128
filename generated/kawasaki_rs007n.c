/* kawasaki_rs007n: Kawasaki RS007N
 *
 * Inverse kinematics, generated from robots/kawasaki_rs007n.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/kawasaki_rs007n.yaml. The formulas and where they come from:
 * kawasaki_rs007n.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 507a4b68dffe081d
 * SPDX-License-Identifier: MIT
 */
#include "kawasaki_rs007n.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(KAWASAKI_RS007N_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(KAWASAKI_RS007N_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef KAWASAKI_RS007N_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    d1 = 0.36, /* joint offset 1 [m] */
    a2 = 0.355, /* link length 2 [m] */
    d4 = 0.375, /* joint offset 4 [m] */
    d6 = 0.078, /* joint offset 6 [m] */
    free_limit1 = 1.1679999999999999e-12, /* a length that fixes no angle [m] */
    offset1 = -1.5707963267948966, /* offset of joint 1 [rad] */
    longest3 = 0.5328999999999999, /* square of the longest reach [m^2] */
    shortest3 = 0.0004000000000000007, /* square of the shortest reach [m^2] */
    longest3_reach = 0.5329000000001705, /* the longest, with what rounding adds [m^2] */
    shortest3_reach = 0.00039999999999532873, /* the shortest, with what rounding adds [m^2] */
    longest3_apart = 0.5328999999999829, /* the longest, where branches merge [m^2] */
    shortest3_apart = 0.00040000000000046796, /* the shortest, where branches merge [m^2] */
    offset2 = -1.5707963267948966, /* offset of joint 2 [rad] */
    free_limit = 1e-12, /* a length that fixes no angle */
    offset4 = 3.141592653589793, /* offset of joint 4 [rad] */
    offset3 = 1.5707963267948966, /* offset of joint 3 [rad] */
    offset5 = 3.141592653589793, /* offset of joint 5 [rad] */
    offset6 = 1.5707963267948966, /* offset of joint 6 [rad] */
    k1 = 0.26625, /* 2 * d4 * a2 [m^2] */
    k2 = 0.26665, /* a2^2 + d4^2 [m^2] */
    k3 = 14.106548524322777; /* 1 / (k1^2) [m^-4] */

#ifndef __CUDACC_RTC__
const char *const kawasaki_rs007n_branches[8] = {
    "front-down-noflip", "front-down-flip", "front-up-noflip", "front-up-flip", "back-up-noflip",
    "back-up-flip", "back-down-noflip", "back-down-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -3.141592653589793, 3.141592653589793, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.356194490192345, 2.356194490192345, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.705260340591211, 2.705260340591211, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -3.490658503988659, 3.490658503988659, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.181661564992912, 2.181661564992912, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -6.283185307179586, 6.283185307179586, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { -1.5707963267948966, -0.36, 0.0, 1.5707963267948966 },
    { -1.5707963267948966, 0.0, 0.355, 3.141592653589793 },
    { 1.5707963267948966, 0.0, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.375, 0.0, 1.5707963267948966 },
    { 3.141592653589793, 0.0, 0.0, 1.5707963267948966 },
    { 1.5707963267948966, 0.078, 0.0, 0.0 },
};
DHGEN_TABLE double base[12] = { 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 };
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, base, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void kawasaki_rs007n_fk(const double q[6], double T[16])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, v3 = s1 * c2, y2_x = c1 * s2,
        v4 = s1 * s2, v5 = q[2] + offset3;
    const double c3 = cos(v5), s3 = sin(v5), x3_x = x2_x * c3 + y2_x * s3, v6 = v3 * c3 + v4 * s3,
        x3_z = c2 * s3 - s2 * c3, v7 = c2 * c3 + s2 * s3, z3_x = x2_x * s3 - y2_x * c3,
        z3_y = v4 * c3 - v3 * s3, v8 = q[3] + offset4;
    const double c4 = cos(v8), s4 = sin(v8), x4_x = x3_x * c4 - s1 * s4, v9 = v6 * c4 + c1 * s4,
        x4_z = x3_z * c4, z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4, z4_y = c1 * c4 - v6 * s4,
        v10 = q[4] + offset5;
    const double c5 = cos(v10), s5 = sin(v10), x5_x = x4_x * c5 + z3_x * s5,
        x5_y = z3_y * s5 - v9 * c5, x5_z = x4_z * c5 - v7 * s5, v11 = z3_y * c5 + v9 * s5,
        z5_z = v7 * c5 + x4_z * s5, z5_x = x4_x * s5 - z3_x * c5, v12 = q[5] + offset6;
    const double c6 = cos(v12), s6 = sin(v12);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = z4_x * c6 - x5_x * s6; T[2] = z5_x;
    T[3] = x2_x * a2 + z3_x * d4 + z5_x * d6;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = z4_y * c6 - x5_y * s6; T[6] = -v11;
    T[7] = z3_y * d4 - v3 * a2 - v11 * d6;
    T[8] = x5_z * c6 + z4_z * s6; T[9] = z4_z * c6 - x5_z * s6; T[10] = z5_z;
    T[11] = d1 - s2 * a2 - v7 * d4 + z5_z * d6;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void kawasaki_rs007n_jacobian(const double q[6], double J[36])
{
    const double v1 = q[0] + offset1;
    const double c1 = cos(v1), s1 = sin(v1), v2 = q[1] + offset2;
    const double c2 = cos(v2), s2 = sin(v2), x2_x = c1 * c2, v3 = s1 * c2, y2_x = c1 * s2,
        v4 = s1 * s2, p2_x = x2_x * a2, v5 = v3 * a2, p2_z = d1 - s2 * a2, v6 = q[2] + offset3;
    const double c3 = cos(v6), s3 = sin(v6), x3_x = x2_x * c3 + y2_x * s3, v7 = v3 * c3 + v4 * s3,
        x3_z = c2 * s3 - s2 * c3, v8 = c2 * c3 + s2 * s3, z3_x = x2_x * s3 - y2_x * c3,
        z3_y = v4 * c3 - v3 * s3, v9 = q[3] + offset4;
    const double c4 = cos(v9), s4 = sin(v9), z4_x = s1 * c4 + x3_x * s4, z4_z = x3_z * s4,
        p4_x = p2_x + z3_x * d4, p4_y = z3_y * d4 - v5, p4_z = p2_z - v8 * d4,
        z4_y = c1 * c4 - v7 * s4, v10 = q[4] + offset5;
    const double c5 = cos(v10), s5 = sin(v10), v11 = z3_y * c5 + (v7 * c4 + c1 * s4) * s5,
        z5_z = v8 * c5 + x3_z * c4 * s5, z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5,
        p6_x = p4_x + z5_x * d6, p6_y = p4_y - v11 * d6, p6_z = p4_z + z5_z * d6, v12 = p6_z - d1,
        v13 = p6_x - p2_x, v14 = v5 + p6_y, v15 = p6_z - p2_z, v16 = p6_x - p4_x, v17 = p6_y - p4_y,
        v18 = p6_z - p4_z;
    J[0] = p6_y; J[1] = c1 * v12; J[2] = -(c1 * v15); J[3] = z3_y * v15 + v8 * v14;
    J[4] = z4_y * v18 - z4_z * v17; J[5] = -(v11 * v18 + z5_z * v17);
    J[6] = -p6_x; J[7] = -(s1 * v12); J[8] = s1 * v15; J[9] = -(v8 * v13 + z3_x * v15);
    J[10] = z4_z * v16 - z4_x * v18; J[11] = z5_z * v16 - z5_x * v18;
    J[12] = 0.0; J[13] = s1 * p6_y - c1 * p6_x; J[14] = c1 * v13 - s1 * v14;
    J[15] = z3_x * v14 - z3_y * v13; J[16] = z4_x * v17 - z4_y * v16;
    J[17] = z5_x * v17 + v11 * v16;
    J[18] = 0.0; J[19] = s1; J[20] = -s1; J[21] = z3_x; J[22] = z4_x; J[23] = z5_x;
    J[24] = 0.0; J[25] = c1; J[26] = -c1; J[27] = z3_y; J[28] = z4_y; J[29] = -v11;
    J[30] = -1.0; J[31] = 0.0; J[32] = 0.0; J[33] = -v8; J[34] = z4_z; J[35] = z5_z;
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
    const double w1 = sqrt(X1 * X1 + wy * wy);
    const int free1 = w1 <= free_limit1;
    const double divisor1 = free1 ? 1.0 : w1;
    const double v1 = seed[0] + offset1;

    /* theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
    const double wz = d6 * T33 - T34;
    const double Z1_3 = wz + d1;
    const double v2 = Z1_3 * Z1_3;

    /* theta4, type 2: U4[3, 3] */
    const double v11 = seed[3] + offset4;

    for (int i1 = 0; i1 < 2; i1++) { /* front, back */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && free1) continue; /* both signs give the same */
        const double factor1 = e1 / divisor1;
        const double c1 = free1 ? cos(v1) : -(X1 * factor1), s1 = free1 ? sin(v1) : wy * factor1;
        const double D1 = w1 * e1;

        /* theta3 */
        const double N3 = v2 + D1 * D1;
        const double K3 = N3 - k2;
        const double D3_squared = (longest3 - N3) * (N3 - shortest3);
        const int apart3 = shortest3_apart < N3 && N3 < longest3_apart;
        if (!(shortest3_reach <= N3 && N3 <= longest3_reach)) continue; /* out of reach */
        const double w3 = sqrt(apart3 ? D3_squared : 0.0);
        const double s3 = k1 * K3 * k3;

        /* theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4] */
        const double X1_2 = a2 + d4 * s3;
        const double v4 = Z1_3 * X1_2, v5 = D1 * X1_2;

        /* theta4 */
        const double v7 = T13 * c1 - T23 * s1, v9 = T23 * c1 + T13 * s1, v10 = v9 * v9;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v12 = T22 * c1 + T12 * s1, v13 = T12 * c1 - T22 * s1,
            v15 = T21 * c1 + T11 * s1, v16 = T11 * c1 - T21 * s1;

        /* joint values */
        const double q1 = dhgen_wrap(atan2(s1, c1) - offset1);

        for (int i2 = 0; i2 < 2; i2++) { /* +, - */
            const double e3 = i2 == 0 ? 1.0 : -1.0;
            /* theta3 */
            if (e3 < 0.0 && !apart3) continue; /* both signs give the same */
            const double v3 = k3 * (k1 * (w3 * e3));

            /* theta2 */
            const double X2_2 = d4 * v3;
            const double S2 = v4 + D1 * X2_2;
            const double C2 = v5 - Z1_3 * X2_2;
            const double w2 = sqrt(S2 * S2 + C2 * C2);
            const double factor2 = 1.0 / w2;
            const double c2 = C2 * factor2, s2 = S2 * factor2;

            /* theta4 */
            const double c2m3 = s3 * s2 - v3 * c2;
            const double v6 = v3 * s2 + s3 * c2, v8 = c2m3 * v7 + T33 * v6;
            const double w4 = sqrt(v8 * v8 + v10);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * c2m3 - v6 * v7;

            /* theta6 */
            const double v14 = c2m3 * v13 + T32 * v6, v17 = c2m3 * v16 + T31 * v6;

            /* joint values */
            const double q2 = dhgen_wrap(atan2(s2, c2) - offset2);
            const double q3 = dhgen_wrap(atan2(s3, -v3) - offset3);

            for (int i3 = 0; i3 < 2; i3++) { /* noflip, flip */
                const double e4 = i3 == 0 ? 1.0 : -1.0;
                /* theta4 */
                if (e4 < 0.0 && free4) continue; /* both signs give the same */
                const double factor4 = e4 / divisor4;
                const double c4 = free4 ? cos(v11) : v8 * factor4,
                    s4 = free4 ? sin(v11) : -(v9 * factor4);
                const double s5 = w4 * e4;

                /* theta6 */
                const double c6 = c4 * v12 + s4 * v14, s6 = c4 * v15 + s4 * v17;

                /* joint values */
                const double q4 = dhgen_wrap(atan2(s4, c4) - offset4);
                const double q5 = dhgen_wrap(atan2(s5, c5) - offset5);
                const double q6 = dhgen_wrap(atan2(s6, c6) - offset6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free1 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef KAWASAKI_RS007N_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.00011679999999999999 [m],
 * doubt_limit = 9.999999999999999e-05. */
static const double
    m1 = 1.3642239999999998e-08, /* doubt_limit1^2 [m^2] */
    /* 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4] */
    m2 = 9.045264537377017e-12,
    m3 = 1.4084507042253522, /* d4 * k1 * k3 [m^-1] */
    m4 = 0.020563380281690184, /* d4 * k1 * k2 * k3 - a2 [m] */
    m5 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide X1 = d6 * T13 - T14, wy = d6 * T23 - T24, v1 = X1 * X1 + wy * wy,
        w1 = dhgen_sqrt_wide(v1), v2 = DHGEN_QUOTIENT(1.0, v1), factor1 = w1 * v2,
        v3 = X1 * factor1, s1 = wy * factor1;

    /* theta3 */
    const dhgen_wide Z1_3 = d1 + (d6 * T33 - T34), N3 = v1 + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = dhgen_sqrt_wide(D3_squared),
        v4 = w3 - w3, v5 = k1 * (N3 - k2), s3 = k3 * v5, v6 = k1 * w3, v7 = k3 * v6;

    /* theta2 */
    const dhgen_wide X1_2 = a2 + d4 * s3, X2_2 = d4 * v7, v8 = Z1_3 * X1_2, v9 = w1 * X2_2,
        v10 = v8 + v9, v11 = v8 - v9, v12 = m3 * N3 - m4, v13 = Z1_3 * v12, v14 = w3 * (m3 * w1),
        S2_pp = v13 + v14, S2_pm = v13 - v14, v15 = w1 * X1_2, v16 = Z1_3 * X2_2, v17 = v15 - v16,
        v18 = v15 + v16, v19 = w3 * (m3 * Z1_3), v20 = w1 * v12, v21 = w1 * -v12, C2_pp = v20 - v19,
        C2_pm = v19 + v20, C2_mp = v21 - v19, C2_mm = v19 + v21, v22 = S2_pp * S2_pp,
        v23 = v22 + C2_pp * C2_pp, v24 = S2_pm * S2_pm, v25 = v24 + C2_pm * C2_pm,
        v26 = v24 + C2_mp * C2_mp, v27 = v22 + C2_mm * C2_mm, w2_pp = dhgen_sqrt_wide(v23),
        w2_pm = dhgen_sqrt_wide(v25), w2_mp = dhgen_sqrt_wide(v26), w2_mm = dhgen_sqrt_wide(v27),
        v28 = DHGEN_QUOTIENT(1.0, v23), v29 = DHGEN_QUOTIENT(1.0, v25),
        v30 = DHGEN_QUOTIENT(1.0, v26), v31 = DHGEN_QUOTIENT(1.0, v27);

    /* theta4 */
    const dhgen_wide v32 = s3 * v10, c2m3_pp = w2_pp * (v28 * (v32 - v7 * v17)),
        v33 = s3 * v11 + v7 * v18, c2m3_pm = w2_pm * (v29 * v33), c2m3_mp = w2_mp * (v30 * v33),
        c2m3_mm = w2_mm * (v31 * (v32 + v7 * -v17)), v34 = v7 * v10,
        v35 = w2_pp * (v28 * (v34 + s3 * v17)), v36 = s3 * v18 - v7 * v11,
        v37 = w2_pm * (v29 * v36), v38 = w2_mp * (v30 * -v36),
        v39 = w2_mm * (v31 * (s3 * -v17 - v34)), v40 = w1 * (v2 * (T13 * X1 + T23 * wy)),
        v41 = T33 * v35 - c2m3_pp * v40, v42 = T33 * v37 - c2m3_pm * v40,
        v43 = T33 * v38 + c2m3_mp * v40, v44 = T33 * v39 + c2m3_mm * v40, v45 = T13 * s1 - T23 * v3,
        v46 = w1 * (v2 * (T13 * wy - X1 * T23)), v47 = v46 * v46, v48 = v47 + v41 * v41,
        v49 = v47 + v42 * v42, v50 = v47 + v43 * v43, v51 = v47 + v44 * v44,
        v52 = DHGEN_QUOTIENT(1.0, v48), v53 = DHGEN_QUOTIENT(1.0, v49),
        v54 = DHGEN_QUOTIENT(1.0, v50), v55 = DHGEN_QUOTIENT(1.0, v51);

    /* theta6 */
    const dhgen_wide v56 = s1 * T12 - v3 * T22, v57 = w1 * (v2 * (X1 * T12 + wy * T22)),
        v58 = s1 * T11 - v3 * T21, v59 = w1 * (v2 * (X1 * T11 + wy * T21));

    /* joint values */
    const dhgen_wide angle1 = dhgen_atan2_wide(wy, -X1), v60 = angle1 - offset1,
        v61 = angle1 - dhgen_signed_wide(DHGEN_HALF_TURN, wy) - offset1,
        angle2 = dhgen_atan2_wide(S2_pp, C2_pp), v62 = angle2 - offset2,
        angle3 = dhgen_atan2_wide(S2_pm, C2_pm), v63 = angle3 - offset2,
        angle4 = dhgen_atan2_wide(S2_pm, C2_mp), v64 = angle4 - offset2,
        angle5 = dhgen_atan2_wide(S2_pp, C2_mm), v65 = angle5 - offset2,
        q2_ppp = dhgen_lowered_wide(v62), q2_pmp = dhgen_lowered_wide(v63),
        q2_mpp = dhgen_lowered_wide(v64), q2_mmp = dhgen_lowered_wide(v65),
        angle6 = dhgen_atan2_wide(v5, -v6), v66 = angle6 - offset3,
        v67 = dhgen_signed_wide(DHGEN_HALF_TURN, v5) - angle6 - offset3,
        q3_ppp = dhgen_raised_wide(v66), q3_pmp = dhgen_raised_wide(v67),
        angle7 = dhgen_atan2_wide(-v46, v41), angle8 = dhgen_atan2_wide(-v46, v42),
        angle9 = dhgen_atan2_wide(v46, v43), angle10 = dhgen_atan2_wide(v46, v44),
        v68 = dhgen_signed_wide(DHGEN_HALF_TURN, -v46),
        v69 = dhgen_signed_wide(DHGEN_HALF_TURN, v46), v70 = angle7 - offset4,
        v71 = angle7 - v68 - offset4, v72 = angle8 - offset4, v73 = angle8 - v68 - offset4,
        v74 = angle9 - offset4, v75 = angle9 - v69 - offset4, v76 = angle10 - offset4,
        v77 = angle10 - v69 - offset4,
        angle11 = dhgen_atan2_wide(dhgen_sqrt_wide(v48), T33 * c2m3_pp + v35 * v40),
        angle12 = dhgen_atan2_wide(dhgen_sqrt_wide(v49), T33 * c2m3_pm + v37 * v40),
        angle13 = dhgen_atan2_wide(dhgen_sqrt_wide(v50), T33 * c2m3_mp - v38 * v40),
        angle14 = dhgen_atan2_wide(dhgen_sqrt_wide(v51), T33 * c2m3_mm - v39 * v40),
        v78 = angle11 - offset5, v79 = offset5 + angle11, v80 = angle12 - offset5,
        v81 = offset5 + angle12, v82 = angle13 - offset5, v83 = offset5 + angle13,
        v84 = angle14 - offset5, v85 = offset5 + angle14, q5_ppp = dhgen_raised_wide(v78),
        q5_ppm = dhgen_only_wide(-v79 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v79,
        q5_pmp = dhgen_raised_wide(v80),
        q5_pmm = dhgen_only_wide(-v81 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v81,
        q5_mpp = dhgen_raised_wide(v82),
        q5_mpm = dhgen_only_wide(-v83 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v83,
        q5_mmp = dhgen_raised_wide(v84),
        q5_mmm = dhgen_only_wide(-v85 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v85,
        v86 = v52 * (v41 * v58 - v45 * (v35 * T31 - c2m3_pp * v59)),
        v87 = v53 * (v42 * v58 - v45 * (v37 * T31 - c2m3_pm * v59)),
        angle15 = dhgen_atan2_wide(v86, v52 * (v41 * v56 - v45 * (v35 * T32 - c2m3_pp * v57))),
        angle16 = dhgen_atan2_wide(v87, v53 * (v42 * v56 - v45 * (v37 * T32 - c2m3_pm * v57))),
        angle17 = dhgen_atan2_wide(-(v54 * (v43 * v58 - v45 * (v38 * T31 + c2m3_mp * v59))), -(v54 *
            (v43 * v56 - v45 * (v38 * T32 + c2m3_mp * v57)))),
        angle18 = dhgen_atan2_wide(-(v55 * (v44 * v58 - v45 * (v39 * T31 + c2m3_mm * v59))), -(v55 *
            (v44 * v56 - v45 * (v39 * T32 + c2m3_mm * v57)))), v88 = angle15 - offset6,
        v89 = angle15 - dhgen_signed_wide(DHGEN_HALF_TURN, v86) - offset6, v90 = angle16 - offset6,
        v91 = angle16 - dhgen_signed_wide(DHGEN_HALF_TURN, v87) - offset6, v92 = angle17 - offset6,
        v93 = angle17 - dhgen_signed_wide(DHGEN_HALF_TURN, -(v54 * (v43 * v58 - v45 * (v38 * T31 +
            c2m3_mp * v59)))) - offset6, v94 = angle18 - offset6,
        v95 = angle18 - dhgen_signed_wide(DHGEN_HALF_TURN, -(v55 * (v44 * v58 - v45 * (v39 * T31 +
            c2m3_mm * v59)))) - offset6, v96 = dhgen_exceeds_wide(q3_ppp, joints + 2),
        v97 = dhgen_exceeds_wide(q3_pmp, joints + 2), q1_ppp = v4 + dhgen_lowered_wide(v60),
        q1_mpp = v4 + dhgen_lowered_wide(v61),
        v98 = dhgen_maximum_wide(v96, dhgen_exceeds_wide(q2_ppp, joints + 1)),
        v99 = dhgen_maximum_wide(v97, dhgen_exceeds_wide(q2_pmp, joints + 1)),
        v100 = dhgen_maximum_wide(v96, dhgen_exceeds_wide(q2_mpp, joints + 1)),
        v101 = dhgen_maximum_wide(v97, dhgen_exceeds_wide(q2_mmp, joints + 1)),
        excess_ppp = dhgen_maximum_wide(v98, dhgen_exceeds_wide(q5_ppp, joints + 4)),
        excess_ppm = dhgen_maximum_wide(v98, dhgen_exceeds_wide(q5_ppm, joints + 4)),
        excess_pmp = dhgen_maximum_wide(v99, dhgen_exceeds_wide(q5_pmp, joints + 4)),
        excess_pmm = dhgen_maximum_wide(v99, dhgen_exceeds_wide(q5_pmm, joints + 4)),
        excess_mpp = dhgen_maximum_wide(v100, dhgen_exceeds_wide(q5_mpp, joints + 4)),
        excess_mpm = dhgen_maximum_wide(v100, dhgen_exceeds_wide(q5_mpm, joints + 4)),
        excess_mmp = dhgen_maximum_wide(v101, dhgen_exceeds_wide(q5_mmp, joints + 4)),
        excess_mmm = dhgen_maximum_wide(v101, dhgen_exceeds_wide(q5_mmm, joints + 4));

    q[0] = q1_ppp; q[1] = q2_ppp; q[2] = q3_ppp; q[3] = dhgen_raised_wide(v70); q[4] = q5_ppp;
    q[5] = dhgen_raised_wide(v88);
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_ppp);
    q[6] = q1_ppp; q[7] = q2_ppp; q[8] = q3_ppp; q[9] = dhgen_raised_wide(v71); q[10] = q5_ppm;
    q[11] = dhgen_raised_wide(v89);
    kind[1] = dhgen_kind_within_wide(q[6], 0.0 < excess_ppm);
    q[12] = q1_ppp; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = dhgen_raised_wide(v72); q[16] = q5_pmp;
    q[17] = dhgen_raised_wide(v90);
    kind[2] = dhgen_kind_within_wide(q[12], 0.0 < excess_pmp);
    q[18] = q1_ppp; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = dhgen_raised_wide(v73); q[22] = q5_pmm;
    q[23] = dhgen_raised_wide(v91);
    kind[3] = dhgen_kind_within_wide(q[18], 0.0 < excess_pmm);
    q[24] = q1_mpp; q[25] = q2_mpp; q[26] = q3_ppp; q[27] = dhgen_raised_wide(v74); q[28] = q5_mpp;
    q[29] = dhgen_raised_wide(v92);
    kind[4] = dhgen_kind_within_wide(q[24], 0.0 < excess_mpp);
    q[30] = q1_mpp; q[31] = q2_mpp; q[32] = q3_ppp; q[33] = dhgen_raised_wide(v75); q[34] = q5_mpm;
    q[35] = dhgen_raised_wide(v93);
    kind[5] = dhgen_kind_within_wide(q[30], 0.0 < excess_mpm);
    q[36] = q1_mpp; q[37] = q2_mmp; q[38] = q3_pmp; q[39] = dhgen_raised_wide(v76); q[40] = q5_mmp;
    q[41] = dhgen_raised_wide(v94);
    kind[6] = dhgen_kind_within_wide(q[36], 0.0 < excess_mmp);
    q[42] = q1_mpp; q[43] = q2_mmp; q[44] = q3_pmp; q[45] = dhgen_raised_wide(v77); q[46] = q5_mmm;
    q[47] = dhgen_raised_wide(v95);
    kind[7] = dhgen_kind_within_wide(q[42], 0.0 < excess_mmm);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D3_squared) <= m2) | (v1 <= m1) | (v51 <= m5) | (v50 <=
        m5) | (v48 <= m5) | (v49 <= m5)) | (dhgen_within_slack_wide(excess_mmm) |
        dhgen_within_slack_wide(excess_mmp) | dhgen_within_slack_wide(excess_mpm) |
        dhgen_within_slack_wide(excess_mpp) | dhgen_within_slack_wide(excess_pmm) |
        dhgen_within_slack_wide(excess_pmp) | dhgen_within_slack_wide(excess_ppp) |
        dhgen_within_slack_wide(excess_ppm));
}

#if DHGEN_LANES > 1
static const double
    m6 = 0.5; /* 1 / 2 */
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
    const double X1 = d6 * T13 - T14, wy = d6 * T23 - T24, v1 = X1 * X1 + wy * wy, w1 = sqrt(v1),
        v2 = DHGEN_QUOTIENT(1.0, v1), factor1 = w1 * v2, v3 = X1 * factor1, s1 = wy * factor1;

    /* theta3 */
    const double Z1_3 = d1 + (d6 * T33 - T34), N3 = v1 + Z1_3 * Z1_3,
        D3_squared = (longest3 - N3) * (N3 - shortest3), w3 = sqrt(D3_squared), v4 = w3 - w3,
        v5 = k1 * (N3 - k2), s3 = k3 * v5, v6 = k1 * w3, v7 = k3 * v6;

    /* theta2 */
    const double X1_2 = a2 + d4 * s3, X2_2 = d4 * v7, v8 = Z1_3 * X1_2, v9 = w1 * X2_2;
    const dhgen_four v10 = e1 * e3, v11 = v8 + v9 * v10;
    const double v12 = m3 * N3 - m4, v13 = Z1_3 * v12;
    const dhgen_four S2 = v13 + w3 * (m3 * (w1 * v10));
    const double v14 = w1 * X1_2, v15 = Z1_3 * X2_2;
    const dhgen_four v16 = e1 * v14, v17 = e3 * v15, v18 = v16 - v17, v19 = w3 * (m3 * (e3 * Z1_3)),
        v20 = w1 * (e1 * v12), C2 = v20 - v19, v21 = S2 * S2 + C2 * C2, w2 = dhgen_sqrt_four(v21),
        v22 = DHGEN_QUOTIENT(1.0, v21);

    /* theta4 */
    const dhgen_four v23 = e3 * v7, c2m3 = w2 * (v22 * (s3 * v11 - v18 * v23)),
        v24 = w2 * (v22 * (v11 * v23 + s3 * v18));
    const double v25 = w1 * (v2 * (T13 * X1 + T23 * wy));
    const dhgen_four v26 = T33 * v24 - e1 * (c2m3 * v25);
    const double v27 = T13 * s1 - T23 * v3, v28 = w1 * (v2 * (T13 * wy - X1 * T23)),
        v29 = v28 * v28;
    const dhgen_four v30 = v29 + v26 * v26, v31 = DHGEN_QUOTIENT(1.0, v30);

    /* theta6 */
    const double v32 = s1 * T12 - v3 * T22, v33 = w1 * (v2 * (X1 * T12 + wy * T22)),
        v34 = s1 * T11 - v3 * T21, v35 = w1 * (v2 * (X1 * T11 + wy * T21));

    /* joint values */
    const double v36 = copysign(DHGEN_HALF_TURN, wy), v39 = copysign(DHGEN_HALF_TURN, v5);
    const dhgen_four v41 = dhgen_signed_four(DHGEN_HALF_TURN, -(e1 * v28)),
        v46 = e1 * (v31 * (v26 * v34 - v27 * (v24 * T31 - e1 * (c2m3 * v35))));

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | (v30 <= m5)) |
        (unsigned)((v1 <= m1) | (fabs(D3_squared) <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(wy, v5, wy, wy),
        dhgen_four_of(-X1, -v6, -X1, -X1)), ratio2 = dhgen_ratio_four(S2, C2),
        ratio3 = dhgen_ratio_four(-(e1 * v28), v26),
        ratio4 = dhgen_ratio_four(dhgen_sqrt_four(v30), T33 * c2m3 + e1 * (v24 * v25)),
        ratio5 = dhgen_ratio_four(v46, e1 * (v31 * (v26 * v32 - v27 * (v24 * T32 - e1 * (c2m3 *
            v33)))));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle1 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0),
        angle3 = dhgen_shuffle(packed1, packed1, 1, 1, 1, 1), angle2 = dhgen_angle_four(ratio2),
        angle4 = dhgen_angle_four(ratio3), angle5 = dhgen_angle_four(ratio4),
        angle6 = dhgen_angle_four(ratio5);
    const dhgen_four v37 = angle1 + v36 * (m6 * (e1 - 1.0)) - offset1, v38 = angle2 - offset2,
        q2_p = dhgen_lowered_four(v38), v40 = e3 * angle3 + v39 * (m6 * (1.0 - e3)) - offset3,
        q3_p = dhgen_raised_four(v40), v42 = angle4 - offset4, v43 = angle4 - v41 - offset4,
        q4_p = dhgen_raised_four(v42), q4_m = dhgen_raised_four(v43), v44 = angle5 - offset5,
        v45 = offset5 + angle5, q5_p = dhgen_raised_four(v44),
        q5_m = dhgen_only_four(-v45 <= -DHGEN_HALF_TURN, DHGEN_TURN) - v45, v47 = angle6 - offset6,
        v48 = angle6 - dhgen_signed_four(DHGEN_HALF_TURN, v46) - offset6,
        q6_p = dhgen_raised_four(v47), q6_m = dhgen_raised_four(v48),
        v49 = dhgen_exceeds_four(q3_p, joints + 2), q1_p = v4 + dhgen_lowered_four(v37),
        v50 = dhgen_maximum_four(v49, dhgen_exceeds_four(q2_p, joints + 1)),
        excess_p = dhgen_maximum_four(v50, dhgen_exceeds_four(q5_p, joints + 4)),
        excess_m = dhgen_maximum_four(v50, dhgen_exceeds_four(q5_m, joints + 4));
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
    { 0.8562, 0.8562, 0.8562, 1.0, 1.0, 1.0 }, 0.8561643835616439, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    1, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, kawasaki_rs007n_fk,
    kawasaki_rs007n_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) kawasaki_rs007n_##function
#include "dhgen/functions.h"

/* stanford: Stanford arm
 *
 * Inverse kinematics, generated from robots/stanford.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/stanford.yaml. The formulas and where they come from: stanford.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: c5078a2be1cf5382
 * SPDX-License-Identifier: MIT
 */
#include "stanford.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(STANFORD_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(STANFORD_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef STANFORD_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack1 = 1.2700000000000001e-13 [m], merge_slack1 = 1.27e-14 [m]. */
static const double
    d1 = 0.412, /* joint offset 1 [m] */
    d2 = 0.154, /* joint offset 2 [m] */
    a3 = 0.0203, /* link length 3 [m] */
    free_limit1 = 1.27e-12, /* a length that fixes no angle [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    k1 = 0.13369999999999999, /* d2 - a3 [m] */
    k2 = 0.01787569, /* k1^2 [m^2] */
    k3 = 3.395980000001613e-14, /* reach_slack1 * (2 * k1 + reach_slack1) [m^2] */
    k4 = 3.3959800000001613e-15; /* merge_slack1 * (2 * k1 + merge_slack1) [m^2] */

#ifndef __CUDACC_RTC__
const char *const stanford_branches[8] = {
    "right-forward-noflip", "right-forward-flip", "right-backward-noflip", "right-backward-flip",
    "left-forward-noflip", "left-forward-flip", "left-backward-noflip", "left-backward-flip",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[6] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { 0.3048, 1.27, 1.27e-09, 0.62000124000248, 1.27, 0.030162500000000002, 0 },
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -1.5707963267948966, 1.5707963267948966, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -2.9670597283903604, 2.9670597283903604, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[6][4] = {
    { 0.0, 0.412, 0.0, -1.5707963267948966 },
    { 0.0, 0.154, 0.0, 1.5707963267948966 },
    { -1.5707963267948966, 0.0, 0.0203, 0.0 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 0.0, 0.0, 1.5707963267948966 },
    { 0.0, 0.0, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 6, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 8

DHGEN_PUBLIC void stanford_fk(const double q[6], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2;
    const double c4 = cos(q[3]), s4 = sin(q[3]), x4_x = s1 * c4 + x2_x * s4,
        x4_y = x2_y * s4 - c1 * c4, v1 = s2 * s4, z4_x = x2_x * c4 - s1 * s4,
        z4_y = x2_y * c4 + c1 * s4, v2 = s2 * c4;
    const double c5 = cos(q[4]), s5 = sin(q[4]), x5_x = x4_x * c5 - z2_x * s5,
        x5_y = x4_y * c5 - z2_y * s5, v3 = v1 * c5 + c2 * s5;
    const double c6 = cos(q[5]), s6 = sin(q[5]);
    T[0] = x5_x * c6 + z4_x * s6; T[1] = z4_x * c6 - x5_x * s6; T[2] = z2_x * c5 + x4_x * s5;
    T[3] = z2_x * q[2] - s1 * d2 + s1 * a3;
    T[4] = x5_y * c6 + z4_y * s6; T[5] = z4_y * c6 - x5_y * s6; T[6] = z2_y * c5 + x4_y * s5;
    T[7] = c1 * d2 + z2_y * q[2] - c1 * a3;
    T[8] = -(v3 * c6 + v2 * s6); T[9] = v3 * s6 - v2 * c6; T[10] = c2 * c5 - v1 * s5;
    T[11] = d1 + c2 * q[2];
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void stanford_jacobian(const double q[6], double J[36])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, z2_x = c1 * s2,
        z2_y = s1 * s2, p3_x = z2_x * q[2] - s1 * d2 + s1 * a3,
        p3_y = c1 * d2 + z2_y * q[2] - c1 * a3;
    const double c4 = cos(q[3]), s4 = sin(q[3]);
    const double c5 = cos(q[4]), s5 = sin(q[4]), v1 = d1 + c2 * q[2] - d1;
    J[0] = -p3_y; J[1] = c1 * v1; J[2] = z2_x; J[3] = 0.0; J[4] = 0.0; J[5] = 0.0;
    J[6] = p3_x; J[7] = s1 * v1; J[8] = z2_y; J[9] = 0.0; J[10] = 0.0; J[11] = 0.0;
    J[12] = 0.0; J[13] = -(s1 * p3_y + c1 * p3_x); J[14] = c2; J[15] = 0.0; J[16] = 0.0;
    J[17] = 0.0;
    J[18] = 0.0; J[19] = -s1; J[20] = 0.0; J[21] = z2_x; J[22] = x2_x * c4 - s1 * s4;
    J[23] = z2_x * c5 + (s1 * c4 + x2_x * s4) * s5;
    J[24] = 0.0; J[25] = c1; J[26] = 0.0; J[27] = z2_y; J[28] = x2_y * c4 + c1 * s4;
    J[29] = z2_y * c5 + (x2_y * s4 - c1 * c4) * s5;
    J[30] = 1.0; J[31] = 0.0; J[32] = 0.0; J[33] = c2; J[34] = -(s2 * c4);
    J[35] = c2 * c5 - s2 * s4 * s5;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[6] = (double (*)[6])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[3, 4] */
    const double N1 = T14 * T14 + T24 * T24;
    const double D1_squared = N1 - k2;
    const int apart1 = k4 < D1_squared;
    if (!(-k3 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double inverse1 = 1.0 / (apart1 ? N1 : k1 * sqrt(N1));
    const double v1 = T14 * k1, v2 = T24 * k1;

    /* theta2, r3, type 4: U1[1, 4] and U1[2, 4] */
    const double Y2_2 = T34 - d1;
    const double v3 = Y2_2 * Y2_2;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = inverse1 * (v2 - T14 * D1), s1 = -(inverse1 * (v1 + T24 * D1));
        const double q1 = atan2(s1, c1);

        /* theta2, r3 */
        const double w3 = sqrt(D1 * D1 + v3);
        const int free2 = w3 <= free_limit1;
        const double divisor2 = free2 ? 1.0 : w3;

        /* theta4, type 2: U4[3, 3] */
        const double X4 = T13 * s1 - T23 * c1;
        const double v4 = T13 * c1 + T23 * s1, v5 = X4 * X4;

        /* theta6, type 3: U4[3, 2] and U4[3, 1] */
        const double v6 = T12 * c1 + T22 * s1, v8 = T22 * c1 - T12 * s1, v9 = T11 * c1 + T21 * s1,
            v11 = T21 * c1 - T11 * s1;

        for (int i2 = 0; i2 < 2; i2++) { /* forward, backward */
            const double e2 = i2 == 0 ? 1.0 : -1.0;
            /* theta2, r3 */
            if (e2 < 0.0 && free2) continue; /* both signs give the same */
            const double factor2 = e2 / divisor2;
            const double c2 = free2 ? cos(seed[1]) : Y2_2 * factor2,
                s2 = free2 ? sin(seed[1]) : -(D1 * factor2);
            const double q2 = atan2(s2, c2);
            const double r3 = w3 * e2;

            /* theta4 */
            const double Y4 = T33 * s2 - c2 * v4;
            const double w4 = sqrt(v5 + Y4 * Y4);
            const int free4 = w4 <= free_limit;
            const double divisor4 = free4 ? 1.0 : w4;

            /* theta5, type 3: U4[2, 3] and U4[1, 3] */
            const double c5 = T33 * c2 + s2 * v4;

            /* theta6 */
            const double v7 = c2 * v6 - T32 * s2, v10 = c2 * v9 - T31 * s2;

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
                const double c6 = c4 * v7 + s4 * v8, s6 = c4 * v10 + s4 * v11;
                const double q6 = atan2(s6, c6);
                const int row = 4 * i1 + 2 * i2 + i3;
                q[row][0] = q1; q[row][1] = q2; q[row][2] = r3; q[row][3] = q4; q[row][4] = q5;
                q[row][5] = q6;
                status[row] = (free2 || free4) ? DHGEN_FREE_JOINT : DHGEN_OK;
            }
        }
    }
}

#ifndef STANFORD_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit1 = 0.000127 [m], doubt_limit = 9.999999999999999e-05. */
static const double
    per_size = 0.7874015748031495, /* slides beyond limits count in the arm's size [m^-1] */
    m1 = 3.3959800000001614e-12, /* 1000 * k4 [m^2] */
    m2 = 1.6129e-08, /* doubt_limit1^2 [m^2] */
    m4 = 9.999999999999999e-09; /* doubt_limit^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide N1 = T14 * T14 + T24 * T24, D1_squared = N1 - k2,
        w1 = dhgen_sqrt_wide(D1_squared), v1 = w1 - w1, inverse1 = DHGEN_QUOTIENT(1.0, N1),
        v2 = k1 * T14, v3 = k1 * T24, v4 = inverse1 * v3, v5 = w1 * (T14 * inverse1),
        c1_p = v4 - v5, c1_m = v4 + v5, v6 = inverse1 * v2, v7 = w1 * (T24 * inverse1),
        v8 = v6 + v7, v9 = v6 - v7, angle1 = dhgen_atan2_wide(-v8, c1_p),
        angle2 = dhgen_atan2_wide(-v9, c1_m);

    /* theta2, r3 */
    const dhgen_wide Y2_2 = T34 - d1, v10 = D1_squared + Y2_2 * Y2_2, w3 = dhgen_sqrt_wide(v10),
        factor2 = w3 * DHGEN_QUOTIENT(1.0, v10), angle3 = dhgen_atan2_wide(-w1, Y2_2),
        q2_pmp = angle3 - dhgen_signed_wide(DHGEN_HALF_TURN, -w1);

    /* theta4 */
    const dhgen_wide c4_p = v8 * T13 + c1_p * T23, c4_m = v9 * T13 + c1_m * T23,
        v11 = inverse1 * (Y2_2 * (T14 * T13 + T24 * T23)) - T33,
        v12 = inverse1 * (Y2_2 * (v2 * T23 - v3 * T13)), Y4_p = v12 + w1 * v11,
        Y4_m = v12 + w1 * -v11, v13 = factor2 * Y4_p, v14 = factor2 * Y4_m,
        v15 = c4_p * c4_p + factor2 * (Y4_p * v13), v16 = c4_m * c4_m + factor2 * (Y4_m * v14),
        angle4 = dhgen_atan2_wide(v13, c4_p), angle5 = dhgen_atan2_wide(v14, c4_m),
        q4_ppm = angle4 - dhgen_signed_wide(DHGEN_HALF_TURN, v13),
        q4_mpm = angle5 - dhgen_signed_wide(DHGEN_HALF_TURN, v14);

    /* theta5 */
    const dhgen_wide v17 = Y2_2 * T33,
        angle6 = dhgen_atan2_wide(-dhgen_sqrt_wide(v15), factor2 * (v17 - w1 * (c1_p * T13 - v8 *
            T23))),
        angle7 = dhgen_atan2_wide(-dhgen_sqrt_wide(v16), factor2 * (v17 + w1 * (c1_m * T13 - v9 *
            T23))), q5_pmp = dhgen_signed_wide(DHGEN_HALF_TURN, -dhgen_sqrt_wide(v15)) - angle6,
        q5_mmp = dhgen_signed_wide(DHGEN_HALF_TURN, -dhgen_sqrt_wide(v16)) - angle7;

    /* theta6 */
    const dhgen_wide v18 = T32 - inverse1 * (Y2_2 * (T14 * T12 + T24 * T22)),
        v19 = inverse1 * (Y2_2 * (v3 * T12 - v2 * T22)),
        v20 = T31 - inverse1 * (Y2_2 * (T14 * T11 + T24 * T21)),
        v21 = inverse1 * (Y2_2 * (v3 * T11 - v2 * T21)),
        s6_p = c4_p * (v21 + w1 * v20) + Y4_p * (c1_p * T21 + v8 * T11),
        s6_m = c4_m * (v21 + w1 * -v20) + Y4_m * (c1_m * T21 + v9 * T11),
        angle8 = dhgen_atan2_wide(s6_p, c4_p * (v19 + w1 * v18) + Y4_p * (c1_p * T22 + v8 * T12)),
        angle9 = dhgen_atan2_wide(s6_m, c4_m * (v19 + w1 * -v18) + Y4_m * (c1_m * T22 + v9 * T12)),
        q6_ppm = angle8 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_p),
        q6_mpm = angle9 - dhgen_signed_wide(DHGEN_HALF_TURN, s6_m);

    /* joint values */
    const dhgen_wide v22 = dhgen_exceeds_wide(angle1, joints),
        v23 = dhgen_exceeds_wide(angle2, joints), v24 = dhgen_exceeds_wide(angle3, joints + 1),
        v25 = dhgen_exceeds_wide(q2_pmp, joints + 1),
        v26 = per_size * dhgen_beyond_wide(w3, joints + 2),
        v27 = per_size * dhgen_maximum_wide(dhgen_low(joints + 2) + w3, -(dhgen_high(joints + 2) +
            w3)), v28 = dhgen_exceeds_wide(angle4, joints + 3),
        v29 = dhgen_exceeds_wide(q4_ppm, joints + 3), v30 = dhgen_exceeds_wide(angle5, joints + 3),
        v31 = dhgen_exceeds_wide(q4_mpm, joints + 3), v32 = dhgen_exceeds_wide(angle6, joints + 4),
        v33 = dhgen_exceeds_wide(q5_pmp, joints + 4), v34 = dhgen_exceeds_wide(angle7, joints + 4),
        v35 = dhgen_exceeds_wide(q5_mmp, joints + 4), q3_ppp = v1 + w3, q3_pmp = v1 - w3,
        v36 = dhgen_maximum_wide(v26, dhgen_maximum_wide(v22, v24)),
        v37 = dhgen_maximum_wide(v27, dhgen_maximum_wide(v22, v25)),
        v38 = dhgen_maximum_wide(v26, dhgen_maximum_wide(v23, v24)),
        v39 = dhgen_maximum_wide(v27, dhgen_maximum_wide(v23, v25)),
        v40 = dhgen_exceeds_wide(angle8, joints + 5),
        excess_ppp = dhgen_maximum_wide(v40, dhgen_maximum_wide(v32, dhgen_maximum_wide(v28, v36))),
        v41 = dhgen_exceeds_wide(q6_ppm, joints + 5),
        excess_ppm = dhgen_maximum_wide(v41, dhgen_maximum_wide(v32, dhgen_maximum_wide(v29, v36))),
        excess_pmp = dhgen_maximum_wide(v41, dhgen_maximum_wide(v33, dhgen_maximum_wide(v28, v37))),
        excess_pmm = dhgen_maximum_wide(v40, dhgen_maximum_wide(v33, dhgen_maximum_wide(v29, v37))),
        v42 = dhgen_exceeds_wide(angle9, joints + 5),
        excess_mpp = dhgen_maximum_wide(v42, dhgen_maximum_wide(v34, dhgen_maximum_wide(v30, v38))),
        v43 = dhgen_exceeds_wide(q6_mpm, joints + 5),
        excess_mpm = dhgen_maximum_wide(v43, dhgen_maximum_wide(v34, dhgen_maximum_wide(v31, v38))),
        excess_mmp = dhgen_maximum_wide(v43, dhgen_maximum_wide(v35, dhgen_maximum_wide(v30, v39))),
        excess_mmm = dhgen_maximum_wide(v42, dhgen_maximum_wide(v35, dhgen_maximum_wide(v31, v39)));

    q[0] = angle1; q[1] = angle3; q[2] = q3_ppp; q[3] = angle4; q[4] = angle6; q[5] = angle8;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_ppp);
    q[6] = angle1; q[7] = angle3; q[8] = q3_ppp; q[9] = q4_ppm; q[10] = -angle6; q[11] = q6_ppm;
    kind[1] = dhgen_kind_within_wide(q[6], 0.0 < excess_ppm);
    q[12] = angle1; q[13] = q2_pmp; q[14] = q3_pmp; q[15] = -angle4; q[16] = q5_pmp; q[17] = q6_ppm;
    kind[2] = dhgen_kind_within_wide(q[12], 0.0 < excess_pmp);
    q[18] = angle1; q[19] = q2_pmp; q[20] = q3_pmp; q[21] = -q4_ppm; q[22] = -q5_pmp;
    q[23] = angle8;
    kind[3] = dhgen_kind_within_wide(q[18], 0.0 < excess_pmm);
    q[24] = angle2; q[25] = -angle3; q[26] = q3_ppp; q[27] = angle5; q[28] = angle7; q[29] = angle9;
    kind[4] = dhgen_kind_within_wide(q[24], 0.0 < excess_mpp);
    q[30] = angle2; q[31] = -angle3; q[32] = q3_ppp; q[33] = q4_mpm; q[34] = -angle7;
    q[35] = q6_mpm;
    kind[5] = dhgen_kind_within_wide(q[30], 0.0 < excess_mpm);
    q[36] = angle2; q[37] = -q2_pmp; q[38] = q3_pmp; q[39] = -angle5; q[40] = q5_mmp;
    q[41] = q6_mpm;
    kind[6] = dhgen_kind_within_wide(q[36], 0.0 < excess_mmp);
    q[42] = angle2; q[43] = -q2_pmp; q[44] = q3_pmp; q[45] = -q4_mpm; q[46] = -q5_mmp;
    q[47] = angle9;
    kind[7] = dhgen_kind_within_wide(q[42], 0.0 < excess_mmm);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] * T[3] * T[3] + T[7] *
        T[7] * T[7] + T[11] * T[11] * T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v10 <= m2) | (dhgen_abs_wide(D1_squared) <= m1) | (v15 <= m4) | (v16 <=
        m4)) | (dhgen_within_slack_wide(excess_mmm) | dhgen_within_slack_wide(excess_mmp) |
        dhgen_within_slack_wide(excess_mpm) | dhgen_within_slack_wide(excess_mpp) |
        dhgen_within_slack_wide(excess_pmm) | dhgen_within_slack_wide(excess_pmp) |
        dhgen_within_slack_wide(excess_ppp) | dhgen_within_slack_wide(excess_ppm));
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
    const dhgen_four e2 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double N1 = T14 * T14 + T24 * T24, D1_squared = N1 - k2, w1 = sqrt(D1_squared),
        v1 = w1 - w1, inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = k1 * T14, v3 = k1 * T24,
        v4 = inverse1 * v3;
    const dhgen_four c1 = v4 - w1 * (inverse1 * (e1 * T14));
    const double v5 = inverse1 * v2;
    const dhgen_four v6 = v5 + w1 * (inverse1 * (e1 * T24));

    /* theta2, r3 */
    const double Y2_2 = T34 - d1, v7 = D1_squared + Y2_2 * Y2_2, w3 = sqrt(v7),
        factor2 = w3 * DHGEN_QUOTIENT(1.0, v7), v8 = copysign(DHGEN_HALF_TURN, -w1);
    const dhgen_four v9 = e2 - 1.0, v10 = m3 * v9;

    /* theta4 */
    const dhgen_four c4 = v6 * T13 + c1 * T23;
    const double v11 = inverse1 * (Y2_2 * (T14 * T13 + T24 * T23)) - T33,
        v12 = inverse1 * (Y2_2 * (v2 * T23 - v3 * T13));
    const dhgen_four Y4 = v12 + w1 * (e1 * v11), v13 = factor2 * Y4,
        v14 = c4 * c4 + factor2 * (Y4 * v13);

    /* theta5 */
    const double v15 = Y2_2 * T33;
    const dhgen_four v16 = dhgen_signed_four(DHGEN_HALF_TURN, -dhgen_sqrt_four(v14)),
        v17 = m3 * -v9;

    /* theta6 */
    const double v18 = T32 - inverse1 * (Y2_2 * (T14 * T12 + T24 * T22)),
        v19 = inverse1 * (Y2_2 * (v3 * T12 - v2 * T22)),
        v20 = T31 - inverse1 * (Y2_2 * (T14 * T11 + T24 * T21)),
        v21 = inverse1 * (Y2_2 * (v3 * T11 - v2 * T21));
    const dhgen_four s6 = c4 * (v21 + w1 * (e1 * v20)) + Y4 * (c1 * T21 + v6 * T11),
        v22 = dhgen_signed_four(DHGEN_HALF_TURN, s6), v23 = m3 * (e2 + 1.0);

    /* joint values */
    const dhgen_four v24 = e2 * w3, v27 = per_size * dhgen_beyond_four(v24, joints + 2),
        q3_p = v1 + v24;

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | (v14 <= m4)) |
        (unsigned)((fabs(D1_squared) <= m1) | (v7 <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_four_of(-w1, -w1, -w1, -w1),
        dhgen_four_of(Y2_2, Y2_2, Y2_2, Y2_2)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(-v6, v13, 0, 5, 2, 7), dhgen_shuffle(c1, c4, 0, 5,
            2, 7)),
        ratio3 = dhgen_ratio_four(dhgen_shuffle(-dhgen_sqrt_four(v14), s6, 0, 5, 2, 7),
            dhgen_shuffle(factor2 * (v15 - e1 * (w1 * (c1 * T13 - v6 * T23))), c4 * (v19 + w1 * (e1
            * v18)) + Y4 * (c1 * T22 + v6 * T12), 0, 5, 2, 7));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle2 = dhgen_shuffle(packed1, packed1, 0, 0, 0, 0), packed2 = dhgen_angle_four(ratio2),
        angle1 = dhgen_shuffle(packed2, packed2, 0, 0, 2, 2),
        angle3 = dhgen_shuffle(packed2, packed2, 1, 1, 3, 3), packed3 = dhgen_angle_four(ratio3),
        angle4 = dhgen_shuffle(packed3, packed3, 0, 0, 2, 2),
        angle5 = dhgen_shuffle(packed3, packed3, 1, 1, 3, 3);
    const dhgen_four q2_ = angle2 + v8 * v10,
        q4__m = angle3 - dhgen_signed_four(DHGEN_HALF_TURN, v13), q5_p = e2 * angle4 + v16 * v17,
        q6_p = angle5 + v10 * v22, q6_m = angle5 - v22 * v23, q2_p = e1 * q2_, q4_p = e2 * angle3,
        q4_m = e2 * q4__m, v25 = dhgen_exceeds_four(angle1, joints),
        v26 = dhgen_exceeds_four(q2_, joints + 1), v28 = dhgen_exceeds_four(angle3, joints + 3),
        v29 = dhgen_exceeds_four(q4__m, joints + 3), v30 = dhgen_exceeds_four(q5_p, joints + 4),
        v31 = dhgen_maximum_four(v27, dhgen_maximum_four(v25, v26)),
        excess_p = dhgen_maximum_four(dhgen_exceeds_four(q6_p, joints + 5), dhgen_maximum_four(v30,
            dhgen_maximum_four(v28, v31))),
        excess_m = dhgen_maximum_four(dhgen_exceeds_four(q6_m, joints + 5), dhgen_maximum_four(v30,
            dhgen_maximum_four(v29, v31)));
    const dhgen_four_mask outside_p = 0.0 < excess_p, outside_m = 0.0 < excess_m;
    if (dhgen_bits_four((dhgen_within_slack_four(excess_p) | dhgen_within_slack_four(excess_m))))
        return -1;

    dhgen_store_4(q, q + 12, q + 24, q + 36, angle1, q2_p, q3_p, q4_p);
    dhgen_store_2(q + 4, q + 16, q + 28, q + 40, q5_p, q6_p);
    dhgen_store_4(q + 6, q + 18, q + 30, q + 42, angle1, q2_p, q3_p, q4_m);
    dhgen_store_2(q + 10, q + 22, q + 34, q + 46, -q5_p, q6_m);
    const unsigned long long none1 = (dhgen_bits_four(angle1 != angle1) * 0x20204040808101ull &
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
DHGEN_TABLE int choosable[2] = { 3, 1 };
DHGEN_TABLE struct dhgen_arm arm = {
    6, 8, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.7874, 0.7874, 0.7874, 1.0, 1.0, 1.0 }, 0.7874015748031495, { 1e-14, 1e-14 }, entries, 9,
    1, /* slides */ 0, /* retries */ 0, /* checks */ 1, /* keeps limits */
    choosable, 2, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 1, /* clamps */ 1, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, stanford_fk,
    stanford_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) stanford_##function
#include "dhgen/functions.h"

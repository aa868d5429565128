/* craig_417: Arm of exercise 4.17 in Craig, Introduction to Robotics
 *
 * Inverse kinematics, generated from robots/craig_417.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/craig_417.yaml. The formulas and where they come from:
 * craig_417.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 0a8b7c253a33639f
 * SPDX-License-Identifier: MIT
 */
#include "craig_417.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(CRAIG_417_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(CRAIG_417_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 4
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef CRAIG_417_PLAIN
#include "dhgen/tile.h"
#endif

/* In formulas below, reach_slack = 1e-13, merge_slack = 1e-14, d3 = 1.0 [m]. */
static const double
    sqrt2 = 1.4142135623730951, /* square root of 2 */
    d4 = 1.0, /* joint offset 4 [m] */
    a3 = 1.0, /* link length 4 [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    free_limit2 = 9e-12, /* a length that fixes no angle [m^2] */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 3.0000000000000004e-05, /* a pose may be rounded by this [m] */
    k1 = 0.5, /* 1 / 2 */
    k2 = 0.7071067811865476, /* sqrt2 * 1 / 2 */
    k3 = 0.5000000000000001, /* k2^2 */
    k4 = 1.4142135623731953e-13, /* reach_slack * (2 * sqrt2 * 1 / 2 + reach_slack) */
    k5 = 1.4142135623731051e-14, /* merge_slack * (2 * sqrt2 * 1 / 2 + merge_slack) */
    k6 = 2.0, /* d3 + d4 [m] */
    k7 = 2.8284271247461903; /* sqrt2 * k6 [m] */

#ifndef __CUDACC_RTC__
const char *const craig_417_branches[2] = {
    "right", "left",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[4] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[4][4] = {
    { 0.0, 0.0, 0.0, 0.0 },
    { 0.0, 0.0, 0.0, -1.5707963267948966 },
    { 0.0, 1.0, 0.0, 0.7853981633974483 },
    { 0.0, 1.0, 1.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 4, DHGEN_MODIFIED, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 6

DHGEN_PUBLIC void craig_417_fk(const double q[4], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2, x2_y = s1 * c2, v1 = c1 * s2 * k2,
        v2 = s1 * s2 * k2, z3_z = c2 * k2, v3 = s1 * k2, z3_x = v1 - v3, v4 = c1 * k2,
        z3_y = v2 + v4, v5 = v1 + v3, v6 = v4 - v2;
    const double c3 = cos(q[2]), s3 = sin(q[2]), x3_x = x2_x * c3 - v5 * s3,
        x3_y = x2_y * c3 + v6 * s3, v7 = s2 * c3 + z3_z * s3, v8 = v5 * c3 + x2_x * s3,
        y3_y = v6 * c3 - x2_y * s3, y3_z = s2 * s3 - z3_z * c3;
    const double c4 = cos(q[3]), s4 = sin(q[3]);
    T[0] = x3_x * c4 - v8 * s4; T[1] = -(v8 * c4 + x3_x * s4); T[2] = z3_x;
    T[3] = z3_x + x3_x * a3 + z3_x * d4;
    T[4] = x3_y * c4 + y3_y * s4; T[5] = y3_y * c4 - x3_y * s4; T[6] = z3_y;
    T[7] = z3_y + x3_y * a3 + z3_y * d4;
    T[8] = y3_z * s4 - v7 * c4; T[9] = y3_z * c4 + v7 * s4; T[10] = z3_z;
    T[11] = z3_z - v7 * a3 + z3_z * d4;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void craig_417_jacobian(const double q[4], double J[24])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]);
    const double c2 = cos(q[1]), s2 = sin(q[1]), v1 = c1 * s2 * k2, v2 = s1 * s2 * k2,
        z3_z = c2 * k2, v3 = s1 * k2, z3_x = v1 - v3, v4 = c1 * k2, z3_y = v2 + v4;
    const double c3 = cos(q[2]), s3 = sin(q[2]),
        p4_x = z3_x + (c1 * c2 * c3 - (v1 + v3) * s3) * a3 + z3_x * d4,
        p4_y = z3_y + (s1 * c2 * c3 + (v4 - v2) * s3) * a3 + z3_y * d4,
        p4_z = z3_z - (s2 * c3 + z3_z * s3) * a3 + z3_z * d4, v5 = p4_x - z3_x, v6 = p4_y - z3_y,
        v7 = p4_z - z3_z;
    J[0] = -p4_y; J[1] = c1 * p4_z; J[2] = z3_y * v7 - z3_z * v6; J[3] = 0.0;
    J[4] = p4_x; J[5] = s1 * p4_z; J[6] = z3_z * v5 - z3_x * v7; J[7] = 0.0;
    J[8] = 0.0; J[9] = -(s1 * p4_y + c1 * p4_x); J[10] = z3_x * v6 - z3_y * v5; J[11] = 0.0;
    J[12] = 0.0; J[13] = -s1; J[14] = z3_x; J[15] = z3_x;
    J[16] = 0.0; J[17] = c1; J[18] = z3_y; J[19] = z3_y;
    J[20] = 1.0; J[21] = 0.0; J[22] = z3_z; J[23] = z3_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[4] = (double (*)[4])rows;
    (void)free_joints; (void)seed; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[2, 3] */
    const double N1 = T13 * T13 + T23 * T23;
    const double D1_squared = N1 - k3;
    const int apart1 = k5 < D1_squared;
    if (!(-k4 <= D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double inverse1 = 1.0 / (apart1 ? N1 : k2 * sqrt(N1));
    const double v1 = T13 * k2, v2 = T23 * k2;

    /* theta2, type 3: U1[3, 3] and U1[1, 3] */
    const double v3 = k2 * T33, v4 = v3 * v3;

    /* theta3, type 3: U2[3, 4] and U2[1, 4] */
    const double v10 = 2.0 * T24, v11 = 2.0 * T14;

    for (int i1 = 0; i1 < 2; i1++) { /* right, left */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && !apart1) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = inverse1 * (v2 - T13 * D1), s1 = -(inverse1 * (v1 + T23 * D1));
        const double q1 = atan2(s1, c1);

        /* theta2 */
        const double S2 = k2 * D1;
        const double w2 = sqrt(S2 * S2 + v4);
        const int short2 = w2 <= free_limit;
        const double v5 = 1.0 / (short2 ? 1.0 : w2);
        const double c2 = v3 * v5, v6 = S2 * v5;
        const double q2 = atan2(-v6, c2);

        /* theta34, type 3: U1[2, 2] and U1[2, 1] */
        const double Z2_34 = T21 * c1 - T11 * s1;
        const double v7 = k2 * Z2_34, v8 = k2 * (T22 * c1 - T12 * s1);
        const double w34 = sqrt(v7 * v7 + v8 * v8);
        const int short34 = w34 <= free_limit;
        const double v9 = 1.0 / (short34 ? 1.0 : w34);
        const double c34 = v8 * v9, s34 = v7 * v9;

        /* theta3 */
        const double v12 = v6 * T34, v13 = a3 * (k1 * (s1 * v11 - c1 * v10 + k7));
        const double C3 = k2 * (c2 * (c1 * T14 + s1 * T24) + v12);
        const double w3 = sqrt(v13 * v13 + C3 * C3);
        const int short3 = w3 <= free_limit2;
        const double factor3 = 1.0 / (short3 ? 1.0 : w3);
        const double c3 = C3 * factor3, v14 = v13 * factor3;
        const double q3 = atan2(-v14, c3);

        /* is the pose one that the arm can take? */
        const double v15 = c1 * c2, v16 = c1 * v6, v17 = s1 * c2, v18 = s1 * v6,
            v19 = k1 * (sqrt2 * s34), v20 = a3 * v14;
        if (!(fabs(c1 * T24 - s1 * T14 - k1 * (sqrt2 * (k6 - v20))) <= pose_slack1 && fabs(T23 * c1
            - T13 * s1 - k2) <= pose_slack && fabs(Z2_34 - v19) <= pose_slack && fabs(T14 * v16 +
            T24 * v18 - c2 * T34 + k1 * (sqrt2 * (k6 + v20))) <= pose_slack1 && fabs(k2 + (T13 * v16
            + T23 * v18 - T33 * c2)) <= pose_slack && fabs(T11 * v16 + T21 * v18 - T31 * c2 - v19)
            <= pose_slack && fabs(v12 + (T14 * v15 + T24 * v17) - a3 * c3) <= pose_slack1 &&
            fabs(T11 * v15 + T21 * v17 + T31 * v6 - c34) <= pose_slack && fabs(T13 * v15 + T23 * v17
            + T33 * v6) <= pose_slack))
            continue; /* the arm can't take this pose */

        /* joint values */
        const double q4 = dhgen_wrap(atan2(s34, c34) - q3);
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3; q[row][3] = q4;
        status[row] = DHGEN_OK;
    }
}

#ifndef CRAIG_417_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05, doubt_limit2 = 0.0009 [m^2]. */
static const double
    m1 = 1.414213562373105e-11, /* 1000 * k5 */
    m2 = 9.999999999999999e-09, /* doubt_limit^2 */
    m3 = 0.7071067811865476, /* k2 */
    m4 = 0.5, /* a3 * k1 [m] */
    m5 = 1.4142135623730951, /* a3 * k1 * k7 [m^2] */
    m6 = 8.1e-07, /* doubt_limit2^2 [m^4] */
    m7 = 9.000000000000002e-10, /* pose_slack1^2 [m^2] */
    m8 = 2.7000000000000006e-09, /* 3 * pose_slack1^2 [m^2] */
    m9 = 1.0000000000000002e-10, /* pose_slack^2 */
    m10 = 6.000000000000001e-10; /* 6 * pose_slack^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide N1 = T13 * T13 + T23 * T23, D1_squared = N1 - k3,
        w1 = dhgen_sqrt_wide(D1_squared), inverse1 = DHGEN_QUOTIENT(1.0, N1), v1 = k2 * T13,
        v2 = k2 * T23, v3 = inverse1 * v2, v4 = w1 * (T13 * inverse1), c1_p = v3 - v4,
        c1_m = v3 + v4, v5 = inverse1 * v1, v6 = w1 * (T23 * inverse1), v7 = v5 + v6, v8 = v5 - v6;

    /* theta2 */
    const dhgen_wide S2 = k2 * w1, v9 = k2 * T33, v10 = v9 * v9 + S2 * S2,
        w2 = dhgen_sqrt_wide(v10), v11 = DHGEN_QUOTIENT(1.0, v10), v12 = w2 * v11, c2 = v9 * v12,
        v13 = S2 * v12, angle1 = dhgen_atan2_wide(-S2, v9);

    /* theta34 */
    const dhgen_wide v14 = T23 * T11 - T13 * T21, v15 = m3 * (inverse1 * (v1 * T11 + v2 * T21)),
        v16 = v15 + w1 * (m3 * (inverse1 * v14)), v17 = v15 + w1 * (m3 * (inverse1 * -v14)),
        v18 = T23 * T12 - T13 * T22, v19 = m3 * (inverse1 * (v1 * T12 + v2 * T22)),
        v20 = v19 + w1 * (m3 * (inverse1 * v18)), v21 = v19 + w1 * (m3 * (inverse1 * -v18)),
        v22 = v16 * v16 + v20 * v20, v23 = v17 * v17 + v21 * v21,
        v24 = dhgen_sqrt_wide(v22) * DHGEN_QUOTIENT(1.0, v22),
        v25 = dhgen_sqrt_wide(v23) * DHGEN_QUOTIENT(1.0, v23);

    /* theta3 */
    const dhgen_wide v26 = 2.0 * T24, v27 = 2.0 * T14, v28 = v13 * T34, v29 = T13 * v26 - T23 * v27,
        v30 = m5 - m4 * (inverse1 * (v1 * v27 + v2 * v26)),
        v31 = v30 + w1 * (m4 * (inverse1 * v29)), v32 = v30 + w1 * (m4 * (inverse1 * -v29)),
        v33 = S2 * T34, C3_p = w2 * (m3 * (v11 * (v33 + v9 * (c1_p * T14 - v7 * T24)))),
        C3_m = w2 * (m3 * (v11 * (v9 * (c1_m * T14 - v8 * T24) - v33))),
        v34 = v31 * v31 + C3_p * C3_p, v35 = v32 * v32 + C3_m * C3_m,
        factor3_p = dhgen_sqrt_wide(v34) * DHGEN_QUOTIENT(1.0, v34),
        factor3_m = dhgen_sqrt_wide(v35) * DHGEN_QUOTIENT(1.0, v35),
        angle2 = dhgen_atan2_wide(-v31, C3_p), angle3 = dhgen_atan2_wide(-v32, C3_m);

    /* is the pose one that the arm can take? */
    const dhgen_wide v36 = c1_p * c2, v37 = c1_m * c2, v38 = c1_p * v13, v39 = c1_m * v13,
        v40 = v7 * c2, v41 = v8 * c2, v42 = v7 * v13, v43 = v8 * v13,
        v44 = k1 * (sqrt2 * (v16 * v24)), v45 = k1 * (sqrt2 * (v17 * v25)),
        v46 = a3 * (v31 * factor3_p), v47 = a3 * (v32 * factor3_m),
        v48 = c1_p * T24 + v7 * T14 - k1 * (sqrt2 * (k6 - v46)),
        v49 = c1_m * T24 + v8 * T14 - k1 * (sqrt2 * (k6 - v47)), v50 = T23 * c1_p + T13 * v7 - k2,
        v51 = T23 * c1_m + T13 * v8 - k2, v52 = c1_p * T21 + v7 * T11 - v44,
        v53 = c1_m * T21 + v8 * T11 - v45, v54 = c2 * T34,
        v55 = T14 * v38 - T24 * v42 - v54 + k1 * (sqrt2 * (k6 + v46)),
        v56 = T24 * v43 - T14 * v39 - v54 + k1 * (sqrt2 * (k6 + v47)), v57 = T33 * c2,
        v58 = k2 + (T13 * v38 - T23 * v42 - v57), v59 = k2 + (T23 * v43 - T13 * v39 - v57),
        v60 = c2 * T31, v61 = T11 * v38 - T21 * v42 - v60 - v44,
        v62 = T21 * v43 - T11 * v39 - v60 - v45,
        v63 = v28 + (T14 * v36 - T24 * v40) - a3 * (C3_p * factor3_p),
        v64 = T14 * v37 - T24 * v41 - v28 - a3 * (C3_m * factor3_m), v65 = v13 * T31,
        v66 = v65 + (T11 * v36 - T21 * v40) - v20 * v24,
        v67 = T11 * v37 - T21 * v41 - v65 - v21 * v25, v68 = T33 * v13,
        v69 = v68 + (T13 * v36 - T23 * v40), v70 = T13 * v37 - T23 * v41 - v68,
        v71 = v48 * v48 + v55 * v55 + v63 * v63, v72 = v49 * v49 + v56 * v56 + v64 * v64,
        v73 = v50 * v50 + v52 * v52 + v58 * v58 + v61 * v61 + v66 * v66 + v69 * v69,
        v74 = v51 * v51 + v53 * v53 + v59 * v59 + v62 * v62 + v67 * v67 + v70 * v70;

    /* joint values */
    const dhgen_wide angle4 = dhgen_atan2_wide(v16, v20), v75 = angle4 - angle2,
        angle5 = dhgen_atan2_wide(v17, v21), v76 = angle5 - angle3;
    const double v77 = DHGEN_NAN;
    const dhgen_wide v78 = dhgen_only_wide(((v71 <= m7) & (v73 <= m9)) == 0, v77),
        v79 = dhgen_only_wide(((v72 <= m7) & (v74 <= m9)) == 0, v77),
        angle6 = dhgen_atan2_wide(-v7, c1_p), angle7 = dhgen_atan2_wide(-v8, c1_m);

    q[0] = v78 + angle6; q[1] = angle1 + v78; q[2] = angle2 + v78;
    q[3] = v78 + dhgen_centred_wide(v75);
    kind[0] = dhgen_kind_wide(q[0]);
    q[4] = v79 + angle7; q[5] = v79 - angle1; q[6] = angle3 + v79;
    q[7] = v79 + dhgen_centred_wide(v76);
    kind[1] = dhgen_kind_wide(q[4]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v35 <= m6) | (v23 <= m2) | (v34 <= m6) | (v22 <= m2) | ((m7 < v72) &
        (v72 <= m8)) | ((m7 < v71) & (v71 <= m8)) | ((m9 < v74) & (v74 <= m10)) |
        (dhgen_abs_wide(D1_squared) <= m1) | (v10 <= m2) | ((m9 < v73) & (v73 <= m10)));
}

#if DHGEN_LANES > 1
/* One regular pose, one sign in lanes. Returns how many rows are OK, or -1 if the pose has to be
 * left to `solve`. */
DHGEN_ALWAYS
DHGEN_INLINE int solve_regular(
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    (void)free_joints;
    const dhgen_four e1 = { 1.0, -1.0, 1.0, -1.0 };
    DHGEN_ENTRIES(double);

    /* theta1 */
    const double N1 = T13 * T13 + T23 * T23, D1_squared = N1 - k3, w1 = sqrt(D1_squared),
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v1 = k2 * T13, v2 = k2 * T23, v3 = inverse1 * v2;
    const dhgen_four c1 = v3 - w1 * (inverse1 * (e1 * T13));
    const double v4 = inverse1 * v1;
    const dhgen_four v5 = v4 + w1 * (inverse1 * (e1 * T23));

    /* theta2 */
    const double S2 = k2 * w1, v6 = k2 * T33, v7 = v6 * v6 + S2 * S2, w2 = sqrt(v7),
        v8 = DHGEN_QUOTIENT(1.0, v7), v9 = w2 * v8, c2 = v6 * v9, v10 = S2 * v9;

    /* theta34 */
    const double v11 = T23 * T11 - T13 * T21, v12 = m3 * (inverse1 * (v1 * T11 + v2 * T21));
    const dhgen_four v13 = v12 + w1 * (m3 * (inverse1 * (e1 * v11)));
    const double v14 = T23 * T12 - T13 * T22, v15 = m3 * (inverse1 * (v1 * T12 + v2 * T22));
    const dhgen_four v16 = v15 + w1 * (m3 * (inverse1 * (e1 * v14))), v17 = v13 * v13 + v16 * v16,
        v18 = dhgen_sqrt_four(v17) * DHGEN_QUOTIENT(1.0, v17);

    /* theta3 */
    const double v19 = 2.0 * T24, v20 = 2.0 * T14, v21 = v10 * T34, v22 = T13 * v19 - T23 * v20,
        v23 = m5 - m4 * (inverse1 * (v1 * v20 + v2 * v19));
    const dhgen_four v24 = v23 + w1 * (m4 * (inverse1 * (e1 * v22))),
        C3 = w2 * (m3 * (v8 * (S2 * (e1 * T34) + v6 * (c1 * T14 - v5 * T24)))),
        v25 = v24 * v24 + C3 * C3, factor3 = dhgen_sqrt_four(v25) * DHGEN_QUOTIENT(1.0, v25);

    /* is the pose one that the arm can take? */
    const dhgen_four v26 = c1 * c2, v27 = c1 * v10, v28 = v5 * c2, v29 = v5 * v10,
        v30 = k1 * (sqrt2 * (v13 * v18)), v31 = a3 * (v24 * factor3),
        v32 = c1 * T24 + v5 * T14 - k1 * (sqrt2 * (k6 - v31)), v33 = T23 * c1 + T13 * v5 - k2,
        v34 = c1 * T21 + v5 * T11 - v30;
    const double v35 = c2 * T34;
    const dhgen_four v36 = e1 * (T14 * v27 - T24 * v29) - v35 + k1 * (sqrt2 * (k6 + v31));
    const double v37 = T33 * c2;
    const dhgen_four v38 = k2 + (e1 * (T13 * v27 - T23 * v29) - v37);
    const double v39 = c2 * T31;
    const dhgen_four v40 = e1 * (T11 * v27 - T21 * v29) - v39 - v30,
        v41 = e1 * v21 + (T14 * v26 - T24 * v28) - a3 * (C3 * factor3);
    const double v42 = v10 * T31;
    const dhgen_four v43 = T11 * v26 - T21 * v28 + e1 * v42 - v16 * v18;
    const double v44 = T33 * v10;
    const dhgen_four v45 = T13 * v26 - T23 * v28 + e1 * v44,
        v46 = v32 * v32 + v36 * v36 + v41 * v41,
        v47 = v33 * v33 + v34 * v34 + v38 * v38 + v40 * v40 + v43 * v43 + v45 * v45;

    /* joint values */
    const double v49 = DHGEN_NAN;
    const dhgen_four v50 = dhgen_only_four(((v46 <= m7) & (v47 <= m9)) == 0, v49);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((v25 <= m6) |
        (v17 <= m2) | ((m9 < v47) & (v47 <= m10)) | ((m7 < v46) & (v46 <= m8)))) |
        (unsigned)((fabs(D1_squared) <= m1) | (v7 <= m2)))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(dhgen_shuffle(-v5, dhgen_all_four(-S2), 0,
        1, 6, 3), dhgen_shuffle(c1, dhgen_all_four(v6), 0, 1, 6, 3)),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(-v24, v13, 0, 1, 6, 7), dhgen_shuffle(C3, v16, 0, 1,
            6, 7));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle4 = dhgen_shuffle(packed1, packed1, 0, 1, 0, 1),
        angle1 = dhgen_shuffle(packed1, packed1, 2, 2, 2, 2), packed2 = dhgen_angle_four(ratio2),
        angle2 = dhgen_shuffle(packed2, packed2, 0, 1, 0, 1),
        angle3 = dhgen_shuffle(packed2, packed2, 2, 3, 2, 3);
    const dhgen_four v48 = angle3 - angle2, q1 = v50 + angle4, q2 = v50 + e1 * angle1,
        q3 = angle2 + v50, q4 = v50 + dhgen_centred_four(v48);

    dhgen_store_4(q, q + 4, q, q + 4, q1, q2, q3, q4);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE struct dhgen_arm arm = {
    4, 2, 0, DHGEN_POSE, joints, NULL, 0,
    { 0.3333, 0.3333, 0.3333, 1.0, 1.0, 1.0 }, 0.3333333333333333, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */ NULL, 0, NULL, 0, 52,
    0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */ 0, /* range exceeds a turn */
    1, /* follows seed */ NULL, NULL, NULL, NULL, craig_417_fk, craig_417_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) craig_417_##function
#include "dhgen/functions.h"

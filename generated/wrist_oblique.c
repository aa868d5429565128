/* wrist_oblique: Oblique spherical wrist
 *
 * Inverse kinematics, generated from robots/wrist_oblique.yaml and templates/c/solver.c.jinja.
 * Do not edit: run dhgen robots/wrist_oblique.yaml. The formulas and where they come from:
 * wrist_oblique.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 1cbcbf07d0e3a04a
 * SPDX-License-Identifier: MIT
 */
#include "wrist_oblique.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(WRIST_OBLIQUE_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(WRIST_OBLIQUE_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_DOF 3
#define DHGEN_ROWS 2
#include "dhgen/ik.h"
#include "dhgen/velocities.h"
#include "dhgen/frames.h"
#ifndef WRIST_OBLIQUE_PLAIN
#include "dhgen/tile.h"
#endif

static const double
    sqrt3 = 1.7320508075688772, /* square root of 3 */
    ca2 = 0.6427876096865394, /* cosine of twist 2 */
    sa2 = 0.766044443118978, /* sine of twist 2 */
    d3 = 0.1, /* joint offset 3 [m] */
    free_limit_squared2 = 1.0000000000000002e-26, /* square of a length that fixes no angle [m^2] */
    reach_slack1 = 1.0000000000000002e-14, /* rounding at the boundary of the workspace [m] */
    merge_slack1 = 1e-15, /* nearer to that boundary two branches are one [m] */
    free_limit = 1e-12, /* a length that fixes no angle */
    pose_slack = 1e-05, /* a pose may be rounded by this */
    pose_slack1 = 1.0000000000000002e-06, /* a pose may be rounded by this [m] */
    k1 = 0.5, /* 1 / 2 */
    k2 = 0.06427876096865394, /* d3 * ca2 [m] */
    k3 = 0.12855752193730788, /* 2 * d3 * ca2 [m] */
    k4 = 0.6634139481689384, /* sa2 * sqrt3 / 2 */
    k5 = 0.8660254037844386, /* sqrt3 / 2 */
    f2 = 0.8660254037844386, /* 1 / 2 * sqrt3 */
    f3 = 0.383022221559489, /* sa2 * 1 / 2 */
    f4 = 0.3213938048432697; /* ca2 * 1 / 2 */

#ifndef __CUDACC_RTC__
const char *const wrist_oblique_branches[2] = {
    "shoulder+", "shoulder-",
};
#endif

DHGEN_TABLE struct dhgen_joint joints[3] = {
    /* lowest, highest, slack of limits; weight; pace; fan step; whether it turns */
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
};

/* The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad]. */
DHGEN_TABLE double table[3][4] = {
    { 0.0, 0.0, 0.0, 1.0471975511965976 },
    { 0.0, 0.0, 0.0, -0.8726646259971648 },
    { 0.0, 0.1, 0.0, 0.0 },
};
DHGEN_TABLE struct dhgen_links links = { 3, DHGEN_STANDARD, joints, &table[0][0], NULL, NULL, NULL
    };
#define DHGEN_FRAMES 5

DHGEN_PUBLIC void wrist_oblique_fk(const double q[3], double T[16])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), v1 = s1 * k1, y1_y = c1 * k1, z1_x = s1 * f2,
        v2 = c1 * f2;
    const double c2 = cos(q[1]), s2 = sin(q[1]), x2_x = c1 * c2 - v1 * s2,
        x2_y = s1 * c2 + y1_y * s2, x2_z = f2 * s2, v3 = v1 * c2 + c1 * s2,
        v4 = y1_y * c2 - s1 * s2, v5 = f2 * c2, v6 = v3 * ca2 + z1_x * sa2,
        y2_y = v4 * ca2 + v2 * sa2, y2_z = v5 * ca2 - f3, z2_x = z1_x * ca2 - v3 * sa2,
        z2_y = v4 * sa2 - v2 * ca2, z2_z = v5 * sa2 + f4;
    const double c3 = cos(q[2]), s3 = sin(q[2]);
    T[0] = x2_x * c3 - v6 * s3; T[1] = -(v6 * c3 + x2_x * s3); T[2] = z2_x; T[3] = z2_x * d3;
    T[4] = x2_y * c3 + y2_y * s3; T[5] = y2_y * c3 - x2_y * s3; T[6] = z2_y; T[7] = z2_y * d3;
    T[8] = x2_z * c3 + y2_z * s3; T[9] = y2_z * c3 - x2_z * s3; T[10] = z2_z; T[11] = z2_z * d3;
    T[12] = T[13] = T[14] = 0.0; T[15] = 1.0;
}

DHGEN_PUBLIC void wrist_oblique_jacobian(const double q[3], double J[18])
{
    const double c1 = cos(q[0]), s1 = sin(q[0]), z1_x = s1 * f2, v1 = c1 * f2;
    const double c2 = cos(q[1]), s2 = sin(q[1]), z2_x = z1_x * ca2 - (s1 * k1 * c2 + c1 * s2) * sa2,
        z2_y = (c1 * k1 * c2 - s1 * s2) * sa2 - v1 * ca2, z2_z = f2 * c2 * sa2 + f4,
        p3_x = z2_x * d3, p3_y = z2_y * d3, p3_z = z2_z * d3;
    J[0] = -p3_y; J[1] = -(v1 * p3_z + k1 * p3_y); J[2] = z2_y * p3_z - z2_z * p3_y;
    J[3] = p3_x; J[4] = k1 * p3_x - z1_x * p3_z; J[5] = z2_z * p3_x - z2_x * p3_z;
    J[6] = 0.0; J[7] = z1_x * p3_y + v1 * p3_x; J[8] = z2_x * p3_y - z2_y * p3_x;
    J[9] = 0.0; J[10] = z1_x; J[11] = z2_x;
    J[12] = 0.0; J[13] = -v1; J[14] = z2_y;
    J[15] = 1.0; J[16] = k1; J[17] = z2_z;
}

/* Fills the rows of the branches that have a solution, and no others. */
DHGEN_FN void solve(const double *T, const double *free_joints, const double *seed, double moved,
    double *rows, unsigned char *status)
{
    double (*const q)[3] = (double (*)[3])rows;
    (void)free_joints; (void)moved;
    DHGEN_ENTRIES(double);

    /* theta1, type 2: U1[3, 4] */
    const double v1 = T14 * sqrt3 * k1;
    const double Y1 = k1 * (sqrt3 * T24);
    const double N1 = v1 * v1 + Y1 * Y1;
    const int free1 = N1 <= free_limit_squared2;
    const double Z1 = k1 * (T34 - k3);
    const double D1_squared = N1 - Z1 * Z1;
    const double v2 = fabs(Z1), v3 = 2.0 * v2;
    const int apart1 = merge_slack1 * (v3 + merge_slack1) < D1_squared;
    if (!(-(reach_slack1 * (v3 + reach_slack1)) < D1_squared)) return; /* out of reach */
    const double w1 = sqrt(apart1 ? D1_squared : 0.0);
    const double inverse1 = 1.0 / (free1 ? 1.0 : (apart1 ? N1 : v2 * sqrt(N1)));
    const double v4 = v1 * Z1, v5 = Y1 * Z1;

    /* theta3, type 3: U1[3, 2] and U1[3, 1] */
    const double v6 = sqrt3 * T22, v7 = T12 * sqrt3, v8 = sqrt3 * T21, v9 = T11 * sqrt3;

    /* theta2, type 3: U0 A3^-1 [3, 3] and U0 A3^-1 [3, 1] */
    const double v14 = k1 * (2.0 * T33 - ca2) * k5, v15 = v14 * v14;

    /* is the pose one that the arm can take? */
    const double v21 = T31 * k5, v22 = T33 * k5, v24 = T34 * k5, v27 = k1 * T31, v28 = k1 * T33,
        v29 = k1 * T34;

    for (int i1 = 0; i1 < 2; i1++) { /* shoulder+, shoulder- */
        const double e1 = i1 == 0 ? 1.0 : -1.0;
        /* theta1 */
        if (e1 < 0.0 && (free1 || !apart1)) continue; /* both signs give the same */
        const double D1 = w1 * e1;
        const double c1 = free1 ? cos(seed[0]) : inverse1 * (v5 + v1 * D1),
            s1 = free1 ? sin(seed[0]) : inverse1 * (Y1 * D1 - v4);
        const double q1 = atan2(s1, c1);

        /* theta3 */
        const double S3 = sa2 * (k1 * (T31 + (s1 * v9 - c1 * v8)));
        const double C3 = sa2 * (k1 * (T32 + (s1 * v7 - c1 * v6)));
        const double w3 = sqrt(S3 * S3 + C3 * C3);
        const int short3 = w3 <= free_limit;
        const double v10 = 1.0 / (short3 ? 1.0 : w3), v11 = C3 * v10, v12 = S3 * v10;
        const double q3 = atan2(-v12, -v11);

        /* theta2 */
        const double v13 = k4 * (T32 * v12 - T31 * v11);
        const double w2 = sqrt(v13 * v13 + v15);
        const int short2 = w2 <= free_limit;
        const double v16 = 1.0 / (short2 ? 1.0 : w2);
        const double c2 = v14 * v16, s2 = v13 * v16;
        const double q2 = atan2(s2, c2);

        /* is the pose one that the arm can take? */
        const double v17 = ca2 * v12, v18 = sa2 * s2, v19 = k1 * s1, v20 = k1 * c1, v23 = sa2 * c2,
            v25 = k1 * (sqrt3 * s1), v26 = k1 * (sqrt3 * c1);
        if (!(fabs(T14 * v25 - T24 * v26 + v29 - k2) <= pose_slack1 && fabs(T13 * v25 - T23 * v26 +
            v28 - ca2) <= pose_slack && fabs(T11 * v25 - T21 * v26 + v27 - sa2 * v12) <= pose_slack
            && fabs(T24 * v20 - T14 * v19 + v24 - d3 * v23) <= pose_slack1 && fabs(T23 * v20 - T13 *
            v19 + v22 - v23) <= pose_slack && fabs(T21 * v20 - T11 * v19 + v21 + (c2 * v17 + v11 *
            s2)) <= pose_slack && fabs(T14 * c1 + T24 * s1 + d3 * v18) <= pose_slack1 && fabs(T11 *
            c1 + T21 * s1 - (s2 * v17 - v11 * c2)) <= pose_slack && fabs(T13 * c1 + T23 * s1 + v18)
            <= pose_slack))
            continue; /* the arm can't take this pose */
        const int row = i1;
        q[row][0] = q1; q[row][1] = q2; q[row][2] = q3;
        status[row] = free1 ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

#ifndef WRIST_OBLIQUE_PLAIN
/* Regular poses: what follows is as fast as it can be, and solves nothing that `solve` doesn't. */
#define DHGEN_SOLVE_WIDE solve_wide
/* In formulas below, doubt_limit = 9.999999999999999e-05. */
static const double
    /* square of a length that fixes no angle [m^2] */
    doubt_limit_squared2 = 1.0000000000000002e-10,
    m1 = 1e-12, /* 1000 * merge_slack1 [m] */
    m2 = 0.383022221559489, /* sa2 * k1 */
    m3 = 9.999999999999999e-09, /* doubt_limit^2 */
    m4 = 0.5, /* k1 */
    m5 = 0.8660254037844386, /* sqrt3 * k1 */
    m6 = 1.0000000000000004e-12, /* pose_slack1^2 [m^2] */
    m7 = 3.000000000000001e-12, /* 3 * pose_slack1^2 [m^2] */
    m8 = 1.0000000000000002e-10, /* pose_slack^2 */
    m9 = 6.000000000000001e-10; /* 6 * pose_slack^2 */

/* As many poses as there are lanes: joint values, NaN without a solution, statuses, and whether a
 * pose has to be left to `solve`. */
DHGEN_INLINE dhgen_wide_mask solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind)
{
    (void)free_joints;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = k1 * (sqrt3 * T14), Y1 = k1 * (sqrt3 * T24), N1 = v1 * v1 + Y1 * Y1,
        Z1 = k1 * (T34 - k3), D1_squared = N1 - Z1 * Z1, w1 = dhgen_sqrt_wide(D1_squared),
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = v1 * Z1, v3 = Y1 * Z1, v4 = v1 * w1,
        c1_p = v3 + v4, c1_m = v3 - v4, v5 = Y1 * w1, s1_p = v5 - v2, v6 = v2 + v5;

    /* theta3 */
    const dhgen_wide v7 = sqrt3 * T22, v8 = sqrt3 * T12, v9 = sqrt3 * T21, v10 = sqrt3 * T11,
        v11 = Y1 * v10 - v1 * v9, v12 = m2 * (T31 - inverse1 * (v2 * v10 + v3 * v9)),
        S3_p = v12 + w1 * (m2 * (inverse1 * v11)), S3_m = v12 + w1 * (m2 * (inverse1 * -v11)),
        v13 = Y1 * v8 - v1 * v7, v14 = m2 * (T32 - inverse1 * (v2 * v8 + v3 * v7)),
        C3_p = v14 + w1 * (m2 * (inverse1 * v13)), C3_m = v14 + w1 * (m2 * (inverse1 * -v13)),
        v15 = S3_p * S3_p + C3_p * C3_p, v16 = S3_m * S3_m + C3_m * C3_m,
        v17 = dhgen_sqrt_wide(v15) * DHGEN_QUOTIENT(1.0, v15),
        v18 = dhgen_sqrt_wide(v16) * DHGEN_QUOTIENT(1.0, v16), v19 = C3_p * v17, v20 = C3_m * v18,
        v21 = S3_p * v17, v22 = S3_m * v18;

    /* theta2 */
    const dhgen_wide v23 = k4 * (T32 * v21 - T31 * v19), v24 = k4 * (T32 * v22 - T31 * v20),
        v25 = k5 * (k1 * (2.0 * T33 - ca2)), v26 = v25 * v25, v27 = v26 + v23 * v23,
        v28 = v26 + v24 * v24, v29 = dhgen_sqrt_wide(v27) * DHGEN_QUOTIENT(1.0, v27),
        v30 = dhgen_sqrt_wide(v28) * DHGEN_QUOTIENT(1.0, v28), c2_p = v25 * v29, c2_m = v25 * v30,
        s2_p = v23 * v29, s2_m = v24 * v30;

    /* is the pose one that the arm can take? */
    const dhgen_wide v31 = ca2 * v21, v32 = ca2 * v22, v33 = sa2 * s2_p, v34 = sa2 * s2_m,
        v35 = m4 * v2, v36 = w1 * (m4 * Y1), v37 = v36 - v35, v38 = v35 + v36, v39 = m4 * v3,
        v40 = w1 * (m4 * v1), v41 = v39 + v40, v42 = v39 - v40, v43 = k5 * T31, v44 = k5 * T33,
        v45 = sa2 * c2_p, v46 = sa2 * c2_m, v47 = k5 * T34, v48 = m5 * v2, v49 = w1 * (m5 * Y1),
        v50 = v49 - v48, v51 = v48 + v49, v52 = m5 * v3, v53 = w1 * (m5 * v1), v54 = v52 + v53,
        v55 = v52 - v53, v56 = k1 * T31, v57 = k1 * T33, v58 = k1 * T34,
        v59 = v58 + inverse1 * (T14 * v50 - T24 * v54) - k2,
        v60 = v58 - inverse1 * (T14 * v51 + T24 * v55) - k2,
        v61 = v57 + inverse1 * (v50 * T13 - v54 * T23) - ca2,
        v62 = v57 - inverse1 * (v51 * T13 + v55 * T23) - ca2,
        v63 = v56 + inverse1 * (T11 * v50 - T21 * v54) - sa2 * v21,
        v64 = v56 - inverse1 * (T11 * v51 + T21 * v55) - sa2 * v22,
        v65 = v47 + inverse1 * (T24 * v41 - T14 * v37) - d3 * v45,
        v66 = v47 + inverse1 * (T24 * v42 + T14 * v38) - d3 * v46,
        v67 = v44 + inverse1 * (v41 * T23 - v37 * T13) - v45,
        v68 = v44 + inverse1 * (v42 * T23 + v38 * T13) - v46,
        v69 = v43 + inverse1 * (T21 * v41 - T11 * v37) + (c2_p * v31 + v19 * s2_p),
        v70 = v43 + inverse1 * (T21 * v42 + T11 * v38) + (c2_m * v32 + v20 * s2_m),
        v71 = d3 * v33 + inverse1 * (T14 * c1_p + T24 * s1_p),
        v72 = d3 * v34 + inverse1 * (T14 * c1_m - T24 * v6),
        v73 = inverse1 * (c1_p * T11 + s1_p * T21) - (s2_p * v31 - v19 * c2_p),
        v74 = inverse1 * (c1_m * T11 - v6 * T21) - (s2_m * v32 - v20 * c2_m),
        v75 = v33 + inverse1 * (c1_p * T13 + s1_p * T23),
        v76 = v34 + inverse1 * (c1_m * T13 - v6 * T23), v77 = v59 * v59 + v65 * v65 + v71 * v71,
        v78 = v60 * v60 + v66 * v66 + v72 * v72,
        v79 = v61 * v61 + v63 * v63 + v67 * v67 + v69 * v69 + v73 * v73 + v75 * v75,
        v80 = v62 * v62 + v64 * v64 + v68 * v68 + v70 * v70 + v74 * v74 + v76 * v76;

    /* joint values */
    const double v81 = DHGEN_NAN;
    const dhgen_wide v82 = dhgen_only_wide(((v77 <= m6) & (v79 <= m8)) == 0, v81),
        v83 = dhgen_only_wide(((v78 <= m6) & (v80 <= m8)) == 0, v81),
        angle1 = dhgen_atan2_wide(s1_p, c1_p), angle2 = dhgen_atan2_wide(-v6, c1_m),
        angle3 = dhgen_atan2_wide(v23, v25), angle4 = dhgen_atan2_wide(v24, v25),
        angle5 = dhgen_atan2_wide(-S3_p, -C3_p), angle6 = dhgen_atan2_wide(-S3_m, -C3_m);

    q[0] = v82 + angle1; q[1] = v82 + angle3; q[2] = v82 + angle5;
    kind[0] = dhgen_kind_wide(q[0]);
    q[3] = v83 + angle2; q[4] = v83 + angle4; q[5] = v83 + angle6;
    kind[1] = dhgen_kind_wide(q[3]);
    const dhgen_wide_mask exact = dhgen_pose_misfit_wide(T) + 0.0 * (T[3] + T[7] + T[11]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v28 <= m3) | (v16 <= m3) | (v27 <= m3) | (v15 <= m3) | ((m6 < v78) &
        (v78 <= m7)) | ((m6 < v77) & (v77 <= m7)) | ((m8 < v80) & (v80 <= m9)) | (N1 <=
        doubt_limit_squared2) | (dhgen_abs_wide(D1_squared) <= m1 * (merge_slack1 + 2.0 *
        dhgen_abs_wide(Z1))) | ((m8 < v79) & (v79 <= m9)));
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
    const double v1 = k1 * (sqrt3 * T14), Y1 = k1 * (sqrt3 * T24), N1 = v1 * v1 + Y1 * Y1,
        Z1 = k1 * (T34 - k3), D1_squared = N1 - Z1 * Z1, w1 = sqrt(D1_squared),
        inverse1 = DHGEN_QUOTIENT(1.0, N1), v2 = v1 * Z1, v3 = Y1 * Z1, v4 = v1 * w1;
    const dhgen_four c1 = v3 + e1 * v4, v5 = e1 * v1;
    const double v6 = Y1 * w1;
    const dhgen_four s1 = e1 * v6 - v2, v7 = e1 * Y1;

    /* theta3 */
    const double v8 = sqrt3 * T22, v9 = sqrt3 * T12, v10 = sqrt3 * T21, v11 = sqrt3 * T11,
        v12 = Y1 * v11 - v1 * v10, v13 = m2 * (T31 - inverse1 * (v2 * v11 + v3 * v10));
    const dhgen_four S3 = v13 + w1 * (m2 * (inverse1 * (e1 * v12)));
    const double v14 = Y1 * v9 - v1 * v8, v15 = m2 * (T32 - inverse1 * (v2 * v9 + v3 * v8));
    const dhgen_four C3 = v15 + w1 * (m2 * (inverse1 * (e1 * v14))), v16 = S3 * S3 + C3 * C3,
        v17 = dhgen_sqrt_four(v16) * DHGEN_QUOTIENT(1.0, v16), v18 = C3 * v17, v19 = S3 * v17;

    /* theta2 */
    const dhgen_four v20 = k4 * (T32 * v19 - T31 * v18);
    const double v21 = k5 * (k1 * (2.0 * T33 - ca2)), v22 = v21 * v21;
    const dhgen_four v23 = v22 + v20 * v20, v24 = dhgen_sqrt_four(v23) * DHGEN_QUOTIENT(1.0, v23),
        c2 = v21 * v24, s2 = v20 * v24;

    /* is the pose one that the arm can take? */
    const dhgen_four v25 = ca2 * v19, v26 = sa2 * s2;
    const double v27 = m4 * v2;
    const dhgen_four v28 = w1 * (m4 * v7) - v27;
    const double v29 = m4 * v3;
    const dhgen_four v30 = v29 + w1 * (m4 * v5);
    const double v31 = k5 * T31, v32 = k5 * T33;
    const dhgen_four v33 = sa2 * c2;
    const double v34 = k5 * T34, v35 = m5 * v2;
    const dhgen_four v36 = w1 * (m5 * v7) - v35;
    const double v37 = m5 * v3;
    const dhgen_four v38 = v37 + w1 * (m5 * v5);
    const double v39 = k1 * T31, v40 = k1 * T33, v41 = k1 * T34;
    const dhgen_four v42 = v41 + inverse1 * (T14 * v36 - T24 * v38) - k2,
        v43 = v40 + inverse1 * (v36 * T13 - v38 * T23) - ca2,
        v44 = v39 + inverse1 * (T11 * v36 - T21 * v38) - sa2 * v19,
        v45 = v34 + inverse1 * (T24 * v30 - T14 * v28) - d3 * v33,
        v46 = v32 + inverse1 * (v30 * T23 - v28 * T13) - v33,
        v47 = v31 + inverse1 * (T21 * v30 - T11 * v28) + (c2 * v25 + v18 * s2),
        v48 = d3 * v26 + inverse1 * (T14 * c1 + T24 * s1),
        v49 = inverse1 * (c1 * T11 + s1 * T21) - (s2 * v25 - v18 * c2),
        v50 = v26 + inverse1 * (c1 * T13 + s1 * T23), v51 = v42 * v42 + v45 * v45 + v48 * v48,
        v52 = v43 * v43 + v44 * v44 + v46 * v46 + v47 * v47 + v49 * v49 + v50 * v50;

    /* joint values */
    const double v53 = DHGEN_NAN;
    const dhgen_four v54 = dhgen_only_four(((v51 <= m6) & (v52 <= m8)) == 0, v53);

    if (dhgen_bits_four(((dhgen_pose_misfit_four(T) <= DHGEN_ORTHONORMAL) == 0) | ((v23 <= m3) |
        (v16 <= m3) | ((m8 < v52) & (v52 <= m9)) | ((m6 < v51) & (v51 <= m7)))) | (unsigned)((N1 <=
        doubt_limit_squared2) | (fabs(D1_squared) <= m1 * (merge_slack1 + 2.0 * fabs(Z1)))))
        return -1;

    const dhgen_direction_four ratio1 = dhgen_ratio_four(-S3, -C3),
        ratio2 = dhgen_ratio_four(dhgen_shuffle(s1, v20, 0, 1, 6, 7), dhgen_shuffle(c1,
            dhgen_all_four(v21), 0, 1, 6, 7));
    const dhgen_four packed1 = dhgen_angle_four(ratio1),
        angle3 = dhgen_shuffle(packed1, packed1, 0, 1, 0, 1), packed2 = dhgen_angle_four(ratio2),
        angle1 = dhgen_shuffle(packed2, packed2, 0, 1, 0, 1),
        angle2 = dhgen_shuffle(packed2, packed2, 2, 3, 2, 3);
    const dhgen_four q1 = v54 + angle1, q2 = v54 + angle2, q3 = v54 + angle3;

    dhgen_store_2(q, q + 3, q, q + 3, q1, q2);
    dhgen_store_1(q + 2, q + 5, q + 2, q + 5, q3);
    const unsigned long long none1 = (dhgen_bits_four(q1 != q1) * 0x81ull & 0x101ull);
    const unsigned long long kind1 = none1 * DHGEN_UNREACHABLE;
    __builtin_memcpy(status, &kind1, 2);
    return __builtin_popcountll(0x101ull & ~none1);
}
#endif
#include "dhgen/one_pose.h"
#endif

DHGEN_TABLE int entries[9] = { 0, 2, 3, 4, 6, 7, 8, 10, 11 };
DHGEN_TABLE int choosable[1] = { 0 };
DHGEN_TABLE struct dhgen_arm arm = {
    3, 2, 0, DHGEN_POSE, joints, NULL, 0,
    { 10.0, 10.0, 10.0, 1.0, 1.0, 1.0 }, 10.0, { 1e-14, 1e-14 }, entries, 9,
    0, /* slides */ 0, /* retries */ 0, /* checks */ 0, /* keeps limits */
    choosable, 1, NULL, 0, 52, 0, /* merges */ 0, /* refines */ 0, /* clamps */ 0, /* far */
    0, /* range exceeds a turn */ 1, /* follows seed */ NULL, NULL, NULL, NULL, wrist_oblique_fk,
    wrist_oblique_jacobian, solve,
    DHGEN_SOLVE_REGULAR,
};

#define DHGEN_NAME(function) wrist_oblique_##function
#include "dhgen/functions.h"

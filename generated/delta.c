/* delta: Delta, three cranks with parallelograms
 *
 * Inverse kinematics, generated from robots/delta.yaml and templates/c/parallel.c.jinja.
 * Do not edit: run dhgen robots/delta.yaml. The formulas and where they come from: delta.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: f33bcc1b99634bba
 * SPDX-License-Identifier: MIT
 */
#include "delta.h"

#include "delta_leg.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(DELTA_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(DELTA_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_LEGS 3
#define DHGEN_LEG_ROWS 4
#define DHGEN_LEG_JOINTS 3
#define DHGEN_LEG_DRIVES 1
#define DHGEN_DRIVES 3
#define DHGEN_ASSEMBLIES 2
#define DHGEN_ELIMINATION DHGEN_THREE_SPHERES
#include "dhgen/assemblies.h"
#include "dhgen/drives.h"

/* The driven joints alone at regular poses, as the legs' own solvers take them: values, NaN without
 * a solution, statuses, and whether a pose has to be left to those. */
DHGEN_ALWAYS
DHGEN_INLINE dhgen_wide_mask delta_leg_drives(
    const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind)
{
    DHGEN_TABLE struct dhgen_joint joints[3] = {
        { -1.0471975511965976, 1.5707963267948966, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
        { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
        { -1.0471975511965976, 1.0471975511965976, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
    };
    /* In formulas below, doubt_limit1 = 0.0001768 [m]. */
    static const double
        crank = 0.524, /* link length 1 [m] */
        rod = 1.244, /* link length 3 [m] */
        doubt_limit_squared4 = 9.770775678976e-08, /* square of a length that fixes no angle [m^4]
            */
        merge_slack2 = 3.125824e-14, /* nearer to that boundary two branches are one [m^2] */
        k1 = -1.2729599999999999, /* crank^2 - rod^2 [m^2] */
        k2 = 0.6461885216240527, /* 1 / (rod^2) [m^-2] */
        m1 = 3.1258239999999996e-11, /* 1000 * merge_slack2 [m^2] */
        m2 = 0.524, /* crank [m] */
        m3 = 3.125824e-08; /* doubt_limit1^2 [m^2] */
    static const double range_cosine3 = 0.49999999913397464, range_sine3 = 0.8660254042844386,
    near3 = 1e-06;
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide X1 = crank * T24 * 2.0, Y1 = 2.0 * (crank * T14), N1 = X1 * X1 + Y1 * Y1,
        Z1 = T14 * T14 + (T24 * T24 + (k1 + T34 * T34)), D1_squared = N1 - Z1 * Z1,
        w1 = dhgen_sqrt_wide(D1_squared), inverse1 = DHGEN_QUOTIENT(1.0, N1), v1 = X1 * Z1,
        v2 = Y1 * Z1, v3 = inverse1 * v2, v4 = w1 * (X1 * inverse1), c1_p = v3 - v4, c1_m = v3 + v4,
        v5 = inverse1 * v1, v6 = w1 * (Y1 * inverse1), s1_p = v5 + v6, s1_m = v5 - v6,
        angle1 = dhgen_atan2_wide(s1_p, c1_p), angle2 = dhgen_atan2_wide(s1_m, c1_m);

    /* theta2 */
    const dhgen_wide v7 = X1 * T14 - T24 * Y1, v8 = m2 - inverse1 * (T24 * v1 + T14 * v2),
        X2_p = v8 + w1 * (inverse1 * v7), X2_m = v8 + w1 * (inverse1 * -v7),
        Y2_p = T24 * c1_p - T14 * s1_p, Y2_m = T24 * c1_m - T14 * s1_m,
        v9 = X2_p * X2_p + Y2_p * Y2_p, v10 = X2_m * X2_m + Y2_m * Y2_m;

    /* theta3 */
    const dhgen_wide s3 = k2 * (rod * T34),
        c3_p = k2 * (rod * (T24 * (c1_p * Y2_p - s1_p * X2_p) - T14 * (c1_p * X2_p + s1_p * Y2_p) +
            crank * X2_p)),
        c3_m = k2 * (rod * (T24 * (c1_m * Y2_m - s1_m * X2_m) - T14 * (c1_m * X2_m + s1_m * Y2_m) +
            crank * X2_m));

    /* joint values */
    const dhgen_wide excess_p = dhgen_beyond_wide(angle1, joints),
        excess_m = dhgen_beyond_wide(angle2, joints);
    const dhgen_wide_mask v11 = 0.0 < excess_p, v12 = 0.0 < excess_m;
    const dhgen_wide v13 = dhgen_abs_wide(dhgen_sqrt_wide(v9) * s3),
        v14 = dhgen_abs_wide(dhgen_sqrt_wide(v10) * s3), v15 = range_cosine3 * v13,
        v16 = range_cosine3 * v14, v17 = range_sine3 * c3_p, v18 = v15 - v17, v19 = v15 + v17,
        v20 = range_sine3 * c3_m, v21 = v16 - v20, v22 = v16 + v20,
        v23 = near3 * (v13 + dhgen_abs_wide(c3_p)), v24 = near3 * (v14 + dhgen_abs_wide(c3_m));

    q[0] = angle1;
    kind[0] = dhgen_kind_within_wide(q[0], v11 | (0.0 < v18));
    q[1] = angle1;
    kind[1] = dhgen_kind_within_wide(q[1], v11 | (0.0 < v19));
    q[2] = angle2;
    kind[2] = dhgen_kind_within_wide(q[2], v12 | (0.0 < v21));
    q[3] = angle2;
    kind[3] = dhgen_kind_within_wide(q[3], v12 | (0.0 < v22));
    const dhgen_wide_mask exact = 0.0 * (T[3] + T[7] + T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D1_squared) <= m1 * (merge_slack2 + 2.0 *
        dhgen_abs_wide(Z1))) | (N1 <= doubt_limit_squared4) | (dhgen_abs_wide(v22) <= v24) |
        (dhgen_abs_wide(v21) <= v24) | (dhgen_abs_wide(v19) <= v23) | (dhgen_abs_wide(v18) <= v23) |
        (v9 <= m3) | (v10 <= m3)) | (dhgen_within_slack_wide(excess_p) |
        dhgen_within_slack_wide(excess_m));
}

DHGEN_ALWAYS
DHGEN_INLINE dhgen_wide_mask solve_driven(
    int chain, const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind)
{
    switch (chain) {
    case 0:
        return delta_leg_drives(T, q, kind);
    default: /* no program for regular poses */
        (void)T;
        return dhgen_all_with_care(q, kind);
    }
}

DHGEN_TABLE int delta_leg_driven[1] = { 0 };
DHGEN_TABLE int delta_leg_slides[1] = { 0 };
DHGEN_TABLE int delta_leg_counted[3] = { 0, 1, 2 };
#ifndef __CUDACC_RTC__
static const char *const delta_leg_names[4] = {
    "shoulder+-elbow+", "shoulder+-elbow-", "shoulder--elbow+", "shoulder--elbow-",
};
#endif

DHGEN_FN int delta_leg_rows(const double *T, const double *q_seed, double *q, unsigned char *status)
{
    return delta_leg_ik(T, q_seed, (double (*)[DELTA_LEG_DOF])q, status);
}

DHGEN_TABLE struct dhgen_leg legs[3] = {
    /* joints, rows, drives; which joints are driven, whether they slide, types, what the platform
     * moves; from the robot's base; in the platform; functions */
    {
        3, 4, 1, delta_leg_driven, delta_leg_slides, "RRR", delta_leg_counted,
        {
            1.0, 0.0, 0.0, -0.164, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, 0.044, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        delta_leg_rows, delta_leg_ik_nearest, delta_leg_ik_batch, delta_leg_fk, delta_leg_jacobian
    },
    {
        3, 4, 1, delta_leg_driven, delta_leg_slides, "RRR", delta_leg_counted,
        {
            -0.5, 0.8660254037844386, 0.0, -0.16399999999999998, 0.0, 0.0, -1.0, 0.0,
                -0.8660254037844386,
            -0.5, 0.0, 0.0,
        },
        {
            -0.5, -0.8660254037844386, 0.0, -0.022, 0.8660254037844386, -0.5, 0.0,
                0.038105117766515297,
            0.0, 0.0, 1.0, 0.0,
        },
        delta_leg_rows, delta_leg_ik_nearest, delta_leg_ik_batch, delta_leg_fk, delta_leg_jacobian
    },
    {
        3, 4, 1, delta_leg_driven, delta_leg_slides, "RRR", delta_leg_counted,
        {
            -0.5, -0.8660254037844386, 0.0, -0.16399999999999998, 0.0, 0.0, -1.0, 0.0,
                0.8660254037844386,
            -0.5, 0.0, 0.0,
        },
        {
            -0.5, 0.8660254037844386, 0.0, -0.022, -0.8660254037844386, -0.5, 0.0,
                -0.038105117766515297,
            0.0, 0.0, 1.0, 0.0,
        },
        delta_leg_rows, delta_leg_ik_nearest, delta_leg_ik_batch, delta_leg_fk, delta_leg_jacobian
    },
};
DHGEN_TABLE int freedoms[3] = { 0, 1, 2 };
DHGEN_TABLE struct dhgen_parallel robot = {
    3, 3, 4, 3,
    1, /* alike */
    freedoms, 1.768, DHGEN_COORDINATES, 0, /* planar */
    legs
};

/* The legs chain by chain, side by side. */
DHGEN_TABLE int first_leg[2] = { 0, 3 };
DHGEN_TABLE size_t legs_by_chain[DHGEN_LEG_COLUMNS] = { 0, 1, 2, 2, 2, 2, 2, 2, 2, 2 };
DHGEN_TABLE double bases[12][DHGEN_LEG_COLUMNS] = {
    {
        1.0, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5,
    },
    {
        0.0, 0.8660254037844386, -0.8660254037844386, -0.8660254037844386, -0.8660254037844386,
        -0.8660254037844386, -0.8660254037844386, -0.8660254037844386, -0.8660254037844386,
        -0.8660254037844386,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        -0.164, -0.16399999999999998, -0.16399999999999998, -0.16399999999999998,
        -0.16399999999999998, -0.16399999999999998, -0.16399999999999998, -0.16399999999999998,
        -0.16399999999999998, -0.16399999999999998,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        -1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, -0.8660254037844386, 0.8660254037844386, 0.8660254037844386, 0.8660254037844386,
        0.8660254037844386, 0.8660254037844386, 0.8660254037844386, 0.8660254037844386,
        0.8660254037844386,
    },
    {
        1.0, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
};
DHGEN_TABLE double carried[12][DHGEN_LEG_COLUMNS] = {
    {
        1.0, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5,
    },
    {
        0.0, -0.8660254037844386, 0.8660254037844386, 0.8660254037844386, 0.8660254037844386,
        0.8660254037844386, 0.8660254037844386, 0.8660254037844386, 0.8660254037844386,
        0.8660254037844386,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.044, -0.022, -0.022, -0.022, -0.022, -0.022, -0.022, -0.022, -0.022, -0.022,
    },
    {
        0.0, 0.8660254037844386, -0.8660254037844386, -0.8660254037844386, -0.8660254037844386,
        -0.8660254037844386, -0.8660254037844386, -0.8660254037844386, -0.8660254037844386,
        -0.8660254037844386,
    },
    {
        1.0, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.038105117766515297, -0.038105117766515297, -0.038105117766515297,
        -0.038105117766515297, -0.038105117766515297, -0.038105117766515297, -0.038105117766515297,
        -0.038105117766515297, -0.038105117766515297,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
};
DHGEN_TABLE struct dhgen_leg_lanes lanes = {
    1, first_leg, legs_by_chain, bases, carried
};

#ifndef __CUDACC_RTC__
const char *const *const delta_branches[3] = {
    delta_leg_names,
    delta_leg_names,
    delta_leg_names,
};
#endif

#ifndef __CUDA_ARCH__
const int delta_drives[3][2] = { { 0, 0 }, { 1, 0 }, { 2, 0 } };
#endif

#define DHGEN_NAME(function) delta_##function
#include "dhgen/functions_parallel.h"

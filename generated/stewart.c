/* stewart: Stewart platform, six cylinders (6-UPS)
 *
 * Inverse kinematics, generated from robots/stewart.yaml and templates/c/parallel.c.jinja.
 * Do not edit: run dhgen robots/stewart.yaml. The formulas and where they come from: stewart.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 7e0d95027cd10e15
 * SPDX-License-Identifier: MIT
 */
#include "stewart.h"

#include "stewart_leg.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(STEWART_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(STEWART_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_LEGS 6
#define DHGEN_LEG_ROWS 4
#define DHGEN_LEG_JOINTS 3
#define DHGEN_LEG_DRIVES 1
#define DHGEN_DRIVES 6
#include "dhgen/direct.h"
#include "dhgen/drives.h"

/* The driven joints alone at regular poses, as the legs' own solvers take them: values, NaN without
 * a solution, statuses, and whether a pose has to be left to those. */
DHGEN_ALWAYS
DHGEN_INLINE dhgen_wide_mask stewart_leg_drives(
    const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind)
{
    DHGEN_TABLE struct dhgen_joint joints[3] = {
        { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
        { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
        { 0.35, 0.75, 7.5e-10, 1.7777777777777777, 0.75, 0.0125, 0 },
    };
    /* In formulas below, doubt_limit1 = 7.500000000000001e-05 [m]. */
    static const double
        per_size = 1.3333333333333333, /* slides beyond limits count in the arm's size [m^-1] */
        m1 = 5.625000000000001e-09; /* doubt_limit1^2 [m^2] */
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1 */
    const dhgen_wide v1 = T14 * T14 + T24 * T24;

    /* theta2, r3 */
    const dhgen_wide v2 = v1 + T34 * T34, q1_pp = dhgen_sqrt_wide(v2);

    /* joint values */
    const dhgen_wide excess_p = per_size * dhgen_beyond_wide(q1_pp, joints + 2),
        excess_m = per_size * dhgen_maximum_wide(dhgen_low(joints + 2) + q1_pp, -(dhgen_high(joints
            + 2) + q1_pp));
    const dhgen_wide_mask outside_pp = 0.0 < excess_p, outside_pm = 0.0 < excess_m;

    q[0] = q1_pp;
    kind[0] = dhgen_kind_within_wide(q[0], outside_pp);
    q[1] = -q1_pp;
    kind[1] = dhgen_kind_within_wide(q[1], outside_pm);
    q[2] = q1_pp;
    kind[2] = dhgen_kind_within_wide(q[2], outside_pp);
    q[3] = -q1_pp;
    kind[3] = dhgen_kind_within_wide(q[3], outside_pm);
    const dhgen_wide_mask exact = 0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7] + T[11] * T[11] *
        T[11]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((v1 <= m1) | (v2 <= m1)) | (dhgen_within_slack_wide(excess_p) |
        dhgen_within_slack_wide(excess_m));
}

DHGEN_ALWAYS
DHGEN_INLINE dhgen_wide_mask solve_driven(
    int chain, const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind)
{
    switch (chain) {
    case 0:
        return stewart_leg_drives(T, q, kind);
    default: /* no program for regular poses */
        (void)T;
        return dhgen_all_with_care(q, kind);
    }
}

DHGEN_TABLE int stewart_leg_driven[1] = { 2 };
DHGEN_TABLE int stewart_leg_slides[1] = { 1 };
DHGEN_TABLE int stewart_leg_counted[3] = { 0, 1, 2 };
#ifndef __CUDACC_RTC__
static const char *const stewart_leg_names[4] = {
    "back-forward", "back-backward", "front-forward", "front-backward",
};
#endif

DHGEN_FN int stewart_leg_rows(const double *T, const double *q_seed, double *q, unsigned char
    *status)
{
    return stewart_leg_ik(T, q_seed, (double (*)[STEWART_LEG_DOF])q, status);
}

DHGEN_TABLE struct dhgen_leg legs[6] = {
    /* joints, rows, drives; which joints are driven, whether they slide, types, what the platform
     * moves; from the robot's base; in the platform; functions */
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            1.0, 0.0, 0.0, -0.492403876506104, 0.0, 1.0, 0.0, 0.08682408883346517, 0.0, 0.0, 1.0,
                0.0,
        },
        {
            1.0, 0.0, 0.0, 0.1928362829059618, 0.0, 1.0, 0.0, -0.2298133329356934, 0.0, 0.0, 1.0,
                0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            -0.5, 0.8660254037844386, 0.0, -0.49240387650610395, -0.8660254037844386, -0.5, 0.0,
            0.08682408883346515, 0.0, 0.0, 1.0, 0.0,
        },
        {
            -0.5, -0.8660254037844386, 0.0, 0.10260604299770058, 0.8660254037844386, -0.5, 0.0,
            0.2819077862357725, 0.0, 0.0, 1.0, 0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            -0.5, -0.8660254037844386, 0.0, -0.492403876506104, 0.8660254037844386, -0.5, 0.0,
            0.08682408883346512, 0.0, 0.0, 1.0, 0.0,
        },
        {
            -0.5, 0.8660254037844386, 0.0, -0.2954423259036624, -0.8660254037844386, -0.5, 0.0,
            -0.05209445330007911, 0.0, 0.0, 1.0, 0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            1.0, 0.0, 0.0, -0.492403876506104, 0.0, 1.0, 0.0, -0.08682408883346517, 0.0, 0.0, 1.0,
                0.0,
        },
        {
            1.0, 0.0, 0.0, 0.1928362829059618, 0.0, 1.0, 0.0, 0.2298133329356934, 0.0, 0.0, 1.0,
                0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            -0.5, 0.8660254037844386, 0.0, -0.492403876506104, -0.8660254037844386, -0.5, 0.0,
            -0.08682408883346512, 0.0, 0.0, 1.0, 0.0,
        },
        {
            -0.5, -0.8660254037844386, 0.0, -0.2954423259036624, 0.8660254037844386, -0.5, 0.0,
            0.05209445330007911, 0.0, 0.0, 1.0, 0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
    {
        3, 4, 1, stewart_leg_driven, stewart_leg_slides, "RRP", stewart_leg_counted,
        {
            -0.5, -0.8660254037844386, 0.0, -0.49240387650610395, 0.8660254037844386, -0.5, 0.0,
            -0.08682408883346515, 0.0, 0.0, 1.0, 0.0,
        },
        {
            -0.5, 0.8660254037844386, 0.0, 0.10260604299770058, -0.8660254037844386, -0.5, 0.0,
            -0.2819077862357725, 0.0, 0.0, 1.0, 0.0,
        },
        stewart_leg_rows, stewart_leg_ik_nearest, stewart_leg_ik_batch, stewart_leg_fk,
            stewart_leg_jacobian
    },
};
DHGEN_TABLE int freedoms[6] = { 0, 1, 2, 3, 4, 5 };
DHGEN_TABLE struct dhgen_parallel robot = {
    6, 3, 4, 6,
    1, /* alike */
    freedoms, 0.9397, DHGEN_POSE, 0, /* planar */
    legs
};

/* The legs chain by chain, side by side. */
DHGEN_TABLE int first_leg[2] = { 0, 6 };
DHGEN_TABLE size_t legs_by_chain[DHGEN_LEG_COLUMNS] = { 0, 1, 2, 3, 4, 5, 5, 5, 5, 5, 5, 5, 5 };
DHGEN_TABLE double bases[12][DHGEN_LEG_COLUMNS] = {
    {
        1.0, -0.5, -0.5, 1.0, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5,
    },
    {
        0.0, 0.8660254037844386, -0.8660254037844386, 0.0, 0.8660254037844386, -0.8660254037844386,
        -0.8660254037844386, -0.8660254037844386, -0.8660254037844386, -0.8660254037844386,
        -0.8660254037844386, -0.8660254037844386, -0.8660254037844386,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        -0.492403876506104, -0.49240387650610395, -0.492403876506104, -0.492403876506104,
        -0.492403876506104, -0.49240387650610395, -0.49240387650610395, -0.49240387650610395,
        -0.49240387650610395, -0.49240387650610395, -0.49240387650610395, -0.49240387650610395,
        -0.49240387650610395,
    },
    {
        0.0, -0.8660254037844386, 0.8660254037844386, 0.0, -0.8660254037844386, 0.8660254037844386,
        0.8660254037844386, 0.8660254037844386, 0.8660254037844386, 0.8660254037844386,
        0.8660254037844386, 0.8660254037844386, 0.8660254037844386,
    },
    {
        1.0, -0.5, -0.5, 1.0, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.08682408883346517, 0.08682408883346515, 0.08682408883346512, -0.08682408883346517,
        -0.08682408883346512, -0.08682408883346515, -0.08682408883346515, -0.08682408883346515,
        -0.08682408883346515, -0.08682408883346515, -0.08682408883346515, -0.08682408883346515,
        -0.08682408883346515,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
};
DHGEN_TABLE double carried[12][DHGEN_LEG_COLUMNS] = {
    {
        1.0, -0.5, -0.5, 1.0, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5,
    },
    {
        0.0, -0.8660254037844386, 0.8660254037844386, 0.0, -0.8660254037844386, 0.8660254037844386,
        0.8660254037844386, 0.8660254037844386, 0.8660254037844386, 0.8660254037844386,
        0.8660254037844386, 0.8660254037844386, 0.8660254037844386,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.1928362829059618, 0.10260604299770058, -0.2954423259036624, 0.1928362829059618,
        -0.2954423259036624, 0.10260604299770058, 0.10260604299770058, 0.10260604299770058,
        0.10260604299770058, 0.10260604299770058, 0.10260604299770058, 0.10260604299770058,
        0.10260604299770058,
    },
    {
        0.0, 0.8660254037844386, -0.8660254037844386, 0.0, 0.8660254037844386, -0.8660254037844386,
        -0.8660254037844386, -0.8660254037844386, -0.8660254037844386, -0.8660254037844386,
        -0.8660254037844386, -0.8660254037844386, -0.8660254037844386,
    },
    {
        1.0, -0.5, -0.5, 1.0, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        -0.2298133329356934, 0.2819077862357725, -0.05209445330007911, 0.2298133329356934,
        0.05209445330007911, -0.2819077862357725, -0.2819077862357725, -0.2819077862357725,
        -0.2819077862357725, -0.2819077862357725, -0.2819077862357725, -0.2819077862357725,
        -0.2819077862357725,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
};
DHGEN_TABLE struct dhgen_leg_lanes lanes = {
    1, first_leg, legs_by_chain, bases, carried
};

#ifndef __CUDACC_RTC__
const char *const *const stewart_branches[6] = {
    stewart_leg_names,
    stewart_leg_names,
    stewart_leg_names,
    stewart_leg_names,
    stewart_leg_names,
    stewart_leg_names,
};
#endif

#ifndef __CUDA_ARCH__
const int stewart_drives[6][2] = { { 0, 2 }, { 1, 2 }, { 2, 2 }, { 3, 2 }, { 4, 2 }, { 5, 2 } };
#endif

#define DHGEN_NAME(function) stewart_##function
#include "dhgen/functions_parallel.h"

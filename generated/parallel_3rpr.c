/* parallel_3rpr: Planar platform on three cylinders (3-RPR)
 *
 * Inverse kinematics, generated from robots/parallel_3rpr.yaml and templates/c/parallel.c.jinja.
 * Do not edit: run dhgen robots/parallel_3rpr.yaml. The formulas and where they come from:
 * parallel_3rpr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 07c20b2bc6956a7a
 * SPDX-License-Identifier: MIT
 */
#include "parallel_3rpr.h"

#include "parallel_3rpr_leg.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(PARALLEL_3RPR_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(PARALLEL_3RPR_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_LEGS 3
#define DHGEN_LEG_ROWS 2
#define DHGEN_LEG_JOINTS 2
#define DHGEN_LEG_DRIVES 1
#define DHGEN_DRIVES 3
#define DHGEN_ASSEMBLIES 6
#define DHGEN_ELIMINATION DHGEN_THREE_CIRCLES
#include "dhgen/assemblies.h"
#include "dhgen/drives.h"

/* The driven joints alone at regular poses, as the legs' own solvers take them: values, NaN without
 * a solution, statuses, and whether a pose has to be left to those. */
DHGEN_ALWAYS
DHGEN_INLINE dhgen_wide_mask parallel_3rpr_leg_drives(
    const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind)
{
    DHGEN_TABLE struct dhgen_joint joints[2] = {
        { -HUGE_VAL, HUGE_VAL, 1e-09, 1.0, 1.0, 0.09817477042468103, 1 },
        { 0.3, 1.6, 1.6e-09, 0.39062499999999994, 1.6, 0.040625, 0 },
    };
    /* In formulas below, doubt_limit1 = 0.00016 [m]. */
    static const double
        per_size = 0.625, /* slides beyond limits count in the arm's size [m^-1] */
        m1 = 2.5600000000000004e-08; /* doubt_limit1^2 [m^2] */
    DHGEN_ENTRIES(dhgen_wide);

    /* theta1, r2 */
    const dhgen_wide v1 = T14 * T14 + T24 * T24, q1_p = dhgen_sqrt_wide(v1);

    /* joint values */
    const dhgen_wide excess_p = per_size * dhgen_beyond_wide(q1_p, joints + 1),
        excess_m = per_size * dhgen_maximum_wide(dhgen_low(joints + 1) + q1_p, -(dhgen_high(joints +
            1) + q1_p));

    q[0] = q1_p;
    kind[0] = dhgen_kind_within_wide(q[0], 0.0 < excess_p);
    q[1] = -q1_p;
    kind[1] = dhgen_kind_within_wide(q[1], 0.0 < excess_m);
    const dhgen_wide_mask exact = 0.0 * (T[3] * T[3] * T[3] + T[7] * T[7] * T[7]) <=
        DHGEN_ORTHONORMAL;
    return (exact == 0) | (v1 <= m1) | (dhgen_within_slack_wide(excess_p) |
        dhgen_within_slack_wide(excess_m));
}

DHGEN_ALWAYS
DHGEN_INLINE dhgen_wide_mask solve_driven(
    int chain, const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind)
{
    switch (chain) {
    case 0:
        return parallel_3rpr_leg_drives(T, q, kind);
    default: /* no program for regular poses */
        (void)T;
        return dhgen_all_with_care(q, kind);
    }
}

DHGEN_TABLE int parallel_3rpr_leg_driven[1] = { 1 };
DHGEN_TABLE int parallel_3rpr_leg_slides[1] = { 1 };
DHGEN_TABLE int parallel_3rpr_leg_counted[2] = { 0, 1 };
#ifndef __CUDACC_RTC__
static const char *const parallel_3rpr_leg_names[2] = { "forward", "backward" };
#endif

DHGEN_FN int parallel_3rpr_leg_rows(const double *T, const double *q_seed, double *q, unsigned char
    *status)
{
    return parallel_3rpr_leg_ik(T, q_seed, (double (*)[PARALLEL_3RPR_LEG_DOF])q, status);
}

DHGEN_TABLE struct dhgen_leg legs[3] = {
    /* joints, rows, drives; which joints are driven, whether they slide, types, what the platform
     * moves; from the robot's base; in the platform; functions */
    {
        2, 2, 1, parallel_3rpr_leg_driven, parallel_3rpr_leg_slides, "RP",
            parallel_3rpr_leg_counted,
        {
            1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, -0.2, 0.0, 1.0, 0.0, -0.1, 0.0, 0.0, 1.0, 0.0,
        },
        parallel_3rpr_leg_rows, parallel_3rpr_leg_ik_nearest, parallel_3rpr_leg_ik_batch,
            parallel_3rpr_leg_fk, parallel_3rpr_leg_jacobian
    },
    {
        2, 2, 1, parallel_3rpr_leg_driven, parallel_3rpr_leg_slides, "RP",
            parallel_3rpr_leg_counted,
        {
            1.0, 0.0, 0.0, -1.2, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, 0.25, 0.0, 1.0, 0.0, -0.1, 0.0, 0.0, 1.0, 0.0,
        },
        parallel_3rpr_leg_rows, parallel_3rpr_leg_ik_nearest, parallel_3rpr_leg_ik_batch,
            parallel_3rpr_leg_fk, parallel_3rpr_leg_jacobian
    },
    {
        2, 2, 1, parallel_3rpr_leg_driven, parallel_3rpr_leg_slides, "RP",
            parallel_3rpr_leg_counted,
        {
            1.0, 0.0, 0.0, -0.5, 0.0, 1.0, 0.0, -1.1, 0.0, 0.0, 1.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.25, 0.0, 0.0, 1.0, 0.0,
        },
        parallel_3rpr_leg_rows, parallel_3rpr_leg_ik_nearest, parallel_3rpr_leg_ik_batch,
            parallel_3rpr_leg_fk, parallel_3rpr_leg_jacobian
    },
};
DHGEN_TABLE int freedoms[3] = { 0, 1, 5 };
DHGEN_TABLE struct dhgen_parallel robot = {
    3, 2, 2, 3,
    1, /* alike */
    freedoms, 1.6, DHGEN_YAW, 1, /* planar */
    legs
};

/* The legs chain by chain, side by side. */
DHGEN_TABLE int first_leg[2] = { 0, 3 };
DHGEN_TABLE size_t legs_by_chain[DHGEN_LEG_COLUMNS] = { 0, 1, 2, 2, 2, 2, 2, 2, 2, 2 };
DHGEN_TABLE double bases[12][DHGEN_LEG_COLUMNS] = {
    {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, -1.2, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5, -0.5,
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
    {
        0.0, 0.0, -1.1, -1.1, -1.1, -1.1, -1.1, -1.1, -1.1, -1.1,
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
DHGEN_TABLE double carried[12][DHGEN_LEG_COLUMNS] = {
    {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        -0.2, 0.25, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
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
    {
        -0.1, -0.1, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25,
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
const char *const *const parallel_3rpr_branches[3] = {
    parallel_3rpr_leg_names,
    parallel_3rpr_leg_names,
    parallel_3rpr_leg_names,
};
#endif

#ifndef __CUDA_ARCH__
const int parallel_3rpr_drives[3][2] = { { 0, 1 }, { 1, 1 }, { 2, 1 } };
#endif

#define DHGEN_NAME(function) parallel_3rpr_##function
#include "dhgen/functions_parallel.h"

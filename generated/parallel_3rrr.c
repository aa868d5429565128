/* parallel_3rrr: Planar platform on three cranks (3-RRR)
 *
 * Inverse kinematics, generated from robots/parallel_3rrr.yaml and templates/c/parallel.c.jinja.
 * Do not edit: run dhgen robots/parallel_3rrr.yaml. The formulas and where they come from:
 * parallel_3rrr.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 5e91c3514772707d
 * SPDX-License-Identifier: MIT
 */
#include "parallel_3rrr.h"

#include "parallel_3rrr_leg.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(PARALLEL_3RRR_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(PARALLEL_3RRR_LIBM) && !defined(DHGEN_LIBM)
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
DHGEN_INLINE dhgen_wide_mask parallel_3rrr_leg_drives(
    const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind)
{
    /* In formulas below, longest2_apart = 0.48999999999999017 [m^2],
     * k2 = 1 / (2 * rod * crank) = 4.081632653061225 [m^-2], crank = 0.35 [m], rod = 0.35 [m]. */
    static const double
        longest2 = 0.48999999999999994, /* square of the longest reach [m^2] */
        shortest2 = 0.0, /* square of the shortest reach [m^2] */
        doubt_limit_squared2 = 4.899999999999999e-09, /* square of a length that fixes no angle
            [m^2] */
        /* 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4] */
        m1 = 4.787281682183579e-12,
        m2 = 1.4285714285714286; /* rod * k2 [m^-1] */
    DHGEN_ENTRIES(dhgen_wide);

    /* theta2 */
    const dhgen_wide N2 = T14 * T14 + T24 * T24, D2_squared = (longest2 - N2) * (N2 - shortest2),
        w2 = dhgen_sqrt_wide(D2_squared);

    /* theta1 */
    const dhgen_wide v1 = m2 * (T24 * N2), v2 = m2 * (T14 * N2), v3 = w2 * (m2 * T14),
        v4 = w2 * (m2 * T24);

    q[0] = dhgen_atan2_wide(v1 - v3, v2 + v4);
    kind[0] = dhgen_kind_wide(q[0]);
    q[1] = dhgen_atan2_wide(v1 + v3, v2 - v4);
    kind[1] = dhgen_kind_wide(q[1]);
    const dhgen_wide_mask exact = 0.0 * (T[3] + T[7]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | ((dhgen_abs_wide(D2_squared) <= m1) | (N2 <= doubt_limit_squared2));
}

DHGEN_ALWAYS
DHGEN_INLINE dhgen_wide_mask solve_driven(
    int chain, const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind)
{
    switch (chain) {
    case 0:
        return parallel_3rrr_leg_drives(T, q, kind);
    default: /* no program for regular poses */
        (void)T;
        return dhgen_all_with_care(q, kind);
    }
}

DHGEN_TABLE int parallel_3rrr_leg_driven[1] = { 0 };
DHGEN_TABLE int parallel_3rrr_leg_slides[1] = { 0 };
DHGEN_TABLE int parallel_3rrr_leg_counted[2] = { 0, 1 };
#ifndef __CUDACC_RTC__
static const char *const parallel_3rrr_leg_names[2] = { "right", "left" };
#endif

DHGEN_FN int parallel_3rrr_leg_rows(const double *T, const double *q_seed, double *q, unsigned char
    *status)
{
    return parallel_3rrr_leg_ik(T, q_seed, (double (*)[PARALLEL_3RRR_LEG_DOF])q, status);
}

DHGEN_TABLE struct dhgen_leg legs[3] = {
    /* joints, rows, drives; which joints are driven, whether they slide, types, what the platform
     * moves; from the robot's base; in the platform; functions */
    {
        2, 2, 1, parallel_3rrr_leg_driven, parallel_3rrr_leg_slides, "RR",
            parallel_3rrr_leg_counted,
        {
            1.0, 0.0, 0.0, -0.5, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, 0.15, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        parallel_3rrr_leg_rows, parallel_3rrr_leg_ik_nearest, parallel_3rrr_leg_ik_batch,
            parallel_3rrr_leg_fk, parallel_3rrr_leg_jacobian
    },
    {
        2, 2, 1, parallel_3rrr_leg_driven, parallel_3rrr_leg_slides, "RR",
            parallel_3rrr_leg_counted,
        {
            -0.5, 0.8660254037844386, 0.0, -0.49999999999999994, -0.8660254037844386, -0.5, 0.0,
                0.0, 0.0,
            0.0, 1.0, 0.0,
        },
        {
            -0.5, -0.8660254037844386, 0.0, -0.075, 0.8660254037844386, -0.5, 0.0,
                0.12990381056766578, 0.0,
            0.0, 1.0, 0.0,
        },
        parallel_3rrr_leg_rows, parallel_3rrr_leg_ik_nearest, parallel_3rrr_leg_ik_batch,
            parallel_3rrr_leg_fk, parallel_3rrr_leg_jacobian
    },
    {
        2, 2, 1, parallel_3rrr_leg_driven, parallel_3rrr_leg_slides, "RR",
            parallel_3rrr_leg_counted,
        {
            -0.5, -0.8660254037844386, 0.0, -0.49999999999999994, 0.8660254037844386, -0.5, 0.0,
                0.0, 0.0,
            0.0, 1.0, 0.0,
        },
        {
            -0.5, 0.8660254037844386, 0.0, -0.075, -0.8660254037844386, -0.5, 0.0,
                -0.12990381056766578,
            0.0, 0.0, 1.0, 0.0,
        },
        parallel_3rrr_leg_rows, parallel_3rrr_leg_ik_nearest, parallel_3rrr_leg_ik_batch,
            parallel_3rrr_leg_fk, parallel_3rrr_leg_jacobian
    },
};
DHGEN_TABLE int freedoms[3] = { 0, 1, 5 };
DHGEN_TABLE struct dhgen_parallel robot = {
    3, 2, 2, 3,
    1, /* alike */
    freedoms, 0.866, DHGEN_YAW, 1, /* planar */
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
        -0.5, -0.49999999999999994, -0.49999999999999994, -0.49999999999999994,
        -0.49999999999999994, -0.49999999999999994, -0.49999999999999994, -0.49999999999999994,
        -0.49999999999999994, -0.49999999999999994,
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
        0.15, -0.075, -0.075, -0.075, -0.075, -0.075, -0.075, -0.075, -0.075, -0.075,
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
        0.0, 0.12990381056766578, -0.12990381056766578, -0.12990381056766578, -0.12990381056766578,
        -0.12990381056766578, -0.12990381056766578, -0.12990381056766578, -0.12990381056766578,
        -0.12990381056766578,
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
const char *const *const parallel_3rrr_branches[3] = {
    parallel_3rrr_leg_names,
    parallel_3rrr_leg_names,
    parallel_3rrr_leg_names,
};
#endif

#ifndef __CUDA_ARCH__
const int parallel_3rrr_drives[3][2] = { { 0, 0 }, { 1, 0 }, { 2, 0 } };
#endif

#define DHGEN_NAME(function) parallel_3rrr_##function
#include "dhgen/functions_parallel.h"

/* five_bar: Planar five-bar linkage (RR legs)
 *
 * Inverse kinematics, generated from robots/five_bar.yaml and templates/c/parallel.c.jinja.
 * Do not edit: run dhgen robots/five_bar.yaml. The formulas and where they come from: five_bar.md.
 *
 * dhgen 0.2.0.dev0; SHA-256 of the robot file: 5e95f08d2a024264
 * SPDX-License-Identifier: MIT
 */
#include "five_bar.h"

#include "five_bar_leg.h"

#define DHGEN_EXPECTS 1 /* the interface of dhgen/ */
#if defined(FIVE_BAR_SCALAR) && !defined(DHGEN_SCALAR)
#define DHGEN_SCALAR
#endif
#if defined(FIVE_BAR_LIBM) && !defined(DHGEN_LIBM)
#define DHGEN_LIBM
#endif
#define DHGEN_LEGS 2
#define DHGEN_LEG_ROWS 2
#define DHGEN_LEG_JOINTS 2
#define DHGEN_LEG_DRIVES 1
#define DHGEN_DRIVES 2
#define DHGEN_ASSEMBLIES 2
#define DHGEN_ELIMINATION DHGEN_TWO_CIRCLES
#include "dhgen/assemblies.h"
#include "dhgen/drives.h"

/* The driven joints alone at regular poses, as the legs' own solvers take them: values, NaN without
 * a solution, statuses, and whether a pose has to be left to those. */
DHGEN_ALWAYS
DHGEN_INLINE dhgen_wide_mask five_bar_leg_drives(
    const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind)
{
    /* In formulas below, longest2_apart = 0.249999999999995 [m^2],
     * k2 = 1 / (2 * rod * crank) = 8.333333333333334 [m^-2], crank = 0.2 [m], rod = 0.3 [m],
     * k1 = crank^2 + rod^2 = 0.13 [m^2]. */
    static const double
        longest2 = 0.25, /* square of the longest reach [m^2] */
        shortest2 = 0.009999999999999995, /* square of the shortest reach [m^2] */
        /* 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4] */
        m1 = 1.1990408665951442e-12,
        m2 = 2.5, /* rod * k2 [m^-1] */
        m3 = 0.125; /* rod * k1 * k2 - crank [m] */
    DHGEN_ENTRIES(dhgen_wide);

    /* theta2 */
    const dhgen_wide N2 = T14 * T14 + T24 * T24, D2_squared = (longest2 - N2) * (N2 - shortest2),
        w2 = dhgen_sqrt_wide(D2_squared);

    /* theta1 */
    const dhgen_wide v1 = m2 * N2 - m3, v2 = T24 * v1, v3 = T14 * v1, v4 = w2 * (m2 * T14),
        v5 = w2 * (m2 * T24);

    q[0] = dhgen_atan2_wide(v2 - v4, v3 + v5);
    kind[0] = dhgen_kind_wide(q[0]);
    q[1] = dhgen_atan2_wide(v2 + v4, v3 - v5);
    kind[1] = dhgen_kind_wide(q[1]);
    const dhgen_wide_mask exact = 0.0 * (T[3] + T[7]) <= DHGEN_ORTHONORMAL;
    return (exact == 0) | (dhgen_abs_wide(D2_squared) <= m1);
}

DHGEN_ALWAYS
DHGEN_INLINE dhgen_wide_mask solve_driven(
    int chain, const dhgen_wide *T, dhgen_wide *q, dhgen_wide_mask *kind)
{
    switch (chain) {
    case 0:
        return five_bar_leg_drives(T, q, kind);
    default: /* no program for regular poses */
        (void)T;
        return dhgen_all_with_care(q, kind);
    }
}

DHGEN_TABLE int five_bar_leg_driven[1] = { 0 };
DHGEN_TABLE int five_bar_leg_slides[1] = { 0 };
DHGEN_TABLE int five_bar_leg_counted[2] = { 0, 1 };
#ifndef __CUDACC_RTC__
static const char *const five_bar_leg_names[2] = { "right", "left" };
#endif

DHGEN_FN int five_bar_leg_rows(const double *T, const double *q_seed, double *q, unsigned char
    *status)
{
    return five_bar_leg_ik(T, q_seed, (double (*)[FIVE_BAR_LEG_DOF])q, status);
}

DHGEN_TABLE struct dhgen_leg legs[2] = {
    /* joints, rows, drives; which joints are driven, whether they slide, types, what the platform
     * moves; from the robot's base; in the platform; functions */
    {
        2, 2, 1, five_bar_leg_driven, five_bar_leg_slides, "RR", five_bar_leg_counted,
        {
            1.0, 0.0, 0.0, 0.1, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        five_bar_leg_rows, five_bar_leg_ik_nearest, five_bar_leg_ik_batch, five_bar_leg_fk,
            five_bar_leg_jacobian
    },
    {
        2, 2, 1, five_bar_leg_driven, five_bar_leg_slides, "RR", five_bar_leg_counted,
        {
            1.0, 0.0, 0.0, -0.1, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        {
            1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        },
        five_bar_leg_rows, five_bar_leg_ik_nearest, five_bar_leg_ik_batch, five_bar_leg_fk,
            five_bar_leg_jacobian
    },
};
DHGEN_TABLE int freedoms[2] = { 0, 1 };
DHGEN_TABLE struct dhgen_parallel robot = {
    2, 2, 2, 2,
    1, /* alike */
    freedoms, 0.5, DHGEN_COORDINATES, 1, /* planar */
    legs
};

/* The legs chain by chain, side by side. */
DHGEN_TABLE int first_leg[2] = { 0, 2 };
DHGEN_TABLE size_t legs_by_chain[DHGEN_LEG_COLUMNS] = { 0, 1, 1, 1, 1, 1, 1, 1, 1 };
DHGEN_TABLE double bases[12][DHGEN_LEG_COLUMNS] = {
    {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.1, -0.1, -0.1, -0.1, -0.1, -0.1, -0.1, -0.1, -0.1,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
};
DHGEN_TABLE double carried[12][DHGEN_LEG_COLUMNS] = {
    {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
    {
        1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    },
    {
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    },
};
DHGEN_TABLE struct dhgen_leg_lanes lanes = {
    1, first_leg, legs_by_chain, bases, carried
};

#ifndef __CUDACC_RTC__
const char *const *const five_bar_branches[2] = {
    five_bar_leg_names,
    five_bar_leg_names,
};
#endif

#ifndef __CUDA_ARCH__
const int five_bar_drives[2][2] = { { 0, 0 }, { 1, 0 } };
#endif

#define DHGEN_NAME(function) five_bar_##function
#include "dhgen/functions_parallel.h"

/* SPDX-License-Identifier: MIT
 *
 * What follows where roots of polynomials nearly meet, and where rows miss the pose. */
#ifndef DHGEN_COMPLETE_H
#define DHGEN_COMPLETE_H

#include "arm.h"
#include "numerical/arm.h"

#if defined(__cplusplus) && defined(DHGEN_SHARED)
extern "C" {
#endif

/* Completes the rows of a pose: splits close roots, adds rows for other values of joints, refines
 * rows and, if `begun` is not negative, searches for lost ones, for row `begun`. Where a pose that
 * may be rounded has none, those of poses beside it are looked at. */
DHGEN_API void dhgen_complete_rows(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, int begun, double *q, unsigned char *status);

#if defined(__cplusplus) && defined(DHGEN_SHARED)
}
#endif

#ifndef DHGEN_SHARED

#include "numerical/other_values.h"
#include "numerical/refine_rows.h"
#include "numerical/rows_beside.h"
#include "numerical/search_lost_rows.h"
#include "numerical/split_close_roots.h"

DHGEN_API void dhgen_complete_rows(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, int begun, double *q, unsigned char *status)
{
    if (arm->completion->turn_count > 0)
        dhgen_split_close_roots(arm, T, free_joints, seed, q, status);
    if (arm->completion->adds_others)
        dhgen_add_others(arm, T, free_joints, q, status);
    const int fitted = dhgen_refine_rows(arm, T, free_joints, seed, q, status);
    int none = arm->completion->descents->checked;
    for (int row = 0; row < dhgen_rows(arm); row++)
        none = none && status[row] == DHGEN_UNREACHABLE;
    if (begun < 0 && arm->completion->equations_end_all)
        begun = 0;
    if (begun >= 0)
        dhgen_search_lost_rows(arm, T, free_joints, seed, begun, fitted, q, status);
    if (none)
        dhgen_add_rows_beside(arm, T, free_joints, seed, q, status);
}

#endif

#endif

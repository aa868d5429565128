/* SPDX-License-Identifier: MIT
 *
 * How a solution joins the ones found before, inside limits if it can. */
#ifndef DHGEN_NUMERICAL_KEEP_H
#define DHGEN_NUMERICAL_KEEP_H

#include "../tolerances.h"
#include "family.h"

/* Where a solution beyond a limit is one of two that nearly meet the other lies across a singular
 * place, and steps from the limit may go back to it: how far to go on, as parts of the way
 * there. */
DHGEN_TABLE double dhgen_farther_on[5] = { 0.0, 1.0, 3.0, 7.0, 15.0 };

/* Takes joint values on a way from u to a solution that keeps all limits and is as exact as a row
 * has to be, farther on if steps return to the first one; returns whether there are any. */
DHGEN_FN int dhgen_reach_inside(struct dhgen_descent *d, const double *u, double *end)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double way[DHGEN_JOINTS], start[DHGEN_JOINTS], inside[DHGEN_JOINTS];
    dhgen_copy_units(arm, end, start);
    for (int j = 0; j < arm->solved; j++)
        way[j] = start[j] - u[j];
    dhgen_wrap_units(arm, way);
    for (int k = 0; k < 5; k++) {
        for (int j = 0; j < arm->solved; j++)
            end[j] = start[j] + dhgen_farther_on[k] * way[j];
        if (dhgen_descend(d, end) <= DHGEN_PROMISED
            && dhgen_clamp_units(d, end, inside) <= DHGEN_LIMIT)
            return 1;
    }
    return 0;
}

/* Replaces a solution that is beyond a limit by one that keeps all of them, if one is found on the
 * way to the seed inside the limits, from there or from the seed; an isolated solution by one that
 * counts as the same and is as exact as a row has to be. */
DHGEN_FN void dhgen_move_inside(
    struct dhgen_descent *d, const struct dhgen_kept *kept, int alone, double enough, double *u)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double end[DHGEN_JOINTS];
    if (dhgen_clamp_units(d, u, end) <= DHGEN_LIMIT)
        return;
    for (int from_seed = 0; from_seed < 2; from_seed++) {
        (void)dhgen_clamp_units(d, from_seed ? d->seed : u, end);
        if (dhgen_pull_to_seed(d, end, arm->lowest, arm->highest) > enough)
            continue;
        if (alone && !dhgen_reach_inside(d, u, end))
            continue;
        if (dhgen_find_known(d, kept, end, 1) < 0 && (!alone || dhgen_is_same(d, u, end, 1))) {
            dhgen_copy_units(arm, end, u);
            return;
        }
    }
}

/* Whether of two solutions that are one the new one is kept: if it alone is inside the limits, and
 * as exact as a row has to be. */
DHGEN_FN int dhgen_replaces(struct dhgen_descent *d, const double *u, const double *known)
{
    double end[DHGEN_JOINTS];
    if (dhgen_clamp_units(d, known, end) <= DHGEN_LIMIT
        || dhgen_clamp_units(d, u, end) > DHGEN_LIMIT)
        return 0;
    dhgen_measure_miss(d, u);
    return d->length <= DHGEN_PROMISED;
}

/* Adds a solution to the ones kept, unless it is one of them. Where the task names more than the
 * joints can choose, and one is exact, the pose has not been rounded: then all have to be exact. */
DHGEN_FN void dhgen_keep(struct dhgen_descent *d, struct dhgen_kept *kept, double *u)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    const double enough = dhgen_enough_beside(d, u);
    const double before = kept->count ? dhgen_enough_beside(d, kept->u[0]) : enough;
    if (before < enough)
        return;
    if (before > enough)
        kept->count = 0;
    if (kept->count == dhgen_rows(arm) || dhgen_find_known(d, kept, u, 0) >= 0)
        return;
    const int kind = dhgen_is_continuum(d, u, enough);
    if (kind == 1)
        dhgen_go_to_nearest_member(d, u, enough, kept->ahead);
    if (arm->limited && kind >= 0)
        dhgen_move_inside(d, kept, !kind, enough, u);
    dhgen_wrap_units(arm, u);
    int k = dhgen_find_known(d, kept, u, kind >= 0);
    if (k >= 0 && !(arm->limited && dhgen_replaces(d, u, kept->u[k])))
        return;
    k = k < 0 ? kept->count++ : k;
    kept->singular[k] = kind >= 0;
    kept->chosen[k] = kind == 1;
    dhgen_copy_units(arm, u, kept->u[k]);
}

/* Keeps the solutions ahead, except members of continua that were already walked along. */
DHGEN_FN void dhgen_keep_ahead(struct dhgen_descent *d, struct dhgen_kept *kept)
{
    struct dhgen_ahead *const ahead = kept->ahead;
    for (int k = 0; k < ahead->count; k++)
        if (!ahead->passed[k]) {
            ahead->passed[k] = 1;
            dhgen_keep(d, kept, ahead->u[k]);
        }
    ahead->count = 0;
}

#endif

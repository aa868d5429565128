/* SPDX-License-Identifier: MIT
 *
 * The solutions of an arm by descents alone. */
#ifndef DHGEN_NUMERICAL_SEARCH_H
#define DHGEN_NUMERICAL_SEARCH_H

#include "../numerical.h"
#include "pairs.h"

/* Starts of all rounds together; the search ends with the first round that finds nothing new. */
#define DHGEN_MOST_STARTS 384

/* Of infinitely many solutions one near to the seed; whether there is one. */
DHGEN_FN int dhgen_nearest_solution(
    struct dhgen_descent *d, const double *low, const double *high, double *best)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double least = HUGE_VAL, u[DHGEN_JOINTS];
    for (int k = 0; k < arm->starts; k++) {
        dhgen_start(d, k, u);
        for (int j = 0; j < arm->solved; j++)
            u[j] = fmin(fmax(u[j], low[j]), high[j]);
        if (dhgen_pull_to_seed(d, u, low, high) > arm->residual)
            continue;
        double square = 0.0;
        for (int j = 0; j < arm->solved; j++)
            square += (u[j] - d->seed[j]) * (u[j] - d->seed[j]);
        if (square < least) {
            least = square;
            dhgen_copy_units(arm, u, best);
        }
    }
    return least < HUGE_VAL;
}

/* The one row of an arm whose solutions are families, beyond limits where none is inside. */
DHGEN_FN void dhgen_redundant_row(struct dhgen_descent *d, double *q, unsigned char *status)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double u[DHGEN_JOINTS] = { 0.0 };
    if (!dhgen_nearest_solution(d, arm->lowest, arm->highest, u)
        && !dhgen_nearest_solution(d, dhgen_no_lowest, dhgen_no_highest, u))
        return;
    status[0] = DHGEN_OK;
    dhgen_wrap_units(arm, u);
    for (int i = 0; i < dhgen_dof(arm); i++)
        q[i] = d->q[i];
    for (int j = 0; j < arm->solved; j++)
        q[arm->joint[j]] = arm->unit[j] * u[j];
}

DHGEN_API void dhgen_numerical_rows(const struct dhgen_numerical_arm *arm, const double *T,
    const double *free_joints, const double *seed, double *q, unsigned char *status)
{
    struct dhgen_descent d;
    struct dhgen_kept kept;
    dhgen_begin_descent(arm, T, free_joints, seed, &d);
    if (arm->redundant) {
        dhgen_redundant_row(&d, q, status);
        return;
    }
    kept.count = 0;
    kept.ahead = 0;
    for (int k = 0, before = -1; k < DHGEN_MOST_STARTS; k++) {
        double u[DHGEN_JOINTS];
        if (k % arm->starts == 0) {
            if (kept.count == before || kept.count == dhgen_rows(arm))
                break;
            before = kept.count;
        }
        dhgen_start(&d, k, u);
        if (dhgen_descend(&d, u) <= arm->residual)
            dhgen_keep(&d, &kept, u);
    }
    dhgen_complete_pairs(&d, &kept);
    dhgen_sort_rows(&d, &kept, q, status);
}

#endif

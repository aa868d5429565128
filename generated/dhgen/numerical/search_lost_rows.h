/* SPDX-License-Identifier: MIT
 *
 * A pose was left without a row after a joint had been chosen, or with rows that are not exact or
 * beyond limits: several joints may be free, and few of their values work. Steps from the seed and
 * from evenly spread starts find some that do. */
#ifndef DHGEN_NUMERICAL_SEARCH_LOST_ROWS_H
#define DHGEN_NUMERICAL_SEARCH_LOST_ROWS_H

#include "../refine.h"
#include "refine_rows.h"

/* Starts of a search. */
#define DHGEN_SEARCH_STARTS 12
/* What is wrong with joint values, as a sum: they are beyond limits, not exact, there are none. */
enum { DHGEN_IS_BEYOND_LIMITS = 1, DHGEN_IS_INEXACT = 2, DHGEN_IS_MISSING = 4 };

/* What is wrong with joint values that miss the pose by so much. */
DHGEN_FN int dhgen_fault(const struct dhgen_arm *arm, double miss, double exact, const double *q)
{
    const int beyond = arm->keeps_limits && dhgen_beyond_limits(arm, q) > 0.0;
    return (miss > exact ? DHGEN_IS_INEXACT : 0) + (beyond ? DHGEN_IS_BEYOND_LIMITS : 0);
}

/* What is wrong with the best of the rows; `chosen` is the first where a joint is free or nearly,
 * else -1. */
DHGEN_FN int dhgen_least_fault(const struct dhgen_arm *arm, struct dhgen_descent *d, double exact,
    const double *q, const unsigned char *status, int *chosen)
{
    int least = DHGEN_IS_MISSING;
    *chosen = -1;
    for (int row = dhgen_rows(arm) - 1; row >= 0; row--) {
        const double *const values = q + dhgen_dof(arm) * row;
        double here[DHGEN_JOINTS], ahead = 0.0, miss = 0.0;
        if (status[row] == DHGEN_UNREACHABLE)
            continue;
        if (d->arm->checked) {
            dhgen_copy_row(arm, values, here);
            miss = dhgen_approach(d, 0, exact, here, &ahead);
        }
        const int fault = dhgen_fault(arm, miss, exact, values);
        least = fault < least ? fault : least;
        *chosen = status[row] == DHGEN_FREE_JOINT || ahead > DHGEN_SURE ? row : *chosen;
    }
    return least;
}

/* Takes start number k to a solution, inside limits if it can. Returns by how much it misses the
 * pose, or infinity where there is none. */
DHGEN_FN double dhgen_search_from(
    const struct dhgen_arm *arm, struct dhgen_descent *d, int k, double exact, double *end)
{
    const struct dhgen_numerical_arm *const descents = d->arm;
    const struct dhgen_completion *const of = arm->completion;
    /* a pose that is checked may have been rounded */
    const double nearly = descents->checked ? descents->residual : DHGEN_DOUBTFUL;
    const double enough = descents->checked ? descents->residual : DHGEN_LOOSE * exact;
    double u[DHGEN_JOINTS], ahead;
    dhgen_start(d, k, u);
    if (dhgen_descend(d, u) > nearly)
        return HUGE_VAL;
    dhgen_copy_row(arm, d->q, end);
    for (int j = 0; j < descents->solved; j++)
        end[descents->joint[j]] = descents->unit[j] * u[j];
    const double miss = descents->checked ? dhgen_approach(d, DHGEN_ROW_STEPS, exact, end, &ahead)
                                          : dhgen_escape(d, exact, end);
    if (miss > enough)
        return HUGE_VAL;
    if (of->arm_angle && fabs(dhgen_wrap(of->arm_angle(end) - d->free_joints[0])) > 1.0)
        return HUGE_VAL; /* the elbow is on the other side */
    if (arm->keeps_limits && arm->clamps && dhgen_beyond_limits(arm, end) > 0.0)
        (void)dhgen_refine(arm, d->T, -arm->clamped[0], HUGE_VAL, end);
    return miss;
}

/* Searches joint values with less wrong with them than the rows have, for row `begun`, or for one
 * that has a free joint where only limits are at fault. Of rows that were `fitted` to a pose that
 * may be rounded only exact values take the place. */
DHGEN_FN void dhgen_search_lost_rows(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, int begun, int fitted, double *q,
    unsigned char *status)
{
    const double exact = dhgen_exactness(arm->completion->descents, T);
    const int dof = dhgen_dof(arm);
    double found[DHGEN_JOINTS] = { 0.0 }, end[DHGEN_JOINTS];
    struct dhgen_descent d;
    int chosen;
    dhgen_begin_descent(arm->completion->descents, T, free_joints, seed, &d);
    const int before = dhgen_least_fault(arm, &d, exact, q, status, &chosen);
    if (before == 0 || (before < DHGEN_IS_MISSING && chosen < 0 && !fitted))
        return;
    int least = before;
    for (int k = 0; k < DHGEN_SEARCH_STARTS && least; k++) {
        const double miss = dhgen_search_from(arm, &d, k, exact, end);
        const int fault = isinf(miss) ? DHGEN_IS_MISSING : dhgen_fault(arm, miss, exact, end);
        if (fault < least) {
            least = fault;
            dhgen_copy_row(arm, end, found);
        }
    }
    if (least == before || (fitted && (least & DHGEN_IS_INEXACT)))
        return;
    if (arm->keeps_limits && before < DHGEN_IS_MISSING && chosen >= 0
        && (before & DHGEN_IS_INEXACT) == (least & DHGEN_IS_INEXACT)) {
        dhgen_copy_row(arm, found, q + dof * chosen); /* other rows are no less exact */
        return;
    }
    for (int row = 0; row < dhgen_rows(arm); row++)
        dhgen_empty_row(arm, q + dof * row, status + row);
    status[begun] = DHGEN_FREE_JOINT;
    dhgen_copy_row(arm, found, q + dof * begun);
}

#endif

/* SPDX-License-Identifier: MIT
 *
 * Rows that are one solution: branches that meet come out apart by rounding where one root follows
 * another. */
#ifndef DHGEN_DUPLICATES_H
#define DHGEN_DUPLICATES_H

#include "arm.h"
#include "refine.h"
#include "tolerances.h"

/* The damping of steps that leave singular directions alone, and how many are made. */
#define DHGEN_SINGULAR 1e-13
#define DHGEN_STEPS_TO_DOUBLE 3

/* Whether two rows are one solution: half way between them the arm is singular, and solves the
 * pose. */
DHGEN_FN int dhgen_are_duplicates(
    const struct dhgen_arm *arm, const double *T, const double *q, const double *other)
{
    const int held[DHGEN_JOINTS] = { 0 };
    double half[DHGEN_JOINTS], e[6];
    if (!(dhgen_half_way(arm, q, other, half) < DHGEN_TOGETHER) || isnan(half[0]))
        return 0;
    for (int i = 0; i < DHGEN_STEPS_TO_DOUBLE; i++) {
        dhgen_miss(arm, T, half, e);
        dhgen_add_step(arm, held, DHGEN_SINGULAR, e, half);
    }
    return dhgen_miss(arm, T, half, e) <= DHGEN_MERGE;
}

/* Empties rows that differ from earlier ones by rounding alone. Where roots follow roots each row
 * is refined first, and emptied if no solution is found. */
DHGEN_FN void dhgen_remove_duplicates(
    const struct dhgen_arm *arm, const double *T, double *q, unsigned char *status)
{
    const int dof = dhgen_dof(arm);
    for (int row = 0; row < dhgen_rows(arm); row++) {
        double *const values = q + dof * row, e[6];
        int ends = arm->refines && dhgen_miss(arm, T, values, e) > DHGEN_PROMISED
            && !dhgen_refine(arm, T, DHGEN_EXACT, DHGEN_BESIDE_SEED, values);
        for (int k = 0; k <= row; k++) {
            if (k > 0)
                ends = dhgen_are_duplicates(arm, T, q + dof * (k - 1), values);
            if (ends)
                dhgen_empty_row(arm, values, status + row);
        }
    }
}

#endif

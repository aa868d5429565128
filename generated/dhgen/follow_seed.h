/* SPDX-License-Identifier: MIT
 *
 * Where the seed solves the pose with other joint values than the rows, and the solutions differ by
 * less than rounding, the arm may as well go on with the seed's. */
#ifndef DHGEN_FOLLOW_SEED_H
#define DHGEN_FOLLOW_SEED_H

#include "arm.h"
#include "refine.h"
#include "tolerances.h"

/* Misses half way to two rows whose ratio is below this are equal but for rounding, which differs
 * between languages. The first row is taken. */
#define DHGEN_ALIKE 2.0

/* Takes joint values to the solution next to the seed that keeps the caller's values and, where
 * joints are clamped or coupled, limits. Returns whether there is one. */
DHGEN_FN int dhgen_beside_seed(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, double *x)
{
    for (int i = 0; i < dhgen_dof(arm); i++) {
        double here = seed[i];
        if (arm->range_exceeds_a_turn
            && !(fabs(dhgen_past_an_end(arm, i, here)) <= DHGEN_BESIDE_SEED))
            here = dhgen_turned(arm, i, here, here);
        x[i] = arm->clamps ? here - dhgen_past_an_end(arm, i, here) : here;
    }
    for (int k = 0; k < arm->given_joint_count; k++)
        x[arm->given_joints[k]] = free_joints[k];
    if (!dhgen_refine(arm, T, DHGEN_EXACT, DHGEN_BESIDE_SEED, x))
        return 0;
    return (!(arm->clamps && dhgen_past_ends(arm, x) > DHGEN_LIMIT)
               || dhgen_refine_inside(arm, T, arm->clamped[0], DHGEN_BESIDE_SEED, x))
        && !(arm->beyond && arm->beyond(arm, x) > DHGEN_LIMIT);
}

/* Gives the solution next to the seed a row: its own, one as good, one left, or any. */
DHGEN_FN void dhgen_follow_seed(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, double *q, unsigned char *status)
{
    const int dof = dhgen_dof(arm);
    double x[DHGEN_JOINTS], half[DHGEN_JOINTS], e[6], least = HUGE_VAL, nearest = DHGEN_TOGETHER;
    int place = 0;
    if (!dhgen_beside_seed(arm, T, free_joints, seed, x))
        return;
    for (int row = dhgen_rows(arm) - 1; row >= 0; row--) {
        double between = DHGEN_FAMILY;
        if (status[row] != DHGEN_UNREACHABLE) {
            const double off = dhgen_half_way(arm, x, q + dof * row, half);
            between = 0.0;
            if (!(arm->clamps && off < DHGEN_TOGETHER))
                between = fmax(dhgen_miss(arm, T, half, e), DHGEN_EXACT);
            if (off < nearest) {
                nearest = off;
                place = row;
                least = -1.0; /* its own */
            }
        }
        if (between <= DHGEN_ALIKE * least)
            place = row;
        least = fmin(least, between);
    }
    if (least >= 0.0)
        status[place] = DHGEN_FREE_JOINT;
    if (nearest > DHGEN_APART_BY || (arm->clamps && dhgen_past_ends(arm, q + dof * place) > 0.0))
        dhgen_copy_row(arm, x, q + dof * place);
}

#endif

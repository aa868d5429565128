/* SPDX-License-Identifier: MIT
 *
 * Descents that end as near to the seed as they can, between limits. */
#ifndef DHGEN_NUMERICAL_PULL_H
#define DHGEN_NUMERICAL_PULL_H

#include "descent.h"

/* Along a continuum of solutions: a part of the way to the seed with every step, then Newton
 * alone. */
#define DHGEN_PULL 0.5
#define DHGEN_PULLED_STEPS 60
/* A step shorter than this ends the pull [rad, arm sizes]. */
#define DHGEN_PULL_SETTLED 1e-09

/* Limits where there are none. */
#define DHGEN_ALL_JOINTS(x) \
    { \
        x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x \
    }
DHGEN_UNUSED DHGEN_TABLE double dhgen_no_lowest[16] = DHGEN_ALL_JOINTS(-HUGE_VAL);
DHGEN_UNUSED DHGEN_TABLE double dhgen_no_highest[16] = DHGEN_ALL_JOINTS(HUGE_VAL);

/* A step with a pull; joints that it would take beyond a limit are put there, and locked. */
DHGEN_FN void dhgen_limited_step(struct dhgen_descent *d, const double *u, double pull,
    const double *low, const double *high, double *step)
{
    const int solved = d->arm->solved, equations = d->arm->equations;
    double e[DHGEN_MOST_EQUATIONS], wish[DHGEN_JOINTS];
    double fixed[DHGEN_JOINTS] = { 0.0 };
    int locked[DHGEN_JOINTS], beyond = 1;
    for (int j = 0; j < solved; j++) {
        wish[j] = pull * (fmin(fmax(d->seed[j], low[j]), high[j]) - u[j]);
        locked[j] = 0;
    }
    while (beyond) {
        beyond = 0;
        for (int i = 0; i < equations; i++) {
            e[i] = d->e[i];
            for (int j = 0; j < solved; j++)
                e[i] -= d->A[i][j] * wish[j];
        }
        dhgen_damped_step(d, e, d->length, DHGEN_DAMPING_FLOOR, step);
        for (int j = 0; j < solved; j++)
            step[j] += wish[j];
        dhgen_shorten(d->arm, step);
        for (int j = 0; j < solved; j++) {
            const double end = u[j] + step[j];
            if (locked[j]) {
                step[j] = fixed[j];
            } else if (end < low[j] || end > high[j]) {
                step[j] = fixed[j] = (end < low[j] ? low[j] : high[j]) - u[j];
                beyond = locked[j] = 1;
                wish[j] = 0.0;
                for (int i = 0; i < equations; i++) {
                    d->e[i] -= d->A[i][j] * fixed[j];
                    d->A[i][j] = 0.0;
                }
            }
        }
    }
}

/* Takes u to a solution on the way to the seed; returns by how much it misses the pose. */
DHGEN_FN double dhgen_pull_to_seed(
    struct dhgen_descent *d, double *u, const double *low, const double *high)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double least = HUGE_VAL, pull = DHGEN_PULL;
    double best[DHGEN_JOINTS], step[DHGEN_JOINTS];
    dhgen_copy_units(arm, u, best); /* compilers can't infer that some miss is finite */
    for (int k = 1; k <= DHGEN_PULLED_STEPS + DHGEN_DESCENT_STEPS; k++) {
        dhgen_measure_miss(d, u);
        if (pull == 0.0) {
            if (d->length >= 0.5 * least && least <= DHGEN_SOLUTION)
                break;
            if (d->length < least) {
                least = d->length;
                dhgen_copy_units(arm, u, best);
            }
        }
        dhgen_limited_step(d, u, pull, low, high, step);
        double longest = 0.0;
        for (int j = 0; j < arm->solved; j++) {
            longest = fmax(longest, fabs(step[j]));
            u[j] += step[j];
        }
        if (k >= DHGEN_PULLED_STEPS || longest < DHGEN_PULL_SETTLED)
            pull = 0.0;
    }
    dhgen_copy_units(arm, best, u);
    return least;
}

#endif

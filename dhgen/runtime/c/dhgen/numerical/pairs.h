/* SPDX-License-Identifier: MIT
 *
 * Pairs of solutions that nearly meet: where one is a row the other becomes one, too. Between them
 * the arm is singular, so that steps from anywhere may converge to one of the two, or to half way
 * between. Along the motion v that leaves the tool where it is, nearly, the pose is missed by
 *
 *     e(t) = e - s t + b t^2 / 2,
 *
 * measured along what v moves: both solutions are near its zeros. */
#ifndef DHGEN_NUMERICAL_PAIRS_H
#define DHGEN_NUMERICAL_PAIRS_H

#include "keep.h"

/* How fast that motion moves the tool, at most: a solution as regular as this has enough digits to
 * be distinct from others as found. At least: of singular solutions it is rounding. */
#define DHGEN_SLOWEST_REGULAR 0.001
#define DHGEN_STILL 1e-13
/* How far along that motion the second derivative b is measured: rounding of it is 1e-10 then. */
#define DHGEN_BEND_STEP 0.001
/* Zeros farther away than this are none of a parabola [rad, arm sizes]; up to here they are starts,
 * and along nearly a continuum the only ones from which it is found. */
#define DHGEN_FARTHEST_OTHER 1.0

/* The zeros of the miss along that motion, the nearer one first, and the motion; returns whether
 * there is a parabola, as bent as that both are near. */
DHGEN_FN int dhgen_find_pair(
    struct dhgen_descent *d, const double *u, double *along, double zeros[2])
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double moved[DHGEN_MOST_EQUATIONS], beside[DHGEN_JOINTS];
    double square = 0.0, missed = 0.0, bend = 0.0;
    dhgen_measure_miss(d, u);
    (void)dhgen_null_direction(d, along);
    (void)dhgen_keep_null_part(d, along);
    for (int i = 0; i < arm->equations; i++) {
        moved[i] = 0.0;
        for (int j = 0; j < arm->solved; j++)
            moved[i] += d->A[i][j] * along[j];
        square += moved[i] * moved[i];
    }
    const double speed = sqrt(square);
    if (!(speed > DHGEN_STILL && speed < DHGEN_SLOWEST_REGULAR))
        return 0;
    for (int i = 0; i < arm->equations; i++)
        missed += d->e[i] * moved[i] / speed;
    for (int side = -1; side <= 1; side += 2) {
        for (int j = 0; j < arm->solved; j++)
            beside[j] = u[j] + side * DHGEN_BEND_STEP * along[j];
        dhgen_measure_miss(d, beside);
        for (int i = 0; i < arm->equations; i++)
            bend += d->e[i] * moved[i] / speed;
    }
    bend = (bend - 2.0 * missed) / (DHGEN_BEND_STEP * DHGEN_BEND_STEP);
    const double spread = speed * speed - 2.0 * bend * missed;
    if (!(spread > 0.0))
        return 0;
    const double sum = speed + sqrt(spread);
    if (!(sum < DHGEN_FARTHEST_OTHER * fabs(bend)))
        return 0;
    zeros[0] = 2.0 * missed / sum;
    zeros[1] = sum / bend;
    return 1;
}

/* Takes a row that is not as exact as it can be, as where it lies half way between two solutions,
 * to the solution that steps from `start` converge to; drops it where another row has that one.
 * Returns whether it is still there. */
DHGEN_FN int dhgen_sharpen(struct dhgen_descent *d, struct dhgen_kept *kept, int k, double *start)
{
    double *const u = kept->u[k], inside[DHGEN_JOINTS];
    const double miss = dhgen_descend(d, start);
    dhgen_measure_miss(d, u);
    if (miss > 0.5 * d->length)
        return 1;
    if (d->arm->limited && dhgen_clamp_units(d, start, inside) > DHGEN_LIMIT
        && dhgen_clamp_units(d, u, inside) <= DHGEN_LIMIT)
        return 1;
    const int known = dhgen_find_known(d, kept, start, 0);
    dhgen_wrap_units(d->arm, start);
    if (known < 0 || known == k) {
        dhgen_copy_units(d->arm, start, u);
        return 1;
    }
    const int last = --kept->count;
    dhgen_copy_units(d->arm, kept->u[last], u);
    kept->singular[k] = kept->singular[last];
    kept->chosen[k] = kept->chosen[last];
    return 0;
}

/* Adds the other one of each pair of solutions that nearly meet. */
DHGEN_FN void dhgen_complete_pairs(struct dhgen_descent *d, struct dhgen_kept *kept)
{
    for (int k = 0; k < kept->count; k++) {
        double along[DHGEN_JOINTS], zeros[2], one[DHGEN_JOINTS], other[DHGEN_JOINTS];
        if (kept->chosen[k] || !dhgen_find_pair(d, kept->u[k], along, zeros))
            continue;
        for (int j = 0; j < d->arm->solved; j++) {
            one[j] = kept->u[k][j] + zeros[0] * along[j];
            other[j] = kept->u[k][j] + zeros[1] * along[j];
        }
        if (!dhgen_sharpen(d, kept, k, one))
            k--; /* the pair of the row that has it is completed, too */
        else if (dhgen_descend(d, other) <= d->arm->residual)
            dhgen_keep(d, kept, other);
    }
}

#endif

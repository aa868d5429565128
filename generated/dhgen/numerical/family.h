/* SPDX-License-Identifier: MIT
 *
 * A continuum of solutions gives one row, the member nearest to the seed, whichever member was
 * found: which one that is rounding decides, as it does where a descent ends that is drawn to the
 * seed along a bend. */
#ifndef DHGEN_NUMERICAL_FAMILY_H
#define DHGEN_NUMERICAL_FAMILY_H

#include "../tolerances.h"
#include "solutions.h"

/* From member to member [rad, arm sizes], and how many to each side: a closed family is mostly less
 * than two turns long. */
#define DHGEN_WALK_STEP 0.2
#define DHGEN_WALK_STEPS 120
/* The walk has come round when its beginning is just behind, no farther than this part of a step,
 * and the direction is about the same. */
#define DHGEN_WALK_CLOSED 1.2
/* Steps to where the distance from the seed is least; one below the length is the last. */
#define DHGEN_LEAST_STEPS 40
#define DHGEN_LEAST_SETTLED 1e-11
/* Two members are equally near to the seed when the squares of their distances differ by less; then
 * values that differ by more than the second decide [rad, arm sizes]. */
#define DHGEN_EQUALLY_NEAR 1e-7
#define DHGEN_MEMBER_TIE 1e-6

/* A walk along a continuum: where it is, its direction, how the distance from the seed falls that
 * way; the best member where that is least so far, if there is any, and the nearest one inside the
 * limits that the walk came by, wherever that is. */
struct dhgen_walk {
    double u[DHGEN_JOINTS], along[DHGEN_JOINTS], fall;
    double best[DHGEN_JOINTS], best_square, inside[DHGEN_JOINTS], inside_square;
    int any, best_inside;
};

/* The nearest values inside the limits, whole turns aside, but next to the seed's where they are
 * just beyond an end there; returns how far one was beyond. */
DHGEN_FN double dhgen_clamp_units(const struct dhgen_descent *d, const double *u, double *inside)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double most = 0.0;
    for (int j = 0; j < arm->solved; j++) {
        const double low = arm->lowest[j], high = arm->highest[j];
        const double middle = 0.5 * (low + high), seen = d->seed[j];
        double near = u[j];
        if (arm->turning[j] && isfinite(middle)) {
            near -= DHGEN_TURN * floor((near - seen) / DHGEN_TURN + 0.5);
            const double past = fmax(low - near, near - high);
            if (past >= DHGEN_DOUBTFUL || fabs(near - seen) >= DHGEN_BESIDE_SEED)
                near -= DHGEN_TURN * ceil((near - middle) / DHGEN_TURN - 0.5);
        }
        inside[j] = fmin(fmax(near, low), high);
        most = fmax(most, fabs(inside[j] - near));
    }
    return most;
}

/* The way from joint values to others, whole turns aside; returns the square of its length. */
DHGEN_FN double dhgen_shortest_way(
    const struct dhgen_numerical_arm *arm, const double *from, const double *to, double *way)
{
    double square = 0.0;
    for (int j = 0; j < arm->solved; j++)
        way[j] = to[j] - from[j];
    dhgen_wrap_units(arm, way);
    for (int j = 0; j < arm->solved; j++)
        square += way[j] * way[j];
    return square;
}

/* The sum of products. */
DHGEN_FN double dhgen_along(const struct dhgen_numerical_arm *arm, const double *a, const double *b)
{
    double sum = 0.0;
    for (int j = 0; j < arm->solved; j++)
        sum += a[j] * b[j];
    return sum;
}

/* Goes from a member of a continuum to another, so far along it; returns 0 where that ends. */
DHGEN_FN int dhgen_walk_on(
    struct dhgen_descent *d, struct dhgen_walk *walk, double step, double enough)
{
    double way[DHGEN_JOINTS];
    for (int j = 0; j < d->arm->solved; j++)
        walk->u[j] += step * walk->along[j];
    if (dhgen_descend(d, walk->u) > enough)
        return 0;
    dhgen_measure_miss(d, walk->u);
    const double length = dhgen_keep_null_part(d, walk->along);
    (void)dhgen_shortest_way(d->arm, walk->u, d->seed, way);
    walk->fall = dhgen_along(d->arm, way, walk->along);
    return length > DHGEN_SINGULAR_LENGTH;
}

/* Keeps of a member and the best one so far that which is nearer to the seed: inside the limits if
 * one is, and of two that are equally near the one that rows would begin with. */
DHGEN_FN void dhgen_keep_nearer(struct dhgen_descent *d, struct dhgen_walk *walk)
{
    double other[DHGEN_JOINTS];
    const double square = dhgen_shortest_way(d->arm, walk->u, d->seed, other);
    const int inside = !d->arm->limited || dhgen_clamp_units(d, walk->u, other) <= DHGEN_LIMIT;
    int better = !walk->any || square < walk->best_square;
    dhgen_wrap_units(d->arm, walk->u);
    if (walk->any && fabs(square - walk->best_square) <= DHGEN_EQUALLY_NEAR)
        for (int j = d->arm->solved - 1; j >= 0; j--)
            if (fabs(walk->u[j] - walk->best[j]) > DHGEN_MEMBER_TIE)
                better = walk->u[j] < walk->best[j];
    if (walk->any && inside != walk->best_inside)
        better = inside;
    if (!better)
        return;
    dhgen_copy_units(d->arm, walk->u, walk->best);
    walk->best_square = square;
    walk->best_inside = inside;
    walk->any = 1;
}

/* Keeps where the walk is if that is the nearest to the seed inside the limits so far. */
DHGEN_FN void dhgen_note_inside(struct dhgen_descent *d, struct dhgen_walk *walk)
{
    double way[DHGEN_JOINTS], inside[DHGEN_JOINTS];
    const double square = dhgen_shortest_way(d->arm, walk->u, d->seed, way);
    if (square < walk->inside_square && dhgen_clamp_units(d, walk->u, inside) <= DHGEN_LIMIT) {
        walk->inside_square = square;
        dhgen_copy_units(d->arm, inside, walk->inside);
    }
}

/* Goes to where the distance from the seed is least, nearby: a secant method along the continuum.
 */
DHGEN_FN void dhgen_walk_to_least(struct dhgen_descent *d, struct dhgen_walk *walk, double enough)
{
    double per_fall = 1.0;
    for (int k = 0; k < DHGEN_LEAST_STEPS; k++) {
        const double before = walk->fall;
        const double step = fmin(fmax(per_fall * before, -DHGEN_WALK_STEP), DHGEN_WALK_STEP);
        if (!dhgen_walk_on(d, walk, step, enough))
            return;
        if (fabs(step) < DHGEN_LEAST_SETTLED)
            break;
        const double secant = step / (before - walk->fall);
        per_fall = secant > 0.0 && secant < HUGE_VAL ? secant : 1.0;
    }
    dhgen_keep_nearer(d, walk);
}

/* Looks for the nearest members to one side, and marks solutions ahead that it comes by; returns
 * whether the walk came round. */
DHGEN_FN int dhgen_walk_along(struct dhgen_descent *d, struct dhgen_walk *walk, const double *first,
    double enough, struct dhgen_ahead *ahead)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double start[DHGEN_JOINTS], way[DHGEN_JOINTS];
    const double closed = DHGEN_WALK_CLOSED * DHGEN_WALK_STEP;
    dhgen_copy_units(arm, walk->u, start);
    dhgen_shortest_way(arm, start, d->seed, way);
    walk->fall = dhgen_along(arm, way, walk->along);
    for (int k = 0; k < DHGEN_WALK_STEPS; k++) {
        const double before = walk->fall;
        if (!dhgen_walk_on(d, walk, DHGEN_WALK_STEP, enough))
            return 0;
        dhgen_pass_by(d, walk->u, ahead);
        if (before >= 0.0 && walk->fall < 0.0) {
            struct dhgen_walk aside = *walk;
            dhgen_walk_to_least(d, &aside, enough);
            walk->any = aside.any;
            walk->best_inside = aside.best_inside;
            walk->best_square = aside.best_square;
            dhgen_copy_units(arm, aside.best, walk->best);
        }
        if (arm->limited)
            dhgen_note_inside(d, walk);
        if (k > 1 && dhgen_shortest_way(arm, walk->u, start, way) < closed * closed
            && dhgen_along(arm, way, walk->along) <= 0.0
            && dhgen_along(arm, walk->along, first) > 0.5)
            return 1;
    }
    return 0;
}

/* Takes a member of a continuum to the one that is nearest to the seed, inside the limits if it
 * can; marks the others of it that are ahead. */
DHGEN_FN void dhgen_go_to_nearest_member(
    struct dhgen_descent *d, double *u, double enough, struct dhgen_ahead *ahead)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    struct dhgen_walk walk;
    double first[DHGEN_JOINTS];
    walk.any = walk.best_inside = 0;
    walk.inside_square = HUGE_VAL;
    dhgen_measure_miss(d, u);
    (void)dhgen_null_direction(d, first);
    for (int side = 0, closed = 0; side < 2 && !closed; side++) {
        dhgen_copy_units(arm, u, walk.u);
        for (int j = 0; j < arm->solved; j++)
            walk.along[j] = first[j] = side ? -first[j] : first[j];
        closed = dhgen_walk_along(d, &walk, first, enough, ahead);
    }
    if (!walk.best_inside && walk.inside_square < HUGE_VAL
        && dhgen_pull_to_seed(d, walk.inside, arm->lowest, arm->highest) <= enough) {
        dhgen_copy_units(arm, walk.inside, u);
    } else if (walk.any) {
        dhgen_copy_units(arm, walk.best, u);
    }
}

#endif

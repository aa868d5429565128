/* SPDX-License-Identifier: MIT
 *
 * The solutions that descents find: which are kept, and which are one. */
#ifndef DHGEN_NUMERICAL_SOLUTIONS_H
#define DHGEN_NUMERICAL_SOLUTIONS_H

#include "pull.h"

/* How far a continuum is looked for in that direction, and how far from where it began, and from
 * the other side, a solution must then be [rad, arm sizes]. */
#define DHGEN_FEELER 0.05
#define DHGEN_FELT 0.01
/* Singular solutions closer than this are one if what lies between them solves, too [rad, arm
 * sizes]: from there a few steps reach solutions that are nearer to where they began than this part
 * of the way. */
#define DHGEN_NEIGHBOURS 0.1
#define DHGEN_STEPS_ASIDE 4
#define DHGEN_STAYING_PART 0.0625
/* Between solutions that are one the pose is missed by no more than this, or than twice what they
 * miss it by [arm sizes, rad]: a hundred times rounding. Where many roots meet, those closer than
 * DHGEN_NEXT_TO [rad, arm sizes] miss it by a little more. */
#define DHGEN_SAME_BETWEEN 1e-13
#define DHGEN_NEXT_TO 1e-05
#define DHGEN_SAME_NEXT_TO 1e-12

/* As many solutions as a general arm's algorithm offers at most, the seed's, and the other
 * starts'. */
#define DHGEN_AHEAD 76

/* Parts of the way between two solutions that are looked at. */
DHGEN_TABLE double dhgen_between[3] = { 0.25, 0.5, 0.75 };

/* Solutions that are still to be kept; a walk along a continuum marks its members. */
struct dhgen_ahead {
    double u[DHGEN_AHEAD][DHGEN_JOINTS];
    int count, passed[DHGEN_AHEAD];
};

/* The solutions kept so far, and the ones ahead, if there are any. */
struct dhgen_kept {
    double u[DHGEN_BRANCHES][DHGEN_JOINTS];
    int count, singular[DHGEN_BRANCHES], chosen[DHGEN_BRANCHES];
    struct dhgen_ahead *ahead;
};

/* The largest difference of two joint vectors. */
DHGEN_FN double dhgen_units_apart(
    const struct dhgen_numerical_arm *arm, const double *a, const double *b)
{
    double most = 0.0;
    for (int j = 0; j < arm->solved; j++)
        most = fmax(most, fabs(a[j] - b[j]));
    return most;
}

/* What others may miss beside a solution: where the task names more than the joints can choose, an
 * exact one is left for exact ones only. */
DHGEN_FN double dhgen_enough_beside(struct dhgen_descent *d, const double *u)
{
    if (!d->arm->checked)
        return d->arm->residual;
    dhgen_measure_miss(d, u);
    return d->length <= DHGEN_SOLUTION ? DHGEN_SOLUTION : d->arm->residual;
}

/* Whether solutions lie all along the way from one to another: where many roots meet, joint values
 * beside the solution miss the pose by next to nothing. Between two that nearly meet the pose is
 * missed by next to nothing, too, but by more than at both. */
DHGEN_FN int dhgen_solves_between(
    struct dhgen_descent *d, const double *u, const double *way, double length)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double other[DHGEN_JOINTS], enough = dhgen_enough_beside(d, u);
    for (int j = 0; j < arm->solved; j++)
        other[j] = u[j] + way[j];
    dhgen_measure_miss(d, other);
    const double ends = d->length;
    dhgen_measure_miss(d, u);
    const double least = length < DHGEN_NEXT_TO ? DHGEN_SAME_NEXT_TO : DHGEN_SAME_BETWEEN;
    enough = fmin(enough, fmax(least, 2.0 * fmax(ends, d->length)));
    for (int i = 0; i < 3; i++) {
        double start[DHGEN_JOINTS], end[DHGEN_JOINTS], step[DHGEN_JOINTS];
        for (int j = 0; j < arm->solved; j++)
            start[j] = end[j] = u[j] + dhgen_between[i] * way[j];
        dhgen_measure_miss(d, end);
        for (int k = 0; k < DHGEN_STEPS_ASIDE && d->length > enough; k++) {
            dhgen_damped_step(d, d->e, d->length, DHGEN_DAMPING_FLOOR, step);
            for (int j = 0; j < arm->solved; j++)
                end[j] += step[j];
            dhgen_measure_miss(d, end);
        }
        if (d->length > enough || dhgen_units_apart(arm, start, end) > DHGEN_STAYING_PART * length)
            return 0;
    }
    return 1;
}

/* Whether u is one of a continuum of solutions: 1 if it goes on to both sides, with solutions that
 * miss the pose by no more than `enough`, 0 if it is an isolated singular solution, as where three
 * nearly meet, -1 if it is a regular one. */
DHGEN_FN int dhgen_is_continuum(struct dhgen_descent *d, const double *u, double enough)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double along[DHGEN_JOINTS], end[2][DHGEN_JOINTS];
    dhgen_measure_miss(d, u);
    if (dhgen_null_direction(d, along) <= DHGEN_SINGULAR_LENGTH)
        return -1;
    for (int side = 0; side < 2; side++) {
        for (int j = 0; j < arm->solved; j++)
            end[side][j] = u[j] + (1 - 2 * side) * DHGEN_FEELER * along[j];
        if (dhgen_descend(d, end[side]) > enough
            || dhgen_units_apart(arm, end[side], u) <= DHGEN_FELT)
            return 0;
    }
    if (dhgen_units_apart(arm, end[0], end[1]) <= DHGEN_FELT)
        return 0;
    for (int side = 0; side < 2; side++) {
        for (int j = 0; j < arm->solved; j++)
            along[j] = end[side][j] - u[j];
        if (!dhgen_solves_between(d, u, along, dhgen_units_apart(arm, end[side], u)))
            return 0;
    }
    return 1;
}

/* Whether two solutions are one; loosely where both are singular. */
DHGEN_FN int dhgen_is_same(struct dhgen_descent *d, const double *known, const double *u, int loose)
{
    const double none[DHGEN_JOINTS] = { 0.0 };
    double gap[DHGEN_JOINTS];
    for (int j = 0; j < d->arm->solved; j++)
        gap[j] = u[j] - known[j];
    dhgen_wrap_units(d->arm, gap);
    const double length = dhgen_units_apart(d->arm, gap, none);
    if (length < DHGEN_SAME_UNITS)
        return 1;
    return loose && length < DHGEN_NEIGHBOURS && dhgen_solves_between(d, known, gap, length);
}

/* Which kept solution a solution is; -1 for none. */
DHGEN_FN int dhgen_find_known(
    struct dhgen_descent *d, const struct dhgen_kept *kept, const double *u, int singular)
{
    for (int k = 0; k < kept->count; k++)
        if (dhgen_is_same(d, kept->u[k], u, singular && kept->singular[k]))
            return k;
    return -1;
}

/* Marks the solutions ahead that are the member of a continuum at which a walk is. */
DHGEN_FN void dhgen_pass_by(
    struct dhgen_descent *d, const double *member, struct dhgen_ahead *ahead)
{
    for (int k = 0; ahead && k < ahead->count; k++)
        if (!ahead->passed[k])
            ahead->passed[k] = dhgen_is_same(d, member, ahead->u[k], 1);
}

/* Fills rows by the first joint, then by the second and so on. */
DHGEN_FN void dhgen_sort_rows(
    struct dhgen_descent *d, const struct dhgen_kept *kept, double *q, unsigned char *status)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    const int dof = dhgen_dof(arm);
    int order[DHGEN_BRANCHES], single = kept->count < 2;
    unsigned char first[DHGEN_BRANCHES] = { 0 };
    for (int k = 0; k < kept->count; k++)
        order[k] = k;
    for (int j = 0; j < arm->solved && !single; j++) {
        double value[DHGEN_BRANCHES];
        for (int k = 0; k < kept->count; k++)
            value[k] = dhgen_order_of(kept->u[k][j], arm->turning[j]);
        single = dhgen_order_blocks(value, DHGEN_TIE, kept->count, order, first);
    }
    for (int row = 0; row < kept->count; row++) {
        double *const of = q + dof * row;
        for (int i = 0; i < arm->given_joints; i++)
            of[arm->given[i]] = d->q[arm->given[i]];
        for (int j = 0; j < arm->solved; j++)
            of[arm->joint[j]] = arm->unit[j] * kept->u[order[row]][j];
        status[row] = kept->chosen[order[row]] ? DHGEN_FREE_JOINT : DHGEN_OK;
    }
}

#endif

/* SPDX-License-Identifier: MIT
 *
 * Rows that miss their pose, taken to solutions by least squares. */
#ifndef DHGEN_NUMERICAL_REFINE_ROWS_H
#define DHGEN_NUMERICAL_REFINE_ROWS_H

#include "../retry.h"
#include "../tolerances.h"
#include "descent.h"

/* Steps of a row that is not exact. Double roots take a quarter off with each; beside a singular
 * place a joint that is nearly free may be anywhere, and three steps are one of it. */
#define DHGEN_ROW_STEPS 72
/* Where many solutions meet the steps end on singular joint values and get slow. They go on from
 * both sides of these, as often as this, while less than this part of the miss is left. */
#define DHGEN_ESCAPES 8
#define DHGEN_STUCK 0.9
/* Steps that miss by less than this part of what counts as exact have come to an end. */
#define DHGEN_SPARE 0.001
/* A row whose step is longer than this is not known yet: the step may reach another solution [rad,
 * arm sizes]. */
#define DHGEN_SURE 0.0001
/* The least miss of a pose that is rounded is found where steps are no longer than this [rad, arm
 * sizes]: far above their rounding, far below the distance of two solutions. */
#define DHGEN_SETTLED 1e-9
/* So many times what counts as exact is still a solution. So many times what a solution may miss a
 * rounded pose by is not far from one. */
#define DHGEN_LOOSE 10.0

/* What an exact row may miss: far away rounding is more [arm sizes, rad]. */
DHGEN_FN double dhgen_exactness(const struct dhgen_numerical_arm *arm, const double *T)
{
    double distance = 1.0; /* arm sizes */
    for (int i = 0; i < arm->coordinates; i++)
        distance = fmax(distance, fabs(T[4 * arm->coordinate[i] + 3]) / arm->size);
    return DHGEN_EXACT * distance;
}

/* Takes the joint values of a row as far as steps help; `ahead` is how long another one would be.
 * Returns by how much the row misses the pose then. Beside a singular place a step that is right
 * may be long, and what it leaves, half of its square, far more than was missed. */
DHGEN_FN double dhgen_approach(
    struct dhgen_descent *d, int steps, double exact, double *q, double *ahead)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double u[DHGEN_JOINTS], best[DHGEN_JOINTS], step[DHGEN_JOINTS], least = HUGE_VAL;
    double last = HUGE_VAL, left = 0.0; /* the miss before a step, and what its curvature leaves */
    for (int i = 0; i < dhgen_dof(arm); i++)
        d->q[i] = q[i];
    for (int j = 0; j < arm->solved; j++)
        best[j] = u[j] = q[arm->joint[j]] / arm->unit[j];
    *ahead = HUGE_VAL;
    for (int k = 0; k <= steps; k++) {
        dhgen_measure_miss(d, u);
        dhgen_damped_step(d, d->e, d->length, DHGEN_FINE, step);
        const int slow = !(d->length <= fmax(0.5 * last, left));
        if (d->length < least) {
            least = d->length;
            *ahead = 0.0;
            dhgen_copy_units(arm, u, best);
            for (int j = 0; j < arm->solved; j++)
                *ahead = fmax(*ahead, fabs(step[j]));
        }
        if (slow || (least <= DHGEN_SPARE * exact && *ahead <= DHGEN_SURE))
            break;
        last = d->length;
        left = dhgen_make_step(arm, step, u);
    }
    dhgen_wrap_units(arm, best);
    for (int j = 0; j < arm->solved; j++)
        q[arm->joint[j]] = arm->unit[j] * best[j];
    return least;
}

/* Takes the joint values of a row to the least miss of a pose that is rounded: that does not
 * vanish. Returns by how much the row misses the pose then. */
DHGEN_FN double dhgen_least_miss(struct dhgen_descent *d, double *q)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double u[DHGEN_JOINTS], best[DHGEN_JOINTS], step[DHGEN_JOINTS];
    double least = HUGE_VAL, ahead = HUGE_VAL;
    for (int j = 0; j < arm->solved; j++)
        best[j] = u[j] = q[arm->joint[j]] / arm->unit[j];
    for (int k = 0; k < DHGEN_ROW_STEPS && ahead > DHGEN_SETTLED; k++) {
        dhgen_measure_miss(d, u);
        if (!(d->length < least))
            break;
        least = d->length;
        ahead = 0.0;
        dhgen_copy_units(arm, u, best);
        dhgen_damped_step(d, d->e, d->length, DHGEN_FINE, step);
        for (int j = 0; j < arm->solved; j++)
            ahead = fmax(ahead, fabs(step[j]));
        (void)dhgen_make_step(arm, step, u);
    }
    dhgen_wrap_units(arm, best);
    for (int j = 0; j < arm->solved; j++)
        q[arm->joint[j]] = arm->unit[j] * best[j];
    return least;
}

/* Takes a row as far as steps help, also from both sides of where they get slow: where many
 * solutions meet, joint values between them are singular. A root of four is missed by the fourth
 * power of the way to it. Returns by how much it misses the pose then. */
DHGEN_FN double dhgen_escape(struct dhgen_descent *d, double exact, double *q)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double ahead, least = dhgen_approach(d, DHGEN_ROW_STEPS, exact, q, &ahead);
    for (int k = 0; k < DHGEN_ESCAPES && least > exact; k++) {
        double u[DHGEN_JOINTS], along[DHGEN_JOINTS], end[2][DHGEN_JOINTS], miss[2];
        for (int j = 0; j < arm->solved; j++)
            u[j] = q[arm->joint[j]] / arm->unit[j];
        dhgen_measure_miss(d, u);
        if (dhgen_null_direction(d, along) <= DHGEN_SINGULAR_LENGTH)
            break;
        double pace = sqrt(sqrt(least));
        for (int side = 0; side < 2; side++) {
            for (int i = 0; i < dhgen_dof(arm); i++)
                end[side][i] = q[i];
            for (int j = 0; j < arm->solved; j++)
                end[side][arm->joint[j]] += pace * arm->unit[j] * along[j];
            pace = -pace;
            miss[side] = dhgen_approach(d, DHGEN_ROW_STEPS, exact, end[side], &ahead);
        }
        const int other = miss[1] < miss[0];
        if (!(miss[other] < DHGEN_STUCK * least))
            break;
        least = miss[other];
        for (int i = 0; i < dhgen_dof(arm); i++)
            q[i] = end[other][i];
    }
    return least;
}

/* Refines a row by least squares, unless it is exact. Where the task names more than the joints can
 * choose, a row that can't be exact is kept if it misses the pose by no more than that may be
 * rounded by; if it misses it by more it is taken to the least miss: equations that hold few digits
 * of a joint make far more of the rounding. Returns by how much the row misses the pose then,
 * `first` being what it misses before. */
DHGEN_FN double dhgen_refine_row(
    struct dhgen_descent *d, double exact, double first, double *q, int *moved)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    double end[DHGEN_JOINTS], off[4], ahead, least;
    if (first <= exact)
        return first;
    if (arm->arm_angle) {
        arm->arm_angle_miss(d->T, d->free_joints, q, off);
        if (fabs(off[0]) > DHGEN_DOUBTFUL)
            return HUGE_VAL; /* out of reach: not a matter of rounding */
    }
    for (int i = 0; i < dhgen_dof(arm); i++)
        end[i] = q[i];
    if (arm->checked) {
        least = dhgen_approach(d, DHGEN_ROW_STEPS, exact, end, &ahead);
        const int may_fit = first > arm->residual && least <= DHGEN_LOOSE * arm->residual;
        if (least > exact && may_fit) /* the pose may be rounded */
            least = dhgen_least_miss(d, end);
        if (least > exact && !(may_fit && least <= arm->residual))
            return first;
    } else {
        least = dhgen_escape(d, exact, end);
    }
    for (int i = 0; i < dhgen_dof(arm); i++) {
        *moved = *moved || q[i] < end[i] || q[i] > end[i];
        q[i] = end[i];
    }
    return least;
}

/* By how much the joint values of two rows differ at most, whole turns aside [rad, arm sizes]. */
DHGEN_FN double dhgen_rows_apart(
    const struct dhgen_numerical_arm *arm, const double *q, const double *other)
{
    double gap[DHGEN_JOINTS], widest = 0.0;
    for (int j = 0; j < arm->solved; j++)
        gap[j] = (q[arm->joint[j]] - other[arm->joint[j]]) / arm->unit[j];
    dhgen_wrap_units(arm, gap);
    for (int j = 0; j < arm->solved; j++)
        widest = fmax(widest, fabs(gap[j]));
    return widest;
}

/* Whether a row that was moved came to lie on one that missed by less at first. */
DHGEN_FN int dhgen_repeats(
    const struct dhgen_numerical_arm *arm, const double *q, const double *first, int row)
{
    const int dof = dhgen_dof(arm);
    for (int k = 0; k < dhgen_rows(arm); k++)
        if ((first[k] < first[row] || (k < row && first[k] <= first[row])) && !isnan(q[dof * k])
            && dhgen_rows_apart(arm, q + dof * k, q + dof * row) < DHGEN_SAME_UNITS)
            return 1;
    return 0;
}

/* What a row may miss in the end: where the task names more than the joints can choose, and one row
 * is exact, the pose has not been rounded, and all have to be exact. */
DHGEN_FN double dhgen_enough_in_rows(
    const struct dhgen_numerical_arm *arm, const double *miss, double exact)
{
    double least = HUGE_VAL;
    if (!arm->checked)
        return DHGEN_LOOSE * exact;
    for (int row = 0; row < dhgen_rows(arm); row++)
        least = fmin(least, miss[row]);
    return least <= exact ? exact : arm->residual;
}

/* Refines the rows; empties rows that miss the pose then, and duplicates. Returns whether there are
 * rows that missed the pose by more than it may be rounded by, and miss it by less now. */
DHGEN_FN int dhgen_refine_rows(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, double *q, unsigned char *status)
{
    const struct dhgen_numerical_arm *const descents = arm->completion->descents;
    const int dof = dhgen_dof(arm);
    const double exact = dhgen_exactness(descents, T);
    struct dhgen_descent d;
    int moved[DHGEN_BRANCHES] = { 0 };
    double first[DHGEN_BRANCHES], miss[DHGEN_BRANCHES];
    dhgen_begin_descent(descents, T, free_joints, seed, &d);
    for (int row = 0; row < dhgen_rows(arm); row++) {
        double *const values = q + dof * row;
        first[row] = miss[row] = HUGE_VAL;
        if (status[row] == DHGEN_UNREACHABLE)
            continue;
        first[row] = dhgen_missed_by(arm, T, values);
        miss[row] = dhgen_refine_row(&d, exact, first[row], values, &moved[row]);
    }
    const double enough = dhgen_enough_in_rows(descents, miss, exact);
    for (int row = 0; row < dhgen_rows(arm); row++)
        if (miss[row] > enough)
            q[dof * row] = DHGEN_NAN;
    int fitted = 0;
    for (int row = 0; row < dhgen_rows(arm); row++) {
        if (isnan(q[dof * row]) || (moved[row] && dhgen_repeats(descents, q, first, row)))
            dhgen_empty_row(arm, q + dof * row, status + row);
        else
            fitted |= descents->checked && miss[row] > exact && first[row] > descents->residual;
    }
    return fitted;
}

#endif

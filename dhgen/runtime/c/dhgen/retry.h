/* SPDX-License-Identifier: MIT
 *
 * Other values of free joints, where the seed's, which the solver took, give no solution, or one
 * beyond limits. */
#ifndef DHGEN_RETRY_H
#define DHGEN_RETRY_H

#include "arm.h"
#include "limits.h"
#include "tolerances.h"

/* Values of a free joint that are tried to each side of the first. */
#define DHGEN_HALF_FAN 32
/* How far a joint is moved whose angle has few digits [rad]: from rounding, doubled again and
 * again. */
#define DHGEN_LEAST_MOVE 1e-15
#define DHGEN_MOST_MOVE 0.1
/* Halvings until an interval of a turn is as small as rounding. */
#define DHGEN_HALVINGS 52
/* Where golden section cuts an interval: (3 - root of 5) / 2. */
#define DHGEN_GOLDEN 0.3819660112501051
/* Turns of joints that may have to be chosen together. */
#define DHGEN_TURNS_TOGETHER 12
/* How far a joint is moved to see which others move with it [rad or length]. */
#define DHGEN_ELSEWHERE 0.1

/* A row that another value of a free joint may solve, and what solving again needs. */
struct dhgen_search {
    const struct dhgen_arm *arm;
    const double *T, *free_joints;
    double seed[DHGEN_JOINTS], start, q[DHGEN_BRANCHES * DHGEN_JOINTS];
    unsigned char status[DHGEN_BRANCHES];
    int joint, row;
    int within;      /* whether limits count */
    double best, at; /* where the arm came nearest */
    double by;       /* how far roots are moved */
};

/* Makes a search ready for a row. */
DHGEN_FN void dhgen_start_search(struct dhgen_search *s, const struct dhgen_arm *arm,
    const double *T, const double *free_joints, int row)
{
    s->arm = arm;
    s->T = T;
    s->free_joints = free_joints;
    s->joint = 0;
    s->row = row;
    s->within = 0;
    s->start = s->at = s->by = 0.0;
    s->best = -HUGE_VAL;
    for (int i = 0; i < dhgen_dof(arm); i++)
        s->seed[i] = 0.0;
    for (int i = 0; i < dhgen_dof(arm) * dhgen_rows(arm); i++)
        s->q[i] = 0.0;
}

/* The joint values of the row that is searched. */
DHGEN_FN double *dhgen_found_row(struct dhgen_search *s)
{
    return s->q + dhgen_dof(s->arm) * s->row;
}

/* By how much joint values miss the entries of a pose that count: the root of the sum of squares.
 */
DHGEN_FN double dhgen_missed_by(const struct dhgen_arm *arm, const double *T, const double *q)
{
    double reached[16], sum = 0.0;
    DHGEN_FORWARD(arm, q, reached);
    for (int k = 0; k < arm->entry_count; k++) {
        const int i = arm->entries[k];
        const double off = (reached[i] - T[i]) * (i % 4 == 3 ? arm->per_length : 1.0);
        sum += off * off;
    }
    return sqrt(sum);
}

/* How far the row is from a solution: 0 if it is solved, else less. One that misses the pose, be it
 * by less than is allowed, is nearer than any out of reach. */
DHGEN_FN double dhgen_shortfall(struct dhgen_search *s)
{
    const double *const q = dhgen_found_row(s);
    const int status = s->status[s->row], ended = status >= DHGEN_LOST;
    if (status == DHGEN_UNREACHABLE)
        return -HUGE_VAL;
    if (!s->arm->checks)
        return ended ? q[0] : 0.0;
    if (ended && q[0] < 0.0)
        return q[0] - 1.0;
    const double miss = ended ? q[0] : dhgen_missed_by(s->arm, s->T, q);
    return miss <= DHGEN_FREE ? 0.0 : -miss / (1.0 + miss);
}

/* Solves with the joint moved. Returns 0 if that solves the row, else less. */
DHGEN_FN double dhgen_attempt(struct dhgen_search *s, double moved)
{
    s->seed[s->joint] = s->start + moved;
    for (int i = 0; i < dhgen_rows(s->arm); i++)
        s->status[i] = DHGEN_UNREACHABLE;
    s->arm->solve(s->T, s->free_joints, s->seed, s->by, s->q, s->status);
    const double result = dhgen_shortfall(s);
    if (result > s->best) {
        s->best = result;
        s->at = s->seed[s->joint];
    }
    if (result == 0.0 && s->within)
        return -dhgen_beyond_limits(s->arm, dhgen_found_row(s));
    return result;
}

/* Whether the row was solved, as exactly as poses may be rounded. */
DHGEN_FN int dhgen_works(struct dhgen_search *s)
{
    const int status = s->status[s->row];
    if (s->within && dhgen_beyond_limits(s->arm, dhgen_found_row(s)) > 0.0)
        return 0;
    return status != DHGEN_UNREACHABLE && status < DHGEN_LOST;
}

/* A move between two that works, by golden section, or NaN. */
DHGEN_FN double dhgen_summit(struct dhgen_search *s, double low, double high)
{
    for (int k = 0; k < s->arm->cuts; k++) {
        const double third = DHGEN_GOLDEN * (high - low);
        const double left = dhgen_attempt(s, low + third), right = dhgen_attempt(s, high - third);
        if (left == 0.0 || right == 0.0)
            return left == 0.0 ? low + third : high - third;
        if (left >= right)
            high -= third;
        else
            low += third;
    }
    /* where branches meet this one has no solution of its own */
    if (!s->arm->retries || isinf(dhgen_attempt(s, low - DHGEN_LIMIT))
        || isinf(dhgen_attempt(s, high + DHGEN_LIMIT)))
        return DHGEN_NAN;
    dhgen_attempt(s, low);
    return dhgen_works(s) ? low : DHGEN_NAN;
}

/* The end of the values that work, between a move that may not and one that does, by bisection. */
DHGEN_FN double dhgen_nearest_end(struct dhgen_search *s, double inner, double outer)
{
    for (int i = 0; i < DHGEN_HALVINGS; i++) {
        const double middle = 0.5 * (inner + outer);
        if (dhgen_attempt(s, middle) == 0.0)
            outer = middle;
        else
            inner = middle;
    }
    return outer;
}

/* How far a free joint has to be moved from the seed's value until it works, or NaN: a fan of
 * values, golden section, bisection of the nearest end; of two equally near the lower one. One that
 * is exact comes before all others. */
DHGEN_FN double dhgen_working_value(struct dhgen_search *s)
{
    const double step = s->arm->joints[s->joint].fan_step;
    if (dhgen_attempt(s, 0.0) == 0.0)
        return 0.0;
    double nearest = DHGEN_NAN, before, here = -HUGE_VAL;
    double after = dhgen_attempt(s, -(double)DHGEN_HALF_FAN * step);
    int exactly = 0;
    for (int k = -DHGEN_HALF_FAN; k <= DHGEN_HALF_FAN; k++) {
        before = here;
        here = after;
        after = dhgen_attempt(s, (double)(k + 1) * step);
        double outer = (double)k * step, inner = 0.0;
        if (k != 0)
            inner = k > 0 ? outer - step : outer + step;
        if (here < 0.0 && here >= before && here > after)
            outer = dhgen_summit(s, outer - step, outer + step);
        else if (here < 0.0 || (k > 0 ? before : after) == 0.0)
            continue;
        if (isnan(outer))
            continue;
        if (s->arm->checks) {
            const int exact = !(dhgen_attempt(s, outer) < 0.0);
            if (exact < exactly)
                continue;
            if (exact > exactly)
                nearest = DHGEN_NAN;
            exactly = exact;
        }
        outer = dhgen_nearest_end(s, inner, outer);
        if (!(fabs(outer) >= fabs(nearest) - DHGEN_LIMIT))
            nearest = outer;
    }
    return nearest;
}

/* How far a joint has to be moved whose angle had few digits, so that the arm could not reach, or
 * NaN: the nearest that works, also where the arm just reaches (an elbow is stretched). While it is
 * right up to rounding of what it was taken from, `solve` takes it as its own. */
DHGEN_FN double dhgen_working_digits(struct dhgen_search *s)
{
    double before[2] = { -HUGE_VAL, -HUGE_VAL };
    int past[2] = { 0, 0 };
    double moved = DHGEN_LEAST_MOVE;
    while (moved < DHGEN_MOST_MOVE) {
        for (int way = 0; way < 2; way++) {
            const double there = way ? -moved : moved, here = dhgen_attempt(s, there);
            if (here == 0.0)
                return there;
            if (here < 2.0 * before[way] && !past[way]++) {
                const double top = dhgen_summit(s, 0.25 * there, there);
                if (!isnan(top))
                    return top;
            }
            before[way] = here;
        }
        moved *= 2.0;
    }
    return DHGEN_NAN;
}

/* How far the last of several free joints has to be moved where none works alone, or NaN: in turn
 * each goes to where the arm came nearest. */
DHGEN_FN double dhgen_working_together(struct dhgen_search *s)
{
    const struct dhgen_arm *const arm = s->arm;
    double working = DHGEN_NAN, before = -HUGE_VAL;
    for (int k = 0; k < DHGEN_TURNS_TOGETHER && isnan(working) && s->best > before; k++) {
        before = s->best;
        s->seed[s->joint] = s->at;
        s->joint = arm->together[k % arm->together_count];
        s->start = s->at = s->seed[s->joint];
        working = dhgen_working_value(s);
    }
    return working;
}

/* Where the values of a joint begin that are tried: angles in the first turn, slides inside their
 * strokes, as they are tried as far as these. */
DHGEN_FN double dhgen_first_value(const struct dhgen_arm *arm, int joint, double value)
{
    if (arm->joints[joint].revolute)
        return fmod(value, DHGEN_TURN);
    return arm->keeps_limits ? value - dhgen_overshoot(arm, joint, value) : value;
}

/* Retries a row that was lost after a joint had been chosen: another value of this joint, if one
 * works. */
DHGEN_FN void dhgen_retry_free_joint(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, int row, double *q, unsigned char *status)
{
    const int nearly = status[row] > DHGEN_NEARLY;
    double *const values = q + dhgen_dof(arm) * row;
    struct dhgen_search lost;
    dhgen_start_search(&lost, arm, T, free_joints, row);
    lost.joint = status[row] - (nearly ? DHGEN_NEARLY : DHGEN_LOST) - 1;
    dhgen_copy_row(arm, seed, lost.seed);
    lost.start = dhgen_first_value(arm, lost.joint, nearly ? values[1] : seed[lost.joint]);
    double nearest = nearly ? dhgen_working_digits(&lost) : dhgen_working_value(&lost);
    if (isnan(nearest) && !nearly && arm->together_count > 0)
        nearest = dhgen_working_together(&lost);
    dhgen_attempt(&lost, isnan(nearest) ? 0.0 : nearest);
    const int works = !isnan(nearest) && dhgen_works(&lost);
    status[row] = DHGEN_UNREACHABLE;
    if (works)
        status[row] = lost.status[row];
    for (int i = 0; i < dhgen_dof(arm); i++)
        values[i] = works ? dhgen_found_row(&lost)[i] : DHGEN_NAN;
}

/* Whether a joint beyond its limits does not move with the one that is searched. */
DHGEN_FN int dhgen_is_hopeless(struct dhgen_search *s)
{
    struct dhgen_search other = *s;
    dhgen_attempt(s, 0.0);
    dhgen_attempt(&other, DHGEN_ELSEWHERE);
    if (dhgen_shortfall(s) < 0.0 || dhgen_shortfall(&other) < 0.0)
        return 0;
    for (int i = 0; i < dhgen_dof(s->arm); i++) {
        const double value = dhgen_found_row(s)[i];
        const double moved = fabs(value - dhgen_found_row(&other)[i]);
        if (moved < DHGEN_LIMIT && fabs(dhgen_overshoot(s->arm, i, value)) > 0.0)
            return 1;
    }
    return 0;
}

/* Retries a row where a free joint took the seed's value, and that puts one beyond its limits: the
 * nearest value that keeps all limits, if there is one. Other free joints take the seed's value as
 * far as their limits allow. */
DHGEN_FN void dhgen_keep_limits(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, int row, double *q, unsigned char *status)
{
    struct dhgen_search search;
    dhgen_start_search(&search, arm, T, free_joints, row);
    search.within = 1;
    for (int i = 0; i < dhgen_dof(arm); i++)
        search.seed[i] = seed[i] - dhgen_overshoot(arm, i, seed[i]);
    for (int k = 0; k < arm->choosable_count; k++) {
        const int joint = search.joint = arm->choosable[k];
        const double inside = search.seed[joint];
        search.start = arm->joints[joint].revolute ? fmod(seed[joint], DHGEN_TURN) : inside;
        const double nearest =
            dhgen_is_hopeless(&search) ? DHGEN_NAN : dhgen_working_value(&search);
        /* beside the solution of another row this one has none */
        if (!isnan(nearest)
            && (fabs(nearest) >= DHGEN_APART_BY || !isinf(dhgen_attempt(&search, 0.0)))) {
            dhgen_attempt(&search, nearest);
            status[row] = search.status[row];
            dhgen_copy_row(arm, dhgen_found_row(&search), q + dhgen_dof(arm) * row);
            return;
        }
        search.seed[joint] = inside;
    }
}

#endif

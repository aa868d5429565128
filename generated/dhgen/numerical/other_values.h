/* SPDX-License-Identifier: MIT
 *
 * Joints whose equation is degenerate, which the rest of the pose leaves several values, each of
 * them alone: rows for the others. */
#ifndef DHGEN_NUMERICAL_OTHER_VALUES_H
#define DHGEN_NUMERICAL_OTHER_VALUES_H

#include "refine_rows.h"

/* Values that are tried beside one that works, to each side: first these, each farther by the root
 * of 2, so that what is missed between it and another one that works shows both, however near they
 * are; then as many as of any free joint. */
#define DHGEN_CLOSE_FAN 20
#define DHGEN_WHOLE_FAN (DHGEN_CLOSE_FAN + DHGEN_HALF_FAN)

/* How far value number k of a fan is from its middle: beside it they lie closer. */
DHGEN_FN double dhgen_fan_value(const struct dhgen_arm *arm, int joint, int k)
{
    const double step = arm->joints[joint].fan_step;
    const int far = (k < 0 ? -k : k) - DHGEN_CLOSE_FAN;
    const double off = far > 0 ? step * far : step * exp2(0.5 * far - 0.5);
    return k == 0 ? 0.0 : copysign(off, (double)k);
}

/* Whether the row that is searched has joint values, and to both sides of them none as good. */
DHGEN_FN int dhgen_is_alone(struct dhgen_search *s, const double *values)
{
    const double own = dhgen_attempt(s, 0.0);
    return dhgen_works(s)
        && dhgen_rows_apart(s->arm->completion->descents, dhgen_found_row(s), values)
        < DHGEN_TOGETHER
        && dhgen_attempt(s, dhgen_fan_value(s->arm, s->joint, -1)) < own
        && dhgen_attempt(s, dhgen_fan_value(s->arm, s->joint, 1)) < own;
}

/* Finds the other values of the joint that is searched, as rows behind the `count` that are known.
 * Returns how many rows there are then. */
DHGEN_FN int dhgen_search_fan(struct dhgen_search *s, double *found, int count)
{
    const struct dhgen_arm *const arm = s->arm;
    const struct dhgen_numerical_arm *const descents = arm->completion->descents;
    const double exact = dhgen_exactness(descents, s->T);
    double before, here = -HUGE_VAL, after = -HUGE_VAL, ahead;
    struct dhgen_descent d;
    dhgen_begin_descent(descents, s->T, s->free_joints, s->seed, &d);
    for (int k = -DHGEN_WHOLE_FAN; k <= DHGEN_WHOLE_FAN; k++) {
        before = here;
        here = after;
        after = dhgen_attempt(s, dhgen_fan_value(arm, s->joint, k + 1));
        if (k == 0 || before == 0.0 || !(here >= before && here > after))
            continue;
        double moved = dhgen_fan_value(arm, s->joint, k);
        if (here < 0.0)
            moved = dhgen_summit(
                s, dhgen_fan_value(arm, s->joint, k - 1), dhgen_fan_value(arm, s->joint, k + 1));
        dhgen_attempt(s, moved);
        if (isnan(moved) || !dhgen_works(s) || count == dhgen_rows(arm))
            continue;
        /* next to where the equation is degenerate its last digits are wrong */
        double *const values = found + dhgen_dof(arm) * count;
        dhgen_copy_row(arm, dhgen_found_row(s), values);
        count += dhgen_approach(&d, DHGEN_ROW_STEPS, exact, values, &ahead) <= exact;
    }
    return count;
}

/* Finds solutions with other values of a joint than a row has. `by` is how far the root of the row
 * is moved. Returns how many. */
DHGEN_FN int dhgen_other_values(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *values, double by, double *found)
{
    struct dhgen_search s;
    int count = 0;
    dhgen_start_search(&s, arm, T, free_joints, 0);
    s.by = by;
    for (int branch = 0; branch < dhgen_rows(arm) * arm->choosable_count; branch++) {
        s.joint = arm->choosable[branch % arm->choosable_count];
        s.row = branch / arm->choosable_count;
        s.start = values[s.joint];
        dhgen_copy_row(arm, values, s.seed);
        if (dhgen_is_alone(&s, values))
            count = dhgen_search_fan(&s, found, count);
    }
    return count;
}

/* Gives a solution a row, unless it has one: next to that of another solution, as their roots are
 * one where rows are the roots of a polynomial. */
DHGEN_FN void dhgen_join_row(const struct dhgen_arm *arm, const double *values, const double *other,
    int kind, double *q, unsigned char *status)
{
    const struct dhgen_numerical_arm *const descents = arm->completion->descents;
    const int dof = dhgen_dof(arm);
    int row = -1, place = -1;
    for (int k = 0; k < dhgen_rows(arm); k++) {
        if (status[k] == DHGEN_UNREACHABLE)
            place = place < row || row < 0 ? k : place;
        else if (dhgen_rows_apart(descents, values, q + dof * k) < DHGEN_TOGETHER)
            return;
        else if (dhgen_rows_apart(descents, other, q + dof * k) < DHGEN_TOGETHER)
            row = k;
    }
    if (place < 0)
        return;
    while (arm->completion->ascends && row >= 0 && place != row + 1 && place != row) {
        const int next = place > row ? place - 1 : place + 1;
        dhgen_copy_row(arm, q + dof * next, q + dof * place);
        status[place] = status[next];
        place = next;
    }
    dhgen_copy_row(arm, values, q + dof * place);
    status[place] = (unsigned char)kind;
}

/* Adds rows for the solutions with other values of a joint than `values`, of a root moved `by`. */
DHGEN_FN void dhgen_add_other_values(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *values, double by, int kind, double *q,
    unsigned char *status)
{
    double found[DHGEN_BRANCHES * DHGEN_JOINTS];
    const int count = dhgen_other_values(arm, T, free_joints, values, by, found);
    for (int k = 0; k < count; k++)
        dhgen_join_row(arm, found + dhgen_dof(arm) * k, values, kind, q, status);
}

/* Adds rows for the other values of joints that the solver chose freely. */
DHGEN_FN void dhgen_add_others(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, double *q, unsigned char *status)
{
    double rows[DHGEN_BRANCHES * DHGEN_JOINTS];
    unsigned char kind[DHGEN_BRANCHES];
    for (int row = 0; row < dhgen_rows(arm); row++)
        kind[row] = status[row];
    for (int i = 0; i < dhgen_dof(arm) * dhgen_rows(arm); i++)
        rows[i] = q[i];
    for (int row = 0; row < dhgen_rows(arm); row++)
        if (kind[row] == DHGEN_FREE_JOINT)
            dhgen_add_other_values(
                arm, T, free_joints, rows + dhgen_dof(arm) * row, 0.0, DHGEN_FREE_JOINT, q, status);
}

#endif

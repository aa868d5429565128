/* SPDX-License-Identifier: MIT
 *
 * Roots that nearly meet: a row of them may lie between two solutions that differ by anything in a
 * joint that is nearly free. Steps from it reach one; the root of the other is as far from it on
 * the other side. A row may have taken the seed's value for its root, which is one of the two and
 * hides the middle: the roots' own rows have a seed that is turned away. */
#ifndef DHGEN_NUMERICAL_SPLIT_CLOSE_ROOTS_H
#define DHGEN_NUMERICAL_SPLIT_CLOSE_ROOTS_H

#include "other_values.h"
#include "refine_rows.h"
#include "solutions.h"

/* How far a seed is turned so that no close root takes its value [rad]: beyond a right angle, where
 * the hidden root is, and no part of a turn, where others are at home poses. */
#define DHGEN_TURNED_AWAY 2.0
/* How far the root of a row is moved where steps from it reach no solution: to both sides by this
 * power of two [rad], then by less and less. */
#define DHGEN_FIRST_POWER 15
#define DHGEN_LAST_POWER 39
#define DHGEN_POWER_STEP 3
/* Where the other of two solutions is looked for, as parts of the way from their double root to
 * one; at none of it where the one came from the seed, and the other may be reached from the root
 * itself. */
DHGEN_TABLE double dhgen_across[5] = { 0.0, -1.0, -2.0, -0.5, -4.0 };

/* The rows of a pose while rows of close roots are split. */
struct dhgen_close_rows {
    const struct dhgen_arm *arm;
    struct dhgen_descent d;
    double exact, away[DHGEN_JOINTS]; /* what an exact row may miss; a seed that is turned away */
    double own[DHGEN_BRANCHES * DHGEN_JOINTS];           /* the rows of the roots themselves */
    double known[2 * DHGEN_BRANCHES][DHGEN_JOINTS];      /* solutions, first the other rows' */
    int count, others;                                   /* solutions; of them of the other rows */
    int doubtful[DHGEN_BRANCHES], found[DHGEN_BRANCHES]; /* rows; whether they have a solution */
    double end[DHGEN_BRANCHES][DHGEN_JOINTS];            /* the solution of a row */
    double off[DHGEN_BRANCHES];                          /* how far its root is from the row's */
};

/* Whether joint values are a solution after so many steps. Beside a singular place they may miss
 * the pose by next to nothing and be far from any. */
DHGEN_FN int dhgen_is_solution(struct dhgen_descent *d, int steps, double exact, double *q)
{
    double ahead;
    return dhgen_approach(d, steps, exact, q, &ahead) <= exact && ahead <= DHGEN_SURE;
}

/* Whether two solutions are one. Two that nearly meet are next to each other, too, but between them
 * the pose is missed. */
DHGEN_FN int dhgen_are_one(struct dhgen_close_rows *rows, const double *q, const double *other)
{
    const struct dhgen_numerical_arm *const arm = rows->d.arm;
    double u[2][DHGEN_JOINTS];
    if (dhgen_rows_apart(arm, q, other) >= DHGEN_TOGETHER)
        return 0;
    for (int j = 0; j < arm->solved; j++) {
        u[0][j] = q[arm->joint[j]] / arm->unit[j];
        u[1][j] = other[arm->joint[j]] / arm->unit[j];
    }
    return dhgen_is_same(&rows->d, u[0], u[1], 1);
}

/* Whether a solution is none of the first that are known. */
DHGEN_FN int dhgen_is_new(struct dhgen_close_rows *rows, int count, const double *q)
{
    for (int k = 0; k < count; k++)
        if (dhgen_are_one(rows, rows->known[k], q))
            return 0;
    return 1;
}

/* Puts a solution behind the known ones, unless it is one of them. */
DHGEN_FN void dhgen_add_known(struct dhgen_close_rows *rows, const double *q)
{
    if (dhgen_is_new(rows, rows->count, q))
        dhgen_copy_row(rows->arm, q, rows->known[rows->count++]);
}

/* Whether steps from the row of a moved root reach a solution, `end`, that no other row has. */
DHGEN_FN int dhgen_leads_elsewhere(
    struct dhgen_close_rows *rows, double angle, int row, double *end)
{
    const struct dhgen_arm *const arm = rows->arm;
    double q[DHGEN_BRANCHES * DHGEN_JOINTS];
    unsigned char kind[DHGEN_BRANCHES];
    for (int k = 0; k < dhgen_rows(arm); k++)
        kind[k] = DHGEN_UNREACHABLE;
    arm->solve(rows->d.T, rows->d.free_joints, rows->away, angle, q, kind);
    if (kind[row] == DHGEN_UNREACHABLE || kind[row] > DHGEN_CLOSE /* lost */)
        return 0;
    dhgen_copy_row(arm, q + dhgen_dof(arm) * row, end);
    return dhgen_is_solution(&rows->d, DHGEN_ROW_STEPS, rows->exact, end)
        && dhgen_is_new(rows, rows->others, end);
}

/* Finds which rows of close roots are no solutions, and what the others are. Returns whether there
 * are such rows. */
DHGEN_FN int dhgen_find_doubtful(
    struct dhgen_close_rows *rows, const double *q, unsigned char *status)
{
    const struct dhgen_arm *const arm = rows->arm;
    const int dof = dhgen_dof(arm);
    unsigned char kind[DHGEN_BRANCHES];
    int any = 0;
    for (int row = 0; row < dhgen_rows(arm); row++)
        kind[row] = DHGEN_UNREACHABLE;
    arm->solve(rows->d.T, rows->d.free_joints, rows->away, 0.0, rows->own, kind);
    rows->count = 0;
    for (int row = 0; row < dhgen_rows(arm); row++) {
        const int close = status[row] == DHGEN_CLOSE;
        double here[DHGEN_JOINTS];
        if (kind[row] == DHGEN_UNREACHABLE || kind[row] > DHGEN_CLOSE /* lost */)
            dhgen_copy_row(arm, q + dof * row, rows->own + dof * row);
        dhgen_copy_row(arm, rows->own + dof * row, here);
        rows->found[row] = 0;
        rows->doubtful[row] = close && !dhgen_is_solution(&rows->d, 0, rows->exact, here);
        if (close)
            status[row] = DHGEN_OK;
        any += rows->doubtful[row];
        if (status[row] != DHGEN_UNREACHABLE && !rows->doubtful[row])
            dhgen_copy_row(arm, q + dof * row, rows->known[rows->count++]);
    }
    rows->others = rows->count;
    return any;
}

/* Finds a solution from a row: from itself, or from where its root is moved. Long steps may reach
 * solutions of other roots, which are known. */
DHGEN_FN int dhgen_find_first(struct dhgen_close_rows *rows, int row, double *end)
{
    int found = dhgen_is_solution(&rows->d, DHGEN_ROW_STEPS, rows->exact, end)
        && dhgen_is_new(rows, rows->others, end);
    for (int power = DHGEN_FIRST_POWER; power <= DHGEN_LAST_POWER; power += DHGEN_POWER_STEP)
        for (int side = 1; side >= -1 && !found; side -= 2)
            found = dhgen_leads_elsewhere(rows, ldexp((double)side, -power), row, end);
    return found;
}

/* Splits a row: finds the solutions to both sides of it, and ends the row if there is one. */
DHGEN_FN void dhgen_split_row(
    struct dhgen_close_rows *rows, int row, const double *q, unsigned char *status)
{
    const struct dhgen_arm *const arm = rows->arm;
    const struct dhgen_completion *const of = arm->completion;
    const double *const own = rows->own + dhgen_dof(arm) * row;
    double *const end = rows->end[row], other[DHGEN_JOINTS], off = 0.0;
    dhgen_copy_row(arm, q + dhgen_dof(arm) * row, end);
    rows->found[row] = dhgen_find_first(rows, row, end);
    if (!rows->found[row])
        return;
    status[row] = DHGEN_UNREACHABLE;
    dhgen_add_known(rows, end);
    for (int k = 0; k < of->turn_count; k++)
        off += of->turns[k].sign * (end[of->turns[k].joint] - own[of->turns[k].joint]);
    rows->off[row] = off = dhgen_wrap(off);
    for (int k = 0; k < 5; k++) {
        if (!dhgen_leads_elsewhere(rows, dhgen_across[k] * off, row, other)
            || dhgen_are_one(rows, end, other))
            continue;
        dhgen_add_known(rows, other);
        break;
    }
}

/* Puts the solutions that were found into the empty rows, each into that which was nearest. */
DHGEN_FN void dhgen_place_solutions(
    const struct dhgen_close_rows *rows, double *q, unsigned char *status)
{
    const struct dhgen_arm *const arm = rows->arm;
    const int dof = dhgen_dof(arm);
    for (int k = rows->others; k < rows->count; k++) {
        int place = -1;
        double least = HUGE_VAL;
        for (int row = dhgen_rows(arm) - 1; row >= 0; row--) {
            const double *const values = q + dof * row;
            const double gap =
                isnan(values[0]) ? HUGE_VAL : dhgen_rows_apart(rows->d.arm, values, rows->known[k]);
            if (status[row] == DHGEN_UNREACHABLE && gap <= least) {
                least = gap;
                place = row;
            }
        }
        if (place < 0)
            return;
        dhgen_copy_row(arm, rows->known[k], q + dof * place);
        status[place] = DHGEN_OK;
    }
}

/* Splits the rows of close roots into the solutions that they lie between. */
DHGEN_FN void dhgen_split_close_roots(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, double *q, unsigned char *status)
{
    const struct dhgen_completion *const of = arm->completion;
    struct dhgen_close_rows rows;
    int any = 0;
    for (int row = 0; row < dhgen_rows(arm); row++)
        any |= status[row] == DHGEN_CLOSE;
    if (!any)
        return;
    rows.arm = arm;
    rows.exact = dhgen_exactness(of->descents, T);
    dhgen_begin_descent(of->descents, T, free_joints, seed, &rows.d);
    dhgen_copy_row(arm, seed, rows.away);
    rows.away[of->turns[0].joint] += DHGEN_TURNED_AWAY;
    if (!dhgen_find_doubtful(&rows, q, status))
        return;
    for (int row = 0; row < dhgen_rows(arm); row++)
        if (rows.doubtful[row])
            dhgen_split_row(&rows, row, q, status);
    dhgen_place_solutions(&rows, q, status);
    for (int row = 0; row < dhgen_rows(arm) && of->adds_others; row++)
        if (rows.found[row])
            dhgen_add_other_values(
                arm, T, free_joints, rows.end[row], rows.off[row], DHGEN_OK, q, status);
    for (int row = 0; row < dhgen_rows(arm); row++)
        if (status[row] == DHGEN_UNREACHABLE)
            dhgen_empty_row(arm, q + dhgen_dof(arm) * row, status + row);
}

#endif

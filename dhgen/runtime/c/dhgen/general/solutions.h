/* SPDX-License-Identifier: MIT
 *
 * The solutions that are found, and how candidates join them. */
#ifndef DHGEN_GENERAL_SOLUTIONS_H
#define DHGEN_GENERAL_SOLUTIONS_H

#include "refine.h"

/* Newton steps for a candidate; two are enough unless a root is nearly double. */
#define DHGEN_LOOP_STEPS 4
/* Solutions closer than this are one [rad, arm sizes]. */
#define DHGEN_SAME_SOLUTION 1e-06
/* The smallest pivot of the Jacobian over the largest: where it is below this the arm is singular,
 * to the accuracy to which a double root is known. */
#define DHGEN_SINGULAR_PIVOT 1e-06
/* Below this it is nearly singular: copies of a singular solution, as far away from it as a miss of
 * 1e-10 leaves them, are no less so. */
#define DHGEN_NEARLY_SINGULAR_PIVOT 0.0001
/* The tolerance `refined`: by how much the loop of a solution may be open [rad, arm sizes]. */
#define DHGEN_LOOP_RESIDUAL 1e-10
/* Beyond this an angle below zero is half a turn that was rounded [rad]. */
#define DHGEN_ALMOST_PI 3.141592653589783

/* A bit for each solution. */
typedef unsigned long long dhgen_solution_set;

/* The solutions found so far. Where one is singular many candidates come near to it: there is room
 * for more than there are solutions, the last of it for regular ones. */
typedef struct {
    int count;
    dhgen_solution_set singular, nearly_singular; /* where the arm is */
    int doubles;                                  /* roots that met, or may have */
    double q[DHGEN_PLACES][6], residual[DHGEN_PLACES];
} dhgen_found;

/* Nothing has been found. */
DHGEN_FN void dhgen_forget(dhgen_found *found)
{
    found->count = 0;
    found->singular = found->nearly_singular = 0;
    found->doubles = 0;
}

/* Whether two joint vectors differ by less than that, modulo turns. */
DHGEN_FN int dhgen_is_close(
    const dhgen_general_arm *arm, const double a[6], const double b[6], double most)
{
    for (int j = 0; j < 6; j++) {
        const double gap = fabs(a[j] - b[j]);
        if (dhgen_is_slide(arm, j) ? gap < most : gap < most || DHGEN_TURN - gap < most) {
            continue;
        }
        return 0;
    }
    return 1;
}

/* Adds a solution unless it is known or none, and marks it where the arm is singular, or nearly;
 * returns its place, or -1. */
DHGEN_FN int dhgen_keep_solution(const dhgen_general_arm *arm, dhgen_found *found, double theta[6],
    double residual, double pivot)
{
    const int singular = pivot < DHGEN_SINGULAR_PIVOT, nearly = pivot < DHGEN_NEARLY_SINGULAR_PIVOT;
    const int room = nearly ? DHGEN_PLACES - arm->most : DHGEN_PLACES;
    if (!(residual <= DHGEN_LOOP_RESIDUAL)) {
        return -1;
    }
    for (int i = 0; i < found->count; i++) {
        if (dhgen_is_close(arm, found->q[i], theta, DHGEN_SAME_SOLUTION)) {
            if (residual < found->residual[i]) {
                found->residual[i] = residual;
                for (int j = 0; j < 6; j++) {
                    found->q[i][j] = theta[j];
                }
            }
            found->singular |= (dhgen_solution_set)singular << i;
            found->nearly_singular |= (dhgen_solution_set)nearly << i;
            return i;
        }
    }
    if (found->count >= room) {
        return -1;
    }
    found->singular |= (dhgen_solution_set)singular << found->count;
    found->nearly_singular |= (dhgen_solution_set)nearly << found->count;
    found->residual[found->count] = residual;
    for (int j = 0; j < 6; j++) {
        found->q[found->count][j] = theta[j];
    }
    return found->count++;
}

/* Keeps the solutions among candidates, given by cosines and sines; returns which these are.
 * `place` takes which solution each candidate became, or -1. */
DHGEN_FN dhgen_solution_set dhgen_keep_lanes(const dhgen_loop *loop, const dhgen_lane c[6],
    const dhgen_lane s[6], int count, dhgen_lane residuals, dhgen_lane pivots, dhgen_found *found,
    int place[DHGEN_GENERAL_LANES])
{
    DHGEN_LANES_IN_ROOM(residual, DHGEN_BOARD(0));
    DHGEN_LANES_IN_ROOM(pivot, DHGEN_BOARD(1));
    DHGEN_ROWS_IN_ROOM(theta, 6, DHGEN_BOARD(2));
    dhgen_solution_set met = 0;
    DHGEN_STORE(residual, residuals);
    DHGEN_STORE(pivot, pivots);
    for (int i = 0; i < 6; i++) {
        const double cosine = loop->arm->advance[0][i], sine = loop->arm->advance[1][i];
        if (dhgen_is_slide(loop->arm, i)) {
            DHGEN_STORE(theta[i], s[i]);
            continue;
        }
        DHGEN_STORE(
            theta[i], dhgen_lane_angle(s[i] * cosine + c[i] * sine, c[i] * cosine - s[i] * sine));
    }
    for (int k = 0; k < count; k++) {
        double row[6];
        for (int i = 0; i < 6; i++) {
            /* half a turn is +pi, whatever rounding makes of it */
            row[i] = theta[i][k] < -DHGEN_ALMOST_PI && !dhgen_is_slide(loop->arm, i)
                ? DHGEN_HALF_TURN
                : theta[i][k];
        }
        place[k] = dhgen_keep_solution(loop->arm, found, row, residual[k], pivot[k]);
        if (place[k] >= 0) {
            met |= (dhgen_solution_set)1 << place[k];
        }
    }
    return met;
}

/* Refines candidates, given by cosines and sines, and keeps the solutions that come of them;
 * returns which these are. `place` takes which solution each candidate became, or -1. Of `doubtful`
 * candidates singular solutions are marked. */
DHGEN_FN dhgen_solution_set dhgen_refine_and_keep(const dhgen_loop *loop, dhgen_lane c[6],
    dhgen_lane s[6], int count, int steps, int doubtful, dhgen_found *found,
    int place[DHGEN_GENERAL_LANES])
{
    const dhgen_lane residual = dhgen_refine_lanes(loop, c, s, steps, steps > DHGEN_LOOP_STEPS);
    dhgen_lane pivot = dhgen_lane_all(1.0);
    if (doubtful) {
        dhgen_lane J[6][7], x[6];
        (void)dhgen_loop_error(loop, c, s, J);
        pivot = dhgen_newton_step(J, x);
    }
    return dhgen_keep_lanes(loop, c, s, count, residual, pivot, found, place);
}

/* How many bits are set. */
DHGEN_FN int dhgen_count_bits(dhgen_solution_set set)
{
    int count = 0;
    for (; set; set &= set - 1) {
        count++;
    }
    return count;
}

/* Whether the number of regular solutions is even. */
DHGEN_FN int dhgen_is_paired(const dhgen_found *found)
{
    return (found->count - dhgen_count_bits(found->singular)) % 2 == 0;
}

/* The links L0 ... L5 of a formulation. */
DHGEN_FN void dhgen_formulation_links(
    const dhgen_formulation *form, const dhgen_loop *loop, double link[6][12])
{
    for (int i = 0; i < 6; i++) {
        const int joint = form->joint[i];
        if (form->sign > 0.0 && joint < 5) {
            dhgen_copy_link(loop->link[joint], link[i]);
        } else if (form->sign > 0.0) {
            dhgen_invert(loop->link[5], link[i]);
        } else if (joint > 0) {
            dhgen_invert(loop->link[joint - 1], link[i]);
        } else {
            dhgen_copy_link(loop->link[5], link[i]);
        }
    }
}

#endif

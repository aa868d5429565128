/* SPDX-License-Identifier: MIT
 *
 * Damped least-squares steps that take joint values to a solution next to them. */
#ifndef DHGEN_REFINE_H
#define DHGEN_REFINE_H

#include "arm.h"
#include "least_squares.h"
#include "limits.h"
#include "tolerances.h"

/* Where two things are singular the Jacobian has rows as small as the joints are near. Damped by
 * the square of the miss a step is then longer than the way; damped by the miss it is not, and
 * gains where roots meet, because the miss is as small as the square of such rows. */
#define DHGEN_CAUTIOUS 0.003
#define DHGEN_DAMPING 0.1
/* Steps: what is right ends after two or three, where roots meet after twelve. */
#define DHGEN_STEPS 20
/* A step is in vain if it leaves more of the miss; where n roots meet (1 - 1/n)^n is left. Near
 * places where two things are singular some make it worse before it gets better: after so many it
 * fails. */
#define DHGEN_SLOW 0.7
#define DHGEN_IN_VAIN 4
/* Nearer than so many times what is enough rounding decides what a step leaves. */
#define DHGEN_NEAR_ENOUGH 100.0
/* Two joints that are past the ends of their ranges can be refined inside, though perhaps not onto
 * the ends: they are put inside as far as they are past, times this, then twice as far, up to
 * that. */
#define DHGEN_NEXT_INSIDE 2.0
#define DHGEN_FARTHEST_INSIDE 16.0

/* How far joint values are from others, whole turns aside [rad, arm sizes]; `half` is the middle.
 */
DHGEN_FN double dhgen_half_way(
    const struct dhgen_arm *arm, const double *x, const double *q, double *half)
{
    double most = 0.0;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        double off = q[i] - x[i];
        off -= arm->joints[i].revolute ? DHGEN_TURN * floor(off / DHGEN_TURN + 0.5) : 0.0;
        most = fmax(most, fabs(off) * sqrt(arm->joints[i].weight));
        half[i] = x[i] + 0.5 * off;
    }
    return most;
}

/* What is missed of yaw, pitch or tilt, as turns about the base's axes, into e. Returns its square.
 * A pose without a yaw misses none. */
DHGEN_FN double dhgen_miss_of_angles(
    const struct dhgen_arm *arm, const double *T, const double *P, double *e)
{
    double square = 0.0;
    if (arm->task == DHGEN_YAW) {
        const double level = T[0] * T[0] + T[4] * T[4];
        e[5] = P[0] * T[4] - P[4] * T[0];
        return level * ((P[0] - T[0]) * (P[0] - T[0]) + (P[4] - T[4]) * (P[4] - T[4]));
    }
    if (arm->task == DHGEN_PITCH) {
        e[3] = T[8] - P[8];
        return e[3] * e[3];
    }
    for (int i = 0; i < 3; i++) {
        e[3] += T[8 + i] * P[4 + i];
        e[4] -= T[8 + i] * P[i];
        square += (P[8 + i] - T[8 + i]) * (P[8 + i] - T[8 + i]);
    }
    return square;
}

/* By how much joint values miss a pose, into e, whose angles are 0 half a turn away, too. Returns
 * the length of the miss, which differs between the two [arm sizes, rad]. */
DHGEN_FN double dhgen_miss(const struct dhgen_arm *arm, const double *T, const double *x, double *e)
{
    const double *const weights = arm->miss_weights;
    double P[16], square = 0.0;
    DHGEN_FORWARD(arm, x, P);
    for (int i = 0; i < 3; i++) {
        e[i] = weights[i] > 0.0 ? weights[i] * (T[4 * i + 3] - P[4 * i + 3]) : 0.0;
        e[3 + i] = 0.0;
        square += e[i] * e[i];
    }
    if (arm->task == DHGEN_POINTING) {
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3 * 4 + 2, k = (i + 2) % 3 * 4 + 2;
            e[3 + i] = P[j] * T[k] - P[k] * T[j];
            square += (P[j] - T[j]) * (P[j] - T[j]);
        }
    } else if (arm->task > DHGEN_POSE) {
        square += dhgen_miss_of_angles(arm, T, P, e);
    } else if (arm->task != DHGEN_COORDINATES) {
        for (int i = 0; i < 9; i++) {
            const int j = (i / 3 + 1) % 3 * 4 + i % 3, k = (i / 3 + 2) % 3 * 4 + i % 3;
            e[3 + i / 3] += 0.5 * (P[j] * T[k] - P[k] * T[j]);
            square += 0.5 * (P[j] - T[j]) * (P[j] - T[j]);
        }
    }
    return sqrt(square);
}

/* Takes out of `width` columns J at joint values x, spins below, what changes no direction that
 * counts. Of a pitch its rate comes first; else turns that don't count about the base's axes have
 * no weight. */
DHGEN_FN void dhgen_count_what_counts(
    const struct dhgen_arm *arm, const double *x, int width, double *J)
{
    double P[16];
    if (arm->task != DHGEN_POINTING && arm->task != DHGEN_PITCH)
        return;
    DHGEN_FORWARD(arm, x, P);
    for (int j = 0; j < width; j++) {
        double *spin = J + 3 * width + j;
        if (arm->task == DHGEN_PITCH) {
            spin[0] = spin[0] * P[4] - spin[width] * P[0];
            continue;
        }
        const double along = P[2] * spin[0] + P[6] * spin[width] + P[10] * spin[2 * width];
        for (int i = 0; i < 3; i++)
            spin[width * i] -= along * P[4 * i + 2];
    }
}

/* Adds the damped least-squares step for the miss e to joint values of which some are held. */
DHGEN_FN void dhgen_add_step(
    const struct dhgen_arm *arm, const int *held, double damping, const double *e, double *x)
{
    const int dof = dhgen_dof(arm);
    double J[6 * DHGEN_JOINTS], step[DHGEN_JOINTS];
    DHGEN_RATES(arm, x, J);
    dhgen_count_what_counts(arm, x, dof, J);
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < dof; j++)
            J[dof * i + j] *= held[j] ? 0.0 : arm->joints[j].pace * arm->miss_weights[i];
    dhgen_least_squares(6, dof, J, dof, damping + DHGEN_FINE, e, step);
    for (int j = 0; j < dof; j++)
        x[j] += step[j] * arm->joints[j].pace;
}

/* Where the joint that is farthest past an end of its range is, or -1; `past` is how far. */
DHGEN_FN int dhgen_farthest_past(const struct dhgen_arm *arm, const double *x, double *past)
{
    int worst = -1;
    *past = 0.0;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        const double off = dhgen_moves(arm, i) ? dhgen_past_an_end(arm, i, x[i]) : 0.0;
        if (fabs(off) > fabs(*past)) {
            worst = i;
            *past = off;
        }
    }
    return worst;
}

/* Takes joint values to some not farther than `most` that miss the pose by less than `enough`; if
 * that is negative, to some inside their limits that miss it by less than so much more. Returns
 * whether it can. Goes on while that gains, first by short steps. */
DHGEN_FN int dhgen_refine(
    const struct dhgen_arm *arm, const double *T, double enough, double most, double *q)
{
    double x[DHGEN_JOINTS], half[DHGEN_JOINTS], e[6], last = HUGE_VAL;
    const int clamps = enough <= 0.0;
    int moves = 0, refined = 0, lost = 0, held[DHGEN_JOINTS] = { 0 };
    dhgen_copy_row(arm, q, x);
    for (int k = 0; k < DHGEN_STEPS; k++) {
        double miss = dhgen_miss(arm, T, x, e), past = 0.0;
        if (clamps && k == 0)
            enough = miss - enough;
        const int worst = clamps && miss < enough ? dhgen_farthest_past(arm, x, &past) : -1;
        if (worst >= 0) { /* one by one: others may follow it inside, or the first the second */
            moves++;
            for (int i = 0; i < dhgen_dof(arm); i++)
                held[i] = i == worst || (held[i] && moves != 2);
            last = HUGE_VAL;
            x[worst] -= past;
            miss = dhgen_miss(arm, T, x, e);
        }
        if (miss < enough) {
            dhgen_copy_row(arm, x, q);
            refined = 1;
            enough = 0.5 * miss;
        } else if (refined
            || (miss > fmax(DHGEN_SLOW * last, DHGEN_NEAR_ENOUGH * enough)
                && ++lost == DHGEN_IN_VAIN)) {
            break;
        }
        last = miss;
        const int cautious = lost == 0 && miss > DHGEN_NEAR_ENOUGH * enough;
        dhgen_add_step(arm, held, (cautious ? DHGEN_CAUTIOUS : DHGEN_DAMPING * miss) * miss, e, x);
        if (!(dhgen_half_way(arm, x, q, half) <= most))
            break; /* another solution */
    }
    return refined;
}

/* Clamps joint values to the ends of ranges that they are past or, as two may not be there at once,
 * takes them inside; the pose is missed by less than `more` more than before. Returns whether it
 * can. */
DHGEN_FN int dhgen_refine_inside(
    const struct dhgen_arm *arm, const double *T, double more, double most, double *q)
{
    double x[DHGEN_JOINTS], e[6];
    if (dhgen_refine(arm, T, -more, most, q))
        return 1;
    if (!arm->range_exceeds_a_turn)
        return 0;
    int past = 0;
    for (int i = 0; i < dhgen_dof(arm); i++)
        past += dhgen_moves(arm, i) && fabs(dhgen_past_an_end(arm, i, q[i])) > 0.0;
    const double enough = dhgen_miss(arm, T, q, e) + more;
    double farther = DHGEN_NEXT_INSIDE;
    while (past > 1 && farther <= DHGEN_FARTHEST_INSIDE) {
        for (int i = 0; i < dhgen_dof(arm); i++)
            x[i] = q[i] - (dhgen_moves(arm, i) ? farther : 0.0) * dhgen_past_an_end(arm, i, q[i]);
        if (dhgen_refine(arm, T, enough, most, x) && !(dhgen_past_ends(arm, x) > 0.0)) {
            dhgen_copy_row(arm, x, q);
            return 1;
        }
        farther *= 2.0;
    }
    return 0;
}

#endif

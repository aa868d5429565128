/* SPDX-License-Identifier: MIT
 *
 * Rows of joint values from what the general algorithm finds, and else from descents. */
#ifndef DHGEN_GENERAL_ROWS_H
#define DHGEN_GENERAL_ROWS_H

#include "../general.h"
#include "../numerical/pairs.h"
#include "search.h"

/* Descents besides what the algorithm found, where that is not certainly everything. */
#define DHGEN_FEW_STARTS 12
#if DHGEN_AHEAD < DHGEN_PLACES + DHGEN_FEW_STARTS
#error "what both offer has to have room ahead"
#endif
/* Bounds of the turn that the arm does not have [rad]: above the first it can't take the pose;
 * above the second, where the certificate fails; below the third the turn is zero, and the solution
 * needs no descent. */
#define DHGEN_NEARLY_NONE 0.01
#define DHGEN_NEARLY_NONE_IN_DOUBT 0.1
#define DHGEN_NO_TURN 1e-12

/* Adds a solution that is exact and unlike all others: it needs no descent. */
DHGEN_FN void dhgen_keep_regular(
    const struct dhgen_numerical_arm *arm, struct dhgen_kept *kept, double *u)
{
    dhgen_wrap_units(arm, u);
    kept->singular[kept->count] = kept->chosen[kept->count] = 0;
    dhgen_copy_units(arm, u, kept->u[kept->count++]);
}

/* A pose with the z axis of T: any turn about the tool's axis works (T. Duff et al., 2017: an
 * orthonormal basis of z). */
DHGEN_FN void dhgen_choose_spin(const double *T, double *whole)
{
    const double side = copysign(1.0, T[10]), a = -1.0 / (side + T[10]), b = T[2] * T[6] * a;
    const double entries[16] = {
        1.0 + side * T[2] * T[2] * a, b, T[2], T[3],  /**/
        side * b, side + T[6] * T[6] * a, T[6], T[7], /**/
        -side * T[2], -T[6], T[10], T[11],            /**/
        0.0, 0.0, 0.0, 1.0                            /**/
    };
    for (int i = 0; i < 16; i++)
        whole[i] = entries[i];
}

/* A solution of the loop as joint values in units. */
DHGEN_FN void dhgen_from_loop(const struct dhgen_descent *d, const double *angles, double *u)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    if (arm->drives)
        dhgen_to_drives(arm, d->q, angles, u);
    for (int j = 0; j < arm->solved && !arm->drives; j++)
        u[j] = arm->facing[j] * (angles[j] - arm->zero[j]) / arm->unit[j];
}

/* Adds the joint values where a descent ends to the solutions ahead, unless they miss the pose by
 * more than `enough`. */
DHGEN_FN void dhgen_look_ahead(
    struct dhgen_descent *d, struct dhgen_ahead *ahead, const double *u, double enough)
{
    double *const end = ahead->u[ahead->count];
    dhgen_copy_units(d->arm, u, end);
    if (dhgen_descend(d, end) <= enough)
        ahead->passed[ahead->count++] = 0;
}

/* Adds what descents from these starts find to the solutions ahead; start 0 is the seed. */
DHGEN_FN void dhgen_look_from_starts(
    struct dhgen_descent *d, struct dhgen_ahead *ahead, int first, int end)
{
    double u[DHGEN_JOINTS];
    for (int k = first; k < end; k++) {
        dhgen_start(d, k, u);
        dhgen_look_ahead(d, ahead, u, d->arm->residual);
    }
}

/* Keeps the solutions of a loop with a turn that the arm does not have, and that has to be zero:
 * those that are exact without it at once; those that are nearly without it come ahead. */
DHGEN_FN void dhgen_keep_without_turn(
    struct dhgen_descent *d, struct dhgen_kept *kept, double (*angles)[6], int many, int certain)
{
    const struct dhgen_numerical_arm *const arm = d->arm;
    const double nearly_none = certain ? DHGEN_NEARLY_NONE : DHGEN_NEARLY_NONE_IN_DOUBT;
    double u[DHGEN_JOINTS];
    for (int k = 0; k < many; k++) {
        int exact = certain;
        for (int j = arm->solved; j < 6; j++)
            exact &= fabs(angles[k][j]) <= DHGEN_NO_TURN;
        dhgen_from_loop(d, angles[k], u);
        if (exact)
            dhgen_keep_regular(arm, kept, u);
        else if (fabs(angles[k][arm->solved]) < nearly_none)
            dhgen_look_ahead(d, kept->ahead, u, arm->residual);
    }
}

/* Keeps solutions that are exact and unlike one another, of drives that move their own joints
 * alone: they need no descent. A joint's values come together: what is known of the joint is read
 * once. The unit of angles is one. */
DHGEN_INLINE void dhgen_keep_exact(
    const struct dhgen_numerical_arm *arm, struct dhgen_kept *kept, double (*angles)[6], int many)
{
    for (int j = 0; j < arm->solved; j++) {
        const double facing = arm->facing[j], zero = arm->zero[j], unit = arm->unit[j];
        for (int k = 0; k < many; k++) {
            const double value = facing * (angles[k][j] - zero);
            kept->u[k][j] = arm->turning[j] ? dhgen_wrap(value) : value / unit;
        }
    }
    for (int k = 0; k < many; k++)
        kept->singular[k] = kept->chosen[k] = 0;
    kept->count = many;
}

/* Keeps the solutions of a loop: at once where they are certainly all, or else they come ahead,
 * since where solutions meet the exact ones differ. */
DHGEN_FN void dhgen_keep_loop(
    struct dhgen_descent *d, struct dhgen_kept *kept, double (*angles)[6], int many, int certain)
{
    double u[DHGEN_JOINTS];
    if (certain && !d->arm->drives) {
        dhgen_keep_exact(d->arm, kept, angles, many);
        return;
    }
    for (int k = 0; k < many; k++) {
        dhgen_from_loop(d, angles[k], u);
        if (certain)
            dhgen_keep_regular(d->arm, kept, u);
        else
            dhgen_look_ahead(d, kept->ahead, u, HUGE_VAL);
    }
}

DHGEN_API void dhgen_general_rows(const dhgen_general_arm *general,
    const struct dhgen_numerical_arm *arm, const double *T, const double *free_joints,
    const double *seed, double *q, unsigned char *status)
{
    struct dhgen_descent d;
    struct dhgen_kept kept;
    struct dhgen_ahead ahead;
    double angles[DHGEN_PLACES][6], residual[DHGEN_PLACES], whole[16];
    dhgen_begin_descent(arm, T, free_joints, seed, &d);
    kept.count = ahead.count = 0;
    kept.ahead = &ahead;
    if (arm->directions == DHGEN_POINTING)
        dhgen_choose_spin(T, whole);
    const int count = dhgen_general_solutions(
        general, arm->directions == DHGEN_POINTING ? whole : T, free_joints, angles, residual);
    const int many = count < 0 ? -1 - count : count;
    int certain = count >= 0;
    if (!certain)
        dhgen_look_from_starts(&d, &ahead, 0, 1);
    if (arm->checked)
        dhgen_keep_without_turn(&d, &kept, angles, many, certain);
    else
        dhgen_keep_loop(&d, &kept, angles, many, certain);
    if (!certain)
        dhgen_look_from_starts(&d, &ahead, 1, DHGEN_FEW_STARTS);
    dhgen_keep_ahead(&d, &kept);
    if (certain && arm->checked && !kept.count) {
        certain = 0;
        dhgen_look_from_starts(&d, &ahead, 0, DHGEN_FEW_STARTS);
        dhgen_keep_ahead(&d, &kept);
    }
    if (!certain)
        dhgen_complete_pairs(&d, &kept);
    dhgen_sort_rows(&d, &kept, q, status);
}

#endif

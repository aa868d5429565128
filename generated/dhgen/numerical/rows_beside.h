/* SPDX-License-Identifier: MIT
 *
 * Finds the rows of rounded poses by the rows of poses close to them. Where one square root is
 * nested in another, or two roots of a polynomial meet, rounding may take a radicand below zero,
 * though the whole pose fixes the joints well. A little to one side of the pose it is above zero,
 * and from there least squares find the row. */
#ifndef DHGEN_NUMERICAL_ROWS_BESIDE_H
#define DHGEN_NUMERICAL_ROWS_BESIDE_H

#include "../arm.h"
#include "../retry.h"
#include "refine_rows.h"

/* How far aside [arm sizes, rad]: some times what a pose may be rounded by, and less than what the
 * formulas let rows miss that least squares refine. */
#define DHGEN_BESIDE_STEPS 3
#define DHGEN_FIRST_BESIDE 1e-5
#define DHGEN_FARTHER_BESIDE 10.0

/* Moves a pose along an axis of the base, or turns it about one: `direction` is 0 ... 5. */
DHGEN_FN void dhgen_move_aside(const double *T, int direction, double by, double size, double *to)
{
    for (int k = 0; k < 16; k++)
        to[k] = T[k];
    if (direction < 3) {
        to[4 * direction + 3] += by * size;
        return;
    }
    const int j = (direction + 1) % 3, k = (direction + 2) % 3;
    for (int c = 0; c < 3; c++) {
        to[4 * j + c] -= by * T[4 * k + c];
        to[4 * k + c] += by * T[4 * j + c];
    }
}

/* Whether no row has these joint values. */
DHGEN_FN int dhgen_has_no_row(
    const struct dhgen_arm *arm, const double *q, const unsigned char *status, const double *values)
{
    for (int k = 0; k < dhgen_rows(arm); k++)
        if (status[k] != DHGEN_UNREACHABLE
            && dhgen_rows_apart(arm->completion->descents, q + dhgen_dof(arm) * k, values)
                < DHGEN_SAME_UNITS)
            return 0;
    return 1;
}

/* Adds rows of poses beside one that may be rounded, unless it has an exact row. */
DHGEN_FN void dhgen_add_rows_beside(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, double *q, unsigned char *status)
{
    const struct dhgen_numerical_arm *const descents = arm->completion->descents;
    const int dof = dhgen_dof(arm);
    const double exact = dhgen_exactness(descents, T);
    double aside[16], rows[DHGEN_BRANCHES * DHGEN_JOINTS], by = DHGEN_FIRST_BESIDE;
    unsigned char kinds[DHGEN_BRANCHES];
    for (int row = 0; row < dhgen_rows(arm); row++)
        if (status[row] != DHGEN_UNREACHABLE && dhgen_missed_by(arm, T, q + dof * row) <= exact)
            return;
    for (int n = 0; n < 12 * DHGEN_BESIDE_STEPS; n++) {
        if (n > 0 && n % 12 == 0)
            by *= DHGEN_FARTHER_BESIDE;
        for (int row = 0; row < dhgen_rows(arm); row++)
            dhgen_empty_row(arm, rows + dof * row, kinds + row);
        dhgen_move_aside(T, n / 2 % 6, n % 2 ? -by : by, descents->size, aside);
        arm->solve(aside, free_joints, seed, 0.0, rows, kinds);
        for (int row = 0; row < dhgen_rows(arm); row++)
            if (kinds[row] >= DHGEN_LOST)
                dhgen_empty_row(arm, rows + dof * row, kinds + row);
        (void)dhgen_refine_rows(arm, T, free_joints, seed, rows, kinds);
        for (int row = 0; row < dhgen_rows(arm); row++) {
            const int empty = kinds[row] != DHGEN_UNREACHABLE && status[row] == DHGEN_UNREACHABLE;
            if (empty && dhgen_has_no_row(arm, q, status, rows + dof * row)) {
                dhgen_copy_row(arm, rows + dof * row, q + dof * row);
                status[row] = kinds[row];
            }
        }
    }
}

#endif

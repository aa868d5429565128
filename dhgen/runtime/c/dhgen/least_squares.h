/* SPDX-License-Identifier: MIT
 *
 * Damped least squares: of a few equations that may have no solution, or many. */
#ifndef DHGEN_LEAST_SQUARES_H
#define DHGEN_LEAST_SQUARES_H

#include "arm.h"

/* Equations, at most. */
#define DHGEN_MOST_EQUATIONS 7
/* Sums of products are four, which compilers work out at once; rows are as long as whole fours, and
 * zero from where they end. */
#define DHGEN_AT_ONCE 4
#define DHGEN_LONGEST_ROW \
    ((DHGEN_MOST_EQUATIONS + DHGEN_JOINTS + DHGEN_AT_ONCE - 1) / DHGEN_AT_ONCE * DHGEN_AT_ONCE)

/* The inner product of two rows. */
DHGEN_INLINE double dhgen_product_of_rows(int width, const double *a, const double *b)
{
    double sum[DHGEN_AT_ONCE] = { 0.0 };
    for (int j = 0; j < width; j += DHGEN_AT_ONCE)
        for (int k = 0; k < DHGEN_AT_ONCE; k++)
            sum[k] += a[j + k] * b[j + k];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/* Adds a multiple of a row to another one. */
DHGEN_INLINE void dhgen_add_to_row(int width, double factor, const double *a, double *to)
{
    for (int j = 0; j < width; j += DHGEN_AT_ONCE)
        for (int k = 0; k < DHGEN_AT_ONCE; k++)
            to[j + k] += factor * a[j + k];
}

/* x = A' (A A' + damping)^-1 y, the rows of A `stride` numbers apart. These, each with its share of
 * the damping's root behind it, are made orthonormal one after another (modified Gram-Schmidt; used
 * as by A. Bjorck, Numerics of Gram-Schmidt orthogonalization, 1994): A A' would lose half of the
 * digits. */
DHGEN_FN void dhgen_least_squares(int equations, int unknowns, const double *A, int stride,
    double damping, const double *y, double *x)
{
    const int width = unknowns + equations;
    double rows[DHGEN_MOST_EQUATIONS][DHGEN_LONGEST_ROW] = { { 0.0 } };
    double right[DHGEN_MOST_EQUATIONS], sum[DHGEN_LONGEST_ROW] = { 0.0 };
    for (int i = 0; i < equations; i++) {
        for (int j = 0; j < unknowns; j++)
            rows[i][j] = A[stride * i + j];
        rows[i][unknowns + i] = sqrt(damping);
        right[i] = y[i];
    }
    for (int k = 0; k < equations; k++) {
        const int end = unknowns + k + 1; /* of this row: its share of the damping is the last */
        double along[DHGEN_MOST_EQUATIONS];
        for (int i = k; i < equations; i++)
            along[i] = dhgen_product_of_rows(end, rows[k], rows[i]);
        const double per_square = 1.0 / along[k], inverse = sqrt(per_square);
        for (int i = k + 1; i < equations; i++) {
            const double factor = -along[i] * per_square;
            dhgen_add_to_row(end, factor, rows[k], rows[i]);
            right[i] += factor * right[k];
        }
        right[k] *= inverse;
        for (int j = 0; j < end; j++)
            rows[k][j] *= inverse;
    }
    for (int i = equations - 1; i >= 0; i--) {
        const double missing = right[i] - dhgen_product_of_rows(width, rows[i], sum);
        dhgen_add_to_row(width, missing, rows[i], sum);
    }
    for (int j = 0; j < unknowns; j++)
        x[j] = sum[j];
}

#endif

/* SPDX-License-Identifier: MIT
 *
 * Damped least squares: of a few equations that may have no solution, or many. */
#ifndef DHGEN_LEAST_SQUARES_H
#define DHGEN_LEAST_SQUARES_H

#include "arm.h"

/* Equations, at most. */
#define DHGEN_MOST_EQUATIONS 7

/* x = A' (A A' + damping)^-1 y, the rows of A `stride` numbers apart. These, each with its share of
 * the damping's root behind it, are made orthonormal one after another (modified Gram-Schmidt; used
 * as by A. Bjorck, Numerics of Gram-Schmidt orthogonalization, 1994): A A' would lose half of the
 * digits. */
DHGEN_FN void dhgen_least_squares(int equations, int unknowns, const double *A, int stride,
    double damping, const double *y, double *x)
{
    const int width = unknowns + equations;
    double rows[DHGEN_MOST_EQUATIONS][DHGEN_MOST_EQUATIONS + DHGEN_JOINTS];
    double right[DHGEN_MOST_EQUATIONS], sum[DHGEN_MOST_EQUATIONS + DHGEN_JOINTS] = { 0.0 };
    for (int i = 0; i < equations; i++) {
        double square = 0.0;
        for (int j = 0; j < width; j++)
            rows[i][j] = j < unknowns ? A[stride * i + j] : j == unknowns + i ? sqrt(damping) : 0.0;
        right[i] = y[i];
        for (int k = 0; k < i; k++) {
            double along = 0.0;
            for (int j = 0; j < width; j++)
                along += rows[k][j] * rows[i][j];
            for (int j = 0; j < width; j++)
                rows[i][j] -= along * rows[k][j];
            right[i] -= along * right[k];
        }
        for (int j = 0; j < width; j++)
            square += rows[i][j] * rows[i][j];
        const double inverse = 1.0 / sqrt(square);
        right[i] *= inverse;
        for (int j = 0; j < width; j++)
            rows[i][j] *= inverse;
    }
    for (int i = equations - 1; i >= 0; i--) {
        double missing = right[i];
        for (int j = 0; j < width; j++)
            missing -= rows[i][j] * sum[j];
        for (int j = 0; j < width; j++)
            sum[j] += missing * rows[i][j];
    }
    for (int j = 0; j < unknowns; j++)
        x[j] = sum[j];
}

#endif

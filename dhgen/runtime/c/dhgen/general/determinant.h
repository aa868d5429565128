/* SPDX-License-Identifier: MIT
 *
 * The determinant of a formulation, and its triangular factor. */
#ifndef DHGEN_GENERAL_DETERMINANT_H
#define DHGEN_GENERAL_DETERMINANT_H

#include "motions.h"

/* The determinant at hidden angles, and the upper triangular factor whose null vectors are
 * (x3, 1) x (x2^2, x2, 1). With A2, A1, A0 the blocks of x3^2, x3, 1 the matrix is
 * [A2 A1 A0 0; 0 A2 A1 A0]; reflections fold it to 9x9 and to 6x6. */
DHGEN_INLINE dhgen_lane dhgen_determinant(
    const double *E, dhgen_lane c, dhgen_lane s, dhgen_lane factor[6][6])
{
    dhgen_lane M[6][9], W[6][9], determinant;
    dhgen_lane *const rows[6] = { M[0], M[1], M[2], M[3], M[4], M[5] };
    dhgen_lane *const last[6] = { factor[0], factor[1], factor[2], factor[3], factor[4],
        factor[5] };
    const dhgen_lane zero = { 0 };
    DHGEN_UNROLL
    for (int r = 0; r < 6; r++) {
        DHGEN_UNROLL
        for (int k = 0; k < 9; k++) {
            const int at = 32 * r + 3 * (k % 3) + k / 3;
            M[r][k] = E[at] + E[9 + at] * c + E[18 + at] * s;
        }
    }
    determinant = dhgen_reflect(rows, 6, 0, 9);
    determinant *= dhgen_reflect(rows + 1, 5, 1, 9);
    determinant *= dhgen_reflect(rows + 2, 4, 2, 9);
    /* now M is [R B1 B0; 0 D1 D0]; the other shift has R B1 B0 under D1 D0 0 */
    DHGEN_UNROLL
    for (int r = 0; r < 3; r++) {
        DHGEN_UNROLL
        for (int k = 0; k < 9; k++) {
            W[r][k] = M[r][k];
            W[3 + r][k] = k < 6 ? M[3 + r][3 + k] : zero;
            if (k < 6) {
                factor[3 + r][k] = M[3 + r][3 + k];
            }
        }
    }
    DHGEN_UNROLL
    for (int k = 0; k < 3; k++) {
        dhgen_lane *const four[4] = { W[k], W[3], W[4], W[5] };
        determinant *= dhgen_reflect(four, 4, k, 9);
    }
    DHGEN_UNROLL
    for (int r = 0; r < 3; r++) {
        DHGEN_UNROLL
        for (int k = 0; k < 6; k++) {
            factor[r][k] = W[3 + r][3 + k];
        }
    }
    determinant *= dhgen_reflect(last, 6, 0, 6);
    determinant *= dhgen_reflect(last + 1, 5, 1, 6);
    determinant *= dhgen_reflect(last + 2, 4, 2, 6);
    determinant *= dhgen_reflect(last + 3, 3, 3, 6);
    determinant *= dhgen_reflect(last + 4, 2, 4, 6);
    return determinant * factor[5][5];
}

/* How far the columns that are cleared first are from depending on each other: the square of the
 * least singular value of A2 over that of the norm of [A2 A1 A0], or a third of it, from det and
 * minors of A2' A2. Where x3 is nearly infinite they do depend on each other if the matrix is
 * singular, and the factor does not show it. */
DHGEN_INLINE dhgen_lane dhgen_independence(const double *E, dhgen_lane c, dhgen_lane s)
{
    dhgen_lane squares = { 0 }, A[6][3], G[3][3];
    for (int r = 0; r < 6; r++) {
        for (int k = 0; k < 9; k++) {
            const int at = 32 * r + k;
            const dhgen_lane x = E[at] + E[9 + at] * c + E[18 + at] * s;
            squares += x * x;
            if (k % 3 == 0) {
                A[r][k / 3] = x;
            }
        }
    }
    for (int i = 0; i < 3; i++) {
        for (int j = i; j < 3; j++) {
            G[i][j] = A[0][i] * A[0][j];
            for (int r = 1; r < 6; r++) {
                G[i][j] += A[r][i] * A[r][j];
            }
        }
    }
    const dhgen_lane first = G[1][1] * G[2][2] - G[1][2] * G[1][2];
    const dhgen_lane minors =
        first + G[0][0] * G[2][2] - G[0][2] * G[0][2] + G[0][0] * G[1][1] - G[0][1] * G[0][1];
    const dhgen_lane det = G[0][0] * first - G[0][1] * (G[0][1] * G[2][2] - G[1][2] * G[0][2])
        + G[0][2] * (G[0][1] * G[1][2] - G[1][1] * G[0][2]);
    return det / (minors * squares + DHGEN_TINY);
}

#endif

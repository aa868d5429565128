/* SPDX-License-Identifier: MIT
 *
 * Rigid motions and reflections in lanes. */
#ifndef DHGEN_GENERAL_MOTIONS_H
#define DHGEN_GENERAL_MOTIONS_H

#include "arm.h"

/* Above this the square of a common factor is no number to divide by. */
#define DHGEN_HUGE 9.999999999999999e+299

/* A rigid transform for each lane. */
typedef dhgen_lane dhgen_rigid[3][4];

/* T becomes T Rz. */
DHGEN_INLINE void dhgen_turn(dhgen_rigid T, dhgen_lane c, dhgen_lane s)
{
    for (int i = 0; i < 3; i++) {
        const dhgen_lane x = T[i][0];
        T[i][0] = x * c + T[i][1] * s;
        T[i][1] = T[i][1] * c - x * s;
    }
}

/* T becomes T Tz. */
DHGEN_INLINE void dhgen_slide(dhgen_rigid T, dhgen_lane d)
{
    for (int i = 0; i < 3; i++) {
        T[i][3] += T[i][2] * d;
    }
}

/* T becomes T times the motion of a joint: by its cosine and sine, or by a length, which replaces
 * the sine. */
DHGEN_INLINE void dhgen_move(
    const dhgen_general_arm *arm, dhgen_rigid T, int joint, dhgen_lane c, dhgen_lane s)
{
    if (dhgen_is_slide(arm, joint)) {
        dhgen_slide(T, s);
    } else {
        dhgen_turn(T, c, s);
    }
}

/* T becomes T K, with one K for all lanes. */
DHGEN_ALWAYS DHGEN_INLINE void dhgen_multiply(dhgen_rigid T, const double K[12])
{
    for (int i = 0; i < 3; i++) {
        const dhgen_lane x = T[i][0], y = T[i][1], z = T[i][2];
        for (int j = 0; j < 3; j++) {
            T[i][j] = x * K[j] + y * K[4 + j] + z * K[8 + j];
        }
        T[i][3] += x * K[3] + y * K[7] + z * K[11];
    }
}

/* T becomes K in every lane. */
DHGEN_INLINE void dhgen_broadcast(dhgen_rigid T, const double K[12])
{
    for (int i = 0; i < 12; i++) {
        T[i / 4][i % 4] = dhgen_lane_all(K[i]);
    }
}

/* Takes the common factor off a cosine and a sine; an angle of zero where the factor's square is no
 * number. */
DHGEN_INLINE void dhgen_normalize(dhgen_lane *c, dhgen_lane *s)
{
    const dhgen_lane square = *c * *c + *s * *s,
                     factor = 1.0 / dhgen_lane_sqrt(square + DHGEN_TINY);
    const dhgen_mask known = (square > DHGEN_TINY) & (square < DHGEN_HUGE);
    *c = dhgen_lane_select(known, *c * factor, dhgen_lane_all(1.0));
    *s = dhgen_lane_select(known, *s * factor, dhgen_lane_all(0.0));
}

/* Reflect `rows` rows of a matrix with `columns` columns so that below the first, `column` becomes
 * zero; row[i] points to the i-th of them. Returns the new diagonal. Sums are of two halves, so
 * that half as many operations wait for each other. */
DHGEN_INLINE dhgen_lane dhgen_reflect(dhgen_lane *const *row, int rows, int column, int columns)
{
    dhgen_lane axis[6], half[2], length, factor;
    for (int i = 0; i < 6; i++) {
        axis[i] = half[i % 2] =
            dhgen_lane_all(0.0); /* compilers don't see that `rows` of them are used */
    }
    DHGEN_UNROLL
    for (int i = 0; i < rows; i++) {
        axis[i] = row[i][column];
        half[i % 2] += axis[i] * axis[i];
    }
    length = dhgen_lane_with_sign(dhgen_lane_sqrt(half[0] + half[1]), axis[0]);
    axis[0] += length;
    factor = 1.0 / (length * axis[0] + DHGEN_TINY);
    DHGEN_UNROLL
    for (int j = column + 1; j < columns; j++) {
        dhgen_lane sum;
        half[0] = axis[0] * row[0][j];
        half[1] = axis[1] * row[1][j];
        DHGEN_UNROLL
        for (int i = 2; i < rows; i++) {
            half[i % 2] += axis[i] * row[i][j];
        }
        sum = (half[0] + half[1]) * factor;
        DHGEN_UNROLL
        for (int i = 0; i < rows; i++) {
            row[i][j] -= axis[i] * sum;
        }
    }
    row[0][column] = -length;
    return -length;
}

#endif

/* SPDX-License-Identifier: MIT
 *
 * The six equations of a formulation. */
#ifndef DHGEN_GENERAL_EQUATIONS_H
#define DHGEN_GENERAL_EQUATIONS_H

#include "loop.h"
#include "monomials.h"

/* Equations that the monomials of the right side are eliminated from. */
#define DHGEN_MIXED 14
/* Columns of the left side, 27 of them, with room for what runs over. */
#define DHGEN_ALL_COLUMNS (DHGEN_LANES_BEHIND ? 40 : 27)

/* Monomials of the left side that the outer joint of the right side leaves alone, and monomials
 * that it mixes: the former hold two of the eight monomials of the right side, the latter six. */
DHGEN_TABLE int dhgen_still[6] = { 3, 6, 7, 8, 11, 14 };
DHGEN_TABLE int dhgen_mixed[8] = { 1, 2, 4, 5, 9, 10, 12, 13 };

/* The monomials of the origin and of the direction z, in the first of 16 columns. */
DHGEN_INLINE void dhgen_begin_columns(double x[240])
{
    for (int i = 0; i < 15; i++) {
        x[16 * i] = i == 0 || i == 3 ? 1.0 : 0.0;
    }
}

typedef void dhgen_joint_parts(const dhgen_lane x[15], dhgen_lane part[3][15]);

/* Columns of monomials, 16 places wide, pass a link, and each becomes three by what the joint
 * before it does: column a columns + k of those to come, `width` places wide, is part a of column
 * k. */
DHGEN_FN void dhgen_pass_link(const double K[12], const double from[240], int columns,
    dhgen_joint_parts *parts, double *to, int width)
{
    /* from the last on, so that what runs over is written again */
    for (int k = (columns - 1) / DHGEN_GENERAL_LANES * DHGEN_GENERAL_LANES; k >= 0;
         k -= DHGEN_GENERAL_LANES) {
        dhgen_lane x[15], part[3][15];
        for (int i = 0; i < 15; i++) {
            x[i] = DHGEN_LOAD_SOME(from + 16 * i + k, columns - k);
        }
        dhgen_act(K, x);
        parts(x, part);
        for (int i = 0; i < 15; i++) {
            for (int a = 0; a < 3; a++) {
                DHGEN_STORE_SOME(to + width * i + a * columns + k, part[a][i], columns - k);
            }
        }
    }
}

/* Reflections that clear the columns of A, one after the other and all that follow in lanes; `axis`
 * and `factor` are the reflections, for other columns. The products of a column with all are summed
 * at once, its own square among them. */
DHGEN_INLINE void dhgen_clear_columns(
    double A[DHGEN_MIXED][8], int rows, int columns, double axis[8][DHGEN_MIXED], double factor[8])
{
    DHGEN_UNROLL
    for (int c = 0; c < columns; c++) {
        const int first = c / DHGEN_GENERAL_LANES * DHGEN_GENERAL_LANES;
        DHGEN_IN_ROOM(product, 8, DHGEN_ROOM_PRODUCT);
        double length;
        DHGEN_UNROLL
        for (int i = c; i < rows; i++) {
            axis[c][i] = A[i][c];
        }
        DHGEN_UNROLL
        for (int j = first; j < columns; j += DHGEN_GENERAL_LANES) {
            dhgen_lane sum = dhgen_lane_all(0.0);
            DHGEN_UNROLL
            for (int i = c; i < rows; i++) {
                sum += axis[c][i] * DHGEN_LOAD_SOME(&A[i][j], columns - j);
            }
            DHGEN_STORE_SOME(&product[j], sum, columns - j);
        }
        length = copysign(sqrt(product[c]), axis[c][c]);
        axis[c][c] += length;
        factor[c] = 1.0 / (length * axis[c][c] + DHGEN_TINY);
        DHGEN_UNROLL
        for (int j = first; j < columns; j += DHGEN_GENERAL_LANES) {
            const dhgen_lane sum = DHGEN_LOAD_SOME(&product[j], columns - j)
                + length * DHGEN_LOAD_SOME(&A[c][j], columns - j);
            const dhgen_lane part = sum * factor[c];
            DHGEN_UNROLL
            for (int i = c; i < rows; i++) {
                DHGEN_STORE_SOME(&A[i][j],
                    DHGEN_LOAD_SOME(&A[i][j], columns - j) - axis[c][i] * part, columns - j);
            }
        }
    }
}

/* Reflects x like the columns that `axis` and `factor` come from. */
DHGEN_INLINE void dhgen_reflect_column(double axis[8][DHGEN_MIXED], const double factor[8],
    int rows, int columns, dhgen_lane x[DHGEN_MIXED])
{
    DHGEN_UNROLL
    for (int c = 0; c < columns; c++) {
        dhgen_lane sum = axis[c][c] * x[c];
        DHGEN_UNROLL
        for (int i = c + 1; i < rows; i++) {
            sum += axis[c][i] * x[i];
        }
        sum *= factor[c];
        DHGEN_UNROLL
        for (int i = c; i < rows; i++) {
            x[i] -= axis[c][i] * sum;
        }
    }
}

/* The monomials of the left side: column 9 a + 3 j + i for 1, c1, s1 (a), the powers x3^2, x3, 1
 * (i) and x2^2, x2, 1 (j) of the partners' half-angle tangents or lengths. */
DHGEN_FN void dhgen_left_side(const dhgen_general_arm *arm, const dhgen_formulation *form,
    double link[6][12], double to[15][32])
{
    DHGEN_ZEROS_IN_ROOM(x, 240, DHGEN_ROOM_X);
    DHGEN_ZEROS_IN_ROOM(y, 240, DHGEN_ROOM_Y);
    DHGEN_ZEROS_IN_ROOM(all, 15 * DHGEN_ALL_COLUMNS, DHGEN_ROOM_ALL);
    const int beside = dhgen_has(arm, DHGEN_LEFT_SLIDE);
    dhgen_joint_parts *const partner_2 =
        beside && dhgen_is_slide(arm, form->joint[1]) ? dhgen_falling_lengths : dhgen_tangents;
    dhgen_joint_parts *const partner_3 =
        beside && dhgen_is_slide(arm, form->joint[2]) ? dhgen_falling_lengths : dhgen_tangents;
    dhgen_joint_parts *const hidden =
        dhgen_has(arm, DHGEN_HIDDEN_SLIDE) ? dhgen_on_circle : dhgen_cosines;
    dhgen_begin_columns(x);
    dhgen_pass_link(link[2], x, 1, partner_3, y, 16);
    dhgen_pass_link(link[1], y, 3, partner_2, x, 16);
    dhgen_pass_link(link[0], x, 9, hidden, all, DHGEN_ALL_COLUMNS);
    for (int k = 0; k < 32; k += DHGEN_GENERAL_LANES) {
        dhgen_lane z[15];
        for (int i = 0; i < 15; i++) {
            z[i] = DHGEN_LOAD_SOME(all + DHGEN_ALL_COLUMNS * i + k, 27 - k);
        }
        dhgen_act(link[5], z);
        for (int i = 0; i < 15; i++) {
            DHGEN_STORE(&to[i][k], z[i]);
        }
    }
}

/* The six equations of a formulation without a slide on the right side: index 32 r + 9 a + 3 j + i
 * for equation r, 1, c1, s1 (a), the powers x3^2, x3, 1 (i) and x2^2, x2, 1 (j) of the partners'
 * half-angle tangents or lengths; the left side's monomials have columns like these. */
DHGEN_FN void dhgen_turning_equations(double link[6][12], const double (*left)[32], double E[192])
{
    DHGEN_ZEROS_IN_ROOM(x, 240, DHGEN_ROOM_X);
    DHGEN_ZEROS_IN_ROOM(y, 240, DHGEN_ROOM_Y);
    DHGEN_ZEROS_IN_ROOM(right, 240, DHGEN_ROOM_RIGHT);
    DHGEN_ZERO_TABLE_IN_ROOM(A, DHGEN_MIXED, 8, DHGEN_ROOM_A);
    double inverse[12];
    double still_axis[8][DHGEN_MIXED], still_factor[8], pair_axis[8][DHGEN_MIXED], pair_factor[8];
    dhgen_begin_columns(x);
    dhgen_invert(link[3], inverse);
    dhgen_pass_link(inverse, x, 1, dhgen_cosines, y, 16);
    dhgen_invert(link[4], inverse);
    dhgen_pass_link(inverse, y, 3, dhgen_cosines, right, 16);
    for (int i = 0; i < 6; i++) {
        A[i][0] = right[16 * dhgen_still[i] + 1];
        A[i][1] = right[16 * dhgen_still[i] + 2];
    }
    dhgen_clear_columns(A, 6, 2, still_axis, still_factor);
    for (int i = 0; i < 8; i++) {
        for (int k = 0; k < 6; k++) {
            A[i][k] = right[16 * dhgen_mixed[i] + 3 + k];
        }
    }
    dhgen_clear_columns(A, 8, 6, pair_axis, pair_factor);
    for (int k = 0; k < 32; k += DHGEN_GENERAL_LANES) {
        dhgen_lane z[15], alone[DHGEN_MIXED], mixed[DHGEN_MIXED];
        for (int i = 0; i < 15; i++) {
            z[i] = DHGEN_LOAD(&left[i][k]);
        }
        for (int i = 0; i < 6; i++) {
            /* the constant column of the right side, times 1 + x2^2 and 1 + x3^2 */
            alone[i] = z[dhgen_still[i]] - right[16 * dhgen_still[i]] * z[0];
        }
        for (int i = 0; i < 8; i++) {
            mixed[i] = z[dhgen_mixed[i]];
        }
        dhgen_reflect_column(still_axis, still_factor, 6, 2, alone);
        dhgen_reflect_column(pair_axis, pair_factor, 8, 6, mixed);
        for (int r = 0; r < 6; r++) {
            DHGEN_STORE(E + 32 * r + k, r < 4 ? alone[2 + r] : mixed[2 + r]);
        }
    }
}

/* The six equations of a formulation with a slide on the right side, in the places of
 * dhgen_turning_equations. */
DHGEN_FN void dhgen_sliding_equations(const dhgen_general_arm *arm, const dhgen_formulation *form,
    double link[6][12], const double (*left)[32], double E[192])
{
    DHGEN_ZEROS_IN_ROOM(x, 240, DHGEN_ROOM_X);
    DHGEN_ZEROS_IN_ROOM(y, 240, DHGEN_ROOM_Y);
    DHGEN_ZEROS_IN_ROOM(right, 240, DHGEN_ROOM_RIGHT);
    DHGEN_TABLE_IN_ROOM(A, DHGEN_MIXED, 8, DHGEN_ROOM_A);
    double inverse[12], axis[8][DHGEN_MIXED], factor[8];
    dhgen_begin_columns(x);
    dhgen_invert(link[3], inverse);
    dhgen_pass_link(inverse, x, 1,
        dhgen_is_slide(arm, form->joint[4]) ? dhgen_rising_lengths : dhgen_cosines, y, 16);
    dhgen_invert(link[4], inverse);
    dhgen_pass_link(inverse, y, 3,
        dhgen_is_slide(arm, form->joint[5]) ? dhgen_rising_lengths : dhgen_cosines, right, 16);
    for (int i = 0; i < 14; i++) {
        for (int k = 0; k < 8; k++) {
            A[i][k] = right[16 * (1 + i) + 1 + k];
        }
    }
    dhgen_clear_columns(A, 14, 8, axis, factor);
    for (int k = 0; k < 32; k += DHGEN_GENERAL_LANES) {
        dhgen_lane z[15], rest[DHGEN_MIXED];
        for (int i = 0; i < 15; i++) {
            z[i] = DHGEN_LOAD(&left[i][k]);
        }
        for (int i = 0; i < 14; i++) {
            /* the constant column of the right side, times 1 + x2^2 and 1 + x3^2 */
            rest[i] = z[1 + i] - right[16 * (1 + i)] * z[0];
        }
        dhgen_reflect_column(axis, factor, 14, 8, rest);
        for (int r = 0; r < 6; r++) {
            DHGEN_STORE(E + 32 * r + k, rest[8 + r]);
        }
    }
}

/* The six equations of a formulation, in the places of dhgen_turning_equations. */
DHGEN_INLINE void dhgen_equations(const dhgen_general_arm *arm, const dhgen_formulation *form,
    double link[6][12], const double (*left)[32], double E[192])
{
    if (dhgen_has(arm, DHGEN_RIGHT_SLIDE)) {
        dhgen_sliding_equations(arm, form, link, left, E);
    } else {
        dhgen_turning_equations(link, left, E);
    }
}

#endif

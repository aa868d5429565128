/* SPDX-License-Identifier: MIT
 *
 * A robot's function for DHGEN_LANES poses, at work: on one pose where lanes are single numbers,
 * and on the poses of a batch side by side. */
#ifndef DHGEN_TILE_H
#define DHGEN_TILE_H

#include "ik.h"
#include "lanes.h"

#undef DHGEN_SOLVE_REGULAR
#define DHGEN_SOLVE_REGULAR solve_regular

/* Joint values, NaN without a solution, statuses, and whether a pose needs care. */
typedef dhgen_wide_mask dhgen_solve_wide(
    const dhgen_wide *T, const dhgen_wide *free_joints, dhgen_wide *q, dhgen_wide_mask *kind);

#if DHGEN_LANES > 1

/* Writes the statuses of a tile: those of a pose, in words of up to eight. */
DHGEN_INLINE void dhgen_store_kinds(dhgen_wide_mask *kind, unsigned char *status)
{
    for (int first = 0; first < DHGEN_ROWS; first += 8) {
        const int size = DHGEN_ROWS - first < 8 ? DHGEN_ROWS - first : 8;
        for (int i = 1; i < size; i++)
            kind[first] |= kind[first + i] << 8 * i;
        for (int k = 0; k < DHGEN_LANES; k++) {
            const long long word = kind[first][k];
            __builtin_memcpy(status + DHGEN_ROWS * k + first, &word, (size_t)size);
        }
    }
}

/* Solves DHGEN_LANES poses of a batch. Returns a bit for each that needs care. */
DHGEN_ALWAYS
DHGEN_INLINE unsigned dhgen_solve_tile(dhgen_solve_wide *solve_wide, int given, const double *T,
    const double *free_joints, double *q, unsigned char *status)
{
    enum { SIZE = DHGEN_ROWS * DHGEN_DOF };
    dhgen_wide pose[16], found[SIZE], x[DHGEN_LANES], held[DHGEN_DOF];
    dhgen_wide_mask kind[DHGEN_ROWS];
    for (int i = 0; i < given; i++)
        for (int k = 0; k < DHGEN_LANES; k++)
            held[i][k] = free_joints[given * k + i];
    for (int i = 0; i < 16; i += DHGEN_LANES) {
        for (int k = 0; k < DHGEN_LANES; k++)
            x[k] = *(const dhgen_wide_at *)(T + 16 * k + i);
        dhgen_transpose(x);
        for (int k = 0; k < DHGEN_LANES; k++)
            pose[i + k] = x[k];
    }
    const dhgen_wide_mask left = solve_wide(pose, given ? held : NULL, found, kind);
#if DHGEN_ROWS * DHGEN_DOF >= DHGEN_LANES
    for (int i = 0; i < SIZE; i += DHGEN_LANES) {
        const int from = i + DHGEN_LANES <= SIZE ? i : SIZE - DHGEN_LANES;
        for (int k = 0; k < DHGEN_LANES; k++)
            x[k] = found[from + k];
        dhgen_transpose(x);
        for (int k = 0; k < DHGEN_LANES; k++)
            *(dhgen_wide_at *)(q + SIZE * k + from) = x[k];
    }
#else
    for (int i = 0; i < SIZE; i++)
        for (int k = 0; k < DHGEN_LANES; k++)
            q[SIZE * k + i] = found[i][k];
#endif
    dhgen_store_kinds(kind, status);
    return dhgen_bits_wide(left);
}

/* All solutions of the poses of a batch. */
DHGEN_ALWAYS
DHGEN_INLINE void dhgen_ik_batch(const struct dhgen_arm *arm, dhgen_solve_wide *solve_wide,
    int given, size_t n, const double *T, const double *free_joints, double *q,
    unsigned char *status)
{
    enum { SIZE = DHGEN_ROWS * DHGEN_DOF };
    const size_t count = (size_t)given;
    size_t k = 0;
    for (; k + DHGEN_LANES <= n; k += DHGEN_LANES) {
        const double *const held = given ? free_joints + count * k : NULL;
        unsigned left = dhgen_solve_tile(
            solve_wide, given, T + 16 * k, held, q + SIZE * k, status + DHGEN_ROWS * k);
        for (size_t i = k; left; i++, left >>= 1)
            if (left & 1u)
                dhgen_ik_each(arm, i, i + 1, T, free_joints, q, status);
    }
    dhgen_ik_each(arm, k, n, T, free_joints, q, status);
}

#else

/* One regular pose of an arm with at most DHGEN_ROWS rows. Returns how many rows are OK, or -1 if
 * it needs care. */
DHGEN_ALWAYS
DHGEN_INLINE int dhgen_solve_branches(dhgen_solve_wide *solve_wide, int rows, const double *T,
    const double *free_joints, double *q, unsigned char *status)
{
    dhgen_wide_mask kind[DHGEN_ROWS];
    int count = 0;
    if (solve_wide(T, free_joints, q, kind))
        return -1;
    for (int row = 0; row < rows; row++) {
        status[row] = (unsigned char)kind[row];
        count += kind[row] == DHGEN_OK;
    }
    return count;
}

/* All solutions of the poses of a batch. */
DHGEN_INLINE void dhgen_ik_batch(const struct dhgen_arm *arm, dhgen_solve_wide *solve_wide,
    int given, size_t n, const double *T, const double *free_joints, double *q,
    unsigned char *status)
{
    (void)solve_wide;
    (void)given;
    dhgen_ik_each(arm, 0, n, T, free_joints, q, status);
}

#endif

#endif

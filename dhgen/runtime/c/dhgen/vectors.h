/* SPDX-License-Identifier: MIT
 *
 * Lanes as GNU vectors of AVX2 or AVX-512. */
#ifndef DHGEN_VECTORS_H
#define DHGEN_VECTORS_H

#include <immintrin.h>

#define dhgen_shuffle __builtin_shufflevector

typedef double dhgen_two_at __attribute__((vector_size(16), aligned(8), may_alias)); /* in memory */
typedef double dhgen_four __attribute__((vector_size(32)));
typedef dhgen_four dhgen_four_at __attribute__((aligned(8), may_alias)); /* in memory */
typedef __typeof__(*(dhgen_four *)0 < *(dhgen_four *)0) dhgen_four_mask;

DHGEN_INLINE dhgen_four dhgen_pick_four(dhgen_four_mask m, dhgen_four yes, dhgen_four no)
{
    return _mm256_blendv_pd(no, yes, (__m256d)m);
}

DHGEN_INLINE dhgen_four dhgen_maximum_four(dhgen_four a, dhgen_four b)
{
    return _mm256_max_pd(a, b);
}

DHGEN_INLINE dhgen_four dhgen_minimum_four(dhgen_four a, dhgen_four b)
{
    return _mm256_min_pd(a, b);
}

DHGEN_INLINE dhgen_four dhgen_sqrt_four(dhgen_four x)
{
    return _mm256_sqrt_pd(x);
}

/* A bit for each lane. */
DHGEN_INLINE unsigned dhgen_bits_four(dhgen_four_mask m)
{
    return (unsigned)_mm256_movemask_pd((__m256d)m);
}

/* A truth value in all lanes. */
DHGEN_INLINE dhgen_four_mask dhgen_where_four(int truth)
{
    return (dhgen_four_mask)_mm256_set1_epi64x(-(long long)truth);
}

DHGEN_INLINE dhgen_four dhgen_four_of(double a, double b, double c, double d)
{
    const dhgen_four all = { a, b, c, d };
    return all;
}

#define DHGEN_OF(name) dhgen_##name##_four
#define DHGEN_VECTOR dhgen_four
#define DHGEN_MASK dhgen_four_mask
#define DHGEN_SIZE 4
/* one pose waits for its values: a sum that doesn't wait for the mask */
#define DHGEN_ADDED(x, m, y) dhgen_pick_four(m, (x) + (y), x)
#include "vector.h"
#include "turns.h"
#include "arctangent.h"
#undef DHGEN_OF
#undef DHGEN_VECTOR
#undef DHGEN_MASK
#undef DHGEN_SIZE
#undef DHGEN_ADDED

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define DHGEN_LANES 8
typedef double dhgen_wide __attribute__((vector_size(64)));
typedef __typeof__(*(dhgen_wide *)0 < *(dhgen_wide *)0) dhgen_wide_mask;

DHGEN_INLINE dhgen_wide dhgen_pick_wide(dhgen_wide_mask m, dhgen_wide yes, dhgen_wide no)
{
    return _mm512_mask_blend_pd(_mm512_movepi64_mask((__m512i)m), no, yes);
}

DHGEN_INLINE dhgen_wide dhgen_maximum_wide(dhgen_wide a, dhgen_wide b)
{
    return _mm512_maskz_max_pd(DHGEN_EACH, a, b);
}

DHGEN_INLINE dhgen_wide dhgen_minimum_wide(dhgen_wide a, dhgen_wide b)
{
    return _mm512_maskz_min_pd(DHGEN_EACH, a, b);
}

DHGEN_INLINE dhgen_wide dhgen_sqrt_wide(dhgen_wide x)
{
    return _mm512_maskz_sqrt_pd(DHGEN_EACH, x);
}

DHGEN_INLINE unsigned dhgen_bits_wide(dhgen_wide_mask m)
{
    return (unsigned)_mm512_movepi64_mask((__m512i)m);
}

DHGEN_INLINE dhgen_wide_mask dhgen_where_wide(int truth)
{
    return (dhgen_wide_mask)_mm512_set1_epi64(-(long long)truth);
}
#else
#define DHGEN_LANES 4
typedef dhgen_four dhgen_wide;
typedef dhgen_four_mask dhgen_wide_mask;
#define dhgen_pick_wide dhgen_pick_four
#define dhgen_maximum_wide dhgen_maximum_four
#define dhgen_minimum_wide dhgen_minimum_four
#define dhgen_sqrt_wide dhgen_sqrt_four
#define dhgen_bits_wide dhgen_bits_four
#define dhgen_where_wide dhgen_where_four
#endif
typedef dhgen_wide dhgen_wide_at __attribute__((aligned(8), may_alias)); /* in memory */

#define DHGEN_OF(name) dhgen_##name##_wide
#define DHGEN_VECTOR dhgen_wide
#define DHGEN_MASK dhgen_wide_mask
#define DHGEN_SIZE DHGEN_LANES
#define DHGEN_ADDED(x, m, y) ((x) + dhgen_only_wide(m, 1.0) * (y))
#include "vector.h"
#include "turns.h"
#include "arctangent.h"
#undef DHGEN_OF
#undef DHGEN_VECTOR
#undef DHGEN_MASK
#undef DHGEN_SIZE
#undef DHGEN_ADDED

/* The status of rows: whether they have no solution, or one beyond limits. */
DHGEN_INLINE dhgen_wide_mask dhgen_kind_wide(dhgen_wide x)
{
    return (x != x) & (long long)DHGEN_UNREACHABLE;
}

DHGEN_INLINE dhgen_wide_mask dhgen_kind_within_wide(dhgen_wide x, dhgen_wide_mask outside)
{
    return ((x != x) & (long long)DHGEN_UNREACHABLE)
        | ((x == x) & outside & (long long)DHGEN_OUT_OF_LIMITS);
}

/* How far the rotation part of one pose is from orthonormal and right-handed, as sums of squares:
 * lengths and angles of its columns, and whether its rows are right-handed. The last lane has what
 * the fourth column makes of them. */
DHGEN_INLINE dhgen_four dhgen_column_misfits(const double *T)
{
    const dhgen_four x = *(const dhgen_four_at *)T, y = *(const dhgen_four_at *)(T + 4);
    const dhgen_four z = *(const dhgen_four_at *)(T + 8), x1 = dhgen_shuffle(x, x, 1, 2, 0, 3);
    const dhgen_four y1 = dhgen_shuffle(y, y, 1, 2, 0, 3), z1 = dhgen_shuffle(z, z, 1, 2, 0, 3);
    const dhgen_four x2 = dhgen_shuffle(x, x, 2, 0, 1, 3), y2 = dhgen_shuffle(y, y, 2, 0, 1, 3);
    const dhgen_four lengths = x * x + y * y + z * z - 1.0, angles = x * x1 + y * y1 + z * z1;
    const dhgen_four mirror = x1 * y2 - x2 * y1 - z;
    return lengths * lengths + 2.0 * angles * angles + mirror * mirror;
}

/* The misfit of a rotation, without the fourth column. */
DHGEN_INLINE dhgen_four dhgen_misfit_four(const double *T)
{
    return dhgen_shuffle(dhgen_column_misfits(T), dhgen_all_four(0.0), 0, 1, 2, 7);
}

/* The misfit of a whole pose: the fourth column counts only as finite, and the last row. */
DHGEN_INLINE dhgen_four dhgen_pose_misfit_four(const double *T)
{
    const dhgen_four last = *(const dhgen_four_at *)(T + 12) - dhgen_four_of(0.0, 0.0, 0.0, 1.0);
    return dhgen_column_misfits(T) * dhgen_four_of(1.0, 1.0, 1.0, 0.0) + last * last;
}

/* How far the tool's z axis is from one long. */
DHGEN_INLINE double dhgen_approach_misfit(const double *T)
{
    const double zz = T[2] * T[2] + T[6] * T[6] + T[10] * T[10] - 1.0;
    return zz * zz;
}

/* By how much the sine of the pitch is above one; NaN if it is not finite. */
DHGEN_INLINE double dhgen_pitch_misfit(const double *T)
{
    const double over = fabs(T[8]) - 1.0;
    return (over > 0.0 ? over * over : 0.0) + 0.0 * T[8];
}

/* How far the third row is from one long. */
DHGEN_INLINE double dhgen_tilt_misfit(const double *T)
{
    const double zz = T[8] * T[8] + T[9] * T[9] + T[10] * T[10] - 1.0;
    return zz * zz;
}

/* Writes joint values of four rows. */
DHGEN_INLINE void dhgen_store_4(double *r0, double *r1, double *r2, double *r3, dhgen_four a,
    dhgen_four b, dhgen_four c, dhgen_four d)
{
    const dhgen_four ab0 = dhgen_shuffle(a, b, 0, 4, 2, 6), ab1 = dhgen_shuffle(a, b, 1, 5, 3, 7);
    const dhgen_four cd0 = dhgen_shuffle(c, d, 0, 4, 2, 6), cd1 = dhgen_shuffle(c, d, 1, 5, 3, 7);
    *(dhgen_four_at *)r0 = dhgen_shuffle(ab0, cd0, 0, 1, 4, 5);
    *(dhgen_four_at *)r1 = dhgen_shuffle(ab1, cd1, 0, 1, 4, 5);
    *(dhgen_four_at *)r2 = dhgen_shuffle(ab0, cd0, 2, 3, 6, 7);
    *(dhgen_four_at *)r3 = dhgen_shuffle(ab1, cd1, 2, 3, 6, 7);
}

DHGEN_INLINE void dhgen_store_2(
    double *r0, double *r1, double *r2, double *r3, dhgen_four a, dhgen_four b)
{
    const dhgen_four first = dhgen_shuffle(a, b, 0, 4, 2, 6);
    const dhgen_four second = dhgen_shuffle(a, b, 1, 5, 3, 7);
    *(dhgen_two_at *)r0 = dhgen_shuffle(first, first, 0, 1);
    *(dhgen_two_at *)r1 = dhgen_shuffle(second, second, 0, 1);
    *(dhgen_two_at *)r2 = dhgen_shuffle(first, first, 2, 3);
    *(dhgen_two_at *)r3 = dhgen_shuffle(second, second, 2, 3);
}

DHGEN_INLINE void dhgen_store_1(double *r0, double *r1, double *r2, double *r3, dhgen_four a)
{
    *r0 = a[0];
    *r1 = a[1];
    *r2 = a[2];
    *r3 = a[3];
}

/* Rows to columns. */
DHGEN_INLINE void dhgen_transpose(dhgen_wide *x)
{
#if DHGEN_LANES == 8
    dhgen_wide y[8];
    for (int k = 0; k < 8; k += 2) {
        y[k] = dhgen_shuffle(x[k], x[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        y[k + 1] = dhgen_shuffle(x[k], x[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int i = 0; i < 4; i++) {
        const int k = i + (i & 2); /* 0, 1, 4, 5 */
        x[k] = dhgen_shuffle(y[k], y[k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
        x[k + 2] = dhgen_shuffle(y[k], y[k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
    for (int k = 0; k < 4; k++) {
        y[k] = x[k];
        x[k] = dhgen_shuffle(y[k], x[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        x[k + 4] = dhgen_shuffle(y[k], x[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
#else
    double y[16];
    dhgen_store_4(y, y + 4, y + 8, y + 12, x[0], x[1], x[2], x[3]);
    for (int k = 0; k < 4; k++)
        x[k] = *(const dhgen_wide_at *)(y + 4 * k);
#endif
}

#endif

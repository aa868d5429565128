/* SPDX-License-Identifier: MIT
 *
 * Numbers in lanes: several angles or candidates at once. */
#ifndef DHGEN_GENERAL_LANES_H
#define DHGEN_GENERAL_LANES_H

#include "../arctangent_series.h"
#include "../interface.h"
#include "threads.h"

/* Lanes: GNU vectors where the compiler has them, plain doubles otherwise; on a GPU the threads of
 * a group with DHGEN_GROUP. Vectors wider than the machine's are slow: compile for the machine, or
 * set DHGEN_GENERAL_LANES to 1, 2, 4 or 8. */
#ifndef DHGEN_GENERAL_LANES
#if defined(__CUDACC__)
#define DHGEN_GENERAL_LANES 1
#elif defined(__GNUC__) && defined(__AVX512F__)
#define DHGEN_GENERAL_LANES 8
#elif defined(__GNUC__) && defined(__AVX__)
#define DHGEN_GENERAL_LANES 4
#elif defined(__GNUC__) && defined(__SSE2__)
#define DHGEN_GENERAL_LANES 2
#else
#define DHGEN_GENERAL_LANES 1
#endif
#endif

#if DHGEN_GENERAL_LANES > 1 && !defined(DHGEN_LANES_ARE_THREADS)
#define DHGEN_LANES_ARE_VECTORS
#ifdef __SSE2__
#include <immintrin.h>
#endif
#endif

/* Added to what is divided by, so that the quotient stays finite; it changes no number that is not
 * next to nothing itself. */
#define DHGEN_TINY 1e-300
/* Up to this ratio, tan(pi/8), the polynomial is the arctangent. */
#define DHGEN_STEEP 0.41421356237309515
#define DHGEN_HALF_PI 1.5707963267948966
#define DHGEN_QUARTER_PI 0.7853981633974483

/* Loops of few rounds over lanes: compilers do not unroll them where there are many operations, and
 * what would fit in registers goes through memory. */
#if DHGEN_GENERAL_LANES == 1 || defined(__OPTIMIZE_SIZE__)
#define DHGEN_UNROLL
#elif defined(__CUDACC__)
#define DHGEN_UNROLL _Pragma("unroll")
#elif defined(__clang__)
#define DHGEN_UNROLL _Pragma("clang loop unroll(full)")
#elif __GNUC__ >= 8
#define DHGEN_UNROLL _Pragma("GCC unroll 16")
#else
#define DHGEN_UNROLL
#endif

/* Factors of the even powers of a cosine from the second on, and of the odd ones of a sine from the
 * third on. */
DHGEN_TABLE double dhgen_cosine_series[8] = {
    -1.0 / 2.0,
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40320.0,
    -1.0 / 3628800.0,
    1.0 / 479001600.0,
    -1.0 / 87178291200.0,
    1.0 / 20922789888000.0,
};
DHGEN_TABLE double dhgen_sine_series[7] = {
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5040.0,
    1.0 / 362880.0,
    -1.0 / 39916800.0,
    1.0 / 6227020800.0,
    -1.0 / 1307674368000.0,
};

#ifdef DHGEN_LANES_ARE_VECTORS
typedef double dhgen_lane __attribute__((vector_size(8 * DHGEN_GENERAL_LANES)));
typedef long long dhgen_mask __attribute__((vector_size(8 * DHGEN_GENERAL_LANES)));
/* A vector that lies between other doubles. */
typedef double dhgen_packed
    __attribute__((vector_size(8 * DHGEN_GENERAL_LANES), aligned(8), may_alias));
/* Arrays that begin where a vector may, so that none crosses the border of two cache lines. */
#define DHGEN_ALIGNED __attribute__((aligned(8 * DHGEN_GENERAL_LANES)))
#define DHGEN_LOAD(from) (dhgen_lane)(*(const dhgen_packed *)(from))
#define DHGEN_STORE(to, x) (*(dhgen_packed *)(to) = (dhgen_packed)(x))

DHGEN_INLINE dhgen_lane dhgen_lane_select(dhgen_mask m, dhgen_lane a, dhgen_lane b)
{
    return (dhgen_lane)((m & (dhgen_mask)a) | (~m & (dhgen_mask)b));
}

DHGEN_INLINE dhgen_lane dhgen_lane_abs(dhgen_lane x)
{
    return (dhgen_lane)((dhgen_mask)x & 0x7fffffffffffffffLL);
}

/* The magnitude of x with the sign of y. */
DHGEN_INLINE dhgen_lane dhgen_lane_with_sign(dhgen_lane x, dhgen_lane y)
{
    const dhgen_mask sign = (dhgen_mask)y & (-0x7fffffffffffffffLL - 1);
    return (dhgen_lane)(((dhgen_mask)x & 0x7fffffffffffffffLL) | sign);
}

/* x, negated where y is negative. */
DHGEN_INLINE dhgen_lane dhgen_lane_facing(dhgen_lane x, dhgen_lane y)
{
    const dhgen_mask sign = (dhgen_mask)y & (-0x7fffffffffffffffLL - 1);
    return (dhgen_lane)((dhgen_mask)x ^ sign);
}

/* The square root, by the machine's own instruction: compilers take sqrt of <math.h> one by one,
 * for the sake of errno. */
DHGEN_INLINE dhgen_lane dhgen_lane_sqrt(dhgen_lane x)
{
#if DHGEN_GENERAL_LANES == 8 && defined(__AVX512F__)
    return (dhgen_lane)_mm512_maskz_sqrt_pd(DHGEN_EACH, (__m512d)x);
#elif DHGEN_GENERAL_LANES == 4 && defined(__AVX__)
    return (dhgen_lane)_mm256_sqrt_pd((__m256d)x);
#elif DHGEN_GENERAL_LANES == 2 && defined(__SSE2__)
    return (dhgen_lane)_mm_sqrt_pd((__m128d)x);
#else
    dhgen_lane r = x;
    for (int k = 0; k < DHGEN_GENERAL_LANES; k++) {
        r[k] = sqrt(x[k]);
    }
    return r;
#endif
}
/* Added and taken away again this leaves the nearest integer, whose last bits are the last bits of
 * the sum: 1.5 * 2^52. */
#define DHGEN_TO_INTEGER 6755399441055744.0
/* pi/2 in two parts, of which a small integer times the first is exact. */
#define DHGEN_HALF_PI_HIGH 1.5707963267341256
#define DHGEN_HALF_PI_LOW 6.077100506506192e-11

#else
#ifndef DHGEN_LANES_ARE_THREADS
typedef double dhgen_lane;
typedef int dhgen_mask;
#define DHGEN_ALIGNED
#define DHGEN_LOAD(from) (*(from))
#define DHGEN_STORE(to, x) (*(to) = (x))
#endif

DHGEN_INLINE dhgen_lane dhgen_lane_select(dhgen_mask m, dhgen_lane a, dhgen_lane b)
{
    return m ? a : b;
}

DHGEN_INLINE dhgen_lane dhgen_lane_abs(dhgen_lane x)
{
    return fabs(x);
}

DHGEN_INLINE dhgen_lane dhgen_lane_with_sign(dhgen_lane x, dhgen_lane y)
{
    return copysign(x, y);
}

DHGEN_INLINE dhgen_lane dhgen_lane_facing(dhgen_lane x, dhgen_lane y)
{
    return y < 0.0 ? -x : x;
}

DHGEN_INLINE dhgen_lane dhgen_lane_sqrt(dhgen_lane x)
{
    return sqrt(x);
}

#endif

#ifndef DHGEN_LANES_ARE_THREADS
/* Arrays in which lanes are stored, of numbers, of rows and of rows of lanes, and members that are
 * such arrays. Where lanes are threads these are in a place of their room, and members are placed
 * there. */
#define DHGEN_IN_ROOM(name, count, place) double name[count]
#define DHGEN_ZEROS_IN_ROOM(name, count, place) double name[count] = { 0.0 }
#define DHGEN_TABLE_IN_ROOM(name, rows, columns, place) double name[rows][columns] DHGEN_ALIGNED
#define DHGEN_ZERO_TABLE_IN_ROOM(name, rows, columns, place) \
    double name[rows][columns] DHGEN_ALIGNED = { { 0.0 } }
#define DHGEN_LANES_IN_ROOM(name, place) double name[DHGEN_GENERAL_LANES]
#define DHGEN_ROWS_IN_ROOM(name, rows, place) double name[rows][DHGEN_GENERAL_LANES]
#define DHGEN_KINDS_IN_ROOM(name, place) int name[DHGEN_GENERAL_LANES]
#define DHGEN_MEMBER(name, count) double name[count]
#define DHGEN_MEMBER_ROWS(name, rows, count) double name[rows][count]
#define DHGEN_PLACE_GRID(grid)
#define DHGEN_PLACE_PARTS(parts, place, length)
#define DHGEN_PLACE_ROWS(of, rows, count, length)
/* From where to where loops over lanes go in which each writes its own entries of arrays that begin
 * there; behind them all meet. */
#define DHGEN_FIRST_LANE 0
#define DHGEN_END_LANE DHGEN_GENERAL_LANES
#define DHGEN_MEET() ((void)0)
/* Lanes of which so many count: the others are in the array, too. */
#define DHGEN_LANES_BEHIND 1
#define DHGEN_LOAD_SOME(from, count) ((void)(count), DHGEN_LOAD(from))
#define DHGEN_STORE_SOME(to, x, count) ((void)(count), DHGEN_STORE(to, x))
/* To an array that each thread has for itself. */
#define DHGEN_SPREAD(to, x, count) DHGEN_STORE_SOME(to, x, count)

/* Numbers from one on, one a lane; behind the last the first of them again. */
DHGEN_INLINE dhgen_lane dhgen_lane_from(const double *numbers, int from, int count)
{
    double each[DHGEN_GENERAL_LANES];
    for (int k = 0; k < DHGEN_GENERAL_LANES; k++) {
        each[k] = numbers[from + k < count ? from + k : from];
    }
    return DHGEN_LOAD(each);
}
#endif

DHGEN_INLINE dhgen_lane dhgen_lane_all(double x)
{
    const dhgen_lane zero = { 0 };
    return zero + x;
}

DHGEN_INLINE dhgen_lane dhgen_lane_max(dhgen_lane a, dhgen_lane b)
{
#if DHGEN_GENERAL_LANES == 8 && defined(__AVX512F__)
    return (dhgen_lane)_mm512_maskz_max_pd(DHGEN_EACH, (__m512d)a, (__m512d)b);
#elif DHGEN_GENERAL_LANES == 4 && defined(__AVX__)
    return (dhgen_lane)_mm256_max_pd((__m256d)a, (__m256d)b);
#else
    return dhgen_lane_select(a > b, a, b);
#endif
}

DHGEN_INLINE dhgen_lane dhgen_lane_min(dhgen_lane a, dhgen_lane b)
{
#if DHGEN_GENERAL_LANES == 8 && defined(__AVX512F__)
    return (dhgen_lane)_mm512_maskz_min_pd(DHGEN_EACH, (__m512d)a, (__m512d)b);
#elif DHGEN_GENERAL_LANES == 4 && defined(__AVX__)
    return (dhgen_lane)_mm256_min_pd((__m256d)a, (__m256d)b);
#else
    return dhgen_lane_select(a < b, a, b);
#endif
}

#ifndef DHGEN_LANES_ARE_THREADS
/* Whether a number of some lane is above another one. */
DHGEN_INLINE int dhgen_lane_any_above(dhgen_lane a, dhgen_lane b)
{
#if DHGEN_GENERAL_LANES == 8 && defined(__AVX512F__)
    return _mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_GT_OQ) != 0;
#elif DHGEN_GENERAL_LANES == 4 && defined(__AVX__)
    return _mm256_movemask_pd(_mm256_cmp_pd((__m256d)a, (__m256d)b, _CMP_GT_OQ)) != 0;
#elif DHGEN_GENERAL_LANES > 1
    const dhgen_mask above = a > b;
    int any = 0;
    for (int k = 0; k < DHGEN_GENERAL_LANES; k++) {
        any |= above[k] != 0;
    }
    return any;
#else
    return a > b;
#endif
}

/* The largest number of all lanes. */
DHGEN_INLINE double dhgen_lane_largest(dhgen_lane x)
{
    double each[DHGEN_GENERAL_LANES], most;
    DHGEN_STORE(each, x);
    most = each[0];
    for (int k = 1; k < DHGEN_GENERAL_LANES; k++) {
        most = each[k] > most ? each[k] : most;
    }
    return most;
}

#ifdef DHGEN_LANES_ARE_VECTORS
/* Bits of many numbers, lane after lane. */
typedef dhgen_mask dhgen_lane_bits;

/* Adds a bit of each lane, from a number on. */
DHGEN_INLINE void dhgen_lane_add_bits(dhgen_lane_bits *bits, dhgen_mask set, int from)
{
    dhgen_mask weight = { 0 };
    for (int k = 0; k < DHGEN_GENERAL_LANES; k++) {
        weight[k] = 1LL << k;
    }
    *bits |= (set & weight) << from;
}

DHGEN_INLINE unsigned long long dhgen_lane_all_bits(dhgen_lane_bits bits)
{
    unsigned long long all = 0;
    for (int k = 0; k < DHGEN_GENERAL_LANES; k++) {
        all |= (unsigned long long)bits[k];
    }
    return all;
}
#else
typedef unsigned long long dhgen_lane_bits;

DHGEN_INLINE void dhgen_lane_add_bits(dhgen_lane_bits *bits, dhgen_mask set, int from)
{
    *bits |= (dhgen_lane_bits)set << from;
}
#endif
#endif

#ifndef DHGEN_LANES_ARE_VECTORS
DHGEN_INLINE unsigned long long dhgen_lane_all_bits(dhgen_lane_bits bits)
{
    return bits;
}
#endif

/* Whether any of four numbers is negative. */
DHGEN_INLINE dhgen_mask dhgen_lane_any_negative(
    dhgen_lane a, dhgen_lane b, dhgen_lane c, dhgen_lane d)
{
#ifdef DHGEN_LANES_ARE_VECTORS
    return ((dhgen_mask)a | (dhgen_mask)b | (dhgen_mask)c | (dhgen_mask)d) < 0;
#else
    return a < 0.0 || b < 0.0 || c < 0.0 || d < 0.0;
#endif
}

/* Cosine and sine of an angle within a few turns of zero, within 2 ulp: of what is left of the
 * nearest quarter turn, by their series. */
DHGEN_INLINE void dhgen_lane_direction(dhgen_lane angle, dhgen_lane *c, dhgen_lane *s)
{
#ifdef DHGEN_LANES_ARE_VECTORS
    const dhgen_lane counted = angle * (1.0 / DHGEN_HALF_PI) + DHGEN_TO_INTEGER;
    const dhgen_lane quarters = counted - DHGEN_TO_INTEGER;
    const dhgen_mask number = (dhgen_mask)counted, odd = -(number & 1);
    const dhgen_lane r = (angle - quarters * DHGEN_HALF_PI_HIGH) - quarters * DHGEN_HALF_PI_LOW;
    const dhgen_lane u = r * r;
    dhgen_lane a = dhgen_lane_all(dhgen_cosine_series[7]), b = dhgen_lane_all(dhgen_sine_series[6]);
    DHGEN_UNROLL
    for (int k = 6; k >= 0; k--) {
        a = a * u + dhgen_cosine_series[k];
    }
    DHGEN_UNROLL
    for (int k = 5; k >= 0; k--) {
        b = b * u + dhgen_sine_series[k];
    }
    a = 1.0 + a * u;
    b = r + b * u * r;
    const dhgen_lane x = dhgen_lane_select(odd, b, a), y = dhgen_lane_select(odd, a, b);
    const long long sign = -0x7fffffffffffffffLL - 1;
    *c = (dhgen_lane)((dhgen_mask)x ^ (-((number + 1) >> 1 & 1) & sign));
    *s = (dhgen_lane)((dhgen_mask)y ^ (-(number >> 1 & 1) & sign));
#else
    *c = cos(angle);
    *s = sin(angle);
#endif
}

/* The angle of a sine and a cosine with any positive common factor, in (-pi, pi], within 3 ulp:
 * atan of a ratio below tan(pi/8) by a polynomial. */
DHGEN_INLINE dhgen_lane dhgen_lane_angle(dhgen_lane y, dhgen_lane x)
{
    const dhgen_lane ax = dhgen_lane_abs(x), ay = dhgen_lane_abs(y), zero = { 0 };
    const dhgen_mask steep = ay > ax;
    const dhgen_lane high = dhgen_lane_select(steep, ay, ax),
                     low = dhgen_lane_select(steep, ax, ay);
    const dhgen_mask turned = low > high * DHGEN_STEEP;
    const dhgen_lane up = dhgen_lane_select(turned, low - high, low);
    const dhgen_lane down = dhgen_lane_select(turned, low + high, high);
    const dhgen_lane r = up / (down + DHGEN_TINY), u = r * r;
    dhgen_lane a = dhgen_lane_all(dhgen_arctangent[10]);
    for (int k = 9; k >= 0; k--) {
        a = a * u + dhgen_arctangent[k];
    }
    a = r + r * u * a + dhgen_lane_select(turned, zero + DHGEN_QUARTER_PI, zero);
    a = dhgen_lane_select(steep, DHGEN_HALF_PI - a, a);
    a = dhgen_lane_select(x < 0.0, DHGEN_HALF_TURN - a, a);
    return dhgen_lane_with_sign(a, y + 0.0);
}

#endif

/* SPDX-License-Identifier: MIT
 *
 * Lanes that are single numbers. */
#ifndef DHGEN_SCALARS_H
#define DHGEN_SCALARS_H

#define DHGEN_LANES 1
typedef double dhgen_wide;
typedef dhgen_wide dhgen_wide_at; /* in memory */
typedef int dhgen_wide_mask;

/* Only what is chosen is computed: a function's arguments all would be. */
#define dhgen_pick_wide(m, yes, no) ((m) ? (yes) : (no))
#define dhgen_only_wide(m, x) ((m) ? (x) : 0.0)

#define dhgen_copysign_wide copysign
#define dhgen_signed_wide copysign
#define dhgen_abs_wide fabs
#define dhgen_sqrt_wide sqrt
#define dhgen_sin_wide sin
#define dhgen_cos_wide cos
#define dhgen_wrap_wide dhgen_wrap
#define dhgen_maximum_wide dhgen_maximum_double

DHGEN_INLINE double dhgen_all_wide(double x)
{
    return x;
}

DHGEN_INLINE int dhgen_where_wide(int truth)
{
    return truth;
}

DHGEN_INLINE unsigned dhgen_bits_wide(int m)
{
    return m != 0;
}

DHGEN_INLINE double dhgen_minimum_wide(double a, double b)
{
    return a < b ? a : b;
}

DHGEN_INLINE double dhgen_negated_wide(double x, double where)
{
    return x * copysign(1.0, where);
}

/* The status of a row: whether it has no solution, or one beyond limits. */
DHGEN_INLINE int dhgen_kind_wide(double x)
{
    return -(x != x) & DHGEN_UNREACHABLE;
}

DHGEN_INLINE int dhgen_kind_within_wide(double x, int outside)
{
    return (-(x != x) & DHGEN_UNREACHABLE) | (-((x == x) & outside) & DHGEN_OUT_OF_LIMITS);
}

#define DHGEN_OF(name) dhgen_##name##_wide
#define DHGEN_VECTOR dhgen_wide
#define DHGEN_MASK dhgen_wide_mask
#define DHGEN_ADDED(x, m, y) ((x) + dhgen_only_wide(m, 1.0) * (y))
#include "turns.h"
#ifdef DHGEN_LIBM /* half the time of atan2 */
DHGEN_INLINE double dhgen_atan2_wide(double y, double x)
{
    return atan(y / x) + copysign(1.5707963267948966 - copysign(1.5707963267948966, x), y);
}
#else
#include "arctangent.h"
#endif
#undef DHGEN_OF
#undef DHGEN_VECTOR
#undef DHGEN_MASK
#undef DHGEN_ADDED

#endif

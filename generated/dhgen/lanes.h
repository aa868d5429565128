/* SPDX-License-Identifier: MIT
 *
 * Lanes: what the fast path computes with. `dhgen_wide` holds one number of each of DHGEN_LANES
 * poses, `dhgen_four` one of each of four branches of one pose. They are GNU vectors where compiler
 * and machine have them; with -DDHGEN_SCALAR and elsewhere `dhgen_wide` is a number, and there is
 * no `dhgen_four`. With -DDHGEN_LIBM the arctangents are those of <math.h>, too. */
#ifndef DHGEN_LANES_H
#define DHGEN_LANES_H

#include "arm.h"
#include "arctangent_series.h"
#include "quotient.h"
#include "tolerances.h"

#if defined(__clang__) || defined(__CUDACC__)
#define DHGEN_UNROLLED _Pragma("unroll")
#define DHGEN_WRITTEN_OUT _Pragma("unroll")
#elif defined(__GNUC__) && __GNUC__ >= 8
#define DHGEN_UNROLLED _Pragma("GCC unroll 2")
#define DHGEN_WRITTEN_OUT _Pragma("GCC unroll 16") /* short loops also without -O3 */
#else
#define DHGEN_UNROLLED
#define DHGEN_WRITTEN_OUT
#endif

/* The ends of a joint's range, with the slack of its limits. */
DHGEN_INLINE double dhgen_low(const struct dhgen_joint *joint)
{
    return joint->lowest - joint->slack;
}

DHGEN_INLINE double dhgen_high(const struct dhgen_joint *joint)
{
    return joint->highest + joint->slack;
}

/* Numbers among lanes, by names like those of lanes. */
typedef double dhgen_double;
#define dhgen_sqrt_double sqrt
#define dhgen_abs_double fabs
#define dhgen_sin_double sin
#define dhgen_cos_double cos

DHGEN_INLINE double dhgen_maximum_double(double a, double b)
{
    return a > b ? a : b;
}

#if defined(__AVX2__) && defined(__GNUC__) && (defined(__clang__) || __GNUC__ >= 12) \
    && !defined(DHGEN_SCALAR) && !defined(DHGEN_LIBM) && !defined(__CUDACC__)
#include "vectors.h"
#else
#include "scalars.h"
#endif

/* How far the rotation part is from orthonormal and right-handed, as a sum of squares. */
DHGEN_INLINE dhgen_wide dhgen_misfit_wide(const dhgen_wide *T)
{
    const dhgen_wide x0 = T[0], x1 = T[1], x2 = T[2];
    const dhgen_wide y0 = T[4], y1 = T[5], y2 = T[6];
    const dhgen_wide xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0;
    const dhgen_wide yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0;
    const dhgen_wide xy = x0 * y0 + x1 * y1 + x2 * y2;
    const dhgen_wide zx = x1 * y2 - x2 * y1 - T[8];
    const dhgen_wide zy = x2 * y0 - x0 * y2 - T[9];
    const dhgen_wide zz = x0 * y1 - x1 * y0 - T[10];
    return xx * xx + yy * yy + 2.0 * xy * xy + zx * zx + zy * zy + zz * zz;
}

/* How far the whole of a pose is from one, as a sum of squares; NaN if it is not finite. */
DHGEN_INLINE dhgen_wide dhgen_pose_misfit_wide(const dhgen_wide *T)
{
    const dhgen_wide w0 = T[12], w1 = T[13], w2 = T[14], w3 = T[15] - 1.0;
    return dhgen_misfit_wide(T) + w0 * w0 + w1 * w1 + w2 * w2 + w3 * w3;
}

/* How far the tool's z axis is from one long. */
DHGEN_INLINE dhgen_wide dhgen_approach_misfit_wide(const dhgen_wide *T)
{
    const dhgen_wide zz = T[2] * T[2] + T[6] * T[6] + T[10] * T[10] - 1.0;
    return zz * zz;
}

/* By how much the sine of the pitch is above one; NaN if it is not finite. */
DHGEN_INLINE dhgen_wide dhgen_pitch_misfit_wide(const dhgen_wide *T)
{
    const dhgen_wide over = dhgen_maximum_wide(dhgen_abs_wide(T[8]), 0.0 * T[8] + 1.0) - 1.0;
    return over * over + 0.0 * T[8];
}

/* How far the third row is from one long. */
DHGEN_INLINE dhgen_wide dhgen_tilt_misfit_wide(const dhgen_wide *T)
{
    const dhgen_wide zz = T[8] * T[8] + T[9] * T[9] + T[10] * T[10] - 1.0;
    return zz * zz;
}

#endif

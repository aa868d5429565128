/* SPDX-License-Identifier: MIT
 *
 * Quotients in the fast path: in C what is written. In CUDA a division's rare cases cost more than
 * all else, registers and branches, so there they are left out: what is divided by must be neither
 * subnormal nor above 1e307. Poses at which it is are left to the careful functions. */
#ifndef DHGEN_QUOTIENT_H
#define DHGEN_QUOTIENT_H

#include "interface.h"

/* The quotient of a and b, from an estimate of 1 / b that is right to six digits: within one of the
 * last place. */
DHGEN_INLINE double dhgen_quotient_by(double estimate, double a, double b)
{
    const double off = fma(-b, estimate, 1.0);
    const double inverse = fma(estimate, fma(off, off, off), estimate), first = a * inverse;
    return fma(fma(-b, first, a), inverse, first);
}

#ifdef __CUDA_ARCH__
DHGEN_INLINE double dhgen_quotient(double a, double b)
{
#ifndef DHGEN_SINGLE_PRECISION
    double estimate;
    asm("rcp.approx.ftz.f64 %0, %1;" : "=d"(estimate) : "d"(b));
    return dhgen_quotient_by(estimate, a, b);
#else
    return __fdividef(a, b); /* within two of the last place */
#endif
}
#define DHGEN_QUOTIENT(a, b) dhgen_quotient(a, b)
#else
#define DHGEN_QUOTIENT(a, b) ((a) / (b))
#endif

#endif

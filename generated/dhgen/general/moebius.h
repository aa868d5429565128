/* SPDX-License-Identifier: MIT
 *
 * A map of the circle that magnifies where roots crowd. */
#ifndef DHGEN_GENERAL_MOEBIUS_H
#define DHGEN_GENERAL_MOEBIUS_H

#include "circle_tables.h"

/* How far the mean of the roots is from the circle's middle: not at all when they are spread
 * evenly, by one when they lie together. Beyond this, squared, roots are spread. */
#define DHGEN_CROWDED 0.12249999999999998
/* How far they are spread at most: |a|. */
#define DHGEN_STRONGEST 0.9
/* The mean of the roots over the first harmonic of log |f|: -1 / (24 8). */
#define DHGEN_MEAN_PER_HARMONIC (-0.005208333333333333)

/* A Moebius map of the circle, a lens: e^(i phi) = (w + a) / (1 + conj(a) w) with a = x + i y
 * inside the circle maps the circle of w = e^(i psi) to itself and shows what lies around the
 * direction of a larger. Where all roots lie together, as near the boundary of reach, f drowns in
 * rounding without it. */
typedef struct {
    double x, y;
} dhgen_moebius;

/* Cosine and sine of phi from cosine and sine of psi. Returns |1 + conj(a) w|^2, whose eighth power
 * makes of f a polynomial in psi. */
DHGEN_INLINE dhgen_lane dhgen_apply_moebius(const dhgen_moebius *a, dhgen_lane *c, dhgen_lane *s)
{
    const dhgen_lane u = *c + a->x, v = *s + a->y;
    const dhgen_lane d = 1.0 + a->x * *c + a->y * *s, e = a->x * *s - a->y * *c;
    const dhgen_lane square = d * d + e * e;
    *c = (u * d + v * e) / square;
    *s = (v * d - u * e) / square;
    return square;
}

/* The samples of f in phi become samples of a polynomial in psi. */
DHGEN_INLINE dhgen_lane dhgen_weighted(dhgen_lane f, dhgen_lane square)
{
    const dhgen_lane fourth = square * square, eighth = fourth * fourth;
    return f * (eighth * eighth);
}

/* The map under which the roots are spread, from samples without one; 0 when they are already. log
 * |f| is a sum over the roots z, and the first harmonic of log |e^(i phi) - z| is -z for z inside
 * the circle, that of its mirror image for z outside. */
DHGEN_FN int dhgen_spreading_moebius(const double samples[DHGEN_SAMPLES], dhgen_moebius *a)
{
    double x = 0.0, y = 0.0, square, part;
    for (int k = 0; k < 12; k++) {
        const double ratio =
            log((fabs(samples[k]) + DHGEN_TINY) / (fabs(samples[k + 12]) + DHGEN_TINY));
        x += ratio * dhgen_sample_c[k];
        y += ratio * dhgen_sample_s[k];
    }
    x *= DHGEN_MEAN_PER_HARMONIC;
    y *= DHGEN_MEAN_PER_HARMONIC;
    square = x * x + y * y;
    if (!(square > DHGEN_CROWDED)) {
        return 0;
    }
    part = fmin(1.0, DHGEN_STRONGEST / sqrt(square));
    a->x = part * x;
    a->y = part * y;
    return 1;
}

/* Roots in phi from roots in psi. */
DHGEN_FN void dhgen_undo_moebius(const dhgen_moebius *a, int count, double *cosine, double *sine)
{
    for (int i = 0; i < count; i += DHGEN_GENERAL_LANES) {
        dhgen_lane c = DHGEN_LOAD_SOME(cosine + i, count - i);
        dhgen_lane s = DHGEN_LOAD_SOME(sine + i, count - i);
        (void)dhgen_apply_moebius(a, &c, &s);
        DHGEN_SPREAD(cosine + i, c, count - i);
        DHGEN_SPREAD(sine + i, s, count - i);
    }
}

#endif

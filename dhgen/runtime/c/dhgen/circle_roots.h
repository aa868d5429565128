/* SPDX-License-Identifier: MIT
 *
 * Roots of a trigonometric polynomial of degree two on the circle. */
#ifndef DHGEN_CIRCLE_ROOTS_H
#define DHGEN_CIRCLE_ROOTS_H

#include "interface.h"

/* Points of the circle where a polynomial is tried, and steps to a root, at most. */
#define DHGEN_DIRECTIONS 16
#define DHGEN_NEWTON_STEPS 100
/* An extremum this near to zero, relative to the coefficients, is a double root: rounding of these
 * may move it either way. */
#define DHGEN_DOUBLE_ROOT 1e-13
/* Where the slope is above this, relative to the coefficients, a Newton step improves a root;
 * below, it may leap away. */
#define DHGEN_SIMPLE_ROOT 1e-4

/* The value of a polynomial of degree four. */
DHGEN_FN double dhgen_horner(const double p[5], double t)
{
    return (((p[4] * t + p[3]) * t + p[2]) * t + p[1]) * t + p[0];
}

/* The root between two points with values of unlike sign. */
DHGEN_FN double dhgen_bracketed_root(const double p[5], double low, double high, double at_low)
{
    double t = 0.5 * (low + high);
    for (int k = 0; k < DHGEN_NEWTON_STEPS; k++) {
        const double value = dhgen_horner(p, t);
        const double slope = ((4.0 * p[4] * t + 3.0 * p[3]) * t + 2.0 * p[2]) * t + p[1];
        if ((value < 0.0) == (at_low < 0.0))
            low = t;
        else
            high = t;
        double following = slope != 0.0 ? t - value / slope : low;
        if (!(low < following && following < high))
            following = 0.5 * (low + high);
        if (fabs(following - t) <= 2e-16 * fabs(t))
            return following;
        t = following;
    }
    return t;
}

/* Roots of a polynomial that is monotone between neighbouring edges. */
DHGEN_FN int dhgen_monotone_roots(
    const double p[5], const double *edges, int count, double tolerance, double *found)
{
    int roots = 0;
    double before = edges[0], at_before = dhgen_horner(p, edges[0]);
    for (int k = 1; k < count; k++) {
        const double edge = edges[k], size = 1.0 + edge * edge;
        double value = dhgen_horner(p, edge);
        if (k < count - 1 && fabs(value) <= tolerance * size * size)
            value = 0.0;
        if (at_before * value < 0.0)
            found[roots++] = dhgen_bracketed_root(p, before, edge, at_before);
        else if (!(value < 0.0 || value > 0.0) && k < count - 1)
            found[roots++] = edge;
        before = edge;
        at_before = value;
    }
    return roots;
}

/* Roots, ascending in (-pi, pi], of a0 + a1 cos x + b1 sin x + a2 cos 2x + b2 sin 2x; else NaN.
 * Seen from a point where it is large, it is a quartic in the half-angle tangent with a large
 * leading coefficient; its roots lie between those of its derivative, those between the roots of
 * the second. They are `close` where the slope is small: there may be a second root at or near it.
 * Rounding may add so much to values. All roots are `moved` by an angle in the end. */
DHGEN_FN void dhgen_circle_roots(double a0, double a1, double b1, double a2, double b2,
    double rounding, double moved, double x[4], int close[4])
{
    const double size = fabs(a0) + fabs(a1) + fabs(b1) + fabs(a2) + fabs(b2);
    double best = -1.0, apart = 0.0, edges[5], extrema[4];
    int count = 0;
    x[0] = x[1] = x[2] = x[3] = DHGEN_NAN;
    close[0] = close[1] = close[2] = close[3] = 0;
    if (!(size > 0.0 && isfinite(size)))
        return;
    for (int k = 0; k < DHGEN_DIRECTIONS; k++) {
        const double at = DHGEN_TURN * k / DHGEN_DIRECTIONS, c = cos(at), s = sin(at);
        const double value = fabs(a0 + a1 * c + b1 * s + a2 * (c * c - s * s) + 2.0 * b2 * c * s);
        if (value > best) {
            best = value;
            apart = at;
        }
    }
    const double c = -cos(apart), s = -sin(apart), c2 = c * c - s * s, s2 = 2.0 * c * s;
    const double u1 = a1 * c + b1 * s, v1 = b1 * c - a1 * s;
    const double u2 = a2 * c2 + b2 * s2, v2 = b2 * c2 - a2 * s2;
    const double lead = a0 - u1 + u2;
    const double p[5] = { (a0 + u1 + u2) / lead, 2.0 * (v1 + 2.0 * v2) / lead,
        2.0 * (a0 - 3.0 * u2) / lead, 2.0 * (v1 - 2.0 * v2) / lead, 1.0 };
    const double slope[5] = { p[1], 2.0 * p[2], 3.0 * p[3], 4.0, 0.0 };
    const double bound = 1.0 + fmax(fmax(fabs(p[0]), fabs(p[1])), fmax(fabs(p[2]), fabs(p[3])));
    const double half = 0.25 * p[3], square = half * half - p[2] / 6.0;
    edges[0] = -bound;
    if (square > 0.0) {
        edges[1] = -half - sqrt(square);
        edges[2] = -half + sqrt(square);
        count = 2;
    }
    edges[count + 1] = bound;
    count = dhgen_monotone_roots(slope, edges, count + 2, 0.0, extrema);
    for (int k = 0; k < count; k++)
        edges[k + 1] = extrema[k];
    edges[count + 1] = bound;
    const double tolerance = (DHGEN_DOUBLE_ROOT * size + rounding) / fabs(lead);
    count = dhgen_monotone_roots(p, edges, count + 2, tolerance, x);
    for (int k = 0; k < count; k++) {
        double at = apart + 0.5 * DHGEN_TURN + 2.0 * atan(x[k]);
        const double ca = cos(at), sa = sin(at);
        const double rate = b1 * ca - a1 * sa + 2.0 * b2 * (ca * ca - sa * sa) - 4.0 * a2 * ca * sa;
        const int flat = fabs(rate) <= DHGEN_SIMPLE_ROOT * size;
        if (!flat)
            at -= (a0 + a1 * ca + b1 * sa + a2 * (ca * ca - sa * sa) + 2.0 * b2 * ca * sa) / rate;
        at -= DHGEN_TURN * ceil(at / DHGEN_TURN - 0.5);
        int place = k;
        for (; place > 0 && x[place - 1] > at; place--) {
            x[place] = x[place - 1];
            close[place] = close[place - 1];
        }
        x[place] = at;
        close[place] = flat;
    }
    for (int k = 0; k < 4; k++)
        x[k] += moved;
}

#endif

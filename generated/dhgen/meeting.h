/* SPDX-License-Identifier: MIT
 *
 * Where circles in the plane meet, and spheres. */
#ifndef DHGEN_MEETING_H
#define DHGEN_MEETING_H

#include "parallel.h"

/* A pose is tried where squares of lengths leave so little below zero [squares of robot sizes], or
 * a polynomial at an extremum, beside its largest coefficient. Rounding leaves 1e-15 of them, and
 * more where coefficients cancel; what is tried and is none does not close when it is refined. */
#define DHGEN_TOUCHES 1e-9
/* Centres that are no farther apart are one [robot sizes]. */
#define DHGEN_ONE_CENTER 1e-9
/* Where two circles meet, by their centres and radii in the plane. Returns at how many points, or
 * minus DHGEN_FREE_JOINT where they are one circle. */
DHGEN_FN int dhgen_meet_circles(
    double size, const double *one, const double *other, double r, double s, double points[2][2])
{
    const double x = other[0] - one[0], y = other[1] - one[1], square = x * x + y * y;
    if (!(square > DHGEN_ONE_CENTER * DHGEN_ONE_CENTER * size * size))
        return fabs(r * r - s * s) <= DHGEN_TOUCHES * size * size ? -DHGEN_FREE_JOINT : 0;
    const double along = 0.5 * (square + r * r - s * s) / square;
    const double beside = r * r / square - along * along;
    if (!(beside >= -DHGEN_TOUCHES * size * size / square))
        return 0;
    const double h = sqrt(fmax(beside, 0.0));
    for (int i = 0; i < 2; i++) {
        const double sign = i == 0 ? 1.0 : -1.0;
        points[i][0] = one[0] + along * x - sign * h * y;
        points[i][1] = one[1] + along * y + sign * h * x;
    }
    return 2;
}

/* Where three spheres meet (F. Thomas and L. Ros, Revisiting trilateration for robot localization,
 * 2005, in coordinates). Returns at how many points, or minus DHGEN_FREE_JOINT where they have a
 * circle in common, or are one sphere. */
DHGEN_FN int dhgen_meet_spheres(
    double size, const double centers[3][3], const double *r, double points[2][3])
{
    const double touches = DHGEN_TOUCHES * size * size;
    double apart[3] = { 0.0, 0.0, 0.0 }, x[3], y[3], i = 0.0, j = 0.0;
    for (int n = 1; n < 3; n++)
        for (int k = 0; k < 3; k++)
            apart[n] += (centers[n][k] - centers[0][k]) * (centers[n][k] - centers[0][k]);
    const int one = apart[2] > apart[1] ? 2 : 1, other = 3 - one;
    const double d = sqrt(apart[one]), from = r[0] * r[0] - r[one] * r[one];
    const double from_other = r[0] * r[0] - r[other] * r[other];
    if (!(d > DHGEN_ONE_CENTER * size))
        return fabs(from) <= touches && fabs(from_other) <= touches ? -DHGEN_FREE_JOINT : 0;
    for (int k = 0; k < 3; k++) {
        x[k] = (centers[one][k] - centers[0][k]) / d;
        i += x[k] * (centers[other][k] - centers[0][k]);
    }
    for (int k = 0; k < 3; k++) {
        y[k] = centers[other][k] - centers[0][k] - i * x[k];
        j += y[k] * y[k];
    }
    j = sqrt(j);
    const double u = 0.5 * (d + from / d);
    const int in_line = !(j > DHGEN_ONE_CENTER * size);
    if (in_line && !(fabs(from_other + i * i - 2.0 * i * u) <= touches))
        return 0;
    const double v = in_line ? 0.0 : 0.5 * (j + (from_other + i * i) / j) - i * u / j;
    const double square = r[0] * r[0] - u * u - v * v;
    if (!(square >= -touches))
        return 0;
    if (in_line && square > touches)
        return -DHGEN_FREE_JOINT;
    const double w = (one == 1 ? 1.0 : -1.0) * sqrt(fmax(square, 0.0));
    for (int k = 0; k < 3; k++)
        y[k] /= in_line ? 1.0 : j;
    for (int k = 0; k < 3; k++) {
        const int e = (k + 1) % 3, f = (k + 2) % 3;
        const double across = in_line ? 0.0 : w * (x[e] * y[f] - x[f] * y[e]);
        points[0][k] = centers[0][k] + u * x[k] + v * y[k] + across;
        points[1][k] = centers[0][k] + u * x[k] + v * y[k] - across;
    }
    return 2;
}

#endif

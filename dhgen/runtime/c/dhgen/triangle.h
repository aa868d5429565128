/* SPDX-License-Identifier: MIT
 *
 * A platform in the plane that three points carry, each of which goes around a circle. */
#ifndef DHGEN_TRIANGLE_H
#define DHGEN_TRIANGLE_H

#include "meeting.h"

#define DHGEN_DEGREE 6
/* Two assemblies that are no farther apart are one [rad, robot sizes]: a root of what legs may
 * miss. */
#define DHGEN_ONE_ASSEMBLY 1e-6
/* Where both equations of a platform on three circles have rows no longer than this [robot sizes]
 * it nearly goes around: up to four roots have nearly merged, none has more than a fourth of the
 * digits, and so many places on the first point's circle are tried. */
#define DHGEN_NEARLY_AROUND 1e-3
#define DHGEN_PLACES_AROUND 8

/* The value of a polynomial, the lowest coefficient first. */
DHGEN_INLINE double dhgen_polynomial(const double *p, int degree, double x)
{
    double value = p[degree];
    for (int k = degree - 1; k >= 0; k--)
        value = value * x + p[k];
    return value;
}

/* The real roots of a polynomial whose highest coefficient is not zero, ascending: between the
 * roots of its derivative there is one, or none. Where it touches zero there is one, too; beside a
 * change of sign it does not touch: that root is found, and a pair nearly merged is two of them. */
DHGEN_FN int dhgen_real_roots(const double *p, int degree, double *roots)
{
    double d[DHGEN_DEGREE + 1], found[DHGEN_DEGREE + 2], largest = 0.0;
    int count = 0;
    for (int order = 1; order <= degree; order++) {
        /* the derivative that has this degree */
        for (int k = 0; k <= order; k++) {
            d[k] = p[k + degree - order];
            for (int j = 0; j < degree - order; j++)
                d[k] *= k + degree - order - j;
        }
        double bound = 0.0, next[DHGEN_DEGREE + 1];
        largest = fabs(d[order]);
        for (int k = 0; k < order; k++) {
            bound = fmax(bound, fabs(d[k] / d[order]));
            largest = fmax(largest, fabs(d[k]));
        }
        int kept = 0, changed = 1; /* nothing touches zero at the bound */
        double low = -1.0 - bound;
        for (int k = 0; k <= count; k++) {
            const double high = k < count ? found[k] : 1.0 + bound;
            const double at_low = dhgen_polynomial(d, order, low);
            const int changes = (at_low < 0.0) != (dhgen_polynomial(d, order, high) < 0.0);
            const int touches =
                fabs(at_low) <= DHGEN_TOUCHES * largest * (1.0 + pow(fabs(low), order));
            if (order == degree && touches && !changed && !changes && kept < order)
                next[kept++] = low;
            if (changes && kept < order) {
                double a = low, b = high;
                for (int i = 0; i < 80 && a < b; i++) {
                    const double middle = 0.5 * (a + b);
                    if ((dhgen_polynomial(d, order, middle) < 0.0) == (at_low < 0.0))
                        a = middle;
                    else
                        b = middle;
                }
                next[kept++] = 0.5 * (a + b);
            }
            changed = changes;
            low = high;
        }
        count = kept;
        for (int k = 0; k < count; k++)
            found[k] = next[k];
    }
    for (int k = 0; k < count; k++)
        roots[k] = found[k];
    return count;
}

/* A platform on three circles. Its first point goes around the origin, |p| = r, and the two others
 * are at e and f in the platform and around E and F: with R the turn by phi,
 *     2 (R e - E) . p = s^2 - r^2 - |e|^2 - |E|^2 + 2 E . R e,
 * and likewise for f. These are linear in p, their determinant and the numerators are known
 * functions of phi, and |p| = r is a polynomial of degree three in cos phi and sin phi, of degree
 * six in tan(phi/2) (C. Gosselin, J. Sefrioui and M. Richard, 1992). */
struct dhgen_triangle {
    double e[2][2], E[2][2], r, s[2];
};

/* The two linear equations at an angle: rows, right sides and determinant. */
DHGEN_FN double dhgen_triangle_rows(
    const struct dhgen_triangle *of, double angle, double rows[2][2], double *right)
{
    const double c = cos(angle), s = sin(angle);
    for (int i = 0; i < 2; i++) {
        const double x = c * of->e[i][0] - s * of->e[i][1], y = s * of->e[i][0] + c * of->e[i][1];
        rows[i][0] = x - of->E[i][0];
        rows[i][1] = y - of->E[i][1];
        right[i] = 0.5
                * (of->s[i] * of->s[i] - of->r * of->r - x * x - y * y - of->E[i][0] * of->E[i][0]
                    - of->E[i][1] * of->E[i][1])
            + of->E[i][0] * x + of->E[i][1] * y;
    }
    return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
}

/* What |p| = r misses at an angle, times the square of the determinant. */
DHGEN_FN double dhgen_triangle_miss(const struct dhgen_triangle *of, double angle)
{
    double rows[2][2], right[2];
    const double d = dhgen_triangle_rows(of, angle, rows, right);
    const double x = right[0] * rows[1][1] - right[1] * rows[0][1];
    const double y = rows[0][0] * right[1] - rows[1][0] * right[0];
    return x * x + y * y - of->r * of->r * d * d;
}

/* The angles of the platform: at most six. */
DHGEN_FN int dhgen_triangle_angles(const struct dhgen_triangle *of, double *angles)
{
    double a[4] = { 0.0, 0.0, 0.0, 0.0 }, b[4] = { 0.0, 0.0, 0.0, 0.0 }, values[7], p[7];
    double start = 0.0, largest = -1.0;
    /* half a turn away from where tan(phi/2) is zero there is no root */
    for (int k = 0; k < 28; k++) {
        const double angle = DHGEN_TURN * k / 28, value = fabs(dhgen_triangle_miss(of, angle));
        if (value > largest) {
            largest = value;
            start = angle - DHGEN_HALF_TURN;
        }
    }
    if (!(largest > 0.0 && isfinite(largest)))
        return 0;
    for (int k = 0; k < 7; k++)
        values[k] = dhgen_triangle_miss(of, start + DHGEN_TURN * k / 7) / largest;
    for (int n = 0; n < 4; n++)
        for (int k = 0; k < 7; k++) {
            a[n] += (n ? 2.0 : 1.0) / 7.0 * values[k] * cos(DHGEN_TURN * n * k / 7);
            b[n] += (n ? 2.0 : 1.0) / 7.0 * values[k] * sin(DHGEN_TURN * n * k / 7);
        }
    for (int k = 0; k < 7; k++)
        p[k] = 0.0;
    for (int n = 0; n < 4; n++) {
        /* (1 + t^2)^3 (cos + i sin)(n phi) = (1 + i t)^(3 + n) (1 - i t)^(3 - n) */
        double x[8] = { 1.0 }, y[8] = { 0.0 };
        for (int factor = 0; factor < 6; factor++) {
            const double sign = factor < 3 + n ? 1.0 : -1.0;
            for (int k = factor + 1; k > 0; k--) {
                x[k] -= sign * y[k - 1];
                y[k] += sign * x[k - 1];
            }
        }
        for (int k = 0; k < 7; k++)
            p[k] += a[n] * x[k] + b[n] * y[k];
    }
    const int count = dhgen_real_roots(p, 6, angles);
    for (int k = 0; k < count; k++)
        angles[k] = start + 2.0 * atan(angles[k]);
    return count;
}

/* Whether the platform is as large as the base, on equal circles: then it can go around. */
DHGEN_FN int dhgen_goes_around(const struct dhgen_triangle *of, double size)
{
    const double(*const e)[2] = of->e, (*const E)[2] = of->E;
    const double square = e[0][0] * e[0][0] + e[0][1] * e[0][1];
    const double c = (e[0][0] * E[0][0] + e[0][1] * E[0][1]) / square;
    const double s = (e[0][0] * E[0][1] - e[0][1] * E[0][0]) / square;
    double most = 0.0;
    for (int i = 0; i < 2; i++) {
        most = fmax(most, fabs(c * e[i][0] - s * e[i][1] - E[i][0]));
        most = fmax(most, fabs(s * e[i][0] + c * e[i][1] - E[i][1]));
        most = fmax(most, fabs(of->s[i] - of->r));
    }
    return square > 0.0 && fabs(c * c + s * s - 1.0) * sqrt(square) <= DHGEN_ONE_ASSEMBLY * size
        && most <= DHGEN_ONE_ASSEMBLY * size;
}

/* The places of the first point at an angle of the platform. Returns how many there are. */
DHGEN_FN int dhgen_triangle_points(const struct dhgen_triangle *of, double angle, double size,
    double points[DHGEN_PLACES_AROUND][2])
{
    double rows[2][2], right[2];
    const double d = dhgen_triangle_rows(of, angle, rows, right);
    const double longest[2] = { rows[0][0] * rows[0][0] + rows[0][1] * rows[0][1],
        rows[1][0] * rows[1][0] + rows[1][1] * rows[1][1] };
    const double least = DHGEN_ONE_ASSEMBLY * DHGEN_ONE_ASSEMBLY * size * size;
    const double around = DHGEN_NEARLY_AROUND * DHGEN_NEARLY_AROUND * size * size;
    const int i = longest[0] < longest[1];
    if (!(longest[i] > around)) {
        for (int k = 0; k < DHGEN_PLACES_AROUND; k++) {
            points[k][0] = of->r * cos(DHGEN_TURN * k / DHGEN_PLACES_AROUND);
            points[k][1] = of->r * sin(DHGEN_TURN * k / DHGEN_PLACES_AROUND);
        }
        return DHGEN_PLACES_AROUND;
    }
    if (fabs(d) > DHGEN_ONE_ASSEMBLY * sqrt(longest[0] * longest[1]) && longest[1 - i] > least) {
        points[0][0] = (right[0] * rows[1][1] - right[1] * rows[0][1]) / d;
        points[0][1] = (rows[0][0] * right[1] - rows[1][0] * right[0]) / d;
        return 1;
    }
    /* both lines are one, or one is none: the other meets the circle twice */
    const double along = right[i] / longest[i];
    const double beside = sqrt(fmax(of->r * of->r / longest[i] - along * along, 0.0));
    for (int k = 0; k < 2; k++) {
        const double sign = k == 0 ? 1.0 : -1.0;
        points[k][0] = along * rows[i][0] - sign * beside * rows[i][1];
        points[k][1] = along * rows[i][1] + sign * beside * rows[i][0];
    }
    return 2;
}

#endif

/* SPDX-License-Identifier: MIT
 *
 * All poses of a platform that drives' values allow, for platforms whose legs, the drives being
 * held, let what they carry go around a point: on circles in the plane, or on spheres. */
#ifndef DHGEN_ASSEMBLIES_H
#define DHGEN_ASSEMBLIES_H

#include "direct.h"

#define DHGEN_MOST_ASSEMBLIES 6
#define DHGEN_DEGREE 6
/* A pose is tried where squares of lengths leave so little below zero [squares of robot sizes], or
 * a polynomial at an extremum, beside its largest coefficient. Rounding leaves 1e-15 of them, and
 * more where coefficients cancel; what is tried and is none does not close when it is refined. */
#define DHGEN_TOUCHES 1e-9
/* Centres that are no farther apart are one [robot sizes]. */
#define DHGEN_ONE_CENTER 1e-9
/* Two assemblies that are no farther apart are one [rad, robot sizes]: a root of what legs may
 * miss. */
#define DHGEN_ONE_ASSEMBLY 1e-6

enum {
    DHGEN_TWO_CIRCLES,   /* one point on two legs, in the plane */
    DHGEN_THREE_CIRCLES, /* a platform on three legs, in the plane */
    DHGEN_THREE_SPHERES  /* a platform that does not turn, on three legs */
};

/* Around which point a leg lets go what it carries while its drives are held, and how far from it,
 * in the robot's base: where its passive axes meet. */
DHGEN_FN double dhgen_leg_center(
    const struct dhgen_parallel *robot, int number, const double *drives, double *center)
{
    const struct dhgen_leg *const leg = robot->leg + number;
    double q[DHGEN_MOST_JOINTS] = { 0.0 }, T[16], J[6 * DHGEN_MOST_JOINTS];
    double points[2][3] = { { 0.0 } }, lines[2][3] = { { 0.0 } }, own[3];
    int found = 0;
    for (int k = 0; k < leg->drives; k++)
        q[leg->driven[k]] = drives[k];
    leg->fk(q, T);
    leg->jacobian(q, J);
    for (int joint = 0, next = 0; joint < leg->joints; joint++) {
        if (next < leg->drives && leg->driven[next] == joint) {
            next++;
            continue;
        }
        if (found == 2)
            continue;
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            const double *const w = J + 3 * leg->joints, *const v = J;
            lines[found][i] = w[leg->joints * i + joint];
            points[found][i] = T[4 * i + 3]
                + w[leg->joints * j + joint] * v[leg->joints * k + joint]
                - w[leg->joints * k + joint] * v[leg->joints * j + joint];
        }
        found++;
    }
    double along = 0.0;
    if (found == 2) { /* where the first axis is nearest to the second */
        double both = 0.0, first = 0.0, second = 0.0;
        for (int i = 0; i < 3; i++) {
            const double apart = points[1][i] - points[0][i];
            both += lines[0][i] * lines[1][i];
            first += apart * lines[0][i];
            second += apart * lines[1][i];
        }
        along = (first - both * second) / (1.0 - both * both);
    }
    double square = 0.0;
    for (int i = 0; i < 3; i++) {
        own[i] = points[0][i] + along * lines[0][i];
        square += (T[4 * i + 3] - own[i]) * (T[4 * i + 3] - own[i]);
    }
    for (int i = 0; i < 3; i++) { /* base is the inverse of the leg's place */
        center[i] = 0.0;
        for (int k = 0; k < 3; k++)
            center[i] += leg->base[4 * k + i] * (own[k] - leg->base[4 * k + 3]);
    }
    return sqrt(square);
}

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

/* Where two circles meet, by their centres and radii in the plane. */
DHGEN_FN int dhgen_meet_circles(
    double size, const double *one, const double *other, double r, double s, double points[2][2])
{
    const double x = other[0] - one[0], y = other[1] - one[1], square = x * x + y * y;
    if (!(square > DHGEN_ONE_CENTER * DHGEN_ONE_CENTER * size * size))
        return 0;
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
 * 2005, in coordinates). */
DHGEN_FN int dhgen_meet_spheres(
    double size, const double centers[3][3], const double *r, double points[2][3])
{
    double x[3], y[3], z[3], i = 0.0, d = 0.0, j = 0.0;
    for (int k = 0; k < 3; k++)
        d += (centers[1][k] - centers[0][k]) * (centers[1][k] - centers[0][k]);
    d = sqrt(d);
    if (!(d > DHGEN_ONE_CENTER * size))
        return 0;
    for (int k = 0; k < 3; k++) {
        x[k] = (centers[1][k] - centers[0][k]) / d;
        i += x[k] * (centers[2][k] - centers[0][k]);
    }
    for (int k = 0; k < 3; k++) {
        y[k] = centers[2][k] - centers[0][k] - i * x[k];
        j += y[k] * y[k];
    }
    j = sqrt(j);
    if (!(j > DHGEN_ONE_CENTER * size))
        return 0;
    for (int k = 0; k < 3; k++)
        y[k] /= j;
    for (int k = 0; k < 3; k++)
        z[k] = x[(k + 1) % 3] * y[(k + 2) % 3] - x[(k + 2) % 3] * y[(k + 1) % 3];
    const double u = 0.5 * (d + (r[0] * r[0] - r[1] * r[1]) / d);
    const double v = 0.5 * (j + (r[0] * r[0] - r[2] * r[2] + i * i) / j) - i * u / j;
    const double square = r[0] * r[0] - u * u - v * v;
    if (!(square >= -DHGEN_TOUCHES * size * size))
        return 0;
    const double w = sqrt(fmax(square, 0.0));
    for (int k = 0; k < 3; k++) {
        points[0][k] = centers[0][k] + u * x[k] + v * y[k] + w * z[k];
        points[1][k] = centers[0][k] + u * x[k] + v * y[k] - w * z[k];
    }
    return 2;
}

/* A platform on three circles. Its first point goes around the origin, |p| = r, and the two others
 * are at e and f in the platform and around E and F: with R the turn by phi,
 *     2 (R e - E) . p = s^2 - r^2 - |e|^2 - |E|^2 + 2 E . R e,
 * and the same for f. These are linear in p, their determinant and what stands over it are known
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

/* The places of the first point at an angle of the platform. */
DHGEN_FN int dhgen_triangle_points(
    const struct dhgen_triangle *of, double angle, double size, double points[2][2])
{
    double rows[2][2], right[2];
    const double d = dhgen_triangle_rows(of, angle, rows, right);
    const double longest[2] = { rows[0][0] * rows[0][0] + rows[0][1] * rows[0][1],
        rows[1][0] * rows[1][0] + rows[1][1] * rows[1][1] };
    if (fabs(d) > DHGEN_ONE_ASSEMBLY * sqrt(longest[0] * longest[1])) {
        points[0][0] = (right[0] * rows[1][1] - right[1] * rows[0][1]) / d;
        points[0][1] = (rows[0][0] * right[1] - rows[1][0] * right[0]) / d;
        return 1;
    }
    /* both lines are one: it meets the circle twice */
    const int i = longest[0] < longest[1];
    if (!(longest[i] > DHGEN_TOUCHES * size * size))
        return 0;
    const double along = right[i] / longest[i];
    const double beside = sqrt(fmax(of->r * of->r / longest[i] - along * along, 0.0));
    for (int k = 0; k < 2; k++) {
        const double sign = k == 0 ? 1.0 : -1.0;
        points[k][0] = along * rows[i][0] - sign * beside * rows[i][1];
        points[k][1] = along * rows[i][1] + sign * beside * rows[i][0];
    }
    return 2;
}

/* Keeps a pose that is refined from a place and an angle of the platform, if it is one and new.
 * Returns how many are kept. */
DHGEN_FN int dhgen_keep_assembly(const struct dhgen_parallel *robot, const double *drives,
    const double *place, double angle, int count, double *poses)
{
    double T[16] = { 0.0 }, found[16], q[DHGEN_MOST_LEGS * DHGEN_MOST_JOINTS];
    T[0] = T[5] = cos(angle);
    T[4] = sin(angle);
    T[1] = -T[4];
    T[10] = T[15] = 1.0;
    for (int i = 0; i < 3; i++)
        T[4 * i + 3] = place[i];
    if (count == DHGEN_MOST_ASSEMBLIES || dhgen_parallel_fk(robot, drives, T, found, q) < 0)
        return count;
    for (int k = 0; k < count; k++) {
        double apart = 0.0;
        for (int i = 0; i < 12; i++)
            apart =
                fmax(apart, fabs(found[i] - poses[16 * k + i]) / (i % 4 == 3 ? robot->size : 1));
        if (apart <= DHGEN_ONE_ASSEMBLY)
            return count;
    }
    for (int i = 0; i < 16; i++)
        poses[16 * count + i] = found[i];
    return count + 1;
}

/* Whether an assembly comes before another one: by their yaw, those of one yaw by their place. */
DHGEN_FN int dhgen_comes_before(double size, const double *one, const double *other)
{
    double yaw[2] = { atan2(one[4], one[0]), atan2(other[4], other[0]) };
    for (int i = 0; i < 2; i++)
        yaw[i] += yaw[i] > DHGEN_ONE_ASSEMBLY - DHGEN_HALF_TURN ? 0.0 : DHGEN_TURN;
    const double apart[3] = { yaw[1] - yaw[0], (other[3] - one[3]) / size,
        (other[7] - one[7]) / size };
    for (int i = 0; i < 3; i++)
        if (fabs(apart[i]) > DHGEN_ONE_ASSEMBLY)
            return apart[i] > 0.0;
    return 0;
}

/* Takes the last of the assemblies to its place among those before it. */
DHGEN_FN void dhgen_put_in_order(double size, int count, double *poses)
{
    const double *const last = poses + 16 * (count - 1);
    int place = 0;
    while (place < count - 1 && !dhgen_comes_before(size, last, poses + 16 * place))
        place++;
    for (int i = 0; i < 16; i++) {
        const double moved = last[i];
        for (int k = count - 1; k > place; k--)
            poses[16 * k + i] = poses[16 * (k - 1) + i];
        poses[16 * place + i] = moved;
    }
}

/* The assemblies of a platform on three circles. */
DHGEN_FN int dhgen_assemblies_of_triangle(const struct dhgen_parallel *robot, const double *drives,
    const double centers[3][3], const double *r, double *poses)
{
    const struct dhgen_leg *const leg = robot->leg;
    struct dhgen_triangle of;
    double angles[DHGEN_DEGREE];
    int count = 0;
    of.r = r[0];
    for (int i = 0; i < 2; i++) {
        of.s[i] = r[i + 1];
        for (int k = 0; k < 2; k++) {
            of.e[i][k] = leg[i + 1].end[4 * k + 3] - leg[0].end[4 * k + 3];
            of.E[i][k] = centers[i + 1][k] - centers[0][k];
        }
    }
    const int roots = dhgen_triangle_angles(&of, angles);
    for (int n = 0; n < roots; n++) {
        double points[2][2];
        const double c = cos(angles[n]), s = sin(angles[n]);
        const int places = dhgen_triangle_points(&of, angles[n], robot->size, points);
        for (int k = 0; k < places; k++) {
            const double x = leg[0].end[3], y = leg[0].end[7];
            const double place[3] = { centers[0][0] + points[k][0] - (c * x - s * y),
                centers[0][1] + points[k][1] - (s * x + c * y), 0.0 };
            const int kept = dhgen_keep_assembly(robot, drives, place, angles[n], count, poses);
            if (kept > count)
                dhgen_put_in_order(robot->size, kept, poses);
            count = kept;
        }
    }
    return count;
}

/* All poses of the platform that drives' values allow, refined. Returns how many there are. */
DHGEN_FN int dhgen_assemblies(
    const struct dhgen_parallel *robot, int elimination, const double *drives, double *poses)
{
    double centers[3][3], r[3], points[2][3] = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
    double plane[2][2];
    int count = 0;
    for (int i = 0; i < robot->drives; i++)
        if (!isfinite(drives[i]))
            return 0;
    for (int i = 0, first = 0; i < robot->legs; i++) {
        r[i] = dhgen_leg_center(robot, i, drives + first, centers[i]);
        first += robot->leg[i].drives;
        for (int k = 0; k < 3 && elimination != DHGEN_THREE_CIRCLES; k++)
            centers[i][k] -= robot->leg[i].end[4 * k + 3];
    }
    if (elimination == DHGEN_THREE_CIRCLES)
        return dhgen_assemblies_of_triangle(robot, drives, (const double(*)[3])centers, r, poses);
    const int found = elimination == DHGEN_THREE_SPHERES
        ? dhgen_meet_spheres(robot->size, (const double(*)[3])centers, r, points)
        : dhgen_meet_circles(robot->size, centers[0], centers[1], r[0], r[1], plane);
    for (int k = 0; k < found; k++) {
        if (elimination == DHGEN_TWO_CIRCLES) {
            points[k][0] = plane[k][0];
            points[k][1] = plane[k][1];
        }
        count = dhgen_keep_assembly(robot, drives, points[k], 0.0, count, poses);
    }
    return count;
}

#endif

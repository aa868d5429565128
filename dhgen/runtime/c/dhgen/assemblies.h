/* SPDX-License-Identifier: MIT
 *
 * All poses of a platform that drives' values allow, for platforms whose legs, the drives being
 * held, let what they carry go around a point: on circles in the plane, or on spheres. */
#ifndef DHGEN_ASSEMBLIES_H
#define DHGEN_ASSEMBLIES_H

#include "direct.h"
#include "triangle.h"

#define DHGEN_MOST_ASSEMBLIES 6
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
    dhgen_set_leg_drives(leg, drives, q);
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

/* Takes the last of the assemblies to its place among the earlier ones. */
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

/* The assemblies of a platform on three circles. Returns what dhgen_assemblies does. */
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
    if (dhgen_goes_around(&of, robot->size))
        return -DHGEN_FREE_JOINT;
    const int roots = dhgen_triangle_angles(&of, angles);
    for (int n = 0; n < roots; n++) {
        double points[DHGEN_PLACES_AROUND][2];
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

/* All poses of the platform that drives' values allow, refined. Returns how many there are; minus
 * DHGEN_FREE_JOINT where they are a continuum, as the platform can move while its drives are held;
 * minus DHGEN_INVALID_POSE for drives that are not finite. */
DHGEN_FN int dhgen_assemblies(
    const struct dhgen_parallel *robot, int elimination, const double *drives, double *poses)
{
    double centers[3][3], r[3], points[2][3] = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
    double plane[2][2];
    int count = 0;
    for (int i = 0; i < robot->drives; i++)
        if (!isfinite(drives[i]))
            return -DHGEN_INVALID_POSE;
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
    return found < 0 ? found : count;
}

#endif

/* SPDX-License-Identifier: MIT
 *
 * The velocities of a platform and of its drives, A xdot = B qdot (C. Gosselin and J. Angeles,
 * Singularity analysis of closed-loop kinematic chains, 1990), and how near they are to singular.
 */
#ifndef DHGEN_PLATFORM_H
#define DHGEN_PLATFORM_H

#include "parallel.h"

/* A's smallest singular value below which a platform is singular, lengths in robot sizes, and what
 * a passive joint has to move of its own, besides those before it, not to depend on them [rad,
 * robot sizes]: the square root of what legs may miss, so that what is computed above it has six
 * digits. */
#define DHGEN_SINGULAR_PLATFORM 1e-6

/* How a leg's end moves: of its rows the first belong to passive joints after the reflections
 * below, as many as are independent, and the next to driven ones. Lengths count in robot sizes,
 * also those of the platform's motion. */
struct dhgen_leg_motion {
    int rows, passive, independent;
    double V[6][6]; /* of the platform's freedoms */
    double J[6][6]; /* of the leg's joints: passive ones first, then driven ones */
    double miss[6]; /* from where the leg ends to where the platform has it */
    int order[6];   /* the joint of each column of J */
    double unit[6]; /* of the joint of each column: slides count in sizes of the robot */
};

/* What a leg's end is away from where the platform carries it: three lengths, then the rotation
 * vector for small turns, in the leg's base. */
DHGEN_FN void dhgen_leg_miss(const double *wanted, const double *is, double size, double *miss)
{
    for (int i = 0; i < 3; i++)
        miss[i] = (wanted[4 * i + 3] - is[4 * i + 3]) / size;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        double sum = 0.0;
        for (int c = 0; c < 3; c++)
            sum += is[4 * j + c] * wanted[4 * k + c] - is[4 * k + c] * wanted[4 * j + c];
        miss[3 + i] = 0.5 * sum;
    }
}

/* The motion of a leg at a pose of the platform and its joint values. */
DHGEN_FN void dhgen_leg_motion_at(const struct dhgen_parallel *robot, int number, const double *X,
    const double *q, struct dhgen_leg_motion *motion)
{
    const struct dhgen_leg *const leg = robot->leg + number;
    double wanted[16], is[16], all[6 * DHGEN_MOST_JOINTS], miss[6];
    dhgen_leg_pose(leg, X, wanted);
    leg->fk(q, is);
    leg->jacobian(q, all);
    dhgen_leg_miss(wanted, is, robot->size, miss);
    motion->rows = leg->joints;
    motion->passive = leg->joints - leg->drives;
    int place = 0;
    for (int driven = 0; driven < 2; driven++)
        for (int joint = 0, next = 0; joint < leg->joints; joint++) {
            const int is_driven = next < leg->drives && leg->driven[next] == joint;
            next += is_driven;
            if (is_driven == driven) {
                motion->order[place] = joint;
                motion->unit[place++] = leg->types[joint] == 'P' ? robot->size : 1.0;
            }
        }
    /* the point that the leg carries, from the platform's origin, in the robot's base */
    double arm[3];
    for (int i = 0; i < 3; i++)
        arm[i] = X[4 * i] * leg->end[3] + X[4 * i + 1] * leg->end[7] + X[4 * i + 2] * leg->end[11];
    for (int i = 0; i < leg->joints; i++) {
        const int row = leg->counted[i], axis = row % 3;
        const double unit = row < 3 ? 1.0 / robot->size : 1.0;
        const double *const along = leg->base + 4 * axis;
        motion->miss[i] = miss[row];
        for (int k = 0; k < leg->joints; k++)
            motion->J[i][k] = unit * all[row * leg->joints + motion->order[k]];
        for (int k = 0; k < robot->drives; k++) {
            const int freedom = robot->freedoms[k], e = freedom % 3;
            const int f = (e + 1) % 3, g = (e + 2) % 3;
            /* turning about axis e moves the point by e x arm */
            if (freedom < 3)
                motion->V[i][k] = row < 3 ? along[e] : 0.0;
            else
                motion->V[i][k] =
                    row < 3 ? unit * (along[g] * arm[f] - along[f] * arm[g]) : along[e];
        }
    }
}

/* Reflects rows of a motion from one on, so that a joint moves only the first of them
 * (Householder), and forwards. */
DHGEN_FN void dhgen_reflect(
    const struct dhgen_parallel *robot, struct dhgen_leg_motion *motion, int row, int joint)
{
    const int m = motion->rows, last = m + robot->drives;
    double v[6] = { 0.0 }, square = 0.0, norm = 0.0;
    for (int i = row; i < m; i++)
        square += motion->J[i][joint] * motion->J[i][joint];
    const double length = motion->J[row][joint] > 0.0 ? -sqrt(square) : sqrt(square);
    for (int i = row; i < m; i++) {
        v[i] = motion->J[i][joint] - (i == row ? length : 0.0);
        norm += v[i] * v[i];
    }
    for (int column = 0; column <= last && norm > 0.0; column++) {
        double x[6] = { 0.0 }, sum = 0.0;
        for (int i = row; i < m; i++) {
            x[i] = column < m   ? motion->J[i][column]
                : column < last ? motion->V[i][column - m]
                                : motion->miss[i];
            sum += v[i] * x[i];
        }
        for (int i = row; i < m; i++) {
            double *const entry = column < m ? &motion->J[i][column]
                : column < last              ? &motion->V[i][column - m]
                                             : &motion->miss[i];
            /* backwards where the reflection turned the joint around */
            *entry = (i == row && length < 0.0 ? -1.0 : 1.0) * (x[i] - 2.0 * sum / norm * v[i]);
        }
    }
}

/* Reflects the rows of a motion so that passive joints move the first ones alone. In the next ones,
 * as many as are driven, the platform and the drives have to agree. Where passive joints depend on
 * each other rows are left over: there the leg's end can't move. */
DHGEN_FN void dhgen_without_passive(
    const struct dhgen_parallel *robot, struct dhgen_leg_motion *motion)
{
    int row = 0;
    motion->independent = 0;
    for (int joint = 0; joint < motion->rows; joint++) {
        double square = 0.0;
        for (int i = row; i < motion->rows; i++)
            square += motion->J[i][joint] * motion->J[i][joint];
        if (joint < motion->passive
            && sqrt(square) * motion->unit[joint] <= DHGEN_SINGULAR_PLATFORM)
            continue;
        motion->independent += joint < motion->passive;
        dhgen_reflect(robot, motion, row++, joint);
    }
}

/* The two matrices of A xdot = B qdot, n x n: as many rows and columns as drives. The platform's
 * freedoms are in the order of velocities, then angular velocities; B has a block for each leg, and
 * nothing below its diagonal. Returns whether they are determined: the passive joints of no leg
 * depend on each other. */
DHGEN_FN int dhgen_platform_rates(
    const struct dhgen_parallel *robot, const double *X, const double *q, double *A, double *B)
{
    const int n = robot->drives;
    int determined = 1;
    for (int i = 0; i < n * n; i++)
        A[i] = B[i] = 0.0;
    for (int i = 0, row = 0; i < robot->legs; i++) {
        struct dhgen_leg_motion motion;
        dhgen_leg_motion_at(robot, i, X, q + i * robot->joints, &motion);
        dhgen_without_passive(robot, &motion);
        determined = determined && motion.independent == motion.passive;
        const int first = row;
        for (int k = motion.independent; row < first + robot->leg[i].drives; k++, row++) {
            for (int j = 0; j < n; j++)
                A[n * row + j] = motion.V[k][j] * (robot->freedoms[j] < 3 ? 1.0 : robot->size);
            for (int j = row - first; j < robot->leg[i].drives; j++)
                B[n * row + first + j] = motion.J[k][motion.passive + j] * robot->size;
        }
    }
    return determined;
}

/* The smallest singular value of a matrix, n x n: by turning its columns until they are orthogonal
 * (M. R. Hestenes, 1958). M is used up. */
DHGEN_FN double dhgen_least_singular(int n, double *M)
{
    for (int round = 0; round < 30; round++)
        for (int i = 0; i < n; i++)
            for (int j = i + 1; j < n; j++) {
                double a = 0.0, b = 0.0, c = 0.0;
                for (int k = 0; k < n; k++) {
                    a += M[n * k + i] * M[n * k + i];
                    b += M[n * k + j] * M[n * k + j];
                    c += M[n * k + i] * M[n * k + j];
                }
                if (!(fabs(c) > 1e-16 * sqrt(a * b)))
                    continue;
                const double half = 0.5 * (b - a) / c;
                const double t = (half < 0.0 ? -1.0 : 1.0) / (fabs(half) + sqrt(1.0 + half * half));
                const double cosine = 1.0 / sqrt(1.0 + t * t), sine = cosine * t;
                for (int k = 0; k < n; k++) {
                    const double x = M[n * k + i];
                    M[n * k + i] = cosine * x - sine * M[n * k + j];
                    M[n * k + j] = sine * x + cosine * M[n * k + j];
                }
            }
    double least = HUGE_VAL;
    for (int i = 0; i < n; i++) {
        double square = 0.0;
        for (int k = 0; k < n; k++)
            square += M[n * k + i] * M[n * k + i];
        least = fmin(least, square);
    }
    return sqrt(least);
}

/* How near a robot is to a singularity of the first kind (B loses a rank: the platform loses a
 * motion) and of the second (A does: the platform has a motion that the drives do not hold): their
 * smallest singular values, lengths in robot sizes. Where passive joints of a leg depend on each
 * other the leg takes a motion away, and A is not determined: 0 and NaN. Returns whether it is. */
DHGEN_FN int dhgen_least_values(
    const struct dhgen_parallel *robot, const double *X, const double *q, double least[2])
{
    double A[36], B[36];
    const int n = robot->drives;
    if (!dhgen_platform_rates(robot, X, q, A, B)) {
        least[0] = 0.0;
        least[1] = DHGEN_NAN;
        return 0;
    }
    for (int row = 0; row < n; row++)
        for (int j = 0; j < n; j++)
            A[n * row + j] *= robot->freedoms[j] < 3 ? robot->size : 1.0;
    for (int leg = 0, j = 0; leg < robot->legs; leg++)
        for (int k = 0; k < robot->leg[leg].drives; k++, j++)
            for (int row = 0; row < n; row++)
                B[n * row + j] *= robot->leg[leg].slides[k] ? robot->size : 1.0;
    least[0] = dhgen_least_singular(n, B) / robot->size;
    least[1] = dhgen_least_singular(n, A) / robot->size;
    return 1;
}

/* Reads a pose of the platform, and whether all joint values of the legs are finite. */
DHGEN_FN int dhgen_read_posture(
    const struct dhgen_parallel *robot, const double *T, const double *q, double *X)
{
    int finite = 1;
    for (int i = 0; i < robot->legs; i++)
        for (int joint = 0; joint < robot->leg[i].joints; joint++)
            finite = finite && isfinite(q[i * robot->joints + joint]);
    return dhgen_read_platform(robot, T, X) && finite;
}

/* dhgen_platform_rates of a pose as it is given. Returns DHGEN_OK, or, with NaN, minus
 * DHGEN_FREE_JOINT where passive joints of a leg depend on each other, or minus DHGEN_INVALID_POSE,
 * also for joint values that are not finite. */
DHGEN_FN int dhgen_parallel_velocities(
    const struct dhgen_parallel *robot, const double *T, const double *q, double *A, double *B)
{
    double X[12];
    int code = -DHGEN_INVALID_POSE;
    if (dhgen_read_posture(robot, T, q, X))
        code = dhgen_platform_rates(robot, X, q, A, B) ? DHGEN_OK : -DHGEN_FREE_JOINT;
    for (int i = 0; i < robot->drives * robot->drives && code < 0; i++)
        A[i] = B[i] = DHGEN_NAN;
    return code;
}

/* dhgen_least_values of a pose as it is given. Returns DHGEN_OK; DHGEN_FREE_JOINT where passive
 * joints of a leg depend on each other; or, with NaN, minus DHGEN_INVALID_POSE, also for joint
 * values that are not finite. */
DHGEN_FN int dhgen_parallel_singularities(
    const struct dhgen_parallel *robot, const double *T, const double *q, double least[2])
{
    double X[12];
    if (dhgen_read_posture(robot, T, q, X))
        return dhgen_least_values(robot, X, q, least) ? DHGEN_OK : DHGEN_FREE_JOINT;
    least[0] = least[1] = DHGEN_NAN;
    return -DHGEN_INVALID_POSE;
}

#endif

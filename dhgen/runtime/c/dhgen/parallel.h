/* SPDX-License-Identifier: MIT
 *
 * Parallel robots: legs, each a serial arm between its place on the base and what it carries of the
 * platform. The inverse model is that of the legs. */
#ifndef DHGEN_PARALLEL_H
#define DHGEN_PARALLEL_H

#include "arm.h"
#include "pose.h"
#include "rigid.h"

#define DHGEN_MOST_LEGS 12
#define DHGEN_LEG_POSES 48 /* of legs that are solved side by side; 32 robots at most */

/* A leg: how its chain is called, and where it is mounted. */
struct dhgen_leg {
    int joints, rows;
    int drives;         /* how many of its joints are driven */
    const int *driven;  /* which, from 0 */
    const int *slides;  /* which drives slide */
    const char *types;  /* of its joints: R turns, P slides */
    const int *counted; /* which of the six velocities of its end the platform gives it: as many as
                         * it has joints */
    double base[12];    /* from the robot's base to its own: the inverse of its place */
    double end[12];     /* what it carries, in the platform's frame */
    int (*ik)(const double *T, const double *q_seed, double *q, unsigned char *status);
    int (*nearest)(const double *T, const double *q_seed, double *q);
    void (*batch)(size_t n, const double *T, double *q, unsigned char *status);
    void (*fk)(const double *q, double *T);
    void (*jacobian)(const double *q, double *J);
};

struct dhgen_parallel {
    int legs;
    int joints, rows;    /* of the leg with the most */
    int drives;          /* of all legs: as many as the platform has freedoms */
    int alike;           /* whether all legs are of one chain: they are solved side by side */
    const int *freedoms; /* which of the six velocities the platform has */
    double size;         /* of the robot [length] */
    int task;            /* what counts of its orientation: DHGEN_POSE, _YAW or _COORDINATES */
    int is_planar;       /* whether it moves in the plane of x and y */
    const struct dhgen_leg *leg;
};

/* The platform's pose as far as the task names it, in full: what it does not name is zero, or the
 * identity. Returns whether it is one. */
DHGEN_INLINE int dhgen_read_platform(const struct dhgen_parallel *robot, const double *T, double *X)
{
    int valid = 1;
    for (int i = 0; i < 12; i++)
        X[i] = T[i];
    if (robot->task == DHGEN_POSE) {
        valid = fabs(T[12]) + fabs(T[13]) + fabs(T[14]) + fabs(T[15] - 1.0) <= DHGEN_LAST_ROW
            && dhgen_read_rotation(X);
    } else {
        const int turns = robot->task == DHGEN_YAW;
        valid = !turns || dhgen_read_yaw(X);
        const double c = turns ? X[0] : 1.0, s = turns ? X[4] : 0.0;
        valid = valid && c * c + s * s > 0.5; /* straight up it has no yaw */
        X[0] = X[5] = c;
        X[1] = -s;
        X[4] = s;
        X[2] = X[6] = X[8] = X[9] = 0.0;
        X[10] = 1.0;
        X[11] = robot->is_planar ? 0.0 : T[11];
    }
    return valid && isfinite(X[3]) && isfinite(X[7]) && isfinite(X[11]);
}

/* What a leg carries at a pose of the platform, in the leg's own base. A point has no orientation:
 * the leg's chain does not need one. */
DHGEN_INLINE void dhgen_leg_pose(const struct dhgen_leg *leg, const double *X, double *T)
{
    const double *const end = leg->end, *const base = leg->base;
    T[12] = T[13] = T[14] = 0.0;
    T[15] = 1.0;
    if (leg->counted[leg->joints - 1] < 3) {
        double p[3];
        for (int i = 0; i < 3; i++)
            p[i] =
                X[4 * i] * end[3] + X[4 * i + 1] * end[7] + X[4 * i + 2] * end[11] + X[4 * i + 3];
        for (int i = 0; i < 3; i++) {
            T[4 * i] = T[4 * i + 1] = T[4 * i + 2] = 0.0;
            T[5 * i] = 1.0;
            T[4 * i + 3] = base[4 * i] * p[0] + base[4 * i + 1] * p[1] + base[4 * i + 2] * p[2]
                + base[4 * i + 3];
        }
        return;
    }
    double carried[12];
    dhgen_compose(X, end, carried);
    dhgen_compose(base, carried, T);
}

/* A leg's place in arrays of rows of all legs. */
DHGEN_INLINE int dhgen_leg_rows(const struct dhgen_parallel *robot, int leg)
{
    return leg * robot->rows * robot->joints;
}

/* Fills the rows of a leg; rows and joints that it has not are none. Returns how many are good. */
DHGEN_FN int dhgen_solve_leg(const struct dhgen_parallel *robot, int number, const double *T,
    const double *q_seed, double *q, unsigned char *status)
{
    const struct dhgen_leg *const leg = robot->leg + number;
    const double *const seed = q_seed ? q_seed + number * robot->joints : NULL;
    double *const rows = q + dhgen_leg_rows(robot, number);
    unsigned char *const statuses = status + number * robot->rows;
    for (int row = leg->rows; row < robot->rows; row++)
        statuses[row] = DHGEN_UNREACHABLE;
    const int count = leg->ik(T, seed, rows, statuses);
    /* from the last row on: a leg with fewer joints has its rows closer together */
    for (int row = robot->rows - 1; row >= 0; row--)
        for (int i = robot->joints - 1; i >= 0; i--)
            rows[row * robot->joints + i] =
                row < leg->rows && i < leg->joints ? rows[row * leg->joints + i] : DHGEN_NAN;
    return count;
}

/* Empties the rows of all legs: the pose is none. */
DHGEN_FN void dhgen_no_platform(
    const struct dhgen_parallel *robot, double *q, unsigned char *status)
{
    for (int i = 0; i < robot->legs * robot->rows; i++)
        status[i] = DHGEN_INVALID_POSE;
    for (int i = 0; i < robot->legs * robot->rows * robot->joints; i++)
        q[i] = DHGEN_NAN;
}

/* Whether a leg refuses its pose, as a leg with slides does that is too far for squares of lengths:
 * all of its rows have that status. */
DHGEN_INLINE int dhgen_is_refused(const struct dhgen_parallel *robot, const unsigned char *status)
{
    int refused = 0;
    for (int i = 0; i < robot->legs; i++)
        refused |= status[i * robot->rows] == DHGEN_INVALID_POSE;
    return refused;
}

/* All solutions of all legs. Returns how many working modes there are, the product of the good rows
 * of the legs, or -DHGEN_INVALID_POSE. */
DHGEN_FN int dhgen_parallel_ik(const struct dhgen_parallel *robot, const double *T,
    const double *q_seed, double *q, unsigned char *status)
{
    double X[12], poses[DHGEN_MOST_LEGS][16];
    int modes = 1;
    if (!dhgen_read_platform(robot, T, X)) {
        dhgen_no_platform(robot, q, status);
        return -DHGEN_INVALID_POSE;
    }
    for (int i = 0; i < robot->legs; i++)
        dhgen_leg_pose(robot->leg + i, X, poses[i]);
    if (robot->alike && !q_seed) {
        robot->leg->batch((size_t)robot->legs, poses[0], q, status);
        if (dhgen_is_refused(robot, status)) {
            dhgen_no_platform(robot, q, status);
            return -DHGEN_INVALID_POSE;
        }
        for (int i = 0; i < robot->legs; i++) {
            int count = 0;
            for (int row = i * robot->rows; row < (i + 1) * robot->rows; row++)
                count += status[row] == DHGEN_OK || status[row] == DHGEN_FREE_JOINT;
            modes *= count;
        }
        return modes;
    }
    for (int i = 0; i < robot->legs; i++) {
        const int count = dhgen_solve_leg(robot, i, poses[i], q_seed, q, status);
        if (count < 0) {
            dhgen_no_platform(robot, q, status);
            return count;
        }
        modes *= count;
    }
    return modes;
}

/* Of every leg the solution nearest to the seed. Returns the worst status of a leg's, or minus what
 * is wrong with the first that has none; q is NaN then. */
DHGEN_FN int dhgen_parallel_nearest(
    const struct dhgen_parallel *robot, const double *T, const double *q_seed, double *q)
{
    double X[12], pose[16], found[DHGEN_MOST_LEGS * DHGEN_MOST_JOINTS];
    int worst = dhgen_read_platform(robot, T, X) ? DHGEN_OK : -DHGEN_INVALID_POSE;
    for (int i = 0; i < robot->legs * robot->joints; i++)
        found[i] = DHGEN_NAN;
    for (int i = 0; i < robot->legs && worst >= 0; i++) {
        dhgen_leg_pose(robot->leg + i, X, pose);
        const int place = i * robot->joints;
        const int code = robot->leg[i].nearest(pose, q_seed + place, found + place);
        worst = code < 0 || code > worst ? code : worst;
    }
    for (int i = 0; i < robot->legs * robot->joints; i++)
        q[i] = worst < 0 ? DHGEN_NAN : found[i];
    return worst;
}

/* dhgen_parallel_ik without a seed for n poses: legs that are of one chain side by side, of as many
 * poses as there is room for. */
DHGEN_FN void dhgen_parallel_batch(
    const struct dhgen_parallel *robot, size_t n, const double *T, double *q, unsigned char *status)
{
    double poses[DHGEN_LEG_POSES][16], X[12];
    const size_t rows = (size_t)(robot->legs * robot->rows), size = rows * (size_t)robot->joints;
    const size_t together = robot->alike ? (size_t)(DHGEN_LEG_POSES / robot->legs) : 1;
    for (size_t k = 0; k < n; k += together) {
        const size_t count = n - k < together ? n - k : together;
        double *const q_k = q + size * k;
        unsigned char *const status_k = status + rows * k;
        unsigned invalid = 0;
        for (size_t i = 0; i < count && robot->alike; i++) {
            if (!dhgen_read_platform(robot, T + 16 * (k + i), X))
                invalid |= 1u << i;
            for (int leg = 0; leg < robot->legs; leg++)
                dhgen_leg_pose(robot->leg + leg, X, poses[i * (size_t)robot->legs + (size_t)leg]);
        }
        if (robot->alike)
            robot->leg->batch(count * (size_t)robot->legs, poses[0], q_k, status_k);
        else
            (void)dhgen_parallel_ik(robot, T + 16 * k, NULL, q_k, status_k);
        for (size_t i = 0; i < count && robot->alike; i++)
            if (invalid >> i & 1u || dhgen_is_refused(robot, status_k + rows * i))
                dhgen_no_platform(robot, q_k + size * i, status_k + rows * i);
    }
}

/* The drives of a leg, the values of its driven joints, out of all its joint values. */
DHGEN_INLINE void dhgen_leg_drives(const struct dhgen_leg *leg, const double *q, double *drives)
{
    for (int k = 0; k < leg->drives; k++)
        drives[k] = q[leg->driven[k]];
}

/* Takes the driven joints of a leg to its drives. */
DHGEN_INLINE void dhgen_set_leg_drives(const struct dhgen_leg *leg, const double *drives, double *q)
{
    for (int k = 0; k < leg->drives; k++)
        q[leg->driven[k]] = drives[k];
}

/* The drives of all legs, one after the other. */
DHGEN_FN void dhgen_take_drives(const struct dhgen_parallel *robot, const double *q, double *drives)
{
    for (int i = 0; i < robot->legs; drives += robot->leg[i++].drives)
        dhgen_leg_drives(robot->leg + i, q + i * robot->joints, drives);
}

#endif

/* SPDX-License-Identifier: MIT
 *
 * The direct model of a platform near a seed: bounded Newton steps on all loops at once. */
#ifndef DHGEN_DIRECT_H
#define DHGEN_DIRECT_H

#include "least_squares.h"
#include "platform.h"

/* Steps of the direct model; the longest one [rad, robot sizes]; what legs may miss the platform by
 * [robot sizes, rad]; and what a step is damped by, as a share of the squares that it divides. */
#define DHGEN_DIRECT_STEPS 60
#define DHGEN_DIRECT_STEP 0.25
#define DHGEN_CLOSED 1e-12
#define DHGEN_DIRECT_DAMPING 1e-14

/* Two rows of a leg have equal drives if these differ by less [rad, robot sizes]. */
#define DHGEN_SAME_DRIVES 1e-9

/* The solution of a square system, M x = y with M in rows of six, damped a little: it has one where
 * M is singular, too. */
DHGEN_FN void dhgen_direct_solution(int n, double M[6][6], const double *y, double *x)
{
    double squares = 0.0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            squares += M[i][j] * M[i][j];
    dhgen_least_squares(n, n, &M[0][0], 6, DHGEN_DIRECT_DAMPING * squares + 1e-300, y, x);
}

/* Moves the platform by its freedoms, lengths in robot sizes. */
DHGEN_FN void dhgen_move_platform(const struct dhgen_parallel *robot, const double *step, double *X)
{
    double w[3] = { 0.0, 0.0, 0.0 };
    for (int k = 0; k < robot->drives; k++) {
        const int freedom = robot->freedoms[k];
        if (freedom < 3)
            X[4 * freedom + 3] += robot->size * step[k];
        else
            w[freedom - 3] = step[k];
    }
    const double angle = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    if (!(angle > 0.0))
        return;
    const double s = sin(angle) / angle, half = sin(0.5 * angle) / angle, c = 2.0 * half * half;
    double R[9];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        R[4 * i] = 1.0 - c * (w[j] * w[j] + w[k] * w[k]);
        R[3 * i + j] = c * w[i] * w[j] - s * w[k];
        R[3 * j + i] = c * w[i] * w[j] + s * w[k];
    }
    for (int column = 0; column < 3; column++) {
        const double x = X[column], y = X[4 + column], z = X[8 + column];
        for (int i = 0; i < 3; i++)
            X[4 * i + column] = R[3 * i] * x + R[3 * i + 1] * y + R[3 * i + 2] * z;
    }
}

/* What a joint's value is away from another one: angles by the short way. */
DHGEN_INLINE double dhgen_drive_miss(int slides, double size, double one, double other)
{
    return slides ? fabs(one - other) / size : fabs(dhgen_wrap(one - other));
}

/* The joint values of a leg at a pose of the platform whose drives are nearest to given ones; a row
 * within limits goes before rows that differ from it in passive joints alone. Returns 0 where it
 * does not reach it. */
DHGEN_FN int dhgen_nearest_drives(const struct dhgen_parallel *robot, int number, const double *X,
    const double *drives, double *q)
{
    const struct dhgen_leg *const leg = robot->leg + number;
    double pose[16], rows[DHGEN_MOST_ROWS * DHGEN_MOST_JOINTS], nearest = HUGE_VAL;
    double misses[DHGEN_MOST_ROWS];
    unsigned char status[DHGEN_MOST_ROWS];
    int taken = -1, taken_is_good = 0;
    dhgen_leg_pose(leg, X, pose);
    (void)leg->ik(pose, NULL, rows, status);
    for (int row = 0; row < leg->rows; row++) {
        double own[DHGEN_MOST_JOINTS], miss = 0.0;
        dhgen_leg_drives(leg, rows + row * leg->joints, own);
        for (int k = 0; k < leg->drives; k++)
            miss += dhgen_drive_miss(leg->slides[k], robot->size, own[k], drives[k]);
        misses[row] = miss;
        nearest = miss < nearest ? miss : nearest;
    }
    for (int row = 0; row < leg->rows; row++) {
        const int good = status[row] == DHGEN_OK || status[row] == DHGEN_FREE_JOINT;
        if (misses[row] <= nearest + DHGEN_SAME_DRIVES && (taken < 0 || good > taken_is_good)) {
            taken = row;
            taken_is_good = good;
        }
    }
    for (int i = 0; i < leg->joints && taken >= 0; i++)
        q[i] = rows[taken * leg->joints + i];
    dhgen_set_leg_drives(leg, drives, q);
    return taken >= 0;
}

/* One step of the direct model: the platform and the passive joints, so that the legs meet it.
 * Those of a leg whose passive joints depend on each other can't follow by steps: its inverse model
 * has them. Returns by how much the legs missed the platform before. */
DHGEN_FN double dhgen_direct_step(
    const struct dhgen_parallel *robot, const double *drives, double *X, double *q)
{
    struct dhgen_leg_motion motions[DHGEN_MOST_LEGS];
    double M[6][6], y[6], step[6], worst = 0.0, longest = 0.0;
    for (int i = 0, row = 0; i < robot->legs; i++) {
        struct dhgen_leg_motion *const motion = motions + i;
        dhgen_leg_motion_at(robot, i, X, q + i * robot->joints, motion);
        for (int k = 0; k < motion->rows; k++) /* NaN is kept */
            if (fabs(motion->miss[k]) > worst || isnan(motion->miss[k]))
                worst = fabs(motion->miss[k]);
        dhgen_without_passive(robot, motion);
        const int end = motion->independent + robot->leg[i].drives;
        for (int k = motion->independent; k < end && row < 6; k++, row++) {
            for (int j = 0; j < robot->drives; j++)
                M[row][j] = motion->V[k][j];
            y[row] = -motion->miss[k];
        }
    }
    dhgen_direct_solution(robot->drives, M, y, step);
    for (int j = 0; j < robot->drives; j++)
        longest = fmax(longest, fabs(step[j]));
    const double share = longest > DHGEN_DIRECT_STEP ? DHGEN_DIRECT_STEP / longest : 1.0;
    for (int j = 0; j < robot->drives; j++)
        step[j] *= share;
    dhgen_move_platform(robot, step, X);
    for (int i = 0, first = 0; i < robot->legs; first += robot->leg[i++].drives) {
        const struct dhgen_leg_motion *const motion = motions + i;
        double P[6][6], r[6], moved[6], most = 0.0;
        if (motion->independent < motion->passive) {
            (void)dhgen_nearest_drives(robot, i, X, drives + first, q + i * robot->joints);
            continue;
        }
        for (int k = 0; k < motion->passive; k++) {
            r[k] = share * motion->miss[k];
            for (int j = 0; j < robot->drives; j++)
                r[k] += motion->V[k][j] * step[j];
            for (int j = 0; j < motion->passive; j++)
                P[k][j] = motion->J[k][j];
        }
        dhgen_direct_solution(motion->passive, P, r, moved);
        for (int k = 0; k < motion->passive; k++)
            most = fmax(most, fabs(moved[k]));
        const double longest_turn = 2.0 * DHGEN_DIRECT_STEP;
        const double less = most > longest_turn ? longest_turn / most : 1.0;
        for (int k = 0; k < motion->passive; k++)
            q[i * robot->joints + motion->order[k]] += less * moved[k];
    }
    return worst;
}

/* The pose of the platform that drives' values make, and the joint values of all legs, refined from
 * a seed: the pose of the platform nearby. Returns DHGEN_OK; DHGEN_FREE_JOINT where the platform is
 * singular there: other poses meet this one, or it can move, or passive joints of a leg can; or,
 * with NaN, minus
 * DHGEN_UNREACHABLE where the legs did not meet the platform in so many steps, or one does not
 * reach the seed, or minus DHGEN_INVALID_POSE. */
DHGEN_FN int dhgen_parallel_fk(const struct dhgen_parallel *robot, const double *drives,
    const double *T_seed, double *T, double *q)
{
    double X[12], last = HUGE_VAL, least[2] = { 0.0, 0.0 };
    int code = dhgen_read_platform(robot, T_seed, X) ? DHGEN_OK : -DHGEN_INVALID_POSE;
    for (int i = 0; i < robot->drives; i++)
        code = isfinite(drives[i]) ? code : -DHGEN_INVALID_POSE;
    for (int i = 0; i < robot->legs * robot->joints; i++)
        q[i] = DHGEN_NAN;
    for (int i = 0, first = 0; i < robot->legs && code >= 0; i++) {
        if (!dhgen_nearest_drives(robot, i, X, drives + first, q + i * robot->joints))
            code = -DHGEN_UNREACHABLE;
        first += robot->leg[i].drives;
    }
    for (int k = 0; k < DHGEN_DIRECT_STEPS && code >= 0 && !(last <= DHGEN_CLOSED); k++)
        last = dhgen_direct_step(robot, drives, X, q);
    if (code >= 0 && last <= DHGEN_CLOSED) {
        (void)dhgen_least_values(robot, X, q, least);
        code = least[1] > DHGEN_SINGULAR_PLATFORM ? DHGEN_OK : DHGEN_FREE_JOINT;
    } else if (code >= 0)
        code = -DHGEN_UNREACHABLE;
    for (int i = 0; i < 12; i++)
        T[i] = code < 0 ? DHGEN_NAN : X[i];
    T[12] = T[13] = T[14] = code < 0 ? DHGEN_NAN : 0.0;
    T[15] = code < 0 ? DHGEN_NAN : 1.0;
    for (int i = 0; i < robot->legs; i++)
        for (int joint = 0; joint < robot->joints; joint++) {
            double *const value = q + i * robot->joints + joint;
            const int turns = joint < robot->leg[i].joints && robot->leg[i].types[joint] == 'R';
            *value = code < 0 ? DHGEN_NAN : turns ? dhgen_wrap(*value) : *value;
        }
    for (int i = 0; i < robot->legs && code >= 0; drives += robot->leg[i++].drives)
        dhgen_set_leg_drives(robot->leg + i, drives, q + i * robot->joints);
    return code;
}

#endif

/* SPDX-License-Identifier: MIT
 *
 * What robots' public functions do: all solutions of a pose, the one nearest to a seed, and all of
 * many poses. */
#ifndef DHGEN_IK_H
#define DHGEN_IK_H

#include "arm.h"

#define DHGEN_SOLVE_REGULAR NULL /* tile.h has one */

/* All solutions of any pose: also of one that is rounded, singular or none. Returns how many rows
 * are inside limits, or -DHGEN_INVALID_POSE. */
DHGEN_API int dhgen_careful_ik(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *q_seed, double *q, unsigned char *status);

/* Of all solutions of a pose, of which there were `count`, that nearest to a seed, with angles
 * moved by whole turns. Returns its status, or minus what is wrong. */
DHGEN_API int dhgen_nearest_row(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *q_seed, int count, double *rows, unsigned char *status,
    double *q);

/* All solutions: regular poses take no other way. */
DHGEN_INLINE int dhgen_ik(const struct dhgen_arm *arm, const double *T, const double *free_joints,
    const double *q_seed, double *q, unsigned char *status)
{
    const int count = arm->regular ? arm->regular(T, free_joints, q, status) : -1;
    return count < 0 ? dhgen_careful_ik(arm, T, free_joints, q_seed, q, status) : count;
}

/* The solution nearest to a seed. */
DHGEN_INLINE int dhgen_ik_nearest(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *q_seed, double *q)
{
    double rows[DHGEN_BRANCHES * DHGEN_JOINTS];
    unsigned char status[DHGEN_BRANCHES];
    const int count = dhgen_ik(arm, T, free_joints, q_seed, rows, status);
    return dhgen_nearest_row(arm, T, free_joints, q_seed, count, rows, status, q);
}

/* All solutions of poses of a batch, from number k on, one after another. */
DHGEN_INLINE void dhgen_ik_each(const struct dhgen_arm *arm, size_t k, size_t n, const double *T,
    const double *free_joints, double *q, unsigned char *status)
{
    const size_t rows = (size_t)dhgen_rows(arm), size = rows * (size_t)dhgen_dof(arm);
    for (; k < n; k++) {
        const double *const given = free_joints ? free_joints + (size_t)arm->given * k : NULL;
        (void)dhgen_ik(arm, T + 16 * k, given, NULL, q + size * k, status + rows * k);
    }
}

#ifndef DHGEN_SHARED

#include "clamp.h"
#include "duplicates.h"
#include "follow_seed.h"
#include "limits.h"
#include "pose.h"
#include "retry.h"

/* Whether a pose and what else the caller gives can be used: 0 if not, 2 if the pose was rounded.
 */
DHGEN_FN int dhgen_read_input(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, double *pose)
{
    for (int k = 0; k < arm->given; k++)
        if (!dhgen_usable(arm, free_joints[k]))
            return 0;
    for (int i = 0; i < dhgen_dof(arm); i++)
        if (!isfinite(seed[i]))
            return 0;
    return dhgen_read_pose(arm, T, pose);
}

/* The rows of a pose, before any of them is clamped to limits. */
DHGEN_FN void dhgen_solve_rows(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *seed, double *q, unsigned char *status)
{
    arm->solve(T, free_joints, seed, 0.0, q, status);
    int begun = -1;
    for (int row = dhgen_rows(arm) - 1; row >= 0; row--)
        begun = status[row] == DHGEN_UNREACHABLE ? begun : row;
    for (int row = 0; row < dhgen_rows(arm) && arm->retries; row++)
        if (status[row] >= DHGEN_LOST)
            dhgen_retry_free_joint(arm, T, free_joints, seed, row, q, status);
    for (int row = 0; row < dhgen_rows(arm) && arm->keeps_limits; row++)
        if (status[row] == DHGEN_FREE_JOINT
            && dhgen_beyond_limits(arm, q + dhgen_dof(arm) * row) > 0.0)
            dhgen_keep_limits(arm, T, free_joints, seed, row, q, status);
    if (arm->complete)
        arm->complete(arm, T, free_joints, seed, begun, q, status);
    if (arm->merges)
        dhgen_remove_duplicates(arm, T, q, status);
    for (int row = 0; row < dhgen_rows(arm) && arm->range_exceeds_a_turn; row++)
        for (int i = 0; i < dhgen_dof(arm); i++) {
            double *const value = q + dhgen_dof(arm) * row + i;
            *value = dhgen_at_an_end(arm, i, *value, seed[i]);
        }
    if (arm->follows_seed)
        dhgen_follow_seed(arm, T, free_joints, seed, q, status);
}

/* Turns the joints of a row inside their limits. Returns whether all are. */
DHGEN_FN int dhgen_turn_inside(const struct dhgen_arm *arm, double *q)
{
    int inside = 1;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        const struct dhgen_joint *const of = arm->joints + i;
        if (arm->clamps || arm->follows_seed)
            q[i] = dhgen_turned(arm, i, q[i], dhgen_moves(arm, i) ? 0.0 : q[i]);
        else if (!(of->lowest <= q[i] && q[i] <= of->highest))
            q[i] = dhgen_turned(arm, i, q[i], q[i]);
        inside &= dhgen_inside(arm, i, q[i]);
    }
    return inside;
}

/* Clamps rows to limits, and again where none is inside, and marks the rows that are not inside.
 * Returns how many are. */
DHGEN_FN int dhgen_end_rows(
    const struct dhgen_arm *arm, const double *T, double *q, unsigned char *status)
{
    const int rows = dhgen_rows(arm);
    const int twice = arm->clamps_far || arm->clamped[1] > arm->clamped[0];
    int count = 0;
    for (int n = 0; n < rows || (twice && n < 2 * rows && count == 0); n++) {
        const int row = n % rows, again = n >= rows;
        if (status[row] == DHGEN_UNREACHABLE)
            continue;
        if (arm->clamps && dhgen_clamp_to_limits(arm, T, row, again, q, status) && again)
            status[row] = DHGEN_FREE_JOINT;
        if (!dhgen_turn_inside(arm, q + dhgen_dof(arm) * row))
            status[row] = DHGEN_OUT_OF_LIMITS;
        count += status[row] != DHGEN_OUT_OF_LIMITS;
    }
    return count;
}

DHGEN_API int dhgen_careful_ik(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *q_seed, double *q, unsigned char *status)
{
    const double zeros[DHGEN_JOINTS] = { 0.0 }, *const seed = q_seed ? q_seed : zeros;
    double pose[16];
    const int valid = dhgen_read_input(arm, T, free_joints, seed, pose);
    if (valid == 2 && arm->regular) {
        const int count = arm->regular(pose, free_joints, q, status);
        if (count >= 0)
            return count;
    }
    for (int row = 0; row < dhgen_rows(arm); row++) {
        status[row] = valid ? DHGEN_UNREACHABLE : DHGEN_INVALID_POSE;
        for (int i = 0; i < dhgen_dof(arm); i++)
            q[dhgen_dof(arm) * row + i] = DHGEN_NAN;
    }
    if (!valid)
        return -DHGEN_INVALID_POSE;
    dhgen_solve_rows(arm, pose, free_joints, seed, q, status);
    return dhgen_end_rows(arm, pose, q, status);
}

/* Whether a row of a regular pose has a joint past an end of its range that was turned although the
 * seed is at that end. */
DHGEN_FN int dhgen_turned_away(const struct dhgen_arm *arm, const double *q_seed,
    const double *rows, const unsigned char *status)
{
    int past = 0;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        const struct dhgen_joint *const of = arm->joints + i;
        if (!(fmin(of->highest - q_seed[i], q_seed[i] - of->lowest) < DHGEN_BESIDE_SEED))
            continue;
        for (int row = 0; row < dhgen_rows(arm); row++)
            if (status[row] == DHGEN_OK) {
                const double value = rows[dhgen_dof(arm) * row + i];
                const double there = dhgen_at_an_end(arm, i, value, q_seed[i]);
                past += dhgen_past_an_end(arm, i, there) != 0.0;
            }
    }
    return past > 0;
}

/* How far a row is from a seed, squared, after its angles have been turned near to it [rad, arm
 * sizes]. */
DHGEN_FN double dhgen_distance(const struct dhgen_arm *arm, const double *q_seed, double *q)
{
    double distance = 0.0;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        q[i] = dhgen_turned(arm, i, q[i], q_seed[i]);
        const double moved = q[i] - q_seed[i];
        distance += arm->joints[i].weight * moved * moved;
    }
    return distance;
}

DHGEN_API int dhgen_nearest_row(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *q_seed, int count, double *rows, unsigned char *status,
    double *q)
{
    double found[DHGEN_JOINTS], least = HUGE_VAL;
    int result = -DHGEN_UNREACHABLE, valid = count >= 0;
    for (int i = 0; i < dhgen_dof(arm); i++) {
        found[i] = DHGEN_NAN;
        valid &= isfinite(q_seed[i]) != 0;
    }
    if (valid && arm->range_exceeds_a_turn && arm->regular
        && dhgen_turned_away(arm, q_seed, rows, status))
        (void)dhgen_careful_ik(arm, T, free_joints, q_seed, rows, status);
    for (int row = 0; row < dhgen_rows(arm) && valid; row++) {
        double *const values = rows + dhgen_dof(arm) * row;
        if (status[row] == DHGEN_OUT_OF_LIMITS && result < 0)
            result = -DHGEN_OUT_OF_LIMITS;
        if (status[row] != DHGEN_OK && status[row] != DHGEN_FREE_JOINT)
            continue;
        const double distance = dhgen_distance(arm, q_seed, values);
        if (distance < least || result < 0) {
            least = distance;
            result = status[row];
            dhgen_copy_row(arm, values, found);
        }
    }
    dhgen_copy_row(arm, found, q);
    return valid ? result : -DHGEN_INVALID_POSE;
}

#endif

#endif

/* SPDX-License-Identifier: MIT
 *
 * The nearest arm with a structure: joint values that lead to all solutions. */
#ifndef DHGEN_GENERAL_NEAR_H
#define DHGEN_GENERAL_NEAR_H

#include "../general.h"
#include "loop.h"

#ifdef DHGEN_DOF
#include "../certain.h"
#endif

/* The nearest arm with a structure: what stands before and behind a pose T to make it this arm's,
 * three rows of four, and what its angles are more than those of the loop; which of its joints are
 * those of the loop. */
typedef struct {
    int rows;
    double left[12], right[12], offsets[6];
    int place[6];
} dhgen_nearest_arm;

/* Its rows at a pose; negative where a branch may end between there and the arm's pose. */
typedef int dhgen_nearest_rows(
    const double *T, const double *free_joints, double *q, unsigned char *status);

/* Such an arm's pose for a pose T. */
DHGEN_FN void dhgen_pose_of_nearest(
    const double left[12], const double T[16], const double right[12], double pose[16])
{
    dhgen_compose(left, T, pose);
    dhgen_append(pose, right);
    for (int i = 12; i < 16; i++) {
        pose[i] = T[i];
    }
}

#ifdef DHGEN_DOF /* rows are as long as those of the robot whose file this is a part of */
/* Angles of the loop that lead to all solutions. That no other branch has one is certain, that none
 * has a second one is not proven. Returns how many; 0 where it is not certain. */
DHGEN_FN int dhgen_near_solutions(const dhgen_nearest_arm *arm, dhgen_nearest_rows *solve,
    const double *T, const double *free_joints, double (*nearby)[6])
{
    double pose[16], q[16][DHGEN_DOF];
    unsigned char status[16];
    int count = 0;
    dhgen_pose_of_nearest(arm->left, T, arm->right, pose);
    if (solve(pose, free_joints, q[0], status) <= 0) {
        return 0;
    }
    for (int row = 0; row < arm->rows; row++) {
        if (status[row] == DHGEN_OK) {
            for (int i = 0; i < 6; i++) {
                nearby[count][i] = q[row][arm->place[i]] - arm->offsets[i];
            }
            count++;
        }
    }
    return count;
}

/* The rows of a pose where those of the nearest arm lead to all solutions. Returns how many are
 * inside limits, or -1 where the pose has to be left to the general algorithm. */
DHGEN_FN int dhgen_near_rows(const struct dhgen_arm *arm, const dhgen_general_arm *general,
    const struct dhgen_numerical_arm *descents, const dhgen_nearest_arm *nearest,
    dhgen_nearest_rows *solve, const double *T, const double *free_joints, double *q,
    unsigned char *status)
{
    double nearby[DHGEN_ROWS][6], solution[DHGEN_ROWS][DHGEN_DOF];
    const int count = dhgen_near_solutions(nearest, solve, T, free_joints, nearby);
    if (count <= 0 || !dhgen_general_correct(general, T, free_joints, nearby, count))
        return -1;
    for (int k = 0; k < count; k++) {
        for (int i = 0; i < arm->given_joint_count; i++) {
            solution[k][arm->given_joints[i]] = free_joints[i];
        }
        for (int i = 0; i < 6; i++) {
            const double value = descents->facing[i] * (nearby[k][i] - descents->zero[i]);
            solution[k][descents->joint[i]] = value - DHGEN_TURN * ceil(value / DHGEN_TURN - 0.5);
        }
    }
    return dhgen_fill_certain(arm, solution, count, q, status);
}
#endif

#endif

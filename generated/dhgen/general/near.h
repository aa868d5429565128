/* SPDX-License-Identifier: MIT
 *
 * The nearest arm with a structure: joint values next to all solutions, and postures. */
#ifndef DHGEN_GENERAL_NEAR_H
#define DHGEN_GENERAL_NEAR_H

#include "../general.h"
#include "loop.h"
#include "postures.h"

#ifdef DHGEN_DOF
#include "../certain.h"
#endif

/* The nearest arm with a structure. */
typedef struct {
    int rows, given;            /* of its closed form; how many values the caller gives */
    double turned, moved;       /* the two arms' tools differ by no more [rad, length] */
    double left[12], right[12]; /* this arm's pose is left T right */
    double offsets[6];          /* its angles minus the loop's */
    int place[6];               /* which of its joints are the loop's */
    const double (*link)[12];   /* C0 ... Cn of its pose C0 Rz(angle 1) C1 ... Rz(angle n) Cn */
    const double *angle;        /* each as the factors of all joint values, and what is added; less
                                   by the offsets, which are in the links */
} dhgen_nearest_arm;

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

#ifdef DHGEN_DOF /* rows are as long as the rows of the robot in whose file this is */
/* What the closed form is given, DHGEN_DOF numbers at most: six joints are solved for. */
DHGEN_FN void dhgen_give_nearest(const dhgen_nearest_arm *arm, const double *free_joints,
    double turned, double moved, double *given)
{
    for (int i = 0; i < arm->given; i++) {
        given[i] = free_joints[i];
    }
    given[arm->given] = turned;
    given[arm->given + 1] = moved;
}

/* Angles of the loop next to all solutions, and the row of each. That no other branch has one is
 * certain, that none has a second one is not proven. Returns how many; -1 where it is not
 * certain. */
DHGEN_FN int dhgen_near_solutions(const dhgen_nearest_arm *arm, dhgen_nearest_rows *solve,
    const double *T, const double *free_joints, double (*nearby)[6], int *rows)
{
    double pose[16], given[DHGEN_DOF], q[16][DHGEN_DOF];
    unsigned char status[16];
    int count = 0;
    dhgen_pose_of_nearest(arm->left, T, arm->right, pose);
    dhgen_give_nearest(arm, free_joints, arm->turned, arm->moved, given);
    if (solve(pose, given, q[0], status) < 0) {
        return -1;
    }
    for (int row = 0; row < arm->rows; row++) {
        if (status[row] == DHGEN_OK) {
            for (int i = 0; i < 6; i++) {
                nearby[count][i] = q[row][arm->place[i]] - arm->offsets[i];
            }
            rows[count++] = row;
        }
    }
    return count;
}

/* The joint values of angles of the loop. */
DHGEN_FN void dhgen_values_of_loop(const struct dhgen_numerical_arm *arm, const double *free_joints,
    const double *angles, double *q)
{
    double u[DHGEN_DOF];
    for (int i = 0; i < arm->given_joints; i++) {
        q[arm->given[i]] = free_joints[i];
    }
    if (arm->drives) {
        dhgen_to_drives(arm, q, angles, u);
        dhgen_wrap_units(arm, u);
    }
    for (int i = 0; i < 6; i++) {
        q[arm->joint[i]] =
            arm->drives ? u[i] : dhgen_wrap(arm->facing[i] * (angles[i] - arm->zero[i]));
    }
}

/* All solutions of a pose where they lie next to the nearest arm's rows, and the row of each.
 * Returns how many, or -1 where the pose has to be left to the general algorithm. */
DHGEN_FN int dhgen_solved_from_nearest(const dhgen_general_arm *general,
    const struct dhgen_numerical_arm *descents, const dhgen_nearest_arm *nearest,
    dhgen_nearest_rows *solve, const double *T, const double *free_joints,
    double (*solution)[DHGEN_DOF], int *row)
{
    double angles[DHGEN_ROWS][6];
    const int count = dhgen_near_solutions(nearest, solve, T, free_joints, angles, row);
    if (count < 0 || !dhgen_general_correct(general, T, free_joints, angles, count)) {
        return -1;
    }
    for (int k = 0; k < count; k++) {
        dhgen_values_of_loop(descents, free_joints, angles[k], solution[k]);
    }
    return count;
}

/* Fills the rows of a pose if all its solutions lie next to the nearest arm's rows; returns whether
 * they do. */
DHGEN_FN int dhgen_solve_from_nearest(const dhgen_general_arm *general,
    const struct dhgen_numerical_arm *descents, const dhgen_nearest_arm *nearest,
    dhgen_nearest_rows *solve, const double *T, const double *free_joints, double *q,
    unsigned char *status)
{
    double solution[DHGEN_ROWS][DHGEN_DOF];
    int row[DHGEN_ROWS];
    const int count =
        dhgen_solved_from_nearest(general, descents, nearest, solve, T, free_joints, solution, row);
    dhgen_keep_certain(solution, row, count, q, status);
    return count >= 0;
}

/* The rows of a pose all of whose solutions lie next to the nearest arm's rows. Returns how many
 * are inside limits, or -1 where the pose has to be left to the general algorithm. */
DHGEN_FN int dhgen_near_rows(const struct dhgen_arm *arm, const dhgen_general_arm *general,
    const struct dhgen_numerical_arm *descents, const dhgen_nearest_arm *nearest,
    dhgen_nearest_rows *solve, const double *T, const double *free_joints, double *q,
    unsigned char *status)
{
    double solution[DHGEN_ROWS + 1][DHGEN_DOF];
    int row[DHGEN_ROWS];
    const int count =
        dhgen_solved_from_nearest(general, descents, nearest, solve, T, free_joints, solution, row);
    return count < 0 ? -1 : dhgen_fill_certain(arm, solution, row, count, q, status);
}

/* Moves solutions, which ascend, to the rows of their postures. */
DHGEN_FN void dhgen_to_nearest_rows(const dhgen_nearest_arm *nearest, dhgen_solve_wide *solve,
    const double *free_joints, double *q, unsigned char *status)
{
    const dhgen_nearest_form form = { solve, nearest->rows, nearest->given + 2, nearest->place,
        nearest->link };
    double given[DHGEN_DOF];
    dhgen_asked asked;
    dhgen_give_nearest(nearest, free_joints, 0.0, 0.0, given);
    dhgen_ask_rows(status, &asked);
    for (int k = 0; k < DHGEN_ASKED; k++) {
        for (int i = 0; i < DHGEN_DOF; i++) {
            const double *const of = nearest->angle + (DHGEN_DOF + 1) * i;
            asked.angle[i][k] = of[DHGEN_DOF];
            for (int j = 0; j < DHGEN_DOF && k < asked.count; j++) {
                asked.angle[i][k] += of[j] * q[DHGEN_DOF * k + j];
            }
        }
        for (int i = 0; i < 6; i++) {
            asked.value[i][k] = asked.angle[nearest->place[i]][k] + nearest->offsets[i];
        }
    }
    dhgen_place_asked(&form, given, &asked, q, status);
}
#endif

#endif

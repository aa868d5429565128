/* SPDX-License-Identifier: MIT
 *
 * Arms of one kind, each with a table of its own: every call reads the numbers computed from it.
 * The closed form of the nominal arm is tried first; where a solution may lie next to none of its
 * rows the general algorithm solves the pose. */
#ifndef DHGEN_CALIBRATED_H
#define DHGEN_CALIBRATED_H

#include "calibrate.h"
#include "certain.h"
#include "general/postures.h"
#include "ik.h"
#include "velocities.h"

/* The runtime hands what callers give, the values of given joints, to the solver as it is. Arms of
 * a kind have no such joint: in their place the solver gets the arm, whose first number's address
 * is its own. */
DHGEN_INLINE const double *dhgen_handed_on(const dhgen_calibration *of)
{
    return of->constant[0];
}

/* The arm that the solver was handed. */
DHGEN_INLINE const dhgen_calibration *dhgen_handed_arm(const double *given)
{
    return (const dhgen_calibration *)(const void *)given;
}

/* The calibrated arm as the runtime sees arms. */
DHGEN_FN struct dhgen_calibrated_arm dhgen_calibrated_arm_of(
    const dhgen_kind *kind, const dhgen_calibration *of)
{
    struct dhgen_calibrated_arm arm;
    arm.arm = *kind->arm;
    arm.calibration = of;
    return arm;
}

/* Angles of the loop next to all solutions, and the row of each. That no other branch has one is
 * certain, that none has a second one is not proven. Returns how many; -1 where it is not
 * certain. */
DHGEN_FN int dhgen_near_nominal(const dhgen_kind *kind, const dhgen_calibration *of,
    const double *T, double (*nearby)[6], int *rows)
{
    const double apart[2] = { of->margin * of->turned, of->margin * of->moved };
    double pose[16], q[DHGEN_ROWS][6];
    unsigned char status[DHGEN_ROWS];
    int count = 0;
    dhgen_pose_of_nearest(of->left, T, of->right, pose);
    if (!kind->nearest || kind->nearest(pose, apart, q[0], status) < 0)
        return -1;
    for (int row = 0; row < kind->nearest_rows; row++)
        if (status[row] == DHGEN_OK) {
            for (int i = 0; i < 6; i++)
                nearby[count][i] = kind->facing[i] * q[row][i] - of->more[i];
            rows[count++] = row;
        }
    return count;
}

/* The arm as the general algorithm reads it. */
DHGEN_FN dhgen_general_arm dhgen_general_arm_of(const dhgen_kind *kind, const dhgen_calibration *of)
{
    dhgen_general_arm general = *kind->general;
    general.size = of->size;
    general.per_size = 1.0 / of->size;
    general.constant = of->loop;
    return general;
}

/* All solutions of a pose where they lie next to the nominal arm's rows, and the row of each.
 * Returns how many, or -1 where the pose has to be left to the general algorithm. */
DHGEN_FN int dhgen_solved_from_nominal(const dhgen_kind *kind, const dhgen_calibration *of,
    const dhgen_general_arm *general, const double *T, double (*solution)[6], int *row)
{
    const int count = dhgen_near_nominal(kind, of, T, solution, row);
    if (count < 0 || !dhgen_general_correct(general, T, NULL, solution, count))
        return -1;
    for (int k = 0; k < count; k++)
        for (int i = 0; i < 6; i++) {
            solution[k][i] *= kind->facing[i];
            if (solution[k][i] <= -DHGEN_HALF_TURN)
                solution[k][i] = DHGEN_HALF_TURN;
        }
    return count;
}

/* The rows of a pose all of whose solutions lie next to the nominal arm's rows. Returns how many
 * are inside limits, or -1 where the pose has to be left to the general algorithm. */
DHGEN_FN int dhgen_certain_rows(const dhgen_kind *kind, const dhgen_calibration *of,
    const double *T, double *q, unsigned char *status)
{
    const dhgen_general_arm general = dhgen_general_arm_of(kind, of);
    double solution[DHGEN_ROWS + 1][6];
    int row[DHGEN_ROWS] = { 0 };
    const int count = dhgen_solved_from_nominal(kind, of, &general, T, solution, row);
    return count < 0 ? -1 : dhgen_fill_certain(kind->arm, solution, row, count, q, status);
}

/* Moves solutions, which ascend, to the rows of their postures. */
DHGEN_FN void dhgen_to_nominal_rows(
    const dhgen_kind *kind, const dhgen_calibration *of, double *q, unsigned char *status)
{
    static const int place[6] = { 0, 1, 2, 3, 4, 5 };
    const dhgen_nearest_form form = { kind->nearest_wide, kind->nearest_rows, 2, place,
        of->nominal };
    const double apart[2] = { 0.0, 0.0 };
    dhgen_asked asked;
    dhgen_ask_rows(status, &asked);
    for (int k = 0; k < DHGEN_ASKED; k++)
        for (int i = 0; i < 6; i++) {
            asked.angle[i][k] = k < asked.count ? kind->facing[i] * q[6 * k + i] : 0.0;
            asked.value[i][k] = kind->facing[i] * (asked.angle[i][k] + of->more[i]);
        }
    dhgen_place_asked(&form, apart, &asked, q, status);
}

/* All rows of a calibrated arm, as a robot's solver fills them: those of the nominal arm also where
 * one of them may be moved to a limit, which is for the caller to do. */
DHGEN_FN void dhgen_calibrated_rows(const dhgen_kind *kind, const dhgen_calibration *of,
    const double *T, const double *seed, double *q, unsigned char *status)
{
    const dhgen_general_arm general = dhgen_general_arm_of(kind, of);
    double rows[DHGEN_ROWS][6];
    int own[DHGEN_ROWS] = { 0 };
    struct dhgen_calibrated_descents descents;
    descents.arm = *kind->descents;
    descents.calibration = of;
    const int count = dhgen_solved_from_nominal(kind, of, &general, T, rows, own);
    if (count >= 0) {
        dhgen_keep_certain(rows, own, count, q, status);
        return;
    }
    dhgen_general_rows(&general, &descents.arm, T, NULL, seed, q, status);
    if (kind->nearest)
        dhgen_to_nominal_rows(kind, of, q, status);
}

#endif

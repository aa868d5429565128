/* SPDX-License-Identifier: MIT
 *
 * Rows of regular poses from solutions that are certainly all: each exact, no two near one another.
 */
#ifndef DHGEN_CERTAIN_H
#define DHGEN_CERTAIN_H

#include "arm.h"
#include "limits.h"
#include "numerical/arm.h"

/* A joint of a row that is certain is not moved to a limit from farther away [rad]: these rows are
 * exact, some joint is 0.01 apart from that of each other one, and what solves the pose to 1e-10
 * beside one of them is not even 1e-6 away from it. */
#define DHGEN_MOVED_TO_LIMIT 1e-4

/* Turns the joints of a row inside their limits, or next to the end that they are beyond by little.
 * Returns its status; -1 where one of them is beyond a limit by so little that it may be moved
 * there. */
DHGEN_FN int dhgen_limited_row(const struct dhgen_arm *arm, double *q)
{
    int status = DHGEN_OK;
    for (int i = 0; i < DHGEN_DOF; i++) {
        const struct dhgen_joint *const of = arm->joints + i;
        if (of->lowest <= q[i] && q[i] <= of->highest)
            continue;
        q[i] = dhgen_turned(arm, i, q[i], 0.0);
        const double off = dhgen_overshoot(arm, i, q[i]);
        if (0.0 < fabs(off) && fabs(off) <= DHGEN_MOVED_TO_LIMIT)
            return -1;
        if (fabs(off) > 0.0)
            status = DHGEN_OUT_OF_LIMITS;
        if (0.0 < fabs(off) && fabs(off) <= DHGEN_DOUBTFUL && arm->range_exceeds_a_turn)
            q[i] = off + (off > 0.0 ? of->highest : of->lowest);
    }
    return status;
}

/* Fills the rows of solutions, and no others. */
DHGEN_FN void dhgen_keep_certain(
    double (*solution)[DHGEN_DOF], const int *row, int count, double *q, unsigned char *status)
{
    for (int k = 0; k < count; k++) {
        for (int i = 0; i < DHGEN_DOF; i++)
            q[DHGEN_DOF * row[k] + i] = solution[k][i];
        status[row[k]] = DHGEN_OK;
    }
}

/* Fills the rows of a pose with solutions, of which each has its own. Returns how many are inside
 * limits, or -1 where one of them may be moved to a limit. */
DHGEN_FN int dhgen_fill_certain(const struct dhgen_arm *arm, double (*solution)[DHGEN_DOF],
    const int *row, int count, double *q, unsigned char *status)
{
    int inside = 0;
    for (int k = 0; k < DHGEN_ROWS; k++)
        dhgen_empty_row(arm, q + DHGEN_DOF * k, status + k);
    dhgen_keep_certain(solution, row, count, q, status);
    for (int k = 0; k < count; k++) {
        const int found = dhgen_limited_row(arm, q + DHGEN_DOF * row[k]);
        if (found < 0)
            return -1;
        status[row[k]] = (unsigned char)found;
        inside += found == DHGEN_OK;
    }
    return inside;
}

#endif

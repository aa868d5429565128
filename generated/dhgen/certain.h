/* SPDX-License-Identifier: MIT
 *
 * Rows of regular poses from solutions that are certainly all: each exact, no two near one another.
 */
#ifndef DHGEN_CERTAIN_H
#define DHGEN_CERTAIN_H

#include "arm.h"
#include "general/lanes.h"
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

/* Joints filled up to whole lanes. */
#define DHGEN_PADDED_JOINTS \
    ((DHGEN_DOF + DHGEN_GENERAL_LANES - 1) / DHGEN_GENERAL_LANES * DHGEN_GENERAL_LANES)

/* Limits of joints; of those that fill lanes there are none. */
typedef struct {
    double lowest[DHGEN_PADDED_JOINTS], highest[DHGEN_PADDED_JOINTS];
} dhgen_padded_limits;

DHGEN_FN void dhgen_pad_limits(const struct dhgen_arm *arm, dhgen_padded_limits *limits)
{
    for (int i = 0; i < DHGEN_PADDED_JOINTS; i++) {
        limits->lowest[i] = i < DHGEN_DOF ? arm->joints[i].lowest : -HUGE_VAL;
        limits->highest[i] = i < DHGEN_DOF ? arm->joints[i].highest : HUGE_VAL;
    }
}

/* The status of a row of which each joint is inside its limits as it is, or, turned or not, farther
 * away from there than any that is moved; -1 for others. Reads what lies behind the row, up to
 * whole lanes. */
DHGEN_INLINE int dhgen_plain_status(const dhgen_padded_limits *limits, const double *q)
{
    const dhgen_lane zero = { 0 };
    int is_outside = 0, is_close = 0;
    for (int i = 0; i < DHGEN_PADDED_JOINTS; i += DHGEN_GENERAL_LANES) {
        const dhgen_lane x = DHGEN_LOAD_SOME(q + i, DHGEN_DOF - i);
        const dhgen_lane below = DHGEN_LOAD(limits->lowest + i) - x,
                         above = x - DHGEN_LOAD(limits->highest + i);
        const dhgen_lane beyond = dhgen_lane_max(below, above);
        const dhgen_lane turned = dhgen_lane_min(below, above) + DHGEN_TURN;
        const dhgen_lane off = dhgen_lane_min(beyond, turned);
        is_outside |= dhgen_lane_any_above(beyond, zero);
        is_close |= dhgen_lane_any_above(
            zero + DHGEN_DOUBTFUL, dhgen_lane_select(beyond > 0.0, off, zero + HUGE_VAL));
    }
    return !is_outside ? DHGEN_OK : is_close ? -1 : DHGEN_OUT_OF_LIMITS;
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

/* Fills the rows of a pose with solutions, of which each has its own; there is room for one more.
 * Returns how many are inside limits, or -1 where one of them may be moved to a limit. */
DHGEN_FN int dhgen_fill_certain(const struct dhgen_arm *arm, double (*solution)[DHGEN_DOF],
    const int *row, int count, double *q, unsigned char *status)
{
    dhgen_padded_limits limits;
    int inside = 0;
    dhgen_pad_limits(arm, &limits);
    for (int i = 0; i < DHGEN_DOF; i++)
        solution[count][i] = 0.0;
    for (int k = 0; k < DHGEN_ROWS; k++)
        dhgen_empty_row(arm, q + DHGEN_DOF * k, status + k);
    dhgen_keep_certain(solution, row, count, q, status);
    for (int k = 0; k < count; k++) {
        int found = dhgen_plain_status(&limits, solution[k]);
        if (found < 0)
            found = dhgen_limited_row(arm, q + DHGEN_DOF * row[k]);
        if (found < 0)
            return -1;
        status[row[k]] = (unsigned char)found;
        inside += found == DHGEN_OK;
    }
    return inside;
}

#endif

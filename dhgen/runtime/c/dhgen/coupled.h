/* SPDX-License-Identifier: MIT
 *
 * Drives whose whole turns hang together: one's turn moves another, as that of a ball screw does,
 * or sums of them have limits. Of a row's copies the one is taken that is inside all limits, and of
 * these the nearest. */
#ifndef DHGEN_COUPLED_H
#define DHGEN_COUPLED_H

#include "coupled_turns.h"
#include "ik.h"
#include "limits.h"

/* Whether a row is inside the limits of all drives and of all sums. */
DHGEN_FN int dhgen_keeps_coupled(const struct dhgen_arm *arm, const double *q)
{
    const struct dhgen_coupling *const coupling = arm->coupling;
    int inside = 1;
    for (int i = 0; i < dhgen_dof(arm); i++)
        inside &= coupling->lowest[i] <= q[i] && q[i] <= coupling->highest[i];
    for (int k = 0; k < coupling->sum_count; k++) {
        const double sum = dhgen_sum_of(arm, k, q);
        inside &= coupling->least[k] <= sum && sum <= coupling->most[k];
    }
    return inside;
}

/* How far a row is from other values, squared [rad, arm sizes]. */
DHGEN_FN double dhgen_coupled_distance(
    const struct dhgen_arm *arm, const double *q, const double *towards)
{
    double distance = 0.0;
    for (int i = 0; i < dhgen_dof(arm); i++)
        distance += arm->joints[i].weight * (q[i] - towards[i]) * (q[i] - towards[i]);
    return distance;
}

/* Moves the coupled drives of a row by whole turns: inside all limits, and there as near to other
 * values as can be. Returns whether there is such a place; else the row is unchanged. */
DHGEN_FN int dhgen_turn_coupled(const struct dhgen_arm *arm, const double *towards, double *q)
{
    struct dhgen_turn_choices choices;
    const double *at;
    double least = HUGE_VAL;
    dhgen_begin_choices(arm, q, DHGEN_COUPLED_TURNS, &choices);
    while ((at = dhgen_next_choice(arm, towards, &choices)) != NULL) {
        const double distance = dhgen_coupled_distance(arm, at, towards);
        if (distance < least && dhgen_keeps_coupled(arm, at)) {
            least = distance;
            dhgen_copy_row(arm, at, q);
        }
    }
    return least < HUGE_VAL;
}

/* All solutions of any pose, of an arm whose drives are coupled. Returns how many rows are inside
 * limits, or -DHGEN_INVALID_POSE. */
DHGEN_FN int dhgen_coupled_ik(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *q_seed, double *q, unsigned char *status)
{
    const double zeros[DHGEN_JOINTS] = { 0.0 };
    int count = dhgen_careful_ik(arm, T, free_joints, q_seed, q, status);
    for (int row = 0; row < dhgen_rows(arm) && count > 0; row++) {
        if (status[row] != DHGEN_OK && status[row] != DHGEN_FREE_JOINT)
            continue;
        if (!dhgen_turn_coupled(arm, zeros, q + dhgen_dof(arm) * row)) {
            status[row] = DHGEN_OUT_OF_LIMITS;
            count--;
        }
    }
    return count;
}

/* Whether the turns of a drive are chosen together with others'. */
DHGEN_FN int dhgen_is_coupled(const struct dhgen_coupling *coupling, int drive)
{
    int coupled = 0;
    for (int k = 0; k < coupling->count; k++)
        coupled |= coupling->drives[k] == drive;
    return coupled;
}

/* The solution nearest to a seed, of an arm whose drives are coupled. Returns its status, or minus
 * what is wrong. */
DHGEN_FN int dhgen_coupled_ik_nearest(const struct dhgen_arm *arm, const double *T,
    const double *free_joints, const double *q_seed, double *q)
{
    double rows[DHGEN_BRANCHES * DHGEN_JOINTS], least = HUGE_VAL;
    unsigned char status[DHGEN_BRANCHES];
    const int count = dhgen_coupled_ik(arm, T, free_joints, q_seed, rows, status);
    int result = count < 0 ? count : -DHGEN_UNREACHABLE;
    for (int i = 0; i < dhgen_dof(arm); i++)
        q[i] = DHGEN_NAN;
    for (int row = 0; row < dhgen_rows(arm) && count >= 0; row++) {
        double *const values = rows + dhgen_dof(arm) * row;
        if (status[row] == DHGEN_OUT_OF_LIMITS && result < 0)
            result = -DHGEN_OUT_OF_LIMITS;
        if (status[row] != DHGEN_OK && status[row] != DHGEN_FREE_JOINT)
            continue;
        for (int i = 0; i < dhgen_dof(arm); i++)
            values[i] = dhgen_is_coupled(arm->coupling, i)
                ? values[i]
                : dhgen_turned(arm, i, values[i], q_seed[i]);
        (void)dhgen_turn_coupled(arm, q_seed, values);
        const double distance = dhgen_coupled_distance(arm, values, q_seed);
        if (distance < least || result < 0) {
            least = distance;
            result = status[row];
            dhgen_copy_row(arm, values, q);
        }
    }
    return result;
}

/* All solutions of many poses, of an arm whose drives are coupled. */
DHGEN_FN void dhgen_coupled_ik_each(const struct dhgen_arm *arm, size_t k, size_t n,
    const double *T, const double *free_joints, double *q, unsigned char *status)
{
    const size_t rows = (size_t)dhgen_rows(arm), size = rows * (size_t)dhgen_dof(arm);
    for (; k < n; k++) {
        const double *const given = free_joints ? free_joints + (size_t)arm->given * k : NULL;
        (void)dhgen_coupled_ik(arm, T + 16 * k, given, NULL, q + size * k, status + rows * k);
    }
}

/* What a robot's public functions do. */
#define DHGEN_DO(function) dhgen_coupled_##function

#endif

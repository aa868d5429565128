/* SPDX-License-Identifier: MIT
 *
 * Whole turns of drives that are coupled: all choices of them, and how far a row is beyond limits
 * whichever is taken. */
#ifndef DHGEN_COUPLED_TURNS_H
#define DHGEN_COUPLED_TURNS_H

#include "arm.h"
#include "limits.h"
#include "tolerances.h"

/* Drives whose whole turns hang together, and sums of drives that have limits. */
struct dhgen_coupling {
    int count;           /* drives whose turns are chosen together */
    const int *drives;   /* their places, each before the drives that its turns move */
    const double *moves; /* what a whole turn of each moves: a row of all drives for each */
    const double *lowest, *highest; /* limits of all drives, with slack */
    int sum_count;                  /* sums with limits */
    const double *factors;          /* of all drives in them, a row for each sum */
    const double *least, *most;     /* their limits, with slack */
    const double *slacks;           /* a sum may miss its limits by this [rad or length] */
};

/* Turns to each side of the one that takes a drive nearest to the wanted value; fewer in searches,
 * which choose turns many times, where more than three drives are coupled. */
#define DHGEN_COUPLED_TURNS 4.0
#define DHGEN_TURNS_OF_FOUR 2.0
#define DHGEN_TURNS_OF_MANY 1.0

/* Where a walk through all choices of whole turns is. */
struct dhgen_turn_choices {
    double at[DHGEN_JOINTS + 1][DHGEN_JOINTS]; /* the row, after the turns of so many drives */
    double turns[DHGEN_JOINTS][2];             /* of each drive: the one it has, and the last */
    double most;                               /* turns to each side */
    int level, fresh; /* the drive that is turned next, and whether it begins anew */
};

/* The first and last number of turns of a drive that may be tried: inside its limits, else beside
 * them, around the one that takes it nearest to where it is wanted. */
DHGEN_FN void dhgen_coupled_turns(const struct dhgen_coupling *coupling, int drive, double value,
    double towards, double most, double ends[2])
{
    const double first = ceil((coupling->lowest[drive] - value) / DHGEN_TURN);
    const double last = floor((coupling->highest[drive] - value) / DHGEN_TURN);
    const double low = fmin(first, last), high = fmax(first, last);
    const double wanted = floor((towards - value) / DHGEN_TURN + 0.5);
    const double middle = fmin(fmax(wanted, low), high);
    ends[0] = fmax(low, middle - most);
    ends[1] = fmin(high, middle + most);
}

/* Begins a walk through the choices of whole turns of a row. */
DHGEN_FN void dhgen_begin_choices(
    const struct dhgen_arm *arm, const double *q, double most, struct dhgen_turn_choices *choices)
{
    choices->most = most;
    dhgen_copy_row(arm, q, choices->at[0]);
    choices->level = 0;
    choices->fresh = 1;
}

/* The row with the next choice of whole turns, or NULL when there is none left. */
DHGEN_FN const double *dhgen_next_choice(
    const struct dhgen_arm *arm, const double *towards, struct dhgen_turn_choices *choices)
{
    const struct dhgen_coupling *const coupling = arm->coupling;
    const int dof = dhgen_dof(arm);
    while (choices->level >= 0) {
        const int level = choices->level;
        if (level == coupling->count) {
            choices->level--;
            choices->fresh = 0;
            return choices->at[level];
        }
        const int drive = coupling->drives[level];
        double *const turns = choices->turns[level];
        if (choices->fresh) {
            dhgen_coupled_turns(
                coupling, drive, choices->at[level][drive], towards[drive], choices->most, turns);
            choices->fresh = turns[0] <= turns[1];
        } else {
            const double last = turns[0];
            turns[0] += 1.0; /* which changes nothing very far out */
            choices->fresh = last < turns[0] && turns[0] <= turns[1];
        }
        choices->level += choices->fresh ? 1 : -1;
        for (int i = 0; i < dof && choices->fresh; i++)
            choices->at[level + 1][i] =
                choices->at[level][i] + turns[0] * coupling->moves[dof * level + i];
    }
    return NULL;
}

/* Whether whole turns of coupled drives move a drive. */
DHGEN_FN int dhgen_turns_coupled(const struct dhgen_arm *arm, int drive)
{
    int moved = 0;
    for (int k = 0; k < arm->coupling->count; k++)
        moved |= fabs(arm->coupling->moves[dhgen_dof(arm) * k + drive]) > 0.0;
    return moved;
}

/* The sum of a row's drives that has limits. */
DHGEN_FN double dhgen_sum_of(const struct dhgen_arm *arm, int sum, const double *q)
{
    double total = 0.0;
    for (int i = 0; i < dhgen_dof(arm); i++)
        total += arm->coupling->factors[dhgen_dof(arm) * sum + i] * q[i];
    return total;
}

/* How far a value is beyond limits that have some slack; none where rounding may take it there. */
DHGEN_FN double dhgen_beyond_slack(double value, double lowest, double highest, double slack)
{
    const double off = slack + fmax(lowest - value, value - highest);
    return off > 0.5 * slack ? off : 0.0;
}

/* How far a row is beyond all limits, with the whole turns of coupled drives that leave least of it
 * [rad, arm sizes]. */
DHGEN_FN double dhgen_coupled_beyond(const struct dhgen_arm *arm, const double *q)
{
    const struct dhgen_coupling *const coupling = arm->coupling;
    const double zeros[DHGEN_JOINTS] = { 0.0 }, *x;
    struct dhgen_turn_choices choices;
    double alone = 0.0, least = HUGE_VAL, most = DHGEN_COUPLED_TURNS;
    for (int i = 0; i < dhgen_dof(arm); i++)
        if (!dhgen_turns_coupled(arm, i))
            alone += fabs(dhgen_overshoot(arm, i, q[i])) * sqrt(arm->joints[i].weight);
    if (coupling->count > 3)
        most = coupling->count == 4 ? DHGEN_TURNS_OF_FOUR : DHGEN_TURNS_OF_MANY;
    dhgen_begin_choices(arm, q, most, &choices);
    while (least > 0.0 && (x = dhgen_next_choice(arm, zeros, &choices)) != NULL) {
        double beyond = 0.0;
        for (int i = 0; i < dhgen_dof(arm); i++)
            if (dhgen_turns_coupled(arm, i))
                beyond += sqrt(arm->joints[i].weight)
                    * dhgen_beyond_slack(
                        x[i], coupling->lowest[i], coupling->highest[i], arm->joints[i].slack);
        for (int k = 0; k < coupling->sum_count; k++) {
            const double sum = dhgen_sum_of(arm, k, x), slack = coupling->slacks[k];
            /* a length's slack is an angle's, times the arm's size */
            beyond += DHGEN_LIMIT / slack
                * dhgen_beyond_slack(sum, coupling->least[k], coupling->most[k], slack);
        }
        least = fmin(least, beyond);
    }
    return alone + least;
}

#endif

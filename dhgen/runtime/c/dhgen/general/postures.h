/* SPDX-License-Identifier: MIT
 *
 * Postures of a nearest arm with a structure: the row of its closed form that holds joint values,
 * and the row of a solution that has this posture. */
#ifndef DHGEN_GENERAL_POSTURES_H
#define DHGEN_GENERAL_POSTURES_H

#include "../arm.h"
#include "motions.h"

/* Joint values belong to a row that differs by less [rad]: at poses that the closed form solves its
 * rows are known to 1e-9. */
#define DHGEN_SAME_POSTURE 1e-06

/* The nearest arm's rows at a pose of its own, given what callers give and by how much another
 * arm's tool may be away, an angle and a length. Returns how many are OK, or -1 where a branch may
 * end so near. */
typedef int dhgen_nearest_rows(
    const double *T, const double *given, double *q, unsigned char *status);

#ifdef DHGEN_DOF /* rows are as long as the rows of the robot in whose file this is */
#include "../tile.h"

/* Rows of a nearest arm at most. */
#define DHGEN_NEAREST_ROWS 16
/* Postures that are asked for at once: as many as there are rows, rounded up to eight, the most
 * lanes. */
#define DHGEN_ASKED ((DHGEN_ROWS + 7) / 8 * 8)

/* Solutions whose postures are asked for: the angles of all joints of the nearest arm, those of the
 * joints that its closed form is asked for, and the poses to which they take it. */
typedef struct {
    int count;
    double angle[DHGEN_DOF][DHGEN_ASKED], value[6][DHGEN_ASKED], pose[16][DHGEN_ASKED];
} dhgen_asked;

/* The closed form of a nearest arm, for several poses. */
typedef struct {
    dhgen_solve_wide *solve;
    int rows, given;          /* of its rows, and of numbers that it is given */
    const int *place;         /* which of its joints are asked for */
    const double (*link)[12]; /* C0 ... Cn of its pose C0 Rz(angle 1) C1 ... Rz(angle n) Cn */
} dhgen_nearest_form;

/* Asks for the rows that hold solutions: these come first. */
DHGEN_FN void dhgen_ask_rows(const unsigned char *status, dhgen_asked *asked)
{
    asked->count = 0;
    while (asked->count < DHGEN_ROWS && status[asked->count] != DHGEN_UNREACHABLE) {
        asked->count++;
    }
}

/* The poses of angles. */
DHGEN_FN void dhgen_ask_poses(const double (*link)[12], dhgen_asked *asked)
{
    for (int from = 0; from < asked->count; from += DHGEN_GENERAL_LANES) {
        dhgen_rigid T;
        dhgen_broadcast(T, link[0]);
        for (int i = 0; i < DHGEN_DOF; i++) {
            dhgen_lane c, s;
            dhgen_lane_direction(
                DHGEN_LOAD_SOME(asked->angle[i] + from, DHGEN_ASKED - from), &c, &s);
            dhgen_turn(T, c, s);
            dhgen_multiply(T, link[i + 1]);
        }
        for (int i = 0; i < 16; i++) {
            const dhgen_lane last = dhgen_lane_all(i == 15);
            DHGEN_SPREAD(
                asked->pose[i] + from, i < 12 ? T[i / 4][i % 4] : last, DHGEN_ASKED - from);
        }
    }
}

/* The postures of solutions: the row that holds each at the pose to which it takes the nearest arm;
 * -1 where a branch ends, or no row does. */
DHGEN_FN void dhgen_find_postures(
    const dhgen_nearest_form *form, const double *given, const dhgen_asked *asked, double *posture)
{
    dhgen_wide pose[16], held[DHGEN_DOF], q[DHGEN_NEAREST_ROWS * DHGEN_DOF];
    dhgen_wide_mask kind[DHGEN_NEAREST_ROWS];
    for (int i = 0; i < form->given; i++) {
        held[i] = dhgen_all_wide(given[i]);
    }
    for (int from = 0; from < asked->count; from += DHGEN_LANES) {
        dhgen_wide least = dhgen_all_wide(DHGEN_SAME_POSTURE), found = dhgen_all_wide(-1.0);
        for (int i = 0; i < 16; i++) {
            pose[i] = *(const dhgen_wide_at *)(asked->pose[i] + from);
        }
        const dhgen_wide_mask left = form->solve(pose, held, q, kind);
        for (int row = 0; row < form->rows; row++) {
            dhgen_wide most = dhgen_all_wide(0.0);
            for (int i = 0; i < 6; i++) {
                const dhgen_wide gap = dhgen_abs_wide(q[DHGEN_DOF * row + form->place[i]]
                    - *(const dhgen_wide_at *)(asked->value[i] + from));
                const dhgen_wide around = dhgen_abs_wide(gap - DHGEN_TURN);
                most = dhgen_maximum_wide(most, dhgen_minimum_wide(gap, around));
            }
            const dhgen_wide_mask here =
                (kind[row] == (long long)DHGEN_OK) & (left == 0) & (most < least);
            found = dhgen_pick_wide(here, dhgen_all_wide(row), found);
            least = dhgen_pick_wide(here, most, least);
        }
        *(dhgen_wide_at *)(posture + from) = found;
    }
}

/* Moves solutions, which fill the first rows, to the rows of their postures: of several with one
 * posture the first. The others follow behind the nearest arm's rows, and fill empty ones of these
 * should there be more. */
DHGEN_FN void dhgen_place_rows(const double *posture, int rows, double *q, unsigned char *status)
{
    double solution[DHGEN_ROWS][DHGEN_DOF];
    unsigned char was[DHGEN_ROWS];
    int count = 0, next = rows;
    for (; count < DHGEN_ROWS && status[count] != DHGEN_UNREACHABLE; count++) {
        was[count] = status[count];
        for (int i = 0; i < DHGEN_DOF; i++) {
            solution[count][i] = q[DHGEN_DOF * count + i];
            q[DHGEN_DOF * count + i] = DHGEN_NAN;
        }
        status[count] = DHGEN_UNREACHABLE;
    }
    for (int late = 0; late < 2; late++) {
        for (int k = 0; k < count; k++) {
            int row = late ? next % DHGEN_ROWS : (int)posture[k];
            if (was[k] == DHGEN_UNREACHABLE || row < 0) {
                continue;
            }
            while (late && status[row] != DHGEN_UNREACHABLE) {
                row = ++next % DHGEN_ROWS;
            }
            if (status[row] != DHGEN_UNREACHABLE) {
                continue;
            }
            for (int i = 0; i < DHGEN_DOF; i++) {
                q[DHGEN_DOF * row + i] = solution[k][i];
            }
            status[row] = was[k];
            was[k] = DHGEN_UNREACHABLE;
        }
    }
}

/* Moves solutions that are asked for to the rows of their postures. */
DHGEN_FN void dhgen_place_asked(const dhgen_nearest_form *form, const double *given,
    dhgen_asked *asked, double *q, unsigned char *status)
{
    double posture[DHGEN_ASKED];
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < DHGEN_ASKED; k++) {
            asked->value[i][k] = dhgen_wrap(asked->value[i][k]);
        }
    }
    dhgen_ask_poses(form->link, asked);
    dhgen_find_postures(form, given, asked, posture);
    dhgen_place_rows(posture, form->rows, q, status);
}
#endif

#endif

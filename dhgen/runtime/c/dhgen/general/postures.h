/* SPDX-License-Identifier: MIT
 *
 * Postures of a nearest arm with a structure: the row of its closed form that holds joint values,
 * and the row of a solution that has this posture. */
#ifndef DHGEN_GENERAL_POSTURES_H
#define DHGEN_GENERAL_POSTURES_H

#include "../arm.h"

/* Joint values are those of a row that misses them by less [rad]: at poses that the closed form
 * does not leave its rows are known to 1e-9. */
#define DHGEN_SAME_POSTURE 1e-06

/* The nearest arm's rows at a pose of its own, given what callers give and by how much another
 * arm's tool may be away, an angle and a length. Returns how many are OK, or -1 where a branch may
 * end so near. */
typedef int dhgen_nearest_rows(
    const double *T, const double *given, double *q, unsigned char *status);

#ifdef DHGEN_DOF /* rows are as long as those of the robot whose file this is a part of */
/* The posture of joint values that take the nearest arm to a pose: the row that holds them. Returns
 * -1 where a branch ends, or no row does. */
DHGEN_FN int dhgen_posture(dhgen_nearest_rows *solve, int rows, const double *pose,
    const double *given, const double *value, const int *place)
{
    double q[16][DHGEN_DOF], least = DHGEN_SAME_POSTURE;
    unsigned char status[16];
    int posture = -1;
    const int count = solve(pose, given, q[0], status);
    for (int row = 0; row < rows && count > 0; row++) {
        double most = status[row] == DHGEN_OK ? 0.0 : HUGE_VAL;
        for (int i = 0; i < 6 && most < least; i++) {
            most = fmax(most, fabs(dhgen_wrap(q[row][place[i]] - value[i])));
        }
        if (most < least) {
            least = most;
            posture = row;
        }
    }
    return posture;
}

/* Moves solutions, which fill the first rows, to those of their postures: of several with one
 * posture the first. The others follow behind the nearest arm's rows, and fill empty ones of these
 * should there be more. */
DHGEN_FN void dhgen_place_rows(const int *posture, int rows, double *q, unsigned char *status)
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
            int row = late ? next % DHGEN_ROWS : posture[k];
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
#endif

#endif
